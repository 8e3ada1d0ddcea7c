// SPDX-License-Identifier: MIT
#pragma once

// From camera space to clip space, by a matrix; division by w then leads to canonical space, where
// x and y of what can be seen lie in -1..1 (or are lengths on the view plane, for the textbooks'
// projections).
//
//     type           looks along   w         x/w                  z/w
//     orthographic   -z            1         left..right -> -1..1 near..far -> -1..1
//     pinhole        +z            z         x d/z                1 - d/z, larger is farther
//     view-plane     -z            -z/d      -x d/z               -d - d^2/z, larger is nearer
//     frustum        -z            -z        left..right -> -1..1 near..far -> -1..1
//
// Sources: pinhole, T0; view-plane, T4 (Mpt = Mp Mt); orthographic and frustum, glm::ortho,
// glm::frustum and glm::perspective for right-handed space and z from -1 to 1.

#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/transform/camera.h>
#include <rastertrace/core/transform/matrix.h>

#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

enum class ProjectionType { none, orthographic, pinhole, view_plane, frustum };

/// How the camera's space is projected. What a type does not use is not read.
struct Projection {
    ProjectionType type = ProjectionType::none;
    Number distance = 1;              ///< pinhole, view-plane: from the eye to the view plane
    std::optional<Number> fov_y = {}; ///< frustum: the vertical field of view in degrees, or
    Number left = -1;                 ///< these, at the distance `near`
    Number right = 1;
    Number bottom = -1;
    Number top = 1;
    std::optional<Number> near = {}; ///< orthographic: none clips nothing
    std::optional<Number> far = {};  ///< none is infinitely far
};

/// A pinhole or a view plane without `near` shows nothing nearer to the eye than this part of the
/// view plane's distance: what lies at the eye itself has no place on the plane.
inline constexpr int near_part_of_distance = 1000;

inline bool is_perspective(ProjectionType type) {
    return type == ProjectionType::pinhole || type == ProjectionType::view_plane ||
           type == ProjectionType::frustum;
}

inline ViewAxis view_axis_of(ProjectionType type) {
    return type == ProjectionType::pinhole ? ViewAxis::plus_z : ViewAxis::minus_z;
}

/// True if the matrix is not exact.
inline bool is_rounded(const Projection& projection) {
    return projection.type == ProjectionType::frustum && projection.fov_y &&
           projection.fov_y->exact() != 90;
}

/// The nearest distance from the eye that is shown; nothing if everything is.
inline std::optional<Rational> near_of(const Projection& projection) {
    if (projection.near)
        return projection.near->exact();
    if (projection.type == ProjectionType::pinhole || projection.type == ProjectionType::view_plane)
        return Rational(projection.distance.exact() / near_part_of_distance);
    return std::nullopt;
}

inline std::optional<Rational> far_of(const Projection& projection) {
    return projection.far ? std::optional(projection.far->exact()) : std::nullopt;
}

/// Rows in maths order. The canvas gives the frustum of a field of view its width.
inline Matrix<Rational> projection_matrix(const Projection& projection, const Canvas& canvas) {
    const Rational d = projection.distance.exact();
    const Rational left = projection.left.exact();
    const Rational right = projection.right.exact();
    const Rational bottom = projection.bottom.exact();
    const Rational top = projection.top.exact();
    const auto near = near_of(projection);
    const auto far = far_of(projection);
    switch (projection.type) {
    case ProjectionType::orthographic: {
        const Rational z_scale = near && far ? Rational(-2 / (*far - *near)) : Rational(-1);
        const Rational z_shift =
            near && far ? Rational(-(*far + *near) / (*far - *near)) : Rational(0);
        return {{{{2 / (right - left), 0, 0, -(right + left) / (right - left)},
                  {0, 2 / (top - bottom), 0, -(top + bottom) / (top - bottom)},
                  {0, 0, z_scale, z_shift},
                  {0, 0, 0, 1}}}};
    }
    case ProjectionType::pinhole:
        return {{{{d, 0, 0, 0}, {0, d, 0, 0}, {0, 0, 1, -d}, {0, 0, 1, 0}}}};
    case ProjectionType::view_plane:
        return {{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, d}, {0, 0, -1 / d, 0}}}};
    case ProjectionType::frustum: {
        // Infinitely far is the limit of the finite formulas.
        const Rational z_scale = far ? Rational(-(*far + *near) / (*far - *near)) : Rational(-1);
        const Rational z_shift =
            far ? Rational(-2 * *far * *near / (*far - *near)) : Rational(-2 * *near);
        if (projection.fov_y) {
            const Rational scale = cotangent_of_degrees(projection.fov_y->exact() / 2);
            return {{{{scale * canvas.height / canvas.width, 0, 0, 0},
                      {0, scale, 0, 0},
                      {0, 0, z_scale, z_shift},
                      {0, 0, -1, 0}}}};
        }
        return {{{{2 * *near / (right - left), 0, (right + left) / (right - left), 0},
                  {0, 2 * *near / (top - bottom), (top + bottom) / (top - bottom), 0},
                  {0, 0, z_scale, z_shift},
                  {0, 0, -1, 0}}}};
    }
    case ProjectionType::none:
        break;
    }
    return identity<Rational>();
}

/// A side of the space that can be seen. A point in clip space lies on the side that is seen, or on
/// the plane, if a x + b y + c z + d w + e is not negative.
template <typename Scalar> struct ClipPlane {
    std::string_view name; ///< near, far, left, right, bottom, top
    Vec<Scalar, 4> factors;
    Scalar constant;

    Scalar value_at(const Vec<Scalar, 4>& p) const {
        return factors.x * p.x + factors.y * p.y + factors.z * p.z + factors.w * p.w + constant;
    }

    /// True if the point can be seen as far as this plane goes.
    bool has_inside(const Vec<Scalar, 4>& p) const {
        return !(value_at(p) < scalar_from<Scalar>(0));
    }
};

/// The planes of a projection. Near and far are distances from the eye, which in a perspective
/// are a multiple of w, and so are told by w, without z's rounding. The four sides stand
/// `guard` x (half the canvas) away from the middle: what lies nearer is left to the fill, which
/// drops it pixel by pixel; what lies beyond would be too far out for it.
inline std::vector<ClipPlane<Rational>> clip_planes(const Projection& projection,
                                                    const Rational& half_width,
                                                    const Rational& half_height,
                                                    const Rational& guard) {
    std::vector<ClipPlane<Rational>> planes;
    if (is_perspective(projection.type)) {
        const Rational distance_of_w =
            projection.type == ProjectionType::view_plane ? projection.distance.exact() : 1;
        planes.push_back({"near", {0, 0, 0, distance_of_w}, -*near_of(projection)});
        if (const auto far = far_of(projection))
            planes.push_back({"far", {0, 0, 0, -distance_of_w}, *far});
    } else if (projection.type == ProjectionType::orthographic && projection.near &&
               projection.far) {
        planes.push_back({"near", {0, 0, 1, 0}, 1});
        planes.push_back({"far", {0, 0, -1, 0}, 1});
    }
    if (projection.type != ProjectionType::none) {
        planes.push_back({"left", {1, 0, 0, guard * half_width}, 0});
        planes.push_back({"right", {-1, 0, 0, guard * half_width}, 0});
        planes.push_back({"bottom", {0, 1, 0, guard * half_height}, 0});
        planes.push_back({"top", {0, -1, 0, guard * half_height}, 0});
    }
    return planes;
}

} // namespace rastertrace
