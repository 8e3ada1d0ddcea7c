// SPDX-License-Identifier: MIT
#include "stage_name.h"

#include <array>

namespace rastertrace {

namespace {

constexpr auto words =
    std::to_array<std::string_view>({"model", "view", "clip", "divide", "order", "cull", "light",
                                     "canvas", "depth", "perspective", "colors"});

static_assert(words.size() == stage_count);

} // namespace

std::string_view name_of(Stage stage) {
    return words[static_cast<std::size_t>(stage)];
}

std::optional<Stage> stage_named(std::string_view name) {
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == name)
            return static_cast<Stage>(i);
    return std::nullopt;
}

std::vector<std::string_view> stage_names() {
    return {words.begin(), words.end()};
}

} // namespace rastertrace
