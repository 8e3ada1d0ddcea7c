// SPDX-License-Identifier: MIT
// A trace that is opened by its index is the trace that is read; an index of anything else is never used.

#include "effort.h"
#include "random_scene.h"
#include "same_replay.h"
#include "traces.h"

#include <rastertrace/trace/explain/explain.h>
#include <rastertrace/trace/explain/pixel_units.h>
#include <rastertrace/trace/record/frame.h>
#include <rastertrace/trace/record/trace_index.h>
#include <rastertrace/trace/record/traced_steps.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {
namespace {

namespace fs = std::filesystem;

constexpr FrameParts all_parts{.writes = true, .depths = true};

class TraceIndexTest : public testing::Test {
protected:
    TraceIndexTest() {
        std::string pattern = (fs::temp_directory_path() / "rastertrace-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
        path_ = (folder_ / "trace.jsonl").string();
        index_ = path_of_index(path_);
    }
    ~TraceIndexTest() override { fs::remove_all(folder_); }

    static void write(const std::string& path, const std::string& text) {
        std::ofstream(path, std::ios::binary) << text;
    }
    static std::string bytes_of(const std::string& path) {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    Source source() const { return std::move(read_source(path_).value()); }
    Trace read() const { return std::move(read_trace(source()).value()); }

    /// Many blocks and keyframes, however small the trace is.
    void make_index() const {
        const Trace trace = read();
        write_index(trace, contents_of(trace).known, index_,
                    {.block = 300, .keyframe = 40, .share_of_frames = 0});
    }

    Trace opened() const {
        return std::move(
            read_trace(source(), {.index = TraceIndex::open(index_, source())}).value());
    }

    /// Why the index is not used; "" if it is.
    std::string refusal() const {
        try {
            TraceIndex::open(index_, source());
        } catch (const Problem& problem) {
            return problem.message;
        }
        return "";
    }

    /// A trace with its index; false if the scene cannot be drawn.
    bool draw(const std::string& scene_text, TraceLayout layout) const {
        const auto scene = read_scene({"scene.json", scene_text});
        if (!scene)
            return false;
        write(path_, trace_text(scene.value().scene, {.layout = layout, .filter = {}}));
        if (read().size() == 0)
            return false;
        make_index();
        return true;
    }

    fs::path folder_;
    std::string path_;
    std::string index_;
};

/// A triangle in each cell of a grid.
std::string many_triangles(std::string_view method) {
    std::string vertices;
    std::string triangles;
    constexpr int side = 7;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const std::string n = std::to_string(y * side + x);
            const auto add = [&](const char* name, int dx, int dy) {
                vertices += (vertices.empty() ? "\"" : ",\"") + std::string(name) + n + "\":[" +
                            std::to_string(7 * x + dx) + "," + std::to_string(7 * y + dy) + "]";
            };
            add("a", 0, x % 3);
            add("b", 9, 1);
            add("c", 1 + y % 4, 8);
            triangles +=
                (triangles.empty() ? "[\"a" : ",[\"a") + n + "\",\"b" + n + "\",\"c" + n + "\"]";
        }
    return R"({"canvas":{"width":56,"height":56,"origin":"bottom-left"},"vertices":{)" + vertices +
           R"(},"triangles":[)" + triangles + "],\"method\":{" + std::string(method) + "}}";
}

/// What people are told: the nearest, and how many others there are.
struct Told {
    std::string answer;
    std::vector<std::string> lines{};
    std::map<std::string, std::size_t> others{};

    bool operator==(const Told&) const = default;
};

Told told_of(Explanation explanation, std::size_t most) {
    Told told{.answer = explanation.question + ": " + explanation.answer,
              .lines = explanation.lacks,
              .others = explanation.farther};
    const auto add = [&told](const std::vector<std::string>& lines) {
        told.lines.insert(told.lines.end(), lines.begin(), lines.end());
    };
    for (const Try& one : explanation.tries) {
        add({std::to_string(one.number), one.step, one.primitive, one.sentence, one.before,
             one.after});
        add(one.working);
    }
    auto& why_not = explanation.why_not;
    std::stable_sort(why_not.begin(), why_not.end(), was_nearer_to_drawing);
    for (std::size_t i = 0; i < why_not.size(); ++i) {
        if (i >= most) {
            ++told.others[why_not[i].reason];
            continue;
        }
        add({why_not[i].primitive, why_not[i].reason, why_not[i].sentence});
        add(why_not[i].working);
    }
    return told;
}

/// The nearest primitives are the same by the index, by the trace gone through in threads, and where each primitive is told
/// of. How many pixels were told of by the index alone.
std::size_t expect_same_answers(const Trace& read, const Trace& indexed, std::size_t most,
                                int every) {
    std::size_t by_index = 0;
    const Canvas& canvas = read.canvas;
    for (int row = 0; row < canvas.height; row += every)
        for (int x = canvas.left(); x <= canvas.right(); x += every) {
            const Pixel pixel{x, canvas.y_of(row)};
            const Told expected = told_of(explain(read, {.pixel = pixel}).value(), most);
            for (const Trace* const trace : {&indexed, &read}) {
                const Explanation answer =
                    explain(*trace, {.pixel = pixel, .most_why_not = most}).value();
                by_index += trace == &read || answer.farther.empty() ? 0 : 1;
                const Told told = told_of(answer, most);
                EXPECT_EQ(told.answer, expected.answer);
                EXPECT_EQ(told.lines, expected.lines) << expected.answer;
                EXPECT_EQ(told.others, expected.others) << expected.answer;
            }
            if (testing::Test::HasFailure())
                return by_index;
        }
    return by_index;
}

TEST_F(TraceIndexTest, HasTheStepsAndTheReplaysOfTheTrace) {
    Random random(3);
    for (std::uint64_t seed = 0; seed < 80; ++seed) {
        if (!draw(RandomScene(seed).text(), seed % 2 == 0 ? TraceLayout::json : TraceLayout::jsonl))
            continue;
        const Trace whole = read();
        const Trace indexed = opened();
        ASSERT_EQ(steps_of(indexed), steps_of(whole));
        EXPECT_EQ(damage_of(indexed), damage_of(whole));
        for (std::size_t n = 1; n <= whole.size(); ++n)
            EXPECT_EQ(indexed.next_of({StepKind::vertex, StepKind::pixel}, n, whole.size()),
                      whole.next_of({StepKind::vertex, StepKind::pixel}, n, whole.size()));
        Replay jumping(indexed, all_parts);
        for (int i = 0; i < 12; ++i) {
            const auto n =
                static_cast<std::size_t>(random.whole(0, static_cast<int>(whole.size())));
            Replay straight(whole, all_parts);
            while (straight.step() < n)
                straight.go_to(straight.step() + 1);
            jumping.go_to(n);
            expect_same(jumping, straight);
            for (std::size_t step = 1; step <= whole.size(); step += 17)
                if (whole.kind_of(step) == StepKind::vertex) {
                    const auto name = whole.step(step).as<VertexStep>().name.text();
                    EXPECT_EQ(jumping.places_of(name), straight.places_of(name));
                }
            ASSERT_FALSE(HasFailure()) << "seed " << seed << ", step " << n;
        }
    }
}

TEST_F(TraceIndexTest, AnswersAsTheTraceDoes) {
    std::size_t by_index = 0;
    for (std::uint64_t seed = 0; seed < all_cases(150U); ++seed) {
        if (!draw(RandomScene(seed).text(), TraceLayout::jsonl))
            continue;
        by_index += expect_same_answers(read(), opened(), 1 + seed % 3, 3);
        ASSERT_FALSE(HasFailure()) << "seed " << seed;
    }
    EXPECT_GT(by_index, all_cases(100U));
}

TEST_F(TraceIndexTest, AnswersAsTheTracesOfExamplesDo) {
    std::vector<fs::path> examples;
    for (const auto& entry : fs::recursive_directory_iterator(RASTERTRACE_EXAMPLES))
        if (entry.path().extension() == ".json")
            examples.push_back(entry.path());
    std::sort(examples.begin(), examples.end()); // a folder has no order
    std::size_t by_index = 0;
    for (const fs::path& example : examples) {
        const auto scene = read_scene({example.string(), bytes_of(example.string())});
        constexpr std::size_t largest = 100'000;
        if (!scene)
            continue;
        const std::string text = trace_text(scene.value(), in_lines);
        if (text.size() > largest || text.find("\n{\"step\"") == std::string::npos)
            continue;
        write(path_, text);
        make_index();
        constexpr int every = all_cases(10) == 10 ? 8 : 24;
        by_index += expect_same_answers(read(), opened(), 2, every);
        ASSERT_FALSE(HasFailure()) << example;
    }
    EXPECT_GT(by_index, all_cases(100U));
}

TEST_F(TraceIndexTest, ATraceInPartsHasWhatItHasAsAWhole) {
    std::size_t with_parts_of_primitives = 0;
    for (std::uint64_t seed = 0; seed < all_cases(150U); ++seed) {
        if (!draw(RandomScene(seed).text(), TraceLayout::jsonl))
            continue;
        const Trace trace = read();
        const TraceContents whole = contents_of(trace, 1, trace.size());
        const TraceContents parts = contents_of(trace, 2, 1);
        ASSERT_TRUE(whole.known.are_known);
        EXPECT_TRUE(parts.known.are_known);
        EXPECT_TRUE(parts.known.units == whole.known.units) << seed;
        EXPECT_EQ(parts.known.others, whole.known.others) << seed;
        EXPECT_EQ(parts.primitives, whole.primitives) << seed;
        EXPECT_EQ(parts.loose, whole.loose) << seed;
        EXPECT_EQ(parts.vertices, whole.vertices) << seed;
        with_parts_of_primitives += std::any_of(whole.known.units.begin(), whole.known.units.end(),
                                                [](const PixelUnit& unit) { return unit.is_part; })
                                        ? 1
                                        : 0;
    }
    EXPECT_GT(with_parts_of_primitives, all_cases(10U));
}

TEST_F(TraceIndexTest, AnswersOfManyTrianglesWithFewOfThem) {
    for (const std::string method :
         {R"("fill":"top-left")", R"("fill":"scanline")", R"("fill":"barycentric")",
          R"("fill":"two-halves","rounding":"nearest")", R"("fill":"scanline","scalar":"float")",
          R"("fill":"top-left","scalar":"fixed")"}) {
        ASSERT_TRUE(draw(many_triangles(method), TraceLayout::jsonl)) << method;
        const Trace trace = read();
        const Trace indexed = opened();
        EXPECT_EQ(expect_same_answers(trace, indexed, most_why_not_told, 4), 14U * 14U) << method;
        ASSERT_FALSE(HasFailure()) << method;
        const auto chosen = steps_to_read(indexed, {3, 3}, 1);
        ASSERT_TRUE(chosen);
        EXPECT_LT(chosen->steps.size(), trace.size() / 2) << method;
    }
}

TEST_F(TraceIndexTest, AnotherTraceCutOrRandomBytesAreNoIndex) {
    ASSERT_TRUE(draw(many_triangles(R"("fill":"scanline")"), TraceLayout::jsonl));
    const std::string of_this = bytes_of(index_);
    const std::string text = bytes_of(path_);
    EXPECT_EQ(refusal(), "");
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        write(index_, of_this.substr(0, of_this.size() * static_cast<std::size_t>(i) / 200));
        EXPECT_NE(refusal(), "") << i;
        std::string noise(static_cast<std::size_t>(random.whole(0, 5000)), ' ');
        for (char& byte : noise)
            byte = static_cast<char>(random.whole(0, 255));
        write(index_, noise);
        EXPECT_NE(refusal(), "") << i;
    }
    ASSERT_TRUE(draw(many_triangles(R"("fill":"top-left")"), TraceLayout::jsonl));
    const std::string of_other = bytes_of(index_);
    write(path_, text);
    write(index_, of_other);
    EXPECT_NE(refusal().find("found that of another trace"), std::string::npos) << refusal();
    write(index_, of_this);
    EXPECT_EQ(refusal(), "");
    write(path_, text);
    fs::last_write_time(index_, fs::last_write_time(path_) - std::chrono::seconds(1));
    EXPECT_NE(refusal().find("found an older one"), std::string::npos) << refusal();
}

TEST_F(TraceIndexTest, AByteThatChangesIsNoticedWhereItIsRead) {
    ASSERT_TRUE(draw(many_triangles(R"("fill":"scanline")"), TraceLayout::jsonl));
    const std::string text = bytes_of(path_);
    const std::string index = bytes_of(index_);
    const Trace whole = read();
    Random random(7);
    for (int i = 0; i < 60; ++i) {
        // A digit of a step, so that the step stays one.
        const auto step = static_cast<std::size_t>(random.whole(1, static_cast<int>(whole.size())));
        const std::size_t end = whole.offset_of(step) + whole.step(step).json().size();
        const std::size_t digit = text.find_last_of("0123456789", end);
        std::string changed = text;
        changed[digit] = changed[digit] == '1' ? '2' : '1';
        if (digit < whole.offset_of(step) || changed == text)
            continue;
        write(path_, changed);
        write(index_, index);
        const Trace indexed = opened();
        EXPECT_THROW(indexed.kind_of(step), StaleIndex) << step;
        EXPECT_THROW(indexed.step(step), StaleIndex) << step;

        // Nobody looks for a kind of step behind the last step that was meant.
        std::size_t before = step - 1;
        const auto is_stale = [&indexed](std::size_t n) {
            try {
                indexed.kind_of(n);
                return false;
            } catch (const StaleIndex&) {
                return true;
            }
        };
        while (before > 0 && is_stale(before))
            --before;
        EXPECT_EQ(indexed.next_of({StepKind::order}, 1, before), before + 1);
        EXPECT_THROW(indexed.next_of({StepKind::order}, 1, step), StaleIndex);
    }
}

TEST_F(TraceIndexTest, ADamagedIndexGivesNoOtherAnswer) {
    ASSERT_TRUE(draw(many_triangles(R"("fill":"scanline")"), TraceLayout::jsonl));
    const std::string index = bytes_of(index_);
    const Trace whole = read();
    Replay straight(whole, all_parts);
    straight.go_to(whole.size() - 5);
    const Question question{.pixel = {20, 20}, .most_why_not = 3};
    const Told expected = told_of(explain(whole, question).value(), 3);
    Random random(11);
    std::size_t noticed = 0;
    for (int i = 0; i < 400; ++i) {
        std::string damaged = index;
        char& byte =
            damaged[static_cast<std::size_t>(random.whole(0, static_cast<int>(index.size()) - 1))];
        byte = static_cast<char>(byte ^ (1 << random.whole(0, 7)));
        write(index_, damaged);
        try {
            const Trace indexed = opened();
            Replay jumping(indexed, all_parts);
            jumping.go_to(whole.size() - 5);
            expect_same(jumping, straight);
            EXPECT_TRUE(told_of(explain(indexed, question).value(), 3) == expected);
        } catch (const Problem&) {
            ++noticed;
        } catch (const StaleIndex&) {
            ++noticed;
        }
    }
    EXPECT_GT(noticed, 20U);
}

TEST_F(TraceIndexTest, IsNotMadeOfAForeignOrDamagedTrace) {
    ASSERT_TRUE(draw(many_triangles(R"("fill":"scanline")"), TraceLayout::jsonl));
    const std::string text = bytes_of(path_);
    fs::remove(index_);
    const auto refused = [&](const std::string& changed) {
        write(path_, changed);
        try {
            make_index();
        } catch (const Problem& problem) {
            return problem.message;
        }
        return std::string();
    };
    std::string blank = text;
    blank.insert(text.find("\n{\"step\"", text.size() / 2) + 2, " ");
    EXPECT_EQ(refused(blank), "expected a trace as rastertrace writes it, found a line that is "
                              "written otherwise");
    EXPECT_EQ(refused(text.substr(0, text.rfind("{\"end\""))),
              "expected a trace as rastertrace writes it, found damage");
    EXPECT_FALSE(fs::exists(index_));
}

} // namespace
} // namespace rastertrace
