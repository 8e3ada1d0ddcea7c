// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/list/pieces.h>

#include "list/clipping.h"

namespace rastertrace {

/// What the depth buffer holds of a vertex.
template <typename Scalar>
Scalar depth_at(Depth depth, const Scalar& distance, const Vec<Scalar, 4>& clip) {
    switch (depth) {
    case Depth::linear_z:
        return distance;
    case Depth::inverse_z:
        // Of points and lines that have no use for a depth, 1/z may not exist (plan.cpp refuses
        // others).
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

/// The number of parts that what clipping has left is drawn as: itself if it is a point, a line or
/// a polygon of the scene, else a fan of triangles.
std::size_t part_count(PrimitiveKind kind, std::size_t corners) {
    return corners < 3 || traits_of(kind).has_ring ? std::min<std::size_t>(corners, 1)
                                                   : corners - 2;
}

/// Sets the depth of a vertex on the screen, and 1/w.
template <typename Scalar>
void find_depth(const Vec<Scalar, 4>& clip, const Scalar& distance, const ScreenList<Scalar>& list,
                ScreenVertex<Scalar>& vertex) {
    vertex.depth = depth_at<Scalar>(list.depth, distance, clip);
    if (list.depth == Depth::ndc_z && list.transforms.moves_depths) {
        const auto& to_range = list.transforms.viewport->rows[2];
        vertex.depth = to_range[2] * vertex.depth + to_range[3];
    }
    if (list.mixes_colors)
        vertex.inverse_w = scalar_from<Scalar>(1) / clip.w;
}

/// The same for a vertex of the scene that is in view; once.
template <typename Scalar> void find_depth(Geometry<Scalar>& geometry, std::size_t index) {
    ScreenList<Scalar>& list = geometry.list;
    if (list.is_drawn[index])
        return;
    const ClipSpaceVertex<Scalar>& vertex = geometry.vertices[index];
    find_depth(vertex.clip, vertex.distance, list, list.vertices[index]);
    list.is_drawn[index] = true;
}

/// Adds the parts of a polygon that clipping has left to the list. `corners` are indices in
/// ScreenList::vertices, `parts` counts the parts of the primitive.
template <typename Scalar>
void add_parts(PrimitiveKind kind, const std::vector<std::size_t>& corners,
               const ScreenPrimitive& primitive, ScreenList<Scalar>& list, int& parts) {
    const std::size_t count = part_count(kind, corners.size());
    for (std::size_t i = 0; i < count; ++i) {
        ScreenPart part{corners, ++parts};
        if (count > 1)
            part.corners = {corners[0], corners[i + 1], corners[i + 2]};
        list.primitives.push_back({.primitive = primitive.primitive,
                                   .index = static_cast<std::uint32_t>(list.parts.size()),
                                   .color = primitive.color,
                                   .state = ScreenPrimitive::State::part});
        list.parts.push_back(std::move(part));
    }
}

/// Clips a primitive and adds the parts that are left to the list.
template <typename Scalar>
void add_clipped(const Scene& scene, Geometry<Scalar>& geometry,
                 const UnclippedPrimitive<Scalar>& unclipped, const ScreenPrimitive& primitive) {
    ScreenList<Scalar>& list = geometry.list;
    const PrimitiveKind kind = scene.primitives[unclipped.index].kind;
    const auto originals = scene.primitives[unclipped.index].corners();
    int made = 0;
    int parts = 0;
    const auto corner_of = [&](std::size_t side, const ClipVertex<Scalar>& vertex) {
        if (vertex.original >= 0) {
            const std::size_t index = originals[static_cast<std::size_t>(vertex.original)];
            find_depth(geometry, index);
            return index;
        }
        list.made.push_back(
            {vertex.color.rounded(scene.method.color_rounding), ++made, originals[side]});
        if (list.mixes_colors)
            list.levels.push_back(vertex.color);
        ScreenVertex<Scalar>& on_screen = list.vertices.emplace_back();
        on_screen.position = positions_on_screen(vertex.position, list.transforms).pixel;
        find_depth(vertex.position, vertex.distance, list, on_screen);
        return list.vertices.size() - 1;
    };
    clip_primitive(
        scene, list,
        unclipped, [&](std::size_t i) -> const auto& { return geometry.vertices[originals[i]]; },
        {},
        [&](std::size_t side, const std::vector<ClipVertex<Scalar>>& polygon) {
            std::vector<std::size_t> corners;
            for (const ClipVertex<Scalar>& vertex : polygon)
                corners.push_back(corner_of(side, vertex));
            add_parts(kind, corners, primitive, list, parts);
        });
}

template <typename Scalar>
void add_primitive(const Scene& scene, Geometry<Scalar>& geometry, std::size_t index) {
    ScreenList<Scalar>& list = geometry.list;
    const auto corners = scene.primitives[index].corners();
    const auto primitive = unclipped<Scalar>(
        scene, list,
        index, [&](std::size_t i) -> const auto& { return geometry.world[corners[i]]; },
        [&](std::size_t i) -> const auto& { return geometry.vertices[corners[i]]; });
    if (!is_finite(primitive.face) &&
        index < (list.infinite_face ? list.infinite_face->primitive : scene.primitives.size())) {
        const Vec<Scalar, 3>& at = geometry.world[corners[0]];
        list.infinite_face = {index, {to_double(at.x), to_double(at.y)}};
    }

    const bool is_skipped = primitive.face.skip.has_value();
    const ScreenPrimitive one{.primitive = static_cast<std::uint32_t>(index),
                              .index = 0,
                              .color = primitive.color,
                              .state = is_skipped ? ScreenPrimitive::State::skipped
                                                  : ScreenPrimitive::State::whole};
    if (primitive.is_in_view) {
        for (const std::size_t corner : corners)
            find_depth(geometry, corner);
        list.primitives.push_back(one);
    } else if (!is_skipped) {
        add_clipped(scene, geometry, primitive, one);
    }
}

/// True if a face is not culled and has an area. `exact` holds the exact matrices once doubles
/// have left that open.
template <typename Scalar>
bool has_drawn_face(const Scene& scene, const Geometry<Scalar>& geometry, std::size_t index,
                    std::optional<Transforms<Rational>>& exact) {
    const ScenePrimitive& primitive = scene.primitives[index];
    const auto is_drawn = [&]<typename Real>(const Transforms<Real>& transforms, auto&& world_of) {
        std::vector<Vec<Real, 3>> world;
        for (const std::size_t corner : primitive.corners())
            world.push_back(world_of(corner));
        return !face_of<Real>(scene, transforms, primitive, world).skip;
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

ScreenPrimitive typed_primitive(const Scene& scene, std::size_t index) {
    return {.primitive = static_cast<std::uint32_t>(index),
            .index = 0,
            .color = color_of(scene, index, Face<Number>{})};
}

/// A piece without its corners.
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
            .colors = {},
            .radius = scene.primitives[one.primitive].radius};
}

template <typename Scalar>
Piece<Scalar> piece_of(const Scene& scene, const ScreenList<Scalar>& list,
                       const ScreenPrimitive& one) {
    auto piece = piece_without_corners<Scalar>(scene, one);
    const auto corners = corners_of(scene, list.parts, one);
    bool is_cut = false;
    if (traits_of(piece.kind).has_ring) {
        for (const std::size_t index : corners) {
            const bool is_made = index >= scene.vertices.size();
            piece.ring.push_back(list.vertices[index].position);
            piece.ring_vertices.push_back(is_made ? list.made[index - scene.vertices.size()].side
                                                  : index);
        }
        return piece;
    }
    for (const std::size_t index : corners) {
        const std::size_t i = piece.count++;
        const ScreenVertex<Scalar>& vertex = list.vertices[index];
        piece.positions[i] = vertex.position;
        piece.depths[i] = vertex.depth;
        piece.inverse_w[i] = vertex.inverse_w;
        if (index < scene.vertices.size()) {
            piece.colors[i] = color_of_vertex(scene, list.mixes_colors, index, one.color);
            piece.vertices[i] = index;
        } else {
            const MadeVertex& made = list.made[index - scene.vertices.size()];
            piece.colors[i] = made.color;
            piece.vertices[i] = made.side;
            is_cut = true;
        }
    }
    // Where an edge between two colors is cut, there is no whole level.
    const auto all = scene.primitives[one.primitive].corners();
    const auto color_of = [&](std::size_t index) {
        return color_of_vertex(scene, list.mixes_colors, index, one.color);
    };
    if (is_cut && std::any_of(all.begin(), all.end(), [&](std::size_t index) {
            return color_of(index) != color_of(all[0]);
        }))
        for (const std::size_t index : corners)
            piece.levels.push_back(index < scene.vertices.size()
                                       ? Levels<Scalar>(color_of(index))
                                       : list.levels[index - scene.vertices.size()]);
    return piece;
}
Piece<Number> piece_of(const Scene& scene, const TypedVertices& typed, const ScreenPrimitive& one) {
    auto piece = piece_without_corners<Number>(scene, one);
    const ScenePrimitive& primitive = scene.primitives[one.primitive];
    if (traits_of(piece.kind).has_ring) {
        for (const std::size_t index : primitive.ring)
            piece.ring.push_back({scene.vertices[index].x, scene.vertices[index].y});
        piece.ring_vertices = primitive.ring;
        return piece;
    }
    for (const std::size_t index : primitive.corners()) {
        const std::size_t i = piece.count++;
        piece.positions[i] = {scene.vertices[index].x, scene.vertices[index].y};
        piece.colors[i] = color_of_vertex(scene, typed.mixes_colors, index, one.color);
        piece.vertices[i] = index;
    }
    return piece;
}

/// The name of a vertex that clipping has made.
std::string name_of_made(const std::string& primitive, int ordinal) {
    return primitive + ":" + std::to_string(ordinal);
}

PieceNames::PieceNames(const Scene& scene, const std::vector<MadeVertex>& made,
                       const std::vector<ScreenPart>& parts, const ScreenPrimitive& one)
    : piece(scene.primitives[one.primitive].name) {
    const std::string& name = scene.primitives[one.primitive].name;
    const auto indices = corners_of(scene, parts, one);
    corners.reserve(indices.size());
    const bool is_part = one.state == ScreenPrimitive::State::part;
    if (is_part)
        made_.reserve(indices.size() + 1); // no name may move
    for (const std::size_t index : indices)
        corners.push_back(index < scene.vertices.size()
                              ? std::string_view(scene.vertices[index].name)
                              : made_.emplace_back(name_of_made(
                                    name, made[index - scene.vertices.size()].ordinal)));
    if (is_part)
        piece = made_.emplace_back(name + "/" + std::to_string(parts[one.index].ordinal));
}

template <typename Scalar>
void tell_pieces(const Scene& scene, const ScreenList<Scalar>& list, std::size_t index,
                 const Listener& listener, const TakeFace<Scalar>& draw_next) {
    // In view, and without a face: there is nothing to tell.
    const ScenePrimitive& primitive = scene.primitives[index];
    if (is_whole(scene, list, index) && !has_face(scene, primitive))
        return draw_next(face_in<Scalar>(scene, list, index, {}));

    const auto corners = primitive.corners();
    std::vector<VertexInSpace<Scalar>> vertices;
    vertices.reserve(corners.size());
    for (const std::size_t corner : corners)
        vertices.push_back(vertex_in_space(scene, list.transforms, corner));
    const auto in_clip_space = [&](std::size_t i) -> const auto& {
        return vertices[i].in_clip_space;
    };
    const auto found = unclipped<Scalar>(
        scene, list, index, [&](std::size_t i) -> const auto& { return vertices[i].world; },
        in_clip_space);
    if (found.is_in_view)
        return draw_next(found.face);

    // Clipped.
    const ListenerSink sink(listener);
    std::vector<std::string_view> names;
    for (const std::size_t corner : corners)
        names.push_back(scene.vertices[corner].name);
    sink(PrimitiveBegan<Scalar>{.kind = primitive.kind,
                                .name = primitive.name,
                                .vertices = names,
                                .color = found.color,
                                .radius = radius_of(primitive),
                                .face = if_any(scene.face_of(primitive))});
    if (!tell_face(found.face, sink))
        return;
    int made = 0;
    const auto reason = clip_primitive(
        scene, list, found, in_clip_space, listener,
        [&](std::size_t, const std::vector<ClipVertex<Scalar>>& polygon) {
            for (const ClipVertex<Scalar>& vertex : polygon)
                if (vertex.original < 0) {
                    const std::string name = name_of_made(primitive.name, ++made);
                    tell_position<Scalar>(name, Space::clip, vertex.position, 4, listener);
                    tell_positions_on_screen(name, vertex.position, list.transforms, listener);
                }
            for (std::size_t i = 0; i < part_count(primitive.kind, polygon.size()); ++i)
                draw_next({});
        });
    if (reason)
        listener(PrimitiveSkipped<>{.why = *reason});
}

template Face<Rational> face_of(const Scene&, const Transforms<Rational>&, const ScenePrimitive&,
                                std::span<const Vec<Rational, 3>>);
template void add_primitive(const Scene&, Geometry<Rational>&, std::size_t);

#define INSTANTIATE(Coordinate)                                                                    \
    template ScreenList<Coordinate> screen_list_of(const Scene&, Geometry<Coordinate>);            \
    template Piece<Coordinate> piece_of(const Scene&, const ScreenList<Coordinate>&,               \
                                        const ScreenPrimitive&);                                   \
    template void tell_pieces(const Scene&, const ScreenList<Coordinate>&, std::size_t,            \
                              const Listener&, const TakeFace<Coordinate>&);
RASTERTRACE_FOR_EACH_COORDINATE(INSTANTIATE)

} // namespace rastertrace
