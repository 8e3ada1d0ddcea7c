// SPDX-License-Identifier: MIT
#pragma once

// The keys and words of a claims file in JSON, beside the fields of its claims (claim_fields.h). The reader allows
// these and no others; docs/claims.schema.json has each.
//
//     json.allow_keys(root, claims_keys);

#include <rastertrace/trace/text/json_key.h>

#include <array>
#include <string_view>

namespace rastertrace {

inline constexpr auto claims_keys =
    std::to_array<std::string_view>({schema_key, "scene", "round", "claims"});

inline constexpr auto round_words = std::to_array<std::string_view>({"nearest", "truncate"});

/// Of a claim about the picture; all others are steps with fields left out.
inline constexpr auto picture_keys = std::to_array<std::string_view>({"picture"});

/// What a row of a picture consists of.
inline constexpr std::string_view picture_marks = ".#?";

} // namespace rastertrace
