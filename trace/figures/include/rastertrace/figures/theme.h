// SPDX-License-Identifier: MIT
#pragma once

// What the roles of a drawing look like, on light paper and on dark.
//
//     paint_of(Role::grid, Theme::dark).color;  // a dark gray

#include <rastertrace/figures/drawing.h>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rastertrace {

enum class Theme : std::uint8_t {
    automatic, ///< in an SVG, light or dark as the reader has set it; elsewhere light
    light,
    dark,
};

/// automatic is called auto.
std::vector<std::string_view> theme_names();
std::optional<Theme> theme_named(std::string_view name);

/// How a role is painted.
struct Paint {
    Color color;
    double width = 1;                    ///< of a line, in units
    std::span<const double> dashes = {}; ///< of a line: drawn, left out, drawn, ..., in units
};

/// In a theme; `automatic` is light.
Paint paint_of(Role role, Theme theme);

/// The name of a role, its class in an SVG: "true-edge".
std::string_view name_of(Role role);

/// All roles.
std::span<const Role> roles();

} // namespace rastertrace
