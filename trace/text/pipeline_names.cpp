// SPDX-License-Identifier: MIT
#include "pipeline_names.h"

#include <array>
#include <cstddef>

namespace rastertrace {

namespace {

constexpr auto projections = std::to_array<std::string_view>(
    {"none", "orthographic", "pinhole", "view-plane", "frustum", "clip-space"});
constexpr auto pixel_ranges = std::to_array<std::string_view>({"centers", "edges", "edges-half"});

} // namespace

std::string_view name_of(ProjectionType type) {
    return projections[static_cast<std::size_t>(type)];
}

std::string name_of(const Projection& projection) {
    return std::string(name_of(projection.type)) + (projection.z_from_zero ? ", z from 0" : "");
}

std::optional<ProjectionType> projection_named(std::string_view name) {
    for (std::size_t i = 0; i < projections.size(); ++i)
        if (projections[i] == name)
            return static_cast<ProjectionType>(i);
    return std::nullopt;
}

std::vector<std::string_view> projection_names() {
    return {projections.begin(), projections.end()};
}

std::span<const std::string_view> pixel_range_names() {
    return pixel_ranges;
}

std::string name_of(const Viewport& viewport) {
    switch (viewport.type) {
    case ViewportType::pixels:
        if (viewport.pixels == PixelRange::centers && !viewport.is_y_down)
            return "fit";
        return std::string(pixel_ranges[static_cast<std::size_t>(viewport.pixels)]) +
               (viewport.is_y_down ? ", y down" : "");
    case ViewportType::pixels_per_unit:
        return "pixels-per-unit";
    case ViewportType::none:
        break;
    }
    return "none";
}

} // namespace rastertrace
