// SPDX-License-Identifier: MIT
// What a drawing is in pixels. White is the paper, black what the shapes are painted in.

#include "colors.h"

#include <rastertrace/figures/bitmap.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

/// What true edges and vertices are painted in.
const Color ink = paint_of(Role::true_edge, Theme::light).color;

/// Rows of text: `#` what shapes are painted in, `.` white, `r` red, `+` what lies between.
std::string picture_of(const Bitmap& bitmap, Color painted = black) {
    std::string text;
    for (std::size_t y = 0; y < bitmap.height; ++y) {
        for (std::size_t x = 0; x < bitmap.width; ++x) {
            const Color color = bitmap.at(x, y);
            text += color == painted ? '#' : color == white ? '.' : color == red ? 'r' : '+';
        }
        text += '\n';
    }
    return text;
}

std::string picture_of(const Drawing& drawing, double scale = 1, Color painted = black) {
    return picture_of(bitmap_of(drawing, Theme::light, scale), painted);
}

/// The same of lines of a role.
std::string picture_of(const Drawing& drawing, Role role) {
    return picture_of(drawing, 1, paint_of(role, Theme::light).color);
}

Drawing sheet(double width, double height, std::vector<Shape> shapes) {
    return {.width = width, .height = height, .title = "A test", .shapes = std::move(shapes)};
}

Areas areas(std::vector<Rectangle> rectangles, Color color = black) {
    return {.color = color, .rectangles = std::move(rectangles)};
}

/// How much of a pixel is ink, 0 to 1.
double coverage_at(const Bitmap& bitmap, std::size_t x, std::size_t y) {
    return (255.0 - bitmap.at(x, y).red()) / (255.0 - ink.red());
}

double covered(const Bitmap& bitmap) {
    double sum = 0;
    for (std::size_t y = 0; y < bitmap.height; ++y)
        for (std::size_t x = 0; x < bitmap.width; ++x)
            sum += coverage_at(bitmap, x, y);
    return sum;
}

TEST(Bitmap, HasThePaperWhereNothingIs) {
    EXPECT_EQ(picture_of(sheet(3, 2, {})), "...\n"
                                           "...\n");
    EXPECT_EQ(bitmap_of(sheet(3, 2, {}), Theme::dark, 1).at(1, 1),
              paint_of(Role::paper, Theme::dark).color);
}

TEST(Bitmap, TakesAsManyPixelsAsTheScaleSaysAndOneForTheRest) {
    for (const double scale : {0.5, 1.0, 1.5, 2.0, 3.0}) {
        const Bitmap bitmap = bitmap_of(sheet(5, 3, {}), Theme::light, scale);
        EXPECT_EQ(bitmap.width, static_cast<std::size_t>(std::ceil(5 * scale)));
        EXPECT_EQ(bitmap.height, static_cast<std::size_t>(std::ceil(3 * scale)));
    }
    EXPECT_EQ(bitmap_of(sheet(0, 0, {}), Theme::light, 1).colors.size(), 1U);
}

TEST(Bitmap, SaysWhyADrawingIsTooLarge) {
    EXPECT_EQ(too_large_for_bitmap(sheet(10'000, 10'000, {}), 1), std::nullopt);
    const auto problem = too_large_for_bitmap(sheet(10'000, 10'001, {}), 1);
    ASSERT_TRUE(problem);
    EXPECT_EQ(to_text(*problem),
              "expected at most 100000000 pixels in a picture, found 10000 x 10001\n"
              "hint: a smaller --scale makes it smaller; --region takes a part of it");
    EXPECT_TRUE(too_large_for_bitmap(sheet(1e300, 1e300, {}), 1));
}

TEST(Bitmap, AreasOnWholePixelsAreSharp) {
    const Drawing drawing = sheet(6, 4, {areas({{{1, 1}, 2, 2}, {{4, 0}, 1, 4}})});
    EXPECT_EQ(picture_of(drawing), "....#.\n"
                                   ".##.#.\n"
                                   ".##.#.\n"
                                   "....#.\n");
    EXPECT_EQ(picture_of(drawing, 2), "........##..\n"
                                      "........##..\n"
                                      "..####..##..\n"
                                      "..####..##..\n"
                                      "..####..##..\n"
                                      "..####..##..\n"
                                      "........##..\n"
                                      "........##..\n");
}

TEST(Bitmap, AreasEndOnTheNearestPixelAndDoNotVanish) {
    EXPECT_EQ(picture_of(sheet(6, 2, {areas({{{0.4, 0}, 2.2, 1.4}, {{4.2, 1.1}, 0.1, 0.1}})})),
              "###...\n"
              "....#.\n");
}

TEST(Bitmap, AreasSideBySideHaveNoSeam) {
    std::vector<Rectangle> columns;
    for (int i = 0; i < 10; ++i)
        columns.push_back({{i * 0.7, 0}, 0.7, 1});
    EXPECT_EQ(picture_of(sheet(7, 1, {areas(columns)}), 2.3), std::string(16, '#') + ".\n" +
                                                                  std::string(16, '#') + ".\n" +
                                                                  std::string(17, '.') + "\n");
}

TEST(Bitmap, PixelsHaveTheirColorsAndLeaveThePaper) {
    const Pixels pixels{.corner = {1, 0},
                        .side = 2,
                        .columns = 3,
                        .colors = {black, no_color, red, red, red, no_color}};
    EXPECT_EQ(picture_of(sheet(8, 5, {pixels})), ".##..rr.\n"
                                                 ".##..rr.\n"
                                                 ".rrrr...\n"
                                                 ".rrrr...\n"
                                                 "........\n");
}

TEST(Bitmap, ShapesCoverThoseBeforeThem) {
    EXPECT_EQ(picture_of(sheet(3, 1, {areas({{{0, 0}, 2, 1}}), areas({{{1, 0}, 2, 1}}, red)})),
              "#rr\n");
}

TEST(Bitmap, TranslucentColorsAreMixedOnceEvenWhereRectanglesOverlap) {
    const Color half{0, 0, 0, 51}; // a fifth
    const Bitmap bitmap =
        bitmap_of(sheet(3, 1, {areas({{{0, 0}, 2, 1}, {{1, 0}, 2, 1}}, half)}), Theme::light, 1);
    for (std::size_t x = 0; x < 3; ++x)
        EXPECT_EQ(bitmap.at(x, 0), Color(204, 204, 204));
}

/// A place is on a line of a width, its ends cut off straight, its corners round.
bool is_on(const Path& path, bool is_closed, double width, Place place) {
    const std::size_t pieces = path.size() - (is_closed ? 0 : 1);
    for (std::size_t i = 0; i < pieces; ++i) {
        const Place a = path[i];
        const Place b = path[(i + 1) % path.size()];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const double along =
            ((place.x - a.x) * (b.x - a.x) + (place.y - a.y) * (b.y - a.y)) / length;
        const double across =
            ((place.x - a.x) * (b.y - a.y) - (place.y - a.y) * (b.x - a.x)) / length;
        if (0 <= along && along <= length && std::abs(across) <= width / 2)
            return true;
        const bool is_corner = i + 1 < pieces || is_closed;
        if (is_corner && std::hypot(place.x - b.x, place.y - b.y) <= width / 2)
            return true;
    }
    return false;
}

/// What 32 x 32 samples say that a shape covers of a pixel.
template <typename IsOn>
double sampled(std::size_t x, std::size_t y, double scale, const IsOn& is_on_shape) {
    constexpr int samples = 32;
    int hits = 0;
    for (int i = 0; i < samples; ++i)
        for (int k = 0; k < samples; ++k) {
            const double px = static_cast<double>(x) + (i + 0.5) / samples;
            const double py = static_cast<double>(y) + (k + 0.5) / samples;
            hits += is_on_shape(Place{px / scale, py / scale}) ? 1 : 0;
        }
    return static_cast<double>(hits) / (samples * samples);
}

/// Coverage is told in eighths; 16 lines of samples in a pixel and 32 of the reference add the rest.
constexpr double tolerance = 1.0 / 16 + 1.0 / 16;

template <typename IsOn>
void expect_covers(const Drawing& drawing, double scale, const IsOn& is_on_shape) {
    const Bitmap bitmap = bitmap_of(drawing, Theme::light, scale);
    for (std::size_t y = 0; y < bitmap.height; ++y)
        for (std::size_t x = 0; x < bitmap.width; ++x)
            ASSERT_NEAR(coverage_at(bitmap, x, y), sampled(x, y, scale, is_on_shape), tolerance)
                << "at " << x << ", " << y;
}

TEST(Bitmap, LinesOfAllSlopesCoverWhatSamplesSay) {
    const double width = paint_of(Role::true_edge, Theme::light).width;
    for (const Place end : {Place{22, 3}, Place{20, 21}, Place{12, 22.5}, Place{3.2, 1.1},
                            Place{22, 11.5}, Place{11.5, 22}, Place{1.5, 20}})
        for (const double scale : {0.5, 1.0, 2.5}) {
            const Path path{{11.5, 11.5}, end};
            SCOPED_TRACE(testing::Message() << end.x << ", " << end.y << " at " << scale);
            expect_covers(sheet(24, 24, {Lines{.role = Role::true_edge, .paths = {path}}}), scale,
                          [&](Place place) { return is_on(path, false, width, place); });
        }
}

TEST(Bitmap, CornersAreRoundAndCoveredOnce) {
    const double width = paint_of(Role::true_edge, Theme::light).width;
    for (const bool is_closed : {false, true}) {
        const Path path{{3, 3}, {20, 5}, {4, 8}, {18, 20}, {17, 12}};
        expect_covers(
            sheet(24, 24,
                  {Lines{.role = Role::true_edge, .paths = {path}, .are_closed = is_closed}}),
            2, [&](Place place) { return is_on(path, is_closed, width, place); });
    }
}

TEST(Bitmap, LinesThatCrossInTranslucentColorsAreMixedOnce) {
    ASSERT_EQ(paint_of(Role::inside, Theme::light).color, Color(0x1f, 0x7f, 0xbf, 70));
    const Bitmap bitmap = bitmap_of(
        sheet(20, 20,
              {Lines{.role = Role::inside, .paths = {{{0, 0}, {20, 20}}, {{0, 20}, {20, 0}}}}}),
        Theme::light, 4);
    EXPECT_EQ(bitmap.at(40, 40), Color(194, 220, 237));
    EXPECT_EQ(bitmap.at(20, 20), Color(194, 220, 237));
}

TEST(Bitmap, DashesAreDrawnAndLeftOutByTurns) {
    // 4 drawn, 3 left out; the line is one pixel wide.
    const auto dashed = [](Path path) {
        return Lines{.role = Role::other_edge, .paths = {std::move(path)}};
    };
    EXPECT_EQ(picture_of(sheet(20, 3, {dashed({{0, 1.5}, {20, 1.5}})}), Role::other_edge),
              "....................\n"
              "####...####...####..\n"
              "....................\n");
    // A dash goes on around a corner, and what lies outside of the sheet counts.
    EXPECT_EQ(
        picture_of(sheet(4, 6, {dashed({{-7, 0.5}, {2.5, 0.5}, {2.5, 20}})}), Role::other_edge),
        "###.\n"
        "..#.\n"
        "....\n"
        "....\n"
        "....\n"
        "..#.\n");
}

TEST(Bitmap, DashesOfALineThatComesFromFarAwayAreThoseOfTheWholeLine) {
    const Drawing near =
        sheet(30, 1, {Lines{.role = Role::other_edge, .paths = {{{-70, 0.5}, {100, 0.5}}}}});
    const Drawing far =
        sheet(30, 1, {Lines{.role = Role::other_edge, .paths = {{{-700'000, 0.5}, {1e6, 0.5}}}}});
    EXPECT_EQ(picture_of(near), picture_of(far));
}

TEST(Bitmap, GridsAreOneSharpPixelEvenAtTheSheetsBorder) {
    // A line of 0.6 pixels is a pixel of six tenths of its color, also where two cross.
    const Lines grid{
        .role = Role::grid,
        .paths = {{{0, 0}, {0, 5}}, {{3, 0}, {3, 5}}, {{5, 0}, {5, 5}}, {{0, 2}, {5, 2}}}};
    ASSERT_EQ(paint_of(Role::grid, Theme::light).color, Color(0xb9, 0xbe, 0xc5));
    const Bitmap bitmap = bitmap_of(sheet(5, 5, {grid}), Theme::light, 1);
    EXPECT_EQ(picture_of(bitmap), "+..++\n"
                                  "+..++\n"
                                  "+++++\n"
                                  "+..++\n"
                                  "+..++\n");
    EXPECT_EQ(bitmap.at(0, 0), Color(213, 216, 220));
    EXPECT_EQ(bitmap.at(3, 2), Color(213, 216, 220));
}

TEST(Bitmap, ABorderIsClosed) {
    const Lines border{
        .role = Role::border, .paths = {{{1, 1}, {5, 1}, {5, 4}, {1, 4}}}, .are_closed = true};
    EXPECT_EQ(picture_of(sheet(7, 6, {border}), Role::border), ".......\n"
                                                               ".#####.\n"
                                                               ".#...#.\n"
                                                               ".#...#.\n"
                                                               ".#####.\n"
                                                               ".......\n");
}

TEST(Bitmap, PolygonsCoverWhatSamplesSay) {
    const Path triangle{{2.3, 1.7}, {21.9, 9.2}, {5.5, 22.1}};
    for (const double scale : {0.5, 1.0, 2.0})
        expect_covers(sheet(24, 24, {Polygons{.role = Role::vertex, .paths = {triangle}}}), scale,
                      [&](Place place) {
                          bool is_inside = true;
                          for (std::size_t i = 0; i < 3; ++i) {
                              const Place a = triangle[i];
                              const Place b = triangle[(i + 1) % 3];
                              is_inside = is_inside && (b.x - a.x) * (place.y - a.y) -
                                                               (b.y - a.y) * (place.x - a.x) >=
                                                           0;
                          }
                          return is_inside;
                      });
}

TEST(Bitmap, PolygonsThatShareAnEdgeCoverAllOfIt) {
    const Path left{{0, 0}, {7, 0}, {3, 10}, {0, 10}};
    const Path right{{7, 0}, {10, 0}, {10, 10}, {3, 10}};
    EXPECT_EQ(
        covered(bitmap_of(sheet(10, 10, {Polygons{.role = Role::vertex, .paths = {left, right}}}),
                          Theme::light, 1)),
        100);
}

TEST(Bitmap, DotsAreDiscs) {
    for (const double radius : {0.7, 2.0, 9.0, 40.0}) {
        const Drawing drawing =
            sheet(100, 100, {Dots{.role = Role::vertex, .radius = radius, .centers = {{50, 50}}}});
        const Bitmap bitmap = bitmap_of(drawing, Theme::light, 1);
        EXPECT_NEAR(covered(bitmap), std::numbers::pi * radius * radius,
                    0.03 * std::numbers::pi * radius * radius + 0.25);
        expect_covers(drawing, 1, [radius](Place place) {
            return std::hypot(place.x - 50, place.y - 50) <= radius;
        });
    }
}

TEST(Bitmap, IsTheSameEachTime) {
    const Drawing drawing = sheet(
        60, 40,
        {Lines{.role = Role::curve_8, .paths = {{{1, 2}, {30, 37}, {59, 3}}}, .are_closed = true},
         Label{.at = {3, 20}, .text = "twice", .size = 13, .has_rim = true}});
    EXPECT_EQ(bitmap_of(drawing, Theme::dark, 1.7).colors,
              bitmap_of(drawing, Theme::dark, 1.7).colors);
}

TEST(Bitmap, AutomaticIsLight) {
    const Drawing drawing = sheet(9, 9, {areas({{{1, 1}, 3, 3}}), Dots{.centers = {{6, 6}}}});
    EXPECT_EQ(bitmap_of(drawing, Theme::automatic, 1).colors,
              bitmap_of(drawing, Theme::light, 1).colors);
}

rc::Gen<double> coordinate() {
    return rc::gen::map(
        rc::gen::pair(rc::gen::inRange(-1'000'000, 1'000'000), rc::gen::inRange(0, 4)),
        [](const std::pair<int, int>& one) {
            constexpr double factors[] = {1, 1e-3, 1e-5, 0}; // NOLINT: four numbers
            return one.first * factors[one.second];
        });
}

rc::Gen<Place> random_place() {
    return rc::gen::map(rc::gen::pair(coordinate(), coordinate()),
                        [](const std::pair<double, double>& one) {
                            return Place{one.first, one.second};
                        });
}

rc::Gen<std::vector<Path>> random_paths() {
    return rc::gen::container<std::vector<Path>>(rc::gen::container<Path>(random_place()));
}

rc::Gen<Role> random_role() {
    return rc::gen::map(rc::gen::inRange<std::size_t>(0, roles().size()),
                        [](std::size_t i) { return roles()[i]; });
}

Shape random_shape() {
    const Role role = *random_role();
    switch (*rc::gen::inRange(0, 6)) {
    case 0: {
        Areas areas{.role = role};
        for (const Path& path : *random_paths())
            for (const Place& place : path)
                areas.rectangles.push_back({place, *coordinate(), *coordinate()});
        return areas;
    }
    case 1:
        return Lines{
            .role = role, .paths = *random_paths(), .are_closed = *rc::gen::arbitrary<bool>()};
    case 2:
        return Polygons{.role = role, .paths = *random_paths()};
    case 3:
        return Dots{.role = role,
                    .radius = *coordinate(),
                    .centers = *rc::gen::container<std::vector<Place>>(random_place())};
    case 4:
        return Pixels{.corner = *random_place(),
                      .side = *coordinate(),
                      .columns = *rc::gen::inRange<std::size_t>(0, 4),
                      .colors = std::vector<Color>(*rc::gen::inRange<std::size_t>(0, 13), red)};
    default:
        return Label{.role = role,
                     .at = *random_place(),
                     .text = *rc::gen::arbitrary<std::string>(),
                     .size = *coordinate(),
                     .anchor = *rc::gen::element(Anchor::start, Anchor::middle, Anchor::end),
                     .is_bold = *rc::gen::arbitrary<bool>(),
                     .is_fixed_width = *rc::gen::arbitrary<bool>(),
                     .is_turned = *rc::gen::arbitrary<bool>(),
                     .has_rim = *rc::gen::arbitrary<bool>()};
    }
}

// Far outside, without size, empty: all has a picture, opaque and the same each time.
RC_GTEST_PROP(Bitmap, AnyDrawingHasOne, ()) {
    Drawing drawing{.width = *rc::gen::inRange(0, 50) * 1.0,
                    .height = *rc::gen::inRange(0, 50) * 1.0,
                    .title = "random"};
    const int count = *rc::gen::inRange(0, 5);
    for (int i = 0; i < count; ++i)
        drawing.shapes.push_back(random_shape());
    const double scale = *rc::gen::element(0.5, 1.0, 2.0, 3.0);
    const Bitmap bitmap = bitmap_of(drawing, Theme::light, scale);
    RC_ASSERT(bitmap.colors.size() == bitmap.width * bitmap.height);
    RC_ASSERT(std::all_of(bitmap.colors.begin(), bitmap.colors.end(),
                          [](Color color) { return color.alpha() == 255; }));
    RC_ASSERT(bitmap.colors == bitmap_of(drawing, Theme::light, scale).colors);
}

} // namespace
} // namespace rastertrace
