// SPDX-License-Identifier: MIT
#include "stats.h"

#include "coverage.h"
#include "trace_counts.h"

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/text.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

std::string names_of(const std::vector<StatsFinding>& findings) {
    std::vector<std::string_view> names;
    for (const StatsFinding finding : findings)
        names.push_back(finding_names[static_cast<std::size_t>(finding)]);
    return joined(names, ", ");
}

Stats stats_of(const Trace& trace) {
    Stats stats;
    stats.steps = trace.size();
    TraceCounts counts(trace, stats);
    for (std::size_t n = 1; n <= trace.size(); ++n)
        counts.take(n);
    counts.finish();

    // Against what should have been drawn, where all of that can be there.
    std::vector<DrawnPrimitive>& drawn = counts.drawn();
    if (!trace.end && !drawn.empty())
        drawn.pop_back();
    if (!trace.is_partial)
        compare_with_corners(trace, drawn, stats);

    // The picture that came of it.
    const Image& picture = counts.picture();
    stats.canvas = picture.colors().size();
    stats.pixels = picture.drawn();
    stats.frame = frame_name(picture);
    const bool is_comparable = trace.end && !trace.end->frame.empty() && !trace.is_partial;
    stats.frame_differs = is_comparable && trace.end->frame != stats.frame;
    return stats;
}

} // namespace rastertrace
