// SPDX-License-Identifier: MIT
// `rastertrace trace`: draws a scene and writes its trace; or writes a part of one that is there.

#include "command.h"
#include "commands.h"
#include "frame_files.h"
#include "load.h"
#include "option_values.h"
#include "output_ending.h"
#include "progress.h"
#include "shared_options.h"

#include <rastertrace/trace/record/excerpt.h>
#include <rastertrace/trace/record/trace_text.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/packed.h>
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

/// By the ending of the file's name, where there is one; else a JSON document.
TraceLayout layout_of(const TraceCommand& command) {
    if (command.layout)
        return *command.layout;
    return format_by_ending<TraceLayout>(std::string(without_packing(command.output)),
                                         trace_endings)
        .value_or(TraceLayout::json);
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

/// Lets somebody write to an output, packed if the name of the file says so.
template <typename Write>
void write_packed(const TraceCommand& command, Output& output, const Write& write) {
    PackedOutput packed(output, packing_named(command.output));
    write(packed);
    packed.finish();
}

/// Writes a file for each frame.
void write_frames(const TraceCommand& command, InputFrames& input, const TraceOptions& options) {
    FrameFiles files(command.output, input.last());
    for (std::size_t frame = input.first(); frame <= input.last(); ++frame) {
        const PlannedScene planned = input.scene(frame);
        check_primitive(command, planned.scene);
        write_packed(command, files.open(frame), [&](Output& output) {
            write_trace(planned.scene, planned.plan, options, output);
        });
    }
    files.commit();
}

/// Writes steps of a trace that is there already.
void write_part(const Source& given, const TraceCommand& command, Output& output) {
    if (command.filter.region || command.filter.primitive)
        throw problem_of(given.name,
                         fmt::format("expected a scene for --{}, found a trace",
                                     command.filter.region ? "region" : "primitive"),
                         "of a trace, --only writes the steps of some kinds");
    std::vector<std::string> kinds;
    for (const StepKind kind : command.filter.only.value_or(std::vector<StepKind>{}))
        kinds.emplace_back(name_of(kind));
    const TraceText text(given);
    const Trace trace = value_or_throw(read_trace(given));
    write_excerpt(trace, text.header_json(), kinds, layout_of(command), output);
    report_damage(trace);
}

} // namespace

int run(const TraceCommand& command) {
    const TraceOptions options{.layout = layout_of(command), .filter = command.filter};
    InputFrames input(
        command.scene,
        {.method = command.method, .limits = command.input, .frames = command.frames});
    const bool is_printed = command.output.empty() || command.output == "-";
    std::optional<Progress> progress;
    if (!is_printed || ::isatty(STDOUT_FILENO) == 0)
        progress.emplace(LongWork{.doing = "trace",
                                  .unit = "MB written",
                                  .done = [] { return bytes_done().written; },
                                  .one_unit = bytes_in_a_megabyte});
    if (const Source* const given = input.given_trace()) {
        if (is_printed) {
            DescriptorOutput output = standard_output();
            write_part(*given, command, output);
            return exit_fine;
        }
        FileOutput output(command.output, opened_files());
        write_packed(command, output, [&](Output& packed) { write_part(*given, command, packed); });
        output.commit();
        return exit_fine;
    }
    if (input.is_sequence() && is_printed)
        throw problem_of(
            command.scene,
            fmt::format("expected one frame for standard output, found {}", input.last()),
            "--frame 1 writes the first; -o scene.json writes each to a file, "
            "scene-1.json and so on");
    if (input.is_sequence()) {
        write_frames(command, input, options);
        return exit_fine;
    }

    const auto [scene, plan, remarks] = input.scene(input.first());
    check_primitive(command, scene);
    if (is_printed) {
        DescriptorOutput output = standard_output();
        write_trace(scene, plan, options, output);
        return exit_fine;
    }
    FileOutput output(command.output, opened_files());
    write_packed(command, output, [&, &scene = scene, &plan = plan](Output& packed) {
        write_trace(scene, plan, options, packed);
    });
    output.commit();
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
        options.option(
            "-o,--output", command_.output,
            "Write to this file (.jsonl: JSON Lines; .gz, .zst: packed) instead of standard output",
            "FILE");
        options.option("--format", format_, "How to write it, whatever the file's name", "NAME")
            .values({"json", "jsonl"});
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
