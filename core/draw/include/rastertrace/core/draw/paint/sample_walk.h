// SPDX-License-Identifier: MIT
#pragma once

// Where the samples of the pixels lie, and which of them an edge passes on each row: the arithmetic
// of the top-left fill, in the numbers that suit each kind of Scalar best.
//
//     const SampleGrid<double> grid(0.5, canvas);  // samples at the pixels' centers
//     SampleWalk<double> walk(top, bottom, grid, 3);
//     walk.first_sample();  // in row 3: the first x whose sample does not lie left of the edge
//     walk.step();          // row 4

#include <rastertrace/core/draw/paint/divisor.h>
#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/fraction.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/edge_function.h>
#include <rastertrace/core/raster/triangle.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>

namespace rastertrace {

/// The samples of all pixels: each lies `sample_offset` from its pixel's integer point, in x and in
/// y. A triangle is set against them in the scene's own coordinates.
template <typename Scalar> class SampleGrid {
public:
    using Length = Scalar;

    SampleGrid(const Scalar& sample_offset, const Canvas& canvas)
        : canvas_(canvas), offset_(sample_offset) {}

    /// Of a sample from its pixel's integer point, in x and in y.
    Scalar sample_offset() const { return offset_; }

    /// The triangle in the coordinates of the grid.
    const Triangle<Length>& in_lengths(const Triangle<Scalar>& triangle) const { return triangle; }

    /// +1 if a vertex (`in_lengths`) with a larger y lies lower in the picture, else -1.
    int down() const { return canvas_.down(); }

    /// The first row whose samples do not lie above the height `y`; row 0 is the top of the
    /// canvas.
    Index first_row_from(const Length& y) const {
        // A sample's height on the canvas is exact; y less the offset may be rounded to another row.
        const Index near = floor_index(y);
        const Scalar sample = scalar_from<Scalar>(near) + offset_;
        if (down() > 0)
            return canvas_.row_of(sample < y ? near + 1 : near);
        return canvas_.row_of(y < sample ? near - 1 : near);
    }

    /// True if the sample at column `x` does not lie left of `length`.
    bool reaches(Index x, const Length& length) const {
        return !(scalar_from<Scalar>(x) + offset_ < length);
    }

    /// The sample of a column in a row.
    Vec<Length, 2> sample(Index x, int row) const {
        return {Length(scalar_from<Scalar>(x) + offset_),
                Length(scalar_from<Scalar>(canvas_.y_of(row)) + offset_)};
    }

    /// Where an edge crosses a row of samples, in columns: the first sample that does not lie left of the
    /// edge is this, rounded up.
    Length crossing(const Edge<Length>& edge, int row) const {
        const Length height = scalar_from<Scalar>(canvas_.y_of(row)) + offset_;
        return Length(edge.x_at(height) - offset_);
    }

    const Canvas& canvas() const { return canvas_; }

private:
    Canvas canvas_;
    Scalar offset_;
};

/// Fractions over one denominator D become whole numbers, in units of 1/D pixel: x to the right of
/// the samples at x = 0, y down from the samples of the top row.
template <typename Integer> class SampleGrid<Fraction<Integer>> {
public:
    using Length = Integer;

    SampleGrid(const Fraction<Integer>& sample_offset, const Canvas& canvas)
        : pixel_(sample_offset.denominator), offset_(sample_offset.numerator),
          top_(canvas.top() * pixel_.value() + offset_), scene_down_(canvas.down()) {}

    Fraction<Integer> sample_offset() const { return {offset_, pixel_.value()}; }

    Triangle<Length> in_lengths(const Triangle<Fraction<Integer>>& triangle) const {
        Triangle<Length> result;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& [x, y] = triangle.vertices[i];
            assert(x.denominator == pixel_.value() && y.denominator == pixel_.value());
            result.vertices[i] = {x.numerator - offset_, scene_down_ * (y.numerator - top_)};
        }
        return result;
    }

    static int down() { return 1; }

    Index first_row_from(Length y) const { return index_from(-pixel_.divide(-y).quotient); }

    bool reaches(Index x, Length length) const { return length <= x * pixel_.value(); }

    /// D, a pixel's side.
    const Divisor<Length>& pixel() const { return pixel_; }

    /// A row or column as an index. On 64 bits it needs no clamping: there plan.h leaves a
    /// coordinate less than 32 bits.
    static Index index_from(Length whole) {
        if constexpr (sizeof(Length) <= sizeof(Index))
            return static_cast<Index>(whole);
        else
            return static_cast<Index>(std::clamp<Length>(whole, -farthest_index, farthest_index));
    }

private:
    Divisor<Integer> pixel_;
    Integer offset_; ///< of a sample from its pixel's integer point
    Integer top_;    ///< y of the samples of the top row, in the scene
    int scene_down_; ///< the canvas's, for the scene's y
};

/// Walks along an edge from row to row of the picture and gives, in each, the first pixel whose
/// sample does not lie left of the edge. This is the form of Rational and Adaptive, which round up what is
/// exact, or leave it open.
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

/// The first sample that the edge function lets a triangle on the right of the edge have, and one on its
/// left not; beyond the canvas nobody asks it. Where x on the edge has been rounded, it says `guess`.
template <std::floating_point Real>
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
    // To the right of the first one, all are admitted: rounding keeps the order of numbers.
    while (left < end) {
        const Index middle = left + (end - left) / 2;
        if (admits(middle))
            end = middle;
        else
            left = middle + 1;
    }
    return left;
}

/// The same in numbers that are rounded: x on the edge is a guess, and the edge function has the last word.
/// If the guess lies farther from the samples than rounding reaches, the function would say the same (unless
/// its products overflow: then it says nothing of use), and is not asked.
template <std::floating_point Real> class SampleWalk<Real> {
public:
    SampleWalk(const Vertex<Real>& upper, const Vertex<Real>& lower, const SampleGrid<Real>& grid,
               int row)
        : edge_(edge_between(upper, lower)), lower_(lower.position), grid_(grid), row_(row),
          margin_(margin_of(upper.position, lower.position)) {}

    [[gnu::always_inline]] Index first_sample() const {
        const Real crossing = grid_.crossing(edge_, row_);
        const Index guess = ceil_index(crossing);
        const Real distance = static_cast<Real>(guess) - crossing;
        return margin_ < distance && distance < 1 - margin_
                   ? guess
                   : first_admitted_sample(edge_.start, lower_, grid_, row_, guess);
    }

    void step() { ++row_; }

private:
    /// How far rounding moves the crossing, and the zero of the function, in columns: with u the unit
    /// roundoff and X the larger |x|, 5 u |dx| + 2 u (X + 1) and 8 u (|dx| + 1), so less than 64 u (X + 1).
    /// Of an edge so low that products underflow nothing is known.
    static Real margin_of(const Vec<Real, 2>& upper, const Vec<Real, 2>& lower) {
        using Limits = std::numeric_limits<Real>;
        const Real least_height = Limits::min() / Limits::epsilon();
        if (!(std::abs(lower.y - upper.y) > least_height))
            return 1;
        return 32 * Limits::epsilon() * (std::max(std::abs(upper.x), std::abs(lower.x)) + 1);
    }

    Edge<Real> edge_;
    Vec<Real, 2> lower_;
    const SampleGrid<Real>& grid_;
    int row_;
    Real margin_;
};

/// The same on a grid of whole numbers, without dividing in every row. In row r, the sample with
/// the number k lies on the edge if
///
///     k D = x1 + (dx/dy) (r D - y1),   so   k = (x1 dy + dx (r D - y1)) / (D dy)
///
/// k is kept as a whole number and what it lies too high by, in units of 1/(D dy); from row to row
/// it moves by dx/dy, kept as so many samples and a rest.
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
        // Whether the rests have made up a sample is as good as random: a branch would be guessed
        // wrong in every other row.
        too_high_ -= rest_step_;
        const auto carry = static_cast<Integer>(too_high_ < 0);
        too_high_ += -carry & whole_;
        sample_ += whole_step_ + carry;
    }

private:
    Integer sample_;     ///< k, rounded up
    Integer too_high_;   ///< by this much, 0 <= too_high_ < whole_
    Integer whole_;      ///< D dy
    Integer whole_step_; ///< from row to row: so many samples, and
    Integer rest_step_;  ///< this much of one
};

} // namespace rastertrace
