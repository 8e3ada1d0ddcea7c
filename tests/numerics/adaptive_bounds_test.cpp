// SPDX-License-Identifier: MIT
// The intervals that adaptive works out for depths and colors, attacked: what they are told may be off
// is off, as far as it may be, and the result is held against exact arithmetic.

#include "hill_climb.h"

#include <rastertrace/core/numbers/interval.h>
#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/raster/depth_interpolation.h>
#include <rastertrace/core/raster/mixed_colors.h>
#include <rastertrace/core/raster/triangle.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace rastertrace {
namespace {

constexpr double side = 64; ///< of the square that triangles lie in

/// A number with its error, and the number that it stands for.
struct Known {
    Interval about;
    Rational exact;
};

/// A number that is off by its whole error, upward or downward as the sign of `way` says; or not at all.
Known known(double value, double error, double way) {
    const double off = way < 0 ? -error : error;
    return {Interval(value - error, value + error), Rational(value) + Rational(off)};
}

/// A triangle with a number at each vertex: six places and three numbers from 1 on, and nine ways.
struct KnownTriangle {
    std::array<Vec<Interval, 2>, 3> about;
    std::array<Vec<Rational, 2>, 3> exact;
    std::array<Interval, 3> numbers_about;
    std::array<Rational, 3> numbers;
};
using Inputs = std::array<double, 20>;
KnownTriangle known_triangle(const Inputs& in, double error) {
    KnownTriangle result;
    for (std::size_t i = 0; i < 3; ++i) {
        const Known x = known(in[2 * i], error * side, in[9 + 2 * i]);
        const Known y = known(in[2 * i + 1], error * side, in[10 + 2 * i]);
        const Known number = known(1 + std::abs(in[6 + i]), error * side, in[15 + i]);
        result.about[i] = {x.about, y.about};
        result.exact[i] = {x.exact, y.exact};
        result.numbers_about[i] = number.about;
        result.numbers[i] = number.exact;
    }
    return result;
}

const Rational exact_half(1, 2);

/// A pixel in the triangle, at the share of two inputs of its sides; nothing if its sample is outside.
std::optional<Pixel> pixel_in(const KnownTriangle& triangle, const Inputs& in) {
    const double s = std::abs(in[18]) / side;
    const double t = (1 - s) * std::abs(in[19]) / side;
    const auto& [a, b, c] = triangle.about;
    const auto at = [s, t](Interval from, Interval to, Interval other) {
        return static_cast<int>(std::floor(from.middle() + s * (to.middle() - from.middle()) +
                                           t * (other.middle() - from.middle())));
    };
    const Pixel pixel{at(a.x, b.x, c.x), at(a.y, b.y, c.y)};
    const Barycentric<Rational> barycentric({triangle.exact});
    if (barycentric.area2() == 0)
        return std::nullopt;
    for (const Rational& weight :
         barycentric.weights_at({pixel.x + exact_half, pixel.y + exact_half}))
        if (weight < 0)
            return std::nullopt;
    return pixel;
}

/// How far the exact number lies from the middle, over half the width. An interval without numbers
/// says nothing, and is right.
std::optional<double> part_of_bound(const Interval& about, const Rational& exact) {
    if (!about.is_number())
        return std::nullopt;
    if (about.is_exact())
        return exact == Rational(about.low()) ? std::nullopt : std::optional(2.0);
    const Rational off = abs(Rational(about.low()) + Rational(about.high()) - 2 * exact);
    return nearest_double(off / (Rational(about.high()) - Rational(about.low())));
}

/// With numbers that are exact, and with numbers that are off by more than rounding does.
class BoundsOfAdaptive : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Errors, BoundsOfAdaptive, testing::Values(0.0, 0x1p-50, 0x1p-20));

TEST_P(BoundsOfAdaptive, DepthsOfATriangle) {
    const double found = worst<double, 20>(
        [](const Inputs& in) -> std::optional<double> {
            const KnownTriangle triangle = known_triangle(in, GetParam());
            const auto pixel = pixel_in(triangle, in);
            if (!pixel)
                return std::nullopt;
            try {
                const DepthPlane<Interval> about(triangle.about, triangle.numbers_about,
                                                 {Interval(0.5), Interval(0.5)});
                const DepthPlane<Rational> exact(triangle.exact, triangle.numbers,
                                                 {exact_half, exact_half});
                return part_of_bound(about.on_row(pixel->y).at(pixel->x),
                                     exact.on_row(pixel->y).at(pixel->x));
            } catch (const Undecided&) {
                return std::nullopt; // it may have no area
            }
        },
        side);
    EXPECT_GT(found, 0.02);
}

TEST_P(BoundsOfAdaptive, DepthsOfAnEdge) {
    const double found = worst<double, 20>(
        [](const Inputs& in) -> std::optional<double> {
            const KnownTriangle edge = known_triangle(in, GetParam());
            const auto& [a, b, other] = edge.exact;
            const double part = std::abs(in[18]) / side;
            const int y = static_cast<int>(std::floor(in[1] + part * (in[3] - in[1])));
            if (a.y == b.y || y < std::min(a.y, b.y) || y > std::max(a.y, b.y))
                return std::nullopt;
            try {
                const DepthEdge<Interval> about(edge.about[0].y, edge.numbers_about[0],
                                                edge.about[1].y, edge.numbers_about[1]);
                const DepthEdge<Rational> exact(a.y, edge.numbers[0], b.y, edge.numbers[1]);
                return part_of_bound(about.at(scalar_from<Interval>(y)), exact.at(Rational(y)));
            } catch (const Undecided&) {
                return std::nullopt; // it may be horizontal
            }
        },
        side);
    EXPECT_GT(found, 0.2);
}

TEST_P(BoundsOfAdaptive, DepthsOfARow) {
    // Also where the row is narrower than its ends are off, and in pixels beyond its ends.
    for (const double narrow : {1.0, 0x1p-18, 0x1p-46}) {
        if (narrow < GetParam())
            continue; // no row is wider than its ends may be off
        const double found = worst<double, 20>(
            [narrow](const Inputs& in) -> std::optional<double> {
                const KnownTriangle ends = known_triangle(in, GetParam());
                const Known right = known(in[0] + narrow * in[2], GetParam() * side, in[11]);
                try {
                    const auto about = row_between(ends.about[0].x, ends.numbers_about[0],
                                                   right.about, ends.numbers_about[1]);
                    const auto exact = row_between<Rational>(ends.exact[0].x, ends.numbers[0],
                                                             right.exact, ends.numbers[1]);
                    const int x =
                        static_cast<int>(std::floor(in[0] + in[18] / side * narrow * side)) +
                        (in[19] < 0 ? 1 : 0);
                    return part_of_bound(about.at(x), exact.at(x));
                } catch (const Undecided&) {
                    return std::nullopt; // it may have no width
                }
            },
            side);
        EXPECT_GT(found, 0.2) << narrow;
    }
}

/// The worst level of a triangle's pixels. A pixel may lie beside the triangle, as the rules have it.
template <bool in_perspective> double worst_level(double error) {
    return worst<double, 20>(
        [error](const Inputs& in) -> std::optional<double> {
            const KnownTriangle triangle = known_triangle(in, error);
            auto pixel = pixel_in(triangle, in);
            if (!pixel)
                return std::nullopt;
            pixel->x += in[9] < -side / 2 ? -1 : in[9] > side / 2 ? 1 : 0;
            std::array<Color, 3> corners;
            for (std::size_t i = 0; i < 3; ++i)
                corners[i] = {static_cast<std::uint8_t>(std::abs(in[12 + i]) / side * 255), 0, 0};
            if (corners[0] == corners[1] && corners[0] == corners[2])
                return std::nullopt;

            // The level before it is rounded.
            const auto level_of = [&](const auto& colors, const auto& weights, auto level) {
                colors.mixed(weights, [&level](const auto& mixed) {
                    level = mixed;
                    return std::uint8_t{0};
                });
                return level;
            };
            try {
                const Interval half(0.5);
                const MixedColors<Interval> about{corners,
                                                  Barycentric<Interval>({triangle.about}),
                                                  {half, half},
                                                  triangle.numbers_about};
                const MixedColors<Rational> exact{corners,
                                                  Barycentric<Rational>({triangle.exact}),
                                                  {exact_half, exact_half},
                                                  triangle.numbers};
                auto weights = about.on_screen(*pixel);
                auto exact_weights = exact.on_screen(*pixel);
                if constexpr (in_perspective) {
                    weights = about.in_space(weights);
                    exact_weights = exact.in_space(exact_weights);
                }
                return part_of_bound(level_of(about, weights, Interval(0)),
                                     level_of(exact, exact_weights, Rational()));
            } catch (const Undecided&) {
                return std::nullopt; // it may have no area, or its pixel no weights in space
            }
        },
        side);
}

TEST_P(BoundsOfAdaptive, LevelsMixedOnTheScreen) {
    EXPECT_GT(worst_level<false>(GetParam()), 0.01);
}

TEST_P(BoundsOfAdaptive, LevelsMixedInSpace) {
    EXPECT_GT(worst_level<true>(GetParam()), 0.0005);
}

} // namespace
} // namespace rastertrace
