// SPDX-License-Identifier: MIT
#include "part_counts.h"

#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <optional>

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

void KindCounts::add(const KindCounts& behind) {
    for (const auto& [kind_name, count] : behind.count_)
        count_[place_of(kind_name) - 1].second += count;
}

PartCounts::PartCounts(const Trace& trace, std::span<PrimitiveStats> primitives,
                       std::span<DrawnPrimitive> drawn)
    : needs(trace), trace_(trace), primitives_(primitives), drawn_(drawn),
      has_rows_(!trace.is_partial) {}

void PartCounts::take(const StepReader& steps, std::size_t first, std::size_t end) {
    for (std::size_t n = first; n < end; ++n) {
        const StepView step = steps.step(n);
        const auto kind = steps.kind_of(n);
        if (!kind) {
            kinds.add(step.kind_name());
            rows.close();
            continue;
        }
        kinds.add(*kind);
        if (kind != StepKind::primitive)
            needs.add(*kind, n);
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
            rows.add(step.as<RejectStep>());
            break;
        case StepKind::primitive:
            count(step.as<PrimitiveStep>(), n);
            break;
        case StepKind::skip:
            count(step.as<SkipStep>());
            break;
        default:
            rows.close();
        }
    }
}

void PartCounts::finish(bool is_whole) {
    finish_primitive();
    needs.close();
    if (is_whole)
        rows.close();
}

/// The pixels that the current primitive has drawn.
void PartCounts::finish_primitive() {
    if (begun_ == 0)
        return;
    DrawnPrimitive& drawn = drawn_[begun_ - 1];
    pixels_.give_to(drawn);
    primitive().pixels = drawn.pixels.size();
    primitive().hidden = drawn.covering().size() - drawn.pixels.size();
}

void PartCounts::count(const PrimitiveStep& begun, std::size_t n) {
    finish_primitive();
    rows.close();
    needs.begin(begun, n);
    color_ = color_of_primitive(begun);
    const bool only_hides = begun.painted.is_false();
    has_rows_ = !trace_.is_partial && !only_hides;

    if (!only_hides)
        drawn_[begun_].corners = needs.corners();
    ++begun_;
    primitive().step = n;
    primitive().kind = begun.kind.text();
    primitive().name = begun.name.text();
    events.push_back({});
}

void PartCounts::count(const SkipStep& skip) {
    rows.close();
    if (begun_ > 0)
        primitive().skipped = skip.why.text();
}

void PartCounts::count(const ScanlineStep& row, std::size_t n) {
    if (has_rows_)
        rows.begin(row, n, begun_ == 0 ? "" : primitive().name);
}

void PartCounts::count(const PixelStep& step) {
    rows.add(step);
    const auto plotted = plotted_by(step, trace_.canvas, color_);
    if (!plotted)
        return;
    events.push_back({PixelEvent::What::draw, plotted->pixel, plotted->color});
    ++writes;
    if (begun_ == 0)
        return;
    ++primitive().writes;
    pixels_.add(trace_.canvas.offset_of(plotted->pixel));
}

void PartCounts::count(const DepthStep& test) {
    rows.add(test);
    const auto pixel = pixel_of(test, trace_.canvas);
    if (!pixel)
        return;
    if (test.pass.is_true()) {
        events.push_back({PixelEvent::What::pass, *pixel, {}});
        return;
    }
    if (test.depth == test.stored)
        events.push_back({PixelEvent::What::tie, *pixel, color_});
    if (begun_ > 0)
        pixels_.add_hidden(trace_.canvas.offset_of(*pixel));
}

} // namespace rastertrace
