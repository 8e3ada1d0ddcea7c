// SPDX-License-Identifier: MIT
#include "obj_file.h"

#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/core/raster/rounding.h>
#include <rastertrace/trace/text/byte_order_mark.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/typed_digits.h>
#include <rastertrace/trace/text/zero_byte.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

namespace rastertrace {

namespace {

using number_text::is_digit;

constexpr Color uncolored(255, 255, 255);

/// Room for every double written out in full: a sign, a point, and 1074 places behind it. The time
/// for a number grows faster than its length, so longer ones are refused.
constexpr std::size_t longest_number = 1100;

/// A decimal of C, `.5`, `1.` or `+2e3`, as JSON and parse_number write it: without `+`, with a digit on both sides of
/// the point. Nothing if it is not the form of a decimal.
std::optional<std::string> usual_form(std::string_view word) {
    std::string usual;
    if (word.starts_with('-'))
        usual = "-";
    if (word.starts_with('-') || word.starts_with('+'))
        word.remove_prefix(1);

    const std::string_view whole = number_text::take_digits(word);
    const bool has_point = number_text::take(word, '.');
    const std::string_view fraction = number_text::take_digits(word);
    const bool exponent_follows = word.starts_with('e') || word.starts_with('E');
    if ((whole.empty() && fraction.empty()) || !(word.empty() || exponent_follows))
        return std::nullopt;

    usual += whole.empty() ? "0" : whole;
    if (has_point)
        usual.append(".").append(fraction.empty() ? "0" : fraction);
    return usual.append(word);
}

/// Statements without which the faces are the same. Nobody needs to be told.
constexpr std::array<std::string_view, 7> plain_statements{"l", "p",      "g",     "o",
                                                           "s", "usemtl", "mtllib"};

/// All others of the Advanced Visualizer manual, appendix B1: curves and surfaces, and their vertices; how a
/// renderer shows things; what the format has had before.
constexpr std::array<std::string_view, 33> skipped_statements{
    "vp",     "cstype",     "deg",       "bmat",     "step",     "curv", "curv2",
    "surf",   "parm",       "trim",      "hole",     "scrv",     "sp",   "end",
    "con",    "mg",         "bevel",     "c_interp", "d_interp", "lod",  "maplib",
    "usemap", "shadow_obj", "trace_obj", "ctech",    "stech",    "call", "csh",
    "bsp",    "bzp",        "cdc",       "cdp",      "res"};

bool is_among(std::string_view name, std::span<const std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string_view text_between(const char* begin, const char* end) {
    return {begin, static_cast<std::size_t>(end - begin)};
}

/// How much of a word is shown.
constexpr std::size_t shown_of_word = 40;

/// Reads one file; the first fault ends it.
///
/// Everything walks `at_` forward, and a character is looked at a fixed number of times, so the
/// time is that of the file's size. `end_` can be read, as a string ends with a zero byte.
class ObjReader {
public:
    explicit ObjReader(const Source& source)
        : source_(source), at_(source.text.c_str()), end_(at_ + source.text.size()) {}

    ObjMesh read() {
        at_ += size_of_mark(source_.text);
        while (at_ != end_) {
            if (at_word())
                read_statement();
            skip_line();
        }
        if (mesh_.face_ends.empty() && mesh_.vertices.empty())
            fail_unquoted(end_, "expected at least one face, found none",
                          "a face of three vertices: f 1 2 3");
        if (mesh_.face_ends.empty())
            fail(end_, "expected at least one face, found none",
                 "a face of three vertices: f 1 2 3");
        if (!has_weights_)
            mesh_.weights.clear();
        if (skipped_ > 0)
            mesh_.remarks.push_back(remark_on_skipped());
        return std::move(mesh_);
    }

private:
    Problem remark_on_skipped() const {
        return problem_at(
            source_, static_cast<std::size_t>(first_skipped_.data() - source_.text.c_str()),
            fmt::format("remark: expected vertices and faces, found {} statement{} of "
                        "curves, surfaces or display, skipped; the first is {}",
                        skipped_, skipped_ == 1 ? "" : "s", first_skipped_),
            "only what f lists is drawn");
    }

    [[noreturn]] void fail(const char* place, std::string message, std::string hint = {}) const {
        throw problem_at(source_, static_cast<std::size_t>(place - source_.text.c_str()),
                         std::move(message), std::move(hint));
    }
    [[noreturn]] void fail_expecting(std::string_view expected, std::string_view found,
                                     std::string hint = {}) const {
        fail(found.data(),
             fmt::format("expected {}, found \"{}\"", expected, shortened(found, shown_of_word)),
             std::move(hint));
    }

    /// Of a file without a vertex, which may be anything, not a word is shown: a scene from somewhere
    /// else could name a file that holds a secret.
    [[noreturn]] void fail_unquoted(const char* place, std::string message,
                                    std::string hint) const {
        Problem problem =
            problem_at(source_, static_cast<std::size_t>(place - source_.text.c_str()),
                       std::move(message), std::move(hint));
        problem.excerpt.clear();
        throw problem;
    }

    /// The length of the line end at `p`, or 0. A carriage return counts only in front of a line
    /// feed or of the end.
    std::size_t line_end_at(const char* p) const {
        if (*p == '\n')
            return 1;
        if (*p == '\r' && p[1] == '\n')
            return 2;
        return *p == '\r' && p + 1 == end_ ? 1 : 0;
    }

    /// The length of the blank at `p`, or 0. A line that ends in a backslash goes on in the next.
    std::size_t blank_at(const char* p) const {
        if (*p == ' ' || *p == '\t')
            return 1;
        if (*p == '\\' && p + 1 != end_ && line_end_at(p + 1) > 0)
            return 1 + line_end_at(p + 1);
        return 0;
    }

    bool word_ends_at(const char* p) const {
        return *p == ' ' || *p == '\n' || p == end_ || line_end_at(p) > 0 || blank_at(p) > 0;
    }

    /// Goes to the next word of the statement; false if there is none.
    bool at_word() {
        while (const std::size_t length = blank_at(at_))
            at_ += length;
        return at_ != end_ && *at_ != '#' && line_end_at(at_) == 0;
    }

    std::string_view take_word() {
        const char* const begin = at_;
        while (!word_ends_at(at_))
            ++at_;
        return text_between(begin, at_);
    }

    /// Leaves a statement that has no more words, and the comment that may stand behind it.
    void skip_line() {
        // Nearly every statement ends with its line.
        if (*at_ == '\n') {
            ++at_;
            return;
        }
        const auto* newline =
            static_cast<const char*>(std::memchr(at_, '\n', static_cast<std::size_t>(end_ - at_)));
        at_ = newline == nullptr ? end_ : newline + 1;
    }

    void read_statement() {
        const std::string_view name = take_word();
        if (name == "v")
            read_vertex(name);
        else if (name == "f")
            read_face(name);
        else if (name == "vt")
            read_texture_coordinate(name);
        else if (name == "vn")
            read_normal(name);
        else if (is_among(name, plain_statements))
            skip_statement();
        else if (is_among(name, skipped_statements)) {
            if (skipped_++ == 0)
                first_skipped_ = name;
            skip_statement();
        } else if (mesh_.vertices.empty())
            fail_unquoted(name.data(), "expected an OBJ file, found a line that is none of it",
                          "its statements are v, vt, vn, f, l, p, g, o, s, usemtl, mtllib");
        else
            fail_expecting("a statement out of v, vt, vn, f, l, p, g, o, s, usemtl, mtllib", name);
    }

    void skip_statement() {
        while (at_word())
            take_word();
    }

    /// v x y z, v x y z w, or v x y z red green blue.
    void read_vertex(std::string_view name) {
        std::array<Number, 3>& position = mesh_.vertices.emplace_back();
        float& unit = mesh_.units.emplace_back();
        std::size_t count = 0;
        std::array<Number, 3> behind;
        std::array<std::string_view, 3> words;
        for (; at_word(); ++count) {
            const char* const begin = at_;
            TypedNumber typed = take_number();
            if (count < 3) {
                position[count] = std::move(typed.number);
                unit = std::max(unit, typed.unit);
            } else if (count < 6) {
                behind[count - 3] = std::move(typed.number);
                words[count - 3] = text_between(begin, at_);
            }
        }
        if (count != 3 && count != 4 && count != 6)
            fail(name.data(), fmt::format("expected v with 3, 4 or 6 numbers, found {}", count));
        if (count == 4)
            has_weights_ = has_weights_ || behind[0].numerator_over(1) != 1;
        if (count == 4 || !mesh_.weights.empty())
            put_last(mesh_.weights, count == 4 ? std::move(behind[0]) : Number(1), Number(1));
        if (count == 6 || !mesh_.colors.empty())
            put_last(mesh_.colors, count == 6 ? color_of(behind, words) : uncolored, uncolored);
    }

    /// Gives the last vertex a value; those before it that have none get the usual one.
    template <typename Value>
    void put_last(std::vector<Value>& values, Value value, const Value& usual) const {
        values.resize(mesh_.vertices.size(), usual);
        values.back() = std::move(value);
    }

    Color color_of(const std::array<Number, 3>& channels,
                   const std::array<std::string_view, 3>& words) const {
        std::array<std::uint8_t, 3> levels{};
        for (std::size_t i = 0; i < 3; ++i) {
            const double channel = channels[i].nearest_double();
            if (!(0 <= channel && channel <= 1))
                fail_expecting("a channel from 0 to 1", words[i]);
            levels[i] = level_of(Rational(channels[i].exact() * 255), ColorRounding::nearest);
        }
        return {levels[0], levels[1], levels[2]};
    }

    void read_texture_coordinate(std::string_view name) {
        const std::size_t count = check_numbers();
        if (count < 1 || count > 3)
            fail(name.data(), fmt::format("expected vt with 1 to 3 numbers, found {}", count));
        ++texture_coordinates_;
    }

    void read_normal(std::string_view name) {
        const std::size_t count = check_numbers();
        if (count != 3)
            fail(name.data(), fmt::format("expected vn with 3 numbers, found {}", count));
        ++normals_;
    }

    /// How many numbers there are up to the end of the statement.
    std::size_t check_numbers() {
        std::size_t count = 0;
        for (; at_word(); ++count)
            take_number();
        return count;
    }

    void read_face(std::string_view name) {
        const std::size_t begin = mesh_.corners.size();
        while (at_word())
            mesh_.corners.push_back(take_corner());
        const std::size_t count = mesh_.corners.size() - begin;
        if (count < 3)
            fail(name.data(), fmt::format("expected f with 3 corners or more, found {}", count));
        mesh_.face_ends.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    }

    /// v, v/vt, v//vn or v/vt/vn. Only the place of the vertex is kept.
    std::uint32_t take_corner() {
        const char* const begin = at_;
        const std::uint32_t vertex = take_index(begin, mesh_.vertices.size(), "vertex");
        if (take_slash()) {
            if (*at_ != '/')
                take_index(begin, texture_coordinates_, "texture coordinate");
            if (take_slash())
                take_index(begin, normals_, "normal");
        }
        if (!word_ends_at(at_))
            fail_corner(begin);
        return vertex;
    }

    bool take_slash() {
        const bool is_slash = *at_ == '/';
        at_ += is_slash ? 1 : 0;
        return is_slash;
    }

    /// The place, from 0, that an index stands for: from 1 on, or back from the last so far, -1.
    std::uint32_t take_index(const char* corner, std::size_t so_far, std::string_view of_what) {
        const char* const begin = at_;
        std::int64_t index = 0;
        const auto [after, error] = std::from_chars(begin, end_, index);
        if (error == std::errc::invalid_argument || !(*after == '/' || word_ends_at(after)))
            fail_corner(corner);
        at_ = after;

        const auto count = static_cast<std::int64_t>(so_far);
        const std::int64_t place = index > 0 ? index - 1 : count + index;
        if (error != std::errc() || index == 0 || place < 0 || place >= count)
            fail(begin,
                 fmt::format("expected the index of a {} ({} so far), found {}", of_what, so_far,
                             shortened(text_between(begin, after), shown_of_word)),
                 "1 is the first in the file, -1 the last before this line");
        return static_cast<std::uint32_t>(place);
    }

    [[noreturn]] void fail_corner(const char* begin) {
        at_ = begin;
        fail_expecting("a corner like 1, 1/1, 1//1 or 1/1/1", take_word());
    }

    /// A number, and what its last digit counts: see typed_digits.h.
    struct TypedNumber {
        Number number;
        float unit;
    };

    TypedNumber take_number() {
        // Nearly every number is a few digits with a point among them.
        const char* p = at_;
        const bool negative = *p == '-';
        if (*p == '-' || *p == '+')
            ++p;
        std::uint64_t digits = 0;
        std::ptrdiff_t count = 0;
        std::ptrdiff_t behind_point = 0;
        for (; is_digit(*p); ++p, ++count)
            digits = 10 * digits + static_cast<std::uint64_t>(*p - '0');
        if (*p == '.')
            for (++p; is_digit(*p); ++p, ++count, ++behind_point)
                digits = 10 * digits + static_cast<std::uint64_t>(*p - '0');

        // 19 digits cannot overflow; Number::decimal takes 18. The rest is for parse_number.
        constexpr auto too_many_digits = static_cast<std::uint64_t>(power_of_ten(18));
        if (count == 0 || count > 19 || digits >= too_many_digits || !word_ends_at(p)) {
            const std::string_view word = take_word();
            return {number_in(word), unit_of_last_digit(word)};
        }
        at_ = p;

        // As parse_number does, zeros at the end become part of the exponent.
        auto exponent = static_cast<int>(-behind_point);
        for (; digits != 0 && digits % 10 == 0; digits /= 10)
            ++exponent;
        const auto magnitude = static_cast<std::int64_t>(digits);
        return {Number::decimal(negative ? -magnitude : magnitude, exponent),
                unit_of_place(static_cast<int>(-behind_point))};
    }

    /// A word as a number, whatever its form.
    Number number_in(std::string_view word) const {
        if (word.size() > longest_number)
            fail_expecting(fmt::format("a number of at most {} characters", longest_number), word);
        const auto usual = usual_form(word);
        if (!usual)
            fail_expecting("a number", word);
        auto parsed = parse_number(*usual);
        if (auto* number = std::get_if<Number>(&parsed))
            return std::move(*number);
        switch (std::get<NumberFault>(parsed)) {
        case NumberFault::too_large:
            fail_expecting("a number up to 1.797e308", word);
        case NumberFault::too_small:
            fail_expecting("0 or a number from 4.941e-324 on", word);
        case NumberFault::too_long:
            fail_expecting(fmt::format("a number of at most {} characters", longest_number), word);
        case NumberFault::zero_denominator: // there are no fractions here
        case NumberFault::malformed:
            break;
        }
        fail_expecting("a number", word);
    }

    const Source& source_;
    const char* at_;  ///< what is read next
    const char* end_; ///< one past the last character, where a zero byte stands
    ObjMesh mesh_;
    std::size_t texture_coordinates_ = 0; ///< how many there were so far
    std::size_t normals_ = 0;
    bool has_weights_ = false;       ///< other than 1
    std::size_t skipped_ = 0;        ///< statements that somebody should know of
    std::string_view first_skipped_; ///< the word of the first one
};

/// A number as JSON has it: a decimal with its exponent.
std::string json_of(const Number& number) {
    const auto decimal = number.as_decimal();
    if (!decimal)
        return fmt::format(R"("{}")", number.exact().get_str());
    return decimal->exponent == 0 ? fmt::format("{}", decimal->digits)
                                  : fmt::format("{}e{}", decimal->digits, decimal->exponent);
}

} // namespace

Result<ObjMesh> read_obj(const Source& source) {
    // A corner is at least two bytes, so 32 bits count the corners of any file up to here.
    constexpr std::size_t largest_file = std::numeric_limits<std::uint32_t>::max();
    if (source.text.size() > largest_file)
        return problem_of(source.name, fmt::format("expected a file of at most {} bytes, found {}",
                                                   largest_file, source.text.size()));
    if (auto problem = zero_byte_in(source)) {
        problem->excerpt.clear();
        return *std::move(problem);
    }
    try {
        return ObjReader(source).read();
    } catch (const Problem& problem) {
        return problem;
    }
}

Result<Source> scene_of_obj(const Source& source) {
    const auto read = read_obj(source);
    if (!read)
        return read.problem();
    const ObjMesh& mesh = read.value();
    std::string vertices;
    std::string colors;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const std::string_view separator = i == 0 ? "\n" : ",\n";
        const auto& [x, y, z] = mesh.vertices[i];
        vertices += fmt::format(R"({}"{}":[{},{},{})", separator, i + 1, json_of(x), json_of(y),
                                json_of(z));
        vertices += mesh.weights.empty() ? "]" : "," + json_of(mesh.weights[i]) + "]";
        if (!mesh.colors.empty())
            colors += fmt::format(R"({}"{}":"{}")", separator, i + 1, to_text(mesh.colors[i]));
    }
    std::string faces;
    for (std::size_t i = 0; i < mesh.faces(); ++i) {
        std::string corners;
        for (const std::uint32_t corner : mesh.face(i))
            corners += fmt::format(R"({}"{}")", corners.empty() ? "" : ",", corner + 1);
        faces += fmt::format("{}[{}]", i == 0 ? "\n" : ",\n", corners);
    }
    return Source{source.name + " as a scene",
                  fmt::format(R"({{"canvas":{{"width":64,"height":48}},)"
                              "\n\"meshes\":[{{\"vertices\":{{{}}},\n\"faces\":[{}]}}]{}{}}}\n",
                              vertices, faces,
                              colors.empty() ? colors : ",\n\"colors\":{" + colors + "}",
                              mesh.weights.empty() ? ",\n\"camera\":\"fit\"" : ""),
                  {}};
}

} // namespace rastertrace
