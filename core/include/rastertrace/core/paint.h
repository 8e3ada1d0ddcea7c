// SPDX-License-Identifier: MIT
#pragma once

// The colors of a primitive's pixels: one for all of them, or mixed from those of the vertices.
//
//     Paint<double> paint{.flat = Color{255, 0, 0}};
//     plot_span(y, -1, 3, paint, image, sink);

#include <rastertrace/core/barycentric.h>
#include <rastertrace/core/canvas.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/rounding.h>
#include <rastertrace/core/scalar.h>
#include <rastertrace/core/sink.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/triangle.h>
#include <rastertrace/core/vec.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace rastertrace {

/// The colors of the vertices, mixed by the weights that they have in a pixel's sample point.
template <typename Scalar> struct MixedColors {
    std::array<Color, 3> corners;
    Barycentric<Scalar> barycentric;
    Scalar sample_offset; ///< from the pixel's integer point to its sample point, in x and in y

    /// Each channel is rounded to the nearest level, a half up. Where a pixel lies outside the
    /// triangle (the floor rule draws some) the mixture may leave 0..255, and is held there.
    Color at(Pixel pixel) const {
        const auto weights =
            barycentric.weights_at({Scalar(scalar_from<Scalar>(pixel.x) + sample_offset),
                                    Scalar(scalar_from<Scalar>(pixel.y) + sample_offset)});
        const auto mix = [this, &weights](std::uint8_t (Color::*channel)() const) {
            Scalar level = scalar_from<Scalar>(0);
            for (std::size_t i = 0; i < 3; ++i)
                level += weights[i] * scalar_from<Scalar>((corners[i].*channel)());
            return static_cast<std::uint8_t>(
                std::clamp<Index>(nearest_index(level, Ties::up), 0, 255));
        };
        return {mix(&Color::red), mix(&Color::green), mix(&Color::blue),
                std::max<std::uint8_t>(mix(&Color::alpha), 1)};
    }
};

/// How the pixels of a primitive get their colors.
template <typename Scalar> struct Paint {
    Color flat;                                    ///< of every pixel, unless
    std::optional<MixedColors<Scalar>> mixed = {}; ///< this is here
};

/// Plots the pixels of a row that the canvas has, from x = `first` to x = `last`, in mixed colors.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, PixelPlotted>
void plot_mixed_span(int y, int first, int last, const MixedColors<Scalar>& mixed, Image& image,
                     Sink&& sink) {
    for (int x = first; x <= last; ++x) {
        const Color color = mixed.at({x, y});
        image.at({x, y}) = color;
        sink(PixelPlotted{.pixel = {x, y}, .color = color});
    }
}

/// Plots the pixels of a row from x = `from` to x = `to`, as far as the canvas has them.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, PixelPlotted, PixelsRejected>
inline void plot_span(int y, Index from, Index to, const Paint<Scalar>& paint, Image& image,
                      Sink&& sink) {
    const Index left = image.canvas().left();
    const Index right = image.canvas().right();
    if (from <= to && from < left)
        sink(
            PixelsRejected{.from_x = from, .from_y = y, .to_x = std::min(to, left - 1), .to_y = y});

    const auto first = static_cast<int>(std::clamp(from, left, right + 1));
    const auto last = static_cast<int>(std::clamp(to, left - 1, right));
    if (paint.mixed) {
        plot_mixed_span(y, first, last, *paint.mixed, image, sink);
    } else {
        Color* const row = image.row(y).data();
        const Color color = paint.flat;
        for (int x = first; x <= last; ++x) {
            row[x - left] = color;
            sink(PixelPlotted{.pixel = {x, y}, .color = color});
        }
    }

    if (from <= to && to > right)
        sink(PixelsRejected{
            .from_x = std::max(from, right + 1), .from_y = y, .to_x = to, .to_y = y});
}

} // namespace rastertrace
