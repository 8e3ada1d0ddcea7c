// SPDX-License-Identifier: MIT
#pragma once

// Few colors, numbered in the order in which they were added.
//
//     Palette palette;
//     if (palette.add(pixels))
//         palette.index_of(pixels[0]);  // 0

#include <rastertrace/core/raster/image.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rastertrace {

/// At most 256 opaque colors.
class Palette {
public:
    static constexpr std::size_t most = 256;

    Palette() { numbers_.fill(free_slot); }

    /// Adds the colors that are new; false as soon as they are too many.
    bool add(std::span<const Color> colors);

    /// The number of a color; nothing if it was not added.
    std::optional<std::uint8_t> index_of(Color color) const;

    const std::vector<Color>& colors() const { return colors_; }

private:
    /// The slot that a color is in, or the free one where it belongs.
    std::size_t slot_of(Color color) const;

    static constexpr std::size_t slots = 1024; // three quarters stay free
    static constexpr std::uint16_t free_slot = 0xFFFF;

    std::vector<Color> colors_;
    std::array<std::uint16_t, slots> numbers_; ///< of the colors in the slots
};

} // namespace rastertrace
