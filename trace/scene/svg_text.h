// SPDX-License-Identifier: MIT
#pragma once

// SVG of polygons and lines, as courses hand it out (CMU 15-462 and Berkeley CS184, DrawSVG), read as scenes of ours:
// `polygon`, `polyline`, `rect` and `line` in `svg` and `g`, filled and stroked in colors. A unit is a pixel, whose
// sample is its center. Filled shapes are drawn in their order, then lines, one pixel wide.
//
//     <svg width="20" height="10"><polygon points="1,1 18,2 9,8.5" fill="#f00"/></svg>

#include <rastertrace/trace/text/problem.h>

namespace rastertrace {

/// The scene that an SVG describes, as a scene file. Elements and attributes that change the picture and have no
/// counterpart here are refused: transforms, scripts, entities, opacity.
Result<Source> scene_of_svg(const Source& source);

} // namespace rastertrace
