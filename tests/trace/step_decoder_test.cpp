// SPDX-License-Identifier: MIT
#include "effort.h"
#include "random_scene.h"
#include "traces.h"

#include <rastertrace/trace/record/step_decoder.h>
#include <rastertrace/trace/record/trace.h>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rastertrace {
namespace {

/// The lines of a trace's steps.
std::vector<std::string> step_lines(const std::string& trace) {
    std::vector<std::string> lines;
    for (std::size_t begin = trace.find('\n') + 1; begin < trace.size();) {
        const std::size_t end = trace.find('\n', begin);
        lines.push_back(trace.substr(begin, end - begin));
        begin = end + 1;
    }
    lines.pop_back(); // the end record
    return lines;
}

/// Steps of every kind: of random scenes, and of one with lines, colors and names of every length.
const std::vector<std::string>& lines() {
    static const std::vector<std::string> all = [] {
        std::vector<std::string> found;
        for (std::uint64_t seed = 0; seed < 200; ++seed)
            if (const auto read = read_scene({"scene.json", RandomScene(seed).text()}))
                for (std::string& line :
                     step_lines(trace_text(read.value().scene, {TraceLayout::jsonl, {}})))
                    if (found.size() < 20'000 || !line.starts_with(R"({"step":"pixel")"))
                        found.push_back(std::move(line));
        return found;
    }();
    return all;
}

/// What is in the trace for a field, and what the decoded step has for it.
void expect_alike(const Index& value, const nlohmann::json& json) {
    RC_ASSERT(json.is_number_integer());
    RC_ASSERT(json.get<Index>() == value);
}
void expect_alike(const std::optional<Index>& value, const nlohmann::json& json) {
    RC_ASSERT(value.has_value());
    expect_alike(*value, json);
}
template <typename Value> void expect_alike(const Value& value, const nlohmann::json& json) {
    RC_ASSERT(nlohmann::json::parse(value.json()) == json);
}

template <typename Step, typename... Rows>
void expect_fields(const Step& step, const nlohmann::json& json, FieldTable<Rows...> /*table*/) {
    std::size_t found = 1; // "step"
    const auto expect_field = [&](auto row) {
        if (json.contains(row.name)) {
            ++found;
            expect_alike(row.in(step), json[std::string(row.name)]);
        } else {
            RC_ASSERT(row.need != FieldNeed::required);
        }
    };
    (expect_field(Rows{}), ...);
    RC_ASSERT(found == json.size());
}

/// What a trace with one step says of it: its kind, and all that is wrong.
std::string judged(const std::string& line) {
    const std::string header = R"({"rastertrace":1,"canvas":{"width":64,"height":64}})";
    auto read = read_trace_to_tell({"t", header + "\n" + line + "\n{\"end\":{}}\n", {}});
    if (!read)
        return read.problem().message;
    const Trace& trace = read.value();
    std::string text = trace.size() == 1 && trace.kind_of(1)
                           ? std::string(name_of(*trace.kind_of(1)))
                           : std::to_string(trace.size());
    for (const Problem& problem : trace.damage)
        text += "; " + problem.message;
    if (trace.size() == 1)
        for (const Problem& problem : trace.faults_in_step(1))
            text += "; " + problem.message;
    return text + "; " + std::to_string(trace.not_finite.count);
}

/// A line with a few bytes that are others, that are gone, or that stand there twice.
std::string mutated_line() {
    std::string line = *rc::gen::elementOf(lines());
    const int changes = *rc::gen::inRange(0, 4);
    for (int i = 0; i < changes && !line.empty(); ++i) {
        const auto at = *rc::gen::inRange<std::size_t>(0, line.size());
        const auto size = *rc::gen::inRange<std::size_t>(1, 5);
        switch (*rc::gen::inRange(0, 4)) {
        case 0:
            line[at] = *rc::gen::elementOf(std::string("0123456789-+.eE/\"\\{}[]:,ntf# "));
            break;
        case 1:
            line[at] = *rc::gen::arbitrary<char>();
            break;
        case 2:
            line.erase(at, size);
            break;
        default:
            line.insert(at, line.substr(line.size() - at, size));
            break;
        }
    }
    std::erase(line, '\n');
    return line;
}

RC_GTEST_PROP(StepDecoder, CountsDigitsEightAtOnceAsOneByOne, ()) {
    const auto text = *rc::gen::container<std::string>(
        rc::gen::weightedOneOf<char>({{30, rc::gen::inRange('0', static_cast<char>('9' + 1))},
                                      {1, rc::gen::arbitrary<char>()}}));
    RC_ASSERT(count_digits(text) == count_digits_one_by_one(text));
}

// Nearly every step is decoded by its table: all that are written in ASCII without an escape.
TEST(StepDecoder, TakesEveryStepThatIsWrittenPlainly) {
    std::array<std::size_t, step_kinds> taken{};
    for (const std::string& line : lines()) {
        std::string_view rest = line;
        AnyStep step;
        const bool is_plain = line.find('\\') == std::string::npos &&
                              line.find("e+") == std::string::npos &&
                              std::all_of(line.begin(), line.end(), [](char c) { return c > 0; });
        ASSERT_TRUE(!is_plain || take_step(rest, step)) << line;
        ASSERT_TRUE(!is_plain || rest.empty()) << line;
        taken[step.index()] += is_plain ? 1 : 0;
    }
    for (std::size_t kind = 0; kind < step_kinds; ++kind)
        EXPECT_GT(taken[kind], 0u) << step_names[kind];
}

RC_GTEST_PROP(StepDecoder, FindsWhatAReaderOfJsonFinds, ()) {
    const std::string line = mutated_line();
    std::string_view rest = line;
    AnyStep step;
    const bool is_taken = take_step(rest, step) && rest.empty();
    RC_CLASSIFY(is_taken);
    if (is_taken) {
        const auto json = nlohmann::json::parse(line, nullptr, false);
        RC_ASSERT(json.is_object());
        RC_ASSERT(json["step"] == step_names[step.index()]);
        std::visit(
            [&json]<typename Step>(const Step& decoded) {
                expect_fields(decoded, json, typename Step::Fields{});
            },
            step);
    }
    // A blank in front of a line makes the thorough reader read it.
    RC_ASSERT(judged(line) == judged(" " + line));
}

} // namespace
} // namespace rastertrace
