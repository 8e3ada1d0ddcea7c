// SPDX-License-Identifier: MIT
#pragma once

// Bresenham's line: whole numbers only, one decision per pixel.
//
// Source: Bresenham 1965, in the form of the report on points and lines: d = 2 dy - dx at the
// start; if d <= 0 go straight on and add 2 dy, else go diagonally and add 2 (dy - dx). At a tie (d
// = 0) the line stays on the side it started on, so a line and its reverse may differ. With `ties: step`
// it goes straight on only if d < 0, as many drawing libraries have it. Here for all eight octants: dx and
// dy are the lengths along the major and the minor axis.
//
//     draw_bresenham({{0, 0}, {5, 2}, {}, {}}, LineRules(), canvas, FlatPainter(image, color));
//     // (0,0)(1,0)(2,1)(3,1)(4,2)(5,2)

#include <rastertrace/core/numbers/fraction.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/line.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace rastertrace {

/// The pixels of Bresenham's line, which can be asked for out of order: pixel i is reached after i
/// steps.
class BresenhamLine {
public:
    explicit BresenhamLine(GridPoint from, GridPoint to, Ties ties = Ties::start)
        : from_(from), to_(to), x_step_(to.x < from.x ? -1 : 1), y_step_(to.y < from.y ? -1 : 1),
          steps_at_ties_(ties == Ties::step) {
        const Index dx = std::abs(to.x - from.x);
        const Index dy = std::abs(to.y - from.y);
        is_x_major_ = dx >= dy;
        major_ = std::max(dx, dy);
        minor_ = std::min(dx, dy);
    }

    /// How many steps lead from the first pixel to the last.
    Index steps() const { return major_; }

    /// True if the next step goes straight on.
    bool goes_straight(std::int64_t d) const { return steps_at_ties_ ? d < 0 : d <= 0; }

    /// How many of the first i steps are diagonal: the least k with d <= 0, that is, k at least
    /// i minor/major - 1/2; or with d < 0, that is, above that less 1.
    Index diagonals_before(Index i) const {
        if (i == 0)
            return 0;
        const Int128 twice = 2 * Int128{i} * minor_;
        return steps_at_ties_ ? static_cast<Index>((twice + major_) / (2 * Int128{major_}))
                              : ceil_quotient(twice - major_, 2 * Int128{major_});
    }

    GridPoint pixel(Index i) const {
        const Index k = diagonals_before(i);
        return is_x_major_ ? GridPoint{from_.x + x_step_ * i, from_.y + y_step_ * k}
                           : GridPoint{from_.x + x_step_ * k, from_.y + y_step_ * i};
    }

    /// d before step i.
    std::int64_t d(Index i) const {
        return static_cast<std::int64_t>(2 * Int128{minor_} - major_ + 2 * Int128{minor_} * i -
                                         2 * Int128{major_} * diagonals_before(i));
    }

    /// What a step adds to d, straight on or diagonally.
    std::int64_t d_straight() const { return 2 * minor_; }
    std::int64_t d_diagonal() const { return 2 * (minor_ - major_); }

    /// A straight and a diagonal step.
    GridPoint straight() const {
        return is_x_major_ ? GridPoint{x_step_, 0} : GridPoint{0, y_step_};
    }
    GridPoint diagonal() const { return {x_step_, y_step_}; }

    /// The steps whose pixels lie on a canvas, from `first` to `last`; none if last < first. Both
    /// coordinates change in one direction only, so these are consecutive.
    struct Range {
        Index first;
        Index last;
    };
    Range steps_on(const Canvas& canvas) const {
        if (canvas.contains(from_.x, from_.y) && canvas.contains(to_.x, to_.y))
            return {0, major_};
        const Index low_y = std::min(canvas.top(), canvas.bottom());
        const Index high_y = std::max(canvas.top(), canvas.bottom());
        const Range x = distances(from_.x, x_step_, canvas.left(), canvas.right());
        const Range y = distances(from_.y, y_step_, low_y, high_y);
        const Range& along_major = is_x_major_ ? x : y;
        const Range& along_minor = is_x_major_ ? y : x;
        return {std::max({Index{0}, along_major.first, first_step_with(along_minor.first)}),
                std::min({major_, along_major.last, first_step_with(along_minor.last + 1) - 1})};
    }

private:
    static Index ceil_quotient(Int128 above, Int128 below) {
        const Int128 quotient = above / below;
        return static_cast<Index>(above % below > 0 ? quotient + 1 : quotient);
    }

    /// How far one has to go from `start` in steps of +-1 to be between `low` and `high`.
    static Range distances(Index start, int step, Index low, Index high) {
        return step > 0 ? Range{low - start, high - start} : Range{start - high, start - low};
    }

    /// The first step after which at least k steps were diagonal: i minor/major - 1/2 > k - 1, or at
    /// least that.
    Index first_step_with(Index k) const {
        if (k <= 0)
            return 0;
        if (k > minor_)
            return major_ + 1;
        const Int128 above = (2 * Int128{k} - 1) * major_;
        return steps_at_ties_ ? ceil_quotient(above, 2 * Int128{minor_})
                              : static_cast<Index>(above / (2 * Int128{minor_})) + 1;
    }

    GridPoint from_;
    GridPoint to_;
    int x_step_;
    int y_step_;
    bool steps_at_ties_;
    bool is_x_major_;
    Index major_;
    Index minor_;
};

/// The compass point of a step: E is x + 1, N is y + 1.
inline Move move_of(GridPoint step) {
    constexpr std::array<std::array<Move, 3>, 3> moves{{{Move::sw, Move::w, Move::nw},
                                                        {Move::s, Move::e, Move::n},
                                                        {Move::se, Move::e, Move::ne}}};
    return moves[static_cast<std::size_t>(step.x + 1)][static_cast<std::size_t>(step.y + 1)];
}

/// Draws a line; false if it has no pixel, but for one that is left out. Time follows the pixels on the canvas. The ends must lie within +-farthest_index / 4.
template <typename Sink>
requires SinkFor<Sink, LineDecided, PixelPlotted, PixelsRejected>
bool draw_bresenham(const GridLine& line, const LineRules& rules, const Canvas& canvas,
                    Sink&& sink) {
    const BresenhamLine path(line.from, line.to, rules.ties);
    const Index end = path.steps() - (rules.ends == EndPixels::both ? 0 : 1);
    if (end < 0)
        return false;
    const auto on_canvas = path.steps_on(canvas);
    const Index first = on_canvas.first;
    const Index last = std::min(on_canvas.last, end);
    const auto reject = [&](const GridPoint& from, const GridPoint& to) {
        sink(PixelsRejected{from.x, from.y, to.x, to.y});
    };
    if (last < first) {
        reject(line.from, path.pixel(end));
        return true;
    }
    if (first > 0)
        reject(line.from, path.pixel(first - 1));

    GridPoint at = path.pixel(first);
    std::int64_t d = path.d(first);
    for (Index i = first;; ++i) {
        const Color color = color_on_line(line, rules, at, i, path.steps());
        const Pixel pixel{static_cast<int>(at.x), static_cast<int>(at.y)};
        sink(PixelPlotted{.pixel = pixel, .color = color});
        if (i == last)
            break;

        // Straight on, or diagonally?
        const bool goes_straight = path.goes_straight(d);
        const GridPoint step = goes_straight ? path.straight() : path.diagonal();
        sink(LineDecided{.pixel = pixel, .d = d, .move = move_of(step)});
        d += goes_straight ? path.d_straight() : path.d_diagonal();
        at = {at.x + step.x, at.y + step.y};
    }

    if (last < end)
        reject(path.pixel(last + 1), path.pixel(end));
    return true;
}

} // namespace rastertrace
