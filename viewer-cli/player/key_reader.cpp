// SPDX-License-Identifier: MIT
// The sequences are those of xterm ("XTerm Control Sequences": PC-style function keys, SGR mouse mode 1006), which
// other terminals send as well.

#include "player/key_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

constexpr char escape = '\x1b';

struct NamedKey {
    std::string_view sequence; ///< behind Escape and [ or O, without parameters
    std::string_view name;
};

constexpr std::array named_keys = std::to_array<NamedKey>({
    {"A", "Up"},
    {"B", "Down"},
    {"C", "Right"},
    {"D", "Left"},
    {"H", "Home"},
    {"F", "End"},
    {"P", "F1"},
    {"1~", "Home"},
    {"3~", "Delete"},
    {"4~", "End"},
    {"5~", "PageUp"},
    {"6~", "PageDown"},
    {"7~", "Home"},
    {"8~", "End"},
    {"11~", "F1"},
});

/// How many bytes a character takes that begins with this one, in UTF-8.
std::size_t length_of_character(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte < 0xC0 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

/// The numbers between semicolons; 0 for none.
std::vector<std::size_t> parameters_in(std::string_view text) {
    std::vector<std::size_t> numbers;
    while (true) {
        const std::size_t end = std::min(text.find(';'), text.size());
        std::size_t number = 0;
        std::from_chars(text.data(), text.data() + end, number);
        numbers.push_back(number);
        if (end == text.size())
            return numbers;
        text.remove_prefix(end + 1);
    }
}

/// `<0;12;7M`: the first button was pressed in column 12 of line 7. The wheel is buttons 64 and 65, which are keys.
KeyPress click_in(std::string_view sequence) {
    const auto numbers = parameters_in(sequence.substr(1, sequence.size() - 2));
    if (numbers.size() == 3 && sequence.ends_with('M') && (numbers[0] == 64 || numbers[0] == 65))
        return {numbers[0] == 64 ? "Left" : "Right"};
    const bool is_press = sequence.ends_with('M') && numbers.size() == 3 && numbers[0] == 0;
    if (!is_press || numbers[1] == 0 || numbers[2] == 0)
        return {};
    return {"Click", numbers[1] - 1, numbers[2] - 1};
}

/// `1;2C` is C with Shift.
std::string name_of(std::string_view sequence) {
    const char last = sequence.back();
    const auto numbers = parameters_in(sequence.substr(0, sequence.size() - 1));
    const bool has_shift = numbers.size() == 2 && numbers[1] == 2;
    const std::string plain = last == '~' ? fmt::format("{}~", numbers[0]) : std::string(1, last);
    for (const NamedKey& key : named_keys)
        if (key.sequence == plain)
            return (has_shift ? "Shift+" : "") + std::string(key.name);
    return {};
}

/// A control character, or one that has a name.
std::string name_of(char c) {
    switch (c) {
    case '\r':
    case '\n':
        return "Enter";
    case '\t':
        return "Tab";
    case ' ':
        return "Space";
    case '\b':
    case '\x7f':
        return "Backspace";
    default:
        return '\0' < c && c < ' ' ? std::string("Ctrl+") + static_cast<char>(c + 'a' - 1)
                                   : std::string(1, c);
    }
}

} // namespace

KeyPress KeyReader::take_key(std::size_t bytes, std::string key) {
    bytes_.erase(0, bytes);
    return {std::move(key)};
}

std::optional<KeyPress> KeyReader::next() {
    if (bytes_.empty())
        return std::nullopt;
    if (bytes_.front() == escape)
        return sequence();
    const std::size_t length = length_of_character(bytes_.front());
    if (bytes_.size() < length)
        return std::nullopt;
    return take_key(length, length == 1 ? name_of(bytes_.front()) : bytes_.substr(0, length));
}

/// What begins with Escape: `ESC [ parameters letter` or `ESC O letter`.
std::optional<KeyPress> KeyReader::sequence() {
    if (bytes_.size() < 2)
        return std::nullopt;
    if (bytes_[1] != '[' && bytes_[1] != 'O')
        return take_key(1, "Escape");
    const auto is_final = [](char c) { return '@' <= c && c <= '~'; };
    const auto last = std::find_if(bytes_.begin() + 2, bytes_.end(), is_final);
    if (last == bytes_.end())
        return std::nullopt;
    const std::string all(bytes_.begin() + 2, last + 1);
    bytes_.erase(bytes_.begin(), last + 1);
    return all.front() == '<' ? click_in(all) : KeyPress{name_of(all)};
}

std::optional<KeyPress> KeyReader::next_of_rest() {
    if (auto key = next())
        return key;
    if (bytes_.empty())
        return std::nullopt;
    return take_key(bytes_.front() == escape ? 1 : bytes_.size(),
                    bytes_.front() == escape ? "Escape" : "");
}

} // namespace rastertrace
