// SPDX-License-Identifier: MIT
#pragma once

// A scene: what is drawn, on which canvas, by which method. Numbers are held as they were typed.
//
//     Scene scene;
//     scene.canvas = {.width = 17, .height = 14};
//     scene.vertices = {{"A", 2, 5}, {"B", -4, -3}, {"C", 5, -3}};
//     scene.primitives = {{.kind = PrimitiveKind::triangle, .name = "ABC", .vertices = {0, 1, 2}}};

#include <rastertrace/core/draw/scene/method.h>
#include <rastertrace/core/draw/scene/stage.h>
#include <rastertrace/core/draw/scene/transforms.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <string>

namespace rastertrace {

/// A named point of the scene.
struct SceneVertex {
    std::string name;
    Number x;
    Number y;
    std::optional<Color> color = {}; ///< for pixels that are mixed from those of the vertices
    Number z = 0;
    Number w = 1; ///< of a vertex that is typed in clip space
};

/// Vertices that share an object space: the scene's own, or those of a mesh.
struct SceneObject {
    std::string name;           ///< "" for the scene's own vertices
    std::size_t end_vertex = 0; ///< its vertices are those from the end of the object before
    Model model;                ///< from its space to the world
};

/// What a scene draws.
struct ScenePrimitive {
    PrimitiveKind kind = PrimitiveKind::triangle;
    bool is_painted = true; ///< false: a triangle that hides what lies behind it, and is not seen
    bool is_side = false;   ///< a line that is drawn only if a face that it bounds is drawn
    std::string name;
    std::array<std::size_t, 3> vertices{}; ///< indices in Scene::vertices, in the author's order
    Color color = {};
    std::uint32_t polygon =
        0; ///< successive triangles with the same number above 0 make a face, see Scene::face_of

    std::int32_t radius = 0; ///< around its vertex, in pixels, if its kind has one
    std::vector<std::size_t> ring =
        {}; ///< all its vertices, in the place of `vertices`, if its kind has a ring

    /// Its vertices: the first one, two or three of `vertices`, or those of the ring.
    std::span<const std::size_t> corners() const {
        const PrimitiveTraits traits = traits_of(kind);
        return traits.has_ring ? std::span(ring) : std::span(vertices).first(traits.corners);
    }
};

/// The radius of a primitive, or of a piece of one, if its kind has one.
template <typename Primitive> std::optional<Index> radius_of(const Primitive& primitive) {
    return traits_of(primitive.kind).has_radius ? std::optional<Index>(primitive.radius)
                                                : std::nullopt;
}

/// A concave face of a mesh, and how it was cut into triangles (triangulate.h).
struct CutFace {
    std::string name;
    std::vector<std::size_t> corners; ///< indices in Scene::vertices, in the author's order
    Vec<Rational, 3> normal;          ///< Newell's, in object space
    std::size_t dropped = 0;          ///< the axis along which it was seen: 0 is x
    std::size_t first_ear = 0;        ///< index in Scene::primitives
    std::size_t ears = 0;             ///< how many of them are its triangles
};

/// Where light comes from, in the world.
struct Light {
    enum class Kind {
        direction, ///< from everywhere to the light
        position,
    };
    Kind kind = Kind::direction;
    Numbers3 at{0, 0, 1};
};

/// Everything needed to draw a picture.
struct Scene {
    std::string title;
    Canvas canvas;
    std::optional<Color> background; ///< of pixels that nothing draws
    std::vector<SceneVertex> vertices;
    std::vector<ScenePrimitive> primitives; ///< drawn in this order
    Method method;

    std::vector<std::string>
        face_names; ///< of those that were cut into triangles, by ScenePrimitive::polygon from 1
    std::vector<CutFace> cut_faces;
    std::vector<SceneObject> objects; ///< none: no vertex has a model
    std::optional<Camera> camera;     ///< none: world space is camera space
    Projection projection;
    Viewport viewport;
    std::optional<Light> light;
    StageSet keep; ///< stages that run although the scene does not need them

    /// How hidden surfaces are found.
    Depth depth() const {
        if (method.depth)
            return *method.depth;
        if (viewport.depths || projection.type == ProjectionType::clip_space)
            return Depth::ndc_z;
        return is_perspective(projection.type)                   ? Depth::inverse_z
               : projection.type == ProjectionType::orthographic ? Depth::linear_z
                                                                 : Depth::none;
    }

    /// What the colors of lines go by, and of a fan, which has only lines.
    ColorLerp color_lerp() const {
        const bool is_in_perspective =
            shade() == Shade::interpolate && is_perspective(projection.type);
        return method.color_lerp.value_or(is_in_perspective ? ColorLerp::space : ColorLerp::axis);
    }

    /// True if colors of lines, or of a fan, are mixed by their places in space.
    bool mixes_lines_in_space() const {
        return mixes_colors() && color_lerp() == ColorLerp::space &&
               (has(PrimitiveKind::line) || has(PrimitiveKind::outline) ||
                (has(PrimitiveKind::triangle) && method.fill == Fill::fan));
    }

    /// True if colors of vertices are mixed in perspective.
    bool mixes_in_perspective() const {
        const bool mixes_triangles = has(PrimitiveKind::triangle) && method.fill != Fill::fan;
        return shade() == Shade::interpolate && is_perspective(projection.type) &&
               (mixes_triangles || mixes_lines_in_space());
    }

    /// True if pixels are tested against a depth buffer: never those of a fill without depths.
    bool has_depth_buffer() const {
        const Depth in_force = depth();
        return in_force != Depth::none && in_force != Depth::painter &&
               traits_of(method.fill).depths != DepthForm::none;
    }

    /// True if points or lines are tested against the depth buffer, too.
    bool has_tested_lines() const {
        return has_depth_buffer() &&
               std::any_of(primitives.begin(), primitives.end(),
                           [](const ScenePrimitive& one) { return !is_filled(one.kind); });
    }

    /// True if faces are culled or lit: their normals are needed.
    bool tests_faces() const {
        return has_faces() && (method.cull != Cull::none || method.shade == Shade::lambert);
    }

    /// True if vertices go through their spaces: x and y as typed are not all that is drawn with.
    bool has_pipeline() const { return needs_pipeline() || keeps_transforms(); }

    /// True if they would without the stages that `keep` names.
    bool needs_pipeline() const {
        return has_transforms() || tests_faces() || depth() != Depth::none;
    }

    /// True if vertices as typed are not in screen space.
    bool has_transforms() const {
        return camera || projection.type != ProjectionType::none ||
               viewport.type != ViewportType::none || method.snap != Snap::none ||
               std::any_of(objects.begin(), objects.end(),
                           [](const SceneObject& object) { return !object.model.steps().empty(); });
    }

    /// True if `keep` names a stage that moves vertices.
    bool keeps_transforms() const {
        return keep.has(Stage::model) || keep.has(Stage::view) || keep.has(Stage::divide);
    }

    /// The name of the face that a triangle is a part of; "" if it is one of its own, or of one without a name.
    std::string_view face_of(const ScenePrimitive& primitive) const {
        const bool has_name = 0 < primitive.polygon && primitive.polygon <= face_names.size();
        return has_name ? std::string_view(face_names[primitive.polygon - 1]) : std::string_view();
    }

    /// True if it has a primitive of this kind.
    bool has(PrimitiveKind kind) const {
        return std::any_of(primitives.begin(), primitives.end(),
                           [kind](const ScenePrimitive& one) { return one.kind == kind; });
    }

    /// True if it has a triangle or a polygon to fill.
    bool has_faces() const { return has(PrimitiveKind::triangle) || has(PrimitiveKind::polygon); }

    /// Where the colors of pixels come from.
    Shade shade() const {
        if (method.shade)
            return *method.shade;
        const bool has_colors = std::any_of(vertices.begin(), vertices.end(),
                                            [](const auto& vertex) { return !!vertex.color; });
        return has_colors ? Shade::interpolate : Shade::flat;
    }

    /// True if pixels are mixed from the colors of vertices.
    bool mixes_colors() const {
        const Shade in_force = shade();
        return in_force == Shade::interpolate || in_force == Shade::affine;
    }
};

} // namespace rastertrace
