// SPDX-License-Identifier: MIT
#pragma once

// Exact division of whole numbers by a divisor that is used more than once.
//
//     const Divisor<std::int64_t> three(3);
//     three.divide(-7);  // quotient -3, rest 2

#include <rastertrace/core/numbers/scalar.h>

#include <cassert>

namespace rastertrace {

/// A quotient that is rounded down, and the remainder, which is not negative.
template <typename Integer> struct Quotient {
    Integer quotient;
    Integer rest;
};

/// A positive divisor of 64 bits. It multiplies by the reciprocal: processors divide integers
/// several times more slowly than they multiply doubles. The product is off by a few units in its
/// last place. A quotient below 2^49 is then off by at most 1, and the remainder says in which
/// direction.
template <typename Integer> class Divisor {
public:
    explicit Divisor(Integer value) : Divisor(value, 1 / static_cast<double>(value)) {}

    Integer value() const { return value_; }

    /// The quotient must lie within +-2^49.
    Quotient<Integer> divide(Integer number) const {
        Integer quotient = floor_index(static_cast<double>(number) * reciprocal_);
        Integer rest = number - quotient * value_;
        const Integer too_high = rest < 0 ? 1 : 0;
        const Integer too_low = rest >= value_ ? 1 : 0;
        quotient += too_low - too_high;
        rest += (too_high - too_low) * value_;
        assert(0 <= rest && rest < value_);
        return {quotient, rest};
    }

    friend Divisor operator*(const Divisor& a, const Divisor& b) {
        return {a.value_ * b.value_, a.reciprocal_ * b.reciprocal_};
    }

private:
    Divisor(Integer value, double reciprocal) : value_(value), reciprocal_(reciprocal) {}

    Integer value_;
    double reciprocal_;
};

} // namespace rastertrace
