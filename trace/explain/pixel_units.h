// SPDX-License-Identifier: MIT
#pragma once

// What the index of a trace has for questions about a pixel: which primitives reach it, and how far away the others are.
//
//     write_index(trace, pixel_units_of(trace), "a.jsonl.index");

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/trace_index.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

/// Goes through a trace.
PixelUnits pixel_units_of(const Trace& trace);

/// What is needed of a trace to tell of a pixel and of the primitives nearest to it.
struct StepsToRead {
    std::vector<std::size_t> steps{}; ///< by number, in order
    std::map<std::string, std::size_t>
        others{}; ///< primitives farther away: how many of each reason (WhyNot)
};

/// By the index of the trace, for at least so many of the nearest. `nullopt` if it does not tell that.
std::optional<StepsToRead> steps_to_read(const Trace& trace, Pixel pixel, std::size_t nearest);

} // namespace rastertrace
