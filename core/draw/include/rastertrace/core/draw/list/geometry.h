// SPDX-License-Identifier: MIT
#pragma once

// The stages before anything is drawn: every vertex on its way from object space to the screen.
//
//     object --model--> world --view--> camera --projection--> clip --/w--> canonical
//            --viewport--> screen
//
// A vertex out of view stops in clip space, so that nothing is divided by a w of 0 or less.
//
//     const auto geometry = geometry_of<double>(scene);
//     geometry.list.vertices[0].position;

#include <rastertrace/core/draw/list/screen_list.h>
#include <rastertrace/core/draw/scene/fit.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/core/numbers/vec.h>

#include <cstddef>
#include <vector>

namespace rastertrace {

/// Distance of the left, right, bottom and top planes of the view from the middle of the picture,
/// in half canvases. Between them and the canvas, the fill drops pixels, at the cost of the canvas;
/// every position on the screen stays below 2^26 pixels.
inline constexpr int guard_band = 4096;

/// A vertex before clipping.
template <typename Scalar> struct ClipSpaceVertex {
    Vec<Scalar, 4> clip;
    Scalar distance;         ///< from the eye along the view
    bool is_in_view = false; ///< it lies outside of no plane
};

/// The vertices of a scene on their way to the screen.
template <typename Scalar> struct Geometry {
    ScreenList<Scalar> list; ///< begun: matrices and vertices, no primitives, no depths
    std::vector<ClipSpaceVertex<Scalar>> vertices; ///< as in Scene::vertices
    std::vector<bool> is_used;                     ///< by a primitive; others are not moved
    std::vector<Vec<Scalar, 3>> world;             ///< of all vertices, if faces are tested
};

/// True if a matrix of the scene has irrational entries, which are the nearest doubles instead.
bool has_rounded_matrix(const Scene& scene);

/// Which of the scene's vertices a primitive has.
std::vector<bool> used_vertices(const Scene& scene);

/// The box in the world around all vertices that primitives have. There must be one.
Box world_box(const Scene& scene);

/// The square of the greatest distance of such a vertex from `center`.
Rational farthest_square(const Scene& scene, const Vec<Rational, 3>& center);

// What follows is compiled in the library, for every kind of number that ScreenList is compiled
// for.

/// Takes every vertex that is used to clip space, and on to the screen if it is in view.
template <typename Scalar> Geometry<Scalar> geometry_of(const Scene& scene);

/// Tells the matrices, then the vertices, then the painter's order.
template <typename Scalar>
void tell_geometry(const Scene& scene, const ScreenList<Scalar>& list, const Listener& listener);

// To draw single primitives in exact numbers; only for Rational.

/// A geometry whose vertices have not been moved yet.
template <typename Scalar> Geometry<Scalar> empty_geometry(const Scene& scene);

/// Takes a vertex to clip space, and on to the screen if it is in view.
template <typename Scalar>
void move_vertex(const Scene& scene, std::size_t index, Geometry<Scalar>& geometry);

} // namespace rastertrace
