// SPDX-License-Identifier: MIT
#include "clip.h"

#include <algorithm>
#include <cmath>

namespace rastertrace {

std::optional<std::pair<Place, Place>> clipped(Place from, Place to, const Rectangle& frame) {
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    if (!std::isfinite(dx) || !std::isfinite(dy))
        return std::nullopt;

    // The share of the line, from `enters` to `leaves`, on the inner side of all four borders. On each border
    // `away` is how fast the line goes outward, `room` how far it may.
    double enters = 0;
    double leaves = 1;
    const auto cut = [&](double away, double room) {
        if (away == 0)
            return room >= 0;
        const double share = room / away;
        if (away < 0)
            enters = std::max(enters, share);
        else
            leaves = std::min(leaves, share);
        return enters <= leaves;
    };
    const bool is_there =
        cut(-dx, from.x - frame.corner.x) && cut(dx, frame.corner.x + frame.width - from.x) &&
        cut(-dy, from.y - frame.corner.y) && cut(dy, frame.corner.y + frame.height - from.y);
    if (!is_there)
        return std::nullopt;
    return std::pair{Place{from.x + enters * dx, from.y + enters * dy},
                     Place{from.x + leaves * dx, from.y + leaves * dy}};
}

Path clipped(const Path& polygon, const std::function<double(Place)>& function) {
    Path result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Place here = polygon[i];
        const Place next = polygon[(i + 1) % polygon.size()];
        const double at_here = function(here);
        const double at_next = function(next);
        if (at_here >= 0)
            result.push_back(here);
        if ((at_here < 0) != (at_next < 0)) {
            const double share = at_here / (at_here - at_next);
            result.push_back(
                {here.x + share * (next.x - here.x), here.y + share * (next.y - here.y)});
        }
    }
    return result;
}

Path corners_of(const Rectangle& frame) {
    const double right = frame.corner.x + frame.width;
    const double bottom = frame.corner.y + frame.height;
    return {frame.corner, {right, frame.corner.y}, {right, bottom}, {frame.corner.x, bottom}};
}

} // namespace rastertrace
