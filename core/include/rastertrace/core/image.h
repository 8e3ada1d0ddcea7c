// SPDX-License-Identifier: MIT
#pragma once

// The picture: one color per pixel of a canvas. The only state that the fills of this folder share.
//
//     Image image(canvas);
//     image.at({2, 5}) = Color{255, 0, 0, 255};

#include <rastertrace/core/canvas.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rastertrace {

/// Red, green, blue and alpha, 0 to 255 each. Alpha 0 is kept for pixels that nothing has drawn:
/// `no_color` is what an image starts with, and no primitive may have a color with alpha 0.
struct Color {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    std::uint8_t alpha = 255;

    friend bool operator==(const Color&, const Color&) = default;
};

inline constexpr Color no_color{0, 0, 0, 0};

/// The colors of a canvas, row-major, top row first.
class Image {
public:
    explicit Image(const Canvas& canvas)
        : canvas_(canvas),
          colors_(static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(canvas.height),
                  no_color) {}

    const Canvas& canvas() const { return canvas_; }
    const std::vector<Color>& colors() const { return colors_; }

    /// The color of a pixel of the canvas.
    Color& at(Pixel pixel) { return colors_[canvas_.offset_of(pixel)]; }
    const Color& at(Pixel pixel) const { return colors_[canvas_.offset_of(pixel)]; }

    /// How many pixels have been drawn.
    std::size_t drawn() const {
        return colors_.size() -
               static_cast<std::size_t>(std::count(colors_.begin(), colors_.end(), no_color));
    }

private:
    Canvas canvas_;
    std::vector<Color> colors_;
};

} // namespace rastertrace
