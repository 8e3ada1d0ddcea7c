// SPDX-License-Identifier: MIT
#pragma once

// What a replay is at as bytes that pack well, and back: the keyframes of an index.

#include "frame.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rastertrace {

/// A replay that remembers all parts, of at most 2^32 steps, and has gone forward alone. Of its primitives it has only
/// how many there are.
std::string replay_bytes(const ReplayState& state);

/// `primitives`: all of the trace. Throws a StaleIndex if the bytes are no such replay.
ReplayState replay_from_bytes(std::string_view bytes, const Canvas& canvas,
                              std::span<const std::uint32_t> primitives);

} // namespace rastertrace
