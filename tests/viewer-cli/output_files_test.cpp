// SPDX-License-Identifier: MIT
// Files that the program writes: whole or not at all, and never over what it has read.

#include "program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

namespace rastertrace {
namespace {

TEST_F(ProgramTest, AFullDiskLeavesNoHalfFile) {
    EXPECT_EQ(run("trace $examples/t0-fill/first-triangle.json >/dev/full").status, 3);
    EXPECT_THAT(
        run("trace $examples/t0-fill/first-triangle.json -o /dev/full"),
        Ends(3, _, "rastertrace: /dev/full: could not be written: No space left on device\n"));
    // A limit of one block of 512 bytes.
    write("old.json", "old");
    EXPECT_THAT(
        shell("ulimit -f 1; $rastertrace trace $examples/t0-fill/first-triangle.json -o old.json"),
        Ends(3, _, StartsWith("rastertrace: old.json: could not be written: ")));
    EXPECT_EQ(content("old.json"), "old");
    EXPECT_EQ(visible_files(), 1u);
}

TEST_F(ProgramTest, NothingThatWasReadIsOverwritten) {
    const std::string scene = R"({"canvas": {"width": 9, "height": 9},
                                  "meshes": [{"obj": "models/c.obj"}]})";
    const std::string model = "v 0 0 0\nv 3 0 0\nv 0 3 0\nf 1 2 3\n";
    write("scene.json", scene);
    shell("mkdir models; ln -s scene.json link.json; ln scene.json hard.json; "
          "ln -s models/c.obj link.obj; ln -s gone.json dangling.json");
    write("models/c.obj", model);
    for (const std::string arguments :
         {"trace scene.json -o scene.json", "trace scene.json -o link.json",
          "trace scene.json -o hard.json", "trace link.json -o ./scene.json",
          "trace scene.json --format json -o models/c.obj",
          "trace scene.json --format json -o models/../link.obj",
          "trace - -o scene.json <scene.json", "trace scene.json >>scene.json",
          "trace scene.json 1<>models/c.obj", "show scene.json 1<>models/c.obj",
          "show scene.json >>hard.json", "stress scene.json >>scene.json",
          "plan - <scene.json >>scene.json",
          "report --quick --format csv scene.json -o models/c.obj",
          "report --quick --format csv - -o scene.json <scene.json",
          "report --quick --format csv $examples/t0-fill/first-triangle.json scene.json "
          "-o out.csv -o scene.json"}) {
        EXPECT_THAT(run(arguments),
                    Refused(EndsWith(
                        ": expected another file than those that are read, found one of them\n")))
            << arguments;
        EXPECT_EQ(content("scene.json"), scene) << arguments;
        EXPECT_EQ(content("models/c.obj"), model) << arguments;
        EXPECT_EQ(visible_files(), 6u) << arguments;
    }
}

// Also a mesh of the scene, what is compared with, and a name that a number makes.
TEST_F(ProgramTest, NothingThatAFigureHasReadIsOverwritten) {
    const std::string model = "v 0 0 0\nv 3 0 0\nv 0 3 0\nf 1 2 3\n";
    write("c-1.obj", model);
    write("scene.json", R"({"canvas": {"width": 9, "height": 9}, "meshes": [{"obj": "c-1.obj"}]})");
    ASSERT_EQ(run("trace scene.json -o other-2.json; ln other-2.json hard").status, 0);
    const std::string other = content("other-2.json");
    for (const std::string arguments :
         {"--format svg -o c-1.obj", "--format html -o c-1.obj", "-o - --format svg >>c-1.obj",
          "--every scanline --format txt -o c.obj",
          "--vary /meshes/0/model/0/translate/0=0:1:2 --format svg -o c.obj",
          "--against other-2.json --format svg -o hard",
          "--against other-2.json --every scanline --format png -o other.json"}) {
        write("scene.json", R"({"canvas": {"width": 9, "height": 9},
            "meshes": [{"obj": "c-1.obj", "model": [{"translate": [0, 0, 0]}]}]})");
        EXPECT_THAT(run("figure scene.json " + std::string(arguments)),
                    Refused(EndsWith(
                        ": expected another file than those that are read, found one of them\n")))
            << arguments;
        EXPECT_EQ(content("c-1.obj"), model) << arguments;
        EXPECT_EQ(content("other-2.json"), other) << arguments;
        EXPECT_EQ(visible_files(), 4u) << arguments;
    }
}

// Every other option that writes, onto every file that its call reads: by its name, through links, and from another
// command of a page.
TEST_F(ProgramTest, NothingThatAnyCommandHasReadIsOverwritten) {
    const std::string refused = "expected another file than those that are read, found one of them";
    write("c.obj", "v 0 0 0\nv 3 0 0\nv 0 3 0\nf 1 2 3\n");
    write("scene.json", R"({"canvas": {"width": 9, "height": 9}, "meshes": [{"obj": "c.obj"}]})");
    write("mine.sh", "exit 7\n");
    write("page.md", "```\n$ rastertrace show scene.json --bare\n```\n");
    shell("ln -s scene.json link.json; ln c.obj hard.obj; mkdir found probes; "
          "ln mine.sh found/seed-1.json; ln -s ../mine.sh found/seed-2.json");
    const auto all = [&] { return shell("cat scene.json c.obj mine.sh page.md").out; };
    const std::string before = all();
    for (const std::string output : {"scene.json", "link.json", "c.obj", "hard.obj", "page.md"}) {
        for (const std::string command :
             {"trace scene.json --format json", "report --quick --format csv scene.json",
              "figure scene.json --format svg", "figure scene.json --sheet 2x1 --format svg"}) {
            if (output != "page.md") { // which these do not read
                EXPECT_THAT(run(command + " -o " + output), Refused(HasSubstr(refused)));
            }
            write("run.md", "```\n$ rastertrace show scene.json --bare\n$ rastertrace " + command +
                                " -o " + output + "\n```\n");
            for (const std::string check : {"", "--check "})
                EXPECT_THAT(run("renew " + check + "page.md run.md").err, HasSubstr(refused))
                    << check << command << " -o " << output;
        }
        EXPECT_EQ(run("sheet scene.json -o " + output).status, 2) << output;
        EXPECT_EQ(run("sheet scene.json --format csv -o " + output).status, 2) << output;
    }
    for (const std::string seed : {"1", "2"})
        EXPECT_THAT(
            run("fuzz --seed " + seed + " --runs 1 --shrink 0 -o found -- sh mine.sh {scene}"),
            Refused(HasSubstr(refused)));
    EXPECT_EQ(run("examples -o $examples").status, 0);
    EXPECT_EQ(all(), before);
}

TEST_F(ProgramTest, SeveralFilesGetTheirNamesTogether) {
    shell("cp $examples/t0-fill/first-triangle.json scene.json");
    const std::string figures =
        "$rastertrace figure scene.json --every pixel --format txt -o f.txt";
    // Once the first has its name, a signal waits for the last of 49.
    EXPECT_EQ(
        shell("env --default-signal=TERM " + figures +
              " & until [ -e f-01.txt ]; do :; done; kill -TERM $!; wait $!; ls f-*.txt | wc -l")
            .out,
        "49\n");
#ifdef RASTERTRACE_FAILING_CALLS
    const auto failing = [&](const std::string& how) {
        return shell("rm -f f-*.txt; " + how + " LD_PRELOAD=" RASTERTRACE_FAILING_CALLS " " +
                     figures);
    };
    // Not one before all are on the disk.
    EXPECT_THAT(failing("FAIL_CALL=fsync FAIL_AT=3"),
                Ends(3, _, "rastertrace: f-03.txt: could not be written: Input/output error\n"));
    EXPECT_EQ(visible_files(), 1u);

    EXPECT_THAT(failing("FAIL_CALL=rename FAIL_AT=3 FAIL_ALWAYS=1"),
                Ends(3, _,
                     "rastertrace: f-03.txt: could not be given its name: Input/output "
                     "error\nhint: new by then: f-01.txt, f-02.txt\n"));
    EXPECT_EQ(shell("ls f-*.txt").out, "f-01.txt\nf-02.txt\n");
    EXPECT_THAT(failing("FAIL_CALL=rename FAIL_AT=1 FAIL_ALWAYS=1").err,
                EndsWith("\nhint: none of the other files is new\n"));
    EXPECT_EQ(visible_files(), 1u);
#endif
}

// A report opens its files and then measures for minutes. Its second file is a pipe: once that can
// be opened for reading, both are open.
TEST_F(ProgramTest, ASignalLeavesNoFile) {
    const std::string run_and_end =
        "ulimit -c 0; mkfifo pipe.csv; for signal in INT TERM HUP QUIT XCPU; do "
        "$preload env --default-signal=$signal $rastertrace report "
        "$examples/numerics/friendly.json -o r.csv -o pipe.csv & "
        "exec 3<pipe.csv; kill -$signal $!; wait $!; echo $?; exec 3<&-; done; rm pipe.csv";
    const std::string statuses = "130\n143\n129\n131\n152\n";
    EXPECT_EQ(shell(run_and_end).out, statuses);
    EXPECT_EQ(visible_files(), 0u);
#ifdef RASTERTRACE_FAILING_CALLS
    // The same where files cannot be without a name.
    EXPECT_EQ(shell("preload='env FAIL_TMPFILE=1 LD_PRELOAD=" RASTERTRACE_FAILING_CALLS "'; " +
                    run_and_end)
                  .out,
              statuses);
    EXPECT_EQ(visible_files(), 0u);
#endif
    // What is ignored stays so.
    EXPECT_EQ(shell("trap '' HUP; mkfifo pipe.csv; $rastertrace report --quick --jobs edge "
                    "$examples/t0-fill/first-triangle.json -o r.csv -o pipe.csv & "
                    "exec 3<pipe.csv; kill -HUP $!; cat <&3 >copy.csv; wait $!")
                  .status,
              0);
    EXPECT_FALSE(content("r.csv").empty());
}

TEST_F(ProgramTest, WritesTheFileThatALinkLeadsTo) {
    shell("mkdir folder; ln -s folder/link2.json link.json; ln -s ../real.json folder/link2.json");
    const std::string trace = "$rastertrace trace $examples/t0-fill/first-triangle.json -o ";
    EXPECT_EQ(shell(trace + "link.json").status, 0) << "the link dangles";
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.json"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "folder/link2.json"));
    EXPECT_THAT(content("real.json"), StartsWith("{\"rastertrace\":1,"));
    shell("ln -s loop.json loop.json");
    EXPECT_THAT(
        shell(trace + "loop.json"),
        Ends(3, _,
             "rastertrace: loop.json: could not be created: Too many levels of symbolic links\n"));
}

TEST_F(ProgramTest, WritesNamesAsLongAsTheSystemTakes) {
    const std::string name = std::string(250, 'n') + ".json";
    const std::string trace = "$rastertrace trace $examples/t0-fill/first-triangle.json -o ";
    EXPECT_EQ(shell(trace + name).status, 0);
    EXPECT_EQ(shell(trace + name).status, 0) << "once more, over the first";
    EXPECT_THAT(content(name), StartsWith("{\"rastertrace\":1,"));
    EXPECT_THAT(shell(trace + "n" + name),
                Ends(3, _, EndsWith(".json: could not be created: File name too long\n")));
}

TEST_F(ProgramTest, KeepsTheModeOfTheFileThatItReplaces) {
    const std::string trace = "$rastertrace trace $examples/t0-fill/first-triangle.json -o ";
    EXPECT_EQ(
        shell("umask 077; : >t.json; chmod 666 t.json; " + trace + "t.json; stat -c %a t.json").out,
        "666\n");
    EXPECT_EQ(shell("umask 022; chmod 640 t.json; " + trace + "t.json; stat -c %a t.json").out,
              "640\n");
    EXPECT_EQ(shell("umask 027; " + trace + "new.json; stat -c %a new.json").out, "640\n");
}

TEST_F(ProgramTest, AFileInAFolderThatTakesNoneIsNotWritten) {
    // Whoever runs the tests may write anywhere; nobody may not.
    EXPECT_THAT(shell("cp $rastertrace rastertrace; cp $examples/t0-fill/first-triangle.json .; "
                      "mkdir folder; echo old >folder/old.json; chmod 666 folder/old.json; chmod "
                      "555 folder; chmod 755 .; as_nobody=; test $(id -u) != 0 || "
                      "as_nobody='setpriv --reuid=65534 --regid=65534 --clear-groups'; $as_nobody "
                      "./rastertrace trace first-triangle.json -o folder/old.json"),
                Ends(3, _,
                     "rastertrace: folder/old.json: may be written, but its folder takes no new "
                     "file to replace it by: Permission denied\n"));
    EXPECT_EQ(content("folder/old.json"), "old\n");
    shell("chmod 755 folder");
}

TEST_F(ProgramTest, WaitsForAPipeThatIsFull) {
    write("big.json", R"({"canvas": {"width": 100, "height": 100},
        "vertices": {"A": [-50, -50], "B": [50, -50], "C": [0, 50]}, "triangles": ["ABC"]})");
    const std::string whole = run("trace big.json").out;

    // A pipe that says EAGAIN as long as it is full. It is read once it is, or once the program ends.
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe2(pipe.data(), O_CLOEXEC), 0);
    ::fcntl(pipe[1], F_SETFL, O_NONBLOCK);
    const int capacity = ::fcntl(pipe[1], F_SETPIPE_SZ, 4096);
    ASSERT_LT(static_cast<std::size_t>(capacity), whole.size());
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe[1], 1);
    const std::string scene = (folder_ / "big.json").string();
    std::vector<std::string> words{RASTERTRACE_PROGRAM, "trace", scene};
    std::vector<char*> arguments{words[0].data(), words[1].data(), words[2].data(), nullptr};
    pid_t child = 0;
    ASSERT_EQ(
        ::posix_spawn(&child, RASTERTRACE_PROGRAM, &actions, nullptr, arguments.data(), environ),
        0);
    posix_spawn_file_actions_destroy(&actions);
    ::close(pipe[1]);
    siginfo_t ended{};
    for (int waiting = 0; waiting < capacity && ended.si_pid == 0; std::this_thread::yield()) {
        ::ioctl(pipe[0], FIONREAD, &waiting);
        ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
    }
    std::string received;
    std::array<char, 4096> buffer;
    for (ssize_t count = 0; (count = ::read(pipe[0], buffer.data(), buffer.size())) > 0;)
        received.append(buffer.data(), static_cast<std::size_t>(count));
    ::close(pipe[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(received, whole);
}

TEST_F(ProgramTest, AClosedPipeEndsItQuietly) {
    write("big.json", R"({"canvas": {"width": 600, "height": 600},
        "vertices": {"A": [-300, -300], "B": [300, -300], "C": [0, 300]}, "triangles": ["ABC"]})");
    const Outcome outcome = shell("{ $rastertrace trace big.json; echo $? >status; } | head -1");
    EXPECT_THAT(outcome.out, StartsWith("{\"rastertrace\":1,"));
    EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(content("status"), "141\n") << "ended by the signal, as other programs are";
}

} // namespace
} // namespace rastertrace
