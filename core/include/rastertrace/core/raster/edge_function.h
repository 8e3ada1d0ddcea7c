// SPDX-License-Identifier: MIT
#pragma once

// The edge of a triangle as graphics hardware sees it: a function that is 0 on the edge, positive
// on the triangle's side of it and negative on the other.
//
//     E(x, y) = a (x - x1) + b (y - y1),   a = y1 - y2,  b = x2 - x1,  both turned if need be
//
// (x1, y1) is the upper end of the edge, as seen in the picture, and (x2, y2) the lower one. So the
// two triangles that share an edge evaluate one expression, with its sign turned: what is rounded
// is rounded alike, and a sample belongs to one of them.
//
// Source: Pineda 1988, E(x, y) = (x - X) dY - (y - Y) dX, here with its sign turned; Direct3D 11
// specification, section 3.4.2.1 (the top-left rule).

#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/steps.h>

#include <array>

namespace rastertrace {

/// An edge of a triangle as a function, in square pixels.
template <typename Scalar> struct EdgeFunction {
    EdgeName name;        ///< from its upper vertex to its lower one
    Vec<Scalar, 2> start; ///< the upper end
    Scalar a;
    Scalar b;
    bool is_top_left; ///< a sample on the edge belongs to the triangle

    Scalar at(const Vec<Scalar, 2>& p) const { return a * (p.x - start.x) + b * (p.y - start.y); }

    /// The tie rule: true if a sample with this value of the function may belong to the triangle.
    bool admits_value(const Scalar& value) const {
        const Scalar zero = scalar_from<Scalar>(0);
        return is_top_left ? !(value < zero) : zero < value;
    }
    bool admits(const Vec<Scalar, 2>& sample) const { return admits_value(at(sample)); }

    /// The function for the triangle on the other side; the tie rule is not changed.
    EdgeFunction negated() const { return {name, start, Scalar(-a), Scalar(-b), is_top_left}; }
};

/// The function of an edge from its upper vertex to its lower one. It is positive where (x, y) lies
/// counter-clockwise of the edge with y up: to the right in the picture, or with y down to the
/// left.
template <typename Scalar>
EdgeFunction<Scalar> edge_function(const Vertex<Scalar>& upper, const Vertex<Scalar>& lower,
                                   bool is_top_left = false) {
    const auto& p = upper.position;
    const auto& q = lower.position;
    return {{upper.index, lower.index}, p, Scalar(p.y - q.y), Scalar(q.x - p.x), is_top_left};
}

/// The function of an edge that is not horizontal, for the triangle on its right in the picture.
/// Samples on the edge belong to that triangle.
template <typename Scalar>
EdgeFunction<Scalar> function_of_left_edge(const Vertex<Scalar>& upper, const Vertex<Scalar>& lower,
                                           int down) {
    const auto function = edge_function(upper, lower, true);
    return down > 0 ? function.negated() : function;
}

/// Where the vertex between `top` and `bottom` lies: -1 left of the edge from one to the other, as
/// seen in the picture, +1 right of it, 0 on it.
template <typename Scalar>
int side_of_edge(const Vertex<Scalar>& top, const Vertex<Scalar>& bottom,
                 const Vertex<Scalar>& middle, int down) {
    const Scalar value = edge_function(top, bottom).at(middle.position);
    const Scalar zero = scalar_from<Scalar>(0);
    const int turn = value < zero ? -1 : zero < value ? 1 : 0;
    return -down * turn;
}

/// The three edges of a triangle whose vertices are sorted from the top of the picture: from top to
/// middle, from middle to bottom, from top to bottom. Each is positive inside. A horizontal upper
/// edge is a top edge, a horizontal lower one a bottom edge.
template <typename Scalar>
std::array<EdgeFunction<Scalar>, 3> edge_functions(const std::array<Vertex<Scalar>, 3>& sorted,
                                                   bool long_edge_is_left, int down) {
    const auto& [top, middle, bottom] = sorted;
    const bool is_left = long_edge_is_left;
    const bool has_top_edge = top.position.y == middle.position.y;
    const bool has_bottom_edge = middle.position.y == bottom.position.y;
    const auto upper = edge_function(top, middle, has_top_edge || !is_left);
    const auto lower = edge_function(middle, bottom, !has_bottom_edge && !is_left);
    const auto long_edge = edge_function(top, bottom, is_left);

    // The short edges have the triangle on one side, the long edge on the other.
    if (is_left == (down > 0))
        return {upper, lower, long_edge.negated()};
    return {upper.negated(), lower.negated(), long_edge};
}

} // namespace rastertrace
