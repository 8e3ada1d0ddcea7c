// SPDX-License-Identifier: MIT
// What all commands say to the words that they are given, and where; and their exit status.

#include "program.h"

#include <string>

namespace rastertrace {
namespace {

TEST_F(ProgramTest, CommandsThatNeedASceneSayThatATraceIsDrawnAlready) {
    ASSERT_EQ(run("trace $examples/t0-fill/first-triangle.json -o drawn.json").status, 0);
    for (const std::string command : {"plan", "report", "stress"})
        EXPECT_THAT(run(command + " drawn.json"),
                    Refused("rastertrace: drawn.json: expected a scene, found a trace\n"
                            "hint: a trace is drawn already; `show` and `stats` read it\n"))
            << command;
}

// A script whose variable is empty must not get the standard output, or the whole catalogue.
TEST_F(ProgramTest, AnEmptyWordIsRefused) {
    for (const std::string words :
         {"stress ''", "trace ''", "show ''", "stats ''", "plan ''", "report ''", "help ''",
          "trace $examples/t0-fill/first-triangle.json -o ''",
          "trace $examples/t0-fill/first-triangle.json --output=",
          "show $examples/t0-fill/first-triangle.json --every ''", "stress --case ''"})
        EXPECT_THAT(run(words), Ends(2, "", EndsWith(", found \"\"\n"))) << words;
    EXPECT_EQ(run("stress ''").err, "rastertrace: stress: expected a word behind it, found \"\"\n");
}

TEST_F(ProgramTest, TheExitStatusStandsWhereStandardErrorCannotBeWritten) {
    write("cut.json", run("trace $examples/t0-fill/first-triangle.json").out.substr(0, 2000));
    for (const std::string no_stderr : {" 2>&-", " 2>/dev/full"}) {
        EXPECT_EQ(run("show nothing.json" + no_stderr).status, 2);
        EXPECT_EQ(run("show cut.json" + no_stderr).status, 2);
        EXPECT_EQ(run("shw" + no_stderr).status, 2);
        EXPECT_EQ(run("show --evry" + no_stderr).status, 2);
        EXPECT_EQ(shell("$rastertrace" + no_stderr).status, 2);
        EXPECT_EQ(run("--version >/dev/full" + no_stderr).status, 3);
    }
    EXPECT_EQ(
        shell("mkfifo pipe; exec 3<>pipe 4>pipe; exec 3<&-; $rastertrace show nothing.json 2>&4")
            .status,
        2)
        << "a pipe that nobody reads";
    // No file gets the number of a closed descriptor, and so no message or picture.
    EXPECT_EQ(run("trace $examples/t0-fill/first-triangle.json -o t.json <&- >&- 2>&-").status, 0);
    EXPECT_EQ(content("t.json"), run("trace $examples/t0-fill/first-triangle.json").out);
}

TEST_F(ProgramTest, HelpThatCannotBeWrittenIsAFailure) {
    for (const std::string arguments :
         {"--help", "help", "help show", "show --help", "--version"}) {
        EXPECT_THAT(
            run(arguments + " >/dev/full"),
            Ends(3, _,
                 "rastertrace: standard output: could not be written: No space left on device\n"))
            << arguments;
        EXPECT_THAT(
            run(arguments + " >&-"),
            Ends(3, _, "rastertrace: standard output: could not be written: Bad file descriptor\n"))
            << arguments;
    }
}

TEST_F(ProgramTest, UsageErrorsNameTheWordAndANearOne) {
    EXPECT_THAT(shell("$rastertrace"), Refused(HasSubstr("rastertrace show examples/")));
    EXPECT_EQ(run("shw x").err, "rastertrace: expected a command out of trace, show, play, figure, "
                                "explain, stats, check, sheet, diff, diagnose, fuzz, stress, "
                                "report, validate, plan, examples, renew, help, found \"shw\"\n"
                                "hint: did you mean show?\n");
    EXPECT_THAT(run("show x --evry pixel"),
                Refused("rastertrace show: --evry: no such option\nhint: did you mean --every?\n"
                        "see rastertrace show --help\n"));
    EXPECT_EQ(run("show x --step scanline y=2").err,
              "rastertrace show: The following argument was not expected: y=2\n"
              "hint: a step of several words goes in quotes: \"scanline y=2\"\n"
              "see rastertrace show --help\n");
    EXPECT_EQ(run("trace x --only pixle").err,
              "rastertrace: --only: expected kinds of step out of "
              "triangulate,matrix,vertex,order,primitive,face,light,clip,edge,half,ray,crossings,"
              "scanline,along,decide,sample,depth,pixel,reject,skip,undecided, found \"pixle\"\n"
              "hint: did you mean pixel?\n");
    EXPECT_EQ(run("trace x --region 1,2,3").err, "rastertrace: --region: expected two corners as "
                                                 "x0,y0,x1,y1, like -4,-3,2,5, found \"1,2,3\"\n");
}

TEST_F(ProgramTest, NothingFromAFileReachesTheTerminalRaw) {
    write("evil.json", "{\"title\": \"a\\u001b]0;x\\u0007\\u009b\\u202e\\n\", \"vertices\": "
                       "{\"\\u001b[2J\": [1, 1]}, \"triangles\": [[\"\\u001b[2J\", \"\\u001b[2J\", "
                       "\"\\u001b[2J\"]]}");
    for (const std::string command : {"trace", "show --all", "stats", "stats --json"})
        EXPECT_THAT(run(command + " evil.json"),
                    Prints(AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("\a")),
                                 Not(HasSubstr("\xC2\x9B")), Not(HasSubstr("\xE2\x80\xAE")))))
            << command;
}

} // namespace
} // namespace rastertrace
