// SPDX-License-Identifier: MIT
#pragma once

// The steps as a trace tells them: those of core/raster/steps.h, with what a trace holds in their fields. Reading, writing,
// conversion, comparison and tables follow their tables; what a step means is told in docs/trace-format.md.
//
//     const ScanlineStep row = trace.step(n).as<ScanlineStep>();
//     for (Index x = row.from; x <= row.to; ++x)
//         ...
//     row.left.text();   // "25/8"
//     row.left.exact();  // 25/8

#include "step_kind.h"
#include "traced_values.h"

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/steps.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace rastertrace {

template <> struct Held<TracedNumber> {
    using Name = TracedText;
    using NameOfPrimitive = TracedText;
    using Edge = TracedText;
    using Flag = TracedFlag;
    using Color = TracedColor;
    using Coordinate = Index;
    using Whole = TracedNumber;
    using Cosine = TracedNumber;
    template <typename Enum> using Word = TracedWord<Enum>;
    template <typename Value, std::size_t size> using Array = TracedList<Value>;
    template <std::size_t size> using Vector = TracedList<TracedNumber>;
    template <typename Value> using List = TracedList<Value>;
    template <typename Value>
    using Maybe = std::conditional_t<std::same_as<Value, Index>, std::optional<Index>, Value>;
    template <typename Value> using OrNull = Value;
};

using TriangulateStep = FaceTriangulated<TracedNumber>;
using MatrixStep = MatrixSetUp<TracedNumber>;
using VertexStep = VertexPlaced<TracedNumber>;
using OrderStep = PrimitivesOrdered<TracedNumber>;
using PrimitiveStep = PrimitiveBegan<TracedNumber>;
using FaceStep = FaceTested<TracedNumber>;
using LightStep = FaceLit<TracedNumber>;
using ClipStep = PrimitiveClipped<TracedNumber>;
using EdgeStep = EdgeSetUp<TracedNumber>;
using HalfStep = HalfBegan<TracedNumber>;
using RayStep = RayBegan<TracedNumber>;
using CrossingsStep = RowCrossed<TracedNumber>;
using ScanlineStep = ScanlineSpanned<TracedNumber>;
using AlongStep = LineSampled<TracedNumber>;
using DecideStep = LineDecided<TracedNumber>;
using SampleStep = SampleTested<TracedNumber>;
using DepthStep = DepthTested<TracedNumber>;
using PixelStep = PixelPlotted<TracedNumber>;
using RejectStep = PixelsRejected<TracedNumber>;
using SkipStep = PrimitiveSkipped<TracedNumber>;
using UndecidedStep = BoundExceeded<TracedNumber>;

/// A step of a known kind.
using AnyStep = AnyStepOf<TracedNumber>;

/// What a step begins with: this, the name of its kind, and a quotation mark.
inline constexpr std::string_view front_of_step = R"({"step":")";

/// What stands in front of a value: `,"left":`.
template <typename Row>
constexpr auto front_characters = [] {
    std::array<char, Row::name.size() + 4> front{',', '"'};
    char* const end = std::copy(Row::name.begin(), Row::name.end(), front.begin() + 2);
    end[0] = '"';
    end[1] = ':';
    return front;
}();
template <typename Row>
constexpr std::string_view front_of_field{front_characters<Row>.data(),
                                          front_characters<Row>.size()};

/// The name of the primitive that a part was cut from: ABC of ABC/1. Of one that is no part, its own.
std::string name_of_whole(const PrimitiveStep& primitive);

/// The face that a primitive is of: ABCD, of the triangles that it was cut into; else the whole primitive.
std::string name_of_face(const PrimitiveStep& primitive);

class StepView;

/// Fields that more than one kind has: of a step of whatever kind, also of one that nobody knows. Absent where it has
/// none.
TracedText name_in(const StepView& step);
std::optional<Index> x_in(const StepView& step);
std::optional<Index> y_in(const StepView& step);

/// The place in the program that drew it, `raster.cpp:120`, which any step of a foreign rasterizer may tell. It says
/// nothing of what was decided, and is never compared.
inline constexpr std::string_view key_of_code = "code";

} // namespace rastertrace
