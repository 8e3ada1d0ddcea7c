// SPDX-License-Identifier: MIT
#include "scanned_lines.h"

#include "step_decoder.h"

#include <rastertrace/trace/text/in_threads.h>

#include <algorithm>
#include <variant>

namespace rastertrace {

namespace {

/// Adds what a step changes.
class ChangesOf {
public:
    ChangesOf(ScannedLines& lines, const Canvas& canvas) : lines_(lines), canvas_(canvas) {}

    void operator()(const PrimitiveStep& step) const {
        add(StepKind::primitive, true, color_of_primitive(step));
    }
    void operator()(const PixelStep& step) const {
        if (const auto plotted = plotted_by(step, canvas_, no_color))
            add(StepKind::pixel, plotted->color != no_color || step.color.color(), plotted->color,
                plotted->pixel);
    }
    void operator()(const DepthStep& step) const {
        if (canvas_.contains(step.x, step.y))
            add(StepKind::depth, stores_depth(step), {},
                {static_cast<int>(step.x), static_cast<int>(step.y)});
    }
    void operator()(const MatrixStep& /*step*/) const { add(StepKind::matrix); }
    void operator()(const OrderStep& /*step*/) const { add(StepKind::order); }
    void operator()(const VertexStep& /*step*/) const { add(StepKind::vertex); }
    void operator()(const EdgeStep& /*step*/) const { add(StepKind::edge); }
    void operator()(const RayStep& /*step*/) const { add(StepKind::ray); }
    void operator()(const ScanlineStep& /*step*/) const { add(StepKind::scanline); }
    template <typename Step> void operator()(const Step& /*other*/) const {}

private:
    void add(StepKind kind, bool is_so = false, Color color = {}, Pixel pixel = {}) const {
        lines_.changes.push_back({.step = static_cast<std::uint32_t>(lines_.measured.kinds.size()),
                                  .kind = kind,
                                  .is_so = is_so,
                                  .color = color,
                                  .pixel = pixel});
    }

    ScannedLines& lines_;
    const Canvas& canvas_;
};

} // namespace

ScannedLines scan_lines(std::string_view text, std::size_t begin, std::size_t end,
                        const LineScan& scan) {
    constexpr std::size_t usual_line = 120; // bytes
    ScannedLines lines{.measured = {.begin = begin, .end = begin}};
    auto& [first, at, kinds, sizes] = lines.measured;
    kinds.reserve((end - begin) / usual_line);
    sizes.reserve((end - begin) / usual_line);
    if (scan.has_changes)
        lines.changes.reserve((end - begin) / usual_line);
    AnyStep step;
    while (at < end) {
        std::string_view rest = text.substr(at);
        if (!take_step(rest, step))
            break;
        if (scan.is_document && rest.starts_with(','))
            rest.remove_prefix(1);
        const std::size_t size = text.size() - rest.size() + 1 - at;
        if (!rest.starts_with('\n') || size > longest_measured_line)
            break;
        lines.counts.add(static_cast<StepKind>(step.index()));
        if (const auto* const pixel = std::get_if<PixelStep>(&step);
            pixel && !lines.stray && !scan.canvas.contains(pixel->x, pixel->y))
            lines.stray = {.offset = at, .x = pixel->x, .y = pixel->y};
        if (scan.has_changes)
            std::visit(ChangesOf(lines, scan.canvas), step);
        kinds.push_back(static_cast<std::uint8_t>(step.index()));
        sizes.push_back(static_cast<std::uint16_t>(size));
        at += size;
    }
    lines.is_whole = at >= end;
    return lines;
}

std::vector<ScannedLines> scan_parts(std::string_view text, std::size_t begin, std::size_t end,
                                     std::size_t part, std::size_t jobs, const LineScan& scan) {
    std::vector<std::size_t> places{begin};
    while (places.back() < std::min(end, text.size())) {
        const std::size_t newline = text.find('\n', std::min(places.back() + part, end) - 1);
        places.push_back(std::min(newline, text.size() - 1) + 1);
    }
    std::vector<ScannedLines> parts(places.size() - 1);
    in_threads(parts.size(), jobs, [&](std::size_t i, std::size_t /*thread*/) {
        parts[i] = scan_lines(text, places[i], places[i + 1], scan);
    });
    return parts;
}

void ScannedLines::play(ReplayState& state) const {
    const std::size_t before = state.step();
    for (const Change& change : changes) {
        state.pass_to(before + change.step);
        if (change.kind == StepKind::pixel)
            state.take_pixel(change.pixel, change.is_so ? change.color : state.color());
        else if (change.kind == StepKind::primitive)
            state.take_primitive(change.color);
        else if (change.kind == StepKind::depth)
            state.take_depth(change.pixel, change.is_so);
        else
            state.take(change.kind);
    }
    state.pass_to(before + measured.kinds.size());
}

} // namespace rastertrace
