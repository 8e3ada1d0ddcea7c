// SPDX-License-Identifier: MIT
#pragma once

// Which samples of a canvas lie in a triangle, row by row, by its edge functions (edge_function.h): exactly, and as far as
// rounding may have moved its edges.
//
//     const TriangleSamples samples(at, grid);
//     samples.row(3).inside;  // the pixels from first to last
//
// Doubles decide where their error leaves no doubt, else fractions do.

#include "screen_point.h"

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/edge_function.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace rastertrace {

/// The pixels of one row from x = first to x = last, or the rows from first to last; none if last
/// lies before first.
struct Span {
    Index first = 0;
    Index last = -1;

    bool is_empty() const { return last < first; }
    Index size() const { return is_empty() ? 0 : last - first + 1; }
    bool has(Index x) const { return first <= x && x <= last; }
};

/// The samples of a canvas, and how exact the numbers of a trace are.
struct CanvasSamples {
    Canvas canvas;
    double offset = 0; ///< from a pixel's integer point to its sample, in x and in y: 0 or 1/2
    double one_rounding =
        0; ///< what one rounding may put a number off, relative to it: 2^-53 of doubles

    ScreenPoint sample_of(Index x, Index y) const {
        return {Coordinate(static_cast<double>(x) + offset),
                Coordinate(static_cast<double>(y) + offset)};
    }

    /// The pixels of a row.
    Span all_columns() const;

    /// The rows of the canvas, counted from its top, with samples between two heights, and a few around them.
    Span rows_about(const Coordinate& low, const Coordinate& high) const;
};

inline Span common_part(const Span& a, const Span& b) {
    return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

/// The edge function of two points, which have to outlive it. It is positive to the left of the way from one to the
/// other, where y points up.
class ExactEdge {
public:
    ExactEdge(const ScreenPoint& from, const ScreenPoint& to);

    const ScreenPoint& from() const { return *from_; }
    const ScreenPoint& to() const { return *to_; }

    /// The sign of the function at a point, after `margin` has been added.
    int sign(const ScreenPoint& at, double margin = 0) const;

    /// About the x of the edge at a height; infinite or NaN of one that is level.
    double near_x_at(double y) const;

    /// Those of some pixels of a row that may lie up to a pixel beside, above or below it, and some more.
    Span columns_near(double y, const Span& columns) const;

private:
    const ScreenPoint* from_;
    const ScreenPoint* to_;
    EdgeFunction<double> near_; ///< of the nearest doubles
    double farthest_;           ///< coordinate of both points
};

/// The pixels whose sample lies at most one pixel from an edge, up or down where it is flatter than 45 degrees (or just
/// that), to the left or right where it is steeper; within the edge's length. From the top row, left to right.
std::vector<Pixel> pixels_near(const ScreenPoint& from, const ScreenPoint& to,
                               const CanvasSamples& grid);

/// The sign of a triangle's area: 1 if its corners turn left, where y points up; 0 if it has none.
int orientation(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c);

/// The samples of a triangle with area.
class TriangleSamples {
public:
    /// The corners and the grid have to outlive this.
    TriangleSamples(const std::array<ScreenPoint, 3>& at, const CanvasSamples& grid);

    /// How a sample lies to an edge.
    enum class Place {
        inside,       ///< so far on the triangle's side that no rounding matters
        within_error, ///< as far on the other side as rounding may put the edge
    };

    /// The edge from the first, second or third corner to the next one.
    bool admits(std::size_t edge, Index x, int y, Place place) const;

    struct Row {
        Span inside;
        Span within_error;
    };
    Row row(int y) const;

private:
    Span span_of_edge(std::size_t edge, int y, Place place) const;
    Span span_of(int y, Place place) const;

    const CanvasSamples* grid_;
    std::array<ExactEdge, 3> edges_; ///< positive on the triangle's side
    double error_;                   ///< at least what rounding may put an edge function off
};

} // namespace rastertrace
