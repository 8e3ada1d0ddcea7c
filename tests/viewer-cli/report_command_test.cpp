// SPDX-License-Identifier: MIT
// `rastertrace report` as a user calls it: what it measures, and what it refuses.

#include "program.h"

#include <string>

namespace rastertrace {
namespace {

TEST_F(ProgramTest, ReportWritesNoFileTwice) {
    write("old.csv", "old");
    shell("ln -s old.csv link.csv; ln -s new.csv dangling.csv; mkdir folder");
    for (const std::string files : {"-o a.csv -o a.csv", "-o a.csv -o folder/../a.csv",
                                    "-o old.csv -o link.csv", "-o new.csv -o dangling.csv"}) {
        EXPECT_THAT(
            run("report --quick --jobs edge $examples/t0-fill/first-triangle.json " + files),
            Refused(HasSubstr("expected files to write that differ, found the file")))
            << files;
        EXPECT_EQ(content("old.csv"), "old") << files;
        EXPECT_EQ(visible_files(), 4u) << files;
    }
    EXPECT_EQ(run("report --quick --jobs edge $examples/t0-fill/first-triangle.json --format csv "
                  "-o /dev/null -o /dev/null")
                  .status,
              0);
}

TEST_F(ProgramTest, ReportMeasuresErrorAgainstRunTime) {
    const std::string report = "$rastertrace report --quick $examples/t0-fill/first-triangle.json";
    EXPECT_THAT(shell(report),
                Ends(0,
                     AllOf(HasSubstr("\nFirst triangle\n==============\n"),
                           HasSubstr("\nx += a, float (begun anew every so many rows)\n"),
                           HasSubstr("\ndepth: nothing to measure: the scene has no depth\n"),
                           HasSubstr("\n-> wrong pixels / perimeter pixels: Choose ")),
                     ""))
        << "progress is for terminals";

    EXPECT_EQ(shell(report + " -o r.svg -o r.html -o r.csv -o r.json").out, "");
    EXPECT_EQ(visible_files(), 4u);
    EXPECT_THAT(content("r.svg"), StartsWith("<svg xmlns="));
    EXPECT_THAT(content("r.svg"), EndsWith("</svg>\n"));
    EXPECT_THAT(content("r.html"), EndsWith("</html>\n"));
    EXPECT_THAT(content("r.csv"), StartsWith("scene,job,method,knob,setting,measure,error,"));
    EXPECT_THAT(content("r.json"), StartsWith("{\n \"report\": 1,\n"));
}

// A title may be anything: in SVG and HTML it is XML, and in CSV no formula.
TEST_F(ProgramTest, ReportQuotesTitlesForEveryFormat) {
    write("scene.json", "{\"title\":\"=1+1\uFFFE\uFFFF\",\"vertices\":{\"A\":[0,0],\"B\":[5,0],"
                        "\"C\":[0,5]},\"triangles\":[\"ABC\"]}");
    EXPECT_THAT(run("report scene.json --quick --jobs edge -o r.svg -o r.html -o r.csv"), Ends(0));
    for (const std::string name : {"r.svg", "r.html"}) {
        EXPECT_THAT(content(name), HasSubstr("=1+1&lt;U+FFFE&gt;&lt;U+FFFF&gt;")) << name;
        EXPECT_EQ(content(name).find("\uFFFE"), std::string::npos) << name;
    }
    EXPECT_THAT(content("r.csv"), HasSubstr("\n'=1+1<U+FFFE><U+FFFF>,"));
}

TEST_F(ProgramTest, ReportHasTheSameNumbersTwiceButForTheTimes) {
    write("line.json", R"({"vertices":{"A":[0,0],"B":[100,300]},"lines":["AB"]})");
    const std::string numbers =
        "report --quick line.json --jobs edge --format json | grep -E "
        "'\"(method|setting|value|count|of|adds|multiplies|divides|comparisons)\"'";
    const Outcome once = run(numbers);
    EXPECT_THAT(once.out, HasSubstr("\"value\": "));
    EXPECT_EQ(run(numbers).out, once.out);
}

TEST_F(ProgramTest, ReportRefusesBeforeItMeasures) {
    write("point.json", R"({"vertices":{"A":[0,0]},"points":["A"]})");
    EXPECT_THAT(run("report point.json -o r.svg"),
                Refused("rastertrace: point.json: expected something to measure, found none (edge: "
                        "the scene has no edge that passes a row of pixels; coverage: the scene "
                        "has no triangle to fill; depth: the scene has no depth; color: the scene "
                        "has no triangle with colored vertices)\n"));
    EXPECT_EQ(visible_files(), 1u) << "nothing was written";
    EXPECT_EQ(run("report point.json -o r.pdf").err,
              "rastertrace: r.pdf: expected a name that ends in .svg, .html, .json, .csv or .txt, "
              "found .pdf\n"
              "hint: of an .svg: rsvg-convert -f pdf r.svg -o r.pdf\n");
    EXPECT_EQ(run("report point.json --jobs edges").err,
              "rastertrace: --jobs: expected jobs out of edge,coverage,depth,color, found "
              "\"edges\"\nhint: did you mean edge?\n");
    EXPECT_EQ(run("report point.json --format pdf").err,
              "rastertrace: --format: expected one of text, json, csv, svg, html, found \"pdf\"\n");
    EXPECT_EQ(run("report").status, 2);
    EXPECT_EQ(run("report --quick $examples/t0-fill/first-triangle.json --jobs edge -o /dev/full "
                  "--format svg")
                  .status,
              3);
}

} // namespace
} // namespace rastertrace
