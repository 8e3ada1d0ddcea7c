// SPDX-License-Identifier: MIT
#pragma once

// Which frame of a scene whose numbers vary, and what varies besides what the scene says.
//
//     const FrameChoice choice{.vary = {{"/camera/position/2", "4:1:7"}}, .frame = 3};
//     read_scene(source, {}, {}, choice);  // seen from z = 3

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

/// A number of the scene that has another value in each frame, as a command line says it.
struct Variation {
    std::string pointer; ///< to the number: a JSON Pointer (RFC 6901)
    std::string values;  ///< FROM:TO:STEPS, or the values with commas between
};

/// What of a sequence is asked for.
struct FrameChoice {
    std::vector<Variation> vary; ///< in the place of what the scene says of the same number
    std::optional<std::size_t> frame = {}; ///< from 1; none: all, or the first
};

/// The most frames of a sequence.
inline constexpr std::size_t most_frames = 100'000;

} // namespace rastertrace
