// SPDX-License-Identifier: MIT
#pragma once

// Two steps of the same key, field by field; and two headers, key by key.

#include "step_lines.h"

#include <rastertrace/trace/diff.h>

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

/// The keys of two headers that are not alike; an object's as `canvas.width`, a stage's as `stages.clip`. Which steps
/// were left out (`only`, `region`, `primitive`) is none of them.
std::vector<FieldDifference> differing_keys(std::string_view header_a, std::string_view header_b);

/// Throws a Problem if an option names a kind or a field that no trace can have, or that neither of these two has.
void check_names(const DiffOptions& options, const TraceText& a, const TraceText& b);

} // namespace rastertrace
