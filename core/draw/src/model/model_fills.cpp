// SPDX-License-Identifier: MIT
// Triangles and polygons of the model.

#include "model/model_drawing.h"

#include <rastertrace/core/raster/mixed_colors.h>

#include <algorithm>
#include <cstdint>

namespace rastertrace {

Rational area2_of(const ModelTriangle& triangle) {
    const auto& [a, b, c] = triangle;
    return (b.at.x - a.at.x) * (c.at.y - a.at.y) - (c.at.x - a.at.x) * (b.at.y - a.at.y);
}

ModelWeights weights_at(const ModelTriangle& triangle, const Vec<Rational, 2>& p) {
    const Rational area2 = area2_of(triangle);
    const auto weight = [&](const ModelVertex& from, const ModelVertex& to) {
        return Rational(
            ((from.at.x - p.x) * (to.at.y - p.y) - (to.at.x - p.x) * (from.at.y - p.y)) / area2);
    };
    const auto& [a, b, c] = triangle;
    return {weight(b, c), weight(c, a), weight(a, b)};
}

Rational ModelDrawing::offset_of_triangles() const {
    return rules_.sample ? *rules_.sample : offset_of(sample_of(method_)).exact();
}

/// A vertex with samples at whole numbers, and y downward in the picture.
ModelVertex ModelDrawing::on_rows(const ModelVertex& vertex, const Rational& offset) const {
    ModelVertex moved = on_samples(vertex, offset);
    moved.at.y *= down_;
    return moved;
}

void ModelDrawing::fill(const ModelTriangle& triangle, Color color) {
    const auto& [a, b, c] = triangle;
    const bool is_flat = a.color.of == b.color.of && a.color.of == c.color.of;
    const bool has_area = area2_of(triangle) != 0;
    mixes_ = scene_.mixes_colors() && has_area && !is_flat;
    color_ = is_flat ? a.color.rounded(method_.color_rounding) : color;
    if (method_.fill == Fill::fan)
        fill_fan(triangle);
    else if (traits_of(method_.fill).rule == PixelRule::row_ends)
        fill_by_rows(triangle);
    else if (!has_area)
        sink_(PrimitiveSkipped<>{.why = SkipReason::zero_area});
    else
        fill_by_samples(triangle);
}

/// The depth test of a pixel, and its color. y is its row.
void ModelDrawing::test_and_put(const ModelTriangle& triangle, GridPoint at,
                                const std::function<Rational()>& depth) {
    const GridPoint in_picture{at.x, at.y * down_};
    const auto pixel = stored_at(in_picture);
    if (!pixel)
        return reject(in_picture);
    if (!depths_ || depths_->keeps_face(*pixel, depth()))
        put(*pixel, mixes_ ? mixed(triangle, at) : color_);
}

Color ModelDrawing::mixed(const ModelTriangle& triangle, GridPoint at) const {
    const ModelWeights shares = rules_.shares(triangle, weights_at(triangle, {at.x, at.y}));
    return mixed_levels<Rational, 3>({triangle[0].color, triangle[1].color, triangle[2].color},
                                     shares,
                                     [this](const Rational& level) { return rules_.level(level); });
}

// --- By samples ----------------------------------------------------------------------------------

/// Every pixel of the box whose sample the rule admits. Each weight grows by the same from sample to sample of a row.
void ModelDrawing::fill_by_samples(const ModelTriangle& triangle) {
    const BoundingBox box = rules_.box(triangle);
    const Index top = Index{canvas_.top()} * down_;
    const ModelWeights at_origin = weights_at(triangle, {0, 0});
    const ModelWeights beside = weights_at(triangle, {1, 0});
    for (Index y = std::max(box.first_row, top);
         y <= std::min(box.last_row, top + canvas_.height - 1); ++y) {
        const auto [first, last] = within_reach(box.first_x, box.last_x);
        ModelWeights weights = weights_at(triangle, {first, y});
        for (Index x = first; x <= last; ++x) {
            const bool covers = rules_.covers(triangle, {x, y}, weights);
            if (method_.fill == Fill::barycentric && canvas_.contains(x, y * down_))
                sink_(SampleTested<Rational>{.x = static_cast<int>(x),
                                             .y = static_cast<int>(y * down_),
                                             .weights = weights,
                                             .inside = covers});
            if (covers)
                test_and_put(triangle, {x, y}, [&] {
                    const auto& [a, b, c] = triangle;
                    return Rational(weights[0] * a.depth + weights[1] * b.depth +
                                    weights[2] * c.depth);
                });
            for (std::size_t i = 0; i < 3; ++i)
                weights[i] += beside[i] - at_origin[i];
        }
        tell_rejected();
    }
}

// --- By rows -------------------------------------------------------------------------------------

ModelEdge ModelDrawing::edge_between(ModelEdge::Role role, const ModelVertex& from,
                                     const ModelVertex& to) const {
    ModelEdge edge{role, from, to};
    edge.dx_dy = rules_.slope(edge);
    sink_(EdgeSetUp<Rational>{
        .edge = {from.index, to.index},
        .dx_dy = from.at.y == to.at.y ? OrNull<Rational>() : OrNull<Rational>(edge.dx_dy * down_)});
    return edge;
}

/// What a row has from one edge to another.
ScanlineSpanned<Rational> ModelDrawing::span_between(Index row, const ModelCrossing& left,
                                                     const ModelCrossing& right,
                                                     const Rational& offset) const {
    const auto [from, to] = rules_.span(left.x, right.x);
    return {.y = static_cast<int>(row * down_),
            .left = left.x + offset,
            .right = right.x + offset,
            .from = from,
            .to = to,
            .left_edge = {left.edge->from.index, left.edge->to.index},
            .right_edge = {right.edge->from.index, right.edge->to.index}};
}

/// On each row from the left to the right edge. The long edge lies opposite the two short ones.
void ModelDrawing::fill_by_rows(const ModelTriangle& triangle) {
    const ModelTriangle sorted = rules_.sorted_from_top(triangle);
    const auto& [top, middle, bottom] = sorted;
    const bool has_height = top.at.y != bottom.at.y;
    const ModelEdge upper = edge_between(ModelEdge::Role::upper, top, middle);
    const ModelEdge lower = edge_between(ModelEdge::Role::lower, has_height ? middle : bottom,
                                         has_height ? bottom : middle);
    const ModelEdge long_edge = edge_between(ModelEdge::Role::long_edge, top, bottom);
    const Rational opposite = top.at.x + long_edge.dx_dy * (middle.at.y - top.at.y);
    const bool long_is_left = !(middle.at.x < opposite);

    const auto [first, last] = rules_.rows(top.at.y, bottom.at.y);
    const Index first_lower = rules_.first_lower_row(sorted);
    const Index canvas_top = Index{canvas_.top()} * down_;
    const Index begin = std::max(first, canvas_top);
    const Index end = std::min(last + 1, canvas_top + canvas_.height);
    for (Index i = begin; i < end; ++i) {
        const Index row =
            method_.fill == Fill::two_halves ? begin + end - 1 - i : i; // from the bottom
        const ModelEdge& short_edge = row < first_lower ? upper : lower;
        fill_row(triangle, row, long_is_left ? long_edge : short_edge,
                 long_is_left ? short_edge : long_edge);
    }
}

namespace {

Rational depth_on(const ModelEdge& edge, Index row) {
    const Rational height = edge.to.at.y - edge.from.at.y;
    return height == 0 ? edge.from.depth
                       : Rational(edge.from.depth + (edge.to.depth - edge.from.depth) *
                                                        (row - edge.from.at.y) / height);
}

} // namespace

/// Depths are linear across the row; beyond an end, that of the end.
void ModelDrawing::fill_row(const ModelTriangle& triangle, Index row, const ModelEdge& left,
                            const ModelEdge& right) {
    const Rational x_left = rules_.x_on(left, row);
    const Rational x_right = rules_.x_on(right, row);
    ScanlineSpanned<Rational> span =
        span_between(row, {&left, x_left}, {&right, x_right}, offset_of_triangles());
    const bool at_pixels = method_.depth_at == DepthAt::rounded_ends;
    const Rational first = at_pixels ? Rational(span.from) : x_left;
    const Rational last = at_pixels ? Rational(span.to) : x_right;
    if (depths_) {
        span.left_depth = depth_on(left, row);
        span.right_depth = depth_on(right, row);
    }
    sink_(span);
    for_each_in_row(row, span.from, span.to, [&](GridPoint at) {
        test_and_put(triangle, at, [&] {
            if (!(first < last))
                return *span.left_depth;
            const Rational here = std::clamp(Rational(at.x), first, last);
            return Rational(*span.left_depth + (*span.right_depth - *span.left_depth) /
                                                   (last - first) * (here - first));
        });
    });
}

// --- Fans ----------------------------------------------------------------------------------------

/// A line from each pixel of an edge to the third vertex, from one edge, from two or from all three.
void ModelDrawing::fill_fan(const ModelTriangle& triangle) {
    const LineColors in_space = [&](GridPoint at, Index, Index) {
        return mixed(triangle, {at.x, at.y * down_});
    };
    const LineColors* const colors =
        mixes_ && scene_.color_lerp() == ColorLerp::space ? &in_space : nullptr;
    const auto line_between = [colors](const GridPoint& a, Color of_a, const GridPoint& b,
                                       Color of_b) {
        return b.x < a.x ? GridLine{b, a, of_b, of_a, colors} : GridLine{a, b, of_a, of_b, colors};
    };
    std::array<GridPoint, 3> at;
    std::array<Color, 3> color;
    for (std::size_t i = 0; i < 3; ++i) {
        at[i] = pixel_of({triangle[i].at.x, triangle[i].at.y * down_});
        color[i] = triangle[i].color.rounded(method_.color_rounding);
    }
    const auto line_of = [this](const GridLine& line) {
        return rules_.line({line.from.x, line.from.y}, {line.to.x, line.to.y});
    };
    constexpr std::array<std::array<std::uint8_t, 3>, 3> passes{{{0, 1, 2}, {0, 2, 1}, {1, 2, 0}}};
    for (int pass = 0; pass < method_.fan_passes; ++pass) {
        const auto& [from, to, apex] = passes[static_cast<std::size_t>(pass)];
        const GridLine base = line_between(at[from], color[from], at[to], color[to]);
        sink_(EdgeSetUp<>{.edge = {from, to}, .octant = octant_of(base.from, base.to)});
        const ModelLine edge = line_of(base);
        std::vector<std::pair<GridPoint, Color>> starts;
        walk(edge, edge.steps, false, [&](Index step, GridPoint pixel) {
            starts.emplace_back(pixel, rules_.color_of_step(base, pixel, step, edge.steps));
        });
        for (const auto& [start, of_start] : starts) {
            sink_(RayBegan<>{.x = start.x, .y = start.y});
            const GridLine ray = line_between(start, of_start, at[apex], color[apex]);
            const ModelLine line = line_of(ray);
            walk(line, line.steps, true, [&](Index step, GridPoint pixel) {
                plot(pixel, [&] { return rules_.color_of_step(ray, pixel, step, line.steps); });
            });
        }
    }
}

// --- Polygons ------------------------------------------------------------------------------------

namespace {

/// An edge of a polygon.
struct TurningEdge {
    ModelEdge edge;
    int turn; ///< what it adds to the winding number right of it: 1 if the polygon runs down along it
    bool has_both_ends; ///< its end at the larger y counts, too
};

/// True if the neighbors of a corner that are not level with it lie on one side of it.
bool turns_back(const std::vector<ModelVertex>& corners, std::size_t corner) {
    const auto side_of_next = [&](std::size_t step) {
        for (std::size_t i = 1; i < corners.size(); ++i)
            if (const Rational dy =
                    corners[(corner + i * step) % corners.size()].at.y - corners[corner].at.y;
                sgn(dy) != 0)
                return sgn(dy);
        return 0;
    };
    return side_of_next(1) == side_of_next(corners.size() - 1);
}

/// The edges that a row meets, from left to right; on one line, in their order. Each has the row at its upper end, or the one at its lower end, so
/// that a row meets an even number of them; or both.
std::vector<ModelCrossing> crossings_on(Index row, bool has_upper_end,
                                        const std::vector<TurningEdge>& edges,
                                        const ModelRules& rules) {
    std::vector<ModelCrossing> met;
    for (const auto& [edge, turn, has_both_ends] : edges) {
        const Rational& upper = edge.from.at.y;
        const Rational& lower = edge.to.at.y;
        const bool is_at_other_end = (has_upper_end ? lower : upper) == row;
        if (upper <= row && row <= lower && (has_both_ends || !is_at_other_end))
            met.push_back({&edge, rules.x_on(edge, row), turn});
    }
    std::stable_sort(met.begin(), met.end(), [&](const ModelCrossing& a, const ModelCrossing& b) {
        if (a.x != b.x)
            return a.x < b.x;
        const Rational& slope_a = a.edge->dx_dy;
        const Rational& slope_b = b.edge->dx_dy;
        return has_upper_end ? slope_a < slope_b : slope_b < slope_a;
    });
    return met;
}

} // namespace

/// The spans of a row around which the polygon winds as the fill rule asks for it.
std::vector<ScanlineSpanned<Rational>>
ModelDrawing::spans_inside(Index row, const std::vector<ModelCrossing>& met) const {
    std::vector<ScanlineSpanned<Rational>> spans;
    const ModelCrossing* left = nullptr;
    int winding = 0;
    for (const ModelCrossing& one : met) {
        winding += one.turn;
        const bool is_inside =
            method_.fill_rule == FillRule::even_odd ? winding % 2 != 0 : winding != 0;
        if (left == nullptr) {
            left = &one;
        } else if (!is_inside) {
            spans.push_back(
                span_between(row, *left, one, offset_of(sample_of_others(method_)).exact()));
            left = nullptr;
        }
    }
    return spans;
}

/// Tells where the edges meet a row, and fills its spans.
void ModelDrawing::fill_spans(Index row, const std::vector<ModelCrossing>& met,
                              const std::vector<ScanlineSpanned<Rational>>& spans, Color color) {
    std::vector<EdgeName> edges;
    std::vector<Rational> x;
    std::vector<std::int64_t> winding;
    for (const ModelCrossing& one : met) {
        edges.push_back({one.edge->from.index, one.edge->to.index});
        x.push_back(one.x + offset_of(sample_of_others(method_)).exact());
        winding.push_back((winding.empty() ? 0 : winding.back()) + one.turn);
    }
    sink_(RowCrossed<Rational>{
        .y = static_cast<int>(row * down_), .edges = edges, .x = x, .winding = winding});
    for (const auto& span : spans) {
        sink_(span);
        for_each_in_row(row, span.from, span.to, [&](GridPoint at) {
            plot({at.x, at.y * down_}, [&] { return color; });
        });
    }
}

/// An edge has its end of smaller y, as the scene has it. Closed rows are also drawn as those that end there.
void ModelDrawing::fill_polygon(const ModelPiece& polygon) {
    const Rational offset = offset_of(sample_of_others(method_)).exact();
    std::vector<TurningEdge> edges;
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const ModelVertex from = on_rows(polygon.corners[i], offset);
        const ModelVertex to = on_rows(polygon.corners[(i + 1) % polygon.corners.size()], offset);
        const bool runs_down = from.at.y < to.at.y;
        const ModelEdge edge =
            edge_between(ModelEdge::Role::of_polygon, runs_down ? from : to, runs_down ? to : from);
        const std::size_t highest = runs_down == (down_ > 0) ? (i + 1) % polygon.corners.size() : i;
        const bool has_both_ends = method_.polygon_vertices == PolygonVertices::turning &&
                                   turns_back(polygon.corners, highest);
        if (from.at.y != to.at.y)
            edges.push_back({edge, runs_down ? 1 : -1, has_both_ends});
    }
    if (edges.empty())
        return sink_(PrimitiveSkipped<>{.why = SkipReason::zero_area});
    const bool has_upper_end = down_ > 0;
    const auto first_row = [has_upper_end](const TurningEdge& one) {
        const Rational& y = one.edge.from.at.y;
        return has_upper_end ? ceil_index(y) : floor_index(y) + 1;
    };
    std::stable_sort(edges.begin(), edges.end(), [&](const TurningEdge& a, const TurningEdge& b) {
        return first_row(a) < first_row(b);
    });
    const Index top = Index{canvas_.top()} * down_;
    for (Index row = top; row < top + canvas_.height; ++row) {
        const auto met = crossings_on(row, has_upper_end, edges, rules_);
        const auto spans = spans_inside(row, met);
        if (!met.empty())
            fill_spans(row, met, spans, polygon.color);
        if (method_.rows != RowRule::closed)
            continue;
        const auto ending = crossings_on(row, !has_upper_end, edges, rules_);
        auto more = spans_inside(row, ending);
        std::erase_if(more, [&spans](const auto& span) {
            return span.to < span.from ||
                   std::any_of(spans.begin(), spans.end(), [&span](const auto& other) {
                       return other.from <= span.from && span.to <= other.to;
                   });
        });
        if (!more.empty())
            fill_spans(row, ending, more, polygon.color);
    }
}

} // namespace rastertrace
