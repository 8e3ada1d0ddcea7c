// SPDX-License-Identifier: MIT
#pragma once

// A double that knows how far it may be off. As long as that decides every comparison, drawing costs
// little more than with doubles; where it does not, Undecided is thrown, and what could not be
// decided is done again with the same type in its other state: as exact fractions. So every decision
// is the one that exact arithmetic takes.
//
//     Adaptive third = Adaptive(1) / Adaptive(3);  // 0.333..., off by at most 2^-54 or so
//     third < Adaptive(0.5);                       // true
//     third * Adaptive(3) < Adaptive(1);           // throws Undecided
//
// Each operation adds to the bound what it rounds: half a unit in the last place of its result (IEEE
// 754), and for a sum the rounding error itself, which is a double (Knuth's two-sum; Shewchuk 1997,
// "Adaptive Precision Floating-Point Arithmetic", theorem 7). Bounds are rounded, too, and are widened for that. The idea of a
// filter with exact arithmetic behind it: Fortune and Van Wyk 1993; CGAL's Filtered_kernel.

#include <rastertrace/core/number.h>

#include <gmpxx.h>

#include <cmath>
#include <compare>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace rastertrace {

/// What is thrown where a bound leaves it open which of two numbers is the larger one.
struct Undecided {
    double difference; ///< of the two, as it was calculated
    double error;      ///< that it may be off by
};

/// Either a double with a bound on its distance from the number that it stands for, or that number
/// itself. Operations on exact numbers are exact; a number without an error counts as one.
class Adaptive {
public:
    Adaptive() = default;

    /// A double that is off by at most `error`.
    explicit Adaptive(double value, double error = 0) : value_(value), error_(error) {}

    /// An exact number. Its double is the one toward zero.
    explicit Adaptive(mpq_class exact)
        : value_(exact.get_d()), error_(std::abs(value_) * 2 * half_ulp + smallest_error(value_)),
          exact_(std::make_shared<const mpq_class>(std::move(exact))) {}

    double value() const { return value_; }
    double error() const { return error_; }

    /// The number itself, if it is known.
    const mpq_class* exact() const { return exact_.get(); }

    friend Adaptive operator+(const Adaptive& a, const Adaptive& b) {
        if (a.exact_ || b.exact_) [[unlikely]]
            return exactly(a, b, [](const mpq_class& p, const mpq_class& q) { return p + q; });
        const double sum = a.value_ + b.value_;
        const double of_b = sum - a.value_;
        const double rounded_off = (a.value_ - (sum - of_b)) + (b.value_ - of_b);
        return finite(sum, (a.error_ + b.error_ + std::abs(rounded_off)) * widening);
    }

    friend Adaptive operator-(const Adaptive& a) {
        if (a.exact_) [[unlikely]]
            return Adaptive(mpq_class(-*a.exact_));
        return Adaptive(-a.value_, a.error_);
    }

    friend Adaptive operator-(const Adaptive& a, const Adaptive& b) {
        if (a.exact_ || b.exact_) [[unlikely]]
            return exactly(a, b, [](const mpq_class& p, const mpq_class& q) { return p - q; });
        return a + Adaptive(-b.value_, b.error_);
    }

    friend Adaptive operator*(const Adaptive& a, const Adaptive& b) {
        if (a.exact_ || b.exact_) [[unlikely]]
            return exactly(a, b, [](const mpq_class& p, const mpq_class& q) { return p * q; });
        const double product = a.value_ * b.value_;
        const double of_factors =
            std::abs(a.value_) * b.error_ + std::abs(b.value_) * a.error_ + a.error_ * b.error_;
        // Nothing is rounded off where a factor is 0 or 1, as most entries of matrices are.
        if (a.is_trivial_factor() || b.is_trivial_factor())
            return finite(product, of_factors * widening);
        return finite(product,
                      (of_factors + std::abs(product) * half_ulp + smallest_error(product)) *
                          widening);
    }

    /// b must not be 0.
    friend Adaptive operator/(const Adaptive& a, const Adaptive& b) {
        if (a.exact_ || b.exact_) [[unlikely]]
            return exactly(a, b, [](const mpq_class& p, const mpq_class& q) { return p / q; });
        const double quotient = a.value_ / b.value_;
        // (a + da)/(b + db) - a/b = (da - (a/b) db)/(b + db).
        const double nearest_to_zero = (std::abs(b.value_) - b.error_) / widening;
        if (!(nearest_to_zero > smallest_normal_product)) [[unlikely]]
            throw Undecided{b.value_, b.error_};
        const double of_terms =
            (a.error_ + std::abs(quotient) * b.error_) * widening / nearest_to_zero;
        return finite(quotient,
                      (of_terms + std::abs(quotient) * half_ulp + smallest_error(quotient)) *
                          widening);
    }

    Adaptive& operator+=(const Adaptive& b) { return *this = *this + b; }

    /// Which is the larger one, if that can be told.
    friend std::optional<std::strong_ordering> order_of(const Adaptive& a, const Adaptive& b) {
        const double difference = a.value_ - b.value_;
        const double error = (a.error_ + b.error_) * widening;
        if (std::abs(difference) > error) [[likely]]
            return difference < 0 ? std::strong_ordering::less : std::strong_ordering::greater;
        return order_of_near(a, b);
    }

    friend bool operator==(const Adaptive& a, const Adaptive& b) { return (a <=> b) == 0; }

    /// Throws Undecided.
    friend std::strong_ordering operator<=>(const Adaptive& a, const Adaptive& b) {
        const auto order = order_of(a, b);
        if (!order) [[unlikely]]
            throw Undecided{a.value_ - b.value_, a.error_ + b.error_};
        return *order;
    }

    /// The same number as a double with its error.
    Adaptive rounded() const { return Adaptive(value_, error_); }

    /// Of the last place of a double: 2^-53.
    static constexpr double half_ulp = std::numeric_limits<double>::epsilon() / 2;

    /// A bound that has been added up from fewer than a dozen terms is widened by this for what they
    /// have been rounded by.
    static constexpr double widening = 1 + 16 * std::numeric_limits<double>::epsilon();

private:
    /// Below this, products of errors and half a unit in the last place are subnormal, and are
    /// rounded by something of a fixed size.
    static constexpr double smallest_normal_product = 0x1p-960;
    static constexpr double smallest_error(double result) {
        return std::abs(result) < smallest_normal_product ? 0x1p-1060 : 0;
    }
    bool is_trivial_factor() const {
        return error_ == 0 && (value_ == 0 || value_ == 1 || value_ == -1);
    }

    bool is_known() const { return exact_ || error_ == 0; }
    mpq_class as_fraction() const { return exact_ ? *exact_ : mpq_class(value_); }

    /// Numbers that are worked out from exact ones are exact. Not inlined: it is not what is fast.
    template <typename Operation>
    [[gnu::noinline]] static Adaptive exactly(const Adaptive& a, const Adaptive& b,
                                              Operation&& operation) {
        if (!a.is_known() || !b.is_known())
            throw Undecided{a.value_, std::numeric_limits<double>::infinity()};
        return Adaptive(mpq_class(operation(a.as_fraction(), b.as_fraction())));
    }

    /// Numbers that are not known to differ.
    [[gnu::noinline]] static std::optional<std::strong_ordering> order_of_near(const Adaptive& a,
                                                                               const Adaptive& b) {
        if (!a.is_known() || !b.is_known())
            return std::nullopt;
        return cmp(a.as_fraction(), b.as_fraction()) <=> 0;
    }

    /// What has left the doubles decides nothing.
    static Adaptive finite(double value, double error) {
        if (!(error <= std::numeric_limits<double>::max() && std::isfinite(value))) [[unlikely]]
            throw Undecided{value, error};
        return Adaptive(value, error);
    }

    double value_ = 0;
    double error_ = 0;
    std::shared_ptr<const mpq_class> exact_;
};

/// A fraction as a double with its error.
inline Adaptive with_error(const mpq_class& exact) {
    const double value = nearest_double(exact);
    if (std::isfinite(value) && mpq_class(value) == exact)
        return Adaptive(value);
    // Half a unit in the last place; of the subnormal numbers, that is half of the smallest one.
    return Adaptive(value, std::abs(value) * Adaptive::half_ulp +
                               std::numeric_limits<double>::denorm_min());
}

/// What has its error already.
inline const Adaptive& with_error(const Adaptive& number) {
    return number;
}

/// A number as typed, likewise.
inline Adaptive with_error(const Number& number) {
    const double value = number.nearest_double();
    return number.is_exactly(value)
               ? Adaptive(value)
               : Adaptive(value, std::abs(value) * Adaptive::half_ulp +
                                     std::numeric_limits<double>::denorm_min());
}

} // namespace rastertrace
