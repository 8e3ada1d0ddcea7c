// SPDX-License-Identifier: MIT
#pragma once

// A reader for each format, and what they share. All of them throw a Problem.

#include "picture.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rastertrace {

/// A picture of `no_color`, whose memory is not used before it is written. Throws if it would be larger than
/// a canvas.
Picture blank_picture(const Source& source, std::size_t width, std::size_t height);

/// Throws if there are fewer rows than a file promises.
void check_rows(const Source& source, int expected, std::size_t found);

/// `level` of 0..`most` as one of 0..255, the nearest.
constexpr std::uint8_t scaled_level(std::uint32_t level, std::uint32_t most) {
    return static_cast<std::uint8_t>((level * 255 + most / 2) / most);
}

Picture read_png(const Source& source);
Picture read_pnm(const Source& source);
Picture read_tga(const Source& source);
Picture read_text_rows(const Source& source);

/// True if the first line seems to be a row of a picture.
bool begins_with_text_row(std::string_view text);

} // namespace rastertrace
