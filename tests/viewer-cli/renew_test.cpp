// SPDX-License-Identifier: MIT
// Pages as their author renews and checks them.

#include "program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
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

// Its times are another each time: it is run, and what it writes is not looked at.
TEST_F(RenewTest, CheckRunsAReportAndKeepsNothingOfIt) {
    write("page.md",
          "```\n$ rastertrace report --quick --jobs edge $examples/t0-fill/first-triangle.json "
          "-o times.csv -otimes.svg --output=times.json\n```\n");
    shell("cp $examples/t0-fill/first-triangle.json . && sed -i 's|$examples/t0-fill/||' page.md; "
          "mkdir temporary");
    const std::string page = content("page.md");
    const Outcome check =
        shell("TMPDIR=$PWD/temporary $rastertrace renew --check page.md; ls temporary");
    EXPECT_EQ(check.status, 0);
    EXPECT_EQ(check.out + check.err, "");
    EXPECT_EQ(visible_files(), 5u);
    EXPECT_EQ(content("page.md"), page);
    EXPECT_EQ(shell("$rastertrace renew page.md; ls times.*").out,
              "page.md: 1 command, 0 renewed\ntimes.csv\ntimes.json\ntimes.svg\n");
}

TEST_F(RenewTest, CheckChangesNoFileThatACommandWritesBeforeItFails) {
    write("cut.json",
          shell("$rastertrace trace $examples/t0-fill/first-triangle.json").out.substr(0, 2000));
    write("page.md", "```\n$ rastertrace figure cut.json -o figure.txt # exit 2\n```\n");
    ASSERT_EQ(shell("$rastertrace renew page.md").status, 0);
    write("figure.txt", "old");
    const Outcome check = shell("$rastertrace renew --check page.md");
    EXPECT_EQ(check.status, 1);
    EXPECT_THAT(check.out, StartsWith("page.md:2:1: expected figure.txt as this command writes "
                                      "it, found another file, or none\n"));
    EXPECT_EQ(content("figure.txt"), "old");
}

// Renew waits for what somebody writes into a pipe, and has read the page by then.
class WaitingRenewTest : public RenewTest {
protected:
    WaitingRenewTest() {
        shell("mkfifo pipe; mkdir temporary");
        write("page.md", waiting);
    }

    /// Runs a script while a command on page.md waits for its scene, which it gets then.
    Outcome renew_while(const std::string& script, const std::string& options = "") const {
        return shell("$rastertrace renew page.md " + options + " & exec 3>pipe; " + script +
                     "; cat scene.json >&3; exec 3>&-; wait $!");
    }

    static inline const std::string waiting = "```\n$ rastertrace show pipe --bare\n```\n";
    static inline const std::string renewed =
        "```\n$ rastertrace show pipe --bare\n...\n.#.\n```\n";
    static inline const std::string hint =
        "hint: no page was written; renew PAGE -o FILE writes what its commands print now to "
        "another file\n";
};

TEST_F(WaitingRenewTest, APageThatHasChangedMeanwhileStays) {
    const Outcome typed = renew_while("echo typed >>page.md");
    EXPECT_EQ(typed.status, 2);
    EXPECT_EQ(typed.err, "rastertrace: page.md: expected the page that was read, found it changed "
                         "meanwhile\n" +
                             hint);
    EXPECT_EQ(typed.out, "");
    EXPECT_EQ(content("page.md"), waiting + "typed\n");

    write("page.md", waiting);
    const Outcome replaced = renew_while("cp page.md other.md; mv other.md page.md");
    EXPECT_EQ(replaced.status, 2);
    EXPECT_EQ(replaced.err, "rastertrace: page.md: expected the page that was read, found another "
                            "file in its place\n" +
                                hint);
    EXPECT_EQ(content("page.md"), waiting);

    const Outcome deleted = renew_while("rm page.md");
    EXPECT_EQ(deleted.status, 2);
    EXPECT_EQ(deleted.err, "rastertrace: page.md: expected the page that was read, found none "
                           "that can be read any more\n" +
                               hint);
    EXPECT_FALSE(fs::exists(folder_ / "page.md"));

    write("page.md", waiting);
    EXPECT_EQ(renew_while("true").status, 0);
    EXPECT_EQ(content("page.md"), renewed);
}

TEST_F(WaitingRenewTest, NoPageIsWrittenIfOneHasChanged) {
    write("other.md", stale);
    EXPECT_EQ(renew_while("echo typed >>page.md", "other.md").status, 2);
    EXPECT_EQ(content("other.md"), stale);
}

TEST_F(WaitingRenewTest, AnotherFileTakesWhatCommandsPrint) {
    const Outcome typed = renew_while("echo typed >>page.md", "-o renewed.md");
    EXPECT_EQ(typed.status, 0) << typed.err;
    EXPECT_EQ(typed.out, "page.md: 1 command, 1 renewed\n");
    EXPECT_EQ(content("page.md"), waiting + "typed\n");
    EXPECT_EQ(content("renewed.md"), renewed);

    write("dots.md", fresh);
    EXPECT_EQ(shell("$rastertrace renew dots.md -o dots.md").err,
              "rastertrace: dots.md: expected another file than those that are read, found one of "
              "them\n");
    EXPECT_EQ(shell("$rastertrace renew dots.md -o -").err,
              "rastertrace: --output: expected the name of a file, found \"-\"\n");
    EXPECT_EQ(shell("$rastertrace renew dots.md page.md -o two.md").err,
              "rastertrace: --output: expected one page, and no --check, found \"two.md\"\n");
}

TEST_F(WaitingRenewTest, ACommandHasItsTime) {
    const Outcome late = shell("$rastertrace renew --timeout 1 page.md");
    EXPECT_EQ(late.status, 2);
    EXPECT_EQ(late.err, "rastertrace: page.md:2:1: expected a command that ends within 1 s, found "
                        "one that takes longer\n"
                        "$ rastertrace show pipe --bare\n"
                        "^\n"
                        "hint: renew --timeout SECONDS gives it more time\n");
    EXPECT_EQ(content("page.md"), waiting);
    EXPECT_EQ(shell("$rastertrace renew --timeout 0 page.md").err,
              "rastertrace: --timeout: expected a number of seconds from 1 to 1000000, found "
              "\"0\"\n");
}

TEST_F(WaitingRenewTest, ASignalEndsTheCommandAndRemovesItsFolder) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) {
        // A shell lets what it runs in the background ignore SIGINT.
        const Outcome ended =
            shell("export TMPDIR=$PWD/temporary; "
                  "env --default-signal=INT $rastertrace renew --check page.md & "
                  "renew=$!; exec 3>pipe; child=$(pgrep -P $renew); kill -" +
                  std::to_string(signal) +
                  " $renew; wait $renew; echo $?; "
                  "for i in $(seq 100); do kill -0 $child 2>/dev/null || break; sleep 0.1; done; "
                  "kill -0 $child 2>/dev/null && echo runs on");
        EXPECT_EQ(ended.out, std::to_string(128 + signal) + "\n");
        if (signal != SIGKILL) {
            EXPECT_EQ(shell("ls temporary").out, "") << signal;
        }
        EXPECT_EQ(content("page.md"), waiting);
    }
}

// What a page from somebody else tries: to read what lies outside, and to write there.
TEST_F(RenewTest, CommandsUseFilesBelowTheFolderOnly) {
    shell("mkdir -p inside/folder outside; cp scene.json inside; cp scene.json outside; cd outside;"
          "printf 'v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n' >mesh.obj;"
          "printf 'precious\n' >old; mkfifo pipe;"
          "cd ../inside; ln -s ../outside link; ln -s ../outside/old old; ln -s ../outside/old "
          "row-2.txt; ln -s ../outside/new new; ln -s ../outside/scene.json there.json");
    const auto in_json = [](const std::string& mesh) {
        return R"({"canvas": {"width": 3, "height": 2}, "meshes": [{"obj": ")" + mesh + R"("}]})";
    };
    write("inside/obj.json", in_json("../outside/mesh.obj"));
    write("inside/absolute.json", in_json((folder_ / "outside/mesh.obj").string()));
    write("inside/linked.json", in_json("link/mesh.obj"));
    write("inside/dots.claims", "scene: ../outside/scene.json\n(0,0): on\n");
    const std::string outside = (folder_ / "outside").string();
    const std::string hint = "hint: renew --allow-outside lets the commands of a page use any file";
    for (const std::string command : {"stats /etc/passwd",
                                      "show ../outside/scene.json",
                                      "show folder/../../outside/scene.json",
                                      "show link/scene.json",
                                      "show there.json",
                                      "show /proc/self/cwd/../outside/scene.json",
                                      "validate ../outside/scene.json",
                                      "explain ../outside/scene.json --pixel 0,0",
                                      "diff scene.json ../outside/scene.json",
                                      "play ../outside/scene.json --print 80x24",
                                      "show ../outside/pipe",
                                      "show /dev/stdin",
                                      "show obj.json --allow-outside",
                                      "show absolute.json --allow-outside",
                                      "plan linked.json --allow-outside",
                                      "check dots.claims",
                                      "figure scene.json --against ../outside/scene.json -o a.svg",
                                      "trace scene.json -o ../outside/new",
                                      "trace scene.json -o../outside/new",
                                      "trace scene.json --output=../outside/new",
                                      "trace scene.json --output ../outside/new",
                                      "trace scene.json -o link/new",
                                      "trace scene.json -o new",
                                      "trace scene.json -o old",
                                      "trace scene.json -o /dev/null",
                                      "trace scene.json -o ../outside/pipe",
                                      "report --quick scene.json -o a.csv -o ../outside/b.csv",
                                      "figure scene.json -o ../outside/a.html",
                                      "figure scene.json --vary /vertices/A/0=0:1:3 -o row.txt"})
        for (const std::string options : {"", " --check"}) {
            write("inside/page.md", "```\n$ rastertrace " + command + " # exit 2\n```\n");
            const Outcome renew = shell("cd inside; $rastertrace renew page.md" + options);
            EXPECT_EQ(renew.status, options.empty() ? 0 : 1) << command << renew.err;
            const std::string told = options.empty() ? content("inside/page.md") : renew.out;
            EXPECT_THAT(told, HasSubstr("expected a file below the folder in which renew runs, "
                                        "found one outside"))
                << command;
            if (options.empty()) {
                EXPECT_THAT(told, HasSubstr(hint)) << command;
            }
            EXPECT_EQ(shell("ls outside; ls inside/row*; cat outside/old").out,
                      "mesh.obj\nold\npipe\nscene.json\ninside/row-2.txt\nprecious\n")
                << command;
        }

    // Who trusts a page says so.
    write("inside/page.md", "```\n"
                            "$ rastertrace show obj.json --bare --allow-outside\n"
                            "$ rastertrace trace scene.json -o " +
                                outside + "/new\n```\n");
    EXPECT_EQ(shell("cd inside; $rastertrace renew --allow-outside --check page.md").status, 1);
    EXPECT_FALSE(fs::exists(folder_ / "outside/new"));
    const Outcome trusted = shell("cd inside; $rastertrace renew --allow-outside page.md");
    EXPECT_EQ(trusted.status, 0) << trusted.err;
    EXPECT_TRUE(fs::exists(folder_ / "outside/new"));
    EXPECT_EQ(shell("cd inside; $rastertrace renew --allow-outside --check page.md").status, 0);
}

// Nor does it run a program, unless somebody trusts the page.
TEST_F(RenewTest, CommandsRunNoProgram) {
    write("page.md", "```\n$ rastertrace fuzz --runs 1 -- touch done '{scene}' # exit 2\n```\n");
    EXPECT_EQ(shell("$rastertrace renew page.md").status, 0);
    EXPECT_THAT(content("page.md"), HasSubstr("a page can run no program"));
    EXPECT_FALSE(fs::exists(folder_ / "done"));
    shell("$rastertrace renew --allow-outside page.md");
    EXPECT_TRUE(fs::exists(folder_ / "done"));
}

// A path may go out and come back, and a page may lie anywhere.
TEST_F(RenewTest, WhereAPathEndsIsWhatCounts) {
    shell("mkdir inside pages; cp scene.json inside; ln -s ../inside/scene.json inside/link.json");
    write("pages/page.md", "```\n"
                           "$ rastertrace show ../inside/scene.json --bare\n"
                           "$ rastertrace show " +
                               (folder_ / "inside/scene.json").string() +
                               " --bare\n"
                               "$ rastertrace show link.json --bare\n"
                               "$ rastertrace trace scene.json -o ../inside/new.json\n```\n");
    const Outcome renew = shell("cd inside; $rastertrace renew ../pages/page.md");
    EXPECT_EQ(renew.status, 0) << renew.err;
    EXPECT_EQ(renew.out, "../pages/page.md: 4 commands, 3 renewed\n");
    EXPECT_THAT(content("inside/new.json"), StartsWith("{\"rastertrace\":1,"));
    const Outcome check = shell("cd inside; $rastertrace renew --check ../pages/page.md");
    EXPECT_EQ(check.status, 0);
    EXPECT_EQ(check.out + check.err, "");
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

TEST_F(RenewTest, APageInAnotherFolderSaysWhereItsCommandsRun) {
    std::filesystem::create_directory(folder_ / "chapter");
    write("chapter/page.md", "```\n$ rastertrace show own.json --bare\n```\n");
    write("chapter/own.json", R"({"vertices": {"A": [0, 0]}, "points": ["A"]})");
    EXPECT_EQ(shell("$rastertrace renew chapter/page.md").err,
              "rastertrace: chapter/page.md:2:1: expected a command that succeeds, found exit "
              "status 2\n"
              "$ rastertrace show own.json --bare\n"
              "^\n"
              "hint: commands run in the current folder: cd chapter before renew\n");
    EXPECT_EQ(shell("cd chapter && $rastertrace renew page.md").status, 0);
}

// Commands that nobody sees: those of a block in a comment of the page.
TEST_F(RenewTest, ABlockInACommentIsHiddenAndRenewed) {
    write("page.md", "<!--\n```\n$ rastertrace --version\n```\n-->\n");
    EXPECT_EQ(shell("$rastertrace renew page.md").status, 0);
    EXPECT_THAT(content("page.md"), ::testing::HasSubstr("rastertrace 0."));
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
    const Outcome refused = shell("$rastertrace renew page.md");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, StartsWith("rastertrace: page.md:2:1: expected a command that prints "
                                        "at most 4 MB, found more\n"));
}

} // namespace
} // namespace rastertrace
