// SPDX-License-Identifier: MIT
// What is told is what decided: whoever does a step's arithmetic again, from the numbers in the trace and
// in the scalar that its header names, gets the decision written there. docs/trace-format.md, "Doing it
// again", says which numbers decide what, and in which order they are added and multiplied.

#include "effort.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/audit/redo.h>
#include <rastertrace/trace/record/step_decoder.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/scene/scene_file.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <string_view>

namespace rastertrace {
namespace {

/// Draws a scene, decides everything again, and adds up how often.
void redo(const std::string& json, std::map<std::string, std::uint64_t>& counts) {
    const auto read = read_scene({"scene.json", json});
    if (!read)
        return; // refused
    const Trace trace = trace_of(read.value().scene);
    const Redone redone = redo(trace);
    if (redone.wrong > 0)
        ADD_FAILURE() << json << "\n" << to_text(problem_of(redone, trace));
    for (const auto& [what, count] : redone.count)
        counts[std::string(what)] += count;
}

TEST(Redo, EveryDecisionOfRandomScenes) {
    std::map<std::string, std::uint64_t> counts;
    for (unsigned seed = 1; seed <= random_cases(1500U) && !HasFailure(); ++seed)
        redo(RandomScene(seed).text(), counts);
    // None of the kinds was missed.
    for (const char* const kind : {"triangulate: normal",
                                   "triangulate: drops",
                                   "triangulate: ears",
                                   "matrix: rows",
                                   "matrix: camera",
                                   "vertex: at",
                                   "vertex: snapped",
                                   "order: names",
                                   "order: distances",
                                   "primitive: at",
                                   "primitive: octant",
                                   "face: normal",
                                   "face: view",
                                   "face: dot",
                                   "face: cosine",
                                   "face: culled",
                                   "face: opposite",
                                   "light: normal",
                                   "light: dot",
                                   "light: intensity",
                                   "light: color",
                                   "clip: out",
                                   "edge: a",
                                   "edge: b",
                                   "edge: top_left",
                                   "edge: dx_dy",
                                   "edge: octant",
                                   "half: from_y",
                                   "half: to_y",
                                   "ray: x",
                                   "ray: y",
                                   "crossings: x",
                                   "crossings: winding",
                                   "scanline: left",
                                   "scanline: right",
                                   "scanline: from",
                                   "scanline: to",
                                   "scanline: left_depth",
                                   "scanline: right_depth",
                                   "along: value",
                                   "along: pixel",
                                   "decide: d",
                                   "decide: move",
                                   "sample: weights",
                                   "sample: inside",
                                   "depth: depth",
                                   "depth: stored",
                                   "depth: pass",
                                   "pixel: x",
                                   "pixel: y",
                                   "pixel: color",
                                   "reject: why",
                                   "skip: why"})
        EXPECT_GE(counts[kind], random_cases(20U)) << kind;
}

/// Triangles and lines whose corners lie on samples and rows, or next to them: so near that no double, or
/// no fraction of 200 digits, is there.
std::string scene_near_ties(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    const auto pick = [&random](auto... values) {
        const std::array all{std::string(values)...};
        return all[random() % all.size()];
    };
    const std::string digits = pick("17", "30", "120", "250");
    const std::string scale = pick("", "", "000000000000000"); // 1e15
    const auto number = [&] {
        // Halves, and a unit of the last digit more or less.
        const auto halves = static_cast<int>(random() % 25) - 1;
        const std::string zeros(std::stoul(digits), '0');
        const mpz_class above = mpz_class(std::to_string(halves) + scale + zeros) +
                                mpz_class(pick("0", "0", "1", "-1"));
        return '"' + above.get_str() + "/2" + zeros + '"';
    };
    // A line that rounds to pixels has no right end.
    const std::string rounding = pick("floor", "nearest", "truncate", "inside", "half-open");
    const std::string line = rounding == "half-open" ? "bresenham" : pick("naive", "dda");
    std::string text = R"({"canvas":{"width":12,"height":12,"origin":")" +
                       pick("top-left", "bottom-left") + R"("},"vertices":{)";
    for (const char* const name : {"A", "B", "C", "D"})
        text += std::string(name == std::string_view("A") ? "" : ",") + '"' + name + R"(":[)" +
                number() + ',' + number() + ',' + number() + ']';
    return text + R"(},"triangles":["ABC","ABD"],"lines":["AB","CD"],"colors":{"A":"red"},)" +
           R"("method":{"scalar":")" + pick("float", "double", "fixed", "adaptive", "exact") +
           R"(","fill":")" + pick("scanline", "two-halves", "barycentric", "top-left", "top-left") +
           R"(","line":")" + line + R"(","depth":")" + pick("none", "linear-z") +
           R"(","rounding":")" + rounding + R"(","depth_at":")" + pick("pixel", "rounded-ends") +
           R"(","color_rounding":")" + pick("nearest", "truncate") + R"(","ends":")" +
           pick("both", "first") + R"(","lerp":")" + pick("direct", "incremental") +
           R"(","snap":")" + pick("none", "none", "floor", "truncate", "nearest") +
           R"(","sample":")" + pick("integer", "center") + R"("}})";
}

TEST(Redo, PixelsThatTheEdgeFunctionsOnceContradicted) {
    // In doubles, pixel (5, 2) lies on the right edge or next to it.
    std::map<std::string, std::uint64_t> counts;
    redo(R"({"canvas":{"width":8,"height":6,"origin":"top-left"},
             "vertices":{"A":[0.4,3.9],"B":[4.0,0.5],"C":[6.7,4.1]},"triangles":["ABC"],
             "method":{"fill":"top-left","scalar":"double"}})",
         counts);
    EXPECT_GT(counts["pixel: x"], 5U);
}

TEST(Redo, KeysOfThePainterThatRoundToOneDouble) {
    // Two keys are one number, a third one is next to them.
    std::map<std::string, std::uint64_t> counts;
    redo(R"({"canvas":{"width":8,"height":8,"origin":"top-left"},"vertices":{
             "A":[1,1,"3.00000000000000000001"],"B":[6,1,"3.00000000000000000001"],
             "C":[6,5,"3.00000000000000000001"],"D":[1,1,3],"E":[6,1,3],"F":[6,5,3],
             "G":[1,1,2],"H":[1,1,2],"I":[6,5,2]},"triangles":["GHI","ABC","BCA","DEF"],
             "method":{"scalar":"adaptive","depth":"painter"}})",
         counts);
    EXPECT_EQ(counts["order: names"], 4U);
}

TEST(Redo, ACrossingIsToldAsCertainAsItIsRounded) {
    // The edge AC meets the row's samples half an ulp from one of them.
    std::map<std::string, std::uint64_t> counts;
    redo(R"({"canvas":{"width":8,"height":4,"origin":"top-left"},"vertices":{
             "A":["9007199254740991/18014398509481984","9007199254740991/18014398509481984"],
             "B":["4503599627370498/9007199254740992","4503599627370497/9007199254740992"],
             "C":[7.25,"4503599627370497/9007199254740992"]},"triangles":["ABC"],
             "method":{"scalar":"adaptive","fill":"top-left"}})",
         counts);
    EXPECT_GT(counts["scanline: from"], 0U);
}

TEST(Redo, CornersOfManyDigitsAreToldInFull) {
    std::map<std::string, std::uint64_t> counts;
    redo(R"({"canvas":{"width":8,"height":8,"origin":"top-left"},"vertices":{"A":[1,"0.)" +
             std::string(322, '0') + "7" + std::string(250, '3') +
             R"("],"B":[6,1],"C":[6,5]},"triangles":["ABC"],
                       "method":{"scalar":"adaptive","fill":"top-left"}})",
         counts);
    EXPECT_GT(counts["pixel: x"], 5U);
}

TEST(Redo, AdaptiveWritesTheFractionThatDecides) {
    // A lies just left of 3, by so much that its nearest double is 3.
    const auto steps_with = [](const std::string& x, const std::string& kind) {
        const auto read = read_scene({"s.json",
                                      R"({"canvas":{"width":8,"height":4,"origin":"top-left"},
                "vertices":{"A":[")" + x + R"(",0],"B":[6,0],"C":[6,3]},"triangles":["ABC"],
                "method":{"scalar":"adaptive"}})"});
        const std::string text = trace_text(read.value().scene);
        const std::size_t begin = text.find(R"({"step":")" + kind + '"');
        return text.substr(begin, text.find('\n', begin) - begin);
    };
    EXPECT_THAT(
        steps_with("2.9999999999999999999", "scanline"),
        testing::HasSubstr(R"("left":"29999999999999999999/10000000000000000000","right":"6",)"
                           R"("from":2,"to":6)"));
    // Of 1,000 digits.
    const std::string digits = std::string(19, '9') + std::string(981, '7');
    const std::string long_step = steps_with("2." + digits, "scanline");
    EXPECT_THAT(long_step, testing::HasSubstr(R"("from":2,"to":6)"));
    EXPECT_EQ(*std::get<ScanlineStep>(step_in_text(long_step, StepKind::scanline)).left.exact(),
              Rational("2" + digits + "/1" + std::string(1000, '0')));
}

/// A trace of the first triangle with one text in the place of another.
Trace changed_trace(const std::string& from, const std::string& to) {
    std::string text = trace_text(scene_in(R"({"canvas":{"width":17,"height":14,"origin":"center"},
        "vertices":{"A":[2,5],"B":[-4,-3],"C":[5,-3]},"triangles":["ABC"]})"));
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return readable_trace(text.replace(at, from.size(), to));
}

// x of AB on row 2 is 2 + 3/4 (2 - 5) = -1/4, and its floor is -1.
TEST(Redo, TellsTheFirstDecisionThatIsAnotherOne) {
    const Trace right = changed_trace(R"("left":-0.25)", R"("left":-0.25)");
    EXPECT_EQ(redo(right).wrong, 0U);
    const Trace trace = changed_trace(R"("right":3.125,"from":-1)", R"("right":3.125,"from":0)");
    const Redone redone = redo(trace);
    EXPECT_EQ(redone.first.what, "scanline: from");
    EXPECT_EQ(redone.first.redone, "-1");
    EXPECT_EQ(redone.first.told, "0");
    EXPECT_THAT(trace.step(redone.first.step).json(), testing::HasSubstr(R"("y":2)"));
    EXPECT_THAT(to_text(problem_of(redone, trace)),
                testing::HasSubstr("-0.25 = -1/4 -> floor -> 0"));
}

TEST(Redo, DoesAgainOnlyWhatIsToldTheNumbersAndTheRuleOf) {
    // 1/4 is no slope of AB; without a scalar nobody knows how exact it was meant to be.
    const std::string slope = R"("edge":"AB","dx_dy":0.75)";
    EXPECT_EQ(redo(changed_trace(slope, R"("edge":"AB","dx_dy":0.25)")).first.what, "edge: dx_dy");
    EXPECT_EQ(redo(changed_trace(R"("scalar":"double",)", "")).count.count("edge: dx_dy"), 0U);
    EXPECT_EQ(redo(changed_trace(R"("rounding":"floor")", R"("other":"floor")"))
                  .count.count("scanline: from"),
              0U);
    // Corners that are missing, or are no numbers, are no fault of a decision.
    for (const std::string corners : {"[[2,5]]", R"([["NaN",5],[-4,-3],[5,-3]])", R"("none")"})
        EXPECT_EQ(redo(changed_trace(R"("at":[[2,5],[-4,-3],[5,-3]])", "\"at\":" + corners)).wrong,
                  0U)
            << corners;
}

TEST(Redo, EveryDecisionNextToATie) {
    std::map<std::string, std::uint64_t> counts;
    for (unsigned seed = 1; seed <= random_cases(1500U) && !HasFailure(); ++seed)
        redo(scene_near_ties(seed), counts);
    for (const char* const kind :
         {"scanline: from", "scanline: to", "along: pixel", "sample: inside", "vertex: snapped"})
        EXPECT_GT(counts[kind], random_cases(1000U)) << kind;
}

} // namespace
} // namespace rastertrace
