// SPDX-License-Identifier: MIT
// L: lines. Pixels are integer points.

#include "stress_rows.h"

#include <rastertrace/core/raster/line_bresenham.h>
#include <rastertrace/core/raster/line_sampling.h>
#include <rastertrace/core/raster/rounding.h>

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <optional>

namespace rastertrace {

namespace {

const MethodOverrides bresenham{{"line", "bresenham"}};
const MethodOverrides bresenham_step{{"line", "bresenham"}, {"ties", "step"}};
const MethodOverrides naive_away{{"line", "naive"}, {"ties", "away"}};
const MethodOverrides naive{{"line", "naive"}};
const MethodOverrides dda{{"line", "dda"}};

/// The line of a scene by each of the three methods, all with the tie rule of Bresenham's.
void add_three_methods(StressRows& rows, std::string_view json, std::uint64_t pixels,
                       const DocumentedOfScalars& of_bresenham = {},
                       const DocumentedOfScalars& of_naive = {},
                       const DocumentedOfScalars& of_dda = {}) {
    rows.add_pictures(json, "bresenham", bresenham, pixels, of_bresenham);
    rows.add_pictures(json, "naive", naive, pixels, of_naive);
    rows.add_pictures(json, "dda", dda, pixels, of_dda);
}

/// The largest relative error of one operation.
constexpr double float_unit = rounding_unit<float>();
constexpr double double_unit = rounding_unit<double>();

/// How a line's pixels are found from (0, 0) to (dx, dy), 0 <= dy <= dx.
enum class Loop {
    accumulate, ///< y += m
    multiply,   ///< y = m x
};

/// The textbook's loop for a line that no canvas could hold, against the whole numbers that the
/// quotient x dy / dx rounds to; ties go up.
struct LineLoop {
    Index dx;
    Index dy;

    Scene scene(std::string_view scalar) const {
        return readable_scene(fmt::format(R"({{"canvas":{{"width":8,"height":8}},)"
                                          R"("vertices":{{"A":[0,0],"B":[{},{}]}},)"
                                          R"("lines":["AB"],"method":{{"line":"dda"}}}})",
                                          dx, dy),
                              with_scalar_named({}, scalar));
    }

    Measured run(std::string_view scalar, Loop loop) const {
        const Scene line = scene(scalar);
        return with_numbers_of(line, [&]<typename Scalar>(const Plan& plan) {
            const auto from = place_of<Scalar>(line, 0, plan);
            const auto to = place_of<Scalar>(line, 1, plan);
            const Scalar m = Scalar(to.y - from.y) / Scalar(to.x - from.x);
            Scalar y = from.y + m * Scalar(scalar_from<Scalar>(0) - from.x);
            Scalar step = m;
            if (loop == Loop::accumulate)
                write_over_denominator_of(y, step);

            Measured measured{.unit = "pixel", .worst_unit = "px"};
            std::optional<Index> first_wrong;
            for (Index x = 0; x <= dx; ++x) {
                if (loop == Loop::multiply)
                    y = from.y + m * Scalar(scalar_from<Scalar>(x) - from.x);
                else if (x > 0)
                    y += step;
                const Index exact = (2 * x * dy + dx) / (2 * dx);
                if (nearest_index(y, Ties::up) != exact) {
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
            if constexpr (!std::floating_point<Scalar>)
                measured.worst = distance_from(Rational(static_cast<long>(dy)), y);
            if (first_wrong)
                measured.note = fmt::format("first at x={}, {:.3g} px at the end", *first_wrong,
                                            distance_from(Rational(static_cast<long>(dy)), y));
            return measured;
        });
    }

    /// How far off n additions of a rounded slope may be: the slope's own rounding n times, and that
    /// of each sum, which is at most dy.
    Documented within_of_sums(double rounding_unit) const {
        return within(2 * static_cast<double>(dx) * static_cast<double>(dy) * rounding_unit);
    }

    /// How far off a product may be: the slope is rounded, then the product.
    Documented within_of_products(double rounding_unit) const {
        return within((2 + rounding_unit) * rounding_unit * static_cast<double>(dy));
    }

    /// With every scalar, both loops.
    void add_to(StressRows& rows, const DocumentedOfScalars& accumulated,
                const DocumentedOfScalars& multiplied) const {
        rows.add_for_all("accumulate, y += m", accumulated,
                         [this](std::string_view scalar) { return run(scalar, Loop::accumulate); });
        rows.add_for_all("multiply, y = m x", multiplied,
                         [this](std::string_view scalar) { return run(scalar, Loop::multiply); });
        const BresenhamLine line({0, 0}, {dx, dy});
        std::uint64_t differing = 0;
        for (Index x = 0; x <= dx; ++x) {
            // At a tie Bresenham's line stays below.
            const Index exact = (2 * x * dy + dx - 1) / (2 * dx);
            differing += line.pixel(x) == GridPoint{x, exact} ? 0 : 1;
        }
        rows.add("whole numbers", "bresenham", {.wrong = differing, .unit = "pixel"}, right());
    }
};

/// L7: the textbook's `for (x = x0; x <= x1; x += 1)` on floating point, up to 16777217.
template <typename Scalar> Measured count_up() {
    constexpr std::int64_t last = 16'777'217;
    Scalar x = 0;
    for (std::int64_t i = 0; i < last; ++i) {
        const auto next = static_cast<Scalar>(x + 1);
        if (next == x)
            return {.wrong = static_cast<std::uint64_t>(last - i),
                    .unit = "step",
                    .note = fmt::format("never ends: {0:.0f} + 1 = {0:.0f}", x)};
        x = next;
    }
    return {.note = "ends"};
}

/// L13: the textbook's level of a channel, `c += step`, cast to int at the end.
template <typename Scalar> Measured last_level(int from, int to, int steps) {
    const Scalar step = static_cast<Scalar>(to - from) / static_cast<Scalar>(steps);
    auto level = static_cast<Scalar>(from);
    for (int i = 0; i < steps; ++i)
        level += step;
    const int last = static_cast<int>(level);
    return {.wrong = last == to ? 0u : 1u,
            .unit = "level",
            .note = fmt::format("{} becomes {}", level, last)};
}

/// A line AB on a canvas whose pixel (0, 0) is the lowest on the left.
std::string line_in(int width, int height, std::string_view a, std::string_view b) {
    return fmt::format(R"({{
  "canvas": {{"width": {}, "height": {}, "origin": "bottom-left"}},
  "vertices": {{"A": [{}], "B": [{}]}},
  "lines": ["AB"]
}})",
                       width, height, a, b);
}

const std::string l1 = line_in(4, 3, "0, 0", "2, 1");
const std::string l1_reversed = line_in(4, 3, "2, 1", "0, 0");
const std::string l2 = line_in(61, 11, "0, 0", "60, 10");
const std::string l10 = line_in(8, 8, "3, 3", "3, 3");
const std::string l11_vertical = line_in(12, 12, "4, 0", "4, 9");
const std::string l11_leftward = line_in(12, 12, "9, 4", "0, 4");

/// The pixels of one scene, drawn exactly, that another does not have, and the other way round, over
/// the pixels of a line: two methods that are said to be the same.
Measured lines_apart(std::string_view one, const MethodOverrides& by_one, std::string_view other,
                     const MethodOverrides& by_other) {
    const auto a = reference_picture(readable_scene(one, by_one));
    const auto b = reference_picture(readable_scene(other, by_other));
    // Each place where they part leaves a pixel in both pictures.
    return {.wrong = differing(a, b) / 2, .unit = "pixel"};
}

// The middle of the line from (0, 0) to (1, 1000000), where it changes its column.
constexpr std::string_view l3 = R"({
  "canvas": {"width": 8, "height": 16},
  "vertices": {"A": [0, -500000], "B": [1, 500000]},
  "lines": ["AB"]
})";

std::string long_line(Index dx, Index dy) {
    return fmt::format(R"({{
  "canvas": {{"width": 64, "height": 64, "origin": "bottom-left"}},
  "vertices": {{"A": [0, 0], "B": [{}, {}]}},
  "lines": ["AB"],
  "method": {{"line": "dda"}}
}})",
                       dx, dy);
}

constexpr std::string_view l9 = R"({
  "canvas": {"width": 16, "height": 5},
  "vertices": {"A": [-2147483648, 0], "B": [2147483647, 1]},
  "lines": ["AB"]
})";

constexpr std::string_view l12 = R"({
  "canvas": {"width": 17, "height": 14},
  "vertices": {"A": [2, 5], "B": [-4, -3]},
  "lines": ["AB"]
})";

constexpr std::string_view l13 = R"({
  "canvas": {"width": 8, "height": 1, "origin": "bottom-left"},
  "vertices": {"A": [0, 0], "B": [7, 0]},
  "colors": {"A": "#0a0000", "B": "#c80000"},
  "lines": ["AB"]
})";

/// L13: the levels of red from A to B, rounded to the nearest, a half up.
Colors levels_of_l13(const Scene& scene) {
    Colors levels;
    for (int i = 0; i < scene.canvas.width; ++i)
        levels.emplace_back(static_cast<std::uint8_t>((2 * (10 * (7 - i) + 200 * i) + 7) / 14), 0,
                            0);
    return levels;
}

/// The same cut off.
Colors cut_levels_of_l13(const Scene& scene) {
    Colors levels;
    for (int i = 0; i < scene.canvas.width; ++i)
        levels.emplace_back(static_cast<std::uint8_t>((10 * (7 - i) + 200 * i) / 7), 0, 0);
    return levels;
}

/// L1 attacks the claim that two tie rules, or two directions, draw the same line.
void l1_one_tie(StressRows& rows) {
    rows.add_pictures(l1, "bresenham", bresenham, 3);
    rows.add_pictures(l1_reversed, "bresenham, other end", bresenham, 3);
    rows.add_pictures(l1, "bresenham, ties step", bresenham_step, 3);
    rows.add_pictures(l1, "naive, ties away", naive_away, 3);
    rows.add("exact", "naive, away, taken for bresenham",
             lines_apart(l1, bresenham, l1, naive_away), wrong(1));
    rows.add("exact", "bresenham, step, taken for start",
             lines_apart(l1, bresenham, l1, bresenham_step), wrong(1));
    rows.add("exact", "bresenham, step, taken for the other end's",
             lines_apart(l1, bresenham_step, l1_reversed, bresenham), right());
    rows.add("exact", "bresenham taken for its other end",
             lines_apart(l1, bresenham, l1_reversed, bresenham), wrong(1));
}

/// L2 attacks rounded slopes: where every sixth point is a tie, a rounded sum misses some of them.
void l2_many_ties(StressRows& rows) {
    // A slope of 1/6 that is rounded takes its ties with it.
    add_three_methods(rows, l2, 61, {}, {}, {{"float", wrong(2)}, {"double", wrong(8)}});
    rows.add_pictures(l2, "naive, ties away", naive_away, 61);
    rows.add("exact", "naive, away, taken for bresenham",
             lines_apart(l2, bresenham, l2, naive_away), wrong(10));
}

/// L3 attacks the choice of the axis to step along: x changes once in a million rows.
void l3_steep(StressRows& rows) {
    const BresenhamLine line({0, 0}, {1, 1'000'000});
    rows.expect_same("whole numbers", "bresenham", static_cast<std::uint64_t>(line.steps() + 1),
                     1'000'001, "pixel");
    Index y = 0;
    while (line.pixel(y).x == 0)
        ++y;
    rows.expect_same("whole numbers", "bresenham, row of the first x=1",
                     static_cast<std::uint64_t>(y), 500'001, "row");
    add_three_methods(rows, l3, 16, {}, {}, {{"float", wrong(2)}});
    rows.add_pictures(l3, "naive, ties away", naive_away, 16);
}

/// L4 attacks sums of a rounded slope, whose error grows with the square of the length.
void l4_million_additions(StressRows& rows) {
    const LineLoop line{1'000'000, 333'333};
    line.add_to(rows,
                {{"float", wrong(977'568, "1675", "first at x=9422, 497 px")},
                 {"double", wrong(1, "4.2e-6", "first at x=500000")}},
                {{"float", wrong(606, "0.030", "first at x=500003")},
                 {"double", line.within_of_products(double_unit)}});
}

/// L5 attacks the same sums where no pixel is near a tie, so that only large errors show.
void l5_one_third(StressRows& rows) {
    const LineLoop line{65'535, 21'845};
    line.add_to(rows,
                {{"float", wrong(44'543, "6.4", "first at x=9422")},
                 {"double", line.within_of_sums(double_unit)}},
                {{"float", line.within_of_products(float_unit)},
                 {"double", line.within_of_products(double_unit)}});
    add_three_methods(rows, long_line(65'535, 21'845), 64);
}

/// L6 attacks nothing: the line is long, but none of the roundings matter.
void l6_control(StressRows& rows) {
    const LineLoop line{4095, 4094};
    line.add_to(
        rows,
        {{"float", line.within_of_sums(float_unit)}, {"double", line.within_of_sums(double_unit)}},
        {{"float", line.within_of_products(float_unit)},
         {"double", line.within_of_products(double_unit)}});
    add_three_methods(rows, long_line(4095, 4094), 64);
}

/// L7 attacks counters that are floating-point numbers.
void l7_float_counter(StressRows& rows) {
    rows.add("float", "textbook: x += 1", count_up<float>(),
             wrong(1, "", "16777216 + 1 = 16777216"));
    rows.add("double", "textbook: x += 1", count_up<double>(), right("ends"));
    add_three_methods(rows, long_line(16'777'217, 3), 64);
}

/// L8 attacks 32-bit decision variables.
void l8_doubled_dy(StressRows& rows) {
    rows.expect_same(
        "whole numbers", "bresenham, the first d",
        static_cast<std::uint64_t>(BresenhamLine({0, 0}, {1'500'000'000, 1'200'000'000}).d(0)),
        900'000'000, "unit");

    add_three_methods(rows, long_line(1'500'000'000, 1'200'000'000), 64);
}

/// L9 attacks 32-bit differences of coordinates, and ends that float does not have.
void l9_int32_ends(StressRows& rows) {

    // In float the end is 2147483648, the slope 2^-32 and every y 1/2, a tie.
    add_three_methods(rows, l9, 16, {{"float", wrong(2)}}, {{"float", wrong(16)}},
                      {{"float", wrong(16)}});
}

/// L10 attacks the division dy / dx.
void l10_no_length(StressRows& rows) {
    add_three_methods(rows, l10, 1);
}

/// L11 attacks loops that take x to grow.
void l11_vertical_and_leftward(StressRows& rows) {
    add_three_methods(rows, l11_vertical, 10);
    add_three_methods(rows, l11_leftward, 10);
}

/// L12 attacks unsigned coordinates.
void l12_negative_end(StressRows& rows) {
    add_three_methods(rows, l12, 9);
}

/// L13 attacks colors that are summed up, then cast.
void l13_last_color(StressRows& rows) {
    rows.add_pictures(l13, "bresenham, color by axis", bresenham, 8, {}, levels_of_l13);
    rows.add_pictures(l13, "dda, color by axis", dda, 8, {}, levels_of_l13);
    rows.add_pictures(l13, "bresenham, colors cut off",
                      {{"line", "bresenham"}, {"color_rounding", "truncate"}}, 8, {},
                      cut_levels_of_l13);
    rows.add("float", "textbook: c += step, cast", last_level<float>(10, 200, 7),
             wrong(1, "", "becomes 199"));
    rows.add("double", "textbook: c += step, cast", last_level<double>(10, 200, 7),
             wrong(1, "", "199.99999999999997 becomes 199"));
}

constexpr auto lines_catalogue = std::to_array<StressCase>({
    {.id = "L1",
     .title = "one tie",
     .input = "(0,0)-(2,1)",
     .why = "the middle pixel is as near to y=0 as to y=1",
     .holds = "each tie rule has its own line: Bresenham stays, (1,0); naive with half away "
              "from zero, (1,1); Bresenham drawn from the other end, (1,1). That they are "
              "\"equivalent\" is wrong by one pixel.",
     .scenes =
         [] {
             return Scenes{{"from A to B", l1}, {"from B to A", l1_reversed}};
         },
     .run = l1_one_tie},
    {.id = "L2",
     .title = "many ties",
     .input = "(0,0)-(60,10)",
     .why = "the gcd is 10: ten pixels lie halfway between two rows",
     .holds = "61 pixels. Naive with half away from zero and Bresenham differ at the 10 ties, "
              "first (3,1) against (3,0); with the same tie rule they are one line, "
              "unless rounded sums miss the ties (dda).",
     .scenes = [] { return only(l2); },
     .run = l2_many_ties},
    {.id = "L3",
     .title = "slope 1,000,000",
     .input = "(0,0)-(1,1000000), drawn from (0,-500000) to (1,500000)",
     .why = "one step of x in a million of y",
     .holds = "1,000,001 pixels; x becomes 1 at y=500001 (naive, half away: 500000). A loop "
              "over x draws 2 of them.",
     .scenes = [] { return only(l3); },
     .run = l3_steep},
    {.id = "L4",
     .title = "a million additions of a slope",
     .input = "(0,0)-(1000000,333333), rounded to nearest",
     .why = "n additions of a rounded slope to a growing value: error up to n^2 |m| 2^-p",
     .holds = "the error grows as n^2 when accumulated, as n when multiplied; float draws "
              "almost every pixel wrong, double one, a tie.",
     .scenes = [] { return only(long_line(1'000'000, 333'333)); },
     .run = l4_million_additions},
    {.id = "L5",
     .title = "slope one third",
     .input = "(0,0)-(65535,21845)",
     .why = "long, but no pixel comes nearer than 1/6 to a tie",
     .holds = "any method that is off by less than 1/6 pixel draws the one set of pixels; "
              "accumulating in float is not one of them",
     .scenes = [] { return only(long_line(65'535, 21'845)); },
     .run = l5_one_third},
    {.id = "L6",
     .title = "control: long, but not stiff",
     .input = "(0,0)-(4095,4094)",
     .why = "a pixel in 1/8190 of a tie, and sums that may lose 2 px in float; but the roundings "
            "of a slope this near to 1 do not add up",
     .holds = "every pixel right, with every method",
     .scenes = [] { return only(long_line(4095, 4094)); },
     .run = l6_control},
    {.id = "L7",
     .title = "a counter that stops counting",
     .input = "x += 1 up to 16777217",
     .why = "float has no whole numbers between 16777216 and 16777218",
     .holds = "our loops count in whole numbers and end; a textbook's loop on float does not",
     .scenes = [] { return only(long_line(16'777'217, 3)); },
     .run = l7_float_counter},
    {.id = "L8",
     .title = "2 dy beyond 32 bits",
     .input = "(0,0)-(1500000000,1200000000), clipped to the canvas",
     .why = "Bresenham's first d is 2 dy - dx, and 2 dy = 2,400,000,000",
     .holds = "d = 900,000,000 at the start, in 64 bits; time follows the canvas, not the line",
     .scenes = [] { return only(long_line(1'500'000'000, 1'200'000'000)); },
     .run = l8_doubled_dy},
    {.id = "L9",
     .title = "from one end of int32 to the other",
     .input = "(-2147483648,0)-(2147483647,1)",
     .why = "dx = 4,294,967,295 does not fit in 32 bits",
     .holds = "y becomes 1 at x=0, in 64 bits. Float has no 2147483647: its line is another, and "
              "a tie at every pixel.",
     .scenes = [] { return only(l9); },
     .run = l9_int32_ends},
    {.id = "L10",
     .title = "no length",
     .input = "(3,3)-(3,3)",
     .why = "dx = dy = 0: no slope",
     .holds = "one pixel (OpenGL's rule has none)",
     .scenes = [] { return only(l10); },
     .run = l10_no_length},
    {.id = "L11",
     .title = "vertical, and leftward",
     .input = "(4,0)-(4,9); (9,4)-(0,4)",
     .why = "dx = 0, and dx < 0",
     .holds = "10 pixels each; a loop `while (x < x1)` draws none of them",
     .scenes =
         [] {
             return Scenes{{"vertical", l11_vertical}, {"leftward", l11_leftward}};
         },
     .run = l11_vertical_and_leftward},
    {.id = "L12",
     .title = "a negative end",
     .input = "(2,5)-(-4,-3)",
     .why = "a textbook holds coordinates in unsigned fields, where -4 becomes 4294967292",
     .holds = "9 pixels",
     .scenes = [] { return only(l12); },
     .run = l12_negative_end},
    {.id = "L13",
     .title = "the last color of a line",
     .input = "red from 10 to 200 in 7 steps",
     .why = "190/7 added 7 times, then cast: the cast takes what is missing to 200 as a level",
     .holds = "200 at the end; ours are whole numbers, rounded or cut off once",
     .scenes = [] { return only(l13); },
     .run = l13_last_color},
});

} // namespace

std::span<const StressCase> line_cases() {
    return lines_catalogue;
}

} // namespace rastertrace
