// SPDX-License-Identifier: MIT
// Traces against stored ones, in a folder that each test has for itself.

#include "failures.h"
#include "picture.h"

#include <rastertrace/testing.h>
#include <rastertrace/trace/compare/diff.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/record/write_trace.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <variant>

namespace rastertrace {
namespace {

using namespace matchers;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

class MatchesTrace : public ::testing::Test {
protected:
    MatchesTrace() {
        std::string pattern = (fs::temp_directory_path() / "rastertrace-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
        older_ = fs::current_path();
        fs::current_path(folder_);
        ::unsetenv("RASTERTRACE_RENEW");
    }
    ~MatchesTrace() override {
        ::unsetenv("RASTERTRACE_RENEW");
        fs::current_path(older_);
        fs::remove_all(folder_);
    }

    /// Compares with RASTERTRACE_RENEW=1; returns what a failure says.
    static std::string renew(const TestedTrace& trace, const TraceMatcher& matcher) {
        ::setenv("RASTERTRACE_RENEW", "1", 1);
        std::string text = failures_of([&] { EXPECT_THAT(trace, matcher); });
        ::unsetenv("RASTERTRACE_RENEW");
        return text;
    }

    static std::string renewing_command(const std::string& test) {
        return std::string("RASTERTRACE_RENEW=1 ") + program_invocation_name +
               " --gtest_filter=MatchesTrace." + test;
    }

    static std::string text_of(const std::string& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    static std::size_t files() {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator("."), fs::directory_iterator()));
    }

private:
    fs::path folder_;
    fs::path older_;
};

/// The first triangle of T0; C may lie elsewhere in its row.
TestedTrace triangle(const std::string& x_of_c = "5") {
    return trace_of(
        triangle_scene({"2", "5", "-4", "-3", x_of_c, "-3"}, {.width = 17, .height = 14}));
}

/// What `trace --only` writes of it.
std::string written_only(const std::vector<StepKind>& kinds, TraceLayout layout) {
    std::string text;
    StringOutput output(text);
    write_trace(first_triangle(), {.layout = layout, .filter = {.only = kinds}}, output);
    return text;
}

TEST_F(MatchesTrace, RenewingWritesTheKindsAsTraceOnlyDoes) {
    const auto matcher = [](const std::string& path) {
        return matchers::MatchesTrace(path, {.kinds = {"scanline", "pixel"}});
    };
    EXPECT_EQ(renew(triangle(), matcher("golden.json")), "");
    EXPECT_EQ(text_of("golden.json"),
              written_only({StepKind::scanline, StepKind::pixel}, TraceLayout::json));
    EXPECT_EQ(renew(triangle(), matcher("golden.jsonl")), "");
    EXPECT_EQ(text_of("golden.jsonl"),
              written_only({StepKind::scanline, StepKind::pixel}, TraceLayout::jsonl));
    EXPECT_EQ(files(), 2U);
    EXPECT_THAT(triangle(), matcher("golden.json"));
    EXPECT_THAT(triangle(), matcher("golden.jsonl"));
}

TEST_F(MatchesTrace, WithoutKindsTheWholeTraceIsStored) {
    EXPECT_EQ(renew(triangle(), matchers::MatchesTrace("golden.json")), "");
    EXPECT_EQ(text_of("golden.json"), triangle().text);
    EXPECT_THAT(triangle(), matchers::MatchesTrace("golden.json"));
}

TEST_F(MatchesTrace, AFailureIsTheDiffAndTheRenewingCommand) {
    const auto matcher =
        matchers::MatchesTrace("golden.json", {.kinds = {"primitive", "scanline", "pixel"}});
    ASSERT_EQ(renew(triangle(), matcher), "");
    const TraceDiff found =
        diff(read_trace(read_source("golden.json").value()).value(), triangle("4").trace.value(),
             {.ignored = {"header"}, .only = {"primitive", "scanline", "pixel"}});
    ASSERT_THAT(diff_text(found), HasSubstr("4 pixels differ because of it"));
    EXPECT_EQ(failures_of([&] { EXPECT_THAT(triangle("4"), matcher); }),
              "Value of: triangle(\"4\")\n"
              "Expected: matches the trace golden.json\n"
              "  Actual: A triangle, 58 steps (of type rastertrace::matchers::TestedTrace), which "
              "differs:\n" +
                  diff_text(found) + "\nIf it should be as it is now, renew the golden:\n  " +
                  renewing_command("AFailureIsTheDiffAndTheRenewingCommand") + "\n");
}

TEST_F(MatchesTrace, RenewingMakesAFailedTestPass) {
    const auto matcher = matchers::MatchesTrace("golden.json", {.kinds = {"pixel"}});
    ASSERT_EQ(renew(triangle(), matcher), "");
    EXPECT_THAT(triangle("3"), Not(matcher));
    ASSERT_EQ(renew(triangle("3"), matcher), "");
    EXPECT_THAT(triangle("3"), matcher);
    EXPECT_THAT(triangle(), Not(matcher));
}

// Its other name is a link.
TEST_F(MatchesTrace, WhatTheTestHasReadIsNotRenewed) {
    std::ofstream("mine.jsonl") << triangle().text;
    fs::create_symlink("mine.jsonl", "golden.jsonl");
    fs::create_hard_link("mine.jsonl", "hard.jsonl");
    for (const std::string golden : {"mine.jsonl", "golden.jsonl", "hard.jsonl"})
        EXPECT_THAT(
            renew(trace_in("mine.jsonl"), matchers::MatchesTrace(golden, {.kinds = {"pixel"}})),
            HasSubstr("expected another file than those that are read, found one of them"));
    EXPECT_EQ(text_of("mine.jsonl"), triangle().text);
}

TEST_F(MatchesTrace, OtherKindsAndTheHeaderAreNotCompared) {
    const auto matcher = matchers::MatchesTrace("golden.json", {.kinds = {"scanline", "pixel"}});
    ASSERT_EQ(renew(triangle(), matcher), "");
    TestedTrace later = triangle();
    const auto replace = [&later](const std::string& from, const std::string& to) {
        const std::size_t place = later.text.find(from);
        ASSERT_NE(place, std::string::npos) << from;
        later.text.replace(place, from.size(), to);
    };
    replace(R"({"rastertrace":1,)", R"({"rastertrace":1,"new_key":[1,2],)");
    replace(R"("step":"edge",)", R"("step":"edge","new_field":7,)");
    EXPECT_THAT(trace_from({"later", later.text}), matcher);
    const auto with_edges = matchers::MatchesTrace("edges.json", {.kinds = {"edge", "pixel"}});
    ASSERT_EQ(renew(triangle(), with_edges), "");
    EXPECT_THAT(trace_from({"later", later.text}), Not(with_edges));
}

TEST_F(MatchesTrace, TolerancesAndIgnoredFieldsAreTaken) {
    ASSERT_EQ(renew(triangle(), matchers::MatchesTrace("golden.json", {.kinds = {"scanline"}})),
              "");
    // C moves by 1/100: no row ends in another pixel.
    const TestedTrace moved = triangle("5.01");
    EXPECT_THAT(moved, Not(matchers::MatchesTrace("golden.json", {.kinds = {"scanline"}})));
    EXPECT_THAT(moved,
                matchers::MatchesTrace(
                    "golden.json", {.kinds = {"scanline"}, .tolerances = {"scanline.right=0.01"}}));
    EXPECT_THAT(moved, Not(matchers::MatchesTrace(
                           "golden.json",
                           {.kinds = {"scanline"}, .tolerances = {"scanline.right=0.0099"}})));
    EXPECT_THAT(moved, matchers::MatchesTrace(
                           "golden.json", {.kinds = {"scanline"}, .ignored = {"scanline.right"}}));
}

TEST_F(MatchesTrace, ATraceOfAnotherRasterizerIsStoredAsItIs) {
    const std::string header =
        R"({"rastertrace":1,"canvas":{"width":4,"height":4,"origin":"top-left"},"method":{"mine":"yes"}})";
    const std::string text = header + "\n" + R"({"step":"pixel","x":1,"y":2,"own":0.1})" + "\n" +
                             R"({"step":"voxel","z":3})" + "\n" + R"({"end":{"steps":2}})" + "\n";
    const TestedTrace mine = trace_from({"mine.jsonl", text});
    ASSERT_EQ(renew(mine, matchers::MatchesTrace("golden.jsonl", {.kinds = {"voxel"}})), "");
    EXPECT_EQ(text_of("golden.jsonl"), header.substr(0, header.size() - 1) +
                                           R"(,"only":["voxel"]})" + "\n" +
                                           R"({"step":"voxel","z":3})" + "\n" +
                                           R"({"end":{"steps":1,"count":{"voxel":1}}})" + "\n");
    EXPECT_THAT(mine, matchers::MatchesTrace("golden.jsonl", {.kinds = {"voxel"}}));
    std::string other = text;
    other.replace(other.find(R"("z":3)"), 5, R"("z":4)");
    EXPECT_THAT(trace_from({"mine.jsonl", other}),
                Not(matchers::MatchesTrace("golden.jsonl", {.kinds = {"voxel"}})));
}

TEST_F(MatchesTrace, WhatCannotBeComparedIsSaid) {
    const auto refusal_of = [](const std::string& golden, const GoldenRules& rules) {
        const std::string text = failures_of(
            [&] { EXPECT_THAT(triangle(), Not(matchers::MatchesTrace(golden, rules))); });
        const std::string begin =
            "Failed\nA triangle\ncannot tell if it matches the trace " + golden + ": ";
        EXPECT_EQ(text.substr(0, begin.size()), begin);
        return text.substr(begin.size(), text.find("\nValue of") - begin.size());
    };
    const std::string hint =
        "\nhint: this makes it: " + renewing_command("WhatCannotBeComparedIsSaid");
    EXPECT_EQ(refusal_of("golden.json", {}),
              "golden.json: expected a golden, found no such file" + hint);
    EXPECT_EQ(refusal_of("golden.json", {.kinds = {"scanlime"}}),
              "expected kinds of step (triangulate, matrix, vertex, order, primitive, face, light, "
              "clip, edge, half, ray, crossings, scanline, along, decide, sample, depth, pixel, "
              "reject, skip, "
              "undecided), found scanlime\nhint: did you mean scanline?");
    std::ofstream("broken.json") << "{\"rastertrace\":1";
    EXPECT_EQ(refusal_of("broken.json", {}),
              "broken.json:1:17: expected ',' or '}', found the end of the file\n"
              "{\"rastertrace\":1\n"
              "                ^");
    std::ofstream("scene.json") << R"({"vertices":{"A":[1,2]},"points":["A"]})";
    EXPECT_EQ(refusal_of("scene.json", {}),
              "scene.json: expected a golden, found a file that is no trace");
    ASSERT_EQ(renew(triangle(), matchers::MatchesTrace("golden.json", {.kinds = {"pixel"}})), "");
    EXPECT_EQ(refusal_of("golden.json", {.kinds = {"pixel", "edge"}}),
              "golden.json: expected a golden with steps of pixel, edge, found one with pixel" +
                  hint);
    EXPECT_EQ(refusal_of("golden.json", {.tolerances = {"often"}}),
              "--tolerance: expected KIND.FIELD=NUMBER, KIND=NUMBER or NUMBER, like "
              "scanline.left=1e-9 or 4ulp, found \"often\"");
    EXPECT_EQ(refusal_of("golden.json", {.ignored = {"pixel.colour"}}),
              "--ignore: expected a field of pixel (x, y, color), found colour\n"
              "hint: did you mean color?");
}

// A typing error in the name of a golden must not cost a source file.
TEST_F(MatchesTrace, RenewingLeavesAFileAloneThatIsNoTrace) {
    const std::string scene = R"({"vertices":{"A":[1,2]},"points":["A"]})";
    std::ofstream("scene.json") << scene;
    std::ofstream("main.cpp") << "int main() {}\n";
    for (const std::string name : {"scene.json", "main.cpp"})
        EXPECT_EQ(renew(triangle(), matchers::MatchesTrace(name)),
                  "Failed\nA triangle\ncannot tell if it matches the trace " + name + ": " + name +
                      ": expected a golden to renew, found a file that is no trace\n");
    EXPECT_EQ(text_of("scene.json"), scene);
    EXPECT_EQ(text_of("main.cpp"), "int main() {}\n");
    EXPECT_EQ(files(), 2U);
}

TEST_F(MatchesTrace, ADamagedTraceIsNotStored) {
    const TestedTrace whole = triangle();
    const TestedTrace cut = trace_from({"cut", whole.text.substr(0, whole.text.size() / 2)});
    EXPECT_THAT(renew(cut, matchers::MatchesTrace("golden.json")), HasSubstr("truncated"));
    EXPECT_EQ(files(), 0U);
}

} // namespace
} // namespace rastertrace
