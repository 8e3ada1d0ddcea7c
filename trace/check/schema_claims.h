// SPDX-License-Identifier: MIT
#pragma once

#include <rastertrace/trace/text/schema_parts.h>

namespace rastertrace {

/// The schema of claims, made from the tables of its reader: claims_keys.h and claim_fields.h.
Json claims_schema();

} // namespace rastertrace
