// SPDX-License-Identifier: MIT
#pragma once

// The keys and words of a claims file in JSON, beside the fields of its claims (claim_fields.h). The reader allows
// these and no others, and the schema of claims is written from them.
//
//     json.allow_keys(root, claims_keys);

#include <rastertrace/trace/text/json_key.h>

#include <array>
#include <string_view>

namespace rastertrace {

inline constexpr std::array claims_keys{
    schema_key,
    JsonKey{"scene", "text", "The scene that the claims are about, from the folder of this file"},
    JsonKey{"round", "round",
            "With \"truncate\", decimals that are cut off count as right, not only rounded ones"},
    JsonKey{"claims", "claims", "What was worked out, in any order", true},
};

inline constexpr std::array round_words{
    JsonWord{"nearest", "decimals have to be rounded"},
    JsonWord{"truncate", "decimals may be rounded or cut off"},
};

/// Of a claim about the picture; all others are steps with fields left out.
inline constexpr std::array picture_keys{
    JsonKey{"picture", "picture",
            "Rows of the picture, top row first: # plotted, . empty, ? left open", true},
};

/// What a row of a picture consists of.
inline constexpr std::string_view picture_marks = ".#?";

} // namespace rastertrace
