// SPDX-License-Identifier: MIT
// Which mistake is in a picture: of one scene of 64 x 64 pixels, which is asked to take less than 1 s, and of a hundred
// scenes together on two cores, less than 10 s.

#include <rastertrace/trace/diagnose/diagnosis.h>
#include <rastertrace/trace/fuzz/fuzz_scene.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

constexpr std::size_t cores = 2;

/// Random triangles, and what comes of them with one mistake.
std::vector<DrawnPair> pairs(std::size_t count, const std::string& mistake) {
    std::vector<DrawnPair> drawn;
    for (std::uint64_t seed = 1; drawn.size() < count; ++seed) {
        const FuzzScene scene =
            random_scene(seed, {.kinds = {FuzzKind::plane}, .method = {}, .largest_canvas = 64});
        Source source{"scene.json", scene_json(scene)};
        const auto image = drawn_by(*rule_named(mistake), source);
        const bool is_large =
            count > 1 || (image && image->canvas().width > 55 && image->canvas().height > 55);
        if (image && is_large &&
            !std::ranges::equal(image->colors(), drawn_by({}, source)->colors()))
            drawn.push_back({std::move(source),
                             {image->canvas().width,
                              image->canvas().height,
                              {image->colors().begin(), image->colors().end()}}});
    }
    return drawn;
}

/// Ends the program if another mistake is found than was put in.
void diagnose_scenes(benchmark::State& state) {
    const auto drawn = pairs(static_cast<std::size_t>(state.range(0)), "height-plus-one");
    for (auto _ : state) {
        const Diagnosis found = diagnose(drawn, {.jobs = cores});
        if (found.answer.empty() || found.unexplained > 0)
            std::abort();
    }
}

BENCHMARK(diagnose_scenes)
    ->Name("diagnose")
    ->Arg(1)
    ->Arg(100)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
} // namespace rastertrace
