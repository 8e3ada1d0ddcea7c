// SPDX-License-Identifier: MIT
#pragma once

// The depth buffer: for each pixel, the depth of the nearest triangle drawn there so far. A pixel is
// drawn only if its own depth is nearer.
//
//     kind        depth at a vertex      the buffer starts at    nearer is
//     linear-z    the distance z         farther than all        smaller
//     inverse-z   1/z                    0, infinitely far       larger
//     ndc-z       z after division       the far end             smaller (larger: view-plane)
//
// 1/z and z after the division are linear on the screen, z itself is not: T0, "Pintando faces",
// after Gambetta. The comparison is strict: of equal depths, the first one drawn stays.
//
// The buffer holds every depth turned: with the sign that makes the nearer one smaller, so that one
// comparison serves all three. Turning is exact, and turning twice gives the depth back.
//
//     DepthBuffer<double> buffer(region, {.larger_passes = true, .cleared = 0.0});
//     buffer.keep_if_nearer(*buffer.row_from(x, row), buffer.turned(0.25));

#include <rastertrace/core/canvas.h>
#include <rastertrace/core/scalar.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/triangle.h>
#include <rastertrace/core/vec.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace rastertrace {

/// When a depth passes, and what an untouched pixel holds.
template <typename Scalar> struct DepthRule {
    bool larger_passes = false;
    std::optional<Scalar> cleared = {}; ///< none: every depth passes
};

/// The pixels that have a depth: columns from `left` on, rows from `top_row` on.
struct DepthRegion {
    int left = 0;
    int top_row = 0;
    int width = 0;
    int height = 0;
};

/// One number per pixel of its region.
template <typename Scalar> class DepthBuffer {
public:
    DepthBuffer(const DepthRegion& region, const DepthRule<Scalar>& rule)
        : region_(region), rule_(rule),
          cells_(static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height),
                 clear_cell()),
          is_clear_(has_clear_cells() ? cells_.size() : 0, true) {}

    /// A depth with the sign that makes the nearer one smaller.
    Scalar turned(const Scalar& depth) const {
        return rule_.larger_passes ? Scalar(-depth) : depth;
    }

    /// A depth as the number that the buffer compares.
    static const Scalar& compared(const Scalar& depth) { return depth; }

    /// The turned depths of a row from column x on. The region must have the pixel.
    Scalar* row_from(int x, int row) {
        return cells_.data() + static_cast<std::ptrdiff_t>(row - region_.top_row) * region_.width +
               (x - region_.left);
    }

    /// Tests a turned depth against a cell of row_from(...), and keeps it if it passes.
    bool keep_if_nearer(Scalar& cell, const Scalar& depth) {
        if constexpr (!std::floating_point<Scalar>)
            if (has_clear_cells()) {
                const auto place = static_cast<std::size_t>(&cell - cells_.data());
                if (is_clear_[place]) {
                    is_clear_[place] = false;
                    cell = depth;
                    return true;
                }
            }
        const bool passes = depth < cell;
        if (passes)
            cell = depth;
        return passes;
    }

    /// The depth that a cell holds, if that is a number.
    std::optional<Scalar> stored(const Scalar& cell) const {
        if constexpr (std::floating_point<Scalar>) {
            if (!rule_.cleared && cell == clear_cell())
                return std::nullopt;
        } else {
            if (has_clear_cells() && is_clear_[static_cast<std::size_t>(&cell - cells_.data())])
                return std::nullopt;
        }
        return turned(cell);
    }

private:
    /// Floating point has a number beyond all others; exact numbers remember which cells are clear.
    bool has_clear_cells() const { return !std::floating_point<Scalar> && !rule_.cleared; }

    Scalar clear_cell() const {
        if (rule_.cleared)
            return turned(*rule_.cleared);
        if constexpr (std::floating_point<Scalar>)
            return std::numeric_limits<Scalar>::infinity();
        else
            return Scalar(0);
    }

    DepthRegion region_;
    DepthRule<Scalar> rule_;
    std::vector<Scalar> cells_;
    std::vector<bool> is_clear_;
};

/// One double per pixel, and which piece it is of: where the errors of two depths leave it open which
/// one is nearer, the exact depths of the two pieces are asked for.
template <> class DepthBuffer<Adaptive> {
public:
    /// Says whether the first piece is nearer than the second one, or than a clear cell if there is
    /// none, in the pixel at this x and row.
    using IsNearer = std::function<bool(std::uint32_t piece, std::optional<std::uint32_t> stored,
                                        int x, int row)>;

    DepthBuffer(const DepthRegion& region, const DepthRule<Adaptive>& rule)
        : region_(region), rule_(rule),
          cells_(static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height),
                 rule.cleared ? turned(*rule.cleared).value()
                              : std::numeric_limits<double>::infinity()),
          pieces_(cells_.size(), no_piece),
          largest_error_(rule.cleared ? rule.cleared->error() : 0) {}

    void ask(IsNearer is_nearer) { is_nearer_ = std::move(is_nearer); }

    /// The depths that follow are of this piece.
    void begin(std::uint32_t piece) { piece_ = piece; }

    /// How many tests have been decided exactly.
    std::uint64_t exact_tests() const { return exact_tests_; }

    /// Depths may be worked out in exact numbers, too.
    template <typename Depth> Depth turned(const Depth& depth) const {
        return rule_.larger_passes ? Depth(-depth) : depth;
    }
    template <typename Depth> static Adaptive compared(const Depth& depth) {
        return with_error(depth);
    }

    double* row_from(int x, int row) {
        return cells_.data() + static_cast<std::ptrdiff_t>(row - region_.top_row) * region_.width +
               (x - region_.left);
    }

    [[gnu::always_inline]] bool keep_if_nearer(double& cell, Adaptive depth) {
        const double difference = cell - depth.value();
        const double error = (depth.error() + largest_error_) * Adaptive::widening;
        const auto place = static_cast<std::size_t>(&cell - cells_.data());
        bool passes = difference > error;
        if (!passes && !(-difference > error)) [[unlikely]]
            passes = passes_when_near(place, error == 0);
        if (passes) {
            cell = depth.value();
            pieces_[place] = piece_;
            if (!(depth.error() <= largest_error_)) [[unlikely]]
                largest_error_ = depth.error();
        }
        return passes;
    }

    std::optional<Adaptive> stored(const double& cell) const {
        if (!std::isfinite(cell))
            return std::nullopt;
        return Adaptive(rule_.larger_passes ? -cell : cell, largest_error_);
    }

private:
    static constexpr std::uint32_t no_piece = std::numeric_limits<std::uint32_t>::max();

    [[gnu::noinline]] bool passes_when_near(std::size_t place, bool is_equal) {
        // What a piece has drawn before its numbers were made exact is drawn by it again.
        const std::uint32_t stored = pieces_[place];
        if (stored == piece_)
            return true;
        if (is_equal)
            return false;
        ++exact_tests_;
        const auto width = static_cast<std::size_t>(region_.width);
        return is_nearer_(piece_, stored == no_piece ? std::nullopt : std::optional(stored),
                          region_.left + static_cast<int>(place % width),
                          region_.top_row + static_cast<int>(place / width));
    }

    DepthRegion region_;
    DepthRule<Adaptive> rule_;
    std::vector<double> cells_;
    std::vector<std::uint32_t> pieces_;
    double largest_error_; ///< of a depth that has been stored
    std::uint32_t piece_ = no_piece;
    std::uint64_t exact_tests_ = 0;
    IsNearer is_nearer_;
};

/// The turned depths of a row of a triangle: linear in x.
template <typename Scalar> struct DepthRow {
    Scalar x;                       ///< where
    Scalar depth;                   ///< the depth is this, and
    Scalar slope;                   ///< from pixel to pixel it grows by this
    std::optional<Scalar> end = {}; ///< a pixel left of `x` or right of this has the depth there

    Scalar at(int column) const {
        const Scalar here = scalar_from<Scalar>(column);
        return depth + slope * ((end ? std::clamp(here, x, *end) : here) - x);
    }
};

/// The same in doubles that know their error: the row's numbers give the error of every pixel of it.
template <> struct DepthRow<Adaptive> {
    DepthRow(Adaptive x, Adaptive depth, Adaptive slope, std::optional<Adaptive> end)
        : x_(x.value()), depth_(depth.value()), slope_(slope.value()),
          first_(end ? x_ : -std::numeric_limits<double>::infinity()),
          last_(end ? end->value() : std::numeric_limits<double>::infinity()) {
        // d + s (x - x0), where s, x0 and the ends are off, and each operation rounds.
        const double steepest = std::abs(slope_) + slope.error();
        const double of_ends = x.error() + (end ? end->error() : 0);
        const bool is_level = steepest == 0;
        error_ =
            (depth.error() + steepest * of_ends +
             (is_level ? 0
                       : 2 * Adaptive::half_ulp * std::abs(depth_) + Adaptive::smallest_error)) *
            Adaptive::widening;
        error_per_pixel_ = (slope.error() + 4 * Adaptive::half_ulp * steepest) * Adaptive::widening;
    }

    [[gnu::always_inline]] Adaptive at(int column) const {
        const double way = std::min(std::max<double>(column, first_), last_) - x_;
        return Adaptive(depth_ + slope_ * way, error_ + error_per_pixel_ * std::abs(way));
    }

private:
    double x_;
    double depth_;
    double slope_;
    double first_; ///< left of it, and right of
    double last_;  ///< this, the depths of the ends hold
    double error_;
    double error_per_pixel_;
};

/// A slope that is too steep for its numbers belongs to a row or a triangle that is too thin to have
/// more than one depth.
template <typename Scalar> Scalar finite_or_zero(const Scalar& slope) {
    if constexpr (std::floating_point<Scalar>)
        return std::isfinite(slope) ? slope : Scalar(0);
    else
        return slope;
}

/// The vertices in the numbers that depths are worked out in.
template <typename Scalar>
std::array<Vec<Scalar, 2>, 3> depth_positions(const Triangle<Scalar>& triangle) {
    return triangle.vertices;
}

/// Fractions over one denominator are divided by it once.
template <typename Integer>
std::array<Vec<double, 2>, 3> depth_positions(const Triangle<Fraction<Integer>>& triangle) {
    const double unit = 1 / static_cast<double>(triangle.vertices[0].x.denominator);
    std::array<Vec<double, 2>, 3> result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = {static_cast<double>(triangle.vertices[i].x.numerator) * unit,
                     static_cast<double>(triangle.vertices[i].y.numerator) * unit};
    return result;
}

/// The turned depths of a triangle: those of its vertices, and linear between them. Both forms are
/// equal in exact arithmetic, and both keep equal depths equal. `Buffer` is what they are tested
/// against.
template <typename Scalar, typename Buffer = DepthBuffer<DepthOf<Scalar>>> class TriangleDepth {
public:
    using D = DepthOf<Scalar>;

    TriangleDepth(const Triangle<Scalar>& triangle, const std::array<D, 3>& depths,
                  Buffer& depth_buffer)
        : buffer(depth_buffer),
          positions_(depth_positions(triangle)), depths_{buffer.turned(depths[0]),
                                                         buffer.turned(depths[1]),
                                                         buffer.turned(depths[2])} {}

    /// The depth where an edge is at height y. A horizontal edge has that of its first vertex.
    D on_edge(const EdgeName& edge, const D& y) const {
        const D height = positions_[edge.to].y - positions_[edge.from].y;
        if (height == scalar_from<D>(0))
            return depths_[edge.from];
        return depths_[edge.from] +
               (depths_[edge.to] - depths_[edge.from]) * (y - positions_[edge.from].y) / height;
    }

    /// By rows, then across: the depths between the two ends of a row.
    static DepthRow<D> between(const D& left, const D& left_depth, const D& right,
                               const D& right_depth) {
        const D zero = scalar_from<D>(0);
        const D width = right - left;
        const D slope = zero < width ? finite_or_zero(D((right_depth - left_depth) / width)) : zero;
        return {left, left_depth, slope, zero < width ? right : left};
    }

    /// By weights: d = d1 + w2 (d2 - d1) + w3 (d3 - d1).
    D by_weights(const std::array<D, 3>& weights) const {
        return depths_[0] + weights[1] * (depths_[1] - depths_[0]) +
               weights[2] * (depths_[2] - depths_[0]);
    }

    /// The same for whole rows: the weights are linear in x and y, and so is the depth. `prepare`
    /// finds how fast it grows in x and in y. Samples lie `sample_offset` from integer points.
    void prepare(const D& sample_offset) {
        const auto& [a, b, c] = positions_;
        const D abx = b.x - a.x;
        const D aby = b.y - a.y;
        const D acx = c.x - a.x;
        const D acy = c.y - a.y;
        const D area2 = abx * acy - acx * aby;
        const D ab = depths_[1] - depths_[0];
        const D ac = depths_[2] - depths_[0];
        origin_ = {D(a.x - sample_offset), D(a.y - sample_offset)};
        if (area2 == scalar_from<D>(0))
            return;
        slope_x_ = finite_or_zero(D((ab * acy - ac * aby) / area2));
        slope_y_ = finite_or_zero(D((ac * abx - ab * acx) / area2));
    }
    DepthRow<D> on_row(int y) const {
        return {origin_.x, linear(depths_[0], slope_y_, scalar_from<D>(y), origin_.y), slope_x_,
                std::nullopt};
    }

    Buffer& buffer;

private:
    std::array<Vec<D, 2>, 3> positions_;
    std::array<D, 3> depths_;
    Vec<D, 2> origin_{}; ///< the first vertex, as samples are counted
    D slope_x_{};
    D slope_y_{};
};

} // namespace rastertrace
