// SPDX-License-Identifier: MIT
#pragma once

// Colors as scenes and traces write them: "#ff8000", "#ff800080", or a name of CSS 2.1.

#include <rastertrace/core/raster/image.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The color that `text` names: #rgb, #rrggbb, #rrggbbaa, or one of the 17 names of CSS 2.1.
std::optional<Color> parse_color(std::string_view text);

/// #rrggbb, or #rrggbbaa where alpha is not 255.
std::string to_text(Color color);

/// Relative luminance of an sRGB color, 0 to 1: IEC 61966-2-1, with the weights of BT.709.
double luminance(Color color);

/// True if black can be read on a color more easily than white: where their contrasts meet (WCAG 2), at a luminance
/// of 0.179.
bool is_light(Color color);

/// The sixteen names.
std::vector<std::string_view> color_names();

} // namespace rastertrace
