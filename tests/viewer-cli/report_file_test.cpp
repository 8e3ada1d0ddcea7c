// SPDX-License-Identifier: MIT
// The files of the report, from data made by hand.

#include "commands/report_file.h"

#include "xml_fault.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

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
    job.advice = {"Choose exact."};
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

/// The heights at which an SVG has texts that begin so.
std::vector<double> heights_of(const std::string& svg, const std::string& text) {
    std::vector<double> heights;
    for (std::size_t at = svg.find(">" + text); at != std::string::npos;
         at = svg.find(">" + text, at + 1)) {
        const std::size_t y = svg.rfind(" y=\"", at);
        heights.push_back(std::stod(svg.substr(y + 4)));
    }
    return heights;
}

// Captions of several lines: the next heading stands below the last one, and the sheet ends below it all.
TEST(ReportFile, AHeadingStandsBelowTheCaptionBeforeIt) {
    MeasuredReport report = hand_made_report();
    std::string sentence;
    for (int i = 0; i < 200; ++i)
        sentence += "word ";
    report.scenes[0].jobs[0].advice = {sentence + "last."};
    report.scenes[0].jobs[1] = report.scenes[0].jobs[0];
    report.scenes[0].jobs[1].job = ReportJob::coverage;
    const std::string svg = report_svg(report);
    EXPECT_EQ(xml_fault(svg), "");
    const auto headings = heights_of(svg, "coverage: 7 rows");
    ASSERT_EQ(headings.size(), 1U);
    const auto captions = heights_of(svg, "word ");
    ASSERT_GT(captions.size(), 10U);
    const auto half = static_cast<std::ptrdiff_t>(captions.size() / 2);
    EXPECT_LT(*std::max_element(captions.begin(), captions.begin() + half), headings[0] - 20);
    EXPECT_GT(*std::min_element(captions.begin() + half, captions.end()), headings[0]);
    const double height = std::stod(svg.substr(svg.find(" height=\"") + 9));
    EXPECT_LT(captions.back(), height);
    EXPECT_LT(heights_of(svg, "rastertrace 0.1").at(0), height);
}

} // namespace
} // namespace rastertrace
