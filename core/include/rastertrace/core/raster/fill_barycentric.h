// SPDX-License-Identifier: MIT
#pragma once

// The bounding-box fill of tinyrenderer's second lesson: try every pixel of the smallest
// axis-aligned rectangle around the triangle, and draw those whose barycentric coordinates are not
// negative.
//
// Source: Sokolov, tinyrenderer, lesson 2, in the Chinese notes on it.
//
//     fill_barycentric(triangle, sample_offset, canvas, FlatPainter(image, color));

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/core/raster/triangle.h>

#include <algorithm>
#include <array>

namespace rastertrace {

/// Fills the closed triangle: samples on its edges are drawn, so two triangles that share an edge
/// both draw them. A sample lies `sample_offset` right of and above (in y) a pixel's integer point.
/// The box is cut to the canvas. A triangle without area has no barycentric coordinates and is
/// skipped.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, SampleTested<Scalar>, PrimitiveSkipped>
void fill_barycentric(const Triangle<Scalar>& triangle, const Scalar& sample_offset, Canvas canvas,
                      Sink&& sink) {
    const Scalar zero = scalar_from<Scalar>(0);
    const Barycentric<Scalar> barycentric(triangle);
    if (barycentric.area2() == zero) {
        sink(PrimitiveSkipped{.why = SkipReason::zero_area});
        return;
    }

    // The box: the pixels whose samples lie between the smallest and largest x and y.
    const auto& [a, b, c] = triangle.vertices;
    const Index left = ceil_index(Scalar(std::min({a.x, b.x, c.x}) - sample_offset));
    const Index right = floor_index(Scalar(std::max({a.x, b.x, c.x}) - sample_offset));
    const Index low = ceil_index(Scalar(std::min({a.y, b.y, c.y}) - sample_offset));
    const Index high = floor_index(Scalar(std::max({a.y, b.y, c.y}) - sample_offset));
    const Index top_row = canvas.row_of(canvas.down() > 0 ? low : high);
    const Index bottom_row = canvas.row_of(canvas.down() > 0 ? high : low);

    // The part of it that the canvas has.
    const Index first_x = std::max<Index>(left, canvas.left());
    const Index last_x = std::min<Index>(right, canvas.right());
    const Index first_row = std::max<Index>(top_row, 0);
    const Index last_row = std::min<Index>(bottom_row, canvas.height - 1);
    if (last_x < first_x || last_row < first_row) {
        sink(PrimitiveSkipped{.why = SkipReason::off_canvas});
        return;
    }

    for (Index row = first_row; row <= last_row; ++row)
        for (Index x = first_x; x <= last_x; ++x) {
            const Pixel pixel{static_cast<int>(x), canvas.y_of(static_cast<int>(row))};
            const auto weights =
                barycentric.weights_at({Scalar(scalar_from<Scalar>(pixel.x) + sample_offset),
                                        Scalar(scalar_from<Scalar>(pixel.y) + sample_offset)});
            const bool is_inside =
                !(weights[0] < zero) && !(weights[1] < zero) && !(weights[2] < zero);
            sink(SampleTested<Scalar>{.pixel = pixel, .weights = weights, .is_inside = is_inside});
        }
}

} // namespace rastertrace
