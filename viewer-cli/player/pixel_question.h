// SPDX-License-Identifier: MIT
#pragma once

// Who drew a pixel, asked of a trace that may have millions of steps: piece by piece, so that keys are heard meanwhile.
//
//     PixelQuestion question(trace, {4, 2});
//     while (!question.answer()) question.look_on(100'000);

#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/explain/steps_of_pixel.h>
#include <rastertrace/trace/record/trace.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace rastertrace {

class PixelQuestion {
public:
    PixelQuestion(const Trace& trace, Pixel pixel)
        : trace_(&trace), pixel_(pixel), steps_(trace, pixel) {}

    Pixel pixel() const { return pixel_; }

    /// Looks at so many steps more; behind the last one the answer is known. False if it was.
    bool look_on(std::size_t steps) {
        if (answer_)
            return false;
        const std::size_t last = std::min(trace_->size(), looked_at_ + steps);
        while (looked_at_ < last)
            steps_.take(++looked_at_);
        if (looked_at_ < trace_->size())
            return true;
        Trace excerpt = std::move(steps_).finish();
        excerpt.damage = trace_->damage;
        excerpt.end = trace_->end;
        answer_ = explain(excerpt, {.about = Topic::pixel, .pixel = pixel_});
        return true;
    }

    /// What part of the trace has been looked at, from 0 to 1.
    double share() const {
        return trace_->size() == 0
                   ? 0
                   : static_cast<double>(looked_at_) / static_cast<double>(trace_->size());
    }

    /// The answer, or why there is none, once it is known.
    const std::optional<Result<Explanation>>& answer() const { return answer_; }

private:
    const Trace* trace_;
    Pixel pixel_;
    StepsOfPixel steps_;
    std::size_t looked_at_ = 0;
    std::optional<Result<Explanation>> answer_;
};

} // namespace rastertrace
