// SPDX-License-Identifier: MIT
#include "suite_results.h"

#include "junit.h"
#include "markdown.h"
#include "option_values.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/figures/svg.h>
#include <rastertrace/trace/text/json_reader.h>
#include <rastertrace/trace/text/named_value.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <utility>

namespace rastertrace {

namespace {

using Outcome = SuiteResult::Outcome;

/// In the order of Outcome.
constexpr std::array<std::string_view, 3> outcome_names{"passed", "failed", "left out"};

/// "1 of 120 cases failed; 2 files left out"
std::string suite_summary(const SuiteResults& results) {
    const std::size_t failed = results.count(Outcome::failed);
    const std::size_t left_out = results.count(Outcome::left_out);
    std::string text = fmt::format("{} of {} failed", failed,
                                   counted(results.count(Outcome::passed) + failed, "case"));
    if (results.shard.count > 1)
        text += fmt::format(" in shard {}/{}", results.shard.number, results.shard.count);
    if (left_out > 0)
        text += fmt::format("; {} left out: no scene, trace or claims", counted(left_out, "file"));
    return text + "\n";
}

/// The lines of a result, each with blanks in front; "" if there are none.
std::string indented(const std::string& text) {
    std::string lines;
    if (text.empty())
        return lines;
    for (const std::string& line : split_at(text, '\n'))
        lines += line.empty() ? "\n" : "    " + line + "\n";
    return lines;
}

} // namespace

std::size_t SuiteResults::count(Outcome outcome) const {
    return static_cast<std::size_t>(std::ranges::count(cases, outcome, &SuiteResult::outcome));
}

SuiteResults merged(std::vector<SuiteResults> shards) {
    std::ranges::sort(shards, {}, [](const SuiteResults& one) { return one.shard.number; });
    SuiteResults all;
    std::vector<std::string> found;
    bool are_all = true;
    for (SuiteResults& one : shards) {
        are_all =
            are_all && one.shard.count == shards.size() && one.shard.number == found.size() + 1;
        found.push_back(fmt::format("{}/{}", one.shard.number, one.shard.count));
        std::ranges::move(one.cases, std::back_inserter(all.cases));
    }
    if (!are_all)
        throw problem_of("", fmt::format("suite merge: expected each shard of one suite once, "
                                         "found {}",
                                         joined(found, ", ")));
    std::ranges::sort(all.cases, {}, &SuiteResult::name);
    return all;
}

std::string result_json(const SuiteResult& result) {
    std::string text = fmt::format(R"({{"name":{},"outcome":"{}")", json_quoted(result.name),
                                   outcome_names[static_cast<std::size_t>(result.outcome)]);
    if (result.outcome == Outcome::failed)
        text += fmt::format(R"(,"message":{},"text":{})", json_quoted(result.message),
                            json_quoted(result.text));
    return text + "}";
}

SuiteResult read_result(const Source& source, const JsonValue& value) {
    const JsonReader json{source};
    const JsonValue outcome = json.member(value, "outcome");
    const auto known =
        value_named<Outcome>({outcome_names.begin(), outcome_names.end()}, outcome.text);
    if (!known)
        json.fail_expecting(outcome, "one of passed, failed, left out");
    SuiteResult result{.name = json.string_in(json.member(value, "name"), "the name of a case"),
                       .outcome = *known};
    if (*known == Outcome::failed) {
        result.message = json.member(value, "message").text;
        result.text = json.member(value, "text").text;
    }
    return result;
}

std::string suite_json(const SuiteResults& results) {
    std::string text = fmt::format(
        R"({{"suite":1,"shard":"{}/{}","passed":{},"failed":{},"left_out":{},"cases":[)",
        results.shard.number, results.shard.count, results.count(Outcome::passed),
        results.count(Outcome::failed), results.count(Outcome::left_out));
    std::string_view separator = "\n";
    for (const SuiteResult& result : results.cases) {
        text += separator;
        text += result_json(result);
        separator = ",\n";
    }
    return text + "\n]}\n";
}

SuiteResults read_suite_results(const Source& source) {
    const JsonReader json{source};
    const auto document = parse_json(source);
    if (!document)
        throw document.problem();
    const JsonValue root = document.value().root();
    if (!root.find("suite"))
        json.fail_expecting(root, "what `suite --format json` writes");
    const JsonValue shard = json.member(root, "shard");
    SuiteResults results;
    const auto read_shard = shard_named(shard.text);
    if (!read_shard)
        json.fail_expecting(shard, "a shard, like 1/2");
    results.shard = *read_shard;
    for (const JsonValue& one : json.array_in(json.member(root, "cases"), "a list of cases"))
        results.cases.push_back(read_result(source, one));
    return results;
}

std::optional<Shard> shard_named(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == text.npos)
        return std::nullopt;
    const auto number = whole_number<std::size_t>(text.substr(0, slash));
    const auto count = whole_number<std::size_t>(text.substr(slash + 1));
    if (!number || !count || *number < 1 || *number > *count)
        return std::nullopt;
    return Shard{*number, *count};
}

std::string suite_text(const SuiteResults& results) {
    std::string text;
    for (const SuiteResult& result : results.cases)
        if (result.outcome == Outcome::failed)
            text += fmt::format("{}: {}\n{}\n", result.name, result.message, indented(result.text));
    return text + suite_summary(results);
}

std::string suite_markdown(const SuiteResults& results) {
    std::string text = "### " + suite_summary(results);
    std::string details;
    std::string_view head = "\n| case | |\n|---|---|\n";
    for (const SuiteResult& result : results.cases) {
        if (result.outcome != Outcome::failed)
            continue;
        text += fmt::format("{}| {} | {} |\n", head, in_markdown(result.name),
                            in_markdown(result.message));
        if (!result.text.empty())
            details += fmt::format("\n<details><summary>{}</summary>\n\n{}\n</details>\n",
                                   escaped(result.name), fenced(result.text + "\n"));
        head = "";
    }
    return text + details;
}

std::string suite_junit(const SuiteResults& results) {
    std::string cases;
    for (const SuiteResult& result : results.cases) {
        const std::filesystem::path path = result.name;
        const std::string folder = path.parent_path().generic_string();
        cases +=
            fmt::format(R"(    <testcase classname="{}" name="{}")",
                        escaped(folder.empty() ? "." : folder), escaped(path.filename().string()));
        cases += result.outcome == Outcome::passed ? "/>\n"
                 : result.outcome == Outcome::left_out
                     ? "><skipped/></testcase>\n"
                     : fmt::format(">\n      <failure message=\"{}\">{}</failure>\n"
                                   "    </testcase>\n",
                                   escaped(result.message), escaped_lines(result.text));
    }
    return junit_document(
        fmt::format("  <testsuite name=\"rastertrace suite\" tests=\"{}\" failures=\"{}\" "
                    "errors=\"0\" skipped=\"{}\">\n{}  </testsuite>\n",
                    results.cases.size(), results.count(Outcome::failed),
                    results.count(Outcome::left_out), cases));
}

} // namespace rastertrace
