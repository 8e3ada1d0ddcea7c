// SPDX-License-Identifier: MIT
#pragma once

// From world space to camera space: the eye at the origin, x to its right, y up, and the view along
// -z (along +z for the pinhole of T0, whose frame is left-handed).
//
//     view_matrix({.position = {0, 0, 4}}, ViewAxis::minus_z);  // moves the world by (0, 0, -4)
//
// Source: the look-at matrix of every text, here with T4's two slips put right: the translation is
// by -position and comes first, and z points from what is looked at to the eye.

#include <rastertrace/core/transform/matrix.h>
#include <rastertrace/core/transform/transform.h>

namespace rastertrace {

/// Where the eye is and where it looks.
struct Camera {
    Numbers3 position{0, 0, 0};
    Numbers3 look_at{0, 0, -1};
    Numbers3 up{0, 1, 0}; ///< any direction that is not the view's
};

/// Where the camera looks in its own space.
enum class ViewAxis { minus_z, plus_z };

/// The directions to the right and upward, and backward against the view, of any length.
struct CameraAxes {
    Vec<Rational, 3> right;
    Vec<Rational, 3> up;
    Vec<Rational, 3> back;
};

inline CameraAxes axes_of(const Camera& camera) {
    const auto back = exact(camera.position) - exact(camera.look_at);
    const auto right = cross(exact(camera.up), back);
    return {right, cross(back, right), back};
}

inline bool is_zero(const Vec<Rational, 3>& vector) {
    return vector.x == 0 && vector.y == 0 && vector.z == 0;
}

/// What is wrong with a camera.
enum class CameraFault { none, looks_at_itself, up_along_view };

inline CameraFault fault_of(const Camera& camera) {
    const CameraAxes axes = axes_of(camera);
    return is_zero(axes.back)    ? CameraFault::looks_at_itself
           : is_zero(axes.right) ? CameraFault::up_along_view
                                 : CameraFault::none;
}

/// True if the matrix of this camera is not exact.
inline bool is_rounded(const Camera& camera) {
    const CameraAxes axes = axes_of(camera);
    return has_irrational_length(axes.right) || has_irrational_length(axes.up) ||
           has_irrational_length(axes.back);
}

/// The rows of the rotation are the camera's axes, each of length 1; the translation, by
/// -position, comes first. The camera must have no fault.
inline Matrix<Rational> view_matrix(const Camera& camera, ViewAxis axis) {
    const CameraAxes axes = axes_of(camera);
    const auto x = unit_vector(axes.right);
    const auto y = unit_vector(axes.up);
    const auto back = unit_vector(axes.back);
    const int sign = axis == ViewAxis::minus_z ? 1 : -1;
    const Matrix<Rational> rotation{{{{x.x, x.y, x.z, 0},
                                      {y.x, y.y, y.z, 0},
                                      {sign * back.x, sign * back.y, sign * back.z, 0},
                                      {0, 0, 0, 1}}}};
    return rotation * translation<Rational>(Vec<Rational, 3>{} - exact(camera.position));
}

} // namespace rastertrace
