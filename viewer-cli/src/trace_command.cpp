// SPDX-License-Identifier: MIT
// `rastertrace trace`: draws a scene and writes its trace; or writes a part of one that is there.

#include "commands.h"
#include "load.h"

#include <rastertrace/trace/excerpt.h>
#include <rastertrace/trace/output.h>
#include <rastertrace/trace/text.h>
#include <rastertrace/trace/trace_text.h>

#include <fmt/core.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace rastertrace {

namespace {

/// JSON Lines for a file that is named so, else one JSON document.
TraceLayout layout_of(const TraceCommand& command) {
    if (command.layout)
        return *command.layout;
    return command.output.ends_with(".jsonl") ? TraceLayout::jsonl : TraceLayout::json;
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

/// The file of a frame: its number, with as many digits as the last one has, in front of the ending.
std::string path_of_frame(const std::string& path, std::size_t frame, std::size_t frames) {
    const std::filesystem::path whole(path);
    const std::size_t digits = std::to_string(frames).size();
    return (whole.parent_path() / fmt::format("{}-{:0{}}{}", whole.stem().string(), frame, digits,
                                              whole.extension().string()))
        .string();
}

/// Lets the program have this many files open, or says that it cannot.
void allow_open_files(std::size_t frames) {
    constexpr rlim_t of_frame = 2; // the file and its folder
    constexpr rlim_t others = 32;
    const rlim_t needed = of_frame * frames + others;
    rlimit limit{};
    if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || needed <= limit.rlim_cur)
        return;
    if (needed > limit.rlim_max)
        throw problem_of("",
                         fmt::format("expected at most {} frames to write at once, found {}",
                                     (limit.rlim_max - others) / of_frame, frames),
                         "--frame 1 writes the first; `ulimit -H -n` tells how many files may be "
                         "open");
    limit.rlim_cur = needed;
    ::setrlimit(RLIMIT_NOFILE, &limit);
}

/// Writes a file for each frame. All are written before the first one gets its name.
void write_frames(const TraceCommand& command, InputFrames& input, const TraceOptions& options) {
    std::error_code error;
    if (std::filesystem::exists(command.output, error) &&
        !std::filesystem::is_regular_file(command.output, error))
        throw problem_of(
            command.output,
            fmt::format("expected a name for {} files, found a device or a folder", input.last()),
            "--frame 1 writes the first");
    allow_open_files(input.last());
    std::deque<FileOutput> files;
    for (std::size_t frame = input.first(); frame <= input.last(); ++frame) {
        const PlannedScene planned = input.scene(frame);
        check_primitive(command, planned.scene);
        FileOutput& file =
            files.emplace_back(path_of_frame(command.output, frame, input.last()), planned.files);
        write_trace(planned.scene, planned.plan, options, file);
    }
    for (FileOutput& file : files)
        file.commit();
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
    write_excerpt(value_or_throw(read_trace(given)), text.header_json(), kinds, layout_of(command),
                  output);
}

} // namespace

int run(const TraceCommand& command) {
    InputFrames input(
        command.scene,
        {.method = command.method, .limits = command.input, .frames = command.frames});
    const TraceOptions options{.layout = layout_of(command), .filter = command.filter};
    const bool is_printed = command.output.empty() || command.output == "-";
    if (const Source* const given = input.given_trace()) {
        if (is_printed) {
            DescriptorOutput output(STDOUT_FILENO, "standard output");
            write_part(*given, command, output);
            return exit_fine;
        }
        FileOutput output(command.output,
                          given->file ? std::vector{*given->file} : std::vector<FileId>{});
        write_part(*given, command, output);
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

    const auto [scene, plan, files, remarks] = input.scene(input.first());
    check_primitive(command, scene);
    if (is_printed) {
        DescriptorOutput output(STDOUT_FILENO, "standard output");
        write_trace(scene, plan, options, output);
        return exit_fine;
    }
    FileOutput output(command.output, files);
    write_trace(scene, plan, options, output);
    output.commit();
    return exit_fine;
}

} // namespace rastertrace
