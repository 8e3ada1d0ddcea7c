// SPDX-License-Identifier: MIT
#include "shared_edges.h"

#include "pixel_set.h"
#include "screen_point.h"
#include "t_junctions.h"
#include "triangle_samples.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/in_threads.h>
#include <rastertrace/trace/text/primitive_name.h>

#include <fmt/core.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

namespace rastertrace {

namespace {

// Two triangles at the edge that they share.

/// An edge of a triangle.
struct EdgeUse {
    std::uint64_t ends; ///< its edge_key
    std::uint32_t triangle;
    std::uint8_t from; ///< its vertices, 0 to 2
    std::uint8_t to;
};

/// All edges of some triangles, those with the same ends behind one another.
std::vector<EdgeUse> edges_by_ends(const std::vector<Cornered>& triangles) {
    std::vector<EdgeUse> uses;
    uses.reserve(3 * triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (const auto& [from, to] : {std::pair<std::uint8_t, std::uint8_t>{0, 1}, {0, 2}, {1, 2}})
            uses.push_back({edge_key(triangles[i].corners, from, to), i, from, to});
    std::stable_sort(uses.begin(), uses.end(),
                     [](const EdgeUse& a, const EdgeUse& b) { return a.ends < b.ends; });
    return uses;
}

/// The uses of one edge by more than one triangle, the first `most_compared` of them.
using EdgeUses = std::span<const EdgeUse>;

/// Those of edges_by_ends, in the order in which they come first among the triangles.
std::vector<EdgeUses> shared_edges(const std::vector<EdgeUse>& uses) {
    std::vector<EdgeUses> edges;
    for (auto first = uses.begin(); first != uses.end();) {
        const auto end = std::find_if(
            first, uses.end(), [first](const EdgeUse& use) { return use.ends != first->ends; });
        const auto count = static_cast<std::size_t>(end - first);
        if (count > 1)
            edges.emplace_back(first, std::min(count, most_compared));
        first = end;
    }
    std::sort(edges.begin(), edges.end(), [](const EdgeUses& a, const EdgeUses& b) {
        const auto order = [](const EdgeUse& use) {
            return std::tie(use.triangle, use.from, use.to);
        };
        return order(a.front()) < order(b.front());
    });
    return edges;
}

/// An edge's name in a trace: "AC", or "P1-P3"; its ends where the step names no vertices.
std::string edge_name(const PrimitiveStep& step, std::size_t from, std::size_t to) {
    const std::vector<std::string> names = step.vertices.texts();
    if (names.size() == 3) {
        const std::array<std::string_view, 3> all{names[0], names[1], names[2]};
        return names[from] + std::string(name_separator(all)) + names[to];
    }
    const auto at = text_rows(step.at);
    return fmt::format("({}, {})-({}, {})", at[from][0], at[from][1], at[to][0], at[to][1]);
}

/// True if two triangles lie on one side of an edge that they share.
bool lie_on_one_side(const EdgeUse& one, const EdgeUse& other,
                     const std::vector<Cornered>& triangles) {
    const auto& at = triangles[one.triangle].at();
    const auto side_of = [&](const EdgeUse& use) {
        const std::size_t opposite = 3U - use.from - use.to;
        return orientation(at[one.from], at[one.to], triangles[use.triangle].at()[opposite]);
    };
    return side_of(one) == side_of(other);
}

/// The pixels of a triangle at one of its edges: so far from the other two that no rounding matters,
/// and up to as far beyond this one as rounding may put it.
ConvexRegion region_at_edge(const Cornered& triangle, std::size_t from) {
    ConvexRegion region = triangle.samples->regions().interior;
    region[from] = triangle.samples->regions().within_error[from];
    return region;
}

/// The same of an edge that it shares. The edge of a fold is like the other two: what lies on it lies
/// between no two triangles.
ConvexRegion region_at_edge(const EdgeUse& edge, const Cornered& triangle, bool is_fold) {
    if (is_fold)
        return triangle.samples->regions().interior;
    return region_at_edge(triangle, edge.to == edge.from + 1U ? edge.from : edge.to);
}

/// The pixels near an edge, between its ends and in `within`, that lie in one of some regions and that
/// neither of two primitives drew. SharedEdge says which are near.
std::vector<std::uint32_t> never_drawn(const ScreenPoint& from, const ScreenPoint& to,
                                       ConvexRegion within, std::span<const ConvexRegion> regions,
                                       const DrawnPrimitive& one, const DrawnPrimitive& other,
                                       const CanvasSamples& grid) {
    const Canvas& canvas = grid.canvas;

    // a x + b y + c is b times the height above the edge, and a times the distance to its right.
    const HalfPlane side = left_of(from, to, grid);
    const mpz_class reach = std::max<mpz_class>(abs(side.a), abs(side.b));
    for (const HalfPlane& plane : between_ends(from, to, grid))
        within.push_back(plane);
    within.push_back(widened(side, reach));
    within.push_back(widened(opposite(side), reach));

    std::vector<std::uint32_t> never;
    const auto [low, high] = std::minmax(from.y, to.y);
    const Span rows = rows_between(Coordinate(low.exact() - 1), Coordinate(high.exact() + 1), grid);
    for (Index row = rows.first; row <= rows.last; ++row) {
        const int y = canvas.y_of(static_cast<int>(row));
        const Span close_by = span_on_row(within, y, whole_row(canvas));
        if (close_by.is_empty())
            continue;
        std::vector<Span> spans;
        for (const ConvexRegion& region : regions)
            spans.push_back(span_on_row(region, y, close_by));
        for (Index x = close_by.first; x <= close_by.last; ++x) {
            const auto offset =
                static_cast<std::uint32_t>(canvas.offset_of({static_cast<int>(x), y}));
            const bool belongs = std::any_of(spans.begin(), spans.end(),
                                             [x](const Span& span) { return span.has(x); });
            if (belongs && !one.covering().contains(offset) && !other.covering().contains(offset))
                never.push_back(offset);
        }
    }
    return never;
}

PixelList pixel_list(const std::vector<std::uint32_t>& offsets, const Canvas& canvas) {
    PixelList list;
    for (const std::uint32_t offset : offsets)
        list.add(pixel_at(offset, canvas));
    return list;
}

/// The pixels that both primitives drew.
PixelList drawn_by_both(const DrawnPrimitive& one, const DrawnPrimitive& other,
                        const Canvas& canvas) {
    PixelList both;
    auto place = other.pixels.begin();
    for (const std::uint32_t offset : one.pixels) {
        while (place != other.pixels.end() && *place < offset)
            ++place;
        if (place == other.pixels.end())
            break;
        if (*place == offset)
            both.add(pixel_at(offset, canvas));
    }
    return both;
}

/// Two triangles at an edge that they share.
SharedEdge compared_at(const EdgeUse& one, const EdgeUse& other, const EdgeUse& first,
                       const std::vector<Cornered>& triangles, const CanvasSamples& grid) {
    const Cornered& a = triangles[one.triangle];
    const Cornered& b = triangles[other.triangle];
    const Cornered& named_by = triangles[first.triangle];
    const bool is_fold = lie_on_one_side(one, other, triangles);
    SharedEdge edge{.one = a.place,
                    .other = b.place,
                    .named_by = named_by.place,
                    .vertices = {first.from, first.to}};
    if (!is_fold)
        edge.twice = drawn_by_both(*a.drawn, *b.drawn, grid.canvas);
    // Of two triangles that are drawn whole there is nothing to look for.
    if (!a.is_drawn_whole || !b.is_drawn_whole)
        edge.never = pixel_list(never_drawn(named_by.at()[first.from], named_by.at()[first.to], {},
                                            std::array{region_at_edge(one, a, is_fold),
                                                       region_at_edge(other, b, is_fold)},
                                            *a.drawn, *b.drawn, grid),
                                grid.canvas);
    return edge;
}

// Vertices on edges that have no vertex there.

/// A vertex's name in a trace, or its place where the step names no vertices.
std::string vertex_name(const PrimitiveStep& step, std::size_t corner) {
    const std::vector<std::string> names = step.vertices.texts();
    if (names.size() == 3)
        return names[corner];
    const auto at = text_rows(step.at);
    return fmt::format("({}, {})", at[corner][0], at[corner][1]);
}

/// Counts the pixels along a T-junction that its triangle and one beside it drew, or neither did.
void count_pixels(const TJunction& junction, const std::vector<Cornered>& drawn,
                  const CanvasSamples& grid, EdgeWithJunctions& result) {
    const Cornered& owner = drawn[junction.edge.from.triangle];
    const auto covers = [](const Cornered& triangle, std::uint32_t offset) {
        return triangle.drawn->covering().contains(offset);
    };
    const auto triangle_at = [&](const TriangleEdge& edge) -> const Cornered& {
        return drawn[edge.from.triangle];
    };
    std::vector<std::uint32_t> twice;
    std::vector<std::uint32_t> never;
    for (const TriangleEdge& beside : junction.beside) {
        const Cornered& other = triangle_at(beside);
        for (const std::uint32_t offset : other.drawn->covering())
            if (covers(owner, offset))
                twice.push_back(offset);

        // Strictly inside the one or the other, or on both edges.
        std::array<ConvexRegion, 3> regions;
        for (const TriangleEdge& edge : {junction.edge, beside}) {
            const Cornered& triangle = triangle_at(edge);
            const std::size_t from = edge.from.corner;
            ConvexRegion& inside = regions[&triangle == &owner ? 0 : 1];
            inside = triangle.samples->regions().interior;
            inside[from] = interior_of(triangle.samples->regions().closed)[from];
            for (const HalfPlane& plane : region_at_edge(triangle, from))
                regions[2].push_back(plane);
        }
        const auto added = never_drawn(other.at()[beside.from.corner], other.at()[beside.to.corner],
                                       between_ends(owner.at()[junction.edge.from.corner],
                                                    owner.at()[junction.edge.to.corner], grid),
                                       regions, *owner.drawn, *other.drawn, grid);
        never.insert(never.end(), added.begin(), added.end());
    }
    // At a vertex, rounding may give a sample to the next triangle.
    std::erase_if(never, [&](std::uint32_t offset) {
        return std::any_of(
            junction.beside.begin(), junction.beside.end(),
            [&](const TriangleEdge& beside) { return covers(triangle_at(beside), offset); });
    });
    put_in_order(twice);
    put_in_order(never);
    result.twice = pixel_list(twice, grid.canvas);
    result.never = pixel_list(never, grid.canvas);
}

} // namespace

std::string name_of(const SharedEdge& edge, const Stats& stats, const Trace& trace) {
    const std::size_t step = stats.primitives[edge.named_by].step;
    return edge_name(trace.step(step).as<PrimitiveStep>(), edge.vertices[0], edge.vertices[1]);
}

std::vector<SharedEdge> compared_edges(const std::vector<Cornered>& triangles, std::size_t jobs,
                                       const CanvasSamples& grid) {
    const std::vector<EdgeUse> uses = edges_by_ends(triangles);
    const std::vector<EdgeUses> edges = shared_edges(uses);
    std::vector<std::size_t> first_pair; // of each edge
    std::size_t count = 0;
    for (const EdgeUses& edge : edges) {
        first_pair.push_back(count);
        count += edge.size() * (edge.size() - 1) / 2;
    }
    std::vector<SharedEdge> pairs(count);
    in_threads(
        edges.size(), jobs,
        [&](std::size_t i, std::size_t /*thread*/) {
            auto pair = pairs.begin() + static_cast<std::ptrdiff_t>(first_pair[i]);
            for (auto one = edges[i].begin(); one != edges[i].end(); ++one)
                for (auto other = one + 1; other != edges[i].end(); ++other)
                    *pair++ = compared_at(*one, *other, edges[i].front(), triangles, grid);
        },
        neighbors_at_once(edges.size(), jobs));
    return pairs;
}

void find_junctions(const std::vector<Cornered>& drawn, const std::vector<Cornered>& not_drawn,
                    const Trace& trace, const CanvasSamples& grid, Stats& stats) {
    std::vector<ScreenTriangle> mesh;
    for (const Cornered& triangle : drawn)
        mesh.push_back({triangle.at(), triangle.corners});
    for (const Cornered& triangle : not_drawn)
        mesh.push_back({triangle.at(), triangle.corners, false});

    const auto step_of = [&](std::size_t triangle) {
        return trace.step(stats.primitives[drawn[triangle].place].step).as<PrimitiveStep>();
    };
    const auto name_of_triangle = [&](std::size_t triangle) {
        return stats.primitives[drawn[triangle].place].name;
    };
    for (const TJunction& junction : t_junctions_of(mesh)) {
        const auto& [from, to] = junction.edge;
        EdgeWithJunctions edge;
        edge.name = edge_name(step_of(from.triangle), from.corner, to.corner);
        edge.triangle = name_of_triangle(from.triangle);
        for (const auto& [triangle, corner] : junction.vertices)
            edge.vertices.push_back(vertex_name(step_of(triangle), corner));
        for (const TriangleEdge& beside : junction.beside)
            edge.beside.push_back(name_of_triangle(beside.from.triangle));
        count_pixels(junction, drawn, grid, edge);
        stats.t_junctions.push_back(std::move(edge));
    }
}

} // namespace rastertrace
