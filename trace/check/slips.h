// SPDX-License-Identifier: MIT
#pragma once

// The mistakes that people make when they work a formula out by hand, one table. Each is the formula
// done again with the mistake in it; a mistake is named only if that gives the number which was found.
//
//     for (const Slip& slip : slips())
//         slip.redo(formula);  // what it would have come to

#include <rastertrace/trace/tell/formula.h>

#include <span>
#include <string_view>
#include <vector>

namespace rastertrace {

/// One mistake.
struct Slip {
    std::string_view name;    ///< "truncate-for-floor"
    std::string_view meaning; ///< "rounded toward 0 where the rule is floor"

    /// What the formula comes to with the mistake in it: one result for each way to make it, none of
    /// which is the right one. None if the formula has no place for it.
    std::vector<Values> (*redo)(const Formula& formula);
};

/// All of them. Of mistakes that explain as much, the earlier one is the likelier.
std::span<const Slip> slips();

/// The slip of that name, or nullptr.
const Slip* find_slip(std::string_view name);

} // namespace rastertrace
