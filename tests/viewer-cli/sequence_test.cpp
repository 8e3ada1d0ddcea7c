// SPDX-License-Identifier: MIT
// The program on scenes whose numbers vary: every command, with and without --frame.

#include "program.h"

#include <string>

namespace rastertrace {
namespace {

/// A point that goes right, pixel by pixel: frame 2 of 3 has it in the middle.
class SequenceTest : public ProgramTest {
protected:
    SequenceTest() {
        write("scene.json", scene_with("[0, 1, 2]"));
        write("typed.json",
              R"({"title": "A point", "canvas": {"width": 3, "height": 1, "origin": "top-left"},
"vertices": {"A": [1, 0]}, "points": ["A"]})");
    }
    static std::string scene_with(const std::string& values) {
        return R"({"title": "A point", "canvas": {"width": 3, "height": 1, "origin": "top-left"},
"vertices": {"A": [0, 0]}, "points": ["A"], "vary": {"/vertices/A/0": )" +
               values + "}}";
    }
};

TEST_F(SequenceTest, ShowPrintsEveryFrameUnderItsLabel) {
    const std::string frame = "A point                                                             "
                              "step 2 of 2\n";
    EXPECT_THAT(run("show scene.json"), Prints(AllOf(StartsWith("1 of 3: A/0 0\n" + frame),
                                                     HasSubstr("\n\n2 of 3: A/0 1\n" + frame),
                                                     HasSubstr("\n\n3 of 3: A/0 2\n" + frame))));
    EXPECT_EQ(run("show scene.json --bare").out, "#..\n\n.#.\n\n..#\n");
    EXPECT_EQ(run("show scene.json --frame 2").out, run("show typed.json").out);

    // The command line varies other numbers, or the same by other values.
    EXPECT_EQ(run("show scene.json --bare --vary /vertices/A/0=2:1:2").out, "..#\n\n.#.\n");
    EXPECT_EQ(run("show typed.json --bare --vary /canvas/width=2,4").out, ".#\n\n.#..\n");
    EXPECT_EQ(run("show - --bare <scene.json").out, "#..\n\n.#.\n\n..#\n");
}

TEST_F(SequenceTest, AFaceKeepsItsLetterFromFrameToFrame) {
    // In the second frame B lies on A.
    write("two.json", R"({"canvas": {"width": 3, "height": 1, "origin": "top-left"},
"vertices": {"A": [0, 0], "B": [1, 0]}, "points": ["A", "B"], "vary": {"/vertices/B/0": [1, 0, 2]}})");
    EXPECT_EQ(run("show two.json --bare --view faces").out, "ab.\n\nb..\n\na.b\n");
    EXPECT_THAT(run("figure two.json --view faces -o two.txt; cat two*.txt").out,
                AllOf(HasSubstr("\n\nb B\n"), HasSubstr("\n\na A  b B\n"), Not(HasSubstr("a B"))));
}

TEST_F(SequenceTest, ATableForAnotherProgramIsOfOneFrame) {
    EXPECT_THAT(run("show scene.json --every pixel --format table").out,
                HasSubstr("3 of 3: A/0 2\nA point\n\n"));
    EXPECT_THAT(run("show scene.json --every pixel --json"),
                Refused("rastertrace: scene.json: --format: expected one frame, found 3\n"
                        "hint: --frame 1 makes a table of the first\n"));
    EXPECT_EQ(run("show scene.json --every pixel --json --frame 2").out,
              run("show typed.json --every pixel --json").out);
}

TEST_F(SequenceTest, TraceWritesAFileForEachFrameOrNone) {
    EXPECT_EQ(run("trace scene.json -o t.json").status, 0);
    EXPECT_EQ(visible_files(), 5u);
    EXPECT_EQ(run("trace typed.json | cmp - t-2.json").status, 0);
    EXPECT_EQ(run("trace scene.json --frame 2 | cmp - t-2.json").status, 0);
    EXPECT_EQ(run("show t-3.json --bare").out, "..#\n");

    // As many digits as the last one needs; one frame has the name as it was given.
    EXPECT_EQ(shell("mkdir more; $rastertrace trace scene.json --vary /vertices/A/0=0:2:12 -o "
                    "more/a.b.jsonl; ls more | head -2")
                  .out,
              "a.b-01.jsonl\na.b-02.jsonl\n");
    EXPECT_EQ(run("trace scene.json --frame 2 -o one.json; cmp one.json t-2.json").status, 0);

    // The last of them cannot be drawn: no file at all, and the older ones stay as they were.
    write("bad.json", R"({"canvas": {"width": 3, "height": 1, "origin": "top-left"},
"vertices": {"A": [0, 0]}, "points": ["A"], "vary": {"/canvas/width": [4, 5, 0.5]}})");
    EXPECT_THAT(shell("rm -r more; $rastertrace trace bad.json -o t.json"),
                Refused(StartsWith("rastertrace: bad.json:1:22: expected a whole number of pixels "
                                   "from 1 to 16384, found 0.5, in frame 3 of 3: width 0.5\n")));
    EXPECT_EQ(visible_files(), 7u);
    EXPECT_EQ(run("trace typed.json | cmp - t-2.json").status, 0);
}

TEST_F(SequenceTest, ManyFilesAreWrittenIfTheSystemLetsThemBeOpen) {
    const std::string trace =
        "$rastertrace trace scene.json --vary /vertices/A/0=0:2:100 -o t.json";
    EXPECT_EQ(shell("ulimit -S -n 64; " + trace).status, 0);
    EXPECT_EQ(visible_files(), 102u);
    EXPECT_THAT(
        shell("rm t-*; ulimit -n 64; " + trace),
        Refused(
            "rastertrace: expected at most 16 frames to write at once, found 100\n"
            "hint: --frame 1 writes the first; `ulimit -H -n` tells how many files may be open\n"));
    EXPECT_EQ(visible_files(), 2u);
}

TEST_F(SequenceTest, StandardOutputTakesOneTrace) {
    EXPECT_THAT(run("trace scene.json"),
                Ends(2, "",
                     "rastertrace: scene.json: expected one frame for standard output, found 3\n"
                     "hint: --frame 1 writes the first; -o scene.json writes each to a file, "
                     "scene-1.json and so on\n"));
    EXPECT_EQ(run("trace scene.json -o /dev/null").err,
              "rastertrace: /dev/null: expected a name for 3 files, found a device or a folder\n");
}

TEST_F(SequenceTest, OtherCommandsTakeTheFirstFrameOrTheOneThatIsNamed) {
    for (const std::string command : {"plan", "stats", "stress", "report --quick --jobs edge"}) {
        const Outcome typed = run(command + " typed.json");
        EXPECT_EQ(run(command + " scene.json --frame 2").out, typed.out) << command;
        EXPECT_EQ(run(command + " scene.json").status, typed.status) << command;
        EXPECT_THAT(run(command + " scene.json --frame 4"),
                    Refused(StartsWith(
                        "rastertrace: scene.json: expected a frame from 1 to 3, found frame 4\n")))
            << command;
    }
    // The first frame is not drawn where the canvas is narrower.
    EXPECT_THAT(run("stats scene.json --vary /vertices/A/0=7,1").out,
                HasSubstr("pixels      0 of 3"));
}

TEST_F(SequenceTest, WhatIsNoFrameIsRefused) {
    const auto complaint = [this](const std::string& arguments) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        return outcome.err;
    };
    EXPECT_EQ(complaint("show scene.json --frame 0"),
              "rastertrace: --frame: expected the number of a frame, from 1, found \"0\"\n");
    EXPECT_EQ(complaint("show typed.json --frame 2"),
              "rastertrace: typed.json: expected a frame from 1 to 1, found frame 2\n"
              "hint: \"vary\" in the scene, or --vary, makes more frames\n");
    EXPECT_EQ(complaint("show scene.json --vary /vertices/A/0"),
              "rastertrace: --vary: expected POINTER=FROM:TO:STEPS or a list of values, found "
              "\"/vertices/A/0\"\n"
              "hint: like /camera/position/2=4:1:7\n");
    EXPECT_EQ(complaint("stress --frame 2"),
              "rastertrace: --frame: expected a scene whose numbers vary, found \"none\"\n");
    run("trace typed.json -o t.json");
    EXPECT_EQ(complaint("show t.json --frame 1"),
              "rastertrace: t.json: expected a scene to draw with --frame 1, found a trace, which "
              "is drawn already\n");
    EXPECT_EQ(complaint("show t.json --vary /canvas/width=1:2:2"),
              "rastertrace: t.json: expected a scene to draw with --vary, found a trace, which is "
              "drawn already\n");
}

} // namespace
} // namespace rastertrace
