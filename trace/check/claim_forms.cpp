// SPDX-License-Identifier: MIT
#include "claim_forms.h"

#include "claim_builder.h"
#include "claim_comparison.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

namespace {

/// What a line can look like, for who has written another.
constexpr std::string_view forms =
    "a line looks like `y=2: -1/4, 25/8 -> -1..3`, `y=2 depth: 1/3, 1/5`, `(3,2): on`, "
    "`(3,2): z 10/3`, `A screen: 2, 5`, `normal ABC: 0, 0, -4`, `dot ABC: -12 culled`, "
    "`AB: -1 3 -3`, `edge AB: 3/4`, `depth ACD (3,2): fails`, `order: ABC, ACD`, `picture:`";

/// A vertex in a space, and how many coordinates it has there.
struct SpaceName {
    std::string_view name;
    std::size_t coordinates;
};
constexpr std::array<SpaceName, 6> space_names{
    {{"object", 3}, {"world", 3}, {"camera", 3}, {"clip", 4}, {"canonical", 3}, {"screen", 2}}};

/// A word before the name of a face, and what it claims.
struct FaceWord {
    std::string_view word;
    std::string_view step;
    std::string_view field;
    std::size_t numbers;
};
constexpr std::array<FaceWord, 9> face_words{{{"normal", "face", "normal", 3},
                                              {"centroid", "face", "centroid", 3},
                                              {"view", "face", "view", 3},
                                              {"plane", "face", "plane", 4},
                                              {"cosine", "face", "cosine", 1},
                                              {"angle", "face", "angle", 1},
                                              {"dot", "face", "dot", 1},
                                              {"light", "light", "light", 3},
                                              {"intensity", "light", "intensity", 1}}};

/// What people call a row, a pixel and an edge before they say which.
constexpr auto row_words = std::to_array<std::string_view>({"row", "scanline", "line"});
constexpr auto pixel_words = std::to_array<std::string_view>({"pixel", "point"});
constexpr auto counted_words = std::to_array<std::string_view>({"rows", "pixels"});
constexpr auto names_in_lists =
    std::to_array<std::string_view>({"d", "dk", "d_k", "p", "pk", "p_k", "x", "y", "z", "w"});
constexpr auto edge_words = std::to_array<std::string_view>({"edge", "slope", "dx/dy"});

bool is_one_of(const ClaimWord& word, std::span<const std::string_view> known) {
    return std::any_of(known.begin(), known.end(),
                       [&word](std::string_view one) { return word.is(one); });
}

/// What fields are called by who has not seen their names, because in a table they have none.
struct FieldWords {
    std::string_view field;
    Words words;
};
constexpr auto field_words = std::to_array<FieldWords>({{"left", "left end"},
                                                        {"x", "ends of the row"},
                                                        {"right", "right end"},
                                                        {"from", "first pixel"},
                                                        {"to", "last pixel"},
                                                        {"left_depth", "depth at the left end"},
                                                        {"right_depth", "depth at the right end"},
                                                        {"dx_dy", "dx/dy"},
                                                        {"plotted", "pixel"},
                                                        {"inside", "pixel"},
                                                        {"inverse_z", "1/z"},
                                                        {"pass", "depth test"},
                                                        {"culled", "face"},
                                                        {"visible", "seen"},
                                                        {"row_count", "number of rows"},
                                                        {"pixel_count", "number of pixels"},
                                                        {"share", "share of the color"},
                                                        {"y_form", "m, b of y = m x + b"},
                                                        {"x_form", "m, b of x = m y + b"},
                                                        {"names", "order"},
                                                        // Called by their names in English.
                                                        {"angle", "angle"},
                                                        {"at", "at"},
                                                        {"centroid", "centroid"},
                                                        {"color", "color"},
                                                        {"cosine", "cosine"},
                                                        {"depth", "depth"},
                                                        {"distances", "distances"},
                                                        {"dot", "dot"},
                                                        {"intensity", "intensity"},
                                                        {"left_edge", "left_edge"},
                                                        {"light", "light"},
                                                        {"move", "move"},
                                                        {"octant", "octant"},
                                                        {"out", "out"},
                                                        {"picture", "picture"},
                                                        {"plane", "plane"},
                                                        {"radius", "radius"},
                                                        {"right_edge", "right_edge"},
                                                        {"rows", "rows"},
                                                        {"snapped", "snapped"},
                                                        {"stored", "stored"},
                                                        {"value", "value"},
                                                        {"vertices", "vertices"},
                                                        {"view", "view"},
                                                        {"weights", "weights"}});

/// Reads the claim of one line. What is wrong is thrown as a Problem.
class ClaimReader : ClaimBuilder {
public:
    using ClaimBuilder::ClaimBuilder;

    void read() {
        line_.leave_out_fillers();
        const bool has_kind = line_.peek().is("line") || line_.peek().is("triangle") ||
                              line_.peek().is("vertex") || line_.peek().is("polygon");
        if ((has_kind && line_.peek(1).is_name() && !is_row_next()) ||
            (line_.peek().is("x") && line_.peek(1).is("y")))
            line_.next();
        const ClaimWord first = line_.peek();
        const ClaimWord second = line_.peek(1);
        const auto* const face_word =
            std::find_if(face_words.begin(), face_words.end(),
                         [&first](const FaceWord& known) { return first.is(known.word); });
        const bool names_pixel =
            is_one_of(first, pixel_words) && (second.is("(") || is_number(second));
        const bool is_bare_pixel =
            is_number(first) && second.is(",") && is_number(line_.peek(2)) && line_.peek(3).is(":");
        if (first.is("(") || names_pixel || is_bare_pixel)
            read_pixel();
        else if (first.is("depth"))
            read_depth();
        else if (first.is("order"))
            read_order();
        else if (first.is("weights"))
            read_weights();
        else if (first.is("matrix"))
            read_matrix();
        else if (is_row_next())
            read_row({});
        else if (is_one_of(first, row_sides) && second.is_name())
            read_side(line_.next());
        else if (is_one_of(first, edge_words))
            read_edge({});
        else if (face_word != face_words.end())
            read_face(*face_word);
        else if (first.is_name())
            read_named(line_.next());
        else
            line_.fail(first, "a claim", std::string(forms));
        line_.expect_end();
    }

    /// What an empty cell holds has not been worked out yet.
    void read_cell(std::string_view field) {
        const bool is_pixels = field == "pixels";
        if (line_.at_end() && (is_pixels || !field_named(field).is_key)) {
            put(is_pixels ? "from" : field,
                {.text = std::string(open_value), .offset = line_.peek().offset});
            return;
        }
        if (is_pixels)
            read_pixels_of_row();
        else if (field == "dx_dy")
            read_slope();
        else
            read_field(field_named(field));
        line_.expect_end();
    }

    /// (3,2) or 3, 2
    void read_pixel_cell() {
        if (line_.peek().is("(")) {
            read_place();
        } else {
            const auto place = line_.numbers(2);
            put("x", place[0]);
            put("y", place[1]);
        }
        line_.expect_end();
    }

private:
    void read_field(const ClaimField& field) {
        const bool is_number = field.type == FieldType::quantity || field.type == FieldType::whole;
        if (is_number && field.is_list)
            put_list(field.name, line_.numbers(0));
        else if (is_number)
            put(field.name, line_.one_number());
        else if (field.type == FieldType::boolean)
            read_verdict(field.name, field.name == "culled" ? "culled or drawn" : "on or off");
        else
            put(field.name, line_.next());
    }

    static bool is_number(const ClaimWord& one) {
        return !one.is_quoted && std::holds_alternative<Number>(parse_number(one.text));
    }

    /// True if a row is named next: y=2, row 2, row y=2, 2:.
    bool is_row_next() const {
        const ClaimWord word = line_.peek();
        const ClaimWord second = line_.peek(1);
        // 01 is the name of a line from 0 to 1.
        const bool is_plain = word.text == "0" || !word.text.starts_with('0');
        return ((word.is("y") || word.is("Y")) && second.is("=")) ||
               (is_one_of(word, row_words) &&
                (second.is("y") || second.is("Y") || is_number(second))) ||
               (is_plain && is_number(word) && second.is(":"));
    }

    /// Goes behind the colon or the equals sign between what a claim is about and what it says.
    void go_to_value() {
        if (!line_.take("="))
            line_.expect(":", "`:`");
    }

    /// What begins with the name of a primitive or a vertex.
    void read_named(const ClaimWord& name) {
        const ClaimWord second = line_.peek();
        if (is_row_next())
            read_row(name);
        else if (second.is("x") && line_.peek(1).is("="))
            read_along(name);
        else if (is_one_of(second, edge_words) &&
                 (line_.peek(1).is("=") || line_.peek(1).is(":") || line_.is_end(2)))
            read_slope_of(name);
        else if (is_one_of(second, edge_words))
            read_edge(name);
        else if (is_one_of(second, counted_words))
            read_counted(name);
        else if (second.is(":") || second.is("=") || second.is("("))
            read_of_name(name);
        else if (second.is_name())
            read_vertex(name);
        else
            line_.fail(second, fmt::format("what is claimed of {}", name.text), std::string(forms));
    }

    /// left y=2: -1/4, left edge y=2: -1/4
    void read_side(const ClaimWord& side) {
        if (!line_.take("edge") && !line_.take("end"))
            line_.take("x");
        if (!is_row_next())
            line_.fail(line_.peek(), "a row, like y=2");
        read_row({}, side.text);
    }

    /// [ABC ]y=2: -1/4, 25/8 -> -1..3, or the ends of all spans of a polygon in the row.
    void read_row(const std::optional<ClaimWord>& primitive, std::string_view side = {}) {
        begin("scanline", primitive);
        if (is_one_of(line_.peek(), row_words))
            line_.next();
        if (line_.take("y") || line_.take("Y"))
            line_.expect("=", "`=` and the row");
        put("y", line_.key());
        const bool is_depth = line_.take("depth");
        go_to_ends();
        if (is_depth)
            return put_ends("left_depth", "right_depth", line_.numbers(2));
        if (line_.take("->") || is_pixels_word())
            return read_pixels_of_row();
        // x from -1/4 to 25/8 are the ends, -1 to 3 the pixels.
        if (line_.peek(1).is("from"))
            line_.take("x");
        const bool says_x = line_.peek().is("from") || line_.peek(1).is("=");
        const ClaimWord before = line_.peek();
        if (is_one_of(before, row_sides))
            side = before.text;
        std::vector<ClaimWord> ends = line_.numbers(0, 2);
        if (ends.size() > 1 && counts_pixels(ends.back())) {
            put("pixel_count", ends.back());
            ends.pop_back();
        }
        const bool are_pixels = ends.size() == 2 && !says_x && are_apart_by_dots(ends) &&
                                is_whole(ends[0]) && is_whole(ends[1]);
        if (are_pixels)
            return put_ends("from", "to", ends);
        if (ends.size() == 1 && counts_pixels(ends.front()) && line_.at_end())
            return put("pixel_count", ends.front());
        if (ends.size() == 1 && !side.empty())
            return put(side, ends.front());
        if (ends.size() == 1 && primitive) { // of a line that is longer in y
            claim_.step = "along";
            return put_along(ends.front());
        }
        if (ends.size() == 1)
            line_.fail(line_.peek(), "a comma between left and right");
        if (ends.size() > 2)
            return put_crossings(ends);
        put_ends("left", "right", ends);
        if (line_.at_end())
            return;
        if (!is_pixels_word())
            line_.expect("->", "`->` and the pixels, or the end of the line");
        is_pixels_word();
        read_pixels_of_row();
    }

    /// Goes behind the colon of a row. None is needed before an arrow or a word.
    void go_to_ends() {
        constexpr std::array<std::string_view, 6> words{"left", "right",  "x",
                                                        "from", "pixels", "->"};
        const bool has_comma = line_.peek().is(",") && is_one_of(line_.peek(1), words);
        if (!line_.take(has_comma ? "," : ":") && !is_one_of(line_.peek(), words))
            line_.expect(":", "`:`");
    }

    /// Goes behind a word that says that pixels follow.
    bool is_pixels_word() {
        return line_.take("pixels") || line_.take("pixel") || line_.take("px");
    }

    /// True of 5 pixels, which is a number with its unit.
    bool counts_pixels(const ClaimWord& number) const {
        const std::string_view typed = line_.typed(number);
        return typed.ends_with("pixels") || typed.ends_with("pixel");
    }

    static bool is_whole(const ClaimWord& number) {
        return number.text.find_first_of("./") == std::string::npos;
    }

    /// True of -1..3 and of -1 to 3.
    bool are_apart_by_dots(const std::vector<ClaimWord>& ends) const {
        return line_.between(ends[0], ends[1]).find_first_not_of(" \t.to") == std::string::npos;
    }

    void put_ends(std::string_view left, std::string_view right,
                  const std::vector<ClaimWord>& ends) {
        put(left, ends.front());
        put(right, ends.back());
    }

    /// The ends of all spans of a polygon in a row.
    void put_crossings(const std::vector<ClaimWord>& ends) {
        claim_.step = "crossings";
        put_list("x", ends);
    }

    /// -1..3, or all of them: -1, 0, 1, 2, 3
    void read_pixels_of_row() {
        std::vector<ClaimWord> pixels = line_.numbers(0);
        if (pixels.size() > 1 && counts_pixels(pixels.back())) { // -1..3, 5 pixels
            put("pixel_count", pixels.back());
            pixels.pop_back();
        }
        const bool are_ends = pixels.size() == 2 && claim_.find("left") == nullptr &&
                              !are_apart_by_dots(pixels) &&
                              !(is_whole(pixels[0]) && is_whole(pixels[1]));
        if (are_ends) // y=2 -> -1/4, 25/8
            return put_ends("left", "right", pixels);
        std::vector<std::string> numbers;
        for (const ClaimWord& pixel : pixels)
            numbers.push_back(pixel.text);
        if (pixels.size() <= 2 || are_consecutive(numbers))
            put_ends("from", "to", pixels);
        else
            put_list("pixels", pixels);
    }

    /// (3,2): on, z 10/3
    void read_pixel() {
        begin("pixel", {});
        if (is_one_of(line_.peek(), pixel_words))
            line_.next();
        read_place();
        if (line_.peek().is_name() && !is_of_pixel(line_.peek()) && line_.peek(1).is(":"))
            return read_in_primitive(line_.next());
        if (!line_.take(":"))
            line_.take("=");
        if (find_verdict(line_.peek(), "inside"))
            return read_verdict("inside", "inside or outside");
        do
            read_of_pixel(line_.next());
        while (line_.take(","));
    }

    static bool is_of_pixel(const ClaimWord& word) {
        return find_verdict(word, "plotted") != nullptr || find_verdict(word, "inside") != nullptr;
    }

    void read_of_pixel(const ClaimWord& word) {
        const bool is_not = word.is("not");
        const ClaimWord said = is_not ? line_.next() : word;
        if (const VerdictWord* const verdict = find_verdict(said, "plotted"))
            return is_not ? put_value({{}, "plotted", verdict->value == "true" ? "false" : "true"},
                                      word)
                          : put_value(*verdict, word);
        if (word.is(open_value))
            return put("plotted", word);
        for (const auto& [name, field] :
             {std::pair{"z", "z"}, std::pair{"1/z", "inverse_z"}, std::pair{"share", "share"}})
            if (word.is(name))
                return put(field, line_.one_number());
        if (word.is("color"))
            return put("color", line_.next());
        line_.fail(word, "on, off, inside, outside, z, 1/z, share or color",
                   did_you_mean(word.text, {"on", "off", "inside", "outside", "share", "color"}));
    }

    /// (3,2) ABC: inside, (3,2) ABC: hidden
    void read_in_primitive(const ClaimWord& primitive) {
        put("in", primitive);
        line_.expect(":", "`:`");
        if (find_verdict(line_.peek(), "visible"))
            return read_verdict("visible", "visible or hidden");
        read_verdict("inside", "inside, outside, visible or hidden");
    }

    /// depth ACD (3,2): 1/3 fails
    void read_depth() {
        line_.next();
        begin("depth", line_.peek().is("(") ? std::nullopt : std::optional(line_.next()));
        read_place();
        line_.expect(":", "`:`");
        if (!find_verdict(line_.peek(), "pass"))
            put("depth", line_.one_number());
        if (!line_.at_end())
            read_verdict("pass", "passes or fails");
    }

    /// True of (3,2) (4,2), with or without a mark between them.
    bool are_points_next() const {
        std::size_t end = 0;
        while (!line_.peek(end).text.empty() && !line_.peek(end).is(")"))
            ++end;
        const ClaimWord between = line_.peek(end + 1);
        const bool has_mark = between.is(",") || between.is(";") || between.is("->");
        return line_.peek().is("(") && line_.peek(end + (has_mark ? 2 : 1)).is("(");
    }

    void begin_primitive(const ClaimWord& name) {
        begin("primitive", {});
        put("name", name);
    }

    /// AB pixels: (2,5) (1,4), AB pixels: 9, ABC rows: 9
    void read_counted(const ClaimWord& name) {
        begin_primitive(name);
        const bool are_rows = line_.next().is("rows");
        go_to_value();
        if (!are_rows && line_.peek().is("("))
            read_points();
        else
            put(are_rows ? "row_count" : "pixel_count", line_.one_number());
    }

    void read_points() {
        std::vector<ClaimWord> coordinates;
        do {
            for (ClaimWord& coordinate : point())
                coordinates.push_back(std::move(coordinate));
            if (!line_.take(",") && !line_.take(";"))
                line_.take("->");
        } while (!line_.at_end());
        put_list("pixels", coordinates);
    }

    /// 9 rows, 50 pixels
    void read_counts() {
        do {
            const ClaimWord number = line_.one_number();
            const bool are_rows = line_.take("rows") || line_.take("row");
            if (!are_rows && !counts_pixels(number))
                line_.fail(line_.peek(), "rows or pixels");
            put(are_rows ? "row_count" : "pixel_count", number);
        } while (line_.take(",") || line_.take("and"));
    }

    /// True of y = 4/3 x + 7/3, and of y = 3 alone.
    bool is_form_next() const {
        const bool is_of_x = line_.peek().is("y");
        if ((!is_of_x && !line_.peek().is("x")) || !line_.peek(1).is("="))
            return false;
        std::size_t at = 2;
        for (; !line_.peek(at).text.empty() && !line_.peek(at).is(","); ++at)
            if (line_.peek(at).text.ends_with(is_of_x ? 'x' : 'y'))
                return true;
        return line_.peek(at).text.empty();
    }

    /// y = 4/3 x + 7/3 on the line or the edge of that name; x = 3/4 y - 7/4
    void read_form(const ClaimWord& name) {
        begin("edge", {});
        put("edge", name);
        const ClaimWord axis = line_.next();
        line_.next();
        const std::string other = axis.is("y") ? "x" : "y";
        const ClaimWord first = line_.peek();
        const auto constant = [&first](std::string_view text) {
            return ClaimWord{.text = std::string(text), .offset = first.offset};
        };
        ClaimWord m = constant("0");
        ClaimWord b = constant("0");
        if (first.is(other) || first.is("-" + other)) {
            m = constant(line_.next().is(other) ? "1" : "-1");
        } else {
            b = line_.one_number();
            if (line_.take("-", other))
                m = constant("-1");
            else if (line_.take("+", other))
                m = constant("1");
            else if (line_.take(other))
                split_sum(m, b, constant("0"));
        }
        if (!line_.at_end())
            b = line_.one_number();
        if (b.is(open_value) && m.text == "0")
            m = b;
        put_list(axis.is("y") ? "y_form" : "x_form", {m, b});
    }

    /// Of 7/3 + 4/3, before x, the last term is m; of one term, all of it.
    void split_sum(ClaimWord& m, ClaimWord& b, const ClaimWord& zero) const {
        const std::string_view typed = line_.typed(b);
        const std::size_t sign = std::max(typed.rfind(" + ") + 1, typed.rfind(" - ") + 1);
        const auto term = [](std::string_view text) {
            const auto read = number_at(text, {});
            const auto* const number = std::get_if<TypedNumber>(&read);
            return number == nullptr ? std::string() : number->text;
        };
        const bool is_sum = sign > 0 && typed.find(')', sign) == std::string_view::npos;
        m = b;
        if (is_sum) {
            m.text = term(typed.substr(sign));
            b.text = term(typed.substr(0, sign - 1));
        } else {
            b = zero;
        }
    }

    /// order: ABC, ACD
    void read_order() {
        begin("order", {});
        line_.next();
        line_.expect(":", "`:`");
        std::vector<ClaimWord> names;
        do
            names.push_back(line_.next());
        while (line_.take(",") || line_.take("->"));
        put_list("names", names);
    }

    /// weights [ABC ](3,2): 5/8, 1/72, 13/36
    void read_weights() {
        line_.next();
        begin("sample", line_.peek().is("(") ? std::nullopt : std::optional(line_.next()));
        read_place();
        line_.expect(":", "`:`");
        put_list("weights", line_.numbers(3));
    }

    /// matrix view: [1 0 0 0] [0 1 0 0] [0 0 1 -4] [0 0 0 1]
    void read_matrix() {
        begin("matrix", {});
        line_.next();
        put("name", line_.next());
        go_to_value();
        std::vector<ClaimWord> entries;
        do {
            const auto row = line_.numbers(4);
            entries.insert(entries.end(), row.begin(), row.end());
            if (!line_.take(","))
                line_.take(";");
        } while (!line_.at_end());
        put_list("rows", entries);
    }

    /// AB x=3: 9/4 -> 2, a line's other coordinate in a column, and its pixel
    void read_along(const ClaimWord& line) {
        begin("along", line);
        line_.next();
        line_.expect("=", "`=` and the column");
        put("x", line_.key());
        line_.expect(":", "`:`");
        put_along(line_.one_number());
    }

    void put_along(const ClaimWord& value) {
        put("value", value);
        if (line_.take("->"))
            put("pixel", line_.key());
    }

    /// [ABC ]edge AB: 3/4
    void read_edge(const std::optional<ClaimWord>& primitive) {
        begin("edge", primitive);
        line_.next();
        const ClaimWord name = line_.next();
        const bool says_slope = line_.take("dx/dy"); // edge AB dx/dy 3/4
        if (!line_.take("=") && !line_.take(":") && !says_slope)
            line_.expect(":", "`:`");
        if (is_form_next())
            return read_form(name);
        put("edge", name);
        line_.take("dx/dy", "=");
        read_slope();
    }

    /// AB slope 3/4, AB: dx/dy = 3/4
    void read_slope_of(const ClaimWord& edge) {
        begin("edge", {});
        put("edge", edge);
        line_.next();
        if (!line_.take("="))
            line_.take(":");
        read_slope();
    }

    /// 3/4, 3 : 4, or none
    void read_slope() {
        if (is_no_slope())
            return put_no_slope();
        ClaimWord slope = line_.one_number();
        if (line_.take(":")) {
            const ClaimWord below = line_.one_number();
            slope.text = typed_quotient(slope.text, below.text);
            if (slope.text.empty())
                line_.fail(below, "a denominator other than 0");
        }
        put("dx_dy", slope);
    }

    bool is_no_slope() const {
        return line_.peek().is("none") || line_.peek().is("horizontal") ||
               line_.peek().is("undefined") || (line_.peek().is("no") && line_.peek(1).is("slope"));
    }

    void put_no_slope() {
        const ClaimWord word = line_.next();
        if (word.is("no"))
            line_.next();
        put("dx_dy", {.text = std::string(no_slope), .offset = word.offset});
    }

    /// normal ABC: 0, 0, -4
    void read_face(const FaceWord& about) {
        begin(about.step, {});
        line_.next();
        put("name", line_.next());
        go_to_value();
        put_list(about.field, line_.numbers(about.numbers));
        if (about.word == "dot" && !line_.at_end())
            read_verdict("culled", "culled or drawn");
    }

    /// AB: -1 3 -3 1 -5, or ABC: culled. What AB is says whether it is Bresenham's d, a slope or a vertex (check.cpp).
    void read_of_name(const ClaimWord& name) {
        if (!line_.take(":")) // A = (2, 5), A(2, 5)
            line_.take("=");
        if (is_form_next())
            return read_form(name);
        if (is_one_of(line_.peek(), edge_words))
            return read_slope_of(name);
        if (are_points_next()) {
            begin_primitive(name);
            return read_points();
        }
        if (find_verdict(line_.peek(), "visible")) {
            begin_primitive(name);
            return read_verdict("visible", "visible or hidden");
        }
        if (line_.has("rows") || line_.has("pixels")) {
            begin_primitive(name);
            return read_counts();
        }
        if (find_verdict(line_.peek(), "culled")) {
            begin("face", {});
            put("name", name);
            return read_verdict("culled", "culled or drawn");
        }
        if (is_no_slope()) {
            begin("edge", {});
            put("edge", name);
            return put_no_slope();
        }
        if (line_.peek().is("m") && line_.peek(1).is("="))
            return read_slope_and_constant(name);
        if (line_.peek().is_name() && line_.peek(1).is("=") &&
            !is_one_of(line_.peek(), names_in_lists))
            line_.fail(line_.peek(), "numbers, or a line, like y = 4/3 x + 7/3");
        begin("decide", name);
        put_list("d", line_.numbers(0));
    }

    /// AB: m = 4/3, b = 7/3
    void read_slope_and_constant(const ClaimWord& name) {
        begin("edge", {});
        put("edge", name);
        line_.skip(2);
        const ClaimWord m = line_.one_number();
        ClaimWord b{.text = std::string(open_value), .offset = m.offset};
        line_.take(",");
        if (line_.take("b", "="))
            b = line_.one_number();
        put_list("y_form", {m, b});
    }

    /// A screen: -10/3, 10/3 -> -4, 3
    void read_vertex(const ClaimWord& name) {
        const ClaimWord second = line_.next();
        const auto* const space =
            std::find_if(space_names.begin(), space_names.end(),
                         [&second](const SpaceName& known) { return second.is(known.name); });
        if (space == space_names.end())
            refuse_space(name, second);
        begin("vertex", {});
        put("name", name);
        put("space", second);
        go_to_value();
        const std::vector<ClaimWord> at = line_.numbers(0, space->coordinates);
        const bool lacks_only_z = space->coordinates == 3 && at.size() == 2;
        if (at.size() != space->coordinates && !lacks_only_z && !at.front().is(open_value))
            line_.fail(line_.peek(), fmt::format("{} numbers in all", space->coordinates));
        put_list("at", at);
        if (space->name == "screen" && line_.take("->"))
            put_list("snapped", line_.numbers(space->coordinates));
    }

    /// Either the space has a typing error, or the word before the name of a face.
    [[noreturn]] void refuse_space(const ClaimWord& first, const ClaimWord& second) const {
        std::vector<std::string_view> names;
        for (const SpaceName& space : space_names)
            names.push_back(space.name);
        const std::string expected = fmt::format("a space ({})", joined(names, ", "));
        const std::string near_space = did_you_mean(second.text, names);
        const std::string near_word = did_you_mean(first.text, first_words());
        line_.fail(second, expected,
                   !near_space.empty()  ? near_space
                   : !near_word.empty() ? near_word
                                        : std::string(forms));
    }
};

} // namespace

std::vector<std::string_view> first_words() {
    std::vector<std::string_view> words{"left",    "right",    "y",       "depth", "edge",  "slope",
                                        "row",     "scanline", "line",    "pixel", "point", "order",
                                        "weights", "matrix",   "picture", "scene", "round"};
    for (const FaceWord& known : face_words)
        words.push_back(known.word);
    return words;
}

void read_claim(ClaimLine& line, Claim& claim) {
    ClaimReader(line, claim).read();
}

void read_cell(ClaimLine& cell, Claim& claim, std::string_view field) {
    ClaimReader(cell, claim).read_cell(field);
}

void read_pixel_cell(ClaimLine& cell, Claim& claim) {
    ClaimReader(cell, claim).read_pixel_cell();
}

std::size_t coordinates_in_space(std::string_view name) {
    const auto* const known =
        std::find_if(space_names.begin(), space_names.end(),
                     [name](const SpaceName& space) { return space.name == name; });
    return known == space_names.end() ? 0 : known->coordinates;
}

std::string_view words_for_field(std::string_view field, Language language) {
    const auto known =
        std::find_if(field_words.begin(), field_words.end(),
                     [field](const FieldWords& words) { return words.field == field; });
    return known == field_words.end() ? field : known->words.in(language);
}

std::string_view Claims::in_words(std::string_view field) const {
    return is_table ? words_for_field(field) : field;
}

} // namespace rastertrace
