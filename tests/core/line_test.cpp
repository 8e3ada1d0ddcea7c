// SPDX-License-Identifier: MIT
#include "picture.h"
#include "random_choice.h"
#include "random_triangle.h"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using Points = std::vector<std::pair<int, int>>;

/// What a line reported.
struct LineRecorder {
    Points pixels;
    std::vector<Color> colors;
    std::vector<std::int64_t> decisions;
    std::vector<Move> moves;
    std::vector<PixelsRejected<>> rejected;
    int octant = 0;
    std::size_t steps = 0;

    template <typename Step> void operator()(const Step& step) {
        ++steps;
        if constexpr (std::same_as<Step, PixelPlotted<>>) {
            pixels.emplace_back(step.x, step.y);
            colors.push_back(step.color);
        } else if constexpr (std::same_as<Step, LineDecided<>>) {
            decisions.push_back(step.d);
            moves.push_back(step.move);
        } else if constexpr (std::same_as<Step, PixelsRejected<>>) {
            rejected.push_back(step);
        } else if constexpr (requires {
                                 step.octant;
                                 step.kind;
                             }) {
            octant = static_cast<int>(step.octant.value_or(0));
        }
    }
};

Scene line_scene(const std::vector<std::string>& ends, Method method = {},
                 Canvas canvas = {.width = 41, .height = 41}) {
    Scene scene;
    scene.canvas = canvas;
    scene.method = method;
    scene.vertices = {{"A", number(ends[0]), number(ends[1])},
                      {"B", number(ends[2]), number(ends[3])}};
    scene.primitives = {{.kind = PrimitiveKind::line, .name = "AB", .vertices = {0, 1}}};
    return scene;
}

LineRecorder line(const Scene& scene) {
    LineRecorder recorder;
    draw_as_planned(scene, recorder);
    return recorder;
}

Scene line_scene(int x0, int y0, int x1, int y1, Method method = {},
                 Canvas canvas = {.width = 41, .height = 41}) {
    return line_scene(
        {std::to_string(x0), std::to_string(y0), std::to_string(x1), std::to_string(y1)}, method,
        canvas);
}

LineRecorder line(int x0, int y0, int x1, int y1, Method method = {},
                  Canvas canvas = {.width = 41, .height = 41}) {
    return line(line_scene(x0, y0, x1, y1, method, canvas));
}

// ---- The report's tables (sources.md, T2) -----------------------------------------------------

TEST(Bresenham, HasThePixelsAndDecisionsOfTheTables) {
    const LineRecorder two = line(0, 0, 5, 2);
    EXPECT_EQ(two.pixels, (Points{{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}}));
    EXPECT_EQ(two.decisions, (std::vector<std::int64_t>{-1, 3, -3, 1, -5}));
    EXPECT_EQ(two.moves, (std::vector{Move::e, Move::ne, Move::e, Move::ne, Move::e}));

    const LineRecorder three = line(0, 0, 5, 3);
    EXPECT_EQ(three.pixels, (Points{{0, 0}, {1, 1}, {2, 1}, {3, 2}, {4, 2}, {5, 3}}));
    EXPECT_EQ(three.decisions, (std::vector<std::int64_t>{1, -3, 3, -1, 5}));

    const LineRecorder ab = line(2, 5, -4, -3);
    EXPECT_EQ(
        ab.pixels,
        (Points{{2, 5}, {1, 4}, {1, 3}, {0, 2}, {-1, 1}, {-2, 0}, {-2, -1}, {-3, -2}, {-4, -3}}));
    EXPECT_EQ(ab.decisions, (std::vector<std::int64_t>{4, 0, 12, 8, 4, 0, 12, 8}));

    const LineRecorder ba = line(-4, -3, 2, 5);
    EXPECT_EQ(
        ba.pixels,
        (Points{{-4, -3}, {-3, -2}, {-3, -1}, {-2, 0}, {-1, 1}, {0, 2}, {0, 3}, {1, 4}, {2, 5}}));
    EXPECT_EQ(ba.decisions, ab.decisions);

    const LineRecorder ac = line(2, 5, 5, -3);
    EXPECT_EQ(ac.pixels,
              (Points{{2, 5}, {2, 4}, {3, 3}, {3, 2}, {3, 1}, {4, 0}, {4, -1}, {5, -2}, {5, -3}}));
    EXPECT_EQ(ac.decisions, (std::vector<std::int64_t>{-2, 4, -6, 0, 6, -4, 2, -8}));

    const LineRecorder ten = line(0, 0, 10, 3);
    std::vector<int> rows;
    for (const auto& [x, y] : ten.pixels)
        rows.push_back(y);
    EXPECT_EQ(rows, (std::vector{0, 0, 1, 1, 1, 1, 2, 2, 2, 3, 3}));
    EXPECT_EQ(std::vector(ten.decisions.begin(), ten.decisions.begin() + 4),
              (std::vector<std::int64_t>{-4, 2, -12, -6}));
}

/// Lines by their letters, drawn in this order.
Scene lettered_lines(const std::vector<std::pair<char, std::array<int, 4>>>& lines, Canvas canvas) {
    Scene scene;
    scene.canvas = canvas;
    for (const auto& [letter, ends] : lines) {
        const std::size_t first = scene.vertices.size();
        scene.vertices.push_back({"", ends[0], ends[1]});
        scene.vertices.push_back({"", ends[2], ends[3]});
        scene.primitives.push_back(
            {.kind = PrimitiveKind::line, .name = {letter}, .vertices = {first, first + 1}});
    }
    return scene;
}

TEST(Bresenham, NamesTheOctantsOfTheReport) {
    const std::vector<std::pair<char, std::array<int, 4>>> star{
        {'1', {0, 0, 5, 2}},   {'2', {0, 0, 2, 5}},   {'3', {0, 0, -2, 5}}, {'4', {0, 0, -5, 2}},
        {'5', {0, 0, -5, -2}}, {'6', {0, 0, -2, -5}}, {'7', {0, 0, 2, -5}}, {'8', {0, 0, 5, -2}}};
    for (const auto& [octant, ends] : star)
        EXPECT_EQ(line(0, 0, ends[2], ends[3]).octant, octant - '0');
    EXPECT_EQ(plots_in(lettered_lines(star, {.width = 11, .height = 11})).owners, "...3...2...\n"
                                                                                  "...3...2...\n"
                                                                                  "....3.2....\n"
                                                                                  "44..3.2..11\n"
                                                                                  "..44.3.11..\n"
                                                                                  "....588....\n"
                                                                                  "..55.7.88..\n"
                                                                                  "55..6.7..88\n"
                                                                                  "....6.7....\n"
                                                                                  "...6...7...\n"
                                                                                  "...6...7...\n");
    EXPECT_EQ(line(0, 0, 3, 3).octant, 1) << "the diagonal is x-major";
    EXPECT_EQ(line(0, 0, -3, 3).octant, 4);
}

TEST(Bresenham, DiffersFromItsReverseAtTies) {
    EXPECT_EQ(line(0, 0, 2, 1).pixels, (Points{{0, 0}, {1, 0}, {2, 1}}));
    EXPECT_EQ(line(2, 1, 0, 0).pixels, (Points{{2, 1}, {1, 1}, {0, 0}}));

    int differ = 0, all = 0;
    for (int dx = 1; dx <= 64; ++dx)
        for (int dy = 0; dy <= dx; ++dy) {
            const Canvas canvas{.width = 65, .height = 65, .origin = Origin::bottom_left};
            Points there = line(0, 0, dx, dy, {}, canvas).pixels;
            const Points back = line(dx, dy, 0, 0, {}, canvas).pixels;
            std::reverse(there.begin(), there.end());
            ++all;
            differ += there != back ? 1 : 0;
        }
    EXPECT_EQ(all, 2144);
    EXPECT_EQ(differ, 714);
}

TEST(Bresenham, SpecialLines) {
    EXPECT_EQ(line(3, 3, 3, 3).pixels, (Points{{3, 3}}));
    // T2's errors: steep, to the left, vertical and horizontal. Where they meet the later one is seen.
    EXPECT_EQ(plots_in(lettered_lines({{'s', {0, 0, 3, 8}},
                                       {'l', {8, 3, 0, 0}},
                                       {'v', {4, 0, 4, 9}},
                                       {'h', {9, 4, 0, 4}}},
                                      {.width = 10, .height = 10, .origin = Origin::bottom_left}))
                  .owners,
              "....v.....\n"
              "...sv.....\n"
              "...sv.....\n"
              "..s.v.....\n"
              "..s.v.....\n"
              "hhhhhhhhhh\n"
              ".s..v..ll.\n"
              ".s..vll...\n"
              "s.llv.....\n"
              "ll..v.....\n");
    EXPECT_EQ(line(2, 1, 0, 0, {.from = LineStart::low}).pixels, line(0, 0, 2, 1).pixels);
    EXPECT_EQ(line(2, 9, 1, 0, {.from = LineStart::low}).pixels, line(1, 0, 2, 9).pixels);
}

TEST(Bresenham, EndsBetweenPixelsGoToTheNearestOnes) {
    EXPECT_EQ(line(line_scene({"1/2", "-1/2", "4.4", "2.4"})).pixels, line(1, 0, 4, 2).pixels)
        << "a half goes up";
}

TEST(Bresenham, StaysWithinHalfAPixelAndIsConnected) {
    for (int dx = -20; dx <= 20; dx += 3)
        for (int dy = -20; dy <= 20; ++dy) {
            const Points pixels = line(0, 0, dx, dy).pixels;
            const int major = std::max(std::abs(dx), std::abs(dy));
            ASSERT_EQ(pixels.size(), static_cast<std::size_t>(major) + 1);
            EXPECT_EQ(pixels.back(), std::pair(dx, dy));
            for (std::size_t i = 0; i < pixels.size(); ++i) {
                // The distance across, times 2 major: at most major.
                const auto [x, y] = pixels[i];
                const int off = std::abs(dx) >= std::abs(dy) ? y * std::abs(dx) - std::abs(x) * dy
                                                             : x * std::abs(dy) - std::abs(y) * dx;
                EXPECT_LE(2 * std::abs(off), major);
                if (i > 0) {
                    EXPECT_LE(std::abs(x - pixels[i - 1].first), 1);
                    EXPECT_LE(std::abs(y - pixels[i - 1].second), 1);
                }
            }
        }
}

// ---- Stiff and extreme (numerics.md, L) -------------------------------------------------------

TEST(StiffLine, SlopeOfAMillion) {
    // L3: x becomes 1 at y = 500001 by Bresenham, at 500000 by the naive line that rounds up.
    const Canvas canvas{.width = 2, .height = 16'000, .origin = Origin::bottom_left};
    const auto column_at = [&canvas](LineMethod method, int y) {
        // The part of the line around row y, moved onto the canvas.
        const Scene scene =
            line_scene({"0", std::to_string(8000 - y), "1", std::to_string(8000 - y + 1'000'000)},
                       {.line = method, .ties = Ties::up}, canvas);
        for (const auto& [x, row] : line(scene).pixels)
            if (row == 8000)
                return x;
        return -1;
    };
    EXPECT_EQ(column_at(LineMethod::bresenham, 500'000), 0);
    EXPECT_EQ(column_at(LineMethod::bresenham, 500'001), 1);
    EXPECT_EQ(column_at(LineMethod::naive, 499'999), 0);
    EXPECT_EQ(column_at(LineMethod::naive, 500'000), 1);
}

TEST(ExtremeLine, CostFollowsTheCanvas) {
    // L8: d0 = 900,000,000, beyond 32 bits on the way; L9: dx = 4,294,967,295.
    const LineRecorder far =
        line(line_scene({"0", "0", "1500000000", "1200000000"}, {}, {.width = 64, .height = 64}));
    EXPECT_EQ(far.decisions.front(), 900'000'000);
    EXPECT_EQ(far.pixels.size(), 32u);
    EXPECT_LE(far.steps, 70u);
    ASSERT_EQ(far.rejected.size(), 1u);
    EXPECT_EQ(far.rejected[0].to_x, 1'500'000'000);

    const LineRecorder wide =
        line(line_scene({"-2147483648", "0", "2147483647", "1"}, {}, {.width = 64, .height = 64}));
    EXPECT_EQ(wide.pixels.size(), 64u);
    EXPECT_EQ(wide.rejected.size(), 2u);

    for (const LineMethod method : {LineMethod::naive, LineMethod::dda, LineMethod::bresenham})
        for (const ScalarKind scalar : {ScalarKind::exact, ScalarKind::double_precision}) {
            const LineRecorder missed =
                line(line_scene({"-1e9", "1e9", "1e9", "2e9"}, {.scalar = scalar, .line = method}));
            EXPECT_TRUE(missed.pixels.empty());
            EXPECT_LE(missed.steps, 90u);
        }
}

RC_GTEST_PROP(Bresenham, OnASmallCanvasIsACutOfTheWholeLine, ()) {
    const auto coordinate = [] { return *rc::gen::inRange(-40, 41); };
    const int x0 = coordinate(), y0 = coordinate(), x1 = coordinate(), y1 = coordinate();
    const Method method{
        .scalar = ScalarKind::exact,
        .line = *rc::gen::element(LineMethod::naive, LineMethod::dda, LineMethod::bresenham)};
    const Points whole = line(x0, y0, x1, y1, method, {.width = 101, .height = 101}).pixels;
    const Canvas small{.width = *rc::gen::inRange(1, 30), .height = *rc::gen::inRange(1, 30)};
    Points expected;
    std::copy_if(whole.begin(), whole.end(), std::back_inserter(expected),
                 [&small](const auto& pixel) { return small.contains(pixel.first, pixel.second); });
    const Scene scene = line_scene(x0, y0, x1, y1, method, small);
    log_scene(scene);
    const LineRecorder cut = line(scene);
    RC_ASSERT(cut.pixels == expected);
    for (const PixelsRejected<>& run : cut.rejected) {
        RC_ASSERT(!small.contains(*run.x, *run.y));
        RC_ASSERT(!small.contains(run.to_x.value_or(*run.x), run.to_y.value_or(*run.y)));
    }
}

// ---- Naive and DDA ------------------------------------------------------------------------------

RC_GTEST_PROP(NaiveAndDda, AreBresenhamWithItsTies, ()) {
    // In exact arithmetic, between whole ends, ties to the start's side: the same pixels.
    const auto coordinate = [] { return *rc::gen::inRange(-20, 21); };
    const int x0 = coordinate(), y0 = coordinate(), x1 = coordinate(), y1 = coordinate();
    const auto from = *rc::gen::element(LineStart::first, LineStart::low);
    const Points expected = line(x0, y0, x1, y1, {.from = from}).pixels;
    for (const LineMethod method : {LineMethod::naive, LineMethod::dda}) {
        const Scene scene = line_scene(
            x0, y0, x1, y1,
            {.scalar = ScalarKind::exact, .line = method, .from = from, .ties = Ties::start});
        log_scene(scene);
        RC_ASSERT(line(scene).pixels == expected);
    }
}

TEST(NaiveAndDda, SendTiesWhereTiesSays) {
    // L1 and L2.
    const auto middle = [](Ties ties, bool reversed) {
        const Method method{.scalar = ScalarKind::exact, .line = LineMethod::naive, .ties = ties};
        return (reversed ? line(2, 1, 0, 0, method) : line(0, 0, 2, 1, method)).pixels[1].second;
    };
    // Where nothing is said, a half goes up from both ends.
    const Method naive_line{.scalar = ScalarKind::exact, .line = LineMethod::naive};
    EXPECT_EQ(line(0, 0, 2, 1, naive_line).pixels[1].second, 1);
    EXPECT_EQ(line(2, 1, 0, 0, naive_line).pixels[1].second, 1);
    EXPECT_EQ(line(0, -1, 2, -2, naive_line).pixels[1].second, -1);
    EXPECT_EQ(middle(Ties::start, false), 0);
    EXPECT_EQ(middle(Ties::start, true), 1);
    EXPECT_EQ(middle(Ties::up, false), 1);
    EXPECT_EQ(middle(Ties::away, false), 1);
    EXPECT_EQ(middle(Ties::even, false), 0);

    const Canvas canvas{.width = 61, .height = 11, .origin = Origin::bottom_left};
    const Points bresenham = line(0, 0, 60, 10, {}, canvas).pixels;
    const Points naive =
        line(0, 0, 60, 10,
             {.scalar = ScalarKind::exact, .line = LineMethod::naive, .ties = Ties::up}, canvas)
            .pixels;
    int differ = 0;
    for (std::size_t i = 0; i < 61; ++i)
        differ += bresenham[i] != naive[i] ? 1 : 0;
    EXPECT_EQ(differ, 10) << "at gcd(60, 10) ties";
    EXPECT_EQ(bresenham[3], std::pair(3, 0));
    EXPECT_EQ(naive[3], std::pair(3, 1));
}

TEST(NaiveAndDda, RoundAsToldAndTakeEndsBetweenPixels) {
    const auto rows = [](Rounding rounding) {
        std::vector<int> result;
        const Method method{
            .scalar = ScalarKind::exact, .line = LineMethod::dda, .rounding = rounding};
        // y = x/2 - 1/4 from x = 0 (nearest to 1/4) to 5 (nearest to 19/4)
        for (const auto& [x, y] : line(line_scene({"1/4", "-1/8", "19/4", "17/8"}, method)).pixels)
            result.push_back(y);
        return result;
    };
    EXPECT_EQ(rows(Rounding::floor), (std::vector{-1, 0, 0, 1, 1, 2}));
    EXPECT_EQ(rows(Rounding::truncate), (std::vector{0, 0, 0, 1, 1, 2}));
    EXPECT_EQ(rows(Rounding::nearest), (std::vector{0, 0, 1, 1, 2, 2}));
}

// ---- Ties and ends

TEST(LineTies, StepGoesWhereTheLineFromTheOtherEndStays) {
    // (0,0)-(2,1): d = 0 at once. T2's way stays in row 0, half of the drawing libraries go to row 1.
    EXPECT_EQ(line(0, 0, 2, 1).pixels, (Points{{0, 0}, {1, 0}, {2, 1}}));
    EXPECT_EQ(line(0, 0, 2, 1, {.ties = Ties::step}).pixels, (Points{{0, 0}, {1, 1}, {2, 1}}));
    for (const LineMethod method : {LineMethod::bresenham, LineMethod::naive, LineMethod::dda})
        for (int dx = -12; dx <= 12; ++dx)
            for (int dy = -12; dy <= 12; ++dy) {
                const ScalarKind scalar = ScalarKind::exact;
                const Points steps =
                    line(0, 0, dx, dy, {.scalar = scalar, .line = method, .ties = Ties::step})
                        .pixels;
                Points stays =
                    line(dx, dy, 0, 0, {.scalar = scalar, .line = method, .ties = Ties::start})
                        .pixels;
                std::reverse(stays.begin(), stays.end());
                ASSERT_EQ(steps, stays) << dx << ", " << dy;
            }
}

TEST(LineTies, StepIsTheSameOnACanvasThatHasOnlyAPart) {
    // What lies off the canvas is not walked: the decisions on it are those of the whole line.
    const Method method{.ties = Ties::step};
    for (int dx = 1; dx <= 40; ++dx)
        for (int dy = 0; dy <= dx; ++dy) {
            const LineRecorder whole = line(-15, -9, -15 + dx, -9 + dy, method);
            const LineRecorder part =
                line(-15, -9, -15 + dx, -9 + dy, method, {.width = 13, .height = 9});
            Points expected;
            for (const auto& [x, y] : whole.pixels)
                if (Canvas{.width = 13, .height = 9}.contains(x, y))
                    expected.emplace_back(x, y);
            ASSERT_EQ(part.pixels, expected) << dx << ", " << dy;
        }
}

TEST(LineEndPixels, WithoutTheLastOneEveryPixelOfAnOutlineIsDrawnOnce) {
    // 28 plots on 25 pixels, the vertices twice (sources.md, T2): so 25 plots, and the same picture.
    for (const LineMethod method : {LineMethod::bresenham, LineMethod::naive, LineMethod::dda}) {
        Scene scene = small_first_triangle({.scalar = ScalarKind::exact, .line = method});
        scene.primitives[0].kind = PrimitiveKind::outline;
        const std::string whole = picture_of(draw_as_planned(scene));
        EXPECT_EQ(line(scene).pixels.size(), 28u);
        scene.method.ends = EndPixels::first;
        EXPECT_EQ(line(scene).pixels.size(), 25u);
        EXPECT_EQ(picture_of(draw_as_planned(scene)), whole);
    }
}

TEST(LineEndPixels, TheLastOneOfTheDrawnOrderIsLeftOut) {
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        const std::vector<std::string> ends{std::to_string(random.whole(-60, 60)) + "/3",
                                            std::to_string(random.whole(-60, 60)) + "/3",
                                            std::to_string(random.whole(-60, 60)) + "/3",
                                            std::to_string(random.whole(-60, 60)) + "/3"};
        Method method{.scalar = ScalarKind::exact,
                      .line =
                          random.pick({LineMethod::bresenham, LineMethod::naive, LineMethod::dda}),
                      .from = random.pick({LineStart::first, LineStart::low})};
        Points all = line(line_scene(ends, method)).pixels;
        method.ends = EndPixels::first;
        all.pop_back();
        ASSERT_EQ(line(line_scene(ends, method)).pixels, all);
    }
    // Of one pixel, nothing is left; that is told.
    Scene scene = line_scene(3, 4, 3, 4, {.ends = EndPixels::first});
    std::optional<SkipReason> why;
    EXPECT_EQ(
        draw_as_planned(scene, [&](const PrimitiveSkipped<>& step) { why = step.why; }).drawn(),
        0u);
    EXPECT_EQ(why, SkipReason::last_pixel_only);
}

TEST(LineStart, ItIsTheLowEndOfTheTrueLine) {
    // A (1/2, 23/5) and B (0, 11/2): |dy| = 9/10 is longer than |dx| = 1/2, so A is the low end, though both
    // nearest pixels, (1, 5) and (0, 6), are one column and one row apart.
    for (const LineMethod method : {LineMethod::naive, LineMethod::dda}) {
        const Method rules{.scalar = ScalarKind::exact,
                           .line = method,
                           .from = LineStart::low,
                           .ends = EndPixels::first};
        for (const auto& ends : {std::vector<std::string>{"1/2", "23/5", "0", "11/2"},
                                 std::vector<std::string>{"0", "11/2", "1/2", "23/5"}})
            EXPECT_EQ(line(line_scene(ends, rules)).pixels, (Points{{0, 5}}));
    }
}

TEST(LineStart, WhicheverEndIsTypedFirstTheLineIsTheSame) {
    Random random(7);
    for (int i = 0; i < 500; ++i) {
        const auto coordinate = [&random] {
            return std::to_string(random.whole(-40, 40)) + random.pick<const char*>({"/2", "/5"});
        };
        const std::string ax = coordinate(), ay = coordinate(), bx = coordinate(),
                          by = coordinate();
        const Method method{
            .scalar = random.pick({ScalarKind::exact, ScalarKind::adaptive}),
            .line = random.pick({LineMethod::bresenham, LineMethod::naive, LineMethod::dda}),
            .from = LineStart::low,
            .ends = random.pick({EndPixels::both, EndPixels::first})};
        const LineRecorder there = line(line_scene({ax, ay, bx, by}, method));
        const LineRecorder back = line(line_scene({bx, by, ax, ay}, method));
        ASSERT_EQ(there.pixels, back.pixels) << ax << ' ' << ay << ' ' << bx << ' ' << by;
        ASSERT_EQ(there.octant, back.octant) << "the octant is that of the line as it is drawn";
    }
    EXPECT_EQ(line(line_scene({"8", "3", "0", "0"}, {.from = LineStart::low})).octant, 1);
}

// ---- Colors and points
// ----------------------------------------------------------------------------

Scene colored_line(ColorLerp lerp) {
    Scene scene = line_scene({"0", "0", "5", "2"}, {.color_lerp = lerp});
    scene.vertices[0].color = Color{0, 0, 0};
    scene.vertices[1].color = Color{255, 128, 0};
    return scene;
}

TEST(LineColors, ByStepAndByDistance) {
    const auto reds = [](ColorLerp lerp) {
        std::vector<int> result;
        for (const Color& color : line(colored_line(lerp)).colors)
            result.push_back(color.red());
        return result;
    };
    EXPECT_EQ(reds(ColorLerp::axis), (std::vector{0, 51, 102, 153, 204, 255}));
    // 0, 43.2, 105.3, 149.1, 207.7, 255 rounded
    EXPECT_EQ(reds(ColorLerp::distance), (std::vector{0, 43, 105, 149, 208, 255}));
}

TEST(LineColors, AreCutOffWhereTheTextCutsThem) {
    // T2: the middle of 0 to 255 is 127, and every level is the whole part of the exact one.
    const Canvas canvas{.width = 512, .height = 1, .origin = Origin::top_left};
    for (int length = 1; length <= 511; ++length) {
        Scene scene = line_scene({"0", "0", std::to_string(length), "0"},
                                 {.color_rounding = ColorRounding::truncate}, canvas);
        scene.vertices[0].color = Color{0, 255, 10};
        scene.vertices[1].color = Color{255, 0, 10};
        const LineRecorder recorder = line(scene);
        for (int step = 0; step <= length; ++step) {
            const Color color = recorder.colors[static_cast<std::size_t>(step)];
            ASSERT_EQ(color.red(), 255 * step / length);
            ASSERT_EQ(color.green(), 255 * (length - step) / length);
            ASSERT_EQ(color.blue(), 10);
        }
    }
}

TEST(LineColors, AChannelThatIsTheSameAtBothEndsIsNotCut) {
    for (int length = 1; length <= 60; ++length)
        for (const int level : {1, 64, 77, 255}) {
            Scene scene = line_scene(
                {"0", "0", std::to_string(length), std::to_string(length / 3)},
                {.color_lerp = ColorLerp::distance, .color_rounding = ColorRounding::truncate},
                {.width = 64, .height = 64, .origin = Origin::top_left});
            const auto same = static_cast<std::uint8_t>(level);
            scene.vertices[0].color = Color{0, same, 9};
            scene.vertices[1].color = Color{255, same, 3};
            for (const Color& color : line(scene).colors)
                ASSERT_EQ(color.green(), same);
        }
}

TEST(LineColors, EndsHaveExactlyTheirColors) {
    // The text's sums end on 254 for 229 of 511 lengths; ours never do.
    for (int length = 1; length <= 511; ++length) {
        Scene scene = line_scene({"0", "0", std::to_string(length), "0"}, {},
                                 {.width = 512, .height = 1, .origin = Origin::top_left});
        scene.vertices[0].color = Color{0, 255, 10};
        scene.vertices[1].color = Color{255, 0, 200};
        for (const ColorLerp lerp : {ColorLerp::axis, ColorLerp::distance}) {
            scene.method.color_lerp = lerp;
            const LineRecorder recorder = line(scene);
            ASSERT_EQ(recorder.colors.front(), (Color{0, 255, 10}));
            ASSERT_EQ(recorder.colors.back(), (Color{255, 0, 200}));
        }
    }
}

TEST(Points, FillACanvasOnePixelAtATime) {
    // The report's first exercise: 512 x 512, y down, all red; pixel (0,1) is the 512th.
    Scene scene;
    scene.canvas = {.width = 512, .height = 512, .origin = Origin::top_left};
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) {
            scene.primitives.push_back({.kind = PrimitiveKind::point,
                                        .name = {},
                                        .vertices = {scene.vertices.size()},
                                        .color = Color{255, 0, 0}});
            scene.vertices.push_back({"", x, y});
        }
    const Image image = draw_as_planned(scene);
    EXPECT_EQ(image.drawn(), 262'144u);
    EXPECT_EQ(std::count(image.colors().begin(), image.colors().end(), Color(255, 0, 0)), 262'144);
    EXPECT_EQ(scene.canvas.offset_of({1, 0}) * 4, 4u);
    EXPECT_EQ(scene.canvas.offset_of({0, 1}) * 4, 2048u);
    EXPECT_EQ(scene.canvas.offset_of({511, 511}) * 4, 1'048'572u);
}

TEST(Points, OffTheCanvasAreRejected) {
    // The report tests x > W; x = W lands on the next row.
    for (const auto& [x, y] : Points{{512, 0}, {0, 512}, {-1, 0}, {0, -1}}) {
        Scene scene;
        scene.canvas = {.width = 512, .height = 512, .origin = Origin::top_left};
        scene.vertices = {{"A", x, y}};
        scene.primitives = {{.kind = PrimitiveKind::point, .name = "A", .vertices = {0}}};
        LineRecorder recorder;
        EXPECT_EQ(draw_as_planned(scene, recorder).drawn(), 0u);
        EXPECT_EQ(recorder.rejected.size(), 1u);
    }
}

TEST(Outline, OfTheFirstTriangleHas28PlotsOn25Pixels) {
    // Left, how often the outline plots each pixel: its vertices twice. Right, with the fill drawn over
    // it: four of its pixels lie outside.
    Scene scene = small_first_triangle();
    scene.primitives[0].name = "outline";
    scene.primitives[0].kind = PrimitiveKind::outline;
    Scene filled = scene;
    filled.primitives.push_back(small_first_triangle().primitives[0]);
    filled.primitives[1].name = "fill";
    EXPECT_EQ(side_by_side({plots_in(scene).counts, plots_in(filled).owners}),
              ".......2...  .......f...\n"
              "......11...  ......ff...\n"
              "......1.1..  .....fffo..\n"
              ".....1..1..  ....fffff..\n"
              "....1....1.  ....fffffo.\n"
              "...1.....1.  ...ffffffo.\n"
              "...1.....1.  ..ffffffff.\n"
              "..1.......1  .fffffffffo\n"
              ".2111111112  .ffffffffff\n"
              "...........  ...........\n");
}

} // namespace
} // namespace rastertrace
