// SPDX-License-Identifier: MIT
#include "corners.h"

namespace rastertrace {

Path corners_of(const PrimitiveStep& primitive) {
    Path corners;
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

std::optional<std::array<double, 3>> plane_through(const Path& at,
                                                   const std::array<double, 3>& values) {
    const double ux = at[1].x - at[0].x;
    const double uy = at[1].y - at[0].y;
    const double vx = at[2].x - at[0].x;
    const double vy = at[2].y - at[0].y;
    const double area = ux * vy - uy * vx;
    if (area == 0)
        return std::nullopt;
    const double du = values[1] - values[0];
    const double dv = values[2] - values[0];
    const double a = (du * vy - dv * uy) / area;
    const double b = (ux * dv - vx * du) / area;
    return std::array{a, b, values[0] - a * at[0].x - b * at[0].y};
}

} // namespace rastertrace
