// SPDX-License-Identifier: MIT
// Random scenes that short numbers get wrong, and which of two scenes is the smaller one.

#include <rastertrace/trace/fuzz/shrink.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <vector>

namespace rastertrace {
namespace {

constexpr std::int64_t half = fuzz_unit / 2;

/// The edge function of a and b at a sample, times 2^20.
std::int64_t edge_at(const FuzzVertex& a, const FuzzVertex& b, std::int64_t x, std::int64_t y) {
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

std::set<std::int64_t> edges_at_samples(const FuzzScene& scene, const FuzzPrimitive& triangle) {
    std::set<std::int64_t> values;
    for (std::int64_t y = half; y < scene.height * fuzz_unit; y += fuzz_unit)
        for (std::int64_t x = half; x < scene.width * fuzz_unit; x += fuzz_unit)
            values.insert(edge_at(triangle.vertices[0], triangle.vertices[1], x, y));
    return values;
}

TEST(FuzzScenes, OneInEightHasASampleAsNearToAnEdgeAsItsGridAllows) {
    constexpr std::int64_t nearest = 16; // 1/65536
    std::size_t long_edges = 0;
    for (std::uint64_t seed = 8; seed <= 400; seed += 8) {
        const FuzzScene scene = random_scene(seed, {.has_near_ties = true});
        const FuzzPrimitive& last = scene.primitives.back();
        const auto values = edges_at_samples(scene, last);
        EXPECT_TRUE(values.contains(nearest) || values.contains(-nearest)) << seed;
        const std::int64_t dx = std::abs(last.vertices[1][0] - last.vertices[0][0]);
        const std::int64_t dy = std::abs(last.vertices[1][1] - last.vertices[0][1]);
        long_edges += std::max(dx, dy) >= 2000 * fuzz_unit ? 1 : 0;
    }
    EXPECT_GT(long_edges, 10u);
}

TEST(FuzzScenes, SomeLinesNeedMoreThan16Bits) {
    std::size_t long_lines = 0;
    for (std::uint64_t seed = 8; seed <= 800; seed += 8) {
        const FuzzScene scene =
            random_scene(seed, {.kinds = {FuzzKind::lines}, .has_near_ties = true});
        const auto& ends = scene.primitives.back().vertices;
        long_lines += std::max(std::abs(ends[1][0] - ends[0][0]),
                               std::abs(ends[1][1] - ends[0][1])) > 16'384 * fuzz_unit;
    }
    EXPECT_GT(long_lines, 10u);
}

TEST(FuzzScenes, WithoutThemASeedHasItsSceneOfBefore) {
    const FuzzScene with = random_scene(8, {.has_near_ties = true});
    const FuzzScene without = random_scene(8, {});
    EXPECT_EQ(with.primitives.size(), without.primitives.size() + 1);
    EXPECT_TRUE(std::equal(without.primitives.begin(), without.primitives.end(),
                           with.primitives.begin(),
                           [](const auto& a, const auto& b) { return a.vertices == b.vertices; }));
}

// What fails whatever w is ends with w = 1, not with the smaller number 0.
TEST(FuzzScenes, AVertexWithWOfOneIsSmallerThanOneWithNone) {
    for (const std::int64_t w : {std::int64_t{0}, 3 * fuzz_unit, -fuzz_unit / 4}) {
        const FuzzVertex vertex{fuzz_unit, 0, 0, w};
        FuzzScene scene{.kind = FuzzKind::clip, .width = 1, .height = 1};
        scene.primitives.push_back({.name = "T1", .vertices = {vertex, vertex, vertex}});
        const FuzzScene small = shrunk(
                                    scene, [](const FuzzScene&) { return true; }, 1000)
                                    .scene;
        EXPECT_EQ(small.primitives[0].vertices[0], (FuzzVertex{0, 0, 0, fuzz_unit})) << w;
    }
}

} // namespace
} // namespace rastertrace
