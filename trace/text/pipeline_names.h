// SPDX-License-Identifier: MIT
#pragma once

// The names that scene files and traces have for projections and viewports.

#include <rastertrace/core/draw/scene/transforms.h>

#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

/// none, orthographic, pinhole, view-plane, frustum.
std::string_view name_of(ProjectionType type);
std::optional<ProjectionType> projection_named(std::string_view name);
std::vector<std::string_view> projection_names();

/// none, fit, pixels-per-unit.
std::string_view name_of(ViewportType type);

} // namespace rastertrace
