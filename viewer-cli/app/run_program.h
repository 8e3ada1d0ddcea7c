// SPDX-License-Identifier: MIT
#pragma once

// Runs a program without a shell and takes what it prints; whatever happens, it is ended before this one ends.
//
//     const FinishedRun run = run_program({.path = "./mine", .words = {"./mine", "scene.json"}});
//
// run_self runs this program once more, as at a terminal of 80 columns:
//
//     const FinishedRun run = run_self({"plan", "scene.json"}, "", {"page.md"});
//
// Files of a run are put in a temporary folder:
//
//     const TemporaryFolder folder("rastertrace-fuzz");
//     write(folder.path() / "scene.json");

#include <rastertrace/trace/text/descriptor.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace rastertrace {

/// How a run of the program ended, and what it printed.
struct FinishedRun {
    int exit_status = 0;       ///< or 128 + the signal that ended it, as a shell tells it
    std::string out;           ///< standard output
    std::string err;           ///< standard error
    bool is_too_large = false; ///< it was ended because it printed more than it may
    bool is_too_long = false;  ///< it was ended because it took more than its time
};

/// The signals by which somebody ends a program, but for SIGKILL.
inline constexpr std::array asked_endings{SIGINT,    SIGTERM, SIGHUP,  SIGQUIT, SIGXCPU,
                                          SIGPIPE,   SIGABRT, SIGALRM, SIGUSR1, SIGUSR2,
                                          SIGVTALRM, SIGPROF, SIGPOLL, SIGPWR};

/// Holds back the signals that somebody ends this program by, while this lives: a run of its own is ended first, and
/// what was made for it is removed. Then they do what they would have done.
class EndingHeldBack {
public:
    EndingHeldBack();
    EndingHeldBack(const EndingHeldBack&) = delete;
    EndingHeldBack& operator=(const EndingHeldBack&) = delete;
    ~EndingHeldBack();

    /// Can be read as soon as one of them waits.
    int descriptor() const { return waiting_.number(); }

private:
    sigset_t before_;
    Descriptor waiting_;
};

/// What is run, and what it may do.
struct ProgramRun {
    std::string path{};               ///< found in PATH if it has no slash
    std::vector<std::string> words{}; ///< the first one is its name
    std::vector<std::string> environment{};
    std::size_t most_output = 4'000'000; ///< bytes, of both outputs
    std::chrono::milliseconds time{60'000};
    bool has_own_group =
        false; ///< what it starts itself is ended with it, and no key of the terminal reaches it
};

/// This program's environment.
std::vector<std::string> own_environment();

/// Runs a program with nothing to read on standard input. Throws a Problem if it cannot be run, or if this program is
/// to end by a signal.
FinishedRun run_program(ProgramRun program);

/// The most that a run may print, in bytes, and its time.
inline constexpr std::size_t most_output = 4'000'000;
inline constexpr std::chrono::minutes time_of_run{10};

/// Runs this program with other arguments, without a shell, with nothing to read on standard input. Files are written
/// below the folder, see run_for_page; "": where they belong; and onto none of the pages.
/// What it prints does not depend on the terminal: COLUMNS is 80, LINES is not set, NO_COLOR is.
/// The run ends with this program, however that ends. Throws a Problem if it cannot be run, or if this program is to
/// end by a signal.
FinishedRun run_self(const std::vector<std::string>& arguments, const std::string& folder,
                     const std::vector<std::string>& pages);

/// For main: takes folder and pages of the program that has started this one by run_self.
void take_folder_of_run();

/// A new folder. It is removed with all that is in it, however the program ends, unless SIGKILL ends it.
class TemporaryFolder {
public:
    /// Throws a Problem if there can be no folder.
    explicit TemporaryFolder(const std::string& name);
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();

    const std::filesystem::path& path() const { return path_; }

private:
    EndingHeldBack until_removed_;
    Descriptor parent_;
    std::filesystem::path path_;
};

} // namespace rastertrace
