// SPDX-License-Identifier: MIT
// `rastertrace sheet`: the empty sheet of a worked example, to fill in and to be checked.

#include "app/command.h"
#include "app/exit_status.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/shared_options.h"

#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/check/claims_table.h>
#include <rastertrace/trace/check/claims_template.h>
#include <rastertrace/trace/check/exercise.h>
#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/process_files.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace rastertrace {

namespace {

enum class SheetFormat { text, columns };

constexpr std::array<Ending<SheetFormat>, 2> sheet_endings{
    {{".txt", SheetFormat::text}, {".csv", SheetFormat::columns}}};

/// What a scene gives to work with, and by which rules, as comments: `# vertices: {A: [2, 5], B: [-4, -3]}`. Without
/// quotes, which a spreadsheet would double.
std::string given_lines(const Source& scene, const Trace& trace) {
    std::string lines;
    const auto document = value_or_throw(parse_json(scene));
    for (const auto& [key, value] : document.root().members()) {
        if (key.text == "method" || key.text.starts_with('$'))
            continue;
        std::string text = in_one_line(scene.view().substr(value.begin, value.end() - value.begin));
        std::erase(text, '"');
        lines += fmt::format("# {}: {}\n", key.text, text);
    }
    std::vector<std::string> rules;
    for (const auto& [key, value] : trace.method.words)
        if (key != "scalar") // who works by hand has exact numbers
            rules.push_back(fmt::format("{} {}", key, value));
    return lines + fmt::format("# method: {}\n", joined(rules, ", "));
}

/// Throws a Problem if another file than this empty sheet is there: what was filled in would be lost.
void refuse_filled_sheet(const std::string& path, std::string_view empty) {
    const ReadToReplace to_be_replaced;
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error) &&
        value_or_throw(read_named_file(path, {})).view() != empty)
        throw problem_of(path, "expected no sheet that has been filled in, found one",
                         "give -o another name, or remove the file");
}

class SheetCommand final : public Command {
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
        options.option(
            "--seed", seed_,
            "Of an exercise: the scene with other numbers, as much work, the same for the "
            "same word, such as a student's number",
            "NAME");
        options
            .option("--format", format_name_, "How to write it, whatever the file's name", "NAME")
            .values({"text", "csv"});
        options.option("-o,--output", output_,
                       "Where it goes: .txt, or .csv for a spreadsheet; none: standard output, as "
                       "text",
                       "FILE");
        drawing_.add_to(options, Holds::steps);
    }

    void read() override {
        scenes_ = drawing_.scene_options();
        if (!seed_.empty())
            exercise_ = value_or_throw(exercise_id(seed_));
        if (!format_name_.empty())
            format_ = *value_of<SheetFormat>("--format", format_name_, {"text", "csv"});
        else if (!output_.empty() && output_ != "-")
            format_ =
                format_by_ending<SheetFormat>(output_, sheet_endings).value_or(SheetFormat::text);
    }

    int run() override {
        Source source = load_scene_trace_or_claims(path_, scenes_.limits);
        if (is_claims(source))
            throw problem_of(source.name, "expected a scene or a trace, found claims");
        if (!exercise_.empty()) {
            if (is_trace(source))
                throw problem_of(source.name, "--seed: expected a scene, found a trace");
            source = exercises_like(source)(exercise_);
        }
        const Source scene = exercise_.empty() ? Source{} : source;
        InputFrames input(path_, std::move(source), scenes_);
        const Trace trace = input.trace(input.first());
        const std::string sheet = sheet_of(scene, trace);
        if (output_.empty() || output_ == "-") {
            print(sheet);
        } else {
            refuse_filled_sheet(output_, sheet);
            write_file(output_, sheet);
        }
        return report_damage(trace);
    }

private:
    std::string sheet_of(const Source& scene, const Trace& trace) const {
        const bool is_text = format_ == SheetFormat::text;
        std::string head = exercise_.empty() ? "" : exercise_line(exercise_);
        if (is_text && path_ != "-")
            head += scene_line(path_);
        if (!exercise_.empty())
            head += given_lines(scene, trace);
        return (head.empty() ? "" : head + "\n") +
               (is_text ? claims_template(trace) : claims_template_in_columns(trace));
    }

    std::string path_;
    std::string seed_;
    std::string exercise_; ///< the ID of one, or ""
    std::string output_;
    std::string format_name_;
    SheetFormat format_ = SheetFormat::text;
    DrawingOptions drawing_;
    SceneOptions scenes_;
};

} // namespace

std::unique_ptr<Command> sheet_command() {
    return std::make_unique<SheetCommand>();
}

} // namespace rastertrace
