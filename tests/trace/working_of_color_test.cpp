// SPDX-License-Identifier: MIT
#include "working_support.h"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// A scene of colored vertices: A black, B red, C blue.
Trace colored(const std::string& vertices, const std::string& rest) {
    return trace_of(scene_in(R"({"canvas": {"width": 8, "height": 8, "origin": "bottom-left"},
"colors": {"A": "#000000", "B": "#ff0000", "C": "#0000ff"}, "vertices": )" +
                             vertices + "," + rest + "}"));
}

/// The first pixel of a line whose color no three channels lead to; 0 if there is none. A line of one pixel
/// mixes nothing.
std::size_t first_unexplained(const Trace& trace) {
    std::vector<std::size_t> pixels;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (trace.kind_of(n) == StepKind::pixel)
            pixels.push_back(n);
    for (const std::size_t n : pixels) {
        const Working lines = working(trace, n);
        for (const std::string channel : {"red", "green", "blue"})
            if (pixels.size() > 1 && trace.step(n).as<PixelStep>().color &&
                std::none_of(lines.begin(), lines.end(), [&](const std::string& line) {
                    return line.starts_with(channel + " = ");
                }))
                return n;
    }
    return 0;
}

/// T2's line of (0, 0) to (5, 2), from level 0 to 255: 51 a step, or 43.2, 105.3, 149.1, 207.7 by the distance
/// (sources.md).
TEST(WorkingOfColor, TheColorsOfALine) {
    const Trace by_distance = example("t2-lines/colors.json");
    EXPECT_THAT(working(by_distance, StepKind::pixel, 1, 0),
                IsSupersetOf(Working{
                    "to the far end sqrt(20), the whole line sqrt(29): 0.830455 of the color of A",
                    "red = 0.830455 (0) + 0.169545 (255) = 43.234026 -> 43"}));
    EXPECT_THAT(working(by_distance, StepKind::pixel, 2, 1),
                Contains(HasSubstr(" = 105.258844 -> 105")));
    EXPECT_THAT(working(by_distance, StepKind::pixel, 3, 1),
                Contains(HasSubstr(" = 149.117013 -> 149")));
    EXPECT_THAT(working(by_distance, StepKind::pixel, 4, 2), Contains(HasSubstr(" = 207.647")));
    const Trace by_steps = trace_of(scene_in(R"({
  "canvas": {"width": 6, "height": 3, "origin": "bottom-left"},
  "vertices": {"A": [0, 0], "B": [5, 2]},
  "colors": {"A": "#000000", "B": "#ff0000"},
  "lines": ["AB"]})"));
    EXPECT_THAT(working(by_steps, StepKind::pixel, 1, 0),
                Contains("red = 0 + 1 (255 - 0) / 5 = 51 -> 51"));
    EXPECT_THAT(working(by_steps, StepKind::pixel, 4, 2),
                Contains("red = 0 + 4 (255 - 0) / 5 = 204 -> 204"));
}

TEST(WorkingOfColor, AColorThatIsCutOff) {
    // T2: halfway from 0 to 255 is 127.
    const Trace cut = trace_of(scene_in(R"({
  "canvas": {"width": 3, "height": 1, "origin": "bottom-left"},
  "vertices": {"A": [0, 0], "B": [2, 0]},
  "colors": {"A": "#000000", "B": "#ff0000"},
  "lines": ["AB"], "method": {"color_rounding": "truncate"}})"));
    EXPECT_THAT(working(cut, StepKind::pixel, 1, 0),
                Contains("red = 0 + 1 (255 - 0) / 2 = 127.5 -> 127"));
}

/// At 45 degrees as typed, and a hair steeper in doubles: the trace says which direction was the longer.
TEST(WorkingOfColor, TheColorsOfALineThatDoublesMakeSteeper) {
    EXPECT_EQ(
        first_unexplained(colored_line(
            "5.6, 11.3", "1.6, 7.3", R"("line": "dda", "from": "low", "color_lerp": "distance")")),
        0u);
}

/// A third of the way from A to each of B and C, all three colors weigh the same.
TEST(WorkingOfColor, TheColorsOfATriangle) {
    const Trace trace = trace_of(scene_in(R"({
  "canvas": {"width": 4, "height": 4, "origin": "bottom-left"},
  "vertices": {"A": [0, 0], "B": [3, 0], "C": [0, 3]},
  "colors": {"A": "#000000", "B": "#ff0000", "C": "#0000f0"},
  "triangles": ["ABC"]})"));
    EXPECT_THAT(
        working(trace, StepKind::pixel, 1, 1),
        IsSupersetOf(Working{"red = 0.333333 (0) + 0.333333 (255) + 0.333333 (0) = 85 -> 85",
                             "blue = 0.333333 (0) + 0.333333 (0) + 0.333333 (240) = 80 -> 80"}));
}

/// C is three times as far away as A and B: half of the way on the screen is a quarter of it in space.
TEST(WorkingOfColor, TheColorsOfATriangleInAPerspective) {
    const Trace ramp = example("tutorial/light/ramp.json");
    EXPECT_THAT(
        working(ramp, StepKind::pixel, 0, 0),
        IsSupersetOf(Working{"weights of A, B, C: 1/4, 1/4, 1/2, divided by z = 1, 1, 3: 1/4, 1/4, "
                             "1/6, together 2/3",
                             "divided by 2/3: 3/8 of A, 3/8 of B, 1/4 of C",
                             "red = 0.375 (0) + 0.375 (0) + 0.25 (255) = 63.75 -> 64"}));
    EXPECT_EQ(first_unexplained(ramp), 0U);
    // On a flat picture nothing is divided, nor where all corners are equally far away.
    Scene affine = scene_in(example_text("tutorial/light/ramp.json"));
    affine.method.shade = Shade::affine;
    const Working flat = working(trace_of(affine), StepKind::pixel, 0, 0);
    EXPECT_THAT(flat, Contains("red = 0.25 (0) + 0.25 (0) + 0.5 (255) = 127.5 -> 128"));
    EXPECT_THAT(flat, Not(Contains(HasSubstr("divided by z"))));
}

/// A corner that clipping makes has a z, too.
TEST(WorkingOfColor, TheColorsOfAClippedTriangleInAPerspective) {
    for (const std::string scalar : {"exact", "double"}) {
        const Trace trace = trace_of(scene_in(R"({
  "canvas": {"width": 12, "height": 12},
  "vertices": {"A": [-1, -1, -1], "B": [3, -1, 4], "C": [0, 2, 3]},
  "colors": {"A": "#ff0000", "B": "#00ff00", "C": "#0000ff"},
  "triangles": ["ABC"], "projection": {"type": "pinhole", "distance": 1},
  "viewport": {"pixels_per_unit": 5}, "method": {"depth": "inverse-z", "scalar": ")" +
                                              scalar + R"("}})"));
        const std::size_t pixel =
            step_of(trace, [](const StepView& step) { return step.kind() == StepKind::pixel; });
        EXPECT_THAT(working(trace, pixel), Contains(HasSubstr(", divided by z = 0.001, 4, 3: ")))
            << scalar;
        EXPECT_EQ(first_unexplained(trace), 0U) << scalar;
    }
}

/// T2's line of 5 steps, 51 a step, as the side of an outline: AB from black to red, CA from blue to black.
TEST(WorkingOfColor, TheColorsOfAnOutline) {
    const std::string vertices = R"({"A": [0, 0], "B": [5, 2], "C": [0, 2]})";
    const Trace trace = colored(vertices, R"("outlines": ["ABC"])");
    EXPECT_THAT(working(trace, StepKind::pixel, 1, 0),
                Contains("red = 0 + 1 (255 - 0) / 5 = 51 -> 51"));
    EXPECT_THAT(working(trace, StepKind::pixel, 0, 1),
                Contains("blue = 255 + 1 (0 - 255) / 2 = 127.5 -> 128"));
    const Trace low = colored(vertices, R"("outlines": ["ABC"], "method": {"from": "low"})");
    EXPECT_THAT(working(low, StepKind::pixel, 0, 1),
                Contains("blue = 0 + 1 (255 - 0) / 2 = 127.5 -> 128"));
    // By the distance: sources.md.
    const Trace by_distance =
        colored(vertices, R"("outlines": ["ABC"], "method": {"color_lerp": "distance"})");
    EXPECT_THAT(working(by_distance, StepKind::pixel, 2, 1),
                Contains(HasSubstr(" = 105.258844 -> 105")));
}

/// From AB's pixel (1, 0), a quarter of the way from black to red, up to the blue C.
TEST(WorkingOfColor, TheColorsOfAFan) {
    const Trace trace = colored(R"({"A": [0, 0], "B": [4, 0], "C": [1, 2]})",
                                R"("triangles": ["ABC"], "method": {"fill": "fan"})");
    const Working start{"on AB at (1, 0): red = 0 + 1 (255 - 0) / 4 = 63.75 -> 64"};
    EXPECT_EQ(working(trace, StepKind::ray, 1, 0), start);
    const Working pixel = working(trace, step_of(trace, [&](const StepView& step) {
                                      return step.kind() == StepKind::pixel && x_in(step) == 1 &&
                                             y_in(step) == 1 &&
                                             step.as<PixelStep>().color.text() == "#200080";
                                  }));
    EXPECT_THAT(pixel, IsSupersetOf(Working{start.front(), "red = 64 + 1 (0 - 64) / 2 = 32 -> 32",
                                            "blue = 0 + 1 (255 - 0) / 2 = 127.5 -> 128"}));
}

/// Of 255 to 127 in four steps the first is 223; a pixel is replaced, whatever its alpha.
TEST(WorkingOfColor, Alpha) {
    const Trace trace = trace_of(scene_in(R"({
  "canvas": {"width": 5, "height": 1, "origin": "bottom-left"},
  "vertices": {"A": [0, 0], "B": [4, 0], "C": [1, 0], "D": [1, 0]},
  "colors": {"A": "#000000ff", "B": "#0000007f"}, "lines": ["CD", "AB"]})"));
    const std::size_t over = step_of(trace, [&](const StepView& step) {
        return step.kind() == StepKind::pixel && step.as<PixelStep>().color.text() == "#000000df";
    });
    EXPECT_THAT(working(trace, over),
                IsSupersetOf(Working{"alpha = 255 + 1 (127 - 255) / 4 = 223 -> 223",
                                     "alpha = 223 is stored: nothing of step 2 is mixed in"}));
    const Trace triangle = trace_of(scene_in(R"({
  "canvas": {"width": 4, "height": 4, "origin": "bottom-left"},
  "vertices": {"A": [0, 0], "B": [3, 0], "C": [0, 3]},
  "colors": {"A": "#00000080", "B": "#0000007f", "C": "#000000ff"}, "triangles": ["ABC"]})"));
    EXPECT_THAT(working(triangle, StepKind::pixel, 1, 1),
                Contains("alpha = 0.333333 (128) + 0.333333 (127) + 0.333333 (255) = 170 -> 170"));
}

/// Colors are mixed between the pixels of the ends, from the one that is drawn first: so it is explained for
/// every pixel of a line, with whatever ends and from whichever.
RC_GTEST_PROP(WorkingOfColor, TheColorsOfALineAreAlwaysExplained, ()) {
    const auto point = [] {
        const int x = *rc::gen::inRange(0, 300);
        const int y = *rc::gen::inRange(0, 300);
        return fmt::format("{}.{}, {}.{}", x / 10, x % 10, y / 10, y % 10);
    };
    const std::string a = point();
    const std::string b = point();
    const auto line = *rc::gen::element<std::string>("bresenham", "naive", "dda");
    const auto from = *rc::gen::element<std::string>("first", "low");
    const auto lerp = *rc::gen::element<std::string>("axis", "distance");
    RC_ASSERT(first_unexplained(
                  colored_line(a, b,
                               fmt::format(R"("line": "{}", "from": "{}", "color_lerp": "{}")",
                                           line, from, lerp))) == 0u);
}

} // namespace
} // namespace rastertrace
