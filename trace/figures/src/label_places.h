// SPDX-License-Identifier: MIT
#pragma once

// Places for labels, so that none covers a mark or another label: beside its mark if there is room, else as near
// as there is, with a line that leads to it.
//
//     LabelPlaces places(area);
//     places.take(box_around(mark, 4));
//     places.find_beside({.mark = mark, .away = 6, .width = 30, .height = 10});
//
// Or, among lines that may be crossed if there is no other way: words_beside().

#include <rastertrace/figures/drawing.h>

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The square that has a circle.
Rectangle box_around(Place center, double radius);

/// Where the letters of a label are anchored that stands in a box: at the side of its mark, for the box may be wider
/// than they are.
struct LabelAnchor {
    double x;
    Anchor anchor;
};
LabelAnchor anchor_beside(Place mark, const Rectangle& box);

/// A label that looks for its place.
struct LabelWish {
    Place mark;
    double away = 0; ///< from the mark's center: so far it reaches
    double width = 0;
    double height = 0;
};

/// Where it stands.
struct LabelPlace {
    Rectangle box;
    std::optional<Path> leader = {}; ///< from the mark, if it does not stand beside it
};

/// Words that look for their place beside a mark.
struct WordsWish {
    Place mark;
    Place inside; ///< the middle of what the mark is a corner of: they rather stand away from it
    std::string_view words;
    double size = 10; ///< of bold letters
};

/// What words keep away from.
struct Obstacles {
    Rectangle sheet;                   ///< what is outside is cut off: they stay within it
    Rectangle frame;                   ///< they rather stay within it, too
    std::vector<Path> sides = {};      ///< rather not on these lines of two places
    std::vector<Rectangle> words = {}; ///< not on other words
};

/// The best box for words, of eight around their mark. `nullopt` if each has other words below it, or does not fit on
/// the sheet.
std::optional<Rectangle> words_beside(const WordsWish& wish, const Obstacles& obstacles);

/// Words in their box, beside the mark that they belong to.
Label strong_label_in(const Rectangle& box, const WordsWish& wish);

class LabelPlaces {
public:
    /// Labels stand in `area`, and rather not across the line at x = `border`.
    LabelPlaces(const Rectangle& area, double border) : area_(area), border_(border) {}

    /// No label covers this.
    void take(const Rectangle& box) { taken_.push_back(box); }

    /// A place beside the mark, which is then taken. `nullopt` if there is none.
    std::optional<LabelPlace> find_beside(const LabelWish& wish);

    /// The nearest place that there is, which is then taken. A line leads to it, and crosses as little as
    /// can be had: marks, labels, other such lines. `nullopt` if the area is full.
    std::optional<LabelPlace> find_anywhere(const LabelWish& wish);

private:
    bool is_free(const Rectangle& box) const;
    bool crosses_border(const Rectangle& box) const {
        return box.left() < border_ && border_ < box.right();
    }
    /// How many marks, labels and other leaders a leader from a mark crosses.
    std::size_t crossings(const Path& leader, Place mark) const;
    /// True if a leader to another label passes through a box: it must stay in sight.
    bool hides_leader(const Rectangle& box) const;

    Rectangle area_;
    double border_;
    std::vector<Rectangle> taken_;
    std::vector<Path> leaders_;
};

} // namespace rastertrace
