// SPDX-License-Identifier: MIT
#pragma once

// Runs this program once more, as somebody would at a terminal of 80 columns, and takes what it
// prints.
//
//     const FinishedRun run = run_self({"plan", "scene.json"}, {});

#include "run_program.h"

#include <rastertrace/trace/text/process_files.h>

#include <chrono>
#include <string>
#include <vector>

namespace rastertrace {

/// What a run may do.
struct RunLimits {
    FileRules files = {};
    std::chrono::seconds time{60};
};

/// The most that a run may print, in bytes.
inline constexpr std::size_t most_output = 4'000'000;

/// Runs this program with other arguments, without a shell, with nothing to read on standard input.
/// What it prints does not depend on the terminal: COLUMNS is 80, LINES is not set, NO_COLOR is.
/// The run ends with this program, however that ends. Throws a Problem if it cannot be run, or if this program is to
/// end by a signal.
FinishedRun run_self(const std::vector<std::string>& arguments, const RunLimits& limits);

/// For main: what the program that has started this one by run_self lets it do.
void take_limits_of_run();

/// True if this run may use only the files below a folder: a page has chosen its arguments.
bool runs_for_page();

} // namespace rastertrace
