// SPDX-License-Identifier: MIT
#include "claims_support.h"
#include "effort.h"
#include "picture.h"
#include "random_scene.h"
#include "traces.h"
#include "working_support.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/tell/working.h>

#include <fmt/core.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

TEST(Working, OfTheFirstTriangle) {
    const Trace trace = trace_of(first_triangle());
    EXPECT_THAT(working(trace, StepKind::primitive, "ABC"),
                ElementsAre("AB x AC = (-6) (-8) - (-8) (3) = 72: C lies left of it",
                            "BC x BA = 9 (8) - 0 (6) = 72: A lies left of it",
                            "CA x CB = (-3) (0) - 8 (-9) = 72: B lies left of it",
                            "area = |72| / 2 = 36, counter-clockwise"));
    EXPECT_THAT(working(trace, StepKind::edge, "AC"),
                ElementsAre("dx = 5 - 2 = 3, dy = -3 - 5 = -8", "x = 2 - 3/8 (y - 5)",
                            "  = -3/8 y + 31/8", "y = -8/3 x + 31/3"));
    const Working row{"left AB: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (-4 - 2)/(-3 - 5) (2 - 5) "
                      "+ 2 = 3/4 (-3) + 2 = -1/4 -> floor -> -1",
                      "right AC: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (5 - 2)/(-3 - 5) (2 - 5) "
                      "+ 2 = (-3/8) (-3) + 2 = 25/8 -> floor -> 3",
                      "-1/4 < 25/8: AB is left, AC is right",
                      "x = -1 to 3: 3 - (-1) + 1 = 5 pixels"};
    EXPECT_EQ(working(trace, StepKind::scanline, 0, 2), row);
    EXPECT_THAT(working(trace, StepKind::pixel, -1, 2), IsSupersetOf(row));
}

TEST(Working, AClockwiseTriangleWhereYPointsDown) {
    const Trace trace = trace_of(triangle_scene(
        {"1", "1", "5", "1", "1", "4"}, {.width = 8, .height = 8, .origin = Origin::top_left}));
    EXPECT_THAT(working(trace, StepKind::primitive, "ABC"),
                IsSupersetOf({"AB x AC = 4 (3) - 0 (0) = 12: C lies right of it",
                              "area = |12| / 2 = 6, clockwise"}));
}

/// P(0, 0) Q(6, 3) R(2, 6): E is above 0 at the corner opposite, Q and R, which decides the signs.
TEST(Working, TheNumbersOfAnEdgeFunction) {
    const Trace trace = example("tutorial/shared-edges/corner-at-the-side.json");
    EXPECT_THAT(working(trace, StepKind::edge, "QP"), Contains("a = dy = -3, b = -dx = 6"));
    EXPECT_THAT(working(trace, StepKind::edge, "RP"), Contains("a = -dy = 6, b = dx = -2"));
}

/// T3's table of points: (ABx, ACx, PAx) x (ABy, ACy, PAy).
TEST(Working, SamplesByACrossProduct) {
    const Trace trace =
        trace_of(first_triangle({.scalar = ScalarKind::exact, .fill = Fill::barycentric}));
    EXPECT_THAT(working(trace, StepKind::sample, 0, 0),
                ElementsAre("AB = (-6, -8), AC = (3, -8), (0, 0) to A = (2, 5)",
                            "(-6, 3, 2) x (-8, -8, 5) = (31, 14, 72)",
                            "divided by 72: u = 31/72 of B, v = 7/36 of C, 1 - u - v = 3/8 of A"));
    const auto cross_at = [&](int x, int y) { return working(trace, StepKind::sample, x, y)[1]; };
    EXPECT_THAT(cross_at(-1, 1), HasSubstr(" = (36, 0, 72)"));
    EXPECT_THAT(cross_at(1, -3), HasSubstr(" = (32, 40, 72)"));
    EXPECT_THAT(cross_at(3, 2), HasSubstr(" = (1, 26, 72)"));
    EXPECT_THAT(cross_at(-1, 2), HasSubstr(" = (33, -6, 72)"));
    EXPECT_THAT(cross_at(4, 2), HasSubstr(" = (-7, 34, 72)"));
}

/// T0, figures 21 to 24 with their slips put right.
TEST(Working, OfAFace) {
    const Trace trace = example("t0-hidden/cube-culled.json");
    EXPECT_THAT(
        working(trace, StepKind::face, "ABC"),
        ElementsAre("A = (-1, 1, 3)", "B = (1, 1, 3)", "C = (1, -1, 3)", "B - A = (2, 0, 0)",
                    "C - A = (2, -2, 0)", "normal = (B - A) x (C - A)",
                    "= (0 (0) - 0 (-2), 0 (2) - 2 (0), 2 (-2) - 0 (2)) = (0, 0, -4)",
                    "centroid = (A + B + C) / 3 = (1/3, 1/3, 3)", "plane: 0 x + 0 y - 4 z + 12 = 0",
                    "normal . view = 0 (-1/3) + 0 (-1/3) + (-4) (-3) = 12",
                    "|normal| = 4, |view| = sqrt(83/9) = 3.036811",
                    "cosine = 12 / (|normal| |view|) = 0.987878, an angle of 8.93 degrees"));
}

/// CGFS: A at z = 2, B at z = 10. Halfway on the edge z is 6; along the row of the screen it would be 26/3.
TEST(Working, TheDepthOnThePlaneThroughTheCorners) {
    const Trace right = example("t0-hidden/middle-of-an-edge.json");
    EXPECT_THAT(working(right, StepKind::depth, 5, 0),
                ElementsAre("plane through the corners: depth = -1/15 x + 0 y + 1/2",
                            "depth = 1/6 (1/2) + 5/6 (1/10) + 0 (1/2) = 1/6",
                            "plane in camera space: -24 x + 0 y + 90 z - 180 = 0",
                            "seen at x' = 5/2, y' = 0 on the view plane z = d = 1",
                            "z = -d D / (A x' + B y' + d C) = 180 / ((-24) (5/2) + 0 (0) + 1 (90)) "
                            "= 6"));
    const Trace wrong = example("t0-hidden/middle-of-an-edge.json", Depth::linear_z);
    EXPECT_EQ(working(wrong, StepKind::depth, 5, 0).back(),
              "depth = 1/6 (2) + 5/6 (10) + 0 (2) = 26/3");
}

TEST(Working, EdgeFunctionsAtTheSamplesOfARow) {
    const Trace trace = example("t3-sweep-and-box/top-left.json");
    EXPECT_THAT(working(trace, StepKind::scanline, 0, 1),
                IsSupersetOf({"E of AC at (3/2, 3/2) = 8 (1/2) + (-8) (1/2) = 0: on a top or left "
                              "edge, inside",
                              "E of BC at (17/2, 3/2) = (-8) (-1/2) + 0 (1/2) = 4: > 0, inside"}));
}

/// T4: the view moves by -4, and projection x view x model takes an object to its place in clip space.
TEST(Working, OfMatricesAndVertices) {
    const Trace trace = example("t4-pipeline/six-spaces.json");
    EXPECT_THAT(
        working(trace, StepKind::matrix, "projection"),
        ElementsAre(
            "perspective:  [1 0 0 0]  [0 1 0 0]  [0 0 1 0]  [0 0 -1 1]",
            "translate:  [1 0 0 0]  [0 1 0 0]  [0 0 1 1]  [0 0 0 1]",
            "perspective x translate, row times column:", "1 (1), 0, 0, 0 = [1 0 0 0]",
            "0, 1 (1), 0, 0 = [0 1 0 0]", "0, 0, 1 (1), 1 (1) = [0 0 1 1]",
            "0, 0, (-1) (1), (-1) (1) + 1 (1) = [0 0 -1 0]",
            "projection x view x model, row times column:", "0, 1 (-1), 0, 1 (1) = [0 -1 0 1]",
            "1 (2), 0, 0, 0 = [2 0 0 0]", "0, 0, 1 (1), 1 (-4) + 1 (1) = [0 0 1 -3]",
            "0, 0, (-1) (1), (-1) (-4) = [0 0 -1 4]"));
    EXPECT_THAT(
        working(trace, StepKind::matrix, "viewport"),
        ElementsAre("scale:  [20 0 0 0]  [0 10 0 0]  [0 0 1 0]  [0 0 0 1]",
                    "translate:  [1 0 0 1]  [0 1 0 1]  [0 0 1 0]  [0 0 0 1]",
                    "flip:  [1 0 0 0]  [0 -1 0 0]  [0 0 1 0]  [0 0 0 1]",
                    "translate x flip, row times column:", "1 (1), 0, 0, 1 (1) = [1 0 0 1]",
                    "0, 1 (-1), 0, 1 (1) = [0 -1 0 1]", "0, 0, 1 (1), 0 = [0 0 1 0]",
                    "0, 0, 0, 1 (1) = [0 0 0 1]", "scale x translate x flip, row times column:",
                    "20 (1), 0, 0, 20 (1) = [20 0 0 20]", "0, 10 (-1), 0, 10 (1) = [0 -10 0 10]",
                    "0, 0, 1 (1), 0 = [0 0 1 0]", "0, 0, 0, 1 (1) = [0 0 0 1]"));
    EXPECT_THAT(working(trace, StepKind::vertex, "A", "camera"),
                ElementsAre("x = 1 (0) + 0 (2) + 0 (1) + 0 (1) = 0",
                            "y = 0 (0) + 1 (2) + 0 (1) + 0 (1) = 2",
                            "z = 0 (0) + 0 (2) + 1 (1) + (-4) (1) = -3"));
    // (1, 1, 1): -1 + 1, 2, 1 - 3, -1 + 4.
    EXPECT_EQ(working(trace, StepKind::vertex, "A", "clip").back(),
              "at once: projection x view x model times (1, 1, 1) = (0, 2, -2, 3)");
    EXPECT_THAT(working(trace, StepKind::vertex, "A", "canonical"),
                ElementsAre("x = 0 / 3 = 0", "y = 2 / 3 = 2/3", "z = -2 / 3 = -2/3"));
}

/// T4's camera at (0, 0, 4), and one whose lengths are no fractions: d = (1, 2, 3), up x d = (0, -3, 2)
/// for an up of (1, 0, 0), d x (up x d) = (2 (2) - 3 (-3), 3 (0) - 1 (2), 1 (-3) - 2 (0)).
TEST(Working, TheAxesOfACamera) {
    EXPECT_THAT(
        working(example("t4-pipeline/six-spaces.json"), StepKind::matrix, "view"),
        IsSupersetOf(Working{
            "d = p - l = (0, 0, 4) - (0, 0, 0) = (0, 0, 4), |d| = 4",
            "up x d = (1 (4) - 0 (0), 0 (0) - 0 (4), 0 (0) - 1 (0))", "= (4, 0, 0), |up x d| = 4",
            "d x (up x d) = (0 (0) - 4 (0), 4 (4) - 0 (0), 0 (0) - 0 (4))",
            "= (0, 16, 0), |d x (up x d)| = 16", "x = (up x d) / |up x d| = (1, 0, 0)",
            "y = d x (up x d) / |d x (up x d)| = (0, 1, 0)", "z = d / |d| = (0, 0, 1)",
            "rotate:  [1 0 0 0]  [0 1 0 0]  [0 0 1 0]  [0 0 0 1]",
            "translate:  [1 0 0 0]  [0 1 0 0]  [0 0 1 -4]  [0 0 0 1]"}));
    const auto camera_of =
        [](const std::string& projection) {
            return working(trace_of(scene_in(R"({
  "canvas": {"width": 9, "height": 9},
  "vertices": {"A": [0, 0, 0], "B": [1, 0, 0], "C": [0, 1, 0]},
  "triangles": ["ABC"],
  "camera": {"position": [1, 2, 4], "look_at": [0, 0, 1], "up": [1, 0, 0]},
  "method": {"scalar": "double"},
  "projection": {"type": ")" + projection + R"(", "distance": 1}})")),
                           StepKind::matrix, "view");
        };
    EXPECT_THAT(camera_of("view-plane"),
                IsSupersetOf(Working{
                    "d = p - l = (1, 2, 4) - (0, 0, 1) = (1, 2, 3), |d| = sqrt(14) = 3.741657",
                    "= (0, -3, 2), |up x d| = sqrt(13) = 3.605551",
                    "= (13, -2, -3), |d x (up x d)| = sqrt(182) = 13.490738",
                    "z = d / |d| = (0.2672612, 0.5345225, 0.8017837)"}));
    // It turns what it sees: x is y cross z.
    EXPECT_THAT(camera_of("pinhole"),
                IsSupersetOf(Working{"x = -(up x d) / |up x d| = (0, 0.8320503, -0.5547002)",
                                     "z = -d / |d| = (-0.2672612, -0.5345225, -0.8017837)"}));
}

TEST(Working, DepthsAtRoundedEndsAndOnALine) {
    const std::string scene = R"({
  "canvas": {"width": 8, "height": 6, "origin": "bottom-left"},
  "vertices": {"A": [0, 0, 2], "B": ["13/2", 0, 8], "C": [0, 4, 2], "D": [1, 2, 3], "E": [5, 2, 1]},
  "triangles": ["ABC", "ABC"], "lines": ["DE"],
  "method": {"scalar": "exact", "depth": "linear-z", "depth_at": "rounded-ends"}})";
    // Row y = 0, from (0, z 2) to (13/2, z 8): its last pixel is 6, so depth grows by 1, not by 12/13.
    const Trace trace = trace_of(scene_in(scene));
    EXPECT_THAT(working(trace, StepKind::scanline, 0, 0),
                Contains("depth = 2 + (8 - 2) / (6 - 0) (x - 0) = 2 + 1 (x - 0)"));
    // The line's point at x = 2 is a quarter of its way from z = 3 to z = 1.
    const std::size_t line = step_of(trace, [](const StepView& step) {
        return step.kind() == StepKind::primitive &&
               step.as<PrimitiveStep>().kind == PrimitiveKind::line;
    });
    for (std::size_t n = line; n <= trace.size(); ++n)
        if (trace.kind_of(n) == StepKind::depth && x_in(trace.step(n)) == 2) {
            EXPECT_THAT(working(trace, n), Contains("depth = 3 + (1 - 3) (2 - 1) / (5 - 1) = 5/2"));
        }
}

/// The sides of an outline, and the lines of a fan, have increments as lines have.
TEST(Working, BresenhamOnSidesAndInFans) {
    EXPECT_THAT(working(example("t2-lines/outline.json"), StepKind::decide, 2, 5),
                ElementsAre("dx = 6, dy = 8: d begins at 2 dx - dy = 4",
                            "straight on adds 2 dx = 12, diagonally 2 (dx - dy) = -4",
                            "next d = 4 - 4 = 0"));
    EXPECT_THAT(working(example("t4-fan/first-triangle.json"), StepKind::decide, -4, -3),
                ElementsAre("dx = 9, dy = 0: d begins at 2 dy - dx = -9",
                            "straight on adds 2 dy = 0, diagonally 2 (dy - dx) = -18",
                            "next d = -9 + 0 = -9"));
}

TEST(Working, ADdaLineAddsToTheLast) {
    const Trace trace = example("t2-lines/dda.json");
    const auto along = [&](int x) {
        return working(trace, step_of(trace,
                                      [x](const StepView& step) {
                                          return step.kind() == StepKind::along &&
                                                 step.as<AlongStep>().x == x;
                                      }))
            .back();
    };
    EXPECT_EQ(along(0), "y = m x + b = 3/7 (0) + 0 = 0");
    EXPECT_EQ(along(2), "y = the last one + m = 3/7 + 3/7 = 6/7");
    EXPECT_THAT(working(trace, StepKind::pixel, 2, 1),
                Contains("y = the last one + m = 3/7 + 3/7 = 6/7"));
}

/// T0's first LERP, of the depths of an edge: 17/75 at y = 1 between 1/3 and 1/5.
TEST(Working, TheDepthsAtTheEndsOfARow) {
    const Trace trace = example("t0-hidden/cube-inverse-z.json");
    const std::size_t row = step_of(trace, [](const StepView& step) {
        return step.kind() == StepKind::scanline &&
               step.as<ScanlineStep>().right_depth.text() == "17/75";
    });
    EXPECT_THAT(working(trace, row), Contains(HasSubstr("  depth = 1/5 + ")));
    EXPECT_THAT(working(trace, row), Contains("  depth per row on BG: (d2 - d1)/(y2 - y1) = "
                                              "(1/5 - 1/3)/(-2 - 3) = 2/75"));
    Scene adding = scene_in(example_text("t0-hidden/cube-inverse-z.json"));
    adding.method.lerp = LerpForm::incremental;
    EXPECT_THAT(working(trace_of(adding), row), Contains(HasSubstr("  depth per row on BG: ")));
    EXPECT_THAT(working(trace, row), Contains(::testing::EndsWith(" = 17/75")));
}

/// T2: index = 4 (512 y + x).
TEST(Working, WhereAPixelLiesInMemory) {
    Scene scene = triangle_scene({"0", "0", "511", "511", "0", "1"},
                                 {.width = 512, .height = 512, .origin = Origin::top_left});
    const auto address_of = [&](int x, int y) {
        scene.primitives = {{.kind = PrimitiveKind::point, .name = "A", .vertices = {0}}};
        scene.vertices[0].x = Number(x);
        scene.vertices[0].y = Number(y);
        return working(trace_of(scene), StepKind::pixel, x, y).back();
    };
    EXPECT_THAT(address_of(0, 0), HasSubstr(" byte 4 (512 (0) + 0) = 0"));
    EXPECT_THAT(address_of(1, 0), HasSubstr(" = 4"));
    EXPECT_THAT(address_of(0, 1), HasSubstr(" = 2048"));
    EXPECT_THAT(address_of(511, 511), HasSubstr(" = 1048572"));
}

/// What does not lead to the number that the trace tells is not claimed.
TEST(Working, LeavesOutWhatTheTraceContradicts) {
    std::string text = trace_text(first_triangle());
    const std::string told = R"("y":2,"left":"-1/4")";
    text.replace(text.find(told), told.size(), R"("y":2,"left":"-1/3")");
    const Trace trace = readable_trace(text);
    const Working row = working(trace, StepKind::scanline, 0, 2);
    EXPECT_THAT(row, Not(Contains(HasSubstr("left AB:"))));
    EXPECT_THAT(row, Contains(HasSubstr("(2 - 5) + 2 = (-3/8) (-3) + 2 = 25/8")));
}

/// A trace of some steps, or one that was edited, has what it has.
TEST(Working, OfStepsWithoutWhatTheyReferTo) {
    const std::string triangle = R"({"step":"primitive","kind":"triangle","name":"ABC",)"
                                 R"("at":[[0,0],[4,0],[0,4]],"depths":[1,2,3]})"
                                 "\n";
    const std::string steps =
        R"({"step":"edge","edge":"AB","dx_dy":1,"a":1,"b":2}
{"step":"scanline","y":1,"left":0,"right":3,"from":0,"to":3,"left_edge":"AC","right_edge":"BC"}
{"step":"sample","x":1,"y":1,"weights":[1,0,0],"inside":true}
{"step":"depth","x":1,"y":1,"depth":1,"pass":true}
{"step":"pixel","x":1,"y":1}
{"step":"decide","x":1,"y":1,"d":3,"move":"E"}
{"step":"along","x":1,"value":1,"pixel":1}
{"step":"face","normal":[1e200,0,1e200],"view":[1e200,0,0],"dot":0}
{"step":"face","normal":["1/3"],"view":[],"dot":0}
{"step":"light","normal":[1e-200,0,0],"light":[1e-200,0,0],"intensity":1}
{"step":"matrix","name":"view","rows":[[1,2],[3]]}
{"step":"order","names":["A","B"],"distances":[1]}
{"step":"primitive","kind":"line","name":"AB","at":[[0,0],[5,2]],"colors":["#000000","#ffffff"]}
{"step":"pixel","x":1,"y":0,"color":"#333333"}
)";
    const std::string header = R"({"rastertrace":1,"canvas":{"width":8,"height":8}})"
                               "\n";
    for (const std::string& text : {header + steps, header + triangle + steps}) {
        const Trace trace = readable_trace(text);
        for (std::size_t n = 1; n <= trace.size(); ++n)
            for (const std::string& line : working(trace, n)) {
                EXPECT_THAT(line, Not(HasSubstr("nan"))) << n;
                EXPECT_THAT(line, Not(HasSubstr("inf"))) << n;
            }
    }
}

/// A matrix of more factors than any scene has is not multiplied out; nor is one that they do not make.
TEST(Working, OfFactorsThatAreNone) {
    const auto lines_of = [](std::size_t factors, const std::string& corner) {
        std::string names, rows;
        for (std::size_t i = 0; i < factors; ++i) {
            names += std::string(i == 0 ? "" : ",") + R"("scale")";
            rows += std::string(i == 0 ? "" : ",") + "[" + corner +
                    ",0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]";
        }
        return working(
            readable_trace(
                R"({"rastertrace":1,"canvas":{"width":8,"height":8}})"
                "\n"
                R"({"step":"matrix","name":"model","rows":[[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0,1]],)"
                R"("factors":[)" +
                names + R"(],"factor_rows":[)" + rows + "]}\n"),
            1);
    };
    EXPECT_EQ(lines_of(2, "1").size(), 7u);
    EXPECT_EQ(lines_of(9, "1").size(), 9u); // too many to multiply on the page
    EXPECT_THAT(lines_of(2, "2"), ElementsAre());
    EXPECT_THAT(lines_of(100'000, "1"), ElementsAre());
}

/// The models of two objects are no factors of one product.
TEST(Working, MatricesOfSeveralObjectsAreNotMultiplied) {
    const Trace trace = trace_of(scene_in(R"({
  "canvas": {"width": 9, "height": 9},
  "meshes": [
    {"vertices": {"A": [0, 0, 0], "B": [1, 0, 0], "C": [0, 1, 0]}, "faces": ["ABC"], "model": [{"translate": [0, 0, 4]}]},
    {"vertices": {"D": [0, 0, 0], "E": [1, 0, 0], "F": [0, 1, 0]}, "faces": ["DEF"], "model": [{"translate": [0, 0, 5]}]}],
  "projection": {"type": "pinhole", "distance": 1}})"));
    EXPECT_THAT(working(trace, StepKind::matrix, "projection"), ElementsAre());
}

/// The d that a sentence and a working promise is the one that the next step tells.
RC_GTEST_PROP(Working, BresenhamsNextDIsTheNextD, ()) {
    const auto side = [] { return *rc::gen::inRange(0, 30); };
    const std::vector<std::string> ends{std::to_string(side()),
                                        std::to_string(side()),
                                        std::to_string(side()),
                                        std::to_string(side()),
                                        "0",
                                        "0"};
    Scene scene = triangle_scene(ends, {.width = 30, .height = 30, .origin = Origin::bottom_left});
    scene.vertices.pop_back();
    scene.primitives[0] = {.kind = PrimitiveKind::line, .name = "AB", .vertices = {0, 1}};
    const Trace trace = trace_of(scene);
    std::string promised;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        if (trace.kind_of(n) != StepKind::decide)
            continue;
        const std::string d = trace.step(n).as<DecideStep>().d.text();
        RC_ASSERT(promised.empty() || promised == d);
        Replay replay(trace);
        replay.go_to(n);
        const std::string sentence = describe_step(replay);
        promised = sentence.substr(sentence.rfind("= ") + 2);
        const std::string line = working_of(replay).back();
        RC_ASSERT(line.substr(line.rfind("= ") + 2) == promised);
    }
}

TEST(Working, NewellsNormalEdgeByEdge) {
    const Trace trace = trace_of(scene_in(
        R"({"meshes":[{"vertices":{"A":[0,0,1],"B":[4,0,1],"C":[1,1,1],"D":[0,4,1]},
            "faces":["ABCD"]}],"method":{"scalar":"exact"},"canvas":{"width":9,"height":9}})"));
    EXPECT_THAT(
        working(trace, 1),
        ElementsAre("A to B: ((0 - 0) (1 + 1), (1 - 1) (0 + 4), (0 - 4) (0 + 0)) = (0, 0, 0)",
                    "B to C: ((0 - 1) (1 + 1), (1 - 1) (4 + 1), (4 - 1) (0 + 1)) = (-2, 0, 3)",
                    "C to D: ((1 - 4) (1 + 1), (1 - 1) (1 + 0), (1 - 0) (1 + 4)) = (-6, 0, 5)",
                    "D to A: ((4 - 0) (1 + 1), (1 - 1) (0 + 0), (0 - 0) (4 + 0)) = (8, 0, 0)",
                    "normal = the sum of these = (0, 0, 8), of length 8: twice the area",
                    "largest in z: the face is seen without it"));
}

/// T2's octants: by the signs of dx and dy, and which of them is longer.
TEST(Working, WhyALineIsOfItsOctant) {
    const Trace octants = example("t2-lines/octants.json");
    EXPECT_THAT(working(octants, StepKind::primitive, "O3"),
                ElementsAre("(0, 0) to (-2, 5): dx = -2 < 0, dy = 5 >= 0, |dx| < |dy|: octant 3"));
    EXPECT_THAT(working(octants, StepKind::primitive, "O8"),
                ElementsAre("(0, 0) to (5, -2): dx = 5 >= 0, dy = -2 < 0, |dx| >= |dy|: octant 8"));
    const Trace outline = example("t2-lines/outline.json");
    const std::size_t side = step_of(outline, [](const StepView& step) {
        return step.kind() == StepKind::edge && step.as<EdgeStep>().octant.has_value();
    });
    EXPECT_EQ(working(outline, side).back(),
              "(2, 5) to (-4, -3): dx = -6 < 0, dy = -8 < 0, |dx| < |dy|: octant 6");
    EXPECT_THAT(working(colored_line("0, 0", "0, 5", ""), 1),
                ElementsAre("(0, 0) to (0, 5): dx = 0 >= 0, dy = 5 >= 0, |dx| < |dy|: octant 2"));
    // From the end with the lower y, between the pixels of the ends.
    EXPECT_THAT(working(colored_line("2.5, 5", "4.4, 0", R"("from": "low")"), 1),
                ElementsAre("(4, 0) to (3, 5): dx = -1 < 0, dy = 5 >= 0, |dx| < |dy|: octant 3"));
}

/// T0's line AB, x = (3 y - 7) / 4.
TEST(Working, ALineThroughTwoPoints) {
    const Trace trace = trace_of(scene_in(R"({
  "canvas": {"width": 17, "height": 14},
  "vertices": {"A": [2, 5], "B": [-4, -3], "C": [7, 3], "D": [0, 0]},
  "lines": ["AB", "DC"], "method": {"line": "naive", "scalar": "exact"}})"));
    EXPECT_THAT(working(trace, StepKind::along, 0, 1),
                ElementsAre("x = m y + b at both ends: 2 = m (5) + b, -4 = m (-3) + b",
                            "m = (x2 - x1)/(y2 - y1) = (-4 - 2)/(-3 - 5) = 3/4, "
                            "b = x1 - m y1 = 2 - 3/4 (5) = -7/4",
                            "x = m y + b = 3/4 (1) - 7/4 = -1"));
    EXPECT_THAT(working(trace, step_of(trace,
                                       [](const StepView& step) {
                                           return step.kind() == StepKind::along &&
                                                  step.as<AlongStep>().x == 2;
                                       })),
                ElementsAre("y = m x + b at both ends: 0 = m (0) + b, 3 = m (7) + b",
                            "m = (y2 - y1)/(x2 - x1) = (3 - 0)/(7 - 0) = 3/7, "
                            "b = y1 - m x1 = 0 - 3/7 (0) = 0",
                            "y = m x + b = 3/7 (2) + 0 = 6/7"));
}

/// T3: boundary A is t0t2, boundary B t0t1, then t1t2; t0 is the lowest vertex of the picture.
TEST(Working, TheBoundariesOfALineSweep) {
    const std::string below = "t0, t1, t2 = A, B, C from below: left CA = t0t2 is boundary A, ";
    const Trace trace = example("t3-sweep-and-box/two-halves.json");
    EXPECT_THAT(working(trace, StepKind::scanline, 0, -2),
                Contains(below + "right BA = t0t1 is boundary B"));
    EXPECT_THAT(working(trace, StepKind::scanline, 0, 3),
                Contains(below + "right CB = t1t2 is boundary B"));
    Scene upside_down = triangle_scene({"1", "1", "11", "4", "5", "10"},
                                       {.width = 13, .height = 11, .origin = Origin::top_left});
    upside_down.method.fill = Fill::two_halves;
    EXPECT_THAT(working(trace_of(upside_down), StepKind::scanline, 0, 2),
                Contains("t0, t1, t2 = C, B, A from below: left AC = t0t2 is boundary A, right AB "
                         "= t1t2 is boundary B"));
    upside_down.method.fill = Fill::scanline;
    EXPECT_THAT(working(trace_of(upside_down), StepKind::scanline, 0, 2),
                Not(Contains(HasSubstr("boundary"))));
}

/// A frustum's near plane is w = 1: the edge from B (w 2) to C (w -2) is cut after 1/4 of it. At 4096 half canvases
/// lies the right plane, half of the way to 8192.
TEST(Working, WhereAnEdgeMeetsAPlane) {
    const Trace wing = example("t4-pipeline/behind-the-eye.json");
    EXPECT_THAT(working(wing, StepKind::vertex, "wing:1", "clip"),
                ElementsAre("near plane: d = w - 1, inside where d >= 0",
                            "B: d1 = 2 - 1 = 1, C: d2 = -2 - 1 = -3",
                            "t = d1/(d1 - d2) = 1 / (1 + 3) = 1/4", "wing:1 = B + t (C - B):",
                            "x = -1 + 1/4 (1 + 1) = -1/2", "y = -1 + 1/4 (-1 + 1) = -1",
                            "z = 1/8 + 1/4 (-35/8 - 1/8) = -1", "w = 2 + 1/4 (-2 - 2) = 1"));
    const Trace beside = trace_of(scene_in(R"({
  "canvas": {"width": 9, "height": 9},
  "vertices": {"A": [0, 0, 0], "B": [8192, 2, 0]}, "lines": ["AB"],
  "projection": {"type": "orthographic", "left": -1, "right": 1, "bottom": -1, "top": 1},
  "method": {"scalar": "exact"}})"));
    EXPECT_THAT(working(beside, StepKind::vertex, "AB:1", "clip"),
                ElementsAre("right plane: d = -x + 4096 w, inside where d >= 0",
                            "A: d1 = (-1) (0) + 4096 (1) = 4096, B: d2 = (-1) (8192) + 4096 (1) = "
                            "-4096",
                            "t = d1/(d1 - d2) = 4096 / (4096 + 4096) = 1/2",
                            "AB:1 = A + t (B - A):", "x = 0 + 1/2 (8192 - 0) = 4096",
                            "y = 0 + 1/2 (2 - 0) = 1", "z = 0 + 1/2 (0 - 0) = 0",
                            "w = 1 + 1/2 (1 - 1) = 1"));
    // A canvas of 6 rows, 2 pixels per unit: half of it is 3/2 from the middle. The sides of an outline are cut one by
    // one.
    const Trace above = trace_of(scene_in(R"({
  "canvas": {"width": 8, "height": 6},
  "vertices": {"A": [0, 0, 1], "B": [0, 12288, 1], "C": [0, 0, -1], "D": [1, 0, 1]},
  "lines": ["AB"], "outlines": ["ACD"],
  "projection": {"type": "pinhole", "distance": 1, "near": "1/2"},
  "viewport": {"pixels_per_unit": 2}, "method": {"scalar": "exact"}})"));
    EXPECT_THAT(working(above, StepKind::vertex, "AB:1", "clip"),
                IsSupersetOf(Working{"top plane: d = -y + 6144 w, inside where d >= 0",
                                     "y = 0 + 1/2 (12288 - 0) = 6144"}));
    EXPECT_THAT(working(above, StepKind::vertex, "ACD:2", "clip"),
                IsSupersetOf(Working{"near plane: d = w - 1/2, inside where d >= 0",
                                     "t = d1/(d1 - d2) = (1/2) / (1/2 + 3/2) = 1/4",
                                     "ACD:2 = D + t (C - D):", "x = 1 + 1/4 (0 - 1) = 3/4"}));
}

/// What a working writes agrees with what is told, or it would not be there: of every scene.
TEST(Working, IsThereForEveryStepOfARandomScene) {
    std::map<std::string, int> worked_out;
    for (std::uint64_t seed = 1; seed <= random_cases(400u); ++seed) {
        auto read = read_scene({"scene.json", RandomScene(seed).text()});
        if (!read)
            continue;
        Scene scene = read.value().scene;
        scene.method.scalar = ScalarKind::exact;
        const Trace trace = trace_of(scene);
        Replay replay(trace);
        std::size_t planes = 0;
        const auto expect = [&](const std::string& part) {
            EXPECT_THAT(working_of(replay), Contains(HasSubstr(part)))
                << seed << " " << replay.step();
            ++worked_out[part];
        };
        for (std::size_t n = 1; n <= trace.size(); ++n) {
            replay.go_to(n);
            const StepView step = trace.step(n);
            const auto kind = trace.kind_of(n);
            if (kind == StepKind::primitive && step.as<PrimitiveStep>().octant)
                expect(fmt::format(": octant {}", *step.as<PrimitiveStep>().octant));
            if (kind == StepKind::edge && step.as<EdgeStep>().octant)
                expect(fmt::format(": octant {}", *step.as<EdgeStep>().octant));
            if (kind == StepKind::scanline && scene.method.fill == Fill::two_halves &&
                primitive_of(replay).kind == PrimitiveKind::triangle) {
                expect("t0t2 is boundary A");
                expect("is boundary B");
            }
            if (kind == StepKind::scanline)
                for (const EndOfRow& end : ends_of(step.as<ScanlineStep>())) {
                    const auto ends = ends_of_edge(primitive_of(replay), end.edge.text());
                    const auto depths = primitive_of(replay).depths.texts();
                    if (end.depth && ends && ends->from[1] != ends->to[1] &&
                        depths[ends->vertices[0]] != depths[ends->vertices[1]])
                        expect("  depth per row on " + end.edge.text() + ": ");
                }
            const auto line =
                kind == StepKind::along ? ends_of_line(replay, primitive_of(replay)) : std::nullopt;
            if (line && (line->from.x != line->to.x || line->from.y != line->to.y))
                expect(" + b at both ends: ");
            if (kind == StepKind::matrix && step.as<MatrixStep>().factors.texts().size() > 1)
                expect(", row times column:");
            if (kind == StepKind::clip)
                planes = trace.kind_of(n - 1) == StepKind::clip ? planes + 1 : 1;
            if (kind == StepKind::vertex && planes == 1 && replay.primitive() != 0 &&
                step.as<VertexStep>().space == Space::clip)
                expect("t = d1/(d1 - d2) = ");
        }
    }
    for (const std::string part :
         {": octant 1", ": octant 6", "t0t2 is boundary A", "t = d1/(d1 - d2) = "})
        EXPECT_GT(worked_out[part], 0) << part;
}

/// Each channel that differs at the ends of a side, or of a line of the fan, leads to the level that is told.
RC_GTEST_PROP(Working, TheColorsOfOutlinesAndFansAreAlwaysExplained, ()) {
    const auto point = [] {
        return fmt::format("[{}.{}, {}]", *rc::gen::inRange(0, 30), *rc::gen::inRange(0, 10),
                           *rc::gen::inRange(0, 30));
    };
    const bool is_fan = *rc::gen::arbitrary<bool>();
    const Trace trace = trace_of(scene_in(fmt::format(
        R"({{"canvas": {{"width": 32, "height": 32, "origin": "bottom-left"}},
"vertices": {{"A": {}, "B": {}, "C": {}}}, "colors": {{"A": "#102030", "B": "#5060c7", "C": "#f8f9fa"}},
"{}": ["ABC"], "method": {{"color_lerp": "{}", {}}}}})",
        point(), point(), point(), is_fan ? "triangles" : "outlines",
        *rc::gen::element<std::string>("axis", "distance"),
        is_fan ? R"("fill": "fan")"
               : fmt::format(R"("line": "{}", "from": "{}")",
                             *rc::gen::element<std::string>("bresenham", "naive", "dda"),
                             *rc::gen::element<std::string>("first", "low")))));
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        Replay replay(trace);
        if (trace.kind_of(n) != StepKind::pixel)
            continue;
        replay.go_to(n);
        const auto line = color_on_line(replay, primitive_of(replay));
        const auto color = trace.step(n).as<PixelStep>().color.color();
        if (!line || !color)
            continue; // the line is one pixel
        const Working lines = working_of(replay);
        RC_ASSERT(std::any_of(lines.begin(), lines.end(), [&](const std::string& one) {
            return one.starts_with("red = ") && one.ends_with(fmt::format(" -> {}", color->red()));
        }));
    }
}

} // namespace
} // namespace rastertrace
