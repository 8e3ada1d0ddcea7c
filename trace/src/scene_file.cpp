// SPDX-License-Identifier: MIT
#include <rastertrace/trace/scene_file.h>

#include "canvas_json.h"
#include "json_document.h"

#include <rastertrace/core/plan.h>
#include <rastertrace/trace/color_text.h>
#include <rastertrace/trace/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace rastertrace {

std::string_view name_separator(std::span<const std::string_view> names) {
    const bool all_short = std::all_of(names.begin(), names.end(), [](std::string_view name) {
        return !name.empty() && first_code_point(name).length == name.size();
    });
    return all_short ? "" : "-";
}

std::string joined_names(std::span<const std::string_view> names) {
    return fmt::format("{}", fmt::join(names, name_separator(names)));
}

namespace {

/// The file name without its folder: the title of a scene that has none.
std::string base_name(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

/// Reads one scene; the first fault ends it.
class SceneReader {
public:
    SceneReader(const Source& source, const MethodOverrides& overrides)
        : source_(source), overrides_(overrides) {}

    Scene read(const JsonValue& root) {
        // The smallest scene has vertices and triangles; everything else has a default.
        allow_keys(root, {"title", "canvas", "vertices", "colors", "triangles", "outlines", "lines",
                          "points", "method"});
        scene_.title = base_name(source_.name);
        if (const JsonValue* title = root.find("title"))
            scene_.title = string_in(*title, "a title in quotes");
        if (const JsonValue* method = root.find("method"))
            read_method(*method);
        apply_overrides();
        if (const JsonValue* vertices = root.find("vertices"))
            read_vertices(*vertices);
        if (const JsonValue* colors = root.find("colors"))
            read_colors(*colors);
        // Drawn in this order: what is thin comes last and stays visible.
        read_primitives(root.find("triangles"), PrimitiveKind::triangle);
        read_primitives(root.find("outlines"), PrimitiveKind::outline);
        read_primitives(root.find("lines"), PrimitiveKind::line);
        read_primitives(root.find("points"), PrimitiveKind::point);
        if (scene_.primitives.empty())
            fail(root, "expected at least one primitive, found none",
                 R"(the smallest scene: {"vertices": {"A": [2, 5], "B": [-4, -3], "C": [5, -3]}, )"
                 R"("triangles": ["ABC"]})");
        read_canvas(root.find("canvas"), root);
        refuse_unfit();
        return std::move(scene_);
    }

private:
    [[noreturn]] void fail(std::size_t offset, std::string message, std::string hint = {}) const {
        throw problem_at(source_, offset, std::move(message), std::move(hint));
    }
    [[noreturn]] void fail(const JsonValue& value, std::string message,
                           std::string hint = {}) const {
        fail(value.begin, std::move(message), std::move(hint));
    }
    [[noreturn]] void fail_expecting(const JsonValue& value, std::string_view expected,
                                     std::string hint = {}) const {
        fail(value, fmt::format("expected {}, found {}", expected, described(value)),
             std::move(hint));
    }

    static std::string did_you_mean(std::string_view word,
                                    const std::vector<std::string_view>& known) {
        const std::string_view nearest = nearest_word(word, known);
        return nearest.empty() ? std::string() : fmt::format("did you mean \"{}\"?", nearest);
    }

    void allow_keys(const JsonValue& value, const std::vector<std::string_view>& known) const {
        if (value.kind != JsonValue::Kind::object)
            fail_expecting(value,
                           "an object with the keys " + fmt::format("{}", fmt::join(known, ", ")));
        for (const JsonValue& key : value.keys)
            if (std::find(known.begin(), known.end(), key.text) == known.end())
                fail_expecting(key, fmt::format("a key out of {}", fmt::join(known, ", ")),
                               did_you_mean(key.text, known));
    }

    const std::string& string_in(const JsonValue& value, std::string_view expected) const {
        if (value.kind != JsonValue::Kind::string || value.text.empty())
            fail_expecting(value, expected);
        return value.text;
    }

    const std::vector<JsonValue>& array_in(const JsonValue& value,
                                           std::string_view expected) const {
        if (value.kind != JsonValue::Kind::array)
            fail_expecting(value, expected);
        return value.items;
    }

    Number number_in(const JsonValue& value) const {
        if (value.kind != JsonValue::Kind::number && value.kind != JsonValue::Kind::string)
            fail_expecting(value, "a number");
        auto parsed = parse_number(value.text);
        if (auto* number = std::get_if<Number>(&parsed))
            return std::move(*number);
        switch (std::get<NumberFault>(parsed)) {
        case NumberFault::zero_denominator:
            fail_expecting(value, "a denominator other than 0");
        case NumberFault::too_large:
            fail_expecting(value, "a number up to 1.797e308");
        case NumberFault::too_small:
            fail_expecting(value, "0 or a number from 4.941e-324 on");
        case NumberFault::malformed:
            break;
        }
        fail_expecting(value, "a number", R"(a fraction is written "25/8", in quotes)");
    }

    void read_method(const JsonValue& method) {
        std::vector<std::string_view> known;
        for (const MethodKey& key : method_keys())
            known.push_back(key.name);
        allow_keys(method, known);
        for (std::size_t i = 0; i < method.keys.size(); ++i) {
            const MethodKey& key = *find_method_key(method.keys[i].text);
            const JsonValue& value = method.items[i];
            const bool is_word = value.kind == JsonValue::Kind::string ||
                                 (value.kind == JsonValue::Kind::number && key.is_number());
            if (!is_word || !key.set(scene_.method, value.text))
                fail_expecting(value, fmt::format("one of {}", fmt::join(key.values, ", ")),
                               did_you_mean(value.text, key.values));
        }
    }

    void apply_overrides() {
        for (const auto& [name, value] : overrides_) {
            const MethodKey* key = find_method_key(name);
            if (key == nullptr || !key->set(scene_.method, value))
                throw problem_of("", fmt::format("--{}: no such choice: {}", name, value));
        }
    }

    void read_vertices(const JsonValue& vertices) {
        if (vertices.kind != JsonValue::Kind::object)
            fail_expecting(vertices, R"(vertices by name, like {"A": [2, 5]})");
        for (std::size_t i = 0; i < vertices.keys.size(); ++i) {
            const JsonValue& name = vertices.keys[i];
            const JsonValue& position = vertices.items[i];
            if (name.text.empty())
                fail_expecting(name, "a name of at least one letter");
            const auto& coordinates = array_in(position, "[x, y]");
            if (coordinates.size() != 2)
                fail_expecting(position, "[x, y]");
            places_of_vertices_.push_back(name.begin);
            vertex_by_name_.emplace(name.text, scene_.vertices.size());
            scene_.vertices.push_back(
                {name.text, number_in(coordinates[0]), number_in(coordinates[1]), std::nullopt});
        }
    }

    std::size_t vertex_named(std::string_view name, std::size_t offset) const {
        const auto found = vertex_by_name_.find(std::string(name));
        if (found != vertex_by_name_.end())
            return found->second;
        std::vector<std::string_view> known;
        for (const SceneVertex& vertex : scene_.vertices)
            known.push_back(vertex.name);
        constexpr std::size_t most_listed = 12;
        const bool too_many = known.size() > most_listed;
        std::string hint = did_you_mean(name, known);
        if (hint.empty() && !known.empty() && !too_many)
            hint = fmt::format("the scene has the vertices {}", fmt::join(known, ", "));
        fail(offset,
             fmt::format("expected the name of a vertex, found \"{}\"", shortened(name, 40)),
             std::move(hint));
    }

    /// What a list of primitives of a kind looks like, and one of them.
    struct Form {
        std::string_view list;
        std::string_view vertices;
    };
    static Form form_of(PrimitiveKind kind) {
        switch (kind) {
        case PrimitiveKind::point:
            return {R"(a list of points, like ["A"])", R"(one vertex, "A" or ["P1"])"};
        case PrimitiveKind::line:
            return {R"(a list of lines, like ["AB"])", R"(two vertices, "AB" or ["P1", "P2"])"};
        case PrimitiveKind::outline:
            return {R"(a list of outlines, like ["ABC"])",
                    R"(three vertices, "ABC" or ["P1", "P2", "P3"])"};
        case PrimitiveKind::triangle:
            break;
        }
        return {R"(a list of triangles, like ["ABC"])",
                R"(three vertices, "ABC" or ["P1", "P2", "P3"])"};
    }

    /// The vertices that "ABC" or ["P1", "P2", "P3"] names.
    void read_corners(const JsonValue& value, ScenePrimitive& primitive) const {
        const std::string_view expected = form_of(primitive.kind).vertices;
        const std::size_t count = primitive.corners().size();
        std::vector<std::size_t> corners;
        if (value.kind == JsonValue::Kind::string) {
            // One-letter names. A place inside the quotes can be pointed at if nothing is escaped.
            if (characters_in(value.text) != count)
                fail_expecting(value, expected);
            const bool as_typed = value.end - value.begin == value.text.size() + 2;
            std::string_view rest = value.text;
            while (!rest.empty()) {
                const std::size_t length = first_code_point(rest).length;
                const std::size_t inside = as_typed ? 1 + value.text.size() - rest.size() : 0;
                corners.push_back(vertex_named(rest.substr(0, length), value.begin + inside));
                rest.remove_prefix(length);
            }
        } else {
            for (const JsonValue& name : array_in(value, expected))
                corners.push_back(
                    vertex_named(string_in(name, "the name of a vertex"), name.begin));
            if (corners.size() != count)
                fail_expecting(value, expected);
        }
        std::copy(corners.begin(), corners.end(), primitive.vertices.begin());
    }

    Color color_in(const JsonValue& value) const {
        constexpr std::string_view expected = R"(a color, like "#ff8000" or "red")";
        const auto color = parse_color(string_in(value, expected));
        if (!color) {
            std::string hint = did_you_mean(value.text, color_names());
            if (value.text.starts_with('#'))
                hint = "8 bits a channel: #rrggbb or #rrggbbaa";
            fail_expecting(value, expected, std::move(hint));
        }
        if (color->alpha() == 0)
            fail_expecting(value, "a color that can be seen (alpha above 00)");
        return *color;
    }

    void read_colors(const JsonValue& colors) {
        if (colors.kind != JsonValue::Kind::object)
            fail_expecting(colors, R"(colors by vertex, like {"A": "red"})");
        for (std::size_t i = 0; i < colors.keys.size(); ++i)
            scene_.vertices[vertex_named(colors.keys[i].text, colors.keys[i].begin)].color =
                color_in(colors.items[i]);
    }

    void read_primitives(const JsonValue* list, PrimitiveKind kind) {
        if (list == nullptr)
            return;
        for (const JsonValue& value : array_in(*list, form_of(kind).list)) {
            ScenePrimitive primitive;
            primitive.kind = kind;
            if (value.kind == JsonValue::Kind::object) {
                allow_keys(value, {"vertices", "name", "color"});
                const JsonValue* vertices = value.find("vertices");
                if (vertices == nullptr)
                    fail(value, R"(expected the key "vertices", found none)");
                read_corners(*vertices, primitive);
                if (const JsonValue* color = value.find("color"))
                    primitive.color = color_in(*color);
                if (const JsonValue* name = value.find("name")) {
                    primitive.name = string_in(*name, "a name in quotes");
                    if (!names_of_primitives_.insert(primitive.name).second)
                        fail_expecting(*name, "a name that no other primitive has");
                }
            } else {
                read_corners(value, primitive);
            }
            if (primitive.name.empty()) {
                std::vector<std::string_view> names;
                for (const std::size_t vertex : primitive.corners())
                    names.push_back(scene_.vertices[vertex].name);
                primitive.name = joined_names(names);
            }
            scene_.primitives.push_back(std::move(primitive));
        }
    }

    void read_canvas(const JsonValue* canvas, const JsonValue& root) {
        CanvasJson given;
        if (canvas != nullptr) {
            auto read = read_canvas_json(source_, *canvas);
            if (!read)
                throw read.problem();
            given = read.value();
        }
        scene_.canvas = {given.width, given.height, given.origin};
        const JsonValue& blamed = canvas != nullptr ? *canvas : root;
        if (!given.has_width)
            scene_.canvas.width = fitted_size(blamed, "width", &SceneVertex::x);
        if (!given.has_height)
            scene_.canvas.height = fitted_size(blamed, "height", &SceneVertex::y);
        if (const auto fault = fault_of_size(scene_.canvas))
            fail(blamed, *fault, R"(say "canvas": {"width": ..., "height": ...})");
    }

    /// The width or height that holds every vertex of a primitive, and a pixel more on each side.
    int fitted_size(const JsonValue& blamed, std::string_view side,
                    Number SceneVertex::*coordinate) const {
        double farthest = 0;
        for (const ScenePrimitive& primitive : scene_.primitives)
            for (const std::size_t vertex : primitive.corners()) {
                const double value = (scene_.vertices[vertex].*coordinate).nearest_double();
                const bool centered = scene_.canvas.origin == Origin::center;
                farthest = std::max(farthest, centered ? std::abs(value) : value);
            }
        const double to_border = std::ceil(farthest) + 1;
        const double size =
            scene_.canvas.origin == Origin::center ? 2 * to_border + 1 : to_border + 1;
        if (size > largest_canvas_side)
            fail(blamed,
                 fmt::format("expected vertices that fit on {0} pixels, or a canvas with a {1}; "
                             "found a vertex {2:.6g} pixels from the origin",
                             largest_canvas_side, side, farthest),
                 R"(say "canvas": {"width": ..., "height": ...})");
        return static_cast<int>(size);
    }

    void refuse_unfit() const {
        const auto unfit = find_unfit(scene_);
        if (!unfit)
            return;
        const SceneVertex& from = scene_.vertices[unfit->from];
        const SceneVertex& to = scene_.vertices[unfit->to];
        const auto at = [](const SceneVertex& vertex) {
            return fmt::format("vertex {} at ({}, {})", vertex.name, vertex.x.nearest_double(),
                               vertex.y.nearest_double());
        };
        const std::size_t place = places_of_vertices_[unfit->to];
        const std::string hint = R"(with "method": {"scalar": "exact"} nothing overflows)";
        using What = Unfit::What;
        switch (unfit->what) {
        case What::coordinate_of_double:
            fail(place,
                 fmt::format("expected coordinates up to 4.49e307 for double, found {}", at(to)),
                 hint);
        case What::coordinate_of_weights:
            fail(place,
                 fmt::format("expected coordinates up to 3.27e150 for weights in double, found {}",
                             at(to)),
                 hint);
        case What::area_of_weights:
            fail(place,
                 fmt::format("expected a triangle whose weights fit in a double, found one from {} "
                             "to {} that is almost without area",
                             at(from), at(to)),
                 hint);
        case What::coordinate_of_fixed:
            fail(place,
                 fmt::format("expected coordinates up to 68719476736 for fixed, found {}", at(to)),
                 hint);
        case What::coordinate_of_line:
            fail(place, fmt::format("expected coordinates up to 2251799813685248 for Bresenham's "
                                    "line, found {}",
                                    at(to)));
        case What::edge_of_fan:
            fail(place,
                 fmt::format("expected edges of at most {} pixels for the fan, which draws a "
                             "line for each, found {} and {}",
                             longest_fan_edge, at(from), at(to)));
        case What::slope_of_double:
            fail(place,
                 fmt::format("expected an edge whose slope dx/dy fits in a double, found {} and {}",
                             at(from), at(to)),
                 hint);
        }
    }

    const Source& source_;
    const MethodOverrides& overrides_;
    Scene scene_;
    std::vector<std::size_t> places_of_vertices_; ///< offsets of their names in the source
    std::unordered_map<std::string, std::size_t> vertex_by_name_;
    std::unordered_set<std::string> names_of_primitives_; ///< those that the author gave
};

} // namespace

Result<Scene> read_scene(const Source& source, const MethodOverrides& overrides) {
    const auto document = parse_json(source);
    if (!document)
        return document.problem();
    try {
        return SceneReader(source, overrides).read(document.value());
    } catch (const Problem& problem) {
        return problem;
    }
}

} // namespace rastertrace
