// SPDX-License-Identifier: MIT
#pragma once

// T-junctions: places where vertices of some triangles lie on an edge of another triangle, or next
// to it, and that one has no vertex there. No rule for shared edges holds where no edge is shared:
// where such a vertex is rounded to one side, samples are in no triangle, or in two.
//
//     for (const TJunction& junction : t_junctions_of(triangles))
//         pixels_at(junction, triangles, drawn_by, canvas, sample_offset).never;
//
// An edge is open if no other triangle has it, that is, the same two ends. A T-junction is an open
// edge with vertices strictly between its ends, of triangles that lie on its other side and have
// open edges along it. Distances from an edge are taken up or down where it is flatter than 45
// degrees (or just that), to the left or right where it is steeper. A vertex belongs to it if it is
//
//   on the edge    at most `on_edge_reach` from it, and so is its triangle's edge, as far as the two
//                  edges run beside each other; or
//   near the edge  at most `near_edge_reach` from it, where two rows of open edges part at one vertex
//                  and meet at another, and each vertex between lies near the other row: PQ in the
//                  one and PM, MQ in the other, or more of them in both.
//
// Never is it off by more than 1/8 of the edge's length: that would be a corner, a notch or a hole
// of the mesh. Nor does it lie within `on_edge_reach` of an end, along the edge: those would be two
// vertices that were meant to be one.

#include <rastertrace/core/raster/canvas.h>

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace rastertrace {

/// In pixels. As far from an edge as a vertex on it can come when the vertex and both ends are
/// snapped to the grid of `fixed`, 1/256: each moves by up to 1/512 in x and in y.
inline constexpr double on_edge_reach = 1.0 / 128;

/// In pixels. As far from an edge as the nearest whole pixel can be: a vertex that was rounded to a
/// pixel is near.
inline constexpr double near_edge_reach = 0.5;

/// An exact point of the screen, in the scene's coordinates.
struct ScreenPoint {
    mpq_class x;
    mpq_class y;
};

/// A triangle of a mesh, on the screen.
struct ScreenTriangle {
    std::span<const ScreenPoint, 3> at;
    std::array<std::uint32_t, 3> corners; ///< numbers of the positions, from 0; equal ones the same

    /// False if it has no area or is culled. An edge that it shares is not open; it has no open
    /// edges itself.
    bool is_drawn = true;

    /// How far rounding may put twice the area that a sample makes with an edge off.
    mpq_class error = 0;
};

/// A vertex of a triangle.
struct TriangleCorner {
    std::size_t triangle = 0; ///< its place in the list of triangles
    std::size_t corner = 0;   ///< 0 to 2
};

/// A vertex on an edge, or near it.
struct JunctionVertex {
    TriangleCorner vertex; ///< in one of the triangles that have it
    mpq_class distance;    ///< from the edge, in pixels; 0 if it lies exactly on it
};

/// An open edge that runs beside another one, on its other side.
struct EdgeBeside {
    TriangleCorner from;
    TriangleCorner to;
    mpq_class low;  ///< It does so from here, in x or y, whichever the other edge runs along more,
    mpq_class high; ///< to here.
};

/// An open edge with vertices on it or near it.
struct TJunction {
    TriangleCorner from;
    TriangleCorner to;
    std::vector<JunctionVertex> vertices; ///< in the order in which they come after `from`
    std::vector<EdgeBeside> beside;       ///< the same
    std::vector<std::size_t> around; ///< all triangles that have one of the vertices and are drawn
};

/// Where more open edges than this meet at a vertex, each is compared with so many of its neighbors;
/// a vertex that lies on more edges than this is told of at so many.
inline constexpr std::size_t most_edges_at_vertex = 8;

/// All T-junctions of a mesh, in the order of its triangles. Takes a time that grows little faster
/// than the number of triangles.
std::vector<TJunction> t_junctions_of(std::span<const ScreenTriangle> triangles);

/// Pixels at a T-junction, by Canvas::offset_of, ascending.
struct JunctionPixels {
    std::vector<std::uint32_t> twice; ///< in the edge's triangle and in one beside it

    /// At most one pixel from the edge, where other edges run beside it, and in none of the
    /// triangles that have one of these edges or vertices. The sample point lies strictly inside
    /// the edge's triangle or the one beside it there, farther from its other edges than rounding
    /// reaches, or between the edges, or on them.
    std::vector<std::uint32_t> never;
};

/// The pixels that a triangle covers, by Canvas::offset_of, ascending and each once.
using CoveredBy = std::function<std::span<const std::uint32_t>(std::size_t triangle)>;

/// What came of a T-junction. Sample points are `sample_offset` from integer points, in x and in y.
JunctionPixels pixels_at(const TJunction& junction, std::span<const ScreenTriangle> triangles,
                         const CoveredBy& covered_by, const Canvas& canvas,
                         const mpq_class& sample_offset);

} // namespace rastertrace
