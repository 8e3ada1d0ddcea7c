// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/numbers/adaptive.h>

#include "list/clipping.h"
#include "list/faces.h"
#include "list/names.h"
#include "tell/listener_sink.h"

#include <rastertrace/core/raster/clip.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace rastertrace {

/// What the depth buffer holds of a vertex.
template <typename Scalar>
Scalar depth_at(Depth depth, const Scalar& distance, const Vec<Scalar, 4>& clip) {
    switch (depth) {
    case Depth::linear_z:
        return distance;
    case Depth::inverse_z:
        // Only what is no triangle, and has no use for a depth, lies where there is no 1/z (plan.cpp refuses others).
        if constexpr (std::same_as<Scalar, Rational>) {
            if (distance == 0)
                return distance;
        } else if constexpr (std::floating_point<Scalar>) {
            if (!std::isfinite(1 / distance))
                return 0;
        }
        return scalar_from<Scalar>(1) / distance;
    case Depth::ndc_z:
        return clip.z / clip.w;
    case Depth::none:
    case Depth::painter:
        break;
    }
    return scalar_from<Scalar>(0);
}

/// The color of a primitive, before its vertices have their say.
template <typename Coordinate>
Color color_of(const Scene& scene, std::size_t primitive, const Face<Coordinate>& face) {
    if (scene.method.shade == Shade::faces)
        return color_of_face(primitive);
    return face.lit ? face.lit->color : scene.primitives[primitive].color;
}

/// The corners of a primitive, each from its place in the scene.
template <typename PlaceOf> auto corners_of(const ScenePrimitive& primitive, PlaceOf&& place_of) {
    std::array<std::decay_t<decltype(place_of(std::size_t{}))>, 3> corners{};
    for (std::size_t i = 0; i < primitive.corners().size(); ++i)
        corners[i] = place_of(primitive.vertices[i]);
    return corners;
}

/// What a polygon is drawn as: itself if it is a point or a line, else a fan of triangles. So many.
std::size_t part_count(std::size_t corners) {
    return corners < 3 ? std::min<std::size_t>(corners, 1) : corners - 2;
}

/// Finds how deep a vertex lies that is on the screen, and 1/w.
template <typename Scalar>
void find_depth(const Vec<Scalar, 4>& clip, const Scalar& distance, const ScreenList<Scalar>& list,
                ScreenVertex<Scalar>& vertex) {
    vertex.depth = depth_at<Scalar>(list.depth, distance, clip);
    if (list.mixes_colors)
        vertex.inverse_w = scalar_from<Scalar>(1) / clip.w;
}

/// The same for a vertex of the scene, once.
template <typename Scalar> void find_depth(Geometry<Scalar>& geometry, std::size_t index) {
    ScreenList<Scalar>& list = geometry.list;
    if (list.is_drawn[index])
        return;
    const ClipSpaceVertex<Scalar>& vertex = geometry.vertices[index];
    find_depth(vertex.clip, vertex.distance, list, list.vertices[index]);
    list.is_drawn[index] = true;
}

/// Tests and lights the face of a primitive, clips it, and adds what is left of it to the list.
template <typename Scalar>
void add_primitive(const Scene& scene, Geometry<Scalar>& geometry, std::size_t index) {
    ScreenList<Scalar>& list = geometry.list;
    using State = ScreenPrimitive::State;
    const ScenePrimitive& primitive = scene.primitives[index];
    const auto world = corners_of(primitive, [&](std::size_t corner) {
        return geometry.world.empty() ? Vec<Scalar, 3>{} : geometry.world[corner];
    });
    const Face<Scalar> face = face_in(scene, list, index, world);
    if (!is_finite(face))
        list.infinite_face = std::min(index, list.infinite_face.value_or(index));
    const Color color = color_of(scene, index, face);
    const auto add = [&](State state, std::size_t part) {
        list.primitives.push_back({.primitive = static_cast<std::uint32_t>(index),
                                   .index = static_cast<std::uint32_t>(part),
                                   .color = color,
                                   .state = state});
    };
    const auto clip_it = [&](auto&& take) {
        const auto vertices =
            corners_of(primitive, [&](std::size_t corner) { return geometry.vertices[corner]; });
        clip_primitive(scene, list, index, color, vertices, {}, take);
    };

    // In view: all of it. Clipping it would leave it as it is.
    const auto corners = primitive.corners();
    if (std::all_of(corners.begin(), corners.end(),
                    [&](std::size_t corner) { return geometry.vertices[corner].is_in_view; })) {
        if (scene.keep.has(Stage::clip))
            clip_it([](auto&&...) {});
        for (const std::size_t corner : corners)
            find_depth(geometry, corner);
        return add(face.skip ? State::skipped : State::whole, 0);
    }
    if (face.skip)
        return;

    // Cut: what is left of it comes as parts.
    int made = 0;
    int parts = 0;
    clip_it([&](std::size_t side, const std::vector<ClipVertex<Scalar>>& polygon) {
        std::vector<std::size_t> indices;
        for (const ClipVertex<Scalar>& vertex : polygon) {
            if (vertex.original >= 0) {
                indices.push_back(corners[static_cast<std::size_t>(vertex.original)]);
                find_depth(geometry, indices.back());
                continue;
            }
            indices.push_back(list.vertices.size());
            list.made.push_back({vertex.color, ++made, corners[side]});
            auto& on_screen = list.vertices.emplace_back();
            on_screen.position = positions_on_screen(vertex.position, list.transforms).pixel;
            find_depth(vertex.position, vertex.distance, list, on_screen);
        }
        for (std::size_t i = 0; i < part_count(indices.size()); ++i) {
            ScreenPart part{{indices[0], 0, 0}, ++parts};
            for (std::size_t corner = 1; corner < std::min<std::size_t>(indices.size(), 3);
                 ++corner)
                part.corners[corner] = indices[i + corner];
            add(State::part, list.parts.size());
            list.parts.push_back(part);
        }
    });
}

/// True if the face of a triangle is drawn, as far as that hangs on which way it is turned. `exact` is made
/// where doubles leave that open.
template <typename Scalar>
bool has_drawn_face(const Scene& scene, const Geometry<Scalar>& geometry, std::size_t index,
                    std::optional<Transforms<Rational>>& exact) {
    const ScenePrimitive& triangle = scene.primitives[index];
    const auto is_drawn = [&](const auto& transforms, auto&& place_of) {
        return !face_of(scene, transforms, triangle, corners_of(triangle, place_of)).skip;
    };
    try {
        return is_drawn(geometry.list.transforms,
                        [&](std::size_t corner) { return geometry.world[corner]; });
    } catch (const Undecided&) {
        if (!exact)
            exact = empty_geometry<Rational>(scene).list.transforms;
        return is_drawn(*exact, [&](std::size_t corner) {
            return vertex_in_space(scene, *exact, corner).world;
        });
    }
}

/// What is drawn of all primitives, in the order in which they are drawn.
template <typename Scalar>
ScreenList<Scalar> screen_list_of(const Scene& scene, Geometry<Scalar> geometry) {
    ScreenList<Scalar>& list = geometry.list;
    std::optional<Transforms<Rational>> exact;
    list.culled_sides = culled_sides_of(
        scene, [&](std::size_t index) { return has_drawn_face(scene, geometry, index, exact); });
    for (std::size_t turn = 0; turn < scene.primitives.size(); ++turn) {
        const std::size_t index = primitive_at(list, turn);
        const std::size_t count = list.primitives.size();
        try {
            add_primitive(scene, geometry, index);
        } catch (const Undecided& undecided) {
            list.primitives.resize(count);
            list.primitives.push_back({.primitive = static_cast<std::uint32_t>(index),
                                       .index = static_cast<std::uint32_t>(list.undecided.size()),
                                       .color = {},
                                       .state = ScreenPrimitive::State::undecided});
            list.undecided.push_back(undecided);
        }
    }
    return std::move(list);
}

/// What the list would hold of a primitive.
ScreenPrimitive typed_primitive(const Scene& scene, std::size_t index) {
    return {.primitive = static_cast<std::uint32_t>(index),
            .index = 0,
            .color = color_of(scene, index, Face<Number>{})};
}

/// A piece, but for its corners.
template <typename Coordinate>
Piece<Coordinate> piece_without_corners(const Scene& scene, const ScreenPrimitive& one) {
    using State = ScreenPrimitive::State;
    const bool is_part = one.state == State::part;
    const PrimitiveKind kind = scene.primitives[one.primitive].kind;
    return {.kind = is_part && kind == PrimitiveKind::outline ? PrimitiveKind::line : kind,
            .primitive = one.primitive,
            .color = one.color,
            .is_part = is_part,
            .is_skipped = one.state == State::skipped,
            .colors = {}};
}

/// One of the list with its corners.
template <typename Scalar>
Piece<Scalar> piece_of(const Scene& scene, const ScreenList<Scalar>& list,
                       const ScreenPrimitive& one) {
    auto piece = piece_without_corners<Scalar>(scene, one);
    for (const std::size_t index : corners_of(scene, list, one)) {
        const std::size_t i = piece.count++;
        const ScreenVertex<Scalar>& vertex = list.vertices[index];
        piece.positions[i] = vertex.position;
        piece.depths[i] = vertex.depth;
        piece.inverse_w[i] = vertex.inverse_w;
        if (index < scene.vertices.size()) {
            piece.colors[i] = color_of_vertex(scene, list, index, one.color);
            piece.vertices[i] = index;
        } else {
            const MadeVertex& made = list.made[index - scene.vertices.size()];
            piece.colors[i] = made.color;
            piece.vertices[i] = made.side;
        }
    }
    return piece;
}
Piece<Number> piece_of(const Scene& scene, const TypedVertices& typed, const ScreenPrimitive& one) {
    auto piece = piece_without_corners<Number>(scene, one);
    for (const std::size_t index : scene.primitives[one.primitive].corners()) {
        const std::size_t i = piece.count++;
        piece.positions[i] = {scene.vertices[index].x, scene.vertices[index].y};
        piece.colors[i] = color_of_vertex(scene, typed, index, one.color);
        piece.vertices[i] = index;
    }
    return piece;
}

/// Tells what is found out about a primitive before it is on the screen, and calls `draw_next(face)` for
/// each of its pieces in the list, when it is their turn. The face of a part has been told.
template <typename Scalar>
void tell_pieces(const Scene& scene, const ScreenList<Scalar>& list, std::size_t index,
                 const Listener& listener, const TakeFace<Scalar>& draw_next) {
    // In view, and without a face: there is nothing to tell.
    const ScenePrimitive& primitive = scene.primitives[index];
    if (is_whole(scene, list, index) && !has_face(scene, primitive))
        return draw_next(face_in<Scalar>(scene, list, index, {}));

    const auto corners = primitive.corners();
    std::array<Vec<Scalar, 3>, 3> world;
    std::array<ClipSpaceVertex<Scalar>, 3> vertices;
    bool is_in_view = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        auto [in_world, in_clip_space] = vertex_in_space(scene, list.transforms, corners[i]);
        world[i] = std::move(in_world);
        vertices[i] = std::move(in_clip_space);
        is_in_view = is_in_view && vertices[i].is_in_view;
    }
    const Face<Scalar> face = face_in(scene, list, index, world);
    if (is_in_view)
        return draw_next(face);

    // Cut. The sides of an outline are cut one by one.
    const ListenerSink sink(listener);
    const Color color = color_of(scene, index, face);
    std::array<std::string_view, 3> names;
    for (std::size_t i = 0; i < corners.size(); ++i)
        names[i] = scene.vertices[corners[i]].name;
    sink(PrimitiveBegan<Scalar>{.kind = primitive.kind,
                                .name = primitive.name,
                                .vertices = std::span(names).first(corners.size()),
                                .positions = {},
                                .color = color,
                                .colors = {}});
    if (!tell_face(face, sink))
        return;
    int made = 0;
    const auto reason = clip_primitive(
        scene, list, index, color, vertices, listener,
        [&](std::size_t, const std::vector<ClipVertex<Scalar>>& polygon) {
            for (const ClipVertex<Scalar>& vertex : polygon)
                if (vertex.original < 0) {
                    const std::string name = name_of_made(primitive.name, ++made);
                    tell_position<Scalar>(name, Space::clip, vertex.position, 4, listener);
                    tell_positions_on_screen(name, vertex.position, list.transforms, listener);
                }
            for (std::size_t i = 0; i < part_count(polygon.size()); ++i)
                draw_next({});
        });
    if (reason)
        listener(PrimitiveSkipped{.why = *reason});
}

// What is asked for primitive by primitive is exact.

template void add_primitive(const Scene&, Geometry<Rational>&, std::size_t);

// For every kind of number that vertices are moved in.

template ScreenList<float> screen_list_of(const Scene&, Geometry<float>);
template Piece<float> piece_of(const Scene&, const ScreenList<float>&, const ScreenPrimitive&);
template void tell_pieces(const Scene&, const ScreenList<float>&, std::size_t, const Listener&,
                          const TakeFace<float>&);

template ScreenList<double> screen_list_of(const Scene&, Geometry<double>);
template Piece<double> piece_of(const Scene&, const ScreenList<double>&, const ScreenPrimitive&);
template void tell_pieces(const Scene&, const ScreenList<double>&, std::size_t, const Listener&,
                          const TakeFace<double>&);

template ScreenList<Adaptive> screen_list_of(const Scene&, Geometry<Adaptive>);
template Piece<Adaptive> piece_of(const Scene&, const ScreenList<Adaptive>&,
                                  const ScreenPrimitive&);
template void tell_pieces(const Scene&, const ScreenList<Adaptive>&, std::size_t, const Listener&,
                          const TakeFace<Adaptive>&);

template ScreenList<Rational> screen_list_of(const Scene&, Geometry<Rational>);
template Piece<Rational> piece_of(const Scene&, const ScreenList<Rational>&,
                                  const ScreenPrimitive&);
template void tell_pieces(const Scene&, const ScreenList<Rational>&, std::size_t, const Listener&,
                          const TakeFace<Rational>&);

} // namespace rastertrace
