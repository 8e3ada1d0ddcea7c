// SPDX-License-Identifier: MIT
#pragma once

// The conventions as text: what each sets, and one scene drawn by all of them.

#include "load.h"

#include <string>

namespace rastertrace {

/// Whose rules a scene can be drawn by, side by side, and what is unusual about them.
std::string conventions_text();

/// A scene drawn by every convention, and where the pictures differ. Conventions that draw the same picture share a frame. Throws a Problem if
/// the scene cannot be drawn by one of them.
std::string convention_sheet(const std::string& path, const SceneOptions& options);

} // namespace rastertrace
