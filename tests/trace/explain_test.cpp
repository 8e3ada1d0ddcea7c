// SPDX-License-Identifier: MIT
#include <rastertrace/trace/explain/explain.h>

#include "picture.h"
#include "traces.h"

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/method_names.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Explanation answer_to(const Trace& trace, const Question& question) {
    auto answer = explain(trace, question);
    if (!answer) {
        ADD_FAILURE() << to_text(answer.problem());
        return {};
    }
    return std::move(answer.value());
}

Question pixel(int x, int y) {
    return {.about = Topic::pixel, .pixel = {x, y}};
}

/// The only reason why a pixel is not drawn.
std::string why_not(const Trace& trace, int x, int y) {
    const Explanation answer = answer_to(trace, pixel(x, y));
    EXPECT_EQ(answer.why_not.size(), 1U);
    return answer.why_not.empty() ? "" : answer.why_not.front().sentence;
}

Trace first_triangle_by(Fill fill, std::optional<Rounding> rounding = {}) {
    return trace_of(
        first_triangle({.scalar = ScalarKind::exact, .fill = fill, .rounding = rounding}));
}

// T3's table of points: (4, 2) has the weights 5/8, -7/72, 17/36.
TEST(Explain, WhatKeepsAPixelOutOfEachFill) {
    EXPECT_EQ(why_not(first_triangle_by(Fill::scanline), 4, 2),
              "AC ends row y=2 at x = 25/8 -> floor -> 3; x = 4 lies beyond it by 7/8");
    EXPECT_EQ(why_not(first_triangle_by(Fill::scanline, Rounding::half_open), 5, -3),
              "AC ends row y=-3 at x = 5 -> ceil - 1 -> 4; x = 5 lies on it, and the rule leaves "
              "it out");
    EXPECT_EQ(why_not(first_triangle_by(Fill::scanline, Rounding::truncate), -1, 2),
              "AB begins row y=2 at x = -1/4 -> truncate -> 0; x = -1 lies before it by 3/4");
    EXPECT_THAT(
        why_not(first_triangle_by(Fill::barycentric), 4, 2),
        testing::StartsWith("at (4, 2) the weight of B is -7/72 < 0: beyond CA, by 0.8192"));
    EXPECT_EQ(why_not(first_triangle_by(Fill::barycentric), 7, 2),
              "(7, 2) lies beyond the box around it, x -4 to 5, y -3 to 5, by 2");
    EXPECT_EQ(why_not(first_triangle_by(Fill::fan), 5, 5),
              "no line of the fan passes through the pixel");
}

// E of AB = 8 (x - 2) - 6 (y - 5), E of BC = y + 3 times 9: in (-1/2, 5/2) and (1, -3).
TEST(Explain, TheEdgeFunctionAndTheTieRule) {
    EXPECT_EQ(why_not(first_triangle_by(Fill::top_left), -1, 2),
              "E of AB at (-1/2, 5/2) = 8 (-5/2) + (-6) (-5/2) = -5: < 0, outside, 0.5 px beyond "
              "it");
    const Trace on_points = trace_of(first_triangle(
        {.scalar = ScalarKind::exact, .fill = Fill::top_left, .sample = Sample::integer}));
    EXPECT_THAT(why_not(on_points, 1, -3),
                HasSubstr("= 0: on the edge, outside: it is no top or left edge"));
    EXPECT_THAT(why_not(on_points, 1, -3), HasSubstr("E of BC at (1, -3)"));
    EXPECT_THAT(answer_to(on_points, pixel(-1, 1)).why_not, IsEmpty()); // on AB, a left edge
}

TEST(Explain, BothEndsOfARowAreWrittenOut) {
    const Explanation answer =
        answer_to(trace_of(first_triangle()), {.about = Topic::scanline, .pixel = {0, 2}});
    ASSERT_EQ(answer.tries.size(), 1U);
    EXPECT_EQ(answer.tries[0].number, 14U);
    EXPECT_THAT(answer.tries[0].working,
                Contains("left AB: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = "
                         "(-4 - 2)/(-3 - 5) (2 - 5) + 2 = 3/4 (-3) + 2 = -1/4 -> floor -> -1"));
}

// T0's cube: ABC and ACD at z = 3; the back face at z = 5.
TEST(Explain, DepthsThatFailAndFacesThatAreCulled) {
    Scene cube = cube_of_t0({"EGF", "ABC", "EFG"});
    cube.method.depth = Depth::inverse_z;
    cube.method.cull = Cull::none;
    const Trace drawn = trace_of(cube);
    const Explanation shown = answer_to(drawn, pixel(1, 1));
    EXPECT_THAT(shown.answer, HasSubstr("drawn by ABC at step "));
    EXPECT_THAT(shown.answer, HasSubstr(", over EGF"));
    ASSERT_FALSE(shown.why_not.empty());
    EXPECT_EQ(shown.why_not[0].reason, "hidden");
    EXPECT_THAT(
        shown.why_not[0].sentence,
        HasSubstr("1/5 against 1/3 of ABC: fails (1/z, larger is nearer; z = 5 against 3)"));

    cube.method.cull = Cull::back;
    const Explanation culled = answer_to(trace_of(cube), pixel(1, 1));
    for (const WhyNot& why : culled.why_not)
        if (why.reason == "culled") {
            EXPECT_THAT(why.sentence, HasSubstr("-20"));
        }
    EXPECT_THAT(culled.why_not, Contains(testing::Field(&WhyNot::reason, "culled")));
}

TEST(Explain, FromPlaceToPlace) {
    const Trace trace = trace_of(cube_of_t0({"ABC", "ACD"}));
    const Explanation vertex = answer_to(trace, {.about = Topic::vertex, .text = "A"});
    EXPECT_EQ(vertex.answer, "screen space: (-10/3, 10/3)");
    std::vector<std::string> spaces;
    for (const Try& one : vertex.tries)
        spaces.push_back(trace.step(one.number).as<VertexStep>().space.text());
    EXPECT_THAT(spaces, ElementsAre("object", "world", "clip", "canonical", "screen"));
    EXPECT_THAT(vertex.tries[1].working, Contains("z = 0 (-1) + 0 (1) + 1 (-1) + 4 (1) = 3"));

    // T0: the normal (0, 0, -4), the view (1/3, ...), -12 from the eye to the face.
    const Explanation face = answer_to(trace, {.about = Topic::face, .text = "ABC"});
    EXPECT_THAT(face.tries[1].sentence, HasSubstr("normal (0, 0, -4)"));
    EXPECT_THAT(face.tries[1].sentence, HasSubstr("= 12"));
}

/// Every pixel along an edge of a triangle on each side of it, with the top-left rule, has one owner.
TEST(Explain, APairHasEachPixelAlongItsEdgeOnce) {
    const Scene scene = lettered_triangles(
        {{'p', {"0", "0", "9", "0", "0", "9"}}, {'q', {"9", "0", "9", "9", "0", "9"}}},
        {.width = 10, .height = 10, .origin = Origin::bottom_left},
        {.scalar = ScalarKind::exact, .fill = Fill::top_left});
    const Trace trace = trace_of(scene);
    const Explanation pair = answer_to(trace, {.about = Topic::pair, .text = "p,q"});
    const Frame frame = frame_after(trace, trace.size());
    ASSERT_FALSE(pair.pixels.empty());
    for (const PixelAlongEdge& one : pair.pixels) {
        const bool is_drawn = frame.image.at(one.pixel) != no_color;
        EXPECT_EQ(one.owners.size(), is_drawn ? 1U : 0U);
        EXPECT_EQ(one.why.size(), 2U);
    }
}

TEST(Explain, WhatATraceLacksIsSaid) {
    const Scene scene = first_triangle();
    const auto only = [&scene](std::vector<StepKind> kinds) {
        return readable_trace(trace_text(scene, {.filter = {.only = std::move(kinds)}}));
    };
    const Explanation rows =
        answer_to(only({StepKind::primitive, StepKind::scanline}), pixel(0, 2));
    EXPECT_EQ(rows.answer, "no step of the trace draws it, but not all steps are there");
    EXPECT_THAT(rows.lacks, Contains("pixel steps were left out of the trace"));
    ASSERT_EQ(rows.why_not.size(), 1U);
    EXPECT_EQ(rows.why_not[0].sentence, "row y=2 has the pixels -1 to 3, but no step of the trace "
                                        "says what became of this one");

    const Explanation pixels = answer_to(only({StepKind::primitive, StepKind::pixel}), pixel(4, 2));
    EXPECT_THAT(pixels.lacks, IsEmpty()); // that it is not drawn can be told; why, not
    ASSERT_EQ(pixels.why_not.size(), 1U);
    EXPECT_EQ(pixels.why_not[0].sentence,
              "the trace has no edge, scanline, sample steps, which would say why");
}

/// The reason that a primitive is given, and its sentence; "" if it is not among those that did not draw.
std::string reason_of(const Explanation& answer, const std::string& primitive) {
    for (const WhyNot& why : answer.why_not)
        if (why.primitive == primitive)
            return why.reason + ": " + why.sentence;
    return "";
}

/// The lines of a trace that are wanted.
template <typename Wanted> Trace trace_of_lines(const std::string& text, const Wanted& is_wanted) {
    std::string kept;
    std::size_t number = 0, begin = 0;
    while (begin < text.size()) {
        const std::size_t end = text.find('\n', begin);
        const std::string line = text.substr(begin, end - begin + 1);
        if (is_wanted(++number, line))
            kept += line;
        begin += line.size();
    }
    return readable_trace(kept);
}

Trace first_lines(const std::string& text, std::size_t count) {
    return trace_of_lines(text, [count](std::size_t n, const std::string&) { return n <= count; });
}

Trace traced_in_region(const Scene& scene, const Region& region) {
    return readable_trace(trace_text(scene, {.filter = {.region = region}}));
}

// The near plane cuts two sides of the outline; their clip steps come after its first part.
TEST(Explain, AnOutlineThatIsCutIsToldByItsParts) {
    const Trace trace = trace_of(scene_in(
        R"({"canvas":{"width":9,"height":9},"vertices":{"A":[0,0,5],"B":[2,0,5],"C":[1,2,-5]},
            "outlines":["ABC"],"projection":{"type":"pinhole","distance":1}})"));
    const Explanation drawn = answer_to(trace, pixel(0, 0));
    EXPECT_THAT(drawn.answer, testing::EndsWith(", over ABC/1"));
    EXPECT_EQ(reason_of(drawn, "ABC"), "");

    const Explanation left_out = answer_to(trace, pixel(-3, -3));
    EXPECT_EQ(reason_of(left_out, "ABC"),
              "clipped: ABC clipped at the near plane: 1 of 2 vertices inside, 2 left; ABC clipped "
              "at the near plane: 1 of 2 vertices inside, 2 left; no part that is left has the "
              "pixel");
    EXPECT_EQ(left_out.why_not.front().primitive, "ABC");
    EXPECT_EQ(reason_of(left_out, "ABC/1"),
              "elsewhere: the line goes from x = 0 to 18/5: x = -3 lies beyond it, by 3");
}

TEST(Explain, WhatATruncatedTraceMayLackIsNoReason) {
    const Trace rows = first_lines(trace_text(first_triangle()), 20);
    EXPECT_EQ(reason_of(answer_to(rows, pixel(0, 0)), "ABC"),
              "unknown: the trace does not have row y=0 of it; the trace is truncated");
    EXPECT_EQ(reason_of(answer_to(rows, pixel(6, 4)), "ABC"),
              "outside: AC ends row y=4 at x = 19/8 -> floor -> 2; x = 6 lies beyond it by 29/8");

    const Trace fan = first_lines(
        trace_text(first_triangle({.scalar = ScalarKind::exact, .fill = Fill::fan})), 8);
    EXPECT_EQ(reason_of(answer_to(fan, pixel(0, 0)), "ABC"),
              "unknown: no step of the trace says why; the trace is truncated");

    const std::string line = trace_text(scene_in(
        R"({"canvas":{"width":9,"height":9},"vertices":{"A":[-4,0],"B":[4,0]},"lines":["AB"]})"));
    EXPECT_EQ(reason_of(answer_to(first_lines(line, 5), pixel(3, 0)), "AB"),
              "unknown: the line goes from x = -4 to 4; no step of the trace says where it is at "
              "x = 3; the trace is truncated");
}

TEST(Explain, WhatLiesBeyondTheRegionOfATraceIsNoReason) {
    const Trace fan = traced_in_region(
        first_triangle({.scalar = ScalarKind::exact, .fill = Fill::fan}), {0, 0, 1, 1});
    EXPECT_EQ(reason_of(answer_to(fan, pixel(-1, -1)), "ABC"),
              "unknown: no step of the trace says why; the trace has only what is about x 0 to 1, "
              "y 0 to 1");
    const Trace rows = traced_in_region(first_triangle(), {-3, -3, 1, 1});
    EXPECT_EQ(reason_of(answer_to(rows, pixel(4, 2)), "ABC"),
              "unknown: the trace does not have row y=2 of it; the trace has only what is about "
              "x -3 to 1, y -3 to 1");
}

TEST(Explain, ALostRowIsNoReason) {
    const Trace damaged =
        trace_of_lines(trace_text(first_triangle()), [](std::size_t, const std::string& line) {
            return line.find(R"("y":2,"left")") == std::string::npos;
        });
    ASSERT_FALSE(damaged.damage.empty());
    EXPECT_EQ(reason_of(answer_to(damaged, pixel(6, 2)), "ABC"),
              "unknown: row y=2 is missing among its rows, y=5 to -3");
    EXPECT_EQ(reason_of(answer_to(damaged, pixel(0, 6)), "ABC"),
              "unknown: the trace does not have row y=6 of it; the trace is damaged, and steps of "
              "it may be missing");
}

// The worked triangle has 49 pixels, and nine rows that AB ends.
TEST(Explain, EveryAnswerSaysWhatTheTraceLacks) {
    const Trace cut = first_lines(trace_text(first_triangle()), 20);
    const std::string truncated = "the trace is truncated: what came later is not known";
    const Explanation row = answer_to(cut, {.about = Topic::scanline, .pixel = {0, 0}});
    EXPECT_EQ(row.answer, "not told");
    EXPECT_THAT(row.lacks, ElementsAre(truncated));

    const Trace part = traced_in_region(first_triangle(), {-3, -3, 1, 1});
    const std::string region = "the trace has only what is about x -3 to 1, y -3 to 1";
    const Explanation face = answer_to(part, {.about = Topic::face, .text = "ABC"});
    EXPECT_EQ(face.answer,
              "as far as the trace goes: 22 pixels plotted, 0 hidden by what is nearer, 22 seen at "
              "the end");
    EXPECT_THAT(face.lacks, Contains(region));
    const Explanation edge = answer_to(part, {.about = Topic::edge, .text = "AB"});
    EXPECT_EQ(edge.answer, "as far as the trace goes: 5 rows with this end");
    EXPECT_THAT(edge.lacks, ElementsAre(region));
}

TEST(Explain, AFaceOfATraceWithoutPrimitivesIsNotTold) {
    const Trace pixels =
        readable_trace(trace_text(first_triangle(), {.filter = {.only = {{StepKind::pixel}}}}));
    const Explanation face = answer_to(pixels, {.about = Topic::face, .text = "NOSUCH"});
    EXPECT_EQ(face.answer, "not told");
    EXPECT_THAT(face.lacks, Contains("primitive steps were left out of the trace"));
}

TEST(Explain, WhatIsHiddenBehindATriangleThatIsNotPainted) {
    const Trace trace = trace_of(scene_in(
        R"({"canvas":{"width":9,"height":9},"vertices":{"A":[-4,0,5],"B":[4,0,5]},"lines":["AB"],
            "meshes":[{"vertices":{"P":[-3,-3,2],"Q":[3,-3,2],"R":[0,3,2]},"faces":["PQR"],
            "draw":"hidden-lines"}],"method":{"depth":"linear-z"}})"));
    EXPECT_EQ(answer_to(trace, pixel(0, 0)).answer, "not drawn: PQR is not painted, AB is hidden");
    EXPECT_THAT(answer_to(trace, {.about = Topic::face, .text = "PQR"}).answer,
                testing::StartsWith("not painted: it only hides what lies behind it, at "));
}

TEST(Explain, ANameWithASlashIsNoPart) {
    const Trace trace = trace_of(scene_in(
        R"({"canvas":{"width":9,"height":9},"vertices":{"A":[-4,-4],"B":[-2,-4],"C":[-4,-2],
            "D":[0,0],"E":[3,0],"F":[0,3]},
            "triangles":[{"vertices":"ABC","name":"b"},{"vertices":"DEF","name":"b/1"}]})"));
    const Explanation face = answer_to(trace, {.about = Topic::face, .text = "b"});
    EXPECT_EQ(face.answer, "6 pixels plotted, 0 hidden by what is nearer, 6 seen at the end");
    EXPECT_EQ(face.tries.size(), 1U);
}

// A at the far left of an edge of length 1e300: (4, -3) lies 5 / 2 from the edge of slope 0 through A.
TEST(Explain, ADistanceFromAnEdgeOfAnyLength) {
    const Trace trace = trace_of(scene_in(
        R"({"canvas":{"width":9,"height":9},"vertices":{"A":[0,0],"B":[1e300,1],"C":[3,1e300]},
            "triangles":["ABC"],"method":{"scalar":"exact","fill":"top-left"}})"));
    const Explanation below = answer_to(trace, pixel(4, -3));
    ASSERT_EQ(below.why_not.size(), 1U);
    ASSERT_TRUE(below.why_not[0].distance);
    EXPECT_DOUBLE_EQ(*below.why_not[0].distance, 2.5);
}

TEST(Explain, TheLastPixelOfALineMayBeLeftOut) {
    const Trace trace = trace_of(
        scene_in(R"({"vertices":{"A":[0,0],"B":[3,0]},"lines":["AB"],"method":{"ends":"first"}})"));
    const Explanation above = answer_to(trace, pixel(3, 1));
    EXPECT_EQ(reason_of(above, "AB"),
              "elsewhere: the last pixel of the line, (3, 0), is left out (ends: first)");
    EXPECT_EQ(above.why_not[0].distance, 1);
}

TEST(Explain, WithoutDepthStepsNothingSaysWhatIsHidden) {
    const Scene scene = scene_in(
        R"({"canvas":{"width":9,"height":9},"vertices":{"A":[-4,0,5],"B":[4,0,5],"P":[-3,-3,2],
            "Q":[3,-3,2],"R":[0,3,2]},"triangles":["PQR"],"lines":["AB"],"points":["A"],
            "method":{"depth":"linear-z"}})");
    const Trace trace = readable_trace(
        trace_text(scene, {.filter = {.only = {{StepKind::primitive, StepKind::pixel}}}}));
    EXPECT_EQ(reason_of(answer_to(trace, pixel(0, 0)), "AB"),
              "unknown: the line goes from x = -4 to 4; no step of the trace says where it is at "
              "x = 0");
    EXPECT_THAT(answer_to(trace, {.about = Topic::face, .text = "PQR"}).answer,
                testing::Not(HasSubstr("hidden")));
}

TEST(Explain, WhyNoStepTestsAFace) {
    const Trace trace = trace_of(scene_in(
        R"({"vertices":{"A":[0,0],"B":[3,0],"C":[0,3],"D":[1,1],"E":[2,2]},
            "triangles":["ABC","ADE"],"lines":["AB"],"method":{"cull":"back"}})"));
    const Explanation flat = answer_to(trace, {.about = Topic::face, .text = "ADE"});
    EXPECT_THAT(flat.lacks, ElementsAre("it was skipped before it was tested"));
    const auto line = explain(trace, {.about = Topic::face, .text = "AB"});
    ASSERT_FALSE(line);
    EXPECT_EQ(line.problem().message, "--face: expected the name of a face, found \"AB\"");
}

/// A fan writes pixels near its corner several times.
TEST(Explain, AFaceHasPixelsAndNotWrites) {
    const Trace trace = trace_of(first_triangle({.scalar = ScalarKind::exact, .fill = Fill::fan}));
    ASSERT_GT(trace.end->count.at("pixel"), *trace.end->pixels);
    const std::string pixels = std::to_string(*trace.end->pixels);
    EXPECT_EQ(answer_to(trace, {.about = Topic::face, .text = "ABC"}).answer,
              pixels + " pixels plotted, 0 hidden by what is nearer, " + pixels +
                  " seen at the end");
}

TEST(Explain, TheFirstDecisionThatDiffers) {
    const Trace floor = first_triangle_by(Fill::scanline);
    const Trace truncate = first_triangle_by(Fill::scanline, Rounding::truncate);
    const auto difference = first_difference(floor, truncate, pixel(-1, 2));
    ASSERT_TRUE(difference && difference->one && difference->other);
    EXPECT_THAT(difference->one->sentence, HasSubstr("-1/4 -> floor -> -1"));
    EXPECT_THAT(difference->other->sentence, HasSubstr("-1/4 -> truncate -> 0"));
    EXPECT_FALSE(first_difference(floor, truncate, pixel(1, 4))); // 5/4 -> 1 by both
}

TEST(Explain, AStepThatChangesNothingIsNoDecision) {
    const Trace rows = first_triangle_by(Fill::scanline);
    Scene culled = first_triangle({.scalar = ScalarKind::exact, .fill = Fill::scanline});
    culled.method.cull = Cull::back;
    EXPECT_FALSE(first_difference(rows, trace_of(culled), pixel(0, 0))); // tested, and drawn
    culled.method.cull = Cull::front;
    const auto difference = first_difference(rows, trace_of(culled), pixel(0, 0));
    ASSERT_TRUE(difference && difference->other);
    EXPECT_THAT(difference->other->sentence, testing::EndsWith("culled"));

    // 49 pixels against 36: the first row, y = 5, has the pixel (2, 5) by one of the rules only.
    const auto face = first_difference(rows, first_triangle_by(Fill::top_left),
                                       {.about = Topic::face, .text = "ABC"});
    ASSERT_TRUE(face && face->one);
    EXPECT_THAT(face->one->sentence, testing::StartsWith("pixel (2, 5)"));
}

TEST(Explain, AStepIsFoundInAnotherTraceByWhatItIsAbout) {
    const Trace rows = first_triangle_by(Fill::scanline);
    Scene scene = first_triangle({.scalar = ScalarKind::exact, .fill = Fill::scanline});
    scene.method.cull = Cull::back;
    const Question row{.about = Topic::step, .text = "scanline y=2"};
    const Question numbered{.about = Topic::step,
                            .text = std::to_string(answer_to(rows, row).tries.at(0).number)};
    const Trace tested = trace_of(scene); // one step more, the facing test
    const auto there = question_for(tested, rows, numbered);
    ASSERT_TRUE(there);
    EXPECT_EQ(answer_to(tested, *there).tries.at(0).sentence,
              answer_to(rows, row).tries.at(0).sentence);

    scene.method.cull = Cull::front;
    EXPECT_FALSE(question_for(trace_of(scene), rows, numbered)); // nothing is drawn
}

TEST(Explain, APairBeyondTheRegionIsNotTold) {
    const Trace trace = traced_in_region(
        lettered_triangles(
            {{'p', {"0", "0", "9", "0", "0", "9"}}, {'q', {"9", "0", "9", "9", "0", "9"}}},
            {.width = 10, .height = 10, .origin = Origin::bottom_left},
            {.scalar = ScalarKind::exact, .fill = Fill::fan}),
        {0, 0, 1, 1});
    const Explanation pair = answer_to(trace, {.about = Topic::pair, .text = "p,q"});
    EXPECT_THAT(pair.answer, HasSubstr(" 0 of neither, "));
    EXPECT_THAT(pair.answer, testing::EndsWith(" not told"));
}

TEST(Explain, ARowSaysWhoseItIs) {
    const Trace two = trace_of(lettered_triangles(
        {{'p', {"0", "0", "9", "0", "0", "9"}}, {'q', {"9", "0", "9", "9", "0", "9"}}},
        {.width = 10, .height = 10, .origin = Origin::bottom_left},
        {.scalar = ScalarKind::exact, .fill = Fill::scanline}));
    const Explanation row = answer_to(two, {.about = Topic::scanline, .pixel = {0, 3}});
    ASSERT_EQ(row.tries.size(), 2U);
    EXPECT_EQ(row.tries[0].primitive, "p");
    EXPECT_EQ(row.tries[1].primitive, "q");

    const Trace line = trace_of(scene_in(R"({"vertices":{"A":[0,0],"B":[3,0]},"lines":["AB"]})"));
    EXPECT_EQ(answer_to(line, {.about = Topic::scanline, .pixel = {0, 0}}).answer,
              "no filled triangle has this row; 1 line with pixels in it has no rows");
    EXPECT_EQ(answer_to(line, {.about = Topic::scanline, .pixel = {0, 1}}).answer,
              "no primitive has this row");
}

TEST(Explain, AnEdgeOfATriangleThatIsCulled) {
    const Trace trace = trace_of(scene_in(
        R"({"vertices":{"A":[0,0],"B":[3,0],"C":[0,3],"D":[0,-3]},"triangles":["ABC","ABD"],
            "method":{"cull":"back"}})"));
    EXPECT_EQ(answer_to(trace, {.about = Topic::edge, .text = "AD"}).answer,
              "no edge is set up: ABD is culled");
}

TEST(Explain, APairIsAskedByTheNamesOfWhatIsDrawn) {
    const Trace clipped = trace_of(scene_in(
        R"({"canvas":{"width":9,"height":9},"vertices":{"A":[0,0,-5],"B":[1,0,5],"C":[0,1,5],
            "D":[2,2,5]},"triangles":["ABC","BCD"],
            "projection":{"type":"pinhole","distance":1}})"));
    const auto pair = explain(clipped, {.about = Topic::pair, .text = "ABC,BCD"});
    ASSERT_FALSE(pair);
    EXPECT_EQ(to_text(pair.problem()),
              "--pair: expected the name of a triangle that is drawn, found \"ABC\"\n"
              "hint: ABC was clipped: ask of its parts, ABC/1, ABC/2");

    const Trace named = trace_of(scene_in(
        R"({"vertices":{"A":[0,0],"B":[3,0],"C":[0,3],"D":[3,3]},
            "triangles":[{"vertices":"ABC","name":"a,b"},{"vertices":"BCD","name":"c"}]})"));
    EXPECT_THAT(answer_to(named, {.about = Topic::pair, .text = "a,b,c"}).answer,
                testing::StartsWith("edge BC: "));
}

TEST(Explain, AMethodIsReadFromOneWord) {
    const auto method = parse_method({"--against", "fill=top-left,color-rounding=truncate"});
    ASSERT_TRUE(method);
    EXPECT_THAT(method.value(), ElementsAre(std::pair("fill", "top-left"),
                                            std::pair("color_rounding", "truncate")));
    EXPECT_EQ(to_text(parse_method({"--against", "fill=top-lfet"}).problem()),
              "--against: expected fill out of scanline, two-halves, barycentric, top-left, fan, "
              "found \"top-lfet\"\nfill=top-lfet\n     ^\nhint: did you mean top-left?");
    EXPECT_EQ(to_text(parse_method({"--against", "truncate"}).problem()),
              "--against: expected a choice like rounding=truncate, found \"truncate\"\n"
              "truncate\n^");
}

} // namespace
} // namespace rastertrace
