// SPDX-License-Identifier: MIT
#pragma once

// The lines of the textbooks that come before Bresenham's: one pixel for each step along the major
// axis, the other coordinate from the equation of the line, rounded.
//
//     naive:  y = m x + b            on every step
//     dda:    y = y0 + m (x - x0)    on the first step, then y += m
//
// Source: the report on points and lines, with y = m x0 + b put right, b being y0 - m x0; DDA: the
// digital differential analyzer of the textbooks.
//
// Here "along" is the major axis (x if |dx| >= |dy|) and "across" the other one.

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/line.h>
#include <rastertrace/core/raster/line_bresenham.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace rastertrace {

/// A line between any two points.
template <typename Scalar> struct Segment {
    Vec<Scalar, 2> from;
    Vec<Scalar, 2> to;
};

/// How the minor coordinate is found.
enum class LineForm { naive, dda };

/// True if x is the major axis of a line.
template <typename Scalar> bool is_longer_in_x(const Segment<Scalar>& segment) {
    const Scalar zero = scalar_from<Scalar>(0);
    const auto magnitude = [&zero](const Scalar& value) {
        return value < zero ? Scalar(-value) : value;
    };
    // One after the other: of signs that filtered doubles leave open, the first one is told.
    const Scalar dy = magnitude(segment.to.y - segment.from.y);
    const Scalar dx = magnitude(segment.to.x - segment.from.x);
    return !(dx < dy);
}

/// The pixel of a coordinate across a line. A tie with Ties::start stays on the side that the line
/// comes from: below if it rises, above if it falls; with Ties::step it goes to the other side.
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

/// Draws a line between any two points. Its steps are the whole numbers along the major axis from
/// the one nearest to the start to the one nearest to the end (a half goes up). False if it has no pixel,
/// but for one that is left out. Time follows the canvas. `colors` says the ends' colors and, in whole pixels, where they are.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, LineSampled<Scalar>, PixelPlotted, PixelsRejected>
bool draw_line_by_lerp(const Segment<Scalar>& segment, LineForm form, const SpanRounding& rounding,
                       const GridLine& colors, const LineRules& rules, const Canvas& canvas,
                       Sink&& sink) {
    const auto& [from, to] = segment;
    const Scalar zero = scalar_from<Scalar>(0);

    // Along and across.
    const Scalar dx = to.x - from.x;
    const Scalar dy = to.y - from.y;
    const bool is_x_major = is_longer_in_x(segment);
    const Scalar& along_from = is_x_major ? from.x : from.y;
    const Scalar& along_to = is_x_major ? to.x : to.y;
    const Scalar& across_from = is_x_major ? from.y : from.x;
    const Scalar d_along = is_x_major ? dx : dy;
    const Scalar d_across = is_x_major ? dy : dx;

    // The slope m and the intercept b.
    const Scalar m = d_along == zero ? zero : Scalar(d_across / d_along);
    const Scalar b = across_from - m * along_from;
    const bool falls = d_across < zero;

    // The steps, and those of them that the canvas has a column or row for.
    const Index first = nearest_index(along_from, Ties::up);
    const Index last = nearest_index(along_to, Ties::up);
    const Index steps = std::abs(last - first);
    const Index last_step = steps - (rules.ends == EndPixels::both ? 0 : 1);
    if (last_step < 0)
        return false;
    const int step = last < first ? -1 : 1;
    const Index low = is_x_major ? canvas.left() : std::min(canvas.top(), canvas.bottom());
    const Index high = is_x_major ? canvas.right() : std::max(canvas.top(), canvas.bottom());
    const Index begin = std::max<Index>(0, step > 0 ? low - first : first - high);
    const Index end = std::min<Index>(last_step, step > 0 ? high - first : first - low);
    const auto point = [is_x_major](Index along, Index across) {
        return is_x_major ? GridPoint{along, across} : GridPoint{across, along};
    };
    const auto value_at = [&](Index along) {
        return form == LineForm::naive
                   ? Scalar(m * scalar_from<Scalar>(along) + b)
                   : linear(across_from, m, scalar_from<Scalar>(along), along_from);
    };
    const auto pixel_at = [&](Index along) {
        return point(along, pixel_across(value_at(along), rounding, falls));
    };
    const auto reject = [&](Index from_step, Index to_step) {
        const GridPoint p = pixel_at(first + step * from_step);
        const GridPoint q = pixel_at(first + step * to_step);
        sink(PixelsRejected{p.x, p.y, q.x, q.y});
    };
    if (end < begin) {
        reject(0, last_step);
        return true;
    }
    if (begin > 0)
        reject(0, begin - 1);

    Scalar value = value_at(first + step * begin);
    Scalar value_step = step > 0 ? m : Scalar(-m);
    if (form == LineForm::dda)
        write_over_denominator_of(value, value_step);
    for (Index i = begin; i <= end; ++i) {
        const Index along = first + step * i;
        if (form == LineForm::naive)
            value = value_at(along);
        else if (i > begin)
            value += value_step;

        const Index across = pixel_across(value, rounding, falls);
        sink(LineSampled<Scalar>{
            .is_x_major = is_x_major, .at = along, .value = value, .pixel = across});
        const GridPoint at = point(along, across);
        if (canvas.contains(at.x, at.y)) {
            const Pixel pixel{static_cast<int>(at.x), static_cast<int>(at.y)};
            const Color color = color_on_line(colors, rules, at, i, steps);
            sink(PixelPlotted{.pixel = pixel, .color = color});
        } else {
            sink(PixelsRejected{at.x, at.y, at.x, at.y});
        }
    }

    if (end < last_step)
        reject(end + 1, last_step);
    return true;
}

} // namespace rastertrace
