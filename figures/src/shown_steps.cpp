// SPDX-License-Identifier: MIT
#include <rastertrace/figures/shown_steps.h>

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>

#include <algorithm>
#include <limits>

namespace rastertrace {

namespace {

/// True if a step of the second kind begins something new for one of the first, which ends there.
bool ends(StepKind kind, StepKind next) {
    switch (kind) {
    case StepKind::primitive:
        return next == StepKind::primitive;
    case StepKind::half:
        return next == StepKind::primitive || next == StepKind::half;
    case StepKind::ray:
        return next == StepKind::primitive || next == StepKind::edge || next == StepKind::ray;
    case StepKind::scanline:
    case StepKind::along:
    case StepKind::decide:
    case StepKind::sample:
        return next != StepKind::depth && next != StepKind::pixel && next != StepKind::reject;
    default:
        return true;
    }
}

} // namespace

std::string steps_text(const Trace& trace, ShownSteps steps) {
    if (steps.first == steps.last)
        return said({"step {} of {}", "passo {} de {}"}, trace.number_of(steps.last), trace.size());
    return said({"steps {} to {} of {}", "passos {} a {} de {}"}, trace.number_of(steps.first),
                trace.number_of(steps.last), trace.size());
}

std::size_t end_of(const Trace& trace, std::size_t n) {
    const auto kind = n == 0 ? std::nullopt : trace.kind_of(n);
    std::size_t last = n;
    while (kind && last < trace.size()) {
        const auto next = trace.kind_of(last + 1);
        if (next && ends(*kind, *next))
            break;
        ++last;
    }
    return last;
}

std::vector<ShownSteps> film_of(const Trace& trace, std::size_t most) {
    std::vector<ShownSteps> frames;
    bool is_fill = false; // the primitive is filled
    constexpr Index no_row = std::numeric_limits<Index>::max();
    Index row = no_row; // the y of the last frame, if it is a row of this primitive
    for (std::size_t n = 1; n <= trace.size() && frames.size() <= most; ++n) {
        const auto kind = trace.kind_of(n);
        if (kind == StepKind::primitive) {
            is_fill = is_filled(trace.step(n).as<PrimitiveStep>().kind);
            row = no_row;
        } else if (kind == StepKind::vertex || (kind == StepKind::pixel && !is_fill)) {
            frames.push_back({n, n});
        } else if (kind == StepKind::ray) {
            frames.push_back({n, end_of(trace, n)});
            n = frames.back().last;
        } else if (is_fill && (kind == StepKind::crossings || kind == StepKind::scanline ||
                               kind == StepKind::sample || kind == StepKind::depth ||
                               kind == StepKind::pixel)) {
            const Index y = y_in(trace.step(n)).value_or(0);
            if (row != y)
                frames.push_back({n, n});
            frames.back().last = n;
            row = y;
        }
    }
    return frames;
}

std::optional<Pixel> pixel_of(const Trace& trace, std::size_t n) {
    if (n == 0)
        return std::nullopt;
    const StepView step = trace.step(n);
    const auto x = x_in(step);
    const auto y = y_in(step);
    if (!x || !y || !trace.canvas.contains(*x, *y))
        return std::nullopt;
    return Pixel{static_cast<int>(*x), static_cast<int>(*y)};
}

bool tests_samples(const Trace& trace) {
    const std::string fill = trace.method_value("fill");
    return fill == "barycentric" || fill == "top-left";
}

std::set<std::size_t> pixels_not_drawn(const Trace& trace, ShownSteps steps) {
    std::set<std::size_t> offsets;
    for (std::size_t n = std::max<std::size_t>(steps.first, 1); n <= steps.last; ++n) {
        const auto kind = trace.kind_of(n);
        const StepView step = trace.step(n);
        const bool is_dropped =
            (kind == StepKind::depth && step.as<DepthStep>().pass.is_false()) ||
            (kind == StepKind::sample && step.as<SampleStep>().inside.is_false());
        const auto pixel = is_dropped ? pixel_of(trace, n) : std::nullopt;
        if (pixel)
            offsets.insert(trace.canvas.offset_of(*pixel));
    }
    return offsets;
}

} // namespace rastertrace
