// SPDX-License-Identifier: MIT
#pragma once

// Where the pixels of a canvas, and the places of the scene, are on a sheet.
//
// A pixel is a square around its sample: with `sample: integer` around the integer point, with `center` between it
// and the next one (canvas.h of the core). So an edge that passes a sample passes the middle of a square.

#include <rastertrace/figures/drawing.h>
#include <rastertrace/trace/record/trace_options.h>

#include <algorithm>

namespace rastertrace {

struct Lattice {
    Canvas canvas;
    Region region;                   ///< the pixels that are shown
    bool begins_at_integers = false; ///< pixels do; else the integer points are in their middles
    double sample_x = 0;             ///< from the integer point of a pixel
    double sample_y = 0;
    double cell = 1; ///< side of a pixel, in units
    Place corner;    ///< of the first one, at the upper left

    int columns() const { return region.x1 - region.x0 + 1; }
    int rows() const { return std::max(region.y0, region.y1) - std::min(region.y0, region.y1) + 1; }
    double width() const { return columns() * cell; }
    double height() const { return rows() * cell; }

    /// The y of the top row.
    int top() const {
        return canvas.down() > 0 ? std::min(region.y0, region.y1) : std::max(region.y0, region.y1);
    }

    bool has(Pixel pixel) const {
        const int row = (pixel.y - top()) * canvas.down();
        return region.x0 <= pixel.x && pixel.x <= region.x1 && 0 <= row && row < rows();
    }

    /// The upper left corner of a pixel.
    Place corner_of(Pixel pixel) const {
        return {corner.x + (pixel.x - region.x0) * cell,
                corner.y + (pixel.y - top()) * canvas.down() * cell};
    }
    Rectangle square_of(Pixel pixel) const { return {corner_of(pixel), cell, cell}; }

    /// The middle of a pixel.
    Place middle_of(Pixel pixel) const {
        const Place at = corner_of(pixel);
        return {at.x + cell / 2, at.y + cell / 2};
    }

    /// A place of the scene, in its coordinates.
    Place place_of(double x, double y) const {
        const double middle = begins_at_integers ? 0.5 : 0.0; // from the integer point
        return {corner.x + (x - region.x0 - middle + 0.5) * cell,
                corner.y + ((y - middle - top()) * canvas.down() + 0.5) * cell};
    }
    Place sample_of(Pixel pixel) const { return place_of(pixel.x + sample_x, pixel.y + sample_y); }

    Rectangle frame() const { return {corner, width(), height()}; }
};

} // namespace rastertrace
