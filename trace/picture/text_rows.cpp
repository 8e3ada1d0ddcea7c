// SPDX-License-Identifier: MIT
// Rows of text, as `rastertrace show --bare` prints them: a character of ASCII a pixel, perhaps with a blank between
// columns.

#include "readers.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace rastertrace {

namespace {

/// The line that begins at `at`, without the blanks at its end.
std::string_view line_at(std::string_view text, std::size_t at) {
    const std::string_view line = text.substr(at, text.find('\n', at) - at);
    return line.substr(0, line.find_last_not_of(" \t\r") + 1);
}

bool has_blanks_between(std::string_view row) {
    return row.size() > 1 && row[1] == ' ';
}

bool is_mark(char c) {
    return '!' <= c && c <= '~';
}

bool is_usual_mark(char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
           std::string_view(".#*+-@?").find(c) != std::string_view::npos;
}

/// The first place in a row that has no mark, or no blank where one should be; its length if there is none.
template <typename IsMark>
std::size_t fault_in(std::string_view row, bool has_blanks, IsMark is_mark_here) {
    std::size_t i = 0;
    while (i < row.size() && (has_blanks && i % 2 == 1 ? row[i] == ' ' : is_mark_here(row[i])))
        ++i;
    return i;
}

} // namespace

bool begins_with_text_row(std::string_view text) {
    const std::string_view row = line_at(text, 0);
    return row.find_first_of(".#") != std::string_view::npos &&
           fault_in(row, has_blanks_between(row), is_usual_mark) == row.size();
}

Picture read_text_rows(const Source& source) {
    const std::string_view text =
        source.view().substr(0, source.view().find_last_not_of(" \t\r\n") + 1);
    const std::string_view first = line_at(text, 0);
    const bool has_blanks = has_blanks_between(first);
    const auto pixels_in = [has_blanks](std::string_view row) {
        return has_blanks ? (row.size() + 1) / 2 : row.size();
    };
    const auto newlines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    Picture picture = blank_picture(source, pixels_in(first), 1 + newlines);
    picture.has_colors = false;

    auto pixel = picture.pixels.begin();
    for (std::size_t at = 0, row_number = 0; row_number <= newlines; ++row_number) {
        const std::string_view row = line_at(text, at);
        const std::size_t fault = fault_in(row, has_blanks, is_mark);
        if (fault < row.size())
            throw problem_at(
                source, at + fault,
                has_blanks && fault % 2 == 1
                    ? "expected a blank between columns as in the first row, found none"
                    : "expected . or another visible character of ASCII, found none");
        if (row.size() != first.size())
            throw problem_at(source, at + std::min(row.size(), first.size()),
                             fmt::format("expected a row of {} pixels like the first one, found {}",
                                         pixels_in(first), pixels_in(row)));
        for (std::size_t i = 0; i < row.size(); i += has_blanks ? 2 : 1)
            *pixel++ = row[i] == '.' ? no_color : Color();
        at = text.find('\n', at) + 1;
    }
    return picture;
}

} // namespace rastertrace
