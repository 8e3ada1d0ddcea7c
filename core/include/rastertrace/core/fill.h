// SPDX-License-Identifier: MIT
#pragma once

// A triangle filled by the algorithm that a method names.
//
//     fill(primitive, paint, method, target, sink);

#include <rastertrace/core/depth.h>
#include <rastertrace/core/fill_barycentric.h>
#include <rastertrace/core/fill_fan.h>
#include <rastertrace/core/fill_scanline.h>
#include <rastertrace/core/fill_top_left.h>
#include <rastertrace/core/fill_two_halves.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/method.h>
#include <rastertrace/core/paint.h>
#include <rastertrace/core/placed.h>
#include <rastertrace/core/plan.h>
#include <rastertrace/core/scene.h>
#include <rastertrace/core/triangle.h>

namespace rastertrace {

struct Exactness;

/// What pixels are drawn on and tested against, and where their samples lie.
template <typename Scalar, typename OfPixels = Scalar> struct Target {
    Image& image;
    SampleGrid<Scalar> grid;
    DepthBuffer<DepthOf<OfPixels>>* depth = nullptr; ///< if depths are tested
    Exactness* exactness = nullptr;                  ///< of `adaptive`
};

/// Where the samples of the scene's pixels lie.
template <typename Scalar> SampleGrid<Scalar> sample_grid(const Scene& scene, const Plan& plan) {
    return {scalar_from<Scalar>(sample_offset_of(scene.method), plan.denominator), scene.canvas};
}

/// Fills a triangle with the stages that its pixels go through.
template <typename Scalar, PixelStages stages, typename OfPixels, typename Sink>
void fill(const PlacedPrimitive<Scalar>& primitive, const Paint<Scalar, stages, OfPixels>& paint,
          const Method& method, Target<Scalar, OfPixels>& target, Sink&& sink) {
    const Triangle<Scalar> triangle{primitive.positions};
    Image& image = target.image;
    const ScanlineRules rules{.lerp = method.lerp, .span = span_rounding(method)};
    switch (method.fill) {
    case Fill::scanline:
        return fill_scanline(triangle, paint, rules, image, sink);
    case Fill::two_halves:
        return fill_two_halves(triangle, paint, rules, image, sink);
    case Fill::barycentric:
        return fill_barycentric(triangle, paint, target.grid.sample_offset(), image, sink);
    case Fill::top_left:
        return fill_top_left(triangle, paint, target.grid, image, sink);
    case Fill::fan:
        break;
    }
    fill_fan(triangle, primitive.colors,
             {.passes = method.fan_passes, .color_lerp = method.color_lerp}, image, sink);
}

} // namespace rastertrace
