// SPDX-License-Identifier: MIT
// Plots, from data made by hand.

#include "label_places.h"
#include "xml_fault.h"

#include <rastertrace/figures/plot.h>
#include <rastertrace/figures/svg.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

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

TEST(Svg, TheCheckItselfSeesFaults) {
    EXPECT_EQ(xml_fault("<a b=\"1\"><c/>x &amp; y</a>"), "");
    EXPECT_NE(xml_fault("<a><b></a></b>"), "");
    EXPECT_NE(xml_fault("<a>x & y</a>"), "");
    EXPECT_NE(xml_fault("<a>"), "");
}

Plot hand_made() {
    return {.title = "errors",
            .x = {.label = "px"},
            .y = {.label = "ns"},
            .curves = {{"one",
                        {{.x = 0, .y = 2, .label = "exact", .is_on_front = true},
                         {.x = 1e-7, .y = 1, .label = "float"}}},
                       {"two", {{.x = 0.5, .y = 30, .label = "4"}}}},
            .caption = "Choose one.",
            .only_shelf = "no method has an error here"};
}

std::string svg_text(const Drawing& drawing) {
    return svg_of(drawing, Theme::automatic).value();
}

template <typename AShape> std::vector<AShape> shapes_of(const Drawing& drawing) {
    std::vector<AShape> shapes;
    for (const Shape& shape : drawing.shapes)
        if (const auto* one = std::get_if<AShape>(&shape))
            shapes.push_back(*one);
    return shapes;
}

/// The labels with this text.
std::vector<Label> labels_with(const Drawing& drawing, std::string_view text) {
    auto labels = shapes_of<Label>(drawing);
    std::erase_if(labels, [text](const Label& label) { return label.text != text; });
    return labels;
}
Label label_with(const Drawing& drawing, std::string_view text) {
    const auto labels = labels_with(drawing, text);
    return labels.size() == 1 ? labels[0] : throw std::runtime_error("no such label, or many");
}

/// What is taken on a sheet.
struct Rect {
    double left, top, right, bottom;
    bool meets(const Rect& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

/// Where a label stands.
Rect rect_of(const Label& label) {
    const double width = width_of(label.text, label.size);
    const double left = label.anchor == Anchor::start    ? label.at.x
                        : label.anchor == Anchor::middle ? label.at.x - width / 2
                                                         : label.at.x - width;
    if (label.is_turned)
        return {label.at.x - label.size, label.at.y - width / 2, label.at.x,
                label.at.y + width / 2};
    return {left, label.at.y - 0.8 * label.size, left + width, label.at.y + 0.2 * label.size};
}

/// The labels of marks, which have a rim.
std::vector<Rect> rects_of_mark_labels(const Drawing& drawing) {
    std::vector<Rect> rects;
    for (const Label& label : shapes_of<Label>(drawing))
        if (label.has_rim)
            rects.push_back(rect_of(label));
    return rects;
}

/// A rectangle around everything that is drawn with a path or a text.
Rect extent_of(const Drawing& drawing) {
    Rect all{drawing.width, drawing.height, 0, 0};
    const auto add = [&all](const Rect& one) {
        all = {std::min(all.left, one.left), std::min(all.top, one.top),
               std::max(all.right, one.right), std::max(all.bottom, one.bottom)};
    };
    for (const Label& label : shapes_of<Label>(drawing))
        add(rect_of(label));
    for (const Lines& lines : shapes_of<Lines>(drawing))
        for (const Path& path : lines.paths)
            for (const Place& place : path)
                add({place.x, place.y, place.x, place.y});
    return all;
}

void expect_labels_apart(const Drawing& drawing) {
    const auto labels = rects_of_mark_labels(drawing);
    for (std::size_t i = 0; i < labels.size(); ++i)
        for (std::size_t j = i + 1; j < labels.size(); ++j)
            EXPECT_FALSE(labels[i].meets(labels[j])) << i << " and " << j;
    // Circles are dots; a mark of each curve begins as one or as a polygon around its place.
    std::vector<Place> marks;
    for (const Dots& dots : shapes_of<Dots>(drawing))
        marks.insert(marks.end(), dots.centers.begin(), dots.centers.end());
    for (const Place& mark : marks)
        for (const Rect& label : labels)
            EXPECT_FALSE(label.meets({mark.x - 3, mark.y - 3, mark.x + 3, mark.y + 3}))
                << mark.x << ", " << mark.y;
}

TEST(Plot, AnErrorOf0StandsOnTheShelf) {
    const Drawing drawing = plot_drawing(hand_made());
    const auto shelf = shapes_of<Areas>(drawing).at(0).rectangles.at(0);
    const Label exact = label_with(drawing, "exact");
    const auto marks = shapes_of<Dots>(drawing);
    ASSERT_EQ(marks.size(), 2U) << "the second curve has squares";
    EXPECT_LT(shelf.corner.x, marks[0].centers[0].x);
    EXPECT_LT(marks[0].centers[0].x, shelf.corner.x + shelf.width);
    EXPECT_LT(shelf.corner.x + shelf.width, marks[1].centers[0].x);
    EXPECT_EQ(label_with(drawing, "0").at.x, shelf.corner.x + shelf.width / 2);
    EXPECT_NE(exact.at.x, 0);
    EXPECT_EQ(xml_fault(svg_text(drawing)), "");
}

TEST(Plot, AnythingInATitleIsText) {
    Plot plot = hand_made();
    plot.title = "</text><script>alert(1)</script>\" onload='x' ]]> & \x01\xff";
    plot.curves[0].name = plot.curves[0].marks[0].label = plot.caption = plot.title;
    for (const Drawing& drawing : {plot_drawing(plot), legend_drawing(plot)}) {
        const std::string svg = svg_text(drawing);
        EXPECT_EQ(xml_fault(svg), "");
        EXPECT_THAT(svg, Not(HasSubstr("<script")));
        EXPECT_THAT(svg, HasSubstr("&lt;script&gt;"));
    }
}

TEST(Plot, APlotWithoutMarksOrWithoutErrorsIsAPlot) {
    Plot plot = hand_made();
    plot.curves[0].marks.pop_back();
    plot.curves.pop_back();
    EXPECT_EQ(labels_with(plot_drawing(plot), "no method has an error here").size(), 1U);
    plot.curves.clear();
    const std::string svg = svg_text(plot_drawing(plot));
    EXPECT_EQ(xml_fault(svg), "");
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

/// As bad as it gets: every curve has its marks within a few pixels of all others.
Plot crowded(std::size_t curves, std::size_t marks) {
    Plot plot = hand_made();
    plot.curves = {{"wide", {{.x = 1e-9, .y = 0.1, .label = ""}, {.x = 1, .y = 1000}}}};
    for (std::size_t i = 0; i < curves; ++i) {
        PlotCurve& curve = plot.curves.emplace_back();
        curve.name = "curve " + std::to_string(i);
        for (std::size_t k = 0; k < marks; ++k)
            curve.marks.push_back({.x = k % 2 == 0 ? 0 : 1e-5 * (1 + 0.9 * static_cast<double>(k)),
                                   .y = 2 + 0.03 * static_cast<double>(i + 20 * k),
                                   .label = std::to_string(i) + "/" + std::to_string(k),
                                   .is_on_front = k == 1});
    }
    return plot;
}

TEST(Plot, NoLabelCoversAnotherOneOrAMarkAndNoneIsDropped) {
    const Plot plot = crowded(9, 5);
    const Drawing drawing = plot_drawing(plot);
    expect_labels_apart(drawing);
    std::string all;
    for (const Label& label : shapes_of<Label>(drawing))
        if (label.has_rim)
            all += ", " + label.text + ",";
    for (const PlotCurve& curve : plot.curves)
        for (const PlotMark& mark : curve.marks)
            EXPECT_THAT(all, HasSubstr(" " + mark.label + (mark.label.empty() ? "" : ",")));
}

TEST(Plot, ALabelIsAnchoredAtTheSideOfItsMark) {
    const Place mark{10, 5};
    const auto anchored = [mark](double left, double right) {
        const LabelAnchor there = anchor_beside(mark, {{left, 0}, right - left, 10});
        return std::pair(there.x, there.anchor);
    };
    EXPECT_EQ(anchored(2, 8), std::pair(8.0, Anchor::end));
    EXPECT_EQ(anchored(2, 10), std::pair(10.0, Anchor::end));
    EXPECT_EQ(anchored(10, 16), std::pair(10.0, Anchor::start));
    EXPECT_EQ(anchored(12, 16), std::pair(12.0, Anchor::start));
    EXPECT_EQ(anchored(6, 16), std::pair(11.0, Anchor::middle));
}

TEST(Plot, ALabelWithoutRoomBesideItsMarkIsLedToByALine) {
    const Drawing drawing = plot_drawing(crowded(9, 5));
    const auto lines = shapes_of<Lines>(drawing);
    const auto leaders = std::count_if(lines.begin(), lines.end(),
                                       [](const Lines& one) { return one.role == Role::leader; });
    EXPECT_GT(leaders, 0);
    const auto few = shapes_of<Lines>(plot_drawing(hand_made()));
    EXPECT_TRUE(std::none_of(few.begin(), few.end(),
                             [](const Lines& one) { return one.role == Role::leader; }));
}

TEST(Plot, LabelsThatHaveNoRoomAtAllAreToldBelow) {
    Plot plot = hand_made();
    plot.curves[0].marks[0].label = std::string(100, 'x');
    const Drawing drawing = plot_drawing(plot);
    std::string below;
    for (const Label& label : shapes_of<Label>(drawing))
        below += label.text + " ";
    EXPECT_THAT(below, HasSubstr("No room for labels of one: "));
    EXPECT_THAT(below, HasSubstr(plot.curves[0].marks[0].label));
}

TEST(Plot, MarksThatLieOnOneAnotherShareALabel) {
    Plot plot = hand_made();
    plot.curves[1].marks = {{.x = 0.5, .y = 30, .label = "8"},
                            {.x = 0.5, .y = 30.1, .label = "12"},
                            {.x = 0.5, .y = 30.1, .label = "16"},
                            {.x = 0.5, .y = 3, .label = "0"}};
    const Drawing drawing = plot_drawing(plot);
    EXPECT_EQ(labels_with(drawing, "8, 12, 16").size(), 1U);
    EXPECT_EQ(labels_with(drawing, "8").size(), 0U);
}

// What is below one plot begins below its last line.
TEST(Plot, TheSheetIsAsHighAsItsCaption) {
    Plot plot = hand_made();
    const double low = plot_drawing(plot).height;
    for (int words = 0; words < 400; words += 50) {
        plot.caption.clear();
        for (int i = 0; i < words; ++i)
            plot.caption += "word" + std::to_string(i) + " ";
        const Drawing drawing = plot_drawing(plot);
        const Rect extent = extent_of(drawing);
        EXPECT_LE(extent.bottom, drawing.height) << words;
        EXPECT_GE(extent.left, 0) << words;
        EXPECT_LE(extent.right, drawing.width) << words;
        EXPECT_LE(drawing.height, extent.bottom + 20) << words;
    }
    EXPECT_GT(plot_drawing(plot).height, low + 100);
}

TEST(Plot, ALongTitleAndLongNamesTakeMoreLines) {
    Plot plot = hand_made();
    plot.title =
        "a title that is as long as titles can be when they say all that there is to be said";
    plot.curves[0].name =
        "a method with a name that says what is mixed, where, and how it is rounded";
    for (const Drawing& drawing : {plot_drawing(plot), legend_drawing(plot)}) {
        const Rect extent = extent_of(drawing);
        EXPECT_LE(extent.right, drawing.width);
        EXPECT_LE(extent.bottom, drawing.height);
    }
}

/// The numbers beside the x axis, or the y axis, in their order on the sheet.
std::vector<std::string> numbers_at(const Drawing& drawing, double Place::*along) {
    std::vector<std::pair<double, std::string>> numbers;
    const double bottom = label_with(drawing, "px").at.y - 18;
    for (const Label& label : shapes_of<Label>(drawing))
        if (label.role == Role::quiet_text &&
            (along == &Place::x) == (std::abs(label.at.y - bottom) < 1))
            numbers.emplace_back(label.at.*along, label.text);
    std::sort(numbers.begin(), numbers.end());
    std::vector<std::string> texts;
    for (const auto& [at, text] : numbers)
        texts.push_back(text);
    return texts;
}

TEST(Plot, ALinearAxisHasRoundNumbersAndNoShelf) {
    Plot plot = hand_made();
    plot.x.scale = plot.y.scale = PlotScale::linear;
    plot.curves = {{"z", {{.x = -20, .y = 1}, {.x = 80, .y = 9}}}};
    const Drawing drawing = plot_drawing(plot);
    EXPECT_THAT(numbers_at(drawing, &Place::x), ElementsAre("-20", "0", "20", "40", "60", "80"));
    EXPECT_THAT(numbers_at(drawing, &Place::y), ElementsAre("8", "6", "4", "2"));
    EXPECT_TRUE(shapes_of<Areas>(drawing).empty());
    const auto marks = shapes_of<Dots>(drawing);
    ASSERT_EQ(marks.size(), 2U);
    // A mark at (-20, 1) lies a twentieth of the range from the left, and from below.
    EXPECT_NEAR((marks[1].centers[0].x - marks[0].centers[0].x) / (20 * 1.1),
                (446 - 58) / 22.0 / 1.1, 1);
}

TEST(Plot, ALogarithmicAxisHasPowersOfTen) {
    Plot plot = hand_made();
    plot.curves = {{"one", {{.x = 1e-7, .y = 1}, {.x = 1e-3, .y = 5e6}}}};
    const Drawing drawing = plot_drawing(plot);
    EXPECT_THAT(numbers_at(drawing, &Place::x), ElementsAre("10", "10", "10", "10", "10"));
    for (const std::string power : {"-7", "-6", "-5", "-4", "-3"})
        EXPECT_EQ(labels_with(drawing, power).size(), 1U) << power;
}

TEST(Plot, NumbersOfAnAxisDoNotCollide) {
    for (const double largest : {1.2e-7, 3e-7, 3e-6, 9e-5, 1e3, 1e30}) {
        Plot plot = hand_made();
        plot.curves.resize(12); // a wide shelf leaves a short axis
        plot.curves[0] = {"one", {{.x = 1e-7, .y = 1e-7}, {.x = largest, .y = largest}}};
        plot.curves[1].marks.clear();
        std::vector<Rect> rects;
        for (const Label& label : shapes_of<Label>(plot_drawing(plot)))
            if (label.role == Role::quiet_text)
                rects.push_back(rect_of(label));
        for (std::size_t i = 0; i < rects.size(); ++i)
            for (std::size_t j = i + 1; j < rects.size(); ++j)
                EXPECT_FALSE(rects[i].meets(rects[j])) << largest;
    }
}

TEST(Plot, ACurveMayBeALineAloneOrMarksAlone) {
    Plot plot = hand_made();
    plot.x.scale = plot.y.scale = PlotScale::linear;
    plot.curves = {{"smooth", {{.x = 0, .y = 0, .label = "a"}, {.x = 1, .y = 1}, {.x = 2, .y = 4}}},
                   {"points", {{.x = 0, .y = 3, .label = "b"}, {.x = 2, .y = 3}}}};
    plot.curves[0].has_marks = false;
    plot.curves[1].has_line = false;
    const auto has_line_of = [](const Drawing& drawing, Role role) {
        const auto lines = shapes_of<Lines>(drawing);
        return std::any_of(lines.begin(), lines.end(),
                           [role](const Lines& one) { return one.role == role; });
    };
    for (const Drawing& drawing : {plot_drawing(plot), legend_drawing(plot)}) {
        EXPECT_TRUE(has_line_of(drawing, Role::curve_1));
        EXPECT_FALSE(has_line_of(drawing, Role::curve_2));
        EXPECT_TRUE(shapes_of<Dots>(drawing).empty()) << "the first curve's marks are circles";
        EXPECT_FALSE(shapes_of<Polygons>(drawing).empty()) << "the second one's are squares";
    }
    EXPECT_TRUE(labels_with(plot_drawing(plot), "a").empty());
    EXPECT_FALSE(labels_with(plot_drawing(plot), "b").empty());
}

TEST(Plot, TheLegendHasWhatThePlotHas) {
    Plot plot = hand_made();
    EXPECT_EQ(labels_with(legend_drawing(plot), "one").size(), 1U);
    EXPECT_EQ(labels_with(legend_drawing(plot), "on the Pareto front").size(), 1U);
    EXPECT_EQ(labels_with(legend_drawing(plot), "the shelf: exactly 0").size(), 1U);
    plot.x.scale = PlotScale::linear;
    plot.curves[0].marks[0].is_on_front = false;
    EXPECT_EQ(labels_with(legend_drawing(plot), "on the Pareto front").size(), 0U);
    EXPECT_EQ(labels_with(legend_drawing(plot), "the shelf: exactly 0").size(), 0U);
}

} // namespace
} // namespace rastertrace
