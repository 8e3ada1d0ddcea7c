// SPDX-License-Identifier: MIT
#pragma once

// What the player shows, and what its keys do: all but the terminal.
//
//     Player player(input, {});
//     player.press({"Right"});
//     player.playback().step();  // 1
//
// Searching a long trace and asking about a pixel are done in pieces, by work(), so that a key is heard at
// once.

#include "frames/frame_text.h"
#include "player/key_reader.h"

#include <rastertrace/figures/player_keys.h>
#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/explain/steps_of_pixel.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/tell/selector.h>
#include <rastertrace/trace/tell/view.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

/// A trace that is gone through in both directions.
///
///     Playback playback(std::move(trace));
///     playback.go_to(31);
///     playback.sentence_of(30);
class Playback {
public:
    /// Faces that have `lettered` keep their letters.
    explicit Playback(Trace trace, FaceGroups lettered = {});
    Playback(const Playback&) = delete;
    Playback& operator=(const Playback&) = delete;

    const Trace& trace() const { return trace_; }

    /// True if depth tests are remembered: there is a depth buffer.
    bool has_depths() const { return parts_.depths; }

    void go_to(std::size_t n) { replay_.go_to(n); }

    /// The picture after the current step.
    const Replay& replay() const { return replay_; }
    std::size_t step() const { return replay_.step(); }

    /// What a step near the current one says, see describe_step; valid until another step is asked for. Far from it this
    /// takes as long as going there.
    const std::string& sentence_of(std::size_t n) const;

    /// The faces that have letters.
    const FaceGroups& faces() const;

private:
    Trace trace_;
    FrameParts parts_;
    Replay replay_;
    mutable Replay around_;                                ///< that tells of the steps around
    mutable std::map<std::size_t, std::string> sentences_; ///< of some steps, by number

    FaceGroups lettered_;
    mutable std::optional<FaceGroups> faces_; ///< once someone has asked
};

/// Who drew a pixel, asked of a trace that may have millions of steps: piece by piece, so that keys are heard meanwhile.
///
///     PixelQuestion question(trace, {4, 2});
///     while (!question.answer()) question.look_on(100'000);
class PixelQuestion {
public:
    PixelQuestion(const Trace& trace, Pixel pixel)
        : trace_(&trace), pixel_(pixel), steps_(trace, pixel) {}

    Pixel pixel() const { return pixel_; }

    /// Looks at so many steps more; behind the last one the answer is known. False if it was.
    bool look_on(std::size_t steps) {
        if (answer_)
            return false;
        const std::size_t last = std::min(trace_->size(), looked_at_ + steps);
        while (looked_at_ < last)
            steps_.take(++looked_at_);
        if (looked_at_ < trace_->size())
            return true;
        Trace excerpt = std::move(steps_).finish();
        excerpt.damage = trace_->damage;
        excerpt.end = trace_->end;
        answer_ = explain(excerpt, {.about = Topic::pixel, .pixel = pixel_});
        return true;
    }

    /// What part of the trace has been looked at, from 0 to 1.
    double share() const {
        return trace_->size() == 0
                   ? 0
                   : static_cast<double>(looked_at_) / static_cast<double>(trace_->size());
    }

    /// The answer, or why there is none, once it is known.
    const std::optional<Result<Explanation>>& answer() const { return answer_; }

private:
    const Trace* trace_;
    Pixel pixel_;
    StepsOfPixel steps_;
    std::size_t looked_at_ = 0;
    std::optional<Result<Explanation>> answer_;
};

/// Where what can be clicked stands on the screen.
struct ScreenPlaces {
    FrameGrid grid = {}; ///< the pixels

    /// The list of steps: one a line, from a step on.
    struct List {
        std::size_t first_line = 0;
        std::size_t first_column = 0;
        std::size_t first_step = 0;
        std::size_t count = 0;
    };
    List list = {};
    std::size_t last_working =
        static_cast<std::size_t>(-1); ///< the farthest that the working is scrolled to
    std::size_t scale = 1;            ///< the lines of a cell
};

/// The lines of a cell, at most.
inline constexpr std::size_t largest_scale = 6;

/// The traces to be played: one, or that of each frame of a scene whose numbers vary.
struct PlayerInput {
    std::size_t first_frame = 1;
    std::size_t last_frame = 1;
    std::function<Trace(std::size_t frame)> open;
    std::function<std::string(std::size_t frame)> label = {}; ///< of a frame of several
};

struct PlayerOptions {
    std::optional<View> view = {}; ///< none: the trace's default
    std::string step = {};         ///< to begin with, see selector.h; empty: before the first
};

class Player {
public:
    /// Opens the first frame, and goes to the step to begin with. Throws a Problem.
    Player(PlayerInput input, const PlayerOptions& options);

    /// Does what a key says; a Click is about a place of the screen.
    void press(const KeyPress& key, const ScreenPlaces& places = {});

    /// Does a piece of what is to be done beside keys; false if there is nothing now.
    bool work();

    /// Goes on by what is due after some time, while it plays; false if nothing is.
    bool pass(double seconds);

    bool is_playing() const { return is_playing_; }
    bool wants_to_leave() const { return wants_to_leave_; }

    const Playback& playback() const { return *playback_; }
    View view() const { return view_; }
    bool is_overview() const { return is_overview_; }
    std::optional<std::size_t> scale() const { return scale_; }
    bool has_working() const { return has_working_; }
    std::size_t working_from() const {
        return working_from_;
    } ///< the first line of it that is shown
    std::optional<Pixel> cursor() const { return cursor_; }
    const PixelQuestion* question() const { return question_ ? &*question_ : nullptr; }
    double steps_per_second() const { return speed_; }
    /// What part of the trace has been searched, from 0 to 1; nothing if no search goes on.
    std::optional<double> searched() const;

    /// True if the cursor, and not the step, is what is looked at.
    bool looks_at_cursor() const { return looks_at_cursor_; }

    /// The page of the help that is shown, from 1; 0: none.
    std::size_t help_page() const { return help_page_; }

    /// What was typed behind `/` or `b` so far, with that; nothing if nothing is being typed.
    std::optional<std::string> prompt() const;

    /// What is to be said of the last key; "" for nothing.
    const std::string& message() const { return message_; }

    /// `frame 3 of 24: degrees 30`; "" if there is one frame.
    std::string frame_label() const;

private:
    /// Steps that are looked at before keys are asked for again: a few milliseconds.
    static constexpr std::size_t steps_at_once = 50'000;

    enum class Asked { nothing, search, breakpoint };
    enum class Direction { forward, back };

    /// A search for a step, done in pieces.
    struct Search {
        std::function<bool(std::size_t step)> is_meant;
        Direction direction = Direction::forward;
        std::size_t begin = 0;     ///< the step it started from
        std::size_t place = 0;     ///< the last step that was looked at
        std::size_t found = 0;     ///< the last one that is meant; 0: none so far
        std::size_t remaining = 1; ///< so many are passed
        std::string missing = {};  ///< what is said if there is none
        std::size_t at_once = steps_at_once;
    };

    /// What was searched for: a kind of step, or words of sentences.
    struct Wanted {
        std::string text;
        std::optional<Selector> selector;
    };

    void open(std::size_t frame);
    void open_or_tell(std::size_t frame);
    void act(PlayerAction action);
    bool act_in_help(const std::string& key);
    void type(const std::string& key);
    void finish_typing();
    bool take_digit(const std::string& key);
    std::size_t take_count() const;
    std::size_t take_times() const;
    void play_at(double steps_per_second);
    void move_to(std::size_t step);
    void move_by(std::size_t count, Direction direction);
    void find(Direction direction, std::function<bool(std::size_t)> is_meant, std::string missing,
              std::size_t at_once = steps_at_once);
    void find_kind(Direction direction);
    void find_row(Direction direction);
    void find_primitive(Direction direction);
    void find_of_primitive(Direction direction);
    void find_at_cursor(Direction direction);
    void find_match(Direction direction);
    void find_words(Direction direction, const std::string& words);
    bool search_on();
    void change_view(int by);
    void change_frame(Direction direction);
    void move_cursor(int columns, int rows);
    void set_cursor(std::optional<Pixel> pixel);
    void toggle_cursor();
    void click(const KeyPress& key, const ScreenPlaces& places);
    void show_step(std::size_t step);
    void scroll_working(int lines);
    void start_search(const std::string& text);
    void add_breakpoint(const std::string& text);
    bool is_at_breakpoint() const;
    std::optional<Selector> selector_of(const std::string& text);

    const Trace& trace() const { return playback_->trace(); }
    std::size_t step() const { return playback_->step(); }

    PlayerInput input_;
    PlayerOptions options_;
    std::size_t frame_ = 0;
    std::unique_ptr<Playback> playback_;

    View view_ = View::plotted;
    bool has_own_view_ = false; ///< somebody has chosen it
    bool is_overview_ = false;
    std::optional<std::size_t> scale_; ///< as somebody has chosen it
    std::size_t shown_scale_ = 1;      ///< on the last screen
    bool has_working_ = true;
    std::size_t working_from_ = 0;
    std::size_t help_page_ = 0;

    bool looks_at_cursor_ = false;
    std::optional<Pixel> cursor_;
    std::optional<PixelQuestion> question_;

    std::string count_; ///< digits typed so far
    Asked asked_ = Asked::nothing;
    std::string typed_;
    std::string message_;

    std::optional<Search> search_;
    std::optional<Wanted> searched_for_;
    std::vector<Selector> breakpoints_;

    bool is_playing_ = false;
    double speed_ = 4;
    double due_ = 0; ///< steps, of which less than one is due
    bool wants_to_leave_ = false;
};

} // namespace rastertrace
