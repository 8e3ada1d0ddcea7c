// SPDX-License-Identifier: MIT
#pragma once

// Exact division of whole numbers by a divisor that is used more than once.
//
//     const Divisor<std::int64_t> three(3);
//     three.divide(-7);  // quotient -3, rest 2

#include <rastertrace/core/numbers/scalar.h>

#include <cassert>
#include <cstdint>

namespace rastertrace {

/// A quotient that is rounded down, and the remainder, which is not negative.
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

/// On 64 bits it multiplies by the reciprocal: processors divide integers several times more slowly
/// than they multiply doubles. The product is off by a few units in its last place. A quotient
/// below 2^49 is then off by at most 1, and the remainder says in which direction.
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
