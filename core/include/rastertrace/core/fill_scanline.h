// SPDX-License-Identifier: MIT
#pragma once

// The scanline fill of the textbooks: sort the vertices by height, join the two short edges, and on
// each row draw everything from the left edge to the right edge.
//
// Source: "Pintando faces" (lrdass/blog, 2022), after Gambetta, "Computer Graphics from Scratch"
// (CGFS), filled triangles; with the texts' slips put right (x grows by dx/dy, the middle row
// counts once, a horizontal edge is not divided by).
//
//     fill_scanline(triangle, paint, rules, image, sink);

#include <rastertrace/core/canvas.h>
#include <rastertrace/core/depth.h>
#include <rastertrace/core/edge.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/paint.h>
#include <rastertrace/core/rounding.h>
#include <rastertrace/core/scalar.h>
#include <rastertrace/core/sink.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/triangle.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace rastertrace {

/// The choices that the scanline fill leaves open.
struct ScanlineRules {
    LerpForm lerp = LerpForm::direct;
    SpanRounding span;
};

/// The y of the first row of pixels at or below height `y`, as seen in the picture.
template <typename Scalar> Index first_row_below(const Scalar& y, int down) {
    return down > 0 ? ceil_index(y) : floor_index(y);
}

/// The y of the last row of pixels at or above height `y`, as seen in the picture.
template <typename Scalar> Index last_row_above(const Scalar& y, int down) {
    return down > 0 ? floor_index(y) : ceil_index(y);
}

/// The y of the first row whose short edge is the lower one. The row of the middle vertex belongs to
/// it, unless it is horizontal: then that is the upper edge's last row.
template <typename Scalar> Index first_lower_y(const JoinedEdges<Scalar>& edges, int down) {
    return edges.has_flat_bottom ? last_row_above(edges.bottom.position.y, down) + down
                                 : first_row_below(edges.middle.position.y, down);
}

/// Reports the rows from `first_y` down to `last_y` that lie above or below the canvas.
template <typename Sink>
requires SinkFor<Sink, RowsRejected>
void report_rejected_rows(Index first_y, Index last_y, const Canvas& canvas, Sink&& sink) {
    const int down = canvas.down();
    if (canvas.row_of(first_y) < 0)
        sink(RowsRejected{.from_y = first_y, .to_y = canvas.top() - down});
    if (canvas.row_of(last_y) >= canvas.height)
        sink(RowsRejected{.from_y = canvas.bottom() + down, .to_y = last_y});
}

/// Reports that the edges are known.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgeSetUp<Scalar>>
void report_edges(const JoinedEdges<Scalar>& edges, Sink&& sink) {
    for (const Edge<Scalar>* edge : {&edges.upper, &edges.lower, &edges.long_edge})
        sink(EdgeSetUp<Scalar>{
            .edge = edge->name, .is_horizontal = edge->is_horizontal, .dx_dy = edge->dx_dy});
}

/// True if every span of the triangle lies left of the canvas, or every one lies right of it.
template <typename Scalar>
bool misses_canvas(const Triangle<Scalar>& triangle, const SpanRounding& rule,
                   const Canvas& canvas) {
    const auto& [a, b, c] = triangle.vertices;
    return last_pixel(std::max({a.x, b.x, c.x}), rule) < canvas.left() ||
           first_pixel(std::min({a.x, b.x, c.x}), rule) > canvas.right();
}

/// Fills the row at `y` from where the left edge meets it to where the right edge does.
template <typename Scalar, PixelStages stages, typename OfPixels, typename Sink>
requires SinkFor<Sink, ScanlineSpanned<Scalar>, PixelPlotted, PixelsRejected>
void fill_row(int y, EdgeWalk<Scalar>& along_left, EdgeWalk<Scalar>& along_right,
              const Paint<Scalar, stages, OfPixels>& paint, const ScanlineRules& rules,
              Image& image, Sink&& sink) {
    const Scalar left = along_left.x_on_row(y);
    const Scalar right = along_right.x_on_row(y);

    // How deep the triangle lies there.
    std::optional<DepthRow<DepthOf<Scalar>>> depths;
    std::optional<DepthOf<Scalar>> left_depth;
    std::optional<DepthOf<Scalar>> right_depth;
    if constexpr (stages.tests_depth) {
        const auto height = scalar_from<DepthOf<Scalar>>(y);
        const auto on_left = paint.depth->on_edge(along_left.name(), height);
        const auto on_right = paint.depth->on_edge(along_right.name(), height);
        depths = paint.depth->between(depth_scalar(left), on_left, depth_scalar(right), on_right);
        left_depth = paint.depth->buffer.turned(on_left);
        right_depth = paint.depth->buffer.turned(on_right);
    }

    // The pixels between them.
    const Index from = first_pixel(left, rules.span);
    const Index to = last_pixel(right, rules.span);
    sink(ScanlineSpanned<Scalar>{.y = y,
                                 .left = left,
                                 .right = right,
                                 .from = from,
                                 .to = to,
                                 .left_edge = along_left.name(),
                                 .right_edge = along_right.name(),
                                 .left_depth = left_depth,
                                 .right_depth = right_depth});
    if constexpr (stages.tests_depth)
        plot_tested_span(image.row(y), from, to, paint, *depths, sink);
    else
        plot_span(image.row(y), from, to, paint, sink);
}

/// Fills a triangle row by row, from the top of the picture to its bottom, both ends of each row
/// included. Rows are the integers y between the highest and the lowest vertex. A triangle without
/// area is drawn as its rows say: a point, or one pixel on each row. Time follows the rows and
/// pixels on the canvas, not the size of the triangle. Coordinates must be finite, and so must the
/// slope of every edge (plan.h tells).
template <typename Scalar, PixelStages stages, typename OfPixels, typename Sink>
requires SinkFor<Sink, EdgeSetUp<Scalar>, ScanlineSpanned<Scalar>, PixelPlotted, PixelsRejected,
                 RowsRejected, PrimitiveSkipped>
void fill_scanline(const Triangle<Scalar>& triangle, const Paint<Scalar, stages, OfPixels>& paint,
                   const ScanlineRules& rules, Image& image, Sink&& sink) {
    const Canvas canvas = image.canvas();
    const int down = canvas.down();
    const int top_y = canvas.top();

    // Sort the vertices by height; join the two short edges against the long one.
    const JoinedEdges<Scalar> edges = joined_edges(triangle, down);
    report_edges(edges, sink);

    // The rows between top and bottom.
    const Index first_y = first_row_below(edges.top.position.y, down);
    const Index last_y = last_row_above(edges.bottom.position.y, down);
    const Index first_row = canvas.row_of(first_y);
    const Index last_row = canvas.row_of(last_y);
    const Index first_lower_row = canvas.row_of(first_lower_y(edges, down));

    // Nothing to draw if it lies between two rows, or misses the canvas.
    if (last_row < first_row) {
        sink(PrimitiveSkipped{.why = SkipReason::between_rows});
        return;
    }
    if (misses_canvas(triangle, rules.span, canvas) || last_row < 0 || first_row >= canvas.height) {
        sink(PrimitiveSkipped{.why = SkipReason::off_canvas});
        return;
    }

    // Rows that the canvas does not have are not walked.
    const auto begin_row = static_cast<int>(std::max<Index>(first_row, 0));
    const auto end_row = static_cast<int>(std::min<Index>(last_row + 1, canvas.height));
    report_rejected_rows(first_y, last_y, canvas, sink);

    EdgeWalk<Scalar> along_long_edge(edges.long_edge, rules.lerp, down);
    EdgeWalk<Scalar> along_upper(edges.upper, rules.lerp, down);
    EdgeWalk<Scalar> along_lower(edges.lower, rules.lerp, down);
    for (int row = begin_row; row < end_row; ++row) {
        const int y = top_y + down * row;

        // The two edges of this row, and where it meets them.
        EdgeWalk<Scalar>& along_short_edge = row < first_lower_row ? along_upper : along_lower;
        EdgeWalk<Scalar>& along_left = edges.long_edge_is_left ? along_long_edge : along_short_edge;
        EdgeWalk<Scalar>& along_right =
            edges.long_edge_is_left ? along_short_edge : along_long_edge;
        fill_row(y, along_left, along_right, paint, rules, image, sink);
    }
}

} // namespace rastertrace
