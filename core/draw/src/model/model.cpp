// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/model/model.h>

#include "list/faces.h"
#include "tell/listener_sink.h"

#include <rastertrace/core/draw/list/drawing_order.h>
#include <rastertrace/core/draw/list/light.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/raster/clip.h>
#include <rastertrace/core/raster/line_bresenham.h>
#include <rastertrace/core/raster/line_sampling.h>
#include <rastertrace/core/raster/shading.h>

#include <numeric>
#include <string>
#include <utility>

namespace rastertrace {

namespace {

using Point3 = Vec<Rational, 3>;
using Point4 = Vec<Rational, 4>;

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
        for (std::size_t i = 0; i < scene_.vertices.size(); ++i)
            vertices_.push_back(moved(i));
        for (const std::size_t index : drawing_order())
            draw(scene_.primitives[index], index);
        return std::move(image_);
    }

private:
    // --- From object space to the screen ---------------------------------------------------------

    /// A vertex before clipping.
    struct ClipSpace {
        Point3 world;
        Point4 clip;
        Rational distance; ///< from the eye along the view
    };

    ClipSpace moved(std::size_t index) const {
        const SceneVertex& vertex = scene_.vertices[index];
        Point4 world{vertex.x.exact(), vertex.y.exact(), vertex.z.exact(), vertex.w.exact()};
        for (std::size_t i = 0; i < scene_.objects.size(); ++i)
            if (index < scene_.objects[i].end_vertex) {
                world = rules_.models[i] * world;
                break;
            }
        const Point4 camera = rules_.view * world;
        const ProjectionType type = scene_.projection.type;
        const bool is_ahead =
            type == ProjectionType::pinhole || (type == ProjectionType::none && !scene_.camera);
        const Rational distance = type == ProjectionType::clip_space ? camera.w
                                  : is_ahead                         ? camera.z
                                                                     : Rational(-camera.z);
        return {{world.x, world.y, world.z}, rules_.projection * camera, distance};
    }

    std::vector<std::size_t> drawing_order() const {
        std::vector<std::size_t> as_listed(scene_.primitives.size());
        std::iota(as_listed.begin(), as_listed.end(), 0);
        if (scene_.depth() != Depth::painter)
            return as_listed;
        auto keys = keys_of_faces<Rational>(
            scene_, [this](std::size_t i) -> const Rational& { return vertices_[i].distance; });
        for (Rational& key : keys)
            key *= rules_.paints_farthest_first ? 1 : -1;
        return sorted_by_distance(scene_, keys).primitives;
    }

    /// Is it seen, and in which light?
    Face<Rational> face_of(const ScenePrimitive& primitive) const {
        Face<Rational> face;
        if (!is_filled(primitive.kind) || !scene_.tests_faces())
            return face;
        std::vector<Point3> world;
        for (const std::size_t corner : primitive.corners())
            world.push_back(vertices_[corner].world);
        const Point3 normal = normal_of<Rational>(world);
        const Point3 centroid = centroid_of<Rational>(world);
        if (has_no_length<Rational>(normal))
            face.skip = SkipReason::zero_area;
        if (!face.skip && method_.cull != Cull::none) {
            const bool is_by_light = method_.cull == Cull::light;
            const Point3 view =
                is_by_light ? light_from<Rational>(*scene_.light, centroid) : to_eye(centroid);
            const Rational dot = rules_.facing(normal, view);
            const bool is_culled = rastertrace::is_culled(method_.cull, dot);
            face.tested = {normal,
                           view,
                           dot,
                           cosine_between(normal, view),
                           is_by_light,
                           is_culled,
                           rastertrace::is_culled(method_.cull, Rational(-dot))};
            if (is_culled)
                face.skip = SkipReason::culled;
        }
        if (!face.skip && method_.shade == Shade::lambert) {
            const Point3 light = light_from<Rational>(*scene_.light, centroid);
            const double intensity = rules_.intensity(normal, light);
            face.lit = {normal, light, dot(normal, light), intensity,
                        lit(primitive.color, intensity, method_.color_rounding)};
        }
        return face;
    }

    Point3 to_eye(const Point3& centroid) const {
        if (is_perspective(scene_.projection.type))
            return exact(scene_.camera ? scene_.camera->position : Numbers3{0, 0, 0}) - centroid;
        return scene_.camera ? axes_of(*scene_.camera).back : Point3{0, 0, 1};
    }

    /// Tests the face, clips, and draws what is left: the primitive, or parts of it.
    void draw(const ScenePrimitive& primitive, std::size_t index) {
        const Face<Rational> face = face_of(primitive);
        const Color color = method_.shade == Shade::faces ? color_of_face(index)
                            : face.lit                    ? face.lit->color
                                                          : primitive.color;
        std::vector<ClipVertex<Rational>> corners;
        bool is_whole = true;
        for (const std::size_t corner : primitive.corners()) {
            const auto& [world, clip, distance] = vertices_[corner];
            const auto own = scene_.mixes_colors() ? scene_.vertices[corner].color : std::nullopt;
            corners.push_back({clip, distance, own ? *own : color, static_cast<int>(corner)});
            for (const ClipPlane<Rational>& plane : rules_.planes)
                is_whole = is_whole && plane.has_inside(clip);
        }
        if (rules_.drops(corners))
            return;
        made_ = parts_ = 0;
        if (is_whole)
            return draw_piece(primitive, corners, color, face);

        // The sides of an outline are clipped one by one; what is left of a triangle is a fan.
        sink_(PrimitiveBegan<Rational>{.kind = primitive.kind,
                                       .name = primitive.name,
                                       .vertices = {},
                                       .positions = {},
                                       .color = color,
                                       .colors = {}});
        if (!tell_face(face, sink_))
            return;
        const bool is_outline = primitive.kind == PrimitiveKind::outline;
        for (std::size_t side = 0; side < (is_outline ? 3 : 1); ++side) {
            auto polygon =
                is_outline ? std::vector{corners[side], corners[(side + 1) % 3]} : corners;
            const std::size_t fewest = std::min<std::size_t>(polygon.size(), 3);
            for (const ClipPlane<Rational>& plane : rules_.planes)
                polygon = clip(polygon, plane, method_.color_rounding);
            for (ClipVertex<Rational>& vertex : polygon)
                if (vertex.original < 0)
                    vertex.original = -++made_;
            if (polygon.size() >= fewest && polygon.size() < 3)
                draw_piece(primitive, polygon, color, {});
            for (std::size_t i = 2; i < polygon.size(); ++i)
                draw_piece(primitive, {polygon[0], polygon[i - 1], polygon[i]}, color, {});
        }
    }

    /// Divides by w, and draws a primitive or a part of it.
    void draw_piece(const ScenePrimitive& primitive,
                    const std::vector<ClipVertex<Rational>>& corners, Color color,
                    const Face<Rational>& face) {
        std::vector<ModelVertex> on_screen;
        std::vector<std::string> names;
        std::vector<Vec<Rational, 2>> positions;
        std::vector<Rational> depths;
        std::vector<Color> colors;
        const bool is_part = parts_ > 0 || corners.size() != primitive.corners().size();
        for (const ClipVertex<Rational>& vertex : corners) {
            const Point3 canonical = rules_.divided(vertex.position);
            const Point4 screen =
                rules_.viewport * Point4{canonical.x, canonical.y, canonical.z, 1};
            const Rational& w = vertex.position.w;
            on_screen.push_back(
                {rules_.placed({screen.x, screen.y}),
                 has_buffer_ ? rules_.depth_of(vertex.distance, vertex.position) : Rational(0),
                 w == 0 ? Rational(0) : Rational(1 / w), vertex.color,
                 static_cast<std::uint16_t>(on_screen.size())});
            names.push_back(vertex.original < 0
                                ? primitive.name + ":" + std::to_string(-vertex.original)
                                : scene_.vertices[static_cast<std::size_t>(vertex.original)].name);
            positions.push_back(on_screen.back().at);
            if (has_buffer_)
                depths.push_back(on_screen.back().depth);
            if (scene_.mixes_colors())
                colors.push_back(vertex.color);
        }
        ++parts_;
        const PrimitiveKind kind = corners.size() == 2 ? PrimitiveKind::line : primitive.kind;
        const std::string name =
            is_part ? primitive.name + "/" + std::to_string(parts_) : primitive.name;
        const std::vector<std::string_view> told_names(names.begin(), names.end());
        sink_(PrimitiveBegan<Rational>{.kind = kind,
                                       .name = name,
                                       .vertices = told_names,
                                       .positions = positions,
                                       .color = color,
                                       .colors = colors,
                                       .is_part = is_part,
                                       .depths = depths});
        if (tell_face(face, sink_))
            draw_on_screen(kind, on_screen, color);
    }

    void draw_on_screen(PrimitiveKind kind, const std::vector<ModelVertex>& corners, Color color) {
        const bool has_sides = kind == PrimitiveKind::outline || rules_.draws_outlines;
        if (kind == PrimitiveKind::point)
            plot(pixel_of(on_samples(corners[0], sample_of_others(method_))), corners[0].color);
        if (kind == PrimitiveKind::line)
            draw_line(corners[0], corners[1]);
        if (kind == PrimitiveKind::triangle) {
            ModelTriangle triangle;
            for (std::size_t i = 0; i < 3; ++i) {
                triangle[i] = on_samples(corners[i], sample_of(method_));
                triangle[i].at.y *= down_;
            }
            fill(triangle, color);
        }
        for (std::uint16_t i = 0; corners.size() == 3 && has_sides && i < 3; ++i) {
            const auto next = static_cast<std::uint16_t>((i + 1) % 3);
            sink_(SideBegan{.edge = {i, next}, .octant = 0});
            draw_line(corners[i], corners[next]);
        }
    }

    /// A vertex with samples at whole numbers.
    ModelVertex on_samples(ModelVertex vertex, Sample sample) const {
        const Vec<Number, 2> offset = offset_of(sample, method_, down_);
        vertex.at.x -= offset.x.exact();
        vertex.at.y -= offset.y.exact();
        return vertex;
    }

    static GridPoint pixel_of(const ModelVertex& vertex) {
        return nearest_pixel(vertex.at, SampleOffset<Rational>());
    }

    // --- Triangles -------------------------------------------------------------------------------

    void fill(const ModelTriangle& triangle, Color color) {
        const auto& [a, b, c] = triangle;
        area2_ = (b.at.x - a.at.x) * (c.at.y - a.at.y) - (c.at.x - a.at.x) * (b.at.y - a.at.y);
        const bool is_flat = a.color == b.color && a.color == c.color;
        mixes_ = scene_.mixes_colors() && area2_ != 0 && !is_flat;
        color_ = is_flat ? a.color : color;
        if (traits_of(method_.fill).rule == PixelRule::row_ends)
            fill_by_rows(triangle);
        else if (area2_ == 0)
            sink_(PrimitiveSkipped{.why = SkipReason::zero_area});
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
                    sink_(SampleTested<Rational>{pixel_at({x, y * down_}), weights, covers});
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
        sink_(EdgeSetUp<Rational>{
            {from.index, to.index}, from.at.y == to.at.y, Rational(edge.dx_dy * down_)});
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
        const Rational offset = offset_of(sample_of(method_), method_, down_).x.exact();
        ScanlineSpanned<Rational> told{static_cast<int>(y * down_),
                                       row.left + offset,
                                       row.right + offset,
                                       row.from,
                                       row.to,
                                       {left.from.index, left.to.index},
                                       {right.from.index, right.to.index}};
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
            sink_(DepthTested<Rational>{
                .pixel = pixel_at(*found), .depth = depth, .stored = held, .passes = passes});
            if (!passes)
                return;
            stored = depth;
        }
        plot({at.x, at.y * down_}, mixes_ ? mixed(triangle, at) : color_);
    }

    Color mixed(const ModelTriangle& triangle, GridPoint at) const {
        const ModelWeights shares = rules_.shares(triangle, weights_at(triangle, at));
        const auto channel = [&](std::uint8_t (Color::*of)() const) {
            const auto [a, b, c] = std::array{(triangle[0].color.*of)(), (triangle[1].color.*of)(),
                                              (triangle[2].color.*of)()};
            return a == b && a == c ? a
                                    : rules_.level(shares[0] * a + shares[1] * b + shares[2] * c);
        };
        return {channel(&Color::red), channel(&Color::green), channel(&Color::blue),
                std::max<std::uint8_t>(channel(&Color::alpha), 1)};
    }

    // --- Lines -----------------------------------------------------------------------------------

    void draw_line(ModelVertex from, ModelVertex to) {
        from = on_samples(from, sample_of_lines(method_));
        to = on_samples(to, sample_of_lines(method_));
        const bool is_on_grid = method_.line == LineMethod::bresenham;
        const ModelLine forward = rules_.line(from.at, to.at);
        const bool falls = is_on_grid           ? forward.last < forward.first
                           : forward.is_x_major ? to.at.x < from.at.x
                                                : to.at.y < from.at.y;
        if (method_.from == LineStart::low && falls)
            std::swap(from, to);
        const ModelLine line = rules_.line(from.at, to.at);
        const GridLine pixels{pixel_of(from), pixel_of(to), from.color, to.color};
        const Index last = line.steps - (method_.ends == EndPixels::both ? 0 : 1);
        if (is_on_grid)
            walk(line, pixels, last);
        else
            sample(line, pixels, last);
    }

    /// Bresenham's line: straight on, or diagonally?
    void walk(const ModelLine& line, const GridLine& pixels, Index last) {
        const bool steps_at_ties = line_rules(method_).ties.of(line.is_x_major) == Ties::step;
        GridPoint at = line.start, pixel = at;
        Index d = line.d;
        for (Index i = 0; i <= last; ++i) {
            plot(pixel, rules_.color_of_step(pixels, pixel, i, line.steps));
            const bool is_straight = d < 0 || (d == 0 && !steps_at_ties);
            const GridPoint step = is_straight ? line.straight : line.diagonal;
            const GridPoint kept = is_straight ? line.straight : line.kept;
            const GridPoint next{at.x + step.x, at.y + step.y};
            if (i < last && canvas_.contains(pixel.x, pixel.y) && canvas_.contains(next.x, next.y))
                sink_(LineDecided{pixel_at(pixel), d, move_of(step)});
            d += is_straight ? line.d_straight : line.d_diagonal;
            at = {at.x + kept.x, at.y + kept.y};
            pixel = next;
        }
    }

    /// A naive or dda line: the coordinate across at each step along its major axis.
    void sample(const ModelLine& line, const GridLine& pixels, Index last) {
        const Vec<Number, 2> offset = offset_of(sample_of_lines(method_), method_, down_);
        SpanRounding rounding = line_rounding(method_);
        rounding.ties = line_rules(method_).ties.of(line.is_x_major);
        const bool falls = line.is_x_major ? line.to.y < line.from.y : line.to.x < line.from.x;
        for (Index i = 0; i <= last; ++i) {
            const Index along = line.last < line.first ? line.first - i : line.first + i;
            const Rational across = rules_.across(line, along);
            const Index rounded = pixel_across(across, rounding, falls);
            if (canvas_.contains(line.is_x_major ? along : canvas_.left(),
                                 line.is_x_major ? canvas_.top() : along))
                sink_(LineSampled<Rational>{
                    line.is_x_major, along,
                    across + (line.is_x_major ? offset.y : offset.x).exact(), rounded});
            const GridPoint at =
                line.is_x_major ? GridPoint{along, rounded} : GridPoint{rounded, along};
            plot(at, rules_.color_of_step(pixels, at, i, line.steps));
        }
    }

    void plot(GridPoint at, Color color) {
        const auto found = rules_.on_canvas(at);
        if (!found)
            return sink_(PixelsRejected{at.x, at.y, at.x, at.y});
        image_.at(pixel_at(*found)) = color;
        sink_(PixelPlotted{pixel_at(*found), color});
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
    std::vector<ClipSpace> vertices_;
    int made_ = 0;       ///< vertices of the primitive that clipping has made
    int parts_ = 0;      ///< of it that have been drawn
    Rational area2_;     ///< of the triangle that is filled, twice
    Color color_;        ///< of its pixels, unless
    bool mixes_ = false; ///< they are mixed
};

} // namespace

bool has_model(const Scene& scene) {
    const auto is_near = [](const Number& x) { return abs(x.exact()) <= 100'000; };
    return !scene.has_tested_lines() && !scene.has(PrimitiveKind::polygon) &&
           !scene.has(PrimitiveKind::circle) && scene.method.fill != Fill::fan &&
           scene.method.line != LineMethod::diamond_exit &&
           std::all_of(
               scene.vertices.begin(), scene.vertices.end(),
               [&](const SceneVertex& vertex) { return is_near(vertex.x) && is_near(vertex.y); });
}

Image draw_by(const ModelRules& rules, const Listener& listener) {
    return ModelDrawing(rules, listener).drawn();
}

} // namespace rastertrace
