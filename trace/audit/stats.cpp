// SPDX-License-Identifier: MIT
#include "stats.h"

#include "coverage.h"
#include "row_check.h"
#include "stats_needs.h"

#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/record/step_decoder.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/in_threads.h>
#include <rastertrace/trace/text/text.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

namespace {

/// Counts steps by their kind. A trace may hold as many kinds as it has steps.
class KindCounts {
public:
    explicit KindCounts(Stats& stats) : count_(stats.count) {}

    void add(std::optional<StepKind> kind, const StepView& step) {
        if (!kind)
            return add(places_.try_emplace(step.kind_name(), 0).first->second, step);
        add(known_[static_cast<std::size_t>(*kind)], step);
    }

private:
    /// `place` of a kind in count_, from 1; 0 as long as it has none.
    void add(std::size_t& place, const StepView& step) {
        if (place == 0) {
            count_.emplace_back(step.kind_name(), 0);
            place = count_.size();
        }
        ++count_[place - 1].second;
    }

    std::vector<std::pair<std::string, std::uint64_t>>& count_;
    std::array<std::size_t, step_kinds> known_{};
    std::unordered_map<std::string, std::size_t> places_; ///< of the other kinds
};

/// The pixel that a step is about, if the canvas has it.
std::optional<Pixel> pixel_of(const auto& step, const Canvas& canvas) {
    if (!canvas.contains(step.x, step.y))
        return std::nullopt;
    return Pixel{static_cast<int>(step.x), static_cast<int>(step.y)};
}

/// Watches depth tests for ties that decide what is seen.
class DepthTies {
public:
    explicit DepthTies(const Canvas& canvas)
        : canvas_(canvas), is_tied_(static_cast<std::size_t>(canvas.width) *
                                    static_cast<std::size_t>(canvas.height)) {}

    /// Takes a depth step and the color of its primitive.
    void add(const DepthStep& test, Color color, const Frame& frame) {
        const auto pixel = pixel_of(test, canvas_);
        if (!pixel)
            return;
        const std::size_t place = canvas_.offset_of(*pixel);
        if (test.pass.is_true())
            is_tied_[place] = false;
        else if (frame.drawn_by[place] != 0 && test.depth.text() == test.stored.text() &&
                 frame.image.at(*pixel) != color)
            is_tied_[place] = true;
    }

    PixelList found() const {
        PixelList ties;
        for (int row = 0; row < canvas_.height; ++row)
            for (int x = canvas_.left(); x <= canvas_.right(); ++x) {
                const Pixel pixel{x, canvas_.y_of(row)};
                if (!is_tied_[canvas_.offset_of(pixel)])
                    continue;
                if (++ties.count <= most_pixels_kept)
                    ties.kept.push_back(pixel);
            }
        return ties;
    }

private:
    Canvas canvas_;
    std::vector<bool> is_tied_;
};

/// Takes the steps of a trace, one after the other: counts them, and notes what each primitive draws.
class StepsCounted {
public:
    StepsCounted(const Trace& trace, Stats& stats)
        : trace_(trace), stats_(stats), kinds_(stats), ties_(trace.canvas), rows_(stats.wrong_rows),
          needs_(trace), state_(trace.canvas) {}

    void take(std::size_t n) {
        const StepView step = trace_.step(n);
        const auto kind = trace_.kind_of(n);
        needs_.add(step, kind, n);
        kinds_.add(kind, step);
        if (!kind) {
            state_.take(step, kind);
            if (!trace_.is_partial && is_painted_)
                rows_.close();
            return;
        }
        const AnyStep any = any_step(step, *kind);
        std::visit([this](const auto& told) { count(told); }, any);
        if (!trace_.is_partial && (is_painted_ || kind == StepKind::primitive))
            rows_.add(any, n, stats_.primitives.empty() ? "" : stats_.primitives.back().name);
    }

    /// Behind the last step: what the primitives drew, and what is known of the whole.
    std::vector<DrawnPrimitive> finish() {
        needs_.close();
        stats_.unjudged = needs_.unjudged();
        for (std::size_t i = 0; i < drawn_.size(); ++i) {
            keep_each_once(drawn_[i]);
            stats_.primitives[i].pixels = drawn_[i].pixels.size();
            stats_.primitives[i].hidden = drawn_[i].covering().size() - drawn_[i].pixels.size();
        }
        if (trace_.end)
            rows_.close();
        stats_.depth_ties = ties_.found();
        return std::move(drawn_);
    }

    const Image& picture() const { return state_.frame().image; }

private:
    void count(const PrimitiveStep& begun) {
        state_.take_primitive(color_of_primitive(begun));
        PrimitiveStats& primitive = stats_.primitives.emplace_back();
        primitive.kind = begun.kind.text();
        primitive.name = begun.name.text();
        is_painted_ = !begun.painted.is_false();
        drawn_.push_back({.step = state_.step(), .pixels = {}, .covered = {}});
    }

    void count(const SkipStep& skip) {
        state_.take(StepKind::skip);
        if (!stats_.primitives.empty())
            stats_.primitives.back().skipped = skip.why.text();
    }

    void count(const PixelStep& step) {
        const auto plotted = plotted_by(step, trace_.canvas, state_.color());
        if (!plotted)
            return state_.take(StepKind::pixel);
        state_.take_pixel(plotted->pixel, plotted->color);
        ++stats_.writes;
        if (stats_.primitives.empty())
            return;
        ++stats_.primitives.back().writes;
        stats_.primitives.back().over += state_.drew_over() != 0 ? 1 : 0;
        add_pixel(drawn_.back(), trace_.canvas.offset_of(plotted->pixel));
    }

    void count(const DepthStep& test) {
        state_.take(StepKind::depth);
        ties_.add(test, state_.color(), state_.frame());
        const auto pixel = pixel_of(test, trace_.canvas);
        if (!test.pass.is_true() && !drawn_.empty() && pixel)
            add_hidden_pixel(drawn_.back(), trace_.canvas.offset_of(*pixel));
    }

    template <typename Step> void count(const Step& /*other*/) { state_.take(Step::step_kind); }

    const Trace& trace_;
    Stats& stats_;
    KindCounts kinds_;
    DepthTies ties_;
    RowCheck rows_;
    StatsNeeds needs_;
    ReplayState state_;
    std::vector<DrawnPrimitive> drawn_;
    bool is_painted_ = true; ///< the current primitive
};

} // namespace

std::string_view name_of(StatsFinding finding) {
    switch (finding) {
    case StatsFinding::holes:
        return "holes";
    case StatsFinding::twice:
        return "twice";
    case StatsFinding::outside:
        return "outside";
    case StatsFinding::rows:
        return "rows";
    case StatsFinding::redo:
        break;
    }
    return "redo";
}

std::string names_of(const std::vector<StatsFinding>& findings) {
    std::vector<std::string_view> names;
    for (const StatsFinding finding : findings)
        names.push_back(name_of(finding));
    return joined(names, ", ");
}

Stats stats_of(const Trace& trace, std::size_t jobs) {
    // Step by step, what is drawn and by which primitive.
    Stats stats;
    stats.steps = trace.size();
    StepsCounted counted(trace, stats);
    constexpr std::size_t most_remembered = 1U << 20U; // steps
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        counted.take(n);
        if (n % most_remembered == 0)
            trace.forget_text();
    }

    // Against what should have been drawn, where all of that can be there.
    std::vector<DrawnPrimitive> drawn = counted.finish();
    if (!trace.end && !drawn.empty())
        drawn.pop_back();
    if (!trace.is_partial)
        compare_with_corners(trace, drawn, jobs == 0 ? usual_jobs() : jobs, stats);

    // The picture that came of it.
    const Image& picture = counted.picture();
    stats.canvas = picture.colors().size();
    stats.pixels = picture.drawn();
    stats.frame = frame_name(picture);
    const bool is_comparable = trace.end && !trace.end->frame.empty() && !trace.is_partial;
    stats.frame_differs = is_comparable && trace.end->frame != stats.frame;
    return stats;
}

} // namespace rastertrace
