// SPDX-License-Identifier: MIT
#pragma once

// A plot as SVG: two logarithmic axes, and a shelf at the left for what is exactly 0, which no
// logarithm reaches. One line per curve, its marks joined in their order. Curves differ by the shape
// of their marks and the dashes of their lines, so that they can be told apart without color.
//
//     Plot plot{.x_label = "error", .y_label = "ns", .curves = {{"float", {{.x = 1e-7, .y = 2}}}}};
//     const std::string svg = svg_document(plot_size, plot_svg(plot));

#include <rastertrace/figures/svg.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// A place on a plot.
struct PlotMark {
    double x = 0; ///< 0 stands on the shelf; not negative
    double y = 1; ///< above 0
    std::string label;
    bool is_on_front = false; ///< gets a ring
};

struct PlotCurve {
    std::string name;
    std::vector<PlotMark> marks;
};

struct Plot {
    std::string title;
    std::string x_label;
    std::string y_label;
    std::vector<PlotCurve> curves; ///< the nth is drawn in the nth style, also if it has no marks
    std::string caption;           ///< below the plot, wrapped
};

/// In pixels of the SVG.
struct SvgSize {
    double width = 0;
    double height = 0;
};
inline constexpr SvgSize plot_size{460, 420};
inline constexpr SvgSize legend_size{300, 420};

/// A group whose upper left corner is at (0, 0), of plot_size.
std::string plot_svg(const Plot& plot);

/// What the lines mean, of legend_size.
std::string legend_svg(const std::vector<PlotCurve>& curves);

/// A group, moved.
std::string moved_svg(double x, double y, std::string_view group);

/// A line of text; `size` in pixels.
std::string text_svg(double x, double y, double size, std::string_view text);

/// A whole document around groups.
std::string svg_document(const SvgSize& size, std::string_view title, std::string_view body);

} // namespace rastertrace
