// SPDX-License-Identifier: MIT
#include "one_drawing.h"

#include "load.h"
#include "progress.h"
#include "suite_cases.h"

#include <rastertrace/figures/heat_map.h>
#include <rastertrace/figures/space_frames.h>
#include <rastertrace/figures/svg.h>
#include <rastertrace/trace/record/selector.h>
#include <rastertrace/trace/record/step_stream.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/canvas_json.h>
#include <rastertrace/trace/text/line_output.h>
#include <rastertrace/trace/text/process_files.h>

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

HouseStyle style_of(const FigureCommand& command) {
    if (command.house_style.empty())
        return {};
    return value_or_throw(
        house_style_in(value_or_throw(read_named_file(command.house_style, command.input))));
}

bool chooses_letters(const FigureCommand& command, FigureFormat format) {
    return format == FigureFormat::tex && !command.style.letter_scale && !command.is_bare;
}

namespace {

SceneOptions scene_options_of(const FigureCommand& command) {
    return {.method = command.method,
            .limits = command.input,
            .frames = command.frames,
            .tells_steps = true};
}

void refuse_sequence(const InputFrames& input, std::string_view option) {
    if (input.is_sequence())
        throw problem_of("", fmt::format("{}: expected one scene, found a sequence", option),
                         "--frame N takes one");
}

/// Writes what `draw` draws, with letters of a size.
void write_drawing(const FigureCommand& command, FigureFormat format,
                   const std::function<Drawing(double letter_scale)>& draw) {
    Drawing drawing = draw(
        chooses_letters(command, format)
            ? letter_scale_for_tex([&](double scale) { return draw(scale).width; }, command.style)
            : command.options.letter_scale);
    apply(style_of(command), drawing);
    const std::string bytes = figure_in(format, drawing, command.style);
    if (command.output == "-")
        print(bytes);
    else
        write_file(command.output, bytes, opened_files());
}

/// The map of a trace, and what stands in front of its steps: a trace without any.
struct CountedTrace {
    Trace header;
    HeatMap map;
};

/// Counts steps as they are read; none is kept.
CountedTrace counted(Heat heat, StepStream& steps) {
    CountedTrace all{steps.header().without_steps(), {heat, steps.header().canvas}};
    while (steps.next())
        all.map.add(steps.step(), steps.kind());
    all.header.damage = steps.damage();
    all.header.not_finite = steps.not_finite();
    return all;
}

/// The same of a trace that has not one step a line.
CountedTrace counted(Heat heat, Trace&& trace) {
    CountedTrace all{trace.without_steps(), {heat, trace.canvas}};
    for (std::size_t n = 1; n <= trace.size(); ++n)
        all.map.add(trace.step(n), trace.kind_of(n));
    all.header.damage = std::move(trace.damage);
    all.header.not_finite = std::move(trace.not_finite);
    return all;
}

/// The same of the trace of a scene, as it is written.
CountedTrace counted(Heat heat, const PlannedScene& planned, const std::string& name) {
    const StepKind kind = steps_for(heat);
    std::optional<CountedTrace> all;
    LineOutput lines([&](std::string_view line) {
        if (!all) {
            Source header{name, std::string(line) + "\n{\"end\":{}}\n"};
            Trace trace = value_or_throw(read_written_trace(std::move(header)));
            const Canvas canvas = trace.canvas;
            all.emplace(CountedTrace{std::move(trace), {heat, canvas}});
        } else if (line.starts_with(front_of_step)) {
            all->map.add(StepView(line), kind);
        }
    });
    write_trace(planned.scene, planned.plan,
                {.layout = TraceLayout::jsonl, .filter = {.only = {{kind}}}}, lines);
    return *std::move(all);
}

CountedTrace counted(const FigureCommand& command, const std::string& path) {
    const SceneOptions options = scene_options_of(command);
    const Heat heat = *command.heat;
    auto opened = open_input(path, options);
    if (auto* const steps = std::get_if<StepStream>(&opened))
        return counted(heat, *steps);
    InputFrames input(path, std::get<Source>(std::move(opened)), options);
    refuse_sequence(input, "--heat");
    const std::size_t frame = input.first();
    return input.given_trace() != nullptr ? counted(heat, input.trace(frame))
                                          : counted(heat, input.scene(frame), path);
}

/// Refuses a trace that the counted steps were left out of.
void check_counted(const CountedTrace& trace, const std::string& file) {
    const StepKind kind = steps_for(trace.map.heat());
    if (trace.header.lacks(kind))
        throw problem_of(file, fmt::format("--heat {}: expected a trace with its {} steps, found "
                                           "one that they were left out of",
                                           name_of(trace.map.heat()), name_of(kind)));
}

/// The scenes and traces that are counted: a file, or those of a suite.
std::vector<std::string> counted_files(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::is_directory(path, error))
        return {path};
    std::vector<std::string> files;
    for (const SuiteCase& one : cases_below(path))
        if (!one.has_claims())
            files.push_back(one.path);
    if (files.empty())
        throw problem_of(path, "expected a folder with scenes or traces, found one without");
    return files;
}

/// "17 x 14 pixels, origin center"
std::string in_words(const Canvas& canvas) {
    return fmt::format("{} x {} pixels, origin {}", canvas.width, canvas.height,
                       name_of(canvas.origin));
}

/// One map of all of them, with the header of the first; what is wrong with any of them is told.
CountedTrace counted_all(const FigureCommand& command, ExitStatus& status) {
    const std::vector<std::string> files = counted_files(command.trace);
    const Progress progress(reading_of("figure", files));
    std::optional<CountedTrace> all;
    for (const std::string& file : files) {
        CountedTrace one = counted(command, file);
        status = std::max(status, report_damage(one.header));
        check_counted(one, files.size() > 1 ? file : "");
        if (!all) {
            all.emplace(std::move(one));
            continue;
        }
        if (!(one.header.canvas == all->header.canvas))
            throw problem_of(file, fmt::format("expected the canvas of {}, {}, found {}",
                                               files.front(), in_words(all->header.canvas),
                                               in_words(one.header.canvas)));
        all->map.add(one.map);
    }
    const HeatMap& map = all->map;
    if (steps_for(map.heat()) == StepKind::depth && map.steps() == 0)
        throw problem_of(
            "", fmt::format("--heat {}: expected depth tests, found none", name_of(map.heat())),
            "--depth linear-z --keep depth tests what no other triangle can hide, too");
    const std::string folder = command.trace.substr(0, command.trace.find_last_not_of('/') + 1);
    all->header.title = shown_title(files.size() > 1 ? "" : all->header.title, folder);
    return *std::move(all);
}

} // namespace

ExitStatus write_space_frames(const FigureCommand& command, FigureFormat format) {
    InputFrames input(command.trace, scene_options_of(command));
    refuse_sequence(input, "--sheet");
    const Trace trace = input.trace(input.first());
    std::optional<std::size_t> step;
    if (command.which == FigureCommand::Which::step) {
        const Selector selector =
            value_or_throw(parse_selector({"--step", command.selector}, trace));
        step = value_or_throw(matching_step(selector, trace, "say which"));
    }
    const ExitStatus status = report_damage(trace);
    write_drawing(command, format, [&](double scale) {
        return space_frames(trace, *command.frames_in_space, step, command.options.eye, scale);
    });
    return status;
}

ExitStatus write_heat_map(const FigureCommand& command, FigureFormat format) {
    ExitStatus status = exit_fine;
    CountedTrace trace = counted_all(command, status);
    FigureOptions options = command.options;
    if (options.region)
        check_region(*options.region, trace.header.canvas);
    options.heat = &trace.map;
    options.heat_in_grays = command.style.theme == Theme::print;
    FigureMaker maker(trace.header, {{}}, options);
    write_drawing(command, format, [&](double scale) {
        maker.set_letter_scale(scale);
        return maker.figure(0);
    });
    return status;
}

} // namespace rastertrace
