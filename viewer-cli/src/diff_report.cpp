// SPDX-License-Identifier: MIT
#include "diff_report.h"

#include "explain_text.h"
#include "junit.h"
#include "load.h"
#include "markdown.h"

#include <rastertrace/figures/png.h>
#include <rastertrace/figures/svg.h>
#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/picture/picture_diff.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

constexpr Color of_a(200, 40, 40);
constexpr Color of_b(30, 130, 60);

constexpr Color drawn_gray(60, 60, 60);
constexpr Color not_drawn(255, 255, 255);

/// What the marks of a picture look like (see PictureDifference): in a, in b, and where they are shown together.
struct MarkRow {
    char mark;
    std::array<Color, 3> colors;
};
constexpr std::array mark_rows{MarkRow{'#', {drawn_gray, drawn_gray, Color(150, 150, 150)}},
                               MarkRow{'!', {drawn_gray, not_drawn, of_a}},
                               MarkRow{'?', {not_drawn, drawn_gray, of_b}},
                               MarkRow{'~', {drawn_gray, drawn_gray, Color(200, 120, 0)}}};

/// The part of the pictures that is told, each pixel a square; `shown` is the place among the colors of a mark.
Bitmap bitmap_of_part(const PictureDifference& picture, std::size_t shown) {
    constexpr std::size_t side = 12;
    const std::size_t rows = picture.rows.size();
    const std::size_t columns = picture.rows.front().size();
    Bitmap bitmap{.width = columns * side,
                  .height = rows * side,
                  .colors = std::vector<Color>(columns * side * rows * side, not_drawn)};
    for (std::size_t y = 0; y < bitmap.height; ++y)
        for (std::size_t x = 0; x < bitmap.width; ++x) {
            const bool is_line = x % side == 0 || y % side == 0;
            const char mark = picture.rows[y / side][x / side];
            const auto row = std::ranges::find(mark_rows, mark, &MarkRow::mark);
            bitmap.colors[y * bitmap.width + x] = is_line                  ? Color(225, 225, 225)
                                                  : row == mark_rows.end() ? not_drawn
                                                                           : row->colors[shown];
        }
    return bitmap;
}

std::string pictures_markdown(const PictureDifference& picture,
                              const std::filesystem::path& folder) {
    make_folder(folder.string());
    constexpr std::array<const char*, 3> names{"a.png", "b.png", "difference.png"};
    for (std::size_t i = 0; i < names.size(); ++i)
        write_file((folder / names[i]).string(),
                   value_or_throw(png_of(bitmap_of_part(picture, i))));
    const std::string path = folder.generic_string();
    const std::string difference = said({"difference", "diferença"});
    return fmt::format(
        "\n| a | b | {1} |\n|---|---|---|\n"
        "| ![a]({0}/a.png) | ![b]({0}/b.png) | ![{1}]({0}/difference.png) |\n\n"
        "{2}\n",
        path, difference,
        said({"Gray: in both; red: only in a; green: only in b; orange: in both, but otherwise.",
              "Cinza: em ambas; vermelho: só em a; verde: só em b; laranja: em ambas, mas de outro "
              "modo."}));
}

} // namespace

std::string explanation_of_first_pixel(const TraceDiff& found, const Trace& trace) {
    const Pixel pixel = found.picture->pixels.front().pixel;
    return explanation_text(
        value_or_throw(explain(trace, {.about = Topic::pixel, .pixel = pixel})));
}

std::string diff_summary(const TraceDiff& found) {
    if (found.is_same)
        return found.damage.empty() ? said({"the same", "iguais"})
                                    : said({"the same, as far as they go", "iguais, até onde vão"});
    std::vector<std::string> parts;
    if (const std::uint64_t steps = count_steps(found); steps > 0)
        parts.push_back(counted_differences(steps, {"step", "passo"}));
    if (const std::uint64_t pixels = count_pixels(found); pixels > 0)
        parts.push_back(counted_differences(pixels, {"pixel", "pixel"}));
    if (!found.header.empty() || !found.end.empty())
        parts.push_back(said({"the header differs", "o cabeçalho difere"}));
    return joined(parts, ", ");
}

std::string without_kinds(const std::string& text) {
    return text.substr(0, text.find("\n\n" + heading_of_kinds() + " ")) + "\n";
}

std::string sentence_of(const std::optional<DiffStep>& step) {
    return step ? step->sentence : said({"no such step", "não há esse passo"});
}

std::string diff_markdown(const TraceDiff& found, const std::string& picture_folder) {
    std::string text =
        fmt::format("### {}\n\na: `{}`, b: `{}`\n",
                    found.is_same ? said({"No difference", "Nenhuma diferença"})
                                  : said({"Decisions differ: {}", "As decisões diferem: {}"},
                                         diff_summary(found)),
                    printable(found.name_a), printable(found.name_b));
    if (found.first) {
        text += said({"\nThe first{}:\n\n", "\nA primeira{}:\n\n"},
                     found.first->primitive.empty()
                         ? ""
                         : said({", in {}", ", em {}"}, printable(found.first->primitive)));
        text += fenced(
            fmt::format("a {}\nb {}\n", sentence_of(found.first->a), sentence_of(found.first->b)));
    }
    if (!found.is_same && found.picture && !found.picture->rows.empty() && !picture_folder.empty())
        text += pictures_markdown(*found.picture, picture_folder);
    return text + fmt::format("\n<details><summary>{}</summary>\n\n{}\n</details>\n",
                              said({"All of it", "Tudo"}), fenced(diff_text(found)));
}

std::string diff_junit(const TraceDiff& found) {
    const std::string name = escaped(found.name_b);
    const std::string body =
        found.is_same
            ? "/>\n"
            : fmt::format(">\n      <failure message=\"{}\">{}</failure>\n    </testcase>\n",
                          escaped(diff_summary(found)), escaped_lines(diff_text(found)));
    return junit_document(fmt::format(
        "  <testsuite name=\"rastertrace diff\" tests=\"1\" failures=\"{}\" errors=\"0\" "
        "skipped=\"0\">\n    <testcase classname=\"{}\" name=\"{}\"{}"
        "  </testsuite>\n",
        found.is_same ? 0 : 1, escaped(found.name_a), name, body));
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
                const bool is_marked = row != mark_rows.end() && c != '#';
                colored += is_marked ? styled(std::string(1, c), {.foreground = row->colors.back()},
                                              colors)
                                     : std::string(1, c);
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
