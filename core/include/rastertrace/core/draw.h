// SPDX-License-Identifier: MIT
#pragma once

// Draws a scene: every primitive in the scene's order, by the method that the scene names.
//
//     const Image picture = draw<double>(scene, plan_for(scene), NullSink{});

#include <rastertrace/core/fill_scanline.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/plan.h>
#include <rastertrace/core/scene.h>
#include <rastertrace/core/sink.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/triangle.h>

#include <array>
#include <string_view>

namespace rastertrace {

/// Draws `scene` and returns its picture, reporting every step to `sink`. The picture is the same
/// whatever the sink. `Scalar` must be the one of the plan (with_scalar finds it); for double,
/// find_overflow must have found nothing.
template <typename Scalar, typename Sink>
Image draw(const Scene& scene, const Plan& plan, Sink&& sink) {
    const ScanlineRules rules{.lerp = scene.method.lerp,
                              .span = {scene.method.rounding, scene.method.ties}};

    Image image(scene.canvas);
    for (const SceneTriangle& primitive : scene.triangles) {
        // Numbers as typed become numbers to calculate with.
        Triangle<Scalar> triangle;
        std::array<std::string_view, 3> names;
        for (std::size_t i = 0; i < 3; ++i) {
            const SceneVertex& vertex = scene.vertices[primitive.vertices[i]];
            triangle.vertices[i].x = scalar_from<Scalar>(vertex.x, plan.denominator);
            triangle.vertices[i].y = scalar_from<Scalar>(vertex.y, plan.denominator);
            names[i] = vertex.name;
        }
        sink(PrimitiveBegan<Scalar>{.kind = PrimitiveKind::triangle,
                                    .name = primitive.name,
                                    .vertices = names,
                                    .positions = triangle.vertices,
                                    .color = primitive.color});

        fill_scanline(triangle, primitive.color, rules, image, sink);
    }
    return image;
}

} // namespace rastertrace
