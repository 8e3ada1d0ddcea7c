// SPDX-License-Identifier: MIT
// "camera": "fit": whatever is there is in view.

#include "effort.h"
#include "random_choice.h"
#include "scene_text.h"
#include "traces.h"

#include <rastertrace/core/draw/draw.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace rastertrace {
namespace {

using testing::HasSubstr;

/// A tetrahedron two units high at the origin.
std::string model_with(const std::string& rest) {
    return R"({"canvas": {"width": 21, "height": 11},
"vertices": {"A": [-1, -1, -1], "B": [1, -1, -1], "C": [0, -1, 1], "D": [0, 1, 0]},
"outlines": ["ABC", "ABD", "BCD", "CAD"], "camera": "fit")" +
           rest + "}";
}

std::string complaint(const std::string& text) {
    const auto scene = read_scene({"scene.json", text});
    return scene ? "no complaint" : to_text(scene.problem());
}

/// True if nothing was cut off, and no pixel dropped.
bool is_in_view(const std::string& trace) {
    for (const std::string_view lost :
         {R"({"step":"clip")", R"({"step":"reject")", R"("why":"off canvas")"})
        if (trace.find(lost) != std::string::npos)
            return false;
    return true;
}

/// A cloud of points somewhere in space, and a box of lines and triangles among them.
std::string random_model(Random& random) {
    const auto place = [&random] {
        std::string text = "[";
        for (const char* end : {",", ",", "]"})
            text += std::to_string(random.whole(-50, 50)) + "e-1" + end;
        return text;
    };
    std::string text = R"({"canvas":{"width":)" + std::to_string(random.whole(9, 60)) +
                       R"(,"height":)" + std::to_string(random.whole(9, 60)) + R"(},"vertices":{)";
    for (char name = 'A'; name <= 'H'; ++name)
        text += std::string(name == 'A' ? "" : ",") + '"' + name + "\":" + place();
    text +=
        R"(},"points":["A","B","C","D","E","F","G","H"],"lines":["AB","CD"],"outlines":["EFG"],)"
        R"("triangles":["AFH","BDH"],"model":[{"rotate":{"axis":"y","degrees":)" +
        std::to_string(random.whole(0, 359)) + "}},{\"translate\":" + place() +
        R"(},{"scale":[1,)" + std::to_string(random.whole(1, 2)) + R"(,1]}],"camera":"fit")";
    const std::string_view projection = random.pick<std::string_view>(
        {"", R"("type":"pinhole","distance":1)", R"("type":"view-plane","distance":"3/2")",
         R"("type":"frustum","fov_y":90,"near":1,"far":"infinity")",
         R"("type":"frustum","left":-1,"right":3,"bottom":-2,"top":1,"near":2,"far":1e3)",
         R"("type":"orthographic","left":-30,"right":30,"bottom":-30,"top":30,"near":1,"far":99)"});
    if (!projection.empty())
        text += R"(,"projection":{)" + std::string(projection) + "}";
    if (random.chance(2) && !projection.empty())
        text += R"(,"viewport":"fit")";
    return text + R"(,"method":{"scalar":")" +
           random.pick<std::string>({"float", "double", "fixed", "adaptive", "exact"}) +
           R"(","depth":"none","fill":")" + random.pick<std::string>({"scanline", "two-halves"}) +
           "\"}}";
}

TEST(FitCamera, EverythingIsInViewAndNotNeedlesslySmall) {
    for (std::uint64_t seed = 0; seed < random_cases(300u); ++seed) {
        Random random(seed);
        const std::string text = random_model(random);
        const Scene scene = scene_in(text);
        const std::string trace = trace_text(scene);
        ASSERT_TRUE(is_in_view(trace)) << text;

        const Canvas& canvas = scene.canvas;
        const Image picture = draw(scene, plan_for(scene));
        int left = canvas.width;
        int right = -canvas.width;
        int first_row = canvas.height;
        int last_row = 0;
        for (int row = 0; row < canvas.height; ++row)
            for (int x = canvas.left(); x <= canvas.right(); ++x)
                if (picture.at({x, canvas.y_of(row)}) != no_color) {
                    left = std::min(left, x);
                    right = std::max(right, x);
                    first_row = std::min(first_row, row);
                    last_row = row;
                }
        // Of an orthographic projection it is the author's box that says how large.
        if (scene.projection.type == ProjectionType::orthographic)
            continue;
        EXPECT_GE(3 * std::max(right - left, last_row - first_row),
                  std::min(canvas.width, canvas.height))
            << text;
    }
}

// What is chosen is plain data: typed into the scene, it gives the same trace.
TEST(FitCamera, IsACameraThatCouldBeTyped) {
    for (std::uint64_t seed = 0; seed < random_cases(100u); ++seed) {
        Random random(seed);
        std::string text = random_model(random);
        const Scene scene = scene_in(text);
        const Camera& camera = *scene.camera;
        const std::string typed = R"("camera":{"position":)" + json_of(camera.position) +
                                  R"(,"look_at":)" + json_of(camera.look_at) + "}";
        const std::string fit = R"("camera":"fit")";
        text.replace(text.find(fit), fit.size(),
                     text.find("projection") == std::string::npos
                         ? typed + R"(,"projection":)" + json_of(scene.projection)
                         : typed);
        EXPECT_EQ(trace_text(scene_in(text)), trace_text(scene)) << text;
    }
}

TEST(FitCamera, TellsWhatItChose) {
    const std::string trace =
        trace_text(scene_in(model_with(R"(, "method": {"scalar": "exact"})")));
    EXPECT_THAT(trace, HasSubstr(R"("projection":"frustum")"));
    // The farthest vertices lie sqrt(3) from the origin: 1.75 / sin(20 degrees) = 5.1166...
    EXPECT_THAT(trace, HasSubstr(R"({"step":"matrix","name":"view")"));
    EXPECT_THAT(trace, HasSubstr(R"("camera":[["0","0","128/25"],["0","0","0"],["0","1","0"]])"));
    // The pinhole looks the other way, from the other side.
    EXPECT_EQ(scene_in(model_with(R"(, "projection": {"type": "pinhole", "distance": 1})"))
                  .camera->position[2]
                  .exact(),
              Rational(-423, 100));
}

TEST(FitCamera, IsOneForAllFrames) {
    const Source source{"scene.json",
                        model_with(R"(, "model": [{"rotate": {"axis": [1, 2, 3], "degrees": 0}},
                                                 {"translate": [0, 0, 0]}],
            "vary": {"/model/0/rotate/degrees": {"from": 0, "to": 330, "steps": 12},
                     "/model/1/translate/0": {"from": -3, "to": 5, "steps": 12}})")};
    SceneSequence sequence(source, {}, {}, {});
    const Camera first = *sequence.frame(1).scene.camera;
    for (std::size_t frame = 1; frame <= sequence.count(); ++frame) {
        const Scene scene = sequence.frame(frame).scene;
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(scene.camera->position[i].exact(), first.position[i].exact()) << frame;
        const std::string trace = trace_text(scene);
        EXPECT_TRUE(is_in_view(trace)) << frame;
        // A frame that is read by itself has it too.
        const auto alone = read_scene(source, {}, {}, {.vary = {}, .frame = frame});
        EXPECT_EQ(trace_text(alone.value().scene), trace) << frame;
    }
}

TEST(FitCamera, WhatCannotBeFittedIsRefused) {
    const auto told = [](const std::string& text) {
        const std::string all = complaint(text);
        return all.substr(0, all.find('\n'));
    };
    const std::string canvas = R"({"canvas": {"width": 9, "height": 9}, "camera": "fit", )";
    EXPECT_EQ(told(canvas + R"("vertices": {"A": [1, 2, 3]}, "points": ["A"]})"),
              "scene.json:1:49: expected vertices in more than one place for a camera that fits, "
              "found all in one");
    EXPECT_EQ(told(canvas + R"("vertices": {}, "points": []})"),
              "scene.json:1:1: expected at least one primitive, found none");
    EXPECT_EQ(
        told(canvas + R"("vertices": {"A": [0, 0, 0], "B": [1e301, 0, 0]}, "lines": ["AB"]})"),
        "scene.json:1:49: expected vertices that are 1e-300 to 1e+300 apart for a camera that "
        "fits, and no farther from the origin; found others");
    EXPECT_EQ(
        told(R"({"vertices": {"A": [0, 0], "B": [1, 1]}, "lines": ["AB"], "camera": "fit"})"),
        "scene.json:1:1: expected a canvas with a width and a height, found none: the picture "
        "is fitted to it");
    EXPECT_EQ(complaint(model_with(R"(,
"projection": {"type": "frustum", "fov_y": 40, "near": 1, "far": 6})")),
              "scene.json:3:53: expected a far from 6.87 on for a camera that fits, found 6\n"
              "\"outlines\": [\"ABC\", \"ABD\", \"BCD\", \"CAD\"], \"camera\": \"fit\",\n"
              "                                                    ^\n"
              "hint: nearer than that, the sides of the view would cut off something");
    EXPECT_EQ(told(model_with(R"(, "projection": {"type": "none"})")),
              "scene.json:3:74: expected a projection that a camera can be fitted to, found "
              "\"none\"");
    EXPECT_EQ(complaint(R"({"vertices": {"A": [1, 2]}, "points": ["A"], "camera": "fti"})"),
              "scene.json:1:56: expected \"fit\" or a camera, like {\"position\": [0, 0, 4]}, "
              "found \"fti\"\n"
              "{\"vertices\": {\"A\": [1, 2]}, \"points\": [\"A\"], \"camera\": \"fti\"}\n"
              "                                                       ^\n"
              "hint: did you mean \"fit\"?");
    // Points in a line have a middle and an end.
    EXPECT_EQ(told(canvas + R"("vertices": {"A": [0, 0, 0], "B": [0, 0, 1]}, "lines": ["AB"]})"),
              "no complaint");
}

} // namespace
} // namespace rastertrace
