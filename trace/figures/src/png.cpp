// SPDX-License-Identifier: MIT
#include <rastertrace/figures/png.h>

#include "palette.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdint>
#include <vector>

namespace rastertrace {

namespace {

/// What libpng is told of a picture. It leaves its functions by longjmp, past whatever has a destructor: so all
/// that has one is made before they are called.
struct Content {
    std::uint32_t width;
    std::uint32_t height;
    int bit_depth;
    int color_type;
    std::vector<png_color> palette;
    std::vector<png_text> texts;
    std::vector<png_byte> row; ///< room for one
    void (*write_row)(const Bitmap&, const Palette&, std::size_t y, png_byte* row);
};

void write_indices(const Bitmap& bitmap, const Palette& palette, std::size_t y, png_byte* row) {
    for (std::size_t x = 0; x < bitmap.width; ++x) {
        const bool is_same = x > 0 && bitmap.at(x, y) == bitmap.at(x - 1, y);
        row[x] = is_same ? row[x - 1] : palette.index_of(bitmap.at(x, y)).value_or(0);
    }
}

void write_colors(const Bitmap& bitmap, const Palette& /*unused*/, std::size_t y, png_byte* row) {
    for (std::size_t x = 0; x < bitmap.width; ++x) {
        const Color color = bitmap.at(x, y);
        *row++ = color.red();
        *row++ = color.green();
        *row++ = color.blue();
    }
}

/// The fewest bits that hold so many numbers, of those that PNG has.
int bits_for(std::size_t colors) {
    constexpr std::array depths{1, 2, 4};
    for (const int bits : depths)
        if (colors <= std::size_t{1} << bits)
            return bits;
    return 8;
}

Content content_of(const Bitmap& bitmap, const Palette& palette, bool has_palette) {
    Content content{.width = static_cast<std::uint32_t>(bitmap.width),
                    .height = static_cast<std::uint32_t>(bitmap.height),
                    .bit_depth = has_palette ? bits_for(palette.colors().size()) : 8,
                    .color_type = has_palette ? PNG_COLOR_TYPE_PALETTE : PNG_COLOR_TYPE_RGB,
                    .palette = {},
                    .texts = {},
                    .row = std::vector<png_byte>(bitmap.width * (has_palette ? 1 : 3)),
                    .write_row = has_palette ? write_indices : write_colors};
    if (has_palette)
        for (const Color color : palette.colors())
            content.palette.push_back({color.red(), color.green(), color.blue()});
    return content;
}

void append(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))
        ->append(reinterpret_cast<const char*>(bytes), count); // NOLINT: libpng has unsigned bytes
}

void keep_message(png_structp png, png_const_charp message) {
    *static_cast<std::string*>(png_get_error_ptr(png)) = message;
    png_longjmp(png, 1);
}

void ignore_warning(png_structp /*unused*/, png_const_charp /*unused*/) {}

/// False if libpng failed; then `file` is of no use.
bool write(png_structp png, png_infop info, const Bitmap& bitmap, const Palette& palette,
           Content& content, std::string& file) {
    if (setjmp(png_jmpbuf(png)) != 0) // NOLINT: libpng has no other way
        return false;
    png_set_write_fn(png, &file, append, nullptr);
    png_set_user_limits(png, most_png_side, most_png_side);
    png_set_IHDR(png, info, content.width, content.height, content.bit_depth, content.color_type,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (!content.palette.empty())
        png_set_PLTE(png, info, content.palette.data(), static_cast<int>(content.palette.size()));
    if (!content.texts.empty())
        png_set_text(png, info, content.texts.data(), static_cast<int>(content.texts.size()));
    png_write_info(png, info);
    png_set_packing(png);
    for (std::size_t y = 0; y < bitmap.height; ++y) {
        content.write_row(bitmap, palette, y, content.row.data());
        png_write_row(png, content.row.data());
    }
    png_write_end(png, nullptr);
    return true;
}

} // namespace

Result<std::string> png_of(const Bitmap& bitmap) {
    if (auto problem = problem_of_sides(bitmap, most_png_side, "PNG"))
        return *std::move(problem);

    Palette palette;
    Content content = content_of(bitmap, palette, palette.add(bitmap.colors));
    std::string keyword = "Title";
    std::string title = printable(bitmap.title);
    if (!title.empty()) {
        png_text text{};
        text.compression = PNG_ITXT_COMPRESSION_NONE; // UTF-8
        text.key = keyword.data();
        text.text = title.data();
        content.texts.push_back(text);
    }

    std::string file;
    std::string message = "libpng has no memory";
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, ignore_warning);
    png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
    const bool is_written = info != nullptr && write(png, info, bitmap, palette, content, file);
    png_destroy_write_struct(&png, &info);
    if (!is_written) {
        Problem problem = problem_of("", fmt::format("the PNG could not be made: {}", message));
        problem.cause = Problem::Cause::system;
        return problem;
    }
    return file;
}

} // namespace rastertrace
