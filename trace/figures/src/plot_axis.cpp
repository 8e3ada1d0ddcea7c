// SPDX-License-Identifier: MIT
#include "plot_axis.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rastertrace {

namespace {

/// Numbers between these are written out, others as powers of ten.
constexpr double smallest_written_out = 0.009;
constexpr double largest_written_out = 99'999;

/// A number on a logarithmic axis.
Tick logarithmic_tick(double digit, int power) {
    const double value = digit * std::pow(10, power);
    if (smallest_written_out <= value && value <= largest_written_out)
        return {value, fmt::format("{:g}", value), {}};
    const std::string text = digit == 1 ? "10" : fmt::format("{:g}x10", digit);
    return {value, text, fmt::format("{}", power)};
}

/// Powers of ten; where there are few of these, 2 and 5 of each, too.
std::vector<Tick> logarithmic_ticks(const Axis& axis) {
    constexpr double room_of_number = 36; // in units, with a power of ten
    constexpr int few_powers = 3;
    const int most_powers =
        std::max(2, static_cast<int>(std::abs(axis.to - axis.from) / room_of_number));
    const auto first = static_cast<int>(std::floor(std::log10(axis.low)));
    const auto last = static_cast<int>(std::ceil(std::log10(axis.high)));
    const int stride = std::max(1, (last - first + most_powers - 1) / most_powers);
    std::vector<Tick> ticks;
    for (const double digit : {1.0, 5.0, 2.0}) {
        if (digit != 1 && last - first > few_powers)
            continue;
        for (int power = first; power <= last; ++power) {
            const double value = digit * std::pow(10, power);
            if (power % stride == 0 && axis.low <= value && value <= axis.high)
                ticks.push_back(logarithmic_tick(digit, power));
        }
    }
    return ticks;
}

/// Multiples of a step of 1, 2 or 5 times a power of ten, at most eight of them.
std::vector<Tick> linear_ticks(const Axis& axis) {
    constexpr double most = 8;
    const double least_step = (axis.high - axis.low) / most;
    const double power = std::pow(10, std::floor(std::log10(least_step)));
    double step = 10 * power;
    for (const double digit : {5.0, 2.0, 1.0})
        if (digit * power >= least_step)
            step = digit * power;
    std::vector<Tick> ticks;
    const auto first = static_cast<long long>(std::ceil(axis.low / step));
    const auto last = static_cast<long long>(std::floor(axis.high / step));
    for (long long i = first; i <= last; ++i) {
        const double value = static_cast<double>(i) * step;
        ticks.push_back({value, fmt::format("{:.6g}", value), {}});
    }
    return ticks;
}

} // namespace

double Axis::at(double value) const {
    const double share = scale == PlotScale::linear
                             ? (value - low) / (high - low)
                             : std::log10(std::max(value, low) / low) / std::log10(high / low);
    return from + share * (to - from);
}

Axis axis_around(const std::vector<double>& values, AxisRoom room, PlotScale scale,
                 AxisMargin factors) {
    Axis axis{.scale = scale, .low = 0.1, .high = 1, .from = room.from, .to = room.to};
    std::vector<double> shown = values;
    if (scale == PlotScale::logarithmic)
        std::erase_if(shown, [](double value) { return value <= 0; });
    if (shown.empty())
        return axis;
    const auto [least, largest] = std::minmax_element(shown.begin(), shown.end());
    if (scale == PlotScale::logarithmic) {
        axis.low = *least / factors.below;
        axis.high = *largest * factors.above;
    } else {
        const double extra = *largest > *least ? (*largest - *least) / 20 : 1;
        axis.low = *least - extra;
        axis.high = *largest + extra;
    }
    return axis;
}

std::vector<Tick> ticks_of(const Axis& axis) {
    return axis.scale == PlotScale::linear ? linear_ticks(axis) : logarithmic_ticks(axis);
}

} // namespace rastertrace
