// SPDX-License-Identifier: MIT
// The picture in space: where the trace has the eye, the view plane and the vertices, and what a step adds.
#include "drawings.h"
#include "space_sheet.h"

#include <rastertrace/figures/page.h>
#include <rastertrace/figures/space_frames.h>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using testing::Contains;
using testing::IsSupersetOf;
using testing::UnorderedElementsAre;

Trace trace_of_example(const std::string& name) {
    const std::string path = std::string(RASTERTRACE_EXAMPLES) + "/" + name + ".json";
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto read = read_scene({path, text});
    if (!read) {
        ADD_FAILURE() << to_text(read.problem());
        return {};
    }
    return readable_trace(trace_text(read.value(), {}));
}

/// The examples in space, but for the large ones.
const std::vector<std::string> in_space{
    "mistakes/affine",           "mistakes/camera",          "mistakes/ground",
    "t0-hidden/cube-culled",     "t0-hidden/cube-inverse-z", "t0-hidden/cube-painter",
    "t0-hidden/two-cubes",       "t0-projection/box",        "t0-projection/cube",
    "t1-hidden/along-z",         "t1-hidden/three-angles",   "t4-pipeline/behind-the-eye",
    "t4-pipeline/camera-points", "t4-pipeline/fit",          "t4-pipeline/six-spaces"};

Drawing in_space_at(const Trace& trace, const std::string& selector) {
    return figure_at(trace, selector, {.is_in_space = true});
}

double distance(const Position& a, const Position& b) {
    return glm::length(a - b);
}

TEST(Space, LinesOfSightLeadFromTheScreenToTheVertices) {
    for (const std::string& name : in_space) {
        const auto space = space_of(trace_of_example(name));
        ASSERT_TRUE(space && space->camera) << name;
        std::size_t images = 0;
        for (const auto& [vertex, image] : space->images) {
            const Position at = space->vertices.at(vertex);
            const Position seen = space->camera->at(image, space->camera->depth_of(at));
            EXPECT_LT(distance(seen, at), 1e-9 * (1 + glm::length(at))) << name << " " << vertex;
            ++images;
        }
        EXPECT_GT(images, 0U) << name;
    }
}

TEST(Space, TheEyeAndThePlanesAreThoseOfTheScene) {
    // The camera of T4 stands at (0, 0, 4), its view plane 1 in front of it: z = -1 in its own space.
    const auto six = space_of(trace_of_example("t4-pipeline/six-spaces"));
    EXPECT_LT(distance(*six->camera->eye(), {0, 0, 4}), 1e-12);
    EXPECT_DOUBLE_EQ(six->camera->plane_z(), -1);
    EXPECT_EQ(six->camera->near_z(), std::nullopt);
    // The pinhole stands in the origin and looks along +z.
    const auto cube = space_of(trace_of_example("t0-projection/cube"));
    EXPECT_LT(distance(*cube->camera->eye(), {0, 0, 0}), 1e-12);
    EXPECT_DOUBLE_EQ(cube->camera->plane_z(), 1);
    EXPECT_EQ(cube->camera->forward(), 1);
    // "near": 1, "far": 17
    const auto wing = space_of(trace_of_example("t4-pipeline/behind-the-eye"));
    EXPECT_DOUBLE_EQ(wing->camera->near_z().value(), -1);
    EXPECT_NEAR(wing->camera->far_z().value(), -17, 1e-12);
    // Parallel lines of sight meet nowhere.
    const auto along = space_of(trace_of_example("t1-hidden/along-z"));
    EXPECT_EQ(along->camera->eye(), std::nullopt);
    EXPECT_EQ(along->camera->near_z(), std::nullopt);
    const auto box = space_of(trace_of_scene(R"({"canvas": {"width": 9, "height": 9},
        "vertices": {"A": [0, 0, -3], "B": [2, 0, -3], "C": [0, 2, -4]}, "triangles": ["ABC"],
        "projection": {"type": "orthographic", "left": -2, "right": 2, "bottom": -2, "top": 2,
                       "near": 1, "far": 6}})"));
    EXPECT_NEAR(box->camera->near_z().value(), -1, 1e-12);
    EXPECT_NEAR(box->camera->far_z().value(), -6, 1e-12);
}

TEST(Space, AVertexThatClippingMadeLiesOnItsEdge) {
    // B(-1, -1, -2) and C(1, -1, 2): the plane z = -1 cuts a quarter off.
    const auto space = space_of(trace_of_example("t4-pipeline/behind-the-eye"));
    EXPECT_LT(distance(space->vertices.at("wing:1"), {-0.5, -1, -1}), 1e-12);
    EXPECT_LT(distance(space->vertices.at("wing:2"), {0.25, 0.5, -1}), 1e-12);
    const Drawing figure = in_space_at(trace_of_example("t4-pipeline/behind-the-eye"), "clip");
    EXPECT_THAT(texts_of(figure, Role::normal), testing::ElementsAre("t = 1/4", "t = 1/4"));
    EXPECT_THAT(texts_of(figure, Role::quiet_text), IsSupersetOf({"inside", "outside"}));
}

TEST(Space, ThePixelOfADepthTestHasTheFacesOnItsLineOfSightTheNearestFirst) {
    // T0's cube of side 2 from z = 3 to 5: the middle of the screen sees the front, then the back.
    const Drawing figure =
        in_space_at(trace_of_example("t0-hidden/cube-inverse-z"), "depth x=0 y=0 fail");
    const auto texts = texts_of(figure, Role::normal);
    ASSERT_EQ(texts.size(), 4U); // in the middle of both diagonals
    EXPECT_THAT((std::vector{texts[0].substr(3), texts[1].substr(3)}),
                UnorderedElementsAre("ABC", "ACD"));
    EXPECT_THAT((std::vector{texts[2].substr(3), texts[3].substr(3)}),
                UnorderedElementsAre("EHG", "EGF"));
    EXPECT_EQ(texts[0].substr(0, 3), "1. ");
    EXPECT_EQ(texts[3].substr(0, 3), "4. ");
}

TEST(Space, TheViewPlaneIsAsLargeAsTheCanvas) {
    // The pinhole sees a plane of 1 x 1 at z = 1: ten pixels, from -5.5 to 4.5 of them.
    const Trace cube = trace_of_example("t0-projection/cube");
    const auto space = space_of(cube);
    const auto window = SpaceSheet(*space, cube, {}, 300, 300).window_at(1);
    EXPECT_LT(distance(window[0], {-0.55, 0.55, 1}), 1e-12);
    EXPECT_LT(distance(window[2], {0.45, -0.45, 1}), 1e-12);
    // Elsewhere in the world: its middle lies 2 of 13 units on the way to what is looked at.
    const Trace trace = trace_of_scene(R"({"canvas": {"width": 8, "height": 8},
        "vertices": {"A": [0, 0, 0], "B": [1, 0, 0], "C": [0, 1, 0]}, "triangles": ["ABC"],
        "camera": {"position": [3, 4, 12], "look_at": [0, 0, 0], "up": [0, 1, 0]},
        "projection": {"type": "view-plane", "distance": 2}, "viewport": {"pixels": "edges"},
        "method": {"fill": "top-left", "sample": "center"}})");
    const auto moved = space_of(trace);
    EXPECT_LT(distance(*moved->camera->eye(), {3, 4, 12}), 1e-12);
    Position middle{};
    for (const Position& corner :
         SpaceSheet(*moved, trace, {}, 300, 300).window_at(moved->camera->plane_z()))
        middle += corner / 4.0;
    EXPECT_LT(distance(middle, Position{3, 4, 12} * (11.0 / 13)), 1e-9);
}

TEST(Space, SidesAndNormalsOfCulledFacesAreDashed) {
    // Two of the twelve triangles face the eye: they have five sides.
    const Drawing figure =
        whole_figure(trace_of_example("t0-hidden/cube-culled"), {.is_in_space = true});
    EXPECT_EQ(shapes_of<Lines>(figure, Role::true_edge).size(), 5U);
    EXPECT_EQ(shapes_of<Lines>(figure, Role::other_edge).size(), 13U);
    EXPECT_EQ(shapes_of<Lines>(figure, Role::normal).size(), 2U);
    EXPECT_EQ(shapes_of<Lines>(figure, Role::culled_normal).size(), 10U);
}

TEST(Space, TheNumbersOfAVertexAreThoseOfItsSpace) {
    const Trace trace = trace_of_example("t4-pipeline/six-spaces");
    for (const auto& [space, numbers] :
         {std::pair("object", "(1, 1, 1)"), std::pair("world", "(0, 2, 1)"),
          std::pair("camera", "(0, 2, -3)"), std::pair("clip", "(0, 2, -2, 3)"),
          std::pair("canonical", "(0, 2/3, -2/3)"), std::pair("screen", "(20, 10/3)")})
        EXPECT_THAT(texts_of(in_space_at(trace, fmt::format("vertex name=A space={}", space)),
                             Role::normal),
                    Contains(numbers));
}

TEST(Space, FromTheSideTheViewPlaneIsALine) {
    const Trace trace = trace_of_example("t0-projection/cube");
    const auto plane = [&](std::string_view eye) {
        const Drawing figure =
            whole_figure(trace, {.is_in_space = true, .eye = space_eye_named(eye).value()});
        return shapes_of<Lines>(figure, Role::view_plane).front().paths.front();
    };
    for (const Place corner : plane("side"))
        EXPECT_NEAR(corner.x, plane("side")[0].x, 1e-9);
    for (const Place corner : plane("top"))
        EXPECT_NEAR(corner.y, plane("top")[0].y, 1e-9);
    // From the front it is upright, as the picture shows it: the second corner is at the right, the third below.
    const Path front = plane("front");
    EXPECT_GT(front[1].x, front[0].x);
    EXPECT_NEAR(front[1].y, front[0].y, 1e-9);
    EXPECT_GT(front[2].y, front[1].y);
}

TEST(Space, WordsCoverNoOthersAndStayOnTheSheet) {
    for (const std::string& name : in_space) {
        const Trace trace = trace_of_example(name);
        std::set<std::string> kinds;
        for (std::size_t n = 0; n <= trace.size(); ++n) {
            // One of each kind, and of each space.
            if (n > 0) {
                std::string kind{name_of(*trace.kind_of(n))};
                if (trace.kind_of(n) == StepKind::vertex)
                    kind += trace.step(n).as<VertexStep>().space.text();
                if (!kinds.insert(kind).second)
                    continue;
            }
            const Drawing figure = figure_of(
                trace, {.steps = {n, n == 0 ? trace.size() : end_of(trace, n)}},
                {.without = {FigurePart::title, FigurePart::caption}, .is_in_space = true});
            const Rectangle sheet{{}, figure.width, figure.height};
            std::vector<std::pair<std::string, Rectangle>> boxes;
            for (const Shape& shape : figure.shapes)
                if (const auto* const label = std::get_if<Label>(&shape))
                    boxes.emplace_back(label->text, box_of(*label));
            for (std::size_t i = 0; i < boxes.size(); ++i) {
                EXPECT_TRUE(sheet.has(boxes[i].second)) << name << " " << n << boxes[i].first;
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_FALSE(boxes[i].second.meets(boxes[j].second))
                        << name << " " << n << ": " << boxes[i].first << ", " << boxes[j].first;
            }
        }
    }
}

TEST(Space, NamesWithoutRoomAreLeftOut) {
    // Vertices in the middle that are ever nearer to one another, and four far away.
    for (const double apart : {2.0, 0.5, 0.1, 0.01, 0.0}) {
        std::string vertices =
            R"("A": [-9, 0, 20], "B": [9, 0, 20], "C": [0, -9, 20], "D": [0, 9, 20])";
        std::string points = R"("A", "B", "C", "D")";
        for (int i = 0; i < 20; ++i) {
            vertices +=
                fmt::format(R"(, "V{}": [{}, {}, 20])", i, apart * (i % 5), apart * (i / 5));
            points += fmt::format(R"(, ["V{}"])", i);
        }
        const Drawing figure =
            whole_figure(trace_of_scene(fmt::format(R"({{"canvas": {{"width": 9, "height": 9}},
                "vertices": {{{}}}, "points": [{}],
                "projection": {{"type": "pinhole", "distance": 10}}}})",
                                                    vertices, points)),
                         {.is_in_space = true});
        const auto names = texts_of(figure, Role::strong_text);
        EXPECT_THAT(names, IsSupersetOf({"A", "B", "C", "D"})) << "those that have room";
        EXPECT_EQ(names.size() == 24, apart == 2.0) << apart;
    }
}

TEST(SpaceFrames, AVertexStandsInEachOfItsSpaces) {
    const Trace trace = trace_of_example("t4-pipeline/six-spaces");
    const Drawing sheet = space_frames(trace, SpaceFrames::spaces, {}, {});
    EXPECT_THAT(texts_of(sheet, Role::text),
                testing::ElementsAre("object: A (1, 1, 1)", "world: A (0, 2, 1)",
                                     "camera: A (0, 2, -3)", "clip: A (0, 2, -2, 3)",
                                     "canonical: A (0, 2/3, -2/3)", "screen: A (20, 10/3)"));
    EXPECT_EQ(shapes_of<Dots>(sheet, Role::rejected).size(), 6U);
    const Drawing of_b =
        space_frames(trace, SpaceFrames::spaces, step_of(trace, "vertex name=B space=screen"), {});
    EXPECT_THAT(texts_of(of_b, Role::text), Contains("screen: B (28, 6)"));
    EXPECT_THROW(space_frames(trace_of_example("faces/arrow"), SpaceFrames::spaces, {}, {}),
                 Problem);
}

TEST(SpaceFrames, EarsAreTheCornersThatAreConvexAndEmpty) {
    // The arrow is reflex at C and F; an ear takes its tip away.
    const Trace trace = trace_of_example("faces/arrow");
    const auto words = texts_of(space_frames(trace, SpaceFrames::ears, {}, {}), Role::text);
    EXPECT_THAT(words, testing::ElementsAre(
                           "1. ABC: convex at B,", "no other vertex in it", "(reflex: C, F)",
                           "2. CDE: convex at D,", "no other vertex in it", "(reflex: F)",
                           "3. FGA: convex at G,", "no other vertex in it", "(reflex: F)",
                           "4. ACE: convex at C,", "no other vertex in it", "(reflex: none)",
                           "5. EFA: what is left"));
    EXPECT_THROW(space_frames(trace, SpaceFrames::ears, step_of(trace, "primitive name=ABC"), {}),
                 Problem);
}

TEST(Space, PagesTellOfEachStepWhatItAdds) {
    const Trace trace = trace_of_example("t4-pipeline/six-spaces");
    const auto in_space_of_trace = steps_in_space(trace, {});
    const auto data = nlohmann::json::parse(page_data(trace, {}, in_space_of_trace.get()));
    const auto& space = data.at("space");
    ASSERT_EQ(space.at("steps").size(), trace.size());
    const std::string all = space.at("all");
    EXPECT_THAT(all, testing::HasSubstr(">eye<"));
    const auto added = [&](const std::string& selector) {
        const std::size_t word = space.at("steps").at(step_of(trace, selector) - 1);
        return data.at("words").at(word).get<std::string>();
    };
    EXPECT_THAT(added("vertex name=A space=world"), testing::HasSubstr(">(0, 2, 1)<"));
    EXPECT_THAT(added("matrix name=viewport"), testing::HasSubstr(">(40, 20)<"));
    EXPECT_EQ(steps_in_space(trace_of_example("t0-fill/first-triangle"), {}), nullptr);
    EXPECT_FALSE(nlohmann::json::parse(page_data(trace)).contains("space"));
}

} // namespace
} // namespace rastertrace
