// SPDX-License-Identifier: MIT
// The report as text for people, and as JSON and CSV for programs.

#include "commands/report_file.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/trace/text/csv.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <string_view>

namespace rastertrace {

namespace {

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
