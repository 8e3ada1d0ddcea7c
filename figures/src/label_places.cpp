// SPDX-License-Identifier: MIT
#include "label_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rastertrace {

namespace {

/// Twice the signed area of a triangle: on which side of a-b c lies.
double side_of(Place a, Place b, Place c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool do_cross(Place a, Place b, Place c, Place d) {
    return side_of(a, b, c) * side_of(a, b, d) < 0 && side_of(c, d, a) * side_of(c, d, b) < 0;
}

/// True if a segment passes through a box: it has an end in it, or crosses a diagonal.
bool passes(const Path& segment, const Box& box) {
    const auto is_in = [&box](Place p) {
        return box.left < p.x && p.x < box.right && box.top < p.y && p.y < box.bottom;
    };
    return is_in(segment[0]) || is_in(segment[1]) ||
           do_cross(segment[0], segment[1], {box.left, box.top}, {box.right, box.bottom}) ||
           do_cross(segment[0], segment[1], {box.left, box.bottom}, {box.right, box.top});
}

/// From the rim of a mark to the nearest place of a box.
Path leader_to(const Box& box, const LabelWish& wish) {
    const Place end{std::clamp(wish.mark.x, box.left, box.right),
                    std::clamp(wish.mark.y, box.top, box.bottom)};
    const double x = end.x - wish.mark.x;
    const double y = end.y - wish.mark.y;
    const double length = std::sqrt(x * x + y * y);
    const double begin = length > wish.away ? wish.away / length : 0;
    return {{wish.mark.x + begin * x, wish.mark.y + begin * y}, end};
}

} // namespace

Box box_around(Place center, double radius) {
    return {center.x - radius, center.y - radius, center.x + radius, center.y + radius};
}

bool LabelPlaces::is_free(const Box& box) const {
    return area_.has(box) && std::none_of(taken_.begin(), taken_.end(),
                                          [&box](const Box& other) { return box.meets(other); });
}

bool LabelPlaces::is_clear(const Path& leader) const {
    return std::none_of(labels_.begin(), labels_.end(),
                        [&leader](const Box& label) { return passes(leader, label); }) &&
           std::none_of(leaders_.begin(), leaders_.end(), [&leader](const Path& other) {
               return do_cross(leader[0], leader[1], other[0], other[1]);
           });
}

std::optional<LabelPlace> LabelPlaces::find_beside(const LabelWish& wish) {
    const auto& [mark, away, width, height] = wish;
    // Right, above, below, left, and the four corners, which may come a little nearer.
    constexpr double nearer = 2;
    const std::array<Place, 8> corners{
        {{mark.x + away, mark.y - height / 2},
         {mark.x - width / 2, mark.y - away - height},
         {mark.x - width / 2, mark.y + away},
         {mark.x - away - width, mark.y - height / 2},
         {mark.x + away - nearer, mark.y - away - height + nearer},
         {mark.x + away - nearer, mark.y + away - nearer},
         {mark.x - away - width + nearer, mark.y - away - height + nearer},
         {mark.x - away - width + nearer, mark.y + away - nearer}}};
    for (const bool may_cross : {false, true})
        for (const Place& corner : corners) {
            const Box box{corner.x, corner.y, corner.x + width, corner.y + height};
            if (!is_free(box) || (!may_cross && crosses_border(box)))
                continue;
            // A line that leads to another label must stay in sight.
            if (std::any_of(leaders_.begin(), leaders_.end(),
                            [&box](const Path& leader) { return passes(leader, box); }))
                continue;
            take(box);
            labels_.push_back(box);
            return LabelPlace{.box = box};
        }
    return std::nullopt;
}

std::optional<LabelPlace> LabelPlaces::find_anywhere(const LabelWish& wish) {
    // All places on a grid; the nearest one is best, and what crosses something is as good as farther away.
    constexpr double step = 4;
    constexpr double of_crossing = 150;
    constexpr double of_border = 30;
    std::optional<LabelPlace> best;
    double least = std::numeric_limits<double>::infinity();
    for (double top = area_.top; top + wish.height <= area_.bottom; top += step)
        for (double left = area_.left; left + wish.width <= area_.right; left += step) {
            const Box box{left, top, left + wish.width, top + wish.height};
            Path leader = leader_to(box, wish);
            const double x = leader[1].x - wish.mark.x;
            const double y = leader[1].y - wish.mark.y;
            double price = std::sqrt(x * x + y * y) + (crosses_border(box) ? of_border : 0);
            if (price >= least || !is_free(box))
                continue;
            const bool hides_leader =
                std::any_of(leaders_.begin(), leaders_.end(),
                            [&box](const Path& other) { return passes(other, box); });
            price += is_clear(leader) && !hides_leader ? 0 : of_crossing;
            if (price >= least)
                continue;
            least = price;
            best = LabelPlace{.box = box, .leader = std::move(leader)};
        }
    if (best) {
        take(best->box);
        labels_.push_back(best->box);
        leaders_.push_back(*best->leader);
    }
    return best;
}

} // namespace rastertrace
