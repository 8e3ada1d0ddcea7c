// SPDX-License-Identifier: MIT
#include "stats.h"

#include "coverage.h"
#include "row_check.h"
#include "stats_needs.h"

#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/text/text.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
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

/// Counts a pixel step, and notes its pixel as drawn by the current primitive.
void count_pixel(Stats& stats, std::vector<DrawnPrimitive>& drawn, const PixelStep& step,
                 const Replay& replay) {
    const Canvas& canvas = replay.trace().canvas;
    const auto pixel = pixel_of(step, canvas);
    if (!pixel)
        return;
    ++stats.writes;
    if (stats.primitives.empty())
        return;
    ++stats.primitives.back().writes;
    stats.primitives.back().over += replay.drew_over() != 0 ? 1 : 0;
    add_pixel(drawn.back(), canvas.offset_of(*pixel));
}

/// Notes a pixel of the current primitive that failed the depth test.
void note_hidden_pixel(std::vector<DrawnPrimitive>& drawn, const DepthStep& test,
                       const Canvas& canvas) {
    const auto pixel = pixel_of(test, canvas);
    if (!drawn.empty() && pixel)
        add_hidden_pixel(drawn.back(), canvas.offset_of(*pixel));
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

Stats stats_of(const Trace& trace) {
    // Step by step, what is drawn and by which primitive.
    Stats stats;
    stats.steps = trace.size();
    KindCounts kinds(stats);
    std::vector<DrawnPrimitive> drawn;
    DepthTies ties(trace.canvas);
    RowCheck rows(stats.wrong_rows);
    StatsNeeds needs(trace);
    Replay replay(trace);
    bool is_painted = true; // the current primitive
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        replay.go_to(n);
        const StepView step = trace.step(n);
        const auto kind = trace.kind_of(n);
        needs.add(step, kind, n);
        kinds.add(kind, step);
        if (kind == StepKind::primitive) {
            const auto begun = step.as<PrimitiveStep>();
            PrimitiveStats& primitive = stats.primitives.emplace_back();
            primitive.kind = begun.kind.text();
            primitive.name = begun.name.text();
            is_painted = !begun.painted.is_false();
            drawn.push_back({.step = n, .pixels = {}, .covered = {}});
        }
        if (kind == StepKind::skip && !stats.primitives.empty())
            stats.primitives.back().skipped = step.as<SkipStep>().why.text();
        if (!trace.is_partial && (is_painted || kind == StepKind::primitive))
            rows.add(trace, n, stats.primitives.empty() ? "" : stats.primitives.back().name);
        if (kind == StepKind::pixel)
            count_pixel(stats, drawn, step.as<PixelStep>(), replay);
        if (kind == StepKind::depth) {
            const auto test = step.as<DepthStep>();
            ties.add(test, replay.color(), replay.frame());
            if (!test.pass.is_true())
                note_hidden_pixel(drawn, test, trace.canvas);
        }
    }

    needs.close();
    stats.unjudged = needs.unjudged();

    // Against what should have been drawn, where all of that can be there.
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        keep_each_once(drawn[i]);
        stats.primitives[i].pixels = drawn[i].pixels.size();
        stats.primitives[i].hidden = drawn[i].covering().size() - drawn[i].pixels.size();
    }
    if (trace.end)
        rows.close();
    if (!trace.end && !drawn.empty())
        drawn.pop_back();
    if (!trace.is_partial)
        compare_with_corners(trace, drawn, stats);

    stats.depth_ties = ties.found();

    // The picture that came of it.
    const Image& picture = replay.frame().image;
    stats.canvas = picture.colors().size();
    stats.pixels = picture.drawn();
    stats.frame = frame_name(picture);
    const bool is_comparable = trace.end && !trace.end->frame.empty() && !trace.is_partial;
    stats.frame_differs = is_comparable && trace.end->frame != stats.frame;
    return stats;
}

} // namespace rastertrace
