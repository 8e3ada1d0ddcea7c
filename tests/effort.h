// SPDX-License-Identifier: MIT
#pragma once

// How much a test does.

namespace rastertrace {

/// How many of a test's random cases are looked at: a tenth under the sanitizers and in a build of type Debug, which
/// look for other faults or count lines, and take more than ten times as long.
template <typename Count> constexpr Count random_cases(Count all) {
#ifdef RASTERTRACE_FEW_CASES
    return all / 10;
#else
    return all;
#endif
}

} // namespace rastertrace
