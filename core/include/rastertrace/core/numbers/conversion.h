// SPDX-License-Identifier: MIT
#pragma once

// From one kind of number to another: what was typed in a scene becomes a Scalar to draw with, and
// a Scalar becomes a double to look at.
//
//     scalar_from<double>(Number::decimal(1, -1));         // the double nearest to 1/10
//     scalar_from<Fraction64>(Number::decimal(5, -1), 2);  // 1/2

#include <rastertrace/core/numbers/rational.h>

#include <cassert>

namespace rastertrace {

/// An exact number as a Scalar: the nearest float or double, or itself.
template <typename Scalar> struct Conversion;

template <> struct Conversion<float> {
    static float of(const Number& number) { return number.nearest_float(); }
    static float of(const Rational& number) { return nearest_float(number); }
};
template <> struct Conversion<double> {
    static double of(const Number& number) { return number.nearest_double(); }
    static double of(const Rational& number) { return nearest_double(number); }
};
template <> struct Conversion<Rational> {
    static Rational of(const Number& number) { return number.exact(); }
    static const Rational& of(const Rational& number) { return number; }
};

/// An exact number as a Scalar: the nearest float or double, or exactly.
template <typename Scalar> Scalar nearest_scalar(const Rational& exact) {
    return Conversion<Scalar>::of(exact);
}

/// A number of the scene as a Scalar other than a fraction.
template <typename Scalar> Scalar scalar_from(const Number& number) {
    return Conversion<Scalar>::of(number);
}

/// What fractions ask of a number, typed or worked out: a denominator that it can be written over,
/// and its numerator over a denominator, rounded to the nearest whole number (a half up). Both only
/// if they fit.
inline std::optional<std::int64_t> denominator_of(const Number& number) {
    return number.denominator();
}
inline std::optional<std::int64_t> nearest_numerator(const Number& number,
                                                     std::int64_t denominator) {
    const auto exact = number.numerator_over(denominator);
    return exact ? exact : nearest_numerator(number.exact(), denominator);
}
inline std::optional<std::int64_t> nearest_numerator(double number, std::int64_t denominator) {
    const double numerator = number * static_cast<double>(denominator);
    if (!(std::abs(numerator) < 0x1p62))
        return std::nullopt;
    const double below = std::floor(numerator);
    return static_cast<std::int64_t>(below) + (numerator - below >= 0.5 ? 1 : 0);
}

/// A coordinate as a Scalar: a fraction over `denominator`, to which a half is rounded up. plan.h
/// finds a denominator for all coordinates, or the grid to snap to.
template <typename Scalar, typename Coordinate>
Scalar scalar_from(const Coordinate& coordinate, std::int64_t denominator) {
    if constexpr (std::same_as<Scalar, Coordinate>) {
        return coordinate;
    } else if constexpr (std::same_as<Scalar, Rational> || is_fraction<Scalar>) {
        if constexpr (std::same_as<Scalar, Rational> && !std::floating_point<Coordinate>)
            if (denominator == 1)
                return scalar_from<Scalar>(coordinate);
        const auto numerator = nearest_numerator(coordinate, denominator);
        assert(numerator && "the plan has seen that every number fits");
        Scalar snapped(*numerator, denominator);
        if constexpr (std::same_as<Scalar, Rational>)
            snapped.canonicalize();
        return snapped;
    } else {
        return Conversion<Scalar>::of(coordinate);
    }
}

/// The same number over a denominator that is `factor` times as large, if it has one.
template <typename Scalar>
Scalar written_finer(const Scalar& value, [[maybe_unused]] std::int64_t factor) {
    if constexpr (is_fraction<Scalar>)
        return {value.numerator * factor, value.denominator * factor};
    else
        return value;
}

/// The double nearest to a coordinate.
inline double to_double(double number) {
    return number;
}
inline double to_double(const Rational& number) {
    return nearest_double(number);
}
inline double to_double(const Number& number) {
    return number.nearest_double();
}

/// How far to_double may lie from the coordinate that is drawn with.
template <typename Coordinate> double error_of(const Coordinate&) {
    return 0;
}

/// True unless two numbers are certain to be equal.
template <typename Scalar> bool may_differ(const Scalar& a, const Scalar& b) {
    return a != b;
}

} // namespace rastertrace
