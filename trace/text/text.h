// SPDX-License-Identifier: MIT
#pragma once

// Text that came from a file, made safe to show: names and titles may hold anything, and a terminal
// obeys what it is sent.
//
//     printable("A\x1b]0;x\a")  // "A<U+001B>]0;x<U+0007>"

#include <cstddef>
#include <span>
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

/// True for characters that move the cursor or start a terminal command (C0, DEL, C1, separators of lines), that reorder
/// what is around them (direction marks), or that nobody sees: of no width (joiners, tags, selectors of variants),
/// fillers, soft hyphens, marks of annotations; and for those that no text should hold, like U+FFFE.
bool is_unsafe(char32_t character);

/// `text` with every unsafe character written as <U+001B>, and every byte that is not UTF-8 as <0xFF>: no two texts look
/// alike because of what cannot be seen.
std::string printable(std::string_view text);

/// How many characters `text` has.
std::size_t characters_in(std::string_view text);

/// The first `count` characters of `text`.
std::string_view first_characters(std::string_view text, std::size_t count);

/// How many columns of a terminal a printable text takes: two for wide characters, none for those
/// that combine with the one before.
std::size_t columns_in(std::string_view text);

/// As much of the beginning of `text` as `count` columns hold.
std::string_view first_columns(std::string_view text, std::size_t count);

/// `text` with blanks behind it, to `width` columns.
std::string padded(std::string_view text, std::size_t width);

/// `text`, cut to at most `width` columns; what was cut is told by "..." at the end.
std::string shortened(std::string_view text, std::size_t width);

/// How wide the text of reports is, in columns.
constexpr std::size_t text_width = 100;

/// `text` in lines of at most `width` characters; a longer word has a line of its own.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

/// A line without the blanks around it: spaces, tabs, carriage returns.
std::string_view without_blanks(std::string_view text);

/// The texts of a list, `separator` between them.
std::string joined(std::span<const std::string> texts, std::string_view separator);
std::string joined(std::span<const std::string_view> texts, std::string_view separator);

/// The parts of `text` between separators, one more than there are of these; some may be empty.
std::vector<std::string> split_at(std::string_view text, char separator);

/// The entry of `known` that `word` was probably meant to be, or "" if none is near.
std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& known);

/// The hint `did you mean NAME?` with that entry, in quotes where names have them, or "".
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known,
                         std::string_view quote = "");

/// `text` as a JSON string, quotes included. Unsafe characters are escaped.
std::string json_quoted(std::string_view text);

/// JSON with its unsafe characters escaped, but for blanks and the ends of lines, which stand between its values.
std::string json_printable(std::string_view json);

/// Writes the same to memory with so much room, and returns its end.
char* write_quoted(char* out, std::string_view text);
constexpr std::size_t room_for_quoted(std::string_view text) {
    return 6 * text.size() + 2; // \u001b
}

} // namespace rastertrace
