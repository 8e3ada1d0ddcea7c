// SPDX-License-Identifier: MIT
#pragma once

// What `check` has found about files of claims, as text and as JSON.
//
//     const CheckedFile file{.name = "anna.txt", .claims = claims, .checked = check(truth, claims)};
//     check_text({file}, CheckTold::answers);  // "anna.txt:3: y=2: ... \n    left end: expected -1/4, found 0\n..."

#include "app/json_text.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/text/problem.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// How much `check` gives away of what it has found.
enum class CheckTold {
    verdicts, ///< only what is right and what is wrong
    rule,     ///< where, and by which rule
    formula,  ///< and the formula in letters
    answers,  ///< and the right numbers, their working, and the likely slips
};

/// A file of claims.
struct CheckedFile {
    std::string name; ///< as messages call it
    Claims claims = {};
    Checked checked = {};      ///< of an exercise, the counts are of the lines of its empty sheet
    std::string exercise = {}; ///< its ID; empty: it is about no exercise
    std::optional<Problem> problem = {}; ///< why it could not be checked; then the rest is empty

    const Claim& claim_of(const CheckedClaim& checked_claim) const {
        return claims.claims[checked_claim.claim];
    }
};

/// right, wrong, follows, open
std::string_view name_of(ClaimVerdict verdict);

/// True of the fields, and of the claims, that are not as claimed.
bool is_wrong(ClaimVerdict verdict);

/// "12 right, 3 wrong, 2 that follow, 4 open"
std::string counts_text(const Checked& checked);

/// The wrong claims of one file with everything about them; of several files one line each, and the most frequent
/// slips. With less than the answers: which claims are right. The rule and the formula are told in text and JSON.
std::string check_text(const std::vector<CheckedFile>& files, CheckTold told);

/// One object, or an array of them for several files.
JsonText check_json(const std::vector<CheckedFile>& files, CheckTold told);

} // namespace rastertrace
