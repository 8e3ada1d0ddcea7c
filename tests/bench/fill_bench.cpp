// SPDX-License-Identifier: MIT
// The scanline fill with a sink that keeps nothing and one that counts, in double and in fractions.

#include <rastertrace/core/draw.h>

#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <vector>

namespace rastertrace {
namespace {

/// Triangles of about `pixels` pixels each on a canvas of 512 x 512, on a grid of 1/16 pixel.
template <typename Scalar> std::vector<Triangle<Scalar>> triangles(int pixels, std::size_t count) {
    std::mt19937_64 random(7);
    int side = 1;
    while (side * side / 2 < pixels)
        ++side;
    std::vector<Triangle<Scalar>> result;
    for (std::size_t i = 0; i < count; ++i) {
        const auto sixteenths = [&random](int below) {
            return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(16 * below + 1));
        };
        const std::int64_t x = sixteenths(512 - side);
        const std::int64_t y = sixteenths(512 - side);
        const auto at = [](std::int64_t value) {
            if constexpr (std::floating_point<Scalar>)
                return static_cast<Scalar>(value) / 16;
            else
                return Scalar{value, 16};
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

template <typename Scalar, typename Sink> void fill(benchmark::State& state) {
    const auto pixels = static_cast<int>(state.range(0));
    const auto all =
        triangles<Scalar>(pixels, static_cast<std::size_t>(20'000'000 / pixels / 10 + 1));
    Image image({.width = 512, .height = 512, .origin = Origin::top_left});
    Sink sink;
    for (auto _ : state)
        for (const auto& triangle : all)
            fill_scanline(triangle, Paint<Scalar>{}, {}, image, sink);
    benchmark::DoNotOptimize(image.colors().data());
    state.counters["triangles"] = benchmark::Counter(static_cast<double>(all.size()) *
                                                         static_cast<double>(state.iterations()),
                                                     benchmark::Counter::kIsRate);
}

BENCHMARK(fill<double, NullSink>)->Arg(100'000)->Arg(100)->Arg(2)->Unit(benchmark::kMillisecond);
BENCHMARK(fill<Fraction64, NullSink>)
    ->Arg(100'000)
    ->Arg(100)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(fill<double, CountingSink>)
    ->Arg(100'000)
    ->Arg(100)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace rastertrace
