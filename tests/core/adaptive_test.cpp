// SPDX-License-Identifier: MIT
// adaptive takes every decision that exact takes; its errors are never larger than their bounds.

#include "edge_scenes.h"
#include "effort.h"
#include "picture.h"
#include "random_choice.h"
#include "scene_text.h"

#include <rastertrace/core/draw/filtered/exactly.h>
#include <rastertrace/core/numbers/adaptive.h>

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
        add({2, s.pixel.x, s.pixel.y, s.is_inside});
    }
    template <typename S> void operator()(const DepthTested<S>& s) {
        add({3, s.pixel.x, s.pixel.y, s.passes});
    }
    template <typename S> void operator()(const LineSampled<S>& s) { add({4, s.at, s.pixel}); }
    template <typename S> void operator()(const FaceTested<S>& s) {
        add({5, s.is_culled, s.is_culled_opposite});
    }
    template <typename S> void operator()(const FaceLit<S>& s) { add({6, as_number(s.color)}); }
    template <typename S> void operator()(const EdgeSetUp<S>& s) { add({7, s.is_horizontal}); }
    template <typename S> void operator()(const EdgeFunctionSetUp<S>& s) {
        add({8, s.is_top_left});
    }
    template <typename S> void operator()(const PrimitiveBegan<S>& s) {
        add({9, static_cast<std::int64_t>(s.vertices.size()), as_number(s.color)});
        has_just_begun_ = true;
    }
    template <typename S> void operator()(const MatrixSetUp<S>&) { add({10}); }
    template <typename S> void operator()(const VertexPlaced<S>& s) {
        add({11, static_cast<std::int64_t>(s.space)});
    }
    template <typename S> void operator()(const PrimitivesOrdered<S>& s) {
        for (const auto name : s.names)
            add({12, name.back()});
    }
    void operator()(const PrimitiveClipped& s) { add({13, s.left}); }
    void operator()(const SideBegan&) { add({14}); }
    void operator()(const HalfBegan& s) { add({15, s.from_y, s.to_y}); }
    void operator()(const RayBegan&) { add({16}); }
    void operator()(const LineDecided& s) { add({17, s.pixel.x, s.pixel.y}); }
    void operator()(const PixelPlotted& s) { add({18, s.pixel.x, s.pixel.y, as_number(s.color)}); }
    void operator()(const PixelsRejected& s) { add({19, s.from_x, s.from_y, s.to_x, s.to_y}); }
    void operator()(const RowsRejected& s) { add({20, s.from_y, s.to_y}); }
    void operator()(const PrimitiveSkipped& s) { add({21, static_cast<std::int64_t>(s.why)}); }
    void operator()(const BoundExceeded& s) {
        EXPECT_FALSE(std::abs(s.difference) > s.error * 1.0001) << "that was decided";
        EXPECT_TRUE(has_just_begun_) << "it stands directly after the beginning, once";
        has_just_begun_ = false;
        ++undecided;
    }

private:
    static std::int64_t as_number(Color color) {
        return (color.red() << 24) + (color.green() << 16) + (color.blue() << 8) + color.alpha();
    }
    void add(std::initializer_list<std::int64_t> numbers) {
        all.insert(all.end(), numbers.begin(), numbers.end());
        has_just_begun_ = false;
    }

    bool has_just_begun_ = false; ///< a primitive, and nothing else was told of it
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

/// The slopes of all edges, in double.
std::vector<double> slopes_of(Scene scene, ScalarKind scalar) {
    scene.method.scalar = scalar;
    std::vector<double> slopes;
    draw_as_planned(scene, [&slopes](const EdgeSetUp<Quantity>& step) {
        if (!step.is_horizontal)
            slopes.push_back(nearest_double(step.dx_dy.exact()));
    });
    return slopes;
}

TEST(Adaptive, TellsASlopeAsTheDoubleNearestToIt) {
    // (0.4 - 0.1)/(0.6 - 0.7) = -3; in doubles -3.0000000000000004.
    Scene first = small_first_triangle({.scalar = ScalarKind::adaptive});
    first.vertices = {{"A", number("0.1"), number("0.7")},
                      {"B", number("0.4"), number("0.6")},
                      {"C", number("-3.1"), number("-5.3")}};
    EXPECT_EQ(slopes_of(first, ScalarKind::adaptive).front(), -3);

    EdgeScenes scenes(29);
    std::mt19937_64 random(29);
    for (int i = 0; i < random_cases(1000); ++i) {
        Scene scene = scenes.next();
        if (random() % 2 == 0)
            scene = nudged(scene, random);
        scene.method.fill = random() % 2 == 0 ? Fill::scanline : Fill::two_halves;
        scene.method.scalar = ScalarKind::exact;
        if (find_unfit(scene))
            continue;
        ASSERT_EQ(slopes_of(scene, ScalarKind::adaptive), slopes_of(scene, ScalarKind::exact))
            << scene_text(scene);
    }
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
            if constexpr (std::same_as<Step, PrimitiveSkipped>)
                with_pixels.push_back(step.why);
        });
        const Image skips_told = draw_as_planned(
            scene, [&](const PrimitiveSkipped& step) { without.push_back(step.why); });
        ASSERT_EQ(skips_told.colors(), told.colors()) << scene_text(scene);
        ASSERT_EQ(draw_as_planned(scene).colors(), told.colors()) << scene_text(scene);
        ASSERT_EQ(without, with_pixels) << scene_text(scene);
        skipped += without.empty() ? 0 : 1;
    }
    EXPECT_GT(skipped, 0);
}

TEST(Adaptive, ZeroIsExactWhateverDividesIt) {
    const Adaptive length(3.1, 1e-16);
    EXPECT_EQ((Adaptive(0) / length).error(), 0);
    EXPECT_EQ((length / Adaptive(1)).error(), length.error());
    EXPECT_GT((Adaptive(1) / length).error(), 0);
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

/// An Adaptive and the number that it stands for.
struct Pair {
    Adaptive with_error;
    mpq_class exact;
};

/// Fails if the bound does not hold. Returns how much of it is used, 0 to 1.
double used_of_bound(const Pair& pair) {
    const mpq_class off = abs(mpq_class(pair.with_error.value()) - pair.exact);
    EXPECT_LE(off, mpq_class(pair.with_error.error()));
    return pair.with_error.error() == 0
               ? 0
               : mpq_class(off / mpq_class(pair.with_error.error())).get_d();
}

/// What random operations came to.
struct Use {
    double worst = 0; ///< how much of a bound is used at most
    int decided = 0;  ///< orders and floors
};

/// Applies random operations to random numbers, from seeds; sizes differ by up to 2^exponents.
Use use_of_bounds(std::uint64_t seed, int exponents) {
    std::mt19937_64 random(seed);
    const auto leaf = [&] {
        const mpq_class exact(mpz_class(static_cast<long>(random() % 2000001) - 1000000),
                              mpz_class(static_cast<long>(random() % 1000 + 1)));
        mpq_class scaled = exact;
        scaled.canonicalize();
        const int exponent =
            static_cast<int>(random() % static_cast<std::uint64_t>(2 * exponents + 1)) - exponents;
        const mpq_class power(mpz_class(1) << static_cast<unsigned>(std::abs(exponent)));
        scaled = exponent < 0 ? mpq_class(scaled / power) : mpq_class(scaled * power);
        return Pair{with_error(scaled), scaled};
    };
    Use use;
    Pair value = leaf();
    const auto is_finite = [](const Adaptive& number) {
        return std::isfinite(number.value()) && std::isfinite(number.error());
    };
    for (int i = 0; i < 12 && is_finite(value.with_error); ++i) {
        const Pair other = leaf();
        try {
            switch (random() % 5) {
            case 0:
                value = {value.with_error + other.with_error, value.exact + other.exact};
                break;
            case 1:
                value = {value.with_error - other.with_error, value.exact - other.exact};
                break;
            case 2:
                value = {value.with_error * other.with_error, value.exact * other.exact};
                break;
            case 3:
                if (other.exact != 0)
                    value = {value.with_error / other.with_error, value.exact / other.exact};
                break;
            default: // what all but cancels
                value = {value.with_error - Adaptive(value.with_error.value()),
                         value.exact - mpq_class(value.with_error.value())};
                break;
            }
        } catch (const Undecided&) {
            return use; // a divisor that may be 0
        }
        if (!is_finite(value.with_error)) {
            EXPECT_FALSE(order_of(value.with_error, other.with_error)) << "beyond the doubles";
            EXPECT_THROW(floor_index(value.with_error), Undecided);
            EXPECT_THROW(require_finite(value.with_error), Undecided);
            return use;
        }
        use.worst = std::max(use.worst, used_of_bound(value));

        // A comparison that is decided is right, and so is a floor.
        if (const auto order = order_of(value.with_error, other.with_error)) {
            EXPECT_EQ(*order, cmp(value.exact, other.exact) <=> 0);
            ++use.decided;
        }
        try {
            EXPECT_EQ(floor_index(value.with_error), floor_index(Rational(value.exact)));
            ++use.decided;
        } catch (const Undecided&) {
            continue;
        }
    }
    return use;
}

TEST(Adaptive, ErrorsStayBelowTheirBounds) {
    double worst = 0;
    for (unsigned seed = 0; seed < random_cases(20000U); ++seed)
        worst = std::max(worst, use_of_bounds(seed, seed % 2 == 0 ? 3 : 200).worst);
    EXPECT_GT(worst, 0.5) << "the bound should not be far larger than it has to be";
}

TEST(Adaptive, SubnormalAndHugeNumbersDecideNothingWrong) {
    int decided = 0;
    for (unsigned seed = 0; seed < random_cases(5000U); ++seed)
        decided += use_of_bounds(seed, 1020).decided;
    EXPECT_GT(decided, random_cases(20000));
}

TEST(Adaptive, QuotientsOfTheSmallestNumbersStayWithinTheirBounds) {
    // Terms of the bound are too small for a double, and the divisor is smaller still.
    std::mt19937_64 random(31);
    const auto part = [&random] {
        return 1 + std::ldexp(static_cast<double>(random() >> 12), -52);
    };
    const auto exponent = [&random](int low, int high) {
        return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low));
    };
    int checked = 0;
    for (int i = 0; i < 20000; ++i) {
        const double a = std::ldexp(part(), exponent(-1074, -1000));
        const double b = std::ldexp(part(), exponent(-900, -860));
        const double error = b * std::ldexp(part(), exponent(-60, -20));
        try {
            const Adaptive quotient = Adaptive(a) / Adaptive(b, error);
            for (const double side : {-1.0, 1.0}) {
                ++checked;
                const mpq_class exact =
                    mpq_class(a) / (mpq_class(b) + mpq_class(side) * mpq_class(error));
                ASSERT_LE(abs(exact - mpq_class(quotient.value())), mpq_class(quotient.error()))
                    << a << " / " << b << " +- " << error;
            }
        } catch (const Undecided&) {
            continue; // the divisor may be too small
        }
    }
    EXPECT_GT(checked, 10000);
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

TEST(Adaptive, FloorsNextToWholeNumbers) {
    for (const double whole : {-3.0, -1.0, 0.0, 1.0, 1e6, -1e15})
        for (const double error : {0.0, 1e-300, 1e-20, 1e-10, 0.1, 0.6})
            for (const double off :
                 {0.0, 1e-320, -1e-320, 1e-20, -1e-20, 1e-10, -1e-10, 0.2, -0.2}) {
                const double value = whole + off;
                const Index low = floor_index(Rational(mpq_class(value) - mpq_class(error)));
                const Index high = floor_index(Rational(mpq_class(value) + mpq_class(error)));
                try {
                    const Index found = floor_index(Adaptive(value, error));
                    EXPECT_TRUE(low == found && high == found) << value << " +- " << error;
                } catch (const Undecided&) {
                    // As little as the error allows for must do to be undecided: not more than twice.
                    const Index wide_low =
                        floor_index(Rational(mpq_class(value) - 2 * mpq_class(error)));
                    const Index wide_high =
                        floor_index(Rational(mpq_class(value) + 2 * mpq_class(error)));
                    EXPECT_NE(wide_low, wide_high) << value << " +- " << error;
                }
            }
}

TEST(Adaptive, DrawsWhatFitsInFractionsOfMachineSize) {
    const auto number_for = [](const Scene& scene) { return plan_for(scene).number; };
    EXPECT_EQ(number_for(first_triangle({.scalar = ScalarKind::adaptive})), NumberType::fraction64);
    Scene scene = triangle_scene({"1e-30", "0", "5", "0", "0", "5"}, {.width = 8, .height = 8},
                                 {.scalar = ScalarKind::adaptive});
    EXPECT_EQ(number_for(scene), NumberType::adaptive);
}

TEST(Adaptive, SaysHowOftenItFellBack) {
    // Row 0 passes through the corner C.
    Scene scene = triangle_scene({"1e-30", "0", "5", "0", "0", "5"}, {.width = 12, .height = 12},
                                 {.scalar = ScalarKind::adaptive});
    Fallbacks fallbacks;
    const Plan plan = plan_for(scene);
    draw(scene, plan, {}, &fallbacks);
    EXPECT_EQ(fallbacks.primitives, 1u);
    EXPECT_EQ(fallbacks.depths, 0u);
}

TEST(Adaptive, FacesThatMeetInAnEdgeTieThere) {
    // Two triangles of four corners on a small grid: they share an edge or more, fold over it, have
    // sides that are horizontal, or no height at all.
    std::mt19937_64 random(23);
    const auto whole = [&random](int below) {
        return static_cast<int>(random() % static_cast<std::uint64_t>(below));
    };
    int ties = 0;
    for (int i = 0; i < random_cases(4000); ++i) {
        Scene scene;
        scene.canvas = {.width = 8, .height = 8, .origin = Origin::top_left};
        scene.method = {.scalar = ScalarKind::adaptive,
                        .fill = i % 2 == 0 ? Fill::scanline : Fill::two_halves,
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
                                        .color = {}});
        }
        const Plan plan = plan_for(scene);
        ExactPieces exact(scene, plan);
        const auto has_row = [&exact](std::uint32_t face, int y) {
            const auto& [a, b, c] = exact.piece({face, 0}).positions;
            const auto [low, high] = std::minmax({a.y, b.y, c.y});
            return low <= y && y <= high;
        };
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8 && has_row(0, y) && has_row(1, y); ++x) {
                const auto first = edge_of_depth(scene, plan, {0, 0}, x, y);
                if (!first || first != edge_of_depth(scene, plan, {1, 0}, x, y))
                    continue;
                ++ties;
                ASSERT_EQ(exact_depth_at(scene, exact.piece({0, 0}), 0, x, y),
                          exact_depth_at(scene, exact.piece({1, 0}), 0, x, y))
                    << scene_text(scene) << "at " << x << ", " << y;
            }
    }
    EXPECT_GT(ties, 1000);
}

TEST(Adaptive, VerticesAtOneDistanceLeaveNoColorOpen) {
    Scene scene =
        triangle_scene({"-7/3", "-5/3", "9/7", "-5/3", "1/7", "13/3"}, {.width = 32, .height = 32},
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
    EXPECT_EQ(fallbacks.colors, 0u);
}

} // namespace
} // namespace rastertrace
