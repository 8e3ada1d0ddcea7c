// SPDX-License-Identifier: MIT
#pragma once

// The answers of `rastertrace explain`, as text and as JSON.

#include "app/json_text.h"

#include <rastertrace/trace/explain/explain.h>

#include <optional>
#include <string>

namespace rastertrace {

/// The same question, answered for a scene that is drawn by another method.
struct OtherAnswer {
    std::string method; ///< as it was asked for: `rounding=truncate`
    Explanation explanation;
    std::optional<Difference> difference; ///< the first decision; `nullopt`: there is none
};

/// The answer in one line, the steps as a table with the working of each, then what kept others out.
std::string explanation_text(const Explanation& explanation);

/// The other answer below it, and the first decision that differs.
std::string other_answer_text(const OtherAnswer& other);

/// Both as one JSON object; docs/explain.md describes it.
JsonText explanation_json(const Explanation& explanation, const std::optional<OtherAnswer>& other);

} // namespace rastertrace
