// SPDX-License-Identifier: MIT
#include "list/faces.h"

#include <rastertrace/core/draw/list/light.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/raster/facing.h>
#include <rastertrace/core/raster/shading.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <concepts>
#include <initializer_list>
#include <optional>

namespace rastertrace {

namespace {

/// The vector from a face to the light.
template <typename Scalar>
Vec<Scalar, 3> light_from(const Light& light, const Vec<Scalar, 3>& centroid) {
    const Vec<Scalar, 3> at{scalar_from<Scalar>(light.at[0]), scalar_from<Scalar>(light.at[1]),
                            scalar_from<Scalar>(light.at[2])};
    return light.kind == Light::Kind::position ? at - centroid : at;
}

} // namespace

template <typename Scalar>
Face<Scalar> face_of(const Scene& scene, const Transforms<Scalar>& transforms,
                     const ScenePrimitive& primitive, const std::array<Vec<Scalar, 3>, 3>& world) {
    Face<Scalar> face;
    const auto& [a, b, c] = world;
    const Vec<Scalar, 3> normal = normal_of<Scalar>(a, b, c);
    if (has_no_length<Scalar>(normal)) {
        face.skip = SkipReason::zero_area;
        return face;
    }
    const Vec<Scalar, 3> centroid = centroid_of<Scalar>(a, b, c);
    const Scalar zero = scalar_from<Scalar>(0);

    const Cull cull = scene.method.cull;
    if (cull != Cull::none) {
        const bool is_by_light = cull == Cull::light;
        const Vec<Scalar, 3> view = is_by_light ? light_from<Scalar>(*scene.light, centroid)
                                    : is_perspective(scene.projection.type)
                                        ? transforms.eye - centroid
                                        : transforms.eye;
        const Scalar product = dot(normal, view);
        const auto cosine = cosine_between(normal, view);
        face.tested =
            FaceTested<Scalar>{.normal = normal,
                               .view = view,
                               .dot = product,
                               .cosine = cosine ? std::optional(to_double(*cosine)) : std::nullopt,
                               .is_by_light = is_by_light,
                               .is_culled = is_culled(cull, product),
                               .is_culled_opposite = is_culled(cull, Scalar(-product))};
        if (face.tested->is_culled) {
            face.skip = SkipReason::culled;
            return face;
        }
    }

    if (scene.method.shade == Shade::lambert) {
        const Vec<Scalar, 3> light = light_from<Scalar>(*scene.light, centroid);
        const Scalar product = dot(normal, light);
        const auto cosine = cosine_between(normal, light);
        using Cosine = typename decltype(cosine)::value_type;
        const Cosine intensity = zero < product && cosine ? *cosine : Cosine(0);
        face.lit =
            FaceLit<Scalar>{.normal = normal,
                            .light = light,
                            .dot = product,
                            .intensity = to_double(intensity),
                            .color = lit(primitive.color, intensity, scene.method.color_rounding)};
    }
    return face;
}

bool has_face(const Scene& scene, const ScenePrimitive& primitive) {
    return primitive.kind == PrimitiveKind::triangle &&
           (scene.method.cull != Cull::none || scene.method.shade == Shade::lambert);
}

template <typename Scalar>
Face<Scalar> face_in(const Scene& scene, const ScreenList<Scalar>& list, std::size_t index,
                     const std::array<Vec<Scalar, 3>, 3>& world) {
    const ScenePrimitive& primitive = scene.primitives[index];
    if (has_face(scene, primitive))
        return face_of(scene, list.transforms, primitive, world);
    if (!list.culled_sides.empty() && list.culled_sides[index])
        return {.skip = SkipReason::culled};
    return {};
}

std::vector<bool> culled_sides_of(const Scene& scene,
                                  const std::function<bool(std::size_t index)>& is_drawn) {
    const auto& primitives = scene.primitives;
    if (scene.method.cull == Cull::none ||
        std::none_of(primitives.begin(), primitives.end(),
                     [](const ScenePrimitive& one) { return one.is_side; }))
        return {};

    // A face is drawn if one of its triangles is: one without area never is.
    const auto face_number = [&primitives](std::size_t i) {
        return primitives[i].polygon == 0 ? i : primitives.size() + primitives[i].polygon;
    };
    std::vector<std::size_t> triangles;
    std::vector<std::size_t> faces;
    for (std::size_t i = 0; i < primitives.size(); ++i)
        if (primitives[i].kind == PrimitiveKind::triangle) {
            triangles.push_back(i);
            if (is_drawn(i))
                faces.push_back(face_number(i));
        }
    std::sort(faces.begin(), faces.end());

    // Their sides: between two triangles of one face lies a diagonal.
    struct SideOfFace {
        std::size_t low, high, face;
        auto operator<=>(const SideOfFace&) const = default;
    };
    std::vector<SideOfFace> sides;
    for (const std::size_t i : triangles)
        if (std::binary_search(faces.begin(), faces.end(), face_number(i)))
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t from = primitives[i].vertices[k];
                const std::size_t to = primitives[i].vertices[(k + 1) % 3];
                sides.push_back({std::min(from, to), std::max(from, to), face_number(i)});
            }
    std::sort(sides.begin(), sides.end());
    const auto is_drawn_side = [&sides](std::size_t from, std::size_t to) {
        const SideOfFace first{std::min(from, to), std::max(from, to), 0};
        auto side = std::lower_bound(sides.begin(), sides.end(), first);
        while (side != sides.end() && side->low == first.low && side->high == first.high) {
            const auto next = std::upper_bound(side, sides.end(), *side);
            if (next - side == 1)
                return true;
            side = next;
        }
        return false;
    };
    std::vector<bool> result(primitives.size());
    for (std::size_t i = 0; i < primitives.size(); ++i)
        result[i] = primitives[i].is_side &&
                    !is_drawn_side(primitives[i].vertices[0], primitives[i].vertices[1]);
    return result;
}

template <typename Scalar> bool is_finite(const Face<Scalar>& face) {
    if constexpr (std::floating_point<Scalar>) {
        const auto all_finite = [](const Vec<Scalar, 3>& a, const Vec<Scalar, 3>& b,
                                   std::initializer_list<double> others) {
            return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z) &&
                   std::isfinite(b.x) && std::isfinite(b.y) && std::isfinite(b.z) &&
                   std::all_of(others.begin(), others.end(),
                               [](double one) { return std::isfinite(one); });
        };
        const auto& [tested, lit, skip] = face;
        return (!tested || all_finite(tested->normal, tested->view,
                                      {tested->dot, tested->cosine.value_or(0)})) &&
               (!lit || all_finite(lit->normal, lit->light, {lit->dot, lit->intensity}));
    }
    return true;
}

template Face<float> face_of(const Scene&, const Transforms<float>&, const ScenePrimitive&,
                             const std::array<Vec<float, 3>, 3>&);
template Face<float> face_in(const Scene&, const ScreenList<float>&, std::size_t,
                             const std::array<Vec<float, 3>, 3>&);
template bool is_finite(const Face<float>&);

template Face<double> face_of(const Scene&, const Transforms<double>&, const ScenePrimitive&,
                              const std::array<Vec<double, 3>, 3>&);
template Face<double> face_in(const Scene&, const ScreenList<double>&, std::size_t,
                              const std::array<Vec<double, 3>, 3>&);
template bool is_finite(const Face<double>&);

template Face<Adaptive> face_of(const Scene&, const Transforms<Adaptive>&, const ScenePrimitive&,
                                const std::array<Vec<Adaptive, 3>, 3>&);
template Face<Adaptive> face_in(const Scene&, const ScreenList<Adaptive>&, std::size_t,
                                const std::array<Vec<Adaptive, 3>, 3>&);
template bool is_finite(const Face<Adaptive>&);

template Face<Rational> face_of(const Scene&, const Transforms<Rational>&, const ScenePrimitive&,
                                const std::array<Vec<Rational, 3>, 3>&);
template Face<Rational> face_in(const Scene&, const ScreenList<Rational>&, std::size_t,
                                const std::array<Vec<Rational, 3>, 3>&);
template bool is_finite(const Face<Rational>&);

} // namespace rastertrace
