// SPDX-License-Identifier: MIT
#pragma once

// The claims file of a scene before anything has been worked out: a table with `?` in place of every
// number, to hand out.
//
//     claims_template(trace);  // "edge AB: ?\nedge AC: ?\n\ny=5: ?, ? -> ?..?\n..."

#include <rastertrace/trace/record/trace.h>

#include <string>
#include <string_view>

namespace rastertrace {

/// What can be worked out by hand of a trace, a line each: vertices on their way to the screen, faces, edges,
/// rows, Bresenham's d, depth tests of pixels that several primitives meet, the picture if it is small. Of a
/// long trace the first lines, and how many more there would be.
std::string claims_template(const Trace& trace);

/// The same as tables with empty cells, in CSV.
std::string claims_template_in_columns(const Trace& trace);

/// The line of a table that names its scene, and a comment that tells where it is looked for.
std::string scene_line(std::string_view path);

} // namespace rastertrace
