// SPDX-License-Identifier: MIT
#pragma once

// The world of a scene, as its trace tells it: vertices, faces, and the camera that looks at them. space_drawing.h draws
// it.
//
//     if (const auto space = space_of(trace))
//         space->vertices.at("A");

#include <rastertrace/figures/drawing.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// A place in the world, or a direction.
using Position = glm::dvec3;

/// The matrices that lead from the world to the screen, and where its lines of sight are.
class ToldCamera {
public:
    /// Nothing if the screen is not that of a projection, or if one of them has no inverse.
    static std::optional<ToldCamera> of(const glm::dmat4& view, const glm::dmat4& projection,
                                        const glm::dmat4& viewport);

    /// The place that is seen at (x, y) of the screen and has this z in camera space.
    Position at(Place screen, double z) const;

    /// A vertex in clip space, in the world; nothing if it is infinitely far away.
    std::optional<Position> from_clip(const glm::dvec4& clip) const;

    /// z in camera space.
    double depth_of(const Position& position) const;

    bool is_perspective() const { return projection_[2][3] != 0; }

    /// Where all lines of sight meet; of parallel ones, nowhere.
    std::optional<Position> eye() const;

    /// z of the plane where a point of the scene is as far from the middle as it is on the screen; of a perspective.
    double plane_z() const;

    /// True if what is farther away has a larger z in canonical space.
    bool canonical_z_grows() const;

    /// From the eye to what is seen: +1 if a larger z is farther away, else -1.
    double forward() const;

    /// z of the planes that cut off what is too near or too far, as far as a frustum's matrix or an orthographic one
    /// tells them.
    std::optional<double> near_z() const;
    std::optional<double> far_z() const;

    /// The axes of camera space, in the world.
    glm::dmat4 to_world() const;

private:
    ToldCamera(const glm::dmat4& view, const glm::dmat4& projection, const glm::dmat4& viewport);

    glm::dmat4 view_;
    glm::dmat4 projection_;
    glm::dmat4 viewport_;
    glm::dmat4 from_clip_; ///< to the world
};

struct SpatialPrimitive {
    std::size_t step; ///< of the trace, where it begins
    std::string name;
    std::string face = {}; ///< of more than three corners, that it is a part of; "" for none
    std::vector<std::string> corners; ///< keys of SpatialScene::vertices
    bool is_closed = true;            ///< the last corner is joined to the first
    bool is_filled = true;
    bool is_culled = false;
    bool is_part = false; ///< what clipping left of the one before

    friend bool operator==(const SpatialPrimitive&, const SpatialPrimitive&) = default;
};

/// The test of a face, or its light: the normal, and the direction that it is compared with.
struct FaceTest {
    std::size_t step;
    std::size_t primitive; ///< its place in SpatialScene::primitives
    Position normal;
    std::optional<Position> other; ///< from the middle to the eye, or to the light
    bool is_light;                 ///< it leads there
    std::optional<double> cosine;  ///< of the angle between them
    bool is_culled;
};

/// What a trace tells of the world.
struct SpatialScene {
    std::map<std::string, Position> vertices;
    std::map<std::string, Place> images = {}; ///< of vertices, on the screen
    std::vector<SpatialPrimitive> primitives = {};
    std::vector<FaceTest> faces = {};
    std::optional<ToldCamera> camera = {}; ///< nothing if no matrix tells it
    double handedness = 1; ///< -1 of a space whose z points away from who looks along it
    std::array<std::string_view, 3> axis_names{"x", "y", "z"}; ///< "" for none
    std::vector<std::pair<Position, Position>> guides =
        {}; ///< lines that stand for what is in view

    /// The places of vertices in `vertices`.
    std::vector<Position> places_of(const std::vector<std::string>& names) const;

    /// The middle of a primitive's corners.
    Position middle_of(const SpatialPrimitive& primitive) const;
};

/// The three numbers, or more, of a place; nothing if one is not finite.
std::optional<Position> position_in(const TracedList<TracedNumber>& list);

/// "(0, 2/3, -2/3)", of the numbers that a step tells.
std::string tuple_of(const TracedList<TracedNumber>& list);

/// A `matrix` step's; nothing if it is not one of four rows and columns.
std::optional<glm::dmat4> matrix_in(const MatrixStep& step);

/// Nothing if no vertex has a place in the world.
std::optional<SpatialScene> space_of(const Trace& trace);

} // namespace rastertrace
