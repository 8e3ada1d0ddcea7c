// SPDX-License-Identifier: MIT
// X: leaving stages out, and when that does not leave the picture as it is.

#include "stress_rows.h"

#include <rastertrace/core/raster/barycentric.h>
#include <rastertrace/core/transform/matrix.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rastertrace {

namespace {

/// With every scalar, the pixels that differ between two ways to draw a scene.
void add_two_ways(StressRows& rows, std::string_view label, std::string_view json,
                  const MethodOverrides& one_way, const MethodOverrides& other_way,
                  const DocumentedOfScalars& documented = {}) {
    rows.add_for_all(label, documented, [&](std::string_view scalar) -> Measured {
        const auto a = drawn_picture(readable_scene(json, with_scalar_named(one_way, scalar)));
        const auto b = drawn_picture(readable_scene(json, with_scalar_named(other_way, scalar)));
        return {.wrong = differing(a, b), .unit = "pixel", .note = counted(drawn_in(a), "pixel")};
    });
}

/// With a stage kept that the scene does not need, and without.
void add_kept(StressRows& rows, std::string_view label, std::string_view json,
              const std::string& stage) {
    add_two_ways(rows, label, json, {{"keep", stage}}, {});
}

/// A scene in space; all of it lies in view.
constexpr std::string_view in_view = R"({
  "canvas": {"width": 64, "height": 64, "origin": "top-left"},
  "vertices": {"A": [-0.0, -1, -2], "B": [1, 0.1, -3], "C": [-0.7, 0.9, -2.5]},
  "triangles": ["ABC"],
  "projection": {"type": "frustum", "left": -1, "right": 1, "bottom": -1, "top": 1,
                 "near": 1, "far": 9},
  "method": {"fill": "top-left"}
})";

/// The same where w is 1 everywhere.
constexpr std::string_view parallel_view = R"({
  "canvas": {"width": 64, "height": 64, "origin": "top-left"},
  "vertices": {"A": [-0.0, -1, -2], "B": [1, 0.1, -3], "C": [-0.7, 0.9, -2.5]},
  "triangles": ["ABC"],
  "projection": {"type": "orthographic", "left": -1, "right": 1, "bottom": -1, "top": 1},
  "method": {"fill": "top-left"}
})";

/// X1: the identity matrix times a point that is not finite: numbers that are NaN, not 1.
Measured identity_times_infinity() {
    const Vec<double, 4> product =
        identity<double>() * Vec<double, 4>{std::numeric_limits<double>::infinity(), 1, 1, 1};
    Measured measured{.unit = "number"};
    for (const double x : {product.y, product.z, product.w})
        measured.wrong += x == 1 ? 0 : 1;
    measured.note = std::isnan(product.y) ? "0 Inf is NaN" : "";
    return measured;
}

/// X3: for how many of 1..1000 x (1/w) is not x/w.
template <typename Real> Measured by_reciprocal(int w) {
    const Real reciprocal = 1 / static_cast<Real>(w);
    Measured measured{.unit = "number"};
    int first = 0;
    for (int i = 1; i <= 1000; ++i) {
        const auto x = static_cast<Real>(i);
        if (x * reciprocal == x / static_cast<Real>(w))
            continue;
        ++measured.wrong;
        first = first == 0 ? i : first;
    }
    if (first > 0)
        measured.note = fmt::format("of 1000, first {}", first);
    return measured;
}

constexpr std::string_view x4 = R"({
  "canvas": {"width": 64, "height": 64, "origin": "top-left"},
  "vertices": {"A": [3, 2, 3], "B": [61, 9, 3], "C": [17, 60, 3]},
  "triangles": ["ABC"],
  "method": {"fill": "top-left", "depth": "inverse-z"}
})";

/// X4: the pixels in which w1 c + w2 c + w3 c is not c = 1/3.
template <typename Scalar> Measured mixed_constant(const MethodOverrides& method) {
    const Scene scene = readable_scene(x4, method);
    const auto place = [&scene](std::size_t i) {
        return Vec<Scalar, 2>{scalar_from<Scalar>(scene.vertices[i].x),
                              scalar_from<Scalar>(scene.vertices[i].y)};
    };
    const Barycentric<Scalar> barycentric(Triangle<Scalar>{{place(0), place(1), place(2)}});
    const auto covered = covered_by(exact_corners(scene, 0), scene.method, scene.canvas);
    const Scalar third = scalar_from<Scalar>(1) / scalar_from<Scalar>(3);
    const Scalar half = scalar_from<Scalar>(1) / scalar_from<Scalar>(2);
    Measured measured{.unit = "pixel"};
    for (int y = 0; y < scene.canvas.height; ++y)
        for (int x = 0; x < scene.canvas.width; ++x) {
            if (!covered[scene.canvas.offset_of({x, y})])
                continue;
            const auto weights = barycentric.weights_at(
                {Scalar(scalar_from<Scalar>(x) + half), Scalar(scalar_from<Scalar>(y) + half)});
            const Scalar mixed = weights[0] * third + weights[1] * third + weights[2] * third;
            measured.wrong += mixed == third ? 0 : 1;
        }
    measured.note = fmt::format("of {}", std::count(covered.begin(), covered.end(), true));
    return measured;
}

/// S10's square at one depth.
constexpr std::string_view x5 = R"({
  "canvas": {"width": 12, "height": 12, "origin": "top-left"},
  "vertices": {"A": [0, 0, 1], "B": [8, 0, 1], "C": [8, 8, 1], "D": [0, 8, 1]},
  "triangles": [{"vertices": "ABC", "color": "red"}, {"vertices": "ACD", "color": "blue"}],
  "method": {"depth": "inverse-z"}
})";

/// A double pyramid on a square, seen along its axis: the square is its silhouette, and lies on
/// samples. Each side of the square belongs to a front face (red) and a back face (blue).
std::string pyramid(bool back_faces_first) {
    const std::string front = R"(
    {"vertices": "ABP", "color": "red"}, {"vertices": "BCP", "color": "red"},
    {"vertices": "CDP", "color": "red"}, {"vertices": "DAP", "color": "red"})";
    const std::string back = R"(
    {"vertices": "BAQ", "color": "blue"}, {"vertices": "CBQ", "color": "blue"},
    {"vertices": "DCQ", "color": "blue"}, {"vertices": "ADQ", "color": "blue"})";
    return fmt::format(R"({{
  "canvas": {{"width": 17, "height": 17}},
  "vertices": {{"A": [-5, -5, -10], "B": [5, -5, -10], "C": [5, 5, -10], "D": [-5, 5, -10],
               "P": [0, 0, -5], "Q": [0, 0, -15]}},
  "triangles": [{},{}],
  "projection": {{"type": "orthographic", "left": -8, "right": 8, "bottom": -8, "top": 8}},
  "viewport": "fit",
  "method": {{"fill": "barycentric", "depth": "linear-z"}}
}})",
                       back_faces_first ? back : front, back_faces_first ? front : back);
}

/// T in front of U. `z` is that of U's nearest corners; T reaches to z = 4. They share the 9 samples
/// of the edge x = 8.
std::string one_behind_the_other(int z) {
    return fmt::format(R"({{
  "canvas": {{"width": 20, "height": 12, "origin": "top-left"}},
  "vertices": {{"A": [0, 0, 2], "B": [8, 0, 4], "C": [8, 8, 4],
               "D": [8, 0, {0}], "E": [16, 0, {1}], "F": [8, 8, {0}]}},
  "triangles": [{{"vertices": "DEF", "color": "blue"}}, {{"vertices": "ABC", "color": "red"}}],
  "method": {{"fill": "barycentric", "depth": "linear-z"}}
}})",
                       z, z + 2);
}

/// X9: steps of the planned trace that the full one does not have in the same order, and how many
/// more the full one has.
Measured planned_in_full(std::string_view json, std::string_view scalar) {
    const MethodOverrides method = with_scalar_named({}, scalar);
    MethodOverrides full = method;
    for (const char* const stage : {"model", "view", "clip", "divide", "canvas"})
        full.emplace_back("keep", stage);
    const auto planned = trace_in(json, method);
    const auto complete = trace_in(json, full);
    if (!planned || !complete)
        return {.wrong = 1, .unit = "trace"};
    std::size_t n = 1;
    Measured measured{.unit = "step"};
    for (std::size_t k = 1; k <= planned.value().size(); ++k) {
        const auto step = planned.value().step(k).json();
        while (n <= complete.value().size() && complete.value().step(n).json() != step)
            ++n;
        measured.wrong += n > complete.value().size() ? 1 : 0;
        ++n;
    }
    measured.wrong += planned.value().end->frame == complete.value().end->frame ? 0 : 1;
    measured.note =
        fmt::format("{}, and {} of stages left out", counted(planned.value().size(), "step"),
                    complete.value().size() - planned.value().size());
    return measured;
}

/// X1 attacks leaving out an identity matrix: it does change infinities and -0.
void x1_identity(StressRows& rows) {
    add_kept(rows, "model kept", in_view, "model");
    add_kept(rows, "view kept", in_view, "view");
    rows.add("double", "textbook: identity times (Inf,1,1,1)", identity_times_infinity(),
             wrong(3, "", "NaN"));
}

/// X2 attacks leaving out a division by 1.
void x2_division_by_one(StressRows& rows) {
    add_kept(rows, "divide kept", parallel_view, "divide");
}

/// X3 attacks the product with 1/w in place of a division by w.
void x3_reciprocal(StressRows& rows) {
    rows.add("double", "textbook: x (1/3)", by_reciprocal<double>(3), wrong(332, "", "first 5"));
    rows.add("float", "textbook: x (1/3)", by_reciprocal<float>(3), wrong(332, "", "first 5"));
    rows.add("float", "textbook: x (1/7)", by_reciprocal<float>(7), wrong(550));
    rows.add("double", "textbook: x (1/7)", by_reciprocal<double>(7), wrong(362));
    rows.add("float", "textbook: x (1/4)", by_reciprocal<float>(4), right());
    rows.add("double", "textbook: x (1/4)", by_reciprocal<double>(4), right());
}

/// X4 attacks weights, which do not sum to 1 when rounded.
void x4_constant_depth(StressRows& rows) {
    add_kept(rows, "depth kept", x4, "depth");
    rows.add("float", "textbook: w1 c + w2 c + w3 c", mixed_constant<float>({}),
             wrong(491, "", "of 1634"));
    rows.add("double", "textbook: w1 c + w2 c + w3 c", mixed_constant<double>({}),
             wrong(496, "", "of 1634"));
    rows.add("exact", "textbook: w1 c + w2 c + w3 c", mixed_constant<Rational>({}), right());
}

/// X5 attacks leaving out the depth buffer where triangles only touch.
void x5_no_overlap(StressRows& rows) {
    add_kept(rows, "scanline, depth kept", x5, "depth");
    add_two_ways(rows, "scanline, no depth", x5, {}, {{"depth", "none"}}, {{"all", wrong(9)}});
    add_two_ways(rows, "top-left, no depth", x5, {{"fill", "top-left"}},
                 {{"fill", "top-left"}, {"depth", "none"}});
}

/// X6 attacks the culling of back faces, by a silhouette on samples.
void x6_back_faces(StressRows& rows) {
    add_two_ways(rows, "front faces first", pyramid(false), {{"cull", "back"}}, {});
    add_two_ways(rows, "back faces first", pyramid(true), {{"cull", "back"}}, {},
                 {{"all", wrong(40)}});
}

/// X7 attacks leaving out the clipper.
void x7_all_in_view(StressRows& rows) {
    add_kept(rows, "clip kept", in_view, "clip");
}

/// X8 attacks the painter in place of a depth buffer.
void x8_painter(StressRows& rows) {
    add_two_ways(rows, "painter, apart", one_behind_the_other(5), {}, {{"depth", "painter"}});
    add_two_ways(rows, "painter, touching", one_behind_the_other(4), {}, {{"depth", "painter"}},
                 {{"all", wrong(9)}});
}

/// X9 attacks the promise that a stage left out takes only its own steps with it.
void x9_traces(StressRows& rows) {
    rows.add_for_all("planned, in the full trace", {},
                     [](std::string_view scalar) { return planned_in_full(in_view, scalar); });
}

constexpr auto stages_catalogue = std::to_array<StressCase>({
    {.id = "X1",
     .title = "the identity matrix",
     .input = "a matrix that moves nothing, kept or left out; a point with an infinity or -0",
     .why = "0 times Inf is NaN in the other rows; -0 + 0 is +0",
     .holds =
         "left out, the picture is the same, because what is not finite is refused before, and "
         "zeros are compared as numbers",
     .scenes = [] { return only(in_view); },
     .run = x1_identity},
    {.id = "X2",
     .title = "division by w = 1",
     .input = "x/1",
     .why = "a division is rounded, but not this one",
     .holds = "x/1 = x for every number: the division may be left out",
     .scenes = [] { return only(parallel_view); },
     .run = x2_division_by_one},
    {.id = "X3",
     .title = "times 1/w for division by w",
     .input = "1..1000, w = 3, 4 and 7",
     .why = "two roundings instead of one",
     .holds = "not the same: w = 3: 332 differ in double, the first 5; w = 7: 550 in float. Only "
              "powers of two are. Ours divides.",
     .run = x3_reciprocal},
    {.id = "X4",
     .title = "a depth that is the same everywhere",
     .input = "1/z = 1/3 at (3,2)(61,9)(17,60)",
     .why = "weights that are rounded do not sum to 1",
     .holds = "d1 + w2 (d2 - d1) + w3 (d3 - d1), ours, keeps it; w1 c + w2 c + w3 c changes it in "
              "491 (float) and 496 (double) of 1,634 pixels",
     .scenes = [] { return only(x4); },
     .run = x4_constant_depth},
    {.id = "X5",
     .title = "faces that cannot overlap",
     .input = "S10's square at one depth, with and without a depth buffer",
     .why = "the triangles do not overlap; their pixels do",
     .holds = "floor: 9 pixels in both, where the buffer keeps the first and no buffer the last; "
              "top-left: none. So the plan asks the pixels, not the geometry.",
     .scenes = [] { return only(x5); },
     .run = x5_no_overlap},
    {.id = "X6",
     .title = "back faces of a closed solid",
     .input = "a double pyramid whose silhouette lies on samples, culled or not",
     .why = "on the silhouette a front and a back face are equally far",
     .holds = "culled or not, the same, if front faces are drawn first; if back faces are, 40 "
              "pixels "
              "of the silhouette are theirs",
     .scenes =
         [] {
             return Scenes{{"front faces first", pyramid(false)},
                           {"back faces first", pyramid(true)}};
         },
     .run = x6_back_faces},
    {.id = "X7",
     .title = "clipping where nothing is outside",
     .input = "every vertex in view",
     .why = "a clipper that cuts at a plane it does not meet makes vertices of its own",
     .holds = "the same picture, because the planes themselves are inside",
     .scenes = [] { return only(in_view); },
     .run = x7_all_in_view},
    {.id = "X8",
     .title = "a painter instead of a buffer",
     .input = "two triangles with depths 2..4 and 5..7; 2..4 and 4..6",
     .why = "where the ranges touch, depths tie: the buffer keeps the first, the painter the last",
     .holds = "ranges apart: the same picture; touching: 9 pixels differ",
     .scenes =
         [] {
             return Scenes{{"apart", one_behind_the_other(5)},
                           {"touching", one_behind_the_other(4)}};
         },
     .run = x8_painter},
    {.id = "X9",
     .title = "the trace without stages left out",
     .input = "a triangle in space, its stages as planned and all of them",
     .why = "the pictures are the same; are the steps?",
     .holds = "the same frame; the full trace is the planned one and the steps of the stages "
              "that were left out",
     .scenes = [] { return only(in_view); },
     .run = x9_traces},
});

} // namespace

std::span<const StressCase> stage_cases() {
    return stages_catalogue;
}

} // namespace rastertrace
