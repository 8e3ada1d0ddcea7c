// SPDX-License-Identifier: MIT
#pragma once

// The arithmetic of the top-left fill: where the sample points lie, and which is the first right of
// an edge on each row. Each kind of number has the form that is fastest for it.
//
//     const SampleGrid<double> grid({0.5, 0.5}, canvas);  // samples at the pixels' centers
//     SampleWalk<double> walk(top, bottom, grid, 3);
//     walk.first_sample();  // in row 3: the first x whose sample is not left of the edge
//     walk.step();          // row 4

#include <rastertrace/core/draw/paint/divisor.h>
#include <rastertrace/core/numbers/fraction.h>
#include <rastertrace/core/numbers/interval.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/edge_function.h>
#include <rastertrace/core/raster/sample_offset.h>
#include <rastertrace/core/raster/triangle.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>

namespace rastertrace {

/// The sample points of all pixels. Lengths are in the scene's own coordinates.
template <typename Scalar> class SampleGrid {
public:
    using Length = Scalar;

    SampleGrid(const SampleOffset<Scalar>& offset, const Canvas& canvas)
        : canvas_(canvas), offset_(offset), whole_rows_(floor_index(offset.y())) {}

    const SampleOffset<Scalar>& offset() const { return offset_; }

    /// The triangle in the coordinates of the grid.
    const Triangle<Length>& in_lengths(const Triangle<Scalar>& triangle) const { return triangle; }

    /// +1 if a vertex (`in_lengths`) with a larger y lies lower in the picture, else -1.
    int down() const { return canvas_.down(); }

    /// The first row whose samples are not above the height `y`. Row 0 is the top of the canvas.
    Index first_row_from(const Length& y) const {
        if constexpr (std::same_as<Scalar, Interval>) {
            const Interval in_rows = y - offset_.y();
            return canvas_.row_of(down() > 0 ? ceil_index(in_rows) : floor_index(in_rows));
        }
        // A sample's height on the canvas is exact; y less the offset may be rounded to another
        // row.
        const Index near = floor_index(y) - whole_rows_;
        const Scalar sample = scalar_from<Scalar>(near) + offset_.y();
        const bool is_above = down() > 0 ? sample < y : y < sample; // as good as random: no branch
        return canvas_.row_of(near) + static_cast<Index>(is_above);
    }

    /// True if the sample at column `x` is not left of `length`.
    bool reaches(Index x, const Length& length) const {
        return !(scalar_from<Scalar>(x) + offset_.x() < length);
    }

    /// The sample of a column in a row.
    Vec<Length, 2> sample(Index x, int row) const {
        return {Length(scalar_from<Scalar>(x) + offset_.x()),
                Length(scalar_from<Scalar>(canvas_.y_of(row)) + offset_.y())};
    }

    /// Where an edge crosses a row of samples, in columns. Rounded up, it is the first sample that
    /// is not left of the edge.
    Length crossing(const Edge<Length>& edge, int row) const {
        const Length height = scalar_from<Scalar>(canvas_.y_of(row)) + offset_.y();
        return Length(edge.x_at(height) - offset_.x());
    }

    const Canvas& canvas() const { return canvas_; }

private:
    Canvas canvas_;
    SampleOffset<Scalar> offset_;
    Index whole_rows_; ///< of the offset, which may be 1 or below 0
};

/// Fractions over one denominator D become whole numbers, in units of 1/D pixel: x to the right of
/// the samples at x = 0, y down from the samples of the top row.
template <typename Integer> class SampleGrid<Fraction<Integer>> {
public:
    using Length = Integer;

    SampleGrid(const SampleOffset<Fraction<Integer>>& offset, const Canvas& canvas)
        : pixel_(offset.x().denominator), offset_x_(offset.x().numerator),
          offset_y_(offset.y().numerator), top_(canvas.top() * pixel_.value() + offset_y_),
          scene_down_(canvas.down()) {}

    SampleOffset<Fraction<Integer>> offset() const {
        return {{offset_x_, pixel_.value()}, {offset_y_, pixel_.value()}};
    }

    Triangle<Length> in_lengths(const Triangle<Fraction<Integer>>& triangle) const {
        Triangle<Length> result;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& [x, y] = triangle.vertices[i];
            assert(x.denominator == pixel_.value() && y.denominator == pixel_.value());
            result.vertices[i] = {x.numerator - offset_x_, scene_down_ * (y.numerator - top_)};
        }
        return result;
    }

    static int down() { return 1; }

    Index first_row_from(Length y) const { return index_from(-pixel_.divide(-y).quotient); }

    bool reaches(Index x, Length length) const { return length <= x * pixel_.value(); }

    /// D, a pixel's side.
    const Divisor<Length>& pixel() const { return pixel_; }

    /// A row or column as an index. It needs no clamping: plan.h takes fractions only for
    /// coordinates of less than 32 bits.
    static Index index_from(Length whole) { return static_cast<Index>(whole); }

private:
    Divisor<Integer> pixel_;
    Integer offset_x_; ///< of a sample from its pixel's integer point
    Integer offset_y_;
    Integer top_;    ///< y of the samples of the top row, in the scene
    int scene_down_; ///< the canvas's, for the scene's y
};

/// Walks along an edge from row to row and gives, on each, the first pixel whose sample is not left
/// of the edge. This is the form of Rational.
template <typename Scalar> class SampleWalk {
public:
    /// Along the edge from its upper vertex to its lower one, beginning in `row`. The edge must
    /// have height.
    SampleWalk(const Vertex<Scalar>& upper, const Vertex<Scalar>& lower,
               const SampleGrid<Scalar>& grid, int row)
        : edge_(edge_between(upper, lower)), grid_(grid), row_(row) {}

    Index first_sample() const { return ceil_index(grid_.crossing(edge_, row_)); }

    void step() { ++row_; }

private:
    Edge<Scalar> edge_;
    const SampleGrid<Scalar>& grid_;
    int row_;
};

/// The first sample that the edge function admits to a triangle on the right of the edge. Beyond
/// the canvas the function is not evaluated, and the result is `guess`.
template <Rounded Real>
[[gnu::cold, gnu::noinline]] Index first_admitted_sample(Vec<Real, 2> upper, Vec<Real, 2> lower,
                                                         const SampleGrid<Real>& grid, int row,
                                                         Index guess) {
    const auto function = function_of_left_edge<Real>({upper, 0}, {lower, 0}, grid.down());
    const auto admits = [&](Index x) { return function.admits(grid.sample(x, row)); };
    Index left = grid.canvas().left();
    Index end = grid.canvas().right() + Index{1};
    const Index near = std::clamp(guess, left, end);
    if ((near == end || admits(near)) && (near == left || !admits(near - 1)))
        return guess;
    // All samples right of the first admitted sample are admitted: rounding is monotonic.
    while (left < end) {
        const Index middle = left + (end - left) / 2;
        if (admits(middle))
            end = middle;
        else
            left = middle + 1;
    }
    return left;
}

/// How far rounding moves the crossing of an edge with a row, and the zero of its function, in
/// columns: with u the unit roundoff and X the larger |x|, 5 u |dx| + 2 u (X + 1) and 8 u (|dx| + 1),
/// so less than 64 u (X + 1). Of an edge so low that products underflow nothing is known.
template <std::floating_point Real>
Real margin_of(const Vec<Real, 2>& upper, const Vec<Real, 2>& lower) {
    using Limits = std::numeric_limits<Real>;
    const Real least_height = Limits::min() / Limits::epsilon();
    if (!(std::abs(lower.y - upper.y) > least_height))
        return 1;
    return 32 * Limits::epsilon() * (std::max(std::abs(upper.x), std::abs(lower.x)) + 1);
}

/// True if the crossing is farther than that from the sample that follows it, and from the one
/// before.
template <std::floating_point Real>
[[gnu::always_inline]] inline bool is_off_samples(Real crossing, Index next, Real margin) {
    const Real distance = static_cast<Real>(next) - crossing;
    return margin < distance && distance < 1 - margin;
}

/// Of intervals: surely, for all doubles in them.
template <std::same_as<Interval> Real>
double margin_of(const Vec<Interval, 2>& upper, const Vec<Interval, 2>& lower) {
    const double low =
        margin_of<double>({upper.x.low(), upper.y.low()}, {lower.x.low(), lower.y.high()});
    const double high =
        margin_of<double>({upper.x.high(), upper.y.high()}, {lower.x.high(), lower.y.low()});
    return std::max(low, high);
}
inline bool is_off_samples(Interval crossing, Index next, double margin) {
    return is_off_samples(crossing.low(), next, margin) &&
           is_off_samples(crossing.high(), next, margin);
}

/// In float, double and intervals of these, x on the edge is a guess, and the edge function decides.
/// It need not be evaluated if the crossing is farther from a sample than the rounding errors of
/// both: then both agree (unless the products of the function overflow, and its value is of no use).
template <Rounded Real> class SampleWalk<Real> {
public:
    SampleWalk(const Vertex<Real>& upper, const Vertex<Real>& lower, const SampleGrid<Real>& grid,
               int row)
        : edge_(edge_between(upper, lower)), lower_(lower.position), grid_(grid), row_(row),
          margin_(margin_of<Real>(upper.position, lower.position)),
          crossing_(grid.crossing(edge_, row)) {}

    [[gnu::always_inline]] Index first_sample() const {
        const Index guess = ceil_index(crossing_);
        return is_off_samples(crossing_, guess, margin_)
                   ? guess
                   : first_admitted_sample(edge_.start, lower_, grid_, row_, guess);
    }

    [[gnu::always_inline]] void step() {
        ++row_;
        crossing_ = grid_.crossing(edge_, row_);
    }

private:
    Edge<Real> edge_;
    Vec<Real, 2> lower_;
    const SampleGrid<Real>& grid_;
    int row_;
    decltype(margin_of<Real>({}, {})) margin_;
    Real crossing_; ///< in this row
};

/// On a grid of whole numbers, with one division per edge and none per row. In row r, sample k lies
/// on the edge if
///
///     k D = x1 + (dx/dy) (r D - y1),   so   k = (x1 dy + dx (r D - y1)) / (D dy)
///
/// k is kept rounded up, with the excess in units of 1/(D dy). From row to row k grows by dx/dy,
/// which is kept as a whole number of samples and a remainder.
template <typename Integer> class SampleWalk<Fraction<Integer>> {
public:
    SampleWalk(const Vertex<Integer>& upper, const Vertex<Integer>& lower,
               const SampleGrid<Fraction<Integer>>& grid, int row) {
        const Divisor<Integer>& pixel = grid.pixel();
        const Integer dx = lower.position.x - upper.position.x;
        const Divisor<Integer> dy(lower.position.y - upper.position.y);
        const Divisor<Integer> whole = pixel * dy;
        const Integer below_upper = row * pixel.value() - upper.position.y;
        const auto [samples_left, too_high] =
            whole.divide(-(upper.position.x * dy.value() + dx * below_upper));
        sample_ = -samples_left;
        too_high_ = too_high;
        whole_ = whole.value();

        const auto [whole_step, rest] = dy.divide(dx);
        whole_step_ = whole_step;
        rest_step_ = rest * pixel.value();
    }

    Index first_sample() const { return SampleGrid<Fraction<Integer>>::index_from(sample_); }

    void step() {
        // The carry is as good as random: a branch would be mispredicted in every other row.
        too_high_ -= rest_step_;
        const auto carry = static_cast<Integer>(too_high_ < 0);
        too_high_ += -carry & whole_;
        sample_ += whole_step_ + carry;
    }

private:
    Integer sample_;     ///< k, rounded up
    Integer too_high_;   ///< the excess of the rounding, 0 <= too_high_ < whole_
    Integer whole_;      ///< D dy
    Integer whole_step_; ///< from row to row: whole samples
    Integer rest_step_;  ///< and the remainder, in units of 1/(D dy)
};

} // namespace rastertrace
