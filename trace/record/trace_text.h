// SPDX-License-Identifier: MIT
#pragma once

// The text of a trace, one step a line, in a file or in memory. Any part of it can be read again, so what is larger
// than the memory can be gone through more than once.
//
//     auto opened = open_trace_text("a.jsonl", {});  // throws a Problem
//     if (auto* text = std::get_if<TraceText>(&opened))
//         text->header().canvas;

#include "trace.h"

#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>

namespace rastertrace {

class TraceText {
public:
    /// A trace in memory, in any layout: one that has not one step a line is laid out so. Throws a Problem.
    explicit TraceText(Source source);
    TraceText(TraceText&&) noexcept;
    TraceText& operator=(TraceText&&) noexcept;
    ~TraceText();

    /// What messages call it.
    const std::string& name() const;

    /// Which file it is, if it is a regular one.
    const std::optional<FileId>& file() const;

    /// What stands in front of the steps: a trace without any.
    const Trace& header() const;

    /// The same as a JSON object.
    const std::string& header_json() const;

    /// True if line n + 1 of a file has step n, as far as there are no empty lines.
    bool has_lines() const;

    /// True if steps end with a comma, and `]` stands behind the last.
    bool is_document() const;

    /// Where the first line behind the header begins.
    std::size_t begin() const;

    /// How many bytes there are.
    std::size_t size() const;

    /// Reads from a place on into `to`; fewer bytes, or none, at the end. Throws a Problem.
    std::size_t read(std::size_t offset, std::span<char> to) const;

    /// The first place of a text from another one on. At most `most` bytes are read, which are taken from it.
    std::optional<std::size_t> find(std::string_view wanted, std::size_t from,
                                    std::size_t& most) const;

private:
    friend std::variant<TraceText, Source> open_trace_text(const std::string& path,
                                                           const InputLimits& limits);
    struct State;
    explicit TraceText(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

/// Opens a file ("-" for standard input): the text of a trace; or, if it is none of one step a line, all that the
/// file holds. What comes from a pipe is kept in a file without a name meanwhile. Throws a Problem.
std::variant<TraceText, Source> open_trace_text(const std::string& path, const InputLimits& limits);

} // namespace rastertrace
