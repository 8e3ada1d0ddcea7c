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
// 754), and for a sum the rounding error itself, which is a double (two-sum: Knuth; Shewchuk 1997,
// theorem 7). Bounds are rounded, too, and are widened for that. A filter with exact arithmetic
// behind it: Fortune and Van Wyk 1993; CGAL's Filtered_kernel.

#include <rastertrace/core/number.h>

#include <gmpxx.h>

#include <cassert>
#include <cmath>
#include <compare>
#include <limits>
#include <optional>
#include <utility>

namespace rastertrace {

/// What is thrown where a bound leaves it open which of two numbers is the larger one.
struct Undecided {
    double difference; ///< of the two, as it was calculated
    double error;      ///< that it may be off by
};

/// Either a double with a bound on its distance from the number that it stands for, or that number
/// itself. Operations on exact numbers are exact; a number without an error counts as one. What is
/// calculated with doubles is compiled into the algorithms; what is exact is called.
class Adaptive {
public:
    Adaptive() = default;

    /// A double that is off by at most `error`.
    explicit Adaptive(double value, double error = 0) : value_(value), error_(error) {}

    /// An exact number. Its double is the one toward zero.
    explicit Adaptive(mpq_class exact) : Adaptive(exactly(std::move(exact))) {}

    Adaptive(const Adaptive& other)
        : value_(other.value_), error_(other.error_), exact_(other.exact_) {
        if (exact_ != nullptr) [[unlikely]]
            ++exact_->owners;
    }
    Adaptive(Adaptive&& other) noexcept
        : value_(other.value_), error_(other.error_), exact_(std::exchange(other.exact_, nullptr)) {
    }
    Adaptive& operator=(Adaptive other) noexcept {
        value_ = other.value_;
        error_ = other.error_;
        std::swap(exact_, other.exact_);
        return *this;
    }
    ~Adaptive() {
        if (exact_ != nullptr) [[unlikely]]
            release(exact_);
    }

    double value() const { return value_; }
    double error() const { return error_; }

    /// The number itself, if it is known.
    const mpq_class* exact() const { return exact_ == nullptr ? nullptr : &exact_->value; }

    /// The same number as a double with its error.
    Adaptive rounded() const { return Adaptive(value_, error_); }

    [[gnu::always_inline]] friend inline Adaptive operator+(const Adaptive& a, const Adaptive& b) {
        if (is_exact(a, b)) [[unlikely]]
            return Adaptive(exact_sum(a.parts(), b.parts()));
        const double sum = a.value_ + b.value_;
        const double of_b = sum - a.value_;
        const double rounded_off = (a.value_ - (sum - of_b)) + (b.value_ - of_b);
        return finite(sum, (a.error_ + b.error_ + std::abs(rounded_off)) * widening);
    }

    friend Adaptive operator-(const Adaptive& a) {
        if (a.exact_ != nullptr) [[unlikely]]
            return Adaptive(mpq_class(-a.exact_->value));
        return Adaptive(-a.value_, a.error_);
    }

    [[gnu::always_inline]] friend inline Adaptive operator-(const Adaptive& a, const Adaptive& b) {
        if (is_exact(a, b)) [[unlikely]]
            return Adaptive(exact_difference(a.parts(), b.parts()));
        return a + Adaptive(-b.value_, b.error_);
    }

    [[gnu::always_inline]] friend inline Adaptive operator*(const Adaptive& a, const Adaptive& b) {
        if (is_exact(a, b)) [[unlikely]]
            return Adaptive(exact_product(a.parts(), b.parts()));
        const double product = a.value_ * b.value_;
        const double of_factors =
            std::abs(a.value_) * b.error_ + std::abs(b.value_) * a.error_ + a.error_ * b.error_;
        // Nothing is rounded off where a factor is 0 or 1, as most entries of matrices are.
        if (a.is_trivial_factor() || b.is_trivial_factor())
            return finite(product, of_factors * widening);
        return finite(product,
                      (of_factors + std::abs(product) * half_ulp + smallest_error) * widening);
    }

    /// b must not be 0.
    friend Adaptive operator/(const Adaptive& a, const Adaptive& b) {
        if (is_exact(a, b)) [[unlikely]]
            return Adaptive(exact_quotient(a.parts(), b.parts()));
        const double quotient = a.value_ / b.value_;
        // (a + da)/(b + db) - a/b = (da - (a/b) db)/(b + db).
        const double nearest_to_zero = (std::abs(b.value_) - b.error_) / widening;
        if (!(nearest_to_zero > smallest_divisor)) [[unlikely]]
            leave_open(b.value_, b.error_);
        const double of_terms =
            (a.error_ + std::abs(quotient) * b.error_) * widening / nearest_to_zero;
        return finite(quotient,
                      (of_terms + std::abs(quotient) * half_ulp + smallest_error) * widening);
    }

    Adaptive& operator+=(const Adaptive& b) { return *this = *this + b; }

    /// start + slope (at - from): the same as with the operators above, and with one bound for all
    /// three.
    [[gnu::always_inline]] friend inline Adaptive
    linear(const Adaptive& start, const Adaptive& slope, const Adaptive& at, const Adaptive& from) {
        if (is_exact(start, slope) || is_exact(at, from)) [[unlikely]]
            return start + slope * (at - from);
        const double way = at.value_ - from.value_;
        const double rise = slope.value_ * way;
        const double value = start.value_ + rise;
        const double of_way = at.error_ + from.error_ + std::abs(way) * half_ulp;
        const double of_rise = (std::abs(slope.value_) + slope.error_) * of_way +
                               slope.error_ * std::abs(way) + smallest_error;
        return finite(value,
                      (start.error_ + of_rise + (std::abs(rise) + std::abs(value)) * half_ulp) *
                          widening);
    }

    /// Which is the larger one, if that can be told.
    [[gnu::always_inline]] friend inline std::optional<std::strong_ordering>
    order_of(const Adaptive& a, const Adaptive& b) {
        const double difference = a.value_ - b.value_;
        if (std::abs(difference) > (a.error_ + b.error_) * widening) [[likely]]
            return difference < 0 ? std::strong_ordering::less : std::strong_ordering::greater;
        return order_of_near(a.parts(), b.parts());
    }

    friend bool operator==(const Adaptive& a, const Adaptive& b) { return (a <=> b) == 0; }

    /// Throws Undecided.
    [[gnu::always_inline]] friend inline std::strong_ordering operator<=>(const Adaptive& a,
                                                                          const Adaptive& b) {
        const auto order = order_of(a, b);
        if (!order) [[unlikely]]
            leave_open(a.value_ - b.value_, a.error_ + b.error_);
        return *order;
    }

    /// Throws Undecided.
    [[noreturn, gnu::noinline, gnu::cold]] static void leave_open(double difference, double error) {
        throw Undecided{difference, error};
    }

    /// Of the last place of a double: 2^-53.
    static constexpr double half_ulp = std::numeric_limits<double>::epsilon() / 2;

    /// A bound that has been added up from fewer than a dozen terms is widened by this for what they
    /// have been rounded by.
    static constexpr double widening = 1 + 16 * std::numeric_limits<double>::epsilon();

    /// What is rounded off a number that is too small for half a unit in its last place, with room
    /// to spare.
    static constexpr double smallest_error = 0x1p-1000;

private:
    static constexpr double smallest_divisor = 0x1p-900;

    /// An exact number, and how many have it.
    struct Exact {
        mpq_class value;
        long owners = 1;
    };

    /// What a number consists of, to be handed over: so that numbers themselves stay in registers.
    struct Parts {
        double value;
        double error;
        Exact* exact;

        bool is_known() const { return exact != nullptr || error == 0; }
        mpq_class as_fraction() const { return exact != nullptr ? exact->value : mpq_class(value); }
    };
    explicit Adaptive(const Parts& parts)
        : value_(parts.value), error_(parts.error), exact_(parts.exact) {}
    Parts parts() const { return {value_, error_, exact_}; }

    static bool is_exact(const Adaptive& a, const Adaptive& b) {
        return a.exact_ != nullptr || b.exact_ != nullptr;
    }
    bool is_trivial_factor() const {
        return error_ == 0 && (value_ == 0 || value_ == 1 || value_ == -1);
    }

    /// What has left the doubles decides nothing.
    [[gnu::always_inline]] static Adaptive finite(double value, double error) {
        if (!(error <= std::numeric_limits<double>::max() &&
              std::abs(value) <= std::numeric_limits<double>::max())) [[unlikely]]
            leave_open(value, error);
        return Adaptive(value, error);
    }

    static Parts exactly(mpq_class exact) {
        const double value = exact.get_d();
        return {value, std::abs(value) * 2 * half_ulp + smallest_error,
                new Exact{std::move(exact)}};
    }
    [[gnu::noinline]] static void release(Exact* exact) {
        if (--exact->owners == 0)
            delete exact;
    }

    /// Numbers that are worked out from exact ones are exact.
    static std::pair<mpq_class, mpq_class> fractions(const Parts& a, const Parts& b) {
        assert(a.is_known() && b.is_known() && "what begins with exact numbers stays exact");
        return {a.as_fraction(), b.as_fraction()};
    }
    [[gnu::noinline]] static Parts exact_sum(Parts a, Parts b) {
        const auto [p, q] = fractions(a, b);
        return exactly(p + q);
    }
    [[gnu::noinline]] static Parts exact_difference(Parts a, Parts b) {
        const auto [p, q] = fractions(a, b);
        return exactly(p - q);
    }
    [[gnu::noinline]] static Parts exact_product(Parts a, Parts b) {
        const auto [p, q] = fractions(a, b);
        return exactly(p * q);
    }
    [[gnu::noinline]] static Parts exact_quotient(Parts a, Parts b) {
        const auto [p, q] = fractions(a, b);
        return exactly(p / q);
    }

    /// Of numbers that are not known to differ.
    [[gnu::noinline]] static std::optional<std::strong_ordering> order_of_near(Parts a, Parts b) {
        if (!a.is_known() || !b.is_known())
            return std::nullopt;
        return cmp(a.as_fraction(), b.as_fraction()) <=> 0;
    }

    double value_ = 0;
    double error_ = 0;
    Exact* exact_ = nullptr;
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
