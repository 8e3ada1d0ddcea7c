// SPDX-License-Identifier: MIT
#pragma once

// The line between two vertices of a primitive: in which direction it is drawn, and the colors of its pixels.

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/paint/piece_in.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/raster/depth_interpolation.h>
#include <rastertrace/core/raster/line_sampling.h>
#include <rastertrace/core/raster/mixed_colors.h>
#include <rastertrace/core/raster/steps.h>

#include <cstddef>
#include <cstdlib>

namespace rastertrace {

/// The line between two vertices of a primitive, in the direction in which it is drawn: its true
/// ends, and the pixels nearest to them.
template <typename Scalar> struct DirectedLine {
    Segment<Scalar> segment;
    GridLine pixels;
    EdgeName ends; ///< corners of the primitive
};

/// With `from: low`, it begins at the end with the lower coordinate along the major axis.
/// Bresenham's line compares the pixels of its ends, the other lines the true ends.
template <typename Scalar>
DirectedLine<Scalar> directed_line(const Piece<Scalar>& primitive, EdgeName side,
                                   const SampleOffset<Scalar>& offset, const Method& method) {
    const Vec<Scalar, 2>& from = primitive.positions[side.from];
    const Vec<Scalar, 2>& to = primitive.positions[side.to];
    const GridPoint to_pixel = nearest_pixel(to, offset);
    const GridPoint from_pixel = nearest_pixel(from, offset);
    const DirectedLine<Scalar> forward{
        {from, to},
        {from_pixel, to_pixel, primitive.colors[side.from], primitive.colors[side.to]},
        side};
    if (method.from == LineStart::first)
        return forward;

    const auto runs_down = [](const auto& a, const auto& b, bool is_x_major) {
        return is_x_major ? b.x < a.x : b.y < a.y;
    };
    const Index columns = std::abs(to_pixel.x - from_pixel.x);
    const Index rows = std::abs(to_pixel.y - from_pixel.y);
    const bool is_reversed = traits_of(method.line).rule == LineRule::grid
                                 ? runs_down(from_pixel, to_pixel, columns >= rows)
                                 : runs_down(from, to, is_longer_in_x(forward.segment));
    return is_reversed
               ? DirectedLine<Scalar>{{to, from}, reversed(forward.pixels), {side.to, side.from}}
               : forward;
}

/// The octant in which the line is drawn.
template <typename Scalar>
int octant_of(const Piece<Scalar>& primitive, EdgeName side, const SampleOffset<Scalar>& offset,
              const Method& method) {
    const GridLine line = directed_line(primitive, side, offset, method).pixels;
    return octant_of(line.from, line.to);
}

/// The colors of a line in space, or between ends one of which clipping has made; none of others, whose
/// colors are found by steps between whole levels.
template <typename Scalar>
LineColors line_colors(const DirectedLine<Scalar>& line, EdgeName side,
                       const Piece<Scalar>& primitive, const SampleOffset<Scalar>& offset,
                       const Scene& scene) {
    using D = DepthOf<Scalar>;
    const bool is_cut = !primitive.levels.empty();
    if (!is_cut && primitive.colors[side.from] == primitive.colors[side.to])
        return {};
    const ColorLerp lerp = scene.color_lerp();
    const bool is_in_space = lerp == ColorLerp::space && scene.mixes_colors();
    const auto [from, to] = is_in_space ? side : line.ends; // in space either way is the same
    if (!is_cut && !is_in_space)
        return {};
    const bool divides = is_in_space && scene.mixes_in_perspective();
    const D one = scalar_from<D>(1);
    const auto levels_of = [&](std::size_t end) {
        return is_cut ? primitive.levels[end] : Levels<D>(primitive.colors[end]);
    };
    const MixedOnLine<D> mixed{
        {levels_of(from), levels_of(to)},
        {divides ? primitive.inverse_w[from] : one, divides ? primitive.inverse_w[to] : one},
        scene.method.color_rounding};
    if (lerp != ColorLerp::space)
        return [mixed, lerp, pixels = line.pixels](GridPoint pixel, Index step, Index steps) {
            if (step == 0 || step == steps)
                return mixed.at(scalar_from<D>(step == 0 ? 0 : 1));
            return mixed.at(lerp == ColorLerp::axis
                                ? D(scalar_from<D>(step) / scalar_from<D>(steps))
                                : D(1 - share_by_distance(pixels, pixel)));
        };

    // In space a pixel stands for the point of the line at its sample along the longer axis, or for its end
    // if that lies beyond it: as for its depth (line_painter.h).
    const auto& first = primitive.positions[from];
    const auto& last = primitive.positions[to];
    const bool is_x_major = is_longer_in_x<Scalar>({first, last});
    const DepthEdge<D> way(depth_scalar(is_x_major ? first.x : first.y), scalar_from<D>(0),
                           depth_scalar(is_x_major ? last.x : last.y), one);
    const SampleOffset<D> samples{depth_scalar(offset.x()), depth_scalar(offset.y())};
    return [mixed, way, samples, is_x_major](GridPoint pixel, Index, Index) {
        return mixed.at(way.held_at(is_x_major ? samples.x_of(pixel.x) : samples.y_of(pixel.y)));
    };
}

} // namespace rastertrace
