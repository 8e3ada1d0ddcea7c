// SPDX-License-Identifier: MIT
#pragma once

#include <rastertrace/numerics/stress.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace rastertrace {

/// A case that was run, and what came of it with each scalar and method.
struct RunCase {
    const StressCase* about;
    std::vector<StressRow> rows;

    /// How many rows have this verdict.
    std::size_t count(Verdict verdict) const {
        return static_cast<std::size_t>(
            std::count_if(rows.begin(), rows.end(),
                          [verdict](const StressRow& row) { return verdict_of(row) == verdict; }));
    }
    /// How many rows are not as documented.
    std::size_t failed() const {
        return static_cast<std::size_t>(std::count_if(
            rows.begin(), rows.end(), [](const StressRow& row) { return !is_as_documented(row); }));
    }
};

} // namespace rastertrace
