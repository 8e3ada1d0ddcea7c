// SPDX-License-Identifier: MIT
#pragma once

// Which rule accounts for the pictures that a renderer has drawn of some scenes.
//
//     const Diagnosis found = diagnose({{scene, cells_of(picture, scene)}}, {});
//     name_of(found.answer.front().rule);  // "height-plus-one"

#include "evidence.h"
#include "rule.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rastertrace {

struct DiagnoseOptions {
    bool any_convention = false; ///< nobody knows which one was meant
    std::size_t jobs = 1;        ///< threads; the answer does not depend on them
};

/// A rule of an answer, and the known mistakes that always draw the same as far as random scenes tell.
struct AnsweredRule {
    Rule rule{};
    std::vector<const Mistake*> same{};
};

struct Diagnosis {
    std::uint64_t drawn =
        0; ///< pixels that are drawn, in the pictures or as the scenes ask, and claims
    std::uint64_t differing =
        0; ///< pixels that the scenes' own rules draw otherwise, and claims that are wrong by them
    std::vector<AnsweredRule>
        answer{}; ///< the best one, and those that draw the same here; none: nothing known
    std::uint64_t unexplained =
        0; ///< of these and others, those that the best rule does not give; of nothing known, the least bad one
    std::uint64_t between = 0; ///< pixels of anti-aliased pictures, see SeenCells

    std::optional<Rule>
        runner_up{}; ///< the next best that draws something else; of nothing known, the closest
    std::uint64_t runner_up_unexplained = 0;
    std::size_t pair = 0; ///< of the scenes: that with the pixel which tells both apart
    std::optional<Pixel>
        pixel; ///< on the canvas of that scene: as the best rule draws it, and not as is asked; none of claims

    std::vector<int>
        rows{}; ///< of that scene: y of those that the runner-up draws otherwise than they are

    bool is_as_asked() const { return differing == 0; }

    /// How much of what differs is explained, 0 to 1. A pixel whose color lay between two that are known counts half.
    double score() const {
        const auto all = static_cast<double>(differing + between);
        const double open = static_cast<double>(unexplained) + static_cast<double>(between) / 2;
        return all == 0 ? 1 : 1 - open / all;
    }
};

/// Finds the rule that accounts for the most. A setting is preferred to a mistake that explains no more, and one rule to
/// two of them; what draws the same by more changes is not told. Nothing is answered if more than a third of what differs, or more than a twentieth of what is drawn,
/// stays unexplained. Throws a Problem if a scene cannot be drawn.
Diagnosis diagnose(std::span<const DrawnPair> pairs, const DiagnoseOptions& options);

} // namespace rastertrace
