// SPDX-License-Identifier: MIT
#include "course_text.h"

#include "obj_file.h"
#include "svg_text.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/trace/text/byte_order_mark.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/number_word.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rastertrace {

namespace {

constexpr std::string_view blanks = " \t\r\v\f";
constexpr std::string_view front_of_triangles = "canvas";

struct Word {
    std::string_view text;
    std::size_t offset;
};

/// The words of the line that begins at an offset, without its comment; `offset` goes to the next line.
void take_line(std::string_view text, std::size_t& offset, std::vector<Word>& words) {
    const std::size_t end = std::min(text.find('\n', offset), text.size());
    std::string_view line = text.substr(offset, end - offset);
    line = line.substr(0, line.find('#'));
    words.clear();
    for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
        const std::size_t behind = std::min(line.find_first_of(blanks, at), line.size());
        words.push_back({line.substr(at, behind - at), offset + at});
        at = line.find_first_not_of(blanks, behind);
    }
    offset = end + 1;
}

/// What all formats share: statements, the canvas, and words that become numbers.
class StatementReader {
public:
    explicit StatementReader(const Source& source) : source_(source) {}
    StatementReader(const StatementReader&) = delete;
    StatementReader& operator=(const StatementReader&) = delete;
    virtual ~StatementReader() = default;

    /// The scene, as JSON.
    std::string read() {
        const std::string_view text = source_.view();
        std::vector<Word> words;
        for (std::size_t offset = size_of_mark(text); offset < text.size();) {
            take_line(text, offset, words);
            if (!words.empty())
                read_statement(words);
        }
        if (is_empty())
            fail(text.size(), fmt::format("expected at least one {}, found none", primitive()));
        return json();
    }

protected:
    using Words = std::vector<Word>;

    virtual void read_statement(const Words& words) = 0;
    virtual bool is_empty() const = 0;
    virtual std::string_view primitive() const { return "triangle"; }
    virtual std::string json() const = 0;

    [[noreturn]] void fail(std::size_t offset, std::string message, std::string hint = {}) const {
        throw problem_at(source_, offset, std::move(message), std::move(hint));
    }

    [[noreturn]] void fail_at(const Word& word, std::string_view expected) const {
        fail(word.offset, fmt::format("expected {}, found \"{}\"", expected,
                                      shortened(printable(word.text), 40)));
    }

    [[noreturn]] void refuse_statement(const Word& word,
                                       const std::vector<std::string_view>& known) const {
        fail(word.offset,
             fmt::format("expected a statement out of {}, found \"{}\"", joined(known, ", "),
                         shortened(printable(word.text), 40)),
             did_you_mean(word.text, known, ""));
    }

    /// Refuses a statement with other than so many words behind its name.
    void need(const Words& words, std::size_t least, std::size_t most) const {
        const std::size_t found = words.size() - 1;
        if (found < least)
            fail(words.back().offset + words.back().text.size(),
                 fmt::format("expected {} behind {}, found {}", counted(least, "word"),
                             words.front().text, found));
        if (found > most)
            fail(words[most + 1].offset,
                 fmt::format("expected {} behind {}, found {}", counted(most, "word"),
                             words.front().text, found));
    }

    std::string number(const Word& word) const {
        const auto usual = usual_form(word.text);
        if (!usual || !std::holds_alternative<Number>(parse_number(*usual)))
            fail_at(word, "a number");
        return *usual;
    }

    std::int64_t whole(const Word& word, std::int64_t least, std::int64_t most) const {
        std::int64_t value = 0;
        std::string_view digits = word.text;
        digits.remove_prefix(digits.starts_with('+') ? 1 : 0);
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc() || end != digits.data() + digits.size() || value < least ||
            value > most)
            fail_at(word, fmt::format("a whole number from {} to {}", least, most));
        return value;
    }

    /// A channel of 0 to 1 as one of 0 to 255, cut off.
    std::uint8_t channel(const Word& word) const {
        const std::string text = number(word);
        const Rational value = std::get<Number>(parse_number(text)).exact();
        if (value < 0 || value > 1)
            fail_at(word, "a channel from 0 to 1");
        return level_of(Rational(value * 255), ColorRounding::truncate);
    }

    void set_canvas(const Words& words) {
        constexpr std::int64_t most = 16384;
        width_ = whole(words[1], 1, most);
        height_ = whole(words[2], 1, most);
    }

    std::string canvas_json() const {
        return fmt::format(R"("canvas":{{"width":{},"height":{},"origin":"top-left"}})", width_,
                           height_);
    }

private:
    const Source& source_;
    std::int64_t width_ = 1;
    std::int64_t height_ = 1;
};

/// A vertex as the text has it: JSON numbers.
struct CourseVertex {
    std::array<std::string, 4> at;
    Color color;
};

/// What the formats of both courses share: vertices and triangles.
class CourseReader : public StatementReader {
public:
    using StatementReader::StatementReader;

protected:
    virtual std::string_view convention() const = 0;
    virtual std::string method() const = 0;

    void add_triangle(std::size_t a, std::size_t b, std::size_t c) {
        triangles_.push_back({a, b, c});
    }

    std::vector<CourseVertex> vertices_;

private:
    bool is_empty() const final { return triangles_.empty(); }

    std::string json() const final {
        std::string text = fmt::format(R"({{{},"convention":"{}",)", canvas_json(), convention());
        text += "\n\"vertices\":{";
        std::string colors;
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const auto& [x, y, z, w] = vertices_[i].at;
            const std::string_view separator = i == 0 ? "\n" : ",\n";
            text += fmt::format(R"({}"{}":[{},{},{},{}])", separator, i + 1, x, y, z, w);
            colors += fmt::format(R"({}"{}":"{}")", separator, i + 1, to_text(vertices_[i].color));
        }
        text += "},\n\"colors\":{" + colors + "},\n\"triangles\":[";
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const auto& [a, b, c] = triangles_[i];
            text += fmt::format(R"({}{{"vertices":["{}","{}","{}"],"name":"t{}"}})",
                                i == 0 ? "\n" : ",\n", a + 1, b + 1, c + 1, i + 1);
        }
        return text + "],\n\"method\":{" + method() + "}}\n";
    }

    std::vector<std::array<std::size_t, 3>> triangles_; ///< places in `vertices_`
};

constexpr Color white(255, 255, 255);

/// UIUC CS418. Colors are mixed on the picture unless `hyp` says in space; without `depth`, what is drawn last stays.
class Cs418Reader final : public CourseReader {
public:
    using CourseReader::CourseReader;

private:
    void read_statement(const Words& words) override {
        const std::string_view name = words.front().text;
        if (name == "png") {
            need(words, 3, 3);
            set_canvas(words);
        } else if (name == "xy" || name == "xyz" || name == "xyzw") {
            need(words, name.size(), name.size());
            CourseVertex vertex{.at = {"0", "0", "0", "1"}, .color = color_};
            for (std::size_t i = 0; i < name.size(); ++i)
                vertex.at[i] = number(words[i + 1]);
            vertices_.push_back(std::move(vertex));
        } else if (name == "rgb") {
            need(words, 3, 3);
            std::array<std::uint8_t, 3> levels{};
            for (std::size_t i = 0; i < 3; ++i)
                levels[i] = static_cast<std::uint8_t>(whole(words[i + 1], 0, 255));
            color_ = Color(levels[0], levels[1], levels[2]);
        } else if (name == "tri") {
            need(words, 3, 3);
            add_triangle(corner(words[1]), corner(words[2]), corner(words[3]));
        } else if (name == "position") {
            positions_ = rows(words, 1, 4);
        } else if (name == "color") {
            colors_ = rows(words, 3, 4);
        } else if (name == "drawArraysTriangles") {
            draw_arrays(words);
        } else if (name == "depth" || name == "hyp") {
            need(words, 0, 0);
            (name == "depth" ? has_depth_ : is_hyperbolic_) = true;
        } else {
            refuse_statement(words.front(), {"png", "xy", "xyz", "xyzw", "rgb", "tri", "position",
                                             "color", "drawArraysTriangles", "depth", "hyp"});
        }
    }

    /// A vertex of `tri`: 1 is the first one, -1 the last.
    std::size_t corner(const Word& word) const {
        const auto count = static_cast<std::int64_t>(vertices_.size());
        const std::int64_t number = whole(word, -count, count);
        if (number == 0)
            fail_at(word, fmt::format("a vertex from 1 to {}, or from -1 back", count));
        return static_cast<std::size_t>(number > 0 ? number - 1 : count + number);
    }

    /// `position 4 x y z w x y z w ...`: rows of as many numbers as the first one says.
    struct Rows {
        std::size_t size = 0;
        std::vector<Word> words;
    };
    Rows rows(const Words& words, std::int64_t least, std::int64_t most) const {
        need(words, 1, words.size());
        Rows rows{.size = static_cast<std::size_t>(whole(words[1], least, most)), .words = {}};
        if ((words.size() - 2) % rows.size != 0)
            fail(words.back().offset,
                 fmt::format("expected {} of {} numbers each, found {} numbers", words.front().text,
                             rows.size, words.size() - 2));
        // The text outlives what refers to it.
        rows.words.assign(words.begin() + 2, words.end());
        return rows;
    }

    void draw_arrays(const Words& words) {
        need(words, 2, 2);
        if (positions_.size == 0)
            fail_at(words[0], "a position first");
        const std::size_t most = positions_.words.size() / positions_.size;
        const auto first =
            static_cast<std::size_t>(whole(words[1], 0, static_cast<std::int64_t>(most)));
        const auto count =
            static_cast<std::size_t>(whole(words[2], 0, static_cast<std::int64_t>(most - first)));
        for (std::size_t i = first; i + 2 < first + count; i += 3) {
            const std::size_t begin = vertices_.size();
            for (std::size_t k = i; k < i + 3; ++k)
                vertices_.push_back(vertex_of_arrays(k, words[0]));
            add_triangle(begin, begin + 1, begin + 2);
        }
    }

    CourseVertex vertex_of_arrays(std::size_t index, const Word& statement) const {
        CourseVertex vertex{.at = {"0", "0", "0", "1"}, .color = white};
        for (std::size_t i = 0; i < positions_.size; ++i)
            vertex.at[i] = number(positions_.words[index * positions_.size + i]);
        if (colors_.size == 0)
            return vertex;
        const std::size_t begin = index * colors_.size;
        if (begin + colors_.size > colors_.words.size())
            fail_at(statement, fmt::format("a color for vertex {}", index));
        const auto level = [&](std::size_t i) { return channel(colors_.words[begin + i]); };
        vertex.color = Color(level(0), level(1), level(2));
        return vertex;
    }

    std::string_view convention() const override { return "cs418"; }
    std::string method() const override {
        return fmt::format(R"("shade":"{}"{})", is_hyperbolic_ ? "interpolate" : "affine",
                           has_depth_ ? R"(,"depth":"ndc-z")" : "");
    }

    Color color_ = white;
    Rows positions_;
    Rows colors_;
    bool has_depth_ = false;
    bool is_hyperbolic_ = false;
};

/// UCR CS130. `vertex_data` has a letter for each number of `v`: the place x y z, and with the shader `color` the
/// color r g b behind it, flat (f), mixed in space (s) or on the picture (n).
class UcrReader final : public CourseReader {
public:
    using CourseReader::CourseReader;

private:
    void read_statement(const Words& words) override {
        const std::string_view name = words.front().text;
        if (name == "size") {
            need(words, 2, 2);
            set_canvas(words);
        } else if (name == "vertex_shader") {
            need(words, 1, 1);
            if (words[1].text != "trivial" && words[1].text != "color")
                fail_at(words[1], "the vertex shader trivial or color");
        } else if (name == "fragment_shader") {
            need(words, 1, 1);
            set_fragment_shader(words[1]);
        } else if (name == "vertex_data") {
            need(words, 1, 1);
            set_data(words[1]);
        } else if (name == "v") {
            add_vertex(words);
        } else if (name == "render") {
            render(words);
        } else {
            refuse_statement(words.front(), {"size", "vertex_shader", "fragment_shader",
                                             "vertex_data", "v", "render"});
        }
    }

    void set_fragment_shader(const Word& word) {
        constexpr std::array<std::string_view, 4> names{"red", "green", "blue", "white"};
        constexpr std::array colors{Color(255, 0, 0), Color(0, 255, 0), Color(0, 0, 255), white};
        const auto* const found = std::find(names.begin(), names.end(), word.text);
        if (found == names.end() && word.text != "gouraud")
            fail_at(word, "the fragment shader red, green, blue, white or gouraud");
        constant_ = found == names.end()
                        ? std::nullopt
                        : std::optional(colors[static_cast<std::size_t>(found - names.begin())]);
    }

    void set_data(const Word& word) {
        const std::size_t odd = word.text.find_first_not_of("fsn");
        if (odd != std::string_view::npos || word.text.size() < 3)
            fail_at(word, "three letters or more out of f, s and n");
        data_ = word.text.size();
        const char of_color = data_ < 6 ? 's' : word.text[3];
        has_flat_colors_ = has_flat_colors_ || of_color == 'f';
        is_affine_ = of_color == 'n';
    }

    void add_vertex(const Words& words) {
        need(words, data_, data_);
        CourseVertex vertex{.at = {"0", "0", "0", "1"}, .color = constant_.value_or(white)};
        for (std::size_t i = 0; i < 3; ++i)
            vertex.at[i] = number(words[i + 1]);
        if (!constant_ && data_ >= 6)
            vertex.color = Color(channel(words[4]), channel(words[5]), channel(words[6]));
        vertices_.push_back(std::move(vertex));
    }

    void render(const Words& words) {
        need(words, 1, 1);
        const std::string_view kind = words[1].text;
        const std::size_t end = vertices_.size();
        if (kind == "triangle")
            for (std::size_t i = rendered_; i + 2 < end; i += 3)
                add(i, i + 1, i + 2);
        else if (kind == "fan")
            for (std::size_t i = rendered_ + 1; i + 1 < end; ++i)
                add(rendered_, i, i + 1);
        else if (kind == "strip")
            for (std::size_t i = rendered_; i + 2 < end; ++i)
                add(i, i + 1, i + 2);
        else
            fail_at(words[1], "triangle, fan or strip");
        rendered_ = vertices_.size();
    }

    /// A flat color is that of the first vertex.
    void add(std::size_t a, std::size_t b, std::size_t c) {
        if (!has_flat_colors_ || constant_)
            return add_triangle(a, b, c);
        const std::size_t begin = vertices_.size();
        for (const std::size_t corner : {a, b, c}) {
            vertices_.push_back(vertices_[corner]);
            vertices_.back().color = vertices_[a].color;
        }
        add_triangle(begin, begin + 1, begin + 2);
    }

    std::string_view convention() const override { return "ucr130"; }
    std::string method() const override {
        return fmt::format(R"("shade":"{}")", is_affine_ ? "affine" : "interpolate");
    }

    std::optional<Color> constant_ = white;
    std::size_t data_ = 3; ///< numbers of a vertex
    bool is_affine_ = false;
    bool has_flat_colors_ = false;
    std::size_t rendered_ = 0; ///< the first vertex that the next `render` is about
};

/// What `fuzz` writes: the canvas, and a line for each primitive, with its name and the places of its vertices.
class TrianglesReader final : public StatementReader {
public:
    using StatementReader::StatementReader;

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

    void read_statement(const Words& words) override {
        const std::string_view name = words.front().text;
        if (name == front_of_triangles) {
            need(words, 2, 2);
            return set_canvas(words);
        }
        const auto* const row = std::find_if(rows.begin(), rows.end(),
                                             [name](const Row& one) { return one.word == name; });
        if (row == rows.end())
            refuse_statement(words.front(), {front_of_triangles, "tri", "line", "clip"});
        const std::size_t numbers = row->vertices * row->coordinates;
        if (words.size() != 2 + numbers)
            fail(words.front().offset,
                 fmt::format("expected a name and {} numbers behind {}, found {}", numbers, name,
                             counted(words.size() - 1, "word")));
        std::vector<std::string> names;
        for (std::size_t i = 2; i < words.size(); i += row->coordinates) {
            std::vector<std::string> at;
            for (std::size_t axis = 0; axis < row->coordinates; ++axis)
                at.push_back(typed_number(words[i + axis]));
            names.push_back(json_quoted(fmt::format("P{}", vertices_.size() + 1)));
            vertices_.push_back(fmt::format("{}: [{}]", names.back(), joined(at, ", ")));
        }
        lists_[row->list].push_back(fmt::format(R"({{"vertices": [{}], "name": {}}})",
                                                joined(names, ", "), json_quoted(words[1].text)));
    }

    /// As it stands there: a fraction is no JSON number.
    std::string typed_number(const Word& word) const {
        if (!std::holds_alternative<Number>(parse_number(std::string(word.text))))
            fail_at(word, "a number");
        return json_quoted(word.text);
    }

    bool is_empty() const override { return lists_.empty(); }
    std::string_view primitive() const override { return "primitive"; }

    std::string json() const override {
        std::string text =
            fmt::format("{{{},\n\"vertices\": {{{}}}", canvas_json(), joined(vertices_, ", "));
        for (const auto& [list, primitives] : lists_)
            text += fmt::format(",\n\"{}\": [{}]", list, joined(primitives, ",\n  "));
        return text + "}\n";
    }

    std::vector<std::string> vertices_;
    std::map<std::string_view, std::vector<std::string>> lists_;
};

} // namespace

Result<Source> scene_of_foreign(const Source& source) {
    const std::string_view first = first_statement(source);
    if (first.starts_with('<'))
        return scene_of_svg(source);
    if (begins_obj(first))
        return scene_of_obj(source);
    try {
        std::string text = first == front_of_triangles ? TrianglesReader(source).read()
                           : first == "png"            ? Cs418Reader(source).read()
                                                       : UcrReader(source).read();
        return Source{source.name + " as a scene", std::move(text), {}};
    } catch (const Problem& problem) {
        return problem;
    }
}

} // namespace rastertrace
