// SPDX-License-Identifier: MIT
#pragma once

// Comma-separated values: RFC 4180.

#include <string>
#include <vector>

namespace rastertrace {

/// Adds a line of fields, in quotes where they have to be. A spreadsheet would take a name like "=1+1" for a formula and
/// run it; behind an apostrophe it is text.
void put_csv_line(std::string& text, const std::vector<std::string>& fields);

} // namespace rastertrace
