// SPDX-License-Identifier: MIT
#pragma once

// The depth buffer: for each pixel, the depth of the nearest triangle drawn there so far. A pixel
// is drawn only if its own depth is nearer.
//
//     kind        depth at a vertex      the buffer starts at    nearer is
//     linear-z    the distance z         farther than all        smaller
//     inverse-z   1/z                    0, infinitely far       larger
//     ndc-z       z after division       the far end             smaller (larger: view-plane)
//
// The comparison is strict: of equal depths, the first one drawn stays.
//
// The buffer holds every depth turned: with the sign that makes the depth that passes the smaller
// one. That is the nearer depth, unless `depth_compare` asks for the other. So one comparison
// serves all kinds. Turning is exact, and turning twice gives the depth back.
//
// Source: Catmull 1974; T0, "Pintando faces", after Gambetta.
//
//     DepthBuffer<double> buffer(region, {.larger_passes = true, .cleared = 0.0});
//     paint_nearer(pixels, depths, buffer.row_from(0, row), colors, Color{255, 0, 0});

#include <rastertrace/core/raster/depth_interpolation.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/span.h>

#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace rastertrace {

/// The algorithm, for the pixels of a row. `cells` and `colors` are those of the column x = 0. The
/// depths of the row and the cells are turned.
template <std::floating_point Scalar>
[[gnu::always_inline]] inline void paint_nearer(PixelSpan pixels, const DepthRow<Scalar>& depths,
                                                Scalar* cells, Color* colors, Color color) {
    for (int x = pixels.first; x <= pixels.last; ++x) {
        const Scalar depth = depths.at(x);
        if (depth < cells[x]) {
            cells[x] = depth;
            colors[x] = color;
        }
    }
}

/// When a depth passes, and what an untouched pixel holds.
template <typename Scalar> struct DepthRule {
    bool larger_passes = false;
    std::optional<Scalar> cleared = {}; ///< none: every depth passes
};

/// One number per pixel of its region, the turned depth of what is nearest.
/// Of fractions: draw/paint/exact_depth_buffer.h.
template <typename Scalar> class DepthBuffer {
public:
    using Cell = Scalar;

    DepthBuffer(const DepthRegion& region, const DepthRule<Scalar>& rule)
        : region_(region), rule_(rule), cells_(region.area(), clear_cell()),
          is_clear_(has_clear_cells() ? cells_.size() : 0, true) {}

    const DepthRegion& region() const { return region_; }
    bool larger_passes() const { return rule_.larger_passes; }
    Scalar turned(const Scalar& depth) const {
        return rastertrace::turned(depth, rule_.larger_passes);
    }

    /// The turned depths of a row from column x on. The region must have the pixel.
    Scalar* row_from(int x, int row) { return cells_.data() + region_.offset_of(x, row); }

    /// The index of a cell of row_from(...) in row-major order.
    std::size_t index_of(const Scalar& cell) const {
        return static_cast<std::size_t>(&cell - cells_.data());
    }

    /// True if a turned depth is nearer than a cell of row_from(...) has it.
    bool is_nearer(const Scalar& cell, const Scalar& depth) const {
        return is_clear(cell) || depth < cell;
    }

    /// True if what a cell has is nearer than a turned depth.
    bool hides(const Scalar& cell, const Scalar& depth) const {
        return !is_clear(cell) && cell < depth;
    }

    /// Tests a turned depth, and keeps it if it is nearer.
    bool keep_if_nearer(Scalar& cell, const Scalar& depth) {
        if (!is_nearer(cell, depth))
            return false;
        cell = depth;
        if (has_clear_cells())
            is_clear_[index_of(cell)] = false;
        return true;
    }

    /// True if nothing has been drawn in a cell whose number cannot say so. Floating point has
    /// infinity for that; exact numbers need a flag.
    bool is_clear(const Scalar& cell) const {
        return has_clear_cells() && is_clear_[index_of(cell)];
    }

    /// The depth in a cell. `nullopt` if nothing has been drawn there and a clear cell has no
    /// depth.
    std::optional<Scalar> stored(const Scalar& cell) const {
        if constexpr (std::floating_point<Scalar>)
            if (!rule_.cleared && cell == clear_cell())
                return std::nullopt;
        return is_clear(cell) ? std::nullopt : std::optional(turned(cell));
    }

private:
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

} // namespace rastertrace
