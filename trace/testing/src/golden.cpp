// SPDX-License-Identifier: MIT
// A trace against a stored one, and the stored one written anew.

#include "question.h"

#include <rastertrace/trace/compare/diff.h>
#include <rastertrace/trace/compare/other_goldens.h>
#include <rastertrace/trace/record/step_kind.h>
#include <rastertrace/trace/record/trace.h>
#include <rastertrace/trace/tell/excerpt.h>
#include <rastertrace/trace/text/input.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/process_files.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace rastertrace::matchers {

namespace {

constexpr const char* renew_variable = "RASTERTRACE_RENEW";

bool is_renewing() {
    const char* const value = std::getenv(renew_variable);
    return value != nullptr && *value != '\0' && std::string_view(value) != "0";
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

/// A trace as it is stored: the steps of some kinds, or all.
std::string golden_text(const TestedTrace& tested, const std::vector<std::string>& kinds,
                        const std::string& path) {
    std::string text;
    StringOutput output(text);
    write_excerpt(trace_or_throw(tested), kinds,
                  path.ends_with(".jsonl") ? TraceLayout::jsonl : TraceLayout::json, output);
    return text;
}

/// Writes the golden, whole and only if it changes. A file that is no trace is left as it is.
void renew(const std::string& path, const std::string& text) {
    std::error_code error;
    if (std::filesystem::exists(path, error)) {
        const ReadToReplace to_be_renewed;
        const Result<Source> older = read_source(path, InputLimits{});
        if (!older)
            throw older.problem();
        if (older.value().text == text)
            return;
        if (!is_trace(older.value()))
            throw problem_of(path, "expected a golden to renew, found a file that is no trace");
    }
    write_file(path, text);
    std::cout << "[ RENEWED  ] " << printable(path) << std::endl;
}

Trace golden_in(const std::string& path) {
    const ReadToReplace to_be_renewed;
    std::error_code error;
    if (!std::filesystem::exists(path, error))
        throw problem_of(path, "expected a golden, found no such file",
                         "this makes it: " + renewing_command());
    Result<Source> source = read_source(path, InputLimits{});
    if (!source)
        throw source.problem();
    if (!is_trace(source.value()))
        throw problem_of(path, "expected a golden, found a file that is no trace");
    Result<Trace> golden = read_trace(std::move(source.value()));
    if (!golden)
        throw golden.problem();
    return std::move(golden.value());
}

/// Throws a Problem if kinds that are to be compared were not stored.
void expect_kinds_stored(const Trace& golden, const std::vector<std::string>& kinds) {
    const auto& only = golden.left_out.only;
    if (!only)
        return;
    const auto is_stored = [&only](const std::string& kind) {
        return std::find(only->begin(), only->end(), kind) != only->end();
    };
    if (!std::all_of(kinds.begin(), kinds.end(), is_stored))
        throw problem_of(golden.source().name,
                         fmt::format("expected a golden with steps of {}, found one with {}",
                                     printable(joined(kinds, ", ")),
                                     printable(joined(*only, ", "))),
                         "this makes it: " + renewing_command());
}

} // namespace

TraceMatcher MatchesTrace(const std::string& golden, GoldenRules rules, Caller caller) {
    return matcher_of({"matches the trace " + golden, "does not match the trace " + golden}, caller,
                      [golden, rules = std::move(rules)](const TestedTrace& tested) -> Verdict {
                          expect_kinds(trace_or_throw(tested), rules.kinds);
                          DiffOptions options{.ignored = rules.ignored, .only = rules.kinds};
                          if (!rules.kinds.empty())
                              options.ignored.emplace_back("header");
                          for (const std::string& tolerance : rules.tolerances)
                              options.tolerances.push_back(parse_tolerance(tolerance));
                          if (is_renewing())
                              renew(golden, golden_text(tested, rules.kinds, golden));

                          const Trace stored = golden_in(golden);
                          expect_kinds_stored(stored, rules.kinds);
                          const Trace& now = trace_or_throw(tested);
                          const TraceDiff found = diff(stored, now, options);
                          if (!found.damage.empty())
                              throw found.damage.front();
                          if (found.is_same)
                              return {true, "nothing differs"};
                          for (const std::string& other : other_goldens(golden))
                              if (diff(golden_in(other), now, options).is_same)
                                  return {true, "nothing differs from " + other};
                          return {false,
                                  "which differs:\n" + diff_text(found) +
                                      "\nIf it should be as it is now, renew the golden:\n  " +
                                      renewing_command()};
                      });
}

} // namespace rastertrace::matchers
