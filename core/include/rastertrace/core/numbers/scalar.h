// SPDX-License-Identifier: MIT
#pragma once

// What the algorithms ask of a number, for each kind of number they run on: float, double, fractions
// on 64 and on 128 bits, GMP rationals, and filtered doubles. An algorithm that needs
// more than + - * / and < finds it here.
//
//     floor_index(2.75)                              // 2
//     floor_index(Fraction<std::int64_t>{-1, 4})     // -1

#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/fraction.h>
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/raster/canvas.h>

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>

namespace rastertrace {

using Fraction64 = Fraction<std::int64_t>;
using Fraction128 = Fraction<Int128>;
using Rational = mpq_class;

/// The grid that `fixed` snaps to: 1/256 pixel, as graphics hardware does.
inline constexpr std::int64_t fixed_grid = 256;

/// The largest whole number not above `x`, kept within +-farthest_index. `x` must not be NaN.
inline Index floor_index(double x) {
    constexpr auto farthest = static_cast<double>(farthest_index);
    // The cast drops the fraction, which rounds a negative number up.
    const double near = std::clamp(x, -farthest, farthest);
    const auto toward_zero = static_cast<Index>(near);
    return static_cast<double>(toward_zero) > near ? toward_zero - 1 : toward_zero;
}

/// The largest whole number not above above/below, for a positive divisor. C++ division drops the
/// fraction, which rounds a negative quotient up.
template <typename Integer> Integer floor_quotient(Integer above, Integer below) {
    const Integer toward_zero = above / below;
    return above % below < 0 ? toward_zero - 1 : toward_zero;
}

/// The same on 64 bits, where dividing by a power of two is worth a shift: `fixed` does it all the
/// time.
inline std::int64_t floor_quotient(std::int64_t above, std::int64_t below) {
    const bool is_power_of_two = (below & (below - 1)) == 0;
    return is_power_of_two ? above >> std::countr_zero(static_cast<std::uint64_t>(below))
                           : floor_quotient<std::int64_t>(above, below);
}

template <typename Integer> Index floor_index(const Fraction<Integer>& x) {
    Integer quotient = floor_quotient(x.numerator, x.denominator);
    return static_cast<Index>(
        std::clamp(quotient, Integer{-farthest_index}, Integer{farthest_index}));
}

inline Index floor_index(const Rational& x) {
    mpz_class quotient;
    mpz_fdiv_q(quotient.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
    if (!quotient.fits_slong_p())
        return sgn(quotient) < 0 ? -farthest_index : farthest_index;
    return std::clamp<Index>(quotient.get_si(), -farthest_index, farthest_index);
}

/// Throws Undecided if the bound reaches over a whole number, or the number lies beyond the indices.
[[gnu::always_inline]] inline Index floor_index(Adaptive x) {
    if (!(std::abs(x.value()) < static_cast<double>(farthest_index))) [[unlikely]] {
        if (x.error() == 0)
            return floor_index(x.value());
        Adaptive::leave_open(x.value(), x.error());
    }
    const auto toward_zero = static_cast<Index>(x.value());
    const Index index =
        static_cast<double>(toward_zero) > x.value() ? toward_zero - 1 : toward_zero;

    // How far to the whole numbers on both sides: exactly, as far as it is less than a half.
    const auto below = static_cast<double>(index);
    const double from_below = x.value() - below;
    const double to_next = below + 1 - x.value();
    const double error = x.error() * Adaptive::widening;
    if (!(error <= from_below && error < to_next)) [[unlikely]]
        Adaptive::leave_open(from_below < to_next ? from_below : -to_next, x.error());
    return index;
}

/// The smallest whole number not below `x`, kept within +-farthest_index.
template <typename Scalar> [[gnu::always_inline]] inline Index ceil_index(const Scalar& x) {
    return -floor_index(Scalar(-x));
}

/// start + slope (at - from): a point on a line. Adaptive has its own, in adaptive.h.
template <typename Scalar>
[[gnu::always_inline]] inline Scalar linear(const Scalar& start, const Scalar& slope,
                                            const Scalar& at, const Scalar& from) {
    return start + slope * (at - from);
}

/// A whole number as a Scalar.
template <typename Scalar> Scalar scalar_from(Index whole) {
    if constexpr (std::same_as<Scalar, Rational>)
        return Rational(whole);
    else if constexpr (std::same_as<Scalar, Adaptive>)
        return std::abs(whole) <= (Index{1} << 53) ? Adaptive(static_cast<double>(whole))
                                                   : rounded_to(static_cast<double>(whole));
    else
        return static_cast<Scalar>(whole);
}

/// An exact number as a Scalar: the nearest float or double, or exactly.
template <typename Scalar> Scalar nearest_scalar(const Rational& exact) {
    if constexpr (std::same_as<Scalar, float>)
        return nearest_float(exact);
    else if constexpr (std::same_as<Scalar, double>)
        return nearest_double(exact);
    else if constexpr (std::same_as<Scalar, Adaptive>)
        return with_error(exact);
    else
        return exact;
}

/// A number of the scene as a Scalar that needs no denominator.
template <typename Scalar> Scalar scalar_from(const Number& number) {
    if constexpr (std::same_as<Scalar, float>)
        return number.nearest_float();
    else if constexpr (std::same_as<Scalar, double>)
        return number.nearest_double();
    else if constexpr (std::same_as<Scalar, Adaptive>)
        return with_error(number);
    else
        return number.exact();
}

/// What fractions ask of a number, typed or worked out: a denominator that it can be written over,
/// and its numerator over a denominator, rounded to the nearest whole number (a half up). Both only
/// if they fit.
inline std::optional<std::int64_t> denominator_of(const Number& number) {
    return number.denominator();
}
inline std::optional<std::int64_t> denominator_of(const Rational& number) {
    if (!number.get_den().fits_slong_p())
        return std::nullopt;
    return number.get_den().get_si();
}
inline std::optional<std::int64_t> nearest_numerator(const Number& number,
                                                     std::int64_t denominator) {
    const auto exact = number.numerator_over(denominator);
    return exact ? exact : number.nearest_numerator_over(denominator);
}
inline std::optional<std::int64_t> nearest_numerator(const Rational& number,
                                                     std::int64_t denominator) {
    return Number::fraction(number).nearest_numerator_over(denominator);
}
inline std::optional<std::int64_t> nearest_numerator(double number, std::int64_t denominator) {
    const double numerator = number * static_cast<double>(denominator);
    if (!(std::abs(numerator) < 0x1p62))
        return std::nullopt;
    const double below = std::floor(numerator);
    return static_cast<std::int64_t>(below) + (numerator - below >= 0.5 ? 1 : 0);
}

/// A fraction in lowest terms.
template <typename Integer> Rational exact(const Fraction<Integer>& number) {
    const auto whole = [](Integer value) {
        if constexpr (sizeof(Integer) <= sizeof(std::int64_t)) {
            return mpz_class(value);
        } else {
            const mpz_class high(static_cast<std::int64_t>(value >> 64));
            const mpz_class low(static_cast<std::uint64_t>(value));
            return mpz_class((high << 64) + low);
        }
    };
    Rational result(whole(number.numerator), whole(number.denominator));
    result.canonicalize();
    return result;
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
template <typename Integer> double to_double(const Fraction<Integer>& number) {
    // A quotient of two doubles is rounded once.
    const auto above = static_cast<double>(number.numerator);
    const auto below = static_cast<double>(number.denominator);
    const auto is_double = [](Integer whole) {
        return -(Integer{1} << 53) <= whole && whole <= (Integer{1} << 53);
    };
    if (is_double(number.numerator) && is_double(number.denominator))
        return above / below;
    return nearest_double(exact(number));
}
inline double to_double(const Adaptive& number) {
    return number.value();
}

/// How far the double nearest to a coordinate may lie from the coordinate that is drawn with.
inline double error_of(const Adaptive& number) {
    return number.error();
}
template <typename Coordinate> double error_of(const Coordinate&) {
    return 0;
}

/// Throws Undecided if a number has left the doubles. Others have been looked at by plan.h.
template <typename Scalar> void require_finite(const Scalar&) {}
inline void require_finite(Adaptive number) {
    if (!std::isfinite(number.value()) || !std::isfinite(number.error()))
        Adaptive::leave_open(number.value(), number.error());
}

/// True if two numbers are not equal, whatever else is not known about them.
template <typename Scalar> bool surely_differ(const Scalar& a, const Scalar& b) {
    return a != b;
}
inline bool surely_differ(const Adaptive& a, const Adaptive& b) {
    const auto order = order_of(a, b);
    return order && *order != 0;
}

/// True if two numbers are not equal, or it is not known that they are.
template <typename Scalar> bool may_differ(const Scalar& a, const Scalar& b) {
    return a != b;
}
inline bool may_differ(const Adaptive& a, const Adaptive& b) {
    const auto order = order_of(a, b);
    return !order || *order != 0;
}

/// A coordinate as a Scalar. Where one is rounded (to a grid of fractions), a half goes up; plan.h
/// finds a denominator that suits them all, or the grid to snap to.
template <typename Scalar, typename Coordinate>
Scalar scalar_from(const Coordinate& coordinate, std::int64_t denominator) {
    if constexpr (std::same_as<Scalar, Coordinate>) {
        return coordinate;
    } else if constexpr (std::same_as<Scalar, Adaptive>) {
        return with_error(coordinate);
    } else if constexpr (std::floating_point<Scalar>) {
        return scalar_from<Scalar>(coordinate);
    } else if constexpr (std::same_as<Scalar, Rational>) {
        if constexpr (!std::floating_point<Coordinate>)
            if (denominator == 1)
                return scalar_from<Scalar>(coordinate);
        const auto numerator = nearest_numerator(coordinate, denominator);
        assert(numerator && "find_unfit has seen that every number fits");
        Rational snapped(*numerator, denominator);
        snapped.canonicalize();
        return snapped;
    } else {
        const auto numerator = nearest_numerator(coordinate, denominator);
        assert(numerator && "the plan has seen that every number fits");
        return Scalar{*numerator, denominator};
    }
}

/// The same number over a denominator that is `factor` times as large, if it has one.
template <typename Scalar> Scalar written_finer(Scalar value, std::int64_t) {
    return value;
}
template <typename Integer>
Fraction<Integer> written_finer(const Fraction<Integer>& value, std::int64_t factor) {
    return {value.numerator * factor, value.denominator * factor};
}

/// The numbers that depths, and colors in a perspective, are worked out in. A fraction's denominator
/// would grow too far: what is drawn on a grid takes doubles, and what is exact takes rationals from
/// the start.
template <typename Scalar> struct DepthScalar { using type = Scalar; };
template <typename Integer> struct DepthScalar<Fraction<Integer>> { using type = double; };
template <typename Scalar> using DepthOf = typename DepthScalar<Scalar>::type;

/// A coordinate as a number for depths.
template <typename Scalar> const Scalar& depth_scalar(const Scalar& x) {
    return x;
}
template <typename Integer> double depth_scalar(const Fraction<Integer>& x) {
    return to_double(x);
}

/// Writes `step` over the denominator of `value`, so that adding it again and again does not make
/// the fraction grow. The denominator of `value` must be a multiple of that of `step`, as it is for
/// a point on a line and the line's slope. Other scalars need no such care.
template <typename Scalar> void write_over_denominator_of(const Scalar&, Scalar&) {}

template <typename Integer>
void write_over_denominator_of(const Fraction<Integer>& value, Fraction<Integer>& step) {
    assert(value.denominator % step.denominator == 0);
    step = {step.numerator * (value.denominator / step.denominator), value.denominator};
}

} // namespace rastertrace
