// SPDX-License-Identifier: MIT
// The program as a user meets it: what it prints, where, and with which exit status.

#include "picture.h"
#include "program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace rastertrace {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST_F(ProgramTest, ShowLooksAtAFrameInManyWays) {
    const Outcome faces =
        shell("$rastertrace show $examples/t2-lines/points.json --bare --view faces");
    EXPECT_EQ(faces.out, "ab...\n"
                         "c....\n"
                         "....d\n");
    const Outcome colored =
        shell("TERM=xterm COLORTERM= $rastertrace show $examples/t2-lines/points.json --view shade "
              "--color always | tail -3 | head -1");
    EXPECT_EQ(colored.out, "> 2   . . . . \x1b[97;40;7m-\x1b[0m  D x=4\n");
    const Outcome plain = shell("$rastertrace show $examples/t2-lines/points.json --view shade");
    EXPECT_EQ(plain.out.find('\x1b'), std::string::npos);

    const Outcome view = shell("$rastertrace show $examples/t2-lines/points.json --view face");
    EXPECT_EQ(view.status, 2);
    EXPECT_EQ(view.err,
              "rastertrace: --view: expected one of plotted, faces, shade, depth, writes, "
              "coverage, found \"face\"\nhint: did you mean faces?\n");
    const Outcome region =
        shell("$rastertrace show $examples/t2-lines/points.json --region 0,0,5,2");
    EXPECT_EQ(region.status, 2);
    EXPECT_EQ(region.err,
              "rastertrace: --region: expected pixels of the canvas (x 0 to 4, y 0 to 2), "
              "found 0,0,5,2\n");
}

TEST_F(ProgramTest, ShowTellsManyStepsOfAKindAsATable) {
    // T0's cube: the face of A, B and C lies at z = 3, what is behind it at 5.
    const std::string cube = "$rastertrace show $examples/t0-hidden/cube-inverse-z.json ";
    const Outcome depths = shell(cube + "--every depth");
    EXPECT_THAT(depths.out,
                StartsWith("T0's cube with a depth buffer of 1/z\n\n  49  depth at (-4, 3): "
                           "1/3 against 0: passes (1/z, larger is nearer; z = 3)\n"));
    EXPECT_THAT(depths.out,
                HasSubstr("depth at (-2, 2): 1/5 against 1/3 of ABC: fails (1/z, larger is "
                          "nearer; z = 5 against 3)\n"));
    EXPECT_THAT(depths.out, Not(HasSubstr("-5-4-3")));
    EXPECT_THAT(shell(cube + "--every depth --frames").out, HasSubstr("-5-4-3"));

    const std::string rows =
        "$rastertrace show $examples/t0-fill/first-triangle.json --every scanline ";
    EXPECT_THAT(
        shell(rows + "--format csv").out,
        StartsWith("step,y,left,right,from,to,left_edge,right_edge,left_depth,right_depth\r\n"
                   "5,5,2,2,2,2,AB,AC,,\r\n"
                   "7,4,5/4,19/8,1,2,AB,AC,,\r\n"));
    EXPECT_THAT(shell(rows + "--format markdown").out,
                HasSubstr("\n| 7 | 4 | 5/4 | 19/8 | 1 | 2 | AB | AC |  |  |\n"));
    const auto steps = nlohmann::json::parse(shell(rows + "--format json").out);
    ASSERT_EQ(steps.size(), 9u);
    EXPECT_EQ(steps[1]["left"], "5/4");
    EXPECT_EQ(shell("$rastertrace show $examples/t0-fill/first-triangle.json --format csv").err,
              "rastertrace: --format: expected --every beside it, found \"csv\"\n");
    EXPECT_EQ(shell(rows + "--format cvs").err,
              "rastertrace: --format: expected one of table, markdown, csv, json, found \"cvs\"\n"
              "hint: did you mean csv?\n");
}

TEST_F(ProgramTest, TablesOfNothingAndOfNegativeFractions) {
    const std::string show = "$rastertrace show $examples/t0-fill/first-triangle.json ";
    EXPECT_THAT(shell(show + "--every scanline --format csv").out,
                HasSubstr("\r\n14,2,-1/4,25/8,"));
    const Outcome before = shell(show + "--every 0 --format csv");
    EXPECT_EQ(before.status, 2);
    EXPECT_EQ(before.err, "rastertrace: --format: expected steps of a kind that has a table, found "
                          "another\n");
    EXPECT_EQ(shell(show + "--every scanline --bare --format csv").status, 2);
    EXPECT_EQ(shell(show + "--bare --region 1,3,3,5").out, ".#.\n"
                                                           "##.\n"
                                                           "##.\n");
    EXPECT_EQ(shell(show + "--bare --overview").status, 2);
    EXPECT_EQ(shell(show + "--every scanline --json").out,
              shell(show + "--every scanline --format json").out);
    for (const std::string other : {"--every scanline --format csv", "", "--every scanline --bare"})
        EXPECT_THAT(shell(show + "--json " + other).err, HasSubstr("--json: expected ")) << other;
    write(
        "empty.json",
        R"({"rastertrace":1,"canvas":{"width":2,"height":1,"origin":"top-left"},"method":{},"steps":[]})");
    EXPECT_EQ(shell("$rastertrace show empty.json --every last --bare").out, "..\n");
    // No depth was tested, and there is no room for numbers.
    EXPECT_THAT(shell(show + "--view depth --overview").out, HasSubstr("the buffer is clear"));
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
    EXPECT_THAT(shell("$rastertrace show slash.json").out,
                HasSubstr("\npoint a name that is long/with a slash   A (0, 0)\n"));
    write(
        "long.json",
        R"({"rastertrace":1,"canvas":{"width":3,"height":3,"origin":"center"},"method":{"cull":"back"},"steps":[
{"step":"face","name":"ABC","normal":["49977918000000000000000000001/10141204000000000000000000003",0,"1/3"],"view":[0,0,1],"dot":1,"cosine":-0.57735026918962573,"culled":false}
]})");
    EXPECT_THAT(
        shell("$rastertrace show long.json --last").out,
        HasSubstr("\nface ABC: normal (49977918.../10141204... = 4.928204, 0, 1/3) . to eye "
                  "(0, 0, 1) = 1, cosine -0.57735 (125.26 degrees): drawn\n"));
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
    EXPECT_THAT(shell("$rastertrace trace depth.json").out,
                HasSubstr(R"("x":0,"y":0,"depth":7.6666666666)"));
}

TEST_F(ProgramTest, StatsJudgeAdaptiveByTheCornersThatItDraws) {
    // B is no double: its nearest one would move pixels across the edges.
    write("scene.json", R"({"canvas":{"width":12,"height":12,"origin":"bottom-left"},
"vertices":{"A":[0,0],"B":["10/3",10],"C":[-8,5],"D":[10,0]},"triangles":["ABC","ABD"],
"method":{"fill":"top-left","sample":"integer"}})");
    const std::string exact = shell("$rastertrace stats scene.json --scalar exact").out;
    EXPECT_EQ(shell("$rastertrace stats scene.json --scalar adaptive").out, exact);
    EXPECT_THAT(shell("$rastertrace trace scene.json --scalar adaptive").out,
                HasSubstr(R"("at":[[0,0],["10/3",10],[-8,5]])"));
    // Once more in numbers that are no fractions of machine size.
    write("long.json", R"({"canvas":{"width":12,"height":12,"origin":"bottom-left"},
"vertices":{"A":[0,0],"B":["10/3",10],"C":[-8,"5000000000000000000001/1000000000000000000000"],"D":[10,0]},
"triangles":["ABC","ABD"],"method":{"fill":"top-left","sample":"integer"}})");
    EXPECT_THAT(shell("$rastertrace trace long.json --scalar adaptive").out,
                HasSubstr(R"("numbers":"doubles with an error bound)"));
    const auto without_steps = [](const std::string& text) {
        return text.substr(text.find("ABC"));
    };
    EXPECT_EQ(without_steps(shell("$rastertrace stats long.json --scalar adaptive").out),
              without_steps(shell("$rastertrace stats long.json --scalar exact").out));
}

TEST_F(ProgramTest, ShowWalksAVertexThroughSixSpaces) {
    const Outcome walk =
        shell("$rastertrace show $examples/t4-pipeline/six-spaces.json --every vertex");
    EXPECT_EQ(walk.status, 0);
    EXPECT_THAT(walk.out,
                StartsWith("A vertex through six spaces\n"
                           "\n"
                           "   5  vertex A in object space: (1, 1, 1)\n"
                           "   6  vertex A in world space: (0, 2, 1), from object (1, 1, 1)\n"
                           "   7  vertex A in camera space: (0, 2, -3), from world (0, 2, 1)\n"
                           "   8  vertex A in clip space: (0, 2, -2, 3), from camera (0, 2, -3)\n"
                           "   9  vertex A in canonical space: (0, 2, -2) / 3 = (0, 2/3, -2/3)\n"
                           "  10  vertex A in screen space: (20, 10/3), from canonical "
                           "(0, 2/3, -2/3)\n"
                           "  11  vertex B in object space: (1, -1, -1)\n"));
    EXPECT_THAT(
        shell("$rastertrace show $examples/t4-pipeline/six-spaces.json --every matrix").out,
        StartsWith("A vertex through six spaces\n"
                   "\n"
                   "   1  model matrix = translate x rotate x scale:  [0 -1 0 1]  [2 0 0 0]  "
                   "[0 0 1 0]  [0 0 0 1]\n"));
    EXPECT_THAT(
        shell("$rastertrace show $examples/t4-pipeline/behind-the-eye.json --every clip").out,
        HasSubstr("wing clipped at the near plane: 2 of 3 vertices inside, 4 left\n"));
}

// A square of two triangles: the scanline fill draws their diagonal twice, the top-left one gives it
// to ABC, whose left edge it is. The outline has 12 pixels, 4 of each side with 3 corners twice; the
// side x = 3 lies right of the samples in ABC.
TEST_F(ProgramTest, StatsNamesThePixelsOfSharedEdges) {
    write("square.json", R"({"vertices":{"A":[0,0],"B":[3,0],"C":[3,3],"D":[0,3]},
                             "triangles":["ABC","ACD"],"outlines":["ABC"]})");
    EXPECT_THAT(shell("$rastertrace stats square.json").out,
                EndsWith("triangle ABC: 10 writes\n"
                         "triangle ACD: 10 writes, 4 over a pixel drawn before\n"
                         "outline ABC: 12 writes to 9 pixels, 12 over a pixel drawn before\n"
                         "edge AC of ABC and ACD: 4 pixels written twice: "
                         "(3, 3) (2, 2) (1, 1) (0, 0); 0 never\n"));
    EXPECT_THAT(shell("$rastertrace stats square.json --fill top-left").out,
                EndsWith("triangle ABC: 6 writes\n"
                         "triangle ACD: 3 writes\n"
                         "  3 pixels on its boundary not drawn: (2, 2) (1, 1) (0, 0)\n"
                         "outline ABC: 12 writes to 9 pixels, 8 over a pixel drawn before\n"
                         "outline ABC on triangle ABC: 4 pixels outside the fill: "
                         "(3, 3) (3, 2) (3, 1) (3, 0)\n"));
    EXPECT_THAT(shell("$rastertrace stats --json square.json").out,
                HasSubstr(R"("edges":[{"edge":"AC","triangles":["ABC","ACD"],)"
                          R"("twice":{"count":4,"pixels":[[3,3],[2,2],[1,1],[0,0]]},)"
                          R"("never":{"count":0,"pixels":[]}}],)"
                          R"("outlines":[{"outline":"ABC","triangle":"ABC",)"
                          R"("outside":{"count":0,"pixels":[]}})"));
}

// Three triangles on the same ten pixels: the nearest hides the one behind it and, drawn first, the
// one as near. Seen from behind, a triangle is culled. None of them misses a pixel.
TEST_F(ProgramTest, StatsCountsHiddenPixelsAsCovered) {
    write("hidden.json", R"({"vertices":{"A":[0,0,1],"B":[3,0,1],"C":[3,3,1],
                                         "D":[0,0,2],"E":[3,0,2],"F":[3,3,2],
                                         "G":[0,0,1],"H":[3,0,1],"I":[3,3,1]},
                             "triangles":["ABC","DEF",{"vertices":"GHI","color":"blue"}],
                             "method":{"fill":"barycentric","depth":"linear-z"}})");
    EXPECT_THAT(
        shell("$rastertrace stats hidden.json").out,
        EndsWith("triangle ABC: 10 writes\n"
                 "triangle DEF: 0 writes, 10 hidden\n"
                 "triangle GHI: 0 writes, 10 hidden\n"
                 "depth ties: 10 pixels would have another color in another order: "
                 "(3, 3) (2, 2) (3, 2) (1, 1) (2, 1) (3, 1) (0, 0) (1, 0) (2, 0) (3, 0)\n"));
    write("culled.json", R"({"vertices":{"A":[0,0,1],"B":[3,0,1],"C":[3,3,1]},
                             "triangles":["ABC","ACB"],
                             "method":{"fill":"barycentric","cull":"back"}})");
    EXPECT_THAT(shell("$rastertrace stats culled.json").out,
                EndsWith("triangle ABC: 10 writes\n"
                         "triangle ACB: 0 writes, skipped: culled\n"));
}

// C15 of the catalogue: M lies 1/40 px below the edge PQ, or above it. No scalar cures it.
TEST_F(ProgramTest, StatsTellsOfTJunctionsWithTheirPixels) {
    const Outcome gap = shell("$rastertrace stress --case C15 --scene 1 | $rastertrace stats -");
    EXPECT_EQ(gap.status, 0);
    EXPECT_THAT(gap.out,
                EndsWith("T-junction at edge PQ of PQT: M 0.025 px from it; beside it PMB, MQB: "
                         "0 pixels in two triangles; 1 in none: (8, 21)\n"));
    for (const std::string scalar : {"float", "double", "fixed", "adaptive"})
        EXPECT_THAT(shell("$rastertrace stress --case C15 --scene 2 | $rastertrace stats - "
                          "--scalar " +
                          scalar)
                        .out,
                    HasSubstr("1 pixel in two triangles: (31, 25); 0 in none\n"))
            << scalar;
    EXPECT_THAT(
        shell("$rastertrace stress --case C15 --scene 1 | $rastertrace stats - --json").out,
        HasSubstr(R"("t_junctions":[{"edge":"PQ","triangle":"PQT",)"
                  R"("vertices":[{"vertex":"M","distance":0.025}],"beside":["PMB","MQB"],)"
                  R"("twice":{"count":0,"pixels":[]},"never":{"count":1,"pixels":[[8,21]]}}])"));
}

// The row y = 2 of the first triangle runs from -1/4 to 25/8: floor takes -1, left of the edge.
TEST_F(ProgramTest, StatsSaysWhyPixelsLieOutside) {
    const std::string stats = "$rastertrace stats $examples/t0-fill/first-triangle.json ";
    EXPECT_THAT(shell(stats).out,
                EndsWith("triangle ABC: 49 writes\n"
                         "  6 pixels drawn outside: (1, 4) (0, 3) (-1, 2) (-2, 0) (-3, -1) "
                         "(-4, -2)\n"
                         "    floor takes the pixel left of the edge: 6\n"));
    EXPECT_THAT(shell(stats + "--rounding nearest").out,
                HasSubstr("    nearest takes the pixel left of the edge: 2\n"
                          "    nearest takes the pixel right of the edge: 4\n"));
    EXPECT_THAT(shell(stats + "--rounding inside").out, EndsWith("triangle ABC: 43 writes\n"));
    EXPECT_THAT(shell(stats + "--fill fan").out,
                HasSubstr("    a line of the fan leaves the triangle: "));
    EXPECT_THAT(shell(stats + "--json").out,
                HasSubstr(R"("causes":[{"cause":"floor takes the pixel left of the edge",)"
                          R"("pixels":6}]})"));
}

TEST_F(ProgramTest, StatsAddsUpTheFacesOfAMesh) {
    const std::string scene = R"({"canvas":{"width":9,"height":9,"origin":"top-left"},"meshes":[
        {"name":"square","vertices":{"A":[0,0],"B":[4,0],"C":[4,4],"D":[0,4]},"faces":["ABCD"]}],
        "vertices":{"P":[6,0],"Q":[8,0],"R":[8,2]},"triangles":["PQR"]})";
    write("mesh.json", scene);
    EXPECT_THAT(shell("$rastertrace stats mesh.json").out,
                EndsWith("triangle PQR: 6 writes\n"
                         "mesh square: 2 primitives, 30 writes, 5 over a pixel drawn before\n"
                         "1 edge within square: 5 pixels written twice: (0, 0) (1, 1) (2, 2) "
                         "(3, 3) (4, 4); 0 never\n"));
    EXPECT_THAT(shell("$rastertrace stats mesh.json --json").out,
                HasSubstr(R"({"kind":"triangle","name":"square.ACD","writes":15,)"));
    const Outcome cube = shell("$rastertrace stats $examples/t3-light/lambert.json");
    EXPECT_THAT(cube.out, HasSubstr(" skipped: culled"));
    EXPECT_LT(std::count(cube.out.begin(), cube.out.end(), '\n'), 40);
}

TEST_F(ProgramTest, StatsHoldsEveryRowAgainstItsPixels) {
    write("foreign.json", R"({"rastertrace":1,"canvas":{"width":4,"height":1},"steps":[
{"step":"primitive","kind":"triangle","name":"ABC"},
{"step":"scanline","y":0,"left":-2,"right":1,"from":-2,"to":1},
{"step":"pixel","x":-2,"y":0},
{"step":"pixel","x":-1,"y":0},
{"step":"pixel","x":-1,"y":0},
{"step":"reject","x":1,"y":0,"why":"stencil"}
],"end":{"steps":6}})");
    const Outcome foreign = shell("$rastertrace stats foreign.json --fail-on rows");
    EXPECT_EQ(foreign.status, 1);
    EXPECT_THAT(foreign.out,
                EndsWith("scanline y=0 of ABC (step 2), -2 to 1: 1 pixel neither drawn "
                         "nor rejected, 1 pixel too many\n"));
    EXPECT_EQ(foreign.err, "rastertrace: --fail-on: found rows\n");
    EXPECT_THAT(shell("$rastertrace stats foreign.json --json").out,
                HasSubstr(R"("wrong_rows":[{"step":2,"primitive":"ABC","y":0,"from":-2,"to":1,)"
                          R"("missing":1,"others":1}])"));
}

TEST_F(ProgramTest, StatsFailsOnRequest) {
    write("square.json", R"({"vertices":{"A":[0,0],"B":[3,0],"C":[3,3],"D":[0,3]},
                             "triangles":["ABC","ACD"]})");
    const std::string stats = "$rastertrace stats square.json ";
    const Outcome twice = shell(stats + "--fail-on holes,twice,outside");
    EXPECT_EQ(twice.status, 1);
    EXPECT_EQ(twice.out, shell(stats).out);
    EXPECT_EQ(twice.err, "rastertrace: --fail-on: found twice\n");
    EXPECT_EQ(shell(stats + "--fail-on holes,outside,rows").status, 0);
    EXPECT_EQ(shell(stats + "--fill top-left --fail-on holes,twice,outside,rows").status, 0);
    EXPECT_EQ(
        shell("$rastertrace stats $examples/t0-fill/first-triangle.json --fail-on outside").err,
        "rastertrace: --fail-on: found outside\n");
    EXPECT_EQ(shell("$rastertrace stats $examples/t4-fan/fan.json --fail-on holes,outside").err,
              "rastertrace: --fail-on: found holes, outside\n");

    const Outcome unknown = shell(stats + "--fail-on hole");
    EXPECT_EQ(unknown.status, 2);
    EXPECT_EQ(unknown.err, "rastertrace: --fail-on: expected findings out of holes,twice,outside,"
                           "rows, found \"hole\"\nhint: did you mean holes?\n");
    const Outcome partial =
        shell("$rastertrace trace square.json --only pixel | $rastertrace stats - --fail-on twice");
    EXPECT_EQ(partial.status, 2);
    EXPECT_EQ(partial.err, "rastertrace: -: --fail-on: expected a trace with all its steps, found "
                           "one that steps were left out of\n");
}

// In double, E of BC is -2.2e-15 at the center of (3, 9). In fractions, the center lies on BC, which
// is no left edge.
TEST_F(ProgramTest, StatsReadsTheDecimalsOfATraceAsItsDoubles) {
    write("doubles.json", R"({"canvas":{"width":8,"height":18,"origin":"top-left"},
        "vertices":{"A":["10/7",12],"B":["20/7",5],"C":["30/7",15]},"triangles":["ABC"],
        "method":{"fill":"top-left"}})");
    const Outcome told =
        shell("$rastertrace stats doubles.json --fail-on holes,twice,outside,rows");
    EXPECT_EQ(told.status, 0);
    EXPECT_EQ(told.err, "");
    EXPECT_THAT(told.out, EndsWith("triangle ABC: 10 writes\n"));
}

// A corner of the cube points at the viewer: three faces are in front, three behind. All six sides
// of its outline are folds.
TEST_F(ProgramTest, StatsDoesNotCountTheFoldsOfAClosedMeshAsDrawnTwice) {
    write("cube.json", R"({"canvas":{"width":40,"height":40,"origin":"top-left"},
        "meshes":[{"name":"cube","vertices":{"A":[-1,-1,-1],"B":[1,-1,-1],"C":[1,1,-1],
                   "D":[-1,1,-1],"E":[-1,-1,1],"F":[1,-1,1],"G":[1,1,1],"H":[-1,1,1]},
                   "faces":["ADCB","EFGH","ABFE","BCGF","CDHG","DAEH"]}],
        "camera":{"position":[3,4,5],"look_at":[0,0,0],"up":[0,1,0]},
        "projection":{"type":"frustum","fov_y":40,"near":1,"far":20},
        "method":{"depth":"painter","fill":"top-left"}})");
    const std::string stats = "$rastertrace stats cube.json --fail-on holes,twice,outside ";
    const Outcome sound = shell(stats);
    EXPECT_EQ(sound.err, "");
    EXPECT_EQ(sound.status, 0);
    EXPECT_THAT(sound.out, HasSubstr("mesh cube: 12 primitives, "));
    // What lies on two sides of an edge still counts.
    EXPECT_EQ(shell(stats + "--fill barycentric --snap nearest --sample integer").err,
              "rastertrace: --fail-on: found twice\n");
}

TEST_F(ProgramTest, StatsPassesNothingThatItCannotJudge) {
    shell("sed 's/\"at\":\\[.*\\]\\],//' $examples/regression/fast.jsonl > fast.jsonl");
    const Outcome lacking =
        shell("$rastertrace stats fast.jsonl --fail-on holes,twice,outside,rows");
    EXPECT_EQ(lacking.status, 2);
    EXPECT_EQ(
        lacking.err,
        "rastertrace: fast.jsonl: --fail-on: holes, twice, outside cannot be judged: expected "
        "\"at\", three pairs of numbers, of triangle ABC (step 1), found none\n");
    EXPECT_EQ(shell("$rastertrace stats fast.jsonl --fail-on rows").status, 0);
    EXPECT_EQ(shell("$rastertrace stats fast.jsonl").status, 0);

    // What was found is told as well.
    shell(
        "sed '0,/pixel/{/pixel/d}' fast.jsonl | sed 's/\"steps\":.*/\"steps\":54}}/' > less.jsonl");
    const Outcome both = shell("$rastertrace stats less.jsonl --fail-on outside,rows");
    EXPECT_EQ(both.status, 2);
    EXPECT_THAT(both.err, HasSubstr("rastertrace: --fail-on: found rows\n"));
    EXPECT_THAT(both.err, HasSubstr("--fail-on: outside cannot be judged: expected \"at\""));
}

// The corners are the centers of the three pixels. The integer point of (0, 0) lies outside.
TEST_F(ProgramTest, StatsFindsTheSampleOfATraceThatDoesNotTellIt) {
    write("foreign.jsonl", R"({"rastertrace":1,"canvas":{"width":3,"height":3,"origin":"top-left"}}
{"step":"primitive","kind":"triangle","name":"ABC","at":[[0.5,0.5],[1.5,0.5],[0.5,1.5]]}
{"step":"pixel","x":0,"y":0}
{"step":"pixel","x":1,"y":0}
{"step":"pixel","x":0,"y":1}
{"end":{"steps":4}}
)");
    const Outcome found = shell("$rastertrace stats foreign.jsonl --fail-on holes,outside");
    EXPECT_EQ(found.err, "");
    EXPECT_EQ(found.status, 0);
    EXPECT_THAT(found.out, EndsWith("sample      center: the header has no method.sample, and only "
                                    "this one explains all pixels\n"
                                    "triangle ABC: 3 writes\n"));
    EXPECT_THAT(shell("$rastertrace stats foreign.jsonl --json").out,
                HasSubstr(R"(,"sample":{"judged_by":"center","explains_all":true},"primitives":)"));

    shell("sed 's/\"x\":1/\"x\":2/' foreign.jsonl > wrong.jsonl");
    EXPECT_THAT(shell("$rastertrace stats wrong.jsonl").out,
                HasSubstr("sample      integer: the header has no method.sample, and neither "
                          "integer nor center explains all pixels\n"));
}

// None of them has one but those that the tutorial has made for it: what lies beside each other there shares its
// edges, or only passes.
TEST_F(ProgramTest, StatsTellsOfNoTJunctionInTheExamplesButThoseOfTheTutorial) {
    const std::set<std::string> about_them{"two-t-junctions.json", "m-up.json", "m-down.json"};
    for (const auto& entry : fs::recursive_directory_iterator(RASTERTRACE_EXAMPLES)) {
        if (entry.path().extension() != ".json")
            continue;
        const Outcome outcome = shell("$rastertrace stats '" + entry.path().string() + "'");
        EXPECT_EQ(outcome.status, 0) << entry.path();
        EXPECT_EQ(outcome.out.find("T-junction") != std::string::npos,
                  about_them.contains(entry.path().filename().string()))
            << entry.path() << outcome.out;
    }
}

TEST_F(ProgramTest, PlanSaysWhichStagesAreNeededAndWhy) {
    EXPECT_EQ(shell("$rastertrace plan $examples/t4-pipeline/camera-points.json").out,
              "Three points seen by T4's camera\n"
              "stage        plan      why; what it saves\n"
              "model        left out  no model moves anything; saves 4 steps\n"
              "view         kept      the camera moves the world\n"
              "clip near    kept      1 vertex lies outside it\n"
              "clip left    kept      1 vertex lies outside it\n"
              "clip right   kept      1 vertex lies outside it\n"
              "clip bottom  kept      1 vertex lies outside it\n"
              "clip top     kept      1 vertex lies outside it\n"
              "divide       kept      w is not 1 at every vertex\n"
              "order        left out  the method has no painter\n"
              "cull         left out  the method does not ask for it\n"
              "light        left out  the method does not ask for it\n"
              "canvas       left out  no triangle is filled\n"
              "depth        left out  the method has no depth buffer\n"
              "perspective  left out  no colors are mixed in a perspective\n"
              "colors       left out  no colors are mixed\n");
    const std::string triangle = "$examples/t0-fill/first-triangle.json";
    EXPECT_THAT(shell("$rastertrace plan --full " + triangle).out,
                HasSubstr("model        kept      asked to be kept; no model moves anything\n"));
    EXPECT_THAT(
        shell("$rastertrace plan --json --keep divide " + triangle).out,
        HasSubstr(R"({"stage":"divide","kept":true,"why":"asked to be kept; w is 1 at every )"
                  R"(vertex","saves":{"bytes":0,"steps":0,"pixels":0}})"));
    EXPECT_THAT(shell("$rastertrace show " + triangle + " --rounding truncate --full").out,
                EndsWith("\nstages: model, view, divide, canvas\n"));
    const Outcome unknown = shell("$rastertrace plan --keep dept " + triangle);
    EXPECT_EQ(unknown.status, 2);
    EXPECT_EQ(unknown.err,
              "rastertrace: --keep: expected stages out of model,view,clip,divide,order,cull,light,"
              "canvas,depth,perspective,colors, found \"dept\"\nhint: did you mean depth?\n");
    const Outcome nobody = shell("$rastertrace trace --primitive ABD " + triangle);
    EXPECT_EQ(nobody.status, 2);
    EXPECT_THAT(nobody.err, HasSubstr("expected a primitive of the scene, found ABD\n"
                                      "hint: did you mean ABC?\n"));
}

TEST_F(ProgramTest, StressListsEveryCaseInOneLine) {
    const Outcome table = shell("$rastertrace stress --quick");
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

TEST_F(ProgramTest, StressWritesTheEntriesOfTheDocumentation) {
    EXPECT_EQ(
        shell("$rastertrace stress --case L2,L6,P7 --markdown").out,
        "3 cases.\n"
        "\n"
        "## Lines\n"
        "\n"
        "[L2](#l2-many-ties), [L6](#l6-control-long-but-not-stiff)\n"
        "\n"
        "### L2: many ties\n"
        "\n"
        "Input: (0,0)-(60,10).\n"
        "Why: The gcd is 10: ten pixels lie halfway between two rows.\n"
        "What holds: 61 pixels. Naive with half away from zero and Bresenham differ at the 10 "
        "ties, "
        "first (3,1) against (3,0); with the same tie rule they are one line, unless rounded sums "
        "miss the ties (dda).\n"
        "\n"
        "What goes wrong:\n"
        "\n"
        "- dda: 2 pixels wrong (float); 8 pixels wrong (double)\n"
        "- naive, away, taken for bresenham: 10 pixels wrong (exact)\n"
        "\n"
        "```\n"
        "rastertrace stress --case L2 --scene > l2.json\n"
        "rastertrace show l2.json\n"
        "```\n"
        "\n"
        "### L6: control: long, but not stiff\n"
        "\n"
        "Input: (0,0)-(4095,4094).\n"
        "Why: A pixel in 1/8190 of a tie, and sums that may lose 2 px in float; but the roundings "
        "of a "
        "slope this near to 1 do not add up.\n"
        "What holds: Every pixel right, with every method.\n"
        "\n"
        "Nothing is wrong.\n"
        "\n"
        "```\n"
        "rastertrace stress --case L6 --scene > l6.json\n"
        "rastertrace show l6.json\n"
        "```\n"
        "\n"
        "## Pipeline\n"
        "\n"
        "[P7](#p7-no-normal-no-view)\n"
        "\n"
        "### P7: no normal, no view\n"
        "\n"
        "Input: B = C; the eye on a vertex; the eye in the plane.\n"
        "Why: A vector of length 0 has no cosine: 0/0.\n"
        "What holds: Not drawn, and nothing is normalized to decide it. A textbook's N.E/|N.E| is "
        "0/0.\n"
        "\n"
        "Nothing is wrong.\n"
        "\n"
        "```\n"
        "rastertrace stress --case P7 --scene > p7.json\n"
        "rastertrace show p7.json\n"
        "```\n");
}

TEST_F(ProgramTest, StressWritesEntriesThatMarkdownReadsAsTheyAre) {
    const auto entry = [this](const std::string& id) {
        return shell("$rastertrace stress --quick --markdown --case " + id).out;
    };
    EXPECT_THAT(entry("X2"), StartsWith("1 case.\n"));
    EXPECT_THAT(entry("X2"), HasSubstr("[X2](#x2-division-by-w--1)\n"));
    EXPECT_THAT(entry("Z3"), HasSubstr("[Z3](#z3-1z-falling-from-1-to-1r)\n"));
    EXPECT_THAT(entry("Z7"), HasSubstr("(With &lt;= all would pass; ours is strict.)\n"));
    EXPECT_THAT(entry("P9"), HasSubstr("eye = look\\_at"));
    // What is code already stays, and what is a number's name.
    EXPECT_THAT(entry("L11"), HasSubstr("a loop `while (x < x1)` draws none"));
    EXPECT_THAT(entry("L11"), HasSubstr("\nWhy: dx = 0, and dx &lt; 0.\n"));
    EXPECT_THAT(entry("P6"), HasSubstr("\nWhat holds: normal . view = -1: a back face. "));
    EXPECT_THAT(entry("X9"), HasSubstr("\nWhy: The pictures are the same; are the steps?\n"));
    EXPECT_THAT(entry("Z14"),
                HasSubstr("\n- scanline, rounded ends: 17 pixels wrong (float, double, "
                          "adaptive, exact); 16 pixels wrong (fixed)\n"));
    EXPECT_THAT(entry("S2"), HasSubstr("4 pixels wrong (every scalar)\n"));
    EXPECT_THAT(entry("C11"), EndsWith("\n\nAll of it is refused, with every scalar.\n"));
}

TEST_F(ProgramTest, StressShowsACaseInFull) {
    const Outcome outcome = shell("$rastertrace stress --case s6");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(
        outcome.out,
        StartsWith("S6  a step that is absorbed  (scanline fill)\n"
                   "\n"
                   "  input   edge (16777216,0)-(16777218,2000), floored\n"
                   "  why     1/1000 added to 2^24 is nothing: float's next number is 2 away\n"
                   "  holds   16777216 + floor(y/1000). "));
    EXPECT_THAT(
        outcome.out,
        HasSubstr("\n  incremental, x += dx/dy\n"
                  "    float                           wrong     1001 rows wrong, at most 2 "
                  "px; of 2001, first at\n"
                  "                                              y=1000\n"));
    EXPECT_THAT(outcome.out, HasSubstr("\n    double                          within    off by at "
                                       "most 1.8e-09 px\n"));
    EXPECT_THAT(outcome.out, EndsWith("\n  see     there is no scene to look at: this is a "
                                      "computation, or is refused\n"
                                      "\n"
                                      "as documented\n"));
    // Two cases by one list or by two options, each once.
    const std::string two = shell("$rastertrace stress --case S1,C15").out;
    EXPECT_EQ(shell("$rastertrace stress --case S1 --case c15 --case S1").out, two);
    EXPECT_THAT(two, HasSubstr("\nas documented\n\nC15  a T-junction  (edge functions)\n"));
    EXPECT_THAT(two,
                HasSubstr("          rastertrace stress --case C15 --scene 2 | rastertrace show "
                          "-   # an overlap\n"));
}

TEST_F(ProgramTest, StressPrintsTheSceneOfACaseToDraw) {
    const Outcome shown =
        shell("$rastertrace stress --case S1 --scene | $rastertrace show - --last --bare");
    EXPECT_EQ(shown.status, 0) << shown.err;
    EXPECT_EQ(shown.out,
              shell("$rastertrace show $examples/t0-fill/first-triangle.json --last --bare").out);
    EXPECT_NE(shell("$rastertrace stress --case C15 --scene 2").out,
              shell("$rastertrace stress --case C15 --scene").out);
    // A case that asks to be looked at can be.
    EXPECT_EQ(shell("$rastertrace stress --case P2 --scene | $rastertrace stats - --json").status,
              0);
}

TEST_F(ProgramTest, StressWritesJson) {
    const Outcome outcome = shell("$rastertrace stress --case S3,C10 --json");
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
    EXPECT_EQ(shell("$rastertrace stress --fill top-left " + scene).out.substr(0, 15),
              "First triangle\n");
    write("s3.json", R"({"title": "\u001b[2J", "canvas": {"width": 8, "height": 12,
        "origin": "top-left"}, "vertices": {"A": [0, 0], "B": [1, 10], "C": [5, 10]},
        "triangles": ["ABC"]})");
    const Outcome outcome = shell("$rastertrace stress s3.json --lerp incremental");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_THAT(
        outcome.out,
        StartsWith("<U+001B>[2J\n"
                   "\n"
                   "edges on samples, or within 2^-20 px of them: the tie rule or the rounding "
                   "decides\n"
                   "  edge CA of triangle ABC                 passes exactly through 6 row ends, "
                   "one at pixel (0, 0)\n"
                   "  edge AB of triangle ABC                 passes exactly through 2 row ends, "
                   "one at pixel (0, 0)\n"
                   "  edge BC of triangle ABC                 lies on row 10\n"
                   "\n"
                   "drawn with pixels that differ from `exact`\n"
                   "float      0 of 35\n"
                   "double     1 of 36, first (0, 10)\n"));
    const auto json =
        nlohmann::json::parse(shell("$rastertrace stress s3.json --lerp incremental --json").out);
    EXPECT_EQ(json["cliffs"][0]["cliff"], "sample-on-edge");
    EXPECT_EQ(json["cliffs"][0]["worst"].size(), 3u);
    EXPECT_EQ(json["pictures"][1], nlohmann::json::parse(R"({"scalar": "double", "pixels": 36,
        "differing": 1, "first": [0, 10]})"));
    write("calm.json", R"({"canvas": {"width": 16, "height": 16, "origin": "top-left"},
        "vertices": {"A": [1.25, 1.75], "B": [13.5, 3.25], "C": [4.75, 12.5]},
        "triangles": ["ABC"], "method": {"fill": "top-left"}})");
    EXPECT_THAT(
        shell("$rastertrace stress calm.json").out,
        StartsWith("calm.json\n"
                   "\n"
                   "Near no cliff: no sample within 2^-20 px of an edge, no sliver, nothing "
                   "steep, deep, far out\n"
                   "or edge-on.\n"));
}

TEST_F(ProgramTest, StressTellsOfTJunctionsInAScene) {
    const auto cliffs = [this](const std::string& scene, const std::string& options = "") {
        return shell("$rastertrace stress --case C15 --scene " + scene +
                     " | $rastertrace stress - " + options)
            .out;
    };
    EXPECT_THAT(cliffs("1"), HasSubstr("T-junctions, vertices on an edge that has no vertex there: "
                                       "every scalar may fall, `exact` too\n"
                                       "  edge PQ of triangle PQT                 M lies 0.025 px "
                                       "from it; 0 pixels in two triangles; 1\n"
                                       "                                          pixel in none: "
                                       "(8, 21)\n"));
    EXPECT_THAT(cliffs("2", "--json"),
                HasSubstr(R"("how_near":"M lies 0.025 px from it; 1 pixel in two triangles: )"
                          R"((31, 25); 0 pixels in none")"));
}

TEST_F(ProgramTest, CommandsThatNeedASceneSayThatATraceIsDrawnAlready) {
    ASSERT_EQ(
        shell("$rastertrace trace $examples/t0-fill/first-triangle.json -o drawn.json").status, 0);
    for (const char* const command : {"plan", "report", "stress"}) {
        const Outcome outcome = shell(std::string("$rastertrace ") + command + " drawn.json");
        EXPECT_EQ(outcome.status, 2) << command;
        EXPECT_EQ(outcome.err, "rastertrace: drawn.json: expected a scene, found a trace\n"
                               "hint: a trace is drawn already; `show` and `stats` read it\n")
            << command;
    }
}

TEST_F(ProgramTest, StressRefusesWhatItCannotRun) {
    const auto refusal = [this](const std::string& arguments) {
        const Outcome outcome = shell("$rastertrace stress " + arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        return outcome.err;
    };
    EXPECT_EQ(refusal("--case S19"),
              "rastertrace: --case: expected a case of the catalogue, L1 to L13, S1 to S14, C1 to "
              "C18, Z1 to Z14, P1 to P12 or X1 to X9, found \"S19\"\nhint: did you mean S1?\n");
    EXPECT_THAT(
        refusal("--markdown --json"),
        HasSubstr("--markdown: expected cases to print as entries of a page, found \"--json\""));
    EXPECT_EQ(
        refusal("--case Z5 --scene"),
        "rastertrace: --scene: expected a case with a scene, found Z5, which is a computation, "
        "or is refused\n");
    EXPECT_EQ(refusal("--case C15 --scene 3"),
              "rastertrace: --scene: expected a scene from 1 to 2 of C15, found 3\n");
    EXPECT_THAT(refusal("--scene"), HasSubstr("hint: say --case S1 --scene\n"));
    EXPECT_THAT(refusal("--case S1,S2 --scene"), HasSubstr("found \"S1,S2\"\n"));
    EXPECT_EQ(refusal("x.json --case S1"),
              "rastertrace: --case: expected cases, or a scene, not both, found \"x.json\"\n");
    EXPECT_EQ(refusal("--case L1,L2 L4"),
              "rastertrace: --case: expected cases, or a scene, not both, found \"L4\"\n"
              "hint: several cases are one word: --case L1,L2,L4\n");
    EXPECT_THAT(
        refusal("--fan-passes 2"),
        StartsWith("rastertrace: --fan-passes: expected a scene to draw by another method"));
    EXPECT_THAT(refusal("$examples/t0-fill/first-triangle.json --scalar double"),
                StartsWith("rastertrace: --scalar: expected no scalar"));
    EXPECT_THAT(refusal("no-such-file.json"), StartsWith("rastertrace: no-such-file.json: "));
    // Nothing to look at.
    write("empty.json", R"({"vertices": {"A": [1, 2]}})");
    EXPECT_THAT(refusal("empty.json"), HasSubstr("expected at least one primitive, found none"));
    write("nan.json", R"({"vertices": {"A": [NaN, 2]}, "triangles": ["AAA"]})");
    EXPECT_THAT(refusal("nan.json"), StartsWith("rastertrace: nan.json:1:21: "));
}

TEST_F(ProgramTest, ShowsThePictureOfTheTextbook) {
    const Outcome outcome =
        shell("$rastertrace show $examples/t0-fill/first-triangle.json --last --bare");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out, textbook_picture);
}

TEST_F(ProgramTest, ShowsFramesOfEveryRow) {
    const Outcome outcome =
        shell("$rastertrace show $examples/t0-fill/first-triangle.json --every scanline");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(
        outcome.out,
        HasSubstr(
            "\n\nFirst triangle                                             steps 14 "
            "to 19 of 62\n"
            "scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor -> -1   right AC: x = "
            "2 - 3/8 (2 - 5) = 25/8 -> floor -> 3\n\n"
            "     -8-7-6-5-4-3-2-1 0 1 2 3 4 5 6 7 8\n"));
    EXPECT_THAT(outcome.out, HasSubstr("\n> 2   . . . . . . . @ @ @ @ @ . . . . .\n"));
    EXPECT_EQ(outcome.out.find("\x1b"), std::string::npos);
}

TEST_F(ProgramTest, TraceOfASceneIsReadBackTheSame) {
    EXPECT_EQ(shell("$rastertrace trace $examples/t0-fill/first-triangle.json -o t.json").status,
              0);
    EXPECT_EQ(shell("$rastertrace trace $examples/t0-fill/first-triangle.json -o t.jsonl").status,
              0);
    EXPECT_EQ(
        shell("$rastertrace trace - <$examples/t0-fill/first-triangle.json >piped.json").status, 0);
    EXPECT_EQ(content("piped.json"), content("t.json"));
    EXPECT_EQ(visible_files(), 3u);
    const std::string stats = shell("$rastertrace stats t.json").out;
    EXPECT_EQ(shell("$rastertrace stats - <t.jsonl").out, stats);
    EXPECT_EQ(shell("$rastertrace stats $examples/t0-fill/first-triangle.json").out, stats);
    EXPECT_THAT(stats, HasSubstr("steps       62\n"));
    EXPECT_THAT(stats, HasSubstr("pixels      49 of 238 on the canvas\n"));
    EXPECT_THAT(
        shell("$rastertrace stats --json t.json").out,
        StartsWith(R"({"title":"First triangle","steps":62,"count":{"primitive":1,"edge":3,)"));
}

TEST_F(ProgramTest, ATraceIsCutDownAsIfItWereDrawnSo) {
    shell("$rastertrace trace $examples/t0-hidden/cube-culled.json -o whole.json; "
          "$rastertrace trace whole.json -o whole.jsonl");
    EXPECT_EQ(content("whole.jsonl"),
              shell("$rastertrace trace $examples/t0-hidden/cube-culled.json --format jsonl").out);
    for (const std::string options :
         {"--only face,vertex --format jsonl", "--only face,vertex", "--only light", ""}) {
        const std::string drawn =
            shell("$rastertrace trace $examples/t0-hidden/cube-culled.json " + options).out;
        EXPECT_THAT(drawn, HasSubstr("\"end\"")) << options;
        EXPECT_EQ(shell("$rastertrace trace whole.json " + options).out, drawn) << options;
        EXPECT_EQ(shell("$rastertrace trace whole.jsonl " + options).out, drawn) << options;
        EXPECT_EQ(shell("$rastertrace trace - <whole.jsonl " + options).out, drawn) << options;
    }
    // A part of a part, and what it does not have.
    shell("$rastertrace trace whole.json --only face,vertex -o part.json");
    EXPECT_EQ(shell("$rastertrace trace part.json --only face").out,
              shell("$rastertrace trace whole.json --only face").out);
    const auto refusal = [this](const std::string& arguments) {
        const Outcome outcome = shell("$rastertrace trace " + arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_EQ(outcome.out, "") << arguments;
        return outcome.err;
    };
    EXPECT_EQ(refusal("part.json --only pixel"),
              "rastertrace: pixel steps were left out of the trace\n");
    EXPECT_EQ(refusal("whole.json --region 0,0,1,1"),
              "rastertrace: whole.json: expected a scene for --region, found a trace\n"
              "hint: of a trace, --only writes the steps of some kinds\n");
    EXPECT_EQ(refusal("whole.json --primitive ABC --only face"),
              "rastertrace: whole.json: expected a scene for --primitive, found a trace\n"
              "hint: of a trace, --only writes the steps of some kinds\n");
    EXPECT_EQ(refusal("whole.json --fill fan"),
              "rastertrace: whole.json: expected a scene to draw with --fill fan, found a trace, "
              "which is drawn already\n");
    // What a terminal would obey is escaped, wherever it stands; what is above ASCII otherwise stays.
    write("foreign.jsonl",
          "{\"rastertrace\":1,\"title\":\"\\u202e\",\"canvas\":{\"width\":3,\"height\":3}}\n"
          "{\"step\":\"\\u009b\\u007f\\u202e\\u00e9\"}\n{\"step\":\"\xC2\x9B\"}\n{\"end\":{}}\n");
    EXPECT_EQ(shell("$rastertrace trace foreign.jsonl --format jsonl").out,
              "{\"rastertrace\":1,\"title\":\"\\u202e\",\"canvas\":{\"width\":3,\"height\":3}}\n"
              "{\"step\":\"\\u009b\\u007f\\u202e\\u00e9\"}\n"
              "{\"step\":\"\\u009b\"}\n"
              "{\"end\":{\"steps\":2,\"count\":{\"\\u009b\":1,"
              "\"\\u009b\\u007f\\u202e\xC3\xA9\":1}}}\n");
    // Neither a trace that breaks off nor itself is written.
    shell("head -n 20 whole.jsonl >cut.jsonl; cp whole.json older.json");
    EXPECT_THAT(refusal("cut.jsonl --only vertex -o older.json"), HasSubstr("truncated"));
    EXPECT_THAT(refusal("whole.json --only face -o whole.json"), HasSubstr("whole.json"));
    EXPECT_EQ(shell("cmp whole.json older.json").status, 0);
}

TEST_F(ProgramTest, SameSceneSameBytesInEveryLocaleAndTimeZone) {
    shell("$rastertrace trace $examples/t0-fill/first-triangle.json --scalar double -o a.json");
    shell("LC_ALL=de_DE.UTF-8 TZ=Asia/Tokyo $rastertrace trace "
          "$examples/t0-fill/first-triangle.json --scalar double -o b.json");
    EXPECT_FALSE(content("a.json").empty());
    EXPECT_EQ(content("a.json"), content("b.json"));
}

TEST_F(ProgramTest, AFileNameIsShownAndNotStored) {
    const std::string scene = R"({"vertices":{"A":[0,0]},"points":["A"]})";
    write("one.json", scene);
    write("other.json", scene);
    const std::string trace = shell("$rastertrace trace one.json").out;
    EXPECT_THAT(trace, StartsWith(R"({"rastertrace":1,"canvas":{)"));
    EXPECT_EQ(shell("$rastertrace trace other.json").out, trace);
    EXPECT_EQ(shell("$rastertrace trace - <one.json").out, trace);
    shell("$rastertrace trace one.json -o kept.trace.json");
    for (const std::string command : {"show", "stats", "plan", "stress"})
        EXPECT_THAT(shell("$rastertrace " + command + " ./one.json").out, StartsWith("one.json"))
            << command;
    EXPECT_THAT(shell("$rastertrace show kept.trace.json").out, StartsWith("kept.trace.json "));
    EXPECT_THAT(shell("$rastertrace show - <one.json").out, StartsWith("standard input "));
}

TEST_F(ProgramTest, MethodIsOverriddenOnTheCommandLine) {
    const Outcome outcome =
        shell("$rastertrace stats $examples/t0-fill/first-triangle.json --rounding truncate");
    EXPECT_THAT(outcome.out, HasSubstr("pixels      45 of 238"));
    const Outcome refused =
        shell("$rastertrace trace $examples/t0-fill/first-triangle.json -o t.json; "
              "$rastertrace show t.json --rounding truncate");
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.err,
              "rastertrace: t.json: expected a scene to draw with --rounding truncate, "
              "found a trace, which is drawn already\n");
    EXPECT_EQ(shell("$rastertrace show x --rounding trunkate").err,
              "rastertrace: --rounding: expected one of floor, nearest, truncate, inside, "
              "half-open, found "
              "\"trunkate\"\nhint: did you mean truncate?\n");
}

TEST_F(ProgramTest, ErrorsHaveFileLineColumnAndCaret) {
    write("bad.json", "{\"vertices\": {\"A\": [2, 5]},\n \"trinagles\": [\"AAA\"]}\n");
    const Outcome outcome = shell("$rastertrace trace bad.json -o t.json");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "rastertrace: bad.json:2:2: expected a key out of title, canvas, "
                           "background, vertices, colors, triangles, "
                           "outlines, lines, points, meshes, model, camera, projection, viewport, "
                           "light, method, keep, vary, found \"trinagles\"\n"
                           " \"trinagles\": [\"AAA\"]}\n"
                           " ^\n"
                           "hint: did you mean \"triangles\"?\n");
    EXPECT_EQ(visible_files(), 1u) << "nothing was written";
}

TEST_F(ProgramTest, HintsSayHowJsonWritesIt) {
    const std::vector<std::pair<std::string, std::string>> slips{
        {R"({"A": [2, 5,]})", "13: expected a value, found ']'\n"
                              "{\"A\": [2, 5,]}\n"
                              "            ^\n"
                              "hint: JSON has no comma behind the last value\n"},
        {R"({"A": [2, 5], })", "15: expected a key in double quotes, found '}'\n"
                               "{\"A\": [2, 5], }\n"
                               "              ^\n"
                               "hint: JSON has no comma behind the last value\n"},
        {R"({'A': [2, 5]})", "2: expected a key in double quotes or '}', found '''\n"
                             "{'A': [2, 5]}\n"
                             " ^\n"
                             "hint: JSON has double quotes: \"A\"\n"},
        {R"({"triangles": ['ABC']})", "16: expected a value or ']', found '''\n"
                                      "{\"triangles\": ['ABC']}\n"
                                      "               ^\n"
                                      "hint: JSON has double quotes: \"A\"\n"},
        {R"({"A": [25/8, 5]})", "10: expected ',' or ']', found '/'\n"
                                "{\"A\": [25/8, 5]}\n"
                                "         ^\n"
                                "hint: a fraction is written \"25/8\", in quotes\n"},
        {R"({"A": (2, 5)})", "7: expected a value, found '('\n"
                             "{\"A\": (2, 5)}\n"
                             "      ^\n"
                             "hint: JSON has square brackets: [2, 5]\n"},
        {R"({"A": [2, 5]} // a)", "15: expected the end of the file, found '/'\n"
                                  "{\"A\": [2, 5]} // a\n"
                                  "              ^\n"
                                  "hint: JSON has no comments\n"},
        {R"({"A": [2, /* x */ 5]})", "11: expected a value, found '/'\n"
                                     "{\"A\": [2, /* x */ 5]}\n"
                                     "          ^\n"
                                     "hint: JSON has no comments\n"},
        {R"(# the first triangle)", "1: expected a JSON value, found '#'\n"
                                    "# the first triangle\n"
                                    "^\n"
                                    "hint: JSON has no comments\n"},
    };
    for (const auto& [text, message] : slips) {
        write("scene.json", text);
        const Outcome outcome = shell("$rastertrace show scene.json");
        EXPECT_EQ(outcome.status, 2) << text;
        EXPECT_EQ(outcome.err, "rastertrace: scene.json:1:" + message);
    }
}

TEST_F(ProgramTest, HintsSayWhereAKeyOfTheMethodBelongs) {
    write("root.json", R"({"rounding": "floor"})");
    EXPECT_THAT(shell("$rastertrace show root.json").err,
                AllOf(StartsWith("rastertrace: root.json:1:2: expected a key out of title, "),
                      EndsWith(", found \"rounding\"\n"
                               "{\"rounding\": \"floor\"}\n"
                               " ^\n"
                               "hint: \"rounding\" belongs in \"method\": {\"rounding\": ...}\n")));
    write("line.json", R"({"line": ["AB"]})");
    EXPECT_THAT(shell("$rastertrace show line.json").err,
                EndsWith("hint: \"line\" belongs in \"method\": {\"line\": ...}; did you mean "
                         "\"lines\"?\n"));
    write("canvas.json", R"({"vertices": {"A": [0, 0]}, "points": ["A"], "canvas": {"fill": 1}})");
    EXPECT_THAT(shell("$rastertrace show canvas.json").err,
                EndsWith("hint: \"fill\" belongs in \"method\": {\"fill\": ...}\n"));
}

TEST_F(ProgramTest, FacesOfAFileAreCutAndToldOf) {
    // A quad, an arrow head, a bow tie and a triangle; and a curve.
    write("a.obj", "v 0 0 0\nv 8 0 0\nv 8 8 0\nv 0 8 0\nv 2 2 0\nv 2 5 0\ncstype bezier\nvp 1\n"
                   "f 1 2 3 4\nf 2 5 4 1\nf 1 3 2 6\nf 1 2 3\n");
    write("scene.json", "{\"canvas\": {\"width\": 17, \"height\": 17},\n"
                        " \"meshes\": [{\"obj\": \"a.obj\"}, {\"obj\": \"a.obj\"}]}");
    const Outcome outcome =
        shell("$rastertrace show scene.json --every primitive --format csv | cut -d, -f 3");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out,
                HasSubstr("\na.f1.1\na.f1.2\na.f2.1\na.f2.2\na.f3.1\na.f3.2\na.f4\na-2.f1.1\n"));
    EXPECT_THAT(
        shell("$rastertrace show scene.json --every triangulate").out,
        HasSubstr(
            "\n   1  face a.f2 is not convex; its normal (0, 0, 32) is largest in z, which is "
            "dropped; ears: a.f2.1; what is left is a.f2.2\n"));
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

TEST_F(ProgramTest, ADecimalCommaIsRemarkedOn) {
    write("scene.json", "{\"vertices\": {\"A\": [2, 5], \"B\": [-4, -3],\n"
                        "              \"C\": [5,5, -3]},\n"
                        " \"triangles\": [\"ABC\"]}");
    const Outcome outcome = shell("$rastertrace show scene.json");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err,
              "rastertrace: scene.json:2:20: remark: expected [x, y] as of other vertices, found "
              "three numbers; nothing in this scene uses z\n"
              "              \"C\": [5,5, -3]},\n"
              "                   ^\n"
              "hint: a decimal comma? JSON has a point: 5.5\n");
    EXPECT_EQ(shell("$rastertrace show scene.json --cull back").err, "");
    EXPECT_EQ(shell("$rastertrace show scene.json --depth linear-z").err, "");
    write("all.json", R"({"vertices": {"A": [2, 5, 1], "B": [4, 3, 1]}, "lines": ["AB"]})");
    EXPECT_EQ(shell("$rastertrace show all.json").err, "");
}

TEST_F(ProgramTest, FilesThatCannotBeRead) {
    EXPECT_EQ(
        shell("$rastertrace show no-such-file.json").err,
        "rastertrace: no-such-file.json: expected a file that can be read, found: No such file "
        "or directory\n");
    EXPECT_EQ(shell("$rastertrace show no-such-file.json").status, 2);
    EXPECT_EQ(shell("$rastertrace show .").err,
              "rastertrace: .: expected a file, found a folder\n");
    EXPECT_EQ(shell("$rastertrace show .").status, 2);
    EXPECT_EQ(shell("$rastertrace show - <&-").status, 3);
    EXPECT_EQ(shell("head -c 3000 $rastertrace >binary; $rastertrace show binary").status, 2);
}

// What stands behind a zero byte would go unseen.
TEST_F(ProgramTest, AZeroByteIsRefusedInEveryFile) {
    write("scene.json", R"({"vertices":{"A":[1,1]},"points":["A"]})" + std::string("\0?", 2));
    EXPECT_EQ(shell("$rastertrace trace scene.json").err,
              "rastertrace: scene.json:1:40: expected text, found a zero byte\n"
              "{\"vertices\":{\"A\":[1,1]},\"points\":[\"A\"]}<U+0000>?\n" +
                  std::string(39, ' ') + "^\n");
    shell("$rastertrace trace $examples/t0-fill/first-triangle.json -o t.jsonl; "
          "printf '\\000?' >> t.jsonl");
    const Outcome trace = shell("$rastertrace show t.jsonl");
    EXPECT_EQ(trace.status, 2);
    EXPECT_THAT(trace.err, HasSubstr("expected text, found a zero byte"));
    write("a.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n# \0\nf 9 9 9\n", 44));
    write("mesh.json", R"({"canvas":{"width":9,"height":9},"meshes":[{"obj":"a.obj"}]})");
    const Outcome mesh = shell("$rastertrace trace mesh.json");
    EXPECT_EQ(mesh.status, 2);
    EXPECT_THAT(mesh.err, HasSubstr("a.obj:5:3: expected text, found a zero byte"));
}

TEST_F(ProgramTest, ATraceThatContradictsItselfIsTold) {
    write("t.json", R"({"rastertrace":1,"canvas":{"width":3,"height":3},"steps":[
{"step":"pixel","x":0,"y":0}
],
"end":{"steps":1,"pixels":99}})");
    for (const std::string command : {"show", "stats"}) {
        const Outcome told = shell("$rastertrace " + command + " t.json");
        EXPECT_EQ(told.status, 2);
        EXPECT_EQ(told.err,
                  "rastertrace: t.json:4:7: expected 99 pixels as the end record says, found 1\n"
                  "\"end\":{\"steps\":1,\"pixels\":99}}\n"
                  "      ^\n");
    }
}

// A script whose variable is empty must not get the standard output, or the whole catalogue.
TEST_F(ProgramTest, AnEmptyWordIsRefused) {
    for (const std::string words :
         {"stress ''", "trace ''", "show ''", "stats ''", "plan ''", "report ''", "help ''",
          "trace $examples/t0-fill/first-triangle.json -o ''",
          "trace $examples/t0-fill/first-triangle.json --output=",
          "show $examples/t0-fill/first-triangle.json --every ''", "stress --case ''"}) {
        const Outcome refused = shell("$rastertrace " + words);
        EXPECT_EQ(refused.status, 2) << words;
        EXPECT_EQ(refused.out, "") << words;
        EXPECT_THAT(refused.err, EndsWith(", found \"\"\n")) << words;
    }
    EXPECT_EQ(shell("$rastertrace stress ''").err,
              "rastertrace: stress: expected a word behind it, found \"\"\n");
}

TEST_F(ProgramTest, WhatNeverEndsIsRefusedAtOnce) {
    EXPECT_EQ(shell("timeout 20 $rastertrace show /dev/zero").err.substr(0, 64),
              "rastertrace: /dev/zero:1:1: expected text, found a zero byte\n<U+");
    const Outcome random = shell("timeout 20 $rastertrace plan /dev/urandom");
    EXPECT_EQ(random.status, 2);
    EXPECT_THAT(random.err, StartsWith("rastertrace: /dev/urandom:"));
    const Outcome words = shell("yes word | timeout 20 $rastertrace stats -");
    EXPECT_EQ(words.status, 2);
    EXPECT_EQ(words.err, "rastertrace: standard input:1:1: expected a JSON value, found 'word'\n"
                         "word\n"
                         "^\n");
    const Outcome blanks = shell("yes '' | timeout 20 $rastertrace show - --max-input 1MB");
    EXPECT_EQ(blanks.status, 2);
    EXPECT_EQ(blanks.err,
              "rastertrace: standard input: expected a file of at most 1 MB, found a larger one\n"
              "hint: --max-input SIZE raises the limit\n");
    EXPECT_EQ(shell("mkfifo pipe; cat $examples/t0-fill/first-triangle.json >pipe & "
                    "timeout 20 $rastertrace show pipe")
                  .status,
              0);
}

TEST_F(ProgramTest, TheLimitOnInputCanBeRaised) {
    const std::string scene = R"({"canvas":{"width":9,"height":9},"meshes":[{"obj":"a.obj"}]})";
    write("scene.json", std::string(1500, ' ') + scene);
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + std::string(2500, '#'));
    const Outcome whole = shell("$rastertrace plan scene.json");
    EXPECT_EQ(whole.status, 0) << whole.err;
    const Outcome refused = shell("$rastertrace plan scene.json --max-input 1kB");
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.err,
              "rastertrace: scene.json: expected a file of at most 1000 bytes, found a larger one\n"
              "hint: --max-input SIZE raises the limit\n");
    EXPECT_THAT(shell("$rastertrace plan scene.json --max-input 2kB").err,
                HasSubstr("expected a file of at most 2000 bytes, found a larger one (a.obj)"));
    EXPECT_EQ(shell("$rastertrace plan scene.json --max-input 3kB").status, 0);

    // A trace may have any size.
    EXPECT_EQ(shell("$rastertrace trace scene.json -o t.json; $rastertrace stats t.json "
                    "--max-input 1kB")
                  .status,
              0);
    EXPECT_EQ(shell("$rastertrace show scene.json --max-input lots").err,
              "rastertrace: --max-input: expected a size in kB, MB or GB, like 512MB, found "
              "\"lots\"\n");
}

TEST_F(ProgramTest, StepsThatAreHeldHaveALimitThatCanBeRaised) {
    write("scene.json", R"({"canvas":{"width":17,"height":14},
        "vertices":{"A":[2,5],"B":[-4,-3],"C":[5,-3]},"triangles":["ABC"],
        "method":{"fill":"barycentric"}})");
    const std::string hint =
        "hint: --max-steps N holds more of them, about 150 bytes each; `trace` "
        "writes any number of them\n";
    for (const std::string words :
         {"show scene.json", "stats scene.json", "explain scene.json --step last",
          "figure scene.json -o o.png", "figure scene.json -o o.html", "play scene.json",
          "diff scene.json --against scalar=exact"}) {
        const Outcome refused = shell("$rastertrace " + words + " --max-steps 50");
        EXPECT_EQ(refused.status, 2) << words;
        EXPECT_EQ(refused.err,
                  "rastertrace: scene.json: expected at most 50 steps to hold, found more\n" + hint)
            << words;
        EXPECT_EQ(refused.out, "") << words;
    }
    EXPECT_EQ(shell("ls").out, "scene.json\n");

    EXPECT_EQ(shell("$rastertrace show scene.json --max-steps 500").status, 0);
    EXPECT_EQ(shell("$rastertrace trace scene.json -o t.jsonl").status, 0);
    EXPECT_EQ(shell("$rastertrace stats t.jsonl --max-steps 50").err,
              "rastertrace: t.jsonl: expected at most 50 steps to hold, found more\n" + hint);
    EXPECT_EQ(shell("$rastertrace show scene.json --max-steps few").err,
              "rastertrace: --max-steps: expected a number of steps, from 1, found \"few\"\n");
}

TEST_F(ProgramTest, ALineOfATraceHasAnEnd) {
    const Outcome refused =
        shell("(echo '{\"rastertrace\":1,\"canvas\":{\"width\":3,\"height\":3}}'; "
              "head -c 16000001 /dev/zero | tr '\\000' ' '; echo '{\"step\":\"pixel\"}') | "
              "$rastertrace stats -");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("standard input:2:1: expected lines of at most 16 MB in a "
                                       "trace, found a longer one"));
}

// The largest file that the file system makes has no byte on the disk.
TEST_F(ProgramTest, AFileOfAnySizeIsReadBlockByBlock) {
    const Outcome huge = shell("for size in 9223372036854775807 17592186040320 1099511627776; do "
                               "truncate -s $size huge 2>/dev/null && break; done; "
                               "$rastertrace show huge");
    EXPECT_EQ(huge.status, 2);
    EXPECT_THAT(huge.err, StartsWith("rastertrace: huge:1:1: expected text, found a zero byte\n"));
}

// 8 bytes for each byte of input, and what the program itself needs.
TEST_F(ProgramTest, ReadingTakesLittleMemory) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer needs memory of its own";
#endif
    constexpr long of_program = 16'000'000;
    const auto peak = [this](const std::string& name) {
        const Outcome outcome = shell("$rastertrace plan " + name);
        EXPECT_LE(outcome.peak_memory,
                  8 * static_cast<long>(fs::file_size(folder_ / name)) + of_program)
            << name;
        return outcome;
    };
    // Straight to the disk: a program that is started counts the memory of the one that starts it.
    const auto write_around = [this](const std::string& name, std::string_view before,
                                     std::string_view after, const auto& item) {
        std::ofstream file(folder_ / name);
        file << before;
        for (int i = 0; i < 300'000; ++i)
            file << item(i) << ',';
        file << after;
    };
    const auto numbers = [](int) { return "1,1,1,1,1,1,1,1,1,1,1,1"; };
    write_around("unknown.json", "{\"unknown\":[", "1]}", numbers);
    EXPECT_THAT(peak("unknown.json").err, HasSubstr("expected a key out of"));
    write_around("wrong.json", "{\"vertices\":{\"A\":[", "1]}}", numbers);
    EXPECT_THAT(peak("wrong.json").err, HasSubstr("found an array of 3600001"));
    write_around("broken.json", "{\"vertices\":{\"A\":[", "1}}", numbers);
    EXPECT_THAT(peak("broken.json").err, HasSubstr("expected ',' or ']', found '}'"));
    write_around("keys.json", "{", "\"last\":1}",
                 [](int i) { return "\"" + std::to_string(1'000'000 + i) + "\":1"; });
    EXPECT_THAT(peak("keys.json").err, HasSubstr("expected a key out of"));
    write_around("mesh.json", R"({"canvas":{"width":9,"height":9},"meshes":[{"vertices":{)",
                 R"("A":[0,0,1],"B":[3,0,1],"C":[0,3,1]},"faces":["ABC"]}]})", [](int i) {
                     return "\"v" + std::to_string(i) + "\":[" + std::to_string(i % 89) + ".25,-" +
                            std::to_string(i % 97) + ".125,0.5]";
                 });
    EXPECT_EQ(peak("mesh.json").status, 0);
}

// 16 bytes for each pixel and 256 MB, however many steps there are: pixels of a row are one step.
TEST_F(ProgramTest, ALargeCanvasTakesSixteenBytesForEachPixel) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer needs memory of its own";
#endif
    constexpr long width = 8192;
    constexpr long height = 2048;
    write("scene.json", R"({"canvas":{"width":8192,"height":2048},
        "vertices":{"A":[-4000,-1000],"B":[4000,-1000],"C":[0,1000],"D":[0,-1000]},
        "triangles":["ABC","ADC"],"outlines":["ABC"]})");
    for (const std::string command : {"stats scene.json", "explain scene.json --pair ABC,ADC",
                                      "figure scene.json -o o.png --cell 1"}) {
        const Outcome outcome = shell("$rastertrace " + command);
        EXPECT_EQ(outcome.status, 0) << command << outcome.err;
        EXPECT_LE(outcome.peak_memory, 16 * width * height + 256'000'000) << command;
    }
}

// A scene from somewhere else cannot look around.
TEST_F(ProgramTest, AnObjFileLiesInTheFolderOfItsScene) {
    shell("mkdir -p scenes/models; ln -s ../../outside.obj scenes/models/link.obj; "
          "ln -s models/inside.obj scenes/alias.obj");
    const std::string obj = "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n";
    write("outside.obj", obj);
    write("scenes/models/inside.obj", obj);
    const auto scene = [](const std::string& path) {
        return R"({"canvas":{"width":9,"height":9},"meshes":[{"obj":")" + path + "\"}]}";
    };
    for (const std::string path : {"models/inside.obj", "alias.obj", "models/../models/inside.obj",
                                   "../scenes/models/inside.obj"}) {
        write("scenes/scene.json", scene(path));
        const Outcome drawn = shell("$rastertrace plan scenes/scene.json");
        EXPECT_EQ(drawn.status, 0) << path << drawn.err;
        EXPECT_EQ(shell("cd scenes; $rastertrace plan - <scene.json").status, 0) << path;
    }
    const std::string absolute = folder_ / "outside.obj";
    for (const std::string& path :
         {std::string("../outside.obj"), std::string("models/link.obj"), absolute}) {
        write("scenes/scene.json", scene(path));
        const Outcome refused = shell("$rastertrace plan scenes/scene.json");
        EXPECT_EQ(refused.status, 2) << path;
        EXPECT_THAT(refused.err, HasSubstr("expected an OBJ file in the scene's folder or below, "
                                           "found \""))
            << path;
        EXPECT_THAT(refused.err, EndsWith("hint: --allow-outside lets it lie anywhere\n")) << path;
        for (const std::string command : {"plan", "trace", "show", "stats", "stress"}) {
            const Outcome allowed =
                shell("$rastertrace " + command + " scenes/scene.json --allow-outside");
            EXPECT_EQ(allowed.status, 0) << path << allowed.err;
        }
    }
    write("scenes/scene.json", scene("../no-such-file.obj"));
    EXPECT_THAT(shell("$rastertrace plan scenes/scene.json").err, HasSubstr("or below, found"))
        << "nothing is told about files outside";

    write("scenes/shadow", "root:$6$secret:19000:0:99999:7:::\n");
    write("scenes/scene.json", scene("shadow"));
    EXPECT_EQ(shell("$rastertrace plan scenes/scene.json").err,
              "rastertrace: scenes/shadow:1:1: expected an OBJ file, found a line that is none of "
              "it\n"
              "hint: its statements are v, vt, vn, f, l, p, g, o, s, usemtl, mtllib\n");
}

TEST_F(ProgramTest, CaretsAndTitlesCountColumns) {
    write("scene.json", "{\"title\":\"三e\u0301\", \"tile\":1}");
    EXPECT_EQ(shell("$rastertrace plan scene.json").err,
              "rastertrace: scene.json:1:17: expected a key out of title, canvas, background, "
              "vertices, colors, "
              "triangles, outlines, lines, points, meshes, model, camera, projection, viewport, "
              "light, method, keep, vary, found \"tile\"\n"
              "{\"title\":\"三e\u0301\", \"tile\":1}\n"
              "                ^\n"
              "hint: did you mean \"title\"?\n");

    // A wide title moves nothing, and a wide name marks no pixel, which is one column.
    const auto shown = [this](const std::string& title, const std::string& name) {
        write("scene.json", "{\"title\":\"" + title + "\",\"vertices\":{\"" + name +
                                "\":[1,1]},\"points\":[[\"" + name +
                                "\"]],"
                                "\"canvas\":{\"width\":5,\"height\":5}}");
        std::string out = shell("$rastertrace show scene.json").out;
        EXPECT_THAT(out, HasSubstr("\n\n* " + name + " (1, 1)\n"));
        return out.substr(0, out.find("* ")).replace(0, title.size(), "TITLE");
    };
    EXPECT_EQ(shown("三角e\u0301", "三"), shown("abcde", "long"));
}

TEST_F(ProgramTest, NamesThatDifferLookDifferent) {
    write("scene.json", "{\"vertices\":{\"A\":[1,1]},\"points\":[[\"A\u200B\"]]}");
    EXPECT_EQ(shell("$rastertrace plan scene.json").err,
              "rastertrace: scene.json:1:36: expected the name of a vertex, found \"A<U+200B>\"\n"
              "{\"vertices\":{\"A\":[1,1]},\"points\":[[\"A<U+200B>\"]]}\n"
              "                                   ^\n"
              "hint: the scene has the vertices A\n");
}

TEST_F(ProgramTest, AFullDiskLeavesNoHalfFile) {
    EXPECT_EQ(shell("$rastertrace trace $examples/t0-fill/first-triangle.json >/dev/full").status,
              3);
    const Outcome device =
        shell("$rastertrace trace $examples/t0-fill/first-triangle.json -o /dev/full");
    EXPECT_EQ(device.status, 3);
    EXPECT_EQ(device.err,
              "rastertrace: /dev/full: could not be written: No space left on device\n");
    // A limit of one block of 512 bytes.
    write("old.json", "old");
    const Outcome limited = shell("ulimit -f 1; $rastertrace trace "
                                  "$examples/t0-fill/first-triangle.json -o old.json");
    EXPECT_EQ(limited.status, 3);
    EXPECT_THAT(limited.err, StartsWith("rastertrace: old.json: could not be written: "));
    EXPECT_EQ(content("old.json"), "old");
    EXPECT_EQ(visible_files(), 1u);
}

TEST_F(ProgramTest, NothingThatWasReadIsOverwritten) {
    const std::string scene = R"({"canvas": {"width": 9, "height": 9},
                                  "meshes": [{"obj": "models/c.obj"}]})";
    const std::string model = "v 0 0 0\nv 3 0 0\nv 0 3 0\nf 1 2 3\n";
    write("scene.json", scene);
    shell("mkdir models; ln -s scene.json link.json; ln scene.json hard.json; "
          "ln -s models/c.obj link.obj; ln -s gone.json dangling.json");
    write("models/c.obj", model);
    for (const std::string arguments :
         {"trace scene.json -o scene.json", "trace scene.json -o link.json",
          "trace scene.json -o hard.json", "trace link.json -o ./scene.json",
          "trace scene.json --format json -o models/c.obj",
          "trace scene.json --format json -o models/../link.obj",
          "trace - -o scene.json <scene.json", "trace scene.json >>scene.json",
          "trace scene.json 1<>models/c.obj", "show scene.json 1<>models/c.obj",
          "show scene.json >>hard.json", "stress scene.json >>scene.json",
          "plan - <scene.json >>scene.json",
          "report --quick --format csv scene.json -o models/c.obj",
          "report --quick --format csv - -o scene.json <scene.json",
          "report --quick --format csv $examples/t0-fill/first-triangle.json scene.json "
          "-o out.csv -o scene.json"}) {
        const Outcome outcome = shell("$rastertrace " + arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_THAT(outcome.err, EndsWith(": expected another file than those that are read, "
                                          "found one of them\n"))
            << arguments;
        EXPECT_EQ(content("scene.json"), scene) << arguments;
        EXPECT_EQ(content("models/c.obj"), model) << arguments;
        EXPECT_EQ(visible_files(), 6u) << arguments;
    }
}

// Also a mesh of the scene, what is compared with, and a name that a number makes.
TEST_F(ProgramTest, NothingThatAFigureHasReadIsOverwritten) {
    const std::string model = "v 0 0 0\nv 3 0 0\nv 0 3 0\nf 1 2 3\n";
    write("c-1.obj", model);
    write("scene.json", R"({"canvas": {"width": 9, "height": 9}, "meshes": [{"obj": "c-1.obj"}]})");
    ASSERT_EQ(shell("$rastertrace trace scene.json -o other-2.json; ln other-2.json hard").status,
              0);
    const std::string other = content("other-2.json");
    for (const std::string arguments :
         {"--format svg -o c-1.obj", "--format html -o c-1.obj", "-o - --format svg >>c-1.obj",
          "--every scanline --format txt -o c.obj",
          "--vary /meshes/0/model/0/translate/0=0:1:2 --format svg -o c.obj",
          "--against other-2.json --format svg -o hard",
          "--against other-2.json --every scanline --format png -o other.json"}) {
        write("scene.json", R"({"canvas": {"width": 9, "height": 9},
            "meshes": [{"obj": "c-1.obj", "model": [{"translate": [0, 0, 0]}]}]})");
        const Outcome outcome = shell("$rastertrace figure scene.json " + std::string(arguments));
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_THAT(outcome.err, EndsWith(": expected another file than those that are read, "
                                          "found one of them\n"))
            << arguments;
        EXPECT_EQ(content("c-1.obj"), model) << arguments;
        EXPECT_EQ(content("other-2.json"), other) << arguments;
        EXPECT_EQ(visible_files(), 4u) << arguments;
    }
}

TEST_F(ProgramTest, SeveralFilesGetTheirNamesTogether) {
    shell("cp $examples/t0-fill/first-triangle.json scene.json");
    const std::string figures =
        "$rastertrace figure scene.json --every pixel --format txt -o f.txt";
    // Once the first has its name, a signal waits for the last of 49.
    const Outcome ended = shell("env --default-signal=TERM " + figures +
                                " & until [ -e f-01.txt ]; do :; done; kill -TERM $!; wait $!; "
                                "ls f-*.txt | wc -l");
    EXPECT_EQ(ended.out, "49\n");
#ifdef RASTERTRACE_FAILING_CALLS
    const auto failing = [&](const std::string& how) {
        return shell("rm -f f-*.txt; " + how + " LD_PRELOAD=" RASTERTRACE_FAILING_CALLS " " +
                     figures);
    };
    // Not one before all are on the disk.
    const Outcome unsynced = failing("FAIL_CALL=fsync FAIL_AT=3");
    EXPECT_EQ(unsynced.status, 3);
    EXPECT_EQ(unsynced.err, "rastertrace: f-03.txt: could not be written: Input/output error\n");
    EXPECT_EQ(visible_files(), 1u);

    const Outcome unnamed = failing("FAIL_CALL=rename FAIL_AT=3 FAIL_ALWAYS=1");
    EXPECT_EQ(unnamed.status, 3);
    EXPECT_EQ(unnamed.err, "rastertrace: f-03.txt: could not be given its name: Input/output "
                           "error\nhint: new by then: f-01.txt, f-02.txt\n");
    EXPECT_EQ(shell("ls f-*.txt").out, "f-01.txt\nf-02.txt\n");
    EXPECT_THAT(failing("FAIL_CALL=rename FAIL_AT=1 FAIL_ALWAYS=1").err,
                EndsWith("\nhint: none of the other files is new\n"));
    EXPECT_EQ(visible_files(), 1u);
#endif
}

TEST_F(ProgramTest, ReportWritesNoFileTwice) {
    write("old.csv", "old");
    shell("ln -s old.csv link.csv; ln -s new.csv dangling.csv; mkdir folder");
    for (const std::string files : {"-o a.csv -o a.csv", "-o a.csv -o folder/../a.csv",
                                    "-o old.csv -o link.csv", "-o new.csv -o dangling.csv"}) {
        const Outcome outcome = shell("$rastertrace report --quick --jobs edge "
                                      "$examples/t0-fill/first-triangle.json " +
                                      files);
        EXPECT_EQ(outcome.status, 2) << files;
        EXPECT_THAT(outcome.err, HasSubstr("expected files to write that differ, found the file"))
            << files;
        EXPECT_EQ(content("old.csv"), "old") << files;
        EXPECT_EQ(visible_files(), 4u) << files;
    }
    EXPECT_EQ(shell("$rastertrace report --quick --jobs edge "
                    "$examples/t0-fill/first-triangle.json --format csv -o /dev/null -o /dev/null")
                  .status,
              0);
}

TEST_F(ProgramTest, TheExitStatusStandsWhereStandardErrorCannotBeWritten) {
    write("cut.json",
          shell("$rastertrace trace $examples/t0-fill/first-triangle.json").out.substr(0, 2000));
    for (const std::string no_stderr : {" 2>&-", " 2>/dev/full"}) {
        EXPECT_EQ(shell("$rastertrace show nothing.json" + no_stderr).status, 2);
        EXPECT_EQ(shell("$rastertrace show cut.json" + no_stderr).status, 2);
        EXPECT_EQ(shell("$rastertrace shw" + no_stderr).status, 2);
        EXPECT_EQ(shell("$rastertrace show --evry" + no_stderr).status, 2);
        EXPECT_EQ(shell("$rastertrace" + no_stderr).status, 2);
        EXPECT_EQ(shell("$rastertrace --version >/dev/full" + no_stderr).status, 3);
    }
    EXPECT_EQ(
        shell("mkfifo pipe; exec 3<>pipe 4>pipe; exec 3<&-; $rastertrace show nothing.json 2>&4")
            .status,
        2)
        << "a pipe that nobody reads";
    // No file gets the number of a closed descriptor, and so no message or picture.
    EXPECT_EQ(shell("$rastertrace trace $examples/t0-fill/first-triangle.json -o t.json "
                    "<&- >&- 2>&-")
                  .status,
              0);
    EXPECT_EQ(content("t.json"),
              shell("$rastertrace trace $examples/t0-fill/first-triangle.json").out);
}

TEST_F(ProgramTest, HelpThatCannotBeWrittenIsAFailure) {
    for (const std::string arguments :
         {"--help", "help", "help show", "show --help", "--version"}) {
        const Outcome full = shell("$rastertrace " + arguments + " >/dev/full");
        EXPECT_EQ(full.status, 3) << arguments;
        EXPECT_EQ(full.err, "rastertrace: standard output: could not be written: "
                            "No space left on device\n");
        const Outcome closed = shell("$rastertrace " + arguments + " >&-");
        EXPECT_EQ(closed.status, 3) << arguments;
        EXPECT_EQ(closed.err,
                  "rastertrace: standard output: could not be written: Bad file descriptor\n");
    }
}

// A report opens its files and then measures for minutes. Its second file is a pipe: once that can
// be opened for reading, both are open.
TEST_F(ProgramTest, ASignalLeavesNoFile) {
    const std::string run_and_end =
        "ulimit -c 0; mkfifo pipe.csv; for signal in INT TERM HUP QUIT XCPU; do "
        "$preload env --default-signal=$signal $rastertrace report "
        "$examples/numerics/friendly.json -o r.csv -o pipe.csv & "
        "exec 3<pipe.csv; kill -$signal $!; wait $!; echo $?; exec 3<&-; done; rm pipe.csv";
    const std::string statuses = "130\n143\n129\n131\n152\n";
    EXPECT_EQ(shell(run_and_end).out, statuses);
    EXPECT_EQ(visible_files(), 0u);
#ifdef RASTERTRACE_FAILING_CALLS
    // The same where files cannot be without a name.
    EXPECT_EQ(shell("preload='env FAIL_TMPFILE=1 LD_PRELOAD=" RASTERTRACE_FAILING_CALLS "'; " +
                    run_and_end)
                  .out,
              statuses);
    EXPECT_EQ(visible_files(), 0u);
#endif
    // What is ignored stays so.
    EXPECT_EQ(shell("trap '' HUP; mkfifo pipe.csv; $rastertrace report --quick --jobs edge "
                    "$examples/t0-fill/first-triangle.json -o r.csv -o pipe.csv & "
                    "exec 3<pipe.csv; kill -HUP $!; cat <&3 >copy.csv; wait $!")
                  .status,
              0);
    EXPECT_FALSE(content("r.csv").empty());
}

TEST_F(ProgramTest, WritesTheFileThatALinkLeadsTo) {
    shell("mkdir folder; ln -s folder/link2.json link.json; ln -s ../real.json folder/link2.json");
    const std::string trace = "$rastertrace trace $examples/t0-fill/first-triangle.json -o ";
    EXPECT_EQ(shell(trace + "link.json").status, 0) << "the link dangles";
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.json"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "folder/link2.json"));
    EXPECT_THAT(content("real.json"), StartsWith("{\"rastertrace\":1,"));
    shell("ln -s loop.json loop.json");
    const Outcome loop = shell(trace + "loop.json");
    EXPECT_EQ(loop.status, 3);
    EXPECT_EQ(loop.err, "rastertrace: loop.json: could not be created: Too many levels of symbolic "
                        "links\n");
}

TEST_F(ProgramTest, WritesNamesAsLongAsTheSystemTakes) {
    const std::string name = std::string(250, 'n') + ".json";
    const std::string trace = "$rastertrace trace $examples/t0-fill/first-triangle.json -o ";
    EXPECT_EQ(shell(trace + name).status, 0);
    EXPECT_EQ(shell(trace + name).status, 0) << "once more, over the first";
    EXPECT_THAT(content(name), StartsWith("{\"rastertrace\":1,"));
    const Outcome longer = shell(trace + "n" + name);
    EXPECT_EQ(longer.status, 3);
    EXPECT_THAT(longer.err, EndsWith(".json: could not be created: File name too long\n"));
}

TEST_F(ProgramTest, KeepsTheModeOfTheFileThatItReplaces) {
    const std::string trace = "$rastertrace trace $examples/t0-fill/first-triangle.json -o ";
    EXPECT_EQ(
        shell("umask 077; : >t.json; chmod 666 t.json; " + trace + "t.json; stat -c %a t.json").out,
        "666\n");
    EXPECT_EQ(shell("umask 022; chmod 640 t.json; " + trace + "t.json; stat -c %a t.json").out,
              "640\n");
    EXPECT_EQ(shell("umask 027; " + trace + "new.json; stat -c %a new.json").out, "640\n");
}

TEST_F(ProgramTest, AFileInAFolderThatTakesNoneIsNotWritten) {
    // Whoever runs the tests may write anywhere; nobody may not.
    const Outcome outcome = shell(
        "cp $rastertrace rastertrace; cp $examples/t0-fill/first-triangle.json .; mkdir folder; "
        "echo old >folder/old.json; chmod 666 folder/old.json; chmod 555 folder; chmod 755 .; "
        "as_nobody=; test $(id -u) != 0 || "
        "as_nobody='setpriv --reuid=65534 --regid=65534 --clear-groups'; "
        "$as_nobody ./rastertrace trace first-triangle.json -o folder/old.json");
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.err, "rastertrace: folder/old.json: may be written, but its folder takes no "
                           "new file to replace it by: Permission denied\n");
    EXPECT_EQ(content("folder/old.json"), "old\n");
    shell("chmod 755 folder");
}

TEST_F(ProgramTest, WaitsForAPipeThatIsFull) {
    write("big.json", R"({"canvas": {"width": 100, "height": 100},
        "vertices": {"A": [-50, -50], "B": [50, -50], "C": [0, 50]}, "triangles": ["ABC"]})");
    const std::string whole = shell("$rastertrace trace big.json").out;

    // A pipe that says EAGAIN as long as it is full. It is read once it is, or once the program ends.
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe2(pipe.data(), O_CLOEXEC), 0);
    ::fcntl(pipe[1], F_SETFL, O_NONBLOCK);
    const int capacity = ::fcntl(pipe[1], F_SETPIPE_SZ, 4096);
    ASSERT_LT(static_cast<std::size_t>(capacity), whole.size());
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe[1], 1);
    const std::string scene = (folder_ / "big.json").string();
    std::vector<std::string> words{RASTERTRACE_PROGRAM, "trace", scene};
    std::vector<char*> arguments{words[0].data(), words[1].data(), words[2].data(), nullptr};
    pid_t child = 0;
    ASSERT_EQ(
        ::posix_spawn(&child, RASTERTRACE_PROGRAM, &actions, nullptr, arguments.data(), environ),
        0);
    posix_spawn_file_actions_destroy(&actions);
    ::close(pipe[1]);
    siginfo_t ended{};
    for (int waiting = 0; waiting < capacity && ended.si_pid == 0; std::this_thread::yield()) {
        ::ioctl(pipe[0], FIONREAD, &waiting);
        ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
    }
    std::string received;
    std::array<char, 4096> buffer;
    for (ssize_t count = 0; (count = ::read(pipe[0], buffer.data(), buffer.size())) > 0;)
        received.append(buffer.data(), static_cast<std::size_t>(count));
    ::close(pipe[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(received, whole);
}

// Not under the sanitizers, which need memory and loading of their own.
#ifdef RASTERTRACE_FAILING_CALLS
TEST_F(ProgramTest, ASystemThatCannotOpenFilesIsNoBadInput) {
    write("bad.json", "not JSON");
    // 5: EIO, 12: ENOMEM, 23: ENFILE, 24: EMFILE
    for (const std::string error : {"5", "12", "23", "24"}) {
        const Outcome outcome =
            shell("FAIL_CALL=open FAIL_AT=1 FAIL_ERRNO=" + error +
                  " LD_PRELOAD=" RASTERTRACE_FAILING_CALLS " $rastertrace show bad.json");
        EXPECT_EQ(outcome.status, 3) << error;
        EXPECT_THAT(outcome.err,
                    StartsWith("rastertrace: bad.json: expected a file that can be read, found: "));
    }
    write("mesh.json", R"({"canvas": {"width": 9, "height": 9}, "meshes": [{"obj": "c.obj"}]})");
    const Outcome mesh =
        shell("FAIL_CALL=open FAIL_AT=2 "
              "LD_PRELOAD=" RASTERTRACE_FAILING_CALLS " $rastertrace show mesh.json");
    EXPECT_EQ(mesh.status, 3);
    EXPECT_EQ(mesh.err,
              "rastertrace: c.obj: expected a file that can be read, found: Too many open "
              "files\n");
}

// A depth for each of 500,000 pixels, each a fraction whose digits GMP keeps.
TEST_F(ProgramTest, LackOfMemoryIsAMessage) {
    write("deep.json", R"({"canvas": {"width": 1000, "height": 1000, "origin": "top-left"},
        "vertices": {"A": [0, 0, "1/123456789012345678901234567890123456789"], "B": [2000, 0, 1],
                     "C": [0, 2000, "2/3"]},
        "triangles": ["ABC"], "keep": ["depth"],
        "method": {"scalar": "exact", "depth": "linear-z", "fill": "top-left"}})");
    write("old.json", "old");
    const Outcome outcome = shell("ulimit -c 0; ulimit -v 80000; $rastertrace trace deep.json "
                                  "--only primitive -o old.json");
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.err, "rastertrace: out of memory\n");
    EXPECT_EQ(content("old.json"), "old");
    EXPECT_EQ(visible_files(), 2u);
}
#endif

TEST_F(ProgramTest, AClosedPipeEndsItQuietly) {
    write("big.json", R"({"canvas": {"width": 600, "height": 600},
        "vertices": {"A": [-300, -300], "B": [300, -300], "C": [0, 300]}, "triangles": ["ABC"]})");
    const Outcome outcome = shell("{ $rastertrace trace big.json; echo $? >status; } | head -1");
    EXPECT_THAT(outcome.out, StartsWith("{\"rastertrace\":1,"));
    EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(content("status"), "141\n") << "ended by the signal, as other programs are";
}

TEST_F(ProgramTest, ATruncatedTraceIsShownAsFarAsItGoes) {
    const Outcome outcome =
        shell("$rastertrace trace $examples/t0-fill/first-triangle.json | head -c 2000 >cut.json; "
              "$rastertrace show cut.json --bare");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.out, StartsWith(".................\n"));
    EXPECT_THAT(outcome.out, HasSubstr("#"));
    EXPECT_THAT(outcome.err, HasSubstr("the trace is truncated after "));
}

TEST_F(ProgramTest, OneGrammarSaysWhichStep) {
    const std::string show = "$rastertrace show $examples/t0-fill/first-triangle.json ";
    const std::string row = shell(show + "--step 14").out;
    EXPECT_THAT(row, HasSubstr("step 14 of 62\nscanline y=2 "));
    EXPECT_EQ(shell(show + "--step 'scanline y=2'").out, row);
    EXPECT_EQ(shell(show + "--step 'scanline right=3.125'").out, row);
    EXPECT_EQ(shell(show + "--step last").out, shell(show).out);
    EXPECT_EQ(shell(show + "--step first").out, shell(show + "--step 1").out);
    EXPECT_EQ(shell(show + "--step 0 --bare").status, 0);
    EXPECT_THAT(shell(show + "--every 'scanline y=2'").out, HasSubstr("steps 14 to 19 of 62\n"));
    EXPECT_EQ(shell(show + "--every 14").out, shell(show + "--every 'scanline y=2'").out);
    EXPECT_EQ(shell(show + "--every 0 --bare").out, shell(show + "--step 0 --bare").out);

    const Outcome faces =
        shell("$rastertrace show $examples/t0-hidden/cube-culled.json --every 'face culled'");
    EXPECT_EQ(faces.status, 0) << faces.err;
    EXPECT_THAT(faces.out, HasSubstr(": culled\n"));
    EXPECT_THAT(faces.out, Not(HasSubstr(": drawn\n")));
}

TEST_F(ProgramTest, WorkingIsWrittenBelowTheSentence) {
    const std::string show = "$rastertrace show $examples/t0-fill/first-triangle.json ";
    const std::string crossing =
        "left AB: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = "
        "(-4 - 2)/(-3 - 5) (2 - 5) + 2 = 3/4 (-3) + 2 = -1/4 -> floor -> -1\n";
    const std::string plain = shell(show + "--step 'scanline y=2'").out;
    EXPECT_THAT(plain, Not(HasSubstr(crossing)));
    const std::string worked = shell(show + "--step 'scanline y=2' --working").out;
    EXPECT_THAT(worked, HasSubstr("-> floor -> 3\n    " + crossing));
    EXPECT_THAT(worked, HasSubstr("\n> 2   . . . "));
    EXPECT_THAT(shell(show + "--every scanline --format table --working").out,
                HasSubstr("-> floor -> 3\n          " + crossing));
    EXPECT_THAT(shell("$rastertrace show $examples/t4-pipeline/six-spaces.json --every matrix "
                      "--working")
                    .out,
                HasSubstr("  [0 0 1 -4]  [0 0 0 1]\n"
                          "          d = p - l = (0, 0, 4) - (0, 0, 0) = (0, 0, 4), |d| = 4\n"));
    for (const std::string beside : {"--bare", "--every edge --format csv"}) {
        const Outcome refused = shell(show + "--working " + beside);
        EXPECT_EQ(refused.status, 2) << beside;
        EXPECT_THAT(refused.err, HasSubstr("--working")) << beside;
    }
}

TEST_F(ProgramTest, ARegionUpsideDownIsRefused) {
    for (const std::string command : {"show", "trace"}) {
        const Outcome refused = shell("$rastertrace " + command +
                                      " $examples/t0-fill/first-triangle.json --region 2,5,-4,-3");
        EXPECT_EQ(refused.status, 2);
        EXPECT_EQ(refused.err, "rastertrace: --region: expected the smaller x and y first, found "
                               "\"2,5,-4,-3\"\nhint: --region -4,-3,2,5\n");
    }
}

TEST_F(ProgramTest, OptionsOfTheGridAskForFrames) {
    const std::string show = "$rastertrace show $examples/t0-hidden/cube-culled.json --every face ";
    EXPECT_THAT(shell(show).out, Not(HasSubstr("\n  5  ")));
    for (const std::string option : {"--view writes", "--region -5,-4,4,5", "--overview"}) {
        EXPECT_THAT(shell(show + option).out, HasSubstr("\n  5  ")) << option;
        const Outcome refused = shell(show + option + " --format csv");
        EXPECT_EQ(refused.status, 2) << option;
        EXPECT_THAT(refused.err, HasSubstr("--format: expected a table, without --bare")) << option;
    }
}

TEST_F(ProgramTest, ListsOfListsAreReadableInTables) {
    EXPECT_THAT(shell("$rastertrace show $examples/t0-fill/first-triangle.json --every primitive "
                      "--format markdown")
                    .out,
                HasSubstr(" | ((2, 5), (-4, -3), (5, -3)) | "));
}

TEST_F(ProgramTest, ThePaintersOrderIsToldWhole) {
    const Outcome shown =
        shell("COLUMNS=80 $rastertrace show $examples/t0-hidden/cube-painter.json --step order");
    EXPECT_THAT(shown.out,
                HasSubstr("the painter draws, farthest first: EHG at 5, EGF at 5, DHE at 13/3, "
                          "BFG at 13/3,\nAEF at 13/3, "));
    EXPECT_THAT(shown.out, HasSubstr("\nABC at 3, ACD at 3\n"));
}

TEST_F(ProgramTest, ShowSaysHowMuchLiesOffTheCanvas) {
    // A textbook's y points up, the canvas's down: the points have negative rows.
    const std::string points =
        R"("vertices":{"A":[1,-1],"B":[3,-3]},"lines":["AB"],"points":["A"]})";
    write("down.json", R"({"canvas":{"width":4,"height":4,"origin":"top-left"},)" + points);
    EXPECT_THAT(shell("$rastertrace show down.json").out,
                EndsWith("\n\n4 pixels lie above the canvas, none drawn: does y point up? "
                         "(\"origin\": \"center\")\n"));
    EXPECT_EQ(shell("$rastertrace show down.json --bare").out, "....\n....\n....\n....\n");
    write("up.json", R"({"canvas":{"width":4,"height":4,"origin":"bottom-left"},)" + points);
    EXPECT_THAT(shell("$rastertrace show up.json").out,
                EndsWith("\n\n4 pixels lie below the canvas, none drawn: is the origin in the "
                         "middle? (\"origin\": \"center\")\n"));
    // A screen's coordinates on a canvas with its origin in the middle are too far up; what is too large for
    // either raises no question.
    write("middle.json", R"({"canvas":{"width":4,"height":4},"vertices":{"A":[0,2],"B":[0,3]},)"
                         R"("lines":["AB"]})");
    EXPECT_THAT(shell("$rastertrace show middle.json").out,
                EndsWith("\n\n1 pixel lies above the canvas, none drawn: does y point down? "
                         "(\"origin\": \"top-left\")\n"));
    write("large.json", R"({"canvas":{"width":4,"height":4,"origin":"top-left"},)"
                        R"("vertices":{"A":[0,3],"B":[0,5]},"lines":["AB"]})");
    EXPECT_THAT(shell("$rastertrace show large.json").out,
                EndsWith("\n\n2 pixels lie below the canvas, none drawn\n"));

    // Rows are dropped whole, triangles too; beside the canvas y is not asked for.
    const auto triangle = [this](const std::string& vertices) {
        write("triangle.json", R"({"canvas":{"width":4,"height":4,"origin":"top-left"},)"
                               R"("vertices":{)" +
                                   vertices + R"(},"triangles":["ABC"]})");
        const std::string out = shell("$rastertrace show triangle.json").out;
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
    EXPECT_THAT(shell("$rastertrace show $examples/t0-fill/first-triangle.json").out,
                Not(HasSubstr("the canvas")));
}

TEST_F(ProgramTest, StepsOutOfRangeAndKindsThatAreNotThere) {
    const std::string show = "$rastertrace show $examples/t0-fill/first-triangle.json ";
    const Outcome beyond = shell(show + "--step 63");
    EXPECT_EQ(beyond.status, 2);
    EXPECT_EQ(beyond.err, "rastertrace: --step: expected a step from 0 to 62, found 63\n63\n^\n");
    EXPECT_EQ(shell(show + "--step -1").err,
              "rastertrace: --step: expected a step from 0 to 62, found -1\n-1\n^\n");
    EXPECT_EQ(shell(show + "--every skanline").err,
              "rastertrace: --every: expected a kind of step that the trace has (primitive, edge, "
              "scanline, pixel), found skanline\n"
              "skanline\n"
              "^\n"
              "hint: did you mean scanline?\n");
    const Outcome several = shell(show + "--step scanline");
    EXPECT_EQ(several.status, 2);
    EXPECT_EQ(several.out, "");
    EXPECT_EQ(several.err,
              "rastertrace: --step: expected one step, found 9: 5, 7, 10, 14, 20, ...\n"
              "scanline\n"
              "^\n"
              "hint: say which, or use --every\n");
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
    const Outcome none = shell(show + "--every 'scanline y=9'");
    EXPECT_EQ(none.status, 2);
    EXPECT_EQ(none.err, "rastertrace: --every: expected a step of the trace, found none with y=9\n"
                        "scanline y=9\n"
                        "         ^\n"
                        "hint: scanline has y: 5, 4, 3, 2, 1, ...\n");
    EXPECT_EQ(shell(show + "--last --all").status, 2);
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
            const Outcome shown = shell("$rastertrace show distance.json" + options);
            EXPECT_EQ(shown.status, 0) << options << shown.err;
            EXPECT_EQ(shown.out, ".....\n.....\n###..\n.....\n.....\n") << options;
            const Outcome refused = shell("$rastertrace show inverse.json" + options);
            EXPECT_EQ(refused.status, 2) << options;
            EXPECT_THAT(refused.err, testing::StartsWith(
                                         "rastertrace: inverse.json:1:52: expected a distance "
                                         "above 0 for 1/distance, found vertex A at distance 0\n"))
                << options;
        }
}

TEST_F(ProgramTest, StepsAreToldInTheLanguageThatIsAskedForNeverInThatOfTheLocale) {
    const std::string triangle = " $examples/t0-fill/first-triangle.json";
    const std::string edge = triangle + " --every 'edge edge=BC' --format table";
    const std::string english = "First triangle\n\n   3  edge BC: horizontal, it has no dx/dy\n";
    const std::string portuguese = "First triangle\n\n   3  aresta BC: horizontal, não tem dx/dy\n";
    EXPECT_EQ(shell("$rastertrace show" + edge).out, english);
    EXPECT_EQ(shell("LC_ALL=pt_BR.UTF-8 LANG=pt_BR $rastertrace show" + edge).out, english);
    EXPECT_EQ(shell("RASTERTRACE_LANGUAGE= $rastertrace show" + edge).out, english);
    EXPECT_EQ(shell("RASTERTRACE_LANGUAGE=pt $rastertrace show" + edge).out, portuguese);
    EXPECT_EQ(shell("$rastertrace show --language pt" + edge).out, portuguese);
    EXPECT_EQ(shell("RASTERTRACE_LANGUAGE=pt $rastertrace show --language en" + edge).out, english);

    // Each command that tells steps.
    const std::string row = " --step 'scanline y=2'";
    for (const std::string& command :
         {"play" + triangle + row + " --print 80x24",
          "figure" + triangle + row + " -o - --format svg", "explain" + triangle + " --pixel 3,2",
          "diff --textconv" + triangle})
        EXPECT_THAT(shell("$rastertrace " + command + " --language pt").out, HasSubstr("linha y=2"))
            << command;
    EXPECT_THAT(shell("$rastertrace explain" + triangle + " --pixel 4,2 --language pt").out,
                HasSubstr("\n      direita AC: x = (x2 - x1)/(y2 - y1)"));
    EXPECT_THAT(shell("$rastertrace figure" + triangle + " -o - --format html --language pt").out,
                HasSubstr("\"language\":\"pt\""));
    write("one.claims", "scene: first.json\nedge AB: 4/3\n");
    EXPECT_THAT(
        shell("cp" + triangle + " first.json; $rastertrace check one.claims --language pt").out,
        HasSubstr("aresta AB: dx/dy"));

    EXPECT_EQ(shell("$rastertrace show --language fr" + edge).err,
              "rastertrace: --language: expected one of en, pt, found \"fr\"\n");
    const Outcome unknown = shell("RASTERTRACE_LANGUAGE=pt_BR $rastertrace show" + edge);
    EXPECT_EQ(unknown.err,
              "rastertrace: RASTERTRACE_LANGUAGE: expected one of en, pt, found \"pt_BR\"\n");
    EXPECT_EQ(unknown.status, 2);

    // A page is the same whoever renews it.
    write("page.md", "```\n$ rastertrace show first.json --every 'edge edge=BC' --format table\n" +
                         english + "```\n");
    EXPECT_EQ(shell("RASTERTRACE_LANGUAGE=pt $rastertrace renew --check page.md").status, 0);
}

TEST_F(ProgramTest, AFileWithoutACommandIsShown) {
    const std::string scene = "$examples/t0-fill/first-triangle.json";
    const Outcome shown = shell("$rastertrace show " + scene + " --bare");
    EXPECT_EQ(shown.status, 0);
    EXPECT_EQ(shell("$rastertrace " + scene + " --bare").out, shown.out);
    EXPECT_EQ(shell("cp " + scene + " a.json; $rastertrace a.json --bare").out, shown.out);
    EXPECT_EQ(shell("$rastertrace none.json").err,
              "rastertrace: none.json: expected a file that can be read, found: No such file or "
              "directory\n");
}

TEST_F(ProgramTest, AWindowOfALargerCanvasNamesTheOptionThatShowsAllOfIt) {
    write("large.json", R"({"canvas": {"width": 512, "height": 512, "origin": "top-left"},
"vertices": {"A": [0, 0], "B": [511, 0], "C": [0, 511]}, "triangles": ["ABC"]})");
    EXPECT_THAT(shell("COLUMNS=80 LINES=24 $rastertrace show large.json").out,
                HasSubstr("\n(x 0 to 73, y 496 to 511 of a canvas of 512 x 512; --overview: all of "
                          "it)\n"));
    EXPECT_THAT(shell("COLUMNS=80 LINES=24 $rastertrace show large.json --region 0,0,1,1").out,
                HasSubstr("\n(x 0 to 1, y 0 to 1 of a canvas of 512 x 512)\n"));
}

TEST_F(ProgramTest, UsageErrorsNameTheWordAndANearOne) {
    EXPECT_EQ(shell("$rastertrace").status, 2);
    EXPECT_THAT(shell("$rastertrace").err, HasSubstr("rastertrace show examples/"));
    EXPECT_EQ(shell("$rastertrace shw x").err, "rastertrace: expected a command out of trace, "
                                               "show, play, figure, explain, stats, check, diff, "
                                               "validate, plan, stress, report, renew, help, found "
                                               "\"shw\"\n"
                                               "hint: did you mean show?\n");
    EXPECT_EQ(shell("$rastertrace show x --evry pixel").err,
              "rastertrace show: --evry: no such option\nhint: did you mean --every?\n"
              "see rastertrace show --help\n");
    EXPECT_EQ(shell("$rastertrace show x --evry pixel").status, 2);
    EXPECT_EQ(shell("$rastertrace show x --step scanline y=2").err,
              "rastertrace show: The following argument was not expected: y=2\n"
              "hint: a step of several words goes in quotes: \"scanline y=2\"\n"
              "see rastertrace show --help\n");
    EXPECT_EQ(shell("$rastertrace trace x --only pixle").err,
              "rastertrace: --only: expected kinds of step out of "
              "triangulate,matrix,vertex,order,primitive,face,light,clip,edge,half,ray,scanline,"
              "along,decide,"
              "sample,depth,pixel,"
              "reject,skip,undecided, found \"pixle\"\n"
              "hint: did you mean pixel?\n");
    EXPECT_EQ(shell("$rastertrace trace x --region 1,2,3").err,
              "rastertrace: --region: expected two corners as x0,y0,x1,y1, like -4,-3,2,5, found "
              "\"1,2,3\"\n");
}

TEST_F(ProgramTest, RegionMayBeginWithANegativeNumber) {
    const Outcome outcome = shell("$rastertrace trace $examples/t0-fill/first-triangle.json "
                                  "--region -4,-3,-3,-3 --only pixel");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("\"count\":{\"pixel\":2}"));
}

// What small files could ask for, in processor time that even a slow build does not need (ulimit -t).
TEST_F(ProgramTest, ManyMeshesOfOneFileAreNamedQuickly) {
    write("one.obj", "v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 2 3\n");
    std::string meshes = R"({"obj":"one.obj"},{"obj":"one.obj","name":"one-3"})";
    for (int i = 2; i < 8000; ++i)
        meshes += R"(,{"obj":"one.obj"})";
    write("many.json", R"({"canvas":{"width":8,"height":8},"meshes":[)" + meshes + "]}");
    const Outcome trace = shell("ulimit -t 20; $rastertrace trace many.json --only primitive");
    EXPECT_EQ(trace.status, 0) << trace.err;
    const std::vector<std::string> names{"one.f1", "one-3.f1", "one-2.f1", "one-4.f1", "one-5.f1"};
    std::size_t at = 0;
    for (const std::string& name : names) {
        at = trace.out.find(R"("name":")" + name + "\"", at);
        ASSERT_NE(at, std::string::npos) << name;
    }
    EXPECT_THAT(trace.out, HasSubstr(R"("name":"one-8000.f1")"));
    EXPECT_THAT(trace.out, Not(HasSubstr(R"("name":"one-8001.f1")")));
}

TEST_F(ProgramTest, ManyUnknownKindsOfStepAreCountedQuickly) {
    std::string steps;
    for (int i = 0; i < 200000; ++i)
        steps += "{\"step\":\"kind" + std::to_string(i) + "\"}\n";
    write("many.jsonl", R"({"rastertrace":1,"canvas":{"width":1,"height":1}})"
                        "\n" +
                            steps + R"({"end":{"steps":200000}})" + "\n");
    const Outcome stats = shell("ulimit -t 20; $rastertrace stats many.jsonl");
    EXPECT_EQ(stats.status, 0) << stats.err;
    EXPECT_THAT(stats.out, HasSubstr("  kind199999 1\n"));
    const Outcome show = shell("ulimit -t 20; $rastertrace show many.jsonl --every kind");
    EXPECT_EQ(show.status, 2);
    EXPECT_THAT(show.err, HasSubstr("(kind0, kind1, kind2, "));
}

TEST_F(ProgramTest, AModelOfManyLongNumbersIsRefusedAtOnce) {
    // A 1 above and 997 bits below the bar, and two times 1/1: 1002 bits each step.
    const auto model = [](int steps) {
        const std::string large = "1" + std::string(300, '0');
        std::string text;
        for (int i = 0; i < steps; ++i)
            text += (i == 0 ? "\n" : ",\n") + (R"({"scale":["1/)" + large + R"(",1,1]})");
        return R"({"canvas":{"width":4,"height":4},"vertices":{"A":[0,0],"B":[1,0],"C":[0,1]},)"
               R"("triangles":["ABC"],"model":[)" +
               text + "]}";
    };
    write("long.json", model(64));
    const Outcome refused = shell("ulimit -t 20; $rastertrace plan long.json");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err,
                StartsWith("rastertrace: long.json:34:1: expected a model whose numbers have "
                           "at most 32768 bits as fractions, all together; found more\n"));
}

TEST_F(ProgramTest, AFanWiderThanEveryCanvasIsRefusedAtOnce) {
    const auto fan = [](const std::string& x) {
        return R"({"canvas":{"width":16,"height":16},"vertices":{"A":[0,0],"B":[)" + x +
               R"(,1],"C":[1,9]},"triangles":["ABC"],"method":{"fill":"fan"}})";
    };
    write("wide.json", fan("16384"));
    EXPECT_EQ(shell("$rastertrace stats wide.json").status, 0);
    write("wider.json", fan("16385"));
    const Outcome refused = shell("$rastertrace trace wider.json -o wider.trace.json");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err,
                StartsWith("rastertrace: wider.json:1:58: expected edges of at most 16384 "
                           "pixels for the fan, which draws a line for each, found vertex A at "
                           "(0, 0) and vertex B at (16385, 1)\n"));
}

TEST_F(ProgramTest, ReportMeasuresErrorAgainstRunTime) {
    const std::string report = "$rastertrace report --quick $examples/t0-fill/first-triangle.json";
    const Outcome table = shell(report);
    EXPECT_EQ(table.status, 0) << table.err;
    EXPECT_EQ(table.err, "") << "progress is for terminals";
    EXPECT_THAT(table.out, HasSubstr("\nFirst triangle\n==============\n"));
    EXPECT_THAT(table.out, HasSubstr("\nx += a, float (begun anew every so many rows)\n"));
    EXPECT_THAT(table.out, HasSubstr("\ndepth: nothing to measure: the scene has no depth\n"));
    EXPECT_THAT(table.out, HasSubstr("\n-> wrong pixels / perimeter pixels: Choose "));

    EXPECT_EQ(shell(report + " -o r.svg -o r.html -o r.csv -o r.json").out, "");
    EXPECT_EQ(visible_files(), 4u);
    EXPECT_THAT(content("r.svg"), StartsWith("<svg xmlns="));
    EXPECT_THAT(content("r.svg"), EndsWith("</svg>\n"));
    EXPECT_THAT(content("r.html"), EndsWith("</html>\n"));
    EXPECT_THAT(content("r.csv"), StartsWith("scene,job,method,knob,setting,measure,error,"));
    EXPECT_THAT(content("r.json"), StartsWith("{\n \"report\": 1,\n"));
}

// A title may be anything: in SVG and HTML it is XML, and in CSV no formula.
TEST_F(ProgramTest, ReportQuotesTitlesForEveryFormat) {
    write("scene.json", "{\"title\":\"=1+1\uFFFE\uFFFF\",\"vertices\":{\"A\":[0,0],\"B\":[5,0],"
                        "\"C\":[0,5]},\"triangles\":[\"ABC\"]}");
    const Outcome written = shell("$rastertrace report scene.json --quick --jobs edge "
                                  "-o r.svg -o r.html -o r.csv");
    EXPECT_EQ(written.status, 0) << written.err;
    for (const std::string name : {"r.svg", "r.html"}) {
        EXPECT_THAT(content(name), HasSubstr("=1+1&lt;U+FFFE&gt;&lt;U+FFFF&gt;")) << name;
        EXPECT_EQ(content(name).find("\uFFFE"), std::string::npos) << name;
    }
    EXPECT_THAT(content("r.csv"), HasSubstr("\n'=1+1<U+FFFE><U+FFFF>,"));
}

TEST_F(ProgramTest, ReportHasTheSameNumbersTwiceButForTheTimes) {
    write("line.json", R"({"vertices":{"A":[0,0],"B":[100,300]},"lines":["AB"]})");
    const std::string numbers =
        "$rastertrace report --quick line.json --jobs edge --format json | grep -E "
        "'\"(method|setting|value|count|of|adds|multiplies|divides|comparisons)\"'";
    const Outcome once = shell(numbers);
    EXPECT_THAT(once.out, HasSubstr("\"value\": "));
    EXPECT_EQ(shell(numbers).out, once.out);
}

TEST_F(ProgramTest, ReportRefusesBeforeItMeasures) {
    write("point.json", R"({"vertices":{"A":[0,0]},"points":["A"]})");
    const Outcome nothing = shell("$rastertrace report point.json -o r.svg");
    EXPECT_EQ(nothing.status, 2);
    EXPECT_EQ(nothing.err,
              "rastertrace: point.json: expected something to measure, found none (edge: the scene "
              "has no edge that passes a row of pixels; coverage: the scene has no triangle to "
              "fill; depth: the scene has no depth; color: the scene has no triangle with colored "
              "vertices)\n");
    EXPECT_EQ(visible_files(), 1u) << "nothing was written";
    EXPECT_EQ(
        shell("$rastertrace report point.json -o r.pdf").err,
        "rastertrace: r.pdf: expected a name that ends in .svg, .html, .json, .csv or .txt, found "
        ".pdf\n"
        "hint: --format says what to write\n");
    EXPECT_EQ(shell("$rastertrace report point.json --jobs edges").err,
              "rastertrace: --jobs: expected jobs out of edge,coverage,depth,color, found "
              "\"edges\"\nhint: did you mean edge?\n");
    EXPECT_EQ(shell("$rastertrace report point.json --format pdf").err,
              "rastertrace: --format: expected one of text, json, csv, svg, html, found \"pdf\"\n");
    EXPECT_EQ(shell("$rastertrace report").status, 2);
    EXPECT_EQ(shell("$rastertrace report --quick $examples/t0-fill/first-triangle.json --jobs edge "
                    "-o /dev/full --format svg")
                  .status,
              3);
}

TEST_F(ProgramTest, HelpOfEveryCommandHasAnExampleThatWorks) {
    EXPECT_THAT(shell("$rastertrace --version").out, StartsWith("rastertrace "));
    EXPECT_EQ(shell("$rastertrace --help").status, 0);
    for (const std::string command :
         {"trace", "show", "stats", "plan", "stress", "report", "renew"}) {
        const Outcome help = shell("$rastertrace " + command + " --help");
        EXPECT_EQ(help.status, 0);
        EXPECT_EQ(help.err, "");
        EXPECT_EQ(shell("$rastertrace help " + command).out, help.out);
        const auto example = help.out.find("Example: rastertrace ");
        ASSERT_NE(example, std::string::npos) << command;
        std::string line = help.out.substr(example + 21);
        line = line.substr(0, line.find('\n'));
        EXPECT_EQ(shell("[ -e docs ] || cp -r $examples $examples/../docs .; "
                        "$rastertrace " +
                        line)
                      .status,
                  0)
            << line;
    }
}

TEST_F(ProgramTest, NothingFromAFileReachesTheTerminalRaw) {
    write("evil.json", "{\"title\": \"a\\u001b]0;x\\u0007\\u009b\\u202e\\n\", \"vertices\": "
                       "{\"\\u001b[2J\": [1, 1]}, \"triangles\": [[\"\\u001b[2J\", \"\\u001b[2J\", "
                       "\"\\u001b[2J\"]]}");
    for (const std::string command : {"trace", "show --all", "stats", "stats --json"}) {
        const Outcome outcome = shell("$rastertrace " + command + " evil.json");
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.out.find('\x1b'), std::string::npos) << command;
        EXPECT_EQ(outcome.out.find('\a'), std::string::npos) << command;
        EXPECT_EQ(outcome.out.find("\xC2\x9B"), std::string::npos) << command;
        EXPECT_EQ(outcome.out.find("\xE2\x80\xAE"), std::string::npos) << command;
    }
}

} // namespace
} // namespace rastertrace
