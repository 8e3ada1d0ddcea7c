// SPDX-License-Identifier: MIT
#pragma once

// A scene: what is drawn, on which canvas, by which method. Numbers are held as they were typed.
//
//     Scene scene;
//     scene.canvas = {.width = 17, .height = 14};
//     scene.vertices = {{"A", 2, 5}, {"B", -4, -3}, {"C", 5, -3}};
//     scene.triangles = {{.name = "ABC", .vertices = {0, 1, 2}}};

#include <rastertrace/core/canvas.h>
#include <rastertrace/core/image.h>
#include <rastertrace/core/method.h>
#include <rastertrace/core/number.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace rastertrace {

/// A named point of the scene.
struct SceneVertex {
    std::string name;
    Number x;
    Number y;
};

/// A triangle between three of the scene's vertices.
struct SceneTriangle {
    std::string name;
    std::array<std::size_t, 3> vertices{}; ///< places in Scene::vertices, in the author's order
    Color color;
};

/// Everything needed to draw a picture.
struct Scene {
    std::string title;
    Canvas canvas;
    std::vector<SceneVertex> vertices;
    std::vector<SceneTriangle> triangles; ///< drawn in this order
    Method method;
};

} // namespace rastertrace
