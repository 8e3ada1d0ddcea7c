// SPDX-License-Identifier: MIT
#pragma once

// What the primitives of a trace drew, compared with the corners that their steps give: holes,
// pixels outside, edges drawn twice or not at all, T-junctions, outlines that stick out of their fill.
//
//     std::vector<DrawnPrimitive> drawn{{.step = 1, .pixels = {39, 55, 56}}};
//     compare_with_corners(trace, drawn, 2, stats);

#include "stats.h"
#include "t_junctions.h"

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rastertrace {

/// A primitive of a trace: its step, and the pixels of the canvas that it drew.
struct DrawnPrimitive {
    std::size_t step = 0;
    std::vector<std::uint32_t> pixels;  ///< Canvas::offset_of; ascending and each once, in the end
    std::vector<std::uint32_t> covered; ///< the same and those that were hidden, if any were

    /// The pixels that it drew, or would have drawn if nothing had stood before it.
    const std::vector<std::uint32_t>& covering() const {
        return covered.empty() ? pixels : covered;
    }
};

/// Notes a pixel that may have been noted before: one that was drawn, or one that was hidden.
void add_pixel(DrawnPrimitive& primitive, std::size_t offset);
void add_hidden_pixel(DrawnPrimitive& primitive, std::size_t offset);

/// Puts the pixels in order, and keeps each of them once.
void keep_each_once(DrawnPrimitive& primitive);

/// The corners that a primitive's step gives, if they are three pairs of numbers and given exactly.
std::optional<std::array<ScreenPoint, 3>> positions_in(const PrimitiveStep& step,
                                                       const Trace& header);

/// Fills in the coverage of stats.primitives, stats.edges, stats.t_junctions, stats.outlines and
/// stats.sample, in so many threads.
/// `drawn` are the first primitives of `stats`, one for one.
void compare_with_corners(const Trace& trace, std::span<const DrawnPrimitive> drawn,
                          std::size_t jobs, Stats& stats);

} // namespace rastertrace
