// SPDX-License-Identifier: MIT
#pragma once

// Random scenes that sit on the edges of decisions: corners on pixels, on the borders of the canvas, on
// each other's edges and on the planes of the view; depths and colors that agree or all but do.

#include "random_choice.h"

#include <rastertrace/core/draw/scene/scene.h>

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>

namespace rastertrace {

/// Random scenes, the same on every machine.
class EdgeScenes {
public:
    explicit EdgeScenes(std::uint64_t seed) : random_(seed) {}

    Scene next() {
        Scene scene;
        scene.canvas = {.width = 12,
                        .height = 12,
                        .origin =
                            random_.pick({Origin::center, Origin::top_left, Origin::bottom_left})};
        scene.method.scalar =
            random_.pick({ScalarKind::single_precision, ScalarKind::double_precision,
                          ScalarKind::fixed, ScalarKind::adaptive, ScalarKind::exact});
        scene.method.fill = random_.pick({Fill::scanline, Fill::two_halves, Fill::barycentric,
                                          Fill::top_left, Fill::top_left, Fill::fan});
        scene.method.rounding = random_.pick(
            {Rounding::floor, Rounding::nearest, Rounding::truncate, Rounding::inside});
        scene.method.lerp = random_.pick({LerpForm::direct, LerpForm::incremental});
        if (random_.chance(2))
            scene.method.sample = random_.pick({Sample::integer, Sample::center});
        scene.method.shade =
            random_.pick({Shade::flat, Shade::interpolate, Shade::affine, Shade::faces});
        scene.method.depth = random_.pick(
            {Depth::none, Depth::painter, Depth::linear_z, Depth::inverse_z, Depth::ndc_z});
        scene.method.cull = random_.pick({Cull::none, Cull::none, Cull::back, Cull::front});
        is_in_space_ = random_.chance(2);
        if (is_in_space_)
            look(scene);
        const int triangles = random_.whole(1, 4);
        for (int i = 0; i < triangles; ++i)
            add_triangle(scene, i);
        return scene;
    }

private:
    /// The pipeline: matrices that move nothing, or a little, or everything.
    void look(Scene& scene) {
        scene.projection = {
            .type = random_.pick({ProjectionType::orthographic, ProjectionType::pinhole,
                                  ProjectionType::view_plane, ProjectionType::frustum})};
        scene.projection.distance = random_.pick<Number>({1, 2});
        scene.projection.left = scene.projection.bottom = -1;
        scene.projection.right = scene.projection.top = 1;
        if (scene.projection.type == ProjectionType::frustum || random_.chance(2)) {
            scene.projection.near = Number(1);
            scene.projection.far = Number(9);
        }
        scene.viewport = {.type = ViewportType::pixels, .pixels_per_unit = 1};
        if (random_.chance(2))
            scene.camera = Camera{.position = {0, 0, random_.pick<Number>({0, 4})},
                                  .look_at = {0, 0, -1},
                                  .up = {0, 1, 0}};
        if (random_.chance(2))
            scene.objects = {{"", 100, {Translate{{0, 0, random_.pick<Number>({0, 0, 1})}}}}};
    }

    /// Corners on a coarse grid, so that many lie on the borders of the canvas, of each other's
    /// boxes and on the planes; depths and colors that agree, or differ by next to nothing.
    void add_triangle(Scene& scene, int number) {
        const std::initializer_list<Number> near_two{
            2, 2, 2, Number::decimal(20000000000000004, -16), 3, 9};
        const Number depth = random_.pick(near_two);
        const auto level = [this] { return static_cast<std::uint8_t>(random_.whole(1, 254)); };
        const Color color{level(), level(), level()};
        const bool is_colorful = random_.chance(3);
        const bool agrees_in_depth = random_.chance(2);
        const bool agrees_in_color = random_.chance(2);
        const int cell_x = random_.whole(0, 2);
        const int cell_y = random_.whole(0, 2);
        ScenePrimitive primitive{.kind = PrimitiveKind::triangle,
                                 .name = "T" + std::to_string(number),
                                 .vertices = {},
                                 .color = {}};
        for (std::size_t i = 0; i < 3; ++i) {
            SceneVertex vertex{primitive.name + static_cast<char>('a' + i), 0, 0, {}, 0};
            const Number at = agrees_in_depth ? depth : random_.pick(near_two);
            if (is_in_space_) {
                const bool looks_up = scene.projection.type == ProjectionType::pinhole;
                const Rational z = looks_up ? at.exact() : Rational(-at.exact());
                const Rational scale = is_perspective(scene.projection.type) ? at.exact() : 1;
                vertex.x = Number::fraction(Rational(random_.whole(-5, 5)) / 4 * scale);
                vertex.y = Number::fraction(Rational(random_.whole(-5, 5)) / 4 * scale);
                vertex.z = Number::fraction(z);
            } else {
                const bool is_apart = random_.whole(0, 3) > 0;
                const int low_x = scene.canvas.left();
                const int low_y = std::min(scene.canvas.top(), scene.canvas.bottom());
                const int half_x =
                    is_apart ? 8 * cell_x + random_.whole(0, 6) : random_.whole(-2, 24);
                const int half_y =
                    is_apart ? 8 * cell_y + random_.whole(0, 6) : random_.whole(-2, 24);
                vertex.x = Number::fraction(Rational(half_x) / 2 + low_x);
                vertex.y = Number::fraction(Rational(half_y) / 2 + low_y);
                vertex.z = at;
            }
            const int more = agrees_in_color ? 0 : random_.whole(0, 1);
            const auto red = static_cast<std::uint8_t>(color.red() + more);
            vertex.color = is_colorful && !agrees_in_color
                               ? Color{level(), level(), level()}
                               : Color{red, color.green(), color.blue()};
            primitive.vertices[i] = scene.vertices.size();
            scene.vertices.push_back(vertex);
        }
        scene.primitives.push_back(primitive);
    }

    Random random_;
    bool is_in_space_ = false;
};

} // namespace rastertrace
