// SPDX-License-Identifier: MIT
// The widths of letters without the font that has them.

#include "font.h"
#include "letter_tables.h"

#include <iterator>

namespace rastertrace {

std::optional<double> advance_of(char32_t character, Typeface face) {
    if (character >= std::size(regular_widths))
        return std::nullopt;
    const auto& widths = face == Typeface::bold ? bold_widths : regular_widths;
    const unsigned short width = widths[character];
    return width == 0xFFFF ? std::nullopt : std::optional(width / 2048.0);
}

} // namespace rastertrace
