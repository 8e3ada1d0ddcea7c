// SPDX-License-Identifier: MIT
// `rastertrace convert`: a trace in another form, for programs that read tables.

#include "command.h"
#include "commands.h"
#include "load.h"
#include "option_values.h"
#include "shared_options.h"
#include "written_trace.h"

#include <rastertrace/trace/record/excerpt.h>
#include <rastertrace/trace/record/flat_steps.h>
#include <rastertrace/trace/record/step_stream.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/csv.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rastertrace {

namespace {

/// A form, and how its steps are flat, if they are.
struct ConvertedForm {
    std::string_view name;
    std::optional<FlatForm> flat;
};
constexpr std::array<ConvertedForm, 3> forms{
    {{"csv", FlatForm::csv}, {"jsonl", std::nullopt}, {"flat", FlatForm::lines}}};

std::vector<std::string_view> form_names() {
    std::vector<std::string_view> names;
    for (const ConvertedForm& form : forms)
        names.push_back(form.name);
    return names;
}

std::optional<ConvertedForm> form_named(std::string_view name) {
    const auto form = std::ranges::find(forms, name, &ConvertedForm::name);
    return form == forms.end() ? std::nullopt : std::optional(*form);
}

/// The columns of flat steps as CSV: the name, the type in SQL, and which steps may have a value.
std::string columns_text() {
    std::string text;
    put_csv_line(text, {"column", "type", "steps"});
    for (const FlatColumn& column : flat_columns())
        put_csv_line(text, {column.name, std::string(sql_name(column.type)),
                            column.kinds.empty() ? "any" : joined(column.kinds, " ")});
    return text;
}

class ConvertCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {"convert", "Write a trace as a table of steps, or in JSON Lines",
                "rastertrace convert examples/t0-fill/first-triangle.json --to csv -o steps.csv\n\n"
                "flat: a JSON object a step, with the columns of csv; jsonl: the trace itself.\n"
                "--columns prints the columns, their types in SQL, and which steps have them."};
    }

    void add_to(OptionList& options) override {
        options.option("trace", path_, trace_input, "TRACE");
        options.option("--to", to_, "What to write", "NAME").values(form_names());
        options.option("-o,--output", output_,
                       "Write to this file (.gz, .zst: packed) instead of standard output", "FILE");
        options.flag("--columns", prints_columns_, "Print the columns instead");
        drawing_.add_to(options, Holds::no_steps);
    }

    void read() override {
        if (prints_columns_ && !(path_.empty() && to_.empty()))
            refuse_value("--columns", "no trace and no --to beside it",
                         path_.empty() ? to_ : path_);
        if (!prints_columns_ && path_.empty())
            throw problem_of("", "convert: expected a trace, found none",
                             "- is standard input; --columns prints the columns");
        if (!prints_columns_ && to_.empty())
            throw problem_of("", fmt::format("convert: expected --to {}, found none",
                                             joined(form_names(), ", --to ")));
        if (!prints_columns_)
            form_ = *value_of("--to", to_, form_names(), form_named);
        drawing_.read_into(options_);
    }

    int run() override {
        if (prints_columns_) {
            write_whole(output_, [](Output& output) { output.write(columns_text()); });
            return exit_fine;
        }
        const TraceProgress progress("convert", output_);
        auto opened = open_input(path_, scene_options());
        write_whole(output_, [&](Output& output) {
            write_flat(form_.flat, output, [&](Output& lines) {
                std::visit([&](auto& input) { write_lines(input, lines); }, opened);
            });
        });
        return exit_fine;
    }

private:
    struct Options {
        MethodOverrides method;
        InputLimits input;
        FrameChoice frames;
    };

    SceneOptions scene_options() const {
        return {.method = options_.method, .limits = options_.input, .frames = options_.frames};
    }

    /// Writes the trace in JSON Lines. Throws the Problem of one that is damaged.
    static void write_lines(StepStream& steps, Output& output) {
        write_all(steps, TraceLayout::jsonl, output);
        if (const auto remark = steps.not_finite().remark())
            print_error(*remark);
    }

    /// The same of a scene, drawn, or of a trace that has not one step a line.
    void write_lines(const Source& source, Output& output) const {
        InputFrames input(path_, source, scene_options());
        if (const Source* const given = input.given_trace())
            return write_part_of(*given, {}, TraceLayout::jsonl, output);
        const PlannedScene planned = input.scene(input.first());
        write_trace(planned.scene, planned.plan, {.layout = TraceLayout::jsonl, .filter = {}},
                    output);
    }

    std::string path_;
    std::string to_;
    std::string output_;
    bool prints_columns_ = false;
    ConvertedForm form_{};
    Options options_;
    DrawingOptions drawing_;
};

} // namespace

std::unique_ptr<Command> convert_command() {
    return std::make_unique<ConvertCommandLine>();
}

} // namespace rastertrace
