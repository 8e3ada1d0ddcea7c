// SPDX-License-Identifier: MIT
#include "one_drawing.h"

#include "load.h"

#include <rastertrace/figures/space_frames.h>
#include <rastertrace/trace/record/selector.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/process_files.h>

#include <optional>
#include <string>

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

ExitStatus write_space_frames(const FigureCommand& command, FigureFormat format) {
    InputFrames input(command.trace, {.method = command.method,
                                      .limits = command.input,
                                      .frames = command.frames,
                                      .tells_steps = true});
    if (input.is_sequence())
        throw problem_of("", "--sheet: expected one scene, found a sequence",
                         "--frame N takes one");
    const Trace trace = input.trace(input.first());
    std::optional<std::size_t> step;
    if (command.which == FigureCommand::Which::step) {
        const Selector selector =
            value_or_throw(parse_selector({"--step", command.selector}, trace));
        step = value_or_throw(matching_step(selector, trace, "say which"));
    }
    const ExitStatus status = report_damage(trace);
    const auto draw = [&](double letter_scale) {
        return space_frames(trace, *command.frames_in_space, step, command.options.eye,
                            letter_scale);
    };
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
    return status;
}

} // namespace rastertrace
