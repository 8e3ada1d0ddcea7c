// SPDX-License-Identifier: MIT
#pragma once

// What is wrong with the text of a number, said alike in scenes and claims. Models have a limit of their own.
//
//     expected_instead_of(NumberFault::zero_denominator);  // "a denominator other than 0"

#include <rastertrace/core/numbers/number.h>

#include <string>

namespace rastertrace {

/// What should stand there; "a number" for what is malformed.
std::string expected_instead_of(NumberFault fault);

} // namespace rastertrace
