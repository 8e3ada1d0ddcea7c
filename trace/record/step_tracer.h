// SPDX-License-Identifier: MIT
#pragma once

// A sink that makes of each step of a drawing the step that a trace tells, and hands it on.
//
//     StepTracer<Steps> tracer(steps, steps.arena());
//     draw(scene, plan, tracer);  // steps.take(ScanlineStep{...}), ...
//
// What is handed on refers to the arena: for as long as that, if the arena `keeps` everything, else until the next step.

#include "arena.h"
#include "trace_options.h"
#include "traced_steps.h"

#include <rastertrace/core/numbers/quantity.h>
#include <rastertrace/core/raster/steps.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

template <typename To> class StepTracer {
public:
    StepTracer(To& to, Arena& arena, bool keeps, const StepFilter& filter = {});
    StepTracer(const StepTracer&) = delete;
    StepTracer& operator=(const StepTracer&) = delete;

    /// False for steps that the filter leaves out, whatever they say.
    template <typename Step> bool takes() const {
        if constexpr (requires(Step * step) { kind_of(step); })
            return wanted_[static_cast<std::size_t>(kind_of(static_cast<Step*>(nullptr)))];
        else
            return true;
    }

    void operator()(const PixelPlotted& step) {
        if (wants(StepKind::pixel) && is_in_region(step.pixel))
            to_.take(
                PixelStep{.x = step.pixel.x,
                          .y = step.pixel.y,
                          .color = step.color == color_ ? TracedColor() : TracedColor(step.color)});
    }

    void operator()(const FaceTriangulated<Quantity>& step);
    void operator()(const MatrixSetUp<Quantity>& step);
    void operator()(const VertexPlaced<Quantity>& step);
    void operator()(const PrimitivesOrdered<Quantity>& step);
    void operator()(const PrimitiveBegan<Quantity>& step);
    void operator()(const FaceTested<Quantity>& step);
    void operator()(const FaceLit<Quantity>& step);
    void operator()(const PrimitiveClipped& step);
    void operator()(const EdgeSetUp<Quantity>& step);
    void operator()(const EdgeFunctionSetUp<Quantity>& step);
    void operator()(const SideBegan& step);
    void operator()(const HalfBegan& step);
    void operator()(const RayBegan& step);
    void operator()(const RowCrossed<Quantity>& step);
    void operator()(const ScanlineSpanned<Quantity>& step);
    void operator()(const LineSampled<Quantity>& step);
    void operator()(const LineDecided& step);
    void operator()(const SampleTested<Quantity>& step);
    void operator()(const DepthTested<Quantity>& step);
    void operator()(const PixelsRejected& step);
    void operator()(const RowsRejected& step);
    void operator()(const PrimitiveSkipped& step);
    void operator()(const BoundExceeded& step);

private:
    bool wants(StepKind kind) const {
        return wanted_[static_cast<std::size_t>(kind)] && is_in_primitive_;
    }

    // Steps that need not be put together if they are left out. PrimitiveBegan says whose the others are.
    static StepKind kind_of(const MatrixSetUp<Quantity>*) { return StepKind::matrix; }
    static StepKind kind_of(const VertexPlaced<Quantity>*) { return StepKind::vertex; }
    static StepKind kind_of(const FaceTested<Quantity>*) { return StepKind::face; }
    static StepKind kind_of(const FaceLit<Quantity>*) { return StepKind::light; }
    static StepKind kind_of(const EdgeSetUp<Quantity>*) { return StepKind::edge; }
    static StepKind kind_of(const EdgeFunctionSetUp<Quantity>*) { return StepKind::edge; }
    static StepKind kind_of(const RowCrossed<Quantity>*) { return StepKind::crossings; }
    static StepKind kind_of(const ScanlineSpanned<Quantity>*) { return StepKind::scanline; }
    static StepKind kind_of(const LineSampled<Quantity>*) { return StepKind::along; }
    static StepKind kind_of(const SampleTested<Quantity>*) { return StepKind::sample; }
    static StepKind kind_of(const DepthTested<Quantity>*) { return StepKind::depth; }
    static StepKind kind_of(const SideBegan*) { return StepKind::edge; }
    static StepKind kind_of(const HalfBegan*) { return StepKind::half; }
    static StepKind kind_of(const RayBegan*) { return StepKind::ray; }
    static StepKind kind_of(const LineDecided*) { return StepKind::decide; }
    static StepKind kind_of(const PixelPlotted*) { return StepKind::pixel; }
    static StepKind kind_of(const PixelsRejected*) { return StepKind::reject; }
    static StepKind kind_of(const RowsRejected*) { return StepKind::reject; }

    bool is_in_region(Index y, Index from, Index to) const {
        return !region_ || (region_->has_row(y) && region_->meets(from, to));
    }
    bool is_in_region(Pixel pixel) const { return is_in_region(pixel.y, pixel.x, pixel.x); }

    /// Hands a step on; what it refers to is given back, if nobody keeps it.
    template <typename Step> void tell(const Step& step) {
        to_.take(step);
        if (!keeps_)
            arena_.rewind(of_primitive_);
    }

    void begin_primitive(std::string_view name, std::span<const std::string_view> vertices);
    void write_labels();
    TracedText label(EdgeName edge);

    TracedText quoted(std::string_view name);
    TracedNumber number(const Quantity& quantity);
    template <typename Value, typename Range, typename Make>
    TracedList<Value> list(const Range& range, const Make& value_of);
    TracedList<TracedNumber> numbers(std::span<const Quantity> quantities);
    TracedList<TracedNumber> vector(const Vec<Quantity, 2>& vector);
    TracedList<TracedNumber> vector(const Vec<Quantity, 3>& vector);
    TracedList<TracedText> names(std::span<const std::string_view> names);

    To& to_;
    Arena& arena_;
    bool keeps_;
    std::array<bool, step_kinds> wanted_{};
    std::optional<Region> region_;
    std::optional<std::string> primitive_;
    bool is_in_primitive_;
    Color color_;            ///< of the current primitive
    TracedText name_;        ///< of the same
    bool is_circle_ = false; ///< then each decision is about pixels in all eight octants
    std::vector<std::string_view> vertices_; ///< its vertices' names
    std::vector<TracedText> labels_;         ///< its edges' names, once one was asked for
    Arena::Mark of_primitive_; ///< up to here the arena has what the primitive refers to
};

} // namespace rastertrace
