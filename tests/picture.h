// SPDX-License-Identifier: MIT
#pragma once

// Pictures as rows of text, and triangles to draw in tests.

#include <rastertrace/core/draw/draw.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rastertrace {

/// The canvas as rows of `.` and `#`, top row first.
inline std::string picture_of(const Image& image) {
    const Canvas& canvas = image.canvas();
    std::string text;
    for (int row = 0; row < canvas.height; ++row) {
        for (int x = canvas.left(); x <= canvas.right(); ++x)
            text += image.at({x, canvas.y_of(row)}) == no_color ? '.' : '#';
        text += '\n';
    }
    return text;
}

/// How many pixels have a color.
inline std::size_t count_of(const Image& image, Color color) {
    return static_cast<std::size_t>(
        std::count(image.colors().begin(), image.colors().end(), color));
}

/// Pictures of one height next to each other.
inline std::string side_by_side(const std::vector<std::string>& pictures) {
    std::vector<std::istringstream> all(pictures.begin(), pictures.end());
    std::string text;
    for (std::string row; std::getline(all.front(), row); text += '\n') {
        text += row;
        for (std::size_t i = 1; i < all.size() && std::getline(all[i], row); ++i)
            text += "  " + row;
    }
    return text;
}

/// A number from what a scene would say: `0.1`, `25/8`.
inline Number number(std::string_view text) {
    return std::get<Number>(parse_number(text));
}

/// A scene of one triangle, its coordinates as a scene would say them: x, y, x, y, x, y.
inline Scene triangle_scene(const std::vector<std::string>& coordinates, Canvas canvas,
                            Method method = {.scalar = ScalarKind::exact}) {
    Scene scene;
    scene.title = "A triangle";
    scene.canvas = canvas;
    scene.method = method;
    for (std::size_t i = 0; i < 3; ++i)
        scene.vertices.push_back({std::string(1, static_cast<char>('A' + i)),
                                  number(coordinates[2 * i]),
                                  number(coordinates[2 * i + 1]),
                                  {}});
    scene.primitives.push_back(
        {.kind = PrimitiveKind::triangle, .name = "ABC", .vertices = {0, 1, 2}, .color = {}});
    return scene;
}

/// A scene of triangles, each named by a letter and drawn in the order of the alphabet.
inline Scene lettered_triangles(const std::map<char, std::vector<std::string>>& triangles,
                                Canvas canvas, Method method = {.scalar = ScalarKind::exact}) {
    Scene scene;
    scene.canvas = canvas;
    scene.method = method;
    for (const auto& [letter, coordinates] : triangles) {
        const Scene one = triangle_scene(coordinates, canvas);
        const std::size_t first = scene.vertices.size();
        scene.vertices.insert(scene.vertices.end(), one.vertices.begin(), one.vertices.end());
        scene.primitives.push_back({.kind = PrimitiveKind::triangle,
                                    .name = {letter},
                                    .vertices = {first, first + 1, first + 2}});
    }
    return scene;
}

/// The worked triangle of T0, and its picture there.
inline Scene first_triangle(Method method = {.scalar = ScalarKind::exact}) {
    return triangle_scene({"2", "5", "-4", "-3", "5", "-3"}, {.width = 17, .height = 14}, method);
}
inline const std::string textbook_picture = ".................\n"
                                            ".................\n"
                                            "..........#......\n"
                                            ".........##......\n"
                                            "........###......\n"
                                            ".......#####.....\n"
                                            ".......#####.....\n"
                                            "......######.....\n"
                                            ".....########....\n"
                                            "....#########....\n"
                                            "....##########...\n"
                                            ".................\n"
                                            ".................\n"
                                            ".................\n";

/// On a canvas just large enough, so that several pictures of it stand side by side: x from -5 to 5,
/// y from 5 down to -4.
inline Scene small_first_triangle(Method method = {.scalar = ScalarKind::exact}) {
    Scene scene = first_triangle(method);
    scene.canvas = {.width = 11, .height = 10};
    return scene;
}

/// T0's cube, +-1 moved by (0, 0, 4): corners by one letter of A to H, triangles by three, faces turned
/// away culled.
inline Scene cube_of_t0(const std::vector<std::string>& primitives) {
    Scene scene;
    scene.canvas = {.width = 10, .height = 10};
    scene.projection = {.type = ProjectionType::pinhole, .distance = 1};
    scene.viewport = {.type = ViewportType::pixels_per_unit, .pixels_per_unit = 10};
    scene.objects = {{"", 8, {Translate{{0, 0, 4}}}}};
    scene.method = {.scalar = ScalarKind::exact, .cull = Cull::back};
    scene.vertices = {{"A", -1, 1, {}, -1},  {"B", 1, 1, {}, -1}, {"C", 1, -1, {}, -1},
                      {"D", -1, -1, {}, -1}, {"E", -1, 1, {}, 1}, {"F", 1, 1, {}, 1},
                      {"G", 1, -1, {}, 1},   {"H", -1, -1, {}, 1}};
    for (const std::string& letters : primitives) {
        ScenePrimitive primitive{.kind = letters.size() == 1 ? PrimitiveKind::point
                                                             : PrimitiveKind::triangle,
                                 .name = letters};
        for (std::size_t i = 0; i < letters.size(); ++i)
            primitive.vertices[i] = static_cast<std::size_t>(letters[i] - 'A');
        scene.primitives.push_back(primitive);
    }
    return scene;
}

/// A told number as a Scalar.
template <typename Scalar> Scalar as(const Quantity& told) {
    if constexpr (std::same_as<Scalar, Rational>)
        return told.exact();
    else
        return static_cast<Scalar>(told.to_double());
}
template <typename Scalar> Vec<Scalar, 3> as(const Vec<Quantity, 3>& told) {
    return {as<Scalar>(told.x), as<Scalar>(told.y), as<Scalar>(told.z)};
}

/// Draws a scene as its plan says.
inline Image draw_as_planned(const Scene& scene) {
    return draw(scene, plan_for(scene));
}
inline Image draw_as_planned(const Scene& scene, const Listener& listener) {
    return draw(scene, plan_for(scene), listener);
}

/// A drawing as its steps tell it: rows of text, top row first, `.` where nothing was plotted.
struct Plots {
    std::string owners; ///< the first letter of the name of the primitive that plotted a pixel last
    std::string counts; ///< how often a pixel was plotted: 1 to 9, `+` for more
};

/// Draws a scene as its plan says, and listens.
inline Plots plots_in(const Scene& scene) {
    Plots plots;
    for (int row = 0; row < scene.canvas.height; ++row)
        plots.owners += std::string(static_cast<std::size_t>(scene.canvas.width), '.') + '\n';
    plots.counts = plots.owners;
    char name = '.';
    draw_as_planned(scene, [&]<typename Step>(const Step& step) {
        if constexpr (std::same_as<Step, PrimitiveBegan<>>) {
            name = step.name.empty() ? '#' : step.name.front();
        } else if constexpr (std::same_as<Step, PixelPlotted<>>) {
            const std::size_t offset = scene.canvas.offset_of(step.pixel());
            const std::size_t place =
                offset + offset / static_cast<std::size_t>(scene.canvas.width);
            plots.owners[place] = name;
            char& count = plots.counts[place];
            count = count == '.' ? '1' : count < '9' ? static_cast<char>(count + 1) : '+';
        }
    });
    return plots;
}

/// Draws it with other numbers of the same kind.
inline Image draw_with(NumberType number, const Scene& scene) {
    Plan plan = plan_for(scene);
    plan.number = number;
    return draw(scene, plan);
}

} // namespace rastertrace
