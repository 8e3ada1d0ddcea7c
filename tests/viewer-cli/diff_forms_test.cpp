// SPDX-License-Identifier: MIT
// `rastertrace diff` for pull requests, CI servers and terminals; the rules of a team; several accepted goldens.

#include "program.h"
#include "xml_fault.h"

#include <gmock/gmock.h>

#include <string>

namespace rastertrace {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class DiffFormsTest : public ProgramTest {
protected:
    DiffFormsTest() {
        shell("$rastertrace trace $examples/t0-fill/first-triangle.json -o a.golden.jsonl;"
              "$rastertrace trace $examples/t0-fill/first-triangle.json --rounding truncate -o "
              "b.jsonl");
    }
};

TEST_F(DiffFormsTest, MarkdownHasASummaryAndPicturesSideBySide) {
    const Outcome told =
        diff("a.golden.jsonl b.jsonl --ignore header --format markdown --pictures shown");
    EXPECT_EQ(told.status, 1);
    EXPECT_THAT(
        told.out,
        AllOf(
            StartsWith("### Decisions differ: 8 steps differ, 4 pixels differ\n"),
            HasSubstr(
                "| ![a](shown/a.png) | ![b](shown/b.png) | ![difference](shown/difference.png) |"),
            HasSubstr("<details><summary>All of it</summary>"), HasSubstr("floor -> -1")));
    for (const char* const name : {"a", "b", "difference"})
        EXPECT_THAT(content(std::string("shown/") + name + ".png"), StartsWith("\x89PNG"));
    EXPECT_NE(content("shown/a.png"), content("shown/b.png"));
    EXPECT_THAT(diff("a.golden.jsonl a.golden.jsonl --format markdown").out,
                StartsWith("### No difference"));
}

TEST_F(DiffFormsTest, JUnitHasOneCase) {
    const Outcome told = diff("a.golden.jsonl b.jsonl --ignore header --format junit");
    EXPECT_EQ(told.status, 1);
    EXPECT_EQ(xml_fault(told.out.substr(told.out.find('\n'))), "");
    EXPECT_THAT(told.out,
                AllOf(HasSubstr("tests=\"1\" failures=\"1\""),
                      HasSubstr("<failure message=\"8 steps differ, 4 pixels differ\">")));
    EXPECT_THAT(diff("a.golden.jsonl a.golden.jsonl --format junit").out,
                HasSubstr("failures=\"0\""));
}

TEST_F(DiffFormsTest, ColorsAreForTerminals) {
    EXPECT_THAT(diff("a.golden.jsonl b.jsonl").out, Not(HasSubstr("\x1b")));
    const std::string colored = diff("a.golden.jsonl b.jsonl --color always").out;
    EXPECT_THAT(colored, HasSubstr("\x1b["));
    write("colored.txt", colored);
    EXPECT_EQ(shell("sed 's/\\x1b\\[[0-9;]*m//g' colored.txt").out,
              diff("a.golden.jsonl b.jsonl").out);
}

TEST_F(DiffFormsTest, RulesStandBesideTheGolden) {
    EXPECT_EQ(diff("a.golden.jsonl b.jsonl").status, 1);
    write(
        "rastertrace-rules.json",
        R"({"ignore": ["header", "pixel"], "tolerance": ["scanline.from=1"], "key": {"tile": ["tx", "ty"]}})");
    const Outcome told = diff("a.golden.jsonl b.jsonl");
    EXPECT_EQ(told.status, 0) << told.out << told.err;
    shell("mkdir rules; mv rastertrace-rules.json rules/team.json");
    EXPECT_EQ(diff("a.golden.jsonl b.jsonl").status, 1);
    EXPECT_EQ(diff("a.golden.jsonl b.jsonl --rules rules/team.json").status, 0);

    write("rastertrace-rules.json", "{\"ignore\": [\"header\"],\n \"tolerance\": [\"scanline\"]}");
    const Outcome wrong = diff("a.golden.jsonl b.jsonl");
    EXPECT_EQ(wrong.status, 2);
    EXPECT_THAT(wrong.err, AllOf(HasSubstr("rastertrace-rules.json:2:16"), HasSubstr("^")));
    write("rastertrace-rules.json", R"({"ignored": []})");
    EXPECT_THAT(diff("a.golden.jsonl b.jsonl").err, HasSubstr("did you mean \"ignore\""));
    write("rastertrace-rules.json", R"({"convention": "opengll"})");
    EXPECT_THAT(diff("a.golden.jsonl b.jsonl").err, HasSubstr("opengl"));
}

TEST_F(DiffFormsTest, TheMethodOfTheRulesDrawsScenes) {
    write(
        "scene.json",
        R"({"canvas":{"width":9,"height":9,"origin":"top-left"},"vertices":{"A":[1,1],"B":[7,2],"C":[3,8]},"triangles":["ABC"]})");
    shell("$rastertrace trace scene.json --convention direct3d -o scene.golden.jsonl");
    EXPECT_EQ(diff("scene.golden.jsonl scene.json").status, 1);
    write("rastertrace-rules.json", R"({"convention": "direct3d"})");
    const Outcome told = diff("scene.golden.jsonl scene.json");
    EXPECT_EQ(told.status, 0) << told.out << told.err;
    EXPECT_EQ(diff("scene.golden.jsonl scene.json --convention cgfs").status, 1);

    // The same by a file that the rules name, from their own folder.
    shell("mkdir rules; mv rastertrace-rules.json rules");
    write("rules/rastertrace-rules.json", R"({"method": "ours.json"})");
    write("rules/ours.json", R"({"convention": "direct3d"})");
    EXPECT_EQ(diff("scene.golden.jsonl scene.json --rules rules/rastertrace-rules.json").status, 0);
    write("rules/ours.json", R"({"convention": "direct4d"})");
    EXPECT_THAT(diff("scene.golden.jsonl scene.json --rules rules/rastertrace-rules.json").err,
                HasSubstr("rules/ours.json:1:16: "));
}

TEST_F(DiffFormsTest, SeveralGoldensMayBeAccepted) {
    EXPECT_EQ(diff("a.golden.jsonl b.jsonl").status, 1);
    shell("cp b.jsonl a.gcc.golden.jsonl");
    const Outcome told = diff("a.golden.jsonl b.jsonl");
    EXPECT_EQ(told.status, 0);
    EXPECT_THAT(told.out, HasSubstr("a.gcc.golden.jsonl is accepted besides a.golden.jsonl\n"));
    // Neither one of another name, nor one that waits.
    shell("mv a.gcc.golden.jsonl ab.golden.jsonl; cp b.jsonl a.golden.new.jsonl");
    EXPECT_EQ(diff("a.golden.jsonl b.jsonl").status, 1);
}

} // namespace
} // namespace rastertrace
