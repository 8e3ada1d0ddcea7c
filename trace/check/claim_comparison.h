// SPDX-License-Identifier: MIT
#pragma once

// What somebody wrote down, held against what is told: 0.33 is 1/3, rounded to 2 digits.
//
//     compare(field, {"1/3"}, NumbersHeld::fractions, false).fit;  // Fit::rounded

#include "claims.h"

#include <rastertrace/trace/tell/formula.h>

#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// How a claimed number is the true one.
enum class Fit {
    exact,
    rounded,   ///< to the digits written
    truncated, ///< cut off behind the digits written, and not rounded to them
    none,
};

/// How a claimed value, or a list of them, is the one that is told.
struct Comparison {
    bool is_right = true;
    bool is_open = true; ///< nothing of it has been worked out
    int places = 0;      ///< of a decimal that was rounded or cut off
    Fit fit = Fit::exact;
};

/// What kind of numbers is told: where they are rounded, a fraction is right that rounds to them.
enum class NumbersHeld {
    fractions,
    doubles, ///< rounded on the way
    floats,
    many_digits, ///< of sines and roots: within `root_tolerance` of the true ones
};

/// How far a number with many digits of sines and roots may be from the true one.
Rational root_tolerance(const Rational& number);

/// True of a list that is judged place by place: a right beginning of it is right.
bool is_by_place(const ClaimedField& field);

/// Compares a field with what is told of it. A vertex may be given without a z of 0.
Comparison compare(const ClaimedField& claimed, const std::vector<std::string>& told,
                   NumbersHeld held, bool may_lack_z);

/// The numbers of a claim, 1 and 0 for true and false; what is open as it is told. Nothing if one is no number.
Values claimed_values(const ClaimedField& field, const std::vector<std::string>& told);

/// True of whole numbers each of which is one more than the one before it.
bool are_consecutive(const std::vector<std::string>& numbers);

/// Red, green and blue of a color; nothing of any other text.
Values levels_in(std::string_view text);

/// True if somebody who found these values would have written the claim.
bool gives(const Values& values, const ClaimedField& claimed);

} // namespace rastertrace
