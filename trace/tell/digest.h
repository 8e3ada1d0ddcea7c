// SPDX-License-Identifier: MIT
#pragma once

// What a scene is about, before its picture: the rows of a triangle, the slope and the decisions of a line, what became of
// the faces of a solid, a vertex on its way to the screen.
//
//     triangle ABC   A (2, 5)   B (-4, -3)   C (5, -3)
//       y=5   AB x = 2 -> 2     AC x = 2 -> 2      1 pixel
//       y=4   AB x = 5/4 -> 1   AC x = 19/8 -> 2   2 pixels

#include <rastertrace/trace/record/trace.h>

#include <cstddef>
#include <string>
#include <vector>

namespace rastertrace {

/// At most so many lines, safe to print, the last of which says what more there is; none of a trace in which nothing is drawn or moved.
std::vector<std::string> digest_of(const Trace& trace, std::size_t most_lines = 12);

} // namespace rastertrace
