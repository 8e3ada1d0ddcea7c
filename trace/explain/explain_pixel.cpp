// SPDX-License-Identifier: MIT
// Who has drawn a pixel, and what kept all others out.

#include "explain_pixels.h"
#include "explanation.h"
#include "steps_of_pixel.h"
#include "why_not.h"

#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/tell/working.h>
#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace rastertrace {

namespace {

/// Plays the steps that matter to a pixel once, and notes what each primitive did there.
class PixelStory {
public:
    /// Given the sentences of the steps, by their numbers in the whole trace, it tells neither tries nor workings,
    /// which need a replay.
    PixelStory(const Trace& trace, Pixel pixel, const std::vector<std::string>* sentences = nullptr)
        : trace_(trace), pixel_(pixel), sentences_(sentences) {}

    Explanation tell() {
        for (std::size_t n = 1; n <= trace_.size(); ++n)
            take(n);
        is_at_end_ = true;
        close_part();
        close_primitive();
        explanation_.lacks =
            what_lacks(trace_, {StepKind::primitive, StepKind::pixel, StepKind::depth}, pixel_);
        explanation_.answer = answer();
        return std::move(explanation_);
    }

private:
    void take(std::size_t n) {
        const auto kind = trace_.kind_of(n);
        if (kind == StepKind::primitive)
            begin(n);
        if (PrimitiveSteps* const current = drawing())
            current->last = n;
        if (is_try(n))
            take_try(n);
        else if (primitive_ && kind)
            take_reason(n, *kind);
    }

    /// Parts that clipping has made come between the steps of the primitive that they are parts of.
    void begin(std::size_t n) {
        close_part();
        PrimitiveSteps steps{.first = n, .told = trace_.step(n).as<PrimitiveStep>()};
        if (primitive_ && is_part_of(steps.told, primitive_->told.name.text())) {
            primitive_->is_whole = true;
            part_ = std::move(steps);
            return;
        }
        close_primitive();
        primitive_ = std::move(steps);
        place_ = explanation_.why_not.size();
        part_has_drawn_ = false;
    }

    /// The primitive, or part of one, whose steps these are; null before the first.
    PrimitiveSteps* drawing() { return part_ ? &*part_ : primitive_ ? &*primitive_ : nullptr; }

    /// The replay, at step n. It has a picture as large as the canvas, so most pixels do without it.
    const Replay& replay_to(std::size_t n) {
        if (!replay_)
            replay_.emplace(trace_, FrameParts{.depths = true});
        replay_->go_to(n);
        return *replay_;
    }

    std::string sentence_of(std::size_t n) {
        return sentences_ != nullptr ? (*sentences_)[trace_.number_of(n)]
                                     : describe_step(replay_to(n));
    }

    /// True for a step that tried to write the pixel.
    bool is_try(std::size_t n) const {
        const auto kind = trace_.kind_of(n);
        const bool is_known =
            kind == StepKind::pixel || kind == StepKind::depth || kind == StepKind::reject;
        return is_known && covers(trace_.step(n), pixel_);
    }

    void take_try(std::size_t n) {
        if (trace_.kind_of(n) == StepKind::pixel)
            last_drawn_ = trace_.number_of(n);
        if (sentences_ != nullptr)
            return note_try(n, sentence_of(n));
        const std::string before = shown_at(replay_to(n - 1), pixel_);
        Try one = try_of(replay_to(n));
        one.before = before;
        one.after = shown_at(*replay_, pixel_);
        note_try(n, one.sentence);
        explanation_.tries.push_back(std::move(one));
    }

    /// What has become of the pixel of a primitive.
    void note_try(std::size_t n, const std::string& sentence) {
        if (drawing() == nullptr)
            return;
        PrimitiveSteps& current = *drawing();
        const StepView step = trace_.step(n);
        switch (*trace_.kind_of(n)) {
        case StepKind::pixel:
            if (!std::exchange(current.has_drawn, true))
                painters_.push_back(name_in(trace_.step(current.first)).text());
            break;
        case StepKind::depth:
            if (step.as<DepthStep>().pass.is_false())
                current.hidden = sentence;
            else
                current.has_passed = true;
            break;
        default:
            current.rejected = sentence;
        }
    }

    /// A step that may be why the primitive does not draw the pixel.
    void take_reason(std::size_t n, StepKind kind) {
        const StepView step = trace_.step(n);
        PrimitiveSteps& current = *drawing();
        if (kind == StepKind::face)
            current.face = sentence_of(n);
        if (kind == StepKind::face && step.as<FaceStep>().culled.is_true())
            culled_faces_.push_back({current.first, n});
        if (kind == StepKind::clip)
            named_by(step).clips.push_back(sentence_of(n));
        if (kind == StepKind::skip) {
            const auto why = step.as<SkipStep>().why;
            named_by(step).skip = why.text();
            if (why == SkipReason::culled && current.face.empty())
                current.face = culled_with(vertices_of(current.first));
        }
        const bool is_of_pixel =
            kind == StepKind::scanline ? y_in(step) == pixel_.y : kind == StepKind::sample;
        if (is_of_pixel && sentences_ == nullptr)
            current.working = working_of(replay_to(n));
    }

    std::vector<std::string> vertices_of(std::size_t primitive) const {
        return trace_.step(primitive).as<PrimitiveStep>().vertices.texts();
    }

    /// A line that is a side of faces is culled with them: which, and what their tests say. "" if no face is
    /// known to have it.
    std::string culled_with(std::vector<std::string> ends) {
        for (const auto& [primitive, face] : std::exchange(culled_faces_, {})) {
            std::vector<std::string> corners = vertices_of(primitive);
            std::sort(corners.begin(), corners.end());
            const auto test = trace_.step(face).as<FaceStep>();
            const std::string text =
                said("{} (normal . view = {})", test.name.text(), test.dot.text());
            for (std::size_t from = 0; from < corners.size(); ++from)
                for (std::size_t to = from + 1; to < corners.size(); ++to) {
                    std::string& faces = faces_of_side_[{corners[from], corners[to]}];
                    faces += (faces.empty() ? "" : ", ") + text;
                }
        }
        std::sort(ends.begin(), ends.end());
        const auto found =
            ends.size() == 2 ? faces_of_side_.find({ends[0], ends[1]}) : faces_of_side_.end();
        return found == faces_of_side_.end() ? "" : said("culled with {}", found->second);
    }

    /// The primitive that a clip or skip step is about: that of an outline may come after its first part.
    PrimitiveSteps& named_by(const StepView& step) {
        const bool is_of_whole =
            name_in(step).text() == name_in(trace_.step(primitive_->first)).text();
        return is_of_whole ? *primitive_ : *drawing();
    }

    /// The part has come to its end: if it did not draw the pixel, why not?
    void close_part() {
        if (!part_)
            return;
        part_has_drawn_ = part_has_drawn_ || part_->has_drawn;
        if (!part_->has_drawn)
            explanation_.why_not.push_back(why_not_of(*part_));
        part_.reset();
    }

    /// The same of a primitive with all its parts, of which one may have drawn the pixel. It is told before them.
    void close_primitive() {
        if (!primitive_)
            return;
        const bool has_place{primitive_->told.at};
        primitive_->is_whole = primitive_->is_whole || (!has_place && !primitive_->clips.empty());
        if (!primitive_->has_drawn && !part_has_drawn_)
            explanation_.why_not.insert(explanation_.why_not.begin() +
                                            static_cast<std::ptrdiff_t>(place_),
                                        why_not_of(*primitive_));
        primitive_.reset();
    }

    WhyNot why_not_of(PrimitiveSteps& steps) {
        steps.samples = &samples_;
        steps.may_lack = why_steps_may_lack(trace_, is_at_end_);
        WhyNot why = why_not(trace_, steps, pixel_);
        const bool only_hides = why.reason == "unpainted" && steps.has_passed;
        if (only_hides || why.reason == "hidden" || why.reason == "rejected")
            covering_.push_back(why);
        return why;
    }

    std::string answer() const {
        if (!painters_.empty() || last_drawn_ != 0)
            return answer_of_drawn();
        const auto& why_not = explanation_.why_not;
        if (!explanation_.lacks.empty())
            return said("no step of the trace draws it, but not all steps are there");
        if (why_not.empty())
            return said("not drawn: there is no primitive");
        if (!covering_.empty())
            return answer_of_covered();
        return why_not.size() == 1 ? said("not drawn: {}", in_words(why_not.front()))
                                   : said("not drawn by any of {} primitives", why_not.size());
    }

    /// Of a pixel that primitives cover, none of which has drawn it.
    std::string answer_of_covered() const {
        const bool all_fail = std::all_of(covering_.begin(), covering_.end(),
                                          [](const WhyNot& why) { return why.reason == "hidden"; });
        if (all_fail)
            return said("not drawn: every primitive that covers it fails the depth test");
        constexpr std::size_t most_named = 3;
        std::vector<std::string> named;
        for (const WhyNot& why : covering_)
            if (named.size() < most_named)
                named.push_back(in_words(why));
        const std::size_t rest = covering_.size() - named.size();
        return said("not drawn: {}{}", joined(named, ", "),
                    rest > 0 ? said(", and {} more", rest) : "");
    }

    std::string answer_of_drawn() const {
        if (painters_.empty())
            return said("drawn at step {}", last_drawn_);
        std::string text = said("drawn by {} at step {}", printable(painters_.back()), last_drawn_);
        std::vector<std::string> before(painters_.begin(), painters_.end() - 1);
        std::reverse(before.begin(), before.end());
        if (!before.empty())
            text += said(", over {}", printable(joined(before, ", ")));
        return text;
    }

    static std::string in_words(const WhyNot& why) {
        const std::string name = printable(why.primitive);
        return why.reason == "elsewhere" ? said("{} is elsewhere", name)
               : why.reason == "outside" ? said("{} does not cover it", name)
               : why.reason == "unknown" ? said("{} does not draw it", name)
               : why.reason == "unpainted"
                   ? said("{} is not painted", name)
                   : said("{} is {}", name, in_language_of_steps(why.reason));
    }

    const Trace& trace_;
    Pixel pixel_;
    ToldSamples samples_ = told_samples(trace_);
    const std::vector<std::string>* sentences_;
    std::optional<Replay> replay_;
    Explanation explanation_;
    std::optional<PrimitiveSteps> primitive_;
    std::optional<PrimitiveSteps> part_; ///< of the primitive, made by clipping
    std::size_t place_ = 0;              ///< in why_not: that of the primitive, before its parts
    bool part_has_drawn_ = false;
    bool is_at_end_ = false;
    struct CulledFace {
        std::size_t primitive; ///< its step
        std::size_t face;      ///< that of the test
    };
    std::vector<CulledFace> culled_faces_; ///< that are not in faces_of_side_ yet
    std::map<std::pair<std::string, std::string>, std::string> faces_of_side_; ///< of culled ones
    std::vector<WhyNot> covering_;      ///< those that reach the pixel and have not drawn it
    std::vector<std::string> painters_; ///< who has drawn the pixel, first to last
    std::size_t last_drawn_ = 0;        ///< the step that did
};

/// The steps that matter to a pixel.
Trace steps_about(const Trace& trace, Pixel pixel) {
    StepsOfPixel chosen(trace, pixel);
    for (std::size_t n = 1; n <= trace.size(); ++n)
        chosen.take(n);
    Trace excerpt = std::move(chosen).finish();
    excerpt.damage = trace.damage;
    return excerpt;
}

/// The trace without what is about pixels of fills in other rows.
Trace steps_about_row(const Trace& trace, int y) {
    Trace excerpt = trace.without_steps();
    excerpt.damage = trace.damage;
    bool is_fill = false;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const StepView step = trace.step(n);
        const auto kind = trace.kind_of(n);
        if (kind == StepKind::primitive)
            is_fill = is_filled(step.as<PrimitiveStep>().kind);
        const bool is_of_pixel =
            kind == StepKind::pixel || kind == StepKind::depth || kind == StepKind::sample;
        if (!is_fill || !is_of_pixel || y_in(step) == y)
            excerpt.add_to_excerpt(trace.number_of(n));
    }
    return excerpt;
}

/// True if what is said of a pixel that is not drawn may quote such a step.
bool may_be_quoted(StepKind kind) {
    return kind == StepKind::face || kind == StepKind::clip || kind == StepKind::depth ||
           kind == StepKind::reject;
}

} // namespace

Explanation explain_pixel(const Trace& trace, const Question& question) {
    const Trace excerpt = steps_about(trace, question.pixel);
    return PixelStory(excerpt, question.pixel).tell();
}

PixelExplainer::PixelExplainer(const Trace& trace) : trace_(trace) {
    sentences_.resize(trace.size() == 0 ? 0 : trace.number_of(trace.size()) + 1);
    Replay replay(trace, {.depths = true});
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (!kind || !may_be_quoted(*kind))
            continue;
        replay.go_to(n);
        sentences_[trace.number_of(n)] = describe_step(replay);
    }
}

Explanation PixelExplainer::explain(Pixel pixel) {
    if (!row_ || y_ != pixel.y)
        row_ = steps_about_row(trace_, pixel.y);
    y_ = pixel.y;
    const Trace excerpt = steps_about(*row_, pixel);
    return PixelStory(excerpt, pixel, &sentences_).tell();
}

} // namespace rastertrace
