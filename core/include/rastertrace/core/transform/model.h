// SPDX-License-Identifier: MIT
#pragma once

// From object space to world space: a model scales, moves (matrix.h), turns and shears.
//
//     translation<double>({0, 0, 4}) * scaling<double>({2, 2, 2});  // scales first, then moves

#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/transform/matrix.h>

#include <array>
#include <cstddef>

namespace rastertrace {

/// Multiplies x, y and z each by its own number.
template <typename Scalar> Matrix<Scalar> scaling(const Vec<Scalar, 3>& by) {
    return diagonal<Scalar>(by.x, by.y, by.z, 1);
}

/// Turns about an axis through the origin, counter-clockwise as seen from the axis's tip.
/// Rodrigues' formula: cos I + (1 - cos) a a^T + sin [a]x, for the unit axis a. `axis` has any
/// length but 0, and `unit` is a vector of length 1 in its direction: the products of the
/// components of a are quotients by the square of the length, and need no root.
template <typename Scalar>
Matrix<Scalar> rotation(const Vec<Scalar, 3>& axis, const Vec<Scalar, 3>& unit, const Scalar& sine,
                        const Scalar& cosine) {
    const Scalar square = dot(axis, axis);
    const std::array<Scalar, 3> v{axis.x, axis.y, axis.z};
    const std::array<std::array<Scalar, 3>, 3> cross{
        {{0, Scalar(-unit.z), unit.y}, {unit.z, 0, Scalar(-unit.x)}, {Scalar(-unit.y), unit.x, 0}}};
    Matrix<Scalar> matrix = identity<Scalar>();
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            matrix.rows[i][j] = (i == j ? cosine : Scalar(0)) +
                                (1 - cosine) * v[i] * v[j] / square + sine * cross[i][j];
    return matrix;
}

/// The multiples of the other coordinates that a shear adds to each: `xy` times y to x, and so on.
template <typename Scalar> struct ShearFactors { Scalar xy, xz, yx, yz, zx, zy; };

template <typename Scalar> Matrix<Scalar> shear(const ShearFactors<Scalar>& by) {
    return {{{{1, by.xy, by.xz, 0}, //
              {by.yx, 1, by.yz, 0},
              {by.zx, by.zy, 1, 0},
              {0, 0, 0, 1}}}};
}

} // namespace rastertrace
