// SPDX-License-Identifier: MIT
#pragma once

// Irrational numbers that matrices need: sine, cosine and tangent of an angle in degrees, and square
// roots. What is drawn has the double nearest to each; what somebody worked out by hand is compared
// with many more digits. The functions of the C library may differ in the last bit from machine to
// machine, and a scene must give the same bytes everywhere; so these are worked out in whole numbers.
//
//     sine_of_degrees(30)                          // 1/2
//     square_root(mpq_class(9, 4))                 // 3/2, exactly
//     square_root(mpq_class(2), RootDigits::many)  // within 2^-512 of it, relatively

#include <gmpxx.h>

namespace rastertrace {

/// above/below in lowest terms.
mpq_class quotient_of(const mpz_class& above, const mpz_class& below);

/// True if the sine and the cosine of the angle are 0, 1 or -1.
bool is_quarter_turn(const mpq_class& degrees);

/// What an irrational number is rounded to.
enum class RootDigits {
    of_double, ///< the nearest double
    many,      ///< a fraction within 2^-`many_binary_digits` of it, relatively
};
inline constexpr unsigned many_binary_digits = 512;

mpq_class sine_of_degrees(const mpq_class& degrees, RootDigits digits = RootDigits::of_double);

mpq_class cosine_of_degrees(const mpq_class& degrees, RootDigits digits = RootDigits::of_double);

/// The angle must lie between 0 and 180 degrees, both excluded.
mpq_class cotangent_of_degrees(const mpq_class& degrees, RootDigits digits = RootDigits::of_double);

/// True if the square root of the number is a fraction.
bool has_rational_root(const mpq_class& square);

/// The square root of a number from 0 on: exactly if it is rational.
mpq_class square_root(const mpq_class& square, RootDigits digits = RootDigits::of_double);

/// pi, with many digits.
mpq_class pi();

} // namespace rastertrace
