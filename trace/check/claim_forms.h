// SPDX-License-Identifier: MIT
#pragma once

// The forms that a line of a table of claims can have, and the claims that they stand for.
//
//     ClaimLine line(source, begin, end);  // (3,2): on
//     read_claim(line, claim);  // {"step": "pixel", "x": 3, "y": 2, "plotted": true}

#include "claim_line.h"
#include "claims.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Reads what a line claims, which are as many copies of a claim as there are pixels that it says the same of. What is
/// wrong is thrown as a Problem.
std::vector<Claim> read_claim(ClaimLine& line, Claim claim);

/// What lines about a kind of step look like, for a hint; of "", all lines.
std::string form_of(std::string_view step);

/// Reads what a cell of a table says of a field; of `pixels`, the first and the last of a row. What is wrong is thrown.
void read_cell(ClaimLine& cell, Claim& claim, std::string_view field);

/// Reads the pixel (3,2), which is drawn.
void read_pixel_cell(ClaimLine& cell, Claim& claim);

/// How many coordinates a vertex has in the space of that name; 0 if there is none.
std::size_t coordinates_in_space(std::string_view name);

/// The words that a line of the table can begin with, besides names.
std::vector<std::string_view> first_words();

} // namespace rastertrace
