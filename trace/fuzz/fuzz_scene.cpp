// SPDX-License-Identifier: MIT
#include "fuzz_scene.h"

#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/named_value.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::int64_t half = fuzz_unit / 2;

/// Far enough that all names fit, and that pictures tell whose a pixel is.
constexpr std::array<Color, 6> colors{Color(230, 25, 75),  Color(60, 180, 75),
                                      Color(0, 130, 200),  Color(245, 130, 48),
                                      Color(145, 30, 180), Color(70, 240, 240)};

/// The engine is defined by the C++ standard, the distributions are not.
class Choices {
public:
    explicit Choices(std::uint64_t seed) : engine_(seed) {}

    std::int64_t whole(std::int64_t low, std::int64_t high) {
        return low +
               static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool chance(int of) { return whole(1, of) == 1; }
    std::int64_t sign() { return 2 * whole(0, 1) - 1; }

private:
    std::mt19937_64 engine_;
};

class RandomFuzzScene {
public:
    RandomFuzzScene(std::uint64_t seed, const FuzzChoice& choice)
        : random_(seed), has_near_tie_(choice.has_near_ties && seed % 8 == 0) {
        scene_.kind = choice.kinds[index_below(choice.kinds.size())];
        scene_.method = choice.method;
        scene_.width = side(choice.largest_canvas);
        scene_.height = side(choice.largest_canvas);
    }

    FuzzScene made() && {
        const auto count = static_cast<std::size_t>(random_.whole(1, 5));
        while (scene_.primitives.size() < count)
            add(scene_.kind == FuzzKind::lines ? line() : triangle());
        if (scene_.kind != FuzzKind::lines && random_.chance(3))
            add_neighbor();
        const bool is_long = scene_.kind == FuzzKind::lines; // and so is its trace
        if (has_near_tie_ && scene_.kind != FuzzKind::clip && (!is_long || random_.chance(4)))
            add(is_long ? long_line() : near_tie());
        return std::move(scene_);
    }

private:
    std::size_t index_below(std::size_t count) {
        return static_cast<std::size_t>(random_.whole(0, static_cast<std::int64_t>(count) - 1));
    }

    int side(int largest) {
        int size = largest;
        for (auto halvings = random_.whole(0, 2); halvings > 0 && size > 4; --halvings)
            size /= 2;
        return size;
    }

    void add(std::vector<FuzzVertex> vertices) {
        const std::size_t n = scene_.primitives.size();
        scene_.primitives.push_back(
            {.name = fmt::format("{}{}", scene_.kind == FuzzKind::lines ? 'L' : 'T', n + 1),
             .vertices = std::move(vertices),
             .color = colors[n % colors.size()]});
    }

    /// A coordinate on an axis of so many pixels: whole, a half (where samples are), a quarter, any; now and then far.
    std::int64_t coordinate(int pixels) {
        const std::int64_t whole = random_.whole(-1, pixels + 1) * fuzz_unit;
        if (random_.chance(16))
            return whole * random_.whole(10, 400) + half * random_.whole(0, 1);
        switch (random_.whole(0, 4)) {
        case 0:
        case 1:
            return whole;
        case 2:
            return whole + half;
        case 3:
            return whole + fuzz_unit / 4 * random_.whole(0, 3);
        default:
            return whole + random_.whole(0, fuzz_unit - 1);
        }
    }

    /// In clip space: around the view, in front of the eye and behind it.
    FuzzVertex clip_vertex() {
        const std::int64_t w = random_.chance(6) ? random_.whole(-2, 0) : random_.whole(1, 4);
        const auto place = [&] {
            return fuzz_unit * random_.whole(-3, 3) / 2 * std::max<std::int64_t>(w, 1);
        };
        const std::int64_t x = place();
        const std::int64_t y = place();
        return {x, y, fuzz_unit * random_.whole(-4, 4) / 4 * std::max<std::int64_t>(w, 1),
                w * fuzz_unit};
    }

    FuzzVertex vertex() {
        // One that is there already: corners that meet.
        if (!scene_.primitives.empty() && random_.chance(4)) {
            const auto& vertices =
                scene_.primitives[index_below(scene_.primitives.size())].vertices;
            return vertices[index_below(vertices.size())];
        }
        if (scene_.kind == FuzzKind::clip)
            return clip_vertex();
        const bool has_depth = scene_.kind == FuzzKind::depth;
        const std::int64_t x = coordinate(scene_.width);
        const std::int64_t y = coordinate(scene_.height);
        return {x, y, has_depth ? random_.whole(1, 9) * fuzz_unit : 0, fuzz_unit};
    }

    std::vector<FuzzVertex> line() { return {vertex(), vertex()}; }

    std::vector<FuzzVertex> triangle() {
        std::vector<FuzzVertex> corners{vertex(), vertex(), vertex()};
        if (scene_.kind == FuzzKind::clip)
            return corners;
        switch (random_.whole(0, 9)) {
        case 0: // a sliver
            corners[2] = corners[1];
            corners[2][index_below(2)] += random_.whole(1, 64);
            break;
        case 1: // a horizontal edge
            corners[2][1] = corners[1][1];
            break;
        case 2: // a vertical one
            corners[1][0] = corners[0][0];
            break;
        case 3: // without area
            corners[2] = {2 * corners[1][0] - corners[0][0], 2 * corners[1][1] - corners[0][1],
                          corners[2][2], fuzz_unit};
            break;
        case 4: // smaller than a pixel
            for (std::size_t i = 1; i < 3; ++i)
                for (std::size_t axis = 0; axis < 2; ++axis)
                    corners[i][axis] = corners[0][axis] + random_.whole(-fuzz_unit, fuzz_unit);
            break;
        default:
            break;
        }
        return corners;
    }

    /// A triangle that has an edge in common with the last one: each pixel on it is to be drawn once.
    void add_neighbor() {
        const auto& corners = scene_.primitives.back().vertices;
        add({corners[1], corners[0], vertex()});
    }

    /// A line from a pixel of the canvas, so long that Bresenham's d leaves 16 bits at the first diagonal step.
    std::vector<FuzzVertex> long_line() {
        const std::size_t major = index_below(2);
        FuzzVertex begin{0, 0, 0, fuzz_unit};
        for (std::size_t axis = 0; axis < 2; ++axis)
            begin[axis] = random_.whole(0, std::min(scene_.width, scene_.height) - 1) * fuzz_unit;
        const std::int64_t minor = random_.whole(500, 3000);
        FuzzVertex end = begin;
        end[major] += random_.sign() * (minor + random_.whole(20'000, 20'500)) * fuzz_unit;
        end[1 - major] += random_.sign() * minor * fuzz_unit;
        return {begin, end};
    }

    /// A triangle whose edge, longer than the canvas or than 2,000 pixels, passes a sample as near as the grid of 1/256
    /// pixel allows: there its edge function is 1/65536 or -1/65536.
    std::vector<FuzzVertex> near_tie() {
        const std::int64_t longest = random_.chance(2) ? 2000 : scene_.width;
        // Euclid's algorithm backwards: along x to_sample stays 1 or -1.
        std::array<std::int64_t, 2> along{1, 0};
        std::array<std::int64_t, 2> to_sample{0, 1};
        while (std::max(along[0], along[1]) < 256 * longest) {
            const std::int64_t times = random_.whole(1, 4);
            for (std::size_t axis = 0; axis < 2; ++axis)
                to_sample[axis] += times * along[axis];
            std::swap(along, to_sample);
        }
        std::vector<FuzzVertex> corners(3, {0, 0, random_.whole(1, 9) * fuzz_unit, fuzz_unit});
        const std::array sides{scene_.width, scene_.height};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const std::int64_t sample = random_.whole(0, sides[axis] - 1) * fuzz_unit + half;
            const std::int64_t grid = random_.sign() * fuzz_unit / 256;
            corners[0][axis] = sample - grid * to_sample[axis];
            corners[1][axis] = corners[0][axis] + grid * along[axis];
            corners[2][axis] = sample + random_.whole(-longest, longest) * fuzz_unit;
        }
        return corners;
    }

    Choices random_;
    bool has_near_tie_;
    FuzzScene scene_;
};

/// An exact decimal of k/1024.
std::string decimal(std::int64_t value) {
    // 1/1024 has ten decimals.
    constexpr std::int64_t scale = 9765625; // 10^10 / 1024
    const std::int64_t whole = std::abs(value) / fuzz_unit;
    std::string text = fmt::format("{}{}", value < 0 ? "-" : "", whole);
    if (const std::int64_t rest = std::abs(value) % fuzz_unit; rest != 0) {
        text += fmt::format(".{:010}", rest * scale);
        text.erase(text.find_last_not_of('0') + 1);
    }
    return text;
}

/// How many coordinates of a vertex are told.
std::size_t count_coordinates(const FuzzScene& scene) {
    return scene.kind == FuzzKind::clip ? 4 : scene.kind == FuzzKind::depth ? 3 : 2;
}

std::string coordinates(const FuzzVertex& vertex, std::size_t count, std::string_view separator) {
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < count; ++i)
        numbers.push_back(decimal(vertex[i]));
    return joined(numbers, separator);
}

std::string vertex_name(std::size_t number, std::size_t count) {
    constexpr std::size_t letters = 26;
    return count <= letters ? std::string(1, static_cast<char>('A' + number))
                            : fmt::format("P{}", number + 1);
}

} // namespace

std::optional<FuzzKind> fuzz_kind_named(std::string_view name) {
    return value_named<FuzzKind>(fuzz_kind_names, name);
}

FuzzScene random_scene(std::uint64_t seed, const FuzzChoice& choice) {
    return RandomFuzzScene(seed, choice).made();
}

std::vector<FuzzVertex> fuzz_vertices(const FuzzScene& scene) {
    std::vector<FuzzVertex> all;
    for (const FuzzPrimitive& primitive : scene.primitives)
        for (const FuzzVertex& vertex : primitive.vertices)
            if (std::ranges::find(all, vertex) == all.end())
                all.push_back(vertex);
    return all;
}

std::string scene_json(const FuzzScene& scene) {
    const std::vector<FuzzVertex> all = fuzz_vertices(scene);
    const auto name_of_vertex = [&all](const FuzzVertex& vertex) {
        return vertex_name(static_cast<std::size_t>(std::ranges::find(all, vertex) - all.begin()),
                           all.size());
    };
    std::vector<std::string> vertices;
    for (const FuzzVertex& vertex : all)
        vertices.push_back(fmt::format(R"("{}": [{}])", name_of_vertex(vertex),
                                       coordinates(vertex, count_coordinates(scene), ", ")));
    std::vector<std::string> primitives;
    for (const FuzzPrimitive& primitive : scene.primitives) {
        std::vector<std::string> names;
        for (const FuzzVertex& vertex : primitive.vertices)
            names.push_back(json_quoted(name_of_vertex(vertex)));
        primitives.push_back(fmt::format(R"({{"vertices": [{}], "name": {}, "color": "{}"}})",
                                         joined(names, ", "), json_quoted(primitive.name),
                                         to_text(primitive.color)));
    }
    std::vector<std::string> method;
    std::vector<std::string> kept;
    std::string beside; // what of the method is a key of the scene
    for (const auto& [key, value] : scene.method)
        if (key == "convention")
            beside += fmt::format(",\n \"convention\": {}", json_quoted(value));
        else if (key == "keep")
            kept.push_back(json_quoted(value));
        else
            method.push_back(fmt::format("{}: {}", json_quoted(key), json_quoted(value)));
    if (!kept.empty())
        beside += fmt::format(",\n \"keep\": [{}]", joined(kept, ", "));
    return fmt::format(
        "{{\"canvas\": {{\"width\": {}, \"height\": {}, \"origin\": \"top-left\"}},\n"
        " \"vertices\": {{{}}},\n \"{}\": [{}]{},\n \"method\": {{{}}}}}\n",
        scene.width, scene.height, joined(vertices, ", "),
        scene.kind == FuzzKind::lines ? "lines" : "triangles", joined(primitives, ",\n  "), beside,
        joined(method, ", "));
}

std::string triangles_text(const FuzzScene& scene) {
    std::string text = fmt::format("canvas {} {}\n", scene.width, scene.height);
    const bool is_clip = scene.kind == FuzzKind::clip;
    const std::string_view word = is_clip ? "clip" : scene.kind == FuzzKind::lines ? "line" : "tri";
    for (const FuzzPrimitive& primitive : scene.primitives) {
        text += fmt::format("{} {}", word, primitive.name);
        for (const FuzzVertex& vertex : primitive.vertices)
            text += " " + coordinates(vertex, is_clip ? 4 : 3, " ");
        text += fmt::format(" {}\n", to_text(primitive.color));
    }
    return text;
}

} // namespace rastertrace
