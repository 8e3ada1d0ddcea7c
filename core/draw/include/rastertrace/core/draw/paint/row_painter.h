// SPDX-License-Identifier: MIT
#pragma once

// The painters of triangles that are tested against a depth buffer, or whose colors are mixed. Each
// is the sink of a fill, like FlatPainter.
//
//     fill_scanline(triangle, rules, canvas,
//                   RowPainter<double>{.image = image, .tests = &tests, .triangle = &depth});

#include <rastertrace/core/draw/paint/depth_tests.h>
#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/draw/scene/method.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/depth_buffer.h>
#include <rastertrace/core/raster/depth_interpolation.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/mixed_colors.h>
#include <rastertrace/core/raster/sample_offset.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/span.h>
#include <rastertrace/core/raster/steps.h>

#include <optional>

namespace rastertrace {

/// Tests the pixels of a row that has one color, and paints those that pass if `is_painted`.
template <typename Depth, typename Tests>
[[gnu::noinline]] void paint_nearer(const ImageRow& row, PixelSpan pixels,
                                    const DepthRow<Depth>& depths, Tests& tests, Color color,
                                    bool is_painted) {
    Color* const colors = row.colors - row.left;
    keep_nearer(tests, row.index, pixels, depths, [=](int x) {
        if (is_painted)
            colors[x] = color;
    });
}

/// The painter of a triangle in one color whose depths lie in a plane and are tested against faces
/// alone. It is inlined like FlatPainter, and its sink keeps no pixels.
template <typename Scalar, typename Sink = NullSink>
requires(!keeps_steps<Sink>) class PlanePainter {
public:
    using D = DepthOf<Scalar>;

    PlanePainter(Image& image, Color color, const DepthPlane<D>& plane, DepthTests<D>& tests,
                 bool tests_canvas = true, Sink sink = {})
        : image_(image), color_(color), plane_(plane), tests_(tests), tests_canvas_(tests_canvas),
          sink_(sink) {}

    template <typename Step> bool takes() const { return false; }
    template <typename Step> [[gnu::always_inline]] void operator()(const Step& step) const {
        sink_(step);
    }

    [[gnu::always_inline]] void operator()(const ScanlineSpanned<Scalar>& span) const {
        const ImageRow row = image_.row(span.y);
        const PixelSpan pixels = span_on_canvas(row, span.from, span.to, tests_canvas_);
        paint_nearer(pixels, plane_.on_row(span.y), tests_.row_from(0, row.index),
                     row.colors - row.left, color_);
    }

private:
    Image& image_;
    Color color_;
    const DepthPlane<D>& plane_;
    DepthTests<D>& tests_;
    bool tests_canvas_;
    [[no_unique_address]] Sink sink_;
};

/// Any triangle: takes the rows, or the samples, of a fill, finds their depths, tests these, mixes
/// colors, and tells every step on. What it refers to must live as long.
template <typename Scalar, typename Tests = DepthTests<DepthOf<Scalar>>, typename Sink = NullSink>
struct RowPainter {
    using D = DepthOf<Scalar>;

    Image& image;
    PixelStages stages = {};
    Color flat = {};                            ///< of every pixel, unless colors are mixed
    const MixedColors<Scalar>* mixed = nullptr; ///< if colors are mixed
    Tests* tests = nullptr;                     ///< if depths are tested; then they are found
    const DepthPlane<D>* plane = nullptr;       ///< in a plane,
    TriangleDepth<D>* triangle = nullptr;       ///< or along the edges, or by weights
    DepthAt depth_at = DepthAt::pixel;
    SampleOffset<D> offset = {};
    [[no_unique_address]] Sink sink = {};

    /// True if the sink takes such a step.
    template <typename Step> bool takes() const { return rastertrace::takes<Step>(sink); }

    /// A step that paints nothing.
    template <typename Step> void operator()(const Step& step) const { sink(step); }

    /// A row from one edge to another.
    [[gnu::always_inline]] void operator()(const ScanlineSpanned<Scalar>& span) const {
        if (plane) {
            sink(span);
            paint(span, plane->on_row(span.y));
        } else if (triangle) {
            paint(span, depths_between_edges(span));
        } else {
            sink(span);
            paint(span);
        }
    }

    /// A sample that lies in the triangle is one pixel.
    void operator()(const SampleTested<Scalar>& sample) const {
        sink(sample);
        if (!sample.inside)
            return;
        if (!triangle)
            return paint_pixel(sample.pixel(), {});
        const auto& [a, b, c] = sample.weights;
        paint_pixel(sample.pixel(),
                    triangle->by_weights({depth_scalar(a), depth_scalar(b), depth_scalar(c)}));
    }

    /// A pixel of the fan brings its color.
    void operator()(const PixelPlotted<>& plotted) const {
        image.at(plotted.pixel()) = plotted.color;
        sink(plotted);
    }

private:
    /// The depths of a row. Those of its ends are told with it.
    DepthRow<D> depths_between_edges(const ScanlineSpanned<Scalar>& span) const {
        const D height = offset.y_of(span.y);
        const D left = triangle->on_edge(span.left_edge, height);
        const D right = triangle->on_edge(span.right_edge, height);
        if (takes<ScanlineSpanned<Scalar>>()) {
            require_finite(left);
            require_finite(right);
            ScanlineSpanned<Scalar> told = span;
            told.left_depth = tests->turned(left);
            told.right_depth = tests->turned(right);
            sink(told);
        }
        if (depth_at == DepthAt::rounded_ends)
            return row_between(scalar_from<D>(span.from), left, scalar_from<D>(span.to), right);
        return row_between(offset.in_columns(depth_scalar(span.left)), left,
                           offset.in_columns(depth_scalar(span.right)), right);
    }

    /// Paints the pixels of a row that are on the canvas.
    template <typename... Depths>
    [[gnu::always_inline]] void paint(const ScanlineSpanned<Scalar>& span,
                                      const Depths&... depths) const {
        const ImageRow row = image.row(span.y);
        const PixelSpan pixels = span_on_canvas(row, span.from, span.to, stages.tests_canvas);
        tell_rejected_left(row, span.from, span.to, sink);
        paint_row(row, pixels, depths...);
        tell_rejected_right(row, span.from, span.to, sink);
    }

    [[gnu::noinline]] void paint_row(const ImageRow& row, PixelSpan pixels) const {
        for (int x = pixels.first; x <= pixels.last; ++x)
            plot({x, row.y}, row.at(x));
    }

    void paint_row(const ImageRow& row, PixelSpan pixels, const DepthRow<D>& depths) const {
        if (!keeps_steps<Sink> && (stages.colors == ColorStage::flat || !stages.is_painted))
            paint_nearer(row, pixels, depths, *tests, flat, stages.is_painted);
        else
            test_row(row, pixels, depths);
    }

    [[gnu::noinline]] void test_row(const ImageRow& row, PixelSpan pixels,
                                    const DepthRow<D>& depths) const {
        auto* const cells = tests->row_from(0, row.index);
        for (int x = pixels.first; x <= pixels.last; ++x)
            if (passes_depth_test({x, row.y}, depths.at(x), cells[x]))
                plot({x, row.y}, row.at(x));
    }

    /// Paints a pixel of the canvas; at a turned depth if it is tested.
    [[gnu::noinline]] void paint_pixel(Pixel pixel, const std::optional<D>& depth) const {
        const int row = static_cast<int>(image.canvas().row_of(pixel.y));
        if (!tests || passes_depth_test(pixel, *depth, *tests->row_from(pixel.x, row)))
            plot(pixel, image.at(pixel));
    }

    /// Tests a turned depth against a cell, which keeps the nearer of the two.
    template <typename Cell> bool passes_depth_test(Pixel pixel, const D& depth, Cell& cell) const {
        const auto test = [&] { return DepthVerdict{tests->keep_if_nearer(cell, depth)}; };
        return decide_and_tell(*tests, pixel, cell, depth, test, sink);
    }

    void plot(Pixel pixel, Color& plotted) const {
        if (!stages.is_painted)
            return;
        plotted = color_at(pixel);
        sink(PixelPlotted<>{.x = pixel.x, .y = pixel.y, .color = plotted});
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
};

} // namespace rastertrace
