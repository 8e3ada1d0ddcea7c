// SPDX-License-Identifier: MIT
#pragma once

// The scene in space, seen from the side: wireframe, eye, view plane, normals. What a camera sees is explained by
// somebody who stands beside it.
//
//     if (const auto space = space_of(trace)) drawing = scene_drawing(*space, 300, 300);

#include <rastertrace/figures/drawing.h>
#include <rastertrace/trace/record/trace.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

using Position = std::array<double, 3>;

/// The eye, and what it looks through.
struct Viewer {
    Position eye;
    std::array<Position, 4> view_plane; ///< the corners of the canvas on it, in a circle
};

/// The test of a face: its normal, and where it was seen from.
struct FaceTest {
    Position middle;
    Position normal;
    std::optional<Position> view; ///< from the middle to the eye, or to the light
    std::optional<double> cosine; ///< of the angle between them
};

/// What a trace tells of the world.
struct SpatialScene {
    std::map<std::string, Position> vertices;
    std::vector<std::pair<std::string, std::string>> seen;   ///< sides of faces that are drawn
    std::vector<std::pair<std::string, std::string>> culled; ///< sides of culled faces only
    std::vector<FaceTest> faces;                             ///< that were tested
    std::optional<Viewer> viewer; ///< none where all lines of sight are parallel
};

/// Nothing if no vertex has three coordinates.
std::optional<SpatialScene> space_of(const Trace& trace);

/// As large as it is asked to be.
Drawing scene_drawing(const SpatialScene& space, double width, double height);

} // namespace rastertrace
