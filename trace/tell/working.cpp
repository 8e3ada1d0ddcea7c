// SPDX-License-Identifier: MIT
#include "working.h"

#include "formula.h"
#include "sheet.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/edge.h>
#include <rastertrace/core/raster/line.h>
#include <rastertrace/core/raster/triangle.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

namespace rastertrace {

std::string product(const Rational& a, const Rational& b) {
    return sgn(a) < 0 ? fmt::format("({}) ({})", text(a), text(b))
                      : fmt::format("{} ({})", text(a), text(b));
}

namespace {

void order(Sheet& sheet) {
    const auto order = sheet.step.as<OrderStep>();
    const auto names = order.names.texts();
    const auto distances = order.distances.texts();
    for (std::size_t i = 0; i < names.size() && i < distances.size(); ++i)
        sheet.put(said("{}. {} at {}", i + 1, names[i], in_sentence(distances[i])));
}

/// Why a line is of its octant (T2): between the pixels of its ends, from the one where it starts.
void put_octant(Sheet& sheet, const std::optional<LineEnds>& ends,
                const SampleOffset<Rational>& offset, std::optional<Index> told) {
    if (!ends || !told)
        return;
    const GridPoint a = nearest_pixel<Rational>({ends->from.x, ends->from.y}, offset);
    const GridPoint b = nearest_pixel<Rational>({ends->to.x, ends->to.y}, offset);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
        if (octant_of(from, to) != *told)
            continue;
        const Index dx = to.x - from.x;
        const Index dy = to.y - from.y;
        const auto sign_of = [](Index d) { return d < 0 ? "< 0" : ">= 0"; };
        return sheet.put(
            said("({}, {}) to ({}, {}): dx = {} {}, dy = {} {}, |dx| {} |dy|: octant {}", from.x,
                 from.y, to.x, to.y, dx, sign_of(dx), dy, sign_of(dy),
                 std::abs(dx) >= std::abs(dy) ? ">=" : "<", *told));
    }
}

/// Which way a triangle is turned: each vertex against the edge before it.
void primitive(Sheet& sheet) {
    const auto octant = sheet.step.as<PrimitiveStep>().octant;
    if (sheet.primitive.kind == PrimitiveKind::line)
        return put_octant(sheet, ends_of_line(sheet.at, sheet.primitive),
                          sheet.trace().method.draws_lines_by(LineMethod::bresenham)
                              ? SampleOffset<Rational>() // they are pixels
                              : told_samples(sheet.trace()).lines,
                          octant);
    const auto corners = corners_of(sheet.primitive);
    if (!corners)
        return;
    const auto& names = sheet.primitive.vertices;
    const bool is_y_up = sheet.trace().canvas.down() < 0;
    const Rational area = doubled_area((*corners)[0], (*corners)[1], (*corners)[2]);
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2& a = (*corners)[i];
        const Vec2& b = (*corners)[(i + 1) % 3];
        const Vec2& p = (*corners)[(i + 2) % 3];
        const Rational value = doubled_area(a, b, p);
        const bool is_left = (sgn(value) > 0) == is_y_up;
        const std::string where = sgn(value) == 0 ? said("on it")
                                  : is_left       ? said("left of it")
                                                  : said("right of it");
        sheet.put(said("{0} x {1} = {2} - {3} = {4}: {5} lies {6}",
                       edge_name(sheet.primitive, i, (i + 1) % 3),
                       edge_name(sheet.primitive, i, (i + 2) % 3), product(b.x - a.x, p.y - a.y),
                       product(b.y - a.y, p.x - a.x), text(value), names[(i + 2) % 3], where));
    }
    const std::string turn = sgn(area) == 0               ? said("no area")
                             : (sgn(area) > 0) == is_y_up ? said("counter-clockwise")
                                                          : said("clockwise");
    sheet.put(said("area = |{}| / 2 = {}, {}", text(area), text(abs(area) / 2), turn));
}

} // namespace

std::string EdgeFunctionText::at(const Vec2& p) const {
    const Rational value = value_at(p);
    return fmt::format("{} + {} = {}: {}", product(a, p.x - from.x), product(b, p.y - from.y),
                       text(value),
                       sgn(value) > 0                  ? said("> 0, inside")
                       : sgn(value) < 0                ? said("< 0, outside")
                       : is_top_left && is_bottom_rule ? said("on a bottom or left edge, inside")
                       : is_top_left                   ? said("on a top or left edge, inside")
                                                       : said("on the edge, outside"));
}

std::optional<EdgeFunctionText> edge_function_in(const Trace& trace, const EdgeStep& edge,
                                                 const PrimitiveText& primitive) {
    const auto a = edge.a.exact();
    const auto b = edge.b.exact();
    const auto ends = a && b ? ends_of_edge(primitive, edge.edge.text()) : std::nullopt;
    const auto from = ends ? vec2_in(ends->from) : std::nullopt;
    if (!from)
        return std::nullopt;
    return EdgeFunctionText{*a, *b, *from, edge.top_left.is_true(), has_bottom_rule(trace)};
}

namespace {

/// Both forms of the line, and on which side the third corner lies.
void edge(Sheet& sheet) {
    const auto step = sheet.step.as<EdgeStep>();
    const auto slope = sheet.form<Slope>("dx_dy");
    if (!slope)
        return;
    const auto& [from, to, other] = *slope;
    const Rational dx = to.x - from.x;
    const Rational dy = to.y - from.y;
    sheet.put(fmt::format("dx = {} {} = {}, dy = {} {} = {}", text(to.x), minus(text(from.x)),
                          text(dx), text(to.y), minus(text(from.y)), text(dy)));
    const LineEnds ends{from, to};
    if (const auto x = slope_form_of(ends, false)) {
        sheet.put(
            fmt::format("x = {} {} (y {})", text(from.x), plus(text(x->m)), minus(text(from.y))));
        sheet.put(fmt::format("  = {} y {}", text(x->m), plus(text(x->b))));
    }
    if (const auto y = slope_form_of(ends, true))
        sheet.put(fmt::format("y = {} x {}", text(y->m), plus(text(y->b))));
    put_octant(sheet, ends, sheet.samples(), step.octant);
    const auto corners = corners_of(sheet.primitive);
    const auto function = edge_function_in(sheet.trace(), step, sheet.primitive);
    if (!corners || !function)
        return;
    // E is above 0 inside: that decides the signs.
    const auto a = step.a.exact();
    const auto b = step.b.exact();
    if (a && b && sheet.agrees(dy, *a) && sheet.agrees(-dx, *b))
        sheet.put(fmt::format("a = dy = {}, b = -dx = {}", text(dy), text(-dx)));
    else if (a && b && sheet.agrees(-dy, *a) && sheet.agrees(dx, *b))
        sheet.put(fmt::format("a = -dy = {}, b = dx = {}", text(-dy), text(dx)));
    const auto is_at = [](const Vec2& p, const Vec2& q) { return p.x == q.x && p.y == q.y; };
    for (std::size_t i = 0; i < 3; ++i)
        if (const Vec2& p = (*corners)[i]; !is_at(p, from) && !is_at(p, to))
            sheet.put(said("E at {} = {}", sheet.primitive.vertices[i], function->at(p)));
}

/// In front of a Lerp that is written out.
constexpr std::string_view x_of_edge = "x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = ";

/// Where an edge crosses a row.
void put_crossing(Sheet& sheet, const EndOfRow& end) {
    const auto x = sheet.form<Lerp>(end.is_left ? "left" : "right");
    const auto told = end.x.exact();
    if (!x || x->i1 == x->i2)
        return;
    // A row that adds to the one before says so in its sentence.
    const bool adds = sheet.method().lerp == LerpForm::incremental;
    if (told && !adds && sheet.agrees(x->value(), *told))
        sheet.put(fmt::format("{} {}: {}{}{} -> {}", end.name(), end.edge.text(), x_of_edge,
                              x->written_out(*told),
                              rule_of_end(sheet.trace(), end, sheet.primitive.kind), end.pixel));

    // The same LERP for the depth there.
    const auto depth = end.depth.exact();
    const auto d =
        depth ? sheet.form<Lerp>(end.is_left ? "left_depth" : "right_depth") : std::nullopt;
    if (!d || !sheet.agrees(d->value(), *depth))
        return;
    const auto& [d1, y1, d2, y2, y, step, other, is_inverse_z] = *d;
    if (d1 != d2)
        sheet.put(said("  depth per row on {}: (d2 - d1)/(y2 - y1) = ({} {})/({} {}) = {}",
                       end.edge.text(), text(d2), minus(text(d1)), text(y2), minus(text(y1)),
                       text(*d->slope())));
    sheet.put(said("  depth = {} {} ({} {}) = {} {} = {}", text(d1), plus(text(*d->slope())),
                   text(y), minus(text(y1)), text(d1), plus(text(Rational(*d->slope() * (y - y1)))),
                   text(*depth)));
}

/// Which boundary each end of a row lies on (T3): A leads from the lowest vertex t0 to the highest t2, B by way of t1.
void put_boundaries(Sheet& sheet, const ScanlineStep& row) {
    const auto corners = corners_of(sheet.primitive);
    if (sheet.method().fill != Fill::two_halves || !corners)
        return;
    const auto [top, middle, bottom] =
        sorted_from_top(Triangle<Rational>{*corners}, sheet.trace().canvas.down());
    const std::array<std::size_t, 3> t{bottom.index, middle.index, top.index};
    constexpr std::array<std::array<std::size_t, 2>, 3> sides{{{0, 2}, {0, 1}, {1, 2}}};
    std::vector<std::string> ends;
    for (const EndOfRow& end : ends_of(row))
        for (const auto& [from, to] : sides)
            if (end.edge == edge_name(sheet.primitive, t[from], t[to]) ||
                end.edge == edge_name(sheet.primitive, t[to], t[from]))
                ends.push_back(said("{} {} = t{}t{} is boundary {}", end.name(), end.edge.text(),
                                    from, to, from + 2 == to ? "A" : "B"));
    const auto& names = sheet.primitive.vertices;
    if (ends.size() == 2)
        sheet.put(said("t0, t1, t2 = {}, {}, {} from below: {}, {}", names[t[0]], names[t[1]],
                       names[t[2]], ends[0], ends[1]));
}

/// What the edge function of an end of a row says of the sample of its pixel, where there are such functions.
void put_edge_function(Sheet& sheet, const EndOfRow& end) {
    const auto offset = sheet.samples();
    const Vec2 sample{offset.x_of(end.pixel), offset.y_of(end.y)};
    for (const std::size_t n : sheet.at.edges()) {
        const auto edge = sheet.trace().step(n).as<EdgeStep>();
        const auto function = edge_function_in(sheet.trace(), edge, sheet.primitive);
        if (!function || edge.edge != end.edge)
            continue;
        const bool is_tie = sgn(function->value_at(sample)) == 0;
        sheet.put(said("E of {} at {} = {}", edge.edge.text(), text(sample), function->at(sample)) +
                  (is_tie ? by_convention(sheet.trace()) : std::string()));
    }
}

void scanline(Sheet& sheet) {
    const auto row = sheet.step.as<ScanlineStep>();
    for (const EndOfRow& end : ends_of(row))
        put_crossing(sheet, end);
    for (const EndOfRow& end : ends_of(row))
        put_edge_function(sheet, end);
    put_boundaries(sheet, row);
    const auto left = row.left.exact();
    const auto right = row.right.exact();
    if (left && right && row.left_edge && *left != *right)
        sheet.put(said("{} {} {}: {} is left, {} is right", text(*left), *left < *right ? "<" : ">",
                       text(*right), row.left_edge.text(), row.right_edge.text()));
    const auto left_depth = row.left_depth.exact();
    const auto right_depth = row.right_depth.exact();
    // Where the depths of the ends lie: on the edges, or in the first and the last pixel.
    const bool has_rounded_ends = sheet.method().depth_at == DepthAt::rounded_ends;
    const auto offset = told_samples(sheet.trace()).triangles;
    const auto end_at = [&](Index pixel, const std::optional<Rational>& end) {
        return has_rounded_ends ? std::optional(Rational(pixel))
               : end            ? std::optional(offset.in_columns(*end))
                                : std::nullopt;
    };
    const auto first = end_at(row.from, left);
    const auto last = end_at(row.to, right);
    if (left_depth && right_depth && first && last && *first < *last)
        sheet.put(said("depth = {} + ({} {}) / ({} {}) (x {}) = {} {} (x {})", text(*left_depth),
                       text(*right_depth), minus(text(*left_depth)), text(*last),
                       minus(text(*first)), minus(text(*first)), text(*left_depth),
                       plus(text((*right_depth - *left_depth) / (*last - *first))),
                       minus(text(*first))));
    else if (left_depth && has_rounded_ends && row.from == row.to)
        sheet.put(said("one pixel: depth = {}", text(*left_depth)));
    if (row.from <= row.to)
        sheet.put(said("x = {} to {}: {} - {} + 1 = {}", row.from, row.to, row.to,
                       row.from < 0 ? fmt::format("({})", row.from) : std::to_string(row.from),
                       counted(static_cast<std::uint64_t>(row.to - row.from + 1), "pixel")));
}

/// Where a row of a polygon meets each edge, and what that adds to the winding number.
void crossings(Sheet& sheet) {
    const auto step = sheet.step.as<CrossingsStep>();
    const auto edges = step.edges.texts();
    const auto x = step.x.values();
    const auto winding = step.winding.values();
    const Rational y = told_samples(sheet.trace()).others.y_of(step.y);
    Rational before = 0;
    for (std::size_t i = 0; i < std::min({edges.size(), x.size(), winding.size()}); ++i) {
        const auto ends = ends_of_edge(sheet.primitive, edges[i]);
        const auto from = ends ? vec2_in(ends->from) : std::nullopt;
        const auto to = ends ? vec2_in(ends->to) : std::nullopt;
        const auto told = x[i].exact();
        const auto after = winding[i].exact();
        if (!from || !to || !told || !after)
            return;
        const Lerp lerp{.d1 = from->x, .i1 = from->y, .d2 = to->x, .i2 = to->y, .i = y};
        if (lerp.slope() && sheet.agrees(lerp.value(), *told))
            sheet.put(fmt::format("{}: {}{}", edges[i], x_of_edge, lerp.written_out(*told)));
        const Rational turn = *after - before;
        sheet.put(said("  the polygon runs {} along {}: {} {} = {}",
                       sgn(turn) > 0 ? said("down##run") : said("up##run"), edges[i], text(before),
                       plus(text(turn)), text(*after)));
        before = *after;
    }
}

/// Twice the areas that a point makes with the edges of a triangle, by one cross product (T3).
void sample(Sheet& sheet) {
    const auto of_sample = weights_of_sample(sheet.trace(), sheet.step, sheet.primitive);
    if (!of_sample)
        return;
    const auto& names = sheet.primitive.vertices;
    const Vec3 xs = of_sample->xs();
    const Vec3 ys = of_sample->ys();
    sheet.put(said("{} = {}, {} = {}, {} to {} = {}", edge_name(sheet.primitive, 0, 1),
                   text(Vec2{xs.x, ys.x}), edge_name(sheet.primitive, 0, 2), text(Vec2{xs.y, ys.y}),
                   text(of_sample->sample), names[0], text(Vec2{xs.z, ys.z})));
    sheet.put(of_sample->written_out());
    const auto [of_a, of_b, of_c] = *of_sample->value();
    sheet.put(said("divided by {}: u = {} of {}, v = {} of {}, 1 - u - v = {} of {}",
                   text(of_sample->areas().z), text(of_b), names[1], text(of_c), names[2],
                   text(of_a), names[0]));
}

/// The depth of a pixel on a line between its ends, along the major axis.
void put_depth_on_line(Sheet& sheet, const Rational& told) {
    const auto depth = sheet.form<Lerp>("depth");
    if (!depth || depth->i1 == depth->i2 || !sheet.agrees(depth->value(), told))
        return;
    sheet.put(said("depth = {} + ({} {}) ({} {}) / ({} {}) = {}", text(depth->d1), text(depth->d2),
                   minus(text(depth->d1)), text(depth->i), minus(text(depth->i1)), text(depth->i2),
                   minus(text(depth->i1)), text(told)));
}

/// The depth of a pixel on the plane through the three corners, if that is what decided.
void depth(Sheet& sheet) {
    const auto told = sheet.step.as<DepthStep>().depth.exact();
    if (!told)
        return;
    if (sheet.primitive.kind == PrimitiveKind::line)
        return put_depth_on_line(sheet, *told);
    const auto depths = numbers_in<3>(sheet.primitive.depths.texts());
    const auto of_sample = weights_of_sample(sheet.trace(), sheet.step, sheet.primitive);
    if (!depths || !of_sample)
        return;
    const auto weights = *of_sample->value();
    const MixedDepth mixed{.weights = {weights.begin(), weights.end()},
                           .depths = {depths->begin(), depths->end()}};
    if (!sheet.agrees(mixed.depth(), *told))
        return;
    const auto& [a, b, c] = of_sample->corners;
    const Rational area = of_sample->areas().z;
    const Rational dx = ((*depths)[1] - (*depths)[0]) * (c.y - a.y) / area -
                        ((*depths)[2] - (*depths)[0]) * (b.y - a.y) / area;
    const Rational dy = ((*depths)[2] - (*depths)[0]) * (b.x - a.x) / area -
                        ((*depths)[1] - (*depths)[0]) * (c.x - a.x) / area;
    sheet.put(said("plane through the corners: depth = {} x {} y {}", text(dx), plus(text(dy)),
                   plus(text((*depths)[0] - dx * a.x - dy * a.y))));
    sheet.put(said("depth = {}", mixed.written_out(*told)));
    write_plane_in_camera_space(sheet, of_sample->sample, *told);
}

/// d of a circle as the square of a distance, and what is added to it.
void put_circle_decision(Sheet& sheet, const CircleDecision& circle) {
    const Rational d = *sheet.step.as<DecideStep>().d.exact();
    const Rational r = sheet.primitive.radius.value_or(0);
    const auto& [x, y, increment] = circle;
    if ((x + 1) * (x + 1) + y * y - y - r * r == d)
        sheet.put(said("x = {}, y = {} from the center: d = (x + 1)^2 + y^2 - y - r^2 = {} = {}",
                       text(x), text(y),
                       fmt::format("{}^2 + {}^2 - {} - {}^2", text(Rational(x + 1)), text(y),
                                   text(y), text(r)),
                       text(d)));
    sheet.put(said("the midpoint ({}, {} - 1/2) lies {} the circle", text(Rational(x + 1)), text(y),
                   sgn(d) < 0 ? said("inside") : said("outside")));
    sheet.put(said("E adds 2 x + 3 = {}, SE 2 (x - y) + 5 = {}", text(Rational(2 * x + 3)),
                   text(Rational(2 * (x - y) + 5))));
    sheet.put(
        said("next d = {} {} = {}", text(d), plus(text(increment)), text(Rational(d + increment))));
}

/// Bresenham's increments, if the ends are pixels.
void decide(Sheet& sheet) {
    if (const auto circle =
            circle_decision(sheet.primitive, sheet.step.as<DecideStep>(), sheet.trace()))
        return put_circle_decision(sheet, *circle);
    const auto d = sheet.step.as<DecideStep>().d.exact();
    const auto ends = ends_of_line(sheet.at, sheet.primitive);
    const auto line = sheet.form<BresenhamDecisions>("d");
    if (!d || !ends || !line)
        return;
    const Rational dx = abs(ends->to.x - ends->from.x);
    const Rational dy = abs(ends->to.y - ends->from.y);
    const std::string_view major = dx < dy ? "dy" : "dx";
    const std::string_view minor = dx < dy ? "dx" : "dy";
    sheet.put(said("dx = {}, dy = {}: d begins at 2 {} - {} = {}", text(dx), text(dy), minor, major,
                   text(line->start())));
    if (const auto told = next_d_told(sheet.at); told && !sheet.agrees(line->next(*d), *told))
        return;
    sheet.put(said("straight on adds 2 {} = {}, diagonally 2 ({} - {}) = {}", minor,
                   text(line->straight()), minor, major, text(line->diagonal())));
    sheet.put(said("next d = {}", line->written_out(*d)));
}

void along(Sheet& sheet) {
    const auto step = sheet.step.as<AlongStep>();
    const auto value = step.value.exact();
    const auto lerp = sheet.form<Lerp>("value");
    const auto m_of_line = lerp ? lerp->slope() : std::nullopt;
    if (!value || !m_of_line || !sheet.agrees(lerp->value(), *value))
        return;
    const Rational& m = *m_of_line;
    const Rational b = lerp->d1 - m * lerp->i1;
    const bool is_x_major = step.x.has_value();
    const auto at = is_x_major ? step.x : step.y;
    const std::string_view major = is_x_major ? "x" : "y";
    const std::string_view minor = is_x_major ? "y" : "x";
    sheet.put(said("{} = m {} + b at both ends: {} = m ({}) + b, {} = m ({}) + b", minor, major,
                   text(lerp->d1), text(lerp->i1), text(lerp->d2), text(lerp->i2)));
    sheet.put(fmt::format("m = ({0}2 - {0}1)/({1}2 - {1}1) = ({2} {3})/({4} {5}) = {6}, "
                          "b = {0}1 - m {1}1 = {7} - {8} = {9}",
                          minor, major, text(lerp->d2), minus(text(lerp->d1)), text(lerp->i2),
                          minus(text(lerp->i1)), text(m), text(lerp->d1), product(m, lerp->i1),
                          text(b)));
    const std::size_t before =
        sheet.trace().method.others.line == LineMethod::dda ? along_before(sheet.at) : 0;
    const auto step_before = before == 0 ? AlongStep{} : sheet.trace().step(before).as<AlongStep>();
    const auto last = step_before.value.exact();
    const auto last_at = is_x_major ? step_before.x : step_before.y;
    if (last && last_at)
        sheet.put(said("{} = the last one {} = {} {} = {}", minor, *at > *last_at ? "+ m" : "- m",
                       text(*last), plus(text(m * (*at - *last_at))), text(*value)));
    else
        sheet.put(fmt::format("{} = m {} + b = {} {} = {}", minor, major, product(m, lerp->i),
                              plus(text(b)), text(*value)));
}

void write_working(Sheet& sheet);

/// Why the pixel is drawn, once more, and where it lies in memory: four bytes a pixel, row by row from
/// the top left (T2).
void pixel(Sheet& sheet) {
    const Canvas& canvas = sheet.trace().canvas;
    const auto plotted = sheet.step.as<PixelStep>();
    if (!canvas.contains(plotted.x, plotted.y))
        return;
    const std::size_t reason = reason_of_pixel(sheet.at);
    if (reason != 0) {
        Sheet of_reason(sheet.at.at(reason));
        write_working(of_reason);
        sheet.put(said("because of step {}", sheet.trace().number_of(reason)) +
                  what_numbers_give(sheet.trace(), reason) + place_in_code(sheet.trace(), reason));
        for (std::string& line : of_reason.lines)
            sheet.put(std::move(line));
    }
    write_color(sheet);
    const Index column = plotted.x - canvas.left();
    const Index row = canvas.row_of(plotted.y);
    sheet.put(said("column {}, row {} from the top left: byte 4 ({} ({}) + {}) = {}", column, row,
                   canvas.width, row, column, 4 * (canvas.width * row + column)));
}

/// A kind of step and what writes its working.
struct Row {
    StepKind kind;
    void (*write)(Sheet& sheet);
};
constexpr Row rows_of_kinds[] = {
    {StepKind::matrix, write_matrix},
    {StepKind::vertex, write_vertex},
    {StepKind::order, order},
    {StepKind::primitive, primitive},
    {StepKind::face, write_face},
    {StepKind::light, write_light},
    {StepKind::edge, edge},
    {StepKind::crossings, crossings},
    {StepKind::scanline, scanline},
    {StepKind::along, along},
    {StepKind::decide, decide},
    {StepKind::sample, sample},
    {StepKind::depth, depth},
    {StepKind::pixel, pixel},
    {StepKind::triangulate, write_triangulation},
    {StepKind::ray, write_ray},
};

/// The working of the sheet's step.
void write_working(Sheet& sheet) {
    const auto kind = sheet.step.kind();
    for (const Row& row : rows_of_kinds)
        if (kind == row.kind)
            row.write(sheet);
}

} // namespace

std::vector<std::string> working_of(const Replay& replay) {
    if (replay.step() == 0)
        return {};
    Sheet sheet(replay, replay.drew_over());
    write_working(sheet);
    for (std::string& line : sheet.lines)
        line = printable(line);
    return std::move(sheet.lines);
}

std::string as_in_working(std::string_view numbers) {
    std::vector<std::string> parts;
    for (const std::string& part : split_at(numbers, ',')) {
        const std::size_t first = std::min(part.find_first_not_of(' '), part.size());
        parts.push_back(part.substr(0, first) + in_sentence(part.substr(first)));
    }
    return joined(parts, ",");
}

} // namespace rastertrace
