// SPDX-License-Identifier: MIT
#include "model/model_pieces.h"

#include "list/faces.h"

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
        for (std::size_t i = 0; i < scene_.vertices.size(); ++i)
            vertices_.push_back(moved(i));
        for (const std::size_t index : drawing_order())
            draw(scene_.primitives[index], index);
    }

private:
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
        return {{world.x, world.y, world.z},
                rules_.projection * camera,
                distance_along_view<Rational>(scene_, camera)};
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
    void draw(const ScenePrimitive& primitive, std::size_t index) {
        const Face<Rational> face = face_of(primitive);
        const Color color = method_.shade == Shade::faces ? color_of_face(index)
                            : face.lit                    ? face.lit->color
                                                          : primitive.color;
        std::vector<ClipVertex<Rational>> corners;
        bool is_whole = true;
        has_two_colors_ = false;
        for (const std::size_t corner : primitive.corners()) {
            const auto& [world, clip, distance] = vertices_[corner];
            const auto own = scene_.mixes_colors() ? scene_.vertices[corner].color : std::nullopt;
            corners.push_back({clip, distance, own ? *own : color, static_cast<int>(corner)});
            has_two_colors_ = has_two_colors_ || corners[0].color.of != corners.back().color.of;
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
                                       .color = color,
                                       .face = if_any(scene_.face_of(primitive))});
        if (!tell_face(face, sink_))
            return;
        const bool is_outline = primitive.kind == PrimitiveKind::outline;
        for (std::size_t side = 0; side < (is_outline ? 3 : 1); ++side) {
            auto polygon =
                is_outline ? std::vector{corners[side], corners[(side + 1) % 3]} : corners;
            const std::size_t fewest = std::min<std::size_t>(polygon.size(), 3);
            for (const ClipPlane<Rational>& plane : rules_.planes)
                polygon = clip(polygon, plane);
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
        std::vector<std::array<Rational, 4>> levels;
        const bool is_cut = scene_.mixes_colors() &&
                            std::any_of(corners.begin(), corners.end(),
                                        [](const auto& corner) { return corner.original < 0; }) &&
                            has_two_colors_;
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
                colors.push_back(vertex.color.rounded(method_.color_rounding));
            if (is_cut)
                levels.push_back(vertex.color.of);
        }
        ++parts_;
        const PrimitiveKind kind = corners.size() == 2 ? PrimitiveKind::line : primitive.kind;
        const std::string name =
            is_part ? primitive.name + "/" + std::to_string(parts_) : primitive.name;
        const std::vector<std::string_view> told_names(names.begin(), names.end());
        sink_(PrimitiveBegan<Rational>{.kind = kind,
                                       .name = name,
                                       .vertices = told_names,
                                       .at = if_any(positions),
                                       .depths = if_any(depths),
                                       .color = color,
                                       .colors = if_any(colors),
                                       .levels = if_any(levels),
                                       .part = is_part ? std::optional(true) : std::nullopt,
                                       .face = if_any(scene_.face_of(primitive))});
        if (tell_face(face, sink_))
            draw_({kind, std::move(on_screen), color});
    }

    const ModelRules& rules_;
    const Scene& scene_;
    const Method& method_;
    const bool has_buffer_;
    const ListenerSink& sink_;
    const std::function<void(const ModelPiece&)>& draw_;
    std::vector<ClipSpace> vertices_;
    int made_ = 0;                ///< vertices of the primitive that clipping has made
    int parts_ = 0;               ///< of it that have been drawn
    bool has_two_colors_ = false; ///< its corners, or more
};

} // namespace

void for_each_piece(const ModelRules& rules, const ListenerSink& sink,
                    const std::function<void(const ModelPiece&)>& draw) {
    ModelPieces(rules, sink, draw).hand_on();
}

} // namespace rastertrace
