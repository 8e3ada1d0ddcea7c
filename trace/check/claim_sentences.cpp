// SPDX-License-Identifier: MIT
#include "claim_sentences.h"

#include "claim_builder.h"
#include "typed_number.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

class SentenceReader : ClaimBuilder {
public:
    SentenceReader(ClaimLine& line, Claim& claim, std::string& primitive)
        : ClaimBuilder(line, claim), primitive_(primitive) {}

    SentenceKind read() {
        const auto* const sentence =
            std::find_if(std::begin(sentences), std::end(sentences), [this](const Form& form) {
                return begins_with(form.words) && (!form.is_meant || (this->*form.is_meant)());
            });
        if (sentence == std::end(sentences))
            return SentenceKind::none;
        if (sentence->read == nullptr) {
            line_.skip_rest();
            return SentenceKind::silent;
        }
        (this->*sentence->read)();
        line_.skip_rest(); // how the numbers come of one another
        return SentenceKind::claim;
    }

private:
    static constexpr std::string_view gap = "   "; ///< between a name and what follows
    static constexpr std::array<std::string_view, 6> reasons{"row", "x", "y", "d", "no", "over"};
    static constexpr std::array<std::string_view, 6> primitive_kinds{
        "triangle", "polygon", "outline", "line", "point", "circle"};

    /// A kind of sentence, by the words that it begins with: "" is any one word.
    struct Form {
        std::array<std::string_view, 4> words;
        void (SentenceReader::*read)();                     ///< nullptr of one that claims nothing
        bool (SentenceReader::*is_meant)() const = nullptr; ///< what else must hold
    };
    static const std::array<Form, 25> sentences;

    bool begins_with(const std::array<std::string_view, 4>& words) const {
        for (std::size_t i = 0; i < words.size() && words[i].data() != nullptr; ++i)
            if (words[i].empty() ? !line_.peek(i).is_name() : !line_.peek(i).is(words[i]))
                return false;
        return true;
    }

    bool tells_ends() const { return line_.has("left") && line_.has("right") && line_.has("->"); }
    bool tells_windings() const { return line_.has("winding"); }
    bool tells_slope() const { return line_.has("dx/dy") && (line_.has(";") || line_.has("it")); }
    bool tells_function() const { return line_.has("E") && line_.has("samples"); }
    bool tells_line() const {
        return line_.peek(4).is(line_.peek().is("x") ? "y" : "x") && line_.peek(5).is("=");
    }
    bool tells_pixel() const {
        const ClaimWord behind = line_.peek(6);
        return line_.is_end(6) || behind.text.starts_with('#') ||
               std::any_of(std::begin(reasons), std::end(reasons),
                           [&behind](std::string_view one) { return behind.is(one); });
    }
    bool is_off_canvas() const { return line_.has("canvas"); }
    bool is_primitive() const {
        const bool is_kind =
            std::any_of(std::begin(primitive_kinds), std::end(primitive_kinds),
                        [this](std::string_view kind) { return line_.peek().is(kind); });
        const bool has_corners = line_.has("(") && !line_.peek(2).is(":") && !line_.peek(2).is("=");
        return is_kind && (has_corners || line_.has("clipped") || line_.has("trace"));
    }
    bool tells_octant() const { return line_.has("octant"); }
    bool tells_space() const { return line_.has("space"); }
    bool tells_normal() const { return line_.has("normal") && line_.has("="); }
    bool tells_cut() const { return line_.has("clipped") && line_.has("plane"); }
    bool is_not_drawn() const { return line_.has("dropped") || line_.has("skipped"); }
    bool is_other() const { return line_.has("exact") || line_.has("convex"); }

    /// True of a colon that belongs to a name: wing:1.
    bool is_in_name(std::size_t at) const {
        return line_.peek(at).is(":") && !line_.is_end(at + 1) &&
               line_.peek(at + 1).begin == line_.peek(at).end;
    }

    /// The words to the first of these, or to the end of the line.
    std::size_t words_to(std::initializer_list<std::string_view> ends) const {
        const auto is_one = [&](std::size_t at) {
            return !is_in_name(at) && std::any_of(ends.begin(), ends.end(),
                                                  [&](auto end) { return line_.peek(at).is(end); });
        };
        std::size_t at = 0;
        while (!line_.is_end(at) && !is_one(at))
            ++at;
        return at;
    }

    void go_to(std::initializer_list<std::string_view> words) { line_.skip(words_to(words)); }
    void go_behind(std::string_view word) { line_.skip(words_to({word}) + 1); }

    /// Goes behind the last of the marks before a word; stays if there is none.
    void go_behind_last(std::string_view mark, std::size_t end) {
        std::size_t behind = 0;
        for (std::size_t at = 0; at < end; ++at)
            if (line_.peek(at).is(mark))
                behind = at + 1;
        line_.skip(behind);
    }

    /// What an equation comes to: the number behind its last `=`. Of a number that stands there in two ways, the first: a
    /// long fraction, and then about what it is. One that is shortened stands before that, or before one that it is a
    /// hair away from: 49977918.../10141204... = 4.928204, 79999999.../40000000... < 2
    ClaimWord value(std::initializer_list<std::string_view> ends) {
        return value_in(words_to(ends));
    }
    ClaimWord value_in(std::size_t end) {
        std::size_t from = 0;
        bool is_rounded = false;
        for (std::size_t at = 0; at < end; ++at) {
            const ClaimWord word = line_.peek(at);
            const bool is_beside = word.is("<") || word.is(">");
            const ClaimWord next = line_.peek(at + 1);
            if (is_beside && (next.is("=") || next.is("sample"))) // how an end lies to a sample
                break;
            is_rounded = is_rounded || is_beside || word.is("..");
            const bool is_again =
                word.is("=") && at == from + 1 && !is_rounded && typed_value(line_.peek(from).text);
            if ((word.is("=") || is_beside) && !is_again)
                from = at + 1;
        }
        line_.skip(from);
        const std::size_t left_at_end = line_.left() - std::min(end - from, line_.left());
        ClaimWord number = line_.number({.has_mixed = false});
        line_.skip(line_.left() -
                   std::min(left_at_end, line_.left())); // behind what else is said of it
        if (is_rounded)
            number.text = shortened_number(number.text);
        return number;
    }

    /// A number that was rounded to seven digits, zeros at the end left out: 6e+09 is 6.000000e+09.
    static std::string shortened_number(std::string text) {
        constexpr std::size_t decimals = 6;
        const std::size_t exponent = text.find('e');
        if (exponent != std::string::npos) {
            const std::size_t point = std::min(text.find('.'), exponent);
            const std::size_t written = exponent - point;
            text.insert(exponent,
                        written == 0
                            ? "." + std::string(decimals, '0')
                            : std::string(decimals + 1 - std::min(written, decimals + 1), '0'));
        }
        return "~" + text;
    }

    /// So many words, or one, as one name.
    ClaimWord name_of_words(std::size_t count) {
        ClaimWord name = line_.next();
        for (std::size_t taken = 1; taken < count; ++taken) {
            name.end = line_.next().end;
            name.text = line_.typed(name);
        }
        return name;
    }

    /// A name, which may have blanks in it, up to a mark or a word.
    ClaimWord name_to(std::string_view end) { return name_of_words(words_to({end})); }

    /// A name without blanks in it.
    ClaimWord plain_name() {
        std::size_t count = 1;
        while (is_in_name(count) || (count > 1 && is_in_name(count - 1)))
            ++count;
        return name_of_words(count);
    }

    /// (1/3, 4)
    std::vector<ClaimWord> coordinates() {
        std::vector<ClaimWord> values;
        line_.expect("(", "coordinates in brackets");
        do
            values.push_back(value({",", ")"}));
        while (line_.take(","));
        line_.expect(")", "`)`");
        return values;
    }

    std::optional<ClaimWord> primitive() const {
        return primitive_.empty()
                   ? std::nullopt
                   : std::optional(ClaimWord{.text = primitive_, .offset = line_.peek().offset});
    }

    /// scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> floor -> -1   right AC: ...   depth 1/3 to 1/5
    void read_row() {
        begin("scanline", primitive());
        line_.skip(3);
        put("y", line_.key());
        for (const auto& [side, pixel] : {std::pair("left", "from"), std::pair("right", "to")}) {
            go_behind(side);
            if (line_.peek().is_name() && !line_.peek().is(":"))
                put(std::string(side) + "_edge", name_to(":"));
            put(side, value({"->"}));
            go_behind_last("->", words_to({"right", "depth", "no"}));
            put(pixel, line_.key());
        }
        if (line_.take("depth")) {
            put("left_depth", value({"to"}));
            line_.expect("to", "to");
            put("right_depth", value({"no"}));
        }
    }

    /// row y=8   AB at 1/2, winding 1   BC at 3, winding 0: inside where ...
    void read_crossings() {
        begin("crossings", primitive());
        line_.skip(3);
        put("y", line_.key());
        std::vector<ClaimWord> ends;
        while (!line_.at_end() && !line_.take(":")) {
            go_behind("at");
            ends.push_back(value({","}));
            go_behind("winding");
            line_.next();
        }
        put_list("x", ends);
    }

    /// edge AB: dx/dy = (-4 - 2) / (-3 - 5) = 3/4; x = ...
    void read_edge() {
        begin("edge", primitive());
        line_.next();
        put("edge", name_to(":"));
        if (line_.has("horizontal"))
            put("dx_dy", {.text = std::string(no_slope), .offset = line_.peek().offset});
        else
            put("dx_dy", value({";"}));
    }

    /// side AB: octant 3
    void read_side() {
        begin("edge", primitive());
        line_.next();
        put("edge", name_to(":"));
        go_behind("octant");
        put("octant", line_.key());
    }

    /// x = 3: y = 1/2 x + 0 = 3/2 -> nearest, ties up -> 2
    void read_along() {
        begin("along", primitive());
        const ClaimWord axis = line_.next();
        line_.next();
        put(axis.text, line_.key());
        line_.expect(":", "`:`");
        put("value", value({"->"}));
        go_behind_last("->", words_to({}));
        put("pixel", line_.key());
    }

    /// at (2, 1): d = 3 > 0, diagonally to NE; d - 6 = -3
    void read_decision() {
        begin("decide", primitive());
        line_.next();
        read_place();
        go_behind("=");
        put("d", line_.key());
        claim_.fields.back().is_list = false;
        go_behind("to");
        put("move", line_.next());
    }

    /// sample of (0, 0): (31, 14, 72) / 72: A 3/8 B 31/72 C 7/36: none is negative, inside
    void read_sample() {
        begin("sample", primitive());
        line_.skip(2);
        read_place();
        line_.expect(":", "`:`");
        if (line_.peek().is("("))
            go_behind(":");
        std::vector<ClaimWord> weights;
        while (!line_.at_end() && !line_.take(":")) {
            plain_name();
            weights.push_back(value_in(words_of_weight()));
        }
        put_list("weights", weights);
        go_behind(",");
        read_verdict("inside", "inside or outside");
    }

    /// The words of a weight: to the name before the next one, or to the colon behind the last.
    std::size_t words_of_weight() const {
        const auto is_of_number = [this](std::size_t at) {
            const std::string text = line_.peek(at).text;
            return line_.peek(at).is_mark || text == "<" || text == ">" || text.front() == '/' ||
                   typed_value(text);
        };
        std::size_t at = 1;
        while (!line_.is_end(at) && !line_.peek(at).is(":") && is_of_number(at))
            ++at;
        return at;
    }

    /// depth at (2, -2): 1/5 against 1/3 of ABC: fails (1/z, larger is nearer; z = 5 against 3)
    void read_depth() {
        begin("depth", primitive());
        line_.skip(2);
        read_place();
        line_.expect(":", "`:`");
        put("depth", value({"against"}));
        line_.next();
        if (!line_.take("nothing"))
            put("stored", value({"of", ":"}));
        go_behind(":");
        read_verdict("pass", "passes or fails");
    }

    /// pixel (3, 2) #690000 (step 3 of 5)   row y=2: -1 to 3
    void read_pixel() {
        begin("pixel", primitive());
        line_.next();
        read_place();
        put_value({{}, "plotted", "true"}, line_.peek());
        if (line_.peek().text.starts_with('#'))
            put("color", line_.next());
    }

    /// triangle ABC   A (2, 5)   B (-4, -3)   C (5, -3)
    void read_primitive() {
        begin("primitive", {});
        line_.next();
        std::size_t count = 1;
        while (!line_.is_end(count) && (!line_.peek(count).is(":") || is_in_name(count)) &&
               line_.between(line_.peek(count - 1), line_.peek(count)).size() < gap.size())
            ++count;
        const ClaimWord name = name_of_words(count);
        primitive_ = name.text;
        put("name", name);
        std::vector<ClaimWord> names;
        std::vector<ClaimWord> places;
        while (line_.has("(") && !line_.peek().is(":") && !line_.peek().is("octant") &&
               !line_.peek().is("radius")) {
            names.push_back(name_to("("));
            for (ClaimWord& coordinate : coordinates())
                places.push_back(std::move(coordinate));
            if (line_.peek().text.starts_with('#'))
                line_.next();
        }
        if (names.empty())
            return;
        put_list("vertices", names);
        put_list("at", places);
        if (line_.take("radius"))
            put("radius", line_.key());
    }

    /// vertex A in screen space: (1, 2, 3) / 5 = (1/5, 2/5, 3/5) -> (0, 0)
    void read_vertex() {
        begin("vertex", {});
        line_.next();
        put("name", name_to("in"));
        line_.next();
        put("space", line_.next());
        go_behind(":");
        if (line_.has("/")) { // (1, 2, 3) / 5 = (1/5, 2/5, 3/5)
            while (!line_.at_end() && !(line_.peek().is("=") && line_.peek(1).is("(")))
                line_.next();
            line_.next();
        }
        put_list("at", coordinates());
        if (line_.has("->")) {
            go_behind("->");
            put_list("snapped", coordinates());
        }
    }

    /// ABC: normal (0, 0, -4) . to eye (-1, -1, 3) = -12, with the other vector as this field.
    void read_product(std::string_view other) {
        put("name", name_to(":"));
        go_to({"("});
        put_list("normal", coordinates());
        go_to({"("});
        put_list(other, coordinates());
        line_.expect("=", "`=`");
        put("dot", value({","}));
    }

    /// face ABC: normal (0, 0, -4) . to eye (-1, -1, 3) = -12, cosine -0.9 (154.16 degrees): culled
    void read_face() {
        begin("face", {});
        line_.next();
        read_product("view");
        if (line_.take(",")) {
            line_.next();
            put("cosine", line_.key());
            if (line_.take("("))
                put("angle", line_.number({}));
        }
        go_behind_last(":", words_to({}));
        read_verdict("culled", "culled or drawn");
    }

    /// light on ABC: normal (0, 0, 1) . light (1, 0, 1) = 1, intensity 0.707107, color #b4b4b4 ...
    void read_light() {
        begin("light", {});
        line_.skip(2);
        read_product("light");
        go_behind("intensity");
        put("intensity", value({","}));
        go_behind("color");
        put("color", line_.next());
    }

    /// the painter draws, farthest first: ABC at 4, ACD at 3
    void read_order() {
        begin("order", {});
        go_behind(":");
        std::vector<ClaimWord> names;
        std::vector<ClaimWord> distances;
        do {
            names.push_back(name_to("at"));
            line_.expect("at", "at");
            distances.push_back(value({","}));
        } while (line_.take(","));
        put_list("names", names);
        put_list("distances", distances);
    }

    /// view matrix = rotate x translate:  [1 0 0 0]  [0 1 0 0]  [0 0 1 -4]  [0 0 0 1]
    void read_matrix() {
        begin("matrix", {});
        put("name", line_.next());
        line_.next();
        if (line_.take("of"))
            put("object", name_of_words(words_to({"=", ":"})));
        go_behind(":");
        std::vector<ClaimWord> entries;
        while (line_.take("[")) {
            while (!line_.at_end() && !line_.peek().is("]"))
                entries.push_back(line_.number({.has_mixed = false}));
            line_.expect("]", "`]`");
        }
        put_list("rows", entries);
    }

    /// ABC clipped at the near plane: 2 of 3 vertices inside, 4 left
    void read_clip() {
        begin("clip", {});
        put("name", name_to("clipped"));
        line_.skip(3);
        put("plane", line_.next());
        go_behind(",");
        put("out", line_.key());
    }

    std::string& primitive_;
};

constexpr std::string_view any = "";

const std::array<SentenceReader::Form, 25> SentenceReader::sentences{{
    {{"scanline", "y", "="}, &SentenceReader::read_row, &SentenceReader::tells_ends},
    {{"row", "y", "="}, &SentenceReader::read_crossings, &SentenceReader::tells_windings},
    {{"edge"}, nullptr, &SentenceReader::tells_function},
    {{"edge"}, &SentenceReader::read_edge, &SentenceReader::tells_slope},
    {{"side"}, &SentenceReader::read_side, &SentenceReader::tells_octant},
    {{"x", "=", any, ":"}, &SentenceReader::read_along, &SentenceReader::tells_line},
    {{"y", "=", any, ":"}, &SentenceReader::read_along, &SentenceReader::tells_line},
    {{"at", "("}, &SentenceReader::read_decision},
    {{"sample", "of", "("}, &SentenceReader::read_sample},
    {{"depth", "at", "("}, &SentenceReader::read_depth},
    {{"pixel", "("}, nullptr, &SentenceReader::is_off_canvas},
    {{"pixel", "("}, &SentenceReader::read_pixel, &SentenceReader::tells_pixel},
    {{"vertex"}, &SentenceReader::read_vertex, &SentenceReader::tells_space},
    {{"face"}, &SentenceReader::read_face, &SentenceReader::tells_normal},
    {{"light", "on"}, &SentenceReader::read_light, &SentenceReader::tells_normal},
    {{"the", "painter", "draws"}, &SentenceReader::read_order},
    {{any, "matrix"}, &SentenceReader::read_matrix},
    {{any}, &SentenceReader::read_clip, &SentenceReader::tells_cut},
    {{any, any}, &SentenceReader::read_primitive, &SentenceReader::is_primitive},
    {{any, "half", ":"}, nullptr},
    {{"a", "line", "begins", "at"}, nullptr},
    {{"nothing", "drawn", "yet"}, nullptr},
    {{any}, nullptr, &SentenceReader::is_not_drawn},
    {{"(", any}, nullptr, &SentenceReader::is_not_drawn},
    {{any, any}, nullptr, &SentenceReader::is_other},
}};

} // namespace

SentenceKind read_sentence(ClaimLine& line, Claim& claim, std::string& primitive) {
    return SentenceReader(line, claim, primitive).read();
}

} // namespace rastertrace
