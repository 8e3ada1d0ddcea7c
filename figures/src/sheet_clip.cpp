// SPDX-License-Identifier: MIT
#include "sheet_clip.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace rastertrace {

namespace {

/// A border: places with `sign` * coordinate <= `limit` are inside.
struct Border {
    double Place::*coordinate;
    double sign;
    double limit;

    double outside_by(Place place) const { return sign * (place.*coordinate) - limit; }
};

std::array<Border, 4> borders_of(const SheetClip& clip) {
    return {{{&Place::x, -1, clip.margin},
             {&Place::x, 1, clip.width + clip.margin},
             {&Place::y, -1, clip.margin},
             {&Place::y, 1, clip.height + clip.margin}}};
}

/// Where the line from a to b, one of which is outside, meets a border.
Place crossing(Place a, Place b, const Border& border) {
    const double before = border.outside_by(a);
    const double behind = border.outside_by(b);
    const double share = before / (before - behind);
    Place place{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    place.*border.coordinate = border.sign * border.limit; // without what rounding added
    return place;
}

} // namespace

bool is_visible(Place place, const SheetClip& clip) {
    const auto borders = borders_of(clip);
    return std::all_of(borders.begin(), borders.end(),
                       [place](const Border& border) { return border.outside_by(place) <= 0; });
}

std::optional<Rectangle> visible_part(const Rectangle& rectangle, const SheetClip& clip) {
    const auto cut = [&clip](double at, double length, double most) {
        return std::pair(std::clamp(std::min(at, at + length), -clip.margin, most + clip.margin),
                         std::clamp(std::max(at, at + length), -clip.margin, most + clip.margin));
    };
    const auto [left, right] = cut(rectangle.corner.x, rectangle.width, clip.width);
    const auto [top, bottom] = cut(rectangle.corner.y, rectangle.height, clip.height);
    if (left >= right || top >= bottom)
        return std::nullopt;
    return Rectangle{{left, top}, right - left, bottom - top};
}

std::vector<Path> visible_pieces(const Path& path, const SheetClip& clip) {
    std::vector<Path> pieces;
    for (std::size_t i = 1; i < path.size(); ++i) {
        Place a = path[i - 1];
        Place b = path[i];
        bool is_seen = true;
        for (const Border& border : borders_of(clip)) {
            const bool a_is_outside = border.outside_by(a) > 0;
            const bool b_is_outside = border.outside_by(b) > 0;
            is_seen = is_seen && !(a_is_outside && b_is_outside);
            if (!is_seen)
                break;
            if (a_is_outside)
                a = crossing(a, b, border);
            else if (b_is_outside)
                b = crossing(a, b, border);
        }
        if (!is_seen)
            continue;
        if (pieces.empty() || !(pieces.back().back() == a))
            pieces.push_back({a});
        pieces.back().push_back(b);
    }
    return pieces;
}

Path visible_polygon(const Path& polygon, const SheetClip& clip) {
    Path rest = polygon;
    for (const Border& border : borders_of(clip)) {
        Path kept;
        for (std::size_t i = 0; i < rest.size(); ++i) {
            const Place a = rest[i];
            const Place b = rest[(i + 1) % rest.size()];
            const bool a_is_outside = border.outside_by(a) > 0;
            const bool b_is_outside = border.outside_by(b) > 0;
            if (!a_is_outside)
                kept.push_back(a);
            if (a_is_outside != b_is_outside)
                kept.push_back(crossing(a, b, border));
        }
        rest = std::move(kept);
    }
    return rest;
}

} // namespace rastertrace
