// SPDX-License-Identifier: MIT
#pragma once

// Files that are read, and how far they are trusted: none fills the memory because it never ends.
//
//     const auto scene = read_source("scene.json", {.bytes = 1'000'000});

#include "problem.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace rastertrace {

/// What is read of the files that a user names, or that those name in turn.
struct InputLimits {
    std::size_t bytes = 256'000'000; ///< of a scene or an OBJ file; a trace may have any size
    bool allow_outside = false;      ///< OBJ files may lie outside of the scene's folder
    std::size_t steps = 10'000'000;  ///< of a trace that has to be held
};

/// Why a trace is not held that has more steps than that.
Problem too_many_steps(const std::string& name, std::size_t most);

/// How many bytes of text, or pixels, the steps of a scene may have that are held: so many for each step that may be held,
/// and for InputLimits::steps at least.
inline std::size_t most_held(std::size_t most_steps, std::size_t of_step) {
    const std::size_t steps = std::max(most_steps, InputLimits().steps);
    return steps > std::numeric_limits<std::size_t>::max() / of_step ? steps : steps * of_step;
}
inline constexpr std::size_t held_bytes_of_step = 100;
inline constexpr std::size_t held_pixels_of_step = 20;

/// Why steps are not held that have more of them; `unit` is "bytes" or "pixels".
Problem too_much_to_hold(const std::string& name, std::size_t most, std::string_view unit);

/// Reads a scene or a trace; "-" is standard input. One that is too large, that has too long a line
/// for a trace, or that is no text, is left alone as soon as that is known.
Result<Source> read_source(const std::string& path, const InputLimits& limits);

/// The same for a command that takes claims too, which need not be JSON.
Result<Source> read_source_or_claims(const std::string& path, const InputLimits& limits);

/// Reads a file of any bytes, such as a picture, without waiting: no standard input, no pipe and no device.
Result<Source> read_bytes(const std::string& path, const InputLimits& limits);

/// Reads a file of any text, such as one that another file names: no standard input, no pipe and no
/// device.
Result<Source> read_named_file(const std::string& path, const InputLimits& limits);

} // namespace rastertrace
