// SPDX-License-Identifier: MIT
#include "text.h"

#include <fmt/core.h>

#include <unictype.h>
#include <uniwidth.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace rastertrace {

CodePoint first_code_point(std::string_view text) {
    // The lead byte says how many bytes follow, and the smallest character that needs so many.
    struct Form {
        unsigned char lead_mask;
        unsigned char lead;
        std::size_t length;
        char32_t smallest;
    };
    static constexpr std::array<Form, 4> forms{{{0x80, 0x00, 1, 0x0},
                                                {0xE0, 0xC0, 2, 0x80},
                                                {0xF0, 0xE0, 3, 0x800},
                                                {0xF8, 0xF0, 4, 0x10000}}};
    const auto lead = static_cast<unsigned char>(text.front());
    for (const Form& form : forms) {
        if ((lead & form.lead_mask) != form.lead || text.size() < form.length)
            continue;
        char32_t value = static_cast<unsigned char>(lead & ~form.lead_mask);
        bool continues = true;
        for (std::size_t i = 1; i < form.length; ++i) {
            const auto byte = static_cast<unsigned char>(text[i]);
            continues = continues && (byte & 0xC0) == 0x80;
            value = value << 6 | (byte & 0x3F);
        }
        const bool is_surrogate = 0xD800 <= value && value <= 0xDFFF;
        if (continues && form.smallest <= value && value <= 0x10FFFF && !is_surrogate)
            return {value, form.length};
    }
    return {not_a_character, 1};
}

bool is_unsafe(char32_t c) {
    const auto between = [c](char32_t first, char32_t last) { return first <= c && c <= last; };
    return between(0x00, 0x1F) || between(0x7F, 0x9F) || between(0x2028, 0x2029) ||
           between(0xFFF9, 0xFFFB) || uc_is_property_default_ignorable_code_point(c) ||
           uc_is_property_not_a_character(c);
}

std::string printable(std::string_view text) {
    std::string out;
    out.reserve(text.size());
    const auto is_plain = [](char byte) { return ' ' <= byte && byte <= '~'; };
    while (!text.empty()) {
        // Most text needs no second look.
        const auto plain = static_cast<std::size_t>(
            std::find_if_not(text.begin(), text.end(), is_plain) - text.begin());
        out += text.substr(0, plain);
        text.remove_prefix(plain);
        if (text.empty())
            break;
        const CodePoint character = first_code_point(text);
        if (character.value == not_a_character)
            out += fmt::format("<0x{:02X}>", static_cast<unsigned char>(text.front()));
        else if (is_unsafe(character.value))
            out += fmt::format("<U+{:04X}>", static_cast<unsigned>(character.value));
        else
            out += text.substr(0, character.length);
        text.remove_prefix(character.length);
    }
    return out;
}

std::size_t characters_in(std::string_view text) {
    std::size_t count = 0;
    for (; !text.empty(); ++count)
        text.remove_prefix(first_code_point(text).length);
    return count;
}

std::string_view first_characters(std::string_view text, std::size_t count) {
    std::string_view rest = text;
    for (; count > 0 && !rest.empty(); --count)
        rest.remove_prefix(first_code_point(rest).length);
    return text.substr(0, text.size() - rest.size());
}

namespace {

/// How many columns a character takes; 1 for a byte that is not UTF-8.
std::size_t columns_of(char32_t c) {
    if (c == not_a_character)
        return 1;
    return static_cast<std::size_t>(std::max(uc_width(c, "UTF-8"), 0));
}

} // namespace

std::size_t columns_in(std::string_view text) {
    std::size_t columns = 0;
    while (!text.empty()) {
        const CodePoint character = first_code_point(text);
        columns += columns_of(character.value);
        text.remove_prefix(character.length);
    }
    return columns;
}

std::string_view first_columns(std::string_view text, std::size_t count) {
    std::string_view rest = text;
    while (!rest.empty()) {
        const CodePoint character = first_code_point(rest);
        const std::size_t columns = columns_of(character.value);
        if (columns > count)
            break;
        count -= columns;
        rest.remove_prefix(character.length);
    }
    return text.substr(0, text.size() - rest.size());
}

std::string padded(std::string_view text, std::size_t width) {
    const std::size_t columns = columns_in(text);
    return std::string(text) + std::string(width - std::min(columns, width), ' ');
}

std::string shortened(std::string_view text, std::size_t width) {
    const std::string_view head = first_columns(text, width);
    if (head.size() == text.size())
        return std::string(text);
    return std::string(first_columns(text, width - std::min<std::size_t>(width, 3))) + "...";
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t space = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, space);
        text.remove_prefix(std::min(space + 1, text.size()));
        if (lines.empty() || columns_in(lines.back()) + 1 + columns_in(word) > width)
            lines.emplace_back(word);
        else
            lines.back() += fmt::format(" {}", word);
    }
    return lines;
}

namespace {

template <typename Text>
std::string joined_texts(std::span<const Text> texts, std::string_view separator) {
    std::string line;
    for (const Text& text : texts) {
        if (&text != &texts.front())
            line += separator;
        line += text;
    }
    return line;
}

} // namespace

std::string joined(std::span<const std::string> texts, std::string_view separator) {
    return joined_texts(texts, separator);
}

std::string joined(std::span<const std::string_view> texts, std::string_view separator) {
    return joined_texts(texts, separator);
}

namespace {

/// How many letters must be added, removed or changed to make one word of the other (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

} // namespace

std::string_view without_blanks(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = std::min(text.find_first_not_of(blanks), text.size());
    return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

std::vector<std::string> split_at(std::string_view text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text)
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& known) {
    // A slip of the pen: at most a third of the letters, two at the most. Long text is no slip.
    std::string_view nearest;
    std::size_t smallest = std::min<std::size_t>(2, word.size() / 3 + 1) + 1;
    if (word.size() > 40)
        return nearest;
    for (const std::string_view candidate : known) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < smallest && distance < candidate.size()) {
            smallest = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

namespace {

/// What other programs call something, and what it is called here. A word may mean several.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> words_elsewhere{{
    {"perspective", "frustum"},
    {"vertical_fov", "fov_y"},
    {"target", "look_at"},
    {"file", "obj"},
    {"z-buffer", "linear-z"},
    {"z-buffer", "inverse-z"},
    {"z-buffer", "ndc-z"},
}};

} // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known,
                         std::string_view quote) {
    std::vector<std::string> meant;
    for (const auto& [theirs, ours] : words_elsewhere)
        if (theirs == word && std::find(known.begin(), known.end(), ours) != known.end())
            meant.push_back(fmt::format("{0}{1}{0}", quote, ours));
    if (meant.empty())
        if (const std::string_view nearest = nearest_word(word, known); !nearest.empty())
            meant.push_back(fmt::format("{0}{1}{0}", quote, nearest));
    return meant.empty() ? std::string() : fmt::format("did you mean {}?", joined(meant, " or "));
}

namespace {

/// A character in a JSON string: two escapes outside of the first 2^16.
std::string json_escape(char32_t c) {
    const auto escaped = [](char32_t unit) {
        return fmt::format("\\u{:04x}", static_cast<unsigned>(unit));
    };
    if (c == not_a_character)
        return "\\ufffd";
    return c < 0x10000 ? escaped(c) : escaped(0xD7C0 + (c >> 10)) + escaped(0xDC00 + (c & 0x3FF));
}

} // namespace

std::string json_printable(std::string_view json) {
    const auto is_plain = [](char byte) { return static_cast<unsigned char>(byte) < 0x7F; };
    std::string text;
    for (;;) {
        const auto plain = static_cast<std::size_t>(
            std::find_if_not(json.begin(), json.end(), is_plain) - json.begin());
        text += json.substr(0, plain);
        json.remove_prefix(plain);
        if (json.empty())
            return text;
        const CodePoint character = first_code_point(json);
        const bool is_shown = character.value != not_a_character && !is_unsafe(character.value);
        text +=
            is_shown ? std::string(json.substr(0, character.length)) : json_escape(character.value);
        json.remove_prefix(character.length);
    }
}

std::string json_quoted(std::string_view text) {
    std::string out(room_for_quoted(text), '\0');
    out.resize(static_cast<std::size_t>(write_quoted(out.data(), text) - out.data()));
    return out;
}

char* write_quoted(char* out, std::string_view text) {
    static constexpr auto plain = [] {
        std::array<bool, 256> table{};
        for (std::size_t byte = ' '; byte <= '~'; ++byte)
            table[byte] = byte != '"' && byte != '\\';
        return table;
    }();
    const auto is_plain = [](char byte) { return plain[static_cast<unsigned char>(byte)]; };
    const auto write = [&out](std::string_view part) {
        out = std::copy(part.begin(), part.end(), out);
    };
    *out++ = '"';
    while (!text.empty()) {
        // Most text needs no second look.
        std::size_t length = 0;
        for (; length < text.size() && is_plain(text[length]); ++length)
            *out++ = text[length];
        text.remove_prefix(length);
        if (text.empty())
            break;
        const CodePoint character = first_code_point(text);
        const std::string_view bytes = text.substr(0, character.length);
        if (bytes == "\"" || bytes == "\\")
            write(std::string("\\").append(bytes));
        else if (bytes == "\n")
            write("\\n");
        else if (bytes == "\t")
            write("\\t");
        else if (character.value == not_a_character || is_unsafe(character.value))
            write(json_escape(character.value));
        else
            write(bytes);
        text.remove_prefix(character.length);
    }
    *out++ = '"';
    return out;
}

} // namespace rastertrace
