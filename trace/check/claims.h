// SPDX-License-Identifier: MIT
#pragma once

// What somebody worked out by hand about a scene: a file of claims, as a table or as JSON.
// docs/check.md describes both.
//
//     y=2: -1/4, 25/8 -> -1..3        {"step":"scanline","y":2,"left":"-1/4","right":"25/8",
//                                      "from":-1,"to":3}
//
// A line of a table is read as the JSON that says the same, so there is one kind of claim: a step of
// the trace of which fields are left out.

#include "typed_number.h"

#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What a claim says of one field of a step.
struct ClaimedField {
    std::string name; ///< as in the trace, or one of those in check.h
    std::vector<std::string>
        values; ///< as text; of a list, or a list of lists, all of them in order
    bool is_list = false;
    std::size_t offset = 0; ///< of the value in the file
    bool goes_on = false;   ///< dots stand behind the last value of the list
};

/// What one line says.
struct Claim {
    std::size_t line = 0;                ///< in its file, from 1
    std::size_t offset = 0;              ///< of its first byte in the file
    std::string text;                    ///< as it stands there, in one line
    std::string step;                    ///< the kind: scanline, vertex, ...; "picture" for rows
    std::vector<ClaimedField> fields;    ///< in the order in which they were written
    std::vector<std::string> picture;    ///< of "picture": rows from the top, `.` for empty
    std::optional<Problem> problem = {}; ///< why it cannot be read; then the rest is empty
    bool is_printed =
        false; ///< a row of a table that `show` prints, which does not name the primitive

    /// The field of that name, or nullptr.
    const ClaimedField* find(std::string_view field) const;
};

/// A file of claims.
struct Claims {
    Source source;
    std::string scene = {}; ///< the file that they are about, as it is written there; may be empty
    std::size_t scene_offset = 0;   ///< where it is written
    bool is_table = false;          ///< not JSON
    bool only_rounds = false;       ///< "round": "nearest": decimals may not be cut off
    bool has_decimal_comma = false; ///< a table in which 0,25 is 1/4
    std::vector<Claim> claims = {};

    /// The name of a field in the words that they are written in: `first pixel` in a table, `from` in JSON.
    std::string_view in_words(std::string_view field) const;

    /// Why lines cannot be read; nothing if all can.
    std::optional<Problem> problem() const;
};

/// Reads claims in either layout, found by its content: one that begins with `{` is JSON. A line of a table that cannot
/// be read is a claim with a problem; if none can, that is the result. In JSON, claims about kinds and fields that no
/// step has are a problem of the file.
Result<Claims> read_claims(Source source);

/// What a field is called where somebody reads it who has written a table, and no names of fields: "first pixel" for
/// the `from` of a row.
std::string_view words_for_field(std::string_view field, Language language = language_of_steps());

/// A value of a field as such a table has it: "on" where `plotted` is true. In the language of steps.
std::string_view word_for_value(std::string_view field, std::string_view value);

/// True if a source holds claims rather than a scene or a trace: an object with the key "claims", or
/// text that is no JSON.
bool is_claims(const Source& source);

} // namespace rastertrace
