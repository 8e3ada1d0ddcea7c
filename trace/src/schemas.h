// SPDX-License-Identifier: MIT
#pragma once

// The three schemas, each written in a file of its own from the tables of its reader.
//
//     scene_schema().dump(2);

#include "schema_parts.h"

namespace rastertrace {

Json scene_schema();  ///< from scene_keys.h, method_names.h, stage_name.h
Json trace_schema();  ///< from trace_keys.h, step_kind.h
Json claims_schema(); ///< from claims_keys.h, claim_fields.h

} // namespace rastertrace
