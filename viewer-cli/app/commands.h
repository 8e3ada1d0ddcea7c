// SPDX-License-Identifier: MIT
#pragma once

// What each command is asked to do, and the function that does it. A command returns its exit
// status and throws a Problem when it cannot go on. `report` and `stress` have theirs in their own
// files: nobody else needs the library of what they measure.

#include "commands/figure_file.h"
#include "commands/step_table.h"
#include "player/terminal.h"
#include "player/terminal_text.h"

#include <rastertrace/figures/figure.h>
#include <rastertrace/figures/space_frames.h>
#include <rastertrace/figures/view.h>
#include <rastertrace/trace/audit/stats.h>
#include <rastertrace/trace/check/schema.h>
#include <rastertrace/trace/compare/diff.h>
#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/method_names.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Exit statuses of the program.
enum ExitStatus : int {
    exit_fine = 0,
    exit_difference = 1, ///< a difference, a wrong claim, a rule broken
    exit_bad_input = 2,  ///< bad usage or input
    exit_system = 3,     ///< the system failed: disk full, ...
};

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
int run(const TraceCommand& command);

struct PlanCommand {
    std::string scene;
    bool json = false;
    MethodOverrides method;
    InputLimits input;
    FrameChoice frames;
};
int run(const PlanCommand& command);

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

struct PlayCommand {
    std::string trace;
    std::string step; ///< to begin with, see selector.h; empty: before the first
    std::optional<View> view;
    std::optional<TextSize> screen; ///< only print that of a terminal of this size
    ColorChoice color = ColorChoice::automatic;
    MethodOverrides method;
    InputLimits input;
    FrameChoice frames;
};
int run(const PlayCommand& command);

struct FigureCommand {
    enum class Which {
        last,
        step,
        until,
        every,
        film, ///< see film_of
    };

    /// Frames in rows and columns on one sheet.
    struct Sheet {
        std::size_t columns;
        std::size_t rows;
    };

    std::string trace;
    std::string output;
    std::optional<FigureFormat> format; ///< none: by the name of the output
    Which which = Which::last;
    std::string selector; ///< for all but Which::last
    FigureOptions options;
    FigureStyle style;
    std::optional<Sheet> sheet;
    std::optional<SpaceFrames> frames_in_space; ///< in the place of all other pictures
    bool is_animated = false;                   ///< all frames in one .svg
    bool is_bare = false;                       ///< only the pixels
    std::string against;                        ///< METHOD, or a file: see FigureOptions
    MethodOverrides method;
    InputLimits input;
    FrameChoice frames;
};
int run(const FigureCommand& command);

struct StatsCommand {
    std::string trace;
    bool json = false;
    std::vector<StatsFinding> fail_on; ///< exit status 1 if there is any of these
    MethodOverrides method;
    InputLimits input;
    FrameChoice frames;
};
int run(const StatsCommand& command);

/// How much `check` gives away of what it has found.
enum class CheckTold {
    verdicts, ///< only what is right and what is wrong
    rule,     ///< where, and by which rule
    formula,  ///< and the formula in letters
    answers,  ///< and the right numbers, their working, and the likely slips
};

struct CheckCommand {
    std::vector<std::string>
        files; ///< a scene or a trace, then claims; or claims that name their scenes
    bool json = false;
    CheckTold told = CheckTold::answers;
    MethodOverrides method;
    InputLimits input;
    FrameChoice frames;
};
int run(const CheckCommand& command);

struct ExplainCommand {
    std::string trace;
    Question question;
    std::string against; ///< METHOD: the same question under another one; empty: none
    bool json = false;
    MethodOverrides method;
    InputLimits input;
    FrameChoice frames;
};
int run(const ExplainCommand& command);

struct DiffCommand {
    std::vector<std::string> files; ///< two scenes or traces; or one scene, and `against`
    std::string against;            ///< METHOD: the only scene, drawn by another one
    DiffOptions options;
    std::optional<Color> background{}; ///< of a picture: what is not drawn
    bool json = false;
    ColorChoice color = ColorChoice::automatic;
    bool is_quiet = false; ///< remarks on scenes are told nobody
    MethodOverrides method;
    InputLimits input;
    FrameChoice frames;
};
int run(const DiffCommand& command);

/// What the two files do differently, with the goldens that are accepted besides the first. Throws a Problem.
TraceDiff diff_of_files(const DiffCommand& command);

/// Compares the files of two folders that have one name. Throws a Problem if there are none.
ExitStatus diff_folders(const DiffCommand& command);

struct ValidateCommand {
    std::vector<std::string> files;
    std::optional<SchemaKind> kind;   ///< what all of them have to be; none: found by content
    std::optional<SchemaKind> schema; ///< print this one instead
    bool redo = false;                ///< do every step of a trace again
    bool json = false;
    InputLimits input;
};
int run(const ValidateCommand& command);

struct RenewCommand {
    std::vector<std::string> pages;
    bool check = false; ///< write nothing, tell what differs
};
int run(const RenewCommand& command);

} // namespace rastertrace
