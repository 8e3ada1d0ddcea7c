// SPDX-License-Identifier: MIT
#pragma once

// The bounding-box fill of tinyrenderer's second lesson: try every pixel of the smallest
// axis-aligned rectangle around the triangle, and draw those whose barycentric coordinates are not
// negative.
//
// Source: Sokolov, tinyrenderer, lesson 2, in the Chinese notes on it.
//
//     fill_barycentric(triangle, offset, canvas, FlatPainter(image, color));

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/raster/bounding_box.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/sample_offset.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/core/raster/triangle.h>

namespace rastertrace {

/// Fills the closed triangle: samples on its edges are drawn, so two triangles that share an edge
/// both draw them. The box is cut to the canvas. A triangle without area has no barycentric coordinates and is skipped.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, SampleTested<Scalar>, PrimitiveSkipped<>>
void fill_barycentric(const Triangle<Scalar>& triangle, const SampleOffset<Scalar>& offset,
                      Canvas canvas, Sink&& sink) {
    const Scalar zero = scalar_from<Scalar>(0);
    const Barycentric<Scalar> barycentric(triangle);
    if (barycentric.area2() == zero) {
        sink(PrimitiveSkipped<>{.why = SkipReason::zero_area});
        return;
    }

    const BoundingBox box = bounding_box(triangle, offset, canvas);
    if (box.is_empty()) {
        sink(PrimitiveSkipped<>{.why = SkipReason::off_canvas});
        return;
    }
    for_each_pixel(box, canvas, [&](Pixel pixel) {
        const auto weights = barycentric.weights_at(offset.sample_of(pixel));
        const bool is_inside = !(weights[0] < zero) && !(weights[1] < zero) && !(weights[2] < zero);
        sink(SampleTested<Scalar>{
            .x = pixel.x, .y = pixel.y, .weights = weights, .inside = is_inside});
    });
}

} // namespace rastertrace
