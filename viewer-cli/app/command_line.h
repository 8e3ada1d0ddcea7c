// SPDX-License-Identifier: MIT
#pragma once

namespace rastertrace {

/// Reads the command line, runs the command, prints its problem if it has one. Returns the exit
/// status of the program, whether the problem could be printed or not.
int run_command_line(int count, const char* const* arguments) noexcept;

} // namespace rastertrace
