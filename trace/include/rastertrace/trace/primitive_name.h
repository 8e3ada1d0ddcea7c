// SPDX-License-Identifier: MIT
#pragma once

// The kinds of primitive, as scenes, traces and people name them.

#include <rastertrace/core/raster/steps.h>

#include <string_view>

namespace rastertrace {

/// point, line, outline, triangle.
std::string_view name_of(PrimitiveKind kind);

} // namespace rastertrace
