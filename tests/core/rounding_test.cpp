// SPDX-License-Identifier: MIT
#include <rastertrace/core/raster/rounding.h>

#include <gtest/gtest.h>

#include <cmath>

namespace rastertrace {
namespace {

TEST(Rounding, OfTheRowInTheTable) {
    const Fraction64 left{-1, 4}, right{25, 8};
    const auto pixels = [&](Rounding rounding) {
        return std::pair(first_pixel(left, {rounding, Ties::up}),
                         last_pixel(right, {rounding, Ties::up}));
    };
    EXPECT_EQ(pixels(Rounding::floor), std::pair(Index{-1}, Index{3}));
    EXPECT_EQ(pixels(Rounding::nearest), std::pair(Index{0}, Index{3}));
    EXPECT_EQ(pixels(Rounding::truncate), std::pair(Index{0}, Index{3}));
    EXPECT_EQ(pixels(Rounding::inside), std::pair(Index{0}, Index{3}));
    EXPECT_EQ(pixels(Rounding::half_open), std::pair(Index{0}, Index{3}));
}

TEST(Rounding, HalfOpenLeavesOutWhatLiesOnTheRightEnd) {
    // T0's row y = 1: from -1 to 7/2; its lowest: from -4 to 5; its top is one point.
    const auto pixels = [](const Fraction64& left, const Fraction64& right) {
        const SpanRounding rule{Rounding::half_open, Ties::up};
        return std::pair(first_pixel(left, rule), last_pixel(right, rule));
    };
    EXPECT_EQ(pixels({-1, 1}, {7, 2}), std::pair(Index{-1}, Index{3}));
    EXPECT_EQ(pixels({-4, 1}, {5, 1}), std::pair(Index{-4}, Index{4}));
    EXPECT_EQ(pixels({2, 1}, {2, 1}), std::pair(Index{2}, Index{1})) << "no pixel";
}

TEST(Rounding, SendsHalvesWhereTiesSays) {
    const auto nearest = [](std::int64_t halves, Ties ties) {
        // As a rational: not in lowest terms where halves is even, which no test here is.
        const Index of_double = nearest_index(static_cast<double>(halves) / 2, ties);
        EXPECT_EQ(nearest_index(Fraction64{halves, 2}, ties), of_double);
        EXPECT_EQ(nearest_index(Rational(halves, 2L), ties), of_double);
        return of_double;
    };
    //                                   -3/2                          -1/2 ...
    EXPECT_EQ(nearest(-3, Ties::start), -2);
    EXPECT_EQ(nearest(-1, Ties::start), -1);
    EXPECT_EQ(nearest(1, Ties::start), 0);
    EXPECT_EQ(nearest(-3, Ties::up), -1);
    EXPECT_EQ(nearest(-1, Ties::up), 0);
    EXPECT_EQ(nearest(1, Ties::up), 1);
    EXPECT_EQ(nearest(-3, Ties::away), -2);
    EXPECT_EQ(nearest(-1, Ties::away), -1);
    EXPECT_EQ(nearest(1, Ties::away), 1);
    EXPECT_EQ(nearest(-3, Ties::even), -2);
    EXPECT_EQ(nearest(-1, Ties::even), 0);
    EXPECT_EQ(nearest(1, Ties::even), 0);
    EXPECT_EQ(nearest(3, Ties::even), 2);
}

TEST(Rounding, IsNotFooledByTheLargestDoubleBelowOneHalf) {
    const double almost_half = std::nextafter(0.5, 0.0); // + 0.5 would round to 1
    EXPECT_EQ(nearest_index(almost_half, Ties::up), 0);
    EXPECT_EQ(nearest_index(-almost_half, Ties::start), 0);
    EXPECT_EQ(nearest_index(-5e-324, Ties::up), 0);
    EXPECT_EQ(nearest_index(1e300, Ties::up), farthest_index);
}

} // namespace
} // namespace rastertrace
