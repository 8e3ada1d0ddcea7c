// SPDX-License-Identifier: MIT
#pragma once

// The spaces of a vertex, from object space to the screen, and the steps that tell them.

#include "tell/listener_sink.h"

#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/core/transform/matrix.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace rastertrace {

/// False for an infinity and for what is no number: only floats and doubles have those.
template <typename Scalar> bool is_finite(const Scalar& number) {
    if constexpr (std::floating_point<Scalar>)
        return std::isfinite(number);
    else
        return true;
}
template <typename Scalar> bool all_finite(const Vec<Scalar, 3>& v) {
    return is_finite(v.x) && is_finite(v.y) && is_finite(v.z);
}
template <typename Scalar> bool all_finite(const Matrix<Scalar>& matrix) {
    return std::all_of(matrix.rows.begin(), matrix.rows.end(), [](const auto& row) {
        return std::all_of(row.begin(), row.end(), [](const Scalar& x) { return is_finite(x); });
    });
}

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
                        scalar_from<Scalar>(vertex.z), scalar_from<Scalar>(vertex.w)};
    positions.world = moved(model, positions.object);
    positions.camera = moved(transforms.view, positions.world);
    positions.clip = moved(transforms.projection, positions.camera);
    return positions;
}

/// A vertex in clip space is in view if it lies outside of no plane.
template <typename Scalar>
bool is_in_view(const Vec<Scalar, 4>& clip, const Transforms<Scalar>& transforms) {
    return std::all_of(transforms.planes.begin(), transforms.planes.end(),
                       [&clip](const auto& plane) { return plane.has_inside(clip); });
}

/// The last spaces of a vertex. `pixel` is where it is drawn: the position on the screen, snapped
/// if the method snaps vertices.
template <typename Scalar> struct ScreenPositions {
    Vec<Scalar, 4> canonical;
    Vec<Scalar, 2> screen;
    Vec<Scalar, 2> pixel;
};

/// A coordinate on the screen as Transforms::snap has it.
template <typename Scalar> Scalar snapped(const Scalar& x, const Transforms<Scalar>& transforms) {
    if constexpr (std::floating_point<Scalar>)
        if (!std::isfinite(x))
            return x; // find_unfit refuses it
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
    require_finite(canonical.z);
    return {
        .canonical = canonical,
        .screen = {screen.x, screen.y},
        .pixel = {snapped<Scalar>(screen.x, transforms), snapped<Scalar>(screen.y, transforms)}};
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

/// How far a position in camera space lies in front of the eye. Without a camera and a projection,
/// z as typed is the distance; in clip space, w is.
template <typename Scalar>
Scalar distance_along_view(const Scene& scene, const Vec<Scalar, 4>& camera) {
    if (scene.projection.type == ProjectionType::clip_space)
        return camera.w;
    const bool looks_along_plus_z =
        scene.projection.type == ProjectionType::pinhole ||
        (scene.projection.type == ProjectionType::none && !scene.camera);
    return looks_along_plus_z ? camera.z : Scalar(-camera.z);
}

/// A vertex in the world and in clip space.
template <typename Scalar> struct VertexInSpace {
    Vec<Scalar, 3> world;
    ClipSpaceVertex<Scalar> in_clip_space;
};

template <typename Scalar>
VertexInSpace<Scalar> vertex_in_space(const Scene& scene, const Transforms<Scalar>& transforms,
                                      std::size_t index) {
    const VertexPositions<Scalar> positions =
        positions_of(scene.vertices[index], model_of(scene, transforms, index), transforms);
    for (const Scalar* coordinate :
         {&positions.clip.x, &positions.clip.y, &positions.clip.z, &positions.clip.w})
        require_finite(*coordinate);
    return {.world = {positions.world.x, positions.world.y, positions.world.z},
            .in_clip_space = {.clip = positions.clip,
                              .distance = distance_along_view<Scalar>(scene, positions.camera),
                              .is_in_view = is_in_view(positions.clip, transforms)}};
}

/// Tells the position of a vertex in one space: the first `count` coordinates.
template <typename Scalar>
void tell_position(std::string_view name, Space space, const Vec<Scalar, 4>& at, std::size_t count,
                   const Listener& listener) {
    const std::array<Scalar, 4> coordinates{at.x, at.y, at.z, at.w};
    ListenerSink{listener}(VertexPlaced<Scalar>{
        .name = name, .space = space, .at = std::span(coordinates).first(count)});
}

/// Tells the spaces of a vertex after clip space.
template <typename Scalar>
void tell_positions_on_screen(std::string_view name, const Vec<Scalar, 4>& clip,
                              const Transforms<Scalar>& transforms, const Listener& listener) {
    const ScreenPositions<Scalar> positions = positions_on_screen(clip, transforms);
    if ((transforms.projection || transforms.begins_in_clip_space) && transforms.divides)
        tell_position<Scalar>(name, Space::canonical, positions.canonical, 3, listener);
    const std::array<Scalar, 2> screen{positions.screen.x, positions.screen.y};
    const std::array<Scalar, 2> pixel{positions.pixel.x, positions.pixel.y};
    ListenerSink{listener}(VertexPlaced<Scalar>{
        .name = name,
        .space = Space::screen,
        .at = screen,
        .snapped = transforms.snap == Snap::none ? std::nullopt : if_any(pixel)});
}

// Compiled in tell_geometry.cpp; for others only for Rational.

/// Tells a matrix, the factors that it is a product of, and the camera of a view. Factors and
/// camera are left out if one of their numbers is infinite.
template <typename Scalar>
void tell_matrix(std::string_view name, std::string_view object,
                 const std::optional<Matrix<Scalar>>& matrix,
                 const MatrixFactors<Rational>& exact_factors, const Camera* camera,
                 const Listener& listener);

/// Tells the painter's order.
template <typename Scalar>
void tell_order(const Scene& scene, const PainterOrder<Scalar>& order, const Listener& listener);

} // namespace rastertrace
