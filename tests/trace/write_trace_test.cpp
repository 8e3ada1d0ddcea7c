// SPDX-License-Identifier: MIT
#include "edge_scenes.h"
#include "effort.h"
#include "picture.h"
#include "random_scene.h"
#include "scene_text.h"
#include "traces.h"

#include <rastertrace/trace/record/step_tracer.h>
#include <rastertrace/trace/record/step_writer.h>
#include <rastertrace/trace/scene/scene_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <random>
#include <sstream>
#include <string>

namespace rastertrace {
namespace {

TEST(WriteTrace, AdaptiveTellsWhereDoublesLeaveADecisionOpen) {
    // No fractions of machine size hold A and C, and in row 1 the edge CA is at x = 1.
    const Scene scene = triangle_scene({"0.999999999999999999999999999999", "0", "2", "1",
                                        "1.000000000000000000000000000001", "2"},
                                       {.width = 3, .height = 3, .origin = Origin::bottom_left},
                                       {.scalar = ScalarKind::adaptive});
    const std::string trace = trace_text(scene);
    EXPECT_THAT(trace, testing::HasSubstr(
                           R"("numbers":"doubles within intervals, and fractions of any size")"));
    EXPECT_THAT(trace, testing::HasSubstr(R"({"step":"undecided","name":"ABC","difference":)"));
    EXPECT_THAT(trace, testing::HasSubstr(R"("undecided":1)"));
    // The same scene in numbers that fit: fractions alone.
    const Scene fits = triangle_scene({"0.5", "0", "2", "0", "0", "2"},
                                      {.width = 3, .height = 3, .origin = Origin::bottom_left},
                                      {.scalar = ScalarKind::adaptive});
    const std::string fraction_trace = trace_text(fits);
    EXPECT_THAT(fraction_trace, testing::HasSubstr(R"("numbers":"fractions of 64 bits")"));
    EXPECT_THAT(fraction_trace, testing::HasSubstr(R"("at":[["1/2","0"],["2","0"],["0","2"]])"));
    EXPECT_THAT(fraction_trace, testing::Not(testing::HasSubstr("undecided")));
}

// Both ends of an edge are doubles, and their difference is none: its depths are told exactly.
TEST(WriteTrace, AdaptiveTellsDepthsWhoseDifferenceIsBeyondTheDoubles) {
    for (const char* fill : {"scanline", "two-halves", "barycentric", "top-left"}) {
        const auto read =
            read_scene({"s.json",
                        R"({"canvas":{"width":12,"height":12,"origin":"top-left"},"vertices":{
                 "A":[1.3,1.2,1.7e308],"B":[10.3,2.3,-1.7e308],"C":[4.45,10.1,3],
                 "D":[1.1,2.6,1],"E":[10.7,1.3,2],"F":[5.3,9.2,3]},"triangles":["ABC","DEF"],
                 "method":{"scalar":"adaptive","depth":"linear-z"}})"},
                       {{"fill", fill}});
        ASSERT_TRUE(read) << fill;
        const auto trace = read_trace({"t.json", trace_text(read.value().scene)});
        ASSERT_TRUE(trace) << fill;
        EXPECT_GT(trace.value().size(), 60U) << fill;
    }
}

TEST(WriteTrace, ABackgroundIsToldAndDrawsNothing) {
    Scene scene = first_triangle();
    const std::string without = trace_text(scene);
    scene.background = Color{255, 128, 0};
    std::string with = trace_text(scene);
    const std::string told = R"(,"background":"#ff8000")";
    ASSERT_NE(with.find(told), std::string::npos);
    const auto trace = read_trace({"t.json", with});
    ASSERT_TRUE(trace);
    EXPECT_EQ(trace.value().background, (Color{255, 128, 0}));
    EXPECT_EQ(with.erase(with.find(told), told.size()), without) << "steps, counts and frame";
    std::string wrong = trace_text(scene);
    wrong.replace(wrong.find("#ff8000"), 7, "#ff80");
    const auto refused = read_trace({"t.json", wrong});
    ASSERT_FALSE(refused);
    EXPECT_THAT(to_text(refused.problem()),
                testing::HasSubstr("expected a color like \"#ff8000\", found"));
}

// At the eye and behind it there is no 1/z, whatever is drawn there.
TEST(WriteTrace, NothingIsDividedByADistanceOfNothing) {
    const auto scene_with = [](const std::string& rest, const std::string& scalar) {
        return read_scene({"s.json", R"({"canvas":{"width":8,"height":8,"origin":"top-left"},)" +
                                         rest + R"("method":{"depth":"inverse-z","scalar":")" +
                                         scalar + "\"}}"});
    };
    for (const char* const scalar : {"double", "adaptive", "exact"}) {
        for (const char* const drawn : {R"("points":["A"],)", R"("lines":["AB"],)"})
            for (const bool is_before : {false, true}) {
                const auto scene =
                    scene_with(std::string(R"("vertices":{"A":[1,1,)") + (is_before ? "1" : "0") +
                                   R"(],"B":[3,1,2]},)" + drawn,
                               scalar);
                EXPECT_EQ(bool(scene), is_before) << scalar << drawn;
            }
    }
    // A's distance is 3 z and the way: 0, just above, just below; its double has either sign.
    const auto can_be_drawn = [&](const std::string& z, const std::string& way,
                                  const std::string& scalar) {
        const auto scene = scene_with(
            R"("vertices":{"A":[1,1,)" + z +
                R"(],"B":[6,1,1],"C":[6,5,1]},"model":[{"scale":[3,3,3]},{"translate":[0,0,")" +
                way + R"("]}],"triangles":["ABC"],)",
            scalar);
        if (scene)
            trace_text(scene.value().scene);
        return static_cast<bool>(scene);
    };
    for (const char* const scalar : {"adaptive", "exact"}) {
        EXPECT_FALSE(can_be_drawn("-0.7", "2.1", scalar)) << scalar;
        EXPECT_FALSE(can_be_drawn("-0.7", "2.0999999999999999999", scalar)) << scalar;
        EXPECT_TRUE(can_be_drawn("-0.7", "2.1000000000000000001", scalar)) << scalar;
        EXPECT_TRUE(can_be_drawn("0.7", "-2.0999999999999999999", scalar)) << scalar;
    }
}

/// Multiplies some coordinates by powers of ten, up to the ends of the doubles.
Scene stretched(Scene scene, std::mt19937_64& random) {
    const std::uint64_t reach = random() % 2 == 0 ? 20 : 300;
    for (SceneVertex& vertex : scene.vertices)
        for (Number* const coordinate : {&vertex.x, &vertex.y, &vertex.z})
            if (random() % 3 == 0) {
                const int exponent =
                    static_cast<int>(random() % (2 * reach + 1)) - static_cast<int>(reach);
                const Rational moved = coordinate->exact() * Number::decimal(1, exponent).exact();
                if (std::isfinite(nearest_double(moved)))
                    *coordinate = Number::fraction(moved);
            }
    return scene;
}

TEST(WriteTrace, WhatIsNotRefusedIsJson) {
    EdgeScenes scenes(23);
    std::mt19937_64 random(23);
    int drawn = 0;
    for (int i = 0; i < random_cases(3000); ++i) {
        Scene scene = stretched(scenes.next(), random);
        if (random() % 2 == 0)
            scene.keep = StageSet::all();
        if (scene.method.fill == Fill::fan) // it has no numbers but indices, and may have millions
            scene.method.fill = Fill::barycentric;
        if (find_unfit(scene))
            continue;
        ++drawn;
        std::string text;
        ASSERT_NO_THROW(text = trace_text(scene)) << scene_text(scene);
        const auto trace = read_trace({"trace", text});
        ASSERT_TRUE(trace) << to_text(trace.problem()) << scene_text(scene);
        ASSERT_TRUE(trace.value().damage.empty())
            << to_text(trace.value().damage.front()) << scene_text(scene);
        ASSERT_TRUE(nlohmann::json::accept(text)) << scene_text(scene);
    }
    EXPECT_GT(drawn, random_cases(1000));
}

TEST(WriteTrace, NoInfinityReachesATrace) {
    std::string text;
    StringOutput output(text);
    StepWriter writer(output, TraceLayout::json);
    Arena arena;
    StepTracer<StepWriter> tracer(writer, arena, false);
    const auto write = [&tracer](double value) {
        tracer(EdgeSetUp<>{.edge = {0, 1}, .dx_dy = OrNull<Quantity>(value)});
    };
    EXPECT_THROW(write(HUGE_VAL), Problem);
    EXPECT_THROW(write(std::nan("")), Problem);
    EXPECT_NO_THROW(write(1e308));
}

/// (0,0) (2,0) (0,2) on a canvas of 3x3: left, below and far enough to the right to be cut.
Scene small_scene(Method method = {.scalar = ScalarKind::exact}) {
    Scene scene = triangle_scene({"-1/2", "-1", "3", "-1", "0", "2"},
                                 {.width = 3, .height = 3, .origin = Origin::bottom_left}, method);
    scene.title = "Small";
    scene.primitives[0].color = {255, 128, 0, 255};
    return scene;
}

const std::string small_json =
    R"({"rastertrace":1,"title":"Small","canvas":{"width":3,"height":3,"origin":"bottom-left"},"method":{"scalar":"exact","fill":"scanline","rounding":"floor","lerp":"direct"},"numbers":"fractions of 64 bits","stages":[{"stage":"model","kept":false,"why":"no model moves anything"},{"stage":"view","kept":false,"why":"there is no camera"},{"stage":"clip","kept":false,"why":"nothing bounds the view"},{"stage":"divide","kept":false,"why":"w is 1 at every vertex"},{"stage":"order","kept":false,"why":"the method has no painter"},{"stage":"cull","kept":false,"why":"the method does not ask for it"},{"stage":"light","kept":false,"why":"the method does not ask for it"},{"stage":"canvas","kept":true,"why":"1 of 1 triangle may reach beyond the canvas"},{"stage":"depth","kept":false,"why":"the method has no depth buffer"},{"stage":"perspective","kept":false,"why":"no colors are mixed in a perspective"},{"stage":"colors","kept":false,"why":"no colors are mixed"}],"steps":[
{"step":"primitive","kind":"triangle","name":"ABC","vertices":["A","B","C"],"at":[["-1/2","-1"],["3","-1"],["0","2"]],"color":"#ff8000"},
{"step":"edge","edge":"CA","dx_dy":"1/6"},
{"step":"edge","edge":"AB","dx_dy":null},
{"step":"edge","edge":"CB","dx_dy":"-1"},
{"step":"reject","y":-1,"to_y":-1,"why":"off-canvas"},
{"step":"scanline","y":2,"left":"0","right":"0","from":0,"to":0,"left_edge":"CA","right_edge":"CB"},
{"step":"pixel","x":0,"y":2},
{"step":"scanline","y":1,"left":"-1/6","right":"1","from":-1,"to":1,"left_edge":"CA","right_edge":"CB"},
{"step":"reject","x":-1,"y":1,"why":"off-canvas"},
{"step":"pixel","x":0,"y":1},
{"step":"pixel","x":1,"y":1},
{"step":"scanline","y":0,"left":"-1/3","right":"2","from":-1,"to":2,"left_edge":"CA","right_edge":"CB"},
{"step":"reject","x":-1,"y":0,"why":"off-canvas"},
{"step":"pixel","x":0,"y":0},
{"step":"pixel","x":1,"y":0},
{"step":"pixel","x":2,"y":0}
],
"end":{"steps":16,"count":{"primitive":1,"edge":3,"scanline":3,"pixel":6,"reject":3},"pixels":6,"frame":")";

TEST(WriteTrace, OneDocumentOneStepPerLine) {
    const std::string text = trace_text(small_scene());
    EXPECT_EQ(text.substr(0, small_json.size()), small_json);
    EXPECT_EQ(text.size(), small_json.size() + 16 + 4) << "the frame's name, and \"}}";
    EXPECT_TRUE(text.ends_with("\"}}\n"));
}

/// T4's camera and view plane on 5 x 5 pixels: A is (1, 1, -3) for the camera, B lies behind it.
Scene small_pipeline() {
    Scene scene;
    scene.title = "Pipeline";
    scene.canvas = {.width = 5, .height = 5, .origin = Origin::top_left};
    scene.vertices = {{"A", 0, 1, {}, 1}, {"B", 0, 1, {}, 6}};
    scene.objects = {{"", 2, {Translate{{1, 0, 0}}}}};
    scene.camera = Camera{.position = {0, 0, 4}, .look_at = {0, 0, 0}, .up = {0, 1, 0}};
    scene.projection = {.type = ProjectionType::view_plane, .distance = 1};
    scene.viewport = {.type = ViewportType::pixels, .pixels_per_unit = 1};
    scene.method = {.scalar = ScalarKind::exact, .snap = Snap::floor, .depth = Depth::none};
    scene.primitives = {{.kind = PrimitiveKind::point, .name = "A", .vertices = {0}, .color = {}},
                        {.kind = PrimitiveKind::point, .name = "B", .vertices = {1}, .color = {}}};
    return scene;
}

TEST(WriteTrace, EveryMatrixAndEverySpace) {
    const std::string expected =
        R"({"rastertrace":1,"title":"Pipeline","canvas":{"width":5,"height":5,"origin":"top-left"},"method":{"scalar":"exact","snap":"floor"},"numbers":"fractions of 64 bits","projection":"view-plane","viewport":"fit","stages":[{"stage":"model","kept":true,"why":"a model moves its vertices"},{"stage":"view","kept":true,"why":"the camera moves the world"},{"stage":"clip","plane":"near","kept":true,"why":"1 vertex lies outside it"},{"stage":"clip","plane":"left","kept":true,"why":"1 vertex lies outside it"},{"stage":"clip","plane":"right","kept":true,"why":"1 vertex lies outside it"},{"stage":"clip","plane":"bottom","kept":true,"why":"1 vertex lies outside it"},{"stage":"clip","plane":"top","kept":true,"why":"1 vertex lies outside it"},{"stage":"divide","kept":true,"why":"w is not 1 at every vertex"},{"stage":"order","kept":false,"why":"the method has no painter"},{"stage":"cull","kept":false,"why":"the method does not ask for it"},{"stage":"light","kept":false,"why":"the method does not ask for it"},{"stage":"canvas","kept":false,"why":"no triangle is filled"},{"stage":"depth","kept":false,"why":"the method has no depth buffer"},{"stage":"perspective","kept":false,"why":"no colors are mixed in a perspective"},{"stage":"colors","kept":false,"why":"no colors are mixed"}],"steps":[
{"step":"matrix","name":"model","rows":[["1","0","0","1"],["0","1","0","0"],["0","0","1","0"],["0","0","0","1"]],"factors":["translate"],"factor_rows":[["1","0","0","1"],["0","1","0","0"],["0","0","1","0"],["0","0","0","1"]]},
{"step":"matrix","name":"view","rows":[["1","0","0","0"],["0","1","0","0"],["0","0","1","-4"],["0","0","0","1"]],"factors":["rotate","translate"],"factor_rows":[["1","0","0","0"],["0","1","0","0"],["0","0","1","0"],["0","0","0","1"],["1","0","0","0"],["0","1","0","0"],["0","0","1","-4"],["0","0","0","1"]],"camera":[["0","0","4"],["0","0","0"],["0","1","0"]]},
{"step":"matrix","name":"projection","rows":[["1","0","0","0"],["0","1","0","0"],["0","0","1","1"],["0","0","-1","0"]],"factors":["perspective","translate"],"factor_rows":[["1","0","0","0"],["0","1","0","0"],["0","0","1","0"],["0","0","-1","1"],["1","0","0","0"],["0","1","0","0"],["0","0","1","1"],["0","0","0","1"]]},
{"step":"matrix","name":"viewport","rows":[["2","0","0","2"],["0","-2","0","2"],["0","0","1","0"],["0","0","0","1"]],"factors":["scale","translate","flip"],"factor_rows":[["2","0","0","0"],["0","2","0","0"],["0","0","1","0"],["0","0","0","1"],["1","0","0","1"],["0","1","0","1"],["0","0","1","0"],["0","0","0","1"],["1","0","0","0"],["0","-1","0","0"],["0","0","1","0"],["0","0","0","1"]]},
{"step":"vertex","name":"A","space":"object","at":["0","1","1"]},
{"step":"vertex","name":"A","space":"world","at":["1","1","1"]},
{"step":"vertex","name":"A","space":"camera","at":["1","1","-3"]},
{"step":"vertex","name":"A","space":"clip","at":["1","1","-2","3"]},
{"step":"vertex","name":"A","space":"canonical","at":["1/3","1/3","-2/3"]},
{"step":"vertex","name":"A","space":"screen","at":["8/3","4/3"],"snapped":["2","1"]},
{"step":"vertex","name":"B","space":"object","at":["0","1","6"]},
{"step":"vertex","name":"B","space":"world","at":["1","1","6"]},
{"step":"vertex","name":"B","space":"camera","at":["1","1","2"]},
{"step":"vertex","name":"B","space":"clip","at":["1","1","3","-2"]},
{"step":"primitive","kind":"point","name":"A","vertices":["A"],"at":[["2","1"]],"color":"#000000"},
{"step":"pixel","x":2,"y":1},
{"step":"primitive","kind":"point","name":"B","vertices":["B"],"color":"#000000"},
{"step":"clip","name":"B","plane":"near","inside":[false],"out":0},
{"step":"skip","name":"B","why":"behind the eye"}
],
"end":{"steps":19,"count":{"matrix":4,"vertex":10,"primitive":2,"clip":1,"pixel":1,"skip":1},"pixels":1,"frame":")";
    EXPECT_EQ(trace_text(small_pipeline()).substr(0, expected.size()), expected);

    // In float, numbers read back to the same float.
    Scene in_float = small_pipeline();
    in_float.method.scalar = ScalarKind::single_precision;
    EXPECT_NE(
        trace_text(in_float).find(R"("space":"canonical","at":[0.33333334,0.33333334,-0.6666667])"),
        std::string::npos);
}

TEST(WriteTrace, HeaderSaysThatIrrationalEntriesAreDoubles) {
    Scene scene = small_pipeline();
    EXPECT_EQ(trace_text(scene).find("matrices"), std::string::npos);
    scene.objects[0].model = {Rotate{{0, 0, 1}, 45}};
    EXPECT_NE(trace_text(scene).find(R"("matrices":"irrational entries are the nearest doubles")"),
              std::string::npos);
}

TEST(WriteTrace, JsonLinesHoldTheSameSteps) {
    std::string expected = trace_text(small_scene());
    const auto replace = [&expected](const std::string& from, const std::string& to) {
        for (auto at = expected.find(from); at != std::string::npos; at = expected.find(from))
            expected.replace(at, from.size(), to);
    };
    replace(",\"steps\":[\n", "}\n");
    replace("\n],\n", "\n{");
    replace("},\n", "}\n");
    EXPECT_EQ(trace_text(small_scene(), {.layout = TraceLayout::jsonl, .filter = {}}), expected);
}

TEST(WriteTrace, FrameIsNamedByFnv1aOfItsBytes) {
    // Two pixels, one of them drawn #ff8000: FNV-1a of 00 00 00 00 ff 80 00 ff, worked by hand in
    // 64-bit arithmetic: h = (h ^ byte) * 0x100000001b3, from 0xcbf29ce484222325.
    Image image({.width = 2, .height = 1, .origin = Origin::top_left});
    image.at({1, 0}) = {255, 128, 0, 255};
    EXPECT_EQ(frame_name(image), "78ef2f8890c7e023");
}

TEST(WriteTrace, InDoubleQuantitiesAreNumbers) {
    const std::string text = trace_text(small_scene({}));
    EXPECT_NE(text.find(R"("dx_dy":0.16666666666666666})"), std::string::npos);
    EXPECT_NE(text.find(R"("left":-0.16666666666666666,"right":1,)"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("at":[[-0.5,-1],[3,-1],[0,2]])"), std::string::npos);
}

TEST(WriteTrace, TiesAreSaidOnlyWhenTheyAreInForce) {
    EXPECT_NE(trace_text(small_scene({.rounding = Rounding::nearest}))
                  .find(R"("rounding":"nearest","ties":"up","lerp")"),
              std::string::npos);
    EXPECT_EQ(trace_text(small_scene()).find("ties"), std::string::npos);
}

TEST(WriteTrace, OnlySomeKinds) {
    const TraceOptions options{
        .layout = TraceLayout::jsonl,
        .filter = {.only = {{StepKind::scanline, StepKind::skip}}, .region = {}}};
    const std::string text = trace_text(small_scene(), options);
    EXPECT_NE(text.find(R"("only":["scanline","skip"]})"), std::string::npos);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1 + 3 + 1);
    EXPECT_NE(text.find(R"({"end":{"steps":3,"count":{"scanline":3},"pixels":6,)"),
              std::string::npos)
        << "the picture is the whole one";
}

TEST(WriteTrace, WhoTakesNoPixelsIsToldTheSameSkipsOfTheSamePicture) {
    /// The skipped primitives of a trace, and what its end says of the picture.
    const auto told = [](const Scene& scene, const StepFilter& filter) {
        std::istringstream lines(
            trace_text(scene, {.layout = TraceLayout::jsonl, .filter = filter}));
        std::string result;
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with(R"({"step":"skip")"))
                result += line + "\n";
            else if (line.starts_with(R"({"end":)"))
                result += line.substr(line.find(R"("pixels":)"));
        return result;
    };
    std::size_t skipped = 0;
    for (std::uint64_t seed = 0; seed < random_cases(300U); ++seed) {
        const std::string text = RandomScene(seed).text();
        const auto read = read_scene({"random.json", text});
        if (!read)
            continue;
        const std::string all = told(read.value().scene, {});
        skipped += all.starts_with("{") ? 1 : 0;
        ASSERT_EQ(told(read.value().scene, {.only = {{StepKind::skip}}}), all) << text;
    }
    EXPECT_GT(skipped, random_cases(300U) / 15);
}

TEST(WriteTrace, OnlyAPrimitiveAndItsParts) {
    Scene scene = small_scene();
    scene.vertices.push_back({"D", 0, 0, {}});
    scene.primitives.push_back(
        {.kind = PrimitiveKind::point, .name = "ABCD", .vertices = {3}, .color = {}});
    const TraceOptions options{.layout = TraceLayout::json, .filter = {.primitive = "ABCD"}};
    std::string text;
    StringOutput output(text);
    write_trace(scene, options, output);
    EXPECT_THAT(text, testing::HasSubstr(R"("primitive":"ABCD","steps":[
{"step":"primitive","kind":"point","name":"ABCD","vertices":["D"],"at":[["0","0"]],"color":"#000000"},
{"step":"pixel","x":0,"y":0}
],)"));
}

TEST(WriteTrace, OnlyARegion) {
    const TraceOptions options{.layout = TraceLayout::jsonl,
                               .filter = {.only = {}, .region = Region{1, 0, 2, 0}}};
    const std::string text = trace_text(small_scene(), options);
    EXPECT_NE(text.find(R"("region":[1,0,2,0]})"), std::string::npos);
    EXPECT_NE(text.find(R"("count":{"primitive":1,"edge":3,"scanline":1,"pixel":2})"),
              std::string::npos)
        << text;
}

TEST(WriteTrace, NamesAreEscaped) {
    Scene scene = small_scene();
    scene.title = "a\"\x1b]0;x\x07\n";
    scene.vertices[0].name = "\xC2\x9B";
    const std::string text = trace_text(scene);
    for (const char c : text)
        EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20);
    EXPECT_NE(text.find(R"("title":"a\"\u001b]0;x\u0007\n")"), std::string::npos);
    EXPECT_NE(text.find(R"("edge":"C\u009b")"), std::string::npos);
}

/// Refuses everything behind the first `room` bytes, as a full disk does.
class FullOutput final : public Output {
public:
    explicit FullOutput(std::size_t room) : room_(room) {}
    void write(std::string_view bytes) override {
        if (bytes.size() > room_)
            throw problem_of("disk", "full");
        room_ -= bytes.size();
    }

private:
    std::size_t room_;
};

TEST(WriteTrace, AFullOutputStopsIt) {
    const std::string whole = trace_text(small_scene());
    FullOutput enough(whole.size());
    EXPECT_NO_THROW(write_trace(small_scene(), {}, enough));
    FullOutput too_small(whole.size() - 1);
    EXPECT_THROW(write_trace(small_scene(), {}, too_small), Problem);
}

TEST(WriteTrace, MemoryDoesNotGrowWithTheSteps) {
    // A picture of a million pixels, a trace of 30 MB: never more than one buffer at a time.
    class LargestWrite final : public Output {
    public:
        void write(std::string_view bytes) override {
            largest = std::max(largest, bytes.size());
            total += bytes.size();
        }
        std::size_t largest = 0, total = 0;
    };
    LargestWrite output;
    write_trace(triangle_scene({"-500", "-500", "1500", "-500", "-500", "1500"},
                               {.width = 1000, .height = 1000}, {}),
                {}, output);
    EXPECT_GT(output.total, 20'000'000u);
    EXPECT_LT(output.largest, 1'000'000u);
}

TEST(WriteTrace, CutFacesAreToldFirstAndExactly) {
    const auto first_step = [](const std::string& scalar) {
        const std::string text = trace_text(scene_in(
            R"({"meshes":[{"name":"m","vertices":{"A":[0,0],"B":[4,0],"C":[0.1,1],"D":["1/3",4]},
                "faces":["BCDA"]}],"camera":{"position":[0,0,9]},"canvas":{"width":9,"height":9},
                "method":{"scalar":")" +
            scalar + "\"}}"));
        const std::size_t begin = text.find('\n') + 1;
        return text.substr(begin, text.find('\n', begin) - begin);
    };
    const std::string begin =
        R"({"step":"triangulate","name":"m.BCDA","vertices":["m.B","m.C","m.D","m.A"],"at":[)";
    const std::string end = R"(],"drops":"z","ears":["m.ABC","m.CDA"]},)";
    const std::string in_fractions =
        begin +
        R"(["4","0","0"],["1/10","1","0"],["1/3","4","0"],["0","0","0"]],"normal":["0","0","61/15")" +
        end;
    for (const std::string scalar : {"exact", "fixed", "adaptive", "double", "float"})
        EXPECT_EQ(first_step(scalar), in_fractions) << scalar;
}

} // namespace
} // namespace rastertrace
