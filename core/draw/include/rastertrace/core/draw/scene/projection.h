// SPDX-License-Identifier: MIT
#pragma once

// The projection of a scene: projection.h of transform/ in exact numbers, and the planes that bound what it
// shows.

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/clip.h>
#include <rastertrace/core/transform/camera.h>
#include <rastertrace/core/transform/matrix.h>

#include <optional>
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

/// What a projection is a product of: two matrices of a view plane and of an orthographic one; the others are
/// one matrix. The canvas gives the frustum of a field of view its width.
std::vector<MatrixFactor<Rational>> factors_of(const Projection& projection, const Canvas& canvas);

/// The product of the factors.
Matrix<Rational> projection_matrix(const Projection& projection, const Canvas& canvas);

/// The planes of a projection. Near and far are distances from the eye, which in a perspective
/// are a multiple of w, and so are told by w, without z's rounding. The four sides stand
/// `guard` x (half the canvas) away from the middle: what lies nearer is left to the fill, which
/// drops it pixel by pixel; what lies beyond would be too far out for it.
std::vector<ClipPlane<Rational>> clip_planes(const Projection& projection,
                                             const Rational& half_width,
                                             const Rational& half_height, const Rational& guard);

} // namespace rastertrace
