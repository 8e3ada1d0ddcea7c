// SPDX-License-Identifier: MIT
// C: coverage by edge functions. Samples at the centers of pixels, the top-left rule, y down, 64x64
// unless said.

#include "stress_rows.h"

#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/raster/edge_function.h>
#include <rastertrace/core/raster/triangle.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace rastertrace {

namespace {

const MethodOverrides top_left{{"fill", "top-left"}};
const MethodOverrides closed{{"fill", "barycentric"}, {"sample", "center"}};

/// A scene of one triangle ABC, filled by the top-left rule.
std::string triangle_in(std::string_view a, std::string_view b, std::string_view c, int side = 64) {
    return fmt::format(R"({{
  "canvas": {{"width": {3}, "height": {3}, "origin": "top-left"}},
  "vertices": {{"A": [{0}], "B": [{1}], "C": [{2}]}},
  "triangles": ["ABC"],
  "method": {{"fill": "top-left"}}
}})",
                       a, b, c, side);
}

const std::string c2 = triangle_in(R"(0, "1/4")", R"(64, "3/8")", R"(64, "5/16")");
const std::string c3 = triangle_in("0, 0.5", "64, 0.5", R"(64, "129/256")");
const std::string c4 = triangle_in("0, 0.5", "64, 0.5", R"(64, "127/256")");
const std::string c5 = triangle_in("0, 0", "64, 64", R"(64, "16383/256")");
const std::string c13 = triangle_in("0, 0", "8, 0", R"(0, "8193/1024")", 16);
const std::string c14 = triangle_in("0.5, 0.5", R"("513/1024", 0.5)", R"(0.5, "513/1024")", 16);
const std::string c18 =
    triangle_in(R"("1919/256", "1919/256")", R"("1921/256", "1919/256")", R"(7.5, "1921/256")", 16);
const std::string c18_moved =
    triangle_in(R"(7.5, "1919/256")", R"("1922/256", "1919/256")", R"("1921/256", "1921/256")", 16);

/// Six triangles round a hub that is the center of pixel (20, 20). `triangles` says which are drawn.
std::string hub(std::string_view triangles) {
    return fmt::format(R"({{
  "canvas": {{"width": 64, "height": 64, "origin": "top-left"}},
  "vertices": {{"H": [20.5, 20.5], "A": [34.5, 20.5], "B": [27.5, 32.5], "C": [13.5, 32.5],
               "D": [6.5, 20.5], "E": [13.5, 8.5], "F": [27.5, 8.5]}},
  "triangles": [{}],
  "method": {{"fill": "top-left", "shade": "faces"}}
}})",
                       triangles);
}
constexpr std::array<std::string_view, 6> sectors{R"("HAB")", R"("HBC")", R"("HCD")",
                                                  R"("HDE")", R"("HEF")", R"("HFA")"};
const std::string all_sectors = joined(sectors, ", ");

/// How many of the triangles of a scene have a pixel, by a method.
std::uint64_t owners_of(const Scene& scene, Pixel pixel) {
    std::uint64_t owners = 0;
    for (std::size_t i = 0; i < scene.primitives.size(); ++i)
        owners += covered_by(exact_corners(scene, i), scene.method,
                             scene.canvas)[scene.canvas.offset_of(pixel)]
                      ? 1
                      : 0;
    return owners;
}

/// The same with one scalar: how many of the triangles, each drawn alone, plot it.
std::uint64_t drawn_owners_of(std::span<const std::string_view> triangles,
                              const MethodOverrides& method, Pixel pixel) {
    std::uint64_t owners = 0;
    for (const std::string_view triangle : triangles) {
        const Scene scene = readable_scene(hub(triangle), method);
        owners += drawn_picture(scene)[scene.canvas.offset_of(pixel)] == no_color ? 0 : 1;
    }
    return owners;
}

/// Twice the signed area of a triangle at whole places, in the numbers that it is drawn with.
struct WholeTriangle {
    std::array<std::array<Index, 2>, 3> at;

    std::string json() const {
        const auto place = [this](std::size_t i) {
            return fmt::format("{}, {}", at[i][0], at[i][1]);
        };
        return triangle_in(place(0), place(1), place(2));
    }

    Rational exact() const {
        const auto x = [this](std::size_t i) { return Rational(static_cast<long>(at[i][0])); };
        const auto y = [this](std::size_t i) { return Rational(static_cast<long>(at[i][1])); };
        return (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
    }

    void add_to(StressRows& rows, std::string_view label,
                const DocumentedOfScalars& documented) const {
        rows.add_for_all(label, documented, [this](std::string_view scalar) -> Measured {
            const Scene scene = readable_scene(json(), with_scalar_named({}, scalar));
            const Rational found =
                with_numbers_of(scene, [&scene]<typename Scalar>(const Plan& plan) {
                    return exact_value(
                        Barycentric<Scalar>(Triangle<Scalar>{{place_of<Scalar>(scene, 0, plan),
                                                              place_of<Scalar>(scene, 1, plan),
                                                              place_of<Scalar>(scene, 2, plan)}})
                            .area2());
                });
            return {.wrong = found == exact() ? 0u : 1u,
                    .unit = "area",
                    .note = fmt::format("2A = {}", found.get_str())};
        });
    }
};

/// (0,0), (F(n), F(n+1)), (F(n+1), F(n+2)) of Fibonacci's numbers, F(1) = F(2) = 1: twice its area is
/// F(n) F(n+2) - F(n+1)^2, which Cassini says is 1 or -1.
WholeTriangle cassini(int n) {
    Index f = 1;
    Index next = 1;
    for (int i = 1; i < n; ++i)
        f = std::exchange(next, f + next);
    return {{{{0, 0}, {f, next}, {next, f + next}}}};
}

/// C8: a small triangle at (k, k).
WholeTriangle shifted(Index k) {
    return {{{{k, k}, {k + 3, k + 1}, {k + 1, k + 3}}}};
}

/// The constant term of the edge function from the first to the second vertex of C8.
template <typename Scalar> Scalar constant_term(const Vec<Scalar, 2>& p, const Vec<Scalar, 2>& q) {
    const Scalar a = p.y - q.y;
    const Scalar b = q.x - p.x;
    return -(a * p.x) - b * p.y;
}

/// C9: the largest extent, in pixels, for which no edge value (the difference of two products of
/// extents) exceeds an integer of so many bits, with vertices on a grid of 1/2^subpixel_bits.
Index largest_safe_extent(int bits, int subpixel_bits) {
    const mpz_class largest = (mpz_class(1) << static_cast<unsigned>(bits - 1)) - 1;
    const mpz_class most = sqrt(mpz_class(largest / 2));
    return mpz_class(most >> static_cast<unsigned>(subpixel_bits)).get_si();
}

/// A triangle that covers the canvas, so many pixels wide and high.
std::string wide_triangle(Index extent) {
    return triangle_in("0, 0", fmt::format("{}, 0", extent), fmt::format("0, {}", extent));
}

std::string huge_triangle(std::string_view power) {
    return triangle_in(fmt::format("-1e{0}, -1e{0}", power), fmt::format("3e{0}, -1e{0}", power),
                       fmt::format("-1e{0}, 3e{0}", power));
}

/// C12: an edge function from (0, 0) to b, at b itself, by a fused multiply-add.
template <typename Real> Measured fused_edge(Real x, Real y) {
    const Real value = std::fma(x, y, -(y * x));
    return {.wrong = value == 0 ? 0u : 1u,
            .unit = "value",
            .worst = std::abs(static_cast<double>(value)),
            .worst_unit = "px^2"};
}

/// The same for 10,000 vertices on a grid of 1/10, seen from (1/10, 1/10).
template <typename Real> Measured edges_on_grid(bool is_fused) {
    Measured measured{.unit = "value"};
    for (int i = 1; i <= 100; ++i)
        for (int k = 1; k <= 100; ++k) {
            const Real x = static_cast<Real>(i) * static_cast<Real>(0.1);
            const Real y = static_cast<Real>(k) * static_cast<Real>(0.1);
            const Real value = is_fused ? std::fma(x, y, -(y * x)) : x * y - y * x;
            measured.wrong += value == 0 ? 0 : 1;
        }
    measured.note = "of 10000";
    return measured;
}

/// C15: two triangles below an edge PQ, and one above; M lies next to PQ, not on it.
std::string t_junction(std::string_view m) {
    return fmt::format(R"({{
  "canvas": {{"width": 64, "height": 96, "origin": "top-left"}},
  "vertices": {{"P": [0, 20], "Q": [40, 27], "T": [32, -20], "M": [{}], "B": [32, 90]}},
  "triangles": ["PQT", "PMB", "MQB"],
  "method": {{"fill": "top-left", "shade": "faces"}}
}})",
                       m);
}
constexpr std::string_view m_below = R"(7, "85/4")";
constexpr std::string_view m_above = R"(33, "103/4")";

/// How many of the triangles, each drawn alone, plot each pixel.
std::vector<int> junction_layers(std::string_view m, std::string_view scalar) {
    const Scene all = readable_scene(t_junction(m), with_scalar_named({}, scalar));
    std::vector<int> layers(all.canvas.area());
    for (const ScenePrimitive& triangle : all.primitives) {
        Scene alone = all;
        alone.primitives = {triangle};
        const auto picture = drawn_picture(alone);
        for (std::size_t i = 0; i < picture.size(); ++i)
            layers[i] += picture[i] == no_color ? 0 : 1;
    }
    return layers;
}

/// The pixels for which `is_wrong(place)`, and where the first of them is.
template <typename IsWrong> Measured pixels_wrong(const Canvas& canvas, IsWrong&& is_wrong) {
    Measured measured{.unit = "pixel"};
    for (int row = 0; row < canvas.height; ++row)
        for (int column = 0; column < canvas.width; ++column)
            if (is_wrong(static_cast<std::size_t>(row * canvas.width + column)) &&
                ++measured.wrong == 1)
                measured.note = fmt::format("({}, {})", column, row);
    return measured;
}

/// Inside the hull of P, T, Q and B: samples in none of the triangles, and in more than one.
void add_junction(StressRows& rows, std::string_view m, const Documented& in_none,
                  const Documented& in_two) {
    const Scene scene = readable_scene(t_junction(m));
    const auto at = [&scene](std::size_t vertex) {
        return ExactPoint{scene.vertices[vertex].x.exact(), scene.vertices[vertex].y.exact()};
    };
    // The hull without M: P, T, Q, B. What an edge of it excludes belongs to nobody.
    const CoveredPixels hull = covered_by_polygon({at(0), at(2), at(1), at(4)}, scene.canvas);
    std::string place_of_m(m);
    std::erase(place_of_m, '"');
    rows.add_for_all(fmt::format("M = ({}), in no triangle", place_of_m), {{"all", in_none}},
                     [&](std::string_view scalar) {
                         const auto layers = junction_layers(m, scalar);
                         return pixels_wrong(scene.canvas, [&](std::size_t i) {
                             return hull[i] && layers[i] == 0;
                         });
                     });
    rows.add_for_all(fmt::format("M = ({}), in two", place_of_m), {{"all", in_two}},
                     [&](std::string_view scalar) {
                         const auto layers = junction_layers(m, scalar);
                         return pixels_wrong(scene.canvas,
                                             [&](std::size_t i) { return layers[i] > 1; });
                     });
}

/// C16's triangle, its vertices in an order, moved by whole pixels.
std::string c16(std::array<std::size_t, 3> order, Index right, Index down) {
    constexpr std::array<std::array<Index, 2>, 3> sixteenths{{{106, 532}, {172, 71}, {55, 10}}};
    std::array<std::string, 3> at;
    for (std::size_t i = 0; i < 3; ++i)
        at[i] = fmt::format(R"("{}/16", "{}/16")", sixteenths[order[i]][0] + 16 * right,
                            sixteenths[order[i]][1] + 16 * down);
    return triangle_in(at[0], at[1], at[2]);
}

/// C17: twice the area of C16's triangle in float, moved to the right.
Measured area_of_shifted(Index shift) {
    const auto place = [shift](Index x, Index y) {
        return Vec<float, 2>{static_cast<float>(shift) + static_cast<float>(x) / 16,
                             static_cast<float>(y) / 16};
    };
    const Triangle<float> triangle{{place(106, 532), place(172, 71), place(55, 10)}};
    const Rational found = exact_value(Barycentric<float>(triangle).area2());
    const Rational exact = exact_area2(exact_corners(readable_scene(c16({0, 1, 2}, 0, 0)), 0));
    return {.wrong = found == exact ? 0u : 1u,
            .unit = "area",
            .note = fmt::format("2A = {}, exactly {}", found.get_str(), exact.get_str())};
}

/// C1 attacks the rule for samples on edges and vertices: each has one owner.
void c1_hub(StressRows& rows) {
    for (std::size_t i = 0; i < sectors.size(); ++i)
        rows.add_pictures(hub(sectors[i]), fmt::format("top-left, sector {}", i + 1), top_left,
                          i % 2 == 0 ? 91 : 77);
    rows.add_pictures(hub(all_sectors), "top-left, all", top_left, 504);
    for (const std::string_view scalar : scalar_names()) {
        rows.expect_same(scalar, "top-left, owners of the hub's pixel",
                         drawn_owners_of(sectors, with_scalar_named(top_left, scalar), {20, 20}), 1,
                         "owner");
        const auto owners = drawn_owners_of(sectors, with_scalar_named(closed, scalar), {20, 20});
        rows.add(scalar, "barycentric, further owners", {.wrong = owners - 1, .unit = "owner"},
                 wrong(5));
    }
    rows.expect_same("reference", "top-left, owners of the hub's pixel",
                     owners_of(readable_scene(hub(all_sectors)), {20, 20}), 1, "owner");
}

/// C2 attacks fills that draw something of every triangle.
void c2_sliver_between_samples(StressRows& rows) {
    rows.add_pictures(c2, "top-left", top_left, 0);
}

/// C3 attacks the rule for a top edge.
void c3_sliver_on_samples(StressRows& rows) {
    rows.add_pictures(c3, "top-left", top_left, 64);
}

/// C4 attacks the rule for a bottom edge.
void c4_sliver_below_samples(StressRows& rows) {
    rows.add_pictures(c4, "top-left", top_left, 0);
}

/// C5 attacks coarse grids, on which a thin triangle loses its area.
void c5_diagonal_sliver(StressRows& rows) {
    rows.add_pictures(c5, "top-left", top_left, 64);
    const Scene scene = readable_scene(c5);
    const auto on_grid = reference_picture(snapped_to_grid(scene, 16));
    rows.add(
        "exact", "textbook: a grid of 1/16",
        {.wrong = differing(on_grid, reference_picture(scene)), .unit = "pixel", .note = "no area"},
        wrong(64));
}

/// C6 attacks the difference of two large products in float.
void c6_cassini_float(StressRows& rows) {
    cassini(17).add_to(rows, "F17", {});
    cassini(18).add_to(rows, "F18", {{"float", wrong(1, "", "2A = 0")}});
}

/// C7 attacks it in double.
void c7_cassini_double(StressRows& rows) {
    cassini(39).add_to(rows, "F39",
                       {{"float", wrong(1, "", "2A = 0")}, {"double", wrong(1, "", "2A = 2")}});
    cassini(40).add_to(rows, "F40",
                       {{"float", wrong(1, "", "2A = 0")}, {"double", wrong(1, "", "2A = 0")}});
}

/// C8 attacks edge functions written as a x + b y + c, whose c keeps no digit far out.
void c8_far_from_origin(StressRows& rows) {
    shifted(0).add_to(rows, "2A at k = 0", {});
    shifted(1 << 24).add_to(rows, "2A at k = 2^24", {{"float", wrong(1, "", "2A = 16")}});
    const DocumentedOfScalars documented{{"float", wrong(1, "", "-67108864")}};
    rows.add_for_all("constant term at k = 2^24", documented, [](std::string_view scalar) {
        const Scene with = readable_scene(shifted(1 << 24).json(), with_scalar_named({}, scalar));
        const Rational found = with_numbers_of(with, [&with]<typename Scalar>(const Plan& plan) {
            return exact_value(constant_term<Scalar>(place_of<Scalar>(with, 0, plan),
                                                     place_of<Scalar>(with, 1, plan)));
        });
        return Measured{
            .wrong = found == -33'554'432 ? 0u : 1u, .unit = "term", .note = found.get_str()};
    });
}

/// C9 attacks edge functions in integers that are too short.
void c9_overflowing_products(StressRows& rows) {
    for (const auto& [bits, subpixel_bits, extent] : {std::array<Index, 3>{32, 0, 32'767},
                                                      {32, 4, 2047},
                                                      {32, 8, 127},
                                                      {32, 12, 7},
                                                      {32, 16, 0},
                                                      {64, 8, 8'388'607}})
        rows.expect_same(fmt::format("int{}", bits),
                         fmt::format("largest safe extent, s = {}", subpixel_bits),
                         static_cast<std::uint64_t>(largest_safe_extent(
                             static_cast<int>(bits), static_cast<int>(subpixel_bits))),
                         static_cast<std::uint64_t>(extent), "pixel");
    for (const Index extent : {Index{128}, Index{8'388'608}})
        rows.add_pictures(wide_triangle(extent), fmt::format("top-left, n = {}", extent), top_left,
                          4096);
}

/// C10 attacks products that overflow to infinity: their difference is NaN, and nothing is drawn.
void c10_huge_triangle(StressRows& rows) {
    rows.add_pictures(huge_triangle("30"), "top-left, 1e30", top_left, 4096,
                      {{"float fixed", refused("found vertex A at (-1e+30, -1e+30)")}});
    rows.add_pictures(huge_triangle("200"), "top-left, 1e200", top_left, 4096,
                      {{"float double fixed", refused("found vertex A at (-1e+200, -1e+200)")}});
}

/// C11 attacks the reading of numbers: every comparison with NaN is false.
void c11_no_numbers(StressRows& rows) {
    for (const std::string_view number : {"NaN", "Infinity", "-Infinity", "1e400"})
        rows.add_refusals(triangle_in(fmt::format("{}, 0", number), "8, 0", "0, 8"),
                          fmt::format("x = {}", number), number.starts_with('-') ? "-" : number);
}

/// C12 attacks compilers that fuse a product with a sum.
void c12_own_vertex(StressRows& rows) {
    const auto zero = [&rows](std::string_view scalar, auto b) {
        using Real = decltype(b.x);
        const Vec<Real, 2> origin{0, 0};
        const Real value = edge_function<Real>({origin, 0}, {b, 1}).at(b);
        rows.add(scalar, "edge function", {.wrong = value == 0 ? 0u : 1u, .unit = "value"},
                 right());
    };
    zero("float", Vec<float, 2>{0.1F, 0.3F});
    zero("double", Vec<double, 2>{0.1, 0.3});
    zero("exact", Vec<Rational, 2>{Rational(1, 10), Rational(3, 10)});
    rows.add("float", "textbook: fused", fused_edge(0.1F, 0.3F), wrong(1, "4.5e-10"));
    rows.add("double", "textbook: fused", fused_edge(0.1, 0.3), wrong(1, "1.7e-18"));
    rows.add("float", "a grid of 1/10", edges_on_grid<float>(false), right());
    rows.add("double", "a grid of 1/10", edges_on_grid<double>(false), right());
    rows.add("float", "a grid of 1/10, fused", edges_on_grid<float>(true), wrong(8'734));
    rows.add("double", "a grid of 1/10, fused", edges_on_grid<double>(true), wrong(8'596));
}

/// C13 attacks the claim that snapping by 1/512 changes no pixel.
void c13_snapped_diagonal(StressRows& rows) {
    rows.add_pictures(c13, "top-left", top_left, 36, {{"fixed", right("28 pixels")}});
}

/// C14 attacks triangles smaller than the grid.
void c14_snapped_to_point(StressRows& rows) {
    rows.add_pictures(c14, "top-left", top_left, 1, {{"fixed", right("0 pixels")}});
}

/// C15 attacks meshes with a vertex next to the edge of a neighbor: the rule for shared edges does not hold.
void c15_t_junction(StressRows& rows) {
    add_junction(rows, m_below, wrong(1), right());
    add_junction(rows, m_above, right(), wrong(1));
}

/// C16 attacks edge values that must be exactly 0.
void c16_sample_on_edge(StressRows& rows) {
    rows.add_pictures(c16({0, 1, 2}, 0, 0), "top-left", top_left, std::nullopt);
    for (const std::string_view scalar : scalar_names()) {
        const Scene scene = readable_scene(c16({0, 1, 2}, 0, 0), with_scalar_named({}, scalar));
        rows.expect_same(scalar, "top-left, pixel (4,11)",
                         drawn_picture(scene)[scene.canvas.offset_of({4, 11})] == no_color ? 0 : 1,
                         1, "pixel");
    }
}

/// C17 attacks fills whose result depends on the order of the vertices, or on where they are.
void c17_order_and_place(StressRows& rows) {
    const std::array<std::array<Index, 2>, 3> moves{{{0, 0}, {29, 7}, {-3, -1}}};
    rows.add_for_all("top-left", {}, [&moves](std::string_view scalar) {
        Measured measured{.unit = "pixel", .note = "18 pictures"};
        const Scene still =
            readable_scene(c16({0, 1, 2}, 0, 0), with_scalar_named(top_left, "exact"));
        const auto reference = reference_picture(still);
        for (const auto& [dx, dy] : moves) {
            std::array<std::size_t, 3> order{0, 1, 2};
            do {
                const auto moved = drawn_picture(
                    readable_scene(c16(order, dx, dy), with_scalar_named(top_left, scalar)));
                measured.wrong += differing(moved, moved_picture(reference, still.canvas, dx, dy));
            } while (std::next_permutation(order.begin(), order.end()));
        }
        return measured;
    });
    rows.add("float", "2A, moved by 2^19", area_of_shifted(Index{1} << 19), right());
    rows.add("float", "2A, moved by 2^21", area_of_shifted(Index{1} << 21), wrong(1));
}

/// C18 attacks samples that are off by 1/256.
void c18_smaller_than_pixel(StressRows& rows) {
    rows.add_pictures(c18, "top-left", top_left, 1);
    rows.add_pictures(c18_moved, "top-left, moved", top_left, 0);
}

constexpr auto edge_functions_catalogue = std::to_array<StressCase>({
    {.id = "C1",
     .title = "a vertex on a pixel's center",
     .input = "hub (20.5,20.5); ring (+14,0)(+7,+12)(-7,+12)(-14,0)(-7,-12)(+7,-12) from it",
     .why = "six triangles meet in one sample, and three edges run along samples",
     .holds = "91 77 91 77 91 77 pixels, 504 in all; the hub's pixel belongs to the first "
              "triangle alone. Closed triangles draw it six times.",
     .scenes = [] { return only(hub(all_sectors)); },
     .run = c1_hub},
    {.id = "C2",
     .title = "a sliver between the samples",
     .input = "(0,1/4)(64,3/8)(64,5/16), area 2",
     .why = "64 pixels long, 1/16 high",
     .holds = "no sample lies in it: nothing is drawn",
     .scenes = [] { return only(c2); },
     .run = c2_sliver_between_samples},
    {.id = "C3",
     .title = "a sliver whose top edge is on samples",
     .input = "(0,1/2)(64,1/2)(64,129/256), area 1/8",
     .why = "64 samples lie on its top edge",
     .holds = "the top edge has its samples: 64 pixels, row 0",
     .scenes = [] { return only(c3); },
     .run = c3_sliver_on_samples},
    {.id = "C4",
     .title = "the same below its edge",
     .input = "(0,1/2)(64,1/2)(64,127/256), area 1/8",
     .why = "64 samples lie on its bottom edge",
     .holds = "the bottom edge has none: nothing is drawn",
     .scenes = [] { return only(c4); },
     .run = c4_sliver_below_samples},
    {.id = "C5",
     .title = "a sliver along the diagonal",
     .input = "(0,0)(64,64)(64,64-1/256), area 1/8",
     .why = "64 samples lie on its left edge; a grid of 1/16 has no room for it",
     .holds = "64 pixels",
     .scenes = [] { return only(c5); },
     .run = c5_diagonal_sliver},
    {.id = "C6",
     .title = "Cassini: an area of -1/2",
     .input = "(0,0)(F18,F19)(F19,F20) = (0,0)(2584,4181)(4181,6765)",
     .why = "two products of 1.7e7 that differ by 1: float has every second whole number there",
     .holds = "2A = -1. Float: 0, the triangle is gone; at F17 it still was right.",
     .scenes = [] { return only(cassini(18).json()); },
     .run = c6_cassini_float},
    {.id = "C7",
     .title = "the same for double",
     .input = "(0,0)(F40,F41)(F41,F42) = (0,0)(102334155,165580141)(165580141,267914296)",
     .why = "products of 2.7e16, where double has every second or fourth whole number",
     .holds = "2A = -1. Double: 0; one number earlier 2 for 1.",
     .scenes = [] { return only(cassini(40).json()); },
     .run = c7_cassini_double},
    {.id = "C8",
     .title = "a triangle far from the origin",
     .input = "(k,k)(k+3,k+1)(k+1,k+3), k = 2^24",
     .why = "vertices merge in float, and the edge function's constant keeps no digit",
     .holds = "2A = 8 anywhere; the constant term of AB is -33554432. Float: 16 and -67108864.",
     .scenes = [] { return only(shifted(1 << 24).json()); },
     .run = c8_far_from_origin},
    {.id = "C9",
     .title = "products that overflow",
     .input = "a triangle n pixels wide, s subpixel bits, products in int32 or int64",
     .why = "an edge value is the difference of two products of extents",
     .holds = "int32 is safe up to n = 32767, 2047, 127, 7, 0 for s = 0, 4, 8, 12, 16; int64 up "
              "to 8,388,607 for s = 8. Beyond that, `fixed` takes fractions of any size.",
     .scenes = [] { return only(wide_triangle(8'388'608)); },
     .run = c9_overflowing_products},
    {.id = "C10",
     .title = "a huge triangle",
     .input = "(-1e30,-1e30)(3e30,-1e30)(-1e30,3e30); the same with 1e200",
     .why = "products beyond the largest number: Inf - Inf is NaN, and nothing is drawn",
     .holds = "4,096 pixels, or refused with the vertex named: never silently nothing",
     .scenes =
         [] {
             return Scenes{{"1e30", huge_triangle("30")}, {"1e200", huge_triangle("200")}};
         },
     .run = c10_huge_triangle},
    {.id = "C11",
     .title = "numbers that are none",
     .input = "NaN, Infinity, 1e400 as a coordinate",
     .why = "every comparison with NaN is false: silently nothing is drawn",
     .holds = "refused with line and column, whatever the scalar; no pixel, exit status 2",
     .run = c11_no_numbers},
    {.id = "C12",
     .title = "an edge at its own vertex",
     .input = "E((0,0), b) at b, b = (0.1,0.3)",
     .why = "a fused multiply-add rounds one of two equal products only",
     .holds = "0: the two products are the same number. Fused: 4.5e-10 (float), 1.7e-18 "
              "(double); this library is compiled without.",
     .scenes = [] { return only(triangle_in("0, 0", "0.1, 0.3", "0.3, 0.1")); },
     .run = c12_own_vertex},
    {.id = "C13",
     .title = "snapping moves a diagonal",
     .input = "(0,0)(8,0)(0,8+1/1024) on 16x16",
     .why = "the diagonal passes 1/1024 beyond the samples; snapped to 1/256, through them",
     .holds = "36 pixels; `fixed`, whose grid is 1/256, has 28. Both are right: the trace names "
              "the grid.",
     .scenes = [] { return only(c13); },
     .run = c13_snapped_diagonal},
    {.id = "C14",
     .title = "snapping leaves nothing",
     .input = "(1/2,1/2)(1/2+1/1024,1/2)(1/2,1/2+1/1024)",
     .why = "smaller than the grid, and with a vertex on a sample",
     .holds = "pixel (0,0); `fixed` draws nothing: its vertices are one point",
     .scenes = [] { return only(c14); },
     .run = c14_snapped_to_point},
    {.id = "C15",
     .title = "a T-junction",
     .input = "P(0,20) Q(40,27); above: apex (32,-20); below: M, apex (32,90); M = (7,85/4) "
              "for (7,849/40), or (33,103/4) for (33,1031/40)",
     .why = "M was rounded: PM and MQ are not PQ, and no rule holds between different edges",
     .holds = "with exact arithmetic too, one pixel is in no triangle (M below PQ), or one in two "
              "(M above): the cure is another mesh",
     .scenes =
         [] {
             return Scenes{{"a gap", t_junction(m_below)}, {"an overlap", t_junction(m_above)}};
         },
     .run = c15_t_junction},
    {.id = "C16",
     .title = "a sample exactly on an edge",
     .input = "(53/8,133/4)(43/4,71/16)(55/16,5/8), pixel (4,11)",
     .why = "an edge value of 0 that is the difference of two rounded products",
     .holds = "by the top-left rule the pixel is in (by a top-right rule it would be out)",
     .scenes =
         [] {
             return only(c16({0, 1, 2}, 0, 0));
         },
     .run = c16_sample_on_edge},
    {.id = "C17",
     .title = "order and place do not matter",
     .input = "C16's triangle, its 6 vertex orders, moved by (0,0), (29,7) and (-3,-1)",
     .why = "the same triangle must have the same pixels, moved with it",
     .holds = "the same set in every order, and moved. Float loses the sixteenths where it moves "
              "beyond 2^20 = 2^24/16, off every canvas.",
     .scenes =
         [] {
             return only(c16({0, 1, 2}, 29, 7));
         },
     .run = c17_order_and_place},
    {.id = "C18",
     .title = "smaller than a pixel",
     .input = "(7.5,7.5) -+ 1/256 round a center; the same moved right by 1/256",
     .why = "2/256 wide: drawn or not by 1/256",
     .holds = "pixel (7,7); nothing",
     .scenes =
         [] {
             return Scenes{{"round the center", c18}, {"moved", c18_moved}};
         },
     .run = c18_smaller_than_pixel},
});

} // namespace

std::span<const StressCase> edge_function_cases() {
    return edge_functions_catalogue;
}

} // namespace rastertrace
