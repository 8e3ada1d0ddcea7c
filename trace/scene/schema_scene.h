// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rastertrace {

/// The schema of a scene, made from the tables of its reader: scene_keys.h, method_names.h and stage_name.h.
std::string scene_schema();

} // namespace rastertrace
