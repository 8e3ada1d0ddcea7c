// SPDX-License-Identifier: MIT
#include "input_check.h"
#include "zero_byte.h"

#include <rastertrace/trace/input.h>
#include <rastertrace/trace/problem.h>
#include <rastertrace/trace/text.h>

#include <fmt/core.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

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

Problem problem_at(const Source& source, std::size_t offset, std::string message,
                   std::string hint) {
    Problem problem = problem_of(source.name, std::move(message), std::move(hint));

    // The line that holds the place, and what of it stands before and after.
    const std::string_view text = source.text;
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
    const std::size_t at = source.text.find('\0');
    if (at == std::string::npos)
        return std::nullopt;
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
    return text;
}

Problem::Cause cause_of_open_error(int error) {
    constexpr std::array errors{ENOENT,       ENOTDIR, EISDIR, EACCES, EPERM,    ELOOP,
                                ENAMETOOLONG, ENXIO,   ENODEV, EINVAL, EOVERFLOW};
    const bool is_due_to_path = std::find(errors.begin(), errors.end(), error) != errors.end();
    return is_due_to_path ? Problem::Cause::input : Problem::Cause::system;
}

namespace {

Result<Source> read_path(const std::string& path, bool is_standard_input, bool must_be_regular,
                         InputCheck fault_of) {
    Source source{.name = is_standard_input ? "standard input" : path, .text = {}};
    const auto failure = [&source](Problem::Cause cause, const std::string& why) {
        Problem problem = problem_of(source.name, why);
        problem.cause = cause;
        return problem;
    };

    // A file that is not there was asked for wrongly; one that cannot be read on is broken.
    const int flags = O_RDONLY | O_CLOEXEC | (must_be_regular ? O_NONBLOCK : 0);
    const Descriptor opened(is_standard_input ? -1 : ::open(path.c_str(), flags));
    if (!is_standard_input && !opened.is_open())
        return failure(cause_of_open_error(errno),
                       fmt::format("expected a file that can be read, found: {}",
                                   std::generic_category().message(errno)));
    const int descriptor = is_standard_input ? STDIN_FILENO : opened.number();
    struct stat status {};
    int error = ::fstat(descriptor, &status) == 0 ? 0 : errno;
    const bool is_folder = error == 0 && S_ISDIR(status.st_mode);
    const bool is_refused =
        is_folder || (error == 0 && must_be_regular && !S_ISREG(status.st_mode));

    // Neither the size that the system tells nor the end of the file is trusted.
    std::optional<Problem> fault;
    if (error == 0 && !is_refused) {
        if (S_ISREG(status.st_mode))
            source.file = FileId{.device = status.st_dev, .inode = status.st_ino};
        std::array<char, 1 << 16> buffer;
        ssize_t count = 0;
        while (!fault && (count = ::read(descriptor, buffer.data(), buffer.size())) != 0) {
            if (count > 0) {
                const std::size_t block = source.text.size();
                source.text.append(buffer.data(), static_cast<std::size_t>(count));
                fault = fault_of(source, block);
            } else if (errno == EAGAIN) {
                wait_until_readable(descriptor);
            } else if (errno != EINTR) {
                error = errno;
                break;
            }
        }
    }
    if (is_refused)
        return failure(Problem::Cause::input, is_folder
                                                  ? "expected a file, found a folder"
                                                  : "expected a file, found a pipe or a device");
    if (fault)
        return *std::move(fault);
    if (error != 0)
        return failure(Problem::Cause::system,
                       "could not be read: " + std::generic_category().message(error));
    return source;
}

} // namespace

Result<Source> read_source(const std::string& path) {
    return read_source(path, InputLimits{});
}

Result<Source> read_source(const std::string& path, const InputLimits& limits) {
    return read_path(path, path == "-", false, {InputCheck::Kind::scene_or_trace, limits});
}

Result<Source> read_source_or_claims(const std::string& path, const InputLimits& limits) {
    return read_path(path, path == "-", false, {InputCheck::Kind::scene_trace_or_claims, limits});
}

Result<Source> read_named_file(const std::string& path, const InputLimits& limits) {
    if (path.find('\0') != std::string::npos)
        return problem_of(path, "expected the name of a file, found one with a zero byte");
    return read_path(path, false, true, {InputCheck::Kind::other, limits});
}

} // namespace rastertrace
