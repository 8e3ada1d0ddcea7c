// SPDX-License-Identifier: MIT
#pragma once

// Random scenes for another rasterizer, rich in what rasterizers get wrong: samples on edges, slivers, edges that two
// triangles share, vertices far off the canvas, equal depths, vertices behind the eye. The same seed gives the same
// scene on every machine.
//
//     const FuzzScene scene = random_scene(17, {.kinds = {FuzzKind::plane}});
//     write(path, triangles_text(scene));

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/text/method_names.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What a scene is about: triangles in the plane, lines, triangles with depths, triangles in clip space.
enum class FuzzKind : std::uint8_t { plane, lines, depth, clip };

/// `2d`, `lines`, `depth`, `clip`.
std::optional<FuzzKind> fuzz_kind_named(std::string_view name);
inline constexpr std::array<std::string_view, 4> fuzz_kind_names{"2d", "lines", "depth", "clip"};

/// x, y, z, w in units of 1/1024: each of them is a float, a double and a short decimal. z is told of depths, w in
/// clip space.
using FuzzVertex = std::array<std::int64_t, 4>;
inline constexpr std::int64_t fuzz_unit = 1024;

struct FuzzPrimitive {
    std::string name{};
    std::vector<FuzzVertex> vertices{}; ///< two of a line, three of a triangle
    Color color{};
};

struct FuzzScene {
    FuzzKind kind = FuzzKind::plane;
    int width = 0;
    int height = 0;
    MethodOverrides method{}; ///< of the reference
    std::vector<FuzzPrimitive> primitives{};
};

/// What is common to the scenes of a run.
struct FuzzChoice {
    std::vector<FuzzKind> kinds{FuzzKind::plane}; ///< one of them for each scene
    MethodOverrides method{};
    int largest_canvas = 32; ///< pixels on a side; a power of 2
    bool has_near_ties =
        false; ///< one scene in eight ends with a primitive that numbers too short get wrong
};

FuzzScene random_scene(std::uint64_t seed, const FuzzChoice& choice);

/// The different vertices, in the order in which they come.
std::vector<FuzzVertex> fuzz_vertices(const FuzzScene& scene);

/// The scene as a scene file.
std::string scene_json(const FuzzScene& scene);

/// The scene for a program that has no reader of JSON: `canvas W H`, then a line for each primitive, in the order in
/// which they are drawn: `tri NAME x y z x y z x y z #rrggbb`, `line NAME x y z x y z #rrggbb`, in clip space
/// `clip NAME x y z w x y z w x y z w #rrggbb`. Numbers are exact decimals.
std::string triangles_text(const FuzzScene& scene);

} // namespace rastertrace
