// SPDX-License-Identifier: MIT
// `rastertrace trace`: draws a scene and writes its trace; or writes a part of one that is there.

#include "app/command.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/output_ending.h"
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

struct TraceCommand {
    std::string scene;
    std::string output; ///< empty: standard output
    std::optional<TraceLayout> layout;
    bool is_flat = false; ///< see flat_steps.h
    StepFilter filter;
    MethodOverrides method;
    InputLimits input;
    FrameChoice frames;
};

constexpr std::array<Ending<TraceLayout>, 2> trace_endings{
    {{".json", TraceLayout::json}, {".jsonl", TraceLayout::jsonl}}};

/// By the ending of the file's name, where there is one; else a JSON document. Flat steps are made of lines.
TraceLayout layout_of(const TraceCommand& command) {
    const std::string ending = ending_of(command.output);
    if (ending == ".gz" || ending == ".zst") // nothing is packed
        refuse_ending(command.output, endings_in<TraceLayout>(trace_endings));
    if (command.is_flat)
        return TraceLayout::jsonl;
    if (command.layout)
        return *command.layout;
    return format_by_ending<TraceLayout>(command.output, trace_endings).value_or(TraceLayout::json);
}

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

/// Lets somebody write a trace, of which the flat steps go to the output if they were asked for.
template <typename Write>
void write_as_asked(const TraceCommand& command, Output& output, const Write& write) {
    if (!command.is_flat)
        return write(output);
    FlatSteps flat(output);
    write(flat);
    flat.finish();
}

void check_primitive(const TraceCommand& command, const Scene& scene) {
    const auto& name = command.filter.primitive;
    if (!name)
        return;
    std::vector<std::string_view> names;
    for (const ScenePrimitive& primitive : scene.primitives)
        names.push_back(primitive.name);
    if (std::find(names.begin(), names.end(), *name) == names.end())
        throw problem_of(command.scene,
                         fmt::format("expected a primitive of the scene, found {}", *name),
                         did_you_mean(*name, names));
}

/// Writes the trace of a scene, or its flat steps.
void write_drawn(const TraceCommand& command, const PlannedScene& planned, Output& output) {
    check_primitive(command, planned.scene);
    const TraceOptions options{.layout = layout_of(command), .filter = command.filter};
    write_as_asked(command, output, [&](Output& lines) {
        write_trace(planned.scene, planned.plan, options, lines);
    });
}

/// Writes a file for each frame.
void write_frames(const TraceCommand& command, InputFrames& input) {
    FrameFiles files(command.output, input.last());
    for (std::size_t frame = input.first(); frame <= input.last(); ++frame) {
        const PlannedScene planned = input.scene(frame);
        write_drawn(command, planned, files.open(frame));
    }
    files.commit();
}

/// Writes steps of a trace that is there already; tells what may be wrong with it.
void write_part(const Source& given, const TraceCommand& command, Output& output) {
    if (command.filter.region || command.filter.primitive)
        throw problem_of(given.name,
                         fmt::format("expected a scene for --{}, found a trace",
                                     command.filter.region ? "region" : "primitive"),
                         "of a trace, --only writes the steps of some kinds");
    std::vector<std::string> kinds;
    for (const StepKind kind : command.filter.only.value_or(std::vector<StepKind>{}))
        kinds.emplace_back(name_of(kind));
    const Trace trace = value_or_throw(read_trace(given));
    write_as_asked(command, output,
                   [&](Output& lines) { write_excerpt(trace, kinds, layout_of(command), lines); });
    report_damage(trace);
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

} // namespace

int run(const TraceCommand& command) {
    InputFrames input(
        command.scene,
        {.method = command.method, .limits = command.input, .frames = command.frames});
    const std::optional<Progress> progress = progress_to(command.output);
    if (const Source* const given = input.given_trace()) {
        write_whole(command.output, [&](Output& output) { write_part(*given, command, output); });
        return exit_fine;
    }
    if (input.is_sequence() && is_standard_output(command.output))
        throw problem_of(
            command.scene,
            fmt::format("expected one frame for standard output, found {}", input.last()),
            "--frame 1 writes the first; -o scene.json writes each to a file, "
            "scene-1.json and so on");
    if (input.is_sequence()) {
        write_frames(command, input);
        return exit_fine;
    }

    const PlannedScene planned = input.scene(input.first());
    write_whole(command.output, [&](Output& output) { write_drawn(command, planned, output); });
    return exit_fine;
}

namespace {

class TraceCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {"trace", "Draw a scene and write its trace, or a part of a trace",
                "rastertrace trace examples/t0-fill/first-triangle.json --only "
                "scanline -o rows.json"};
    }

    void add_to(OptionList& options) override {
        options
            .option("scene", command_.scene,
                    "A scene, or a trace to cut down; - for standard input", "SCENE")
            .required();
        options.option("-o,--output", command_.output,
                       "Write to this file (.jsonl: JSON Lines) instead of standard output",
                       "FILE");
        AddedOption format =
            options.option("--format", format_, "How to write it, whatever the file's name", "NAME")
                .values({"json", "jsonl"});
        options
            .flag("--flat", command_.is_flat,
                  "Write only the steps, each behind its number and the name of its primitive, for "
                  "databases")
            .excludes(format);
        options.option("--only", only_, "Write only these kinds of step", "KIND,...")
            .values(step_kind_names());
        options.option("--region", region_, "Write only steps that touch these pixels",
                       "x0,y0,x1,y1");
        options
            .option("--primitive", command_.filter.primitive,
                    "Write only the steps of this primitive and its parts", "NAME")
            .names_of(NamesOf::primitives);
        drawing_.add_to(options, Holds::no_steps, "without it, -o writes a file for each");
    }

    void read() override {
        if (!format_.empty() && format_ != "json" && format_ != "jsonl")
            refuse_value("--format", "json or jsonl", format_);
        if (!format_.empty())
            command_.layout = format_ == "json" ? TraceLayout::json : TraceLayout::jsonl;
        if (!only_.empty())
            command_.filter.only =
                values_of("--only", "kinds of step", only_, step_kind_names(), step_kind_named);
        command_.filter.region = region_of(region_);
        drawing_.read_into(command_);
    }

    int run() override { return rastertrace::run(command_); }

private:
    TraceCommand command_;
    std::string format_;
    std::string only_;
    std::string region_;
    DrawingOptions drawing_;
};

} // namespace

std::unique_ptr<Command> trace_command() {
    return std::make_unique<TraceCommandLine>();
}

} // namespace rastertrace
