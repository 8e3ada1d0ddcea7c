// SPDX-License-Identifier: MIT
#pragma once

// How a bound is attacked: from random inputs the search climbs to those with a larger error against
// the bound, moving one number by a few last places or to another size.

#include <rastertrace/core/numbers/conversion.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string>

namespace rastertrace {

/// The worst inputs found by hill-climbing: `error_over_bound` gives their error as a part of the
/// bound, or nothing if they are no inputs. Fails as soon as that is more than 1.
template <typename Scalar, std::size_t count>
double worst(
    const std::function<std::optional<double>(const std::array<Scalar, count>&)>& error_over_bound,
    double largest, int climbs = 30, int steps = 400) {
    std::mt19937_64 random(20220705);
    const auto uniform = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto draw = [&]() -> Scalar {
        const auto value = static_cast<Scalar>(uniform(-largest, largest));
        // Whole numbers, short ones and small ones are where rounding is different.
        switch (random() % 4) {
        case 0:
            return std::floor(value);
        case 1:
            return std::floor(value * 16) / 16;
        case 2:
            return static_cast<Scalar>(value * std::exp2(uniform(-12, 0)));
        default:
            return value;
        }
    };
    double best = 0;
    for (int climb = 0; climb < climbs; ++climb) {
        std::array<Scalar, count> at;
        for (Scalar& one : at)
            one = draw();
        double here = error_over_bound(at).value_or(-1);
        for (int step = 0; step < steps; ++step) {
            std::array<Scalar, count> next = at;
            Scalar& moved = next[random() % count];
            if (random() % 3 == 0)
                moved = draw();
            else
                for (std::uint64_t i = 0; i <= random() % 8; ++i)
                    moved =
                        std::nextafter(moved, random() % 2 == 0 ? static_cast<Scalar>(largest)
                                                                : static_cast<Scalar>(-largest));
            const double there = error_over_bound(next).value_or(-1);
            EXPECT_LE(there, 1) << "the bound is broken";
            if (there > 1)
                return there;
            if (there >= here) {
                at = next;
                here = there;
            }
        }
        best = std::max(best, here);
    }
    testing::Test::RecordProperty("worst", std::to_string(best));
    return best;
}

template <typename Scalar> Rational exact(Scalar value) {
    return Rational(static_cast<double>(value));
}
inline double magnitude(const Rational& value) {
    return std::abs(nearest_double(value));
}

} // namespace rastertrace
