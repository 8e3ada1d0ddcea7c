// SPDX-License-Identifier: MIT
#include "picture.h"
#include "traces.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/tell/describe.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rastertrace {
namespace {

/// What is said of step n of a scene's trace.
std::string description(const Scene& scene, std::size_t n) {
    Source source{"t", {}};
    StringOutput output(source.text);
    write_trace(scene, {}, output);
    const auto trace = read_trace(source);
    Replay replay(trace.value());
    replay.go_to(n);
    return describe_step(replay);
}

TEST(Describe, EveryStepOfTheFirstTriangle) {
    const Scene scene = first_triangle();
    EXPECT_EQ(description(scene, 0), "nothing drawn yet");
    EXPECT_EQ(description(scene, 1), "triangle ABC   A (2, 5)   B (-4, -3)   C (5, -3)");
    EXPECT_EQ(description(scene, 2), "edge AB: dx/dy = (-4 - 2) / (-3 - 5) = 3/4; "
                                     "x = 2 + 3/4 (y - 5); y = 4/3 x + 7/3");
    EXPECT_EQ(description(scene, 3), "edge BC: horizontal, it has no dx/dy");
    EXPECT_EQ(description(scene, 4), "edge AC: dx/dy = (5 - 2) / (-3 - 5) = -3/8; "
                                     "x = 2 - 3/8 (y - 5); y = -8/3 x + 31/3");
    EXPECT_EQ(description(scene, 14),
              "scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor -> -1   "
              "right AC: x = 2 - 3/8 (2 - 5) = 25/8 -> floor -> 3");
    EXPECT_EQ(description(scene, 15), "pixel (-1, 2)   row y=2: -1 to 3");
}

TEST(Describe, TheNextDIsTheOneThatFollows) {
    const auto first_decision = [](const std::string& mistake) {
        const auto scene = read_scene(
            {"scene.json", R"({"canvas":{"width":9,"height":9},"vertices":{"A":[0,0],"B":[5,2]},)"
                           R"("lines":["AB"],"method":{"line":"bresenham")" +
                               mistake + "}}"});
        const Trace trace = readable_trace(trace_text(scene.value(), {}));
        Replay replay(trace);
        replay.go_to(3);
        return describe_step(replay);
    };
    EXPECT_EQ(first_decision(""), "at (0, 0): d = -1 <= 0, straight on to E; d + 4 = 3");
    // dy = 2 is added in the place of 2 dy.
    EXPECT_EQ(first_decision(R"(,"mistake":"factor-2-dropped")"),
              "at (0, 0): d = -1 <= 0, straight on to E; the next d is 1");
}

/// What is said of the first step of a trace.
std::string first_sentence_of(const std::string& text) {
    const auto trace = read_trace({"t", text});
    EXPECT_TRUE(trace);
    Replay replay(trace.value());
    replay.go_to(1);
    return describe_step(replay);
}

TEST(Describe, ASentenceIsItsPatternAndWhatStandsForThePlaceholders) {
    const Trace trace = trace_of(first_triangle());
    Replay replay(trace);
    EXPECT_EQ(sentence_of_step(replay).pattern, describe_step(replay));
    replay.go_to(15);
    const Sentence sentence = sentence_of_step(replay);
    EXPECT_EQ(sentence.pattern, row_of(StepKind::pixel).sentence.in(Language::english));
    EXPECT_THAT(pieces_of(sentence.pattern),
                testing::ElementsAre("pixel (", ", ", ")", "", "", ""));
    EXPECT_THAT(sentence.fills, testing::ElementsAre("-1", "2", "", "   row y=2: -1 to 3", ""));

    const Trace unknown = readable_trace(
        R"({"rastertrace":1,"canvas":{"width":2,"height":2,"origin":"center"},"steps":[
{"step":"blur","x":1}
],"end":{"steps":1}})");
    Replay other(unknown);
    other.go_to(1);
    EXPECT_EQ(sentence_of_step(other).pattern, "{step}");
    EXPECT_EQ(describe_step(other), R"({"step":"blur","x":1})");
}

TEST(Describe, ABresenhamLineThatStepsAtTies) {
    Scene scene;
    scene.canvas = {.width = 5, .height = 3, .origin = Origin::bottom_left};
    scene.vertices = {{"A", 0, 0}, {"B", 2, 1}};
    scene.primitives = {{.kind = PrimitiveKind::line, .name = "AB", .vertices = {0, 1}}};
    EXPECT_EQ(description(scene, 3), "at (0, 0): d = 0 <= 0, straight on to E; d + 2 = 2");
    scene.method.ties = Ties::step;
    EXPECT_EQ(description(scene, 3), "at (0, 0): d = 0 >= 0, diagonally to NE; d - 2 = -2");
}

TEST(Describe, HiddenLines) {
    // A line that dives into the face: before it, on it, behind it; its side, which is hidden by nothing.
    Scene scene = triangle_scene({"0", "0", "7", "0", "0", "7"},
                                 {.width = 9, .height = 9, .origin = Origin::bottom_left},
                                 {.scalar = ScalarKind::exact, .depth = Depth::linear_z});
    scene.vertices[0].z = 4;
    scene.vertices[1].z = 4;
    scene.vertices[2].z = 4;
    scene.vertices.push_back({"D", 1, 1, {}, 3});
    scene.vertices.push_back({"E", 3, 1, {}, 5});
    scene.primitives.push_back({.kind = PrimitiveKind::line, .name = "DE", .vertices = {3, 4}});
    std::vector<std::string> said;
    const Trace trace = trace_of(scene);
    bool is_line = false;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        if (trace.kind_of(n) == StepKind::primitive)
            is_line = trace.step(n).as<PrimitiveStep>().kind == PrimitiveKind::line;
        if (!is_line || trace.kind_of(n) != StepKind::depth)
            continue;
        Replay replay(trace, {.depths = true});
        replay.go_to(n);
        said.push_back(describe_step(replay));
    }
    EXPECT_THAT(said, testing::ElementsAre(
                          "depth at (1, 1): 3 against 4 of ABC: passes (z, smaller is nearer)",
                          "depth at (2, 1): 4 against 4 of ABC: passes (z, smaller is nearer; of "
                          "equals the thinner "
                          "one passes)",
                          "depth at (3, 1): 5 against 4 of ABC: fails (z, smaller is nearer; ABC "
                          "covers the line's "
                          "own point and is nearer there)"));
}

TEST(Describe, WhatDoublesLeaveOpen) {
    const Scene scene = triangle_scene({"0.999999999999999999999999999999", "0", "2", "1",
                                        "1.000000000000000000000000000001", "2"},
                                       {.width = 3, .height = 3, .origin = Origin::bottom_left},
                                       {.scalar = ScalarKind::adaptive});
    std::string found;
    for (std::size_t n = 1; found.empty() && n < 10; ++n)
        if (const std::string text = description(scene, n); text.starts_with("doubles"))
            found = text;
    EXPECT_TRUE(found.starts_with("doubles leave ABC open: a difference of ")) << found;
    EXPECT_TRUE(found.ends_with("; drawn in exact numbers")) << found;
}

TEST(Describe, IncrementalRowsAddToTheRowBefore) {
    const Scene scene =
        first_triangle({.scalar = ScalarKind::exact, .lerp = LerpForm::incremental});
    EXPECT_EQ(description(scene, 5),
              "scanline y=5   left AB: x = 2 + 3/4 (5 - 5) = 2 -> floor -> 2   "
              "right AC: x = 2 - 3/8 (5 - 5) = 2 -> floor -> 2");
    EXPECT_EQ(description(scene, 7), "scanline y=4   left AB: x = 2 - 3/4 = 5/4 -> floor -> 1   "
                                     "right AC: x = 2 + 3/8 = 19/8 -> floor -> 2");
}

/// `two-halves` goes upward.
TEST(Describe, IncrementalRowsSayWhatIsAdded) {
    const Scene scene = first_triangle(
        {.scalar = ScalarKind::exact, .fill = Fill::two_halves, .lerp = LerpForm::incremental});
    std::string second;
    for (std::size_t n = 1; second.empty(); ++n)
        if (const std::string text = description(scene, n); text.starts_with("scanline y=-2"))
            second = text;
    EXPECT_EQ(second, "scanline y=-2   left AB: x = -4 + 3/4 = -13/4 -> floor -> -4   "
                      "right AC: x = 5 - 3/8 = 37/8 -> floor -> 4");
}

TEST(Describe, NegativeCoordinatesAreSubtractedAsOneWritesIt) {
    const Scene scene =
        triangle_scene({"-1", "-2", "3", "-4", "-3", "-4"}, {.width = 9, .height = 9});
    EXPECT_EQ(description(scene, 2), "edge AC: dx/dy = (-3 + 1) / (-4 + 2) = 1; "
                                     "x = -1 + 1 (y + 2); y = 1 x - 1");
    EXPECT_EQ(description(scene, 7),
              "scanline y=-3   left AC: x = -1 + 1 (-3 + 2) = -2 -> floor -> -2   "
              "right AB: x = -1 - 2 (-3 + 2) = 1 -> floor -> 1");
}

TEST(Describe, WhatIsNotDrawn) {
    EXPECT_EQ(
        description(triangle_scene({"9", "0", "9", "1", "8", "1"}, {.width = 5, .height = 5}), 5),
        "triangle ABC: skipped, off canvas");
    const Scene cut = triangle_scene({"0", "0", "9", "0", "0", "9"}, {.width = 5, .height = 5});
    EXPECT_EQ(description(cut, 5), "rows y=9 to 3: dropped, off-canvas");
    EXPECT_EQ(description(cut, 10), "pixels (3, 2) to (7, 2): dropped, off-canvas");
}

TEST(Describe, PixelsDrawnAgain) {
    Scene scene = first_triangle();
    scene.primitives.push_back(scene.primitives[0]);
    EXPECT_EQ(description(scene, 62 + 6), "pixel (2, 5)   row y=5: 2 to 2   over step 6");
}

TEST(Describe, LinesAndTheirDecisions) {
    Scene scene = triangle_scene({"0", "0", "5", "2", "0", "0"}, {.width = 13, .height = 13});
    scene.vertices.pop_back();
    scene.primitives[0] = {.kind = PrimitiveKind::line, .name = "AB", .vertices = {0, 1}};
    EXPECT_EQ(description(scene, 1), "line AB   A (0, 0)   B (5, 2)   octant 1");
    EXPECT_EQ(description(scene, 3), "at (0, 0): d = -1 <= 0, straight on to E; d + 4 = 3");
    EXPECT_EQ(description(scene, 5), "at (1, 0): d = 3 > 0, diagonally to NE; d - 6 = -3");
    scene.method.line = LineMethod::naive;
    EXPECT_EQ(description(scene, 4), "x = 1: y = 2/5 x + 0 = 2/5 -> nearest -> 0");
}

TEST(Describe, EdgeFunctionsSamplesHalvesAndRays) {
    EXPECT_EQ(
        description(first_triangle({.scalar = ScalarKind::exact, .fill = Fill::top_left}), 2),
        "edge AB: E(x, y) = 8 (x - 2) - 6 (y - 5), top or left: samples where E = 0 belong to "
        "the triangle");
    // AB is at x = 2 + 3/4 (9/2 - 5), AC at 2 - 3/8 (9/2 - 5).
    EXPECT_EQ(description(first_triangle({.scalar = ScalarKind::exact, .fill = Fill::top_left}), 5),
              "scanline y=4, samples at y = 4 + 1/2   left AB: x = 13/8 <= sample 2 + 1/2 -> 2   "
              "right AC: x = 35/16 > sample 1 + 1/2 -> 1   no pixel between");
    EXPECT_EQ(
        description(first_triangle({.scalar = ScalarKind::exact, .fill = Fill::barycentric}), 2),
        "sample of (-4, 5): (48, -48, 72) / 72: A 1 B 2/3 C -2/3: one is negative, outside");
    EXPECT_EQ(
        description(first_triangle({.scalar = ScalarKind::exact, .fill = Fill::two_halves}), 5),
        "lower half: no row");
    EXPECT_EQ(
        description(first_triangle({.scalar = ScalarKind::exact, .fill = Fill::two_halves}), 6),
        "upper half: rows y=-3 to 5");
    EXPECT_EQ(description(first_triangle({.scalar = ScalarKind::exact, .fill = Fill::fan}), 3),
              "a line begins at (-4, -3), to (5, -3)");
}

/// T3: a level of 128 is 21.6 % of the light, not half of it.
TEST(Describe, TheLevelOfALitFaceIsNotItsShareOfTheLight) {
    EXPECT_EQ(first_sentence_of(
                  "{\"rastertrace\":1,\"canvas\":{\"width\":3,\"height\":3}}\n"
                  "{\"step\":\"light\",\"name\":\"ABC\",\"normal\":[0,0,1],\"light\":[0,0,1],"
                  "\"dot\":1,\"intensity\":0.5,\"color\":\"#800000\"}\n{\"end\":{\"steps\":1}}\n"),
              "light on ABC: normal (0, 0, 1) . light (0, 0, 1) = 1, intensity 0.5, color #800000 "
              "(level 128: 21.6 % of the light on an sRGB screen)");
}

TEST(Describe, DoublesThatAreShortFractions) {
    const Scene scene = first_triangle({.scalar = ScalarKind::double_precision});
    EXPECT_EQ(description(scene, 14),
              "scanline y=2   left AB: x = 2 + 0.75 (2 - 5) = -0.25 = -1/4 -> floor -> -1   "
              "right AC: x = 2 - 0.375 (2 - 5) = 3.125 = 25/8 -> floor -> 3");
}

TEST(Describe, DoublesThatAreNoShortFractions) {
    const Scene scene = triangle_scene({"0.1", "0", "5.1", "0", "0.1", "5"},
                                       {.width = 8, .height = 8, .origin = Origin::bottom_left},
                                       {.scalar = ScalarKind::double_precision});
    for (std::size_t n = 1; n < 12; ++n)
        EXPECT_EQ(description(scene, n).find("= 1/10"), std::string::npos) << n;
}

/// A scene of rows and lines names two roundings; each end and each pixel is rounded by its own.
TEST(Describe, TheRoundingOfRowsAndThatOfLines) {
    Scene scene = first_triangle();
    scene.method.line = LineMethod::naive;
    scene.primitives.push_back(
        {.kind = PrimitiveKind::line, .name = "AB", .vertices = {0, 1}, .color = {}});
    EXPECT_EQ(description(scene, 14),
              "scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor -> -1   "
              "right AC: x = 2 - 3/8 (2 - 5) = 25/8 -> floor -> 3");
    const std::size_t line = 63;
    EXPECT_EQ(description(scene, line), "line AB   A (2, 5)   B (-4, -3)   octant 6");
    EXPECT_EQ(description(scene, line + 3), "y = 4: x = 3/4 y - 7/4 = 5/4 -> nearest -> 1");
    EXPECT_EQ(description(scene, line + 5),
              "y = 3: x = 3/4 y - 7/4 = 1/2 -> nearest, ties up -> 1");

    // Both nearest, each with its own ties.
    scene.method.rounding = Rounding::nearest;
    EXPECT_THAT(description(scene, 10), ::testing::HasSubstr(" = 1/2 -> nearest, ties up -> 1 "));
    EXPECT_THAT(description(scene, line + 5),
                ::testing::HasSubstr(" = 1/2 -> nearest, ties up -> 1"));
}

/// Thirty degrees make fractions of thirty digits; a formula shows seven.
TEST(Describe, LongFractionsInFormulas) {
    const Scene scene = triangle_scene(
        {"2", "5.0000000000000000000000001", "-4", "-3.0000000000000000000000001", "5", "-3"},
        {.width = 17, .height = 11}, {.scalar = ScalarKind::exact});
    for (std::size_t n = 2; n < 20; ++n)
        EXPECT_LT(description(scene, n).size(), 260u) << description(scene, n);
    EXPECT_EQ(description(scene, 2),
              "edge AC: dx/dy = (5 - 2) / (-3 - 5) = -1000000.../26666666... = -0.375; "
              "x = 2 - 0.375 (y - 5); y = -2.666667 x + 10.33333");
    EXPECT_EQ(description(scene, 5),
              "scanline y=5   left AB: x = 2 + 0.75 (5 - 5) = 79999999.../40000000... < 2 -> "
              "floor -> 1   right AC: x = 2 - 0.375 (5 - 5) = 53333333.../26666666... > 2 -> "
              "floor -> 2");
}

/// A number that is large is not beside a whole number because seven digits are.
TEST(Describe, LargeNumbersAreNotBesideWholeOnes) {
    const Scene scene = triangle_scene({"12345678.3", "0", "12345679.3", "0", "12345678.3", "3.3"},
                                       {.width = 8, .height = 8}, {.scalar = ScalarKind::exact});
    EXPECT_EQ(description(scene, 1).find(" < "), std::string::npos);
}

/// A fan's lines go to the pixel nearest to the apex.
TEST(Describe, AFansLineGoesToAPixel) {
    const Scene scene = triangle_scene({"0", "0", "4", "0", "6.5", "5.5"},
                                       {.width = 9, .height = 9, .origin = Origin::bottom_left},
                                       {.scalar = ScalarKind::exact, .fill = Fill::fan});
    EXPECT_EQ(description(scene, 3), "a line begins at (0, 0), to (7, 6)");
}

/// T2's colors, step by step or by the distance.
TEST(Describe, TheColorOfALinesPixel) {
    Scene scene = scene_in(R"({
  "canvas": {"width": 6, "height": 3, "origin": "bottom-left"},
  "vertices": {"A": [0, 0], "B": [5, 2]},
  "colors": {"A": "#000000", "B": "#ff0000"},
  "lines": ["AB"]})");
    EXPECT_EQ(description(scene, 4),
              "pixel (1, 0) #330000 (step 1 of 5)   d = -1 <= 0, straight on");
    scene.method.color_lerp = ColorLerp::distance;
    EXPECT_EQ(description(scene, 4),
              "pixel (1, 0) #2b0000 (0.169545 of the distance)   d = -1 <= 0, straight on");
}

/// A trace has one word for both; the sentence is true of both.
TEST(Describe, APointBesideTheEyeIsNotBehindIt) {
    const Trace trace = trace_of(scene_in(R"({"canvas": {"width": 9, "height": 9},
        "vertices": {"R": [1, 1, 0], "S": [1, 1, 2]}, "points": ["R", "S"],
        "projection": {"type": "view-plane", "distance": 1}})"));
    std::vector<std::string> told;
    Replay replay(trace);
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        replay.go_to(n);
        if (trace.kind_of(n) == StepKind::skip) {
            EXPECT_EQ(trace.step(n).as<SkipStep>().why.text(), "behind the eye");
            told.push_back(describe_step(replay));
        }
    }
    EXPECT_THAT(told, testing::ElementsAre("point R: skipped, not in front of the eye",
                                           "point S: skipped, not in front of the eye"));
}

/// A trace of some steps only does not know what kind of primitive was skipped.
TEST(Describe, ASkippedPrimitiveOfUnknownKind) {
    EXPECT_EQ(
        first_sentence_of(
            "{\"rastertrace\":1,\"canvas\":{\"width\":3,\"height\":3},\"only\":[\"skip\"]}\n"
            "{\"step\":\"skip\",\"name\":\"DGH\",\"why\":\"culled\"}\n{\"end\":{\"steps\":1}}\n"),
        "primitive DGH: skipped, culled");
}

TEST(Describe, OnlyWhatIsCutIsCalledClipped) {
    const auto said_of_first = [](const std::string& next, const std::string& header = "") {
        return first_sentence_of(R"({"rastertrace":1,"canvas":{"width":3,"height":3})" + header +
                                 "}\n" + R"({"step":"primitive","kind":"triangle","name":"ABC"})" +
                                 "\n" + next + R"({"end":{}})" + "\n");
    };
    const std::string clipped = "triangle ABC: not all of it can be seen, it is clipped";
    const std::string untold = "triangle ABC: the trace does not tell where it is";
    const std::string pixel = R"({"step":"pixel","x":0,"y":0})"
                              "\n";
    const std::string clip = R"({"step":"clip","name":"ABC","plane":"near"})"
                             "\n";
    const std::string stages =
        R"(,"stages":[{"stage":"clip","plane":"near","kept":true,"why":""}])";
    EXPECT_EQ(said_of_first(pixel), untold);
    EXPECT_EQ(said_of_first(""), untold);
    EXPECT_EQ(said_of_first(pixel, stages), untold);
    EXPECT_EQ(said_of_first(clip), clipped);
    EXPECT_EQ(said_of_first(pixel, stages + R"(,"only":["primitive","pixel"])"), clipped);
    EXPECT_EQ(said_of_first("", stages), clipped);
}

TEST(Describe, StepsThatAreUnknown) {
    EXPECT_EQ(
        first_sentence_of(
            "{\"rastertrace\":1,\"canvas\":{\"width\":3,\"height\":3}}\n"
            "{\"step\":\"tile\",\"note\":\"\\u001b[2J \xC2\x9B\"}\n{\"end\":{\"steps\":1}}\n"),
        "{\"step\":\"tile\",\"note\":\"\\u001b[2J <U+009B>\"}");
}

TEST(Describe, FacesInEars) {
    const auto face_of = [](const std::string& vertices, const std::string& face) {
        return description(
            scene_in(R"({"meshes":[{"vertices":{)" + vertices + R"(},"faces":[)" + face + "]}]}"),
            1);
    };
    EXPECT_EQ(face_of(R"("A":[0,0],"B":[4,0],"C":[1,1],"D":[0,4])", R"("ABCD")"),
              "face ABCD is not convex; its normal (0, 0, 8) is largest in z, which is dropped; "
              "ears: ABC; what is left is ACD");

    // A comb of twenty teeth has too many to tell.
    std::string vertices;
    std::string face;
    for (int i = 0; i < 40; ++i) {
        vertices += (i == 0 ? "\"P" : ",\"P") + std::to_string(i) + "\":[" + std::to_string(i) +
                    "," + (i % 2 == 0 ? "0]" : "5]");
        face += (i == 0 ? "\"P" : ",\"P") + std::to_string(i) + '"';
    }
    EXPECT_THAT(face_of(vertices + R"(,"A":[39,-9],"B":[0,-9])", "[" + face + R"(,"A","B"])"),
                testing::HasSubstr(", ... (39 in all); what is left is "));
}

} // namespace
} // namespace rastertrace
