// SPDX-License-Identifier: MIT
#pragma once

// What the primitives of a trace drew, compared with the corners that their steps give: holes, pixels outside, edges
// drawn twice or not at all.
//
//     std::vector<DrawnPrimitive> drawn{{.corners = at, .pixels = PixelSet(offsets)}};
//     compare_with_corners(trace, drawn, stats);

#include "pixel_set.h"
#include "screen_point.h"
#include "stats.h"

#include <rastertrace/trace/record/trace.h>

#include <array>
#include <optional>
#include <span>

namespace rastertrace {

/// A primitive of a trace: its corners, and the pixels of the canvas that it drew.
struct DrawnPrimitive {
    std::optional<std::array<ScreenPoint, 3>> corners = {}; ///< if it is judged by them
    PixelSet pixels = {};
    PixelSet covered = {}; ///< the same and those that were hidden, if any were

    /// The pixels that it drew, or would have drawn if nothing had stood before it.
    const PixelSet& covering() const { return covered.empty() ? pixels : covered; }
};

/// Fills in the coverage of stats.primitives, stats.edges and stats.sample.
/// `drawn` are the first primitives of `stats`, one for one.
void compare_with_corners(const Trace& trace, std::span<const DrawnPrimitive> drawn, Stats& stats);

} // namespace rastertrace
