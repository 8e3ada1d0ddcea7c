// SPDX-License-Identifier: MIT
#pragma once

// The conventions of graphics hardware, other rasterizers and courses: what each sets, a row of one table. A scene
// says "convention": NAME; what it says itself wins.
//
//     row_of(Convention::cs418).method;  // {{"fill", "scanline"}, {"rows", "half-open"}, ...}

#include <rastertrace/core/draw/scene/method.h>
#include <rastertrace/core/transform/viewport.h>

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// Where canonical coordinates come to on the canvas, and which z is in view.
struct ConventionView {
    PixelRange pixels;
    bool is_y_down = false;      ///< y = 1 is at the bottom of the picture
    bool z_from_zero = false;    ///< of vertices in clip space: 0 <= z <= w, not -w <= z <= w
    bool has_unit_depths = true; ///< depths are 0 to 1, not z/w
};

struct ConventionRow {
    Convention convention;
    std::string_view name;
    std::string_view what;                                             ///< whose it is
    std::vector<std::pair<std::string_view, std::string_view>> method; ///< keys and values
    const ConventionView* view; ///< of scenes that are projected
    std::string_view source;    ///< where it is defined
    std::string_view unusual;   ///< what others do otherwise
};

/// All of them, in the order in which they are listed.
std::span<const ConventionRow> convention_rows();

/// The row of a convention; nullptr of none.
const ConventionRow* row_of(Convention convention);

/// `edges, y down, depths 0 to 1`
std::string name_of_view(const ConventionRow& row);

} // namespace rastertrace
