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
bool is_rounded(const Projection& projection);

/// The nearest distance from the eye that is shown; nothing if everything is.
std::optional<Rational> near_of(const Projection& projection);

std::optional<Rational> far_of(const Projection& projection);

/// What a projection is a product of: T4's Mp Mt of a view plane, scale and translation of an
/// orthographic one; the others are one matrix. The canvas gives the frustum of a field of view its
/// width.
std::vector<MatrixFactor<Rational>> factors_of(const Projection& projection, const Canvas& canvas);

/// The product of the factors.
Matrix<Rational> projection_matrix(const Projection& projection, const Canvas& canvas);

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
std::vector<ClipPlane<Rational>> clip_planes(const Projection& projection,
                                             const Rational& half_width,
                                             const Rational& half_height, const Rational& guard);

} // namespace rastertrace
