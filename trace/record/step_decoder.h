// SPDX-License-Identifier: MIT
#pragma once

// Decodes steps that are written as this program writes them (step_json.h): of a known kind, the fields in the order of their table,
// without blanks, escapes or characters beyond ASCII. That is nearly every step; any other text is left to a reader of
// JSON, which finds the same values (field_type.h).
//
//     AnyStep step;
//     while (take_step(text, step) && take_line_end(text))
//         std::visit(use, step);

#include "trace.h"
#include "traced_steps.h"

#include <cstddef>
#include <string_view>

namespace rastertrace {

/// Takes the step that a text begins with. False if it begins with none that is written so; then the text stays as it
/// is. A step that was taken is valid: it has each field that its kind must have, each value is of the field's type, and
/// each number is finite. The step is a view of the text.
bool take_step(std::string_view& text, AnyStep& step);

/// The step of a kind that is known in a text, whatever that looks like.
AnyStep step_in_text(std::string_view json, StepKind kind);

/// So many digits stand at the beginning of a text; `count_digits` looks at eight at once.
std::size_t count_digits(std::string_view text);
std::size_t count_digits_one_by_one(std::string_view text);

} // namespace rastertrace
