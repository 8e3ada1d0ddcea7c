// SPDX-License-Identifier: MIT
#include "shared_edges.h"

#include "screen_point.h"
#include "triangle_samples.h"

#include <rastertrace/trace/record/traced_steps.h>
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

/// An edge of a triangle.
struct EdgeUse {
    std::uint64_t ends; ///< numbers of its ends, the same from either of them
    std::uint32_t triangle;
    std::uint8_t from; ///< its vertices, 0 to 2
    std::uint8_t to;

    /// Its number in TriangleSamples.
    std::size_t number() const { return to == from + 1 ? from : to; }
};

/// All edges of some triangles, those with the same ends behind one another.
std::vector<EdgeUse> edges_by_ends(const std::vector<DrawnTriangle>& triangles) {
    std::vector<EdgeUse> uses;
    uses.reserve(3 * triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (const auto& [from, to] :
             {std::pair<std::uint8_t, std::uint8_t>{0, 1}, {0, 2}, {1, 2}}) {
            const auto [low, high] =
                std::minmax(triangles[i].corners[from], triangles[i].corners[to]);
            uses.push_back({std::uint64_t{low} << 32 | high, i, from, to});
        }
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
            edges.push_back(EdgeUses(&*first, std::min(count, most_compared)));
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
                     const std::vector<DrawnTriangle>& triangles) {
    const auto& at = triangles[one.triangle].at();
    const auto side_of = [&](const EdgeUse& use) {
        const std::size_t opposite = 3U - use.from - use.to;
        return orientation(at[one.from], at[one.to], triangles[use.triangle].at()[opposite]);
    };
    return side_of(one) == side_of(other);
}

/// True of a pixel that lies so far from the other two edges of a triangle that no rounding matters, and up to as far
/// beyond this one as rounding may put it. The edge of a fold is like the other two: what lies on it lies between no two
/// triangles.
bool is_at(const EdgeUse& edge, const TriangleSamples& samples, bool is_fold, const Pixel& pixel) {
    using Place = TriangleSamples::Place;
    for (std::size_t i = 0; i < 3; ++i)
        if (const bool is_shared = i == edge.number() && !is_fold;
            !samples.admits(i, pixel.x, pixel.y, is_shared ? Place::within_error : Place::inside))
            return false;
    return true;
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
                       const std::vector<DrawnTriangle>& triangles, const CanvasSamples& grid) {
    const DrawnTriangle& a = triangles[one.triangle];
    const DrawnTriangle& b = triangles[other.triangle];
    const bool is_fold = lie_on_one_side(one, other, triangles);
    SharedEdge edge{.one = a.place,
                    .other = b.place,
                    .named_by = triangles[first.triangle].place,
                    .vertices = {first.from, first.to}};
    if (!is_fold)
        edge.twice = drawn_by_both(*a.drawn, *b.drawn, grid.canvas);
    // Of two triangles that are drawn whole there is nothing to look for.
    if (a.is_drawn_whole && b.is_drawn_whole)
        return edge;
    const TriangleSamples samples_a(a.at(), grid);
    const TriangleSamples samples_b(b.at(), grid);
    for (const Pixel& pixel : pixels_near(a.at()[one.from], a.at()[one.to], grid)) {
        const auto offset = static_cast<std::uint32_t>(grid.canvas.offset_of(pixel));
        if (!a.drawn->covering().contains(offset) && !b.drawn->covering().contains(offset) &&
            (is_at(one, samples_a, is_fold, pixel) || is_at(other, samples_b, is_fold, pixel)))
            edge.never.add(pixel);
    }
    return edge;
}

} // namespace

std::string name_of(const SharedEdge& edge, const Stats& stats, const Trace& trace) {
    const std::size_t step = stats.primitives[edge.named_by].step;
    return edge_name(trace.step(step).as<PrimitiveStep>(), edge.vertices[0], edge.vertices[1]);
}

std::vector<SharedEdge> compared_edges(const std::vector<DrawnTriangle>& triangles,
                                       const CanvasSamples& grid) {
    const std::vector<EdgeUse> uses = edges_by_ends(triangles);
    std::vector<SharedEdge> pairs;
    for (const EdgeUses& edge : shared_edges(uses))
        for (auto one = edge.begin(); one != edge.end(); ++one)
            for (auto other = one + 1; other != edge.end(); ++other)
                pairs.push_back(compared_at(*one, *other, edge.front(), triangles, grid));
    return pairs;
}

} // namespace rastertrace
