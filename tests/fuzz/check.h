// SPDX-License-Identifier: MIT
#pragma once

// What the fuzz targets share: a check that ends the run with its message, and when a text may be
// sent to a terminal.
//
//     check(stats.pixels <= stats.canvas, "more pixels were drawn than there are");

#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/text/problem.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace rastertrace::fuzz {

/// The largest canvas that is drawn or replayed: small ones take the same ways through the code, and more
/// than a thousand of them fit into a second.
inline constexpr int largest_side = 24;

inline bool is_small(const Canvas& canvas) {
    return canvas.width <= largest_side && canvas.height <= largest_side;
}

/// Stops with a message, which libFuzzer reports as a crash.
inline void check(bool holds, const std::string& message) {
    if (holds)
        return;
    std::fprintf(stderr, "check failed: %s\n", message.c_str());
    std::abort();
}

/// What the fuzzer made up, as a file.
inline Source source_of(std::string name, const std::uint8_t* data, std::size_t size) {
    return {std::move(name), std::string(data, data + size)};
}

/// True if `text` holds a C0 control other than `allowed`, DEL, or a C1 control (U+0080..U+009F,
/// which UTF-8 writes as C2 80..C2 9F).
inline bool has_control(std::string_view text, char allowed) {
    unsigned char before = 0;
    return std::any_of(text.begin(), text.end(), [&](char c) {
        const auto byte = static_cast<unsigned char>(c);
        const bool is_c1 = before == 0xC2 && 0x80 <= byte && byte <= 0x9F;
        before = byte;
        return (byte < 0x20 && c != allowed) || byte == 0x7F || is_c1;
    });
}

/// A message may have several lines, but nothing else that a terminal would obey.
inline void check_message(const Problem& problem) {
    check(!has_control(to_text(problem), '\n'), "a problem's text has a control character");
}

/// A description is one line.
inline void check_description(const std::string& description) {
    check(!has_control(description, ' '), "a step's description has a control character");
}

} // namespace rastertrace::fuzz
