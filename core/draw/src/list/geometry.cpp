// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/list/geometry.h>

#include "list/vertex_spaces.h"

#include <rastertrace/core/draw/list/drawing_order.h>
#include <rastertrace/core/draw/scene/transforms.h>
#include <rastertrace/core/numbers/irrational.h>

#include <limits>
#include <utility>

namespace rastertrace {

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
    result.begins_in_clip_space = scene.projection.type == ProjectionType::clip_space;

    // A matrix that moves something, or that the scene keeps although it does not.
    const auto matrix_of = [&](Stage stage,
                               const Matrix<Rational>& exact) -> std::optional<Matrix<Scalar>> {
        if (exact != identity<Rational>())
            result.needed.add(stage);
        else if (!scene.keep.has(stage) || result.begins_in_clip_space)
            return std::nullopt;
        return rounded<Scalar>(exact);
    };
    for (const SceneObject& object : scene.objects)
        result.models.push_back(matrix_of(Stage::model, object.model.matrix()));
    result.rest_model = matrix_of(Stage::model, identity<Rational>());
    result.view = matrix_of(
        Stage::view, scene.camera ? view_matrix(*scene.camera, view_axis_of(scene.projection.type))
                                  : identity<Rational>());
    if (scene.projection.type != ProjectionType::none && !result.begins_in_clip_space)
        result.projection = rounded<Scalar>(product_of(factors_of(scene.projection, scene.canvas)));
    if (scene.viewport.type != ViewportType::none)
        result.viewport = rounded<Scalar>(product_of(factors_of(scene.viewport, scene.canvas)));
    result.moves_depths = scene.viewport.depths.has_value();

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
                                 nearest(plane.constant),
                                 plane.is_open});
    // Floats and doubles begin at the least w that 1 can be divided by.
    if constexpr (std::floating_point<Scalar>)
        for (ClipPlane<Scalar>& plane : result.planes)
            if (std::exchange(plane.is_open, false))
                plane.constant = -std::numeric_limits<Scalar>::min();
    result.snap = scene.method.snap;
    result.ties = scene.method.ties.value_or(Ties::up);
    return result;
}

std::vector<bool> used_vertices(const Scene& scene) {
    std::vector<bool> is_used(scene.vertices.size());
    for (const ScenePrimitive& primitive : scene.primitives)
        for (const std::size_t index : primitive.corners())
            is_used[index] = true;
    return is_used;
}

/// The eye in the world: the camera's position, or the origin without a camera. In a parallel view:
/// the direction to the eye, which is the same for all faces.
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

/// A geometry whose vertices have not been moved yet. Members that outlive the others are allocated
/// first, so that the others leave no gap behind.
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

/// Takes a vertex to clip space.
template <typename Scalar>
void move_to_clip_space(const Scene& scene, std::size_t index, Geometry<Scalar>& geometry) {
    auto [world, in_clip_space] = vertex_in_space(scene, geometry.list.transforms, index);
    geometry.vertices[index] = std::move(in_clip_space);
    if (!geometry.world.empty())
        geometry.world[index] = std::move(world);
}

/// Takes a vertex from clip space on to the screen, if it is in view.
template <typename Scalar> void move_to_screen(std::size_t index, Geometry<Scalar>& geometry) {
    const ClipSpaceVertex<Scalar>& vertex = geometry.vertices[index];
    ScreenList<Scalar>& list = geometry.list;
    if (vertex.is_in_view)
        list.vertices[index].position = positions_on_screen(vertex.clip, list.transforms).pixel;
}

template <typename Scalar>
void move_vertex(const Scene& scene, std::size_t index, Geometry<Scalar>& geometry) {
    move_to_clip_space(scene, index, geometry);
    move_to_screen(index, geometry);
}

/// Counts the vertices outside of each plane, and drops the planes that no vertex lies outside of:
/// they cut nothing.
template <typename Scalar> void find_planes(const Scene& scene, Geometry<Scalar>& geometry) {
    std::vector<ClipPlane<Scalar>> kept;
    for (const ClipPlane<Scalar>& plane : geometry.list.transforms.planes) {
        std::size_t outside = 0;
        for (std::size_t i = 0; i < geometry.vertices.size(); ++i)
            if (!geometry.vertices[i].is_in_view && geometry.is_used[i] &&
                !plane.has_inside(geometry.vertices[i].clip))
                ++outside;
        geometry.list.outside.push_back({plane.name, outside});
        if (outside > 0 || scene.keep.has(Stage::clip))
            kept.push_back(plane);
    }
    geometry.list.transforms.planes = std::move(kept);
}

/// Sorts the faces for the painter, unless the farthest come first already.
template <typename Scalar> void find_order(const Scene& scene, Geometry<Scalar>& geometry) {
    const auto keys = keys_of_faces<Scalar>(scene, [&geometry](std::size_t index) -> const Scalar& {
        return geometry.vertices[index].distance;
    });
    StageSet& needed = geometry.list.transforms.needed;
    if (!std::is_sorted(keys.begin(), keys.end(),
                        [](const Scalar& a, const Scalar& b) { return b < a; }))
        needed.add(Stage::order);
    if (needed.has(Stage::order) || scene.keep.has(Stage::order))
        geometry.list.order = sorted_by_distance(scene, keys);
}

template <typename Scalar> Geometry<Scalar> geometry_of(const Scene& scene) {
    Geometry<Scalar> result = empty_geometry<Scalar>(scene);
    result.is_used = used_vertices(scene);
    Transforms<Scalar>& transforms = result.list.transforms;
    const bool needs_signs =
        scene.depth() == Depth::inverse_z && !is_perspective(scene.projection.type);

    // To clip space.
    for (std::size_t i = 0; i < result.vertices.size(); ++i) {
        if (!result.is_used[i])
            continue;
        move_to_clip_space(scene, i, result);
        const ClipSpaceVertex<Scalar>& vertex = result.vertices[i];
        if (vertex.clip.w != scalar_from<Scalar>(1))
            transforms.needed.add(Stage::divide);
        // Behind the eye there is no 1/z (plan.cpp refuses it): an interval must decide the
        // sign.
        if (needs_signs)
            static_cast<void>(vertex.distance < scalar_from<Scalar>(0));
    }
    find_planes(scene, result);
    transforms.divides = transforms.needed.has(Stage::divide) || scene.keep.has(Stage::divide);

    // On to the screen.
    for (std::size_t i = 0; i < result.vertices.size(); ++i)
        move_to_screen(i, result);
    if (scene.depth() == Depth::painter)
        find_order(scene, result);
    return result;
}

#define INSTANTIATE(Coordinate) template Geometry<Coordinate> geometry_of(const Scene&);
RASTERTRACE_FOR_EACH_COORDINATE(INSTANTIATE)

template Geometry<Rational> empty_geometry(const Scene&);
template void move_vertex(const Scene&, std::size_t, Geometry<Rational>&);

} // namespace rastertrace
