// SPDX-License-Identifier: MIT
#include "claim_line.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/number_fault.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <variant>

namespace rastertrace {

namespace {

using number_text::is_digit;

constexpr std::string_view blanks = " \t\r\n";

/// How much of a word is shown.
constexpr std::size_t shown_of_word = 40;

/// The mark at the front of `text`, or "".
std::string_view mark_at(std::string_view text) {
    constexpr std::array<std::string_view, 13> marks{"->", "..", "<=", "(", ")", "[", "]",
                                                     ",",  ";",  "|",  ":", "=", "~"};
    for (const std::string_view mark : marks)
        if (text.starts_with(mark))
            return mark;
    return {};
}

/// The length of the word at the front of `text`: to a blank, a mark, a quote or a comment. 4/3x+7/3 are three.
std::size_t word_length(std::string_view text) {
    std::size_t length = 1;
    while (length < text.size() && (blanks.find(text[length]) == std::string_view::npos) &&
           text[length] != '"' && text[length] != '#' && mark_at(text.substr(length)).empty())
        ++length;
    text = text.substr(0, length);
    const std::size_t letter = text.find_first_not_of("+-./0123456789");
    if (letter == std::string_view::npos || (text[letter] != 'x' && text[letter] != 'y'))
        return length;
    const std::string_view behind = text.substr(letter + 1);
    const bool is_last = behind.empty();
    const bool has_term =
        behind.size() > 1 && (behind[0] == '+' || behind[0] == '-') && is_digit(behind[1]);
    const bool has_factor = letter > 0 && is_digit(text[letter - 1]);
    if (has_factor && (is_last || has_term))
        return letter;
    return has_term ? letter + 1 : length;
}

/// Characters of a line, and the plain ones that are read in their place. Of two that begin alike, the longer is first.
struct Spelling {
    std::string_view typed;
    std::string_view read;
};
constexpr auto spellings = std::to_array<Spelling>({
    {"\\text{", ""},     {"\\mathrm{", ""},    {"_{", "_"},          {"\\leq", "<="},
    {"\u2264", "<="},    {"\u2208", "="},      {"\u0394x", "dx"},    {"\u0394y", "dy"},
    {"\u2206x", "dx"},   {"\u2206y", "dy"},    {"\u0394", " "},      {"\u2206", " "},
    {"\u2032", "'"},     {"\u2019", "'"},      {"<=", "<="},         {"<", "<="},
    {"\\frac", "frac "}, {"\\tfrac", "frac "}, {"\\dfrac", "frac "}, {"\\sqrt", "sqrt"},
    {"\\pi", "pi"},      {"\\cdot", "*"},      {"}{", ")/("},        {"{", "("},
    {"}", ")"},          {"$", " "},           {"=>", "->"},         {"~=", "~"},
    {"...", ".."},       {"\u2026", ".."},     {"\u2192", "->"},     {"\u21D2", "->"},
    {"\u2212", "-"},     {"\u2013", "-"},      {"\u2014", "-"},      {"\u2248", "~"},
    {"\u2243", "~"},     {"\u00A0", " "},      {"\u202F", " "},      {"\u2009", " "},
    {"\u201C", "\""},    {"\u201D", "\""},     {"\u221A", "sqrt "},  {"\u03C0", "pi"},
    {"\u00B0", " deg"},  {"\u2044", "/"},      {"\u2215", "/"},      {"\u00B7", "*"},
    {"\u00D7", "*"},     {"\u22C5", "*"},      {"\u00BC", "1/4"},    {"\u00BD", "1/2"},
    {"\u00BE", "3/4"},   {"\u2153", "1/3"},    {"\u2154", "2/3"},    {"\u2155", "1/5"},
    {"\u2156", "2/5"},   {"\u2157", "3/5"},    {"\u2158", "4/5"},    {"\u2159", "1/6"},
    {"\u215A", "5/6"},   {"\u215B", "1/8"},    {"\u215C", "3/8"},    {"\u215D", "5/8"},
    {"\u215E", "7/8"},
});

/// True of #808080 and #808080ff, which are no comments.
bool is_color_at(std::string_view text) {
    const std::size_t end =
        std::min(text.find_first_not_of("0123456789abcdefABCDEF", 1), text.size());
    return (end == 7 || end == 9) &&
           (end == text.size() || std::isalnum(static_cast<unsigned char>(text[end])) == 0);
}

} // namespace

ClaimLine::ClaimLine(const Source& source, std::size_t begin, std::size_t end, CommaUse& commas)
    : source_(source), commas_(commas),
      raw_(without_blanks(std::string_view(source.text).substr(begin, end - begin))), text_(raw_) {
    spell();
    leave_out_numbering();
    read_words();
    translate();
}

/// Copies the line up to its comment, with plain characters in place of those that mean the same. What stands in quotes
/// stays as it is.
void ClaimLine::spell() {
    std::size_t at = 0;
    while (at < raw_.size()) {
        if (raw_[at] == '#' && !is_color_at(raw_.substr(at)) &&
            !without_blanks(spelled_).ends_with("color"))
            break;
        const std::size_t quoted_from = at;
        const std::size_t before = spelled_.size();
        spell_character(at);
        if (spelled_.size() == before || spelled_.back() != '"')
            continue;
        while (at < raw_.size() && raw_[at] != '"' && !raw_.substr(at).starts_with("\u201D"))
            for (std::size_t i = raw_[at] == '\\' ? 2 : 1; i > 0 && at < raw_.size(); --i) {
                spelled_ += raw_[at];
                places_.push_back(at++);
            }
        if (at == raw_.size())
            throw problem_at(source_, offset_of_raw(quoted_from),
                             "expected a closing quote, found none");
        spell_character(at);
    }
    text_ = without_blanks(raw_.substr(0, at));
    // A sentence ends with a full stop; a number that goes on has two of them.
    const std::string_view sentence = without_blanks(spelled_);
    if (sentence.ends_with('.') && !sentence.ends_with("..") && sentence.size() > 1)
        spelled_.resize(sentence.size() - 1);
}

void ClaimLine::spell_character(std::size_t& at) {
    const std::string_view rest = raw_.substr(at);
    const auto* const known =
        std::find_if(spellings.begin(), spellings.end(),
                     [rest](const Spelling& one) { return rest.starts_with(one.typed); });
    std::string_view read = known == spellings.end() ? rest.substr(0, 1) : known->read;
    const std::string_view typed = known == spellings.end() ? read : known->typed;
    if (typed.size() > 1 && typed.ends_with('{') && read.size() < 2)
        ++plain_braces_;
    if (typed == "}" && plain_braces_ > 0) {
        --plain_braces_;
        read = "";
    }
    if (read.empty()) {
        at += typed.size();
        return;
    }
    const bool is_behind_digit = !spelled_.empty() && is_digit(spelled_.back());
    if (typed == "\u2013" && is_behind_digit && rest.size() > typed.size() &&
        is_digit(rest[typed.size()]))
        read = ".."; // from 1 to 3 is 1–3
    if (is_behind_digit && is_digit(read.front()) && known != spellings.end()) { // 3⅛
        spelled_ += ' ';
        places_.push_back(at);
    }
    spelled_ += read;
    places_.insert(places_.end(), read.size(), at);
    at += typed.size();
}

/// `- y=2: ...` and `1. y=2: ...` are lines of a list.
void ClaimLine::leave_out_numbering() {
    const std::string_view line = spelled_;
    std::size_t end = 0;
    for (const std::string_view bullet : {"- ", "* ", "\u2022 "})
        if (line.starts_with(bullet))
            end = bullet.size();
    const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
    const bool is_letter =
        line.size() > 1 && std::isalpha(static_cast<unsigned char>(line[0])) != 0 && line[1] == ')';
    const std::size_t label = is_letter ? 1 : digits;
    if (label > 0 && label + 1 < line.size() && (line[label] == '.' || line[label] == ')') &&
        line[label + 1] == ' ')
        end = label + 2;
    spelled_.erase(0, end);
    places_.erase(places_.begin(), places_.begin() + static_cast<std::ptrdiff_t>(end));
}

void ClaimLine::read_words() {
    for (std::size_t at = 0; at < spelled_.size();) {
        const std::string_view rest = std::string_view(spelled_).substr(at);
        if (blanks.find(rest.front()) != std::string_view::npos) {
            ++at;
            continue;
        }
        if (rest.front() == '"') {
            read_quoted(at);
            continue;
        }
        const std::string_view mark = mark_at(rest);
        const std::size_t length = mark.empty() ? word_length(rest) : mark.size();
        add({.text = std::string(rest.substr(0, length)),
             .offset = offset_of(at),
             .is_mark = !mark.empty(),
             .begin = at,
             .end = at + length});
        at += length;
    }
}

/// Puts English words in the place of others. Short ones are read so beside numbers only: a and e are names, too.
void ClaimLine::translate() {
    const auto is_number = [this](std::size_t i) {
        return i < words_.size() && !words_[i].is_quoted && !words_[i].text.empty() &&
               std::string_view("-+.?0123456789").find(words_[i].text[0]) != std::string_view::npos;
    };
    bool was_translated = false;
    for (std::size_t i = 0; i < words_.size(); ++i) {
        const bool is_word = !words_[i].is_quoted && !words_[i].is_mark;
        const std::string_view english = is_word ? english_word(words_[i].text) : "";
        const bool is_short = english == "from" || english == "to" || english == "and";
        if (english == "from" && !is_number(i + 1) && was_translated) {
            words_.erase(words_.begin() + static_cast<std::ptrdiff_t>(i--)); // inclinação de AB
            continue;
        }
        was_translated = !english.empty() && (!is_short || is_number(i + 1));
        if (was_translated)
            words_[i].text = english;
    }
}

/// A string as in JSON.
void ClaimLine::read_quoted(std::size_t& at) {
    std::size_t end = at + 1;
    while (end < spelled_.size() && spelled_[end] != '"')
        end += spelled_[end] == '\\' ? 2 : 1;
    end = std::min(end + 1, spelled_.size());
    add({.text = plain_text(std::string_view(spelled_).substr(at, end - at)),
         .offset = offset_of(at),
         .is_quoted = true,
         .begin = at,
         .end = end});
    at = end;
}

void ClaimLine::add(ClaimWord word) {
    if (words_.size() == most_words)
        throw problem_at(
            source_, word.offset,
            fmt::format("expected at most {} words in a line, found more", most_words));
    words_.push_back(std::move(word));
}

/// In the source, of a byte of the line as it is read; of its end, behind the last one.
std::size_t ClaimLine::offset_of(std::size_t at) const {
    return at < spelled_.size() ? offset_of_raw(places_[at]) : offset_of_raw(0) + text_.size();
}

std::size_t ClaimLine::offset_of_raw(std::size_t at) const {
    return static_cast<std::size_t>(raw_.data() - source_.text.data()) + at;
}

ClaimWord ClaimLine::peek(std::size_t ahead) const {
    if (next_ + ahead < words_.size())
        return words_[next_ + ahead];
    return {.text = {},
            .offset = offset_of(spelled_.size()),
            .begin = spelled_.size(),
            .end = spelled_.size()};
}

ClaimWord ClaimLine::next() {
    ClaimWord word = peek();
    next_ = std::min(next_ + 1, words_.size());
    return word;
}

bool ClaimLine::has(std::string_view plain) const {
    return std::any_of(words_.begin() + static_cast<std::ptrdiff_t>(next_), words_.end(),
                       [plain](const ClaimWord& word) { return word.is(plain); });
}

void ClaimLine::leave_out_fillers() {
    constexpr std::array<std::string_view, 4> fillers{"the", "of", "at", "goes"};
    std::erase_if(words_, [&](const ClaimWord& word) {
        return std::any_of(fillers.begin(), fillers.end(),
                           [&word](std::string_view filler) { return word.is(filler); });
    });
    for (ClaimWord& word : words_)
        if (word.is("is") || word.is("are") || word.is("has")) {
            word.text = ":";
            word.is_mark = true;
        }
}

void ClaimLine::part(std::size_t length, std::size_t left_out) {
    ClaimWord& first = words_[next_];
    ClaimWord second = first;
    second.text.erase(0, length + left_out);
    second.begin += length + left_out;
    second.offset = offset_of(second.begin);
    first.text.resize(length);
    first.end = first.begin + length;
    words_.insert(words_.begin() + static_cast<std::ptrdiff_t>(next_) + 1, std::move(second));
}

bool ClaimLine::take_last_dots() {
    if (!peek().is("..") || !is_end(1))
        return false;
    ++next_;
    return true;
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

std::optional<ClaimWord> ClaimLine::take_number(const NumberSpelling& spelling) {
    const ClaimWord first = peek();
    if (first.is(open_value))
        return next();
    if (first.is_quoted)
        return std::nullopt;
    const auto read = number_at(std::string_view(spelled_).substr(first.begin), spelling);
    if (const auto* const fault = std::get_if<NumberFault>(&read)) {
        if (*fault != NumberFault::malformed)
            fail(first, expected_instead_of(*fault));
        return std::nullopt;
    }
    last_ = std::get<TypedNumber>(read);
    commas_.is_seen = commas_.is_seen || last_.has_comma;
    // It ends where a word does.
    const std::size_t end = first.begin + last_.length;
    std::size_t behind = next_;
    while (behind < words_.size() && words_[behind].begin < end)
        ++behind;
    if (words_[behind - 1].end > end)
        return std::nullopt;
    next_ = behind;
    return ClaimWord{.text = last_.text, .offset = first.offset, .begin = first.begin, .end = end};
}

ClaimWord ClaimLine::number(const NumberSpelling& spelling) {
    auto word = take_number(spelling);
    if (!word)
        fail(peek(), "a number, like 3.125 or 25/8");
    return std::move(*word);
}

/// The next one of a list, perhaps with its name before it: xl = -1/4, left -1/4.
ClaimWord ClaimLine::value_of_list(bool has_mixed) {
    const bool is_side = std::any_of(row_sides.begin(), row_sides.end(),
                                     [this](std::string_view side) { return peek().is(side); });
    if (peek().is_name() && !typed_value(peek().text) &&
        (peek(1).is("=") || (is_side && peek(1).is(":"))))
        next_ += 2;
    else if (is_side)
        ++next_;
    ClaimWord value = number({.has_decimal_comma = commas_.is_decimal, .has_mixed = has_mixed});
    while (peek().is("=") && !peek(1).is_mark) { // 2 - 9/4 = -1/4
        ++next_;
        const ClaimWord same = number({.has_decimal_comma = commas_.is_decimal});
        const auto first = typed_value(value.text);
        const auto second = typed_value(same.text);
        const Rational difference = first && second ? first->value - second->value : Rational(0);
        const int places = second ? second->places.value_or(0) : 0;
        const bool is_rounded =
            places > 0 && std::abs(difference.get_d()) * std::pow(10.0, places) <= 1;
        if (sgn(difference) != 0 && !is_rounded)
            fail(same, "a number that is equal to the one before it");
        if (!is_rounded)
            value = same;
    }
    return value;
}

bool ClaimLine::take_separator() {
    for (const std::string_view mark : {",", ";", "|", "..", "to", "and"})
        if (take(mark))
            return true;
    return false;
}

/// Commas both with and without a blank behind them, or beside semicolons and bars, are those of decimals and those
/// between numbers, but for those beside a fraction. So is the only comma where one number belongs. With blanks alone
/// between numbers, nobody knows.
void ClaimLine::note_commas(std::size_t count) {
    std::size_t tight = 0;
    std::size_t loose = 0;
    std::optional<std::size_t> apart; // by a blank, or a stroke between blanks
    const auto begins_number = [this](std::size_t i) {
        return i < words_.size() && words_[i].text.find_first_of("0123456789") < 2 &&
               words_[i].text.find_first_not_of("+-./0123456789") == std::string::npos;
    };
    const auto is_fraction = [this](std::size_t i) {
        return words_[i].text.find('/') != std::string::npos;
    };
    for (std::size_t i = next_; i < words_.size() && !words_[i].is("->"); ++i) {
        const bool is_tight =
            words_[i].is(",") && 0 < i && i + 1 < words_.size() &&
            words_[i - 1].end == words_[i].begin && words_[i].end == words_[i + 1].begin &&
            is_digit(spelled_[words_[i].begin - 1]) && is_digit(spelled_[words_[i].end]);
        if (is_tight && (is_fraction(i - 1) || is_fraction(i + 1)))
            continue;
        tight += is_tight ? 1 : 0;
        if (begins_number(i) &&
            (begins_number(i + 1) ||
             (i + 2 < words_.size() && words_[i + 1].is("/") && begins_number(i + 2))))
            apart = i;
        const bool is_apart = i + 1 < words_.size() && words_[i].end < words_[i + 1].begin;
        constexpr std::array<std::string_view, 5> apart_by{";", "|", "to", "and", ".."};
        const bool is_other = std::any_of(apart_by.begin(), apart_by.end(),
                                          [&](std::string_view one) { return words_[i].is(one); });
        loose += is_other || (words_[i].is(",") && is_apart) ? 1 : 0;
    }
    if (tight > 0 && loose == 0 && apart && !commas_.is_decimal)
        fail(words_[*apart + 1], "`;` between two numbers",
             "a comma may be that of a decimal, or stand between numbers: 0,25; 3,125 or 0, 25, 3, "
             "125");
    if (tight > 0 && (count == 1 || (count > 0 && loose > 0)))
        commas_.is_decimal = commas_.is_seen = true;
}

std::vector<ClaimWord> ClaimLine::numbers(std::size_t count, std::size_t usual, bool has_mixed) {
    note_commas(std::max(count, count == 1 ? 1 : usual));
    const std::size_t begin = next_;
    const bool is_list = peek().is("[") || (peek().is("(") && !take_number({}));
    next_ = begin + (is_list ? 1 : 0);
    const std::string_view closing = is_list && words_[begin].is("[") ? "]" : ")";
    std::vector<ClaimWord> values;
    std::optional<ClaimWord> with_comma;
    std::optional<ClaimWord> mixed;
    bool is_by_blanks = false;
    bool has_more = true;
    while (has_more) {
        take("from");
        values.push_back(value_of_list(has_mixed));
        if (last_.has_comma)
            with_comma = values.back();
        if (last_.is_mixed)
            mixed = values.back();
        has_more = values.size() != count && !take_last_dots() && take_separator();
        if (has_more && take_last_dots())
            break;
        if (has_more && (peek().is("pixels") || peek().is("pixel")))
            break;
        if (values.size() != count && !has_more) {
            const std::size_t behind = next_;
            const bool is_named = peek().is("right");
            has_more = is_by_blanks = is_named || take_number({}).has_value();
            next_ = behind;
        }
    }
    // What can be read in two ways is not guessed.
    const bool has_too_few = values.size() < std::max(count, usual);
    if (with_comma && has_too_few)
        refuse_two_readings(*with_comma, fmt::format("{} numbers", std::max(count, usual)),
                            "this file has decimal commas: a comma with a blank behind it, or a "
                            "`;`, stands between two numbers");
    if (mixed && count != 1 && (is_by_blanks || has_too_few))
        refuse_two_readings(*mixed, "commas between numbers", "");
    if (is_list)
        expect(closing, fmt::format("`{}`", closing));
    const bool is_open = values.size() == 1 && values.front().is(open_value);
    if (values.size() < count && !is_open)
        fail(peek(), fmt::format("{} numbers in all", count));
    return values;
}

/// -1,3 and 2 1/2 are one number each, or two.
void ClaimLine::refuse_two_readings(const ClaimWord& number, std::string_view expected,
                                    std::string hint) const {
    const std::string typed = spelled_.substr(number.begin, number.end - number.begin);
    const std::size_t between = typed.find_first_of(", ");
    throw problem_at(source_, number.offset,
                     fmt::format("expected {}, found {}, which is {}, or {} and {}", expected,
                                 typed, number.text, typed.substr(0, between),
                                 without_blanks(std::string_view(typed).substr(between + 1))),
                     std::move(hint));
}

std::string ClaimLine::rest() {
    const ClaimWord first = next();
    if (first.is_quoted) {
        expect_end();
        return first.text;
    }
    next_ = words_.size();
    return std::string(text_.substr(first.offset - offset_of_raw(0)));
}

void ClaimLine::fail(const ClaimWord& word, std::string_view expected, std::string hint) const {
    const bool is_end = word.text.empty() && !word.is_quoted;
    throw problem_at(
        source_, word.offset,
        fmt::format("expected {}, found {}", expected,
                    is_end ? "the end of the line" : shortened(word.text, shown_of_word)),
        std::move(hint));
}

void ClaimLine::fail_at_begin(std::string message, std::string hint) const {
    throw problem_at(source_, offset_of_raw(0), std::move(message), std::move(hint));
}

std::string_view english_word(std::string_view typed) {
    constexpr auto words = std::to_array<Words>({
        "and##claim",     "angle##claim",  "centroid##claim", "color##claim",   "cosine##claim",
        "culled##claim",  "depth##claim",  "drawn##claim",    "edge##claim",    "fails##claim",
        "from##claim",    "has##claim",    "hidden##claim",   "inside##claim",  "intensity##claim",
        "is##claim",      "left##claim",   "light##claim",    "matrix##claim",  "none##claim",
        "off##claim",     "on##claim",     "order##claim",    "outside##claim", "passes##claim",
        "picture##claim", "plane##claim",  "right##claim",    "row##claim",     "rows##claim",
        "scene##claim",   "slope##claim",  "to##claim",       "view##claim",    "visible##claim",
        "weights##claim", "vertex##claim", "first##claim",    "last##claim",    "face##claim",
    });
    static const auto known = [&words] {
        std::map<std::string, std::string_view, std::less<>> english;
        for (const Words& word : words) // of several, all mean the same
            for (const std::string& other : split_at(word.in(Language::portuguese), '|'))
                english.emplace(other, word.in(Language::english));
        return english;
    }();
    const auto found = known.find(typed);
    return found == known.end() ? std::string_view() : found->second;
}

bool is_one_word(std::string_view text) {
    const bool is_spelled_alike =
        std::none_of(spellings.begin(), spellings.end(), [text](const Spelling& one) {
            return text.find(one.typed) != std::string_view::npos;
        });
    return !text.empty() && text.front() != '"' && text.front() != '#' &&
           blanks.find(text.front()) == std::string_view::npos && mark_at(text).empty() &&
           word_length(text) == text.size() && is_spelled_alike && !text.ends_with('.');
}

} // namespace rastertrace
