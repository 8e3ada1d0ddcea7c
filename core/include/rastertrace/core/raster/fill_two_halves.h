// SPDX-License-Identifier: MIT
#pragma once

// The line sweep of tinyrenderer's second lesson: cut the triangle at its middle vertex, fill the
// lower half, then the upper one, from the bottom of the picture to its top.
//
// Source: Sokolov, tinyrenderer, lesson 2, in the Chinese notes on it. Boundary A is the long edge,
// boundary B the short edge of the half. (The lesson's segment_height + 1, which makes boundary B
// miss its end, is not repeated; nor is the middle row, which it draws with both halves.)
//
//     fill_two_halves(triangle, {}, rules, canvas, FlatPainter(image, color));

#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/fill_scanline.h>

#include <algorithm>

namespace rastertrace {

/// Fills the rows of one half, from `first_row`, lowest in the picture, up to `last_row`, as far as
/// the canvas has them.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, ScanlineSpanned<Scalar>>
void fill_half(const JoinedEdges<Scalar>& edges, const Edge<Scalar>& short_edge, Index first_row,
               Index last_row, const SampleOffset<Scalar>& offset, const ScanlineRules& rules,
               Canvas canvas, Sink&& sink) {
    const int up = -canvas.down();

    // Boundary A is the long edge; which of the two is left is the same on every row of both
    // halves.
    EdgeWalk<Scalar> along_a(edges.long_edge, rules.lerp, up);
    EdgeWalk<Scalar> along_b(short_edge, rules.lerp, up);
    EdgeWalk<Scalar>& along_left = edges.long_edge_is_left ? along_a : along_b;
    EdgeWalk<Scalar>& along_right = edges.long_edge_is_left ? along_b : along_a;
    const Index highest_row = std::max<Index>(last_row, 0);
    for (Index row = std::min<Index>(first_row, canvas.height - 1); row >= highest_row; --row)
        span_row(canvas.y_of(static_cast<int>(row)), along_left, along_right, offset, rules.span,
                 sink);
}

/// Fills a triangle half by half. In exact arithmetic it draws the pixels of fill_scanline.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgeSetUp<Scalar>, HalfBegan<>, ScanlineSpanned<Scalar>, PixelsRejected<>,
                 PrimitiveSkipped<>>
void fill_two_halves(const Triangle<Scalar>& triangle, const SampleOffset<Scalar>& offset,
                     const ScanlineRules& rules, Canvas canvas, Sink&& sink) {
    const int down = canvas.down();

    // Sort the vertices by height; the long edge is boundary A.
    const JoinedEdges<Scalar> edges = joined_edges(triangle, down);
    tell_edges(edges, sink);

    const Index top_row =
        canvas.row_of(first_row_below(offset.in_rows(edges.top.position.y), down));
    const Index bottom_row =
        canvas.row_of(last_row_of(offset.in_rows(edges.bottom.position.y), rules.rows, down));
    const Index middle_row =
        std::min<Index>(canvas.row_of(first_lower_y(edges, offset, down)), bottom_row + 1);
    const RowRange rows = rows_on_canvas(
        top_row, bottom_row, [&] { return misses_canvas(triangle, offset, rules.span, canvas); },
        canvas, sink);
    if (rows.is_empty())
        return;

    // The lower half, then the upper one.
    const auto y_of = [&canvas](Index row) { return canvas.y_of(row); };
    sink(HalfBegan<>{.half = "lower", .from_y = y_of(bottom_row), .to_y = y_of(middle_row)});
    fill_half(edges, edges.lower, bottom_row, middle_row, offset, rules, canvas, sink);
    sink(HalfBegan<>{.half = "upper", .from_y = y_of(middle_row - 1), .to_y = y_of(top_row)});
    fill_half(edges, edges.upper, middle_row - 1, top_row, offset, rules, canvas, sink);
}

} // namespace rastertrace
