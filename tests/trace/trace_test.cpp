// SPDX-License-Identifier: MIT
#include "effort.h"
#include "picture.h"
#include "random_scene.h"
#include "random_triangle.h"
#include "told_problem.h"
#include "traces.h"

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace rastertrace {
namespace {

std::string complaint(const std::string& text) {
    const auto trace = read_trace({"trace.json", text});
    return trace ? "no complaint" : to_text(trace.problem());
}

void expect_complaint(const std::string& text, const std::string& message,
                      const std::string& hint = "") {
    EXPECT_EQ(complaint(text), told_problem(text, message, hint));
}

std::vector<std::string> damage(const std::string& text) {
    const auto trace = read_trace({"trace.json", text});
    std::vector<std::string> messages;
    if (!trace)
        return {"unreadable: " + to_text(trace.problem())};
    for (const Problem& problem : trace.value().damage)
        messages.push_back(problem.message);
    return messages;
}

/// Replaces the first occurrence.
std::string with(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

/// Of the first triangle.
const std::string first_pixel_step = R"({"step":"pixel","x":2,"y":5})";

TEST(Trace, RoundTripInBothLayouts) {
    for (const TraceLayout layout : {TraceLayout::json, TraceLayout::jsonl}) {
        const Trace trace = sound_trace(trace_text(first_triangle(), {layout, {}}));
        EXPECT_EQ(trace.title, "A triangle");
        EXPECT_EQ(trace.canvas, first_triangle().canvas);
        EXPECT_EQ(trace.method.word_of("scalar"), "exact");
        EXPECT_EQ(trace.size(), 62u);
        ASSERT_TRUE(trace.end);
        EXPECT_EQ(trace.end->steps, 62u);
        EXPECT_EQ(trace.end->pixels, 49u);
        EXPECT_EQ(trace.end->count.at("scanline"), 9u);
        EXPECT_EQ(trace.step(14).kind(), StepKind::scanline);
        EXPECT_EQ(trace.step(14).as<ScanlineStep>().left.text(), "-1/4");
        EXPECT_EQ(trace.step(14).as<ScanlineStep>().from, -1);
        EXPECT_FALSE(trace.step(14).field("color"));
    }
}

TEST(Trace, FrameIsThePictureAfterAnyStep) {
    // Step by step against pictures drawn from the steps themselves, going forward and back.
    const Trace trace = trace_of(first_triangle());
    std::vector<Image> pictures{Image(trace.canvas)};
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        pictures.push_back(pictures.back());
        const StepView step = trace.step(n);
        if (step.kind() == StepKind::pixel)
            pictures.back().at({static_cast<int>(*x_in(step)), static_cast<int>(*y_in(step))}) =
                Color{};
    }
    Replay replay(trace);
    for (const std::size_t n : {0u, 5u, 6u, 62u, 30u, 1u, 61u, 0u}) {
        replay.go_to(n);
        EXPECT_EQ(replay.frame().image.colors(), pictures[n].colors()) << n;
        EXPECT_EQ(frame_after(trace, n).image.colors(), pictures[n].colors()) << n;
    }
    EXPECT_EQ(pictures.back().drawn(), 49u);
}

RC_GTEST_PROP(Trace, ReplaysToThePictureThatWasDrawn, ()) {
    const Method method{.scalar =
                            *rc::gen::element(ScalarKind::exact, ScalarKind::double_precision),
                        .lerp = *rc::gen::element(LerpForm::direct, LerpForm::incremental)};
    const Scene scene = triangle_scene(any_triangle(90, 8), {.width = 15, .height = 12}, method);
    log_scene(scene);
    const auto layout = *rc::gen::element(TraceLayout::json, TraceLayout::jsonl);
    const auto trace = read_trace({"t", trace_text(scene, {layout, {}})});
    RC_ASSERT(static_cast<bool>(trace));
    RC_ASSERT(trace.value().damage.empty());
    const Frame frame = frame_after(trace.value(), trace.value().size());
    RC_ASSERT(frame.image.colors() == draw_as_planned(scene).colors());
    RC_ASSERT(frame_name(frame.image) == trace.value().end->frame);
    RC_ASSERT(trace_text(scene, {layout, {}}) == trace_text(scene, {layout, {}}));
}

TEST(Trace, CutShortAfterEveryByte) {
    // Whatever is left, its whole steps are read, and it is said that the rest is missing.
    const Scene scene = triangle_scene({"0", "0", "2", "0", "0", "2"}, {.width = 5, .height = 5});
    for (const TraceLayout layout : {TraceLayout::json, TraceLayout::jsonl}) {
        const std::string whole = trace_text(scene, {layout, {}});
        const std::size_t end_of_header = whole.find('\n');
        for (std::size_t length = 0; length + 1 < whole.size(); ++length) {
            const std::string text = whole.substr(0, length);
            const auto trace = read_trace({"cut.json", text});
            if (length < end_of_header) {
                ASSERT_FALSE(trace) << text;
                EXPECT_NE(trace.problem().line, 0u);
                continue;
            }
            ASSERT_TRUE(trace) << text << "\n" << to_text(trace.problem());
            // A step is whole when its closing brace is there.
            std::size_t steps = 0;
            for (auto at = text.find("\n{\"step\""); at != std::string::npos;
                 at = text.find("\n{\"step\"", at + 1))
                steps += whole.find("}", at) < length ? 1 : 0;
            EXPECT_EQ(trace.value().size(), steps) << text;
            ASSERT_EQ(trace.value().damage.size(), 1u) << text;
            EXPECT_NE(trace.value().damage[0].message.find("truncated"), std::string::npos);
        }
        EXPECT_TRUE(damage(whole.substr(0, whole.size() - 1)).empty())
            << "only the last newline is missing";
    }
}

TEST(Trace, TruncationIsToldWithItsPlace) {
    const std::string whole = trace_text(first_triangle());
    const auto trace = read_trace({"cut.json", whole.substr(0, whole.find("\"y\":4,") + 3)});
    ASSERT_TRUE(trace);
    EXPECT_EQ(
        to_text(trace.value().damage.at(0)),
        "cut.json:8:1: expected the rest of the trace, found the end of the file: the trace is "
        "truncated after 6 whole steps\n"
        "{\"step\":\"scanline\",\"y\"\n"
        "^");
}

TEST(Trace, UnknownStepsAndFieldsAreKept) {
    const std::string text =
        with(with(trace_text(first_triangle()), first_pixel_step,
                  R"({"step":"pixel","x":2,"y":5,"shader":{"name":"caf\u00e9","inputs":[1,2]}},
{"step":"tile","x":0,"note":"foreign"})"),
             R"("steps":62)", R"("steps":63)");
    const Trace trace = sound_trace(text);
    EXPECT_EQ(trace.size(), 63u);
    EXPECT_EQ(trace.step(6).field("shader"), R"({"name":"caf\u00e9","inputs":[1,2]})");
    EXPECT_EQ(trace.step(7).kind_name(), "tile");
    EXPECT_EQ(trace.step(7).kind(), std::nullopt);
    EXPECT_EQ(trace.step(7).field("note"), R"("foreign")");
    EXPECT_EQ(frame_after(trace, 63).image.drawn(), 49u);
}

TEST(Trace, AnyLayoutOfTheDocumentIsRead) {
    // As other programs may write it: on one line, or with blanks everywhere and keys in another
    // order.
    std::string one_line = trace_text(first_triangle());
    one_line.erase(std::remove(one_line.begin(), one_line.end(), '\n'), one_line.end());
    EXPECT_EQ(sound_trace(one_line).size(), 62u);

    const Trace spread =
        sound_trace("{\n \"steps\": [\n  { \"y\": 1,\n \"x\": -1, \"step\": \"pixel\" }\n ],"
                    "\r\n \"canvas\": {\"width\": 3, \"height\": 3},\n"
                    " \"end\": {\"steps\": 1},\n \"rastertrace\": 1\n}\n");
    EXPECT_EQ(picture_of(frame_after(spread, 1).image), "#..\n...\n...\n");
    EXPECT_TRUE(is_trace({"t", "{\n \"steps\": [],\n \"rastertrace\": 1}"}));
    EXPECT_TRUE(is_trace({"t", "\n\n" + trace_text(first_triangle())}));
    EXPECT_FALSE(is_trace({"t", "{\"vertices\": {}}"}));
    EXPECT_EQ(sound_trace("{\"steps\":[\n{\"step\":\"pixel\",\"x\":0,\"y\":0}\n],\n"
                          "\"rastertrace\":1,\"canvas\":{\"width\":3,\"height\":3},\"end\":{}}")
                  .size(),
              1u);
    EXPECT_EQ(sound_trace("\n\n" + trace_text(first_triangle())).size(), 62u);

    std::string carriage_returns = with(trace_text(first_triangle()), "],\n", "],\r\n");
    EXPECT_EQ(sound_trace("\xEF\xBB\xBF" + carriage_returns).size(), 62u);
}

TEST(Trace, ANewerVersionIsRefused) {
    EXPECT_EQ(
        complaint(with(trace_text(first_triangle()), "{\"rastertrace\":1", "{\"rastertrace\":2")),
        "trace.json:1:16: expected a trace of version 1, found version 2\n"
        "{\"rastertrace\":2,\"title\":\"A triangle\",\"canvas\":{\"width\"...\n"
        "               ^\n"
        "hint: a newer rastertrace has written it");
}

TEST(Trace, ALineThatIsNoStepIsRefusedWithItsPlace) {
    const std::string whole = trace_text(first_triangle());
    expect_complaint(with(whole, first_pixel_step, R"({"step":"pixel","x":2 "y":5})"),
                     "trace.json:7:23: expected ',' or '}', found a string");
    expect_complaint(with(whole, first_pixel_step, R"({"step":"pixel","x":2})"),
                     "trace.json:7:1: expected a pixel step with the key \"y\", found none");
    expect_complaint(with(whole, R"("x":2,"y":5})", R"("x":2.9,"y":5})"),
                     "trace.json:7:21: expected a whole number, found 2.9");
    expect_complaint(with(whole, R"("x":2,"y":5})", R"("x":2,"x":3,"y":5})"),
                     "trace.json:7:23: expected each key once, found \"x\" again");
    EXPECT_EQ(
        complaint(with(whole, R"("left":"5/4")", R"("left":"5/0")")),
        "trace.json:8:33: expected a number, or an exact one like \"25/8\", found \"5/0\"\n"
        "{\"step\":\"scanline\",\"y\":4,\"left\":\"5/0\",\"right\":\"19/8\",\"from\":1,\"to\":2,"
        "\"le...\n"
        "                                ^");
    expect_complaint(with(whole, first_pixel_step, R"([1,2])"),
                     "trace.json:7:1: expected a step, found an array of 2");
}

TEST(Trace, ABadEndRecordIsRefusedWithItsPlace) {
    const std::string start =
        "{\"rastertrace\":1,\"canvas\":{\"width\":3,\"height\":3},\"steps\":[\n]";
    expect_complaint(start + ",\"end\":{\"steps\":x}}",
                     "trace.json:2:18: expected a value, found 'x'");
    expect_complaint(start + "} garbage",
                     "trace.json:2:4: expected the end of the file, found more");
}

TEST(Trace, PixelsOffTheCanvasAreToldAndNotDrawn) {
    const std::string text =
        with(trace_text(first_triangle()), R"("x":2,"y":5})", R"("x":9,"y":3000000000})");
    EXPECT_EQ(damage(text), std::vector<std::string>{"expected pixels on the canvas (x -8..8, y "
                                                     "7..-6), found (9, 3000000000)"});
    const auto trace = read_trace({"t", text});
    EXPECT_EQ(frame_after(trace.value(), 62).image.drawn(), 48u);
}

TEST(Trace, CountsThatDoNotAgreeAreTold) {
    EXPECT_EQ(
        damage(with(trace_text(first_triangle()), "{\"step\":\"pixel\",\"x\":2,\"y\":5},\n", "")),
        (std::vector<std::string>{"expected 62 steps as the end record says, found 61",
                                  "expected 49 pixel steps as the end record says, found 48",
                                  "expected 49 pixels as the end record says, found 48"}));
    const std::string foreign =
        with(with(trace_text(first_triangle()), "\"count\":{", "\"count\":{\"tile\":2,"), "],\n",
             "{\"step\":\"tile\"}],\n");
    EXPECT_EQ(damage(with(with(foreign, "}\n{\"step\":\"tile\"}", "},\n{\"step\":\"tile\"}\n"),
                          "\"steps\":62", "\"steps\":63")),
              std::vector<std::string>{"expected 2 tile steps as the end record says, found 1"});
}

TEST(Trace, APictureThatIsNotThatOfTheEndRecordIsTold) {
    const std::string whole = trace_text(first_triangle());
    EXPECT_EQ(damage(with(whole, "\"pixels\":49", "\"pixels\":50")),
              std::vector<std::string>{"expected 50 pixels as the end record says, found 49"});
    const auto moved = damage(with(whole, "\"x\":2,\"y\":5}", "\"x\":2,\"y\":6}"));
    ASSERT_EQ(moved.size(), 1u);
    EXPECT_TRUE(moved[0].starts_with(
        "expected the picture 96f1b027ae1e2a78 as the end record says, found "));
}

// Steps that are not there cannot be missed, but those that are there are held against the whole.
TEST(Trace, APartOfATraceIsHeldAgainstWhatItCanTell) {
    const auto part = [](const StepFilter& filter) {
        std::string text;
        StringOutput output(text);
        write_trace(first_triangle(), {.layout = TraceLayout::json, .filter = filter}, output);
        return text;
    };
    StepFilter rows;
    rows.only = {StepKind::scanline};
    StepFilter pixels;
    pixels.only = {StepKind::pixel};
    StepFilter region;
    region.region = Region{0, 0, 3, 3};
    StepFilter other;
    other.primitive = "XYZ";
    for (const StepFilter& filter : {rows, pixels, region, other})
        EXPECT_EQ(damage(part(filter)), std::vector<std::string>{});

    EXPECT_EQ(damage(with(part(rows), "\"pixels\":49", "\"pixels\":7")), std::vector<std::string>{})
        << "no pixel is there to be counted";
    EXPECT_EQ(damage(with(part(pixels), "\"pixels\":49", "\"pixels\":50")),
              std::vector<std::string>{"expected 50 pixels as the end record says, found 49"});
    EXPECT_EQ(
        damage(with(part(region), "\"pixels\":49", "\"pixels\":7")),
        std::vector<std::string>{"expected at most 7 pixels as the end record says, found 15"});
    EXPECT_EQ(damage(with(part(rows), "\"steps\":9", "\"steps\":8")),
              std::vector<std::string>{"expected 8 steps as the end record says, found 9"});
}

TEST(Trace, NumbersBeyondDoublesAreRefusedInEveryLayout) {
    for (const std::string& number :
         {std::string("1e999"), std::string("-1E+400"), "1" + std::string(400, '0')}) {
        const std::string step =
            with(R"({"step":"pixel","x":2,"y":5,"note":[{"a":NUMBER}]})", "NUMBER", number);
        const std::string line = with(trace_text(first_triangle()), first_pixel_step, step);
        std::string one_line = line;
        one_line.erase(std::remove(one_line.begin(), one_line.end(), '\n'), one_line.end());
        const std::string lines =
            with(trace_text(first_triangle(), {TraceLayout::jsonl, {}}), first_pixel_step, step);
        for (const std::string& text : {line, one_line, lines})
            EXPECT_NE(complaint(text).find("expected a number up to 1.797e308, found"),
                      std::string::npos)
                << complaint(text);
    }
    const std::string large = with(trace_text(first_triangle()), first_pixel_step,
                                   R"({"step":"pixel","x":2,"y":5,"note":[1e308,1e-999]})");
    EXPECT_EQ(damage(large), std::vector<std::string>{});
}

TEST(Trace, AHeaderThatCannotBeUsed) {
    EXPECT_EQ(complaint("{\"rastertrace\":1}").substr(0, 59),
              "trace.json:1:1: expected the key \"canvas\", found none\n{\"ras");
    EXPECT_EQ(
        complaint(with(trace_text(first_triangle()), "\"width\":17", "\"width\":2147483648"))
            .substr(0, 94),
        "trace.json:1:57: expected a whole number of pixels from 1 to 16384, found 2147483648\n"
        "{\"rastert");
}

// A short fuzz: damaged traces are read or refused, never more. tests/fuzz has the long one.
TEST(Trace, SurvivesAnyDamage) {
    const std::size_t written = trace_of(first_triangle()).size();
    std::size_t refused = 0, damaged = 0, sound = 0;
    const auto survives = [&] {
        std::string text = trace_text(
            first_triangle(), {*rc::gen::element(TraceLayout::json, TraceLayout::jsonl), {}});
        const int changes = *rc::gen::inRange(1, 6);
        for (int i = 0; i < changes && !text.empty(); ++i) {
            const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
            const auto size = *rc::gen::inRange<std::size_t>(0, 40);
            switch (*rc::gen::inRange(0, 4)) {
            case 0:
                text[at] = *rc::gen::arbitrary<char>();
                break;
            case 1:
                text.erase(at, size);
                break;
            case 2:
                text.resize(text.size() - at);
                break;
            default:
                text.insert(at, text.substr(text.size() - at, size));
                break;
            }
        }
        const auto read = read_trace({"t", text});
        if (!read) {
            ++refused;
            RC_ASSERT(to_text(read.problem()).starts_with("t:"));
            return;
        }
        const Trace& trace = read.value();
        const Frame frame = frame_after(trace, trace.size());
        RC_ASSERT(frame.image.colors().size() <= 67'108'864u);
        RC_ASSERT(is_trace({"t", text}));
        // A step that is missing, or is there twice, is told of.
        RC_ASSERT(!trace.damage.empty() || trace.size() == written);
        ++(trace.damage.empty() ? sound : damaged);
    };
    // Few changes leave a trace that is damaged and can be read: mostly where the end is gone.
    for (int run = 0; run < 10; ++run)
        ASSERT_TRUE(rc::check(survives));
    EXPECT_GT(refused, 0u);
    EXPECT_GT(damaged, 0u);
    EXPECT_GT(sound, 0u);
}

// What was written a moment ago is read without being checked: to the same steps.
TEST(Trace, AnExcerptOfAnExcerptHasItsOwnSteps) {
    const Trace whole = trace_of(first_triangle());
    Trace excerpt = whole.without_steps();
    for (const std::size_t n : whole.steps_of({StepKind::scanline}))
        excerpt.add_to_excerpt(n);
    Trace last = excerpt.without_steps();
    EXPECT_EQ(last.size(), 0U);
    last.add_to_excerpt(excerpt.number_of(excerpt.size()));
    ASSERT_EQ(last.size(), 1U);
    EXPECT_EQ(last.step(1).json(), excerpt.step(excerpt.size()).json());
}

TEST(Trace, WhatIsDrawnIsWhatIsReadOfItsText) {
    std::size_t compared = 0;
    for (std::uint64_t seed = 0; seed < random_cases(100u); ++seed) {
        const auto read = read_scene({"scene.json", RandomScene(seed).text()});
        if (!read)
            continue;
        ++compared;
        const std::string text = trace_text(read.value().scene);
        const Trace checked = sound_trace(text);
        const PlannedScene& planned = read.value();
        const Trace drawn = drawn_trace(planned.scene, planned.plan, "trace.json", 1'000'000);
        ASSERT_EQ(drawn.size(), checked.size()) << text;
        EXPECT_EQ(drawn.method.words, checked.method.words);
        EXPECT_EQ(drawn.end->frame, checked.end->frame);
        EXPECT_EQ(drawn.end->count, checked.end->count);
        for (std::size_t i = 1; i <= drawn.size(); ++i) {
            const std::size_t n = seed % 2 == 0 ? i : 1 + i * 7919 % drawn.size();
            ASSERT_EQ(drawn.kind_of(n), checked.kind_of(n)) << text;
            ASSERT_EQ(drawn.step(n).json(), checked.step(n).json());
            ASSERT_EQ(x_in(drawn.step(n)), x_in(checked.step(n)));
            ASSERT_EQ(drawn.step(n).field("color"), checked.step(n).field("color"));
        }
    }
    EXPECT_GT(compared, random_cases(100u) / 2);
}

// Pixels in a row are held as one step: two triangles of 100 rows take two steps a row, and a few for their edges.
TEST(Trace, PixelsInARowAreHeldAsOneStep) {
    const auto read = read_scene({"scene.json", R"({
        "canvas":{"width":100,"height":100,"origin":"top-left"},
        "vertices":{"A":[0,0],"B":[99,0],"C":[99,99],"D":[0,99]},"triangles":["ABC","ACD"],
        "method":{"fill":"scanline"}})"});
    ASSERT_TRUE(read) << to_text(read.problem());
    const PlannedScene& planned = read.value();
    const Trace trace = drawn_trace(planned.scene, planned.plan, "scene.json", 500);
    EXPECT_GT(trace.size(), 10'000u);
    try {
        drawn_trace(planned.scene, planned.plan, "scene.json", 200);
        FAIL() << "200 steps are too few";
    } catch (const Problem& problem) {
        EXPECT_EQ(
            to_text(problem),
            "scene.json: expected at most 200 steps to hold, found more\n"
            "hint: --max-steps N holds more of them, about 150 bytes each; `trace` writes any "
            "number of them");
    }
}

TEST(Trace, ManyCountsThatDisagreeAreToldAtOnePlace) {
    std::string counts;
    for (int i = 0; i < 2; ++i)
        counts += (i == 0 ? "\"kind" : ",\"kind") + std::to_string(i) + "\":1";
    const std::string text = R"({"rastertrace":1,"canvas":{"width":3,"height":3}})"
                             "\n{\"end\":{\"count\":{" +
                             counts + "}}}\n";
    const auto trace = read_trace({"t.jsonl", text});
    ASSERT_TRUE(trace);
    ASSERT_EQ(trace.value().damage.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ(to_text(trace.value().damage[i]), "t.jsonl:2:8: expected 1 kind" +
                                                        std::to_string(i) +
                                                        " steps as the end record says, found 0\n"
                                                        "{\"end\":{\"count\":{" +
                                                        counts + "}}}\n       ^");
}

} // namespace
} // namespace rastertrace
