// SPDX-License-Identifier: MIT
#include "claim_forms.h"

#include "claim_builder.h"
#include "claim_comparison.h"
#include "line_equation.h"

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

/// What a line about each kind of step can look like, for who has written another.
struct FormOfStep {
    std::string_view step;
    std::string_view example;
};
constexpr auto forms_of_steps = std::to_array<FormOfStep>({
    {"scanline", "`y=2: -1/4, 25/8 -> -1..3`"},
    {"scanline", "`y=2 depth: 1/3, 1/5`"},
    {"pixel", "`(3,2): on`"},
    {"pixel", "`(3,2): z 10/3`"},
    {"vertex", "`A screen: 2, 5`"},
    {"face", "`normal ABC: 0, 0, -4`"},
    {"face", "`dot ABC: -12 culled`"},
    {"decide", "`AB: -1 3 -3`"},
    {"edge", "`edge AB: 3/4`"},
    {"edge", "`AB: y = 4/3 x + 7/3`"},
    {"depth", "`depth ACD (3,2): fails`"},
    {"order", "`order: ABC, ACD`"},
    {"primitive", "`AB pixels: (0,0) (1,0)`"},
    {"primitive", "`ABC: 9 rows, 49 pixels`"},
    {"along", "`AB x=3: 9/4 -> 2`"},
    {"sample", "`weights (3,2): 5/8, 1/72, 13/36`"},
    {"matrix", "`matrix model: [0 -1 0 0] [1 0 0 0] [0 0 1 0] [0 0 0 1]`"},
    {"picture", "`picture:`"},
});

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
constexpr auto edge_words =
    std::to_array<std::string_view>({"edge", "slope", "dx/dy", "dy/dx", "gradient", "Steigung"});

/// The columns of an edge table, as a line has them.
constexpr auto edge_columns = std::to_array<std::pair<std::string_view, std::string_view>>(
    {{"ymin", "y_min"}, {"ymax", "y_max"}, {"x", "x_start"}, {"1/m", "dx_dy"}, {"dx/dy", "dx_dy"}});

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
                                                        {"length", "length of the normal"},
                                                        {"m", "slope"},
                                                        {"y_min", "ymin"},
                                                        {"y_max", "ymax"},
                                                        {"x_start", "x at ymin"},
                                                        {"place", "pixel"},
                                                        {"place_before", "pixel"},
                                                        {"xy", "point"},
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

    /// The claims of the line, of which there may be several.
    std::vector<Claim> read() {
        try {
            read_line();
            line_.expect_end();
        } catch (Problem& problem) {
            if (problem.hint.empty())
                problem.hint = form_of(claim_.step);
            throw;
        }
        if (places_.empty())
            return {claim_};
        std::vector<Claim> claims(places_.size(), claim_);
        for (std::size_t i = 0; i < claims.size(); ++i)
            claims[i].fields.insert(claims[i].fields.begin(), places_[i].begin(), places_[i].end());
        return claims;
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
    void read_line() {
        line_.leave_out_fillers();
        if ((line_.peek().is("inverse") && line_.peek(1).is("slope")) ||
            (line_.peek().is("x") && line_.peek(1).is("y")))
            line_.next();
        const bool has_kind = line_.peek().is("line") || line_.peek().is("triangle") ||
                              line_.peek().is("vertex") || line_.peek().is("polygon");
        if (has_kind && line_.peek(1).is_name() && !is_row_next())
            line_.next();
        if (line_.peek().text.size() > 2 && line_.peek().is_name() && !line_.peek().is_quoted &&
            (line_.peek().text.starts_with("n_") || line_.peek().text.starts_with("m_")))
            line_.part(1, 1); // n_ABC, m_AB
        const ClaimWord first = line_.peek();
        const ClaimWord second = line_.peek(1);
        const bool is_parted = !line_.at_end() && line_.between(first, second) == "_";
        const bool says_normal = first.is("n") && is_parted;
        const auto* const face_word =
            std::find_if(face_words.begin(), face_words.end(), [&](const FaceWord& known) {
                return first.is(known.word) || (says_normal && known.word == "normal");
            });
        const bool names_pixel =
            (is_one_of(first, pixel_words) && (second.is("(") || is_number(second))) ||
            (first.is("pixels") && second.is("("));
        const bool is_bare_pixel =
            is_number(first) && second.is(",") && is_number(line_.peek(2)) && line_.peek(3).is(":");
        if (const auto line = line_equation(line_.remaining()); line && has_both_axes())
            read_equation({}, *line);
        else if (first.is("(") || names_pixel || is_bare_pixel)
            read_pixel();
        else if (first.is("|"))
            read_length();
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
        else if (is_number(first) && is_one_of(second, counted_words))
            read_counts_of({});
        else if (are_numbers_next())
            read_numbers();
        else if (is_indexed(first) && second.is("=") && is_indexed_list_next())
            read_indexed();
        else if (is_one_of(first, row_sides) && second.is_name())
            read_side(line_.next());
        else if (first.is("m") && (is_parted || (second.is("(") && line_.peek(3).is(")") &&
                                                 !is_number(line_.peek(2)))))
            read_slope_m();
        else if (first.is("m") && second.is("="))
            read_slope_and_constant({});
        else if (is_one_of(first, edge_words))
            read_edge({});
        else if (face_word != face_words.end())
            read_face(*face_word);
        else if (first.is_name())
            read_named(line_.next());
        else
            line_.fail(first, "a claim", form_of(""));
    }

    bool has_both_axes() const {
        const std::string_view rest = line_.remaining();
        return rest.find('x') != std::string_view::npos && rest.find('y') != std::string_view::npos;
    }

    /// True of 2, -4, 6: three numbers, or dots behind fewer.
    bool are_numbers_next() const {
        std::size_t numbers = 0;
        for (std::size_t i = 0; !line_.is_end(i); ++i) {
            if (line_.peek(i).is("..") && line_.is_end(i + 1))
                return numbers > 0;
            if (!is_number(line_.peek(i)) && !line_.peek(i).is(","))
                return false;
            numbers += is_number(line_.peek(i)) ? 1 : 0;
        }
        return numbers > 2;
    }

    /// d of the only line.
    void read_numbers() {
        begin("decide", {});
        put_list("d", line_.numbers(0));
    }

    /// True of d0 and p_1.
    static bool is_indexed(const ClaimWord& word) { return index_of(word).has_value(); }

    static std::optional<std::size_t> index_of(const ClaimWord& word) {
        std::string_view text = word.text;
        if (word.is_quoted || (!text.starts_with('d') && !text.starts_with('p')))
            return std::nullopt;
        text.remove_prefix(text.size() > 1 && text[1] == '_' ? 2 : 1);
        constexpr std::size_t most_digits = 5;
        if (text.empty() || text.size() > most_digits ||
            text.find_first_not_of("0123456789") != std::string_view::npos)
            return std::nullopt;
        return std::stoul(std::string(text));
    }

    /// True of d0 = 2, d1 = -4: each number has its name.
    bool is_indexed_list_next() const {
        for (std::size_t i = 0; !line_.is_end(i); i += 4)
            if (!is_indexed(line_.peek(i)) || !line_.peek(i + 1).is("=") ||
                (!line_.is_end(i + 3) && !line_.peek(i + 3).is(",") && !line_.peek(i + 3).is(";")))
                return false;
        return true;
    }

    void read_indexed() {
        begin("decide", {});
        std::vector<ClaimWord> all;
        do {
            const ClaimWord name = line_.next();
            line_.next();
            const std::size_t index = *index_of(name);
            if (index >= most_words)
                line_.fail(name, "a smaller index");
            while (all.size() <= index)
                all.push_back({.text = std::string(open_value), .offset = name.offset});
            all[index] = line_.one_number();
        } while (line_.take(",") || line_.take(";"));
        put_list("d", all);
        claim_.fields.back().goes_on = true; // only these are claimed
    }

    /// |n| = sqrt(76), |normal ABC| = 9
    void read_length() {
        begin("face", {});
        line_.next();
        if (line_.peek().text.starts_with("n_"))
            line_.part(1, 1);
        if (!line_.take("n"))
            line_.take("normal");
        if (!line_.peek().is("|"))
            put("name", line_.next());
        line_.expect("|", "`|` behind the normal");
        go_to_value();
        put("length", line_.one_number());
    }

    /// m(AB) = 3/4, m_AB = 3/4
    void read_slope_m() {
        begin("edge", {});
        line_.next();
        const bool has_brackets = line_.take("(");
        put("edge", line_.next());
        if (has_brackets)
            line_.expect(")", "`)` behind the edge");
        go_to_value();
        put("m", line_.one_number());
    }

    /// y = 4/3 x + 7/3, on the line or the edge of that name
    void read_equation(const std::optional<ClaimWord>& name, const LineEquation& line) {
        begin("edge", {});
        if (name)
            put("edge", *name);
        const std::size_t offset = line_.peek().offset;
        line_.skip(most_words);
        put_list(line.is_of_y ? "x_form" : "y_form",
                 {{.text = line.m, .offset = offset}, {.text = line.b, .offset = offset}});
    }

    /// Goes behind a word that says that a row has no pixels.
    bool take_no_pixels() {
        if (line_.take("none") || line_.take("empty") || line_.take("no", "pixels"))
            return true;
        return line_.is_end(1) && line_.take("-");
    }

    void put_no_pixels(const ClaimWord& at) {
        put("pixel_count", {.text = "0", .offset = at.offset});
    }

    void read_field(const ClaimField& field) {
        const bool is_number = field.type == FieldType::quantity || field.type == FieldType::whole;
        if (is_number && field.is_list)
            put_list(field.name, line_.numbers(0));
        else if (is_number)
            put(field.name, line_.one_number());
        else if (field.type == FieldType::boolean &&
                 (line_.peek().is("true") || line_.peek().is("false")))
            put(field.name, line_.next());
        else if (field.type == FieldType::boolean)
            read_verdict(field.name, field.name == "culled" ? "culled or drawn" : "on or off");
        else if (field.is_list)
            put_list(field.name, names_in_brackets());
        else
            put(field.name, line_.next());
    }

    /// (AB, CD), as `show` prints a list of names
    std::vector<ClaimWord> names_in_brackets() {
        line_.expect("(", "`(`");
        std::vector<ClaimWord> names;
        do
            names.push_back(line_.next());
        while (line_.take(","));
        line_.expect(")", "`)`");
        return names;
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
        else if (second.is("->") || second.is("projected"))
            read_image(name);
        else if (second.is(":") || is_verdict_alone(second) || second.is("=") || second.is("("))
            read_of_name(name);
        else if (second.is_name())
            read_vertex(name);
        else
            line_.fail(second, fmt::format("what is claimed of {}", name.text), form_of(""));
    }

    /// True of drawn, behind a name alone.
    bool is_verdict_alone(const ClaimWord& word) const {
        return line_.is_end(1) && (find_verdict(word, "culled") != nullptr ||
                                   find_verdict(word, "visible") != nullptr);
    }

    /// A -> (10, 0), A projected: 10, 0, which is A' = (10, 0)
    void read_image(ClaimWord name) {
        if (line_.next().is("projected") && !line_.take("="))
            line_.take(":");
        name.text += '\'';
        begin("decide", name);
        put_list("d", line_.numbers(0));
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
        const ClaimWord before = line_.peek();
        if (take_no_pixels())
            return put_no_pixels(before);
        if (line_.peek(1).is("<=")) { // -1/4 <= x <= 25/8
            const ClaimWord left = line_.one_number();
            line_.next();
            if (!line_.take("x") || !line_.take("<="))
                line_.fail(line_.peek(), "`x <=` between the ends");
            return put_ends("left", "right", {left, line_.one_number()});
        }
        // x from -1/4 to 25/8 and x = [-1/4, 25/8] are the ends, -1 to 3 the pixels.
        if (line_.peek(1).is("from"))
            line_.take("x");
        const bool is_interval = line_.peek(2).is("[") && line_.take("x", "=");
        const bool says_x = is_interval || line_.peek().is("from") || line_.peek(1).is("=");
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
        const bool has_unit = ends.size() == 1 && line_.typed(ends.front()).ends_with("px");
        if (ends.size() == 1 && line_.at_end() &&
            (counts_pixels(ends.front()) || (has_unit && side.empty() && is_whole(ends.front()))))
            return put("pixel_count", ends.front());
        if (ends.size() == 1 && !side.empty())
            return put(side, ends.front());
        if (ends.size() == 1 && primitive) { // of a line that is longer in y
            claim_.step = "along";
            return put_along(ends.front());
        }
        if (ends.size() == 1)
            line_.fail(line_.peek(), "a comma between left and right");
        if (ends.size() == 4 && is_whole(ends[2]) && is_whole(ends[3]) &&
            are_apart_by_dots({ends[2], ends[3]}) && !are_apart_by_dots({ends[1], ends[2]})) {
            put_ends("left", "right", {ends[0], ends[1]}); // -1/4, 25/8; -1..3
            return put_ends("from", "to", {ends[2], ends[3]});
        }
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
        const ClaimWord first = line_.peek();
        if (take_no_pixels())
            return put_no_pixels(first);
        line_.take("x", "=");
        std::vector<ClaimWord> pixels = line_.numbers(0);
        if (counts_pixels(pixels.back())) { // -1..3, 5 pixels
            put("pixel_count", pixels.back());
            pixels.pop_back();
        }
        if (pixels.empty())
            return;
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
        if (is_one_of(line_.peek(), pixel_words) || line_.peek().is("pixels"))
            line_.next();
        if (are_points_next())
            return read_several_pixels();
        read_place();
        if (line_.peek().is_name() && !is_of_pixel(line_.peek()) && line_.peek(1).is(":"))
            return read_in_primitive(line_.next());
        if (!line_.take(":"))
            line_.take("=");
        if (find_verdict(line_.peek(), "inside"))
            return read_verdict("inside", "inside or outside");
        if (const VerdictWord* const verdict = find_verdict(line_.peek(1), "inside");
            verdict != nullptr && line_.take("not")) // is not inside
            return put_value({{}, "inside", verdict->value == "true" ? "false" : "true"},
                             line_.next());
        do
            read_of_pixel(line_.next());
        while (line_.take(","));
    }

    /// (1,2) -> (2,3) -> (3,3), the pixels of the only line; or (3,2), (2,2): on, a claim for each.
    void read_several_pixels() {
        const std::vector<ClaimWord> all = points();
        if (line_.at_end()) {
            begin("primitive", {});
            return put_list("pixels", all);
        }
        for (std::size_t i = 0; i + 1 < all.size(); i += 2) {
            put("x", all[i]);
            put("y", all[i + 1]);
            places_.push_back(std::exchange(claim_.fields, {}));
        }
        line_.take(":");
        read_of_pixel(line_.next());
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
        if (!expected_instead(field_named("color"), word.text) && !word.is_mark)
            return put("color", word);
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

    void read_points() { put_list("pixels", points()); }

    /// x and y of each pixel.
    std::vector<ClaimWord> points() {
        std::vector<ClaimWord> coordinates;
        do {
            for (ClaimWord& coordinate : point())
                coordinates.push_back(std::move(coordinate));
            if (!line_.take(",") && !line_.take(";"))
                line_.take("->");
        } while (line_.peek().is("("));
        line_.take_last_dots();
        return coordinates;
    }

    /// 9 rows, 50 pixels, of the only primitive if none is named
    void read_counts_of(const std::optional<ClaimWord>& name) {
        begin("primitive", {});
        if (name)
            put("name", *name);
        do {
            const ClaimWord number = line_.one_number();
            const bool are_rows = line_.take("rows") || line_.take("row");
            if (!are_rows && !counts_pixels(number))
                line_.fail(line_.peek(), "rows or pixels");
            put(are_rows ? "row_count" : "pixel_count", number);
        } while (line_.take(",") || line_.take("and"));
    }

    /// order: ABC, ACD
    void read_order() {
        begin("order", {});
        line_.next();
        line_.expect(":", "`:`");
        std::vector<ClaimWord> names;
        do
            names.push_back(line_.next());
        while (line_.take(",") || line_.take("->") || line_.peek().is_name());
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
            const auto row = line_.numbers(4, 0, false);
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
        const bool is_of_x = line_.next().is("dy/dx");
        const ClaimWord name = line_.next();
        const bool says_slope = line_.take("dx/dy"); // edge AB dx/dy 3/4
        if (!line_.take("=") && !line_.take(":") && !says_slope)
            line_.expect(":", "`:`");
        if (const auto line = line_equation(line_.remaining()))
            return read_equation(name, *line);
        if (is_edge_column_next())
            return read_edge_row(name);
        put("edge", name);
        if (is_of_x)
            return put_slope_in_x();
        line_.take("dx/dy", "=");
        read_slope();
    }

    /// AB slope 3/4, AB: dx/dy = 3/4
    void read_slope_of(const ClaimWord& edge) {
        begin("edge", {});
        put("edge", edge);
        const bool is_of_x = line_.next().is("dy/dx");
        if (!line_.take("="))
            line_.take(":");
        is_of_x ? put_slope_in_x() : read_slope();
    }

    /// dy/dx, which is m of y = m x + b
    void put_slope_in_x() {
        const ClaimWord m = line_.one_number();
        put_list("y_form", {m, {.text = std::string(open_value), .offset = m.offset}});
    }

    /// True of ymax 5, x = 3/4.
    bool is_edge_column_next() const {
        return edge_column(line_.peek()) != edge_columns.end() &&
               (is_number(line_.peek(1)) || line_.peek(1).is("=") ||
                line_.peek(1).is(open_value)) &&
               (line_.has("ymin") || line_.has("ymax"));
    }

    static const std::pair<std::string_view, std::string_view>* edge_column(const ClaimWord& word) {
        return std::find_if(edge_columns.begin(), edge_columns.end(),
                            [&word](const auto& column) { return word.is(column.first); });
    }

    /// edge AB: ymin 1, ymax 7, x 1, 1/m 0, as the edge table has it
    void read_edge_row(const ClaimWord& edge) {
        begin("edge", {});
        put("edge", edge);
        do {
            const ClaimWord word = line_.next();
            const auto* const column = edge_column(word);
            if (column == edge_columns.end())
                line_.fail(word, "ymin, ymax, x or 1/m");
            line_.take("=");
            put(column->second, line_.one_number());
        } while (line_.take(",") || line_.take(";") ||
                 edge_column(line_.peek()) != edge_columns.end());
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
        if (about.word == "dot")
            line_.take(",");
        if (about.word == "dot" && !line_.at_end())
            read_verdict("culled", "culled or drawn");
    }

    /// AB: -1 3 -3 1 -5, or ABC: culled. What AB is says whether it is Bresenham's d, a slope or a vertex (check.cpp).
    void read_of_name(const ClaimWord& name) {
        if (!line_.take(":")) // A = (2, 5), A(2, 5)
            line_.take("=");
        if (const auto line = line_equation(line_.remaining()))
            return read_equation(name, *line);
        if (is_edge_column_next())
            return read_edge_row(name);
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
        if (line_.has("rows") || line_.has("pixels"))
            return read_counts_of(name);
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
    void read_slope_and_constant(const std::optional<ClaimWord>& name) {
        begin("edge", {});
        if (name)
            put("edge", *name);
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
                                        : form_of(""));
    }

    std::vector<std::vector<ClaimedField>>
        places_; ///< x and y, of each pixel that the line claims the same of
};

} // namespace

std::string form_of(std::string_view step) {
    std::vector<std::string_view> examples;
    for (const FormOfStep& form : forms_of_steps)
        if (step.empty() || form.step == step)
            examples.push_back(form.example);
    return examples.empty() ? form_of("") : "a line looks like " + joined(examples, ", ");
}

std::vector<std::string_view> first_words() {
    std::vector<std::string_view> words{"left",    "right",    "y",       "depth", "edge",  "slope",
                                        "row",     "scanline", "line",    "pixel", "point", "order",
                                        "weights", "matrix",   "picture", "scene", "round"};
    for (const FaceWord& known : face_words)
        words.push_back(known.word);
    return words;
}

std::vector<Claim> read_claim(ClaimLine& line, Claim claim) {
    return ClaimReader(line, claim).read();
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
