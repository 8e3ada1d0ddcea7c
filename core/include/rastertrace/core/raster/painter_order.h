// SPDX-License-Identifier: MIT
#pragma once

// The painter: what is far is drawn first, and what is near covers it. Wrong where triangles overlap
// in a circle or cut each other, and where the key that they are sorted by says the wrong thing.
//
//     const auto order = painter_order<double>(scene, [](std::size_t vertex) { return ...; });

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/scene/scene.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <vector>

namespace rastertrace {

/// The order in which the painter draws a scene's primitives: the farthest triangle first; what is
/// no triangle keeps its turn. Of equals, the first stays first. Source: T0, with every triangle
/// drawn, not only the nearest.
template <typename Scalar> struct PainterOrder {
    std::vector<std::size_t> primitives; ///< indices in Scene::primitives
    std::vector<Scalar> keys;            ///< of the triangles, in the order drawn
};

/// The distance that a triangle is sorted by. `distance_of` tells that of a vertex, by its place in
/// the scene.
template <typename Scalar, typename DistanceOf>
Scalar painter_key(const Scene& scene, const ScenePrimitive& triangle, DistanceOf&& distance_of) {
    const Scalar& a = distance_of(triangle.vertices[0]);
    const Scalar& b = distance_of(triangle.vertices[1]);
    const Scalar& c = distance_of(triangle.vertices[2]);
    switch (scene.method.painter_key) {
    case PainterKey::nearest:
        return std::min({a, b, c});
    case PainterKey::farthest:
        return std::max({a, b, c});
    case PainterKey::mean:
        break;
    }
    const Scalar three = scalar_from<Scalar>(3);
    const Scalar sum = a + b + c;
    require_finite(sum);
    if constexpr (std::floating_point<Scalar>)
        if (!std::isfinite(sum))
            return a / three + b / three + c / three;
    return sum / three;
}

/// True if sorting the triangles would leave them as they are.
template <typename Scalar, typename DistanceOf>
bool comes_farthest_first(const Scene& scene, DistanceOf&& distance_of) {
    std::optional<Scalar> before;
    for (const ScenePrimitive& primitive : scene.primitives) {
        if (primitive.kind != PrimitiveKind::triangle)
            continue;
        const Scalar key = painter_key<Scalar>(scene, primitive, distance_of);
        if (before && *before < key)
            return false;
        before = key;
    }
    return true;
}

/// Sorts the triangles by their distance from the eye.
template <typename Scalar, typename DistanceOf>
PainterOrder<Scalar> painter_order(const Scene& scene, DistanceOf&& distance_of) {
    std::vector<std::size_t> triangles;
    std::vector<Scalar> keys(scene.primitives.size());
    for (std::size_t i = 0; i < scene.primitives.size(); ++i)
        if (scene.primitives[i].kind == PrimitiveKind::triangle) {
            triangles.push_back(i);
            keys[i] = painter_key<Scalar>(scene, scene.primitives[i], distance_of);
        }
    std::stable_sort(triangles.begin(), triangles.end(),
                     [&keys](std::size_t a, std::size_t b) { return keys[b] < keys[a]; });

    PainterOrder<Scalar> order;
    auto next = triangles.begin();
    for (std::size_t i = 0; i < scene.primitives.size(); ++i)
        if (scene.primitives[i].kind == PrimitiveKind::triangle) {
            order.keys.push_back(keys[*next]);
            order.primitives.push_back(*next++);
        } else {
            order.primitives.push_back(i);
        }
    return order;
}

} // namespace rastertrace
