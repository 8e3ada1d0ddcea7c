// SPDX-License-Identifier: MIT
#pragma once

// Irrational numbers that matrices need, each as the double nearest to it: sine, cosine and tangent
// of an angle in degrees, and square roots. The functions of the C library may differ in the last
// bit from machine to machine, and a scene must give the same bytes everywhere; so these are worked
// out in whole numbers.
//
//     sine_of_degrees(30)          // 0.5
//     square_root(mpq_class(9, 4)) // 3/2, exactly

#include <gmpxx.h>

namespace rastertrace {

/// above/below in lowest terms.
mpq_class quotient_of(const mpz_class& above, const mpz_class& below);

/// True if the sine and the cosine of the angle are 0, 1 or -1.
bool is_quarter_turn(const mpq_class& degrees);

double sine_of_degrees(const mpq_class& degrees);

double cosine_of_degrees(const mpq_class& degrees);

/// The angle must lie between 0 and 180 degrees, both excluded.
double cotangent_of_degrees(const mpq_class& degrees);

/// True if the square root of the number is a fraction.
bool has_rational_root(const mpq_class& square);

/// The square root of a number from 0 on: exactly if it is rational, else the nearest double.
mpq_class square_root(const mpq_class& square);

} // namespace rastertrace
