// SPDX-License-Identifier: MIT
// Two triangles and the edge that they share: which of them has each pixel along it, and why.

#include "explanation.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>

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
    std::vector<std::string> parts;
    for (const std::size_t n : trace.steps_of({StepKind::primitive})) {
        PrimitiveText primitive = primitive_in(trace.step(n));
        if (primitive.name == name && corners_of(primitive))
            return primitive;
        if (is_part_of(trace.step(n).as<PrimitiveStep>(), name))
            parts.push_back(primitive.name);
    }
    if (!parts.empty())
        refuse("the name of a triangle that is drawn", name,
               fmt::format("{} was clipped: ask of its parts, {}", name, joined(parts, ", ")));
    refuse_name(trace, Topic::pair, name);
}

/// The two names that a text joins by a comma. A name may have commas too: the split is where both are known.
std::vector<std::string> names_in(const Trace& trace, const std::string& text) {
    std::set<std::string> known;
    for (const std::size_t n : trace.steps_of({StepKind::primitive}))
        known.insert(name_in(trace.step(n)).text());
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
        : pair_(pair), canvas_(trace.canvas), offset_(told_samples(trace).triangles),
          is_flat_(abs(pair.to.x - pair.from.x) >= abs(pair.to.y - pair.from.y)),
          begin_(is_flat_ ? canvas_.left() : std::min(canvas_.top(), canvas_.bottom())) {
        const int size = is_flat_ ? canvas_.width : canvas_.height;
        for (int along = begin_; along < begin_ + size; ++along) {
            const auto across = across_at(along);
            near_.push_back(across ? Range{ceil_index(Rational(*across - 1)),
                                           floor_index(Rational(*across + 1))}
                                   : Range{});
        }
    }

    bool has(Index x, Index y) const {
        const Index along = is_flat_ ? x : y;
        const Index across = is_flat_ ? y : x;
        if (!canvas_.contains(x, y))
            return false;
        const Range& near = near_[static_cast<std::size_t>(along - begin_)];
        return near.first <= across && across <= near.last;
    }

    /// All that the canvas has, from the top row, left to right.
    std::vector<Pixel> pixels() const {
        std::vector<Pixel> pixels;
        for (std::size_t i = 0; i < near_.size(); ++i)
            for (Index across = near_[i].first; across <= near_[i].last; ++across) {
                const Index along = begin_ + static_cast<Index>(i);
                const Index x = is_flat_ ? along : across;
                const Index y = is_flat_ ? across : along;
                if (canvas_.contains(x, y))
                    pixels.push_back({static_cast<int>(x), static_cast<int>(y)});
            }
        std::sort(pixels.begin(), pixels.end(), [this](const Pixel& one, const Pixel& other) {
            return std::pair(canvas_.row_of(one.y), one.x) <
                   std::pair(canvas_.row_of(other.y), other.x);
        });
        return pixels;
    }

private:
    Rational sample(Index along) const {
        return is_flat_ ? offset_.x_of(along) : offset_.y_of(along);
    }

    /// Where the edge is, in rows, at the samples of a column (of a row: in columns), if it gets there.
    std::optional<Rational> across_at(Index column_or_row) const {
        const Vec2& a = pair_.from;
        const Vec2& b = pair_.to;
        const Rational along = sample(column_or_row);
        const Lerp across = lerp_on({a, b}, is_flat_, along);
        if (!across.slope() || along < std::min(across.i1, across.i2) ||
            along > std::max(across.i1, across.i2))
            return std::nullopt;
        return is_flat_ ? offset_.in_rows(across.value()) : offset_.in_columns(across.value());
    }

    /// Those of a column, or row, that are near: rows from `first` to `last`, or columns.
    struct Range {
        Index first = 0;
        Index last = -1;
    };

    const Pair& pair_;
    Canvas canvas_;
    SampleOffset<Rational> offset_;
    bool is_flat_;
    int begin_;               ///< the first column of the canvas, or row
    std::vector<Range> near_; ///< of each column, or row, from there
};

/// The steps of the two triangles, and where the next primitive begins. They are sorted by row once, so that each
/// pixel is asked of few of them.
class StepsOfPair {
public:
    StepsOfPair(const Trace& trace, const Pair& pair, const NearEdge& near) : trace_(trace) {
        bool is_of_pair = false;
        for (std::size_t n = 1; n <= trace.size(); ++n) {
            const auto kind = trace.kind_of(n);
            const bool ends_pair = is_of_pair && kind == StepKind::primitive;
            if (kind == StepKind::primitive)
                is_of_pair = std::find(pair.names.begin(), pair.names.end(),
                                       name_in(trace.step(n)).text()) != pair.names.end();
            if ((is_of_pair || ends_pair) && kind)
                take(n, *kind, near);
        }
        close_rows();
    }

    /// The steps that decide about a pixel: those of its row, and what belongs to no row.
    Trace about(Pixel pixel) const {
        std::vector<std::size_t> numbers = always_;
        const auto row = rows_.find(pixel.y);
        if (row != rows_.end())
            numbers.insert(numbers.end(), row->second.begin(), row->second.end());
        std::sort(numbers.begin(), numbers.end());
        numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
        Trace excerpt = trace_.without_steps();
        excerpt.damage = trace_.damage;
        for (const std::size_t n : numbers)
            excerpt.add_to_excerpt(trace_.number_of(n));
        return excerpt;
    }

private:
    void take(std::size_t n, StepKind kind, const NearEdge& near) {
        const StepView step = trace_.step(n);
        switch (kind) {
        case StepKind::scanline:
            rows_[step.as<ScanlineStep>().y].push_back(n);
            if (last_row_ == 0)
                always_.push_back(n);
            last_row_ = n;
            return;
        case StepKind::pixel:
        case StepKind::depth:
        case StepKind::sample: {
            const auto x = x_in(step);
            const auto y = y_in(step);
            if (x && y && near.has(*x, *y))
                rows_[*y].push_back(n);
            return;
        }
        case StepKind::ray:
        case StepKind::along:
        case StepKind::decide:
            return; // the pixels that they lead to say enough
        case StepKind::primitive:
            close_rows();
            break;
        default:
            break;
        }
        always_.push_back(n);
    }

    /// The first and the last row of a triangle say from where to where it goes.
    void close_rows() {
        if (last_row_ != 0)
            always_.push_back(last_row_);
        last_row_ = 0;
    }

    const Trace& trace_;
    std::vector<std::size_t> always_;
    std::unordered_map<Index, std::vector<std::size_t>> rows_; ///< by y
    std::size_t last_row_ = 0;                                 ///< of the current triangle
};

/// Who has a pixel, and how each of the two came to have it or not.
PixelAlongEdge pixel_of(const Trace& excerpt, const Pair& pair, Pixel pixel) {
    const Explanation story = explain_pixel(excerpt, {.pixel = pixel});
    PixelAlongEdge found{.pixel = pixel};
    for (const std::string& name : pair.names) {
        const auto why_not =
            std::find_if(story.why_not.begin(), story.why_not.end(),
                         [&name](const WhyNot& one) { return one.primitive == name; });
        if (why_not == story.why_not.end()) {
            found.owners.push_back(name);
            found.why.push_back(said("{} has it", name));
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
    const StepsOfPair steps(trace, pair, near);
    Explanation explanation;
    std::array<std::size_t, 2> only{};
    std::size_t both = 0, none = 0, untold = 0;
    for (const Pixel& pixel : near.pixels()) {
        explanation.pixels.push_back(pixel_of(steps.about(pixel), pair, pixel));
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
        printable(said("edge {}: {} along it, {} of {}, {} of {}, {} of both, {} of neither",
                       pair.edge, said_count(explanation.pixels.size(), "pixel"), only[0],
                       pair.names[0], only[1], pair.names[1], both, none));
    if (untold > 0)
        explanation.answer += said(", {} not told", untold);
    explanation.lacks = what_lacks(trace, {StepKind::primitive, StepKind::pixel, StepKind::depth});
    return explanation;
}

} // namespace rastertrace
