// SPDX-License-Identifier: MIT
#pragma once

// The equation of a line as people write it.
//
//     line_equation("8y = 5x + 11")->m;           // "5/8"
//     line_equation("y - 2 = 5/8 (x - 1)")->b;    // "11/8"

#include <optional>
#include <string>
#include <string_view>

namespace rastertrace {

/// y = m x + b; or x = m y + b, if that is how it was written.
struct LineEquation {
    bool is_of_y = false;
    std::string m; ///< as it was typed, if it stands so; `?` if it is open
    std::string b;
};

/// Nothing of a text that is no equation in x, y or both of the first degree.
std::optional<LineEquation> line_equation(std::string_view text);

} // namespace rastertrace
