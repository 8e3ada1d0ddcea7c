// SPDX-License-Identifier: MIT
#pragma once

// A line of a table of claims, word by word. Characters that mean the same are read alike: a minus of any kind, an
// arrow, dots, a vulgar fraction.
//
//     ClaimLine line(source, begin, end, commas);   // y=2: −¼, 25/8
//     line.next().text;                     // "y"
//     line.expect("=", "`=`");

#include "typed_number.h"

#include <algorithm>
#include <array>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// A word, a number, or a mark between them: ( ) [ ] , ; | : = <= -> .. ~
struct ClaimWord {
    std::string text; ///< without quotes; empty at the end of the line
    std::size_t offset = 0;
    bool is_quoted = false;
    bool is_mark = false;
    std::size_t begin = 0; ///< in the line as it is read
    std::size_t end = 0;

    /// True of the word or the mark itself, not of the same in quotes.
    bool is(std::string_view plain) const { return !is_quoted && text == plain; }

    /// True of what can be a name.
    bool is_name() const { return !is_mark && (is_quoted || !text.empty()); }
};

/// The most words and marks of a line: twice those of Bresenham's d, with commas, along the longest line.
inline constexpr std::size_t most_words = 4 * std::size_t{largest_canvas_side};

/// What the ends of a row are called.
inline constexpr std::array<std::string_view, 2> row_sides{"left", "right"};

/// How the commas of a file are read: one between two digits is that of a decimal, if any line says so.
struct CommaUse {
    bool is_decimal = false;
    bool is_seen = false; ///< a line that can only have decimal commas has been read
};

/// What is wrong is thrown as a Problem that points at it.
class ClaimLine {
public:
    /// The bytes of a source from `begin` to `end`, which hold one line. A # begins a comment; a bullet or a number
    /// before the line, and a full stop behind it, are left out. More than `most_words` are refused.
    ClaimLine(const Source& source, std::size_t begin, std::size_t end, CommaUse& commas);

    bool at_end() const { return next_ == words_.size(); }

    /// The next word, or the one behind it; empty at the end of the line.
    ClaimWord peek(std::size_t ahead = 0) const;
    ClaimWord next();

    /// True if the word is one of those that follow.
    bool has(std::string_view plain) const;

    /// Goes behind the next words if they are these.
    bool take(std::string_view plain);
    bool take(std::string_view plain, std::string_view mark);

    /// Leaves out what only makes a sentence of it: the, of, at, goes. `is`, `are` and `has` become a colon.
    void leave_out_fillers();

    /// Parts the next word in two; between them, as many bytes are left out.
    void part(std::size_t length, std::size_t left_out);

    /// Goes behind dots that are the last of the line: the list before them goes on.
    bool take_last_dots();

    /// True if take_last_dots was.
    bool ends_in_dots() const { return at_end() && !words_.empty() && words_.back().is(".."); }

    /// What is left of the line, as it is read.
    std::string_view remaining() const {
        return std::string_view(spelled_).substr(std::min(peek().begin, spelled_.size()));
    }

    /// True of a place behind the last word.
    bool is_end(std::size_t ahead) const { return next_ + ahead >= words_.size(); }

    /// Goes behind so many words.
    void skip(std::size_t words) { next_ = std::min(next_ + words, words_.size()); }

    /// Goes behind a mark, or fails.
    void expect(std::string_view mark, std::string expected);
    void expect_end() const;

    /// Goes behind a number, which becomes one as scenes spell it (typed_number.h), or behind a `?`.
    std::optional<ClaimWord> take_number(const NumberSpelling& spelling);

    /// The same, or fails.
    ClaimWord number(const NumberSpelling& spelling);

    /// A number beside which a comma parts it from the next: that of a row or a pixel.
    ClaimWord key() { return number({.has_mixed = false}); }

    /// One number; a comma in it is that of a decimal.
    ClaimWord one_number() { return numbers(1).front(); }

    /// So many numbers, 0 for any, with commas or blanks between them, perhaps in brackets; or one `?` for all. `usual`
    /// is how many there are of them as a rule. Without `has_mixed`, 3 1/8 are two of them.
    std::vector<ClaimWord> numbers(std::size_t count, std::size_t usual = 0, bool has_mixed = true);

    /// A word as it was typed, a number with its unit.
    std::string_view typed(const ClaimWord& word) const {
        return std::string_view(spelled_).substr(word.begin, word.end - word.begin);
    }

    /// What stands between two words that were read.
    std::string_view between(const ClaimWord& first, const ClaimWord& second) const {
        return std::string_view(spelled_).substr(first.end,
                                                 std::max(second.begin, first.end) - first.end);
    }

    /// What follows as it stands, without quotes around it, to the end of the line.
    std::string rest();

    /// The line without its comment and the blanks around it.
    std::string_view text() const { return text_; }

    /// Fails with "expected ..., found ..." at a word.
    [[noreturn]] void fail(const ClaimWord& word, std::string_view expected,
                           std::string hint = {}) const;

    /// Fails at the first word of the line.
    [[noreturn]] void fail_at_begin(std::string message, std::string hint = {}) const;

private:
    void spell();
    void spell_character(std::size_t& at);
    void leave_out_numbering();
    void read_words();
    void translate();
    void read_quoted(std::size_t& at);
    void add(ClaimWord word);
    std::size_t offset_of(std::size_t at) const;
    std::size_t offset_of_raw(std::size_t at) const;
    bool take_separator();
    void note_commas(std::size_t count);
    ClaimWord value_of_list(bool has_mixed);
    [[noreturn]] void refuse_two_readings(const ClaimWord& number, std::string_view expected,
                                          std::string hint) const;

    const Source& source_;
    CommaUse& commas_;
    std::string_view raw_;
    std::string_view text_;
    std::string spelled_;             ///< as it is read
    std::vector<std::size_t> places_; ///< in `raw_`, of each byte of `spelled_`
    std::vector<ClaimWord> words_;
    std::size_t next_ = 0;
    TypedNumber last_;     ///< that was read
    int plain_braces_ = 0; ///< open ones like those of \text{left}, which are left out
};

/// The English word for one that claims in another language have: slope for inclinação; "" if there is none.
std::string_view english_word(std::string_view typed);

/// True if `text` is read as one word that is no mark.
bool is_one_word(std::string_view text);

} // namespace rastertrace
