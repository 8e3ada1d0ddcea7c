// SPDX-License-Identifier: MIT
#pragma once

// What triangles drew where one ends and the next begins: at an edge that they share.

#include "coverage.h"
#include "triangle_samples.h"

#include <rastertrace/core/raster/canvas.h>

#include <array>
#include <cstdint>
#include <vector>

namespace rastertrace {

/// A triangle with area, to be compared with the pixels that it drew.
struct DrawnTriangle {
    const DrawnPrimitive* drawn;
    std::uint32_t place;                  ///< in Stats::primitives
    std::array<std::uint32_t, 3> corners; ///< numbers of the positions; the same for equal ones
    bool is_drawn_whole = false;          ///< it has all its samples

    const std::array<ScreenPoint, 3>& at() const { return *drawn->corners; }
};

/// The pixel of an offset in a PixelSet.
inline Pixel pixel_at(std::uint32_t offset, const Canvas& canvas) {
    const int place = static_cast<int>(offset);
    return {canvas.left() + place % canvas.width, canvas.y_of(place / canvas.width)};
}

/// Compares every two triangles that share an edge, the first `most_compared` at each edge.
std::vector<SharedEdge> compared_edges(const std::vector<DrawnTriangle>& triangles,
                                       const CanvasSamples& grid);

} // namespace rastertrace
