// SPDX-License-Identifier: MIT
#include "pipeline_names.h"

#include <array>
#include <cstddef>

namespace rastertrace {

namespace {

constexpr std::array<std::string_view, 5> projections{"none", "orthographic", "pinhole",
                                                      "view-plane", "frustum"};

} // namespace

std::string_view name_of(ProjectionType type) {
    return projections[static_cast<std::size_t>(type)];
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

std::string_view name_of(ViewportType type) {
    constexpr std::array<std::string_view, 3> names{"none", "fit", "pixels-per-unit"};
    return names[static_cast<std::size_t>(type)];
}

} // namespace rastertrace
