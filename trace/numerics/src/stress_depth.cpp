// SPDX-License-Identifier: MIT
// Z: hidden surfaces. Samples at the centers of pixels, the top-left rule, y down; z is the distance
// from the eye.

#include "stress_rows.h"

#include <rastertrace/core/raster/depth_interpolation.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace rastertrace {

namespace {

/// The red pixels of a scene; for "reference", of its exact picture.
Measured red_pixels(const TableRow& row, std::string_view scalar) {
    const Scene scene = row.scene(scalar);
    const Colors picture = scalar == "reference" ? reference_picture(scene) : drawn_picture(scene);
    return counted_as(row, static_cast<std::uint64_t>(
                               std::count(picture.begin(), picture.end(), Color{255, 0, 0})));
}

Measured pixels_drawn(const TableRow& row, std::string_view scalar) {
    return counted_as(row, drawn_in(drawn_picture(row.scene(scalar))));
}

// Z1: an edge AB with z from 1 to r over two rows.

/// The depth in the middle of that edge by the core's own interpolation of z, or of 1/z.
Measured middle_of_edge(const TableRow& row, std::string_view scalar) {
    const Scene scene = row.scene(scalar);
    const Rational r = scene.vertices[1].z.exact();
    const bool is_inverse = row.text("depth") == "inverse-z";
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
Measured largest_linear_error(const TableRow& row, std::string_view) {
    const Rational r = row.scene({}).vertices[1].z.exact();
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

// Z3: from 1 to 1/"r" in "n" steps.

/// d += step, n times: how far off the last one is, over 1/r.
Measured accumulated_depth(const TableRow& row, std::string_view scalar) {
    const auto r = row.number<double>("r");
    const int n = row.number<int>("n");
    return with_real(scalar, [r, n]<typename Real>() -> Measured {
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
    });
}

/// (1 - t)/z0 + t/z1 in every step, exactly.
Rational exact_mix(int i, int n, double r) {
    const Rational t(i, n);
    return (1 - t) + t / Rational(r);
}

/// The largest relative error of the same.
Measured mixed_depth(const TableRow& row, std::string_view scalar) {
    const auto r = row.number<double>("r");
    const int n = row.number<int>("n");
    return with_real(scalar, [r, n]<typename Real>() {
        Measured measured{.worst_unit = "of 1/z"};
        for (int i = 0; i <= n; ++i) {
            const Real t = static_cast<Real>(i) / static_cast<Real>(n);
            const Real depth = (1 - t) + t / static_cast<Real>(r);
            measured.worst =
                std::max(measured.worst, relative_distance_from(exact_mix(i, n, r), depth));
        }
        return measured;
    });
}

/// The core's own row, d1 + slope (x - x1): the largest absolute error, over the nearer depth 1.
Measured row_of_depths(const TableRow& row, std::string_view scalar) {
    const auto r = row.number<double>("r");
    const int n = row.number<int>("n");
    return with_numbers_of(row.scene(scalar), [r, n]<typename Scalar>(const Plan&) {
        using D = DepthOf<Scalar>;
        const D one = scalar_from<D>(1);
        const D far_depth = one / nearest_scalar<D>(Rational(r));
        const auto depths = row_between(scalar_from<D>(0), one, scalar_from<D>(n), far_depth);
        Measured measured{.worst_unit = "of the nearest 1/z"};
        double relative = 0;
        for (int i = 0; i <= n; ++i) {
            const Rational exact = exact_mix(i, n, r);
            const D found = depths.at(i);
            measured.worst = std::max(measured.worst, distance_from(exact, found));
            relative = std::max(relative, relative_distance_from(exact, found));
        }
        if (relative > 0)
            measured.note = fmt::format("{:.2g} of 1/z itself", relative);
        return measured;
    });
}

// Z4 and Z5: depths as codes of a buffer, a + b/z from 0 at the plane "near" to 1 at "far".

struct CodedDepth {
    Rational near;
    Rational far;

    /// far (z - near) / (z (far - near))
    Rational at(const Rational& z) const { return far * (z - near) / (z * (far - near)); }
};

CodedDepth coded_depth(const TableRow& row) {
    return {Rational(row.text("near")), Rational(row.text("far"))};
}

/// The nearest of the codes 0 to 2^bits - 1.
mpz_class code_of(const Rational& depth, unsigned bits) {
    const Rational scaled = depth * Rational((mpz_class(1) << bits) - 1) + Rational(1, 2);
    mpz_class code;
    mpz_fdiv_q(code.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
    return code;
}

/// How far apart in z two codes lie: 2^-bits over the slope of the depth.
Measured code_width(const TableRow& row, std::string_view) {
    const auto [near, far] = coded_depth(row);
    const Rational z(row.text("z"));
    const Rational codes(mpz_class(1) << row.number<unsigned>("bits"));
    return {.wrong = 1,
            .unit = "depth",
            .worst = nearest_double(z * z * (far - near) / (far * near * codes)),
            .worst_unit = "in z"};
}

/// A buffer of codes: pixels where the farther one of two planes, drawn first, stays.
Measured planes_by_codes(const TableRow& row, std::string_view) {
    const Scene scene = row.scene({});
    const CodedDepth coded = coded_depth(row);
    const auto code = [&](std::size_t vertex) {
        return code_of(coded.at(scene.vertices[vertex].z.exact()), row.number<unsigned>("bits"));
    };
    const auto covered = covered_by(exact_corners(scene, 0), scene.method, scene.canvas);
    return {.wrong = code(0) == code(3) ? count_in(covered) : 0,
            .unit = "pixel",
            .note = fmt::format("code {} for both", code(3).get_str())};
}

/// Z5: how many steps from float to float lie between two numbers of one sign.
std::uint64_t float_steps_between(const Rational& a, const Rational& b) {
    const auto place = [](const Rational& x) {
        return static_cast<std::int64_t>(std::bit_cast<std::int32_t>(nearest_float(x)));
    };
    return static_cast<std::uint64_t>(std::llabs(place(a) - place(b)));
}

/// Z5: steps between the depths of z = 1000 and 1001. "depth" is standard, reversed or n/z in float, or in codes.
Measured steps_between_depths(const TableRow& row, std::string_view) {
    const CodedDepth coded = coded_depth(row);
    const std::string depth = row.text("depth");
    if (depth == "codes")
        return counted_as(
            row, mpz_class(code_of(coded.at(1001), 24) - code_of(coded.at(1000), 24)).get_ui());
    const auto at = [&](const Rational& z) {
        if (depth == "n/z")
            return Rational(coded.near / z);
        return depth == "standard" ? coded.at(z) : Rational(1 - coded.at(z));
    };
    return counted_as(row, float_steps_between(at(1000), at(1001)));
}

// Z6: pairs of triangles in the same corners, each with view depths from 1 to 2^20.

/// The pairs, and their pictures by exact 1/z.
struct DeepPairs {
    std::vector<std::string> scenes;
    std::vector<Colors> typed;
    std::vector<Colors> on_grid;
    std::uint64_t drawn = 0;

    DeepPairs() {
        for (const StressScene& pair : find_stress_case("Z6")->scenes()) {
            const Scene scene = readable_scene(pair.json, {{"scalar", "exact"}});
            scenes.push_back(pair.json);
            typed.push_back(reference_picture(scene));
            on_grid.push_back(reference_picture(snapped_to_grid(scene)));
            drawn += drawn_in(typed.back());
        }
    }
};
const DeepPairs& deep_pairs() {
    static const DeepPairs pairs;
    return pairs;
}

/// The pixels of all pairs that a depth gets wrong.
Measured pairs_by_depth(const TableRow& row, std::string_view scalar) {
    const DeepPairs& pairs = deep_pairs();
    Measured measured{.unit = "pixel", .note = fmt::format("of {}", pairs.drawn)};
    for (std::size_t i = 0; i < pairs.scenes.size(); ++i) {
        const Scene scene = readable_scene(pairs.scenes[i], row.method(scalar));
        const auto& expected = scalar == "fixed" ? pairs.on_grid[i] : pairs.typed[i];
        measured.wrong += differing(drawn_picture(scene), expected);
    }
    return measured;
}

/// The same by a buffer of 24-bit codes of 1 - near/z, near 1/32, far at infinity.
Measured pairs_by_codes(const TableRow&, std::string_view) {
    const DeepPairs& pairs = deep_pairs();
    Measured measured{.unit = "pixel", .note = fmt::format("of {}", pairs.drawn)};
    for (const std::string& pair : pairs.scenes) {
        const Scene scene = readable_scene(pair, {{"scalar", "exact"}});
        const auto corners = exact_corners(scene, 0);
        if (exact_area2(corners) == 0)
            continue;
        const auto plane = [&](std::size_t triangle) {
            std::array<Rational, 3> inverse;
            for (std::size_t k = 0; k < 3; ++k)
                inverse[k] = 1 / scene.vertices[scene.primitives[triangle].vertices[k]].z.exact();
            return plane_through(corners, inverse);
        };
        const ExactPlane first = plane(0);
        const ExactPlane second = plane(1);
        const auto covered = covered_by(corners, scene.method, scene.canvas);
        for (int y = 0; y < scene.canvas.height; ++y)
            for (int x = 0; x < scene.canvas.width; ++x) {
                if (!covered[scene.canvas.offset_of({x, y})])
                    continue;
                const ExactPoint sample{Rational(2 * x + 1, 2), Rational(2 * y + 1, 2)};
                const Rational t = first.at(sample);
                const Rational u = second.at(sample);
                // U is drawn second: it wins if it is nearer, by its code.
                const bool wins = code_of(1 - u / 32, 24) < code_of(1 - t / 32, 24);
                measured.wrong += wins == (u > t) ? 0 : 1;
            }
    }
    return measured;
}

// Z7 and Z12: tests in the trace of a scene.

std::uint64_t depth_tests(const TableRow& row, std::string_view scalar, bool only_passes) {
    const Trace trace = row.trace(scalar);
    const auto tests = trace.steps_of({StepKind::depth});
    if (!only_passes)
        return tests.size();
    return static_cast<std::uint64_t>(
        std::count_if(tests.begin(), tests.end(), [&trace](std::size_t n) {
            return trace.step(n).as<DepthStep>().pass.is_true();
        }));
}

Measured tests(const TableRow& row, std::string_view scalar) {
    return counted_as(row, depth_tests(row, scalar, false));
}

Measured passes(const TableRow& row, std::string_view scalar) {
    return counted_as(row, depth_tests(row, scalar, true));
}

/// Z12: none may pass.
Measured false_passes(const TableRow& row, std::string_view scalar) {
    return {.wrong = depth_tests(row, scalar, true),
            .unit = "test",
            .note = counted(depth_tests(row, scalar, false), "test")};
}

Measured is_tested(const TableRow& row, std::string_view scalar) {
    return counted_as(row, depth_tests(row, scalar, false) > 0 ? 1 : 0);
}

constexpr auto measures_of_depths = std::to_array<NamedMeasure>({
    {"red pixels", red_pixels},
    {"pixels drawn", pixels_drawn},
    {"middle of an edge", middle_of_edge},
    {"largest linear error", largest_linear_error},
    {"accumulated depth", accumulated_depth},
    {"mixed depth", mixed_depth},
    {"row of depths", row_of_depths},
    {"code width", code_width},
    {"planes by codes", planes_by_codes},
    {"steps between depths", steps_between_depths},
    {"deep pairs", pairs_by_depth},
    {"deep pairs by codes", pairs_by_codes},
    {"depth tests", tests},
    {"depth passes", passes},
    {"false passes", false_passes},
    {"is tested", is_tested},
});

} // namespace

std::span<const NamedMeasure> depth_measures() {
    return measures_of_depths;
}

} // namespace rastertrace
