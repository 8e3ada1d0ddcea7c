// SPDX-License-Identifier: MIT
// The grid, its border, and the numbers of its columns and rows.

#include "clip.h"
#include "panel.h"

#include <array>
#include <cmath>
#include <string>

namespace rastertrace {

namespace {

constexpr double number_size = 9;

/// Only every 2nd, 5th, 10th, ... number, where they would touch.
int stride_of(double cell, double needed) {
    int stride = 1;
    for (const int next : {2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10'000, 20'000})
        if (stride * cell < needed)
            stride = next;
    return stride;
}

double widest_number(int first, int last) {
    return std::max(width_of(std::to_string(first), number_size),
                    width_of(std::to_string(last), number_size));
}

} // namespace

double axis_margin(const Lattice& lattice) {
    constexpr double gap = 5;
    return widest_number(lattice.region.y0, lattice.region.y1) + gap;
}

void add_grid(const Panel& panel, std::vector<Shape>& shapes) {
    const Lattice& lattice = panel.lattice;
    const Rectangle frame = lattice.frame();
    Lines lines{.role = Role::grid};
    for (int column = 1; column < lattice.columns(); ++column) {
        const double x = frame.corner.x + column * lattice.cell;
        lines.paths.push_back({{x, frame.corner.y}, {x, frame.bottom()}});
    }
    for (int row = 1; row < lattice.rows(); ++row) {
        const double y = frame.corner.y + row * lattice.cell;
        lines.paths.push_back({{frame.corner.x, y}, {frame.right(), y}});
    }
    shapes.push_back(std::move(lines));
}

void add_border(const Panel& panel, std::vector<Shape>& shapes) {
    shapes.push_back(Lines{
        .role = Role::border, .paths = {corners_of(panel.lattice.frame())}, .are_closed = true});
}

void add_axes(const Panel& panel, std::vector<Shape>& shapes) {
    const Lattice& lattice = panel.lattice;
    const Rectangle frame = lattice.frame();
    const Place zero = lattice.place_of(0, 0);

    // Where x or y is 0, if that is inside.
    Lines axes{.role = Role::axis};
    if (frame.corner.x < zero.x && zero.x < frame.right())
        axes.paths.push_back({{zero.x, frame.corner.y}, {zero.x, frame.bottom()}});
    if (frame.corner.y < zero.y && zero.y < frame.bottom())
        axes.paths.push_back({{frame.corner.x, zero.y}, {frame.right(), zero.y}});
    if (panel.parts.has(FigurePart::grid) && !has_cell_texts(panel.parts))
        shapes.push_back(std::move(axes));

    // The numbers of columns below, those of rows at the left.
    constexpr double gap = 3;
    const int every_column =
        stride_of(lattice.cell, widest_number(lattice.region.x0, lattice.region.x1) + gap);
    const int every_row = stride_of(lattice.cell, number_size + 1);
    for (int x = lattice.region.x0; x <= lattice.region.x1; ++x)
        if (x % every_column == 0)
            shapes.push_back(Label{
                .role = Role::quiet_text,
                .at = {lattice.middle_of({x, lattice.top()}).x, frame.bottom() + axis_height - 4},
                .text = std::to_string(x),
                .size = number_size,
                .anchor = Anchor::middle});
    for (int y = lattice.region.y0; y <= lattice.region.y1; ++y)
        if (y % every_row == 0)
            shapes.push_back(
                Label{.role = Role::quiet_text,
                      .at = {frame.corner.x - gap,
                             lattice.middle_of({lattice.region.x0, y}).y + 0.35 * number_size},
                      .text = std::to_string(y),
                      .size = number_size,
                      .anchor = Anchor::end});
}

} // namespace rastertrace
