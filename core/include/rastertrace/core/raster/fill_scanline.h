// SPDX-License-Identifier: MIT
#pragma once

// The scanline fill of the textbooks: sort the vertices by height, join the two short edges, and on
// each row draw everything from the left edge to the right edge.
//
// Source: "Pintando faces" (lrdass/blog, 2022), after Gambetta, "Computer Graphics from Scratch"
// (CGFS), filled triangles; with the texts' slips put right (x grows by dx/dy, the middle row
// counts once, a horizontal edge is not divided by).
//
//     fill_scanline(triangle, {}, rules, canvas, FlatPainter(image, color));  // at integer points

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/choices.h>
#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/core/raster/sample_offset.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/span.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/core/raster/triangle.h>

#include <algorithm>

namespace rastertrace {

/// The choices that the scanline fill leaves open.
struct ScanlineRules {
    LerpForm lerp = LerpForm::direct;
    SpanRounding span = {};
    RowRule rows = RowRule::closed;
};

/// The y of the first row of pixels at or below height `y`, as seen in the picture.
template <typename Scalar> Index first_row_below(const Scalar& y, int down) {
    return down > 0 ? ceil_index(y) : floor_index(y);
}

/// The y of the last row of pixels at or above height `y`, as seen in the picture.
template <typename Scalar> Index last_row_above(const Scalar& y, int down) {
    return down > 0 ? floor_index(y) : ceil_index(y);
}

/// The y of the last row of a triangle whose lowest vertex is at height `y`.
template <typename Scalar> Index last_row_of(const Scalar& y, RowRule rows, int down) {
    return rows == RowRule::closed ? last_row_above(y, down) : first_row_below(y, down) - down;
}

/// The y of the first row whose short edge is the lower one. A row at the height of the middle
/// vertex belongs to the lower edge, which begins there: its x is that of the vertex, without
/// rounding. A horizontal lower edge has no rows: then that row is the last one of the upper edge.
template <typename Scalar>
Index first_lower_y(const JoinedEdges<Scalar>& edges, const SampleOffset<Scalar>& offset,
                    int down) {
    return edges.has_flat_bottom
               ? last_row_above(offset.in_rows(edges.bottom.position.y), down) + down
               : first_row_below(offset.in_rows(edges.middle.position.y), down);
}

/// What is known of an edge once it is set up.
template <typename Scalar> EdgeSetUp<Scalar> set_up(const Edge<Scalar>& edge) {
    return {.edge = edge.name,
            .dx_dy = edge.is_horizontal ? OrNull<Scalar>() : OrNull<Scalar>(edge.dx_dy)};
}

/// Reports the three edges.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgeSetUp<Scalar>>
void tell_edges(const JoinedEdges<Scalar>& edges, Sink&& sink) {
    if (!takes<EdgeSetUp<Scalar>>(sink))
        return;
    for (const Edge<Scalar>* edge : {&edges.upper, &edges.lower, &edges.long_edge})
        sink(set_up(*edge));
}

/// True if every span of the triangle lies left of the canvas, or every one lies right of it.
template <typename Scalar>
[[gnu::always_inline]] inline bool misses_canvas(const Triangle<Scalar>& triangle,
                                                 const SampleOffset<Scalar>& offset,
                                                 const SpanRounding& rule, const Canvas& canvas) {
    const auto& [a, b, c] = triangle.vertices;
    const Scalar right = offset.in_columns(std::max({a.x, b.x, c.x}));
    const Scalar left = offset.in_columns(std::min({a.x, b.x, c.x}));
    return last_pixel(right, rule) < canvas.left() || first_pixel(left, rule) > canvas.right();
}

/// Yields a row, from where the left edge meets it to where the right edge does.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, ScanlineSpanned<Scalar>>
[[gnu::always_inline]] inline void span_row(int y, EdgeWalk<Scalar>& along_left,
                                            EdgeWalk<Scalar>& along_right,
                                            const SampleOffset<Scalar>& offset,
                                            const SpanRounding& rule, Sink&& sink) {
    const Scalar left = along_left.x_on_row(y, offset);
    const Scalar right = along_right.x_on_row(y, offset);
    sink(ScanlineSpanned<Scalar>{.y = y,
                                 .left = left,
                                 .right = right,
                                 .from = first_pixel(offset.in_columns(left), rule),
                                 .to = last_pixel(offset.in_columns(right), rule),
                                 .left_edge = along_left.name(),
                                 .right_edge = along_right.name()});
}

/// Fills a triangle row by row, from the top of the picture to its bottom, both ends of each row
/// included. Rows are those whose samples lie between the highest and the lowest vertex (RowRule). A triangle
/// without area has rows, too: it is drawn as a point, or with one pixel on each row. The time is
/// proportional to the rows on the canvas, not to the size of the triangle. Coordinates and the
/// slopes of the edges must be finite.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgeSetUp<Scalar>, ScanlineSpanned<Scalar>, PixelsRejected<>,
                 PrimitiveSkipped<>>
void fill_scanline(const Triangle<Scalar>& triangle, const SampleOffset<Scalar>& offset,
                   const ScanlineRules& rules, Canvas canvas, Sink&& sink) {
    const int down = canvas.down();

    // Sort the vertices by height; join the two short edges against the long one.
    const JoinedEdges<Scalar> edges = joined_edges(triangle, down);
    tell_edges(edges, sink);

    // The rows between top and bottom, as far as the canvas has them.
    const Index first_row =
        canvas.row_of(first_row_below(offset.in_rows(edges.top.position.y), down));
    const Index last_row =
        canvas.row_of(last_row_of(offset.in_rows(edges.bottom.position.y), rules.rows, down));
    const Index first_lower_row = canvas.row_of(first_lower_y(edges, offset, down));
    const RowRange rows = rows_on_canvas(
        first_row, last_row, [&] { return misses_canvas(triangle, offset, rules.span, canvas); },
        canvas, sink);
    if (rows.is_empty())
        return;

    EdgeWalk<Scalar> along_long_edge(edges.long_edge, rules.lerp, down);
    EdgeWalk<Scalar> along_upper(edges.upper, rules.lerp, down);
    EdgeWalk<Scalar> along_lower(edges.lower, rules.lerp, down);
    for (int row = rows.begin; row < rows.end; ++row) {
        // The two edges of this row.
        EdgeWalk<Scalar>& along_short_edge = row < first_lower_row ? along_upper : along_lower;
        EdgeWalk<Scalar>& along_left = edges.long_edge_is_left ? along_long_edge : along_short_edge;
        EdgeWalk<Scalar>& along_right =
            edges.long_edge_is_left ? along_short_edge : along_long_edge;
        span_row(canvas.y_of(row), along_left, along_right, offset, rules.span, sink);
    }
}

} // namespace rastertrace
