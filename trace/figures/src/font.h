// SPDX-License-Identifier: MIT
#pragma once

// The letters of our bitmaps: DejaVu Sans (trace/figures/font), as outlines that stb_truetype reads. It has Latin, Greek,
// and signs of mathematics.
//
//     outline_of(U'A', Typeface::regular, 20).advance  // 13.68: where the next letter begins

#include <rastertrace/figures/drawing.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace rastertrace {

enum class Typeface : std::uint8_t { regular, bold, fixed_width };

/// A letter that begins at (0, 0), on the line that letters stand on; y goes down.
struct Outline {
    std::vector<Path> contours = {}; ///< closed; clockwise around what is filled
    double advance = 0;              ///< to the next letter
};

/// From a letter to the next one, in ems; nothing if the font has not the character.
std::optional<double> advance_of(char32_t character, Typeface face);

/// In pixels, for letters of `size` pixels an em. A character that the font has not is a box.
Outline outline_of(char32_t character, Typeface face, double size);

} // namespace rastertrace
