// SPDX-License-Identifier: MIT
#include "coverage.h"

#include "positions.h"
#include "screen_point.h"
#include "shared_edges.h"
#include "triangle_samples.h"

#include <rastertrace/trace/tell/told_samples.h>

#include <algorithm>
#include <cstdint>
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
auto drawn_on_row(const DrawnPrimitive& primitive, Index row, const Canvas& canvas) {
    const auto begin = static_cast<std::uint32_t>(row * canvas.width);
    return primitive.covering().part(begin, begin + static_cast<std::uint32_t>(canvas.width));
}

/// Compares a triangle with its own corners.
Coverage coverage_of(DrawnTriangle& triangle, const CanvasSamples& grid) {
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

    // On each of them, the gaps between the pixels drawn are holes, as far as they lie inside.
    Coverage coverage;
    Index missing = 0; // of the triangle with all that rounding may add to it
    for (Index row = rows.first; row <= rows.last; ++row) {
        const int y = canvas.y_of(static_cast<int>(row));
        const auto [inside, within_error] = samples.row(y);
        missing += within_error.size();
        Index next = inside.first;
        for (const std::uint32_t offset : drawn_on_row(*triangle.drawn, row, canvas)) {
            const Pixel pixel = pixel_at(offset, canvas);
            if (within_error.has(pixel.x))
                --missing;
            else
                coverage.outside.add(pixel);
            if (inside.has(pixel.x)) {
                add(coverage.holes, y, {next, pixel.x - 1});
                next = pixel.x + 1;
            }
        }
        add(coverage.holes, y, {next, inside.last});
    }
    triangle.is_drawn_whole = missing == 0;
    return coverage;
}

/// What one rounding puts a number of the trace off, relative to it.
double one_rounding_of(const Trace& trace) {
    const Method& method = trace.method.triangles;
    const bool is_exact = decides_exactly(method) || method.scalar == ScalarKind::fixed;
    return is_exact ? 0 : trace.method.has_floats() ? 0x1p-24 : 0x1p-53;
}

/// Judges all triangles with area by samples that are so far from the integer points.
void judge_by_samples(double offset, const Trace& trace, std::vector<DrawnTriangle>& triangles,
                      Stats& stats) {
    const CanvasSamples grid{trace.canvas, offset, one_rounding_of(trace)};
    for (DrawnTriangle& triangle : triangles)
        stats.primitives[triangle.place].coverage = coverage_of(triangle, grid);
    stats.edges = compared_edges(triangles, grid);
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
    const ToldMethod& method = trace.method;
    return !method.word_of("sample").empty() ||
           (method.says("fill") && traits_of(method.triangles.fill).rule != PixelRule::samples);
}

} // namespace

void compare_with_corners(const Trace& trace, std::span<const DrawnPrimitive> drawn, Stats& stats) {
    // The triangles whose corners are known; one without area covers nothing, and shares an edge with nobody.
    PointNumbers numbers;
    std::vector<DrawnTriangle> triangles;
    for (std::uint32_t place = 0; place < drawn.size(); ++place) {
        const auto& at = drawn[place].corners;
        const PrimitiveStats& primitive = stats.primitives[place];
        if (primitive.kind != "triangle" || primitive.skipped == "culled" || !at ||
            orientation((*at)[0], (*at)[1], (*at)[2]) == 0)
            continue;
        triangles.push_back(
            {.drawn = &drawn[place],
             .place = place,
             .corners = {numbers.of((*at)[0]), numbers.of((*at)[1]), numbers.of((*at)[2])}});
    }
    const auto judge = [&](double offset) {
        judge_by_samples(offset, trace, triangles, stats);
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
