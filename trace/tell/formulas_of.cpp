// SPDX-License-Identifier: MIT
#include "formulas_of.h"

#include "describe.h"
#include "told_samples.h"

#include <rastertrace/trace/record/traced_steps.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string>
#include <utility>

namespace rastertrace {

namespace {

using Formulas = std::vector<Formula>;

/// From the integer points of a primitive's pixels to their samples.
SampleOffset<Rational> offset_of(const Trace& trace, std::size_t primitive) {
    const ToldSamples samples = told_samples(trace);
    return primitive == 0 ? samples.triangles
                          : samples.of(trace.step(primitive).as<PrimitiveStep>().kind);
}

/// The name of the edge that an end of a row, "left" or "right", lies on.
std::string edge_of_end(const ScanlineStep& row, const std::string& side) {
    return (side == "left" ? row.left_edge : row.right_edge).text();
}

/// Of samples, a row has those from its left end on, up to the one before its right end.
RoundedEnd rounded_end(const Numbers& numbers, std::size_t row, const std::string& side) {
    const Trace& trace = numbers.trace();
    const Method& method = trace.method.triangles;
    const auto x = numbers.one(row, side);
    const bool is_by_samples = traits_of(method.fill).rule == PixelRule::samples;
    const auto offset = offset_of(trace, numbers.steps().primitive_of(row));
    return {.x = offset.in_columns(x.value_or(0)),
            .rule = is_by_samples ? SpanRounding{.rounding = Rounding::half_open}
                                  : span_rounding(method),
            .is_last = side == "right"};
}

/// The rows of matrices, one behind the other; none if one holds no numbers.
std::vector<MatrixTimes::Row> matrix_rows(const TracedList<TracedList<TracedNumber>>& lists) {
    std::vector<MatrixTimes::Row> rows;
    for (const auto& list : lists.values()) {
        const auto entries = list.values();
        MatrixTimes::Row& row = rows.emplace_back();
        for (std::size_t i = 0; i < row.size(); ++i) {
            const auto entry = i < entries.size() ? entries[i].exact() : std::nullopt;
            if (!entry)
                return {};
            row[i] = *entry;
        }
    }
    return rows;
}

/// A share of the way from one depth to another, held between them.
MixedDepth between(const Rational& first, const Rational& last, const Rational& at,
                   const Rational& d1, const Rational& d2) {
    if (first >= last)
        return {.weights = {1}, .depths = {d1}};
    const Rational share =
        std::clamp(Rational((at - first) / (last - first)), Rational(0), Rational(1));
    return {.weights = {1 - share, share}, .depths = {d1, d2}};
}

/// The formulas of one step's fields.
class Deriver {
public:
    Deriver(const Numbers& numbers, std::size_t step)
        : numbers_(numbers), at_(numbers.steps().at(step)), step_(step), view_(numbers.step(step)),
          primitive_step_(at_.primitive()), primitive_(primitive_of(at_)) {}

    Formulas of_edge() const {
        const auto edge = edge_named(view_.as<EdgeStep>().edge.text());
        if (!edge)
            return {};
        return {{Slope{edge->from, edge->to, edge->other}}};
    }

    /// Of an edge, or of a primitive that is a line.
    Formulas of_form(bool is_of_y) const {
        if (view_.kind() == StepKind::edge) {
            const auto edge = edge_named(view_.as<EdgeStep>().edge.text());
            return edge ? Formulas{{LineForm{edge->from, edge->to, is_of_y}}} : Formulas{};
        }
        const auto line = ends_of_primitive();
        return line ? Formulas{{LineForm{line->from, line->to, is_of_y}}} : Formulas{};
    }

    /// On the edge; or one slope on from the row before or behind, which may be what somebody did.
    Formulas of_row_end(const std::string& side) const {
        const auto row = view_.as<ScanlineStep>();
        const std::string name = edge_of_end(row, side);
        const auto edge = edge_named(name);
        if (!edge)
            return {};
        const Rational y = sample_y(row.y);
        Lerp lerp{
            .d1 = edge->from.x, .i1 = edge->from.y, .d2 = edge->to.x, .i2 = edge->to.y, .i = y};
        if (edge->other)
            lerp.other = {edge->other->x, edge->other->y};
        Formulas formulas{{lerp}};
        const auto slope = numbers_.one(edge_step(name), "dx_dy");
        if (!slope)
            return formulas;
        Lerp by_slope = lerp;
        by_slope.step = slope;
        formulas.push_back({by_slope});
        if (!numbers_.takes_only_claims())
            return formulas;
        for (const int rows : {1, -1})
            for (const std::size_t n : at_.in_primitive(StepKind::scanline)) {
                const auto beside = numbers_.step(n).as<ScanlineStep>();
                for (const std::string one : {"left", "right"})
                    if (beside.y == row.y + rows && edge_of_end(beside, one) == name)
                        if (const auto x = numbers_.one(n, one))
                            formulas.push_back({Lerp{.d1 = *x,
                                                     .i1 = y + rows,
                                                     .d2 = edge->to.x,
                                                     .i2 = edge->to.y,
                                                     .i = y,
                                                     .step = slope}});
            }
        return formulas;
    }

    Formulas of_row_depth(const std::string& side) const {
        const auto row = view_.as<ScanlineStep>();
        const auto edge = edge_named(edge_of_end(row, side));
        const Values depths = numbers_.of(primitive_step_, "depths");
        if (!edge || depths.size() != 3)
            return {};
        Lerp lerp{.d1 = depths[edge->corners[0]],
                  .i1 = edge->from.y,
                  .d2 = depths[edge->corners[1]],
                  .i2 = edge->to.y,
                  .i = sample_y(row.y),
                  .is_inverse_z = has_inverse_z()};
        if (edge->other)
            lerp.other = {depths[3 - edge->corners[0] - edge->corners[1]], edge->other->y};
        return {{lerp}};
    }

    Formulas of_row_pixel(const std::string& field) const {
        const std::string side = field == "from" ? "left" : "right";
        RoundedEnd end = rounded_end(numbers_, step_, side);
        const std::string edge = edge_of_end(view_.as<ScanlineStep>(), side);
        end.per_row = numbers_.one(edge_step(edge), "dx_dy").value_or(0);
        return {{end}};
    }

    Formulas of_place() const {
        const auto vertex = view_.as<VertexStep>();
        const Values right = numbers_.right().of(step_, "at");
        const auto& places = at_.places_of(vertex.name.text());
        const auto here = std::lower_bound(places.begin(), places.end(), step_);
        const std::size_t before = here == places.begin() ? 0 : *std::prev(here);
        Values from = numbers_.of(before, "at");
        if (vertex.space == Space::canonical && from.size() == 4)
            return {{DividedByW{{from[0], from[1], from[2], from[3]}}}};
        if (from.empty())
            return {{TakenOver{right}}};
        Values told_from = numbers_.right().of(before, "at");
        for (Values* const point : {&from, &told_from})
            as_before_matrix(*point, vertex.space == Space::screen);
        const std::vector<MatrixStep> matrices = matrices_of(vertex);
        if (matrices.empty()) {
            from.resize(std::min(from.size(), right.size()));
            return {{TakenOver{from}}};
        }
        if (from.size() != 4)
            return {};
        std::optional<MatrixTimes> nearest;
        Rational least;
        for (const MatrixStep& step : matrices) {
            const auto matrix = exact_matrix_in(step);
            if (!matrix || right.size() > matrix->rows.size())
                continue;
            const auto* const rows = matrix->rows.data();
            MatrixTimes product{.rows = {rows, rows + right.size()},
                                .point = {from[0], from[1], from[2], from[3]},
                                .factors = factors_in(step),
                                .is_viewport = step.name == "viewport"};
            MatrixTimes told = product;
            std::copy(told_from.begin(), told_from.end(), told.point.begin());
            Rational distance;
            for (std::size_t i = 0; i < right.size(); ++i)
                distance += abs(told.value(i) - right[i]);
            if (!nearest || distance < least) {
                nearest = std::move(product);
                least = distance;
            }
        }
        return nearest ? Formulas{{std::move(*nearest)}} : Formulas{};
    }

    Formulas of_snapped() const {
        const Snap snap = method().snap;
        const Rounding rounding = snap == Snap::floor      ? Rounding::floor
                                  : snap == Snap::truncate ? Rounding::truncate
                                                           : Rounding::nearest;
        return {{RoundedPlace{numbers_.of(step_, "at"), {.rounding = rounding}}}};
    }

    Formulas of_face(std::string_view field) const {
        const bool is_light = view_.kind() == StepKind::light;
        const std::string_view to = is_light ? "light" : "view";
        const auto normal = vector_in("normal");
        const auto view = vector_in(to);
        const auto corners = world_corners();
        if (field == "dot" && normal && view)
            return {{FaceDot{*normal, *view}}};
        if ((field == "cosine" || field == "intensity") && normal && view)
            return {{FaceCosine{*normal, *view, numbers_.one(step_, "dot"), field == "intensity"}}};
        if (field == "culled")
            if (const auto dot = numbers_.one(step_, "dot"))
                return {{IsCulled{*dot, method().cull != Cull::front}}};
        if (!corners)
            return {};
        if (field == "normal")
            return {{FaceNormal{*corners}}};
        if (field == "plane" && normal)
            return {{FacePlane{*normal, (*corners)[0]}}};
        const Formula centroid{Centroid{*corners}};
        if (field == "centroid")
            return {centroid};
        // The eye is where the trace's own view and centroid say.
        const Numbers& told = numbers_.right();
        const auto true_corners = Deriver(told, step_).world_corners();
        const Values true_view = told.of(step_, to);
        const Values claimed = numbers_.of(step_, "centroid");
        const Values middle = claimed.size() == 3 ? claimed : value_of(centroid);
        if (field != to || !true_corners || true_view.size() != 3 || !normal)
            return {};
        const Values true_middle = value_of({Centroid{*true_corners}});
        return {{Toward{.to = {true_view[0] + true_middle[0], true_view[1] + true_middle[1],
                               true_view[2] + true_middle[2]},
                        .centroid = {middle[0], middle[1], middle[2]},
                        .corners = *corners,
                        .normal = *normal}}};
    }

    Formulas of_decisions() const {
        const auto ends = ends_of_line(at_, primitive_);
        const auto line = ends ? decisions_between(numbers_.trace(), *ends) : std::nullopt;
        return line ? Formulas{{*line}} : Formulas{};
    }

    /// Those of a line that Bresenham draws.
    Formulas of_pixels() const {
        const auto steps = pixels_of(at_, step_);
        auto ends = ends_of_line(at_, primitive_);
        const auto line = ends ? decisions_between(numbers_.trace(), *ends) : std::nullopt;
        if (!line || steps.empty() ||
            !numbers_.trace().method.draws_lines_by(LineMethod::bresenham) ||
            primitive_.kind != PrimitiveKind::line)
            return {};
        const StepView first = numbers_.step(steps.front());
        if (x_in(first) != ends->from.x || y_in(first) != ends->from.y)
            std::swap(ends->from, ends->to);
        const Vec2 way{ends->to.x - ends->from.x, ends->to.y - ends->from.y};
        const Vec2 diagonal{sgn(way.x), sgn(way.y)};
        const bool is_x_major = abs(way.x) >= abs(way.y);
        return {{LinePixels{.decisions = *line,
                            .from = ends->from,
                            .straight = is_x_major ? Vec2{diagonal.x, 0} : Vec2{0, diagonal.y},
                            .diagonal = diagonal}}};
    }

    /// How many rows a primitive has, or how many pixels a line.
    Formulas of_count(std::string_view field) const {
        const auto steps = pixels_of(at_, step_);
        const bool is_line = primitive_.kind == PrimitiveKind::line;
        if (steps.empty() || (field == "pixel_count" && !is_line))
            return {};
        const auto between = [&](const auto& coordinate) {
            const auto [low, high] =
                std::minmax_element(steps.begin(), steps.end(), [&](std::size_t a, std::size_t b) {
                    return coordinate(numbers_.step(a)) < coordinate(numbers_.step(b));
                });
            return InclusiveCount{*coordinate(numbers_.step(*low)),
                                  *coordinate(numbers_.step(*high))};
        };
        const InclusiveCount rows = between([](const StepView& step) { return y_in(step); });
        const InclusiveCount columns = between([](const StepView& step) { return x_in(step); });
        const bool is_by_column =
            field == "pixel_count" && columns.last - columns.first > rows.last - rows.first;
        InclusiveCount count = is_by_column ? columns : rows;
        count.is_of_rows = field == "row_count";
        return {{count}};
    }

    Formulas of_row_count() const {
        const auto first = numbers_.one(step_, "from");
        const auto last = numbers_.one(step_, "to");
        return first && last ? Formulas{{InclusiveCount{*first, *last}}} : Formulas{};
    }

    /// Of a pixel on a line with two colors, or in a triangle with three.
    Formulas of_color() const {
        const bool is_cut = method().color_rounding == ColorRounding::truncate;
        if (const auto line = color_on_line(at_, primitive_)) {
            const auto weights = [&](ColorLerp lerp) {
                const Rational share = line->share_by(lerp);
                return std::vector<Rational>{1 - share, share};
            };
            return {{MixedColor{.corners = {line->from, line->to},
                                .weights = weights(line->lerp),
                                .is_cut = is_cut,
                                .other_weights =
                                    weights(line->lerp == ColorLerp::axis ? ColorLerp::distance
                                                                          : ColorLerp::axis)}}};
        }
        const auto triangle = corners();
        const auto sample = sample_of(numbers_.trace(), view_);
        if (!triangle || !sample || primitive_.colors.values().size() != 3)
            return {};
        MixedColor mixed{
            .corners = {}, .weights = value_of({Weights{*triangle, *sample}}), .is_cut = is_cut};
        for (std::size_t i = 0; i < 3; ++i)
            mixed.corners.push_back(primitive_.color_of(i).value_or(Color()));
        if (const auto divisors = divisors_of(at_, primitive_))
            if (auto in_space = shares_in_space(mixed.weights, *divisors))
                mixed.other_weights = std::exchange(mixed.weights, std::move(in_space->shares));
        return mixed.weights.empty() ? Formulas{} : Formulas{{std::move(mixed)}};
    }

    /// Of a sample in a triangle.
    Formulas of_inside() const {
        const auto triangle = corners();
        const auto sample = sample_of(numbers_.trace(), view_);
        if (!triangle || !sample)
            return {};
        return {{InTriangle{{*triangle, *sample}, view_.as<SampleStep>().inside.is_true()}}};
    }

    /// A line's other coordinate where it is at x or y.
    Formulas of_along() const {
        const auto along = view_.as<AlongStep>();
        const auto at = along.x ? along.x : along.y;
        const auto line = primitive_.kind == PrimitiveKind::line ? ends_of_primitive()
                                                                 : ends_of_line(at_, primitive_);
        if (!line || !at)
            return {};
        const bool is_x_major = along.x.has_value();
        return {{lerp_on(*line, is_x_major, sample_of_lines(numbers_.trace(), is_x_major, *at))}};
    }

    Formulas of_weights() const {
        const auto triangle = corners();
        const auto sample = sample_of(numbers_.trace(), view_);
        if (!triangle || !sample)
            return {};
        return {{Weights{*triangle, *sample}}};
    }

    /// `as_z` and `as_inverse`: not the depth of the trace, but z, or 1/z.
    Formulas of_depth(bool as_z, bool as_inverse) const {
        if (primitive_.kind == PrimitiveKind::line)
            return as_z || as_inverse ? Formulas{} : depth_on_line();
        std::optional<MixedDepth> mixed = depth_in_row();
        const std::optional<MixedDepth> by_corners = depth_in_triangle();
        if (!mixed)
            mixed = by_corners;
        if (!mixed)
            return {};
        if (by_corners) {
            mixed->corner_weights = by_corners->weights;
            mixed->corner_depths = by_corners->depths;
        }
        mixed->gives_inverse = has_inverse_z() ? as_z : as_inverse;
        return {{std::move(*mixed)}};
    }

    Formulas of_depth_test() const {
        const auto depth = numbers_.one(step_, "depth");
        const auto stored = numbers_.one(step_, "stored");
        const auto larger = larger_depth_passes(numbers_.trace(), step_);
        if (!depth || !stored || !larger)
            return {};
        return {{DepthComparison{*depth, *stored, *larger}}};
    }

private:
    /// A point with its w, as a matrix takes it; on the way to the screen divided by that, if no step has told so.
    static void as_before_matrix(Values& point, bool to_screen) {
        if (point.size() == 3)
            point.emplace_back(1);
        if (to_screen && point.size() == 4 && sgn(point[3]) != 0) {
            const Rational w = point[3];
            for (Rational& coordinate : point)
                coordinate /= w;
        }
    }

    /// Those that lead to where a vertex is: of its mesh, if one is. Meshes without a name do not say whose a matrix is.
    std::vector<MatrixStep> matrices_of(const VertexStep& vertex) const {
        const std::string name = vertex.name.text();
        const std::size_t point = name.rfind('.');
        std::vector<MatrixStep> own, others;
        for (const std::size_t n : at_.matrices())
            if (auto step = numbers_.step(n).as<MatrixStep>();
                step.name == matrix_into(vertex.space.text())) {
                if (point != std::string::npos && step.object == name.substr(0, point))
                    own.push_back(step);
                else if (!step.object)
                    others.push_back(step);
            }
        return own.empty() ? others : own;
    }

    struct Edge {
        Vec2 from;
        Vec2 to;
        std::optional<Vec2> other;
        std::array<std::size_t, 2> corners; ///< which of the primitive's they are
    };

    /// An edge of the step's primitive, found by its name.
    std::optional<Edge> edge_named(const std::string& name) const {
        const auto ends = ends_of_edge(primitive_, name);
        const auto from = ends ? corner(ends->vertices[0]) : std::nullopt;
        const auto to = ends ? corner(ends->vertices[1]) : std::nullopt;
        if (!from || !to)
            return std::nullopt;
        const auto [first, second] = ends->vertices;
        const bool has_other = primitive_.vertices.size() == 3;
        return Edge{
            *from, *to, has_other ? corner(3 - first - second) : std::nullopt, {first, second}};
    }

    /// The first `edge` step of an edge in the step's primitive.
    std::size_t edge_step(const std::string& name) const {
        for (const std::size_t n : at_.in_primitive(StepKind::edge))
            if (numbers_.step(n).as<EdgeStep>().edge == name)
                return n;
        return 0;
    }

    std::optional<Vec2> corner(std::size_t i) const { return numbers_.corner(primitive_, i); }

    /// Of a primitive that is a line.
    std::optional<LineEnds> ends_of_primitive() const {
        const auto from = corner(0);
        const auto to = corner(1);
        return primitive_.kind == PrimitiveKind::line && from && to
                   ? std::optional(LineEnds{*from, *to})
                   : std::nullopt;
    }

    /// Of a row of the step's primitive.
    Rational sample_y(Index row) const {
        return told_samples(numbers_.trace()).of(primitive_.kind).y_of(row);
    }

    std::optional<std::vector<Vec3>> world_corners() const {
        return numbers_.corners_in(primitive_.vertices, Space::world);
    }

    std::optional<std::array<Vec2, 3>> corners() const {
        std::array<Vec2, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto one = corner(i);
            if (!one)
                return std::nullopt;
            corners[i] = *one;
        }
        return corners;
    }

    /// Of a pixel on a line between its ends, along the major axis.
    Formulas depth_on_line() const {
        const auto line = ends_of_line(at_, primitive_);
        const Values depths = numbers_.of(primitive_step_, "depths");
        if (!line || depths.size() != 2)
            return {};
        const auto test = view_.as<DepthStep>();
        const bool is_x_major = abs(line->to.x - line->from.x) >= abs(line->to.y - line->from.y);
        const Rational& from = is_x_major ? line->from.x : line->from.y;
        const Rational& to = is_x_major ? line->to.x : line->to.y;
        const Rational at =
            sample_of_lines(numbers_.trace(), is_x_major, is_x_major ? test.x : test.y);
        return {{Lerp{.d1 = depths[0],
                      .i1 = from,
                      .d2 = depths[1],
                      .i2 = to,
                      .i = std::clamp(at, std::min(from, to), std::max(from, to)),
                      .is_inverse_z = has_inverse_z()}}};
    }

    /// From the ends of the row that a depth test lies in, as fills along the edges do.
    std::optional<MixedDepth> depth_in_row() const {
        const auto test = view_.as<DepthStep>();
        const std::size_t row = at_.scanline();
        if (row == 0 || numbers_.step(row).as<ScanlineStep>().y != test.y)
            return std::nullopt;
        const auto left_depth = numbers_.one(row, "left_depth");
        const auto right_depth = numbers_.one(row, "right_depth");
        const bool is_rounded = method().depth_at == DepthAt::rounded_ends;
        const auto first = numbers_.one(row, is_rounded ? "from" : "left");
        const auto last = numbers_.one(row, is_rounded ? "to" : "right");
        if (!left_depth || !right_depth || !first || !last)
            return std::nullopt;
        const auto offset = told_samples(numbers_.trace()).triangles;
        const Rational x = is_rounded ? Rational(test.x) : offset.x_of(test.x);
        return between(*first, *last, x, *left_depth, *right_depth);
    }

    /// From the depths of all three corners, as a plane over the screen.
    std::optional<MixedDepth> depth_in_triangle() const {
        const auto triangle = corners();
        const auto sample = sample_of(numbers_.trace(), view_);
        const Values depths = numbers_.of(primitive_step_, "depths");
        if (!triangle || !sample || depths.size() != 3)
            return std::nullopt;
        const Values weights = value_of({Weights{*triangle, *sample}});
        return weights.empty() ? std::nullopt
                               : std::optional(MixedDepth{.weights = weights, .depths = depths});
    }

    std::optional<Vec3> vector_in(std::string_view field) const {
        const Values values = numbers_.of(step_, field);
        return values.size() == 3 ? std::optional(Vec3{values[0], values[1], values[2]})
                                  : std::nullopt;
    }

    const Method& method() const { return numbers_.trace().method.triangles; }
    bool has_inverse_z() const { return method().depth == Depth::inverse_z; }

    const Numbers& numbers_;
    StepContext at_;
    std::size_t step_;
    StepView view_;
    std::size_t primitive_step_;
    PrimitiveText primitive_;
};

/// An end of a row as it was claimed, if somebody has.
RoundedEnd end_in_row(const Numbers& numbers, std::size_t row, const std::string& side) {
    const std::string pixel = side == "left" ? "from" : "to";
    const auto claimed = numbers.one(row, pixel);
    if (claimed && claimed != numbers.right().one(row, pixel))
        return {.x = *claimed, .rule = {.rounding = Rounding::floor}};
    return rounded_end(numbers, row, side);
}

} // namespace

std::optional<Matrix<Rational>> exact_matrix_in(const MatrixStep& step) {
    const auto rows = matrix_rows(step.rows);
    return rows.size() == 4 ? std::optional(Matrix<Rational>{{rows[0], rows[1], rows[2], rows[3]}})
                            : std::nullopt;
}

std::vector<MatrixTimes::Factor> factors_in(const MatrixStep& step) {
    const auto names = step.factors.texts();
    const auto rows = matrix_rows(step.factor_rows);
    std::vector<MatrixTimes::Factor> factors;
    for (std::size_t i = 0; i < names.size() && 4 * i + 3 < rows.size(); ++i)
        factors.push_back(
            {names[i], {rows[4 * i], rows[4 * i + 1], rows[4 * i + 2], rows[4 * i + 3]}});
    return factors;
}

std::vector<std::size_t> pixels_of(const StepContext& steps, std::size_t primitive) {
    const Trace& trace = steps.trace();
    const std::string name = name_in(trace.step(primitive)).text();
    std::vector<std::size_t> pixels;
    std::set<std::pair<Index, Index>> seen;
    const auto& primitives = steps.all_of(StepKind::primitive);
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const std::string one = name_in(trace.step(primitives[i])).text();
        if (one != name && !one.starts_with(name + "/")) // a part of it
            continue;
        const std::size_t last = i + 1 < primitives.size() ? primitives[i + 1] - 1 : trace.size();
        for (const std::size_t n :
             trace.steps_of({StepKind::pixel, StepKind::depth}, primitives[i], last))
            if (seen.emplace(y_in(trace.step(n)).value_or(0), x_in(trace.step(n)).value_or(0))
                    .second)
                pixels.push_back(n);
    }
    return pixels;
}

Formula in_row(const Numbers& numbers, std::size_t row, Rational x) {
    return {
        InRow{end_in_row(numbers, row, "left"), end_in_row(numbers, row, "right"), std::move(x)}};
}

std::vector<Formula> formulas_of(const Numbers& numbers, std::size_t step, std::string_view field) {
    if (step == 0)
        return {};
    const Deriver of(numbers, step);
    const std::string name(field);
    const auto kind = numbers.trace().kind_of(step);
    if (!kind)
        return {};
    switch (*kind) {
    case StepKind::edge:
        return name == "dx_dy"                        ? of.of_edge()
               : name == "y_form" || name == "x_form" ? of.of_form(name == "x_form")
                                                      : Formulas{};
    case StepKind::primitive:
        return name == "y_form" || name == "x_form"           ? of.of_form(name == "x_form")
               : name == "pixels"                             ? of.of_pixels()
               : name == "row_count" || name == "pixel_count" ? of.of_count(name)
                                                              : Formulas{};
    case StepKind::pixel:
        return name == "color" ? of.of_color() : Formulas{};
    case StepKind::scanline:
        if (name == "left" || name == "right")
            return of.of_row_end(name);
        if (name == "left_depth" || name == "right_depth")
            return of.of_row_depth(name.substr(0, name.find('_')));
        return name == "from" || name == "to" ? of.of_row_pixel(name)
               : name == "pixel_count"        ? of.of_row_count()
                                              : Formulas{};
    case StepKind::vertex:
        return name == "at" ? of.of_place() : name == "snapped" ? of.of_snapped() : Formulas{};
    case StepKind::face:
    case StepKind::light:
        return of.of_face(name);
    case StepKind::decide:
        return name == "d" ? of.of_decisions() : Formulas{};
    case StepKind::along:
        return name == "value" ? of.of_along() : Formulas{};
    case StepKind::sample:
        return name == "weights" ? of.of_weights() : name == "inside" ? of.of_inside() : Formulas{};
    case StepKind::depth:
        return name == "depth" || name == "z" || name == "inverse_z"
                   ? of.of_depth(name == "z", name == "inverse_z")
               : name == "pass" ? of.of_depth_test()
                                : Formulas{};
    default:
        return {};
    }
}

} // namespace rastertrace
