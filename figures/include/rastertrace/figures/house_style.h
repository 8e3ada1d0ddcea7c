// SPDX-License-Identifier: MIT
#pragma once

// What a document has its figures look like, whatever the theme and the format: a file like
//
//     {"true-edge": {"color": "#003366", "width": 2.5}, "vertex": {"radius": 4}, "decimal": ","}
//
// The names are those of the roles: the classes of an .svg, the styles of a .tex.

#include <rastertrace/figures/drawing.h>
#include <rastertrace/trace/text/problem.h>

#include <map>
#include <optional>

namespace rastertrace {

struct RoleStyle {
    std::optional<Color> color = {};   ///< of lines, areas, dots and words
    std::optional<double> width = {};  ///< of lines, in units
    std::optional<double> radius = {}; ///< of dots, in units
};

struct HouseStyle {
    std::map<Role, RoleStyle> roles = {};
    bool has_decimal_comma = false; ///< 0,5; coordinates then have a semicolon between
};

/// The style that a file describes; or what is wrong with it.
Result<HouseStyle> house_style_in(const Source& source);

/// Draws a drawing in this style. Shapes that have colors of their own keep them.
void apply(const HouseStyle& style, Drawing& drawing);

} // namespace rastertrace
