// SPDX-License-Identifier: MIT
#pragma once

// What makes an exercise as hard as another: how many rows, ties, cuts and hidden pixels each primitive has, and which
// way lines run.

#include <rastertrace/trace/record/trace.h>

#include <string>
#include <vector>

namespace rastertrace {

/// Of a scene's trace in exact numbers: "ABC: 8 rows", "AB: octant 2". Two scenes with the same facts take the same work.
std::vector<std::string> facts_of(const Trace& trace);

} // namespace rastertrace
