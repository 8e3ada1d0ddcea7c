// SPDX-License-Identifier: MIT
#pragma once

// What a claim can say of each kind of step: the fields that the step has in a trace, and those that
// follow from the trace (check.h). Both layouts of a claims file ask here.

#include <rastertrace/trace/record/step_kind.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// A field of a claim.
struct ClaimField {
    std::string_view name;
    FieldType type; ///< of its value, or of each of its values
    bool is_list = false;
    bool is_key = false; ///< it says which step is meant, and is not compared
};

/// All fields of claims about steps of a kind.
std::vector<ClaimField> claim_fields_of(StepKind kind);

/// The kinds of which there is something to claim.
std::vector<std::string_view> claim_kinds();

/// What a value of a field should be, if `text` is not one: "a whole number". A key cannot be left open.
std::optional<std::string> expected_instead(const ClaimField& field, std::string_view text);

/// What is wrong with the last row of a picture: its marks, or its length.
std::optional<std::string> fault_in_last_row(const std::vector<std::string>& rows);

} // namespace rastertrace
