// SPDX-License-Identifier: MIT
#include "two_players.h"

#include <algorithm>
#include <utility>

namespace rastertrace {

namespace {

/// Columns of each of two screens, with two between them.
std::size_t half_of(std::size_t columns) {
    return columns < 2 ? 0 : (columns - 2) / 2;
}

} // namespace

void TwoPlayers::press(KeyPress key, const ScreenPlaces& places) {
    if (key.key == "Click" && places.second_from > 0 && key.column >= places.second_from)
        key.column -= places.second_from;
    first_.press(key, places);
    second_.press(key, places);
    follow();
}

bool TwoPlayers::work() {
    const bool has_worked = first_.work();
    if (has_worked)
        follow();
    return second_.work() || has_worked;
}

void TwoPlayers::look_for_change() {
    first_.look_for_change();
    second_.look_for_change();
}

bool TwoPlayers::pass(double seconds) {
    const std::size_t before = first_.playback().step();
    if (!first_.pass(seconds))
        return false;
    if (const auto n = difference(); n && before < *n && *n <= first_.playback().step())
        first_.stop_at(*n, "the first step that differs");
    follow();
    return true;
}

std::optional<std::size_t> TwoPlayers::difference() {
    const Trace& one = first_.playback().trace();
    const Trace& other = second_.playback().trace();
    const std::size_t both = std::min(one.size(), other.size());
    while (alike_ < both && one.step(alike_ + 1).json() == other.step(alike_ + 1).json())
        ++alike_;
    const bool are_read =
        first_.playback().growing().is_whole() && second_.playback().growing().is_whole();
    const bool is_end = alike_ == both && (!are_read || one.size() == other.size());
    return is_end ? std::nullopt : std::optional(alike_ + 1);
}

/// The second one is where the first one is, or at its own end.
void TwoPlayers::follow() {
    second_.stop_at(std::min(first_.playback().step(), second_.playback().trace().size()), "");
}

PlayerScreen TwoPlayers::screen(TextSize size, const ScreenAbility& ability) const {
    const std::size_t half = half_of(size.columns);
    PlayerScreen screen = player_screen(first_, {half, size.lines}, ability);
    const PlayerScreen other = player_screen(second_, {half, size.lines}, ability);
    screen.lines.resize(std::max(screen.lines.size(), other.lines.size()));
    for (std::size_t i = 0; i < other.lines.size(); ++i)
        screen.lines[i] = beside(screen.lines[i], other.lines[i], half + 2);
    screen.places.second_from = half + 2;
    return screen;
}

} // namespace rastertrace
