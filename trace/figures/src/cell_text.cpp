// SPDX-License-Identifier: MIT
// What is written in the pixels of a figure: numbers of their order, depths, writes, weights.

#include "panel.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string>

namespace rastertrace {

namespace {

constexpr double text_size = 9;
constexpr double line_height = 10;
constexpr std::size_t any_width = std::numeric_limits<std::size_t>::max();

/// The lines of each pixel, by its offset.
using CellTexts = std::map<std::size_t, std::vector<std::string>>;

/// The first pixel that was drawn has 1, the next one 2; a pixel drawn over keeps its last number.
void add_order(const Replay& replay, CellTexts& texts) {
    const Trace& trace = replay.trace();
    std::size_t number = 0;
    std::map<std::size_t, std::size_t> number_of;
    for (const std::size_t n : trace.steps_of({StepKind::pixel}, 1, replay.step())) {
        ++number;
        if (const auto pixel = pixel_of(trace, n))
            number_of[trace.canvas.offset_of(*pixel)] = number;
    }
    for (const auto& [offset, of_pixel] : number_of)
        texts[offset].push_back(std::to_string(of_pixel));
}

/// What a view of a terminal's frame would print, where it is not empty.
void add_view(View view, const Replay& replay, CellTexts& texts) {
    const FrameCells cells(view, replay, any_width);
    const Canvas& canvas = replay.trace().canvas;
    for (int row = 0; row < canvas.height; ++row)
        for (int column = 0; column < canvas.width; ++column) {
            const Pixel pixel{canvas.left() + column, canvas.y_of(row)};
            const Cell cell = cells.at(pixel);
            const std::size_t offset = canvas.offset_of(pixel);
            const auto& stored_by = replay.frame().stored_by;
            const bool is_empty = view == View::depth ? stored_by.empty() || stored_by[offset] == 0
                                                      : cell.text == ".";
            if (!is_empty)
                texts[offset].push_back(cell.text);
        }
}

/// The weights of each sample of the current primitive: each over the area, which all of them have.
void add_weights(const Replay& replay, CellTexts& texts) {
    const Trace& trace = replay.trace();
    for (const std::size_t n :
         trace.steps_of({StepKind::sample}, replay.primitive() + 1, replay.step())) {
        const auto pixel = pixel_of(trace, n);
        if (!pixel)
            continue;
        auto& lines = texts[trace.canvas.offset_of(*pixel)];
        for (const std::string& weight : trace.step(n).as<SampleStep>().weights.texts())
            lines.push_back(short_number(weight));
    }
}

/// What is told of each pixel that is drawn, and of the step that drew it.
template <typename Tell> void add_of_drawn(const Replay& replay, CellTexts& texts, Tell&& tell) {
    const auto& drawn_by = replay.frame().drawn_by;
    for (std::size_t offset = 0; offset < drawn_by.size(); ++offset)
        if (drawn_by[offset] != 0)
            tell(offset, drawn_by[offset], texts[offset]);
}

void add_owners(const Replay& replay, CellTexts& texts) {
    add_of_drawn(replay, texts, [&](std::size_t, std::size_t step, auto& lines) {
        if (const std::size_t primitive = replay.primitive_of(step); primitive != 0)
            lines.push_back(
                printable(name_of_face(replay.trace().step(primitive).as<PrimitiveStep>())));
    });
}

void add_levels(const Replay& replay, CellTexts& texts) {
    add_of_drawn(replay, texts, [&](std::size_t offset, std::size_t, auto& lines) {
        const Color color = replay.frame().image.colors()[offset];
        lines.push_back(std::to_string(color.red()));
        if (color.red() == color.green() && color.green() == color.blue())
            return;
        lines.push_back(std::to_string(color.green()));
        lines.push_back(std::to_string(color.blue()));
    });
}

CellTexts cell_texts(const Panel& panel, const FigureParts& parts) {
    const Replay& replay = panel.replay;
    CellTexts texts;
    if (parts.has(FigurePart::order))
        add_order(replay, texts);
    if (parts.has(FigurePart::depths))
        add_view(View::depth, replay, texts);
    if (parts.has(FigurePart::writes))
        add_view(View::writes, replay, texts);
    if (parts.has(FigurePart::weights))
        add_weights(replay, texts);
    if (parts.has(FigurePart::owners))
        add_owners(replay, texts);
    if (parts.has(FigurePart::levels))
        add_levels(replay, texts);
    return texts;
}

} // namespace

bool has_cell_texts(const FigureParts& parts) {
    constexpr std::array in_cells{FigurePart::order,   FigurePart::depths, FigurePart::writes,
                                  FigurePart::weights, FigurePart::owners, FigurePart::levels};
    return std::any_of(in_cells.begin(), in_cells.end(),
                       [&parts](FigurePart part) { return parts.has(part); });
}

double cell_for_texts(const Panel& panel, const FigureParts& parts) {
    constexpr double gap = 4;
    double side = 0;
    for (const auto& [offset, lines] : cell_texts(panel, parts)) {
        side = std::max(side, static_cast<double>(lines.size()) * line_height + gap);
        for (const std::string& line : lines)
            side = std::max(side, width_of(line, text_size) + gap);
    }
    return side;
}

void add_cell_texts(const Panel& panel, std::vector<Shape>& shapes) {
    const PixelColors color_of = own_colors_of(panel);
    CellTexts texts = cell_texts(panel, panel.parts);
    if (panel.against != nullptr && panel.lattice.cell > text_size)
        panel.for_each_pixel([&](Pixel, std::size_t offset) {
            const ComparisonMark* const mark = comparison_at(panel, offset);
            if (mark != nullptr && !mark->mark.empty())
                texts[offset].emplace_back(mark->mark);
        });
    panel.for_each_pixel([&](Pixel pixel, std::size_t offset) {
        const auto found = texts.find(offset);
        if (found == texts.end())
            return;
        std::optional<Color> color; // what can be read on a pixel that has a color of its own
        if (const Color own = color_of ? color_of(pixel, offset) : no_color; own != no_color)
            color = is_light(own) ? Color{0, 0, 0} : Color{255, 255, 255};
        const Place middle = panel.lattice.middle_of(pixel);
        double y = middle.y + 0.36 * text_size -
                   0.5 * line_height * static_cast<double>(found->second.size() - 1);
        for (const std::string& line : found->second) {
            shapes.push_back(Label{.role = Role::cell_text,
                                   .color = color,
                                   .at = {middle.x, y},
                                   .text = line,
                                   .size = text_size,
                                   .anchor = Anchor::middle,
                                   .has_rim = !color && panel.against == nullptr &&
                                              panel.parts.has(FigurePart::edges)});
            y += line_height;
        }
    });
}

} // namespace rastertrace
