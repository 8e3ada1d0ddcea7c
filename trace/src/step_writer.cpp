// SPDX-License-Identifier: MIT
#include <rastertrace/trace/step_writer.h>

#include <rastertrace/trace/color_text.h>
#include <rastertrace/trace/scene_file.h>
#include <rastertrace/trace/text.h>

#include <fmt/format.h>

#include <iterator>

namespace rastertrace {

namespace {

/// What the buffer holds before it is handed on.
constexpr std::size_t buffer_size = 256 * 1024;

std::string_view name_of(PrimitiveKind kind) {
    switch (kind) {
    case PrimitiveKind::triangle:
        break;
    }
    return "triangle";
}

std::string_view name_of(SkipReason reason) {
    switch (reason) {
    case SkipReason::off_canvas:
        return "off canvas";
    case SkipReason::between_rows:
        break;
    }
    return "between rows";
}

} // namespace

std::string json_quoted(std::string_view text) {
    std::string out = "\"";
    while (!text.empty()) {
        const CodePoint character = first_code_point(text);
        const std::string_view bytes = text.substr(0, character.length);
        if (bytes == "\"" || bytes == "\\")
            (out += '\\') += bytes;
        else if (bytes == "\n")
            out += "\\n";
        else if (bytes == "\t")
            out += "\\t";
        else if (character.value == not_a_character)
            out += "\\ufffd";
        else if (is_unsafe(character.value))
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(character.value));
        else
            out += bytes;
        text.remove_prefix(character.length);
    }
    return out += '"';
}

StepWriter::StepWriter(Output& output, TraceLayout layout, const StepFilter& filter)
    : output_(output), buffer_(buffer_size),
      next_separator_(layout == TraceLayout::json ? ",\n" : "\n"), region_(filter.region) {
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

void StepWriter::remember(std::span<const std::string_view> vertices, Color color) {
    color_ = color;
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
}

void StepWriter::begin_primitive_line(PrimitiveKind kind, std::string_view name,
                                      std::span<const std::string_view> vertices) {
    begin_line(StepKind::primitive);
    put(R"({"step":"primitive","kind":")", name_of(kind), R"(","name":)",
        std::string_view(json_quoted(name)), R"(,"vertices":[)");
    for (std::size_t i = 0; i < vertices.size(); ++i)
        put(std::string_view(i == 0 ? "" : ","), std::string_view(json_quoted(vertices[i])));
    put(R"(],"at":[)");
}

void StepWriter::end_primitive_line(Color color) {
    put(R"(],"color":")", std::string_view(to_text(color)), "\"}");
}

void StepWriter::put_colored_pixel(const PixelPlotted& step) {
    put(R"({"step":"pixel","x":)", step.pixel.x, R"(,"y":)", step.pixel.y, R"(,"color":")",
        std::string_view(to_text(step.color)), "\"}");
}

void StepWriter::operator()(const PixelsRejected& step) {
    if (!wants(StepKind::reject) || !is_in_region(step.y, step.from, step.to))
        return;
    begin_line(StepKind::reject);
    put(R"({"step":"reject","x":)", step.from, R"(,"to_x":)", step.to, R"(,"y":)", step.y,
        R"(,"why":"off-canvas"})");
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
    put(R"({"step":"skip","why":")", name_of(step.why), "\"}");
}

} // namespace rastertrace
