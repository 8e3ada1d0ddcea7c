// SPDX-License-Identifier: MIT
#include <rastertrace/trace/step_kind.h>

#include <array>

namespace rastertrace {

namespace {

constexpr std::array<std::string_view, step_kinds> names{
    "matrix", "vertex", "order",  "primitive", "face",     "light",  "clip",
    "edge",   "half",   "ray",    "scanline",  "along",    "decide", "sample",
    "depth",  "pixel",  "reject", "skip",      "undecided"};

} // namespace

std::string_view name_of(StepKind kind) {
    return names[static_cast<std::size_t>(kind)];
}

std::optional<StepKind> step_kind_named(std::string_view name) {
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name)
            return static_cast<StepKind>(i);
    return std::nullopt;
}

std::vector<std::string_view> step_kind_names() {
    return {names.begin(), names.end()};
}

} // namespace rastertrace
