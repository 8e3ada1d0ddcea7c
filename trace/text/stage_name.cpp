// SPDX-License-Identifier: MIT
#include "stage_name.h"

#include <array>

namespace rastertrace {

namespace {

constexpr std::array<JsonWord, stage_count> words{{
    {"model", "takes vertices from object to world space"},
    {"view", "takes vertices from world to camera space"},
    {"clip", "cuts at the planes that bound the view"},
    {"divide", "divides by w"},
    {"order", "sorts triangles for the painter"},
    {"cull", "drops faces by their normals"},
    {"light", "lights faces"},
    {"canvas", "drops pixels that the canvas does not have"},
    {"depth", "tests pixels against the nearest"},
    {"perspective", "mixes colors as they mix in space"},
    {"colors", "mixes the colors of vertices"},
}};

} // namespace

std::string_view name_of(Stage stage) {
    return words[static_cast<std::size_t>(stage)].name;
}

std::optional<Stage> stage_named(std::string_view name) {
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i].name == name)
            return static_cast<Stage>(i);
    return std::nullopt;
}

std::span<const JsonWord> stage_words() {
    return words;
}

std::vector<std::string_view> stage_names() {
    constexpr auto names = names_of(words);
    return {names.begin(), names.end()};
}

} // namespace rastertrace
