// SPDX-License-Identifier: MIT
#include "triangles_text.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/text/byte_order_mark.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rastertrace {

namespace {

constexpr std::string_view blanks = " \t\r\v\f";

struct Word {
    std::string_view text;
    std::size_t offset;
};

using WordsOfLine = std::vector<Word>;

/// The words of the line that begins at an offset, without its comment; `offset` goes to the next line.
void take_line(std::string_view text, std::size_t& offset, WordsOfLine& words) {
    const std::size_t end = std::min(text.find('\n', offset), text.size());
    std::string_view line = text.substr(offset, end - offset);
    words.clear();
    for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
        const std::size_t behind = std::min(line.find_first_of(blanks, at), line.size());
        const std::string_view word = line.substr(at, behind - at);
        const bool is_color = word.starts_with('#') && word.size() == 7 && parse_color(word);
        const std::size_t comment = is_color ? word.size() : std::min(word.find('#'), word.size());
        if (comment > 0)
            words.push_back({word.substr(0, comment), offset + at});
        if (comment < word.size())
            break;
        at = line.find_first_not_of(blanks, behind);
    }
    offset = end + 1;
}

/// The canvas, and a line for each primitive, with its name and the places of its vertices.
class TrianglesReader {
public:
    explicit TrianglesReader(const Source& source) : source_(source) {}

    /// The scene, as JSON.
    std::string read() {
        const std::string_view text = source_.view();
        WordsOfLine words;
        for (std::size_t offset = size_of_mark(text); offset < text.size();) {
            take_line(text, offset, words);
            if (!words.empty())
                read_statement(words);
        }
        if (lists_.empty())
            fail(text.size(), "expected at least one primitive, found none");
        return json();
    }

private:
    /// How many vertices of how many coordinates, and the scene's list of that kind.
    struct Row {
        std::string_view word;
        std::size_t vertices;
        std::size_t coordinates;
        std::string_view list;
    };
    static constexpr std::array rows{Row{"tri", 3, 3, "triangles"}, Row{"line", 2, 3, "lines"},
                                     Row{"clip", 3, 4, "triangles"}};

    void read_statement(const WordsOfLine& words) {
        const std::string_view name = words.front().text;
        if (name == "canvas")
            return set_canvas(words);
        const auto* const row = std::find_if(rows.begin(), rows.end(),
                                             [name](const Row& one) { return one.word == name; });
        if (row == rows.end())
            refuse_statement(words.front());
        const std::size_t numbers = row->vertices * row->coordinates;
        const bool has_color = words.back().text.starts_with('#');
        if (words.size() - (has_color ? 1 : 0) != 2 + numbers)
            fail(words.front().offset,
                 fmt::format("expected a name and {} numbers behind {}, found {}", numbers, name,
                             counted(words.size() - 1, "word")));
        std::vector<std::string> names;
        for (std::size_t i = 2; i < 2 + numbers; i += row->coordinates) {
            std::vector<std::string> at;
            for (std::size_t axis = 0; axis < row->coordinates; ++axis)
                at.push_back(typed_number(words[i + axis]));
            names.push_back(json_quoted(fmt::format("P{}", vertices_.size() + 1)));
            vertices_.push_back(fmt::format("{}: [{}]", names.back(), joined(at, ", ")));
        }
        const std::string color =
            has_color ? fmt::format(R"(, "color": "{}")", words.back().text) : "";
        lists_[row->list].push_back(fmt::format(R"({{"vertices": [{}], "name": {}{}}})",
                                                joined(names, ", "), json_quoted(words[1].text),
                                                color));
    }

    void set_canvas(const WordsOfLine& words) {
        constexpr std::size_t expected = 2;
        const std::size_t found = words.size() - 1;
        if (found != expected)
            fail(found < expected ? words.back().offset + words.back().text.size()
                                  : words[expected + 1].offset,
                 fmt::format("expected {} behind canvas, found {}", counted(expected, "word"),
                             found));
        width_ = side(words[1]);
        height_ = side(words[2]);
    }

    /// Of the canvas.
    std::int64_t side(const Word& word) const {
        constexpr std::int64_t most = 16384;
        std::int64_t value = 0;
        std::string_view digits = word.text;
        digits.remove_prefix(digits.starts_with('+') ? 1 : 0);
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc() || end != digits.data() + digits.size() || value < 1 ||
            value > most)
            fail_at(word, fmt::format("a whole number from 1 to {}", most));
        return value;
    }

    /// As it stands there: a fraction is no JSON number.
    std::string typed_number(const Word& word) const {
        if (!std::holds_alternative<Number>(parse_number(std::string(word.text))))
            fail_at(word, "a number");
        return json_quoted(word.text);
    }

    [[noreturn]] void fail(std::size_t offset, std::string message, std::string hint = {}) const {
        throw problem_at(source_, offset, std::move(message), std::move(hint));
    }

    [[noreturn]] void fail_at(const Word& word, std::string_view expected) const {
        fail(word.offset, fmt::format("expected {}, found \"{}\"", expected,
                                      shortened(printable(word.text), 40)));
    }

    [[noreturn]] void refuse_statement(const Word& word) const {
        const std::vector<std::string_view> known{"canvas", "tri", "line", "clip"};
        fail(word.offset,
             fmt::format("expected a statement out of {}, found \"{}\"", joined(known, ", "),
                         shortened(printable(word.text), 40)),
             did_you_mean(word.text, known, ""));
    }

    std::string json() const {
        std::string text =
            fmt::format("{{\"canvas\":{{\"width\":{},\"height\":{},\"origin\":\"top-left\"}},\n"
                        "\"vertices\": {{{}}}",
                        width_, height_, joined(vertices_, ", "));
        for (const auto& [list, primitives] : lists_)
            text += fmt::format(",\n\"{}\": [{}]", list, joined(primitives, ",\n  "));
        return text + "}\n";
    }

    const Source& source_;
    std::int64_t width_ = 1;
    std::int64_t height_ = 1;
    std::vector<std::string> vertices_;
    std::map<std::string_view, std::vector<std::string>> lists_;
};

} // namespace

Result<Source> scene_of_triangles(const Source& source) {
    try {
        return Source{source.name + " as a scene", TrianglesReader(source).read(), {}};
    } catch (const Problem& problem) {
        return problem;
    }
}

} // namespace rastertrace
