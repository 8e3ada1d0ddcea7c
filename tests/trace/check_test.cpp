// SPDX-License-Identifier: MIT
// What is true of a scene, and what is told of a claim that is not. The numbers are those of the texts
// (docs/sources.md).

#include "claims_support.h"
#include "random_choice.h"
#include "random_scene.h"
#include "told_problem.h"
#include "traces.h"

#include "effort.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// T0's triangle, drawn by a method.
std::string triangle_by(const std::string& method) {
    return R"({"canvas":{"width":17,"height":14},"vertices":{"A":[2,5],"B":[-4,-3],"C":[5,-3]},)"
           R"("triangles":["ABC"],"method":{)" +
           method + "}}";
}
const std::string triangle = triangle_by(R"("scalar":"exact")");

/// The verdicts, a letter each: r, w, f, o.
std::string verdicts(const Checked& checked) {
    std::string text;
    for (const CheckedClaim& claim : checked.claims)
        text += std::string("rwfo")[static_cast<std::size_t>(claim.verdict)];
    return text;
}

std::string verdicts(const std::string& scene, const std::string& claims,
                     const MethodOverrides& method = {}) {
    return verdicts(check_claims(scene, claims, method));
}

void expect_problem(const std::string& scene, const std::string& claims, const std::string& message,
                    const std::string& hint = "") {
    EXPECT_EQ(problem_of_claims(scene, claims), told_problem(claims, message, hint));
}

const CheckedField& first_wrong(const Checked& checked) {
    for (const CheckedClaim& claim : checked.claims)
        for (const CheckedField& field : claim.fields)
            if (field.verdict == ClaimVerdict::wrong)
                return field;
    static const CheckedField none{};
    ADD_FAILURE() << "nothing is wrong";
    return none;
}

/// The names of the slips of the first wrong field.
std::vector<std::string> slips_of(const std::string& scene, const std::string& claims) {
    return slip_names(first_wrong(check_claims(scene, claims)));
}

/// The line of T2: (0,0) to (5,2).
const std::string line_of_five = R"({"canvas":{"width":8,"height":4,"origin":"bottom-left"},
 "vertices":{"A":[0,0],"B":[5,2]},"lines":["AB"],"colors":{"A":"#000000","B":"#ff0000"},
 "method":{"scalar":"exact"}})";

/// Two triangles, one before the other.
const std::string two_depths = R"({"canvas":{"width":9,"height":9},
 "vertices":{"A":[-4,-4,2],"B":[4,-4,2],"C":[-4,4,2],"D":[-4,-4,4],"E":[4,-4,4],"F":[-4,4,4]},
 "triangles":["DEF","ABC"],"method":{"scalar":"exact","depth":"inverse-z","shade":"faces"}})";

TEST(Check, LinesByTheirEquations) {
    // 3 y = 4 x + 7 has A(2, 5) and B(-4, -3); B and C(5, -3) have y = -3.
    EXPECT_EQ(verdicts(triangle, "AB: y = 4/3 x + 7/3\n"
                                 "BA: y = 1.33x + 2.33\n"
                                 "edge AB: x = 3/4 y - 7/4\n"
                                 "BC: y = -3\n"
                                 "AB: y = 4/3 x + 2\n"),
              "rrrrw");
    EXPECT_EQ(verdicts(line_of_five, "AB: y = 2/5 x\nAB: x = 5/2 y\n"), "rr");
    EXPECT_THAT(slips_of(triangle, "AB: y = 3/4 x + 7/3\n"), Contains("dy-dx-inverted"));
    EXPECT_THAT(slips_of(triangle, "AB: x = 4/3 y - 7/4\n"), Contains("dx-dy-inverted"));
}

TEST(Check, PixelsOfALinePlaceByPlace) {
    EXPECT_EQ(verdicts(line_of_five, "AB pixels: (0,0) (1,0) (2,1) (3,1) (4,2) (5,2)\n"), "r");
    const Checked begun = check_claims(line_of_five, "AB: (0,0), (1,0)\n");
    EXPECT_EQ(begun.claims[0].fields[0].remark, "ends early: the first 2 of 6");
    EXPECT_EQ(begun.open, 1U);
    EXPECT_EQ(begun.end_early, 1U);
    EXPECT_EQ(verdicts(line_of_five, "AB: (0,0), (1,0), ...\n"), "r");
    const Checked wrong = check_claims(line_of_five, "AB: (0,0) (1,0) (2,1) (3,2) (4,2) (5,3)\n");
    const CheckedField& field = first_wrong(wrong);
    EXPECT_EQ(field.place, 4U);
    EXPECT_EQ(field.expected, "3, 1");
    EXPECT_EQ(field.found, "3, 2");
    // The step before (3, 1): d = -3.
    EXPECT_THAT(wrong.claims[0].working, Contains(HasSubstr("d = -3 <= 0, straight on")));
}

TEST(Check, ALineInTheStepsOfTheFirstOctantIsNamed) {
    const std::string falling = R"({"canvas":{"width":12,"height":9,"origin":"bottom-left"},
 "vertices":{"A":[0,5],"B":[8,2]},"lines":["AB"]})";
    EXPECT_THAT(slips_of(falling, "AB: (0,5) (1,5) (2,6) (3,6) (4,6) (5,7) (6,7) (7,8) (8,8)\n"),
                Contains("octant-ignored"));
}

TEST(Check, ARowWithAHoleIsWrongThere) {
    const Checked checked = check_claims(triangle, "y=2: -1, 0, 2, 3\n");
    EXPECT_EQ(first_wrong(checked).place, 3U);
    EXPECT_EQ(first_wrong(checked).expected, "1");
    EXPECT_EQ(verdicts(triangle, "y=2: -1, 0, 1, 2, 3\ny=2: -1, 0, 1, 2\n"
                                 "y=7: 0 pixels\n(4,2) ABC: hidden\n"),
              "rwrw");
}

TEST(Check, CountsOfRowsAndPixels) {
    // Rows -3 to 5; x = -1 to 3 in the row y = 2.
    EXPECT_EQ(verdicts(triangle, "ABC: 9 rows\nABC rows: 9\ny=2: 5 pixels\n"), "rrr");
    EXPECT_EQ(verdicts(line_of_five, "AB: 6 pixels\nAB pixels: 6\n"), "rr");
    EXPECT_THAT(slips_of(line_of_five, "AB: 5 pixels\n"), ElementsAre("last-pixel"));
    EXPECT_THAT(slips_of(triangle, "y=2: 4 pixels\n"), ElementsAre("last-pixel"));
    EXPECT_THAT(slips_of(triangle, "ABC rows: 10\n"), ElementsAre("middle-row-twice"));
}

TEST(Check, WhatIsHiddenAndWhatIsSeen) {
    EXPECT_EQ(verdicts(two_depths, "ABC: visible\nDEF: hidden\n"
                                   "(-2,-2) ABC: visible\n(-2,-2) DEF: hidden\n"
                                   "(-2,-2) DEF: inside\nDEF: seen\n"),
              "rrrrrw");
}

TEST(Check, SharesAndLevelsOfColors) {
    // Step 2 of 5: 2/5 (255) = 102; step 3 of 5: 153; by the distance of (2, 1): 1 - sqrt(10 / 29), 105.26.
    EXPECT_EQ(verdicts(line_of_five, "(2,1): share 2/5\n(2,1): color #660000\n"
                                     "(3,1): color #990000\n(2,1): share 1/2\n"),
              "rrrw");
    EXPECT_THAT(slips_of(line_of_five, "(2,1): color #690000\n"), ElementsAre("color-by-distance"));
    // Step 1 of 2 of 255: 127.5.
    const std::string half = R"({"canvas":{"width":4,"height":4,"origin":"bottom-left"},
 "vertices":{"A":[0,0],"B":[2,0]},"lines":["AB"],"colors":{"A":"#000000","B":"#ff0000"}})";
    EXPECT_EQ(verdicts(half, "(1,0): color #800000\n"), "r");
    EXPECT_THAT(slips_of(half, "(1,0): color #7f0000\n"),
                ElementsAre("byte-cast", "color-summed-and-cut"));
}

TEST(Check, ASampleIsJudgedByItsOwnWeights) {
    const std::string scene = triangle_by(R"("fill":"barycentric","scalar":"exact")");
    const Checked checked = check_claims(scene, "(3,2): outside\n(4,2): inside\n");
    EXPECT_EQ(verdicts(checked), "ww");
    for (const CheckedClaim& claim : checked.claims)
        EXPECT_THAT(claim.fields.at(0).rule, HasSubstr("weights"));
    const std::string by_edges =
        R"({"canvas":{"width":8,"height":8,"origin":"bottom-left"},"vertices":{"A":[0,0],"B":[6,0],"C":[0,6]},)"
        R"("triangles":["ABC"],"method":{"fill":"barycentric","scalar":"exact"}})";
    EXPECT_THAT(slips_of(by_edges, "(3,3) ABC: outside\n"), Contains("edge-the-other-way"));
}

TEST(Check, RowsOfTheFirstTriangle) {
    const Checked checked = check_claims(triangle, "y=5: 2, 2 -> 2..2\n"
                                                   "y=4: 5/4, 19/8 -> 1..2\n"
                                                   "y=3: 0.5, 2.75 -> 0..2\n"
                                                   "y=2: -1/4, 25/8 -> -1..3\n"
                                                   "y=1: -1, 7/2\n"
                                                   "y=0: -> -2..3\n");
    EXPECT_EQ(verdicts(checked), "rrrrrr");
    EXPECT_EQ(checked.right, 6U);
    EXPECT_EQ(checked.wrong + checked.follow + checked.open, 0U);
}

TEST(Check, AWrongRowShowsTheRightValueAndItsWorking) {
    const Checked checked = check_claims(triangle, "y=2: 1/4, 25/8\n");
    ASSERT_EQ(verdicts(checked), "w");
    const CheckedClaim& claim = checked.claims[0];
    EXPECT_EQ(claim.fields[0].verdict, ClaimVerdict::wrong);
    EXPECT_EQ(claim.fields[0].expected, "-1/4");
    EXPECT_EQ(claim.fields[0].found, "1/4");
    EXPECT_EQ(claim.fields[1].verdict, ClaimVerdict::right);
    EXPECT_THAT(claim.working, Contains("left AB: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = "
                                        "(-4 - 2)/(-3 - 5) (2 - 5) + 2 = 3/4 (-3) + 2 = -1/4 -> "
                                        "floor -> -1"));
}

TEST(Check, WhatGoesOnFromAWrongNumberFollows) {
    // 0 is the floor of 1/4, and the row that is claimed does not have (-1, 2).
    const Checked checked = check_claims(triangle, "y=2: 1/4, 25/8 -> 0..3\n"
                                                   "(-1,2): off\n"
                                                   "(3,2): on\n");
    EXPECT_EQ(verdicts(checked), "wfr");
    EXPECT_EQ(checked.claims[0].fields[2].name, "from");
    EXPECT_EQ(checked.claims[0].fields[2].verdict, ClaimVerdict::follows);
    EXPECT_EQ(checked.claims[1].fields[0].follows_from, 1U);
    EXPECT_EQ(checked.follow, 1U);
}

TEST(Check, ARowThatAddsTheSlopeToAWrongOneFollows) {
    // -1/4 - 3/4 = -1 is right; from 1/4 it is -1/2, and then -5/4.
    const Checked checked = check_claims(triangle, "y=2: 1/4, ?\ny=1: -1/2, ?\ny=0: -5/4, ?\n");
    EXPECT_EQ(verdicts(checked), "wff");
    EXPECT_EQ(checked.claims[2].fields[0].follows_from, 2U);
}

TEST(Check, WhoRoundsTooEarlyIsTold) {
    // dx/dy = 6/7 is 0.9 to one digit; 2 + 0.9 (4 - 5) = 1.1, where 2 - 6/7 = 8/7 is 1.14.
    const std::string sevenths = R"({"canvas":{"width":17,"height":14},
        "vertices":{"A":[2,5],"B":[-4,-2],"C":[5,-3]},"triangles":["ABC"],"method":{"scalar":"exact"}})";
    const Checked checked = check_claims(sevenths, "edge AB: 0.9\ny=4: 1.10, ?\n");
    EXPECT_EQ(verdicts(checked), "rf");
    EXPECT_EQ(checked.claims[1].fields[0].follows_from, 1U);
}

TEST(Check, AMovedVertexMovesItsRows) {
    // With B at (-4, 3), y=4 lies on (2, 5) (-4, 3): 2 - 3 = -1.
    const Checked checked = check_claims(triangle, "y=4: -1, 19/8\nB screen: -4, 3\n");
    EXPECT_EQ(verdicts(checked), "fw");
    EXPECT_EQ(checked.claims[0].fields[0].follows_from, 2U);
}

TEST(Check, DecimalsAreRoundedOrCutOff) {
    const std::string thirds = R"({"canvas":{"width":17,"height":14},
        "vertices":{"A":[0,0],"B":[2,3],"C":[4,0]},"triangles":["ABC"],"method":{"scalar":"exact"}})";
    const Checked checked = check_claims(thirds, "y=1: 0.67, ?\ny=1: 0.6667, ?\ny=1: 0.66, ?\n");
    EXPECT_EQ(verdicts(checked), "rrr");
    EXPECT_EQ(checked.claims[0].fields[0].remark, "rounded to 2 digits");
    EXPECT_EQ(checked.claims[1].fields[0].remark, "rounded to 4 digits");
    EXPECT_EQ(checked.claims[2].fields[0].remark, "cut off behind 2 digits, not rounded");
    EXPECT_EQ(verdicts(thirds, "round: truncate\ny=1: 0.66, ?\ny=1: 0.67, ?\n"), "rr");
    EXPECT_EQ(verdicts(thirds, "round: nearest\ny=1: 0.66, ?\ny=1: 0.67, ?\n"), "wr");
    EXPECT_EQ(verdicts(thirds, "y=1: 0.7, ?\ny=1: 0.6, ?\n"), "rr");
    EXPECT_EQ(verdicts(thirds, "y=1: 0.65, ?\ny=1: 1, ?\ny=1: 0, ?\ny=1: 0.0, ?\n"), "wwww");
}

/// A triangle of unit vectors, with `more` keys of the scene.
std::string unit_vectors(const std::string& more) {
    return R"({"canvas":{"width":17,"height":14},
 "vertices":{"A":[1,0,0],"B":[0,1,0],"C":[0,0,1]},"triangles":["ABC"],"method":{"scalar":"exact"},)" +
           more + "}";
}

std::string turned(const std::string& axis, const std::vector<int>& degrees) {
    std::string steps;
    for (const int angle : degrees)
        steps += fmt::format(R"({}{{"rotate":{{"axis":{},"degrees":{}}}}})",
                             steps.empty() ? "" : ",", axis, angle);
    return unit_vectors("\"model\":[" + steps + "]");
}

TEST(Check, TheSchoolsAnswerIsRightWhereSinesAreRounded) {
    EXPECT_EQ(verdicts(turned("\"z\"", {45, 45}), "A world: 0, 1, 0\nB world: -1, 0, 0\n"
                                                  "A screen: 0, 1\nA screen: 0.1, 1\n"),
              "rrrw");
    EXPECT_EQ(verdicts(turned("[1,1,1]", {120}),
                       "A world: 0, 1, 0\nB world: 0, 0, 1\nC world: 1, 0, 0\n"),
              "rrr");
    EXPECT_EQ(verdicts(turned("\"x\"", {30, 60}), "B world: 0, 0, 1\nC world: 0, -1, 0\n"), "rr");
}

TEST(Check, ARootIsRightInEveryNumberOfDigits) {
    // The first 60 digits of the root of 1/2.
    const std::string root = "0.707106781186547524400844362104849039284835937688474036588340";
    const std::string scene = turned("\"z\"", {45});
    for (std::size_t digits = 1; digits <= 58; ++digits) {
        const std::string cut = root.substr(0, digits + 2);
        const Checked checked = check_claims(scene, "A world: " + cut + ", sqrt(2)/2, 0\n");
        EXPECT_EQ(verdicts(checked), "r") << cut;
        const bool rounds_up = root[digits + 2] >= '5';
        const std::string shortened = rounds_up ? "cut off behind" : "rounded to";
        EXPECT_THAT(checked.claims[0].fields[0].remark, HasSubstr(shortened)) << cut;
        // A last digit that is two off is wrong.
        std::string wrong = cut;
        wrong.back() = static_cast<char>(wrong.back() + (wrong.back() < '8' ? 2 : -2));
        EXPECT_EQ(verdicts(scene, "A world: " + wrong + ", sqrt(2)/2, 0\n"), "w") << wrong;
    }
    EXPECT_EQ(verdicts(scene, "A world: \u221A2/2, cos 45\u00B0, 0\n"
                              "B world: -1/sqrt(2), sin(pi/4), 0\n"
                              "A world: sqrt(3)/2, sqrt(2)/2, 0\n"
                              "A world: ~0.7, 0.7071.., 0\n"),
              "rrwr");
}

TEST(Check, ACameraAndACosineHaveRoots) {
    const std::string camera = unit_vectors(
        R"("camera":{"position":[0,-3,1],"look_at":[0,0,0],"up":[0,0,1]},"projection":{"type":"pinhole","distance":1})");
    EXPECT_EQ(verdicts(camera, "A camera: -1, 0, 3.16227766\nA camera: -1, 0, sqrt(10)\n"
                               "A camera: -1, 0, 3.2\nA camera: -1, 0, 3.3\n"),
              "rrrw");
    // The normal (0, 0, 1) and the view (1, 0, 1) of T1.
    const std::string angles = example_text("t1-hidden/three-angles.json");
    EXPECT_EQ(verdicts(angles, "cosine ABC: sqrt(2)/2\ncosine ABC: 1/sqrt(2)\n"
                               "cosine ABC: 0.70710678118654752440\n"
                               "cosine ABC: 0.70710678118654752442\n"),
              "rrrw");
}

TEST(Check, ATieThatRootsDecideIsTold) {
    // Turned by 45 degrees twice, the face is seen from its edge.
    const std::string edge_on = R"({"canvas":{"width":17,"height":14},
        "vertices":{"A":[0,0,0],"B":[1,0,0],"C":[0,1,0]},"triangles":["ABC"],
        "model":[{"rotate":{"axis":"y","degrees":45}},{"rotate":{"axis":"y","degrees":45}}],
        "method":{"scalar":"exact","cull":"back"}})";
    const Checked checked = check_claims(edge_on, "dot ABC: 0\nABC: culled\n");
    EXPECT_EQ(checked.claims[0].verdict, ClaimVerdict::right);
    EXPECT_EQ(checked.claims[1].fields[0].remark,
              "by the sines and roots as doubles; without rounding it is a tie");
}

TEST(Check, ANameAndNumbersAreWhatHasTheName) {
    EXPECT_EQ(verdicts(triangle, "AB: 3/4\nBA: 6/8\nBC: none\nedge BC: horizontal\nedge AB: none\n"
                                 "A = (2, 5)\nA: 2 5\nB: 4, 3\n"),
              "rrrrwrrw");
    expect_problem(
        turned("\"z\"", {90}), "A: 0, 1, 0\n",
        "claims:1:1: expected the space that A is in (object, world, camera), found none",
        "A camera: ...");
}

TEST(Check, WhatIsToldCanBeClaimedInWords) {
    // T1: the normal (0, 0, 1) and the view (1, 0, 1).
    const std::string angles = example_text("t1-hidden/three-angles.json");
    EXPECT_EQ(verdicts(angles, "angle ABC: 45\u00B0\nangle ABC: 60\n"), "rw");
    EXPECT_EQ(verdicts(triangle,
                       "weights (3,2): 5/8, 1/72, 13/36\nweights (3,2): 5/8, 13/36, 1/72\n",
                       {{"fill", "barycentric"}}),
              "rw");
    EXPECT_EQ(verdicts(turned("\"z\"", {90}),
                       "matrix model: [0 -1 0 0] [1 0 0 0] [0 0 1 0] [0 0 0 1]\n"
                       "matrix model: [0 1 0 0] [-1 0 0 0] [0 0 1 0] [0 0 0 1]\n"),
              "rw");
    // From (-4, -3) to (2, 5) x is 3/4 (y + 3) - 4, and from (0, 0) to (8, 2) y is x/4.
    const std::string lines =
        R"({"canvas":{"width":17,"height":14},"vertices":{"A":[2,5],"B":[-4,-3],"O":[0,0],"P":[8,2]},
        "lines":["BA","OP"],"method":{"line":"naive","scalar":"exact"}})";
    EXPECT_EQ(verdicts(lines, "BA y=0: -7/4\nBA y=0: 7/4\nOP x=3: 3/4 -> 1\nOP x=3: 3/4 -> 0\n"),
              "rwrw");
}

/// Right sheets of T0's triangle, as people write them.
const std::vector<std::string> right_sheets{
    "y=2: -1/4, 25/8 -> -1..3",
    "Y = 2: \u2212\u00BC; 3 1/8 \u2192 -1 to 3.",
    "row 2: [-1 / 4 | 25/8] => -1, 0, 1, 2, 3",
    "1. y=2: x from -1/4 to 2 - 3/8 (2 - 5)",
    "y;left;right\n2;-0,25;3,125\n",
    "| y | xL | xR |\n|---|---|---|\n| 2 | -\\frac{1}{4} | \\frac{25}{8} |\n",
    "slope AB = 3 : 4",
    "edge AC: -3/8",
    "A = (2, 5)",
    "B screen: -4 | -3",
    "AB: y = 4/3 x + 7/3",
    "line AC: x = -3/8y + 31/8",
    "ABC: 9 rows, 49 pixels",
    "y=2: 5 pixels",
    "(3,2): on\n(4,2): off"};

/// Sentences of several scenes, as `show` prints them.
const std::vector<std::string> sheets_of_sentences{
    "  14  scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor -> -1   right AC: x = 2 - "
    "3/8 (2 - 5) = 25/8 -> "
    "floor -> 3   depth 1/3 to 1/5",
    "First triangle   step 14 of 62\nvertex A in canonical space: (1, 2, 3) / 5 = (1/5, 2/5, "
    "3/5)\n\n   1 2\n 1 . .\n",
    "triangle ABC   A (2, 5)   B (-4, -3) #ff0000   C (5, -3)\nedge AB: dx/dy = 6 / 8 = 0.75 = "
    "3/4; x = 2 + 3/4 (y - 5)",
    "row y=8   AB at 1/2, winding 1   BC at 3, winding 0: inside where the winding number is odd",
    "x = 3: y = 1/2 x + 0 = 3/2 -> nearest, ties up -> 2\nside AB: octant 3\nat (2, 1): d = 3 > 0, "
    "diagonally to NE; d - 6 = -3",
    "sample of (0, 0): (31, 14, 72) / 72: A 3/8 B 0.25 = 1/4 C 49977918.../10141204... = 4.928204: "
    "none is negative, inside",
    "depth at (2, -2): 1/5 against 1/3 of ABC: fails (1/z, larger is nearer; z = 5 against "
    "3)\npixel (3, 2) #690000 (step 3 of 5)",
    "face ABC: normal (0, 0, -4) . to eye (-1, -1, 3) = -12, cosine -0.9 (154.16 degrees): culled",
    "light on ABC: normal (0, 0, 1) . light (1, 0, 1) = 1, intensity 0.707107, color #b4b4b4 "
    "(level 180)",
    "the painter draws, farthest first: ABC at 4, ACD at 79999999.../40000000... < 2",
    "model matrix of cube = rotate x translate:  [1 0 0 0]  [0 1 0 0]  [0 0 1 -4]  [0 0 0 1]",
    "ABC clipped at the near plane: 2 of 3 vertices inside, 4 left"};

TEST(Check, RightSheetsAreRight) {
    for (const std::string& sheet : right_sheets) {
        const Checked checked = check_claims(triangle, sheet);
        EXPECT_GT(checked.right, 0U) << sheet;
        EXPECT_EQ(checked.wrong + checked.follow, 0U) << sheet;
    }
}

/// A sheet with one character changed, left out or put in.
std::string mutated(std::string sheet, Random& random) {
    const auto any = [&random](std::size_t count) {
        return static_cast<std::size_t>(random.whole(0, static_cast<int>(count) - 1));
    };
    const std::string characters = "0123456789-/,.;:|()= \n\t\"#~xyABz\xE2";
    const std::size_t at = any(sheet.size());
    switch (random.whole(0, 2)) {
    case 0:
        sheet[at] = characters[any(characters.size())];
        return sheet;
    case 1:
        return sheet.erase(at, 1);
    default:
        return sheet.insert(at, 1, characters[any(characters.size())]);
    }
}

TEST(Check, AChangedDigitIsNeverCalledRight) {
    // A digit of a value is changed, so that no digit is lost to rounding: the sheet is no longer right.
    for (const std::string& sheet : right_sheets)
        for (std::size_t at = 0; at < sheet.size(); ++at) {
            const bool is_numbering = sheet.starts_with("1. ") && at == 0;
            if (sheet[at] < '0' || '9' < sheet[at] || is_numbering || sheet.starts_with("(3,2)"))
                continue;
            std::string other = sheet;
            other[at] = sheet[at] == '9' ? '7' : static_cast<char>(sheet[at] + 1);
            const auto claims = read_claims({"claims", other});
            if (!claims)
                continue;
            try {
                const Checked checked = check(Truth({"scene.json", triangle}, {}), claims.value());
                EXPECT_GT(checked.wrong + checked.follow, 0U) << other;
            } catch (const Problem&) { // a row or a pixel that the scene does not have
            }
        }
}

TEST(Check, AnySheetIsReadOrRefused) {
    Random random(20261128);
    const Truth truth({"scene.json", triangle}, {});
    std::vector<std::string> sheets = right_sheets;
    sheets.insert(sheets.end(), sheets_of_sentences.begin(), sheets_of_sentences.end());
    for (std::size_t i = 0; i < random_cases(4000U); ++i) {
        std::string sheet = sheets[i % sheets.size()];
        for (int changes = random.whole(1, 4); changes > 0 && !sheet.empty(); --changes)
            sheet = mutated(sheet, random);
        const auto claims = read_claims({"claims", sheet});
        if (!claims) {
            EXPECT_FALSE(to_text(claims.problem()).empty());
            continue;
        }
        try {
            check(truth, claims.value());
        } catch (const Problem& problem) {
            EXPECT_FALSE(to_text(problem).empty());
        }
    }
}

TEST(Check, AllNamesThatTheSceneDoesNotHaveAreToldInOneRun) {
    EXPECT_EQ(
        problem_of_claims(triangle, "edge AX: 1\nD screen: 1, 2\n"),
        "claims:1:6: expected an edge of the scene (AB, AC, BC), found \"AX\"\nedge AX: 1\n     ^\n"
        "hint: did you mean AB?\n"
        "claims:2:1: expected a vertex of the scene (A, B, C), found \"D\"\nD screen: 1, 2\n^\n"
        "hint: a line looks like `A screen: 2, 5`");
    const Checked checked =
        check_claims(triangle, "edge AX: 1\ny=2: -1/4, 25/8\nthe moon is bright\n");
    EXPECT_EQ(checked.right, 1U);
    EXPECT_EQ(checked.not_understood, 2U);
    EXPECT_EQ(checked.claims[0].verdict, ClaimVerdict::not_understood);
    EXPECT_EQ(checked.claims[2].problem->line, 3U);
}

TEST(Check, OpenValuesAreCountedApart) {
    const Checked checked = check_claims(triangle, "y=2: ?, ? -> ?..?\ny=2: ?, 25/8\ny=2: ?, 3\n");
    EXPECT_EQ(verdicts(checked), "orw");
    EXPECT_EQ(checked.open, 1U);
}

TEST(Check, PixelsOfThePicture) {
    EXPECT_EQ(verdicts(triangle, "(3,2): on\n(4,2): off\n(4,2): outside\n(-1,2): on\n"
                                 "(3,2): color black\n(3,2): color #000000\n"
                                 "(3,2): off\n(4,2): on\n(3,2): color white\n"),
              "rrrrrrwww");
}

TEST(Check, DecisionsAreThoseOfTheScenesRule) {
    // Toward zero, the row y=2 has no pixel at -1: that is right where the scene says so.
    const std::string truncated = triangle_by(R"("scalar":"exact","rounding":"truncate")");
    EXPECT_EQ(verdicts(truncated, "y=2: -> 0..3\n(-1,2): off\n"), "rr");
    EXPECT_EQ(verdicts(triangle, "y=2: -> 0..3\n(-1,2): off\n"), "wf");
}

TEST(Check, ValuesAreExactWhateverTheScalar) {
    // The nearest double of 1/3 is not 1/3, and not what is claimed.
    for (const std::string scalar : {"float", "double", "adaptive", "fixed", "exact"}) {
        const std::string scene =
            R"({"canvas":{"width":9,"height":9},"vertices":{"A":[0,0],"B":[1,3],"C":[4,0]},)"
            R"("triangles":["ABC"],"method":{"scalar":")" +
            scalar + R"("}})";
        EXPECT_EQ(verdicts(scene, "y=1: 1/3, 3\n"), "r") << scalar;
        EXPECT_EQ(verdicts(scene, "y=1: 0.3333333333333333, 3\n"), "r") << scalar;
        EXPECT_EQ(verdicts(scene, "y=1: 333333/1000000, 3\n"), "w") << scalar;
    }
}

TEST(Check, WhatTheScalarDecidesOtherwiseIsTold) {
    std::size_t differ = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const std::string scene = RandomScene(seed).text();
        if (!read_scene({"scene.json", scene}, {{"scalar", "float"}}))
            continue;
        const Truth truth({"scene.json", scene}, {{"scalar", "float"}});
        const std::size_t count = std::min(truth.decided().size(), truth.exact().size());
        std::string primitive;
        for (std::size_t n = 1; n <= count; ++n) {
            const auto kind = truth.decided().kind_of(n);
            if (truth.exact().kind_of(n) != kind)
                break; // from here on the traces tell of different things
            if (kind == StepKind::primitive)
                primitive = name_in(truth.decided().step(n)).text();
            if (kind != StepKind::scanline)
                continue;
            const auto decided = truth.decided().step(n).as<ScanlineStep>();
            const auto right = truth.exact().step(n).as<ScanlineStep>();
            if (decided.y != right.y || decided.from == right.from)
                continue;
            ++differ;
            const Checked checked = check(
                truth, claims_in(fmt::format("{0} y={1}: -> {2}..?\n{0} y={1}: -> {3}..?\n",
                                             primitive, decided.y, right.from, decided.from)));
            EXPECT_EQ(verdicts(checked), "rr") << scene;
            EXPECT_EQ(checked.claims[0].fields[0].remark,
                      fmt::format("the scene's `float` has {}, exact arithmetic {}", decided.from,
                                  right.from));
        }
    }
    EXPECT_GT(differ, 3U);
}

TEST(Check, WhatTheScalarDecidesOtherwiseIsNotToldOfWhatIsOpen) {
    // Thirds of a double, added up, fall below 1 and 2.
    const std::string thirds = example_text("tutorial/numbers/thirds.json");
    const MethodOverrides added{{"scalar", "double"}, {"lerp", "incremental"}};
    const Checked open =
        check_claims(thirds, example_text("tutorial/numbers/3-thirds.claims"), added);
    EXPECT_GT(open.open, 0U);
    for (const CheckedClaim& claim : open.claims)
        for (const CheckedField& field : claim.fields)
            EXPECT_EQ(field.remark, "") << field.name;
    const Checked decided = check_claims(thirds, "y=6: -> 2..?\n", added);
    EXPECT_EQ(decided.claims[0].fields[0].remark, "the scene's `double` has 1, exact arithmetic 2");
    EXPECT_EQ(decided.claims[0].fields[1].remark, "");
}

TEST(Check, ATraceIsHeldToWhatItTells) {
    const std::string text = trace_text(scene_in(triangle_by(R"("scalar":"double")")));
    const Truth truth(readable_trace(text));
    const Checked checked = check(truth, claims_in("y=2: -1/4, 3.125 -> -1..3\ny=2: 1/4, ?\n"
                                                   "A screen: 2, 5\nC screen: 5, 3\n"));
    EXPECT_EQ(verdicts(checked), "rwrw");
}

TEST(Check, FacesAreKnownThoughNothingIsCulled) {
    const std::string cube = example_text("t0-hidden/cube-inverse-z.json");
    const Checked checked = check_claims(cube, "normal ABC: 0, 0, -4\ncentroid ABC: 1/3, 1/3, 3\n"
                                               "view ABC: -1/3, -1/3, -3\ndot ABC: 12\n"
                                               "plane ABC: 0, 0, -4, 12\ncosine ABC: 0.9879\n"
                                               "dot ABC: 12 drawn\ndot ABC: 12 culled\n");
    EXPECT_EQ(verdicts(checked), "rrrrrrrw");
}

TEST(Check, TheFiguresNumbersAndTheirSlips) {
    // T0, figures 22 to 24 and 12 to 13.
    const std::string cube = example_text("t0-hidden/cube-culled.json");
    EXPECT_THAT(slips_of(cube, "normal ABC: 0, -4, 0\n"), ElementsAre("y-for-z"));
    EXPECT_THAT(slips_of(cube, "view ABC: 0, -4, 0\n"), ElementsAre("normal-for-view"));
    EXPECT_THAT(slips_of(cube, "view ABC: 1/3, 1/3, 3\n"), Contains("view-turned-round"));
    EXPECT_THAT(slips_of(cube, "dot ABC: -12\n"), Contains("view-turned-round"));
    // One digit of one number: nothing tells which slip it was.
    EXPECT_THAT(slips_of(cube, "E world: -1, 1, 4\n"), IsEmpty());
    EXPECT_THAT(slips_of(cube, "A screen: -3, 3\n"), Contains("truncate-for-floor"));
    EXPECT_THAT(slips_of(cube, "A canonical: -1, 1, 2\n"), ElementsAre("not-divided"));
    EXPECT_THAT(slips_of(triangle, "edge AB: 4/3\n"), ElementsAre("dx-dy-inverted"));
    EXPECT_THAT(slips_of(triangle, "y=4: 2, ?\n"), Contains("neighbor-row"));
    EXPECT_THAT(slips_of(triangle, "y=0: -> -1..3\n"), Contains("truncate-for-floor"));
}

TEST(Check, TheLineItselfRefutesASlip) {
    // 29/3 to the nearest is 10, and 19/8 would be 2 by each rule: round(5/4) is 1.
    const std::string ends = R"({"canvas":{"width":14,"height":14,"origin":"bottom-left"},
        "vertices":{"A":[5,10],"B":[3,4],"C":[12,4]},"triangles":["ABC"]})";
    EXPECT_THAT(slips_of(ends, "y=6: 11/3, 29/3 -> 4..9\n"),
                ElementsAre("inside-for-floor", "half-open-for-floor"));
    EXPECT_THAT(slips_of(triangle, "y=4: 5/4, 19/8 -> 2..2\n"),
                ElementsAre("inside-for-floor", "half-open-for-floor"));
    // Both ends by one rule.
    EXPECT_THAT(slips_of(ends, "y=6: 11/3, 29/3 -> 4..10\n"),
                AllOf(Contains("nearest-for-floor"), Not(Contains("inside-for-floor"))));
    // The other end says nothing.
    EXPECT_THAT(slips_of(ends, "y=6: 11/3, 29/3 -> 4..?\n"), Contains("nearest-for-floor"));
}

TEST(Check, ThePixelsCornerForItsCenter) {
    // The row y=2 of T0's triangle runs from -1/4 to 25/8; that of its samples, y = 5/2, from 1/8.
    const std::string by_samples = triangle_by(R"("scalar":"exact","fill":"top-left")");
    EXPECT_EQ(verdicts(by_samples, "y=2: 1/8, 47/16\n"), "r");
    EXPECT_THAT(slips_of(by_samples, "y=2: -1/4, ?\n"), Contains("corner-for-center"));
    EXPECT_THAT(slips_of(by_samples, "y=2: ?, 25/8\n"), Contains("corner-for-center"));
}

TEST(Check, ACosineGoesOnFromAWrongProduct) {
    // 13 / (4 sqrt(83) / 3) = 1.0702, where 12 gives 0.9879.
    const Checked checked = check_claims(example_text("t0-hidden/cube-culled.json"),
                                         "dot ABC: 13\ncosine ABC: 1.0702\n");
    EXPECT_EQ(verdicts(checked), "wf");
}

TEST(Check, TheStartExchangedWithTheStep) {
    // T0, figure 13: a LERP from 3 to 4 over y = -3 to 3, told as 0.16, 3.16, 6.16, ... for 3, 19/6, 10/3.
    const std::string edge = R"({"canvas":{"width":17,"height":14},
        "vertices":{"A":[-3,-3,3],"B":[-3,3,4],"C":[6,-3,3]},"triangles":["ABC"],
        "method":{"scalar":"exact","depth":"linear-z"},"keep":["depth"]})";
    EXPECT_EQ(verdicts(edge, "y=-2 depth: 19/6, ?\ny=-1 depth: 10/3, ?\n"), "rr");
    const Checked checked = check_claims(
        edge,
        "y=-3 depth: 0.16, ?\ny=-2 depth: 3.16, ?\ny=-1 depth: 6.16, ?\ny=0 depth: 9.16, ?\n");
    EXPECT_EQ(verdicts(checked), "wrww");
    // 3.16 is 19/6 cut off: where the start is 3 and k is 1, a + 3 k is right by accident.
    EXPECT_EQ(checked.claims[1].fields[0].remark, "cut off behind 2 digits, not rounded");
    EXPECT_THAT(checked.claims[1].fields[0].slips, IsEmpty());
    for (const std::size_t i : {0U, 2U, 3U})
        EXPECT_EQ(slip_names(checked.claims[i].fields[0]).at(0), "start-and-step-exchanged");
}

TEST(Check, TheCosineOfT1) {
    // T1 divides N . E by |N . E|: 1, 0/0 and -1 where it is 0.7071, 0 and -0.7071.
    const std::string angles = example_text("t1-hidden/three-angles.json");
    EXPECT_THAT(slips_of(angles, "cosine ABC: 1\n"), Contains("cosine-of-dot-only"));
}

TEST(Check, ACosineThatIsAFractionMayBeClaimedAsOne) {
    // The trace tells doubles: 0.9333333333333333 of 14/15.
    const std::string tent = example_text("tutorial/light/tent.json");
    const Checked right =
        check_claims(tent, "intensity east: 14/15\nintensity east: 0.9333333333333333\n"
                           "intensity north: 11/15\nintensity north: 0.733\n"
                           "intensity south: 1/3\n");
    EXPECT_EQ(verdicts(right), "rrrrr");
    // 14/15 + 1/1000000000
    const Checked near =
        check_claims(tent, "intensity east: 2800000003/3000000000\nintensity east: 13/15\n"
                           "intensity east: 0.93333333\nintensity east: 0.93333334\n");
    EXPECT_EQ(verdicts(near), "wwrw");
    EXPECT_EQ(near.claims[0].fields[0].expected, "14/15");

    const std::string faces = example_text("tutorial/hidden/three-faces.json");
    EXPECT_EQ(verdicts(faces, "cosine GHI: -14/15\ncosine GHI: -13/15\n"
                              "cosine ABC: 4/5\ncosine DEF: 0\n"),
              "rwrr");
    // The root of 1/2 is no fraction: 17 digits are more than the double of it has.
    const std::string angles = example_text("t1-hidden/three-angles.json");
    EXPECT_EQ(verdicts(angles, "cosine ABC: 0.70710678118654752\n"
                               "cosine ABC: 0.7071067811865\n"
                               "cosine ABC: 0.7071067821865\n"),
              "rrw");
}

TEST(Check, BresenhamsDecisions) {
    const std::string lines = example_text("t2-lines/worked-lines.json");
    EXPECT_EQ(verdicts(lines, "OP: 1 -3 3 -1 5\nAB: 4 0 12 8 4 0 12 8\n"
                              "AC: -2 4 -6 0 6 -4 2 -8\n"),
              "rrr");
    // d = 0 decided the other way: 4 is followed by 0, then by -4.
    EXPECT_THAT(slips_of(lines, "AB: 4 0 -4 8 4 0 -4 8\n"), Contains("tie-the-other-way"));
    // dy - dx = 3 - 5 to begin with.
    EXPECT_THAT(slips_of(lines, "OP: -2 1 -1 2 0\n"), Contains("factor-2-dropped"));
}

TEST(Check, AListThatEndsEarlyIsOpen) {
    const std::string lines = example_text("t2-lines/worked-lines.json"); // AB: 4 0 12 8 4 0 12 8
    const auto field = [&](const std::string& claim) {
        return check_claims(lines, claim).claims.at(0).fields.at(0);
    };
    EXPECT_EQ(field("AB: 4 0 12").verdict, ClaimVerdict::open);
    EXPECT_EQ(field("AB: 4 0 12").remark, "ends early: the first 3 of 8");
    EXPECT_TRUE(field("AB: 4 0 12").ends_early);
    EXPECT_EQ(field("AB: 4, 0, 12, ...").verdict, ClaimVerdict::right);
    EXPECT_EQ(field("AB: 4, 0, 12, ...").remark, "the first 3 of 8");
    EXPECT_EQ(field("AB: 4 0 12 8 4 0 12 8").remark, "");
    EXPECT_EQ(field("AB: 4 0 12 8 4 0 12 8 4").remark, "8 of 9 right; 8 belong");
    EXPECT_EQ(field("AB: ?").verdict, ClaimVerdict::open);
}

TEST(Check, NumbersOfAListAreMarkedOneByOne) {
    const std::string lines = example_text("t2-lines/worked-lines.json");
    // 12 + 12 where d = 0 goes straight on to 12, and 12 - 4 behind it.
    const Checked checked = check_claims(lines, "AB: 4 0 13 9 5 1\nAB: 4 1 12\n");
    const CheckedField& third = checked.claims[0].fields[0];
    EXPECT_EQ(third.place, 3U);
    EXPECT_EQ(third.expected, "12");
    EXPECT_EQ(third.found, "13");
    EXPECT_EQ(third.remark, "2 of 6 right, 3 follow; ends early: 8 belong");
    ASSERT_EQ(third.numbers.size(), 4U);
    for (std::size_t i = 1; i < 4; ++i) // each is the one before it and the right increment
        EXPECT_EQ(third.numbers[i].verdict, ClaimVerdict::follows);
    // d = 0 is followed by 12: the working of the step before it.
    EXPECT_THAT(checked.claims[0].working, Contains(HasSubstr("next d = 0 + 12 = 12")));
    EXPECT_EQ(checked.claims[1].fields[0].place, 2U);
    EXPECT_EQ(checked.claims[1].fields[0].right_numbers, 2U);
    EXPECT_EQ(checked.claims[1].fields[0].numbers.size(), 1U);
    // 8 for 2 is wrong, and 6 is neither -2 nor 8 - 4.
    const Checked ten = check_claims(R"({"canvas":{"width":16,"height":12,"origin":"bottom-left"},
        "vertices":{"A":[0,0],"B":[10,8]},"lines":["AB"],"method":{"line":"bresenham"}})",
                                     "AB: 6 8 6 14 10 6 2 -2 14 10\n");
    EXPECT_EQ(ten.claims[0].fields[0].right_numbers, 8U);
    EXPECT_EQ(ten.claims[0].fields[0].claimed_numbers, 10U);
}

TEST(Check, ATableMayHaveThePixelBeforeEachStep) {
    // d is 4 0 12 8 4 0 12 8, from (2, 5) down to (-4, -3): the first pixel stands beside an open d.
    const std::string line =
        R"({"canvas":{"width":17,"height":14},"vertices":{"A":[2,5],"B":[-4,-3]},
        "lines":["AB"],"method":{"line":"bresenham"}})";
    EXPECT_EQ(verdicts(line, "k,p_k,x,y\n0,?,2,5\n1,0,1,4\n"), "rr");
    EXPECT_EQ(verdicts(line, "k,p_k,x,y\n0,4,2,5\n1,0,1,4\n8,,-4,-3\n"), "rrr");
    EXPECT_EQ(verdicts(line, "k,p_k,x,y\n0,4,2,5\n1,0,2,4\n"), "rw");
}

TEST(Check, ACircleInTheFormsOfTextbooks) {
    // r = 8: d = 1 - 8 = -7, then + 2 x + 3 or + 2 (x - y) + 5; 2 d + 1 and d + 1/4 decide the same.
    const std::string circle = example_text("../tests/claims/circle8.json");
    EXPECT_EQ(verdicts(circle, "k: -7 -4 1 -6 3 2\n"), "r");
    const Checked doubled = check_claims(circle, "k: -13 -7 3 -11 7 5\n");
    EXPECT_EQ(verdicts(doubled), "r");
    EXPECT_EQ(doubled.claims[0].fields[0].remark, "in the form d = 3 - 2 r");
    EXPECT_EQ(verdicts(circle, "k: -27/4 -15/4 5/4 -23/4 13/4 9/4\n"), "r");
    const Checked wrong = check_claims(circle, "k: -13 -7 3 -10 7 5\n");
    EXPECT_EQ(first_wrong(wrong).expected, "-11");
    EXPECT_EQ(wrong.claims[0].fields[0].right_numbers, 5U);
    const std::string octant = "k pixels: (0,8) (1,8) (2,8) (3,7) (4,7) (5,6)";
    EXPECT_EQ(verdicts(circle, octant + " (6,5)\n" + octant + "\n"), "rr");
    EXPECT_EQ(verdicts(circle, "k pixels: (0,8) (1,8) (2,7) (3,7) (4,7) (5,6)\n"), "w");
    // All of a circle of radius 1, around.
    const std::string small = R"({"canvas":{"width":5,"height":5},"vertices":{"O":[1,0]},
        "circles":[{"center":"O","radius":1,"name":"k"}]})";
    EXPECT_EQ(verdicts(small, "k pixels: (2,0) (1,1) (0,0) (1,-1)\n"), "r");
    EXPECT_EQ(verdicts(small, "k pixels: (2,0) (1,1) (0,1) (1,-1)\n"), "w");
}

TEST(Check, AHalfGoesUpUnlessASheetIsRightByAnotherTie) {
    const std::string line = example_text("../tests/claims/dda-half-up.json");
    EXPECT_EQ(verdicts(line, example_text("../tests/claims/dda-half-up.claims")), "rrrr");
    EXPECT_EQ(verdicts(line, example_text("../tests/claims/dda-half-up.csv")), "rrr");
    const std::string to_start = "AB y=7: 5.5 -> 5\nAB y=9: 6.5 -> 6\n";
    const Checked by_start = check_claims(line, to_start);
    EXPECT_EQ(verdicts(by_start), "rr");
    EXPECT_EQ(by_start.remark, "right with `ties: start`");
    EXPECT_EQ(verdicts(line, to_start, {{"ties", "up"}}), "ww");
    // 5 for 5.5 and 7 for 6.5 are not of one tie.
    EXPECT_EQ(verdicts(line, "AB y=7: 5.5 -> 5\nAB y=9: 6.5 -> 7\n"), "wr");
}

TEST(Check, CoordinatesOfOneVertexOnSeveralLinesDoNotContradict) {
    const Checked checked =
        check_claims(triangle, "A screen: 3, ?\nA screen: ?, 5\nA screen: 2, ?\n");
    EXPECT_EQ(verdicts(checked), "wrr");
    EXPECT_THAT(checked.claims[1].remarks, IsEmpty());
    EXPECT_THAT(checked.claims[2].remarks, ElementsAre("contradicts line 1"));
}

TEST(Check, AListMayHaveTooFewNumbers) {
    // A vertex may be given without its z of 0, though wrong.
    const Checked vertex = check_claims(triangle, R"({"claims":[
        {"step":"vertex","name":"A","space":"object","at":[1, 5]},
        {"step":"vertex","name":"A","space":"object","at":[2]}]})");
    ASSERT_EQ(verdicts(vertex), "ww");
    EXPECT_EQ(vertex.claims[0].fields[0].remark, "");
    EXPECT_EQ(vertex.claims[1].fields[0].remark, "1 value, where 3 belong");
}

TEST(Check, APictureShowsWhereItDiffers) {
    EXPECT_EQ(verdicts(triangle, "picture:\n......#...\n.....##...\n....###...\n"
                                 "...#####..\n...#####..\n..######..\n.########.\n"
                                 "#########.\n##########\n"),
              "r");
    const Checked checked = check_claims(triangle, "picture:\n......#...\n.....##...\n....###...\n"
                                                   "....####..\n...######.\n..######..\n"
                                                   ".########.\n#########.\n##########\n");
    ASSERT_EQ(verdicts(checked), "w");
    EXPECT_THAT(checked.claims[0].picture,
                ElementsAre("   5  ......#...", "   4  .....##...", "   3  ....###...",
                            "   2  ...?####..  -1/4, 25/8 -> -1..3",
                            "   1  ...#####!.  -1, 7/2 -> -1..3", "   0  ..######..",
                            "  -1  .########.", "  -2  #########.", "  -3  ##########"));
}

TEST(Check, ContradictionsAreTold) {
    const Checked checked = check_claims(triangle, "y=2: -1/4, ?\ny=3: 1/2, ?\ny=2: 1/4, ?\n");
    EXPECT_EQ(verdicts(checked), "rrw");
    EXPECT_THAT(checked.claims[2].remarks, ElementsAre("contradicts line 1"));
}

TEST(Check, WhatTheSceneDoesNotHave) {
    expect_problem(triangle, "D screen: 1, 2\n",
                   "claims:1:1: expected a vertex of the scene (A, B, C), found \"D\"",
                   "a line looks like `A screen: 2, 5`");
    expect_problem(
        triangle, "A clip: 1, 2, 3, 4\n",
        "claims:1:3: expected a space that A is in (object, world, camera, screen), found clip",
        "a line looks like `A screen: 2, 5`");
    expect_problem(triangle, "normal ABD: 1, 2, 3\n",
                   "claims:1:8: expected a face of the scene (ABC), found \"ABD\"",
                   "did you mean ABC?");
    expect_problem(
        triangle, "(9,2): z 3\n",
        "claims:1:2: expected a pixel of the canvas (x -8 to 8, y -6 to 7), found (9, 2)",
        "a line looks like `(3,2): on`, `(3,2): z 10/3`");
    EXPECT_EQ(verdicts(triangle, "(9,2): on\n(9,2): off\n"), "wr");
    expect_problem(triangle, "(3,2): z 3\n",
                   "claims:1:10: expected a scene with a depth buffer, found one without",
                   "--depth inverse-z gives it one");
    expect_problem(triangle, "AB: 1 2 3\n",
                   "claims:1:1: expected a claim about something that the trace tells, found one "
                   "about `decide`, of which it has no step",
                   "lines are drawn so by --line bresenham");
    const Checked row = check_claims(triangle, "y=6: 1, 2\n");
    EXPECT_EQ(verdicts(row), "w");
    EXPECT_THAT(row.claims[0].remarks, ElementsAre("there is no such row: rows are y=-3 to 5"));
}

TEST(Check, AClaimSaysWhichPrimitiveIsMeant) {
    const std::string two = R"({"canvas":{"width":9,"height":9},
        "vertices":{"A":[0,0],"B":[0,3],"C":[3,0],"D":[-3,0]},"triangles":["ABC","ABD"]})";
    expect_problem(
        two, "y=1: 0, 2\n",
        "claims:1:1: expected a claim about one step, found one about 2 of kind `scanline`",
        "say which is meant: ABC, ABD; ABC y=2: ..., or \"in\": \"ABC\"");
    EXPECT_EQ(verdicts(two, "ABC y=1: 0, 2\nABD y=1: -2, 0\n"), "rr");
}

TEST(Check, AClaimSaysWhatItIsAbout) {
    EXPECT_EQ(
        problem_of_claims(triangle, R"({"claims":[{"step":"vertex","space":"eye","at":[1,2,3]}]})"),
        "claims:1:12: expected the `name` that this claim is about, found none\n"
        "{\"claims\":[{\"step\":\"vertex\",\"space\":\"eye\",\"at\":[1,2...\n           ^");
    EXPECT_EQ(verdicts(triangle, "edge BA: 3/4\n"), "r"); // from either end
}

TEST(Check, NamesMayLookLikeNumbers) {
    const std::string digits = R"({"canvas":{"width":17,"height":14},
        "vertices":{"0":[2,5],"1":[-4,-3],"2":[5,-3]},"triangles":["012"],"lines":["01"]})";
    EXPECT_EQ(verdicts(digits, "012 y=2: -1/4, 25/8 -> -1..3\n(3,2) 012: inside\n"
                               "012 edge 01: 3/4\n01: 4 0 12 8 4 0 12 8\n"),
              "rrrr");
}

TEST(Check, ALineMayLeaveTheCanvas) {
    const std::string off = R"({"canvas":{"width":8,"height":4,"origin":"bottom-left"},
        "vertices":{"A":[-3,0],"B":[5,2]},"lines":["AB"]})";
    EXPECT_EQ(verdicts(off, "AB: -4 0 4 -8 -4 0 4 -8\n"), "r");
    EXPECT_EQ(verdicts(off, "AB: -4 0 4 -8 -4 0 4 8\n"), "w");
    const std::string far = R"({"canvas":{"width":8,"height":8},
        "vertices":{"A":[-3,0],"B":[2000000000,3]},"lines":["AB"]})";
    EXPECT_EQ(verdicts(far, "AB: 1 2 3\n"), "w");
}

/// A trace that some steps were left out of.
Truth truth_of_kinds(const std::string& scene, std::vector<StepKind> kinds) {
    return Truth(
        readable_trace(trace_text(scene_in(scene), {.filter = {.only = std::move(kinds)}})));
}

TEST(Check, WhatATraceLacksIsNotGuessed) {
    const Truth rows = truth_of_kinds(triangle, {StepKind::scanline});
    EXPECT_EQ(verdicts(check(rows, claims_in("y=2: -1/4, 25/8\n"))), "r");
    EXPECT_THROW(check(rows, claims_in("(3,2): on\n")), Problem);
    EXPECT_THROW(check(rows, claims_in("picture:\n#\n")), Problem);
    EXPECT_THROW(check(rows, claims_in("edge AB: 3/4\n")), Problem);
    // Without its primitive, an edge has no working: it is right or wrong, and no slip is named.
    const Truth edges = truth_of_kinds(triangle, {StepKind::edge});
    const Checked checked = check(edges, claims_in("edge AB: 3/4\nedge AB: 4/3\n"));
    EXPECT_EQ(verdicts(checked), "rw");
    EXPECT_THAT(checked.claims[1].fields[0].slips, IsEmpty());
    // A trace that breaks off may have told the row.
    std::string text = trace_text(scene_in(triangle));
    text.resize(text.find(R"({"step":"scanline","y":2)"));
    const Checked cut =
        check(Truth(readable_trace(text)), claims_in("y=3: 1/2, 11/4\ny=2: 1, 2\n"));
    EXPECT_EQ(verdicts(cut), "ro");
    EXPECT_THAT(cut.claims[1].remarks,
                ElementsAre("steps were left out of the trace: it may be one of these"));
}

TEST(Check, APainterMayHaveNothingToSort) {
    const std::string line = R"({"canvas":{"width":8,"height":4,"origin":"bottom-left"},
        "vertices":{"A":[0,0],"B":[5,2]},"lines":["AB"],"method":{"depth":"painter"}})";
    EXPECT_EQ(verdicts(line, "(0,0): on\n"), "r");
}

TEST(Check, TheViewIsTowardTheEyeWhateverCulls) {
    const std::string by_light = R"({"canvas":{"width":8,"height":8},
        "vertices":{"A":[0,0,3],"B":[1,1,3],"C":[1,0,3]},"triangles":["ABC"],
        "projection":{"type":"pinhole","distance":1},"light":{"direction":[0,0,-1]},
        "method":{"scalar":"exact","cull":"light","shade":"lambert"}})";
    EXPECT_EQ(verdicts(by_light, "view ABC: -2/3, -1/3, -3\n"), "r");
}

TEST(Check, AVerdictAndTheNumberBesideItAreOfOneTest) {
    // The normal is (0, 0, -1). The eye sees ABC, by 3; the light comes from behind it, by -1.
    const std::string by_light = R"({"canvas":{"width":8,"height":8},
        "vertices":{"A":[0,0,3],"B":[1,1,3],"C":[1,0,3]},"triangles":["ABC"],
        "projection":{"type":"pinhole","distance":1},"light":{"direction":[0,0,1]},
        "method":{"scalar":"exact","cull":"light","shade":"lambert"}})";
    EXPECT_EQ(verdicts(by_light, "dot ABC: -1 culled\nABC: culled\ndot ABC: -1 ?\n"), "rrr");
    EXPECT_EQ(verdicts(by_light, "dot ABC: 3\n"), "r"); // normal . view, alone
    for (const std::string wrong : {"3 culled", "-1 drawn", "3 drawn"})
        EXPECT_EQ(verdicts(by_light, "dot ABC: " + wrong + "\n"), "w") << wrong;
}

TEST(Check, WhereNothingIsCulledAllIsDrawn) {
    const std::string turned = R"({"canvas":{"width":20,"height":20},
        "vertices":{"A":[-1,1,3],"B":[1,1,3],"C":[1,-1,3]},"triangles":["ACB"],
        "projection":{"type":"pinhole","distance":1},"method":{"scalar":"exact"}})";
    const Checked checked = check_claims(turned, "ACB: drawn\nACB: culled\n");
    EXPECT_EQ(verdicts(checked), "rw");
    EXPECT_THAT(checked.claims[1].remarks, Contains("the scene culls nothing"));
    EXPECT_EQ(checked.claims[0].fields[0].remark, "");
}

TEST(Check, AnOpenVerdictIsThatOfAFace) {
    const std::string tent = example_text("tutorial/light/tent.json");
    const Checked open = check_claims(tent, "east: ?\neast: drawn\n");
    EXPECT_EQ(verdicts(open), "or");
    EXPECT_EQ(open.claims[0].fields[0].name, "culled");
    expect_problem(
        tent, "esat: ?\n",
        "claims:1:1: expected a face of the scene (east, north, south, west), found \"esat\"",
        "did you mean east?");

    // The name of a line is about its decisions, beside faces too.
    const std::string both = R"({"canvas":{"width":9,"height":9},
        "vertices":{"A":[0,0],"B":[3,1],"C":[0,3]},"triangles":["ABC"],"lines":["AB"],
        "method":{"scalar":"exact"}})";
    const Checked of_line = check_claims(both, "AB: ?\nABC: ?\n");
    EXPECT_EQ(verdicts(of_line), "oo");
    EXPECT_EQ(of_line.claims[0].fields[0].name, "d");
    EXPECT_EQ(of_line.claims[1].fields[0].name, "culled");
}

TEST(Check, NoSlipGivesAPartOfAList) {
    const Checked checked =
        check_claims(triangle, R"({"claims":[{"step":"face","name":"ABC","normal":[0]}]})");
    EXPECT_EQ(verdicts(checked), "w");
    EXPECT_THAT(checked.claims[0].fields[0].slips, IsEmpty());
}

TEST(Check, EqualDepthsAreNoMatterOfZ) {
    const std::string equal = R"({"canvas":{"width":10,"height":10,"origin":"bottom-left"},
        "vertices":{"A":[1,1,2],"B":[8,1,2],"C":[1,8,2],"D":[8,8,2]},
        "triangles":["ABC","ABD"],"method":{"scalar":"exact","depth":"linear-z"}})";
    EXPECT_THAT(slips_of(equal, "depth ABD (2,1): passes\n"), IsEmpty());
}

TEST(Check, TwoRoundingsDoNotContradict) {
    const Checked checked = check_claims(triangle, "y=-2: -3.3, ?\ny=-2: -13/4, ?\n");
    EXPECT_EQ(verdicts(checked), "rr");
    EXPECT_THAT(checked.claims[1].remarks, IsEmpty());
}

TEST(Check, APlaceAndItsPixelAreTwoThings) {
    const Checked checked =
        check_claims(example_text("t0-hidden/cube-culled.json"), "A screen: -3, 3 -> -4, 3\n");
    EXPECT_EQ(verdicts(checked), "w");
    EXPECT_EQ(checked.claims[0].fields[0].expected, "-10/3, 10/3");
    EXPECT_EQ(checked.claims[0].fields[1].verdict, ClaimVerdict::right);
}

TEST(Check, ATraceOfRoundedNumbersTakesTheFraction) {
    const std::string sevenths = R"({"canvas":{"width":17,"height":14},
        "vertices":{"A":[2,5],"B":[-4,-2],"C":[5,-3]},"triangles":["ABC"],"method":{"scalar":")";
    for (const std::string scalar : {"float", "double", "adaptive"}) {
        const Truth truth(readable_trace(trace_text(scene_in(sevenths + scalar + "\"}}"))));
        EXPECT_EQ(
            verdicts(check(truth, claims_in("edge AB: 6/7\ny=1: -10/7, 7/2\nedge AB: 7/8\n"))),
            "rrw")
            << scalar;
    }
}

TEST(Check, ADecimalMayBeLong) {
    const std::string thirds = R"({"canvas":{"width":17,"height":14},
        "vertices":{"A":[0,0],"B":[2,3],"C":[4,0]},"triangles":["ABC"],"method":{"scalar":"exact"}})";
    EXPECT_EQ(verdicts(thirds, "y=1: 0." + std::string(99, '6') + "7, ?\n"), "r");
}

/// A step as a claim, and what tells it from the others: its key fields, and the primitive or the side.
struct CopiedStep {
    std::string claim;
    std::string keys;
};

CopiedStep copied(const StepView& step, const std::string& in) {
    CopiedStep copy{std::string(step.json()), step.kind_name()};
    const auto& fields = fields_of(*step.kind());
    const bool has_name = std::any_of(fields.begin(), fields.end(),
                                      [](const auto& field) { return field.name == "name"; });
    if (!in.empty() && !has_name) {
        copy.claim.insert(copy.claim.size() - 1, R"(,"in":")" + in + '"');
        copy.keys += in;
    }
    for (const StepField& field : fields)
        if (field.role == FieldRole::key)
            copy.keys.append(" ").append(step.field(field.name).value_or(""));
    return copy;
}

/// Each step of a trace as a claim: whoever copies them is right. Left out are pixels, which are claimed of the
/// final picture, what has nothing to claim but its place, and steps that keys do not tell apart, such as the
/// decisions of a fan's lines in one pixel.
std::string steps_as_claims(const Trace& trace) {
    std::vector<CopiedStep> copies;
    std::multiset<std::string> keys;
    std::string in;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const StepView step = trace.step(n);
        const StepKind kind = *step.kind();
        if (kind == StepKind::primitive)
            in = name_in(step).text();
        if (kind == StepKind::edge && step.as<EdgeStep>().octant)
            in = step.as<EdgeStep>().edge.text();
        if (kind == StepKind::pixel || kind == StepKind::reject || kind == StepKind::undecided ||
            kind == StepKind::ray)
            continue;
        copies.push_back(copied(step, in));
        keys.insert(copies.back().keys);
    }
    std::string claims;
    for (const CopiedStep& copy : copies)
        if (keys.count(copy.keys) == 1)
            claims += (claims.empty() ? "" : ",\n") + copy.claim;
    return R"({"claims":[)" + claims + "]}";
}

TEST(Check, WhoeverCopiesTheTraceIsRight) {
    std::size_t checked_claims = 0;
    for (std::uint64_t seed = 1; seed <= random_cases(200U); ++seed) {
        const std::string scene = RandomScene(seed).text();
        auto read = read_scene({"scene.json", scene}, {{"scalar", "exact"}});
        if (!read)
            continue;
        const Trace trace = trace_of(read.value().scene);
        const std::string claims = steps_as_claims(trace);
        if (claims.ends_with("[]}"))
            continue;
        try {
            const Checked checked = check_claims(scene, claims);
            checked_claims += checked.claims.size();
            for (const CheckedClaim& claim : checked.claims)
                for (const CheckedField& field : claim.fields) {
                    EXPECT_TRUE(field.verdict == ClaimVerdict::right ||
                                field.verdict == ClaimVerdict::open)
                        << "seed " << seed << ": " << field.name << " expected " << field.expected
                        << " found " << field.found << "\n"
                        << claims_in(claims).claims[claim.claim].text << "\n"
                        << scene;
                    EXPECT_THAT(field.slips, IsEmpty());
                }
        } catch (const Problem& problem) {
            ADD_FAILURE() << "seed " << seed << ": " << to_text(problem) << "\n" << scene;
        }
        if (HasFailure())
            return;
    }
    EXPECT_GT(checked_claims, random_cases(10'000U));
}

} // namespace
} // namespace rastertrace
