// SPDX-License-Identifier: MIT
#pragma once

// Which steps tell of a pixel and of the primitives nearest to it: of a trace of many primitives, few have to be told of
// in sentences.
//
//     const auto chosen = steps_to_read(trace, {4, 2}, 12);
//     chosen->others["outside"];  // so many primitives are farther away

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/record/trace.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

struct StepsToRead {
    std::vector<std::size_t> steps{}; ///< by number, in order
    std::map<std::string, std::size_t>
        others{}; ///< primitives farther away: how many of each reason (WhyNot)
};

/// For at least so many of the nearest. `nullopt` if a trace lacks steps, has some that are not written as StepWriter
/// writes them, or has too few primitives.
std::optional<StepsToRead> steps_to_read(const Trace& trace, Pixel pixel, std::size_t nearest);

} // namespace rastertrace
