// SPDX-License-Identifier: MIT
#pragma once

// Colors mixed from those of corners: of a triangle's pixels, and of a line's in space.
//
//     MixedColors<double> colors{corners, barycentric, 0.5};
//     colors.at<false>({3, 4});

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/core/raster/sample_offset.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace rastertrace {

/// A color as four numbers, red, green, blue and alpha. Where clipping has cut an edge, they are no whole
/// levels: only the color of a pixel is rounded.
template <typename Scalar> struct Levels {
    std::array<Scalar, 4> of{};

    Levels() = default;
    Levels(Color color) // NOLINT: a color is such numbers
        : of{scalar_from<Scalar>(color.red()), scalar_from<Scalar>(color.green()),
             scalar_from<Scalar>(color.blue()), scalar_from<Scalar>(color.alpha())} {}

    Color rounded(ColorRounding rounding) const {
        return {level_of(of[0], rounding), level_of(of[1], rounding), level_of(of[2], rounding),
                level_of(of[3], rounding)};
    }
};

/// The channels of corners, mixed by their weights. `level_of` rounds each; one that is the same at all
/// corners is that.
template <typename Weight, std::size_t n, typename LevelOf>
Color mixed_levels(const std::array<Levels<Weight>, n>& corners,
                   const std::array<Weight, n>& weights, LevelOf&& level_of) {
    const auto mix = [&](std::size_t channel) {
        const Weight& first = corners[0].of[channel];
        bool is_same = true;
        Weight mixture = scalar_from<Weight>(0);
        for (std::size_t i = 0; i < n; ++i) {
            is_same = is_same && !are_not_all_equal(first, first, corners[i].of[channel]);
            mixture += weights[i] * corners[i].of[channel];
        }
        return level_of(is_same ? first : mixture);
    };
    return {mix(0), mix(1), mix(2), std::max<std::uint8_t>(mix(3), 1)};
}

/// The colors of a line, mixed from those of its ends.
template <typename Depth> struct MixedOnLine {
    std::array<Levels<Depth>, 2> ends;
    std::array<Depth, 2> inverse_w; ///< of the ends in a perspective, else equal
    ColorRounding rounding = ColorRounding::nearest;

    /// The color at this part of the way on the screen, 0 to 1. In space, the share of each end is
    /// divided by its w, then by the sum of both.
    Color at(const Depth& way) const {
        std::array<Depth, 2> shares{Depth(scalar_from<Depth>(1) - way), way};
        if (are_not_all_equal(inverse_w[0], inverse_w[0], inverse_w[1])) {
            const Depth first = shares[0] * inverse_w[0];
            const Depth second = shares[1] * inverse_w[1];
            const Depth sum = first + second;
            if (scalar_from<Depth>(0) < sum)
                shares = {Depth(first / sum), Depth(second / sum)};
        }
        return mixed_levels(ends, shares,
                            [this](const Depth& level) { return level_of(level, rounding); });
    }
};

/// The colors of the vertices, mixed by the weights that they have in a pixel's sample point.
template <typename Scalar> struct MixedColors {
    using D = DepthOf<Scalar>;

    std::array<Color, 3> corners;
    Barycentric<Scalar> barycentric;
    SampleOffset<Scalar> offset;
    std::array<D, 3> inverse_w{}; ///< of the vertices, in a perspective
    ColorRounding rounding = ColorRounding::nearest;
    std::optional<std::array<Levels<D>, 3>> levels = {}; ///< in the place of `corners`

    /// The color of a pixel. Outside the triangle (the floor rule draws such pixels) the mixture
    /// may leave 0..255, and is clamped.
    template <bool in_perspective> Color at(Pixel pixel) const {
        const auto level = [this](const auto& channel) { return level_of(channel, rounding); };
        const auto weights = on_screen(pixel);
        // If all vertices have the same w, the weights on the screen are those in space.
        if constexpr (in_perspective)
            if (are_not_all_equal(inverse_w[0], inverse_w[1], inverse_w[2]))
                return mixed(in_space(weights), level);
        if (levels)
            return mixed(in_depths(weights), level);
        return mixed(weights, level);
    }

    /// The weights of the vertices on the screen.
    std::array<Scalar, 3> on_screen(Pixel pixel) const {
        return barycentric.weights_at(offset.sample_of(pixel));
    }

    /// The weights in space of a point with these weights on the screen: each is divided by the w
    /// of its vertex, then by the sum of all. If that sum is not positive, far outside the
    /// triangle, they stay as they are.
    std::array<D, 3> in_space(const std::array<Scalar, 3>& on_screen) const {
        const std::array<D, 3> weights = in_depths(on_screen);
        const auto [shares, sum] = shares_of(weights);
        if (!(scalar_from<D>(0) < sum))
            return weights;
        return {D(shares[0] / sum), D(shares[1] / sum), D(shares[2] / sum)};
    }

    static std::array<D, 3> in_depths(const std::array<Scalar, 3>& weights) {
        return {depth_scalar(weights[0]), depth_scalar(weights[1]), depth_scalar(weights[2])};
    }

    /// Weights divided by w, and their sum.
    struct Shares {
        std::array<D, 3> shares;
        D sum;
    };
    Shares shares_of(const std::array<D, 3>& weights) const {
        const std::array<D, 3> shares{D(weights[0] * inverse_w[0]), D(weights[1] * inverse_w[1]),
                                      D(weights[2] * inverse_w[2])};
        return {shares, D(shares[0] + shares[1] + shares[2])};
    }

    /// Not inlined: pixels of mixed colors are slow anyway, and the rows that call it stay small.
    template <typename Weight, typename LevelOf>
    [[gnu::noinline]] Color mixed(const std::array<Weight, 3>& weights, LevelOf level_of) const {
        if constexpr (std::same_as<Weight, D>)
            if (levels)
                return mixed_levels(*levels, weights, level_of);
        const auto mix = [&](std::uint8_t (Color::*channel)() const) {
            // A channel that is the same at all vertices is not rounded.
            const std::uint8_t first = (corners[0].*channel)();
            if (first == (corners[1].*channel)() && first == (corners[2].*channel)())
                return first;
            Weight mixture = scalar_from<Weight>(0);
            for (std::size_t i = 0; i < 3; ++i)
                mixture += weights[i] * scalar_from<Weight>((corners[i].*channel)());
            return level_of(mixture);
        };
        return {mix(&Color::red), mix(&Color::green), mix(&Color::blue),
                std::max<std::uint8_t>(mix(&Color::alpha), 1)};
    }
};

} // namespace rastertrace
