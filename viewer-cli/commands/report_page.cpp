// SPDX-License-Identifier: MIT
// The report's plots: alone as SVG, and with the tables as HTML.

#include "commands/report_file.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/figures/plot.h>
#include <rastertrace/figures/svg.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

constexpr double margin = 14;

Plot plot_of(const JobReport& job, std::size_t measure) {
    const ErrorMeasure& one = job.measures[measure];
    Plot plot{.title = std::string(one.name),
              .x = {.label = one.unit.empty() ? std::string(one.name)
                                              : fmt::format("{} ({})", one.name, one.unit)},
              .y = {.label = fmt::format("median ns for each {}", job.unit)},
              .caption = job.advice[measure],
              .only_shelf = "no method has an error here"};
    for (const Curve& curve : job.curves) {
        PlotCurve& drawn = plot.curves.emplace_back();
        drawn.name = curve.method;
        for (const Setting& setting : curve.settings)
            if (setting.failure.empty() && setting.errors[measure].value)
                drawn.marks.push_back({.x = *setting.errors[measure].value,
                                       .y = setting.timing.median,
                                       .label = setting.label,
                                       .is_on_front = setting.on_front[measure]});
    }
    return plot;
}

/// True if no setting of a curve could be measured.
bool has_failed(const Curve& curve) {
    return std::none_of(curve.settings.begin(), curve.settings.end(),
                        [](const Setting& setting) { return setting.failure.empty(); });
}

/// Puts a drawing right of what is on a sheet, or below it.
void place_right(Drawing part, Drawing& sheet) {
    const double left = sheet.width;
    sheet.width += part.width;
    sheet.height = std::max(sheet.height, part.height);
    place(std::move(part), {left, 0}, sheet);
}
void place_below(Drawing part, Drawing& sheet) {
    const double top = sheet.height;
    sheet.width = std::max(sheet.width, part.width);
    sheet.height += part.height;
    place(std::move(part), {0, top}, sheet);
}

/// Text on a sheet of its own, in as many lines as it takes.
Drawing text_drawing(std::string_view text, double width, double size, bool is_bold) {
    constexpr double line_height = 1.4;
    Drawing sheet{.width = width, .title = {}};
    const auto columns = static_cast<std::size_t>((width - 2 * margin) / width_of("x", size));
    for (std::string& line : wrapped(printable(text), columns)) {
        sheet.height += line_height * size;
        sheet.shapes.push_back(Label{.role = is_bold ? Role::strong_text : Role::text,
                                     .at = {margin, sheet.height},
                                     .text = std::move(line),
                                     .size = size,
                                     .is_bold = is_bold});
    }
    return sheet;
}

std::string heading_of(const JobReport& job) {
    return fmt::format("{}: {}; exact is {}", name_of(job.job), counted(job.units, job.unit),
                       job.reference);
}

/// The plots of a job side by side, and what their lines mean.
Drawing plots_drawing(const JobReport& job) {
    Drawing sheet{.title = heading_of(job)};
    Plot plot;
    for (std::size_t measure = 0; measure < job.measures.size(); ++measure) {
        plot = plot_of(job, measure);
        sheet.description +=
            fmt::format("{}{}: {}", sheet.description.empty() ? "" : " ", plot.title, plot.caption);
        place_right(plot_drawing(plot), sheet);
    }
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
        if (has_failed(job.curves[i]))
            plot.curves[i].name += " (failed)";
    place_right(legend_drawing(plot), sheet);
    return sheet;
}

/// A drawing as SVG. A plot has no pixels: there are never too many.
std::string svg_text(const Drawing& drawing, Theme theme) {
    return svg_of(drawing, theme).value();
}

std::string machine_line(const MeasuredReport& report) {
    return fmt::format("rastertrace {}; {}; {}, {}; up to {} runs of each setting",
                       report.machine.version, report.machine.cpu, report.machine.compiler,
                       report.machine.flags, report.timing.runs);
}

std::string row_html(std::string_view cell, const std::vector<std::string>& cells) {
    std::string html = "<tr>";
    for (const std::string& one : cells)
        html += fmt::format("<{0}>{1}</{0}>", cell, escaped(one));
    return html + "</tr>\n";
}

std::string table_html(const JobReport& job) {
    std::vector<std::string> head{"method", "setting"};
    for (const ErrorMeasure& measure : job.measures)
        head.push_back(measure.unit.empty() ? std::string(measure.name)
                                            : fmt::format("{}, {}", measure.name, measure.unit));
    for (const std::string_view name : {"minimum ns", "median ns", "runs"})
        head.emplace_back(name);
    for (const WorkColumn& column : work_columns)
        head.emplace_back(column.name);
    std::string html = "<table>\n" + row_html("th", head);
    for (const Curve& curve : job.curves)
        for (const Setting& setting : curve.settings) {
            std::vector<std::string> cells{curve.method, setting.name};
            if (!setting.failure.empty()) {
                html += fmt::format("<tr><td>{}</td><td>{}</td><td colspan=\"{}\">failed: {}</td>"
                                    "</tr>\n",
                                    escaped(curve.method), escaped(setting.name), head.size() - 2,
                                    escaped(setting.failure));
                continue;
            }
            for (std::size_t measure = 0; measure < job.measures.size(); ++measure) {
                const ErrorValue& error = setting.errors[measure];
                std::string text = !error.value  ? "-"
                                   : error.count ? fmt::format("{} of {}", *error.count, error.of)
                                                 : fmt::format("{:.3g}", *error.value);
                if (setting.on_front[measure])
                    text += " *";
                cells.push_back(text);
            }
            cells.push_back(fmt::format("{:.3g}", setting.timing.minimum));
            cells.push_back(fmt::format("{:.3g}", setting.timing.median));
            cells.push_back(fmt::format("{}", setting.timing.runs));
            for (const WorkColumn& column : work_columns) {
                const auto count = count_in(column, setting.work);
                cells.push_back(!count ? "-"
                                : column.is_per_unit
                                    ? fmt::format("{:.3g}", static_cast<double>(*count) /
                                                                static_cast<double>(setting.units))
                                    : fmt::format("{}", *count));
            }
            html += row_html("td", cells);
            if (!setting.note.empty())
                html += fmt::format("<tr><td></td><td></td><td colspan=\"{}\">{}</td></tr>\n",
                                    head.size() - 2, escaped(setting.note));
        }
    return html + "</table>\n";
}

} // namespace

std::string report_svg(const MeasuredReport& report) {
    Drawing sheet{.title = "rastertrace: error against run time"};
    for (const SceneReport& scene : report.scenes)
        for (const JobReport& job : scene.jobs) {
            if (!job.nothing.empty())
                continue;
            Drawing plots = plots_drawing(job);
            sheet.height += margin;
            place_below(text_drawing(scene.title, plots.width, 14, true), sheet);
            place_below(text_drawing(plots.title, plots.width, 11, false), sheet);
            sheet.description += fmt::format("{}{}. {}", sheet.description.empty() ? "" : " ",
                                             plots.title, plots.description);
            place_below(std::move(plots), sheet);
        }
    sheet.height += margin;
    place_below(text_drawing(machine_line(report), sheet.width, 10, false), sheet);
    sheet.height = std::ceil(sheet.height + margin);
    return svg_text(sheet, Theme::automatic);
}

std::string report_html(const MeasuredReport& report) {
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<title>rastertrace: error against run time</title>\n<style>\n"
                       "body { font-family: sans-serif; margin: 2em; max-width: 80em; }\n"
                       "table { border-collapse: collapse; font-size: 85%; }\n"
                       "th, td { border: 1px solid #bbb; padding: 2px 6px; text-align: right; }\n"
                       "th:nth-child(-n+2), td:nth-child(-n+2) { text-align: left; }\n"
                       "svg { max-width: 100%; height: auto; }\n"
                       "</style>\n</head>\n<body>\n<h1>Error against run time</h1>\n";
    html += fmt::format("<p>{}</p>\n<p>Times and operations are for one row or pixel. * on the "
                        "Pareto front: nothing is both faster and nearer.</p>\n",
                        escaped(machine_line(report)));
    for (const SceneReport& scene : report.scenes) {
        html += fmt::format("<h2>{}</h2>\n", escaped(scene.title));
        for (const JobReport& job : scene.jobs) {
            if (!job.nothing.empty()) {
                html += fmt::format("<h3>{}</h3>\n<p>Nothing to measure: {}.</p>\n",
                                    name_of(job.job), escaped(job.nothing));
                continue;
            }
            html += fmt::format("<h3>{}</h3>\n", escaped(heading_of(job)));
            html += svg_text(plots_drawing(job), Theme::light);
            html += "<ul>\n";
            for (std::size_t measure = 0; measure < job.measures.size(); ++measure)
                html += fmt::format("<li>{}: {}</li>\n", escaped(job.measures[measure].name),
                                    escaped(job.advice[measure]));
            html += "</ul>\n" + table_html(job);
        }
        html += fmt::format("<p>Trace, as the scene's method has it: {} in {:.3g} ms, written to "
                            "nowhere; drawing alone {:.3g} ms.</p>\n",
                            counted(scene.trace.steps, "step"), scene.trace.writing.median / 1e6,
                            scene.trace.drawing.median / 1e6);
    }
    return html + "</body>\n</html>\n";
}

} // namespace rastertrace
