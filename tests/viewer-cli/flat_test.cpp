// SPDX-License-Identifier: MIT
// `rastertrace trace --flat` as a user calls it.

#include "effort.h"
#include "program.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

using Json = nlohmann::json;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

/// A program that is started counts the memory of the one that starts it: a suite of its own has little.
class FlatMemoryTest : public ProgramTest {};

TEST_F(FlatMemoryTest, DoesNotGrowWithTheTrace) {
    if (is_sanitized)
        GTEST_SKIP() << "the sanitizer needs memory of its own";
    write("scene.json", R"({"canvas":{"width":800,"height":800},"method":{"fill":"barycentric"},
                            "vertices":{"A":[-390,-390],"B":[390,-390],"C":[0,390]},
                            "triangles":["ABC"]})");
    EXPECT_LT(run("trace scene.json --flat -o flat.jsonl").peak_memory, 48'000'000);
    EXPECT_GT(fs::file_size(folder_ / "flat.jsonl"), 70'000'000u);
}

class FlatTest : public ProgramTest {};

TEST_F(FlatTest, EveryStepOfEveryExampleHasItsNumberAndItsPrimitive) {
    std::size_t traces = 0;
    for (const auto& entry : fs::recursive_directory_iterator(RASTERTRACE_EXAMPLES)) {
        if (entry.path().extension() != ".json")
            continue;
        for (const std::string scalar : {"double", "exact"}) {
            SCOPED_TRACE(entry.path().string() + " " + scalar);
            const Outcome outcome = shell(
                "scene='" + entry.path().string() + "'; options='--frame 1 --scalar " + scalar +
                "'; $rastertrace trace $scene $options -o t.jsonl 2>no-scene || exit 9; "
                "$rastertrace trace $scene $options --flat -o flat.jsonl && "
                "$rastertrace trace t.jsonl --flat | cmp - flat.jsonl");
            if (outcome.status == 9)
                continue; // no scene, or none that is drawn in such numbers
            ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
            ++traces;
            const auto steps = lines_of(content("t.jsonl"));
            const auto rows = lines_of(content("flat.jsonl"));
            ASSERT_EQ(rows.size(), steps.size() - 2);
            std::string in;
            for (std::size_t n = 1; n <= rows.size(); ++n) {
                if (steps[n].starts_with(R"({"step":"primitive")"))
                    in = R"("in":)" + Json::parse(steps[n])["name"].dump() + ",";
                ASSERT_EQ(rows[n - 1],
                          "{\"n\":" + std::to_string(n) + "," + in + steps[n].substr(1));
            }
        }
    }
    EXPECT_GT(traces, 100u);
}

/// What a foreign rasterizer has put in, or written in its own way, stays as it is.
TEST_F(FlatTest, StepsOfOthersAreLinesToo) {
    write("foreign.jsonl",
          R"({"rastertrace":1,"canvas":{"width":9,"height":9}}
{"step":"pixel","x":0,"y":0}
{"step":"primitive", "kind":"triangle","name":"=A\"é","code":"raster.cpp:1"}
{"name":"B","step":"primitive","kind":"triangle"}
{"x":3,"y":"4","step":"shaded"}
{"end":{}}
)");
    EXPECT_THAT(run("trace foreign.jsonl --flat"), Prints(R"({"n":1,"step":"pixel","x":0,"y":0}
{"n":2,"in":"=A\"é","step":"primitive", "kind":"triangle","name":"=A\"é","code":"raster.cpp:1"}
{"n":3,"in":"B","name":"B","step":"primitive","kind":"triangle"}
{"n":4,"in":"B","x":3,"y":"4","step":"shaded"}
)"));
}

TEST_F(FlatTest, ItDoesNotMatterHowTheTraceIsLaidOut) {
    EXPECT_EQ(shell("scene=$examples/t0-hidden/cube-culled.json; "
                    "$rastertrace trace $scene -o t.json; $rastertrace trace $scene -o t.jsonl; "
                    "tr '\\n' ' ' <t.json >one-line.json; $rastertrace trace $scene --flat >flat; "
                    "for from in t.json t.jsonl one-line.json; do "
                    "$rastertrace trace $from --flat | cmp - flat || exit 1; done; "
                    "$rastertrace trace $scene --only face,pixel >part.json && "
                    "$rastertrace trace part.json --flat >part && "
                    "$rastertrace trace $scene --only face,pixel --flat | cmp - part")
                  .status,
              0);
}

TEST_F(FlatTest, ADamagedTraceIsRefusedAndNoFileIsLeft) {
    run("trace $examples/t0-fill/first-triangle.json -o whole.jsonl; head -n 20 whole.jsonl "
        ">cut.jsonl; sed '9s/\"y\":[0-9]*/\"y\":\"?\"/' whole.jsonl >damaged.jsonl; sed "
        "'s/\"steps\":62/\"steps\":63/' whole.jsonl >miscounted.jsonl");
    for (const std::string name :
         {"none.jsonl", "cut.jsonl", "damaged.jsonl", "miscounted.jsonl"}) {
        const Outcome refused =
            run("trace " + name + " --flat -o out; s=$?; test ! -e out && exit $s");
        EXPECT_EQ(refused.status, 2) << name;
        EXPECT_EQ(refused.err, run("stats " + name).err);
    }
    EXPECT_THAT(run("trace whole.jsonl --flat --format json"), Refused(HasSubstr("--format")));
}

} // namespace
} // namespace rastertrace
