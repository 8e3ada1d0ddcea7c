// SPDX-License-Identifier: MIT
#pragma once

// A triangle filled by the algorithm that a method names.
//
//     fill(triangle, colors, method, grid, canvas, FlatPainter(image, color));

#include <rastertrace/core/draw/paint/fill_top_left.h>
#include <rastertrace/core/draw/paint/piece_in.h>
#include <rastertrace/core/draw/paint/sample_walk.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/method.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/fill_barycentric.h>
#include <rastertrace/core/raster/fill_fan.h>
#include <rastertrace/core/raster/fill_scanline.h>
#include <rastertrace/core/raster/fill_two_halves.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/triangle.h>

#include <array>

namespace rastertrace {

/// The samples that the scene's triangles are filled by.
template <typename Scalar> SampleGrid<Scalar> sample_grid(const Scene& scene, const Plan& plan) {
    return {sample_offset<Scalar>(sample_of(scene.method), plan.denominator),
            canvas_of_samples(scene.method, scene.canvas)};
}

/// Fills a triangle. `sink` is the painter of its rows and pixels. Only the fan needs the colors of
/// the vertices, or those of all pixels.
template <typename Scalar, typename Sink>
void fill(const Triangle<Scalar>& triangle, const std::array<Color, 3>& colors,
          const Method& method, const SampleGrid<Scalar>& grid, Canvas canvas, Sink&& sink,
          const LineColors* of_fan = nullptr) {
    const ScanlineRules rules{
        .lerp = method.lerp, .span = span_rounding(method), .rows = rows_of_triangles(method)};
    switch (method.fill) {
    case Fill::scanline:
        return fill_scanline(triangle, grid.offset(), rules, canvas, sink);
    case Fill::two_halves:
        return fill_two_halves(triangle, grid.offset(), rules, canvas, sink);
    case Fill::barycentric:
        return fill_barycentric(triangle, grid.offset(), canvas, sink);
    case Fill::top_left:
        return fill_top_left(triangle, grid, canvas_of_samples(method, canvas), sink);
    case Fill::fan:
        return fill_fan(
            triangle, colors, grid.offset(),
            {.passes = method.fan_passes, .lines = line_rules(method), .colors = of_fan}, canvas,
            sink);
    }
    not_an_enumerator();
}

} // namespace rastertrace
