// SPDX-License-Identifier: MIT
#pragma once

// A line of a table of claims, word by word.
//
//     ClaimLine line(source, begin, end);   // y=2: -1/4, 25/8
//     line.next().text;                     // "y"
//     line.expect("=", "`=`");

#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/trace/text/problem.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// A word, a number, or a mark between them: ( ) , : = -> ..
struct ClaimWord {
    std::string text; ///< without quotes; empty at the end of the line
    std::size_t offset = 0;
    bool is_quoted = false;
    bool is_mark = false;

    /// True of the word or the mark itself, not of the same in quotes.
    bool is(std::string_view plain) const { return !is_quoted && text == plain; }

    /// True of what can be a name.
    bool is_name() const { return !is_mark && (is_quoted || !text.empty()); }
};

/// The most words and marks of a line: twice those of Bresenham's d, with commas, along the longest line.
inline constexpr std::size_t most_words = 4 * std::size_t{largest_canvas_side};

/// What is wrong is thrown as a Problem that points at it.
class ClaimLine {
public:
    /// The bytes of a source from `begin` to `end`, which hold one line. A # begins a comment. More than
    /// `most_words` are refused.
    ClaimLine(const Source& source, std::size_t begin, std::size_t end);

    bool at_end() const { return next_ == words_.size(); }

    /// The next word, or the one behind it; empty at the end of the line.
    ClaimWord peek(std::size_t ahead = 0) const;
    ClaimWord next();

    /// Goes behind the next words if they are these.
    bool take(std::string_view plain);
    bool take(std::string_view plain, std::string_view mark);

    /// Goes behind a mark, or fails.
    void expect(std::string_view mark, std::string expected);
    void expect_end() const;

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
    std::size_t offset_of(std::string_view part) const;
    std::string_view text_behind_colon() const;
    void read_words();
    std::size_t read_word(std::size_t at);
    std::size_t read_quoted(std::size_t at);
    void add(ClaimWord word);

    const Source& source_;
    std::string_view raw_;
    std::string_view text_;
    std::vector<ClaimWord> words_;
    std::size_t next_ = 0;
};

/// True if `text` is read as one word that is no mark.
bool is_one_word(std::string_view text);

} // namespace rastertrace
