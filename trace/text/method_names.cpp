// SPDX-License-Identifier: MIT
#include "method_names.h"

#include "conventions.h"
#include "text.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/core/draw/scene/scene.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace rastertrace {

namespace {

template <typename Enum> struct Word {
    Enum value;
    std::string_view word;
};
template <typename Enum> Word(Enum, std::string_view) -> Word<Enum>;

/// The names that stand in the rows of algorithms.
template <typename Enum, std::size_t count>
constexpr std::array<Word<Enum>, count> words_of(const std::array<Enum, count>& all) {
    std::array<Word<Enum>, count> words{};
    for (std::size_t i = 0; i < count; ++i)
        words[i] = {all[i], traits_of(all[i]).name};
    return words;
}
constexpr auto lines = words_of(all_lines);
constexpr auto fills = words_of(all_fills);

constexpr std::array scalars{
    Word{ScalarKind::single_precision, "float"}, Word{ScalarKind::double_precision, "double"},
    Word{ScalarKind::fixed, "fixed"}, Word{ScalarKind::adaptive, "adaptive"},
    Word{ScalarKind::exact, "exact"}};
constexpr std::array starts{Word{LineStart::first, "first"}, Word{LineStart::low, "low"}};
constexpr std::array end_pixels{Word{EndPixels::both, "both"}, Word{EndPixels::first, "first"}};
constexpr std::array fill_rules{Word{FillRule::even_odd, "even-odd"},
                                Word{FillRule::non_zero, "non-zero"}};
constexpr std::array polygon_vertex_rules{Word{PolygonVertices::half_open, "half-open"},
                                          Word{PolygonVertices::turning, "turning"}};
constexpr std::array passes{Word{1, "1"}, Word{2, "2"}, Word{3, "3"}};
constexpr std::array roundings{Word{Rounding::floor, "floor"}, Word{Rounding::nearest, "nearest"},
                               Word{Rounding::truncate, "truncate"},
                               Word{Rounding::inside, "inside"},
                               Word{Rounding::half_open, "half-open"}};
constexpr std::array tie_rules{Word{Ties::start, "start"}, Word{Ties::up, "up"},
                               Word{Ties::away, "away"}, Word{Ties::even, "even"},
                               Word{Ties::step, "step"}};
constexpr std::array samples{Word{Sample::integer, "integer"}, Word{Sample::center, "center"}};
constexpr std::array horizontal_edges{Word{HorizontalEdge::top, "top"},
                                      Word{HorizontalEdge::bottom, "bottom"}};
constexpr std::array row_rules{Word{RowRule::closed, "closed"},
                               Word{RowRule::half_open, "half-open"}};
constexpr std::array lerps{Word{LerpForm::direct, "direct"},
                           Word{LerpForm::incremental, "incremental"}};
constexpr std::array snaps{Word{Snap::none, "none"}, Word{Snap::floor, "floor"},
                           Word{Snap::truncate, "truncate"}, Word{Snap::nearest, "nearest"}};
constexpr std::array culls{Word{Cull::none, "none"}, Word{Cull::back, "back"},
                           Word{Cull::front, "front"}, Word{Cull::both, "both"},
                           Word{Cull::light, "light"}};
constexpr std::array depth_kinds{Word{Depth::none, "none"}, Word{Depth::painter, "painter"},
                                 Word{Depth::linear_z, "linear-z"},
                                 Word{Depth::inverse_z, "inverse-z"}, Word{Depth::ndc_z, "ndc-z"}};
constexpr std::array compares{Word{DepthCompare::automatic, "auto"},
                              Word{DepthCompare::less, "less"},
                              Word{DepthCompare::greater, "greater"}};
constexpr std::array depth_places{Word{DepthAt::pixel, "pixel"},
                                  Word{DepthAt::rounded_ends, "rounded-ends"}};
constexpr std::array painter_keys{Word{PainterKey::nearest, "nearest"},
                                  Word{PainterKey::farthest, "farthest"},
                                  Word{PainterKey::mean, "mean"}};
constexpr std::array shades{Word{Shade::flat, "flat"}, Word{Shade::faces, "faces"},
                            Word{Shade::interpolate, "interpolate"}, Word{Shade::affine, "affine"},
                            Word{Shade::lambert, "lambert"}};
constexpr std::array color_lerps{Word{ColorLerp::space, "space"}, Word{ColorLerp::axis, "axis"},
                                 Word{ColorLerp::distance, "distance"}};
constexpr std::array color_roundings{Word{ColorRounding::nearest, "nearest"},
                                     Word{ColorRounding::truncate, "truncate"}};

bool always(const Scene&) {
    return true;
}
bool has_vertex_colors(const Scene& scene) {
    return std::any_of(scene.vertices.begin(), scene.vertices.end(),
                       [](const SceneVertex& vertex) { return vertex.color.has_value(); });
}
bool has_triangles(const Scene& scene) {
    return scene.has(PrimitiveKind::triangle);
}
bool has_lines(const Scene& scene) {
    return std::any_of(
        scene.primitives.begin(), scene.primitives.end(), [](const ScenePrimitive& one) {
            return one.kind == PrimitiveKind::line || one.kind == PrimitiveKind::outline;
        });
}
bool fills_by(const Scene& scene, PixelRule rule) {
    return has_triangles(scene) && traits_of(scene.method.fill).rule == rule;
}
bool has_polygons(const Scene& scene) {
    return scene.has(PrimitiveKind::polygon);
}
bool fills_spans(const Scene& scene) {
    return fills_by(scene, PixelRule::row_ends) || has_polygons(scene);
}
bool rounds_lines(const Scene& scene) {
    return traits_of(scene.method.line).rule == LineRule::rounding && has_lines(scene);
}
bool rounds(const Scene& scene) {
    return fills_spans(scene) || rounds_lines(scene);
}

/// What is in force where nothing was said. With spans and lines in one scene that nobody has given
/// a rule, each has its own.
std::string default_of_two(const Scene& scene, std::string_view for_spans,
                           std::string_view for_lines) {
    if (fills_spans(scene) && rounds_lines(scene) && for_spans != for_lines)
        return std::string(for_spans) + "+" + std::string(for_lines);
    return std::string(fills_spans(scene) ? for_spans : for_lines);
}

bool draws_on_grid(const Scene& scene) {
    return (has_lines(scene) && traits_of(scene.method.line).rule == LineRule::grid) ||
           fills_by(scene, PixelRule::lines);
}

/// Bresenham's line has a rule of its own for ties. `up`, `away` and `even`, which are for others, leave it as
/// it is.
bool has_ties_of_bresenham(const Scene& scene) {
    return draws_on_grid(scene) &&
           (scene.method.ties == Ties::start || scene.method.ties == Ties::step);
}

bool has_ties(const Scene& scene) {
    return has_ties_of_bresenham(scene) || scene.method.snap == Snap::nearest ||
           (fills_spans(scene) && span_rounding(scene.method).rounding == Rounding::nearest) ||
           (rounds_lines(scene) && line_rounding(scene.method).rounding == Rounding::nearest);
}

template <typename Member> bool is_value(const Member& member, const Member& value) {
    return member == value;
}
template <typename Value> bool is_value(const std::optional<Value>& member, const Value& value) {
    return member == value;
}

/// The key that chooses `member`, one of `words`.
template <auto member, const auto& words>
MethodKey key(
    std::string_view name, std::string_view meaning, bool (*in_force)(const Scene&),
    std::string (*otherwise)(const Scene&) = [](const Scene&) { return std::string(); }) {
    MethodKey result{.name = name,
                     .meaning = meaning,
                     .values = {},
                     .get =
                         [](const Method& method) {
                             for (const auto& word : words)
                                 if (is_value(method.*member, word.value))
                                     return std::string(word.word);
                             return std::string();
                         },
                     .set =
                         [](Method& method, std::string_view value) {
                             for (const auto& word : words)
                                 if (word.word == value) {
                                     method.*member = word.value;
                                     return true;
                                 }
                             return false;
                         },
                     .otherwise = otherwise,
                     .in_force = in_force};
    for (const auto& word : words)
        result.values.push_back(word.word);
    return result;
}

/// True if a scene has what samples that a scene does not choose leave where it is.
bool has_unsampled(const Scene& scene) {
    const bool has_diamonds = traits_of(scene.method.line).rule == LineRule::diamonds;
    return std::any_of(all_primitives.begin(), all_primitives.end(), [&](PrimitiveKind kind) {
        const SampledBy whose = traits_of(kind).samples;
        return scene.has(kind) &&
               (whose == SampledBy::itself || (whose == SampledBy::line && !has_diamonds));
    });
}

/// True if a scene has triangles, or lines, that are drawn by samples.
bool tests_samples(const Scene& scene) {
    return fills_by(scene, PixelRule::samples) ||
           (has_lines(scene) && traits_of(scene.method.line).rule == LineRule::diamonds);
}

/// The samples of triangles, or of all that is drawn, are not at integers.
bool moves_samples(const Scene& scene) {
    const bool is_moved = sample_of_others(scene.method) != Sample::integer;
    return tests_samples(scene) || (is_moved && !scene.primitives.empty());
}

} // namespace

/// Not of `key`: its words are those of the table.
static MethodKey convention_key() {
    MethodKey key{
        .name = "convention",
        .meaning = "the rules of graphics hardware, another rasterizer or a course",
        .values = {},
        .get =
            [](const Method& method) {
                const ConventionRow* const row = row_of(method.convention);
                return row == nullptr ? std::string() : std::string(row->name);
            },
        .set =
            [](Method& method, std::string_view value) {
                for (const ConventionRow& row : convention_rows())
                    if (row.name == value) {
                        method.convention = row.convention;
                        return true;
                    }
                return false;
            },
        .otherwise = [](const Scene&) { return std::string(); },
        .in_force = [](const Scene& scene) { return scene.method.convention != Convention::none; }};
    for (const ConventionRow& row : convention_rows())
        key.values.push_back(row.name);
    return key;
}

static MethodKey mistake_key() {
    MethodKey key{.name = "mistake",
                  .meaning = "known mistakes to draw with",
                  .values = {},
                  .get =
                      [](const Method& method) {
                          std::vector<std::string_view> names;
                          for (const Mistake* const mistake : method.mistakes)
                              names.push_back(mistake->name);
                          return joined(names, ",");
                      },
                  .set =
                      [](Method& method, std::string_view value) {
                          method.mistakes.clear();
                          for (const std::string& name : split_at(std::string(value), ',')) {
                              method.mistakes.push_back(find_mistake(name));
                              if (method.mistakes.back() == nullptr)
                                  return false;
                          }
                          return true;
                      },
                  .otherwise = [](const Scene&) { return std::string(); },
                  .in_force = [](const Scene& scene) { return !scene.method.mistakes.empty(); },
                  .told_as = "a name that `rastertrace diagnose --list` lists, or several: a,b"};
    for (const Mistake& mistake : mistakes())
        key.values.push_back(mistake.name);
    return key;
}

MethodOverrides settings_of(const Mistake& mistake) {
    auto settings = parse_method({"", std::string(mistake.setting)});
    return std::move(settings.value());
}

void put_in(const Mistake& mistake, Method& method) {
    if (mistake.put_in != nullptr) {
        method.scalar = ScalarKind::exact;
        return;
    }
    for (const auto& [name, value] : settings_of(mistake))
        find_method_key(name)->set(method, value);
}

std::string MethodKey::listed() const {
    return told_as.empty() ? joined(values, ", ") : std::string(told_as);
}

std::string MethodKey::expected() const {
    return told_as.empty() ? fmt::format("one of {}", listed()) : listed();
}

std::span<const MethodKey> method_keys() {
    static const std::array keys{
        convention_key(),
        key<&Method::scalar, scalars>("scalar", "the numbers to draw with", always),
        key<&Method::line, lines>("line", "the algorithm that draws lines", has_lines),
        key<&Method::from, starts>("from", "the end that lines are drawn from", has_lines),
        key<&Method::ends, end_pixels>("ends", "which of its end pixels a line draws",
                                       [](const Scene& scene) {
                                           return has_lines(scene) &&
                                                  traits_of(scene.method.line).rule !=
                                                      LineRule::diamonds;
                                       }),
        key<&Method::fill, fills>("fill", "the algorithm that fills triangles", has_triangles),
        key<&Method::fill_rule, fill_rules>(
            "fill_rule", "what lies inside a polygon that crosses itself", has_polygons),
        key<&Method::polygon_vertices, polygon_vertex_rules>(
            "polygon_vertices", "which edges have the row of a polygon's vertex",
            [](const Scene& scene) {
                return has_polygons(scene) &&
                       scene.method.polygon_vertices == PolygonVertices::turning;
            }),
        key<&Method::fan_passes, passes>(
            "fan_passes", "from how many edges the fan is drawn",
            [](const Scene& scene) { return fills_by(scene, PixelRule::lines); }),
        key<&Method::rounding, roundings>(
            "rounding", "how a span's ends, or a line's points, become pixels", rounds,
            [](const Scene& scene) { return default_of_two(scene, "floor", "nearest"); }),
        key<&Method::ties, tie_rules>("ties", "where rounding to nearest sends a half", has_ties,
                                      [](const Scene&) { return std::string("up"); }),
        key<&Method::sample, samples>(
            "sample", "where in its pixel a fill, or a line, looks", moves_samples,
            [](const Scene& scene) {
                return std::string(sample_of(scene.method) == Sample::center ? "center"
                                                                             : "integer");
            }),
        key<&Method::horizontal_edge, horizontal_edges>(
            "horizontal_edge", "which horizontal edge of a triangle has the samples on it",
            [](const Scene& scene) {
                return has_triangles(scene) && scene.method.fill == Fill::top_left &&
                       scene.method.horizontal_edge != HorizontalEdge::top;
            }),
        key<&Method::rows, row_rules>(
            "rows", "which of the rows of its outermost vertices a triangle, or a polygon, has",
            [](const Scene& scene) {
                return (fills_by(scene, PixelRule::row_ends) &&
                        scene.method.rows == RowRule::half_open) ||
                       (has_polygons(scene) && scene.method.rows == RowRule::closed);
            }),
        key<&Method::lerp, lerps>("lerp", "how x is found from row to row", fills_spans),
        key<&Method::snap, snaps>("snap", "where vertices on the screen go before they are drawn",
                                  [](const Scene& scene) { return scene.has_transforms(); }),
        key<&Method::cull, culls>("cull", "which faces are not drawn",
                                  [](const Scene& scene) {
                                      return scene.has_faces() &&
                                             (scene.has_transforms() || scene.tests_faces());
                                  }),
        key<&Method::depth, depth_kinds>(
            "depth", "how triangles in front hide those behind",
            [](const Scene& scene) {
                return scene.has_depth_buffer() || scene.depth() == Depth::painter;
            },
            [](const Scene& scene) {
                for (const auto& word : depth_kinds)
                    if (word.value == scene.depth())
                        return std::string(word.word);
                return std::string();
            }),
        key<&Method::depth_compare, compares>(
            "depth_compare", "which depths pass the test",
            [](const Scene& scene) { return scene.has_depth_buffer(); }),
        key<&Method::depth_at, depth_places>(
            "depth_at", "where the depths of a row's ends lie",
            [](const Scene& scene) { return scene.has_depth_buffer() && fills_spans(scene); }),
        key<&Method::painter_key, painter_keys>(
            "painter_key", "the distance that the painter sorts by",
            [](const Scene& scene) { return scene.depth() == Depth::painter; }),
        key<&Method::shade, shades>(
            "shade", "where the colors of pixels come from",
            [](const Scene& scene) {
                return has_vertex_colors(scene) || scene.shade() != Shade::flat;
            },
            [](const Scene& scene) {
                return std::string(scene.mixes_colors() ? "interpolate" : "flat");
            }),
        key<&Method::color_lerp, color_lerps>(
            "color_lerp", "what the color along a line goes by",
            [](const Scene& scene) {
                return scene.mixes_colors() &&
                       (has_lines(scene) || fills_by(scene, PixelRule::lines));
            },
            [](const Scene& scene) {
                return std::string(scene.color_lerp() == ColorLerp::space ? "space" : "axis");
            }),
        key<&Method::color_rounding, color_roundings>(
            "color_rounding", "what becomes of a channel that is no whole level",
            [](const Scene& scene) {
                return scene.mixes_colors() ||
                       (scene.has_faces() && scene.shade() == Shade::lambert);
            }),
        mistake_key(),
    };
    return keys;
}

std::string value_in_force(const MethodKey& key, const Scene& scene) {
    const std::string said = key.get(scene.method);
    if (key.name == "sample" && tests_samples(scene) && has_unsampled(scene) &&
        sample_of_others(scene.method) != Sample::integer)
        return said + "+" + said;
    return said.empty() ? key.otherwise(scene) : said;
}

std::string ToldMethod::word_of(std::string_view key) const {
    const auto found = std::find_if(words.begin(), words.end(),
                                    [key](const auto& word) { return word.first == key; });
    return found == words.end() ? std::string() : found->second;
}

ToldMethod told_method(std::vector<std::pair<std::string, std::string>> words) {
    ToldMethod told;
    bool has_two_samples = false;
    for (const auto& [name, value] : words) {
        const MethodKey* const key = find_method_key(name);
        if (key == nullptr)
            continue;
        // `floor+nearest`: that of triangles, and that of lines.
        const std::size_t plus = value.find('+');
        const bool has_two = plus != std::string::npos;
        if (key->set(told.triangles, value.substr(0, plus)) &&
            key->set(told.others, has_two ? value.substr(plus + 1) : value))
            told.keys.insert(name);
        has_two_samples = has_two_samples || (has_two && name == "sample");
    }
    const bool tests_samples =
        (told.says("fill") && traits_of(told.triangles.fill).rule == PixelRule::samples) ||
        (told.says("line") && traits_of(told.others.line).rule == LineRule::diamonds);
    if (tests_samples && !has_two_samples)
        told.others.sample.reset();
    told.words = std::move(words);
    return told;
}

const MethodKey* find_method_key(std::string_view name) {
    for (const MethodKey& key : method_keys())
        if (key.name == name)
            return &key;
    return nullptr;
}

namespace {

/// A problem at a place of a METHOD, which is one line and needs no number.
Problem problem_in_method(const Source& source, std::size_t offset, std::string message,
                          std::string hint = {}) {
    Problem problem = problem_at(source, offset, std::move(message), std::move(hint));
    problem.line = 0;
    return problem;
}

} // namespace

Result<MethodOverrides> parse_method(const Source& source) {
    std::vector<std::string_view> keys;
    for (const MethodKey& key : method_keys())
        keys.push_back(key.name);
    MethodOverrides method;
    std::size_t offset = 0;
    for (const std::string& choice : split_at(source.text, ',')) {
        const std::size_t equals = choice.find('=');
        if (equals == std::string::npos)
            return problem_in_method(
                source, offset,
                fmt::format("expected a choice like rounding=truncate, found \"{}\"", choice));
        std::string name = choice.substr(0, equals);
        std::replace(name.begin(), name.end(), '-', '_');
        const std::string value = choice.substr(equals + 1);
        const MethodKey* const key = find_method_key(name);
        if (key == nullptr)
            return problem_in_method(
                source, offset,
                fmt::format("expected a key out of {}, found \"{}\"", joined(keys, ", "), name),
                did_you_mean(name, keys));
        Method scratch;
        if (!key->set(scratch, value))
            return problem_in_method(
                source, offset + equals + 1,
                !key->told_as.empty()
                    ? fmt::format("expected {}, found \"{}\"", key->told_as, value)
                    : fmt::format("expected {} out of {}, found \"{}\"", name, key->listed(),
                                  value),
                did_you_mean(value, key->values));
        method.emplace_back(name, value);
        offset += choice.size() + 1;
    }
    return method;
}

} // namespace rastertrace
