// SPDX-License-Identifier: MIT
// What `diff` finds between a trace and the same with one thing changed: that, and nothing else.

#include "effort.h"
#include "picture.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/core/numbers/conversion.h>
#include <rastertrace/trace/compare/diff.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/text/text.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Json = nlohmann::ordered_json;

TraceDiff diff_of(const std::string& a, const std::string& b, const DiffOptions& options = {}) {
    const auto read = [](const char* name, const std::string& text) {
        Result<Trace> trace = read_trace({name, text});
        if (!trace)
            throw trace.problem();
        return std::move(trace.value());
    };
    return diff(read("a.json", a), read("b.json", b), options);
}

/// All that differs, as `scanline 1 0 0 0`: changed, only in a, only in b, moved.
std::vector<std::string> counts_of(const TraceDiff& found) {
    std::vector<std::string> counts;
    for (const KindDifference& kind : found.kinds)
        counts.push_back(kind.kind + " " + std::to_string(kind.changed) + " " +
                         std::to_string(kind.only_a) + " " + std::to_string(kind.only_b) + " " +
                         std::to_string(kind.moved));
    return counts;
}

/// How many steps only a has, where nothing else differs.
std::size_t only_in_a(const TraceDiff& found) {
    std::size_t count = 0;
    for (const KindDifference& kind : found.kinds) {
        count += kind.only_a;
        EXPECT_EQ(kind.changed + kind.only_b + kind.moved, 0U) << diff_text(found);
    }
    return count;
}

/// What the other way round has to find.
std::vector<std::string> mirrored_counts_of(TraceDiff found) {
    for (KindDifference& kind : found.kinds)
        std::swap(kind.only_a, kind.only_b);
    return counts_of(found);
}

/// The scenes of the examples, with their paths.
std::vector<std::pair<std::string, std::string>> example_scenes() {
    std::vector<std::pair<std::string, std::string>> scenes;
    for (const std::string& path : example_files()) {
        std::ifstream file(path);
        std::string text{std::istreambuf_iterator<char>(file), {}};
        if (text.find("\"canvas\"") != std::string::npos ||
            text.find("\"vertices\"") != std::string::npos ||
            text.find("\"meshes\"") != std::string::npos)
            scenes.emplace_back(path, std::move(text));
    }
    return scenes;
}

/// The trace of an example, or "" if it is no scene that can be drawn.
std::string trace_of_example(const std::pair<std::string, std::string>& example,
                             const MethodOverrides& method = {}, TraceLayout layout = {}) {
    const auto read = read_scene({example.first, example.second}, method);
    return read ? trace_text(read.value(), {.layout = layout, .filter = {}}) : "";
}

/// A random scene, and its trace; none of a scene that cannot be drawn.
struct RandomTrace {
    std::string scene;
    std::optional<PlannedScene> planned;

    explicit RandomTrace(std::uint64_t seed) : scene(RandomScene(seed).text()) {
        auto read = read_scene({"scene.json", scene});
        if (read)
            planned = std::move(read.value());
    }

    std::string text(const StepFilter& filter = {}) const {
        return trace_text(*planned, {.layout = TraceLayout::jsonl, .filter = filter});
    }
};

/// Calls `use` with random traces, and the number of each.
template <typename Use> void for_random_traces(std::uint64_t count, const Use& use) {
    for (std::uint64_t seed = 0; seed < random_cases(count); ++seed) {
        const RandomTrace trace(seed);
        SCOPED_TRACE(trace.scene);
        if (trace.planned)
            use(trace, seed);
    }
}

/// A trace as its header, its steps and what is behind them.
struct Lines {
    std::string header;
    std::vector<std::string> steps;
    std::string end;

    explicit Lines(const std::string& jsonl) {
        std::vector<std::string> lines = split_at(jsonl, '\n');
        header = lines.front();
        for (std::size_t i = 1; i < lines.size(); ++i)
            if (lines[i].starts_with("{\"end\""))
                end = lines[i] + "\n";
            else if (end.empty())
                steps.push_back(lines[i]);
    }

    std::string text() const {
        std::string text = header + "\n";
        for (const std::string& step : steps)
            text += step + "\n";
        return text + end;
    }
};

std::string first_triangle_trace(TraceLayout layout = TraceLayout::jsonl) {
    return trace_text(first_triangle(), {.layout = layout, .filter = {}});
}

/// The value of a field with something else in its place.
Json changed(const Json& value) {
    if (value.is_boolean())
        return !value.get<bool>();
    if (value.is_number_integer())
        return value.get<std::int64_t>() + 1000;
    if (value.is_number())
        return value.get<double>() * 2 + 1;
    if (value.is_null())
        return "7/3";
    if (value.is_array()) {
        Json list = value;
        if (list.empty())
            list.push_back(1);
        else
            list.back() = changed(list.back());
        return list;
    }
    const std::string text = value.get<std::string>();
    if (text.starts_with('#'))
        return text == "#123456" ? "#654321" : "#123456";
    if (text.find_first_not_of("-0123456789/") == std::string::npos)
        return "3" + (text.starts_with('-') ? text.substr(1) : text);
    return text + "'";
}

TEST(Diff, EveryExampleIsAlikeToItselfInAnyLayout) {
    for (const auto& example : example_scenes()) {
        const std::string json = trace_of_example(example);
        if (json.empty() || json.size() > random_cases<std::size_t>(3'000'000))
            continue;
        EXPECT_TRUE(diff_of(json, json).is_same_bytes) << example.first;
        const TraceDiff found = diff_of(json, trace_of_example(example, {}, TraceLayout::jsonl));
        EXPECT_TRUE(found.is_same) << example.first << "\n" << diff_text(found);
        EXPECT_FALSE(found.is_same_bytes);
        EXPECT_THAT(found.remarks, IsEmpty());
    }
    const std::string json = first_triangle_trace(TraceLayout::json);
    EXPECT_TRUE(diff_of(json, Json::parse(json).dump(2)).is_same);
    EXPECT_TRUE(diff_of(Json::parse(json).dump(), first_triangle_trace()).is_same);
}

/// Every field of some steps of each kind, changed.
void change_every_field(const std::string& name, const std::string& trace) {
    const Lines lines(trace);
    std::map<std::string, std::size_t> seen;
    for (std::size_t n = 0; n < lines.steps.size(); ++n) {
        const Json step = Json::parse(lines.steps[n]);
        const std::string kind = step["step"];
        constexpr std::size_t most_of_a_kind = 3;
        if (seen[kind]++ >= most_of_a_kind)
            continue;
        for (const auto& item : step.items()) {
            const std::string key = item.key();
            if (key == "step")
                continue;
            Lines other = lines;
            Json mutated = step;
            mutated[key] = changed(item.value());
            other.steps[n] = mutated.dump();
            const TraceDiff found = diff_of(trace, other.text());
            SCOPED_TRACE(name + " step " + std::to_string(n + 1) + " " + key + ": " +
                         other.steps[n] + "\n" + diff_text(found));
            ASSERT_FALSE(found.is_same);
            ASSERT_TRUE(found.first.has_value());
            const auto& first = found.first->a ? found.first->a : found.first->b;
            EXPECT_EQ(first->number, n + 1);
            EXPECT_EQ(found.first->kind, kind);

            // Either the field differs, or, if it is a key, one step is there instead of another.
            const auto& fields = fields_of(*step_kind_named(kind));
            const bool is_key =
                std::any_of(fields.begin(), fields.end(), [&](const StepField& field) {
                    return field.name == key && field.role == FieldRole::key;
                });
            if (kind == "primitive" && is_key)
                continue; // all its steps are those of another primitive
            const auto is_like_this = [&step](const std::string& line) {
                const Json other_step = Json::parse(line);
                return other_step["step"] == "matrix" && other_step["name"] == step["name"] &&
                       other_step.value("object", "") == step.value("object", "");
            };
            if (kind == "matrix" && is_key &&
                std::count_if(lines.steps.begin(), lines.steps.end(), is_like_this) > 1)
                continue; // those of meshes without names: nothing says which is which
            EXPECT_THAT(counts_of(found), ElementsAre(kind + (is_key ? " 0 1 1 0" : " 1 0 0 0")));
            if (!is_key) {
                ASSERT_EQ(found.first->fields.size(), 1U);
                EXPECT_EQ(found.first->fields[0].name, key);
                EXPECT_TRUE(diff_of(trace, other.text(), {.ignored = {kind + "." + key}}).is_same);
            }
            EXPECT_TRUE(diff_of(trace, other.text(), {.ignored = {kind}}).is_same);
            EXPECT_EQ(counts_of(diff_of(other.text(), trace)), mirrored_counts_of(found));
        }
    }
}

TEST(Diff, EveryFieldThatIsChangedIsFoundAndNothingElse) {
    int examples = 0;
    for (const auto& example : example_scenes()) {
        const std::string trace = trace_of_example(example, {}, TraceLayout::jsonl);
        if (trace.empty() || trace.size() > random_cases<std::size_t>(100'000))
            continue;
        change_every_field(example.first, trace);
        ++examples;
    }
    EXPECT_GT(examples, 5);
}

TEST(Diff, OneStepMoreOrLessIsToldAloneWhateverComesBehind) {
    Random random(19);
    for_random_traces(300, [&](const RandomTrace& random_trace, std::uint64_t) {
        const Lines lines(random_trace.text());
        const int count = static_cast<int>(lines.steps.size());
        const auto n = static_cast<std::size_t>(random.whole(0, count - 1));
        const std::string kind = Json::parse(lines.steps[n])["step"];
        if (kind == "primitive")
            return;
        Lines shorter = lines;
        shorter.steps.erase(shorter.steps.begin() + static_cast<std::ptrdiff_t>(n));
        const TraceDiff found = diff_of(lines.text(), shorter.text());
        SCOPED_TRACE(lines.steps[n] + "\n" + diff_text(found));
        EXPECT_THAT(counts_of(found), ElementsAre(kind + " 0 1 0 0"));
        EXPECT_THAT(counts_of(diff_of(shorter.text(), lines.text())),
                    ElementsAre(kind + " 0 0 1 0"));
        EXPECT_TRUE(diff_of(lines.text(), shorter.text(), {.ignored = {kind}}).is_same);
    });
}

/// The steps of each primitive, those in front of the first at 0.
std::vector<std::vector<std::string>> primitives_in(const Lines& lines) {
    std::vector<std::vector<std::string>> primitives(1);
    for (const std::string& step : lines.steps) {
        if (step.starts_with(R"({"step":"primitive")"))
            primitives.emplace_back();
        primitives.back().push_back(step);
    }
    return primitives;
}

Lines lines_of(Lines lines, const std::vector<std::vector<std::string>>& primitives) {
    lines.steps.clear();
    for (const auto& steps : primitives)
        lines.steps.insert(lines.steps.end(), steps.begin(), steps.end());
    return lines;
}

TEST(Diff, APrimitiveThatMovedIsToldAsMoved) {
    Random random(20);
    int moved = 0;
    for_random_traces(300, [&](const RandomTrace& random_trace, std::uint64_t) {
        const Lines lines(random_trace.text());
        auto primitives = primitives_in(lines);
        if (primitives.size() < 4)
            return;
        const int last = static_cast<int>(primitives.size()) - 1;
        const auto from = static_cast<std::size_t>(random.whole(1, last));
        const auto to = static_cast<std::size_t>(random.whole(1, last));
        auto one = std::move(primitives[from]);
        const std::string name = Json::parse(one.front())["name"];
        primitives.erase(primitives.begin() + static_cast<std::ptrdiff_t>(from));
        primitives.insert(primitives.begin() + static_cast<std::ptrdiff_t>(to), std::move(one));
        const std::string other = lines_of(lines, primitives).text();
        const TraceDiff found = diff_of(lines.text(), other);
        SCOPED_TRACE(name + "\n" + diff_text(found));
        if (from == to) {
            EXPECT_TRUE(found.is_same);
            return;
        }
        ++moved;
        EXPECT_THAT(counts_of(found), ElementsAre("primitive 0 0 0 1"));
        EXPECT_TRUE(found.first->is_moved);
        EXPECT_THAT(counts_of(diff_of(other, lines.text())), ElementsAre("primitive 0 0 0 1"));
        EXPECT_TRUE(diff_of(lines.text(), other, {.ignored = {"primitive"}}).is_same);
    });
    EXPECT_GT(moved, random_cases(100));
}

TEST(Diff, APrimitiveThatIsGoneIsToldWithItsSteps) {
    for_random_traces(200, [&](const RandomTrace& random_trace, std::uint64_t seed) {
        const Lines lines(random_trace.text());
        auto primitives = primitives_in(lines);
        if (primitives.size() < 3)
            return;
        const std::size_t gone = 1 + seed % (primitives.size() - 1);
        std::map<std::string, std::size_t> steps;
        for (const std::string& step : primitives[gone])
            ++steps[Json::parse(step)["step"]];
        primitives.erase(primitives.begin() + static_cast<std::ptrdiff_t>(gone));
        const TraceDiff found = diff_of(lines.text(), lines_of(lines, primitives).text());
        SCOPED_TRACE("\n" + diff_text(found));
        only_in_a(found);
        ASSERT_EQ(found.kinds.size(), steps.size());
        for (const KindDifference& kind : found.kinds)
            EXPECT_EQ(kind.only_a, steps[kind.kind]) << kind.kind;
        EXPECT_EQ(found.first->kind, "primitive");
    });
}

/// A quantity as the trace has it, exactly; nothing for what is none.
std::optional<Rational> quantity_in(const Json& value) {
    const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    const auto parsed = parse_number(text, NumberSize::any);
    const auto* const number = std::get_if<Number>(&parsed);
    return number == nullptr ? std::nullopt : std::optional(number->exact());
}

bool has_same_value(const Json& a, const Json& b) {
    if (a.is_array() && b.is_array() && a.size() == b.size())
        return std::equal(a.begin(), a.end(), b.begin(), has_same_value);
    const auto in_a = quantity_in(a);
    const auto in_b = quantity_in(b);
    return in_a && in_b ? *in_a == *in_b : a == b;
}

// Where doubles decide alike, steps stand side by side, so that this test finds the ones that differ by itself.
TEST(Diff, ExactAgainstDoubleTellsOnlyWhatDiffersInValue) {
    int compared = 0;
    for (const auto& example : example_scenes()) {
        const std::string exact =
            trace_of_example(example, {{"scalar", "exact"}}, TraceLayout::jsonl);
        const std::string doubles =
            trace_of_example(example, {{"scalar", "double"}}, TraceLayout::jsonl);
        if (exact.empty() || doubles.empty() || exact.size() > random_cases<std::size_t>(300'000))
            continue;
        const Lines a(exact);
        const Lines b(doubles);
        bool is_aligned = a.steps.size() == b.steps.size();
        std::map<std::string, std::size_t> expected;
        for (std::size_t n = 0; is_aligned && n < a.steps.size(); ++n) {
            const Json of_a = Json::parse(a.steps[n]);
            const Json of_b = Json::parse(b.steps[n]);
            is_aligned = of_a["step"] == of_b["step"];
            for (const auto& field : fields_of(*step_kind_named(std::string(of_a["step"])))) {
                const std::string name(field.name);
                is_aligned = is_aligned && (field.role != FieldRole::key || !of_a.contains(name) ||
                                            (of_b.contains(name) && of_a[name] == of_b[name]));
            }
            const bool is_alike =
                is_aligned && of_a.size() == of_b.size() &&
                std::all_of(of_a.items().begin(), of_a.items().end(), [&of_b](const auto& item) {
                    return of_b.contains(item.key()) &&
                           has_same_value(item.value(), of_b[item.key()]);
                });
            if (is_aligned && !is_alike)
                ++expected[of_a["step"]];
        }
        if (!is_aligned)
            continue;
        ++compared;
        const TraceDiff found = diff_of(exact, doubles, {.ignored = {"header"}});
        SCOPED_TRACE(example.first + "\n" + diff_text(found));
        std::map<std::string, std::size_t> told;
        for (const KindDifference& kind : found.kinds) {
            told[kind.kind] = kind.changed;
            EXPECT_EQ(kind.only_a + kind.only_b + kind.moved, 0U);
        }
        EXPECT_EQ(told, expected);
    }
    EXPECT_GT(compared, 20);
}

TEST(Diff, AToleranceHoldsForTheFieldThatItNames) {
    Lines other(first_triangle_trace());
    Json row = Json::parse(other.steps[13]); // y = 2, from -1/4 to 25/8
    ASSERT_EQ(row["left"], "-1/4");
    row["left"] = "-1/8";
    other.steps[13] = row.dump();
    const auto is_same = [&](const std::string& tolerance) {
        return diff_of(first_triangle_trace(), other.text(),
                       {.tolerances = {parse_tolerance(tolerance)}})
            .is_same;
    };
    for (const std::string enough : {"scanline.left=0.125", "scanline.left=1/8", "scanline=0.2",
                                     "0.125", "scanline.left=4503599627370496ulp"})
        EXPECT_TRUE(is_same(enough)) << enough;
    for (const std::string too_little :
         {"scanline.left=0.1249", "scanline.right=1", "pixel=1", "edge.dx_dy=1", "0.1",
          "scanline.left=2251799813685247ulp"})
        EXPECT_FALSE(is_same(too_little)) << too_little;
    // The last one that is about the field counts.
    EXPECT_FALSE(diff_of(first_triangle_trace(), other.text(),
                         {.tolerances = {parse_tolerance("1"), parse_tolerance("scanline.left=0")}})
                     .is_same);
}

// The double nearest to 1/3 is a third of its ulp away from it; the next ones, two thirds and more.
TEST(Diff, UlpsAreThoseOfTheScalar) {
    const auto trace = [](const std::string& scalar, const std::string& value) {
        return R"({"rastertrace":1,"canvas":{"width":4,"height":4},"method":{"scalar":")" + scalar +
               "\"}}\n" + R"({"step":"along","x":1,"value":)" + value +
               ",\"pixel\":0}\n{\"end\":{}}\n";
    };
    const auto is_same = [&](const std::string& scalar, const std::string& value,
                             const std::string& tolerance) {
        return diff_of(trace(scalar, "\"1/3\""), trace(scalar, value),
                       {.tolerances = {parse_tolerance(tolerance)}})
            .is_same;
    };
    EXPECT_TRUE(is_same("double", "0.3333333333333333", "0.5ulp"));
    EXPECT_FALSE(is_same("double", "0.3333333333333333", "0.25ulp"));
    EXPECT_FALSE(is_same("double", "0.33333334", "1000000ulp"));
    EXPECT_TRUE(is_same("float", "0.33333334", "1ulp"));
    EXPECT_FALSE(is_same("float", "0.3333335", "4ulp"));
    EXPECT_TRUE(is_same("float", "0.3333335", "8ulp"));
    EXPECT_FALSE(is_same("float", "1e300", "8ulp")); // no float is
}

TEST(Diff, NumbersAreComparedAsTheyAreWritten) {
    const auto trace = [](const std::string& value) {
        return R"({"rastertrace":1,"canvas":{"width":4,"height":4}})"
               "\n"
               R"({"step":"along","x":1,"value":)" +
               value + ",\"pixel\":0}\n{\"end\":{}}\n";
    };
    for (const std::string same :
         {"3.125", "3.1250", "31250e-4", "\"25/8\"", "\"50/16\"", "\"3.125\""})
        EXPECT_TRUE(diff_of(trace("\"25/8\""), trace(same)).is_same) << same;
    for (const std::string other : {"3.1250000000000001", "-3.125", "\"25/9\""})
        EXPECT_FALSE(diff_of(trace("\"25/8\""), trace(other)).is_same) << other;
}

// The row of y = 2 begins a pixel farther to the right: (-1, 2) is not drawn, and nothing else is said to follow.
TEST(Diff, TheFirstDifferenceHasThePixelsThatItLedTo) {
    Lines other(first_triangle_trace());
    Json row = Json::parse(other.steps[13]);
    row["from"] = 0;
    other.steps[13] = row.dump();
    ASSERT_EQ(other.steps[14], R"({"step":"pixel","x":-1,"y":2})");
    other.steps.erase(other.steps.begin() + 14);
    ASSERT_EQ(other.steps.back(), R"({"step":"pixel","x":5,"y":-3})");
    other.steps.pop_back(); // of another row
    const TraceDiff found = diff_of(first_triangle_trace(), other.text());
    ASSERT_TRUE(found.first && found.first->a && found.first->b);
    EXPECT_EQ(found.first->a->number, 14U);
    EXPECT_EQ(found.led_to.count, 1U);
    ASSERT_EQ(found.led_to.only_a.size(), 1U);
    EXPECT_EQ(found.led_to.only_a[0], (Pixel{-1, 2}));
    EXPECT_EQ(found.picture->only_a, 2U);
    EXPECT_EQ(found.picture->rows, (std::vector<std::string>{".................", //
                                                             ".................", //
                                                             "..........#......", //
                                                             ".........##......", //
                                                             "........###......", //
                                                             ".......!####.....", //
                                                             ".......#####.....", //
                                                             "......######.....", //
                                                             ".....########....", //
                                                             "....#########....", //
                                                             "....#########!...", //
                                                             ".................", //
                                                             ".................", //
                                                             "................."}));
}

TEST(Diff, WhoOwnsAPixelIsPartOfThePicture) {
    const std::string scene = R"({"canvas":{"width":6,"height":4,"origin":"bottom-left"},
        "vertices":{"A":[0,0],"B":[4,0],"C":[0,3],"D":[5,0],"E":[5,3],"F":[1,0]},
        "triangles":["ABC","DEF"],"method":{"scalar":"exact"}})";
    const Lines lines(trace_text(scene_in(scene), in_lines));
    auto primitives = primitives_in(lines);
    std::swap(primitives[1], primitives[2]);
    const TraceDiff found = diff_of(lines.text(), lines_of(lines, primitives).text());
    EXPECT_GT(found.picture->owners, 0U);
    EXPECT_EQ(found.picture->only_a + found.picture->only_b + found.picture->colors, 0U);
    EXPECT_THAT(found.picture->names, ElementsAre("ABC", "DEF"));
    EXPECT_NE(found.picture->faces_a, found.picture->faces_b);
    EXPECT_THAT(found.remarks,
                ElementsAre("the primitives are not the same in the same order: from there on "
                            "the traces were read twice"));
}

TEST(Diff, DifferentCanvasesAreComparedByCoordinates) {
    Scene scene = first_triangle();
    scene.canvas.width = 19;
    scene.canvas.height = 16;
    const TraceDiff found = diff_of(first_triangle_trace(), trace_text(scene, in_lines));
    EXPECT_THAT(found.kinds, IsEmpty());
    ASSERT_EQ(found.header.size(), 2U);
    EXPECT_EQ(found.header[0].name, "canvas.width");
    EXPECT_EQ(found.header[1].name, "canvas.height");
    EXPECT_EQ(found.picture->only_a + found.picture->only_b, 0U);
    EXPECT_FALSE(found.is_same);
    EXPECT_TRUE(
        diff_of(first_triangle_trace(), trace_text(scene, in_lines), {.ignored = {"header"}})
            .is_same);
}

TEST(Diff, ATraceThatBreaksOffIsComparedAsFarAsItGoes) {
    const std::string whole = first_triangle_trace();
    for (std::size_t size = whole.find('\n') + 1; size < whole.rfind("{\"end\""); size += 13) {
        const TraceDiff found = diff_of(whole, whole.substr(0, size));
        SCOPED_TRACE(size);
        EXPECT_THAT(found.kinds, IsEmpty());
        ASSERT_EQ(found.damage.size(), 1U);
        EXPECT_EQ(found.damage[0].file, "b.json");
        EXPECT_THAT(found.damage[0].message, HasSubstr("truncated after"));
    }
    const std::string part = whole.substr(0, 2000);
    EXPECT_EQ(diff_of(part, part).damage.size(), 2U);
}

TEST(Diff, StepsThatOneTraceLeavesOutAreNotMissed) {
    for_random_traces(100, [&](const RandomTrace& random_trace, std::uint64_t) {
        const std::string whole = random_trace.text();
        const std::vector<StepFilter> filters{
            {.only = std::vector{StepKind::scanline, StepKind::pixel}},
            {.only = std::vector{StepKind::primitive, StepKind::pixel}},
            {.region = Region{-2, 1, 5, 6}},
            {.primitive =
                 std::string(Json::parse(primitives_in(Lines(whole)).back().front())["name"])}};
        for (const StepFilter& filter : filters) {
            if (filter.primitive && filter.primitive->empty())
                continue;
            const std::string part = random_trace.text(filter);
            if (sound_trace(part).size() == 0) // nothing would be compared
                continue;
            const TraceDiff found = diff_of(whole, part);
            EXPECT_TRUE(found.is_same) << diff_text(found);
            EXPECT_TRUE(diff_of(part, whole).is_same);
        }
    });
}

TEST(Diff, AnOptionNamesWhatThereIs) {
    const auto problem_of_options = [](const DiffOptions& options) {
        try {
            diff_of(first_triangle_trace(), first_triangle_trace(), options);
        } catch (const Problem& problem) {
            return to_text(problem);
        }
        return std::string("none");
    };
    EXPECT_EQ(problem_of_options({.tolerances = {parse_tolerance("scanline.lft=1")}}),
              "--tolerance: expected a field of scanline (y, left, right, from, to, left_edge, "
              "right_edge, left_depth, right_depth), found lft\nhint: did you mean left?");
    EXPECT_THAT(problem_of_options({.ignored = {"sampel"}}),
                HasSubstr("found sampel\nhint: did you mean sample?"));
    EXPECT_THAT(problem_of_options({.only = {"pixels"}}), HasSubstr("hint: did you mean pixel?"));
    EXPECT_EQ(problem_of_options({.ignored = {"header", "end", "pixel.color"}}), "none");
    EXPECT_THAT(problem_of_options({.tolerances = {parse_tolerance("pixel.x=1")}}),
                HasSubstr("expected another field than x of pixel: steps are found by it"));
    EXPECT_THAT(problem_of_options({.tolerances = {parse_tolerance("pixel.color=1")}}),
                HasSubstr("expected another field than color of pixel: it is no number"));
    for (const std::string bad :
         {".left=1", "scanline.=1", "", "left", "scanline.left", "scanline.left=", "=1", "-1",
          "scanline.left=1e", "ulp", "scanline.left=x"})
        EXPECT_THROW(parse_tolerance(bad), Problem) << bad;
}

// What a foreign rasterizer adds is compared, too, and can be left out by its name.
TEST(Diff, StepsAndFieldsOfUnknownNames) {
    Lines one(first_triangle_trace());
    Lines other = one;
    one.steps.insert(one.steps.begin() + 5, R"({"step":"tile","x":1,"y":2,"cost":[1,2]})");
    other.steps.insert(other.steps.begin() + 5, R"({"step":"tile","x":1,"y":2,"cost":[1,3.0]})");
    const TraceDiff found = diff_of(one.text(), other.text());
    EXPECT_THAT(counts_of(found), ElementsAre("tile 1 0 0 0"));
    EXPECT_EQ(found.first->fields[0].name, "cost");
    EXPECT_TRUE(diff_of(one.text(), other.text(), {.ignored = {"tile"}}).is_same);
    EXPECT_TRUE(diff_of(one.text(), other.text(), {.ignored = {"tile.cost"}}).is_same);
    EXPECT_TRUE(diff_of(one.text(), other.text(), {.tolerances = {parse_tolerance("tile.cost=1")}})
                    .is_same);
}

TEST(Diff, AStepThatCannotBeUnderstoodIsRefusedWhereItDiffers) {
    Lines other(first_triangle_trace());
    other.steps[13] = R"({"step":"scanline","y":2})";
    try {
        diff_of(first_triangle_trace(), other.text());
        ADD_FAILURE() << "no problem";
    } catch (const Problem& problem) {
        EXPECT_THAT(to_text(problem), HasSubstr("b.json"));
        EXPECT_THAT(to_text(problem),
                    HasSubstr("expected a scanline step with the key \"left\", found none"));
    }
}

// A row takes 6 MB here: more than the steps in front of a difference that are kept.
TEST(Diff, TheRowOfAPixelIsToldHoweverFarBehindTheBeginningOfItsPrimitive) {
    const std::string padding = R"(,"note":")" + std::string(100'000, '-') + "\"}\n";
    std::string text = R"({"rastertrace":1,"canvas":{"width":60,"height":3,"origin":"top-left"}}
{"step":"primitive","kind":"triangle","name":"ABC","vertices":["A","B","C"]}
)";
    for (int y = 0; y < 3; ++y) {
        text += R"({"step":"scanline","y":)" + std::to_string(y) +
                R"(,"left":0,"right":59,"from":0,"to":59,"left_edge":"AB","right_edge":"AC"})"
                "\n";
        for (int x = 0; x < 60; ++x)
            text += R"({"step":"pixel","x":)" + std::to_string(x) + R"(,"y":)" + std::to_string(y) +
                    padding;
    }
    text += "{\"end\":{}}\n";
    const auto without = [&text](const std::string& pixel) {
        std::string other = text;
        const std::size_t begin = other.find(R"({"step":"pixel",)" + pixel);
        other.erase(begin, other.find('\n', begin) + 1 - begin);
        return diff_of(text, other);
    };
    for (const auto& [x, y] : {std::pair{58, 0}, {4, 1}, {58, 1}, {58, 2}}) {
        const std::string row = std::to_string(y);
        const TraceDiff found = without(R"("x":)" + std::to_string(x) + R"(,"y":)" + row + ",");
        const auto sentence = [&row](int column) {
            return "pixel (" + std::to_string(column) + ", " + row + ")   row y=" + row +
                   ": 0 to 59";
        };
        ASSERT_TRUE(found.first && found.first->a && !found.before_b.empty());
        EXPECT_EQ(found.first->a->sentence, sentence(x));
        EXPECT_EQ(found.before_b.back().sentence, sentence(x - 1));
    }
}

/// A triangle that reaches so far, on a canvas that holds it.
Lines lines_of_triangle(int reach) {
    const std::string far = std::to_string(reach);
    const std::string side = std::to_string(2 * reach + 4);
    return Lines(
        trace_text(scene_in(R"({"canvas":{"width":)" + side + R"(,"height":)" + side +
                            R"(},"vertices":{"A":[-)" + far + ",-" + far + R"(],"B":[)" + far +
                            ",-" + far + R"(],"C":[0,)" + far + R"(]},"triangles":["ABC"]})"),
                   in_lines));
}

// More steps than are looked ahead, or kept until they come later, in another order.
TEST(Diff, StepsInAnotherOrderAreFoundFarApart) {
    const Lines lines = lines_of_triangle(30);
    Lines turned = lines;
    std::reverse(turned.steps.begin() + 1, turned.steps.end());
    const TraceDiff found = diff_of(lines.text(), turned.text());
    std::size_t moved = 0;
    for (const KindDifference& kind : found.kinds) {
        EXPECT_EQ(kind.changed + kind.only_a + kind.only_b, 0U) << diff_text(found);
        moved += kind.moved;
    }
    EXPECT_GT(moved, 1000U);
    EXPECT_EQ(found.picture->only_a + found.picture->only_b, 0U);
}

// As many steps as a wide row has; what stands behind them has not moved.
TEST(Diff, ThousandsOfStepsThatOneTraceDoesNotHaveMoveNoOther) {
    const Lines lines = lines_of_triangle(60);
    Lines shorter = lines;
    const auto begin = shorter.steps.begin() + 100;
    shorter.steps.erase(begin, begin + 5000);
    EXPECT_EQ(only_in_a(diff_of(lines.text(), shorter.text())), 5000U);
}

// More steps than are looked ahead: what stands behind them is found byte for byte, from either side.
TEST(Diff, AGapOfAnyLengthIsToldAsWhatItIs) {
    const Lines lines = lines_of_triangle(250);
    Lines shorter = lines;
    constexpr std::size_t gap = 60'000;
    const auto begin = shorter.steps.begin() + 100;
    shorter.steps.erase(begin, begin + gap);
    const TraceDiff found = diff_of(lines.text(), shorter.text());
    EXPECT_EQ(only_in_a(found), gap);
    EXPECT_EQ(mirrored_counts_of(diff_of(shorter.text(), lines.text())), counts_of(found));
}

TEST(Diff, TheColorOfAPrimitiveChangesItsPixels) {
    const Lines lines(first_triangle_trace());
    Lines other = lines;
    Json primitive = Json::parse(other.steps[0]);
    primitive["color"] = "#ff0000";
    other.steps[0] = primitive.dump();
    for (const TraceDiff& found :
         {diff_of(lines.text(), other.text()), diff_of(other.text(), lines.text())}) {
        EXPECT_THAT(counts_of(found), ElementsAre("primitive 1 0 0 0"));
        EXPECT_EQ(found.picture->colors, 49U);
        EXPECT_EQ(found.led_to.count, 49U);
        EXPECT_EQ(found.led_to.colors.size(), 49U);
        EXPECT_THAT(found.picture->faces_a, IsEmpty()); // nobody else has drawn them
    }
}

// A part of a face is the face's, as are its vertices.
TEST(Diff, AVertexReachesThePartsOfItsFaces) {
    const auto trace = [](int z) {
        return trace_text(scene_in(R"({"canvas":{"width":32,"height":32},
                "vertices":{"A":[-1,-1,-2],"B":[1,-1,-2],"C":[0,1,)" +
                                   std::to_string(z) + R"(]},"triangles":["ABC"],
                "camera":{"position":[0,0,0],"look_at":[0,0,-1],"up":[0,1,0]},
                "projection":{"type":"frustum","fov_y":90,"near":1,"far":10}})"),
                          in_lines);
    };
    const TraceDiff found = diff_of(trace(1), trace(2));
    ASSERT_TRUE(found.first.has_value());
    EXPECT_EQ(found.first->kind, "vertex");
    const PictureDifference& picture = *found.picture;
    EXPECT_GT(found.led_to.count, 0U);
    EXPECT_EQ(found.led_to.count, picture.only_a + picture.only_b + picture.colors + picture.owners)
        << diff_text(found);
}

TEST(Diff, WhatTheEndRecordSaysOfStepsThatAreNotThere) {
    for (const TraceLayout layout : {TraceLayout::json, TraceLayout::jsonl}) {
        const std::string whole = first_triangle_trace(layout);
        std::string other = whole;
        const std::size_t frame = other.find("\"frame\":\"") + std::strlen("\"frame\":\"");
        other[frame] = other[frame] == '0' ? '1' : '0';
        const TraceDiff found = diff_of(whole, other);
        EXPECT_FALSE(found.is_same);
        ASSERT_EQ(found.end.size(), 1U);
        EXPECT_EQ(found.end[0].name, "end.frame");
        EXPECT_TRUE(diff_of(whole, other, {.ignored = {"end"}}).is_same);
        EXPECT_THROW(diff_of(whole, whole + "{\"end\":{}}\n"), Problem);
    }
}

TEST(Diff, WhatMayStandBehindTheBreakIsNotMissed) {
    const std::string scene = R"({"canvas":{"width":8,"height":8,"origin":"bottom-left"},
        "vertices":{"A":[0,0],"B":[6,0],"C":[0,6],"D":[7,1],"E":[7,7],"F":[1,7]},
        "triangles":["ABC","DEF"]})";
    const Lines lines(trace_text(scene_in(scene), in_lines));
    auto primitives = primitives_in(lines);
    std::swap(primitives[1], primitives[2]);
    const std::string turned = lines_of(lines, primitives).text();
    for (std::size_t size = turned.find('\n') + 1; size < turned.rfind("{\"end\""); size += 7) {
        const TraceDiff found = diff_of(lines.text(), turned.substr(0, size));
        SCOPED_TRACE(std::to_string(size) + "\n" + diff_text(found));
        for (const KindDifference& kind : found.kinds)
            EXPECT_EQ(kind.changed + kind.only_a + kind.only_b, 0U) << kind.kind;
    }
}

TEST(Diff, OneNameInTwoWaysToWriteIt) {
    const auto trace = [](const std::string& name, const std::string& blank) {
        return R"({"rastertrace":1,"title":")" + name + R"(","canvas":{"width":4,"height":4}})" +
               "\n" + blank + R"({"step":"primitive","kind":"triangle","name":")" + name + "\"}\n" +
               blank + R"({"step":"pixel","x":1,"y":1})" + "\n{\"end\":{}}\n";
    };
    EXPECT_TRUE(diff_of(trace("\u00c4B", ""), trace("\\u00c4B", "")).is_same);
    EXPECT_TRUE(diff_of(trace("AB", ""), trace("AB", "\n \r\n")).is_same);
    std::string other = trace("AB", "\r\n");
    other.replace(other.find("\"y\":1"), 5, "\"y\":0");
    const TraceDiff found = diff_of(trace("AB", "\r\n"), other);
    EXPECT_EQ(found.first->a->number, 2U);
}

/// The trace of a scene.
std::string drawn(const std::string& scene) {
    std::string trace = trace_of_example({"scene.json", scene}, {}, TraceLayout::jsonl);
    EXPECT_FALSE(trace.empty()) << scene;
    return trace;
}

/// Triangles of a scene that may be drawn under any names.
struct NamelessTriangle {
    int id; ///< stays with it
    std::array<int, 6> at;
    int color;
};

enum class Naming { by_id, all_alike, by_place };

/// The trace of them. A scene has no two triangles of one name; another program may.
std::string trace_named(const std::vector<NamelessTriangle>& triangles, Naming naming) {
    Json scene{{"canvas", {{"width", 20}, {"height", 20}, {"origin", "top-left"}}},
               {"method", {{"fill", "top-left"}}}};
    for (std::size_t place = 0; place < triangles.size(); ++place) {
        const NamelessTriangle& one = triangles[place];
        const std::string number =
            std::to_string(naming == Naming::by_id ? one.id : static_cast<int>(place));
        Json names = Json::array();
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string name = "P" + std::to_string(one.id) + "abc"[i];
            names.push_back(name);
            scene["vertices"][name] = {one.at[2 * i] / 4.0, one.at[2 * i + 1] / 4.0};
        }
        scene["triangles"].push_back({{"vertices", names},
                                      {"name", "T" + number},
                                      {"color", one.color == 0 ? "#102030" : "#405060"}});
    }
    Lines lines(drawn(scene.dump()));
    for (std::string& step : lines.steps)
        if (naming == Naming::all_alike && step.find(R"("name":"T)") != std::string::npos) {
            Json named = Json::parse(step);
            named["name"] = "T";
            step = named.dump();
        }
    return lines.text();
}

NamelessTriangle random_nameless(Random& random, int id) {
    NamelessTriangle one{.id = id, .at = {}, .color = 0};
    for (int& coordinate : one.at)
        coordinate = static_cast<int>(random.whole(0, 4 * 19));
    return one;
}

/// Drops one, puts one in, moves a vertex, exchanges two neighbors or changes a color.
void mutate(std::vector<NamelessTriangle>& triangles, Random& random) {
    const auto place =
        static_cast<std::size_t>(random.whole(0, static_cast<int>(triangles.size()) - 2));
    const auto at = triangles.begin() + static_cast<std::ptrdiff_t>(place);
    switch (random.whole(0, 4)) {
    case 0:
        triangles.erase(at);
        break;
    case 1:
        triangles.insert(at, random_nameless(random, 1000 + static_cast<int>(place)));
        break;
    case 2:
        at->at[static_cast<std::size_t>(random.whole(0, 5))] +=
            static_cast<int>(random.whole(1, 9));
        break;
    case 3:
        std::iter_swap(at, at + 1);
        break;
    default:
        at->color = 1;
    }
}

TEST(Diff, PrimitivesAreFoundWhateverTheirNames) {
    Random random(42);
    std::size_t renamed = 0;
    for (std::uint64_t round = 0; round < random_cases(500U); ++round) {
        std::vector<NamelessTriangle> before;
        const int count = static_cast<int>(random.whole(2, 16));
        for (int id = 0; id < count; ++id)
            before.push_back(random_nameless(random, id));
        std::vector<NamelessTriangle> now = before;
        mutate(now, random);
        const auto compared = [&](Naming old_names, Naming new_names, const DiffOptions& options) {
            return diff_of(trace_named(before, old_names), trace_named(now, new_names), options);
        };
        // A step that says that a primitive draws nothing is found by its name.
        const DiffOptions nameless{.ignored = {"primitive.name", "skip"}};
        const auto without_names = [](std::vector<std::string> counts) {
            std::erase_if(counts, [](const std::string& one) {
                return one.starts_with("primitive ") || one.starts_with("skip ");
            });
            return counts;
        };
        const TraceDiff by_names = compared(Naming::by_id, Naming::by_id, {});
        const auto nameless_counts = counts_of(compared(Naming::by_id, Naming::by_id, nameless));
        for (const auto& [old_names, new_names] : {std::pair(Naming::all_alike, Naming::all_alike),
                                                   std::pair(Naming::by_place, Naming::by_place),
                                                   std::pair(Naming::by_id, Naming::all_alike),
                                                   std::pair(Naming::all_alike, Naming::by_id)}) {
            const TraceDiff found = compared(old_names, new_names, nameless);
            SCOPED_TRACE(diff_text(by_names) + "\n" + diff_text(found));
            EXPECT_EQ(counts_of(found), nameless_counts);
            // A name that is another one is a difference of its primitive, and of nothing else.
            const auto told = counts_of(compared(old_names, new_names, {}));
            EXPECT_EQ(without_names(told), without_names(counts_of(by_names)));
            renamed += told != counts_of(by_names) ? 1 : 0;
        }
    }
    EXPECT_GT(renamed, random_cases<std::size_t>(500));
}

TEST(Diff, OneTriangleOfAHundredThatIsGoneIsToldAlone) {
    std::vector<NamelessTriangle> all;
    for (int id = 0; id < 100; ++id) {
        const int x = 8 * (id % 10);
        const int y = 8 * (id / 10);
        all.push_back({.id = id, .at = {x, y, x + 7, y, x, y + 7}, .color = 0});
    }
    std::vector<NamelessTriangle> fewer = all;
    fewer.erase(fewer.begin() + 50);
    const Lines lines(trace_named(all, Naming::by_id));
    const std::size_t own_steps = primitives_in(lines)[51].size();
    for (const Naming naming : {Naming::by_id, Naming::all_alike, Naming::by_place}) {
        const TraceDiff found = diff_of(trace_named(all, naming), trace_named(fewer, naming),
                                        {.ignored = {"primitive.name"}});
        EXPECT_EQ(only_in_a(found), own_steps) << diff_text(found);
    }
    EXPECT_THAT(counts_of(diff_of(trace_named(all, Naming::by_place),
                                  trace_named(fewer, Naming::by_place))),
                ::testing::Contains("primitive 49 1 0 0"));
}

// Names also stand in front of the primitives: faces, lights, vertices.
TEST(Diff, ARenamedPrimitiveIsToldAsOne) {
    const auto scene = [](const std::string& first, const std::string& second) {
        return R"({"vertices":{"A":[0,0,0],"B":[4,0,0],"C":[0,4,0],"D":[4,4,1]},"method":{"cull":"back"},)"
               R"("camera":{"position":[1,1,9],"look_at":[1,1,0]},)"
               R"("projection":{"type":"frustum","fov_y":60,"near":1,"far":50},)"
               R"("canvas":{"width":32,"height":32},"triangles":[{"vertices":"ABC","name":")" +
               first + R"("},{"vertices":"BDC","name":")" + second + R"("}]})";
    };
    const std::string one = drawn(scene("one", "two"));
    ASSERT_THAT(one, HasSubstr(R"({"step":"face","name":"one")"));
    const TraceDiff found = diff_of(one, drawn(scene("eins", "zwei")));
    EXPECT_THAT(counts_of(found), ElementsAre("primitive 2 0 0 0", "face 0 2 2 0"));
    EXPECT_THAT(diff_text(diff_of(one, drawn(scene("eins", "zwei")), {.ignored = {"face"}})),
                HasSubstr("    renamed: one in a is eins in b\n"));
}

TEST(Diff, OnlyWhatBothTellIsComparedIfSoAsked) {
    const std::string full = first_triangle_trace();
    Lines fewer(full);
    std::erase_if(fewer.steps, [](const std::string& step) {
        return step.starts_with(R"({"step":"edge")") || step.starts_with(R"({"step":"primitive")");
    });
    for (std::string& step : fewer.steps)
        if (step.starts_with(R"({"step":"scanline")")) {
            Json row = Json::parse(step);
            row.erase("left_edge");
            row["speed"] = 7;
            step = row.dump();
        }
    EXPECT_FALSE(diff_of(full, fewer.text(), {.ignored = {"end"}}).is_same);
    const TraceDiff found =
        diff_of(full, fewer.text(), {.ignored = {"end"}, .compares_common = true});
    EXPECT_TRUE(found.is_same) << diff_text(found);
    EXPECT_THAT(found.remarks, ::testing::Contains("compared: only the fields that both traces "
                                                   "have, of pixel, scanline"));
}

TEST(Diff, TheStepsAroundADifferenceAreToldAsInTheWholeTrace) {
    Random random(23);
    for_random_traces(200, [&](const RandomTrace& random_trace, std::uint64_t) {
        const Lines lines(random_trace.text());
        const int count = static_cast<int>(lines.steps.size());
        Lines shorter = lines;
        shorter.steps.erase(shorter.steps.begin() + random.whole(0, count - 1));
        const TraceDiff found = diff_of(lines.text(), shorter.text());
        const Trace whole = sound_trace(lines.text());
        Replay replay(whole, {.depths = true});
        std::vector<DiffStep> told = found.before_a;
        if (found.first->a)
            told.push_back(*found.first->a);
        told.insert(told.end(), found.after_a.begin(), found.after_a.end());
        for (const DiffStep& step : told) {
            replay.go_to(step.number);
            EXPECT_EQ(step.sentence, describe_step(replay)) << step.number;
        }
    });
}

// What a trace of one primitive does not tell is not taken for an empty buffer.
TEST(Diff, TheReasonOfADepthTestIsThatOfTheBuffer) {
    const std::string scene = R"({"canvas":{"width":6,"height":6,"origin":"top-left"},)"
                              R"("vertices":{"A":[0,0,1],"B":[5,0,1],"C":[0,5,1]},"triangles":[)"
                              R"({"vertices":"ABC","name":"T3"},{"vertices":"ABC","name":"T4"}],)"
                              R"("method":{"depth":"inverse-z"}})";
    Lines lines(trace_text(scene_in(scene), in_lines));
    const auto failed = std::find_if(lines.steps.begin(), lines.steps.end(), [](const auto& step) {
        return step.find(R"("pass":false)") != std::string::npos;
    });
    ASSERT_NE(failed, lines.steps.end());
    const std::string text = lines.text();
    failed->insert(failed->size() - 1, R"(,"beside":"X")");
    EXPECT_THAT(diff_of(text, lines.text()).first->a->sentence,
                "depth at (0, 0): 1 against 1 of T3: fails (1/z, larger is nearer; z = 1 against "
                "1; of equals the first stays)");
    const Trace alone = readable_trace(
        trace_text(scene_in(scene), {.layout = TraceLayout::jsonl, .filter = {.primitive = "T4"}}));
    Replay replay(alone, {.depths = true});
    replay.go_to(*alone.steps_of({StepKind::depth}).begin());
    EXPECT_THAT(describe_step(replay), HasSubstr("; of equals the first stays)"));
}

// What clipping leaves of ABC is ABC/1, ABC/2 here; another program fills ABC.
TEST(Diff, PartsAreTheirTriangleWhereTheOtherTraceHasOnlyThat) {
    const std::string ours = trace_text(
        scene_in(R"({"canvas":{"width":8,"height":8},"convention":"opengl",)"
                 R"("vertices":{"A":[-1,-1,0,1],"B":[1,-1,0,1],"C":[0,2,3,2],"D":[0,2,-1,2]},)"
                 R"("triangles":["ABC","ABD"]})"),
        in_lines);
    ASSERT_THAT(ours, HasSubstr(R"("name":"ABC/2")"));
    Lines theirs(ours);
    theirs.header = theirs.header.substr(0, theirs.header.find(R"(,"method")")) + "}";
    std::erase_if(theirs.steps, [](const std::string& step) {
        const Json json = Json::parse(step);
        return json.contains("part") ||
               (json["step"] != "primitive" && json["step"] != "depth" && json["step"] != "pixel");
    });
    const DiffOptions common{
        .ignored = {"header"}, .compares_order = false, .compares_common = true};
    EXPECT_TRUE(diff_of(ours, theirs.text(), common).is_same)
        << diff_text(diff_of(ours, theirs.text(), common));
    EXPECT_TRUE(diff_of(theirs.text(), ours, common).is_same);

    Lines exchanged = theirs; // ABD first
    auto primitives = primitives_in(theirs);
    std::swap(primitives[1], primitives[2]);
    exchanged = lines_of(theirs, primitives);
    EXPECT_THAT(counts_of(diff_of(ours, exchanged.text(), {.only = {"primitive"}})),
                ElementsAre("primitive 0 0 0 1"));

    const auto pixel = std::find_if(theirs.steps.begin(), theirs.steps.end(), [](const auto& step) {
        return step.find(R"("step":"pixel")") != std::string::npos;
    });
    theirs.steps.erase(pixel);
    const TraceDiff found = diff_of(ours, theirs.text(), common);
    EXPECT_THAT(counts_of(found), ElementsAre("pixel 0 1 0 0"));
    EXPECT_EQ(found.first->primitive, "ABC");
}

// A vertex that another program tells only on the screen is compared there.
TEST(Diff, VerticesAreComparedInTheSpacesThatBothTell) {
    const std::string ours = trace_text(
        scene_in(R"({"canvas":{"width":9,"height":9},"camera":{"position":[0,0,5],)"
                 R"("look_at":[0,0,0]},"projection":{"type":"view-plane","distance":1},)"
                 R"("vertices":{"A":[0,0,0],"B":[2,0,0],"C":[0,2,0]},"triangles":["ABC"]})"),
        in_lines);
    Lines theirs(ours);
    std::erase_if(theirs.steps, [](const std::string& step) {
        return step.find(R"("vertex")") != std::string::npos &&
               step.find(R"("screen")") == std::string::npos;
    });
    EXPECT_FALSE(diff_of(ours, theirs.text()).is_same);
    const DiffOptions common{.ignored = {"header", "end"}, .compares_common = true};
    EXPECT_TRUE(diff_of(ours, theirs.text(), common).is_same);
    const auto vertex =
        std::find_if(theirs.steps.begin(), theirs.steps.end(), [](const auto& step) {
            return step.find(R"("vertex")") != std::string::npos;
        });
    vertex->insert(vertex->rfind(']'), ",7");
    EXPECT_FALSE(diff_of(ours, theirs.text(), common).is_same);
}

TEST(Diff, StepsOfAKindOfOnesOwnAreFoundByTheirKeys) {
    const auto trace = [](const std::vector<std::string>& tiles) {
        std::string text = R"({"rastertrace":1,"canvas":{"width":4,"height":4}})"
                           "\n";
        for (const std::string& tile : tiles)
            text += R"({"step":"tile",)" + tile + "}\n";
        return text + R"({"end":{}})" + "\n";
    };
    const std::string a = trace(
        {R"("tx":0,"ty":0,"cost":1)", R"("tx":1,"ty":0,"cost":2)", R"("tx":0,"ty":1,"cost":3)"});
    const std::string b = trace({R"("tx":1,"ty":0,"cost":2)", R"("tx":0,"ty":1,"cost":4)"});
    DiffOptions options;
    add_step_key(options, "tile=tx,ty");
    EXPECT_THAT(counts_of(diff_of(a, b, options)), ElementsAre("tile 1 1 0 0"));
    EXPECT_THAT(counts_of(diff_of(a, b)), ElementsAre("tile 2 1 0 0"));
}

TEST(Diff, ThePlaceInTheCodeIsNoDifference) {
    Lines lines(first_triangle_trace());
    for (std::size_t n = 0; n < lines.steps.size(); ++n)
        lines.steps[n].insert(lines.steps[n].size() - 1,
                              R"(,"code":"raster.cpp:)" + std::to_string(n) + "\"");
    EXPECT_TRUE(diff_of(first_triangle_trace(), lines.text()).is_same);
}

} // namespace
} // namespace rastertrace
