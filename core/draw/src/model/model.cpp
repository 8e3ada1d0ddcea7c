// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/model/model.h>

#include "model/model_pieces.h"

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/raster/line_bresenham.h>
#include <rastertrace/core/raster/line_sampling.h>
#include <rastertrace/core/raster/shading.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace rastertrace {

namespace {

Pixel pixel_at(GridPoint p) {
    return {static_cast<int>(p.x), static_cast<int>(p.y)};
}

class ModelDrawing {
public:
    ModelDrawing(const ModelRules& rules, const Listener& listener)
        : rules_(rules), scene_(rules.scene), method_(scene_.method), canvas_(scene_.canvas),
          down_(canvas_.down()), has_buffer_(scene_.has_depth_buffer()), sink_(listener),
          image_(canvas_), buffer_(has_buffer_ ? image_.colors().size() : 0) {}

    Image drawn() {
        for_each_piece(rules_, sink_, [this](const ModelPiece& piece) { draw(piece); });
        return std::move(image_);
    }

private:
    void draw(const ModelPiece& piece) {
        const auto& [kind, corners, color] = piece;
        const bool has_sides = kind == PrimitiveKind::outline || rules_.draws_outlines;
        if (kind == PrimitiveKind::point)
            plot(pixel_of(on_samples(corners[0], offset_of(sample_of_others(method_)).exact())),
                 corners[0].color.rounded(method_.color_rounding));
        if (kind == PrimitiveKind::line)
            draw_line(corners[0], corners[1]);
        if (kind == PrimitiveKind::triangle) {
            ModelTriangle triangle;
            for (std::size_t i = 0; i < 3; ++i) {
                triangle[i] = on_samples(corners[i], offset_of_triangles());
                triangle[i].at.y *= down_;
            }
            fill(triangle, color);
        }
        for (std::uint16_t i = 0; corners.size() == 3 && has_sides && i < 3; ++i) {
            const auto next = static_cast<std::uint16_t>((i + 1) % 3);
            sink_(EdgeSetUp<>{.edge = EdgeName{i, next}, .octant = 0});
            draw_line(corners[i], corners[next]);
        }
    }

    /// A vertex with samples at whole numbers.
    static ModelVertex on_samples(ModelVertex vertex, const Rational& offset) {
        vertex.at.x -= offset;
        vertex.at.y -= offset;
        return vertex;
    }

    Rational offset_of_triangles() const {
        return rules_.sample ? *rules_.sample : offset_of(sample_of(method_)).exact();
    }

    static GridPoint pixel_of(const ModelVertex& vertex) {
        return nearest_pixel(vertex.at, SampleOffset<Rational>());
    }

    // --- Triangles -------------------------------------------------------------------------------

    void fill(const ModelTriangle& triangle, Color color) {
        const auto& [a, b, c] = triangle;
        area2_ = (b.at.x - a.at.x) * (c.at.y - a.at.y) - (c.at.x - a.at.x) * (b.at.y - a.at.y);
        const bool is_flat = a.color.of == b.color.of && a.color.of == c.color.of;
        mixes_ = scene_.mixes_colors() && area2_ != 0 && !is_flat;
        color_ = is_flat ? a.color.rounded(method_.color_rounding) : color;
        if (traits_of(method_.fill).rule == PixelRule::row_ends)
            fill_by_rows(triangle);
        else if (area2_ == 0)
            sink_(PrimitiveSkipped<>{.why = SkipReason::zero_area});
        else
            fill_by_samples(triangle);
    }

    /// The weights of the vertices in a sample: the areas of the triangles that it makes with the edges.
    ModelWeights weights_at(const ModelTriangle& triangle, GridPoint p) const {
        const auto weight = [&](const ModelVertex& from, const ModelVertex& to) {
            return Rational(
                ((from.at.x - p.x) * (to.at.y - p.y) - (to.at.x - p.x) * (from.at.y - p.y)) /
                area2_);
        };
        const auto& [a, b, c] = triangle;
        return {weight(b, c), weight(c, a), weight(a, b)};
    }

    /// Every pixel of the box whose sample the rule admits. Each weight grows by the same from sample to sample of a row.
    void fill_by_samples(const ModelTriangle& triangle) {
        const BoundingBox box = rules_.box(triangle);
        const Index top = Index{canvas_.top()} * down_;
        const Index first = std::max<Index>(box.first_x, canvas_.left());
        const ModelWeights at_origin = weights_at(triangle, {0, 0});
        const ModelWeights beside = weights_at(triangle, {1, 0});
        for (Index y = std::max(box.first_row, top);
             y <= std::min(box.last_row, top + canvas_.height - 1); ++y) {
            ModelWeights weights = weights_at(triangle, {first, y});
            for (Index x = first; x <= std::min<Index>(box.last_x, canvas_.right()); ++x) {
                const bool covers = rules_.covers(triangle, {x, y}, weights);
                if (method_.fill == Fill::barycentric)
                    sink_(SampleTested<Rational>{.x = static_cast<int>(x),
                                                 .y = static_cast<int>(y * down_),
                                                 .weights = weights,
                                                 .inside = covers});
                if (covers)
                    test_and_plot(triangle, {x, y}, [&] {
                        const auto& [a, b, c] = triangle;
                        return Rational(weights[0] * a.depth + weights[1] * b.depth +
                                        weights[2] * c.depth);
                    });
                for (std::size_t i = 0; i < 3; ++i)
                    weights[i] += beside[i] - at_origin[i];
            }
        }
    }

    ModelEdge edge_between(ModelEdge::Role role, const ModelVertex& from,
                           const ModelVertex& to) const {
        ModelEdge edge{role, from, to};
        edge.dx_dy = rules_.slope(edge);
        sink_(EdgeSetUp<Rational>{.edge = {from.index, to.index},
                                  .dx_dy = from.at.y == to.at.y
                                               ? OrNull<Rational>()
                                               : OrNull<Rational>(edge.dx_dy * down_)});
        return edge;
    }

    /// On each row from the left to the right edge. The long edge lies opposite the two short ones.
    void fill_by_rows(const ModelTriangle& triangle) {
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
            const Index y =
                method_.fill == Fill::two_halves ? begin + end - 1 - i : i; // from the bottom
            const ModelEdge& short_edge = y < first_lower ? upper : lower;
            draw_row(triangle, y, long_is_left ? long_edge : short_edge,
                     long_is_left ? short_edge : long_edge);
        }
    }

    void draw_row(const ModelTriangle& triangle, Index y, const ModelEdge& left,
                  const ModelEdge& right) {
        ModelRow row{rules_.x_on(left, y), rules_.x_on(right, y)};
        std::tie(row.from, row.to) = rules_.span(row.left, row.right);
        const Rational offset = offset_of_triangles();
        ScanlineSpanned<Rational> told{.y = static_cast<int>(y * down_),
                                       .left = row.left + offset,
                                       .right = row.right + offset,
                                       .from = row.from,
                                       .to = row.to,
                                       .left_edge = {left.from.index, left.to.index},
                                       .right_edge = {right.from.index, right.to.index}};
        if (has_buffer_) {
            told.left_depth = row.left_depth = depth_on(left, y);
            told.right_depth = row.right_depth = depth_on(right, y);
        }
        sink_(told);
        // A mistake may bring pixels back that lie as far off the canvas as it has pixels.
        const Index far = Index{canvas_.width} * canvas_.height;
        for (Index x = std::max(row.from, -far); x <= std::min(row.to, far); ++x)
            test_and_plot(triangle, {x, y}, [&] { return depth_in(row, x); });
    }

    /// Linear across the row; beyond an end, that of the end.
    Rational depth_in(const ModelRow& row, Index x) const {
        const bool at_pixels = method_.depth_at == DepthAt::rounded_ends;
        const Rational left = at_pixels ? Rational(row.from) : row.left;
        const Rational right = at_pixels ? Rational(row.to) : row.right;
        if (!(left < right))
            return row.left_depth;
        const Rational here = std::clamp(Rational(x), left, right);
        return row.left_depth + (row.right_depth - row.left_depth) / (right - left) * (here - left);
    }

    static Rational depth_on(const ModelEdge& edge, Index y) {
        const Rational height = edge.to.at.y - edge.from.at.y;
        return height == 0 ? edge.from.depth
                           : Rational(edge.from.depth + (edge.to.depth - edge.from.depth) *
                                                            (y - edge.from.at.y) / height);
    }

    /// The depth test of a pixel, and its color.
    template <typename DepthOfPixel>
    void test_and_plot(const ModelTriangle& triangle, GridPoint at, DepthOfPixel&& depth_of_pixel) {
        const auto found = rules_.on_canvas({at.x, at.y * down_});
        if (!found)
            return;
        if (has_buffer_) {
            const Rational depth = depth_of_pixel();
            std::optional<Rational>& stored = buffer_[canvas_.offset_of(pixel_at(*found))];
            const std::optional<Rational> held = stored ? stored : rules_.cleared;
            const bool passes = rules_.passes(depth, held);
            const Pixel pixel = pixel_at(*found);
            sink_(DepthTested<Rational>{
                .x = pixel.x, .y = pixel.y, .depth = depth, .stored = held, .pass = passes});
            if (!passes)
                return;
            stored = depth;
        }
        plot({at.x, at.y * down_}, mixes_ ? mixed(triangle, at) : color_);
    }

    Color mixed(const ModelTriangle& triangle, GridPoint at) const {
        const ModelWeights shares = rules_.shares(triangle, weights_at(triangle, at));
        return mixed_levels<Rational, 3>(
            {triangle[0].color, triangle[1].color, triangle[2].color}, shares,
            [this](const Rational& level) { return rules_.level(level); });
    }

    // --- Lines -----------------------------------------------------------------------------------

    void draw_line(ModelVertex from, ModelVertex to) {
        const Rational offset = offset_of(sample_of_lines(method_)).exact();
        from = on_samples(from, offset);
        to = on_samples(to, offset);
        const bool is_on_grid = method_.line == LineMethod::bresenham;
        const ModelLine forward = rules_.line(from.at, to.at);
        const bool falls = is_on_grid           ? forward.last < forward.first
                           : forward.is_x_major ? to.at.x < from.at.x
                                                : to.at.y < from.at.y;
        if (method_.from == LineStart::low && falls)
            std::swap(from, to);
        const ModelLine line = rules_.line(from.at, to.at);
        const LineColors colors = line_colors(from, to);
        const GridLine pixels{pixel_of(from), pixel_of(to),
                              from.color.rounded(method_.color_rounding),
                              to.color.rounded(method_.color_rounding), colors ? &colors : nullptr};
        const Index last = line.steps - (method_.ends == EndPixels::both ? 0 : 1);
        if (is_on_grid)
            walk(line, pixels, last);
        else
            sample(line, pixels, last);
    }

    /// In space: by the place on the line, beyond an end that of the end. Else by steps, unless these lead
    /// between levels that are not whole.
    LineColors line_colors(const ModelVertex& from, const ModelVertex& to) const {
        const ColorLerp lerp = scene_.color_lerp();
        const auto is_whole = [this](const ModelVertex& end) {
            return Levels<Rational>(end.color.rounded(method_.color_rounding)).of == end.color.of;
        };
        if (from.color.of == to.color.of ||
            (lerp != ColorLerp::space && is_whole(from) && is_whole(to)))
            return {};
        const bool divides = lerp == ColorLerp::space && scene_.mixes_in_perspective();
        const MixedOnLine<Rational> mixed{
            {from.color, to.color},
            {divides ? from.inverse_w : Rational(1), divides ? to.inverse_w : Rational(1)},
            method_.color_rounding};
        const Rational dx = to.at.x - from.at.x;
        const Rational dy = to.at.y - from.at.y;
        const bool is_x_major = abs(dx) >= abs(dy);
        const Rational run = is_x_major ? dx : dy;
        return [=](GridPoint pixel, Index step, Index steps) {
            const Rational along =
                is_x_major ? Rational(pixel.x - from.at.x) : Rational(pixel.y - from.at.y);
            if (lerp == ColorLerp::space)
                return mixed.at(run == 0
                                    ? Rational(0)
                                    : std::clamp<Rational>(along / run, Rational(0), Rational(1)));
            if (step == 0 || step == steps)
                return mixed.at(step == 0 ? 0 : 1);
            const GridLine pixels{pixel_of(from), pixel_of(to), {}, {}};
            return mixed.at(lerp == ColorLerp::axis
                                ? Rational(Rational(step) / steps)
                                : Rational(1 - share_by_distance(pixels, pixel)));
        };
    }

    /// Bresenham's line: straight on, or diagonally?
    void walk(const ModelLine& line, const GridLine& pixels, Index last) {
        const bool steps_at_ties = line_rules(method_).ties == Ties::step;
        GridPoint at = line.start, pixel = at;
        Index d = line.d;
        for (Index i = 0; i <= last; ++i) {
            plot(pixel, rules_.color_of_step(pixels, pixel, i, line.steps));
            const bool is_straight = d < 0 || (d == 0 && !steps_at_ties);
            const GridPoint step = is_straight ? line.straight : line.diagonal;
            const GridPoint kept = is_straight ? line.straight : line.kept;
            const GridPoint next{at.x + step.x, at.y + step.y};
            if (i < last && canvas_.contains(pixel.x, pixel.y) && canvas_.contains(next.x, next.y))
                sink_(LineDecided<>{.x = static_cast<int>(pixel.x),
                                    .y = static_cast<int>(pixel.y),
                                    .d = d,
                                    .move = move_of(step)});
            d += is_straight ? line.d_straight : line.d_diagonal;
            at = {at.x + kept.x, at.y + kept.y};
            pixel = next;
        }
    }

    /// A naive or dda line: the coordinate across at each step along its major axis.
    void sample(const ModelLine& line, const GridLine& pixels, Index last) {
        const Rational offset = offset_of(sample_of_lines(method_)).exact();
        const SpanRounding rounding = line_rounding(method_);
        const bool falls = line.is_x_major ? line.to.y < line.from.y : line.to.x < line.from.x;
        for (Index i = 0; i <= last; ++i) {
            const Index along = line.last < line.first ? line.first - i : line.first + i;
            const Rational across = rules_.across(line, along);
            const Index rounded = pixel_across(across, rounding, falls);
            if (canvas_.contains(line.is_x_major ? along : canvas_.left(),
                                 line.is_x_major ? canvas_.top() : along))
                sink_(line_sampled(line.is_x_major, along, Rational(across + offset), rounded));
            const GridPoint at =
                line.is_x_major ? GridPoint{along, rounded} : GridPoint{rounded, along};
            plot(at, rules_.color_of_step(pixels, at, i, line.steps));
        }
    }

    void plot(GridPoint at, Color color) {
        const auto found = rules_.on_canvas(at);
        if (!found)
            return sink_(pixels_off_canvas(at.x, at.y, at.x, at.y));
        const Pixel pixel = pixel_at(*found);
        image_.at(pixel) = color;
        sink_(PixelPlotted<>{.x = pixel.x, .y = pixel.y, .color = color});
    }

    const ModelRules& rules_;
    const Scene& scene_;
    const Method& method_;
    const Canvas& canvas_;
    const int down_;
    const bool has_buffer_;
    ListenerSink sink_;
    Image image_;
    std::vector<std::optional<Rational>> buffer_; ///< of depths, top row first
    Rational area2_;                              ///< of the triangle that is filled, twice
    Color color_;                                 ///< of its pixels, unless
    bool mixes_ = false;                          ///< they are mixed
};

} // namespace

namespace {

/// True if no line of a scene is so long that it could not be walked pixel by pixel: 100,000 pixels, in the world and as
/// typed. Behind a camera a z can be one of them.
bool is_walkable(const Scene& scene) {
    const auto is_near = [](const Rational& x) { return abs(x) <= 100'000; };
    const Matrix<Rational> as_typed = identity<Rational>();
    auto object = scene.objects.begin();
    for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
        while (object != scene.objects.end() && object->end_vertex <= i)
            ++object;
        const SceneVertex& typed = scene.vertices[i];
        const Vec<Rational, 4> world =
            (object == scene.objects.end() ? as_typed : object->model.matrix()) *
            Vec<Rational, 4>{typed.x.exact(), typed.y.exact(), typed.z.exact(), 1};
        if (!is_near(typed.x.exact()) || !is_near(typed.y.exact()) || !is_near(world.x) ||
            !is_near(world.y) || (scene.camera && !is_near(world.z)))
            return false;
    }
    return true;
}

} // namespace

bool has_model(const Scene& scene) {
    return !scene.has_tested_lines() && !scene.has(PrimitiveKind::polygon) &&
           !scene.has(PrimitiveKind::circle) && scene.method.fill != Fill::fan &&
           scene.method.line != LineMethod::diamond_exit && is_walkable(scene);
}

Image draw_by(const ModelRules& rules, const Listener& listener) {
    return ModelDrawing(rules, listener).drawn();
}

} // namespace rastertrace
