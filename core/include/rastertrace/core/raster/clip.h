// SPDX-License-Identifier: MIT
#pragma once

// Clipping in homogeneous coordinates, before the division by w: what lies behind the eye is cut
// off. After the division it would appear mirrored in front of the eye.
//
// Source: Sutherland and Hodgman 1974, one plane after the other; Blinn and Newell 1978 for doing
// so before the division.
//
//     clip(polygon, plane);  // the part on the plane's inner side

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/mixed_colors.h>

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

/// A plane of the view volume. A point in clip space lies inside, or on the plane, if
/// a x + b y + c z + d w + e >= 0; inside an open one only if that is above 0. An open one cuts half way
/// between the plane and the nearest corner inside.
template <typename Scalar> struct ClipPlane {
    std::string_view name; ///< near, far, left, right, bottom, top, w
    Vec<Scalar, 4> factors;
    Scalar constant;
    bool is_open = false;

    Scalar value_at(const Vec<Scalar, 4>& p) const {
        return factors.x * p.x + factors.y * p.y + factors.z * p.z + factors.w * p.w + constant;
    }

    /// True if the point lies inside the plane, or on one that is not open.
    bool has_inside(const Vec<Scalar, 4>& p) const {
        const Scalar value = value_at(p);
        const Scalar zero = scalar_from<Scalar>(0);
        return is_open ? zero < value : !(value < zero);
    }
};

/// A corner of a polygon in clip space.
template <typename Scalar> struct ClipVertex {
    Vec<Scalar, 4> position;
    Scalar distance; ///< from the eye along the view
    Levels<Scalar> color;
    int original = -1; ///< its index among the primitive's own vertices; -1 if clipping made it
};

/// The intersection of the plane with the edge from a vertex inside to one outside. It is always
/// computed in this direction: two triangles that share the edge get the same point.
template <typename Scalar>
ClipVertex<Scalar> meeting_point(const ClipVertex<Scalar>& inside,
                                 const ClipVertex<Scalar>& outside,
                                 const ClipPlane<Scalar>& plane) {
    // From the end nearer to the plane: from the other one, the difference would be rounded to the
    // size of a far coordinate, and a w just above 0 could come out as 0 or below.
    const Scalar value_inside = plane.value_at(inside.position);
    const Scalar value_outside = -plane.value_at(outside.position);
    const Scalar sum = value_inside + value_outside;
    const bool is_from_inside = !(value_outside < value_inside);
    const Scalar way = (is_from_inside ? value_inside : value_outside) / sum;
    const auto between = [&way, is_from_inside](const Scalar& a, const Scalar& b) {
        return is_from_inside ? Scalar(a + way * (b - a)) : Scalar(b + way * (a - b));
    };
    Levels<Scalar> color;
    for (std::size_t i = 0; i < color.of.size(); ++i)
        color.of[i] = between(inside.color.of[i], outside.color.of[i]);
    const auto& p = inside.position;
    const auto& q = outside.position;
    // On a plane that w alone decides, near or far in a perspective, w and the distance are known.
    const Scalar zero = scalar_from<Scalar>(0);
    const auto& f = plane.factors;
    const bool is_plane_of_w = f.x == zero && f.y == zero && f.z == zero;
    const Scalar plane_distance =
        plane.constant < zero ? Scalar(-plane.constant) : Scalar(plane.constant);
    return {.position = {between(p.x, q.x), between(p.y, q.y), between(p.z, q.z),
                         is_plane_of_w ? Scalar(-plane.constant / f.w) : between(p.w, q.w)},
            .distance = is_plane_of_w ? plane_distance : between(inside.distance, outside.distance),
            .color = std::move(color),
            .original = -1};
}

/// The part of a polygon on the inner side of a plane, the plane included; of a line, if it has two
/// vertices; of a point, if it has one. Empty if all of it lies outside. Several parts of a concave
/// polygon stay joined by sides along the plane, between which a fill finds nothing.
template <typename Scalar>
std::vector<ClipVertex<Scalar>> clip(const std::vector<ClipVertex<Scalar>>& polygon,
                                     ClipPlane<Scalar> plane) {
    const Scalar zero = scalar_from<Scalar>(0);
    if (plane.is_open) {
        std::optional<Scalar> nearest;
        for (const ClipVertex<Scalar>& vertex : polygon)
            if (const Scalar value = plane.value_at(vertex.position);
                zero < value && !(nearest && *nearest < value))
                nearest = value;
        if (!nearest)
            return {};
        plane.constant = plane.constant - *nearest / scalar_from<Scalar>(2);
    }

    // A vertex on the plane is kept, and is itself the point where a side leaves.
    const auto side_of = [&plane, &zero](const ClipVertex<Scalar>& vertex) {
        const Scalar value = plane.value_at(vertex.position);
        return value < zero ? -1 : zero < value ? 1 : 0;
    };
    const bool is_closed = polygon.size() > 2;
    std::vector<ClipVertex<Scalar>> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ClipVertex<Scalar>& vertex = polygon[i];
        const int side = side_of(vertex);
        if (side >= 0)
            left.push_back(vertex);

        // The point where the way to the next vertex crosses the plane, if it does.
        if (!is_closed && i + 1 == polygon.size())
            break;
        const ClipVertex<Scalar>& next = polygon[(i + 1) % polygon.size()];
        if (side * side_of(next) < 0)
            left.push_back(side > 0 ? meeting_point(vertex, next, plane)
                                    : meeting_point(next, vertex, plane));
    }
    return left;
}

} // namespace rastertrace
