// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace rastertrace {

/// Names the schema that an editor holds a file against. The program passes it over, and offers it in no message.
inline constexpr std::string_view schema_key = "$schema";

} // namespace rastertrace
