// SPDX-License-Identifier: MIT
#pragma once

// Runs this program once more, as somebody would at a terminal of 80 columns, and takes what it
// prints.
//
//     const FinishedRun run = run_self({"plan", "scene.json"}, "", {"page.md"});

#include "app/run_program.h"

#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace rastertrace {

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

} // namespace rastertrace
