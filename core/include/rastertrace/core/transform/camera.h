// SPDX-License-Identifier: MIT
#pragma once

// From world space to camera space: the eye at the origin, x to its right, y up, and the view along
// -z (along +z for the pinhole of T0, whose frame is left-handed).
//
//     const auto axes = camera_axes<double>({0, 0, 4}, {0, 0, 0}, {0, 1, 0});  // of length 4
//
// Source: the look-at matrix of every text, here with T4's two slips put right: the translation is
// by -position and comes first, and z points from what is looked at to the eye.

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/transform/matrix.h>

#include <array>

namespace rastertrace {

/// Where the camera looks in its own space.
enum class ViewAxis { minus_z, plus_z };

/// The directions to the right and upward, and backward against the view.
template <typename Scalar> struct CameraAxes {
    Vec<Scalar, 3> right;
    Vec<Scalar, 3> up;
    Vec<Scalar, 3> back;
};

/// The axes of an eye at `position`, of any length. `up` is any direction that is not the view's.
template <typename Scalar>
CameraAxes<Scalar> camera_axes(const Vec<Scalar, 3>& position, const Vec<Scalar, 3>& look_at,
                               const Vec<Scalar, 3>& up) {
    const Vec<Scalar, 3> back = position - look_at;
    const Vec<Scalar, 3> right = cross(up, back);
    return {right, cross(back, right), back};
}

/// What a view is the product of: a rotation, whose rows are the axes, of length 1, and a translation by
/// -position, which moves a point first.
template <typename Scalar>
std::array<MatrixFactor<Scalar>, 2> view(const CameraAxes<Scalar>& unit_axes,
                                         const Vec<Scalar, 3>& position, ViewAxis axis) {
    const auto& [x, y, back] = unit_axes;
    const Scalar zero = scalar_from<Scalar>(0);
    const Scalar sign = scalar_from<Scalar>(axis == ViewAxis::minus_z ? 1 : -1);
    return {{{"rotate",
              {{{{x.x, x.y, x.z, zero},
                 {y.x, y.y, y.z, zero},
                 {Scalar(sign * back.x), Scalar(sign * back.y), Scalar(sign * back.z), zero},
                 {zero, zero, zero, scalar_from<Scalar>(1)}}}}},
             {"translate", translation<Scalar>(Vec<Scalar, 3>{} - position)}}};
}

} // namespace rastertrace
