// SPDX-License-Identifier: MIT
#include "effort.h"
#include "languages.h"
#include "random_choice.h"
#include "random_scene.h"
#include "traces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <numeric>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using nlohmann::json;

/// What is said of a triangle's scene with this "vary", and of these variations of a command line.
std::string complaint_about(const std::string& vary, const std::vector<Variation>& given = {},
                            std::size_t frame = 1) {
    const Source source{"scene.json", R"({"canvas": {"width": 9, "height": 9},
"vertices": {"A": [0, 3], "B": [-3, "-5/2"], "C/~": [3, -3]}, "triangles": [["A", "B", "C/~"]],
"model": [{"rotate": {"axis": "z", "degrees": 0}}],
"vary": )" + vary + "}"};
    const auto read = read_scene(source, {}, {}, {.vary = given, .frame = frame});
    return read ? "no complaint" : to_text(read.problem());
}

/// The pointers to all numbers of a scene.
std::vector<std::string> numbers_of(const json& scene) {
    std::vector<std::string> pointers;
    const json flat = scene.flatten();
    for (const auto& [pointer, value] : flat.items())
        if (value.is_number())
            pointers.push_back(pointer);
    return pointers;
}

/// A fraction as an author types it.
json typed(int above, int below) {
    const int divisor = std::gcd(above, below);
    if (below == divisor)
        return above / divisor;
    return std::to_string(above / divisor) + '/' + std::to_string(below / divisor);
}

// The promise of the whole: no trace of a frame differs from that of the scene with its number typed.
TEST(Vary, AFrameIsTheSceneWithItsNumberTyped) {
    int drawn = 0;
    int refused = 0;
    for (std::uint64_t seed = 0; seed < random_cases(200u); ++seed) {
        json scene = json::parse(RandomScene(seed).text());
        const auto pointers = numbers_of(scene);
        Random random(seed);
        const json::json_pointer pointer(pointers[static_cast<std::size_t>(
            random.whole(0, static_cast<int>(pointers.size()) - 1))]);
        const int from = random.whole(-6, 20);
        const int to = random.whole(-6, 20);
        const int steps = random.whole(2, 5);

        json varied = scene;
        varied["vary"][pointer.to_string()] = {{"from", from}, {"to", to}, {"steps", steps}};
        const Source source{"scene.json", varied.dump()};
        for (int i = 0; i < steps; ++i) {
            scene[pointer] = typed(from * (steps - 1) + (to - from) * i, steps - 1);
            const auto expected = read_scene({"scene.json", scene.dump()});
            const auto frame =
                read_scene(source, {}, {}, {.vary = {}, .frame = static_cast<std::size_t>(i) + 1});
            ASSERT_EQ(!!frame, !!expected) << source.text << " frame " << i + 1;
            if (!frame) {
                ++refused;
                continue;
            }
            ++drawn;
            ASSERT_EQ(trace_text(frame.value().scene), trace_text(expected.value().scene))
                << source.text << " frame " << i + 1;
        }
    }
    EXPECT_GT(drawn, random_cases(200)) << "most frames can be drawn";
    EXPECT_GT(refused, 0) << "and some cannot";
}

TEST(Vary, FramesOfAListAndOfACommandLine) {
    const Source source{"scene.json", R"({"canvas": {"width": 9, "height": 9},
        "vertices": {"A": [0, 3], "B": [-3, -3], "C": [3, -3]}, "triangles": ["ABC"],
        "vary": {"/vertices/A/0": [0, "1/3", 2.50], "/vertices/B/0": {"from": -3, "to": -2, "steps": 3}}})"};
    SceneSequence sequence(source, {}, {}, {});
    ASSERT_EQ(sequence.count(), 3u);
    EXPECT_EQ(sequence.label(1), "1 of 3: A/0 0, B/0 -3");
    EXPECT_EQ(sequence.label(2), "2 of 3: A/0 1/3, B/0 -2.5");
    EXPECT_EQ(sequence.label(3), "3 of 3: A/0 2.5, B/0 -2");
    {
        const TellingIn portuguese(Language::portuguese);
        EXPECT_EQ(sequence.label(3), "3 de 3: A/0 2.5, B/0 -2");
    }
    EXPECT_EQ(sequence.frame(3).scene.vertices[0].x.exact().get_str(), "5/2");
    EXPECT_EQ(sequence.frame(2).scene.vertices[0].x.exact().get_str(), "1/3")
        << "frames may be read in any order";

    // The command line's take the place of the scene's; others join them.
    SceneSequence other(source, {}, {},
                        {{"/vertices/A/0", "-1,0.001,1e3"},
                         {"/vertices/B/0", "7:8:3"},
                         {"/canvas/width", "9:11:3"}});
    EXPECT_EQ(other.label(2), "2 of 3: A/0 0.001, B/0 7.5, width 10");
    EXPECT_EQ(other.frame(2).scene.canvas.width, 10);

    SceneSequence one(source, {}, {}, {{"/vertices/A/0", "4:9:1"}, {"/vertices/B/0", "5"}});
    EXPECT_EQ(one.count(), 1u);
    EXPECT_EQ(one.frame(1).scene.vertices[0].x.exact(), 4) << "one step is the first value";
}

// A model's matrix is kept from one frame to the next as long as the model stays as it is.
TEST(Vary, EachFrameHasItsOwnModels) {
    const Source source{"scene.json", R"({"canvas": {"width": 9, "height": 9},
        "vertices": {"A": [0, 3], "B": [-3, -3], "C": [3, -3]}, "triangles": ["ABC"],
        "model": [{"rotate": {"axis": "z", "degrees": 30}}, {"translate": [0, 0, 1]}],
        "meshes": [{"name": "one", "model": [{"scale": [2, 2, 2]}], "vertices": {"A": [0, 3], "B": [-3, -3], "C": [3, -3]}, "faces": ["ABC"]},
                   {"name": "two", "vertices": {"A": [0, 3], "B": [-3, -3], "C": [3, -3]}, "faces": ["ABC"]}],
        "vary": {"/model/0/rotate/degrees": [30, 30, 90, 30], "/model/1/translate/2": [1, 1, 1, 2],
                 "/meshes/0/model/0/scale/0": [2, 0.5, "1/2", 2]}})"};
    SceneSequence sequence(source, {}, {}, {});
    for (const std::size_t n : {1u, 2u, 3u, 4u, 2u, 2u, 1u, 4u, 3u}) {
        const Scene scene = sequence.frame(n).scene;
        ASSERT_EQ(scene.objects.size(), 3u);
        const Number degrees = n == 3 ? 90 : 30;
        const Model own{Rotate{{0, 0, 1}, degrees}, Translate{{0, 0, n == 4 ? 2 : 1}}};
        const Model scaled{Scale{{n == 1 || n == 4 ? Number(2) : Number::decimal(5, -1), 2, 2}}};
        EXPECT_TRUE(scene.objects[0].model.matrix() == own.matrix()) << n;
        EXPECT_TRUE(scene.objects[1].model.matrix() == scaled.matrix()) << n;
        EXPECT_TRUE(scene.objects[2].model.matrix() == identity<Rational>()) << n;
    }
}

TEST(Vary, NumbersOfOneShortNameAreToldByTheirPointers) {
    const Source source{"scene.json", R"({"canvas": {"width": 9, "height": 9},
        "vertices": {"A": [0, 3]}, "points": ["A"],
        "model": [{"rotate": {"axis": "x", "degrees": 0}}, {"rotate": {"axis": "y", "degrees": 0}}],
        "vary": {"/model/0/rotate/degrees": [1], "/model/1/rotate/degrees": [2]}})"};
    EXPECT_EQ(SceneSequence(source, {}, {}, {}).label(1),
              "1 of 1: /model/0/rotate/degrees 1, /model/1/rotate/degrees 2");
}

TEST(Vary, SlashesAndTildesOfKeysAreEscaped) {
    EXPECT_EQ(complaint_about(R"({"/vertices/C~1~0/0": [1, 2]})", {}, 2), "no complaint");
    EXPECT_THAT(complaint_about(R"({"/vertices/C~2/0": [1, 2]})"),
                testing::HasSubstr("expected ~0 or ~1 (a tilde or a slash in a key), found "
                                   "\"C~2\"\n"));
}

TEST(Vary, WhatIsNoNumberOfTheSceneIsRefused) {
    EXPECT_EQ(
        complaint_about(R"({"/model/0/rotate/degree": [1, 2]})"),
        "scene.json:4:10: expected a key of /model/0/rotate: axis, degrees, found \"degree\"\n"
        "\"vary\": {\"/model/0/rotate/degree\": [1, 2]}}\n"
        "         ^\n"
        "hint: did you mean degrees?");
    const auto told = [](const std::string& pointer) {
        const std::string text = complaint_about("{\"" + pointer + "\": [1, 2]}");
        const std::size_t begin = text.find(": expected") + 2;
        return text.substr(begin, text.find('\n') - begin);
    };
    EXPECT_EQ(told("/canvas"), "expected a number at /canvas, found an object");
    EXPECT_EQ(told("/model/0/rotate/axis"),
              "expected a number at /model/0/rotate/axis, found \"z\"");
    EXPECT_EQ(told("/model/0/rotate/axis/0"),
              "expected the pointer to end at /model/0/rotate/axis, which is \"z\", found \"0\" "
              "behind it");
    EXPECT_EQ(told("/model/1"), "expected an index of /model: 0 to 0, found \"1\"");
    EXPECT_EQ(told("/vertices/A/00"), "expected an index of /vertices/A: 0 to 1, found \"00\"");
    EXPECT_EQ(told("/vertices/A/-"), "expected an index of /vertices/A: 0 to 1, found \"-\"");
    EXPECT_EQ(told("vertices/A/0"),
              "expected a JSON Pointer, which begins with '/', found \"vertices/A/0\"");
    EXPECT_EQ(told("/vary/0"), "expected a number that is drawn by, found one of \"vary\"");
    EXPECT_EQ(told("/vertices/D/0"), "expected a key of /vertices: A, B, C/~, found \"D\"");
    EXPECT_EQ(complaint_about(R"({"/vertices/B/1": [1, 2]})"), "no complaint")
        << "a fraction is a number";
}

TEST(Vary, WhatIsNoSequenceIsRefused) {
    const auto told = [](const std::string& values) {
        const std::string text = complaint_about("{\"/canvas/width\": " + values + "}");
        return text.substr(0, text.find('\n'));
    };
    EXPECT_EQ(told("5"), "scene.json:4:27: expected {\"from\": 0, \"to\": 345, \"steps\": 24} or a "
                         "list of numbers, found 5");
    EXPECT_EQ(told("[]"), "scene.json:4:27: expected {\"from\": 0, \"to\": 345, \"steps\": 24} or "
                          "a list of numbers, found an empty array");
    EXPECT_EQ(told("[1, true]"), "scene.json:4:31: expected a number, found true");
    for (const std::string steps : {"0", "-1", "1.5", "\"3/2\"", "100001"})
        EXPECT_EQ(told("{\"from\": 1, \"to\": 2, \"steps\": " + steps + "}"),
                  "scene.json:4:57: expected a whole number of steps from 1 to 100000, found " +
                      steps);
    EXPECT_EQ(told(R"({"from": 1, "to": 2})"),
              "scene.json:4:27: expected the key \"steps\", found none");
    EXPECT_EQ(told(R"({"from": 1, "until": 2})"),
              "scene.json:4:39: expected a key out of from, to, steps, found \"until\"");

    EXPECT_THAT(
        complaint_about(R"({"/canvas/width": [7, 9], "/canvas/height": [7, 8, 9]})"),
        testing::HasSubstr(":35: expected as many values as /canvas/width has, 2; found 3\n"));
    EXPECT_EQ(complaint_about(R"({"/canvas/width": [7, 9]})", {{"/canvas/height", "1:2:3"}}),
              "--vary: expected as many values as /canvas/width has, 2; found 3");
    EXPECT_EQ(complaint_about("{}", {{"/canvas/width", "7"}, {"/canvas/width", "8"}}),
              "--vary: expected each number once, found /canvas/width again");
    EXPECT_EQ(complaint_about("{}", {{"/canvas/with", "7"}}),
              "--vary: expected a key of /canvas: width, height, found \"with\"\n"
              "hint: did you mean width?");
    EXPECT_EQ(complaint_about("{}", {{"/canvas/width", "7:8"}}),
              "--vary: expected FROM:TO:STEPS or a list of values, found \"7:8\"\n"
              "hint: like 4:1:7, or 4,3,2");
}

TEST(Vary, AFaultOfAFrameStandsWhereTheNumberIsTyped) {
    EXPECT_EQ(complaint_about(R"({"/canvas/width": [9, 8.5]})"), "no complaint");
    EXPECT_EQ(complaint_about(R"({"/canvas/width": [9, 8.5]})", {}, 2),
              "scene.json:1:22: expected a whole number of pixels from 1 to 16384, found 8.5, in "
              "frame 2 of 2: width 8.5\n"
              "{\"canvas\": {\"width\": 9, \"height\": 9},\n"
              "                     ^");
    EXPECT_EQ(complaint_about(R"({"/canvas/width": [9, 8]})", {}, 3),
              "scene.json: expected a frame from 1 to 2, found frame 3");
    EXPECT_EQ(complaint_about("{}", {}, 2),
              "scene.json: expected a frame from 1 to 1, found frame 2\n"
              "hint: \"vary\" in the scene, or --vary, makes more frames");
}

} // namespace
} // namespace rastertrace
