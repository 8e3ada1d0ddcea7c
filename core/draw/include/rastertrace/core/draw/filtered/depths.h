// SPDX-License-Identifier: MIT
#pragma once

// Depths in filtered doubles, and the buffer that they are tested against. The formulas are those
// of depth_interpolation.h, in an order without overflow. Instead of an error bound for every
// operation there is one bound for a row, an edge or a triangle. u = 2^-53 is the relative rounding
// error of one operation.
//
//     DepthTests<Adaptive> tests(region, rule);
//     tests.ask(is_nearer, exact_depth);  // the exact fallback of undecided tests

#include <rastertrace/core/draw/paint/depth_tests.h>
#include <rastertrace/core/draw/paint/thin_depths.h>
#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/depth_interpolation.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace rastertrace {

/// One double per pixel, and the number of the piece that it belongs to. If the error bounds of two
/// depths leave undecided which one is nearer, the exact depths of the two pieces are compared.
template <> class DepthTests<Adaptive> {
public:
    /// Returns whether a piece is nearer than the stored one (than a clear cell if there is none)
    /// at this x and row, exactly.
    using IsNearer = std::function<bool(std::uint32_t piece, std::optional<std::uint32_t> stored,
                                        int x, int row)>;

    /// Returns the exact depth of a piece, or of a clear cell, at this x and row.
    using ExactDepth = std::function<Rational(std::optional<std::uint32_t> piece, int x, int row)>;

    /// The piece of each depth is always kept, with and without lines.
    DepthTests(const DepthRegion& region, const DepthRule<Adaptive>& rule, bool = true)
        : region_(region), rule_(rule),
          cells_(region.area(), rule.cleared ? turned(*rule.cleared).value()
                                             : std::numeric_limits<double>::infinity()),
          pieces_(cells_.size(), no_piece),
          largest_error_(rule.cleared ? rule.cleared->error() : 0) {}

    void ask(IsNearer is_nearer, ExactDepth exact_depth) {
        is_nearer_ = std::move(is_nearer);
        exact_depth_ = std::move(exact_depth);
    }

    /// The depths that follow are of this piece.
    void begin(std::uint32_t piece) { piece_ = piece; }

    /// The number of tests that took exact depths.
    std::uint64_t exact_tests() const { return exact_tests_; }

    /// A depth, or those of a row, in filtered doubles: pieces that fell back have exact ones.
    static Adaptive tested(Adaptive depth) { return depth; }
    static Adaptive tested(const Rational& depth) { return with_error(depth); }
    static const DepthRow<Adaptive>& tested(const DepthRow<Adaptive>& row, PixelSpan) {
        return row;
    }
    static DepthRow<Adaptive> tested(const DepthRow<Rational>& row, PixelSpan pixels);

    bool larger_passes() const { return rule_.larger_passes; }
    template <typename Depth> Depth turned(const Depth& depth) const {
        return rastertrace::turned(depth, rule_.larger_passes);
    }
    double* row_from(int x, int row) { return cells_.data() + region_.offset_of(x, row); }

    /// As in depth_tests.h, with the exact fallback.
    [[gnu::always_inline]] bool is_nearer(const double& cell, Adaptive depth) {
        const auto order = order_of(depth, in_cell(cell));
        return order ? *order < 0 : is_nearer_exactly(piece_, pieces_[index_of(cell)], cell);
    }

    bool hides(const double& cell, Adaptive depth) { return hides(cell, depth, piece_); }

    [[gnu::always_inline]] bool keep_if_nearer(double& cell, Adaptive depth) {
        if (!is_nearer(cell, depth))
            return false;
        cell = depth.value();
        pieces_[index_of(cell)] = piece_;
        widen_largest_error(depth.error());
        return !is_behind_thin(cell, depth, Thickness::face);
    }

    bool is_behind_thin(const double& cell, Adaptive depth, Thickness thickness) {
        const Thin* const thin = thin_.find(index_of(cell));
        if (!thin)
            return false;
        const bool is_thinner = thickness < thin->thickness;
        if (const auto order = order_of(depth, thin->depth))
            return is_thinner ? *order > 0 : *order >= 0;
        return is_thinner ? is_nearer_exactly(thin->owner, piece_, cell)
                          : !is_nearer_exactly(piece_, thin->owner, cell);
    }

    std::optional<std::uint32_t> thin_owner_of(const double& cell) const {
        const Thin* const thin = thin_.find(index_of(cell));
        return thin ? std::optional(thin->owner) : std::nullopt;
    }

    void keep_thin(const double& cell, Adaptive depth, Thickness thickness) {
        thin_.keep(index_of(cell), {depth, thickness, piece_});
    }

    /// Tests a face's row, whose depths have one error bound: calls `keep(x)` where they pass.
    template <typename Keep>
    void keep_nearer(int row, int first, int last, const DepthRow<Adaptive>& depths, Keep&& keep);

    std::optional<Adaptive> stored(const double& cell) const {
        if (!rule_.cleared && pieces_[index_of(cell)] == no_piece)
            return std::nullopt;
        return turned(in_cell(cell));
    }

    bool has(int x, int row) const { return region_.has(x, row); }

    /// The face that the depth in a cell belongs to, if one has been drawn there.
    std::optional<std::uint32_t> owner_of(const double& cell) const {
        const std::uint32_t piece = pieces_[index_of(cell)];
        return piece == no_piece ? std::nullopt : std::optional(piece);
    }

    /// Decides about a turned depth by `test()`, and emits both depths: as doubles if these have
    /// decided, else as exact numbers.
    template <typename Test, typename Sink>
    bool decide_and_tell(Pixel pixel, const double& cell, Adaptive depth, Test&& test,
                         Sink&& sink) {
        if (!takes<DepthTested<Adaptive>>(sink))
            return test().passes;
        const std::uint64_t exact_before = exact_tests_;
        std::optional<Thin> thin;
        if (const Thin* const found = thin_.find(index_of(cell)))
            thin = *found;
        std::optional<Adaptive> stored_depth = stored(cell);
        std::optional<std::uint32_t> stored_piece = owner_of(cell);
        const bool is_thin_nearer =
            thin && (!stored_piece || !hides(cell, thin->depth, thin->owner));
        const DepthVerdict verdict = test();
        if (is_thin_nearer || verdict.is_by_thin) {
            stored_depth = turned(thin->depth);
            stored_piece = thin->owner;
        }
        const auto emit = [&]<typename Number>(const Number& tested,
                                               const std::optional<Number>& nearest) {
            sink(DepthTested<Number>{.pixel = pixel,
                                     .depth = tested,
                                     .stored = nearest,
                                     .passes = verdict.passes,
                                     .reason = verdict.reason,
                                     .other = verdict.other});
        };
        if (!verdict.is_exact && exact_tests_ == exact_before && std::isfinite(depth.value()) &&
            (!stored_depth || std::isfinite(stored_depth->value()))) {
            emit(turned(depth), stored_depth);
        } else {
            const int row = row_of(cell);
            emit(exact_depth_(piece_, pixel.x, row),
                 stored_depth ? std::optional(exact_depth_(stored_piece, pixel.x, row))
                              : std::nullopt);
        }
        return verdict.passes;
    }

private:
    using Thin = ThinDepths<Adaptive>::Thin;
    static constexpr std::uint32_t no_piece = std::numeric_limits<std::uint32_t>::max();

    std::size_t index_of(const double& cell) const {
        return static_cast<std::size_t>(&cell - cells_.data());
    }

    /// The turned depth in a cell. Its error is at most the largest that has been stored.
    Adaptive in_cell(double cell) const { return Adaptive(cell, largest_error_); }

    void widen_largest_error(double error) {
        if (!(error <= largest_error_)) [[unlikely]]
            largest_error_ = std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
    }

    /// True if the face in a cell is nearer than a turned depth of a piece.
    bool hides(const double& cell, Adaptive depth, std::uint32_t piece) {
        const auto order = order_of(in_cell(cell), depth);
        return order ? *order < 0 : is_nearer_exactly(pieces_[index_of(cell)], piece, cell);
    }

    /// Compares two pieces, or a piece and a clear cell, in the pixel of a cell.
    [[gnu::noinline]] bool is_nearer_exactly(std::uint32_t piece, std::uint32_t other,
                                             const double& cell) {
        ++exact_tests_;
        const int column =
            static_cast<int>(index_of(cell) % static_cast<std::size_t>(region_.width));
        return is_nearer_(piece, other == no_piece ? std::nullopt : std::optional(other),
                          region_.left + column, row_of(cell));
    }

    int row_of(const double& cell) const {
        return region_.top_row +
               static_cast<int>(index_of(cell) / static_cast<std::size_t>(region_.width));
    }

    DepthRegion region_;
    DepthRule<Adaptive> rule_;
    std::vector<double> cells_;
    std::vector<std::uint32_t> pieces_;
    double largest_error_; ///< of all depths that have been stored
    std::uint32_t piece_ = no_piece;
    std::uint64_t exact_tests_ = 0;
    ThinDepths<Adaptive> thin_;
    IsNearer is_nearer_;
    ExactDepth exact_depth_;
};

/// The turned depths of a row, with one error bound.
template <> struct DepthRow<Adaptive> {
    double x;
    double depth;
    double slope;
    double first; ///< left of this, the depth is that of the left end
    double last;  ///< right of this, that of the right end
    double error;

    [[gnu::always_inline]] Adaptive at(int column) const {
        const double way = std::min(std::max<double>(column, first), last) - x;
        return Adaptive(depth + slope * way, error);
    }
};

template <typename Keep>
[[gnu::always_inline]] inline void
DepthTests<Adaptive>::keep_nearer(int row, int first, int last, const DepthRow<Adaptive>& depths,
                                  Keep&& keep) {
    double* const cells = row_from(0, row);
    std::uint32_t* const pieces = pieces_.data() + (cells - cells_.data());
    const DepthRow<Adaptive> near = depths; // a copy: no depth that is written can be part of it
    const std::uint32_t piece = piece_;
    const double error = (near.error + largest_error_) * Adaptive::widening;
    const bool has_thin = !thin_.is_empty();
    bool has_kept = false;
    for (int x = first; x <= last; ++x) {
        const Adaptive depth = near.at(x);
        const double difference = cells[x] - depth.value();
        if (!(difference > error)) {
            if (-difference > error || error == 0)
                continue;
            if (!is_nearer_exactly(piece, pieces[x], cells[x])) [[unlikely]]
                continue;
        }
        cells[x] = depth.value();
        pieces[x] = piece;
        has_kept = true;
        if (!has_thin || !is_behind_thin(cells[x], depth, Thickness::face))
            keep(x);
    }
    if (has_kept)
        widen_largest_error(near.error);
}

/// d + s (x - x0) from exact numbers: each of them is rounded once, and so are the three
/// operations. |x - x0| is largest in the first or the last pixel.
inline DepthRow<Adaptive> DepthTests<Adaptive>::tested(const DepthRow<Rational>& row,
                                                       PixelSpan pixels) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double u = Adaptive::half_ulp;
    const Adaptive x = with_error(row.x);
    const Adaptive depth = with_error(row.depth);
    const Adaptive slope = with_error(row.slope);
    const Adaptive end = row.end ? with_error(*row.end) : x;
    const double reach =
        std::max(std::abs(pixels.first - x.value()), std::abs(pixels.last - x.value()));
    const double steepest = std::abs(slope.value()) + slope.error();
    const double of_way = x.error() + end.error() + u * reach;
    const bool is_level = steepest == 0;
    const double rounded_off = is_level ? 0
                                        : u * (4 * steepest * reach + 2 * std::abs(depth.value())) +
                                              Adaptive::smallest_error;
    return {.x = x.value(),
            .depth = depth.value(),
            .slope = slope.value(),
            .first = row.end ? x.value() : -infinity,
            .last = row.end ? end.value() : infinity,
            .error = (depth.error() + steepest * of_way + slope.error() * reach + rounded_off) *
                     Adaptive::widening};
}

/// The error bound of d1 + t (d2 - d1), 0 <= t <= 1, where `rise` is d2 - d1. The errors of the
/// depths add at most the larger one of them, that of t at most |rise|. Five operations on the way
/// to t (d2 - d1) are rounded, and the sum.
inline double error_between(Adaptive depth, Adaptive other_depth, double rise, double of_t) {
    constexpr double u = Adaptive::half_ulp;
    const double of_depths = std::max(depth.error(), other_depth.error());
    if (rise == 0)
        return of_depths;
    const double largest = std::max(std::abs(depth.value()), std::abs(other_depth.value()));
    return (of_depths + (std::min(of_t, 1.0) + 6 * u) * std::abs(rise) + u * largest +
            Adaptive::smallest_error) *
           Adaptive::widening;
}

/// Leaves a primitive open if the depths of two vertices differ by more than doubles hold, with a
/// factor of 2 for rounding.
inline void require_finite_differences(const std::array<Adaptive, 3>& depths) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i)
        if (!std::isfinite(2 * (depths[i].value() - depths[(i + 1) % 3].value())))
            Adaptive::leave_open(infinity, infinity);
}

/// The depths of an edge, with one error bound.
template <> class DepthEdge<Adaptive> {
public:
    /// The error of t is that of the y of both vertices, over the height of the edge. Throws
    /// Undecided if the edge may be horizontal or not.
    DepthEdge(Adaptive y, Adaptive depth, Adaptive other_y, Adaptive other_depth)
        : y_(y.value()), depth_(depth.value()), height_(other_y.value() - y_),
          rise_(other_depth.value() - depth_), is_horizontal_(y == other_y),
          error_(is_horizontal_ ? depth.error()
                                : error_between(depth, other_depth, rise_,
                                                (y.error() + other_y.error()) * Adaptive::widening /
                                                    std::abs(height_))) {}

    /// The y of a row is exact.
    Adaptive at(Adaptive y) const {
        return Adaptive(is_horizontal_ ? depth_ : depth_ + rise_ * ((y.value() - y_) / height_),
                        error_);
    }

    /// The same, with y limited to the edge.
    Adaptive held_at(Adaptive y) const {
        const double part = is_horizontal_ ? 0 : (y.value() - y_) / height_;
        return Adaptive(depth_ + rise_ * std::clamp(part, 0.0, 1.0), error_);
    }

private:
    double y_;
    double depth_;
    double height_;
    double rise_;
    bool is_horizontal_;
    double error_;
};

/// The error of t is that of both ends, over the width. If the width may be 0, the depth still lies
/// between those of the ends.
inline DepthRow<Adaptive> row_between(Adaptive left, Adaptive left_depth, Adaptive right,
                                      Adaptive right_depth) {
    const double width = right.value() - left.value();
    const double rise = right_depth.value() - left_depth.value();
    const double slope = rise / width;
    const bool is_wide = width > 0 && std::isfinite(slope);
    const double of_t = is_wide ? (left.error() + right.error()) * Adaptive::widening / width : 1;
    return {.x = left.value(),
            .depth = left_depth.value(),
            .slope = is_wide ? slope : 0,
            .first = left.value(),
            .last = is_wide ? right.value() : left.value(),
            .error = error_between(left_depth, right_depth, rise, of_t)};
}

/// Two sides of a triangle as doubles, from its first vertex on, and their error bounds.
struct KnownSides {
    double abx, aby, acx, acy;
    double reach;    ///< the largest magnitude of these four,
    double of_reach; ///< and their error bound
    double area2;    ///< twice the signed area
    double of_area2;
    double smallest_area2; ///< a lower bound of |area2|: 0 if there may be no area

    explicit KnownSides(const std::array<Vec<Adaptive, 2>, 3>& positions) {
        const auto& [a, b, c] = positions;
        abx = b.x.value() - a.x.value();
        aby = b.y.value() - a.y.value();
        acx = c.x.value() - a.x.value();
        acy = c.y.value() - a.y.value();
        reach = std::max({std::abs(abx), std::abs(aby), std::abs(acx), std::abs(acy)});
        of_reach = 2 * std::max({a.x.error(), a.y.error(), b.x.error(), b.y.error(), c.x.error(),
                                 c.y.error()}) +
                   Adaptive::half_ulp * reach;
        area2 = abx * acy - acx * aby;
        of_area2 = error_of_products(reach, of_reach, reach, of_reach);
        const double smallest = (std::abs(area2) - of_area2) / Adaptive::widening;
        smallest_area2 = smallest > 0 ? smallest : 0;
    }
};

/// The depths of a triangle as a plane. The error bound holds in the triangle.
template <> class DepthPlane<Adaptive> {
public:
    /// Throws Undecided if the triangle may have no area.
    DepthPlane(const std::array<Vec<Adaptive, 2>, 3>& positions,
               const std::array<Adaptive, 3>& depths, const SampleOffset<Adaptive>& offset) {
        const KnownSides sides(positions);
        if (sides.smallest_area2 == 0)
            Adaptive::leave_open(sides.area2, sides.of_area2);
        const double ab = depths[1].value() - depths[0].value();
        const double ac = depths[2].value() - depths[0].value();
        const Adaptive x = positions[0].x - offset.x();
        const Adaptive y = positions[0].y - offset.y();
        origin_ = {x.value(), y.value()};
        depth_ = depths[0].value();
        slope_x_ = (ab * sides.acy - ac * sides.aby) / sides.area2;
        slope_y_ = (ac * sides.abx - ab * sides.acx) / sides.area2;

        // Depths differ by at most `range`, with an error of at most of_range.
        constexpr double u = Adaptive::half_ulp;
        const double range = std::max(std::abs(ab), std::abs(ac));
        const double of_depths =
            std::max({depths[0].error(), depths[1].error(), depths[2].error()});
        const double of_range = 2 * of_depths + u * range;
        error_ = depths[0].error();
        if (range == 0 && of_depths == 0)
            return;
        const double slope = std::max(std::abs(slope_x_), std::abs(slope_y_));
        const double of_slope = (error_of_products(range, of_range, sides.reach, sides.of_reach) +
                                 slope * sides.of_area2) *
                                    Adaptive::widening / sides.smallest_area2 +
                                u * slope;

        // d + s_x (x - x0) + s_y (y - y0), where |x - x0| and |y - y0| are at most `reach`.
        const double of_way = std::max(x.error(), y.error()) + sides.of_reach + u * sides.reach;
        error_ = (error_ + 2 * ((slope + of_slope) * of_way + of_slope * sides.reach) +
                  u * (6 * slope * sides.reach + 2 * std::abs(depth_)) + Adaptive::smallest_error) *
                 Adaptive::widening;
    }

    DepthRow<Adaptive> on_row(int y) const {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return {.x = origin_.x,
                .depth = depth_ + slope_y_ * (y - origin_.y),
                .slope = slope_x_,
                .first = -infinity,
                .last = infinity,
                .error = error_};
    }

private:
    Vec<double, 2> origin_{};
    double depth_;
    double slope_x_;
    double slope_y_;
    double error_; ///< of every depth in the triangle
};

} // namespace rastertrace
