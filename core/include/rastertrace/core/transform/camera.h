// SPDX-License-Identifier: MIT
#pragma once

// From world space to camera space: the eye at the origin, y up, and the view along -z, with x to its
// right (along +z for the pinhole of T0, with x to the right where the world's own is).
//
//     const auto axes = camera_axes<double>({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, ViewAxis::minus_z);
//
// Source: the look-at matrix of every text, here with T4's two slips put right: the translation is
// by -position and comes first, and z points from what is looked at to the eye. T0 looks the other way.

#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/transform/matrix.h>

namespace rastertrace {

/// Where the camera looks in its own space.
enum class ViewAxis { minus_z, plus_z };

/// The axes x, y and z of camera space in the world. Whichever way the view goes, z is x cross y: a
/// camera turns what it sees, and mirrors nothing.
template <typename Scalar> struct CameraAxes {
    Vec<Scalar, 3> right;
    Vec<Scalar, 3> up;
    Vec<Scalar, 3> back; ///< against a view along -z; one along +z is this itself
};

/// The axes of an eye at `position`, of any length. `up` is any direction that is not the view's.
template <typename Scalar>
CameraAxes<Scalar> camera_axes(const Vec<Scalar, 3>& position, const Vec<Scalar, 3>& look_at,
                               const Vec<Scalar, 3>& up, ViewAxis axis) {
    const Vec<Scalar, 3> z = axis == ViewAxis::minus_z ? position - look_at : look_at - position;
    const Vec<Scalar, 3> x = cross(up, z);
    return {x, cross(z, x), z};
}

/// The factors of a view: a rotation, whose rows are the axes of length 1, and a translation by
/// -position, which moves a point first.
template <typename Scalar>
MatrixFactors<Scalar> view(const CameraAxes<Scalar>& unit_axes, const Vec<Scalar, 3>& position) {
    const auto& [x, y, z] = unit_axes;
    const Matrix<Scalar> rotation{{{{x.x, x.y, x.z, 0}, //
                                    {y.x, y.y, y.z, 0},
                                    {z.x, z.y, z.z, 0},
                                    {0, 0, 0, 1}}}};
    return {{"rotate", rotation}, {"translate", translation<Scalar>(Vec<Scalar, 3>{} - position)}};
}

} // namespace rastertrace
