// SPDX-License-Identifier: MIT
#pragma once

// The fill of graphics hardware: a pixel is drawn if its sample point lies inside all three edges;
// a sample exactly on an edge belongs to the triangle only if that edge is a top or a left one.
// Then every sample on an edge that two triangles share has exactly one owner.
//
// Source: Pineda 1988 (edge functions); Direct3D 11 specification, section 3.4.2.1 (the top-left
// rule).
//
//     fill_top_left(triangle, SampleGrid<double>({0.5, 0.5}, canvas), canvas, FlatPainter(image, color));
//
// The triangle has the rows of samples from its top vertex (included) to its bottom vertex (not
// included). An edge function is linear, so on a row it changes sign once: where the edge crosses
// the row. The fill does not test every pixel of the box. It computes where the two edges of a row
// cross it, and draws the samples between: from the first that the left edge admits to the last
// that the right edge admits. Two triangles that share an edge compute the same crossing, so there
// is neither a gap nor an overlap.

#include <rastertrace/core/draw/paint/sample_walk.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/edge_function.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/span.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/core/raster/triangle.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace rastertrace {

/// The indices of a triangle's vertices, from the top of the picture to its bottom, and the side of
/// the long edge, which runs from the top vertex to the bottom vertex.
struct TriangleOrder {
    std::uint16_t top;
    std::uint16_t middle;
    std::uint16_t bottom;
    bool long_edge_is_left; ///< it passes the middle vertex on the left
};

/// Emits the edge functions. Not inlined, so that it leaves no trace in the code of a fill without
/// a listener.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgeSetUp<Scalar>>
[[gnu::noinline]] void tell_edge_functions(const Triangle<Scalar>& triangle,
                                           const TriangleOrder& order, int down, Sink&& sink) {
    const auto vertex = [&triangle](std::uint16_t index) {
        return Vertex<Scalar>{triangle.vertices[index], index};
    };
    for (const EdgeFunction<Scalar>& function :
         edge_functions<Scalar>({vertex(order.top), vertex(order.middle), vertex(order.bottom)},
                                order.long_edge_is_left, down))
        sink(EdgeSetUp<Scalar>{.edge = function.name,
                               .a = function.a,
                               .b = function.b,
                               .top_left = function.is_top_left});
}

/// Adds the crossings of a row with its two edges.
template <typename Scalar>
void add_crossings(const Triangle<Scalar>& triangle, const TriangleOrder& order, bool is_upper,
                   const SampleOffset<Scalar>& offset, ScanlineSpanned<Scalar>& span) {
    const auto edge = [&triangle](std::uint16_t upper, std::uint16_t lower) {
        return edge_between(Vertex<Scalar>{triangle.vertices[upper], upper},
                            Vertex<Scalar>{triangle.vertices[lower], lower});
    };
    const Edge<Scalar> long_edge = edge(order.top, order.bottom);
    const Edge<Scalar> short_edge =
        is_upper ? edge(order.top, order.middle) : edge(order.middle, order.bottom);
    const Edge<Scalar>& left_edge = order.long_edge_is_left ? long_edge : short_edge;
    const Edge<Scalar>& right_edge = order.long_edge_is_left ? short_edge : long_edge;
    const Scalar sample_y = scalar_from<Scalar>(span.y) + offset.y();
    span.left = left_edge.x_at(sample_y);
    span.right = right_edge.x_at(sample_y);
    span.left_edge = left_edge.name;
    span.right_edge = right_edge.name;
}

/// True if a triangle whose vertices lie right of the canvas has no sample on it. In rounded
/// numbers the vertices do not decide that: a left edge may still admit a sample of the last
/// column.
template <typename Scalar>
[[gnu::noinline]] bool lies_right_of_canvas(const Triangle<Scalar>& triangle,
                                            const SampleGrid<Scalar>& grid, Canvas canvas) {
    if constexpr (Rounded<Scalar>) {
        const auto [top, middle, bottom] = sorted_from_top(triangle, grid.down());
        const bool long_edge_is_left = side_of_edge(top, bottom, middle, grid.down()) > 0;
        const Index first_lower_row = grid.first_row_from(middle.position.y);
        const Index end_row =
            std::min<Index>(grid.first_row_from(bottom.position.y), canvas.height);
        for (Index row = std::max<Index>(grid.first_row_from(top.position.y), 0); row < end_row;
             ++row) {
            const bool is_upper = row < first_lower_row;
            const auto& upper = long_edge_is_left || is_upper ? top : middle;
            const auto& lower = !long_edge_is_left && is_upper ? middle : bottom;
            if (function_of_left_edge(upper, lower, grid.down())
                    .admits(grid.sample(canvas.right(), static_cast<int>(row))))
                return false;
        }
    }
    return true;
}

/// Emits a row: its pixels and, if the sink takes them, the crossings of its edges.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, ScanlineSpanned<Scalar>>
[[gnu::always_inline]] inline void yield_row(const Triangle<Scalar>& triangle,
                                             const TriangleOrder& order, bool is_upper, int y,
                                             const SampleGrid<Scalar>& grid, Index from, Index to,
                                             Sink&& sink) {
    ScanlineSpanned<Scalar> span{
        .y = y, .left = {}, .right = {}, .from = from, .to = to, .left_edge = {}, .right_edge = {}};
    if (takes<ScanlineSpanned<Scalar>>(sink))
        add_crossings(triangle, order, is_upper, grid.offset(), span);
    sink(span);
}

/// Fills a triangle so that each sample of a shared edge is drawn exactly once. `grid`
/// says where the samples lie. Top and left are those of the picture, whichever way y points. A
/// triangle without area has no inside and is skipped.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgeSetUp<Scalar>, ScanlineSpanned<Scalar>, PixelsRejected<>,
                 PrimitiveSkipped<>>
void fill_top_left(const Triangle<Scalar>& triangle, const SampleGrid<Scalar>& grid, Canvas canvas,
                   Sink&& sink) {
    // Sort the vertices by height. The long edge runs from top to bottom, the two short ones meet
    // at the middle vertex, left or right of it.
    const auto [top, middle, bottom] = sorted_from_top(grid.in_lengths(triangle), grid.down());
    const int middle_side = side_of_edge(top, bottom, middle, grid.down());
    if (middle_side == 0) {
        sink(PrimitiveSkipped<>{.why = SkipReason::zero_area});
        return;
    }
    const bool long_edge_is_left = middle_side > 0;
    const TriangleOrder order{top.index, middle.index, bottom.index, long_edge_is_left};
    if (takes<EdgeSetUp<Scalar>>(sink))
        tell_edge_functions(triangle, order, canvas.down(), sink);

    // The rows of samples from the top vertex, included, to the bottom vertex, not included, as far
    // as the canvas has them. The row of the middle vertex belongs to the lower short edge.
    const Index first_row = grid.first_row_from(top.position.y);
    const Index first_lower_row = grid.first_row_from(middle.position.y);
    const Index end_row = grid.first_row_from(bottom.position.y);
    const auto misses_sides = [&triangle, &grid, canvas, a = top.position.x, b = middle.position.x,
                               c = bottom.position.x] {
        return grid.reaches(canvas.left(), std::max({a, b, c})) ||
               (!grid.reaches(canvas.right(), std::min({a, b, c})) &&
                lies_right_of_canvas(triangle, grid, canvas));
    };
    const RowRange rows = rows_on_canvas(first_row, end_row - 1, misses_sides, canvas, sink);
    if (rows.is_empty())
        return;
    const auto middle_row =
        static_cast<int>(std::clamp<Index>(first_lower_row, rows.begin, rows.end));

    // Down the upper short edge, then down the lower one; the long edge opposite both. In each row,
    // the samples from the left edge to before the right one: a left edge has its own samples, a
    // right edge does not. That, and which rows there are, is the top-left rule.
    SampleWalk<Scalar> along_long_edge(top, bottom, grid, rows.begin);
    const auto fill_half = [&](bool is_upper, const auto& upper, const auto& lower, int begin,
                               int end) __attribute__((always_inline)) {
        if (begin == end)
            return;
        SampleWalk<Scalar> along_short_edge(upper, lower, grid, begin);
        for (int row = begin; row < end; ++row) {
            const Index on_long_edge = along_long_edge.first_sample();
            const Index on_short_edge = along_short_edge.first_sample();
            const auto [left, right] = long_edge_is_left ? std::pair(on_long_edge, on_short_edge)
                                                         : std::pair(on_short_edge, on_long_edge);
            // The next crossings are worked out while this row is painted: they do not wait for its
            // end.
            along_long_edge.step();
            along_short_edge.step();
            yield_row(triangle, order, is_upper, canvas.y_of(row), grid, left, right - 1, sink);
        }
    };
    fill_half(true, top, middle, rows.begin, middle_row);
    fill_half(false, middle, bottom, middle_row, rows.end);
}

} // namespace rastertrace
