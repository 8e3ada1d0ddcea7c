// SPDX-License-Identifier: MIT
#pragma once

// What people say for the values of a boolean field: selectors and claims share the words.

#include <rastertrace/trace/text/language.h>

#include <array>
#include <string_view>

namespace rastertrace {

struct VerdictWord {
    std::string_view word;
    std::string_view field;
    std::string_view value;
    Words told = word; ///< how an answer says it; most are only read
};

inline constexpr std::array<VerdictWord, 6> verdict_words{
    {{"pass", "pass", "true"},
     {"fail", "pass", "false"},
     {"culled", "culled", "true", "culled"},
     {"drawn", "culled", "false", "drawn"},
     {"inside", "inside", "true", "inside"},
     {"outside", "inside", "false", "outside"}}};

} // namespace rastertrace
