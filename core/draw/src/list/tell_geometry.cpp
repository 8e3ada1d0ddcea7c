// SPDX-License-Identifier: MIT
// Tells the matrices of a scene, and its vertices through their spaces.

#include <rastertrace/core/draw/list/geometry.h>

#include "list/vertex_spaces.h"

namespace rastertrace {

/// Tells every vertex through its spaces, except those that the scene has no matrix for. A vertex
/// that is not in view stops at clip space.
template <typename Scalar>
void tell_vertices(const Scene& scene, const Transforms<Scalar>& transforms,
                   const Listener& listener) {
    if (!listener.takes<VertexPlaced<Scalar>>())
        return;
    const std::vector<bool> is_used = used_vertices(scene);
    for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
        if (!is_used[i])
            continue;
        const std::string_view name = scene.vertices[i].name;
        const auto& model = model_of(scene, transforms, i);
        const auto positions = positions_of(scene.vertices[i], model, transforms);
        if (model)
            tell_position<Scalar>(name, Space::object, positions.object, 3, listener);
        if (!transforms.begins_in_clip_space)
            tell_position<Scalar>(name, Space::world, positions.world, 3, listener);
        if (transforms.view)
            tell_position<Scalar>(name, Space::camera, positions.camera, 3, listener);
        if (transforms.projection || transforms.begins_in_clip_space)
            tell_position<Scalar>(name, Space::clip, positions.clip, 4, listener);
        if (is_in_view(positions.clip, transforms))
            tell_positions_on_screen(name, positions.clip, transforms, listener);
    }
}

template <typename Scalar>
void tell_matrix(std::string_view name, std::string_view object,
                 const std::optional<Matrix<Scalar>>& matrix,
                 const MatrixFactors<Rational>& exact_factors, const Camera* camera,
                 const Listener& listener) {
    if (!matrix)
        return;
    bool are_finite = true;
    std::vector<MatrixFactor<Scalar>> factors;
    for (const MatrixFactor<Rational>& factor : exact_factors) {
        factors.push_back({factor.name, rounded<Scalar>(factor.matrix)});
        are_finite = are_finite && all_finite(factors.back().matrix);
    }
    std::vector<Vec<Scalar, 3>> vectors;
    if (camera != nullptr)
        for (const Numbers3& numbers : {camera->position, camera->look_at, camera->up}) {
            const Vec<Rational, 3> v = exact(numbers);
            vectors.push_back({nearest_scalar<Scalar>(v.x), nearest_scalar<Scalar>(v.y),
                               nearest_scalar<Scalar>(v.z)});
            are_finite = are_finite && all_finite<Scalar>(vectors.back());
        }
    if (!are_finite) {
        factors.clear();
        vectors.clear();
    }
    std::vector<std::string_view> names;
    std::vector<std::array<Scalar, 4>> rows;
    for (const auto& [factor, of_factor] : factors) {
        names.push_back(factor);
        rows.insert(rows.end(), of_factor.rows.begin(), of_factor.rows.end());
    }
    ListenerSink{listener}(MatrixSetUp<Scalar>{.name = name,
                                               .object = if_any(object),
                                               .rows = matrix->rows,
                                               .factors = if_any(names),
                                               .factor_rows = if_any(rows),
                                               .camera = if_any(vectors)});
}

/// Tells the matrices of a scene.
template <typename Scalar>
void tell_matrices(const Scene& scene, const Transforms<Scalar>& transforms,
                   const Listener& listener) {
    if (!listener.takes<MatrixSetUp<Scalar>>())
        return;
    for (std::size_t i = 0; i < transforms.models.size(); ++i)
        tell_matrix<Scalar>("model", scene.objects[i].name, transforms.models[i],
                            factors_of(scene.objects[i].model.steps()), nullptr, listener);
    if (scene.objects.empty())
        tell_matrix<Scalar>("model", {}, transforms.rest_model, {}, nullptr, listener);
    tell_matrix<Scalar>("view", {}, transforms.view,
                        scene.camera
                            ? factors_of(*scene.camera, view_axis_of(scene.projection.type))
                            : std::vector<MatrixFactor<Rational>>(),
                        scene.camera ? &*scene.camera : nullptr, listener);
    tell_matrix<Scalar>("projection", {}, transforms.projection,
                        factors_of(scene.projection, scene.canvas), nullptr, listener);
    tell_matrix<Scalar>("viewport", {}, transforms.viewport,
                        factors_of(scene.viewport, scene.canvas), nullptr, listener);
}

template <typename Scalar>
void tell_order(const Scene& scene, const PainterOrder<Scalar>& order, const Listener& listener) {
    std::vector<std::string_view> names;
    std::vector<std::int64_t> listed;
    for (const std::size_t i : order.primitives)
        if (is_filled(scene.primitives[i].kind)) {
            names.push_back(scene.primitives[i].name);
            listed.push_back(static_cast<std::int64_t>(i) + 1);
        }
    ListenerSink{listener}(
        PrimitivesOrdered<Scalar>{.names = names, .distances = order.keys, .listed = listed});
}

template <typename Scalar>
void tell_geometry(const Scene& scene, const ScreenList<Scalar>& list, const Listener& listener) {
    const Transforms<Scalar>& transforms = list.transforms;
    tell_matrices(scene, transforms, listener);
    if (scene.has_transforms() || scene.keeps_transforms())
        tell_vertices(scene, transforms, listener);
    if (list.order)
        tell_order(scene, *list.order, listener);
}

#define INSTANTIATE(Coordinate)                                                                    \
    template void tell_geometry(const Scene&, const ScreenList<Coordinate>&, const Listener&);
RASTERTRACE_FOR_EACH_COORDINATE(INSTANTIATE)

template void tell_matrix(std::string_view, std::string_view,
                          const std::optional<Matrix<Rational>>&, const MatrixFactors<Rational>&,
                          const Camera*, const Listener&);
template void tell_order(const Scene&, const PainterOrder<Rational>&, const Listener&);

} // namespace rastertrace
