// SPDX-License-Identifier: MIT
#pragma once

// Runs this program once more, as somebody would at a terminal of 80 columns, and takes what it
// prints.
//
//     const FinishedRun run = run_self({"plan", "scene.json"}, folder);

#include "run_program.h"

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The most that a run may print, in bytes, and its time.
inline constexpr std::size_t most_output = 4'000'000;
inline constexpr std::chrono::minutes time_of_run{10};

/// Runs this program with other arguments, without a shell, with nothing to read on standard input. Runs of one folder,
/// and the caller after take_folder_of_runs, share what they have opened. If it has a folder `files`, files are written
/// below that, see write_files_below; else where they belong.
/// What it prints does not depend on the terminal: COLUMNS is 80, LINES is not set, NO_COLOR is.
/// The run ends with this program, however that ends. Throws a Problem if it cannot be run, or if this program is to
/// end by a signal.
FinishedRun run_self(const std::vector<std::string>& arguments, const std::string& folder);

inline constexpr std::string_view folder_of_files = "files";

/// Shares the list of opened files in a folder (process_files.h).
void take_folder_of_runs(const std::string& folder);

/// For main: the same with the folder of the program that has started this one by run_self.
void take_folder_of_caller();

} // namespace rastertrace
