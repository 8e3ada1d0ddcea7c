// SPDX-License-Identifier: MIT
#include "derivation.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/tell/told_samples.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
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
    const auto offset = offset_of(trace, numbers.index().primitive_of(row));
    return {.x = offset.in_columns(x.value_or(0)),
            .rule = is_by_samples ? SpanRounding{.rounding = Rounding::half_open}
                                  : span_rounding(method),
            .is_last = side == "right"};
}

/// The rows of matrices, one behind the other.
std::vector<MatrixTimes::Row> matrix_rows(const TracedList<TracedList<TracedNumber>>& lists) {
    std::vector<MatrixTimes::Row> rows;
    for (const auto& list : lists.values()) {
        const auto entries = list.values();
        MatrixTimes::Row& row = rows.emplace_back();
        for (std::size_t i = 0; i < 4 && i < entries.size(); ++i)
            row[i] = entries[i].exact().value_or(0);
    }
    return rows;
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

/// The longest line whose decisions are worked out.
constexpr int most_decisions = 1000;

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
        : numbers_(numbers), step_(step), view_(numbers.step(step)),
          primitive_(numbers.index().primitive_of(step)) {}

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
        const auto from = numbers_.corner(step_, 0);
        const auto to = numbers_.corner(step_, 1);
        const bool is_line = view_.as<PrimitiveStep>().kind == PrimitiveKind::line;
        return is_line && from && to ? Formulas{{LineForm{*from, *to, is_of_y}}} : Formulas{};
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
        for (const int rows : {1, -1}) {
            const std::string beside = std::to_string(row.y + rows);
            for (const std::size_t n : numbers_.index().find(StepKind::scanline, {{"y", beside}}))
                for (const std::string one : {"left", "right"})
                    if (numbers_.index().primitive_of(n) == primitive_ &&
                        edge_of_end(numbers_.step(n).as<ScanlineStep>(), one) == name)
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
        const Values depths = numbers_.of(primitive_, "depths");
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
        const auto space = view_.as<VertexStep>().space;
        const Values right = Numbers(numbers_.index()).of(step_, "at");
        const std::size_t before = numbers_.index().place_before(step_);
        Values from = numbers_.of(before, "at");
        if (space == Space::canonical && from.size() == 4)
            return {{DividedByW{{from[0], from[1], from[2], from[3]}}}};
        const std::string matrix(matrix_into(space.text()));
        if (from.empty())
            return {{TakenOver{right}}};
        if (numbers_.index().find(StepKind::matrix, {{"name", matrix}}).empty()) {
            from.resize(std::min(from.size(), right.size()));
            return {{TakenOver{from}}};
        }
        if (from.size() == 3)
            from.emplace_back(1);
        if (from.size() != 4)
            return {};
        Formulas formulas;
        // Of several objects, the matrix is that of the one which the vertex belongs to: it gives what is told.
        const Values told_from = Numbers(numbers_.index()).of(before, "at");
        for (const std::size_t n : numbers_.index().find(StepKind::matrix, {{"name", matrix}})) {
            MatrixTimes product{.rows = {}, .point = {from[0], from[1], from[2], from[3]}};
            const auto step = numbers_.step(n).as<MatrixStep>();
            for (const MatrixTimes::Row& row : matrix_rows(step.rows))
                if (product.rows.size() < right.size())
                    product.rows.push_back(row);
            product.factors = factors_in(step);
            product.is_viewport = matrix == "viewport";
            MatrixTimes told = product;
            std::copy(told_from.begin(), told_from.end(), told.point.begin());
            const Values of_told = value_of({told});
            bool is_this = of_told.size() == right.size();
            for (std::size_t i = 0; is_this && i < right.size(); ++i)
                is_this = agrees(of_told[i], right[i], numbers_.trace());
            if (is_this)
                formulas.push_back({product});
        }
        return formulas;
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
        const auto corners = world_corners(primitive_);
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
        const Numbers told(numbers_.index());
        const auto true_corners = Deriver(told, step_).world_corners(primitive_);
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
        Replay replay(numbers_.trace());
        replay.go_to(step_);
        const auto ends = ends_of_line(replay, primitive_of(replay));
        if (!ends)
            return {};
        const auto line = decisions_between(numbers_.trace(), *ends);
        if (!line || line->major > most_decisions)
            return {}; // no hand works that out
        return {{*line}};
    }

    /// Those of a line that Bresenham draws.
    Formulas of_pixels() const {
        Replay replay(numbers_.trace());
        replay.go_to(step_);
        const auto steps = numbers_.index().pixels_of(step_);
        auto ends = ends_of_line(replay, primitive_of(replay));
        const auto line = ends ? decisions_between(numbers_.trace(), *ends) : std::nullopt;
        if (!line || steps.empty() || line->major > most_decisions ||
            !numbers_.trace().method.draws_lines_by(LineMethod::bresenham) ||
            view_.as<PrimitiveStep>().kind != PrimitiveKind::line)
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
        const auto steps = numbers_.index().pixels_of(step_);
        const bool is_line = view_.as<PrimitiveStep>().kind == PrimitiveKind::line;
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
        Replay replay(numbers_.trace());
        replay.go_to(step_);
        const PrimitiveText primitive = primitive_of(replay);
        if (const auto line = color_on_line(replay, primitive)) {
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
        if (!triangle || !sample || primitive.colors.values().size() != 3)
            return {};
        MixedColor mixed{
            .corners = {}, .weights = value_of({Weights{*triangle, *sample}}), .is_cut = is_cut};
        for (std::size_t i = 0; i < 3; ++i)
            mixed.corners.push_back(primitive.color_of(i).value_or(Color()));
        if (const auto divisors = divisors_of(replay, primitive))
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
        const auto from = numbers_.corner(primitive_, 0);
        const auto to = numbers_.corner(primitive_, 1);
        if (!from || !to || !at ||
            numbers_.step(primitive_).as<PrimitiveStep>().kind != PrimitiveKind::line)
            return {};
        const Rational i = sample_of_lines(numbers_.trace(), along.x.has_value(), *at);
        Lerp lerp{.d1 = from->y, .i1 = from->x, .d2 = to->y, .i2 = to->x, .i = i};
        if (!along.x)
            lerp = {.d1 = from->x, .i1 = from->y, .d2 = to->x, .i2 = to->y, .i = i};
        return {{lerp}};
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
    struct Edge {
        Vec2 from;
        Vec2 to;
        std::optional<Vec2> other;
        std::array<std::size_t, 2> corners; ///< which of the primitive's they are
    };

    /// An edge of the step's primitive, found by its name.
    std::optional<Edge> edge_named(const std::string& name) const {
        if (primitive_ == 0)
            return std::nullopt;
        const PrimitiveText text = primitive_in(numbers_.step(primitive_));
        for (std::size_t i = 0; i < text.vertices.size(); ++i)
            for (std::size_t k = 0; k < text.vertices.size(); ++k) {
                if (i == k || edge_name(text, i, k) != name)
                    continue;
                const auto from = numbers_.corner(primitive_, i);
                const auto to = numbers_.corner(primitive_, k);
                if (!from || !to)
                    return std::nullopt;
                return Edge{*from,
                            *to,
                            text.vertices.size() == 3 ? numbers_.corner(primitive_, 3 - i - k)
                                                      : std::nullopt,
                            {i, k}};
            }
        return std::nullopt;
    }

    /// The first `edge` step of an edge in the step's primitive.
    std::size_t edge_step(const std::string& name) const {
        for (const std::size_t n : numbers_.index().find(StepKind::edge, {{"edge", name}}))
            if (numbers_.index().primitive_of(n) == primitive_)
                return n;
        return 0;
    }

    /// Of a row of the step's primitive.
    Rational sample_y(Index row) const { return offset_of(numbers_.trace(), primitive_).y_of(row); }

    std::optional<std::vector<Vec3>> world_corners(std::size_t primitive) const {
        if (primitive == 0)
            return std::nullopt;
        std::vector<Vec3> corners;
        for (const std::string& name :
             numbers_.step(primitive).as<PrimitiveStep>().vertices.texts()) {
            const auto corner = numbers_.in_world(name);
            if (!corner)
                return std::nullopt;
            corners.push_back(*corner);
        }
        return corners.size() < 3 ? std::nullopt : std::optional(std::move(corners));
    }

    std::optional<std::array<Vec2, 3>> corners() const {
        std::array<Vec2, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto corner = primitive_ == 0 ? std::nullopt : numbers_.corner(primitive_, i);
            if (!corner)
                return std::nullopt;
            corners[i] = *corner;
        }
        return corners;
    }

    /// From the ends of the row that a depth test lies in, as fills along the edges do.
    std::optional<MixedDepth> depth_in_row() const {
        const auto test = view_.as<DepthStep>();
        for (const std::size_t row :
             numbers_.index().find(StepKind::scanline, {{"y", std::to_string(test.y)}})) {
            const auto left_depth = numbers_.one(row, "left_depth");
            const auto right_depth = numbers_.one(row, "right_depth");
            if (numbers_.index().primitive_of(row) != primitive_ || !left_depth || !right_depth)
                continue;
            const bool is_rounded = method().depth_at == DepthAt::rounded_ends;
            const auto first = numbers_.one(row, is_rounded ? "from" : "left");
            const auto last = numbers_.one(row, is_rounded ? "to" : "right");
            const auto offset = told_samples(numbers_.trace()).triangles;
            const Rational x = is_rounded ? Rational(test.x) : offset.x_of(test.x);
            if (first && last)
                return between(*first, *last, x, *left_depth, *right_depth);
        }
        return std::nullopt;
    }

    /// From the depths of all three corners, as a plane over the screen.
    std::optional<MixedDepth> depth_in_triangle() const {
        const auto triangle = corners();
        const auto sample = sample_of(numbers_.trace(), view_);
        const Values depths = numbers_.of(primitive_, "depths");
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
    std::size_t step_;
    StepView view_;
    std::size_t primitive_;
};

/// An end of a row as it was claimed, if somebody has.
RoundedEnd end_in_row(const Numbers& numbers, std::size_t row, const std::string& side) {
    const std::string pixel = side == "left" ? "from" : "to";
    const auto claimed = numbers.one(row, pixel);
    if (claimed && claimed != Numbers(numbers.index()).one(row, pixel))
        return {.x = *claimed, .rule = {.rounding = Rounding::floor}};
    return rounded_end(numbers, row, side);
}

} // namespace

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
