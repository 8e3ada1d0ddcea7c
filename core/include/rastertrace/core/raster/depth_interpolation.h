// SPDX-License-Identifier: MIT
#pragma once

// The depths of a triangle's pixels, from those of its vertices. 1/z and z after the division by w
// are linear on the screen, z itself is not.
//
//     along the edges, then across the row:   d = d1 + (d2 - d1) (y - y1)/(y2 - y1), then in x
//     as a plane:                             d = d1 + s_x (x - x1) + s_y (y - y1)
//     by weights:                             d = d1 + w2 (d2 - d1) + w3 (d3 - d1)
//
// All three are equal in exact arithmetic. Depths are turned (depth_buffer.h).
//
// Source: T0, "Pintando faces", after Gambetta.
//
//     TriangleDepth<double> depth(triangle.vertices, {1, 2, 3}, false);
//     depth.plane({0.5, 0.5}).on_row(4).at(2);

#include <rastertrace/core/numbers/fraction.h>
#include <rastertrace/core/numbers/scalar.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/sample_offset.h>
#include <rastertrace/core/raster/steps.h>
#include <rastertrace/core/raster/triangle.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>

namespace rastertrace {

/// A depth with the sign that makes the nearer one smaller.
template <typename Depth> Depth turned(const Depth& depth, bool larger_passes) {
    return larger_passes ? Depth(-depth) : depth;
}

/// The turned depths of a row of a triangle: linear in x.
template <typename Scalar> struct DepthRow {
    Scalar x;                       ///< the depth is known here
    Scalar depth;                   ///< at x
    Scalar slope;                   ///< the change in depth from a pixel to the next
    std::optional<Scalar> end = {}; ///< pixels outside of [x, end] have the depth of the nearer end

    [[gnu::always_inline]] Scalar at(int column) const {
        const Scalar here = scalar_from<Scalar>(column);
        return depth + slope * ((end ? held_between(here, x, *end) : here) - x);
    }
};

/// 0 for a slope that overflows: its row or triangle is too thin to have more than one depth.
template <typename Scalar> Scalar finite_or_zero(const Scalar& slope) {
    require_finite(slope);
    if constexpr (std::floating_point<Scalar>)
        return std::isfinite(slope) ? slope : Scalar(0);
    else
        return slope;
}

/// The depths of an edge between its vertices: linear in y. A horizontal edge has that of its first
/// vertex.
template <typename Scalar> class DepthEdge {
public:
    DepthEdge(const Scalar& y, const Scalar& depth, const Scalar& other_y,
              const Scalar& other_depth)
        : y_(y), depth_(depth), height_(other_y - y), rise_(other_depth - depth),
          is_horizontal_(height_ == scalar_from<Scalar>(0)) {}

    Scalar at(const Scalar& y) const {
        return is_horizontal_ ? depth_ : Scalar(depth_ + rise_ * (y - y_) / height_);
    }

    /// The same; beyond an end, the depth of that end.
    Scalar held_at(const Scalar& y) const {
        if (is_horizontal_)
            return depth_;
        const Scalar part = (y - y_) / height_;
        return depth_ + rise_ * held_between(part, scalar_from<Scalar>(0), scalar_from<Scalar>(1));
    }

private:
    Scalar y_;
    Scalar depth_;
    Scalar height_;
    Scalar rise_;
    bool is_horizontal_;
};

/// The depths between the two ends of a row.
template <typename Scalar>
DepthRow<Scalar> row_between(const Scalar& left, const Scalar& left_depth, const Scalar& right,
                             const Scalar& right_depth) {
    const Scalar zero = scalar_from<Scalar>(0);
    const Scalar width = right - left;
    const Scalar slope =
        zero < width ? finite_or_zero(Scalar((right_depth - left_depth) / width)) : zero;
    return {left, left_depth, slope, zero < width ? right : left};
}

/// The depths of a triangle as a plane: linear in x and y.
template <typename Scalar> class DepthPlane {
public:
    DepthPlane(const std::array<Vec<Scalar, 2>, 3>& positions, const std::array<Scalar, 3>& depths,
               const SampleOffset<Scalar>& offset) {
        const auto& [a, b, c] = positions;
        const Scalar abx = b.x - a.x;
        const Scalar aby = b.y - a.y;
        const Scalar acx = c.x - a.x;
        const Scalar acy = c.y - a.y;
        const Scalar area2 = abx * acy - acx * aby;
        const Scalar ab = depths[1] - depths[0];
        const Scalar ac = depths[2] - depths[0];
        origin_ = {Scalar(a.x - offset.x()), Scalar(a.y - offset.y())};
        depth_ = depths[0];
        if (area2 == scalar_from<Scalar>(0))
            return;
        slope_x_ = finite_or_zero(Scalar((ab * acy - ac * aby) / area2));
        slope_y_ = finite_or_zero(Scalar((ac * abx - ab * acx) / area2));
    }

    DepthRow<Scalar> on_row(int y) const {
        return {origin_.x, linear(depth_, slope_y_, scalar_from<Scalar>(y), origin_.y), slope_x_,
                std::nullopt};
    }

private:
    Vec<Scalar, 2> origin_{}; ///< the first vertex, as samples are counted
    Scalar depth_{};          ///< there
    Scalar slope_x_{};
    Scalar slope_y_{};
};

/// The vertices in the numbers that depths are worked out in.
template <typename Scalar>
std::array<Vec<Scalar, 2>, 3> depth_positions(const Triangle<Scalar>& triangle) {
    return triangle.vertices;
}

/// Fractions over one denominator are divided by it once.
template <typename Integer>
std::array<Vec<double, 2>, 3> depth_positions(const Triangle<Fraction<Integer>>& triangle) {
    const double unit = 1 / static_cast<double>(triangle.vertices[0].x.denominator);
    std::array<Vec<double, 2>, 3> result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = {static_cast<double>(triangle.vertices[i].x.numerator) * unit,
                     static_cast<double>(triangle.vertices[i].y.numerator) * unit};
    return result;
}

/// The turned depths of a triangle: those of its vertices, and linear between them. All forms are
/// equal in exact arithmetic, and each keeps equal depths equal.
template <typename Scalar> class TriangleDepth {
public:
    /// Of the vertices; `larger_passes` as in DepthRule.
    TriangleDepth(const std::array<Vec<Scalar, 2>, 3>& positions,
                  const std::array<Scalar, 3>& depths, bool larger_passes)
        : positions_(positions), depths_{turned(depths[0], larger_passes),
                                         turned(depths[1], larger_passes),
                                         turned(depths[2], larger_passes)} {}

    /// The depth where an edge is at height y.
    [[gnu::always_inline]] Scalar on_edge(const EdgeName& edge, const Scalar& y) {
        auto& depths = edges_[edge.from + edge.to - 1U];
        if (!depths)
            depths.emplace(positions_[edge.from].y, depths_[edge.from], positions_[edge.to].y,
                           depths_[edge.to]);
        return depths->at(y);
    }

    /// By weights: d = d1 + w2 (d2 - d1) + w3 (d3 - d1).
    Scalar by_weights(const std::array<Scalar, 3>& weights) const {
        return depths_[0] + weights[1] * (depths_[1] - depths_[0]) +
               weights[2] * (depths_[2] - depths_[0]);
    }

    /// The same for whole rows: the weights are linear in x and y, and so is the depth.
    DepthPlane<Scalar> plane(const SampleOffset<Scalar>& offset) const {
        return {positions_, depths_, offset};
    }

private:
    std::array<Vec<Scalar, 2>, 3> positions_;
    std::array<Scalar, 3> depths_;
    std::array<std::optional<DepthEdge<Scalar>>, 3>
        edges_; ///< those between 0 and 1, 0 and 2, 1 and 2
};

} // namespace rastertrace
