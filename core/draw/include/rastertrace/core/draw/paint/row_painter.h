// SPDX-License-Identifier: MIT
#pragma once

// The painter of triangles that are tested against a depth buffer, or whose colors are mixed: it takes
// the rows of a fill, finds their depths, and paints the pixels that no nearer triangle hides.
//
//     RowPainter<double> painter(pixels, depth);
//     fill_scanline(triangle, rules, canvas, painter);
//
// One call a row, into loops that are compiled once for each kind of number: no fill includes them.

#include <rastertrace/core/draw/paint/depth_tests.h>
#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/draw/scene/method.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/depth_interpolation.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/mixed_colors.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/span.h>
#include <rastertrace/core/raster/steps.h>

#include <concepts>
#include <optional>

namespace rastertrace {

/// Paints those pixels of a row that nothing nearer hides, in one color, and tells nobody.
template <typename Scalar>
[[gnu::noinline]] void paint_nearer(const ImageRow& row, PixelSpan pixels,
                                    const DepthRow<Scalar>& depths, DepthTests<Scalar>& tests,
                                    Color color) {
    Color* const colors = row.colors - row.left;
    tests.keep_nearer(row.index, pixels.first, pixels.last, depths,
                      [=](int x) { colors[x] = color; });
}

/// The same for a triangle that only hides.
template <typename Scalar>
[[gnu::noinline]] void hide_behind(const ImageRow& row, PixelSpan pixels,
                                   const DepthRow<Scalar>& depths, DepthTests<Scalar>& tests) {
    tests.keep_nearer(row.index, pixels.first, pixels.last, depths, [](int) {});
}

/// Paints where the depths lie on one line, from `depth` at `x0`. All of it is handed over in registers: a
/// row of a small triangle is soon painted.
template <std::floating_point Scalar>
[[gnu::noinline]] void paint_nearer(Color* colors, Scalar* cells, PixelSpan pixels, Scalar x0,
                                    Scalar depth, Scalar slope, Color color) {
    for (int x = pixels.first; x <= pixels.last; ++x) {
        const Scalar here = depth + slope * (static_cast<Scalar>(x) - x0);
        if (here < cells[x]) {
            cells[x] = here;
            colors[x] = color;
        }
    }
}

/// What is done with the pixels of a triangle: a depth test, a color. `Scalar` is what colors are mixed
/// in; depths are compared in DepthOf<Scalar>.
template <typename Scalar, typename Sink = NullSink> struct PixelPainter {
    using D = DepthOf<Scalar>;

    Image& image;
    PixelStages stages = {};
    Color flat = {};                            ///< of every pixel, unless colors are mixed
    const MixedColors<Scalar>* mixed = nullptr; ///< if colors are mixed
    DepthTests<D>* tests = nullptr;             ///< if depths are tested
    DepthAt depth_at = DepthAt::pixel;
    [[no_unique_address]] Sink sink = {};

    /// Paints pixels of a row that are not tested.
    [[gnu::noinline]] void paint_row(const ImageRow& row, PixelSpan pixels) {
        for (int x = pixels.first; x <= pixels.last; ++x)
            plot({x, row.y}, row.at(x));
    }

    /// Paints those that no nearer triangle hides, at these turned depths.
    [[gnu::noinline]] void paint_row(const ImageRow& row, PixelSpan pixels,
                                     const DepthRow<D>& depths) {
        auto* const cells = tests->row_from(0, row.index);
        for (int x = pixels.first; x <= pixels.last; ++x)
            if (passes_depth_test({x, row.y}, depths.at(x), cells[x]))
                plot({x, row.y}, row.at(x));
    }

    /// Paints one pixel of the canvas, at this turned depth if it is tested.
    [[gnu::noinline]] void paint(Pixel pixel, const std::optional<D>& depth) {
        const int row = static_cast<int>(image.canvas().row_of(pixel.y));
        if (!tests || passes_depth_test(pixel, *depth, *tests->row_from(pixel.x, row)))
            plot(pixel, image.at(pixel));
    }

private:
    void plot(Pixel pixel, Color& plotted) {
        if (!stages.is_painted)
            return;
        plotted = color_at(pixel);
        sink(PixelPlotted{.pixel = pixel, .color = plotted});
    }

    Color color_at(Pixel pixel) const {
        switch (stages.colors) {
        case ColorStage::affine:
            return mixed->template at<false>(pixel);
        case ColorStage::perspective:
            return mixed->template at<true>(pixel);
        case ColorStage::flat:
            break;
        }
        return flat;
    }

    /// Tests a turned depth against what is stored for the pixel, and keeps the nearer one.
    template <typename Cell> bool passes_depth_test(Pixel pixel, const D& depth, Cell& cell) {
        const auto test = [&] { return DepthVerdict{tests->keep_if_nearer(cell, depth)}; };
        if constexpr (keeps_steps<Sink>)
            return tests->decide_and_tell(pixel, cell, depth, test, sink);
        else
            return test().passes;
    }
};

/// Finds the depths of the rows that a fill yields, as the fill finds its pixels, and hands them to a
/// PixelPainter. That may have numbers of its own, where a triangle is exact and the rest of the picture
/// is not. What it is made of must live as long.
template <typename Scalar, typename OfPixels = Scalar, typename Sink = NullSink> class RowPainter {
public:
    using D = DepthOf<Scalar>;

    /// No depths are tested.
    explicit RowPainter(PixelPainter<OfPixels, Sink>& pixels) : pixels_(pixels) {}

    /// Depths are interpolated along the edges, then across each row; or by the weights of a sample.
    RowPainter(PixelPainter<OfPixels, Sink>& pixels, TriangleDepth<D>& triangle)
        : pixels_(pixels), triangle_(&triangle) {}

    /// Depths lie in a plane.
    RowPainter(PixelPainter<OfPixels, Sink>& pixels, const DepthPlane<D>& plane)
        : pixels_(pixels), plane_(&plane) {}

    /// Whom it tells may want the numbers of such a step.
    template <typename Step> bool takes() const { return rastertrace::takes<Step>(pixels_.sink); }

    /// What paints nothing is told on.
    template <typename Step> void operator()(const Step& step) const { pixels_.sink(step); }

    /// A row from one edge to another.
    [[gnu::always_inline]] void operator()(const ScanlineSpanned<Scalar>& span) const {
        if (plane_) {
            pixels_.sink(span);
            paint(span, plane_->on_row(span.y));
        } else if (triangle_) {
            paint(span, depths_between_edges(span));
        } else {
            pixels_.sink(span);
            paint(span);
        }
    }

    /// A sample that lies in the triangle is one pixel.
    void operator()(const SampleTested<Scalar>& sample) const {
        pixels_.sink(sample);
        if (sample.is_inside && triangle_)
            pixels_.paint(sample.pixel,
                          pixels_.tests->tested(triangle_->by_weights(
                              {depth_scalar(sample.weights[0]), depth_scalar(sample.weights[1]),
                               depth_scalar(sample.weights[2])})));
        else if (sample.is_inside)
            pixels_.paint(sample.pixel, {});
    }

    /// A pixel of the fan brings its color.
    void operator()(const PixelPlotted& plotted) const {
        pixels_.image.at(plotted.pixel) = plotted.color;
        pixels_.sink(plotted);
    }

private:
    /// The depths of a row, and those of its ends, which are told with it.
    DepthRow<D> depths_between_edges(const ScanlineSpanned<Scalar>& span) const {
        const auto height = scalar_from<D>(span.y);
        const D left = triangle_->on_edge(span.left_edge, height);
        const D right = triangle_->on_edge(span.right_edge, height);
        if (rastertrace::takes<ScanlineSpanned<Scalar>>(pixels_.sink)) {
            ScanlineSpanned<Scalar> told = span;
            told.left_depth = pixels_.tests->turned(left);
            told.right_depth = pixels_.tests->turned(right);
            pixels_.sink(told);
        }
        if (pixels_.depth_at == DepthAt::rounded_ends)
            return row_between(scalar_from<D>(span.from), left, scalar_from<D>(span.to), right);
        return row_between(depth_scalar(span.left), left, depth_scalar(span.right), right);
    }

    /// Paints what the canvas has of a row.
    template <typename... Depths>
    [[gnu::always_inline]] void paint(const ScanlineSpanned<Scalar>& span,
                                      const Depths&... depths) const {
        const ImageRow row = pixels_.image.row(span.y);
        PixelSpan pixels{static_cast<int>(span.from), static_cast<int>(span.to)};
        if (pixels_.stages.tests_canvas)
            pixels = span_on_canvas(row, span.from, span.to);
        tell_rejected_left(row, span.from, span.to, pixels_.sink);
        paint(row, pixels, depths...);
        tell_rejected_right(row, span.from, span.to, pixels_.sink);
    }

    void paint(const ImageRow& row, PixelSpan pixels) const { pixels_.paint_row(row, pixels); }
    [[gnu::always_inline]] void paint(const ImageRow& row, PixelSpan pixels,
                                      const DepthRow<D>& depths) const {
        auto& tests = *pixels_.tests;
        const auto& tested = tests.tested(depths, pixels);
        if constexpr (!keeps_steps<Sink> && std::floating_point<DepthOf<OfPixels>>)
            if (pixels_.stages.colors == ColorStage::flat && pixels_.stages.is_painted &&
                !tested.end && !tests.has_owners())
                return paint_nearer(row.colors - row.left, tests.row_from(0, row.index), pixels,
                                    tested.x, tested.depth, tested.slope, pixels_.flat);
        if (!keeps_steps<Sink> && !pixels_.stages.is_painted)
            hide_behind(row, pixels, tested, tests);
        else if (!keeps_steps<Sink> && pixels_.stages.colors == ColorStage::flat)
            paint_nearer(row, pixels, tested, tests, pixels_.flat);
        else
            pixels_.paint_row(row, pixels, tested);
    }

    PixelPainter<OfPixels, Sink>& pixels_;
    TriangleDepth<D>* triangle_ = nullptr;
    const DepthPlane<D>* plane_ = nullptr;
};

} // namespace rastertrace
