// SPDX-License-Identifier: MIT
#pragma once

// A number as somebody wrote it down, held against the true one: 0.33 is 1/3, rounded to 2 digits.
//
//     const auto claimed = claimed_number("0.33");
//     fit_of(*claimed, Rational(1, 3));  // Fit::rounded

#include <rastertrace/core/numbers/scalar.h>

#include <optional>
#include <string>
#include <string_view>

namespace rastertrace {

struct ClaimedNumber {
    Rational value;
    std::optional<int> places = {}; ///< digits behind the point, of a decimal
};

/// Nothing of a text that is no number.
std::optional<ClaimedNumber> claimed_number(std::string_view text);

/// How a claimed number is the true one.
enum class Fit {
    exact,
    rounded,   ///< to the digits written
    truncated, ///< cut off behind the digits written, and not rounded to them
    none,
};

Fit fit_of(const ClaimedNumber& claimed, const Rational& truth);

} // namespace rastertrace
