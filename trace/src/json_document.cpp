// SPDX-License-Identifier: MIT
#include "json_document.h"

#include <rastertrace/trace/text.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <optional>
#include <unordered_set>

namespace rastertrace {

const JsonValue* JsonValue::find(std::string_view key) const {
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i].text == key)
            return &items[i];
    return nullptr;
}

std::string described(const JsonValue& value) {
    constexpr std::size_t width = 40;
    switch (value.kind) {
    case JsonValue::Kind::null:
        return "null";
    case JsonValue::Kind::boolean:
        return value.text;
    case JsonValue::Kind::number:
        return shortened(value.text, width);
    case JsonValue::Kind::string:
        return fmt::format("\"{}\"", shortened(value.text, width));
    case JsonValue::Kind::array:
        return value.items.empty() ? "an empty array"
                                   : fmt::format("an array of {}", value.items.size());
    case JsonValue::Kind::object:
        break;
    }
    return "an object";
}

namespace {

using nlohmann::json;

/// Follows nlohmann's parser from token to token: the parser tells what it read, this finds where.
class DocumentBuilder final : public nlohmann::json_sax<json> {
public:
    DocumentBuilder(const Source& source, std::size_t begin, std::size_t end)
        : source_(source), position_(begin), begin_(begin), end_(end) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (std::string_view(source.text).substr(begin).starts_with(byte_order_mark))
            position_ += byte_order_mark.size();
    }

    JsonValue take_root() { return std::move(root_); }
    const std::optional<Problem>& problem() const { return problem_; }

    bool null() override { return add(JsonValue::Kind::null, {}); }
    bool boolean(bool value) override {
        return add(JsonValue::Kind::boolean, value ? "true" : "false");
    }
    bool number_integer(number_integer_t) override { return add_number(); }
    bool number_unsigned(number_unsigned_t) override { return add_number(); }
    bool number_float(number_float_t, const string_t&) override { return add_number(); }
    bool string(string_t& value) override { return add(JsonValue::Kind::string, std::move(value)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(JsonValue::Kind::object); }
    bool start_array(std::size_t) override { return open(JsonValue::Kind::array); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& value) override {
        JsonValue name = token(JsonValue::Kind::string, std::move(value));
        Container& object = open_.back();
        if (!object.seen.insert(name.text).second) {
            problem_ =
                problem_at(source_, name.begin,
                           fmt::format("expected each key once, found {} again", described(name)));
            return false;
        }
        object.value.keys.push_back(std::move(name));
        after_key_ = true;
        return true;
    }

    bool parse_error(std::size_t bytes_read, const std::string&,
                     const json::exception& error) override {
        problem_ = explain(bytes_read, error);
        return false;
    }

private:
    struct Container {
        JsonValue value;
        std::unordered_set<std::string> seen; ///< keys
    };

    /// The bytes of the next token, which the parser has already accepted.
    JsonValue token(JsonValue::Kind kind, std::string text) {
        const std::string& all = source_.text;
        position_ = all.find_first_not_of(" \t\r\n,:", position_);
        JsonValue value;
        value.kind = kind;
        value.begin = position_;
        value.text = std::move(text);
        if (all[position_] == '"') {
            ++position_;
            while (all[position_] != '"')
                position_ += all[position_] == '\\' ? 2 : 1;
            ++position_;
        } else if (std::string_view("[]{}").find(all[position_]) != std::string_view::npos) {
            ++position_;
        } else {
            position_ = std::min(all.find_first_of(" \t\r\n,:]}", position_), end_);
        }
        value.end = position_;
        after_key_ = false;
        return value;
    }

    bool add_number() {
        JsonValue number = token(JsonValue::Kind::number, {});
        number.text = source_.text.substr(number.begin, number.end - number.begin);
        return place(std::move(number));
    }

    bool add(JsonValue::Kind kind, std::string text) { return place(token(kind, std::move(text))); }

    bool place(JsonValue value) {
        if (open_.empty()) {
            root_ = std::move(value);
            has_root_ = true;
        } else {
            open_.back().value.items.push_back(std::move(value));
        }
        return true;
    }

    bool open(JsonValue::Kind kind) {
        JsonValue container = token(kind, {});
        if (open_.size() == deepest_json) {
            problem_ = problem_at(source_, container.begin,
                                  fmt::format("expected at most {} arrays and objects in one "
                                              "another, found one more",
                                              deepest_json));
            return false;
        }
        open_.push_back({std::move(container), {}});
        return true;
    }

    bool close() {
        token(JsonValue::Kind::null, {});
        JsonValue value = std::move(open_.back().value);
        open_.pop_back();
        value.end = position_;
        return place(std::move(value));
    }

    /// What the parser stumbled over, in our words.
    Problem explain(std::size_t bytes_read, const json::exception& error) const {
        const std::string_view text = std::string_view(source_.text).substr(0, end_);
        const std::size_t last_read = begin_ + (bytes_read == 0 ? 0 : bytes_read - 1);

        // Where the token begins that does not fit: behind the last good one, the blanks, and the
        // one comma or colon that may stand between them; but not behind the last byte that was
        // read.
        const auto skip_blanks = [text](std::size_t at) {
            return std::min(text.find_first_not_of(" \t\r\n", at), text.size());
        };
        std::size_t place = skip_blanks(position_);
        if (place < text.size() && (text[place] == ',' || text[place] == ':'))
            place = skip_blanks(place + 1);
        place = std::min({place, last_read, text.size()});

        // A string or number that breaks off or holds what it must not, in the parser's words.
        const std::string_view told = error.what();
        for (const std::string_view kind : {"invalid string: ", "invalid number; "}) {
            const std::size_t at = told.find(kind);
            if (at == std::string_view::npos || place >= text.size())
                continue;
            const std::string_view why = told.substr(at, told.find("; last read", at) - at);
            return problem_at(source_, place, fmt::format("expected valid JSON, found an {}", why));
        }
        constexpr int number_overflow = 406;
        if (error.id == number_overflow)
            return problem_at(
                source_, place,
                fmt::format(
                    "expected a number up to 1.797e308, found {}",
                    shortened(text.substr(place, text.find_first_of(" \t\r\n,]}", place) - place),
                              40)));
        return problem_at(
            source_, place,
            fmt::format("expected {}, found {}", expected_at(place), found_at(place)));
    }

    std::string_view expected_at(std::size_t place) const {
        const std::string_view before =
            std::string_view(source_.text).substr(begin_, place - begin_);
        const std::size_t last = before.find_last_not_of(" \t\r\n");
        const char previous = last == std::string_view::npos ? '\0' : before[last];
        const bool in_object = !open_.empty() && open_.back().value.kind == JsonValue::Kind::object;
        if (after_key_ && previous != ':')
            return "':'";
        if (previous == ':')
            return "a value";
        if (open_.empty())
            return has_root_ ? "the end of the file" : "a JSON value";
        const bool is_first = open_.back().value.items.empty();
        if (in_object)
            return is_first ? "a key in double quotes or '}'"
                            : (previous == ',' ? "a key in double quotes" : "',' or '}'");
        return is_first ? "a value or ']'" : (previous == ',' ? "a value" : "',' or ']'");
    }

    std::string found_at(std::size_t place) const {
        const std::string_view text = std::string_view(source_.text).substr(0, end_);
        if (place >= text.size())
            return "the end of the file";
        const std::string_view rest = text.substr(place);
        const CodePoint first = first_code_point(rest);
        if (first.value == not_a_character)
            return fmt::format("the byte 0x{:02X}, which is not UTF-8",
                               static_cast<unsigned char>(rest.front()));
        if (rest.front() == '"')
            return "a string";
        // A word or number as a whole, anything else as one character.
        std::size_t length = 0;
        while (length < rest.size() && length < 40 &&
               (std::isalnum(static_cast<unsigned char>(rest[length])) != 0 ||
                std::string_view("+-._").find(rest[length]) != std::string_view::npos))
            ++length;
        return fmt::format("'{}'", rest.substr(0, std::max(length, first.length)));
    }

    const Source& source_;
    std::size_t position_; ///< behind the last token
    std::size_t begin_;
    std::size_t end_;
    std::vector<Container> open_; ///< arrays and objects not yet closed, outermost first
    bool after_key_ = false;
    JsonValue root_;
    bool has_root_ = false;
    std::optional<Problem> problem_;
};

} // namespace

Result<JsonValue> parse_json(const Source& source, std::size_t begin, std::size_t size) {
    const std::string_view text = std::string_view(source.text).substr(begin, size);
    DocumentBuilder builder(source, begin, begin + text.size());
    if (!json::sax_parse(text.begin(), text.end(), &builder) && builder.problem())
        return *builder.problem();
    return builder.take_root();
}

} // namespace rastertrace
