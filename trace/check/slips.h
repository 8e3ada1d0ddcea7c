// SPDX-License-Identifier: MIT
#pragma once

// The mistakes that people make when they work a formula out by hand, one table. Each is the formula
// done again with the mistake in it; a mistake is named only if that gives the number which was found.
//
//     for (const Slip& slip : slips())
//         slip.redo(formula);  // what it would have come to

#include <rastertrace/trace/tell/formula.h>
#include <rastertrace/trace/text/language.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What a formula comes to with a mistake in it.
struct SlipResult {
    Values values;
    std::string detail = {}; ///< what the mistake was made with: "to 2 digits"; may be empty
};

/// One mistake.
struct Slip {
    std::string_view name;    ///< "truncate-for-floor"
    Words done;               ///< "z in the place of y"
    Words instead_of;         ///< "y"
    std::string_view symptom; ///< what is seen of it in the picture or the numbers
    double in_thousand;       ///< a guess of how many wrong numbers come of it, where it can happen

    /// What the formula comes to with the mistake in it: one result for each way to make it, none of
    /// which is the right one. None if the formula has no place for it.
    std::vector<SlipResult> (*redo)(const Formula& formula);
};

/// "rounding toward 0 instead of rounding down", in the language of steps.
std::string meaning_of(const Slip& slip, std::string_view detail = {});

/// The same of a slip by its name, or of a known mistake of programs (mistakes.h); "" of any other name.
std::string meaning_of(std::string_view name);

/// All of them.
std::span<const Slip> slips();

/// The slip of that name, or nullptr.
const Slip* find_slip(std::string_view name);

} // namespace rastertrace
