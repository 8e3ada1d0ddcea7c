// SPDX-License-Identifier: MIT
#pragma once

// Text that came from a file, made safe to show: names and titles may hold anything, and a terminal
// obeys what it is sent.
//
//     printable("A\x1b]0;x\a")  // "A<U+001B>]0;x<U+0007>"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// One character of a UTF-8 text.
struct CodePoint {
    char32_t value = 0;     ///< `not_a_character` for a byte that is not UTF-8
    std::size_t length = 1; ///< bytes
};

inline constexpr char32_t not_a_character = 0xFFFFFFFF;

/// The character at the front of `text`, which must not be empty.
CodePoint first_code_point(std::string_view text);

/// True for characters that move the cursor, start a terminal command, or reorder what is around
/// them: control characters (C0, DEL, C1), line and paragraph separators, direction marks.
bool is_unsafe(char32_t character);

/// `text` with every unsafe character written as <U+001B>, and every byte that is not UTF-8 as
/// <0xFF>.
std::string printable(std::string_view text);

/// How many characters `text` has.
std::size_t characters_in(std::string_view text);

/// The first `count` characters of `text`.
std::string_view first_characters(std::string_view text, std::size_t count);

/// `text`, cut to at most `width` characters; what was cut is told by "..." at the end.
std::string shortened(std::string_view text, std::size_t width);

/// The entry of `known` that `word` was probably meant to be, or "" if none is near.
std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& known);

/// The hint `did you mean NAME?` with that entry, in quotes where names have them, or "".
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known,
                         std::string_view quote = "");

} // namespace rastertrace
