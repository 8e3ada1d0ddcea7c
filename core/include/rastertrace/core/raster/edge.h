// SPDX-License-Identifier: MIT
#pragma once

// The edge of a triangle as the scanline algorithm sees it: x as a function of y.
//
//     x = x1 + a (y - y1),   a = (x2 - x1) / (y2 - y1)
//
// The textbook calls this a linear interpolation, LERP, of x along y.

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/choices.h>
#include <rastertrace/core/raster/sample_offset.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/core/raster/triangle.h>

#include <array>
#include <cstdint>
#include <utility>

namespace rastertrace {

/// A vertex of a triangle, with its index in the order in which the scene names the vertices.
template <typename Scalar> struct Vertex {
    Vec<Scalar, 2> position;
    std::uint16_t index = 0;
};

/// A line from one vertex to another: x as a function of y.
template <typename Scalar> struct Edge {
    EdgeName name;
    Vec<Scalar, 2> start;
    bool is_horizontal = false; ///< then its only value is start.x, and dx_dy is 0
    Scalar dx_dy{};             ///< (x2 - x1)/(y2 - y1)

    /// x at height y, which must lie between those of the vertices.
    Scalar x_at(const Scalar& y) const { return linear(start.x, dx_dy, y, start.y); }
};

/// The edge between two vertices. A horizontal one is not divided by its height of 0: that is the
/// mistake that stops the textbook's own example.
template <typename Scalar>
Edge<Scalar> edge_between(const Vertex<Scalar>& from, const Vertex<Scalar>& to) {
    const Scalar dx = to.position.x - from.position.x;
    const Scalar dy = to.position.y - from.position.y;
    const Scalar zero = scalar_from<Scalar>(0);
    const bool is_horizontal = dy == zero;
    return {.name = {from.index, to.index},
            .start = from.position,
            .is_horizontal = is_horizontal,
            .dx_dy = is_horizontal ? zero : Scalar(dx / dy)};
}

/// The vertices from the top of the picture to its bottom; on one height, from left to right. The
/// order in which the scene names them makes no difference to the edges, nor to any pixel. Always
/// inline: handed over in memory, three vertices cost as much as all else in a small triangle.
template <typename Scalar>
[[gnu::always_inline]] inline std::array<Vertex<Scalar>, 3>
sorted_from_top(const Triangle<Scalar>& triangle, int down) {
    std::array<Vertex<Scalar>, 3> vertices{
        {{triangle.vertices[0], 0}, {triangle.vertices[1], 1}, {triangle.vertices[2], 2}}};
    const auto is_before = [down](const Vertex<Scalar>& a, const Vertex<Scalar>& b) {
        const auto& p = a.position;
        const auto& q = b.position;
        if (p.y != q.y)
            return down > 0 ? p.y < q.y : q.y < p.y;
        return p.x != q.x ? p.x < q.x : a.index < b.index;
    };
    // Three exchanges sort three.
    const auto sort_pair = [&is_before](Vertex<Scalar>& a, Vertex<Scalar>& b) {
        if (is_before(b, a))
            std::swap(a, b);
    };
    sort_pair(vertices[0], vertices[1]);
    sort_pair(vertices[1], vertices[2]);
    sort_pair(vertices[0], vertices[1]);
    return vertices;
}

/// The edges of a triangle as the row-by-row fills see them: the long one from top to bottom, and
/// opposite it the two short ones, joined at the middle vertex.
template <typename Scalar> struct JoinedEdges {
    Vertex<Scalar> top;
    Vertex<Scalar> middle;
    Vertex<Scalar> bottom;
    Edge<Scalar> long_edge;
    Edge<Scalar> upper;
    Edge<Scalar> lower;
    bool has_height;        ///< the vertices do not all lie on one height
    bool has_flat_bottom;   ///< the lower edge is horizontal, and the triangle has height
    bool has_area;          ///< the middle vertex does not lie on the long edge
    bool long_edge_is_left; ///< it passes the middle vertex on the left, or touches it
};

/// A triangle without height is its row from the leftmost to the rightmost vertex: its lower edge
/// starts at the rightmost one.
template <typename Scalar>
JoinedEdges<Scalar> joined_edges(const Triangle<Scalar>& triangle, int down) {
    const auto [top, middle, bottom] = sorted_from_top(triangle, down);
    const bool has_height = top.position.y != bottom.position.y;
    const Edge<Scalar> long_edge = edge_between(top, bottom);
    const Scalar x_opposite_middle = long_edge.x_at(middle.position.y);
    return {.top = top,
            .middle = middle,
            .bottom = bottom,
            .long_edge = long_edge,
            .upper = edge_between(top, middle),
            .lower = has_height ? edge_between(middle, bottom) : edge_between(bottom, middle),
            .has_height = has_height,
            .has_flat_bottom = has_height && middle.position.y == bottom.position.y,
            .has_area = has_height && middle.position.x != x_opposite_middle,
            .long_edge_is_left = !(middle.position.x < x_opposite_middle)};
}

/// Walks along an edge from row to row of the picture and returns x on each.
template <typename Scalar> class EdgeWalk {
public:
    /// `y_step` is the step in y from one row to the next, +1 or -1.
    EdgeWalk(const Edge<Scalar>& edge, LerpForm form, int y_step)
        : edge_(edge), form_(form), y_step_(y_step) {}

    EdgeName name() const { return edge_.name; }
    const Edge<Scalar>& edge() const { return edge_; }

    /// x at the samples of row `y`. After the first call, every call must ask for the next row.
    [[gnu::always_inline]] Scalar x_on_row(int y, const SampleOffset<Scalar>& offset) {
        return x_at([&] { return offset.y_of(y); });
    }

    /// The same where samples lie at integer points.
    [[gnu::always_inline]] Scalar x_on_row(int y) {
        return x_at([y] { return scalar_from<Scalar>(y); });
    }

private:
    template <typename Height> [[gnu::always_inline]] Scalar x_at(Height&& height) {
        if (form_ == LerpForm::direct)
            return edge_.x_at(height());
        if (has_begun_)
            x_ += step_;
        else
            begin_at(height());
        return x_;
    }

    void begin_at(const Scalar& height) {
        x_ = edge_.x_at(height);
        step_ = y_step_ > 0 ? edge_.dx_dy : Scalar(-edge_.dx_dy);
        write_over_denominator_of(x_, step_);
        has_begun_ = true;
    }

    Edge<Scalar> edge_;
    LerpForm form_;
    int y_step_;
    bool has_begun_ = false;
    Scalar x_{};    ///< incremental: the value on the row before
    Scalar step_{}; ///< incremental: from one row to the next
};

} // namespace rastertrace
