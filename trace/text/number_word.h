// SPDX-License-Identifier: MIT
#pragma once

// Numbers as other programs write them.

#include <optional>
#include <string>
#include <string_view>

namespace rastertrace {

/// A decimal of C, `.5`, `1.` or `+2e3`, as JSON and parse_number write it: without `+`, with a digit on both sides of
/// the point. Nothing if it is not the form of a decimal.
std::optional<std::string> usual_form(std::string_view word);

} // namespace rastertrace
