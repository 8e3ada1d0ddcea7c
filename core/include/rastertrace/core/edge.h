// SPDX-License-Identifier: MIT
#pragma once

// The edge of a triangle as the scanline algorithm sees it: x as a function of y.
//
//     x = x1 + a (y - y1),   a = (x2 - x1) / (y2 - y1)
//
// The textbook calls this a linear interpolation, LERP, of x along y.

#include <rastertrace/core/scalar.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/vec.h>

#include <cstdint>

namespace rastertrace {

/// How the values of a linear interpolation are found, row after row.
enum class LerpForm {
    direct,      ///< d = d1 + a (i - i1) on every row
    incremental, ///< d = d1 + a (i - i1) on the first row that is drawn, then d += a
};

/// A vertex of a triangle, with its place in the order in which the scene names the vertices.
template <typename Scalar> struct Vertex {
    Vec<Scalar, 2> position;
    std::uint8_t place = 0;
};

/// A line from one vertex to another: x as a function of y.
template <typename Scalar> struct Edge {
    EdgeName name;
    Vec<Scalar, 2> start;
    bool is_horizontal = false; ///< then its only value is start.x, and dx_dy is 0
    Scalar dx_dy{};             ///< (x2 - x1)/(y2 - y1)

    /// x at height y.
    Scalar x_at(const Scalar& y) const { return start.x + dx_dy * (y - start.y); }
};

/// The edge between two vertices. A horizontal one is not divided by its height of 0: that is the
/// mistake that stops the textbook's own example.
template <typename Scalar>
Edge<Scalar> edge_between(const Vertex<Scalar>& from, const Vertex<Scalar>& to) {
    const Scalar dx = to.position.x - from.position.x;
    const Scalar dy = to.position.y - from.position.y;
    const Scalar zero = scalar_from<Scalar>(0);
    const bool is_horizontal = dy == zero;
    return {.name = {from.place, to.place},
            .start = from.position,
            .is_horizontal = is_horizontal,
            .dx_dy = is_horizontal ? zero : Scalar(dx / dy)};
}

/// Walks along an edge from row to row of the picture and gives x on each.
template <typename Scalar> class EdgeWalk {
public:
    /// `down` is the step in y from one row to the next, +1 or -1.
    EdgeWalk(const Edge<Scalar>& edge, LerpForm form, int down)
        : edge_(edge), form_(form), down_(down) {}

    EdgeName name() const { return edge_.name; }

    /// x on row `y`. After the first call, every call must ask for the next row down.
    Scalar x_on_row(int y) {
        if (form_ == LerpForm::direct)
            return edge_.x_at(scalar_from<Scalar>(y));
        if (has_begun_)
            x_ += step_;
        else
            begin_on_row(y);
        return x_;
    }

private:
    void begin_on_row(int y) {
        x_ = edge_.x_at(scalar_from<Scalar>(y));
        step_ = down_ > 0 ? edge_.dx_dy : Scalar(-edge_.dx_dy);
        write_over_denominator_of(x_, step_);
        has_begun_ = true;
    }

    Edge<Scalar> edge_;
    LerpForm form_;
    int down_;
    bool has_begun_ = false;
    Scalar x_{};    ///< incremental: the value on the row before
    Scalar step_{}; ///< incremental: from one row to the next
};

} // namespace rastertrace
