// SPDX-License-Identifier: MIT
#pragma once

// How likely a slip is behind a wrong number, and not chance: a digit misread, a factor of ten, any other number. A
// slip that can be made in many ways gives many numbers, so that one of them is easily met; a long fraction is not.
//
//     evidence_for(results, field, right) + prior_of(name) > prior_of_chance()   // the slip is named
//
// Natural logarithms of probabilities (Bayes). The shares are guesses: what is named hardly depends on them.

#include "claims.h"
#include "slips.h"

#include <rastertrace/trace/tell/formula.h>

#include <cstddef>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Of one wrong number: how much likelier it is with a slip that has these results than by chance.
double evidence_for(const std::vector<SlipResult>& results, const ClaimedField& field,
                    const Values& right);

/// How often a slip was made, and how often not where it could have been.
struct HowOften {
    std::size_t made = 0;
    std::size_t not_made = 0;
};

/// How likely that is of somebody who makes the slip nearly always, or now and then.
double habit_of(const HowOften& often);

/// The share of wrong numbers that come of a slip, and of those that come of nothing.
double prior_of(std::string_view slip); ///< or a mistake of programs alone
double prior_of_mistake();              ///< of programs, where no formula is done again with it
double prior_of_chance();

} // namespace rastertrace
