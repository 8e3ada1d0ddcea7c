// SPDX-License-Identifier: MIT
// TGA, after the Truevision TGA File Format Specification, version 2.0: a header of 18 bytes, a name, a palette,
// the pixels. What may follow them is left out.

#include "readers.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

constexpr bool has_colors_of(unsigned bits) {
    return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

class TgaReader {
public:
    explicit TgaReader(const Source& source) : source_(source), bytes_(source.view()) {}

    Picture read() {
        check_header();
        Picture picture = blank_picture(source_, word_at(12), word_at(14));
        take(byte_at(0)); // a name
        const bool has_palette = byte_at(1) == 1;
        for (std::size_t i = 0; has_palette && i < word_at(5); ++i)
            palette_.push_back(color_at(take(bytes_for(byte_at(7))), byte_at(7)));
        read_pixels(picture);

        // Some programs say that there is no alpha and write it nevertheless; others write 0 there.
        const bool is_told = (byte_at(17) & 15U) > 0;
        if (!is_told && std::all_of(picture.pixels.begin(), picture.pixels.end(),
                                    [](Color pixel) { return pixel.alpha() == 0; }))
            for (Color& pixel : picture.pixels)
                pixel = {pixel.red(), pixel.green(), pixel.blue()};
        return picture;
    }

private:
    unsigned byte_at(std::size_t at) const { return static_cast<unsigned char>(bytes_[at]); }
    unsigned word_at(std::size_t at) const { return byte_at(at) | byte_at(at + 1) << 8U; }
    static std::size_t bytes_for(unsigned bits) { return (bits + 7) / 8; }

    /// Goes on by `count` bytes, and returns where they begin.
    std::size_t take(std::size_t count) {
        if (count > bytes_.size() - at_)
            throw problem_of(source_.name,
                             fmt::format("expected {} bytes of a TGA at byte {}, found {}", count,
                                         at_, bytes_.size() - at_));
        at_ += count;
        return at_ - count;
    }

    void check_byte(bool holds, std::size_t at, std::string_view expected) const {
        if (!holds)
            throw problem_of(source_.name, fmt::format("expected {} at byte {}, found {}", expected,
                                                       at, byte_at(at)));
    }

    /// Byte 2 is the type: 1 with a palette, 2 colors, 3 grays, and 8 more with run lengths.
    void check_header() {
        take(18);
        type_ = byte_at(2) & ~8U;
        has_runs_ = (byte_at(2) & 8U) != 0;
        bits_ = byte_at(16);
        check_byte(1 <= type_ && type_ <= 3, 2, "a type of TGA, 1, 2, 3, 9, 10 or 11,");
        check_byte(byte_at(1) == 1 || (byte_at(1) == 0 && type_ != 1), 1, "1 for a palette");
        check_byte(byte_at(1) == 0 || has_colors_of(byte_at(7)), 7,
                   "15, 16, 24 or 32 bits for each color of a palette");
        check_byte(type_ == 2 ? has_colors_of(bits_) : bits_ == 8, 16,
                   type_ == 2 ? "15, 16, 24 or 32 bits a pixel" : "8 bits a pixel");
        check_byte((byte_at(17) & 0xC0U) == 0, 17, "rows that are not interleaved");
    }

    /// Blue, green and red: bytes, or 5 bits each from the lowest on.
    Color color_at(std::size_t at, unsigned bits) const {
        const auto level = [this](std::size_t i) { return static_cast<std::uint8_t>(byte_at(i)); };
        if (bits >= 24)
            return {level(at + 2), level(at + 1), level(at), bits == 32 ? level(at + 3) : full};
        const unsigned word = word_at(at);
        const bool has_alpha = bits == 16 && (byte_at(17) & 15U) == 1;
        return {scaled_level(word >> 10U & 31U, 31), scaled_level(word >> 5U & 31U, 31),
                scaled_level(word & 31U, 31), has_alpha ? scaled_level(word >> 15U, 1) : full};
    }

    Color pixel_at(std::size_t at) const {
        if (type_ == 2)
            return color_at(at, bits_);
        const unsigned byte = byte_at(at);
        if (type_ == 3) {
            const auto gray = static_cast<std::uint8_t>(byte);
            return {gray, gray, gray};
        }
        const std::size_t index = std::size_t{byte} - word_at(3); // huge if below the first color
        check_byte(index < palette_.size(), at, "a color of the palette");
        return palette_[index];
    }

    /// Bits of the descriptor, byte 17, say in which corner the first pixel is.
    void read_pixels(Picture& picture) {
        const bool from_right = (byte_at(17) & 0x10U) != 0;
        const bool from_top = (byte_at(17) & 0x20U) != 0;
        const auto width = static_cast<std::size_t>(picture.width);
        const auto height = static_cast<std::size_t>(picture.height);
        const std::size_t pixel_bytes = bytes_for(bits_);
        if (!has_runs_)
            check_rows(source_, picture.height, (bytes_.size() - at_) / (width * pixel_bytes));

        // A packet is a byte and one pixel for all of a run, or each pixel by itself. It may go on in the next row.
        Color color;
        std::size_t left = 0;
        bool is_run = false;
        for (std::size_t row = 0; row < height; ++row) {
            Color* const pixels = &picture.pixels[(from_top ? row : height - 1 - row) * width];
            for (std::size_t x = 0; x < width; ++x) {
                const bool begins = has_runs_ && left == 0;
                if (at_ + (begins ? 1 : 0) + (begins || !is_run ? pixel_bytes : 0) > bytes_.size())
                    check_rows(source_, picture.height, row);
                if (begins) {
                    const unsigned packet = byte_at(take(1));
                    left = 1 + (packet & 127U);
                    is_run = (packet & 128U) != 0;
                }
                if (begins || !is_run)
                    color = pixel_at(take(pixel_bytes));
                pixels[from_right ? width - 1 - x : x] = color;
                left -= has_runs_ ? 1 : 0;
            }
        }
    }

    static constexpr std::uint8_t full = 255;

    const Source& source_;
    std::string_view bytes_;
    std::size_t at_ = 0; ///< what is read next
    unsigned type_ = 0;
    unsigned bits_ = 0; ///< of a pixel
    bool has_runs_ = false;
    std::vector<Color> palette_;
};

} // namespace

Picture read_tga(const Source& source) {
    return TgaReader(source).read();
}

} // namespace rastertrace
