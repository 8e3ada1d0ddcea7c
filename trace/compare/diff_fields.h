// SPDX-License-Identifier: MIT
#pragma once

// Two steps of the same key, field by field.
//
//     FieldComparison fields(options, false);
//     fields.differing(a, b);  // {{.name = "left", .a = ..., .b = ...}}

#include "diff.h"

#include <rastertrace/trace/record/step_lines.h>

#include <string_view>
#include <vector>

namespace rastertrace {

class FieldComparison {
public:
    /// `has_floats`: an ulp is one of a float.
    FieldComparison(const DiffOptions& options, bool has_floats)
        : options_(options), has_floats_(has_floats) {}

    /// The fields that are not alike, in the order of a's.
    std::vector<FieldDifference> differing(const StepLine& a, const StepLine& b) const;

private:
    bool is_ignored(std::string_view kind_and_field) const;

    const DiffOptions& options_;
    bool has_floats_;
};

} // namespace rastertrace
