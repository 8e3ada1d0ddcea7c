// SPDX-License-Identifier: MIT
#include "claim_forms.h"

#include "claim_fields.h"

#include <rastertrace/trace/record/verdict_words.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
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
constexpr std::array<FaceWord, 8> face_words{{{"normal", "face", "normal", 3},
                                              {"centroid", "face", "centroid", 3},
                                              {"view", "face", "view", 3},
                                              {"plane", "face", "plane", 4},
                                              {"cosine", "face", "cosine", 1},
                                              {"dot", "face", "dot", 1},
                                              {"light", "light", "light", 3},
                                              {"intensity", "light", "intensity", 1}}};

/// The words for true and false that only a table of claims has.
constexpr std::array<VerdictWord, 4> words_of_table{{{"on", "plotted", "true"},
                                                     {"off", "plotted", "false"},
                                                     {"passes", "pass", "true"},
                                                     {"fails", "pass", "false"}}};

/// What fields are called by who has not seen their names, because in a table they have none.
struct FieldWords {
    std::string_view field;
    std::string_view words;
};
constexpr std::array<FieldWords, 14> field_words{{{"left", "left end"},
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
                                                  {"names", "order"}}};

/// The first word for which that holds, those of tables first; or nullptr.
template <typename Holds> const VerdictWord* find_verdict_word(const Holds& holds) {
    const auto own = std::find_if(words_of_table.begin(), words_of_table.end(), holds);
    if (own != words_of_table.end())
        return &*own;
    const auto shared = std::find_if(verdict_words.begin(), verdict_words.end(), holds);
    return shared == verdict_words.end() ? nullptr : &*shared;
}

/// What a word says of a field, or nullptr.
const VerdictWord* find_verdict(const ClaimWord& word, std::string_view field) {
    return find_verdict_word(
        [&](const VerdictWord& known) { return known.field == field && word.is(known.word); });
}

/// Reads the claim of one line. What is wrong is thrown as a Problem.
class ClaimReader {
public:
    ClaimReader(ClaimLine& line, Claim& claim) : line_(line), claim_(claim) {}

    void read() {
        const ClaimWord first = line_.peek();
        const auto face_word =
            std::find_if(face_words.begin(), face_words.end(),
                         [&first](const FaceWord& known) { return first.is(known.word); });
        if (first.is("("))
            read_pixel();
        else if (first.is("depth"))
            read_depth();
        else if (first.is("order"))
            read_order();
        else if (first.is("y") && line_.peek(1).is("="))
            read_row({});
        else if (first.is("edge"))
            read_edge({});
        else if (face_word != face_words.end())
            read_face(*face_word);
        else if (first.is_name())
            read_named(line_.next());
        else
            line_.fail(first, "a claim", std::string(forms));
        line_.expect_end();
    }

private:
    /// What begins with the name of a primitive or a vertex.
    void read_named(const ClaimWord& name) {
        const ClaimWord second = line_.peek();
        if (second.is("y"))
            read_row(name);
        else if (second.is("edge"))
            read_edge(name);
        else if (second.is(":"))
            read_line_or_verdict(name);
        else if (second.is_name())
            read_vertex(name);
        else
            line_.fail(second, fmt::format("what is claimed of {}", name.text), std::string(forms));
    }

    /// [ABC ]y=2: -1/4, 25/8 -> -1..3, or the ends of all spans of a polygon in the row.
    void read_row(const std::optional<ClaimWord>& primitive) {
        begin("scanline", primitive);
        line_.next();
        line_.expect("=", "`=` and the row");
        put("y", line_.next());
        const bool is_depth = line_.take("depth");
        line_.expect(":", "`:`");
        if (is_depth)
            return read_ends("left_depth", "right_depth", line_.next());
        if (!line_.take("->")) {
            if (has_more_ends())
                return read_crossings();
            const ClaimWord first = line_.next();
            if (line_.peek().is(".."))
                return read_pixels_of_row(first);
            read_ends("left", "right", first);
            if (line_.at_end())
                return;
            line_.expect("->", "`->` and the pixels, or the end of the line");
        }
        read_pixels_of_row(line_.next());
    }

    void read_ends(std::string_view left, std::string_view right, const ClaimWord& first) {
        put(left, first);
        line_.expect(",", fmt::format("a comma between {} and {}", left, right));
        put(right, line_.next());
    }

    /// True if more than two ends follow. A comma without a space behind it may be that of a decimal.
    bool has_more_ends() {
        std::size_t commas = 0;
        for (; line_.peek(2 * commas + 1).is(","); ++commas)
            if (line_.peek(2 * commas + 1).offset + 1 == line_.peek(2 * commas + 2).offset)
                return false;
        return commas > 1;
    }

    /// The ends of all spans of a polygon in a row.
    void read_crossings() {
        claim_.step = "crossings";
        std::vector<ClaimWord> ends{line_.next()};
        while (line_.take(","))
            ends.push_back(line_.next());
        put_list("x", ends);
    }

    void read_pixels_of_row(const ClaimWord& from) {
        put("from", from);
        line_.expect("..", "the first and the last pixel, like -1..3");
        put("to", line_.next());
    }

    /// (3,2): on, z 10/3
    void read_pixel() {
        begin("pixel", {});
        read_place();
        if (!line_.peek().is(":"))
            return read_in_primitive(line_.next());
        line_.next();
        if (find_verdict(line_.peek(), "inside"))
            return read_verdict("inside", "inside or outside");
        do
            read_of_pixel(line_.next());
        while (line_.take(","));
    }

    void read_of_pixel(const ClaimWord& word) {
        if (const VerdictWord* const verdict = find_verdict(word, "plotted"))
            return put_value(*verdict, word);
        if (word.is(open_value))
            return put("plotted", word);
        for (const auto& [name, field] :
             {std::pair{"z", "z"}, std::pair{"1/z", "inverse_z"}, std::pair{"color", "color"}})
            if (word.is(name))
                return put(field, line_.next());
        line_.fail(word, "on, off, inside, outside, z, 1/z or color",
                   did_you_mean(word.text, {"on", "off", "inside", "outside", "color"}));
    }

    /// (3,2) ABC: inside
    void read_in_primitive(const ClaimWord& primitive) {
        put("in", primitive);
        line_.expect(":", "`:`");
        read_verdict("inside", "inside or outside");
    }

    /// depth ACD (3,2): 1/3 fails
    void read_depth() {
        line_.next();
        begin("depth", line_.peek().is("(") ? std::nullopt : std::optional(line_.next()));
        read_place();
        line_.expect(":", "`:`");
        if (!find_verdict(line_.peek(), "pass"))
            put("depth", line_.next());
        if (!line_.at_end())
            read_verdict("pass", "passes or fails");
    }

    /// (3,2)
    void read_place() {
        line_.expect("(", "a pixel, like (3,2)");
        put("x", line_.next());
        line_.expect(",", "a comma between x and y");
        put("y", line_.next());
        line_.expect(")", "`)` behind x and y");
    }

    /// order: ABC, ACD
    void read_order() {
        begin("order", {});
        line_.next();
        line_.expect(":", "`:`");
        std::vector<ClaimWord> names;
        do
            names.push_back(line_.next());
        while (line_.take(","));
        put_list("names", names);
    }

    /// [ABC ]edge AB: 3/4
    void read_edge(const std::optional<ClaimWord>& primitive) {
        begin("edge", primitive);
        line_.next();
        put("edge", line_.next());
        line_.expect(":", "`:`");
        put("dx_dy", line_.next());
    }

    /// normal ABC: 0, 0, -4
    void read_face(const FaceWord& about) {
        begin(about.step, {});
        line_.next();
        put("name", line_.next());
        line_.expect(":", "`:`");
        put_list(about.field, numbers(about.numbers));
        if (about.word == "dot" && !line_.at_end())
            read_verdict("culled", "culled or drawn");
    }

    /// AB: -1 3 -3 1 -5, or ABC: culled
    void read_line_or_verdict(const ClaimWord& name) {
        line_.next();
        if (find_verdict(line_.peek(), "culled")) {
            begin("face", {});
            put("name", name);
            return read_verdict("culled", "culled or drawn");
        }
        begin("decide", name);
        std::vector<ClaimWord> values;
        do {
            values.push_back(line_.next());
            line_.take(",");
        } while (!line_.at_end());
        put_list("d", values);
    }

    /// A screen: -10/3, 10/3 -> -4, 3
    void read_vertex(const ClaimWord& name) {
        const ClaimWord second = line_.next();
        const auto space =
            std::find_if(space_names.begin(), space_names.end(),
                         [&second](const SpaceName& known) { return second.is(known.name); });
        if (space == space_names.end())
            refuse_space(name, second);
        begin("vertex", {});
        put("name", name);
        put("space", second);
        line_.expect(":", "`:`");
        put_list("at", numbers(space->coordinates));
        if (space->name == "screen" && line_.take("->"))
            put_list("snapped", numbers(space->coordinates));
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

    /// So many numbers with commas between, or `?` for all of them.
    std::vector<ClaimWord> numbers(std::size_t count) {
        std::vector<ClaimWord> words{line_.next()};
        if (words.front().is(open_value) && !line_.peek().is(","))
            return words;
        while (words.size() < count) {
            line_.expect(",", fmt::format("a comma and {} numbers in all", count));
            words.push_back(line_.next());
        }
        return words;
    }

    void read_verdict(std::string_view field, std::string_view expected) {
        const ClaimWord word = line_.next();
        if (const VerdictWord* const verdict = find_verdict(word, field))
            put_value(*verdict, word);
        else if (word.is(open_value))
            put(field, word);
        else
            line_.fail(word, expected);
    }

    void begin(std::string_view step, const std::optional<ClaimWord>& primitive) {
        claim_.step = step;
        if (primitive)
            put("in", *primitive);
    }

    void put(std::string_view field, const ClaimWord& word) { put_list(field, {word}); }

    void put_value(const VerdictWord& verdict, const ClaimWord& word) {
        put(verdict.field, {.text = std::string(verdict.value), .offset = word.offset});
    }

    void put_list(std::string_view name, const std::vector<ClaimWord>& words) {
        const ClaimField field = field_named(name);
        ClaimedField claimed{.name = std::string(name),
                             .values = {},
                             .is_list = field.is_list,
                             .offset = words.front().offset};
        for (const ClaimWord& word : words) {
            if (word.is_mark || word.text.empty())
                line_.fail(word, fmt::format("a value for {}", name));
            if (const auto expected = expected_instead(field, word.text))
                line_.fail(word, *expected);
            claimed.values.push_back(word.text);
        }
        claim_.fields.push_back(std::move(claimed));
    }

    /// The field of a name; of two with that name, the list. Steps of this table have them all.
    ClaimField field_named(std::string_view name) const {
        ClaimField found;
        for (const ClaimField& field : claim_fields_of(*step_kind_named(claim_.step)))
            if (field.name == name && !found.is_list)
                found = field;
        return found;
    }

    ClaimLine& line_;
    Claim& claim_;
};

} // namespace

std::vector<std::string_view> first_words() {
    std::vector<std::string_view> words{"y", "depth", "edge", "order", "picture", "scene", "round"};
    for (const FaceWord& known : face_words)
        words.push_back(known.word);
    return words;
}

void read_claim(ClaimLine& line, Claim& claim) {
    ClaimReader(line, claim).read();
}

std::string_view words_for_field(std::string_view field) {
    const auto known =
        std::find_if(field_words.begin(), field_words.end(),
                     [field](const FieldWords& words) { return words.field == field; });
    return known == field_words.end() ? field : known->words;
}

std::string_view word_for_value(std::string_view field, std::string_view value) {
    const VerdictWord* const known = find_verdict_word(
        [&](const VerdictWord& word) { return word.field == field && word.value == value; });
    return known == nullptr ? value : known->word;
}

} // namespace rastertrace
