// SPDX-License-Identifier: MIT
// What is handed out to be worked out by hand: it can be read as claims, and says no number.

#include "effort.h"
#include "picture.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/check/claims_template.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using testing::Each;
using testing::HasSubstr;

/// True of a field that says which step is meant.
bool is_key(const std::string& kind, const std::string& field) {
    const auto& fields = fields_of(*step_kind_named(kind));
    return field == "in" ||
           std::any_of(fields.begin(), fields.end(), [&field](const StepField& one) {
               return one.name == field && one.role == FieldRole::key;
           });
}

/// All that a claim says of its step, beside which one it is.
std::vector<std::string> values_of(const Claim& claim) {
    std::vector<std::string> values;
    for (const ClaimedField& field : claim.fields)
        if (!is_key(claim.step, field.name))
            values.insert(values.end(), field.values.begin(), field.values.end());
    return values;
}

/// Fails unless a template can be read and leaves everything open.
void expect_open(const std::string& text) {
    const auto claims = read_claims({"template", text});
    ASSERT_TRUE(static_cast<bool>(claims)) << to_text(claims.problem());
    for (const Claim& claim : claims.value().claims) {
        EXPECT_THAT(values_of(claim), Each(open_value)) << claim.text;
        for (const std::string& row : claim.picture)
            EXPECT_EQ(row, std::string(row.size(), '?'));
    }
}

TEST(ClaimsTemplate, OfTheFirstTriangleAsksForItsEdgesRowsAndPicture) {
    std::string picture;
    for (int row = 0; row < 10; ++row)
        picture += "???????????\n";
    EXPECT_EQ(claims_template(trace_of(small_first_triangle())), "edge AB: ?\n"
                                                                 "edge AC: ?\n"
                                                                 "\n"
                                                                 "y=5: ?, ? -> ?..?\n"
                                                                 "y=4: ?, ? -> ?..?\n"
                                                                 "y=3: ?, ? -> ?..?\n"
                                                                 "y=2: ?, ? -> ?..?\n"
                                                                 "y=1: ?, ? -> ?..?\n"
                                                                 "y=0: ?, ? -> ?..?\n"
                                                                 "y=-1: ?, ? -> ?..?\n"
                                                                 "y=-2: ?, ? -> ?..?\n"
                                                                 "y=-3: ?, ? -> ?..?\n"
                                                                 "\n"
                                                                 "picture:\n" +
                                                                     picture);
}

TEST(ClaimsTemplate, AsksForWhatASceneInSpaceHas) {
    Scene cube = cube_of_t0({"ABC", "ACD", "AED"});
    cube.method.depth = Depth::inverse_z;
    cube.method.snap = Snap::floor;
    const std::string text = claims_template(trace_of(cube));
    for (const std::string line :
         {"A world: ?, ?, ?\n", "A clip: ?, ?, ?, ?\n", "A screen: ?, ? -> ?, ?\n",
          "normal ACD: ?, ?, ?\n", "dot ACD: ? ?\n", "ACD edge AC: ?\n",
          "ABC y=3 depth: ?, ?\ndepth ABC (-4,3): ? ?\n"})
        EXPECT_THAT(text, HasSubstr(line));
    EXPECT_EQ(text.find(" object:"), std::string::npos);
    expect_open(text);

    Scene line = first_triangle();
    line.primitives = {{.kind = PrimitiveKind::line, .name = "AB", .vertices = {0, 1}}};
    EXPECT_THAT(claims_template(trace_of(line)), HasSubstr("AB: ? ? ? ? ? ? ? ?\n\npicture:"));
}

TEST(ClaimsTemplate, QuotesNamesThatAreWordsOfTheTable) {
    const std::string text = claims_template(trace_of(scene_in(
        R"({"vertices":{"normal":[0,0],"a b":[5,0],"#":[2,7]},
            "triangles":[["normal","a b","#"],{"vertices":["#","normal","a b"],"name":"order"}]})")));
    EXPECT_THAT(text, HasSubstr(R"("order" y=)"));
    expect_open(text);
}

TEST(ClaimsTemplate, OfALongTraceEndsAndSaysSo) {
    Scene scene = first_triangle();
    scene.vertices[0].y = 2000;
    scene.canvas = {.width = 17, .height = 4100};
    const std::string text = claims_template(trace_of(scene));
    EXPECT_THAT(text, HasSubstr("\n# and 1506 more lines\n")); // 2 edges, 2004 rows, 500 lines
    EXPECT_EQ(text.find("picture"), std::string::npos);
    expect_open(text);
}

TEST(ClaimsTemplate, OfEveryExampleCanBeRead) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(RASTERTRACE_EXAMPLES)) {
        if (entry.path().extension() != ".json" || entry.file_size() > 10'000)
            continue;
        const auto source = read_source(entry.path().string());
        ASSERT_TRUE(static_cast<bool>(source));
        const auto scene = read_scene(source.value());
        ASSERT_TRUE(static_cast<bool>(scene)) << to_text(scene.problem());
        SCOPED_TRACE(entry.path().filename().string());
        expect_open(claims_template(trace_of(scene.value().scene)));
    }
}

TEST(ClaimsTemplate, OfRandomScenesCanBeRead) {
    int lines = 0;
    for (std::uint64_t seed = 1; seed <= random_cases(300u); ++seed) {
        const std::string text = RandomScene(seed).text();
        const auto scene = read_scene({"random.json", text});
        if (!scene)
            continue; // drawn by another test
        SCOPED_TRACE(text);
        const std::string written = claims_template(trace_of(scene.value().scene));
        lines += static_cast<int>(std::count(written.begin(), written.end(), '\n'));
        expect_open(written);
    }
    EXPECT_GT(lines, 1000);
}

} // namespace
} // namespace rastertrace
