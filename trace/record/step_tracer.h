// SPDX-License-Identifier: MIT
#pragma once

// A sink that makes of each step of a drawing the step that a trace tells, and hands it on.
//
//     StepTracer<Steps> tracer(steps, steps.arena(), true);
//     draw(scene, plan, tracer);  // steps.take(ScanlineStep{...}), ...
//
// The names and lists of such a step are in the arena: as long as the arena, if the tracer `keeps` them, else until the
// next step.

#include "arena.h"
#include "trace_options.h"
#include "traced_steps.h"

#include <rastertrace/core/numbers/quantity.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace rastertrace {

/// The fields of steps as a trace holds them: what they refer to is in the arena.
class FieldTracer {
public:
    FieldTracer(Arena& arena, bool keeps) : arena_(arena), keeps_(keeps) {}

    /// A primitive begins: what belongs to the one before is given back, if nobody keeps it.
    void begin(std::string_view name, std::span<const std::string_view> vertices);

    /// A step has been handed on: its names and lists are given back, if nobody keeps them.
    void end_step() {
        if (!keeps_)
            arena_.clear();
    }

    template <typename Told, typename Step> Told step(const Step& step) {
        Told told;
        for_each_pair_of_fields(told, step,
                                [this](auto& to, const auto& from) { this->trace(to, from); });
        return told;
    }

private:
    void trace(Index& told, Index value) { told = value; }
    void trace(std::optional<Index>& told, std::optional<Index> value) { told = value; }
    void trace(TracedFlag& told, bool value) { told = TracedFlag(value); }
    void trace(TracedColor& told, Color value) { told = TracedColor(value); }
    void trace(TracedText& told, std::string_view name) { told = quoted(name, arena_); }
    void trace(TracedText& told, NameOfPrimitive /*name*/) { told = name_; }
    void trace(TracedText& told, EdgeName edge) { told = label(edge); }
    template <typename Enum> void trace(TracedWord<Enum>& told, Enum value) {
        told = TracedWord<Enum>(quoted_word_of(value));
    }
    void trace(TracedNumber& told, const Quantity& number);
    void trace(TracedNumber& told, std::same_as<Index> auto number) { told = TracedNumber(number); }
    template <typename Value, typename Field>
    void trace(TracedList<Value>& told, std::span<const Field> fields) {
        const std::span<Value> values = arena_.array<Value>(fields.size());
        for (std::size_t i = 0; i < fields.size(); ++i)
            trace(values[i], fields[i]);
        told = TracedList<Value>(std::span<const Value>(values));
    }
    template <typename Value, typename Field, std::size_t size>
    void trace(TracedList<Value>& told, const std::array<Field, size>& fields) {
        trace(told, std::span<const Field>(fields));
    }
    void trace(TracedList<TracedNumber>& told, const Vec<Quantity, 2>& at) {
        trace(told, std::array{at.x, at.y});
    }
    void trace(TracedList<TracedNumber>& told, const Vec<Quantity, 3>& at) {
        trace(told, std::array{at.x, at.y, at.z});
    }
    template <typename Told, typename Field>
    void trace(Told& told, const std::optional<Field>& field) {
        if (field)
            trace(told, *field);
    }
    template <typename Field> void trace(TracedNumber& told, const OrNull<Field>& field) {
        told = TracedNumber::null();
        if (field)
            trace(told, *field);
    }

    static TracedText quoted(std::string_view name, Arena& arena);
    TracedText label(EdgeName edge);

    /// For what the current primitive refers to.
    Arena& of_primitive() { return keeps_ ? arena_ : own_; }

    Arena& arena_;
    Arena own_; ///< of the primitive, if nobody keeps it
    bool keeps_;
    TracedText name_;                        ///< of the current primitive
    std::vector<std::string_view> vertices_; ///< its vertices' names
    std::vector<TracedText> labels_;         ///< its edges' names, those that were asked for
};

/// Which steps of a drawing are told.
class FilterOfSteps {
public:
    explicit FilterOfSteps(const StepFilter& filter);

    bool takes(StepKind kind) const { return kinds_[static_cast<std::size_t>(kind)]; }

    /// The primitive with this name begins.
    void begin(std::string_view name);
    void begin(const PrimitiveBegan<>& step) {
        begin(step.name);
        is_mirrored_ = step.radius.has_value();
    }

    template <typename Step> bool takes(const Step& step) const {
        return takes(Step::step_kind) && is_in_primitive_ && (!region_ || is_in_region(step));
    }

private:
    // A step of rows or pixels is told if these meet the region.
    template <typename Step> bool is_in_region(const Step& step) const {
        if constexpr (requires { step.pixel(); })
            return has(step.x, step.y);
        else
            return true;
    }
    bool is_in_region(const RowCrossed<>& step) const { return region_->has_row(step.y); }
    bool is_in_region(const ScanlineSpanned<>& step) const {
        return region_->has_row(step.y) && region_->meets(step.from, step.to);
    }
    bool is_in_region(const LineSampled<>& step) const {
        return has(step.x.value_or(step.pixel), step.y.value_or(step.pixel));
    }
    bool is_in_region(const LineDecided<>& step) const {
        return is_mirrored_ || has(step.x, step.y); // then it is about eight pixels
    }
    bool is_in_region(const PixelsRejected<>& step) const;
    bool has(Index x, Index y) const { return region_->has_row(y) && region_->meets(x, x); }

    std::array<bool, step_kinds> kinds_{};
    std::optional<Region> region_;
    std::optional<std::string> primitive_;
    bool is_in_primitive_;
    bool is_mirrored_ = false; ///< what is decided of one octant is drawn in all
};

template <typename To> class StepTracer {
public:
    StepTracer(To& to, Arena& arena, bool keeps, const StepFilter& filter = {})
        : to_(to), fields_(arena, keeps), filter_(filter) {}

    /// False for steps that the filter leaves out, whatever they say. Some say whose the others are.
    template <typename Step> bool takes() const {
        return Step::step_kind == StepKind::primitive || Step::step_kind == StepKind::undecided ||
               filter_.takes(Step::step_kind);
    }

    /// Any step of a drawing.
    template <template <typename> typename Step> void operator()(const Step<Quantity>& step) {
        if constexpr (std::same_as<Step<Quantity>, PrimitiveBegan<>>) {
            filter_.begin(step);
            fields_.begin(step.name, step.vertices);
            color_ = step.color;
        } else if constexpr (std::same_as<Step<Quantity>, BoundExceeded<>>) {
            filter_.begin(step.name);
        }
        if (!filter_.takes(step))
            return;
        auto told = fields_.template step<Step<TracedNumber>>(step);
        if constexpr (std::same_as<Step<Quantity>, PixelPlotted<>>)
            if (step.color == color_)
                told.color = {};
        to_.take(told);
        fields_.end_step();
    }

private:
    To& to_;
    FieldTracer fields_;
    FilterOfSteps filter_;
    Color color_; ///< of the current primitive
};

} // namespace rastertrace
