// SPDX-License-Identifier: MIT
#pragma once

// How much a test does.

namespace rastertrace {

/// How many of a test's random cases are looked at: a tenth under the sanitizers, which look for other
/// faults and take more than ten times as long.
template <typename Count> constexpr Count random_cases(Count all) {
#ifdef RASTERTRACE_SANITIZE
    return all / 10;
#else
    return all;
#endif
}

} // namespace rastertrace
