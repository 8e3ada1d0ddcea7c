// SPDX-License-Identifier: MIT
#pragma once

// A primitive of a trace with the pixels that it drew, as the steps told them.

#include "pixel_set.h"
#include "screen_point.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rastertrace {

/// A primitive of a trace: its corners, and the pixels of the canvas that it drew.
struct DrawnPrimitive {
    std::optional<std::array<ScreenPoint, 3>> corners = {}; ///< if it is judged by them
    PixelSet pixels = {};
    PixelSet covered = {}; ///< the same and those that were hidden, if any were

    /// The pixels that it drew, or would have drawn if nothing had stood before it.
    const PixelSet& covering() const { return covered.empty() ? pixels : covered; }
};

/// Collects the pixels that the steps of a primitive are about, in whatever order and however often.
class DrawnPixels {
public:
    void add(std::size_t offset) { pixels_.push_back(static_cast<std::uint32_t>(offset)); }
    void add_hidden(std::size_t offset) { hidden_.push_back(static_cast<std::uint32_t>(offset)); }

    /// Gives them to the primitive, sorted and each once, and begins anew.
    void give_to(DrawnPrimitive& primitive);

private:
    std::vector<std::uint32_t> pixels_; ///< canvases have at most 2^26
    std::vector<std::uint32_t> hidden_;
};

} // namespace rastertrace
