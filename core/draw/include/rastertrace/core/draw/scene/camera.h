// SPDX-License-Identifier: MIT
#pragma once

// The camera of a scene: camera.h of transform/ in exact numbers.
//
//     view_matrix({.position = {0, 0, 4}}, ViewAxis::minus_z);  // moves the world by (0, 0, -4)

#include <rastertrace/core/draw/scene/model.h>
#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/transform/camera.h>
#include <rastertrace/core/transform/matrix.h>

#include <vector>

namespace rastertrace {

/// Where the eye is and where it looks.
struct Camera {
    Numbers3 position{0, 0, 0};
    Numbers3 look_at{0, 0, -1};
    Numbers3 up{0, 1, 0}; ///< any direction that is not the view's
};

/// Its axes, of any length.
CameraAxes<Rational> axes_of(const Camera& camera);

bool is_zero(const Vec<Rational, 3>& vector);

/// What is wrong with a camera.
enum class CameraFault { none, looks_at_itself, up_along_view };

CameraFault fault_of(const Camera& camera);

/// True if the matrix of this camera is not exact.
bool is_rounded(const Camera& camera);

/// Its rotation and its translation. The camera must have no fault.
std::vector<MatrixFactor<Rational>> factors_of(const Camera& camera, ViewAxis axis);

/// The product of the factors. Of an axis whose length is no fraction, the shift -position . axis is divided by
/// that length last, and rounded once: a position at right angles to the axis gives 0.
Matrix<Rational> view_matrix(const Camera& camera, ViewAxis axis);

} // namespace rastertrace
