// SPDX-License-Identifier: MIT
#pragma once

// Filling in filtered doubles. A fill is certified first, then painted: its rows are kept until
// every decision about the triangle has been taken. exactly.h includes this and has the exact
// fallback.
//
//     CertainRows rows;
//     if (!left_open_by([&] { fill_top_left(triangle, grid, canvas, rows); }))
//         rows.paint_with(painter, [&](const auto& again) {
//             fill_top_left(triangle, grid, canvas, again);
//         });

#include <rastertrace/core/draw/filtered/colors.h>
#include <rastertrace/core/draw/filtered/depths.h>
#include <rastertrace/core/draw/paint/sample_walk.h>
#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/core/raster/triangle.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace rastertrace {

/// A line from one vertex to another: x as a function of y.
template <> struct Edge<Adaptive> {
    EdgeName name;
    Vec<Adaptive, 2> start;
    bool is_horizontal = false;
    Adaptive dx_dy{};
    double bound = 0; ///< the error bound of x anywhere between the vertices

    /// x at height y, which must lie between those of the vertices.
    Adaptive x_at(const Adaptive& y) const {
        const double x = start.x.value() + dx_dy.value() * (y.value() - start.y.value());
        if (y.error() == 0)
            return Adaptive(x, bound);
        const double steepest = std::abs(dx_dy.value()) + dx_dy.error();
        return Adaptive(x, (bound + steepest * y.error()) * Adaptive::widening);
    }
};

/// The error bound of x = x1 + a (y - y1): the errors of x1, a and y1, and the rounding errors of
/// the three operations, at the other end, where they are largest.
inline double bound_of_x(const Vec<Adaptive, 2>& start, Adaptive dx_dy, Adaptive dy) {
    constexpr double half_ulp = Adaptive::half_ulp;
    const double steepest = std::abs(dx_dy.value()) + dx_dy.error();
    const double height = std::abs(dy.value()) + dy.error();
    const double rise = steepest * height;
    const double error = start.x.error() + dx_dy.error() * height +
                         steepest * (start.y.error() + height * half_ulp) +
                         (std::abs(start.x.value()) + 2 * rise) * half_ulp +
                         Adaptive::smallest_error;
    return error * Adaptive::widening;
}

/// The edge between two vertices, with its bound.
template <>
inline Edge<Adaptive> edge_between(const Vertex<Adaptive>& from, const Vertex<Adaptive>& to) {
    const Adaptive dx = to.position.x - from.position.x;
    const Adaptive dy = to.position.y - from.position.y;
    const bool is_horizontal = dy == Adaptive(0);
    const Adaptive dx_dy = is_horizontal ? Adaptive(0) : dx / dy;
    return {.name = {from.index, to.index},
            .start = from.position,
            .is_horizontal = is_horizontal,
            .dx_dy = dx_dy,
            .bound = bound_of_x(from.position, dx_dy, dy)};
}

/// The triangle is moved by the sample offset, so that samples have integer coordinates: a filtered
/// double carries the error of that.
template <> class SampleGrid<Adaptive> {
public:
    using Length = Adaptive;

    SampleGrid(const SampleOffset<Adaptive>& offset, const Canvas& canvas)
        : canvas_(canvas), offset_(offset) {}

    const SampleOffset<Adaptive>& offset() const { return offset_; }

    Triangle<Length> in_lengths(const Triangle<Adaptive>& triangle) const {
        Triangle<Length> result;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& [x, y] = triangle.vertices[i];
            result.vertices[i] = {x - offset_.x(), y - offset_.y()};
        }
        return result;
    }

    int down() const { return canvas_.down(); }

    Index first_row_from(Length y) const {
        return canvas_.row_of(down() > 0 ? ceil_index(y) : floor_index(y));
    }

    bool reaches(Index x, Length length) const { return length <= scalar_from<Length>(x); }

    /// The column in which an edge crosses a row of samples.
    Length crossing(const Edge<Length>& edge, int row) const {
        return edge.x_at(scalar_from<Length>(canvas_.y_of(row)));
    }

private:
    Canvas canvas_;
    SampleOffset<Adaptive> offset_;
};

/// Runs what may leave a decision undecided; returns which comparison was, if one was.
template <typename Run> std::optional<Undecided> left_open_by(Run&& run) {
    try {
        run();
        return std::nullopt;
    } catch (const Undecided& undecided) {
        return undecided;
    }
}

/// The rows of a fill, kept until all of them are certain. A fill that yields single pixels is not
/// kept: it is run again.
class CertainRows {
public:
    template <typename Step> void operator()(const Step&) {}
    void operator()(const ScanlineSpanned<Adaptive>& span) { spans_.push_back(span); }
    void operator()(const SampleTested<Adaptive>&) { has_pixels_ = true; }
    void operator()(const PixelPlotted&) { has_pixels_ = true; }
    void operator()(const PrimitiveSkipped& step) { skipped_ = step; }

    template <typename Step> bool takes() const { return false; }

    void clear() {
        spans_.clear();
        has_pixels_ = false;
        skipped_.reset();
    }

    /// Why the primitive draws nothing, if so.
    const std::optional<PrimitiveSkipped>& skipped() const { return skipped_; }

    /// Gives the rows to a painter; calls `yield_again(painter)` if there were single pixels.
    template <typename Painter, typename YieldAgain>
    void paint_with(Painter&& painter, YieldAgain&& yield_again) const {
        if (has_pixels_)
            return yield_again(painter);
        for (const auto& span : spans_)
            painter(span);
    }

private:
    std::vector<ScanlineSpanned<Adaptive>> spans_;
    bool has_pixels_ = false;
    std::optional<PrimitiveSkipped> skipped_;
};

} // namespace rastertrace
