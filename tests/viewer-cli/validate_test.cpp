// SPDX-License-Identifier: MIT
// `rastertrace validate`, as a user calls it.

#include "program.h"

#include <nlohmann/json.hpp>

#include <string>

namespace rastertrace {
namespace {

constexpr const char* scene_json = R"({"canvas":{"width":17,"height":14},
 "vertices":{"A":[2,5],"B":[-4,-3],"C":[5,-3]},
 "triangles":["ABC"],
 "method":{"scalar":"exact"}})";

class ValidateTest : public ProgramTest {
protected:
    ValidateTest() {
        write("scene.json", scene_json);
        write("claims.txt", "scene: scene.json\ny=2: -1/4, 25/8 -> -1..3\nA screen: 9, 9\n");
        run("trace scene.json -o trace.json; $rastertrace trace scene.json -o trace.jsonl");
    }

    /// What is told of a copy of a trace that a sed script has changed.
    Outcome changed(const std::string& script, const std::string& trace = "trace.jsonl") const {
        return shell("sed -e '" + script + "' " + trace +
                     " > bad.json; $rastertrace validate bad.json");
    }
};

TEST_F(ValidateTest, SaysWhatEachFileIs) {
    write("turn.json", R"({"canvas":{"width":9,"height":9},"vertices":{"A":[0,0],"B":[3,0]},)"
                       R"("lines":["AB"],"points":["A","B"],"vary":{"/vertices/A/0":[0,1,2]}})");
    write("loose.txt", "y=2: -1/4, 25/8\n");
    EXPECT_THAT(run("trace scene.json --only pixel -o part.json; $rastertrace validate scene.json "
                    "trace.json trace.jsonl part.json turn.json claims.txt loose.txt"),
                Ends(0,
                     "scene.json: a scene, 1 triangle, 17 x 14 pixels\n"
                     "trace.json: a trace of version 1, 62 steps, complete; stats can judge holes, "
                     "twice, outside, rows\n"
                     "trace.jsonl: a trace of version 1, 62 steps, complete; stats can judge "
                     "holes, twice, outside, rows\n"
                     "part.json: a trace of version 1, 49 steps (others were left out), complete; "
                     "stats can judge nothing of it\n"
                     "turn.json: a scene of 3 frames, 1 line, 2 points, 9 x 9 pixels\n"
                     "claims.txt: 2 claims about scene.json\n"
                     "loose.txt: 1 claim, which name no scene\n",
                     ""));
}

// x of AB on row 2 is -1/4, whose floor is -1.
TEST_F(ValidateTest, DoesEveryStepOfATraceAgain) {
    const std::string of_redo = "; $rastertrace validate --redo bad.json";
    for (const std::string trace : {"trace.jsonl", "trace.json"}) {
        EXPECT_THAT(run("validate --redo " + trace), Prints(HasSubstr(" numbers done again\n")));
        EXPECT_THAT(shell(R"(sed -e 's/"from":-1,"to":3/"from":0,"to":3/' )" + trace +
                          " > bad.json" + of_redo),
                    Refused(AllOf(HasSubstr("expected -1 for scanline: from, done again from the "
                                            "numbers of the trace, found 0"),
                                  HasSubstr("hint: step 14 tells: scanline y=2"))));
        EXPECT_EQ(run("validate bad.json").status, 0);
        EXPECT_THAT(run("stats bad.json --fail-on redo"),
                    Ends(1, _, EndsWith("rastertrace: --fail-on: found redo\n")));
    }
    EXPECT_THAT(run("trace scene.json --only scanline -o bad.json" + of_redo),
                Refused(HasSubstr("--redo: expected a trace with all its steps")));
    EXPECT_THAT(run("validate --redo scene.json claims.txt - < trace.json"), Ends(0));
}

// Of every fill and line, and by every command that does a trace again.
TEST_F(ValidateTest, DoesEachNumberAgain) {
    const auto redone = [this](const std::string& scene, const std::string& script) {
        return shell("$rastertrace trace " + scene + " -o right.jsonl && sed -e '" + script +
                     "' right.jsonl > bad.json && ! cmp -s right.jsonl bad.json && "
                     "$rastertrace validate --redo right.jsonl > ok.txt && "
                     "$rastertrace validate --redo bad.json");
    };
    write("samples.json", R"({"canvas":{"width":8,"height":8,"origin":"top-left"},
        "vertices":{"A":[2,1],"B":[6,3],"C":[2,6]},"triangles":["ABC"],"method":{"fill":"top-left"}})");
    for (const std::string left : {"4", R"("NaN")"})
        EXPECT_THAT(redone("samples.json", R"(s/"y":2,"left":2,/"y":2,"left":)" + left + ",/"),
                    Refused(HasSubstr("expected 2 for scanline: left, done again")))
            << left;
    EXPECT_THAT(run("stats bad.json --fail-on redo"), Ends(1));
    EXPECT_THAT(run("show bad.json --step \"scanline y=2\" --color never").out,
                HasSubstr("[!] its numbers give left = 2"));
    const std::string bresenham = std::string(RASTERTRACE_EXAMPLES) + "/t2-lines/bresenham.json";
    EXPECT_THAT(redone(bresenham, R"(0,/"d":3,/s/"d":3,/"d":17,/)"),
                Refused(HasSubstr("expected 3 for decide: d, done again")));
    EXPECT_THAT(redone(bresenham, R"(0,/"octant":1/s/"octant":1/"octant":2/)"),
                Refused(HasSubstr("expected 1 for primitive: octant, done again")));
    EXPECT_THAT(redone(bresenham, R"(0,/"move":"E"/s/"move":"E"/"move":"W"/)"),
                Refused(HasSubstr("expected E for decide: move, done again")));
    EXPECT_THAT(redone("scene.json --fill two-halves", R"(s/"half":"lower","from_y":-/&1/)"),
                Refused(HasSubstr(" for half: from_y, done again")));
    // The end record names the picture.
    EXPECT_THAT(redone("scene.json",
                       R"(s/{"step":"pixel","x":0,"y":2}/{"step":"pixel","x":0,"y":6}/;)"
                       R"(s/,"pixels":[0-9]*,"frame":"[0-9a-f]*"//)"),
                Refused(HasSubstr("expected 2 for pixel: y, done again")));
}

TEST_F(ValidateTest, SaysThatNothingWasDoneAgain) {
    write("pixels.jsonl", R"({"rastertrace":1,"canvas":{"width":4,"height":4,"origin":"top-left"}}
{"step":"pixel","x":1,"y":2}
{"end":{"steps":1}}
)");
    const std::string nothing =
        "nothing was compared: expected numbers that can be done again, found none\n";
    EXPECT_THAT(run("validate --redo pixels.jsonl"),
                Refused(HasSubstr("rastertrace: pixels.jsonl: --redo: " + nothing)));
    EXPECT_THAT(run("stats pixels.jsonl --fail-on redo"), Ends(2, _, HasSubstr(nothing)));
}

TEST_F(ValidateTest, SaysWhatOfATraceCanBeJudged) {
    for (const std::string trace : {"trace.jsonl", "trace.json"})
        EXPECT_THAT(
            changed(R"(s/"at":.*\]\],//)", trace),
            Ends(0, "bad.json: a trace of version 1, 62 steps, complete; stats can judge rows\n",
                 "rastertrace: bad.json: remark: stats cannot judge holes, twice, "
                 "outside: expected \"at\", three pairs of numbers, of triangle ABC (step 1), "
                 "found none\n"));
}

TEST_F(ValidateTest, OneFileThatIsNotValidDoesNotStopTheOthers) {
    write("empty.json", " \n");
    write("list.json", "[1, 2]");
    write("other.json", R"({"name": "x"})");
    const Outcome all =
        run("validate . empty.json list.json other.json lost.json scene.json scene.json");
    EXPECT_EQ(all.status, 2);
    EXPECT_EQ(all.out, "scene.json: a scene, 1 triangle, 17 x 14 pixels\n"
                       "scene.json: a scene, 1 triangle, 17 x 14 pixels\n");
    const std::string hint = "hint: a scene has \"vertices\" or \"meshes\", a trace begins with "
                             "\"rastertrace\", claims are lines or have \"claims\"\n";
    EXPECT_EQ(all.err,
              "rastertrace: .: expected a file, found a folder\n"
              "rastertrace: empty.json: expected a scene, a trace or claims, found an empty file\n"
              "rastertrace: list.json: expected a scene, a trace or claims, found none of them\n" +
                  hint +
                  "rastertrace: other.json: expected a scene, a trace or claims, found none of "
                  "them\n" +
                  hint +
                  "rastertrace: lost.json: expected a file that can be read, found: No such file "
                  "or directory\n");
}

TEST_F(ValidateTest, ASceneIsValidIfEveryFrameCanBeDrawn) {
    write("turn.json", R"({"canvas":{"width":9,"height":9},"vertices":{"A":[0,0],"B":[3,0]},
 "lines":["AB"],"vary":{"/canvas/width":[9,8,0]}})");
    EXPECT_THAT(run("validate turn.json"),
                Ends(2, "",
                     "rastertrace: turn.json:1:20: expected a whole number of pixels from 1 to "
                     "16384, found 0, in frame 3 of 3: width 0\n"
                     "{\"canvas\":{\"width\":9,\"height\":9},\"vertices\":{\"A\":[0,0],\"B\":...\n"
                     "                   ^\n"));
}

TEST_F(ValidateTest, ATraceIsReadToItsEnd) {
    for (const char* const trace : {"trace.json", "trace.jsonl"}) {
        EXPECT_THAT(
            shell("head -20 " + std::string(trace) + " > cut.json; $rastertrace validate cut.json"),
            Refused("rastertrace: cut.json:21:1: expected the rest of the trace, found the end of "
                    "the file: the trace is truncated after 19 whole steps\n"));
        // The picture is drawn, and each count compared.
        EXPECT_THAT(changed("$s/\"pixels\":49/\"pixels\":48/", trace).err,
                    HasSubstr("expected 48 pixels as the end record says, found 49\n"));
        EXPECT_THAT(changed("$s/96f1/96f2/", trace).err,
                    HasSubstr("expected the picture 96f2b027ae1e2a78 as the end record "
                              "says, found 96f1b027ae1e2a78\n"));
        EXPECT_THAT(changed("$s/\"edge\":3/\"edge\":4/", trace).err,
                    HasSubstr("expected 4 edge steps as the end record says, found 3\n"));
    }
}

TEST_F(ValidateTest, FieldsThatReadersPassOverAreTold) {
    EXPECT_EQ(changed("4s/null/[]/").err,
              "rastertrace: bad.json:4:36: expected a number, an exact one like \"25/8\", or null "
              "for dx_dy, found []\n"
              "{\"step\":\"edge\",\"edge\":\"BC\",\"dx_dy\":[]}\n"
              "                                   ^\n");
    EXPECT_EQ(changed("2s/\\[\"A\"/[7/", "trace.json").err,
              "rastertrace: bad.json:2:63: expected an array of strings for vertices, found "
              "[7,\"B\",\"C\"]\n"
              "...step\":\"primitive\",\"kind\":\"triangle\",\"name\":\"ABC\",\"vertices\":[7,"
              "\"B\",\"C\"],"
              "\"at\":[[\"2\",\"5\"],[\"-4\",\"-3\"],...\n"
              "                                                               ^\n");
    // In the header, in the end record, and in the order of their lines.
    const Outcome both = changed("1s/\"stages\"/\"title\":7,\"stages\"/;3s/\"3.4\"/true/;"
                                 "$s/\"frame\":\"[^\"]*\"/\"frame\":5/");
    EXPECT_EQ(both.status, 2);
    const std::size_t title = both.err.find(":1:");
    const std::size_t edge = both.err.find(":3:36: expected a number, an exact one");
    const std::size_t frame = both.err.find(":64:");
    EXPECT_THAT(both.err, HasSubstr("expected a string for title, found 7\n"));
    EXPECT_THAT(both.err, HasSubstr("expected a string for frame, found 5\n"));
    EXPECT_TRUE(title < edge && edge < frame && frame != std::string::npos) << both.err;
}

TEST_F(ValidateTest, StepsThatCannotBeUsedDoNotHideTheRest) {
    for (const char* const trace : {"trace.json", "trace.jsonl"})
        EXPECT_THAT(
            changed("3s/\"edge\":\"AB\",//;4s/\"step\":\"edge\"/\"step\":5/;6s/\"y\":5/\"y\":0.5/;"
                    "8s/\"left_edge\":\"AB\"/\"left_edge\":1/",
                    trace),
            Refused(AllOf(
                HasSubstr("bad.json:3:1: expected a edge step with the key \"edge\", found none\n"),
                HasSubstr("bad.json:4:1: expected"),
                HasSubstr("bad.json:6:24: expected a whole number, found 0.5\n"),
                HasSubstr("expected a string for left_edge, found 1\n"),
                Not(HasSubstr("as the end record says")), Not(HasSubstr("remark")))));
}

TEST_F(ValidateTest, WhatComesBeforeTheEndOfTheReadingIsToldToo) {
    EXPECT_THAT(changed("3s/\"edge\":\"AB\",//;$s/}$//;$a more"),
                Refused(AllOf(HasSubstr("bad.json:3:1: expected a edge step with the key"),
                              HasSubstr("bad.json:64:"))));
}

TEST_F(ValidateTest, ATextOfAnyKindIsTakenForClaims) {
    write("letter.txt", "Dear reader,\n");
    EXPECT_THAT(run("validate letter.txt").err,
                StartsWith("rastertrace: letter.txt:1:6: taken for claims, since it is no JSON: "
                           "expected a space ("));
    write("claims.txt", "scene: scene.json\nDear reader\n");
    EXPECT_THAT(run("validate claims.txt").err,
                StartsWith("rastertrace: claims.txt:2:6: expected a space ("));
}

TEST_F(ValidateTest, APlaceFarBehindTheFirstBlockIsTold) {
    // More than a block of a stream, with a fault in the last step.
    std::string lines;
    for (int i = 0; i < 40'000; ++i)
        lines += R"({"step":"edge","edge":"AB","dx_dy":1})"
                 "\n";
    write("rest.jsonl", lines + R"({"step":"edge","edge":"AB","dx_dy":{}})"
                                "\n{\"end\":{}}\n");
    EXPECT_THAT(shell("head -1 trace.jsonl | cat - rest.jsonl > long.jsonl; $rastertrace validate "
                      "long.jsonl"),
                Refused(StartsWith("rastertrace: long.jsonl:40002:36: expected")));
}

TEST_F(ValidateTest, WhatAForeignRasterizerAddsIsARemark) {
    EXPECT_THAT(changed("6s/\"step\":\"scanline\"/\"step\":\"wobble\"/;3s/\"AB\"/"
                        "\"AB\",\"slope\":3/;$s/\"scanline\":9/\"scanline\":8/"),
                Ends(0,
                     "bad.json: a trace of version 1, 62 steps, complete; stats can judge holes, "
                     "twice, outside, rows\n",
                     "rastertrace: bad.json: remark: kinds of step that this program does not "
                     "know: wobble (1)\n"
                     "rastertrace: bad.json: remark: fields that steps of these kinds do not have: "
                     "edge.slope (1)\n"));
}

TEST_F(ValidateTest, AColorIsOneThatCanBeDrawn) {
    // Each digit of #rgb counts twice: it is the red of #ff0000.
    EXPECT_THAT(changed("2s/#000000/#f00/;$s/\"frame\":\"[^\"]*\"/\"title\":\"\"/"),
                Ends(0, _, ""));
    const std::string view = "explain bad.json --pixel 3,2 --json";
    EXPECT_THAT(run(view).out, HasSubstr("\"after\":\"ABC #ff0000\""));

    for (const char* const color : {"\"blurple\"", "\"#12\"", "\"#ff00f\"", "\"\"", "7", "null"}) {
        const std::string message =
            std::string("rastertrace: bad.json:2:125: expected a color like \"#ff8000\", found ") +
            color + "\n";
        EXPECT_THAT(changed("2s/\"#000000\"/" + std::string(color) + "/"),
                    Refused(StartsWith(message)));
        for (const char* const reader :
             {"show bad.json", "figure bad.json -o x.svg", "explain bad.json --pixel 3,2",
              "stats bad.json", "play bad.json --print 80x24", "diff trace.jsonl bad.json"})
            EXPECT_THAT(run(reader), Refused(HasSubstr("expected a color like"))) << reader;
    }
    EXPECT_THAT(changed("7s/\"y\":5/\"y\":5,\"color\":\"blurple\"/").err,
                HasSubstr("bad.json:7:37: expected a color"));
    EXPECT_THAT(changed("2s/\"color\"/\"colors\":[\"red\",\"#12\",\"#fff\"],\"color\"/").err,
                HasSubstr("expected an array of colors like \"#ff8000\", found [\"red\","));
}

TEST_F(ValidateTest, ANumberThatIsNotFiniteIsARemark) {
    const Outcome told = changed("8s/\"left\":\"[^\"]*\"/\"left\":\"NaN\"/;3s/3.4/-inf/;"
                                 "11s/\"right\":\"[^\"]*\"/\"right\":\"inf\"/");
    EXPECT_EQ(told.out,
              "bad.json: a trace of version 1, 62 steps, complete; stats can judge holes, "
              "twice, outside, rows\n");
    EXPECT_EQ(told.err,
              "rastertrace: bad.json:3:36: remark: expected a finite number for dx_dy, found "
              "\"-inf\"; 2 more steps have such a number\n"
              "{\"step\":\"edge\",\"edge\":\"AB\",\"dx_dy\":\"-inf\"}\n"
              "                                   ^\n"
              "hint: it is told as it stands; formulas, figures and counts leave it out\n");
    EXPECT_EQ(told.status, 0);
    for (const char* const reader :
         {"show bad.json", "figure bad.json -o x.svg", "explain bad.json --pixel 3,2",
          "explain bad.json --edge AB", "stats bad.json", "play bad.json --print 80x24",
          "check bad.json claims.txt"})
        EXPECT_THAT(run(reader).err, HasSubstr(told.err)) << reader;
    EXPECT_THAT(run("show bad.json --step \"edge dx_dy=-inf\"").out,
                HasSubstr("\nedge AB: dx/dy = (-4 - 2) / (-3 - 5) = -inf"));
    EXPECT_THAT(run("explain bad.json --pixel -3,4").out, HasSubstr("at x = NaN -> floor -> "));
    // JSON has no such number, and names may be called so.
    EXPECT_EQ(changed("8s/\"left\":\"[^\"]*\"/\"left\":NaN/").status, 2);
    EXPECT_EQ(changed("8s/\"left\":\"[^\"]*\"/\"left\":\"nan\"/").status, 2);
    EXPECT_EQ(changed("2s/\"name\":\"ABC\"/\"name\":\"NaN\"/").err, "");
}

TEST_F(ValidateTest, ClaimsAreAboutWhatTheirSceneHas) {
    write("lost.txt", "scene: nowhere.json\ny=2: 1, 2\n");
    write("names.txt", "scene: scene.json\nedge AQ: 3/4\n");
    write("rows.txt", "scene: scene.json\ny=99: 1, 2\n");
    EXPECT_EQ(run("validate lost.txt").err,
              "rastertrace: lost.txt:1:8: expected a file that can be read, found: No such file or "
              "directory (nowhere.json)\nscene: nowhere.json\n       ^\n");
    EXPECT_THAT(run("validate names.txt"),
                Refused(StartsWith("rastertrace: names.txt:2:6: expected ")));
    // A row that is not there is a wrong claim, and no fault of the file.
    EXPECT_THAT(run("validate rows.txt"), Ends(0, "rows.txt: 1 claim about scene.json\n",
                                               StartsWith("rastertrace: rows.txt:2:1: remark: ")));
}

TEST_F(ValidateTest, TheKindMayBeAskedFor) {
    EXPECT_EQ(run("validate --kind trace trace.json scene.json").err,
              "rastertrace: scene.json: expected a trace, found a scene\n");
    EXPECT_EQ(run("validate --kind scene trace.jsonl").err,
              "rastertrace: trace.jsonl: expected a scene, found a trace\n");
    EXPECT_EQ(run("validate --kind claims scene.json").err,
              "rastertrace: scene.json: expected claims, found a scene\n");
    EXPECT_THAT(run("validate --kind scene claims.txt").err,
                StartsWith("rastertrace: claims.txt:1:1: expected a JSON value"));
}

TEST_F(ValidateTest, ReadsStandardInputOnce) {
    EXPECT_EQ(run("validate - < scene.json").out,
              "standard input: a scene, 1 triangle, 17 x 14 pixels\n");
    EXPECT_EQ(shell("cat trace.jsonl | $rastertrace validate -").out,
              "standard input: a trace of version 1, 62 steps, complete; stats can judge holes, "
              "twice, outside, rows\n");
    EXPECT_EQ(run("validate - -").err,
              "rastertrace: validate: expected standard input once, found \"-\"\n");
}

TEST_F(ValidateTest, TellsInJson) {
    write("bad.json", R"({"vertices": {"A": [2, "five"]}, "points": ["A"]})");
    EXPECT_THAT(
        run("validate scene.json bad.json --json"),
        Ends(
            2,
            "[\n"
            R"({"file":"scene.json","kind":"scene","valid":true,"about":"a scene, 1 triangle, 17 x 14 pixels","problems":[],"all_told":true,"remarks":[]},)"
            "\n"
            R"({"file":"bad.json","kind":"scene","valid":false,"about":"","problems":[{"file":"bad.json","line":1,"column":24,"message":"expected a number, found \"five\"","hint":"a fraction is written \"25/8\", in quotes"}],"all_told":true,"remarks":[]})"
            "\n]\n",
            ""));
}

TEST_F(ValidateTest, ManyProblemsAreCounted) {
    std::string lines;
    for (int i = 0; i < 150; ++i)
        lines += R"({"step":"edge","edge":"AB","dx_dy":true})"
                 "\n";
    write("rest.jsonl", lines + "{\"end\":{}}\n");
    EXPECT_THAT(
        shell(
            "head -1 trace.jsonl | cat - rest.jsonl > bad.jsonl; $rastertrace validate bad.jsonl"),
        Refused(HasSubstr("rastertrace: bad.jsonl: only the first 100 problems are told\n")));
}

TEST_F(ValidateTest, PrintsSchemas) {
    for (const std::string name : {"scene", "trace", "claims"}) {
        const Outcome printed = run("validate --schema " + name);
        EXPECT_EQ(printed.status, 0);
        EXPECT_EQ(nlohmann::json::parse(printed.out)["$schema"],
                  "http://json-schema.org/draft-07/schema#");
    }
    EXPECT_EQ(run("validate --schema scenes").err,
              "rastertrace: --schema: expected one of scene, trace, claims, found \"scenes\"\n"
              "hint: did you mean scene?\n");
    EXPECT_EQ(run("validate --schema scene scene.json").status, 2);
    EXPECT_EQ(run("validate").err, "rastertrace: validate: expected a file, found none\n"
                                   "hint: - is standard input; --schema NAME prints a schema\n");
}

} // namespace
} // namespace rastertrace
