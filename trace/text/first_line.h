// SPDX-License-Identifier: MIT
#pragma once

// The first line of a file tells whether it is a trace with one step a line, which can be read without being kept.

#include "input.h"
#include "input_check.h"
#include "input_file.h"
#include "problem.h"
#include "trace_layout.h"

#include <string>

namespace rastertrace {

/// A file that has been read as far as its first line tells what it is, or whole.
struct FirstLine {
    InputFile file;
    Source source; ///< what has been read of it
    LineLayout layout;
};

/// Opens a file ("-" for standard input) and reads so far. Throws a Problem.
FirstLine open_first_line(const std::string& path, InputCheck::Kind kind,
                          const InputLimits& limits);

/// Reads a file until its first line tells of a trace with one step a line, and perhaps somewhat farther; or, if it
/// does not, all of the file. Each block is looked at by `fault_of`. Throws a Problem.
LineLayout read_first_line(InputFile& file, Source& source, InputCheck& fault_of);

} // namespace rastertrace
