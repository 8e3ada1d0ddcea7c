// SPDX-License-Identifier: MIT
#include "coverage.h"

#include "outside_causes.h"
#include "positions.h"
#include "t_junctions.h"
#include "triangle_samples.h"

#include <rastertrace/trace/record/told_samples.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/in_threads.h>
#include <rastertrace/trace/text/primitive_name.h>

#include <fmt/core.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

namespace rastertrace {

namespace {

/// So many primitives, or edges, a thread takes at a time: neighbors, whose steps and corners stand near each other.
std::size_t at_once(std::size_t count, std::size_t jobs) {
    return std::clamp<std::size_t>(count / (8 * jobs), 1, 64);
}

Span common_part(const Span& a, const Span& b) {
    return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

void add(PixelList& list, Pixel pixel) {
    ++list.count;
    if (list.kept.size() < most_pixels_kept)
        list.kept.push_back(pixel);
}

/// Adds the pixels of a row; the time it takes does not depend on how many are not kept.
void add(PixelList& list, int y, const Span& span) {
    if (span.is_empty())
        return;
    list.count += static_cast<std::uint64_t>(span.last - span.first + 1);
    for (Index x = span.first; x <= span.last && list.kept.size() < most_pixels_kept; ++x)
        list.kept.push_back({static_cast<int>(x), y});
}

void put_in_order(std::vector<std::uint32_t>& pixels) {
    if (!std::is_sorted(pixels.begin(), pixels.end()))
        std::sort(pixels.begin(), pixels.end());
    pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
}

/// A triangle or an outline, with its corners.
struct Cornered {
    const DrawnPrimitive* drawn = nullptr;
    std::uint32_t place = 0;                ///< in Stats::primitives
    std::array<std::uint32_t, 3> corners{}; ///< numbers of the positions; the same for equal ones
    std::unique_ptr<const TriangleSamples> samples = {}; ///< of a triangle with area
    bool is_drawn_whole = false; ///< it has all its samples, and rounding matters for none of them

    const std::array<ScreenPoint, 3>& at() const { return *drawn->corners; }
};

/// The pixels that a primitive covers on a row of the canvas.
PixelSet::Part drawn_on_row(const DrawnPrimitive& primitive, Index row, const Canvas& canvas) {
    const auto begin = static_cast<std::uint32_t>(row * canvas.width);
    return primitive.covering().part(begin, begin + static_cast<std::uint32_t>(canvas.width));
}

Pixel pixel_at(std::uint32_t offset, const Canvas& canvas) {
    const int place = static_cast<int>(offset);
    return {canvas.left() + place % canvas.width, canvas.y_of(place / canvas.width)};
}

// A triangle against its own corners.

/// The pixels `gap` of a row were not drawn; `inside` is the part of the row within the triangle.
void add_missing(Coverage& coverage, int y, const Span& gap, const Span& inside) {
    add(coverage.open_edge, y, common_part(gap, {gap.first, inside.first - 1}));
    add(coverage.holes, y, common_part(gap, inside));
    add(coverage.open_edge, y, common_part(gap, {inside.last + 1, gap.last}));
}

/// What a triangle drew, but for the causes: `outside` gets the places of the pixels that need one, in ascending order.
Coverage coverage_of(const Cornered& triangle, const CanvasSamples& grid,
                     std::vector<std::uint32_t>& outside) {
    const Canvas& canvas = grid.canvas;
    const auto& [a, b, c] = triangle.at();
    const auto& drawn = triangle.drawn->covering();

    // The rows that the triangle passes through, and those that it was drawn on.
    Span rows = rows_between(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), grid);
    if (!drawn.empty()) {
        const Span drawn_rows{canvas.row_of(pixel_at(drawn.front(), canvas).y),
                              canvas.row_of(pixel_at(drawn.back(), canvas).y)};
        rows = rows.is_empty() ? drawn_rows
                               : Span{std::min(rows.first, drawn_rows.first),
                                      std::max(rows.last, drawn_rows.last)};
    }

    // On each of them, the gaps between the pixels drawn are missing, as far as the triangle goes.
    Coverage coverage;
    for (Index row = rows.first; row <= rows.last; ++row) {
        const int y = canvas.y_of(static_cast<int>(row));
        const auto [closed, inside, within_error] = triangle.samples->row(y);
        Index next = closed.first;
        for (const std::uint32_t offset : drawn_on_row(*triangle.drawn, row, canvas)) {
            const Pixel pixel = pixel_at(offset, canvas);
            if (!closed.has(pixel.x)) {
                if (!within_error.has(pixel.x)) {
                    add(coverage.outside, pixel);
                    outside.push_back(offset);
                }
                continue;
            }
            add_missing(coverage, y, {next, pixel.x - 1}, inside);
            next = pixel.x + 1;
        }
        add_missing(coverage, y, {next, closed.last}, inside);
    }
    return coverage;
}

// Two triangles at the edge that they share.

/// An edge of a triangle.
struct EdgeUse {
    std::uint64_t ends; ///< the numbers of its vertices, the smaller one in front
    std::uint32_t triangle;
    std::uint8_t from; ///< its vertices, 0 to 2
    std::uint8_t to;
};

/// The numbers of two vertices of a triangle, as EdgeUse has them.
std::uint64_t ends_of(const Cornered& triangle, std::size_t from, std::size_t to) {
    const auto [low, high] = std::minmax(triangle.corners[from], triangle.corners[to]);
    return std::uint64_t{low} << 32 | high;
}

/// All edges of some triangles, those with the same ends behind one another.
std::vector<EdgeUse> edges_by_ends(const std::vector<Cornered>& triangles) {
    std::vector<EdgeUse> uses;
    uses.reserve(3 * triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (const auto& [from, to] : {std::pair<std::uint8_t, std::uint8_t>{0, 1}, {0, 2}, {1, 2}})
            uses.push_back({ends_of(triangles[i], from, to), i, from, to});
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
        add(list, pixel_at(offset, canvas));
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
            add(both, pixel_at(offset, canvas));
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

/// Every pair of the triangles at every edge.
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
        at_once(edges.size(), jobs));
    return pairs;
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

/// The T-junctions among the triangles that are drawn. The edges of those that are not count too:
/// whoever shares one has a neighbor.
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

/// What one rounding puts a number of the trace off, relative to it.
double one_rounding_of(const Trace& trace) {
    const std::string scalar = trace.method_value("scalar");
    const bool is_exact = scalar == "exact" || scalar == "adaptive" || scalar == "fixed";
    return is_exact ? 0 : has_floats(trace) ? 0x1p-24 : 0x1p-53;
}

/// Judges all triangles with area by the samples of a grid.
void judge_by_samples(const CanvasSamples& grid, const Trace& trace, std::size_t jobs,
                      std::vector<Cornered>& fills, const std::vector<Cornered>& not_drawn,
                      Stats& stats) {
    stats.t_junctions.clear();
    const double one_rounding = one_rounding_of(trace);
    std::vector<OutsideCauses> causes;
    for (std::size_t i = 0; i < jobs; ++i)
        causes.emplace_back(trace, grid);
    in_threads(
        fills.size(), jobs,
        [&](std::size_t i, std::size_t thread) {
            Cornered& fill = fills[i];
            fill.samples = std::make_unique<TriangleSamples>(fill.at(), grid, one_rounding);
            std::vector<std::uint32_t> outside;
            PrimitiveStats& primitive = stats.primitives[fill.place];
            Coverage& coverage = primitive.coverage.emplace(coverage_of(fill, grid, outside));
            coverage.causes = causes[thread].of(outside, primitive.step);
            fill.is_drawn_whole = coverage.holes.count == 0 && coverage.open_edge.count == 0 &&
                                  fill.samples->is_clear();
        },
        at_once(fills.size(), jobs));
    stats.edges = compared_edges(fills, jobs, grid);
    find_junctions(fills, not_drawn, trace, grid, stats);
    for (Cornered& fill : fills)
        fill.samples.reset(); // they refer to the grid
}

/// True if every pixel has been drawn whose sample lies inside a triangle, and no other one.
bool explains_all(const Stats& stats) {
    return std::all_of(stats.primitives.begin(), stats.primitives.end(),
                       [](const PrimitiveStats& one) {
                           return !one.coverage || (one.coverage->holes.count == 0 &&
                                                    one.coverage->outside.count == 0);
                       }) &&
           std::all_of(stats.edges.begin(), stats.edges.end(),
                       [](const SharedEdge& edge) { return edge.never.count == 0; });
}

/// True if a trace says where its sample points are. The fills that go from row to row, and the
/// fan, have them at integer points.
bool tells_sample(const Trace& trace) {
    const std::string fill = trace.method_value("fill");
    return !trace.method_value("sample").empty() || fill == "scanline" || fill == "two-halves" ||
           fill == "fan";
}

// Outlines against fills.

PixelList drawn_by_first_only(const DrawnPrimitive& first, const DrawnPrimitive& other,
                              const Canvas& canvas) {
    PixelList alone;
    for (const std::uint32_t offset : first.pixels)
        if (!other.pixels.contains(offset))
            add(alone, pixel_at(offset, canvas));
    return alone;
}

/// Every pair of an outline and a fill with the same corners, in whatever order they are named.
void compare_outlines(const std::vector<Cornered>& outlines, const std::vector<Cornered>& fills,
                      const Canvas& canvas, Stats& stats) {
    struct SameCorners {
        std::size_t outlines = 0;
        std::vector<const Cornered*> fills;
    };
    std::map<std::array<std::uint32_t, 3>, SameCorners> known;
    const auto same_corners = [&known](const Cornered& primitive) -> SameCorners& {
        auto corners = primitive.corners;
        std::sort(corners.begin(), corners.end());
        return known[corners];
    };
    for (const Cornered& fill : fills)
        if (SameCorners& same = same_corners(fill); same.fills.size() < most_compared)
            same.fills.push_back(&fill);

    for (const Cornered& outline : outlines) {
        SameCorners& same = same_corners(outline);
        if (++same.outlines > most_compared)
            continue;
        for (const Cornered* fill : same.fills)
            stats.outlines.push_back(
                {.outline = stats.primitives[outline.place].name,
                 .fill = stats.primitives[fill->place].name,
                 .outside = drawn_by_first_only(*outline.drawn, *fill->drawn, canvas)});
    }
}

} // namespace

void DrawnPixels::give_to(DrawnPrimitive& primitive) {
    put_in_order(pixels_);
    primitive.pixels = PixelSet(pixels_);
    if (!hidden_.empty()) {
        hidden_.insert(hidden_.end(), pixels_.begin(), pixels_.end());
        put_in_order(hidden_);
        primitive.covered = PixelSet(hidden_);
    }
    pixels_.clear();
    hidden_.clear();
}

std::string name_of(const SharedEdge& edge, const Stats& stats, const Trace& trace) {
    const std::size_t step = stats.primitives[edge.named_by].step;
    return edge_name(trace.step(step).as<PrimitiveStep>(), edge.vertices[0], edge.vertices[1]);
}

void compare_with_corners(const Trace& trace, std::span<const DrawnPrimitive> drawn,
                          std::size_t jobs, Stats& stats) {
    // The triangles and the outlines whose corners are known.
    PointNumbers numbers;
    std::vector<Cornered> fills;
    std::vector<Cornered> not_drawn;
    std::vector<Cornered> outlines;
    for (std::uint32_t place = 0; place < drawn.size(); ++place) {
        const std::string& kind = stats.primitives[place].kind;
        const bool is_culled = stats.primitives[place].skipped == "culled";
        if ((kind != "triangle" && (kind != "outline" || is_culled)) || !drawn[place].corners)
            continue;
        auto& list = kind == "outline" ? outlines : is_culled ? not_drawn : fills;
        Cornered& cornered = list.emplace_back(Cornered{.drawn = &drawn[place], .place = place});
        for (std::size_t i = 0; i < 3; ++i)
            cornered.corners[i] = numbers.of(cornered.at()[i]);
    }
    compare_outlines(outlines, fills, trace.canvas, stats);

    // A triangle without area covers nothing, and shares an edge with nobody.
    const auto flat = std::stable_partition(fills.begin(), fills.end(), [](const Cornered& fill) {
        return orientation(fill.at()[0], fill.at()[1], fill.at()[2]) != 0;
    });
    std::move(flat, fills.end(), std::back_inserter(not_drawn));
    fills.erase(flat, fills.end());
    const auto judge = [&](const SampleOffset<mpq_class>& offset) {
        judge_by_samples({trace.canvas, offset}, trace, jobs, fills, not_drawn, stats);
        return explains_all(stats);
    };
    if (tells_sample(trace)) {
        judge(told_samples(trace).triangles);
        return;
    }
    const SampleOffset<mpq_class> center(mpq_class(1, 2), mpq_class(1, 2));
    const bool center_explains = judge(center);
    const bool integer_explains = judge({});
    if (center_explains && integer_explains)
        return;
    stats.sample = {.is_center = center_explains,
                    .explains_all = center_explains || integer_explains};
    if (center_explains)
        judge(center);
}

} // namespace rastertrace
