// SPDX-License-Identifier: MIT
#include "pixel_runs.h"

#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

namespace rastertrace {

std::vector<PixelRuns> runs_of(const Pixels& pixels) {
    if (pixels.columns == 0)
        return {};
    const auto order = [](Color a, Color b) {
        return std::tuple(a.red(), a.green(), a.blue(), a.alpha()) <
               std::tuple(b.red(), b.green(), b.blue(), b.alpha());
    };
    std::map<Color, std::vector<Rectangle>, decltype(order)> by_color(order);
    const auto at = [&pixels](std::size_t i) { return pixels.colors[i]; };
    const std::size_t count = pixels.colors.size() / pixels.columns * pixels.columns;
    for (std::size_t begin = 0; begin < count;) {
        const std::size_t row_end = (begin / pixels.columns + 1) * pixels.columns;
        std::size_t end = begin + 1;
        while (end < row_end && at(end) == at(begin))
            ++end;
        if (at(begin) != no_color) {
            const auto column = static_cast<double>(begin % pixels.columns);
            const auto row = static_cast<double>(begin / pixels.columns);
            by_color[at(begin)].push_back({.corner = {pixels.corner.x + column * pixels.side,
                                                      pixels.corner.y + row * pixels.side},
                                           .width = static_cast<double>(end - begin) * pixels.side,
                                           .height = pixels.side});
        }
        begin = end;
    }
    std::vector<PixelRuns> runs;
    for (auto& [color, rectangles] : by_color)
        runs.push_back({color, std::move(rectangles)});
    return runs;
}

} // namespace rastertrace
