// SPDX-License-Identifier: MIT
#include "format_number.h"

#include "problem.h"

#include <fmt/core.h>

namespace rastertrace {

void refuse_to_format(double value) {
    throw problem_of("", fmt::format("expected a finite number to write, found {}", value),
                     "this is a fault of rastertrace, please report it with the scene");
}

Rational bound_beside(const Rational& value, double near) {
    // A power of two that is not larger than the difference.
    const Rational difference = abs(value - Rational(near));
    const mp_bitcnt_t bits = mpz_sizeinbase(difference.get_den_mpz_t(), 2) -
                             mpz_sizeinbase(difference.get_num_mpz_t(), 2) + 1;
    Rational step(1);
    mpq_div_2exp(step.get_mpq_t(), step.get_mpq_t(), bits);
    return value < near ? Rational(near - step) : Rational(near + step);
}

} // namespace rastertrace
