// SPDX-License-Identifier: MIT
#pragma once

// Files that are read, and how far they are trusted: none fills the memory because it never ends.
//
//     const auto scene = read_source("scene.json", {.bytes = 1'000'000});

#include "problem.h"

#include <cstddef>
#include <string>

namespace rastertrace {

/// What is read of the files that a user names, or that those name in turn.
struct InputLimits {
    std::size_t bytes = 256'000'000; ///< of a scene or an OBJ file; a trace may have any size
    bool allow_outside = false;      ///< OBJ files may lie outside of the scene's folder
    std::size_t steps = 10'000'000;  ///< of a trace that has to be held
};

/// Why a trace is not held that has more steps than that.
Problem too_many_steps(const std::string& name, std::size_t most);

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
