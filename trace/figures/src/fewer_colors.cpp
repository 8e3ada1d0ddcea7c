// SPDX-License-Identifier: MIT
#include "fewer_colors.h"

#include "palette.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace rastertrace {

namespace {

/// 0xRRGGBB.
std::uint32_t word_of(Color color) {
    return std::uint32_t{color.red()} << 16 | std::uint32_t{color.green()} << 8 | color.blue();
}

struct ColorCount {
    std::uint32_t word;
    std::size_t pixels;
};

/// The colors, by their words.
std::vector<ColorCount> color_counts(std::span<const Color> pixels) {
    std::unordered_map<std::uint32_t, std::size_t> counts;
    for (std::size_t i = 0; i < pixels.size();) {
        std::size_t end = i + 1; // of pixels of one color, which are counted together
        while (end < pixels.size() && pixels[end] == pixels[i])
            ++end;
        counts[word_of(pixels[i])] += end - i;
        i = end;
    }
    std::vector<ColorCount> colors;
    for (const auto& [word, count] : counts)
        colors.push_back({word, count});
    std::sort(colors.begin(), colors.end(),
              [](const ColorCount& a, const ColorCount& b) { return a.word < b.word; });
    return colors;
}

/// The most frequent colors of the groups whose members differ in their last `bits` bits, by group.
std::unordered_map<std::uint32_t, ColorCount> most_frequent(const std::vector<ColorCount>& colors,
                                                            std::uint32_t group_mask) {
    std::unordered_map<std::uint32_t, ColorCount> groups;
    for (const ColorCount& color : colors) {
        const auto found = groups.try_emplace(color.word & group_mask, color).first;
        if (found->second.pixels < color.pixels)
            found->second = color;
    }
    return groups;
}

} // namespace

void reduce_colors(std::span<Color> pixels) {
    const std::vector<ColorCount> colors = color_counts(pixels);
    if (colors.size() <= Palette::most)
        return;
    std::uint32_t mask = 0xFFFFFF;
    std::unordered_map<std::uint32_t, ColorCount> groups;
    do {
        mask = (mask << 1) & 0xFEFEFE & mask; // one more bit of each
        groups = most_frequent(colors, mask);
    } while (groups.size() > Palette::most);
    Color before{}; // the last one that was looked up
    Color found{};
    for (Color& color : pixels) {
        if (&color == pixels.data() || color != before) {
            before = color;
            const std::uint32_t word = groups.at(word_of(color) & mask).word;
            found = {static_cast<std::uint8_t>(word >> 16), static_cast<std::uint8_t>(word >> 8),
                     static_cast<std::uint8_t>(word)};
        }
        color = found;
    }
}

} // namespace rastertrace
