// SPDX-License-Identifier: MIT
// An interval holds what exact arithmetic gives, and what doubles give, whatever is done with it.

#include "effort.h"

#include <rastertrace/core/numbers/interval.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>

namespace rastertrace {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

/// An interval, a number in it that exact arithmetic works with, and one that doubles work with.
struct Held {
    Interval interval;
    Rational exact;
    double near;

    bool holds() const {
        return Rational(interval.low()) <= exact && exact <= Rational(interval.high()) &&
               interval.low() <= near && near <= interval.high();
    }
};

/// Numbers of all sizes up to 2^+-exponents: whole ones, decimals, neighbors, intervals of some width.
class Numbers {
public:
    Numbers(std::uint64_t seed, int exponents) : random_(seed), exponents_(exponents) {}

    std::uint64_t below(std::uint64_t count) { return random_() % count; }

    Held next() {
        Rational exact(static_cast<long>(below(2'000'001)) - 1'000'000,
                       static_cast<long>(below(4) == 0 ? 1 : below(1000) + 1));
        exact.canonicalize();
        const int exponent =
            static_cast<int>(below(static_cast<std::uint64_t>(2 * exponents_ + 1))) - exponents_;
        const Rational power(mpz_class(1) << static_cast<unsigned>(std::abs(exponent)));
        exact = exponent < 0 ? Rational(exact / power) : Rational(exact * power);
        const auto tight = Conversion<Interval>::of(exact);
        if (below(3) > 0 || !tight.is_number())
            return {tight, exact, nearest_double(exact)};
        // Wider, with the exact number at one end and the double at the other.
        const double other =
            tight.middle() + std::abs(tight.middle()) * std::ldexp(1, -static_cast<int>(below(60)));
        const Interval wide(std::min(tight.low(), other), std::max(tight.high(), other));
        return {wide, exact, other};
    }

private:
    std::mt19937_64 random_;
    int exponents_;
};

/// How often numbers were decided about.
struct Count {
    int held = 0;
    int decided = 0;
};

/// Does random operations with random numbers.
Count count_of(std::uint64_t seed, int exponents) {
    Numbers numbers(seed, exponents);
    Count count;
    Held value = numbers.next();
    for (int i = 0; i < 12 && value.interval.is_number(); ++i) {
        const Held other = numbers.next();
        const auto apply = [&](auto operation) {
            value = {operation(value.interval, other.interval),
                     Rational(operation(value.exact, other.exact)),
                     operation(value.near, other.near)};
        };
        try {
            switch (numbers.below(5)) {
            case 0:
                apply([](const auto& a, const auto& b) { return a + b; });
                break;
            case 1:
                apply([](const auto& a, const auto& b) { return a - b; });
                break;
            case 2:
                apply([](const auto& a, const auto& b) { return a * b; });
                break;
            case 3:
                if (other.exact != 0)
                    apply([](const auto& a, const auto& b) { return a / b; });
                break;
            default: // what all but cancels
                value = {value.interval - Interval(value.near), value.exact - Rational(value.near),
                         0};
                break;
            }
        } catch (const Undecided&) {
            return count; // a divisor that may be 0
        }
        if (!value.interval.is_number()) { // beyond the doubles: nothing is decided
            EXPECT_THROW(static_cast<void>(value.interval < other.interval), Undecided);
            EXPECT_THROW(static_cast<void>(value.interval == value.interval), Undecided);
            EXPECT_THROW(floor_index(value.interval), Undecided);
            EXPECT_THROW(require_finite(value.interval), Undecided);
            return count;
        }
        EXPECT_TRUE(value.holds()) << value.interval.low() << " " << value.interval.high();
        ++count.held;

        // What is decided is decided as exact numbers and doubles decide.
        const auto decide = [&](auto question) {
            try {
                const auto found = question(value.interval, other.interval);
                EXPECT_EQ(found, question(value.exact, other.exact));
                EXPECT_EQ(found, question(value.near, other.near));
                ++count.decided;
            } catch (const Undecided& open) {
                EXPECT_FALSE(std::abs(open.difference) > open.error * 1.0001) << "that was decided";
            }
        };
        decide([](const auto& a, const auto& b) { return a < b; });
        decide([](const auto& a, const auto& b) { return a >= b; });
        decide([](const auto& a, const auto& b) { return a == b; });
        decide([](const auto& a, const auto&) { return floor_index(a); });
    }
    return count;
}

TEST(Interval, HoldsTheExactNumberAndThatOfDoubles) {
    Count all;
    for (unsigned seed = 0; seed < random_cases(20000U) && !testing::Test::HasFailure(); ++seed) {
        const Count count = count_of(seed, seed % 2 == 0 ? 3 : 200);
        all.held += count.held;
        all.decided += count.decided;
    }
    EXPECT_GT(all.decided, all.held) << "most comparisons are decided";
}

TEST(Interval, HoldsSubnormalAndHugeNumbers) {
    int held = 0;
    for (unsigned seed = 0; seed < random_cases(5000U) && !testing::Test::HasFailure(); ++seed)
        held += count_of(seed, 1060).held;
    EXPECT_GT(held, random_cases(5000));
}

TEST(Interval, IsNotMuchWiderThanItsRounding) {
    // Every operation moves an end by a unit or two of its last place.
    const Interval third = Interval(1) / Interval(3);
    EXPECT_EQ(third.low(), std::nextafter(1.0 / 3, 0));
    EXPECT_EQ(third.high(), std::nextafter(1.0 / 3, 1));
    EXPECT_EQ((third + third).width() <= 5 * std::numeric_limits<double>::epsilon(), true);
    const auto tenth = Conversion<Interval>::of(Number::decimal(1, -1));
    EXPECT_EQ(tenth.middle(), 0.1);
    EXPECT_EQ(Interval::around(1, 1).low(), std::nextafter(1.0, 0));
    EXPECT_EQ(Interval::around(1, 1).high(), std::nextafter(1.0, 2));
    EXPECT_EQ(Interval::around(-8, -8).low(), std::nextafter(-8.0, -9));
    EXPECT_EQ(Interval::around(-8, -8).high(), std::nextafter(-8.0, 0));
}

TEST(Interval, KeepsExactResultsExact) {
    const Interval half(0.5), three(3), wide(3.1, 3.2);
    EXPECT_TRUE((half + three == Interval(3.5)) && (half - three == Interval(-2.5)));
    EXPECT_TRUE((half * three == Interval(1.5)) && (three / half == Interval(6)));
    EXPECT_FALSE((Interval(1) / three).is_exact());
    EXPECT_FALSE((Interval(1e16) + Interval(1)).is_exact());
    EXPECT_FALSE((Interval(0.1) * Interval(0.1)).is_exact());
    // 0 is exact whatever it is multiplied or divided with, and 1 changes nothing.
    EXPECT_TRUE((Interval(0) / wide).is_exact() && (Interval(0) * wide).is_exact());
    EXPECT_EQ((wide / Interval(1)).width(), wide.width());
}

TEST(Interval, TinyProductsAndQuotientsAreNotZero) {
    for (const Interval& tiny :
         {Interval(smallest) * Interval(0.5), Interval(smallest) / Interval(3),
          Interval(1e-200) * Interval(-1e-200)}) {
        EXPECT_FALSE(tiny.is_exact());
        EXPECT_THROW(static_cast<void>(tiny == Interval(0)), Undecided);
    }
}

TEST(Interval, OverflowDecidesNothing) {
    for (const Interval& beyond :
         {Interval(largest) + Interval(largest), Interval(1e200) * Interval(1e200),
          Interval(1e200) / Interval(1e-200), Interval(0) * (Interval(largest) * Interval(2))}) {
        EXPECT_FALSE(beyond.is_number());
        EXPECT_THROW(static_cast<void>(Interval(0) < beyond), Undecided);
        EXPECT_THROW(static_cast<void>(beyond - beyond == Interval(0)), Undecided);
    }
}

TEST(Interval, ADivisorThatHoldsZeroIsUndecided) {
    for (const Interval& divisor : {Interval(0), Interval(-1, 1), Interval(0, 1), Interval(-1, 0)})
        EXPECT_THROW(static_cast<void>(Interval(1) / divisor), Undecided);
    const Interval quotient = Interval(-1, 2) / Interval(-4, -2);
    EXPECT_LE(quotient.low(), -1);
    EXPECT_GE(quotient.high(), 0.5);
    EXPECT_TRUE(Interval(-1.01) < quotient && quotient < Interval(0.51));
}

TEST(Interval, FloorsNextToWholeNumbers) {
    for (const double whole : {-3.0, -1.0, 0.0, 1.0, 1e6, -1e15})
        for (const double error : {0.0, 1e-300, 1e-20, 1e-10, 0.1, 0.6})
            for (const double off :
                 {0.0, 1e-320, -1e-320, 1e-20, -1e-20, 1e-10, -1e-10, 0.2, -0.2}) {
                const Interval x(whole + off - error, whole + off + error);
                const Index low = floor_index(x.low());
                if (low == floor_index(x.high()))
                    EXPECT_EQ(floor_index(x), low);
                else
                    EXPECT_THROW(floor_index(x), Undecided);
            }
    EXPECT_EQ(floor_index(Interval(1e300, 1e301)), farthest_index);
}

TEST(Interval, HeldBetweenIsNoDecision) {
    const Interval x(1, 4), low(2, 3), high(3, 5);
    const Interval held = held_between(x, low, high);
    EXPECT_EQ(held.low(), 2);
    EXPECT_EQ(held.high(), 4);
}

TEST(Interval, RootsAreHeld) {
    std::mt19937_64 random(5);
    for (int i = 0; i < random_cases(2000); ++i) {
        const double square =
            std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 200) - 150);
        const Interval root = square_root(Interval(square));
        EXPECT_LE(Rational(root.low()) * Rational(root.low()), Rational(square));
        EXPECT_GE(Rational(root.high()) * Rational(root.high()), Rational(square));
    }
}

} // namespace
} // namespace rastertrace
