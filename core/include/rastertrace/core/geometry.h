// SPDX-License-Identifier: MIT
#pragma once

// The stages before anything is drawn: every vertex on its way from object space to the screen.
//
//     object --model--> world --view--> camera --projection--> clip --/w--> canonical
//            --viewport--> screen
//
// Primitives are clipped in clip space, so that nothing is divided by a w of 0 or less, and come out
// as pieces that lie on the screen.
//
//     const auto geometry = geometry_of<double>(scene);
//     for_each_piece(scene, geometry, sink, [](const Piece<double>& piece) { /* draw it */ });

#include <rastertrace/core/camera.h>
#include <rastertrace/core/clip.h>
#include <rastertrace/core/matrix.h>
#include <rastertrace/core/projection.h>
#include <rastertrace/core/rounding.h>
#include <rastertrace/core/scalar.h>
#include <rastertrace/core/scene.h>
#include <rastertrace/core/sink.h>
#include <rastertrace/core/steps.h>
#include <rastertrace/core/transform.h>
#include <rastertrace/core/vec.h>
#include <rastertrace/core/viewport.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The four sides of the space that is not clipped stand this many half canvases from the middle of
/// the picture. Nearer than that, it is the fill that drops what the canvas does not have, at the
/// cost of the canvas; every place on the screen stays below 2^26 pixels.
inline constexpr int guard_band = 4096;

/// The matrices of a scene; those that it does not have leave a vertex where it is.
template <typename Scalar> struct Transforms {
    std::vector<std::optional<Matrix<Scalar>>> models; ///< of the scene's objects
    std::optional<Matrix<Scalar>> view;
    std::optional<Matrix<Scalar>> projection;
    std::optional<Matrix<Scalar>> viewport;
    std::vector<ClipPlane<Scalar>> planes;
    Snap snap = Snap::none;
    Ties ties = Ties::up; ///< of Snap::nearest
};

template <typename Scalar> Transforms<Scalar> transforms_of(const Scene& scene) {
    Transforms<Scalar> result;
    for (const SceneObject& object : scene.objects)
        result.models.push_back(object.model.empty()
                                    ? std::nullopt
                                    : std::optional(rounded<Scalar>(model_matrix(object.model))));
    if (scene.camera)
        result.view =
            rounded<Scalar>(view_matrix(*scene.camera, view_axis_of(scene.projection.type)));
    if (scene.projection.type != ProjectionType::none)
        result.projection = rounded<Scalar>(projection_matrix(scene.projection, scene.canvas));
    if (scene.viewport.type != ViewportType::none)
        result.viewport = rounded<Scalar>(viewport_matrix(scene.viewport, scene.canvas));

    const auto nearest = [](const Rational& exact) { return nearest_scalar<Scalar>(exact); };
    for (const ClipPlane<Rational>& plane :
         clip_planes(scene.projection, half_extent(scene.viewport, scene.canvas.width),
                     half_extent(scene.viewport, scene.canvas.height), guard_band))
        result.planes.push_back({plane.name,
                                 {nearest(plane.factors.x), nearest(plane.factors.y),
                                  nearest(plane.factors.z), nearest(plane.factors.w)},
                                 nearest(plane.constant)});
    result.snap = scene.method.snap;
    result.ties = scene.method.ties.value_or(Ties::up);
    return result;
}

/// True if a matrix of the scene has irrational entries, which are the nearest doubles instead.
inline bool has_rounded_matrix(const Scene& scene) {
    return (scene.camera && is_rounded(*scene.camera)) || is_rounded(scene.projection) ||
           std::any_of(scene.objects.begin(), scene.objects.end(), [](const SceneObject& object) {
               return std::any_of(object.model.begin(), object.model.end(),
                                  [](const ModelStep& step) { return is_rounded(step); });
           });
}

/// `matrix` times `vector`, or `vector` itself if there is no matrix.
template <typename Scalar>
Vec<Scalar, 4> moved(const std::optional<Matrix<Scalar>>& matrix, const Vec<Scalar, 4>& vector) {
    return matrix ? *matrix * vector : vector;
}

/// The first spaces of a vertex, in homogeneous coordinates.
template <typename Scalar> struct VertexPlaces {
    Vec<Scalar, 4> object;
    Vec<Scalar, 4> world;
    Vec<Scalar, 4> camera;
    Vec<Scalar, 4> clip;
};

template <typename Scalar>
VertexPlaces<Scalar> places_of(const SceneVertex& vertex,
                               const std::optional<Matrix<Scalar>>& model,
                               const Transforms<Scalar>& transforms) {
    VertexPlaces<Scalar> places;
    places.object = {scalar_from<Scalar>(vertex.x), scalar_from<Scalar>(vertex.y),
                     scalar_from<Scalar>(vertex.z), scalar_from<Scalar>(1)};
    places.world = moved(model, places.object);
    places.camera = moved(transforms.view, places.world);
    places.clip = moved(transforms.projection, places.camera);
    return places;
}

/// The last spaces of a vertex. `pixel` is where it is drawn: on the screen, snapped if it is to be.
template <typename Scalar> struct ScreenPlaces {
    Vec<Scalar, 4> canonical;
    Vec<Scalar, 2> screen;
    Vec<Scalar, 2> pixel;
};

/// x/w, y/w and z/w, moved to the screen. w must not be 0.
template <typename Scalar>
ScreenPlaces<Scalar> places_on_screen(const Vec<Scalar, 4>& clip,
                                      const Transforms<Scalar>& transforms) {
    const Vec<Scalar, 4> canonical{Scalar(clip.x / clip.w), Scalar(clip.y / clip.w),
                                   Scalar(clip.z / clip.w), scalar_from<Scalar>(1)};
    const Vec<Scalar, 4> screen = moved(transforms.viewport, canonical);
    const auto snapped = [&transforms](const Scalar& x) {
        switch (transforms.snap) {
        case Snap::floor:
            return scalar_from<Scalar>(floor_index(x));
        case Snap::truncate:
            return scalar_from<Scalar>(truncate_index(x));
        case Snap::nearest:
            return scalar_from<Scalar>(nearest_index(x, transforms.ties));
        case Snap::none:
            break;
        }
        return x;
    };
    return {.canonical = canonical,
            .screen = {screen.x, screen.y},
            .pixel = {snapped(screen.x), snapped(screen.y)}};
}

/// A vertex before clipping.
template <typename Scalar> struct PlacedVertex {
    Vec<Scalar, 4> clip;
    Vec<Scalar, 2> pixel;    ///< where it is drawn, if it
    bool is_in_view = false; ///< lies outside no plane
};

/// A scene without a pipeline: vertices are drawn where they were typed.
struct TypedGeometry {};

/// The places of all vertices that a primitive has.
template <typename Scalar> struct Geometry {
    Transforms<Scalar> transforms;
    std::vector<PlacedVertex<Scalar>> vertices; ///< as in Scene::vertices
    std::vector<bool> is_used;                  ///< by a primitive; the others are not placed
};

/// Calls `visit(place, vertex, model)` with each vertex that is used, and the place of its object.
template <typename Scalar, typename Visit>
void for_each_used_vertex(const Scene& scene, const Geometry<Scalar>& geometry, Visit&& visit) {
    const std::optional<Matrix<Scalar>> no_model;
    std::size_t object = 0;
    for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
        while (object < scene.objects.size() && i >= scene.objects[object].end_vertex)
            ++object;
        if (geometry.is_used[i])
            visit(i, object < scene.objects.size() ? geometry.transforms.models[object] : no_model);
    }
}

/// Takes every vertex that is used to clip space, and on to the screen if it can be seen.
template <typename Scalar> Geometry<Scalar> geometry_of(const Scene& scene) {
    Geometry<Scalar> result;
    result.transforms = transforms_of<Scalar>(scene);
    result.vertices.resize(scene.vertices.size());
    result.is_used.resize(scene.vertices.size());
    for (const ScenePrimitive& primitive : scene.primitives)
        for (const std::size_t place : primitive.corners())
            result.is_used[place] = true;

    const auto& transforms = result.transforms;
    for_each_used_vertex(scene, result, [&](std::size_t i, const auto& model) {
        PlacedVertex<Scalar>& vertex = result.vertices[i];
        vertex.clip = places_of(scene.vertices[i], model, transforms).clip;
        vertex.is_in_view =
            std::all_of(transforms.planes.begin(), transforms.planes.end(),
                        [&vertex](const ClipPlane<Scalar>& plane) {
                            return !(plane.value_at(vertex.clip) < scalar_from<Scalar>(0));
                        });
        if (vertex.is_in_view)
            vertex.pixel = places_on_screen(vertex.clip, transforms).pixel;
    });
    return result;
}

/// Reports a place of a vertex: the first `count` coordinates.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, VertexPlaced<Scalar>>
void report_place(std::string_view name, Space space, const Vec<Scalar, 4>& at, std::size_t count,
                  Sink&& sink) {
    const std::array<Scalar, 4> coordinates{at.x, at.y, at.z, at.w};
    sink(VertexPlaced<Scalar>{
        .name = name, .space = space, .at = std::span(coordinates).first(count), .snapped = {}});
}

/// Reports the spaces of a vertex from clip space on.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, VertexPlaced<Scalar>>
void report_places_on_screen(std::string_view name, const Vec<Scalar, 4>& clip,
                             const Transforms<Scalar>& transforms, Sink&& sink) {
    const ScreenPlaces<Scalar> places = places_on_screen(clip, transforms);
    if (transforms.projection)
        report_place<Scalar>(name, Space::canonical, places.canonical, 3, sink);
    const std::array<Scalar, 2> screen{places.screen.x, places.screen.y};
    const std::array<Scalar, 2> pixel{places.pixel.x, places.pixel.y};
    sink(VertexPlaced<Scalar>{.name = name,
                              .space = Space::screen,
                              .at = screen,
                              .snapped = transforms.snap == Snap::none
                                             ? std::span<const Scalar>()
                                             : std::span<const Scalar>(pixel)});
}

/// Reports the matrices, then every vertex through its spaces; a space that the scene has no matrix
/// for is passed over. A vertex that cannot be seen stops at clip space.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, MatrixSetUp<Scalar>, VertexPlaced<Scalar>>
void report_geometry(const Scene& scene, const Geometry<Scalar>& geometry, Sink&& sink) {
    const Transforms<Scalar>& transforms = geometry.transforms;
    for (std::size_t i = 0; i < transforms.models.size(); ++i)
        if (transforms.models[i])
            sink(MatrixSetUp<Scalar>{
                .name = "model", .object = scene.objects[i].name, .matrix = *transforms.models[i]});
    if (transforms.view)
        sink(MatrixSetUp<Scalar>{.name = "view", .object = {}, .matrix = *transforms.view});
    if (transforms.projection)
        sink(MatrixSetUp<Scalar>{
            .name = "projection", .object = {}, .matrix = *transforms.projection});
    if (transforms.viewport)
        sink(MatrixSetUp<Scalar>{.name = "viewport", .object = {}, .matrix = *transforms.viewport});

    for_each_used_vertex(scene, geometry, [&](std::size_t i, const auto& model) {
        const std::string_view name = scene.vertices[i].name;
        const auto places = places_of(scene.vertices[i], model, transforms);
        if (model)
            report_place<Scalar>(name, Space::object, places.object, 3, sink);
        report_place<Scalar>(name, Space::world, places.world, 3, sink);
        if (transforms.view)
            report_place<Scalar>(name, Space::camera, places.camera, 3, sink);
        if (transforms.projection)
            report_place<Scalar>(name, Space::clip, places.clip, 4, sink);
        if (geometry.vertices[i].is_in_view)
            report_places_on_screen(name, places.clip, transforms, sink);
    });
}

/// Without a pipeline there is nothing to report.
template <typename Sink> void report_geometry(const Scene&, const TypedGeometry&, Sink&&) {}

/// A primitive on the screen, or a part of one that clipping has cut: the first `count` of each.
template <typename Coordinate> struct Piece {
    PrimitiveKind kind;
    std::string_view name;
    Color color; ///< of the primitive
    std::size_t count = 0;
    std::array<std::string_view, 3> names;
    std::array<Vec<Coordinate, 2>, 3> positions{};
    std::array<Color, 3> colors;           ///< the primitive's, where a vertex has none
    std::array<std::size_t, 3> vertices{}; ///< places in the scene of the vertices, or of the
                                           ///< primitive's first one if clipping made them
    bool is_part = false;
};

/// The color of a vertex of a primitive.
inline Color color_of(const SceneVertex& vertex, const ScenePrimitive& primitive,
                      bool mixes_colors) {
    return mixes_colors ? vertex.color.value_or(primitive.color) : primitive.color;
}

/// A primitive whose vertices all have a place: `position_of(i)` tells it.
template <typename Coordinate, typename PositionOf>
Piece<Coordinate> whole_piece(const Scene& scene, const ScenePrimitive& primitive,
                              bool mixes_colors, PositionOf&& position_of) {
    Piece<Coordinate> piece{.kind = primitive.kind,
                            .name = primitive.name,
                            .color = primitive.color,
                            .names = {},
                            .colors = {}};
    for (const std::size_t place : primitive.corners()) {
        const std::size_t i = piece.count++;
        piece.names[i] = scene.vertices[place].name;
        piece.positions[i] = position_of(place);
        piece.colors[i] = color_of(scene.vertices[place], primitive, mixes_colors);
        piece.vertices[i] = place;
    }
    return piece;
}

/// Without a pipeline every primitive is one piece.
template <typename Sink, typename Visit>
void for_each_piece(const Scene& scene, const TypedGeometry&, Sink&&, Visit&& visit) {
    const bool mixes_colors = scene.mixes_colors();
    for (const ScenePrimitive& primitive : scene.primitives)
        visit(whole_piece<Number>(scene, primitive, mixes_colors, [&scene](std::size_t place) {
            return Vec<Number, 2>{scene.vertices[place].x, scene.vertices[place].y};
        }));
}

/// Why clipping at a plane has left nothing of a polygon.
template <typename Scalar>
SkipReason reason_of(const ClipPlane<Scalar>& plane,
                     const std::vector<ClipVertex<Scalar>>& polygon) {
    if (plane.name == "far")
        return SkipReason::too_far;
    if (plane.name != "near")
        return SkipReason::outside_view;
    // The near plane's value is the distance from the eye, less the near distance.
    const bool is_behind_eye =
        std::all_of(polygon.begin(), polygon.end(), [&plane](const ClipVertex<Scalar>& vertex) {
            return !(plane.constant < plane.value_at(vertex.position));
        });
    return is_behind_eye ? SkipReason::behind_eye : SkipReason::too_near;
}

/// Cuts a polygon, a line or a point down to what lies inside all planes; each plane that it is not
/// wholly inside of is reported. If nothing is left: why.
template <typename Scalar, typename Sink>
requires SinkFor<Sink, PrimitiveClipped> std::optional<SkipReason>
clip_at_planes(std::string_view name, std::vector<ClipVertex<Scalar>>& polygon,
               const std::vector<ClipPlane<Scalar>>& planes, Sink&& sink) {
    const std::size_t fewest = std::min<std::size_t>(polygon.size(), 3);
    for (const ClipPlane<Scalar>& plane : planes) {
        // A triangle has 3 vertices, and each of the planes may add one to it.
        std::array<bool, 16> is_inside{};
        const std::size_t count = polygon.size();
        for (std::size_t i = 0; i < count; ++i)
            is_inside[i] = !(plane.value_at(polygon[i].position) < scalar_from<Scalar>(0));
        if (std::all_of(is_inside.begin(), is_inside.begin() + static_cast<std::ptrdiff_t>(count),
                        [](bool inside) { return inside; }))
            continue;

        std::vector<ClipVertex<Scalar>> left = clip(polygon, plane);
        if (left.size() < fewest)
            left.clear();
        sink(PrimitiveClipped{.name = name,
                              .plane = plane.name,
                              .is_inside = std::span(is_inside).first(count),
                              .left = static_cast<int>(left.size())});
        const SkipReason reason = reason_of(plane, polygon);
        polygon = std::move(left);
        if (polygon.empty())
            return reason;
    }
    return std::nullopt;
}

/// Clips what some vertices of a primitive span, puts the vertices that this makes on the screen, and
/// visits what is left: a point, a line, or the triangles of a fan. `made` counts the vertices that
/// clipping has made, `parts` the pieces. If nothing is left: why.
template <typename Scalar, typename Sink, typename Visit>
std::optional<SkipReason> visit_parts(const Scene& scene, const Geometry<Scalar>& geometry,
                                      const ScenePrimitive& primitive,
                                      std::span<const std::size_t> corners, bool mixes_colors,
                                      int& made, int& parts, Sink&& sink, Visit&& visit) {
    std::vector<ClipVertex<Scalar>> polygon;
    for (const std::size_t place : corners)
        polygon.push_back({geometry.vertices[place].clip,
                           color_of(scene.vertices[place], primitive, mixes_colors),
                           static_cast<int>(polygon.size())});
    const auto reason = clip_at_planes(primitive.name, polygon, geometry.transforms.planes, sink);

    std::vector<std::string> names;
    std::vector<Vec<Scalar, 2>> positions;
    for (const ClipVertex<Scalar>& vertex : polygon) {
        if (vertex.original >= 0) {
            names.push_back(
                scene.vertices[corners[static_cast<std::size_t>(vertex.original)]].name);
        } else {
            names.push_back(primitive.name + ":" + std::to_string(++made));
            report_place<Scalar>(names.back(), Space::clip, vertex.position, 4, sink);
            report_places_on_screen(names.back(), vertex.position, geometry.transforms, sink);
        }
        positions.push_back(places_on_screen(vertex.position, geometry.transforms).pixel);
    }

    const std::size_t count = std::min<std::size_t>(polygon.size(), 3);
    for (std::size_t last = count; count > 0 && last <= polygon.size(); ++last) {
        const std::string name = primitive.name + "/" + std::to_string(++parts);
        Piece<Scalar> piece{.kind = corners.size() < primitive.corners().size()
                                        ? PrimitiveKind::line
                                        : primitive.kind,
                            .name = name,
                            .color = primitive.color,
                            .count = count,
                            .names = {},
                            .colors = {},
                            .is_part = true};
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t corner = i == 0 ? 0 : last - count + i;
            const int original = polygon[corner].original;
            piece.names[i] = names[corner];
            piece.positions[i] = positions[corner];
            piece.colors[i] = polygon[corner].color;
            piece.vertices[i] = corners[static_cast<std::size_t>(std::max(original, 0))];
        }
        visit(piece);
    }
    return reason;
}

/// Visits the pieces of all primitives, in the scene's order. A primitive in view is one piece;
/// clipping of the others is reported.
template <typename Scalar, typename Sink, typename Visit>
requires SinkFor<Sink, PrimitiveBegan<Scalar>, PrimitiveClipped, VertexPlaced<Scalar>,
                 PrimitiveSkipped>
void for_each_piece(const Scene& scene, const Geometry<Scalar>& geometry, Sink&& sink,
                    Visit&& visit) {
    const bool mixes_colors = scene.mixes_colors();
    for (const ScenePrimitive& primitive : scene.primitives) {
        const auto corners = primitive.corners();
        if (std::all_of(corners.begin(), corners.end(), [&geometry](std::size_t place) {
                return geometry.vertices[place].is_in_view;
            })) {
            visit(
                whole_piece<Scalar>(scene, primitive, mixes_colors, [&geometry](std::size_t place) {
                    return geometry.vertices[place].pixel;
                }));
            continue;
        }

        // Cut: what is left of it comes as parts. The sides of an outline are cut one by one.
        std::array<std::string_view, 3> names;
        for (std::size_t i = 0; i < corners.size(); ++i)
            names[i] = scene.vertices[corners[i]].name;
        sink(PrimitiveBegan<Scalar>{.kind = primitive.kind,
                                    .name = primitive.name,
                                    .vertices = std::span(names).first(corners.size()),
                                    .positions = {},
                                    .color = primitive.color,
                                    .colors = {}});
        int made = 0;
        int parts = 0;
        std::optional<SkipReason> reason;
        if (primitive.kind != PrimitiveKind::outline) {
            reason = visit_parts(scene, geometry, primitive, corners, mixes_colors, made, parts,
                                 sink, visit);
        } else {
            for (std::size_t i = 0; i < 3; ++i) {
                const std::array<std::size_t, 2> side{corners[i], corners[(i + 1) % 3]};
                reason = visit_parts(scene, geometry, primitive, side, mixes_colors, made, parts,
                                     sink, visit);
            }
        }
        if (parts == 0)
            sink(PrimitiveSkipped{.why = *reason});
    }
}

} // namespace rastertrace
