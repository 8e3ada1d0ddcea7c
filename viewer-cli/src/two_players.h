// SPDX-License-Identifier: MIT
#pragma once

// Two traces side by side: both are at the same step, and playing stops where they differ for the first time.
//
//     TwoPlayers players(std::move(mine), std::move(theirs));
//     players.press({"Space"});
//     players.pass(0.5);
//     players.first().message();  // "the first step that differs"

#include "player.h"
#include "player_screen.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace rastertrace {

class TwoPlayers {
public:
    TwoPlayers(Player first, Player second)
        : first_(std::move(first)), second_(std::move(second)) {}

    /// What a key does to the first, and where that leads the second. A click may be on either picture.
    void press(KeyPress key, const ScreenPlaces& places = {});

    /// As Player's.
    bool work();
    bool pass(double seconds);
    void look_for_change();

    const Player& first() const { return first_; }
    const Player& second() const { return second_; }

    /// The first step that differs, or that only one of them has; nothing if there is none as far as they are read.
    std::optional<std::size_t> difference();

    PlayerScreen screen(TextSize size, const ScreenAbility& ability) const;

private:
    void follow();

    Player first_, second_;
    std::size_t alike_ = 0; ///< steps from the first on that are known to be the same
};

} // namespace rastertrace
