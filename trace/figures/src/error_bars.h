// SPDX-License-Identifier: MIT
#pragma once

// Bresenham's d at each of his decisions, as bars beside the line: below its columns, or at the right of its rows.

#include "panel.h"

#include <optional>
#include <vector>

namespace rastertrace {

/// A decision: at a pixel, by a number.
struct Decision {
    Pixel pixel;
    double d;
    std::string text; ///< d, as the trace has it
};

/// The decisions of the current line so far.
struct Decisions {
    bool is_steep = false; ///< there is one for each row, not for each column
    std::vector<Decision> all;
};

/// Nothing if the current step is not of such a line.
std::optional<Decisions> decisions_of(const Replay& replay);

/// How much room the bars take: below, or at the right.
inline constexpr double error_bars_size = 90;

/// Draws them into a strip of that size, its edge at `from`: a y below the pixels, or an x at their right.
void add_error_bars(const Decisions& decisions, const Lattice& lattice, double from,
                    std::vector<Shape>& shapes);

} // namespace rastertrace
