// SPDX-License-Identifier: MIT
#include "json_scanner.h"

#include "json_document.h"

#include <nlohmann/json.hpp>

#include <array>

namespace rastertrace {

void JsonScanner::skip_blanks() {
    while (position_ < text_.size() && (text_[position_] == ' ' || text_[position_] == '\t' ||
                                        text_[position_] == '\r' || text_[position_] == '\n'))
        ++position_;
}

bool JsonScanner::take(char c) {
    if (position_ >= text_.size() || text_[position_] != c)
        return false;
    ++position_;
    return true;
}

bool JsonScanner::skip_string() {
    if (!take('"'))
        return false;
    for (; position_ < text_.size(); ++position_) {
        const auto byte = static_cast<unsigned char>(text_[position_]);
        if (byte == '"') {
            ++position_;
            return true;
        }
        if (byte < 0x20)
            return false;
        if (byte == '\\' || byte >= 0x80)
            needs_full_check_ = true;
        if (byte == '\\')
            ++position_;
    }
    return false;
}

bool JsonScanner::skip_number() {
    const std::size_t begin = position_;
    const auto skip_digits = [this] {
        const std::size_t first = position_;
        while (position_ < text_.size() && '0' <= text_[position_] && text_[position_] <= '9')
            ++position_;
        return position_ > first;
    };
    take('-');
    if (!take('0') && !skip_digits())
        return false;
    if (take('.') && !skip_digits())
        return false;
    bool can_be_large = false;
    if (take('e') || take('E')) {
        can_be_large = take('+') || !take('-');
        const std::size_t exponent = position_;
        if (!skip_digits())
            return false;
        can_be_large = can_be_large && position_ - exponent > longest_plain_exponent;
    }
    if (can_be_large || position_ - begin > longest_plain_number)
        needs_full_check_ = true;
    return true;
}

bool JsonScanner::skip_value(std::size_t depth) {
    if (position_ >= text_.size())
        return false;
    switch (text_[position_]) {
    case '"':
        return skip_string();
    case '[':
        return ++position_, skip_items(']', false, depth);
    case '{':
        return ++position_, skip_items('}', true, depth);
    default:
        break;
    }
    for (const std::string_view word : {"true", "false", "null"})
        if (text_.substr(position_).starts_with(word)) {
            position_ += word.size();
            return true;
        }
    return skip_number();
}

bool JsonScanner::skip_items(char close, bool have_keys, std::size_t depth) {
    if (depth == deepest_json)
        return false;
    skip_blanks();
    if (take(close))
        return true;
    do {
        skip_blanks();
        if (have_keys) {
            if (!skip_string())
                return false;
            skip_blanks();
            if (!take(':'))
                return false;
            skip_blanks();
        }
        if (!skip_value(depth + 1))
            return false;
        skip_blanks();
    } while (take(','));
    return take(close);
}

bool JsonScanner::next(char open, char close, bool have_keys) {
    if (failed_ || state_ == State::behind)
        return false;

    // The bracket or comma in front, or the end.
    skip_blanks();
    const bool is_first = state_ == State::before;
    if (is_first && !take(open))
        return fail();
    state_ = State::inside;
    skip_blanks();
    if (take(close)) {
        state_ = State::behind;
        skip_blanks();
        return position_ == text_.size() ? false : fail();
    }
    if (!is_first && !take(','))
        return fail();

    // The key, and the value.
    skip_blanks();
    if (have_keys) {
        const std::size_t begin = position_ + 1;
        if (!skip_string())
            return fail();
        key_ = text_.substr(begin, position_ - 1 - begin);
        skip_blanks();
        if (!take(':'))
            return fail();
        skip_blanks();
    }
    const std::size_t begin = position_;
    if (!skip_value(0))
        return fail();
    value_ = text_.substr(begin, position_ - begin);
    return true;
}

bool JsonScanner::next_field() {
    return next('{', '}', true);
}

bool JsonScanner::next_element() {
    return next('[', ']', false);
}

std::string plain_text(std::string_view value) {
    if (!value.starts_with('"'))
        return std::string(value);
    if (value.find('\\') == std::string_view::npos)
        return std::string(value.substr(1, value.size() - 2));
    const auto decoded = nlohmann::json::parse(value, nullptr, false);
    return decoded.is_string() ? decoded.get<std::string>() : std::string(value);
}

} // namespace rastertrace
