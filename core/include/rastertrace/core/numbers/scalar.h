// SPDX-License-Identifier: MIT
#pragma once

// What the algorithms ask of a number. An algorithm that needs more than + - * / and < finds it
// here. NumberTraits has a specialization for each kind of number: float, double and fractions
// here, GMP's rationals in rational.h.
//
//     floor_index(2.75)                              // 2
//     floor_index(Fraction<std::int64_t>{-1, 4})     // -1

#include <rastertrace/core/numbers/fraction.h>
#include <rastertrace/core/numbers/index.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace rastertrace {

/// What most kinds of numbers share: a cast from whole numbers, and depths of the same kind.
template <typename Scalar> struct PlainNumber {
    using Depth = Scalar;
    static Scalar from(Index whole) { return static_cast<Scalar>(whole); }
    static const Scalar& depth(const Scalar& x) { return x; }
};

/// What a kind of number does in its own way:
///
///     static Index floor(x)        the largest whole number not above x, within +-farthest_index
///     static Scalar from(whole)    a whole number as a Scalar
///     using Depth                  the numbers of depths, and of colors in a perspective
///     static Depth depth(x)        a coordinate as a Depth
template <typename Scalar> struct NumberTraits : PlainNumber<Scalar> {};

template <std::floating_point Real> struct NumberTraits<Real> : PlainNumber<Real> {
    /// x must not be NaN.
    static Index floor(double x) {
        constexpr auto farthest = static_cast<double>(farthest_index);
        // The cast drops the fraction, which rounds a negative number up.
        const double near = std::clamp(x, -farthest, farthest);
        const auto toward_zero = static_cast<Index>(near);
        return static_cast<double>(toward_zero) > near ? toward_zero - 1 : toward_zero;
    }
};

/// The largest whole number not above above/below, for a positive divisor. C++ division drops the
/// fraction, which rounds a negative quotient up.
template <typename Integer> Integer floor_quotient(Integer above, Integer below) {
    const Integer toward_zero = above / below;
    return above % below < 0 ? toward_zero - 1 : toward_zero;
}

/// The same on 64 bits, with a shift for a power of two, as `fixed` has it.
inline std::int64_t floor_quotient(std::int64_t above, std::int64_t below) {
    const bool is_power_of_two = (below & (below - 1)) == 0;
    return is_power_of_two ? above >> std::countr_zero(static_cast<std::uint64_t>(below))
                           : floor_quotient<std::int64_t>(above, below);
}

template <typename Integer> struct FractionNumber : PlainNumber<Fraction<Integer>> {
    static Index floor(const Fraction<Integer>& x) {
        const Integer quotient = floor_quotient(x.numerator, x.denominator);
        return static_cast<Index>(
            std::clamp(quotient, Integer{-farthest_index}, Integer{farthest_index}));
    }
};

/// Depths are doubles: their denominators would grow too large.
template <typename Integer> struct NumberTraits<Fraction<Integer>> : FractionNumber<Integer> {
    using Depth = double;
    static double depth(const Fraction<Integer>& x) { return to_double(x); }
};

/// The largest whole number not above `x`, kept within +-farthest_index.
template <typename Scalar> [[gnu::always_inline]] inline Index floor_index(const Scalar& x) {
    return NumberTraits<Scalar>::floor(x);
}

/// The smallest whole number not below `x`, kept within +-farthest_index.
template <typename Scalar> [[gnu::always_inline]] inline Index ceil_index(const Scalar& x) {
    return -floor_index(Scalar(-x));
}

/// start + slope (at - from): a point on a line.
template <typename Scalar>
[[gnu::always_inline]] inline Scalar linear(const Scalar& start, const Scalar& slope,
                                            const Scalar& at, const Scalar& from) {
    return start + slope * (at - from);
}

/// A whole number as a Scalar.
template <typename Scalar> Scalar scalar_from(Index whole) {
    return NumberTraits<Scalar>::from(whole);
}

/// The numbers of depths, and of colors in a perspective.
template <typename Scalar> using DepthOf = typename NumberTraits<Scalar>::Depth;

/// A coordinate as a number for depths.
template <typename Scalar> decltype(auto) depth_scalar(const Scalar& x) {
    return NumberTraits<Scalar>::depth(x);
}

/// True if two numbers are certain to differ.
template <typename Scalar> bool surely_differ(const Scalar& a, const Scalar& b) {
    return a != b;
}

/// True if two of three numbers differ. An interval has its own.
template <typename Scalar>
bool are_not_all_equal(const Scalar& a, const Scalar& b, const Scalar& c) {
    return a != b || a != c;
}

/// Does nothing: plan.h has seen that every number is finite. An interval has its own.
template <typename Scalar> void require_finite(const Scalar&) {}

/// `x` held between two numbers.
template <typename Scalar>
[[gnu::always_inline]] inline Scalar held_between(const Scalar& x, const Scalar& low,
                                                  const Scalar& high) {
    return std::clamp(x, low, high);
}

/// Writes `step`, a fraction, over the denominator of `value`, so that repeated additions do not
/// make the sum's denominator grow. The denominator of `value` must be a multiple of that of
/// `step`, as for a point on a line and the line's slope.
template <typename Scalar>
void write_over_denominator_of([[maybe_unused]] const Scalar& value,
                               [[maybe_unused]] Scalar& step) {
    if constexpr (is_fraction<Scalar>) {
        assert(value.denominator % step.denominator == 0);
        step = {step.numerator * (value.denominator / step.denominator), value.denominator};
    }
}

} // namespace rastertrace
