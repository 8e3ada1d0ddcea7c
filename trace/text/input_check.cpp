// SPDX-License-Identifier: MIT
#include "input_check.h"

#include "byte_order_mark.h"
#include "json_document.h"
#include "trace_layout.h"
#include "zero_byte.h"

#include <fmt/core.h>

#include <string>
#include <string_view>

namespace rastertrace {

namespace {

/// From so many bytes on, a beginning is long enough to be judged.
constexpr std::size_t enough_to_judge = 4096;

/// "256 MB", or "1234 bytes" where it comes out uneven.
std::string in_words(std::size_t bytes) {
    constexpr std::size_t megabyte = 1'000'000;
    return bytes > 0 && bytes % megabyte == 0 ? fmt::format("{} MB", bytes / megabyte)
                                              : fmt::format("{} bytes", bytes);
}

/// That a file begins as one packed by gzip (RFC 1952) or Zstandard (RFC 8878), if it does.
std::optional<Problem> packed_problem(const std::string& name, std::string_view beginning) {
    const bool is_gzip = beginning.starts_with("\x1f\x8b\x08");
    if (!is_gzip && !beginning.starts_with("\x28\xb5\x2f\xfd"))
        return std::nullopt;
    return problem_of(name,
                      fmt::format("expected a file that is not packed, found one packed by {}",
                                  is_gzip ? "gzip" : "zstd"),
                      fmt::format("`{} FILE | rastertrace show -` unpacks it on the way",
                                  is_gzip ? "zcat" : "zstdcat"));
}

bool can_begin_json(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks_and_mark);
    return first == std::string_view::npos ||
           std::string_view("{[\"-0123456789tfn").find(text[first]) != std::string_view::npos;
}

} // namespace

Problem line_too_long(const Source& source, std::size_t line_begin) {
    return problem_at(source, line_begin,
                      fmt::format("expected lines of at most {} in a trace, found a longer one",
                                  in_words(longest_line)));
}

Problem too_many_steps(const std::string& name, std::size_t most) {
    return problem_of(name, fmt::format("expected at most {} steps to hold, found more", most),
                      "--max-steps N holds more of them, about 150 bytes each; `trace` writes any "
                      "number of them");
}

Problem too_much_to_hold(const std::string& name, std::size_t most, std::string_view unit) {
    return problem_of(
        name, fmt::format("expected steps to hold of at most {} {}, found more", most, unit),
        "--max-steps N, above 10 million, holds more; `trace` writes any number of "
        "steps");
}

bool InputCheck::holds_trace(const Source& source) {
    if (!is_trace_)
        is_trace_ = kind_ != Kind::other && kind_ != Kind::bytes && is_trace(source);
    return *is_trace_;
}

std::optional<Problem> InputCheck::operator()(const Source& source, std::size_t block) {
    const std::string_view text = source.view();
    if (kind_ != Kind::other)
        if (auto problem = packed_problem(source.name, text))
            return problem;
    const std::string_view added = text.substr(block);
    if (kind_ != Kind::bytes && added.find('\0') != std::string_view::npos) {
        // A file that another one names, and that is no text, is not quoted.
        auto problem = zero_byte_in(source);
        if (problem && kind_ == Kind::other)
            problem->excerpt.clear();
        return problem;
    }

    // What is no JSON from its first byte on is refused by the parser.
    if (kind_ == Kind::scene_or_trace && !has_begun_ && text.size() >= enough_to_judge) {
        has_begun_ = true;
        if (!can_begin_json(text) && !is_foreign_scene(source))
            return parse_json(source).problem();
    }

    // A trace is read line by line, so only its lines have to be short.
    const std::size_t newline = added.find('\n');
    const std::size_t line_end = newline == std::string_view::npos ? text.size() : block + newline;
    if (line_end - line_begin_ > longest_line && holds_trace(source))
        return line_too_long(source, line_begin_);
    if (newline != std::string_view::npos)
        line_begin_ = text.rfind('\n') + 1;

    if (text.size() > limits_.bytes && !holds_trace(source))
        return problem_of(source.name,
                          fmt::format("expected a file of at most {}, found a larger one",
                                      in_words(limits_.bytes)),
                          "--max-input SIZE raises the limit");
    return std::nullopt;
}

} // namespace rastertrace
