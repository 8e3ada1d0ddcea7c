// SPDX-License-Identifier: MIT
// The same scenes with each scalar: planning and drawing, with no sink. `adaptive` beside `double` on
// scenes of every day, `exact` beside `double` where fractions of machine size fit.

#include <rastertrace/core/draw/draw.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>

namespace rastertrace {
namespace {

void add_triangle(Scene& scene, std::array<SceneVertex, 3> corners) {
    const std::size_t first = scene.vertices.size();
    for (SceneVertex& corner : corners)
        scene.vertices.push_back(std::move(corner));
    scene.primitives.push_back({.kind = PrimitiveKind::triangle,
                                .name = "T",
                                .vertices = {first, first + 1, first + 2},
                                .color = {200, 80, 20}});
}

/// Triangles of about `pixels` pixels each, two million pixels in all, on a canvas of 512 x 512.
/// Coordinates have `digits` decimal places: with two of them they fit in fractions of 64 bits, with
/// fifteen in none of machine size.
Scene flat_triangles(int pixels, int digits, Fill fill) {
    Scene scene;
    scene.canvas = {.width = 512, .height = 512, .origin = Origin::top_left};
    scene.method.fill = fill;
    std::mt19937_64 random(7);
    const int side = static_cast<int>(std::ceil(std::sqrt(2.0 * pixels)));
    const std::int64_t unit = power_of_ten(digits);
    const auto place = [&](std::int64_t below) {
        return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(below * unit));
    };
    const auto decimal = [digits](std::int64_t value) { return Number::decimal(value, -digits); };
    for (int i = 0; i < 2'000'000 / pixels + 1; ++i) {
        const std::int64_t x = place(512 - side - 2);
        const std::int64_t y = place(512 - side - 2);
        const std::int64_t lower = y + place(2);
        const std::int64_t farther = x + place(2);
        add_triangle(scene, {SceneVertex{"A", decimal(x), decimal(y)},
                             SceneVertex{"B", decimal(x + side * unit), decimal(lower)},
                             SceneVertex{"C", decimal(farther), decimal(y + side * unit)}});
    }
    return scene;
}

/// A torus of 2 x 250 x 200 triangles in a perspective, against a depth buffer.
Scene torus(Fill fill, Shade shade) {
    constexpr int around = 250, across = 200;
    Scene scene;
    scene.canvas = {.width = 800, .height = 800};
    scene.method.fill = fill;
    scene.method.shade = shade;
    const auto decimal = [](double value) {
        return Number::decimal(std::llround(value * 1e6), -6);
    };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double u = 2 * 3.14159265358979 * i / around;
            const double v = 2 * 3.14159265358979 * j / across;
            const double radius = 1 + 0.4 * std::cos(v);
            scene.vertices.push_back(
                {"V", decimal(radius * std::cos(u)), decimal(0.4 * std::sin(v)),
                 Color{static_cast<std::uint8_t>(i), 80, 20}, decimal(radius * std::sin(u))});
        }
    for (std::size_t i = 0; i < around; ++i)
        for (std::size_t j = 0; j < across; ++j) {
            const std::size_t next_i = (i + 1) % around, next_j = (j + 1) % across;
            const std::size_t a = i * across + j, b = next_i * across + j;
            const std::size_t c = next_i * across + next_j, d = i * across + next_j;
            for (const auto& corners : {std::array{a, b, c}, std::array{a, c, d}})
                scene.primitives.push_back({.kind = PrimitiveKind::triangle,
                                            .name = "T",
                                            .vertices = corners,
                                            .color = {200, 80, 20}});
        }
    scene.camera = Camera{.position = {1, 2, 3}, .look_at = {0, 0, 0}, .up = {0, 1, 0}};
    scene.projection = {.type = ProjectionType::frustum};
    scene.projection.fov_y = Number(40);
    scene.projection.near = Number(1);
    scene.projection.far = Number(10);
    scene.viewport = {.type = ViewportType::pixels, .pixels_per_unit = 1};
    return scene;
}

void picture(benchmark::State& state, Scene scene, ScalarKind scalar) {
    scene.method.scalar = scalar;
    Fallbacks fallbacks;
    for (auto _ : state) {
        const Plan plan = plan_for(scene);
        const Image image = draw(scene, plan, {}, &fallbacks);
        benchmark::DoNotOptimize(image.colors().data());
    }
    if (scalar == ScalarKind::adaptive) {
        state.counters["fallback_%"] = 100 * static_cast<double>(fallbacks.primitives) /
                                       static_cast<double>(scene.primitives.size());
        state.counters["exact_depths"] = static_cast<double>(fallbacks.depths);
    }
}

/// Every scalar on every scene; names say scene/scalar.
const bool scalars_are_registered = [] {
    struct Case {
        std::string name;
        std::function<Scene()> scene;
        bool has_exact; ///< in a time worth waiting for
    };
    std::vector<Case> cases;
    for (const auto& [fill, name] :
         {std::pair(Fill::scanline, "scanline"), std::pair(Fill::top_left, "top-left")})
        for (const int pixels : {10'000, 100, 2})
            for (const int digits : {2, 15})
                cases.push_back({name + std::string("/") + std::to_string(pixels) + "px/" +
                                     std::to_string(digits) + "digits",
                                 [=, fill = fill] { return flat_triangles(pixels, digits, fill); },
                                 digits == 2});
    cases.push_back({"torus/top-left", [] { return torus(Fill::top_left, Shade::flat); }, false});
    cases.push_back({"torus/scanline", [] { return torus(Fill::scanline, Shade::flat); }, false});
    cases.push_back(
        {"torus/top-left/colors", [] { return torus(Fill::top_left, Shade::interpolate); }, false});
    for (const Case& one : cases)
        for (const auto& [scalar, word] :
             {std::pair(ScalarKind::double_precision, "double"),
              std::pair(ScalarKind::adaptive, "adaptive"), std::pair(ScalarKind::exact, "exact")})
            if (scalar != ScalarKind::exact || one.has_exact)
                benchmark::RegisterBenchmark(
                    ("scalars/" + one.name + "/" + word).c_str(),
                    [scene = one.scene, scalar = scalar](benchmark::State& state) {
                        picture(state, scene(), scalar);
                    })
                    ->Unit(benchmark::kMillisecond);
    return true;
}();

} // namespace
} // namespace rastertrace
