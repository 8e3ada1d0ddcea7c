// SPDX-License-Identifier: MIT
#include "frame.h"

#include "traced_steps.h"

#include <algorithm>
#include <utility>

namespace rastertrace {

void ReplayState::start_over() {
    frame_ = Frame(frame_.image.canvas(), parts_);
    has_changed_.assign(has_changed_.size(), 0);
    place_ = {};
}

void ReplayState::go_to_place_of(const ReplayState& other) {
    Color* const colors = frame_.image.row(frame_.image.canvas().top()).colors;
    for (std::size_t tile = 0; tile < has_changed_.size(); ++tile) {
        if (has_changed_[tile] == 0 && other.has_changed_[tile] == 0)
            continue; // blank in both
        const std::size_t begin = tile * tile_size;
        const std::size_t end = std::min(begin + tile_size, frame_.drawn_by.size());
        const auto take_over = [begin, end](auto& values, const auto& others) {
            if (!values.empty())
                std::copy(others.data() + begin, others.data() + end, values.data() + begin);
        };
        std::copy(other.frame_.image.colors().data() + begin,
                  other.frame_.image.colors().data() + end, colors + begin);
        take_over(frame_.drawn_by, other.frame_.drawn_by);
        take_over(frame_.writes, other.frame_.writes);
        take_over(frame_.stored_by, other.frame_.stored_by);
        has_changed_[tile] = other.has_changed_[tile];
    }
    place_ = other.place_;
    if (primitives_.size() < place_.primitives)
        primitives_ = other.primitives_;
    if (matrices_.size() < place_.matrices)
        matrices_ = other.matrices_;
}

namespace {

/// Adds a step to the list of its kind, of which `count` come before it. A replay that went back has it already.
void add_to(std::vector<std::size_t>& list, std::size_t& count, std::size_t step) {
    if (count == list.size())
        list.push_back(step);
    ++count;
}

} // namespace

void ReplayState::pass() {
    ++place_.step;
    place_.drew_over = place_.stored_before = 0;
}

void ReplayState::take(const StepView& step) {
    const auto kind = step.kind();
    if (!kind)
        return pass();
    switch (*kind) {
    case StepKind::primitive:
        return take(step.as<PrimitiveStep>());
    case StepKind::pixel:
        return take(step.as<PixelStep>());
    case StepKind::depth:
        return parts_.depths ? take(step.as<DepthStep>()) : pass();
    default:
        return take(*kind);
    }
}

void ReplayState::take(StepKind kind) {
    pass();
    switch (kind) {
    case StepKind::matrix:
        add_to(matrices_, place_.matrices, place_.step);
        break;
    case StepKind::order:
        place_.order = place_.step;
        break;
    case StepKind::vertex:
        place_.vertex_before = place_.vertex;
        place_.vertex = place_.step;
        break;
    case StepKind::edge:
        place_.edges.push_back(place_.step);
        place_.ray = 0;
        break;
    case StepKind::ray:
        place_.ray = place_.step;
        break;
    case StepKind::scanline:
        place_.scanline_before = place_.scanline;
        place_.scanline = place_.step;
        break;
    default:
        break;
    }
}

void ReplayState::take(const PrimitiveStep& step) {
    pass();
    place_.primitive = place_.step;
    add_to(primitives_, place_.primitives, place_.step);
    place_.ray = place_.scanline = place_.scanline_before = 0;
    place_.edges.clear();
    place_.color = color_of_primitive(step);
}

void ReplayState::take(const PixelStep& step) {
    pass();
    const auto plotted = plotted_by(step, frame_.image.canvas(), place_.color);
    if (!plotted)
        return;
    const std::size_t offset = frame_.image.canvas().offset_of(plotted->pixel);
    frame_.image.at(plotted->pixel) = plotted->color;
    place_.drew_over = std::exchange(frame_.drawn_by[offset], place_.step);
    if (parts_.writes)
        ++frame_.writes[offset];
    has_changed_[offset / tile_size] = 1;
}

void ReplayState::take(const DepthStep& step) {
    pass();
    const Canvas& canvas = frame_.image.canvas();
    if (!parts_.depths || !canvas.contains(step.x, step.y))
        return;
    const std::size_t offset =
        canvas.offset_of({static_cast<int>(step.x), static_cast<int>(step.y)});
    place_.stored_before = frame_.stored_by[offset];
    if (!stores_depth(step))
        return;
    frame_.stored_by[offset] = place_.step;
    has_changed_[offset / tile_size] = 1;
}

void ReplayState::take_over(ReplayState&& other) {
    const FrameParts parts = parts_;
    *this = std::move(other);
    parts_ = parts;
    if (!parts.writes)
        frame_.writes = {};
    if (!parts.depths) {
        frame_.stored_by = {};
        place_.stored_before = 0;
    }
}

void Replay::go_to(std::size_t n) {
    if (n < step())
        start_over();
    if (n == trace_.size())
        if (auto ahead = trace_.end_state_ahead(step()))
            take_over(*std::move(ahead));
    while (step() < n)
        take(trace_.step(step() + 1));
}

void Replay::go_to_place_of(const Replay& other) {
    ReplayState::go_to_place_of(other);
    vertex_places_ = other.vertex_places_;
}

std::size_t ReplayState::primitive_of(std::size_t step) const {
    const auto so_far = primitives();
    const auto next = std::upper_bound(so_far.begin(), so_far.end(), step);
    return next == so_far.begin() ? 0 : *(next - 1);
}

const std::vector<std::size_t>& Replay::places_of(const std::string& vertex) const {
    auto& [by_name, steps] = *vertex_places_;
    for (; steps < trace_.size(); ++steps)
        if (trace_.kind_of(steps + 1) == StepKind::vertex)
            by_name[trace_.step(steps + 1).as<VertexStep>().name.text()].push_back(steps + 1);
    static const std::vector<std::size_t> none;
    const auto found = by_name.find(vertex);
    return found == by_name.end() ? none : found->second;
}

std::optional<PlottedPixel> plotted_by(const PixelStep& pixel, const Canvas& canvas,
                                       Color of_primitive) {
    if (!canvas.contains(pixel.x, pixel.y))
        return std::nullopt;
    return PlottedPixel{{static_cast<int>(pixel.x), static_cast<int>(pixel.y)},
                        pixel.color ? pixel.color.color().value_or(of_primitive) : of_primitive};
}

bool stores_depth(const DepthStep& test) {
    return test.pass.is_true() && !test.side_of && !test.beside;
}

Color color_of_primitive(const PrimitiveStep& step) {
    return step.color.color().value_or(Color{});
}

Frame frame_after(const Trace& trace, std::size_t n) {
    Replay replay(trace);
    replay.go_to(n);
    return std::move(replay).frame();
}

} // namespace rastertrace
