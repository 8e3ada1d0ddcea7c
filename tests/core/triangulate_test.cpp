// SPDX-License-Identifier: MIT
// A face is cut into triangles that are all of it, once. What a polygon covers is told independently, by the
// parity of the edges beside a point, in fractions.
#include "effort.h"
#include "picture.h"
#include "random_choice.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/core/draw/scene/triangulate.h>
#include <rastertrace/trace/scene/scene_file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using Corner = std::array<Rational, 3>;
using Outline = std::vector<Corner>;
using Triangles = std::vector<std::array<std::size_t, 3>>;

/// x, y pairs in the plane z = 0.
Outline in_plane(const std::vector<std::array<int, 2>>& places) {
    Outline outline;
    for (const auto& [x, y] : places)
        outline.push_back({Rational(x), Rational(y), Rational(0)});
    return outline;
}

std::vector<SceneVertex> vertices_of(const Outline& outline) {
    std::vector<SceneVertex> vertices;
    for (const auto& [x, y, z] : outline)
        vertices.push_back({.name = "P" + std::to_string(vertices.size()),
                            .x = number(x.get_str()),
                            .y = number(y.get_str()),
                            .z = number(z.get_str())});
    return vertices;
}

Triangulation cut(const Outline& outline) {
    const auto vertices = vertices_of(outline);
    std::vector<std::size_t> face(outline.size());
    std::iota(face.begin(), face.end(), std::size_t{0});
    return FaceCutter(vertices).cut(face);
}

/// Twice the area of a, b, c in the plane z = 0; above 0 if they are counter-clockwise.
Rational doubled_area(const Corner& a, const Corner& b, const Corner& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// By the shoelace formula.
Rational doubled_area(const Outline& outline) {
    Rational sum;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Corner& to = outline[(i + 1) % outline.size()];
        sum += outline[i][0] * to[1] - to[0] * outline[i][1];
    }
    return sum;
}

/// True if two counter-clockwise triangles have no inner point in common: all of one lies beyond an edge of
/// the other.
bool are_apart(const std::array<Corner, 3>& one, const std::array<Corner, 3>& other) {
    const auto is_beyond = [](const auto& triangle, const auto& corners) {
        for (std::size_t i = 0; i < 3; ++i)
            if (std::all_of(corners.begin(), corners.end(), [&](const Corner& corner) {
                    return doubled_area(triangle[i], triangle[(i + 1) % 3], corner) <= 0;
                }))
                return true;
        return false;
    };
    return is_beyond(one, other) || is_beyond(other, one);
}

/// Random points in an order in which no two edges cross: two that do are uncrossed until none is left.
/// Edges may still touch.
Outline random_simple_polygon(Random& random, int corners, int size) {
    std::vector<std::array<int, 2>> places;
    while (static_cast<int>(places.size()) < corners) {
        const std::array place{random.whole(0, size), random.whole(0, size)};
        if (std::find(places.begin(), places.end(), place) == places.end())
            places.push_back(place);
    }
    const Outline points = in_plane(places);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto at = [&](std::size_t i) -> const Corner& { return points[order[i % order.size()]]; };
    const auto side = [&](std::size_t i, std::size_t k) {
        return sgn(doubled_area(at(i), at(i + 1), at(k)));
    };
    for (bool is_crossed = true; is_crossed;) {
        is_crossed = false;
        for (std::size_t i = 0; i + 2 < order.size(); ++i)
            for (std::size_t k = i + 2; k < order.size(); ++k)
                if (side(i, k) * side(i, k + 1) < 0 && side(k, i) * side(k, i + 1) < 0) {
                    std::reverse(order.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                 order.begin() + static_cast<std::ptrdiff_t>(k) + 1);
                    is_crossed = true;
                }
    }
    Outline outline;
    for (const std::size_t i : order)
        outline.push_back(points[i]);
    return outline;
}

/// True if a point lies inside by the parity of the edges to its right. It lies on none of their corners'
/// rows.
bool has_inside(const Outline& outline, const Rational& x, const Rational& y) {
    bool is_inside = false;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Corner& from = outline[i];
        const Corner& to = outline[(i + 1) % outline.size()];
        if ((from[1] < y) != (to[1] < y) &&
            from[0] + (y - from[1]) / (to[1] - from[1]) * (to[0] - from[0]) > x)
            is_inside = !is_inside;
    }
    return is_inside;
}

/// The triangles have the area of the polygon, none overlaps another, and all turn as it does.
void expect_partition(const Outline& outline, const Triangles& triangles) {
    const bool is_turned = doubled_area(outline) < 0;
    Rational sum;
    std::vector<std::array<Corner, 3>> parts;
    for (const auto& [a, b, c] : triangles) {
        parts.push_back({outline[a], outline[b], outline[c]});
        if (is_turned)
            std::swap(parts.back()[1], parts.back()[2]);
        const Rational area = doubled_area(parts.back()[0], parts.back()[1], parts.back()[2]);
        EXPECT_GT(area, 0) << a << ' ' << b << ' ' << c;
        sum += area;
    }
    EXPECT_EQ(sum, abs(doubled_area(outline)));
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t k = i + 1; k < parts.size(); ++k)
            EXPECT_TRUE(are_apart(parts[i], parts[k])) << "triangles " << i << " and " << k;
}

std::string text_of(const Outline& outline) {
    std::string text = "the polygon";
    for (const Corner& corner : outline)
        text += " (" + corner[0].get_str() + ", " + corner[1].get_str() + ")";
    return text;
}

/// A random simple polygon that is concave, from a random corner on, either way around.
Outline random_concave(Random& random) {
    for (;;) {
        Outline outline =
            random_simple_polygon(random, random.whole(4, 14), random.pick({4, 6, 12}));
        if (cut(outline).form == FaceForm::concave)
            return outline;
    }
}

TEST(Triangulate, EarsAreAllOfThePolygonOnce) {
    Random random(20);
    for (int i = 0; i < random_cases(400) && !testing::Test::HasFailure(); ++i) {
        SCOPED_TRACE(i);
        const Outline outline = random_concave(random);
        const auto ears = cut(outline).ears;
        ASSERT_TRUE(ears) << text_of(outline);
        EXPECT_EQ(ears->triangles.size(), outline.size() - 2) << text_of(outline);
        expect_partition(outline, ears->triangles);
        EXPECT_EQ(ears->normal.z, doubled_area(outline));
        EXPECT_EQ(ears->dropped, 2u);
        if (HasFailure())
            ADD_FAILURE() << text_of(outline);
    }
}

/// How often each pixel of a 12 x 12 canvas is drawn.
std::map<std::pair<int, int>, int> writes_of(const Outline& outline) {
    std::string vertices;
    std::string face;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        vertices += (i == 0 ? "\"P" : ",\"P") + std::to_string(i) + "\":[" +
                    outline[i][0].get_str() + "," + outline[i][1].get_str() + "]";
        face += (i == 0 ? "\"P" : ",\"P") + std::to_string(i) + '"';
    }
    const auto read = read_scene(
        {"s", R"({"canvas":{"width":12,"height":12,"origin":"top-left"},"meshes":[{"vertices":{)" +
                  vertices + R"(},"faces":[[)" + face +
                  R"(]]}],"method":{"scalar":"exact","fill":"top-left"}})"});
    EXPECT_TRUE(read) << to_text(read.problem());
    std::map<std::pair<int, int>, int> writes;
    if (read)
        draw(read.value().scene, read.value().plan, [&](const PixelPlotted<>& step) {
            ++writes[{step.x, step.y}];
        });
    return writes;
}

TEST(Triangulate, EachPixelInsideIsDrawnOnceWhereverTheFaceBegins) {
    // A sample on an edge belongs to what lies right of it, or below it: it is moved there by less than any
    // two of these numbers differ.
    const Rational hair(1, 1 << 20);
    Random random(21);
    for (int i = 0; i < random_cases(60) && !testing::Test::HasFailure(); ++i) {
        Outline outline = random_concave(random);
        std::map<std::pair<int, int>, int> inside;
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 12; ++x)
                if (has_inside(outline, x + Rational(1, 2) + hair,
                               y + Rational(1, 2) + hair * hair))
                    inside[{x, y}] = 1;
        for (std::size_t first = 0; first < outline.size(); ++first) {
            EXPECT_EQ(writes_of(outline), inside) << text_of(outline);
            std::rotate(outline.begin(), outline.begin() + 1, outline.end());
        }
        std::reverse(outline.begin(), outline.end());
        EXPECT_EQ(writes_of(outline), inside) << text_of(outline);
    }
}

TEST(Triangulate, NumbersOfAnySizeDecideAlike) {
    // The same polygon with whole numbers whose products need 128 bits, or nearly that many, over a
    // denominator beyond 64 bits, and so far away that no double tells its corners apart.
    const std::array shifts{Rational(1'000'000'000'000), Rational(500'000'000'000'000'000),
                            Rational(1, mpz_class("618970019642690137449562111")),
                            Rational(mpz_class("900000000000000000000000000000"))};
    Random random(22);
    for (int i = 0; i < random_cases(100); ++i) {
        const Outline outline = random_concave(random);
        const auto expected = cut(outline).ears->triangles;
        for (const Rational& shift : shifts) {
            Outline moved = outline;
            for (Corner& corner : moved)
                for (Rational& coordinate : corner)
                    coordinate += shift;
            const auto ears = cut(moved).ears;
            ASSERT_TRUE(ears) << text_of(outline);
            EXPECT_EQ(ears->triangles, expected) << text_of(outline);
        }
    }
}

TEST(Triangulate, InSpaceTheNormalIsThatOfThePlane) {
    // The plane of two random vectors: a face in it is cut as it is, seen along the larger side.
    Random random(23);
    for (int i = 0; i < random_cases(200); ++i) {
        const Outline outline = random_concave(random);
        Vec<Rational, 3> u{};
        Vec<Rational, 3> v{};
        for (Rational* const number : {&u.x, &u.y, &u.z, &v.x, &v.y, &v.z})
            *number = random.whole(-5, 5);
        const auto normal = cross(u, v);
        if (sgn(dot(normal, normal)) == 0)
            continue;
        Outline in_space;
        for (const Corner& at : outline)
            in_space.push_back({at[0] * u.x + at[1] * v.x + 1, at[0] * u.y + at[1] * v.y - 2,
                                at[0] * u.z + at[1] * v.z + 3});
        const Triangulation found = cut(in_space);
        ASSERT_TRUE(found.ears) << text_of(outline);
        EXPECT_TRUE(found.is_planar);
        EXPECT_EQ(found.ears->triangles, cut(outline).ears->triangles) << text_of(outline);
        const Rational area = doubled_area(outline);
        EXPECT_EQ(found.ears->normal.x, area * normal.x);
        EXPECT_EQ(found.ears->normal.y, area * normal.y);
        EXPECT_EQ(found.ears->normal.z, area * normal.z);
        const std::array sizes{abs(normal.x), abs(normal.y), abs(normal.z)};
        EXPECT_EQ(sizes[found.ears->dropped], *std::max_element(sizes.begin(), sizes.end()));
    }
}

TEST(Triangulate, TheOrderIsThatOfTheLine) {
    // 4 E . . . D    A is no ear: C lies in EAB. B is one, ABC, and sends A and C to the end of the line. So D
    // 3 .     .      is asked next: CDE. What is left is ACE.
    // 2 .   .
    // 1 . C   .
    // 0 A . . . B
    const auto ears = cut(in_plane({{0, 0}, {4, 0}, {1, 1}, {4, 4}, {0, 4}})).ears;
    ASSERT_TRUE(ears);
    EXPECT_EQ(ears->triangles, (Triangles{{0, 1, 2}, {2, 3, 4}, {0, 2, 4}}));
}

TEST(Triangulate, ConvexFacesStayTheFan) {
    EXPECT_EQ(cut(in_plane({{0, 0}, {4, 0}, {4, 4}, {0, 4}})).form, FaceForm::convex);
    EXPECT_EQ(cut(in_plane({{0, 0}, {0, 4}, {4, 4}, {4, 0}})).form, FaceForm::convex);
    EXPECT_EQ(cut(in_plane({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}})).form, FaceForm::convex)
        << "a corner in the middle of an edge";
    EXPECT_EQ(cut(in_plane({{0, 0}, {0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}})).form,
              FaceForm::convex)
        << "repeated corners";
}

TEST(Triangulate, CornersThatAreRepeatedAreCutOnce) {
    const auto once = cut(in_plane({{0, 0}, {4, 0}, {2, 1}, {4, 4}, {0, 4}})).ears;
    const auto again =
        cut(in_plane({{0, 0}, {4, 0}, {4, 0}, {2, 1}, {4, 4}, {4, 4}, {4, 4}, {0, 4}, {0, 0}}))
            .ears;
    ASSERT_TRUE(once && again);
    const std::array<std::size_t, 5> places{0, 1, 3, 4, 7};
    Triangles expected = once->triangles;
    for (auto& triangle : expected)
        for (std::size_t& corner : triangle)
            corner = places[corner];
    EXPECT_EQ(again->triangles, expected);
}

TEST(Triangulate, CornersOnAnEdgeAreCornersOfTriangles) {
    // Two corners in the middle of edges; a triangle without area would have three corners on a line.
    const Outline outline =
        in_plane({{0, 0}, {2, 0}, {4, 0}, {2, 1}, {4, 4}, {2, 4}, {0, 4}, {0, 2}});
    const auto ears = cut(outline).ears;
    ASSERT_TRUE(ears);
    EXPECT_EQ(ears->triangles.size(), outline.size() - 2);
    expect_partition(outline, ears->triangles);
}

TEST(Triangulate, WhatIsNotSimpleIsToldWithItsFirstEdge) {
    const auto meeting = [](const std::vector<std::array<int, 2>>& places) {
        const Triangulation found = cut(in_plane(places));
        EXPECT_EQ(found.form, FaceForm::crossed);
        EXPECT_FALSE(found.ears);
        return found.meeting;
    };
    using Edges = std::array<std::size_t, 2>;
    EXPECT_EQ(meeting({{0, 0}, {4, 4}, {4, 0}, {0, 3}}), (Edges{0, 2})) << "a bow tie";
    EXPECT_EQ(meeting({{4, 0}, {0, 3}, {0, 0}, {4, 4}}), (Edges{0, 2})) << "from another corner";
    EXPECT_EQ(meeting({{0, 0}, {6, 0}, {6, 4}, {3, 0}, {0, 4}}), (Edges{0, 2}))
        << "a corner that touches an edge";
    EXPECT_EQ(meeting({{0, 9}, {-6, -8}, {9, 3}, {-9, 3}, {6, -8}}), (Edges{0, 2}))
        << "a star of five points, which turns left everywhere";
    EXPECT_EQ(meeting({{0, 0}, {4, 0}, {4, 4}, {4, 2}, {0, 2}}), (Edges{1, 2})) << "it turns back";
    EXPECT_EQ(
        meeting({{9, 9}, {0, 9}, {0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 2}, {4, 2}, {4, 3}, {9, 3}}),
        (Edges{3, 6}))
        << "along an edge";
}

TEST(Triangulate, WhatHasNoAreaHasNoNormal) {
    EXPECT_EQ(cut(in_plane({{0, 0}, {1, 1}, {2, 2}, {3, 3}})).form, FaceForm::no_area);
    EXPECT_EQ(cut(in_plane({{1, 1}, {1, 1}, {1, 1}, {1, 1}})).form, FaceForm::no_area);
    EXPECT_EQ(cut(in_plane({{0, 0}, {2, 2}, {2, 0}, {0, 2}})).form, FaceForm::no_area)
        << "one half takes away what the other adds";
}

TEST(Triangulate, CornersOffThePlaneAreMeasured) {
    Outline outline = in_plane({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    EXPECT_TRUE(cut(outline).is_planar);
    outline[2][2] = Rational(1, 2);
    // Half of what the corners span along the normal, (-2, -2, 32).
    const Triangulation found = cut(outline);
    EXPECT_FALSE(found.is_planar);
    EXPECT_NEAR(found.off_plane, 8 / std::sqrt(2 * 2 + 2 * 2 + 32 * 32) / 2, 1e-15);

    // By next to nothing, in whole numbers and beyond 64 bits.
    Outline large = in_plane({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    for (Corner& corner : large)
        for (Rational& coordinate : corner)
            coordinate *= Rational(10'000'000'000'000'000);
    EXPECT_TRUE(cut(large).is_planar);
    large[2][2] = 1;
    EXPECT_FALSE(cut(large).is_planar);
    EXPECT_NEAR(cut(large).off_plane, 0.25, 1e-15);
    outline[2][2] = Rational(1, mpz_class("1000000000000000000000000000000"));
    EXPECT_FALSE(cut(outline).is_planar);
    EXPECT_NEAR(cut(outline).off_plane * 1e30, 0.25, 1e-15);
}

TEST(Triangulate, ADenominatorOfManyPrimesIsRefused) {
    Outline outline = in_plane({{0, 0}, {4, 0}, {2, 1}, {4, 4}, {0, 4}});
    mpz_class prime("1000000007");
    for (int i = 0; i < 1200; ++i) {
        mpz_nextprime(prime.get_mpz_t(), prime.get_mpz_t());
        outline.push_back({Rational(1, prime), Rational(1, prime), Rational(0)});
    }
    EXPECT_EQ(cut(outline).form, FaceForm::too_fine);
}

/// How many triangles a face of many corners is cut into.
std::size_t triangles_of(const Outline& outline) {
    const auto vertices = vertices_of(outline);
    std::vector<std::size_t> face(outline.size());
    std::iota(face.begin(), face.end(), std::size_t{0});
    const Triangulation found = FaceCutter(vertices).cut(face);
    return found.ears ? found.ears->triangles.size() : 0;
}

/// A comb, with a tooth for every other corner.
Outline comb(int count) {
    std::vector<std::array<int, 2>> places;
    for (int i = 0; i < count; ++i)
        places.push_back({i, i % 2 * 1000});
    places.push_back({count, -10});
    places.push_back({-1, -10});
    return in_plane(places);
}

/// A star, with a spike for every other corner.
Outline star(int count) {
    std::vector<std::array<int, 2>> places;
    for (int i = 0; i < count; ++i) {
        const double radius = i % 2 == 0 ? 10'000'000 : 100'000;
        const double angle = 2 * std::numbers::pi * i / count;
        places.push_back({static_cast<int>(radius * std::cos(angle)),
                          static_cast<int>(radius * std::sin(angle))});
    }
    return in_plane(places);
}

// scripts/check-growth.sh measures the time that such faces take.
TEST(Triangulate, FacesOfEightyThousandCornersAreCut) {
    constexpr int count = all_cases(80000);
    for (const Outline& outline : {comb(count), star(count)})
        EXPECT_EQ(triangles_of(outline), outline.size() - 2);
}

} // namespace
} // namespace rastertrace
