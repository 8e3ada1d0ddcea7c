// SPDX-License-Identifier: MIT
#pragma once

// The line sweep of tinyrenderer's second lesson: cut the triangle at its middle vertex, fill the
// lower half, then the upper one, from the bottom of the picture to its top.
//
// Source: Sokolov, tinyrenderer, lesson 2, in the Chinese notes on it. Boundary A is the long edge,
// boundary B the short edge of the half. (The lesson's segment_height + 1, which makes boundary B
// miss its end, is not repeated; nor is the middle row, which it draws with both halves.)
//
//     fill_two_halves(triangle, paint, rules, image, sink);

#include <rastertrace/core/edge.h>
#include <rastertrace/core/fill_scanline.h>

#include <algorithm>

namespace rastertrace {

/// Fills the rows of one half, from the one at `first_y`, lowest in the picture, up to `last_y`.
template <typename Scalar, PixelStages stages, typename OfPixels, typename Sink>
requires SinkFor<Sink, ScanlineSpanned<Scalar>, PixelPlotted, PixelsRejected>
void fill_half(const JoinedEdges<Scalar>& edges, const Edge<Scalar>& short_edge, Index first_y,
               Index last_y, const Paint<Scalar, stages, OfPixels>& paint,
               const ScanlineRules& rules, Image& image, Sink&& sink) {
    const Canvas canvas = image.canvas();
    const int up = -canvas.down();
    const Index first_row = std::min<Index>(canvas.row_of(first_y), canvas.height - 1);
    const Index last_row = std::max<Index>(canvas.row_of(last_y), 0);

    // Boundary A is the long edge; which of the two is left is the same on every row of both
    // halves.
    EdgeWalk<Scalar> along_a(edges.long_edge, rules.lerp, up);
    EdgeWalk<Scalar> along_b(short_edge, rules.lerp, up);
    EdgeWalk<Scalar>& along_left = edges.long_edge_is_left ? along_a : along_b;
    EdgeWalk<Scalar>& along_right = edges.long_edge_is_left ? along_b : along_a;
    for (Index row = first_row; row >= last_row; --row)
        fill_row(canvas.y_of(static_cast<int>(row)), along_left, along_right, paint, rules, image,
                 sink);
}

/// Fills a triangle half by half. In exact arithmetic it draws the pixels of fill_scanline.
template <typename Scalar, PixelStages stages, typename OfPixels, typename Sink>
requires SinkFor<Sink, EdgeSetUp<Scalar>, HalfBegan, ScanlineSpanned<Scalar>, PixelPlotted,
                 PixelsRejected, RowsRejected, PrimitiveSkipped>
void fill_two_halves(const Triangle<Scalar>& triangle, const Paint<Scalar, stages, OfPixels>& paint,
                     const ScanlineRules& rules, Image& image, Sink&& sink) {
    const Canvas canvas = image.canvas();
    const int down = canvas.down();

    // Sort the vertices by height; the long edge is boundary A.
    const JoinedEdges<Scalar> edges = joined_edges(triangle, down);
    report_edges(edges, sink);

    const Index top_y = first_row_below(edges.top.position.y, down);
    const Index bottom_y = last_row_above(edges.bottom.position.y, down);
    const Index middle_y = first_lower_y(edges, down);

    // Nothing to draw if it lies between two rows, or misses the canvas.
    if (canvas.row_of(bottom_y) < canvas.row_of(top_y)) {
        sink(PrimitiveSkipped{.why = SkipReason::between_rows});
        return;
    }
    if (misses_canvas(triangle, rules.span, canvas) || canvas.row_of(bottom_y) < 0 ||
        canvas.row_of(top_y) >= canvas.height) {
        sink(PrimitiveSkipped{.why = SkipReason::off_canvas});
        return;
    }
    report_rejected_rows(top_y, bottom_y, canvas, sink);

    // The lower half, then the upper one.
    sink(HalfBegan{.is_upper = false, .from_y = bottom_y, .to_y = middle_y});
    fill_half(edges, edges.lower, bottom_y, middle_y, paint, rules, image, sink);
    sink(HalfBegan{.is_upper = true, .from_y = middle_y - down, .to_y = top_y});
    fill_half(edges, edges.upper, middle_y - down, top_y, paint, rules, image, sink);
}

} // namespace rastertrace
