// SPDX-License-Identifier: MIT
#pragma once

// What the primitives of a trace drew, compared with the corners that their steps give: holes,
// pixels outside, edges drawn twice or not at all, outlines that stick out of their fill.
//
//     std::vector<DrawnPrimitive> drawn{{.corners = at, .pixels = PixelSet(offsets)}};
//     compare_with_corners(trace, drawn, stats);

#include "drawn_primitive.h"
#include "stats.h"

#include <rastertrace/trace/record/trace.h>

#include <span>

namespace rastertrace {

/// Fills in the coverage of stats.primitives, stats.edges, stats.outlines and
/// stats.sample.
/// `drawn` are the first primitives of `stats`, one for one.
void compare_with_corners(const Trace& trace, std::span<const DrawnPrimitive> drawn, Stats& stats);

} // namespace rastertrace
