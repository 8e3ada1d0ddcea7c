// SPDX-License-Identifier: MIT
#pragma once

// What of a shape can be on the sheet: TeX has no numbers for places that are far from it.
//
//     const SheetClip clip{.width = 40, .height = 20, .margin = 5};
//     visible_pieces({{-1e6, 10}, {1e6, 10}}, clip);  // {{{-5, 10}, {45, 10}}}

#include <rastertrace/figures/drawing.h>

#include <optional>
#include <vector>

namespace rastertrace {

/// A sheet and so many units around it.
struct SheetClip {
    double width;
    double height;
    double margin;
};

bool is_visible(Place place, const SheetClip& clip);

/// The part of a rectangle; nothing if there is none, or if it has no area.
std::optional<Rectangle> visible_part(const Rectangle& rectangle, const SheetClip& clip);

/// The parts of a line, one after the other.
std::vector<Path> visible_pieces(const Path& path, const SheetClip& clip);

/// The part of a polygon, after Sutherland and Hodgman 1974; empty if there is none.
Path visible_polygon(const Path& polygon, const SheetClip& clip);

} // namespace rastertrace
