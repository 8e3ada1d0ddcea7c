// SPDX-License-Identifier: MIT
#pragma once

// How the numbers of a step come of one another, in lines as one would write them down by hand:
//
//     AB = B - A = (2, 0, 0)
//     AC = C - A = (2, -2, 0)
//     normal = AB x AC = (0 (0) - 0 (-2), 0 (2) - 2 (0), 2 (-2) - 0 (2)) = (0, 0, -4)
//
// Everything is worked out again from the numbers in the trace, exactly; a line whose result would not be
// the one that the trace tells is left out.

#include <rastertrace/trace/record/replay.h>

#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The working of the current step of a replay, safe to print. Kinds of steps in which nothing is worked out have
/// none.
std::vector<std::string> working_of(const Replay& replay);

/// A number, or several with commas between, as a working writes them: long fractions by their first digits.
std::string as_in_working(std::string_view numbers);

} // namespace rastertrace
