// SPDX-License-Identifier: MIT
#include "step_writer.h"

#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/primitive_name.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace rastertrace {

namespace {

/// What the buffer holds before it is handed on.
constexpr std::size_t buffer_size = 256 * 1024;

} // namespace

StepWriter::StepWriter(Output& output, TraceLayout layout, const StepFilter& filter)
    : output_(output), buffer_(buffer_size),
      next_separator_(layout == TraceLayout::json ? ",\n" : "\n"), region_(filter.region),
      primitive_(filter.primitive), is_in_primitive_(!filter.primitive) {
    wanted_.fill(!filter.only);
    if (filter.only)
        for (const StepKind kind : *filter.only)
            wanted_[static_cast<std::size_t>(kind)] = true;
}

void StepWriter::make_room(std::size_t size) {
    flush();
    if (buffer_.size() < size)
        buffer_.resize(size);
}

void StepWriter::flush() {
    output_.write({buffer_.data(), used_});
    used_ = 0;
}

void StepWriter::write_labels() {
    const std::size_t count = vertices_.size();
    const std::string_view separator = name_separator(vertices_);
    // The strings of the primitive before are used again.
    quoted_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::string& quoted = quoted_[i];
        quoted.resize(room_for_quoted(vertices_[i]));
        quoted.resize(
            static_cast<std::size_t>(write_quoted(quoted.data(), vertices_[i]) - quoted.data()));
    }
    labels_.resize(2 * count);
    for (std::size_t from = 0; from < count; ++from)
        for (const std::size_t to : {(from + 1) % count, (from + count - 1) % count}) {
            // "A" and "B" become "AB": the inner quotes give way to the separator.
            std::string& label = labels_[label_of(
                {static_cast<std::uint16_t>(from), static_cast<std::uint16_t>(to)})];
            label.assign(quoted_[from], 0, quoted_[from].size() - 1);
            label += separator;
            label.append(quoted_[to], 1);
        }
    has_labels_ = true;
}

namespace {

constexpr auto itself = [](const auto& value) -> const auto& {
    return value;
};

/// The value of a field that the step has only if `is_there`.
template <typename Value> const Value* only_if(bool is_there, const Value& value) {
    return is_there ? &value : nullptr;
}
template <typename Value> const Value* only_if(const std::optional<Value>& value) {
    return value ? &*value : nullptr;
}

} // namespace

void StepWriter::operator()(const FaceTriangulated<Quantity>& step) {
    if (!wants(StepKind::triangulate))
        return;
    const auto place = [](const Vec<Quantity, 3>& at) { return tuple(at.x, at.y, at.z); };
    put_step<TriangulateStep>(Quoted{step.name}, List{step.vertices, quoted}, List{step.at, place},
                              place(step.normal), Word{{&step.dropped, 1}},
                              List{step.ears, quoted});
}

void StepWriter::operator()(const MatrixSetUp<Quantity>& step) {
    if (!wants(StepKind::matrix))
        return;
    using Row = std::array<Quantity, 4>;
    const auto row = [](const Row& entries) {
        return tuple(entries[0], entries[1], entries[2], entries[3]);
    };
    std::vector<const Row*> rows_of_factors;
    for (const auto& factor : step.factors)
        for (const Row& one : factor.matrix.rows)
            rows_of_factors.push_back(&one);
    const Quoted object{step.object};
    put_step<MatrixStep>(
        Word{step.name}, only_if(!step.object.empty(), object), List{step.matrix.rows, row},
        ListIfAny{step.factors, [](const auto& factor) { return Word{factor.name}; }},
        ListIfAny{rows_of_factors, [&row](const Row* one) { return row(*one); }},
        ListIfAny{step.camera, [](const auto& at) { return tuple(at.x, at.y, at.z); }});
}

void StepWriter::operator()(const VertexPlaced<Quantity>& step) {
    if (!wants(StepKind::vertex))
        return;
    put_step<VertexStep>(Quoted{step.name}, Word{word_of(step.space)}, List{step.at, itself},
                         ListIfAny{step.snapped, itself});
}

void StepWriter::operator()(const PrimitivesOrdered<Quantity>& step) {
    if (!wants(StepKind::order))
        return;
    put_step<OrderStep>(
        List{step.names, quoted}, List{step.distances, itself},
        List{step.indices, [](std::size_t index) { return static_cast<std::int64_t>(index + 1); }});
}

void StepWriter::operator()(const PrimitiveBegan<Quantity>& step) {
    is_in_primitive_ = !primitive_ || is_part_of(step.name, *primitive_);
    color_ = step.color;
    name_ = step.name;
    vertices_.assign(step.vertices.begin(), step.vertices.end());
    has_labels_ = false;
    is_circle_ = step.kind == PrimitiveKind::circle;
    if (!wants(StepKind::primitive))
        return;
    const auto position = [](const Vec<Quantity, 2>& at) { return tuple(at.x, at.y); };
    const auto levels = [](const std::array<Quantity, 4>& of) {
        return tuple(of[0], of[1], of[2], of[3]);
    };
    const bool is_part = true;
    const bool is_painted = false;
    put_step<PrimitiveStep>(
        Word{word_of(step.kind)}, Quoted{step.name}, List{step.vertices, quoted},
        ListIfAny{step.positions, position}, ListIfAny{step.depths, itself}, ColorText(step.color),
        ListIfAny{step.colors, [](Color color) { return ColorText(color); }},
        ListIfAny{step.levels, levels}, only_if(step.octant != 0, step.octant),
        only_if(step.is_part, is_part), only_if(!step.is_painted, is_painted),
        only_if(is_circle_, step.radius), only_if(!step.face.empty(), Quoted{step.face}));
}

void StepWriter::operator()(const FaceTested<Quantity>& step) {
    if (!wants(StepKind::face))
        return;
    const Word light{"light"};
    put_step<FaceStep>(Quoted{name_}, tuple(step.normal.x, step.normal.y, step.normal.z),
                       tuple(step.view.x, step.view.y, step.view.z), step.dot,
                       OrNull{only_if(step.cosine)}, only_if(step.is_by_light, light),
                       step.is_culled, step.is_culled_opposite);
}

void StepWriter::operator()(const FaceLit<Quantity>& step) {
    if (!wants(StepKind::light))
        return;
    put_step<LightStep>(Quoted{name_}, tuple(step.normal.x, step.normal.y, step.normal.z),
                        tuple(step.light.x, step.light.y, step.light.z), step.dot, step.intensity,
                        ColorText(step.color));
}

void StepWriter::operator()(const PrimitiveClipped& step) {
    if (wants(StepKind::clip))
        put_step<ClipStep>(Quoted{step.name}, Word{step.plane}, List{step.is_inside, itself},
                           step.left);
}

void StepWriter::operator()(const EdgeSetUp<Quantity>& step) {
    if (wants(StepKind::edge))
        put_step<EdgeStep>(label(step.edge), OrNull{only_if(!step.is_horizontal, step.dx_dy)},
                           Absent(), Absent(), Absent(), Absent());
}

void StepWriter::operator()(const EdgeFunctionSetUp<Quantity>& step) {
    if (wants(StepKind::edge))
        put_step<EdgeStep>(label(step.edge), Absent(), step.a, step.b, step.is_top_left, Absent());
}

void StepWriter::operator()(const SideBegan& step) {
    if (wants(StepKind::edge))
        put_step<EdgeStep>(label(step.edge), Absent(), Absent(), Absent(), Absent(), step.octant);
}

void StepWriter::operator()(const HalfBegan& step) {
    if (wants(StepKind::half))
        put_step<HalfStep>(Word{step.is_upper ? "upper" : "lower"}, step.from_y, step.to_y);
}

void StepWriter::operator()(const RayBegan& step) {
    if (wants(StepKind::ray))
        put_step<RayStep>(step.x, step.y);
}

void StepWriter::operator()(const RowCrossed<Quantity>& step) {
    if (!wants(StepKind::crossings) || (region_ && !region_->has_row(step.y)))
        return;
    put_step<CrossingsStep>(step.y, List{step.edges, [this](EdgeName edge) { return label(edge); }},
                            List{step.x, itself},
                            List{step.winding, [](int number) { return std::int64_t{number}; }});
}

void StepWriter::operator()(const ScanlineSpanned<Quantity>& step) {
    if (!wants(StepKind::scanline) || !is_in_region(step.y, step.from, step.to))
        return;
    put_step<ScanlineStep>(step.y, step.left, step.right, step.from, step.to, label(step.left_edge),
                           label(step.right_edge), only_if(step.left_depth),
                           only_if(step.right_depth));
}

void StepWriter::operator()(const LineSampled<Quantity>& step) {
    if (!wants(StepKind::along) || !is_in_region(step))
        return;
    put_step<AlongStep>(only_if(step.is_x_major, step.at), only_if(!step.is_x_major, step.at),
                        step.value, step.pixel);
}

void StepWriter::operator()(const LineDecided& step) {
    if (wants(StepKind::decide) && (is_circle_ || is_in_region(step.pixel)))
        put_step<DecideStep>(step.pixel.x, step.pixel.y, step.d, Word{word_of(step.move)});
}

void StepWriter::operator()(const SampleTested<Quantity>& step) {
    if (!wants(StepKind::sample) || !is_in_region(step.pixel))
        return;
    const auto& [first, second, third] = step.weights;
    put_step<SampleStep>(step.pixel.x, step.pixel.y, tuple(first, second, third), step.is_inside);
}

void StepWriter::operator()(const DepthTested<Quantity>& step) {
    if (!wants(StepKind::depth) || !is_in_region(step.pixel))
        return;
    const Quoted other{step.other};
    const auto other_if = [&](DepthReason reason) { return only_if(step.reason == reason, other); };
    put_step<DepthStep>(step.pixel.x, step.pixel.y, step.depth, OrNull{only_if(step.stored)},
                        step.passes, other_if(DepthReason::side_of), other_if(DepthReason::beside),
                        other_if(DepthReason::behind));
}

void StepWriter::put_colored_pixel(const PixelPlotted& step) {
    put_step<PixelStep>(step.pixel.x, step.pixel.y, ColorText(step.color));
}

void StepWriter::operator()(const PixelsRejected& step) {
    const auto [low_x, high_x] = std::minmax(step.from_x, step.to_x);
    const auto [low_y, high_y] = std::minmax(step.from_y, step.to_y);
    const bool meets_region = !region_ || (region_->meets(low_x, high_x) && low_y <= region_->y1 &&
                                           region_->y0 <= high_y);
    if (!wants(StepKind::reject) || !meets_region)
        return;
    put_step<RejectStep>(&step.from_x, only_if(low_x != high_x || low_y != high_y, step.to_x),
                         &step.from_y, only_if(low_y != high_y, step.to_y), off_canvas);
}

void StepWriter::operator()(const RowsRejected& step) {
    const Index low = std::min(step.from_y, step.to_y);
    const Index high = std::max(step.from_y, step.to_y);
    if (wants(StepKind::reject) && (!region_ || (region_->y0 <= high && low <= region_->y1)))
        put_step<RejectStep>(Absent(), Absent(), step.from_y, step.to_y, off_canvas);
}

void StepWriter::operator()(const PrimitiveSkipped& step) {
    if (wants(StepKind::skip))
        put_step<SkipStep>(Quoted{name_}, Word{word_of(step.why)});
}

void StepWriter::operator()(const BoundExceeded& step) {
    // What has left the doubles has no difference to tell.
    const bool is_told = std::isfinite(step.difference) && std::isfinite(step.error);
    is_in_primitive_ = !primitive_ || is_part_of(step.name, *primitive_);
    if (wants(StepKind::undecided))
        put_step<UndecidedStep>(Quoted{step.name}, only_if(is_told, step.difference),
                                only_if(is_told, step.error));
}

} // namespace rastertrace
