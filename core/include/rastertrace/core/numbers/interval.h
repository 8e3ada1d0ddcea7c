// SPDX-License-Identifier: MIT
#pragma once

// An interval of two doubles: it holds the number that exact arithmetic gives, and every number that
// the same operations give in double. A comparison or a floor that is not the same for all numbers of
// its intervals throws Undecided. Where nothing is thrown, doubles decide as exact numbers do.
//
//     const Interval third = Interval(1) / Interval(3);
//     third < Interval(0.5);              // true
//     third * Interval(3) < Interval(1);  // throws Undecided
//
// Source: Moore 1966. Each end is rounded to the nearest double and moved outward to the next one
// (Rump et al. 2009), unless the result is exact (of sums: Knuth, two-sum).

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/quantity.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rastertrace {

/// Thrown if intervals leave it open how two numbers compare.
struct Undecided {
    double difference; ///< of the two numbers, in doubles
    double error;      ///< that the difference may be off by
};

/// The numbers from `low` to `high`. Both are finite, or both are NaN: what overflows decides nothing.
class Interval {
    using Limits = std::numeric_limits<double>;

public:
    Interval() = default;
    explicit Interval(double number) : Interval(number, number) {}
    Interval(double low, double high) : low_(low), high_(high) {}

    /// The interval whose ends were rounded to these.
    [[gnu::always_inline]] static inline Interval around(double low, double high) {
        const Interval wide(low - unit_of(low), high + unit_of(high));
        const bool is_finite = wide.high_ - wide.low_ <= Limits::max();
        return is_finite ? wide : Interval(Limits::quiet_NaN());
    }

    double low() const { return low_; }
    double high() const { return high_; }
    double middle() const { return low_ == high_ ? low_ : low_ / 2 + high_ / 2; }
    bool is_number() const { return low_ <= high_; }
    bool is_exact() const { return low_ == high_; }

    /// The distance between the ends, or a little more.
    double width() const { return is_exact() ? 0 : high_ - low_ + unit_of(high_ - low_); }

    /// A trace has the middle.
    operator Quantity() const { return middle(); } // NOLINT: as every number is

    [[gnu::always_inline]] friend inline Interval operator+(Interval a, Interval b) {
        const double low = a.low_ + b.low_;
        const double high = a.high_ + b.high_;
        const bool is_exact = low == high ? is_exact_sum(a, b, low) : a.is(0) || b.is(0);
        return is_exact ? Interval(low, high) : around(low, high);
    }
    friend Interval operator-(Interval a) { return {-a.high_, -a.low_}; }
    [[gnu::always_inline]] friend inline Interval operator-(Interval a, Interval b) {
        return a + -b;
    }
    [[gnu::always_inline]] friend inline Interval operator*(Interval a, Interval b) {
        const double p = a.low_ * b.low_, q = a.low_ * b.high_;
        const double r = a.high_ * b.low_, s = a.high_ * b.high_;
        const double low = std::min(std::min(p, q), std::min(r, s));
        const double high = std::max(std::max(p, q), std::max(r, s));
        const bool is_exact = low == high ? is_exact_product(a, b) : a.is_one() || b.is_one();
        return is_exact ? Interval(low, high) : around(low, high);
    }
    /// Throws Undecided if b may be 0.
    [[gnu::always_inline]] friend inline Interval operator/(Interval a, Interval b) {
        if (!(b.low_ > 0 || b.high_ < 0)) [[unlikely]]
            leave_open(b, Interval(0));
        const bool is_negative = b.high_ < 0;
        const Interval above = is_negative ? -a : a;
        const Interval below = is_negative ? -b : b;
        const double low = above.low_ / (above.low_ < 0 ? below.low_ : below.high_);
        const double high = above.high_ / (above.high_ < 0 ? below.high_ : below.low_);
        const bool is_exact = low == high ? above.is_exact() && low * below.low_ == above.low_ &&
                                                is_exact_product(Interval(low), below)
                                          : below.is(1);
        return is_exact ? Interval(low, high) : around(low, high);
    }
    [[gnu::always_inline]] Interval& operator+=(Interval b) { return *this = *this + b; }

    // Comparisons throw Undecided.
    [[gnu::always_inline]] friend inline bool operator<(Interval a, Interval b) {
        if (!(a.high_ < b.low_ || a.low_ >= b.high_)) [[unlikely]]
            leave_open(a, b);
        return a.high_ < b.low_;
    }
    friend bool operator>(Interval a, Interval b) { return b < a; }
    friend bool operator<=(Interval a, Interval b) { return !(b < a); }
    friend bool operator>=(Interval a, Interval b) { return !(a < b); }
    [[gnu::always_inline]] friend inline bool operator==(Interval a, Interval b) {
        const bool differ = a.high_ < b.low_ || b.high_ < a.low_;
        if (!differ && !(a.is_exact() && b.is(a.low_))) [[unlikely]]
            leave_open(a, b);
        return !differ;
    }

    [[noreturn, gnu::noinline, gnu::cold]] static void leave_open(Interval a, Interval b) {
        const double low = a.low_ - b.high_;
        const double high = a.high_ - b.low_;
        throw Undecided{low / 2 + high / 2, high / 2 - low / 2};
    }

private:
    bool is(double number) const { return low_ == number && high_ == number; }
    bool is_one() const { return is_exact() && std::abs(low_) == 1; } ///< or -1

    /// What leads from a double to the next one, or a little farther. Half a unit in the last place
    /// would be a tie where the number is a power of two.
    static double unit_of(double number) {
        return std::abs(number) * (Limits::epsilon() / 2 * (1 + Limits::epsilon())) + Limits::min();
    }

    static bool is_exact_sum(Interval a, Interval b, double sum) {
        const double of_b = sum - a.low_;
        return a.is_exact() && b.is_exact() && (a.low_ - (sum - of_b)) + (b.low_ - of_b) == 0;
    }
    /// By 0, 1 and -1, as most entries of matrices are, and of two numbers that a float could hold.
    static bool is_exact_product(Interval a, Interval b) {
        const auto is_short = [](Interval x) {
            return std::abs(x.low_) < 0x1p127 && static_cast<float>(x.low_) == x.low_;
        };
        const auto is_trivial = [](Interval x) { return x.low_ * x.low_ == std::abs(x.low_); };
        return a.is(0) || b.is(0) ||
               (a.is_exact() && b.is_exact() &&
                (is_trivial(a) || is_trivial(b) || (is_short(a) && is_short(b))));
    }

    double low_ = 0;
    double high_ = 0;
};

template <> struct NumberTraits<Interval> : PlainNumber<Interval> {
    static Interval from(Index whole) {
        const auto near = static_cast<double>(whole);
        return std::abs(whole) <= farthest_index ? Interval(near) : Interval::around(near, near);
    }
    /// Throws Undecided.
    [[gnu::always_inline]] static inline Index floor(Interval x) {
        using OfDouble = NumberTraits<double>;
        if (!x.is_number() || OfDouble::floor(x.low()) != OfDouble::floor(x.high())) [[unlikely]]
            Interval::leave_open(x, Interval(std::floor(x.high())));
        return OfDouble::floor(x.low());
    }
};

/// A typed or computed number: itself if it is a double, else its neighbors among them.
template <> struct Conversion<Interval> {
    static Interval of(const Rational& exact) {
        const double near = nearest_double(exact);
        const bool is_exact = std::isfinite(near) && Rational(near) == exact;
        return is_exact ? Interval(near) : Interval::around(near, near);
    }
    static Interval of(const Number& number) {
        const double near = number.nearest_double();
        return number.is_exactly(near) ? Interval(near) : Interval::around(near, near);
    }
    static Interval of(Interval number) { return number; }
};

/// Numbers that are rounded to doubles, or bound those.
template <typename Scalar>
concept Rounded = std::floating_point<Scalar> || std::same_as<Scalar, Interval>;

inline double to_double(Interval number) {
    return number.middle();
}
inline double error_of(Interval number) {
    return number.width();
}

// What scalar.h and conversion.h ask of a number.
inline void require_finite(Interval number) {
    if (!number.is_number())
        Interval::leave_open(number, number);
}
inline bool surely_differ(Interval a, Interval b) {
    return a.high() < b.low() || b.high() < a.low();
}
inline bool are_not_all_equal(Interval a, Interval b, Interval c) {
    return surely_differ(a, b) || surely_differ(a, c) || a != b || a != c;
}
inline bool may_differ(Interval a, Interval b) {
    return !(a.is_exact() && b.is_exact() && a.low() == b.low());
}
inline Interval held_between(Interval x, Interval low, Interval high) {
    require_finite(low);
    require_finite(high);
    require_finite(x);
    return {std::min(std::max(x.low(), low.low()), high.low()),
            std::min(std::max(x.high(), low.high()), high.high())};
}
inline Interval square_root(Interval square) {
    return Interval::around(std::sqrt(std::max(square.low(), 0.0)), std::sqrt(square.high()));
}

} // namespace rastertrace
