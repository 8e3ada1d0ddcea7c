// SPDX-License-Identifier: MIT
#include "step_writer.h"

#include "traced_steps.h"

#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/primitive_name.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rastertrace {

namespace {

/// What the buffer holds before it is handed on.
constexpr std::size_t buffer_size = 256 * 1024;

} // namespace

NumberStyle number_style_of(const Method& method) {
    return method.scalar == ScalarKind::adaptive ? NumberStyle::doubles : NumberStyle::exact;
}

StepWriter::StepWriter(Output& output, TraceLayout layout, const StepFilter& filter,
                       NumberStyle numbers)
    : output_(output), buffer_(buffer_size),
      next_separator_(layout == TraceLayout::json ? ",\n" : "\n"), numbers_(numbers),
      region_(filter.region), primitive_(filter.primitive), is_in_primitive_(!filter.primitive) {
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
    const std::span vertices = std::span(vertices_).first(vertex_count_);
    const std::string_view separator = name_separator(vertices);
    std::array<std::string, most_vertices> quoted;
    for (std::size_t i = 0; i < vertices.size(); ++i)
        quoted[i] = json_quoted(vertices[i]);
    for (std::size_t from = 0; from < vertices.size(); ++from)
        for (std::size_t to = 0; to < vertices.size(); ++to) {
            // "A" and "B" become "AB": the inner quotes give way to the separator.
            std::string& label = labels_[from * most_vertices + to];
            label.assign(quoted[from], 0, quoted[from].size() - 1);
            label += separator;
            label.append(quoted[to], 1);
        }
    has_labels_ = true;
}

void StepWriter::begin_primitive_line(PrimitiveKind kind, std::string_view name,
                                      std::span<const std::string_view> vertices) {
    begin_line(StepKind::primitive);
    put(R"({"step":"primitive","kind":")", word_of(kind), R"(","name":)",
        std::string_view(json_quoted(name)), R"(,"vertices":[)");
    for (std::size_t i = 0; i < vertices.size(); ++i)
        put(std::string_view(i == 0 ? "" : ","), std::string_view(json_quoted(vertices[i])));
    put("]");
}

void StepWriter::end_primitive_line(const PrimitiveBegan<Quantity>& step) {
    put(R"(,"color":")", std::string_view(to_text(step.color)), "\"");
    for (std::size_t i = 0; i < step.colors.size(); ++i)
        put(std::string_view(i == 0 ? R"(,"colors":[")" : R"(,")"),
            std::string_view(to_text(step.colors[i])), "\"");
    if (!step.colors.empty())
        put("]");
    if (step.octant != 0)
        put(R"(,"octant":)", step.octant);
    if (step.is_part)
        put(R"(,"part":true)");
    if (!step.is_painted)
        put(R"(,"painted":false)");
    if (step.kind == PrimitiveKind::circle)
        put(R"(,"radius":)", step.radius);
    put("}");
}

/// The field that tells what a depth test was decided by, if not by the stored depth.
std::string_view StepWriter::field_of(DepthReason reason) {
    constexpr std::array<std::string_view, 4> names{"", "side_of", "beside", "behind"};
    return names[static_cast<std::size_t>(reason)];
}

void StepWriter::begin_vertex_line(std::string_view name, Space space) {
    begin_line(StepKind::vertex);
    put(R"({"step":"vertex","name":)", std::string_view(json_quoted(name)), R"(,"space":")",
        word_of(space), "\"");
}

void StepWriter::put_names(std::string_view key, std::span<const std::string_view> names) {
    std::string_view before = key;
    for (const std::string_view name : names) {
        put(before, std::string_view(json_quoted(name)));
        before = ",";
    }
    put("]");
}

void StepWriter::operator()(const FaceTriangulated<Quantity>& step) {
    if (!wants(StepKind::triangulate))
        return;
    begin_line(StepKind::triangulate);
    put(R"({"step":"triangulate","name":)", std::string_view(json_quoted(step.name)));
    put_names(R"(,"vertices":[)", step.vertices);
    // Who cuts the ears again has to know just where the corners are.
    std::string_view before = R"(,"at":[[)";
    for (const auto& corner : step.at) {
        put(before, Exactly{corner.x, true}, ",", Exactly{corner.y, true}, ",",
            Exactly{corner.z, true}, "]");
        before = ",[";
    }
    put(R"(],"normal":[)", Exactly{step.normal.x, true}, ",", Exactly{step.normal.y, true}, ",",
        Exactly{step.normal.z, true}, R"(],"drops":")", std::string_view(&step.dropped, 1), "\"");
    put_names(R"(,"ears":[)", step.ears);
    put("}");
}

void StepWriter::operator()(const PrimitiveClipped& step) {
    if (!wants(StepKind::clip))
        return;
    begin_line(StepKind::clip);
    put(R"({"step":"clip","name":)", std::string_view(json_quoted(step.name)), R"(,"plane":")",
        step.plane, R"(","inside":)");
    std::string_view before = "[";
    for (const bool is_inside : step.is_inside) {
        put(before, word(is_inside));
        before = ",";
    }
    put(R"(],"out":)", step.left, "}");
}

void StepWriter::put_colored_pixel(const PixelPlotted& step) {
    put(R"({"step":"pixel","x":)", step.pixel.x, R"(,"y":)", step.pixel.y, R"(,"color":")",
        std::string_view(to_text(step.color)), "\"}");
}

void StepWriter::operator()(const SideBegan& step) {
    if (!wants(StepKind::edge))
        return;
    begin_line(StepKind::edge);
    put(R"({"step":"edge","edge":)", label(step.edge), R"(,"octant":)", step.octant, "}");
}

void StepWriter::operator()(const HalfBegan& step) {
    if (!wants(StepKind::half))
        return;
    begin_line(StepKind::half);
    put(R"({"step":"half","half":")", std::string_view(step.is_upper ? "upper" : "lower"),
        R"(","from_y":)", step.from_y, R"(,"to_y":)", step.to_y, "}");
}

void StepWriter::operator()(const RayBegan& step) {
    if (!wants(StepKind::ray))
        return;
    begin_line(StepKind::ray);
    put(R"({"step":"ray","x":)", step.x, R"(,"y":)", step.y, "}");
}

void StepWriter::operator()(const LineDecided& step) {
    if (!wants(StepKind::decide) || !(is_circle_ || is_in_region(step.pixel)))
        return;
    begin_line(StepKind::decide);
    put(R"({"step":"decide","x":)", step.pixel.x, R"(,"y":)", step.pixel.y, R"(,"d":)", step.d,
        R"(,"move":")", word_of(step.move), "\"}");
}

void StepWriter::operator()(const PixelsRejected& step) {
    const auto [low_x, high_x] = std::minmax(step.from_x, step.to_x);
    const auto [low_y, high_y] = std::minmax(step.from_y, step.to_y);
    const bool meets_region = !region_ || (region_->meets(low_x, high_x) && low_y <= region_->y1 &&
                                           region_->y0 <= high_y);
    if (!wants(StepKind::reject) || !meets_region)
        return;
    begin_line(StepKind::reject);
    put(R"({"step":"reject","x":)", step.from_x);
    if (low_x != high_x || low_y != high_y)
        put(R"(,"to_x":)", step.to_x);
    put(R"(,"y":)", step.from_y);
    if (low_y != high_y)
        put(R"(,"to_y":)", step.to_y);
    put(R"(,"why":"off-canvas"})");
}

void StepWriter::operator()(const RowsRejected& step) {
    const Index low = std::min(step.from_y, step.to_y);
    const Index high = std::max(step.from_y, step.to_y);
    if (!wants(StepKind::reject) || (region_ && (high < region_->y0 || region_->y1 < low)))
        return;
    begin_line(StepKind::reject);
    put(R"({"step":"reject","y":)", step.from_y, R"(,"to_y":)", step.to_y,
        R"(,"why":"off-canvas"})");
}

void StepWriter::operator()(const PrimitiveSkipped& step) {
    if (!wants(StepKind::skip))
        return;
    begin_line(StepKind::skip);
    put(R"({"step":"skip","name":)", std::string_view(json_quoted(name_)), R"(,"why":")",
        word_of(step.why), "\"}");
}

void StepWriter::operator()(const BoundExceeded& step) {
    if (!wants(StepKind::undecided))
        return;
    begin_line(StepKind::undecided);
    // What has left the doubles has no difference to tell.
    if (std::isfinite(step.difference) && std::isfinite(step.error))
        put(R"({"step":"undecided","difference":)", step.difference, R"(,"error":)", step.error,
            "}");
    else
        put(R"({"step":"undecided"})");
}

} // namespace rastertrace
