// SPDX-License-Identifier: MIT
// The bounds of bounds.h, attacked: from random inputs the search climbs to those with a
// larger error against the bound, moving one number by a few last places or to another size. No step
// may pass the bound; and it must come near enough to show that the bound says something.

#include "bounds.h"
#include "hill_climb.h"

#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/mixed_colors.h>
#include <rastertrace/numerics/knobs.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

namespace rastertrace {
namespace {

template <typename Scalar> class Bounds : public testing::Test {};
using Floats = testing::Types<float, double>;
TYPED_TEST_SUITE(Bounds, Floats);

/// An edge x1, y1, x2, y2 and a row, and what is exact there.
template <typename Scalar> struct EdgeAtRow {
    Edge<Scalar> edge;
    Vec<Scalar, 2> end;
    int y = 0;
    Rational x, offset, slope;
};
template <typename Scalar>
std::optional<EdgeAtRow<Scalar>> edge_at_row(const std::array<Scalar, 5>& in, double largest) {
    EdgeAtRow<Scalar> result;
    const auto& [x1, y1, x2, y2, share] = in;
    const auto lowest = static_cast<double>(std::min(y1, y2));
    const auto highest = static_cast<double>(std::max(y1, y2));
    // The row is an input too: where between the two ends it lies.
    const double part = std::abs(static_cast<double>(share)) / largest;
    result.y = static_cast<int>(std::ceil(lowest + part * (highest - lowest)));
    if (!(lowest < highest) || result.y > highest || part > 1)
        return std::nullopt;
    result.edge = edge_between(Vertex<Scalar>{{x1, y1}}, Vertex<Scalar>{{x2, y2}});
    result.end = {x2, y2};
    result.slope = (exact(x2) - exact(x1)) / (exact(y2) - exact(y1));
    result.offset = result.slope * (Rational(result.y) - exact(y1));
    result.x = exact(x1) + result.offset;
    return result;
}

/// The worst that one way to find x does on one row of an edge.
template <typename Scalar, typename XOf, typename BoundOf>
double worst_on_a_row(const XOf& x_of, const BoundOf& bound_of) {
    return worst<Scalar, 5>(
        [&](const std::array<Scalar, 5>& in) -> std::optional<double> {
            const auto at = edge_at_row(in, 2048);
            if (!at)
                return std::nullopt;
            const double bound = bound_of(*at);
            const double error = magnitude(exact(Scalar(x_of(*at))) - at->x);
            return bound == 0 ? std::nullopt : std::optional(error / bound);
        },
        2048);
}

TYPED_TEST(Bounds, DirectEdge) {
    using Scalar = TypeParam;
    EXPECT_GT(
        worst_on_a_row<Scalar>(
            [](const EdgeAtRow<Scalar>& at) { return at.edge.x_at(static_cast<Scalar>(at.y)); },
            [](const EdgeAtRow<Scalar>& at) {
                return direct_bound<Scalar>(magnitude(at.x), magnitude(at.offset));
            }),
        0.4);
}

TYPED_TEST(Bounds, WeightedEdge) {
    using Scalar = TypeParam;
    EXPECT_GT(worst_on_a_row<Scalar>(
                  [](const EdgeAtRow<Scalar>& at) {
                      return WeightedWalk<Scalar>(at.edge.start, at.end).x_on_row(at.y);
                  },
                  [](const EdgeAtRow<Scalar>& at) {
                      return weighted_bound<Scalar>(static_cast<double>(at.edge.start.x),
                                                    static_cast<double>(at.end.x));
                  }),
              0.3);
}

TYPED_TEST(Bounds, IncrementalEdge) {
    using Scalar = TypeParam;
    const double found = worst<Scalar, 5>(
        [](const std::array<Scalar, 5>& in) -> std::optional<double> {
            const auto at = edge_at_row(in, 256);
            if (!at || in[1] > in[3])
                return std::nullopt;
            // From the upper vertex's row down to `at->y`.
            const int first = static_cast<int>(std::ceil(in[1]));
            if (at->y - first < 20)
                return std::nullopt;
            ReseededWalk<Scalar> walk(at->edge, 1, without_end);
            Scalar x = walk.x_on_row(first);
            double largest = 0;
            for (int y = first + 1; y <= at->y; ++y) {
                x = walk.x_on_row(y);
                largest = std::max(largest, std::abs(static_cast<double>(x)));
            }
            const Rational first_offset = at->slope * (Rational(first) - exact(in[1]));
            const double bound = incremental_bound<Scalar>(
                at->y - first, magnitude(at->slope), largest,
                direct_bound<Scalar>(magnitude(exact(in[0]) + first_offset),
                                     magnitude(first_offset)));
            return bound == 0 ? std::nullopt : std::optional(magnitude(exact(x) - at->x) / bound);
        },
        256, 12, 250);
    EXPECT_GT(found, 0.3);
}

/// The exponent k of the growth c n^k that fits errors best, by least squares of logarithms.
double exponent_of(const std::vector<double>& n, const std::vector<double>& errors) {
    double mean_x = 0;
    double mean_y = 0;
    for (std::size_t i = 0; i < n.size(); ++i) {
        mean_x += std::log(n[i]) / static_cast<double>(n.size());
        mean_y += std::log(errors[i]) / static_cast<double>(n.size());
    }
    double above = 0;
    double below = 0;
    for (std::size_t i = 0; i < n.size(); ++i) {
        above += (std::log(n[i]) - mean_x) * (std::log(errors[i]) - mean_y);
        below += (std::log(n[i]) - mean_x) * (std::log(n[i]) - mean_x);
    }
    return above / below;
}

/// The largest error after n rows over many slopes, for edges from (x0, 0), for n = 64 ... 16384.
template <typename Scalar> double growth(double x0) {
    std::mt19937_64 random(7);
    std::vector<double> lengths;
    std::vector<double> errors;
    for (int n = 64; n <= 16'384; n *= 2) {
        double largest = 0;
        for (int edge = 0; edge < 60; ++edge) {
            const auto dx =
                static_cast<Scalar>(std::uniform_real_distribution<double>(0.4, 0.6)(random) * n);
            const Edge<Scalar> at = edge_between(
                Vertex<Scalar>{{static_cast<Scalar>(x0), 0}},
                Vertex<Scalar>{{static_cast<Scalar>(x0) + dx, static_cast<Scalar>(n)}});
            ReseededWalk<Scalar> walk(at, 1, without_end);
            Scalar x{};
            for (int y = 0; y <= n; ++y)
                x = walk.x_on_row(y);
            const Rational end = exact(static_cast<Scalar>(static_cast<Scalar>(x0) + dx));
            largest = std::max(largest, magnitude(exact(x) - end));
        }
        lengths.push_back(n);
        errors.push_back(largest);
    }
    return exponent_of(lengths, errors);
}

TYPED_TEST(Bounds, IncrementalErrorGrowsWithNFarFromZeroAndWithNSquaredNearIt) {
    // Beside 2^20, what n steps add is nothing: every sum rounds a number of the same size.
    EXPECT_NEAR(growth<TypeParam>(0x1p20), 1, 0.15);
    // From 0 on, the numbers that are rounded grow with n themselves.
    EXPECT_NEAR(growth<TypeParam>(0), 2, 0.25);
}

TEST(BoundsOfFixedPoint, TruncatedSlope) {
    for (const int bits : {0, 4, 8, 12, 16}) {
        const double unit = std::ldexp(1, bits);
        const double found = worst<double, 5>(
            [bits, unit](const std::array<double, 5>& in) -> std::optional<double> {
                std::array<double, 5> on_grid = in;
                for (std::size_t i = 0; i < 4; ++i)
                    on_grid[i] = std::floor(in[i] * unit) / unit;
                const auto at = edge_at_row(on_grid, 512);
                if (!at)
                    return std::nullopt;
                const auto whole = [unit](double x) { return static_cast<std::int64_t>(x * unit); };
                FixedPointWalk<std::int64_t> walk({whole(on_grid[0]), whole(on_grid[1]),
                                                   whole(on_grid[2]), whole(on_grid[3]),
                                                   std::int64_t{1} << bits},
                                                  1, at->y, bits);
                walk.step();
                const Rational x = Rational(static_cast<long>(walk.x())) / Rational(unit);
                const double bound =
                    fixed_point_bound(magnitude(Rational(at->y) - exact(on_grid[1])), bits);
                return magnitude(x - at->x) / bound;
            },
            512);
        EXPECT_GT(found, 0.8) << bits;
    }
}

/// A triangle, a pixel's sample, and the weights there: exactly, and what they may be off by.
template <typename Scalar> struct WeightsAtPixel {
    Triangle<Scalar> triangle;
    Pixel pixel;
    std::array<Rational, 3> weights;
    std::array<double, 3> bounds;

    std::array<Scalar, 3> computed() const {
        const Scalar half = static_cast<Scalar>(0.5);
        return Barycentric<Scalar>(triangle).weights_at(
            {static_cast<Scalar>(pixel.x) + half, static_cast<Scalar>(pixel.y) + half});
    }
};
template <typename Scalar, std::size_t count>
std::optional<WeightsAtPixel<Scalar>> weights_at_pixel(const std::array<Scalar, count>& in) {
    WeightsAtPixel<Scalar> at{
        .triangle = {{{{in[0], in[1]}, {in[2], in[3]}, {in[4], in[5]}}}},
        .pixel = {static_cast<int>(std::floor(in[6])), static_cast<int>(std::floor(in[7]))},
        .weights = {},
        .bounds = {}};
    const Rational half(1, 2);
    std::array<Rational, 6> e;
    for (std::size_t i = 0; i < 6; ++i)
        e[i] = exact(in[i]);
    const Rational abx = e[2] - e[0], aby = e[3] - e[1], acx = e[4] - e[0], acy = e[5] - e[1];
    const Rational pax = e[0] - at.pixel.x - half, pay = e[1] - at.pixel.y - half;
    const Rational area = abx * acy - acx * aby;
    if (area == 0 || Barycentric<Scalar>(at.triangle).area2() == 0)
        return std::nullopt;
    const double area_size = magnitude(abx * acy) + magnitude(acx * aby);
    const double size_b = magnitude(acx * pay) + magnitude(pax * acy);
    const double size_c = magnitude(pax * aby) + magnitude(abx * pay);
    at.weights[1] = (acx * pay - pax * acy) / area;
    at.weights[2] = (pax * aby - abx * pay) / area;
    at.weights[0] = 1 - at.weights[1] - at.weights[2];
    const auto bound_of = [&](std::size_t i, double size, double roundings) {
        at.bounds[i] = weight_bound<Scalar>(magnitude(at.weights[i]), size, magnitude(area),
                                            area_size, roundings);
    };
    bound_of(0, area_size + size_b + size_c, 7);
    bound_of(1, size_b, 5);
    bound_of(2, size_c, 5);
    return std::isfinite(at.bounds[0]) ? std::optional(at) : std::nullopt;
}

TYPED_TEST(Bounds, BarycentricWeights) {
    using Scalar = TypeParam;
    for (const std::size_t corner : {0U, 1U, 2U}) {
        const double found = worst<Scalar, 8>(
            [corner](const std::array<Scalar, 8>& in) -> std::optional<double> {
                const auto at = weights_at_pixel(in);
                if (!at || at->bounds[corner] == 0)
                    return std::nullopt;
                return magnitude(exact(at->computed()[corner]) - at->weights[corner]) /
                       at->bounds[corner];
            },
            512);
        EXPECT_GT(found, 0.2) << corner;
    }
}

TYPED_TEST(Bounds, MixedLevels) {
    using Scalar = TypeParam;
    const double found = worst<Scalar, 11>(
        [](const std::array<Scalar, 11>& in) -> std::optional<double> {
            const auto at = weights_at_pixel(in);
            if (!at)
                return std::nullopt;
            MixedColors<Scalar> colors{
                .corners = {},
                .barycentric = Barycentric<Scalar>(at->triangle),
                .offset = {static_cast<Scalar>(0.5), static_cast<Scalar>(0.5)}};
            Rational level;
            double size = 0;
            double of_weights = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const auto red = static_cast<std::uint8_t>(std::abs(in[8 + i]) / 2);
                colors.corners[i] = {red, 0, 0};
                level += red * at->weights[i];
                size += red * magnitude(at->weights[i]);
                of_weights += red * at->bounds[i];
            }
            // The level before it is rounded, unless it is the same everywhere.
            std::optional<Scalar> computed;
            colors.mixed(colors.on_screen(at->pixel), [&computed](Scalar mixed) {
                computed = mixed;
                return std::uint8_t{0};
            });
            return computed ? std::optional(magnitude(exact(*computed) - level) /
                                            level_bound<Scalar>(size, of_weights))
                            : std::nullopt;
        },
        510);
    EXPECT_GT(found, 0.2);
}

TYPED_TEST(Bounds, DepthsOfARowDirectAndAccumulated) {
    using Scalar = TypeParam;
    const auto attack = [](bool accumulates) {
        return worst<Scalar, 4>(
            [accumulates](const std::array<Scalar, 4>& in) -> std::optional<double> {
                const int from = static_cast<int>(std::floor(in[3]));
                const int to = from + 40;
                const DepthRow<Scalar> row{in[0], in[1], in[2] / 64, {}};
                const auto exact_at = [&](int x) {
                    return Rational(exact(row.slope) * (Rational(x) - exact(row.x)));
                };
                const Rational offset = exact_at(to);
                const Rational depth = exact(row.depth) + offset;
                double bound = depth_bound<Scalar>(magnitude(depth), magnitude(offset));
                Scalar computed = row.at(to);
                if (accumulates) {
                    ReseededDepths<Scalar> depths(row, without_end);
                    double largest = 0;
                    computed = depths.at(from);
                    for (int x = from + 1; x <= to; ++x) {
                        computed = depths.at(x);
                        largest = std::max(largest, std::abs(static_cast<double>(computed)));
                    }
                    const Rational first = exact_at(from);
                    bound = accumulated_depth_bound<Scalar>(
                        to - from, largest,
                        depth_bound<Scalar>(magnitude(exact(row.depth) + first), magnitude(first)));
                }
                return bound == 0 ? std::nullopt
                                  : std::optional(magnitude(exact(computed) - depth) / bound);
            },
            256);
    };
    EXPECT_GT(attack(false), 0.4);
    EXPECT_GT(attack(true), 0.3);
}

// Z3: from 1 to 1/r in 64 steps. Accumulated, 1/z of the far end is off by about n r u, and by more
// than itself where r is large enough; in whole parts, ((n - i)/z0 + i/z1)/n, it is off by 4 u.
TEST(BoundsOfDepth, AccumulatingLosesTheFarEnd) {
    for (const double r : {1e4, 1e6}) {
        const int n = 64;
        const auto far = static_cast<float>(1 / r);
        const DepthRow<float> row{0, 1, (far - 1) / n, {}};
        ReseededDepths<float> depths(row, without_end);
        float depth = 1;
        for (int x = 0; x <= n; ++x)
            depth = depths.at(x);
        const double relative = std::abs(static_cast<double>(depth) - 1 / r) * r;
        EXPECT_LT(relative, 1.01 * n * r * unit_roundoff<float> + n * r * unit_roundoff<float>);
        EXPECT_GT(relative, r * unit_roundoff<float>);
        for (int i = 0; i <= n; ++i) {
            const float weighted =
                (static_cast<float>(n - i) / 1.0F + static_cast<float>(i) * far) / n;
            const Rational right = (Rational(n - i) + Rational(i) * exact(far)) / n;
            EXPECT_LE(magnitude(exact(weighted) - right), gamma_of<float>(4) * magnitude(right));
        }
    }
}

TEST(BoundsOfDepth, HalfACode) {
    for (const int bits : {16, 24, 32}) {
        const double found = worst<double, 3>(
            [bits](const std::array<double, 3>& in) -> std::optional<double> {
                const double nearest = std::min(in[0], in[1]);
                const double farthest = std::max(in[0], in[1]);
                if (!(nearest < farthest) || in[2] < nearest || in[2] > farthest)
                    return std::nullopt;
                const DepthCodes<double> codes(nearest, farthest, bits);
                const double stored = codes.depth_of(codes.code_of(in[2]));
                return std::abs(stored - in[2]) / depth_code_bound(nearest, farthest, bits);
            },
            1);
        EXPECT_GT(found, 0.95) << bits;
    }
}

TEST(BoundsOfDivision, BetweenTwoDivisions) {
    for (const int interval : {8, 16, 64}) {
        const double found = worst<double, 4>(
            [interval](const std::array<double, 4>& in) -> std::optional<double> {
                // s goes from s0 to s1 while w goes from w0 to w1, over one interval.
                const double w0 = 1 + std::abs(in[0]);
                const double w1 = 1 + std::abs(in[1]);
                const double s0 = in[2];
                const double s1 = in[3];
                const auto plane = [interval](double from, double to) {
                    return ScreenPlane<double>(
                        {{{0, 0}, {static_cast<double>(interval), 0}, {0, 1}}}, {from, to, from},
                        interval);
                };
                const std::array over_w{plane(s0 / w0, s1 / w1)};
                const auto inverse_w = plane(1 / w0, 1 / w1);
                double largest = 0;
                PerspectiveRow<double, 1>(over_w, inverse_w, 0, 0, interval)
                    .walk(0, interval, [&](int x, const std::array<double, 1>& values) {
                        const double t = static_cast<double>(x) / interval;
                        const double right =
                            ((1 - t) * s0 / w0 + t * s1 / w1) / ((1 - t) / w0 + t / w1);
                        largest = std::max(largest, std::abs(values[0] - right));
                    });
                const double rounding = 1e-12 * (std::abs(s0) + std::abs(s1));
                const double bound = division_bound(w1 / w0, s1 - s0);
                if (bound < 1000 * rounding)
                    return std::nullopt;
                return (largest - rounding) / bound;
            },
            255);
        EXPECT_GT(found, 0.95) << interval;
    }
}

} // namespace
} // namespace rastertrace
