// SPDX-License-Identifier: MIT
// L: lines. Pixels are integer points.

#include "stress_rows.h"

#include <rastertrace/core/raster/line_bresenham.h>
#include <rastertrace/core/raster/line_sampling.h>
#include <rastertrace/core/raster/rounding.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rastertrace {

namespace {

/// The pixels of one scene that another does not have, both exact: two methods that are said to be the same.
Measured lines_apart(const TableRow& row, std::string_view scalar) {
    const auto a = reference_picture(row.scene(scalar));
    const auto b = reference_picture(row.scene(scalar, "other", "other_by"));
    // Each place where they part leaves a pixel in both pictures.
    return {.wrong = differing(a, b) / 2, .unit = "pixel"};
}

/// The textbook's loop from (0, 0) to B, 0 <= dy <= dx, for a line that no canvas could hold, against the whole
/// numbers that the quotient x dy / dx rounds to; ties go up. "loop" is accumulate, y += m, or multiply, y = m x.
Measured line_loop(const TableRow& row, std::string_view scalar) {
    const Scene line = row.scene(scalar);
    const Index dx = whole_place(line, 1).x;
    const Index dy = whole_place(line, 1).y;
    const bool accumulates = row.text("loop") == "accumulate";
    return with_numbers_of(line, [&]<typename Scalar>(const Plan& plan) {
        const auto from = place_of<Scalar>(line, 0, plan);
        const auto to = place_of<Scalar>(line, 1, plan);
        const Scalar m = Scalar(to.y - from.y) / Scalar(to.x - from.x);
        Scalar y = from.y + m * Scalar(scalar_from<Scalar>(0) - from.x);
        Scalar step = m;
        if (accumulates)
            write_over_denominator_of(y, step);

        Measured measured{.unit = "pixel", .worst_unit = "px"};
        std::optional<Index> first_wrong;
        for (Index x = 0; x <= dx; ++x) {
            if (!accumulates)
                y = from.y + m * Scalar(scalar_from<Scalar>(x) - from.x);
            else if (x > 0)
                y += step;
            if (nearest_index(y, Ties::up) != (2 * x * dy + dx) / (2 * dx)) {
                ++measured.wrong;
                first_wrong = first_wrong.value_or(x);
            }
            // x dy is a whole double: the only rounding is that of the error itself.
            if constexpr (std::floating_point<Scalar>)
                measured.worst =
                    std::max(measured.worst,
                             std::abs(std::fma(static_cast<double>(y), static_cast<double>(dx),
                                               -static_cast<double>(x * dy))) /
                                 static_cast<double>(dx));
        }
        const double at_end = distance_from(Rational(static_cast<long>(dy)), y);
        if constexpr (!std::floating_point<Scalar>)
            measured.worst = at_end;
        if (first_wrong)
            measured.note =
                fmt::format("first at x={}, {:.3g} px at the end", *first_wrong, at_end);
        return measured;
    });
}

BresenhamLine bresenham_line(const TableRow& row) {
    return BresenhamLine({0, 0}, whole_place(row.scene({}), 1));
}

/// Each pixel of the same line.
Measured bresenham_loop(const TableRow& row, std::string_view) {
    const auto [dx, dy] = whole_place(row.scene({}), 1);
    const BresenhamLine line = bresenham_line(row);
    Measured measured{.unit = "pixel"};
    for (Index x = 0; x <= dx; ++x) {
        // At a tie Bresenham's line stays below.
        const Index exact = (2 * x * dy + dx - 1) / (2 * dx);
        measured.wrong += line.pixel(x) == GridPoint{x, exact} ? 0 : 1;
    }
    return measured;
}

Measured bresenham_pixels(const TableRow& row, std::string_view) {
    return counted_as(row, static_cast<std::uint64_t>(bresenham_line(row).steps() + 1));
}

Measured bresenham_first_column(const TableRow& row, std::string_view) {
    const BresenhamLine line = bresenham_line(row);
    Index y = 0;
    while (line.pixel(y).x == 0)
        ++y;
    return counted_as(row, static_cast<std::uint64_t>(y));
}

Measured bresenham_first_d(const TableRow& row, std::string_view) {
    return counted_as(row, static_cast<std::uint64_t>(bresenham_line(row).d(0)));
}

/// L7: the textbook's `for (x = x0; x <= x1; x += 1)` on floating point, up to 16777217.
Measured count_up(const TableRow&, std::string_view scalar) {
    return with_real(scalar, []<typename Real>() -> Measured {
        constexpr std::int64_t last = 16'777'217;
        Real x = 0;
        for (std::int64_t i = 0; i < last; ++i) {
            const auto next = static_cast<Real>(x + 1);
            if (next == x)
                return {.wrong = static_cast<std::uint64_t>(last - i),
                        .unit = "step",
                        .note = fmt::format("never ends: {0:.0f} + 1 = {0:.0f}", x)};
            x = next;
        }
        return {.note = "ends"};
    });
}

/// L13: the textbook's level of red from 10 to 200, `c += 190/7`, cast to int at the end.
Measured last_level(const TableRow&, std::string_view scalar) {
    return with_real(scalar, []<typename Real>() -> Measured {
        const Real step = Real(190) / Real(7);
        Real level = 10;
        for (int i = 0; i < 7; ++i)
            level += step;
        const int last = static_cast<int>(level);
        return {.wrong = last == 200 ? 0u : 1u,
                .unit = "level",
                .note = fmt::format("{} becomes {}", level, last)};
    });
}

constexpr auto measures_of_lines = std::to_array<NamedMeasure>({
    {"lines apart", lines_apart},
    {"line loop", line_loop},
    {"bresenham loop", bresenham_loop},
    {"bresenham pixels", bresenham_pixels},
    {"bresenham first x=1", bresenham_first_column},
    {"bresenham first d", bresenham_first_d},
    {"count up", count_up},
    {"last level", last_level},
});

} // namespace

std::span<const NamedMeasure> line_measures() {
    return measures_of_lines;
}

} // namespace rastertrace
