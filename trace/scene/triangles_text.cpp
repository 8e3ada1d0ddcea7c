// SPDX-License-Identifier: MIT
#include "triangles_text.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

namespace {

/// A statement of a primitive: how many vertices it has, of how many coordinates, and the scene's list of its kind.
struct Statement {
    std::string_view word;
    std::size_t vertices;
    std::size_t coordinates;
    std::string_view list;
};
constexpr std::array statements{Statement{"tri", 3, 3, "triangles"},
                                Statement{"line", 2, 3, "lines"},
                                Statement{"clip", 3, 4, "triangles"}};

class TrianglesReader {
public:
    explicit TrianglesReader(const Source& source) : source_(source) {}

    std::string read() {
        const std::string_view text = source_.view();
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            read_line(text.substr(begin, end - begin));
            begin = end + 1;
        }
        std::vector<std::string> lists;
        for (const std::string_view list : {"triangles", "lines"}) {
            std::vector<std::string> primitives;
            for (const auto& [of, json] : primitives_)
                if (of == list)
                    primitives.push_back(json);
            if (!primitives.empty())
                lists.push_back(fmt::format(" \"{}\": [{}]", list, joined(primitives, ",\n  ")));
        }
        if (canvas_.empty() || lists.empty())
            fail(text.substr(text.size()), canvas_.empty() ? "a line `canvas W H`" : "a primitive",
                 "the end");
        return fmt::format("{{{},\n \"vertices\": {{{}}},\n{}}}\n", canvas_,
                           joined(vertices_, ", "), joined(lists, ",\n"));
    }

private:
    [[noreturn]] void fail(std::string_view at, std::string_view expected,
                           std::string_view found) const {
        throw problem_at(
            source_, static_cast<std::size_t>(at.data() - source_.view().data()),
            fmt::format("expected {}, found {}", expected, shortened(printable(found), 40)));
    }

    void read_line(std::string_view line) {
        line = line.substr(0, line.find('#'));
        constexpr std::string_view blanks = " \t\r";
        std::vector<std::string_view> words;
        for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
            const std::size_t behind = std::min(line.find_first_of(blanks, at), line.size());
            words.push_back(line.substr(at, behind - at));
            at = line.find_first_not_of(blanks, behind);
        }
        if (words.empty())
            return;
        const auto statement =
            std::find_if(statements.begin(), statements.end(),
                         [&](const Statement& one) { return one.word == words.front(); });
        if (words.front() == front_of_triangles)
            read_canvas(words);
        else if (statement == statements.end())
            fail(words.front(), "canvas, tri, line or clip", words.front());
        else
            read_primitive(*statement, words);
    }

    void read_canvas(const std::vector<std::string_view>& words) {
        if (words.size() != 3)
            fail(words.front(), "`canvas W H`",
                 fmt::format("{} words behind it", words.size() - 1));
        for (const std::string_view size : {words[1], words[2]}) {
            int pixels = 0;
            const auto read = std::from_chars(size.data(), size.data() + size.size(), pixels);
            if (read.ec != std::errc{} || read.ptr != size.data() + size.size() || pixels < 1)
                fail(size, "a whole number of pixels", size);
        }
        canvas_ = fmt::format(R"("canvas": {{"width": {}, "height": {}, "origin": "top-left"}})",
                              words[1], words[2]);
    }

    void read_primitive(const Statement& statement, const std::vector<std::string_view>& words) {
        const std::size_t numbers = statement.vertices * statement.coordinates;
        if (words.size() != 2 + numbers)
            fail(words.front(),
                 fmt::format("a name and {} numbers behind {}", numbers, statement.word),
                 fmt::format("{} words", words.size() - 1));
        std::vector<std::string> names;
        for (std::size_t i = 2; i < words.size(); i += statement.coordinates) {
            std::vector<std::string> at;
            for (std::size_t axis = 0; axis < statement.coordinates; ++axis) {
                const std::string_view word = words[i + axis];
                const auto number = parse_number(std::string(word));
                if (!std::holds_alternative<Number>(number))
                    fail(word, "a number", word);
                at.push_back(json_quoted(word)); // a fraction, and 1. or .5, are no JSON numbers
            }
            names.push_back(json_quoted(fmt::format("P{}", vertices_.size() + 1)));
            vertices_.push_back(fmt::format("{}: [{}]", names.back(), joined(at, ", ")));
        }
        primitives_.emplace_back(statement.list,
                                 fmt::format(R"({{"vertices": [{}], "name": {}}})",
                                             joined(names, ", "), json_quoted(words[1])));
    }

    const Source& source_;
    std::string canvas_;
    std::vector<std::string> vertices_;
    std::vector<std::pair<std::string_view, std::string>> primitives_;
};

} // namespace

Source scene_of_triangles(const Source& source) {
    return {source.name + " as a scene", TrianglesReader(source).read(), {}};
}

} // namespace rastertrace
