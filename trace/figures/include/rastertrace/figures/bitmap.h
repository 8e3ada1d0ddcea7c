// SPDX-License-Identifier: MIT
#pragma once

// A drawing as pixels. AGG finds how much of each pixel a shape covers, in whole numbers, and letters are outlines
// of a font that the program holds, so that every machine gets the same bytes.
//
//     const Bitmap bitmap = bitmap_of(drawing, Theme::light, 2);  // a unit is 2 x 2 pixels
//     const Color corner = bitmap.at(0, 0);
//
// Edges that lie on whole pixels are sharp. Elsewhere a pixel gets as much of a color as the shape covers of it.

#include <rastertrace/figures/drawing.h>
#include <rastertrace/figures/theme.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Opaque pixels, row by row, the top one first.
struct Bitmap {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<Color> colors = {};
    std::string title = {}; ///< of the drawing

    Color at(std::size_t x, std::size_t y) const { return colors[y * width + x]; }
};

/// The most pixels of a bitmap: they take 400 megabytes.
inline constexpr std::size_t most_bitmap_pixels = 100'000'000;

/// Why a drawing has no bitmap: it would have too many pixels. To be asked before bitmap_of().
std::optional<Problem> too_large_for_bitmap(const Drawing& drawing, double scale);

/// Why a format whose sides have at most so many pixels cannot hold a bitmap.
std::optional<Problem> problem_of_sides(const Bitmap& bitmap, std::size_t most,
                                        std::string_view format);

/// The drawing as pixels, `scale` of them per unit; where its width or height is no whole number of pixels, one
/// more, and at least one. The drawing must not be too large. No coordinate may be NaN.
Bitmap bitmap_of(const Drawing& drawing, Theme theme, double scale);

} // namespace rastertrace
