// SPDX-License-Identifier: MIT
#pragma once

// Runs this program once more, as somebody would at a terminal of 80 columns, and takes what it
// prints.
//
//     const FinishedRun run = run_self({"plan", "scene.json"});

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
};

/// The most that a run may print, in bytes.
inline constexpr std::size_t most_output = 4'000'000;

/// Runs this program with other arguments, without a shell, with nothing to read on standard input.
/// What it prints does not depend on the terminal: COLUMNS is 80, LINES is not set, NO_COLOR is.
/// Throws a Problem if it cannot be run.
FinishedRun run_self(const std::vector<std::string>& arguments);

} // namespace rastertrace
