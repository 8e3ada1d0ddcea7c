// SPDX-License-Identifier: MIT
// `rastertrace figure --heat`: the number in each pixel is what a reader counts who knows nothing of this program's own.

#include "effort.h"
#include "program.h"
#include "random_choice.h"
#include "random_scene.h"

#include <rastertrace/figures/heat_map.h>
#include <rastertrace/trace/text/color_text.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// What stands in the pixels, by column and row from the upper left.
using Cells = std::map<std::pair<int, int>, std::string>;

constexpr int side = 40; // of a pixel

class HeatMapTest : public ProgramTest {
protected:
    Outcome heat(const std::string& scene, const std::string& name,
                 const std::string& more = "--format svg -o -") const {
        return shell("$rastertrace figure " + scene + " --heat " + name + " " + more);
    }

    /// The numbers of a figure that has nothing but its pixels, side by side.
    Cells cells(const std::string& scene, const std::string& name) const {
        const Outcome told = heat(scene, name,
                                  "--without grid,axes,title,legend,caption --with counts --cell " +
                                      std::to_string(side) + " --format svg -o -");
        EXPECT_EQ(told.status, 0) << scene << told.err;
        const std::regex text(
            R"re(class="label cell-text"[^>]* x="([^"]+)" y="([^"]+)"[^>]*>([^<]+)<)re");
        Cells found;
        for (std::sregex_iterator at(told.out.begin(), told.out.end(), text), end; at != end; ++at)
            found[{static_cast<int>(std::stod((*at)[1]) / side),
                   static_cast<int>(std::stod((*at)[2]) / side)}] = (*at)[3];
        return found;
    }

    nlohmann::json trace_of(const std::string& scene) const {
        return nlohmann::json::parse(shell("$rastertrace trace " + scene).out);
    }
};

/// The column and row of a step's pixel.
std::pair<int, int> place_of(const nlohmann::json& step, const nlohmann::json& trace) {
    const auto& canvas = trace["canvas"];
    const int width = canvas["width"];
    const int height = canvas["height"];
    const int x = step["x"];
    const int y = step["y"];
    if (canvas["origin"] == "top-left")
        return {x, y};
    if (canvas["origin"] == "bottom-left")
        return {x, height - 1 - y};
    return {x + width / 2, height / 2 - y};
}

double number_of(const nlohmann::json& value) {
    if (value.is_number())
        return value;
    const std::string text = value;
    const std::size_t slash = text.find('/');
    return slash == std::string::npos
               ? std::stod(text)
               : std::stod(text.substr(0, slash)) / std::stod(text.substr(slash + 1));
}

Cells counted(const nlohmann::json& trace, const std::string& kind) {
    std::map<std::pair<int, int>, int> count;
    for (const auto& step : trace["steps"])
        if (step["step"] == kind)
            ++count[place_of(step, trace)];
    Cells cells;
    for (const auto& [place, number] : count)
        cells[place] = std::to_string(number);
    return cells;
}

/// All depths of each pixel, the nearest two of them compared.
Cells fights(const nlohmann::json& trace) {
    const auto& method = trace["method"];
    const bool larger_is_nearer =
        method["depth"] == "inverse-z" || method.value("depth_compare", "") == "greater";
    std::map<std::pair<int, int>, std::vector<double>> depths;
    for (const auto& step : trace["steps"])
        if (step["step"] == "depth")
            depths[place_of(step, trace)].push_back(number_of(step["depth"]));
    Cells cells;
    for (auto& [place, all] : depths) {
        if (all.size() < 2)
            continue;
        std::sort(all.begin(), all.end());
        if (larger_is_nearer)
            std::reverse(all.begin(), all.end());
        int digits = 0;
        const double difference =
            std::abs(all[0] - all[1]) / std::max(std::abs(all[0]), std::abs(all[1]));
        while (digits < 15 && difference <= std::stod("1e-" + std::to_string(digits + 1)))
            ++digits;
        cells[place] = all[0] == all[1] ? "=" : std::to_string(digits);
    }
    return cells;
}

std::uint64_t sum_of(const Cells& cells) {
    std::uint64_t sum = 0;
    for (const auto& [place, number] : cells)
        sum += std::stoull(number);
    return sum;
}

bool has_kind(const nlohmann::json& trace, const std::string& kind) {
    return trace["end"]["count"].contains(kind);
}

TEST_F(HeatMapTest, EachPixelHasTheNumberThatItsStepsAddUpTo) {
    std::size_t with_tests = 0;
    for (const std::string example :
         {"t0-fill/first-triangle", "t0-hidden/two-depths", "t0-hidden/cube-inverse-z",
          "t0-hidden/cube-painter", "tutorial/hidden/one-plane", "tutorial/hidden/painter",
          "t2-lines/octants", "t4-fan/fan", "circle/midpoint"}) {
        const std::string scene = "$examples/" + example + ".json";
        const nlohmann::json trace = trace_of(scene);
        EXPECT_EQ(cells(scene, "overdraw"), counted(trace, "pixel")) << example;
        if (!has_kind(trace, "depth"))
            continue;
        ++with_tests;
        EXPECT_EQ(cells(scene, "tests"), counted(trace, "depth")) << example;
        EXPECT_EQ(cells(scene, "depth-fights"), fights(trace)) << example;
    }
    EXPECT_GE(with_tests, 3U);
}

TEST_F(HeatMapTest, AlsoOfRandomScenes) {
    for (std::uint64_t seed = 1; seed <= random_cases(80U); ++seed) {
        write("scene.json", RandomScene(seed).text());
        const Outcome stats = shell("$rastertrace stats scene.json --json");
        if (stats.status != 0)
            continue;
        const nlohmann::json told = nlohmann::json::parse(stats.out);
        const nlohmann::json trace = trace_of("scene.json");
        const Cells writes = cells("scene.json", "overdraw");
        EXPECT_EQ(writes, counted(trace, "pixel")) << seed;
        EXPECT_EQ(sum_of(writes), told["writes"]) << seed;
        EXPECT_EQ(writes.size(), told["pixels"]) << seed;
        if (!has_kind(trace, "depth"))
            continue;
        const Cells tests = cells("scene.json", "tests");
        EXPECT_EQ(tests, counted(trace, "depth")) << seed;
        EXPECT_EQ(sum_of(tests), told["count"]["depth"]) << seed;
    }
}

/// Triangles that meet, with many equal depths. (Points and lines are kept apart from faces in the buffer, so what they
/// are compared with need not be the nearest.)
TEST_F(HeatMapTest, DepthsAreTheTwoNearest) {
    for (int seed = 1; seed <= random_cases(40); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        std::string vertices;
        std::string triangles;
        for (int i = 0; i < 5; ++i) {
            const std::string name = "T" + std::to_string(i);
            const bool is_flat = random.chance(2);
            const int depth = random.whole(1, 3);
            for (const std::string corner : {"a", "b", "c"})
                vertices += (vertices.empty() ? "" : ",") + ("\"" + name + corner + "\":[") +
                            std::to_string(random.whole(-2, 14)) + "," +
                            std::to_string(random.whole(-2, 14)) + "," +
                            std::to_string(is_flat ? depth : random.whole(1, 9)) + "]";
            triangles +=
                (i == 0 ? "[\"" : ",[\"") + name + "a\",\"" + name + "b\",\"" + name + "c\"]";
        }
        write("scene.json",
              R"({"canvas":{"width":13,"height":12,"origin":"top-left"},"vertices":{)" + vertices +
                  R"(},"triangles":[)" + triangles +
                  R"(],"method":{"depth":"linear-z","scalar":")" +
                  std::string(random.pick<std::string_view>({"exact", "double", "float"})) +
                  R"(","depth_compare":")" + (random.chance(2) ? "greater" : "less") + R"("}})");
        const nlohmann::json trace = trace_of("scene.json");
        if (has_kind(trace, "depth")) {
            EXPECT_EQ(cells("scene.json", "depth-fights"), fights(trace)) << seed;
        }
    }
}

/// Two planes that differ in the k-th digit; 1 and 1 + 10^-k, as near as doubles have them.
TEST_F(HeatMapTest, DepthsAgreeInAsManyDigitsAsTheyWereTypedWith) {
    for (const auto& [depth, number] : {std::pair<std::string, std::string>{"1", "="},
                                        {"1.0000000000009", "12"},
                                        {"1.0001", "4"},
                                        {"1.0002", "3"},
                                        {"1.05", "1"},
                                        {"1.5", "0"},
                                        {"-1", "0"}}) {
        write(
            "scene.json",
            R"({"canvas":{"width":4,"height":4,"origin":"top-left"},"vertices":{)"
            R"("A":[0,0,1],"B":[3,0,1],"C":[0,3,1],"D":[0,0,)" +
                depth + R"(],"E":[3,0,)" + depth + R"(],"F":[0,3,)" + depth +
                R"(]},"triangles":["ABC","DEF"],"method":{"depth":"linear-z","scalar":"exact"}})");
        const Cells found = cells("scene.json", "depth-fights");
        EXPECT_EQ(found.size(), 10U) << depth;
        for (const auto& [place, text] : found)
            EXPECT_EQ(text, number) << depth;
    }
}

TEST_F(HeatMapTest, ASceneAndItsTraceHaveOneMap) {
    for (const std::string name : {"overdraw", "tests", "depth-fights"}) {
        const std::string scene = "$examples/t0-hidden/cube-inverse-z.json";
        const std::string expected = heat(scene, name).out;
        EXPECT_THAT(expected, StartsWith("<svg "));
        ASSERT_EQ(shell("$rastertrace trace " + scene + " -o t.json; $rastertrace trace " + scene +
                        " -o t.jsonl; $rastertrace trace " + scene + " -o t.jsonl.zst")
                      .status,
                  0);
        write("whole.json", nlohmann::json::parse(content("t.json")).dump(2));
        for (const std::string trace : {"t.json", "t.jsonl", "t.jsonl.zst", "whole.json"})
            EXPECT_EQ(heat(trace, name).out, expected) << trace;
        EXPECT_EQ(heat("- < t.jsonl", name).out, expected);
        EXPECT_EQ(heat("- < " + scene, name).out, expected);
    }
}

/// The numbers of a folder are those of its scenes and traces, added up; of depth-fights, the largest. Goldens and claims
/// are not counted.
TEST_F(HeatMapTest, AFolderIsCountedTogether) {
    shell("mkdir -p all/inner; cp $examples/t0-hidden/cube-inverse-z.json all/a.json; "
          "$rastertrace trace all/a.json --cull back --keep depth -o all/inner/b.jsonl; "
          "$rastertrace trace all/a.json -o all/a.golden.jsonl; echo '4: 0' > all/c.claims");
    for (const std::string name : {"overdraw", "tests", "depth-fights"}) {
        Cells expected = cells("all/a.json", name);
        for (const auto& [place, text] : cells("all/inner/b.jsonl", name)) {
            const auto [at, is_new] = expected.try_emplace(place, text);
            if (is_new)
                continue;
            const auto number = [](const std::string& of) {
                return of == "=" ? 16 : std::stoi(of);
            };
            const int one = number(at->second);
            const int other = number(text);
            const int both = name == "depth-fights" ? std::max(one, other) : one + other;
            at->second = both == 16 && name == "depth-fights" ? "=" : std::to_string(both);
        }
        EXPECT_EQ(cells("all/", name), expected) << name;
    }
    EXPECT_THAT(heat("all", "tests").out, HasSubstr(">all</text>"));
    shell("cp $examples/t0-fill/first-triangle.json all/d.json");
    const Outcome told = heat("all", "overdraw");
    EXPECT_EQ(told.status, 2);
    EXPECT_EQ(told.err, "rastertrace: all/d.json: expected the canvas of all/a.json, 10 x 10 "
                        "pixels, origin center, "
                        "found 17 x 14 pixels, origin center\n");
    shell("mkdir none");
    EXPECT_EQ(heat("none", "overdraw").status, 2);
}

TEST_F(HeatMapTest, EveryFormatOfPicturesHasIt) {
    const std::string scene = "$examples/t0-hidden/two-depths.json";
    for (const auto& [format, begin] : {std::pair<std::string, std::string>{"svg", "<svg "},
                                        {"png", "\x89PNG"},
                                        {"gif", "GIF89a"},
                                        {"tex", "% "},
                                        {"html", "<!doctype html>\n<html lang=\"en\">\n"}}) {
        const Outcome told = heat(scene, "tests", "-o x." + format);
        EXPECT_EQ(told.status, 0) << told.err;
        EXPECT_THAT(content("x." + format), StartsWith(begin));
    }
    EXPECT_THAT(content("x.html"), HasSubstr(heat(scene, "tests").out));
    for (const std::string format : {"txt", "cast"})
        EXPECT_EQ(heat(scene, "tests", "-o x." + format).err,
                  "rastertrace: --heat: expected one of svg, png, tex, gif, html, found " + format +
                      "\n");
}

TEST_F(HeatMapTest, TheCaptionAddsUpWhatIsShown) {
    const std::string scene = "$examples/t0-fill/first-triangle.json";
    for (const std::string line : {">writes: 49</text>", ">pixels written: 49</text>",
                                   ">most writes of one pixel: 1</text>"})
        EXPECT_THAT(heat(scene, "overdraw").out, HasSubstr(line));
    EXPECT_THAT(heat(scene, "overdraw", "--region 0,-3,1,-2 --format svg -o -").out,
                HasSubstr(">writes: 4</text>"));
    EXPECT_THAT(heat(scene, "overdraw", "--language pt --format svg -o -").out,
                HasSubstr(">pixels escritos: 49</text>"));
}

TEST_F(HeatMapTest, WhatAMapCannotHave) {
    const std::string scene = "$examples/t0-hidden/two-depths.json";
    const auto refusal = [&](const std::string& options) {
        const Outcome told = heat(scene, "tests", options + " -o x.svg");
        EXPECT_EQ(told.status, 2) << options;
        return told.err;
    };
    for (const std::string option :
         {"--sheet 2x2", "--animate", "--view faces", "--against fill=fan", "--palette scene"})
        EXPECT_EQ(refusal(option), "rastertrace: --heat: expected no " +
                                       option.substr(0, option.find(' ')) + ", found one\n");
    EXPECT_EQ(refusal("--with edges"),
              "rastertrace: --with edges: expected grid, axes, pixels, counts, title, legend or "
              "caption with --heat, found another part\n");
    EXPECT_THAT(refusal("--step 3"), HasSubstr("--step"));
    EXPECT_EQ(shell("$rastertrace figure " + scene + " --with counts -o x.svg").err,
              "rastertrace: --with counts: expected --heat, found none\n");
    EXPECT_EQ(heat("$examples/t0-projection/turning.json", "overdraw").err,
              "rastertrace: --heat: expected one scene, found a sequence\n"
              "hint: --frame N takes one\n");
    EXPECT_EQ(heat("$examples/t0-fill/first-triangle.json", "tests").err,
              "rastertrace: --heat tests: expected depth tests, found none\n"
              "hint: --depth linear-z --keep depth tests what no other triangle can hide, too\n");
    shell("$rastertrace trace " + scene + " --only depth -o depths.jsonl");
    EXPECT_EQ(heat("depths.jsonl", "overdraw").err,
              "rastertrace: --heat overdraw: expected a trace with its pixel steps, found one that "
              "they were left out of\n");
    EXPECT_EQ(heat("depths.jsonl", "tests").status, 0);
    EXPECT_EQ(visible_files(), 1U);
}

/// What there is of a trace that breaks off is shown, and the exit status says that it is not all.
TEST_F(HeatMapTest, ABrokenTraceIsCountedAsFarAsItGoes) {
    shell("$rastertrace trace $examples/t0-fill/first-triangle.json -o t.jsonl; "
          "head -n 20 t.jsonl > cut.jsonl");
    const Outcome told = heat("cut.jsonl", "overdraw");
    EXPECT_EQ(told.status, 2);
    EXPECT_THAT(told.out, StartsWith("<svg "));
    const auto lines = content("cut.jsonl");
    std::size_t pixels = 0;
    for (std::size_t at = 0; (at = lines.find("\"pixel\"", at)) != std::string::npos; ++at)
        ++pixels;
    EXPECT_THAT(told.out, HasSubstr(">writes: " + std::to_string(pixels) + "</text>"));
}

/// Steps are counted and forgotten: four times as many take no more memory, of a scene as of a pipe.
TEST_F(HeatMapTest, MemoryDoesNotGrowWithTheSteps) {
    const auto scene = [](int triangles) {
        std::string text =
            R"({"canvas":{"width":256,"height":256,"origin":"top-left"},"vertices":{)"
            R"("A":[0,0],"B":[255,0],"C":[0,255]},"triangles":[)";
        for (int i = 0; i < triangles; ++i)
            text += i == 0 ? "\"ABC\"" : ",\"ABC\"";
        return text + "]}";
    };
    write("few.json", scene(16)); // 20 MB of text, more than is read at once
    write("many.json", scene(64));
    for (const std::string input : {"X.json", "- < X.jsonl.gz"}) {
        const auto peak = [&](const std::string& name) {
            shell("$rastertrace trace " + name + ".json -o " + name + ".jsonl.gz");
            std::string from = input;
            from.replace(from.find('X'), 1, name);
            const Outcome told = heat(from, "overdraw", "--format png -o x.png");
            EXPECT_EQ(told.status, 0) << told.err;
            return told.peak_memory;
        };
        const long of_many = peak("many");
        if (!is_sanitized) {
            EXPECT_LT(of_many, peak("few") + 8'000'000) << input;
        }
    }
}

// --- colors -------------------------------------------------------------------------------------

/// The more, the darker, in even steps of lightness (CIE L*), so that grays say the same.
TEST(HeatColors, LightnessFallsEvenly) {
    const Canvas canvas{.width = 1, .height = 1};
    HeatMap map(Heat::overdraw, canvas);
    constexpr int most = 101;
    for (int i = 0; i < most; ++i)
        map.add(StepView(R"({"step":"pixel","x":0,"y":0})"), StepKind::pixel);
    ASSERT_EQ(map.most(), static_cast<std::uint32_t>(most));
    const auto lightness = [&](int number, bool in_grays) {
        const double light = luminance(map.color_of(static_cast<std::uint32_t>(number), in_grays));
        return light > 216.0 / 24389 ? 116 * std::cbrt(light) - 16 : light * 24389 / 27;
    };
    const double range = lightness(1, false) - lightness(most, false);
    EXPECT_GT(range, 60);
    for (int number = 1; number <= most; ++number) {
        const double even = lightness(1, false) - range * (number - 1) / (most - 1);
        EXPECT_NEAR(lightness(number, false), even, 5) << number;
        EXPECT_NEAR(lightness(number, true), lightness(number, false), 0.5) << number;
        const Color gray = map.color_of(static_cast<std::uint32_t>(number), true);
        EXPECT_TRUE(gray.red() == gray.green() && gray.green() == gray.blue());
        if (number > 1) {
            EXPECT_LT(lightness(number, false), lightness(number - 1, false) + 0.01) << number;
        }
    }
}

} // namespace
} // namespace rastertrace
