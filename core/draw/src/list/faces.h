// SPDX-License-Identifier: MIT
#pragma once

// Tests and lights faces, and finds the lines that are hidden with them.

#include "list/vertex_spaces.h"

#include <rastertrace/core/draw/list/light.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/facing.h>
#include <rastertrace/core/raster/shading.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace rastertrace {

/// True if a primitive has a face that is tested or lit.
inline bool has_face(const Scene& scene, const ScenePrimitive& primitive) {
    return is_filled(primitive.kind) &&
           (scene.method.cull != Cull::none || scene.method.shade == Shade::lambert);
}

/// For each primitive of the scene: true if it is a side of faces, and none of them is drawn.
/// `is_drawn(index)` tells whether a triangle is drawn. Empty if no line depends on faces.
std::vector<bool> culled_sides_of(const Scene& scene,
                                  const std::function<bool(std::size_t index)>& is_drawn);

/// The vector from a face to the light.
template <typename Scalar>
Vec<Scalar, 3> light_from(const Light& light, const Vec<Scalar, 3>& centroid) {
    const Vec<Scalar, 3> at{scalar_from<Scalar>(light.at[0]), scalar_from<Scalar>(light.at[1]),
                            scalar_from<Scalar>(light.at[2])};
    return light.kind == Light::Kind::position ? at - centroid : at;
}

/// Tests a face against the view: where it is seen from, and whether it is culled.
template <typename Scalar>
FaceTested<Scalar> tested_face(const Scene& scene, const Vec<Scalar, 3>& eye,
                               const Vec<Scalar, 3>& normal, const Vec<Scalar, 3>& centroid) {
    const Cull cull = scene.method.cull;
    const bool is_by_light = cull == Cull::light;
    const Vec<Scalar, 3> view = is_by_light ? light_from<Scalar>(*scene.light, centroid)
                                : is_perspective(scene.projection.type) ? eye - centroid
                                                                        : eye;
    const Scalar product = dot(normal, view);
    const auto cosine = cosine_between(normal, view);
    return {.normal = normal,
            .view = view,
            .dot = product,
            .cosine = cosine ? std::optional(to_double(*cosine)) : std::nullopt,
            .by = is_by_light ? std::optional<std::string_view>("light") : std::nullopt,
            .culled = is_culled(cull, product),
            .opposite = is_culled(cull, Scalar(-product))};
}

/// Lights a face by Lambert's law. A face turned from the light is black.
template <typename Scalar>
FaceLit<Scalar> lit_face(const Scene& scene, Color color, const Vec<Scalar, 3>& normal,
                         const Vec<Scalar, 3>& centroid) {
    const Vec<Scalar, 3> light = light_from<Scalar>(*scene.light, centroid);
    const Scalar product = dot(normal, light);
    const auto cosine = cosine_between(normal, light);
    using Cosine = typename decltype(cosine)::value_type;
    const Cosine intensity = scalar_from<Scalar>(0) < product && cosine ? *cosine : Cosine(0);
    return {.normal = normal,
            .light = light,
            .dot = product,
            .intensity = to_double(intensity),
            .color = lit(color, intensity, scene.method.color_rounding)};
}

template <typename Scalar>
Face<Scalar> face_of(const Scene& scene, const Transforms<Scalar>& transforms,
                     const ScenePrimitive& primitive, std::span<const Vec<Scalar, 3>> world) {
    const Vec<Scalar, 3> normal = normal_of<Scalar>(world);
    if (has_no_length<Scalar>(normal))
        return {.skip = SkipReason::zero_area};
    const Vec<Scalar, 3> centroid = centroid_of<Scalar>(world);

    Face<Scalar> face;
    if (scene.method.cull != Cull::none) {
        face.tested = tested_face<Scalar>(scene, transforms.eye, normal, centroid);
        if (face.tested->culled) {
            face.skip = SkipReason::culled;
            return face;
        }
    }
    if (scene.method.shade == Shade::lambert)
        face.lit = lit_face<Scalar>(scene, primitive.color, normal, centroid);
    return face;
}

/// The face of any primitive; `world` are its corners in the world. A line is skipped if it is a
/// side of faces and none of them is drawn.
template <typename Scalar>
Face<Scalar> face_in(const Scene& scene, const ScreenList<Scalar>& list, std::size_t index,
                     std::span<const Vec<Scalar, 3>> world) {
    const ScenePrimitive& primitive = scene.primitives[index];
    if (has_face(scene, primitive))
        return face_of(scene, list.transforms, primitive, world);
    if (!list.culled_sides.empty() && list.culled_sides[index])
        return {.skip = SkipReason::culled};
    return {};
}

/// False if a number of the face is infinite or no number: a normal is a product of two lengths,
/// and is multiplied by a third.
template <typename Scalar> bool is_finite(const Face<Scalar>& face) {
    const auto& [tested, lit, skip] = face;
    return (!tested || (all_finite<Scalar>(tested->normal) && all_finite<Scalar>(tested->view) &&
                        is_finite(tested->dot) && is_finite(tested->cosine.value_or(0)))) &&
           (!lit || (all_finite<Scalar>(lit->normal) && all_finite<Scalar>(lit->light) &&
                     is_finite(lit->dot) && is_finite(lit->intensity)));
}

} // namespace rastertrace
