// SPDX-License-Identifier: MIT
// Plots, from data made by hand.

#include "xml_fault.h"

#include <rastertrace/numerics/plot_svg.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace rastertrace {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A character in UTF-8, as a program might write it that checks nothing.
std::string utf8(char32_t c) {
    if (c < 0x80)
        return {static_cast<char>(c)};
    const auto part = [c](int shift) { return static_cast<char>(0x80 | (c >> shift & 0x3F)); };
    if (c < 0x800)
        return {static_cast<char>(0xC0 | c >> 6), part(0)};
    if (c < 0x10000)
        return {static_cast<char>(0xE0 | c >> 12), part(6), part(0)};
    return {static_cast<char>(0xF0 | c >> 18), part(12), part(6), part(0)};
}

// Char of XML 1.0, section 2.2: all but most control characters, surrogates, U+FFFE and U+FFFF.
TEST(Escaped, IsXmlWhateverTheCharacter) {
    for (char32_t c = 0; c <= 0x10FFFF; ++c) {
        const bool is_xml = c == 0x9 || c == 0xA || c == 0xD || (0x20 <= c && c <= 0xD7FF) ||
                            (0xE000 <= c && c <= 0xFFFD) || 0x10000 <= c;
        const std::string text = escaped(utf8(c));
        const bool is_markup = c == '&' || c == '<' || c == '>' || c == '"' || c == '\'';
        if (text != utf8(c) && !is_markup) {
            ASSERT_THAT(text, testing::MatchesRegex("(&lt;[U0][+x][0-9A-F]+&gt;)+"));
        } else {
            ASSERT_TRUE(is_xml) << text;
        }
    }
}

TEST(PlotSvg, TheCheckItselfSeesFaults) {
    EXPECT_EQ(xml_fault("<a b=\"1\"><c/>x &amp; y</a>"), "");
    EXPECT_NE(xml_fault("<a><b></a></b>"), "");
    EXPECT_NE(xml_fault("<a>x & y</a>"), "");
    EXPECT_NE(xml_fault("<a>"), "");
}

Plot hand_made() {
    return {.title = "errors",
            .x_label = "px",
            .y_label = "ns",
            .curves = {{"one",
                        {{.x = 0, .y = 2, .label = "exact", .is_on_front = true},
                         {.x = 1e-7, .y = 1, .label = "float"}}},
                       {"two", {{.x = 0.5, .y = 30, .label = "4"}}}},
            .caption = "Choose one."};
}

TEST(PlotSvg, AnErrorOf0StandsOnTheShelf) {
    const std::string svg = svg_document(plot_size, "t", plot_svg(hand_made()));
    EXPECT_EQ(xml_fault(svg), "");
    EXPECT_THAT(svg, HasSubstr(">0</text>"));
    // The shelf begins at the axis, 58 pixels in; its first column is 13 further on.
    EXPECT_THAT(svg, HasSubstr(R"(<circle class="front" cx="71.0")"));
    EXPECT_THAT(svg, HasSubstr(">exact</text>"));
}

TEST(PlotSvg, AnythingInATitleIsText) {
    Plot plot = hand_made();
    plot.title = "</text><script>alert(1)</script>\" onload='x' ]]> & \x01\xff";
    plot.curves[0].name = plot.curves[0].marks[0].label = plot.caption = plot.title;
    const std::string svg =
        svg_document(plot_size, plot.title, plot_svg(plot) + legend_svg(plot.curves));
    EXPECT_EQ(xml_fault(svg), "");
    EXPECT_THAT(svg, Not(HasSubstr("<script")));
    EXPECT_THAT(svg, HasSubstr("&lt;/text&gt;&lt;script&gt;"));
}

TEST(PlotSvg, APlotWithoutMarksOrWithoutErrorsIsAPlot) {
    Plot plot = hand_made();
    plot.curves[0].marks.pop_back();
    plot.curves.pop_back();
    EXPECT_THAT(plot_svg(plot), HasSubstr("no method has an error here"));
    plot.curves.clear();
    EXPECT_EQ(xml_fault(svg_document(plot_size, "", plot_svg(plot))), "");
    EXPECT_THAT(plot_svg(plot), Not(HasSubstr("nan")));
}

} // namespace
} // namespace rastertrace
