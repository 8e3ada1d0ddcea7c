// SPDX-License-Identifier: MIT
// Tells the matrices of a scene, and its vertices through their spaces.

#include <rastertrace/core/draw/list/geometry.h>

#include "list/vertex_spaces.h"
#include "tell/listener_sink.h"

#include <rastertrace/core/numbers/adaptive.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Tells a place of a vertex: the first `count` coordinates.
template <typename Scalar>
void tell_position(std::string_view name, Space space, const Vec<Scalar, 4>& at, std::size_t count,
                   const Listener& listener) {
    const ListenerSink sink(listener);
    const std::array<Scalar, 4> coordinates{at.x, at.y, at.z, at.w};
    sink(VertexPlaced<Scalar>{
        .name = name, .space = space, .at = std::span(coordinates).first(count), .snapped = {}});
}

/// Tells the spaces of a vertex from clip space on.
template <typename Scalar>
void tell_positions_on_screen(std::string_view name, const Vec<Scalar, 4>& clip,
                              const Transforms<Scalar>& transforms, const Listener& listener) {
    const ListenerSink sink(listener);
    const ScreenPositions<Scalar> positions = positions_on_screen(clip, transforms);
    if (transforms.projection && transforms.divides)
        tell_position<Scalar>(name, Space::canonical, positions.canonical, 3, listener);
    const std::array<Scalar, 2> screen{positions.screen.x, positions.screen.y};
    const std::array<Scalar, 2> pixel{positions.pixel.x, positions.pixel.y};
    sink(VertexPlaced<Scalar>{.name = name,
                              .space = Space::screen,
                              .at = screen,
                              .snapped = transforms.snap == Snap::none
                                             ? std::span<const Scalar>()
                                             : std::span<const Scalar>(pixel)});
}

/// Tells every vertex through its spaces; a space that the scene has no matrix for is passed over.
/// A vertex that cannot be seen stops at clip space.
template <typename Scalar>
void tell_vertices(const Scene& scene, const Transforms<Scalar>& transforms,
                   const Listener& listener) {
    if (!listener.takes<VertexPlaced<Scalar>>())
        return;
    for_each_used_vertex(
        scene, transforms, used_vertices(scene), [&](std::size_t i, const auto& model) {
            const std::string_view name = scene.vertices[i].name;
            const auto positions = positions_of(scene.vertices[i], model, transforms);
            if (model)
                tell_position<Scalar>(name, Space::object, positions.object, 3, listener);
            tell_position<Scalar>(name, Space::world, positions.world, 3, listener);
            if (transforms.view)
                tell_position<Scalar>(name, Space::camera, positions.camera, 3, listener);
            if (transforms.projection)
                tell_position<Scalar>(name, Space::clip, positions.clip, 4, listener);
            if (is_in_view(positions.clip, transforms))
                tell_positions_on_screen(name, positions.clip, transforms, listener);
        });
}

template <typename Scalar> bool is_finite(const Scalar& number) {
    if constexpr (std::floating_point<Scalar>)
        return std::isfinite(number);
    else
        return true;
}

/// Tells a matrix, what it is a product of, and the camera of a view.
template <typename Scalar>
void tell_matrix(std::string_view name, std::string_view object,
                 const std::optional<Matrix<Scalar>>& matrix,
                 const std::vector<MatrixFactor<Rational>>& exact_factors, const Camera* camera,
                 const Listener& listener) {
    if (!matrix)
        return;
    bool are_finite = true;
    std::vector<MatrixFactor<Scalar>> factors;
    for (const MatrixFactor<Rational>& factor : exact_factors) {
        factors.push_back({factor.name, rounded<Scalar>(factor.matrix)});
        for (const auto& row : factors.back().matrix.rows)
            are_finite = are_finite && std::all_of(row.begin(), row.end(), is_finite<Scalar>);
    }
    std::vector<Vec<Scalar, 3>> vectors;
    if (camera != nullptr)
        for (const Numbers3& numbers : {camera->position, camera->look_at, camera->up}) {
            const Vec<Rational, 3> v = exact(numbers);
            vectors.push_back({nearest_scalar<Scalar>(v.x), nearest_scalar<Scalar>(v.y),
                               nearest_scalar<Scalar>(v.z)});
            for (const Scalar& coordinate : {vectors.back().x, vectors.back().y, vectors.back().z})
                are_finite = are_finite && is_finite(coordinate);
        }
    if (!are_finite) {
        factors.clear();
        vectors.clear();
    }
    ListenerSink{listener}(MatrixSetUp<Scalar>{
        .name = name, .object = object, .matrix = *matrix, .factors = factors, .camera = vectors});
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

/// Tells the matrices, then the vertices, then what the painter has sorted.
template <typename Scalar>
void tell_geometry(const Scene& scene, const ScreenList<Scalar>& list, const Listener& listener) {
    const ListenerSink sink(listener);
    const Transforms<Scalar>& transforms = list.transforms;
    tell_matrices(scene, transforms, listener);
    if (scene.has_transforms() || scene.keeps_transforms())
        tell_vertices(scene, transforms, listener);
    if (list.order) {
        std::vector<std::string_view> names;
        std::vector<std::size_t> indices;
        for (const std::size_t i : list.order->primitives)
            if (scene.primitives[i].kind == PrimitiveKind::triangle) {
                names.push_back(scene.primitives[i].name);
                indices.push_back(i);
            }
        sink(PrimitivesOrdered<Scalar>{
            .names = names, .distances = list.order->keys, .indices = indices});
    }
}

// For every kind of number that vertices are moved in.

template void tell_position<float>(std::string_view, Space, const Vec<float, 4>&, std::size_t,
                                   const Listener&);
template void tell_positions_on_screen<float>(std::string_view, const Vec<float, 4>&,
                                              const Transforms<float>&, const Listener&);
template void tell_geometry(const Scene&, const ScreenList<float>&, const Listener&);
template void tell_position<double>(std::string_view, Space, const Vec<double, 4>&, std::size_t,
                                    const Listener&);
template void tell_positions_on_screen<double>(std::string_view, const Vec<double, 4>&,
                                               const Transforms<double>&, const Listener&);
template void tell_geometry(const Scene&, const ScreenList<double>&, const Listener&);
template void tell_position<Adaptive>(std::string_view, Space, const Vec<Adaptive, 4>&, std::size_t,
                                      const Listener&);
template void tell_positions_on_screen<Adaptive>(std::string_view, const Vec<Adaptive, 4>&,
                                                 const Transforms<Adaptive>&, const Listener&);
template void tell_geometry(const Scene&, const ScreenList<Adaptive>&, const Listener&);
template void tell_position<Rational>(std::string_view, Space, const Vec<Rational, 4>&, std::size_t,
                                      const Listener&);
template void tell_positions_on_screen<Rational>(std::string_view, const Vec<Rational, 4>&,
                                                 const Transforms<Rational>&, const Listener&);
template void tell_geometry(const Scene&, const ScreenList<Rational>&, const Listener&);

} // namespace rastertrace
