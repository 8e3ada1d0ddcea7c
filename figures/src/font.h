// SPDX-License-Identifier: MIT
#pragma once

// The letters of our bitmaps: dots in 5 columns and 12 rows, drawn for this program. ASCII, what Portuguese,
// Spanish, German and French are written with, and some signs of mathematics.
//
//     glyph_of(U'A').has(2, 3)  // true: the tip

#include <array>
#include <cstdint>

namespace rastertrace {

/// Rows from the top: three for accents on capitals, seven of a capital, two below the line.
inline constexpr int glyph_columns = 5;
inline constexpr int glyph_rows = 12;
inline constexpr int glyph_rows_above_line = 10;

/// The dots of a letter.
struct Glyph {
    std::array<std::uint8_t, glyph_rows> rows = {}; ///< bit 0 is the leftmost column

    /// False outside of the glyph.
    bool has(int column, int row) const {
        return 0 <= column && column < glyph_columns && 0 <= row && row < glyph_rows &&
               (rows[static_cast<std::size_t>(row)] >> column & 1) != 0;
    }
};

/// A box for a character that the font has not.
Glyph glyph_of(char32_t character);

} // namespace rastertrace
