// SPDX-License-Identifier: MIT
// Z: hidden surfaces. Samples at the centers of pixels, the top-left rule, y down; z is the distance
// from the eye.

#include "stress_rows.h"

#include <rastertrace/core/raster/depth_interpolation.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <random>

namespace rastertrace {

namespace {

const MethodOverrides inverse_z{{"depth", "inverse-z"}};
const MethodOverrides linear_z{{"depth", "linear-z"}};

const Color red{255, 0, 0};

/// The picture by 1/z, which is linear on the screen, whatever the scene's own depth.
Colors by_inverse_z(const Scene& scene) {
    Scene right = scene;
    right.method.depth = Depth::inverse_z;
    return reference_picture(right);
}

/// Draws a scene by a depth that is documented to go wrong, with every scalar.
void add_against_inverse_z(StressRows& rows, std::string_view json, std::string_view label,
                           const MethodOverrides& method, const DocumentedOfScalars& documented) {
    rows.add_pictures(json, label, method, std::nullopt, documented, by_inverse_z);
}

std::uint64_t count_of(const Colors& picture, Color color) {
    return static_cast<std::uint64_t>(std::count(picture.begin(), picture.end(), color));
}

/// Triangles with a color each, drawn in this order. A corner is "x, y, z".
struct ColoredTriangle {
    std::string_view name;
    std::array<std::string, 3> corners;
    std::string_view color;
};
std::string scene_of(const std::vector<ColoredTriangle>& triangles, std::string_view depth,
                     int side = 64) {
    std::string vertices;
    std::string list;
    for (const ColoredTriangle& triangle : triangles) {
        const std::string_view separator = list.empty() ? "" : ",\n    ";
        vertices += separator;
        std::array<std::string, 3> names;
        for (std::size_t i = 0; i < 3; ++i) {
            names[i] = fmt::format("{}{}", triangle.name, i + 1);
            vertices +=
                fmt::format(R"({}"{}": [{}])", i == 0 ? "" : ", ", names[i], triangle.corners[i]);
        }
        list += fmt::format(R"({}{{"name": "{}", "vertices": ["{}"], "color": "{}"}})", separator,
                            triangle.name, joined(names, R"(", ")"), triangle.color);
    }
    return fmt::format(R"({{
  "canvas": {{"width": {0}, "height": {0}, "origin": "top-left"}},
  "vertices": {{
    {1}}},
  "triangles": [
    {2}],
  "method": {{"fill": "top-left", "depth": "{3}"}}
}})",
                       side, vertices, list, depth);
}

/// Right to so many rounding units.
DocumentedOfScalars within_units(double count) {
    return {{"float", within(count * rounding_unit<float>())},
            {"double fixed", within(count * rounding_unit<double>())}};
}

// Z1: an edge with z from 1 to r over two rows.

std::string steep_edge(std::string_view r) {
    return fmt::format(R"({{
  "canvas": {{"width": 4, "height": 4, "origin": "top-left"}},
  "vertices": {{"A": [0, 0, 1], "B": [0, 2, {}], "C": [2, 0, 1]}},
  "triangles": ["ABC"],
  "method": {{"fill": "barycentric", "depth": "inverse-z"}}
}})",
                       r);
}

/// The depth in the middle of that edge by the core's own interpolation.
Measured middle_of_edge(std::string_view scalar, const Rational& r, bool is_inverse) {
    const Scene scene = readable_scene(steep_edge(r.get_str()), with_scalar_named({}, scalar));
    return with_numbers_of(scene, [&]<typename Scalar>(const Plan& plan) {
        using D = DepthOf<Scalar>;
        const Triangle<Scalar> triangle{{place_of<Scalar>(scene, 0, plan),
                                         place_of<Scalar>(scene, 1, plan),
                                         place_of<Scalar>(scene, 2, plan)}};
        const D one = scalar_from<D>(1);
        const D far_z = nearest_scalar<D>(r);
        const D far_depth = is_inverse ? D(one / far_z) : far_z;
        TriangleDepth<D> depth(depth_positions(triangle), {one, far_depth, one}, false);
        const D found = depth.on_edge({0, 1}, one);
        const Rational true_z = 2 * r / (1 + r);
        if (is_inverse)
            return Measured{.worst = relative_distance_from(Rational(1 / true_z), found),
                            .worst_unit = "of 1/z"};
        const Rational z = exact_value(found);
        return Measured{
            .wrong = 1,
            .unit = "depth",
            .worst = nearest_double(z / true_z),
            .worst_unit = "times z",
            .note = fmt::format("{:.10g} for {:.10g}", nearest_double(z), nearest_double(true_z))};
    });
}

/// The largest error of linear z along the edge, where the screen fraction t is sqrt r/(1 + sqrt r).
Measured largest_linear_error(const Rational& r) {
    const double root = std::sqrt(nearest_double(r));
    const Rational t(root / (1 + root));
    const Triangle<Rational> triangle{{{{0, 0}, {0, 2}, {2, 0}}}};
    TriangleDepth<Rational> linear(triangle.vertices, {1, r, 1}, false);
    const Rational true_z = 1 / ((1 - t) + t / r);
    return {.wrong = 1,
            .unit = "depth",
            .worst = nearest_double(linear.on_edge({0, 1}, Rational(2 * t)) - true_z),
            .worst_unit = "too far"};
}

// Z3: from 1 to 1/r in n steps.

/// d += step, n times: how far off the last one is, over 1/r.
template <typename Real> Measured accumulated_depth(double r, int n) {
    const Real end = 1 / static_cast<Real>(r);
    const Real step = (end - 1) / static_cast<Real>(n);
    Real depth = 1;
    for (int i = 0; i < n; ++i)
        depth += step;
    return {.wrong = 1,
            .unit = "depth",
            .worst = relative_distance_from(Rational(1 / Rational(r)), depth),
            .worst_unit = "of 1/z",
            .note = depth <= 0 ? "0 or less: never drawn" : ""};
}

/// (1 - t)/z0 + t/z1 in every step: the largest relative error.
template <typename Real> Measured mixed_depth(double r, int n) {
    Measured measured{.worst_unit = "of 1/z"};
    for (int i = 0; i <= n; ++i) {
        const Real t = static_cast<Real>(i) / static_cast<Real>(n);
        const Real depth = (1 - t) + t / static_cast<Real>(r);
        const Rational exact_t(i, n);
        measured.worst = std::max(
            measured.worst,
            relative_distance_from(Rational((1 - exact_t) + exact_t / Rational(r)), depth));
    }
    return measured;
}

/// The core's own row, d1 + slope (x - x1): the largest absolute error, over the nearer depth 1.
Measured depth_row(std::string_view scalar, double r, int n) {
    const Scene scene = readable_scene(steep_edge("2"), with_scalar_named({}, scalar));
    return with_numbers_of(scene, [&]<typename Scalar>(const Plan&) {
        using D = DepthOf<Scalar>;
        const D one = scalar_from<D>(1);
        const D far_depth = one / nearest_scalar<D>(Rational(r));
        const auto row = row_between(scalar_from<D>(0), one, scalar_from<D>(n), far_depth);
        Measured measured{.worst_unit = "of the nearest 1/z"};
        double relative = 0;
        for (int i = 0; i <= n; ++i) {
            const Rational t(i, n);
            const Rational exact = (1 - t) + t / Rational(r);
            const D found = row.at(i);
            measured.worst = std::max(measured.worst, distance_from(exact, found));
            relative = std::max(relative, relative_distance_from(exact, found));
        }
        if (relative > 0)
            measured.note = fmt::format("{:.2g} of 1/z itself", relative);
        return measured;
    });
}

// Z4 and Z5: depths as codes of a buffer, a + b/z from 0 at the near plane to 1 at the far one.

struct CodedDepth {
    Rational near;
    Rational far;

    /// far (z - near) / (z (far - near))
    Rational at(const Rational& z) const { return far * (z - near) / (z * (far - near)); }
    Rational z_of(const Rational& depth) const { return far * near / (far - depth * (far - near)); }

    static mpz_class largest_code(int bits) {
        return (mpz_class(1) << static_cast<unsigned>(bits)) - 1;
    }
    static mpz_class nearest_code(const Rational& depth, int bits) {
        const Rational scaled = depth * largest_code(bits) + Rational(1, 2);
        mpz_class code;
        mpz_fdiv_q(code.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
        return code;
    }
    mpz_class code_of(const Rational& z, int bits) const { return nearest_code(at(z), bits); }

    /// How far apart in z two codes lie: 2^-bits over the slope of the depth.
    double width_at(const Rational& z, int bits) const {
        return nearest_double(z * z * (far - near) /
                              (far * near * Rational(mpz_class(1) << static_cast<unsigned>(bits))));
    }
};

/// Z4: two planes, the farther one drawn first: at the middle of a code near z = 500, and a quarter
/// of a code behind it.
struct TwoPlanes {
    static constexpr int bits = 24;
    CodedDepth coded{Rational(1, 10), 1000};

    Rational near_z() const {
        return coded.z_of(Rational(coded.code_of(500, bits)) / coded.largest_code(bits));
    }
    Rational far_z() const { return near_z() + Rational(coded.width_at(500, bits)) / 4; }

    std::string json() const {
        const auto triangle = [](std::string_view name, const Rational& z, std::string_view color) {
            const auto corner = [&z](std::string_view at) {
                return fmt::format(R"({}, "{}")", at, z.get_str());
            };
            return ColoredTriangle{name, {corner("0, 0"), corner("32, 0"), corner("0, 32")}, color};
        };
        return scene_of({triangle("B", far_z(), "blue"), triangle("A", near_z(), "red")},
                        "inverse-z", 32);
    }

    /// A buffer of codes: pixels where the farther plane, drawn first, stays.
    Measured by_codes() const {
        const Scene scene = readable_scene(json());
        const bool is_equal = coded.code_of(near_z(), bits) == coded.code_of(far_z(), bits);
        const auto covered = covered_by(exact_corners(scene, 0), scene.method, scene.canvas);
        return {.wrong = is_equal ? static_cast<std::uint64_t>(
                                        std::count(covered.begin(), covered.end(), true))
                                  : 0,
                .unit = "pixel",
                .note = fmt::format("code {} for both", coded.code_of(near_z(), bits).get_str())};
    }
};

/// Z5: how many steps from float to float lie between two numbers of one sign.
std::uint64_t float_steps_between(const Rational& a, const Rational& b) {
    const auto place = [](const Rational& x) {
        return static_cast<std::int64_t>(std::bit_cast<std::int32_t>(nearest_float(x)));
    };
    return static_cast<std::uint64_t>(std::llabs(place(a) - place(b)));
}

// Z2, Z9, Z10, Z11: triangles that hide each other.

std::string z2() {
    return scene_of({{"T", {"0, 0, 1", "64, 0, 9", "0, 64, 1"}, "red"},
                     {"U", {"0, 0, 4", "64, 0, 4", "0, 64, 4"}, "blue"}},
                    "inverse-z");
}

std::string z14() {
    return scene_of({{"T", {"0.9, 0, 1", "63.9, 10.5, 9", "8.2, 63.5, 3"}, "red"},
                     {"U", {"0.9, 0, 4", "63.9, 10.5, 4", "8.2, 63.5, 4"}, "blue"}},
                    "inverse-z");
}

std::string z9(bool first_is_first) {
    const ColoredTriangle t{"T", {"0.5, 0.5, 1", "64.5, 0.5, 3", "0.5, 64.5, 1"}, "red"};
    const ColoredTriangle u{"U", {"0.5, 0.5, 3", "64.5, 0.5, 1", "0.5, 64.5, 3"}, "blue"};
    return first_is_first ? scene_of({t, u}, "inverse-z", 65) : scene_of({u, t}, "inverse-z", 65);
}

std::string z10(std::array<std::size_t, 3> order, std::string_view depth = "inverse-z") {
    const std::array<ColoredTriangle, 3> triangles{
        {{"A", {"4, 28, 2", "60, 24, 6", "60, 34, 6"}, "red"},
         {"B", {"28, 60, 2", "26, 4, 6", "36, 4, 6"}, "green"},
         {"C", {"58, 6, 2", "10, 60, 6", "4, 52, 6"}, "blue"}}};
    return scene_of({triangles[order[0]], triangles[order[1]], triangles[order[2]]}, depth);
}

std::string z11(int z) {
    return scene_of({{"floor", {"0, 63, 2", "63, 63, 2", "32, 10, 100"}, "gray"},
                     {"box",
                      {fmt::format("28, 30, {}", z), fmt::format("36, 30, {}", z),
                       fmt::format("32, 38, {}", z)},
                      "red"}},
                    "inverse-z");
}

// Z6: pairs of triangles, each with view depths from 1 to 2^20.

/// In the same corners, U lies before or behind T by one part in 2^k, or as far away, each corner by
/// its own sign. The same on every machine: the engine's own numbers, no distribution.
std::vector<StressScene> random_pairs() {
    std::mt19937_64 random(6);
    const auto below = [&random](std::uint64_t count) { return random() % count; };
    std::vector<StressScene> scenes;
    for (int i = 0; i < 16; ++i) {
        // One corner at depth 1, one at 2^20, one between.
        const std::array<std::uint64_t, 3> depths{1, std::uint64_t{1} << 20,
                                                  std::uint64_t{1} << below(21)};
        const std::size_t first = below(3);
        const std::uint64_t parts = std::uint64_t{1} << (1 + below(24));
        ColoredTriangle t{"T", {}, "red"};
        ColoredTriangle u{"U", {}, "blue"};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint64_t x = below(1025);
            const std::uint64_t y = below(1025);
            const std::uint64_t z = depths[(first + k) % 3];
            t.corners[k] = fmt::format(R"("{}/16", "{}/16", {})", x, y, z);
            u.corners[k] = fmt::format(R"("{}/16", "{}/16", "{}/{}")", x, y,
                                       z * (parts - 1 + below(3)), parts);
        }
        scenes.push_back({fmt::format("pair {}", i + 1), scene_of({t, u}, "inverse-z")});
    }
    return scenes;
}

/// The pictures of all pairs by exact 1/z.
struct PairReferences {
    std::vector<StressScene> pairs = random_pairs();
    std::vector<Colors> typed;
    std::vector<Colors> on_grid;
    std::uint64_t drawn = 0;

    PairReferences() {
        for (const StressScene& pair : pairs) {
            const Scene scene = readable_scene(pair.json, {{"scalar", "exact"}});
            typed.push_back(reference_picture(scene));
            on_grid.push_back(reference_picture(snapped_to_grid(scene)));
            drawn += drawn_in(typed.back());
        }
    }

    /// The pixels of all pairs that a depth gets wrong.
    Measured wrong_by(const MethodOverrides& method) const {
        Measured measured{.unit = "pixel", .note = fmt::format("of {}", drawn)};
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            const Scene scene = readable_scene(pairs[i].json, method);
            const bool is_fixed = scene.method.scalar == ScalarKind::fixed;
            measured.wrong += differing(drawn_picture(scene), is_fixed ? on_grid[i] : typed[i]);
        }
        return measured;
    }

    /// The same by a buffer of 24-bit codes of 1 - near/z, near 1/32, far at infinity.
    Measured wrong_by_codes() const {
        Measured measured{.unit = "pixel", .note = fmt::format("of {}", drawn)};
        const auto code_of = [](const Rational& inverse) {
            return CodedDepth::nearest_code(1 - inverse / 32, 24);
        };
        for (const StressScene& pair : pairs) {
            const Scene scene = readable_scene(pair.json, {{"scalar", "exact"}});
            const auto corners = exact_corners(scene, 0);
            if (exact_area2(corners) == 0)
                continue;
            std::array<ExactPlane, 2> planes;
            for (std::size_t i = 0; i < 2; ++i) {
                std::array<Rational, 3> inverse;
                for (std::size_t k = 0; k < 3; ++k)
                    inverse[k] = 1 / scene.vertices[scene.primitives[i].vertices[k]].z.exact();
                planes[i] = plane_through(corners, inverse);
            }
            const auto covered = covered_by(corners, scene.method, scene.canvas);
            const auto width = static_cast<std::size_t>(scene.canvas.width);
            for (std::size_t place = 0; place < covered.size(); ++place) {
                if (!covered[place])
                    continue;
                const ExactPoint sample{Rational(static_cast<long>(2 * (place % width) + 1), 2),
                                        Rational(static_cast<long>(2 * (place / width) + 1), 2)};
                const Rational t = planes[0].at(sample);
                const Rational u = planes[1].at(sample);
                // U is drawn second: it wins if it is nearer, by its code.
                measured.wrong += (u > t) == (code_of(u) < code_of(t)) ? 0 : 1;
            }
        }
        return measured;
    }
};

// Z7: layers on layers.

std::string z7() {
    constexpr int layers = 4096;
    std::string list;
    for (int i = 0; i < layers; ++i)
        list += fmt::format(R"({}{{"vertices": "ABC", "name": "layer {}", "color": "{}"}})",
                            i == 0 ? "" : ",\n    ", i + 1, i == 0 ? "red" : "blue");
    return fmt::format(R"({{
  "canvas": {{"width": 16, "height": 16, "origin": "top-left"}},
  "vertices": {{"A": [0, 0, 5], "B": [8, 0, 5], "C": [0, 8, 5]}},
  "triangles": [
    {}],
  "method": {{"fill": "top-left", "depth": "inverse-z"}}
}})",
                       list);
}

/// Tests and passes in the trace of a scene.
struct DepthTests {
    std::uint64_t tests = 0;
    std::uint64_t passes = 0;
};
DepthTests depth_tests_of(std::string_view json, const MethodOverrides& method) {
    DepthTests count;
    const auto trace = trace_in(json, method, {StepKind::depth});
    if (!trace)
        return count;
    for (const std::size_t n : trace.value().steps_of({StepKind::depth})) {
        ++count.tests;
        count.passes += trace.value().step(n).as<DepthStep>().pass.is_true() ? 1 : 0;
    }
    return count;
}

// Z8: z = 1000/(x + 2y + 7), triangulated twice.

std::string z8() {
    const auto corner = [](int x, int y) {
        return fmt::format(R"({}, {}, "1000/{}")", x, y, x + 2 * y + 7);
    };
    return scene_of({{"A", {corner(0, 0), corner(60, 3), corner(5, 61)}, "red"},
                     {"B", {corner(2, 60), corner(1, 1), corner(63, 5)}, "blue"}},
                    "inverse-z");
}

constexpr std::string_view z12 = R"({
  "canvas": {"width": 16, "height": 16},
  "vertices": {"A": [-8, -8, -9], "B": [8, -8, -9], "C": [0, 8, -9]},
  "triangles": ["ABC"],
  "projection": {"type": "frustum", "left": -1, "right": 1, "bottom": -1, "top": 1,
                 "near": 1, "far": 9},
  "method": {"fill": "top-left", "depth": "ndc-z"}
})";

std::string z13(int z) {
    return scene_of({{"T", {"0, 0, 1", fmt::format("32, 0, {}", z), "0, 32, 1"}, "red"}},
                    "inverse-z");
}

/// Z1 attacks linear z, by how far off it is.
void z1_middle_of_edge(StressRows& rows) {
    struct Edge {
        const char* r;
        std::string_view ratio;
        std::string_view largest;
    };
    for (const auto& [r, ratio, largest] :
         {Edge{"10", "3.025", "4.675"}, Edge{"1000", "250.50025", "937.75"},
          Edge{"1000000", "250000.5", "998001"}, Edge{"1000000000", "2.5e8", "999936755"}}) {
        rows.add_for_all(fmt::format("linear-z, r = {}", r), {{"all", wrong(1, ratio)}},
                         [r = Rational(r)](std::string_view scalar) {
                             return middle_of_edge(scalar, r, false);
                         });
        // 1/r is rounded, then the difference, the product, the quotient and the sum;
        // the middle is half as large as what is added.
        rows.add_for_all(
            fmt::format("inverse-z, r = {}", r), within_units(6),
            [r = Rational(r)](std::string_view scalar) { return middle_of_edge(scalar, r, true); });
        rows.add("exact", fmt::format("linear-z, largest error, r = {}", r),
                 largest_linear_error(Rational(r)), wrong(1, largest));
    }
}

/// Z2 attacks linear z, by the pixels that it gives to the wrong triangle.
void z2_wrong_winner(StressRows& rows) {
    rows.add_pictures(z2(), "inverse-z", inverse_z, 2016);
    rows.expect_same("reference", "inverse-z, T's pixels",
                     count_of(reference_picture(readable_scene(z2())), red), 1971, "pixel");
    add_against_inverse_z(rows, z2(), "linear-z", linear_z, {{"all", wrong(735)}});
}

/// Z3 attacks sums of 1/z: their absolute error stays while the value falls.
void z3_falling_inverse(StressRows& rows) {
    const auto accumulated = [&rows](std::string_view scalar, double r, int n,
                                     const Measured& measured, std::string_view worst) {
        rows.add(scalar, fmt::format("textbook: d += step, r = {:g}, n = {}", r, n), measured,
                 wrong(1, worst));
    };
    accumulated("float", 1e4, 64, accumulated_depth<float>(1e4, 64), "0.0058");
    accumulated("float", 1e6, 64, accumulated_depth<float>(1e6, 64), "0.28");
    accumulated("float", 1e6, 1024, accumulated_depth<float>(1e6, 1024), "0.955");
    accumulated("float", 1e8, 4096, accumulated_depth<float>(1e8, 4096), "1");
    accumulated("double", 1e6, 1024, accumulated_depth<double>(1e6, 1024), "2.4e-9");
    accumulated("double", 1e8, 4096, accumulated_depth<double>(1e8, 4096), "7.8e-6");
    accumulated("double", 1e12, 1024, accumulated_depth<double>(1e12, 1024), "0.016");
    // Two roundings of the value itself; or, in a row, of the difference, the slope, the
    // product and the sum, none of which is larger than the nearest depth.
    for (const double r : {1e4, 1e6, 1e8}) {
        rows.add("float", fmt::format("textbook: (1-t)/z0 + t/z1, r = {:g}", r),
                 mixed_depth<float>(r, 1024), within(4 * rounding_unit<float>()));
        rows.add("double", fmt::format("textbook: (1-t)/z0 + t/z1, r = {:g}", r),
                 mixed_depth<double>(r, 1024), within(4 * rounding_unit<double>()));
        rows.add_for_all(fmt::format("a row of depths, r = {:g}", r), within_units(4),
                         [r](std::string_view scalar) { return depth_row(scalar, r, 1024); });
    }
}

/// Z4 attacks buffers of a few bits, in which different depths have one code.
void z4_codes(StressRows& rows) {
    struct Width {
        Rational near;
        Rational far;
        Rational z;
        int bits;
        std::string_view width;
    };
    const std::array<Width, 5> widths{{{Rational(1, 10), 1000, 500, 24, "0.14900"},
                                       {Rational(1, 10), 1000, 500, 16, "38.14"},
                                       {1, 1000, 500, 24, "0.014886"},
                                       {1, 1000, 500, 16, "3.811"},
                                       {Rational(1, 1000), 10000, 5000, 24, "1490"}}};
    for (const auto& [near, far, z, bits, width] : widths)
        rows.add(
            fmt::format("{} bits", bits),
            fmt::format("one code, n={}, f={}, z={}", near.get_str(), far.get_str(), z.get_str()),
            {.wrong = 1,
             .unit = "depth",
             .worst = CodedDepth{near, far}.width_at(z, bits),
             .worst_unit = "in z"},
            wrong(1, width));
    rows.add("24 bits", "textbook: a buffer of codes", TwoPlanes().by_codes(), wrong(496));
    rows.add_pictures(TwoPlanes().json(), "inverse-z", inverse_z, 496);
}

/// Z5 attacks a float buffer with 1 at the far plane: its numbers lie at the other end.
void z5_codes_of_float(StressRows& rows) {
    const CodedDepth coded{Rational(1, 10), 10000};
    const Rational from = 1000;
    const Rational to = 1001;
    const auto count = [&rows](std::string_view scalar, std::string_view label, std::uint64_t found,
                               std::uint64_t expected) {
        rows.expect_same(scalar, label, found, expected, "step");
    };
    count("float", "standard, 0 near to 1 far", float_steps_between(coded.at(from), coded.at(to)),
          2);
    count("float", "reversed, 1 near to 0 far",
          float_steps_between(1 - coded.at(from), 1 - coded.at(to)), 13'731);
    count("float", "n/z", float_steps_between(coded.near / from, coded.near / to), 13'730);
    count("24 bits", "standard, 0 near to 1 far",
          mpz_class(coded.code_of(to, 24) - coded.code_of(from, 24)).get_ui(), 2);
}

/// Z6 attacks every depth at once: each triangle reaches from 1 to a million.
void z6_deep_pairs(StressRows& rows) {
    const PairReferences references;
    rows.add_for_all("inverse-z", {{"float", wrong(682)}}, [&](std::string_view scalar) {
        return references.wrong_by(with_scalar_named(inverse_z, scalar));
    });
    rows.add_for_all("linear-z", {{"float", wrong(2930)}, {"all", wrong(2758)}},
                     [&](std::string_view scalar) {
                         return references.wrong_by(with_scalar_named(linear_z, scalar));
                     });
    rows.add("24 bits", "textbook: codes of 1 - n/z", references.wrong_by_codes(), wrong(1562));
}

/// Z7 attacks depth tests that let an equal depth pass.
void z7_layers(StressRows& rows) {
    const std::string json = z7();
    for (const std::string_view scalar : scalar_names()) {
        const MethodOverrides method = with_scalar_named(inverse_z, scalar);
        rows.expect_same(scalar, "inverse-z, the first layer's pixels",
                         count_of(drawn_picture(readable_scene(json, method)), red), 28, "pixel");
        if (rows.is_quick() && scalar != scalar_names().front())
            continue;
        const DepthTests count = depth_tests_of(json, method);
        rows.expect_same(scalar, "inverse-z, tests", count.tests, 114'688, "test");
        rows.expect_same(scalar, "inverse-z, tests that pass", count.passes, 28, "test");
    }
}

/// Z8 attacks ties of depths that are rounded differently.
void z8_triangulated_twice(StressRows& rows) {
    const Scene scene = readable_scene(z8());
    const auto a = covered_by(exact_corners(scene, 0), scene.method, scene.canvas);
    const auto b = covered_by(exact_corners(scene, 1), scene.method, scene.canvas);
    rows.expect_same("reference", "pixels in both", common_pixels(a, b), 1695, "pixel");
    rows.add_pictures(z8(), "inverse-z", inverse_z, std::nullopt,
                      {{"float", wrong(745)}, {"double fixed", wrong(1295)}});
}

/// Z9 attacks ties on the line in which two planes cross.
void z9_crossing_on_samples(StressRows& rows) {
    for (const bool first : {true, false}) {
        const std::string_view order = first ? "T first" : "T second";
        rows.add_pictures(z9(first), fmt::format("inverse-z, {}", order), inverse_z, 2080,
                          first ? DocumentedOfScalars{{"double fixed", wrong(32)}}
                                : DocumentedOfScalars{{"float", wrong(32)}});
        rows.expect_same("reference", fmt::format("inverse-z, {}, T's pixels", order),
                         count_of(reference_picture(readable_scene(z9(first))), red),
                         first ? 1584 : 1552, "pixel");
        rows.add_pictures(z9(first), fmt::format("linear-z, {}", order), linear_z, 2080);
    }
}

/// Z10 attacks the painter: there is no right order.
void z10_cycle(StressRows& rows) {
    // ABC, ACB, BAC, BCA, CAB, CBA
    constexpr std::array<std::uint64_t, 6> by_order{60, 27, 38, 62, 56, 29};
    const auto* wrong_pixels = by_order.data();
    std::array<std::size_t, 3> order{0, 1, 2};
    do {
        const auto label = fmt::format("{}{}{}", "ABC"[order[0]], "ABC"[order[1]], "ABC"[order[2]]);
        rows.add_pictures(z10(order), "inverse-z, " + label, inverse_z, 817);
        add_against_inverse_z(rows, z10(order), "no depth, " + label, {{"depth", "none"}},
                              {{"all", wrong(*wrong_pixels++)}});
    } while (std::next_permutation(order.begin(), order.end()));
    // All three have the same keys: the painter leaves them in their order.
    for (const std::string key : {"nearest", "farthest", "mean"})
        add_against_inverse_z(rows, z10({0, 1, 2}), "painter by " + key,
                              {{"depth", "painter"}, {"painter_key", key}},
                              {{"all", wrong(by_order[0])}});
}

/// Z11 attacks each of the painter's keys.
void z11_painter_key(StressRows& rows) {
    for (const int z : {3, 30}) {
        rows.add_pictures(z11(z), fmt::format("inverse-z, z = {}", z), inverse_z, std::nullopt);
        rows.expect_same("reference", fmt::format("the box's pixels, z = {}", z),
                         count_of(by_inverse_z(readable_scene(z11(z))), red), z == 3 ? 32 : 0,
                         "pixel");
        for (const std::string key : {"nearest", "farthest", "mean"}) {
            const bool is_wrong = (z == 3) == (key == "nearest");
            add_against_inverse_z(rows, z11(z), fmt::format("painter by {}, z = {}", key, z),
                                  {{"depth", "painter"}, {"painter_key", key}},
                                  {{"all", is_wrong ? wrong(32) : right()}});
        }
    }
}

/// Z12 attacks the first test of a pixel, against the cleared buffer.
void z12_far_plane(StressRows& rows) {
    for (const std::string_view scalar : scalar_names()) {
        const MethodOverrides method = with_scalar_named({}, scalar);
        const DepthTests count = depth_tests_of(z12, method);
        rows.add(scalar, "ndc-z, tests that pass",
                 {.wrong = count.passes, .unit = "test", .note = counted(count.tests, "test")},
                 right());
        rows.expect_same(scalar, "ndc-z", drawn_in(drawn_picture(readable_scene(z12, method))), 0,
                         "pixel");
        rows.expect_same(scalar, "ndc-z, samples that were tested", count.tests > 0 ? 1 : 0, 1,
                         "scene");
    }
}

/// Z13 attacks 1/z where z is 0 or changes its sign.
void z13_no_inverse(StressRows& rows) {
    rows.add_refusals(z13(0), "inverse-z, z = 0",
                      "expected a distance above 0 for 1/distance, found vertex T2 at "
                      "distance 0");
    rows.add_refusals(z13(-3), "inverse-z, z = -3",
                      "expected a distance above 0 for 1/distance, found vertex T2 at "
                      "distance -3");
}

/// Z14 attacks depths that are taken where a row's ends are rounded to.
void z14_rounded_ends(StressRows& rows) {
    const auto at_pixels = [](const Scene& scene) {
        Scene right = scene;
        right.method.scalar = ScalarKind::exact;
        right.method.depth_at = DepthAt::pixel;
        return drawn_picture(right);
    };
    for (const std::string_view fill : {"scanline", "two-halves"})
        rows.add_pictures(z14(), fmt::format("{}, rounded ends", fill),
                          {{"fill", std::string(fill)}, {"depth_at", "rounded-ends"}}, {},
                          {{"float double adaptive exact", wrong(17)}, {"fixed", wrong(16)}},
                          at_pixels);
}

constexpr auto depth_catalogue = std::to_array<StressCase>({
    {.id = "Z1",
     .title = "depths from 1 to r along one edge",
     .input = "z = 1..r, its middle on the screen, r = 10, 1e3, 1e6, 1e9",
     .why = "1/z is linear on the screen, z is not; stiff from r = 1e6 on",
     .holds = "z = 2r/(1+r) in the middle. Linear z has (1+r)/2, (1+r)^2/(4r) times as far; its "
              "largest error, nearer to the far end, is (sqrt r - 1)^2.",
     .scenes = [] { return only(steep_edge("1000000")); },
     .run = z1_middle_of_edge},
    {.id = "Z2",
     .title = "the wrong winner",
     .input = "T (0,0,1)(64,0,9)(0,64,1); U the same with z = 4",
     .why = "linear z puts T's far end too far along the whole row",
     .holds = "2,016 pixels, 1,971 of them T's, up to x = 54 in row 0. Linear z gives T 1,236: "
              "735 wrong.",
     .scenes = [] { return only(z2()); },
     .run = z2_wrong_winner},
    {.id = "Z3",
     .title = "1/z falling from 1 to 1/r",
     .input = "n steps from 1 to 1/r",
     .why = "sums keep an absolute error while the value falls to 1/r: relative, n r 2^-p",
     .holds = "direct, (1-t)/z0 + t/z1, keeps every digit at any r. Accumulated, float is 28 % "
              "off at r = 1e6, and never draws at 1e8. Ours, d + slope x, is off by some 2^-p of "
              "the nearest depth.",
     .scenes = [] { return only(steep_edge("1000000")); },
     .run = z3_falling_inverse},
    {.id = "Z4",
     .title = "two planes within one code",
     .input = "planes at z and z + dz; depth a + b/z from near to far, in 24 or 16 bits",
     .why = "one code of the buffer spans z^2 (f - n)/(f n 2^bits)",
     .holds = "near 0.1, far 1000, z = 500: 0.149 (24 bit), 38 (16 bit). Planes within one code "
              "are equal: the first one drawn stays, though it is behind. Ours keeps 1/z in the "
              "scalar.",
     .scenes = [] { return only(TwoPlanes().json()); },
     .run = z4_codes},
    {.id = "Z5",
     .title = "where a float buffer has its codes",
     .input = "z = 1000..1001, near 0.1, far 10000",
     .why = "float has most of its numbers near 0, and standard depth puts the distance near 1",
     .holds = "steps from depth to depth: standard 2, reversed 13,731, n/z 13,730, 24-bit "
              "fixed 2. Our "
              "inverse-z is 1/z, larger is nearer, as good as reversed.",
     .run = z5_codes_of_float},
    {.id = "Z6",
     .title = "pairs of triangles a million deep",
     .input = "16 random pairs, z from 1 to 2^20 inside each triangle, the second nearer or "
              "farther by one part in 2..2^24, corner by corner",
     .why = "r = 1,048,576: stiff in every triangle",
     .holds = "the winner is that of exact 1/z, in double too. Linear z is wrong in two of five "
              "pixels, a buffer of 24-bit codes, which tie far away, in one of four, float in one "
              "of ten.",
     .scenes = [] { return random_pairs(); },
     .run = z6_deep_pairs},
    {.id = "Z7",
     .title = "4,096 layers at one depth",
     .input = "(0,0)(8,0)(0,8), z = 5, drawn 4,096 times",
     .why = "every test but the first is a tie",
     .holds = "28 pixels, 114,688 tests: 28 pass, 114,660 fail, the first layer stays. (With <= "
              "all would pass; ours is strict.)",
     .scenes = [] { return only(z7()); },
     .run = z7_layers},
    {.id = "Z8",
     .title = "one plane, triangulated twice",
     .input = "z = 1000/(x+2y+7) at A (0,0)(60,3)(5,61) and B (2,60)(1,1)(63,5)",
     .why = "equal depths, each rounded on its own: z-fighting",
     .holds = "1,695 pixels in both; B, drawn last, wins none. Rounded, B wins where its noise is "
              "the larger: 745 in float, 1,295 in double. More digits do not cure a tie.",
     .scenes = [] { return only(z8()); },
     .run = z8_triangulated_twice},
    {.id = "Z9",
     .title = "planes that cross on samples",
     .input = "T (.5,.5,1)(64.5,.5,3)(.5,64.5,1); U with z = 3,1,3; 65x65",
     .why = "32 samples at which both are equally near",
     .holds = "2,080 pixels; T gets 1,584 drawn first, 1,552 drawn second: the first one keeps "
              "the ties. 1/3 is no sum of powers of two: rounded 1/z splits them.",
     .scenes =
         [] {
             return Scenes{{"T first", z9(true)}, {"T second", z9(false)}};
         },
     .run = z9_crossing_on_samples},
    {.id = "Z10",
     .title = "a cycle",
     .input = "A (4,28,2)(60,24,6)(60,34,6); B (28,60,2)(26,4,6)(36,4,6); C "
              "(58,6,2)(10,60,6)(4,52,6)",
     .why = "each lies before one of the others and behind the other: no order is right",
     .holds = "817 pixels, the same in any order with a depth buffer; the painter is wrong in "
              "every order",
     .scenes =
         [] {
             return only(z10({0, 1, 2}));
         },
     .run = z10_cycle},
    {.id = "Z11",
     .title = "which depth the painter sorts by",
     .input = "floor (0,63,2)(63,63,2)(32,10,100); box (28,30,z)(36,30,z)(32,38,z), z = 3 or 30",
     .why = "one number stands for a triangle that reaches from 2 to 100",
     .holds = "z = 3: the box wins its 32 pixels; z = 30: the floor does. The nearest vertex is "
              "the wrong key for the one, mean and farthest for the other.",
     .scenes =
         [] {
             return Scenes{{"z = 3", z11(3)}, {"z = 30", z11(30)}};
         },
     .run = z11_painter_key},
    {.id = "Z12",
     .title = "as far as the cleared buffer",
     .input = "a triangle on the far plane, ndc-z: its depth is 1, and so is the buffer's",
     .why = "a tie with nothing",
     .holds = "not drawn: the test is strict, and each test says what was stored",
     .scenes = [] { return only(z12); },
     .run = z12_far_plane},
    {.id = "Z13",
     .title = "z = 0, or of both signs",
     .input = "z = 1, 0, 1; z = 1, -3, 1; without clipping",
     .why = "1/0, or 1/z through infinity: the largest of all depths wins every test",
     .holds = "refused with the vertex named, never drawn",
     .run = z13_no_inverse},
    {.id = "Z14",
     .title = "depths at rounded ends",
     .input = "T (.9,0,1)(63.9,10.5,9)(8.2,63.5,3); U the same with z = 4; rows from edge to edge",
     .why = "CGFS gives the depths of a row's ends to the pixels that they are rounded to: each "
            "pixel has the depth of a place up to a pixel away",
     .holds =
         "2,020 pixels, 17 of them wrong, where T and U cross; a row of one pixel has its left "
         "end's depth",
     .scenes = [] { return only(z14()); },
     .run = z14_rounded_ends},
});

} // namespace

std::span<const StressCase> depth_cases() {
    return depth_catalogue;
}

} // namespace rastertrace
