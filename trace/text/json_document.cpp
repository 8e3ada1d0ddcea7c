// SPDX-License-Identifier: MIT
#include "json_document.h"

#include "byte_order_mark.h"
#include "json_scanner.h"
#include "name_index.h"
#include "text.h"
#include "zero_byte.h"

#include <rastertrace/core/numbers/number.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <limits>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// How much of a word is shown.
constexpr std::size_t shown_of_word = 40;

/// The offset behind the string, number or word that begins at `begin`.
std::size_t end_of_token(std::string_view text, std::size_t begin) {
    if (text[begin] != '"')
        return std::min(text.find_first_of(" \t\r\n,:]}", begin), text.size());
    std::size_t at = begin + 1;
    while (text[at] != '"')
        at += text[at] == '\\' ? 2 : 1;
    return at + 1;
}

JsonValue::Kind kind_of(char first) {
    switch (first) {
    case '{':
        return JsonValue::Kind::object;
    case '[':
        return JsonValue::Kind::array;
    case '"':
        return JsonValue::Kind::string;
    case 't':
    case 'f':
        return JsonValue::Kind::boolean;
    case 'n':
        return JsonValue::Kind::null;
    default:
        return JsonValue::Kind::number;
    }
}

/// A string, number or word as plain text.
std::string text_of_token(std::string_view text, std::size_t begin) {
    return plain_text(text.substr(begin, end_of_token(text, begin) - begin));
}

bool is_container(JsonValue::Kind kind) {
    return kind == JsonValue::Kind::array || kind == JsonValue::Kind::object;
}

} // namespace

JsonValue::JsonValue(const JsonDocument& document, std::uint32_t node)
    : begin(document.nodes_[node].begin), document_(&document), node_(node) {
    const std::string_view from_here = document.text_from(node);
    kind = kind_of(from_here.front());
    if (!is_container(kind) && kind != Kind::null)
        text = text_of_token(from_here, 0);
}

std::size_t JsonValue::end() const {
    const std::string_view all = document_->text();
    if (!is_container(kind))
        return end_of_token(all, begin);
    // Behind the last thing inside of it comes nothing but its bracket.
    const std::uint32_t next = document_->nodes_[node_].next;
    std::uint32_t last = node_;
    for (std::uint32_t node = node_ + 1; node != next; node = document_->nodes_[node].next)
        last = node;
    const std::size_t inside = last == node_ ? begin + 1 : JsonValue(*document_, last).end();
    return all.find_first_not_of(blanks, inside) + 1;
}

std::optional<JsonValue> JsonValue::find(std::string_view key) const {
    for (const auto& [name, value] : members())
        if (name.text == key)
            return value;
    return std::nullopt;
}

JsonElements JsonValue::elements() const {
    const std::uint32_t end = document_->nodes_[node_].next;
    return {*document_, kind == Kind::array ? node_ + 1 : end, end};
}

JsonMembers JsonValue::members() const {
    const std::uint32_t end = document_->nodes_[node_].next;
    return {*document_, kind == Kind::object ? node_ + 1 : end, end};
}

std::string described(const JsonValue& value) {
    switch (value.kind) {
    case JsonValue::Kind::null:
        return "null";
    case JsonValue::Kind::boolean:
        return value.text;
    case JsonValue::Kind::number:
        return shortened(value.text, shown_of_word);
    case JsonValue::Kind::string:
        return fmt::format("\"{}\"", shortened(value.text, shown_of_word));
    case JsonValue::Kind::array:
        return value.elements().empty() ? "an empty array"
                                        : fmt::format("an array of {}", value.elements().size());
    case JsonValue::Kind::object:
        break;
    }
    return "an object";
}

using nlohmann::json;

/// Follows nlohmann's parser from token to token: the parser tells what it read, this finds where.
class DocumentBuilder final : public nlohmann::json_sax<json> {
public:
    DocumentBuilder(const Source& source, std::size_t begin, std::size_t end)
        : source_(source), document_(source, end), position_(begin), begin_(begin), end_(end) {
        position_ += size_of_mark(source.view().substr(begin));
    }

    JsonDocument take_document() { return std::move(document_); }
    const std::optional<Problem>& problem() const { return problem_; }

    bool null() override { return add(); }
    bool boolean(bool) override { return add(); }
    bool number_integer(number_integer_t) override { return add(); }
    bool number_unsigned(number_unsigned_t) override { return add(); }
    bool number_float(number_float_t, const string_t&) override { return add(); }
    bool string(string_t&) override { return add(); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(); }
    bool start_array(std::size_t) override { return open(); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& value) override {
        const std::uint32_t node = add_node();
        const auto name_of = [this](std::uint32_t other) {
            return text_of_token(document_.text(), document_.nodes_[other].begin);
        };
        if (!open_.back().keys.insert(node, name_of)) {
            problem_ = problem_at(source_, document_.nodes_[node].begin,
                                  fmt::format("expected each key once, found \"{}\" again",
                                              shortened(value, shown_of_word)));
            return false;
        }
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
        std::uint32_t node;
        bool is_object;
        NameIndex keys;
    };

    bool is_empty(const Container& container) const {
        return document_.nodes_.size() == container.node + std::size_t{1};
    }

    /// Goes to the next token, which the parser has already accepted, and behind it. Returns where
    /// it begins.
    std::size_t take_token() {
        const std::string_view text = document_.text();
        const std::size_t begin = text.find_first_not_of(" \t\r\n,:", position_);
        const bool is_bracket =
            std::string_view("[]{}").find(text[begin]) != std::string_view::npos;
        position_ = is_bracket ? begin + 1 : end_of_token(text, begin);
        after_key_ = false;
        return begin;
    }

    /// Adds the next token with nothing inside of it.
    std::uint32_t add_node() {
        const auto node = static_cast<std::uint32_t>(document_.nodes_.size());
        document_.nodes_.push_back({static_cast<std::uint32_t>(take_token()), node + 1});
        return node;
    }

    bool add() {
        add_node();
        return true;
    }

    bool open() {
        const std::uint32_t node = add_node();
        const std::size_t begin = document_.nodes_[node].begin;
        if (open_.size() == deepest_json) {
            problem_ = problem_at(source_, begin,
                                  fmt::format("expected at most {} arrays and objects in one "
                                              "another, found one more",
                                              deepest_json));
            return false;
        }
        open_.push_back({node, source_.view()[begin] == '{', {}});
        return true;
    }

    bool close() {
        take_token();
        document_.nodes_[open_.back().node].next =
            static_cast<std::uint32_t>(document_.nodes_.size());
        open_.pop_back();
        return true;
    }

    /// What the parser stumbled over, in our words.
    Problem explain(std::size_t bytes_read, const json::exception& error) const {
        const std::string_view text = source_.view().substr(0, end_);
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
                              shown_of_word)));
        return problem_at(source_, place,
                          fmt::format("expected {}, found {}", expected_at(place), found_at(place)),
                          std::string(hint_at(place)));
    }

    /// What JSON has instead of what was found, if that is how another notation says it.
    std::string_view hint_at(std::size_t place) const {
        const std::string_view text = source_.view().substr(0, end_);
        const std::string_view rest = text.substr(place);
        const char previous = last_before(place);
        if (rest.starts_with("//") || rest.starts_with("/*") || rest.starts_with('#'))
            return "JSON has no comments";
        if (rest.starts_with('/') && number_text::is_digit(previous))
            return R"(a fraction is written "25/8", in quotes)";
        if (rest.starts_with('\''))
            return R"(JSON has double quotes: "A")";
        if (rest.starts_with('('))
            return "JSON has square brackets: [2, 5]";
        if (previous == ',' && (rest.starts_with('}') || rest.starts_with(']')))
            return "JSON has no comma behind the last value";
        return {};
    }

    /// The last character before a place that is no blank; 0 if there is none.
    char last_before(std::size_t place) const {
        const std::string_view before = source_.view().substr(begin_, place - begin_);
        const std::size_t last = before.find_last_not_of(" \t\r\n");
        return last == std::string_view::npos ? '\0' : before[last];
    }

    std::string_view expected_at(std::size_t place) const {
        const char previous = last_before(place);
        const bool in_object = !open_.empty() && open_.back().is_object;
        if (after_key_ && previous != ':')
            return "':'";
        if (previous == ':')
            return "a value";
        if (open_.empty())
            return document_.nodes_.empty() ? "a JSON value" : "the end of the file";
        const bool is_first = is_empty(open_.back());
        if (in_object)
            return is_first ? "a key in double quotes or '}'"
                            : (previous == ',' ? "a key in double quotes" : "',' or '}'");
        return is_first ? "a value or ']'" : (previous == ',' ? "a value" : "',' or ']'");
    }

    std::string found_at(std::size_t place) const {
        const std::string_view text = source_.view().substr(0, end_);
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
    JsonDocument document_;
    std::size_t position_; ///< behind the last token
    std::size_t begin_;
    std::size_t end_;
    std::vector<Container> open_; ///< arrays and objects not yet closed, outermost first
    bool after_key_ = false;
    std::optional<Problem> problem_;
};

Result<JsonDocument> parse_json(const Source& source, std::size_t begin, std::size_t size) {
    // The parser takes a zero byte for the end.
    if (begin == 0)
        if (auto problem = zero_byte_in(source))
            return *std::move(problem);
    const std::string_view text = source.view().substr(begin, size);
    constexpr std::size_t largest = std::numeric_limits<std::uint32_t>::max();
    if (begin + text.size() > largest)
        return problem_of(source.name, fmt::format("expected JSON of at most {} bytes in one "
                                                   "piece, found more",
                                                   largest));
    DocumentBuilder builder(source, begin, begin + text.size());
    if (!json::sax_parse(text.begin(), text.end(), &builder) && builder.problem())
        return *builder.problem();
    return builder.take_document();
}

} // namespace rastertrace
