// SPDX-License-Identifier: MIT
#include "problem.h"

#include "mapped_file.h"
#include "text.h"
#include "zero_byte.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <iterator>
#include <system_error>
#include <utility>

namespace rastertrace {

namespace {

/// How many characters of a line are shown before and after the place that is meant.
constexpr std::size_t shown_before = 60;
constexpr std::size_t shown_after = 40;

/// `text` made safe to print, tabs as blanks.
std::string excerpt_of(std::string_view text) {
    std::string line(text);
    std::replace(line.begin(), line.end(), '\t', ' ');
    return printable(line);
}

/// The last `count` characters of `text`.
std::string_view last_characters(std::string_view text, std::size_t count) {
    const std::size_t all = characters_in(text);
    return text.substr(first_characters(text, all - std::min(all, count)).size());
}

} // namespace

Problem problem_of(std::string file, std::string message, std::string hint) {
    Problem problem;
    problem.file = std::move(file);
    problem.message = std::move(message);
    problem.hint = std::move(hint);
    return problem;
}

Problem problem_of_system(std::string file, std::string_view what, int error) {
    Problem problem = problem_of(
        std::move(file), fmt::format("{}: {}", what, std::generic_category().message(error)));
    problem.cause = Problem::Cause::system;
    return problem;
}

std::string_view Source::view() const {
    return mapped ? mapped->text() : std::string_view(text);
}

Problem problem_at(const Source& source, std::size_t offset, std::string message,
                   std::string hint) {
    Problem problem = problem_of(source.name, std::move(message), std::move(hint));

    // The line that holds the place, and what of it stands before and after.
    const std::string_view text = source.view();
    offset = std::min(offset, text.size());
    const std::string_view before_place = text.substr(0, offset);
    const std::size_t newline = before_place.rfind('\n');
    const std::string_view before =
        before_place.substr(newline == std::string_view::npos ? 0 : newline + 1);
    const std::string_view rest = text.substr(offset);
    const std::string_view after = rest.substr(0, rest.find_first_of("\r\n"));
    problem.line =
        1 + static_cast<std::size_t>(std::count(before_place.begin(), before_place.end(), '\n'));
    problem.column = characters_in(before) + 1;

    // A window of the line around the place; a tab counts as one blank.
    std::string shown = excerpt_of(last_characters(before, shown_before));
    if (characters_in(before) > shown_before)
        shown.insert(0, "...");
    problem.caret = columns_in(shown);
    shown += excerpt_of(first_characters(after, shown_after));
    if (characters_in(after) > shown_after)
        shown += "...";
    problem.excerpt = std::move(shown);
    return problem;
}

std::optional<Problem> zero_byte_in(const Source& source) {
    const std::size_t at = source.view().find('\0');
    if (at == std::string::npos)
        return std::nullopt;
    if (source.view().starts_with("PK\x03\x04")) // a zip archive
        return problem_of(source.name,
                          "expected text, found a file of a spreadsheet, or an archive",
                          "in the spreadsheet, save it as CSV");
    return problem_at(source, at, "expected text, found a zero byte");
}

std::string to_text(const Problem& problem) {
    std::string text;
    if (!problem.file.empty())
        text += printable(problem.file) + ":";
    if (problem.line > 0)
        text += fmt::format("{}:{}:", problem.line, problem.column);
    if (!text.empty())
        text += " ";
    text += printable(problem.message);
    if (!problem.excerpt.empty())
        text += "\n" + problem.excerpt + "\n" + std::string(problem.caret, ' ') + "^";
    if (!problem.hint.empty())
        text += "\nhint: " + printable(problem.hint);
    constexpr std::size_t most_further = 20;
    for (std::size_t i = 0; i < std::min(problem.further.size(), most_further); ++i)
        text += "\n" + to_text(problem.further[i]);
    if (problem.further.size() > most_further)
        text += fmt::format("\nand {} more", problem.further.size() - most_further);
    return text;
}

Problem first_of(std::vector<Problem> problems) {
    Problem first = std::move(problems.front());
    first.further.assign(std::make_move_iterator(problems.begin() + 1),
                         std::make_move_iterator(problems.end()));
    return first;
}

Problem::Cause cause_of_open_error(int error) {
    constexpr std::array errors{ENOENT,       ENOTDIR, EISDIR, EACCES, EPERM,    ELOOP,
                                ENAMETOOLONG, ENXIO,   ENODEV, EINVAL, EOVERFLOW};
    const bool is_due_to_path = std::find(errors.begin(), errors.end(), error) != errors.end();
    return is_due_to_path ? Problem::Cause::input : Problem::Cause::system;
}

} // namespace rastertrace
