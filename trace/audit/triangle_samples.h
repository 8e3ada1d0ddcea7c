// SPDX-License-Identifier: MIT
#pragma once

// Which samples of a canvas lie in a triangle, row by row: exactly, and as far as rounding may have moved its edges.
//
//     const TriangleSamples samples(at, grid, 0x1p-53);
//     samples.row(3).closed;  // the pixels from first to last
//
// Doubles decide where their error leaves no doubt (Shewchuk 1997, "Adaptive precision floating-point arithmetic and
// fast robust geometric predicates"); where it does, whole numbers of any size do.

#include "screen_point.h"

#include <rastertrace/core/raster/canvas.h>

#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/core/raster/sample_offset.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace rastertrace {

/// Where sample points are.
struct CanvasSamples {
    Canvas canvas;
    SampleOffset<mpq_class> offset;
    double x = offset.x().get_d(); ///< the nearest doubles
    double y = offset.y().get_d();

    double error = x == offset.x() && y == offset.y() ? 0 : 0x1p-53; ///< how far these may be off

    /// Added to a pixel of a canvas, they are exact.
    bool are_short =
        error == 0 && std::fmod(x, 0x1p-30) == 0 && std::fmod(y, 0x1p-30) == 0; // 16 bits before

    /// The sample of a pixel.
    Coordinate x_of(Index pixel) const {
        return are_short ? Coordinate(static_cast<double>(pixel) + x)
                         : Coordinate(offset.x_of(pixel));
    }
    Coordinate y_of(Index pixel) const {
        return are_short ? Coordinate(static_cast<double>(pixel) + y)
                         : Coordinate(offset.y_of(pixel));
    }
};

/// The pixels of one row from x = first to x = last, or the rows from first to last; none if last
/// lies before first.
struct Span {
    Index first = 0;
    Index last = -1;

    bool is_empty() const { return last < first; }
    bool has(Index x) const { return first <= x && x <= last; }
};

/// The pixels (x, y) with a x + b y + c >= 0.
struct HalfPlane {
    mpz_class a;
    mpz_class b;
    mpz_class c;
};

/// The pixels that lie in every one of some half planes.
using ConvexRegion = std::vector<HalfPlane>;

/// Left of the line from one point to another, where y points up: the edge function, twice the
/// signed area that a sample point makes with the edge, is at least -`widening`. Pineda 1988.
HalfPlane left_of(const ScreenPoint& from, const ScreenPoint& to, const CanvasSamples& grid,
                  const mpq_class& widening = 0);

/// The other side of the line.
HalfPlane opposite(const HalfPlane& plane);

/// The pixels with a x + b y + c >= -by.
HalfPlane widened(const HalfPlane& plane, const mpz_class& by);

/// The region without its boundary: of whole numbers, those above 0 are the ones from 1.
ConvexRegion interior_of(ConvexRegion region);

/// What lies between the ends of an edge: x or y, whichever it runs along more, is from that of
/// one end to that of the other.
ConvexRegion between_ends(const ScreenPoint& from, const ScreenPoint& to,
                          const CanvasSamples& grid);

/// The pixels of `within`, a part of row `y`, that lie in a region. Where there are none, the
/// result begins one behind the end of `within`.
Span span_on_row(const ConvexRegion& region, int y, const Span& within);

/// The rows of the canvas, counted from its top, whose sample points have a y from `low` to `high`.
Span rows_between(const Coordinate& low, const Coordinate& high, const CanvasSamples& grid);

/// All pixels of a row.
Span whole_row(const Canvas& canvas);

/// The sign of a triangle's area: 1 if its corners turn left, where y points up; 0 if it has none.
int orientation(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c);

/// The samples of a triangle with area.
class TriangleSamples {
public:
    /// `one_rounding` is what one rounding of the numbers of the trace may put a number off, relative to it: 2^-53 of
    /// doubles, 0 of exact ones. The corners and
    /// the grid have to outlive this.
    TriangleSamples(const std::array<ScreenPoint, 3>& at, const CanvasSamples& grid,
                    double one_rounding);

    struct Row {
        Span closed;       ///< in the triangle, or on its boundary
        Span inside;       ///< so far inside that no rounding matters
        Span within_error; ///< as far as rounding may put the edges
    };
    Row row(int y) const;

    /// True if rounding matters for no sample at all: in every row, all three are the same.
    bool is_clear() const;

    /// The half planes of the edges from the first, second and third corner, whichever way they turn.
    struct Regions {
        ConvexRegion closed;
        ConvexRegion interior;
        ConvexRegion within_error;
    };
    const Regions& regions() const;

private:
    /// An edge function in doubles: positive on the triangle's side.
    struct NearEdge {
        double x, y; ///< of a point on it
        double a, b; ///< a (x' - x) + b (y' - y)
    };
    int side_of(const NearEdge& edge, double x, double y) const;
    std::optional<Span> clear_span(int y) const;

    const std::array<ScreenPoint, 3>* at_;
    const CanvasSamples* grid_;
    double one_rounding_;
    int orientation_;
    double error_; ///< at least what rounding may put an edge function off
    double
        spread_; ///< of corners that are no doubles: what that may put a difference of coordinates off
    double extent_; ///< how far rounding may move the boundary up or down, at most
    std::array<NearEdge, 3> edges_;
    mutable std::shared_ptr<const Regions> regions_; ///< once someone has asked
};

} // namespace rastertrace
