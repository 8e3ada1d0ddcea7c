// SPDX-License-Identifier: MIT
// The stress catalogue is as documented; what it documents is found again here by plain loops that
// share nothing with it; and a wrong result is noticed.

#include "picture.h"

#include <rastertrace/numerics/stress.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/method_names.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

// Every case of the catalogue.

class StressCatalogue : public testing::TestWithParam<std::string> {};

TEST_P(StressCatalogue, IsAsDocumented) {
    const StressCase& one = *find_stress_case(GetParam());
    const auto rows = rows_of(one, {.quick = true});
    EXPECT_FALSE(rows.empty());
    for (const StressRow& row : rows)
        EXPECT_TRUE(is_as_documented(row))
            << row.scalar << ", " << row.method << ": " << name_of(verdict_of(row)) << ", "
            << described(row) << "\ndocumented: " << described(row.documented, row.measured) << " "
            << row.documented.note;
}

std::vector<std::string> ids() {
    std::vector<std::string> ids;
    for (const StressCase& one : stress_cases())
        ids.emplace_back(one.id);
    return ids;
}
INSTANTIATE_TEST_SUITE_P(Cases, StressCatalogue, testing::ValuesIn(ids()),
                         [](const auto& one) { return one.param; });

TEST(StressCases, AreThoseOfTheCatalogue) {
    std::vector<std::string> expected;
    for (const auto& [family, count] : {std::pair{'L', 13}, std::pair{'S', 14}, std::pair{'C', 18},
                                        std::pair{'Z', 14}, std::pair{'P', 12}, std::pair{'X', 9}})
        for (int i = 1; i <= count; ++i)
            expected.push_back(family + std::to_string(i));
    EXPECT_EQ(ids(), expected);
    for (const StressCase& one : stress_cases()) {
        EXPECT_LE(one.title.size(), 40u) << one.id;
        EXPECT_FALSE(one.input.empty() || one.why.empty() || one.holds.empty()) << one.id;
        EXPECT_FALSE(family_of(one).empty()) << one.id;
    }
    EXPECT_EQ(find_stress_case("c15"), find_stress_case("C15"));
    EXPECT_EQ(find_stress_case("C19"), nullptr);
}

// Every scene can be read and drawn, and every scalar is put through most cases: one that the method
// gains comes in by itself.
TEST(StressCases, TakeEveryScalarOfTheMethod) {
    std::map<std::string, std::size_t> taken; // cases, by their scalars
    for (const StressCase& one : stress_cases()) {
        for (const StressScene& scene : one.scenes())
            EXPECT_TRUE(read_scene({"scene", scene.json}, {{"scalar", "exact"}}))
                << one.id << " " << scene.name;
        std::set<std::string> scalars;
        for (const StressRow& row : rows_of(one, {.quick = true}))
            scalars.emplace(row.scalar);
        for (const std::string& scalar : scalars)
            ++taken[scalar];
    }
    for (const std::string_view scalar : find_method_key("scalar")->values)
        EXPECT_GT(taken[std::string(scalar)], stress_cases().size() / 2) << scalar;
}

// What is said of a row.

StressRow row_of(Measured measured, Documented documented) {
    return {"float", "method", std::move(measured), documented};
}

TEST(StressRow, IsAsDocumentedOnlyIfItIsWrongByTheSameCountAndSize) {
    const Measured measured{.wrong = 590, .unit = "row", .worst = 0.02356, .worst_unit = "px"};
    const auto documented = [](std::uint64_t wrong, const std::string& worst) {
        return Documented{.verdict = Verdict::wrong, .wrong = wrong, .worst = worst};
    };
    EXPECT_TRUE(is_as_documented(row_of(measured, documented(590, "0.024"))));
    EXPECT_TRUE(is_as_documented(row_of(measured, documented(590, "2.36e-2"))));
    EXPECT_TRUE(is_as_documented(row_of(measured, documented(590, ""))));
    EXPECT_FALSE(is_as_documented(row_of(measured, documented(589, "0.024"))));
    EXPECT_FALSE(is_as_documented(row_of(measured, documented(590, "0.023"))));
    EXPECT_FALSE(is_as_documented(row_of(measured, {})));
}

TEST(StressRow, WhatMustBeWrongMayNotBeRight) {
    const Documented wrong{.verdict = Verdict::wrong, .wrong = 1};
    EXPECT_FALSE(is_as_documented(row_of({}, wrong)));
    EXPECT_FALSE(is_as_documented(row_of({.is_refused = true, .note = "no"}, wrong)));
}

TEST(StressRow, MayBeBetterThanItsBoundButNotWorse) {
    const Documented bound{.verdict = Verdict::within, .bound = 1e-3};
    EXPECT_TRUE(is_as_documented(row_of({}, bound)));
    EXPECT_TRUE(is_as_documented(row_of({.worst = 1e-3}, bound)));
    EXPECT_FALSE(is_as_documented(row_of({.worst = 1.001e-3}, bound)));
    EXPECT_FALSE(is_as_documented(row_of({.wrong = 1}, bound)));
    EXPECT_FALSE(is_as_documented(row_of({.worst = std::nan("")}, bound)));
    EXPECT_FALSE(is_as_documented(row_of({.worst = 1e-9}, {}))) << "right is right, not nearly";
}

TEST(StressRow, IsRefusedForTheReasonThatIsDocumented) {
    const Measured refused{.is_refused = true, .note = "expected a, found vertex B"};
    EXPECT_TRUE(
        is_as_documented(row_of(refused, {.verdict = Verdict::refused, .note = "vertex B"})));
    EXPECT_FALSE(
        is_as_documented(row_of(refused, {.verdict = Verdict::refused, .note = "vertex A"})));
    EXPECT_FALSE(is_as_documented(row_of(refused, {})));
}

TEST(StressRow, SaysWhatWasFound) {
    const Documented wrong{.verdict = Verdict::wrong, .wrong = 590, .worst = "0.024"};
    const auto row = row_of(
        {.wrong = 590, .unit = "row", .worst = 0.02356, .worst_unit = "px", .note = "of 3001"},
        wrong);
    EXPECT_EQ(described(row), "590 rows wrong, at most 0.024 px; of 3001");
    EXPECT_EQ(described_error(row), "590 rows wrong, at most 0.024 px");
    EXPECT_EQ(described(wrong, row.measured), "590 rows wrong, at most 0.024 px");
    EXPECT_EQ(described(row_of({.worst = 1e-9, .worst_unit = "px"},
                               {.verdict = Verdict::within, .bound = 1e-3})),
              "off by at most 1e-09 px");
}

// The numbers that the catalogue documents and that no text has, found again.

/// The row of a case.
const StressRow& row_in(const std::vector<StressRow>& rows, std::string_view scalar,
                        std::string_view method) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const StressRow& row) {
        return row.scalar == scalar && row.method == method;
    });
    if (found == rows.end())
        throw std::runtime_error("no row " + std::string(scalar) + ", " + std::string(method));
    return *found;
}
std::uint64_t wrong_in(std::string_view id, std::string_view scalar, std::string_view method) {
    static std::map<std::string, std::vector<StressRow>> found;
    auto& rows = found[std::string(id)];
    if (rows.empty())
        rows = rows_of(*find_stress_case(id), {.quick = true});
    return row_in(rows, scalar, method).measured.wrong;
}

/// Pixels that differ where a line has y(x) instead of exact(x): one missing, one too many.
template <typename Y, typename Exact> std::uint64_t line_pixels(int steps, Y&& y, Exact&& exact) {
    std::uint64_t count = 0;
    for (int x = 0; x <= steps; ++x)
        count += y(x) == exact(x) ? 0 : 2;
    return count;
}

/// The nearest whole number; a half stays below.
template <typename Real> std::int64_t nearest_below(Real x) {
    return static_cast<std::int64_t>(std::ceil(x - Real(0.5)));
}

template <typename Real> std::uint64_t l2_dda() {
    Real y = 0;
    return line_pixels(
        60,
        [&y](int x) {
            if (x > 0)
                y += Real(10) / Real(60);
            return nearest_below(y);
        },
        // ceil(x/6 - 1/2)
        [](int x) { return (x - 3 + 5) / 6; });
}

TEST(Independently, TiesThatASumOfSixthsMisses) {
    EXPECT_EQ(wrong_in("L2", "float", "dda"), l2_dda<float>());
    EXPECT_EQ(wrong_in("L2", "double", "dda"), l2_dda<double>());
}

TEST(Independently, TheSumThatMissesTheTieOfAMillion) {
    // From y = 8, the top row of the canvas, down to -7: the line is walked from below.
    const float m = 1.0F / 1'000'000.0F;
    float x = 0 + m * (-7.0F - -500'000.0F);
    std::uint64_t count = 0;
    for (int y = -7; y <= 8; ++y) {
        if (y > -7)
            x += m;
        // Exactly x = 1/2 + y/1000000; at y = 0 it stays at 0.
        count += nearest_below(x) == (y > 0 ? 1 : 0) ? 0 : 2;
    }
    EXPECT_EQ(wrong_in("L3", "float", "dda"), count);
}

/// How many pixels of 0..dx a slope dy/dx in Real gets wrong; ties go up.
template <typename Real> std::uint64_t long_line(std::int64_t dx, std::int64_t dy, bool adds) {
    const Real m = static_cast<Real>(dy) / static_cast<Real>(dx);
    Real sum = 0;
    std::uint64_t wrong = 0;
    for (std::int64_t x = 0; x <= dx; ++x, sum += m) {
        const Real y = adds ? sum : m * static_cast<Real>(x);
        const Real below = std::floor(y);
        const auto nearest = static_cast<std::int64_t>(below) + (y - below >= Real(0.5) ? 1 : 0);
        const std::int64_t twice = 2 * (nearest * dx - x * dy);
        wrong += -dx < twice && twice <= dx ? 0 : 1;
    }
    return wrong;
}

TEST(Independently, LongLines) {
    EXPECT_EQ(long_line<float>(1'000'000, 333'333, true), 977'568u);
    EXPECT_EQ(long_line<double>(1'000'000, 333'333, true), 1u);
    EXPECT_EQ(wrong_in("L4", "float", "multiply, y = m x"),
              long_line<float>(1'000'000, 333'333, false));
    EXPECT_EQ(wrong_in("L5", "float", "accumulate, y += m"),
              long_line<float>(65'535, 21'845, true));
    EXPECT_EQ(long_line<double>(65'535, 21'845, true), 0u);
    EXPECT_EQ(long_line<float>(65'535, 21'845, false), 0u);
    EXPECT_EQ(long_line<float>(4095, 4094, true), 0u);
}

TEST(Independently, TheLineWhoseFloatEndIsATieEverywhere) {
    const float from = -2147483648.0F;
    const auto to = static_cast<float>(2147483647.0);
    const float m = 1.0F / (to - from);
    const float b = 0.0F - m * from;
    std::uint64_t count = 0;
    for (int x = -8; x <= 7; ++x)
        count += nearest_below(m * static_cast<float>(x) + b) == (x >= 0 ? 1 : 0) ? 0 : 2;
    EXPECT_EQ(wrong_in("L9", "float", "naive"), count);
}

/// Rows of 0..dy that floor(x) gets wrong.
template <typename Real> std::uint64_t long_edge(std::int64_t dx, std::int64_t dy, bool adds) {
    const Real slope = static_cast<Real>(dx) / static_cast<Real>(dy);
    Real sum = 0;
    std::uint64_t wrong = 0;
    for (std::int64_t y = 0; y <= dy; ++y, sum += slope) {
        const Real x = adds ? sum : slope * static_cast<Real>(y);
        wrong += static_cast<std::int64_t>(std::floor(x)) == y * dx / dy ? 0 : 1;
    }
    return wrong;
}

TEST(Independently, LongEdges) {
    EXPECT_EQ(long_edge<float>(1000, 3000, true), 590u);
    EXPECT_EQ(long_edge<double>(1000, 3000, true), 409u);
    EXPECT_EQ(wrong_in("S5", "float", "incremental, x += dx/dy"),
              long_edge<float>(100'000, 700'000, true));
    EXPECT_EQ(wrong_in("S5", "double", "incremental, x += dx/dy"),
              long_edge<double>(100'000, 700'000, true));
    EXPECT_EQ(long_edge<float>(100'000, 700'000, false), 0u);
    EXPECT_EQ(long_edge<double>(100'000, 700'000, false), 0u);
}

TEST(Independently, HalfOfTheLeastFloatIsNothing) {
    const float least = 0x1p-149F;
    const float slope = (-least - 0.0F) / (0.0F - 2.0F);
    EXPECT_EQ(slope, 0.0F);
    // Rows 0 and 1 lose their pixel at x = -1.
    EXPECT_EQ(wrong_in("S12", "float", "scanline"), 2u);
}

// Depths of samples by a plane through the corners: gradients, then the row, then the column. The
// formulas are those of depth_interpolation.h, written out for 1/z.

template <typename Real> struct PlaneOf {
    std::array<std::array<double, 3>, 3> at; ///< x, y and 1/z, which is rounded already

    /// 1/z at the center of pixel (x, y).
    Real at_sample(int x, int y) const {
        const auto X = [this](int i) {
            return static_cast<Real>(at[static_cast<std::size_t>(i)][0]);
        };
        const auto Y = [this](int i) {
            return static_cast<Real>(at[static_cast<std::size_t>(i)][1]);
        };
        // Larger is nearer: the buffer holds -1/z.
        const auto D = [this](int i) {
            return -static_cast<Real>(at[static_cast<std::size_t>(i)][2]);
        };
        const Real abx = X(1) - X(0), aby = Y(1) - Y(0), acx = X(2) - X(0), acy = Y(2) - Y(0);
        const Real area2 = abx * acy - acx * aby;
        const Real ab = D(1) - D(0), ac = D(2) - D(0);
        const Real in_x = (ab * acy - ac * aby) / area2;
        const Real in_y = (ac * abx - ab * acx) / area2;
        const Real half(0.5);
        const Real row = D(0) + in_y * (Real(y) - (Y(0) - half));
        return -(row + in_x * (Real(x) - (X(0) - half)));
    }
};

/// True if the center of pixel (x, y) lies in a triangle by the top-left rule, y down; coordinates in
/// units of 1/16.
bool has_center(const std::array<std::array<std::int64_t, 2>, 3>& t, int x, int y) {
    const auto cross = [](auto p, auto q, auto r) {
        return (q[0] - p[0]) * (r[1] - p[1]) - (r[0] - p[0]) * (q[1] - p[1]);
    };
    const std::int64_t area = cross(t[0], t[1], t[2]);
    if (area == 0)
        return false;
    const std::array<std::int64_t, 2> sample{16 * x + 8, 16 * y + 8};
    for (std::size_t i = 0; i < 3; ++i) {
        auto p = t[i];
        auto q = t[(i + 1) % 3];
        if (area < 0)
            std::swap(p, q);
        // Going round with the inside on the right as seen (y down), left edges go up, top edges right.
        const std::int64_t side = cross(p, q, sample);
        const bool is_top_left = q[1] < p[1] || (q[1] == p[1] && q[0] > p[0]);
        if (side < 0 || (side == 0 && !is_top_left))
            return false;
    }
    return true;
}

template <typename Real> double inverse(double z) {
    return static_cast<double>(Real(1) / static_cast<Real>(z));
}

/// Z8: pixels in both triangulations that the second one wins.
template <typename Real> std::uint64_t z8_won_by_second() {
    const std::array<std::array<std::array<int, 2>, 3>, 2> corners{
        {{{{0, 0}, {60, 3}, {5, 61}}}, {{{2, 60}, {1, 1}, {63, 5}}}}};
    std::array<PlaneOf<Real>, 2> planes;
    std::array<std::array<std::array<std::int64_t, 2>, 3>, 2> places{};
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& [x, y] = corners[i][k];
            const Real z = static_cast<Real>(1000.0L / (x + 2 * y + 7));
            planes[i].at[k] = {double(x), double(y), static_cast<double>(Real(1) / z)};
            places[i][k] = {16 * x, 16 * y};
        }
    std::uint64_t won = 0;
    std::uint64_t common = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            if (has_center(places[0], x, y) && has_center(places[1], x, y)) {
                ++common;
                won += planes[1].at_sample(x, y) > planes[0].at_sample(x, y) ? 1 : 0;
            }
    EXPECT_EQ(common, 1695u);
    return won;
}

TEST(Independently, OnePlaneTriangulatedTwice) {
    EXPECT_EQ(wrong_in("Z8", "float", "inverse-z"), z8_won_by_second<float>());
    EXPECT_EQ(wrong_in("Z8", "double", "inverse-z"), z8_won_by_second<double>());
}

/// Z9: of the 32 pixels in column 32 those that the triangle drawn second wins.
template <typename Real> std::uint64_t z9_ties_to_second(bool t_is_first) {
    PlaneOf<Real> t{{{{0.5, 0.5, 1}, {64.5, 0.5, inverse<Real>(3)}, {0.5, 64.5, 1}}}};
    PlaneOf<Real> u{
        {{{0.5, 0.5, inverse<Real>(3)}, {64.5, 0.5, 1}, {0.5, 64.5, inverse<Real>(3)}}}};
    std::uint64_t won = 0;
    for (int y = 0; y < 32; ++y) {
        const Real of_t = t.at_sample(32, y);
        const Real of_u = u.at_sample(32, y);
        won += (t_is_first ? of_u > of_t : of_t > of_u) ? 1 : 0;
    }
    return won;
}

TEST(Independently, TiesOfPlanesThatCross) {
    EXPECT_EQ(wrong_in("Z9", "float", "inverse-z, T first"), z9_ties_to_second<float>(true));
    EXPECT_EQ(wrong_in("Z9", "double", "inverse-z, T first"), z9_ties_to_second<double>(true));
    EXPECT_EQ(wrong_in("Z9", "float", "inverse-z, T second"), z9_ties_to_second<float>(false));
    EXPECT_EQ(wrong_in("Z9", "double", "inverse-z, T second"), z9_ties_to_second<double>(false));
}

/// The triangles of a case's scene, each with its corners and depths.
struct PlainTriangle {
    std::array<std::array<std::int64_t, 2>, 3> sixteenths;
    std::array<Rational, 3> z;
};
std::vector<PlainTriangle> triangles_of(const StressScene& scene) {
    const auto planned = read_scene({"scene", scene.json});
    const Scene& read = planned.value().scene;
    std::vector<PlainTriangle> triangles;
    for (const ScenePrimitive& primitive : read.primitives) {
        PlainTriangle triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            const SceneVertex& vertex = read.vertices[primitive.vertices[i]];
            triangle.sixteenths[i] = {floor_index(Rational(vertex.x.exact() * 16)),
                                      floor_index(Rational(vertex.y.exact() * 16))};
            triangle.z[i] = vertex.z.exact();
        }
        triangles.push_back(triangle);
    }
    return triangles;
}

/// Depth at a sample, exactly: by weights, which are areas.
Rational exact_depth(const PlainTriangle& t, const std::array<Rational, 3>& depths, int x, int y) {
    const std::array<std::int64_t, 2> p{16 * x + 8, 16 * y + 8};
    const auto cross = [](auto a, auto b, auto c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    };
    const auto& s = t.sixteenths;
    Rational sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += Rational(static_cast<long>(cross(p, s[(i + 1) % 3], s[(i + 2) % 3]))) * depths[i];
    return sum / Rational(static_cast<long>(cross(s[0], s[1], s[2])));
}

// Z6 in float, by the formulas above; and its linear z in exact arithmetic.
TEST(Independently, PairsAMillionDeep) {
    std::uint64_t by_float = 0;
    std::uint64_t by_linear = 0;
    for (const StressScene& pair : find_stress_case("Z6")->scenes()) {
        const auto triangles = triangles_of(pair);
        std::array<PlaneOf<float>, 2> planes;
        std::array<std::array<Rational, 3>, 2> inverse_z;
        for (std::size_t i = 0; i < 2; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& [x, y] = triangles[i].sixteenths[k];
                inverse_z[i][k] = 1 / triangles[i].z[k];
                planes[i].at[k] = {double(x) / 16, double(y) / 16,
                                   static_cast<double>(1.0F / nearest_float(triangles[i].z[k]))};
            }
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                if (!has_center(triangles[0].sixteenths, x, y))
                    continue;
                const bool second_wins = exact_depth(triangles[1], inverse_z[1], x, y) >
                                         exact_depth(triangles[0], inverse_z[0], x, y);
                by_float +=
                    (planes[1].at_sample(x, y) > planes[0].at_sample(x, y)) == second_wins ? 0 : 1;
                by_linear += (exact_depth(triangles[1], triangles[1].z, x, y) <
                              exact_depth(triangles[0], triangles[0].z, x, y)) == second_wins
                                 ? 0
                                 : 1;
            }
    }
    EXPECT_EQ(wrong_in("Z6", "float", "inverse-z"), by_float);
    EXPECT_EQ(wrong_in("Z6", "exact", "linear-z"), by_linear);
}

// Z10: three triangles painted one over the other, against the nearest at each sample.
TEST(Independently, TheCycleInEveryOrder) {
    const std::array<std::string, 3> names{"A", "B", "C"};
    const auto triangles = triangles_of(find_stress_case("Z10")->scenes().front());
    std::array<std::size_t, 3> order{0, 1, 2};
    do {
        std::uint64_t wrong = 0;
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                int painted = -1;
                int nearest = -1;
                Rational best = 0;
                for (const std::size_t i : order) {
                    if (!has_center(triangles[i].sixteenths, x, y))
                        continue;
                    painted = static_cast<int>(i);
                    std::array<Rational, 3> inverse;
                    for (std::size_t k = 0; k < 3; ++k)
                        inverse[k] = 1 / triangles[i].z[k];
                    const Rational here = exact_depth(triangles[i], inverse, x, y);
                    if (here > best) {
                        best = here;
                        nearest = painted;
                    }
                }
                wrong += painted == nearest ? 0 : 1;
            }
        const std::string label = names[order[0]] + names[order[1]] + names[order[2]];
        EXPECT_EQ(wrong_in("Z10", "double", "no depth, " + label), wrong) << label;
        EXPECT_GT(wrong, 0u) << label;
    } while (std::next_permutation(order.begin(), order.end()));
}

// C15, with whole numbers: in units of 1/16 pixel all its corners are whole.
TEST(Independently, TheGapAndTheOverlapOfTheTJunction) {
    using Corners = std::array<std::array<std::int64_t, 2>, 3>;
    const auto layers = [](std::array<std::int64_t, 2> m, int x, int y) {
        const Corners above{{{0, 320}, {640, 432}, {512, -320}}};
        const Corners left{{{0, 320}, m, {512, 1440}}};
        const Corners right{{m, {640, 432}, {512, 1440}}};
        return int(has_center(above, x, y)) + int(has_center(left, x, y)) +
               int(has_center(right, x, y));
    };
    const Corners hull_above{{{0, 320}, {512, -320}, {640, 432}}};
    const Corners hull_below{{{0, 320}, {640, 432}, {512, 1440}}};
    int gaps = 0;
    int overlaps = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 64; ++x) {
            const bool is_inside = has_center(hull_above, x, y) || has_center(hull_below, x, y);
            gaps += is_inside && layers({112, 340}, x, y) == 0 ? 1 : 0;
            overlaps += layers({528, 412}, x, y) > 1 ? 1 : 0;
        }
    EXPECT_EQ(gaps, 1);
    EXPECT_EQ(overlaps, 1);
}

// P5 and P8 by the textbook's formula.
template <typename Real> using Triple = std::array<Real, 3>;
template <typename Real>
Real facing(Triple<Real> a, Triple<Real> b, Triple<Real> c, Triple<Real> eye, Triple<Real> v) {
    const auto minus = [](const Triple<Real>& p, const Triple<Real>& q) {
        return Triple<Real>{p[0] - q[0], p[1] - q[1], p[2] - q[2]};
    };
    const auto u = minus(b, a);
    const auto w = minus(c, a);
    const auto e = minus(eye, v);
    const Triple<Real> n{u[1] * w[2] - w[1] * u[2], u[2] * w[0] - w[2] * u[0],
                         u[0] * w[1] - w[0] * u[1]};
    return n[0] * e[0] + n[1] * e[1] + n[2] * e[2];
}

template <typename Real> std::uint64_t faces_of_many_minds() {
    std::mt19937_64 random(8);
    const auto point = [&random] {
        Triple<Real> p;
        for (Real& x : p)
            x = static_cast<Real>(static_cast<double>(static_cast<int>(random() % 199) - 99) / 10);
        return p;
    };
    std::uint64_t count = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto a = point();
        const auto b = point();
        const auto c = point();
        const auto eye = point();
        const Real from_a = facing(a, b, c, eye, a);
        count += from_a == facing(a, b, c, eye, b) && from_a == facing(a, b, c, eye, c) ? 0 : 1;
    }
    return count;
}

TEST(Independently, FacesSeenFromEachVertex) {
    EXPECT_EQ(wrong_in("P8", "float", "normal . (eye - V)"), faces_of_many_minds<float>());
    EXPECT_EQ(wrong_in("P8", "double", "normal . (eye - V)"), faces_of_many_minds<double>());
}

TEST(Independently, TheEdgeOnFaceSeenFromItsMiddle) {
    const auto from_middle = []<typename Real>(Real) {
        const Triple<Real> a{0, 0, 0};
        const Triple<Real> b{Real(0.1), Real(0.2), Real(0.3)};
        const Triple<Real> c{Real(0.7), Real(-0.4), Real(0.5)};
        const Triple<Real> middle{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3,
                                  (a[2] + b[2] + c[2]) / 3};
        return facing<Real>(a, b, c, {Real(5.2), Real(-2.2), Real(4.4)}, middle);
    };
    EXPECT_EQ(from_middle(0.0F), -1.7881393e-07F);
    EXPECT_EQ(from_middle(0.0), 2.220446049250313e-16);
}

} // namespace
} // namespace rastertrace
