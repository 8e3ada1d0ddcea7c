// SPDX-License-Identifier: MIT
#pragma once

// Which steps a frame shows: the one that it is about and those that belong to it.
//
//     const ShownSteps row{n, end_of(trace, n)};  // a scanline with its pixels

#include <rastertrace/trace/record/trace.h>

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rastertrace {

/// The step that a frame is about, and the last one whose pixels it has; 0 is before the first.
struct ShownSteps {
    std::size_t first = 0;
    std::size_t last = 0;

    bool has(std::size_t step) const { return first <= step && step <= last; }
};

/// Which steps of how many a frame shows: "step 14 of 62", "steps 14 to 19 of 62".
std::string steps_text(const Trace& trace, ShownSteps steps);

/// The last step that belongs to step n: a primitive has all steps up to the next one, a scanline or a decision
/// its pixels, an edge only itself.
std::size_t end_of(const Trace& trace, std::size_t n);

/// The frames of a film: each vertex that enters a space; each row of a fill, or line of the fan,
/// with its pixels; each pixel of a line, an outline or a point. At most one more than `most`.
std::vector<ShownSteps> film_of(const Trace& trace, std::size_t most);

/// The pixel of a step, if it has one that the canvas has.
std::optional<Pixel> pixel_of(const Trace& trace, std::size_t n);

/// True if the fill of triangles tests samples.
bool tests_samples(const Trace& trace);

/// The pixels that steps have tested and not drawn, by their offset on the canvas.
std::set<std::size_t> pixels_not_drawn(const Trace& trace, ShownSteps steps);

} // namespace rastertrace
