// SPDX-License-Identifier: MIT
#pragma once

// The steps as a trace tells them: a struct for each kind, and beside it the table of its fields, in the order in which
// they are written. Reading, writing, conversion, comparison, tables and schema follow the table; what a step means is told in
// docs/trace-format.md, and where it comes from in core/raster/steps.h.
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
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace rastertrace {

/// A string that is known when the program is compiled.
template <std::size_t size> struct FixedString {
    consteval FixedString(const char (&literal)[size]) { // NOLINT: a literal is one
        std::copy(literal, literal + size, characters);
    }
    constexpr std::string_view view() const { return {characters, size - 1}; }

    char characters[size];
};

/// A row of a step's table.
template <FixedString key_of_field, auto member, FieldRole role_of_field, FieldNeed need_of_field>
struct FieldRow {
    static constexpr FixedString key = key_of_field;
    static constexpr std::string_view name = key.view();
    static constexpr FieldRole role = role_of_field;
    static constexpr FieldNeed need = need_of_field;

    /// What stands in front of its value: `,"left":`.
    static constexpr auto front_characters = [] {
        std::array<char, name.size() + 4> front{',', '"'};
        char* const end = std::copy(name.begin(), name.end(), front.begin() + 2);
        end[0] = '"';
        end[1] = ':';
        return front;
    }();
    static constexpr std::string_view front{front_characters.data(), front_characters.size()};

    /// The field of a step.
    static constexpr auto& in(auto& step) { return step.*member; }
};

template <typename... Rows> struct FieldTable {};

/// What a step begins with: this, the name of its kind, and a quotation mark.
inline constexpr std::string_view front_of_step = R"({"step":")";

/// The words of the tables.
namespace field {
using enum FieldNeed;
template <FixedString name, auto member, FieldNeed need = none>
using Key = FieldRow<name, member, FieldRole::key, need>;
template <FixedString name, auto member, FieldNeed need = none>
using Reason = FieldRow<name, member, FieldRole::reason, need>;
template <FixedString name, auto member, FieldNeed need = none>
using Decision = FieldRow<name, member, FieldRole::decision, need>;
template <FixedString name, auto member, FieldNeed need = none>
using Told = FieldRow<name, member, FieldRole::told, need>;
} // namespace field

/// A face that is not convex has been cut into triangles.
struct TriangulateStep {
    static constexpr StepKind step_kind = StepKind::triangulate;

    TracedText name = {};
    TracedList<TracedText> vertices = {};
    TracedList<TracedList<TracedNumber>> at = {};
    TracedList<TracedNumber> normal = {};
    TracedText drops = {};
    TracedList<TracedText> ears = {};

    using Fields = FieldTable<field::Key<"name", &TriangulateStep::name, field::required>,
                              field::Told<"vertices", &TriangulateStep::vertices>,
                              field::Reason<"at", &TriangulateStep::at>,
                              field::Reason<"normal", &TriangulateStep::normal>,
                              field::Decision<"drops", &TriangulateStep::drops>,
                              field::Decision<"ears", &TriangulateStep::ears>>;
};

/// A transform is set up.
struct MatrixStep {
    static constexpr StepKind step_kind = StepKind::matrix;

    TracedText name = {};
    TracedText object = {};
    TracedList<TracedList<TracedNumber>> rows = {};
    TracedList<TracedText> factors = {};
    TracedList<TracedList<TracedNumber>> factor_rows = {};
    TracedList<TracedList<TracedNumber>> camera = {};

    using Fields = FieldTable<field::Key<"name", &MatrixStep::name, field::required>,
                              field::Key<"object", &MatrixStep::object>,
                              field::Told<"rows", &MatrixStep::rows>,
                              field::Told<"factors", &MatrixStep::factors>,
                              field::Told<"factor_rows", &MatrixStep::factor_rows>,
                              field::Told<"camera", &MatrixStep::camera>>;
};

/// A vertex enters a space.
struct VertexStep {
    static constexpr StepKind step_kind = StepKind::vertex;

    TracedText name = {};
    TracedWord<Space> space = {};
    TracedList<TracedNumber> at = {};
    TracedList<TracedNumber> snapped = {};

    using Fields = FieldTable<field::Key<"name", &VertexStep::name, field::required>,
                              field::Key<"space", &VertexStep::space, field::required>,
                              field::Reason<"at", &VertexStep::at>,
                              field::Decision<"snapped", &VertexStep::snapped>>;
};

/// The painter has sorted the faces.
struct OrderStep {
    static constexpr StepKind step_kind = StepKind::order;

    TracedList<TracedText> names = {};
    TracedList<TracedNumber> distances = {};
    TracedList<TracedNumber> listed = {};

    using Fields = FieldTable<field::Decision<"names", &OrderStep::names>,
                              field::Reason<"distances", &OrderStep::distances>,
                              field::Told<"listed", &OrderStep::listed>>;
};

/// A primitive begins.
struct PrimitiveStep {
    static constexpr StepKind step_kind = StepKind::primitive;

    TracedWord<PrimitiveKind> kind = {};
    TracedText name = {};
    TracedList<TracedText> vertices = {};
    TracedList<TracedList<TracedNumber>> at = {};
    TracedList<TracedNumber> depths = {};
    TracedColor color = {};
    TracedList<TracedColor> colors = {};
    TracedList<TracedList<TracedNumber>> levels = {};
    std::optional<Index> octant = {};
    TracedFlag part = {};
    TracedFlag painted = {};
    std::optional<Index> radius = {};
    TracedText face = {};

    using Fields = FieldTable<
        field::Told<"kind", &PrimitiveStep::kind, field::required>,
        field::Key<"name", &PrimitiveStep::name, field::required>,
        field::Told<"vertices", &PrimitiveStep::vertices>, field::Reason<"at", &PrimitiveStep::at>,
        field::Reason<"depths", &PrimitiveStep::depths>,
        field::Told<"color", &PrimitiveStep::color>,
        field::Reason<"colors", &PrimitiveStep::colors>,
        field::Reason<"levels", &PrimitiveStep::levels>,
        field::Decision<"octant", &PrimitiveStep::octant>,
        field::Told<"part", &PrimitiveStep::part>, field::Told<"painted", &PrimitiveStep::painted>,
        field::Reason<"radius", &PrimitiveStep::radius>, field::Told<"face", &PrimitiveStep::face>>;
};

/// A face is tested.
struct FaceStep {
    static constexpr StepKind step_kind = StepKind::face;

    TracedText name = {};
    TracedList<TracedNumber> normal = {};
    TracedList<TracedNumber> view = {};
    TracedNumber dot = {};
    TracedNumber cosine = {};
    TracedText by = {};
    TracedFlag culled = {};
    TracedFlag opposite = {};

    using Fields =
        FieldTable<field::Key<"name", &FaceStep::name>, field::Reason<"normal", &FaceStep::normal>,
                   field::Reason<"view", &FaceStep::view>,
                   field::Reason<"dot", &FaceStep::dot, field::required>,
                   field::Told<"cosine", &FaceStep::cosine, field::or_null>,
                   field::Key<"by", &FaceStep::by>, field::Decision<"culled", &FaceStep::culled>,
                   field::Told<"opposite", &FaceStep::opposite>>;
};

/// A face is lit.
struct LightStep {
    static constexpr StepKind step_kind = StepKind::light;

    TracedText name = {};
    TracedList<TracedNumber> normal = {};
    TracedList<TracedNumber> light = {};
    TracedNumber dot = {};
    TracedNumber intensity = {};
    TracedColor color = {};

    using Fields =
        FieldTable<field::Key<"name", &LightStep::name>,
                   field::Reason<"normal", &LightStep::normal>,
                   field::Reason<"light", &LightStep::light>, field::Reason<"dot", &LightStep::dot>,
                   field::Told<"intensity", &LightStep::intensity, field::required>,
                   field::Decision<"color", &LightStep::color>>;
};

/// A primitive meets a plane with a vertex outside it.
struct ClipStep {
    static constexpr StepKind step_kind = StepKind::clip;

    TracedText name = {};
    TracedText plane = {};
    TracedList<TracedFlag> inside = {};
    std::optional<Index> out = {};

    using Fields = FieldTable<
        field::Key<"name", &ClipStep::name>, field::Key<"plane", &ClipStep::plane, field::required>,
        field::Decision<"inside", &ClipStep::inside>, field::Decision<"out", &ClipStep::out>>;
};

/// An edge is set up, by its slope or as a function; or a side is about to be drawn.
struct EdgeStep {
    static constexpr StepKind step_kind = StepKind::edge;

    TracedText edge = {};
    TracedNumber dx_dy = {};
    TracedNumber a = {};
    TracedNumber b = {};
    TracedFlag top_left = {};
    std::optional<Index> octant = {};

    using Fields = FieldTable<field::Key<"edge", &EdgeStep::edge, field::required>,
                              field::Reason<"dx_dy", &EdgeStep::dx_dy, field::or_null>,
                              field::Reason<"a", &EdgeStep::a>, field::Reason<"b", &EdgeStep::b>,
                              field::Decision<"top_left", &EdgeStep::top_left>,
                              field::Decision<"octant", &EdgeStep::octant>>;
};

/// A half of a `two-halves` fill begins.
struct HalfStep {
    static constexpr StepKind step_kind = StepKind::half;

    TracedText half = {};
    std::optional<Index> from_y = {};
    std::optional<Index> to_y = {};

    using Fields = FieldTable<field::Key<"half", &HalfStep::half, field::required>,
                              field::Decision<"from_y", &HalfStep::from_y>,
                              field::Decision<"to_y", &HalfStep::to_y>>;
};

/// A line of the fan begins.
struct RayStep {
    static constexpr StepKind step_kind = StepKind::ray;

    Index x = 0;
    Index y = 0;

    using Fields = FieldTable<field::Key<"x", &RayStep::x, field::required>,
                              field::Key<"y", &RayStep::y, field::required>>;
};

/// A row of a polygon meets its edges, from left to right.
struct CrossingsStep {
    static constexpr StepKind step_kind = StepKind::crossings;

    Index y = 0;
    TracedList<TracedText> edges = {};
    TracedList<TracedNumber> x = {};
    TracedList<TracedNumber> winding = {};

    using Fields = FieldTable<field::Key<"y", &CrossingsStep::y, field::required>,
                              field::Reason<"edges", &CrossingsStep::edges>,
                              field::Reason<"x", &CrossingsStep::x>,
                              field::Decision<"winding", &CrossingsStep::winding>>;
};

/// The two ends of a row are known, or of one of the spans of a polygon.
struct ScanlineStep {
    static constexpr StepKind step_kind = StepKind::scanline;

    Index y = 0;
    TracedNumber left = {};
    TracedNumber right = {};
    Index from = 0;
    Index to = 0;
    TracedText left_edge = {};
    TracedText right_edge = {};
    TracedNumber left_depth = {};
    TracedNumber right_depth = {};

    using Fields = FieldTable<field::Key<"y", &ScanlineStep::y, field::required>,
                              field::Reason<"left", &ScanlineStep::left, field::required>,
                              field::Reason<"right", &ScanlineStep::right, field::required>,
                              field::Decision<"from", &ScanlineStep::from, field::required>,
                              field::Decision<"to", &ScanlineStep::to, field::required>,
                              field::Reason<"left_edge", &ScanlineStep::left_edge>,
                              field::Reason<"right_edge", &ScanlineStep::right_edge>,
                              field::Reason<"left_depth", &ScanlineStep::left_depth>,
                              field::Reason<"right_depth", &ScanlineStep::right_depth>>;
};

/// A `naive`, `dda` or `diamond-exit` line is at a step of its major axis: it tells x if that is it, else y.
struct AlongStep {
    static constexpr StepKind step_kind = StepKind::along;

    std::optional<Index> x = {};
    std::optional<Index> y = {};
    TracedNumber value = {};
    Index pixel = 0;

    using Fields = FieldTable<field::Key<"x", &AlongStep::x>, field::Key<"y", &AlongStep::y>,
                              field::Reason<"value", &AlongStep::value, field::required>,
                              field::Decision<"pixel", &AlongStep::pixel, field::required>>;
};

/// Bresenham chooses.
struct DecideStep {
    static constexpr StepKind step_kind = StepKind::decide;

    Index x = 0;
    Index y = 0;
    TracedNumber d = {};
    TracedWord<Move> move = {};

    using Fields = FieldTable<field::Key<"x", &DecideStep::x, field::required>,
                              field::Key<"y", &DecideStep::y, field::required>,
                              field::Reason<"d", &DecideStep::d, field::required>,
                              field::Decision<"move", &DecideStep::move, field::required>>;
};

/// `barycentric` tests a pixel.
struct SampleStep {
    static constexpr StepKind step_kind = StepKind::sample;

    Index x = 0;
    Index y = 0;
    TracedList<TracedNumber> weights = {};
    TracedFlag inside = {};

    using Fields = FieldTable<field::Key<"x", &SampleStep::x, field::required>,
                              field::Key<"y", &SampleStep::y, field::required>,
                              field::Reason<"weights", &SampleStep::weights>,
                              field::Decision<"inside", &SampleStep::inside>>;
};

/// A pixel meets the depth buffer.
struct DepthStep {
    static constexpr StepKind step_kind = StepKind::depth;

    Index x = 0;
    Index y = 0;
    TracedNumber depth = {};
    TracedNumber stored = {};
    TracedFlag pass = {};
    TracedText side_of = {};
    TracedText beside = {};
    TracedText behind = {};

    using Fields = FieldTable<
        field::Key<"x", &DepthStep::x, field::required>,
        field::Key<"y", &DepthStep::y, field::required>,
        field::Reason<"depth", &DepthStep::depth, field::required>,
        field::Reason<"stored", &DepthStep::stored, field::or_null>,
        field::Decision<"pass", &DepthStep::pass>, field::Reason<"side_of", &DepthStep::side_of>,
        field::Reason<"beside", &DepthStep::beside>, field::Reason<"behind", &DepthStep::behind>>;
};

/// A pixel is plotted.
struct PixelStep {
    static constexpr StepKind step_kind = StepKind::pixel;

    Index x = 0;
    Index y = 0;
    TracedColor color = {};

    using Fields = FieldTable<field::Key<"x", &PixelStep::x, field::required>,
                              field::Key<"y", &PixelStep::y, field::required>,
                              field::Decision<"color", &PixelStep::color>>;
};

/// Pixels are dropped: one, a run of them, or whole rows.
struct RejectStep {
    static constexpr StepKind step_kind = StepKind::reject;

    std::optional<Index> x = {};
    std::optional<Index> to_x = {};
    std::optional<Index> y = {};
    std::optional<Index> to_y = {};
    TracedText why = {};

    using Fields =
        FieldTable<field::Key<"x", &RejectStep::x>, field::Key<"to_x", &RejectStep::to_x>,
                   field::Key<"y", &RejectStep::y>, field::Key<"to_y", &RejectStep::to_y>,
                   field::Decision<"why", &RejectStep::why, field::required>>;
};

/// A primitive draws nothing.
struct SkipStep {
    static constexpr StepKind step_kind = StepKind::skip;

    TracedText name = {};
    TracedWord<SkipReason> why = {};

    using Fields = FieldTable<field::Key<"name", &SkipStep::name>,
                              field::Decision<"why", &SkipStep::why, field::required>>;
};

/// With `adaptive`: intervals of doubles leave a decision about a primitive open. It begins next.
struct UndecidedStep {
    static constexpr StepKind step_kind = StepKind::undecided;

    TracedText name = {};
    TracedNumber difference = {};
    TracedNumber error = {};

    using Fields = FieldTable<field::Key<"name", &UndecidedStep::name>,
                              field::Reason<"difference", &UndecidedStep::difference>,
                              field::Reason<"error", &UndecidedStep::error>>;
};

/// A step of a known kind.
using AnyStep = std::variant<TriangulateStep, MatrixStep, VertexStep, OrderStep, PrimitiveStep,
                             FaceStep, LightStep, ClipStep, EdgeStep, HalfStep, RayStep,
                             CrossingsStep, ScanlineStep, AlongStep, DecideStep, SampleStep,
                             DepthStep, PixelStep, RejectStep, SkipStep, UndecidedStep>;

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
TracedText code_in(const StepView& step);

} // namespace rastertrace
