// SPDX-License-Identifier: MIT
#pragma once

// The painter's order of a scene: its faces sorted by their distance from the eye.
//
//     const auto keys = keys_of_faces<double>(scene, [](std::size_t vertex) { return ...; });
//     const auto order = sorted_by_distance(scene, keys);

#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/raster/painter.h>

#include <cstddef>
#include <vector>

namespace rastertrace {

/// The distances that the faces are sorted by, in the scene's order. `distance_of(vertex)` is the
/// distance of a vertex, given by its index in the scene, from the eye.
template <typename Scalar, typename DistanceOf>
std::vector<Scalar> keys_of_faces(const Scene& scene, DistanceOf&& distance_of) {
    std::vector<Scalar> keys;
    std::vector<Scalar> distances;
    for (const ScenePrimitive& one : scene.primitives)
        if (is_filled(one.kind)) {
            distances.clear();
            for (const std::size_t corner : one.corners())
                distances.push_back(distance_of(corner));
            keys.push_back(painter_key<Scalar>(scene.method.painter_key, distances));
        }
    return keys;
}

/// The faces with the farthest first; points and lines keep their turns.
template <typename Scalar>
PainterOrder<Scalar> sorted_by_distance(const Scene& scene, const std::vector<Scalar>& keys) {
    std::vector<std::size_t> faces;
    for (std::size_t i = 0; i < scene.primitives.size(); ++i)
        if (is_filled(scene.primitives[i].kind))
            faces.push_back(i);

    PainterOrder<Scalar> order;
    const std::vector<std::size_t> sorted = painter_order<Scalar>(keys);
    auto next = sorted.begin();
    for (std::size_t i = 0; i < scene.primitives.size(); ++i)
        if (is_filled(scene.primitives[i].kind)) {
            order.keys.push_back(keys[*next]);
            order.primitives.push_back(faces[*next++]);
        } else {
            order.primitives.push_back(i);
        }
    return order;
}

} // namespace rastertrace
