// SPDX-License-Identifier: MIT
#include "primitive_name.h"

#include "text.h"

#include <algorithm>

namespace rastertrace {

std::string_view name_of(PrimitiveKind kind) {
    return traits_of(kind).name;
}

std::string_view name_separator(std::span<const std::string_view> names) {
    const bool all_short = std::all_of(names.begin(), names.end(), [](std::string_view name) {
        return !name.empty() && first_code_point(name).length == name.size();
    });
    return all_short ? "" : "-";
}

std::string joined_names(std::span<const std::string_view> names) {
    return joined(names, name_separator(names));
}

} // namespace rastertrace
