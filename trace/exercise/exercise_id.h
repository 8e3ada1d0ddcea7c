// SPDX-License-Identifier: MIT
#pragma once

// The names of exercises: what a student types, and the line of a sheet that says which exercise it is about.
//
//     exercise_id("anna");      // "1:anna"
//     exercise_line("1:anna");  // "# exercise 1:anna\n"

#include <rastertrace/trace/text/problem.h>

#include <string>
#include <string_view>

namespace rastertrace {

/// The generator's version. An ID begins with it, so that exercises of earlier versions can be made again.
inline constexpr int exercise_version = 1;

/// The ID of what was typed: `anna` is `1:anna`. A Problem for one without letters, of more than 100, with control
/// characters, or of a version that there is not.
Result<std::string> exercise_id(std::string_view typed);

/// The line of a sheet that names its exercise: "# exercise 1:anna\n".
std::string exercise_line(std::string_view id);

/// The ID that such a line of a sheet has.
Result<std::string> exercise_of_sheet(const Source& sheet);

} // namespace rastertrace
