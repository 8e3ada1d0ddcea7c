// SPDX-License-Identifier: MIT
#pragma once

// Pictures as rows of text, and triangles to draw in tests.

#include <rastertrace/core/draw.h>

#include <concepts>
#include <cstddef>
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

inline Scene first_triangle(Method method = {.scalar = ScalarKind::exact}) {
    return triangle_scene({"2", "5", "-4", "-3", "5", "-3"}, {.width = 17, .height = 14}, method);
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

/// Draws it with other numbers of the same kind.
inline Image draw_with(NumberType number, const Scene& scene) {
    Plan plan = plan_for(scene);
    plan.number = number;
    return draw(scene, plan);
}

} // namespace rastertrace
