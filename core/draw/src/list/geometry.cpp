// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/numbers/adaptive.h>

#include "list/vertex_spaces.h"

#include <rastertrace/core/draw/scene/transforms.h>
#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/raster/rounding.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace rastertrace {

/// True if a matrix of the scene has irrational entries, which are the nearest doubles instead.
bool has_rounded_matrix(const Scene& scene) {
    return (scene.camera && is_rounded(*scene.camera)) || is_rounded(scene.projection) ||
           std::any_of(scene.objects.begin(), scene.objects.end(), [](const SceneObject& object) {
               const auto& steps = object.model.steps();
               return std::any_of(steps.begin(), steps.end(),
                                  [](const ModelStep& step) { return is_rounded(step); });
           });
}

template <typename Scalar> Transforms<Scalar> transforms_of(const Scene& scene) {
    Transforms<Scalar> result;

    // A matrix that moves something, or that the scene keeps although it does not.
    const auto matrix_of = [&](Stage stage,
                               const Matrix<Rational>& exact) -> std::optional<Matrix<Scalar>> {
        if (exact != identity<Rational>())
            result.needed.add(stage);
        else if (!scene.keep.has(stage))
            return std::nullopt;
        return rounded<Scalar>(exact);
    };
    for (const SceneObject& object : scene.objects)
        result.models.push_back(matrix_of(Stage::model, object.model.matrix()));
    result.rest_model = matrix_of(Stage::model, identity<Rational>());
    result.view = matrix_of(
        Stage::view, scene.camera ? view_matrix(*scene.camera, view_axis_of(scene.projection.type))
                                  : identity<Rational>());
    if (scene.projection.type != ProjectionType::none)
        result.projection = rounded<Scalar>(product_of(factors_of(scene.projection, scene.canvas)));
    if (scene.viewport.type != ViewportType::none)
        result.viewport = rounded<Scalar>(product_of(factors_of(scene.viewport, scene.canvas)));

    // A plane near the eye must not be rounded into it.
    const auto nearest = [](const Rational& exact) {
        const Scalar rounded_one = nearest_scalar<Scalar>(exact);
        if constexpr (std::floating_point<Scalar>)
            if (rounded_one == 0 && exact != 0)
                return std::copysign(std::numeric_limits<Scalar>::min(),
                                     static_cast<Scalar>(sgn(exact)));
        return rounded_one;
    };
    for (const ClipPlane<Rational>& plane :
         clip_planes(scene.projection, half_extent(scene.viewport, scene.canvas.width),
                     half_extent(scene.viewport, scene.canvas.height), guard_band))
        result.planes.push_back({plane.name,
                                 {nearest(plane.factors.x), nearest(plane.factors.y),
                                  nearest(plane.factors.z), nearest(plane.factors.w)},
                                 nearest(plane.constant)});
    result.snap = scene.method.snap;
    result.ties = scene.method.ties.value_or(Ties::up);
    return result;
}

/// x/w, y/w and z/w, moved to the screen. w must not be 0.
template <typename Scalar>
ScreenPositions<Scalar> positions_on_screen(const Vec<Scalar, 4>& clip,
                                            const Transforms<Scalar>& transforms) {
    const Vec<Scalar, 4> canonical =
        transforms.divides ? Vec<Scalar, 4>{Scalar(clip.x / clip.w), Scalar(clip.y / clip.w),
                                            Scalar(clip.z / clip.w), scalar_from<Scalar>(1)}
                           : clip;
    const Vec<Scalar, 4> screen = moved(transforms.viewport, canonical);
    require_finite(screen.x);
    require_finite(screen.y);
    const auto snapped = [&transforms](const Scalar& x) {
        if constexpr (std::floating_point<Scalar>)
            if (!std::isfinite(x))
                return x; // find_unfit will say so
        switch (transforms.snap) {
        case Snap::floor:
            return scalar_from<Scalar>(floor_index(x));
        case Snap::truncate:
            return scalar_from<Scalar>(truncate_index(x));
        case Snap::nearest:
            return scalar_from<Scalar>(nearest_index(x, transforms.ties));
        case Snap::none:
            break;
        }
        return x;
    };
    return {.canonical = canonical,
            .screen = {screen.x, screen.y},
            .pixel = {snapped(screen.x), snapped(screen.y)}};
}

/// Which of the scene's vertices a primitive has.
std::vector<bool> used_vertices(const Scene& scene) {
    std::vector<bool> is_used(scene.vertices.size());
    for (const ScenePrimitive& primitive : scene.primitives)
        for (const std::size_t index : primitive.corners())
            is_used[index] = true;
    return is_used;
}

/// The matrix of the object that a vertex belongs to.
template <typename Scalar>
const std::optional<Matrix<Scalar>>&
model_of(const Scene& scene, const Transforms<Scalar>& transforms, std::size_t index) {
    const auto object =
        std::upper_bound(scene.objects.begin(), scene.objects.end(), index,
                         [](std::size_t i, const SceneObject& one) { return i < one.end_vertex; });
    return object == scene.objects.end()
               ? transforms.rest_model
               : transforms.models[static_cast<std::size_t>(object - scene.objects.begin())];
}

/// How far a place in camera space lies in front of the eye. Without a camera and a projection, z as
/// typed is the distance.
template <typename Scalar>
Scalar distance_along_view(const Scene& scene, const Vec<Scalar, 4>& camera) {
    const bool looks_along_plus_z =
        scene.projection.type == ProjectionType::pinhole ||
        (scene.projection.type == ProjectionType::none && !scene.camera);
    return looks_along_plus_z ? camera.z : Scalar(-camera.z);
}

/// The eye in the world: the camera's place, or the origin without one. Where nothing converges, the
/// direction to it, against the view, which is the same for all faces.
template <typename Scalar> Vec<Scalar, 3> eye_of(const Scene& scene) {
    const Vec<Rational, 3> ahead{Rational(0), Rational(0), Rational(1)};
    const Vec<Rational, 3> eye =
        is_perspective(scene.projection.type)
            ? exact(scene.camera ? scene.camera->position : Numbers3{0, 0, 0})
        : scene.camera ? axes_of(*scene.camera).back
                       : ahead;
    return {nearest_scalar<Scalar>(eye.x), nearest_scalar<Scalar>(eye.y),
            nearest_scalar<Scalar>(eye.z)};
}

/// A vertex in the world and in clip space.
template <typename Scalar>
VertexInSpace<Scalar> vertex_in_space(const Scene& scene, const Transforms<Scalar>& transforms,
                                      const std::optional<Matrix<Scalar>>& model,
                                      std::size_t index) {
    const VertexPositions<Scalar> positions =
        positions_of(scene.vertices[index], model, transforms);
    for (const Scalar* coordinate :
         {&positions.clip.x, &positions.clip.y, &positions.clip.z, &positions.clip.w})
        require_finite(*coordinate);
    return {.world = {positions.world.x, positions.world.y, positions.world.z},
            .in_clip_space = {.clip = positions.clip,
                              .distance = distance_along_view<Scalar>(scene, positions.camera),
                              .is_in_view = is_in_view(positions.clip, transforms)}};
}
template <typename Scalar>
VertexInSpace<Scalar> vertex_in_space(const Scene& scene, const Transforms<Scalar>& transforms,
                                      std::size_t index) {
    return vertex_in_space(scene, transforms, model_of(scene, transforms, index), index);
}

/// Takes a vertex to clip space.
template <typename Scalar>
void move_to_clip_space(const Scene& scene, const std::optional<Matrix<Scalar>>& model,
                        std::size_t index, Geometry<Scalar>& geometry) {
    auto [world, in_clip_space] = vertex_in_space(scene, geometry.list.transforms, model, index);
    geometry.vertices[index] = std::move(in_clip_space);
    if (!geometry.world.empty())
        geometry.world[index] = std::move(world);
}

/// Takes a vertex from there on to the screen, if it can be seen.
template <typename Scalar>
void move_to_screen(const ClipSpaceVertex<Scalar>& vertex, const Transforms<Scalar>& transforms,
                    ScreenVertex<Scalar>& on_screen) {
    if (vertex.is_in_view)
        on_screen.position = positions_on_screen(vertex.clip, transforms).pixel;
}

/// Takes a vertex to clip space, and on to the screen if it can be seen.
template <typename Scalar>
void move_vertex(const Scene& scene, std::size_t index, Geometry<Scalar>& geometry) {
    const auto& transforms = geometry.list.transforms;
    move_to_clip_space(scene, model_of(scene, transforms, index), index, geometry);
    move_to_screen(geometry.vertices[index], transforms, geometry.list.vertices[index]);
}

/// A geometry whose vertices have no place yet. What stays is allocated first, so that what goes leaves no
/// hole behind.
template <typename Scalar> Geometry<Scalar> empty_geometry(const Scene& scene) {
    Geometry<Scalar> result;
    result.list.transforms = transforms_of<Scalar>(scene);
    result.list.mixes_colors = scene.mixes_colors();
    result.list.depth = scene.depth();
    result.list.vertices.resize(scene.vertices.size());
    result.list.is_drawn.resize(scene.vertices.size());
    result.list.primitives.reserve(scene.primitives.size());
    result.vertices.resize(scene.vertices.size());
    result.is_used.resize(scene.vertices.size());
    if (scene.tests_faces()) {
        result.world.resize(scene.vertices.size());
        result.list.transforms.eye = eye_of<Scalar>(scene);
    }
    return result;
}

/// Throws Undecided if a number may be of either sign. Only Adaptive leaves that open.
template <typename Scalar> void require_decided(const Scalar& number) {
    if constexpr (std::same_as<Scalar, Adaptive>)
        static_cast<void>(number < Adaptive(0));
}

/// Takes every vertex that is used to clip space, and on to the screen if it can be seen.
template <typename Scalar> Geometry<Scalar> geometry_of(const Scene& scene) {
    Geometry<Scalar> result = empty_geometry<Scalar>(scene);
    result.is_used = used_vertices(scene);

    // To clip space. A plane that no vertex lies outside of cannot cut anything.
    Transforms<Scalar>& transforms = result.list.transforms;
    std::vector<std::size_t> outside(transforms.planes.size());
    for_each_used_vertex(scene, transforms, result.is_used, [&](std::size_t i, const auto& model) {
        move_to_clip_space(scene, model, i, result);
        const ClipSpaceVertex<Scalar>& vertex = result.vertices[i];
        if (!vertex.is_in_view)
            for (std::size_t plane = 0; plane < transforms.planes.size(); ++plane)
                if (!transforms.planes[plane].has_inside(vertex.clip))
                    ++outside[plane];
        if (vertex.clip.w != scalar_from<Scalar>(1))
            transforms.needed.add(Stage::divide);
    });
    // Behind the eye there is no 1/z: on that hangs whether the scene can be drawn (plan.cpp).
    if (scene.depth() == Depth::inverse_z && !is_perspective(scene.projection.type))
        for_each_used_vertex(scene, transforms, result.is_used, [&](std::size_t i, const auto&) {
            require_decided(result.vertices[i].distance);
        });
    transforms.divides = transforms.needed.has(Stage::divide) || scene.keep.has(Stage::divide);
    for (std::size_t plane = 0; plane < transforms.planes.size(); ++plane)
        result.list.outside.push_back({transforms.planes[plane].name, outside[plane]});
    if (!scene.keep.has(Stage::clip)) {
        std::vector<ClipPlane<Scalar>> crossed;
        for (std::size_t plane = 0; plane < transforms.planes.size(); ++plane)
            if (outside[plane] > 0)
                crossed.push_back(transforms.planes[plane]);
        transforms.planes = std::move(crossed);
    }

    // On to the screen, what can be seen.
    for (std::size_t i = 0; i < result.vertices.size(); ++i)
        move_to_screen(result.vertices[i], transforms, result.list.vertices[i]);

    const DistanceOf<Scalar> distance_of = [&result](std::size_t index) -> const Scalar& {
        return result.vertices[index].distance;
    };
    for (const DrawingOrder<Scalar>& order : drawing_orders<Scalar>)
        if (order.depth == scene.depth()) {
            if (!order.is_sorted(scene, distance_of))
                transforms.needed.add(Stage::order);
            if (transforms.needed.has(Stage::order) || scene.keep.has(Stage::order))
                result.list.order = order.sorted(scene, distance_of);
        }
    return result;
}

// For every kind of number that vertices are moved in.

template Geometry<float> geometry_of(const Scene&);
template VertexInSpace<float> vertex_in_space(const Scene&, const Transforms<float>&, std::size_t);
template ScreenPositions<float> positions_on_screen(const Vec<float, 4>&, const Transforms<float>&);

template Geometry<double> geometry_of(const Scene&);
template VertexInSpace<double> vertex_in_space(const Scene&, const Transforms<double>&,
                                               std::size_t);
template ScreenPositions<double> positions_on_screen(const Vec<double, 4>&,
                                                     const Transforms<double>&);

template Geometry<Adaptive> geometry_of(const Scene&);
template VertexInSpace<Adaptive> vertex_in_space(const Scene&, const Transforms<Adaptive>&,
                                                 std::size_t);
template ScreenPositions<Adaptive> positions_on_screen(const Vec<Adaptive, 4>&,
                                                       const Transforms<Adaptive>&);

template Geometry<Rational> geometry_of(const Scene&);
template Geometry<Rational> empty_geometry(const Scene&);
template VertexInSpace<Rational> vertex_in_space(const Scene&, const Transforms<Rational>&,
                                                 std::size_t);
template void move_vertex(const Scene&, std::size_t, Geometry<Rational>&);
template ScreenPositions<Rational> positions_on_screen(const Vec<Rational, 4>&,
                                                       const Transforms<Rational>&);

} // namespace rastertrace
