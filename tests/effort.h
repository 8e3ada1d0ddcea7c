// SPDX-License-Identifier: MIT
#pragma once

// How much a test does.

namespace rastertrace {

/// How many of a test's random cases are looked at: as many percent as the build is set to (tests/CMakeLists.txt).
template <typename Count> constexpr Count random_cases(Count all) {
    return static_cast<Count>(all * Count{RASTERTRACE_RANDOM_CASES} / 100);
}

/// How many are looked at of cases that were chosen, or that a bound on their number or share is meant for: all; a tenth
/// under the sanitizers and in a build of type Debug, which look for other faults or count lines, and take more than ten
/// times as long.
template <typename Count> constexpr Count all_cases(Count all) {
#ifdef RASTERTRACE_FEW_CASES
    return all / 10;
#else
    return all;
#endif
}

/// False where they are a tenth: shares of so few are not bounded.
inline constexpr bool are_all_cases = all_cases(10) == 10;

/// The address sanitizer needs time and memory of its own: neither is bounded then.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool is_sanitized = true;
#elif defined(__has_feature)
inline constexpr bool is_sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool is_sanitized = false;
#endif

} // namespace rastertrace
