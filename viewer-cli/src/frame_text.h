// SPDX-License-Identifier: MIT
#pragma once

// A frame as text: the canvas as a grid of characters, top row first.
//
//     First triangle                                                  step 14 of 62
//     scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> -1   ...
//
//          -8-7-6-5-4-3-2-1 0 1 2 3 4 5 6 7 8
//       4   . . . . . . . . . # # . . . . . .
//     > 2   . . . . . . . @ @ @ @ @ . . . . .

#include "terminal.h"

#include <rastertrace/trace/frame.h>

#include <cstddef>
#include <string>

namespace rastertrace {

/// A frame and what is said above it.
struct FrameText {
    std::string caption;        ///< what the step says, see describe_step
    std::size_t first_step = 0; ///< pixels drawn by the steps from this one ...
    std::size_t last_step = 0;  ///< ... to this one, the frame's own, are new: drawn as @
};

/// The frame that a replay has reached, with title, caption, and coordinates along the borders:
/// `.` empty, `#` plotted, `@` plotted by the steps shown, a letter for a vertex of the current
/// primitive (plotted or not), `>` the row that the first of these steps is about. A canvas too wide for `size` loses
/// the gaps between its columns; one that still does not fit is cut to a window around the newest
/// pixel, and a line says so.
std::string frame_text(const Replay& replay, const FrameText& about, TextSize size);

/// Only the grid: `.` empty, `#` plotted.
std::string bare_frame_text(const Frame& frame);

} // namespace rastertrace
