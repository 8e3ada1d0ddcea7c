// SPDX-License-Identifier: MIT
// The letters of bitmaps.

#include <rastertrace/figures/bitmap.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

namespace rastertrace {
namespace {

/// Rows of text: `#` ink, `.` paper, `+` what lies between. Without the rows and columns around it that are empty.
std::string picture_of(Label label, double scale = 1) {
    label.at = {40, 40};
    const Bitmap bitmap = bitmap_of(
        {.width = 90, .height = 80, .title = "letters", .shapes = {label}}, Theme::print, scale);
    std::vector<std::string> rows;
    std::size_t left = bitmap.width;
    std::size_t right = 0;
    for (std::size_t y = 0; y < bitmap.height; ++y) {
        std::string row;
        for (std::size_t x = 0; x < bitmap.width; ++x) {
            const int red = bitmap.at(x, y).red();
            row += red == 0 ? '#' : red == 255 ? '.' : '+';
        }
        if (row.find_first_not_of('.') == std::string::npos) {
            row.clear();
        } else {
            left = std::min(left, row.find_first_not_of('.'));
            right = std::max(right, row.find_last_not_of('.') + 1);
        }
        rows.push_back(row);
    }
    while (!rows.empty() && rows.back().empty())
        rows.pop_back();
    std::string text;
    for (const std::string& row : rows)
        if (!row.empty())
            text += row.substr(left, right - left) + '\n';
        else if (!text.empty())
            text += '\n';
    return text;
}

/// The leftmost and the rightmost column of ink, and the rows.
struct Extent {
    std::size_t left;
    std::size_t right;
    std::size_t top;
    std::size_t bottom;
};

Extent extent_of(const Label& label, double scale = 1) {
    const Bitmap bitmap = bitmap_of(
        {.width = 200, .height = 80, .title = "letters", .shapes = {label}}, Theme::print, scale);
    Extent extent{bitmap.width, 0, bitmap.height, 0};
    for (std::size_t y = 0; y < bitmap.height; ++y)
        for (std::size_t x = 0; x < bitmap.width; ++x)
            if (bitmap.at(x, y) != Color(255, 255, 255)) {
                extent.left = std::min(extent.left, x);
                extent.right = std::max(extent.right, x);
                extent.top = std::min(extent.top, y);
                extent.bottom = y;
            }
    return extent;
}

TEST(Letters, AreAsTheyWereDrawn) {
    EXPECT_EQ(picture_of({.at = {}, .text = "Age"}), "..#..............\n"
                                                     ".#.#.............\n"
                                                     "#...#..####..###.\n"
                                                     "#...#.#...#.#...#\n"
                                                     "#####.#...#.#####\n"
                                                     "#...#.#...#.#....\n"
                                                     "#...#..####..###.\n"
                                                     "..........#......\n"
                                                     ".......###.......\n");
}

TEST(Letters, HaveTheirAccents) {
    EXPECT_EQ(picture_of({.at = {}, .text = "Áãç"}), "...#.............\n"
                                                     "..#..............\n"
                                                     ".......##.#......\n"
                                                     "..#...#.##.......\n"
                                                     ".#.#.............\n"
                                                     "#...#..###...###.\n"
                                                     "#...#.....#.#...#\n"
                                                     "#####..####.#....\n"
                                                     "#...#.#...#.#...#\n"
                                                     "#...#..####..###.\n"
                                                     "..............#..\n"
                                                     ".............##..\n");
}

TEST(Letters, ThatTheFontHasNotAreABox) {
    const std::string box = "#####\n"
                            "#...#\n"
                            "#...#\n"
                            "#...#\n"
                            "#...#\n"
                            "#...#\n"
                            "#####\n";
    EXPECT_EQ(picture_of({.at = {}, .text = "日"}), box);
    EXPECT_EQ(picture_of({.at = {}, .text = "א"}), box);
}

TEST(Letters, OfControlAreShownAsTheirNumbers) {
    EXPECT_EQ(picture_of({.at = {}, .text = "\x1b"}), picture_of({.at = {}, .text = "<U+001B>"}));
    EXPECT_EQ(picture_of({.at = {}, .text = "\xff"}), picture_of({.at = {}, .text = "<0xFF>"}));
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
    const auto row_and_shape = [&utf8](char32_t c) {
        // An H beside it: letters may differ in their place alone.
        return picture_of({.at = {}, .text = "H" + utf8(c), .is_fixed_width = true});
    };
    std::map<std::string, std::string> seen{{row_and_shape(U'日'), "the box"}};
    for (const char32_t c : letters) {
        const auto [place, is_new] = seen.try_emplace(row_and_shape(c), utf8(c));
        EXPECT_TRUE(is_new) << utf8(c) << " looks like " << place->second;
        EXPECT_NE(picture_of({.at = {}, .text = utf8(c)}), "") << utf8(c);
    }
}

TEST(Letters, OfManyPixelsAreStrokesOfEqualWidth) {
    EXPECT_EQ(picture_of({.at = {}, .text = "Hx"}, 2), "##......##............\n"
                                                       "##......##............\n"
                                                       "##......##............\n"
                                                       "##......##............\n"
                                                       "##......##..##+....+##\n"
                                                       "##......##..##++..++##\n"
                                                       "##########..++##++##++\n"
                                                       "##########...+##++##+.\n"
                                                       "##......##....++##++..\n"
                                                       "##......##....++##++..\n"
                                                       "##......##...+##++##+.\n"
                                                       "##......##..++##++##++\n"
                                                       "##......##..##++..++##\n"
                                                       "##......##..##+....+##\n");
}

TEST(Letters, StandOnTheirLineAndBeginAtTheirPlace) {
    const Extent extent = extent_of({.at = {20, 30}, .text = "H"});
    EXPECT_EQ(extent.left, 20U);
    EXPECT_EQ(extent.bottom, 29U);
    EXPECT_EQ(extent.top, 23U);
}

TEST(Letters, EndOrAreCenteredWhereTheAnchorSays) {
    for (const double scale : {1.0, 2.0, 3.0}) {
        const Extent start = extent_of({.at = {100, 30}, .text = "HIH"}, scale);
        const Extent end =
            extent_of({.at = {100, 30}, .text = "HIH", .anchor = Anchor::end}, scale);
        const Extent middle =
            extent_of({.at = {100, 30}, .text = "HIH", .anchor = Anchor::middle}, scale);
        const auto hundred = static_cast<std::size_t>(100 * scale);
        EXPECT_EQ(start.left, hundred);
        EXPECT_EQ(end.right, hundred - 1);
        EXPECT_LE(middle.left + middle.right, 2 * hundred + 1);
        EXPECT_GE(middle.left + middle.right + 2, 2 * hundred);
    }
}

TEST(Letters, OfFixedWidthAreBelowOneAnother) {
    for (const double size : {10.0, 12.0, 17.0})
        for (const char* text : {"iiiiH", "WWWWH", "    H", "1.1.H", "mm-1H"})
            EXPECT_EQ(
                extent_of({.at = {0, 30}, .text = text, .size = size, .is_fixed_width = true})
                    .right,
                extent_of({.at = {0, 30}, .text = "HHHHH", .size = size, .is_fixed_width = true})
                    .right)
                << text << " " << size;
}

TEST(Letters, AreNoWiderThanWidthOfSays) {
    for (const double size : {8.0, 9.0, 10.0, 11.0, 12.0, 13.5, 14.0, 16.0, 20.0})
        for (const double scale : {1.0, 1.5, 2.0, 3.0})
            for (const char* text : {"WWWWWWWW", "0123456789", "Row 4: x = 2.5", "@", "iiii"})
                for (const bool is_fixed : {false, true})
                    EXPECT_LE(static_cast<double>(extent_of({.at = {0, 30},
                                                             .text = text,
                                                             .size = size,
                                                             .is_fixed_width = is_fixed},
                                                            scale)
                                                      .right),
                              width_of(text, size) * scale)
                        << text << " " << size << " " << scale;
}

TEST(Letters, ThatAreBoldAreWiderAndStayOpen) {
    EXPECT_EQ(picture_of({.at = {}, .text = "em", .is_bold = true}), ".####..##.##.\n"
                                                                     "##..##.#.#.##\n"
                                                                     "######.#.#.##\n"
                                                                     "##.....#.#.##\n"
                                                                     ".####..#.#.##\n");
}

TEST(Letters, ThatAreTurnedRunUpward) {
    const Label label{.at = {}, .text = "La"};
    Label turned = label;
    turned.is_turned = true;
    EXPECT_EQ(picture_of(label), "#..........\n"
                                 "#..........\n"
                                 "#......###.\n"
                                 "#.........#\n"
                                 "#......####\n"
                                 "#.....#...#\n"
                                 "#####..####\n");
    EXPECT_EQ(picture_of(turned), "...####\n"
                                  "..#.#.#\n"
                                  "..#.#.#\n"
                                  "..#.#.#\n"
                                  ".....#.\n"
                                  "\n"
                                  "......#\n"
                                  "......#\n"
                                  "......#\n"
                                  "......#\n"
                                  "#######\n");
}

TEST(Letters, WithARimHaveThePaperAroundThem) {
    const Label label{.at = {5, 10}, .text = "I", .has_rim = true};
    const Bitmap bitmap = bitmap_of(
        {.width = 14,
         .height = 13,
         .title = "rim",
         .shapes = {Areas{.color = Color(255, 0, 0), .rectangles = {{{0, 0}, 14, 13}}}, label}},
        Theme::print, 1);
    std::string text;
    for (std::size_t y = 0; y < bitmap.height; ++y) {
        for (std::size_t x = 0; x < bitmap.width; ++x)
            text += bitmap.at(x, y) == Color(255, 0, 0) ? 'r'
                    : bitmap.at(x, y) == Color(0, 0, 0) ? '#'
                                                        : '.';
        text += '\n';
    }
    EXPECT_EQ(text, "rrrrrrrrrrrrrr\n"
                    "rrrrrrrrrrrrrr\n"
                    "rrrr.....rrrrr\n"
                    "rrrr.###.rrrrr\n"
                    "rrrr..#..rrrrr\n"
                    "rrrrr.#.rrrrrr\n"
                    "rrrrr.#.rrrrrr\n"
                    "rrrrr.#.rrrrrr\n"
                    "rrrr..#..rrrrr\n"
                    "rrrr.###.rrrrr\n"
                    "rrrr.....rrrrr\n"
                    "rrrrrrrrrrrrrr\n"
                    "rrrrrrrrrrrrrr\n");
}

} // namespace
} // namespace rastertrace
