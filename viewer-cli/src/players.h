// SPDX-License-Identifier: MIT
#pragma once

// What a terminal plays: a trace, or two side by side, both at the same step; playing stops where they differ for the first
// time.
//
//     Players players(std::move(mine), std::move(theirs));
//     players.press({"Space"});
//     players.pass(0.5);
//     players.first().message();  // "the first step that differs"

#include "load.h"
#include "player.h"
#include "player_screen.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace rastertrace {

class Players {
public:
    explicit Players(Player first, std::optional<Player> second = std::nullopt);

    /// A key is the first one's; the second one is at the same step, and shows it in the same way. A click may be on either
    /// picture.
    void press(KeyPress key, const ScreenPlaces& places = {});

    /// As Player's.
    bool work();
    bool pass(double seconds);
    void look_for_change();

    const Player& first() const { return first_; }

    /// Of what is still read from a pipe; -1 if nothing is.
    int pipe() const;

    /// What is wrong with the traces.
    ExitStatus report() const;

    PlayerScreen screen(TextSize size, const ScreenAbility& ability) const;

private:
    void follow();
    bool is_lost() const { return first_.lost() || (second_ && second_->lost()); }
    std::optional<std::size_t> difference(std::size_t last);

    Player first_;
    std::optional<Player> second_;
    std::size_t alike_ = 0; ///< steps from the first on that are known to be the same
};

} // namespace rastertrace
