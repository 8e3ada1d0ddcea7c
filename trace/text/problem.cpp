// SPDX-License-Identifier: MIT
#include "problem.h"

#include "input.h"
#include "input_check.h"
#include "input_file.h"
#include "mapped_file.h"
#include "text.h"
#include "trace_layout.h"
#include "zero_byte.h"

#include <fmt/core.h>

#include <unistd.h>

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

namespace {

/// What the first line of a text tells.
LineLayout layout_by_first_line(std::string_view text) {
    return layout_of(without_blanks(text.substr(0, text.find('\n'))));
}

/// A trace with a step a line, from its first byte on, whose lines are not too long; null for what is read instead: any
/// other file, and a small one, which nobody has to look at where it is.
std::shared_ptr<const MappedFile> mapped_trace(const InputFile& file) {
    constexpr std::size_t smallest = 1'000'000;
    if (!file.id() || ::lseek(file.descriptor(), 0, SEEK_CUR) != 0)
        return nullptr;
    auto mapped = MappedFile::of(file.descriptor(), file.name());
    const std::string_view text = mapped->text();
    // A file that is no text may have no end of a line for as long as it goes on.
    const std::string_view beginning = text.substr(0, longest_line);
    if (text.size() < smallest || layout_by_first_line(beginning) == LineLayout::other)
        return nullptr;
    for (std::size_t rest = text.size(), begin = 0; rest > longest_line;
         rest = text.size() - begin) {
        const std::size_t newline = text.rfind('\n', begin + longest_line);
        if (newline == std::string_view::npos || newline < begin)
            return nullptr; // who reads it says so
        begin = newline + 1;
    }
    return mapped;
}

Result<Source> read_path(const std::string& path, InputFile::Kind kind, InputCheck fault_of) {
    auto file = InputFile::open(path, kind);
    if (!file)
        return file.problem();
    Source source{.name = file.value().name(), .text = {}, .file = file.value().id()};
    try {
        std::size_t block = 0;
        if (kind == InputFile::Kind::any) // what another file names is no trace
            source.mapped = mapped_trace(file.value());
        // A text that need not grow is neither copied nor moved. What the system tells may be far from true.
        constexpr std::size_t most_trusted = 64U << 20U;
        if (!source.mapped)
            source.text.reserve(std::min(file.value().told_size(), most_trusted));
        while (!source.mapped && file.value().read_into(source.text)) {
            if (auto fault = fault_of(source, block))
                return *std::move(fault);
            block = source.text.size();
        }
    } catch (const Problem& problem) {
        return problem;
    }
    // Of a trace each whole line is used; who reads it says where it ends.
    if (file.value().is_cut_off() && layout_by_first_line(source.text) == LineLayout::other)
        return problem_of(source.name,
                          "expected the end of what is packed, found the end of the file");
    return source;
}

} // namespace

Result<Source> read_source(const std::string& path) {
    return read_source(path, InputLimits{});
}

Result<Source> read_source(const std::string& path, const InputLimits& limits) {
    return read_path(path, InputFile::Kind::any, {InputCheck::Kind::scene_or_trace, limits});
}

Result<Source> read_source_or_claims(const std::string& path, const InputLimits& limits) {
    return read_path(path, InputFile::Kind::any, {InputCheck::Kind::scene_trace_or_claims, limits});
}

Result<Source> read_bytes(const std::string& path, const InputLimits& limits) {
    return read_path(path, InputFile::Kind::any, {InputCheck::Kind::bytes, limits});
}

Result<Source> read_named_file(const std::string& path, const InputLimits& limits) {
    if (path.find('\0') != std::string::npos)
        return problem_of(path, "expected the name of a file, found one with a zero byte");
    return read_path(path, InputFile::Kind::regular_file, {InputCheck::Kind::other, limits});
}

} // namespace rastertrace
