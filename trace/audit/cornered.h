// SPDX-License-Identifier: MIT
#pragma once

// A primitive with three corners, to be compared with the pixels that it drew; and what coverage.cpp and shared_edges.cpp
// both need for that.

#include "drawn_primitive.h"
#include "screen_point.h"

#include <rastertrace/core/raster/canvas.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace rastertrace {

/// A triangle or an outline, with its corners.
struct Cornered {
    const DrawnPrimitive* drawn = nullptr;
    std::uint32_t place = 0;                ///< in Stats::primitives
    std::array<std::uint32_t, 3> corners{}; ///< numbers of the positions; the same for equal ones
    bool is_drawn_whole = false;            ///< it has all its samples

    const std::array<ScreenPoint, 3>& at() const { return *drawn->corners; }
};

/// The pixel of an offset in a PixelSet.
inline Pixel pixel_at(std::uint32_t offset, const Canvas& canvas) {
    const int place = static_cast<int>(offset);
    return {canvas.left() + place % canvas.width, canvas.y_of(place / canvas.width)};
}

} // namespace rastertrace
