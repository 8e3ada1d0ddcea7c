// SPDX-License-Identifier: MIT
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/numbers/adaptive.h>

#include "tell/listener_sink.h"

#include <rastertrace/core/draw/list/light.h>
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

/// The vector from a face to the light.
template <typename Scalar>
Vec<Scalar, 3> light_from(const Light& light, const Vec<Scalar, 3>& centroid) {
    const Vec<Scalar, 3> at{scalar_from<Scalar>(light.at[0]), scalar_from<Scalar>(light.at[1]),
                            scalar_from<Scalar>(light.at[2])};
    return light.kind == Light::Kind::position ? at - centroid : at;
}

/// Tests which way a triangle is turned, and lights it. A triangle without area has no normal.
template <typename Scalar>
Face<Scalar> face_of(const Scene& scene, const Transforms<Scalar>& transforms,
                     const ScenePrimitive& primitive, const std::array<Vec<Scalar, 3>, 3>& world) {
    Face<Scalar> face;
    const auto& [a, b, c] = world;
    const Vec<Scalar, 3> normal = normal_of<Scalar>(a, b, c);
    if (has_no_length<Scalar>(normal)) {
        face.skip = SkipReason::zero_area;
        return face;
    }
    const Vec<Scalar, 3> centroid = centroid_of<Scalar>(a, b, c);
    const Scalar zero = scalar_from<Scalar>(0);

    const Cull cull = scene.method.cull;
    if (cull != Cull::none) {
        const bool is_by_light = cull == Cull::light;
        const Vec<Scalar, 3> view = is_by_light ? light_from<Scalar>(*scene.light, centroid)
                                    : is_perspective(scene.projection.type)
                                        ? transforms.eye - centroid
                                        : transforms.eye;
        const Scalar product = dot(normal, view);
        const auto cosine = cosine_between(normal, view);
        face.tested =
            FaceTested<Scalar>{.normal = normal,
                               .view = view,
                               .dot = product,
                               .cosine = cosine ? std::optional(to_double(*cosine)) : std::nullopt,
                               .is_by_light = is_by_light,
                               .is_culled = is_culled(cull, product),
                               .is_culled_opposite = is_culled(cull, Scalar(-product))};
        if (face.tested->is_culled) {
            face.skip = SkipReason::culled;
            return face;
        }
    }

    if (scene.method.shade == Shade::lambert) {
        const Vec<Scalar, 3> light = light_from<Scalar>(*scene.light, centroid);
        const Scalar product = dot(normal, light);
        const auto cosine = cosine_between(normal, light);
        using Cosine = typename decltype(cosine)::value_type;
        const Cosine intensity = zero < product && cosine ? *cosine : Cosine(0);
        face.lit =
            FaceLit<Scalar>{.normal = normal,
                            .light = light,
                            .dot = product,
                            .intensity = to_double(intensity),
                            .color = lit(primitive.color, intensity, scene.method.color_rounding)};
    }
    return face;
}

/// True if a primitive is a triangle whose face is tested or lit.
bool has_face(const Scene& scene, const ScenePrimitive& primitive) {
    return primitive.kind == PrimitiveKind::triangle &&
           (scene.method.cull != Cull::none || scene.method.shade == Shade::lambert);
}

/// The face of a primitive whose corners lie there in the world. Nothing is found out about one that has
/// none, but that it is a side of culled ones.
template <typename Scalar>
Face<Scalar> face_in(const Scene& scene, const ScreenList<Scalar>& list, std::size_t index,
                     const std::array<Vec<Scalar, 3>, 3>& world) {
    const ScenePrimitive& primitive = scene.primitives[index];
    if (has_face(scene, primitive))
        return face_of(scene, list.transforms, primitive, world);
    if (!list.culled_sides.empty() && list.culled_sides[index])
        return {.skip = SkipReason::culled};
    return {};
}

/// Which of the scene's lines are sides of faces none of which is drawn: `is_drawn(index)` tells whether a
/// triangle is. Empty if that does not matter to any.
template <typename IsDrawn>
std::vector<bool> culled_sides_of(const Scene& scene, IsDrawn&& is_drawn) {
    const auto& primitives = scene.primitives;
    if (scene.method.cull == Cull::none ||
        std::none_of(primitives.begin(), primitives.end(),
                     [](const ScenePrimitive& one) { return one.is_side; }))
        return {};

    // A face is drawn if one of its triangles is: one without area never is.
    const auto face_number = [&primitives](std::size_t i) {
        return primitives[i].polygon == 0 ? i : primitives.size() + primitives[i].polygon;
    };
    std::vector<std::size_t> triangles;
    std::vector<std::size_t> faces;
    for (std::size_t i = 0; i < primitives.size(); ++i)
        if (primitives[i].kind == PrimitiveKind::triangle) {
            triangles.push_back(i);
            if (is_drawn(i))
                faces.push_back(face_number(i));
        }
    std::sort(faces.begin(), faces.end());

    // Their sides: between two triangles of one face lies a diagonal.
    struct SideOfFace {
        std::size_t low, high, face;
        auto operator<=>(const SideOfFace&) const = default;
    };
    std::vector<SideOfFace> sides;
    for (const std::size_t i : triangles)
        if (std::binary_search(faces.begin(), faces.end(), face_number(i)))
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t from = primitives[i].vertices[k];
                const std::size_t to = primitives[i].vertices[(k + 1) % 3];
                sides.push_back({std::min(from, to), std::max(from, to), face_number(i)});
            }
    std::sort(sides.begin(), sides.end());
    const auto is_drawn_side = [&sides](std::size_t from, std::size_t to) {
        const SideOfFace first{std::min(from, to), std::max(from, to), 0};
        auto side = std::lower_bound(sides.begin(), sides.end(), first);
        while (side != sides.end() && side->low == first.low && side->high == first.high) {
            const auto next = std::upper_bound(side, sides.end(), *side);
            if (next - side == 1)
                return true;
            side = next;
        }
        return false;
    };
    std::vector<bool> result(primitives.size());
    for (std::size_t i = 0; i < primitives.size(); ++i)
        result[i] = primitives[i].is_side &&
                    !is_drawn_side(primitives[i].vertices[0], primitives[i].vertices[1]);
    return result;
}

/// False if a number of a face that would be told is none: a normal is a product of two lengths, and is
/// multiplied by a third one.
template <typename Scalar> bool is_finite(const Face<Scalar>& face) {
    if constexpr (std::floating_point<Scalar>) {
        const auto all_finite = [](const Vec<Scalar, 3>& a, const Vec<Scalar, 3>& b,
                                   std::initializer_list<double> others) {
            return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z) &&
                   std::isfinite(b.x) && std::isfinite(b.y) && std::isfinite(b.z) &&
                   std::all_of(others.begin(), others.end(),
                               [](double one) { return std::isfinite(one); });
        };
        const auto& [tested, lit, skip] = face;
        return (!tested || all_finite(tested->normal, tested->view,
                                      {tested->dot, tested->cosine.value_or(0)})) &&
               (!lit || all_finite(lit->normal, lit->light, {lit->dot, lit->intensity}));
    }
    return true;
}

/// What a vertex is called that clipping has made.
std::string name_of_made(const std::string& primitive, int ordinal) {
    return primitive + ":" + std::to_string(ordinal);
}

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

/// The color of a vertex of the scene, or of its primitive if it has none that counts.
template <typename AList>
Color color_of_vertex(const Scene& scene, const AList& list, std::size_t index, Color color) {
    return list.mixes_colors ? scene.vertices[index].color.value_or(color) : color;
}

/// Why clipping at a plane has left nothing of a polygon.
template <typename Scalar>
SkipReason reason_of(const ClipPlane<Scalar>& plane,
                     const std::vector<ClipVertex<Scalar>>& polygon) {
    if (plane.name == "far")
        return SkipReason::too_far;
    if (plane.name != "near")
        return SkipReason::outside_view;
    // An orthographic view has no eye to be behind of.
    if (plane.factors.z != scalar_from<Scalar>(0))
        return SkipReason::too_near;
    // The near plane's value is the distance from the eye, less the near distance.
    const bool is_behind_eye =
        std::all_of(polygon.begin(), polygon.end(), [&plane](const ClipVertex<Scalar>& vertex) {
            return !(plane.constant < plane.value_at(vertex.position));
        });
    return is_behind_eye ? SkipReason::behind_eye : SkipReason::too_near;
}

/// Cuts a polygon, a line or a point down to what lies inside all planes; each plane that it is not
/// wholly inside of is told. If nothing is left: why. Only a vertex that it begins with makes a
/// plane cut: one that clipping has made lies, but for rounding, between two of those.
template <typename Scalar>
std::optional<SkipReason> clip_at_planes(std::string_view name,
                                         std::vector<ClipVertex<Scalar>>& polygon,
                                         const std::vector<ClipPlane<Scalar>>& planes,
                                         ColorRounding color_rounding, const Listener& listener) {
    const std::size_t fewest = std::min<std::size_t>(polygon.size(), 3);
    const std::vector<ClipVertex<Scalar>> whole = polygon;
    for (const ClipPlane<Scalar>& plane : planes) {
        if (std::all_of(whole.begin(), whole.end(), [&plane](const ClipVertex<Scalar>& vertex) {
                return plane.has_inside(vertex.position);
            }))
            continue;

        // A triangle has 3 vertices, and each of the planes may add one to it.
        std::array<bool, 16> is_inside{};
        const std::size_t count = polygon.size();
        for (std::size_t i = 0; i < count; ++i)
            is_inside[i] = plane.has_inside(polygon[i].position);
        if (std::all_of(is_inside.begin(), is_inside.begin() + static_cast<std::ptrdiff_t>(count),
                        [](bool inside) { return inside; }))
            continue;

        std::vector<ClipVertex<Scalar>> left = clip(polygon, plane, color_rounding);
        if (left.size() < fewest)
            left.clear();
        listener(PrimitiveClipped{.name = name,
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

/// The corners of a primitive, each from its place in the scene.
template <typename PlaceOf> auto corners_of(const ScenePrimitive& primitive, PlaceOf&& place_of) {
    std::array<std::decay_t<decltype(place_of(std::size_t{}))>, 3> corners{};
    for (std::size_t i = 0; i < primitive.corners().size(); ++i)
        corners[i] = place_of(primitive.vertices[i]);
    return corners;
}

/// Clips a primitive whose corners lie in clip space; the sides of an outline one by one. Calls
/// `take(side, polygon)` with what is left of each: the first corner of what was clipped, and a point, a
/// line or a polygon, whose vertices know which of the corners they are. If nothing is left: why.
template <typename Scalar, typename Take>
std::optional<SkipReason> clip_primitive(const Scene& scene, const ScreenList<Scalar>& list,
                                         std::size_t index, Color color,
                                         const std::array<ClipSpaceVertex<Scalar>, 3>& vertices,
                                         const Listener& listener, Take&& take) {
    const ScenePrimitive& primitive = scene.primitives[index];
    const std::size_t count = primitive.corners().size();
    const bool is_outline = primitive.kind == PrimitiveKind::outline;
    std::optional<SkipReason> reason;
    bool is_left = false;
    for (std::size_t side = 0; side < (is_outline ? count : 1); ++side) {
        std::vector<ClipVertex<Scalar>> polygon;
        for (std::size_t i = 0; i < (is_outline ? 2 : count); ++i) {
            const std::size_t corner = (side + i) % count;
            const auto& [clip, distance, is_in_view] = vertices[corner];
            polygon.push_back({clip, distance,
                               color_of_vertex(scene, list, primitive.vertices[corner], color),
                               static_cast<int>(corner)});
        }
        reason = clip_at_planes(primitive.name, polygon, list.transforms.planes,
                                scene.method.color_rounding, listener);
        is_left = is_left || !polygon.empty();
        take(side, polygon);
    }
    return is_left ? std::nullopt : reason;
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

/// Places in the list of the corners of a primitive, or of a part of one.
template <typename Scalar>
std::span<const std::size_t> corners_of(const Scene& scene, const ScreenList<Scalar>& list,
                                        const ScreenPrimitive& one) {
    const auto corners = scene.primitives[one.primitive].corners();
    if (one.state != ScreenPrimitive::State::part)
        return corners;
    const bool is_line = scene.primitives[one.primitive].kind == PrimitiveKind::outline;
    return std::span(list.parts[one.index].corners).first(is_line ? 2 : corners.size());
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

PieceNames::PieceNames(const Scene& scene, const TypedVertices&, const ScreenPrimitive& one)
    : piece(scene.primitives[one.primitive].name) {
    const auto indices = scene.primitives[one.primitive].corners();
    std::transform(indices.begin(), indices.end(), corners.begin(),
                   [&](std::size_t index) { return std::string_view(scene.vertices[index].name); });
}
template <typename Scalar>
PieceNames::PieceNames(const Scene& scene, const ScreenList<Scalar>& list,
                       const ScreenPrimitive& one)
    : piece(scene.primitives[one.primitive].name) {
    const std::string& name = scene.primitives[one.primitive].name;
    std::size_t i = 0;
    for (const std::size_t index : corners_of(scene, list, one)) {
        if (index >= scene.vertices.size())
            made_[i] = name_of_made(name, list.made[index - scene.vertices.size()].ordinal);
        corners[i] = index < scene.vertices.size() ? scene.vertices[index].name : made_[i];
        ++i;
    }
    if (one.state == ScreenPrimitive::State::part)
        piece = made_[3] = name + "/" + std::to_string(list.parts[one.index].ordinal);
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

template Face<Rational> face_of(const Scene&, const Transforms<Rational>&, const ScenePrimitive&,
                                const std::array<Vec<Rational, 3>, 3>&);
template void add_primitive(const Scene&, Geometry<Rational>&, std::size_t);

// For every kind of number that vertices are moved in.

template ScreenList<float> screen_list_of(const Scene&, Geometry<float>);
template Piece<float> piece_of(const Scene&, const ScreenList<float>&, const ScreenPrimitive&);
template PieceNames::PieceNames(const Scene&, const ScreenList<float>&, const ScreenPrimitive&);
template void tell_pieces(const Scene&, const ScreenList<float>&, std::size_t, const Listener&,
                          const TakeFace<float>&);

template ScreenList<double> screen_list_of(const Scene&, Geometry<double>);
template Piece<double> piece_of(const Scene&, const ScreenList<double>&, const ScreenPrimitive&);
template PieceNames::PieceNames(const Scene&, const ScreenList<double>&, const ScreenPrimitive&);
template void tell_pieces(const Scene&, const ScreenList<double>&, std::size_t, const Listener&,
                          const TakeFace<double>&);

template ScreenList<Adaptive> screen_list_of(const Scene&, Geometry<Adaptive>);
template Piece<Adaptive> piece_of(const Scene&, const ScreenList<Adaptive>&,
                                  const ScreenPrimitive&);
template PieceNames::PieceNames(const Scene&, const ScreenList<Adaptive>&, const ScreenPrimitive&);
template void tell_pieces(const Scene&, const ScreenList<Adaptive>&, std::size_t, const Listener&,
                          const TakeFace<Adaptive>&);

template ScreenList<Rational> screen_list_of(const Scene&, Geometry<Rational>);
template Piece<Rational> piece_of(const Scene&, const ScreenList<Rational>&,
                                  const ScreenPrimitive&);
template PieceNames::PieceNames(const Scene&, const ScreenList<Rational>&, const ScreenPrimitive&);
template void tell_pieces(const Scene&, const ScreenList<Rational>&, std::size_t, const Listener&,
                          const TakeFace<Rational>&);

} // namespace rastertrace
