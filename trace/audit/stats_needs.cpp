// SPDX-License-Identifier: MIT
#include "stats_needs.h"

#include "positions.h"

#include <rastertrace/trace/text/primitive_name.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// "a triangle, ... or point".
std::string kinds_of_primitives() {
    std::vector<std::string_view> names;
    for (const PrimitiveKind kind : all_primitives)
        names.push_back(name_of(kind));
    const std::string_view last = names.back();
    names.pop_back();
    return fmt::format("a {} or {}", joined(names, ", "), last);
}

} // namespace

void StatsNeeds::begin(const PrimitiveStep& step, std::size_t number) {
    close();
    primitive_ = {.is_begun = true, .corners = positions_in(step, header_)};
    const auto called = [&step, number] {
        return fmt::format("{} {} (step {})", printable(step.kind.text()),
                           printable(step.name.text()), number);
    };
    // Of the kinds that are known, triangles alone are judged by their corners.
    const bool is_other = step.kind != PrimitiveKind::triangle && traits_of(step.kind);
    primitive_.is_judged = !is_other && !step.painted.is_false();
    if (step.kind != PrimitiveKind::triangle)
        primitive_.lacks = "expected " + kinds_of_primitives() + ", found " + called();
    else if (!primitive_.corners)
        primitive_.lacks =
            fmt::format(R"(expected "at", three pairs of numbers, of {}, found {})", called(),
                        shortened(printable(step.at ? step.at.json() : "none"), 40));
}

void StatsNeeds::add(StepKind kind, std::size_t number) {
    switch (kind) {
    case StepKind::skip:
    case StepKind::clip:
        primitive_.is_undrawn = true;
        break;
    case StepKind::scanline:
    case StepKind::sample:
    case StepKind::ray:
        primitive_.tells_its_pixels = true;
        break;
    case StepKind::pixel:
    case StepKind::depth:
        if (primitive_.first_pixel == 0)
            primitive_.first_pixel = number;
        break;
    default:
        break;
    }
}

void StatsNeeds::close() {
    const Primitive primitive = std::exchange(primitive_, {});
    if (!primitive.is_judged)
        return;
    const bool has_pixels = primitive.first_pixel != 0;
    std::string lacks = primitive.lacks;
    if (!primitive.is_begun && has_pixels)
        lacks = fmt::format(R"(expected a "primitive" in front of step {}, found none)",
                            primitive.first_pixel);
    if (lacks_of_corners_.empty() && (has_pixels || !primitive.is_undrawn))
        lacks_of_corners_ = lacks;
    if (lacks_of_rows_.empty() && has_pixels && !primitive.tells_its_pixels)
        lacks_of_rows_ = fmt::format(R"(expected a "scanline" in front of step {}, found none)",
                                     primitive.first_pixel);
}

std::vector<Unjudged> StatsNeeds::unjudged() const {
    if (header_.is_partial)
        return {{{stats_findings.begin(), stats_findings.end()},
                 "expected a trace with all its steps, found one that steps were left out of"}};
    std::vector<Unjudged> all;
    if (!lacks_of_corners_.empty())
        all.push_back(
            {{StatsFinding::holes, StatsFinding::twice, StatsFinding::outside}, lacks_of_corners_});
    if (!lacks_of_rows_.empty())
        all.push_back({{StatsFinding::rows}, lacks_of_rows_});
    return all;
}

} // namespace rastertrace
