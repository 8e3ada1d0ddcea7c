// SPDX-License-Identifier: MIT
// What two traces do differently, as text: the first difference and what came of it, then all of them by kind, then
// the pictures.

#include "diff.h"
#include "diff_header.h"

#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace rastertrace {

namespace {

/// So many pixels of a list are named.
constexpr std::size_t most_pixels_named = 8;

/// How a pixel may differ, with the words for it.
struct DifferenceRow {
    std::uint64_t PictureDifference::*count;
    std::vector<Pixel> Consequences::*led_to;
    Words words;
};
constexpr std::array difference_rows{
    DifferenceRow{&PictureDifference::only_a, &Consequences::only_a, "only in a"},
    DifferenceRow{&PictureDifference::only_b, &Consequences::only_b, "only in b"},
    DifferenceRow{&PictureDifference::colors, &Consequences::colors, "in another color"},
    DifferenceRow{&PictureDifference::owners, &Consequences::owners, "of another primitive"},
};

/// Longer JSON is cut.
constexpr std::size_t longest_value = 60;

/// A value as a sentence has it: a string without its quotes, a stage as what became of it.
std::string value_text(const std::string& json) {
    if (json.starts_with("{\"stage\""))
        return fmt::format("{} ({})",
                           value_of_stage(json, "kept") == "true" ? said("kept") : said("left out"),
                           printable(value_of_stage(json, "why").text()));
    return json.empty() ? said("none##nothing")
                        : shortened(printable(plain_text(json)), longest_value);
}

std::string distance_text(double distance) {
    return fmt::format("{:.4g}", distance);
}

/// `left: -1/4 in a, -1/2 in b, 0.25 apart`.
std::string field_text(const FieldDifference& field) {
    std::string text = said("{}: {} in a, {} in b", printable(field.name), value_text(field.a),
                            value_text(field.b));
    if (field.distance)
        text += said(", {} apart", distance_text(*field.distance));
    return text;
}

std::string step_line(char side, char mark, const DiffStep& step) {
    const std::string line = step.line == 0 ? "" : said(" (line {})", step.line);
    return said("{} {} step {}{}: {}\n", side, mark, step.number, line, step.sentence);
}

std::string steps_of(char side, const std::vector<DiffStep>& before,
                     const std::optional<DiffStep>& step, const std::vector<DiffStep>& after) {
    std::string text;
    for (const DiffStep& one : before)
        text += step_line(side, ' ', one);
    if (step)
        text += step_line(side, '>', *step);
    else
        text += said("{} > no such step\n", side);
    for (const DiffStep& one : after)
        text += step_line(side, ' ', one);
    return text;
}

std::string pixels_named(const std::vector<Pixel>& pixels) {
    std::string text;
    for (std::size_t i = 0; i < std::min(pixels.size(), most_pixels_named); ++i)
        text += fmt::format(" ({}, {})", pixels[i].x, pixels[i].y);
    return text + (pixels.size() > most_pixels_named ? " ..." : "");
}

std::string first_text(const TraceDiff& found) {
    const StepDifference& first = *found.first;
    // In color, lines that begin with `a ` are those of a.
    std::string text =
        said("\nthe first difference{}{}\n",
             first.primitive.empty() ? "" : said(", in {}", printable(first.primitive)),
             first.is_moved ? said(": a {} that has moved", printable(first.kind)) : "");
    text += steps_of('a', found.before_a, first.a, found.after_a);
    text += steps_of('b', found.before_b, first.b, found.after_b);
    for (const FieldDifference& field : first.fields)
        text += "    " +
                (first.kind == "primitive" && field.name == "name" && !field.a.empty() &&
                         !field.b.empty()
                     ? said("renamed: {} in a is {} in b", value_text(field.a), value_text(field.b))
                     : field_text(field)) +
                "\n";

    const Consequences& led_to = found.led_to;
    if (led_to.count == 0)
        return text + (found.picture ? said("    it changes no pixel\n") : "");
    text += said("    {} because of it\n", counted_differences(led_to.count, "pixel"));
    for (const DifferenceRow& row : difference_rows)
        if (const std::vector<Pixel>& pixels = led_to.*row.led_to; !pixels.empty())
            text += fmt::format("        {}:{}\n", row.words.in(language_of_steps()),
                                pixels_named(pixels));
    return text;
}

std::string fields_text(const std::vector<FieldSummary>& fields) {
    std::vector<std::string> parts;
    for (const FieldSummary& field : fields) {
        std::string part = fmt::format("{} {}", printable(field.name), field.count);
        if (field.largest)
            part += said(" (by at most {})", distance_text(*field.largest));
        parts.push_back(std::move(part));
    }
    return joined(parts, ", ");
}

std::string count_text(std::size_t count) {
    return count == 0 ? "." : fmt::format("{}", count);
}

std::string kinds_text(const std::vector<KindDifference>& kinds) {
    const std::array<std::string, 4> titles{said("changed"), said("only a"), said("only b"),
                                            said("moved")};
    std::size_t width = columns_in(heading_of_kinds());
    for (const KindDifference& kind : kinds)
        width = std::max(width, columns_in(printable(kind.kind)));
    std::string text =
        fmt::format("\n{}  {}\n", padded(heading_of_kinds(), width), joined(titles, "  "));
    for (const KindDifference& kind : kinds) {
        const std::array counts{kind.changed, kind.only_a, kind.only_b, kind.moved};
        std::string line = padded(printable(kind.kind), width);
        for (std::size_t i = 0; i < counts.size(); ++i)
            line += fmt::format("  {:>{}}", count_text(counts[i]), columns_in(titles[i]));
        line += "   " + fields_text(kind.fields);
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

/// Rows of the picture with their y in front, and the x of the first and the last column above.
std::string grid_text(const PictureDifference& picture,
                      const std::vector<const std::vector<std::string>*>& grids) {
    const std::size_t columns = picture.rows.front().size();
    std::size_t label = 0;
    const auto y_of = [&picture](std::size_t row) {
        return fmt::format("{}", picture.top + picture.down * static_cast<int>(row));
    };
    for (std::size_t row = 0; row < picture.rows.size(); ++row)
        label = std::max(label, y_of(row).size());
    std::string text = said("{}  x = {} to {}\n", std::string(label, ' '), picture.left,
                            picture.left + static_cast<int>(columns) - 1);
    for (std::size_t row = 0; row < picture.rows.size(); ++row) {
        text += fmt::format("{:>{}}  ", y_of(row), label);
        for (std::size_t i = 0; i < grids.size(); ++i)
            text += (i == 0 ? "" : "   ") + (*grids[i])[row];
        text += "\n";
    }
    return text;
}

/// What the letters stand for, in lines.
std::string names_text(const std::vector<std::string>& names) {
    constexpr std::size_t widest = 79;
    std::string text;
    std::string line;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string name = fmt::format("{} {}{}", primitive_letters[i], printable(names[i]),
                                             i + 1 < names.size() ? "," : "");
        if (!line.empty() && columns_in(line) + 1 + columns_in(name) > widest)
            text += std::exchange(line, "") + "\n";
        line += (line.empty() ? "" : " ") + name;
    }
    return text + line + "\n";
}

std::string picture_text(const PictureDifference& picture) {
    if (picture.rows.empty())
        return said("\nthe pictures are alike\n");
    std::vector<std::string> counts;
    for (const DifferenceRow& row : difference_rows)
        if (const std::uint64_t count = picture.*row.count; count > 0)
            counts.push_back(fmt::format("{} {}", said_count(count, "pixel"),
                                         row.words.in(language_of_steps())));
    std::string text = fmt::format("\n{}{}\n", heading_of_pictures(), joined(counts, ", "));
    text += grid_text(picture, {&picture.rows});
    text += said("# in both, ! only in a, ? only in b, ~ in both, but otherwise\n");
    if (!picture.names.empty()) {
        std::vector<const std::vector<std::string>*> grids{&picture.faces_a, &picture.faces_b};
        std::erase_if(grids, [](const auto* faces) { return faces->empty(); });
        const std::string one = picture.faces_a.empty() ? "b" : "a";
        text += said("\nwho drew them, {}\n", grids.size() > 1 ? said("a and b") : one);
        text += grid_text(picture, grids);
        text += names_text(picture.names);
        if (picture.names.size() == primitive_letters.size())
            text += said("# another one\n");
    }
    if (picture.is_cut)
        text += said("(a part of the canvas)\n");
    return text;
}

std::string header_text(const TraceDiff& found) {
    std::string text = said("\nthe header\n");
    for (const FieldDifference& field : found.header)
        text += "    " + field_text(field) + "\n";
    for (const FieldDifference& field : found.end)
        text += "    " + field_text(field) + "\n";
    return text;
}

std::string remarks_text(const TraceDiff& found) {
    std::string text;
    for (const std::string& remark : found.remarks)
        text += remark + "\n";
    return text;
}

} // namespace

std::uint64_t count_steps(const TraceDiff& found) {
    std::uint64_t steps = 0;
    for (const KindDifference& kind : found.kinds)
        steps += kind.changed + kind.only_a + kind.only_b + kind.moved;
    return steps;
}

std::uint64_t count_pixels(const TraceDiff& found) {
    return found.picture ? found.picture->only_a + found.picture->only_b + found.picture->colors +
                               found.picture->owners
                         : 0;
}

std::string counted_differences(std::uint64_t count, const Words& what) {
    return said_count(count, what) + (count == 1 ? said(" differs") : said(" differ"));
}

std::string heading_of_kinds() {
    return said("steps");
}

std::string heading_of_pictures() {
    return said("the pictures: ");
}

std::string diff_text(const TraceDiff& found) {
    std::string text =
        fmt::format("a: {}\nb: {}\n", printable(found.name_a), printable(found.name_b));
    if (found.is_same)
        return text + remarks_text(found) +
               (found.is_same_bytes    ? said("the same, byte for byte\n")
                : found.damage.empty() ? said("the same\n")
                                       : said("the same, as far as they go\n"));

    text += remarks_text(found);
    const std::uint64_t steps = count_steps(found);
    const bool has_header = !found.header.empty() || !found.end.empty();
    if (steps > 0)
        text += counted_differences(steps, "step") + "\n";
    else if (has_header) // else only the pictures differ
        text += said("no step differs\n");
    if (has_header)
        text += header_text(found);
    if (found.first)
        text += first_text(found);
    if (!found.kinds.empty())
        text += kinds_text(found.kinds);
    if (found.picture)
        text += picture_text(*found.picture);
    return text + (found.explanation.empty() ? "" : "\n" + found.explanation);
}

} // namespace rastertrace
