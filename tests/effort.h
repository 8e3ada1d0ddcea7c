// SPDX-License-Identifier: MIT
#pragma once

// How much a test does.

namespace rastertrace {

/// How many of a test's random cases are looked at: as many percent as the build is set to (tests/CMakeLists.txt).
template <typename Count> constexpr Count random_cases(Count all) {
    return static_cast<Count>(all * Count{RASTERTRACE_RANDOM_CASES} / 100);
}

} // namespace rastertrace
