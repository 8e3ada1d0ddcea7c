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

#include <vector>

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

CameraAxes axes_of(const Camera& camera);

bool is_zero(const Vec<Rational, 3>& vector);

/// What is wrong with a camera.
enum class CameraFault { none, looks_at_itself, up_along_view };

CameraFault fault_of(const Camera& camera);

/// True if the matrix of this camera is not exact.
bool is_rounded(const Camera& camera);

/// A rotation, whose rows are the camera's axes, each of length 1, and a translation by -position, which
/// moves a point first. The camera must have no fault.
std::vector<MatrixFactor<Rational>> factors_of(const Camera& camera, ViewAxis axis);

/// The product of the factors. Of an axis whose length is no fraction, the shift -position . axis is divided by
/// that length last, and rounded once: a position at right angles to the axis gives 0.
Matrix<Rational> view_matrix(const Camera& camera, ViewAxis axis);

} // namespace rastertrace
