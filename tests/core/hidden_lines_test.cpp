// SPDX-License-Identifier: MIT
// Hidden lines: what may be seen of points, lines and outlines, against statements of their own.

#include "picture.h"
#include "random_choice.h"
#include "random_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

const Color red{255, 0, 0};
const Color green{0, 255, 0};
const Color blue{0, 0, 255};

/// A solid: its corners, and its faces, counter-clockwise seen from outside.
struct Solid {
    std::string name;
    std::vector<std::array<int, 3>> corners;
    std::vector<std::vector<std::size_t>> faces;
};

const Solid cube{
    "cube",
    {{-1, -1, -1},
     {1, -1, -1},
     {1, 1, -1},
     {-1, 1, -1},
     {-1, -1, 1},
     {1, -1, 1},
     {1, 1, 1},
     {-1, 1, 1}},
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 7, 3}, {1, 2, 6, 5}}};
const Solid tetrahedron{"tetrahedron",
                        {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                        {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
const Solid octahedron{
    "octahedron",
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};

/// How far a place lies before the plane of a face, in volumes: above 0 if the face is turned to it.
int before_face(const Solid& solid, const std::vector<std::size_t>& face,
                const std::array<int, 3>& eye) {
    std::array<std::array<int, 3>, 3> to{};
    const std::array<int, 3>& corner = solid.corners[face[0]];
    for (std::size_t i = 0; i < 3; ++i) {
        to[0][i] = solid.corners[face[1]][i] - corner[i];
        to[1][i] = solid.corners[face[2]][i] - corner[i];
        to[2][i] = eye[i] - corner[i];
    }
    const auto& [a, b, e] = to;
    return (a[1] * b[2] - a[2] * b[1]) * e[0] + (a[2] * b[0] - a[0] * b[2]) * e[1] +
           (a[0] * b[1] - a[1] * b[0]) * e[2];
}

/// Hidden lines of a solid, as a mesh says it: faces that only hide, and each side once. True in the map: a
/// side with a face that is turned to the eye.
struct Wireframe {
    Scene scene;
    std::size_t first_side = 0;
    std::vector<bool> has_front;
};
Wireframe wireframe_of(const Solid& solid, const std::array<int, 3>& eye, const Method& method) {
    Wireframe result;
    Scene& scene = result.scene;
    scene.canvas = {.width = 64, .height = 64};
    scene.camera = Camera{{eye[0], eye[1], eye[2]}, {0, 0, 0}, {0, 1, 0}};
    scene.projection = {.type = ProjectionType::frustum,
                        .fov_y = number("50"),
                        .near = number("0.1"),
                        .far = number("100")};
    scene.viewport.type = ViewportType::pixels;
    scene.method = method;
    for (std::size_t i = 0; i < solid.corners.size(); ++i) {
        const auto& [x, y, z] = solid.corners[i];
        scene.vertices.push_back({std::string(1, static_cast<char>('A' + i)), x, y, {}, z});
    }
    std::map<std::pair<std::size_t, std::size_t>, bool> sides;
    std::uint32_t polygon = 0;
    for (const auto& face : solid.faces) {
        polygon += 1;
        for (std::size_t i = 2; i < face.size(); ++i)
            scene.primitives.push_back({.is_painted = false,
                                        .name = "face",
                                        .vertices = {face[0], face[i - 1], face[i]},
                                        .polygon = polygon});
        const bool is_front = before_face(solid, face, eye) > 0;
        for (std::size_t i = 0; i < face.size(); ++i) {
            const auto side = std::minmax(face[i], face[(i + 1) % face.size()]);
            sides[{side.first, side.second}] = sides[{side.first, side.second}] || is_front;
        }
    }
    result.first_side = scene.primitives.size();
    for (const auto& [ends, has_front] : sides) {
        scene.primitives.push_back({.kind = PrimitiveKind::line,
                                    .is_side = true,
                                    .name = "side",
                                    .vertices = {ends.first, ends.second}});
        result.has_front.push_back(has_front);
    }
    return result;
}

using Pixels = std::set<std::pair<int, int>>;

/// The pixels that each primitive of a scene was asked to draw, and those that it drew.
struct LineSink {
    std::vector<Pixels> asked;
    std::vector<Pixels> drawn;

    void operator()(const PrimitiveBegan<>&) {
        asked.emplace_back();
        drawn.emplace_back();
    }
    void operator()(const DepthTested<>& step) { asked.back().emplace(step.x, step.y); }
    void operator()(const PixelPlotted<>& step) {
        asked.back().emplace(step.x, step.y);
        drawn.back().emplace(step.x, step.y);
    }
};

/// From a direction that sees no face edge-on.
std::array<int, 3> any_eye(Random& random, const Solid& solid) {
    for (;;) {
        const std::array<int, 3> eye{random.whole(-9, 9), random.whole(-9, 9), random.whole(-9, 9)};
        const bool is_far = eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2] > 12;
        const bool sees_all =
            std::all_of(solid.faces.begin(), solid.faces.end(),
                        [&](const auto& face) { return before_face(solid, face, eye) != 0; });
        if (is_far && sees_all && (eye[0] != 0 || eye[2] != 0))
            return eye;
    }
}

/// T1's title: a convex solid shows the sides of its front faces, each without a gap, and no other.
void expect_front_sides(const Solid& solid, const Method& method, int directions) {
    Random random(17);
    for (int i = 0; i < directions; ++i) {
        const auto eye = any_eye(random, solid);
        const Wireframe wireframe = wireframe_of(solid, eye, method);
        LineSink sink;
        const Image picture = draw_as_planned(wireframe.scene, sink);
        const std::string about = solid.name + " from " + std::to_string(eye[0]) + " " +
                                  std::to_string(eye[1]) + " " + std::to_string(eye[2]) + "\n" +
                                  picture_of(picture);
        Pixels of_front_sides;
        for (std::size_t side = 0; side < wireframe.has_front.size(); ++side) {
            const std::size_t line = wireframe.first_side + side;
            if (!wireframe.has_front[side])
                continue;
            of_front_sides.insert(sink.asked[line].begin(), sink.asked[line].end());
            for (const auto& [x, y] : sink.asked[line])
                ASSERT_NE(picture.at({x, y}), no_color)
                    << "a gap at " << x << ", " << y << ": " << about;
        }
        for (std::size_t side = 0; side < wireframe.has_front.size(); ++side)
            if (!wireframe.has_front[side]) {
                const Pixels& drawn = sink.drawn[wireframe.first_side + side];
                const bool is_hidden =
                    std::all_of(drawn.begin(), drawn.end(),
                                [&](const auto& pixel) { return of_front_sides.count(pixel) > 0; });
                ASSERT_TRUE(is_hidden) << "side " << side << " shows through: " << about;
            }
    }
}

TEST(HiddenLines, OfAConvexSolidAreThoseWithoutAFrontFace) {
    for (const Solid& solid : {cube, tetrahedron, octahedron}) {
        expect_front_sides(solid, {.cull = Cull::back}, 1'000);
        expect_front_sides(
            solid, {.line = LineMethod::dda, .fill = Fill::top_left, .cull = Cull::back}, 300);
        expect_front_sides(solid, {.scalar = ScalarKind::adaptive, .cull = Cull::back}, 60);
        expect_front_sides(solid, {.scalar = ScalarKind::fixed, .cull = Cull::back}, 60);
    }
    expect_front_sides(cube, {.scalar = ScalarKind::exact, .cull = Cull::back}, 5);
}

TEST(HiddenLines, AreHiddenByTheFacesThemselvesIfNoneIsCulled) {
    // What is left over is a pixel where a side leaves the silhouette.
    Random random(5);
    int left_over = 0;
    for (int i = 0; i < 300; ++i) {
        const auto eye = any_eye(random, cube);
        const Wireframe wireframe = wireframe_of(cube, eye, {});
        LineSink sink;
        draw_as_planned(wireframe.scene, sink);
        Pixels of_front_sides;
        for (std::size_t side = 0; side < wireframe.has_front.size(); ++side)
            if (wireframe.has_front[side]) {
                const Pixels& asked = sink.asked[wireframe.first_side + side];
                of_front_sides.insert(asked.begin(), asked.end());
            }
        for (std::size_t side = 0; side < wireframe.has_front.size(); ++side)
            for (const auto& pixel : sink.drawn[wireframe.first_side + side])
                left_over += of_front_sides.count(pixel) == 0 ? 1 : 0;
    }
    EXPECT_LE(left_over, 15) << "of 300 pictures";
}

/// Corners with a depth each, x y z, in the coordinates of the screen.
using Places = std::vector<std::array<std::string, 3>>;

/// A scene without a projection, z the distance from the eye.
class FlatScene {
public:
    explicit FlatScene(Method method) {
        scene.canvas = {.width = 24, .height = 24, .origin = Origin::top_left};
        scene.method = method;
        scene.method.depth = Depth::linear_z;
    }

    void add(PrimitiveKind kind, const Places& places, Color color) {
        ScenePrimitive primitive{.kind = kind, .name = std::to_string(scene.primitives.size())};
        primitive.color = color;
        for (std::size_t i = 0; i < places.size(); ++i) {
            primitive.vertices[i] = scene.vertices.size();
            const auto& [x, y, z] = places[i];
            scene.vertices.push_back({primitive.name + std::string(1, static_cast<char>('a' + i)),
                                      number(x),
                                      number(y),
                                      {},
                                      number(z)});
        }
        scene.primitives.push_back(primitive);
    }

    Scene scene;
};

const Places big_face{{"0", "0", "5"}, {"30", "0", "5"}, {"0", "30", "5"}};

TEST(HiddenLines, OfEqualsTheThinnerOnePasses) {
    for (const ScalarKind scalar : {ScalarKind::double_precision, ScalarKind::adaptive,
                                    ScalarKind::exact, ScalarKind::fixed}) {
        // Whatever comes first.
        for (const bool thin_first : {false, true}) {
            FlatScene flat({.scalar = scalar});
            const auto add_thin = [&flat] {
                flat.add(PrimitiveKind::line, {{"2", "3", "5"}, {"9", "3", "5"}}, green);
                flat.add(PrimitiveKind::point, {{"4", "3", "5"}}, blue);
            };
            if (thin_first)
                add_thin();
            flat.add(PrimitiveKind::triangle, big_face, red);
            if (!thin_first)
                add_thin();
            const Image picture = draw_as_planned(flat.scene);
            EXPECT_EQ(picture.at({3, 3}), green);
            EXPECT_EQ(picture.at({4, 3}), blue);
            EXPECT_EQ(picture.at({10, 3}), red);
        }
        // Of lines the first one stays.
        FlatScene lines({.scalar = scalar});
        lines.add(PrimitiveKind::triangle, big_face, red);
        lines.add(PrimitiveKind::line, {{"2", "3", "5"}, {"9", "3", "5"}}, green);
        lines.add(PrimitiveKind::line, {{"5", "1", "5"}, {"5", "9", "5"}}, blue);
        const Image picture = draw_as_planned(lines.scene);
        EXPECT_EQ(picture.at({5, 3}), green);
        EXPECT_EQ(picture.at({5, 4}), blue);
    }
}

TEST(HiddenLines, MeetTheDepthBufferWithoutAnyFace) {
    // AB at z = 2 lies before CD at z = 9; a point before both, and the sides of a triangle behind all.
    for (const ScalarKind scalar :
         {ScalarKind::double_precision, ScalarKind::adaptive, ScalarKind::exact, ScalarKind::fixed})
        for (const bool nearest_first : {false, true}) {
            FlatScene flat({.scalar = scalar});
            const auto add = [&flat](int number) {
                if (number == 0)
                    flat.add(PrimitiveKind::point, {{"5", "3", "1"}}, green);
                if (number == 1)
                    flat.add(PrimitiveKind::line, {{"0", "3", "2"}, {"10", "3", "2"}}, red);
                if (number == 2)
                    flat.add(PrimitiveKind::line, {{"5", "0", "9"}, {"5", "6", "9"}}, blue);
                if (number == 3)
                    flat.add(PrimitiveKind::outline,
                             {{"2", "3", "20"}, {"8", "3", "20"}, {"5", "9", "20"}},
                             Color{9, 9, 9});
            };
            for (int i = 0; i < 4; ++i)
                add(nearest_first ? i : 3 - i);
            const Image picture = draw_as_planned(flat.scene);
            EXPECT_EQ(picture.at({5, 3}), green);
            EXPECT_EQ(picture.at({4, 3}), red);
            EXPECT_EQ(picture.at({8, 3}), red);
            EXPECT_EQ(picture.at({5, 4}), blue);
            EXPECT_EQ(picture.at({5, 9}), (Color{9, 9, 9}));
        }
}

TEST(HiddenLines, TheirPixelsAreTheSameInAnyOrder) {
    Random random(23);
    for (int i = 0; i < 300; ++i) {
        FlatScene flat({.scalar = random.pick({ScalarKind::double_precision, ScalarKind::adaptive,
                                               ScalarKind::exact, ScalarKind::fixed}),
                        .fill = random.pick({Fill::scanline, Fill::top_left, Fill::barycentric})});
        const auto coordinate = [&] { return std::to_string(random.whole(-8, 5 * 30)) + "/5"; };
        const auto place = [&]() -> std::array<std::string, 3> {
            return {coordinate(), coordinate(), std::to_string(random.whole(1, 9))};
        };
        for (int face = random.whole(1, 4); face > 0; --face)
            flat.add(PrimitiveKind::triangle, {place(), place(), place()}, red);
        const auto first = static_cast<std::ptrdiff_t>(flat.scene.primitives.size());
        for (int thin = random.whole(2, 5); thin > 0; --thin) {
            if (random.chance(4))
                flat.add(PrimitiveKind::point, {place()}, green);
            else if (random.chance(4))
                flat.add(PrimitiveKind::outline, {place(), place(), place()}, green);
            else
                flat.add(PrimitiveKind::line, {place(), place()}, green);
        }
        // A side of the first face, too.
        flat.scene.primitives.push_back(
            {.kind = PrimitiveKind::line, .name = "side", .vertices = {0, 1}, .color = green});
        const std::string there = picture_of(draw_as_planned(flat.scene));
        const std::size_t drawn = count_of(draw_as_planned(flat.scene), green);
        std::reverse(flat.scene.primitives.begin() + first, flat.scene.primitives.end());
        ASSERT_EQ(count_of(draw_as_planned(flat.scene), green), drawn)
            << scene_text(flat.scene) << there;
        ASSERT_EQ(picture_of(draw_as_planned(flat.scene)), there) << scene_text(flat.scene);
    }
}

TEST(HiddenLines, ALineThatIsDrawnLeavesTheFaceToTheNextOne) {
    // RS lies behind the face ABC. PQ, before it, crosses RS in column 5.
    for (const bool near_first : {false, true}) {
        FlatScene flat(
            {.scalar = ScalarKind::exact, .fill = Fill::top_left, .sample = Sample::integer});
        flat.add(PrimitiveKind::triangle,
                 {{"21/5", "41/10", "5"}, {"31/5", "49/10", "5"}, {"24/5", "26/5", "5"}}, red);
        const auto add_near = [&flat] {
            flat.add(PrimitiveKind::line, {{"5", "0", "1"}, {"5", "9", "1"}}, green);
        };
        if (near_first)
            add_near();
        flat.add(PrimitiveKind::line, {{"0", "49/10", "9"}, {"11", "49/10", "9"}}, blue);
        if (!near_first)
            add_near();
        const Image picture = draw_as_planned(flat.scene);
        EXPECT_NE(picture.at({6, 5}), blue);
        EXPECT_EQ(picture.at({5, 5}), green);
        EXPECT_EQ(picture.at({7, 5}), blue);
    }
}

TEST(HiddenLines, ALineInAFacesPlaneIsWhole) {
    Random random(31);
    for (int i = 0; i < 200; ++i) {
        FlatScene flat({.scalar = random.pick({ScalarKind::exact, ScalarKind::adaptive}),
                        .fill = random.pick({Fill::scanline, Fill::top_left, Fill::barycentric})});
        std::array<Vec<Rational, 3>, 3> face;
        for (auto& corner : face)
            corner = {Rational(random.whole(0, 230), 10), Rational(random.whole(0, 230), 10),
                      Rational(random.whole(10, 900), 9)};
        const auto text = [](const Vec<Rational, 3>& at) -> std::array<std::string, 3> {
            const auto lowest = [](Rational number) {
                number.canonicalize();
                return number.get_str();
            };
            return {lowest(at.x), lowest(at.y), lowest(at.z)};
        };
        const auto inside = [&] {
            const Rational u(random.whole(0, 12), 24);
            const Rational v(random.whole(0, 12), 24);
            return Vec<Rational, 3>{
                face[0].x + u * (face[1].x - face[0].x) + v * (face[2].x - face[0].x),
                face[0].y + u * (face[1].y - face[0].y) + v * (face[2].y - face[0].y),
                face[0].z + u * (face[1].z - face[0].z) + v * (face[2].z - face[0].z)};
        };
        flat.add(PrimitiveKind::triangle, {text(face[0]), text(face[1]), text(face[2])}, red);
        flat.add(PrimitiveKind::line, {text(inside()), text(inside())}, green);
        LineSink sink;
        draw_as_planned(flat.scene, sink);
        ASSERT_EQ(sink.drawn.back(), sink.asked.back()) << scene_text(flat.scene);
    }
}

TEST(HiddenLines, AreAsDeepAsTheLineIsThere) {
    // From z = 4 before the face at z = 5 to z = 8 behind it: it goes through at a quarter of its way.
    FlatScene flat({.scalar = ScalarKind::exact});
    flat.add(PrimitiveKind::triangle, big_face, red);
    flat.add(PrimitiveKind::line, {{"2", "3", "4"}, {"14", "3", "8"}}, green);
    const Image picture = draw_as_planned(flat.scene);
    for (int x = 2; x <= 14; ++x)
        EXPECT_EQ(picture.at({x, 3}), x <= 5 ? green : red) << x;
}

TEST(HiddenLines, AFaceDoesNotHideItsOwnSides) {
    Random random(3);
    const auto coordinate = [&random] { return std::to_string(random.whole(0, 24 * 7)) + "/7"; };
    const auto depth = [&random] { return std::to_string(random.whole(10, 900)) + "/9"; };
    for (int i = 0; i < 600; ++i) {
        const Method method{
            .scalar =
                random.pick({ScalarKind::double_precision, ScalarKind::adaptive, ScalarKind::exact,
                             ScalarKind::fixed, ScalarKind::single_precision}),
            .line = random.pick({LineMethod::bresenham, LineMethod::naive, LineMethod::dda}),
            .fill =
                random.pick({Fill::scanline, Fill::top_left, Fill::barycentric, Fill::two_halves})};
        FlatScene flat(method);
        flat.add(PrimitiveKind::triangle,
                 {{coordinate(), coordinate(), depth()},
                  {coordinate(), coordinate(), depth()},
                  {coordinate(), coordinate(), depth()}},
                 red);
        Scene alone = flat.scene;
        alone.primitives[0].kind = PrimitiveKind::outline;
        alone.primitives[0].color = green;
        ScenePrimitive outline = alone.primitives[0];
        outline.name = "outline";
        flat.scene.primitives.push_back(outline);
        const Image whole = draw_as_planned(alone);
        const Image picture = draw_as_planned(flat.scene);
        for (std::size_t offset = 0; offset < whole.colors().size(); ++offset)
            if (whole.colors()[offset] == green) {
                ASSERT_EQ(picture.colors()[offset], green)
                    << scene_text(flat.scene) << picture_of(picture);
            }
    }
}

/// A fraction of a point's weights in a triangle: all of one sign, or no area.
struct Weights {
    std::array<Rational, 3> of;
    Rational area;

    Weights(const std::array<Vec<Rational, 3>, 3>& corners, const Rational& x, const Rational& y) {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& a = corners[(i + 1) % 3];
            const auto& b = corners[(i + 2) % 3];
            of[i] = (a.x - x) * (b.y - y) - (b.x - x) * (a.y - y);
            area += of[i];
        }
    }
    bool has_inside() const {
        return sgn(area) != 0 && std::all_of(of.begin(), of.end(), [&](const Rational& one) {
                   return sgn(one) * sgn(area) >= 0;
               });
    }
};

TEST(HiddenLines, WhatIsNotDrawnIsBehindAFace) {
    // Against the point of the line itself and all faces, in fractions: nothing in sight is missing, and what a
    // face hides that reaches two pixels around it is not drawn.
    Random random(11);
    for (int i = 0; i < 400; ++i) {
        const ScalarKind scalar = random.pick({ScalarKind::exact, ScalarKind::adaptive});
        FlatScene flat({.scalar = scalar,
                        .fill = random.pick({Fill::scanline, Fill::top_left, Fill::barycentric})});
        const auto coordinate = [&] { return std::to_string(random.whole(-8, 5 * 30)) + "/5"; };
        const auto depth = [&] { return std::to_string(random.whole(1, 40)); };
        std::vector<std::array<Vec<Rational, 3>, 3>> faces;
        const auto vec = [](const std::array<std::string, 3>& place) {
            return Vec<Rational, 3>{number(place[0]).exact(), number(place[1]).exact(),
                                    number(place[2]).exact()};
        };
        for (int face = random.whole(1, 4); face > 0; --face) {
            const Places places{{coordinate(), coordinate(), depth()},
                                {coordinate(), coordinate(), depth()},
                                {coordinate(), coordinate(), depth()}};
            flat.add(PrimitiveKind::triangle, places, red);
            faces.push_back({vec(places[0]), vec(places[1]), vec(places[2])});
        }
        const Places line{{coordinate(), coordinate(), depth()},
                          {coordinate(), coordinate(), depth()}};
        flat.add(PrimitiveKind::line, line, green);
        LineSink sink;
        draw_as_planned(flat.scene, sink);

        const auto from = vec(line[0]);
        const auto to = vec(line[1]);
        const bool is_x_major = abs(to.x - from.x) >= abs(to.y - from.y);
        const Rational length = is_x_major ? to.x - from.x : to.y - from.y;
        if (sgn(length) == 0)
            continue;
        for (const auto& [x, y] : sink.asked.back()) {
            const Rational way = is_x_major ? x - from.x : y - from.y;
            const Rational part = std::clamp<Rational>(way / length, 0, 1);
            const Vec<Rational, 3> point{from.x + part * (to.x - from.x),
                                         from.y + part * (to.y - from.y),
                                         from.z + part * (to.z - from.z)};
            bool is_hidden = false;
            bool is_far_inside = false;
            for (const auto& face : faces) {
                const Weights at(face, point.x, point.y);
                if (!at.has_inside())
                    continue;
                const Rational deep =
                    (at.of[0] * face[0].z + at.of[1] * face[1].z + at.of[2] * face[2].z) / at.area;
                if (!(deep < point.z))
                    continue;
                is_hidden = true;
                bool covers_all = faces.size() == 1;
                for (const int dx : {-2, 2})
                    for (const int dy : {-2, 2})
                        covers_all =
                            covers_all && Weights(face, point.x + dx, point.y + dy).has_inside();
                is_far_inside = is_far_inside || covers_all;
            }
            const bool is_drawn = sink.drawn.back().count({x, y}) > 0;
            ASSERT_TRUE(is_drawn || is_hidden) << "not drawn at " << x << ", " << y << "\n"
                                               << scene_text(flat.scene);
            ASSERT_FALSE(is_drawn && is_far_inside) << "drawn at " << x << ", " << y << "\n"
                                                    << scene_text(flat.scene);
        }
    }
}

TEST(HiddenLines, FacesThatOnlyHideDrawNothing) {
    FlatScene flat({});
    flat.add(PrimitiveKind::triangle, big_face, red);
    flat.scene.primitives.back().is_painted = false;
    flat.add(PrimitiveKind::line, {{"2", "3", "9"}, {"9", "3", "9"}}, green);
    flat.add(PrimitiveKind::line, {{"2", "6", "1"}, {"9", "6", "1"}}, blue);
    for (const Shade shade : {Shade::flat, Shade::faces, Shade::interpolate}) {
        flat.scene.method.shade = shade;
        const Image picture = draw_as_planned(flat.scene);
        EXPECT_EQ(picture.drawn(), 8u) << "the line that lies before it";
    }
    flat.scene.primitives.resize(1);
    EXPECT_EQ(draw_as_planned(flat.scene).drawn(), 0u) << "alone, it is not even tested";
}

TEST(HiddenLines, ASideIsDrawnWithItsFaceAndCulledWithIt) {
    // M lies on AB: the triangle AMB has no area and is never drawn, but the face AMBC is.
    const auto drawn_sides = [](bool is_turned_away) {
        Scene scene;
        scene.canvas = {.width = 24, .height = 24};
        scene.method = {.scalar = ScalarKind::exact, .cull = Cull::back, .depth = Depth::linear_z};
        scene.vertices = {
            {"A", -8, -8, {}, 5}, {"M", 0, -8, {}, 5}, {"B", 8, -8, {}, 5}, {"C", -8, 8, {}, 5}};
        for (std::array<std::size_t, 3> corners :
             {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
            if (is_turned_away)
                std::swap(corners[1], corners[2]);
            scene.primitives.push_back(
                {.is_painted = false, .name = "face", .vertices = corners, .polygon = 1});
        }
        for (const auto& [from, to] : {std::pair{0U, 1U}, {1U, 2U}, {2U, 3U}, {3U, 0U}})
            scene.primitives.push_back({.kind = PrimitiveKind::line,
                                        .is_side = true,
                                        .name = "side",
                                        .vertices = {from, to}});
        LineSink sink;
        draw_as_planned(scene, sink);
        return std::count_if(sink.drawn.begin(), sink.drawn.end(),
                             [](const Pixels& pixels) { return !pixels.empty(); });
    };
    EXPECT_EQ(drawn_sides(false), 4);
    EXPECT_EQ(drawn_sides(true), 0);
}

TEST(HiddenLines, OfTwoLinesInAPixelTheNearerOneStaysWhateverHasTheDepthBuffer) {
    // The face is nearer than both in the middle of the pixels of row 1: AB is its side, PQ lies beside it.
    for (const ScalarKind scalar :
         {ScalarKind::double_precision, ScalarKind::adaptive, ScalarKind::exact})
        for (const bool side_first : {false, true}) {
            FlatScene flat({.scalar = scalar});
            flat.add(PrimitiveKind::triangle,
                     {{"1", "7/5", "5"}, {"12", "7/5", "5"}, {"6", "-3", "1"}}, red);
            const auto add_line = [&flat] {
                flat.add(PrimitiveKind::line, {{"1", "29/20", "9"}, {"12", "29/20", "9"}}, green);
            };
            if (!side_first)
                add_line();
            flat.scene.primitives.push_back(
                {.kind = PrimitiveKind::line, .name = "AB", .vertices = {0, 1}, .color = blue});
            if (side_first)
                add_line();
            const Image picture = draw_as_planned(flat.scene);
            for (int x = 1; x <= 12; ++x)
                EXPECT_EQ(picture.at({x, 1}), blue) << x;
        }
}

TEST(HiddenLines, ASideIsHiddenByAFaceThatCoversItsPoint) {
    // The nearer face has no pixel in row 1, where AB is drawn at y = 7/5, but covers AB.
    for (const bool is_side : {false, true}) {
        FlatScene flat({.scalar = ScalarKind::exact});
        flat.add(PrimitiveKind::triangle, {{"1", "7/5", "5"}, {"12", "7/5", "5"}, {"6", "-3", "5"}},
                 red);
        flat.add(PrimitiveKind::triangle,
                 {{"-2", "13/10", "1"}, {"16", "13/10", "1"}, {"6", "12", "1"}}, red);
        flat.add(PrimitiveKind::line, {{"1", "7/5", "5"}, {"12", "7/5", "5"}}, green);
        if (is_side)
            flat.scene.primitives.back().vertices = {0, 1, 0};
        EXPECT_EQ(count_of(draw_as_planned(flat.scene), green), 0U);
    }
}

// As docs/scene-format.md says: a face that is the nearest at no sample of nine is not asked.
TEST(HiddenLines, ASliverBetweenSamplesHidesNothing) {
    for (const std::string below : {"33/10", "36/10"}) { // samples lie at y = 5/2, 7/2
        FlatScene flat({.scalar = ScalarKind::exact, .fill = Fill::top_left});
        flat.add(PrimitiveKind::triangle,
                 {{"-9", "27/10", "1"}, {"40", "27/10", "1"}, {"9", below, "1"}}, red);
        flat.add(PrimitiveKind::line, {{"8", "3", "5"}, {"10", "3", "5"}}, green);
        EXPECT_EQ(count_of(draw_as_planned(flat.scene), green), below == "33/10" ? 3U : 0U);
    }
}

TEST(HiddenLines, ADiagonalOfAFaceIsNoSideOfIt) {
    // The square AXBY is drawn, AZB is turned away: of AZB's sides, AB is only a diagonal of the square.
    Scene scene;
    scene.canvas = {.width = 24, .height = 24};
    scene.method = {.scalar = ScalarKind::exact, .cull = Cull::back, .depth = Depth::linear_z};
    scene.vertices = {{"A", -8, -8, {}, 5},
                      {"X", 8, -8, {}, 5},
                      {"B", 8, 8, {}, 5},
                      {"Y", -8, 8, {}, 5},
                      {"Z", 0, 2, {}, 4}};
    const auto add_face = [&scene](std::array<std::size_t, 3> corners, std::uint32_t polygon) {
        scene.primitives.push_back(
            {.is_painted = false, .name = "face", .vertices = corners, .polygon = polygon});
    };
    add_face({0, 1, 2}, 1);
    add_face({0, 2, 3}, 1);
    add_face({0, 4, 2}, 0);
    for (const auto& [from, to] : {std::pair{0U, 1U}, {0U, 4U}, {4U, 2U}, {2U, 0U}})
        scene.primitives.push_back(
            {.kind = PrimitiveKind::line, .is_side = true, .name = "side", .vertices = {from, to}});
    LineSink sink;
    draw_as_planned(scene, sink);
    EXPECT_FALSE(sink.drawn[3].empty()) << "AX";
    for (const std::size_t side : std::array<std::size_t, 3>{4, 5, 6})
        EXPECT_TRUE(sink.drawn[side].empty()) << side;
}

} // namespace
} // namespace rastertrace
