// SPDX-License-Identifier: MIT
#include "svg_text.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/core/numbers/rational.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/fill_edge_table.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/number_word.h>
#include <rastertrace/trace/text/text.h>

#include <expat.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

namespace {

constexpr std::string_view xml_blanks = " \t\r\n";

/// An attribute, and where its value stands in the file.
struct Attribute {
    std::string_view name;
    std::string_view value;
    std::size_t offset;
};

/// What a group hands down to what is in it.
struct Style {
    std::optional<Color> fill = Color(0, 0, 0);
    std::optional<Color> stroke;
    std::optional<FillRule> rule; ///< non-zero, if nothing is said
};

struct Point {
    Rational x;
    Rational y;
};

/// A filled shape, or a line of two points.
struct Shape {
    std::vector<Point> points;
    Color color;
};

constexpr std::array<std::string_view, 6> shapes_and_groups{"svg",      "g",    "polygon",
                                                            "polyline", "rect", "line"};
constexpr std::array<std::string_view, 3> silent{"title", "desc", "metadata"};

class SvgReader {
public:
    explicit SvgReader(const Source& source) : source_(source) {}

    /// The scene, as JSON.
    std::string read() {
        const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(
            XML_ParserCreate(nullptr), &XML_ParserFree);
        parser_ = parser.get();
        XML_SetUserData(parser_, this);
        XML_SetElementHandler(parser_, on<&SvgReader::begin_element>, on<&SvgReader::end_element>);
        XML_SetEntityDeclHandler(parser_, on<&SvgReader::entity>);
        const std::string_view text = source_.view();
        for (std::size_t at = 0; at <= text.size() && !problem_;) { // expat counts in int
            const std::size_t size = std::min<std::size_t>(text.size() - at, 1U << 20);
            const bool is_last = at + size == text.size();
            const auto status = XML_Parse(parser_, text.data() + at, static_cast<int>(size),
                                          static_cast<int>(is_last));
            if (status == XML_STATUS_ERROR && !problem_)
                problem_ = problem_at(source_, place(),
                                      fmt::format("expected well-formed XML, found: {}",
                                                  XML_ErrorString(XML_GetErrorCode(parser_))));
            at += size + (is_last ? 1 : 0);
        }
        if (problem_)
            throw *std::move(problem_);
        if (fills_.empty() && lines_.empty())
            throw problem_at(source_, text.size(),
                             "expected a polygon, polyline, rect or line, found none");
        return json();
    }

private:
    /// A handler of expat: problems do not pass through C.
    template <auto member, typename... Arguments> static void on(void* reader, Arguments... given) {
        auto& self = *static_cast<SvgReader*>(reader);
        if (self.problem_)
            return;
        try {
            (self.*member)(given...);
        } catch (Problem& problem) {
            self.problem_ = std::move(problem);
            XML_StopParser(self.parser_, XML_FALSE);
        }
    }

    std::size_t place() const {
        const XML_Index index = XML_GetCurrentByteIndex(parser_);
        return std::min(static_cast<std::size_t>(std::max<XML_Index>(index, 0)),
                        source_.view().size());
    }

    [[noreturn]] void fail(std::size_t offset, std::string message, std::string hint = {}) const {
        throw problem_at(source_, offset, std::move(message), std::move(hint));
    }
    [[noreturn]] void fail_at(const Attribute& attribute, std::string_view expected) const {
        fail(attribute.offset, fmt::format("expected {}, found \"{}\"", expected,
                                           shortened(printable(attribute.value), 40)));
    }

    void entity(const XML_Char*, int, const XML_Char*, int, const XML_Char*, const XML_Char*,
                const XML_Char*, const XML_Char*) {
        fail(place(), "expected no entities, found one");
    }

    /// The attributes of the element at hand; values are looked up in its text.
    std::vector<Attribute> attributes_of(const XML_Char** given) const {
        const std::size_t begin = place();
        const auto size = static_cast<std::size_t>(XML_GetCurrentByteCount(parser_));
        const std::string_view element = source_.view().substr(begin, size);
        std::vector<Attribute> attributes;
        for (; *given != nullptr; given += 2) {
            const std::string_view name = given[0];
            std::size_t at = element.find(name);
            while (at != std::string_view::npos &&
                   (xml_blanks.find(element[at - 1]) == std::string_view::npos ||
                    element.find_first_not_of("= \t\r\n", at + name.size()) == at + name.size()))
                at = element.find(name, at + 1);
            const std::size_t quote = element.find_first_of("\"'", at);
            attributes.push_back({name, given[1], quote < size ? begin + quote + 1 : begin});
        }
        return attributes;
    }

    void begin_element(const XML_Char* given_name, const XML_Char** given) {
        const std::string_view name = given_name;
        const bool is_foreign = name.find(':') != std::string_view::npos;
        if (silent_ > 0 || is_foreign ||
            std::find(silent.begin(), silent.end(), name) != silent.end()) {
            ++silent_;
            return;
        }
        if (std::find(shapes_and_groups.begin(), shapes_and_groups.end(), name) ==
                shapes_and_groups.end() ||
            (name == "svg") != styles_.empty())
            fail(place(),
                 fmt::format("expected an element out of svg, which contains all, {}, found \"{}\"",
                             joined(std::span(shapes_and_groups).subspan(1), ", "),
                             shortened(printable(name), 40)));
        const auto attributes = attributes_of(given);
        styles_.push_back(style_of(attributes));
        if (name == "svg")
            set_canvas(attributes);
        else if (name == "line")
            add_stroke({at(attributes, "x1", "y1"), at(attributes, "x2", "y2")}, false);
        else if (name == "rect")
            add_shape(corners_of_rect(attributes), true);
        else if (name != "g")
            add_shape(points_of(attributes), name == "polygon");
    }

    void end_element(const XML_Char*) {
        if (silent_ > 0)
            --silent_;
        else
            styles_.pop_back();
    }

    Style style_of(const std::vector<Attribute>& attributes) const {
        Style style = styles_.empty() ? Style{} : styles_.back();
        for (const Attribute& attribute : attributes) {
            if (attribute.name != "style") {
                set_style(style, attribute);
                continue;
            }
            for (std::size_t at = 0; at < attribute.value.size();) {
                const std::size_t end =
                    std::min(attribute.value.find(';', at), attribute.value.size());
                const std::string_view one = attribute.value.substr(at, end - at);
                const std::size_t colon = std::min(one.find(':'), one.size());
                const std::string_view value = trimmed(one.substr(std::min(colon + 1, one.size())));
                set_style(style, {trimmed(one.substr(0, colon)), value, attribute.offset + at});
                at = end + 1;
            }
        }
        return style;
    }

    static std::string_view trimmed(std::string_view text) {
        text.remove_prefix(std::min(text.find_first_not_of(xml_blanks), text.size()));
        return text.substr(0, text.find_last_not_of(xml_blanks) + 1);
    }

    void set_style(Style& style, const Attribute& attribute) const {
        const auto& [name, value, offset] = attribute;
        if (name == "fill" || name == "stroke") {
            const auto color = parse_color(value);
            if (!color && value != "none")
                fail_at(attribute, "none, a color like #f00, or a name of CSS 2.1");
            (name == "fill" ? style.fill : style.stroke) = color;
        } else if (name == "fill-rule") {
            if (value != "nonzero" && value != "evenodd")
                fail_at(attribute, "nonzero or evenodd");
            style.rule = value == "evenodd" ? FillRule::even_odd : FillRule::non_zero;
        } else if (name == "transform") {
            fail_at(attribute, "coordinates without a transform");
        } else if (name.ends_with("opacity")) {
            if (number(attribute, value) != 1)
                fail_at(attribute, "opaque colors, an opacity of 1");
        } else if (name == "rx" || name == "ry") {
            if (number(attribute, value) != 0)
                fail_at(attribute, "a rect without round corners");
        }
    }

    Rational number(const Attribute& attribute, std::string_view word) const {
        if (word.ends_with("px"))
            word.remove_suffix(2);
        const auto usual = usual_form(word);
        const auto number = parse_number(usual.value_or(std::string()));
        const auto* const value = std::get_if<Number>(&number);
        if (value == nullptr) {
            const auto in_value = static_cast<std::size_t>(word.data() - attribute.value.data());
            fail(attribute.offset + in_value,
                 fmt::format("expected a number, found \"{}\"", shortened(printable(word), 40)));
        }
        return value->exact();
    }

    /// Numbers with xml_blanks, commas or only signs between.
    std::vector<Rational> numbers(const Attribute& attribute) const {
        std::vector<Rational> found;
        constexpr std::string_view separators = ", \t\r\n";
        const std::string_view text = attribute.value;
        for (std::size_t at = text.find_first_not_of(separators); at != std::string_view::npos;) {
            std::size_t end = at + 1;
            while (end < text.size() && separators.find(text[end]) == std::string_view::npos &&
                   !((text[end] == '-' || text[end] == '+') && text[end - 1] != 'e' &&
                     text[end - 1] != 'E'))
                ++end;
            found.push_back(number(attribute, text.substr(at, end - at)));
            at = text.find_first_not_of(separators, end);
        }
        return found;
    }

    static const Attribute* find(const std::vector<Attribute>& attributes, std::string_view name) {
        for (const Attribute& attribute : attributes)
            if (attribute.name == name)
                return &attribute;
        return nullptr;
    }

    Rational length(const std::vector<Attribute>& attributes, std::string_view name) const {
        const Attribute* const found = find(attributes, name);
        return found == nullptr ? Rational(0) : number(*found, found->value);
    }

    Point at(const std::vector<Attribute>& attributes, std::string_view x,
             std::string_view y) const {
        return {length(attributes, x), length(attributes, y)};
    }

    std::vector<Point> corners_of_rect(const std::vector<Attribute>& attributes) const {
        const auto [x, y] = at(attributes, "x", "y");
        const auto [width, height] = at(attributes, "width", "height");
        return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    }

    std::vector<Point> points_of(const std::vector<Attribute>& attributes) const {
        const Attribute* const points = find(attributes, "points");
        if (points == nullptr)
            return {};
        const auto all = numbers(*points);
        if (all.size() % 2 != 0)
            fail(points->offset, fmt::format("expected an x and a y for each point, found {}",
                                             counted(all.size(), "number")));
        std::vector<Point> found;
        for (std::size_t i = 0; i < all.size(); i += 2)
            found.push_back({all[i], all[i + 1]});
        if (found.size() > most_corners)
            fail(points->offset,
                 fmt::format("expected at most {} points, found {}", most_corners, found.size()));
        return found;
    }

    /// `viewBox` says what is seen, or else `width` and `height`.
    void set_canvas(const std::vector<Attribute>& attributes) {
        const Attribute* const box = find(attributes, "viewBox");
        if (box != nullptr) {
            const auto seen = numbers(*box);
            if (seen.size() != 4)
                fail_at(*box, "a viewBox of four numbers");
            corner_ = {seen[0], seen[1]};
            width_ = side(*box, seen[2]);
            height_ = side(*box, seen[3]);
            return;
        }
        const Attribute* const width = find(attributes, "width");
        const Attribute* const height = find(attributes, "height");
        if (width == nullptr || height == nullptr)
            fail(place(), "expected a viewBox, or width and height, found none");
        width_ = side(*width, number(*width, width->value));
        height_ = side(*height, number(*height, height->value));
    }

    Index side(const Attribute& attribute, const Rational& length) const {
        if (length <= 0 || length > largest_canvas_side)
            fail_at(attribute, fmt::format("sides above 0, of at most {}", largest_canvas_side));
        return ceil_index(length);
    }

    void add_shape(const std::vector<Point>& points, bool is_closed) {
        const Style& style = styles_.back();
        if (style.fill && points.size() >= 3) {
            const FillRule rule = style.rule.value_or(FillRule::non_zero);
            if (points.size() > 3 && rule_.value_or(rule) != rule)
                fail(place(), "expected one fill-rule for all polygons, found both");
            if (points.size() > 3)
                rule_ = rule;
            fills_.push_back({points, *style.fill});
        }
        add_stroke(points, is_closed);
    }

    void add_stroke(const std::vector<Point>& points, bool is_closed) {
        const auto& stroke = styles_.back().stroke;
        const std::size_t ends = points.size() - (is_closed || points.empty() ? 0 : 1);
        for (std::size_t i = 0; stroke && i < ends; ++i)
            lines_.push_back({{points[i], points[(i + 1) % points.size()]}, *stroke});
    }

    /// Triangles can have edge functions; beside polygons they are polygons, too.
    std::string json() const {
        const bool has_polygons = std::any_of(fills_.begin(), fills_.end(), [](const Shape& shape) {
            return shape.points.size() > 3;
        });
        std::string vertices;
        std::size_t count = 0;
        const auto list_of = [&](std::string_view key, const std::vector<Shape>& shapes) {
            std::string list;
            for (const Shape& shape : shapes) {
                std::string names;
                for (const Point& p : shape.points) {
                    vertices += fmt::format(R"({}"{}":["{}","{}"])", count == 0 ? "\n" : ",\n",
                                            count + 1, Rational(p.x - corner_.x).get_str(),
                                            Rational(p.y - corner_.y).get_str());
                    names += fmt::format(R"({}"{}")", names.empty() ? "" : ",", ++count);
                }
                list += fmt::format(R"({}{{"vertices":[{}],"color":"{}"}})",
                                    list.empty() ? "\n" : ",\n", names, to_text(shape.color));
            }
            return list.empty() ? std::string() : fmt::format(",\n\"{}\":[{}]", key, list);
        };
        std::string lists = list_of(has_polygons ? "polygons" : "triangles", fills_);
        lists += list_of("lines", lines_);
        std::string method = R"("sample":"center")";
        if (has_polygons)
            method += fmt::format(R"(,"rounding":"half-open","fill_rule":"{}")",
                                  rule_ == FillRule::even_odd ? "even-odd" : "non-zero");
        else if (!fills_.empty())
            method += R"(,"fill":"top-left")";
        return fmt::format(R"({{"canvas":{{"width":{},"height":{},"origin":"top-left"}},)"
                           "\n\"vertices\":{{{}}}{},\n\"method\":{{{}}}}}\n",
                           width_, height_, vertices, lists, method);
    }

    const Source& source_;
    XML_Parser parser_ = nullptr;
    std::optional<Problem> problem_;
    std::vector<Style> styles_; ///< of the elements around
    std::size_t silent_ = 0;    ///< elements around in which nothing is drawn
    Index width_ = 1;
    Index height_ = 1;
    Point corner_;
    std::vector<Shape> fills_;
    std::vector<Shape> lines_;
    std::optional<FillRule> rule_; ///< of polygons
};

} // namespace

Result<Source> scene_of_svg(const Source& source) {
    try {
        return Source{source.name + " as a scene", SvgReader(source).read(), {}};
    } catch (const Problem& problem) {
        return problem;
    }
}

} // namespace rastertrace
