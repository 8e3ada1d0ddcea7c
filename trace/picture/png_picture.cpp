// SPDX-License-Identifier: MIT
// PNG, by libpng: whatever the file has, as red, green, blue and alpha of 8 bits.

#include "readers.h"

#include <fmt/core.h>

#include <png.h>

#include <cassert>
#include <csetjmp>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// A file while libpng reads it. libpng leaves its functions by longjmp, past whatever has a destructor: so all
/// that has one is kept here, and the functions below that call it have nothing of the kind.
struct PngFile {
    std::string_view rest; ///< what has not been read yet
    std::string message = "no memory for libpng";
    int passes = 1; ///< over all rows; 7 if the file is interlaced
    Picture picture;
    std::size_t rows = 0; ///< how many are complete

    png_structp png = nullptr;
    png_infop info = nullptr;

    PngFile() = default;
    PngFile(const PngFile&) = delete;
    PngFile& operator=(const PngFile&) = delete;
    ~PngFile() { png_destroy_read_struct(&png, &info, nullptr); }
};

void keep_message(png_structp png, png_const_charp message) {
    static_cast<PngFile*>(png_get_error_ptr(png))->message = message;
    png_longjmp(png, 1);
}

void ignore_warning(png_structp /*unused*/, png_const_charp /*unused*/) {}

void take_bytes(png_structp png, png_bytep bytes, std::size_t count) {
    std::string_view& rest = static_cast<PngFile*>(png_get_io_ptr(png))->rest;
    if (count > rest.size())
        png_error(png, "the file ends too early");
    std::memcpy(bytes, rest.data(), count);
    rest.remove_prefix(count);
}

/// Reads what stands before the pixels, and says how these are wanted. False if libpng failed.
bool read_header(PngFile& file) {
    png_structp png = file.png;
    if (setjmp(png_jmpbuf(png)) != 0) // NOLINT: libpng has no other way
        return false;
    png_set_read_fn(png, &file, take_bytes);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);            // blank_picture has ours
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1); // texts may be huge
    png_read_info(png, file.info);

    png_set_expand(png);   // palettes, fewer bits than 8, and transparent colors
    png_set_scale_16(png); // to the nearest level of 8 bits
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
    file.passes = png_set_interlace_handling(png);
    return true;
}

/// Reads all rows, four bytes a pixel, and what follows them. False if libpng failed.
bool read_rows(PngFile& file) {
    png_structp png = file.png;
    if (setjmp(png_jmpbuf(png)) != 0) // NOLINT: libpng has no other way
        return false;
    png_read_update_info(png, file.info); // takes memory for rows
    const auto width = static_cast<std::size_t>(file.picture.width);
    const auto height = static_cast<std::size_t>(file.picture.height);
    assert(png_get_rowbytes(png, file.info) == width * sizeof(Color));
    for (int pass = 1; pass <= file.passes; ++pass)
        for (std::size_t row = 0; row < height; ++row) {
            void* const pixels = file.picture.pixels.data() + row * width;
            png_read_row(png, static_cast<png_bytep>(pixels), nullptr);
            file.rows = pass == file.passes ? row + 1 : 0;
        }
    png_read_end(png, nullptr);
    return true;
}

} // namespace

Picture read_png(const Source& source) {
    PngFile file;
    file.rest = source.view();
    const auto fail = [&] {
        const auto height = static_cast<std::size_t>(file.picture.height);
        const std::string found = file.rows < height
                                      ? fmt::format("{} rows, found {}, then", height, file.rows)
                                      : "a PNG, found";
        throw problem_of(source.name,
                         fmt::format("expected {} a fault at byte {}: {}", found,
                                     source.view().size() - file.rest.size(), file.message));
    };
    file.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &file, keep_message, ignore_warning);
    file.info = file.png == nullptr ? nullptr : png_create_info_struct(file.png);
    if (file.info == nullptr || !read_header(file))
        fail();
    file.picture = blank_picture(source, png_get_image_width(file.png, file.info),
                                 png_get_image_height(file.png, file.info));
    if (!read_rows(file))
        fail();

    // In the place of its four bytes, each pixel becomes a color, whatever the order of bytes in a word.
    for (Color& pixel : file.picture.pixels) {
        const auto* const bytes = reinterpret_cast<const png_byte*>(&pixel); // NOLINT
        pixel = {bytes[0], bytes[1], bytes[2], bytes[3]};
    }
    return std::move(file.picture);
}

} // namespace rastertrace
