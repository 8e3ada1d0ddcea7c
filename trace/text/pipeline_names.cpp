// SPDX-License-Identifier: MIT
#include "pipeline_names.h"

#include <array>
#include <cstddef>

namespace rastertrace {

namespace {

constexpr std::array projections{
    JsonWord{"none", "x and y are taken as they are"},
    JsonWord{"orthographic", "a box is in view; nothing gets smaller with its distance"},
    JsonWord{"pinhole", "onto a view plane at a distance; looks along +z"},
    JsonWord{"view-plane", "onto a view plane at a distance; looks along -z"},
    JsonWord{"frustum", "a perspective from near to far, as OpenGL has it; looks along -z"},
    JsonWord{"clip-space", "the vertices have been projected already, and are divided by w"}};
constexpr std::array pixel_ranges{
    JsonWord{"centers", "-1 and 1 are the centers of the first and the last pixel"},
    JsonWord{"edges", "-1 and 1 are the edges of the canvas; pixel i goes from i to i + 1"},
    JsonWord{"edges-half",
             "-1 and 1 are the edges of the canvas; pixel i goes from i - 1/2 to i + 1/2"}};
constexpr auto names_of_projections = names_of(projections);
constexpr auto names_of_pixel_ranges = names_of(pixel_ranges);

} // namespace

std::string_view name_of(ProjectionType type) {
    return projections[static_cast<std::size_t>(type)].name;
}

std::string name_of(const Projection& projection) {
    return std::string(name_of(projection.type)) + (projection.z_from_zero ? ", z from 0" : "");
}

std::optional<ProjectionType> projection_named(std::string_view name) {
    for (std::size_t i = 0; i < projections.size(); ++i)
        if (projections[i].name == name)
            return static_cast<ProjectionType>(i);
    return std::nullopt;
}

std::span<const JsonWord> projection_words() {
    return projections;
}

std::vector<std::string_view> projection_names() {
    return {names_of_projections.begin(), names_of_projections.end()};
}

std::span<const JsonWord> pixel_range_words() {
    return pixel_ranges;
}

std::span<const std::string_view> pixel_range_names() {
    return names_of_pixel_ranges;
}

std::string name_of(const Viewport& viewport) {
    switch (viewport.type) {
    case ViewportType::pixels:
        if (viewport.pixels == PixelRange::centers && !viewport.is_y_down)
            return "fit";
        return std::string(pixel_ranges[static_cast<std::size_t>(viewport.pixels)].name) +
               (viewport.is_y_down ? ", y down" : "");
    case ViewportType::pixels_per_unit:
        return "pixels-per-unit";
    case ViewportType::none:
        break;
    }
    return "none";
}

} // namespace rastertrace
