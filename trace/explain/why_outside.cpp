// SPDX-License-Identifier: MIT
// What keeps a filled triangle from a pixel. Each fill has its own rule: the trace says by its steps which one it
// was.

#include "why_not.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/formula.h>
#include <rastertrace/trace/tell/sheet.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// What the rules are asked with.
struct Case {
    const Trace& trace;
    const PrimitiveSteps& steps;
    Pixel pixel;
    Vec2 sample;

    /// The primitive in words, and where its corners are, exactly. Not every rule asks, and working it out takes most of
    /// the time.
    const PrimitiveText& primitive() const {
        if (!primitive_)
            primitive_ = primitive_in(trace.step(steps.first));
        return *primitive_;
    }
    const std::optional<std::array<Vec2, 3>>& corners() const {
        if (!corners_)
            corners_ = corners_of(primitive());
        return *corners_;
    }
    mutable std::optional<PrimitiveText> primitive_ = {};
    mutable std::optional<std::optional<std::array<Vec2, 3>>> corners_ = {};
};

WhyNot outside(std::string sentence, const Rational& distance) {
    return {
        .reason = "outside", .sentence = std::move(sentence), .distance = nearest_double(distance)};
}

/// The distance of a point from a line through two others, in pixels, of the double of the area between them.
double distance_from_line(const Rational& area, const Vec2& from, const Vec2& to) {
    const Rational dx = to.x - from.x;
    const Rational dy = to.y - from.y;
    // Scaled, as the squares of coordinates need not fit a double.
    const Rational scale = std::max(abs(dx), abs(dy));
    if (sgn(scale) == 0)
        return 0;
    return std::abs(nearest_double(area / scale)) /
           std::hypot(nearest_double(dx / scale), nearest_double(dy / scale));
}

/// An edge that clipping has made has both ends on its plane, named after the primitive: wing:1, wing:2.
std::string made_by_clipping(const std::string& edge) {
    const std::size_t colon = edge.find(':');
    return colon != std::string::npos && edge.find(':', colon + 1) != std::string::npos
               ? said(", which clipping has made,")
               : "";
}

/// `top-left`: the edge that has the sample farthest outside.
std::optional<WhyNot> by_edge_function(const Case& c) {
    std::optional<WhyNot> farthest;
    for (std::size_t n = c.steps.first; n <= c.steps.last; ++n) {
        if (c.trace.kind_of(n) != StepKind::edge)
            continue;
        const auto told = c.trace.step(n).as<EdgeStep>();
        const auto function =
            told.a ? edge_function_in(c.trace, told, c.primitive()) : std::nullopt;
        const Rational value = function ? function->value_at(c.sample) : Rational(1);
        if (sgn(value) > 0 || (sgn(value) == 0 && function->is_top_left))
            continue;
        const double distance = distance_from_line(value, {0, 0}, {function->a, function->b});
        if (farthest && *farthest->distance >= distance)
            continue;
        const std::string edge = told.edge.text();
        farthest =
            WhyNot{.reason = "outside",
                   .sentence = sgn(value) == 0
                                   ? said("E of {} at {} = {}: it is no {} or left edge{}", edge,
                                          text(c.sample), function->at(c.sample),
                                          has_bottom_rule(c.trace) ? said("bottom") : said("top"),
                                          by_convention(c.trace))
                                   : said("E of {}{} at {} = {}, {} px beyond it", edge,
                                          made_by_clipping(edge), text(c.sample),
                                          function->at(c.sample), six_places(distance)),
                   .distance = distance};
    }
    return farthest;
}

/// The end of a row that a pixel lies beyond.
WhyNot beyond_end(const Case& c, std::size_t n, bool is_left) {
    const EndOfRow told = ends_of(c.trace.step(n).as<ScanlineStep>())[is_left ? 0 : 1];
    const auto end = told.x.exact();
    const Rational gap = !end      ? Rational(0)
                         : is_left ? Rational(*end - c.sample.x)
                                   : Rational(c.sample.x - *end);
    const std::string side = is_left ? said("before") : said("beyond");
    const std::string where =
        !end            ? said("lies {} that pixel", side)
        : sgn(gap) > 0  ? said("lies {} it by {}", side, text(gap))
        : sgn(gap) == 0 ? said("lies on it, and the rule leaves it out{}", by_convention(c.trace))
                        : said("lies {} within it, and the rule leaves it out", text(abs(gap)));
    const std::string edge = told.edge.text();
    const std::string name = !edge.empty() ? edge
                             : is_left     ? said("left end##subject")
                                           : said("right end##subject");
    WhyNot why = outside(
        said("{}{} {} row y={} at x = {}{} -> {}; x = {} {}", name, made_by_clipping(edge),
             is_left ? said("begins") : said("ends"), told.y, in_sentence(told.x.text()),
             rule_of_end(c.trace, told, c.primitive().kind), told.pixel, text(c.sample.x), where) +
            what_numbers_give(c.trace, n),
        gap);
    for (const std::string& line : c.steps.working)
        if (line.starts_with(told.name() + " "))
            why.working.push_back(line);
    return why;
}

/// What the crossings of a polygon's row say of the pixel: `; the winding number there is -2`.
std::string winding_there(const Case& c) {
    for (std::size_t n = c.steps.first; n <= c.steps.last; ++n) {
        if (c.trace.kind_of(n) != StepKind::crossings)
            continue;
        const auto row = c.trace.step(n).as<CrossingsStep>();
        if (row.y != c.pixel.y)
            continue;
        const auto x = row.x.values();
        const auto winding = row.winding.texts();
        std::string there = "0";
        for (std::size_t i = 0; i < std::min(x.size(), winding.size()); ++i)
            if (const auto at = x[i].exact(); at && *at <= c.sample.x)
                there = winding[i];
        return said("; the winding number there is {}", there);
    }
    return {};
}

/// The row of the pixel, if the primitive has one there: of a polygon's spans, the one that ends nearest to it.
std::optional<WhyNot> by_row(const Case& c) {
    std::size_t nearest = 0;
    Index least = 0;
    bool is_before = false;
    for (std::size_t n = c.steps.first; n <= c.steps.last; ++n) {
        if (c.trace.kind_of(n) != StepKind::scanline)
            continue;
        const StepView step = c.trace.step(n);
        if (y_in(step) != c.pixel.y) // read without decoding the whole row
            continue;
        const auto row = step.as<ScanlineStep>();
        const Index gap = std::max(row.from - c.pixel.x, c.pixel.x - row.to);
        if (gap <= 0)
            return WhyNot{.reason = "unknown",
                          .sentence = said("row y={} has the pixels {} to {}, but no step of the "
                                           "trace says what became of this one",
                                           c.pixel.y, row.from, row.to)};
        if (nearest != 0 && gap >= least)
            continue;
        nearest = n;
        least = gap;
        is_before = c.pixel.x < row.from;
    }
    if (nearest == 0)
        return std::nullopt;
    WhyNot why = beyond_end(c, nearest, is_before);
    why.sentence += winding_there(c);
    return why;
}

/// The corner that lies highest in the picture, or lowest.
std::size_t outermost_corner(const Case& c, bool is_top) {
    const auto& corners = *c.corners();
    const bool wants_largest = (c.trace.canvas.down() < 0) == is_top;
    std::size_t best = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (wants_largest ? corners[i].y > corners[best].y : corners[i].y < corners[best].y)
            best = i;
    return best;
}

/// A row that the triangle does not reach.
std::optional<WhyNot> by_rows(const Case& c) {
    const Canvas& canvas = c.trace.canvas;
    std::optional<Index> top, bottom;
    for (std::size_t n = c.steps.first; n <= c.steps.last; ++n) {
        if (c.trace.kind_of(n) != StepKind::scanline)
            continue;
        const Index y = y_in(c.trace.step(n)).value_or(0);
        if (!top || canvas.row_of(y) < canvas.row_of(*top))
            top = y;
        if (!bottom || canvas.row_of(y) > canvas.row_of(*bottom))
            bottom = y;
    }
    if (!top)
        return std::nullopt;
    const bool is_above = canvas.row_of(c.pixel.y) < canvas.row_of(*top);
    const bool is_below = canvas.row_of(c.pixel.y) > canvas.row_of(*bottom);
    const std::string rows = *top == *bottom ? said("its only row, y={}", *top)
                                             : said("its rows, y={} to {}", *top, *bottom);
    if (!is_above && !is_below)
        return WhyNot{.reason = "unknown",
                      .sentence = said("row y={} is missing among {}", c.pixel.y, rows)};
    if (!c.steps.may_lack.empty())
        return not_told(c.steps, said("the trace does not have row y={} of it", c.pixel.y));
    const std::string lies =
        said("row y={} lies {} {}", c.pixel.y, is_above ? said("above") : said("below"), rows);
    const auto& corners = c.corners();
    if (!corners)
        return WhyNot{.reason = "outside", .sentence = lies};
    const std::size_t corner = outermost_corner(c, is_above);
    const Rational distance = abs(c.sample.y - (*corners)[corner].y);
    const bool is_left_out =
        is_below && sgn(distance) == 0 && c.trace.method.triangles.rows == RowRule::half_open;
    const std::string left_out =
        is_left_out ? said(", and half-open rows leave out the lowest{}", by_convention(c.trace))
                    : "";
    return outside(said("{}: its {} corner, {}, is at y = {}{}", lies,
                        is_above ? said("highest") : said("lowest"), c.primitive().vertices[corner],
                        in_sentence(c.primitive().positions[corner][1]), left_out),
                   distance);
}

/// AB, or A1-B1: the side across from a corner.
std::string side_across(const PrimitiveText& primitive, std::size_t corner) {
    return edge_name(primitive, (corner + 1) % 3, (corner + 2) % 3);
}

/// `barycentric`: the corner of the most negative weight.
std::optional<WhyNot> by_weight(const Case& c) {
    for (std::size_t n = c.steps.first; n <= c.steps.last; ++n) {
        if (c.trace.kind_of(n) != StepKind::sample)
            continue;
        const auto tested = c.trace.step(n).as<SampleStep>();
        if (tested.x != c.pixel.x || tested.y != c.pixel.y || tested.inside.is_true())
            continue;
        const auto weights = tested.weights.values();
        std::optional<std::size_t> worst;
        for (std::size_t i = 0; i < weights.size() && i < 3; ++i) {
            const auto weight = weights[i].exact();
            if (weight && sgn(*weight) < 0 && (!worst || *weight < *weights[*worst].exact()))
                worst = i;
        }
        const auto& corners = c.corners();
        if (!worst || !corners)
            return WhyNot{.reason = "outside", .sentence = said("its sample lies outside")};
        const auto& from = (*corners)[(*worst + 1) % 3];
        const auto& to = (*corners)[(*worst + 2) % 3];
        const double distance = distance_from_line(doubled_area(from, to, c.sample), from, to);
        return WhyNot{.reason = "outside",
                      .sentence = said("at {} the weight of {} is {} < 0: beyond {}, by {} px",
                                       text(c.sample), c.primitive().vertices[*worst],
                                       in_sentence(weights[*worst].text()),
                                       side_across(c.primitive(), *worst), six_places(distance)),
                      .distance = distance,
                      .working = c.steps.working};
    }
    return std::nullopt;
}

/// How far a number lies outside of a range; 0 within it.
Rational beyond(const Rational& number, const Rational& low, const Rational& high) {
    return std::max({Rational(0), Rational(low - number), Rational(number - high)});
}

/// `barycentric`: the box around the triangle, beyond which no sample is tested.
std::optional<WhyNot> by_box(const Case& c) {
    if (c.trace.method.triangles.fill != Fill::barycentric || !c.corners())
        return std::nullopt;
    const auto& corners = c.corners();
    const auto& [p, q, r] = *corners;
    const auto [left, right] = std::minmax({p.x, q.x, r.x});
    const auto [low, high] = std::minmax({p.y, q.y, r.y});
    const Rational dx = beyond(c.sample.x, left, right);
    const Rational dy = beyond(c.sample.y, low, high);
    if (sgn(dx) == 0 && sgn(dy) == 0)
        return std::nullopt;
    return outside(said("{} lies beyond the box around it, x {} to {}, y {} to {}, by {}",
                        text(c.sample), text(left), text(right), text(low), text(high),
                        text(std::max(dx, dy))),
                   std::max(dx, dy));
}

/// Lines from one side to the corner across: `fan`.
bool is_fan(const Case& c) {
    const auto edge = find_step(c.trace, c.steps, StepKind::edge);
    return c.trace.method.triangles.fill == Fill::fan || (edge && edge->as<EdgeStep>().octant);
}

/// No rule can be told: which steps would say more?
WhyNot unknown(const Case& c) {
    std::vector<std::string> lacking;
    for (const StepKind kind : {StepKind::edge, StepKind::scanline, StepKind::sample})
        if (c.trace.lacks(kind))
            lacking.emplace_back(name_of(kind));
    const std::string none = said("no step of the trace says why");
    if (lacking.empty() && !c.steps.may_lack.empty())
        return not_told(c.steps, none);
    return {.reason = "unknown",
            .sentence = lacking.empty() ? none
                                        : said("the trace has no {} steps, which would say why",
                                               joined(lacking, ", "))};
}

} // namespace

WhyNot why_outside(const Trace& trace, const PrimitiveSteps& steps, Pixel pixel) {
    const PrimitiveStep& told = steps.told;
    if (told.painted.is_false())
        return {.reason = "unpainted", .sentence = said("it only hides what lies behind it")};
    const auto& offset = steps.samples->of(told.kind);
    const Case c{trace, steps, pixel, {offset.x_of(pixel.x), offset.y_of(pixel.y)}};
    for (const auto rule : {by_edge_function, by_row, by_weight, by_rows, by_box})
        if (auto why = rule(c))
            return *std::move(why);
    if (is_fan(c) && !trace.lacks(StepKind::pixel) && steps.may_lack.empty())
        return {.reason = "outside",
                .sentence = said("no line of the fan passes through the pixel")};
    return unknown(c);
}

} // namespace rastertrace
