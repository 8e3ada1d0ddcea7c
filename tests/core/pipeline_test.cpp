// SPDX-License-Identifier: MIT
// From object space to the screen. Worked numbers are those of T4 and T0 (sources.md) and of
// numerics.md, part P; the rest are properties.

#include "picture.h"

#include <rastertrace/core/draw/list/geometry.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/paint/fill_top_left.h>
#include <rastertrace/core/numbers/irrational.h>
#include <rastertrace/core/raster/clip.h>
#include <rastertrace/core/raster/flat_painter.h>

#include <glm/gtc/matrix_transform.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

Matrix<Rational> projection_matrix(const Projection& projection, const Canvas& canvas) {
    return product_of(factors_of(projection, canvas));
}

Matrix<Rational> viewport_matrix(const Viewport& viewport, const Canvas& canvas) {
    return product_of(factors_of(viewport, canvas));
}

using ::testing::ElementsAre;

template <typename Scalar> Matrix<Scalar> matrix_of(std::span<const std::array<Quantity, 4>> told) {
    Matrix<Scalar> matrix;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            matrix.rows[row][column] = as<Scalar>(told[row][column]);
    return matrix;
}

/// Keeps where each vertex was placed, and the matrices.
template <typename Scalar> struct PlaceSink {
    std::map<std::pair<std::string, Space>, std::vector<Scalar>> places;
    std::map<std::pair<std::string, Space>, std::vector<Scalar>> snapped;
    std::map<std::string, Matrix<Scalar>> matrices;

    void operator()(const VertexPlaced<>& step) {
        const auto numbers = [](std::span<const Quantity> told) {
            std::vector<Scalar> result;
            for (const Quantity& number : told)
                result.push_back(as<Scalar>(number));
            return result;
        };
        places[{std::string(step.name), step.space}] = numbers(step.at);
        if (step.snapped)
            snapped[{std::string(step.name), step.space}] = numbers(*step.snapped);
    }
    void operator()(const MatrixSetUp<>& step) {
        matrices[std::string(step.name)] = matrix_of<Scalar>(step.rows);
    }

    const std::vector<Scalar>& at(const std::string& name, Space space) const {
        return places.at({name, space});
    }
};

template <typename Scalar> PlaceSink<Scalar> places_in(const Scene& scene) {
    PlaceSink<Scalar> sink;
    const auto list = screen_list_of(scene, geometry_of<Scalar>(scene));
    tell_geometry(scene, list, sink);
    tell_all_pieces(scene, list, sink, [](const ScreenPrimitive&, const auto&) {});
    return sink;
}

using Rationals = std::vector<Rational>;

/// A scene of points at whole coordinates.
Scene scene_of_points(const std::vector<std::array<int, 3>>& points) {
    Scene scene;
    scene.canvas = {.width = 512, .height = 512, .origin = Origin::top_left};
    scene.method.scalar = ScalarKind::exact;
    for (const auto& [x, y, z] : points) {
        const std::string name(1, static_cast<char>('A' + scene.vertices.size()));
        scene.primitives.push_back({.kind = PrimitiveKind::point,
                                    .name = name,
                                    .vertices = {scene.vertices.size()},
                                    .color = {}});
        scene.vertices.push_back({name, x, y, {}, z});
    }
    return scene;
}

Projection view_plane(int distance) {
    return {.type = ProjectionType::view_plane, .distance = distance};
}

const Viewport fit{.type = ViewportType::pixels, .pixels_per_unit = 1};

TEST(Pipeline, CameraOfT4) {
    Scene scene = scene_of_points({{0, 0, 0}, {1, 1, 1}});
    scene.camera = Camera{.position = {0, 0, 4}, .look_at = {0, 0, 0}, .up = {0, 1, 0}};
    const auto placed = places_in<Rational>(scene);
    const Matrix<Rational> view{{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, -4}, {0, 0, 0, 1}}}};
    EXPECT_TRUE(placed.matrices.at("view") == view);
    EXPECT_EQ(placed.at("A", Space::camera), (Rationals{0, 0, -4}));
    EXPECT_EQ(placed.at("B", Space::camera), (Rationals{1, 1, -3}));
}

TEST(Pipeline, ViewPlaneOfT4ToCanonicalSpaceAndTheScreen) {
    struct Row {
        int z, distance;
        Rationals canonical, screen;
    };
    const auto q = [](const char* text) { return Rational(text); };
    const std::vector<Row> rows{
        {-3, 1, {q("1/3"), q("1/3"), q("-2/3")}, {q("1022/3"), q("511/3")}},
        {-3, 2, {q("2/3"), q("2/3"), q("-2/3")}, {q("2555/6"), q("511/6")}},
        {-3, 3, {1, 1, 0}, {511, 0}},
        {-4, 1, {q("1/4"), q("1/4"), q("-3/4")}, {q("2555/8"), q("1533/8")}},
        {-4, 2, {q("1/2"), q("1/2"), -1}, {q("1533/4"), q("511/4")}},
        {-4, 3, {q("3/4"), q("3/4"), q("-3/4")}, {q("3577/8"), q("511/8")}},
        {-5, 1, {q("1/5"), q("1/5"), q("-4/5")}, {q("1533/5"), q("1022/5")}},
    };
    for (const Row& row : rows) {
        Scene scene = scene_of_points({{1, 1, row.z}, {0, 0, -4}});
        scene.projection = view_plane(row.distance);
        scene.viewport = fit;
        const auto placed = places_in<Rational>(scene);
        EXPECT_EQ(placed.at("A", Space::canonical), row.canonical) << row.z << row.distance;
        EXPECT_EQ(placed.at("A", Space::screen), row.screen) << row.z << row.distance;
        EXPECT_EQ(placed.at("B", Space::screen), (Rationals{q("511/2"), q("511/2")}));

        // Few ulps where each coordinate takes a product, a quotient and a sum.
        const auto in_double = places_in<double>(scene).at("A", Space::screen);
        const auto in_float = places_in<float>(scene).at("A", Space::screen);
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_NEAR(in_double[i], row.screen[i].get_d(), 4 * 512 * 0x1p-53);
            EXPECT_NEAR(in_float[i], row.screen[i].get_d(), 4 * 512 * 0x1p-24);
        }
    }
}

TEST(Pipeline, CornersOfTheViewport) {
    const Canvas canvas{.width = 512, .height = 512, .origin = Origin::top_left};
    const auto at = [&canvas](const Rational& x, const Rational& y) {
        const auto screen =
            viewport_matrix(fit, canvas) * Vec<Rational, 4>{x, y, Rational(0), Rational(1)};
        return std::pair(screen.x, screen.y);
    };
    EXPECT_EQ(at(-1, 1), std::pair(Rational(0), Rational(0)));
    EXPECT_EQ(at(1, -1), std::pair(Rational(511), Rational(511)));
    EXPECT_EQ(at(0, 0), std::pair(Rational("511/2"), Rational("511/2")));
    EXPECT_EQ(at(Rational("1/2"), Rational("1/2")),
              std::pair(Rational("1533/4"), Rational("511/4")));
}

// Each coordinate by itself, from where the canvas begins and where it ends: without a matrix.
RC_GTEST_PROP(Pipeline, ViewportsPutThePlaneOnTheCanvas, ()) {
    const Canvas canvas{
        .width = *rc::gen::inRange(1, 2000),
        .height = *rc::gen::inRange(1, 2000),
        .origin = *rc::gen::element(Origin::center, Origin::top_left, Origin::bottom_left)};
    const Viewport viewport{
        .type = ViewportType::pixels,
        .pixels = *rc::gen::element(PixelRange::centers, PixelRange::edges, PixelRange::edges_half),
        .is_y_down = *rc::gen::arbitrary<bool>()};
    Rational x(*rc::gen::inRange(-300, 300), 97);
    Rational y(*rc::gen::inRange(-300, 300), 89);
    x.canonicalize();
    y.canonicalize();
    // A pixel reaches so far to both sides of the number that it has.
    const bool is_center = viewport.pixels == PixelRange::centers;
    const bool is_edges = viewport.pixels == PixelRange::edges;
    const Rational before = is_center || is_edges ? Rational(0) : Rational(-1, 2);
    const Rational behind = is_center ? Rational(0) : is_edges ? Rational(1) : Rational(1, 2);
    const Rational left = canvas.left() + before;
    const Rational right = canvas.right() + behind;
    const bool grows_up = canvas.down() < 0;
    const Rational top = canvas.top() + (grows_up ? behind : before);
    const Rational bottom = canvas.bottom() + (grows_up ? before : behind);
    const Rational from_top = viewport.is_y_down ? Rational((1 + y) / 2) : Rational((1 - y) / 2);

    const auto screen =
        viewport_matrix(viewport, canvas) * Vec<Rational, 4>{x, y, Rational(7), Rational(1)};
    RC_ASSERT((screen.x == left + (x + 1) / 2 * (right - left)));
    RC_ASSERT((screen.y == top + from_top * (bottom - top)));
    RC_ASSERT((screen.z == 7 && screen.w == 1));
}

// Whatever the origin of the canvas, (-1, 1) is its first pixel and (1, -1) its last.
RC_GTEST_PROP(Pipeline, FitMeetsTheCornersOfEveryCanvas, ()) {
    const Canvas canvas{
        .width = *rc::gen::inRange(1, 2000),
        .height = *rc::gen::inRange(1, 2000),
        .origin = *rc::gen::element(Origin::center, Origin::top_left, Origin::bottom_left)};
    const auto matrix = viewport_matrix(fit, canvas);
    const auto first =
        matrix * Vec<Rational, 4>{Rational(-1), Rational(1), Rational(0), Rational(1)};
    const auto last =
        matrix * Vec<Rational, 4>{Rational(1), Rational(-1), Rational(0), Rational(1)};
    RC_ASSERT(first.x == canvas.left() && first.y == canvas.top());
    RC_ASSERT(last.x == canvas.right() && last.y == canvas.bottom());
}

TEST(Pipeline, CubeOfT0ThroughThePinhole) {
    const auto q = [](const char* text) { return Rational(text); };
    const std::vector<std::string> corners{"A", "B", "C", "D", "E", "F", "G", "H"};
    const auto placed = places_in<Rational>(cube_of_t0(corners));
    const auto& a = placed.at("A", Space::canonical);
    EXPECT_EQ(std::pair(a[0], a[1]), std::pair(q("-1/3"), q("1/3")));
    const auto& e = placed.at("E", Space::canonical);
    EXPECT_EQ(std::pair(e[0], e[1]), std::pair(q("-1/5"), q("1/5")));
    EXPECT_EQ(placed.at("A", Space::screen), (Rationals{q("-10/3"), q("10/3")}));
    EXPECT_EQ(placed.at("E", Space::screen), (Rationals{-2, 2}));

    // The text's figures cut toward zero; its stated rule is the floor.
    const auto snapped = [&corners](Snap snap, const std::string& name) {
        Scene scene = cube_of_t0(corners);
        scene.method.snap = snap;
        return places_in<Rational>(scene).snapped.at({name, Space::screen});
    };
    EXPECT_EQ(snapped(Snap::floor, "A"), (Rationals{-4, 3}));
    EXPECT_EQ(snapped(Snap::floor, "B"), (Rationals{3, 3}));
    EXPECT_EQ(snapped(Snap::floor, "D"), (Rationals{-4, -4}));
    EXPECT_EQ(snapped(Snap::floor, "E"), (Rationals{-2, 2}));
    EXPECT_EQ(snapped(Snap::truncate, "A"), (Rationals{-3, 3}));
    EXPECT_EQ(snapped(Snap::truncate, "D"), (Rationals{-3, -3}));
    EXPECT_EQ(snapped(Snap::nearest, "A"), (Rationals{-3, 3}));
}

// T4's center of the screen is 255.5: floor goes to 255, nearest (a half up, or to even) to 256.
TEST(Pipeline, SnapOfT4sTie) {
    for (const auto& [snap, expected] :
         {std::pair(Snap::floor, 255), std::pair(Snap::truncate, 255),
          std::pair(Snap::nearest, 256)}) {
        Scene scene = scene_of_points({{0, 0, -4}});
        scene.projection = view_plane(1);
        scene.viewport = fit;
        scene.method.snap = snap;
        EXPECT_EQ(places_in<Rational>(scene).snapped.at({"A", Space::screen}),
                  (Rationals{expected, expected}));
    }
}

/// Why a primitive was skipped.
struct SkipSink {
    std::vector<SkipReason> reasons;
    void operator()(const PrimitiveSkipped<>& step) { reasons.push_back(step.why); }
    template <typename Step> void operator()(const Step&) {}
};

TEST(Pipeline, WhatLiesBehindTheEyeHasNoPixel) {
    for (const ScalarKind scalar : {ScalarKind::single_precision, ScalarKind::double_precision,
                                    ScalarKind::fixed, ScalarKind::exact}) {
        Scene scene = scene_of_points({{1, 1, 2}});
        scene.projection = view_plane(1);
        scene.viewport = fit;
        scene.method.scalar = scalar;
        SkipSink sink;
        EXPECT_EQ(draw_as_planned(scene, sink).drawn(), 0u);
        EXPECT_EQ(sink.reasons, std::vector{SkipReason::behind_eye});

        scene.vertices[0].z = Number::decimal(-1, -4); // 1/10000 of a unit in front of it
        sink.reasons.clear();
        EXPECT_EQ(draw_as_planned(scene, sink).drawn(), 0u);
        EXPECT_EQ(sink.reasons, std::vector{SkipReason::too_near});
    }
}

/// numerics.md, part P: 64 x 64 pixels, row 0 at y = -1, centers, top-left. What is left of a
/// triangle after clipping by the frustum of left = bottom = -1, right = top = 1, near 1 and far 17.
std::size_t pixels_of_part_p(const std::vector<std::array<Number, 3>>& corners) {
    Scene scene;
    scene.canvas = {.width = 64, .height = 64, .origin = Origin::top_left};
    scene.projection = {.type = ProjectionType::frustum, .near = Number(1), .far = Number(17)};
    for (const auto& [x, y, z] : corners)
        scene.vertices.push_back({"V", x, y, {}, z});
    scene.primitives.push_back(
        {.kind = PrimitiveKind::triangle, .name = "T", .vertices = {0, 1, 2}, .color = {}});
    Image image(scene.canvas);
    const auto list = screen_list_of(scene, geometry_of<Rational>(scene));
    for_each_piece(scene, list, [&image](const Piece<Rational>& piece) {
        Triangle<Rational> triangle;
        for (std::size_t i = 0; i < 3; ++i)
            triangle.vertices[i] = {(piece.positions[i].x + 1) * 32,
                                    (piece.positions[i].y + 1) * 32};
        const Rational half(mpz_class(1), mpz_class(2));
        fill_top_left(triangle, SampleGrid<Rational>({half, half}, image.canvas()), image.canvas(),
                      FlatPainter(image, Color{}));
    });
    return image.drawn();
}

TEST(Pipeline, TrianglesOnAndBehindTheNearPlane) {
    const Number half = Number::decimal(5, -1);
    const Number minus_half = Number::decimal(-5, -1);
    EXPECT_EQ(pixels_of_part_p({{-1, -1, -2}, {1, -1, -2}, {0, half, -1}}), 512u) << "P1";
    EXPECT_EQ(
        pixels_of_part_p({{minus_half, minus_half, -1}, {half, minus_half, -1}, {0, half, -1}}),
        512u)
        << "P1, all on the plane";
    EXPECT_EQ(pixels_of_part_p({{-1, -1, minus_half}, {1, -1, minus_half}, {0, 1, minus_half}}), 0u)
        << "P1, all before it";
    EXPECT_EQ(pixels_of_part_p({{0, 1, -2}, {-1, -1, -2}, {1, -1, 2}}), 320u) << "P2";
    EXPECT_EQ(pixels_of_part_p({{0, 1, -2}, {-1, -1, -2}, {1, -1, 0}}), 768u) << "P3";
}

/// Twice the area of a polygon in the plane.
Rational area2_of(const std::vector<ClipVertex<Rational>>& polygon) {
    Rational sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto& p = polygon[i].position;
        const auto& q = polygon[(i + 1) % polygon.size()].position;
        sum += p.x * q.y - q.x * p.y;
    }
    return sum;
}

// What a plane cuts off and what it leaves make up the triangle, and lie on their own sides.
RC_GTEST_PROP(Clip, KeepsExactlyThePartInside, ()) {
    const auto whole = [] { return Rational(*rc::gen::inRange(-8, 9)); };
    std::vector<ClipVertex<Rational>> triangle;
    for (int i = 0; i < 3; ++i)
        triangle.push_back({{whole(), whole(), Rational(0), Rational(1)}, Rational(0), Color{}, i});
    const ClipPlane<Rational> plane{"near", {whole(), whole(), Rational(0), whole()}, whole()};
    const ClipPlane<Rational> other_side{"near",
                                         {Rational(-plane.factors.x), Rational(-plane.factors.y),
                                          Rational(0), Rational(-plane.factors.w)},
                                         Rational(-plane.constant)};
    const auto inside = clip(triangle, plane);
    const auto outside = clip(triangle, other_side);
    for (const auto& vertex : inside)
        RC_ASSERT(plane.value_at(vertex.position) >= 0);
    for (const auto& vertex : outside)
        RC_ASSERT(other_side.value_at(vertex.position) >= 0);
    RC_ASSERT(inside.size() <= 4u);
    const bool is_all_on_plane =
        plane.factors.x == 0 && plane.factors.y == 0 && plane.factors.w + plane.constant == 0;
    if (!is_all_on_plane)
        RC_ASSERT(area2_of(inside) + area2_of(outside) == area2_of(triangle));
}

/// A random model step with numbers of two digits.
rc::Gen<Number> gen_number() {
    return rc::gen::map(rc::gen::inRange(-99, 100),
                        [](int tenths) { return Number::decimal(tenths, -1); });
}
rc::Gen<Numbers3> gen_numbers3() {
    return rc::gen::map(
        rc::gen::tuple(gen_number(), gen_number(), gen_number()),
        [](const std::tuple<Number, Number, Number>& numbers) {
            return Numbers3{std::get<0>(numbers), std::get<1>(numbers), std::get<2>(numbers)};
        });
}
ModelStep random_step() {
    switch (*rc::gen::inRange(0, 4)) {
    case 0:
        return Scale{*gen_numbers3()};
    case 1:
        return Translate{*gen_numbers3()};
    case 2: {
        const Numbers3 axis = *rc::gen::suchThat(
            gen_numbers3(), [](const Numbers3& numbers) { return !is_zero(exact(numbers)); });
        return Rotate{axis, *gen_number()};
    }
    default:
        return Shear{.xy = *gen_number(),
                     .xz = *gen_number(),
                     .yx = *gen_number(),
                     .yz = *gen_number(),
                     .zx = *gen_number(),
                     .zy = *gen_number()};
    }
}

/// A random camera without fault.
Camera random_camera() {
    Camera camera{.position = *gen_numbers3(), .look_at = *gen_numbers3(), .up = *gen_numbers3()};
    RC_PRE(fault_of(camera) == CameraFault::none);
    return camera;
}

// P V M v, step by step through the spaces, is the product of the matrices as reported, times v.
RC_GTEST_PROP(Pipeline, IsTheProductOfItsMatrices, ()) {
    Scene scene = scene_of_points(
        {{*rc::gen::inRange(-9, 10), *rc::gen::inRange(-9, 10), *rc::gen::inRange(-9, 10)}});
    std::vector<ModelStep> model;
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i)
        model.push_back(random_step());
    scene.objects = {{"", 1, model}};
    scene.camera = random_camera();
    scene.projection = {.type = ProjectionType::frustum, .near = Number(1), .far = Number(100)};
    scene.keep = StageSet::all();
    const auto placed = places_in<Rational>(scene);
    const Vec<Rational, 4> object{scene.vertices[0].x.exact(), scene.vertices[0].y.exact(),
                                  scene.vertices[0].z.exact(), Rational(1)};
    const auto product = placed.matrices.at("projection") *
                         (placed.matrices.at("view") * placed.matrices.at("model"));
    const auto clip = product * object;
    RC_ASSERT(placed.at("A", Space::clip) == (Rationals{clip.x, clip.y, clip.z, clip.w}));

    // In double, each of three products of four terms is rounded; the terms can cancel, so the
    // bound goes by their sizes.
    const auto in_double = places_in<double>(scene);
    Rational largest = 1;
    for (const Matrix<Rational>* matrix :
         {&placed.matrices.at("projection"), &placed.matrices.at("view"),
          &placed.matrices.at("model")}) {
        Rational row_sum = 0;
        for (const auto& row : matrix->rows)
            for (const Rational& entry : row)
                row_sum = std::max<Rational>(row_sum, abs(entry));
        largest *= 4 * row_sum;
    }
    const double bound = 16 * 0x1p-53 * 10 * largest.get_d();
    for (std::size_t i = 0; i < 4; ++i)
        RC_ASSERT(std::abs(in_double.at("A", Space::clip)[i] -
                           placed.at("A", Space::clip)[i].get_d()) <= bound);
}

/// Keeps each matrix with the product of the factors that are told with it.
struct FactorSink {
    struct Told {
        Matrix<Rational> matrix;
        std::vector<std::string> names;
        Matrix<Rational> product;
        std::vector<Vec<Rational, 3>> camera;
    };
    std::map<std::string, Told> told = {};

    void operator()(const MatrixSetUp<>& step) {
        Told& one = told[std::string(step.name)];
        one.matrix = matrix_of<Rational>(step.rows);
        one.product = identity<Rational>();
        if (step.factors)
            one.names.assign(step.factors->begin(), step.factors->end());
        for (std::size_t i = 0; i < one.names.size(); ++i)
            one.product = one.product * matrix_of<Rational>(step.factor_rows->subspan(4 * i, 4));
        if (step.camera)
            for (const auto& v : *step.camera)
                one.camera.push_back({v.x.exact(), v.y.exact(), v.z.exact()});
    }
};

template <typename Scalar> FactorSink factors_in(const Scene& scene) {
    FactorSink sink;
    tell_geometry(scene, screen_list_of(scene, geometry_of<Scalar>(scene)), sink);
    return sink;
}

// The shift along an axis is -(axis . position) / |axis|, rounded once: its square times |axis|^2 is the square of
// the product, within two half units in the last place.
RC_GTEST_PROP(Pipeline, TheShiftOfAViewIsRoundedOnce, ()) {
    const Camera camera = random_camera();
    const auto view = view_matrix(camera, ViewAxis::minus_z);
    const CameraAxes axes = axes_of(camera);
    const std::array rows{axes.right, axes.up, axes.back};
    for (std::size_t i = 0; i < 3; ++i) {
        const Rational shift = view.rows[i][3];
        const Rational along = dot(rows[i], exact(camera.position));
        RC_ASSERT(sgn(shift) == -sgn(along));
        const Rational off = abs(shift * shift * dot(rows[i], rows[i]) - along * along);
        RC_ASSERT(off * (std::int64_t{1} << 51) <= along * along);
    }
}

/// T0's camera at the origin that looks along z, typed out, is no camera.
TEST(Pipeline, ACameraThatLooksAlongZMirrorsNothing) {
    EXPECT_EQ(view_matrix({.position = {0, 0, 0}, .look_at = {0, 0, 1}}, ViewAxis::plus_z),
              identity<Rational>());
}

TEST(Pipeline, ACameraThatLooksAtTheOriginHasNoShiftAcross) {
    // (0, 1, 0) x (3, 4, 12) = (12, 0, -3), at right angles to (3, 4, 12); so is the axis upward.
    const auto view = view_matrix({.position = {3, 4, 12}, .look_at = {0, 0, 0}}, ViewAxis::plus_z);
    EXPECT_EQ(view.rows[0][3], 0);
    EXPECT_EQ(view.rows[1][3], 0);
    EXPECT_EQ(view.rows[2][3], 13);
}

// Whatever the projection, the viewport and the way y points.
RC_GTEST_PROP(Pipeline, EachMatrixIsTheProductOfTheFactorsThatAreTold, ()) {
    Scene scene = scene_of_points({{1, 2, -3}});
    scene.canvas = {.width = *rc::gen::inRange(1, 40),
                    .height = *rc::gen::inRange(1, 40),
                    .origin =
                        *rc::gen::element(Origin::top_left, Origin::bottom_left, Origin::center)};
    std::vector<ModelStep> model;
    for (int i = *rc::gen::inRange(1, 4); i > 0; --i)
        model.push_back(random_step());
    scene.objects = {{"", 1, model}};
    scene.camera = random_camera();
    const int low = *rc::gen::inRange(-9, 9);
    scene.projection = {.type =
                            *rc::gen::element(ProjectionType::orthographic, ProjectionType::pinhole,
                                              ProjectionType::view_plane, ProjectionType::frustum),
                        .distance = *rc::gen::inRange(1, 9),
                        .left = low,
                        .right = low + *rc::gen::inRange(1, 9),
                        .bottom = low + 1,
                        .top = low + 1 + *rc::gen::inRange(1, 9)};
    if (scene.projection.type == ProjectionType::frustum || *rc::gen::arbitrary<bool>()) {
        scene.projection.near = Number(1);
        scene.projection.far = Number(*rc::gen::inRange(2, 9));
    }
    scene.viewport.type = *rc::gen::element(ViewportType::pixels, ViewportType::pixels_per_unit);
    scene.viewport.pixels_per_unit = *rc::gen::inRange(1, 9);
    scene.keep = StageSet::all();

    const FactorSink sink = factors_in<Rational>(scene);
    RC_ASSERT(sink.told.size() == 4u);
    for (const auto& [name, told] : sink.told) {
        RC_LOG() << name << "\n";
        // A view's shift is divided by the length of its axis last, and so is rounded once; its factors have
        // the axes rounded.
        const Rational slack = name == "view" ? Rational(40, std::int64_t{1} << 53) : Rational(0);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                RC_ASSERT(abs(told.product.rows[i][j] - told.matrix.rows[i][j]) <=
                          (j == 3 ? slack : Rational(0)));
        RC_ASSERT(!told.names.empty());
        RC_ASSERT(told.camera.empty() == (name != "view"));
    }
    RC_ASSERT(sink.told.at("model").names.size() == model.size());
    const auto& camera = sink.told.at("view").camera;
    RC_ASSERT(camera.size() == 3u);
    RC_ASSERT(is_zero(camera[0] - exact(scene.camera->position)));
    RC_ASSERT(is_zero(camera[1] - exact(scene.camera->look_at)));
    RC_ASSERT(is_zero(camera[2] - exact(scene.camera->up)));
}

// T4: Mpt = Mp Mt, and S((W - 1)/2, (H - 1)/2) T(1, 1) S(1, -1).
TEST(Pipeline, FactorsOfT4) {
    const Canvas canvas{.width = 512, .height = 512, .origin = Origin::top_left};
    const auto projection = factors_of(view_plane(2), canvas);
    ASSERT_EQ(projection.size(), 2u);
    EXPECT_EQ(projection[0].name, "perspective");
    EXPECT_TRUE(
        (projection[0].matrix.rows[3] == std::array<Rational, 4>{0, 0, Rational(-1, 2), 1}));
    EXPECT_EQ(projection[1].name, "translate");
    EXPECT_TRUE(projection[1].matrix == translation<Rational>({0, 0, 2}));
    const auto viewport = factors_of(fit, canvas);
    ASSERT_EQ(viewport.size(), 3u);
    EXPECT_TRUE(viewport[0].matrix == diagonal<Rational>(Rational(511, 2), Rational(511, 2), 1, 1));
    EXPECT_TRUE(viewport[1].matrix == translation<Rational>({1, 1, 0}));
    EXPECT_TRUE(viewport[2].matrix == diagonal<Rational>(1, -1, 1, 1));
}

TEST(Pipeline, FactorsBeyondTheScalarAreNotTold) {
    Scene scene = scene_of_points({{1, 2, -3}});
    scene.objects = {
        {"", 1, {Scale{{Number::decimal(1, 60), 1, 1}}, Scale{{Number::decimal(1, -60), 1, 1}}}}};
    scene.keep = StageSet::all();
    EXPECT_THAT(factors_in<double>(scene).told.at("model").names, ElementsAre("scale", "scale"));
    EXPECT_THAT(factors_in<float>(scene).told.at("model").names, ElementsAre());
    EXPECT_TRUE(factors_in<float>(scene).told.at("model").matrix == identity<Rational>());
}

TEST(Model, GoesInTheOrderListed) {
    const Model turn_then_move{Rotate{{0, 0, 1}, 90}, Translate{{1, 0, 0}}};
    const Model move_then_turn{Translate{{1, 0, 0}}, Rotate{{0, 0, 1}, 90}};
    const Vec<Rational, 4> x_axis{Rational(1), Rational(0), Rational(0), Rational(1)};
    const auto first = turn_then_move.matrix() * x_axis;
    const auto second = move_then_turn.matrix() * x_axis;
    EXPECT_EQ(std::pair(first.x, first.y), std::pair(Rational(1), Rational(1)));
    EXPECT_EQ(std::pair(second.x, second.y), std::pair(Rational(0), Rational(2)));
}

TEST(Model, ShearAddsEachOfTheSixMultiples) {
    const auto matrix =
        Model({Shear{.xy = 1, .xz = 2, .yx = 3, .yz = 4, .zx = 5, .zy = 6}}).matrix();
    const auto at =
        matrix * Vec<Rational, 4>{Rational(1), Rational(10), Rational(100), Rational(1)};
    EXPECT_EQ(at.x, 1 + 1 * 10 + 2 * 100);
    EXPECT_EQ(at.y, 10 + 3 * 1 + 4 * 100);
    EXPECT_EQ(at.z, 100 + 5 * 1 + 6 * 10);
}

TEST(Model, QuarterTurnsAreExact) {
    for (int quarters = -8; quarters <= 8; ++quarters)
        for (const Numbers3& axis :
             {Numbers3{1, 0, 0}, Numbers3{0, 5, 0}, Numbers3{0, 0, -2}, Numbers3{1, 2, 2}}) {
            const Rotate turn{axis, 90 * quarters};
            EXPECT_FALSE(is_rounded(ModelStep(turn)));
            Matrix<Rational> all = identity<Rational>();
            for (int i = 0; i < 4; ++i)
                all = Model({turn}).matrix() * all;
            EXPECT_TRUE(all == identity<Rational>());
        }
    EXPECT_TRUE(is_rounded(ModelStep(Rotate{{1, 0, 0}, 45})));
    EXPECT_TRUE(is_rounded(ModelStep(Rotate{{1, 1, 0}, 90})));

    // Half a turn needs no sine, and swaps x and y about (1, 1, 0).
    EXPECT_FALSE(is_rounded(ModelStep(Rotate{{1, 1, 0}, 180})));
    const Matrix<Rational> swap{{{{0, 1, 0, 0}, {1, 0, 0, 0}, {0, 0, -1, 0}, {0, 0, 0, 1}}}};
    EXPECT_TRUE(Model({Rotate{{1, 1, 0}, 180}}).matrix() == swap);
}

// Each entry of the matrix is off by at most half an ulp of 1, and so is its norm by a few; n turns
// add up: n (4 u) of the radius, and as much again for the roundings of each product.
TEST(Model, TurningAllTheWayRoundReturns) {
    for (const int n : {3, 5, 7, 12, 360, 1000}) {
        const auto matrix = rounded<double>(
            Model({Rotate{{1, 2, 3}, Number::fraction(mpq_class(mpz_class(360), mpz_class(n)))}})
                .matrix());
        Vec<double, 4> point{1, -2, 3, 1};
        for (int i = 0; i < n; ++i)
            point = matrix * point;
        const double bound = n * 8 * 0x1p-53 * std::sqrt(14.0);
        EXPECT_NEAR(point.x, 1, bound) << n;
        EXPECT_NEAR(point.y, -2, bound) << n;
        EXPECT_NEAR(point.z, 3, bound) << n;
    }
}

Vec<Rational, 4> as_point(const Vec<Rational, 3>& at) {
    return {at.x, at.y, at.z, Rational(1)};
}

// Every entry is the double nearest to a unit vector's component, so lengths are 1 and products 0 to
// three halves of an ulp of 1 and a bit.
RC_GTEST_PROP(CameraAxes, AreOrthonormal, ()) {
    const auto view =
        view_matrix(random_camera(), *rc::gen::element(ViewAxis::minus_z, ViewAxis::plus_z));
    const auto row = [&view](std::size_t i) {
        return Vec<Rational, 3>{view.rows[i][0], view.rows[i][1], view.rows[i][2]};
    };
    const Rational bound = Rational(4) / (mpz_class(1) << 53);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            RC_ASSERT(abs(dot(row(i), row(j)) - (i == j ? 1 : 0)) <= bound);
    // Right-handed: z = x cross y.
    const auto z = cross(row(0), row(1));
    RC_ASSERT(dot(z, row(2)) > 0);
}

// The eye goes to the origin, and what it looks at lies straight ahead on -z: as near as axes and shift, each rounded
// once, have them.
RC_GTEST_PROP(CameraAxes, LookAlongMinusZ, ()) {
    const Camera camera = random_camera();
    const auto view = view_matrix(camera, ViewAxis::minus_z);
    const auto position = exact(camera.position);
    const auto eye = view * as_point(position);
    const auto ahead = view * as_point(exact(camera.look_at));
    RC_ASSERT(ahead.z < 0);
    const Rational size = abs(position.x) + abs(position.y) + abs(position.z) - ahead.z;
    const Rational bound = size / (mpz_class(1) << 51);
    for (const Rational& off : {eye.x, eye.y, eye.z, ahead.x, ahead.y})
        RC_ASSERT(abs(off) <= bound);
}

TEST(CameraAxes, OfAnAxisAlignedCameraAreExact) {
    EXPECT_FALSE(is_rounded(Camera{.position = {0, 0, 4}, .look_at = {0, 0, 0}, .up = {0, 7, 3}}));
    EXPECT_FALSE(is_rounded(Camera{.position = {3, 0, 4}, .look_at = {0, 0, 0}, .up = {0, 1, 0}}));
    EXPECT_TRUE(is_rounded(Camera{.position = {1, 1, 1}, .look_at = {0, 0, 0}, .up = {0, 1, 0}}));
}

TEST(CameraAxes, FaultsHaveNames) {
    EXPECT_EQ(fault_of({.position = {1, 2, 3}, .look_at = {1, 2, 3}, .up = {0, 1, 0}}),
              CameraFault::looks_at_itself);
    EXPECT_EQ(fault_of({.position = {0, 4, 0}, .look_at = {0, 0, 0}, .up = {0, 1, 0}}),
              CameraFault::up_along_view);
    EXPECT_EQ(fault_of({.position = {0, 0, 4}, .look_at = {0, 0, 0}, .up = {0, 0, 0}}),
              CameraFault::up_along_view);
}

void expect_near(const Matrix<Rational>& ours, const glm::dmat4& theirs) {
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            const double expected = theirs[static_cast<int>(j)][static_cast<int>(i)];
            EXPECT_NEAR(ours.rows[i][j].get_d(), expected, 1e-14 * (1 + std::abs(expected)))
                << i << j;
        }
}

// A second opinion.
TEST(Pipeline, AgreesWithGlm) {
    const Canvas canvas{.width = 300, .height = 200};
    const double pi = std::numbers::pi;
    expect_near(projection_matrix({.type = ProjectionType::frustum,
                                   .fov_y = Number(50),
                                   .near = Number::decimal(1, -1),
                                   .far = Number(100)},
                                  canvas),
                glm::perspective(50 * pi / 180, 1.5, 0.1, 100.0));
    expect_near(
        projection_matrix(
            {.type = ProjectionType::frustum, .fov_y = Number(50), .near = Number::decimal(1, -1)},
            canvas),
        glm::infinitePerspective(50 * pi / 180, 1.5, 0.1));
    const Projection bounds{
        .left = -1, .right = 3, .bottom = -2, .top = 1, .near = Number(2), .far = Number(9)};
    Projection frustum = bounds;
    frustum.type = ProjectionType::frustum;
    expect_near(projection_matrix(frustum, canvas), glm::frustum(-1.0, 3.0, -2.0, 1.0, 2.0, 9.0));
    Projection orthographic = bounds;
    orthographic.type = ProjectionType::orthographic;
    expect_near(projection_matrix(orthographic, canvas),
                glm::ortho(-1.0, 3.0, -2.0, 1.0, 2.0, 9.0));
    expect_near(view_matrix({.position = {1, 2, 3}, .look_at = {4, -5, 6}, .up = {1, 1, 0}},
                            ViewAxis::minus_z),
                glm::lookAt(glm::dvec3(1, 2, 3), glm::dvec3(4, -5, 6), glm::dvec3(1, 1, 0)));
    expect_near(Model({Rotate{{1, 2, 3}, 77}}).matrix(),
                glm::rotate(glm::dmat4(1), 77 * pi / 180, glm::dvec3(1, 2, 3)));
}

// A triangle wholly in view is one piece, at the very places of its vertices: clipping neither cuts
// it nor moves it.
RC_GTEST_PROP(Pipeline, ClippingLeavesWhatIsInViewAlone, ()) {
    Scene scene;
    scene.canvas = {.width = 64, .height = 64};
    scene.projection = {.type = ProjectionType::frustum, .near = Number(1), .far = Number(20)};
    scene.viewport = fit;
    for (int i = 0; i < 3; ++i)
        scene.vertices.push_back({std::string(1, static_cast<char>('A' + i)),
                                  *rc::gen::inRange(-30, 31),
                                  *rc::gen::inRange(-30, 31),
                                  {},
                                  *rc::gen::inRange(-20, 0)});
    scene.primitives.push_back(
        {.kind = PrimitiveKind::triangle, .name = "ABC", .vertices = {0, 1, 2}, .color = {}});
    const auto with_planes = geometry_of<double>(scene);
    auto without_planes = with_planes;
    without_planes.list.transforms.planes.clear();
    std::vector<std::array<Vec<double, 2>, 3>> pieces;
    const auto collect = [&pieces](const Piece<double>& piece) {
        RC_ASSERT(!piece.is_part);
        pieces.push_back(piece.positions);
    };
    for_each_piece(scene, screen_list_of(scene, with_planes), collect);
    for_each_piece(scene, screen_list_of(scene, without_planes), collect);
    RC_ASSERT(pieces.size() == 2u);
    RC_ASSERT(pieces[0] == pieces[1]);
}

// A triangle of any size around a point in view: clipping leaves a polygon of 3 to 9 corners around
// that point, and no corner lies farther out than the guard band.
RC_GTEST_PROP(Pipeline, WhatClippingLeavesStaysWithinTheGuardBand, ()) {
    Scene scene;
    scene.canvas = {.width = 64, .height = 64};
    scene.projection = {.type = ProjectionType::frustum, .near = Number(1), .far = Number(20)};
    scene.viewport = fit;
    const auto any = [] { return *rc::gen::inRange<std::int64_t>(-1'000'000, 1'000'001); };
    const std::array<std::int64_t, 3> a{any(), any(), any()};
    const std::array<std::int64_t, 3> b{any(), any(), any()};
    scene.vertices = {{"A", a[0], a[1], {}, a[2]},
                      {"B", b[0], b[1], {}, b[2]},
                      {"C", -a[0] - b[0], -a[1] - b[1], {}, -30 - a[2] - b[2]}};
    scene.primitives.push_back(
        {.kind = PrimitiveKind::triangle, .name = "ABC", .vertices = {0, 1, 2}, .color = {}});
    int parts = 0;
    const auto list = screen_list_of(scene, geometry_of<Rational>(scene));
    for_each_piece(scene, list, [&parts](const Piece<Rational>& piece) {
        ++parts;
        for (const auto& position : piece.positions) {
            RC_ASSERT(abs(position.x) <= guard_band * 32);
            RC_ASSERT(abs(position.y) <= guard_band * 32);
        }
    });
    RC_ASSERT(1 <= parts && parts <= 7);
}

// From a far end, the difference of two coordinates is rounded to the size of the far one. What the
// near plane makes still has w = near, in every scalar.
TEST(Clip, LeavesWAtTheNearPlane) {
    for (const int exponent : {3, 6, 10, 14, 17}) {
        Scene scene;
        scene.canvas = {.width = 64, .height = 64};
        scene.projection = {.type = ProjectionType::frustum, .near = Number::decimal(1, -1)};
        scene.viewport = fit;
        scene.vertices = {{"A", 0, 1, {}, Number::decimal(-1, exponent)},
                          {"B", -1, -1, {}, 1},
                          {"C", 1, -1, {}, 1}};
        scene.primitives.push_back(
            {.kind = PrimitiveKind::triangle, .name = "ABC", .vertices = {0, 1, 2}, .color = {}});
        EXPECT_EQ(places_in<double>(scene).at("ABC:1", Space::clip)[3], 0.1) << exponent;
        EXPECT_EQ(places_in<float>(scene).at("ABC:1", Space::clip)[3], 0.1F) << exponent;
        EXPECT_EQ(places_in<Rational>(scene).at("ABC:1", Space::clip)[3], Rational("1/10"));
        for (const ScalarKind scalar : {ScalarKind::single_precision, ScalarKind::double_precision,
                                        ScalarKind::fixed, ScalarKind::exact}) {
            scene.method.scalar = scalar;
            EXPECT_FALSE(find_unfit(scene)) << exponent;
        }
    }
}

TEST(Pipeline, AnOrthographicViewHasNothingBehindIt) {
    Scene scene = scene_of_points({{0, 0, 0}});
    scene.projection = {.type = ProjectionType::orthographic, .near = Number(1), .far = Number(9)};
    scene.viewport = fit;
    SkipSink sink;
    EXPECT_EQ(draw_as_planned(scene, sink).drawn(), 0u);
    EXPECT_EQ(sink.reasons, std::vector{SkipReason::too_near});
}

// 10^9 pixels away, the numbers of `fixed` outgrow 128 bits; the line is drawn all the same.
TEST(Pipeline, FixedReachesFarOut) {
    Scene scene;
    scene.canvas = {.width = 20, .height = 12};
    scene.vertices = {{"A", 1'000'000'000, 0, {}}, {"B", 0, 0, {}}};
    scene.primitives.push_back(
        {.kind = PrimitiveKind::line, .name = "AB", .vertices = {0, 1}, .color = {}});
    scene.method = {.scalar = ScalarKind::fixed, .line = LineMethod::naive, .snap = Snap::floor};
    EXPECT_EQ(draw_as_planned(scene).drawn(), 10u) << "x = 0..9 of -10..9";
}

TEST(Pipeline, WhatHasNoPlaceIsFoundAndNotCastToAnIndex) {
    Scene scene = scene_of_points({{1, 1, 1}});
    scene.objects = {
        {"", 1, {Scale{{Number::decimal(1, 200), 1, 1}}, Scale{{Number::decimal(1, 200), 1, 1}}}}};
    scene.method = {.scalar = ScalarKind::double_precision, .snap = Snap::nearest};
    const auto unfit = find_unfit(scene);
    ASSERT_TRUE(unfit);
    EXPECT_EQ(unfit->what, Unfit::What::matrix);
    scene.objects[0].model = {Scale{{Number::decimal(1, 18), 1, 1}}};
    EXPECT_EQ(find_unfit(scene)->what, Unfit::What::coordinate_of_snap);
}

TEST(Irrational, SmallAnglesKeepTheirDigits) {
    const mpq_class tiny = mpq_class(1) / (mpz_class("1" + std::string(50, '0')));
    EXPECT_EQ(sine_of_degrees(tiny), 1.7453292519943295e-52) << "pi/180 x 10^-50";
    EXPECT_EQ(cotangent_of_degrees(tiny), 5.729577951308232e+51) << "180/pi x 10^50";
    EXPECT_EQ(cotangent_of_degrees(90 - tiny), 1.7453292519943295e-52);
}

TEST(Irrational, SinesAndCosinesAreTheNearestDoubles) {
    EXPECT_EQ(sine_of_degrees(30), 0.5);
    EXPECT_EQ(cosine_of_degrees(60), 0.5);
    EXPECT_EQ(sine_of_degrees(180), 0);
    EXPECT_EQ(cosine_of_degrees(-270), 0);
    EXPECT_EQ(cotangent_of_degrees(45), 1);
    for (int tenths = 0; tenths <= 900; ++tenths) {
        // A long double has 11 bits more; where it does not lie near the middle of two doubles, it
        // decides which is nearest.
        const long double radians =
            static_cast<long double>(tenths) / 1800 * std::numbers::pi_v<long double>;
        const mpq_class degrees = mpq_class(tenths) / 10;
        EXPECT_NEAR(sine_of_degrees(degrees).get_d(), static_cast<double>(std::sin(radians)),
                    std::abs(std::sin(static_cast<double>(radians))) * 0x1p-53);
        EXPECT_NEAR(cosine_of_degrees(degrees).get_d(), static_cast<double>(std::cos(radians)),
                    std::abs(std::cos(static_cast<double>(radians))) * 0x1p-53 + 0x1p-62);
    }
}

RC_GTEST_PROP(Irrational, SquareRootsAreTheNearestDoubles, ()) {
    const mpq_class square = mpq_class(*rc::gen::inRange<std::int64_t>(1, 1'000'000'000)) /
                             *rc::gen::inRange<std::int64_t>(1, 1'000'000'000);
    const mpq_class root = square_root(square);
    const double near = root.get_d();
    if (root * root == square)
        return;
    RC_ASSERT(mpq_class(near) == root);
    // The root lies between the middles to both neighbors.
    const mpq_class below = (root + mpq_class(std::nextafter(near, 0.0))) / 2;
    const mpq_class above = (root + mpq_class(std::nextafter(near, 1e300))) / 2;
    RC_ASSERT(below * below <= square && square <= above * above);
}

} // namespace
} // namespace rastertrace
