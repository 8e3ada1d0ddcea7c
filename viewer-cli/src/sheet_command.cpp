// SPDX-License-Identifier: MIT
// `rastertrace sheet`: the empty sheet of a worked example, to fill in and to be checked.

#include "command.h"
#include "commands.h"
#include "figure_file.h"
#include "load.h"
#include "output_ending.h"
#include "shared_options.h"
#include "sheet_page.h"

#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/check/claims_template.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/process_files.h>

#include <array>
#include <memory>
#include <string>
#include <utility>

namespace rastertrace {

namespace {

enum class SheetFormat { text, columns, svg, png, tex };

constexpr std::array<Ending<SheetFormat>, 5> endings{{{".txt", SheetFormat::text},
                                                      {".csv", SheetFormat::columns},
                                                      {".svg", SheetFormat::svg},
                                                      {".png", SheetFormat::png},
                                                      {".tex", SheetFormat::tex}}};

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
        const std::string sheet = sheet_of(trace, input.given_scene());
        if (output_.empty() || output_ == "-") {
            print(sheet);
        } else {
            const std::vector<FileId> read = opened_files();
            if (format_ == SheetFormat::text || format_ == SheetFormat::columns)
                refuse_filled_sheet(output_, sheet);
            write_file(output_, sheet, read);
        }
        return report_damage(trace);
    }

private:
    struct Options {
        MethodOverrides method;
        InputLimits input;
        FrameChoice frames;
    };

    std::string sheet_of(const Trace& trace, const Source* scene) const {
        switch (format_) {
        case SheetFormat::columns:
            return claims_template_in_columns(trace);
        case SheetFormat::svg:
            return figure_in(FigureFormat::svg, sheet_page(trace, scene), {});
        case SheetFormat::png:
            return figure_in(FigureFormat::png, sheet_page(trace, scene), {});
        case SheetFormat::tex:
            return figure_in(FigureFormat::tex, sheet_page(trace, scene), {});
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
