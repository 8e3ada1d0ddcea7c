// SPDX-License-Identifier: MIT
#pragma once

// Pictures as rows of text, and triangles to draw in tests.

#include <rastertrace/core/draw.h>

#include <functional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
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

/// One step of any kind, for any scalar.
template <typename Scalar>
using StepsOf =
    std::tuple<const MatrixSetUp<Scalar>*, const VertexPlaced<Scalar>*,
               const PrimitivesOrdered<Scalar>*, const FaceTested<Scalar>*, const FaceLit<Scalar>*,
               const PrimitiveBegan<Scalar>*, const EdgeSetUp<Scalar>*,
               const EdgeFunctionSetUp<Scalar>*, const ScanlineSpanned<Scalar>*,
               const LineSampled<Scalar>*, const SampleTested<Scalar>*, const DepthTested<Scalar>*>;
using PlainSteps =
    std::tuple<const PrimitiveClipped*, const SideBegan*, const HalfBegan*, const RayBegan*,
               const LineDecided*, const PixelPlotted*, const PixelsRejected*, const RowsRejected*,
               const PrimitiveSkipped*, const BoundExceeded*>;
template <typename... Types> std::variant<Types...> any_of(std::tuple<Types...>);
using AnyStep = decltype(any_of(std::tuple_cat(
    std::declval<StepsOf<float>>(), std::declval<StepsOf<double>>(),
    std::declval<StepsOf<Adaptive>>(), std::declval<StepsOf<Fraction64>>(),
    std::declval<StepsOf<Fraction128>>(), std::declval<StepsOf<Rational>>(), PlainSteps{})));

/// Draws a scene as its plan says. Compiled once, for all the tests.
Image draw_as_planned(const Scene& scene);
Image draw_watched(const Scene& scene, const std::function<void(const AnyStep&)>& watch);

/// Draws a scene as its plan says, with a sink.
template <typename Sink> Image draw_as_planned(const Scene& scene, Sink&& sink) {
    return draw_watched(scene, [&sink](const AnyStep& step) {
        std::visit([&sink](const auto* one) { sink(*one); }, step);
    });
}

} // namespace rastertrace
