// SPDX-License-Identifier: MIT
#include "commands/report_file.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/figures/plot.h>
#include <rastertrace/figures/svg.h>
#include <rastertrace/trace/text/csv.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

// Text, JSON and CSV.

/// The name of the processor as Linux tells it.
std::string cpu_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name"))
            if (const auto colon = line.find(": "); colon != std::string::npos)
                return printable(line.substr(colon + 2));
    return {};
}

/// "590/3001*", "0.024": with a star if it is on the front.
std::string error_text(const Setting& setting, std::size_t measure) {
    const ErrorValue& error = setting.errors[measure];
    if (!error.value)
        return "-";
    const std::string star = setting.on_front[measure] ? "*" : " ";
    return (error.count ? fmt::format("{}/{}", *error.count, error.of)
                        : fmt::format("{:.3g}", *error.value)) +
           star;
}

/// So many for each unit, to a hundredth: "2", "0.33".
std::string per_unit(std::uint64_t count, std::uint64_t units) {
    const double share = static_cast<double>(count) / static_cast<double>(units);
    return fmt::format("{:.4g}", std::round(100 * share) / 100);
}

void put_wrapped(std::string& text, std::string_view first, std::string_view rest,
                 std::string_view indent) {
    bool is_first = true;
    for (const std::string& line : wrapped(rest, text_width - indent.size())) {
        text += fmt::format("{}{}\n", is_first ? first : indent, line);
        is_first = false;
    }
}

/// "adaptive: a bound for each triangle; 3 exact fallbacks".
std::string note_of(const Setting& setting) {
    std::string note = fmt::format("{}: {}", setting.name, setting.note);
    if (setting.work)
        note += fmt::format("; {}", counted(setting.work->exact_fallbacks, "exact fallback"));
    return note;
}

void put_curve(std::string& text, const JobReport& job, const Curve& curve) {
    text += fmt::format("{} ({})\n", curve.method, curve.knob);
    std::uint64_t wrong_when_snapped = 0;
    bool is_snapped = false;
    for (const Setting& setting : curve.settings) {
        if (!setting.failure.empty()) {
            put_wrapped(text, fmt::format("  {:<15} ", setting.name),
                        "failed: " + printable(setting.failure), std::string(18, ' '));
            continue;
        }
        text += fmt::format("  {:<15}", setting.name);
        for (std::size_t measure = 0; measure < 2; ++measure)
            text += fmt::format("{:>14}",
                                measure < job.measures.size() ? error_text(setting, measure) : "");
        text += fmt::format("{:>10.3g}{:>10.3g}{:>5}", setting.timing.minimum,
                            setting.timing.median, setting.timing.runs);
        if (setting.work)
            for (const WorkColumn& column : work_columns)
                if (column.is_per_unit) {
                    const auto count = count_in(column, setting.work);
                    text += fmt::format("{:>6}", count ? per_unit(*count, setting.units) : "-");
                }
        text += '\n';
        if (!setting.note.empty())
            put_wrapped(text, "  ", note_of(setting), "  ");
        if (setting.wrong_when_snapped) {
            is_snapped = true;
            wrong_when_snapped += *setting.wrong_when_snapped;
        }
    }
    if (is_snapped)
        text += fmt::format("  against exact arithmetic on the snapped vertices: {} wrong\n",
                            counted(wrong_when_snapped, "pixel"));
}

void put_job(std::string& text, const JobReport& job) {
    if (!job.nothing.empty()) {
        text += '\n';
        put_wrapped(
            text, "",
            fmt::format("{}: nothing to measure: {}", name_of(job.job), printable(job.nothing)),
            "  ");
        return;
    }
    text += '\n';
    put_wrapped(text, "",
                fmt::format("{}: {}; exact is {}", name_of(job.job), counted(job.units, job.unit),
                            job.reference),
                "  ");
    for (std::size_t measure = 0; measure < job.measures.size(); ++measure) {
        const ErrorMeasure& one = job.measures[measure];
        text += fmt::format("  error {}: {}{}\n", measure + 1, one.name,
                            one.unit.empty() ? "" : fmt::format(" ({})", one.unit));
        if (one.unseen > 0)
            text += fmt::format("    up to {:.2g} is enough: {}\n", one.unseen, one.unseen_as);
    }
    text += fmt::format("{:<17}{:>13} {:>13} {:>10}{:>10}{:>5}{:>6}{:>6}{:>6}{:>6}{:>6}\n", "",
                        "error 1", job.measures.size() > 1 ? "error 2" : "", "min ns", "median ns",
                        "runs", "add", "mul", "div", "cmp", "test");
    for (const Curve& curve : job.curves)
        put_curve(text, job, curve);
    for (std::size_t measure = 0; measure < job.measures.size(); ++measure)
        put_wrapped(text, "-> ",
                    fmt::format("{}: {}", job.measures[measure].name, job.advice[measure]), "   ");
}

using Json = nlohmann::ordered_json;

Json json_of(const Timing& timing) {
    return {{"minimum_ns", timing.minimum}, {"median_ns", timing.median}, {"runs", timing.runs}};
}

Json json_of(const JobReport& job, const Setting& setting) {
    Json json{{"setting", setting.name}};
    if (!setting.failure.empty()) {
        json["failure"] = printable(setting.failure);
        return json;
    }
    Json errors = Json::object();
    Json front = Json::array();
    for (std::size_t measure = 0; measure < job.measures.size(); ++measure) {
        const ErrorValue& error = setting.errors[measure];
        if (!error.value)
            continue;
        const std::string key(job.measures[measure].key);
        Json value{{"value", *error.value}};
        if (error.count) {
            value["count"] = *error.count;
            value["of"] = error.of;
        }
        errors[key] = std::move(value);
        if (setting.on_front[measure])
            front.push_back(key);
    }
    json["errors"] = std::move(errors);
    json["on_front"] = std::move(front);
    for (const WorkColumn& column : work_columns)
        if (const auto count = count_in(column, setting.work))
            json["work"][std::string(column.key)] = *count;
    if (!setting.note.empty())
        json["note"] = setting.note;
    if (setting.wrong_when_snapped)
        json["wrong_when_snapped"] = *setting.wrong_when_snapped;
    json["units"] = setting.units;
    json["time"] = json_of(setting.timing);
    return json;
}

Json json_of(const JobReport& job) {
    Json json{{"job", name_of(job.job)}};
    if (!job.nothing.empty()) {
        json["nothing"] = printable(job.nothing);
        return json;
    }
    json["unit"] = job.unit;
    json["units"] = job.units;
    json["reference"] = job.reference;
    for (const ErrorMeasure& measure : job.measures)
        json["measures"].push_back({{"key", measure.key},
                                    {"name", measure.name},
                                    {"unit", measure.unit},
                                    {"enough", measure.unseen}});
    for (const Curve& curve : job.curves) {
        Json settings = Json::array();
        for (const Setting& setting : curve.settings)
            settings.push_back(json_of(job, setting));
        json["curves"].push_back(
            {{"method", curve.method}, {"knob", curve.knob}, {"settings", settings}});
    }
    for (std::size_t measure = 0; measure < job.measures.size(); ++measure)
        json["advice"][std::string(job.measures[measure].key)] = job.advice[measure];
    return json;
}

// Plots and tables, for SVG and HTML.

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

Machine this_machine() {
    return {.cpu = cpu_name(),
#ifdef __clang__
            .compiler = "clang++ " __clang_version__,
#else
            .compiler = "g++ " __VERSION__,
#endif
            .flags = RASTERTRACE_FLAGS,
            .version = RASTERTRACE_VERSION};
}

std::string report_text(const MeasuredReport& report) {
    std::string text =
        fmt::format("rastertrace {}: error against run time\n", report.machine.version);
    put_wrapped(text, "",
                fmt::format("{}{}{}, {}", report.machine.cpu,
                            report.machine.cpu.empty() ? "" : "; ", report.machine.compiler,
                            report.machine.flags),
                "  ");
    put_wrapped(text, "",
                fmt::format("up to {} runs of each setting, all in turn; those of a setting end "
                            "after {:g} s, but not before {} have been made, unless one takes as "
                            "long",
                            report.timing.runs, report.timing.most_time, least_runs),
                "  ");
    put_wrapped(text, "",
                "Times and operations are for one row, one pixel: ns; additions, multiplications, "
                "divisions, comparisons, pixels tested. * on the Pareto front: nothing is both "
                "faster and nearer.",
                "  ");
    for (const SceneReport& scene : report.scenes) {
        const std::string title = shortened(printable(scene.title), text_width);
        text += fmt::format("\n{}\n{:=<{}}\n", title, "", columns_in(title));
        for (const JobReport& job : scene.jobs)
            put_job(text, job);
        const TraceCost& trace = scene.trace;
        const auto milliseconds = [](double nanoseconds) { return nanoseconds / 1e6; };
        text += '\n';
        put_wrapped(text, "",
                    fmt::format("trace, as the scene's method has it: {} in {:.3g} ms (minimum "
                                "{:.3g} ms), {} bytes, written to nowhere; drawing alone {:.3g} ms",
                                counted(trace.steps, "step"), milliseconds(trace.writing.median),
                                milliseconds(trace.writing.minimum), trace.bytes,
                                milliseconds(trace.drawing.median)),
                    "  ");
    }
    return text;
}

std::string report_json(const MeasuredReport& report) {
    Json json{{"report", 1},
              {"rastertrace", report.machine.version},
              {"cpu", report.machine.cpu},
              {"compiler", report.machine.compiler},
              {"flags", report.machine.flags},
              {"runs", report.timing.runs},
              {"seconds_for_a_setting", report.timing.most_time},
              {"scenes", Json::array()}};
    for (const SceneReport& scene : report.scenes) {
        Json one{{"title", printable(scene.title)}, {"jobs", Json::array()}};
        for (const JobReport& job : scene.jobs)
            one["jobs"].push_back(json_of(job));
        one["trace"] = {{"steps", scene.trace.steps},
                        {"bytes", scene.trace.bytes},
                        {"drawing", json_of(scene.trace.drawing)},
                        {"writing", json_of(scene.trace.writing)}};
        json["scenes"].push_back(std::move(one));
    }
    return json.dump(1) + "\n";
}

std::string report_csv(const MeasuredReport& report) {
    std::string text;
    std::vector<std::string> head{"scene",      "job",       "method", "knob", "setting",
                                  "measure",    "error",     "count",  "of",   "on_front",
                                  "minimum_ns", "median_ns", "runs",   "unit", "units"};
    for (const WorkColumn& column : work_columns)
        head.emplace_back(column.key);
    head.emplace_back("failure");
    put_csv_line(text, head);
    const auto number = [](const auto& value) { return fmt::format("{}", value); };
    for (const SceneReport& scene : report.scenes)
        for (const JobReport& job : scene.jobs)
            for (const Curve& curve : job.curves)
                for (const Setting& setting : curve.settings) {
                    const std::vector<std::string> begin{scene.title, std::string(name_of(job.job)),
                                                         curve.method, curve.knob, setting.name};
                    if (!setting.failure.empty()) {
                        std::vector<std::string> line = begin;
                        line.resize(head.size() - 1);
                        line.push_back(setting.failure);
                        put_csv_line(text, line);
                        continue;
                    }
                    for (std::size_t measure = 0; measure < job.measures.size(); ++measure) {
                        const ErrorValue& error = setting.errors[measure];
                        if (!error.value)
                            continue;
                        std::vector<std::string> line = begin;
                        line.insert(line.end(),
                                    {std::string(job.measures[measure].key), number(*error.value),
                                     error.count ? number(*error.count) : "",
                                     error.count ? number(error.of) : "",
                                     setting.on_front[measure] ? "1" : "0",
                                     number(setting.timing.minimum), number(setting.timing.median),
                                     number(setting.timing.runs), job.unit, number(setting.units)});
                        for (const WorkColumn& column : work_columns) {
                            const auto count = count_in(column, setting.work);
                            line.push_back(count ? number(*count) : "");
                        }
                        line.emplace_back();
                        put_csv_line(text, line);
                    }
                }
    return text;
}

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

std::string report_in(ReportFormat format, const MeasuredReport& report) {
    switch (format) {
    case ReportFormat::json:
        return report_json(report);
    case ReportFormat::csv:
        return report_csv(report);
    case ReportFormat::svg:
        return report_svg(report);
    case ReportFormat::html:
        return report_html(report);
    case ReportFormat::text:
        break;
    }
    return report_text(report);
}

} // namespace rastertrace
