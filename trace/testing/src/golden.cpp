// SPDX-License-Identifier: MIT
// A trace against a stored one, and the stored one written anew.

#include "question.h"

#include <rastertrace/trace/diff.h>
#include <rastertrace/trace/input.h>
#include <rastertrace/trace/output.h>
#include <rastertrace/trace/step_kind.h>
#include <rastertrace/trace/text.h>
#include <rastertrace/trace/trace_text.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace::matchers {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* renew_variable = "RASTERTRACE_RENEW";

bool is_renewing() {
    const char* const value = std::getenv(renew_variable);
    return value != nullptr && std::string_view(value) != "" && std::string_view(value) != "0";
}

/// The command that runs the current test again, and renews what it compares with.
std::string renewing_command() {
#ifdef __GLIBC__
    std::string command = fmt::format("{}=1 {}", renew_variable, program_invocation_name);
#else
    std::string command = fmt::format("{}=1 THIS_PROGRAM", renew_variable);
#endif
    if (const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info())
        command += fmt::format(" --gtest_filter={}.{}", test->test_suite_name(), test->name());
    return command;
}

/// Throws a Problem for a kind that neither the format nor the trace knows.
void expect_kinds(const Trace& trace, const std::vector<std::string>& kinds) {
    for (const std::string& kind : kinds) {
        const auto known = step_kind_named(kind);
        bool is_there = known.has_value();
        for (std::size_t n = 1; n <= trace.size() && !is_there; ++n)
            is_there = trace.step(n).kind_name() == kind;
        if (!is_there)
            throw problem_of("",
                             fmt::format("expected kinds of step ({}), found {}",
                                         joined(step_kind_names(), ", "), printable(kind)),
                             did_you_mean(kind, step_kind_names()));
        if (known && trace.lacks(*known))
            throw problem_of("", fmt::format("{} steps were left out of the trace", kind));
    }
}

/// A trace as a golden: the steps of some kinds, or all, one a line.
std::string golden_text(const TestedTrace& tested, const std::vector<std::string>& kinds,
                        bool is_document) {
    const Trace& trace = trace_or_throw(tested);
    Json header = Json::parse(TraceText(Source{tested.name, tested.text}).header_json());
    header.erase("steps"); // of a document
    if (!kinds.empty())
        header["only"] = kinds;
    std::string text = header.dump();
    if (is_document)
        text.replace(text.size() - 1, 1, R"(,"steps":[)");

    std::map<std::size_t, std::uint64_t> known; // in the order of step_kind.h
    std::map<std::string, std::uint64_t> foreign;
    std::uint64_t steps = 0;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const StepView step = trace.step(n);
        const std::string kind = step.kind_name();
        if (!kinds.empty() && std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
            continue;
        text += is_document && steps > 0 ? ",\n" : "\n";
        text += step.json().find('\n') == std::string_view::npos ? std::string(step.json())
                                                                 : Json::parse(step.json()).dump();
        ++steps;
        if (const auto number = trace.kind_of(n))
            ++known[static_cast<std::size_t>(*number)];
        else
            ++foreign[kind];
    }

    Json count = Json::object();
    for (const auto& [kind, number] : known)
        count[std::string(name_of(static_cast<StepKind>(kind)))] = number;
    for (const auto& [kind, number] : foreign)
        count[kind] = number;
    Json end{{"steps", steps}, {"count", std::move(count)}};
    if (trace.end && trace.end->pixels)
        end["pixels"] = *trace.end->pixels;
    if (trace.end && !trace.end->frame.empty())
        end["frame"] = trace.end->frame;
    const std::string record = R"("end":)" + end.dump();
    return text + (is_document ? "\n],\n" + record + "}\n" : "\n{" + record + "}\n");
}

/// Writes the golden, whole and only if it changes. A file that is no trace is left as it is.
void renew(const std::string& path, const std::string& text) {
    std::error_code error;
    if (std::filesystem::exists(path, error)) {
        const Result<Source> older = read_source(path, InputLimits{});
        if (!older)
            throw older.problem();
        if (older.value().text == text)
            return;
        if (!is_trace(older.value()))
            throw problem_of(path, "expected a golden to renew, found a file that is no trace");
    }
    FileOutput output(path);
    output.write(text);
    output.commit();
    std::cout << "[ RENEWED  ] " << printable(path) << std::endl;
}

TraceText golden_in(const std::string& path) {
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        throw problem_of(path, "expected a golden, found no such file",
                         "this makes it: " + renewing_command());
    auto opened = open_trace_text(path, InputLimits{});
    if (auto* const text = std::get_if<TraceText>(&opened))
        return std::move(*text);
    Source source = std::get<Source>(std::move(opened));
    if (!is_trace(source))
        throw problem_of(path, "expected a golden, found a file that is no trace");
    return TraceText(std::move(source));
}

/// Throws a Problem if kinds that are to be compared were not stored.
void expect_kinds_stored(const TraceText& golden, const std::vector<std::string>& kinds) {
    const auto& only = golden.header().left_out.only;
    if (!only)
        return;
    const auto is_stored = [&only](const std::string& kind) {
        return std::find(only->begin(), only->end(), kind) != only->end();
    };
    if (!std::all_of(kinds.begin(), kinds.end(), is_stored))
        throw problem_of(golden.name(),
                         fmt::format("expected a golden with steps of {}, found one with {}",
                                     printable(joined(kinds, ", ")),
                                     printable(joined(*only, ", "))),
                         "this makes it: " + renewing_command());
}

} // namespace

TraceMatcher MatchesTrace(const std::string& golden, GoldenRules rules, Caller caller) {
    return matcher_of(
        {"matches the trace " + golden, "does not match the trace " + golden}, caller,
        [golden, rules = std::move(rules)](const TestedTrace& tested) -> Verdict {
            expect_kinds(trace_or_throw(tested), rules.kinds);
            DiffOptions options{.ignored = rules.ignored, .only = rules.kinds};
            if (!rules.kinds.empty())
                options.ignored.emplace_back("header");
            for (const std::string& tolerance : rules.tolerances)
                options.tolerances.push_back(parse_tolerance(tolerance));
            if (is_renewing())
                renew(golden, golden_text(tested, rules.kinds, !golden.ends_with(".jsonl")));

            const TraceText stored = golden_in(golden);
            expect_kinds_stored(stored, rules.kinds);
            const TraceDiff found =
                diff(stored, TraceText(Source{tested.name, tested.text}), options);
            if (!found.damage.empty())
                throw found.damage.front();
            if (found.is_same)
                return {true, "nothing differs"};
            return {false, "which differs:\n" + diff_text(found) +
                               "\nIf it should be as it is now, renew the golden:\n  " +
                               renewing_command()};
        });
}

} // namespace rastertrace::matchers
