// SPDX-License-Identifier: MIT
// What libpng reads of our PNG files.

#include <rastertrace/figures/png.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <png.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using testing::ElementsAre;

Bitmap bitmap_with(std::size_t width, std::size_t height, std::size_t colors) {
    Bitmap bitmap{.width = width, .height = height};
    for (std::size_t i = 0; i < width * height; ++i) {
        const std::size_t n = i % colors;
        bitmap.colors.push_back({static_cast<std::uint8_t>(n), static_cast<std::uint8_t>(n >> 8),
                                 static_cast<std::uint8_t>(7 * n)});
    }
    return bitmap;
}

std::vector<Color> png_read_back(const std::string& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&image, file.data(), file.size()) == 0)
        return {};
    image.format = PNG_FORMAT_RGBA;
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
    if (png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) == 0)
        return {};
    std::vector<Color> colors;
    for (std::size_t i = 0; i < bytes.size(); i += 4)
        colors.push_back({bytes[i], bytes[i + 1], bytes[i + 2], bytes[i + 3]});
    return colors;
}

/// The chunks of a file: their names and what is in them.
std::vector<std::pair<std::string, std::string>> chunks_in(const std::string& file) {
    std::vector<std::pair<std::string, std::string>> chunks;
    for (std::size_t at = 8; at + 12 <= file.size();) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i)
            length = length << 8 | static_cast<unsigned char>(file[at + i]);
        chunks.emplace_back(file.substr(at + 4, 4), file.substr(at + 8, length));
        at += 12 + length;
    }
    return chunks;
}

std::vector<std::string> chunk_names(const std::string& file) {
    std::vector<std::string> names;
    for (const auto& [name, content] : chunks_in(file))
        if (names.empty() || names.back() != name)
            names.push_back(name);
    return names;
}

TEST(Png, IsReadBackAsTheBitmap) {
    for (const std::size_t colors : {1U, 2U, 3U, 4U, 5U, 16U, 17U, 255U, 256U, 257U, 3000U})
        for (const std::size_t width : {1U, 7U, 64U}) {
            const Bitmap bitmap = bitmap_with(width, 1 + 4000 / width, colors);
            const auto png = png_of(bitmap);
            ASSERT_TRUE(png);
            EXPECT_EQ(png_read_back(png.value()), bitmap.colors) << colors << " colors";
            EXPECT_EQ(png.value(), png_of(bitmap).value());
        }
}

TEST(Png, HasAPaletteForUpTo256Colors) {
    const auto bits_and_type = [](std::size_t colors) {
        const std::string header =
            chunks_in(png_of(bitmap_with(20, 20, colors)).value()).front().second;
        return std::pair(int{header[8]}, int{header[9]});
    };
    constexpr int palette = 3;
    constexpr int rgb = 2;
    EXPECT_EQ(bits_and_type(2), std::pair(1, palette));
    EXPECT_EQ(bits_and_type(4), std::pair(2, palette));
    EXPECT_EQ(bits_and_type(16), std::pair(4, palette));
    EXPECT_EQ(bits_and_type(17), std::pair(8, palette));
    EXPECT_EQ(bits_and_type(256), std::pair(8, palette));
    EXPECT_EQ(bits_and_type(257), std::pair(8, rgb));
}

TEST(Png, HasTheTitleAndNothingElseBesidesThePicture) {
    Bitmap bitmap = bitmap_with(3, 3, 3);
    EXPECT_THAT(chunk_names(png_of(bitmap).value()), ElementsAre("IHDR", "PLTE", "IDAT", "IEND"));
    bitmap.title = "½ of a triangle\x1b";
    const std::string file = png_of(bitmap).value();
    EXPECT_THAT(chunk_names(file), ElementsAre("IHDR", "PLTE", "iTXt", "IDAT", "IEND"));
    EXPECT_EQ(chunks_in(file)[2].second,
              std::string("Title\0\0\0\0\0", 10) + "½ of a triangle<U+001B>");
}

TEST(Png, HasNoPixelsTooManyAndNotNone) {
    const auto none = png_of({});
    ASSERT_FALSE(none);
    EXPECT_EQ(to_text(none.problem()), "expected 1 to 1000000 pixels a side in a PNG, found 0 x 0");
    const auto wide = png_of(bitmap_with(1'000'001, 1, 1));
    ASSERT_FALSE(wide);
    EXPECT_EQ(to_text(wide.problem()),
              "expected 1 to 1000000 pixels a side in a PNG, found 1000001 x 1\n"
              "hint: a smaller --scale makes it smaller");
    const Bitmap longest = bitmap_with(1, 1'000'000, 2);
    EXPECT_EQ(png_read_back(png_of(longest).value()), longest.colors);
}

} // namespace
} // namespace rastertrace
