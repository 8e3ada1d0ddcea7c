// SPDX-License-Identifier: MIT
#pragma once

// The list of what is drawn: every primitive, or part of a clipped one, with its corners on the
// screen and its color. geometry.h and pieces.h make it; the plan owns it; drawing walks it.

#include <rastertrace/core/draw/list/coordinates.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/scene/transforms.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/clip.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/mixed_colors.h>
#include <rastertrace/core/transform/matrix.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace rastertrace {

/// The matrices of a scene. One that is absent leaves a vertex where it is.
template <typename Scalar> struct Transforms {
    std::vector<std::optional<Matrix<Scalar>>> models; ///< of the scene's objects
    std::optional<Matrix<Scalar>> rest_model;          ///< of vertices that have no object
    std::optional<Matrix<Scalar>> view;
    std::optional<Matrix<Scalar>> projection;
    std::optional<Matrix<Scalar>> viewport;
    bool begins_in_clip_space = false;     ///< there vertices are typed
    bool moves_depths = false;             ///< the viewport has a range of depths
    std::vector<ClipPlane<Scalar>> planes; ///< those that a vertex lies outside of
    bool divides = true;                   ///< by w
    StageSet needed;                       ///< the stages of vertices that could change the picture
    Snap snap = Snap::none;
    Ties ties = Ties::up; ///< of Snap::nearest
    Vec<Scalar, 3> eye{}; ///< if faces are tested; see eye_of
};

/// The order in which the painter draws a scene's primitives. Points and lines keep their turns.
template <typename Scalar> struct PainterOrder {
    std::vector<std::size_t> primitives; ///< indices in Scene::primitives
    std::vector<Scalar> keys;            ///< distances of the faces, in the order drawn
};

/// The position where a vertex is drawn, and what is interpolated from it.
template <typename Scalar> struct ScreenVertex {
    Vec<Scalar, 2> position{};
    Scalar depth{};     ///< if there is a depth buffer
    Scalar inverse_w{}; ///< if colors are mixed
};

/// How many of the vertices in use lie outside a plane of the view.
struct VerticesOutside {
    std::string_view plane;
    std::size_t vertices;
};

/// An entry of the list: a primitive, or one of the parts that clipping has left of it.
struct ScreenPrimitive {
    enum class State : std::uint8_t {
        whole,
        part,
        skipped,   ///< whole, and not drawn: culled, or without area
        undecided, ///< doubles do not decide its face, or what clipping leaves of it
    };
    std::uint32_t primitive; ///< its index in the scene
    std::uint32_t index; ///< in ScreenList::parts of a part; in ScreenList::undecided if undecided
    Color color;         ///< of the primitive, lit
    State state = State::whole;
};

/// A vertex that clipping has made.
struct MadeVertex {
    Color color;      ///< rounded
    int ordinal;      ///< in its primitive, from 1
    std::size_t side; ///< index in the scene of the first vertex of what was clipped
};

/// The corners of a part.
struct ScreenPart {
    std::vector<std::size_t> corners; ///< indices in ScreenList::vertices
    int ordinal;                      ///< in its primitive, from 1
};

/// A face whose normal, or that times the view or the light, is infinite.
struct InfiniteFace {
    std::size_t primitive;    ///< index in the scene
    std::array<double, 2> at; ///< x and y of its first vertex in the world
};

/// All that is drawn of a scene, in screen space.
template <typename Coordinate> struct ScreenList {
    Transforms<Coordinate> transforms;
    std::optional<PainterOrder<Coordinate>> order; ///< if the painter has sorted them
    std::vector<VerticesOutside> outside;          ///< for each plane of the view
    bool mixes_colors = false;                     ///< of vertices
    Depth depth = Depth::none;

    /// The scene's vertices, then those that clipping has made. Vertices out of view have no
    /// position.
    std::vector<ScreenVertex<Coordinate>> vertices;
    std::vector<bool> is_drawn; ///< for each vertex of the scene
    std::vector<MadeVertex> made;
    std::vector<Levels<Coordinate>> levels; ///< of these, if colors are mixed
    std::vector<ScreenPart> parts;
    std::vector<ScreenPrimitive> primitives; ///< in the order in which they are drawn
    std::vector<Undecided> undecided;        ///< the comparisons that doubles did not decide

    /// For each primitive of the scene: true if it is a side of faces, and none of them is drawn.
    /// Empty if no line depends on faces.
    std::vector<bool> culled_sides;

    std::optional<InfiniteFace> infinite_face; ///< the first one of the scene
};

/// A scene without a pipeline needs no list: vertices are drawn where they were typed.
struct TypedVertices {
    bool mixes_colors = false;
};

/// What is drawn: the vertices as typed, or a list in screen space. `fixed` moves vertices in
/// double and snaps them when they are drawn.
struct AnyScreenList : OfAnyCoordinate<TypedVertices, ScreenList> {
    using variant::variant;
};

/// The index of the primitive that is drawn at this turn: in the scene's order, or in the
/// painter's.
template <typename Coordinate>
std::size_t primitive_at(const ScreenList<Coordinate>& list, std::size_t turn) {
    return list.order ? list.order->primitives[turn] : turn;
}

/// The corners of a primitive, or of a part of one: indices in ScreenList::vertices.
inline std::span<const std::size_t>
corners_of(const Scene& scene, const std::vector<ScreenPart>& parts, const ScreenPrimitive& one) {
    if (one.state != ScreenPrimitive::State::part)
        return scene.primitives[one.primitive].corners();
    return parts[one.index].corners;
}

/// True if all of a primitive is in view, so that clipping leaves it alone.
template <typename Coordinate>
bool is_whole(const Scene& scene, const ScreenList<Coordinate>& list, std::size_t index) {
    const auto corners = scene.primitives[index].corners();
    return std::all_of(corners.begin(), corners.end(),
                       [&list](std::size_t corner) { return list.is_drawn[corner]; });
}

} // namespace rastertrace
