// SPDX-License-Identifier: MIT
// `rastertrace sheet`: the empty sheet of a worked example, to fill in and to be checked.

#include "command.h"
#include "commands.h"
#include "figure_file.h"
#include "load.h"
#include "output_ending.h"
#include "shared_options.h"

#include <rastertrace/figures/figure.h>
#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/check/claims_template.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/process_files.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

enum class SheetFormat { text, columns, svg, png, tex };

constexpr std::array<Ending<SheetFormat>, 5> endings{{{".txt", SheetFormat::text},
                                                      {".csv", SheetFormat::columns},
                                                      {".svg", SheetFormat::svg},
                                                      {".png", SheetFormat::png},
                                                      {".tex", SheetFormat::tex}}};

/// The vertices as the scene has them: A (2, 5).
std::vector<std::string> given_vertices(const Trace& trace) {
    std::vector<std::string> lines;
    std::set<std::string> known;
    const auto add = [&](const std::string& name, const std::vector<std::string>& at) {
        if (known.insert(name).second)
            lines.push_back(fmt::format("{} ({})", name, joined(at, ", ")));
    };
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const StepView step = trace.step(n);
        if (step.kind() == StepKind::vertex) {
            const auto vertex = step.as<VertexStep>();
            add(vertex.name.text(), vertex.at.texts());
        } else if (step.kind() == StepKind::primitive) {
            const auto primitive = step.as<PrimitiveStep>();
            const auto names = primitive.vertices.texts();
            const auto places = primitive.at.values();
            for (std::size_t i = 0; i < std::min(names.size(), places.size()); ++i)
                add(names[i], places[i].texts());
        }
    }
    lines.emplace_back();
    return lines;
}

/// The lines of a sheet as they are printed: what is given, and a rule to write on in place of each `?`. The picture is
/// the grid above them.
std::vector<std::string> printed_lines(const Trace& trace) {
    std::vector<std::string> lines = given_vertices(trace);
    for (std::string line : split_at(claims_template(trace), '\n')) {
        if (line == "picture:")
            break;
        for (std::size_t at = line.find('?'); at != std::string::npos; at = line.find('?', at))
            line.replace(at, 1, "_______");
        lines.push_back(std::move(line));
    }
    while (!lines.empty() && lines.back().empty())
        lines.pop_back();
    return lines;
}

/// A page to print: the grid before the first step, and below it, in columns, what is asked.
Drawing page_of(const Trace& trace) {
    FigureMaker maker(trace, {{.steps = {.first = 1, .last = 1}, .is_question = true}}, {});
    Drawing page = maker.figure(0);
    const std::vector<std::string> lines = printed_lines(trace);
    constexpr double size = 12;
    constexpr double line_height = 22; // room for a hand
    constexpr double margin = 16;
    std::size_t longest = 1;
    for (const std::string& line : lines)
        longest = std::max(longest, columns_in(line));
    const double column_width = static_cast<double>(longest) * size * 0.62 + margin;
    // As many columns as the grid is wide; more, where the page would be much higher than wide.
    constexpr double highest = 1.4;
    const auto count = static_cast<double>(lines.size());
    const double columns =
        std::max(std::floor((page.width - margin) / column_width),
                 std::ceil(std::sqrt(count * line_height / column_width / highest)));
    const auto rows = static_cast<std::size_t>(std::ceil(count / columns));
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto column = static_cast<double>(i / rows);
        const auto row = static_cast<double>(i % rows);
        page.shapes.push_back(
            Label{.at = {margin + column * column_width, page.height + margin + row * line_height},
                  .text = printable(lines[i]),
                  .size = size,
                  .is_fixed_width = true});
    }
    page.width = std::max(page.width, 2 * margin + columns * column_width);
    page.height += 2 * margin + static_cast<double>(rows) * line_height;
    return page;
}

class SheetCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {
            "sheet", "Write the empty sheet of a scene: to work out by hand, fill in, and check",
            "rastertrace sheet examples/t0-fill/first-triangle.json\n\n"
            "Fill in the file and check it: rastertrace check examples/t0-fill/first-triangle.json "
            "sheet.csv"};
    }

    void add_to(OptionList& options) override {
        options.option("scene", path_, trace_input, "FILE").required();
        options.option("-o,--output", output_,
                       "Where it goes: .txt, .csv for a spreadsheet, .svg, .png or .tex to print; "
                       "none: standard output, as text",
                       "FILE");
        drawing_.add_to(options, Holds::steps);
    }

    void read() override {
        drawing_.read_into(options_);
        if (ending_of(output_) == ".pdf")
            throw problem_of(output_, "expected .txt, .csv, .svg, .png or .tex, found .pdf",
                             "write a .tex, and pdflatex makes the PDF of it");
        if (!output_.empty() && output_ != "-")
            format_ = format_by_ending<SheetFormat>(output_, endings).value_or(SheetFormat::text);
    }

    int run() override {
        Source source = load_scene_trace_or_claims(path_, options_.input);
        if (is_claims(source))
            throw problem_of(source.name, "expected a scene or a trace, found claims");
        InputFrames input(
            path_, std::move(source),
            {.method = options_.method, .limits = options_.input, .frames = options_.frames});
        const Trace trace = input.trace(input.first());
        if (output_.empty() || output_ == "-")
            print(sheet_of(trace));
        else
            write_file(output_, sheet_of(trace), opened_files());
        return report_damage(trace);
    }

private:
    struct Options {
        MethodOverrides method;
        InputLimits input;
        FrameChoice frames;
    };

    std::string sheet_of(const Trace& trace) const {
        switch (format_) {
        case SheetFormat::columns:
            return claims_template_in_columns(trace);
        case SheetFormat::svg:
            return figure_in(FigureFormat::svg, page_of(trace), {});
        case SheetFormat::png:
            return figure_in(FigureFormat::png, page_of(trace), {});
        case SheetFormat::tex:
            return figure_in(FigureFormat::tex, page_of(trace), {});
        case SheetFormat::text:
            break;
        }
        return (path_ == "-" ? "" : scene_line(path_) + "\n") + claims_template(trace);
    }

    std::string path_;
    std::string output_;
    SheetFormat format_ = SheetFormat::text;
    Options options_;
    DrawingOptions drawing_;
};

} // namespace

std::unique_ptr<Command> sheet_command() {
    return std::make_unique<SheetCommandLine>();
}

} // namespace rastertrace
