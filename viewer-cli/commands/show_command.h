// SPDX-License-Identifier: MIT
#pragma once

// What `rastertrace show` is asked. `play` asks the same where there is no terminal.

#include "app/command.h"
#include "app/load.h"
#include "app/shared_options.h"
#include "commands/step_table.h"
#include "frames/terminal_text.h"

#include <rastertrace/trace/record/trace_options.h>
#include <rastertrace/trace/tell/view.h>

#include <optional>
#include <string>

namespace rastertrace {

class ShowCommand final : public Command {
public:
    enum class Which {
        summary, ///< what the scene is about, and the last frame
        last,
        step,
        every,
        all
    };

    CommandAbout about() const override;
    void add_to(OptionList& options) override;
    void read() override;
    int run() override;

    std::string trace;
    Which which = Which::summary;
    std::string selector; ///< for Which::step and Which::every, see selector.h
    bool bare = false;
    std::optional<View> view;          ///< none: the trace's default; `plotted` if bare
    std::optional<Region> region;      ///< of the canvas
    bool has_working = false;          ///< how the numbers of each step come of one another
    std::optional<TableFormat> format; ///< of Which::every: a table of any kind
    ColorChoice color = ColorChoice::automatic;
    SceneOptions scenes;

    /// True if an option is about the grid of a frame.
    bool asks_for_frames() const { return view || region; }

private:
    bool tells_steps() const { return which == Which::every || which == Which::step; }

    std::string step_;
    std::string every_;
    bool all_ = false;
    std::string view_name_;
    std::string region_text_;
    std::string format_name_;
    bool is_json_ = false;
    std::string color_name_;
    DrawingOptions drawing_;
};

} // namespace rastertrace
