// SPDX-License-Identifier: MIT
// `rastertrace show`: prints frames of a trace as text.

#include "commands/show_command.h"
#include "app/option_values.h"
#include "frames/frame_text.h"
#include "frames/off_canvas.h"
#include "frames/terminal_text.h"

#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/digest.h>
#include <rastertrace/trace/tell/selector.h>
#include <rastertrace/trace/tell/shown_steps.h>
#include <rastertrace/trace/tell/working.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

std::vector<ShownSteps> steps_to_show(const ShowCommand& command, const Trace& trace) {
    std::vector<ShownSteps> shown;
    switch (command.which) {
    case ShowCommand::Which::summary:
    case ShowCommand::Which::last:
        shown.push_back({trace.size(), trace.size()});
        break;
    case ShowCommand::Which::step: {
        const Selector selector =
            value_or_throw(parse_selector({"--step", command.selector}, trace));
        const std::size_t n =
            value_or_throw(matching_step(selector, trace, "say which, or use --every"));
        shown.push_back({n, n});
        break;
    }
    case ShowCommand::Which::every: {
        const Selector selector =
            value_or_throw(parse_selector({"--every", command.selector}, trace));
        for (const std::size_t n : value_or_throw(matching_steps(selector, trace)))
            shown.push_back({n, end_of(trace, n)});
        break;
    }
    case ShowCommand::Which::all:
        for (std::size_t n = 1; n <= trace.size(); ++n)
            shown.push_back({n, n});
        break;
    }
    return shown;
}

/// The working of a step below its sentence.
std::string indented(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += fmt::format("          {}\n", line);
    return text;
}

/// The steps of one kind, one line for each.
void print_table(const Trace& trace, const std::vector<ShownSteps>& shown,
                 const ShowCommand& command) {
    const TableFormat format = command.format.value_or(TableFormat::table);
    StepTable table(format, *trace.kind_of(shown.front().first));
    if (format == TableFormat::table)
        print(shortened(printable(trace.title), 79) + "\n\n");
    print(table.head());
    Replay replay(trace, parts_for(View::plotted, trace));
    for (const ShownSteps& steps : shown) {
        replay.go_to(steps.first);
        print(table.line(replay));
        if (command.has_working)
            print(indented(working_of(replay)));
    }
    print(table.end());
}

/// True if steps are to be told as a table: asked for, or of a kind that there are many of.
bool is_table(const ShowCommand& command, const Trace& trace,
              const std::vector<ShownSteps>& shown) {
    const bool is_every = command.which == ShowCommand::Which::every;
    if ((!is_every && !command.format) || command.bare || command.asks_for_frames())
        return false;
    const std::size_t first = shown.front().first;
    const auto kind = first == 0 ? std::nullopt : trace.kind_of(first);
    if (command.format && !kind)
        throw problem_of("", "--format: expected steps of a kind that has a table, found another");
    return kind && (command.format || (is_told_as_table(*kind) && shown.size() > 1));
}

/// More frames of a sequence than anyone scrolls through.
constexpr std::size_t most_on_terminal = 1000;

/// Refuses a sequence where it makes no sense to print all of it.
void check_sequence(const ShowCommand& command, const InputFrames& input) {
    const std::size_t count = input.last() - input.first() + 1;
    if (count > most_on_terminal && ::isatty(STDOUT_FILENO) != 0)
        throw problem_of(command.trace,
                         fmt::format("expected a sequence of at most {} frames for a terminal, "
                                     "found {}",
                                     most_on_terminal, count),
                         "--frame 1 shows the first; a file or a pipe takes all of them");
    if (input.is_sequence() && command.format && *command.format != TableFormat::table)
        throw problem_of(command.trace,
                         fmt::format("--format: expected one frame, found {}", count),
                         "--frame 1 makes a table of the first");
}

/// `faces` have letters; those of the frame before, then those of this one.
ExitStatus show(const Trace& trace, const ShowCommand& command, FaceGroups& faces) {
    const auto shown = steps_to_show(command, trace);
    if (is_table(command, trace, shown)) {
        print_table(trace, shown, command);
        return report_damage(trace);
    }
    const TextSize size = output_size();
    if (command.region)
        check_region(*command.region, trace.canvas);
    const View view = command.view   ? *command.view
                      : command.bare ? View::plotted
                                     : default_view(trace);

    const std::string below = command.bare ? std::string() : text_below(trace);
    Replay replay(trace, parts_for(view, trace));
    if (view == View::faces) {
        replay.go_to(trace.size());
        faces = lettered_faces(replay, faces);
    }
    bool is_first = true;
    for (const ShownSteps& steps : shown) {
        FrameText about{.caption = {},
                        .first_step = steps.first,
                        .last_step = steps.last,
                        .view = view,
                        .colors = output_colors(command.color),
                        .region = command.region,
                        .below = below,
                        .faces = &faces};
        if (!command.bare) {
            replay.go_to(steps.first);
            about.caption = describe_step(replay);
            if (command.has_working)
                about.working = working_of(replay);
        }

        // Where vertices are still on their way to the screen, many frames would be many empty
        // grids: each is its words.
        if (!command.bare && replay.step() > 0 && replay.primitive() == 0 && shown.size() > 1) {
            print(fmt::format("{}{:>4}  {}\n",
                              is_first ? shortened(printable(trace.title), 79) + "\n\n" : "",
                              steps.first, about.caption) +
                  indented(about.working));
            is_first = false;
            continue;
        }
        replay.go_to(steps.last);
        if (command.which == ShowCommand::Which::summary) {
            print(summary_text(replay, about, size));
            break;
        }
        const std::string blank_line = is_first ? "" : "\n";
        print(blank_line + (command.bare
                                ? bare_frame_text(replay, view, command.region, about.faces)
                                : frame_text(replay, about, size)));
        is_first = false;
    }
    print(below);
    return report_damage(trace);
}

} // namespace

CommandAbout ShowCommand::about() const {
    return {"show", "Print frames of a trace as text",
            "rastertrace show examples/t0-fill/first-triangle.json --every scanline\n\n"
            "In a frame, . is empty, # plotted, @ plotted by the step shown, x tested and not "
            "drawn, a letter a\nvertex; --view faces, shade, depth, writes or coverage show more.\n"
            "STEP is a number, first, last, or a kind of step with what it has:\n"
            "  14, scanline, \"scanline y=2\", \"depth x=3 y=2 fail\", \"pixel in=ABC\""};
}

void ShowCommand::add_to(OptionList& options) {
    options.option("trace", trace, trace_input, "TRACE").required();
    OptionList frames = options.one_of(
        "Which frames",
        "One of these; if none is given, what the scene is about and all of its picture");
    frames.option("--step", step_, "After this step, from 0", "STEP");
    frames.option("--every", every_,
                  "After every such step, together with the pixels that belong to it", "STEP");
    frames.flag("--all", all_, "After every step");
    options.flag("--bare", bare, "Only the grid: . empty, # plotted, top row first");
    add_view_to(options, view_name_);
    options.option("--region", region_text_, "Show only these pixels", "x0,y0,x1,y1");
    options.flag("--working", has_working,
                 "Write out how the numbers of a step come of one another");
    options
        .option("--format", format_name_, "With --every or --step: the steps in this form", "NAME")
        .values(table_format_names());
    options.flag("--json", is_json_, "The same: short for --format json");
    options.option("--color", color_name_, "Colors, on a terminal", "WHEN").values(color_choices);
    options.language();
    drawing_.add_to(options, Holds::steps, "all if not given");
}

void ShowCommand::read() {
    if (bare || has_working)
        which = Which::last;
    if (!step_.empty())
        which = Which::step;
    if (!every_.empty())
        which = Which::every;
    selector = step_ + every_; // one of them, at most
    if (all_)
        which = Which::all;
    view = value_of("--view", view_name_, view_names(), view_named);
    region = region_of(region_text_);
    if (bare && has_working)
        refuse_value("--bare", "only the grid, without --working", "--bare");
    if (is_json_) {
        if (!format_name_.empty())
            refuse_value("--json", "no --format beside it", format_name_);
        if (!tells_steps() || bare || asks_for_frames())
            refuse_value("--json", "--every or --step beside it, and no grid", "--json");
        format_name_ = "json";
    }
    format = value_of("--format", format_name_, table_format_names(), table_format_named);
    if (format) {
        if (!tells_steps())
            refuse_value("--format", "--every or --step beside it", format_name_);
        if (has_working && format != TableFormat::table)
            refuse_value("--working", "sentences, without --format " + format_name_, "--working");
        if (bare || asks_for_frames())
            refuse_value("--format", "a table, without --bare, --view and --region", format_name_);
    }
    color = color_choice_of(color_name_);
    scenes = drawing_.scene_options();
    scenes.tells_steps = true;
}

int ShowCommand::run() {
    InputFrames input(trace, scenes);
    check_sequence(*this, input);
    if (input.first() < input.last() && which == Which::summary)
        which = Which::last;
    ExitStatus status = exit_fine;
    FaceGroups faces;
    for (std::size_t frame = input.first(); frame <= input.last(); ++frame) {
        if (frame > input.first())
            print("\n");
        if (input.is_sequence() && !bare)
            print(printable(input.label(frame)) + "\n");
        status = show(input.trace(frame), *this, faces);
    }
    return status;
}

std::unique_ptr<Command> show_command() {
    return std::make_unique<ShowCommand>();
}

} // namespace rastertrace
