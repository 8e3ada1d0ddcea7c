// SPDX-License-Identifier: MIT
#pragma once

// The player's screen as lines of text: the frame that `show --step` prints, and around it the steps before and after,
// the conventions in force, how far one has come, the pixel under the cursor.
//
//     const PlayerScreen screen = player_screen(player, {80, 24}, {});
//     terminal.show(screen.lines);

#include "frames/frame_text.h"
#include "frames/terminal_text.h"
#include "player/player.h"

#include <string>
#include <vector>

namespace rastertrace {

/// What a terminal can show.
struct ScreenAbility {
    ColorDepth colors = ColorDepth::none;
    bool has_unicode = false; ///< half blocks
};

struct PlayerScreen {
    std::vector<std::string> lines; ///< as many as the size has, at most, none longer
    ScreenPlaces places = {};       ///< of pixels and steps in them
};

/// What a size has room for; of a very small one only the step and its sentence.
PlayerScreen player_screen(const Player& player, TextSize size, const ScreenAbility& ability);

/// The keys as lines of so many columns: the player's help.
std::vector<std::string> player_help(std::size_t columns);

} // namespace rastertrace
