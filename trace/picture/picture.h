// SPDX-License-Identifier: MIT
#pragma once

// Pictures that other programs have drawn: PNG, PNM (the files of netpbm), TGA, and rows of text.
//
//     const auto file = read_bytes("mine.ppm", {});
//     const auto picture = read_picture(file.value());  // a Picture, or the Problem and its place
//     picture.value().at(0, 0);                         // the pixel in the top left corner

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <optional>

namespace rastertrace {

/// As large as a canvas may be (canvas.h).
struct Picture {
    int width = 0;
    int height = 0;
    Colors pixels; ///< row-major, top row first

    /// True if the file has colors. Levels of 8 bits are exactly as in the file, without any correction of
    /// gamma; others are scaled to 0..255 and rounded to the nearest.
    /// False for rows of text and bitmaps (PBM), which only tell what is drawn: that is black, the 1 of a
    /// bitmap; everything else is `no_color`.
    bool has_colors = true;

    /// The pixel `x` columns from the left and `row` rows from the top.
    const Color& at(int x, int row) const {
        return pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

enum class PictureFormat {
    png,
    pnm,       ///< P1 to P6: bits, grays or colors, as text or as bytes
    tga,       ///< colors, grays or a palette, raw or with run lengths
    text_rows, ///< `.` is empty, any other character drawn; perhaps a blank between columns
};

/// The format that a file seems to have; `nullopt` if it is no picture. What it begins with decides; for a TGA,
/// what it ends with, or the ending of its name. Rows of text are recognized by the first of them, if it
/// consists of letters, digits and .#*+-@? with one . or # at least.
std::optional<PictureFormat> picture_format(const Source& source);

/// Reads a picture. Sizes are checked before memory is taken; a file that ends too early is a problem.
Result<Picture> read_picture(const Source& source);

} // namespace rastertrace
