// SPDX-License-Identifier: MIT
#pragma once

// What `rastertrace show` is asked. `play` asks the same where there is no terminal.

#include "commands/step_table.h"
#include "frames/terminal_text.h"

#include <rastertrace/trace/record/trace_options.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/tell/view.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/method_names.h>

#include <optional>
#include <string>

namespace rastertrace {

struct ShowCommand {
    enum class Which {
        summary, ///< what the scene is about, and the last frame
        last,
        step,
        every,
        all
    };

    std::string trace;
    Which which = Which::summary;
    std::string selector; ///< for Which::step and Which::every, see selector.h
    bool bare = false;
    std::optional<View> view;          ///< none: the trace's default; `plotted` if bare
    std::optional<Region> region;      ///< of the canvas
    bool has_working = false;          ///< how the numbers of each step come of one another
    std::optional<TableFormat> format; ///< of Which::every: a table of any kind
    ColorChoice color = ColorChoice::automatic;
    MethodOverrides method;
    InputLimits input;
    FrameChoice frames;

    /// True if an option is about the grid of a frame.
    bool asks_for_frames() const { return view || region; }
};
int run(ShowCommand command);

} // namespace rastertrace
