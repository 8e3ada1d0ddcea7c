// SPDX-License-Identifier: MIT
// Where a point, a line, a circle, or the sides of an outline are, if not in a pixel.

#include "why_not.h"

#include <rastertrace/core/raster/line.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// A line, or a side: the steps that draw it.
struct LineSteps {
    std::string name;
    std::size_t first;
    std::size_t last;
    std::optional<LineEnds> ends;
    bool is_x_major;
};

/// Where a line is, and how far from the pixel.
struct PlaceOnLine {
    std::string text;
    std::optional<Rational> distance = {};
    bool is_known = true; ///< false: it may be in the pixel, as far as the trace goes
};

bool is_x_major_line(std::optional<Index> octant, const std::optional<LineEnds>& ends) {
    if (const auto told = is_x_major_octant(octant))
        return *told;
    return ends && abs(ends->to.x - ends->from.x) >= abs(ends->to.y - ends->from.y);
}

/// The line itself, or the sides of an outline that the trace tells.
std::vector<LineSteps> lines_of(const Trace& trace, const PrimitiveSteps& steps) {
    const StepView step = trace.step(steps.first);
    const PrimitiveText primitive = primitive_in(step);
    const auto ends_at = [](const EdgeEnds& ends) -> std::optional<LineEnds> {
        const auto from = vec2_in(ends.from);
        const auto to = vec2_in(ends.to);
        return from && to ? std::optional(LineEnds{*from, *to}) : std::nullopt;
    };
    std::vector<LineSteps> lines;
    if (primitive.kind == "line") {
        const auto ends = primitive.positions.size() == 2
                              ? ends_at({primitive.positions[0], primitive.positions[1], {0, 1}})
                              : std::nullopt;
        return {{said("the line"), steps.first, steps.last, ends,
                 is_x_major_line(step.as<PrimitiveStep>().octant, ends)}};
    }
    for (std::size_t n = steps.first; n <= steps.last; ++n) {
        if (trace.kind_of(n) != StepKind::edge)
            continue;
        if (!lines.empty())
            lines.back().last = n - 1;
        const auto edge = trace.step(n).as<EdgeStep>();
        const auto found = ends_of_edge(primitive, edge.edge.text());
        const auto ends = found ? ends_at(*found) : std::nullopt;
        lines.push_back(
            {edge.edge.text(), n, steps.last, ends, is_x_major_line(edge.octant, ends)});
    }
    return lines;
}

/// The pixel with the nearest sample, a half up, as the ends of lines are rounded.
Pixel pixel_at(const Vec2& point, const SampleOffset<Rational>& offset) {
    const auto [x, y] = nearest_pixel<Rational>({point.x, point.y}, offset);
    return {static_cast<int>(x), static_cast<int>(y)};
}

/// The line has no pixel in the column, or the row: it ends before, or there its last pixel is left out.
PlaceOnLine beyond_ends(const Trace& trace, const LineSteps& line, Pixel pixel) {
    if (!line.ends)
        return {.text = said("no step says where {} is", line.name), .is_known = false};
    const auto& [from, to] = *line.ends;
    const auto offset = told_samples(trace).lines;
    const Rational at = line.is_x_major ? offset.x_of(pixel.x) : offset.y_of(pixel.y);
    const auto [low, high] =
        std::minmax(line.is_x_major ? from.x : from.y, line.is_x_major ? to.x : to.y);
    const std::string_view axis = line.is_x_major ? "x" : "y";
    const std::string goes =
        said("{} goes from {} = {} to {}", line.name, axis, text(low), text(high));
    const Rational gap = at < low ? Rational(low - at) : Rational(at - high);
    if (sgn(gap) > 0)
        return {said("{}: {} = {} lies beyond it, by {}", goes, axis, text(at), text(gap)), gap};
    if (trace.method.others.line == LineMethod::diamond_exit)
        return {said("{}, and does not leave the diamond of a pixel at {} = {}{}", goes, axis,
                     text(at), by_convention(trace)),
                Rational(0)};
    if (trace.method.others.ends == EndPixels::first)
        for (const Pixel& end : {pixel_at(to, offset), pixel_at(from, offset)})
            if ((line.is_x_major ? end.x : end.y) == (line.is_x_major ? pixel.x : pixel.y))
                return {said("the last pixel of {}, ({}, {}), is left out (ends: first)", line.name,
                             end.x, end.y),
                        Rational(std::abs(line.is_x_major ? end.y - pixel.y : end.x - pixel.x))};
    return {.text =
                said("{}; no step of the trace says where it is at {} = {}", goes, axis, text(at)),
            .is_known = false};
}

/// What led to a pixel of a line: `9/7 -> 1`, or the pixel alone.
std::string place_in(const Trace& trace, const LineSteps& line, std::size_t n, Index at) {
    for (std::size_t before = n; before > line.first; --before)
        if (trace.kind_of(before) == StepKind::along)
            return fmt::format("{} -> {}",
                               in_sentence(trace.step(before).as<AlongStep>().value.text()), at);
    return fmt::format("{}", at);
}

/// True if the pixels that are dropped reach a column, or a row.
bool reaches(const RejectStep& dropped, bool is_column, Index wanted) {
    const auto from = is_column ? dropped.x : dropped.y;
    const auto to = is_column ? dropped.to_x : dropped.to_y;
    return from && std::min(*from, to.value_or(*from)) <= wanted &&
           wanted <= std::max(*from, to.value_or(*from));
}

/// Where the line is in the pixel's column, or row.
PlaceOnLine place_of(const Trace& trace, const LineSteps& line, Pixel pixel) {
    const std::string_view major = line.is_x_major ? "x" : "y";
    const std::string_view minor = line.is_x_major ? "y" : "x";
    const auto major_in = line.is_x_major ? x_in : y_in;
    const auto minor_in = line.is_x_major ? y_in : x_in;
    const Index wanted = line.is_x_major ? pixel.x : pixel.y;
    const Index asked = line.is_x_major ? pixel.y : pixel.x;
    const std::string where =
        said("in {} {} = {}", line.is_x_major ? said("column") : said("row"), major, wanted);
    for (std::size_t n = line.first; n <= line.last; ++n) {
        const auto kind = trace.kind_of(n);
        const StepView step = trace.step(n);
        const bool is_fragment = kind == StepKind::pixel || kind == StepKind::depth;
        if (is_fragment && major_in(step) == wanted) {
            const Index at = minor_in(step).value_or(0);
            return {said("{} {} is at {} = {}, not {}", where, line.name, minor,
                         place_in(trace, line, n, at), asked),
                    Rational(std::abs(at - asked))};
        }
        if (kind == StepKind::reject && reaches(step.as<RejectStep>(), line.is_x_major, wanted))
            return {said("{} {} is off the canvas", where, line.name)};
    }
    return beyond_ends(trace, line, pixel);
}

std::string no_step_says_what_became_of_it() {
    return said("no step of the trace says what became of it");
}

std::string no_step_says_where_it_is() {
    return said("no step of the trace says where it is");
}

WhyNot of_point(const Trace& trace, const PrimitiveSteps& steps, Pixel pixel) {
    const PrimitiveText primitive = primitive_in(trace.step(steps.first));
    const auto place =
        primitive.positions.empty() ? std::nullopt : vec2_in(primitive.positions.front());
    const bool is_in_pixel = place && pixel_at(*place, told_samples(trace).others) == pixel;
    if (!place || is_in_pixel)
        return {.reason = "unknown", .sentence = no_step_says_what_became_of_it()};
    const auto drawn = find_step(trace, steps, StepKind::pixel);
    const std::string at = said("it is at ({}, {})", in_sentence(primitive.positions[0][0]),
                                in_sentence(primitive.positions[0][1]));
    if (!drawn)
        return {.reason = "elsewhere", .sentence = at};
    const auto [x, y, color] = drawn->as<PixelStep>();
    return {.reason = "elsewhere", .sentence = fmt::format("{}: pixel ({}, {})", at, x, y)};
}

/// The pixels of a circle are nearer to it, in their row or column, than those inside and outside: of the
/// distances a <= b from the center, (b - 1/2)^2 + a^2 < r^2 < (b + 1/2)^2 + a^2.
WhyNot of_circle(const Trace& trace, const PrimitiveSteps& steps, Pixel pixel) {
    const PrimitiveText primitive = primitive_in(trace.step(steps.first));
    const auto center = center_of(primitive, trace);
    if (!center || !primitive.radius)
        return {.reason = "unknown", .sentence = no_step_says_where_it_is()};
    const auto [a, b] =
        std::minmax({Rational(abs(pixel.x - center->x)), Rational(abs(pixel.y - center->y))});
    const Rational r = *primitive.radius;
    const Rational square = a * a + b * b;
    const bool is_inside = square + b < r * r;
    const bool is_outside = square - b >= r * r && sgn(b) > 0;
    if (!is_inside && !is_outside)
        return {.reason = "unknown", .sentence = no_step_says_what_became_of_it()};
    return {.reason = "elsewhere",
            .sentence =
                said("it lies {} from ({}, {}), and the square of the pixel's distance is {}: {}",
                     text(r), text(center->x), text(center->y), text(square),
                     is_inside ? said("inside") : said("outside")),
            .distance = std::abs(std::sqrt(nearest_double(square)) - nearest_double(r))};
}

} // namespace

WhyNot why_elsewhere(const Trace& trace, const PrimitiveSteps& steps, Pixel pixel) {
    const auto kind = steps.told.kind;
    if (kind == PrimitiveKind::point)
        return of_point(trace, steps, pixel);
    if (kind == PrimitiveKind::circle)
        return of_circle(trace, steps, pixel);
    if (trace.lacks(StepKind::pixel))
        return {.reason = "unknown",
                .sentence = said("the trace has no pixel steps, which would say where it is")};
    WhyNot why{.reason = "elsewhere"};
    bool is_known = true;
    std::vector<std::string> places;
    for (const LineSteps& line : lines_of(trace, steps)) {
        const PlaceOnLine place = place_of(trace, line, pixel);
        places.push_back(place.text);
        is_known = is_known && place.is_known;
        if (place.distance)
            why.distance = std::min(why.distance.value_or(nearest_double(*place.distance)),
                                    nearest_double(*place.distance));
    }
    why.sentence = places.empty() ? no_step_says_where_it_is() : joined(places, "; ");
    // Of an outline, sides that the trace does not have may be in the pixel.
    const bool may_lack_sides = !steps.may_lack.empty() && kind != PrimitiveKind::line;
    if (is_known && !places.empty() && !may_lack_sides)
        return why;
    return steps.may_lack.empty() ? WhyNot{.reason = "unknown", .sentence = why.sentence}
                                  : not_told(steps, why.sentence);
}

} // namespace rastertrace
