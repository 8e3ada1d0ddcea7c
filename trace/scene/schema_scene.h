// SPDX-License-Identifier: MIT
#pragma once

#include <rastertrace/trace/text/schema_parts.h>

namespace rastertrace {

/// The schema of a scene, made from the tables of its reader: scene_keys.h, method_names.h and stage_name.h.
Json scene_schema();

} // namespace rastertrace
