// SPDX-License-Identifier: MIT
// `rastertrace play`: a trace step by step, forward and back, in a terminal.

#include "app/command.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/shared_options.h"
#include "commands/show_command.h"
#include "player/player.h"
#include "player/player_screen.h"
#include "player/terminal_session.h"

#include <rastertrace/trace/tell/selector.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/process_files.h>

#include <fmt/core.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

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

using Steady = std::chrono::steady_clock;

/// A screen is drawn so often while nothing is pressed.
constexpr std::chrono::milliseconds between_screens{50};

/// While it plays.
constexpr int between_steps = 15;

SceneOptions scene_options(const PlayCommand& command) {
    return {.method = command.method,
            .limits = command.input,
            .frames = command.frames,
            .tells_steps = true};
}

/// The frames of a scene, or a trace. It is read at once for the first frame, and again to be read again.
PlayerInput open_input_of(const PlayCommand& command) {
    Source source = value_or_throw(read_source_or_claims(command.trace, command.input));
    std::string path = command.trace;
    if (is_claims(source)) { // what they claim something of
        const Claims claims = value_or_throw(read_claims(std::move(source)));
        path = path_of_scene(claims);
        source = load_scene_of_claims(claims, command.input);
    }
    const auto frames =
        std::make_shared<InputFrames>(path, std::move(source), scene_options(command));
    if (frames->given_trace() == nullptr)
        return {.first_frame = frames->first(),
                .last_frame = frames->last(),
                .open = [frames](std::size_t frame) { return frames->trace(frame); },
                .label = [frames](std::size_t frame) { return frames->label(frame); }};
    return {.open = [command, path, first = std::make_shared<bool>(true), frames](std::size_t) {
        if (std::exchange(*first, false))
            return frames->trace(1);
        if (path == "-")
            throw problem_of("standard input",
                             "expected a file to be read again, found what can be read once");
        return load_trace(path, scene_options(command));
    }};
}

/// Where nothing can be taken over, the frame is printed.
int show_instead(const PlayCommand& command) {
    ShowCommand show;
    show.trace = command.trace;
    show.which = command.step.empty() ? ShowCommand::Which::last : ShowCommand::Which::step;
    show.selector = command.step;
    show.view = command.view;
    show.color = command.color;
    show.method = command.method;
    show.input = command.input;
    show.frames = command.frames;
    show.has_working = true;
    const int status = run(show);
    print_error("rastertrace: there is no terminal that can be played on: this is what `show` "
                "prints\n");
    return status;
}

PlayerOptions player_options(const PlayCommand& command) {
    return {.view = command.view, .step = command.step};
}

ScreenAbility ability_of(const PlayCommand& command) {
    return {.colors = output_colors(command.color), .has_unicode = output_has_unicode()};
}

/// What a terminal of some size would show at first.
void print_screen(Player& player, const PlayCommand& command) {
    while (player.work()) {
    }
    for (const std::string& line :
         player_screen(player, *command.screen, ability_of(command)).lines)
        print(line.substr(0, line.find_last_not_of(' ') + 1) + "\n");
}

/// How long to wait for a key, in milliseconds; for ever if that is negative.
int time_to_wait(const Player& player, bool has_worked, bool is_shown) {
    if (has_worked)
        return 0;
    return player.is_playing() || !is_shown ? between_steps : -1;
}

/// Keys, time and screens, until somebody leaves.
void play(Player& player, const PlayCommand& command) {
    const ScreenAbility ability = ability_of(command);
    TerminalSession terminal;
    PlayerScreen screen;
    bool is_shown = false; // as things are now
    bool is_urgent = true; // somebody waits for it
    auto drawn = Steady::now();
    auto before = Steady::now();
    while (!player.wants_to_leave() && terminal.is_open()) {
        is_urgent = terminal.needs_redraw() || is_urgent;
        if (is_urgent || (!is_shown && Steady::now() - drawn >= between_screens)) {
            screen = player_screen(player, terminal.size(), ability);
            terminal.show(screen.lines);
            drawn = Steady::now();
            is_shown = true;
            is_urgent = false;
        }
        const bool has_worked = player.work();
        is_shown = is_shown && !has_worked;
        terminal.wait(time_to_wait(player, has_worked, is_shown));
        while (const auto key = terminal.key()) {
            player.press(*key, screen.places);
            is_urgent = true;
        }
        const auto now = Steady::now();
        if (player.pass(std::chrono::duration<double>(now - before).count()))
            is_shown = false;
        before = now;
    }
}

} // namespace

int run(const PlayCommand& command) {
    if (!command.screen && !TerminalSession::is_possible())
        return show_instead(command);
    Player player(open_input_of(command), player_options(command));
    if (command.screen)
        print_screen(player, command);
    else
        play(player, command);
    return report_damage(player.playback().trace());
}

namespace {

/// The list of keys is as wide as a page.
constexpr std::size_t key_columns = 79;

class PlayCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {"play", "Go through a trace step by step, forward and back, in the terminal",
                "rastertrace play examples/t0-fill/first-triangle.json --step \"scanline y=2\"\n\n"
                "rastertrace play --keys lists the keys, and ? does while it plays."};
    }

    void add_to(OptionList& options) override {
        AddedOption trace = options.option("trace", command_.trace, trace_input, "TRACE");
        options.flag("--keys", lists_keys_, "List the keys, and play nothing").excludes(trace);
        options.option("--step", command_.step, "Begin at this step; before the first if not given",
                       "STEP");
        add_view_to(options, view_);
        options.option("--color", color_, "Colors", "WHEN").values(color_choices);
        options.option("--print", screen_size_,
                       "Print the first screen of a terminal of that size, and play nothing",
                       "COLUMNSxLINES");
        options.language();
        drawing_.add_to(options, Holds::steps, "all if not given");
    }

    void read() override {
        if (lists_keys_)
            return;
        if (command_.trace.empty())
            refuse_value("TRACE", "a trace or a scene to play", "none");
        command_.view = value_of("--view", view_, view_names(), view_named);
        command_.color = color_choice_of(color_);
        if (!screen_size_.empty()) {
            const auto [columns, lines] = size_in_option(
                "--print", "columns and lines from 1 to 1000, as in 80x24", screen_size_, 1000);
            command_.screen = TextSize{columns, lines};
        }
        drawing_.read_into(command_);
    }

    int run() override {
        if (!lists_keys_)
            return rastertrace::run(command_);
        print(joined(player_help(key_columns), "\n") + "\n");
        return exit_fine;
    }

private:
    PlayCommand command_;
    bool lists_keys_ = false;
    std::string view_;
    std::string color_;
    std::string screen_size_;
    DrawingOptions drawing_;
};

} // namespace

std::unique_ptr<Command> play_command() {
    return std::make_unique<PlayCommandLine>();
}

} // namespace rastertrace
