// SPDX-License-Identifier: MIT
#pragma once

// Is a scene near any cliff? A cliff is where a small change of a number, such as its rounding, has a
// large effect: a sample that an edge runs through, a face seen edge-on, a triangle with depths from
// 1 to a million. Everything is looked at in exact arithmetic, on the screen.
//
//     for (const CliffGroup& group : cliffs_of(scene))
//         for (const Cliff& cliff : group.worst)
//             cliff.where;  // "edge AB of triangle ABC"
//
// That a scene is near a cliff does not say that it falls: compared_pictures draws it with every
// scalar and counts the pixels that do.

#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What there is to fall from.
enum class CliffKind {
    depth_ratio,    ///< depths in one triangle of which one is 10^6 times another, or more
    slope,          ///< |dx/dy| of an edge 10^6 or more, or 10^-6 or less and not 0
    absorbed_step,  ///< a step of x from row to row that is lost in x: |x| / |dx/dy| >= 2^(p-1)
    growing_error,  ///< n steps added up: n^2 |slope| 2^-p reaches the nearest tie, 1/(2n)
    sliver,         ///< twice the area is at most 2^(2-p) of the products that it is made of
    sample_on_edge, ///< an edge passes a sample within 2^-20 px, or a line a tie
    collapsed,      ///< a triangle has an area as typed, but none where `fixed` snaps it
    snapped,        ///< `fixed` moves a vertex
    edge_on,        ///< |cosine| between normal and view at most 2^-20
    near_plane,     ///< a vertex on the near plane, or cut off by it, or at the eye
    far_out,        ///< a coordinate beyond 2^23, where float has no halves of pixels
};

/// "sliver", as JSON has it.
std::string_view name_of(CliffKind kind);
/// In a line for people: what it is, and who falls.
std::string_view meaning_of(CliffKind kind);

/// One place near a cliff. Names in it are as typed: not yet safe to print.
struct Cliff {
    std::string where;    ///< "edge AB of triangle ABC"
    std::string how_near; ///< with numbers
    double nearness = 0;  ///< the larger, the nearer; comparable within a kind
};

/// The places near cliffs of one kind, worst first, and how many more there are.
struct CliffGroup {
    CliffKind kind;
    std::vector<Cliff> worst;
    std::uint64_t more = 0;
};

/// How many places of a kind are kept.
inline constexpr std::size_t most_cliffs = 20;

/// The groups that are not empty. The scene's scalar does not matter; its other methods do.
std::vector<CliffGroup> cliffs_of(const Scene& scene);

/// A scene's picture with one scalar, beside the exact one.
struct ComparedPicture {
    std::string scalar;
    std::string refusal;         ///< why there is no picture; "" if there is one
    std::uint64_t pixels = 0;    ///< that it draws, or `exact` does
    std::uint64_t differing = 0; ///< of these: by their color, or by the primitive that they show
    std::optional<Pixel> first;  ///< of those, from the top and from the left
};

/// Reads and draws a scene with every scalar. If `exact` is refused, nothing differs from it.
std::vector<ComparedPicture> compared_pictures(const Source& source,
                                               const MethodOverrides& method = {},
                                               const InputLimits& limits = {},
                                               const FrameChoice& choice = {});

} // namespace rastertrace
