// SPDX-License-Identifier: MIT
#pragma once

// The edge-table fill of a polygon of any shape, concave or crossing itself: on each row, the edges
// that the row meets are sorted by x, and the spans between them that lie inside are drawn.
//
// An edge has the rows from its upper vertex to before its lower one, as seen in the picture. So a
// row through a vertex meets one edge where the outline goes on, and two or none where it turns
// back: every row meets an even number of edges. A horizontal edge has no rows.
//
// Source: Foley, van Dam, Feiner and Hughes, Computer Graphics: Principles and Practice, 1990,
// section 3.6 (edge table and active-edge table); Adobe, PostScript Language Reference, 1999,
// section 4.5 (insideness: even-odd, non-zero winding number).
//
//     fill_edge_table<double>(corners, {}, {.fill_rule = FillRule::non_zero}, canvas,
//                             FlatPainter(image, color));

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/fill_scanline.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/core/raster/sample_offset.h>
#include <rastertrace/core/raster/sink.h>
#include <rastertrace/core/raster/span.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rastertrace {

/// The most corners that a polygon may have: an EdgeName holds no more.
inline constexpr std::size_t most_corners = 65535;

/// Which points lie inside a polygon that crosses itself, by its winding number there: how often it
/// runs around the point.
enum class FillRule {
    even_odd, ///< those around which it is odd
    non_zero, ///< those around which it is not 0
};

constexpr bool is_inside(int winding, FillRule rule) {
    return rule == FillRule::even_odd ? winding % 2 != 0 : winding != 0;
}

/// The choices that the edge-table fill leaves open.
struct EdgeTableRules {
    FillRule fill_rule = FillRule::even_odd;
    ScanlineRules rows;
};

/// An edge in the table, and where it meets the row at hand.
template <typename Scalar> struct TableEdge {
    EdgeWalk<Scalar> walk;
    Index first_row; ///< from the top of the picture
    Index end_row;   ///< behind its last one
    int turn;        ///< what it adds to the winding number: 1 if the polygon runs down along it
    Scalar x{};
};

/// The edges of a polygon that are not horizontal, from the first row of each. Emits all edges.
template <typename Scalar, typename Sink>
std::vector<TableEdge<Scalar>> edge_table(std::span<const Vec<Scalar, 2>> corners,
                                          const SampleOffset<Scalar>& offset, LerpForm lerp,
                                          const Canvas& canvas, Sink&& sink) {
    const auto first_row = [&](const Vertex<Scalar>& vertex) {
        return canvas.row_of(first_row_below(offset.in_rows(vertex.position.y), canvas.down()));
    };
    const int down = canvas.down();
    std::vector<TableEdge<Scalar>> table;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t next = (i + 1) % corners.size();
        const Vertex<Scalar> from{corners[i], static_cast<std::uint16_t>(i)};
        const Vertex<Scalar> to{corners[next], static_cast<std::uint16_t>(next)};
        const bool runs_down = down > 0 ? from.position.y < to.position.y //
                                        : to.position.y < from.position.y;
        const Vertex<Scalar>& upper = runs_down ? from : to;
        const Vertex<Scalar>& lower = runs_down ? to : from;
        const Edge<Scalar> edge = edge_between(upper, lower);
        sink(EdgeSetUp<Scalar>{
            .edge = edge.name, .is_horizontal = edge.is_horizontal, .dx_dy = edge.dx_dy});
        if (!edge.is_horizontal)
            table.push_back({.walk = {edge, lerp, down},
                             .first_row = first_row(upper),
                             .end_row = first_row(lower),
                             .turn = runs_down ? 1 : -1});
    }
    std::stable_sort(table.begin(), table.end(),
                     [](const auto& a, const auto& b) { return a.first_row < b.first_row; });
    return table;
}

/// Sorts the edges of a row from left to right; those that meet it in one point as they go on below
/// it. By insertion: hardly any change places from one row to the next. Every compiler makes the same
/// comparisons, so that intervals leave the same one open.
template <typename Scalar> void sort_by_x(std::vector<TableEdge<Scalar>*>& active, int down) {
    const auto is_before = [down](const TableEdge<Scalar>& a, const TableEdge<Scalar>& b) {
        if (a.x != b.x)
            return a.x < b.x;
        const Scalar& slope_a = a.walk.edge().dx_dy;
        const Scalar& slope_b = b.walk.edge().dx_dy;
        return down > 0 ? slope_a < slope_b : slope_b < slope_a;
    };
    for (std::size_t i = 1; i < active.size(); ++i)
        for (std::size_t k = i; k > 0 && is_before(*active[k], *active[k - 1]); --k)
            std::swap(active[k], active[k - 1]);
}

/// Yields the spans of a row that lie inside. `active` are its edges, from left to right.
template <typename Scalar, typename Sink>
void span_inside(int y, const std::vector<TableEdge<Scalar>*>& active,
                 const SampleOffset<Scalar>& offset, const EdgeTableRules& rules, Sink&& sink) {
    const TableEdge<Scalar>* left = nullptr;
    int winding = 0;
    for (const TableEdge<Scalar>* const edge : active) {
        winding += edge->turn;
        if (left == nullptr) {
            left = edge; // from outside to inside
        } else if (!is_inside(winding, rules.fill_rule)) {
            sink(ScanlineSpanned<Scalar>{
                .y = y,
                .left = left->x,
                .right = edge->x,
                .from = first_pixel(offset.in_columns(left->x), rules.rows.span),
                .to = last_pixel(offset.in_columns(edge->x), rules.rows.span),
                .left_edge = left->walk.name(),
                .right_edge = edge->walk.name()});
            left = nullptr;
        }
    }
}

/// Emits the edges of a row, and the winding number right of each.
template <typename Scalar, typename Sink>
void tell_crossings(int y, const std::vector<TableEdge<Scalar>*>& active, Sink&& sink) {
    if (!takes<RowCrossed<Scalar>>(sink))
        return;
    std::vector<EdgeName> edges;
    std::vector<Scalar> x;
    std::vector<int> winding;
    for (const TableEdge<Scalar>* const edge : active) {
        edges.push_back(edge->walk.name());
        x.push_back(edge->x);
        winding.push_back((winding.empty() ? 0 : winding.back()) + edge->turn);
    }
    sink(RowCrossed<Scalar>{.y = y, .edges = edges, .x = x, .winding = winding});
}

/// True if all of the corners lie left of the canvas, or all of them right of it.
template <typename Scalar>
bool misses_canvas(std::span<const Vec<Scalar, 2>> corners, const SampleOffset<Scalar>& offset,
                   const SpanRounding& rule, const Canvas& canvas) {
    const Scalar* leftmost = &corners[0].x;
    const Scalar* rightmost = &corners[0].x;
    for (const Vec<Scalar, 2>& corner : corners.subspan(1)) {
        if (corner.x < *leftmost)
            leftmost = &corner.x;
        if (*rightmost < corner.x)
            rightmost = &corner.x;
    }
    return last_pixel(offset.in_columns(*rightmost), rule) < canvas.left() ||
           first_pixel(offset.in_columns(*leftmost), rule) > canvas.right();
}

/// Fills a polygon row by row, from the top of the picture to its bottom, both ends of each span
/// included, from the row of its upper vertex to before that of its lower one. The time is
/// proportional to the rows on the canvas times the edges that they meet. Coordinates and the
/// slopes of the edges must be finite; at most 65,535 corners.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgeSetUp<Scalar>, RowCrossed<Scalar>, ScanlineSpanned<Scalar>, RowsRejected,
                 PrimitiveSkipped>
void fill_edge_table(std::span<const Vec<Scalar, 2>> corners, const SampleOffset<Scalar>& offset,
                     const EdgeTableRules& rules, const Canvas& canvas, Sink&& sink) {
    auto table = edge_table<Scalar>(corners, offset, rules.rows.lerp, canvas, sink);
    if (table.empty()) {
        sink(PrimitiveSkipped{.why = SkipReason::zero_area});
        return;
    }
    Index end_row = table.front().end_row;
    for (const TableEdge<Scalar>& edge : table)
        end_row = std::max(end_row, edge.end_row);
    const RowRange rows = rows_on_canvas(
        table.front().first_row, end_row - 1,
        [&] { return misses_canvas<Scalar>(corners, offset, rules.rows.span, canvas); }, canvas,
        sink);

    auto next = table.begin();
    std::vector<TableEdge<Scalar>*> active;
    for (int row = rows.begin; row < rows.end; ++row) {
        const int y = canvas.y_of(row);
        // Edges end, and others begin.
        std::erase_if(active, [row](const auto* edge) { return edge->end_row <= row; });
        for (; next != table.end() && next->first_row <= row; ++next)
            if (row < next->end_row)
                active.push_back(&*next);

        // Where they meet the row, from left to right.
        for (TableEdge<Scalar>* const edge : active)
            edge->x = edge->walk.x_on_row(y, offset);
        sort_by_x(active, canvas.down());
        tell_crossings(y, active, sink);
        span_inside(y, active, offset, rules, sink);
    }
}

} // namespace rastertrace
