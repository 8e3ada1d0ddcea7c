// SPDX-License-Identifier: MIT
#pragma once

// What the naive line and the DDA share: one pixel for each step along the major axis, which is x
// if |dx| >= |dy|, else y. "Along" names the coordinate on the major axis, "across" the other one.
// The two algorithms differ in how they find the coordinate across.

#include <rastertrace/core/numbers/index.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/line.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <cstdlib>

namespace rastertrace {

/// A line between any two points.
template <typename Scalar> struct Segment {
    Vec<Scalar, 2> from;
    Vec<Scalar, 2> to;
};

/// True if x is the major axis of a line.
template <typename Scalar> bool is_longer_in_x(const Segment<Scalar>& segment) {
    const Scalar zero = scalar_from<Scalar>(0);
    const auto magnitude = [&zero](const Scalar& value) {
        return value < zero ? Scalar(-value) : value;
    };
    const Scalar dy = magnitude(segment.to.y - segment.from.y);
    const Scalar dx = magnitude(segment.to.x - segment.from.x);
    return !(dx < dy);
}

/// The pixel of a coordinate across a line. At a tie, Ties::start stays on the side that the line
/// comes from: below if it rises, above if it falls. Ties::step goes to the other side.
template <typename Scalar>
Index pixel_across(const Scalar& value, const SpanRounding& rule, bool falls) {
    if (rule.rounding == Rounding::nearest && falls) {
        if (rule.ties == Ties::start)
            return nearest_index(value, Ties::up);
        if (rule.ties == Ties::step)
            return nearest_index(value, Ties::start);
    }
    return first_pixel(value, rule);
}

/// The choices that both algorithms leave open.
struct LineSampling {
    SpanRounding rounding;
    GridLine colors; ///< of the ends, and their pixels
    LineRules rules;
};

/// A line along its major axis. Its steps are the samples along the axis, from the one nearest to the
/// start to the one nearest to the end (a half goes up).
template <typename Scalar> class SampledLine {
public:
    SampledLine(const Segment<Scalar>& segment, const SampleOffset<Scalar>& offset,
                const LineSampling& sampling, const Canvas& canvas)
        : offset_(offset), sampling_(sampling), rounding_(sampling.rounding), canvas_(canvas) {
        const auto& [from, to] = segment;
        const Scalar zero = scalar_from<Scalar>(0);
        const Scalar dx = to.x - from.x;
        const Scalar dy = to.y - from.y;
        is_x_major_ = is_longer_in_x(segment);
        rounding_.ties = sampling.rules.ties;
        along_from = is_x_major_ ? from.x : from.y;
        across_from = is_x_major_ ? from.y : from.x;
        const Scalar d_along = is_x_major_ ? dx : dy;
        const Scalar d_across = is_x_major_ ? dy : dx;
        slope = d_along == zero ? zero : Scalar(d_across / d_along);
        falls_ = d_across < zero;

        const auto nearest = [&](const Vec<Scalar, 2>& p) {
            return nearest_index(is_x_major_ ? offset.in_columns(p.x) : offset.in_rows(p.y),
                                 Ties::up);
        };
        first_ = nearest(from);
        const Index last = nearest(to);
        goes_back = last < first_;
        steps_ = std::abs(last - first_);
        last_step_ = steps_ - (sampling.rules.ends == EndPixels::both ? 0 : 1);
    }

    Scalar along_from{};
    Scalar across_from{};
    Scalar slope{};         ///< m; 0 for a line without length
    bool goes_back = false; ///< toward smaller coordinates along the axis

    /// The column, or row, after so many steps.
    Index along(Index step) const { return goes_back ? first_ - step : first_ + step; }

    /// The coordinate of its samples along the axis.
    Scalar sample_along(Index step) const {
        return is_x_major_ ? offset_.x_of(along(step)) : offset_.y_of(along(step));
    }

    /// The last step that is drawn; -1 if the only pixel is the last one, which `ends: first`
    /// leaves out.
    Index last_step() const { return last_step_; }

    /// The steps that are drawn and have a column, or row, of the canvas.
    StepRange steps_on_canvas() const {
        const Index low = is_x_major_ ? canvas_.left() : std::min(canvas_.top(), canvas_.bottom());
        const Index high =
            is_x_major_ ? canvas_.right() : std::max(canvas_.top(), canvas_.bottom());
        return steps_between(low, high, first_, goes_back, last_step_);
    }

    /// The pixel of a step, where the line has this coordinate across.
    GridPoint pixel(Index step, const Scalar& across) const {
        return point(along(step), rounded(across));
    }

    /// Rounds the coordinate across at a step, and plots the pixel if the canvas has it.
    template <typename Sink> void plot(Index step, const Scalar& across, Sink&& sink) const {
        const Index pixel = rounded(across);
        sink(line_sampled(is_x_major_, along(step), across, pixel));
        const GridPoint at = point(along(step), pixel);
        if (!canvas_.contains(at.x, at.y))
            return sink(pixels_off_canvas(at.x, at.y, at.x, at.y));
        const Color color = color_on_line(sampling_.colors, sampling_.rules, at, step, steps_);
        sink(PixelPlotted<>{
            .x = static_cast<int>(at.x), .y = static_cast<int>(at.y), .color = color});
    }

private:
    GridPoint point(Index along, Index across) const {
        return is_x_major_ ? GridPoint{along, across} : GridPoint{across, along};
    }

    Index rounded(const Scalar& across) const {
        return pixel_across(is_x_major_ ? offset_.in_rows(across) : offset_.in_columns(across),
                            rounding_, falls_);
    }

    const SampleOffset<Scalar>& offset_;
    const LineSampling& sampling_;
    SpanRounding rounding_; ///< with the ties of its major axis
    const Canvas& canvas_;
    bool is_x_major_ = true;
    bool falls_ = false; ///< the coordinate across becomes smaller from start to end
    Index first_ = 0;
    Index steps_ = 0;     ///< from end to end
    Index last_step_ = 0; ///< that is drawn
};

} // namespace rastertrace
