// SPDX-License-Identifier: MIT
#pragma once

// The edge of a triangle in filtered doubles, the formula of edge.h with one bound for all
// rows; and where the samples lie. Who fills with Adaptive includes it.
//
//     edge_between(upper, lower).x_at(3.0);

#include <rastertrace/core/draw/paint/sample_walk.h>
#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/triangle.h>

#include <cmath>
#include <cstddef>
#include <optional>

namespace rastertrace {

/// A line from one vertex to another: x as a function of y.
template <> struct Edge<Adaptive> {
    EdgeName name;
    Vec<Adaptive, 2> start;
    bool is_horizontal = false;
    Adaptive dx_dy{};
    double bound = 0; ///< x, calculated anywhere between the vertices, is off by no more

    /// x at height y, which must lie between those of the vertices.
    Adaptive x_at(const Adaptive& y) const {
        const double x = start.x.value() + dx_dy.value() * (y.value() - start.y.value());
        if (y.error() == 0)
            return Adaptive(x, bound);
        const double steepest = std::abs(dx_dy.value()) + dx_dy.error();
        return Adaptive(x, (bound + steepest * y.error()) * Adaptive::widening);
    }
};

/// How far x = x1 + a (y - y1) may be off: what x1, a and y1 are off by, and half a unit in the last place of
/// each of the three results, at the other end, where they are largest.
inline double bound_of_x(const Vec<Adaptive, 2>& start, Adaptive dx_dy, Adaptive dy) {
    constexpr double half_ulp = Adaptive::half_ulp;
    const double steepest = std::abs(dx_dy.value()) + dx_dy.error();
    const double height = std::abs(dy.value()) + dy.error();
    const double rise = steepest * height;
    const double error = start.x.error() + dx_dy.error() * height +
                         steepest * (start.y.error() + height * half_ulp) +
                         (std::abs(start.x.value()) + 2 * rise) * half_ulp +
                         Adaptive::smallest_error;
    return error * Adaptive::widening;
}

/// The edge between two vertices, with its bound.
template <>
inline Edge<Adaptive> edge_between(const Vertex<Adaptive>& from, const Vertex<Adaptive>& to) {
    const Adaptive dx = to.position.x - from.position.x;
    const Adaptive dy = to.position.y - from.position.y;
    const bool is_horizontal = dy == Adaptive(0);
    const Adaptive dx_dy = is_horizontal ? Adaptive(0) : dx / dy;
    return {.name = {from.index, to.index},
            .start = from.position,
            .is_horizontal = is_horizontal,
            .dx_dy = dx_dy,
            .bound = bound_of_x(from.position, dx_dy, dy)};
}

/// The double nearest to dx/dy of an edge, if its vertices are doubles and one more step tells it: what is left
/// of the division, dx - q dy, has no error but that of the last digits of dx and dy.
inline std::optional<double> nearest_slope(const Vec<Adaptive, 2>& from,
                                           const Vec<Adaptive, 2>& to) {
    if (from.x.error() + from.y.error() + to.x.error() + to.y.error() != 0)
        return std::nullopt;
    const Adaptive dx = to.x - from.x;
    const Adaptive dy = to.y - from.y;
    const double quotient = dx.value() / dy.value();
    const double magnitude = std::abs(quotient);
    // Far from where digits are lost at either end of the range.
    if (!(magnitude > 0x1p-400 && magnitude < 0x1p400 && std::abs(dy.value()) > 0x1p-100))
        return std::nullopt;
    const double rest = std::fma(-quotient, dy.value(), dx.value());
    const double off = (std::abs(rest) + dx.error() + magnitude * dy.error()) * Adaptive::widening;
    const double to_next = magnitude - std::nextafter(magnitude, 0.0);
    const double smallest_dy = (std::abs(dy.value()) - dy.error()) / Adaptive::widening;
    return off < to_next / 2 * smallest_dy ? std::optional(quotient) : std::nullopt;
}

/// Filtered doubles may be moved by the offset: then samples have whole coordinates, as
/// the pixels have.
template <> class SampleGrid<Adaptive> {
public:
    using Length = Adaptive;

    SampleGrid(Adaptive sample_offset, const Canvas& canvas)
        : canvas_(canvas), offset_(sample_offset) {}

    Adaptive sample_offset() const { return offset_; }

    Triangle<Length> in_lengths(const Triangle<Adaptive>& triangle) const {
        Triangle<Length> result;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& [x, y] = triangle.vertices[i];
            result.vertices[i] = {x - offset_, y - offset_};
        }
        return result;
    }

    int down() const { return canvas_.down(); }

    Index first_row_from(Length y) const {
        return canvas_.row_of(down() > 0 ? ceil_index(y) : floor_index(y));
    }

    bool reaches(Index x, Length length) const { return length <= scalar_from<Length>(x); }

    /// Where an edge crosses a row of samples, in columns.
    Length crossing(const Edge<Length>& edge, int row) const {
        return edge.x_at(scalar_from<Length>(canvas_.y_of(row)));
    }

private:
    Canvas canvas_;
    Adaptive offset_;
};

} // namespace rastertrace
