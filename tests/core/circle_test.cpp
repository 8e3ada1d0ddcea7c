// SPDX-License-Identifier: MIT
#include "picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using Points = std::vector<std::pair<Index, Index>>;

/// What a circle reported.
struct CircleRecorder {
    Points pixels;
    Points decided_at;
    std::vector<std::int64_t> decisions;
    std::vector<Move> moves;
    Points rejected;
    std::vector<SkipReason> skipped;

    template <typename Step> void operator()(const Step& step) {
        if constexpr (std::same_as<Step, PixelPlotted<>>) {
            pixels.emplace_back(step.x, step.y);
        } else if constexpr (std::same_as<Step, LineDecided<>>) {
            decided_at.emplace_back(step.x, step.y);
            decisions.push_back(step.d);
            moves.push_back(step.move);
        } else if constexpr (std::same_as<Step, PixelsRejected<>>) {
            EXPECT_FALSE(step.to_x || step.to_y) << "one pixel";
            rejected.emplace_back(*step.x, *step.y);
        } else if constexpr (std::same_as<Step, PrimitiveSkipped<>>) {
            skipped.push_back(step.why);
        }
    }
};

Scene circle_scene(const Number& x, const Number& y, std::int32_t radius, Canvas canvas,
                   ScalarKind scalar = ScalarKind::exact) {
    Scene scene;
    scene.canvas = canvas;
    scene.method.scalar = scalar;
    scene.vertices = {{"O", x, y}};
    scene.primitives = {
        {.kind = PrimitiveKind::circle, .name = "k", .vertices = {0}, .radius = radius}};
    return scene;
}

CircleRecorder circle(const Scene& scene) {
    CircleRecorder recorder;
    draw_as_planned(scene, recorder);
    return recorder;
}

CircleRecorder circle(std::int32_t radius) {
    const int side = 2 * radius + 3;
    return circle(circle_scene(0, 0, radius, {.width = side, .height = side}));
}

/// The pixels of a circle around (0, 0), each decided by itself: with its distances a <= b from the
/// center along the axes, the points half a pixel before and behind it along b lie inside and
/// outside. Four times the squares are whole numbers.
std::set<std::pair<Index, Index>> pixels_by_their_midpoints(Index radius) {
    std::set<std::pair<Index, Index>> pixels;
    if (radius == 0)
        pixels.emplace(0, 0);
    for (Index x = -radius; x <= radius; ++x)
        for (Index y = -radius; y <= radius; ++y) {
            const auto [a, b] = std::minmax({std::abs(x), std::abs(y)});
            const Index square = 4 * radius * radius;
            if (b > 0 && 4 * a * a + (2 * b - 1) * (2 * b - 1) < square &&
                square < 4 * a * a + (2 * b + 1) * (2 * b + 1))
                pixels.emplace(x, y);
        }
    return pixels;
}

/// Hearn and Baker, Computer Graphics, the example after the midpoint circle algorithm: the
/// decision parameters and the pixels of an octant of a circle of radius 10.
TEST(Circle, HasThePixelsAndDecisionsOfTheTextbook) {
    const CircleRecorder ten = circle(10);
    EXPECT_EQ(ten.decisions, (std::vector<std::int64_t>{-9, -6, -1, 6, -3, 8, 5}));
    EXPECT_EQ(ten.decided_at, (Points{{0, 10}, {1, 10}, {2, 10}, {3, 10}, {4, 9}, {5, 9}, {6, 8}}));
    EXPECT_EQ(ten.moves,
              (std::vector{Move::e, Move::e, Move::e, Move::se, Move::e, Move::se, Move::se}));
    EXPECT_EQ(ten.pixels.back(), (std::pair<Index, Index>{-7, 7}));
    EXPECT_EQ(ten.pixels.size(), 4U + 6 * 8 + 4);
}

TEST(Circle, IsARing) {
    EXPECT_EQ(picture_of(draw_as_planned(circle_scene(0, 0, 3, {.width = 9, .height = 9}))),
              ".........\n"
              "...###...\n"
              "..#...#..\n"
              ".#.....#.\n"
              ".#.....#.\n"
              ".#.....#.\n"
              "..#...#..\n"
              "...###...\n"
              ".........\n");
    EXPECT_EQ(picture_of(draw_as_planned(circle_scene(1, 0, 0, {.width = 3, .height = 1}))),
              "..#\n");
}

TEST(Circle, HasThePixelsWhoseMidpointsLieOnBothSides) {
    std::vector<std::int32_t> radii{100, 127, 128, 500};
    for (std::int32_t radius = 0; radius <= 64; ++radius)
        radii.push_back(radius);
    for (const std::int32_t radius : radii) {
        const Points drawn = circle(radius).pixels;
        const std::set<std::pair<Index, Index>> pixels(drawn.begin(), drawn.end());
        EXPECT_EQ(pixels.size(), drawn.size()) << "a pixel twice, radius " << radius;
        EXPECT_EQ(pixels, pixels_by_their_midpoints(radius)) << radius;
    }
}

TEST(Circle, IsSymmetricAndConnected) {
    for (std::int32_t radius = 0; radius <= 64; ++radius) {
        const Points drawn = circle(radius).pixels;
        std::set<std::pair<Index, Index>> left(drawn.begin(), drawn.end());
        for (const auto& [x, y] : drawn)
            EXPECT_TRUE(left.contains({-x, y}) && left.contains({y, x})) << radius;

        // All can be reached from the first one.
        Points reached{drawn.front()};
        left.erase(drawn.front());
        while (!reached.empty()) {
            const auto [x, y] = reached.back();
            reached.pop_back();
            for (const Index dx : {-1, 0, 1})
                for (const Index dy : {-1, 0, 1})
                    if (left.erase({x + dx, y + dy}) > 0)
                        reached.emplace_back(x + dx, y + dy);
        }
        EXPECT_TRUE(left.empty()) << radius;
    }
}

TEST(Circle, GoesAroundThePixelNearestToItsCenterInEveryScalar) {
    const Canvas canvas{.width = 21, .height = 21};
    const Points whole = circle(circle_scene(2, -1, 5, canvas)).pixels;
    for (const ScalarKind scalar : {ScalarKind::single_precision, ScalarKind::double_precision,
                                    ScalarKind::fixed, ScalarKind::adaptive, ScalarKind::exact})
        // A half goes up.
        EXPECT_EQ(circle(circle_scene(number("3/2"), number("-5/4"), 5, canvas, scalar)).pixels,
                  whole);
}

TEST(Circle, IsCutOffByTheCanvasPixelByPixel) {
    for (const Origin origin : {Origin::center, Origin::bottom_left, Origin::top_left}) {
        const Canvas canvas{.width = 12, .height = 9, .origin = origin};
        for (const int at : {-9, -6, -1, 0, 4, 8, 13}) {
            const CircleRecorder drawn = circle(circle_scene(at, 3, 6, canvas));
            Points on_canvas;
            Points dropped;
            for (const auto& [x, y] : pixels_by_their_midpoints(6))
                (canvas.contains(x + at, y + 3) ? on_canvas : dropped).emplace_back(x + at, y + 3);
            Points pixels = drawn.pixels;
            std::sort(pixels.begin(), pixels.end());
            Points rejected = drawn.rejected;
            std::sort(rejected.begin(), rejected.end());
            EXPECT_EQ(pixels, on_canvas) << at;
            if (drawn.skipped.empty()) {
                EXPECT_EQ(rejected, dropped) << at;
                EXPECT_EQ(drawn.decisions, circle(6).decisions) << "off the canvas, too";
            }
        }
    }
    // Around the canvas, and nowhere near it.
    const Canvas small{.width = 3, .height = 3};
    EXPECT_TRUE(circle(circle_scene(0, 0, 9, small)).pixels.empty());
    EXPECT_EQ(circle(circle_scene(0, 0, 9, small)).rejected.size(),
              pixels_by_their_midpoints(9).size());
    for (const Number& far : {Number(6), Number(-6), number("1000000000000000")}) {
        const CircleRecorder none = circle(circle_scene(far, 0, 4, small));
        EXPECT_EQ(none.skipped, std::vector{SkipReason::off_canvas});
        EXPECT_TRUE(none.decisions.empty() && none.rejected.empty());
        EXPECT_EQ(circle(circle_scene(0, far, 4, small)).skipped, none.skipped);
    }
}

} // namespace
} // namespace rastertrace
