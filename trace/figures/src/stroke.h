// SPDX-License-Identifier: MIT
#pragma once

// Lines with a width, as polygons: what SVG calls stroking. Corners are round, ends are cut off straight.
//
//     add_stroke({{0, 0}, {40, 20}}, {.width = 1.8}, coverage);

#include "coverage.h"

#include <span>

namespace rastertrace {

/// All in pixels.
struct Pen {
    double width = 1;
    std::span<const double> dashes = {}; ///< drawn, left out, drawn, ...
    bool joins_ends = false;             ///< the last place of a path with the first
};

/// Adds a line to what is covered.
void add_stroke(std::span<const Place> path, const Pen& pen, PixelCoverage& coverage);

/// Adds a disc.
void add_disc(Place center, double radius, PixelCoverage& coverage);

} // namespace rastertrace
