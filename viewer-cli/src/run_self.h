// SPDX-License-Identifier: MIT
#pragma once

// Runs this program once more, as somebody would at a terminal of 80 columns, and takes what it
// prints.
//
//     const FinishedRun run = run_self({"plan", "scene.json"}, {});

#include <rastertrace/trace/text/descriptor.h>
#include <rastertrace/trace/text/process_files.h>

#include <chrono>
#include <csignal>
#include <cstddef>
#include <string>
#include <vector>

namespace rastertrace {

/// How a run of the program ended, and what it printed.
struct FinishedRun {
    int exit_status = 0;       ///< or 128 + the signal that ended it, as a shell tells it
    std::string out;           ///< standard output
    std::string err;           ///< standard error
    bool is_too_large = false; ///< it was ended because it printed more than `most_output`
    bool is_too_long = false;  ///< it was ended because it took more than its time
};

/// What a run may do.
struct RunLimits {
    FileRules files = {};
    std::chrono::seconds time{60};
};

/// The most that a run may print, in bytes.
inline constexpr std::size_t most_output = 4'000'000;

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

/// Runs this program with other arguments, without a shell, with nothing to read on standard input.
/// What it prints does not depend on the terminal: COLUMNS is 80, LINES is not set, NO_COLOR is.
/// The run ends with this program, however that ends. Throws a Problem if it cannot be run, or if this program is to
/// end by a signal.
FinishedRun run_self(const std::vector<std::string>& arguments, const RunLimits& limits);

/// For main: what the program that has started this one by run_self lets it do.
void take_limits_of_run();

} // namespace rastertrace
