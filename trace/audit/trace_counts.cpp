// SPDX-License-Identifier: MIT
#include "trace_counts.h"

#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <utility>

namespace rastertrace {

namespace {

/// The pixel that a test is about, if the canvas has it.
std::optional<Pixel> pixel_of(const DepthStep& test, const Canvas& canvas) {
    if (!canvas.contains(test.x, test.y))
        return std::nullopt;
    return Pixel{static_cast<int>(test.x), static_cast<int>(test.y)};
}

} // namespace

std::size_t KindCounts::place_of(const std::string& kind_name) {
    std::size_t& place = places_.try_emplace(kind_name, 0).first->second;
    if (place == 0) {
        count_.emplace_back(kind_name, 0);
        place = count_.size();
    }
    return place;
}

void KindCounts::add(StepKind kind) {
    std::size_t& place = known_[static_cast<std::size_t>(kind)];
    if (place == 0)
        place = place_of(std::string(name_of(kind)));
    ++count_[place - 1].second;
}

TraceCounts::TraceCounts(const Trace& trace, Stats& stats)
    : trace_(trace), stats_(stats), needs_(trace), has_rows_(!trace.is_partial),
      picture_(trace.canvas), is_tied_(picture_.colors().size()) {}

void TraceCounts::take(std::size_t n) {
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

void TraceCounts::finish() {
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

/// The pixels that the current primitive has drawn.
void TraceCounts::finish_primitive() {
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

void TraceCounts::count(const PrimitiveStep& begun, std::size_t n) {
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

void TraceCounts::count(const SkipStep& skip) {
    rows_.close();
    if (!drawn_.empty())
        primitive().skipped = skip.why.text();
}

void TraceCounts::count(const ScanlineStep& row, std::size_t n) {
    if (has_rows_)
        rows_.begin(row, n, drawn_.empty() ? "" : primitive().name);
}

void TraceCounts::count(const PixelStep& step) {
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

void TraceCounts::count(const DepthStep& test) {
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

} // namespace rastertrace
