// SPDX-License-Identifier: MIT
// Each matcher, seen to fail: the whole message, as a reader of a failed test sees it. Numbers and words are those of
// docs/explain.md, and of T0's worked triangle.

#include "failures.h"
#include "picture.h"

#include <rastertrace/testing.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using namespace matchers;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// The trace of an example, under its short name.
TestedTrace example(const std::string& name) {
    TestedTrace trace = trace_in(std::string(RASTERTRACE_EXAMPLES) + "/" + name + ".json");
    trace.name = name;
    return trace;
}

/// What GoogleTest says of a trace: its name, how many steps it has, and of which type it is.
std::string told(const std::string& name, int steps) {
    return "  Actual: " + name + ", " + std::to_string(steps) +
           " steps (of type rastertrace::matchers::TestedTrace), ";
}

/// That a trace does not meet a matcher, and the whole of what is said then: what was expected, of which trace, and why.
void expect_failure(const TestedTrace& trace, const TraceMatcher& matcher,
                    const std::string& expected, const std::string& told, const std::string& why) {
    EXPECT_EQ(failures_of([&] { EXPECT_THAT(trace, matcher); }),
              "Value of: trace\nExpected: " + expected + "\n" + told + why);
}

const std::string of_first_triangle = told("t0-fill/first-triangle", 62);

TEST(PlotsPixel, IsMetByAPixelThatIsPlotted) {
    const TestedTrace trace = example("t0-fill/first-triangle");
    EXPECT_THAT(trace, PlotsPixel(3, 2));
    EXPECT_THAT(trace, PlotsPixel(3, 2, In("ABC")));
    EXPECT_THAT(trace, AllOf(Not(PlotsPixel(4, 2)), Not(PlotsPixel(4, 2, In("ABC")))));
}

TEST(PlotsPixel, SaysWhyAPixelIsNotPlotted) {
    const TestedTrace trace = example("t0-fill/first-triangle");
    expect_failure(trace, PlotsPixel(4, 2), "plots pixel (4, 2)", of_first_triangle,
                   R"(pixel (4, 2): not drawn: ABC does not cover it
  ABC: outside: AC ends row y=2 at x = 25/8 -> floor -> 3; x = 4 lies beyond it by 7/8
      right AC: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (5 - 2)/(-3 - 5) (2 - 5) + 2 = (-3/8) (-3) + 2 = 25/8 -> floor -> 3
)");
}

TEST(PlotsPixel, SaysWhyAPixelIsPlotted) {
    const TestedTrace trace = example("t0-fill/first-triangle");
    expect_failure(trace, Not(PlotsPixel(3, 2)), "does not plot pixel (3, 2)", of_first_triangle,
                   R"(pixel (3, 2) is plotted
  step 19: pixel (3, 2)   row y=2: -1 to 3
      because of step 14
      left AB: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (-4 - 2)/(-3 - 5) (2 - 5) + 2 = 3/4 (-3) + 2 = -1/4 -> floor -> -1
      right AC: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (5 - 2)/(-3 - 5) (2 - 5) + 2 = (-3/8) (-3) + 2 = 25/8 -> floor -> 3
      -1/4 < 25/8: AB is left, AC is right
      x = -1 to 3: 3 - (-1) + 1 = 5 pixels
      column 11, row 5 from the top left: byte 4 (17 (5) + 11) = 384
)");
}

TEST(PlotsPixel, AsksTheSceneDrawnByAnotherMethod) {
    const std::string path = std::string(RASTERTRACE_EXAMPLES) + "/t0-fill/first-triangle.json";
    EXPECT_THAT(trace_in(path), PlotsPixel(-1, 2));
    EXPECT_THAT(trace_in(path, {{"rounding", "truncate"}}), Not(PlotsPixel(-1, 2)));
}

TEST(PlotsPixel, OfOnePrimitiveCountsWhatIsDrawnOverLater) {
    const TestedTrace trace = example("t0-hidden/two-depths");
    EXPECT_THAT(trace, AllOf(PlotsPixel(3, 2, In("ABC")), PlotsPixel(3, 2, In("DEF"))));
    EXPECT_THAT(trace, AllOf(PlotsPixel(1, 2, In("ABC")), Not(PlotsPixel(1, 2, In("DEF")))));
}

TEST(PlotsPixel, OfOnePrimitiveSaysWhyThisOneDoesNot) {
    const TestedTrace trace = example("t0-hidden/two-depths");
    expect_failure(trace, PlotsPixel(1, 2, In("DEF")), "plots pixel (1, 2) in DEF",
                   told("t0-hidden/two-depths", 100), R"(pixel (1, 2): drawn by ABC at step 37
  DEF: outside: DF begins row y=2 at x = 2 -> floor -> 2; x = 1 lies before it by 1
      left DF: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (2 - 2)/(4 - 1) (2 - 1) + 2 = 0 (1) + 2 = 2 -> floor -> 2
)");
}

TEST(HasScanline, ComparesByValue) {
    const TestedTrace trace = example("t0-fill/first-triangle");
    EXPECT_THAT(trace, AllOf(HasScanline(2, "-1/4", "25/8"), HasScanline(2, -0.25, 3.125),
                             HasScanline(2, "-0.25", "50/16", In("ABC")), HasScanline(5, 2, 2U)));
    EXPECT_THAT(trace,
                AllOf(Not(HasScanline(2, "-1/4", "24/8")), Not(HasScanline(2, "1/4", "25/8")),
                      Not(HasScanline(2, "-1/4", "25/8000001"))));
}

TEST(HasScanline, TakesWhatIsAboutTheNumber) {
    const TestedTrace trace = example("t0-fill/first-triangle");
    EXPECT_THAT(trace, HasScanline(2, about(-0.26, 0.01), about("3.12500001", 1e-7)));
    EXPECT_THAT(trace, Not(HasScanline(2, -0.25, about("3.12500001", 1e-9))));
}

// A float that was written by another program is the decimal it stands for.
TEST(HasScanline, TakesADoubleAsItsShortestDecimal) {
    const TestedTrace trace = trace_from(
        {"mine",
         R"({"rastertrace":1,"canvas":{"width":4,"height":4,"origin":"top-left"},"method":{}}
{"step":"primitive","kind":"triangle","name":"ABC","vertices":["A","B","C"],"color":"#000000"}
{"step":"scanline","y":1,"left":0.1,"right":1e-7,"from":1,"to":0,"left_edge":"AB","right_edge":"AC"}
{"end":{"steps":2}}
)"});
    EXPECT_THAT(trace, AllOf(HasScanline(1, 0.1, 1e-7), HasScanline(1, 0.1F, 1e-7F),
                             HasScanline(1, "1/10", "0.0000001")));
}

TEST(HasScanline, SaysWhichRowThereIs) {
    const TestedTrace trace = example("t0-fill/first-triangle");
    const std::string row = R"(row y=2 is
  step 14: scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor -> -1   right AC: x = 2 - 3/8 (2 - 5) = 25/8 -> floor -> 3
      left AB: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (-4 - 2)/(-3 - 5) (2 - 5) + 2 = 3/4 (-3) + 2 = -1/4 -> floor -> -1
      right AC: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (5 - 2)/(-3 - 5) (2 - 5) + 2 = (-3/8) (-3) + 2 = 25/8 -> floor -> 3
      -1/4 < 25/8: AB is left, AC is right
      x = -1 to 3: 3 - (-1) + 1 = 5 pixels
)";
    expect_failure(trace, HasScanline(2, "-1/4", about(3, 0.01)),
                   "has scanline y=2 from -1/4 to 3 +- 0.01", of_first_triangle, row);
    expect_failure(trace, Not(HasScanline(2, "-1/4", 3.125)),
                   "does not have scanline y=2 from -1/4 to 3.125", of_first_triangle, row);
    expect_failure(trace, HasScanline(6, 0, 0, In("ABC")), "has scanline y=6 from 0 to 0 in ABC",
                   of_first_triangle, "no primitive has the row y=6\n");
}

TEST(CullsFace, SaysHowTheDotProductComesOut) {
    const TestedTrace trace = example("t0-hidden/cube-culled");
    EXPECT_THAT(trace, AllOf(CullsFace("ADE"), Not(CullsFace("ABC"))));
    expect_failure(trace, Not(CullsFace("ADE")), "does not cull face ADE",
                   told("t0-hidden/cube-culled", 235), R"(the test is
  step 213: face ADE: normal (-4, 0, 0) . to eye (1, -1/3, -11/3) = -4, cosine -0.262111 (105.20 degrees): culled
      A = (-1, 1, 3)
      D = (-1, -1, 3)
      E = (-1, 1, 5)
      D - A = (0, -2, 0)
      E - A = (0, 0, 2)
      normal = (D - A) x (E - A)
      = ((-2) (2) - 0 (0), 0 (0) - 0 (2), 0 (0) - (-2) (0)) = (-4, 0, 0)
      centroid = (A + D + E) / 3 = (-1, 1/3, 11/3)
      plane: -4 x + 0 y + 0 z - 4 = 0
      normal . view = (-4) (1) + 0 (-1/3) + 0 (-11/3) = -4
      |normal| = 4, |view| = sqrt(131/9) = 3.815174
      cosine = -4 / (|normal| |view|) = -0.262111, an angle of 105.20 degrees
)");
}

TEST(CullsFace, IsNotMetWhereNoFaceIsTested) {
    const TestedTrace trace = example("t0-fill/first-triangle");
    EXPECT_THAT(trace, Not(CullsFace("ABC")));
    expect_failure(trace, CullsFace("ABC"), "culls face ABC", of_first_triangle,
                   "the trace does not test this face\n");
}

TEST(DecidesByItsNumbers, TellsTheFirstDecisionThatIsAnotherOne) {
    EXPECT_THAT(example("t0-fill/first-triangle"), DecidesByItsNumbers());
    const TestedTrace fast = trace_in(std::string(RASTERTRACE_EXAMPLES) + "/regression/fast.jsonl");
    EXPECT_THAT(fast, Not(DecidesByItsNumbers()));
    // The row's left end is -1/4, whose floor is -1.
    EXPECT_THAT(failures_of([&] { EXPECT_THAT(fast, DecidesByItsNumbers()); }),
                AllOf(HasSubstr("decides by its numbers"),
                      HasSubstr("fast.jsonl:12:60: expected -1 for scanline: from"),
                      HasSubstr("found 0; 3 more values are not what their numbers give")));
}

/// The first failure that a matcher reports for a trace.
std::string first_failure(const TestedTrace& trace, const TraceMatcher& matcher) {
    const std::string text = failures_of([&] { EXPECT_THAT(trace, matcher); });
    return text.substr(0, text.find("\nValue of"));
}

TEST(FailsDepth, TellsBothDepths) {
    const TestedTrace trace = example("t0-hidden/two-depths");
    EXPECT_THAT(trace, Not(FailsDepth("DEF", 3, 2)));
    expect_failure(trace, FailsDepth("DEF", 3, 2), "fails the depth test of DEF at (3, 2)",
                   told("t0-hidden/two-depths", 100), R"(the test is
  step 71: depth at (3, 2): 2 against 3 of ABC: passes (z, smaller is nearer)
      plane through the corners: depth = 0 x + 0 y + 2
      depth = 2/3 (2) + 1/6 (2) + 1/6 (2) = 2
)");
    EXPECT_THAT(example("t0-hidden/cube-inverse-z"), FailsDepth("EGF", 2, -2));
}

TEST(FailsDepth, FailsEitherWayWhereThereIsNoTest) {
    const TestedTrace trace = example("t0-hidden/two-depths");
    const std::string message =
        "Failed\nt0-hidden/two-depths\n"
        "cannot tell if it fails the depth test of ABC at (0, 0): no such test; pixel (0, 0): not "
        "drawn by any of 2 primitives\n"
        "  ABC: outside: AC begins row y=0 at x = 1 -> floor -> 1; x = 0 lies before it by 1\n"
        "      left AC: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (1 - 1)/(5 - 0) (0 - 0) + 1 = 0 "
        "(0) + 1 = 1 -> floor -> 1";
    EXPECT_EQ(first_failure(trace, FailsDepth("ABC", 0, 0)), message + "\n");
    EXPECT_EQ(first_failure(trace, Not(FailsDepth("ABC", 0, 0))), message);
    EXPECT_NE(first_failure(example("t0-fill/first-triangle"), Not(FailsDepth("ABC", 3, 2))), "");
}

TEST(ShowsPicture, MarksWhatDiffers) {
    const TestedTrace trace = example("t2-lines/points");
    EXPECT_THAT(trace, ShowsPicture({"##...", "#....", "....#"}));
    EXPECT_THAT(trace, ShowsPicture("##...\n"
                                    "#....\n"
                                    "....#\n"));
    EXPECT_THAT(trace, ShowsPicture(R"(
##...
#....
....#
)"));
    EXPECT_THAT(trace, ShowsPicture(std::vector<std::string>{"##...", "#....", "....#"}));
    expect_failure(trace, ShowsPicture({"##...", "#..#.", "....."}), "shows the picture",
                   told("t2-lines/points", 8), R"(which shows
    y  expected  there     ! only expected, ? only there
    0  ##...     ##...     ##...
    1  #..#.     #....     #..!.
    2  .....     ....#     ....?
)");
    expect_failure(trace, Not(ShowsPicture({"##...", "#....", "....#"})),
                   "does not show the picture", told("t2-lines/points", 8),
                   "all of its 3 rows are there\n");
}

TEST(ShowsPicture, OfAPartIsAboutThatPartOnly) {
    const TestedTrace trace = example("t0-fill/first-triangle"); // y points up
    EXPECT_THAT(trace, ShowsPicture({"..#", ".##", "###"}, {0, 5}));
    expect_failure(trace, ShowsPicture({"##", "#."}, {1, 5}), "shows the picture",
                   of_first_triangle, R"(which shows
    y  expected  there     ! only expected, ? only there
    5  ##        .#        !#
    4  #.        ##        #?
)");
}

// Not() must not turn a question that has no answer into a test that passes.
TEST(Matchers, AQuestionWithoutAnAnswerFailsWhateverStandsAroundIt) {
    const TestedTrace trace = example("t0-fill/first-triangle");
    const std::string off_canvas = "Failed\nt0-fill/first-triangle\ncannot tell if it plots pixel "
                                   "(99, 2): expected a pixel of the "
                                   "canvas (x -8 to 8, y -6 to 7), found (99, 2)\n";
    EXPECT_EQ(failures_of([&] { EXPECT_THAT(trace, PlotsPixel(99, 2)); }), off_canvas);
    EXPECT_EQ(failures_of([&] {
                  EXPECT_THAT(trace, Not(PlotsPixel(99, 2)));
              }).substr(0, off_canvas.size()),
              off_canvas);
}

TEST(Matchers, ATraceOfPixelsAloneAnswersNothingElse) {
    const TestedTrace trace = trace_from(
        {"mine",
         R"({"rastertrace":1,"canvas":{"width":4,"height":4,"origin":"top-left"},"method":{}}
{"step":"primitive","kind":"triangle","name":"A","vertices":["P","Q","R"],"color":"#000000"}
{"step":"pixel","x":1,"y":2}
{"end":{"steps":2}}
)"});
    EXPECT_THAT(trace, AllOf(PlotsPixel(1, 2), Not(PlotsPixel(2, 2))));
    const auto refusal_of = [&trace](const TraceMatcher& matcher) {
        return first_failure(trace, Not(matcher));
    };
    EXPECT_EQ(
        refusal_of(CullsFace("A")),
        "Failed\nmine\ncannot tell if it culls face A: expected a trace with face steps or with "
        "stages, found one that has none");
    EXPECT_EQ(refusal_of(HasScanline(2, 1, 3)),
              "Failed\nmine\ncannot tell if it has scanline y=2 from 1 to 3: expected a trace with "
              "scanline steps, found one that has none");
    const std::string nothing =
        "Failed\nmine\ncannot tell if it decides by its numbers: nothing was "
        "compared: expected numbers that can be done again, found none";
    EXPECT_EQ(refusal_of(DecidesByItsNumbers()), nothing);
    EXPECT_EQ(first_failure(trace, DecidesByItsNumbers()), nothing + "\n");
}

TEST(Matchers, AMistakeIsToldInTheLineOfTheTest) {
    ::testing::TestPartResultArray failures;
    {
        const ::testing::ScopedFakeTestPartResultReporter reporter(
            ::testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &failures);
        EXPECT_THAT(trace_in("missing.jsonl"), PlotsPixel(1, 2));
    }
    ASSERT_EQ(failures.size(), 1);
    EXPECT_EQ(failures.GetTestPartResult(0).line_number(), __LINE__ - 3);
    EXPECT_THAT(failures.GetTestPartResult(0).file_name(),
                ::testing::EndsWith("matchers_test.cpp"));
}

TEST(Matchers, WhatCannotBeAskedIsSaid) {
    const TestedTrace trace = example("t0-fill/first-triangle");
    const auto refusal_of = [&trace](const TraceMatcher& matcher) {
        const std::string text = first_failure(trace, matcher);
        const std::string begin = "Failed\nt0-fill/first-triangle\ncannot tell if it ";
        EXPECT_EQ(text.substr(0, begin.size()), begin);
        return text.substr(std::min(begin.size(), text.size()));
    };
    EXPECT_EQ(refusal_of(PlotsPixel(3, 2, In("ABD"))),
              "plots pixel (3, 2) in ABD: expected a primitive of the trace (ABC), found ABD\n"
              "hint: did you mean ABC?\n");
    EXPECT_EQ(refusal_of(CullsFace("ABD")),
              "culls face ABD: expected a primitive of the trace (ABC), found ABD\n"
              "hint: did you mean ABC?\n");
    EXPECT_EQ(refusal_of(FailsDepth("wing", 3, 2)),
              "fails the depth test of wing at (3, 2): expected a primitive of the trace (ABC), "
              "found wing\n");
    EXPECT_EQ(refusal_of(HasScanline(2, "1/0", "x")),
              "has scanline y=2 from 1/0 to x: expected a number, like 3.125 or 25/8, found "
              "\"1/0\"\n");
    EXPECT_EQ(
        refusal_of(HasScanline(20, 0, 0)),
        "has scanline y=20 from 0 to 0: expected a row of the canvas (y -6 to 7), found 20\n");
    EXPECT_EQ(refusal_of(ShowsPicture({"..", "."}, {0, 0})),
              "shows the picture: expected rows of one length, found 2 and 1 columns\n");
    EXPECT_EQ(refusal_of(ShowsPicture({"..x"}, {0, 0})),
              "shows the picture: expected rows of `#` and `.`, found ..x\n");
    EXPECT_EQ(refusal_of(ShowsPicture({})),
              "shows the picture: expected rows of `#` and `.`, found none\n");
    EXPECT_EQ(refusal_of(ShowsPicture({"..#.."})),
              "shows the picture: expected 17 columns and 14 rows, found 5 and 1\n"
              "hint: ShowsPicture(rows, Pixel{x, y}) is about a part of the canvas\n");
    EXPECT_EQ(refusal_of(ShowsPicture({"..", "..", ".."}, {8, -5})),
              "shows the picture: expected at most 1 columns and 2 rows, found 2 and 3\n");
}

TEST(Matchers, WhatCannotBeReadFailsTheTest) {
    EXPECT_EQ(
        first_failure(trace_in("missing.jsonl"), Not(PlotsPixel(3, 2))),
        "Failed\nmissing.jsonl\n"
        "cannot tell if it plots pixel (3, 2): missing.jsonl: expected a file that can be read, "
        "found: No such file or directory");
    EXPECT_EQ(
        first_failure(trace_from({"scene.json", R"({"points":[]})"}), Not(PlotsPixel(3, 2))),
        "Failed\nscene.json\n"
        "cannot tell if it plots pixel (3, 2): scene.json:1:1: expected at least one "
        "primitive, found none\n"
        "{\"points\":[]}\n"
        "^\n"
        "hint: the smallest scene: {\"vertices\": {\"A\": [2, 5], \"B\": [-4, -3], \"C\": [5, "
        "-3]}, \"triangles\": [\"ABC\"]}");
    EXPECT_EQ(
        first_failure(trace_from({"t.json", trace_of(first_triangle()).text}, {{"fill", "fan"}}),
                      Not(PlotsPixel(3, 2))),
        "Failed\nt.json\ncannot tell if it plots pixel (3, 2): t.json: expected a scene to draw "
        "with fill fan, found "
        "a trace, which is drawn already");
    Scene infinite = first_triangle();
    infinite.vertices[0].x = number("1e308");
    infinite.method.scalar = ScalarKind::single_precision;
    EXPECT_EQ(first_failure(trace_of(infinite), Not(PlotsPixel(0, 0))),
              "Failed\nA triangle\ncannot tell if it plots pixel (0, 0): expected coordinates up "
              "to 8.51e+37 for "
              "float, found vertex A at (1e+308, 5)\n"
              "hint: with \"method\": {\"scalar\": \"exact\"} nothing overflows");
}

TEST(Matchers, ATraceThatBreaksOffOrWasCutDownDoesNotAnswer) {
    const TestedTrace whole = trace_of(first_triangle());
    ASSERT_THAT(whole, PlotsPixel(3, 2));
    EXPECT_EQ(
        first_failure(trace_from({"cut", whole.text.substr(0, whole.text.size() / 2)}),
                      Not(PlotsPixel(3, 2))),
        "Failed\ncut\n"
        "cannot tell if it plots pixel (3, 2): cut:18:1: expected the rest of the trace, found "
        "the end of the file: the trace is truncated after 16 whole steps\n"
        "{\"step\":\"pixel\",\"x\"\n"
        "^");
    const auto trace_with = [](const std::string& key) {
        return trace_from(
            {"part",
             R"({"rastertrace":1,"canvas":{"width":4,"height":4,"origin":"top-left"},"method":{},)" +
                 key + "}\n{\"end\":{\"steps\":0}}\n"});
    };
    const std::string begin = "Failed\npart\ncannot tell if it plots pixel (3, 2): ";
    EXPECT_EQ(first_failure(trace_with(R"("only":["scanline"])"), Not(PlotsPixel(3, 2))),
              begin + "pixel steps were left out of the trace");
    EXPECT_EQ(first_failure(trace_with(R"("region":[0,0,1,1])"), Not(PlotsPixel(3, 2))),
              begin +
                  "the trace has only what is about x 0 to 1, y 0 to 1: the pixel lies outside");
    EXPECT_EQ(first_failure(trace_with(R"("primitive":"ABC")"), Not(PlotsPixel(3, 2))),
              begin + "the trace has only the steps of ABC");
}

// docs/regression-tests.md shows what fails if the rasterizer beside it rounds by a cast.
TEST(Matchers, ThePageShowsWhatAFailureSays) {
    const std::string folder = RASTERTRACE_EXAMPLES;
    const TestedTrace mine{"mine.jsonl", {}, trace_in(folder + "/regression/fast.jsonl").trace};
    const std::string pixel = failures_of([&] { EXPECT_THAT(mine, PlotsPixel(-1, 2)); });
    const std::string picture = failures_of([&] {
        EXPECT_THAT(mine, ShowsPicture(".###\n"
                                       "####\n"
                                       "####\n",
                                       {-4, -1}));
    });
    std::ifstream file(folder + "/../docs/regression-tests.md", std::ios::binary);
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(page.find("```\n" + pixel + "```\n"), std::string::npos) << pixel;
    EXPECT_NE(page.find("```\n" + picture + "```\n"), std::string::npos) << picture;
}

} // namespace
} // namespace rastertrace
