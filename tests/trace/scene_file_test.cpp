// SPDX-License-Identifier: MIT
#include "edge_scenes.h"
#include "picture.h"
#include "random_scene.h"
#include "scene_text.h"
#include "told_problem.h"
#include "traces.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/core/draw/model/mistakes.h>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// What is said about a scene file with this text.
std::string complaint(const std::string& text) {
    const auto scene = read_scene({"scene.json", text});
    return scene ? "no complaint" : to_text(scene.problem());
}

void expect_complaint(const std::string& text, const std::string& message,
                      const std::string& hint = "") {
    EXPECT_EQ(complaint(text), told_problem(text, message, hint));
}

TEST(SceneFile, SmallestScene) {
    const Scene scene = scene_in(R"({"vertices": {"A": [2, 5], "B": [-4, -3], "C": [5, -3]},
                                     "triangles": ["ABC"]})");
    EXPECT_EQ(scene.title, "");
    EXPECT_EQ(scene.vertices.size(), 3u);
    EXPECT_EQ(scene.primitives[0].name, "ABC");
    EXPECT_EQ(scene.canvas.width, 13) << "fitted: x -5..5, and a pixel more on each side";
    EXPECT_EQ(scene.canvas.height, 13);
    EXPECT_EQ(scene.method.scalar, ScalarKind::double_precision);
    EXPECT_EQ(span_rounding(scene.method).rounding, Rounding::floor);
}

TEST(SceneFile, EveryKey) {
    const Scene scene = scene_in(R"({
        "title": "Everything",
        "canvas": {"width": 20, "height": 10, "origin": "top-left"},
        "vertices": {"P1": [0.1, "25/8"], "P2": [3, -4e0], "é": [1, 2]},
        "triangles": [{"vertices": ["P1", "P2", "é"], "name": "roof", "color": "#ff8000"},
                      ["é", "P2", "P1"]],
        "method": {"scalar": "exact", "fill": "scanline", "rounding": "nearest", "ties": "even",
                   "lerp": "incremental"}})");
    EXPECT_EQ(scene.title, "Everything");
    EXPECT_EQ(scene.canvas, (Canvas{20, 10, Origin::top_left}));
    EXPECT_EQ(scene.vertices[0].x.exact().get_str(), "1/10");
    EXPECT_EQ(scene.vertices[0].y.exact().get_str(), "25/8");
    EXPECT_EQ(scene.primitives[0].name, "roof");
    EXPECT_EQ(scene.primitives[0].color, (Color{255, 128, 0, 255}));
    EXPECT_EQ(scene.primitives[1].name, "é-P2-P1");
    EXPECT_EQ(scene.method.rounding, Rounding::nearest);
    EXPECT_EQ(scene.method.ties, Ties::even);
    EXPECT_EQ(scene.method.lerp, LerpForm::incremental);
}

TEST(SceneFile, ByteOrderMarkAndCarriageReturnsSayNothing) {
    scene_in("\xEF\xBB\xBF{\"vertices\": {\"A\": [2, 5]},\r\n\"triangles\": [\"AAA\"]}\r\n");
}

TEST(SceneFile, OverridesTakeThePlaceOfTheMethod) {
    const auto scene = read_scene({"s", R"({"vertices": {"A": [2, 5]}, "triangles": ["AAA"],
                                            "method": {"rounding": "inside"}})"},
                                  {{"rounding", "truncate"}, {"scalar", "exact"}});
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene.value().scene.method.rounding, Rounding::truncate);
    EXPECT_EQ(scene.value().scene.method.scalar, ScalarKind::exact);
}

TEST(SceneFile, UnknownKey) {
    expect_complaint(
        "{\"vertices\": {\"A\": [2, 5]},\n \"trinagles\": [\"AAA\"]}",
        "scene.json:2:2: expected a key out of title, canvas, background, vertices, colors, "
        "triangles, polygons, outlines, lines, circles, points, meshes, model, camera, projection, "
        "viewport, light, convention, method, keep, vary, found \"trinagles\"",
        "did you mean \"triangles\"?");
}

TEST(SceneFile, WrongType) {
    expect_complaint(R"({"vertices": {"A": [2, "five"]}, "triangles": ["AAA"]})",
                     "scene.json:1:24: expected a number, found \"five\"",
                     "a fraction is written \"25/8\", in quotes");
    expect_complaint(
        R"({"vertices": {"A": {}}, "triangles": ["AAA"]})",
        "scene.json:1:20: expected [x, y], [x, y, z] or [x, y, z, w], found an object");
    expect_complaint(R"({"vertices": {"A": [1, 2, 3, 4]}, "triangles": ["AAA"]})",
                     "scene.json:1:20: expected a canvas with a width and a height beside a vertex "
                     "of four numbers, in clip space, found none",
                     "say \"canvas\": {\"width\": ..., \"height\": ...}; or decimal commas? JSON "
                     "has a point: 5.5");
    expect_complaint(R"({"title": 5})", "scene.json:1:11: expected a title in quotes, found 5");
    expect_complaint(
        "[]",
        "scene.json:1:1: expected an object with the keys title, canvas, background, vertices, "
        "colors, triangles, polygons, outlines, lines, circles, points, meshes, model, camera, "
        "projection, viewport, light, convention, method, keep, vary, found an empty array");
}

TEST(SceneFile, MissingVertex) {
    expect_complaint(R"({"vertices": {"A": [2, 5], "B": [1, 2]}, "triangles": ["ABC"]})",
                     "scene.json:1:59: expected the name of a vertex, found \"C\"",
                     "the scene has the vertices A, B");
}

TEST(SceneFile, RepeatedName) {
    expect_complaint(R"({"vertices": {"A": [2, 5], "A": [1, 2]}, "triangles": ["AAA"]})",
                     "scene.json:1:28: expected each key once, found \"A\" again");
    EXPECT_EQ(complaint(R"({"vertices": {"A": [2, 5]},
"triangles": [{"vertices": "AAA", "name": "x"}, {"vertices": "AAA", "name": "x"}]})"),
              "scene.json:2:77: expected a name that no other primitive has, found \"x\"\n"
              "...vertices\": \"AAA\", \"name\": \"x\"}, {\"vertices\": \"AAA\", \"name\": "
              "\"x\"}]}\n"
              "                                                               ^");
}

TEST(SceneFile, NumbersThatAreNone) {
    expect_complaint(R"({"vertices": {"A": [2, 1e999]}})",
                     "scene.json:1:24: expected a number up to 1.797e308, found 1e999");
    expect_complaint(R"({"vertices": {"A": [2, "-1e999"]}})",
                     "scene.json:1:24: expected a number up to 1.797e308, found \"-1e999\"");
    expect_complaint(R"({"vertices": {"A": [2, 1e-400]}})",
                     "scene.json:1:24: expected 0 or a number from 4.941e-324 on, found 1e-400");
    expect_complaint(R"({"vertices": {"A": ["1/0", 2]}})",
                     "scene.json:1:21: expected a denominator other than 0, found \"1/0\"");
    expect_complaint(R"({"vertices": {"A": [NaN, 2]}})",
                     "scene.json:1:21: expected a value or ']', found 'NaN'");
}

TEST(SceneFile, CanvasesThatAreNone) {
    const std::string rest = R"(, "vertices": {"A": [2, 5]}, "triangles": ["AAA"]})";
    EXPECT_EQ(complaint(R"({"canvas": {"width": 0, "height": 5})" + rest),
              "scene.json:1:22: expected a whole number of pixels from 1 to 16384, found 0\n"
              "{\"canvas\": {\"width\": 0, \"height\": 5}, \"vertices\": {\"A\": [2, 5...\n"
              "                     ^");
    EXPECT_EQ(complaint(R"({"canvas": {"width": 100000, "height": 100000})" + rest),
              "scene.json:1:22: expected a whole number of pixels from 1 to 16384, found 100000\n"
              "{\"canvas\": {\"width\": 100000, \"height\": 100000}, \"vertices\": {...\n"
              "                     ^");
    EXPECT_EQ(complaint(R"({"canvas": {"width": 16384, "height": 16384})" + rest),
              "scene.json:1:12: expected a canvas of at most 67108864 pixels, found 16384 x 16384\n"
              "{\"canvas\": {\"width\": 16384, \"height\": 16384}, \"vert...\n"
              "           ^\n"
              "hint: say \"canvas\": {\"width\": ..., \"height\": ...}");
    EXPECT_EQ(complaint(R"({"canvas": {"width": 2.5})" + rest),
              "scene.json:1:22: expected a whole number of pixels from 1 to 16384, found 2.5\n"
              "{\"canvas\": {\"width\": 2.5}, \"vertices\": {\"A\": [2, 5]}, \"triang...\n"
              "                     ^");
    EXPECT_EQ(complaint(R"({"vertices": {"A": [1, 1e9]}, "triangles": ["AAA"]})"),
              "scene.json:1:1: expected vertices that fit on 16384 pixels, or a canvas with a "
              "height; found a vertex 1e+09 pixels from the origin\n"
              "{\"vertices\": {\"A\": [1, 1e9]}, \"triangles...\n"
              "^\n"
              "hint: say \"canvas\": {\"width\": ..., \"height\": ...}");
}

TEST(SceneFile, ColorsThatAreNone) {
    const auto with_color = [](const std::string& color) {
        return R"({"vertices": {"A": [2, 5]}, "triangles": [{"vertices": "AAA", "color": ")" +
               color + R"("}]})";
    };
    EXPECT_EQ(
        complaint(with_color("gren")),
        "scene.json:1:72: expected a color, like \"#ff8000\" or \"red\", found \"gren\"\n"
        "...: {\"A\": [2, 5]}, \"triangles\": [{\"vertices\": \"AAA\", \"color\": \"gren\"}]}\n"
        "                                                               ^\n"
        "hint: did you mean \"green\"?");
    EXPECT_EQ(complaint(with_color("#00000000")).substr(0, 80),
              "scene.json:1:72: expected a color that can be seen (alpha above 00), found \"#000");
}

TEST(SceneFile, WordsOfOtherProgramsGetAHint) {
    const auto hint = [](const std::string& text) {
        const std::string told =
            complaint(R"({"vertices": {"A": [2, 5, 1]}, "points": ["A"], )" + text + "}");
        return told.substr(told.rfind('\n') + 1);
    };
    EXPECT_EQ(hint(R"("projection": {"type": "perspective"})"), "hint: did you mean \"frustum\"?");
    for (const std::string key : {"fov", "vertical_fov"})
        EXPECT_EQ(
            hint(R"("projection": {"type": "frustum", "near": 1, "far": 9, ")" + key + R"(": 60})"),
            "hint: did you mean \"fov_y\"?");
    EXPECT_EQ(hint(R"("camera": {"position": [0, 0, 9], "target": [0, 0, 0]})"),
              "hint: did you mean \"look_at\"?");
    EXPECT_EQ(hint(R"("meshes": [{"file": "cube.obj"}])"), "hint: did you mean \"obj\"?");
    EXPECT_EQ(hint(R"("method": {"depth": "z-buffer"})"),
              "hint: did you mean \"linear-z\" or \"inverse-z\" or \"ndc-z\"?");
}

TEST(SceneFile, ValuesOfTheMethod) {
    expect_complaint(
        R"({"method": {"scalar": "exat"}})",
        "scene.json:1:23: expected one of float, double, fixed, adaptive, exact, found \"exat\"",
        "did you mean \"exact\"?");
}

TEST(SceneFile, ChoicesThatDoNotGoTogether) {
    const auto with = [](const std::string& method, const std::string& primitives) {
        return R"({"vertices": {"A": [1, 2], "B": [5, 3], "C": [2, 4]}, )" + primitives +
               R"(, "method": )" + method + "}";
    };
    EXPECT_THAT(
        complaint(with(R"({"rounding": "half-open", "line": "dda"})", R"("lines": ["AB"])")),
        AllOf(
            HasSubstr("expected a rounding that lines can have, found \"half-open\": a line has no "
                      "right end"),
            HasSubstr("hint: say \"line\": \"bresenham\"")));
    EXPECT_THAT(
        complaint(with(R"({"rounding": "nearest", "ties": "step"})", R"("triangles": ["ABC"])")),
        HasSubstr("expected ties that the rows of triangles can have, found \"step\""));
    EXPECT_THAT(complaint(with(R"({"snap": "nearest", "ties": "step"})", R"("points": ["A"])")),
                HasSubstr("expected ties that a snapped vertex can have, found \"step\""));
    for (const char* const fine : {R"({"rounding": "half-open"})", R"({"ties": "step"})"})
        EXPECT_EQ(complaint(with(fine, R"("triangles": ["ABC"], "lines": ["AB"])")),
                  "no complaint");
}

TEST(SceneFile, HiddenLinesNeedADepthBuffer) {
    const auto mesh = [](const std::string& draw, const std::string& more) {
        return R"({"meshes": [{"vertices": {"A": [0, 0, 2], "B": [5, 0, 2], "C": [5, 5, 3], "D": [0, 5, 3]},
 "faces": ["ABCD", "ABC"], "draw": ")" +
               draw + R"("}])" + more + "}";
    };
    expect_complaint(mesh("hidden-lines", ""),
                     "scene.json:2:36: expected a depth buffer for hidden lines, found none",
                     "say \"projection\": {...}, or \"method\": {\"depth\": \"linear-z\"}");
    EXPECT_THAT(
        complaint(mesh("hidden-lines", R"(, "method": {"depth": "linear-z", "fill": "fan"})")),
        HasSubstr("found \"fill\": \"fan\""));
    EXPECT_THAT(
        complaint(mesh("hidden-line", "")),
        HasSubstr("expected triangles, polygons, outlines or hidden-lines, found \"hidden-line\""));

    // Each side once, after all triangles; no line within a face.
    const auto read =
        read_scene({"scene.json", mesh("hidden-lines", R"(, "method": {"depth": "linear-z"})")});
    ASSERT_TRUE(read) << to_text(read.problem());
    std::vector<std::string> names;
    for (const ScenePrimitive& primitive : read.value().scene.primitives)
        names.push_back(primitive.name);
    EXPECT_THAT(names, ElementsAre("ABC", "ACD", "ABC", "AB", "BC", "CD", "DA", "CA"));
}

/// A scene of one point on a canvas, and what else it says.
std::string point_scene(const std::string& more) {
    return R"({"vertices": {"A": [1, 2, 3]}, "points": ["A"],)"
           "\n " +
           more + "}";
}

TEST(SceneFile, PipelineKeys) {
    const Scene scene = scene_in(point_scene(R"("canvas": {"width": 8, "height": 6},
        "model": [{"scale": [1, "1/2", 2]}, {"rotate": {"axis": [0, 1, 1], "degrees": 30}},
                  {"translate": [0, 0, 4]}, {"shear": {"xy": 3}}],
        "camera": {"position": [0, 0, 4]},
        "projection": {"type": "frustum", "fov_y": 60, "near": 1, "far": "infinity"})"));
    EXPECT_EQ(scene.vertices[0].z.nearest_double(), 3);
    ASSERT_EQ(scene.objects.size(), 1u);
    EXPECT_EQ(scene.objects[0].model.steps().size(), 4u);
    EXPECT_EQ(std::get<Scale>(scene.objects[0].model.steps()[0]).by[1].nearest_double(), 0.5);
    EXPECT_EQ(std::get<Shear>(scene.objects[0].model.steps()[3]).xy.nearest_double(), 3);
    EXPECT_EQ(scene.camera->position[2].nearest_double(), 4);
    EXPECT_EQ(scene.camera->look_at[2].nearest_double(), 0);
    EXPECT_EQ(scene.camera->up[1].nearest_double(), 1);
    EXPECT_EQ(scene.projection.fov_y->nearest_double(), 60);
    EXPECT_FALSE(scene.projection.far);
    EXPECT_EQ(scene.viewport.type, ViewportType::pixels);
}

TEST(SceneFile, PinholeShowsAPlaneOfOneUnit) {
    const Scene scene = scene_in(point_scene(R"("canvas": {"width": 8, "height": 6},
        "projection": {"type": "pinhole", "distance": 2})"));
    EXPECT_EQ(scene.viewport.type, ViewportType::pixels_per_unit);
    EXPECT_EQ(scene.viewport.pixels_per_unit.nearest_double(), 6);
}

TEST(SceneFile, ViewportsThatTakePixelsByTheirEdges) {
    const std::string canvas = R"("canvas": {"width": 20, "height": 30, "origin": "top-left"}, )";
    const auto viewport = [&canvas](const std::string& text) {
        return scene_in(point_scene(canvas + R"("viewport": )" + text)).viewport;
    };
    EXPECT_EQ(viewport(R"({"pixels": "edges"})").pixels, PixelRange::edges);
    EXPECT_FALSE(viewport(R"({"pixels": "edges"})").is_y_down);
    EXPECT_EQ(viewport(R"({"pixels": "edges-half", "y": "up"})").pixels, PixelRange::edges_half);
    EXPECT_TRUE(viewport(R"({"pixels": "centers", "y": "down"})").is_y_down);

    const auto told = [&canvas](const std::string& text) {
        const std::string said = complaint(point_scene(canvas + R"("viewport": )" + text));
        return said.substr(0, said.find('\n'));
    };
    EXPECT_EQ(told(R"({"pixels": "edge"})"),
              "scene.json:2:86: expected one of centers, edges, edges-half, found \"edge\"");
    EXPECT_EQ(told(R"({"pixels": 1})"),
              "scene.json:2:86: expected one of centers, edges, edges-half, found 1");
    EXPECT_EQ(told(R"({"pixels": "edges", "y": "left"})"),
              "scene.json:2:100: expected one of up, down, found \"left\"");
    EXPECT_EQ(told(R"({"pixels": "edges", "pixels_per_unit": 2})"),
              "scene.json:2:95: expected a key out of pixels, depth_range, y, found "
              "\"pixels_per_unit\"");
    for (const std::string none : {R"({"y": "down"})", R"({"pixel": "edges"})", "{}", "[]", "7"})
        EXPECT_THAT(told(none),
                    StartsWith("scene.json:2:75: expected \"fit\", {\"pixels\": \"edges\"} "
                               "or {\"pixels_per_unit\": 10}, found "))
            << none;
    EXPECT_THAT(
        complaint(point_scene(R"("viewport": {"pixels": "edges"})")),
        StartsWith("scene.json:1:1: expected a canvas with a width and a height, found none"));

    EXPECT_EQ(
        told(R"({"pixels": "edges", "depth_range": [0]})"),
        "scene.json:2:110: expected two depths, [near, far], like [0, 1], found an array of 1");
    EXPECT_EQ(told(R"({"pixels": "edges", "depth_range": [0.5, "1/2"]})"),
              "scene.json:2:110: expected two depths that differ, found the same twice");
    EXPECT_EQ(told(R"({"pixels": "edges", "depth_range": [0, 1]})"),
              "scene.json:2:110: expected a frustum, an orthographic projection with near and "
              "far, or vertices in clip space beside depth_range, found another: z does not lie "
              "within -1..1");
    EXPECT_THAT(
        complaint(point_scene(
            canvas + R"("projection": {"type": "frustum", "fov_y": 60, "near": 1, "far": 9},)"
                     R"("viewport": {"pixels": "edges", "depth_range": [0, 1]},)"
                     R"("triangles": ["AAA"], "method": {"depth": "inverse-z"})")),
        HasSubstr("expected \"depth\": \"ndc-z\" beside depth_range, found another"));
}

TEST(SceneFile, CamerasThatAreNone) {
    const std::string canvas = R"("canvas": {"width": 8, "height": 6}, )";
    expect_complaint(
        point_scene(canvas + R"("camera": {"position": [0, 4, 0]})"),
        "scene.json:2:49: expected an up that is not parallel to the view, found one that is",
        "for a camera that looks straight down, say \"up\": [0, 0, -1]");
    expect_complaint(point_scene(R"("camera": {"position": [0, 0, 0]})"),
                     "scene.json:2:12: expected a camera that looks at another place than its own, "
                     "found position = look_at");
}

TEST(SceneFile, ProjectionsThatAreNone) {
    const auto frustum = [](const std::string& rest) {
        return complaint(point_scene(R"("projection": {"type": "frustum", )" + rest + "}"));
    };
    EXPECT_EQ(frustum(R"("fov_y": 50, "near": 5, "far": 5)"),
              "scene.json:2:67: expected far above near, found 5 and 5\n"
              "...ection\": {\"type\": \"frustum\", \"fov_y\": 50, \"near\": 5, \"far\": 5}}\n"
              "                                                               ^");
    EXPECT_EQ(frustum(R"("fov_y": 180, "near": 5, "far": 6)"),
              "scene.json:2:45: expected a field of view between 0 and 180 degrees, found 180\n"
              " \"projection\": {\"type\": \"frustum\", \"fov_y\": 180, \"near\": 5, \"far\": 6}}\n"
              "                                            ^");
    EXPECT_EQ(frustum(R"("fov_y": 50, "near": 0, "far": 6)"),
              "scene.json:2:57: expected a distance above 0, found 0\n"
              " \"projection\": {\"type\": \"frustum\", \"fov_y\": 50, \"near\": 0, \"far\": 6}}\n"
              "                                                        ^");
    expect_complaint(point_scene(R"("projection": {"type": "pinehole"})"),
                     "scene.json:2:25: expected one of none, orthographic, pinhole, view-plane, "
                     "frustum, clip-space, found \"pinehole\"",
                     "did you mean \"pinhole\"?");
    EXPECT_EQ(
        complaint(point_scene(R"("projection": {"type": "pinhole", "distance": 1})")),
        "scene.json:1:1: expected a canvas with a width and a height, found none: the picture "
        "is fitted to it\n"
        "{\"vertices\": {\"A\": [1, 2, 3]}, \"points\":...\n"
        "^\n"
        "hint: say \"canvas\": {\"width\": ..., \"height\": ...}");
}

TEST(SceneFile, LightsThatAreNone) {
    const auto scene = [](const std::string& rest) {
        return complaint("{\"vertices\": {\"A\": [0, 0], \"B\": [3, 0], \"C\": [3, 3]},\n"
                         " \"triangles\": [\"ABC\"],\n " +
                         rest + "}");
    };
    EXPECT_THAT(scene(R"("method": {"shade": "lambert"})"),
                testing::StartsWith(
                    "scene.json:1:1: expected a light for \"shade\": \"lambert\", found none\n"));
    EXPECT_THAT(scene(R"("method": {"cull": "light"})"),
                testing::StartsWith(
                    "scene.json:1:1: expected a light for \"cull\": \"light\", found none\n"));
    EXPECT_EQ(scene(R"("light": {"direction": [0, 0, 0]})"),
              "scene.json:3:25: expected a direction to the light that is not 0, found [0, 0, 0]\n"
              " \"light\": {\"direction\": [0, 0, 0]}}\n"
              "                        ^");
    EXPECT_EQ(scene(R"("light": {})"),
              "scene.json:3:11: expected a direction or a position, found neither\n"
              " \"light\": {}}\n"
              "          ^");
}

TEST(SceneFile, StagesToKeep) {
    const std::string triangle =
        R"({"vertices": {"A": [0, 0], "B": [3, 0], "C": [3, 3]}, "triangles": ["ABC"],)";
    const Scene scene = scene_in(triangle + R"("keep": ["depth", "model"]})");
    EXPECT_TRUE(scene.keep.has(Stage::depth) && scene.keep.has(Stage::model));
    EXPECT_FALSE(scene.keep.has(Stage::view));
    expect_complaint(triangle + "\n\"keep\": [\"dept\"]}",
                     "scene.json:2:10: expected stages out of model, view, clip, divide, order, "
                     "cull, light, canvas, depth, perspective, colors, found \"dept\"",
                     "did you mean \"depth\"?");
}

TEST(SceneFile, MeshesInline) {
    const Scene scene = scene_in(R"({"meshes": [
        {"name": "roof", "vertices": {"A": [0, 0, 0], "B": [3, 0, 0], "C": [3, 3, 0], "D": [0, 3, 0]},
         "faces": ["ABCD"], "color": "red", "draw": "outlines", "model": [{"scale": [2, 2, 2]}]}],
        "lines": [["roof.A", "roof.C"]]})");
    ASSERT_EQ(scene.primitives.size(), 3u);
    EXPECT_EQ(scene.primitives[0].name, "roof.ABC");
    EXPECT_EQ(scene.primitives[1].name, "roof.ACD");
    EXPECT_EQ(scene.primitives[1].kind, PrimitiveKind::outline);
    EXPECT_EQ(scene.primitives[1].vertices, (std::array<std::size_t, 3>{0, 2, 3}));
    EXPECT_EQ(scene.primitives[2].name, "roof.A-roof.C");
    EXPECT_EQ(scene.canvas.width, 15) << "fitted to the scaled mesh: x -6..6 and a pixel more";
}

TEST(SceneFile, MeshesThatAreNone) {
    expect_complaint(R"({"meshes": [{"obj": "no/such.obj"}]})",
                     "scene.json:1:21: expected a file that can be read, found: No such file or "
                     "directory (no/such.obj)",
                     "a relative path starts from the scene's folder");
    expect_complaint(R"({"meshes": [{"vertices": {"A": [0, 0]}, "faces": ["AAB"]}]})",
                     "scene.json:1:54: expected the name of a vertex, found \"B\"",
                     "the scene has the vertices A");
    expect_complaint(R"({"meshes": [{"vertices": {"A": [0, 0]}, "faces": []}]})",
                     "scene.json:1:50: expected at least one face, found none");
}

TEST(SceneFile, ScaleToNothingIsDrawn) {
    const auto scene = scene_in(R"({"vertices": {"A": [1, 2], "B": [3, 4], "C": [5, 0]},
        "triangles": ["ABC"], "model": [{"scale": [0, 0, 0]}]})");
    EXPECT_EQ(picture_of(draw_as_planned(scene)), "...\n.#.\n...\n");
}

TEST(SceneFile, OverflowNamesVertexAndValue) {
    EXPECT_EQ(
        complaint(R"({"canvas": {"width": 9, "height": 9},
"vertices": {"A": [0, 0], "B": [1, 1e-320], "C": [0, 1]}, "triangles": ["ABC"]})"),
        "scene.json:2:27: expected an edge whose slope dx/dy fits in a double, found vertex A "
        "at (0, 0) and vertex B at (1, 1e-320)\n"
        "\"vertices\": {\"A\": [0, 0], \"B\": [1, 1e-320], \"C\": [0, 1]}, \"triangl...\n"
        "                          ^\n"
        "hint: with \"method\": {\"scalar\": \"exact\"} nothing overflows");
}

TEST(SceneFile, EmptySceneAndEmptyFile) {
    expect_complaint("{}", "scene.json:1:1: expected at least one primitive, found none",
                     "the smallest scene: {\"vertices\": {\"A\": [2, 5], \"B\": [-4, -3], \"C\": "
                     "[5, -3]}, \"triangles\": [\"ABC\"]}");
    EXPECT_EQ(complaint(""), "scene.json:1:1: expected a JSON value, found the end of the file");
}

TEST(SceneFile, NotJson) {
    expect_complaint("{\"a\": tru}", "scene.json:1:7: expected a value, found 'tru'");
    expect_complaint("{\"a\":\n  [1,,2]}", "scene.json:2:6: expected a value, found ','");
    expect_complaint("{\"a\" 1}", "scene.json:1:6: expected ':', found '1'");
    expect_complaint("{\"a\": 1,}", "scene.json:1:9: expected a key in double quotes, found '}'",
                     "JSON has no comma behind the last value");
    expect_complaint("{\"a\": [1 2]}", "scene.json:1:10: expected ',' or ']', found '2'");
    expect_complaint("{} {}", "scene.json:1:4: expected the end of the file, found '{'");
    expect_complaint(
        "{\"a\": \"x",
        "scene.json:1:7: expected valid JSON, found an invalid string: missing closing quote");
    EXPECT_EQ(complaint("\x7F"
                        "ELF\x02\x01"),
              "scene.json:1:1: expected a JSON value, found '<U+007F>'\n"
              "<U+007F>ELF<U+0002><U+0001>\n"
              "^");
}

TEST(SceneFile, NestingIsRefusedByDepth) {
    const std::string text = complaint(std::string(10000, '['));
    EXPECT_EQ(text.substr(0, text.find('\n')),
              "scene.json:1:65: expected at most 64 arrays and objects in one another, found one "
              "more");
}

// What a test prints of a random scene that fails is that scene.
TEST(SceneFile, OfASceneIsReadBackAsThatScene) {
    int compared = 0;
    const auto expect_same = [&compared](const Scene& scene) {
        // Hidden lines are said of a whole mesh, which is not written.
        if (std::any_of(scene.primitives.begin(), scene.primitives.end(),
                        [](const ScenePrimitive& one) { return !one.is_painted; }))
            return;
        ++compared;
        const Scene back = scene_in(scene_text(scene));
        EXPECT_EQ(scene_text(back), scene_text(scene));
        EXPECT_TRUE(draw_as_planned(back).colors() == draw_as_planned(scene).colors())
            << scene_text(scene);
    };
    EdgeScenes scenes(31);
    int drawn = 0;
    while (drawn < 300)
        if (Scene scene = scenes.next(); !find_unfit(scene)) {
            const ProjectionType type = scene.projection.type;
            if (type == ProjectionType::pinhole || type == ProjectionType::view_plane)
                scene.projection.far = {}; // which a file cannot say
            expect_same(scene);
            ++drawn;
        }
    EXPECT_GT(compared, 150);
    compared = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
        if (const auto read = read_scene({"scene.json", RandomScene(seed).text()}))
            expect_same(read.value().scene);
    EXPECT_GT(compared, 150);
}

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;

/// An arrow that points right, from B on.
const std::string arrow =
    R"("vertices": {"A": [7, 0], "B": [0, 5], "C": [0, 2], "D": [-7, 2], "E": [-7, -2], "F": [0, -2],
                    "G": [0, -5]}, "faces": ["BCDEFGA"])";

/// The names of the primitives, and those of their vertices behind them.
std::vector<std::string> primitives_of(const Scene& scene) {
    std::vector<std::string> all;
    for (const ScenePrimitive& one : scene.primitives) {
        all.push_back(one.name);
        for (const std::size_t vertex : one.corners())
            all.back() += " " + scene.vertices[vertex].name;
    }
    return all;
}

TEST(SceneFile, ConcaveFacesAreEarsInTheOrderInWhichTheyAreCut) {
    const Scene scene = scene_in(R"({"meshes": [{)" + arrow + "}]}");
    EXPECT_THAT(primitives_of(scene),
                ElementsAre("ABC A B C", "CDE C D E", "FGA F G A", "ACE A C E", "EFA E F A"));
    ASSERT_EQ(scene.cut_faces.size(), 1u);
    EXPECT_EQ(scene.cut_faces[0].name, "BCDEFGA");
    EXPECT_EQ(scene.cut_faces[0].normal.z.get_str(), "126");
    EXPECT_EQ(scene.cut_faces[0].first_ear, 0u);
    EXPECT_EQ(scene.cut_faces[0].ears, 5u);
    EXPECT_TRUE(scene_in(R"({"meshes": [{"vertices": {"A": [0, 0], "B": [4, 0], "C": [4, 4],
                             "D": [0, 4]}, "faces": ["ABCD"]}]})")
                    .cut_faces.empty());
}

TEST(SceneFile, EarsAreFoundAgainWhateverIsDrawnBeforeThem) {
    // Outlines come behind all triangles, and a face with three corners has no ears.
    const Scene scene = scene_in(
        R"({"vertices": {"P": [1, 1], "Q": [2, 2], "R": [3, 0]}, "triangles": ["PQR"], "meshes": [
            {"name": "a", "draw": "outlines", )" +
        arrow + R"(}, {"name": "b", "vertices": {"A": [0, 0], "B": [1, 0], "C": [0, 1]},
            "faces": ["ABC"]}, {"name": "c", )" +
        arrow + "}]}");
    ASSERT_EQ(scene.cut_faces.size(), 2u);
    for (const CutFace& face : scene.cut_faces) {
        const std::string mesh = face.name.substr(0, 2);
        EXPECT_EQ(scene.primitives.at(face.first_ear).name, mesh + "ABC");
        EXPECT_EQ(scene.primitives.at(face.first_ear + face.ears - 1).name, mesh + "EFA");
    }
}

/// The remarks on a scene, one behind the other.
std::string remarks_on(const std::string& text) {
    const auto scene = read_scene({"scene.json", text});
    EXPECT_TRUE(scene) << to_text(scene.problem());
    std::string all;
    if (scene)
        for (const Problem& remark : scene.value().remarks)
            all += to_text(remark) + "\n";
    return all;
}

TEST(SceneFile, FacesOffTheirPlaneAreToldOnceAMesh) {
    EXPECT_EQ(
        remarks_on(
            R"({"canvas": {"width": 9, "height": 9}, "projection": {"type": "none"}, "meshes": [{
"vertices": {"A": [0, 0, 0], "B": [4, 0, 0], "C": [4, 4, 0.5], "D": [0, 4, 0]},
"faces": ["ABC", "ABCD", "DCBA", "ABDD"]}]})"),
        "scene.json:3:18: remark: expected faces whose corners lie in one plane, found 2 of 3 "
        "faces whose corners do not, by up to 0.125; the first is ABCD\n"
        "\"faces\": [\"ABC\", \"ABCD\", \"DCBA\", \"ABDD\"]}]}\n"
        "                 ^\n"
        "hint: it is cut as it is seen along x, y or z, whichever its normal is nearest to\n");
}

TEST(SceneFile, ACameraWithoutAProjectionIsRemarked) {
    const auto scene_with = [](const std::string& keys) {
        return R"({"canvas": {"width": 9, "height": 9}, "vertices": {"A": [0, 0, 0]}, "points": ["A"],
"camera": )" + keys +
               "}";
    };
    const std::string camera = R"({"position": [3, 4, 12]})";
    EXPECT_EQ(remarks_on(scene_with(camera)),
              "scene.json:2:11: remark: expected a projection for the camera, found none: x and y "
              "in the camera's space are places on the screen, and what lies behind it is drawn\n"
              "\"camera\": {\"position\": [3, 4, 12]}}\n"
              "          ^\n"
              "hint: say \"projection\": {\"type\": \"pinhole\", \"distance\": 1}, or {\"type\": "
              "\"none\"} if that is meant\n");
    for (const char* const projection :
         {R"({"type": "none"})", R"({"type": "pinhole", "distance": 1})"})
        EXPECT_EQ(remarks_on(scene_with(camera + R"(, "projection": )" + projection)), "");
}

// Whether a fill never makes a mistake, or this scene does not show it: who asks for it is told.
TEST(SceneFile, AMistakeIsRemarkedIfAndOnlyIfItChangesNoPixel) {
    int idle = 0;
    int shown = 0;
    for (const char* const fill : {"scanline", "top-left", "barycentric"})
        for (const char* const corner : {"[3, 6]", "[12, 3]"})
            for (const Mistake& mistake : mistakes()) {
                const std::string text =
                    fmt::format(R"({{"canvas": {{"width": 8, "height": 8, "origin": "top-left"}},
"vertices": {{"A": [1, 1], "B": [6, 2], "C": {}}}, "triangles": ["ABC"],
"method": {{"fill": "{}", "scalar": "exact"}}}})",
                                corner, fill);
                const auto right = read_scene({"scene.json", text});
                const auto read =
                    read_scene({"scene.json", text}, {{"mistake", std::string(mistake.name)}});
                ASSERT_TRUE(right) << text;
                if (!read) // it cannot be made here, and is refused
                    continue;
                const Image with = draw(read.value().scene, read.value().plan);
                const Image without = draw(right.value().scene, right.value().plan);
                const bool is_idle = std::ranges::equal(with.colors(), without.colors());
                const auto& remarks = read.value().remarks;
                EXPECT_EQ(remarks.size(), is_idle ? 1U : 0U) << mistake.name << "\n" << text;
                ++(is_idle ? idle : shown);
                if (is_idle && !remarks.empty()) {
                    EXPECT_EQ(
                        remarks[0].message,
                        fmt::format("remark: the mistake \"{}\" changes no pixel of this scene",
                                    mistake.name));
                }
            }
    EXPECT_GT(idle, 100);
    EXPECT_GT(shown, 50);
}

TEST(SceneFile, AFaceThatRoundingMayHaveBentIsNotTold) {
    // The plane z = (x + y)/3, its corners rounded to six digits, and one of them moved.
    const auto remarks = [](const std::string& third, const std::string& two_thirds) {
        return remarks_on(
            R"({"canvas": {"width": 9, "height": 9}, "projection": {"type": "none"}, "meshes": [{
"vertices": {"A": [0, 0, 0], "B": [1, 0, )" +
            third + R"(], "C": [1, 1, )" + two_thirds + R"(], "D": [0, 1, )" + third +
            R"(]},
"faces": ["ABCD"]}]})");
    };
    const auto told = [](const std::string& distance) {
        return "scene.json:3:11: remark: expected faces whose corners lie in one plane, found 1 of "
               "1 face whose corners do not, by up to " +
               distance +
               "; the first is ABCD\n"
               "\"faces\": [\"ABCD\"]}]}\n"
               "          ^\n"
               "hint: it is cut as it is seen along x, y or z, whichever its normal is nearest "
               "to\n";
    };
    EXPECT_EQ(remarks("0.333333", "0.666667"), "");
    EXPECT_EQ(remarks("333333e-6", "6666.67e-4"), "");
    EXPECT_EQ(remarks("0.333333", "0.66668"), "") << "five digits leave more open";
    EXPECT_EQ(remarks("0.333333", "0.666680"), told("3.17e-06"));
    // Nobody has rounded a fraction or a whole number.
    EXPECT_EQ(remarks("\"333333/1000000\"", "\"666667/1000000\""), told("2.26e-07"));
    EXPECT_EQ(remarks("333333", "666667"), told("5.3e-07"));
}

TEST(SceneFile, FacesThatAreNoPolygonAreToldAndStayTheFan) {
    const std::string text = R"({"meshes": [{"name": "tie",
"vertices": {"A": [0, 0], "B": [4, 4], "C": [4, 0], "D": [0, 3], "E": [8, 8]},
"faces": ["ABC", "ABCD", "BCDA", "AEBB"]}]})";
    EXPECT_EQ(
        remarks_on(text),
        "scene.json:3:18: remark: expected faces whose edges do not cross, found 2 faces whose "
        "edges do; in tie.ABCD the edge from tie.A to tie.B meets the one from tie.C to tie.D\n"
        "\"faces\": [\"ABC\", \"ABCD\", \"BCDA\", \"AEBB\"]}]}\n"
        "                 ^\n"
        "hint: it is drawn as the fan of triangles from its first corner\n"
        "scene.json:3:34: remark: expected faces with an area, found 1 face without; the first "
        "is tie.AEBB\n"
        "\"faces\": [\"ABC\", \"ABCD\", \"BCDA\", \"AEBB\"]}]}\n"
        "                                 ^\n"
        "hint: it is drawn as the fan of triangles from its first corner\n");
    EXPECT_THAT(primitives_of(scene_in(text)),
                IsSupersetOf({"tie.ABC tie.A tie.B tie.C", "tie.ACD tie.A tie.C tie.D"}));
}

TEST(SceneFile, AFaceWithTooManyDigitsIsRefused) {
    // Twenty denominators of 601 digits, which have hardly a factor in common.
    std::string vertices;
    std::string face;
    for (int i = 0; i < 20; ++i) {
        const std::string name(1, static_cast<char>('A' + i));
        const std::string above = "1" + std::string(590, '0');
        const std::string below = "1" + std::string(595, '0') + std::to_string(10007 + 2 * i * i);
        vertices += (i == 0 ? "\"" : ",\"") + name + R"(":[")" + above + "/" + below + "\"," +
                    std::to_string(i * i) + "]";
        face += name;
    }
    EXPECT_THAT(
        complaint(R"({"meshes":[{"vertices":{)" + vertices + R"(},"faces":[")" + face + "\"]}]}"),
        HasSubstr("expected a face whose fractions have a common denominator of at most 32768 "
                  "bits, found a longer one"));
}

} // namespace
} // namespace rastertrace
