// SPDX-License-Identifier: MIT
#pragma once

// The colors of a primitive's pixels: one for all of them, or mixed from those of the vertices; and
// which of them a nearer triangle hides.
//
//     Paint<double> paint{.flat = Color{255, 0, 0}};
//     plot_span(y, -1, 3, paint, image, sink);

#include <rastertrace/core/adaptive_depth.h>
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
    std::array<D, 3> inverse_w{}; ///< of the vertices, in a perspective

    /// Each channel is rounded to the nearest level, a half up. Where a pixel lies outside the
    /// triangle (the floor rule draws some) the mixture may leave 0..255, and is held there.
    template <bool in_perspective> Color at(Pixel pixel) const {
        const auto nearest = [](const auto& level) { return nearest_index(level, Ties::up); };
        const auto weights = on_screen(pixel);
        // Where w is the same all over, so are the weights.
        if constexpr (in_perspective)
            if (inverse_w[0] != inverse_w[1] || inverse_w[0] != inverse_w[2])
                return mixed(in_space(weights), nearest);
        return mixed(weights, nearest);
    }

    /// The weights of the vertices on the screen.
    std::array<Scalar, 3> on_screen(Pixel pixel) const {
        return barycentric.weights_at({Scalar(scalar_from<Scalar>(pixel.x) + sample_offset),
                                       Scalar(scalar_from<Scalar>(pixel.y) + sample_offset)});
    }

    /// The weights in space of a point that has these weights on the screen: each is divided by the
    /// w of its vertex, and all are divided by their sum. A point so far outside the triangle that
    /// it has none keeps what it has.
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
    template <typename Weight, typename Nearest>
    [[gnu::noinline]] Color mixed(const std::array<Weight, 3>& weights, Nearest nearest) const {
        const auto mix = [&](std::uint8_t (Color::*channel)() const) {
            // What is the same everywhere is not rounded.
            const std::uint8_t first = (corners[0].*channel)();
            if (first == (corners[1].*channel)() && first == (corners[2].*channel)())
                return first;
            Weight level = scalar_from<Weight>(0);
            for (std::size_t i = 0; i < 3; ++i)
                level += weights[i] * scalar_from<Weight>((corners[i].*channel)());
            return static_cast<std::uint8_t>(std::clamp<Index>(nearest(level), 0, 255));
        };
        return {mix(&Color::red), mix(&Color::green), mix(&Color::blue),
                std::max<std::uint8_t>(mix(&Color::alpha), 1)};
    }
};

/// Doubles that know their error have a form of their own: adaptive_color.h.
template <> struct MixedColors<Adaptive>;

/// Where the colors of pixels come from.
enum class ColorStage : std::uint8_t {
    flat,        ///< one for all of them
    affine,      ///< mixed as they mix on the screen
    perspective, ///< mixed as they mix in space
};

/// What is done for each pixel of a triangle beside plotting it. Decided for each triangle before it
/// is drawn (plan.h) and compiled in or out: a fill has no branch for what its triangle does not
/// need.
struct PixelStages {
    ColorStage colors = ColorStage::flat;
    bool tests_depth = false; ///< against what is nearest so far
    bool tests_canvas = true; ///< drops what the canvas does not have
};

/// Calls `fill_with.template operator()<stages>()` with the stages as a constant. A sink that keeps
/// steps costs far more than a canvas test, which is always compiled in for it.
template <typename Sink, typename FillWith>
void with_stages(const PixelStages& stages, FillWith&& fill_with) {
    const auto with_depth = [&]<ColorStage colors, bool tests_canvas>() {
        if (stages.tests_depth)
            fill_with.template operator()<PixelStages{colors, true, tests_canvas}>();
        else
            fill_with.template operator()<PixelStages{colors, false, tests_canvas}>();
    };
    const auto with_canvas = [&]<ColorStage colors>() {
        if constexpr (!keeps_steps<Sink>)
            if (!stages.tests_canvas)
                return with_depth.template operator()<colors, false>();
        with_depth.template operator()<colors, true>();
    };
    switch (stages.colors) {
    case ColorStage::flat:
        return with_canvas.template operator()<ColorStage::flat>();
    case ColorStage::affine:
        return with_canvas.template operator()<ColorStage::affine>();
    case ColorStage::perspective:
        return with_canvas.template operator()<ColorStage::perspective>();
    }
}

/// How the pixels of a triangle get their colors, and which of them are hidden. Colors and depth tests
/// have numbers of their own where a triangle is exact and the rest of the picture is not.
template <typename Scalar, PixelStages stages = PixelStages{}, typename OfPixels = Scalar>
struct Paint {
    Color flat;                                   ///< of every pixel, unless colors are mixed
    const MixedColors<OfPixels>* mixed = nullptr; ///< if colors are mixed
    TriangleDepth<Scalar, DepthBuffer<DepthOf<OfPixels>>>* depth =
        nullptr; ///< if depths are tested
};

/// Tests a pixel's turned depth against what is stored for it, and keeps the nearer one.
template <typename D, typename Cell, typename Sink>
requires SinkFor<Sink, DepthTested<D>>
[[gnu::always_inline]] inline bool passes_depth_test(Pixel pixel, int row, const D& depth,
                                                     Cell& cell, DepthBuffer<D>& buffer,
                                                     Sink&& sink) {
    if constexpr (keeps_steps<Sink> && std::same_as<D, Adaptive>) {
        return buffer.keep_and_tell(pixel, row, cell, depth, sink);
    } else if constexpr (keeps_steps<Sink>) {
        const std::optional<D> stored = buffer.stored(cell);
        const bool passes = buffer.keep_if_nearer(cell, depth);
        sink(DepthTested<D>{
            .pixel = pixel, .depth = buffer.turned(depth), .stored = stored, .passes = passes});
        return passes;
    } else {
        return buffer.keep_if_nearer(cell, depth);
    }
}

/// The pixels of a row that its canvas has, from x = `first` to x = `last`.
struct SpanOnCanvas {
    int first;
    int last;
};

/// Reports those left of the canvas: before the pixels that are plotted.
template <typename Sink>
requires SinkFor<Sink, PixelsRejected>
[[gnu::always_inline]] inline void report_rejected_left(const ImageRow& row, Index from, Index to,
                                                        Sink&& sink) {
    if (from <= to && from < row.left)
        sink(PixelsRejected{.from_x = from,
                            .from_y = row.y,
                            .to_x = std::min<Index>(to, row.left - 1),
                            .to_y = row.y});
}

/// Reports those right of it: after them.
template <typename Sink>
requires SinkFor<Sink, PixelsRejected>
[[gnu::always_inline]] inline void report_rejected_right(const ImageRow& row, Index from, Index to,
                                                         Sink&& sink) {
    if (from <= to && to > row.right)
        sink(PixelsRejected{.from_x = std::max<Index>(from, row.right + 1),
                            .from_y = row.y,
                            .to_x = to,
                            .to_y = row.y});
}

/// The pixels from x = `from` to x = `to` that are on the canvas; those left of it are reported.
/// Inline, like all that a row of a small triangle needs: calling it would cost as much as the row.
template <bool tests_canvas, typename Sink>
requires SinkFor<Sink, PixelsRejected>
[[gnu::always_inline]] inline SpanOnCanvas span_on_canvas(const ImageRow& row, Index from, Index to,
                                                          Sink&& sink) {
    if constexpr (!tests_canvas)
        return {static_cast<int>(from), static_cast<int>(to)};
    report_rejected_left(row, from, to, sink);
    const Index left = row.left;
    const Index right = row.right;
    return {static_cast<int>(std::clamp(from, left, right + 1)),
            static_cast<int>(std::clamp(to, left - 1, right))};
}

/// Plots the pixels of a row from x = `from` to x = `to`, as far as the canvas has them.
template <typename Scalar, PixelStages stages, typename OfPixels, typename Sink>
requires SinkFor<Sink, PixelPlotted, PixelsRejected>
[[gnu::always_inline]] inline void plot_span(const ImageRow& row, Index from, Index to,
                                             const Paint<Scalar, stages, OfPixels>& paint,
                                             Sink&& sink) {
    const auto [first, last] = span_on_canvas<stages.tests_canvas>(row, from, to, sink);
    Color* const colors = row.colors - row.left;
    Color color = paint.flat; // a copy: no pixel that is written can be part of it
    for (int x = first; x <= last; ++x) {
        if constexpr (stages.colors != ColorStage::flat)
            color = paint.mixed->template at<stages.colors == ColorStage::perspective>({x, row.y});
        colors[x] = color;
        sink(PixelPlotted{.pixel = {x, row.y}, .color = color});
    }
    if constexpr (stages.tests_canvas)
        report_rejected_right(row, from, to, sink);
}

/// The same for a triangle with depths: plots those pixels that no nearer triangle hides.
template <typename Scalar, PixelStages stages, typename OfPixels, typename Sink>
requires SinkFor<Sink, DepthTested<DepthOf<OfPixels>>, PixelPlotted, PixelsRejected>
[[gnu::always_inline]] inline void plot_tested_span(const ImageRow& row, Index from, Index to,
                                                    const Paint<Scalar, stages, OfPixels>& paint,
                                                    const DepthRow<DepthOf<Scalar>>& depths,
                                                    Sink&& sink) {
    const auto [first, last] = span_on_canvas<stages.tests_canvas>(row, from, to, sink);
    auto& buffer = paint.depth->buffer;
    const auto& compared = buffer.compared(depths, first, last);
    auto* const cells = buffer.row_from(0, row.index);
    Color* const colors = row.colors - row.left;
    Color color = paint.flat;
    for (int x = first; x <= last; ++x) {
        if (!passes_depth_test({x, row.y}, row.index, compared.at(x), cells[x], buffer, sink))
            continue;
        if constexpr (stages.colors != ColorStage::flat)
            color = paint.mixed->template at<stages.colors == ColorStage::perspective>({x, row.y});
        colors[x] = color;
        sink(PixelPlotted{.pixel = {x, row.y}, .color = color});
    }
    if constexpr (stages.tests_canvas)
        report_rejected_right(row, from, to, sink);
}

} // namespace rastertrace
