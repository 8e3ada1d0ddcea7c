// SPDX-License-Identifier: MIT
#pragma once

// Values of an enumeration by their names, in the order of the values.
//
//     constexpr std::array<std::string_view, 2> names{"spaces", "ears"};
//     value_named<SpaceFrames>(names, "ears");  // SpaceFrames::ears

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

namespace rastertrace {

/// The value whose name it is; nothing if none has it.
template <typename Value>
std::optional<Value> value_named(std::span<const std::string_view> names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        return std::nullopt;
    return static_cast<Value>(found - names.begin());
}

} // namespace rastertrace
