// SPDX-License-Identifier: MIT
#pragma once

// An axis of a plot: from values to places on the sheet, and the values that are written beside it.
//
//     const Axis axis = axis_around({1, 40}, {.from = 0, .to = 300}, PlotScale::linear, {});
//     axis.at(20);

#include <rastertrace/figures/plot.h>

#include <string>
#include <vector>

namespace rastertrace {

struct Axis {
    PlotScale scale = PlotScale::logarithmic;
    double low = 0.1; ///< the value at `from`
    double high = 1;  ///< the value at `to`
    double from = 0;  ///< in units of the sheet
    double to = 1;

    /// Where a value lies. On a logarithmic axis, what is not above 0 lies at its low end.
    double at(double value) const;
};

/// The room of an axis on the sheet.
struct AxisRoom {
    double from = 0;
    double to = 1;
};

/// How much wider than its values a logarithmic axis is: its ends are the least value divided by `below`, and the
/// largest times `above`. A linear axis is a twentieth wider at both ends.
struct AxisMargin {
    double below = 1.5;
    double above = 1.5;
};

/// An axis that has all values: those above 0, if it is logarithmic.
Axis axis_around(const std::vector<double>& values, AxisRoom room, PlotScale scale,
                 AxisMargin factors);

/// A value worth a line across the plot, in its order of importance: powers of ten before others.
struct Tick {
    double value = 0;
    std::string text;  ///< "0.02", "500", "10"
    std::string power; ///< of ten, to be written raised: "-7"
};
std::vector<Tick> ticks_of(const Axis& axis);

} // namespace rastertrace
