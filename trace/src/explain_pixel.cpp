// SPDX-License-Identifier: MIT
// Who has drawn a pixel, and what kept all others out.

#include "explanation.h"
#include "step_text.h"
#include "why_not.h"

#include <rastertrace/trace/describe.h>
#include <rastertrace/trace/steps_of_pixel.h>
#include <rastertrace/trace/text.h>
#include <rastertrace/trace/working.h>

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace rastertrace {

namespace {

/// Plays the steps that matter to a pixel once, and notes what each primitive did there.
class PixelStory {
public:
    PixelStory(const Trace& trace, Pixel pixel) : trace_(trace), pixel_(pixel) {}

    Explanation tell() {
        for (std::size_t n = 1; n <= trace_.size(); ++n)
            take(n);
        close_primitive();
        tell_what_lacks();
        explanation_.answer = answer();
        return std::move(explanation_);
    }

private:
    void take(std::size_t n) {
        const auto kind = trace_.kind_of(n);
        if (kind == StepKind::primitive)
            close_primitive();
        if (kind == StepKind::primitive)
            current_ = PrimitiveSteps{.first = n};
        if (current_)
            current_->last = n;
        if (is_try(n))
            take_try(n);
        else if (current_ && kind)
            take_reason(n, *kind);
    }

    /// The replay, at step n. It has a picture as large as the canvas, so most pixels do without it.
    const Replay& replay_to(std::size_t n) {
        if (!replay_)
            replay_.emplace(trace_, FrameParts{.depths = true});
        replay_->go_to(n);
        return *replay_;
    }

    /// True for a step that tried to write the pixel.
    bool is_try(std::size_t n) const {
        const auto kind = trace_.kind_of(n);
        const bool is_known =
            kind == StepKind::pixel || kind == StepKind::depth || kind == StepKind::reject;
        return is_known && covers(trace_.step(n), pixel_);
    }

    void take_try(std::size_t n) {
        const std::string before = shown_at(replay_to(n - 1), pixel_);
        Try one = try_of(replay_to(n));
        one.before = before;
        one.after = shown_at(*replay_, pixel_);
        const auto kind = trace_.kind_of(n);
        if (kind == StepKind::pixel)
            last_drawn_ = one.number;
        if (current_ && kind == StepKind::pixel)
            current_->has_drawn = true;
        if (current_ && kind == StepKind::depth && trace_.step(n).text("pass") == "false")
            current_->hidden = one.sentence;
        if (current_ && kind == StepKind::reject)
            current_->rejected = one.sentence;
        explanation_.tries.push_back(std::move(one));
    }

    /// A step that may be why the primitive does not draw the pixel.
    void take_reason(std::size_t n, StepKind kind) {
        const StepView step = trace_.step(n);
        if (kind == StepKind::face)
            current_->face = describe_step(replay_to(n));
        if (kind == StepKind::clip)
            current_->clips.push_back(describe_step(replay_to(n)));
        if (kind == StepKind::skip)
            current_->skip = step.text("why");
        const bool is_of_pixel =
            kind == StepKind::scanline ? step.whole("y") == pixel_.y : kind == StepKind::sample;
        if (is_of_pixel)
            current_->working = working_of(replay_to(n));
    }

    /// The primitive has come to its end: if it did not draw the pixel, why not?
    void close_primitive() {
        if (!current_)
            return;
        const StepView step = trace_.step(current_->first);
        const bool is_part = step.text("part") == "true";
        current_->is_whole = !step.field("at") && !current_->clips.empty();
        if (current_->has_drawn) {
            painters_.push_back(step.text("name"));
            if (is_part && whole_)
                explanation_.why_not.erase(explanation_.why_not.begin() +
                                           static_cast<std::ptrdiff_t>(*std::exchange(whole_, {})));
        } else {
            if (!is_part)
                whole_.reset();
            if (current_->is_whole && current_->skip.empty())
                whole_ = explanation_.why_not.size();
            explanation_.why_not.push_back(why_not(trace_, *current_, pixel_));
        }
        current_.reset();
    }

    void tell_what_lacks() {
        auto& lacks = explanation_.lacks;
        const bool has_depths = !trace_.method_value("depth").empty();
        for (const StepKind kind : {StepKind::primitive, StepKind::pixel, StepKind::depth})
            if (trace_.lacks(kind) && (kind != StepKind::depth || has_depths))
                lacks.push_back(fmt::format("{} steps were left out of the trace", name_of(kind)));
        if (const auto& region = trace_.left_out.region) {
            const auto& [x0, y0, x1, y1] = *region;
            const bool is_in_region =
                x0 <= pixel_.x && pixel_.x <= x1 && y0 <= pixel_.y && pixel_.y <= y1;
            if (!is_in_region)
                lacks.push_back(fmt::format("the trace has only what is about x {} to {}, y {} to "
                                            "{}: the pixel lies outside",
                                            x0, x1, y0, y1));
        }
        if (!trace_.left_out.primitive.empty())
            lacks.push_back(fmt::format("the trace has only the steps of {}",
                                        printable(trace_.left_out.primitive)));
        if (!trace_.end)
            lacks.emplace_back("the trace is truncated: what came later is not known");
    }

    std::string answer() const {
        if (!painters_.empty() || last_drawn_ != 0)
            return answer_of_drawn();
        const auto& why_not = explanation_.why_not;
        const auto count_of = [&why_not](std::string_view reason) {
            return std::count_if(why_not.begin(), why_not.end(),
                                 [reason](const WhyNot& one) { return one.reason == reason; });
        };
        if (!explanation_.lacks.empty())
            return "no step of the trace draws it, but not all steps are there";
        if (why_not.empty())
            return "not drawn: there is no primitive";
        if (count_of("hidden") != 0)
            return "not drawn: every primitive that covers it fails the depth test";
        return why_not.size() == 1
                   ? fmt::format("not drawn: {}", in_words(why_not.front()))
                   : fmt::format("not drawn by any of {} primitives", why_not.size());
    }

    std::string answer_of_drawn() const {
        if (painters_.empty())
            return fmt::format("drawn at step {}", last_drawn_);
        std::string text =
            fmt::format("drawn by {} at step {}", printable(painters_.back()), last_drawn_);
        std::vector<std::string> before(painters_.begin(), painters_.end() - 1);
        std::reverse(before.begin(), before.end());
        if (!before.empty())
            text += fmt::format(", over {}", printable(joined(before, ", ")));
        return text;
    }

    static std::string in_words(const WhyNot& why) {
        return fmt::format("{} {}", printable(why.primitive),
                           why.reason == "elsewhere" ? std::string("is elsewhere")
                           : why.reason == "outside" ? std::string("does not cover it")
                           : why.reason == "unknown" ? std::string("does not draw it")
                                                     : "is " + why.reason);
    }

    const Trace& trace_;
    Pixel pixel_;
    std::optional<Replay> replay_;
    Explanation explanation_;
    std::optional<PrimitiveSteps> current_;
    std::optional<std::size_t> whole_;  ///< in why_not: the primitive that the parts belong to
    std::vector<std::string> painters_; ///< who has drawn the pixel, first to last
    std::size_t last_drawn_ = 0;        ///< the step that did
};

} // namespace

Explanation explain_pixel(const Trace& trace, Pixel pixel) {
    StepsOfPixel chosen(trace, pixel);
    for (std::size_t n = 1; n <= trace.size(); ++n)
        chosen.take(trace.step(n), trace.kind_of(n), trace.number_of(n));
    const Trace excerpt = std::move(chosen).finish();
    return PixelStory(excerpt, pixel).tell();
}

} // namespace rastertrace
