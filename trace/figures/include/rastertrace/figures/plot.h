// SPDX-License-Identifier: MIT
#pragma once

// A plot of curves, as a drawing. Axes are linear or logarithmic; beside a logarithmic x axis there is a shelf
// for what is exactly 0, which no logarithm reaches. Curves differ by the shape of their marks and the dashes
// of their lines, so that they can be told apart without color.
//
//     Plot plot{.x = {.label = "error"}, .y = {.label = "ns"}, .curves = {{"float", {{.x = 1e-7, .y = 2}}}}};
//     const std::string svg = svg_of(plot_drawing(plot), Theme::automatic).value();

#include <rastertrace/figures/drawing.h>

#include <string>
#include <vector>

namespace rastertrace {

/// A place on a plot.
struct PlotMark {
    double x = 0; ///< on a logarithmic axis: not negative; 0 stands on the shelf
    double y = 1; ///< on a logarithmic axis: above 0
    std::string label = {};
    bool is_on_front = false; ///< gets a ring
};

struct PlotCurve {
    std::string name;
    std::vector<PlotMark> marks = {}; ///< a line joins them in their order
    bool has_line = true;
    bool has_marks = true; ///< without, neither marks nor labels are drawn
};

enum class PlotScale { logarithmic, linear };

struct PlotAxis {
    PlotScale scale = PlotScale::logarithmic;
    std::string label = {};
};

/// The usual widths of a plot and of a legend, in units. They are as high as what is in them.
inline constexpr double plot_width = 460;
inline constexpr double legend_width = 300;

struct Plot {
    double width = plot_width;
    double area_height = 310; ///< of the part between the axes
    std::string title = {};
    PlotAxis x = {};
    PlotAxis y = {};
    std::vector<PlotCurve> curves =
        {};                      ///< the nth looks like curve_role(n), also if it has no marks
    std::string caption = {};    ///< below the plot, in as many lines as it takes
    std::string only_shelf = {}; ///< what is said where nothing lies off the shelf: "no errors"
};

/// The plot. Every label stands where it covers no mark and no other label; one that has no room beside its mark
/// is led to by a thin line, and one that has none at all is told in the caption. Marks of a curve that lie on
/// one another share a label: "8, 12, 16".
Drawing plot_drawing(const Plot& plot);

/// What is on a plot: its curves, and the ring and the shelf if it has them.
Drawing legend_drawing(const Plot& plot);

} // namespace rastertrace
