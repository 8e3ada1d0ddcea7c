// SPDX-License-Identifier: MIT
#pragma once

// Exact fractions on machine integers that are never reduced: an operation is a few integer
// instructions, as cheap as with double. The caller must know that the numbers fit; plan.h works
// that out from the scene before drawing.
//
//     Fraction<std::int64_t> half{1, 2};
//     half + half  // 2/2, equal to 1

#include <compare>
#include <concepts>
#include <cstdint>
#include <numeric>

namespace rastertrace {

__extension__ using Int128 = __int128;

/// numerator / denominator, not in lowest terms; the denominator is positive. Sums and differences
/// of fractions over the same denominator keep it. No operation checks for overflow.
template <typename Integer> struct Fraction {
    Integer numerator = 0;
    Integer denominator = 1;

    constexpr Fraction() = default;
    constexpr explicit Fraction(Integer whole) : numerator(whole) {}
    constexpr Fraction(Integer above, Integer below) : numerator(above), denominator(below) {}

    friend constexpr Fraction operator+(const Fraction& a, const Fraction& b) {
        if (a.denominator == b.denominator)
            return {a.numerator + b.numerator, a.denominator};
        return {a.numerator * b.denominator + b.numerator * a.denominator,
                a.denominator * b.denominator};
    }

    friend constexpr Fraction operator-(const Fraction& a) { return {-a.numerator, a.denominator}; }
    friend constexpr Fraction operator-(const Fraction& a, const Fraction& b) { return a + -b; }

    friend constexpr Fraction operator*(const Fraction& a, const Fraction& b) {
        return {a.numerator * b.numerator, a.denominator * b.denominator};
    }

    /// b must not be 0.
    friend constexpr Fraction operator/(const Fraction& a, const Fraction& b) {
        const Integer sign = b.numerator < 0 ? -1 : 1;
        if (a.denominator == b.denominator)
            return {sign * a.numerator, sign * b.numerator};
        return {sign * a.numerator * b.denominator, sign * a.denominator * b.numerator};
    }

    constexpr Fraction& operator+=(const Fraction& b) { return *this = *this + b; }

    friend constexpr bool operator==(const Fraction& a, const Fraction& b) {
        return (a <=> b) == std::strong_ordering::equal;
    }

    friend constexpr std::strong_ordering operator<=>(const Fraction& a, const Fraction& b) {
        if (a.denominator == b.denominator)
            return a.numerator <=> b.numerator;
        return a.numerator * b.denominator <=> b.numerator * a.denominator;
    }
};

template <typename Scalar> inline constexpr bool is_fraction = false;
template <typename Integer> inline constexpr bool is_fraction<Fraction<Integer>> = true;

using Fraction64 = Fraction<std::int64_t>;

/// The double nearest to above/below, for a positive divisor.
double nearest_quotient(std::int64_t above, std::int64_t below);

/// The double nearest to a fraction.
template <typename Integer> double to_double(const Fraction<Integer>& number) {
    // A quotient of two doubles is rounded once.
    const auto is_double = [](Integer whole) {
        return -(Integer{1} << 53) <= whole && whole <= (Integer{1} << 53);
    };
    if (is_double(number.numerator) && is_double(number.denominator))
        return static_cast<double>(number.numerator) / static_cast<double>(number.denominator);
    return nearest_quotient(number.numerator, number.denominator);
}

} // namespace rastertrace
