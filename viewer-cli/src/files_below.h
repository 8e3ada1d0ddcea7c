// SPDX-License-Identifier: MIT
#pragma once

// The files of a folder that a command is given whole.
//
//     for (const std::string& name : files_below("goldens", "traces"))

#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The files in a folder and its folders, as paths from it, by name; none whose name, or whose folder's, begins with a
/// dot. `of_what` names what a message expects there. Throws a Problem.
std::vector<std::string> files_below(const std::string& folder, std::string_view of_what);

} // namespace rastertrace
