// SPDX-License-Identifier: MIT
#pragma once

// Dividing whole numbers by the same divisor again and again, exactly.
//
//     const Divisor<std::int64_t> three(3);
//     three.divide(-7);  // quotient -3, rest 2

#include <rastertrace/core/numbers/scalar.h>

#include <cassert>
#include <cstdint>

namespace rastertrace {

/// What a whole number is: so many times the divisor, rounded down, and a rest that is not negative.
template <typename Integer> struct Quotient {
    Integer quotient;
    Integer rest;
};

/// A positive divisor.
template <typename Integer> class Divisor {
public:
    explicit Divisor(Integer value) : value_(value) {}

    Integer value() const { return value_; }

    Quotient<Integer> divide(Integer number) const {
        const Integer quotient = floor_quotient<Integer>(number, value_);
        return {quotient, number - quotient * value_};
    }

    friend Divisor operator*(const Divisor& a, const Divisor& b) {
        return Divisor(a.value_ * b.value_);
    }

private:
    Integer value_;
};

/// On 64 bits, multiplied by the reciprocal: a processor divides whole numbers several times slower
/// than it multiplies doubles. The product is off by a few units in its last place; a quotient of
/// less than 2^49 is then off by less than 1, and its rest tells which way.
template <> class Divisor<std::int64_t> {
public:
    explicit Divisor(std::int64_t value) : Divisor(value, 1 / static_cast<double>(value)) {}

    std::int64_t value() const { return value_; }

    /// The quotient must lie within +-2^49.
    Quotient<std::int64_t> divide(std::int64_t number) const {
        std::int64_t quotient = floor_index(static_cast<double>(number) * reciprocal_);
        std::int64_t rest = number - quotient * value_;
        const std::int64_t too_high = rest < 0 ? 1 : 0;
        const std::int64_t too_low = rest >= value_ ? 1 : 0;
        quotient += too_low - too_high;
        rest += (too_high - too_low) * value_;
        assert(0 <= rest && rest < value_);
        return {quotient, rest};
    }

    friend Divisor operator*(const Divisor& a, const Divisor& b) {
        return {a.value_ * b.value_, a.reciprocal_ * b.reciprocal_};
    }

private:
    Divisor(std::int64_t value, double reciprocal) : value_(value), reciprocal_(reciprocal) {}

    std::int64_t value_;
    double reciprocal_;
};

} // namespace rastertrace
