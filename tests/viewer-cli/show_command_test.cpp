// SPDX-License-Identifier: MIT
// `rastertrace show` as a user calls it: frames, steps, tables and sentences.

#include "picture.h"
#include "program.h"

#include <nlohmann/json.hpp>

#include <string>

namespace rastertrace {
namespace {

/// floor(-1/4) = -1 and so on: a cast rounds them toward 0.
TEST_F(ProgramTest, SentencesOfWrongStepsSayWhatTheirNumbersGive) {
    const std::string fast = "$examples/regression/fast.jsonl";
    EXPECT_EQ(run("show --all " + fast +
                  " | grep -o 'scanline y=.* left\\|\\[!\\].*' | grep -B1 '!' | tr '\\n' ' '")
                  .out,
              "scanline y=2   left [!] its numbers give from = -1 -- scanline y=0   left [!] its "
              "numbers give from = -2 scanline y=-1   left [!] its numbers give from = -3 scanline "
              "y=-2   left [!] its numbers give from = -4 ");
    for (const std::string question : {"--step 11", "--scanline 2", "--pixel 0,2", "--pixel=-1,2"})
        EXPECT_THAT(run("explain " + fast + " " + question).out,
                    HasSubstr("   [!] its numbers give from = -1\n"))
            << question;
    EXPECT_THAT(run("explain " + fast + " --step 11 --json").out,
                HasSubstr("[!] its numbers give from = -1"));
    EXPECT_THAT(run("show --all --language pt " + fast).out,
                HasSubstr("   [!] seus n\u00FAmeros d\u00E3o from = -1\n"));
    EXPECT_THAT(run("figure " + fast + " --step 11 --format txt -o -").out,
                HasSubstr("[!] its numbers give from = -1"));
    EXPECT_THAT(run("play " + fast + " --step 'scanline y=2' --print 140x30").out,
                HasSubstr("[!] its numbers give from = -1"));
    // Step 11 of both traces; what is told of mine.jsonl is what its numbers give.
    const std::string difference = run("diff $examples/regression/mine.jsonl " + fast).out;
    EXPECT_THAT(difference, HasSubstr("[!] its numbers give from = -1\n"));
    EXPECT_EQ(difference.find("[!]"), difference.rfind("[!]"));
    EXPECT_THAT(run("show --all $examples/regression/mine.jsonl").out, Not(HasSubstr("[!]")));
}

TEST_F(ProgramTest, ShowBeginsWithWhatTheSceneIsAbout) {
    const std::string show = "$rastertrace show $examples/t0-fill/first-triangle.json";
    const std::string summary = shell(show).out;
    EXPECT_THAT(summary, StartsWith("First triangle\n"
                                    "triangle ABC   A (2, 5)   B (-4, -3)   C (5, -3)\n"
                                    "  y=5    AB x = 2 -> 2        AC x = 2 -> 2      1 pixel\n"));
    EXPECT_THAT(summary, Not(HasSubstr("step 62"))); // nor marks of one
    EXPECT_THAT(summary, Not(HasSubstr("@")));
    EXPECT_THAT(summary, Not(HasSubstr(">-3")));
    EXPECT_THAT(shell(show + " --step last").out, HasSubstr("step 62 of 62\npixel (5, -3)"));
    EXPECT_THAT(shell(show + " --bare").out, StartsWith("................."));
    EXPECT_THAT(shell(show + " --language pt").out, HasSubstr("tri\u00E2ngulo ABC"));
}

TEST_F(ProgramTest, ShowLooksAtAFrameInManyWays) {
    EXPECT_EQ(run("show $examples/t2-lines/points.json --bare --view faces").out, "ab...\n"
                                                                                  "c....\n"
                                                                                  "....d\n");
    EXPECT_EQ(
        shell("TERM=xterm COLORTERM= $rastertrace show $examples/t2-lines/points.json --step last "
              "--view shade --color always | tail -3 | head -1")
            .out,
        "> 2   . . . . \x1b[97;40;7m-\x1b[0m  D x=4\n");
    EXPECT_THAT(run("show $examples/t2-lines/points.json --view shade").out,
                Not(HasSubstr("\x1b")));

    EXPECT_THAT(run("show $examples/t2-lines/points.json --view face"),
                Refused("rastertrace: --view: expected one of plotted, faces, shade, depth, "
                        "writes, coverage, found \"face\"\nhint: did you mean faces?\n"));
    EXPECT_THAT(run("show $examples/t2-lines/points.json --region 0,0,5,2"),
                Refused("rastertrace: --region: expected pixels of the canvas (x 0 to 4, y 0 to "
                        "2), found 0,0,5,2\n"));
}

TEST_F(ProgramTest, ShowTellsManyStepsOfAKindAsATable) {
    // T0's cube: the face of A, B and C lies at z = 3, what is behind it at 5.
    const std::string cube = "$rastertrace show $examples/t0-hidden/cube-inverse-z.json ";
    EXPECT_THAT(shell(cube + "--every depth").out,
                AllOf(StartsWith("T0's cube with a depth buffer of 1/z\n\n  49  depth at (-4, 3): "
                                 "1/3 against 0: passes (1/z, larger is nearer; z = 3)\n"),
                      HasSubstr("depth at (-2, 2): 1/5 against 1/3 of ABC: fails (1/z, larger is "
                                "nearer; z = 5 against 3)\n"),
                      Not(HasSubstr("-5-4-3"))));
    EXPECT_THAT(shell(cube + "--every depth --view faces").out, HasSubstr("-5-4-3"));

    const std::string rows = "show $examples/t0-fill/first-triangle.json --every scanline ";
    EXPECT_THAT(
        run(rows + "--format csv").out,
        StartsWith("step,y,left,right,from,to,left_edge,right_edge,left_depth,right_depth\r\n"
                   "5,5,2,2,2,2,AB,AC,,\r\n"
                   "7,4,5/4,19/8,1,2,AB,AC,,\r\n"));
    EXPECT_THAT(run(rows + "--format markdown").out,
                HasSubstr("\n| 7 | 4 | 5/4 | 19/8 | 1 | 2 | AB | AC |  |  |\n"));
    const auto steps = nlohmann::json::parse(run(rows + "--format json").out);
    ASSERT_EQ(steps.size(), 9u);
    EXPECT_EQ(steps[1]["left"], "5/4");
    EXPECT_EQ(run("show $examples/t0-fill/first-triangle.json --format csv").err,
              "rastertrace: --format: expected --every or --step beside it, found \"csv\"\n");
    EXPECT_EQ(run(rows + "--format cvs").err,
              "rastertrace: --format: expected one of table, markdown, csv, json, found \"cvs\"\n"
              "hint: did you mean csv?\n");
}

TEST_F(ProgramTest, TablesOfNothingAndOfNegativeFractions) {
    const std::string show = "$rastertrace show $examples/t0-fill/first-triangle.json ";
    EXPECT_THAT(shell(show + "--every scanline --format csv").out,
                HasSubstr("\r\n14,2,-1/4,25/8,"));
    EXPECT_THAT(
        shell(show + "--every 0 --format csv"),
        Refused(
            "rastertrace: --format: expected steps of a kind that has a table, found another\n"));
    EXPECT_EQ(shell(show + "--every scanline --bare --format csv").status, 2);
    EXPECT_EQ(shell(show + "--bare --region 1,3,3,5").out, ".#.\n"
                                                           "##.\n"
                                                           "##.\n");
    EXPECT_EQ(shell(show + "--every scanline --json").out,
              shell(show + "--every scanline --format json").out);
    for (const std::string other : {"--every scanline --format csv", "", "--every scanline --bare"})
        EXPECT_THAT(shell(show + "--json " + other).err, HasSubstr("--json: expected ")) << other;
    write(
        "empty.json",
        R"({"rastertrace":1,"canvas":{"width":2,"height":1,"origin":"top-left"},"method":{},"steps":[]})");
    EXPECT_EQ(run("show empty.json --every last --bare").out, "..\n");
    // No depth was tested, and there is no room for numbers.
    EXPECT_THAT(shell("COLUMNS=10 " + show + "--view depth").out, HasSubstr("the buffer is clear"));
}

TEST_F(ProgramTest, DepthTestsSayTheRuleThatWasAskedFor) {
    const std::string cube = "$rastertrace show $examples/t0-hidden/cube-inverse-z.json ";
    EXPECT_THAT(shell(cube + "--depth linear-z --depth-compare greater --every depth").out,
                HasSubstr(": passes (z, larger passes)\n"));
    EXPECT_THAT(shell(cube + "--depth-compare less --every depth").out,
                HasSubstr("(1/z, smaller passes; z = 3"));
}

TEST_F(ProgramTest, SentencesShortenWhatTheTraceHasWhole) {
    write(
        "slash.json",
        R"({"rastertrace":1,"canvas":{"width":3,"height":3,"origin":"center"},"method":{},"steps":[
{"step":"primitive","kind":"point","name":"a name that is long/with a slash","vertices":["A"],"at":[[0,0]]}
]})");
    EXPECT_THAT(run("show slash.json").out,
                HasSubstr("\npoint a name that is long/with a slash   A (0, 0)\n"));
    write(
        "long.json",
        R"({"rastertrace":1,"canvas":{"width":3,"height":3,"origin":"center"},"method":{"cull":"back"},"steps":[
{"step":"face","name":"ABC","normal":["49977918000000000000000000001/10141204000000000000000000003",0,"1/3"],"view":[0,0,3],"dot":1,"cosine":0.067483709301797742,"culled":false}
]})");
    EXPECT_THAT(run("show long.json --step last").out,
                HasSubstr("\nface ABC: normal (49977918.../10141204... = 4.928204, 0, 1/3) . to "
                          "eye (0, 0, 3) = 1, cosine 0.067484 (86.13 degrees): drawn\n"));
}

TEST_F(ProgramTest, AdaptiveWritesJsonBeyondTheDoubles) {
    // Areas, and a depth, that no double holds.
    write("area.json", R"({"canvas":{"width":8,"height":8,"origin":"top-left"},
"vertices":{"A":[0,0],"B":[1e160,0],"C":[0,1e160]},"triangles":["ABC"],
"method":{"fill":"barycentric","scalar":"adaptive"}})");
    write("depth.json", R"({"canvas":{"width":4,"height":4,"origin":"top-left"},
"vertices":{"A":[11,-3,1e300],"B":[19,12,1],"C":[-7e12,-4,1]},"triangles":["ABC"],"keep":["depth"],
"method":{"fill":"top-left","scalar":"adaptive","depth":"linear-z"}})");
    for (const char* const scene : {"area.json", "depth.json"}) {
        const Outcome trace = shell(std::string("$rastertrace trace ") + scene);
        EXPECT_EQ(trace.status, 0) << trace.err;
        EXPECT_TRUE(nlohmann::json::accept(trace.out)) << scene;
        const std::string to_pictures = std::string("$rastertrace trace ") + scene +
                                        " | $rastertrace show - --bare; $rastertrace show " +
                                        scene + " --scalar exact --bare";
        const Outcome pictures = shell(to_pictures);
        const std::string& both = pictures.out;
        EXPECT_EQ(both.substr(0, both.size() / 2), both.substr(both.size() / 2)) << scene;
    }
    EXPECT_THAT(run("trace depth.json").out, HasSubstr(R"({"step":"undecided","name":"ABC"})"));
}

TEST_F(ProgramTest, ShowWalksAVertexThroughSixSpaces) {
    EXPECT_THAT(run("show $examples/t4-pipeline/six-spaces.json --every vertex"),
                Prints(StartsWith(
                    "A vertex through six spaces\n"
                    "\n"
                    "   5  vertex A in object space: (1, 1, 1)\n"
                    "   6  vertex A in world space: (0, 2, 1), from object (1, 1, 1)\n"
                    "   7  vertex A in camera space: (0, 2, -3), from world (0, 2, 1)\n"
                    "   8  vertex A in clip space: (0, 2, -2, 3), from camera (0, 2, -3)\n"
                    "   9  vertex A in canonical space: (0, 2, -2) / 3 = (0, 2/3, -2/3)\n"
                    "  10  vertex A in screen space: (20, 10/3), from canonical (0, 2/3, -2/3)\n"
                    "  11  vertex B in object space: (1, -1, -1)\n")));
    EXPECT_THAT(run("show $examples/t4-pipeline/six-spaces.json --every matrix").out,
                StartsWith("A vertex through six spaces\n"
                           "\n"
                           "   1  model matrix = translate x rotate x scale:  [0 -1 0 1]  [2 0 0 "
                           "0]  [0 0 1 0]  [0 0 0 1]\n"));
    EXPECT_THAT(run("show $examples/t4-pipeline/behind-the-eye.json --every clip").out,
                HasSubstr("wing clipped at the near plane: 2 of 3 vertices inside, 4 left\n"));
}

TEST_F(ProgramTest, ShowsThePictureOfTheTextbook) {
    EXPECT_THAT(run("show $examples/t0-fill/first-triangle.json --bare"),
                Ends(0, textbook_picture, ""));
}

TEST_F(ProgramTest, ShowsFramesOfEveryRow) {
    EXPECT_THAT(
        run("show $examples/t0-fill/first-triangle.json --every scanline"),
        Prints(AllOf(HasSubstr("\n\nFirst triangle                                             "
                               "steps 14 to 19 of 62\n"
                               "scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor -> -1  "
                               " right AC: x = 2 - 3/8 (2 - 5) = 25/8 -> floor -> 3\n\n"
                               "     -8-7-6-5-4-3-2-1 0 1 2 3 4 5 6 7 8\n"),
                     HasSubstr("\n> 2   . . . . . . . @ @ @ @ @ . . . . .\n"),
                     Not(HasSubstr("\x1b")))));
}

TEST_F(ProgramTest, FacesOfAFileAreCutAndToldOf) {
    // A quad, an arrow head, a bow tie and a triangle; and a curve.
    write("a.obj", "v 0 0 0\nv 8 0 0\nv 8 8 0\nv 0 8 0\nv 2 2 0\nv 2 5 0\ncstype bezier\nvp 1\n"
                   "f 1 2 3 4\nf 2 5 4 1\nf 1 3 2 6\nf 1 2 3\n");
    write("scene.json", "{\"canvas\": {\"width\": 17, \"height\": 17},\n"
                        " \"meshes\": [{\"obj\": \"a.obj\"}, {\"obj\": \"a.obj\"}]}");
    const Outcome outcome = run("show scene.json --every primitive --format csv | cut -d, -f 3");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out,
                HasSubstr("\na.f1.1\na.f1.2\na.f2.1\na.f2.2\na.f3.1\na.f3.2\na.f4\na-2.f1.1\n"));
    EXPECT_THAT(run("show scene.json --every triangulate").out,
                HasSubstr("\n   1  face a.f2 is not convex; its normal (0, 0, 32) is largest in z, "
                          "which is dropped; ears: a.f2.1; what is left is a.f2.2\n"));
    const std::string of_face =
        "remark: expected faces whose edges do not cross, found 1 face whose "
        "edges do; in ";
    const std::string excerpt = "\n \"meshes\": [{\"obj\": \"a.obj\"}, {\"obj\": \"a.obj\"}]}\n";
    const std::string hint = "hint: it is drawn as the fan of triangles from its first corner\n";
    EXPECT_EQ(outcome.err,
              "rastertrace: a.obj:7:1: remark: expected vertices and faces, found 2 statements of "
              "curves, surfaces or display, skipped; the first is cstype\n"
              "cstype bezier\n^\nhint: only what f lists is drawn\n"
              "rastertrace: scene.json:2:21: " +
                  of_face + "a.f3 the edge from a.1 to a.3 meets the one from a.2 to a.6" +
                  excerpt + std::string(20, ' ') + "^\n" + hint +
                  "rastertrace: scene.json:2:39: " + of_face +
                  "a-2.f3 the edge from a-2.1 to a-2.3 meets the one from a-2.2 to a-2.6" +
                  excerpt + std::string(38, ' ') + "^\n" + hint);
}

TEST_F(ProgramTest, ATruncatedTraceIsShownAsFarAsItGoes) {
    EXPECT_THAT(run("trace $examples/t0-fill/first-triangle.json | head -c 2000 >cut.json; "
                    "$rastertrace show cut.json --bare"),
                Ends(2, AllOf(StartsWith(".................\n"), HasSubstr("#")),
                     HasSubstr("the trace is truncated after ")));
}

TEST_F(ProgramTest, OneGrammarSaysWhichStep) {
    const std::string show = "$rastertrace show $examples/t0-fill/first-triangle.json ";
    const std::string row = shell(show + "--step 14").out;
    EXPECT_THAT(row, HasSubstr("step 14 of 62\nscanline y=2 "));
    EXPECT_EQ(shell(show + "--step 'scanline y=2'").out, row);
    EXPECT_EQ(shell(show + "--step 'scanline right=3.125'").out, row);
    EXPECT_EQ(shell(show + "--step first").out, shell(show + "--step 1").out);
    EXPECT_EQ(shell(show + "--step 0 --bare").status, 0);
    EXPECT_THAT(shell(show + "--every 'scanline y=2'").out, HasSubstr("steps 14 to 19 of 62\n"));
    EXPECT_EQ(shell(show + "--every 14").out, shell(show + "--every 'scanline y=2'").out);
    EXPECT_EQ(shell(show + "--every 0 --bare").out, shell(show + "--step 0 --bare").out);

    EXPECT_THAT(run("show $examples/t0-hidden/cube-culled.json --every 'face culled'"),
                Prints(AllOf(HasSubstr(": culled\n"), Not(HasSubstr(": drawn\n")))));
}

TEST_F(ProgramTest, WorkingIsWrittenBelowTheSentence) {
    const std::string show = "$rastertrace show $examples/t0-fill/first-triangle.json ";
    const std::string crossing =
        "left AB: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = "
        "(-4 - 2)/(-3 - 5) (2 - 5) + 2 = 3/4 (-3) + 2 = -1/4 -> floor -> -1\n";
    EXPECT_THAT(shell(show + "--step 'scanline y=2'").out, Not(HasSubstr(crossing)));
    EXPECT_THAT(shell(show + "--step 'scanline y=2' --working").out,
                AllOf(HasSubstr("-> floor -> 3\n    " + crossing), HasSubstr("\n> 2   . . . ")));
    EXPECT_THAT(shell(show + "--every scanline --format table --working").out,
                HasSubstr("-> floor -> 3\n          " + crossing));
    EXPECT_THAT(run("show $examples/t4-pipeline/six-spaces.json --every matrix --working").out,
                HasSubstr("  [0 0 1 -4]  [0 0 0 1]\n"
                          "          d = p - l = (0, 0, 4) - (0, 0, 0) = (0, 0, 4), |d| = 4\n"));
    for (const std::string beside : {"--bare", "--every edge --format csv"})
        EXPECT_THAT(shell(show + "--working " + beside), Refused(HasSubstr("--working"))) << beside;
}

TEST_F(ProgramTest, ARegionUpsideDownIsRefused) {
    for (const std::string command : {"show", "trace"})
        EXPECT_THAT(run(command + " $examples/t0-fill/first-triangle.json --region 2,5,-4,-3"),
                    Refused("rastertrace: --region: expected the smaller x and y first, found "
                            "\"2,5,-4,-3\"\nhint: --region -4,-3,2,5\n"));
}

TEST_F(ProgramTest, OptionsOfTheGridAskForFrames) {
    const std::string show = "$rastertrace show $examples/t0-hidden/cube-culled.json --every face ";
    EXPECT_THAT(shell(show).out, Not(HasSubstr("\n  5  ")));
    for (const std::string option : {"--view writes", "--region -5,-4,4,5"}) {
        EXPECT_THAT(shell(show + option).out, HasSubstr("\n  5  ")) << option;
        EXPECT_THAT(shell(show + option + " --format csv"),
                    Refused(HasSubstr("--format: expected a table, without --bare")))
            << option;
    }
}

TEST_F(ProgramTest, ListsOfListsAreReadableInTables) {
    EXPECT_THAT(
        run("show $examples/t0-fill/first-triangle.json --every primitive --format markdown").out,
        HasSubstr(" | ((2, 5), (-4, -3), (5, -3)) | "));
}

TEST_F(ProgramTest, ThePaintersOrderIsToldWhole) {
    EXPECT_THAT(
        shell("COLUMNS=80 $rastertrace show $examples/t0-hidden/cube-painter.json --step order")
            .out,
        AllOf(HasSubstr("the painter draws, farthest first: EHG at 5, EGF at 5, DHE at 13/3, BFG "
                        "at 13/3,\nAEF at 13/3, "),
              HasSubstr("\nABC at 3, ACD at 3\n")));
}

TEST_F(ProgramTest, ShowSaysHowMuchLiesOffTheCanvas) {
    // A textbook's y points up, the canvas's down: the points have negative rows.
    const std::string points =
        R"("vertices":{"A":[1,-1],"B":[3,-3]},"lines":["AB"],"points":["A"]})";
    write("down.json", R"({"canvas":{"width":4,"height":4,"origin":"top-left"},)" + points);
    EXPECT_THAT(run("show down.json").out,
                EndsWith("\n\n4 pixels lie above the canvas, none drawn: does y point up? "
                         "(\"origin\": \"center\")\n"));
    EXPECT_EQ(run("show down.json --bare").out, "....\n....\n....\n....\n");
    write("up.json", R"({"canvas":{"width":4,"height":4,"origin":"bottom-left"},)" + points);
    EXPECT_THAT(run("show up.json").out,
                EndsWith("\n\n4 pixels lie below the canvas, none drawn: is the origin in the "
                         "middle? (\"origin\": \"center\")\n"));
    // A screen's coordinates on a canvas with its origin in the middle are too far up; what is too large for
    // either raises no question.
    write("middle.json", R"({"canvas":{"width":4,"height":4},"vertices":{"A":[0,2],"B":[0,3]},)"
                         R"("lines":["AB"]})");
    EXPECT_THAT(run("show middle.json").out,
                EndsWith("\n\n1 pixel lies above the canvas, none drawn: does y point down? "
                         "(\"origin\": \"top-left\")\n"));
    write("large.json", R"({"canvas":{"width":4,"height":4,"origin":"top-left"},)"
                        R"("vertices":{"A":[0,3],"B":[0,5]},"lines":["AB"]})");
    EXPECT_THAT(run("show large.json").out,
                EndsWith("\n\n2 pixels lie below the canvas, none drawn\n"));

    // Rows are dropped whole, triangles too; beside the canvas y is not asked for.
    const auto triangle = [this](const std::string& vertices) {
        write("triangle.json", R"({"canvas":{"width":4,"height":4,"origin":"top-left"},)"
                               R"("vertices":{)" +
                                   vertices + R"(},"triangles":["ABC"]})");
        const std::string out = run("show triangle.json").out;
        return out.substr(out.rfind("\n\n", out.find(" the canvas")) + 2);
    };
    EXPECT_EQ(triangle(R"("A":[0,-2],"B":[0,1],"C":[1,1])"),
              "2 rows lie above the canvas, none drawn: does y point up? (\"origin\": \"center\")\n"
              "\nstages: canvas\n");
    EXPECT_EQ(triangle(R"("A":[0,-2],"B":[0,-1],"C":[1,-1])"),
              "1 triangle lies above the canvas, none drawn: does y point up? "
              "(\"origin\": \"center\")\n\nstages: canvas\n");
    EXPECT_EQ(triangle(R"("A":[-2,1],"B":[5,1],"C":[-2,1])"),
              "2 pixels lie left of the canvas, 2 pixels right of it, none drawn\n"
              "\nstages: canvas\n");
    EXPECT_THAT(run("show $examples/t0-fill/first-triangle.json").out,
                Not(HasSubstr("the canvas")));
}

TEST_F(ProgramTest, StepsOutOfRangeAndKindsThatAreNotThere) {
    const std::string show = "$rastertrace show $examples/t0-fill/first-triangle.json ";
    EXPECT_THAT(shell(show + "--step 63"),
                Refused("rastertrace: --step: expected a step from 0 to 62, found 63\n63\n^\n"));
    EXPECT_EQ(shell(show + "--step -1").err,
              "rastertrace: --step: expected a step from 0 to 62, found -1\n-1\n^\n");
    EXPECT_EQ(shell(show + "--every skanline").err,
              "rastertrace: --every: expected a kind of step that the trace has (primitive, edge, "
              "scanline, pixel), found skanline\n"
              "skanline\n"
              "^\n"
              "hint: did you mean scanline?\n");
    EXPECT_THAT(shell(show + "--step scanline"),
                Ends(2, "",
                     "rastertrace: --step: expected one step, found 9: 5, 7, 10, 14, 20, ...\n"
                     "scanline\n"
                     "^\n"
                     "hint: say which, or use --every\n"));
    // The player takes the same, with the same meaning.
    const std::string play =
        "$rastertrace play $examples/t0-fill/first-triangle.json --print 80x24 ";
    EXPECT_EQ(shell(play + "--step scanline").err,
              "rastertrace: --step: expected one step, found 9: 5, 7, 10, 14, 20, ...\n"
              "scanline\n"
              "^\n"
              "hint: say which\n");
    for (const char* const step :
         {"0", "14", "first", "last", "'scanline y=2'", "'pixel in=ABC x=3 y=2'"}) {
        const std::string shown = shell(show + "--step " + step).out;
        EXPECT_EQ(shell(play + "--step " + step).out.substr(0, 79), shown.substr(0, 79)) << step;
    }
    for (const char* const step : {"63", "-1", "scan", "scanline", "'scanline y=9'"})
        EXPECT_EQ(shell(play + "--step " + step).status, 2) << step;
    EXPECT_THAT(shell(show + "--every 'scanline y=9'"),
                Refused("rastertrace: --every: expected a step of the trace, found none with y=9\n"
                        "scanline y=9\n"
                        "         ^\n"
                        "hint: scanline has y: 5, 4, 3, 2, 1, ...\n"));
    EXPECT_EQ(shell(show + "--step last --all").status, 2);
}

TEST_F(ProgramTest, ALineWithoutADistanceHasNoOneOverZ) {
    const std::string scene =
        R"({"canvas": {"width": 5, "height": 5}, "vertices": {"A": [0, 0], "B": [-1e9, 0]},
            "lines": ["AB"], "method": {"depth": ")";
    write("distance.json", scene + "linear-z\"}}");
    write("inverse.json", scene + "inverse-z\"}}");
    for (const std::string line : {"naive", "dda", "bresenham"})
        for (const std::string scalar : {"float", "double", "fixed", "adaptive", "exact"}) {
            const std::string options = " --bare --line " + line + " --scalar " + scalar;
            EXPECT_THAT(run("show distance.json" + options),
                        Prints(".....\n.....\n###..\n.....\n.....\n"))
                << options;
            EXPECT_THAT(
                run("show inverse.json" + options),
                Refused(StartsWith("rastertrace: inverse.json:1:52: expected a distance above 0 "
                                   "for 1/distance, found vertex A at distance 0\n")))
                << options;
        }
}

TEST_F(ProgramTest, StepsAreToldInTheLanguageThatIsAskedForNeverInThatOfTheLocale) {
    const std::string triangle = " $examples/t0-fill/first-triangle.json";
    const std::string edge = triangle + " --every 'edge edge=BC' --format table";
    const std::string english = "First triangle\n\n   3  edge BC: horizontal, it has no dx/dy\n";
    const std::string portuguese = "First triangle\n\n   3  aresta BC: horizontal, não tem dx/dy\n";
    EXPECT_EQ(run("show" + edge).out, english);
    EXPECT_EQ(shell("LC_ALL=pt_BR.UTF-8 LANG=pt_BR $rastertrace show" + edge).out, english);
    EXPECT_EQ(shell("RASTERTRACE_LANGUAGE= $rastertrace show" + edge).out, english);
    EXPECT_EQ(shell("RASTERTRACE_LANGUAGE=pt $rastertrace show" + edge).out, portuguese);
    EXPECT_EQ(run("show --language pt" + edge).out, portuguese);
    EXPECT_EQ(shell("RASTERTRACE_LANGUAGE=pt $rastertrace show --language en" + edge).out, english);

    // Each command that tells steps.
    const std::string row = " --step 'scanline y=2'";
    for (const std::string& command :
         {"play" + triangle + row + " --print 80x24",
          "figure" + triangle + row + " -o - --format svg", "explain" + triangle + " --pixel 3,2",
          "diff" + triangle + " --against rounding=truncate"})
        EXPECT_THAT(run(command + " --language pt").out, HasSubstr("linha y=2")) << command;
    EXPECT_THAT(run("explain" + triangle + " --pixel 4,2 --language pt").out,
                HasSubstr("\n      direita AC: x = (x2 - x1)/(y2 - y1)"));
    EXPECT_THAT(run("figure" + triangle + " -o - --format html --language pt").out,
                HasSubstr("\"language\":\"pt\""));
    write("one.claims", "scene: first.json\nedge AB: 4/3\n");
    EXPECT_THAT(
        shell("cp" + triangle + " first.json; $rastertrace check one.claims --language pt").out,
        HasSubstr("aresta AB: dx/dy"));

    EXPECT_EQ(run("show --language fr" + edge).err,
              "rastertrace: --language: expected one of en, pt, found \"fr\"\n");
    EXPECT_THAT(
        shell("RASTERTRACE_LANGUAGE=pt_BR $rastertrace show" + edge),
        Refused("rastertrace: RASTERTRACE_LANGUAGE: expected one of en, pt, found \"pt_BR\"\n"));

    // A page is the same whoever renews it.
    write("page.md", "```\n$ rastertrace show first.json --every 'edge edge=BC' --format table\n" +
                         english + "```\n");
    EXPECT_EQ(shell("RASTERTRACE_LANGUAGE=pt $rastertrace renew --check page.md").status, 0);
}

TEST_F(ProgramTest, AFileWithoutACommandIsShown) {
    const std::string scene = "$examples/t0-fill/first-triangle.json";
    const Outcome shown = run("show " + scene + " --bare");
    EXPECT_EQ(shown.status, 0);
    EXPECT_EQ(run(scene + " --bare").out, shown.out);
    EXPECT_EQ(shell("cp " + scene + " a.json; $rastertrace a.json --bare").out, shown.out);
    EXPECT_EQ(run("none.json").err, "rastertrace: none.json: expected a file that can be read, "
                                    "found: No such file or directory\n");
}

TEST_F(ProgramTest, AWindowOfALargerCanvasSaysWhatItShows) {
    write("large.json", R"({"canvas": {"width": 512, "height": 512, "origin": "top-left"},
"vertices": {"A": [0, 0], "B": [511, 0], "C": [0, 511]}, "triangles": ["ABC"]})");
    EXPECT_THAT(shell("COLUMNS=80 LINES=24 $rastertrace show large.json --step last").out,
                HasSubstr("\n(x 0 to 73, y 496 to 511 of a canvas of 512 x 512)\n"));
    // The summary shows all of it.
    EXPECT_THAT(shell("COLUMNS=80 LINES=24 $rastertrace show large.json").out,
                HasSubstr("\n(1 cell = "));
    EXPECT_THAT(shell("COLUMNS=80 LINES=24 $rastertrace show large.json --region 0,0,1,1").out,
                HasSubstr("\n(x 0 to 1, y 0 to 1 of a canvas of 512 x 512)\n"));
}

} // namespace
} // namespace rastertrace
