// SPDX-License-Identifier: MIT
#pragma once

// The list of what is drawn: every primitive, or part of one, with its corners on the screen and its
// color. geometry.h and pieces.h make it; the plan owns it; drawing walks it.

#include <rastertrace/core/draw/list/drawing_order.h>
#include <rastertrace/core/draw/scene/transforms.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/transform/matrix.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace rastertrace {

/// The matrices of a scene; those that it does not have leave a vertex where it is.
template <typename Scalar> struct Transforms {
    std::vector<std::optional<Matrix<Scalar>>> models; ///< of the scene's objects
    std::optional<Matrix<Scalar>> rest_model;          ///< of vertices that have no object
    std::optional<Matrix<Scalar>> view;
    std::optional<Matrix<Scalar>> projection;
    std::optional<Matrix<Scalar>> viewport;
    std::vector<ClipPlane<Scalar>> planes; ///< those that a vertex lies outside of
    bool divides = true;                   ///< by w
    StageSet needed; ///< of the stages of vertices: those that could change the picture
    Snap snap = Snap::none;
    Ties ties = Ties::up; ///< of Snap::nearest
    Vec<Scalar, 3> eye{}; ///< if faces are tested; see eye_of
};

/// Where a vertex is drawn, and what is interpolated from it.
template <typename Scalar> struct ScreenVertex {
    Vec<Scalar, 2> position{};
    Scalar depth{};     ///< if there is a depth buffer
    Scalar inverse_w{}; ///< if colors are mixed
};

/// How many vertices that are used lie outside of a plane of the view.
struct VerticesOutside {
    std::string_view plane;
    std::size_t vertices;
};

/// What the list holds of a primitive: all of it, or one of the parts that clipping has left.
struct ScreenPrimitive {
    enum class State : std::uint8_t {
        whole,
        part,
        skipped, ///< whole, and not drawn: its face is culled, or has no normal; or those of a side are
        undecided, ///< doubles leave its face open, or what clipping leaves of it
    };
    std::uint32_t primitive; ///< its index in the scene
    std::uint32_t index;     ///< of a part, in ScreenList::parts; in ScreenList::undecided
    Color color;             ///< of the primitive, lit
    State state = State::whole;
};

/// A vertex that clipping has made.
struct MadeVertex {
    Color color;
    int ordinal;      ///< in its primitive, from 1
    std::size_t side; ///< index in the scene of the first vertex of what was clipped
};

/// The corners of a part.
struct ScreenPart {
    std::array<std::size_t, 3> corners; ///< indices in ScreenList::vertices
    int ordinal;                        ///< in its primitive, from 1
};

/// All that is drawn of a scene, with its place on the screen.
template <typename Coordinate> struct ScreenList {
    Transforms<Coordinate> transforms;
    std::optional<PainterOrder<Coordinate>> order; ///< if the painter has sorted them
    std::vector<VerticesOutside> outside;          ///< of each plane of the view
    bool mixes_colors = false;                     ///< of vertices
    Depth depth = Depth::none;

    /// The scene's, of which those out of view have no position; then those that clipping made.
    std::vector<ScreenVertex<Coordinate>> vertices;
    std::vector<bool> is_drawn; ///< of the scene's: those that are drawn
    std::vector<MadeVertex> made;
    std::vector<ScreenPart> parts;
    std::vector<ScreenPrimitive> primitives; ///< in the order in which they are drawn
    std::vector<Undecided> undecided;        ///< what left them open

    /// Of the scene's primitives: lines that are not drawn, as no face is that they are sides of. Empty if
    /// none of its lines goes by that.
    std::vector<bool> culled_sides;

    /// The first primitive of the scene with a face that is told with an infinity.
    std::optional<std::size_t> infinite_face;
};

/// A scene without a pipeline needs no list: vertices are drawn where they were typed.
struct TypedVertices {
    bool mixes_colors = false;
};

/// What is drawn: the vertices as typed, or a list of what lies on the screen. `fixed` moves vertices in
/// double and snaps them when they are drawn.
struct AnyScreenList : std::variant<TypedVertices, ScreenList<float>, ScreenList<double>,
                                    ScreenList<Adaptive>, ScreenList<Rational>> {
    using variant::variant;
};

/// The primitives in the order in which they are drawn: the scene's, or the painter's.
template <typename Coordinate>
std::size_t primitive_at(const ScreenList<Coordinate>& list, std::size_t turn) {
    return list.order ? list.order->primitives[turn] : turn;
}

/// True if all of a primitive is in view, so that clipping leaves it alone.
template <typename Coordinate>
bool is_whole(const Scene& scene, const ScreenList<Coordinate>& list, std::size_t index) {
    const auto corners = scene.primitives[index].corners();
    return std::all_of(corners.begin(), corners.end(),
                       [&list](std::size_t corner) { return list.is_drawn[corner]; });
}

} // namespace rastertrace
