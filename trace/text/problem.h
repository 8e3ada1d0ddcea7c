// SPDX-License-Identifier: MIT
#pragma once

// What is wrong with an input, said so that its author can mend it:
//
//     scene.json:2:22: expected a number, found "five"
//     {"vertices": {"A": [2, "five"]},
//                            ^
//     hint: ...

#include "descriptor.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

class MappedFile;

/// A file as it was read, with the name that messages call it by.
struct Source {
    std::string name;
    std::string text;
    std::optional<FileId> file = {};               ///< which one it was, if it was a regular file
    std::shared_ptr<const MappedFile> mapped = {}; ///< of a large trace: in the place of `text`
    bool is_read = false; ///< from a file or a pipe, whose lines can be named

    /// All that it says.
    std::string_view view() const;
};

/// Why something could not be done.
struct Problem {
    enum class Cause {
        input, ///< what was asked for, or a file's content, is wrong
        system ///< the machine could not do it: disk full, no permission, ...
    };
    Cause cause = Cause::input;
    std::string file;       ///< empty when no file is to blame
    std::size_t line = 0;   ///< from 1; 0 when the whole file is meant
    std::size_t column = 0; ///< from 1, in characters
    std::string message;    ///< "expected ..., found ..."
    std::string excerpt;    ///< the line, made safe to print; may be empty
    std::size_t caret = 0;  ///< how many characters of the excerpt stand before the place
    std::string hint;       ///< may be empty

    std::vector<Problem> further = {}; ///< more of the same file, of one that is read to its end
};

/// The whole message, and those of further problems behind it, without a newline at its end. Safe to print: no control
/// characters.
std::string to_text(const Problem& problem);

/// The first of some problems of one file, with the others behind it.
Problem first_of(std::vector<Problem> problems);

/// A problem at a byte of a source.
Problem problem_at(const Source& source, std::size_t offset, std::string message,
                   std::string hint = {});

/// What an error of open(2), or of looking a path up, is due to: the path, or the system.
Problem::Cause cause_of_open_error(int error);

/// A problem with no place in a file.
Problem problem_of(std::string file, std::string message, std::string hint = {});

/// That the machine could not do something, and why: `error` is what errno was.
Problem problem_of_system(std::string file, std::string_view what, int error);

/// A value, or the problem that kept it from being made.
template <typename T> class Result {
public:
    Result(T value) : state_(std::move(value)) {}           // NOLINT: a value is a result
    Result(Problem problem) : state_(std::move(problem)) {} // NOLINT: and so is a problem

    explicit operator bool() const { return std::holds_alternative<T>(state_); }

    T& value() { return std::get<T>(state_); }
    const T& value() const { return std::get<T>(state_); }
    const Problem& problem() const { return std::get<Problem>(state_); }

private:
    std::variant<T, Problem> state_;
};

/// Reads a whole file; "-" is standard input. A missing file or a folder is a problem of the input.
Result<Source> read_source(const std::string& path);

} // namespace rastertrace
