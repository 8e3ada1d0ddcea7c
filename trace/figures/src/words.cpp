// SPDX-License-Identifier: MIT
#include "words.h"

#include "clip.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace rastertrace {

namespace {

// Sizes of letters and heights of lines, in units.
constexpr double title_size = 13;
constexpr double title_line = 17;
constexpr double wideness_of_bold = 1.17; ///< at most, against the regular letters
constexpr double step_size = 9;
constexpr double caption_size = 11;
constexpr double caption_line = 15;
constexpr double working_size = 9.5;
constexpr double working_line = 13;
constexpr double legend_size = 10;
constexpr double legend_line = 16;
constexpr double swatch = 11;
constexpr double gap = 5;

/// A legend with more groups than this says nothing any more.
constexpr std::size_t most_entries = 24;

/// Which steps are shown; nothing for the whole picture.
std::string shown_steps_text(const Panel& panel) {
    const std::size_t first = panel.frame.steps.first;
    const Trace& trace = panel.trace();
    if (first == 0 || !panel.parts.has(FigurePart::step))
        return {};
    if (panel.frame.is_question)
        return said("before step {} of {}", trace.number_of(first), trace.size());
    return steps_text(trace, panel.frame.steps);
}

/// A swatch, and what it stands for.
struct Entry {
    std::vector<Role> layers; ///< one over the other
    std::optional<Color> color;
    std::string text;
};

/// The groups of faces that can be seen.
std::vector<Entry> entries_of_faces(const Panel& panel) {
    std::set<std::size_t> seen;
    for (const std::size_t primitive : visible_primitives(panel.replay))
        if (const auto group = panel.groups.group_of.find(primitive);
            group != panel.groups.group_of.end())
            seen.insert(group->second);
    std::vector<Entry> entries;
    if (seen.size() > most_entries)
        return entries;
    for (const std::size_t group : seen)
        entries.push_back({.layers = {face_role(group)},
                           .color = {},
                           .text = printable(panel.groups.names[group])});
    return entries;
}

std::vector<Entry> entries_of_comparison(const Panel& panel, const std::string& against) {
    const std::array<std::string, 4> words{
        said("the same"), said("! only in {}", printable(panel.trace().title)),
        said("? only in {}", printable(against)), said("~ in another color")};
    std::set<Role> seen;
    panel.for_each_pixel([&](Pixel, std::size_t offset) {
        if (const ComparisonMark* const mark = comparison_at(panel, offset))
            seen.insert(mark->role);
    });
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (const Role role = comparison_marks()[i].role; seen.contains(role))
            entries.push_back({.layers = {role}, .color = {}, .text = words[i]});
    return entries;
}

/// What the grays of depths and of writes say; nothing for other views.
std::vector<Entry> entries_of_grays(View view) {
    const auto entry = [](double share, std::string text) {
        return Entry{.layers = {Role::plotted}, .color = gray(share), .text = std::move(text)};
    };
    if (view == View::depth)
        return {entry(0, said("farthest")), entry(0.5, ""), entry(1, said("nearest"))};
    if (view != View::writes)
        return {};
    std::vector<Entry> entries;
    for (std::uint32_t writes = 1; writes <= most_writes_told; ++writes)
        entries.push_back(entry(share_of_writes(writes), writes == most_writes_told
                                                             ? said("{} or more writes", writes)
                                                             : fmt::format("{}", writes)));
    return entries;
}

/// What the layers of half-planes add up to; nothing for a frame that has none.
std::vector<Entry> entries_of_half_planes(const Panel& panel) {
    if (!has_half_planes(panel))
        return {};
    const auto entry = [](std::size_t negative, std::string text) {
        Entry one{.layers = {}, .color = {}, .text = std::move(text)};
        one.layers.assign(3 - negative, Role::inside);
        one.layers.insert(one.layers.end(), negative, Role::outside);
        return one;
    };
    const auto names = panel.trace().step(panel.primitive()).as<PrimitiveStep>().vertices.texts();
    const std::string all =
        names.size() == 3
            ? printable(fmt::format("{0}{1}, {1}{2}, {2}{0}", names[0], names[1], names[2]))
            : said("all three");
    return {entry(0, all + " \u2265 0"), entry(1, said("one of them < 0")),
            entry(2, said("two of them < 0"))};
}

/// What colors stand for.
std::vector<Entry> entries_of(const Panel& panel, const std::string& against) {
    std::vector<Entry> entries = panel.against != nullptr    ? entries_of_comparison(panel, against)
                                 : panel.view == View::faces ? entries_of_faces(panel)
                                                             : entries_of_grays(panel.view);
    if (panel.parts.has(FigurePart::half_planes))
        for (Entry& entry : entries_of_half_planes(panel))
            entries.push_back(std::move(entry));
    return entries;
}

void add_swatch(const Entry& entry, const Rectangle& box, std::vector<Shape>& shapes) {
    for (const Role role : entry.layers)
        shapes.emplace_back(Areas{.role = role, .color = entry.color, .rectangles = {box}});
    shapes.emplace_back(Lines{.role = Role::grid, .paths = {corners_of(box)}, .are_closed = true});
}

} // namespace

double add_title(const std::string& title, const Panel& panel, const Column& column, double y,
                 std::vector<Shape>& shapes) {
    const std::string steps = shown_steps_text(panel);
    if (!steps.empty())
        shapes.push_back(Label{.role = Role::quiet_text,
                               .at = {column.right, y + title_size - 1},
                               .text = steps,
                               .size = step_size,
                               .anchor = Anchor::end});
    const double room = column.width() - (steps.empty() ? 0 : width_of(steps, step_size) + gap);
    const double top = y;
    for (const std::string& line :
         wrapped(printable(title), letters_in(room, wideness_of_bold * title_size))) {
        shapes.push_back(Label{.role = Role::strong_text,
                               .at = {column.left, y + title_size - 1},
                               .text = line,
                               .size = title_size,
                               .is_bold = true});
        y += title_line;
    }
    return std::max(y, top + title_line) + gap - top;
}

double add_legend(const Panel& panel, const std::string& against, const Column& column, double y,
                  std::vector<Shape>& shapes) {
    const std::vector<Entry> entries = entries_of(panel, against);
    if (entries.empty())
        return 0;
    const double top = y;
    double x = column.left;
    y += gap;
    for (const Entry& entry : entries) {
        const double needed = swatch + gap + width_of(entry.text, legend_size) + 2 * gap;
        if (x > column.left && x + needed > column.right) {
            x = column.left;
            y += legend_line;
        }
        const Rectangle box{{x, y}, swatch, swatch};
        add_swatch(entry, box, shapes);
        shapes.push_back(Label{
            .at = {x + swatch + gap, y + 0.85 * swatch}, .text = entry.text, .size = legend_size});
        x += needed;
    }
    return y + legend_line - top;
}

std::string with_six_digits(std::string_view sentence) {
    constexpr std::string_view in_numbers = "0123456789.eE+-";
    std::string text;
    while (!sentence.empty()) {
        const std::size_t begin = std::min(sentence.find_first_of("0123456789"), sentence.size());
        text += sentence.substr(0, begin);
        sentence.remove_prefix(begin);
        std::size_t length = std::min(sentence.find_first_not_of(in_numbers), sentence.size());
        while (length > 0 &&
               std::string_view(".eE+-").find(sentence[length - 1]) != std::string_view::npos)
            --length; // the end of the sentence
        const std::string number(sentence.substr(0, length));
        const auto digits = std::count_if(number.begin(), number.end(),
                                          [](char c) { return '0' <= c && c <= '9'; });
        const auto value = TracedNumber(number).nearest_double();
        const bool is_long = digits > 6 && number.find('.') != std::string::npos && value;
        text += is_long ? fmt::format("{:.6g}", *value) : number;
        sentence.remove_prefix(length);
    }
    return text;
}

std::string with_whole_formulas(std::string_view text) {
    std::string whole;
    for (const TextPart& part : parts_with_formulas(text))
        for (const char c : part.text)
            if (c == ' ' && part.is_formula)
                whole += "\u00a0";
            else
                whole += c == '$' && !part.is_formula ? "\\$" : std::string(1, c);
    return whole;
}

double add_caption(const std::string& caption, bool is_of_step, const Column& column, double y,
                   std::vector<Shape>& shapes) {
    const double top = y;
    y += gap;
    // Several blanks stand between parts of a sentence: each begins a line.
    std::string part;
    std::string rest = printable(caption);
    if (!is_of_step)
        rest = with_whole_formulas(rest);
    while (!rest.empty()) {
        const std::size_t end = rest.find("   ");
        part = rest.substr(0, end);
        rest = end == std::string::npos ? std::string()
                                        : std::string(without_blanks(rest.substr(end)));
        for (const std::string& line : wrapped(part, letters_in(column.width(), caption_size))) {
            shapes.push_back(Label{.at = {column.left, y + 0.85 * caption_size},
                                   .text = line,
                                   .size = caption_size,
                                   .names_points = is_of_step,
                                   .has_formulas = !is_of_step});
            y += caption_line;
        }
    }
    return y - top;
}

double add_working(const std::vector<std::string>& working, const Column& column, double y,
                   std::vector<Shape>& shapes) {
    const double top = y;
    y += gap;
    for (const std::string& line : working)
        for (const std::string& piece : wrapped(line, letters_in(column.width(), working_size))) {
            shapes.push_back(Label{.at = {column.left, y + 0.85 * working_size},
                                   .text = piece,
                                   .size = working_size,
                                   .is_fixed_width = true});
            y += working_line;
        }
    return y - top;
}

} // namespace rastertrace
