// SPDX-License-Identifier: MIT
#pragma once

// Goes through one JSON object or array without building anything: for the lines of a trace, of
// which there may be millions.
//
//     JsonScanner fields(line);
//     while (fields.next_field())
//         use(fields.key(), fields.value());

#include <cstddef>
#include <string>
#include <string_view>

namespace rastertrace {

/// A number of so few characters, whose exponent has so few digits, lies below 1.797e308.
inline constexpr std::size_t longest_plain_number = 200;
inline constexpr std::size_t longest_plain_exponent = 2;

class JsonScanner {
public:
    explicit JsonScanner(std::string_view json) : text_(json) {}

    /// Goes to the next field of an object; false behind the last, or if the text is no object.
    bool next_field();

    /// Goes to the next element of an array; false behind the last, or if the text is no array.
    bool next_element();

    std::string_view key() const { return key_; }     ///< without quotes, escapes as they are
    std::string_view value() const { return value_; } ///< as it stands

    /// True if the text is not what it was taken for. Whoever has come to the end without failing
    /// has read valid JSON, except that needs_full_check may tell otherwise.
    bool failed() const { return failed_; }

    /// True if something was passed over that is not checked here: escapes, bytes beyond ASCII,
    /// numbers that might be larger than a double.
    bool needs_full_check() const { return needs_full_check_; }

private:
    enum class State { before, inside, behind };

    void skip_blanks();
    bool take(char c);
    bool skip_string();
    bool skip_number();
    bool skip_value(std::size_t depth);
    bool skip_items(char close, bool have_keys, std::size_t depth);
    bool next(char open, char close, bool have_keys);
    bool fail() {
        failed_ = true;
        return false;
    }

    std::string_view text_;
    std::size_t position_ = 0;
    std::string_view key_;
    std::string_view value_;
    State state_ = State::before;
    bool failed_ = false;
    bool needs_full_check_ = false;
};

/// A JSON value as plain text: what a string says, or else the value as it stands.
std::string plain_text(std::string_view value);

} // namespace rastertrace
