// SPDX-License-Identifier: MIT
// What a trace tells of a polygon. The numbers are those of Foley, van Dam, Feiner and Hughes 1990, figure 3.22: scan
// line 8 meets the polygon at 2, 4.5, 8.5 and 13.

#include "claims_support.h"
#include "traces.h"

#include <rastertrace/core/raster/fill_edge_table.h>
#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/audit/stats.h>
#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/working.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace rastertrace {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string scene_text(const std::string& method = R"("scalar":"exact")") {
    return R"({"canvas":{"width":16,"height":13,"origin":"bottom-left"},)"
           R"("vertices":{"A":[2,3],"B":[7,1],"C":[13,5],"D":[13,11],"E":[7,7],"F":[2,9]},)"
           R"("polygons":["ABCDEF"],"method":{)" +
           method + "}}";
}

/// The number of the first step of a kind in a row.
std::size_t step_in_row(const Trace& trace, StepKind kind, Index y) {
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (trace.kind_of(n) == kind && y_in(trace.step(n)) == y)
            return n;
    return 0;
}

TEST(PolygonTrace, TellsTheCrossingsOfARow) {
    const Trace trace = trace_of(scene_in(scene_text()));
    Replay replay(trace);
    const std::size_t n = step_in_row(trace, StepKind::crossings, 8);
    replay.go_to(n);
    EXPECT_EQ(trace.step(n).json(), R"({"step":"crossings","y":8,"edges":["FA","FE","DE","DC"],)"
                                    R"("x":["2","9/2","17/2","13"],"winding":[1,0,1,0]})");
    EXPECT_EQ(
        describe_step(replay),
        "row y=8   FA at 2, winding 1   FE at 9/2, winding 0   DE at 17/2, winding 1   DC at 13, "
        "winding 0: inside where the winding number is odd");
    EXPECT_THAT(
        working_of(replay),
        Contains("DE: x = (x2 - x1)/(y2 - y1) (y - y1) + x1 = (7 - 13)/(7 - 11) (8 - 11) + 13 = "
                 "3/2 (-3) + 13 = 17/2"));
    EXPECT_THAT(working_of(replay), Contains("  the polygon runs up along FE: 1 - 1 = 0"));
    // Two spans follow.
    EXPECT_EQ(trace.step(n + 1).as<ScanlineStep>().left_edge.text(), "FA");
    EXPECT_EQ(trace.step(step_in_row(trace, StepKind::crossings, 7) - 1).as<PixelStep>().x, 13);
    EXPECT_THAT(trace_text(scene_in(scene_text(R"("fill_rule":"non-zero")"))),
                HasSubstr(R"("fill_rule":"non-zero")"));
}

TEST(PolygonTrace, IsDoneAgain) {
    for (const std::string scalar : {"float", "double", "fixed", "adaptive", "exact"})
        for (const std::string lerp : {"direct", "incremental"}) {
            const Redone right = redo(sound_trace(trace_text(scene_in(scene_text(
                R"("scalar":")" + scalar + R"(","lerp":")" + lerp + R"(","rounding":"inside")")))));
            EXPECT_EQ(right.wrong, 0U) << scalar << ' ' << lerp << ' ' << right.first.what;
            EXPECT_GE(right.count.at("scanline: left"), 10U);
        }
    const auto replaced = [](const std::string& from, const std::string& to) {
        std::string text = trace_text(scene_in(scene_text()));
        text.replace(text.find(from), from.size(), to);
        return redo(readable_trace(text)).first.what;
    };
    EXPECT_EQ(replaced(R"("x":["2","9/2")", R"("x":["2","7/2")"), "crossings: x");
    EXPECT_EQ(replaced(R"("winding":[1,0,1,0]})", R"("winding":[1,2,1,0]})"), "crossings: winding");
    EXPECT_EQ(replaced(R"("winding":[1,0,1,0]})", R"("winding":[1,1e300,1,0]})"),
              "crossings: winding");
    EXPECT_EQ(replaced(R"("left":"17/2")", R"("left":"19/2")"), "scanline: left");
    EXPECT_EQ(replaced(R"("left_edge":"DE")", R"("left_edge":"FE")"), "scanline: left_edge");
}

TEST(PolygonTrace, ExplainsWhatLiesBetweenTwoSpans) {
    const Trace trace = trace_of(scene_in(scene_text()));
    const auto why_not = [&trace](int x, int y) {
        const auto answer = explain(trace, {.about = Topic::pixel, .pixel = {x, y}});
        return answer && answer.value().why_not.size() == 1
                   ? answer.value().why_not.front().sentence
                   : "";
    };
    EXPECT_EQ(why_not(6, 8), "FE ends row y=8 at x = 9/2 -> floor -> 4; x = 6 lies beyond it by "
                             "3/2; the winding number there is 0");
    EXPECT_EQ(why_not(7, 8), "DE begins row y=8 at x = 17/2 -> floor -> 8; x = 7 lies before it by "
                             "3/2; the winding number there is 0");
    EXPECT_THAT(why_not(7, 12), HasSubstr("y=10 to 1"));
    const Stats stats = stats_of(trace);
    ASSERT_EQ(stats.primitives.size(), 1U);
    EXPECT_EQ(stats.primitives[0].over, 1U) << "both spans of row y=7 end in E";
    EXPECT_THAT(stats.unjudged, IsEmpty());
}

TEST(PolygonTrace, ClaimsAboutItsRowsAreChecked) {
    const auto field_of = [](const std::string& claim) {
        return check_claims(scene_text(), claim).claims.at(0).fields.at(0);
    };
    EXPECT_EQ(field_of("y=8: 2, 9/2, 17/2, 13\n").verdict, ClaimVerdict::right);
    EXPECT_EQ(field_of("y=10: 23/2, 13\n").verdict, ClaimVerdict::right);
    const CheckedField wrong = field_of("y=8: 2, 9/2, 8, 13\n");
    EXPECT_EQ(wrong.verdict, ClaimVerdict::wrong);
    EXPECT_EQ(wrong.expected, "2, 9/2, 17/2, 13");
}

TEST(PolygonTrace, HasTheRowsOfFoleyWithYUp) {
    const std::string scene = R"({"canvas":{"width":10,"height":10,"origin":"bottom-left"},)"
                              R"("vertices":{"A":[3,5],"B":[1,7],"C":[1,1],"D":[7,6]},)"
                              R"("polygons":["ABCD"],"method":{"scalar":"exact")";
    const auto checked =
        check_claims(scene + "}}", "y=1: 1, 1\ny=4: 1, 23/5\ny=5: 1, 3, 3, 29/5\ny=6: 1, 2\n");
    for (const auto& claim : checked.claims)
        for (const CheckedField& field : claim.fields)
            EXPECT_EQ(field.verdict, ClaimVerdict::right) << field.expected;
    // Both ends, said in the header; done again, too.
    const std::string closed = trace_text(scene_in(scene + R"(,"rows":"closed"}})"));
    EXPECT_THAT(closed, HasSubstr(R"("rows":"closed")"));
    EXPECT_THAT(closed, HasSubstr(R"({"step":"scanline","y":7,"left":"1","right":"1")"));
    const Redone redone = redo(sound_trace(closed));
    EXPECT_EQ(redone.wrong, 0U) << redone.first.what;
}

/// A span of several in one row is the one whose end is nearest.
TEST(PolygonTrace, ClaimsAboutOneSpanAreChecked) {
    const auto fields_of = [](const std::string& claim) {
        return check_claims(scene_text(), claim).claims.at(0).fields;
    };
    for (const std::string right : {"y=8: 2, 9/2 -> 2..4", "y=8: 17/2, 13 -> 8..13"})
        for (const CheckedField& field : fields_of(right + "\n"))
            EXPECT_EQ(field.verdict, ClaimVerdict::right) << right;
    const auto wrong = fields_of("y=8: 8, 13 -> 8..13\n");
    EXPECT_EQ(wrong.at(0).verdict, ClaimVerdict::wrong);
    EXPECT_EQ(wrong.at(0).expected, "17/2");
    EXPECT_EQ(wrong.at(1).verdict, ClaimVerdict::right);
}

/// The fan of a square with a notch: twice the areas 2, -1/2 and so on come to 2 times 3.
TEST(PolygonTrace, ANormalIsThatOfAllCorners) {
    const std::string face = R"({"canvas":{"width":40,"height":40,"origin":"center"},)"
                             R"("camera":{"position":[3,2,6]},)"
                             R"("projection":{"type":"frustum","fov_y":60,"near":1,"far":20},)"
                             R"("vertices":{"A":[-1,-1,1],"B":[1,-1,1],"C":[1,1,1],"D":[0,0,1],)"
                             R"("E":[-1,1,1]},"polygons":["ABCDE"],)"
                             R"("method":{"depth":"none","cull":"back","scalar":"exact"}})";
    const auto checked =
        check_claims(face, "normal ABCDE: 0, 0, 6\nnormal ABCDE: 0, 0, 4\n").claims;
    EXPECT_EQ(checked.at(0).fields.at(0).verdict, ClaimVerdict::right);
    const CheckedField& of_three = checked.at(1).fields.at(0);
    EXPECT_EQ(of_three.verdict, ClaimVerdict::wrong);
    ASSERT_FALSE(of_three.slips.empty());
    EXPECT_EQ(of_three.slips.front().name, "three-corners");

    const Trace trace = sound_trace(trace_text(scene_in(face)));
    Replay replay(trace, {.depths = true});
    for (std::size_t n = 1; n <= trace.size(); ++n)
        if (trace.kind_of(n) == StepKind::face) {
            replay.go_to(n);
            EXPECT_THAT(
                working_of(replay),
                Contains("normal = (B - A) x (C - A) + (C - A) x (D - A) + (D - A) x (E - A)"));
        }
}

TEST(PolygonScene, TakesFacesOfMeshesAsTheyAre) {
    const Scene scene =
        scene_in(R"({"meshes":[{"name":"m","vertices":{"A":[0,0],"B":[6,0],"C":[1,1],"D":[0,6]},)"
                 R"("faces":["ABCD"],"draw":"polygons"}]})");
    ASSERT_EQ(scene.primitives.size(), 1U);
    EXPECT_EQ(scene.primitives[0].name, "m.ABCD");
    EXPECT_EQ(scene.primitives[0].kind, PrimitiveKind::polygon);
    EXPECT_EQ(scene.primitives[0].corners().size(), 4U);
    EXPECT_THAT(scene.cut_faces, IsEmpty());
}

TEST(PolygonScene, IsWhatACanvasIsFittedTo) {
    const std::string vertices = R"("vertices":{"A":[0,0],"B":[10,0],"C":[12,6],"D":[5,10]})";
    for (const std::string& what :
         {"{" + vertices + R"(,"polygons":["ABCD"]})",
          R"({"meshes":[{)" + vertices + R"(,"faces":["ABCD"],"draw":"polygons"}]})"}) {
        const Scene scene = scene_in(what);
        EXPECT_EQ(scene.canvas.width, 27) << "x -12..12, and a pixel more on each side";
        EXPECT_EQ(scene.canvas.height, 23);
    }
}

TEST(PolygonScene, IsRefusedWithAReason) {
    const std::string start = R"({"vertices":{"A":[0,0],"B":[6,0],"C":[0,6]},"polygons":)";
    EXPECT_EQ(refusal_of_scene(start + R"(["AB"]})"),
              R"(expected three vertices or more, "ABCDE" or ["P1", ...], found "AB")");
    EXPECT_EQ(refusal_of_scene(start + R"("ABC"})"),
              R"(expected a list of polygons, like ["ABCDE"], found "ABC")");
    EXPECT_EQ(refusal_of_scene(start + R"(["ABC"],"method":{"depth":"linear-z"}})"),
              "expected no depth buffer beside a polygon, found one");
    EXPECT_EQ(
        refusal_of_scene(
            start +
            R"(["ABC"],"triangles":[{"vertices":"ABC","name":"t"}],"method":{"fill":"top-left"}})"),
        R"(expected triangles that are filled by rows beside polygons, found "fill": "top-left")");
    EXPECT_EQ(refusal_of_scene(start + "[\"" + std::string(most_corners, 'A') + "\"]}"), "");
    EXPECT_EQ(refusal_of_scene(start + "[\"" + std::string(most_corners + 1, 'A') + "\"]}"),
              "expected a polygon of at most 65535 vertices, found 65536");
}

} // namespace
} // namespace rastertrace
