// SPDX-License-Identifier: MIT
#pragma once

// The names that scene files and traces have for projections and viewports.

#include <rastertrace/core/draw/scene/transforms.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// none, orthographic, pinhole, view-plane, frustum.
std::string_view name_of(ProjectionType type);

/// The same, for a trace: `clip-space, z from 0` is one of its own.
std::string name_of(const Projection& projection);
std::optional<ProjectionType> projection_named(std::string_view name);
std::vector<std::string_view> projection_names();

/// centers, edges, edges-half.
std::span<const std::string_view> pixel_range_names();

/// What a trace calls a viewport: none, pixels-per-unit, fit (the centers of the first and the last pixel, y up), edges;
/// `edges, y down`.
std::string name_of(const Viewport& viewport);

} // namespace rastertrace
