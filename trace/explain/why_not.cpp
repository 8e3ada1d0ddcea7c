// SPDX-License-Identifier: MIT
#include "why_not.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// Clipping left nothing of a primitive that is skipped for one of these.
constexpr std::array<std::string_view, 4> clipped_away{"behind the eye", "too near", "too far",
                                                       "outside the view"};

/// culled, clipped or skipped: the reason (WhyNot) of a primitive that is skipped for one.
std::string_view reason_of_skip(std::string_view why) {
    const bool is_clipped = std::count(clipped_away.begin(), clipped_away.end(), why) > 0;
    return why == "culled" ? "culled" : is_clipped ? "clipped" : "skipped";
}

/// Where its corners are: `A (2, 5)   B (-4, -3)`.
std::string corners_text(const PrimitiveText& primitive) {
    std::vector<std::string> corners;
    for (std::size_t i = 0; i < primitive.positions.size() && i < primitive.vertices.size(); ++i)
        corners.push_back(
            fmt::format("{} {}", primitive.vertices[i], point(primitive.positions[i])));
    return joined(corners, ", ");
}

/// A primitive that a `skip` step says nothing is drawn of.
WhyNot why_skipped(const Trace& trace, const PrimitiveSteps& steps) {
    const std::string reason(reason_of_skip(steps.skip));
    if (reason == "culled")
        return {.reason = reason,
                .sentence = steps.face.empty()
                                ? said("culled; the trace has no face step, which would say why")
                                : steps.face};
    if (reason == "clipped")
        return {.reason = reason,
                .sentence = fmt::format("{}: {}", in_language_of_steps(steps.skip),
                                        steps.clips.empty()
                                            ? said("all of it lies outside one plane of the view")
                                            : joined(steps.clips, "; "))};
    const std::string why(in_language_of_steps(steps.skip));
    const std::string corners = corners_text(primitive_in(trace.step(steps.first)));
    return {.reason = reason,
            .sentence = corners.empty() ? why : fmt::format("{}: {}", why, corners)};
}

/// A primitive that clipping has cut into parts, none of which has drawn the pixel.
WhyNot why_clipped(const PrimitiveSteps& steps) {
    const std::string clips =
        steps.clips.empty() ? said("cut by a plane of the view") : joined(steps.clips, "; ");
    if (!steps.may_lack.empty())
        return not_told(steps, clips);
    return {.reason = "clipped", .sentence = said("{}; no part that is left has the pixel", clips)};
}

} // namespace

WhyNot not_told(const PrimitiveSteps& steps, const std::string& sentence) {
    return {.reason = "unknown", .sentence = fmt::format("{}; {}", sentence, steps.may_lack)};
}

std::optional<StepView> find_step(const Trace& trace, const PrimitiveSteps& steps, StepKind kind) {
    for (std::size_t n = steps.first; n <= steps.last; ++n)
        if (trace.kind_of(n) == kind)
            return trace.step(n);
    return std::nullopt;
}

WhyNot why_not(const Trace& trace, const PrimitiveSteps& steps, Pixel pixel) {
    const PrimitiveStep& primitive = steps.told;
    WhyNot why;
    if (!steps.skip.empty())
        why = why_skipped(trace, steps);
    else if (steps.is_whole)
        why = why_clipped(steps);
    else if (!steps.hidden.empty())
        why = {.reason = "hidden", .sentence = steps.hidden};
    else if (!steps.rejected.empty())
        why = {.reason = "rejected", .sentence = steps.rejected};
    else if (is_filled(primitive.kind))
        why = why_outside(trace, steps, pixel);
    else
        why = why_elsewhere(trace, steps, pixel);
    why.primitive = primitive.name.text();
    why.sentence = printable(why.sentence);
    return why;
}

} // namespace rastertrace
