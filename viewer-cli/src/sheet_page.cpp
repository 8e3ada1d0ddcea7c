// SPDX-License-Identifier: MIT
#include "sheet_page.h"

#include <rastertrace/figures/figure.h>
#include <rastertrace/trace/check/claims_template.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace rastertrace {

namespace {

/// The vertices as the scene has them: A (2, 5).
std::vector<std::string> given_vertices(const Trace& trace) {
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
    lines.emplace_back();
    return lines;
}

/// The lines of a sheet as they are printed: what is given, and a rule to write on in place of each `?`. The picture is
/// the grid above them.
std::vector<std::string> printed_lines(const Trace& trace) {
    std::vector<std::string> lines = given_vertices(trace);
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

Drawing sheet_page(const Trace& trace) {
    FigureMaker maker(trace, {{.steps = {.first = 1, .last = 1}, .is_question = true}}, {});
    Drawing page = maker.figure(0);
    const std::vector<std::string> lines = printed_lines(trace);
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

} // namespace rastertrace
