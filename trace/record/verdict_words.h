// SPDX-License-Identifier: MIT
#pragma once

// What people say for the values of a boolean field: selectors and claims share the words.

#include <array>
#include <string_view>

namespace rastertrace {

struct VerdictWord {
    std::string_view word;
    std::string_view field;
    std::string_view value;
};

inline constexpr std::array<VerdictWord, 6> verdict_words{{{"pass", "pass", "true"},
                                                           {"fail", "pass", "false"},
                                                           {"culled", "culled", "true"},
                                                           {"drawn", "culled", "false"},
                                                           {"inside", "inside", "true"},
                                                           {"outside", "inside", "false"}}};

} // namespace rastertrace
