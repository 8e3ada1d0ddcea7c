// SPDX-License-Identifier: MIT
// A picture that is expected, against the one that a trace shows.

#include "question.h"

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace::matchers {

namespace {

using Rows = std::vector<std::string>;

/// Throws a Problem if these rows are no picture of a part of the canvas with this top left pixel.
void expect_picture(const Rows& rows, const Canvas& canvas, Pixel top_left, bool is_whole) {
    if (rows.empty() || rows.front().empty())
        throw problem_of("", "expected rows of `#` and `.`, found none");
    const std::size_t width = rows.front().size();
    for (const std::string& row : rows) {
        if (row.size() != width)
            throw problem_of("", fmt::format("expected rows of one length, found {} and {} columns",
                                             width, row.size()));
        if (row.find_first_not_of(".#") != std::string::npos)
            throw problem_of("",
                             fmt::format("expected rows of `#` and `.`, found {}", printable(row)));
    }
    const int most_columns = canvas.right() - top_left.x + 1;
    const int most_rows = canvas.height - static_cast<int>(canvas.row_of(top_left.y));
    const auto columns = static_cast<std::size_t>(most_columns);
    const auto lines = static_cast<std::size_t>(most_rows);
    if (is_whole ? width != columns || rows.size() != lines
                 : width > columns || rows.size() > lines)
        throw problem_of(
            "",
            fmt::format("expected {}{} columns and {} rows, found {} and {}",
                        is_whole ? "" : "at most ", columns, lines, width, rows.size()),
            is_whole ? "ShowsPicture(rows, Pixel{x, y}) is about a part of the canvas" : "");
}

/// The same part of the picture that a trace shows.
Rows picture_in(const Trace& trace, std::size_t width, std::size_t height, Pixel top_left) {
    const Canvas& canvas = trace.canvas;
    const Frame frame = frame_after(trace, trace.size());
    Rows rows(height, std::string(width, '.'));
    for (std::size_t row = 0; row < height; ++row)
        for (std::size_t column = 0; column < width; ++column) {
            const Pixel pixel{top_left.x + static_cast<int>(column),
                              top_left.y + canvas.down() * static_cast<int>(row)};
            if (frame.drawn_by[canvas.offset_of(pixel)] != 0)
                rows[row][column] = '#';
        }
    return rows;
}

/// Both pictures in one: `!` is only expected, `?` is only there.
Rows marked(const Rows& expected, const Rows& found) {
    Rows rows = found;
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < rows[i].size(); ++k)
            if (expected[i][k] != found[i][k])
                rows[i][k] = expected[i][k] == '#' ? '!' : '?';
    return rows;
}

/// Pictures side by side, with y in front of each row.
std::string pictures_text(const Canvas& canvas, Pixel top_left, const Rows& expected,
                          const Rows& found) {
    const Rows both = marked(expected, found);
    const std::size_t width = std::max<std::size_t>(expected.front().size(), 8); // of a title
    std::string text = fmt::format("\n{:>5}  {}  {}  {}", "y", padded("expected", width),
                                   padded("there", width), "! only expected, ? only there");
    for (std::size_t i = 0; i < both.size(); ++i)
        text += fmt::format("\n{:>5}  {}  {}  {}", top_left.y + canvas.down() * static_cast<int>(i),
                            padded(expected[i], width), padded(found[i], width), both[i]);
    return text;
}

TraceMatcher shows_picture(Rows expected, std::optional<Pixel> part, Caller caller) {
    return matcher_of(
        {"shows the picture", "does not show the picture"}, caller,
        [expected = std::move(expected), part](const TestedTrace& tested) -> Verdict {
            const Trace& trace = trace_or_throw(tested);
            const Canvas& canvas = trace.canvas;
            const Pixel top_left = part.value_or(Pixel{canvas.left(), canvas.top()});
            expect_on_canvas(canvas, top_left);
            expect_picture(expected, canvas, top_left, !part);
            expect_told(trace, {StepKind::pixel});
            const Rows found =
                picture_in(trace, expected.front().size(), expected.size(), top_left);
            if (found == expected)
                return {true, fmt::format("all of its {} rows are there", expected.size())};
            return {false, "which shows" + pictures_text(canvas, top_left, expected, found)};
        });
}

} // namespace

Picture::Picture(std::string_view text) {
    if (text.starts_with('\n')) // of a raw string
        text.remove_prefix(1);
    if (text.ends_with('\n'))
        text.remove_suffix(1);
    rows_ = split_at(text, '\n');
}

TraceMatcher ShowsPicture(const Picture& picture, Caller caller) {
    return shows_picture(picture.rows(), std::nullopt, caller);
}

TraceMatcher ShowsPicture(const Picture& picture, Pixel top_left, Caller caller) {
    return shows_picture(picture.rows(), top_left, caller);
}

} // namespace rastertrace::matchers
