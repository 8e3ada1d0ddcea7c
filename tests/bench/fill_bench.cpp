// SPDX-License-Identifier: MIT
// Fills with a sink that keeps nothing, next to the loop that well-known teaching renderers use:
// glm barycentric coordinates for each pixel of the box. Canvas 512 x 512, flat color.

#include <rastertrace/core/draw/paint/fill.h>
#include <rastertrace/core/draw/paint/row_painter.h>
#include <rastertrace/core/raster/flat_painter.h>

#include <benchmark/benchmark.h>

#include <glm/glm.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <random>
#include <vector>

/// With all that it calls inlined, as in a program of one fill, whose canvas the compiler knows.
#define INLINED __attribute__((flatten))

namespace rastertrace {
namespace {

/// Triangles of about `pixels` pixels each on a square canvas, on a grid of 1/16 pixel.
template <typename Scalar>
std::vector<Triangle<Scalar>> triangles(int pixels, std::size_t count, int canvas = 512) {
    std::mt19937_64 random(7);
    int side = 1;
    while (side * side / 2 < pixels)
        ++side;
    std::vector<Triangle<Scalar>> result;
    for (std::size_t i = 0; i < count; ++i) {
        const auto sixteenths = [&random](int below) {
            return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(16 * below + 1));
        };
        const std::int64_t x = sixteenths(canvas - side);
        const std::int64_t y = sixteenths(canvas - side);
        const auto at = [](std::int64_t value) {
            if constexpr (std::floating_point<Scalar>)
                return static_cast<Scalar>(value) / 16;
            else
                return Scalar{value * 16, 256};
        };
        result.push_back({{{{at(x), at(y)},
                            {at(x + 16 * side), at(y + sixteenths(2))},
                            {at(x + sixteenths(2)), at(y + 16 * side)}}}});
    }
    return result;
}

struct CountingSink {
    std::uint64_t steps = 0;
    template <typename Step> void operator()(const Step&) { ++steps; }
};

/// Runs `fill_one` on every triangle of about as many pixels as the benchmark's argument says.
template <typename Scalar, typename FillOne> void run(benchmark::State& state, FillOne&& fill_one) {
    const auto pixels = static_cast<int>(state.range(0));
    const auto all = triangles<Scalar>(pixels, static_cast<std::size_t>(2'000'000 / pixels + 1));
    Image image({.width = 512, .height = 512, .origin = Origin::top_left});
    for (auto _ : state)
        for (const auto& triangle : all)
            fill_one(triangle, image);
    benchmark::DoNotOptimize(image.colors().data());
    state.counters["triangles"] = benchmark::Counter(static_cast<double>(all.size()) *
                                                         static_cast<double>(state.iterations()),
                                                     benchmark::Counter::kIsRate);
}

/// Samples at the centers of the pixels of a square canvas.
template <typename Scalar> SampleGrid<Scalar> centers(int side) {
    const Canvas canvas{.width = side, .height = side, .origin = Origin::top_left};
    if constexpr (std::floating_point<Scalar>)
        return {{Scalar(0.5), Scalar(0.5)}, canvas};
    else
        return {{Scalar{128, 256}, Scalar{128, 256}}, canvas};
}

enum class Rows { closed, half_open, centers };

template <typename Scalar, typename Sink, Rows rows = Rows::closed>
void scanline(benchmark::State& state) {
    Sink sink;
    const auto centered = centers<Scalar>(512).offset();
    run<Scalar>(state, [&](const Triangle<Scalar>& triangle, Image& image) INLINED {
        constexpr bool is_half_open = rows == Rows::half_open;
        constexpr ScanlineRules rules{
            .span = {.rounding = is_half_open ? Rounding::half_open : Rounding::floor},
            .rows = is_half_open ? RowRule::half_open : RowRule::closed};
        const auto offset = rows == Rows::centers ? centered : SampleOffset<Scalar>();
        fill_scanline(triangle, offset, rules, image.canvas(), FlatPainter(image, Color{}, sink));
    });
}

/// `fixed` is this one: fractions over 256 on 64 bits.
template <typename Scalar> void top_left(benchmark::State& state) {
    const auto grid = centers<Scalar>(512);
    run<Scalar>(state, [&grid](const Triangle<Scalar>& triangle, Image& image) INLINED {
        fill_top_left(triangle, grid, image.canvas(), FlatPainter(image, Color{}));
    });
}

/// The textbook's loop over the box of a triangle: `use` gets each pixel of a canvas of `side` x `side`, and its weights.
template <typename Use>
void for_each_in_box(const Triangle<double>& triangle, int side, Use&& use) {
    const glm::vec2 a(triangle.vertices[0]), b(triangle.vertices[1]), c(triangle.vertices[2]);
    const glm::vec2 last(static_cast<float>(side - 1));
    const glm::vec2 low = glm::max(glm::floor(glm::min(a, glm::min(b, c))), glm::vec2(0));
    const glm::vec2 high = glm::min(glm::ceil(glm::max(a, glm::max(b, c))), last);
    for (int y = static_cast<int>(low.y); y <= static_cast<int>(high.y); ++y)
        for (int x = static_cast<int>(low.x); x <= static_cast<int>(high.x); ++x) {
            const glm::vec2 p(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            const glm::vec3 cross = glm::cross(glm::vec3(b.x - a.x, c.x - a.x, a.x - p.x),
                                               glm::vec3(b.y - a.y, c.y - a.y, a.y - p.y));
            use(Pixel{x, y}, glm::vec3(1.0F - (cross.x + cross.y) / cross.z, cross.x / cross.z,
                                       cross.y / cross.z));
        }
}

void glm_barycentric(benchmark::State& state) {
    run<double>(state, [](const Triangle<double>& triangle, Image& image) {
        for_each_in_box(triangle, 512, [&image](Pixel pixel, const glm::vec3& weights) INLINED {
            if (weights.x >= 0 && weights.y >= 0 && weights.z >= 0)
                image.at(pixel) = Color{};
        });
    });
}

/// The same against a depth buffer of 1/z: triangles that come nearer and nearer, so that every
/// pixel passes, on a canvas of `side` x `side`.
template <typename Scalar, typename FillOne>
void run_with_depth(benchmark::State& state, FillOne&& fill_one) {
    const auto pixels = static_cast<int>(state.range(0));
    const auto side = static_cast<int>(state.range(1));
    const auto all =
        triangles<Scalar>(pixels, static_cast<std::size_t>(2'000'000 / pixels + 1), side);
    Image image({.width = side, .height = side, .origin = Origin::top_left});
    DepthTests<DepthOf<Scalar>> buffer({.left = 0, .top_row = 0, .width = side, .height = side},
                                       {.larger_passes = true, .cleared = 0});
    double nearness = 1;
    for (auto _ : state)
        for (const auto& triangle : all) {
            nearness += 0x1p-20;
            fill_one(triangle, std::array{nearness, nearness + 0x1p-22, nearness + 0x1p-21}, image,
                     buffer);
        }
    benchmark::DoNotOptimize(image.colors().data());
}

template <typename Scalar> void top_left_with_depth(benchmark::State& state) {
    const auto grid = centers<Scalar>(static_cast<int>(state.range(1)));
    run_with_depth<Scalar>(state, [&grid](const Triangle<Scalar>& triangle,
                                          const std::array<double, 3>& depths, Image& image,
                                          auto& buffer) INLINED {
        using D = DepthOf<Scalar>;
        const TriangleDepth<D> depth(depth_positions(triangle),
                                     {D(depths[0]), D(depths[1]), D(depths[2])},
                                     buffer.larger_passes());
        const auto plane = depth.plane({D(0.5), D(0.5)});
        fill_top_left(triangle, grid, image.canvas(),
                      PlanePainter<Scalar>(image, Color{}, plane, buffer));
    });
}

/// With a depth buffer: it divides at every pixel of the box.
void glm_barycentric_with_depth(benchmark::State& state) {
    const auto side = static_cast<int>(state.range(1));
    std::vector<float> z_buffer(static_cast<std::size_t>(side) * static_cast<std::size_t>(side),
                                1e9F);
    run_with_depth<double>(state, [&](const Triangle<double>& triangle,
                                      const std::array<double, 3>& depths, Image& image,
                                      DepthTests<double>&) {
        const glm::vec3 inverse_z(depths[0], depths[1], depths[2]);
        for_each_in_box(triangle, side, [&](Pixel pixel, const glm::vec3& weights) INLINED {
            if (weights.x < 0 || weights.y < 0 || weights.z < 0)
                return;
            const float z = 1 / glm::dot(weights, inverse_z);
            float& stored = z_buffer[image.canvas().offset_of(pixel)];
            if (z < stored) {
                stored = z;
                image.at(pixel) = Color{};
            }
        });
    });
}

void sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->Arg(100'000)->Arg(100)->Arg(2)->Unit(benchmark::kMillisecond);
}
BENCHMARK(glm_barycentric)->Apply(sizes);
BENCHMARK(top_left<Fraction64>)->Apply(sizes);
BENCHMARK(top_left<double>)->Apply(sizes);
BENCHMARK(scanline<Fraction64, NullSink>)->Apply(sizes);
BENCHMARK(scanline<double, NullSink>)->Apply(sizes);
BENCHMARK(scanline<double, NullSink, Rows::half_open>)->Apply(sizes);
BENCHMARK(scanline<double, NullSink, Rows::centers>)->Apply(sizes);
BENCHMARK(scanline<Fraction64, NullSink, Rows::half_open>)->Apply(sizes);
BENCHMARK(scanline<Fraction64, NullSink, Rows::centers>)->Apply(sizes);
BENCHMARK(scanline<double, CountingSink>)->Apply(sizes);
void sizes_with_depth(benchmark::internal::Benchmark* benchmark) {
    for (const int side : {512, 2048})
        for (const int pixels : {100'000, 100, 2})
            benchmark->Args({pixels, side});
    benchmark->Unit(benchmark::kMillisecond);
}
BENCHMARK(glm_barycentric_with_depth)->Apply(sizes_with_depth);
BENCHMARK(top_left_with_depth<Fraction64>)->Apply(sizes_with_depth);
BENCHMARK(top_left_with_depth<double>)->Apply(sizes_with_depth);

} // namespace
} // namespace rastertrace
