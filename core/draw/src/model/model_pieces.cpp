// SPDX-License-Identifier: MIT
#include "model/model_pieces.h"

#include "list/clipping.h"
#include "list/faces.h"
#include "list/vertex_spaces.h"

#include <rastertrace/core/draw/list/drawing_order.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/raster/clip.h>
#include <rastertrace/core/raster/shading.h>

#include <numeric>
#include <string>
#include <utility>

namespace rastertrace {

namespace {

using Point3 = Vec<Rational, 3>;
using Point4 = Vec<Rational, 4>;

class ModelPieces {
public:
    ModelPieces(const ModelRules& rules, const ListenerSink& sink,
                const std::function<void(const ModelPiece&)>& draw)
        : rules_(rules), scene_(rules.scene), method_(scene_.method),
          has_buffer_(scene_.has_depth_buffer()), sink_(sink), draw_(draw) {}

    void hand_on() {
        is_used_ = used_vertices(scene_);
        divides_ = scene_.keep.has(Stage::divide);
        for (std::size_t i = 0; i < scene_.vertices.size(); ++i) {
            vertices_.push_back(moved(i));
            divides_ = divides_ || (is_used_[i] && vertices_[i].clip.w != 1);
        }
        culled_sides_ = culled_sides_of(
            scene_, [this](std::size_t index) { return !face_of(scene_.primitives[index]).skip; });
        tell_matrices();
        if (scene_.has_transforms() || scene_.keeps_transforms())
            tell_vertices();
        for (const std::size_t index : drawing_order())
            draw(index);
    }

private:
    /// A vertex in the spaces before clipping.
    struct Spaces {
        Point4 object;
        Point4 world;
        Point4 camera;
        Point4 clip;
        Rational distance; ///< from the eye along the view
    };

    const ModelMatrix& model_of(std::size_t vertex) const {
        for (std::size_t i = 0; i < scene_.objects.size(); ++i)
            if (vertex < scene_.objects[i].end_vertex)
                return rules_.models[i];
        return no_model_;
    }

    Spaces moved(std::size_t index) const {
        const SceneVertex& vertex = scene_.vertices[index];
        Spaces in;
        in.object = {vertex.x.exact(), vertex.y.exact(), vertex.z.exact(), vertex.w.exact()};
        in.world = model_of(index).product * in.object;
        in.camera = rules_.view.product * in.world;
        in.clip = rules_.projection.product * in.camera;
        in.distance = distance_along_view<Rational>(scene_, in.camera);
        return in;
    }

    /// A vertex after clipping.
    struct OnScreen {
        Point3 canonical;
        Vec<Rational, 2> screen;
        Vec<Rational, 2> placed;
    };

    OnScreen on_screen(const Point4& clip) const {
        const Point3 canonical = rules_.divided(clip);
        const Point4 screen =
            rules_.viewport.product * Point4{canonical.x, canonical.y, canonical.z, 1};
        return {canonical, {screen.x, screen.y}, rules_.placed({screen.x, screen.y})};
    }

    bool is_in_view(const Point4& clip) const {
        return std::all_of(rules_.planes.begin(), rules_.planes.end(),
                           [&clip](const auto& plane) { return plane.has_inside(clip); });
    }

    // --- What is told of all -----------------------------------------------------------------------

    /// True of a matrix that moves something, or that the scene keeps.
    bool is_told(const ModelMatrix& matrix, Stage stage) const {
        return matrix.product != identity<Rational>() ||
               (scene_.keep.has(stage) && !begins_in_clip_space());
    }
    bool begins_in_clip_space() const {
        return scene_.projection.type == ProjectionType::clip_space;
    }
    bool projects() const {
        return scene_.projection.type != ProjectionType::none && !begins_in_clip_space();
    }

    void tell_matrices() const {
        const auto tell = [this](std::string_view name, std::string_view object,
                                 const ModelMatrix& matrix, const Camera* camera) {
            tell_matrix<Rational>(name, object, std::optional(matrix.product), matrix.factors,
                                  camera, sink_.listener());
        };
        for (std::size_t i = 0; i < rules_.models.size(); ++i)
            if (is_told(rules_.models[i], Stage::model))
                tell("model", scene_.objects[i].name, rules_.models[i], nullptr);
        if (scene_.objects.empty() && is_told(no_model_, Stage::model))
            tell("model", {}, no_model_, nullptr);
        if (is_told(rules_.view, Stage::view))
            tell("view", {}, rules_.view, scene_.camera ? &*scene_.camera : nullptr);
        if (projects())
            tell("projection", {}, rules_.projection, nullptr);
        if (scene_.viewport.type != ViewportType::none)
            tell("viewport", {}, rules_.viewport, nullptr);
    }

    /// Every vertex that is used, through its spaces; one that is not in view stops at clip space.
    void tell_vertices() const {
        for (std::size_t i = 0; i < vertices_.size(); ++i)
            if (is_used_[i])
                tell_vertex(i);
    }

    void tell_vertex(std::size_t index) const {
        const auto tell = [&](Space space, const Point4& at, std::size_t count) {
            tell_position<Rational>(scene_.vertices[index].name, space, at, count,
                                    sink_.listener());
        };
        const Spaces& in = vertices_[index];
        if (is_told(model_of(index), Stage::model))
            tell(Space::object, in.object, 3);
        if (!begins_in_clip_space())
            tell(Space::world, in.world, 3);
        if (is_told(rules_.view, Stage::view))
            tell(Space::camera, in.camera, 3);
        if (projects() || begins_in_clip_space())
            tell(Space::clip, in.clip, 4);
        if (!is_in_view(in.clip))
            return;
        tell_on_screen(scene_.vertices[index].name, in.clip);
    }

    void tell_on_screen(const std::string& name, const Point4& clip) const {
        const auto [canonical, screen, placed] = on_screen(clip);
        if ((projects() || begins_in_clip_space()) && divides_)
            tell_position<Rational>(name, Space::canonical,
                                    {canonical.x, canonical.y, canonical.z, 1}, 3,
                                    sink_.listener());
        // Where a rule places vertices without snapping them, that is their place on the screen.
        const bool snaps = method_.snap != Snap::none;
        const Vec<Rational, 2>& at = snaps ? screen : placed;
        const std::array<Rational, 2> told{at.x, at.y}, snapped{placed.x, placed.y};
        sink_(VertexPlaced<Rational>{.name = name,
                                     .space = Space::screen,
                                     .at = told,
                                     .snapped = snaps ? if_any(snapped) : std::nullopt});
    }

    std::vector<std::size_t> drawing_order() const {
        std::vector<std::size_t> as_listed(scene_.primitives.size());
        std::iota(as_listed.begin(), as_listed.end(), 0);
        if (scene_.depth() != Depth::painter)
            return as_listed;
        auto keys = keys_of_faces<Rational>(
            scene_, [this](std::size_t i) -> const Rational& { return vertices_[i].distance; });
        const int sign = rules_.paints_farthest_first ? 1 : -1;
        for (Rational& key : keys)
            key *= sign;
        PainterOrder<Rational> order = sorted_by_distance(scene_, keys);
        if (order.primitives == as_listed && !scene_.keep.has(Stage::order))
            return as_listed;
        for (Rational& key : order.keys)
            key *= sign;
        tell_order(scene_, order, sink_.listener());
        return order.primitives;
    }

    // --- One primitive ------------------------------------------------------------------------------

    /// Is it seen, and in which light?
    Face<Rational> face_of(const ScenePrimitive& primitive) const {
        Face<Rational> face;
        std::vector<Point3> world;
        for (const std::size_t corner : primitive.corners()) {
            const Point4& at = vertices_[corner].world;
            world.push_back({at.x, at.y, at.z});
        }
        const Point3 normal = normal_of<Rational>(world);
        const Point3 centroid = centroid_of<Rational>(world);
        if (has_no_length<Rational>(normal))
            face.skip = SkipReason::zero_area;
        if (!face.skip && method_.cull != Cull::none) {
            face.tested = tested_face<Rational>(scene_, eye(), normal, centroid);
            auto& tested = *face.tested;
            tested.dot = rules_.facing(normal, tested.view);
            tested.culled = is_culled(method_.cull, tested.dot);
            tested.opposite = is_culled(method_.cull, Rational(-tested.dot));
            if (tested.culled)
                face.skip = SkipReason::culled;
        }
        if (!face.skip && method_.shade == Shade::lambert) {
            face.lit = lit_face<Rational>(scene_, primitive.color, normal, centroid);
            face.lit->intensity = rules_.intensity(normal, face.lit->light);
            face.lit->color = lit(primitive.color, face.lit->intensity, method_.color_rounding);
        }
        return face;
    }

    /// Where it is, or in a parallel view the direction to it.
    Point3 eye() const {
        if (is_perspective(scene_.projection.type))
            return exact(scene_.camera ? scene_.camera->position : Numbers3{0, 0, 0});
        return scene_.camera ? axes_of(*scene_.camera).back : Point3{0, 0, 1};
    }

    /// Tests the face, clips, and draws what is left: the primitive, or parts of it.
    void draw(std::size_t index) {
        const ScenePrimitive& primitive = scene_.primitives[index];
        Face<Rational> face;
        if (has_face(scene_, primitive))
            face = face_of(primitive);
        else if (!culled_sides_.empty() && culled_sides_[index])
            face.skip = SkipReason::culled;
        const Color color = method_.shade == Shade::faces ? color_of_face(index)
                            : face.lit                    ? face.lit->color
                                                          : primitive.color;
        std::vector<ClipVertex<Rational>> corners;
        bool is_whole = true;
        has_two_colors_ = false;
        for (const std::size_t corner : primitive.corners()) {
            const Spaces& in = vertices_[corner];
            const auto own = scene_.mixes_colors() ? scene_.vertices[corner].color : std::nullopt;
            corners.push_back({in.clip, in.distance, own ? *own : color, static_cast<int>(corner)});
            has_two_colors_ = has_two_colors_ || corners[0].color.of != corners.back().color.of;
            is_whole = is_whole && is_in_view(in.clip);
        }
        if (rules_.drops(corners))
            return;
        made_ = parts_ = 0;
        if (is_whole)
            return draw_piece(index, corners, color, face);

        std::vector<std::string_view> names;
        for (const std::size_t corner : primitive.corners())
            names.push_back(scene_.vertices[corner].name);
        sink_(PrimitiveBegan<Rational>{.kind = primitive.kind,
                                       .name = primitive.name,
                                       .vertices = names,
                                       .color = color,
                                       .radius = radius_of(primitive),
                                       .face = if_any(scene_.face_of(primitive))});
        if (tell_face(face, sink_))
            clip_and_draw(index, corners, color);
    }

    /// The sides of an outline are clipped one by one; what is left of a triangle is a fan.
    void clip_and_draw(std::size_t index, const std::vector<ClipVertex<Rational>>& corners,
                       Color color) {
        const ScenePrimitive& primitive = scene_.primitives[index];
        const bool is_outline = primitive.kind == PrimitiveKind::outline;
        std::optional<SkipReason> reason;
        for (std::size_t side = 0; side < (is_outline ? corners.size() : 1); ++side) {
            auto polygon = is_outline
                               ? std::vector{corners[side], corners[(side + 1) % corners.size()]}
                               : corners;
            reason = clip_at_planes(primitive.name, polygon, rules_.planes, sink_.listener());
            for (ClipVertex<Rational>& vertex : polygon)
                if (vertex.original < 0) {
                    vertex.original = -++made_;
                    tell_made(made_name(primitive, vertex), vertex.position);
                }
            const bool is_fan = polygon.size() > 3 && !traits_of(primitive.kind).has_ring;
            if (!polygon.empty() && !is_fan)
                draw_part(index, polygon, color, side);
            for (std::size_t i = 2; is_fan && i < polygon.size(); ++i)
                draw_part(index, {polygon[0], polygon[i - 1], polygon[i]}, color, side);
        }
        if (parts_ == 0)
            sink_(PrimitiveSkipped<>{.why = *reason});
    }

    static std::string made_name(const ScenePrimitive& primitive,
                                 const ClipVertex<Rational>& vertex) {
        return primitive.name + ":" + std::to_string(-vertex.original);
    }

    /// A vertex that clipping has made.
    void tell_made(const std::string& name, const Point4& clip) const {
        tell_position<Rational>(name, Space::clip, clip, 4, sink_.listener());
        tell_on_screen(name, clip);
    }

    void draw_part(std::size_t index, const std::vector<ClipVertex<Rational>>& corners, Color color,
                   std::size_t side) {
        ++parts_;
        draw_piece(index, corners, color, {}, side);
    }

    /// Divides by w, and draws a primitive or a part of it.
    void draw_piece(std::size_t index, const std::vector<ClipVertex<Rational>>& corners,
                    Color color, const Face<Rational>& face, std::size_t side = 0) {
        const ScenePrimitive& primitive = scene_.primitives[index];
        const bool is_part = parts_ > 0;
        const bool is_side = is_part && primitive.kind == PrimitiveKind::outline;
        ModelPiece piece{index, is_side ? PrimitiveKind::line : primitive.kind, {}, color, side};
        std::vector<std::string> names;
        std::vector<Vec<Rational, 2>> positions;
        std::vector<Rational> depths;
        std::vector<Color> colors;
        std::vector<std::array<Rational, 4>> levels;
        bool is_cut = false;
        for (const ClipVertex<Rational>& vertex : corners) {
            const bool is_made = vertex.original < 0;
            const Rational& w = vertex.position.w;
            piece.corners.push_back(
                {on_screen(vertex.position).placed,
                 has_buffer_ ? rules_.depth_of(vertex.distance, vertex.position) : Rational(0),
                 w == 0 ? Rational(0) : Rational(1 / w), vertex.color,
                 static_cast<std::uint16_t>(piece.corners.size())});
            const ModelVertex& corner = piece.corners.back();
            names.push_back(is_made
                                ? made_name(primitive, vertex)
                                : scene_.vertices[static_cast<std::size_t>(vertex.original)].name);
            is_cut = is_cut || (is_made && has_two_colors_);
            positions.push_back(corner.at);
            depths.push_back(corner.depth);
            colors.push_back(corner.color.rounded(method_.color_rounding));
            levels.push_back(corner.color.of);
        }
        // A ring has neither depths nor colors of vertices.
        const bool has_colors = scene_.mixes_colors() && !traits_of(primitive.kind).has_ring;
        const std::vector<std::string_view> told_names(names.begin(), names.end());
        sink_(PrimitiveBegan<Rational>{
            .kind = piece.kind,
            .name = is_part ? primitive.name + "/" + std::to_string(parts_) : primitive.name,
            .vertices = told_names,
            .at = if_any(positions),
            .depths = has_buffer_ ? if_any(depths) : std::nullopt,
            .color = color,
            .colors = has_colors ? if_any(colors) : std::nullopt,
            .levels = has_colors && is_cut ? if_any(levels) : std::nullopt,
            .octant =
                piece.kind == PrimitiveKind::line ? std::optional(octant_of(piece)) : std::nullopt,
            .part = is_part ? std::optional(true) : std::nullopt,
            .painted = primitive.is_painted ? std::nullopt : std::optional(false),
            .radius = radius_of(primitive),
            .face = if_any(scene_.face_of(primitive))});
        if (tell_face(face, sink_))
            draw_(piece);
    }

    Index octant_of(const ModelPiece& line) const {
        const Rational offset = offset_of(sample_of_lines(method_)).exact();
        const auto [from, to] = directed(rules_, on_samples(line.corners[0], offset),
                                         on_samples(line.corners[1], offset));
        return rastertrace::octant_of(pixel_of(from.at), pixel_of(to.at));
    }

    const ModelRules& rules_;
    const Scene& scene_;
    const Method& method_;
    const bool has_buffer_;
    const ListenerSink& sink_;
    const std::function<void(const ModelPiece&)>& draw_;
    const ModelMatrix no_model_{{}, identity<Rational>()};
    std::vector<Spaces> vertices_;
    std::vector<bool> is_used_;
    bool divides_ = false;           ///< w is not 1 at every vertex
    std::vector<bool> culled_sides_; ///< as of culled_sides_of
    int made_ = 0;                   ///< vertices of the primitive that clipping has made
    int parts_ = 0;                  ///< of it that have been drawn
    bool has_two_colors_ = false;    ///< its corners, or more
};

} // namespace

ModelVertex on_samples(ModelVertex vertex, const Rational& offset) {
    vertex.at.x -= offset;
    vertex.at.y -= offset;
    return vertex;
}

std::pair<ModelVertex, ModelVertex> directed(const ModelRules& rules, const ModelVertex& from,
                                             const ModelVertex& to) {
    const Method& method = rules.scene.method;
    const ModelLine line = rules.line(from.at, to.at);
    const bool runs_down = traits_of(method.line).rule == LineRule::grid ? line.last < line.first
                           : line.is_x_major                             ? to.at.x < from.at.x
                                                                         : to.at.y < from.at.y;
    return method.from == LineStart::low && runs_down ? std::pair{to, from} : std::pair{from, to};
}

void for_each_piece(const ModelRules& rules, const ListenerSink& sink,
                    const std::function<void(const ModelPiece&)>& draw) {
    ModelPieces(rules, sink, draw).hand_on();
}

} // namespace rastertrace
