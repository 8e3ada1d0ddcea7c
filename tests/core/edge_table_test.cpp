// SPDX-License-Identifier: MIT
#include "picture.h"

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/raster/fill_edge_table.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using ::testing::ElementsAre;

using Place = std::pair<Index, Index>;

/// What a polygon reported.
struct PolygonRecorder {
    std::map<Place, int> pixels; ///< how often each was plotted
    std::map<int, std::vector<std::pair<Rational, Rational>>> spans;
    std::map<int, std::vector<int>> winding;
    std::vector<SkipReason> skipped;

    template <typename Step> void operator()(const Step& step) {
        if constexpr (std::same_as<Step, PixelPlotted<>>)
            ++pixels[{step.x, step.y}];
        else if constexpr (std::same_as<Step, ScanlineSpanned<>>)
            spans[step.y].emplace_back(step.left.exact(), step.right.exact());
        else if constexpr (std::same_as<Step, RowCrossed<>>)
            winding[step.y].assign(step.winding.begin(), step.winding.end());
        else if constexpr (std::same_as<Step, PrimitiveSkipped<>>)
            skipped.push_back(step.why);
    }
};

using Corners = std::vector<std::pair<Number, Number>>;

Scene polygon_scene(const Corners& corners, Canvas canvas, Method method) {
    Scene scene;
    scene.canvas = canvas;
    scene.method = method;
    ScenePrimitive polygon{.kind = PrimitiveKind::polygon, .name = "p"};
    for (const auto& [x, y] : corners) {
        polygon.ring.push_back(scene.vertices.size());
        scene.vertices.push_back({"V" + std::to_string(scene.vertices.size()), x, y});
    }
    scene.primitives.push_back(polygon);
    return scene;
}

PolygonRecorder drawn(const Corners& corners, Canvas canvas, Method method) {
    PolygonRecorder recorder;
    draw_as_planned(polygon_scene(corners, canvas, method), recorder);
    return recorder;
}

std::set<Place> places(const PolygonRecorder& recorder) {
    std::set<Place> all;
    for (const auto& [place, times] : recorder.pixels)
        all.insert(place);
    return all;
}

constexpr Canvas big{.width = 40, .height = 40};
const Method exactly{.scalar = ScalarKind::exact};

/// Foley, van Dam, Feiner and Hughes 1990, figure 3.22: scan line 8 meets it at 2, 4.5, 8.5 and 13.
TEST(EdgeTable, HasTheCrossingsOfFoley) {
    const Corners corners{{2, 3}, {7, 1}, {13, 5}, {13, 11}, {7, 7}, {2, 9}};
    const auto recorder =
        drawn(corners, {.width = 16, .height = 13, .origin = Origin::bottom_left}, exactly);
    EXPECT_THAT(recorder.spans.at(8), ElementsAre(std::pair(Rational(2), Rational(9, 2)),
                                                  std::pair(Rational(17, 2), Rational(13))));
    EXPECT_THAT(recorder.winding.at(8), ElementsAre(1, 0, 1, 0));
    // ymin <= y < ymax in the scene's y: the row of the lower vertex is there, that of the upper one is not.
    EXPECT_EQ(recorder.spans.count(1), 1u);
    EXPECT_EQ(recorder.spans.count(11), 0u);
}

/// The edge table of an exercise, y up: DA and BA begin at y = 5, where they meet in A.
TEST(EdgeTable, HasTheRowsOfFoleyWithYUp) {
    const Corners corners{{3, 5}, {1, 7}, {1, 1}, {7, 6}};
    const Canvas canvas{.width = 10, .height = 10, .origin = Origin::bottom_left};
    const auto spans = drawn(corners, canvas, exactly).spans;
    const auto span = [](const Rational& left, const Rational& right) {
        return std::pair(left, right);
    };
    EXPECT_THAT(spans.at(1), ElementsAre(span(1, 1)));
    EXPECT_THAT(spans.at(4), ElementsAre(span(1, Rational(23, 5))));
    EXPECT_THAT(spans.at(5), ElementsAre(span(1, 3), span(3, Rational(29, 5))));
    EXPECT_THAT(spans.at(6), ElementsAre(span(1, 2)));
    EXPECT_EQ(spans.count(7), 0u);

    Method method = exactly;
    method.rows = RowRule::closed;
    const auto closed = drawn(corners, canvas, method).spans;
    EXPECT_THAT(closed.at(7), ElementsAre(span(1, 1)));
    EXPECT_THAT(closed.at(6), ElementsAre(span(1, 2), span(7, 7)));
}

/// Hearn and Baker's way: where the outline turns back, at D, F, B and E of figure 3.22, both edges count; where it goes
/// on, at A and C, one does.
TEST(EdgeTable, VerticesWhereTheOutlineTurnsBackCountTwice) {
    const Canvas canvas{.width = 16, .height = 13, .origin = Origin::bottom_left};
    Method method = exactly;
    method.polygon_vertices = PolygonVertices::turning;
    const auto span = [](int left, int right) {
        return std::pair(Rational(left), Rational(right));
    };
    const auto spans =
        drawn({{2, 3}, {7, 1}, {13, 5}, {13, 11}, {7, 7}, {2, 9}}, canvas, method).spans;
    EXPECT_THAT(spans.at(11), ElementsAre(span(13, 13)));
    EXPECT_THAT(spans.at(9), ElementsAre(span(2, 2), span(10, 13)));
    EXPECT_THAT(spans.at(7), ElementsAre(span(2, 7), span(7, 13)));
    EXPECT_THAT(spans.at(5), ElementsAre(span(2, 13)));
    EXPECT_THAT(spans.at(3), ElementsAre(span(2, 10)));
    EXPECT_THAT(spans.at(1), ElementsAre(span(7, 7)));
    // A horizontal edge has no rows: the neighbors behind it say whether the outline turns back.
    const auto step = drawn({{0, 0}, {6, 0}, {6, 3}, {3, 3}, {3, 6}, {0, 6}}, canvas, method).spans;
    EXPECT_THAT(step.at(2), ElementsAre(span(0, 6)));
    EXPECT_THAT(step.at(3), ElementsAre(span(0, 3)));
    EXPECT_THAT(step.at(6), ElementsAre(span(0, 3)));
}

/// The inside of the star's middle is run around twice.
TEST(EdgeTable, FillsAStarByBothRules) {
    const Corners star{{8, 14}, {13, 0}, {0, 9}, {16, 9}, {3, 0}};
    const Canvas canvas{.width = 17, .height = 15, .origin = Origin::bottom_left};
    Method method = exactly;
    const auto even_odd = drawn(star, canvas, method);
    method.fill_rule = FillRule::non_zero;
    const auto non_zero = drawn(star, canvas, method);
    EXPECT_THAT(even_odd.winding.at(6), ElementsAre(-1, -2, -1, 0));
    EXPECT_EQ(even_odd.pixels.count({8, 6}), 0u);
    EXPECT_EQ(non_zero.pixels.count({8, 6}), 1u);
    EXPECT_EQ(non_zero.spans.at(6).size(), 1u);
}

TEST(EdgeTable, SkipsWhatHasNoRows) {
    EXPECT_THAT(drawn({{0, 2}, {5, 2}, {3, 2}}, big, exactly).skipped,
                ElementsAre(SkipReason::zero_area));
    const Number third = number("1/3");
    const Number half = number("1/2");
    EXPECT_THAT(drawn({{0, third}, {5, half}, {3, third}}, big, exactly).skipped,
                ElementsAre(SkipReason::between_rows));
    EXPECT_THAT(drawn({{100, 0}, {105, 0}, {103, 4}}, big, exactly).skipped,
                ElementsAre(SkipReason::off_canvas));
}

/// Corners in eighths of a pixel, in part off the canvas; many on one row, or on one place.
Corners random_corners() {
    Corners corners;
    const int count = *rc::gen::inRange(3, 9);
    const int step = *rc::gen::element(1, 4, 8);
    for (int i = 0; i < count; ++i) {
        const auto coordinate = [step] {
            return number(std::to_string(*rc::gen::inRange(-200 / step, 200 / step) * step) + "/8");
        };
        const Number x = coordinate();
        corners.emplace_back(x, coordinate());
    }
    return corners;
}

Rational minus(const Number& a, const Number& b) {
    return a.exact() - b.exact();
}

/// How often the polygon runs around a point that lies at a y just above row `y`: the
/// edges of that row with the point on their right, by the sign of an area, counted by where they lead.
int winding_at(const Corners& corners, const Rational& x, int y) {
    int winding = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& [ax, ay] = corners[i];
        const auto& [bx, by] = corners[(i + 1) % corners.size()];
        const bool is_above_a = ay.exact() > y;
        const bool is_above_b = by.exact() > y;
        if (is_above_a == is_above_b)
            continue;
        // Twice the area of A, B and the point; y points up.
        const Rational area = minus(bx, ax) * (y - ay.exact()) - (x - ax.exact()) * minus(by, ay);
        const int turn = is_above_a ? 1 : -1;
        if (sgn(area) * -turn < 0)
            winding += turn;
    }
    return winding;
}

/// Where a row meets edges, without those that end on it.
std::vector<Rational> crossings_of(const Corners& corners, int y) {
    std::vector<Rational> all;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& [ax, ay] = corners[i];
        const auto& [bx, by] = corners[(i + 1) % corners.size()];
        if ((ay.exact() > y) != (by.exact() > y))
            all.push_back(ax.exact() + minus(bx, ax) * (y - ay.exact()) / minus(by, ay));
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// The pixels of a row whose square, [x, x + 1), meets the inside, or has a crossing in it.
std::set<Place> expected_row(const Corners& corners, int y, FillRule rule, const Canvas& canvas) {
    std::set<Place> expected;
    const auto crossings = crossings_of(corners, y);
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        const bool has_inside =
            i + 1 < crossings.size() && crossings[i] != crossings[i + 1] &&
            is_inside(winding_at(corners, (crossings[i] + crossings[i + 1]) / 2, y), rule);
        const Rational& last = has_inside ? crossings[i + 1] : crossings[i];
        for (Index x = floor_index(crossings[i]); x <= floor_index(last); ++x)
            if (x >= canvas.left() && x <= canvas.right())
                expected.insert({x, y});
    }
    return expected;
}

RC_GTEST_PROP(EdgeTable, DrawsWhatTheWindingNumbersSay, ()) {
    const Corners corners = random_corners();
    Method method = exactly;
    method.fill_rule = *rc::gen::element(FillRule::even_odd, FillRule::non_zero);
    const auto recorder = drawn(corners, big, method);
    std::set<Place> expected;
    for (int row = 0; row < big.height; ++row)
        expected.merge(expected_row(corners, big.y_of(row), method.fill_rule, big));
    RC_ASSERT(places(recorder) == expected);
}

RC_GTEST_PROP(EdgeTable, ARowMeetsAnEvenNumberOfEdgesWhereVerticesTurn, ()) {
    Method method = exactly;
    method.polygon_vertices = PolygonVertices::turning;
    const Corners corners = random_corners();
    for (const auto& [y, winding] : drawn(corners, big, method).winding)
        RC_ASSERT(winding.size() % 2 == 0U);
}

/// `closed` has the rows of the polygon, and those of the one that is upside down.
RC_GTEST_PROP(EdgeTable, ClosedRowsAreThoseOfBothWays, ()) {
    const Corners corners = random_corners();
    Method method = exactly;
    method.fill_rule = *rc::gen::element(FillRule::even_odd, FillRule::non_zero);
    method.rounding = *rc::gen::element(Rounding::floor, Rounding::inside);
    // Rows from -20 to 20.
    const Canvas canvas{.width = 40, .height = 41};
    const Canvas upside_down{.width = 40, .height = 41, .origin = Origin::top_left};
    auto expected = places(drawn(corners, canvas, method));
    Corners turned;
    for (const auto& [x, y] : corners)
        turned.emplace_back(Number::fraction(x.exact() + 20), Number::fraction(20 - y.exact()));
    for (const auto& [x, y] : places(drawn(turned, upside_down, method)))
        expected.insert({x - 20, 20 - y});
    method.rows = RowRule::closed;
    RC_ASSERT(places(drawn(corners, canvas, method)) == expected);
}

/// The first corner, the direction, and the kind of number make no difference to the picture.
RC_GTEST_PROP(EdgeTable, IsThePolygonAndNotItsList, ()) {
    Corners corners = random_corners();
    Method method = exactly;
    method.fill_rule = *rc::gen::element(FillRule::even_odd, FillRule::non_zero);
    method.rounding = *rc::gen::element(Rounding::floor, Rounding::inside, Rounding::half_open);
    method.rows = *rc::gen::element(RowRule::closed, RowRule::half_open);
    const Canvas canvas{
        .width = 40, .height = 40, .origin = *rc::gen::element(Origin::center, Origin::top_left)};
    const auto expected = places(drawn(corners, canvas, method));
    std::rotate(corners.begin(), corners.begin() + *rc::gen::inRange<long>(0, 3), corners.end());
    if (*rc::gen::arbitrary<bool>())
        std::reverse(corners.begin(), corners.end());
    method.scalar = *rc::gen::element(ScalarKind::exact, ScalarKind::adaptive, ScalarKind::fixed);
    RC_ASSERT(places(drawn(corners, canvas, method)) == expected);
}

/// Without the right ends, what two polygons share has one owner: none plots a pixel twice, and the
/// parts of a polygon that a chord cuts make the whole.
RC_GTEST_PROP(EdgeTable, IsTiledByItsParts, ()) {
    // Around the middle, so that every chord lies inside; corners on one row are likely.
    Corners corners;
    for (const auto& [dx, dy] :
         {std::pair(1, 0), {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}) {
        const int far = *rc::gen::inRange(1, 15);
        corners.emplace_back(dx * far, dy * far);
    }
    Method method = exactly;
    method.rounding = Rounding::half_open;
    const auto whole = drawn(corners, big, method);
    std::map<Place, int> parts;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (const auto& [place, times] :
             drawn({{0, 0}, corners[i], corners[(i + 1) % corners.size()]}, big, method).pixels)
            parts[place] += times;
    RC_ASSERT(whole.pixels == parts);
    RC_ASSERT(std::all_of(whole.pixels.begin(), whole.pixels.end(),
                          [](const auto& pixel) { return pixel.second == 1; }));
}

/// A triangle has the rows of the scanline fill, but for the last one.
RC_GTEST_PROP(EdgeTable, OfATriangleHasTheRowsOfScanline, ()) {
    Corners corners = random_corners();
    corners.resize(3);
    Method method = exactly;
    method.lerp = *rc::gen::element(LerpForm::direct, LerpForm::incremental);
    const auto polygon = drawn(corners, big, method);
    Scene scene = polygon_scene(corners, big, method);
    scene.primitives = {{.kind = PrimitiveKind::triangle, .name = "t", .vertices = {0, 1, 2}}};
    PolygonRecorder triangle;
    draw_as_planned(scene, triangle);
    for (const auto& [y, spans] : polygon.spans)
        RC_ASSERT(triangle.spans.at(y) == spans);
    RC_ASSERT(triangle.spans.size() <= polygon.spans.size() + 1);
}

/// What clipping leaves of a polygon is one part, and is drawn as the polygon with its corners.
RC_GTEST_PROP(EdgeTable, IsClippedToOnePart, ()) {
    Method method = exactly;
    Scene scene = polygon_scene(random_corners(), big, method);
    for (SceneVertex& vertex : scene.vertices)
        vertex.z = -*rc::gen::inRange(-4, 20);
    scene.projection = {.type = ProjectionType::frustum, .fov_y = 90, .near = 1, .far = 30};
    Corners told;
    PolygonRecorder recorder;
    int parts = 0;
    draw_as_planned(scene, [&]<typename Step>(const Step& step) {
        recorder(step);
        if constexpr (std::same_as<Step, PrimitiveBegan<>>) {
            parts += step.at ? 1 : 0;
            for (const auto& at : step.at.value_or(std::span<const Vec<Quantity, 2>>()))
                told.emplace_back(Number::fraction(at.x.exact()), Number::fraction(at.y.exact()));
        }
    });
    RC_ASSERT(parts <= 1);
    RC_CLASSIFY(parts == 1);
    if (parts == 1)
        RC_ASSERT(places(drawn(told, big, method)) == places(recorder));
}

/// The normal of a concave face is that of its area, whatever its first three corners say.
TEST(EdgeTable, CullsAConcaveFaceByItsArea) {
    // Counter-clockwise; the turn at the second corner is the other way.
    Scene scene = polygon_scene({{0, 4}, {-1, 1}, {-6, 0}, {6, 0}}, big, exactly);
    scene.method.cull = Cull::back;
    PolygonRecorder recorder;
    std::vector<bool> culled;
    std::vector<Rational> normals;
    draw_as_planned(scene, [&]<typename Step>(const Step& step) {
        recorder(step);
        if constexpr (std::same_as<Step, FaceTested<>>) {
            culled.push_back(step.culled);
            normals.push_back(step.normal.z.exact());
        }
    });
    EXPECT_THAT(culled, ElementsAre(false));
    // Shoelace: (0*1 + 1*4) + (0 + 6) + 0 + (24 - 0) = 34, twice the area.
    EXPECT_THAT(normals, ElementsAre(Rational(34)));
    EXPECT_FALSE(recorder.pixels.empty());
}

} // namespace
} // namespace rastertrace
