// SPDX-License-Identifier: MIT
#pragma once

// What the readers of a line of claims share: putting words into the fields of a claim.

#include "claim_fields.h"
#include "claim_line.h"
#include "claims.h"

#include <rastertrace/trace/tell/verdict_words.h>

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What a word says of a field that is true or false, or nullptr.
const VerdictWord* find_verdict(const ClaimWord& word, std::string_view field);

/// Fills a claim with the words of a line. What is wrong is thrown as a Problem.
class ClaimBuilder {
public:
    ClaimBuilder(ClaimLine& line, Claim& claim) : line_(line), claim_(claim) {}

protected:
    /// The kind of step, and the name of the primitive that it belongs to.
    void begin(std::string_view step, const std::optional<ClaimWord>& primitive);

    void put(std::string_view field, const ClaimWord& word) { put_list(field, {word}); }
    void put_list(std::string_view name, const std::vector<ClaimWord>& words);
    void put_value(const VerdictWord& verdict, const ClaimWord& word);

    /// A word that says true or false of a field, or `?`.
    void read_verdict(std::string_view field, std::string_view expected);

    /// (3,2), which becomes x and y.
    void read_place();
    std::array<ClaimWord, 2> point();

    /// The field of a name; of two with that name, the list. Steps of this table have them all.
    ClaimField field_named(std::string_view name) const;

    ClaimLine& line_;
    Claim& claim_;
};

} // namespace rastertrace
