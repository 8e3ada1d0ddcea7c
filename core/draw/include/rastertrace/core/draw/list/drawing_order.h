// SPDX-License-Identifier: MIT
#pragma once

// Orders of drawing that are not the scene's own: every one that a scene can ask for is a row of
// drawing_orders.
//
//     const DistanceOf<double> distance_of = [](std::size_t vertex) { return ...; };
//     const auto order = drawing_orders<double>[0].sorted(scene, distance_of);

#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/raster/painter.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace rastertrace {

/// The order in which the painter draws a scene's primitives. What is no triangle keeps its turn.
template <typename Scalar> struct PainterOrder {
    std::vector<std::size_t> primitives; ///< indices in Scene::primitives
    std::vector<Scalar> keys;            ///< of the triangles, in the order drawn
};

/// Tells how far a vertex of the scene, by its place there, lies from the eye.
template <typename Scalar> using DistanceOf = std::function<const Scalar&(std::size_t vertex)>;

/// The distances that the triangles of a scene are sorted by, in the scene's order.
template <typename Scalar>
std::vector<Scalar> keys_of_triangles(const Scene& scene, const DistanceOf<Scalar>& distance_of) {
    std::vector<Scalar> keys;
    for (const ScenePrimitive& one : scene.primitives)
        if (one.kind == PrimitiveKind::triangle)
            keys.push_back(painter_key(scene.method.painter_key, distance_of(one.vertices[0]),
                                       distance_of(one.vertices[1]), distance_of(one.vertices[2])));
    return keys;
}

/// True if sorting the triangles would leave them as they are.
template <typename Scalar>
bool comes_farthest_first(const Scene& scene, const DistanceOf<Scalar>& distance_of) {
    const std::vector<Scalar> keys = keys_of_triangles(scene, distance_of);
    return std::is_sorted(keys.begin(), keys.end(),
                          [](const Scalar& a, const Scalar& b) { return b < a; });
}

/// Sorts the triangles by their distance from the eye.
template <typename Scalar>
PainterOrder<Scalar> sorted_by_distance(const Scene& scene, const DistanceOf<Scalar>& distance_of) {
    const std::vector<Scalar> keys = keys_of_triangles(scene, distance_of);
    std::vector<std::size_t> triangles;
    for (std::size_t i = 0; i < scene.primitives.size(); ++i)
        if (scene.primitives[i].kind == PrimitiveKind::triangle)
            triangles.push_back(i);

    PainterOrder<Scalar> order;
    const std::vector<std::size_t> places = painter_order<Scalar>(keys);
    auto next = places.begin();
    for (std::size_t i = 0; i < scene.primitives.size(); ++i)
        if (scene.primitives[i].kind == PrimitiveKind::triangle) {
            order.keys.push_back(keys[*next]);
            order.primitives.push_back(triangles[*next++]);
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
    {{Depth::painter, sorted_by_distance<Scalar>, comes_farthest_first<Scalar>}}};

} // namespace rastertrace
