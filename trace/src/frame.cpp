// SPDX-License-Identifier: MIT
#include <rastertrace/trace/frame.h>

#include <rastertrace/trace/color_text.h>

#include <algorithm>
#include <utility>

namespace rastertrace {

void Replay::go_to(std::size_t n) {
    if (n < step_) {
        frame_ = Frame(trace_.canvas, parts_);
        step_ = primitive_ = scanline_ = scanline_before_ = drew_over_ = stored_before_ = 0;
        order_ = ray_ = vertex_ = vertex_before_ = 0;
        edges_.clear();
        primitives_.clear();
        matrices_.clear();
    }
    while (step_ < n)
        apply_next();
}

void Replay::apply_next() {
    ++step_;
    drew_over_ = stored_before_ = 0;
    const auto kind = trace_.kind_of(step_);
    if (!kind)
        return;
    const StepView step = trace_.step(step_);
    switch (*kind) {
    case StepKind::primitive:
        primitive_ = step_;
        primitives_.push_back(step_);
        ray_ = scanline_ = scanline_before_ = 0;
        edges_.clear();
        color_ = color_of_primitive(step);
        break;
    case StepKind::matrix:
        matrices_.push_back(step_);
        break;
    case StepKind::order:
        order_ = step_;
        break;
    case StepKind::vertex:
        vertex_before_ = vertex_;
        vertex_ = step_;
        break;
    case StepKind::edge:
        edges_.push_back(step_);
        ray_ = 0;
        break;
    case StepKind::ray:
        ray_ = step_;
        break;
    case StepKind::scanline:
        scanline_before_ = scanline_;
        scanline_ = step_;
        break;
    case StepKind::pixel: {
        const auto plotted = plotted_by(step, trace_.canvas, color_);
        if (!plotted)
            break;
        frame_.image.at(plotted->pixel) = plotted->color;
        std::size_t& drawn_by = frame_.drawn_by[trace_.canvas.offset_of(plotted->pixel)];
        drew_over_ = drawn_by;
        drawn_by = step_;
        if (parts_.writes)
            ++frame_.writes[trace_.canvas.offset_of(plotted->pixel)];
        break;
    }
    case StepKind::depth: {
        const Index x = *step.whole("x");
        const Index y = *step.whole("y");
        if (!parts_.depths || !trace_.canvas.contains(x, y))
            break;
        std::size_t& stored_by =
            frame_.stored_by[trace_.canvas.offset_of({static_cast<int>(x), static_cast<int>(y)})];
        stored_before_ = stored_by;
        // What passes a nearer depth leaves it stored.
        if (step.text("pass") == "true" && !step.field("side_of") && !step.field("beside"))
            stored_by = step_;
        break;
    }
    default:
        break;
    }
}

std::size_t Replay::primitive_of(std::size_t step) const {
    const auto next = std::upper_bound(primitives_.begin(), primitives_.end(), step);
    return next == primitives_.begin() ? 0 : *(next - 1);
}

const std::vector<std::size_t>& Replay::places_of(const std::string& vertex) const {
    if (!places_) {
        places_.emplace();
        for (std::size_t n = 1; n <= trace_.size(); ++n)
            if (trace_.kind_of(n) == StepKind::vertex)
                (*places_)[trace_.step(n).text("name")].push_back(n);
    }
    static const std::vector<std::size_t> none;
    const auto found = places_->find(vertex);
    return found == places_->end() ? none : found->second;
}

std::optional<PlottedPixel> plotted_by(const StepView& step, const Canvas& canvas,
                                       Color of_primitive) {
    const Index x = *step.whole("x");
    const Index y = *step.whole("y");
    if (!canvas.contains(x, y))
        return std::nullopt;
    const auto own_color = step.field("color") ? parse_color(step.text("color")) : of_primitive;
    return PlottedPixel{{static_cast<int>(x), static_cast<int>(y)},
                        own_color.value_or(of_primitive)};
}

Color color_of_primitive(const StepView& step) {
    return parse_color(step.text("color")).value_or(Color{});
}

Frame frame_after(const Trace& trace, std::size_t n) {
    Replay replay(trace);
    replay.go_to(n);
    return std::move(replay).frame();
}

} // namespace rastertrace
