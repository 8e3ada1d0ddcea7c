// SPDX-License-Identifier: MIT
#pragma once

// Comma-separated values: RFC 4180.

#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// A field, in quotes if it has to be. A spreadsheet would take a name like "=1+1" for a formula and run it; behind an
/// apostrophe it is text.
std::string csv_field(std::string_view text);

/// Adds a line of fields.
void put_csv_line(std::string& text, const std::vector<std::string>& fields);

} // namespace rastertrace
