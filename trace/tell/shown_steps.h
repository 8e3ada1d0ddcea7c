// SPDX-License-Identifier: MIT
#pragma once

// Which steps a frame shows: the one that it is about and those that belong to it.
//
//     const ShownSteps row{n, end_of(trace, n)};  // a scanline with its pixels

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/trace_options.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <array>
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

/// The pixel of a step, if it is about one that the canvas has. That of an `along` is the one that its value is rounded to.
std::optional<Pixel> pixel_of(const Trace& trace, std::size_t n);

/// The pixel of the canvas that is nearest to a point; none if there is none.
std::optional<Pixel> pixel_at(const Trace& trace, const TracedList<TracedNumber>& at);

/// What on the canvas the sentence of a step is about: what figures, pages and terminals mark.
struct StepSubject {
    std::optional<Region> pixels = {}; ///< as far as the canvas has them
    bool is_row = false;               ///< they stand for whole rows
    std::size_t row = 0; ///< the `scanline` or `crossings` that tells the ends of its row; 0: none
    std::size_t primitive = 0; ///< the step of its primitive, which may come after it; 0: none
    std::optional<std::array<std::size_t, 2>> edge = {}; ///< places of two vertices of it

    bool has(Pixel pixel) const {
        return pixels && pixels->has_row(pixel.y) && pixels->meets(pixel.x, pixel.x);
    }
};

/// That of step n, where a replay is or that it has passed since its primitive began; nothing, of step 0.
StepSubject subject_of(const Replay& replay, std::size_t n);

/// True if the fill of triangles tests samples.
bool tests_samples(const Trace& trace);

/// The pixels that steps have tested and not drawn, by their offset on the canvas.
std::set<std::size_t> pixels_not_drawn(const Trace& trace, ShownSteps steps);

} // namespace rastertrace
