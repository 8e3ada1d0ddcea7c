// SPDX-License-Identifier: MIT
// Pages as their author renews and checks them.

#include "program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace rastertrace {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class RenewTest : public ProgramTest {
protected:
    RenewTest() {
        write("scene.json", R"({"title": "Dots", "canvas": {"width": 3, "height": 2},
                                "vertices": {"A": [0, 0]}, "points": ["A"]})");
        write("bad.json", R"({"vertices": 1})");
    }
};

const std::string stale = "# Dots\n"
                          "```console\n"
                          "$ rastertrace show scene.json --bare\n"
                          "..#\n"
                          "\n"
                          "$ rastertrace show bad.json   # exit 2\n"
                          "```\n";
const std::string fresh =
    "# Dots\n"
    "```console\n"
    "$ rastertrace show scene.json --bare\n"
    "...\n"
    ".#.\n"
    "\n"
    "$ rastertrace show bad.json   # exit 2\n"
    "rastertrace: bad.json:1:14: expected vertices by name, like {\"A\": [2, 5]}, found 1\n"
    "{\"vertices\": 1}\n"
    "             ^\n"
    "```\n";

TEST_F(RenewTest, OutputsArePutOnThePage) {
    write("page.md", stale);
    const Outcome first = shell("$rastertrace renew page.md");
    EXPECT_EQ(first.status, 0) << first.err;
    EXPECT_EQ(first.out, "page.md: 2 commands, 2 renewed\n");
    EXPECT_EQ(content("page.md"), fresh);
    EXPECT_EQ(visible_files(), 3u);

    const Outcome second = shell("$rastertrace renew page.md");
    EXPECT_EQ(second.out, "page.md: 2 commands, 0 renewed\n");
    EXPECT_EQ(content("page.md"), fresh);
    const Outcome check = shell("$rastertrace renew --check page.md");
    EXPECT_EQ(check.status, 0);
    EXPECT_EQ(check.out + check.err, "");
}

TEST_F(RenewTest, CheckTellsTheFirstLineThatDiffers) {
    write("page.md", stale);
    write("fresh.md", fresh);
    const Outcome check = shell("$rastertrace renew --check page.md fresh.md");
    EXPECT_EQ(check.status, 1);
    EXPECT_EQ(check.out, "page.md:4:3: expected \"...\", found \"..#\"\n"
                         "..#\n"
                         "  ^\n"
                         "hint: line 3 is rastertrace show scene.json --bare\n"
                         "page.md:7:1: expected \"rastertrace: bad.json:1:14: expected vertices by "
                         "name, like {\"A\": [2, 5]}, found 1\", found the end of the output\n"
                         "```\n"
                         "^\n"
                         "hint: line 6 is rastertrace show bad.json   # exit 2\n"
                         "to renew: rastertrace renew page.md\n");
    EXPECT_EQ(check.err, "");
    EXPECT_EQ(content("page.md"), stale);
}

TEST_F(RenewTest, CheckTellsWhichFilesAreStaleAndWritesNone) {
    write("page.md", "# Dots\n"
                     "```console\n"
                     "$ rastertrace figure scene.json -o dots.svg\n"
                     "```\n");
    EXPECT_EQ(shell("$rastertrace renew page.md").status, 0);
    const std::string figure = content("dots.svg");
    EXPECT_THAT(figure, StartsWith("<svg"));
    EXPECT_EQ(shell("$rastertrace renew --check page.md").status, 0);

    write("dots.svg", "old");
    const Outcome old = shell("$rastertrace renew --check page.md");
    EXPECT_EQ(old.status, 1);
    EXPECT_EQ(old.out, "page.md:3:1: expected dots.svg as this command writes it, found another "
                       "file, or none\n"
                       "$ rastertrace figure scene.json -o dots....\n"
                       "^\n"
                       "to renew: rastertrace renew page.md\n");
    EXPECT_EQ(content("dots.svg"), "old");

    shell("rm dots.svg");
    EXPECT_EQ(shell("$rastertrace renew --check page.md").status, 1);
    EXPECT_EQ(shell("ls dots.svg").status, 2) << "there still is none";
    EXPECT_EQ(shell("$rastertrace renew page.md").status, 0);
    EXPECT_EQ(content("dots.svg"), figure);
}

TEST_F(RenewTest, EachFileOfASequenceIsChecked) {
    write("page.md", "```console\n"
                     "$ rastertrace trace scene.json --vary /vertices/A/0=0:1:2 -o dots.json\n"
                     "```\n");
    EXPECT_EQ(shell("$rastertrace renew page.md").status, 0);
    EXPECT_EQ(shell("$rastertrace renew --check page.md").status, 0);
    write("dots-2.json", "old");
    EXPECT_THAT(shell("$rastertrace renew --check page.md").out,
                HasSubstr("expected dots-2.json as"));
}

TEST_F(RenewTest, CheckTellsFilesThatAreNoLongerWritten) {
    const auto page_with = [this](const std::string& options) {
        write("page.md", "```console\n$ rastertrace trace scene.json " + options + "\n```\n");
        EXPECT_EQ(shell("$rastertrace renew page.md").status, 0);
    };
    const auto checked = [this] { return shell("$rastertrace renew --check page.md"); };
    const auto told = [](const std::string& file) {
        return "page.md:2:1: expected no " + file +
               ", which this command no longer writes, found it\n"
               "$ rastertrace trace scene.json --vary /v...\n"
               "^\n"
               "hint: renew leaves it; remove it if nothing else needs it\n";
    };
    // From one file to ten, from ten to eight.
    page_with("-o dots.json");
    page_with("--vary /vertices/A/0=0:1:10 -o dots.json");
    EXPECT_EQ(checked().out, told("dots.json"));
    EXPECT_EQ(checked().status, 1);
    shell("rm dots.json");
    EXPECT_EQ(checked().out, "");
    EXPECT_EQ(checked().status, 0);
    page_with("--vary /vertices/A/0=0:1:8 -o dots.json");
    std::string all;
    for (const std::string number : {"01", "02", "03", "04", "05", "06", "07", "08", "09", "10"})
        all += told("dots-" + number + ".json");
    EXPECT_EQ(checked().out, all);
    shell("rm dots-0*.json dots-10.json");
    EXPECT_EQ(checked().status, 0);
    // From eight to six; and what is no whole sequence is something else.
    page_with("--vary /vertices/A/0=0:1:6 -o dots.json");
    write("dots-12.json", "mine");
    EXPECT_EQ(checked().out, told("dots-7.json") + told("dots-8.json"));
    EXPECT_EQ(content("dots-12.json"), "mine");
    shell("rm dots-7.json dots-8.json");
    EXPECT_EQ(checked().status, 0);
    // Another command may write them, and the scene is no output.
    write("page.md", "```console\n"
                     "$ rastertrace trace scene.json -o dots.json\n"
                     "$ rastertrace trace scene.json --vary /vertices/A/0=0:1:6 -o ./dots.json\n"
                     "$ rastertrace trace scene.json --vary /vertices/A/0=0:1:2 -o scene.json\n"
                     "```\n");
    EXPECT_EQ(shell("$rastertrace renew page.md").status, 0);
    EXPECT_EQ(checked().out, "");
    EXPECT_EQ(checked().status, 0);
}

TEST_F(RenewTest, ACommandThatFailsIsAProblem) {
    write("page.md", "```\n$ rastertrace show bad.json\nold\n```\n");
    const Outcome failed = shell("$rastertrace renew page.md");
    EXPECT_EQ(failed.status, 2);
    EXPECT_EQ(failed.err, "rastertrace: page.md:2:1: expected a command that succeeds, found exit "
                          "status 2\n"
                          "$ rastertrace show bad.json\n"
                          "^\n"
                          "hint: it says: rastertrace: bad.json:1:14: expected vertices by name, "
                          "like {\"A\": [2, 5]}, found 1\n");
    EXPECT_EQ(content("page.md"), "```\n$ rastertrace show bad.json\nold\n```\n");
    write("page.md", "```\n$ rastertrace show scene.json # exit 1\n```\n");
    EXPECT_THAT(shell("$rastertrace renew page.md").err,
                HasSubstr("page.md:2:1: expected exit status 1, found success\n"));
    // The system's failure is no mistake of the page.
    write("page.md", "```\n$ rastertrace trace scene.json -o no-folder/t.json\n```\n");
    EXPECT_EQ(shell("$rastertrace renew page.md").status, 3);
}

TEST_F(RenewTest, APageWithAMistakeLeavesAllAsTheyWere) {
    write("page.md", stale);
    write("other.md", "```\n$ rastertrace show scene.json > out.txt\n```\n");
    const Outcome refused = shell("$rastertrace renew page.md other.md");
    EXPECT_EQ(refused.status, 2);
    EXPECT_EQ(refused.err, "rastertrace: other.md:2:31: expected a command that needs no shell, "
                           "found >\n"
                           "$ rastertrace show scene.json > out.txt\n"
                           "                              ^\n"
                           "hint: quote it if it is part of a word\n");
    EXPECT_EQ(content("page.md"), stale);
    EXPECT_EQ(visible_files(), 4u);
}

TEST_F(RenewTest, PagesAreFiles) {
    EXPECT_EQ(shell("$rastertrace renew no.md").err,
              "rastertrace: no.md: expected a file that can be read, found: No such file or "
              "directory\n");
    EXPECT_EQ(shell("$rastertrace renew no.md").status, 2);
    EXPECT_EQ(shell("$rastertrace renew -").err,
              "rastertrace: renew: expected the names of pages, found \"-\"\n");
    EXPECT_EQ(shell("$rastertrace renew /dev/zero").status, 2);
    write("page.md", "```\n$ rastertrace renew page.md\n```\n");
    EXPECT_EQ(shell("$rastertrace renew page.md").err,
              "rastertrace: page.md:2:1: expected a command that shows something, found renew\n"
              "$ rastertrace renew page.md\n"
              "^\n");
    write("text.md", stale);
    EXPECT_THAT(shell("$rastertrace renew text.md >>text.md").err,
                HasSubstr("expected another file than those that are read"));
    EXPECT_EQ(content("text.md"), stale);
}

TEST_F(RenewTest, LineEndsModesAndLinksSurvive) {
    write("real.md", "caf\xC3\xA9\r\n"
                     "~~~\r\n"
                     "$ rastertrace show 'scene.json' \"--bare\"\r\n"
                     "~~~");
    shell("chmod 640 real.md; ln -s real.md page.md");
    EXPECT_EQ(shell("$rastertrace renew page.md").status, 0);
    EXPECT_EQ(content("real.md"), "caf\xC3\xA9\r\n"
                                  "~~~\r\n"
                                  "$ rastertrace show 'scene.json' \"--bare\"\r\n"
                                  "...\r\n"
                                  ".#.\r\n"
                                  "~~~");
    EXPECT_EQ(shell("$rastertrace renew page.md").out, "page.md: 1 command, 0 renewed\n");
    EXPECT_TRUE(fs::is_symlink(folder_ / "page.md"));
    EXPECT_EQ(shell("stat -c %a real.md").out, "640\n");
}

// What the terminal is like is nothing that a page should depend on.
TEST_F(RenewTest, PagesAreTheSameOnEveryTerminal) {
    const std::string page = "```\n$ rastertrace show examples/t0-fill/first-triangle.json\n```\n";
    shell("ln -s $examples examples");
    write("wide.md", page);
    write("narrow.md", page);
    shell("COLUMNS=200 LINES=50 $rastertrace renew wide.md");
    shell("COLUMNS=30 LINES=8 $rastertrace renew narrow.md");
    EXPECT_EQ(content("wide.md"), content("narrow.md"));
    EXPECT_THAT(content("wide.md"), HasSubstr("\n -6   . . ."));
}

TEST_F(RenewTest, AnOutputHasAnEnd) {
    write("large.json", R"({"canvas": {"width": 600, "height": 600, "origin": "top-left"},
                            "vertices": {"A": [0, 0], "B": [599, 0], "C": [0, 599]},
                            "triangles": ["ABC"]})");
    write("page.md", "```\n$ rastertrace trace large.json\n```\n");
    const Outcome refused = shell("$rastertrace renew page.md");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, StartsWith("rastertrace: page.md:2:1: expected a command that prints "
                                        "at most 4 MB, found more\n"));
}

} // namespace
} // namespace rastertrace
