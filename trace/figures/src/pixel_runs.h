// SPDX-License-Identifier: MIT
#pragma once

// Pixels as few rectangles, for formats that are made of shapes.
//
//     for (const PixelRuns& runs : runs_of(pixels)) ...

#include <rastertrace/figures/drawing.h>

#include <vector>

namespace rastertrace {

/// All pixels of a color: those beside one another as one rectangle.
struct PixelRuns {
    Color color;
    std::vector<Rectangle> rectangles;
};

/// By color: red first, then green, blue and alpha. Without `no_color`.
std::vector<PixelRuns> runs_of(const Pixels& pixels);

} // namespace rastertrace
