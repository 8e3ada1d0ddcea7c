// SPDX-License-Identifier: MIT
#pragma once

// A bitmap as a PNG file: with a palette where 256 colors are enough, else with red, green and blue per pixel.
// The title is in it, and no time, so that the same bitmap makes the same bytes.
//
//     const auto png = png_of(bitmap_of(drawing, Theme::light, 2));

#include <rastertrace/figures/bitmap.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <string>

namespace rastertrace {

/// The most pixels of a row or a column: libpng reads no more.
inline constexpr std::size_t most_png_side = 1'000'000;

/// The bytes of the file; or why there are none: the bitmap is empty, or a side is too long.
Result<std::string> png_of(const Bitmap& bitmap);

} // namespace rastertrace
