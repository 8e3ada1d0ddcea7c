// SPDX-License-Identifier: MIT
#pragma once

// What the algorithms ask of a number, for each kind of number they run on: double, fractions on 64
// and on 128 bits, and GMP rationals. An algorithm that needs more than + - * / and < finds it
// here.
//
//     floor_index(2.75)                              // 2
//     floor_index(Fraction<std::int64_t>{-1, 4})     // -1

#include <rastertrace/core/canvas.h>
#include <rastertrace/core/fraction.h>
#include <rastertrace/core/number.h>

#include <gmpxx.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <concepts>
#include <cstdint>

namespace rastertrace {

using Fraction64 = Fraction<std::int64_t>;
using Fraction128 = Fraction<Int128>;
using Rational = mpq_class;

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

/// The smallest whole number not below `x`, kept within +-farthest_index.
template <typename Scalar> Index ceil_index(const Scalar& x) {
    return -floor_index(Scalar(-x));
}

/// A whole number as a Scalar.
template <typename Scalar> Scalar scalar_from(Index whole) {
    if constexpr (std::same_as<Scalar, Rational>)
        return Rational(static_cast<long>(whole));
    else
        return static_cast<Scalar>(whole);
}

/// A number of the scene as a Scalar: the nearest double, or exactly. Fractions on machine integers
/// are written over `denominator`, rounded to the nearest (a half up) if the number is no multiple
/// of 1/denominator; plan.h finds a denominator that suits them all, or the grid to snap to.
template <typename Scalar> Scalar scalar_from(const Number& number, std::int64_t denominator) {
    if constexpr (std::floating_point<Scalar>) {
        return number.nearest_double();
    } else if constexpr (std::same_as<Scalar, Rational>) {
        return number.exact();
    } else {
        const auto exact = number.numerator_over(denominator);
        const auto numerator = exact ? exact : number.nearest_numerator_over(denominator);
        assert(numerator && "the plan has seen that every number fits");
        return Scalar{*numerator, denominator};
    }
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
