// SPDX-License-Identifier: MIT
#pragma once

// Bresenham's line in closed form: pixel i and its d without the steps before it. So drawing a line
// costs only the part of it that lies on the canvas.
//
//     BresenhamLine({0, 0}, {5, 2}).pixel(4);  // (4, 2)

#include <rastertrace/core/numbers/fraction.h>
#include <rastertrace/core/numbers/index.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/line.h>
#include <rastertrace/core/raster/rounding.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace rastertrace {

/// The pixels of Bresenham's line in any order. Pixel i is reached after i steps.
class BresenhamLine {
public:
    explicit BresenhamLine(GridPoint from, GridPoint to, Ties ties = Ties::start)
        : from_(from), to_(to), x_step_(to.x < from.x ? -1 : 1), y_step_(to.y < from.y ? -1 : 1) {
        const Index dx = std::abs(to.x - from.x);
        const Index dy = std::abs(to.y - from.y);
        is_x_major_ = dx >= dy;
        steps_at_ties_ = ties == Ties::step;
        major_ = std::max(dx, dy);
        minor_ = std::min(dx, dy);
    }

    /// How many steps lead from the first pixel to the last.
    Index steps() const { return major_; }

    /// True if the next step goes straight on.
    bool goes_straight(std::int64_t d) const { return steps_at_ties_ ? d < 0 : d <= 0; }

    /// How many of the first i steps are diagonal. A step goes straight on if d <= 0: this is the
    /// least k >= i minor/major - 1/2. With ties that step (d < 0): the least k > i minor/major -
    /// 1/2.
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

    /// The steps up to `end` whose pixels lie on a canvas. Both coordinates change in one direction
    /// only, so these are consecutive.
    StepRange steps_on(const Canvas& canvas, Index end) const {
        if (canvas.contains(from_.x, from_.y) && canvas.contains(to_.x, to_.y))
            return {0, end};
        const Index low_y = std::min(canvas.top(), canvas.bottom());
        const Index high_y = std::max(canvas.top(), canvas.bottom());
        const StepRange x = distances(from_.x, x_step_, canvas.left(), canvas.right());
        const StepRange y = distances(from_.y, y_step_, low_y, high_y);
        const StepRange& along_major = is_x_major_ ? x : y;
        const StepRange& along_minor = is_x_major_ ? y : x;
        return {std::max({Index{0}, along_major.first, first_step_with(along_minor.first)}),
                std::min({end, along_major.last, first_step_with(along_minor.last + 1) - 1})};
    }

private:
    static Index ceil_quotient(Int128 above, Int128 below) {
        const Int128 quotient = above / below;
        return static_cast<Index>(above % below > 0 ? quotient + 1 : quotient);
    }

    /// How far one has to go from `start` in steps of +-1 to be between `low` and `high`.
    static StepRange distances(Index start, int step, Index low, Index high) {
        return step > 0 ? StepRange{low - start, high - start}
                        : StepRange{start - high, start - low};
    }

    /// The first step i after which at least k steps were diagonal: the least i with
    /// i minor/major - 1/2 > k - 1, or >= with ties that step.
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

} // namespace rastertrace
