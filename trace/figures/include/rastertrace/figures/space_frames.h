// SPDX-License-Identifier: MIT
#pragma once

// Pictures in space side by side, each with words below: a vertex in each of its spaces, a face cut into ears.
//
//     const Drawing sheet = space_frames(trace, SpaceFrames::spaces, step, {});

#include <rastertrace/figures/drawing.h>
#include <rastertrace/figures/space_eye.h>
#include <rastertrace/trace/record/trace.h>

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

enum class SpaceFrames : std::uint8_t {
    spaces, ///< of a `vertex` step: object, world, camera, clip, canonical, screen, as far as it goes through them
    ears,   ///< of a `triangulate` step: each ear, and why it is one
};
std::vector<std::string_view> space_frames_names();
std::optional<SpaceFrames> space_frames_named(std::string_view name);

/// The sheet of a step; without one, of the first that it can be of. `letter_scale` is as FigureOptions has it. Throws a Problem
/// if there is no such step.
Drawing space_frames(const Trace& trace, SpaceFrames frames, std::optional<std::size_t> step,
                     const SpaceEye& eye, double letter_scale = 1);

} // namespace rastertrace
