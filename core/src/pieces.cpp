// SPDX-License-Identifier: MIT
#include <rastertrace/core/pieces.h>

#include "listener_sink.h"

#include <rastertrace/core/clip.h>

#include <algorithm>
#include <span>
#include <string>
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
Face<Scalar> face_of(const Scene& scene, const Geometry<Scalar>& geometry,
                     const ScenePrimitive& primitive) {
    Face<Scalar> face;
    if (geometry.world.empty() || primitive.kind != PrimitiveKind::triangle)
        return face;
    const auto& a = geometry.world[primitive.vertices[0]];
    const auto& b = geometry.world[primitive.vertices[1]];
    const auto& c = geometry.world[primitive.vertices[2]];
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
                                        ? geometry.eye - centroid
                                        : geometry.eye;
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
        face.lit = FaceLit<Scalar>{.normal = normal,
                                   .light = light,
                                   .dot = product,
                                   .intensity = to_double(intensity),
                                   .color = lit(primitive.color, intensity)};
    }
    return face;
}

/// What the depth buffer holds of a vertex.
template <typename Scalar>
Scalar depth_at(Depth depth, const Scalar& distance, const Vec<Scalar, 4>& clip) {
    switch (depth) {
    case Depth::linear_z:
        return distance;
    case Depth::inverse_z:
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

/// A primitive whose vertices all have a place: `position_of(i)` tells it.
template <typename Coordinate, typename PositionOf>
Piece<Coordinate> whole_piece(const Scene& scene, std::size_t number, Color color,
                              bool mixes_colors, PositionOf&& position_of) {
    const ScenePrimitive& primitive = scene.primitives[number];
    Piece<Coordinate> piece{.kind = primitive.kind,
                            .name = primitive.name,
                            .primitive = number,
                            .color = color,
                            .names = {},
                            .colors = {}};
    for (const std::size_t place : primitive.corners()) {
        const SceneVertex& vertex = scene.vertices[place];
        const std::size_t i = piece.count++;
        piece.names[i] = vertex.name;
        piece.positions[i] = position_of(place);
        piece.colors[i] = mixes_colors ? vertex.color.value_or(color) : color;
        piece.vertices[i] = place;
    }
    return piece;
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
/// wholly inside of is reported. If nothing is left: why. Only a vertex that it begins with makes a
/// plane cut: one that clipping has made lies, but for rounding, between two of those.
template <typename Scalar>
std::optional<SkipReason>
clip_at_planes(std::string_view name, std::vector<ClipVertex<Scalar>>& polygon,
               const std::vector<ClipPlane<Scalar>>& planes, const Listener& listener) {
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

        std::vector<ClipVertex<Scalar>> left = clip(polygon, plane);
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

/// What some vertices of a primitive span, before clipping.
template <typename Scalar>
std::vector<ClipVertex<Scalar>> polygon_of(const Scene& scene, const Geometry<Scalar>& geometry,
                                           Color color, std::span<const std::size_t> corners,
                                           bool mixes_colors) {
    std::vector<ClipVertex<Scalar>> polygon;
    for (const std::size_t place : corners)
        polygon.push_back({geometry.vertices[place].clip, geometry.vertices[place].distance,
                           mixes_colors ? scene.vertices[place].color.value_or(color) : color,
                           static_cast<int>(polygon.size())});
    return polygon;
}

/// Clips what some vertices of a primitive span, puts the vertices that this makes on the screen, and
/// visits what is left: a point, a line, or the triangles of a fan. `made` counts the vertices that
/// clipping has made, `parts` the pieces. If nothing is left: why.
template <typename Scalar>
std::optional<SkipReason>
visit_parts(const Scene& scene, const Geometry<Scalar>& geometry, std::size_t number, Color color,
            std::span<const std::size_t> corners, bool mixes_colors, int& made, int& parts,
            const Listener& listener, const std::type_identity_t<PieceVisitor<Scalar>>& visit) {
    const ScenePrimitive& primitive = scene.primitives[number];
    std::vector<ClipVertex<Scalar>> polygon =
        polygon_of(scene, geometry, color, corners, mixes_colors);
    const auto reason =
        clip_at_planes(primitive.name, polygon, geometry.transforms.planes, listener);

    std::vector<std::string> names;
    std::vector<Vec<Scalar, 2>> positions;
    for (const ClipVertex<Scalar>& vertex : polygon) {
        if (vertex.original >= 0) {
            names.push_back(
                scene.vertices[corners[static_cast<std::size_t>(vertex.original)]].name);
        } else {
            names.push_back(primitive.name + ":" + std::to_string(++made));
            tell_place<Scalar>(names.back(), Space::clip, vertex.position, 4, listener);
            tell_places_on_screen(names.back(), vertex.position, geometry.transforms, listener);
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
                            .primitive = number,
                            .color = color,
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
            piece.depths[i] = depth_at<Scalar>(geometry.depth, polygon[corner].distance,
                                               polygon[corner].position);
            piece.inverse_w[i] = scalar_from<Scalar>(1) / polygon[corner].position.w;
            piece.vertices[i] = corners[static_cast<std::size_t>(std::max(original, 0))];
        }
        visit(piece);
    }
    return reason;
}

/// Visits the pieces of a primitive. In view it is one; what clips it is reported.
template <typename Scalar>
void visit_pieces(const Scene& scene, const Geometry<Scalar>& geometry, std::size_t number,
                  bool mixes_colors, const Listener& listener,
                  const std::type_identity_t<PieceVisitor<Scalar>>& visit) {
    const ScenePrimitive& primitive = scene.primitives[number];
    const auto corners = primitive.corners();
    const Face<Scalar> face = face_of(scene, geometry, primitive);
    const Color color = color_of(scene, number, face);

    // In view: one piece. Clipping it would leave it as it is.
    if (std::all_of(corners.begin(), corners.end(), [&geometry](std::size_t place) {
            return geometry.vertices[place].is_in_view;
        })) {
        auto piece =
            whole_piece<Scalar>(scene, number, color, mixes_colors, [&geometry](std::size_t place) {
                return geometry.vertices[place].pixel;
            });
        if (scene.keep.has(Stage::clip)) {
            auto polygon = polygon_of(scene, geometry, color, corners, mixes_colors);
            clip_at_planes(primitive.name, polygon, geometry.transforms.planes, listener);
        }
        for (std::size_t i = 0; i < piece.count; ++i) {
            const PlacedVertex<Scalar>& vertex = geometry.vertices[piece.vertices[i]];
            piece.depths[i] = depth_at<Scalar>(geometry.depth, vertex.distance, vertex.clip);
            if (mixes_colors)
                piece.inverse_w[i] = scalar_from<Scalar>(1) / vertex.clip.w;
        }
        piece.face = face;
        visit(piece);
        return;
    }

    // Cut: what is left of it comes as parts. The sides of an outline are cut one by one.
    const ListenerSink sink(listener);
    std::array<std::string_view, 3> names;
    for (std::size_t i = 0; i < corners.size(); ++i)
        names[i] = scene.vertices[corners[i]].name;
    sink(PrimitiveBegan<Scalar>{.kind = primitive.kind,
                                .name = primitive.name,
                                .vertices = std::span(names).first(corners.size()),
                                .positions = {},
                                .color = color,
                                .colors = {}});
    if (!report_face(face, sink))
        return;
    int made = 0;
    int parts = 0;
    std::optional<SkipReason> reason;
    if (primitive.kind != PrimitiveKind::outline) {
        reason = visit_parts(scene, geometry, number, color, corners, mixes_colors, made, parts,
                             listener, visit);
    } else {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::array<std::size_t, 2> side{corners[i], corners[(i + 1) % 3]};
            reason = visit_parts(scene, geometry, number, color, side, mixes_colors, made, parts,
                                 listener, visit);
        }
    }
    if (parts == 0)
        listener(PrimitiveSkipped{.why = *reason});
}

/// Without a pipeline every primitive is one piece.
void visit_pieces(const Scene& scene, const TypedGeometry&, std::size_t number, bool mixes_colors,
                  const Listener&, const PieceVisitor<Number>& visit) {
    visit(whole_piece<Number>(
        scene, number, color_of(scene, number, Face<Number>{}), mixes_colors,
        [&scene](std::size_t place) {
            return Vec<Number, 2>{scene.vertices[place].x, scene.vertices[place].y};
        }));
}

/// Calls visit_pieces for every primitive in its turn.
template <typename AGeometry, typename Visit>
void visit_all_pieces(const Scene& scene, const AGeometry& geometry, const Visit& visit,
                      const Listener& listener) {
    const bool mixes_colors = scene.mixes_colors();
    for (std::size_t turn = 0; turn < scene.primitives.size(); ++turn)
        visit_pieces(scene, geometry, primitive_at(geometry, turn), mixes_colors, listener, visit);
}

template <typename Scalar>
void for_each_piece(const Scene& scene, const Geometry<Scalar>& geometry,
                    const std::type_identity_t<PieceVisitor<Scalar>>& visit,
                    const Listener& listener) {
    visit_all_pieces(scene, geometry, visit, listener);
}
void for_each_piece(const Scene& scene, const TypedGeometry& geometry,
                    const PieceVisitor<Number>& visit, const Listener& listener) {
    visit_all_pieces(scene, geometry, visit, listener);
}

// For every kind of number that vertices are moved in.

template Face<float> face_of(const Scene&, const Geometry<float>&, const ScenePrimitive&);
template void visit_pieces(const Scene&, const Geometry<float>&, std::size_t, bool, const Listener&,
                           const PieceVisitor<float>&);
template void for_each_piece(const Scene&, const Geometry<float>&, const PieceVisitor<float>&,
                             const Listener&);

template Face<double> face_of(const Scene&, const Geometry<double>&, const ScenePrimitive&);
template void visit_pieces(const Scene&, const Geometry<double>&, std::size_t, bool,
                           const Listener&, const PieceVisitor<double>&);
template void for_each_piece(const Scene&, const Geometry<double>&, const PieceVisitor<double>&,
                             const Listener&);

template Face<Adaptive> face_of(const Scene&, const Geometry<Adaptive>&, const ScenePrimitive&);
template void visit_pieces(const Scene&, const Geometry<Adaptive>&, std::size_t, bool,
                           const Listener&, const PieceVisitor<Adaptive>&);
template void for_each_piece(const Scene&, const Geometry<Adaptive>&, const PieceVisitor<Adaptive>&,
                             const Listener&);

template Face<Rational> face_of(const Scene&, const Geometry<Rational>&, const ScenePrimitive&);
template void visit_pieces(const Scene&, const Geometry<Rational>&, std::size_t, bool,
                           const Listener&, const PieceVisitor<Rational>&);
template void for_each_piece(const Scene&, const Geometry<Rational>&, const PieceVisitor<Rational>&,
                             const Listener&);

} // namespace rastertrace
