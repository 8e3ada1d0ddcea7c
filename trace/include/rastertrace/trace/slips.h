// SPDX-License-Identifier: MIT
#pragma once

// The mistakes that people make when they work a formula out by hand, one table. Each is the formula
// done again with the mistake in it; a mistake is named only if that gives the number which was found.
//
//     for (const Slip& slip : slips()) ... slip.name;  // "dx-dy-inverted"

#include <span>
#include <string_view>

namespace rastertrace {

/// One mistake.
struct Slip {
    std::string_view name;    ///< "truncate-for-floor"
    std::string_view meaning; ///< "rounded toward 0 where the rule is down"
};

/// All of them, in the order of the table.
std::span<const Slip> slips();

/// The slip of that name, or nullptr.
const Slip* find_slip(std::string_view name);

} // namespace rastertrace
