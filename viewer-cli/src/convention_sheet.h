// SPDX-License-Identifier: MIT
#pragma once

// One scene drawn by every convention, and where the pictures differ, as one sheet of text.

#include "load.h"

#include <string>

namespace rastertrace {

/// The sheet of a scene. Conventions that draw the same picture share a frame. Throws a Problem if
/// the scene cannot be drawn by one of them.
std::string convention_sheet(const std::string& path, const SceneOptions& options);

} // namespace rastertrace
