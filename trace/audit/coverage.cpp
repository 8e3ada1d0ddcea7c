// SPDX-License-Identifier: MIT
#include "coverage.h"

#include "cornered.h"
#include "positions.h"
#include "screen_point.h"
#include "shared_edges.h"
#include "triangle_samples.h"

#include <rastertrace/trace/record/told_samples.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace rastertrace {

namespace {

/// Adds the pixels of a row; the time it takes does not depend on how many are not kept.
void add(PixelList& list, int y, const Span& span) {
    if (span.is_empty())
        return;
    list.count += static_cast<std::uint64_t>(span.last - span.first + 1);
    for (Index x = span.first; x <= span.last && list.kept.size() < most_pixels_kept; ++x)
        list.kept.push_back({static_cast<int>(x), y});
}

/// The pixels that a primitive covers on a row of the canvas.
PixelSet::Part drawn_on_row(const DrawnPrimitive& primitive, Index row, const Canvas& canvas) {
    const auto begin = static_cast<std::uint32_t>(row * canvas.width);
    return primitive.covering().part(begin, begin + static_cast<std::uint32_t>(canvas.width));
}

// A triangle against its own corners.

/// The pixels `gap` of a row were not drawn; `inside` is the part of the row within the triangle.
void add_missing(Coverage& coverage, int y, const Span& gap, const Span& inside) {
    if (inside.is_empty())
        return add(coverage.open_edge, y, gap);
    add(coverage.open_edge, y, common_part(gap, {gap.first, inside.first - 1}));
    add(coverage.holes, y, common_part(gap, inside));
    add(coverage.open_edge, y, common_part(gap, {inside.last + 1, gap.last}));
}

Coverage coverage_of(const Cornered& triangle, const CanvasSamples& grid) {
    const Canvas& canvas = grid.canvas;
    const auto& [a, b, c] = triangle.at();
    const auto& drawn = triangle.drawn->covering();
    const TriangleSamples samples(triangle.at(), grid);

    // The rows that the triangle passes through, and those that it was drawn on.
    Span rows = grid.rows_about(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}));
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
        const auto [closed, inside, within_error] = samples.row(y);
        Index next = closed.first;
        for (const std::uint32_t offset : drawn_on_row(*triangle.drawn, row, canvas)) {
            const Pixel pixel = pixel_at(offset, canvas);
            if (!closed.has(pixel.x)) {
                if (!within_error.has(pixel.x))
                    coverage.outside.add(pixel);
                continue;
            }
            add_missing(coverage, y, {next, pixel.x - 1}, inside);
            next = pixel.x + 1;
        }
        add_missing(coverage, y, {next, closed.last}, inside);
    }
    return coverage;
}

/// What one rounding puts a number of the trace off, relative to it.
double one_rounding_of(const Trace& trace) {
    const std::string scalar = trace.method_value("scalar");
    const bool is_exact = scalar == "exact" || scalar == "adaptive" || scalar == "fixed";
    return is_exact ? 0 : has_floats(trace) ? 0x1p-24 : 0x1p-53;
}

/// Judges all triangles with area by samples that are so far from the integer points.
void judge_by_samples(double offset, const Trace& trace, std::vector<Cornered>& fills,
                      Stats& stats) {
    const CanvasSamples grid{trace.canvas, offset, one_rounding_of(trace)};
    for (Cornered& fill : fills) {
        const Coverage& coverage =
            stats.primitives[fill.place].coverage.emplace(coverage_of(fill, grid));
        fill.is_drawn_whole = coverage.holes.count == 0 && coverage.open_edge.count == 0;
    }
    stats.edges = compared_edges(fills, grid);
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
            alone.add(pixel_at(offset, canvas));
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

void compare_with_corners(const Trace& trace, std::span<const DrawnPrimitive> drawn, Stats& stats) {
    // The triangles and the outlines whose corners are known.
    PointNumbers numbers;
    std::vector<Cornered> fills;
    std::vector<Cornered> outlines;
    for (std::uint32_t place = 0; place < drawn.size(); ++place) {
        const std::string& kind = stats.primitives[place].kind;
        const bool is_culled = stats.primitives[place].skipped == "culled";
        if ((kind != "triangle" && kind != "outline") || is_culled || !drawn[place].corners)
            continue;
        auto& list = kind == "outline" ? outlines : fills;
        Cornered& cornered = list.emplace_back(Cornered{.drawn = &drawn[place], .place = place});
        for (std::size_t i = 0; i < 3; ++i)
            cornered.corners[i] = numbers.of(cornered.at()[i]);
    }
    compare_outlines(outlines, fills, trace.canvas, stats);

    // A triangle without area covers nothing, and shares an edge with nobody.
    std::erase_if(fills, [](const Cornered& fill) {
        return orientation(fill.at()[0], fill.at()[1], fill.at()[2]) == 0;
    });
    const auto judge = [&](double offset) {
        judge_by_samples(offset, trace, fills, stats);
        return explains_all(stats);
    };
    if (tells_sample(trace)) {
        judge(told_samples(trace).triangles.x().get_d());
        return;
    }
    constexpr double center = 0.5;
    const bool center_explains = judge(center);
    const bool integer_explains = judge(0);
    if (center_explains && integer_explains)
        return;
    stats.sample = {.is_center = center_explains,
                    .explains_all = center_explains || integer_explains};
    if (center_explains)
        judge(center);
}

} // namespace rastertrace
