// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace rastertrace {

/// The schema of claims, made from the tables of its reader: claims_keys.h and claim_fields.h.
std::string claims_schema();

} // namespace rastertrace
