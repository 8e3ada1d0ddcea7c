// SPDX-License-Identifier: MIT
#include "describe.h"

#include "mistake_text.h"
#include "step_text.h"

#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// What the parts of a sentence are worked out from.
struct Context {
    const Replay& replay;
    StepView step;
    PrimitiveText primitive;

    template <typename Step> Step as() const { return step.as<Step>(); }
};

/// What the step's primitive is called. A trace from before these steps had names, without its primitives, does
/// not say: the number of the step.
std::string name_of_primitive(const Context& context) {
    if (const std::string name = name_in(context.step).text(); !name.empty())
        return name;
    return context.replay.primitive() == 0
               ? said("of step {}", context.replay.trace().number_of(context.replay.step()))
               : context.primitive.name;
}

/// True if the primitive of the current step is cut: steps of kind `clip` follow it. Where the next step is not at hand,
/// the stages tell.
bool is_clipped(const Replay& replay) {
    const Trace& trace = replay.trace();
    const std::size_t n = replay.step();
    const bool has_next = n < trace.size() && !trace.lacks(StepKind::clip) &&
                          trace.number_of(n + 1) == trace.number_of(n) + 1;
    if (has_next)
        return trace.kind_of(n + 1) == StepKind::clip;
    return std::find(trace.stages.begin(), trace.stages.end(), "clip") != trace.stages.end();
}

std::string corners(const Context& context) {
    const PrimitiveText& primitive = context.primitive;
    const auto colors = primitive.colors.texts();
    std::string text;
    for (std::size_t i = 0; i < primitive.vertices.size() && i < primitive.positions.size(); ++i) {
        text += fmt::format("   {} {}", primitive.vertices[i], point(primitive.positions[i]));
        if (i < colors.size())
            text += fmt::format(" {}", colors[i]);
    }
    if (primitive.positions.empty())
        text += is_clipped(context.replay) ? said(": not all of it can be seen, it is clipped")
                                           : said(": the trace does not tell where it is");
    return text;
}

/// The space that a vertex goes on to comes of the one before: by a matrix, or by dividing by w.
std::string place(const Context& context) {
    const Replay& replay = context.replay;
    const auto vertex = context.as<VertexStep>();
    const std::string at = point(vertex.at.texts());
    if (replay.vertex_before() == 0)
        return at;
    const auto before = replay.trace().step(replay.vertex_before()).as<VertexStep>();
    if (before.name != vertex.name)
        return at;
    const auto from = before.at.texts();
    if (vertex.space == Space::canonical && from.size() == 4)
        return fmt::format("{} = {}",
                           quotient(point({from[0], from[1], from[2]}), in_sentence(from[3])), at);
    return said("{}, from {} {}", at, in_language_of_steps(before.space.text()), point(from));
}

std::string farthest_first(const Context& context) {
    const auto order = context.as<OrderStep>();
    const auto names = order.names.texts();
    const auto distances = order.distances.texts();
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += said("{} {} at {}", i == 0 ? "" : ",", names[i],
                     i < distances.size() ? in_sentence(distances[i]) : "?");
    return text;
}

/// A double that is a short fraction with it: `-0.25 = -1/4`.
std::string with_fraction(const std::string& number) {
    constexpr int largest_denominator = 64;
    const auto exact = number.find('.') == std::string::npos ? std::nullopt : number_in(number);
    const bool is_dyadic = exact && exact->get_den() <= largest_denominator &&
                           Rational(nearest_double(*exact)) == *exact;
    return is_dyadic ? fmt::format("{} = {}", number, exact->get_str()) : in_sentence(number);
}

std::string edge_function(const Trace& trace, const EdgeStep& step,
                          const std::optional<EdgeEnds>& ends) {
    const std::string x = ends ? minus(in_formula(ends->from[0])) : "- x1";
    const std::string y = ends ? minus(in_formula(ends->from[1])) : "- y1";
    const std::string rule =
        step.top_left.is_true() && has_bottom_rule(trace)
            ? said("bottom or left: samples where E = 0 belong to the triangle")
        : step.top_left.is_true() ? said("top or left: samples where E = 0 belong to the triangle")
                                  : said("samples where E = 0 do not belong to the triangle");
    return said("edge {}: E(x, y) = {} (x {}) {} (y {}), {}", step.edge.text(),
                in_formula(step.a.text()), x, plus(in_formula(step.b.text())), y, rule);
}

/// The other form of a line that is not vertical: `; y = 4/3 x + 7/3`.
std::string line_form(const EdgeEnds& ends) {
    const auto from = vec2_in(ends.from);
    const auto to = vec2_in(ends.to);
    const auto form = from && to ? slope_form_of({*from, *to}, true) : std::nullopt;
    return form ? fmt::format("; y = {} x {}", text(form->m), plus(text(form->b))) : std::string();
}

std::string edge(const Context& context) {
    const auto step = context.as<EdgeStep>();
    const std::string name = step.edge.text();
    if (step.octant)
        return said("side {}: octant {}", name, *step.octant);
    const auto ends = ends_of_edge(context.primitive, name);
    if (step.a)
        return edge_function(context.replay.trace(), step, ends);
    const std::string slope = step.dx_dy.text();
    if (slope == "null")
        return said("edge {}: horizontal, it has no dx/dy", name);
    if (!ends)
        return said("edge {}: dx/dy = {}", name, with_fraction(slope));
    const std::string x1 = in_formula(ends->from[0]);
    const std::string y1 = in_formula(ends->from[1]);
    return said("edge {}: dx/dy = ({} {}) / ({} {}) = {}; x = {} {} (y {}){}", name,
                in_formula(ends->to[0]), minus(x1), in_formula(ends->to[1]), minus(y1),
                with_fraction(slope), x1, plus(in_formula(slope)), minus(y1), line_form(*ends));
}

std::string rows_of_half(const Context& context) {
    const Canvas& canvas = context.replay.trace().canvas;
    const auto half = context.as<HalfStep>();
    const Index from = half.from_y.value_or(0);
    const Index to = half.to_y.value_or(0);
    // A half is filled upward: its rows end where they began, or above.
    return canvas.row_of(from) < canvas.row_of(to) ? said("no row")
                                                   : said("rows y={} to {}", from, to);
}

std::string weights(const Context& context) {
    const auto& vertices = context.primitive.vertices;
    const auto weights = context.as<SampleStep>().weights.texts();
    std::string text;
    if (const auto of_sample =
            weights_of_sample(context.replay.trace(), context.step, context.primitive)) {
        const Vec3 areas = of_sample->areas();
        text = fmt::format(" {} / {}:", rastertrace::text(areas), rastertrace::text(areas.z));
    }
    for (std::size_t i = 0; i < weights.size(); ++i)
        text += fmt::format(" {} {}", i < vertices.size() ? vertices[i] : "?",
                            with_fraction(weights[i]));
    return text;
}

/// What a depth is compared with, and whose it is.
std::string against(const Context& context) {
    const Replay& replay = context.replay;
    const std::string stored = context.as<DepthStep>().stored.text();
    if (stored == "null")
        return said("nothing");
    const std::size_t owner = replay.primitive_of(replay.stored_before());
    return owner == 0 ? in_sentence(stored)
                      : said("{} of {}", in_sentence(stored),
                             replay.trace().step(owner).as<PrimitiveStep>().name.text());
}

/// 1 over a number, as the trace would write it: 5 of 1/5, 3/2 of 2/3.
std::string inverse_of(const std::string& number) {
    const auto value = TracedNumber(number).nearest_double();
    if (!value || *value == 0)
        return "?";
    const std::size_t bar = number.find('/');
    if (bar == std::string::npos)
        return fmt::format("{:.7g}", 1 / *value);
    const bool is_negative = number.starts_with('-');
    const std::string above = number.substr(is_negative ? 1 : 0, bar - (is_negative ? 1 : 0));
    const std::string below = number.substr(bar + 1);
    return in_sentence((is_negative ? "-" : "") + (above == "1" ? below : below + "/" + above));
}

/// What the depths are, and which of them is nearer: (1/z, larger is nearer; z = 5 against 3).
std::string depth_rule(const Context& context) {
    const Replay& replay = context.replay;
    const auto test = context.as<DepthStep>();
    const ToldMethod& method = replay.trace().method;
    const bool is_inverse = method.triangles.depth == Depth::inverse_z;
    const std::string asked = method.word_of("depth_compare");
    const auto depth = test.depth.nearest_double();
    const auto stored = test.stored.nearest_double();
    const auto larger = larger_depth_passes(replay.trace(), replay.step());
    const std::string what = is_inverse                                  ? "1/z"
                             : method.triangles.depth == Depth::linear_z ? "z"
                                                                         : method.word_of("depth");
    if (what.empty() || !larger)
        return {};
    const bool is_usual = asked.empty() || asked == "auto";
    std::string text = *larger    ? is_usual ? said(" ({}, larger is nearer", what)
                                             : said(" ({}, larger passes", what)
                          : is_usual ? said(" ({}, smaller is nearer", what)
                                  : said(" ({}, smaller passes", what);
    if (is_inverse && depth && *depth != 0)
        text += "; z = " + inverse_of(test.depth.text()) +
                (stored && *stored != 0 ? said(" against {}", inverse_of(test.stored.text())) : "");
    if (test.depth.text() == test.stored.text() && test.depth.text() != "NaN" && !test.behind)
        text += replay.stored_before() == 0 && replay.trace().left_out.primitive.empty()
                    ? said("; equal to the empty buffer")
                : test.pass.is_true() ? said("; of equals the thinner one passes")
                                      : said("; of equals the first stays");
    const bool is_point = context.primitive.kind == PrimitiveKind::point;
    const std::string part = is_point ? said("corner") : said("side");
    const std::string own = is_point ? said("the point") : said("the line's own point");
    if (test.side_of)
        text += said("; {} does not hide its own {}", test.side_of.text(), part);
    if (test.beside)
        text += said("; {} does not cover {}, or is not nearer there", test.beside.text(), own);
    if (test.behind)
        text += said("; {} covers {} and is nearer there", test.behind.text(), own);
    return text + ")";
}

std::string drawn_over(const Context& context) {
    const Replay& replay = context.replay;
    const auto pixel = context.as<PixelStep>();
    if (!replay.trace().canvas.contains(pixel.x, pixel.y))
        return said("   not on the canvas, not drawn");
    return replay.drew_over() != 0
               ? said("   over step {}", replay.trace().number_of(replay.drew_over()))
               : std::string();
}

/// "" of one that is not there.
std::string shown(std::optional<Index> index) {
    return index ? std::to_string(*index) : std::string();
}

std::string dropped(const Context& context) {
    const auto run = context.as<RejectStep>();
    const std::string x = shown(run.x);
    const std::string y = shown(run.y);
    const std::string to_x = run.to_x ? shown(run.to_x) : x;
    const std::string to_y = run.to_y ? shown(run.to_y) : y;
    if (!run.x)
        return said("rows y={} to {}", y, to_y);
    if (x == to_x && y == to_y)
        return fmt::format("pixel ({}, {})", x, y);
    return said("pixels ({}, {}) to ({}, {})", x, y, to_x, to_y);
}

/// dx/dy of an edge of the current primitive as it was set up; nothing if it is horizontal.
std::optional<std::string> slope_of(const Replay& replay, const TracedText& edge) {
    for (const std::size_t n : replay.edges()) {
        const auto step = replay.trace().step(n).as<EdgeStep>();
        if (step.edge == edge && step.dx_dy.has_number())
            return step.dx_dy.text();
    }
    return std::nullopt;
}

/// A method names one rule for the rows of triangles and one for lines, as in `floor+nearest`, if it needs
/// both.
std::string rule_of_rows(const Trace& trace, std::string_view key) {
    const std::string rules = trace.method.word_of(key);
    return rules.substr(0, rules.find('+'));
}
std::string rule_of_lines(const Trace& trace, std::string_view key) {
    const std::string rules = trace.method.word_of(key);
    return rules.substr(rules.find('+') + 1);
}

/// ` -> floor`; of a number halfway between two samples, ` -> nearest, ties up`; with an argument, ` -> floor(x - 1/2)`.
std::string rounded_by(const std::string& rule, const std::string& ties, std::string_view argument,
                       const std::optional<Rational>& number) {
    if (rule.empty())
        return {};
    const std::string text = fmt::format(" -> {}{}", rule, argument);
    const bool is_tie = number && rule == "nearest" && number->get_den() == 2;
    return is_tie ? text + said(", ties {}", ties.empty() ? "up" : ties) : text;
}

/// What is rounded instead of x, or y: `(x - 1/2)`; "" if samples lie at integers.
std::string among_samples(std::string_view axis, const Rational& offset) {
    return sgn(offset) == 0 ? std::string() : fmt::format("({} {})", axis, minus(text(offset)));
}

} // namespace

std::string rule_of_end(const Trace& trace, const EndOfRow& end,
                        const TracedWord<PrimitiveKind>& kind) {
    const auto offset = told_samples(trace).of(kind);
    const std::string argument = among_samples("x", offset.x());
    const std::string rounding = rule_of_rows(trace, "rounding");
    const auto x = end.x.exact();
    if (rounding == "inside")
        return (end.is_left ? " -> ceil" : " -> floor") + argument;
    if (rounding == "half-open")
        return " -> ceil" + argument + (end.is_left ? "" : " - 1");
    if (!rounding.empty())
        return rounded_by(rounding, rule_of_rows(trace, "ties"), argument,
                          x ? std::optional(offset.in_columns(*x)) : std::nullopt);
    if (!x || trace.method.triangles.fill != Fill::top_left)
        return {};
    const Rational sample = offset.x_of(end.pixel);
    if (end.is_left ? *x > sample : *x <= sample)
        return {};
    return said(" {} sample {}{}", end.is_left ? "<=" : ">", end.pixel,
                sgn(offset.x()) != 0 ? " " + plus(text(offset.x())) : std::string());
}

namespace {

/// One end of a row: `left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor -> -1`.
template <std::size_t which> std::string end_of_row(const Context& context) {
    const auto& [replay, step, primitive] = context;
    const EndOfRow end = ends_of(step.as<ScanlineStep>())[which];
    std::string text = end.name() + (end.edge ? " " + end.edge.text() : "") + ": x = ";

    const auto slope = slope_of(replay, end.edge);
    const auto ends = ends_of_edge(primitive, end.edge.text());
    const bool adds = replay.trace().method.triangles.lerp == LerpForm::incremental;
    // Between two rows of a polygon there may be other spans: it adds up all the same.
    const bool has_formula = !adds || primitive.kind != PrimitiveKind::polygon;
    std::string x_before;
    bool goes_up = false;
    if (adds && replay.scanline_before() != 0) {
        const auto row_before = replay.trace().step(replay.scanline_before()).as<ScanlineStep>();
        goes_up = row_before.y < end.y;
        for (const EndOfRow& before : ends_of(row_before))
            if (before.edge == end.edge)
                x_before = before.x.text();
    }
    if (slope && !x_before.empty())
        text += fmt::format("{} {} = ", in_formula(x_before),
                            goes_up ? plus(in_formula(*slope)) : minus(in_formula(*slope)));
    else if (slope && ends && has_formula)
        text += fmt::format("{} {} ({} {}) = ", in_formula(ends->from[0]), plus(in_formula(*slope)),
                            end.y, minus(in_formula(ends->from[1])));
    return text + fmt::format("{}{} -> {}", with_fraction(end.x.text()),
                              rule_of_end(replay.trace(), end, primitive.kind), end.pixel);
}

/// The edges that a row of a polygon meets: `   AB at 1/2, winding number 1`.
std::string crossings(const Context& context) {
    const auto step = context.as<CrossingsStep>();
    const auto edges = step.edges.texts();
    const auto x = step.x.texts();
    const auto winding = step.winding.texts();
    std::string text;
    for (std::size_t i = 0; i < std::min({edges.size(), x.size(), winding.size()}); ++i)
        text += said("   {} at {}, winding {}", edges[i], in_sentence(x[i]), winding[i]);
    return text;
}

/// Depths at the ends of a row: `   depth 1/3 to 1/5`.
std::string depths_of_row(const Context& context) {
    const auto row = context.as<ScanlineStep>();
    return row.left_depth && row.right_depth
               ? said("   depth {} to {}", in_sentence(row.left_depth.text()),
                      in_sentence(row.right_depth.text()))
               : std::string();
}

/// What a line goes by: `1/2 x + 0 = `, or the number before and m, for `dda`: `3/7 + 3/7 = `.
std::string slope_form(const Context& context) {
    const Replay& replay = context.replay;
    const auto step = context.as<AlongStep>();
    const auto ends = ends_of_line(replay, context.primitive);
    const auto value = step.value.exact();
    const bool is_x_major = step.x.has_value();
    const auto at = is_x_major ? step.x : step.y;
    const auto form = ends ? slope_form_of(*ends, is_x_major) : std::nullopt;
    if (!form || !value || !at)
        return {};
    const std::size_t before =
        replay.trace().method.others.line == LineMethod::dda ? along_before(replay) : 0;
    if (before != 0) {
        const auto last = replay.trace().step(before).as<AlongStep>();
        const auto last_value = last.value.exact();
        const auto last_at = is_x_major ? last.x : last.y;
        if (!last_value || !last_at)
            return {};
        const Rational moved = (*at - *last_at) * form->m;
        return agrees(*last_value + moved, *value, replay.trace())
                   ? fmt::format("{} {} = ", in_formula(last.value.text()), plus(text(moved)))
                   : std::string();
    }
    const Rational sample = sample_of_lines(replay.trace(), is_x_major, *at);
    return agrees(form->m * sample + form->b, *value, replay.trace())
               ? fmt::format("{} {} {} = ", text(form->m),
                             sample != *at ? text(sample)
                             : is_x_major  ? "x"
                                           : "y",
                             plus(text(form->b)))
               : std::string();
}

/// What Bresenham's d becomes: `; d - 6 = -3`.
std::string next_d(const Context& context) {
    const auto d = context.as<DecideStep>().d.exact();
    const auto ends = ends_of_line(context.replay, context.primitive);
    if (const auto circle =
            circle_decision(context.primitive, context.as<DecideStep>(), context.replay.trace()))
        return fmt::format("; d {} = {}", plus(text(circle->increment)),
                           text(*d + circle->increment));
    const auto line = ends ? decisions_between(context.replay.trace(), *ends) : std::nullopt;
    if (!line || !d)
        return {};
    const Rational next = line->next(*d);
    if (const auto told = next_d_told(context.replay);
        told && !agrees(next, *told, context.replay.trace()))
        return said("; the next d is {}", text(*told));
    return fmt::format("; d {} = {}", plus(text(next - *d)), text(next));
}

/// How much of the light that is a level of 255 is on an sRGB screen (IEC 61966-2-1), in percent.
double share_of_light(int level) {
    const double signal = level / 255.0;
    return 100 * (signal <= 0.04045 ? signal / 12.92 : std::pow((signal + 0.055) / 1.055, 2.4));
}

/// The brightest level of a color, and what it is on a screen: ` (level 128: 21.6 % of the light)`.
std::string level(const Context& context) {
    const auto color = context.as<LightStep>().color.color();
    if (!color)
        return {};
    const int brightest = std::max({int{color->red()}, int{color->green()}, int{color->blue()}});
    return said(" (level {}: {:.1f} % of the light on an sRGB screen)", brightest,
                share_of_light(brightest));
}

/// Which side of 0 Bresenham's d lies on, and where it goes for that. A circle goes diagonally at 0.
std::string sign_of_d(const Context& context, const DecideStep& step) {
    const std::string d = step.d.text();
    if (d == "NaN")
        return said("(neither above 0 nor below)");
    const bool steps_at_0 = context.replay.trace().method.others.ties == Ties::step ||
                            context.primitive.kind == PrimitiveKind::circle;
    const bool is_diagonal = steps_at_0 ? !d.starts_with('-') : !d.starts_with('-') && d != "0";
    const std::string_view compared = steps_at_0    ? is_diagonal ? ">= 0" : "< 0"
                                      : is_diagonal ? "> 0"
                                                    : "<= 0";
    return is_diagonal ? said("{}, diagonally", compared) : said("{}, straight on", compared);
}

/// The color of a pixel that has its own; on a line, how far it has come from one end's to the other's.
std::string color(const Context& context) {
    const auto pixel = context.as<PixelStep>();
    if (!pixel.color)
        return {};
    const std::string told = " " + pixel.color.text();
    const auto on_line = color_on_line(context.replay, context.primitive);
    if (!on_line)
        return told;
    switch (on_line->lerp) {
    case ColorLerp::space:
        return said("{} ({} of the color of {})", told, text(on_line->share()), on_line->names[1]);
    case ColorLerp::distance:
        return said("{} ({} of the distance)", told, six_places(nearest_double(on_line->share())));
    case ColorLerp::axis:
        break;
    }
    return said("{} (step {} of {})", told, text(on_line->step), text(on_line->steps));
}

/// Why a pixel is drawn, once more: its row, its decision or its sample.
std::string reason(const Context& context) {
    const std::size_t n = reason_of_pixel(context.replay);
    if (n == 0)
        return {};
    const Trace& trace = context.replay.trace();
    const StepView step = trace.step(n);
    switch (*trace.kind_of(n)) {
    case StepKind::scanline: {
        const auto row = step.as<ScanlineStep>();
        return said("   row y={}: {} to {}", row.y, row.from, row.to);
    }
    case StepKind::along: {
        const auto along = step.as<AlongStep>();
        return fmt::format("   {} = {}", along.x ? "y" : "x", in_sentence(along.value.text()));
    }
    case StepKind::decide: {
        const auto decision = step.as<DecideStep>();
        return fmt::format("   d = {} {}", decision.d.text(), sign_of_d(context, decision));
    }
    case StepKind::sample:
        return said("   no weight is negative");
    default:
        return {};
    }
}

/// How much of a long list or name is shown.
constexpr std::size_t most_ears_shown = 12;
constexpr std::size_t shown_of_name = 60;

/// The ears of a face in the order in which they were cut; the last triangle is what they leave.
std::string ears(const Context& context) {
    auto names = context.as<TriangulateStep>().ears.texts();
    const std::size_t count = names.size();
    if (count < 2)
        return joined(names, ", ");
    const std::string rest = shortened(names.back(), shown_of_name);
    names.resize(std::min(count - 1, most_ears_shown));
    std::string text = joined(names, ", ");
    if (names.size() < count - 1)
        text += said(", ... ({} in all)", count - 1);
    return said("{}; what is left is {}", text, rest);
}

/// A part of a sentence that is more than a field.
struct Part {
    std::string_view name;
    std::string (*text)(const Context& context);
};

/// In the order of the sentences in step_kind.cpp.
constexpr Part parts[] = {
    {"face",
     [](const Context& context) {
         return said("face {}",
                     shortened(context.as<TriangulateStep>().name.text(), shown_of_name));
     }},
    {"ears", ears},
    {"of_object",
     [](const Context& context) {
         const TracedText object = context.as<MatrixStep>().object;
         return object ? said(" of {}", object.text()) : std::string();
     }},
    {"factors",
     [](const Context& context) {
         const auto factors = context.as<MatrixStep>().factors.texts();
         return factors.empty() ? std::string() : " = " + joined(factors, " x ");
     }},
    {"rows",
     [](const Context& context) {
         std::string text;
         for (auto row : text_rows(context.as<MatrixStep>().rows)) {
             std::transform(row.begin(), row.end(), row.begin(), in_formula);
             text += fmt::format("  [{}]", joined(row, " "));
         }
         return text;
     }},
    {"place", place},
    {"snapped",
     [](const Context& context) {
         const auto snapped = context.as<VertexStep>().snapped;
         return snapped ? " -> " + point(snapped.texts()) : std::string();
     }},
    {"farthest_first", farthest_first},
    {"corners", corners},
    {"radius",
     [](const Context& context) {
         const auto radius = context.as<PrimitiveStep>().radius;
         return radius ? said("   radius {}", *radius) : std::string();
     }},
    {"octant",
     [](const Context& context) {
         const auto octant = context.as<PrimitiveStep>().octant;
         return octant ? said("   octant {}", *octant) : std::string();
     }},
    {"painted",
     [](const Context& context) {
         return context.as<PrimitiveStep>().painted.is_false() ? said("   only hides, not painted")
                                                               : std::string();
     }},
    {"kind",
     [](const Context& context) {
         const auto& kind = context.primitive.kind;
         return std::string(in_language_of_steps(kind ? kind.text() : "primitive"));
     }},
    {"primitive", name_of_primitive},
    {"toward",
     [](const Context& context) {
         return context.as<FaceStep>().by == "light" ? said("to light") : said("to eye");
     }},
    {"cosine",
     [](const Context& context) {
         const auto cosine = context.as<FaceStep>().cosine.nearest_double();
         return cosine ? said(", cosine {} ({:.2f} degrees)", six_places(*cosine),
                              degrees_of_cosine(*cosine))
                       : std::string();
     }},
    {"intensity",
     [](const Context& context) {
         const TracedNumber intensity = context.as<LightStep>().intensity;
         const auto value = intensity.nearest_double();
         return value ? six_places(*value) : intensity.text();
     }},
    {"level", level},
    {"inside",
     [](const Context& context) {
         const auto inside = context.as<ClipStep>().inside.texts();
         return said("{} of {}", std::count(inside.begin(), inside.end(), "true"), inside.size());
     }},
    {"edge", edge},
    {"rows_of_half", rows_of_half},
    {"line_to",
     [](const Context& context) {
         const auto ends = ends_of_line(context.replay, context.primitive);
         return ends ? said(", to {}", text(ends->to)) : std::string();
     }},
    {"samples",
     [](const Context& context) {
         const auto offset = told_samples(context.replay.trace()).of(context.primitive.kind);
         return sgn(offset.y()) != 0 ? said(", samples at y = {} {}", context.as<ScanlineStep>().y,
                                            plus(text(offset.y())))
                                     : std::string();
     }},
    {"crossings", crossings},
    {"fill_rule",
     [](const Context& context) {
         return context.replay.trace().method.others.fill_rule == FillRule::non_zero ? said("not 0")
                                                                                     : said("odd");
     }},
    {"left_end", end_of_row<0>},
    {"right_end", end_of_row<1>},
    {"depths_of_row", depths_of_row},
    {"empty",
     [](const Context& context) {
         const auto row = context.as<ScanlineStep>();
         return row.to < row.from ? said("   no pixel between") : std::string();
     }},
    {"along",
     [](const Context& context) {
         const auto along = context.as<AlongStep>();
         return along.x ? fmt::format("x = {}: y", *along.x)
                        : fmt::format("y = {}: x", shown(along.y));
     }},
    {"slope_form", slope_form},
    {"rule_of_line",
     [](const Context& context) {
         const Trace& trace = context.replay.trace();
         if (trace.method.others.line == LineMethod::diamond_exit)
             return said(" -> diamond");
         const auto along = context.as<AlongStep>();
         const auto offset = told_samples(trace).lines;
         const Rational& across = along.x ? offset.y() : offset.x();
         auto value = along.value.exact();
         if (value)
             *value -= across;
         return rounded_by(rule_of_lines(trace, "rounding"), rule_of_lines(trace, "ties"),
                           among_samples(along.x ? "y" : "x", across), value);
     }},
    {"sign_of_d",
     [](const Context& context) { return sign_of_d(context, context.as<DecideStep>()); }},
    {"next_d", next_d},
    {"weights", weights},
    {"against", against},
    {"depth_rule", depth_rule},
    {"color", color},
    {"reason", reason},
    {"drawn_over", drawn_over},
    {"dropped", dropped},
    {"what_is_open",
     [](const Context& context) {
         const auto open = context.as<UndecidedStep>();
         const std::string name = printable(open.name.text());
         return open.error ? said("doubles leave {} open: a difference of {}, off by up to {}",
                                  name, open.difference.text(), open.error.text())
                           : said("a number of {} has left the doubles", name);
     }},
};

/// The part of that name, or nullptr.
const Part* part_named(std::string_view name) {
    const auto* const found = std::find_if(std::begin(parts), std::end(parts),
                                           [name](const Part& part) { return part.name == name; });
    return found == std::end(parts) ? nullptr : found;
}

/// {pass?passes:fails}: the words for true and for false of a boolean field.
struct Choice {
    std::string_view field;
    std::string_view if_true;
    std::string_view if_false;
};
std::optional<Choice> choice_in(std::string_view placeholder) {
    const std::size_t mark = placeholder.find('?');
    const std::size_t colon = placeholder.find(':', std::min(mark, placeholder.size()));
    if (colon == std::string_view::npos)
        return std::nullopt;
    return Choice{placeholder.substr(0, mark), placeholder.substr(mark + 1, colon - mark - 1),
                  placeholder.substr(colon + 1)};
}

/// What stands for a placeholder of a sentence.
std::string filled_in(std::string_view placeholder, const Context& context) {
    if (placeholder.starts_with('@')) {
        const Part* const part = part_named(placeholder.substr(1));
        return part != nullptr ? part->text(context) : std::string();
    }
    const auto value_of = [&context](std::string_view field) {
        return context.step.field(field).value_or("");
    };
    if (placeholder.starts_with('#'))
        return std::string(in_language_of_steps(plain_text(value_of(placeholder.substr(1)))));
    if (const auto choice = choice_in(placeholder))
        return std::string(value_of(choice->field) == "true" ? choice->if_true : choice->if_false);
    const std::string value = value_of(placeholder);
    return value.starts_with('[') ? point(TracedList<TracedValue>(value).texts())
                                  : in_sentence(plain_text(value));
}

/// A placeholder of a pattern: from its opening bracket on, to behind the closing one.
struct Placeholder {
    std::size_t begin;
    std::size_t end;
};

std::vector<Placeholder> placeholders_in(std::string_view pattern) {
    std::vector<Placeholder> places;
    for (std::size_t open = pattern.find('{'); open != std::string_view::npos;
         open = pattern.find('{', open + 1))
        places.push_back({open, pattern.find('}', open) + 1});
    return places;
}

} // namespace

std::optional<bool> larger_depth_passes(const Trace& trace, std::size_t n) {
    const Method& method = trace.method.triangles;
    if (method.depth_compare != DepthCompare::automatic)
        return method.depth_compare == DepthCompare::greater;
    const auto test = trace.step(n).as<DepthStep>();
    const auto depth = test.depth.nearest_double();
    const auto stored = test.stored.nearest_double();
    const bool is_decided_by_them = !test.side_of && !test.beside && !test.behind;
    if (is_decided_by_them && depth && stored && *depth != *stored)
        return test.pass.is_true() == (*depth > *stored);
    return method.depth == Depth::inverse_z  ? std::optional(true)
           : method.depth == Depth::linear_z ? std::optional(false)
                                             : std::nullopt;
}

Sentence sentence_of_step(const Replay& replay) {
    if (replay.step() == 0)
        return {.pattern = Words("nothing drawn yet").in(language_of_steps()), .fills = {}};
    const StepView step = replay.trace().step(replay.step());
    const auto kind = replay.trace().kind_of(replay.step());
    if (!kind) {
        constexpr std::size_t width = 100;
        return {.pattern = "{step}", .fills = {printable(shortened(step.json(), width))}};
    }
    Sentence sentence{.pattern = row_of(*kind).sentence.in(language_of_steps()), .fills = {}};
    const Context context{replay, step, primitive_of(replay)};
    for (const auto& [begin, end] : placeholders_in(sentence.pattern))
        sentence.fills.push_back(
            printable(filled_in(sentence.pattern.substr(begin + 1, end - begin - 2), context)));
    return sentence;
}

std::vector<std::string_view> pieces_of(std::string_view pattern) {
    std::vector<std::string_view> pieces;
    std::size_t begin = 0;
    for (const Placeholder& place : placeholders_in(pattern)) {
        pieces.push_back(pattern.substr(begin, place.begin - begin));
        begin = place.end;
    }
    pieces.push_back(pattern.substr(begin));
    return pieces;
}

std::string_view unknown_placeholder(std::string_view pattern, const StepRow& row) {
    const auto is_field = [fields = fields_of(row.kind)](std::string_view name) {
        return std::any_of(fields.begin(), fields.end(),
                           [name](const StepField& field) { return field.name == name; });
    };
    const auto is_known = [&](std::string_view placeholder) {
        if (placeholder.starts_with('@'))
            return part_named(placeholder.substr(1)) != nullptr;
        if (placeholder.starts_with('#'))
            return is_field(placeholder.substr(1));
        const auto choice = choice_in(placeholder);
        return is_field(choice ? choice->field : placeholder);
    };
    for (const auto& [begin, end] : placeholders_in(pattern)) {
        const std::string_view placeholder = pattern.substr(begin + 1, end - begin - 2);
        if (!is_known(placeholder))
            return placeholder;
    }
    return {};
}

std::string describe_step(const Replay& replay) {
    const Sentence sentence = sentence_of_step(replay);
    const auto pieces = pieces_of(sentence.pattern);
    std::string text(pieces.front());
    for (std::size_t i = 0; i < sentence.fills.size(); ++i)
        text.append(sentence.fills[i]).append(pieces[i + 1]);
    return text + what_numbers_give(replay.trace(), replay.step()) + formula_of_mistake(replay) +
           place_in_code(replay.trace(), replay.step());
}

} // namespace rastertrace
