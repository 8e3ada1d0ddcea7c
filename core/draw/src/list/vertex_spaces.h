// SPDX-License-Identifier: MIT
#pragma once

// The spaces of a vertex up to clip space.

#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/transform/matrix.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace rastertrace {

/// `matrix` times `vector`, or `vector` itself if there is no matrix.
template <typename Scalar>
Vec<Scalar, 4> moved(const std::optional<Matrix<Scalar>>& matrix, const Vec<Scalar, 4>& vector) {
    return matrix ? *matrix * vector : vector;
}

/// The first spaces of a vertex, in homogeneous coordinates.
template <typename Scalar> struct VertexPositions {
    Vec<Scalar, 4> object;
    Vec<Scalar, 4> world;
    Vec<Scalar, 4> camera;
    Vec<Scalar, 4> clip;
};

template <typename Scalar>
VertexPositions<Scalar> positions_of(const SceneVertex& vertex,
                                     const std::optional<Matrix<Scalar>>& model,
                                     const Transforms<Scalar>& transforms) {
    VertexPositions<Scalar> positions;
    positions.object = {scalar_from<Scalar>(vertex.x), scalar_from<Scalar>(vertex.y),
                        scalar_from<Scalar>(vertex.z), scalar_from<Scalar>(1)};
    positions.world = moved(model, positions.object);
    positions.camera = moved(transforms.view, positions.world);
    positions.clip = moved(transforms.projection, positions.camera);
    return positions;
}

/// Calls `visit(index, model)` with each vertex that is used, and the matrix of its object.
template <typename Scalar, typename Visit>
void for_each_used_vertex(const Scene& scene, const Transforms<Scalar>& transforms,
                          const std::vector<bool>& is_used, Visit&& visit) {
    std::size_t object = 0;
    for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
        while (object < scene.objects.size() && i >= scene.objects[object].end_vertex)
            ++object;
        if (is_used[i])
            visit(i, object < scene.objects.size() ? transforms.models[object]
                                                   : transforms.rest_model);
    }
}

/// A vertex in clip space is in view if it lies outside of no plane.
template <typename Scalar>
bool is_in_view(const Vec<Scalar, 4>& clip, const Transforms<Scalar>& transforms) {
    return std::all_of(transforms.planes.begin(), transforms.planes.end(),
                       [&clip](const auto& plane) { return plane.has_inside(clip); });
}

} // namespace rastertrace
