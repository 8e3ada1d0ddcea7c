// SPDX-License-Identifier: MIT
#pragma once

// The stages of drawing, in the order in which they run, and when each is needed: if the picture
// could change without it. All of it is decided before anything is drawn.
//
//     stage        does                                   is needed if
//     model        object to world space                  a model moves something
//     view         world to camera space                  the camera does
//     clip         cuts at a plane, each by itself        a vertex lies outside the plane
//     divide       divides by w                           a w is not 1
//     order        sorts for the painter                  the farthest do not come first already
//     cull         drops faces by their normals           the method asks for it
//     light        lights faces                           the method asks for it
//     canvas       drops pixels that the canvas has not   a triangle may reach beyond the canvas
//     depth        tests pixels against the nearest       two primitives share a pixel, or one is
//                                                         cut, or as far as the buffer starts
//     perspective  mixes colors as they mix in space      w differs in a triangle or a line
//     colors       mixes the colors of vertices           they differ in a triangle
//
// The last four are decided for each triangle, and depth for each primitive (PixelStages). A stage
// that the scene keeps although it does not need it runs, and the picture is the same.
//
//     plan_for(scene).stages.decisions;

#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/raster/canvas.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Where the colors of pixels come from.
enum class ColorStage : std::uint8_t {
    flat,        ///< all pixels have the same color
    affine,      ///< mixed as they mix on the screen
    perspective, ///< mixed as they mix in space
};

/// What is done for each pixel of a triangle beside plotting it.
struct PixelStages {
    ColorStage colors = ColorStage::flat;
    bool tests_depth = false; ///< against what is nearest so far
    bool tests_canvas = true; ///< drops what the canvas does not have
    bool is_painted = true;   ///< false: it is only tested
};

/// What a stage that is left out would have cost.
struct Savings {
    std::uint64_t bytes = 0;  ///< of memory
    std::uint64_t steps = 0;  ///< in the trace, beside those of pixels
    std::uint64_t pixels = 0; ///< tested; an upper bound, since boxes are counted
};

/// What was decided about a stage.
struct StageDecision {
    Stage stage;
    std::string_view plane; ///< of Stage::clip; "" elsewhere
    bool is_kept;
    std::string why;
    Savings saved = {}; ///< if it is left out
};

/// All that was decided.
struct Stages {
    std::vector<StageDecision> decisions; ///< in the order in which the stages run
    std::vector<PixelStages> pixels;      ///< of the scene's primitives
    DepthRegion depth_region = {};        ///< the pixels whose depths are tested
};

struct AnyScreenList; // screen_list.h

/// Decides about every stage. `depth_size` is that of an element of the depth buffer, in bytes.
Stages stages_of(const Scene& scene, const AnyScreenList& list, std::size_t depth_size);

/// "1 triangle", "3 triangles".
inline std::string counted(std::uint64_t count, std::string_view noun) {
    return std::to_string(count).append(" ").append(noun).append(count == 1 ? "" : "s");
}

} // namespace rastertrace
