// SPDX-License-Identifier: MIT
#pragma once

// Hidden lines: the painter of points, lines and outlines that are tested against the depth buffer.
//
// A pixel of a line stands for the point of the line at that step of its major axis, and has the
// depth of that point. The point may lie up to a pixel away from the sample at which the buffer has
// the depths of the faces. Tested against those depths, a line would be broken by the faces that it
// borders. So the buffer only says which faces are in the pixel and in the eight around it. A face
// hides the point if
//
//   - the point lies inside it on the screen, its sides included,
//   - and it is nearer there: of equal depths the thinner primitive passes, a line before a face,
//     a point before both;
//   - and the line is not a side of it, the point not a corner of it, by the indices of vertices.
//
// Points and lines are tested against each other by depth: of equal depths the thinner primitive
// passes, and of equally thin ones the first stays. Their depths are kept apart from those of the
// faces (thin_depths.h).
//
// Source: T1, "Remoção de linhas e superfícies ocultas", by a depth buffer.
//
//     LinePainter painter(piece, side, scene, image, tests, owners, NullSink());
//     draw_line(piece, side, method, canvas, painter);

#include "hidden-lines/owners.h"
#include "hidden-lines/sides.h"

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/paint/depth_tests.h>
#include <rastertrace/core/draw/paint/piece_in.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/line_sampling.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace rastertrace {

/// The point of a line at each step of its major axis. Beyond an end it is that end. Depths are
/// turned.
template <typename Depth> struct LinePoints {
    bool is_x_major;
    DepthEdge<Depth> across; ///< the other coordinate, and
    DepthEdge<Depth> depths; ///< the turned depth: both are linear along the major axis
    DeepPoint<Depth> from;
    DeepPoint<Depth> to;
    SampleOffset<Depth> offset = {};

    /// The coordinate of a pixel's sample along the major axis.
    Depth along_at(Pixel pixel) const {
        return is_x_major ? offset.x_of(pixel.x) : offset.y_of(pixel.y);
    }

    /// The depth of the point at a pixel.
    Depth depth_at(Pixel pixel) const { return depths.held_at(along_at(pixel)); }

    DeepPoint<Depth> at(Pixel pixel) const {
        const Depth along = along_at(pixel);
        const Depth& first = is_x_major ? from.at.x : from.at.y;
        const Depth& last = is_x_major ? to.at.x : to.at.y;
        const bool goes_on = first < last;
        if (goes_on ? !(first < along) : !(along < first))
            return from;
        if (goes_on ? !(along < last) : !(last < along))
            return to;
        const Depth other = across.held_at(along);
        return {is_x_major ? Vec<Depth, 2>{along, other} : Vec<Depth, 2>{other, along},
                depths.held_at(along)};
    }
};

/// The points of the line between two corners of a piece. Both corners of a point are the same. A
/// line that is seen end-on is its nearer end. `larger_passes` as in DepthRule.
template <typename Scalar>
LinePoints<DepthOf<Scalar>> line_points(const Piece<Scalar>& piece, EdgeName side,
                                        bool larger_passes, const Scene& scene) {
    using D = DepthOf<Scalar>;
    const auto point_of = [&](std::size_t corner) {
        DeepPoint<D> point = corner_of(piece, corner);
        point.depth = turned(point.depth, larger_passes);
        return point;
    };
    DeepPoint<D> from = point_of(side.from);
    DeepPoint<D> to = point_of(side.to);
    const bool is_x_major = is_longer_in_x<D>({from.at, to.at});
    const D& first = is_x_major ? from.at.x : from.at.y;
    const D& last = is_x_major ? to.at.x : to.at.y;
    if (first == last) {
        const DeepPoint<D> nearer = to.depth < from.depth ? to : from;
        from = to = nearer;
    }
    return {is_x_major,
            {first, is_x_major ? from.at.y : from.at.x, last, is_x_major ? to.at.y : to.at.x},
            {first, from.depth, last, to.depth},
            from,
            to,
            sample_offset<D>(sample_of_lines(scene.method), 1)};
}

/// True if a triangle covers a point on the screen, its sides included, and is nearer there. A
/// triangle without area covers nothing. The depth of the point is turned, those of the triangle
/// are not.
template <typename Depth>
bool hides_point(const DeepTriangle<Depth>& triangle, const DeepPoint<Depth>& point,
                 bool larger_passes) {
    const auto zero = scalar_from<Depth>(0);
    const auto way_to = [&point](const DeepPoint<Depth>& corner) {
        return Vec<Depth, 2>{Depth(corner.at.x - point.at.x), Depth(corner.at.y - point.at.y)};
    };
    const std::array ways{way_to(triangle[0]), way_to(triangle[1]), way_to(triangle[2])};

    // Twice the areas that the point makes with the sides are the weights of the corners, times the
    // area.
    std::array<Depth, 3> weights;
    bool has_positive = false;
    bool has_negative = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& a = ways[(i + 1) % 3];
        const auto& b = ways[(i + 2) % 3];
        weights[i] = a.x * b.y - b.x * a.y;
        has_positive = has_positive || zero < weights[i];
        has_negative = has_negative || weights[i] < zero;
        if (has_positive && has_negative)
            return false;
    }

    // Both depths times the area. At a corner that is exactly the depth of the corner.
    Depth of_triangle = zero;
    Depth of_point = zero;
    for (std::size_t i = 0; i < 3; ++i) {
        of_triangle += weights[i] * turned(triangle[i].depth, larger_passes);
        of_point += weights[i] * point.depth;
    }
    return has_positive ? of_triangle < of_point : has_negative && of_point < of_triangle;
}

/// The scene's vertices at the ends of a side of a piece, before clipping.
template <typename Coordinate>
std::array<std::size_t, 2> ends_in_scene(const Scene& scene, const Piece<Coordinate>& piece,
                                         EdgeName side) {
    const ScenePrimitive& primitive = scene.primitives[piece.primitive];
    if (primitive.kind == PrimitiveKind::line)
        return {primitive.vertices[0], primitive.vertices[1]};
    if (!piece.is_part)
        return {primitive.vertices[side.from], primitive.vertices[side.to]};
    // A part of an outline is the rest of a side, and has the index of its first vertex.
    const auto corners = primitive.corners();
    const auto first = std::find(corners.begin(), corners.end(), piece.vertices[0]);
    const auto from = static_cast<std::size_t>(first - corners.begin());
    return {corners[from], corners[(from + 1) % corners.size()]};
}

/// Paints the visible pixels of a point, a line or a side, and tells every step on.
template <typename Scalar, typename Tests, typename Sink> class LinePainter {
public:
    LinePainter(const Piece<Scalar>& piece, EdgeName side, const Scene& scene, Image& image,
                Tests& tests, const Owners<DepthOf<Scalar>>& owners, const Sink& sink)
        : scene_(scene), image_(image), tests_(tests), owners_(owners),
          points_(line_points(piece, side, tests_.larger_passes(), scene)),
          thickness_(traits_of(piece.kind).thickness), ends_(ends_in_scene(scene, piece, side)),
          sink_(sink) {
        tests_.begin_side(side.from);
    }

    template <typename Step> bool takes() const { return rastertrace::takes<Step>(sink_); }

    template <typename Step> void operator()(const Step& step) const { sink_(step); }

    void operator()(const PixelPlotted<>& plotted) const {
        const Pixel pixel = plotted.pixel();
        const auto row = static_cast<int>(image_.canvas().row_of(pixel.y));
        auto& cell = *tests_.row_from(pixel.x, row);
        const auto depth = points_.depth_at(pixel);
        const auto test = [&] { return verdict_on(pixel, row, cell, depth); };
        if (!decide_and_tell(tests_, pixel, cell, depth, test, sink_))
            return;
        image_.at(pixel) = plotted.color;
        sink_(plotted);
    }

private:
    /// Tests a turned depth, and keeps it if it passes.
    template <typename Cell>
    DepthVerdict verdict_on(Pixel pixel, int row, Cell& cell, const DepthOf<Scalar>& depth) const {
        DepthVerdict verdict{.passes = false};
        if (const auto face = face_before(pixel, row)) {
            verdict.behind = primitive_of(*face).name;
            return verdict;
        }
        const auto owner = tests_.owner_of(cell);
        if (tests_.is_behind_thin(cell, depth, thickness_)) {
            // A line does not hide the points at its ends.
            const std::uint32_t thin = *tests_.thin_owner_of(cell);
            verdict.is_by_thin = true;
            verdict.passes =
                thickness_ < traits_of(primitive_of(thin).kind).thickness && is_side_of(thin);
            if (verdict.passes)
                verdict.side_of = primitive_of(thin).name;
        } else if (owner && tests_.hides(cell, depth)) {
            verdict.passes = true;
            (is_side_of(*owner) ? verdict.side_of : verdict.beside) = primitive_of(*owner).name;
        } else {
            verdict.passes = owner || tests_.is_nearer(cell, depth);
        }
        if (verdict.passes)
            tests_.keep_thin(cell, depth, thickness_);
        return verdict;
    }

    /// The face, in the pixel or next to it, that hides the point of the line at a pixel, if there
    /// is one.
    std::optional<std::uint32_t> face_before(Pixel pixel, int row) const {
        std::array<std::uint32_t, 9> seen{};
        auto end = seen.begin();
        // The pixel itself first: usually its own face decides.
        for (const int dy : {0, -1, 1})
            for (const int dx : {0, -1, 1}) {
                if (!tests_.has(pixel.x + dx, row + dy))
                    continue;
                const auto owner = tests_.owner_of(*tests_.row_from(pixel.x + dx, row + dy));
                if (!owner || std::find(seen.begin(), end, *owner) != end)
                    continue;
                *end++ = *owner;
                if (!is_side_of(*owner) && is_hidden_by(*owner, pixel))
                    return owner;
            }
        return std::nullopt;
    }

    /// True if the face of an owner covers the point of the line at a pixel, and is nearer there.
    bool is_hidden_by(std::uint32_t owner, Pixel pixel) const {
        return hides_point(owners_.triangle_of(owner), points_.at(pixel), tests_.larger_passes());
    }

    /// Keeps the last answer about a polygon: the next pixel mostly needs it again.
    bool is_side_of(std::uint32_t owner) const {
        const std::size_t primitive = owners_.primitive_of(owner);
        const std::uint32_t polygon = scene_.primitives[primitive].polygon;
        if (polygon == 0)
            return rastertrace::is_side_of(scene_, ends_, primitive);
        if (polygon != asked_polygon_) {
            asked_polygon_ = polygon;
            is_side_of_asked_ = rastertrace::is_side_of(scene_, ends_, primitive);
        }
        return is_side_of_asked_;
    }
    const ScenePrimitive& primitive_of(std::uint32_t owner) const {
        return scene_.primitives[owners_.primitive_of(owner)];
    }

    const Scene& scene_;
    Image& image_;
    Tests& tests_;
    const Owners<DepthOf<Scalar>>& owners_;
    LinePoints<DepthOf<Scalar>> points_;
    Thickness thickness_;
    std::array<std::size_t, 2> ends_;
    mutable std::uint32_t asked_polygon_ = 0; ///< none
    mutable bool is_side_of_asked_ = false;
    [[no_unique_address]] Sink sink_;
};

} // namespace rastertrace
