// SPDX-License-Identifier: MIT
#pragma once

namespace rastertrace {

/// Exit statuses of the program.
enum ExitStatus : int {
    exit_fine = 0,
    exit_difference = 1, ///< a difference, a wrong claim, a rule broken
    exit_bad_input = 2,  ///< bad usage or input
    exit_system = 3,     ///< the system failed: disk full, ...
};

} // namespace rastertrace
