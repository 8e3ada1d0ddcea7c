// SPDX-License-Identifier: MIT
#pragma once

// T-junctions: vertices of some triangles that lie exactly on an edge of another triangle, which has
// no vertex there. No rule for shared edges holds where no edge is shared: where the edges are
// rounded, samples may be in no triangle, or in two.
//
//     for (const TJunction& junction : t_junctions_of(triangles))
//         junction.vertices; // strictly between junction.from and junction.to
//
// An edge is open if no other triangle has it, that is, the same two ends. A T-junction is an open
// edge with vertices strictly between its ends, of triangles that lie on its other side and have
// open edges along it.

#include "screen_point.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rastertrace {

/// A triangle of a mesh, on the screen.
struct ScreenTriangle {
    std::span<const ScreenPoint, 3> at;
    std::array<std::uint32_t, 3> corners; ///< numbers of the positions; equal ones the same

    /// False if it has no area or is culled. An edge that it shares is not open; it has no open
    /// edges itself.
    bool is_drawn = true;
};

/// A number for the edge between two corners, the same from either end.
inline std::uint64_t edge_key(const std::array<std::uint32_t, 3>& corners, std::size_t from,
                              std::size_t to) {
    const auto [low, high] = std::minmax(corners[from], corners[to]);
    return std::uint64_t{low} << 32 | high;
}

/// A vertex of a triangle.
struct TriangleCorner {
    std::size_t triangle = 0; ///< its place in the list of triangles
    std::size_t corner = 0;   ///< 0 to 2
};

/// An edge of a triangle.
struct TriangleEdge {
    TriangleCorner from;
    TriangleCorner to;
};

/// An open edge with vertices on it.
struct TJunction {
    TriangleEdge edge;
    std::vector<TriangleCorner> vertices; ///< in the order in which they come after `edge.from`
    std::vector<TriangleEdge> beside;     ///< the edges along it that end there, the same
};

/// Where more edges than this of one line lie on one another, a vertex is compared with so many.
inline constexpr std::size_t most_edges_at_vertex = 8;

/// All T-junctions of a mesh, in the order of its triangles: n log n steps for n edges.
std::vector<TJunction> t_junctions_of(std::span<const ScreenTriangle> triangles);

} // namespace rastertrace
