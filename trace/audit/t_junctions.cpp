// SPDX-License-Identifier: MIT
#include "t_junctions.h"

#include "triangle_samples.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace rastertrace {

namespace {

/// False, slope and height at x = 0; of an upright line true, 0 and its x.
using Line = std::tuple<bool, mpq_class, mpq_class>;

Line line_through(const ScreenPoint& a, const ScreenPoint& b) {
    const mpq_class x = a.x.exact();
    const mpq_class y = a.y.exact();
    if (a.x == b.x)
        return {true, 0, x};
    const mpq_class slope = (b.y.exact() - y) / (b.x.exact() - x);
    return {false, slope, y - slope * x};
}

/// An edge that one triangle has, and no other.
struct OpenEdge {
    TriangleEdge edge;
    std::array<TriangleCorner, 2> ends; ///< of `edge`, in the order of the line
    bool is_left;                       ///< Its triangle lies to the left, where y points up.
};

/// The open edges of each line, in the order of the triangles.
std::map<Line, std::vector<OpenEdge>> open_edges(std::span<const ScreenTriangle> triangles) {
    constexpr std::array<std::array<std::size_t, 3>, 3> sides{{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}};
    std::unordered_map<std::uint64_t, std::size_t> uses;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (const auto& [from, to, opposite] : sides)
            ++uses[edge_key(triangles[i].corners, from, to)];

    std::map<Line, std::vector<OpenEdge>> edges;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (const auto& [from, to, opposite] : sides) {
            if (!triangles[i].is_drawn || uses[edge_key(triangles[i].corners, from, to)] > 1)
                continue;
            const TriangleEdge edge{{i, from}, {i, to}};
            const auto& at = triangles[i].at;
            const bool goes_on = at[from] < at[to];
            const auto& [low, high] =
                goes_on ? std::tie(at[from], at[to]) : std::tie(at[to], at[from]);
            edges[line_through(low, high)].push_back(
                {edge, goes_on ? std::array{edge.from, edge.to} : std::array{edge.to, edge.from},
                 orientation(low, high, at[opposite]) > 0});
        }
    return edges;
}

/// Adds the T-junctions of a line. Goes along it, and keeps the edges at hand on either side.
void add_junctions(const std::vector<OpenEdge>& edges, std::span<const ScreenTriangle> triangles,
                   std::vector<TJunction>& found) {
    const auto at = [&](const TriangleCorner& corner) -> const ScreenPoint& {
        return triangles[corner.triangle].at[corner.corner];
    };
    const auto number = [&](const TriangleCorner& corner) {
        return triangles[corner.triangle].corners[corner.corner];
    };
    // The ends of the edges; at one point, those that edges end at come first.
    std::vector<std::tuple<const ScreenPoint*, bool, std::size_t>> ends;
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (const bool begins : {false, true})
            ends.emplace_back(&at(edges[i].ends[begins ? 0 : 1]), begins, i);
    std::sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) {
        const auto& [a_at, a_begins, a_edge] = a;
        const auto& [b_at, b_begins, b_edge] = b;
        return std::tie(*a_at, a_begins, a_edge) < std::tie(*b_at, b_begins, b_edge);
    });

    std::map<std::size_t, TJunction> junctions;   // by edge
    std::array<std::set<std::size_t>, 2> at_hand; // to the right and to the left of the line
    for (const auto& [place, begins, i] : ends) {
        const auto& [edge, corners, is_left] = edges[i];
        const auto& [low, high] = corners;
        std::size_t compared = 0;
        for (const std::size_t other : at_hand[!is_left]) {
            if (++compared > most_edges_at_vertex)
                break;
            const auto& [other_low, other_high] = edges[other].ends;
            if (!(at(other_low) < *place) || !(*place < at(other_high)))
                continue;
            auto& [of, vertices, beside] =
                junctions.try_emplace(other, TJunction{edges[other].edge, {}, {}}).first->second;
            const TriangleCorner& vertex = begins ? low : high;
            if (vertices.empty() || number(vertices.back()) != number(vertex))
                vertices.push_back(vertex);
            // An edge with both ends on the other one is added at the first of them.
            if (begins || !(at(other_low) < at(low)))
                beside.push_back(edge);
        }
        if (begins)
            at_hand[is_left].insert(i);
        else
            at_hand[is_left].erase(i);
    }
    for (auto& [i, junction] : junctions) {
        if (edges[i].ends[0].corner != junction.edge.from.corner) {
            std::reverse(junction.vertices.begin(), junction.vertices.end());
            std::reverse(junction.beside.begin(), junction.beside.end());
        }
        found.push_back(std::move(junction));
    }
}

} // namespace

std::vector<TJunction> t_junctions_of(std::span<const ScreenTriangle> triangles) {
    std::vector<TJunction> found;
    for (const auto& [line, edges] : open_edges(triangles))
        add_junctions(edges, triangles, found);
    std::sort(found.begin(), found.end(), [](const TJunction& a, const TJunction& b) {
        return std::tie(a.edge.from.triangle, a.edge.from.corner) <
               std::tie(b.edge.from.triangle, b.edge.from.corner);
    });
    return found;
}

} // namespace rastertrace
