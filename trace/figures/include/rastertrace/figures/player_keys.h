// SPDX-License-Identifier: MIT
#pragma once

// The keys of the player, in the terminal (`rastertrace play`) and on a page (`figure -o FILE.html`): one table, from
// which both, their help, and docs/player.md come.
//
//     player_action_of("l");  // PlayerAction::next
//
// A key is called by the character that it types, or by a name: Right, Left, Up, Down, Home, End, Space, Enter,
// Escape, Shift+Right, Ctrl+l, F1.

#include <rastertrace/trace/text/language.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What a key does.
enum class PlayerAction : std::uint8_t {
    next,
    previous,
    next_row,
    previous_row,
    next_of_kind,
    previous_of_kind,
    next_of_primitive,
    previous_of_primitive,
    next_primitive,
    previous_primitive,
    next_at_cursor,
    previous_at_cursor,
    first,
    last,
    play,
    faster,
    slower,
    search,
    next_match,
    previous_match,
    breakpoint,
    no_breakpoints,
    cursor_left,
    cursor_down,
    cursor_up,
    cursor_right,
    cursor_to_step,
    next_view,
    previous_view,
    overview,
    larger_cells,
    smaller_cells,
    working,
    working_down,
    working_up,
    next_frame,
    previous_frame,
    read_again,
    redraw,
    help,
    quit,
};

/// A row of the table.
struct PlayerKey {
    PlayerAction action;
    std::string_view name;              ///< "next": what tests and pages call the action
    std::vector<std::string_view> keys; ///< the first is the one to learn
    Words does;                         ///< "the next step"
    bool is_on_pages;                   ///< a page has it, too
};

/// The table, in the order in which help tells it.
std::span<const PlayerKey> player_keys();

/// The row of an action.
const PlayerKey& key_of(PlayerAction action);

/// What a key does; nothing if it does nothing.
std::optional<PlayerAction> player_action_of(std::string_view key);

/// A key as people are told of it, in the language of steps: `Shift+Right`, `Shift+Direita`.
std::string told_key(std::string_view key);

} // namespace rastertrace
