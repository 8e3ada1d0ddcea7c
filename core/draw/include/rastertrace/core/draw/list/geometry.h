// SPDX-License-Identifier: MIT
#pragma once

// The stages before anything is drawn: every vertex on its way from object space to the screen.
//
//     object --model--> world --view--> camera --projection--> clip --/w--> canonical
//            --viewport--> screen
//
// What lies out of view stops in clip space, so that nothing is divided by a w of 0 or less.
//
//     const auto geometry = geometry_of<double>(scene);
//     geometry.list.vertices[0].position;

#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/scene/fit.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/core/numbers/vec.h>
#include <rastertrace/core/raster/steps.h>

#include <cstddef>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The four sides of the space that is not clipped stand this many half canvases from the middle of
/// the picture. Nearer than that, it is the fill that drops what the canvas does not have, at the
/// cost of the canvas; every place on the screen stays below 2^26 pixels.
inline constexpr int guard_band = 4096;

/// The last spaces of a vertex. `pixel` is where it is drawn: on the screen, snapped if it is to be.
template <typename Scalar> struct ScreenPositions {
    Vec<Scalar, 4> canonical;
    Vec<Scalar, 2> screen;
    Vec<Scalar, 2> pixel;
};

/// A vertex before clipping.
template <typename Scalar> struct ClipSpaceVertex {
    Vec<Scalar, 4> clip;
    Scalar distance;         ///< from the eye along the view
    bool is_in_view = false; ///< it lies outside of no plane
};

/// The places of all vertices that a primitive has.
template <typename Scalar> struct Geometry {
    ScreenList<Scalar> list; ///< begun: matrices and vertices, no primitives, no depths
    std::vector<ClipSpaceVertex<Scalar>> vertices; ///< as in Scene::vertices
    std::vector<bool> is_used;                     ///< by a primitive; the others are not placed
    std::vector<Vec<Scalar, 3>> world;             ///< of all vertices, if faces are tested
};

/// True if a matrix of the scene has irrational entries, which are the nearest doubles instead.
bool has_rounded_matrix(const Scene& scene);

/// Which of the scene's vertices a primitive has.
std::vector<bool> used_vertices(const Scene& scene);

/// The box around all vertices that primitives have, in the world. There must be one.
Box world_box(const Scene& scene);

/// The square of the greatest distance of such a vertex from `center`.
Rational farthest_square(const Scene& scene, const Vec<Rational, 3>& center);

// What follows is compiled in the library, for float, double, Adaptive and Rational.

/// Takes every vertex that is used to clip space, and on to the screen if it can be seen.
template <typename Scalar> Geometry<Scalar> geometry_of(const Scene& scene);

/// A geometry whose vertices have no place yet. Only for Rational.
template <typename Scalar> Geometry<Scalar> empty_geometry(const Scene& scene);

/// A vertex in the world and in clip space.
template <typename Scalar> struct VertexInSpace {
    Vec<Scalar, 3> world;
    ClipSpaceVertex<Scalar> in_clip_space;
};
template <typename Scalar>
VertexInSpace<Scalar> vertex_in_space(const Scene& scene, const Transforms<Scalar>& transforms,
                                      std::size_t index);

/// Takes a vertex to clip space, and on to the screen if it can be seen. Only for Rational.
template <typename Scalar>
void move_vertex(const Scene& scene, std::size_t index, Geometry<Scalar>& geometry);

/// x/w, y/w and z/w, moved to the screen. w must not be 0.
template <typename Scalar>
ScreenPositions<Scalar> positions_on_screen(const Vec<Scalar, 4>& clip,
                                            const Transforms<Scalar>& transforms);

/// Tells a place of a vertex: the first `count` coordinates.
template <typename Scalar>
void tell_position(std::string_view name, Space space, const Vec<Scalar, 4>& at, std::size_t count,
                   const Listener& listener);

/// Tells the spaces of a vertex from clip space on.
template <typename Scalar>
void tell_positions_on_screen(std::string_view name, const Vec<Scalar, 4>& clip,
                              const Transforms<Scalar>& transforms, const Listener& listener);

/// Tells the matrices, then the vertices, then what the painter has sorted.
template <typename Scalar>
void tell_geometry(const Scene& scene, const ScreenList<Scalar>& list, const Listener& listener);

} // namespace rastertrace
