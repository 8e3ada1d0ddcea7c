// SPDX-License-Identifier: MIT
#include "sheet_page.h"

#include "load.h"

#include <rastertrace/figures/figure.h>
#include <rastertrace/trace/check/claims_template.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace rastertrace {

namespace {

/// What a scene file gives: A (2, 5, 3); then camera: {position: [0, 0, 4], ...}. Empty if it is no JSON.
std::vector<std::string> given_in_scene(const Source& scene) {
    constexpr std::array keys{"model", "camera", "projection", "viewport", "light"};
    const auto document = parse_json(scene);
    if (!document)
        return {};
    const JsonValue root = document.value().root();
    std::vector<std::string> lines;
    if (const auto vertices = root.find("vertices"))
        for (const auto& [name, at] : vertices->members()) {
            std::vector<std::string> coordinates;
            for (const JsonValue& coordinate : at.elements())
                coordinates.push_back(coordinate.text);
            lines.push_back(fmt::format("{} ({})", name.text, joined(coordinates, ", ")));
        }
    for (const std::string key : keys)
        if (const auto value = root.find(key)) {
            std::string text = key + ": ";
            text += scene.view().substr(value->begin, value->end() - value->begin);
            std::erase(text, '"');
            lines.push_back(std::move(text));
        }
    return lines;
}

/// The vertices of a trace, where there is no scene: A (2, 5).
std::vector<std::string> given_in_trace(const Trace& trace) {
    std::vector<std::string> lines;
    std::set<std::string> known;
    const auto add = [&](const std::string& name, const std::vector<std::string>& at) {
        if (known.insert(name).second)
            lines.push_back(fmt::format("{} ({})", name, joined(at, ", ")));
    };
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const StepView step = trace.step(n);
        if (step.kind() == StepKind::vertex) {
            const auto vertex = step.as<VertexStep>();
            add(vertex.name.text(), vertex.at.texts());
        } else if (step.kind() == StepKind::primitive) {
            const auto primitive = step.as<PrimitiveStep>();
            const auto names = primitive.vertices.texts();
            const auto places = primitive.at.values();
            for (std::size_t i = 0; i < std::min(names.size(), places.size()); ++i)
                add(names[i], places[i].texts());
        }
    }
    return lines;
}

/// By which rules it is drawn: `method: fill scanline, rounding floor`. Who works by hand has exact numbers.
std::string method_of_sheet(const Trace& trace) {
    std::vector<std::string> rules;
    for (const auto& [key, value] : trace.method)
        if (key != "scalar")
            rules.push_back(fmt::format("{} {}", key, value));
    return "method: " + joined(rules, ", ");
}

std::vector<std::string> wrapped_lines(const std::vector<std::string>& lines) {
    constexpr std::size_t longest = 68;
    std::vector<std::string> all;
    for (const std::string& line : lines) {
        const auto parts = wrapped(line, longest);
        all.insert(all.end(), parts.begin(), parts.end());
    }
    return all;
}

/// The lines of a sheet as they are printed: what is given, and a rule to write on in place of each `?`. The picture is
/// the grid above them.
std::vector<std::string> printed_lines(const Trace& trace, const Source* scene) {
    std::vector<std::string> lines = scene ? given_in_scene(*scene) : std::vector<std::string>{};
    if (lines.empty())
        lines = given_in_trace(trace);
    lines.push_back(method_of_sheet(trace));
    lines = wrapped_lines(lines);
    lines.emplace_back();
    for (std::string line : split_at(claims_template(trace), '\n')) {
        if (line == "picture:")
            break;
        for (std::size_t at = line.find('?'); at != std::string::npos; at = line.find('?', at))
            line.replace(at, 1, "_______");
        lines.push_back(std::move(line));
    }
    while (!lines.empty() && lines.back().empty())
        lines.pop_back();
    return lines;
}

} // namespace

Drawing sheet_page(const Trace& trace, const Source* scene, const std::string& exercise) {
    FigureMaker maker(trace, {{.steps = {.first = 1, .last = 1}, .is_question = true}}, {});
    Drawing page = maker.figure(0);
    std::vector<std::string> lines = printed_lines(trace, scene);
    if (!exercise.empty())
        lines.insert(lines.begin(), fmt::format("exercise {}", exercise));
    constexpr double size = 12;
    constexpr double line_height = 22; // room for a hand
    constexpr double margin = 16;
    std::size_t longest = 1;
    for (const std::string& line : lines)
        longest = std::max(longest, columns_in(line));
    const double column_width = static_cast<double>(longest) * size * 0.62 + margin;
    // As many columns as the grid is wide; more, where the page would be much higher than wide.
    constexpr double highest = 1.4;
    const auto count = static_cast<double>(lines.size());
    const double columns =
        std::max(std::floor((page.width - margin) / column_width),
                 std::ceil(std::sqrt(count * line_height / column_width / highest)));
    const auto rows = static_cast<std::size_t>(std::ceil(count / columns));
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto column = static_cast<double>(i / rows);
        const auto row = static_cast<double>(i % rows);
        page.shapes.push_back(
            Label{.at = {margin + column * column_width, page.height + margin + row * line_height},
                  .text = printable(lines[i]),
                  .size = size,
                  .is_fixed_width = true});
    }
    page.width = std::max(page.width, 2 * margin + columns * column_width);
    page.height += 2 * margin + static_cast<double>(rows) * line_height;
    return page;
}

void refuse_filled_sheet(const std::string& path, std::string_view empty) {
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error) &&
        value_or_throw(read_named_file(path, {})).view() != empty)
        throw problem_of(path, "expected no sheet that has been filled in, found one",
                         "give -o another name, or remove the file");
}

} // namespace rastertrace
