// SPDX-License-Identifier: MIT
#pragma once

// Orders of drawing. The painter: what is far is drawn first, and what is near covers it. Wrong where triangles
// overlap in a circle or cut each other, and where the key that they are sorted by says the wrong thing.
//
//     const DistanceOf<double> distance_of = [](std::size_t vertex) { return ...; };
//     const auto order = painter_order<double>(scene, distance_of);
//
// Every order that a scene can ask for is a row of one table, drawing_orders.

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/scene/scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <functional>
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

/// Tells how far a vertex of the scene, by its place there, lies from the eye.
template <typename Scalar> using DistanceOf = std::function<const Scalar&(std::size_t vertex)>;

/// The distance that a triangle is sorted by.
template <typename Scalar>
Scalar painter_key(const Scene& scene, const ScenePrimitive& triangle,
                   const DistanceOf<Scalar>& distance_of) {
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
template <typename Scalar>
bool comes_farthest_first(const Scene& scene, const DistanceOf<Scalar>& distance_of) {
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
template <typename Scalar>
PainterOrder<Scalar> painter_order(const Scene& scene, const DistanceOf<Scalar>& distance_of) {
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

/// An order of drawing that is not the scene's own.
template <typename Scalar> struct DrawingOrder {
    Depth depth; ///< the choice that asks for it
    PainterOrder<Scalar> (*sorted)(const Scene& scene, const DistanceOf<Scalar>& distance_of);
    bool (*is_sorted)(const Scene& scene, const DistanceOf<Scalar>& distance_of); ///< already
};

template <typename Scalar>
inline constexpr std::array<DrawingOrder<Scalar>, 1> drawing_orders{
    {{Depth::painter, painter_order<Scalar>, comes_farthest_first<Scalar>}}};

} // namespace rastertrace
