// SPDX-License-Identifier: MIT
#pragma once

// The fill of graphics hardware: a pixel is drawn if its sample point lies inside all three edges;
// a sample exactly on an edge belongs to the triangle only if that edge is a top or a left one.
// Then every sample on an edge that two triangles share has exactly one owner.
//
// Source: Pineda 1988 (edge functions); Direct3D 11 specification, section 3.4.2.1 (the top-left
// rule).
//
//     fill_top_left(triangle, paint, sample_offset, image, sink);
//
// An edge function is linear, so on a row of samples it changes sign once: where the edge crosses
// the row. Instead of asking every pixel of the box, the fill asks each edge for its crossing and
// draws what lies between the two: from the left edge's crossing, included, to the right edge's,
// not included. The crossing of an edge is computed from its upper vertex whichever triangle it
// belongs to, so both owners of a shared edge find the same number, rounded or not: there is
// neither a gap nor a double.

#include <rastertrace/core/edge.h>
#include <rastertrace/core/fill_scanline.h>

#include <algorithm>
#include <tuple>

namespace rastertrace {

/// The first pixel of a row whose sample does not lie left of `x`.
template <typename Scalar> Index first_sample_from(const Scalar& x, const Scalar& sample_offset) {
    return ceil_index(Scalar(x - sample_offset));
}

/// Walks along an edge from row to row of the picture and gives, on each, the first pixel whose
/// sample does not lie left of the edge.
template <typename Scalar> class SampleWalk {
public:
    SampleWalk(const Edge<Scalar>& edge, const Scalar& sample_offset, int)
        : edge_(edge), sample_offset_(sample_offset) {}

    Index first_sample_on_row(int y) {
        const Scalar sample_y = scalar_from<Scalar>(y) + sample_offset_;
        return first_sample_from(edge_.x_at(sample_y), sample_offset_);
    }

private:
    const Edge<Scalar>& edge_;
    const Scalar& sample_offset_;
};

/// The same in fractions of which all coordinates have one denominator D, without dividing on every
/// row. With numerators over D and the slope dx/dy, the sample with the number k lies on the edge
/// if
///
///     k D + s = x1 + (dx/dy) (y D + s - y1),   so   k = ((x1 - s) dy + dx (y D + s - y1)) / (D dy)
///
/// k is kept as a whole number and what it lies too high by, in units of 1/(D dy); from row to row
/// it moves by dx/dy. Each row asks for the next one.
template <typename Integer> class SampleWalk<Fraction<Integer>> {
public:
    SampleWalk(const Edge<Fraction<Integer>>& edge, const Fraction<Integer>& sample_offset,
               int down)
        : edge_(edge), denominator_(edge.start.x.denominator),
          offset_(sample_offset.numerator * (denominator_ / sample_offset.denominator)),
          down_(down) {}

    Index first_sample_on_row(int y) {
        if (!has_begun_)
            begin_on_row(y);
        else
            step();
        return static_cast<Index>(std::clamp<Integer>(sample_, -farthest_index, farthest_index));
    }

private:
    void begin_on_row(int y) {
        const Integer dx = edge_.dx_dy.numerator;
        const Integer dy = edge_.dx_dy.denominator;
        const Integer above = (edge_.start.x.numerator - offset_) * dy +
                              dx * (y * denominator_ + offset_ - edge_.start.y.numerator);
        whole_ = denominator_ * dy;
        sample_ = -floor_quotient(-above, whole_);
        too_high_ = sample_ * whole_ - above;
        has_begun_ = true;
    }

    void step() {
        if (!has_step_) {
            const Integer dx = down_ * edge_.dx_dy.numerator;
            const Integer dy = edge_.dx_dy.denominator;
            whole_step_ = floor_quotient(dx, dy);
            rest_step_ = (dx - whole_step_ * dy) * denominator_;
            has_step_ = true;
        }
        sample_ += whole_step_;
        too_high_ -= rest_step_;
        if (too_high_ < 0) {
            too_high_ += whole_;
            ++sample_;
        }
    }

    const Edge<Fraction<Integer>>& edge_;
    Integer denominator_;
    Integer offset_; ///< s
    int down_;
    bool has_begun_ = false;
    Integer sample_ = 0;   ///< k, rounded up
    Integer too_high_ = 0; ///< by this much, 0 <= too_high_ < whole_
    Integer whole_ = 1;    ///< D dy
    bool has_step_ = false;
    Integer whole_step_ = 0; ///< from row to row: so many samples, and
    Integer rest_step_ = 0;  ///< this much of one
};

/// Reports the edge functions. Each is turned so that it is positive on the triangle's side.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgeFunctionSetUp<Scalar>>
void report_edge_functions(const JoinedEdges<Scalar>& edges, Sink&& sink) {
    const auto report = [&sink](const Vertex<Scalar>& from, const Vertex<Scalar>& to,
                                const Vertex<Scalar>& opposite, bool is_top_left) {
        const auto& p = from.position;
        const auto& q = to.position;
        const Scalar a = p.y - q.y;
        const Scalar b = q.x - p.x;
        const Scalar c = -(a * p.x) - b * p.y;
        const Scalar of_opposite = a * opposite.position.x + b * opposite.position.y + c;
        const bool is_turned = of_opposite < scalar_from<Scalar>(0);
        sink(EdgeFunctionSetUp<Scalar>{.edge = {from.place, to.place},
                                       .a = is_turned ? Scalar(-a) : a,
                                       .b = is_turned ? Scalar(-b) : b,
                                       .c = is_turned ? Scalar(-c) : c,
                                       .is_top_left = is_top_left});
    };
    // A horizontal upper edge is a top edge, a horizontal lower one a bottom edge.
    const auto& [top, middle, bottom] = std::tie(edges.top, edges.middle, edges.bottom);
    const bool short_edges_are_left = !edges.long_edge_is_left;
    report(top, middle, bottom, edges.upper.is_horizontal || short_edges_are_left);
    report(middle, bottom, top, !edges.lower.is_horizontal && short_edges_are_left);
    report(top, bottom, middle, edges.long_edge_is_left);
}

/// Reports where the two edges of a row cross it, and the pixels between.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, ScanlineSpanned<Scalar>>
void report_crossings(const JoinedEdges<Scalar>& edges, int y, bool is_upper, Index from, Index to,
                      const Scalar& sample_offset, Sink&& sink) {
    const Scalar sample_y = scalar_from<Scalar>(y) + sample_offset;
    const Edge<Scalar>& short_edge = is_upper ? edges.upper : edges.lower;
    const Edge<Scalar>& left_edge = edges.long_edge_is_left ? edges.long_edge : short_edge;
    const Edge<Scalar>& right_edge = edges.long_edge_is_left ? short_edge : edges.long_edge;
    sink(ScanlineSpanned<Scalar>{.y = y,
                                 .left = left_edge.x_at(sample_y),
                                 .right = right_edge.x_at(sample_y),
                                 .from = from,
                                 .to = to,
                                 .left_edge = left_edge.name,
                                 .right_edge = right_edge.name});
}

/// Fills a triangle so that each sample of a shared edge is drawn exactly once. A sample lies
/// `sample_offset` from a pixel's integer point, in x and in y. Top and left are those of the
/// picture, whichever way y points. A triangle without area has no inside and is skipped.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, EdgeFunctionSetUp<Scalar>, ScanlineSpanned<Scalar>, PixelPlotted,
                 PixelsRejected, RowsRejected, PrimitiveSkipped>
void fill_top_left(const Triangle<Scalar>& triangle, const Paint<Scalar>& paint,
                   const Scalar& sample_offset, Image& image, Sink&& sink) {
    const Canvas canvas = image.canvas();
    const int down = canvas.down();
    const int top_y = canvas.top();

    // The long edge against the two short ones.
    const JoinedEdges<Scalar> edges = joined_edges(triangle, down);
    if (!edges.has_area) {
        sink(PrimitiveSkipped{.why = SkipReason::zero_area});
        return;
    }
    report_edge_functions(edges, sink);

    // The rows of samples from the top vertex, included, to the bottom vertex, not included.
    const auto first_y_from = [&](const Scalar& y) {
        return first_row_below(Scalar(y - sample_offset), down);
    };
    const Index first_y = first_y_from(edges.top.position.y);
    const Index last_y = first_y_from(edges.bottom.position.y) - down;
    const Index first_row = canvas.row_of(first_y);
    const Index last_row = canvas.row_of(last_y);
    const Index first_lower_row = canvas.row_of(first_y_from(edges.middle.position.y));
    if (last_row < first_row) {
        sink(PrimitiveSkipped{.why = SkipReason::between_rows});
        return;
    }
    const auto& [a, b, c] = triangle.vertices;
    if (last_row < 0 || first_row >= canvas.height ||
        first_sample_from(std::max({a.x, b.x, c.x}), sample_offset) <= canvas.left() ||
        first_sample_from(std::min({a.x, b.x, c.x}), sample_offset) > canvas.right()) {
        sink(PrimitiveSkipped{.why = SkipReason::off_canvas});
        return;
    }
    report_rejected_rows(first_y, last_y, canvas, sink);

    const auto begin_row = static_cast<int>(std::max<Index>(first_row, 0));
    const auto end_row = static_cast<int>(std::min<Index>(last_row + 1, canvas.height));
    SampleWalk<Scalar> along_long_edge(edges.long_edge, sample_offset, down);
    SampleWalk<Scalar> along_upper(edges.upper, sample_offset, down);
    SampleWalk<Scalar> along_lower(edges.lower, sample_offset, down);
    for (int row = begin_row; row < end_row; ++row) {
        const int y = top_y + down * row;
        // The two edges of this row, and the samples from the left one to before the right one.
        SampleWalk<Scalar>& along_short_edge = row < first_lower_row ? along_upper : along_lower;
        const Index on_long_edge = along_long_edge.first_sample_on_row(y);
        const Index on_short_edge = along_short_edge.first_sample_on_row(y);
        const Index from = edges.long_edge_is_left ? on_long_edge : on_short_edge;
        const Index to = (edges.long_edge_is_left ? on_short_edge : on_long_edge) - 1;
        report_crossings(edges, y, row < first_lower_row, from, to, sample_offset, sink);
        plot_span(y, from, to, paint, image, sink);
    }
}

} // namespace rastertrace
