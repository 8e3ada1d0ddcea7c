// SPDX-License-Identifier: MIT
#pragma once

// The depth buffer of exact depths (raster/depth_buffer.h). A cell takes no memory before something is drawn in it, and
// then that of two machine words; a fraction that is longer stands elsewhere.
//
//     ExactDepthBuffer buffer(region, {.larger_passes = true, .cleared = Rational(0)});
//     buffer.keep_if_nearer(*buffer.row_from(x, row), buffer.turned(Rational(1, 3)));

#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/core/raster/blank_vector.h>
#include <rastertrace/core/raster/depth_buffer.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace rastertrace {

/// As DepthBuffer, of fractions of any size.
class ExactDepthBuffer {
public:
    /// All zeros: nothing has been drawn.
    struct Cell {
        std::int64_t numerator;   ///< of the turned depth; or its place among the long ones
        std::int64_t denominator; ///< -1: it is a long one
    };

    ExactDepthBuffer(const DepthRegion& region, const DepthRule<Rational>& rule)
        : region_(region), larger_passes_(rule.larger_passes), cells_(region.area()) {
        if (rule.cleared)
            cleared_ = turned(*rule.cleared);
    }

    const DepthRegion& region() const { return region_; }
    bool larger_passes() const { return larger_passes_; }
    Rational turned(const Rational& depth) const {
        return rastertrace::turned(depth, larger_passes_);
    }

    Cell* row_from(int x, int row) { return cells_.data() + region_.offset_of(x, row); }
    std::size_t index_of(const Cell& cell) const {
        return static_cast<std::size_t>(&cell - cells_.data());
    }

    bool is_nearer(const Cell& cell, const Rational& depth) const {
        return !has_depth(cell) || depth < depth_of(cell);
    }
    bool hides(const Cell& cell, const Rational& depth) const {
        return has_depth(cell) && depth_of(cell) < depth;
    }

    bool keep_if_nearer(Cell& cell, const Rational& depth) {
        if (!is_nearer(cell, depth))
            return false;
        const mpz_class& above = depth.get_num();
        const mpz_class& below = depth.get_den();
        if (is_long(cell)) {
            long_ones_[static_cast<std::size_t>(cell.numerator)] = depth;
        } else if (above.fits_slong_p() && below.fits_slong_p()) {
            cell = {above.get_si(), below.get_si()};
        } else {
            cell = {static_cast<std::int64_t>(long_ones_.size()), -1};
            long_ones_.push_back(depth);
        }
        return true;
    }

    std::optional<Rational> stored(const Cell& cell) const {
        return has_depth(cell) ? std::optional(turned(depth_of(cell))) : std::nullopt;
    }

private:
    static bool is_clear(const Cell& cell) { return cell.denominator == 0; }
    static bool is_long(const Cell& cell) { return cell.denominator < 0; }
    bool has_depth(const Cell& cell) const { return !is_clear(cell) || cleared_; }

    /// The turned depth of a cell that has one.
    Rational depth_of(const Cell& cell) const {
        return is_long(cell)    ? long_ones_[static_cast<std::size_t>(cell.numerator)]
               : is_clear(cell) ? *cleared_
                                : Rational(cell.numerator, cell.denominator);
    }

    DepthRegion region_;
    bool larger_passes_;
    std::optional<Rational> cleared_; ///< turned
    BlankVector<Cell> cells_;
    std::deque<Rational> long_ones_;
};

} // namespace rastertrace
