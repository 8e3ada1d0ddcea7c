// SPDX-License-Identifier: MIT
#pragma once

// The forms that a line of a table of claims can have, and the claims that they stand for.
//
//     ClaimLine line(source, begin, end);  // (3,2): on
//     read_claim(line, claim);             // {"step": "pixel", "x": 3, "y": 2, "plotted": true}

#include "claim_line.h"
#include "claims.h"

#include <string_view>
#include <vector>

namespace rastertrace {

/// Reads what a line claims. What is wrong is thrown as a Problem.
void read_claim(ClaimLine& line, Claim& claim);

/// The words that a line of the table can begin with, besides names.
std::vector<std::string_view> first_words();

} // namespace rastertrace
