// SPDX-License-Identifier: MIT
#include "players.h"

#include <rastertrace/trace/tell/step_text.h>

#include <algorithm>
#include <utility>

namespace rastertrace {

namespace {

/// Columns of each of two screens, with two between them.
std::size_t half_of(std::size_t columns) {
    return columns < 2 ? 0 : (columns - 2) / 2;
}

} // namespace

Players::Players(Player first, std::optional<Player> second)
    : first_(std::move(first)), second_(std::move(second)) {
    follow();
}

void Players::press(KeyPress key, const ScreenPlaces& places) {
    if (key.key == "Click" && places.second_from > 0 && key.column >= places.second_from)
        key.column -= places.second_from;
    const auto action = first_.is_typing() ? std::nullopt : player_action_of(key.key);
    first_.press(key, places);
    if (!second_)
        return;
    if (action == PlayerAction::read_again || action == PlayerAction::next_frame ||
        action == PlayerAction::previous_frame) {
        std::size_t before = 0;
        do {
            before = second_->frame();
            second_->press(key);
        } while (second_->frame() != first_.frame() && second_->frame() != before);
        alike_ = 0;
    }
    if (!is_lost())
        second_->look_as(first_);
    follow();
}

bool Players::work() {
    const bool has_worked = first_.work();
    const bool has_second = second_ && second_->work();
    follow();
    return has_second || has_worked;
}

void Players::look_for_change() {
    first_.look_for_change();
    if (second_)
        second_->look_for_change();
}

bool Players::pass(double seconds) {
    if (second_) // neither may be looked at if one has gone
        look_for_change();
    if (is_lost())
        return false;
    const std::size_t before = first_.playback().step();
    if (!first_.pass(seconds))
        return false;
    const auto n = second_ ? difference(first_.playback().step()) : std::nullopt;
    if (n && before < *n)
        first_.stop_at(*n, said({"the first step that differs", "o primeiro passo que difere"}));
    follow();
    return true;
}

int Players::pipe() const {
    const int first = first_.playback().growing().pipe();
    return first >= 0 || !second_ ? first : second_->playback().growing().pipe();
}

ExitStatus Players::report() const {
    const ExitStatus first = report_damage(first_.playback().trace());
    return second_ ? std::max(first, report_damage(second_->playback().trace())) : first;
}

/// The first step up to the last one that is asked for that differs, or that only one of them has; nothing if there is none
/// as far as they are read.
std::optional<std::size_t> Players::difference(std::size_t last) {
    const Trace& one = first_.playback().trace();
    const Trace& other = second_->playback().trace();
    const std::size_t both = std::min({one.size(), other.size(), last});
    for (; alike_ < both; ++alike_) {
        const StepView mine = one.step(alike_ + 1), theirs = other.step(alike_ + 1);
        if (mine.json() != theirs.json())
            return alike_ + 1;
    }
    const bool are_read =
        first_.playback().growing().is_whole() && second_->playback().growing().is_whole();
    return are_read && both < last ? std::optional(both + 1) : std::nullopt;
}

/// The second one is where the first one is, or at its own end.
void Players::follow() {
    if (second_ && !is_lost())
        second_->stop_at(std::min(first_.playback().step(), second_->playback().trace().size()),
                         "");
}

PlayerScreen Players::screen(TextSize size, const ScreenAbility& ability) const {
    if (!second_)
        return player_screen(first_, size, ability);
    const std::size_t half = half_of(size.columns);
    PlayerScreen screen = player_screen(first_, {half, size.lines}, ability);
    const PlayerScreen other = player_screen(*second_, {half, size.lines}, ability, half + 2);
    screen.lines.resize(std::max(screen.lines.size(), other.lines.size()));
    for (std::size_t i = 0; i < other.lines.size(); ++i)
        screen.lines[i] = beside(screen.lines[i], other.lines[i], half + 2);
    screen.places.second_from = half + 2;
    return screen;
}

} // namespace rastertrace
