// SPDX-License-Identifier: MIT
#pragma once

// The sentences that steps are told in (describe.h), read as claims: what `show` prints can be handed in, whole or in
// part, with other numbers in it.
//
//     scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor -> -1   right AC: ...
//     {"step": "scanline", "y": 2, "left": "-1/4", "from": -1, ...}

#include "claim_line.h"
#include "claims.h"

#include <string>

namespace rastertrace {

/// What a line is, of an answer.
enum class SentenceKind {
    none,   ///< no sentence
    claim,  ///< what it says has been put into the claim
    silent, ///< a sentence of which nothing is held against the scene
};

/// Reads a sentence; of any other line, nothing is taken. `primitive` is the name of the one whose steps are told, "" for
/// none; the sentence of a primitive sets it.
SentenceKind read_sentence(ClaimLine& line, Claim& claim, std::string& primitive);

} // namespace rastertrace
