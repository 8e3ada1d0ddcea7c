// SPDX-License-Identifier: MIT
// The plots and files of the report, from data made by hand.

#include "plot_svg.h"
#include "report_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// What is wrong with a document as XML, or "": tags that do not match, a raw & or <, control
/// characters, attributes without quotes.
std::string xml_fault(const std::string& xml) {
    std::vector<std::string> open;
    for (std::size_t i = 0; i < xml.size();) {
        const char c = xml[i];
        if (static_cast<unsigned char>(c) < 0x20 && c != '\n')
            return "a control character";
        if (c == '&') {
            const std::size_t end = xml.find(';', i);
            const std::string name = xml.substr(i + 1, end - i - 1);
            if (end == std::string::npos ||
                (name != "amp" && name != "lt" && name != "gt" && name != "quot" && name != "#39"))
                return "an entity that is none: " + xml.substr(i, 10);
            i = end + 1;
            continue;
        }
        if (c != '<') {
            ++i;
            continue;
        }
        const std::size_t end = xml.find('>', i);
        if (end == std::string::npos)
            return "a tag without an end";
        std::string tag = xml.substr(i + 1, end - i - 1);
        i = end + 1;
        if (tag.find('<') != std::string::npos)
            return "a < in a tag";
        if (tag.starts_with('/')) {
            if (open.empty() || open.back() != tag.substr(1))
                return "an end tag of something else: " + tag;
            open.pop_back();
            continue;
        }
        const bool is_empty = tag.ends_with('/');
        if (std::count(tag.begin(), tag.end(), '"') % 2 != 0)
            return "a quote too many: " + tag;
        if (!is_empty)
            open.push_back(tag.substr(0, tag.find_first_of(" \n")));
    }
    return open.empty() ? "" : "a tag left open: " + open.back();
}

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

TEST(PlotSvg, TextIsWrappedBetweenWords) {
    EXPECT_THAT(wrapped("one two three", 7), ElementsAre("one two", "three"));
    EXPECT_THAT(wrapped("incomprehensible", 7), ElementsAre("incomprehensible"));
    EXPECT_TRUE(wrapped("", 7).empty());
}

/// A report of one scene with a hostile title, a success and a failure.
MeasuredReport hand_made_report() {
    Setting good;
    good.name = good.label = "exact";
    good.errors = {ErrorValue::ratio(0, 7)};
    good.on_front = {true};
    good.units = 7;
    good.work = Work{.adds = 7, .multiplies = 14};
    good.timing = {.minimum = 1, .median = 2, .runs = 20};
    Setting bad;
    bad.name = bad.label = "float";
    bad.failure = "beyond, \"the largest\" <float>";
    JobReport job;
    job.job = ReportJob::edge;
    job.unit = "row";
    job.units = 7;
    job.reference = "exact";
    job.measures = {{"wrong_rows", "wrong rows / rows", "", "rows"}};
    job.curves = {{"x1 + a (y - y1)", "scalar", {good, bad}}};
    job.advice = {{"Choose exact."}};
    JobReport nothing;
    nothing.job = ReportJob::depth;
    nothing.nothing = "the scene has no depth";
    SceneReport scene;
    scene.title = "<script>\x1b]0;x\a\"&";
    scene.jobs = {job, nothing};
    return {.machine = {"a CPU", "a compiler", "-O3", "0.1"}, .timing = {}, .scenes = {scene}};
}

TEST(ReportFile, TextHasTheFailuresAndFits) {
    const std::string text = report_text(hand_made_report());
    EXPECT_THAT(text, HasSubstr("a CPU; a compiler, -O3\n"));
    EXPECT_THAT(text, HasSubstr("\n  exact                    0/7*"));
    EXPECT_THAT(text, HasSubstr("\n  float           failed: beyond, \"the largest\" <float>\n"));
    EXPECT_THAT(text, HasSubstr("\n-> wrong rows / rows: Choose exact.\n"));
    EXPECT_THAT(text, HasSubstr("\ndepth: nothing to measure: the scene has no depth\n"));
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    for (std::size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1)
        EXPECT_LE(text.find('\n', begin) - begin, 100U);
}

TEST(ReportFile, JsonReadsBack) {
    const auto json = nlohmann::json::parse(report_json(hand_made_report()));
    const auto& job = json["scenes"][0]["jobs"][0];
    EXPECT_EQ(job["curves"][0]["settings"][0]["errors"]["wrong_rows"]["of"], 7);
    EXPECT_EQ(job["curves"][0]["settings"][0]["on_front"][0], "wrong_rows");
    EXPECT_EQ(job["curves"][0]["settings"][1]["failure"], "beyond, \"the largest\" <float>");
    EXPECT_EQ(json["scenes"][0]["jobs"][1]["nothing"], "the scene has no depth");
}

TEST(ReportFile, CsvHasAsManyFieldsInEveryLine) {
    const std::string csv = report_csv(hand_made_report());
    std::vector<std::size_t> fields{1};
    bool is_quoted = false;
    for (const char c : csv) {
        is_quoted = is_quoted != (c == '"');
        if (c == ',' && !is_quoted)
            ++fields.back();
        if (c == '\n')
            fields.push_back(1);
    }
    fields.pop_back();
    EXPECT_THAT(fields, ElementsAre(22U, 22U, 22U));
    EXPECT_THAT(csv, HasSubstr("\"beyond, \"\"the largest\"\" <float>\""));
}

TEST(ReportFile, SvgAndHtmlTakeAnyTitle) {
    const std::string svg = report_svg(hand_made_report());
    EXPECT_EQ(xml_fault(svg), "");
    const std::string html = report_html(hand_made_report());
    for (const std::string& page : {svg, html}) {
        EXPECT_THAT(page, Not(HasSubstr("<script")));
        EXPECT_THAT(page, HasSubstr("&lt;script&gt;&lt;U+001B&gt;"));
    }
    EXPECT_THAT(html, HasSubstr("failed: beyond, &quot;the largest&quot; &lt;float&gt;"));
    EXPECT_THAT(html, HasSubstr("Nothing to measure: the scene has no depth."));
}

} // namespace
} // namespace rastertrace
