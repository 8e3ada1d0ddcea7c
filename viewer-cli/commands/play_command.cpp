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

using Steady = std::chrono::steady_clock;

/// A screen is drawn so often while nothing is pressed.
constexpr std::chrono::milliseconds between_screens{50};

/// While it plays.
constexpr int between_steps = 15;

/// How long to wait for a key, in milliseconds; for ever if that is negative.
int time_to_wait(const Player& player, bool has_worked, bool is_shown) {
    if (has_worked)
        return 0;
    return player.is_playing() || !is_shown ? between_steps : -1;
}

/// What a terminal of some size would show at first.
void print_screen(Player& player, const TextSize& size, const ScreenAbility& ability) {
    while (player.work()) {
    }
    for (const std::string& line : player_screen(player, size, ability).lines)
        print(line.substr(0, line.find_last_not_of(' ') + 1) + "\n");
}

/// Keys, time and screens, until somebody leaves.
void play(Player& player, const ScreenAbility& ability) {
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

/// The list of keys is as wide as a page.
constexpr std::size_t key_columns = 79;

class PlayCommand final : public Command {
public:
    CommandAbout about() const override {
        return {"play", "Go through a trace step by step, forward and back, in the terminal",
                "rastertrace play examples/t0-fill/first-triangle.json --step \"scanline y=2\"\n\n"
                "rastertrace play --keys lists the keys, and ? does while it plays."};
    }

    void add_to(OptionList& options) override {
        AddedOption trace = options.option("trace", trace_, trace_input, "TRACE");
        options.flag("--keys", lists_keys_, "List the keys, and play nothing").excludes(trace);
        options.option("--step", step_, "Begin at this step; before the first if not given",
                       "STEP");
        add_view_to(options, view_name_);
        options.option("--color", color_name_, "Colors", "WHEN").values(color_choices);
        options.option("--print", screen_size_,
                       "Print the first screen of a terminal of that size, and play nothing",
                       "COLUMNSxLINES");
        options.language();
        drawing_.add_to(options, Holds::steps, "all if not given");
    }

    void read() override {
        if (lists_keys_)
            return;
        if (trace_.empty())
            refuse_value("TRACE", "a trace or a scene to play", "none");
        view_ = value_of("--view", view_name_, view_names(), view_named);
        color_ = color_choice_of(color_name_);
        if (!screen_size_.empty()) {
            const auto [columns, lines] = size_in_option(
                "--print", "columns and lines from 1 to 1000, as in 80x24", screen_size_, 1000);
            screen_ = TextSize{columns, lines};
        }
        scenes_ = drawing_.scene_options();
        scenes_.tells_steps = true;
    }

    int run() override {
        if (lists_keys_) {
            print(joined(player_help(key_columns), "\n") + "\n");
            return exit_fine;
        }
        if (!screen_ && !TerminalSession::is_possible())
            return show_instead();
        Player player(open_input(), {.view = view_, .step = step_});
        const ScreenAbility ability{.colors = output_colors(color_),
                                    .has_unicode = output_has_unicode()};
        if (screen_)
            print_screen(player, *screen_, ability);
        else
            play(player, ability);
        return report_damage(player.playback().trace());
    }

private:
    /// The frames of a scene, or a trace. It is read at once for the first frame, and again to be read again.
    PlayerInput open_input() const {
        Source source = value_or_throw(read_source_or_claims(trace_, scenes_.limits));
        std::string path = trace_;
        if (is_claims(source)) { // what they claim something of
            const Claims claims = value_or_throw(read_claims(std::move(source)));
            path = path_of_scene(claims);
            source = load_scene_of_claims(claims, scenes_.limits);
        }
        const auto frames = std::make_shared<InputFrames>(path, std::move(source), scenes_);
        if (frames->given_trace() == nullptr)
            return {.first_frame = frames->first(),
                    .last_frame = frames->last(),
                    .open = [frames](std::size_t frame) { return frames->trace(frame); },
                    .label = [frames](std::size_t frame) { return frames->label(frame); }};
        return {.open = [this, path, first = std::make_shared<bool>(true), frames](std::size_t) {
            if (std::exchange(*first, false))
                return frames->trace(1);
            if (path == "-")
                throw problem_of("standard input",
                                 "expected a file to be read again, found what can be read once");
            return load_trace(path, scenes_);
        }};
    }

    /// Where nothing can be taken over, the frame is printed.
    int show_instead() const {
        ShowCommand show;
        show.trace = trace_;
        show.which = step_.empty() ? ShowCommand::Which::last : ShowCommand::Which::step;
        show.selector = step_;
        show.view = view_;
        show.color = color_;
        show.scenes = scenes_;
        show.has_working = true;
        const int status = show.run();
        print_error("rastertrace: there is no terminal that can be played on: this is what `show` "
                    "prints\n");
        return status;
    }

    std::string trace_;
    bool lists_keys_ = false;
    std::string step_; ///< to begin with, see selector.h; empty: before the first
    std::string view_name_;
    std::optional<View> view_;
    std::string color_name_;
    ColorChoice color_ = ColorChoice::automatic;
    std::string screen_size_;
    std::optional<TextSize> screen_; ///< only print that of a terminal of this size
    DrawingOptions drawing_;
    SceneOptions scenes_;
};

} // namespace

std::unique_ptr<Command> play_command() {
    return std::make_unique<PlayCommand>();
}

} // namespace rastertrace
