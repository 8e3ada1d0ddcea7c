// SPDX-License-Identifier: MIT
#include "clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace rastertrace {

namespace {

/// A border: places with `sign` * coordinate <= `limit` are inside.
struct Border {
    double Place::*coordinate;
    double sign;
    double limit;

    double outside_by(Place place) const { return sign * (place.*coordinate) - limit; }
};

std::array<Border, 4> borders_of(const Rectangle& frame) {
    return {{{&Place::x, -1, -frame.left()},
             {&Place::x, 1, frame.right()},
             {&Place::y, -1, -frame.top()},
             {&Place::y, 1, frame.bottom()}}};
}

/// The place on the line from a to b where a linear function is 0 that has these values at its ends.
Place zero_between(Place a, Place b, double at_a, double at_b) {
    const double share = at_a / (at_a - at_b);
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

/// Where the line from a to b, one of which is outside, meets a border.
Place crossing(Place a, Place b, const Border& border) {
    Place place = zero_between(a, b, border.outside_by(a), border.outside_by(b));
    place.*border.coordinate = border.sign * border.limit; // without what rounding added
    return place;
}

/// The part of a polygon that is not outside.
template <typename OutsideBy, typename Crossing>
Path part_of(const Path& polygon, const OutsideBy& outside_by, const Crossing& crossing_of) {
    Path part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Place a = polygon[i];
        const Place b = polygon[(i + 1) % polygon.size()];
        const bool a_is_outside = outside_by(a) > 0;
        const bool b_is_outside = outside_by(b) > 0;
        if (!a_is_outside)
            part.push_back(a);
        if (a_is_outside != b_is_outside)
            part.push_back(crossing_of(a, b));
    }
    return part;
}

} // namespace

std::optional<std::pair<Place, Place>> clipped(Place from, Place to, const Rectangle& frame) {
    if (!std::isfinite(to.x - from.x) || !std::isfinite(to.y - from.y))
        return std::nullopt;
    for (const Border& border : borders_of(frame)) {
        const bool from_is_outside = border.outside_by(from) > 0;
        const bool to_is_outside = border.outside_by(to) > 0;
        if (from_is_outside && to_is_outside)
            return std::nullopt;
        if (from_is_outside)
            from = crossing(from, to, border);
        else if (to_is_outside)
            to = crossing(from, to, border);
    }
    return std::pair{from, to};
}

std::vector<Path> clipped_pieces(const Path& path, const Rectangle& frame) {
    std::vector<Path> pieces;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const auto part = clipped(path[i - 1], path[i], frame);
        if (!part)
            continue;
        if (pieces.empty() || !(pieces.back().back() == part->first))
            pieces.push_back({part->first});
        pieces.back().push_back(part->second);
    }
    return pieces;
}

Path clipped(const Path& polygon, const std::function<double(Place)>& function) {
    return part_of(
        polygon, [&](Place place) { return -function(place); },
        [&](Place a, Place b) { return zero_between(a, b, function(a), function(b)); });
}

Path clipped(const Path& polygon, const Rectangle& frame) {
    Path part = polygon;
    for (const Border& border : borders_of(frame))
        part = part_of(
            part, [&](Place place) { return border.outside_by(place); },
            [&](Place a, Place b) { return crossing(a, b, border); });
    return part;
}

std::optional<Rectangle> clipped(const Rectangle& rectangle, const Rectangle& frame) {
    const auto cut = [](double a, double b, double least, double most) {
        return std::pair(std::clamp(std::min(a, b), least, most),
                         std::clamp(std::max(a, b), least, most));
    };
    const auto [left, right] =
        cut(rectangle.left(), rectangle.right(), frame.left(), frame.right());
    const auto [top, bottom] =
        cut(rectangle.top(), rectangle.bottom(), frame.top(), frame.bottom());
    if (left >= right || top >= bottom)
        return std::nullopt;
    return Rectangle{{left, top}, right - left, bottom - top};
}

Path corners_of(const Rectangle& frame) {
    return {frame.corner,
            {frame.right(), frame.top()},
            {frame.right(), frame.bottom()},
            {frame.left(), frame.bottom()}};
}

} // namespace rastertrace
