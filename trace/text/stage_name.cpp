// SPDX-License-Identifier: MIT
#include "stage_name.h"

#include <array>

namespace rastertrace {

namespace {

constexpr std::array<std::string_view, stage_count> names{"model", "view",        "clip",  "divide",
                                                          "order", "cull",        "light", "canvas",
                                                          "depth", "perspective", "colors"};

} // namespace

std::string_view name_of(Stage stage) {
    return names[static_cast<std::size_t>(stage)];
}

std::optional<Stage> stage_named(std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name)
            return static_cast<Stage>(i);
    return std::nullopt;
}

std::vector<std::string_view> stage_names() {
    return {names.begin(), names.end()};
}

} // namespace rastertrace
