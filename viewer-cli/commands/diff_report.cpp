// SPDX-License-Identifier: MIT
#include "commands/diff_report.h"

#include "app/load.h"
#include "commands/explain_text.h"

#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

constexpr Color of_a(200, 40, 40);
constexpr Color of_b(30, 130, 60);

/// The colors of the marks of a picture (see PictureDifference) that tell a difference.
struct MarkRow {
    char mark;
    Color color;
};
constexpr std::array mark_rows{MarkRow{'!', of_a}, MarkRow{'?', of_b},
                               MarkRow{'~', Color(200, 120, 0)}};

} // namespace

std::string explanation_of_first_pixel(const TraceDiff& found, const Trace& trace) {
    const Pixel pixel = found.picture->pixels.front().pixel;
    return explanation_text(
        value_or_throw(explain(trace, {.about = Topic::pixel, .pixel = pixel})));
}

std::string diff_summary(const TraceDiff& found) {
    if (found.is_same)
        return found.damage.empty() ? said("the same##pictures")
                                    : said("the same, as far as they go");
    std::vector<std::string> parts;
    if (const std::uint64_t steps = count_steps(found); steps > 0)
        parts.push_back(counted_differences(steps, "step"));
    if (const std::uint64_t pixels = count_pixels(found); pixels > 0)
        parts.push_back(counted_differences(pixels, "pixel"));
    if (!found.header.empty() || !found.end.empty())
        parts.push_back(said("the header differs"));
    return joined(parts, ", ");
}

std::string without_kinds(const std::string& text) {
    return text.substr(0, text.find("\n\n" + heading_of_kinds() + " ")) + "\n";
}

std::string sentence_of(const std::optional<DiffStep>& step) {
    return step ? step->sentence : said("no such step");
}

std::string diff_in_color(const std::string& text, ColorDepth colors) {
    if (colors == ColorDepth::none)
        return text;
    std::string colored;
    bool is_picture = false;
    for (const std::string& line : split_at(text, '\n')) {
        is_picture = is_picture ? !line.starts_with('#') && !line.empty()
                                : line.starts_with(heading_of_pictures());
        if (line.starts_with("a ") || line.starts_with("b ")) {
            colored += styled(line, {.foreground = line.front() == 'a' ? of_a : of_b}, colors);
        } else if (is_picture && line.find("x = ") == std::string::npos) {
            for (const char c : line) {
                const auto row = std::ranges::find(mark_rows, c, &MarkRow::mark);
                const std::string mark(1, c);
                colored += row == mark_rows.end()
                               ? mark
                               : styled(mark, {.foreground = row->color}, colors);
            }
        } else {
            colored += line;
        }
        colored += '\n';
    }
    colored.pop_back();
    return colored;
}

} // namespace rastertrace
