// SPDX-License-Identifier: MIT
#include "convention_sheet.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/conventions.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// So many columns of a terminal are taken for granted.
constexpr std::size_t sheet_width = 100;

/// The conventions that draw one picture.
struct Group {
    std::vector<std::string_view> names;
    std::vector<Color> colors; ///< row by row, from the top left
    std::vector<std::string> lines = {};
};

/// The scene by every convention that it can be drawn by; `canvas` is that of the last one.
std::vector<Group> drawn_by_all(const Source& source, const SceneOptions& options, Canvas& canvas) {
    std::vector<Group> groups;
    for (const ConventionRow& row : convention_rows()) {
        MethodOverrides method = options.method;
        method.emplace_back("convention", row.name);
        auto read = read_scene(source, method, options.limits, options.frames);
        if (!read) {
            Problem problem = read.problem();
            problem.message += fmt::format(", with the convention {}", row.name);
            throw problem;
        }
        const Image image = draw(read.value().scene, read.value().plan);
        canvas = image.canvas();
        const auto colors = image.colors();
        const auto known = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
            return std::equal(colors.begin(), colors.end(), group.colors.begin(),
                              group.colors.end());
        });
        if (known != groups.end())
            known->names.push_back(row.name);
        else
            groups.push_back({.names = {row.name}, .colors = {colors.begin(), colors.end()}});
    }
    return groups;
}

/// `#` where all pictures are the same; `*` where this one has a pixel, or a color, that not all
/// have; `-` where it has none and another one has.
char mark_of(const std::vector<Group>& groups, const Group& group, std::size_t at) {
    const Color color = group.colors[at];
    const bool is_same = std::all_of(groups.begin(), groups.end(),
                                     [&](const Group& other) { return other.colors[at] == color; });
    const bool is_drawn = color != no_color;
    return is_same ? (is_drawn ? '#' : '.') : is_drawn ? '*' : '-';
}

/// What a row sets of a key; a dash if it does not.
std::string_view value_in(const ConventionRow& row, std::string_view key) {
    for (const auto& [name, value] : row.method)
        if (name == key)
            return value;
    return "-";
}

/// The settings as they stand in a scene: `rows half-open, rounding half-open`.
std::string other_settings(const ConventionRow& row) {
    std::vector<std::string> all;
    for (const auto& [name, value] : row.method)
        if (name != "fill" && name != "sample" && name != "line" && name != "depth")
            all.push_back(fmt::format("{} {}", name, value));
    return all.empty() ? "-" : joined(all, ", ");
}

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size(), width), ' ');
    return text;
}

} // namespace

std::string conventions_text() {
    const auto line = [](std::string_view name, std::string_view fill, std::string_view sample,
                         std::string_view lines, std::string_view depth, std::string_view others) {
        return fmt::format("{:<13} {:<12} {:<8} {:<13} {:<10} {}\n", name, fill, sample, lines,
                           depth, others);
    };
    std::string text = line("convention", "fill", "sample", "line", "depth", "other keys");
    for (const ConventionRow& row : convention_rows())
        text += line(row.name, value_in(row, "fill"), value_in(row, "sample"),
                     value_in(row, "line"), value_in(row, "depth"), other_settings(row));
    for (const ConventionRow& row : convention_rows())
        text += fmt::format("\n{}: {}\n  viewport  {}\n  source    {}\n  unusual   {}\n", row.name,
                            row.what, name_of_view(row), row.source, row.unusual);
    return text;
}

std::string convention_sheet(const std::string& path, const SceneOptions& options) {
    const Source source = load_scene_source(path, options.limits);
    Canvas canvas;
    std::vector<Group> groups = drawn_by_all(source, options, canvas);
    const auto width = static_cast<std::size_t>(canvas.width);
    std::size_t differing = 0;
    for (std::size_t at = 0; at < groups.front().colors.size(); ++at)
        differing += std::any_of(groups.begin(), groups.end(),
                                 [&](const Group& group) {
                                     return group.colors[at] != groups.front().colors[at];
                                 })
                         ? 1
                         : 0;

    // The frames, and their width: a heading may be wider than the picture.
    std::size_t column = width;
    for (Group& group : groups) {
        const auto drawn = std::count_if(group.colors.begin(), group.colors.end(),
                                         [](Color color) { return color != no_color; });
        for (const std::string_view name : group.names)
            group.lines.emplace_back(name);
        group.lines.push_back(counted(static_cast<std::uint64_t>(drawn), "pixel"));
        for (const std::string& line : group.lines)
            column = std::max(column, line.size());
    }
    const std::size_t across = std::max<std::size_t>(1, (sheet_width + 2) / (column + 2));

    std::string text = fmt::format("{}: {} pictures by {} conventions; they differ in {}\n",
                                   shortened(printable(source.name), 79), groups.size(),
                                   convention_rows().size(), counted(differing, "pixel"));
    for (std::size_t first = 0; first < groups.size(); first += across) {
        const std::size_t end = std::min(first + across, groups.size());
        std::size_t headings = 0;
        for (std::size_t i = first; i < end; ++i)
            headings = std::max(headings, groups[i].lines.size());
        for (std::size_t i = first; i < end; ++i) {
            Group& group = groups[i];
            group.lines.resize(headings);
            for (std::size_t begin = 0; begin < group.colors.size(); begin += width) {
                std::string& line = group.lines.emplace_back();
                for (std::size_t x = 0; x < width; ++x)
                    line += mark_of(groups, group, begin + x);
            }
        }
        for (std::size_t k = 0; k < groups[first].lines.size(); ++k) {
            std::string line;
            for (std::size_t i = first; i < end; ++i)
                line += padded(groups[i].lines[k], column + 2);
            line.erase(line.find_last_not_of(' ') + 1);
            text += (k == 0 ? "\n" : "") + line + "\n";
        }
    }
    return text + "\n# all alike   * not in all   - only in others\n";
}

} // namespace rastertrace
