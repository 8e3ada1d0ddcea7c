// SPDX-License-Identifier: MIT
#pragma once

// Clips primitives at the planes of the view.

#include "list/faces.h"

#include <rastertrace/core/raster/clip.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The color of a vertex of the scene; that of its primitive if colors are not mixed or it has
/// none.
inline Color color_of_vertex(const Scene& scene, bool mixes_colors, std::size_t index,
                             Color color) {
    return mixes_colors ? scene.vertices[index].color.value_or(color) : color;
}

/// The color of a primitive.
template <typename Coordinate>
Color color_of(const Scene& scene, std::size_t primitive, const Face<Coordinate>& face) {
    if (scene.method.shade == Shade::faces)
        return color_of_face(primitive);
    return face.lit ? face.lit->color : scene.primitives[primitive].color;
}

/// A primitive before it is clipped.
template <typename Scalar> struct UnclippedPrimitive {
    std::size_t index;      ///< in the scene
    bool is_in_view = true; ///< all of its vertices are
    Face<Scalar> face = {};
    Color color = {};
};

/// A primitive with its face tested and lit. `world_of(i)` and `in_clip_space(i)` yield its vertex
/// number i in two spaces.
template <typename Scalar, typename WorldOf, typename InClipSpace>
UnclippedPrimitive<Scalar> unclipped(const Scene& scene, const ScreenList<Scalar>& list,
                                     std::size_t index, WorldOf&& world_of,
                                     InClipSpace&& in_clip_space) {
    UnclippedPrimitive<Scalar> result{.index = index};
    const ScenePrimitive& primitive = scene.primitives[index];
    const std::size_t count = primitive.corners().size();
    std::vector<Vec<Scalar, 3>> world;
    for (std::size_t i = 0; i < count; ++i)
        result.is_in_view = result.is_in_view && in_clip_space(i).is_in_view;
    if (has_face(scene, primitive)) {
        world.reserve(count);
        for (std::size_t i = 0; i < count; ++i)
            world.push_back(world_of(i));
    }
    result.face = face_in<Scalar>(scene, list, index, world);
    result.color = color_of(scene, index, result.face);
    return result;
}

/// Why nothing of a polygon is left behind a plane.
template <typename Scalar>
SkipReason reason_of(const ClipPlane<Scalar>& plane,
                     const std::vector<ClipVertex<Scalar>>& polygon) {
    // Of clip space, either plane drops what lies behind the eye. An orthographic view has w = 1.
    const Scalar zero = scalar_from<Scalar>(0);
    const bool bounds_z = plane.factors.z != zero;
    if (plane.name == "w" || (bounds_z && std::all_of(polygon.begin(), polygon.end(),
                                                      [&zero](const ClipVertex<Scalar>& vertex) {
                                                          return !(zero < vertex.position.w);
                                                      })))
        return SkipReason::behind_eye;
    if (plane.name == "far")
        return SkipReason::too_far;
    if (plane.name != "near")
        return SkipReason::outside_view;
    // An orthographic view has no eye.
    if (bounds_z)
        return SkipReason::too_near;
    // The near plane's value is the distance from the eye, less the near distance.
    const bool is_behind_eye =
        std::all_of(polygon.begin(), polygon.end(), [&plane](const ClipVertex<Scalar>& vertex) {
            return !(plane.constant < plane.value_at(vertex.position));
        });
    return is_behind_eye ? SkipReason::behind_eye : SkipReason::too_near;
}

/// Cuts a polygon, a line or a point down to what lies inside all planes, and tells each plane that
/// cuts it. Returns the reason if nothing is left. Only an original vertex outside of a plane makes
/// it cut: a vertex that clipping has made lies between two of those, but for rounding.
template <typename Scalar>
std::optional<SkipReason>
clip_at_planes(std::string_view name, std::vector<ClipVertex<Scalar>>& polygon,
               const std::vector<ClipPlane<Scalar>>& planes, const Listener& listener) {
    const std::size_t fewest = std::min<std::size_t>(polygon.size(), 3);
    const std::vector<ClipVertex<Scalar>> whole = polygon;
    for (const ClipPlane<Scalar>& plane : planes) {
        if (std::all_of(whole.begin(), whole.end(), [&plane](const ClipVertex<Scalar>& vertex) {
                return plane.has_inside(vertex.position);
            }))
            continue;

        const std::size_t count = polygon.size();
        const auto is_inside = std::make_unique<bool[]>(count);
        for (std::size_t i = 0; i < count; ++i)
            is_inside[i] = plane.has_inside(polygon[i].position);
        if (std::all_of(is_inside.get(), is_inside.get() + count,
                        [](bool inside) { return inside; }))
            continue;

        std::vector<ClipVertex<Scalar>> left = clip(polygon, plane);
        if (left.size() < fewest)
            left.clear();
        listener(PrimitiveClipped<>{.name = name,
                                    .plane = plane.name,
                                    .inside = {is_inside.get(), count},
                                    .out = static_cast<Index>(left.size())});
        const SkipReason reason = reason_of(plane, polygon);
        polygon = std::move(left);
        if (polygon.empty())
            return reason;
    }
    return std::nullopt;
}

/// Clips a primitive, or the sides of an outline one by one. `in_clip_space(i)` yields its vertex
/// number i. Calls `take(side, polygon)` with what is left of each: the index of the first corner,
/// and a point, a line or a polygon. Returns the reason if nothing is left of all.
template <typename Scalar, typename InClipSpace, typename Take>
std::optional<SkipReason> clip_primitive(const Scene& scene, const ScreenList<Scalar>& list,
                                         const UnclippedPrimitive<Scalar>& unclipped,
                                         InClipSpace&& in_clip_space, const Listener& listener,
                                         Take&& take) {
    const ScenePrimitive& primitive = scene.primitives[unclipped.index];
    const auto corners = primitive.corners();
    const std::size_t count = corners.size();
    const bool is_outline = primitive.kind == PrimitiveKind::outline;
    std::optional<SkipReason> reason;
    bool is_left = false;
    for (std::size_t side = 0; side < (is_outline ? count : 1); ++side) {
        std::vector<ClipVertex<Scalar>> polygon;
        for (std::size_t i = 0; i < (is_outline ? 2 : count); ++i) {
            const std::size_t corner = (side + i) % count;
            const ClipSpaceVertex<Scalar>& vertex = in_clip_space(corner);
            polygon.push_back(
                {vertex.clip, vertex.distance,
                 color_of_vertex(scene, list.mixes_colors, corners[corner], unclipped.color),
                 static_cast<int>(corner)});
        }
        reason = clip_at_planes(primitive.name, polygon, list.transforms.planes, listener);
        is_left = is_left || !polygon.empty();
        take(side, polygon);
    }
    return is_left ? std::nullopt : reason;
}

} // namespace rastertrace
