// SPDX-License-Identifier: MIT
#include "shown_steps.h"

#include "step_text.h"
#include "told_samples.h"

#include <algorithm>
#include <cmath>
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

std::optional<Pixel> on_canvas(const Canvas& canvas, std::optional<Index> x,
                               std::optional<Index> y) {
    if (!x || !y || !canvas.contains(*x, *y))
        return std::nullopt;
    return Pixel{static_cast<int>(*x), static_cast<int>(*y)};
}

/// The primitive that a step belongs to, or the one that it names. That one may begin after it.
std::size_t primitive_meant(const Replay& replay, std::size_t n, StepKind kind) {
    const Trace& trace = replay.trace();
    const std::size_t own = replay.primitive();
    switch (kind) {
    case StepKind::triangulate:
    case StepKind::matrix:
    case StepKind::vertex:
    case StepKind::order:
        return 0;
    case StepKind::face:
    case StepKind::light:
    case StepKind::clip:
    case StepKind::skip:
    case StepKind::undecided:
        break;
    default:
        return own;
    }
    const std::string name = name_in(trace.step(n)).text();
    const auto is_meant = [&](std::size_t primitive) {
        const auto step = trace.step(primitive).as<PrimitiveStep>();
        return step.name == name || name_of_whole(step) == name;
    };
    if (name.empty() || (own != 0 && is_meant(own)))
        return own;
    const std::size_t next = trace.next_of({StepKind::primitive}, n, trace.size());
    return next <= trace.size() && is_meant(next) ? next : 0;
}

/// What the canvas has of columns and rows; nothing if it has none of them.
std::optional<Region> part_of(const Canvas& canvas, Index from_x, Index to_x, Index from_y,
                              Index to_y) {
    const auto [left, right] = std::minmax({from_x, to_x});
    const auto [least, most] = std::minmax({from_y, to_y});
    const auto [first_y, last_y] = std::minmax({Index{canvas.top()}, Index{canvas.bottom()}});
    if (right < canvas.left() || left > canvas.right() || most < first_y || least > last_y)
        return std::nullopt;
    return Region{static_cast<int>(std::max<Index>(left, canvas.left())),
                  static_cast<int>(std::max(least, first_y)),
                  static_cast<int>(std::min<Index>(right, canvas.right())),
                  static_cast<int>(std::min(most, last_y))};
}

/// Whole rows.
void set_rows(const Canvas& canvas, Index from, Index to, StepSubject& subject) {
    subject.pixels = part_of(canvas, canvas.left(), canvas.right(), from, to);
    subject.is_row = true;
}

/// A run of a row, or whole rows. What leads off the canvas along a line is none of them.
void set_rejected(const Canvas& canvas, const RejectStep& reject, StepSubject& subject) {
    if (!reject.y || (reject.to_x && reject.to_y))
        return;
    if (!reject.x)
        return set_rows(canvas, *reject.y, reject.to_y.value_or(*reject.y), subject);
    subject.pixels = part_of(canvas, *reject.x, reject.to_x.value_or(*reject.x), *reject.y,
                             reject.to_y.value_or(*reject.y));
}

} // namespace

std::string steps_text(const Trace& trace, ShownSteps steps) {
    if (steps.first == steps.last)
        return said("step {} of {}", trace.number_of(steps.last), trace.size());
    return said("steps {} to {} of {}", trace.number_of(steps.first), trace.number_of(steps.last),
                trace.size());
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
    switch (trace.kind_of(n).value_or(StepKind::pixel)) {
    case StepKind::along: {
        const auto along = step.as<AlongStep>();
        return on_canvas(trace.canvas, along.x.value_or(along.pixel),
                         along.y.value_or(along.pixel));
    }
    case StepKind::reject:
        if (const auto reject = step.as<RejectStep>(); reject.to_x || reject.to_y)
            return std::nullopt;
        [[fallthrough]];
    default:
        return on_canvas(trace.canvas, x_in(step), y_in(step));
    }
}

std::optional<Pixel> pixel_at(const Trace& trace, const TracedList<TracedNumber>& at) {
    const auto position = at.values();
    const auto x = position.size() < 2 ? std::nullopt : position[0].nearest_double();
    const auto y = position.size() < 2 ? std::nullopt : position[1].nearest_double();
    if (!x || !y || !(std::abs(*x) < largest_canvas_side) || !(std::abs(*y) < largest_canvas_side))
        return std::nullopt;
    // Where pixels are sampled at their centers, a pixel reaches from its point to the next one.
    const double half = pixels_begin_at_integers(trace) ? 0 : 0.5;
    return on_canvas(trace.canvas, static_cast<Index>(std::floor(*x + half)),
                     static_cast<Index>(std::floor(*y + half)));
}

StepSubject subject_of(const Replay& replay, std::size_t n) {
    const Trace& trace = replay.trace();
    const Canvas& canvas = trace.canvas;
    const auto kind = n == 0 ? std::nullopt : trace.kind_of(n);
    StepSubject subject;
    if (n == 0)
        return subject;
    const StepView step = trace.step(n);
    subject.primitive = kind ? primitive_meant(replay, n, *kind) : replay.primitive();
    if (const auto pixel = pixel_of(trace, n))
        subject.pixels = Region{pixel->x, pixel->y, pixel->x, pixel->y};
    if (!kind)
        return subject;
    switch (*kind) {
    case StepKind::vertex:
        if (const auto vertex = step.as<VertexStep>(); vertex.space == Space::screen)
            if (const auto pixel = pixel_at(trace, vertex.at))
                subject.pixels = Region{pixel->x, pixel->y, pixel->x, pixel->y};
        break;
    case StepKind::edge:
        if (subject.primitive != 0)
            if (const auto ends = ends_of_edge(primitive_in(trace.step(subject.primitive)),
                                               step.as<EdgeStep>().edge.text()))
                subject.edge = ends->vertices;
        break;
    case StepKind::half: {
        const auto half = step.as<HalfStep>();
        // It is filled upward; one that ends below its beginning has no row.
        if (half.from_y && half.to_y && canvas.row_of(*half.from_y) >= canvas.row_of(*half.to_y))
            set_rows(canvas, *half.from_y, *half.to_y, subject);
        break;
    }
    case StepKind::crossings:
        subject.row = n;
        set_rows(canvas, step.as<CrossingsStep>().y, step.as<CrossingsStep>().y, subject);
        break;
    case StepKind::scanline: {
        const auto row = step.as<ScanlineStep>();
        subject.row = n;
        set_rows(canvas, row.y, row.y, subject);
        if (subject.pixels) // those between its ends
            subject.pixels =
                part_of(canvas, std::clamp<Index>(row.from, canvas.left(), canvas.right()),
                        std::clamp<Index>(row.to, canvas.left(), canvas.right()), row.y, row.y);
        break;
    }
    case StepKind::reject:
        set_rejected(canvas, step.as<RejectStep>(), subject);
        [[fallthrough]];
    case StepKind::depth:
    case StepKind::pixel:
        if (const std::size_t row = replay.scanline();
            row != 0 && row < n && trace.step(row).as<ScanlineStep>().y == y_in(step))
            subject.row = row;
        break;
    default:
        break;
    }
    return subject;
}

bool tests_samples(const Trace& trace) {
    return traits_of(trace.method.triangles.fill).rule == PixelRule::samples;
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
