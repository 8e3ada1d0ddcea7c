// SPDX-License-Identifier: MIT
#pragma once

// A filtered double: a double with an error bound. A comparison that the bound leaves undecided
// throws Undecided, and is done again with exact numbers (draw/filtered/exactly.h). So every
// decision is the one of exact arithmetic.
//
//     const Adaptive third = Adaptive(1) / Adaptive(3);  // 0.333..., error at most 2^-54
//     third < Adaptive(0.5);                             // true
//     third * Adaptive(3) < Adaptive(1);                 // throws Undecided
//
// Each operation adds its rounding error to the bound: half a unit in the last place of its result
// (IEEE 754); of a sum the error itself, which is a double (two-sum: Knuth; Shewchuk 1997, theorem
// 7). Bounds are rounded too, and are widened for that. Floating-point filters with exact
// arithmetic: Fortune and Van Wyk 1993; CGAL's Filtered_kernel.

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/quantity.h>

#include <cmath>
#include <compare>
#include <limits>
#include <optional>

namespace rastertrace {

/// Thrown if an error bound leaves the order of two numbers undecided.
struct Undecided {
    double difference; ///< of the two numbers, in doubles
    double error;      ///< the error bound of the difference
};

/// A double and a bound on its distance from the exact number. Two doubles wide, so that it is
/// passed in registers. After an overflow the bound is infinite or NaN, and decides nothing.
class Adaptive {
public:
    Adaptive() = default;

    /// A double with an error of at most `error`.
    explicit Adaptive(double value, double error = 0) : value_(value), error_(error) {}

    double value() const { return value_; }
    double error() const { return error_; }

    /// A trace has the double.
    operator Quantity() const { return value_; } // NOLINT: as every number is

    [[gnu::always_inline]] friend inline Adaptive operator+(Adaptive a, Adaptive b) {
        const double sum = a.value_ + b.value_;
        const double of_b = sum - a.value_;
        const double rounded_off = (a.value_ - (sum - of_b)) + (b.value_ - of_b);
        return Adaptive(sum, (a.error_ + b.error_ + std::abs(rounded_off)) * widening);
    }

    friend Adaptive operator-(Adaptive a) { return Adaptive(-a.value_, a.error_); }

    [[gnu::always_inline]] friend inline Adaptive operator-(Adaptive a, Adaptive b) {
        return a + -b;
    }

    [[gnu::always_inline]] friend inline Adaptive operator*(Adaptive a, Adaptive b) {
        const double product = a.value_ * b.value_;
        const double of_factors =
            std::abs(a.value_) * b.error_ + std::abs(b.value_) * a.error_ + a.error_ * b.error_;
        // A factor of 0 or 1, as most entries of matrices are, rounds nothing.
        const double rounded_off = a.is_trivial_factor() || b.is_trivial_factor()
                                       ? 0
                                       : std::abs(product) * half_ulp + smallest_error;
        return Adaptive(product, (of_factors + rounded_off) * widening);
    }

    /// b must not be 0.
    friend Adaptive operator/(Adaptive a, Adaptive b) {
        const double quotient = a.value_ / b.value_;
        // (a + da)/(b + db) - a/b = (da - (a/b) db)/(b + db).
        const double nearest_to_zero = (std::abs(b.value_) - b.error_) / widening;
        if (!(nearest_to_zero > smallest_divisor)) [[unlikely]]
            leave_open(b.value_, b.error_);
        // 0/b and a/1 are exact: a typed coordinate of 0, and a w of 1.
        if ((a.value_ == 0 && a.error_ == 0) || (b.value_ == 1 && b.error_ == 0))
            return a;
        // The product may underflow, and the divisor may be smaller still.
        const double of_terms = (a.error_ + std::abs(quotient) * b.error_ + smallest_product) *
                                widening / nearest_to_zero;
        return Adaptive(quotient,
                        (of_terms + std::abs(quotient) * half_ulp + smallest_error) * widening);
    }

    Adaptive& operator+=(Adaptive b) { return *this = *this + b; }

    /// start + slope (at - from): the same double as with the operators, with one bound for all
    /// three.
    [[gnu::always_inline]] friend inline Adaptive linear(Adaptive start, Adaptive slope,
                                                         Adaptive at, Adaptive from) {
        const double way = at.value_ - from.value_;
        const double rise = slope.value_ * way;
        const double value = start.value_ + rise;
        const double of_way = at.error_ + from.error_ + std::abs(way) * half_ulp;
        const double of_rise = (std::abs(slope.value_) + slope.error_) * of_way +
                               slope.error_ * std::abs(way) + smallest_error;
        return Adaptive(value,
                        (start.error_ + of_rise + (std::abs(rise) + std::abs(value)) * half_ulp) *
                            widening);
    }

    /// The order of two numbers. Returns nullopt if it is undecided.
    [[gnu::always_inline]] friend inline std::optional<std::strong_ordering> order_of(Adaptive a,
                                                                                      Adaptive b) {
        const double difference = a.value_ - b.value_;
        const double error = a.error_ + b.error_;
        if (std::abs(difference) > error * widening) [[likely]]
            return difference < 0 ? std::strong_ordering::less : std::strong_ordering::greater;
        if (error == 0)
            return std::strong_ordering::equal;
        return std::nullopt;
    }

    friend bool operator==(Adaptive a, Adaptive b) { return (a <=> b) == 0; }

    /// Throws Undecided.
    [[gnu::always_inline]] friend inline std::strong_ordering operator<=>(Adaptive a, Adaptive b) {
        const auto order = order_of(a, b);
        if (!order) [[unlikely]]
            leave_open(a.value_ - b.value_, a.error_ + b.error_);
        return *order;
    }

    /// Throws Undecided.
    [[noreturn, gnu::noinline, gnu::cold]] static void leave_open(double difference, double error) {
        throw Undecided{difference, error};
    }

    /// Half a unit in the last place of 1: 2^-53.
    static constexpr double half_ulp = std::numeric_limits<double>::epsilon() / 2;

    /// The factor that covers the rounding of a bound that is a sum of fewer than a dozen terms.
    static constexpr double widening = 1 + 16 * std::numeric_limits<double>::epsilon();

    /// More than the rounding error of any subnormal result.
    static constexpr double smallest_error = 0x1p-1000;

private:
    static constexpr double smallest_divisor = 0x1p-900;
    static constexpr double smallest_product = std::numeric_limits<double>::min();

    /// True for 0, 1 and -1: their squares are their magnitudes.
    bool is_trivial_factor() const { return error_ == 0 && value_ * value_ == std::abs(value_); }

    double value_ = 0;
    double error_ = 0;
};

/// The error bound of a difference of two products p q, where `p` and `q` bound the magnitudes and
/// `of_p` and `of_q` the errors. Both products are rounded, and their difference, which may be
/// twice as large.
inline double error_of_products(double p, double of_p, double q, double of_q) {
    return (2 * (p * of_q + q * of_p + of_p * of_q) + 4 * Adaptive::half_ulp * p * q +
            Adaptive::smallest_error) *
           Adaptive::widening;
}

/// The double nearest to a number, which is not exact: its error is half a unit in the last place,
/// of subnormal numbers half of the smallest one.
inline Adaptive rounded_to(double nearest) {
    return Adaptive(nearest, std::abs(nearest) * Adaptive::half_ulp +
                                 std::numeric_limits<double>::denorm_min());
}

template <> struct NumberTraits<Adaptive> : PlainNumber<Adaptive> {
    static Adaptive from(Index whole) {
        return std::abs(whole) <= (Index{1} << 53) ? Adaptive(static_cast<double>(whole))
                                                   : rounded_to(static_cast<double>(whole));
    }

    /// Throws Undecided if the interval holds an integer above its lower end, or lies beyond the
    /// indices.
    [[gnu::always_inline]] static inline Index floor(Adaptive x) {
        if (!(std::abs(x.value()) < static_cast<double>(farthest_index))) [[unlikely]] {
            if (x.error() == 0)
                return floor_index(x.value());
            Adaptive::leave_open(x.value(), x.error());
        }
        const auto toward_zero = static_cast<Index>(x.value());
        const Index index =
            static_cast<double>(toward_zero) > x.value() ? toward_zero - 1 : toward_zero;

        // The distances to the integers on both sides: exact where they are less than a half.
        const auto below = static_cast<double>(index);
        const double from_below = x.value() - below;
        const double to_next = below + 1 - x.value();
        const double error = x.error() * Adaptive::widening;
        if (!(error <= from_below && error < to_next)) [[unlikely]]
            Adaptive::leave_open(from_below < to_next ? from_below : -to_next, x.error());
        return index;
    }
};

/// The nearest double, with its error bound.
template <> struct Conversion<Adaptive> {
    static Adaptive of(const Rational& exact) {
        const double value = nearest_double(exact);
        return std::isfinite(value) && Rational(value) == exact ? Adaptive(value)
                                                                : rounded_to(value);
    }
    static Adaptive of(const Number& number) {
        const double value = number.nearest_double();
        return number.is_exactly(value) ? Adaptive(value) : rounded_to(value);
    }
    static Adaptive of(Adaptive number) { return number; }
};

/// True of filtered doubles: a decision may be left open.
template <typename Scalar> inline constexpr bool is_filtered = std::same_as<Scalar, Adaptive>;

/// A typed or computed number as a filtered double.
template <typename Coordinate> Adaptive with_error(const Coordinate& number) {
    return Conversion<Adaptive>::of(number);
}

inline double to_double(Adaptive number) {
    return number.value();
}

inline double error_of(Adaptive number) {
    return number.error();
}

/// Throws Undecided after an overflow.
inline void require_finite(Adaptive number) {
    if (!std::isfinite(number.value()) || !std::isfinite(number.error()))
        Adaptive::leave_open(number.value(), number.error());
}

/// Throws Undecided if the integer above the number is undecided.
inline void require_certain_index(Adaptive number) {
    static_cast<void>(ceil_index(number));
}

/// True if two numbers differ for certain.
inline bool surely_differ(Adaptive a, Adaptive b) {
    const auto order = order_of(a, b);
    return order && *order != 0;
}

/// False if two numbers are equal for certain.
inline bool may_differ(Adaptive a, Adaptive b) {
    const auto order = order_of(a, b);
    return !order || *order != 0;
}

} // namespace rastertrace
