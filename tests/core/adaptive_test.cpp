// SPDX-License-Identifier: MIT
// adaptive takes every decision that exact takes.

#include "edge_scenes.h"
#include "effort.h"
#include "picture.h"
#include "random_choice.h"
#include "scene_text.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

/// Writes down what was decided, and leaves out the numbers that it was decided by.
class Decisions {
public:
    std::vector<std::int64_t> all;
    int undecided = 0;

    template <typename S> void operator()(const ScanlineSpanned<S>& s) {
        add({1, s.y, s.from, s.to});
    }
    template <typename S> void operator()(const SampleTested<S>& s) {
        add({2, s.x, s.y, s.inside});
    }
    template <typename S> void operator()(const DepthTested<S>& s) { add({3, s.x, s.y, s.pass}); }
    template <typename S> void operator()(const LineSampled<S>& s) {
        add({4, s.x.value_or(0) + s.y.value_or(0), s.pixel});
    }
    template <typename S> void operator()(const FaceTested<S>& s) {
        add({5, s.culled, s.opposite});
    }
    template <typename S> void operator()(const FaceLit<S>& s) { add({6, as_number(s.color)}); }
    template <typename S> void operator()(const EdgeSetUp<S>& s) {
        add({7, s.dx_dy && !*s.dx_dy, s.top_left.value_or(false), s.octant.value_or(0)});
    }
    template <typename S> void operator()(const PrimitiveBegan<S>& s) {
        EXPECT_TRUE(undecided_name_.empty() || undecided_name_ == s.name);
        undecided_name_.clear();
        add({9, static_cast<std::int64_t>(s.vertices.size()), as_number(s.color)});
    }
    template <typename S> void operator()(const MatrixSetUp<S>&) { add({10}); }
    template <typename S> void operator()(const VertexPlaced<S>& s) {
        add({11, static_cast<std::int64_t>(s.space)});
    }
    template <typename S> void operator()(const PrimitivesOrdered<S>& s) {
        for (const auto name : s.names)
            add({12, name.back()});
    }
    void operator()(const PrimitiveClipped<>& s) { add({13, *s.out}); }
    void operator()(const HalfBegan<>& s) { add({15, *s.from_y, *s.to_y}); }
    void operator()(const RayBegan<>&) { add({16}); }
    void operator()(const LineDecided<>& s) { add({17, s.x, s.y}); }
    void operator()(const PixelPlotted<>& s) { add({18, s.x, s.y, as_number(s.color)}); }
    void operator()(const PixelsRejected<>& s) {
        add({19, s.x.value_or(0), *s.y, s.to_x.value_or(0), s.to_y.value_or(0)});
    }
    void operator()(const PrimitiveSkipped<>& s) { add({21, static_cast<std::int64_t>(s.why)}); }
    void operator()(const BoundExceeded<>& s) {
        EXPECT_FALSE(std::abs(s.difference.value_or(0)) > s.error.value_or(0) * 1.0001)
            << "that was decided";
        EXPECT_TRUE(undecided_name_.empty());
        undecided_name_ = s.name;
        ++undecided;
    }

private:
    static std::int64_t as_number(Color color) {
        return (color.red() << 24) + (color.green() << 16) + (color.blue() << 8) + color.alpha();
    }
    void add(std::initializer_list<std::int64_t> numbers) {
        EXPECT_TRUE(undecided_name_.empty()) << "its primitive begins directly after it";
        all.insert(all.end(), numbers.begin(), numbers.end());
    }

    std::string undecided_name_; ///< of the step before
};

Decisions decisions_of(Scene scene, ScalarKind scalar, Colors& picture) {
    scene.method.scalar = scalar;
    Decisions decisions;
    picture = draw_as_planned(scene, decisions).colors();
    return decisions;
}

/// Moves every corner by less than any double near it can tell, so that no fractions of machine size
/// fit: what lay on an edge now lies a hair to one side, and the rest lies just where it looked.
Scene nudged(Scene scene, std::mt19937_64& random) {
    for (SceneVertex& vertex : scene.vertices)
        for (Number* const coordinate : {&vertex.x, &vertex.y, &vertex.z}) {
            const auto digits = static_cast<std::int64_t>(random() % 5) - 2;
            const int places = -17 - static_cast<int>(random() % 16);
            *coordinate =
                Number::fraction(coordinate->exact() + Number::decimal(digits, places).exact());
        }
    return scene;
}

/// How many scenes are drawn; scripts/check-adaptive.sh asks for more.
int scenes_to_draw() {
    const char* const asked = std::getenv("RASTERTRACE_ADAPTIVE_SCENES");
    return asked ? std::atoi(asked) : random_cases(4000);
}

/// The numbers of all edges and rows: of primitives that are told in doubles, as doubles tell them.
struct NumbersTold {
    std::vector<double> numbers;
    int in_fractions = 0;

    void operator()(const BoundExceeded<>&) { ++in_fractions; }
    void operator()(const EdgeSetUp<>& step) {
        numbers.push_back(step.dx_dy && *step.dx_dy ? (*step.dx_dy)->to_double() : 0);
    }
    void operator()(const ScanlineSpanned<>& step) {
        numbers.insert(numbers.end(), {step.left.to_double(), step.right.to_double()});
    }
    void operator()(const SampleTested<>& step) {
        for (const Quantity& weight : step.weights)
            numbers.push_back(weight.to_double());
    }
};

TEST(Adaptive, TellsWhatDoublesTellWhereTheyDecide) {
    EdgeScenes scenes(29);
    std::mt19937_64 random(29);
    int decided = 0;
    for (int i = 0; i < random_cases(5000); ++i) {
        Scene scene = scenes.next();
        // Vertices as typed that fit in no fraction of machine size, and seldom lie on a sample.
        if (scene.has_pipeline() || scene.method.fill == Fill::fan)
            continue;
        for (SceneVertex& vertex : scene.vertices)
            for (Number* const coordinate : {&vertex.x, &vertex.y})
                *coordinate = Number::fraction(
                    coordinate->exact() + Rational(static_cast<unsigned>(random() % 997), 997) +
                    Number::decimal(1, -30).exact());
        scene.method.scalar = ScalarKind::exact;
        if (find_unfit(scene))
            continue;
        scene.method.scalar = ScalarKind::adaptive;
        NumbersTold adaptive, in_double;
        draw_as_planned(scene, adaptive);
        scene.method.scalar = ScalarKind::double_precision;
        draw_as_planned(scene, in_double);
        if (adaptive.in_fractions > 0)
            continue;
        ++decided;
        ASSERT_EQ(adaptive.numbers, in_double.numbers) << scene_text(scene);
    }
    EXPECT_GT(decided, random_cases(50));
}

TEST(Adaptive, DrawsTheSameWhoeverListens) {
    // Who takes no pixels is told of a primitive when it is painted; who does, while it is.
    EdgeScenes scenes(31);
    std::mt19937_64 random(31);
    int skipped = 0;
    for (int i = 0; i < random_cases(1000); ++i) {
        Scene scene = scenes.next();
        if (random() % 2 == 0)
            scene = nudged(scene, random);
        scene.method.scalar = ScalarKind::adaptive;
        if (find_unfit(scene))
            continue;
        std::vector<SkipReason> with_pixels;
        std::vector<SkipReason> without;
        const Image told = draw_as_planned(scene, [&]<typename Step>(const Step& step) {
            if constexpr (std::same_as<Step, PrimitiveSkipped<>>)
                with_pixels.push_back(step.why);
        });
        const Image skips_told = draw_as_planned(
            scene, [&](const PrimitiveSkipped<>& step) { without.push_back(step.why); });
        ASSERT_EQ(skips_told.colors(), told.colors()) << scene_text(scene);
        ASSERT_EQ(draw_as_planned(scene).colors(), told.colors()) << scene_text(scene);
        ASSERT_EQ(without, with_pixels) << scene_text(scene);
        skipped += without.empty() ? 0 : 1;
    }
    EXPECT_GT(skipped, 0);
}

TEST(Adaptive, DecidesAsExact) {
    EdgeScenes scenes(7);
    std::mt19937_64 random(7);
    int drawn = 0, fallen_back = 0;
    while (drawn < scenes_to_draw()) {
        Scene scene = scenes.next();
        if (random() % 2 == 0)
            scene = nudged(scene, random);
        scene.method.scalar = ScalarKind::exact;
        // A plan may leave more out where numbers are exact; in full, all decisions are seen.
        const StageSet needed = scene.keep;
        scene.keep = StageSet::all();
        if (find_unfit(scene))
            continue;
        ++drawn;
        Colors exact_picture, adaptive_picture;
        const Decisions exact = decisions_of(scene, ScalarKind::exact, exact_picture);
        const Decisions adaptive = decisions_of(scene, ScalarKind::adaptive, adaptive_picture);
        ASSERT_EQ(exact.all, adaptive.all) << scene_text(scene);
        ASSERT_TRUE(exact_picture == adaptive_picture) << scene_text(scene);
        fallen_back += adaptive.undecided > 0;

        // Planned, and with the sink that keeps nothing, it draws the same.
        scene.keep = needed;
        scene.method.scalar = ScalarKind::adaptive;
        ASSERT_TRUE(draw_as_planned(scene).colors() == exact_picture) << scene_text(scene);
    }
    EXPECT_GT(fallen_back, drawn / 4) << "these scenes are made to be undecided";
}

TEST(Adaptive, DecidesWithinAnUlpOfAnEdge) {
    // The third corner lies within a few ulps of the line through the other two: most of these
    // triangles have no area in doubles, or one of the wrong sign.
    std::mt19937_64 random(11);
    const auto whole = [&random](int below) {
        return static_cast<int>(random() % static_cast<std::uint64_t>(below));
    };
    int undecided = 0;
    for (int i = 0; i < random_cases(3000); ++i) {
        std::array<double, 6> at{};
        for (double& coordinate : at)
            coordinate = whole(12 * 1024) / 1024.0 + whole(3) / 3.0;
        const double way = whole(1000) / 999.0;
        at[4] = at[0] + way * (at[2] - at[0]);
        at[5] = at[1] + way * (at[3] - at[1]);
        for (int ulps = whole(4); ulps > 0; --ulps)
            at[5] = std::nextafter(at[5], i % 2 == 0 ? 100 : -100);
        Scene scene = triangle_scene({"0", "0", "0", "0", "0", "0"},
                                     {.width = 12, .height = 12, .origin = Origin::top_left});
        for (std::size_t corner = 0; corner < 3; ++corner) {
            scene.vertices[corner].x = Number::fraction(mpq_class(at[2 * corner]));
            scene.vertices[corner].y = Number::fraction(mpq_class(at[2 * corner + 1]));
        }
        for (const Fill fill :
             {Fill::scanline, Fill::two_halves, Fill::barycentric, Fill::top_left}) {
            scene.method.fill = fill;
            Colors exact_picture, adaptive_picture;
            const Decisions exact = decisions_of(scene, ScalarKind::exact, exact_picture);
            const Decisions adaptive = decisions_of(scene, ScalarKind::adaptive, adaptive_picture);
            ASSERT_EQ(exact.all, adaptive.all) << scene_text(scene);
            ASSERT_TRUE(exact_picture == adaptive_picture) << scene_text(scene);
            undecided += adaptive.undecided;
        }
    }
    EXPECT_GT(undecided, random_cases(1000));
}

/// Triangles whose corners are given as x, y, z, tested against a depth buffer.
Scene triangles_in_depth(const std::vector<std::array<const char*, 9>>& triangles, Fill fill) {
    Scene scene;
    scene.canvas = {.width = 16, .height = 16, .origin = Origin::top_left};
    scene.method = {.scalar = ScalarKind::adaptive, .fill = fill, .depth = Depth::linear_z};
    scene.keep = StageSet::all();
    for (const auto& corners : triangles) {
        const std::size_t first = scene.vertices.size();
        for (std::size_t i = 0; i < 9; i += 3)
            scene.vertices.push_back(
                {"V", number(corners[i]), number(corners[i + 1]), {}, number(corners[i + 2])});
        scene.primitives.push_back({.kind = PrimitiveKind::triangle,
                                    .name = "T" + std::to_string(first),
                                    .vertices = {first, first + 1, first + 2},
                                    .color = {static_cast<std::uint8_t>(first + 1), 80, 20}});
    }
    return scene;
}

TEST(Adaptive, DepthsOfAnySizeAreDecidedAsExact) {
    // Depths whose differences, products and errors leave the doubles at either end.
    const std::vector<std::vector<std::array<const char*, 9>>> scenes{
        {{"0.1", "0.2", "1e307", "10", "0.3", "2e307", "0.7", "10", "3e307"},
         {"0.3", "0.25", "1.1e307", "10.5", "0.35", "1e306", "0.8", "11", "5e307"}},
        {{"0.1", "-0.1", "1.5e-60", "10.3", "-0.2", "1.5e-60", "0.2", "10.3", "1.5e-60"},
         {"1", "-1e-265", "1e-60", "2", "1e-265", "3e-60", "9.5", "3e-265", "9e-60"}},
        {{"-0.9", "-0.9", "1.6e308", "16.3", "-0.9", "1.6e308", "-0.9", "16.3", "1.6e308"},
         {"4.3", "0.4", "1e300", "0.3", "10.3", "1.5e308", "8.4", "10.4", "1.5e308"},
         {"12.3", "0.4", "1e307", "13.4", "0.4", "1e307", "12.3", "1.4", "1e307"},
         {"0.3", "0.3", "1.55e308", "10.3", "0.4", "1.55e308", "0.4", "10.3", "1.55e308"}}};
    for (const auto& triangles : scenes)
        for (const Fill fill :
             {Fill::scanline, Fill::two_halves, Fill::barycentric, Fill::top_left}) {
            Scene scene = triangles_in_depth(triangles, fill);
            Colors exact_picture, adaptive_picture;
            const Decisions exact = decisions_of(scene, ScalarKind::exact, exact_picture);
            const Decisions adaptive = decisions_of(scene, ScalarKind::adaptive, adaptive_picture);
            EXPECT_EQ(exact.all, adaptive.all) << triangles.front()[2];
            EXPECT_TRUE(exact_picture == adaptive_picture) << triangles.front()[2];
            for (const bool keeps_depth : {false, true}) {
                scene.keep = {};
                if (keeps_depth)
                    scene.keep.add(Stage::depth);
                EXPECT_TRUE(draw_as_planned(scene).colors() == exact_picture)
                    << triangles.front()[2];
            }
        }
}

TEST(Adaptive, DrawsWhatFitsInFractionsOfMachineSize) {
    const auto number_for = [](const Scene& scene) { return plan_for(scene).number; };
    EXPECT_EQ(number_for(first_triangle({.scalar = ScalarKind::adaptive})), NumberType::fraction64);
    Scene scene = triangle_scene({"1e-30", "0", "5", "0", "0", "5"}, {.width = 8, .height = 8},
                                 {.scalar = ScalarKind::adaptive});
    EXPECT_EQ(number_for(scene), NumberType::interval);
}

TEST(Adaptive, SaysHowOftenItFellBack) {
    // At y = 1 the edge CA is at x = 1.
    Scene scene = triangle_scene({"0.999999999999999999999999999999", "0", "5", "1",
                                  "1.000000000000000000000000000001", "2"},
                                 {.width = 12, .height = 12}, {.scalar = ScalarKind::adaptive});
    Fallbacks fallbacks;
    const Plan plan = plan_for(scene);
    draw(scene, plan, {}, &fallbacks);
    EXPECT_EQ(fallbacks.primitives, 1u);
    EXPECT_EQ(fallbacks.depths, 0u);
}

/// Fails unless a scene is decided as exact decides, with all stages and as planned. Returns how many
/// depth tests took exact depths.
std::uint64_t exact_tests_of(Scene scene) {
    scene.keep = StageSet::all();
    Colors exact_picture, adaptive_picture;
    const Decisions exact = decisions_of(scene, ScalarKind::exact, exact_picture);
    const Decisions adaptive = decisions_of(scene, ScalarKind::adaptive, adaptive_picture);
    EXPECT_EQ(exact.all, adaptive.all) << scene_text(scene);
    EXPECT_TRUE(exact_picture == adaptive_picture) << scene_text(scene);
    scene.keep = {};
    scene.method.scalar = ScalarKind::adaptive;
    Fallbacks fallbacks;
    const Image silent = draw(scene, plan_for(scene), {}, &fallbacks);
    EXPECT_TRUE(silent.colors() == exact_picture) << scene_text(scene);
    return fallbacks.depths;
}

TEST(Adaptive, PlanesThatCrossInALineAreDecidedAsExact) {
    // z = 1/3 + x/3 + y/7 and z = 1/3 + y/3 + x/7 are equal on the diagonal of the canvas.
    for (const Fill fill : {Fill::scanline, Fill::two_halves, Fill::barycentric, Fill::top_left}) {
        Scene scene =
            triangles_in_depth({{"1/3", "1/7", "1", "67/3", "1/7", "1", "1/3", "155/7", "1"},
                                {"1/7", "1/3", "1", "155/7", "1/3", "1", "1/7", "67/3", "1"}},
                               fill);
        for (std::size_t i = 0; i < 6; ++i) {
            SceneVertex& vertex = scene.vertices[i];
            const Rational x = vertex.x.exact(), y = vertex.y.exact();
            vertex.z = Number::fraction(Rational(1, 3) + x / (i < 3 ? 3 : 7) + y / (i < 3 ? 7 : 3));
        }
        EXPECT_GE(exact_tests_of(scene), 8u);
    }
}

TEST(Adaptive, CoplanarFacesAreDecidedAsExact) {
    // Both lie in z = 1/3 + x/7 + y/11: of equal depths, the first one stays.
    std::mt19937_64 random(23);
    const auto whole = [&random](int below) {
        return static_cast<int>(random() % static_cast<std::uint64_t>(below));
    };
    std::uint64_t exact_tests = 0;
    for (int i = 0; i < random_cases(200); ++i) {
        Scene scene = triangles_in_depth({{"0", "0", "1", "1", "0", "1", "0", "1", "1"},
                                          {"0", "0", "1", "1", "0", "1", "0", "1", "1"}},
                                         i % 2 == 0 ? Fill::top_left : Fill::scanline);
        for (SceneVertex& vertex : scene.vertices) {
            const Rational x(3 * whole(48) + 1, 9), y(3 * whole(48) + 2, 9);
            vertex.x = Number::fraction(x);
            vertex.y = Number::fraction(y);
            vertex.z = Number::fraction(Rational(1, 3) + x / 7 + y / 11);
        }
        scene.method.depth_at = i % 3 == 0 ? DepthAt::rounded_ends : DepthAt::pixel;
        exact_tests += exact_tests_of(scene);
    }
    EXPECT_GT(exact_tests, static_cast<std::uint64_t>(random_cases(200)));
}

TEST(Adaptive, FacesThatMeetInAnEdgeAreDecidedAsExact) {
    // Two triangles of four corners on a small grid: they share an edge or more, fold over it, have
    // sides that are horizontal, or no height at all.
    std::mt19937_64 random(23);
    const auto whole = [&random](int below) {
        return static_cast<int>(random() % static_cast<std::uint64_t>(below));
    };
    for (int i = 0; i < random_cases(1000); ++i) {
        Scene scene;
        scene.canvas = {.width = 8, .height = 8, .origin = Origin::top_left};
        scene.method = {.fill = i % 2 == 0 ? Fill::scanline : Fill::two_halves,
                        .depth = Depth::linear_z,
                        .depth_at = i % 3 == 0 ? DepthAt::rounded_ends : DepthAt::pixel};
        for (int corner = 0; corner < 4; ++corner)
            scene.vertices.push_back({std::string(1, static_cast<char>('A' + corner)),
                                      whole(7),
                                      whole(7),
                                      {},
                                      Number::fraction(Rational(1 + whole(9)) / 7)});
        for (std::size_t face = 0; face < 2; ++face) {
            const auto a = static_cast<std::size_t>(whole(4));
            scene.primitives.push_back({.kind = PrimitiveKind::triangle,
                                        .name = face == 0 ? "1" : "2",
                                        .vertices = {a, (a + 1) % 4, (a + 2 + face) % 4},
                                        .color = {200, static_cast<std::uint8_t>(face), 1}});
        }
        exact_tests_of(scene);
    }
}

TEST(Adaptive, VerticesAtOneDistanceLeaveNoColorOpen) {
    Scene scene =
        triangle_scene({"-7/3", "-5/3", "9/7", "-4/3", "1/7", "13/3"}, {.width = 32, .height = 32},
                       {.scalar = ScalarKind::adaptive, .fill = Fill::top_left});
    const std::array<Color, 3> colors{{{255, 10, 3}, {7, 200, 90}, {31, 60, 240}}};
    for (std::size_t i = 0; i < 3; ++i) {
        scene.vertices[i].z = number(i < 2 ? "7/3" : "11/3");
        scene.vertices[i].color = colors[i];
    }
    scene.projection = {.type = ProjectionType::pinhole};
    scene.projection.distance = Number(11);
    const Plan plan = plan_for(scene);
    ASSERT_EQ(plan.stages.pixels[0].colors, ColorStage::perspective);
    Fallbacks fallbacks;
    const Image picture = draw(scene, plan, {}, &fallbacks);
    EXPECT_GT(picture.drawn(), 100u);
    EXPECT_EQ(fallbacks.primitives, 0u);
}

} // namespace
} // namespace rastertrace
