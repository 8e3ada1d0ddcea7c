// SPDX-License-Identifier: MIT
// Two triangles and the edge that they share: which of them has each pixel along it, and why.

#include "explanation.h"
#include "step_text.h"

#include <rastertrace/core/scene/stages.h>
#include <rastertrace/trace/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>

namespace rastertrace {

namespace {

/// The two triangles, and the ends of their edge.
struct Pair {
    std::array<std::string, 2> names;
    std::string edge; ///< as the first of them names its vertices
    Vec2 from;
    Vec2 to;
};

[[noreturn]] void refuse(const std::string& expected, const std::string& found,
                         std::string hint = {}) {
    throw problem_of("", fmt::format("--pair: expected {}, found \"{}\"", expected, found),
                     std::move(hint));
}

/// The triangle of a name, as its `primitive` step says.
PrimitiveText triangle_named(const Trace& trace, const std::string& name) {
    std::vector<std::string> known, parts;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        if (trace.kind_of(n) != StepKind::primitive)
            continue;
        PrimitiveText primitive = primitive_in(trace.step(n));
        if (primitive.name == name && corners_of(primitive))
            return primitive;
        if (corners_of(primitive))
            known.push_back(primitive.name);
        if (is_part_of(trace.step(n), name))
            parts.push_back(primitive.name);
    }
    if (!parts.empty())
        refuse("the name of a triangle that is drawn", name,
               fmt::format("{} was clipped: ask of its parts, {}", name, joined(parts, ", ")));
    refuse("the name of a triangle that is drawn", name,
           did_you_mean(name, std::vector<std::string_view>(known.begin(), known.end())));
}

/// The two names that a text joins by a comma. A name may have commas too: the split is where both are known.
std::vector<std::string> names_in(const Trace& trace, const std::string& text) {
    std::set<std::string> known;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (trace.kind_of(n) == StepKind::primitive)
            known.insert(trace.step(n).text("name"));
    for (std::size_t comma = text.find(','); comma != std::string::npos;
         comma = text.find(',', comma + 1))
        if (known.contains(text.substr(0, comma)) && known.contains(text.substr(comma + 1)))
            return {text.substr(0, comma), text.substr(comma + 1)};
    return split_at(text, ',');
}

Pair pair_named(const Trace& trace, const std::string& text) {
    const auto names = names_in(trace, text);
    if (names.size() != 2 || names[0] == names[1])
        refuse("two triangles, like ABC,ACD", text);
    const PrimitiveText one = triangle_named(trace, names[0]);
    const PrimitiveText other = triangle_named(trace, names[1]);
    const auto corners = *corners_of(one);
    const auto others = *corners_of(other);
    std::vector<std::size_t> shared;
    for (std::size_t i = 0; i < 3; ++i)
        if (std::any_of(others.begin(), others.end(), [&](const Vec2& corner) {
                return corner.x == corners[i].x && corner.y == corners[i].y;
            }))
            shared.push_back(i);
    if (shared.size() != 2)
        refuse("two triangles that share an edge", text,
               fmt::format("they have {} in common", counted(shared.size(), "corner")));
    return {{names[0], names[1]},
            edge_name(one, shared[0], shared[1]),
            corners[shared[0]],
            corners[shared[1]]};
}

/// Pixels whose sample lies at most one pixel from an edge, up or down where it is flatter than 45 degrees (or just
/// that), to the left or right where it is steeper; within the edge's length.
class NearEdge {
public:
    NearEdge(const Pair& pair, const Trace& trace)
        : pair_(pair), canvas_(trace.canvas), offset_(sample_offset(trace)),
          is_flat_(abs(pair.to.x - pair.from.x) >= abs(pair.to.y - pair.from.y)) {}

    bool has(Index x, Index y) const {
        const Rational px = Rational(static_cast<long>(x)) + offset_;
        const Rational py = Rational(static_cast<long>(y)) + offset_;
        const auto& [a, b] = std::pair(pair_.from, pair_.to);
        const Rational along = is_flat_ ? px : py;
        const Rational begin = is_flat_ ? a.x : a.y;
        const Rational end = is_flat_ ? b.x : b.y;
        if (begin == end || along < std::min(begin, end) || along > std::max(begin, end))
            return false;
        const Rational share = (along - begin) / (end - begin);
        const Rational across = is_flat_ ? a.y + share * (b.y - a.y) : a.x + share * (b.x - a.x);
        return abs((is_flat_ ? py : px) - across) <= 1;
    }

    /// All that the canvas has, from the top row, left to right.
    std::vector<Pixel> pixels() const {
        std::vector<Pixel> pixels;
        for (int row = 0; row < canvas_.height; ++row)
            for (int x = canvas_.left(); x <= canvas_.right(); ++x)
                if (const int y = canvas_.y_of(row); has(x, y))
                    pixels.push_back({x, y});
        return pixels;
    }

private:
    const Pair& pair_;
    Canvas canvas_;
    Rational offset_;
    bool is_flat_;
};

/// The steps of the two triangles, of pixels only those near the edge, and where the next primitive begins.
Trace excerpt_of(const Trace& trace, const Pair& pair, const NearEdge& near) {
    Trace excerpt = trace.without_steps();
    excerpt.damage = trace.damage;
    bool is_of_pair = false;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        const StepView step = trace.step(n);
        const bool ends_pair = is_of_pair && kind == StepKind::primitive;
        if (kind == StepKind::primitive)
            is_of_pair = std::find(pair.names.begin(), pair.names.end(), step.text("name")) !=
                         pair.names.end();
        const bool is_fragment =
            kind == StepKind::pixel || kind == StepKind::depth || kind == StepKind::sample;
        const auto x = step.whole("x");
        const auto y = step.whole("y");
        if ((is_of_pair || ends_pair) && kind && (!is_fragment || (x && y && near.has(*x, *y))))
            excerpt.add_to_excerpt(step, kind, trace.number_of(n));
    }
    return excerpt;
}

/// Who has a pixel, and how each of the two came to have it or not.
PixelAlongEdge pixel_of(const Trace& excerpt, const Pair& pair, Pixel pixel) {
    const Explanation story = explain_pixel(excerpt, pixel);
    PixelAlongEdge found{.pixel = pixel};
    for (const std::string& name : pair.names) {
        const auto why_not =
            std::find_if(story.why_not.begin(), story.why_not.end(),
                         [&name](const WhyNot& one) { return one.primitive == name; });
        if (why_not == story.why_not.end()) {
            found.owners.push_back(name);
            found.why.push_back(fmt::format("{} has it", name));
            continue;
        }
        if (why_not->reason == "hidden")
            found.owners.push_back(name);
        if (why_not->reason == "unknown")
            found.is_told = false;
        found.why.push_back(fmt::format("{}: {}", name, why_not->sentence));
    }
    return found;
}

} // namespace

Explanation explain_pair(const Trace& trace, const std::string& names) {
    const Pair pair = pair_named(trace, names);
    const NearEdge near(pair, trace);
    const Trace excerpt = excerpt_of(trace, pair, near);
    Explanation explanation;
    std::array<std::size_t, 2> only{};
    std::size_t both = 0, none = 0, untold = 0;
    for (const Pixel& pixel : near.pixels()) {
        explanation.pixels.push_back(pixel_of(excerpt, pair, pixel));
        const auto& owners = explanation.pixels.back().owners;
        if (!explanation.pixels.back().is_told)
            ++untold;
        else if (owners.size() == 2)
            ++both;
        else if (owners.empty())
            ++none;
        else
            ++only[owners.front() == pair.names[0] ? 0 : 1];
    }
    explanation.answer =
        printable(fmt::format("edge {}: {} along it, {} of {}, {} of {}, {} of both, {} of neither",
                              pair.edge, counted(explanation.pixels.size(), "pixel"), only[0],
                              pair.names[0], only[1], pair.names[1], both, none));
    if (untold > 0)
        explanation.answer += fmt::format(", {} not told", untold);
    explanation.lacks = what_lacks(trace, {StepKind::primitive, StepKind::pixel, StepKind::depth});
    return explanation;
}

} // namespace rastertrace
