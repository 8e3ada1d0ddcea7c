// SPDX-License-Identifier: MIT
#include "label_places.h"

#include "clip.h"

#include <rastertrace/trace/tell/formula.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rastertrace {

namespace {

bool do_cross(Place a, Place b, Place c, Place d) {
    return doubled_area(a, b, c) * doubled_area(a, b, d) < 0 &&
           doubled_area(c, d, a) * doubled_area(c, d, b) < 0;
}

/// True if a segment passes through a box: it has an end in it, or crosses a diagonal.
bool passes(const Path& segment, const Rectangle& box) {
    const auto is_in = [&box](Place p) {
        return box.left() < p.x && p.x < box.right() && box.top() < p.y && p.y < box.bottom();
    };
    return is_in(segment[0]) || is_in(segment[1]) ||
           do_cross(segment[0], segment[1], {box.left(), box.top()}, {box.right(), box.bottom()}) ||
           do_cross(segment[0], segment[1], {box.left(), box.bottom()}, {box.right(), box.top()});
}

/// From the rim of a mark to the nearest place of a box.
Path leader_to(const Rectangle& box, const LabelWish& wish) {
    const Place end{std::clamp(wish.mark.x, box.left(), box.right()),
                    std::clamp(wish.mark.y, box.top(), box.bottom())};
    const double x = end.x - wish.mark.x;
    const double y = end.y - wish.mark.y;
    const double length = std::sqrt(x * x + y * y);
    const double begin = length > wish.away ? wish.away / length : 0;
    return {{wish.mark.x + begin * x, wish.mark.y + begin * y}, end};
}

/// To have other words below is as bad as nothing else.
constexpr double of_other_words = 100;

/// How bad a place for words is: nothing is 0.
double badness_of(const Rectangle& box, const Obstacles& obstacles) {
    constexpr double of_leaving = 4; // what leaves the pixels may cover the title
    constexpr double of_axes = 1;    // or numbers
    constexpr double of_side = 1;
    const Rectangle& frame = obstacles.frame;
    const double height = box.height;
    double badness = 0;
    if (box.left() < 0 || frame.right() + height < box.right() ||
        box.top() < frame.top() - height / 2 || frame.bottom() + height / 2 < box.bottom())
        badness += of_leaving;
    if (box.left() < frame.left() || frame.bottom() < box.bottom())
        badness += of_axes;
    for (const Path& side : obstacles.sides)
        if (clipped(side[0], side[1], box))
            badness += of_side;
    for (const Rectangle& other : obstacles.words)
        if (box.meets(other))
            badness += of_other_words;
    return badness;
}

} // namespace

std::optional<Rectangle> words_beside(const WordsWish& wish, const Obstacles& obstacles) {
    constexpr double gap = 5;
    const auto& [mark, inside, words, size] = wish;
    const double width = width_of(words, size, true);
    const double away_x = mark.x - inside.x;
    const double away_y = mark.y - inside.y;
    const double away = std::max(1.0, std::sqrt(away_x * away_x + away_y * away_y));
    std::optional<Rectangle> best;
    double least = of_other_words / 2;
    for (const int right : {1, 0, -1})
        for (const int down : {-1, 0, 1}) {
            if (right == 0 && down == 0)
                continue;
            const double left = mark.x + right * gap + (right - 1) * width / 2;
            const double top = mark.y + down * gap + (down - 1) * size / 2;
            const Rectangle box{{left, top}, width, size};
            if (!obstacles.sheet.has(box))
                continue;
            const double inward = -(right * away_x + down * away_y) / away;
            const double badness = inward + badness_of(box, obstacles);
            if (badness >= least)
                continue;
            least = badness;
            best = box;
        }
    return best;
}

Rectangle box_around(Place center, double radius) {
    return {{center.x - radius, center.y - radius}, 2 * radius, 2 * radius};
}

LabelAnchor anchor_beside(Place mark, const Rectangle& box) {
    if (box.right() <= mark.x)
        return {box.right(), Anchor::end};
    if (mark.x <= box.left())
        return {box.left(), Anchor::start};
    return {(box.left() + box.right()) / 2, Anchor::middle};
}

Label strong_label_in(const Rectangle& box, const WordsWish& wish) {
    constexpr double baseline = 0.85; // of the size of letters, below the top of their box
    const auto [x, anchor] = anchor_beside(wish.mark, box);
    return {.role = Role::strong_text,
            .at = {x, box.top() + baseline * wish.size},
            .text = std::string(wish.words),
            .size = wish.size,
            .anchor = anchor,
            .is_bold = true,
            .names_points = true,
            .has_rim = true};
}

bool LabelPlaces::is_free(const Rectangle& box) const {
    return area_.has(box) &&
           std::none_of(taken_.begin(), taken_.end(),
                        [&box](const Rectangle& other) { return box.meets(other); });
}

std::size_t LabelPlaces::crossings(const Path& leader, Place mark) const {
    const auto marks_and_labels =
        std::count_if(taken_.begin(), taken_.end(), [&](const Rectangle& other) {
            const bool is_own = other.meets(box_around(mark, 0.1));
            return !is_own && passes(leader, other);
        });
    const auto leaders =
        std::count_if(leaders_.begin(), leaders_.end(), [&leader](const Path& other) {
            return do_cross(leader[0], leader[1], other[0], other[1]);
        });
    return static_cast<std::size_t>(marks_and_labels + leaders);
}

bool LabelPlaces::hides_leader(const Rectangle& box) const {
    return std::any_of(leaders_.begin(), leaders_.end(),
                       [&box](const Path& leader) { return passes(leader, box); });
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
            const Rectangle box{corner, width, height};
            if (!is_free(box) || hides_leader(box) || (!may_cross && crosses_border(box)))
                continue;
            take(box);
            return LabelPlace{.box = box};
        }
    return std::nullopt;
}

std::optional<LabelPlace> LabelPlaces::find_anywhere(const LabelWish& wish) {
    // All places on a grid; the nearest one is best, and to cross something is as bad as to be so much farther away,
    // in units.
    constexpr double step = 4;
    constexpr double of_crossing = 60;
    constexpr double of_border = 30;
    std::optional<LabelPlace> best;
    double least = std::numeric_limits<double>::infinity();
    for (double top = area_.top(); top + wish.height <= area_.bottom(); top += step)
        for (double left = area_.left(); left + wish.width <= area_.right(); left += step) {
            const Rectangle box{{left, top}, wish.width, wish.height};
            Path leader = leader_to(box, wish);
            const double x = leader[1].x - wish.mark.x;
            const double y = leader[1].y - wish.mark.y;
            double price = std::sqrt(x * x + y * y) + (crosses_border(box) ? of_border : 0);
            if (price >= least || !is_free(box))
                continue;
            const std::size_t crossed = crossings(leader, wish.mark) + (hides_leader(box) ? 1 : 0);
            price += of_crossing * static_cast<double>(crossed);
            if (price >= least)
                continue;
            least = price;
            best = LabelPlace{.box = box, .leader = std::move(leader)};
        }
    if (best) {
        take(best->box);
        leaders_.push_back(*best->leader);
    }
    return best;
}

} // namespace rastertrace
