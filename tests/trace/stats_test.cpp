// SPDX-License-Identifier: MIT
#include "picture.h"
#include "random_scene.h"
#include "random_triangle.h"
#include "trace/stats_of_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The scene's first triangle, its vertices in another order.
Scene in_order(Scene scene, const std::array<std::size_t, 3>& order) {
    scene.primitives[0].vertices = order;
    return scene;
}

/// Points x, y, x, y, ..., named A, B, C, ..., and triangles of them.
Scene mesh(const std::vector<int>& coordinates,
           const std::vector<std::array<std::size_t, 3>>& triangles, Canvas canvas,
           const Method& method) {
    Scene scene;
    scene.canvas = canvas;
    scene.method = method;
    for (std::size_t i = 0; 2 * i < coordinates.size(); ++i)
        scene.vertices.push_back({std::string(1, static_cast<char>('A' + i)), coordinates[2 * i],
                                  coordinates[2 * i + 1]});
    for (const auto& corners : triangles) {
        std::string name;
        for (const std::size_t corner : corners)
            name += scene.vertices[corner].name;
        scene.primitives.push_back(
            {.kind = PrimitiveKind::triangle, .name = name, .vertices = corners});
    }
    return scene;
}

constexpr Canvas ten_by_ten{.width = 10, .height = 10, .origin = Origin::top_left};

/// The square from (0, 0) to (8, 8), cut along its diagonal AC.
Scene square(const Method& method) {
    return mesh({0, 0, 8, 0, 8, 8, 0, 8}, {{0, 1, 2}, {0, 2, 3}}, ten_by_ten, method);
}

TEST(Stats, CountWritesAndOverdraw) {
    Scene scene = first_triangle();
    scene.primitives.push_back(scene.primitives[0]);
    const Stats stats = stats_of_scene(scene);
    EXPECT_EQ(stats.pixels, 49u);
    EXPECT_EQ(stats.writes, 98u);
    ASSERT_EQ(stats.primitives.size(), 2u);
    EXPECT_EQ(stats.primitives[0].over, 0u);
    EXPECT_EQ(stats.primitives[1].over, 49u);
    EXPECT_EQ(stats.primitives[1].pixels, 49u);
    EXPECT_FALSE(stats.frame_differs);
}

TEST(Stats, FindAnotherPictureThanTheEndRecordNames) {
    std::string text = trace_text(first_triangle());
    text.insert(text.find("\"frame\":\"") + 9, "0");
    EXPECT_TRUE(stats_of(readable_trace(text)).frame_differs);
}

TEST(Coverage, TheFloorRuleDrawsOutsideOnTheLeftAndMissesNothing) {
    const Coverage coverage = *stats_of_scene(first_triangle()).primitives[0].coverage;
    EXPECT_EQ(coverage.holes.count, 0u);
    EXPECT_EQ(coverage.outside.count, 6u);
    EXPECT_THAT(coverage.outside.kept, ElementsAre(Pixel{1, 4}, Pixel{0, 3}, Pixel{-1, 2},
                                                   Pixel{-2, 0}, Pixel{-3, -1}, Pixel{-4, -2}));
}

TEST(Coverage, TheBarycentricFillDrawsTheClosedTriangle) {
    const Stats stats =
        stats_of_scene(first_triangle({.scalar = ScalarKind::exact, .fill = Fill::barycentric}));
    EXPECT_EQ(stats.primitives[0].coverage->holes.count, 0u);
    EXPECT_EQ(stats.primitives[0].coverage->outside.count, 0u);
    EXPECT_EQ(stats.pixels, 43u);
}

TEST(Coverage, TheTopLeftRuleLeavesTheOtherEdgesOpen) {
    const Stats stats = stats_of_scene(first_triangle(
        {.scalar = ScalarKind::exact, .fill = Fill::top_left, .sample = Sample::integer}));
    const Coverage& coverage = *stats.primitives[0].coverage;
    EXPECT_EQ(stats.pixels, 32u);
    EXPECT_EQ(coverage.holes.count, 0u);
    EXPECT_EQ(coverage.outside.count, 0u);
}

TEST(Coverage, SamplesAtTheCenterAreJudgedAtTheCenter) {
    const Stats stats =
        stats_of_scene(first_triangle({.scalar = ScalarKind::exact, .fill = Fill::top_left}));
    const Coverage& coverage = *stats.primitives[0].coverage;
    EXPECT_EQ(coverage.holes.count, 0u);
    EXPECT_EQ(coverage.outside.count, 0u);
}

TEST(Coverage, TheFanMissesPixelsByTheOrderOfItsVertices) {
    const Method fan{.scalar = ScalarKind::exact, .fill = Fill::fan};
    const auto missed = [](const Scene& scene) {
        return stats_of_scene(scene).primitives[0].coverage->holes.count;
    };
    const Scene small = first_triangle(fan);
    EXPECT_EQ(missed(small), 2u);
    EXPECT_EQ(missed(in_order(small, {2, 0, 1})), 3u);
    EXPECT_EQ(missed(in_order(small, {1, 2, 0})), 0u);

    const Scene large =
        triangle_scene({"100", "100", "400", "150", "250", "400"},
                       {.width = 512, .height = 512, .origin = Origin::top_left}, fan);
    EXPECT_EQ(missed(large), 256u);
    EXPECT_EQ(missed(in_order(large, {2, 0, 1})), 2789u);
    EXPECT_EQ(missed(in_order(large, {1, 2, 0})), 4341u);
}

TEST(Coverage, OnlyTheFirstPixelsAreKept) {
    const Scene scene =
        in_order(triangle_scene({"100", "100", "400", "150", "250", "400"},
                                {.width = 512, .height = 512, .origin = Origin::top_left},
                                {.scalar = ScalarKind::exact, .fill = Fill::fan}),
                 {1, 2, 0});
    const Coverage coverage = *stats_of_scene(scene).primitives[0].coverage;
    EXPECT_GT(coverage.holes.count, most_pixels_kept);
    EXPECT_EQ(coverage.holes.kept.size(), most_pixels_kept);
    for (std::size_t i = 1; i < most_pixels_kept; ++i)
        EXPECT_LT(scene.canvas.offset_of(coverage.holes.kept[i - 1]),
                  scene.canvas.offset_of(coverage.holes.kept[i]));
}

TEST(Coverage, ThreePassesOfTheFanHideTheHoles) {
    const Stats stats = stats_of_scene(
        first_triangle({.scalar = ScalarKind::exact, .fill = Fill::fan, .fan_passes = 3}));
    EXPECT_EQ(stats.writes, 242u);
    EXPECT_EQ(stats.primitives[0].pixels, 50u);
    EXPECT_EQ(stats.primitives[0].coverage->holes.count, 0u);
    EXPECT_EQ(stats.primitives[0].coverage->outside.count, 7u);
}

RC_GTEST_PROP(Coverage, AgreesWithEveryPixelTestedByItself, ()) {
    // A fan on a small canvas: holes, pixels outside, and parts off the canvas.
    std::vector<std::string> coordinates;
    for (int i = 0; i < 6; ++i)
        coordinates.push_back(std::to_string(*rc::gen::inRange(-40, 41)) + "/" +
                              std::to_string(*rc::gen::inRange(1, 5)));
    const auto origin = *rc::gen::element(Origin::center, Origin::bottom_left, Origin::top_left);
    const auto fill = *rc::gen::element(Fill::fan, Fill::scanline, Fill::top_left);
    const Scene scene = triangle_scene(coordinates, {.width = 15, .height = 12, .origin = origin},
                                       {.scalar = ScalarKind::exact, .fill = fill});
    log_scene(scene);
    std::array<std::array<mpq_class, 2>, 3> at;
    for (std::size_t i = 0; i < 6; ++i)
        at[i / 2][i % 2] = number(coordinates[i]).exact();
    const auto turn = [](const auto& a, const auto& b, const auto& c) {
        return sgn(mpq_class((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])));
    };
    const Stats stats = stats_of_scene(scene);
    const int winding = turn(at[0], at[1], at[2]);
    RC_ASSERT(stats.primitives[0].coverage.has_value() == (winding != 0));
    if (winding == 0)
        return;

    const mpq_class offset = fill == Fill::top_left ? mpq_class(1, 2) : mpq_class(0);
    const Image image = draw_as_planned(scene);
    std::vector<Pixel> holes;
    std::vector<Pixel> outside;
    for (int row = 0; row < scene.canvas.height; ++row)
        for (int x = scene.canvas.left(); x <= scene.canvas.right(); ++x) {
            const Pixel pixel{x, scene.canvas.y_of(row)};
            const std::array<mpq_class, 2> sample{pixel.x + offset, pixel.y + offset};
            int least = 1;
            for (std::size_t i = 0; i < 3; ++i)
                least = std::min(least, winding * turn(at[i], at[(i + 1) % 3], sample));
            const bool is_drawn = image.at(pixel) != no_color;
            if (least > 0 && !is_drawn)
                holes.push_back(pixel);
            if (least < 0 && is_drawn)
                outside.push_back(pixel);
        }
    RC_ASSERT(stats.primitives[0].coverage->holes.kept == holes);
    RC_ASSERT(stats.primitives[0].coverage->outside.kept == outside);
}

// What a fill decides in double or float, it decides right in these numbers: its corners are the
// doubles or floats that the trace has, and what rounding leaves open is no fault.
RC_GTEST_PROP(Coverage, AFillInDoubleOrFloatIsFaultless, ()) {
    const auto scalar =
        *rc::gen::element(ScalarKind::double_precision, ScalarKind::single_precision);
    Method method{.scalar = scalar};
    method.fill =
        *rc::gen::element(Fill::top_left, Fill::barycentric, Fill::scanline, Fill::two_halves);
    method.sample = *rc::gen::element(Sample::integer, Sample::center);
    method.rounding = Rounding::inside;
    const auto parts = *rc::gen::inRange(1, 15);
    auto coordinates = any_triangle(12 * parts, parts);
    // Samples lie on edges often where corners lie in rows of samples.
    const bool has_whole_rows = *rc::gen::arbitrary<bool>();
    for (const std::size_t i : {1U, 3U, 5U})
        if (has_whole_rows)
            coordinates[i] = std::to_string(*rc::gen::inRange(-12, 13));
    const auto origin = *rc::gen::element(Origin::center, Origin::bottom_left, Origin::top_left);
    const Scene scene =
        triangle_scene(coordinates, {.width = 20, .height = 18, .origin = origin}, method);
    log_scene(scene);
    const Stats stats = stats_of_scene(scene);
    if (const auto& coverage = stats.primitives[0].coverage) {
        RC_ASSERT(coverage->holes.count == 0u);
        RC_ASSERT(coverage->outside.count == 0u);
    }
}

// Row 0 lies 1/1024 pixel inside the edge AB. That is 2^14 roundings of a number below 1 in float.
TEST(Coverage, WhatAFloatCanTellIsJudged) {
    std::string text = R"({"rastertrace":1,"canvas":{"width":24,"height":24,"origin":"top-left"},)"
                       R"("method":{"scalar":"float","sample":"integer"}}
{"step":"primitive","kind":"triangle","name":"ABC","at":[[0,-0.0009765625],[20,-0.0009765625],[0,20]]}
)";
    for (int y = 1; y < 20; ++y)
        for (int x = 0; x + y < 20; ++x)
            text += R"({"step":"pixel","x":)" + std::to_string(x) + R"(,"y":)" + std::to_string(y) +
                    "}\n";
    const Stats stats = stats_of(readable_trace(text + "{\"end\":{}}\n"));
    EXPECT_EQ(stats.primitives[0].coverage->holes.count, 19u);
    EXPECT_EQ(stats.primitives[0].coverage->outside.count, 0u);
}

TEST(Coverage, IsOnlyOfTrianglesWithAreaAndNumbers) {
    const Scene line = triangle_scene({"0", "0", "2", "2", "4", "4"}, ten_by_ten);
    EXPECT_FALSE(stats_of_scene(line).primitives[0].coverage);

    const std::string text = trace_text(first_triangle());
    const std::string at = R"("at":[["2","5"],["-4","-3"],["5","-3"]],)";
    for (const std::string other :
         {"", R"("at":[["2","5"],["-4","-3"]],)", R"("at":[["2"],["-4"],["5"]],)",
          R"("at":[["2","5"],["-4","-3"],["5","x"]],)", R"("at":7,)"}) {
        std::string foreign = text;
        foreign.replace(foreign.find(at), at.size(), other);
        const Stats stats = stats_of(readable_trace(foreign));
        EXPECT_EQ(stats.primitives[0].pixels, 49u) << other;
        EXPECT_FALSE(stats.primitives[0].coverage) << other;
    }
}

TEST(Coverage, IsNotOfWhatWasLeftOutOrCutOff) {
    StepFilter filter;
    filter.only = std::vector{StepKind::primitive};
    EXPECT_FALSE(stats_of(readable_trace(trace_text(first_triangle(), {{}, filter})))
                     .primitives[0]
                     .coverage);

    // Cut within the second triangle: the first is whole.
    const std::string whole = trace_text(square({.scalar = ScalarKind::exact}));
    const Stats stats = stats_of(readable_trace(whole.substr(0, whole.rfind("\"pixel\""))));
    ASSERT_EQ(stats.primitives.size(), 2u);
    EXPECT_TRUE(stats.primitives[0].coverage);
    EXPECT_FALSE(stats.primitives[1].coverage);
    EXPECT_THAT(stats.edges, IsEmpty());
}

TEST(SharedEdge, TheScanlineFillDrawsItTwice) {
    const Trace trace = trace_of(square({.scalar = ScalarKind::exact}));
    const Stats stats = stats_of(trace);
    ASSERT_EQ(stats.edges.size(), 1u);
    EXPECT_EQ(name_of(stats.edges[0], stats, trace), "AC");
    EXPECT_EQ(stats.primitives[stats.edges[0].one].name, "ABC");
    EXPECT_EQ(stats.primitives[stats.edges[0].other].name, "ACD");
    EXPECT_EQ(stats.edges[0].twice.count, 9u);
    EXPECT_EQ(stats.edges[0].twice.kept.front(), (Pixel{0, 0}));
    EXPECT_EQ(stats.edges[0].twice.kept.back(), (Pixel{8, 8}));
    EXPECT_EQ(stats.edges[0].never.count, 0u);
}

TEST(SharedEdge, TheTopLeftRuleDrawsItOnce) {
    const Stats stats =
        stats_of_scene(square({.scalar = ScalarKind::exact, .fill = Fill::top_left}));
    EXPECT_EQ(stats.primitives[0].writes + stats.primitives[1].writes, 64u);
    EXPECT_EQ(std::max(stats.primitives[0].writes, stats.primitives[1].writes), 36u);
    ASSERT_EQ(stats.edges.size(), 1u);
    EXPECT_EQ(stats.edges[0].twice.count, 0u);
    EXPECT_EQ(stats.edges[0].never.count, 0u);
}

TEST(SharedEdge, PixelsOnItAndNextToItMayBeDrawnByNeither) {
    // As a foreign rasterizer might: it never draws the diagonal, nor (4, 3) next to it, nor (6, 1)
    // two pixels from it and more.
    std::string text = foreign_header;
    const auto draw = [&text](const std::string& name, const std::string& at, auto is_in) {
        text += foreign_triangle(name, at, [is_in](int x, int y) {
            return is_in(x, y) && Pixel{x, y} != Pixel{4, 3} && Pixel{x, y} != Pixel{6, 1};
        });
    };
    draw("upper", "[[0,0],[8.0,0],[8,8]]", [](int x, int y) { return x > y; });
    draw("lower", "[[\"16/2\",8e0],[0,0],[0,8]]", [](int x, int y) { return x < y; });
    const Trace trace = readable_trace(text + "{\"end\":{}}\n");
    const Stats stats = stats_of(trace);
    ASSERT_EQ(stats.edges.size(), 1u);
    EXPECT_EQ(name_of(stats.edges[0], stats, trace), "(0, 0)-(8, 8)");
    EXPECT_EQ(stats.edges[0].twice.count, 0u);
    EXPECT_THAT(stats.edges[0].never.kept,
                ElementsAre(Pixel{1, 1}, Pixel{2, 2}, Pixel{3, 3}, Pixel{4, 3}, Pixel{4, 4},
                            Pixel{5, 5}, Pixel{6, 6}, Pixel{7, 7}));
    EXPECT_THAT(stats.primitives[0].coverage->holes.kept, ElementsAre(Pixel{6, 1}, Pixel{4, 3}));
}

RC_GTEST_PROP(SharedEdge, AgreesWithEveryPixelTestedByItself, ()) {
    // Two triangles on an edge, or folded over it, filled by a fan: it leaves holes.
    std::vector<int> coordinates;
    for (int i = 0; i < 8; ++i)
        coordinates.push_back(*rc::gen::inRange(-2, 14));
    const Scene scene = mesh(coordinates, {{0, 1, 2}, {3, 1, 0}}, ten_by_ten,
                             {.scalar = ScalarKind::exact, .fill = Fill::fan});
    log_scene(scene);
    const int ax = coordinates[0];
    const int ay = coordinates[1];
    const int bx = coordinates[2];
    const int by = coordinates[3];
    const auto turn = [&](int x, int y) { return (bx - ax) * (y - ay) - (by - ay) * (x - ax); };
    const auto is_inside = [&](int x, int y, std::size_t apex) {
        const int cx = coordinates[2 * apex];
        const int cy = coordinates[2 * apex + 1];
        const int winding = turn(cx, cy);
        return winding * turn(x, y) > 0 &&
               winding * ((cx - bx) * (y - by) - (cy - by) * (x - bx)) > 0 &&
               winding * ((ax - cx) * (y - cy) - (ay - cy) * (x - cx)) > 0;
    };
    RC_PRE(turn(coordinates[4], coordinates[5]) != 0 && turn(coordinates[6], coordinates[7]) != 0);
    const bool runs_along_x = std::abs(bx - ax) >= std::abs(by - ay);
    const int reach = std::max(std::abs(bx - ax), std::abs(by - ay));

    // Folded over the edge, both lie on one side of it.
    const bool is_fold =
        (turn(coordinates[4], coordinates[5]) > 0) == (turn(coordinates[6], coordinates[7]) > 0);

    // What each of the two draws by itself.
    Scene alone = scene;
    alone.primitives.resize(1);
    const Image one = draw_as_planned(alone);
    alone.primitives[0] = scene.primitives[1];
    const Image other = draw_as_planned(alone);

    std::vector<Pixel> twice;
    std::vector<Pixel> never;
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x) {
            const bool by_one = one.at({x, y}) != no_color;
            const bool by_other = other.at({x, y}) != no_color;
            if (by_one && by_other && !is_fold)
                twice.push_back({x, y});
            const auto [low, high] = runs_along_x ? std::minmax({ax, bx}) : std::minmax({ay, by});
            const int along = runs_along_x ? x : y;
            const bool is_near = low <= along && along <= high && std::abs(turn(x, y)) <= reach;
            const bool is_on_edge = turn(x, y) == 0 && low < along && along < high;
            if (is_near && ((is_on_edge && !is_fold) || is_inside(x, y, 2) || is_inside(x, y, 3)) &&
                !by_one && !by_other)
                never.push_back({x, y});
        }
    const Stats stats = stats_of_scene(scene);
    // Where both have the same corners, they share three edges; this one comes first.
    RC_ASSERT(!stats.edges.empty());
    RC_ASSERT(stats.edges[0].twice.kept == twice);
    RC_ASSERT(stats.edges[0].never.kept == never);
    RC_CLASSIFY(!never.empty(), "some are never drawn");
}

TEST(SharedEdge, HorizontalAndVerticalOnesToo) {
    // Twice the square, its left half and its right half, its upper half and its lower half.
    const Method method{
        .scalar = ScalarKind::exact, .fill = Fill::top_left, .sample = Sample::integer};
    for (const auto& coordinates :
         {std::vector{4, 0, 4, 8, 0, 4, 8, 4}, std::vector{0, 4, 8, 4, 4, 0, 4, 8}}) {
        const Scene scene = mesh(coordinates, {{0, 1, 2}, {1, 0, 3}}, ten_by_ten, method);
        const Stats stats = stats_of_scene(scene);
        ASSERT_EQ(stats.edges.size(), 1u);
        EXPECT_EQ(stats.edges[0].twice.count, 0u);
        EXPECT_EQ(stats.edges[0].never.count, 0u);
    }
}

TEST(SharedEdge, AFoldIsNotDrawnTwice) {
    // ABC and ABD lie both below AB, and share pixels.
    const Scene fold = mesh({1, 2, 9, 2, 4, 9, 8, 9}, {{0, 1, 2}, {0, 1, 3}}, ten_by_ten,
                            {.scalar = ScalarKind::exact, .fill = Fill::top_left});
    const Stats stats = stats_of_scene(fold);
    ASSERT_EQ(stats.edges.size(), 1u);
    EXPECT_LT(stats.pixels, stats.writes);
    EXPECT_EQ(stats.edges[0].twice.count, 0u);
    EXPECT_EQ(stats.edges[0].never.count, 0u);
}

TEST(SharedEdge, OfThreeTrianglesEveryPairIsCompared) {
    const Scene scene = mesh({0, 0, 8, 0, 8, 8, 0, 8, 4, 8}, {{0, 1, 2}, {0, 2, 3}, {2, 0, 4}},
                             ten_by_ten, {.scalar = ScalarKind::exact});
    std::vector<std::string> pairs;
    const Trace trace = trace_of(scene);
    const Stats stats = stats_of(trace);
    for (const auto& edge : stats.edges)
        pairs.push_back(name_of(edge, stats, trace) + " of " + stats.primitives[edge.one].name +
                        " and " + stats.primitives[edge.other].name);
    EXPECT_THAT(pairs, ElementsAre("AC of ABC and ACD", "AC of ABC and CAE", "AC of ACD and CAE"));
}

TEST(SharedEdge, OfVeryManyTrianglesTheFirstAreCompared) {
    Scene scene = triangle_scene({"0", "0", "2", "0", "0", "2"}, ten_by_ten);
    scene.primitives.resize(100, scene.primitives[0]);
    EXPECT_EQ(stats_of_scene(scene).edges.size(), 3 * most_compared * (most_compared - 1) / 2);
}

TEST(WrongRows, AreNotInWhatIsDrawnHere) {
    std::size_t rows = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const auto read = read_scene({"scene.json", RandomScene(seed).text()});
        if (!read)
            continue;
        const Trace trace = trace_of(read.value().scene);
        const Stats stats = stats_of(trace);
        for (const WrongRow& row : stats.wrong_rows)
            ADD_FAILURE() << "seed " << seed << ": " << trace.step(row.step).json() << " missing "
                          << row.missing << ", others " << row.others;
        for (const auto& [kind, count] : stats.count)
            rows += kind == "scanline" ? count : 0;
    }
    EXPECT_GT(rows, 1000u);
}

// The order of pixels is free; a row that was cut off is not judged.
TEST(WrongRows, CountWhatIsMissingAndWhatIsTooMuch) {
    const auto wrong = [](const std::string& pixels, const std::string& end = R"(],"end":{}})") {
        const Stats stats = stats_of(readable_trace(
            R"({"rastertrace":1,"canvas":{"width":8,"height":8,"origin":"top-left"},"steps":[
{"step":"scanline","y":2,"left":1,"right":3,"from":1,"to":3})" +
            pixels + "\n" + end));
        std::string text;
        for (const WrongRow& row : stats.wrong_rows)
            text +=
                std::to_string(row.missing) + " missing, " + std::to_string(row.others) + " others";
        return text;
    };
    const auto pixel = [](int x, int y) {
        return ",\n{\"step\":\"pixel\",\"x\":" + std::to_string(x) + ",\"y\":" + std::to_string(y) +
               "}";
    };
    const std::string rejected =
        ",\n{\"step\":\"reject\",\"x\":1,\"to_x\":2,\"y\":2,\"why\":\"x\"}";
    const std::string hidden = ",\n{\"step\":\"depth\",\"x\":3,\"y\":2,\"depth\":1,\"pass\":false}";
    EXPECT_EQ(wrong(pixel(1, 2) + pixel(2, 2) + pixel(3, 2)), "");
    EXPECT_EQ(wrong(pixel(3, 2) + pixel(2, 2) + pixel(1, 2)), "");
    EXPECT_EQ(wrong(rejected + hidden), "");
    EXPECT_EQ(wrong(pixel(1, 2) + pixel(2, 2)), "1 missing, 0 others");
    EXPECT_EQ(wrong(rejected + pixel(2, 2) + pixel(3, 2)), "0 missing, 1 others");
    EXPECT_EQ(wrong(rejected + pixel(4, 2)), "1 missing, 1 others");
    EXPECT_EQ(wrong(rejected + hidden + pixel(2, 3)), "0 missing, 1 others");
    EXPECT_EQ(wrong(""), "3 missing, 0 others");
    EXPECT_EQ(wrong(pixel(1, 2), ""), "");
}

/// The findings that cannot be judged, and why: "holes, twice, outside: expected ..."
std::vector<std::string> unjudged(const std::string& steps, const std::string& header = "") {
    std::vector<std::string> all;
    const Stats stats = stats_of(
        readable_trace(R"({"rastertrace":1,"canvas":{"width":8,"height":8,"origin":"top-left"})" +
                       header + "}\n" + steps + "{\"end\":{}}\n"));
    for (const auto& [findings, lacks] : stats.unjudged)
        all.push_back(names_of(findings) + ": " + lacks);
    return all;
}

TEST(Unjudged, IsWhatStepsLackFieldsFor) {
    const auto triangle = [](const std::string& more, const std::string& kind = "triangle") {
        return R"({"step":"primitive","kind":")" + kind + R"(","name":"ABC")" + more + "}\n";
    };
    const std::string at = R"(,"at":[[0,0],["7/2",0],[0,3.5]])";
    const std::string row = R"({"step":"scanline","y":1,"left":1,"right":1,"from":1,"to":1})"
                            "\n";
    const std::string pixel = R"({"step":"pixel","x":1,"y":1})"
                              "\n";
    const std::string corners = "holes, twice, outside: expected ";
    const std::string of_abc = R"("at", three pairs of numbers, of triangle ABC (step 1), found )";
    EXPECT_THAT(unjudged(triangle(at) + row + pixel), IsEmpty());
    EXPECT_THAT(unjudged(triangle("") + row + pixel), ElementsAre(corners + of_abc + "none"));
    EXPECT_THAT(unjudged(triangle("") + row), ElementsAre(corners + of_abc + "none"));
    EXPECT_THAT(unjudged(triangle(R"(,"at":[[0,0],[3,0]])") + row + pixel),
                ElementsAre(corners + of_abc + "[[0,0],[3,0]]"));
    EXPECT_THAT(unjudged(triangle(R"(,"at":[[0,0],[3,0],[0,"x"]])") + row + pixel),
                ElementsAre(corners + of_abc + R"([[0,0],[3,0],[0,"x"]])"));
    EXPECT_THAT(
        unjudged(triangle(at, "quad") + row + pixel),
        ElementsAre(
            corners +
            "a triangle, polygon, outline, line, circle or point, found quad ABC (step 1)"));
    EXPECT_THAT(unjudged(triangle(at) + pixel),
                ElementsAre(R"(rows: expected a "scanline" in front of step 2, found none)"));
    EXPECT_THAT(unjudged(pixel),
                ElementsAre(corners + R"(a "primitive" in front of step 1, found none)",
                            R"(rows: expected a "scanline" in front of step 1, found none)"));
    EXPECT_THAT(unjudged(pixel, R"(,"only":["pixel"])"),
                ElementsAre("holes, twice, outside, rows: expected a trace with all its steps, "
                            "found one that steps were left out of"));
    // The first one that lacks something is told.
    EXPECT_THAT(
        unjudged(triangle(at) + row + pixel + triangle("") + pixel),
        ElementsAre(corners +
                        R"("at", three pairs of numbers, of triangle ABC (step 4), found none)",
                    R"(rows: expected a "scanline" in front of step 5, found none)"));
    // What has no inside, or draws nothing, lacks nothing.
    EXPECT_THAT(unjudged(triangle("", "line") + pixel), IsEmpty());
    EXPECT_THAT(unjudged(triangle("") + R"({"step":"skip","why":"culled"})"
                                        "\n"),
                IsEmpty());
}

TEST(Unjudged, IsNothingOfWhatIsDrawnHere) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const auto read = read_scene({"scene.json", RandomScene(seed).text()});
        if (!read)
            continue;
        for (const Unjudged& one : stats_of(trace_of(read.value().scene)).unjudged)
            ADD_FAILURE() << "seed " << seed << ": " << names_of(one.findings) << ": " << one.lacks;
    }
}

/// The trace of a scene as a rasterizer writes it that says nothing of samples.
Stats without_sample(const Scene& scene) {
    std::string text = trace_text(scene);
    const std::size_t begin = text.find(R"(,"sample":)");
    return stats_of(readable_trace(text.erase(begin, text.find('}', begin) - begin)));
}

TEST(FoundSample, IsTheOnlyOneThatExplainsAllPixels) {
    for (const Sample sample : {Sample::integer, Sample::center}) {
        const Stats stats = without_sample(triangle_scene(
            {"1/2", "1/2", "15/2", "1/2", "1/2", "15/2"}, ten_by_ten,
            {.scalar = ScalarKind::exact, .fill = Fill::barycentric, .sample = sample}));
        ASSERT_TRUE(stats.sample);
        EXPECT_EQ(stats.sample->is_center, sample == Sample::center);
        EXPECT_TRUE(stats.sample->explains_all);
        for (const PrimitiveStats& primitive : stats.primitives) {
            EXPECT_EQ(primitive.coverage->holes.count, 0u);
            EXPECT_EQ(primitive.coverage->outside.count, 0u);
        }
    }
}

// By the top-left rule the square from (0, 0) to (8, 8) has the pixels 0 to 7, whichever of their
// samples are tested: those that are missing lie on its boundary.
TEST(FoundSample, IsNotToldWhereBothExplainAllPixels) {
    EXPECT_FALSE(
        without_sample(square({.scalar = ScalarKind::exact, .fill = Fill::top_left})).sample);
}

TEST(FoundSample, IsIntegerWhereNeitherExplainsAllPixels) {
    std::string text = R"({"rastertrace":1,"canvas":{"width":8,"height":8,"origin":"top-left"}}
{"step":"primitive","kind":"triangle","name":"ABC","at":[[0,0],[4,0],[0,4]]}
{"step":"pixel","x":7,"y":7}
{"end":{}}
)";
    const Stats stats = stats_of(readable_trace(text));
    ASSERT_TRUE(stats.sample);
    EXPECT_FALSE(stats.sample->is_center);
    EXPECT_FALSE(stats.sample->explains_all);
    // Strictly inside: (1, 1), (2, 1), (1, 2).
    EXPECT_EQ(stats.primitives[0].coverage->holes.count, 3u);
}

} // namespace
} // namespace rastertrace
