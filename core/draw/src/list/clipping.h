// SPDX-License-Identifier: MIT
#pragma once

// Clips what is drawn at the planes of the view, and tells it.

#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/clip.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// The color of a vertex of the scene, or of its primitive if it has none that counts.
template <typename AList>
Color color_of_vertex(const Scene& scene, const AList& list, std::size_t index, Color color) {
    return list.mixes_colors ? scene.vertices[index].color.value_or(color) : color;
}

/// Why clipping at a plane has left nothing of a polygon.
template <typename Scalar>
SkipReason reason_of(const ClipPlane<Scalar>& plane,
                     const std::vector<ClipVertex<Scalar>>& polygon) {
    if (plane.name == "far")
        return SkipReason::too_far;
    if (plane.name != "near")
        return SkipReason::outside_view;
    // An orthographic view has no eye to be behind of.
    if (plane.factors.z != scalar_from<Scalar>(0))
        return SkipReason::too_near;
    // The near plane's value is the distance from the eye, less the near distance.
    const bool is_behind_eye =
        std::all_of(polygon.begin(), polygon.end(), [&plane](const ClipVertex<Scalar>& vertex) {
            return !(plane.constant < plane.value_at(vertex.position));
        });
    return is_behind_eye ? SkipReason::behind_eye : SkipReason::too_near;
}

/// Cuts a polygon, a line or a point down to what lies inside all planes; each plane that it is not
/// wholly inside of is told. If nothing is left: why. Only a vertex that it begins with makes a
/// plane cut: one that clipping has made lies, but for rounding, between two of those.
template <typename Scalar>
std::optional<SkipReason> clip_at_planes(std::string_view name,
                                         std::vector<ClipVertex<Scalar>>& polygon,
                                         const std::vector<ClipPlane<Scalar>>& planes,
                                         ColorRounding color_rounding, const Listener& listener) {
    const std::size_t fewest = std::min<std::size_t>(polygon.size(), 3);
    const std::vector<ClipVertex<Scalar>> whole = polygon;
    for (const ClipPlane<Scalar>& plane : planes) {
        if (std::all_of(whole.begin(), whole.end(), [&plane](const ClipVertex<Scalar>& vertex) {
                return plane.has_inside(vertex.position);
            }))
            continue;

        // A triangle has 3 vertices, and each of the planes may add one to it.
        std::array<bool, 16> is_inside{};
        const std::size_t count = polygon.size();
        for (std::size_t i = 0; i < count; ++i)
            is_inside[i] = plane.has_inside(polygon[i].position);
        if (std::all_of(is_inside.begin(), is_inside.begin() + static_cast<std::ptrdiff_t>(count),
                        [](bool inside) { return inside; }))
            continue;

        std::vector<ClipVertex<Scalar>> left = clip(polygon, plane, color_rounding);
        if (left.size() < fewest)
            left.clear();
        listener(PrimitiveClipped{.name = name,
                                  .plane = plane.name,
                                  .is_inside = std::span(is_inside).first(count),
                                  .left = static_cast<int>(left.size())});
        const SkipReason reason = reason_of(plane, polygon);
        polygon = std::move(left);
        if (polygon.empty())
            return reason;
    }
    return std::nullopt;
}

/// Clips a primitive whose corners lie in clip space; the sides of an outline one by one. Calls
/// `take(side, polygon)` with what is left of each: the first corner of what was clipped, and a point, a
/// line or a polygon, whose vertices know which of the corners they are. If nothing is left: why.
template <typename Scalar, typename Take>
std::optional<SkipReason> clip_primitive(const Scene& scene, const ScreenList<Scalar>& list,
                                         std::size_t index, Color color,
                                         const std::array<ClipSpaceVertex<Scalar>, 3>& vertices,
                                         const Listener& listener, Take&& take) {
    const ScenePrimitive& primitive = scene.primitives[index];
    const std::size_t count = primitive.corners().size();
    const bool is_outline = primitive.kind == PrimitiveKind::outline;
    std::optional<SkipReason> reason;
    bool is_left = false;
    for (std::size_t side = 0; side < (is_outline ? count : 1); ++side) {
        std::vector<ClipVertex<Scalar>> polygon;
        for (std::size_t i = 0; i < (is_outline ? 2 : count); ++i) {
            const std::size_t corner = (side + i) % count;
            const auto& [clip, distance, is_in_view] = vertices[corner];
            polygon.push_back({clip, distance,
                               color_of_vertex(scene, list, primitive.vertices[corner], color),
                               static_cast<int>(corner)});
        }
        reason = clip_at_planes(primitive.name, polygon, list.transforms.planes,
                                scene.method.color_rounding, listener);
        is_left = is_left || !polygon.empty();
        take(side, polygon);
    }
    return is_left ? std::nullopt : reason;
}

} // namespace rastertrace
