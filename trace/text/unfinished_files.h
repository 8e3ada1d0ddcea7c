// SPDX-License-Identifier: MIT
#pragma once

// What a program does before a signal ends it, or where it cannot unwind:
//
//     extern "C" void on_signal(int signal) {
//         rastertrace::remove_unfinished_files();
//         ...
//     }

namespace rastertrace {

/// Removes every file that a FileOutput keeps under a temporary name, and temporary folders with all that is in them. May
/// be called in a signal handler, and when no memory is left.
void remove_unfinished_files() noexcept;

} // namespace rastertrace
