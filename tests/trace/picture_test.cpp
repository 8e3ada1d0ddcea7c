// SPDX-License-Identifier: MIT
// Pictures in every format that is read: whole, cut short, damaged, and with headers that promise too much.

#include "told_problem.h"

#include <rastertrace/trace/picture/picture.h>
#include <rastertrace/trace/picture/picture_trace.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/text.h>

#include <gtest/gtest.h>

#include <png.h>
#include <zlib.h>

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using namespace std::string_literals;
using Levels = std::vector<unsigned>;

/// A picture as text: its colors as #rrggbbaa, a row a line.
std::string colors_of(const Picture& picture) {
    std::string text;
    for (int row = 0; row < picture.height; ++row)
        for (int x = 0; x < picture.width; ++x) {
            std::array<char, 12> hex{};
            const Color color = picture.at(x, row);
            std::snprintf(hex.data(), hex.size(), "%02x%02x%02x%02x%c", color.red(), color.green(),
                          color.blue(), color.alpha(), x + 1 < picture.width ? ' ' : '\n');
            text += hex.data();
        }
    return text;
}

std::string read_as(const std::string& name, const std::string& bytes) {
    const auto picture = read_picture({name, bytes});
    return picture ? colors_of(picture.value()) : to_text(picture.problem());
}
std::string read(const std::string& bytes) {
    return read_as("picture", bytes);
}

void expect_refusal(const std::string& text, const std::string& message) {
    EXPECT_EQ(read(text), told_problem(text, message));
}

/// What is drawn of a picture without colors.
std::string drawn_in(const std::string& bytes) {
    const auto picture = read_picture({"picture", bytes});
    if (!picture)
        return to_text(picture.problem());
    EXPECT_FALSE(picture.value().has_colors);
    return joined(picture_rows(picture.value()), "\n") + "\n";
}

std::string words(std::initializer_list<unsigned> numbers) {
    std::string bytes;
    for (const unsigned number : numbers)
        bytes += {static_cast<char>(number & 255), static_cast<char>(number >> 8)};
    return bytes;
}

std::uint8_t nearest(unsigned level, unsigned most) {
    return static_cast<std::uint8_t>(std::lround(level * 255.0 / most));
}

// ---- PNG, written by libpng.

struct PngKind {
    int type;
    int bits;
    bool is_interlaced = false;
    bool has_clear_color = false; ///< tRNS
    double gamma = 0;             ///< of a chunk gAMA, if it is not 0
};

std::size_t channels_of(int type) {
    switch (type) {
    case PNG_COLOR_TYPE_GRAY_ALPHA:
        return 2;
    case PNG_COLOR_TYPE_RGB:
        return 3;
    case PNG_COLOR_TYPE_RGB_ALPHA:
        return 4;
    default:
        return 1;
    }
}

Color palette_color(unsigned index) {
    return {static_cast<std::uint8_t>(17 * index), static_cast<std::uint8_t>(255 - index),
            static_cast<std::uint8_t>(3 * index + 1), static_cast<std::uint8_t>(255 - 13 * index)};
}

/// `levels` are samples of `kind.bits` bits, pixel after pixel.
std::string png_with(const PngKind& kind, std::size_t width, std::size_t height,
                     const Levels& levels) {
    // A byte for each sample, which libpng packs, or two.
    std::vector<png_byte> bytes;
    for (const unsigned level : levels) {
        if (kind.bits == 16)
            bytes.push_back(static_cast<png_byte>(level >> 8U));
        bytes.push_back(static_cast<png_byte>(level & 255U));
    }
    std::vector<png_bytep> rows;
    for (std::size_t y = 0; y < height; ++y)
        rows.push_back(bytes.data() + y * bytes.size() / height);

    std::string file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &file,
        [](png_structp writer, png_bytep data, std::size_t size) {
            const auto* const text = reinterpret_cast<const char*>(data);
            static_cast<std::string*>(png_get_io_ptr(writer))->append(text, size);
        },
        nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height),
                 kind.bits, kind.type,
                 kind.is_interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    std::vector<png_color> palette;
    std::vector<png_byte> alphas;
    for (unsigned i = 0; kind.type == PNG_COLOR_TYPE_PALETTE && i < 1U << kind.bits; ++i) {
        const Color color = palette_color(i);
        palette.push_back({color.red(), color.green(), color.blue()});
        alphas.push_back(color.alpha());
    }
    if (!palette.empty())
        png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    png_color_16 clear{};
    clear.gray = clear.red = static_cast<png_uint_16>(levels[0]);
    if (kind.type == PNG_COLOR_TYPE_RGB) {
        clear.green = static_cast<png_uint_16>(levels[1]);
        clear.blue = static_cast<png_uint_16>(levels[2]);
    }
    if (kind.has_clear_color)
        png_set_tRNS(png, info, alphas.data(), static_cast<int>(alphas.size()),
                     palette.empty() ? &clear : nullptr);
    if (kind.gamma != 0)
        png_set_gAMA(png, info, kind.gamma);
    png_set_rows(png, info, rows.data());
    png_write_png(png, info, PNG_TRANSFORM_PACKING, nullptr);
    png_destroy_write_struct(&png, &info);
    return file;
}

Picture expected_of(const PngKind& kind, int width, int height, const Levels& levels) {
    const std::size_t channels = channels_of(kind.type);
    Picture picture{width, height, Colors(levels.size() / channels)};
    const unsigned most = (1U << static_cast<unsigned>(kind.bits)) - 1;
    for (std::size_t i = 0; i < levels.size(); i += channels) {
        const bool is_clear =
            kind.has_clear_color &&
            std::equal(levels.begin(), levels.begin() + static_cast<int>(channels),
                       levels.begin() + static_cast<int>(i));
        const std::uint8_t alpha = is_clear ? 0 : 255;
        const auto level = [&](std::size_t channel) { return nearest(levels[i + channel], most); };
        Color& pixel = picture.pixels[i / channels];
        if (kind.type == PNG_COLOR_TYPE_PALETTE) {
            const Color c = palette_color(levels[i]);
            pixel = {c.red(), c.green(), c.blue(),
                     kind.has_clear_color ? c.alpha() : std::uint8_t{255}};
        } else if (channels <= 2) {
            pixel = {level(0), level(0), level(0), channels == 2 ? level(1) : alpha};
        } else {
            pixel = {level(0), level(1), level(2), channels == 4 ? level(3) : alpha};
        }
    }
    return picture;
}

std::vector<PngKind> all_kinds_of_png() {
    std::vector<PngKind> kinds;
    for (const bool is_interlaced : {false, true})
        for (const bool has_clear_color : {false, true})
            for (const int type : {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_PALETTE, PNG_COLOR_TYPE_RGB,
                                   PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB_ALPHA})
                for (const int bits : {1, 2, 4, 8, 16}) {
                    const bool has_few =
                        type == PNG_COLOR_TYPE_GRAY || type == PNG_COLOR_TYPE_PALETTE;
                    const bool has_alpha = (type & PNG_COLOR_MASK_ALPHA) != 0;
                    if ((bits >= 8 || has_few) && !(bits == 16 && type == PNG_COLOR_TYPE_PALETTE) &&
                        !(has_alpha && has_clear_color))
                        kinds.push_back({type, bits, is_interlaced, has_clear_color});
                }
    return kinds;
}

TEST(PictureFile, PngOfEveryKind) {
    std::mt19937 random(1);
    for (const PngKind& kind : all_kinds_of_png())
        for (const auto& [width, height] : {std::pair(1, 1), std::pair(3, 2), std::pair(13, 11)}) {
            Levels levels(static_cast<std::size_t>(width * height) * channels_of(kind.type));
            for (unsigned& level : levels)
                level = static_cast<unsigned>(random() &
                                              ((1U << static_cast<unsigned>(kind.bits)) - 1));
            const std::string file = png_with(kind, static_cast<std::size_t>(width),
                                              static_cast<std::size_t>(height), levels);
            EXPECT_EQ(read(file), colors_of(expected_of(kind, width, height, levels)))
                << "type " << kind.type << ", " << kind.bits << " bits, interlaced "
                << kind.is_interlaced << ", tRNS " << kind.has_clear_color;
        }
}

TEST(PictureFile, PngOf16BitsIsRoundedToTheNearest) {
    const PngKind kind{PNG_COLOR_TYPE_GRAY, 16};
    Levels levels(65536);
    for (unsigned i = 0; i < levels.size(); ++i)
        levels[i] = i;
    EXPECT_EQ(read(png_with(kind, 256, 256, levels)),
              colors_of(expected_of(kind, 256, 256, levels)));
}

TEST(PictureFile, PngIsNotCorrectedForGamma) {
    for (const double gamma : {1.0, 0.45455, 0.1}) {
        const PngKind kind{.type = PNG_COLOR_TYPE_RGB, .bits = 8, .gamma = gamma};
        EXPECT_EQ(read(png_with(kind, 2, 1, {1, 2, 3, 100, 200, 255})), "010203ff 64c8ffff\n");
    }
}

// ---- PNM.

TEST(PictureFile, PnmAsText) {
    EXPECT_EQ(drawn_in("P1\n3 2\n0 1 0\n1 1 0\n"), ".#.\n##.\n");
    EXPECT_EQ(drawn_in("P1 # drawn by hand\n3 2 # columns, rows\n010#\n110"), ".#.\n##.\n");
    EXPECT_EQ(read("P2\n3 1\n255\n0 128 255\n"), "000000ff 808080ff ffffffff\n");
    EXPECT_EQ(read("P2 3 1 3 0 1 3"), "000000ff 555555ff ffffffff\n");
    EXPECT_EQ(read("P2 3 1 2 0 1 2"), "000000ff 808080ff ffffffff\n") << "127.5";
    EXPECT_EQ(read("P2 2 1 65535 128 65407"), "000000ff ffffffff\n");
    EXPECT_EQ(read("P2 2 1 65535 129 65406"), "010101ff fefefeff\n");
    EXPECT_EQ(read("P3\n# CREATOR: a course\r\n2 1\r\n255\r\n1 2 3\r\n4 5 6\r\n"),
              "010203ff 040506ff\n");
}

TEST(PictureFile, PnmAsBytes) {
    EXPECT_EQ(drawn_in("P4\n10 2\n\x40\x80\xBF\x7F"), ".#......#.\n#.######.#\n");
    EXPECT_EQ(read("P5\n3 1\n255\n\x01\x80\xFF"), "010101ff 808080ff ffffffff\n");
    EXPECT_EQ(read("P5 3 1 15\n\x01\x08\x0F"), "111111ff 888888ff ffffffff\n");
    EXPECT_EQ(read("P5 2 1 511\n\x01\x00\x01\xFF"s), "808080ff ffffffff\n") << "127.7";
    EXPECT_EQ(read("P6\n#\n2 1\n255\n\x0A\x20\x23\x01\x02\xFF"), "0a2023ff 0102ffff\n")
        << "the first byte is a sample, whatever it is";
    EXPECT_EQ(read("P6 1 1 65535\n\x80\x80\x00\x7F\xFF\xFFmore"s), "8000ffff\n");
}

TEST(PictureFile, PnmThatIsWrongIsToldByItsPlace) {
    expect_refusal("P3\n2 x\n255", "picture:2:3: expected a height from 1 to 16384, found \"x\"");
    expect_refusal("P3\n2 1\n255\n1 2 3\n4 256 6\n",
                   "picture:5:3: expected a sample from 0 to 255, found \"256\"");
    EXPECT_EQ(read("P3 2 3 255 1 2 3 4 5 6 7 8"),
              "picture: expected 3 rows, found 1 and then the end");
    EXPECT_EQ(read("P1 2 2 0 1 1"), "picture: expected 2 rows, found 1 and then the end");
    expect_refusal("P1 2 1 0 2", "picture:1:10: expected 0 or 1, found \"2\"");
    EXPECT_EQ(read("P5 2 3 255\nabcde"), "picture: expected 3 rows, found 2 and then the end");
    EXPECT_EQ(read("P5 2 1 15\n\x0F\x10"),
              "picture: expected samples from 0 to 15, found 16 in row 1");
    expect_refusal("P6 1 1 65536\n",
                   "picture:1:8: expected a largest sample from 1 to 65535, found \"65536\"");
    expect_refusal("P6 1", "picture:1:5: expected a height from 1 to 16384, found the end");
}

// ---- TGA, by a small writer.

struct TgaKind {
    unsigned type;
    unsigned bits;
    unsigned palette_bits = 0;
    unsigned descriptor = 0; ///< bits of alpha; 16: from the right; 32: from the top
};

std::string tga_color(Color c, unsigned bits) {
    const auto five = [](std::uint8_t level) {
        return static_cast<unsigned>(std::lround(level * 31 / 255.0));
    };
    if (bits <= 16)
        return words({five(c.blue()) | five(c.green()) << 5 | five(c.red()) << 10 |
                      (c.alpha() >= 128 ? 0x8000U : 0U)});
    std::string bytes{static_cast<char>(c.blue()), static_cast<char>(c.green()),
                      static_cast<char>(c.red())};
    if (bits == 32)
        bytes += static_cast<char>(c.alpha());
    return bytes;
}

using FourColors = std::array<Color, 4>;

/// Of levels that 5 bits have: grays, or colors, with alpha or without.
FourColors colors_of_levels(bool is_gray, bool has_alpha) {
    FourColors colors;
    for (unsigned i = 0; i < 4; ++i) {
        const auto level = [&](unsigned five) {
            return nearest((is_gray ? 1 + 9 * i : five + 9 * i * five) % 32, 31);
        };
        const std::uint8_t alpha = has_alpha && i % 2 == 1 ? 0 : 255;
        colors[i] = Color(level(1), level(7), level(12), alpha);
    }
    return colors;
}

/// Four columns and two rows of them, A A A B and B C D A, from the corner that a descriptor names on.
std::string picture_of(const FourColors& colors, unsigned descriptor = 32) {
    constexpr std::array<std::size_t, 8> places{0, 0, 0, 1, 1, 2, 3, 0};
    const std::size_t other_column = (descriptor & 16) != 0 ? 3 : 0;
    const std::size_t other_row = (descriptor & 32) != 0 ? 0 : 4;
    Picture picture{4, 2, Colors(places.size())};
    for (std::size_t i = 0; i < places.size(); ++i)
        picture.pixels[i] = colors[places[i ^ other_column ^ other_row]];
    return colors_of(picture);
}

/// With runs, packets of three, of two over the end of a row, and of three pixels by themselves.
std::string tga_with(const TgaKind& kind, const FourColors& colors) {
    constexpr unsigned first_of_palette = 5;
    const bool has_palette = kind.palette_bits != 0;
    std::array<std::string, 4> p;
    for (std::size_t i = 0; i < 4; ++i)
        p[i] = kind.type % 8 == 1   ? std::string(1, static_cast<char>(first_of_palette + i))
               : kind.type % 8 == 3 ? std::string(1, static_cast<char>(colors[i].red()))
                                    : tga_color(colors[i], kind.bits);
    std::string file{4, static_cast<char>(has_palette ? 1 : 0), static_cast<char>(kind.type)};
    file += words({has_palette ? first_of_palette : 0, has_palette ? 4U : 0U});
    file += static_cast<char>(kind.palette_bits);
    file += words({0, 0, 4, 2});
    file += {static_cast<char>(kind.bits), static_cast<char>(kind.descriptor)};
    file += "name";
    for (const Color color : colors)
        file += has_palette ? tga_color(color, kind.palette_bits) : "";
    return file + (kind.type >= 8 ? "\x82" + p[0] + "\x81" + p[1] + "\x02" + p[2] + p[3] + p[0]
                                  : p[0] + p[0] + p[0] + p[1] + p[1] + p[2] + p[3] + p[0]);
}

TEST(PictureFile, TgaOfEveryKind) {
    for (const unsigned runs : {0U, 8U})
        for (const unsigned corner : {0U, 16U, 32U, 48U}) {
            std::vector<TgaKind> kinds{{3 + runs, 8, 0, corner}};
            for (const unsigned bits : {15U, 16U, 24U, 32U}) {
                const unsigned alpha = bits == 16 ? 1 : bits == 32 ? 8 : 0;
                kinds.push_back({2 + runs, bits, 0, corner | alpha});
                kinds.push_back({1 + runs, 8, bits, corner | alpha});
            }
            for (const TgaKind& kind : kinds) {
                const bool has_alpha = (kind.descriptor & 15) != 0;
                const FourColors colors = colors_of_levels(kind.type % 8 == 3, has_alpha);
                EXPECT_EQ(read_as("a.TGA", tga_with(kind, colors)), picture_of(colors, corner))
                    << "type " << kind.type << ", " << kind.bits << " bits, palette of "
                    << kind.palette_bits << ", descriptor " << kind.descriptor;
            }
        }
}

TEST(PictureFile, TgaIsRecognizedByItsEnd) {
    const FourColors colors = colors_of_levels(false, false);
    const std::string file = tga_with({2, 24, 0, 32}, colors);
    const std::string footer = std::string(8, '\0') + "TRUEVISION-XFILE."s + '\0';
    EXPECT_EQ(read(file + footer), picture_of(colors));
    EXPECT_EQ(picture_format({"a", file}), std::nullopt);
}

TEST(PictureFile, TgaWithAlphaThatItsHeaderDoesNotTell) {
    const FourColors colors = colors_of_levels(false, true);
    EXPECT_EQ(read_as("a.tga", tga_with({2, 32, 0, 32}, colors)), picture_of(colors));

    const FourColors clear{Color(0, 0, 255, 0), Color(0, 0, 0, 0), Color(255, 0, 0, 0),
                           Color(0, 255, 0, 0)};
    FourColors opaque = clear;
    for (Color& color : opaque)
        color = Color(color.red(), color.green(), color.blue());
    EXPECT_EQ(read_as("a.tga", tga_with({2, 32, 0, 40}, clear)), picture_of(clear));
    EXPECT_EQ(read_as("a.tga", tga_with({2, 32, 0, 32}, clear)), picture_of(opaque));
    EXPECT_EQ(read_as("a.tga", tga_with({2, 16, 0, 32}, clear)), picture_of(opaque));
}

TEST(PictureFile, TgaThatIsWrongIsToldByItsPlace) {
    const FourColors colors = colors_of_levels(false, false);
    const auto with = [&](std::size_t at, char byte) {
        std::string file = tga_with({1, 8, 24}, colors);
        file[at] = byte;
        return read_as("a.tga", file);
    };
    EXPECT_EQ(read_as("a.tga", "short"), "a.tga: expected 18 bytes of a TGA at byte 0, found 5");
    EXPECT_EQ(with(1, 0), "a.tga: expected 1 for a palette at byte 1, found 0");
    EXPECT_EQ(with(2, 4),
              "a.tga: expected a type of TGA, 1, 2, 3, 9, 10 or 11, at byte 2, found 4");
    EXPECT_EQ(
        with(7, 8),
        "a.tga: expected 15, 16, 24 or 32 bits for each color of a palette at byte 7, found 8");
    EXPECT_EQ(with(16, 16), "a.tga: expected 8 bits a pixel at byte 16, found 16");
    EXPECT_EQ(with(17, '\x40'),
              "a.tga: expected rows that are not interleaved at byte 17, found 64");
    EXPECT_EQ(with(5, 1), "a.tga: expected a color of the palette at byte 25, found 197");
    EXPECT_EQ(with(14, 100), "a.tga: expected 100 rows, found 2 and then the end");
    EXPECT_EQ(read_as("a.tga", tga_with({10, 24}, colors).substr(0, 32)),
              "a.tga: expected 2 rows, found 1 and then the end");
}

// ---- Rows of text.

TEST(PictureFile, RowsOfText) {
    EXPECT_EQ(drawn_in("..#\n.##\n"), "..#\n.##\n");
    EXPECT_EQ(drawn_in("..A\r\n.B\"\r\n\r\n"), "..#\n.##\n") << "any other character is drawn";
    EXPECT_EQ(drawn_in(". . #\n. # #  \n"), "..#\n.##\n") << "a blank between columns";
    EXPECT_EQ(drawn_in("#\n."), "#\n.\n");
}

TEST(PictureFile, RowsOfTextThatAreWrongAreToldByTheirPlace) {
    expect_refusal("..#\n.##\n.#\n",
                   "picture:3:3: expected a row of 3 pixels like the first one, found 2");
    EXPECT_EQ(read("..#\n\n.##\n"),
              "picture:2:1: expected a row of 3 pixels like the first one, found 0");
    expect_refusal(". #\n# # .\n",
                   "picture:2:4: expected a row of 2 pixels like the first one, found 3");
    expect_refusal("..#\n. #\n",
                   "picture:2:2: expected . or another visible character of ASCII, found none");
    expect_refusal(". #\n.##\n",
                   "picture:2:2: expected a blank between columns as in the first row, found none");
}

TEST(PictureFile, WhatIsNoPicture) {
    for (const std::string& text :
         {""s, "\n"s, "{\"rastertrace\":1}\n"s, "# a comment\n"s, "v 0 0 0\nv 1 0 0\n"s,
          "row 3: -1/4..25/8\n"s, "y,left,right\n"s, "P7\n"s, "P9 1 1\n"s, "\x89PNG\n"s})
        EXPECT_EQ(picture_format({"a", text}), std::nullopt) << text;
    EXPECT_EQ(read("{}"), "picture: expected a picture (PNG, PPM, PGM, PBM, TGA, or rows of text), "
                          "found something else");
    EXPECT_EQ(picture_format({"a", ".#A4\n"}), PictureFormat::text_rows);
    EXPECT_EQ(picture_format({"a", "P6\n"}), PictureFormat::pnm);
    EXPECT_EQ(picture_format({"a.tga", png_with({PNG_COLOR_TYPE_GRAY, 8}, 1, 1, {1})}),
              PictureFormat::png);
}

// ---- Damage.

/// A small file of each kind; names tell the format.
std::vector<Source> small_files() {
    std::vector<Source> files;
    for (const PngKind& kind : all_kinds_of_png()) {
        Levels levels(12 * channels_of(kind.type));
        for (unsigned i = 0; i < levels.size(); ++i)
            levels[i] = i * 41 % (1U << static_cast<unsigned>(kind.bits));
        files.push_back({"a.png", png_with(kind, 4, 3, levels)});
    }
    for (const TgaKind& kind :
         {TgaKind{2, 24}, TgaKind{10, 24}, TgaKind{2, 16, 0, 49}, TgaKind{9, 8, 32, 8},
          TgaKind{1, 8, 15}, TgaKind{3, 8}, TgaKind{11, 8}})
        files.push_back({"a.tga", tga_with(kind, colors_of_levels(kind.type % 8 == 3, false))});
    for (const std::string& text :
         {"P1 4 2 0101 1 0 1 0"s, "P2 2 3 15 1 2 3 4 5 6"s, "P3\n# two\n2 1\n255\n1 200 3 4 5 6"s,
          "P4 4 2\n\x50\xA0"s, "P5 2 3 15\n\1\2\3\4\5\6"s,
          "P6 2 1 65535\n\1\2\3\4\5\6\1\2\3\4\5\6"s})
        files.push_back({"a.pnm", text});
    return files;
}

TEST(PictureFile, CutAnywhereIsAProblem) {
    for (const Source& file : small_files()) {
        const std::string whole = read_as(file.name, file.text);
        ASSERT_TRUE(read_picture(file)) << whole;
        for (std::size_t size = 0; size < file.text.size(); ++size) {
            const auto cut = read_picture({file.name, file.text.substr(0, size)});
            EXPECT_FALSE(cut) << file.name << ", " << size << " bytes of " << file.text.size();
        }
    }
    EXPECT_EQ(
        read(small_files().front().text.substr(0, 45)),
        "picture: expected 3 rows, found 0, then a fault at byte 41: the file ends too early");
}

/// Gives every chunk of a PNG its checksum.
void mend_checksums(std::string& png) {
    auto* const bytes = reinterpret_cast<png_bytep>(png.data());
    for (std::size_t at = 8; at + 12 <= png.size();) {
        const std::size_t length = png_get_uint_32(bytes + at);
        if (length > png.size() - at - 12)
            return;
        png_save_uint_32(
            bytes + at + 8 + length,
            static_cast<png_uint_32>(crc32(0, bytes + at + 4, static_cast<uInt>(length + 4))));
        at += 12 + length;
    }
}

/// Kilobytes, at the most so far.
long used_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

void expect_no_memory_since(long before) {
#ifdef RASTERTRACE_FEW_CASES
    static_cast<void>(before);
#else
    EXPECT_LT(used_memory() - before, 20'000);
#endif
}

TEST(PictureFile, HeadersThatPromiseTooMuchTakeNoMemory) {
    const long before = used_memory();
    std::string png = png_with({PNG_COLOR_TYPE_RGB, 8}, 1, 1, {1, 2, 3});
    const auto with_size = [&png](std::uint32_t width, std::uint32_t height) {
        png_save_uint_32(reinterpret_cast<png_bytep>(png.data()) + 16, width);
        png_save_uint_32(reinterpret_cast<png_bytep>(png.data()) + 20, height);
        mend_checksums(png);
        return read_as("a.png", png);
    };
    const std::string limits =
        "expected 1 to 16384 pixels a side and at most 67108864 in all, found ";
    EXPECT_EQ(with_size(60000, 60000), "a.png: " + limits + "60000 x 60000");
    EXPECT_EQ(with_size(0x7FFFFFFF, 0x7FFFFFFF), "a.png: " + limits + "2147483647 x 2147483647");
    EXPECT_EQ(with_size(16384, 16384), "a.png: " + limits + "16384 x 16384");
    EXPECT_EQ(with_size(16384, 4096).substr(0, 39), "a.png: expected 4096 rows, found 0, the");
    expect_refusal("P6 100000 100000 255\n",
                   "picture:1:4: expected a width from 1 to 16384, found \"100000\"");
    EXPECT_EQ(read("P6 16384 4096 255\n"), "picture: expected 4096 rows, found 0 and then the end");
    EXPECT_EQ(read("P3 16384 4096 255\n1"),
              "picture: expected 4096 rows, found 0 and then the end");
    EXPECT_EQ(read("P5 16384 16384 255\n"), "picture: " + limits + "16384 x 16384");
    for (const unsigned type : {2U, 10U}) {
        const std::string begin = std::string{0, 0, static_cast<char>(type)} + std::string(9, '\0');
        const std::string end{24, 0};
        EXPECT_EQ(read_as("a.tga", begin + words({65535, 65535}) + end),
                  "a.tga: " + limits + "65535 x 65535");
        EXPECT_EQ(read_as("a.tga", begin + words({16384, 4096}) + end),
                  "a.tga: expected 4096 rows, found 0 and then the end");
    }
    expect_no_memory_since(before);
}

TEST(PictureFile, PngWithHugeTextsTakesNoMemory) {
    const std::string long_text(7'000'000, ' ');
    std::string packed(8000, '\0');
    uLongf size = packed.size();
    compress(reinterpret_cast<Bytef*>(packed.data()), &size,
             reinterpret_cast<const Bytef*>(long_text.data()), long_text.size());
    packed.resize(size);
    std::string chunk = "0000zTXtComment\0\0"s + packed + "0000";
    png_save_uint_32(reinterpret_cast<png_bytep>(chunk.data()), static_cast<png_uint_32>(size + 9));
    std::string file = png_with({PNG_COLOR_TYPE_RGB, 8}, 1, 1, {1, 2, 3});
    for (int i = 0; i < 20; ++i)
        file.insert(33, chunk); // behind the header
    mend_checksums(file);

    const long before = used_memory();
    EXPECT_EQ(read(file), "010203ff\n");
    expect_no_memory_since(before);
}

/// Whatever the bytes are, there is a whole picture or a message that is safe to show.
void check_outcome(const Source& file) {
    const auto picture = read_picture(file);
    if (picture) {
        ASSERT_EQ(picture.value().pixels.size(),
                  static_cast<std::size_t>(picture.value().width) *
                      static_cast<std::size_t>(picture.value().height));
        return;
    }
    const std::string text = to_text(picture.problem());
    ASSERT_NE(text.find("expected"), std::string::npos) << text;
    ASSERT_TRUE(std::none_of(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7F;
    }));
}

TEST(PictureFile, DamagedFilesAreReadOrRefused) {
    std::mt19937 random(2);
    std::vector<Source> files = small_files();
    files.push_back({"a.txt", "..#\n.##\n###\n"});
    for (int i = 0; i < 10'000; ++i) {
        Source file = files[random() % files.size()];
        for (std::size_t changes = 1 + random() % 6; changes > 0; --changes)
            file.text[random() % file.text.size()] =
                static_cast<char>(random() % 3 == 0 ? 255 : random());
        if (random() % 8 == 0)
            file.text.resize(random() % file.text.size());
        if (random() % 4 != 0 && file.name == "a.png")
            mend_checksums(file.text);
        check_outcome(file);
    }
}

TEST(PictureFile, RandomBytesAreRefused) {
    std::mt19937 random(3);
    for (int i = 0; i < 10'000; ++i) {
        std::string bytes(random() % 200, '\0');
        for (char& byte : bytes)
            byte = static_cast<char>(random());
        const std::array beginnings{"\x89PNG\r\n\x1A\n"s, "P1 2 2 "s, "P3 "s,
                                    "P6 1 1 255\n"s,      ".#"s,      ""s};
        check_outcome(
            {random() % 2 == 0 ? "a.tga" : "a", beginnings[random() % beginnings.size()] + bytes});
    }
}

TEST(PictureFile, ReadBytesKeepsZeroBytesAndTheLimit) {
    const auto path = std::filesystem::temp_directory_path() / "rastertrace-picture-test.pgm";
    std::ofstream(path, std::ios::binary) << "P5 2 1 255\n\0\1"s;
    const auto file = read_bytes(path.string(), {});
    ASSERT_TRUE(file);
    EXPECT_EQ(read(file.value().text), "000000ff 010101ff\n");
    const auto large = read_bytes(path.string(), {.bytes = 5});
    ASSERT_FALSE(large);
    EXPECT_EQ(large.problem().message, "expected a file of at most 5 bytes, found a larger one");
    std::filesystem::remove(path);
}

} // namespace
} // namespace rastertrace
