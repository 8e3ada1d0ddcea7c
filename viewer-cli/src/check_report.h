// SPDX-License-Identifier: MIT
#pragma once

// What `check` has found about files of claims, in each of its formats.
//
//     const CheckedFile file{.name = "anna.txt", .claims = claims, .checked = check(truth, claims)};
//     check_text({file}, CheckTold::answers);  // "anna.txt:3: y=2: ... \n    left end: expected -1/4, found 0\n..."

#include "commands.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/text/problem.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What is marked as one.
struct Mark {
    std::vector<std::size_t> claims{}; ///< of Checked::claims; none: nothing was handed in
    ClaimVerdict verdict = ClaimVerdict::open;
    std::string asked = {}; ///< the line of the empty sheet, if there is one
};

/// A file of claims.
struct CheckedFile {
    std::string name; ///< as messages call it
    Claims claims = {};
    Checked checked = {};
    std::string exercise = {}; ///< its ID; empty: it is about no exercise
    std::vector<Mark> marks =
        {}; ///< one for each claim; of an exercise, for each line of its sheet
    std::optional<Problem> problem = {}; ///< why it could not be checked; then the rest is empty

    const Claim& claim_of(const CheckedClaim& checked_claim) const {
        return claims.claims[checked_claim.claim];
    }

    /// The name of a field in the words that the claims are written in: `first pixel` in a table, `from` in JSON.
    std::string_view in_words(std::string_view field) const {
        return claims.is_table ? words_for_field(field) : field;
    }

    /// "first pixel: expected -1, found 0", in the same words.
    std::string difference(const CheckedField& field, std::string_view expected,
                           std::string_view found) const;
};

/// right, wrong, follows, open
std::string_view name_of(ClaimVerdict verdict);

/// The same in the language of steps, as all that follows here.
std::string_view in_words(ClaimVerdict verdict);

/// In words, with less than the answers only `wrong` for what follows from a wrong number.
std::string_view verdict_of(const CheckedClaim& claim, CheckTold told);

/// Of 1: what goes on rightly from a wrong number loses nothing more.
int points_of(ClaimVerdict verdict);

/// True of the fields, and of the claims, that are not as claimed.
bool is_wrong(ClaimVerdict verdict);

/// "12 right, 3 wrong, 2 that follow, 4 open"
std::string counts_text(const Checked& checked);

/// What is left of a sheet when it is marked: a class of them takes little memory.
struct SheetMark {
    std::string name;
    std::string exercise = {}; ///< as in CheckedFile
    Checked counts = {};       ///< without claims
    std::optional<Problem> problem = {};
};

SheetMark mark_of(const CheckedFile& file);

/// "anna.txt: 12 right, 3 wrong; most likely truncate-for-floor\n"
std::string mark_in_words(const SheetMark& mark, CheckTold told);

/// "anna.txt:3: y=2: 0, 25/8"
std::string place_of(const CheckedFile& file, const CheckedClaim& claim);

/// The text of a claim, as much of it as is shown.
std::string shown_claim(const Claim& claim);

/// What there is to be said of a claim besides its verdict, as much as is to be told: lines, or "".
std::string about_claim(const CheckedFile& file, const CheckedClaim& claim, CheckTold told);

/// The wrong claims of one file with everything about them; of several files one line each. With less than the
/// answers: which claims are right. The same choice in all formats; the rule and the formula are told in text and JSON.
std::string check_text(const std::vector<CheckedFile>& files, CheckTold told);

/// One object, or an array of them for several files.
std::string check_json(const std::vector<CheckedFile>& files, CheckTold told);

/// JUnit's XML, as programs that run tests show it.
std::string check_junit(const std::vector<CheckedFile>& files, CheckTold told);

/// A line for each file: RFC 4180. With a column for exercises, if any has one.
std::string check_csv(const std::vector<SheetMark>& marks, CheckTold told);

/// A table for each file, and what is wrong behind it.
std::string check_markdown(const std::vector<CheckedFile>& files, CheckTold told);

/// results.json of Gradescope; `visibility` is one of its own: visible, after_due_date, after_published, hidden.
std::string check_gradescope(const std::vector<CheckedFile>& files, CheckTold told,
                             std::string_view visibility);

/// results.json of PrairieLearn.
std::string check_prairielearn(const std::vector<CheckedFile>& files, CheckTold told);

} // namespace rastertrace
