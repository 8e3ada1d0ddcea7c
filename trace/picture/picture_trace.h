// SPDX-License-Identifier: MIT
#pragma once

// A picture as what else is read: a trace that plots its pixels, or the rows of a claim.
//
//     const Source trace{"mine.png", picture_trace(picture), {}};

#include "picture.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

/// False if the picture has no colors, or a pixel of it is transparent: then only that is not drawn.
bool has_background(const Picture& picture);

/// The color of what is not drawn: that of most pixels on its border; `no_color` if it has no background.
Color background_of(const Picture& picture);

/// The color of what a picture of a drawing does not draw: the one `said`, or that of most pixels that the drawing does
/// not draw; `no_color` if it has no background.
Color background_beside(const Picture& picture, std::optional<Color> said,
                        const std::function<bool(int x, int row)>& is_drawn);

/// The color that most of some pixels have; `no_color` of none.
Color most_frequent(const std::vector<Color>& colors);

/// A trace of `pixel` steps, from the top, with the colors that the picture has; its canvas begins at the top left.
std::string picture_trace(const Picture& picture);

/// Rows of `#` where the picture is drawn, and of `.`.
std::vector<std::string> picture_rows(const Picture& picture);

} // namespace rastertrace
