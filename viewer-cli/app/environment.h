// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <string_view>

namespace rastertrace {

/// What a variable of the environment is set to; empty if it is not.
inline std::string_view environment_variable(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? std::string_view() : std::string_view(value);
}

} // namespace rastertrace
