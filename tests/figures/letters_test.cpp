// SPDX-License-Identifier: MIT
// The letters of bitmaps.

#include <rastertrace/figures/bitmap.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

/// A label alone on a sheet, in black.
Bitmap picture_of(Label label, double scale = 1) {
    label.color = Color{0, 0, 0};
    return bitmap_of({.width = 200, .height = 80, .title = "letters", .shapes = {label}},
                     Theme::light, scale);
}

Bitmap picture_of(const std::string& text, double scale = 1) {
    return picture_of({.at = {40, 40}, .text = text}, scale);
}

/// How much of a pixel is ink, 0 to 1.
double ink_at(const Bitmap& bitmap, std::size_t x, std::size_t y) {
    return (255.0 - bitmap.at(x, y).red()) / 255;
}

/// The pixels that have ink, and how much of it all have.
struct Ink {
    std::size_t left;
    std::size_t right;
    std::size_t top;
    std::size_t bottom;
    double sum = 0;
};

Ink ink_of(const Bitmap& bitmap) {
    Ink ink{bitmap.width, 0, bitmap.height, 0};
    for (std::size_t y = 0; y < bitmap.height; ++y)
        for (std::size_t x = 0; x < bitmap.width; ++x)
            if (ink_at(bitmap, x, y) > 0) {
                ink.left = std::min(ink.left, x);
                ink.right = std::max(ink.right, x);
                ink.top = std::min(ink.top, y);
                ink.bottom = y;
                ink.sum += ink_at(bitmap, x, y);
            }
    return ink;
}

Ink ink_of(const Label& label, double scale = 1) {
    return ink_of(picture_of(label, scale));
}

// The font's own numbers, in 2048ths of its size: an I is a bar from 201 to 403, 1493 high; a hyphen one from 100 to
// 639, between the heights 479 and 643.
TEST(Letters, HaveTheOutlinesOfTheFont) {
    const Ink bar = ink_of({.at = {10, 60}, .text = "I", .size = 64}, 2);
    EXPECT_EQ(bar.left, 20U + 12);  // 201 / 16 = 12.6
    EXPECT_EQ(bar.right, 20U + 25); // 403 / 16 = 25.2
    EXPECT_EQ(bar.bottom, 119U);
    EXPECT_EQ(bar.top, 120U - 93); // 1493 / 16 = 93.3
    EXPECT_NEAR(bar.sum, 202.0 / 16 * 93, 93 / 8.0);

    const Ink hyphen = ink_of({.at = {10, 60}, .text = "-", .size = 64}, 2);
    EXPECT_EQ(hyphen.left, 20U + 6);     // 6.25
    EXPECT_EQ(hyphen.right, 20U + 39);   // 39.9
    EXPECT_EQ(hyphen.top, 120U - 41);    // 40.2
    EXPECT_EQ(hyphen.bottom, 120U - 30); // 29.9
    EXPECT_NEAR(hyphen.sum, 539.0 / 16 * 164 / 16, 8);
}

TEST(Letters, HaveTheirFeetAndTopsOnWholePixels) {
    for (const double size : {8.0, 9.0, 10.0, 11.0, 12.0, 14.0})
        for (const double scale : {1.0, 1.5, 2.0, 3.0}) {
            const auto feet = static_cast<std::size_t>(std::floor(40 * scale + 0.5)) - 1;
            const auto ink = [&](const char* letter) {
                return ink_of({.at = {40, 40}, .text = letter, .size = size}, scale);
            };
            for (const char* letter : {"H", "O", "E", "0", "8", "d", "x", "o", "e", "z"})
                EXPECT_EQ(ink(letter).bottom, feet) << letter << " " << size << " " << scale;
            for (const char* letter : {"O", "E", "0", "8", "d"})
                EXPECT_EQ(ink(letter).top, ink("H").top) << letter << " " << size << " " << scale;
            for (const char* letter : {"o", "e", "z"})
                EXPECT_EQ(ink(letter).top, ink("x").top) << letter << " " << size << " " << scale;
            EXPECT_LT(ink("H").top, ink("x").top);
            EXPECT_GT(ink("g").bottom, feet);
        }
}

TEST(Letters, ThatTheFontHasNotAreABox) {
    const Label box{.at = {40, 40}, .text = "日", .size = 20};
    const Bitmap picture = picture_of(box);
    Label other = box;
    other.text = "א";
    EXPECT_EQ(picture.colors, picture_of(other).colors);
    // Dark around, and nothing in it.
    const Ink ink = ink_of(picture);
    const std::size_t middle = (ink.left + ink.right) / 2;
    EXPECT_EQ(ink_at(picture, middle, (ink.top + ink.bottom) / 2), 0);
    EXPECT_GT(ink_at(picture, middle, ink.top + 1), 0.5);
    EXPECT_GT(ink_at(picture, middle, ink.bottom - 1), 0.1);
}

TEST(Letters, OfControlAreShownAsTheirNumbers) {
    EXPECT_EQ(picture_of("\x1b").colors, picture_of("<U+001B>").colors);
    EXPECT_EQ(picture_of("\xff").colors, picture_of("<0xFF>").colors);
}

TEST(Letters, OfOurLanguagesAreAllThereAndAllDifferent) {
    std::u32string letters;
    for (char32_t c = U'!'; c <= U'~'; ++c)
        letters += c;
    letters += U"ÀÁÂÃÄÇÈÉÊËÌÍÎÏÑÒÓÔÕÖÙÚÛÜÝŸÆŒßàáâãäçèéêëìíîïñòóôõöùúûüýÿæœ"
               U"ªº°¹²³¡¿§«»‹›“”„‘’…•·–—€µπ−×÷±≤≥≠≈√∞→←↑↓½¼¾";
    const auto utf8 = [](char32_t c) {
        std::string text;
        if (c < 0x80)
            return std::string(1, static_cast<char>(c));
        if (c < 0x800)
            text += static_cast<char>(0xC0 | c >> 6);
        else
            text = {static_cast<char>(0xE0 | c >> 12), static_cast<char>(0x80 | (c >> 6 & 0x3F))};
        return text + static_cast<char>(0x80 | (c & 0x3F));
    };
    // (In the font of fixed width, the two dashes are one.)
    for (const bool is_fixed_width : {false, true}) {
        const auto words_of = [&](char32_t c) {
            std::vector<std::uint32_t> words;
            for (const Color color :
                 picture_of({.at = {5, 10}, .text = utf8(c), .is_fixed_width = is_fixed_width}, 2)
                     .colors)
                words.push_back(color.red());
            return words;
        };
        std::map<std::vector<std::uint32_t>, std::string> seen{{words_of(U'日'), "the box"},
                                                               {words_of(U' '), "a blank"}};
        for (const char32_t c : letters) {
            if (is_fixed_width && c == U'—')
                continue;
            const auto [place, is_new] = seen.try_emplace(words_of(c), utf8(c));
            EXPECT_TRUE(is_new) << utf8(c) << " looks like " << place->second;
        }
    }
}

TEST(Letters, EndOrAreCenteredWhereTheAnchorSays) {
    for (const double scale : {1.0, 2.0, 3.0}) {
        const auto ink = [scale](Anchor anchor) {
            return ink_of({.at = {100, 30}, .text = "HIH", .anchor = anchor}, scale);
        };
        // Beside an H there is a tenth of its size: 201 / 2048.
        const auto hundred = static_cast<std::size_t>(100 * scale);
        const auto gap = static_cast<std::size_t>(scale);
        EXPECT_EQ(ink(Anchor::start).left, hundred + gap);
        EXPECT_EQ(ink(Anchor::end).right, hundred - gap - 1);
        const Ink middle = ink(Anchor::middle);
        EXPECT_NEAR(static_cast<double>(middle.left + middle.right + 1) / 2, 100 * scale, 0.5);
    }
}

TEST(Letters, OfFixedWidthAreBelowOneAnother) {
    for (const double size : {10.0, 12.0, 17.0})
        for (const char* text : {"iiiiH", "WWWWH", "    H", "1.1.H", "mm-1H"})
            EXPECT_EQ(
                ink_of({.at = {0, 30}, .text = text, .size = size, .is_fixed_width = true}).right,
                ink_of({.at = {0, 30}, .text = "HHHHH", .size = size, .is_fixed_width = true})
                    .right)
                << text << " " << size;
}

// Advances of the font: W 2025, A 1401, 1 1303; a bold W 2259.
TEST(Letters, AreAsWideAsTheFontSays) {
    EXPECT_EQ(width_of("W", 2048), 2025);
    EXPECT_EQ(width_of("A1", 2048), 1401 + 1303);
    EXPECT_EQ(width_of("W", 2048, true), 2259);
    for (const double size : {8.0, 10.0, 13.5, 20.0})
        for (const double scale : {1.0, 1.5, 2.0, 3.0})
            for (const char* text : {"WWWWWW", "0123456789", "Row 4: x = 2.5", "@", "iiii"})
                for (const bool is_bold : {false, true}) {
                    const Ink ink = ink_of(
                        {.at = {5, 30}, .text = text, .size = size, .is_bold = is_bold}, scale);
                    const double width = width_of(text, size, is_bold) * scale;
                    EXPECT_LT(static_cast<double>(ink.right), 5 * scale + width);
                    EXPECT_GE(static_cast<double>(ink.right) + 1,
                              5 * scale + width - 0.2 * size * scale);
                }
}

TEST(Letters, OfFixedWidthFitInALineOfSoMany) {
    for (const double size : {8.0, 10.0, 13.5, 20.0}) {
        const std::string line(letters_in(190, size), 'W');
        EXPECT_LT(ink_of({.at = {0, 30}, .text = line, .size = size, .is_fixed_width = true}).right,
                  190U);
        EXPECT_GT(line.size(), 0.9 * 190 / (0.602 * size));
    }
    EXPECT_EQ(letters_in(3, 10), 1U);
}

TEST(Letters, ThatAreBoldHaveMoreInkAndStayOpen) {
    for (const double scale : {1.0, 2.0}) {
        Label label{.at = {40, 40}, .text = "em"};
        const Ink regular = ink_of(label, scale);
        label.is_bold = true;
        const Bitmap bold = picture_of(label, scale);
        const Ink ink = ink_of(bold);
        EXPECT_GT(ink.sum, 1.2 * regular.sum);
        // Between the legs of the m, at its feet, there is paper.
        std::size_t gaps = 0;
        for (std::size_t x = (ink.left + ink.right) / 2; x < ink.right; ++x)
            gaps += ink_at(bold, x, ink.bottom) < 0.5 && ink_at(bold, x + 1, ink.bottom) >= 0.5;
        EXPECT_GE(gaps, 2U);
    }
}

TEST(Letters, ThatAreTurnedRunUpward) {
    Label label{.at = {50, 40}, .text = "La", .size = 15};
    const Bitmap plain = picture_of(label);
    label.is_turned = true;
    const Bitmap turned = picture_of(label);
    EXPECT_NEAR(ink_of(turned).sum, ink_of(plain).sum, 2);
    for (std::size_t along = 0; along < 30; ++along)
        for (std::size_t down = 0; down < 30; ++down)
            EXPECT_NEAR(ink_at(plain, 45 + along, 20 + down), ink_at(turned, 30 + down, 44 - along),
                        0.26)
                << along << ", " << down;
}

TEST(Letters, WithARimHaveThePaperAroundThem) {
    const Color red(255, 0, 0);
    const Label label{.at = {5, 10}, .text = "I", .has_rim = true};
    const Bitmap bitmap =
        bitmap_of({.width = 14,
                   .height = 13,
                   .title = "rim",
                   .shapes = {Areas{.color = red, .rectangles = {{{0, 0}, 14, 13}}}, label}},
                  Theme::light, 2);
    // The I is from 5.98 to 6.97 and from 3 to 10; its rim is 1.5 wide.
    for (std::size_t row = 0; row < bitmap.height; ++row)
        for (std::size_t column = 0; column < bitmap.width; ++column) {
            SCOPED_TRACE(testing::Message() << column << ", " << row);
            const double x = (static_cast<double>(column) + 0.5) / 2;
            const double y = (static_cast<double>(row) + 0.5) / 2;
            const double away =
                std::hypot(std::max({5.98 - x, x - 6.97, 0.0}), std::max({3 - y, y - 10, 0.0}));
            const Color color = bitmap.at(column, row);
            if (away > 2) {
                EXPECT_EQ(color, red);
            } else if (0.5 < away && away < 1) {
                EXPECT_EQ(color, Color(255, 255, 255));
            } else if (away == 0) {
                EXPECT_LT(color.red(), 200);
            }
        }
}

} // namespace
} // namespace rastertrace
