// SPDX-License-Identifier: MIT
// X: leaving stages out, and when that does not leave the picture as it is.

#include "stress_rows.h"

#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/transform/matrix.h>

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <limits>

namespace rastertrace {

namespace {

/// The pixels that differ between two ways to draw a scene, "by" and "other_by".
Measured two_ways(const TableRow& row, std::string_view scalar) {
    const auto a = drawn_picture(row.scene(scalar));
    const auto b = drawn_picture(row.scene(scalar, "scene", "other_by"));
    return {.wrong = differing(a, b), .unit = "pixel", .note = counted(drawn_in(a), "pixel")};
}

/// Those that differ between two scenes.
Measured two_scenes(const TableRow& row, std::string_view scalar) {
    return {.wrong = differing(drawn_picture(row.scene(scalar)),
                               drawn_picture(row.scene(scalar, "other"))),
            .unit = "pixel"};
}

/// X1: the identity matrix times a point that is not finite: numbers that are NaN, not 1.
Measured identity_times_infinity(const TableRow&, std::string_view) {
    const Vec<double, 4> product =
        identity<double>() * Vec<double, 4>{std::numeric_limits<double>::infinity(), 1, 1, 1};
    Measured measured{.unit = "number", .note = std::isnan(product.y) ? "0 Inf is NaN" : ""};
    for (const double x : {product.y, product.z, product.w})
        measured.wrong += x == 1 ? 0 : 1;
    return measured;
}

/// X3: for how many of 1..1000 x (1/w) is not x/w.
Measured by_reciprocal(const TableRow& row, std::string_view scalar) {
    return with_real(scalar, [&row]<typename Real>() {
        const auto w = row.number<Real>("w");
        const Real reciprocal = 1 / w;
        Measured measured{.unit = "number"};
        for (int i = 1; i <= 1000; ++i) {
            const auto x = static_cast<Real>(i);
            if (x * reciprocal != x / w && ++measured.wrong == 1)
                measured.note = fmt::format("of 1000, first {}", i);
        }
        return measured;
    });
}

/// X4: the pixels in which w1 c + w2 c + w3 c is not c = 1/3.
Measured mixed_constant(const TableRow& row, std::string_view scalar) {
    const Scene scene = row.scene({});
    const auto covered = covered_by(exact_corners(scene, 0), scene.method, scene.canvas);
    return with_type(scalar, [&]<typename Scalar>() {
        const auto place = [&scene](std::size_t i) {
            return Vec<Scalar, 2>{scalar_from<Scalar>(scene.vertices[i].x),
                                  scalar_from<Scalar>(scene.vertices[i].y)};
        };
        const Barycentric<Scalar> barycentric(Triangle<Scalar>{{place(0), place(1), place(2)}});
        const Scalar third = scalar_from<Scalar>(1) / scalar_from<Scalar>(3);
        const Scalar half = scalar_from<Scalar>(1) / scalar_from<Scalar>(2);
        Measured measured{.unit = "pixel", .note = fmt::format("of {}", count_in(covered))};
        for (int y = 0; y < scene.canvas.height; ++y)
            for (int x = 0; x < scene.canvas.width; ++x) {
                if (!covered[scene.canvas.offset_of({x, y})])
                    continue;
                const auto weights = barycentric.weights_at(
                    {Scalar(scalar_from<Scalar>(x) + half), Scalar(scalar_from<Scalar>(y) + half)});
                const Scalar mixed = weights[0] * third + weights[1] * third + weights[2] * third;
                measured.wrong += mixed == third ? 0 : 1;
            }
        return measured;
    });
}

/// X9: steps of the planned trace that the full one does not have in the same order, and how many
/// more the full one has.
Measured planned_in_full(const TableRow& row, std::string_view scalar) {
    MethodOverrides full = row.method(scalar);
    for (const char* const stage : {"model", "view", "clip", "divide", "canvas"})
        full.emplace_back("keep", stage);
    const Trace planned = row.trace(scalar);
    const Trace complete = trace_of(readable_scene(scene_text(row.text("scene")), full));
    std::size_t n = 1;
    Measured measured{.unit = "step"};
    for (std::size_t k = 1; k <= planned.size(); ++k) {
        const auto step = planned.step(k).json();
        while (n <= complete.size() && complete.step(n).json() != step)
            ++n;
        measured.wrong += n > complete.size() ? 1 : 0;
        ++n;
    }
    measured.wrong += planned.end->frame == complete.end->frame ? 0 : 1;
    measured.note = fmt::format("{}, and {} of stages left out", counted(planned.size(), "step"),
                                complete.size() - planned.size());
    return measured;
}

constexpr auto measures_of_stages = std::to_array<NamedMeasure>({
    {"two ways", two_ways},
    {"two scenes", two_scenes},
    {"identity times infinity", identity_times_infinity},
    {"reciprocal", by_reciprocal},
    {"mixed constant", mixed_constant},
    {"planned in full", planned_in_full},
});

} // namespace

std::span<const NamedMeasure> stage_measures() {
    return measures_of_stages;
}

} // namespace rastertrace
