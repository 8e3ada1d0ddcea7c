// SPDX-License-Identifier: MIT
#pragma once

// Lines that hold steps as StepWriter writes them, decoded for what a replay needs of them. A part of a text needs no
// other part, so several are scanned at once; what came of them is then taken in order.
//
//     const auto lines = scan_lines(text, begin, end, {.canvas = canvas});
//     places.add_lines(lines.measured);
//     lines.play(state);

#include "frame.h"
#include "step_counts.h"
#include "step_places.h"

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

struct ScannedLines {
    MeasuredLines measured; ///< those that were taken: one step each
    bool is_whole = true;   ///< none was left
    StepCounts counts = {};

    /// The first pixel that the canvas has not.
    struct StrayPixel {
        std::size_t offset; ///< of its step
        Index x;
        Index y;
    };
    std::optional<StrayPixel> stray = {};

    /// A step that changes more of a replay than its number.
    struct Change {
        std::uint32_t step; ///< from 0
        StepKind kind;
        bool is_so; ///< a pixel has a color of its own; a depth is stored
        Color color;
        Pixel pixel;
    };
    std::vector<Change> changes = {};

    /// Takes all steps.
    void play(ReplayState& state) const;
};

/// What the lines of a text are scanned for.
struct LineScan {
    Canvas canvas{};
    bool is_document = false; ///< a comma may stand behind a step
    bool has_changes = true;  ///< for a replay
};

/// Scans lines of a text from `begin`, where one begins, as far as each holds a step as StepWriter writes it; the last
/// one begins before `end`.
ScannedLines scan_lines(std::string_view text, std::size_t begin, std::size_t end,
                        const LineScan& scan);

/// The same in parts of so many bytes, each up to the end of a line, and in so many threads.
std::vector<ScannedLines> scan_parts(std::string_view text, std::size_t begin, std::size_t end,
                                     std::size_t part, std::size_t jobs, const LineScan& scan);

} // namespace rastertrace
