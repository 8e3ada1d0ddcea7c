// SPDX-License-Identifier: MIT
#pragma once

// The scanline fill of the textbooks: sort the vertices by height, join the two short edges, and on
// each row draw everything from the left edge to the right edge.
//
// Source: "Pintando faces" (lrdass/blog, 2022), after Gambetta, "Computer Graphics from Scratch"
// (CGFS), filled triangles; with the texts' slips put right (x grows by dx/dy, the middle row
// counts once, a horizontal edge is not divided by).
//
//     fill_scanline(triangle, color, rules, image, sink);

#include <rastertrace/core/canvas.h>
#include <rastertrace/core/edge.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/rounding.h>
#include <rastertrace/core/scalar.h>
#include <rastertrace/core/sink.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/triangle.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace rastertrace {

/// The choices that the scanline fill leaves open.
struct ScanlineRules {
    LerpForm lerp = LerpForm::direct;
    SpanRounding span;
};

/// The vertices from the top of the picture to its bottom; on one height, from left to right. The
/// order in which the scene names them makes no difference to the edges, nor to any pixel.
template <typename Scalar>
std::array<Vertex<Scalar>, 3> sorted_from_top(const Triangle<Scalar>& triangle, int down) {
    std::array<Vertex<Scalar>, 3> vertices{
        {{triangle.vertices[0], 0}, {triangle.vertices[1], 1}, {triangle.vertices[2], 2}}};
    const auto is_before = [down](const Vertex<Scalar>& a, const Vertex<Scalar>& b) {
        const auto& p = a.position;
        const auto& q = b.position;
        if (p.y != q.y)
            return down > 0 ? p.y < q.y : q.y < p.y;
        return p.x != q.x ? p.x < q.x : a.place < b.place;
    };
    std::sort(vertices.begin(), vertices.end(), is_before);
    return vertices;
}

/// The y of the first row of pixels at or below height `y`, as seen in the picture.
template <typename Scalar> Index first_row_below(const Scalar& y, int down) {
    return down > 0 ? ceil_index(y) : floor_index(y);
}

/// The y of the last row of pixels at or above height `y`, as seen in the picture.
template <typename Scalar> Index last_row_above(const Scalar& y, int down) {
    return down > 0 ? floor_index(y) : ceil_index(y);
}

/// Plots the pixels of a row from x = `from` to x = `to`, as far as the canvas has them.
template <typename Sink>
requires SinkFor<Sink, PixelPlotted, PixelsRejected>
void plot_span(int y, Index from, Index to, Color color, Image& image, Sink&& sink) {
    if (to < from)
        return;
    const Index left = image.canvas().left();
    const Index right = image.canvas().right();
    if (from < left)
        sink(PixelsRejected{.y = y, .from = from, .to = std::min(to, left - 1)});

    const auto first = static_cast<int>(std::clamp(from, left, right + 1));
    const auto last = static_cast<int>(std::clamp(to, left - 1, right));
    Color* const row = image.row(y).data();
    for (int x = first; x <= last; ++x) {
        row[x - left] = color;
        sink(PixelPlotted{.pixel = {x, y}, .color = color});
    }

    if (to > right)
        sink(PixelsRejected{.y = y, .from = std::max(from, right + 1), .to = to});
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

/// Reports that an edge is known.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgeSetUp<Scalar>>
void report_edge(const Edge<Scalar>& edge, Sink&& sink) {
    sink(EdgeSetUp<Scalar>{
        .edge = edge.name, .is_horizontal = edge.is_horizontal, .dx_dy = edge.dx_dy});
}

/// Fills a triangle row by row, from the top of the picture to its bottom, both ends of each row
/// included. Rows are the integers y between the highest and the lowest vertex. A triangle without
/// area is drawn as its rows say: a point, or one pixel on each row. Time follows the rows and
/// pixels on the canvas, not the size of the triangle. Coordinates must be finite, and so must the
/// slope of every edge (plan.h tells).
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgeSetUp<Scalar>, ScanlineSpanned<Scalar>, PixelPlotted, PixelsRejected,
                 RowsRejected, PrimitiveSkipped>
void fill_scanline(const Triangle<Scalar>& triangle, Color color, const ScanlineRules& rules,
                   Image& image, Sink&& sink) {
    const Canvas canvas = image.canvas();
    const int down = canvas.down();
    const int top_y = canvas.top();

    // Sort the vertices by height.
    const auto [top, middle, bottom] = sorted_from_top(triangle, down);

    // The long edge runs from top to bottom. Opposite it lie the two short edges, joined at the
    // middle vertex. If there is no height at all, the lower one starts at the rightmost vertex.
    const bool has_height = top.position.y != bottom.position.y;
    const Edge<Scalar> long_edge = edge_between(top, bottom);
    const Edge<Scalar> upper = edge_between(top, middle);
    const Edge<Scalar> lower =
        has_height ? edge_between(middle, bottom) : edge_between(bottom, middle);
    report_edge(upper, sink);
    report_edge(lower, sink);
    report_edge(long_edge, sink);

    // The rows between top and bottom. The row of the middle vertex belongs to the lower short
    // edge, unless that one is horizontal: then it is the upper edge's last row.
    const Index first_y = first_row_below(top.position.y, down);
    const Index last_y = last_row_above(bottom.position.y, down);
    const Index first_row = canvas.row_of(first_y);
    const Index last_row = canvas.row_of(last_y);
    const bool flat_bottom = has_height && middle.position.y == bottom.position.y;
    const Index first_lower_row =
        flat_bottom ? last_row + 1 : canvas.row_of(first_row_below(middle.position.y, down));

    // Nothing to draw if it lies between two rows, or misses the canvas.
    const auto [leftmost, rightmost] =
        std::minmax({top.position.x, middle.position.x, bottom.position.x});
    const bool is_between_rows = last_row < first_row;
    const bool is_off_canvas = last_row < 0 || first_row >= canvas.height ||
                               last_pixel(rightmost, rules.span) < canvas.left() ||
                               first_pixel(leftmost, rules.span) > canvas.right();
    if (is_between_rows || is_off_canvas) {
        sink(PrimitiveSkipped{.why = is_between_rows ? SkipReason::between_rows
                                                     : SkipReason::off_canvas});
        return;
    }

    // Rows that the canvas does not have are not walked.
    const auto begin_row = static_cast<int>(std::max<Index>(first_row, 0));
    const auto end_row = static_cast<int>(std::min<Index>(last_row + 1, canvas.height));
    report_rejected_rows(first_y, last_y, canvas, sink);

    // Left and right: the long edge is on the left if it passes the middle vertex on the left.
    const bool long_edge_is_left = !(middle.position.x < long_edge.x_at(middle.position.y));

    EdgeWalk<Scalar> along_long_edge(long_edge, rules.lerp, down);
    EdgeWalk<Scalar> along_upper(upper, rules.lerp, down);
    EdgeWalk<Scalar> along_lower(lower, rules.lerp, down);
    for (int row = begin_row; row < end_row; ++row) {
        const int y = top_y + down * row;

        // The two edges of this row, and where it meets them.
        EdgeWalk<Scalar>& along_short_edge = row < first_lower_row ? along_upper : along_lower;
        EdgeWalk<Scalar>& along_left = long_edge_is_left ? along_long_edge : along_short_edge;
        EdgeWalk<Scalar>& along_right = long_edge_is_left ? along_short_edge : along_long_edge;
        const Scalar left = along_left.x_on_row(y);
        const Scalar right = along_right.x_on_row(y);

        // The pixels between them.
        const Index from = first_pixel(left, rules.span);
        const Index to = last_pixel(right, rules.span);
        sink(ScanlineSpanned<Scalar>{.y = y,
                                     .left = left,
                                     .right = right,
                                     .from = from,
                                     .to = to,
                                     .left_edge = along_left.name(),
                                     .right_edge = along_right.name()});

        plot_span(y, from, to, color, image, sink);
    }
}

} // namespace rastertrace
