// SPDX-License-Identifier: MIT
#pragma once

// The line of graphics hardware: a pixel is drawn if the line leaves its diamond, the points that are
// less than 1/2 away from its sample along the axes, |x - i| + |y - j| < 1/2. So lines that follow one
// another share no pixel, and a line and its reverse have the same pixels but for their ends.
//
// Source: OpenGL 4.6 specification, section 14.5.1. It moves both ends by (-e, -e e) for a small e, y up
// in the picture, so that no point lies on the border of a diamond.
//
//     draw_diamond_exit_line(segment, {0.5, 0.5}, sampling, canvas, sink);

#include <rastertrace/core/numbers/index.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/line.h>
#include <rastertrace/core/raster/line_sampling.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/core/raster/sample_offset.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <cstdlib>

namespace rastertrace {

/// A point, y up in the picture.
template <typename Scalar> Vec<Scalar, 2> turned_up(const Vec<Scalar, 2>& p, int down) {
    return {p.x, down > 0 ? Scalar(-p.y) : p.y};
}

/// A line with y up in the picture. If its major axis is x, |dx| >= |dy|, it goes through one diamond
/// in each column between its ends: that of the pixel nearest to it there.
template <typename Scalar> class DiamondLine {
public:
    DiamondLine(const Segment<Scalar>& segment, const SampleOffset<Scalar>& offset, int down)
        : from_(turned_up<Scalar>(segment.from, down)), to_(turned_up<Scalar>(segment.to, down)),
          sample_(turned_up<Scalar>({offset.x(), offset.y()}, down)),
          is_x_major_(is_longer_in_x(segment)) {
        const Scalar zero = scalar_from<Scalar>(0);
        const Scalar rise = is_x_major_ ? Scalar(to_.y - from_.y) : Scalar(to_.x - from_.x);
        const Scalar run = is_x_major_ ? Scalar(to_.x - from_.x) : Scalar(to_.y - from_.y);
        goes_back_ = run < zero;
        slope_ = run == zero ? zero : Scalar(rise / run);
        // Moved by -e, an end that lies on a column of samples has left it on the lower side.
        const Index from = ceil_index(Scalar(along_of(from_) - along_of(sample_)));
        const Index to = ceil_index(Scalar(along_of(to_) - along_of(sample_)));
        first_ = goes_back_ ? from - 1 : from;
        last_ = goes_back_ ? to : to - 1;
        const Index back = goes_back_ ? 1 : -1;
        if (is_in_diamond(from_, first_ + back))
            first_ += back;
        if (is_in_diamond(to_, last_))
            last_ += back;
    }

    bool is_x_major() const { return is_x_major_; }

    /// The last step: column `along(0)` is the first that the line draws. -1 if it leaves no diamond.
    Index last_step() const { return goes_back_ ? first_ - last_ : last_ - first_; }

    /// The column, or row, of a step.
    Index along(Index step) const { return goes_back_ ? first_ - step : first_ + step; }

    /// The steps whose columns, or rows, lie between two of these.
    StepRange steps_in(Index low, Index high) const {
        return steps_between(low, high, first_, goes_back_, last_step());
    }

    /// The other coordinate of the line at the samples of a column or row.
    Scalar across(Index along) const {
        return linear(across_of(from_), slope_,
                      Scalar(scalar_from<Scalar>(along) + along_of(sample_)), along_of(from_));
    }

    /// Its pixel there. At a tie, the end's -e moves an x-major line by -e m, which counts for more
    /// than -e e, and a y-major one by -e.
    Index pixel_across(const Scalar& across) const {
        const bool rises = is_x_major_ && scalar_from<Scalar>(0) < slope_;
        return nearest_index(Scalar(across - across_of(sample_)), rises ? Ties::up : Ties::start);
    }

private:
    const Scalar& along_of(const Vec<Scalar, 2>& p) const { return is_x_major_ ? p.x : p.y; }
    const Scalar& across_of(const Vec<Scalar, 2>& p) const { return is_x_major_ ? p.y : p.x; }

    /// True if a point of the line lies in the diamond that the line goes through in a column. On its
    /// border, -e moves the point inside if it lies right of the sample.
    bool is_in_diamond(const Vec<Scalar, 2>& p, Index along) const {
        const Index pixel = pixel_across(across(along));
        const Scalar zero = scalar_from<Scalar>(0);
        const auto magnitude = [&zero](const Scalar& x) { return x < zero ? Scalar(-x) : x; };
        const Scalar u = p.x - sample_.x - scalar_from<Scalar>(is_x_major_ ? along : pixel);
        const Scalar v = p.y - sample_.y - scalar_from<Scalar>(is_x_major_ ? pixel : along);
        const Scalar sum = magnitude(u) + magnitude(v);
        const Scalar twice = sum + sum;
        const Scalar one = scalar_from<Scalar>(1);
        return twice < one || (twice == one && zero < u);
    }

    Vec<Scalar, 2> from_;
    Vec<Scalar, 2> to_;
    Vec<Scalar, 2> sample_; ///< from a pixel's integer point
    bool is_x_major_;
    bool goes_back_ = false;
    Scalar slope_{};
    Index first_ = 0; ///< column, or row
    Index last_ = 0;
};

/// Draws a line between any two points; false if it leaves no diamond. The time is proportional to the
/// canvas.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, LineSampled<Scalar>, PixelPlotted<>, PixelsRejected<>>
bool draw_diamond_exit_line(const Segment<Scalar>& segment, const SampleOffset<Scalar>& offset,
                            const LineSampling& sampling, const Canvas& canvas, Sink&& sink) {
    const int down = canvas.down();
    const DiamondLine<Scalar> line(segment, offset, down);
    const Index end = line.last_step();
    if (end < 0)
        return false;

    // Rows of samples count upward, those of the canvas as its y does.
    const bool is_x_major = line.is_x_major();
    const auto y_of = [down](Index row) { return down > 0 ? -row : row; };
    const auto pixel = [&](Index along, const Scalar& across) {
        const Index other = line.pixel_across(across);
        return is_x_major ? GridPoint{along, y_of(other)} : GridPoint{other, y_of(along)};
    };
    const auto pixel_at = [&](Index step) {
        return pixel(line.along(step), line.across(line.along(step)));
    };
    const Index low_y = std::min(canvas.top(), canvas.bottom());
    const Index high_y = std::max(canvas.top(), canvas.bottom());
    const Index low = is_x_major ? canvas.left() : down > 0 ? -high_y : low_y;
    const Index high = is_x_major ? canvas.right() : down > 0 ? -low_y : high_y;
    const StepRange steps = line.steps_in(low, high);

    reject_before(steps, end, pixel_at, sink);
    for (Index i = steps.first; i <= steps.last; ++i) {
        const Index along = line.along(i);
        const Scalar across = line.across(along);
        const GridPoint at = pixel(along, across);
        const Scalar turned = is_x_major && down > 0 ? Scalar(-across) : across;
        sink(is_x_major ? line_sampled(true, at.x, turned, at.y)
                        : line_sampled(false, at.y, turned, at.x));
        if (!canvas.contains(at.x, at.y)) {
            sink(pixels_off_canvas(at.x, at.y, at.x, at.y));
            continue;
        }
        // The end's color belongs to the pixel that the line stops in.
        const Color color = color_on_line(sampling.colors, sampling.rules, at, i, end + 1);
        sink(PixelPlotted<>{
            .x = static_cast<int>(at.x), .y = static_cast<int>(at.y), .color = color});
    }
    reject_behind(steps, end, pixel_at, sink);
    return true;
}

} // namespace rastertrace
