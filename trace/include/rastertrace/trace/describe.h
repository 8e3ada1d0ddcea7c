// SPDX-License-Identifier: MIT
#pragma once

// What a step says, in the words and formulas of the textbook, with the numbers put in:
//
//     scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> -1   right AC: x = 2 - 3/8 (2 - 5) =
//     25/8 -> 3

#include <rastertrace/trace/frame.h>

#include <string>

namespace rastertrace {

/// The current step of a replay in one line, safe to print.
std::string describe_step(const Replay& replay);

} // namespace rastertrace
