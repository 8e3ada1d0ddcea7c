// SPDX-License-Identifier: MIT
#pragma once

// Claims as people write them, one line each.
//
//     y=2: -1/4, 25/8 -> -1..3
//     (3,2): on
//     A screen: 2, 5

#include "claims.h"

#include <string>
#include <string_view>

namespace rastertrace {

/// Reads `claims.source` as a table into `claims`.
void read_claims_table(Claims& claims);

/// A name as a word of the table: in quotes where it could be taken for something else.
std::string name_in_table(std::string_view name);

/// `text` with one blank in place of each line break and what stands beside it.
std::string in_one_line(std::string_view text);

} // namespace rastertrace
