// SPDX-License-Identifier: MIT
// Drawings as SVG.

#include "figures/hostile_drawing.h"
#include "xml_fault.h"

#include <rastertrace/figures/bitmap.h>
#include <rastertrace/figures/svg.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <sstream>
#include <string>

namespace rastertrace {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Svg, IsXmlWhateverTheTexts) {
    std::set<std::string> scopes;
    for (const Theme theme : {Theme::automatic, Theme::light, Theme::dark}) {
        const auto svg = svg_of(hostile_drawing(), theme);
        ASSERT_TRUE(svg);
        EXPECT_EQ(xml_fault(svg.value()), "");
        EXPECT_EQ(svg.value(), svg_of(hostile_drawing(), theme).value());

        // Its rules are about itself alone: another figure in the same page has another class.
        const std::string& text = svg.value();
        const std::size_t begin = text.find("class=\"") + 7;
        const std::string scope = text.substr(begin, text.find('"', begin) - begin);
        scopes.insert(scope);
        const std::size_t style = text.find("<style>\n") + 8;
        std::istringstream rules(text.substr(style, text.find("</style>") - style));
        for (std::string rule; std::getline(rules, rule);)
            EXPECT_TRUE(rule == "}" || rule.starts_with("@media") ||
                        rule.starts_with("." + scope + " ."))
                << rule;
        EXPECT_THAT(svg.value(), Not(HasSubstr("<script")));
    }
    EXPECT_EQ(scopes.size(), 3U);
    const std::array frames{hostile_drawing(), hostile_drawing(), hostile_drawing()};
    const auto animated = animated_svg_of(frames, 0.5, Theme::automatic);
    ASSERT_TRUE(animated);
    EXPECT_EQ(xml_fault(animated.value()), "");
}

TEST(Svg, PixelsOfAColorAreRunsByColor) {
    const auto svg =
        svg_of({.width = 6,
                .height = 4,
                .title = "pixels",
                .shapes = {Pixels{.corner = {0, 0},
                                  .side = 2,
                                  .columns = 3,
                                  .colors = {Color(9, 0, 0), Color(9, 0, 0), no_color,
                                             Color(1, 0, 0), no_color, Color(9, 0, 0)}}}},
               Theme::light);
    EXPECT_THAT(svg.value(),
                HasSubstr("<path class=\"area\" style=\"fill:#010000\" d=\"M0 2h2v2h-2z\"/>\n"
                          "<path class=\"area\" style=\"fill:#090000\" "
                          "d=\"M0 0h4v2h-4zM4 2h2v2h-2z\"/>\n"));
}

TEST(Svg, KeepsBlanks) {
    const auto text_of = [](const std::string& text) {
        Label label;
        label.text = text;
        const Drawing drawing{.width = 10, .height = 10, .title = "", .shapes = {label}};
        const std::string svg = svg_of(drawing, Theme::light).value();
        const std::size_t begin = svg.find("<text");
        return svg.substr(begin, svg.find('\n', begin) - begin);
    };
    for (const std::string text : {"A  B", " A", "A "})
        EXPECT_THAT(text_of(text),
                    testing::EndsWith(R"( xml:space="preserve">)" + text + "</text>"));
    EXPECT_THAT(text_of("A B C"), testing::EndsWith(R"(font-size="10">A B C</text>)"));
}

TEST(Svg, AndBitmapHaveTheHostileDrawing) {
    const Bitmap bitmap = bitmap_of(hostile_drawing(), Theme::light, 1);
    EXPECT_EQ(bitmap.width, 400U);
    EXPECT_EQ(bitmap.title, hostile_drawing().title);
}

} // namespace
} // namespace rastertrace
