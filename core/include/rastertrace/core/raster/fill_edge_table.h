// SPDX-License-Identifier: MIT
#pragma once

// The edge-table fill of a polygon of any shape, concave or crossing itself: on each row, the edges
// that the row meets are sorted by x, and the spans between them that lie inside are drawn.
//
// An edge between y1 < y2 has the rows y1 <= y < y2, in the scene's own y. So a row through a vertex
// meets one edge where the outline goes on, and two or none where it turns back: every row meets an
// even number of edges. A horizontal edge has no rows. With RowRule::closed, a row that ends an edge
// is also drawn with the edges y1 < y <= y2, which come up to it from smaller y. With
// PolygonVertices::turning, edges whose larger y is a turning point have that row, too.
//
// Source: Foley, van Dam, Feiner and Hughes, Computer Graphics: Principles and Practice, 1990,
// section 3.6 (edge table and active-edge table); Adobe, PostScript Language Reference, 1999,
// section 4.5 (insideness: even-odd, non-zero winding number); Hearn and Baker, Computer Graphics,
// 1994, section 3-11 (vertices where the outline turns back count twice).
//
//     fill_edge_table<double>(corners, {}, {.fill_rule = FillRule::non_zero}, canvas,
//                             FlatPainter(image, color));

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/choices.h>
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
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace rastertrace {

/// The most corners that a polygon may have: an EdgeName holds no more.
inline constexpr std::size_t most_corners = 65535;

constexpr bool is_inside(int winding, FillRule rule) {
    return rule == FillRule::even_odd ? winding % 2 != 0 : winding != 0;
}

/// The choices that the edge-table fill leaves open.
struct EdgeTableRules {
    FillRule fill_rule = FillRule::even_odd;
    ScanlineRules rows{.rows = RowRule::half_open};
    PolygonVertices vertices = PolygonVertices::half_open;
};

/// An edge in the table, and where it meets the row at hand.
template <typename Scalar> struct TableEdge {
    EdgeWalk<Scalar> walk;
    Scalar low; ///< y of its vertices, in rows
    Scalar high;
    Index first_row; ///< from the top of the picture
    Index end_row;   ///< behind its last one
    int turn;        ///< what it adds to the winding number: 1 if the polygon runs down along it
    Scalar x{};

    /// True if it goes on from row y toward larger y, or, if not `onward`, toward smaller y.
    bool goes_on(int y, bool onward) const {
        return onward ? scalar_from<Scalar>(y) < high : low < scalar_from<Scalar>(y);
    }
};

/// True if the outline turns back at a corner: its neighbors that are not level with it lie on one side.
template <typename Scalar>
bool turns_back(std::span<const Vec<Scalar, 2>> corners, std::size_t corner) {
    const Scalar& y = corners[corner].y;
    const auto is_above = [&](std::size_t step) {
        std::size_t at = corner;
        do
            at = (at + step) % corners.size();
        while (corners[at].y == y && at != corner);
        return corners[at].y < y;
    };
    return is_above(1) == is_above(corners.size() - 1);
}

/// The edges of a polygon that are not horizontal, from the first row of each. Emits all edges.
template <typename Scalar, typename Sink>
std::vector<TableEdge<Scalar>>
edge_table(std::span<const Vec<Scalar, 2>> corners, const SampleOffset<Scalar>& offset,
           const EdgeTableRules& rules, const Canvas& canvas, Sink&& sink) {
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
        sink(set_up(edge));
        if (edge.is_horizontal)
            continue;
        const Scalar low = offset.in_rows((down > 0 ? upper : lower).position.y);
        const Scalar high = offset.in_rows((down > 0 ? lower : upper).position.y);
        const Index first = ceil_index(low);
        const Vertex<Scalar>& highest = down > 0 ? lower : upper;
        const bool has_high =
            rules.rows.rows == RowRule::closed || (rules.vertices == PolygonVertices::turning &&
                                                   turns_back<Scalar>(corners, highest.index));
        const Index end = has_high ? floor_index(high) + 1 : ceil_index(high);
        table.push_back({.walk = {edge, rules.rows.lerp, down},
                         .low = low,
                         .high = high,
                         .first_row = canvas.row_of(down > 0 ? first : end - 1),
                         .end_row = canvas.row_of(down > 0 ? end : first - 1),
                         .turn = runs_down ? 1 : -1});
    }
    std::stable_sort(table.begin(), table.end(),
                     [](const auto& a, const auto& b) { return a.first_row < b.first_row; });
    return table;
}

/// Sorts the edges of a row from left to right; those that meet it in one point as they go on toward
/// larger y, or, if not `onward`, toward smaller y. By insertion: hardly any change places from one row
/// to the next. Every compiler makes the same comparisons, so that intervals leave the same one open.
template <typename Scalar> void sort_by_x(std::vector<TableEdge<Scalar>*>& active, bool onward) {
    const auto is_before = [onward](const TableEdge<Scalar>& a, const TableEdge<Scalar>& b) {
        if (a.x != b.x)
            return a.x < b.x;
        const Scalar& slope_a = a.walk.edge().dx_dy;
        const Scalar& slope_b = b.walk.edge().dx_dy;
        return onward ? slope_a < slope_b : slope_b < slope_a;
    };
    for (std::size_t i = 1; i < active.size(); ++i)
        for (std::size_t k = i; k > 0 && is_before(*active[k], *active[k - 1]); --k)
            std::swap(active[k], active[k - 1]);
}

/// The spans of a row that lie inside. `active` are its edges, from left to right.
template <typename Scalar>
std::vector<ScanlineSpanned<Scalar>>
spans_inside(int y, const std::vector<TableEdge<Scalar>*>& active,
             const SampleOffset<Scalar>& offset, const EdgeTableRules& rules) {
    std::vector<ScanlineSpanned<Scalar>> spans;
    const TableEdge<Scalar>* left = nullptr;
    int winding = 0;
    for (const TableEdge<Scalar>* const edge : active) {
        winding += edge->turn;
        if (left == nullptr) {
            left = edge; // from outside to inside
        } else if (!is_inside(winding, rules.fill_rule)) {
            spans.push_back({.y = y,
                             .left = left->x,
                             .right = edge->x,
                             .from = first_pixel(offset.in_columns(left->x), rules.rows.span),
                             .to = last_pixel(offset.in_columns(edge->x), rules.rows.span),
                             .left_edge = left->walk.name(),
                             .right_edge = edge->walk.name()});
            left = nullptr;
        }
    }
    return spans;
}

/// Emits the edges of a row, and the winding number right of each.
template <typename Scalar, typename Sink>
void tell_crossings(int y, const std::vector<TableEdge<Scalar>*>& active, Sink&& sink) {
    if (!takes<RowCrossed<Scalar>>(sink))
        return;
    std::vector<EdgeName> edges;
    std::vector<Scalar> x;
    std::vector<std::int64_t> winding;
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

/// The spans that no other one has all the pixels of. Both lists are ordered from left to right.
template <typename Scalar>
std::vector<ScanlineSpanned<Scalar>>
spans_beyond(std::vector<ScanlineSpanned<Scalar>> spans,
             const std::vector<ScanlineSpanned<Scalar>>& others) {
    auto other = others.begin();
    std::erase_if(spans, [&](const ScanlineSpanned<Scalar>& span) {
        if (span.to < span.from)
            return true;
        while (other != others.end() && other->to < span.to)
            ++other;
        return other != others.end() && other->from <= span.from;
    });
    return spans;
}

/// Fills a polygon row by row, from the top of the picture to its bottom, both ends of each span
/// included, on the rows from its smallest y to before its largest one, or with RowRule::closed to that.
/// The time is proportional to the rows on the canvas times the edges that they meet. Coordinates and
/// the slopes of the edges must be finite; at most 65,535 corners.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgeSetUp<Scalar>, RowCrossed<Scalar>, ScanlineSpanned<Scalar>,
                 PixelsRejected<>, PrimitiveSkipped<>>
void fill_edge_table(std::span<const Vec<Scalar, 2>> corners, const SampleOffset<Scalar>& offset,
                     const EdgeTableRules& rules, const Canvas& canvas, Sink&& sink) {
    auto table = edge_table<Scalar>(corners, offset, rules, canvas, sink);
    if (table.empty()) {
        sink(PrimitiveSkipped<>{.why = SkipReason::zero_area});
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
        const auto those = [&](bool onward) {
            std::vector<TableEdge<Scalar>*> edges;
            std::copy_if(active.begin(), active.end(), std::back_inserter(edges),
                         [&](const auto* edge) { return edge->goes_on(y, onward); });
            sort_by_x(edges, onward);
            return edges;
        };
        const auto tell = [&](const auto& edges, const auto& spans) {
            tell_crossings(y, edges, sink);
            for (const ScanlineSpanned<Scalar>& span : spans)
                sink(span);
        };
        sort_by_x(active, true);
        if (rules.rows.rows == RowRule::half_open) {
            tell(active, spans_inside(y, active, offset, rules));
            continue;
        }

        // The row as it begins what lies at larger y, and what else it has as the end of what lies at smaller y.
        const auto onward = those(true);
        const auto spans = spans_inside(y, onward, offset, rules);
        if (!onward.empty())
            tell(onward, spans);
        const auto back = those(false);
        if (const auto more = spans_beyond(spans_inside(y, back, offset, rules), spans);
            !more.empty())
            tell(back, more);
    }
}

} // namespace rastertrace
