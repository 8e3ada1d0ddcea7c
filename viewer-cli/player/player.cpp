// SPDX-License-Identifier: MIT
#include "player/player.h"

#include "app/load.h"

#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/shown_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace rastertrace {

namespace {

constexpr double slowest = 0.25; ///< steps in a second
constexpr double fastest = 1024;

/// Sentences are kept of at most so many steps.
constexpr std::size_t most_sentences = 2000;

} // namespace

Playback::Playback(Trace trace, FaceGroups lettered)
    : trace_(std::move(trace)), parts_(parts_for(View::writes, trace_)), replay_(trace_, parts_),
      around_(replay_), lettered_(std::move(lettered)) {}

const FaceGroups& Playback::faces() const {
    if (!faces_) {
        Replay at_end(trace_);
        at_end.go_to(trace_.size());
        faces_ = lettered_faces(at_end, lettered_);
    }
    return *faces_;
}

const std::string& Playback::sentence_of(std::size_t n) const {
    if (sentences_.size() > most_sentences)
        sentences_.clear();
    const auto [place, is_new] = sentences_.try_emplace(n);
    if (is_new) {
        around_.go_to(n);
        place->second = describe_step(around_);
    }
    return place->second;
}

Player::Player(PlayerInput input, const PlayerOptions& options)
    : input_(std::move(input)), options_(options), view_(options.view.value_or(View::plotted)),
      has_own_view_(options.view.has_value()) {
    open(input_.first_frame);
    if (!options.step.empty()) {
        const Selector selector = value_or_throw(parse_selector({"--step", options.step}, trace()));
        move_to(value_or_throw(matching_step(selector, trace(), "say which")));
    }
}

/// Opens the trace of a frame. The step stays the same, if there is one, or the last.
void Player::open(std::size_t frame) {
    const bool was_last = playback_ && step() == trace().size();
    const std::size_t before = playback_ ? step() : 0;
    auto opened = std::make_unique<Playback>(input_.open(frame),
                                             playback_ ? playback_->faces() : FaceGroups());
    search_.reset();
    question_.reset();
    asked_ = Asked::nothing;
    playback_ = std::move(opened);
    frame_ = frame;
    if (!has_own_view_)
        view_ = default_view(trace());
    if (cursor_ && !trace().canvas.contains(cursor_->x, cursor_->y))
        cursor_.reset();
    set_cursor(cursor_);
    show_step(was_last && before > 0 ? trace().size() : std::min(before, trace().size()));
}

/// Where what was open cannot be opened again, it stays.
void Player::open_or_tell(std::size_t frame) {
    try {
        open(frame);
    } catch (const Problem& problem) {
        message_ = problem.message;
    }
}

std::string Player::frame_label() const {
    return input_.first_frame == input_.last_frame || !input_.label ? "" : input_.label(frame_);
}

std::optional<std::string> Player::prompt() const {
    switch (asked_) {
    case Asked::search:
        return "/" + typed_;
    case Asked::breakpoint:
        return said("break at: ") + typed_;
    case Asked::nothing:
        break;
    }
    return count_.empty() ? std::nullopt : std::optional(count_);
}

void Player::press(const KeyPress& key, const ScreenPlaces& places) {
    if (key.key.empty())
        return; // none that we know, or a button of the mouse let go
    message_.clear();
    working_from_ = std::min(working_from_, places.last_working);
    shown_scale_ = places.scale;
    if (key.key == "Click")
        return click(key, places);
    if (asked_ != Asked::nothing)
        return type(key.key);
    if (help_page_ > 0 && act_in_help(key.key))
        return;
    search_.reset(); // any key ends it
    if (take_digit(key.key))
        return;
    if (key.key == "Escape") {
        is_playing_ = false;
        help_page_ = 0;
        count_.clear();
        return;
    }
    if (key.key == "Backspace" && !count_.empty()) {
        count_.pop_back();
        return;
    }
    if (key.key == "Enter") {
        if (!count_.empty())
            move_to(take_count());
        count_.clear();
        return;
    }
    if (const auto action = player_action_of(key.key))
        act(*action);
    else
        message_ = said("{} does nothing; ? lists the keys", told_key(key.key));
    count_.clear();
}

/// Keys that turn the pages of the help, or close it; false of another one, which closes it too.
bool Player::act_in_help(const std::string& key) {
    for (const char* const forward : {"Space", "Down", "j", "Right", "l", "PageDown", "Enter"})
        if (key == forward) {
            ++help_page_;
            return true;
        }
    for (const char* const back : {"Up", "k", "Left", "h", "PageUp"})
        if (key == back) {
            help_page_ = std::max<std::size_t>(help_page_, 2) - 1;
            return true;
        }
    if (player_action_of(key) == PlayerAction::help)
        return false;
    help_page_ = 0;
    return player_action_of(key) == PlayerAction::quit;
}

bool Player::take_digit(const std::string& key) {
    constexpr std::size_t most_digits = 12;
    const bool is_digit = key.size() == 1 && '0' <= key[0] && key[0] <= '9';
    if (is_digit && count_.size() < most_digits)
        count_ += key;
    return is_digit;
}

/// The number that was typed before the key; 1 if none was.
std::size_t Player::take_count() const {
    std::size_t count = 1;
    std::from_chars(count_.data(), count_.data() + count_.size(), count);
    return count;
}

void Player::act(PlayerAction action) {
    using enum PlayerAction;
    using enum Direction;
    const auto times = [this] {
        constexpr std::size_t most = 100'000; // more than any canvas has
        return static_cast<int>(std::min(take_times(), most));
    };
    const bool has_count = !count_.empty();
    switch (action) {
    case next:
        return move_by(take_times(), forward);
    case previous:
        return move_by(take_times(), back);
    case next_row:
        return find_row(forward);
    case previous_row:
        return find_row(back);
    case next_of_kind:
        return find_kind(forward);
    case previous_of_kind:
        return find_kind(back);
    case next_of_primitive:
        return find_of_primitive(forward);
    case previous_of_primitive:
        return find_of_primitive(back);
    case next_primitive:
        return find_primitive(forward);
    case previous_primitive:
        return find_primitive(back);
    case next_at_cursor:
        return find_at_cursor(forward);
    case previous_at_cursor:
        return find_at_cursor(back);
    case first:
        return move_to(has_count ? take_count() : 0);
    case last:
        return move_to(has_count ? take_count() : trace().size());
    case play:
        is_playing_ = !is_playing_ && step() < trace().size();
        due_ = 0;
        return;
    case faster:
        return play_at(speed_ * 2);
    case slower:
        return play_at(speed_ / 2);
    case search:
        asked_ = Asked::search;
        typed_.clear();
        return;
    case breakpoint:
        asked_ = Asked::breakpoint;
        typed_.clear();
        return;
    case next_match:
        return find_match(forward);
    case previous_match:
        return find_match(back);
    case no_breakpoints:
        message_ =
            breakpoints_.empty() ? said("there are no breakpoints") : said("breakpoints removed");
        breakpoints_.clear();
        return;
    case cursor_left:
        return move_cursor(-times(), 0);
    case cursor_right:
        return move_cursor(times(), 0);
    case cursor_up:
        return move_cursor(0, -times());
    case cursor_down:
        return move_cursor(0, times());
    case cursor_to_step:
        return toggle_cursor();
    case next_view:
        return change_view(1);
    case previous_view:
        return change_view(-1);
    case overview:
        is_overview_ = !is_overview_;
        return;
    case larger_cells:
        scale_ = std::min(scale_.value_or(shown_scale_) + 1, largest_scale);
        return;
    case smaller_cells:
        scale_ = std::max<std::size_t>(scale_.value_or(shown_scale_), 1) - 1;
        return;
    case working:
        has_working_ = !has_working_;
        return;
    case working_down:
        return scroll_working(times());
    case working_up:
        return scroll_working(-times());
    case next_frame:
        return change_frame(forward);
    case previous_frame:
        return change_frame(back);
    case read_again:
        return open_or_tell(frame_);
    case redraw:
        return;
    case help:
        ++help_page_;
        return;
    case quit:
        wants_to_leave_ = true;
        return;
    }
}

/// The same of a key that does something so many times.
std::size_t Player::take_times() const {
    return std::max<std::size_t>(take_count(), 1);
}

void Player::play_at(double steps_per_second) {
    speed_ = std::clamp(steps_per_second, slowest, fastest);
    message_ = said("{:g} steps a second", speed_);
}

/// What is clicked: a pixel, or a step of the list. The wheel goes from step to step.
void Player::click(const KeyPress& key, const ScreenPlaces& places) {
    if (const auto pixel = places.grid.pixel_at(key.line, key.column, trace().canvas)) {
        set_cursor(pixel);
        looks_at_cursor_ = true;
        return;
    }
    const ScreenPlaces::List& list = places.list;
    const bool is_in_list = asked_ == Asked::nothing && key.column >= list.first_column &&
                            key.line >= list.first_line && key.line - list.first_line < list.count;
    if (is_in_list)
        move_to(list.first_step + (key.line - list.first_line));
}

/// How many lines it takes, only a screen knows, which shows its end at the least.
void Player::scroll_working(int lines) {
    constexpr std::size_t most = 1000;
    const auto from = static_cast<long long>(working_from_) + lines;
    working_from_ = std::min(static_cast<std::size_t>(std::max(from, 0LL)), most);
}

void Player::show_step(std::size_t step) {
    if (step != this->step())
        working_from_ = 0;
    playback_->go_to(step);
}

void Player::move_to(std::size_t step) {
    looks_at_cursor_ = false;
    const std::size_t last = trace().size();
    if (step > last)
        message_ = said("expected a step up to {}, found {}", last, step);
    show_step(std::min(step, last));
}

void Player::move_by(std::size_t count, Direction direction) {
    looks_at_cursor_ = false;
    const std::size_t last = trace().size();
    if (direction == Direction::forward && step() == last)
        message_ = said("this is the last step");
    if (direction == Direction::back && step() == 0)
        message_ = said("nothing is before the first step");
    show_step(direction == Direction::forward ? std::min(last - step(), count) + step()
                                              : step() - std::min(step(), count));
}

bool Player::work() {
    const bool has_searched = search_on();
    const bool has_asked = question_ && question_->look_on(steps_at_once);
    return has_searched || has_asked;
}

bool Player::pass(double seconds) {
    if (!is_playing_)
        return false;
    constexpr double longest = 0.5; // who was stopped meanwhile missed nothing
    due_ += std::min(seconds, longest) * speed_;
    looks_at_cursor_ = false;
    const bool is_due = due_ >= 1;
    for (; due_ >= 1 && is_playing_; due_ -= 1) {
        if (step() == trace().size()) {
            is_playing_ = false;
            due_ = 0;
            break;
        }
        show_step(step() + 1);
        if (is_at_breakpoint()) {
            is_playing_ = false;
            message_ = said("breakpoint");
        }
    }
    return is_due;
}

void Player::change_view(int by) {
    const auto count = static_cast<int>(view_names().size());
    auto view = static_cast<int>(view_);
    do
        view = (view + by + count) % count;
    while (static_cast<View>(view) == View::depth && !playback_->has_depths());
    view_ = static_cast<View>(view);
    has_own_view_ = true;
}

void Player::change_frame(Direction direction) {
    const bool is_forward = direction == Direction::forward;
    const std::size_t times = take_times();
    if (input_.first_frame == input_.last_frame)
        message_ = said("there is one frame: no number of the scene varies");
    else if (frame_ == (is_forward ? input_.last_frame : input_.first_frame))
        message_ = is_forward ? said("this is the last frame") : said("this is the first frame");
    else
        open_or_tell(is_forward ? frame_ + std::min(times, input_.last_frame - frame_)
                                : frame_ - std::min(times, frame_ - input_.first_frame));
}

void Player::set_cursor(std::optional<Pixel> pixel) {
    cursor_ = pixel;
    question_.reset();
    if (cursor_) {
        question_.emplace(trace(), *cursor_);
        question_->look_on(steps_at_once);
    }
}

void Player::toggle_cursor() {
    looks_at_cursor_ = false;
    const auto pixel = pixel_looked_at(playback_->replay(), step());
    const Canvas& canvas = trace().canvas;
    const Pixel middle{canvas.left() + canvas.width / 2, canvas.y_of(canvas.height / 2)};
    if (cursor_ && (!pixel || *pixel == *cursor_))
        set_cursor(std::nullopt);
    else
        set_cursor(pixel.value_or(middle));
}

void Player::move_cursor(int columns, int rows) {
    if (!cursor_)
        return toggle_cursor();
    looks_at_cursor_ = true;
    const Canvas& canvas = trace().canvas;
    const int row =
        std::clamp(static_cast<int>(canvas.row_of(cursor_->y)) + rows, 0, canvas.height - 1);
    const int x = std::clamp(cursor_->x + columns, canvas.left(), canvas.right());
    set_cursor(Pixel{x, canvas.y_of(row)});
}

} // namespace rastertrace
