// SPDX-License-Identifier: MIT
#pragma once

// Primitives and their edges, as scenes, traces and people name them.

#include <rastertrace/core/raster/steps.h>

#include <span>
#include <string>
#include <string_view>

namespace rastertrace {

/// "triangle".
std::string_view name_of(PrimitiveKind kind);

/// What stands between names that are written as one: nothing if each is one letter, "-" otherwise.
std::string_view name_separator(std::span<const std::string_view> names);

/// Names written as one: "ABC", or "P1-P2-P3".
std::string joined_names(std::span<const std::string_view> names);

} // namespace rastertrace
