// SPDX-License-Identifier: MIT
#pragma once

// The conventions as text.

#include <string>

namespace rastertrace {

/// Whose rules a scene can be drawn by, side by side, and what is unusual about them.
std::string conventions_text();

} // namespace rastertrace
