// SPDX-License-Identifier: MIT
#pragma once

// Pictures of more than 256 colors, for formats that have no more.
//
//     reduce_colors(pixels);  // now a Palette takes them

#include <rastertrace/core/raster/image.h>

#include <span>

namespace rastertrace {

/// Leaves at most 256 of the colors of opaque pixels. Colors that differ only in the last bit of their red, green
/// and blue become the most frequent one among them, then those that differ in the last two bits, and so on,
/// until few enough are left: what is large keeps its color. Of two that are as frequent, the darker red stays
/// (then green, then blue).
void reduce_colors(std::span<Color> pixels);

} // namespace rastertrace
