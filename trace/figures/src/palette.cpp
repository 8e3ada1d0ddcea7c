// SPDX-License-Identifier: MIT
#include "palette.h"

namespace rastertrace {

std::size_t Palette::slot_of(Color color) const {
    // Knuth's multiplicative hash: the upper bits of a product with 2^32 divided by the golden ratio.
    constexpr std::uint32_t factor = 2654435769;
    constexpr int unused_bits = 22; // of 32, for 1024 slots
    const std::uint32_t word = std::uint32_t{color.red()} | std::uint32_t{color.green()} << 8 |
                               std::uint32_t{color.blue()} << 16;
    std::size_t slot = word * factor >> unused_bits;
    while (numbers_[slot] != free_slot && !(colors_[numbers_[slot]] == color))
        slot = (slot + 1) % slots;
    return slot;
}

bool Palette::add(std::span<const Color> colors) {
    std::optional<Color> last;
    for (const Color color : colors) {
        if (last == color)
            continue;
        last = color;
        const std::size_t slot = slot_of(color);
        if (numbers_[slot] != free_slot)
            continue;
        if (colors_.size() == most)
            return false;
        numbers_[slot] = static_cast<std::uint16_t>(colors_.size());
        colors_.push_back(color);
    }
    return true;
}

std::optional<std::uint8_t> Palette::index_of(Color color) const {
    const std::uint16_t number = numbers_[slot_of(color)];
    if (number == free_slot)
        return std::nullopt;
    return static_cast<std::uint8_t>(number);
}

} // namespace rastertrace
