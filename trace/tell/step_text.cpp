// SPDX-License-Identifier: MIT
#include "step_text.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/raster/line.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/primitive_name.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string_view>
#include <system_error>

namespace rastertrace {

std::string said_count(std::uint64_t count, const Words& noun) {
    return counted(count, noun.in(language_of_steps()));
}

std::string in_sentence(const std::string& number) {
    constexpr std::size_t longest = 20;
    constexpr std::size_t digits = 8;
    const std::size_t bar = number.find('/');
    if (bar == std::string::npos || number.size() <= longest)
        return number;
    const auto first_digits = [](std::string part) {
        return part.size() <= digits + 3 ? part : part.substr(0, digits) + "...";
    };
    const auto value = TracedNumber(number).nearest_double();
    if (!value)
        return number; // a name with a slash
    const std::string digits_of_value = fmt::format("{:.7g}", *value);
    // What lies a hair beside a whole number or a half is rounded otherwise than that.
    constexpr double hair = 1e-6;
    const auto near = number_in(digits_of_value);
    const auto exact = number_in(number);
    const bool is_close = near && exact && *near != *exact && near->get_den() <= 2 &&
                          std::abs(nearest_double(*exact - *near)) < hair;
    return fmt::format("{}/{} {} {}", first_digits(number.substr(0, bar)),
                       first_digits(number.substr(bar + 1)),
                       !is_close        ? "="
                       : *exact < *near ? "<"
                                        : ">",
                       digits_of_value);
}

std::string in_formula(const std::string& number) {
    const auto value =
        in_sentence(number) == number ? std::nullopt : TracedNumber(number).nearest_double();
    return value ? fmt::format("{:.7g}", *value) : number;
}

std::optional<Rational> number_in(std::string_view text) {
    return TracedNumber(text).exact();
}

Rational as_stored(const Rational& number, std::string_view json, bool is_float) {
    if (json.starts_with('"'))
        return number;
    const double stored =
        is_float ? static_cast<double>(nearest_float(number)) : nearest_double(number);
    return std::isfinite(stored) ? Rational(stored) : number;
}

std::optional<Rational> stored_number_in(const TracedNumber& told, bool is_float) {
    if (const auto stored = told.stored_double(is_float))
        return Rational(*stored);
    const auto number = told.exact();
    return number ? std::optional(as_stored(*number, told.json(), is_float)) : std::nullopt;
}

std::optional<Vec2> vec2_in(const std::vector<std::string>& texts) {
    const auto x = texts.empty() ? std::nullopt : number_in(texts[0]);
    const auto y = texts.size() < 2 ? std::nullopt : number_in(texts[1]);
    return x && y ? std::optional(Vec2{*x, *y}) : std::nullopt;
}

std::optional<Vec3> vec3_in(const std::vector<std::string>& texts) {
    const auto xy = vec2_in(texts);
    const auto z = texts.size() < 3 ? std::nullopt : number_in(texts[2]);
    return xy && z ? std::optional(Vec3{xy->x, xy->y, *z}) : std::nullopt;
}

std::string text(const Rational& number) {
    constexpr std::size_t longest = 15;
    constexpr int largest_denominator = 1000;
    const std::string fraction = number.get_str();
    if (fraction.size() <= longest && number.get_den() < largest_denominator)
        return fraction;
    const double near = nearest_double(number);
    if (!std::isfinite(near))
        return in_sentence(fraction);
    const std::string decimal = fmt::format("{:.15g}", near);
    return number_in(decimal) == number ? decimal : fmt::format("{:.7g}", near);
}

std::string text(const Vec2& v) {
    return fmt::format("({}, {})", text(v.x), text(v.y));
}

std::string text(const Vec3& v) {
    return fmt::format("({}, {}, {})", text(v.x), text(v.y), text(v.z));
}

std::string plus(const std::string& number) {
    return number.starts_with('-') ? fmt::format("- {}", number.substr(1))
                                   : fmt::format("+ {}", number);
}

std::string minus(const std::string& number) {
    return number.starts_with('-') ? fmt::format("+ {}", number.substr(1))
                                   : fmt::format("- {}", number);
}

bool agrees(const Rational& worked_out, const Rational& told, const Trace& trace) {
    const bool is_float = trace.method.has_floats();
    const double tolerance = is_float ? 1e-4 : 1e-9;
    const double nothing = is_float ? 1e-9 : 1e-12; // what is left of numbers that cancel
    const double difference = std::abs(nearest_double(worked_out - told));
    const double size =
        std::max(std::abs(nearest_double(told)), std::abs(nearest_double(worked_out)));
    return difference <= std::max(nothing, tolerance * size);
}

std::string quotient(const std::string& above, const std::string& below) {
    const auto in_brackets = [](const std::string& number) {
        const bool has_brackets = number.starts_with('(') || number.find('/') == std::string::npos;
        return has_brackets ? number : fmt::format("({})", number);
    };
    return fmt::format("{} / {}", in_brackets(above), in_brackets(below));
}

double degrees_of_cosine(double cosine) {
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

std::string six_places(double number) {
    std::string text = fmt::format("{:.6f}", number);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
        text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string point(std::vector<std::string> coordinates) {
    std::transform(coordinates.begin(), coordinates.end(), coordinates.begin(), in_sentence);
    return fmt::format("({})", joined(coordinates, ", "));
}

std::string what_numbers_give(const Trace& trace, std::size_t step) {
    constexpr Words numbers_give{"its numbers give"};
    if (!trace.numbers_give)
        return {};
    const auto found = trace.numbers_give->find(trace.number_of(step));
    return found == trace.numbers_give->end()
               ? std::string()
               : fmt::format("   [!] {} {}", numbers_give.in(language_of_steps()),
                             printable(found->second));
}

PrimitiveText primitive_in(const StepView& step) {
    const auto told = step.as<PrimitiveStep>();
    return {told.kind,   told.name.text(), told.vertices.texts(), text_rows(told.at),
            told.depths, told.colors,      told.radius,           told.levels};
}

std::optional<Levels<Rational>> PrimitiveText::color_of(std::size_t vertex) const {
    const auto told = levels.values();
    const auto all = colors.values();
    if (vertex >= all.size())
        return std::nullopt;
    if (vertex >= told.size()) {
        const auto color = all[vertex].color();
        return color ? std::optional(Levels<Rational>(*color)) : std::nullopt;
    }
    Levels<Rational> result;
    const auto channels = told[vertex].texts();
    for (std::size_t i = 0; i < result.of.size(); ++i) {
        const auto channel = i < channels.size() ? number_in(channels[i]) : std::nullopt;
        if (!channel)
            return std::nullopt;
        result.of[i] = *channel;
    }
    return result;
}

std::optional<Divisors> divisors_of(const StepContext& context, const PrimitiveText& primitive) {
    const Trace& trace = context.trace();
    const auto& stages = trace.stages;
    if (trace.method.triangles.shade == Shade::affine ||
        std::find(stages.begin(), stages.end(), "perspective") == stages.end())
        return std::nullopt;
    // Depths of 1/z tell it, too: who asks about one pixel of a long trace may not have the spaces of vertices.
    const auto depths = primitive.depths.values();
    const bool has_z = trace.method.triangles.depth == Depth::inverse_z && !depths.empty();
    Divisors result{has_z ? "z" : "w", {}};
    for (std::size_t i = 0; i < primitive.vertices.size(); ++i) {
        std::optional<Rational> divisor;
        if (has_z && i < depths.size()) {
            divisor = depths[i].exact();
            if (divisor && sgn(*divisor) != 0)
                divisor = 1 / *divisor;
        } else {
            for (const std::size_t n : context.places_of(primitive.vertices[i])) {
                const auto vertex = trace.step(n).as<VertexStep>();
                const auto at = vertex.at.values();
                if (vertex.space == Space::clip && at.size() == 4)
                    divisor = at[3].exact();
            }
        }
        if (!divisor || sgn(*divisor) == 0)
            return std::nullopt;
        result.of.push_back(*divisor);
    }
    const bool differ = std::any_of(result.of.begin(), result.of.end(),
                                    [&](const Rational& one) { return one != result.of[0]; });
    return differ ? std::optional(std::move(result)) : std::nullopt;
}

std::optional<SharesInSpace> shares_in_space(const std::vector<Rational>& on_screen,
                                             const Divisors& divisors) {
    SharesInSpace result;
    for (std::size_t i = 0; i < std::min(on_screen.size(), divisors.of.size()); ++i) {
        result.divided.push_back(on_screen[i] / divisors.of[i]);
        result.sum += result.divided.back();
    }
    if (sgn(result.sum) <= 0)
        return std::nullopt;
    for (const Rational& one : result.divided)
        result.shares.push_back(one / result.sum);
    return result;
}

std::string place_in_code(const Trace& trace, std::size_t step) {
    const auto told = step == 0 ? std::nullopt : trace.step(step).field(key_of_code);
    const std::string code = plain_text(told.value_or(""));
    return code.empty() ? "" : "   " + printable(code);
}

std::string edge_name(const PrimitiveText& primitive, std::size_t from, std::size_t to) {
    const std::vector<std::string_view> names(primitive.vertices.begin(), primitive.vertices.end());
    return fmt::format("{}{}{}", names[from], name_separator(names), names[to]);
}

PrimitiveText primitive_of(const StepContext& context) {
    return context.primitive() == 0 ? PrimitiveText{}
                                    : primitive_in(context.trace().step(context.primitive()));
}

std::optional<EdgeEnds> ends_of_edge(const PrimitiveText& primitive, const std::string& edge) {
    const std::vector<std::string_view> names(primitive.vertices.begin(), primitive.vertices.end());
    const std::string_view separator = name_separator(names);
    const std::size_t count = names.size();
    for (std::size_t from = 0; from < count; ++from)
        for (const std::size_t to : {(from + 1) % count, (from + count - 1) % count}) {
            const bool have_places =
                from < primitive.positions.size() && to < primitive.positions.size() &&
                primitive.positions[from].size() >= 2 && primitive.positions[to].size() >= 2;
            if (from != to && have_places && edge.starts_with(names[from]) &&
                edge == fmt::format("{}{}{}", names[from], separator, names[to]))
                return EdgeEnds{primitive.positions[from], primitive.positions[to], {from, to}};
        }
    return std::nullopt;
}

std::optional<std::array<Vec2, 3>> corners_of(const PrimitiveText& primitive) {
    if (primitive.kind != PrimitiveKind::triangle || primitive.vertices.size() != 3 ||
        primitive.positions.size() != 3)
        return std::nullopt;
    std::array<Vec2, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto corner = vec2_in(primitive.positions[i]);
        if (!corner)
            return std::nullopt;
        corners[i] = *corner;
    }
    return corners;
}

namespace {

std::optional<LineEnds> line_between(const std::optional<Vec2>& from,
                                     const std::optional<Vec2>& to) {
    return from && to ? std::optional(LineEnds{*from, *to}) : std::nullopt;
}

/// The pixel whose sample is nearest to a point, a half up.
Vec2 pixel_near(const Vec2& point, const SampleOffset<Rational>& offset) {
    const GridPoint pixel = nearest_pixel<Rational>({point.x, point.y}, offset);
    return {pixel.x, pixel.y};
}

/// A line as it is drawn between pixels: each end goes to the nearest sample, a half up.
LineEnds between_nearest_pixels(const LineEnds& ends, const SampleOffset<Rational>& offset) {
    return {pixel_near(ends.from, offset), pixel_near(ends.to, offset)};
}

/// The edge, or the side, that was set up last.
std::optional<EdgeEnds> current_edge(const StepContext& context, const PrimitiveText& primitive) {
    if (context.edges().empty())
        return std::nullopt;
    const auto edge = context.trace().step(context.edges().back()).as<EdgeStep>();
    return ends_of_edge(primitive, edge.edge.text());
}

} // namespace

std::optional<LineEnds> ends_of_line(const StepContext& context, const PrimitiveText& primitive) {
    const auto& positions = primitive.positions;
    const Trace& trace = context.trace();
    const ToldSamples samples = told_samples(trace);
    const auto as_drawn = [&](const std::vector<std::string>& from,
                              const std::vector<std::string>& to) {
        const auto line = line_between(vec2_in(from), vec2_in(to));
        return line && trace.method.draws_lines_by(LineMethod::bresenham)
                   ? between_nearest_pixels(*line, samples.lines)
                   : line;
    };
    if (primitive.kind == PrimitiveKind::line && positions.size() == 2)
        return as_drawn(positions[0], positions[1]);
    const auto ends = current_edge(context, primitive);
    if (!ends)
        return std::nullopt;
    if (primitive.kind == PrimitiveKind::outline)
        return as_drawn(ends->from, ends->to);
    if (context.ray() == 0)
        return std::nullopt;
    const auto ray = trace.step(context.ray()).as<RayStep>();
    for (const auto& corner : positions)
        if (corner != ends->from && corner != ends->to) {
            const auto apex = vec2_in(corner);
            return apex ? line_between(Vec2{ray.x, ray.y}, pixel_near(*apex, samples.triangles))
                        : std::nullopt;
        }
    return std::nullopt;
}

Rational ColorOnLine::share_by(ColorLerp by) const {
    if (by == ColorLerp::distance)
        return 1 - std::sqrt(nearest_double(to_end / length));
    if (by == ColorLerp::axis)
        return step / steps;
    const auto in_space = divisors ? shares_in_space({1 - way, way}, *divisors) : std::nullopt;
    return in_space ? in_space->shares[1] : way;
}

namespace {

/// A line between two colors as it is drawn, from where it starts.
struct ColoredLine {
    GridPoint from_pixel;
    GridPoint to_pixel;
    Levels<Rational> from;
    Levels<Rational> to;
    std::array<std::string, 2> names;
    bool is_along_x;
};

/// Between two of a primitive's vertices, from the first one. Ends that are pixels have no offset.
std::optional<ColoredLine> colored_line(const LineEnds& ends, const PrimitiveText& primitive,
                                        const std::array<std::size_t, 2>& vertices,
                                        const SampleOffset<Rational>& offset = {}) {
    const auto [first, second] = vertices;
    const auto from = primitive.color_of(first);
    const auto to = primitive.color_of(second);
    if (!from || !to || primitive.vertices.size() != primitive.colors.values().size())
        return std::nullopt;
    return ColoredLine{nearest_pixel<Rational>({ends.from.x, ends.from.y}, offset),
                       nearest_pixel<Rational>({ends.to.x, ends.to.y}, offset),
                       *from,
                       *to,
                       {primitive.vertices[first], primitive.vertices[second]},
                       abs(ends.to.x - ends.from.x) >= abs(ends.to.y - ends.from.y)};
}

void reverse(ColoredLine& line) {
    std::swap(line.from_pixel, line.to_pixel);
    std::swap(line.from, line.to);
    std::swap(line.names[0], line.names[1]);
}

/// A fan draws its edges and its lines from the end with the lower x. Its lines lead between whole levels.
void begin_left(ColoredLine& line, const Trace& trace) {
    for (Levels<Rational>* const end : {&line.from, &line.to})
        *end = end->rounded(trace.method.triangles.color_rounding);
    if (line.to_pixel.x < line.from_pixel.x)
        reverse(line);
}

ColorOnLine color_at(const ColoredLine& line, GridPoint at, const Trace& trace) {
    const GridPoint from = line.from_pixel;
    const GridPoint to = line.to_pixel;
    const auto square_of_distance = [](GridPoint a, GridPoint b) {
        const Rational dx = b.x - a.x;
        const Rational dy = b.y - a.y;
        return Rational(dx * dx + dy * dy);
    };
    const auto steps_to = [&](GridPoint p) {
        return line.is_along_x ? std::abs(p.x - from.x) : std::abs(p.y - from.y);
    };
    const Index step = steps_to(at);
    const Index steps = steps_to(to);
    const Method& method = trace.method.others;
    const ColorLerp lerp =
        method.color_lerp == ColorLerp::distance ? ColorLerp::distance : ColorLerp::axis;
    // The first and the last pixel have the colors of the ends, wherever rounding has put them.
    const ColorRounding rounding = method.color_rounding;
    const Rational length = square_of_distance(from, to);
    return {.from = line.from,
            .to = line.to,
            .names = line.names,
            .step = step,
            .steps = steps,
            .to_end = step == 0       ? length
                      : step == steps ? Rational(0)
                                      : square_of_distance(at, to),
            .length = length,
            .lerp = lerp,
            .color =
                color_on_line({from, to, line.from.rounded(rounding), line.to.rounded(rounding)},
                              {.color_lerp = lerp, .color_rounding = rounding}, at, step, steps)};
}

/// The same in space: a pixel stands for the point of the line at its sample along the longer axis.
std::optional<ColorOnLine> color_in_space(const StepContext& context,
                                          const PrimitiveText& primitive,
                                          const std::array<std::size_t, 2>& ends) {
    const auto place_of = [&](std::size_t i) {
        return i < primitive.positions.size() ? vec2_in(primitive.positions[i]) : std::nullopt;
    };
    const auto [first, second] = ends;
    const auto a = place_of(first);
    const auto b = place_of(second);
    const auto from = primitive.color_of(first);
    const auto to = primitive.color_of(second);
    if (!a || !b || !from || !to || from->of == to->of)
        return std::nullopt;
    const auto pixel = context.trace().step(context.step()).as<PixelStep>();
    const auto samples = told_samples(context.trace()).lines;
    const bool is_x_major = abs(b->x - a->x) >= abs(b->y - a->y);
    const Rational run = is_x_major ? Rational(b->x - a->x) : Rational(b->y - a->y);
    const Rational along = is_x_major ? Rational(samples.x_of(pixel.x) - a->x)
                                      : Rational(samples.y_of(pixel.y) - a->y);
    ColorOnLine color{.from = *from,
                      .to = *to,
                      .names = {primitive.vertices[first], primitive.vertices[second]},
                      .step = along,
                      .steps = run,
                      .lerp = ColorLerp::space};
    color.way =
        sgn(run) == 0 ? Rational(0) : std::clamp<Rational>(along / run, Rational(0), Rational(1));
    if (auto divisors = divisors_of(context, primitive))
        color.divisors = {divisors->name, {divisors->of[first], divisors->of[second]}};
    return color;
}

/// The edge that the current lines of a fan begin in.
std::optional<ColoredLine> edge_of_fan(const PrimitiveText& primitive, const EdgeEnds& edge,
                                       const Trace& trace) {
    const auto ends = line_between(vec2_in(edge.from), vec2_in(edge.to));
    auto line = ends ? colored_line(between_nearest_pixels(*ends, told_samples(trace).triangles),
                                    primitive, edge.vertices)
                     : std::nullopt;
    if (line)
        begin_left(*line, trace);
    return line;
}

/// The line of a fan that is being drawn: from a pixel of its edge, in the color that is there, to the vertex beyond.
std::optional<ColoredLine> line_of_fan(const StepContext& context, const PrimitiveText& primitive,
                                       const LineEnds& ends) {
    const auto edge = current_edge(context, primitive);
    const auto start = color_on_edge_of_fan(context, primitive);
    if (!edge || !start)
        return std::nullopt;
    const std::size_t apex = 3 - edge->vertices[0] - edge->vertices[1];
    auto line = colored_line(ends, primitive, {apex, apex});
    if (!line)
        return std::nullopt;
    line->from = start->color;
    line->names[0] = text(ends.from);
    begin_left(*line, context.trace());
    return line;
}

} // namespace

std::optional<ColorOnLine> color_on_edge_of_fan(const StepContext& context,
                                                const PrimitiveText& primitive) {
    if (context.trace().method.others.color_lerp == ColorLerp::space)
        return std::nullopt; // mixed of those of all corners
    const auto edge = current_edge(context, primitive);
    const bool is_fan = primitive.kind == PrimitiveKind::triangle && context.ray() != 0;
    const auto line =
        edge && is_fan ? edge_of_fan(primitive, *edge, context.trace()) : std::nullopt;
    if (!line)
        return std::nullopt;
    const auto ray = context.trace().step(context.ray()).as<RayStep>();
    return color_at(*line, {ray.x, ray.y}, context.trace());
}

std::optional<ColorOnLine> color_on_line(const StepContext& context,
                                         const PrimitiveText& primitive) {
    const auto ends = ends_of_line(context, primitive);
    if (!ends)
        return std::nullopt;
    std::optional<ColoredLine> line;
    if (primitive.kind == PrimitiveKind::triangle) {
        line = line_of_fan(context, primitive, *ends);
    } else {
        const auto side = current_edge(context, primitive);
        const auto [first, second] = side ? side->vertices : std::array<std::size_t, 2>{0, 1};
        if (context.trace().method.others.color_lerp == ColorLerp::space)
            return color_in_space(context, primitive, {first, second});
        const bool are_pixels = context.trace().method.draws_lines_by(LineMethod::bresenham);
        line = colored_line(*ends, primitive, {first, second},
                            are_pixels ? SampleOffset<Rational>()
                                       : told_samples(context.trace()).lines);
        // Which direction is the longer one, the step that led to the pixel says: doubles may not tell.
        const std::size_t reason = reason_of_pixel(context);
        if (line && reason != 0 && context.trace().kind_of(reason) == StepKind::along)
            line->is_along_x = context.trace().step(reason).as<AlongStep>().x.has_value();
        const bool runs_down =
            line && line->is_along_x ? ends->to.x < ends->from.x : ends->to.y < ends->from.y;
        if (line && runs_down && context.trace().method.others.from == LineStart::low)
            reverse(*line);
    }
    if (!line)
        return std::nullopt;
    const auto pixel = context.trace().step(context.step()).as<PixelStep>();
    const ColorOnLine color = color_at(*line, {pixel.x, pixel.y}, context.trace());
    return sgn(color.steps) == 0 ? std::nullopt : std::optional(color);
}

std::optional<bool> is_x_major_octant(std::optional<Index> octant) {
    if (!octant)
        return std::nullopt;
    return *octant == 1 || *octant == 4 || *octant == 5 || *octant == 8;
}

bool covers(const StepView& step, Pixel pixel) {
    if (step.kind() != StepKind::reject)
        return x_in(step) == pixel.x && y_in(step) == pixel.y;
    const auto run = step.as<RejectStep>();
    const auto lies_between = [](Index at, std::optional<Index> from, std::optional<Index> to) {
        const auto last = to ? to : from;
        return from && std::min(*from, *last) <= at && at <= std::max(*from, *last);
    };
    const bool is_whole_row = !run.x && run.to_y;
    if (run.to_x && run.to_y)
        return false; // of a line, which leads off the canvas
    return lies_between(pixel.y, run.y, run.to_y) &&
           (is_whole_row || lies_between(pixel.x, run.x, run.to_x));
}

Lerp lerp_on(const LineEnds& ends, bool is_x_major, const Rational& at) {
    const auto& [a, b] = ends;
    return is_x_major ? Lerp{.d1 = a.y, .i1 = a.x, .d2 = b.y, .i2 = b.x, .i = at}
                      : Lerp{.d1 = a.x, .i1 = a.y, .d2 = b.x, .i2 = b.y, .i = at};
}

std::optional<SlopeForm> slope_form_of(const LineEnds& ends, bool is_x_major) {
    const Lerp at_0 = lerp_on(ends, is_x_major, 0);
    const auto m = at_0.slope();
    return m ? std::optional(SlopeForm{*m, at_0.value()}) : std::nullopt;
}

std::optional<Rational> next_d_told(const StepContext& context) {
    constexpr std::size_t between = 4; // a depth test and a pixel, and what a later program may add
    const Trace& trace = context.trace();
    const std::size_t n = context.step();
    for (std::size_t next = n + 1; next <= std::min(trace.size(), n + between); ++next) {
        const auto kind = trace.kind_of(next);
        const bool is_at_hand = trace.number_of(next) - trace.number_of(n) == next - n;
        if (!is_at_hand || kind == StepKind::primitive || kind == StepKind::edge ||
            kind == StepKind::ray)
            return std::nullopt;
        if (kind == StepKind::decide)
            return trace.step(next).as<DecideStep>().d.exact();
    }
    return std::nullopt;
}

std::optional<BresenhamDecisions> decisions_between(const Trace& trace, const LineEnds& ends) {
    const Rational dx = abs(ends.to.x - ends.from.x);
    const Rational dy = abs(ends.to.y - ends.from.y);
    if (dx.get_den() != 1 || dy.get_den() != 1)
        return std::nullopt;
    const Rational longer = std::max(dx, dy);
    return BresenhamDecisions{.major = longer,
                              .minor = std::min(dx, dy),
                              .steps = static_cast<std::size_t>(longer.get_num().get_ui()),
                              .steps_at_ties = trace.method.others.ties == Ties::step};
}

std::optional<Vec2> center_of(const PrimitiveText& primitive, const Trace& trace) {
    const auto at =
        primitive.positions.empty() ? std::nullopt : vec2_in(primitive.positions.front());
    return at ? std::optional(pixel_near(*at, told_samples(trace).others)) : std::nullopt;
}

std::optional<CircleDecision> circle_decision(const PrimitiveText& primitive,
                                              const DecideStep& step, const Trace& trace) {
    const auto center = center_of(primitive, trace);
    const auto d = step.d.exact();
    if (primitive.kind != PrimitiveKind::circle || !center || !d)
        return std::nullopt;
    const Rational x = step.x - center->x;
    const Rational y = step.y - center->y;
    return CircleDecision{
        .x = x, .y = y, .increment = sgn(*d) < 0 ? Rational(2 * x + 3) : Rational(2 * (x - y) + 5)};
}

std::string_view matrix_into(std::string_view space) {
    return space == "world"    ? "model"
           : space == "camera" ? "view"
           : space == "clip"   ? "projection"
           : space == "screen" ? "viewport"
                               : "";
}

Rational sample_of_lines(const Trace& trace, bool is_column, Index at) {
    const auto offset = told_samples(trace).lines;
    return is_column ? offset.x_of(at) : offset.y_of(at);
}

bool has_bottom_rule(const Trace& trace) {
    return trace.method.triangles.horizontal_edge == HorizontalEdge::bottom;
}

std::string by_convention(const Trace& trace) {
    const std::string convention = trace.method.word_of("convention");
    return convention.empty() ? convention : said(", by the rule of {}", printable(convention));
}

std::optional<Vec2> sample_of(const Trace& trace, const StepView& step) {
    const auto x = x_in(step);
    const auto y = y_in(step);
    if (!x || !y)
        return std::nullopt;
    const auto offset = told_samples(trace).triangles;
    return Vec2{offset.x_of(*x), offset.y_of(*y)};
}

std::optional<Weights> weights_of_sample(const Trace& trace, const StepView& step,
                                         const PrimitiveText& primitive) {
    const auto corners = corners_of(primitive);
    const auto p = sample_of(trace, step);
    if (!corners || !p || sgn(doubled_area((*corners)[0], (*corners)[1], (*corners)[2])) == 0)
        return std::nullopt;
    return Weights{*corners, *p};
}

std::size_t along_before(const StepContext& context) {
    for (std::size_t before = context.step(); before > context.primitive() + 1;) {
        --before;
        const auto kind = context.trace().kind_of(before);
        if (kind == StepKind::along)
            return before;
        if (kind != StepKind::pixel && kind != StepKind::depth && kind != StepKind::reject)
            break;
    }
    return 0;
}

std::size_t reason_of_pixel(const StepContext& context) {
    if (context.primitive() == 0)
        return 0; // a trace of some steps only
    for (std::size_t n = context.step() - 1; n > context.primitive(); --n) {
        const auto kind = context.trace().kind_of(n);
        if (kind != StepKind::pixel && kind != StepKind::depth && kind != StepKind::reject)
            return kind ? n : 0; // a kind that nobody knows is no reason
    }
    return 0;
}

std::array<EndOfRow, 2> ends_of(const ScanlineStep& row) {
    return {{{true, row.left_edge, row.y, row.left, row.left_depth, row.from},
             {false, row.right_edge, row.y, row.right, row.right_depth, row.to}}};
}

std::string EndOfRow::name() const {
    return is_left ? said("left") : said("right");
}

} // namespace rastertrace
