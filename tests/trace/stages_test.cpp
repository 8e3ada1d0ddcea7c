// SPDX-License-Identifier: MIT
// Leaving a stage out changes neither the picture nor the steps of the other stages; each stage is
// needed in one scene and not in another that differs as little as possible.

#include "edge_scenes.h"
#include "effort.h"
#include "picture.h"
#include "scene_text.h"
#include "traces.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/stage_name.h>

#include <fmt/core.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

bool runs(Stage stage, const Plan& plan, std::string_view plane = "") {
    for (const StageDecision& decision : plan.stages.decisions)
        if (decision.stage == stage && (plane.empty() || decision.plane == plane) &&
            decision.is_kept)
            return true;
    return false;
}

bool needs(Stage stage, const std::string& text, std::string_view plane = "") {
    return runs(stage, plan_for(scene_in(text)), plane);
}

/// Doubles may leave open what a stage asks that the other way leaves out: that is not compared.
std::vector<std::string> compared_steps_of(const Trace& trace) {
    std::vector<std::string> steps;
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (trace.step(n).kind() != StepKind::undecided)
            steps.emplace_back(trace.step(n).json());
    return steps;
}

/// The steps of a full trace without those, and without the fields, of the stages that the plan
/// leaves out.
std::vector<std::string> without_left_out(const Trace& full, const Scene& scene, const Plan& plan) {
    std::map<std::string, std::size_t> numbers;
    for (std::size_t i = 0; i < scene.primitives.size(); ++i)
        numbers[scene.primitives[i].name] = i;
    // The vertices of objects whose model moves nothing.
    std::set<std::string> resting_vertices;
    std::size_t first = 0;
    for (const SceneObject& object : scene.objects) {
        for (std::size_t i = first; i < std::min(object.end_vertex, scene.vertices.size()); ++i)
            if (object.model.matrix() == identity<Rational>())
                resting_vertices.insert(scene.vertices[i].name);
        first = object.end_vertex;
    }
    for (std::size_t i = first; i < scene.vertices.size(); ++i)
        resting_vertices.insert(scene.vertices[i].name);
    const std::vector<std::vector<std::string>> identity_rows{
        {"1", "0", "0", "0"}, {"0", "1", "0", "0"}, {"0", "0", "1", "0"}, {"0", "0", "0", "1"}};

    std::vector<std::string> steps;
    bool tests_depth = true;
    for (std::size_t n = 1; n <= full.size(); ++n) {
        const StepView step = full.step(n);
        std::string json(step.json());
        const std::string name = name_in(step).text();
        switch (step.kind().value()) {
        case StepKind::matrix:
            if (text_rows(step.as<MatrixStep>().rows) == identity_rows)
                continue;
            break;
        case StepKind::vertex: {
            const auto space = step.as<VertexStep>().space;
            if (!scene.has_transforms() ||
                (space == Space::object && resting_vertices.contains(name)) ||
                (space == Space::camera && !runs(Stage::view, plan)) ||
                (space == Space::canonical && !runs(Stage::divide, plan)))
                continue;
            break;
        }
        case StepKind::order:
            if (!runs(Stage::order, plan))
                continue;
            break;
        case StepKind::primitive:
            tests_depth =
                plan.stages.pixels[numbers.at(name.substr(0, name.find('/')))].tests_depth;
            break;
        case StepKind::depth:
            if (!tests_depth)
                continue;
            break;
        case StepKind::scanline:
            if (const auto depths = json.find(",\"left_depth\""); !tests_depth)
                json = json.substr(0, depths) + (depths == std::string::npos ? "" : "}");
            break;
        case StepKind::undecided:
            continue;
        default:
            break;
        }
        steps.push_back(json);
    }
    return steps;
}

Scene full(Scene scene) {
    scene.keep = StageSet::all();
    return scene;
}

/// Steps with their numbers rounded to nine places: `adaptive` writes doubles that are off by no more
/// than their bounds, and exact numbers, as fractions in quotes too, from where these leave a decision
/// open, which may be earlier where more is asked.
std::vector<std::string> with_rounded_numbers(std::vector<std::string> steps) {
    static const std::regex number(
        R"re("-?[0-9]+(/[0-9]+)?"|-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?)re");
    for (std::string& step : steps) {
        std::string rounded;
        auto rest = step.cbegin();
        for (std::sregex_iterator one(step.begin(), step.end(), number), end; one != end; ++one) {
            rounded.append(rest, (*one)[0].first);
            const std::string found = one->str();
            const double value = found.front() == '"'
                                     ? nearest_double(mpq_class(found.substr(1, found.size() - 2)))
                                     : std::strtod(found.c_str(), nullptr);
            const std::string text = fmt::format("{:.9f}", value);
            rounded += text == "-0.000000000" ? "0.000000000" : text;
            rest = (*one)[0].second;
        }
        step = rounded.append(rest, step.cend());
    }
    return steps;
}

/// Fails unless the scene gives the same picture and the same steps, planned and in full.
void expect_same(const Scene& scene, const std::string& about) {
    const Plan plan = plan_for(scene);
    const Trace planned = trace_of(scene);
    const Trace complete = trace_of(full(scene));
    ASSERT_EQ(planned.end->frame, complete.end->frame) << about;
    if (scene.method.scalar == ScalarKind::adaptive)
        ASSERT_EQ(with_rounded_numbers(compared_steps_of(planned)),
                  with_rounded_numbers(without_left_out(complete, scene, plan)))
            << about;
    else
        ASSERT_EQ(compared_steps_of(planned), without_left_out(complete, scene, plan)) << about;
    // A sink that keeps nothing draws the same, with the canvas test compiled out.
    ASSERT_EQ(frame_name(draw_as_planned(scene)), planned.end->frame) << about;
}

TEST(Stages, LeavingThemOutChangesNothing) {
    EdgeScenes scenes(6);
    std::map<std::pair<Stage, bool>, int> seen;
    int drawn = 0;
    while (drawn < random_cases(6000)) {
        const Scene scene = scenes.next();
        if (find_unfit(scene) || find_unfit(full(scene)))
            continue;
        ++drawn;
        for (const StageDecision& decision : plan_for(scene).stages.decisions)
            ++seen[{decision.stage, decision.is_kept}];
        ASSERT_NO_FATAL_FAILURE(expect_same(scene, scene_text(scene)));
    }
    // The scenes do sit on the edges: every stage is left out of many and kept in many.
    for (std::size_t i = 0; i < stage_count; ++i) {
        const auto stage = static_cast<Stage>(i);
        EXPECT_GT((seen[{stage, false}]), random_cases(100)) << name_of(stage);
        if (stage != Stage::light) {
            EXPECT_GT((seen[{stage, true}]), random_cases(100)) << name_of(stage);
        }
    }
}

TEST(Stages, LeavingThemOutOfTheExamplesChangesNothing) {
    int count = 0;
    for (const std::string& file : example_files()) {
        const auto source = read_source(file);
        auto scene = read_scene(source.value());
        ASSERT_TRUE(scene) << file;
        scene.value().scene.keep = {}; // some keep what they do not need, to be looked at
        expect_same(scene.value().scene, file);
        ++count;
    }
    EXPECT_GT(count, 20);
}

// A scene in which each stage is needed, and one that differs as little as possible in which it is
// not.

std::string mesh(const std::string& model, const std::string& rest) {
    return R"({"canvas":{"width":8,"height":8},"meshes":[{"vertices":{"A":[0,0,-2],"B":[1,0,-2],)"
           R"("C":[0,1,-2]},"faces":["ABC"],"model":[)" +
           model + "]}]," + rest + "}";
}

const std::string flat_view =
    R"("projection":{"type":"orthographic","left":-1,"right":1,"bottom":-1,"top":1})";

TEST(Stages, ModelIsNeededIfItMovesSomething) {
    EXPECT_TRUE(needs(Stage::model, mesh(R"({"translate":[0,0,"1/1000"]})", flat_view)));
    EXPECT_FALSE(needs(Stage::model, mesh(R"({"translate":[0,0,0]})", flat_view)));
}

TEST(Stages, ViewIsNeededIfTheCameraMovesTheWorld) {
    const auto camera = [](const std::string& position) {
        return mesh("",
                    R"("camera":{"position":)" + position + R"(,"look_at":[0,0,-1]},)" + flat_view);
    };
    EXPECT_TRUE(needs(Stage::view, camera("[0,0,\"1/1000\"]")));
    EXPECT_FALSE(needs(Stage::view, camera("[0,0,0]")));
}

TEST(Stages, EachPlaneIsNeededIfAVertexLiesOutsideIt) {
    const auto near = [](const std::string& distance) {
        return mesh("", R"("projection":{"type":"frustum","left":-1,"right":1,"bottom":-1,"top":1,)"
                        R"("near":)" +
                            distance + R"(,"far":9})");
    };
    EXPECT_TRUE(needs(Stage::clip, near("2.001"), "near"));
    EXPECT_FALSE(needs(Stage::clip, near("2"), "near")) << "on the plane is inside";
    EXPECT_FALSE(needs(Stage::clip, near("2.001"), "far"));
}

TEST(Stages, DivideIsNeededIfAWIsNotOne) {
    const auto pinhole = [](const std::string& z) {
        return R"({"canvas":{"width":8,"height":8},"vertices":{"A":[0,0,1],"B":[1,0,1],"C":[0,1,)" +
               z + R"(]},"triangles":["ABC"],"projection":{"type":"pinhole","distance":1}})";
    };
    EXPECT_TRUE(needs(Stage::divide, pinhole("1.0000000000000002")));
    EXPECT_FALSE(needs(Stage::divide, pinhole("1")));
}

/// Two triangles of one box each, the second moved by `x` and away from the eye by `z`.
std::string two_triangles(int x, int z, const std::string& method) {
    return fmt::format(R"({{"canvas":{{"width":32,"height":8,"origin":"top-left"}},)"
                       R"("vertices":{{"A":[0,0,2],"B":[3,0,2],"C":[0,3,2],)"
                       R"("D":[{},0,{}],"E":[{},0,{}],"F":[{},3,{}]}},"triangles":["ABC","DEF"],)"
                       R"("method":{{{}}}}})",
                       x, z, x + 3, z, x, z, method);
}

TEST(Stages, OrderIsNeededIfTheFarthestDoNotComeFirst) {
    EXPECT_TRUE(needs(Stage::order, two_triangles(1, 3, R"("depth":"painter")")));
    EXPECT_FALSE(needs(Stage::order, two_triangles(1, 2, R"("depth":"painter")")));
}

TEST(Stages, CullAndLightAreNeededIfTheMethodAsks) {
    EXPECT_TRUE(needs(Stage::cull, two_triangles(1, 3, R"("cull":"back")")));
    EXPECT_FALSE(needs(Stage::cull, two_triangles(1, 3, R"("cull":"none")")));
    const auto lit = [](const std::string& shade) {
        std::string text = two_triangles(1, 3, R"("shade":")" + shade + "\"");
        return text.insert(text.size() - 1, R"(,"light":{"direction":[0,0,1]})");
    };
    EXPECT_TRUE(needs(Stage::light, lit("lambert")));
    EXPECT_FALSE(needs(Stage::light, lit("flat")));
}

TEST(Stages, CanvasTestIsNeededIfATriangleMayReachBeyondIt) {
    EXPECT_TRUE(needs(Stage::canvas, two_triangles(29, 2, R"("scalar":"exact")")));
    EXPECT_FALSE(needs(Stage::canvas, two_triangles(28, 2, R"("scalar":"exact")")));
}

TEST(Stages, DepthIsNeededIfTwoTrianglesMayShareAPixel) {
    const std::string method = R"("depth":"linear-z","scalar":"exact")";
    EXPECT_TRUE(needs(Stage::depth, two_triangles(3, 2, method))) << "both reach x = 3";
    EXPECT_FALSE(needs(Stage::depth, two_triangles(4, 2, method)));
    const Plan plan = plan_for(scene_in(two_triangles(4, 2, method)));
    EXPECT_EQ(plan.stages.depth_region.width * plan.stages.depth_region.height, 0);
}

/// Why the depths of a scene are tested, or not.
std::string why_depth(const Scene& scene) {
    for (const StageDecision& decision : plan_for(scene).stages.decisions)
        if (decision.stage == Stage::depth)
            return decision.why;
    return "";
}

TEST(Stages, DepthThatIsKeptOnRequestHasTheReasonOfTheScene) {
    const auto why = [](int x) {
        return why_depth(
            full(scene_in(two_triangles(x, 2, R"("depth":"linear-z","scalar":"exact")"))));
    };
    EXPECT_EQ(why(4), "asked to be kept; no two triangles can share a pixel");
    EXPECT_EQ(why(3),
              "asked to be kept; 2 of 2 triangles may share a pixel with another, or may be as far "
              "as the buffer starts");
}

TEST(Stages, DepthOfTrianglesThatAreCutIsNeededForTheirParts) {
    // Each reaches behind the eye, on its own side of the canvas.
    const auto why = [](const std::string& primitives) {
        return why_depth(scene_in(
            R"({"canvas":{"width":33,"height":17,"origin":"top-left"},)"
            R"("vertices":{"A":[-1,1,-2],"B":[-2,-1,-2],"C":[-1,-1,2],"D":[1,1,-2],"E":[2,-1,-2],"F":[1,-1,2]},)" +
            primitives +
            R"(,"projection":{"type":"frustum","left":-1,"right":1,"bottom":-1,"top":1,"near":1,"far":17},)"
            R"("method":{"scalar":"exact","fill":"top-left","depth":"inverse-z"}})"));
    };
    EXPECT_EQ(why(R"("triangles":["ABC"])"),
              "1 of 1 triangle has parts, made by clipping, that may share a pixel");
    EXPECT_EQ(why(R"("triangles":["ABC","DEF"])"),
              "2 of 2 triangles have parts, made by clipping, that may share a pixel");
    EXPECT_EQ(why(R"("triangles":["ABC","DEF"],"outlines":["ABC"])"),
              "2 of 3 primitives may share a pixel with another, or may be as far as the buffer "
              "starts; 1 of 3 primitives has parts or sides that may share a pixel");
}

std::string colored(const std::string& z, const std::string& color) {
    return R"({"canvas":{"width":8,"height":8},"vertices":{"A":[0,0,2],"B":[1,0,2],"C":[0,1,)" + z +
           R"(]},"triangles":["ABC"],"colors":{"A":"#102030","B":"#102030","C":")" + color +
           R"("},"projection":{"type":"pinhole","distance":1}})";
}

TEST(Stages, ColorsAreNeededIfTheyDifferAndPerspectiveIfWDoes) {
    EXPECT_TRUE(needs(Stage::colors, colored("3", "#102031")));
    EXPECT_FALSE(needs(Stage::colors, colored("3", "#102030")));
    EXPECT_TRUE(needs(Stage::perspective, colored("2.0000000000000004", "#102031")));
    EXPECT_FALSE(needs(Stage::perspective, colored("2", "#102031")));
}

// What leaving out would change if it were done carelessly: numerics, part X.

TEST(Stages, X1AnIdentityMatrixChangesNothing) {
    // 1 x + 0 y + 0 z + 0 is x, if y and z are finite; what is not is refused before. -0 is 0.
    for (const std::string scalar : {"float", "double", "exact"})
        expect_same(scene_in(R"({"canvas":{"width":8,"height":8},"meshes":[{"vertices":)"
                             R"({"A":[-0.0,1e-30,-2],"B":["1/3",1e30,-2],"C":[3,-0.1,-2e30]},)"
                             R"("faces":["ABC"],"model":[{"scale":[1,1,1]}],"draw":"outlines"}],)"
                             R"("camera":{"position":[0,0,0],"look_at":[0,0,-1]},)"
                             R"("projection":{"type":"orthographic","left":-4,"right":4,)"
                             R"("bottom":-4,"top":4},"method":{"scalar":")" +
                             scalar + "\"}}"),
                    "X1 " + scalar);
}

TEST(Stages, X2DividingByOneChangesNothing) {
    const Scene scene =
        scene_in(R"({"canvas":{"width":9,"height":9},"vertices":{"A":["1/3",0.1,1],)"
                 R"("B":[-0.7,"2/7",1],"C":[0.3,-0.9,1]},"triangles":["ABC"],)"
                 R"("projection":{"type":"pinhole","distance":"1/3"},)"
                 R"("viewport":{"pixels_per_unit":9}})");
    EXPECT_FALSE(runs(Stage::divide, plan_for(scene)));
    expect_same(scene, "X2");
}

TEST(Stages, X3KeepsTheDivisionByAWThatIsTheSameEverywhere) {
    // 5/3 is not 5 times 1/3 in double: w = 3 everywhere is still divided by.
    EXPECT_TRUE(needs(Stage::divide, R"({"canvas":{"width":8,"height":8},"vertices":{"A":[5,0,3],)"
                                     R"("B":[1,0,3],"C":[0,1,3]},"triangles":["ABC"],)"
                                     R"("projection":{"type":"pinhole","distance":1}})"));
}

TEST(Stages, X4EqualDepthsStayEqual) {
    // 1/3 at three corners: mixed by weights, some pixels would have another depth than 1/3, and of
    // two such triangles the second would show through.
    const std::string corners = R"("A":[3,2,3],"B":[61,9,3],"C":[17,60,3],)"
                                R"("D":[3,2,3],"E":[17,60,3],"F":[61,9,3])";
    for (const std::string fill : {"scanline", "two-halves", "barycentric", "top-left"})
        for (const std::string scalar : {"float", "double", "fixed", "exact"}) {
            const Scene scene = scene_in(
                R"({"canvas":{"width":64,"height":64,"origin":"top-left"},"vertices":{)" + corners +
                R"(},"triangles":[{"vertices":"ABC","color":"red"},{"vertices":"DEF","color":"blue"}],)"
                R"("method":{"depth":"inverse-z","fill":")" +
                fill + R"(","scalar":")" + scalar + "\"}}");
            const Image image = draw_as_planned(scene);
            for (const Color& color : image.colors())
                ASSERT_TRUE(color == no_color || color == Color(255, 0, 0)) << fill << scalar;
            expect_same(scene, fill + " " + scalar);
        }
}

TEST(Stages, X5DecidesFromPixelsNotFromGeometry) {
    // Two halves of a square share no area, but under the inclusive rule the 9 pixels of the
    // diagonal: without the test the second one would win them.
    const Scene scene = scene_in(
        R"({"canvas":{"width":10,"height":10,"origin":"top-left"},)"
        R"("vertices":{"A":[0,0,2],"B":[8,0,2],"C":[8,8,2],"D":[0,8,2]},)"
        R"("triangles":[{"vertices":"ABC","color":"red"},{"vertices":"ACD","color":"blue"}],)"
        R"("method":{"depth":"inverse-z"}})");
    EXPECT_TRUE(runs(Stage::depth, plan_for(scene)));
    const Image image = draw_as_planned(scene);
    for (int i = 0; i <= 8; ++i)
        EXPECT_EQ(image.at({i, i}), Color(255, 0, 0));
    expect_same(scene, "X5");
}

TEST(Stages, X6CullsWhateverTheDepthBufferWouldHide) {
    // A back face at the same depth as a front one behind it in the scene's order: culling is not
    // left out although a buffer is there.
    EXPECT_TRUE(needs(Stage::cull, two_triangles(0, 2, R"("cull":"back","depth":"linear-z")")));
}

TEST(Stages, X7PlanesAreLeftOutOnlyWhereNothingLiesOutside) {
    const std::string on_planes =
        R"({"canvas":{"width":9,"height":9},"vertices":{"A":[-1,-1,-1],"B":[9,-9,-9],"C":[0,1,-1]},)"
        R"("triangles":["ABC"],"projection":{"type":"frustum","left":-1,"right":1,"bottom":-1,)"
        R"("top":1,"near":1,"far":9}})";
    EXPECT_FALSE(needs(Stage::clip, on_planes));
    expect_same(scene_in(on_planes), "X7");
}

TEST(Stages, X8ThePainterIsLeftOutOnlyWhereItWouldMoveNothing) {
    // Apart in depth, the painter's picture is that of the depth buffer; equal keys keep their turn.
    for (const int z : {1, 2, 3}) {
        const Scene painted = scene_in(two_triangles(1, z, R"("depth":"painter")"));
        EXPECT_EQ(runs(Stage::order, plan_for(painted)), z > 2);
        expect_same(painted, "X8");
        if (z != 2) {
            EXPECT_EQ(
                draw_as_planned(painted).colors(),
                draw_as_planned(scene_in(two_triangles(1, z, R"("depth":"inverse-z")"))).colors());
        }
    }
}

// What a second reader broke, once.

TEST(Stages, ASliverJustBelowHalfAPixelDrawsNothingBeyondItself) {
    // y - 1/2 would be rounded to the row above the sliver, where its edges are far outside it.
    for (const bool is_single : {false, true}) {
        const double ulp = is_single ? 0x1p-24 : 0x1p-53;
        for (const double half : {-0.5, -1.5, -3.5})
            for (const bool has_depth : {false, true}) {
                Scene scene;
                scene.canvas = {.width = 12, .height = 12};
                scene.method.scalar =
                    is_single ? ScalarKind::single_precision : ScalarKind::double_precision;
                scene.method.fill = Fill::top_left;
                if (has_depth)
                    scene.method.depth = Depth::inverse_z;
                const auto exact = [](double x) { return Number::fraction(Rational(x)); };
                const double above = half * (1 + 2 * ulp);
                const double below = half * (1 + 4 * ulp);
                scene.vertices = {{"A", -5, exact(above), {}, 2},
                                  {"B", 4, exact(above), {}, 2},
                                  {"C", 0, exact(below), {}, 2}};
                scene.primitives = {{.kind = PrimitiveKind::triangle,
                                     .name = "ABC",
                                     .vertices = {0, 1, 2},
                                     .color = {}}};
                EXPECT_EQ(draw_as_planned(scene).drawn(), 0u) << half << " " << ulp;
                expect_same(scene, "sliver");
            }
    }
}

TEST(Stages, EqualWMixesInTheNumbersOfTheScreen) {
    for (const std::string fill : {"scanline", "barycentric", "top-left"})
        for (const std::string colors : {R"("A":"#ca1831","B":"#81b5a7","C":"#bcee14")",
                                         R"("A":"#9a4e68","B":"#49388e","C":"#0009b4")"})
            expect_same(
                scene_in(R"({"canvas":{"width":16,"height":16},"vertices":{"A":[-1,-1,1],)"
                         R"("B":[1,-1,1],"C":[0,1,1]},"triangles":["ABC"],"colors":{)" +
                         colors +
                         R"(},"projection":{"type":"pinhole","distance":1},"viewport":"fit",)"
                         R"("method":{"scalar":"fixed","shade":"interpolate","fill":")" +
                         fill + "\"}}"),
                fill);
}

TEST(Stages, DepthsThatOverflowAreRefusedAndTinyOnesTested) {
    const auto text = [](const std::string& scalar, const std::string& fill,
                         const std::string& depth, const std::string& vertices) {
        return R"({"canvas":{"width":64,"height":64,"origin":"bottom-left"},"vertices":{)" +
               vertices + R"(},"triangles":["ABC"],"method":{"scalar":")" + scalar +
               R"(","fill":")" + fill + R"(","depth":")" + depth + "\"}}";
    };
    // An infinite product, an infinite difference: no infinity may reach a trace.
    for (const std::string& refused :
         {text("float", "two-halves", "linear-z",
               R"("A":[45,10,1.47e26],"B":[-11.15,-16.13,-7.04e36],"C":[60,28,5.40e36])"),
          text("double", "barycentric", "linear-z",
               R"("A":[2,2,1.5e308],"B":[60,5,-1.5e308],"C":[10,60,1.5e308])")}) {
        const auto read = read_scene({"scene.json", refused});
        ASSERT_FALSE(read);
        EXPECT_THAT(
            read.problem().message,
            testing::StartsWith("expected a depth whose product with a coordinate fits in"));
    }
    // A slope without digits.
    expect_same(
        scene_in(text("float", "scanline", "inverse-z",
                      R"("A":[20,8,1.69e38],"B":[-2.37e7,8,3.9e37],"C":[5.59e6,4.39e7,1.43e34])")),
        "tiny depths");
}

TEST(Stages, ADepthAsFarAsTheBufferStartsIsTested) {
    // One triangle alone, but on the far plane: against a clear buffer of ndc-z it fails.
    const std::string text =
        R"({"canvas":{"width":9,"height":9},"vertices":{"A":[-9,-9,-9],"B":[9,-9,-9],"C":[0,9,-9]},)"
        R"("triangles":["ABC"],"projection":{"type":"frustum","left":-1,"right":1,"bottom":-1,)"
        R"("top":1,"near":1,"far":9},"method":{"depth":"ndc-z","scalar":"exact"}})";
    EXPECT_TRUE(needs(Stage::depth, text));
    EXPECT_EQ(draw_as_planned(scene_in(text)).drawn(), 0u);
}

} // namespace
} // namespace rastertrace
