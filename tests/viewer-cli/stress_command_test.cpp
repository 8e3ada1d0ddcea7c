// SPDX-License-Identifier: MIT
// `rastertrace stress` as a user calls it: the catalogue, and what it finds in a scene.

#include "program.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <string>

namespace rastertrace {
namespace {

TEST_F(ProgramTest, StressListsEveryCaseInOneLine) {
    const Outcome table = run("stress --quick");
    EXPECT_EQ(table.status, 0) << table.out;
    EXPECT_EQ(table.err, "");
    EXPECT_THAT(table.out,
                StartsWith("case what                                     result         "
                           "rows: one scalar and one method each\n"
                           "\n"
                           "lines\n"
                           "L1   one tie                                  as documented  "
                           "right "));
    EXPECT_THAT(table.out, HasSubstr("\nX9   the trace without stages left out"));
    EXPECT_THAT(table.out, HasSubstr("\n80 cases, "));
    EXPECT_THAT(table.out, HasSubstr("\nEvery row is as documented: "));
    std::istringstream lines(table.out);
    for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 100u) << line;
}

TEST_F(ProgramTest, StressShowsACaseInFull) {
    EXPECT_THAT(
        run("stress --case s6"),
        Prints(AllOf(
            StartsWith("S6  a step that is absorbed  (scanline fill)\n"
                       "\n"
                       "  input   edge (16777216,0)-(16777218,2000), floored\n"
                       "  why     1/1000 added to 2^24 is nothing: float's next number is 2 away\n"
                       "  holds   16777216 + floor(y/1000). "),
            HasSubstr("\n  incremental, x += dx/dy\n"
                      "    float                           wrong     1001 rows wrong, at most 2 "
                      "px; of 2001, first at\n"
                      "                                              y=1000\n"),
            HasSubstr(
                "\n    double                          within    off by at most 1.8e-09 px\n"),
            EndsWith(
                "\n  see     there is no scene to look at: this is a computation, or is refused\n"
                "\n"
                "as documented\n"))));
    // Two cases by one list or by two options, each once.
    const std::string two = run("stress --case S1,C15").out;
    EXPECT_EQ(run("stress --case S1 --case c15 --case S1").out, two);
    EXPECT_THAT(two, HasSubstr("\nas documented\n\nC15  a T-junction  (edge functions)\n"));
    EXPECT_THAT(two,
                HasSubstr("          rastertrace stress --case C15 --scene 2 | rastertrace show "
                          "-   # an overlap\n"));
}

TEST_F(ProgramTest, StressPrintsTheSceneOfACaseToDraw) {
    const Outcome shown = run("stress --case S1 --scene | $rastertrace show - --bare");
    EXPECT_EQ(shown.status, 0) << shown.err;
    EXPECT_EQ(shown.out, run("show $examples/t0-fill/first-triangle.json --bare").out);
    EXPECT_NE(run("stress --case C15 --scene 2").out, run("stress --case C15 --scene").out);
    // A case that asks to be looked at can be.
    EXPECT_EQ(run("stress --case P2 --scene | $rastertrace stats - --json").status, 0);
}

TEST_F(ProgramTest, StressWritesJson) {
    const Outcome outcome = run("stress --case S3,C10 --json");
    EXPECT_EQ(outcome.status, 0);
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["failed"], nlohmann::json::array());
    ASSERT_EQ(json["cases"].size(), 2u);
    const auto& s3 = json["cases"][0];
    EXPECT_EQ(s3["id"], "S3");
    EXPECT_EQ(s3["family"], "scanline fill");
    EXPECT_EQ(s3["as_documented"], true);
    EXPECT_EQ(s3["scenes"], nlohmann::json::array({""}));
    const auto row = std::find_if(s3["rows"].begin(), s3["rows"].end(), [](const auto& one) {
        return one["scalar"] == "double" && one["method"] == "scanline, incremental";
    });
    ASSERT_NE(row, s3["rows"].end());
    EXPECT_EQ(*row, nlohmann::json::parse(R"({"scalar": "double", "method": "scanline, incremental",
        "verdict": "wrong", "as_documented": true, "wrong": 1, "unit": "pixel",
        "note": "36 pixels", "documented": {"verdict": "wrong", "wrong": 1}})"));
    const auto& refused = json["cases"][1]["rows"][1];
    EXPECT_EQ(refused["verdict"], "refused");
    EXPECT_THAT(refused["message"].get<std::string>(), HasSubstr("vertex A at (-1e+30, -1e+30)"));
}

TEST_F(ProgramTest, StressLooksForCliffsInAScene) {
    const std::string scene = "$examples/t0-fill/first-triangle.json";
    EXPECT_EQ(run("stress --fill top-left " + scene).out.substr(0, 15), "First triangle\n");
    write("s3.json", R"({"title": "\u001b[2J", "canvas": {"width": 8, "height": 12,
        "origin": "top-left"}, "vertices": {"A": [0, 0], "B": [1, 10], "C": [5, 10]},
        "triangles": ["ABC"]})");
    EXPECT_THAT(run("stress s3.json --lerp incremental"),
                Ends(0,
                     StartsWith("<U+001B>[2J\n"
                                "\n"
                                "edges on samples, or within 2^-20 px of them: the tie rule or the "
                                "rounding decides\n"
                                "  edge CA of triangle ABC                 passes exactly through "
                                "6 row ends, one at pixel (0, 0)\n"
                                "  edge AB of triangle ABC                 passes exactly through "
                                "2 row ends, one at pixel (0, 0)\n"
                                "  edge BC of triangle ABC                 lies on row 10\n"
                                "\n"
                                "drawn with pixels that differ from `exact`\n"
                                "float      0 of 35\n"
                                "double     1 of 36, first (0, 10)\n"),
                     ""));
    const auto json = nlohmann::json::parse(run("stress s3.json --lerp incremental --json").out);
    EXPECT_EQ(json["cliffs"][0]["cliff"], "sample-on-edge");
    EXPECT_EQ(json["cliffs"][0]["worst"].size(), 3u);
    EXPECT_EQ(json["pictures"][1], nlohmann::json::parse(R"({"scalar": "double", "pixels": 36,
        "differing": 1, "first": [0, 10]})"));
    write("calm.json", R"({"canvas": {"width": 16, "height": 16, "origin": "top-left"},
        "vertices": {"A": [1.25, 1.75], "B": [13.5, 3.25], "C": [4.75, 12.5]},
        "triangles": ["ABC"], "method": {"fill": "top-left"}})");
    EXPECT_THAT(run("stress calm.json").out,
                StartsWith("calm.json\n"
                           "\n"
                           "Near no cliff: no sample within 2^-20 px of an edge, no sliver, "
                           "nothing steep, deep, far out\n"
                           "or edge-on.\n"));
}

TEST_F(ProgramTest, StressRefusesWhatItCannotRun) {
    EXPECT_EQ(refusal("stress --case S19"),
              "rastertrace: --case: expected a case of the catalogue, L1 to L13, S1 to S14, C1 to "
              "C18, Z1 to Z14, P1 to P12 or X1 to X9, found \"S19\"\nhint: did you mean S1?\n");
    EXPECT_EQ(refusal("stress --case Z5 --scene"),
              "rastertrace: --scene: expected a case with a scene, found Z5, which is a "
              "computation, or is refused\n");
    EXPECT_EQ(refusal("stress --case C15 --scene 3"),
              "rastertrace: --scene: expected a scene from 1 to 2 of C15, found 3\n");
    EXPECT_THAT(refusal("stress --scene"), HasSubstr("hint: say --case S1 --scene\n"));
    EXPECT_THAT(refusal("stress --case S1,S2 --scene"), HasSubstr("found \"S1,S2\"\n"));
    EXPECT_EQ(refusal("stress x.json --case S1"),
              "rastertrace: --case: expected cases, or a scene, not both, found \"x.json\"\n");
    EXPECT_EQ(refusal("stress --case L1,L2 L4"),
              "rastertrace: --case: expected cases, or a scene, not both, found \"L4\"\n"
              "hint: several cases are one word: --case L1,L2,L4\n");
    EXPECT_THAT(
        refusal("stress --fan-passes 2"),
        StartsWith("rastertrace: --fan-passes: expected a scene to draw by another method"));
    EXPECT_THAT(refusal("stress $examples/t0-fill/first-triangle.json --scalar double"),
                StartsWith("rastertrace: --scalar: expected no scalar"));
    EXPECT_THAT(refusal("stress no-such-file.json"),
                StartsWith("rastertrace: no-such-file.json: "));
    // Nothing to look at.
    write("empty.json", R"({"vertices": {"A": [1, 2]}})");
    EXPECT_THAT(refusal("stress empty.json"),
                HasSubstr("expected at least one primitive, found none"));
    write("nan.json", R"({"vertices": {"A": [NaN, 2]}, "triangles": ["AAA"]})");
    EXPECT_THAT(refusal("stress nan.json"), StartsWith("rastertrace: nan.json:1:21: "));
}

} // namespace
} // namespace rastertrace
