// SPDX-License-Identifier: MIT
// A style of a document's own, in all formats of drawings.
#include "drawings.h"

#include <rastertrace/figures/bitmap.h>
#include <rastertrace/figures/house_style.h>
#include <rastertrace/figures/svg.h>
#include <rastertrace/figures/tikz.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace rastertrace {
namespace {

using testing::HasSubstr;

HouseStyle style_in(const std::string& text) {
    auto style = house_style_in({"house.json", text});
    if (!style) {
        ADD_FAILURE() << to_text(style.problem());
        return {};
    }
    return std::move(style.value());
}

std::string refusal_of(const std::string& text) {
    const auto style = house_style_in({"house.json", text});
    return style ? "" : style.problem().message;
}

Drawing styled(const std::string& style) {
    Drawing drawing{.width = 20,
                    .height = 20,
                    .title = "A test",
                    .shapes = {Label{.at = {1, 19}, .text = "A(0.5, 2)"},
                               Lines{.role = Role::true_edge, .paths = {{{0, 10}, {20, 10}}}},
                               Dots{.role = Role::vertex, .radius = 1, .centers = {{10, 4}}},
                               Areas{.role = Role::plotted,
                                     .color = Color{1, 2, 3},
                                     .rectangles = {{{0, 16}, 4, 4}}}}};
    apply(style_in(style), drawing);
    return drawing;
}

TEST(HouseStyle, HoldsForAllFormats) {
    const Drawing drawing = styled(R"({"true-edge": {"color": "#ff0000", "width": 4},
        "vertex": {"color": "#00ff00", "radius": 3}, "plotted": {"color": "#0000ff"}})");
    const std::string svg = svg_of(drawing, Theme::light).value();
    EXPECT_THAT(svg, HasSubstr("style=\"stroke:#ff0000;stroke-width:4\""));
    EXPECT_THAT(svg, HasSubstr("style=\"fill:#00ff00\" d=\"M7 4a3 3"));
    EXPECT_THAT(svg, HasSubstr("style=\"fill:#010203\"")) << "a color of its own stays";
    const std::string tex = tikz_of(drawing, Theme::light, 20).value();
    EXPECT_THAT(tex, HasSubstr("[rt-line true-edge,draw=rt-FF0000,line width=4mm]"));
    EXPECT_THAT(tex, HasSubstr("\\fill[rt-00FF00] (10,4) circle[radius=3mm]"));
    const auto bitmap = bitmap_of(drawing, Theme::light, 1);
    const auto at = [&](std::size_t x, std::size_t y) {
        return bitmap.colors[y * bitmap.width + x];
    };
    EXPECT_EQ(at(10, 9), (Color{255, 0, 0}));
    EXPECT_EQ(at(10, 11), (Color{255, 0, 0}));
    EXPECT_EQ(at(10, 4), (Color{0, 255, 0}));
    EXPECT_EQ(at(1, 17), (Color{1, 2, 3}));
}

TEST(HouseStyle, CommasLeaveCoordinatesApart) {
    const auto text = [](const std::string& style) {
        return texts_of(styled(style), Role::text).front();
    };
    EXPECT_EQ(text(R"({"decimal": ","})"), "A(0,5; 2)");
    EXPECT_EQ(text(R"({"decimal": "."})"), "A(0.5, 2)");
    Drawing whole{
        .width = 9, .height = 9, .title = {}, .shapes = {Label{.at = {}, .text = "A(1, 2)."}}};
    apply(style_in(R"({"decimal": ","})"), whole);
    EXPECT_EQ(texts_of(whole, Role::text).front(), "A(1, 2).");
}

TEST(HouseStyle, WhatIsWrongIsTold) {
    EXPECT_EQ(
        refusal_of("[]"),
        R"(expected a style, like {"true-edge": {"color": "#003366"}}, found an empty array)");
    EXPECT_THAT(refusal_of(R"({"true-edges": {}})"),
                HasSubstr("expected decimal, or the role of a shape, as an .svg has it, found"));
    EXPECT_THAT(refusal_of(R"({"true-edge": {"colour": "#000000"}})"), HasSubstr("colour"));
    EXPECT_THAT(refusal_of(R"({"true-edge": {"color": "rad"}})"),
                HasSubstr(R"(expected a color, like "#003366", found "rad")"));
    for (const std::string width : {"0", "-1", "101", "\"2\""})
        EXPECT_THAT(refusal_of(R"({"grid": {"width": )" + width + "}}"),
                    HasSubstr("expected a number above 0, at most 100, found"))
            << width;
    EXPECT_THAT(refusal_of(R"({"decimal": ";"})"), HasSubstr(R"(expected "." or ",", found ";")"));
    EXPECT_NE(refusal_of("{"), "");
}

} // namespace
} // namespace rastertrace
