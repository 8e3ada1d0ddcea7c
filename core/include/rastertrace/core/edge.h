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

#include <optional>

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
    std::optional<Scalar> dx_dy; ///< nothing for a horizontal edge, whose only value is start.x

    /// x at height y. A horizontal edge has only its first value: dividing by its height of 0 is
    /// the mistake that stops the textbook's own example.
    Scalar x_at(const Scalar& y) const {
        return dx_dy ? Scalar(start.x + *dx_dy * (y - start.y)) : start.x;
    }
};

template <typename Scalar>
Edge<Scalar> edge_between(const Vertex<Scalar>& from, const Vertex<Scalar>& to) {
    const Scalar dx = to.position.x - from.position.x;
    const Scalar dy = to.position.y - from.position.y;
    Edge<Scalar> edge{{from.place, to.place}, from.position, std::nullopt};
    if (dy != scalar_from<Scalar>(0))
        edge.dx_dy = dx / dy;
    return edge;
}

/// Walks along an edge from row to row of the picture and gives x on each.
template <typename Scalar> class EdgeWalk {
public:
    /// `down` is the step in y from one row to the next, +1 or -1.
    EdgeWalk(const Edge<Scalar>& edge, LerpForm form, int down)
        : edge_(edge), down_(down), incremental_(form == LerpForm::incremental) {}

    EdgeName name() const { return edge_.name; }

    /// x on row `y`. After the first call, every call must ask for the next row down.
    Scalar x_on_row(int y) {
        if (!incremental_ || !x_) {
            const Scalar x = edge_.x_at(scalar_from<Scalar>(y));
            if (incremental_)
                start_adding(x);
            return x;
        }
        *x_ += step_;
        return *x_;
    }

private:
    void start_adding(const Scalar& x) {
        const Scalar zero = scalar_from<Scalar>(0);
        const Scalar dx_dy = edge_.dx_dy.value_or(zero);
        step_ = down_ > 0 ? dx_dy : Scalar(-dx_dy);
        x_ = x;
        share_denominator(*x_, step_);
    }

    Edge<Scalar> edge_;
    int down_;
    bool incremental_;
    std::optional<Scalar> x_; ///< the value on the row before; nothing before the first
    Scalar step_{};           ///< from one row to the next
};

} // namespace rastertrace
