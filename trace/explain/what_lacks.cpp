// SPDX-License-Identifier: MIT
// What a trace does not have: steps that were left out, or lost.

#include "explanation.h"

#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

namespace rastertrace {

namespace {

std::string region_text(const Trace& trace) {
    const auto& [x0, y0, x1, y1] = *trace.left_out.region;
    return said("the trace has only what is about x {} to {}, y {} to {}", x0, x1, y0, y1);
}

bool is_in_region(const Trace& trace, const Pixel& pixel) {
    const auto& [x0, y0, x1, y1] = *trace.left_out.region;
    return x0 <= pixel.x && pixel.x <= x1 && y0 <= pixel.y && pixel.y <= y1;
}

} // namespace

std::vector<std::string> what_lacks(const Trace& trace, std::initializer_list<StepKind> kinds,
                                    std::optional<Pixel> pixel) {
    std::vector<std::string> lacks;
    const bool has_depths = !trace.method.word_of("depth").empty();
    for (const StepKind kind : kinds)
        if (trace.lacks(kind) && (kind != StepKind::depth || has_depths))
            lacks.push_back(said("{} steps were left out of the trace", name_of(kind)));
    if (trace.left_out.region && !(pixel && is_in_region(trace, *pixel)))
        lacks.push_back(region_text(trace) + (pixel ? said(": the pixel lies outside") : ""));
    if (!trace.left_out.primitive.empty())
        lacks.push_back(
            said("the trace has only the steps of {}", printable(trace.left_out.primitive)));
    if (!trace.end)
        lacks.push_back(said("the trace is truncated: what came later is not known"));
    return lacks;
}

std::string why_steps_may_lack(const Trace& trace, bool is_last) {
    if (trace.left_out.region)
        return region_text(trace);
    if (!trace.end)
        return is_last ? said("the trace is truncated") : "";
    return trace.damage.empty() ? "" : said("the trace is damaged, and steps of it may be missing");
}

} // namespace rastertrace
