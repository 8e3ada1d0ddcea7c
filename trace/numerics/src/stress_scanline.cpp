// SPDX-License-Identifier: MIT
// S: the scanline fill, its rows floor(left)..floor(right), and the edges that it walks along. Pixels
// are integer points.

#include "stress_rows.h"

#include <rastertrace/core/raster/edge.h>
#include <rastertrace/numerics/knobs.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/output.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rastertrace {

namespace {

/// The edge AB of a scene, from (from_x, 0) to (from_x + dx, dy), walked down row by row and floored, against
/// from_x + floor(y dx / dy), which whole numbers give.
struct WholeEdge {
    explicit WholeEdge(const Scene& scene)
        : from_x(whole_place(scene, 0).x), dx(whole_place(scene, 1).x - from_x),
          dy(whole_place(scene, 1).y) {}

    Index from_x;
    Index dx;
    Index dy;

    Index exact_on_row(Index y) const { return from_x + y * dx / dy; }

    /// Counts the rows that `x_on_row(y)` gets wrong.
    template <typename XOnRow> Measured rows_wrong(XOnRow&& x_on_row) const {
        Measured measured{.unit = "row", .worst_unit = "px"};
        std::optional<Index> first_wrong;
        for (Index y = 0; y <= dy; ++y) {
            const auto x = x_on_row(y);
            if (floor_index(x) != exact_on_row(y)) {
                ++measured.wrong;
                first_wrong = first_wrong.value_or(y);
            }
            // x - from_x and y dx are whole or short doubles: only the error itself is rounded.
            if constexpr (std::floating_point<std::remove_cvref_t<decltype(x)>>)
                measured.worst = std::max(
                    measured.worst,
                    std::abs(std::fma(static_cast<double>(x) - static_cast<double>(from_x),
                                      static_cast<double>(dy), -static_cast<double>(y * dx))) /
                        static_cast<double>(dy));
        }
        if (first_wrong)
            measured.note = fmt::format("of {}, first at y={}", dy + 1, *first_wrong);
        return measured;
    }
};

/// With the core's own walk; "lerp" is incremental or direct.
Measured edge_walk(const TableRow& row, std::string_view scalar) {
    const Scene scene = row.scene(scalar);
    const auto form = row.text("lerp") == "incremental" ? LerpForm::incremental : LerpForm::direct;
    return with_numbers_of(scene, [&]<typename Scalar>(const Plan& plan) {
        const Vertex<Scalar> from{place_of<Scalar>(scene, 0, plan), 0};
        const Vertex<Scalar> to{place_of<Scalar>(scene, 1, plan), 1};
        EdgeWalk<Scalar> walk(edge_between(from, to), form, 1);
        return WholeEdge(scene).rows_wrong(
            [&walk](Index y) { return walk.x_on_row(static_cast<int>(y)); });
    });
}

/// x = (1 - t) a + t b.
Measured edge_mix(const TableRow& row, std::string_view scalar) {
    const WholeEdge edge(row.scene(scalar));
    return with_real(scalar, [&edge]<typename Real>() {
        return edge.rows_wrong([&edge](Index y) {
            const Real t = static_cast<Real>(y) / static_cast<Real>(edge.dy);
            return (1 - t) * static_cast<Real>(edge.from_x) +
                   t * static_cast<Real>(edge.from_x + edge.dx);
        });
    });
}

/// The fixed-point walk that the report measures: the slope truncated to "bits", and added row after row.
Measured fixed_point_walk(const TableRow& row, std::string_view) {
    const WholeEdge edge(row.scene({}));
    const int bits = row.number<int>("bits");
    const Int128 unit = Int128{1} << bits;
    FixedPointWalk<Int128> walk(
        {edge.from_x * unit, 0, (edge.from_x + edge.dx) * unit, edge.dy * unit, unit}, 1, 0, bits);
    Measured measured{.unit = "row"};
    for (Index y = 0; y <= edge.dy; ++y) {
        walk.step();
        measured.wrong += walk.pixel() == edge.exact_on_row(y) ? 0 : 1;
    }
    return measured;
}

/// S6 on double: the same edge where double has only every second whole number, in the textbook's
/// loop (our indices end at 2^53 - 1). "loop" is accumulate or multiply.
Measured absorbed_at_2_53(const TableRow& row, std::string_view) {
    const double start = 0x1p53;
    const bool accumulates = row.text("loop") == "accumulate";
    double sum = start;
    Measured measured{.unit = "row"};
    for (Index y = 0; y <= 2000; ++y, sum += 0.001) {
        const double x = accumulates ? sum : start + 0.001 * static_cast<double>(y);
        measured.wrong +=
            static_cast<Index>(std::floor(x)) == (Index{1} << 53) + y * 2 / 2000 ? 0 : 1;
    }
    return measured;
}

/// How many pixels the trace names, plotted or rejected.
Measured pixels_named(const TableRow& row, std::string_view scalar) {
    const Trace trace = row.trace(scalar);
    std::uint64_t pixels = count_of(trace, StepKind::pixel);
    for (const std::size_t n : trace.steps_of({StepKind::reject})) {
        const auto reject = trace.step(n).as<RejectStep>();
        pixels += static_cast<std::uint64_t>(reject.to_x.value_or(*reject.x) - *reject.x + 1);
    }
    return counted_as(row, pixels);
}

/// The steps of a kind: as many as expected, or at most so many.
Measured steps_of_kind(const TableRow& row, std::string_view scalar) {
    const std::uint64_t count = count_of(row.trace(scalar), *step_kind_named(row.text("kind")));
    if (row.has("expected"))
        return counted_as(row, count);
    const auto most = row.number<std::uint64_t>("most");
    return {
        .wrong = count > most ? count - most : 0, .unit = "step", .note = counted(count, "step")};
}

/// The pixels that two triangles both have.
Measured common_to_two(const TableRow& row, std::string_view scalar) {
    const Scene scene = row.scene(scalar);
    const auto covered = [&scene](std::size_t i) {
        return covered_by(exact_corners(scene, i), scene.method, scene.canvas);
    };
    return counted_as(row, common_pixels(covered(0), covered(1)));
}

/// -0 among the numbers of a trace.
Measured minus_zeros(const TableRow& row, std::string_view scalar) {
    std::string text;
    StringOutput output(text);
    write_trace(row.scene(scalar), {}, output);
    Measured measured{.unit = "number"};
    for (const std::string_view minus_zero : {"-0,", "-0]", "-0}", "-0\"", "-0.0"})
        for (auto at = text.find(minus_zero); at != std::string::npos;
             at = text.find(minus_zero, at + 1))
            ++measured.wrong;
    return measured;
}

constexpr auto measures_of_scanlines = std::to_array<NamedMeasure>({
    {"edge walk", edge_walk},
    {"edge mix", edge_mix},
    {"fixed-point walk", fixed_point_walk},
    {"absorbed at 2^53", absorbed_at_2_53},
    {"pixels named", pixels_named},
    {"steps", steps_of_kind},
    {"common pixels", common_to_two},
    {"minus zeros", minus_zeros},
});

} // namespace

std::span<const NamedMeasure> scanline_measures() {
    return measures_of_scanlines;
}

} // namespace rastertrace
