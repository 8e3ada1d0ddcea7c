// SPDX-License-Identifier: MIT
#pragma once

// What a trace amounts to: how many steps, pixels, and pixels drawn again.
//
//     const Stats stats = stats_of(trace);

#include <rastertrace/trace/trace.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

/// What one primitive drew.
struct PrimitiveStats {
    std::string kind;
    std::string name;
    std::uint64_t writes = 0; ///< pixel steps
    std::uint64_t over = 0;   ///< of these, onto pixels that were drawn already
    std::string skipped;      ///< why it drew nothing, if it was skipped
};

struct Stats {
    std::uint64_t steps = 0;
    std::vector<std::pair<std::string, std::uint64_t>> count; ///< by kind, in order of appearance
    std::uint64_t canvas = 0;                                 ///< pixels that the canvas has
    std::uint64_t pixels = 0;                                 ///< different pixels drawn
    std::uint64_t writes = 0;                                 ///< pixel steps on the canvas
    std::vector<PrimitiveStats> primitives;
    std::string frame;          ///< name of the final picture, see frame_name
    bool frame_differs = false; ///< the end record names another picture
};

Stats stats_of(const Trace& trace);

} // namespace rastertrace
