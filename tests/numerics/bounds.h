// SPDX-License-Identifier: MIT
#pragma once

// How far off each method can be: bounds on its error, for inputs that are numbers of its type and
// nothing that overflows or underflows. Tests try to break them.
//
//     direct_bound<float>(1.0 / 3, 1000.0 / 3);  // pixels
//
// Every operation rounds once: fl(a + b) = (a + b)(1 + d), |d| <= u. A product of n such factors is
// within gamma(n) of 1 (Higham, "Accuracy and Stability of Numerical Algorithms", lemma 3.1).

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

namespace rastertrace {

/// u: half the distance from 1 to the next number.
template <std::floating_point Scalar>
inline constexpr double
    unit_roundoff = static_cast<double>(std::numeric_limits<Scalar>::epsilon()) / 2;

/// n u / (1 - n u): what n roundings, one on top of the other, can add up to.
template <std::floating_point Scalar> constexpr double gamma_of(double n) {
    return n * unit_roundoff<Scalar> / (1 - n * unit_roundoff<Scalar>);
}

/// x1 + a (y - y1), where x is exact and `offset` is the exact a (y - y1): three roundings of a, one
/// of y - y1, one of the product; the sum rounds everything once more.
template <std::floating_point Scalar> double direct_bound(double x, double offset) {
    return unit_roundoff<Scalar> * std::abs(x) + gamma_of<Scalar>(6) * std::abs(offset);
}

/// (1 - t) x1 + t x2 for 0 <= t <= 1: three roundings of t, one of 1 - t, one of a product, one of the
/// sum. It does not matter how near to 0 x is: near an end of an edge it is no better.
template <std::floating_point Scalar> double weighted_bound(double x1, double x2) {
    return gamma_of<Scalar>(6) * (std::abs(x1) + std::abs(x2));
}

/// x += a, n times, from a first value that is `first_error` off: a is wrong by three roundings, n
/// times over, and every sum rounds a number up to `largest`. With largest = |x0| + n |a| this grows
/// with n where |x0| leads, and with n^2 where n |a| does.
template <std::floating_point Scalar>
double incremental_bound(double n, double slope, double largest, double first_error) {
    // What the sums have gathered so far is rounded too.
    const double gathered = first_error + n * gamma_of<Scalar>(3) * std::abs(slope);
    return gathered + gamma_of<Scalar>(n) * (largest + gathered);
}

/// x += a in fixed point with so many bits behind the point, `height` rows below a vertex on the grid:
/// a is too small by less than a unit, and the first row drops less than one.
inline double fixed_point_bound(double height, int bits) {
    return std::ldexp(std::abs(height) + 1, -bits);
}

/// What moving a vertex to the nearest place of a grid does to it, in x and in y.
inline double snapping_bound(int bits) {
    return std::ldexp(0.5, -bits);
}

/// A barycentric weight w = cross/area: `cross_size` and `area_size` are what the two differences of
/// products would be if they were sums, of magnitudes. Where the area drowns in its own rounding there
/// is no bound (infinity). The third weight is what the two cross products leave of the area: its
/// `cross_size` is that of all three, and two more `roundings` come in.
template <std::floating_point Scalar>
double weight_bound(double weight, double cross_size, double area, double area_size,
                    double roundings = 5) {
    const double lost = gamma_of<Scalar>(4) * area_size;
    if (!(lost < std::abs(area)))
        return std::numeric_limits<double>::infinity();
    return (gamma_of<Scalar>(roundings) * cross_size + std::abs(weight) * lost) /
           (std::abs(area) - lost);
}

/// A level of a color, the sum of three weights times levels, before it is rounded: `size` is the sum
/// of their magnitudes, `of_weights` that of the levels times what the weights are off by.
template <std::floating_point Scalar> double level_bound(double size, double of_weights) {
    return of_weights + gamma_of<Scalar>(4) * (size + of_weights);
}

/// A depth of a row, d0 + slope (x - x0): `offset` is the exact slope (x - x0). Against the *largest*
/// depth of the row this is a few u; against a small one at its far end, as many times u as the
/// depths differ.
template <std::floating_point Scalar> double depth_bound(double depth, double offset) {
    return unit_roundoff<Scalar> * std::abs(depth) + gamma_of<Scalar>(3) * std::abs(offset);
}

/// The same accumulated over n pixels of depths up to `largest`.
template <std::floating_point Scalar>
double accumulated_depth_bound(double n, double largest, double first_error) {
    return first_error + gamma_of<Scalar>(n) * (largest + first_error);
}

/// A depth in a buffer of codes between `nearest` and `farthest`: half a code, and what double rounds.
inline double depth_code_bound(double nearest, double farthest, int bits) {
    const double range = std::abs(farthest - nearest);
    return 0.5 * range / (std::ldexp(1, bits) - 1) +
           gamma_of<double>(8) * (range + std::abs(nearest) + std::abs(farthest));
}

/// An attribute between two divisions, where w differs by the factor `ratio` from one to the other and
/// the attribute by `difference`, in exact arithmetic. With r the larger w over the smaller one, the
/// weight that is taken to be t is t/(t + (1 - t) r), and is farthest from it, by
/// (sqrt r - 1)/(sqrt r + 1), at t = sqrt r/(1 + sqrt r).
inline double division_bound(double ratio, double difference) {
    const double root = std::sqrt(std::max(ratio, 1 / ratio));
    return std::abs(difference) * (root - 1) / (root + 1);
}

} // namespace rastertrace
