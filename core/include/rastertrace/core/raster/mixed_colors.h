// SPDX-License-Identifier: MIT
#pragma once

// The colors of a triangle's pixels, mixed from those of its vertices.
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
#include <cstddef>
#include <cstdint>

namespace rastertrace {

/// The colors of the vertices, mixed by the weights that they have in a pixel's sample point.
template <typename Scalar> struct MixedColors {
    using D = DepthOf<Scalar>;

    std::array<Color, 3> corners;
    Barycentric<Scalar> barycentric;
    SampleOffset<Scalar> offset;
    std::array<D, 3> inverse_w{}; ///< of the vertices, in a perspective
    ColorRounding rounding = ColorRounding::nearest;

    /// The color of a pixel. Outside the triangle (the floor rule draws such pixels) the mixture
    /// may leave 0..255, and is clamped.
    template <bool in_perspective> Color at(Pixel pixel) const {
        const auto level = [this](const auto& channel) { return level_of(channel, rounding); };
        const auto weights = on_screen(pixel);
        // If all vertices have the same w, the weights on the screen are those in space.
        if constexpr (in_perspective)
            if (are_not_all_equal(inverse_w[0], inverse_w[1], inverse_w[2]))
                return mixed(in_space(weights), level);
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
        const std::array<D, 3> weights{depth_scalar(on_screen[0]), depth_scalar(on_screen[1]),
                                       depth_scalar(on_screen[2])};
        const auto [shares, sum] = shares_of(weights);
        if (!(scalar_from<D>(0) < sum))
            return weights;
        return {D(shares[0] / sum), D(shares[1] / sum), D(shares[2] / sum)};
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
