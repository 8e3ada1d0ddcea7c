// SPDX-License-Identifier: MIT
#pragma once

// Where pixels are: the one page that says what a pixel stands for, where it is asked, and which
// way y points.
//
// A pixel is named by the integer point (x, y) of the scene's own coordinates. Fills and lines look at
// one point of it, its sample (sample_offset.h). A scene says where that is:
//
//     sample: integer                          sample: center
//
//         3 -   o     o     o                      3 -   +-----+-----+
//                                                        |     |     |
//         2 -   o     o     o   the sample         2.5   |  o  |  o  |   the sample of
//               (1,2)           of (1, 2)                |(1,2)|     |   (1, 2): (1.5, 2.5)
//         1 -                                      2 -   +-----+-----+
//               |     |     |                            |     |     |
//               1     2     3                            1     2     3
//
// With `integer`, the convention of the textbooks, the sample is the integer point itself. With
// `center`, that of graphics hardware, it lies half a pixel from there, toward larger x and larger y:
// top-left has it unless the scene says otherwise. The corners of that square, or any other point up
// to a pixel away, can be samples, too.
//
// Two fills, barycentric and top-left, ask whether the sample lies in the triangle. The others,
// scanline, two-halves, fan and lines, look where an edge or a line meets the row (or column) of
// samples, and round that to one of these (rounding.h): they may draw a pixel whose sample lies
// outside.
//
// The canvas says which integer points exist and which way y points:
//
//     origin: center, y up           bottom-left, y up          top-left, y down
//
//          y                         y                          (0,0) ----- x
//          |                         |                            |
//     -----+----- x                  |                            |
//        (0,0)                     (0,0) ----- x                  y
//
//     Canvas canvas{.width = 17, .height = 14};  // origin in the center: x -8..8, y 7..-6, y up
//
// Whatever the origin, rows are counted from the top of the picture, and pixels are visited from
// the top row to the bottom row (two-halves: from the bottom), from left to right in a row.

#include <rastertrace/core/numbers/index.h>

#include <cstddef>

namespace rastertrace {

/// A pixel on a canvas, by its integer point in the scene's coordinates.
struct Pixel {
    int x = 0;
    int y = 0;

    friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// Where (0, 0) lies on the canvas, and which way y points.
enum class Origin {
    center,      ///< y up; column = floor(width/2 + x), row = floor(height/2 - y)
    bottom_left, ///< y up; column = x, row = height - 1 - y
    top_left,    ///< y down; column = x, row = y
};

/// The largest width or height, and the largest number of pixels, of a canvas.
inline constexpr int largest_canvas_side = 16'384;
inline constexpr int largest_canvas_area = 1 << 26;

/// The grid of pixels that a scene is drawn on. Rows count from the top of the picture, from 0.
struct Canvas {
    int width = 0;  ///< columns, 1 or more
    int height = 0; ///< rows, 1 or more
    Origin origin = Origin::center;
    bool is_turned = false; ///< rows count from the bottom of the picture instead

    /// How many pixels there are.
    std::size_t area() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }

    /// The x of the leftmost and of the rightmost column.
    int left() const { return origin == Origin::center ? -(width / 2) : 0; }
    int right() const { return left() + width - 1; }

    /// The step in y from one row to the row below it: +1 where y points down, -1 where it points
    /// up.
    int down() const { return (origin == Origin::top_left) != is_turned ? 1 : -1; }

    /// The same pixels with their rows in the other order: what is the top of it is the bottom of
    /// the picture.
    Canvas turned() const { return {width, height, origin, !is_turned}; }

    /// The y of the topmost and of the bottommost row.
    int top() const { return is_turned ? upright_top() + down() * (1 - height) : upright_top(); }
    int bottom() const { return top() + down() * (height - 1); }

    /// How many rows `y` lies below the top row; negative above the canvas. `y` may lie anywhere.
    Index row_of(Index y) const { return (y - top()) * down(); }

    /// The y of the row that lies `row` rows below the top row.
    template <typename Row> Row y_of(Row row) const { return top() + down() * row; }

    /// True when the canvas has this pixel: left() <= x <= right(), and the same for y.
    bool contains(Index x, Index y) const {
        const Index row = row_of(y);
        return left() <= x && x <= right() && 0 <= row && row < height;
    }

    /// The place of a pixel of the canvas in row-major order, top row first.
    std::size_t offset_of(Pixel pixel) const {
        return static_cast<std::size_t>(row_of(pixel.y)) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(pixel.x - left());
    }

    friend bool operator==(const Canvas&, const Canvas&) = default;

private:
    int upright_top() const {
        switch (origin) {
        case Origin::center:
            return height / 2;
        case Origin::bottom_left:
            return height - 1;
        case Origin::top_left:
            break;
        }
        return 0;
    }
};

/// The pixels that have a depth: columns from `left` on, rows from `top_row` on.
struct DepthRegion {
    int left = 0;
    int top_row = 0;
    int width = 0;
    int height = 0;

    bool has(int x, int row) const {
        return left <= x && x < left + width && top_row <= row && row < top_row + height;
    }

    std::size_t area() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }

    /// The index of a pixel in row-major order. The column may lie outside of the region: rows are
    /// addressed from x = 0.
    std::ptrdiff_t offset_of(int x, int row) const {
        return static_cast<std::ptrdiff_t>(row - top_row) * width + (x - left);
    }
};

} // namespace rastertrace
