// SPDX-License-Identifier: MIT
// `rastertrace trace` as a user calls it: the same bytes everywhere, and traces that are cut down.

#include "program.h"

#include <string>

namespace rastertrace {
namespace {

TEST_F(ProgramTest, TraceOfASceneIsReadBackTheSame) {
    EXPECT_EQ(run("trace $examples/t0-fill/first-triangle.json -o t.json").status, 0);
    EXPECT_EQ(run("trace $examples/t0-fill/first-triangle.json -o t.jsonl").status, 0);
    EXPECT_EQ(run("trace - <$examples/t0-fill/first-triangle.json >piped.json").status, 0);
    EXPECT_EQ(content("piped.json"), content("t.json"));
    EXPECT_EQ(visible_files(), 3u);
    const std::string stats = run("stats t.json").out;
    EXPECT_EQ(run("stats - <t.jsonl").out, stats);
    EXPECT_EQ(run("stats $examples/t0-fill/first-triangle.json").out, stats);
    EXPECT_THAT(stats, HasSubstr("steps       62\n"));
    EXPECT_THAT(stats, HasSubstr("pixels      49 of 238 on the canvas\n"));
    EXPECT_THAT(
        run("stats --json t.json").out,
        StartsWith(R"({"title":"First triangle","steps":62,"count":{"primitive":1,"edge":3,)"));
}

TEST_F(ProgramTest, ATraceIsCutDownAsIfItWereDrawnSo) {
    run("trace $examples/t0-hidden/cube-culled.json -o whole.json; $rastertrace trace whole.json "
        "-o whole.jsonl");
    EXPECT_EQ(content("whole.jsonl"),
              run("trace $examples/t0-hidden/cube-culled.json --format jsonl").out);
    for (const std::string options :
         {"--only face,vertex --format jsonl", "--only face,vertex", "--only light", ""}) {
        const std::string drawn = run("trace $examples/t0-hidden/cube-culled.json " + options).out;
        EXPECT_THAT(drawn, HasSubstr("\"end\"")) << options;
        EXPECT_EQ(run("trace whole.json " + options).out, drawn) << options;
        EXPECT_EQ(run("trace whole.jsonl " + options).out, drawn) << options;
        EXPECT_EQ(run("trace - <whole.jsonl " + options).out, drawn) << options;
    }
    // A part of a part, and what it does not have.
    run("trace whole.json --only face,vertex -o part.json");
    EXPECT_EQ(run("trace part.json --only face").out, run("trace whole.json --only face").out);
    EXPECT_EQ(refusal("trace part.json --only pixel"),
              "rastertrace: pixel steps were left out of the trace\n");
    EXPECT_EQ(refusal("trace whole.json --region 0,0,1,1"),
              "rastertrace: whole.json: expected a scene for --region, found a trace\n"
              "hint: of a trace, --only writes the steps of some kinds\n");
    EXPECT_EQ(refusal("trace whole.json --primitive ABC --only face"),
              "rastertrace: whole.json: expected a scene for --primitive, found a trace\n"
              "hint: of a trace, --only writes the steps of some kinds\n");
    EXPECT_EQ(refusal("trace whole.json --fill fan"),
              "rastertrace: whole.json: expected a scene to draw with --fill fan, found a trace, "
              "which is drawn already\n");
    // What a terminal would obey is escaped, wherever it stands; what is above ASCII otherwise stays.
    write("foreign.jsonl",
          "{\"rastertrace\":1,\"title\":\"\\u202e\",\"canvas\":{\"width\":3,\"height\":3}}\n"
          "{\"step\":\"\\u009b\\u007f\\u202e\\u00e9\"}\n{\"step\":\"\xC2\x9B\"}\n{\"end\":{}}\n");
    EXPECT_EQ(
        run("trace foreign.jsonl --format jsonl").out,
        "{\"rastertrace\":1,\"title\":\"\\u202e\",\"canvas\":{\"width\":3,\"height\":3}}\n"
        "{\"step\":\"\\u009b\\u007f\\u202e\\u00e9\"}\n"
        "{\"step\":\"\\u009b\"}\n"
        "{\"end\":{\"steps\":2,\"count\":{\"\\u009b\":1,\"\\u009b\\u007f\\u202e\xC3\xA9\":1}}}\n");
    // Neither a trace that breaks off nor itself is written.
    shell("head -n 20 whole.jsonl >cut.jsonl; cp whole.json older.json");
    EXPECT_THAT(refusal("trace cut.jsonl --only vertex -o older.json"), HasSubstr("truncated"));
    EXPECT_THAT(refusal("trace whole.json --only face -o whole.json"), HasSubstr("whole.json"));
    EXPECT_EQ(shell("cmp whole.json older.json").status, 0);
}

TEST_F(ProgramTest, SameSceneSameBytesInEveryLocaleAndTimeZone) {
    run("trace $examples/t0-fill/first-triangle.json --scalar double -o a.json");
    shell("LC_ALL=de_DE.UTF-8 TZ=Asia/Tokyo $rastertrace trace "
          "$examples/t0-fill/first-triangle.json --scalar double -o b.json");
    EXPECT_FALSE(content("a.json").empty());
    EXPECT_EQ(content("a.json"), content("b.json"));
}

TEST_F(ProgramTest, AFileNameIsShownAndNotStored) {
    const std::string scene = R"({"vertices":{"A":[0,0]},"points":["A"]})";
    write("one.json", scene);
    write("other.json", scene);
    const std::string trace = run("trace one.json").out;
    EXPECT_THAT(trace, StartsWith(R"({"rastertrace":1,"canvas":{)"));
    EXPECT_EQ(run("trace other.json").out, trace);
    EXPECT_EQ(run("trace - <one.json").out, trace);
    run("trace one.json -o kept.trace.json");
    for (const std::string command : {"show", "stats", "plan", "stress"})
        EXPECT_THAT(run(command + " ./one.json").out, StartsWith("one.json")) << command;
    EXPECT_THAT(run("show kept.trace.json").out, StartsWith("kept.trace.json\n"));
    EXPECT_THAT(run("show - <one.json").out, StartsWith("standard input\n"));
}

TEST_F(ProgramTest, MethodIsOverriddenOnTheCommandLine) {
    EXPECT_THAT(run("stats $examples/t0-fill/first-triangle.json --rounding truncate").out,
                HasSubstr("pixels      45 of 238"));
    EXPECT_THAT(run("trace $examples/t0-fill/first-triangle.json -o t.json; $rastertrace show "
                    "t.json --rounding truncate"),
                Refused("rastertrace: t.json: expected a scene to draw with --rounding truncate, "
                        "found a trace, which is drawn already\n"));
    EXPECT_EQ(run("show x --rounding trunkate").err,
              "rastertrace: --rounding: expected one of floor, nearest, truncate, inside, "
              "half-open, found \"trunkate\"\nhint: did you mean truncate?\n");
}

TEST_F(ProgramTest, AMethodMayStandInAFile) {
    const std::string scene = "$examples/t0-fill/first-triangle.json ";
    write("ours.json", "{\"fill\": \"top-left\",\n \"sample\": [\"1/4\", 0]}");
    EXPECT_EQ(run("trace " + scene + "--method ours.json").out,
              run("trace " + scene + "--fill top-left --sample '1/4 0'").out);
    // What is asked for beside it counts more; a scene says less.
    write("scalar.json", R"({"scalar": "double", "convention": "direct3d"})");
    EXPECT_EQ(run("trace " + scene + "--method scalar.json --convention opengl").out,
              run("trace " + scene + "--scalar double --convention opengl").out);

    const auto refusal_of = [&](const std::string& text) {
        write("wrong.json", text);
        return refusal("show " + scene + "--method wrong.json");
    };
    EXPECT_THAT(refusal_of("{\"fill\": \"top-left\",\n \"sample\": \"centre\"}"),
                AllOf(StartsWith("rastertrace: wrong.json:2:12: expected one of integer, center, "),
                      HasSubstr("^\nhint: did you mean \"center\"?\n")));
    EXPECT_THAT(refusal_of(R"({"fil": "top-left"})"), HasSubstr("did you mean \"fill\"?"));
    EXPECT_THAT(refusal_of("[]"),
                StartsWith("rastertrace: wrong.json:1:1: expected an object with the keys "));
    EXPECT_THAT(refusal_of("{"), StartsWith("rastertrace: wrong.json:1:"));
    EXPECT_THAT(run("show " + scene + "--method none.json").err,
                StartsWith("rastertrace: none.json: "));
}

TEST_F(ProgramTest, RegionMayBeginWithANegativeNumber) {
    EXPECT_THAT(
        run("trace $examples/t0-fill/first-triangle.json --region -4,-3,-3,-3 --only pixel"),
        Prints(HasSubstr("\"count\":{\"pixel\":2}")));
}

} // namespace
} // namespace rastertrace
