// SPDX-License-Identifier: MIT
// What the program came with, and how it was built.

#include "program.h"

#include <string>

namespace rastertrace {
namespace {

using ExamplesTest = ProgramTest;

TEST_F(ExamplesTest, AreListedWithTheirTitles) {
    EXPECT_THAT(run("examples").out,
                AllOf(HasSubstr("\nt0-fill/first-triangle.json                  First triangle\n"),
                      HasSubstr("\nclaims/t0-rows.claims                        T0, the triangle "),
                      HasSubstr("\nmodels/cube.obj\n")));
    EXPECT_EQ(run("examples | wc -l").out, shell("find $examples -type f | wc -l").out);
    EXPECT_THAT(run("examples First-Triangle").out,
                AllOf(HasSubstr("t0-fill/first-triangle.json"), Not(HasSubstr("models/"))));
    EXPECT_THAT(run("examples teapot"), Refused(HasSubstr("found \"teapot\"")));
}

TEST_F(ExamplesTest, AreCopiedWithoutLoss) {
    EXPECT_EQ(run("examples -o here/mine").status, 0);
    EXPECT_EQ(shell("diff -r here/mine $examples").out, "");
    const std::string count =
        std::to_string(std::stoul(shell("find $examples -type f | wc -l").out));
    write("here/mine/t0-fill/first-triangle.json", "my own");
    EXPECT_EQ(run("examples -o here/mine").out,
              "0 of " + count + " files copied to here/mine; the others are there already\n");
    EXPECT_EQ(content("here/mine/t0-fill/first-triangle.json"), "my own");
    EXPECT_EQ(run("examples cube -o more").status, 2);
    write("file", "");
    const Outcome refused = run("examples -o file");
    EXPECT_NE(refused.status, 0);
    EXPECT_THAT(refused.err, StartsWith("rastertrace: file"));
}

TEST_F(ExamplesTest, AreNamedWhereTheyAreMissing) {
    EXPECT_THAT(run("show examples/t0-fill/first-triangle.json").err,
                HasSubstr("hint: rastertrace examples -o examples copies the examples\n"));
    shell("mkdir examples");
    EXPECT_THAT(run("show examples/none.json").err, Not(HasSubstr("hint")));
}

TEST_F(ExamplesTest, TheVersionTellsHowTheProgramWasBuilt) {
    const std::string version = run("--version").out;
    EXPECT_THAT(version, MatchesRegex("rastertrace [0-9]+\\.[0-9]+\\.[0-9]+\n"));
    EXPECT_THAT(run("--version --verbose").out,
                AllOf(StartsWith(version), HasSubstr("-ffp-contract=off"), HasSubstr("GMP "),
                      HasSubstr("/examples\n")));
    EXPECT_EQ(run("--verbose").status, 2);
}

} // namespace
} // namespace rastertrace
