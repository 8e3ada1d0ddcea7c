// SPDX-License-Identifier: MIT
#pragma once

// The colors of a primitive's pixels: one for all of them, or mixed from those of the vertices; and
// which of them a nearer triangle hides.
//
//     Paint<double> paint{.flat = Color{255, 0, 0}};
//     plot_span(y, -1, 3, paint, image, sink);

#include <rastertrace/core/barycentric.h>
#include <rastertrace/core/canvas.h>
#include <rastertrace/core/depth.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/rounding.h>
#include <rastertrace/core/scalar.h>
#include <rastertrace/core/sink.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/triangle.h>
#include <rastertrace/core/vec.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <optional>

namespace rastertrace {

/// The colors of the vertices, mixed by the weights that they have in a pixel's sample point.
template <typename Scalar> struct MixedColors {
    using D = DepthOf<Scalar>;

    std::array<Color, 3> corners;
    Barycentric<Scalar> barycentric;
    Scalar sample_offset; ///< from the pixel's integer point to its sample point, in x and in y
    std::optional<std::array<D, 3>> inverse_w = {}; ///< of the vertices, in a perspective

    /// Each channel is rounded to the nearest level, a half up. Where a pixel lies outside the
    /// triangle (the floor rule draws some) the mixture may leave 0..255, and is held there.
    Color at(Pixel pixel) const {
        const auto weights =
            barycentric.weights_at({Scalar(scalar_from<Scalar>(pixel.x) + sample_offset),
                                    Scalar(scalar_from<Scalar>(pixel.y) + sample_offset)});
        return inverse_w ? mixed(in_space(weights)) : mixed(weights);
    }

private:
    /// The weights in space of a point that has these weights on the screen: each is divided by the
    /// w of its vertex, and all are divided by their sum. A point so far outside the triangle that
    /// it has none keeps what it has.
    std::array<D, 3> in_space(const std::array<Scalar, 3>& on_screen) const {
        const std::array<D, 3> weights{depth_scalar(on_screen[0]), depth_scalar(on_screen[1]),
                                       depth_scalar(on_screen[2])};
        const std::array<D, 3> shares{D(weights[0] * (*inverse_w)[0]),
                                      D(weights[1] * (*inverse_w)[1]),
                                      D(weights[2] * (*inverse_w)[2])};
        const D sum = shares[0] + shares[1] + shares[2];
        if (!(scalar_from<D>(0) < sum))
            return weights;
        return {D(shares[0] / sum), D(shares[1] / sum), D(shares[2] / sum)};
    }

    /// Not inlined: pixels of mixed colors are slow anyway, and the rows that call it stay small.
    template <typename Weight>
    [[gnu::noinline]] Color mixed(const std::array<Weight, 3>& weights) const {
        const auto mix = [this, &weights](std::uint8_t (Color::*channel)() const) {
            Weight level = scalar_from<Weight>(0);
            for (std::size_t i = 0; i < 3; ++i)
                level += weights[i] * scalar_from<Weight>((corners[i].*channel)());
            return static_cast<std::uint8_t>(
                std::clamp<Index>(nearest_index(level, Ties::up), 0, 255));
        };
        return {mix(&Color::red), mix(&Color::green), mix(&Color::blue),
                std::max<std::uint8_t>(mix(&Color::alpha), 1)};
    }
};

/// How the pixels of a primitive get their colors, and which of them are hidden.
template <typename Scalar> struct Paint {
    Color flat;                                    ///< of every pixel, unless
    std::optional<MixedColors<Scalar>> mixed = {}; ///< this is here
    TriangleDepth<Scalar>* depth = nullptr;        ///< tests every pixel, if it is here

    Color at(Pixel pixel) const { return mixed ? mixed->at(pixel) : flat; }
};

/// Tests a pixel's depth against what is stored for it, and keeps the nearer one.
template <bool larger, typename D, typename Sink>
requires SinkFor<Sink, DepthTested<D>>
bool passes_depth_test(Pixel pixel, const D& depth, D& cell, DepthBuffer<D>& buffer, Sink&& sink) {
    if constexpr (keeps_steps<Sink>) {
        const std::optional<D> stored = buffer.stored(cell);
        const bool passes = buffer.template keep_if_nearer<larger>(cell, depth);
        sink(DepthTested<D>{.pixel = pixel, .depth = depth, .stored = stored, .passes = passes});
        return passes;
    } else {
        return buffer.template keep_if_nearer<larger>(cell, depth);
    }
}

/// The plain loop of a row in one color that nobody watches: `count` pixels from x = `first` on.
/// Stores are unconditional, so that a compiler can do several at once.
template <bool larger, std::floating_point D>
inline void keep_nearer_pixels(Color* colors, D* cells, int first, int count,
                               const DepthRow<D>& depths, Color color) {
    const auto [x, depth, slope, end] = depths;
    for (int i = 0; i < count; ++i) {
        const D here = depth + slope * (static_cast<D>(first + i) - x);
        const bool passes = larger ? cells[i] < here : here < cells[i];
        cells[i] = passes ? here : cells[i];
        colors[i] = passes ? color : colors[i];
    }
}

/// Plots the pixels of a row that the canvas has and that no nearer triangle hides.
template <bool larger, typename Scalar, typename Sink>
requires SinkFor<Sink, DepthTested<DepthOf<Scalar>>, PixelPlotted>
void plot_nearer_pixels(int y, int first, int last, const Paint<Scalar>& paint,
                        const DepthRow<DepthOf<Scalar>>& depths, Image& image, Sink&& sink) {
    using D = DepthOf<Scalar>;
    if (last < first)
        return;
    auto& buffer = paint.depth->buffer;
    D* const cells = buffer.row_from(first, static_cast<int>(image.canvas().row_of(y)));
    Color* const row = &image.at({first, y});
    if constexpr (!keeps_steps<Sink> && std::floating_point<D>)
        if (!paint.mixed && !depths.end) {
            keep_nearer_pixels<larger>(row, cells, first, last - first + 1, depths, paint.flat);
            return;
        }
    for (int x = first; x <= last; ++x) {
        if (!passes_depth_test<larger>({x, y}, depths.at(x), cells[x - first], buffer, sink))
            continue;
        const Color color = paint.at({x, y});
        row[x - first] = color;
        sink(PixelPlotted{.pixel = {x, y}, .color = color});
    }
}

/// Plots the pixels of a row that the canvas has, from x = `first` to x = `last`, in mixed colors.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, PixelPlotted>
[[gnu::noinline]] void plot_mixed_span(int y, int first, int last, const MixedColors<Scalar>& mixed,
                                       Image& image, Sink&& sink) {
    for (int x = first; x <= last; ++x) {
        const Color color = mixed.at({x, y});
        image.at({x, y}) = color;
        sink(PixelPlotted{.pixel = {x, y}, .color = color});
    }
}

/// The part of a row from x = `from` to x = `to` that the canvas has; what it does not have is
/// reported in two parts, one before and one after the pixels that are plotted.
struct SpanOnCanvas {
    int first;
    int last;
};

inline SpanOnCanvas span_on_canvas(Index from, Index to, const Canvas& canvas) {
    const Index left = canvas.left();
    const Index right = canvas.right();
    return {static_cast<int>(std::clamp(from, left, right + 1)),
            static_cast<int>(std::clamp(to, left - 1, right))};
}

template <typename Sink>
requires SinkFor<Sink, PixelsRejected>
void report_rejected_left(int y, Index from, Index to, const Canvas& canvas, Sink&& sink) {
    const Index left = canvas.left();
    if (from <= to && from < left)
        sink(
            PixelsRejected{.from_x = from, .from_y = y, .to_x = std::min(to, left - 1), .to_y = y});
}

template <typename Sink>
requires SinkFor<Sink, PixelsRejected>
void report_rejected_right(int y, Index from, Index to, const Canvas& canvas, Sink&& sink) {
    const Index right = canvas.right();
    if (from <= to && to > right)
        sink(PixelsRejected{
            .from_x = std::max(from, right + 1), .from_y = y, .to_x = to, .to_y = y});
}

/// Plots the pixels of a row from x = `from` to x = `to`, as far as the canvas has them. Inline: on
/// a short row, calling it would cost as much as the row.
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

/// The same for a triangle with depths: plots those pixels that no nearer triangle hides.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, DepthTested<DepthOf<Scalar>>, PixelPlotted, PixelsRejected>
void plot_tested_span(int y, Index from, Index to, const Paint<Scalar>& paint,
                      const DepthRow<DepthOf<Scalar>>& depths, Image& image, Sink&& sink) {
    report_rejected_left(y, from, to, image.canvas(), sink);
    const auto [first, last] = span_on_canvas(from, to, image.canvas());
    if (paint.depth->buffer.larger_passes())
        plot_nearer_pixels<true>(y, first, last, paint, depths, image, sink);
    else
        plot_nearer_pixels<false>(y, first, last, paint, depths, image, sink);
    report_rejected_right(y, from, to, image.canvas(), sink);
}

} // namespace rastertrace
