// SPDX-License-Identifier: MIT
#include "claim_line.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::string_view blanks = " \t\r";

/// How much of a word is shown.
constexpr std::size_t shown_of_word = 40;

/// The mark at the front of `text`, or "".
std::string_view mark_at(std::string_view text) {
    constexpr std::array<std::string_view, 7> marks{"->", "..", "(", ")", ",", ":", "="};
    for (const std::string_view mark : marks)
        if (text.starts_with(mark))
            return mark;
    return {};
}

/// The length of the word at the front of `text`: to a blank, a mark, a quote or a comment.
std::size_t word_length(std::string_view text) {
    std::size_t length = 1;
    while (length < text.size() && (blanks.find(text[length]) == std::string_view::npos) &&
           text[length] != '"' && text[length] != '#' && mark_at(text.substr(length)).empty())
        ++length;
    return length;
}

/// A character that looks like a mark or a blank of a table of claims, and what to type instead.
struct LookAlike {
    std::string_view character;
    std::string_view hint;
};
constexpr std::array<LookAlike, 9> look_alikes{
    {{"\u2212", "a minus is -, not U+2212"},
     {"\u2013", "a minus is -, not U+2013"},
     {"\u00A0", "a blank is a plain space, not U+00A0"},
     {"\u202F", "a blank is a plain space, not U+202F"},
     {"\u2009", "a blank is a plain space, not U+2009"},
     {"\u2192", "an arrow is ->, not U+2192"},
     {"\u2026", "from the first to the last pixel is .., not U+2026"},
     {"\u201C", "a quote is \", not U+201C"},
     {"\u201D", "a quote is \", not U+201D"}}};

/// The hint for the first look-alike of the list that a word has, or "".
std::string hint_for_look_alike(const ClaimWord& word) {
    for (const LookAlike& known : look_alikes)
        if (!word.is_quoted && word.text.find(known.character) != std::string::npos)
            return std::string(known.hint);
    return {};
}

/// True if a comma stands between two digits, as in 0,25.
bool has_decimal_comma(std::string_view text) {
    using number_text::is_digit;
    for (std::size_t at = text.find(','); at != std::string_view::npos; at = text.find(',', at + 1))
        if (0 < at && at + 1 < text.size() && is_digit(text[at - 1]) && is_digit(text[at + 1]))
            return true;
    return false;
}

} // namespace

ClaimLine::ClaimLine(const Source& source, std::size_t begin, std::size_t end)
    : source_(source),
      raw_(without_blanks(std::string_view(source.text).substr(begin, end - begin))), text_(raw_) {
    read_words();
}

void ClaimLine::read_words() {
    for (std::size_t at = 0; at < raw_.size();) {
        const bool is_color = !words_.empty() && words_.back().is("color");
        if (blanks.find(raw_[at]) != std::string_view::npos) {
            ++at;
        } else if (raw_[at] == '#' && !is_color) {
            text_ = without_blanks(raw_.substr(0, at));
            return;
        } else {
            at = raw_[at] == '"' ? read_quoted(at) : read_word(at);
        }
    }
}

std::size_t ClaimLine::read_word(std::size_t at) {
    const std::string_view mark = mark_at(raw_.substr(at));
    const std::size_t length = mark.empty() ? word_length(raw_.substr(at)) : mark.size();
    add({.text = std::string(raw_.substr(at, length)),
         .offset = offset_of(raw_.substr(at)),
         .is_mark = !mark.empty()});
    return at + length;
}

/// A string as in JSON.
std::size_t ClaimLine::read_quoted(std::size_t at) {
    std::size_t end = at + 1;
    while (end < raw_.size() && raw_[end] != '"')
        end += raw_[end] == '\\' ? 2 : 1;
    if (end >= raw_.size())
        throw problem_at(source_, offset_of(raw_.substr(at)),
                         "expected a closing quote, found none");
    add({.text = plain_text(raw_.substr(at, end + 1 - at)),
         .offset = offset_of(raw_.substr(at)),
         .is_quoted = true});
    return end + 1;
}

void ClaimLine::add(ClaimWord word) {
    if (words_.size() == most_words)
        throw problem_at(
            source_, word.offset,
            fmt::format("expected at most {} words in a line, found more", most_words));
    words_.push_back(std::move(word));
}

std::size_t ClaimLine::offset_of(std::string_view part) const {
    return static_cast<std::size_t>(part.data() - source_.text.data());
}

ClaimWord ClaimLine::peek(std::size_t ahead) const {
    if (next_ + ahead < words_.size())
        return words_[next_ + ahead];
    return {.text = {}, .offset = offset_of(text_) + text_.size()};
}

ClaimWord ClaimLine::next() {
    ClaimWord word = peek();
    next_ = std::min(next_ + 1, words_.size());
    return word;
}

bool ClaimLine::take(std::string_view plain) {
    const bool is_next = peek().is(plain);
    next_ += is_next ? 1 : 0;
    return is_next;
}

bool ClaimLine::take(std::string_view plain, std::string_view mark) {
    const bool are_next = peek().is(plain) && peek(1).is(mark);
    next_ += are_next ? 2 : 0;
    return are_next;
}

void ClaimLine::expect(std::string_view mark, std::string expected) {
    if (!take(mark))
        fail(peek(), expected);
}

void ClaimLine::expect_end() const {
    if (!at_end())
        fail(peek(), "the end of the line");
}

std::string_view ClaimLine::text_behind_colon() const {
    const auto colon = std::find_if(words_.begin(), words_.end(),
                                    [](const ClaimWord& word) { return word.is(":"); });
    return colon == words_.end() ? "" : text_.substr(colon->offset - offset_of(text_));
}

std::string ClaimLine::rest() {
    const ClaimWord first = next();
    if (first.is_quoted) {
        expect_end();
        return first.text;
    }
    next_ = words_.size();
    return std::string(text_.substr(first.offset - offset_of(text_)));
}

void ClaimLine::fail(const ClaimWord& word, std::string_view expected, std::string hint) const {
    const bool is_end = word.text.empty() && !word.is_quoted;
    if (const std::string look_alike = hint_for_look_alike(word); !look_alike.empty())
        hint = look_alike;
    else if (hint.empty() && has_decimal_comma(text_behind_colon()))
        hint = "a decimal has a point: 0.25, not 0,25";
    throw problem_at(
        source_, word.offset,
        fmt::format("expected {}, found {}", expected,
                    is_end ? "the end of the line" : shortened(word.text, shown_of_word)),
        std::move(hint));
}

void ClaimLine::fail_at_begin(std::string message, std::string hint) const {
    throw problem_at(source_, offset_of(raw_), std::move(message), std::move(hint));
}

bool is_one_word(std::string_view text) {
    return !text.empty() && text.front() != '"' && text.front() != '#' &&
           blanks.find(text.front()) == std::string_view::npos && mark_at(text).empty() &&
           word_length(text) == text.size();
}

} // namespace rastertrace
