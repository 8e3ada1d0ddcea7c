// SPDX-License-Identifier: MIT
#pragma once

// The depth buffer: for each pixel, the depth of the nearest primitive drawn there so far. A pixel is
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
// The buffer holds every depth turned: with the sign that makes the one that passes smaller (the nearer
// one, unless the scene asks for the other with `depth_compare`), so that one comparison serves all. Turning is
// exact, and turning twice gives the depth back.
//
// A primitive that can share no pixel with another one is not tested (pixel_stages in src/stages_of.h).
// Points and lines are tested as src/line_painter.h says: for them, the buffer remembers whose each depth is.
// What they are drawn at is kept beside the depths of faces, so no line takes a face away from the next one.
//
//     DepthBuffer<double> buffer(region, {.larger_passes = true, .cleared = 0.0});
//     buffer.keep_if_nearer(*buffer.row_from(x, row), buffer.turned(0.25));

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/core/raster/triangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace rastertrace {

/// When a depth passes, and what an untouched pixel holds.
template <typename Scalar> struct DepthRule {
    bool larger_passes = false;
    std::optional<Scalar> cleared = {}; ///< none: every depth passes
};

/// A depth with the sign that makes the nearer one smaller.
template <typename Depth> Depth turned(const Depth& depth, bool larger_passes) {
    return larger_passes ? Depth(-depth) : depth;
}

/// The pixels that have a depth: columns from `left` on, rows from `top_row` on.
struct DepthRegion {
    int left = 0;
    int top_row = 0;
    int width = 0;
    int height = 0;

    bool has(int x, int row) const {
        return left <= x && x < left + width && top_row <= row && row < top_row + height;
    }
};

template <typename Scalar> struct DepthRow;

/// Of equal depths the thinner primitive passes.
enum class Thickness : std::uint8_t { point, line, face };

inline Thickness thickness_of(PrimitiveKind kind) {
    switch (kind) {
    case PrimitiveKind::point:
        return Thickness::point;
    case PrimitiveKind::line:
    case PrimitiveKind::outline:
        return Thickness::line;
    case PrimitiveKind::triangle:
        break;
    }
    return Thickness::face;
}

/// What was decided about a pixel, as in DepthTested.
struct DepthVerdict {
    bool passes;
    DepthReason reason = DepthReason::stored;
    std::string_view other = {};
    bool is_by_thin =
        false;             ///< a point or a line in the pixel has decided, even if a face is nearer
    bool is_exact = false; ///< with `adaptive`: doubles have left it open
};

/// One number per pixel of its region, that of the nearest face; and where points and lines are drawn, that of
/// the nearest of them.
template <typename Scalar> class DepthBuffer {
public:
    DepthBuffer(const DepthRegion& region, const DepthRule<Scalar>& rule,
                bool remembers_owners = false)
        : region_(region), rule_(rule),
          cells_(static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height),
                 clear_cell()),
          is_clear_(has_clear_cells() ? cells_.size() : 0, true),
          owners_(remembers_owners ? cells_.size() : 0, no_owner) {}

    /// The depths that follow are of this one of those that are drawn.
    void begin(std::uint32_t owner) { owner_ = owner; }

    /// True if it remembers of whom each depth is.
    bool remembers_owners() const { return !owners_.empty(); }

    /// True if the region has a pixel.
    bool has(int x, int row) const { return region_.has(x, row); }

    /// The face that a cell of row_from(...) has its depth from, if one has been drawn there.
    std::optional<std::uint32_t> owner_of(const Scalar& cell) const {
        const std::uint32_t owner = owners_[index_of(cell)];
        return owner == no_owner ? std::nullopt : std::optional(owner);
    }

    bool larger_passes() const { return rule_.larger_passes; }
    Scalar turned(const Scalar& depth) const {
        return rastertrace::turned(depth, rule_.larger_passes);
    }

    /// A depth, or those of a row from one pixel to another, in the numbers that the buffer compares.
    static const Scalar& compared(const Scalar& depth) { return depth; }
    static const DepthRow<Scalar>& compared(const DepthRow<Scalar>& row, int, int) { return row; }

    /// The turned depths of a row from column x on. The region must have the pixel.
    Scalar* row_from(int x, int row) {
        return cells_.data() + static_cast<std::ptrdiff_t>(row - region_.top_row) * region_.width +
               (x - region_.left);
    }

    /// True if a turned depth is nearer than a cell of row_from(...) has it.
    bool is_nearer(const Scalar& cell, const Scalar& depth) const {
        if constexpr (!std::floating_point<Scalar>)
            if (is_clear(cell))
                return true;
        return depth < cell;
    }

    /// True if a face in the cell is nearer than a turned depth.
    bool hides(const Scalar& cell, const Scalar& depth) const {
        return !is_clear(cell) && cell < depth;
    }

    /// Tests a turned depth of a face, and keeps it if no face in the cell is as near. True if no point or
    /// line is as near either.
    bool keep_if_nearer(Scalar& cell, const Scalar& depth) {
        if (!is_nearer(cell, depth))
            return false;
        cell = depth;
        if (has_clear_cells())
            is_clear_[index_of(cell)] = false;
        if (remembers_owners()) [[unlikely]] {
            owners_[index_of(cell)] = owner_;
            return !is_behind_thin(cell, depth, Thickness::face);
        }
        return true;
    }

    /// True if the point or line that is kept for a cell is nearer than a turned depth, or as near and no
    /// thicker.
    bool is_behind_thin(const Scalar& cell, const Scalar& depth, Thickness thickness) const {
        const Thin* const thin = thin_in(cell);
        return thin && (thickness < thin->thickness ? thin->depth < depth : !(depth < thin->depth));
    }

    /// The point or line that is kept for a cell.
    std::optional<std::uint32_t> thin_owner_of(const Scalar& cell) const {
        const Thin* const thin = thin_in(cell);
        return thin ? std::optional(thin->owner) : std::nullopt;
    }

    /// Keeps the turned depth of a point or a line that is drawn.
    void keep_thin(const Scalar& cell, const Scalar& depth, Thickness thickness) {
        thin_[index_of(cell)] = {depth, thickness, owner_};
    }

    /// Decides about a turned depth by `test()`, and tells both depths and what was decided.
    template <typename Test, typename Sink>
    bool decide_and_tell(Pixel pixel, int, const Scalar& cell, const Scalar& depth, Test&& test,
                         Sink&& sink) {
        if (!takes<DepthTested<Scalar>>(sink))
            return test().passes;
        std::optional<Scalar> of_thin;
        std::optional<Scalar> nearest = stored(cell);
        if (const Thin* const thin = thin_in(cell)) {
            of_thin = turned(thin->depth);
            if (!owner_of(cell) || !(cell < thin->depth))
                nearest = of_thin;
        }
        const DepthVerdict verdict = test();
        sink(DepthTested<Scalar>{.pixel = pixel,
                                 .depth = turned(depth),
                                 .stored = verdict.is_by_thin ? of_thin : nearest,
                                 .passes = verdict.passes,
                                 .reason = verdict.reason,
                                 .other = verdict.other});
        return verdict.passes;
    }

    /// Tests the turned depths of a face's row: calls `keep(x)` where they pass.
    template <typename Keep>
    [[gnu::always_inline]] void keep_nearer(int row, int first, int last,
                                            const DepthRow<Scalar>& depths, Keep&& keep) {
        const DepthRow<Scalar> near = depths; // a copy: no depth that is written can be part of it
        Scalar* const cells = row_from(0, row);
        for (int x = first; x <= last; ++x)
            if (keep_if_nearer(cells[x], near.at(x)))
                keep(x);
    }

    /// The depth that a cell holds, if that is a number.
    std::optional<Scalar> stored(const Scalar& cell) const {
        if constexpr (std::floating_point<Scalar>) {
            if (!rule_.cleared && cell == clear_cell())
                return std::nullopt;
        } else {
            if (is_clear(cell))
                return std::nullopt;
        }
        return turned(cell);
    }

private:
    static constexpr std::uint32_t no_owner = std::numeric_limits<std::uint32_t>::max();

    std::size_t index_of(const Scalar& cell) const {
        return static_cast<std::size_t>(&cell - cells_.data());
    }

    bool is_clear(const Scalar& cell) const {
        return has_clear_cells() && is_clear_[index_of(cell)];
    }

    /// A point or a line, as it was drawn in a pixel.
    struct Thin {
        Scalar depth;
        Thickness thickness;
        std::uint32_t owner;
    };
    const Thin* thin_in(const Scalar& cell) const {
        const auto found = thin_.empty() ? thin_.end() : thin_.find(index_of(cell));
        return found == thin_.end() ? nullptr : &found->second;
    }

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
    std::vector<std::uint32_t> owners_; ///< of the cells, if it remembers them
    std::uint32_t owner_ = no_owner;
    std::unordered_map<std::size_t, Thin> thin_; ///< the nearest of each cell that has one
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

/// A slope that is too steep for its numbers belongs to a row or a triangle that is too thin to have
/// more than one depth.
template <typename Scalar> Scalar finite_or_zero(const Scalar& slope) {
    if constexpr (std::floating_point<Scalar>)
        return std::isfinite(slope) ? slope : Scalar(0);
    else
        return slope;
}

/// The depths of an edge between its vertices: linear in y. A horizontal edge has that of its first
/// vertex.
template <typename Scalar> class DepthEdge {
public:
    DepthEdge(const Scalar& y, const Scalar& depth, const Scalar& other_y,
              const Scalar& other_depth)
        : y_(y), depth_(depth), height_(other_y - y), rise_(other_depth - depth),
          is_horizontal_(height_ == scalar_from<Scalar>(0)) {}

    Scalar at(const Scalar& y) const {
        return is_horizontal_ ? depth_ : Scalar(depth_ + rise_ * (y - y_) / height_);
    }

    /// The same, and the depth of an end beyond it.
    Scalar held_at(const Scalar& y) const {
        if (is_horizontal_)
            return depth_;
        const Scalar part = (y - y_) / height_;
        return depth_ + rise_ * std::clamp(part, scalar_from<Scalar>(0), scalar_from<Scalar>(1));
    }

private:
    Scalar y_;
    Scalar depth_;
    Scalar height_;
    Scalar rise_;
    bool is_horizontal_;
};

/// The depths between the two ends of a row.
template <typename Scalar>
DepthRow<Scalar> row_between(const Scalar& left, const Scalar& left_depth, const Scalar& right,
                             const Scalar& right_depth) {
    const Scalar zero = scalar_from<Scalar>(0);
    const Scalar width = right - left;
    const Scalar slope =
        zero < width ? finite_or_zero(Scalar((right_depth - left_depth) / width)) : zero;
    return {left, left_depth, slope, zero < width ? right : left};
}

/// The depths of a triangle as a plane: linear in x and y. Samples lie `sample_offset` from integer
/// points.
template <typename Scalar> class DepthPlane {
public:
    DepthPlane(const std::array<Vec<Scalar, 2>, 3>& positions, const std::array<Scalar, 3>& depths,
               const Scalar& sample_offset) {
        const auto& [a, b, c] = positions;
        const Scalar abx = b.x - a.x;
        const Scalar aby = b.y - a.y;
        const Scalar acx = c.x - a.x;
        const Scalar acy = c.y - a.y;
        const Scalar area2 = abx * acy - acx * aby;
        const Scalar ab = depths[1] - depths[0];
        const Scalar ac = depths[2] - depths[0];
        origin_ = {Scalar(a.x - sample_offset), Scalar(a.y - sample_offset)};
        depth_ = depths[0];
        if (area2 == scalar_from<Scalar>(0))
            return;
        slope_x_ = finite_or_zero(Scalar((ab * acy - ac * aby) / area2));
        slope_y_ = finite_or_zero(Scalar((ac * abx - ab * acx) / area2));
    }

    DepthRow<Scalar> on_row(int y) const {
        return {origin_.x, linear(depth_, slope_y_, scalar_from<Scalar>(y), origin_.y), slope_x_,
                std::nullopt};
    }

private:
    Vec<Scalar, 2> origin_{}; ///< the first vertex, as samples are counted
    Scalar depth_{};          ///< there
    Scalar slope_x_{};
    Scalar slope_y_{};
};

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
/// equal in exact arithmetic, and both keep equal depths equal.
template <typename Scalar> class TriangleDepth {
public:
    /// Of the vertices; `larger_passes` as in DepthRule.
    TriangleDepth(const std::array<Vec<Scalar, 2>, 3>& positions,
                  const std::array<Scalar, 3>& depths, bool larger_passes)
        : positions_(positions), depths_{turned(depths[0], larger_passes),
                                         turned(depths[1], larger_passes),
                                         turned(depths[2], larger_passes)} {}

    /// The depth where an edge is at height y.
    [[gnu::always_inline]] Scalar on_edge(const EdgeName& edge, const Scalar& y) {
        auto& depths = edges_[edge.from + edge.to - 1U];
        if (!depths)
            depths.emplace(positions_[edge.from].y, depths_[edge.from], positions_[edge.to].y,
                           depths_[edge.to]);
        return depths->at(y);
    }

    /// By weights: d = d1 + w2 (d2 - d1) + w3 (d3 - d1).
    Scalar by_weights(const std::array<Scalar, 3>& weights) const {
        return depths_[0] + weights[1] * (depths_[1] - depths_[0]) +
               weights[2] * (depths_[2] - depths_[0]);
    }

    /// The same for whole rows: the weights are linear in x and y, and so is the depth.
    DepthPlane<Scalar> plane(const Scalar& sample_offset) const {
        return {positions_, depths_, sample_offset};
    }

private:
    std::array<Vec<Scalar, 2>, 3> positions_;
    std::array<Scalar, 3> depths_;
    std::array<std::optional<DepthEdge<Scalar>>, 3>
        edges_; ///< those between 0 and 1, 0 and 2, 1 and 2
};

} // namespace rastertrace
