// SPDX-License-Identifier: MIT
#pragma once

// A scene: what is drawn, on which canvas, by which method. Numbers are held as they were typed.
//
//     Scene scene;
//     scene.canvas = {.width = 17, .height = 14};
//     scene.vertices = {{"A", 2, 5}, {"B", -4, -3}, {"C", 5, -3}};
//     scene.primitives = {{.kind = PrimitiveKind::triangle, .name = "ABC", .vertices = {0, 1, 2}}};

#include <rastertrace/core/camera.h>
#include <rastertrace/core/canvas.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/method.h>
#include <rastertrace/core/number.h>
#include <rastertrace/core/projection.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/transform.h>
#include <rastertrace/core/viewport.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rastertrace {

/// A named point of the scene.
struct SceneVertex {
    std::string name;
    Number x;
    Number y;
    std::optional<Color> color = {}; ///< for pixels that are mixed from those of the vertices
    Number z = 0;
};

/// Vertices that share an object space: the scene's own, or those of a mesh.
struct SceneObject {
    std::string name;             ///< "" for the scene's own vertices
    std::size_t end_vertex = 0;   ///< its vertices are those from the end of the object before
    std::vector<ModelStep> model; ///< from its space to the world
};

/// A point, a line, a triangle to fill, or the outline of a triangle.
struct ScenePrimitive {
    PrimitiveKind kind = PrimitiveKind::triangle;
    std::string name;
    std::array<std::size_t, 3> vertices{}; ///< places in Scene::vertices, in the author's order
    Color color = {};

    /// Its vertices: the first one, two or three of `vertices`.
    std::span<const std::size_t> corners() const {
        return std::span(vertices).first(corner_count(kind));
    }

    /// How many vertices a primitive of a kind has.
    static constexpr std::size_t corner_count(PrimitiveKind kind) {
        switch (kind) {
        case PrimitiveKind::point:
            return 1;
        case PrimitiveKind::line:
            return 2;
        case PrimitiveKind::outline:
        case PrimitiveKind::triangle:
            break;
        }
        return 3;
    }
};

/// Everything needed to draw a picture.
struct Scene {
    std::string title;
    Canvas canvas;
    std::vector<SceneVertex> vertices;
    std::vector<ScenePrimitive> primitives; ///< drawn in this order
    Method method;

    std::vector<SceneObject> objects; ///< none: no vertex has a model
    std::optional<Camera> camera;     ///< none: the world is the camera's space
    Projection projection;
    Viewport viewport;

    /// True if vertices are moved before they are drawn: the places as typed are not those on the
    /// screen.
    bool has_pipeline() const {
        return camera || projection.type != ProjectionType::none ||
               viewport.type != ViewportType::none || method.snap != Snap::none ||
               std::any_of(objects.begin(), objects.end(),
                           [](const SceneObject& one) { return !one.model.empty(); });
    }

    /// True if it has a primitive of this kind.
    bool has(PrimitiveKind kind) const {
        return std::any_of(primitives.begin(), primitives.end(),
                           [kind](const ScenePrimitive& one) { return one.kind == kind; });
    }

    /// True if pixels are mixed from the colors of vertices.
    bool mixes_colors() const {
        const bool have_colors = std::any_of(vertices.begin(), vertices.end(),
                                             [](const SceneVertex& one) { return !!one.color; });
        return method.shade.value_or(have_colors ? Shade::interpolate : Shade::flat) ==
               Shade::interpolate;
    }
};

} // namespace rastertrace
