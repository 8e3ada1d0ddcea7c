// SPDX-License-Identifier: MIT
// Pages as their author renews and checks them.

#include "program.h"

#include <csignal>
#include <string>

namespace rastertrace {
namespace {

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
    EXPECT_THAT(run("renew page.md"), Prints("page.md: 2 commands, 2 renewed\n"));
    EXPECT_EQ(content("page.md"), fresh);
    EXPECT_EQ(visible_files(), 3u);

    EXPECT_EQ(run("renew page.md").out, "page.md: 2 commands, 0 renewed\n");
    EXPECT_EQ(content("page.md"), fresh);
    const Outcome check = run("renew --check page.md");
    EXPECT_EQ(check.status, 0);
    EXPECT_EQ(check.out + check.err, "");
}

TEST_F(RenewTest, CheckTellsTheFirstLineThatDiffers) {
    write("page.md", stale);
    write("fresh.md", fresh);
    EXPECT_THAT(run("renew --check page.md fresh.md"),
                Ends(1,
                     "page.md:4:3: expected \"...\", found \"..#\"\n"
                     "..#\n"
                     "  ^\n"
                     "hint: line 3 is rastertrace show scene.json --bare\n"
                     "page.md:7:1: expected \"rastertrace: bad.json:1:14: expected vertices by "
                     "name, like {\"A\": [2, 5]}, found 1\", found the end of the output\n"
                     "```\n"
                     "^\n"
                     "hint: line 6 is rastertrace show bad.json   # exit 2\n"
                     "to renew: rastertrace renew page.md\n",
                     ""));
    EXPECT_EQ(content("page.md"), stale);
}

TEST_F(RenewTest, CheckTellsWhichFilesAreStaleAndWritesNone) {
    write("page.md", "# Dots\n"
                     "```console\n"
                     "$ rastertrace figure scene.json -o dots.svg\n"
                     "```\n");
    EXPECT_EQ(run("renew page.md").status, 0);
    const std::string figure = content("dots.svg");
    EXPECT_THAT(figure, StartsWith("<svg"));
    EXPECT_EQ(run("renew --check page.md").status, 0);

    write("dots.svg", "old");
    EXPECT_THAT(run("renew --check page.md"),
                Ends(1, "page.md:3:1: expected dots.svg as this command writes it, found another "
                        "file, or none\n"
                        "$ rastertrace figure scene.json -o dots....\n"
                        "^\n"
                        "to renew: rastertrace renew page.md\n"));
    EXPECT_EQ(content("dots.svg"), "old");

    shell("rm dots.svg");
    EXPECT_EQ(run("renew --check page.md").status, 1);
    EXPECT_EQ(shell("ls dots.svg").status, 2) << "there still is none";
    EXPECT_EQ(run("renew page.md").status, 0);
    EXPECT_EQ(content("dots.svg"), figure);
}

TEST_F(RenewTest, EachFileOfASequenceIsChecked) {
    write("page.md", "```console\n"
                     "$ rastertrace trace scene.json --vary /vertices/A/0=0:1:2 -o dots.json\n"
                     "```\n");
    EXPECT_EQ(run("renew page.md").status, 0);
    EXPECT_EQ(run("renew --check page.md").status, 0);
    write("dots-2.json", "old");
    EXPECT_THAT(run("renew --check page.md").out, HasSubstr("expected dots-2.json as"));
}

TEST_F(RenewTest, CheckChangesNoFileThatACommandWritesBeforeItFails) {
    write("cut.json", run("trace $examples/t0-fill/first-triangle.json").out.substr(0, 2000));
    write("page.md", "```\n$ rastertrace figure cut.json -o figure.txt # exit 2\n```\n");
    ASSERT_EQ(run("renew page.md").status, 0);
    write("figure.txt", "old");
    EXPECT_THAT(run("renew --check page.md"),
                Ends(1, StartsWith("page.md:2:1: expected figure.txt as this command writes it, "
                                   "found another file, or none\n")));
    EXPECT_EQ(content("figure.txt"), "old");
}

// What a command of the page has made, another one may read and a third one make again.
TEST_F(RenewTest, AFileOfThePageIsMadeTwice) {
    write("page.md", "```\n$ rastertrace trace scene.json -o made.json\n"
                     "$ rastertrace show made.json --bare\n"
                     "$ rastertrace trace scene.json --scalar exact -o made.json\n```\n");
    EXPECT_THAT(run("renew page.md"), Prints("page.md: 3 commands, 1 renewed\n"));
    EXPECT_THAT(run("renew page.md"), Prints("page.md: 3 commands, 0 renewed\n"));
    EXPECT_EQ(run("renew --check page.md").status, 1) << "the first command writes another file";
}

TEST_F(RenewTest, ACommandMakesNoFolderOutsideAndNoneUnderCheck) {
    write("mine.sh", "exit 7\n");
    const auto page = [&](const std::string& folder) {
        write("page.md", "```\n$ rastertrace fuzz --runs 1 --shrink 0 -o " + folder +
                             " -- sh mine.sh '{scene}' # exit 1\n```\n");
    };
    page("found/deep");
    EXPECT_THAT(run("renew --check page.md"),
                Ends(1, HasSubstr("expected found/deep/seed-1.json")));
    EXPECT_EQ(shell("ls -d found").status, 2);
    EXPECT_EQ(run("renew page.md").status, 0);
    EXPECT_EQ(shell("ls found/deep | wc -l").out, "3\n");
    EXPECT_EQ(run("renew --check page.md").status, 0);
    shell("mkdir here; mv mine.sh here");
    page("../outside/deep");
    EXPECT_THAT(shell("cd here; $rastertrace renew ../page.md").err,
                HasSubstr("../outside/deep: expected a folder below the one that the commands of "
                          "the page run in, found one outside"));
    EXPECT_EQ(shell("ls -d outside").status, 2);
}

// Renew waits for what somebody writes into a pipe, and has read the page by then.
class WaitingRenewTest : public RenewTest {
protected:
    WaitingRenewTest() {
        shell("mkfifo pipe; mkdir temporary");
        write("page.md", waiting);
    }

    static inline const std::string waiting = "```\n$ rastertrace show pipe --bare\n```\n";
};

TEST_F(WaitingRenewTest, ASignalEndsTheCommandAndRemovesItsFolder) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) {
        // A shell lets what it runs in the background ignore SIGINT.
        EXPECT_EQ(
            shell(
                "export TMPDIR=$PWD/temporary; env --default-signal=INT $rastertrace renew --check "
                "page.md & renew=$!; exec 3>pipe; child=$(pgrep -P $renew); kill -" +
                std::to_string(signal) +
                " $renew; wait $renew; echo $?; for i in $(seq 100); do kill -0 $child 2>/dev/null "
                "|| break; sleep 0.1; done; kill -0 $child 2>/dev/null && echo runs on")
                .out,
            std::to_string(128 + signal) + "\n");
        if (signal != SIGKILL) {
            EXPECT_EQ(shell("ls temporary").out, "") << signal;
        }
        EXPECT_EQ(content("page.md"), waiting);
    }
}

// Commands run in the current folder, wherever the page lies.
TEST_F(RenewTest, APageMayLieAnywhere) {
    shell("mkdir inside pages; cp scene.json inside; ln -s ../inside/scene.json inside/link.json");
    write("pages/page.md", "```\n"
                           "$ rastertrace show ../inside/scene.json --bare\n"
                           "$ rastertrace show " +
                               (folder_ / "inside/scene.json").string() +
                               " --bare\n"
                               "$ rastertrace show link.json --bare\n"
                               "$ rastertrace trace scene.json -o ../inside/new.json\n```\n");
    EXPECT_THAT(shell("cd inside; $rastertrace renew ../pages/page.md"),
                Prints("../pages/page.md: 4 commands, 3 renewed\n"));
    EXPECT_THAT(content("inside/new.json"), StartsWith("{\"rastertrace\":1,"));
    const Outcome check = shell("cd inside; $rastertrace renew --check ../pages/page.md");
    EXPECT_EQ(check.status, 0);
    EXPECT_EQ(check.out + check.err, "");
}

TEST_F(RenewTest, ACommandThatFailsIsAProblem) {
    write("page.md", "```\n$ rastertrace show bad.json\nold\n```\n");
    EXPECT_THAT(
        run("renew page.md"),
        Refused("rastertrace: page.md:2:1: expected a command that succeeds, found exit status 2\n"
                "$ rastertrace show bad.json\n"
                "^\n"
                "hint: it says: rastertrace: bad.json:1:14: expected vertices by name, like "
                "{\"A\": [2, 5]}, found 1\n"));
    EXPECT_EQ(content("page.md"), "```\n$ rastertrace show bad.json\nold\n```\n");
    write("page.md", "```\n$ rastertrace show scene.json # exit 1\n```\n");
    EXPECT_THAT(run("renew page.md").err,
                HasSubstr("page.md:2:1: expected exit status 1, found success\n"));
    // The system's failure is no mistake of the page.
    write("page.md", "```\n$ rastertrace trace scene.json -o no-folder/t.json\n```\n");
    EXPECT_EQ(run("renew page.md").status, 3);
}

// Commands that nobody sees: those of a block in a comment of the page.
TEST_F(RenewTest, ABlockInACommentIsHiddenAndRenewed) {
    write("page.md", "<!--\n```\n$ rastertrace --version\n```\n-->\n");
    EXPECT_EQ(run("renew page.md").status, 0);
    EXPECT_THAT(content("page.md"), HasSubstr("rastertrace 0."));
}

TEST_F(RenewTest, APageWithAMistakeLeavesAllAsTheyWere) {
    write("page.md", stale);
    write("other.md", "```\n$ rastertrace show scene.json > out.txt\n```\n");
    EXPECT_THAT(
        run("renew page.md other.md"),
        Refused("rastertrace: other.md:2:31: expected a command that needs no shell, found >\n"
                "$ rastertrace show scene.json > out.txt\n"
                "                              ^\n"
                "hint: quote it if it is part of a word\n"));
    EXPECT_EQ(content("page.md"), stale);
    EXPECT_EQ(visible_files(), 4u);
}

TEST_F(RenewTest, PagesAreFiles) {
    EXPECT_THAT(run("renew no.md"), Refused("rastertrace: no.md: expected a file that can be read, "
                                            "found: No such file or directory\n"));
    EXPECT_EQ(run("renew /dev/zero").status, 2);
    write("page.md", "```\n$ rastertrace renew page.md\n```\n");
    EXPECT_EQ(run("renew page.md").err,
              "rastertrace: page.md:2:1: expected a command that shows something, found renew\n"
              "$ rastertrace renew page.md\n"
              "^\n");
    write("text.md", stale);
    EXPECT_THAT(run("renew text.md >>text.md").err,
                HasSubstr("expected another file than those that are read"));
    EXPECT_EQ(content("text.md"), stale);
}

TEST_F(RenewTest, BytesModesAndLinksSurvive) {
    write("real.md", "caf\xC3\xA9 \xFF\r\n"
                     "```\n"
                     "$ rastertrace show 'scene.json' \"--bare\"\n"
                     "```");
    shell("chmod 640 real.md; ln -s real.md page.md");
    EXPECT_EQ(run("renew page.md").status, 0);
    EXPECT_EQ(content("real.md"), "caf\xC3\xA9 \xFF\r\n"
                                  "```\n"
                                  "$ rastertrace show 'scene.json' \"--bare\"\n"
                                  "...\n"
                                  ".#.\n"
                                  "```");
    EXPECT_EQ(run("renew page.md").out, "page.md: 1 command, 0 renewed\n");
    EXPECT_TRUE(fs::is_symlink(folder_ / "page.md"));
    EXPECT_EQ(shell("stat -c %a real.md").out, "640\n");
}

// What the terminal is like is nothing that a page should depend on.
TEST_F(RenewTest, PagesAreTheSameOnEveryTerminal) {
    const std::string page = "```\n$ rastertrace show examples/t0-fill/first-triangle.json\n```\n";
    shell("mkdir -p examples/t0-fill; cp $examples/t0-fill/first-triangle.json examples/t0-fill");
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
    EXPECT_THAT(run("renew page.md"),
                Refused(StartsWith("rastertrace: page.md:2:1: expected a command that prints at "
                                   "most 4 MB, found more\n")));
}

} // namespace
} // namespace rastertrace
