// SPDX-License-Identifier: MIT
// `rastertrace stats` as a user calls it: what it counts, and what it fails on.

#include "program.h"

#include <algorithm>
#include <string>

namespace rastertrace {
namespace {

TEST_F(ProgramTest, StatsJudgeAdaptiveByTheCornersThatItDraws) {
    // B is no double: its nearest one would move pixels across the edges.
    write("scene.json", R"({"canvas":{"width":12,"height":12,"origin":"bottom-left"},
"vertices":{"A":[0,0],"B":["10/3",10],"C":[-8,5],"D":[10,0]},"triangles":["ABC","ABD"],
"method":{"fill":"top-left","sample":"integer"}})");
    const std::string exact = run("stats scene.json --scalar exact").out;
    EXPECT_EQ(run("stats scene.json --scalar adaptive").out, exact);
    EXPECT_THAT(run("trace scene.json --scalar adaptive").out,
                HasSubstr(R"("at":[["0","0"],["10/3","10"],["-8","5"]])"));
    // Once more in numbers that are no fractions of machine size.
    write("long.json", R"({"canvas":{"width":12,"height":12,"origin":"bottom-left"},
"vertices":{"A":[0,0],"B":["10/3",10],"C":[-8,"5000000000000000000001/1000000000000000000000"],"D":[10,0]},
"triangles":["ABC","ABD"],"method":{"fill":"top-left","sample":"integer"}})");
    EXPECT_THAT(run("trace long.json --scalar adaptive").out,
                HasSubstr(R"("numbers":"doubles within intervals)"));
    const auto without_steps = [](const std::string& text) {
        return text.substr(text.find("ABC"));
    };
    EXPECT_EQ(without_steps(run("stats long.json --scalar adaptive").out),
              without_steps(run("stats long.json --scalar exact").out));
}

// A square of two triangles: the scanline fill draws their diagonal twice, the top-left one gives it
// to ABC, whose left edge it is. The outline has 12 pixels, 4 of each side with 3 corners twice.
TEST_F(ProgramTest, StatsNamesThePixelsOfSharedEdges) {
    write("square.json", R"({"vertices":{"A":[0,0],"B":[3,0],"C":[3,3],"D":[0,3]},
                             "triangles":["ABC","ACD"],"outlines":["ABC"]})");
    EXPECT_THAT(run("stats square.json").out,
                EndsWith("triangle ABC: 10 writes\n"
                         "triangle ACD: 10 writes, 4 over a pixel drawn before\n"
                         "outline ABC: 12 writes to 9 pixels, 12 over a pixel drawn before\n"
                         "edge AC of ABC and ACD: 4 pixels written twice: (3, 3) (2, 2) (1, 1) (0, "
                         "0); 0 never\n"));
    EXPECT_THAT(run("stats square.json --fill top-left").out,
                EndsWith("triangle ABC: 6 writes\n"
                         "triangle ACD: 3 writes\n"
                         "outline ABC: 12 writes to 9 pixels, 8 over a pixel drawn before\n"));
    EXPECT_THAT(run("stats --json square.json").out,
                HasSubstr(R"("edges":[{"edge":"AC","triangles":["ABC","ACD"],)"
                          R"("twice":{"count":4,"pixels":[[3,3],[2,2],[1,1],[0,0]]},)"
                          R"("never":{"count":0,"pixels":[]}}])"));
}

// Three triangles on the same ten pixels: the nearest hides the one behind it and, drawn first, the
// one as near. Seen from behind, a triangle is culled. None of them misses a pixel.
TEST_F(ProgramTest, StatsCountsHiddenPixelsAsCovered) {
    write("hidden.json", R"({"vertices":{"A":[0,0,1],"B":[3,0,1],"C":[3,3,1],
                                         "D":[0,0,2],"E":[3,0,2],"F":[3,3,2],
                                         "G":[0,0,1],"H":[3,0,1],"I":[3,3,1]},
                             "triangles":["ABC","DEF",{"vertices":"GHI","color":"blue"}],
                             "method":{"fill":"barycentric","depth":"linear-z"}})");
    EXPECT_THAT(run("stats hidden.json").out,
                EndsWith("triangle ABC: 10 writes\n"
                         "triangle DEF: 0 writes, 10 hidden\n"
                         "triangle GHI: 0 writes, 10 hidden\n"
                         "depth ties: 10 pixels would have another color in another order: (3, 3) "
                         "(2, 2) (3, 2) (1, 1) (2, 1) (3, 1) (0, 0) (1, 0) (2, 0) (3, 0)\n"));
    write("culled.json", R"({"vertices":{"A":[0,0,1],"B":[3,0,1],"C":[3,3,1]},
                             "triangles":["ABC","ACB"],
                             "method":{"fill":"barycentric","cull":"back"}})");
    EXPECT_THAT(run("stats culled.json").out,
                EndsWith("triangle ABC: 10 writes\n"
                         "triangle ACB: 0 writes, skipped: culled\n"));
}

// The row y = 2 of the first triangle runs from -1/4 to 25/8: floor takes -1, left of the edge.
TEST_F(ProgramTest, StatsNamesThePixelsOutside) {
    const std::string stats = "$rastertrace stats $examples/t0-fill/first-triangle.json ";
    EXPECT_THAT(shell(stats).out,
                EndsWith("triangle ABC: 49 writes\n"
                         "  6 pixels drawn outside: (1, 4) (0, 3) (-1, 2) (-2, 0) (-3, -1) "
                         "(-4, -2)\n"));
    EXPECT_THAT(shell(stats + "--rounding nearest").out, HasSubstr("  6 pixels drawn outside: "));
    EXPECT_THAT(shell(stats + "--rounding inside").out, EndsWith("triangle ABC: 43 writes\n"));
    EXPECT_THAT(
        shell(stats + "--json").out,
        HasSubstr(
            R"("outside":{"count":6,"pixels":[[1,4],[0,3],[-1,2],[-2,0],[-3,-1],[-4,-2]]}})"));
}

TEST_F(ProgramTest, StatsAddsUpTheFacesOfAMesh) {
    const std::string scene = R"({"canvas":{"width":9,"height":9,"origin":"top-left"},"meshes":[
        {"name":"square","vertices":{"A":[0,0],"B":[4,0],"C":[4,4],"D":[0,4]},"faces":["ABCD"]}],
        "vertices":{"P":[6,0],"Q":[8,0],"R":[8,2]},"triangles":["PQR"]})";
    write("mesh.json", scene);
    EXPECT_THAT(run("stats mesh.json").out,
                EndsWith("triangle PQR: 6 writes\n"
                         "mesh square: 2 primitives, 30 writes, 5 over a pixel drawn before\n"
                         "1 edge within square: 5 pixels written twice: (0, 0) (1, 1) (2, 2) (3, "
                         "3) (4, 4); 0 never\n"));
    EXPECT_THAT(run("stats mesh.json --json").out,
                HasSubstr(R"({"kind":"triangle","name":"square.ACD","writes":15,)"));
    const Outcome cube = run("stats $examples/t3-light/lambert.json");
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
    EXPECT_THAT(run("stats foreign.json --fail-on rows"),
                Ends(1,
                     EndsWith("scanline y=0 of ABC (step 2), -2 to 1: 1 pixel neither drawn nor "
                              "rejected, 1 pixel too many\n"),
                     "rastertrace: --fail-on: found rows\n"));
    EXPECT_THAT(run("stats foreign.json --json").out,
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
    EXPECT_EQ(run("stats $examples/t0-fill/first-triangle.json --fail-on outside").err,
              "rastertrace: --fail-on: found outside\n");
    EXPECT_EQ(run("stats $examples/t4-fan/fan.json --fail-on holes,outside").err,
              "rastertrace: --fail-on: found holes, outside\n");

    EXPECT_THAT(
        shell(stats + "--fail-on hole"),
        Refused("rastertrace: --fail-on: expected findings out of holes,twice,outside,rows,redo, "
                "found \"hole\"\nhint: did you mean holes?\n"));
    EXPECT_THAT(run("trace square.json --only pixel | $rastertrace stats - --fail-on twice"),
                Refused("rastertrace: -: --fail-on: expected a trace with all its steps, found one "
                        "that steps were left out of\n"));
}

// In double, E of BC is -2.2e-15 at the center of (3, 9). In fractions, the center lies on BC, which
// is no left edge.
TEST_F(ProgramTest, StatsReadsTheDecimalsOfATraceAsItsDoubles) {
    write("doubles.json", R"({"canvas":{"width":8,"height":18,"origin":"top-left"},
        "vertices":{"A":["10/7",12],"B":["20/7",5],"C":["30/7",15]},"triangles":["ABC"],
        "method":{"fill":"top-left"}})");
    EXPECT_THAT(run("stats doubles.json --fail-on holes,twice,outside,rows"),
                Ends(0, EndsWith("triangle ABC: 10 writes\n"), ""));
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
    EXPECT_THAT(shell(stats), Ends(0, HasSubstr("mesh cube: 12 primitives, "), ""));
    // What lies on two sides of an edge still counts.
    EXPECT_EQ(shell(stats + "--fill barycentric --snap nearest --sample integer").err,
              "rastertrace: --fail-on: found twice\n");
}

TEST_F(ProgramTest, StatsPassesNothingThatItCannotJudge) {
    shell("sed 's/\"at\":\\[.*\\]\\],//' $examples/regression/fast.jsonl > fast.jsonl");
    EXPECT_THAT(
        run("stats fast.jsonl --fail-on holes,twice,outside,rows"),
        Refused("rastertrace: fast.jsonl: --fail-on: holes, twice, outside cannot be judged: "
                "expected \"at\", three pairs of numbers, of triangle ABC (step 1), found none\n"));
    EXPECT_EQ(run("stats fast.jsonl --fail-on rows").status, 0);
    EXPECT_EQ(run("stats fast.jsonl").status, 0);

    // What was found is told as well.
    shell(
        "sed '0,/pixel/{/pixel/d}' fast.jsonl | sed 's/\"steps\":.*/\"steps\":54}}/' > less.jsonl");
    EXPECT_THAT(run("stats less.jsonl --fail-on outside,rows"),
                Refused(AllOf(HasSubstr("rastertrace: --fail-on: found rows\n"),
                              HasSubstr("--fail-on: outside cannot be judged: expected \"at\""))));
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
    EXPECT_THAT(run("stats foreign.jsonl --fail-on holes,outside"),
                Ends(0,
                     EndsWith("sample      center: the header has no method.sample, and only this "
                              "one explains all pixels\n"
                              "triangle ABC: 3 writes\n"),
                     ""));
    EXPECT_THAT(run("stats foreign.jsonl --json").out,
                HasSubstr(R"(,"sample":{"judged_by":"center","explains_all":true},"primitives":)"));

    shell("sed 's/\"x\":1/\"x\":2/' foreign.jsonl > wrong.jsonl");
    EXPECT_THAT(run("stats wrong.jsonl").out,
                HasSubstr("sample      integer: the header has no method.sample, and neither "
                          "integer nor center explains all pixels\n"));
}

} // namespace
} // namespace rastertrace
