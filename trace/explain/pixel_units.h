// SPDX-License-Identifier: MIT
#pragma once

// What questions about a pixel need of a trace, from its index or by going through it: which primitives reach the pixel,
// and how far away the others are.
//
//     write_index(trace, contents_of(trace).known, "a.jsonl.index");

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/trace_index.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Their names in WhyNot.
inline constexpr std::array<std::string_view, far_reasons> far_reason_names{
    "outside", "unpainted", "culled", "clipped", "skipped", "unknown"};

/// What going through a trace gives.
struct TraceContents {
    PixelUnits known{};
    std::vector<std::uint32_t> primitives{}; ///< steps
    std::vector<std::uint32_t> loose{};      ///< steps that belong to no primitive (is_loose)
    std::vector<std::uint32_t> vertices{};   ///< `vertex` steps
};

/// In so many threads, each with parts of at least so many steps; 0: as many as run at once. Nothing is known of a trace
/// that lacks steps, or has some that are not written as StepWriter writes them.
TraceContents contents_of(const Trace& trace, std::size_t jobs = 0,
                          std::size_t steps_in_part = 1 << 14);

/// What is needed of a trace to tell of a pixel and of the primitives nearest to it.
struct StepsToRead {
    std::vector<std::size_t> steps{}; ///< by number, in order
    std::map<std::string, std::size_t>
        others{}; ///< primitives farther away: how many of each reason (WhyNot)
};

/// For at least so many of the nearest. `nullopt` if neither an index nor the trace as rastertrace writes it tells that.
std::optional<StepsToRead> steps_to_read(const Trace& trace, Pixel pixel, std::size_t nearest,
                                         std::size_t jobs = 0);

} // namespace rastertrace
