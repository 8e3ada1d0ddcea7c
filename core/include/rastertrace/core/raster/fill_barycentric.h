// SPDX-License-Identifier: MIT
#pragma once

// The bounding-box fill of tinyrenderer's second lesson: try every pixel of the smallest
// axis-aligned rectangle around the triangle, and draw those whose barycentric coordinates are not
// negative.
//
// Source: Sokolov, tinyrenderer, lesson 2, in the Chinese notes on it.
//
//     fill_barycentric(triangle, offset, {}, canvas, FlatPainter(image, color));

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/raster/bounding_box.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/core/raster/sample_offset.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/core/raster/triangle.h>

namespace rastertrace {

/// The triangle of all points whose weights are at least -`by`: where two of them are -by, the third
/// is 1 + 2 by.
template <typename Scalar>
Triangle<Scalar> widened(const Triangle<Scalar>& triangle, const Scalar& by) {
    const auto& v = triangle.vertices;
    Triangle<Scalar> result;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec<Scalar, 2>& a = v[i];
        const Vec<Scalar, 2>& b = v[(i + 1) % 3];
        const Vec<Scalar, 2>& c = v[(i + 2) % 3];
        result.vertices[i] = {Scalar(a.x + by * (a.x - b.x) + by * (a.x - c.x)),
                              Scalar(a.y + by * (a.y - b.y) + by * (a.y - c.y))};
    }
    return result;
}

/// Fills the closed triangle: samples on its edges are drawn, so two triangles that share an edge
/// both draw them.
/// With a tolerance, a weight may be as far below 0. The box is cut to the canvas. A triangle without area has no barycentric coordinates and is
/// skipped.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, SampleTested<Scalar>, PrimitiveSkipped>
void fill_barycentric(const Triangle<Scalar>& triangle, const SampleOffset<Scalar>& offset,
                      Tolerance tolerance, Canvas canvas, Sink&& sink) {
    const Scalar zero = scalar_from<Scalar>(0);
    const Barycentric<Scalar> barycentric(triangle);
    if (barycentric.area2() == zero) {
        sink(PrimitiveSkipped{.why = SkipReason::zero_area});
        return;
    }

    const BoundingBox box = bounding_box(
        tolerance.is_zero() ? triangle : widened(triangle, tolerance.in<Scalar>()), offset, canvas);
    if (box.is_empty()) {
        sink(PrimitiveSkipped{.why = SkipReason::off_canvas});
        return;
    }
    const Scalar least = tolerance.is_zero() ? zero : Scalar(-tolerance.in<Scalar>());
    for_each_pixel(box, canvas, [&](Pixel pixel) {
        const auto weights = barycentric.weights_at(offset.sample_of(pixel));
        const bool is_inside =
            !(weights[0] < least) && !(weights[1] < least) && !(weights[2] < least);
        sink(SampleTested<Scalar>{.pixel = pixel, .weights = weights, .is_inside = is_inside});
    });
}

} // namespace rastertrace
