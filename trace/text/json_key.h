// SPDX-License-Identifier: MIT
#pragma once

// The keys that an object of a file may have, in tables. A reader takes from them which keys it allows, the
// writer of schemas (schema.h) what editors say about each.
//
//     json.allow_keys(value, rotate_keys);  // throws a Problem at a key that is none of them

#include <array>
#include <cstddef>
#include <string_view>

namespace rastertrace {

/// A key of a JSON object.
struct JsonKey {
    std::string_view name;
    std::string_view form;    ///< what its value is: one of the definitions of the schema
    std::string_view meaning; ///< one line for people
    bool is_required = false;
};

/// A word that may be the value of a key.
struct JsonWord {
    std::string_view name;
    std::string_view meaning; ///< one line for people
};

template <std::size_t count>
constexpr std::array<std::string_view, count> names_of(const std::array<JsonWord, count>& words) {
    std::array<std::string_view, count> names{};
    for (std::size_t i = 0; i < count; ++i)
        names[i] = words[i].name;
    return names;
}

/// Names the schema that an editor holds a file against. The program passes it over, and offers it in no message.
inline constexpr JsonKey schema_key{"$schema", "text", "The schema that this file is held against"};

} // namespace rastertrace
