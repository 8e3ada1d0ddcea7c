// SPDX-License-Identifier: MIT
#pragma once

// Colors mixed in filtered doubles: the formulas of mixed_colors.h, with one error bound for all
// pixels of a triangle. A level that the bound leaves undecided is computed in exact numbers. u =
// 2^-53 is the relative rounding error of one operation.
//
//     MixedColors<Adaptive> colors(corners, triangle, offset, inverse_w, rounding,
//                                  exact_color);
//     colors.at<false>({3, 4});

#include <rastertrace/core/draw/filtered/depths.h>
#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/mixed_colors.h>
#include <rastertrace/core/raster/triangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>

namespace rastertrace {

/// Error bounds of the levels of a triangle's pixels.
struct ErrorOfLevels {
    double affine;
    double perspective;
    double smallest_sum; ///< `perspective` holds if the sum of the weights over w is larger
};

/// A pixel's sample may lie outside of the triangle, by up to two pixels.
inline ErrorOfLevels error_of_levels(const Triangle<Adaptive>& triangle,
                                     const std::array<Adaptive, 3>& inverse_w) {
    constexpr double u = Adaptive::half_ulp;

    // Two sides, and the way from the first vertex to a pixel.
    const KnownSides sides(triangle.vertices);
    const double way = sides.reach + 2;
    const double of_way = std::max(triangle.vertices[0].x.error(), triangle.vertices[0].y.error()) +
                          sides.of_reach + u * way;

    // Weights: a cross product, or the area less two of them, over the area. In the triangle they
    // are at most 1. A pixel outside adds at most its distance times the third side, which is at
    // most twice `reach`.
    const double area2 = std::abs(sides.area2);
    const double weight = 1 + 4 * sides.reach * Adaptive::widening / sides.smallest_area2;
    const double of_cross = error_of_products(sides.reach, sides.of_reach, way, of_way);
    const double of_rest = sides.of_area2 + 2 * of_cross + 6 * u * weight * area2;
    const double of_weight =
        (of_rest + weight * sides.of_area2) * Adaptive::widening / sides.smallest_area2 +
        2 * u * weight;

    // A level is a sum of three products, plus one half.
    const auto of_level = [](double of_one, double largest) {
        return 3 * 255 * (of_one + 5 * u * largest + Adaptive::smallest_error) * Adaptive::widening;
    };

    // In space, each weight is a share (weight over w), over the sum of the three shares.
    const auto [smallest, largest] =
        std::minmax({inverse_w[0].value(), inverse_w[1].value(), inverse_w[2].value()});
    const double of_w =
        std::max({inverse_w[0].error(), inverse_w[1].error(), inverse_w[2].error()});
    const double share = weight * largest;
    const double of_share = weight * of_w + largest * of_weight + of_weight * of_w + u * share +
                            Adaptive::smallest_error;
    const double of_sum = 3 * of_share + 6 * u * share;
    const double smallest_sum = smallest / 2;
    const double exact_sum = std::max(0.0, smallest_sum - of_sum) / Adaptive::widening;
    const double in_space = share * Adaptive::widening / exact_sum;
    const double of_in_space = (of_share + in_space * of_sum) / exact_sum + u * in_space;

    return {.affine = of_level(of_weight * Adaptive::widening, weight),
            .perspective = of_level(of_in_space * Adaptive::widening, in_space),
            .smallest_sum = smallest_sum};
}

/// The colors of a triangle's pixels.
template <> struct MixedColors<Adaptive> {
    /// `exact_color` is the exact fallback of one pixel.
    MixedColors(const std::array<Color, 3>& corners, const Triangle<Adaptive>& triangle,
                const SampleOffset<Adaptive>& offset, const std::array<Adaptive, 3>& inverse_w,
                ColorRounding rounding, std::function<Color(Pixel)> exact_color)
        : colors_{corners,
                  Barycentric<double>(values(triangle)),
                  {offset.x().value(), offset.y().value()},
                  {inverse_w[0].value(), inverse_w[1].value(), inverse_w[2].value()},
                  rounding},
          error_(error_of_levels(triangle, inverse_w)), exact_color_(std::move(exact_color)) {}

    template <bool in_perspective> Color at(Pixel pixel) const {
        const auto weights = colors_.on_screen(pixel);
        try {
            if constexpr (in_perspective) {
                const auto [shares, sum] = colors_.shares_of(weights);
                if (!(sum > error_.smallest_sum))
                    Adaptive::leave_open(sum, error_.smallest_sum);
                return mixed({shares[0] / sum, shares[1] / sum, shares[2] / sum},
                             error_.perspective);
            }
            return mixed(weights, error_.affine);
        } catch (const Undecided&) {
            return exact_color_(pixel);
        }
    }

private:
    static Triangle<double> values(const Triangle<Adaptive>& triangle) {
        Triangle<double> result;
        for (std::size_t i = 0; i < 3; ++i)
            result.vertices[i] = {triangle.vertices[i].x.value(), triangle.vertices[i].y.value()};
        return result;
    }

    /// Rounding to the nearest level, a half up, is the floor of the level plus one half.
    Color mixed(const std::array<double, 3>& weights, double error) const {
        const double half = colors_.rounding == ColorRounding::nearest ? 0.5 : 0;
        return colors_.mixed(weights, [error, half](double channel) {
            return level_of(Adaptive(channel + half, error), ColorRounding::truncate);
        });
    }

    MixedColors<double> colors_;
    ErrorOfLevels error_;
    std::function<Color(Pixel)> exact_color_;
};

} // namespace rastertrace
