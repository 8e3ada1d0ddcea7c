// SPDX-License-Identifier: MIT
// The rules of other programs, each against a second, plain implementation in fractions, with ties forced: vertices
// on samples, lines through corners of diamonds.

#include "random_choice.h"
#include "traces.h"

#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using Point = std::array<Rational, 2>;
using Pixels = std::multiset<std::pair<Index, Index>>;

constexpr int side_of_canvas = 12;
constexpr std::array scalars{"float", "double", "fixed", "adaptive", "exact"};

std::string text_of(const Point& p) {
    return "[\"" + p[0].get_str() + "\",\"" + p[1].get_str() + "\"]";
}

/// Where the pixels of the canvas are: 0 .. side_of_canvas - 1 with y down, or with y up.
std::string scene_of(const std::vector<Point>& points, const std::string& primitives,
                     bool is_y_down, const std::string& method) {
    std::string vertices;
    for (std::size_t i = 0; i < points.size(); ++i)
        vertices += fmt::format(R"({}"{}":{})", i == 0 ? "" : ",", "ABCDEF"[i], text_of(points[i]));
    return fmt::format(
        R"({{"canvas":{{"width":{0},"height":{0},"origin":"{1}"}},"vertices":{{{2}}},{3},"method":{{{4}}}}})",
        side_of_canvas, is_y_down ? "top-left" : "bottom-left", vertices, primitives, method);
}

Pixels plotted(const Trace& trace) {
    Pixels pixels;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (trace.kind_of(n) == StepKind::pixel) {
            const auto step = trace.step(n).as<PixelStep>();
            pixels.insert({step.x, step.y});
        }
    return pixels;
}

/// Draws a scene in every scalar, redoes what is told, and holds the pixels of those without rounding against what is
/// expected.
void expect_pixels(const std::vector<Point>& points, const std::string& primitives, bool is_y_down,
                   const std::string& method, const Pixels& expected) {
    for (const std::string scalar : scalars) {
        const std::string scene =
            scene_of(points, primitives, is_y_down,
                     method + (method.empty() ? "" : ",") + R"("scalar":")" + scalar + '"');
        const Trace trace = trace_of(scene_in(scene));
        const Redone redone = redo(trace);
        EXPECT_EQ(redone.wrong, 0U) << scene << redone.first.what;
        const bool rounds = scalar == "float" || scalar == "double";
        EXPECT_TRUE(rounds || plotted(trace) == expected) << scene;
    }
}

Point random_point(Random& random, int parts) {
    const auto coordinate = [&random, parts] {
        return Rational(Rational(random.whole(-2 * parts, (side_of_canvas + 1) * parts)) / parts);
    };
    const Rational x = coordinate();
    return {x, coordinate()};
}

Index floor_of(const Rational& x) {
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
    return whole.get_si();
}
Index ceil_of(const Rational& x) {
    return -floor_of(Rational(-x));
}

Rational cross(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

/// The ends of a triangle in a row, if it reaches that.
std::optional<std::array<Rational, 2>> ends_in_row(const std::vector<Point>& t, const Rational& y) {
    std::vector<Rational> meets;
    for (std::size_t i = 0; i < 3; ++i) {
        const Point& p = t[i];
        const Point& q = t[(i + 1) % 3];
        if (p[1] == y)
            meets.push_back(p[0]);
        if ((p[1] < y && y < q[1]) || (q[1] < y && y < p[1]))
            meets.emplace_back(p[0] + (y - p[1]) * (q[0] - p[0]) / (q[1] - p[1]));
    }
    if (meets.empty())
        return std::nullopt;
    const auto [low, high] = std::minmax_element(meets.begin(), meets.end());
    return std::array<Rational, 2>{*low, *high};
}

/// The pixels of a triangle row by row, samples at integers; `of(left, right)` are the first and the last one of a row.
Pixels rows_of(const std::vector<Point>& t, bool is_y_down, bool is_half_open,
               const std::function<std::array<Index, 2>(const Rational&, const Rational&)>& of) {
    const auto lowest = [&t, is_y_down] {
        Rational y = t[0][1];
        for (const Point& p : t)
            y = is_y_down ? std::max(y, p[1]) : std::min(y, p[1]);
        return y;
    }();
    Pixels pixels;
    for (Index y = 0; y < side_of_canvas; ++y) {
        const auto ends = ends_in_row(t, Rational(y));
        if (!ends || (is_half_open && lowest == y))
            continue;
        const auto [from, to] = of((*ends)[0], (*ends)[1]);
        for (Index x = std::max<Index>(from, 0); x <= std::min<Index>(to, side_of_canvas - 1); ++x)
            pixels.insert({x, y});
    }
    return pixels;
}

std::vector<Point> random_triangle(Random& random) {
    const int parts = random.pick({1, 1, 2, 4});
    return {random_point(random, parts), random_point(random, parts), random_point(random, parts)};
}

TEST(HalfOpenRows, LeaveOutTheRowOfTheLowestVertex) {
    Random random(1);
    for (int run = 0; run < 150; ++run) {
        const auto t = random_triangle(random);
        const bool is_y_down = random.chance(2);
        const std::string fill = random.pick({"scanline", "two-halves"});
        const Pixels expected =
            rows_of(t, is_y_down, true, [](const Rational& left, const Rational& right) {
                return std::array{ceil_of(left), ceil_of(right) - 1};
            });
        expect_pixels(t, R"("triangles":["ABC"])", is_y_down,
                      R"("rows":"half-open","rounding":"half-open","fill":")" + fill + '"',
                      expected);
    }
}

/// Four triangles around a point: with half-open rows and ends each pixel is drawn once, with closed ones the pixels
/// on shared edges are drawn by each.
TEST(HalfOpenRows, GiveEachPixelOfASharedEdgeToOneTriangle) {
    Random random(2);
    std::size_t closed_twice = 0;
    for (int run = 0; run < 100; ++run) {
        const int parts = random.pick({1, 2, 3});
        const std::vector<Point> points{
            {Rational(random.whole(0, 3)), Rational(random.whole(0, 3))},
            {Rational(random.whole(8, 11)), Rational(random.whole(0, 3))},
            {Rational(random.whole(8, 11)), Rational(random.whole(8, 11))},
            {Rational(random.whole(0, 3)), Rational(random.whole(8, 11))},
            {Rational(Rational(random.whole(4 * parts, 7 * parts)) / parts),
             Rational(Rational(random.whole(4 * parts, 7 * parts)) / parts)}};
        for (const bool is_half_open : {true, false}) {
            const std::string rule = is_half_open ? R"("rows":"half-open","rounding":"half-open")"
                                                  : R"("rounding":"inside")";
            const Pixels all = plotted(
                trace_of(scene_in(scene_of(points, R"("triangles":["ABE","BCE","CDE","DAE"])",
                                           random.chance(2), rule + R"(,"scalar":"exact")"))));
            const std::set<std::pair<Index, Index>> once(all.begin(), all.end());
            EXPECT_TRUE(!is_half_open || once.size() == all.size()) << run;
            closed_twice += is_half_open ? 0 : all.size() - once.size();
        }
    }
    EXPECT_GT(closed_twice, 100U);
}

/// By edge functions in fractions: a sample inside, on a left edge, or on the horizontal edge of the rule.
TEST(HorizontalEdge, HasItsSamplesAtTheBottomOrAtTheTop) {
    Random random(7);
    for (int run = 0; run < 200; ++run) {
        const auto t = random_triangle(random);
        const Rational area = cross(t[0], t[1], t[2]);
        if (area == 0)
            continue;
        const bool is_y_down = random.chance(2);
        const bool is_bottom = random.chance(2);
        Pixels expected;
        for (Index y = 0; y < side_of_canvas; ++y)
            for (Index x = 0; x < side_of_canvas; ++x) {
                const Point p{x + Rational(1, 2), y + Rational(1, 2)};
                const bool is_inside = [&] {
                    for (std::size_t i = 0; i < 3; ++i) {
                        const Point& a = t[i];
                        const Point& b = t[(i + 1) % 3];
                        const Point& c = t[(i + 2) % 3];
                        const int side = sgn(Rational(cross(a, b, p) * area));
                        // Of a slanted edge, the triangle lies right of it; of a level one, above or below.
                        const Rational at =
                            a[1] == b[1]
                                ? Rational(0)
                                : Rational(a[0] + (c[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]));
                        const bool is_below = (c[1] > a[1]) == is_y_down;
                        const bool owns = a[1] == b[1] ? is_below != is_bottom : at < c[0];
                        if (side < 0 || (side == 0 && !owns))
                            return false;
                    }
                    return true;
                }();
                if (is_inside)
                    expected.insert({x, y});
            }
        expect_pixels(t, R"("triangles":["ABC"])", is_y_down,
                      fmt::format(R"("fill":"top-left","horizontal_edge":"{}")",
                                  is_bottom ? "bottom" : "top"),
                      expected);
    }
}

/// The pixels whose samples have no weight below 0 in a triangle.
Pixels pixels_by_weights(const std::vector<Point>& t, const Rational& offset) {
    const Rational area = cross(t[0], t[1], t[2]);
    Pixels pixels;
    for (Index y = 0; y < side_of_canvas; ++y)
        for (Index x = 0; x < side_of_canvas; ++x) {
            const Point p{x + offset, y + offset};
            if (cross(t[1], t[2], p) / area >= 0 && cross(t[2], t[0], p) / area >= 0 &&
                cross(t[0], t[1], p) / area >= 0)
                pixels.insert({x, y});
        }
    return pixels;
}

TEST(Rows, AreRefusedWhereTheyMeanNothing) {
    EXPECT_EQ(refusal_of_scene(R"({"vertices":{"A":[0,0],"B":[4,0],"C":[0,4]},"triangles":["ABC"],)"
                               R"("method":{"rows":"half-open","fill":"top-left"}})"),
              R"(expected a fill by rows beside "rows": "half-open", found "fill": "top-left")");
}

/// A place of the samples, and how far it is from the pixel's integer point.
struct SamplePlace {
    std::string name;
    Rational offset;

    std::string method() const { return R"("sample":")" + name + '"'; }
};

SamplePlace random_place(Random& random) {
    return random.pick<SamplePlace>({{"center", Rational(1, 2)}, {"integer", 0}});
}

std::vector<Point> moved(std::vector<Point> points, const Rational& by) {
    for (Point& p : points)
        p = {Rational(p[0] - by), Rational(p[1] - by)};
    return points;
}

TEST(SamplePlaces, AreWhereTheRowsOfATriangleLook) {
    Random random(8);
    for (int run = 0; run < 150; ++run) {
        const auto t = random_triangle(random);
        const bool is_y_down = random.chance(2);
        const SamplePlace place = random_place(random);
        const std::string fill = random.pick({"scanline", "two-halves"});
        const bool is_floor = random.chance(2);
        const Pixels expected =
            rows_of(moved(t, place.offset), is_y_down, !is_floor,
                    [is_floor](const Rational& left, const Rational& right) {
                        return is_floor ? std::array{floor_of(left), floor_of(right)}
                                        : std::array{ceil_of(left), ceil_of(right) - 1};
                    });
        expect_pixels(t, R"("triangles":["ABC"])", is_y_down,
                      fmt::format(R"({},"fill":"{}"{})", place.method(), fill,
                                  is_floor ? "" : R"(,"rows":"half-open","rounding":"half-open")"),
                      expected);
    }
}

TEST(SamplePlaces, AreWhereWeightsAreTested) {
    Random random(9);
    for (int run = 0; run < 100; ++run) {
        const auto t = random_triangle(random);
        if (cross(t[0], t[1], t[2]) == 0)
            continue;
        const bool is_y_down = random.chance(2);
        const SamplePlace place = random_place(random);
        expect_pixels(t, R"("triangles":["ABC"])", is_y_down,
                      place.method() + R"(,"fill":"barycentric")",
                      pixels_by_weights(t, place.offset));
    }
}

/// The nearest whole number; a half goes up or down.
Index nearest_of(const Rational& x, bool goes_up) {
    return goes_up ? floor_of(x + Rational(1, 2)) : ceil_of(x - Rational(1, 2));
}

/// Whether a half goes up, by the rule of a line's ties.
bool tie_goes_up(const std::string& ties, const Rational& at, bool falls) {
    if (ties == "start" || ties == "step")
        return (ties == "start") == falls;
    if (ties == "even")
        return floor_of(at) % 2 != 0;
    return ties == "up" || at > 0;
}

/// A line as seen from the samples: a pixel at each whole number along its longer side.
Pixels pixels_of_line(Point a, Point b, bool between_pixels, const std::string& ties) {
    const auto nearest = [](const Point& p) {
        return Point{Rational(nearest_of(p[0], true)), Rational(nearest_of(p[1], true))};
    };
    if (between_pixels) {
        a = nearest(a);
        b = nearest(b);
    }
    const bool is_x_major = abs(Rational(b[0] - a[0])) >= abs(Rational(b[1] - a[1]));
    const std::size_t along = is_x_major ? 0 : 1;
    const std::size_t across = 1 - along;
    const auto [low, high] = std::minmax({nearest_of(a[along], true), nearest_of(b[along], true)});
    Pixels pixels;
    for (Index i = low; i <= high; ++i) {
        const Rational run = b[along] - a[along];
        const Rational at =
            run == 0 ? a[across]
                     : Rational(a[across] + (i - a[along]) * (b[across] - a[across]) / run);
        const Index other = nearest_of(at, tie_goes_up(ties, at, b[across] < a[across]));
        const auto pixel = is_x_major ? std::pair(i, other) : std::pair(other, i);
        if (std::min(pixel.first, pixel.second) >= 0 &&
            std::max(pixel.first, pixel.second) < side_of_canvas)
            pixels.insert(pixel);
    }
    return pixels;
}

TEST(SamplePlaces, AreWhereLinesLook) {
    Random random(10);
    for (int run = 0; run < 200; ++run) {
        const int parts = random.pick({1, 2, 4});
        const std::vector<Point> ends{random_point(random, parts), random_point(random, parts)};
        const bool is_y_down = random.chance(2);
        const SamplePlace place = random_place(random);
        const std::string line = random.pick({"naive", "dda", "bresenham"});
        const auto seen = moved(ends, place.offset);
        expect_pixels(ends, R"("lines":["AB"])", is_y_down,
                      place.method() + R"(,"line":")" + line + '"',
                      pixels_of_line(seen[0], seen[1], line == "bresenham",
                                     line == "bresenham" ? "start" : "up"));
    }
}

/// Bresenham's line knows two rules for ties: it steps, or not.
TEST(TiesOfLines, GoAsTheMethodSays) {
    Random random(13);
    std::size_t differ = 0;
    for (int run = 0; run < 200; ++run) {
        const std::vector<Point> ends{random_point(random, 1), random_point(random, 1)};
        const std::string line = random.pick({"naive", "dda", "bresenham"});
        const std::string ties = line == "bresenham"
                                     ? random.pick({"start", "step"})
                                     : random.pick({"start", "step", "up", "away", "even"});
        const Pixels expected = pixels_of_line(ends[0], ends[1], line == "bresenham", ties);
        differ +=
            expected == pixels_of_line(ends[0], ends[1], line == "bresenham", "start") ? 0 : 1;
        expect_pixels(ends, R"("lines":["AB"])", random.chance(2),
                      fmt::format(R"("line":"{}","ties":"{}")", line, ties), expected);
    }
    EXPECT_GT(differ, 10U);
}

/// Everything that is drawn, whatever the samples are: a scene looks from them as the moved one does from integers.
TEST(SamplePlaces, MoveAllThatIsDrawn) {
    Random random(11);
    std::size_t drawn = 0;
    for (int run = 0; run < 300; ++run) {
        std::vector<Point> points;
        for (int i = 0; i < 5; ++i)
            points.push_back(random_point(random, random.pick({1, 2, 4})));
        const bool is_y_down = random.chance(2);
        const SamplePlace place = random_place(random);
        const std::string fill =
            random.pick({"scanline", "two-halves", "barycentric", "top-left", "fan"});
        const bool has_rows = fill == "scanline" || fill == "two-halves";
        const std::string primitives =
            random.pick({R"("triangles":["ABC","BCD"],"outlines":["CDE"])",
                         R"("outlines":["ABC"],"points":["D"])",
                         R"("lines":["AB","CD"],"circles":[{"center":"E","radius":3}])",
                         R"("triangles":["ABC"],"points":["D","E"])"});
        const std::string method = fmt::format(
            R"("fill":"{}","line":"{}","lerp":"{}"{})", fill,
            random.pick({"naive", "dda", "bresenham", "diamond-exit"}),
            random.pick({"direct", "incremental"}),
            has_rows ? fmt::format(R"(,"rounding":"{}")",
                                   random.pick({"floor", "nearest", "truncate", "inside"}))
                     : "");
        const Trace from_integers =
            trace_of(scene_in(scene_of(moved(points, place.offset), primitives, is_y_down,
                                       method + R"(,"scalar":"exact","sample":"integer")")));
        const Pixels expected = plotted(from_integers);
        drawn += expected.size();
        expect_pixels(points, primitives, is_y_down, method + "," + place.method(), expected);
    }
    EXPECT_GT(drawn, 3000U);
}

/// A depth is that of the triangle's plane at the sample.
TEST(SamplePlaces, AreWhereDepthsAndColorsAre) {
    Random random(12);
    std::size_t tested = 0;
    for (int run = 0; run < 60; ++run) {
        const auto t = random_triangle(random);
        const Rational area = cross(t[0], t[1], t[2]);
        if (area == 0)
            continue;
        const bool is_y_down = random.chance(2);
        const SamplePlace place = random_place(random);
        const std::string fill = random.pick({"scanline", "two-halves", "barycentric", "top-left"});
        std::string vertices;
        std::vector<Rational> depths;
        for (std::size_t i = 0; i < 3; ++i) {
            depths.emplace_back(random.whole(1, 9));
            vertices += fmt::format(R"({}"{}":["{}","{}",{}])", i == 0 ? "" : ",", "ABC"[i],
                                    t[i][0].get_str(), t[i][1].get_str(), depths[i].get_str());
        }
        for (const std::string scalar : {"exact", "adaptive", "double"}) {
            const std::string scene = fmt::format(
                R"({{"canvas":{{"width":{0},"height":{0},"origin":"{1}"}},"vertices":{{{2}}},)"
                R"("keep":["depth"],"colors":{{"A":"#f00","B":"#0f0","C":"#00f"}},"triangles":["ABC"],)"
                R"("method":{{{3},"fill":"{4}","rounding":"inside",)"
                R"("depth":"linear-z","scalar":"{5}"}}}})",
                side_of_canvas, is_y_down ? "top-left" : "bottom-left", vertices, place.method(),
                fill, scalar);
            const Trace trace = trace_of(scene_in(scene));
            const Redone redone = redo(trace);
            EXPECT_EQ(redone.wrong, 0U) << scene << redone.first.what;
            for (std::size_t n = 1; n <= trace.size() && scalar == "exact"; ++n) {
                if (trace.kind_of(n) != StepKind::depth)
                    continue;
                const auto step = trace.step(n).as<DepthStep>();
                const Point p{step.x + place.offset, step.y + place.offset};
                const Rational depth =
                    (cross(t[1], t[2], p) * depths[0] + cross(t[2], t[0], p) * depths[1] +
                     cross(t[0], t[1], p) * depths[2]) /
                    area;
                EXPECT_EQ(step.depth.exact(), depth) << scene;
                ++tested;
            }
        }
    }
    EXPECT_GT(tested, 500U);
}

TEST(SamplePlaces, AreTwo) {
    for (const std::string wrong : {"[0.25,0.75]", R"("1/4 3/4")", R"("middle")", "0", "{}"}) {
        const std::string refusal = refusal_of_scene(
            R"({"vertices":{"A":[0,0],"B":[4,0],"C":[0,4]},"triangles":["ABC"],"method":{"sample":)" +
            wrong + "}}");
        EXPECT_TRUE(refusal.starts_with("expected one of integer, center, found ")) << refusal;
    }
}

/// |x - i| + |y - j| of the point of a line at t.
Rational distance_in_diamond(const Point& a, const Point& b, const Point& center,
                             const Rational& t) {
    Rational sum = 0;
    for (std::size_t i = 0; i < 2; ++i)
        sum += abs(Rational(a[i] + t * (b[i] - a[i]) - center[i]));
    return sum;
}

/// OpenGL's definition, pixel by pixel, with an e that is small enough for coordinates in quarters: the moved line
/// meets the diamond, and does not end in it.
Pixels pixels_of_diamonds(Point a, Point b, bool is_y_down, const Rational& sample) {
    const Rational e = Rational(1) / (1 << 20);
    for (Point* p : {&a, &b}) {
        (*p)[0] -= e;
        (*p)[1] -= (is_y_down ? -1 : 1) * e * e;
    }
    Pixels pixels;
    for (Index y = 0; y < side_of_canvas; ++y)
        for (Index x = 0; x < side_of_canvas; ++x) {
            const Point center{x + sample, y + sample};
            std::vector<Rational> ts{0, 1};
            for (std::size_t i = 0; i < 2; ++i)
                if (a[i] != b[i])
                    ts.emplace_back((center[i] - a[i]) / (b[i] - a[i]));
            const bool meets = std::any_of(ts.begin(), ts.end(), [&](const Rational& t) {
                return 0 <= t && t <= 1 && distance_in_diamond(a, b, center, t) < Rational(1, 2);
            });
            if (meets && distance_in_diamond(a, b, center, 1) >= Rational(1, 2))
                pixels.insert({x, y});
        }
    return pixels;
}

TEST(DiamondExit, DrawsTheDiamondsThatALineLeaves) {
    Random random(5);
    std::size_t drawn = 0;
    for (int run = 0; run < 250; ++run) {
        const int parts = random.pick({1, 2, 4});
        const Point a = random_point(random, parts);
        const Point b = random.chance(4) ? Point{a[0] + Rational(random.whole(-4, 4)) / 4,
                                                 a[1] + Rational(random.whole(-4, 4)) / 4}
                                         : random_point(random, parts);
        const bool is_y_down = random.chance(2);
        const bool is_center = random.chance(2);
        const Pixels expected =
            pixels_of_diamonds(a, b, is_y_down, is_center ? Rational(1, 2) : Rational(0));
        drawn += expected.size();
        expect_pixels(
            {a, b}, R"("lines":["AB"])", is_y_down,
            fmt::format(R"("line":"diamond-exit","sample":"{}")", is_center ? "center" : "integer"),
            expected);
    }
    EXPECT_GT(drawn, 500U);
}

/// A line that is cut at a point of it has the same pixels as its two parts, none of them twice.
TEST(DiamondExit, ALineIsTheLinesThatItIsMadeOf) {
    Random random(6);
    for (int run = 0; run < 100; ++run) {
        const Point a = random_point(random, 2);
        const Point c = random_point(random, 2);
        const Point b{(a[0] + c[0]) / 2, (a[1] + c[1]) / 2};
        const bool is_y_down = random.chance(2);
        const auto pixels = [&](const std::string& lines) {
            return plotted(trace_of(scene_in(scene_of(
                {a, b, c}, lines, is_y_down, R"("line":"diamond-exit","scalar":"exact")"))));
        };
        EXPECT_TRUE(pixels(R"("lines":["AB","BC"])") == pixels(R"("lines":["AC"])")) << run;
    }
}

} // namespace
} // namespace rastertrace
