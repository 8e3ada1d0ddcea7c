// SPDX-License-Identifier: MIT
#pragma once

// Why a primitive has not drawn a pixel: the rule that kept it out, with the numbers of the trace.
//
//     why_not(trace, steps, {4, 2}).sentence;  // "AC ends row y=2 at x = 25/8 -> floor -> 3; ..."

#include "explain.h"

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/told_samples.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// The steps of one primitive, and what has been said of some of them.
struct PrimitiveSteps {
    std::size_t first = 0; ///< its own step
    PrimitiveStep told{};  ///< the same
    std::size_t last = 0;
    bool has_drawn = false;             ///< the pixel
    bool has_passed = false;            ///< the depth test in the pixel
    std::string face{};                 ///< the sentence of its facing test
    std::vector<std::string> clips{};   ///< those of the planes that it meets
    std::string skip{};                 ///< why it draws nothing
    std::string hidden{};               ///< the sentence of the depth test that fails in the pixel
    std::string rejected{};             ///< that of pixels dropped, of which the pixel is one
    bool is_whole = false;              ///< clipping cuts it; its parts follow
    std::string may_lack{};             ///< why steps of it may be missing; "" if all are there
    std::vector<std::string> working{}; ///< of its row, or its sample, in the pixel
    const ToldSamples* samples = nullptr; ///< those of the trace
};

/// The first step of a kind among some.
std::optional<StepView> find_step(const Trace& trace, const PrimitiveSteps& steps, StepKind kind);

WhyNot why_not(const Trace& trace, const PrimitiveSteps& steps, Pixel pixel);

/// What rests on a step that is not there cannot be told of a primitive whose steps may be missing.
WhyNot not_told(const PrimitiveSteps& steps, const std::string& sentence);

/// What keeps a filled triangle from a pixel: an edge function, the end of a row, a negative weight (why_outside.cpp).
WhyNot why_outside(const Trace& trace, const PrimitiveSteps& steps, Pixel pixel);

/// Where a point, a line, or the sides of an outline are instead (why_elsewhere.cpp).
WhyNot why_elsewhere(const Trace& trace, const PrimitiveSteps& steps, Pixel pixel);

} // namespace rastertrace
