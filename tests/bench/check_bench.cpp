// SPDX-License-Identifier: MIT
// A thousand claims about the rows of a triangle, one in ten with a slip in it: read, held against the scene, and
// told as text. It is asked to take less than 0.2 s. `check/drawn`: the same without the scene's drawing.

#include "commands/check_report.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/check/claims.h>

#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <cstdlib>
#include <string>
#include <utility>

namespace rastertrace {
namespace {

constexpr int rows = 1000;

Truth triangle() {
    return Truth({"triangle.json", R"({"canvas":{"width":80,"height":1001,"origin":"bottom-left"},
"vertices":{"A":[0,0],"B":[0,1000],"C":[75,0]},"triangles":["ABC"]})"},
                 {});
}

/// The right end of row y is 75 - 3/40 y. In every tenth row the slope is turned over.
std::string claims_text() {
    std::string text;
    for (int y = 0; y < rows; ++y)
        text += y % 10 == 9 ? fmt::format("y={}: 0, {}/3\n", y, 225 - 40 * y)
                            : fmt::format("y={}: 0, {}/40\n", y, 3000 - 3 * y);
    return text;
}

/// Ends the program if something else is found than was put in.
std::string report_on(const Truth& truth, const std::string& text) {
    auto claims = read_claims({"claims.txt", text});
    if (!claims)
        std::abort();
    CheckedFile file{.name = "claims.txt", .claims = std::move(claims.value())};
    file.checked = check(truth, file.claims);
    if (file.checked.right != rows * 9 / 10)
        std::abort();
    return check_text({file}, CheckTold::answers);
}

void check_scene(benchmark::State& state) {
    const std::string text = claims_text();
    for (auto _ : state)
        benchmark::DoNotOptimize(report_on(triangle(), text));
}

void check_drawn(benchmark::State& state) {
    const std::string text = claims_text();
    const Truth truth = triangle();
    for (auto _ : state)
        benchmark::DoNotOptimize(report_on(truth, text));
}

BENCHMARK(check_scene)->Name("check/scene")->Unit(benchmark::kMillisecond);
BENCHMARK(check_drawn)->Name("check/drawn")->Unit(benchmark::kMillisecond);

} // namespace
} // namespace rastertrace
