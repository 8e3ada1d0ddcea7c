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
//
//     pinhole(2.0) * Vec<double, 4>{1, 1, 4, 1};  // (2, 2, 2, 4): x/w = 1/2

#include <rastertrace/core/transform/matrix.h>

#include <optional>

namespace rastertrace {

/// The sides of what is shown: of an orthographic view, or of a frustum at its near plane.
template <typename Scalar> struct ViewSides { Scalar left, right, bottom, top; };

/// The distances from the eye between which something is shown.
template <typename Scalar> struct ViewRange {
    std::optional<Scalar> near = {}; ///< none: orthographic only; nothing is clipped
    std::optional<Scalar> far = {};  ///< none: infinitely far
};

/// Scale and translation of an orthographic view. Without near or far, z is only turned.
template <typename Scalar>
MatrixFactors<Scalar> orthographic(const ViewSides<Scalar>& sides, const ViewRange<Scalar>& range) {
    const auto& [left, right, bottom, top] = sides;
    const auto& [near, far] = range;
    const bool has_depth = near && far;
    const Scalar z_scale = has_depth ? Scalar(-2 / (*far - *near)) : Scalar(-1);
    const Scalar z_shift = has_depth ? Scalar((*far + *near) / 2) : Scalar(0);
    return {
        {"scale", diagonal<Scalar>(2 / (right - left), 2 / (top - bottom), z_scale, 1)},
        {"translate", translation<Scalar>({-(left + right) / 2, -(bottom + top) / 2, z_shift})}};
}

/// A pinhole at the distance `d` before its view plane.
template <typename Scalar> Matrix<Scalar> pinhole(const Scalar& d) {
    return {{{{d, 0, 0, 0}, //
              {0, d, 0, 0},
              {0, 0, 1, -d},
              {0, 0, 1, 0}}}};
}

/// T4's Mp Mt: the eye at the distance `d` before the view plane.
template <typename Scalar> MatrixFactors<Scalar> view_plane(const Scalar& d) {
    Matrix<Scalar> perspective = identity<Scalar>();
    perspective.rows[3][2] = -1 / d;
    return {{"perspective", perspective}, {"translate", translation<Scalar>({0, 0, d})}};
}

/// A frustum through these sides at the near plane. No `far` is the limit of the finite formulas.
template <typename Scalar>
Matrix<Scalar> frustum(const ViewSides<Scalar>& sides, const ViewRange<Scalar>& range) {
    const auto& [left, right, bottom, top] = sides;
    const Scalar& near = *range.near;
    const auto& far = range.far;
    const Scalar z_scale = far ? Scalar(-(*far + near) / (*far - near)) : Scalar(-1);
    const Scalar z_shift = far ? Scalar(-2 * *far * near / (*far - near)) : Scalar(-2 * near);
    return {{{{2 * near / (right - left), 0, (right + left) / (right - left), 0},
              {0, 2 * near / (top - bottom), (top + bottom) / (top - bottom), 0},
              {0, 0, z_scale, z_shift},
              {0, 0, -1, 0}}}};
}

/// A frustum by its field of view: y is scaled by the cotangent of half its angle, x by that over
/// the aspect, width over height.
template <typename Scalar>
Matrix<Scalar> frustum_of_view(const Scalar& cotangent, const Scalar& aspect,
                               const ViewRange<Scalar>& range) {
    const Scalar& near = *range.near;
    const Scalar x = near * aspect / cotangent;
    const Scalar y = near / cotangent;
    return frustum<Scalar>({-x, x, -y, y}, range);
}

} // namespace rastertrace
