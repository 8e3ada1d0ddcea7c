// SPDX-License-Identifier: MIT
#pragma once

// The depth tests of a picture: the depth buffer of the faces. If points or lines are tested too,
// also which face each depth is of, its owner, and the nearest point or line of each pixel.
//
//     DepthTests<double> tests(region, rule, has_lines);
//     tests.begin(3);  // the depths that follow are of primitive 3 of the list
//     tests.keep_if_nearer(*tests.row_from(x, row), tests.turned(0.25));

#include <rastertrace/core/draw/paint/exact_depth_buffer.h>
#include <rastertrace/core/draw/paint/thin_depths.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/depth_buffer.h>
#include <rastertrace/core/raster/depth_interpolation.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/span.h>
#include <rastertrace/core/raster/steps.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace rastertrace {

/// Of a picture in one kind of number. See also numbered_depths.h.
template <typename Depth> class DepthTests {
public:
    using Buffer =
        std::conditional_t<std::same_as<Depth, Rational>, ExactDepthBuffer, DepthBuffer<Depth>>;
    using Cell = typename Buffer::Cell;

    DepthTests(const DepthRegion& region, const DepthRule<Depth>& rule, bool has_lines = false)
        : buffer_(region, rule), owners_(has_lines ? region.area() : 0, no_owner) {}

    bool larger_passes() const { return buffer_.larger_passes(); }
    Depth turned(const Depth& depth) const { return buffer_.turned(depth); }
    bool has(int x, int row) const { return buffer_.region().has(x, row); }
    Cell* row_from(int x, int row) { return buffer_.row_from(x, row); }
    bool is_nearer(const Cell& cell, const Depth& depth) const {
        return buffer_.is_nearer(cell, depth);
    }

    /// The owner of the depths that follow.
    void begin(std::uint32_t owner) { owner_ = owner; }
    void begin_side(std::size_t) {}

    /// True if the owners of depths are kept.
    bool has_owners() const { return !owners_.empty(); }

    /// The face whose depth is in a cell of row_from(...). `nullopt` if no face has been drawn
    /// there.
    std::optional<std::uint32_t> owner_of(const Cell& cell) const {
        const std::uint32_t owner = owners_[buffer_.index_of(cell)];
        return owner == no_owner ? std::nullopt : std::optional(owner);
    }

    /// True if a face in the cell is nearer than a turned depth.
    bool hides(const Cell& cell, const Depth& depth) const { return buffer_.hides(cell, depth); }

    /// Tests a turned depth of a face, and keeps it if it is nearer than the cell. Returns true if
    /// it is also nearer than the point or line of the cell.
    bool keep_if_nearer(Cell& cell, const Depth& depth) {
        if (!buffer_.keep_if_nearer(cell, depth))
            return false;
        if (!has_owners()) [[likely]]
            return true;
        owners_[buffer_.index_of(cell)] = owner_;
        return !is_behind_thin(cell, depth, Thickness::face);
    }

    /// True if the point or line of a cell is nearer than a turned depth, or as near and no
    /// thicker.
    bool is_behind_thin(const Cell& cell, const Depth& depth, Thickness thickness) const {
        const auto* const thin = thin_.find(buffer_.index_of(cell));
        return thin && (thickness < thin->thickness ? thin->depth < depth : !(depth < thin->depth));
    }

    /// The point or line of a cell, if there is one.
    std::optional<std::uint32_t> thin_owner_of(const Cell& cell) const {
        const auto* const thin = thin_.find(buffer_.index_of(cell));
        return thin ? std::optional(thin->owner) : std::nullopt;
    }

    /// Keeps the turned depth of a point or a line that is drawn.
    void keep_thin(const Cell& cell, const Depth& depth, Thickness thickness) {
        thin_.keep(buffer_.index_of(cell), {depth, thickness, owner_});
    }

    /// The depth that is told of the face, or of the point or line, in a cell; not turned.
    template <typename> std::optional<Depth> stored_face(const Cell& cell) const {
        return buffer_.stored(cell);
    }
    template <typename> std::optional<Depth> stored_thin(const Cell& cell) const {
        const auto* const thin = thin_.find(buffer_.index_of(cell));
        return thin ? std::optional(turned(thin->depth)) : std::nullopt;
    }

    /// True if the face in a cell is nearer than the point or line, which there must be.
    bool hides_thin(const Cell& cell) const {
        return owner_of(cell) && hides(cell, thin_.find(buffer_.index_of(cell))->depth);
    }

protected:
    static constexpr std::uint32_t no_owner = std::numeric_limits<std::uint32_t>::max();

    Buffer buffer_;
    std::vector<std::uint32_t> owners_; ///< of the cells, if points or lines are tested
    std::uint32_t owner_ = no_owner;
    ThinDepths<Depth> thin_;
};

/// Tests the depths of a row of a face. Calls `keep(x)` for each pixel that passes.
template <typename Tests, typename Depth, typename Keep>
[[gnu::always_inline]] inline void keep_nearer(Tests& tests, int row, PixelSpan pixels,
                                               const DepthRow<Depth>& depths, Keep&& keep) {
    const DepthRow<Depth> near = depths; // a copy: no depth that is written can be part of it
    auto* const cells = tests.row_from(0, row);
    for (int x = pixels.first; x <= pixels.last; ++x)
        if (tests.keep_if_nearer(cells[x], near.at(x)))
            keep(x);
}

/// Returns what `test()` decides about a turned depth, and emits DepthTested with both depths.
template <typename Tests, typename Cell, typename Depth, typename Test, typename Sink>
bool decide_and_tell(Tests& tests, Pixel pixel, const Cell& cell, const Depth& depth, Test&& test,
                     Sink&& sink) {
    if (!takes<DepthTested<Depth>>(sink))
        return test().passes;
    const auto of_thin = tests.template stored_thin<Depth>(cell);
    const auto nearest =
        of_thin && !tests.hides_thin(cell) ? of_thin : tests.template stored_face<Depth>(cell);
    const DepthVerdict verdict = test();
    sink(DepthTested<Depth>{.x = pixel.x,
                            .y = pixel.y,
                            .depth = tests.turned(depth),
                            .stored = verdict.is_by_thin ? of_thin : nearest,
                            .pass = verdict.passes,
                            .side_of = verdict.side_of,
                            .beside = verdict.beside,
                            .behind = verdict.behind});
    return verdict.passes;
}

} // namespace rastertrace
