// SPDX-License-Identifier: MIT
#pragma once

// What lies off the canvas, in one line:
//
//     3 rows and 2 pixels lie above the canvas, 10 pixels left of it, none drawn: does y point down?
//     ("origin": "top-left")

#include <rastertrace/trace/record/trace.h>

#include <string>

namespace rastertrace {

/// How much a trace says to have been dropped on which side of its canvas; "" if nothing was. Rows
/// were dropped whole, triangles as well. Where all of it that is not beside the canvas lies above it,
/// or all below, and nothing moved the vertices to the screen, y may have been meant to point the
/// other way: then that is asked.
std::string off_canvas_text(const Trace& trace);

} // namespace rastertrace
