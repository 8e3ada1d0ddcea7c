// SPDX-License-Identifier: MIT
#include "step_tracer.h"

#include "step_writer.h"
#include "steps.h"

#include <rastertrace/trace/text/primitive_name.h>
#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <type_traits>

namespace rastertrace {

namespace {

/// The words of an enumeration in quotation marks.
template <typename Enum, std::size_t count> const std::array<std::string, count>& words_of() {
    static const std::array<std::string, count> words = [] {
        std::array<std::string, count> quoted;
        for (std::size_t i = 0; i < count; ++i)
            quoted[i] = "\"" + std::string(word_of(static_cast<Enum>(i))) + "\"";
        return quoted;
    }();
    return words;
}
template <std::size_t count, typename Enum> TracedWord<Enum> word(Enum value) {
    return TracedWord<Enum>(words_of<Enum, count>()[static_cast<std::size_t>(value)]);
}
constexpr std::size_t spaces = 6;
constexpr std::size_t moves = 8;
constexpr std::size_t skip_reasons = 10;

TracedText text(std::string_view quoted) {
    return TracedText(quoted);
}

const TracedText off_canvas = text("\"off-canvas\"");

/// A value that the step has only if `is_there`.
template <typename Value> Value only_if(bool is_there, const Value& value) {
    return is_there ? value : Value();
}
std::optional<Index> index_if(bool is_there, Index index) {
    return is_there ? std::optional(index) : std::nullopt;
}

/// ABC/1 is a part of ABC.
bool is_part_of(std::string_view name, std::string_view whole) {
    return name.starts_with(whole) && (name.size() == whole.size() || name[whole.size()] == '/');
}

} // namespace

template <typename To>
StepTracer<To>::StepTracer(To& to, Arena& arena, bool keeps, const StepFilter& filter)
    : to_(to), arena_(arena), keeps_(keeps), region_(filter.region), primitive_(filter.primitive),
      is_in_primitive_(!filter.primitive), of_primitive_(arena.mark()) {
    wanted_.fill(!filter.only);
    if (filter.only)
        for (const StepKind kind : *filter.only)
            wanted_[static_cast<std::size_t>(kind)] = true;
}

template <typename To>
void StepTracer<To>::begin_primitive(std::string_view name,
                                     std::span<const std::string_view> vertices) {
    is_in_primitive_ = !primitive_ || is_part_of(name, *primitive_);
    if (!keeps_)
        arena_.rewind({});
    name_ = quoted(name);
    vertices_.assign(vertices.begin(), vertices.end());
    labels_.clear();
    of_primitive_ = arena_.mark();
}

template <typename To> void StepTracer<To>::write_labels() {
    const std::size_t count = vertices_.size();
    const std::string_view separator = name_separator(vertices_);
    std::string label;
    for (std::size_t from = 0; from < count; ++from)
        for (const std::size_t to : {(from + 1) % count, (from + count - 1) % count}) {
            label.assign(vertices_[from]).append(separator).append(vertices_[to]);
            labels_.push_back(quoted(label));
        }
    of_primitive_ = arena_.mark();
}

/// The name of an edge of the current primitive: from each vertex there is the way to the next one, and back to the one
/// before. To be asked for before anything else of the step takes room.
template <typename To> TracedText StepTracer<To>::label(EdgeName edge) {
    if (labels_.empty())
        write_labels();
    const bool leads_on =
        edge.to == edge.from + 1 || (edge.to == 0 && edge.from + 1U == vertices_.size());
    const std::size_t number = 2U * edge.from + (leads_on ? 0 : 1);
    return number < labels_.size() ? labels_[number] : TracedText("\"\"");
}

template <typename To> TracedText StepTracer<To>::quoted(std::string_view name) {
    const auto is_plain = [](char c) { return ' ' <= c && c <= '~' && c != '"' && c != '\\'; };
    if (std::all_of(name.begin(), name.end(), is_plain)) { // nearly always
        const std::span<char> room = arena_.array<char>(name.size() + 2);
        room.front() = room.back() = '"';
        std::copy(name.begin(), name.end(), room.begin() + 1);
        return TracedText({room.data(), room.size()});
    }
    std::string text(room_for_quoted(name), '\0');
    const char* const end = write_quoted(text.data(), name);
    return TracedText(arena_.copy({text.data(), static_cast<std::size_t>(end - text.data())}));
}

template <typename To> TracedNumber StepTracer<To>::number(const Quantity& quantity) {
    return quantity.visit([this]<typename Number>(const Number& number) {
        if constexpr (std::is_same_v<Number, Rational>) {
            return TracedNumber(arena_.copy("\"" + number.get_str() + "\""));
        } else if constexpr (std::is_floating_point_v<Number>) {
            if (!std::isfinite(number))
                refuse_to_format(static_cast<double>(number));
            return TracedNumber(number);
        } else {
            const Index divisor = std::gcd(number.numerator, number.denominator);
            const Index denominator = number.denominator / divisor;
            if (denominator <= std::numeric_limits<std::uint32_t>::max())
                return TracedNumber(number.numerator / divisor,
                                    static_cast<std::uint32_t>(denominator));
            std::array<char, room_for(Fraction64{})> text{};
            const char* const end = format_number(text.data(), number);
            return TracedNumber(
                arena_.copy({text.data(), static_cast<std::size_t>(end - text.data())}));
        }
    });
}

template <typename To>
template <typename Value, typename Range, typename Make>
TracedList<Value> StepTracer<To>::list(const Range& range, const Make& value_of) {
    const std::span<Value> values = arena_.array<Value>(std::size(range));
    std::size_t i = 0;
    for (const auto& one : range)
        values[i++] = value_of(one);
    return TracedList<Value>(std::span<const Value>(values));
}

template <typename To>
TracedList<TracedNumber> StepTracer<To>::numbers(std::span<const Quantity> quantities) {
    return list<TracedNumber>(quantities, [this](const Quantity& one) { return number(one); });
}

template <typename To>
TracedList<TracedNumber> StepTracer<To>::vector(const Vec<Quantity, 2>& vector) {
    const std::span<TracedNumber> values = arena_.array<TracedNumber>(2);
    values[0] = number(vector.x);
    values[1] = number(vector.y);
    return TracedList<TracedNumber>(values);
}
template <typename To>
TracedList<TracedNumber> StepTracer<To>::vector(const Vec<Quantity, 3>& vector) {
    const std::span<TracedNumber> values = arena_.array<TracedNumber>(3);
    values[0] = number(vector.x);
    values[1] = number(vector.y);
    values[2] = number(vector.z);
    return TracedList<TracedNumber>(values);
}

template <typename To>
TracedList<TracedText> StepTracer<To>::names(std::span<const std::string_view> names) {
    return list<TracedText>(names, [this](std::string_view name) { return quoted(name); });
}

template <typename To> void StepTracer<To>::operator()(const FaceTriangulated<Quantity>& step) {
    if (!wants(StepKind::triangulate))
        return;
    const auto place = [this](const Vec<Quantity, 3>& at) { return vector(at); };
    tell(TriangulateStep{.name = quoted(step.name),
                         .vertices = names(step.vertices),
                         .at = list<TracedList<TracedNumber>>(step.at, place),
                         .normal = vector(step.normal),
                         .drops = quoted({&step.dropped, 1}),
                         .ears = names(step.ears)});
}

template <typename To> void StepTracer<To>::operator()(const MatrixSetUp<Quantity>& step) {
    if (!wants(StepKind::matrix))
        return;
    using Rows = TracedList<TracedList<TracedNumber>>;
    using Row = std::array<Quantity, 4>;
    const auto row = [this](const Row& entries) { return numbers(entries); };
    std::vector<Row> rows_of_factors;
    for (const auto& factor : step.factors)
        for (const Row& one : factor.matrix.rows)
            rows_of_factors.push_back(one);
    const bool has_factors = !step.factors.empty();
    const auto place = [this](const Vec<Quantity, 3>& at) { return vector(at); };
    const auto name = [this](const auto& factor) { return quoted(factor.name); };
    tell(MatrixStep{.name = quoted(step.name),
                    .object = only_if(!step.object.empty(), quoted(step.object)),
                    .rows = list<TracedList<TracedNumber>>(step.matrix.rows, row),
                    .factors = only_if(has_factors, list<TracedText>(step.factors, name)),
                    .factor_rows = only_if(
                        has_factors, Rows(list<TracedList<TracedNumber>>(rows_of_factors, row))),
                    .camera = only_if(!step.camera.empty(),
                                      Rows(list<TracedList<TracedNumber>>(step.camera, place)))});
}

template <typename To> void StepTracer<To>::operator()(const VertexPlaced<Quantity>& step) {
    if (wants(StepKind::vertex))
        tell(VertexStep{.name = quoted(step.name),
                        .space = word<spaces>(step.space),
                        .at = numbers(step.at),
                        .snapped = only_if(!step.snapped.empty(), numbers(step.snapped))});
}

template <typename To> void StepTracer<To>::operator()(const PrimitivesOrdered<Quantity>& step) {
    if (!wants(StepKind::order))
        return;
    const auto listed = [](std::size_t index) {
        return TracedNumber(static_cast<Index>(index + 1));
    };
    tell(OrderStep{.names = names(step.names),
                   .distances = numbers(step.distances),
                   .listed = list<TracedNumber>(step.indices, listed)});
}

template <typename To> void StepTracer<To>::operator()(const PrimitiveBegan<Quantity>& step) {
    begin_primitive(step.name, step.vertices);
    color_ = step.color;
    is_circle_ = step.kind == PrimitiveKind::circle;
    if (!wants(StepKind::primitive))
        return;
    const auto position = [this](const Vec<Quantity, 2>& at) { return vector(at); };
    const auto levels = [this](const std::array<Quantity, 4>& of) { return numbers(of); };
    const auto color = [](Color of) { return TracedColor(of); };
    tell(PrimitiveStep{
        .kind = word<all_primitives.size()>(step.kind),
        .name = name_,
        .vertices = names(step.vertices),
        .at = only_if(!step.positions.empty(),
                      list<TracedList<TracedNumber>>(step.positions, position)),
        .depths = only_if(!step.depths.empty(), numbers(step.depths)),
        .color = TracedColor(step.color),
        .colors = only_if(!step.colors.empty(), list<TracedColor>(step.colors, color)),
        .levels =
            only_if(!step.levels.empty(), list<TracedList<TracedNumber>>(step.levels, levels)),
        .octant = index_if(step.octant != 0, step.octant),
        .part = only_if(step.is_part, TracedFlag(true)),
        .painted = only_if(!step.is_painted, TracedFlag(false)),
        .radius = index_if(is_circle_, step.radius),
        .face = only_if(!step.face.empty(), quoted(step.face))});
}

template <typename To> void StepTracer<To>::operator()(const FaceTested<Quantity>& step) {
    if (wants(StepKind::face))
        tell(FaceStep{.name = name_,
                      .normal = vector(step.normal),
                      .view = vector(step.view),
                      .dot = number(step.dot),
                      .cosine = step.cosine ? number(*step.cosine) : TracedNumber::null(),
                      .by = only_if(step.is_by_light, text("\"light\"")),
                      .culled = TracedFlag(step.is_culled),
                      .opposite = TracedFlag(step.is_culled_opposite)});
}

template <typename To> void StepTracer<To>::operator()(const FaceLit<Quantity>& step) {
    if (wants(StepKind::light))
        tell(LightStep{.name = name_,
                       .normal = vector(step.normal),
                       .light = vector(step.light),
                       .dot = number(step.dot),
                       .intensity = number(step.intensity),
                       .color = TracedColor(step.color)});
}

template <typename To> void StepTracer<To>::operator()(const PrimitiveClipped& step) {
    if (wants(StepKind::clip))
        tell(ClipStep{.name = quoted(step.name),
                      .plane = quoted(step.plane),
                      .inside = list<TracedFlag>(step.is_inside,
                                                 [](bool inside) { return TracedFlag(inside); }),
                      .out = step.left});
}

template <typename To> void StepTracer<To>::operator()(const EdgeSetUp<Quantity>& step) {
    if (wants(StepKind::edge))
        tell(EdgeStep{.edge = label(step.edge),
                      .dx_dy = step.is_horizontal ? TracedNumber::null() : number(step.dx_dy)});
}

template <typename To> void StepTracer<To>::operator()(const EdgeFunctionSetUp<Quantity>& step) {
    if (wants(StepKind::edge))
        tell(EdgeStep{.edge = label(step.edge),
                      .a = number(step.a),
                      .b = number(step.b),
                      .top_left = TracedFlag(step.is_top_left)});
}

template <typename To> void StepTracer<To>::operator()(const SideBegan& step) {
    if (wants(StepKind::edge))
        tell(EdgeStep{.edge = label(step.edge), .octant = step.octant});
}

template <typename To> void StepTracer<To>::operator()(const HalfBegan& step) {
    if (wants(StepKind::half))
        tell(HalfStep{.half = text(step.is_upper ? "\"upper\"" : "\"lower\""),
                      .from_y = step.from_y,
                      .to_y = step.to_y});
}

template <typename To> void StepTracer<To>::operator()(const RayBegan& step) {
    if (wants(StepKind::ray))
        tell(RayStep{.x = step.x, .y = step.y});
}

template <typename To> void StepTracer<To>::operator()(const RowCrossed<Quantity>& step) {
    if (!wants(StepKind::crossings) || (region_ && !region_->has_row(step.y)))
        return;
    label({}); // before the lists take room
    tell(CrossingsStep{
        .y = step.y,
        .edges = list<TracedText>(step.edges, [this](EdgeName edge) { return label(edge); }),
        .x = numbers(step.x),
        .winding = list<TracedNumber>(step.winding,
                                      [](int winding) { return TracedNumber(Index{winding}); })});
}

template <typename To> void StepTracer<To>::operator()(const ScanlineSpanned<Quantity>& step) {
    if (!wants(StepKind::scanline) || !is_in_region(step.y, step.from, step.to))
        return;
    const TracedText left_edge = label(step.left_edge);
    const auto depth = [this](const auto& of) { return of ? number(*of) : TracedNumber(); };
    tell(ScanlineStep{.y = step.y,
                      .left = number(step.left),
                      .right = number(step.right),
                      .from = step.from,
                      .to = step.to,
                      .left_edge = left_edge,
                      .right_edge = label(step.right_edge),
                      .left_depth = depth(step.left_depth),
                      .right_depth = depth(step.right_depth)});
}

template <typename To> void StepTracer<To>::operator()(const LineSampled<Quantity>& step) {
    const bool is_in = step.is_x_major ? is_in_region(step.pixel, step.at, step.at)
                                       : is_in_region(step.at, step.pixel, step.pixel);
    if (wants(StepKind::along) && is_in)
        tell(AlongStep{.x = index_if(step.is_x_major, step.at),
                       .y = index_if(!step.is_x_major, step.at),
                       .value = number(step.value),
                       .pixel = step.pixel});
}

template <typename To> void StepTracer<To>::operator()(const LineDecided& step) {
    if (wants(StepKind::decide) && (is_circle_ || is_in_region(step.pixel)))
        tell(DecideStep{.x = step.pixel.x,
                        .y = step.pixel.y,
                        .d = TracedNumber(Index{step.d}),
                        .move = word<moves>(step.move)});
}

template <typename To> void StepTracer<To>::operator()(const SampleTested<Quantity>& step) {
    if (wants(StepKind::sample) && is_in_region(step.pixel))
        tell(SampleStep{.x = step.pixel.x,
                        .y = step.pixel.y,
                        .weights = numbers(step.weights),
                        .inside = TracedFlag(step.is_inside)});
}

template <typename To> void StepTracer<To>::operator()(const DepthTested<Quantity>& step) {
    if (!wants(StepKind::depth) || !is_in_region(step.pixel))
        return;
    const auto other_if = [&](DepthReason reason) {
        return step.reason == reason ? quoted(step.other) : TracedText();
    };
    tell(DepthStep{.x = step.pixel.x,
                   .y = step.pixel.y,
                   .depth = number(step.depth),
                   .stored = step.stored ? number(*step.stored) : TracedNumber::null(),
                   .pass = TracedFlag(step.passes),
                   .side_of = other_if(DepthReason::side_of),
                   .beside = other_if(DepthReason::beside),
                   .behind = other_if(DepthReason::behind)});
}

template <typename To> void StepTracer<To>::operator()(const PixelsRejected& step) {
    const auto [low_x, high_x] = std::minmax(step.from_x, step.to_x);
    const auto [low_y, high_y] = std::minmax(step.from_y, step.to_y);
    const bool meets_region = !region_ || (region_->meets(low_x, high_x) && low_y <= region_->y1 &&
                                           region_->y0 <= high_y);
    if (wants(StepKind::reject) && meets_region)
        tell(RejectStep{.x = step.from_x,
                        .to_x = index_if(low_x != high_x || low_y != high_y, step.to_x),
                        .y = step.from_y,
                        .to_y = index_if(low_y != high_y, step.to_y),
                        .why = off_canvas});
}

template <typename To> void StepTracer<To>::operator()(const RowsRejected& step) {
    const auto [low, high] = std::minmax(step.from_y, step.to_y);
    if (wants(StepKind::reject) && (!region_ || (region_->y0 <= high && low <= region_->y1)))
        tell(RejectStep{.y = step.from_y, .to_y = step.to_y, .why = off_canvas});
}

template <typename To> void StepTracer<To>::operator()(const PrimitiveSkipped& step) {
    if (wants(StepKind::skip))
        tell(SkipStep{.name = name_, .why = word<skip_reasons>(step.why)});
}

template <typename To> void StepTracer<To>::operator()(const BoundExceeded& step) {
    // What has left the doubles has no difference to tell.
    const bool is_told = std::isfinite(step.difference) && std::isfinite(step.error);
    is_in_primitive_ = !primitive_ || is_part_of(step.name, *primitive_);
    if (wants(StepKind::undecided))
        tell(UndecidedStep{.name = quoted(step.name),
                           .difference = only_if(is_told, TracedNumber(step.difference)),
                           .error = only_if(is_told, TracedNumber(step.error))});
}

template class StepTracer<Steps>;
template class StepTracer<StepWriter>;

} // namespace rastertrace
