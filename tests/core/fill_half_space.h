// SPDX-License-Identifier: MIT
#pragma once

// The half-space fill of graphics hardware: a pixel is drawn if its sample lies on the inner side
// of all three edges. A sample exactly on an edge belongs to the triangle only if that edge is a
// top or a left one, so every sample on an edge that two triangles share has exactly one owner.
//
// Source: Pineda 1988 (edge functions); Direct3D 11 specification, section 3.4.2.1 (the top-left
// rule).
//
//     fill_half_space(triangle, {0.5, 0.5}, canvas, FlatPainter(image, color));
//
// `"fill": "top-left"` of a scene draws the same pixels row by row (draw/paint/fill_top_left.h), and is
// tested against this one.

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/bounding_box.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/edge_function.h>
#include <rastertrace/core/raster/sample_offset.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/core/raster/triangle.h>

#include <array>

namespace rastertrace {

/// A sample point met the three edges of a triangle.
template <typename Scalar> struct EdgesTested {
    int x, y;                     ///< of its pixel
    std::array<Scalar, 3> values; ///< of the edge functions: upper, lower and long edge
    bool inside;                  ///< all three admit the sample
};

/// Fills a triangle: tests every pixel of its box, top row first. A triangle without
/// area has no inside and is skipped.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgesTested<Scalar>, PrimitiveSkipped<>>
void fill_half_space(const Triangle<Scalar>& triangle, const SampleOffset<Scalar>& offset,
                     const Canvas& canvas, Sink&& sink) {
    // Three edge functions, positive inside.
    const auto sorted = sorted_from_top(triangle, canvas.down());
    const auto& [top, middle, bottom] = sorted;
    const int middle_side = side_of_edge(top, bottom, middle, canvas.down());
    if (middle_side == 0) {
        sink(PrimitiveSkipped<>{.why = SkipReason::zero_area});
        return;
    }
    const auto edges = edge_functions(sorted, middle_side > 0, canvas.down());

    const BoundingBox box = bounding_box(triangle, offset, canvas);
    if (box.is_empty()) {
        sink(PrimitiveSkipped<>{.why = SkipReason::off_canvas});
        return;
    }
    for_each_pixel(box, canvas, [&](Pixel pixel) {
        const auto sample = offset.sample_of(pixel);
        const std::array values{edges[0].at(sample), edges[1].at(sample), edges[2].at(sample)};
        const bool is_inside = edges[0].admits_value(values[0]) &&
                               edges[1].admits_value(values[1]) && edges[2].admits_value(values[2]);
        sink(
            EdgesTested<Scalar>{.x = pixel.x, .y = pixel.y, .values = values, .inside = is_inside});
    });
}

} // namespace rastertrace
