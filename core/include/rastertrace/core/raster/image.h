// SPDX-License-Identifier: MIT
#pragma once

// The picture: one color per pixel of a canvas. It is the only state that fills share.
//
//     Image image(canvas);
//     image.at({2, 5}) = Color{255, 0, 0, 255};

#include <rastertrace/core/raster/blank_vector.h>
#include <rastertrace/core/raster/canvas.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace rastertrace {

/// Red, green, blue and alpha, 0 to 255 each, in one word: a picture is filled a word at a time.
/// Alpha 0 is kept for pixels that nothing has drawn: `no_color` is what an image starts with, and
/// no primitive may have a color with alpha 0.
class Color {
public:
    /// Opaque black.
    constexpr Color() : Color(0, 0, 0) {}
    constexpr Color(std::uint8_t red, std::uint8_t green, std::uint8_t blue,
                    std::uint8_t alpha = 255)
        : word_(std::uint32_t{red} | std::uint32_t{green} << 8 | std::uint32_t{blue} << 16 |
                std::uint32_t{alpha} << 24) {}

    constexpr std::uint8_t red() const { return static_cast<std::uint8_t>(word_); }
    constexpr std::uint8_t green() const { return static_cast<std::uint8_t>(word_ >> 8); }
    constexpr std::uint8_t blue() const { return static_cast<std::uint8_t>(word_ >> 16); }
    constexpr std::uint8_t alpha() const { return static_cast<std::uint8_t>(word_ >> 24); }

    friend constexpr bool operator==(const Color&, const Color&) = default;

private:
    std::uint32_t word_;
};

inline constexpr Color no_color{0, 0, 0, 0};

/// A row of a picture: its pixels from x = `left` to x = `right`.
struct ImageRow {
    int index; ///< 0 is the top row
    int y;
    int left;
    int right;
    Color* colors; ///< of the leftmost pixel, and on to the right

    Color& at(int x) const { return colors[x - left]; }
};

/// The colors of all pixels of a canvas, row-major, top row first.
using Colors = BlankVector<Color>;

/// A canvas and its colors.
class Image {
public:
    explicit Image(const Canvas& canvas) : Image(canvas, canvas.width, canvas.height) {}

    /// A picture whose rows share the memory of one, for drawing that nobody looks at.
    static Image of_one_row(const Canvas& canvas) { return {canvas, 0, 1}; }

    const Canvas& canvas() const { return canvas_; }
    const Colors& colors() const { return colors_; }

    /// The color of a pixel of the canvas.
    Color& at(Pixel pixel) { return colors_[offset_of(pixel)]; }
    const Color& at(Pixel pixel) const { return colors_[offset_of(pixel)]; }

    /// The row at height `y` of the canvas.
    ImageRow row(int y) {
        const int index = (y - top_) * down_;
        return {index, y, left_, left_ + canvas_.width - 1, colors_.data() + index * stride_};
    }

    /// How many pixels have been drawn.
    std::size_t drawn() const {
        return colors_.size() -
               static_cast<std::size_t>(std::count(colors_.begin(), colors_.end(), no_color));
    }

private:
    Image(const Canvas& canvas, int stride, int rows)
        : canvas_(canvas), left_(canvas.left()), top_(canvas.top()), down_(canvas.down()),
          stride_(stride),
          colors_(static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(rows)) {}

    std::size_t offset_of(Pixel pixel) const {
        return static_cast<std::size_t>((pixel.y - top_) * down_ * stride_ + (pixel.x - left_));
    }

    Canvas canvas_;
    int left_; ///< left(), top() and down() of the canvas, computed once: rows are often short
    int top_;
    int down_;
    std::ptrdiff_t stride_; ///< from a row to the next; 0 if all are one
    Colors colors_;         ///< of zeros at first: no_color
};

} // namespace rastertrace
