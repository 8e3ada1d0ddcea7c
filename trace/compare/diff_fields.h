// SPDX-License-Identifier: MIT
#pragma once

// Two steps of the same key, field by field.
//
//     FieldComparison fields(options, 0);
//     fields.differing(a, b);  // {{.name = "left", .a = ..., .b = ...}}

#include "diff.h"
#include "steps_ahead.h"

#include <string_view>
#include <vector>

namespace rastertrace {

class FieldComparison {
public:
    /// `floats`: how many of the two traces have numbers of floats.
    FieldComparison(const DiffOptions& options, int floats) : options_(options), floats_(floats) {}

    /// The fields that are not alike, in the order of a's.
    std::vector<FieldDifference> differing(const KeyedStep& a, const KeyedStep& b) const;

private:
    const DiffOptions& options_;
    int floats_;
};

} // namespace rastertrace
