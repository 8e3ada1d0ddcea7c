// SPDX-License-Identifier: MIT
#pragma once

// The simplest painter: every pixel of a primitive in one color. A painter is the sink of a fill.
// It paints the pixels of the rows that the fill yields, and tells every step on.
//
//     fill_scanline(triangle, rules, canvas, FlatPainter(image, Color{255, 0, 0}));
//     fill_scanline(triangle, rules, canvas, FlatPainter(image, Color{255, 0, 0}, listening_sink));
//
// It is inlined into the fill: a call would cost as much as a row of a small triangle.

#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/span.h>
#include <rastertrace/core/raster/steps.h>

#include <concepts>

namespace rastertrace {

template <typename Sink = NullSink> class FlatPainter {
public:
    /// `tests_canvas` is false if every row is known to lie on the canvas. A sink without a name
    /// must be callable as a constant; one with a name is referred to.
    FlatPainter(Image& image, Color color, Sink sink = {}, bool tests_canvas = true)
        : image_(image), color_(color), tests_canvas_(tests_canvas), sink_{sink} {}

    /// True if the sink takes such a step.
    template <typename Step> bool takes() const { return rastertrace::takes<Step>(sink_); }

    /// A step that paints nothing.
    template <typename Step> [[gnu::always_inline]] void operator()(const Step& step) const {
        sink_(step);
    }

    /// A row from one edge to another.
    template <typename Scalar>
    [[gnu::always_inline]] void operator()(const ScanlineSpanned<Scalar>& span) const {
        sink_(span);
        const ImageRow row = image_.row(span.y);
        const Color color = color_; // a copy: no pixel that is written can be part of it
        const PixelSpan pixels = span_on_canvas(row, span.from, span.to, tests_canvas_);
        tell_rejected_left(row, span.from, span.to, sink_);
        Color* const colors = row.colors - row.left;
        for (int x = pixels.first; x <= pixels.last; ++x) {
            colors[x] = color;
            sink_(PixelPlotted<>{.x = x, .y = row.y, .color = color});
        }
        tell_rejected_right(row, span.from, span.to, sink_);
    }

    /// A sample that lies in the triangle is one pixel.
    template <typename Sample>
    requires std::same_as<decltype(Sample::inside), bool>
    [[gnu::always_inline]] void operator()(const Sample& sample) const {
        sink_(sample);
        if (sample.inside)
            (*this)(PixelPlotted<>{.x = sample.x, .y = sample.y, .color = color_});
    }

    /// A pixel of a line, or of the fan, brings its color.
    [[gnu::always_inline]] void operator()(const PixelPlotted<>& plotted) const {
        image_.at(plotted.pixel()) = plotted.color;
        sink_(plotted);
    }

private:
    Image& image_;
    Color color_;
    bool tests_canvas_;
    [[no_unique_address]] Sink sink_;
};

template <typename Sink>
FlatPainter(Image&, Color, Sink&&, bool tests_canvas = true) -> FlatPainter<Sink>;

} // namespace rastertrace
