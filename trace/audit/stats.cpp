// SPDX-License-Identifier: MIT
#include "stats.h"

#include "coverage.h"
#include "row_check.h"
#include "stats_needs.h"

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/text.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rastertrace {

std::string names_of(const std::vector<StatsFinding>& findings) {
    std::vector<std::string_view> names;
    for (const StatsFinding finding : findings)
        names.push_back(finding_names[static_cast<std::size_t>(finding)]);
    return joined(names, ", ");
}

namespace {

/// The pixel that a test is about, if the canvas has it.
std::optional<Pixel> pixel_of(const DepthStep& test, const Canvas& canvas) {
    if (!canvas.contains(test.x, test.y))
        return std::nullopt;
    return Pixel{static_cast<int>(test.x), static_cast<int>(test.y)};
}

/// Counts steps by their kind, in order of appearance. A trace may hold as many kinds as it has steps.
class KindCounts {
public:
    void add(StepKind kind) {
        std::size_t& place = known_[static_cast<std::size_t>(kind)];
        if (place == 0)
            place = place_of(std::string(name_of(kind)));
        ++count_[place - 1].second;
    }
    void add(const std::string& kind_name) { ++count_[place_of(kind_name) - 1].second; }

    const std::vector<std::pair<std::string, std::uint64_t>>& all() const { return count_; }

private:
    /// The place of a kind in `count_`, from 1.
    std::size_t place_of(const std::string& kind_name) {
        std::size_t& place = places_.try_emplace(kind_name, 0).first->second;
        if (place == 0) {
            count_.emplace_back(kind_name, 0);
            place = count_.size();
        }
        return place;
    }

    std::vector<std::pair<std::string, std::uint64_t>> count_;
    std::array<std::size_t, step_kinds> known_{};         ///< places of known kinds; 0: not yet
    std::unordered_map<std::string, std::size_t> places_; ///< of all kinds
};

/// Goes through the steps of a trace and counts them.
class TraceCounts {
public:
    /// Fills in `stats`, but for what is compared with corners, and what is told of the picture.
    TraceCounts(const Trace& trace, Stats& stats)
        : trace_(trace), stats_(stats), needs_(trace), has_rows_(!trace.is_partial),
          picture_(trace.canvas), is_tied_(picture_.colors().size()) {}

    /// Takes step n; they come in order.
    void take(std::size_t n) {
        const StepView step = trace_.step(n);
        const auto kind = trace_.kind_of(n);
        if (!kind) {
            kinds_.add(step.kind_name());
            rows_.close();
            return;
        }
        kinds_.add(*kind);
        if (kind != StepKind::primitive)
            needs_.add(*kind, n);
        switch (*kind) {
        case StepKind::pixel:
            count(step.as<PixelStep>());
            break;
        case StepKind::depth:
            count(step.as<DepthStep>());
            break;
        case StepKind::scanline:
            count(step.as<ScanlineStep>(), n);
            break;
        case StepKind::reject:
            rows_.add(step.as<RejectStep>());
            break;
        case StepKind::primitive:
            count(step.as<PrimitiveStep>(), n);
            break;
        case StepKind::skip:
            count(step.as<SkipStep>());
            break;
        default:
            rows_.close();
        }
    }

    /// Behind the last step. The last row of a trace that is cut off is not judged: its pixels may be missing.
    void finish() {
        finish_primitive();
        needs_.close();
        if (trace_.end)
            rows_.close();
        stats_.count = kinds_.all();
        stats_.unjudged = needs_.unjudged();
        stats_.wrong_rows = rows_.wrong();
        const Canvas& canvas = picture_.canvas();
        for (int row = 0; row < canvas.height; ++row)
            for (int x = canvas.left(); x <= canvas.right(); ++x) {
                const Pixel pixel{x, canvas.y_of(row)};
                if (is_tied_[canvas.offset_of(pixel)])
                    stats_.depth_ties.add(pixel);
            }
    }

    /// What each primitive has drawn.
    std::vector<DrawnPrimitive>& drawn() { return drawn_; }

    const Image& picture() const { return picture_; }

private:
    PrimitiveStats& primitive() { return stats_.primitives.back(); }

    /// The pixels that the current primitive has drawn.
    void finish_primitive() {
        if (drawn_.empty())
            return;
        DrawnPrimitive& drawn = drawn_.back();
        drawn.pixels = PixelSet(pixels_);
        if (!hidden_.empty()) {
            hidden_.insert(hidden_.end(), pixels_.begin(), pixels_.end());
            drawn.covered = PixelSet(hidden_);
        }
        pixels_.clear();
        hidden_.clear();
        primitive().pixels = drawn.pixels.size();
        primitive().hidden = drawn.covering().size() - drawn.pixels.size();
    }

    void count(const PrimitiveStep& begun, std::size_t n) {
        finish_primitive();
        rows_.close();
        needs_.begin(begun, n);
        color_ = color_of_primitive(begun);
        const bool only_hides = begun.painted.is_false();
        has_rows_ = !trace_.is_partial && !only_hides;

        drawn_.emplace_back();
        if (!only_hides)
            drawn_.back().corners = needs_.corners();
        stats_.primitives.emplace_back();
        primitive().step = n;
        primitive().kind = begun.kind.text();
        primitive().name = begun.name.text();
    }

    void count(const SkipStep& skip) {
        rows_.close();
        if (!drawn_.empty())
            primitive().skipped = skip.why.text();
    }

    void count(const ScanlineStep& row, std::size_t n) {
        if (has_rows_)
            rows_.begin(row, n, drawn_.empty() ? "" : primitive().name);
    }

    void count(const PixelStep& step) {
        rows_.add(step);
        const auto plotted = plotted_by(step, trace_.canvas, color_);
        if (!plotted)
            return;
        ++stats_.writes;
        const Color before = std::exchange(picture_.at(plotted->pixel), plotted->color);
        if (drawn_.empty())
            return;
        if (before != no_color)
            ++primitive().over;
        ++primitive().writes;
        pixels_.push_back(static_cast<std::uint32_t>(trace_.canvas.offset_of(plotted->pixel)));
    }

    void count(const DepthStep& test) {
        rows_.add(test);
        const auto pixel = pixel_of(test, trace_.canvas);
        if (!pixel)
            return;
        const std::size_t offset = trace_.canvas.offset_of(*pixel);
        if (test.pass.is_true()) {
            is_tied_[offset] = false;
            return;
        }
        const Color before = picture_.at(*pixel);
        if (test.depth == test.stored && before != no_color && before != color_)
            is_tied_[offset] = true;
        if (!drawn_.empty())
            hidden_.push_back(static_cast<std::uint32_t>(offset));
    }

    const Trace& trace_;
    Stats& stats_;
    KindCounts kinds_;
    RowCheck rows_;
    StatsNeeds needs_;
    std::vector<DrawnPrimitive> drawn_;
    std::vector<std::uint32_t> pixels_; ///< offsets, of the current primitive
    std::vector<std::uint32_t> hidden_; ///< the same of those that failed the depth test
    Color color_;                       ///< of the current primitive
    bool has_rows_;                     ///< rows of the current primitive are judged
    Image picture_;
    std::vector<bool> is_tied_; ///< pixels where a depth test was a tie that decided what is seen
};

} // namespace

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
