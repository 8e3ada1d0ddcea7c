// SPDX-License-Identifier: MIT
// `rastertrace check` as a student and a teacher meet it. The numbers are those of the texts.

#include "program.h"

#include <rastertrace/trace/check/slips.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

/// With T0's triangle as scene.json, and two students.
class CheckTest : public ProgramTest {
protected:
    CheckTest() {
        fs::copy(fs::path(RASTERTRACE_EXAMPLES) / "t0-fill/first-triangle.json",
                 folder_ / "scene.json");
        write("anna.txt", "y=4: 1.25, 2.375 -> 1..2\n"
                          "y=2: -1/4, 25/8 -> 0..3   # rounded toward 0\n"
                          "y=1: ?, 7/2\n"
                          "(3,2): ?\n"
                          "(0,2): on\n");
        write("ben.txt", "scene: scene.json\n"
                         "edge AB: 4/3\n"
                         "y=4: 1.4, 2.38\n");
    }
};

TEST_F(CheckTest, AWrongLineIsToldWithItsValueItsWorkingAndTheSlip) {
    EXPECT_THAT(run("check scene.json anna.txt"),
                Ends(1,
                     AllOf(StartsWith("anna.txt:2: y=2: -1/4, 25/8 -> 0..3\n"
                                      "    first pixel: expected -1, found 0\n"
                                      "    likely slip truncate-for-floor: rounding toward 0"),
                           HasSubstr("\n        left AB: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = "
                                     "(-4 - 2)/(-3 - 5) (2 - 5) + 2 = "),
                           EndsWith("\n\n3 right, 1 wrong, 1 open\n")),
                     ""));
}

TEST_F(CheckTest, WhatIsRightIsOnlyCounted) {
    write("right.txt", "scene: scene.json\ny=2: -1/4, 25/8 -> -1..3\n(-2,2): off\n");
    EXPECT_THAT(run("check right.txt"), Prints("2 right, 0 wrong\n"));
}

/// A(0, 0) B(8, 5) C(9, 5) on whole points: the row y = 2 goes from 3.2 to 3.6, the row y = 4 from 6.4 to 7.2.
TEST_F(CheckTest, AnEmptyRowIsWrittenWithAnyFirstPixel) {
    write("sliver.json", R"({"canvas": {"width": 12, "height": 8, "origin": "bottom-left"},
        "vertices": {"A": [0, 0], "B": [8, 5], "C": [9, 5]}, "triangles": ["ABC"],
        "method": {"scalar": "exact", "fill": "top-left", "sample": "integer"}})");
    for (const std::string row : {"2..1", "3..2", "4..3", "9..8"}) { // y = 2: from 3.2 to 3.6
        write("empty.txt", "scene: sliver.json\ny=2: " + row + "\n");
        EXPECT_EQ(run("check empty.txt").out, "1 right, 0 wrong\n") << row;
    }
    for (const std::string row : {"3..3", "3..1", "4..4"}) {
        write("empty.txt", "scene: sliver.json\ny=2: " + row + "\n");
        EXPECT_EQ(run("check empty.txt").status, 1) << row;
    }
    write("full.txt", "scene: sliver.json\ny=4: 8..7\n"); // it has the pixel 7
    EXPECT_EQ(run("check full.txt").status, 1);
}

/// Who says that a drawn pixel is not is told by which rule it is, with the numbers of the edge.
TEST_F(CheckTest, AWrongOutsideIsToldWhyItIsInside) {
    write("corner.json", R"({"canvas": {"width": 9, "height": 8, "origin": "bottom-left"},
        "vertices": {"P": [0, 0], "Q": [6, 3], "R": [2, 6]}, "triangles": ["PQR"],
        "method": {"scalar": "exact", "fill": "top-left", "sample": "integer"}})");
    write("corner.txt", "scene: corner.json\n(1,3): off\n");
    EXPECT_THAT(run("check corner.txt").out,
                AllOf(HasSubstr("        drawn by PQR at step "),
                      HasSubstr("        E of RP at (1, 3) = 6 (-1) + (-2) (-3) = 0: on a top or "
                                "left edge, inside\n")));
}

/// Who has taken the color of the nearest where a painter has painted over it is told who painted last.
TEST_F(CheckTest, AWrongColorIsToldWhoWroteThePixel) {
    write("painted.txt", "scene: painter.json\n(9,3): color blue\n");
    fs::copy(fs::path(RASTERTRACE_EXAMPLES) / "tutorial/hidden/painter.json",
             folder_ / "painter.json");
    EXPECT_THAT(run("check painted.txt").out,
                ContainsRegex("        drawn by ABC at step [0-9]+, over GHI\n"
                              "        pixel \\(9, 3\\).*\n"
                              "        pixel \\(9, 3\\).* over step "));
}

/// Stretched, turned and moved, in place of moved, turned and stretched: B(1, -1, -1) comes to (2, 2, -1) both ways.
TEST_F(CheckTest, StepsInTheOppositeOrderAreNamed) {
    fs::copy(fs::path(RASTERTRACE_EXAMPLES) / "tutorial/pipeline/backward.json",
             folder_ / "backward.json");
    write("steps.txt", "scene: backward.json\nA world: 0, 2, 1\nB world: 2, 2, -1\n"
                       "C world: 0, -2, -1\nD world: 2, -2, 1\n");
    const std::string told = run("check steps.txt").out;
    EXPECT_THAT(told, EndsWith("\n\n1 right, 3 wrong\n"));
    for (const std::string line :
         {"2: A world: 0, 2, 1", "4: C world: 0, -2, -1", "5: D world: 2, -2, 1"})
        EXPECT_THAT(told, ContainsRegex(line + "\n    .*\n    likely slip factors-exchanged: "));
}

TEST_F(CheckTest, ARoundedDecimalIsRightAndSaysSo) {
    write("rounded.txt", "y=4: 1.25, 2.38\n");
    EXPECT_EQ(run("check scene.json rounded.txt").out, "rounded.txt:1: y=4: 1.25, 2.38\n"
                                                       "    right end: right, rounded to 2 digits\n"
                                                       "\n"
                                                       "1 right, 0 wrong\n");
    write("cut.txt", "y=0: -1.75, 3.8\n");
    EXPECT_EQ(run("check scene.json cut.txt").status, 0);
    write("cut.txt", "round: nearest\ny=0: -1.75, 3.8\n");
    EXPECT_EQ(run("check scene.json cut.txt").status, 1);
}

TEST_F(CheckTest, WhatGoesOnFromAWrongNumberIsCountedApart) {
    // T0, figures 22 to 24: both vectors are wrong, and then 16 is their product.
    EXPECT_THAT(
        run("check $examples/claims/t0-figs-22-24.claims"),
        Ends(1, AllOf(HasSubstr("dot ABC: 16\n    dot: expected 12, found 16; follows from line "),
                      HasSubstr("\n        worked out as for line "),
                      EndsWith("\n1 right, 2 wrong, 2 that follow\n"))));
}

TEST_F(CheckTest, WhatGoesOnFromItsOwnLineNamesTheNumber) {
    write("cut.txt", "y=2: 1/4, 25/8 -> 0..3\n");
    EXPECT_THAT(run("check scene.json cut.txt").out,
                HasSubstr("\n    left end: expected -1/4, found 1/4\n"
                          "    first pixel: expected -1, found 0; follows from its left end\n"));
    write("two.txt", "edge AB: 4/3\ny=4: 2/3, 19/8\n");
    EXPECT_THAT(run("check scene.json two.txt").out,
                HasSubstr("    left end: expected 5/4, found 2/3; follows from line 1\n"));
}

TEST_F(CheckTest, ARightNumberThatWasRoundedIsSaidToBeWhereItComesFrom) {
    write("rounded.txt", "edge AC: -0.38\ny=-3: -4, 5.04\n"); // 2 + 8 (0.38), where 2 + 8 (3/8) = 5
    EXPECT_THAT(
        run("check scene.json rounded.txt").out,
        HasSubstr(
            "    right end: expected 5, found 5.04; follows from line 1, which is rounded\n"));
}

TEST_F(CheckTest, ATableIsAnsweredInItsWordsAndJsonInNamesOfFields) {
    write("table.txt", "(1,4): off\n(5,5): inside\n");
    EXPECT_THAT(run("check scene.json table.txt").out,
                AllOf(HasSubstr("\n    pixel: expected on, found off\n"),
                      HasSubstr("\n    pixel: expected outside, found inside\n")));
    const std::string json = R"({"claims":[{"step":"pixel","x":1,"y":4,"plotted":false},
        {"step":"scanline","y":2,"from":0}]})";
    write("claims.json", json);
    EXPECT_THAT(run("check scene.json claims.json").out,
                AllOf(HasSubstr("\n    plotted: expected true, found false\n"),
                      HasSubstr("\n    from: expected -1, found 0\n")));
    const std::string faces = "$examples/tutorial/hidden/view-turned-round.claims";
    EXPECT_THAT(run("check " + faces).out,
                HasSubstr("\n    face: expected drawn, found culled; follows from its dot\n"));
}

TEST_F(CheckTest, EndsOfARowThatWereExchangedAreToldWithTheSlipOfEach) {
    const auto check_row = [this](const std::string& row) {
        write("row.txt", "scene: whose-slip.json\n" + row + "\n");
        return run("check row.txt").out;
    };
    fs::copy(fs::path(RASTERTRACE_EXAMPLES) / "tutorial/filling/whose-slip.json",
             folder_ / "whose-slip.json");
    // Row y = 1 of A(1, 3) B(-3, -3) C(6, -2) goes from -1/3 to 3.
    EXPECT_THAT(check_row("y=1: 3, -1/3"), AllOf(HasSubstr("    right end: expected 3, found -1/3\n"
                                                           "    left and right are exchanged\n"),
                                                 Not(HasSubstr("likely slip"))));
    // y1 - y for y - y1 gives 7/3 on the left and -1 on the right; then somebody has sorted them.
    EXPECT_THAT(
        check_row("y=1: -1, 7/3"),
        HasSubstr("    right end: expected 3, found 7/3\n"
                  "    likely slip sign: losing or adding a minus instead of keeping each sign\n"
                  "    left and right are exchanged\n"));
    EXPECT_THAT(check_row("y=1: 7/3, -1"),
                AllOf(HasSubstr("    likely slip sign: "), Not(HasSubstr("exchanged"))));
    // The same of the left end alone, which still is the smaller one.
    EXPECT_THAT(check_row("y=1: 7/3, 3"),
                AllOf(HasSubstr("    likely slip sign: "), Not(HasSubstr("exchanged"))));
    // dx/dy turned over gives 1 + 3/2 (-2) = -2 on the left.
    EXPECT_THAT(
        check_row("y=1: 3, -2"),
        HasSubstr("    likely slip dx-dy-inverted: dx/dy = (y2 - y1)/(x2 - x1) instead of dx/dy = "
                  "(x2 - x1)/(y2 - y1)\n    left and right are exchanged\n"));
    EXPECT_THAT(check_row("y=1: 17, 19"), Not(HasSubstr("exchanged")));
}

TEST_F(CheckTest, APictureIsComparedPixelByPixel) {
    // Rounded toward 0; one row is left open.
    write("picture.txt", "picture:\n......#...\n.....##...\n....###...\n....####..\n...#####..\n"
                         "...#####..\n..#######.\n??????????\n##########\n");
    EXPECT_EQ(run("check scene.json picture.txt").out, "picture.txt:1: picture:\n"
                                                       "    picture: 0 too many, 3 missing\n"
                                                       "       5  ......#...\n"
                                                       "       4  .....##...\n"
                                                       "       3  ....###...\n"
                                                       "       2  ...?####..  -1/4, 25/8 -> -1..3\n"
                                                       "       1  ...#####..\n"
                                                       "       0  ..?#####..  -7/4, 31/8 -> -2..3\n"
                                                       "      -1  .?#######.  -5/2, 17/4 -> -3..4\n"
                                                       "      -2            \n"
                                                       "      -3  ##########\n"
                                                       "\n"
                                                       "0 right, 1 wrong\n");
}

TEST_F(CheckTest, JsonHasEverything) {
    const auto report = nlohmann::json::parse(run("check ben.txt --json").out);
    EXPECT_EQ(report["file"], "ben.txt");
    EXPECT_EQ(report["right"], 0);
    EXPECT_EQ(report["wrong"], 2);
    EXPECT_EQ(report["follow"], 0);
    EXPECT_EQ(report["open"], 0);
    ASSERT_EQ(report["claims"].size(), 2u);
    const auto& slope = report["claims"][0];
    EXPECT_EQ(slope["line"], 2);
    EXPECT_EQ(slope["claim"], "edge AB: 4/3");
    EXPECT_EQ(slope["right"], false);
    EXPECT_EQ(slope["verdict"], "wrong");
    EXPECT_EQ(slope["expected"], nlohmann::json({{"dx_dy", "3/4"}}));
    EXPECT_EQ(slope["found"], nlohmann::json({{"dx_dy", "4/3"}}));
    EXPECT_EQ(slope["slips"][0]["name"], "dx-dy-inverted");
    EXPECT_EQ(slope["slips"][0]["field"], "dx_dy");
    EXPECT_TRUE(slope["follows_from"].is_null());
    EXPECT_THAT(slope["working"].dump(), HasSubstr("dx = -4 - 2 = -6, dy = -3 - 5 = -8"));
    EXPECT_EQ(report["claims"][1]["expected"], nlohmann::json({{"left", "5/4"}}));
    EXPECT_THAT(report["claims"][1]["remarks"].dump(), HasSubstr("right: rounded to 2 digits"));
}

TEST_F(CheckTest, APileHasALineForEachFileAndGoesOnBehindABadOne) {
    write("carl.txt", "y=2: -1/4, x\n");
    const Outcome text = run("check scene.json anna.txt carl.txt ben.txt");
    EXPECT_EQ(text.status, 2);
    EXPECT_EQ(text.out,
              "anna.txt: 3 right, 1 wrong, 1 open; most likely truncate-for-floor\n"
              "carl.txt: could not be checked\n"
              "ben.txt: 0 right, 2 wrong; most likely dx-dy-inverted\n"
              "\n"
              "The most likely slip of a sheet, and of how many sheets:\n"
              "dx-dy-inverted      1  dx/dy = (y2 - y1)/(x2 - x1) instead of dx/dy = "
              "(x2 - x1)/(y2 - y1)\n"
              "truncate-for-floor  1  rounding toward 0, int(x) instead of rounding down, "
              "floor(x)\n");
    EXPECT_EQ(run("check scene.json anna.txt ben.txt --hint 2").out,
              "anna.txt: 3 right, 1 wrong, 1 open\n"
              "ben.txt: 0 right, 2 wrong\n");
    EXPECT_EQ(text.err,
              "rastertrace: carl.txt:1:12: expected a number, like 3.125 or 25/8, found x\n"
              "y=2: -1/4, x\n"
              "           ^\n"
              "hint: a line looks like `y=2: -1/4, 25/8 -> -1..3`, `y=2 depth: 1/3, 1/5`\n");
    const auto json = nlohmann::json::parse(run("check scene.json anna.txt carl.txt --json").out);
    EXPECT_EQ(json[0]["wrong"], 1);
    EXPECT_THAT(json[1]["problem"].get<std::string>(), StartsWith("carl.txt:1:12: expected"));
    EXPECT_EQ(run("check scene.json anna.txt ben.txt").status, 1);
}

TEST_F(CheckTest, ALineThatIsNotUnderstoodCostsNoOther) {
    write("sheet.txt", "y=2: i dont know\ny=2: -1/4, 25/8\nedge XY: 1\n");
    const Outcome text = run("check scene.json sheet.txt");
    EXPECT_EQ(text.status, 1);
    EXPECT_THAT(text.out,
                HasSubstr("sheet.txt:1:6: expected a number, like 3.125 or 25/8, found i\n"
                          "y=2: i dont know\n"
                          "     ^\n"));
    EXPECT_THAT(text.out, EndsWith("\n1 right, 0 wrong, 2 not understood\n"));
    const auto json = nlohmann::json::parse(run("check scene.json sheet.txt --json").out);
    EXPECT_EQ(json["not_understood"], 2);
    EXPECT_EQ(json["claims"][0]["right"], nullptr);
    EXPECT_EQ(json["claims"][0]["verdict"], "not understood");
    EXPECT_THAT(json["claims"][2]["problem"].get<std::string>(), StartsWith("sheet.txt:3:6: "));
    const Outcome strict = run("check scene.json sheet.txt --strict");
    EXPECT_EQ(strict.status, 2);
    EXPECT_EQ(strict.out, "");
    EXPECT_THAT(strict.err, HasSubstr("sheet.txt:3:6: "));
    EXPECT_EQ(run("check scene.json sheet.txt sheet.txt").status, 1);
    write("nothing.txt", "i dont know\nthe moon is bright\n");
    EXPECT_EQ(run("check scene.json nothing.txt").status, 2);
}

TEST_F(CheckTest, AListThatEndsEarlyHasAnOpenPoint) {
    write("line.json", R"({"canvas":{"width":9,"height":9},"vertices":{"A":[0,0],"B":[2,1]},
        "lines":["AB"],"method":{"line":"bresenham"}})");
    write("sheet.txt", "AB pixels: (0,0) (1,0)\n");
    const Outcome early = run("check line.json sheet.txt");
    EXPECT_EQ(early.status, 1);
    EXPECT_EQ(early.out, "sheet.txt:1: AB pixels: (0,0) (1,0)\n"
                         "    pixels: open, ends early: the first 2 of 3\n"
                         "\n"
                         "0 right, 0 wrong, 1 open\n");
    write("sheet.txt", "AB pixels: (0,0) (1,0) ...\n");
    EXPECT_EQ(run("check line.json sheet.txt").status, 0);
}

TEST_F(CheckTest, TheTablesThatShowPrintsAreRight) {
    const std::string examples = RASTERTRACE_EXAMPLES;
    for (const std::string scene : {"t0-fill/first-triangle.json", "t2-lines/worked-lines.json",
                                    "t4-pipeline/camera-points.json", "polygon/concave.json"})
        for (const std::string kind :
             {"scanline", "edge", "decide", "vertex", "face", "pixel", "crossings"}) {
            const std::string path = examples + "/" + scene;
            const Outcome told = run("show '" + path + "' --every " + kind + " --format csv");
            if (told.status != 0 || std::count(told.out.begin(), told.out.end(), '\n') < 2)
                continue;
            write("table.csv", told.out);
            EXPECT_EQ(run("check '" + path + "' table.csv").status, 0) << scene << " " << kind;
        }
}

TEST_F(CheckTest, WithoutAnswersNoFormatHasOne) {
    EXPECT_EQ(run("check ben.txt --no-answers").out, "ben.txt:2: edge AB: 4/3: wrong\n"
                                                     "ben.txt:3: y=4: 1.4, 2.38: wrong\n"
                                                     "\n"
                                                     "0 right, 2 wrong\n");
    for (const std::string format : {"text", "json"})
        EXPECT_THAT(run("check ben.txt --no-answers --format " + format),
                    Ends(1, AllOf(Not(HasSubstr("3/4")), Not(HasSubstr("inverted")),
                                  Not(HasSubstr("rounded")))))
            << format;
}

TEST_F(CheckTest, ASheetIsOpenAndNamesItsScene) {
    EXPECT_THAT(run("sheet scene.json > open.txt"), Ends(0));
    EXPECT_THAT(content("open.txt"),
                StartsWith("# a relative name is looked for from the folder of this file\n"
                           "scene: scene.json\n\nedge AB: ?\nedge AC: ?\n"));
    const Outcome checked = run("check open.txt");
    EXPECT_EQ(checked.out, "0 right, 0 wrong, 12 open\n"); // 2 edges, 9 rows, the picture
    EXPECT_EQ(checked.status, 0);
}

TEST_F(CheckTest, ASheetNamesAnySceneSoThatItIsFound) {
    for (const std::string name : {"a #b.json", " a.json", "a.json ", "\"a\".json", "a\nb.json",
                                   "a\\b.json", "color #1.json", "first one.json"}) {
        fs::copy(folder_ / "scene.json", folder_ / name);
        EXPECT_THAT(run("sheet '" + name + "' > open.txt"), Ends(0));
        EXPECT_EQ(run("check open.txt").out, "0 right, 0 wrong, 12 open\n") << name;
    }
}

TEST_F(CheckTest, ASheetInColumnsIsFilledInAndChecked) {
    EXPECT_EQ(run("sheet scene.json -o sheet.csv").status, 0);
    EXPECT_THAT(content("sheet.csv"), StartsWith("ABC\nedge,dx/dy\nAB,\nBC,\nAC,\n\n"
                                                 "ABC\ny,left,right,from,to\n5,,,,\n"));
    EXPECT_EQ(run("check scene.json sheet.csv").out, "0 right, 0 wrong, 12 open\n");
    EXPECT_EQ(shell("sed 's/^2,,,,/2;-0,25;3,125;-1;/; s/,/;/g; s/0;25/0,25/; s/3;125/3,125/' "
                    "sheet.csv > filled.csv; "
                    "$rastertrace check scene.json filled.csv")
                  .out,
              "filled.csv: commas are read as those of decimals: 0,25 is 1/4\n\n"
              "1 right, 0 wrong, 11 open\n");
}

TEST_F(CheckTest, ASheetIsOfASceneOrATrace) {
    EXPECT_EQ(run("sheet anna.txt").err,
              "rastertrace: anna.txt: expected a scene or a trace, found claims\n");
}

TEST_F(CheckTest, AHintTellsTheRuleAndNoNumber) {
    const std::string rule = "ben.txt:2: edge AB: 4/3: wrong\n    dx/dy\n        how far an edge "
                             "goes in x for one row\n";
    EXPECT_THAT(run("check ben.txt --hint").out, StartsWith(rule + "ben.txt:3"));
    EXPECT_THAT(run("check --hint ben.txt").out, StartsWith(rule + "ben.txt:3"));
    EXPECT_THAT(run("check ben.txt --hint 2").out,
                StartsWith(rule + "        dx/dy = (x2 - x1) / (y2 - y1)\n"));
    const auto told = nlohmann::json::parse(run("check ben.txt --hint 2 --json").out);
    EXPECT_EQ(told["claims"][0]["formulas"][0], "dx/dy = (x2 - x1) / (y2 - y1)");
    EXPECT_FALSE(told["claims"][0].contains("expected"));
    EXPECT_THAT(run("check ben.txt --hint --answers").err, HasSubstr("at most 1"));
}

TEST_F(CheckTest, WhyAPixelIsNotDrawnIsToldAsExplainDoes) {
    write("pixel.txt", "(4,2): on\n");
    const std::string explained = run("explain scene.json --pixel 4,2").out;
    const std::string reason =
        "AC ends row y=2 at x = 25/8 -> floor -> 3; x = 4 lies beyond it by 7/8";
    EXPECT_THAT(explained, HasSubstr(reason));
    EXPECT_THAT(run("check scene.json pixel.txt").out, HasSubstr(reason));
}

TEST_F(CheckTest, ALongFractionIsShownByItsFirstDigits) {
    write("long.json", R"({"canvas":{"width":8,"height":8},
        "vertices":{"A":["1234567890123/1000000000007",3],"B":[0,0],"C":[3,0]},
        "triangles":["ABC"]})");
    write("long.txt", "scene: long.json\nA screen: 1, 3\n");
    EXPECT_EQ(run("check long.txt").out,
              "long.txt:2: A screen: 1, 3\n"
              "    at: expected 12345678.../10000000... = 1.234568, 3, found 1, 3\n"
              "        vertex A in screen space: (12345678.../10000000... = 1.234568, 3), from "
              "camera (12345678.../10000000... = 1.234568, 3, 0)\n"
              "\n"
              "0 right, 1 wrong\n");
    const auto report = nlohmann::json::parse(run("check long.txt --json").out);
    EXPECT_EQ(report["claims"][0]["expected"]["at"], "1234567890123/1000000000007, 3");
}

TEST_F(CheckTest, ATraceIsTakenAtItsWord) {
    run("trace scene.json --rounding truncate -o cut.trace.json");
    EXPECT_THAT(run("check cut.trace.json anna.txt"), Ends(0));
    EXPECT_EQ(run("check scene.json anna.txt --rounding truncate").status, 0);
    EXPECT_EQ(run("check cut.trace.json anna.txt --rounding floor").err,
              "rastertrace: cut.trace.json: expected a scene to draw with --rounding floor, found "
              "a trace, which is drawn already\n");
}

TEST_F(CheckTest, ReadsStandardInput) {
    EXPECT_EQ(run("check scene.json - < anna.txt").out.substr(0, 17), "standard input:2:");
    EXPECT_EQ(run("check - < ben.txt").status, 1);
    EXPECT_EQ(shell("cat scene.json | $rastertrace check - anna.txt").status, 1);
}

TEST_F(CheckTest, ALongTableIsReadWhole) {
    std::string table;
    for (int i = 0; i < 300; ++i)
        table += "y=2: -1/4, 25/8 -> -1..3\n";
    write("long.txt", table);
    EXPECT_EQ(run("check scene.json long.txt").out, "300 right, 0 wrong\n");
    EXPECT_EQ(run("check scene.json long.txt --max-input 7kB").err,
              "rastertrace: long.txt: expected a file of at most 7000 bytes, found a larger one\n"
              "hint: --max-input SIZE raises the limit\n");
}

TEST_F(CheckTest, FilesInTheWrongPlaceAreTold) {
    write("none.txt", "y=2: -1/4, 25/8\n");
    write("turned.txt", "scene: none.txt\ny=2: -1/4, 25/8\n");
    write("empty.txt", "# nothing yet\n");
    write("lost.txt", "scene: lost.json\ny=2: -1/4, 25/8\n");
    const std::vector<std::pair<std::string, std::string>> faults{
        {"none.txt", "none.txt: expected a scene before the claims, or its name in them, found "
                     "none\nhint: check SCENE CLAIMS, or a line `scene: FILE`\n"},
        {"scene.json", "scene.json: expected claims behind the scene, found none\n"
                       "hint: rastertrace sheet SCENE writes a sheet to fill in\n"},
        {"scene.json scene.json", "scene.json:1:1: expected claims, found a scene\n"
                                  "{\"title\": \"First triangle\",\n^\n"
                                  "hint: claims come behind the scene: check SCENE CLAIMS\n"},
        {"turned.txt", "turned.txt:1:8: expected a scene or a trace, found claims (none.txt)\n"
                       "scene: none.txt\n       ^\n"},
        {"lost.txt", "lost.txt:1:8: expected a file that can be read, found: No such file or "
                     "directory (lost.json)\nscene: lost.json\n       ^\n"},
        {"scene.json empty.txt", "empty.txt: expected claims, found none\n"
                                 "hint: rastertrace sheet SCENE writes a sheet to fill in\n"},
        {"ben.txt --hint=3", "--hint: expected one of 1, 2, found \"3\"\n"},
        {"ben.txt --format csv", "--format: expected text or json, found \"csv\"\n"},
    };
    for (const auto& [arguments, message] : faults)
        EXPECT_THAT(run("check " + arguments), Ends(2, "", "rastertrace: " + message)) << arguments;
}

TEST_F(CheckTest, ClaimsThatAreBrokenJsonAreToldAsValidateDoes) {
    write("broken.json",
          "{\"scene\": \"scene.json\",\n"
          " \"claims\": [{\"step\": \"vertex\", \"name\": \"A\", \"space\": \"screen\", "
          "\"at\": [2/5, \"?\"]}]}\n");
    const Outcome checked = run("check broken.json");
    EXPECT_EQ(checked.status, 2);
    EXPECT_THAT(checked.err, StartsWith("rastertrace: broken.json:2:"));
    EXPECT_THAT(checked.err, HasSubstr("found '/'"));
    EXPECT_THAT(checked.err, HasSubstr("hint: "));
    const Outcome validated = run("validate broken.json");
    EXPECT_THAT(validated.out + validated.err, HasSubstr(checked.err.substr(13)));
    EXPECT_EQ(run("check scene.json broken.json").err, checked.err);
}

TEST_F(CheckTest, NamesFromFilesAreSafeToPrint) {
    write("named.json",
          R"({"canvas":{"width":8,"height":8},"vertices":{"A":[0,3],"B":[-3,-3],"C":[3,-3]},
        "triangles":[{"vertices":"ABC","name":"a\u001b]0;x\u0007"}]})");
    write("named.txt", R"("a\u001b]0;x\u0007" y=3: 1, 1)");
    for (const std::string format : {"text", "json"}) {
        const Outcome checked = run("check named.json named.txt --format " + format);
        EXPECT_EQ(checked.status, 1) << checked.err;
        EXPECT_EQ(checked.out.find_first_of("\x1b\x07"), std::string::npos) << format;
    }
}

/// Words of two small letters or more. Names of slips are the same in all languages.
std::set<std::string> words_in(std::string text) {
    for (const Slip& slip : slips())
        for (std::size_t at; (at = text.find(slip.name)) != std::string::npos;)
            text.erase(at, slip.name.size());
    std::set<std::string> words;
    std::string word;
    for (const char byte : text + "\n") {
        if (('a' <= byte && byte <= 'z') || static_cast<unsigned char>(byte) >= 0x80) {
            word += byte;
            continue;
        }
        if (word.size() >= 2)
            words.insert(word);
        word.clear();
    }
    return words;
}

TEST_F(CheckTest, NothingOfTheAnswerIsEnglishInPortuguese) {
    write("carl.txt", "y=2: -1/4, x\n");
    write("rounded.txt", "edge AC: -0.38\ny=-3: -4, 5.04\ny=6: 1, 2\n");
    write("picture.txt", "picture:\n..........\n..........\n..........\n..........\n..........\n..."
                         ".......\n..........\n..........\n..........\n");
    write("comma.txt", "y=2: -0,25; 3,12\ny=2: -0,25; 3,5\n");
    write("table.txt", "(1,4): off\n(5,5): inside\nABC: culled\nABC: 8 rows\n");
    write("claims.json", R"({"claims":[{"step":"pixel","x":1,"y":4,"color":"#ffffff"},
        {"step":"pixel","x":5,"y":5,"color":"#ffffff"},{"step":"scanline","y":2,"from":0}]})");
    // Files, what is quoted of them, signs of formulas, marks of Markdown, and what is Portuguese as well.
    const std::set<std::string> shared{
        "anna",     "as",    "ben",        "byte",    "carl",   "ceil",     "claims",  "cleo",
        "class",    "color", "comma",      "csv",     "culled", "details",  "do",      "dora",
        "doubles",  "dx",    "dy",         "edge",    "emil",   "examples", "face",    "ffffff",
        "floor",    "from",  "horizontal", "inside",  "int",    "json",     "no",      "normal",
        "off",      "on",    "picture",    "pixel",   "pixels", "round",    "rounded", "rows",
        "scanline", "sheet", "step",       "summary", "table",  "txt"};
    shell("ln -s $examples examples"); // the words of its path are no answer
    for (const std::string arguments :
         {"scene.json anna.txt", "scene.json anna.txt --hint 2", "ben.txt --hint 1",
          "ben.txt --no-answers", "scene.json anna.txt carl.txt ben.txt", "scene.json rounded.txt",
          "scene.json picture.txt", "scene.json comma.txt", "scene.json table.txt",
          "scene.json table.txt --hint 2", "scene.json claims.json",
          "examples/class/*.txt examples/class/*/*.txt"}) {
        const Outcome english = run("check " + arguments);
        const Outcome told = run("check --language pt " + arguments);
        EXPECT_EQ(told.status, english.status) << arguments;
        EXPECT_EQ(told.err, english.err)
            << arguments; // what is wrong with a file is told in English
        const std::set<std::string> words = words_in(english.out);
        EXPECT_GT(words.size(), 4U) << english.out;
        for (const std::string& word : words_in(told.out))
            EXPECT_FALSE(words.contains(word) && !shared.contains(word))
                << arguments << ": " << word << " in\n"
                << told.out;
    }
}

TEST_F(CheckTest, AnswersInPortuguese) {
    const auto told = [this](const std::string& arguments) {
        return run("check --language pt " + arguments).out;
    };
    EXPECT_THAT(told("scene.json anna.txt"),
                AllOf(StartsWith("anna.txt:2: y=2: -1/4, 25/8 -> 0..3\n"
                                 "    primeiro pixel: esperado -1, encontrado 0\n"
                                 "    deslize provável truncate-for-floor: arredondar em direção a "
                                 "0, int(x), e não arredondar para baixo, floor(x)\n"),
                      HasSubstr("\n        linha y=2   esquerda AB: x = 2 + 3/4 (2 - 5) = -1/4"),
                      EndsWith("\n\n3 certos, 1 errado, 1 em aberto\n")));
    write("cut.txt", "y=2: 1/4, 25/8 -> 0..3\n");
    EXPECT_THAT(
        told("scene.json cut.txt"),
        HasSubstr("    primeiro pixel: esperado -1, encontrado 0; decorre de outro valor da "
                  "mesma linha do arquivo (extremo esquerdo)\n"));
    write("rounded.txt", "edge AC: -0.38\ny=-3: -4, 5.04\n");
    EXPECT_THAT(
        told("scene.json rounded.txt"),
        AllOf(HasSubstr("    dx/dy: certo, arredondado para 2 casas\n"),
              HasSubstr("    extremo direito: esperado 5, encontrado 5.04; decorre da linha "
                        "1 do arquivo, de um número arredondado\n")));
    EXPECT_THAT(
        told("$examples/claims/t0-figs-22-24.claims"),
        AllOf(HasSubstr("    produto escalar: esperado 12, encontrado 16; decorre da linha "),
              HasSubstr("\n        a conta é a da linha "),
              EndsWith("\n1 certo, 2 errados, 2 que decorrem\n")));
    write("table.txt", "(1,4): off\n(5,5): inside\nedge BC: 1\n");
    EXPECT_THAT(told("scene.json table.txt"),
                AllOf(HasSubstr("    pixel: esperado desenhado, encontrado não desenhado\n"),
                      HasSubstr("    pixel: esperado fora, encontrado dentro\n"),
                      HasSubstr("    dx/dy: esperado nenhum, encontrado 1\n")));
    EXPECT_THAT(told("ben.txt --hint 2"),
                StartsWith("ben.txt:2: edge AB: 4/3: errado\n    dx/dy\n"
                           "        quanto uma aresta anda em x por linha\n"
                           "        dx/dy = (x2 - x1) / (y2 - y1)\nben.txt:3"));
    EXPECT_EQ(told("ben.txt --no-answers"), "ben.txt:2: edge AB: 4/3: errado\n"
                                            "ben.txt:3: y=4: 1.4, 2.38: errado\n"
                                            "\n"
                                            "0 certos, 2 errados\n");
    EXPECT_THAT(told("$examples/class/*.txt $examples/class/*/*.txt"),
                HasSubstr("\nO deslize mais provável de uma folha, e de quantas folhas:\n"
                          "truncate-for-floor  2  arredondar em direção a 0, int(x)"));
}

TEST_F(CheckTest, KeysOfJsonAreTheSameInPortuguese) {
    const auto told = [this](const std::string& arguments) {
        return run("check --language pt " + arguments).out;
    };
    EXPECT_EQ(told("ben.txt --no-answers --json"), run("check ben.txt --no-answers --json").out);

    const auto report = nlohmann::json::parse(told("ben.txt --json"));
    const auto english = nlohmann::json::parse(run("check ben.txt --json").out);
    const auto& slope = report["claims"][0];
    EXPECT_EQ(slope["verdict"], "wrong");
    EXPECT_EQ(slope["expected"], english["claims"][0]["expected"]);
    EXPECT_EQ(slope["slips"][0]["name"], "dx-dy-inverted");
    EXPECT_THAT(slope["slips"][0]["meaning"].get<std::string>(), HasSubstr(", e não "));
    EXPECT_THAT(report["claims"][1]["remarks"].dump(),
                HasSubstr("right: arredondado para 2 casas"));
}

/// The slips that a claims file of the examples says it has, in comments; "none" if it is wrong and none fits.
std::vector<std::string> slips_said_in(const fs::path& file) {
    std::vector<std::string> slips;
    std::ifstream text(file);
    for (std::string line; std::getline(text, line);)
        if (line.starts_with("# slip: "))
            slips.push_back(line.substr(8));
    return slips;
}

TEST_F(CheckTest, TheMistakesOfTheTextsAreFoundAndNamed) {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(fs::path(RASTERTRACE_EXAMPLES) / "claims")) {
        const std::string path = entry.path().string();
        const Outcome checked = run("check '" + path + "' --json");
        ASSERT_EQ(checked.err, "");
        const auto report = nlohmann::json::parse(checked.out);
        std::vector<std::string> most_likely;
        for (const auto& claim : report["claims"])
            if (!claim["slips"].empty())
                most_likely.push_back(claim["slips"][0]["name"]);
        const auto said = slips_said_in(entry.path());
        for (const std::string& slip : said)
            EXPECT_TRUE(slip == "none"
                            ? most_likely.empty()
                            : std::count(most_likely.begin(), most_likely.end(), slip) > 0)
                << slip << " " << path;
        EXPECT_EQ(checked.status, said.empty() ? 0 : 1) << path;
        all.insert(said.begin(), said.end());
    }
    EXPECT_GE(all.size(), 10u);
}

TEST(CheckPage, HasTheTableOfSlips) {
    std::string table = "\n| slip | what is done |\n|---|---|\n";
    for (const Slip& slip : slips())
        table += fmt::format("| `{}` | {} |\n", slip.name, slip.done.in(Language::english));
    std::ostringstream page;
    page << std::ifstream(fs::path(RASTERTRACE_EXAMPLES) / "../docs/check.md").rdbuf();
    EXPECT_THAT(page.str(), HasSubstr(table + "\n"));
}

} // namespace
} // namespace rastertrace
