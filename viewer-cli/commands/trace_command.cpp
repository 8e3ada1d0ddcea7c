// SPDX-License-Identifier: MIT
// `rastertrace trace`: draws a scene and writes its trace; or writes a part of one that is there.

#include "app/command.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/progress.h"
#include "app/shared_options.h"
#include "frames/frame_files.h"

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/tell/excerpt.h>
#include <rastertrace/trace/tell/flat_steps.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/process_files.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

constexpr std::array<Ending<TraceLayout>, 2> trace_endings{
    {{".json", TraceLayout::json}, {".jsonl", TraceLayout::jsonl}}};

/// True if that is no file.
bool is_standard_output(const std::string& path) {
    return path.empty() || path == "-";
}

/// Lets somebody write to standard output, or to a file that gets its name when all is there.
template <typename Write> void write_whole(const std::string& path, const Write& write) {
    if (is_standard_output(path)) {
        DescriptorOutput output = standard_output();
        write(output);
        return;
    }
    FileOutput output(path);
    write(output);
    output.commit();
}

/// The progress of the command; none beside rows on a terminal.
std::optional<Progress> progress_to(const std::string& path) {
    if (is_standard_output(path) && ::isatty(STDOUT_FILENO) != 0)
        return std::nullopt;
    return std::optional<Progress>(std::in_place,
                                   LongWork{.doing = "trace",
                                            .unit = "MB written",
                                            .done = [] { return bytes_done().written; },
                                            .one_unit = bytes_in_a_megabyte});
}

class TraceCommand final : public Command {
public:
    CommandAbout about() const override {
        return {"trace", "Draw a scene and write its trace, or a part of a trace",
                "rastertrace trace examples/t0-fill/first-triangle.json --only "
                "scanline -o rows.json"};
    }

    void add_to(OptionList& options) override {
        options
            .option("scene", scene_, "A scene, or a trace to cut down; - for standard input",
                    "SCENE")
            .required();
        options.option("-o,--output", output_,
                       "Write to this file (.jsonl: JSON Lines) instead of standard output",
                       "FILE");
        AddedOption format =
            options.option("--format", format_, "How to write it, whatever the file's name", "NAME")
                .values({"json", "jsonl"});
        options
            .flag("--flat", is_flat_,
                  "Write only the steps, each behind its number and the name of its primitive, for "
                  "databases")
            .excludes(format);
        options.option("--only", only_, "Write only these kinds of step", "KIND,...")
            .values(step_kind_names());
        options.option("--region", region_, "Write only steps that touch these pixels",
                       "x0,y0,x1,y1");
        options
            .option("--primitive", filter_.primitive,
                    "Write only the steps of this primitive and its parts", "NAME")
            .names_of(NamesOf::primitives);
        drawing_.add_to(options, Holds::no_steps, "without it, -o writes a file for each");
    }

    void read() override {
        if (!format_.empty() && format_ != "json" && format_ != "jsonl")
            refuse_value("--format", "json or jsonl", format_);
        if (!only_.empty())
            filter_.only =
                values_of("--only", "kinds of step", only_, step_kind_names(), step_kind_named);
        filter_.region = region_of(region_);
        scenes_ = drawing_.scene_options();
    }

    int run() override {
        InputFrames input(scene_, scenes_);
        const std::optional<Progress> progress = progress_to(output_);
        if (const Source* const given = input.given_trace()) {
            write_whole(output_, [&](Output& output) { write_part(*given, output); });
            return exit_fine;
        }
        if (input.is_sequence() && is_standard_output(output_))
            throw problem_of(
                scene_,
                fmt::format("expected one frame for standard output, found {}", input.last()),
                "--frame 1 writes the first; -o scene.json writes each to a file, "
                "scene-1.json and so on");
        if (input.is_sequence()) {
            FrameFiles files(output_, input.last());
            for (std::size_t frame = input.first(); frame <= input.last(); ++frame) {
                const PlannedScene planned = input.scene(frame);
                write_drawn(planned, files.open(frame));
            }
            files.commit();
            return exit_fine;
        }

        const PlannedScene planned = input.scene(input.first());
        write_whole(output_, [&](Output& output) { write_drawn(planned, output); });
        return exit_fine;
    }

private:
    /// By the ending of the file's name, where there is one; else a JSON document. Flat steps are made of lines.
    TraceLayout layout() const {
        const std::string ending = ending_of(output_);
        if (ending == ".gz" || ending == ".zst") // nothing is packed
            refuse_ending(output_, endings_in<TraceLayout>(trace_endings));
        if (is_flat_)
            return TraceLayout::jsonl;
        if (!format_.empty())
            return format_ == "json" ? TraceLayout::json : TraceLayout::jsonl;
        return format_by_ending<TraceLayout>(output_, trace_endings).value_or(TraceLayout::json);
    }

    /// Lets somebody write a trace, of which the flat steps go to the output if they were asked for.
    template <typename Write> void write_as_asked(Output& output, const Write& write) const {
        if (!is_flat_)
            return write(output);
        FlatSteps flat(output);
        write(flat);
        flat.finish();
    }

    void check_primitive(const Scene& scene) const {
        const auto& name = filter_.primitive;
        if (!name)
            return;
        std::vector<std::string_view> names;
        for (const ScenePrimitive& primitive : scene.primitives)
            names.push_back(primitive.name);
        if (std::find(names.begin(), names.end(), *name) == names.end())
            throw problem_of(scene_,
                             fmt::format("expected a primitive of the scene, found {}", *name),
                             did_you_mean(*name, names));
    }

    /// Writes the trace of a scene, or its flat steps.
    void write_drawn(const PlannedScene& planned, Output& output) const {
        check_primitive(planned.scene);
        const TraceOptions options{.layout = layout(), .filter = filter_};
        write_as_asked(output, [&](Output& lines) {
            write_trace(planned.scene, planned.plan, options, lines);
        });
    }

    /// Writes steps of a trace that is there already; tells what may be wrong with it.
    void write_part(const Source& given, Output& output) const {
        if (filter_.region || filter_.primitive)
            throw problem_of(given.name,
                             fmt::format("expected a scene for --{}, found a trace",
                                         filter_.region ? "region" : "primitive"),
                             "of a trace, --only writes the steps of some kinds");
        std::vector<std::string> kinds;
        for (const StepKind kind : filter_.only.value_or(std::vector<StepKind>{}))
            kinds.emplace_back(name_of(kind));
        const Trace trace = value_or_throw(read_trace(given));
        write_as_asked(output,
                       [&](Output& lines) { write_excerpt(trace, kinds, layout(), lines); });
        report_damage(trace);
    }

    std::string scene_;
    std::string output_; ///< empty: standard output
    std::string format_;
    bool is_flat_ = false; ///< see flat_steps.h
    std::string only_;
    std::string region_;
    StepFilter filter_;
    DrawingOptions drawing_;
    SceneOptions scenes_;
};

} // namespace

std::unique_ptr<Command> trace_command() {
    return std::make_unique<TraceCommand>();
}

} // namespace rastertrace
