// SPDX-License-Identifier: MIT
#include <rastertrace/figures/corners.h>

namespace rastertrace {

std::vector<Point> corners_of(const PrimitiveStep& primitive) {
    std::vector<Point> corners;
    for (const TracedList<TracedNumber>& place : primitive.at.values()) {
        const auto at = place.values();
        const auto x = at.size() < 2 ? std::nullopt : at[0].nearest_double();
        const auto y = at.size() < 2 ? std::nullopt : at[1].nearest_double();
        if (!x || !y)
            return {};
        corners.push_back({*x, *y});
    }
    return corners;
}

} // namespace rastertrace
