// SPDX-License-Identifier: MIT
#pragma once

// Points, and what all lines share: which octant they lie in, where they start, and their colors.

#include <rastertrace/core/numbers/fraction.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/choices.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/core/raster/sample_offset.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>

namespace rastertrace {

/// A point of the grid, anywhere.
struct GridPoint {
    Index x = 0;
    Index y = 0;

    friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// The pixel whose sample is nearest to a point; a half goes up, in x and in y.
template <typename Scalar>
GridPoint nearest_pixel(const Vec<Scalar, 2>& point, const SampleOffset<Scalar>& offset) {
    return {nearest_index(offset.in_columns(point.x), Ties::up),
            nearest_index(offset.in_rows(point.y), Ties::up)};
}

/// The color of a line's pixel at a step of so many.
using LineColors = std::function<Color(GridPoint pixel, Index step, Index steps)>;

/// A line between two points of the grid, with the colors of its ends.
struct GridLine {
    GridPoint from;
    GridPoint to;
    Color from_color;
    Color to_color;
    const LineColors* colors = nullptr; ///< in the place of these two, in space or of cut ends
};

/// Draws a point: one pixel.
template <typename Sink>
requires SinkFor<Sink, PixelPlotted<>, PixelsRejected<>>
void draw_point(GridPoint point, Color color, const Canvas& canvas, Sink&& sink) {
    if (canvas.contains(point.x, point.y))
        sink(PixelPlotted<>{
            .x = static_cast<int>(point.x), .y = static_cast<int>(point.y), .color = color});
    else
        sink(pixels_off_canvas(point.x, point.y, point.x, point.y));
}

/// Steps of a line, counted from its start: from `first` to `last`; none if last < first.
struct StepRange {
    Index first;
    Index last;

    bool is_empty() const { return last < first; }
};

/// The steps from 0 to `last` that lie between `low` and `high` on an axis: step 0 at `first`, each one
/// further, or back.
inline StepRange steps_between(Index low, Index high, Index first, bool goes_back, Index last) {
    return {std::max<Index>(0, goes_back ? first - high : low - first),
            std::min<Index>(last, goes_back ? first - low : high - first)};
}

/// Reports the pixels before those on the canvas: all up to step `end`, if the canvas has none of
/// them. `pixel_at(step)` is the pixel of a step.
template <typename PixelAt, typename Sink>
requires SinkFor<Sink, PixelsRejected<>>
void reject_before(const StepRange& on_canvas, Index end, PixelAt&& pixel_at, Sink&& sink) {
    const Index last = on_canvas.is_empty() ? end : on_canvas.first - 1;
    if (last < 0)
        return;
    const GridPoint p = pixel_at(Index{0});
    const GridPoint q = pixel_at(last);
    sink(pixels_off_canvas(p.x, p.y, q.x, q.y));
}

/// Reports the pixels behind those on the canvas, up to step `end`.
template <typename PixelAt, typename Sink>
requires SinkFor<Sink, PixelsRejected<>>
void reject_behind(const StepRange& on_canvas, Index end, PixelAt&& pixel_at, Sink&& sink) {
    if (on_canvas.is_empty() || on_canvas.last >= end)
        return;
    const GridPoint p = pixel_at(on_canvas.last + 1);
    const GridPoint q = pixel_at(end);
    sink(pixels_off_canvas(p.x, p.y, q.x, q.y));
}

/// The octant of a direction, 1 to 8, by the signs of dx and dy and whether |dx| >= |dy|: 1
/// (+,+,yes), 2 (+,+,no), 3 (-,+,no), 4 (-,+,yes), 5 (-,-,yes), 6 (-,-,no), 7 (+,-,no), 8
/// (+,-,yes). A 0 counts as +. Octants run counter-clockwise where y points up.
inline int octant_of(bool dx_is_negative, bool dy_is_negative, bool is_x_major) {
    if (!dy_is_negative)
        return dx_is_negative ? (is_x_major ? 4 : 3) : (is_x_major ? 1 : 2);
    return dx_is_negative ? (is_x_major ? 5 : 6) : (is_x_major ? 8 : 7);
}

inline int octant_of(GridPoint from, GridPoint to) {
    const Index dx = to.x - from.x;
    const Index dy = to.y - from.y;
    return octant_of(dx < 0, dy < 0, std::abs(dx) >= std::abs(dy));
}

/// The same line from its other end.
inline GridLine reversed(const GridLine& line) {
    return {line.to, line.from, line.to_color, line.from_color, line.colors};
}

/// `part` of the way from one color to another out of `whole`.
inline Color color_between(Color from, Color to, Index part, Index whole, ColorRounding rounding) {
    const auto channel = [part, whole, rounding](std::uint8_t a, std::uint8_t b) {
        const Int128 weighted = Int128{a} * (whole - part) + Int128{b} * part;
        const Int128 half = rounding == ColorRounding::nearest ? whole : 0;
        return static_cast<std::uint8_t>((2 * weighted + half) / (2 * Int128{whole}));
    };
    return {channel(from.red(), to.red()), channel(from.green(), to.green()),
            channel(from.blue(), to.blue()), channel(from.alpha(), to.alpha())};
}

/// The distance of a pixel from the end of a line, over the line's length.
inline double share_by_distance(const GridLine& line, GridPoint pixel) {
    const auto distance = [](GridPoint a, GridPoint b) {
        const auto dx = static_cast<double>(b.x - a.x);
        const auto dy = static_cast<double>(b.y - a.y);
        return std::sqrt(dx * dx + dy * dy);
    };
    return distance(pixel, line.to) / distance(line.from, line.to);
}

/// The color of a line's pixel by its distance from the end: the part of the start's color is that
/// distance over the line's length.
inline Color color_by_distance(const GridLine& line, GridPoint pixel, ColorRounding rounding) {
    const double share = share_by_distance(line, pixel);
    const auto channel = [share, rounding](std::uint8_t a, std::uint8_t b) {
        return a == b ? a : level_of(share * a + (1 - share) * b, rounding);
    };
    return {channel(line.from_color.red(), line.to_color.red()),
            channel(line.from_color.green(), line.to_color.green()),
            channel(line.from_color.blue(), line.to_color.blue()),
            channel(line.from_color.alpha(), line.to_color.alpha())};
}

/// The color of step `step` of `steps` along a line. The first and the last pixel have exactly the
/// colors of the ends, unless the line has colors of its own.
inline Color color_on_line(const GridLine& line, const LineRules& rules, GridPoint pixel,
                           Index step, Index steps) {
    if (line.colors)
        return (*line.colors)(pixel, step, steps);
    if (line.from_color == line.to_color || step == 0)
        return line.from_color;
    if (step == steps)
        return line.to_color;
    if (rules.color_lerp == ColorLerp::distance)
        return color_by_distance(line, pixel, rules.color_rounding);
    return color_between(line.from_color, line.to_color, step, steps, rules.color_rounding);
}

} // namespace rastertrace
