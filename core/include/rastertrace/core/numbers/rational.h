// SPDX-License-Identifier: MIT
#pragma once

// Fractions of any size, in lowest terms: GMP's.
//
//     floor_index(Rational(-1, 4))  // -1

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/numbers/scalar.h>

#include <gmpxx.h>

#include <algorithm>
#include <cstdint>

namespace rastertrace {

using Rational = mpq_class;

template <> struct NumberTraits<Rational> : PlainNumber<Rational> {
    static Index floor(const Rational& x) {
        mpz_class quotient;
        mpz_fdiv_q(quotient.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
        if (!quotient.fits_slong_p())
            return sgn(quotient) < 0 ? -farthest_index : farthest_index;
        return std::clamp<Index>(quotient.get_si(), -farthest_index, farthest_index);
    }
};

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

} // namespace rastertrace
