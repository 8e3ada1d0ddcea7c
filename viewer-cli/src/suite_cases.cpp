// SPDX-License-Identifier: MIT
#include "suite_cases.h"

#include "check_report.h"
#include "claims_checker.h"
#include "diff_report.h"
#include "files_below.h"
#include "load.h"

#include <rastertrace/core/draw/draw.h>
#include <rastertrace/trace/check/claims.h>
#include <rastertrace/trace/compare/diff_rules.h>
#include <rastertrace/trace/record/write_trace.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <exception>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

using Outcome = SuiteResult::Outcome;

constexpr std::string_view golden_ending = ".golden.jsonl";
constexpr std::string_view scene_ending = ".json";
constexpr std::array<std::string_view, 2> trace_endings{".trace.json", ".jsonl"};
constexpr std::string_view claims_ending = ".claims";

/// A path without an ending; nothing if it has another one.
std::optional<std::string> without(const std::string& path, std::string_view ending) {
    if (!path.ends_with(ending))
        return std::nullopt;
    return path.substr(0, path.size() - ending.size());
}

/// A path without its ending and the word in front of it, NAME of NAME.mine; the path itself if it has no such word.
std::string without_word(const std::string& path) {
    return std::filesystem::path(path).replace_extension().generic_string();
}

/// Finds what stands beside a file in a list of files, which is sorted.
class Neighbors {
public:
    Neighbors(const std::string& folder, const std::vector<std::string>& names)
        : folder_(folder), names_(names) {}

    /// The case that a file is; nothing if it is none.
    std::optional<SuiteCase> case_of(const std::string& name) const {
        SuiteCase one{.name = name, .path = path_of(name)};
        const auto golden_of = without(name, golden_ending);
        if (golden_of && (has(*golden_of + ".json") || has(*golden_of + ".jsonl") ||
                          has(without_word(*golden_of) + std::string(golden_ending))))
            return std::nullopt; // it is what another file is compared with
        if (std::filesystem::path(name).filename() == rules_name || golden_of_new_one(name))
            return std::nullopt;
        for (const std::string_view ending : trace_endings)
            if (const auto stem = without(name, ending); stem && !one.is_trace) {
                one.is_trace = true;
                for (const std::string& of : {*stem, without_word(*stem)}) {
                    choose(one.golden, of + std::string(golden_ending), one);
                    choose(one.scene, of + std::string(scene_ending), one);
                }
            }
        const auto stem = without(name, scene_ending);
        if (stem && !one.is_trace)
            choose(one.golden, *stem + std::string(golden_ending), one);
        if (!one.is_trace && !stem && !one.has_claims())
            return std::nullopt;
        one.files.push_back(one.path);
        one.files.push_back((std::filesystem::path(one.path).parent_path() / rules_name).string());
        return one;
    }

private:
    std::string path_of(const std::string& name) const {
        return (std::filesystem::path(folder_) / name).string();
    }
    bool has(const std::string& name) const { return std::ranges::binary_search(names_, name); }

    /// Takes a file, if it is there and none is taken yet.
    void choose(std::string& path, const std::string& name, SuiteCase& one) const {
        if (!path.empty() || name == one.name || !has(name))
            return;
        path = path_of(name);
        one.files.push_back(path);
        if (name.ends_with(golden_ending))
            std::ranges::move(other_goldens(path), std::back_inserter(one.files));
    }

    const std::string& folder_;
    const std::vector<std::string>& names_;
};

SuiteResult failed(std::string message, std::string text) {
    text.resize(text.find_last_not_of('\n') + 1);
    return {.outcome = Outcome::failed, .message = std::move(message), .text = std::move(text)};
}

SuiteResult failed(const Problem& problem) {
    const std::string text = to_text(problem);
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    return failed(text.substr(0, text.find('\n')), text.substr(end + 1));
}

/// Compares a file with what it should be. What another program wrote tells what it likes to, in any order, as for
/// `fuzz`.
SuiteResult compared_with(const std::string& expected, const SuiteCase& one,
                          const SuiteRules& rules) {
    DiffCommand command;
    command.files = {expected, one.path};
    command.options = rules.comparison;
    command.is_quiet = true;
    if (one.is_trace) {
        command.options.compares_common = true;
        command.options.compares_order = false;
        command.options.ignored.insert(command.options.ignored.end(), {"header", "end"});
    }
    if (!one.is_trace || expected == one.scene)
        command.method = rules.method;
    const TraceDiff found = compared(command);
    if (!found.damage.empty())
        return failed(found.damage.front());
    return found.is_same ? SuiteResult{}
                         : failed(diff_summary(found), without_kinds(diff_text(found)));
}

SuiteResult checked(Source claims) {
    ClaimsChecker checker({.is_quiet = true}, [](const Problem&) {});
    const CheckedFile file = checker.check(std::move(claims));
    return file.checked.wrong + file.checked.follow == 0
               ? SuiteResult{}
               : failed(counts_text(file.checked), check_text({file}, CheckTold::answers));
}

/// What the program makes of a scene, in the place of our drawing.
SuiteResult driven(const SuiteCase& one, const SuiteRules& rules, const PlannedScene& planned,
                   const DiffOptions& comparison) {
    Source expected = one.golden.empty() ? written_trace(planned.scene, planned.plan, one.path)
                                         : value_or_throw(read_named_file(one.golden, {}));
    const std::string text(expected.view());
    if (const Trace golden = value_or_throw(read_trace(std::move(expected)));
        !golden.damage.empty())
        return failed(golden.damage.front());
    const auto finding = rules.program->difference_in(one.path, text, comparison);
    return finding ? failed(std::string(words_of(finding->kind)) + ": " + finding->first,
                            without_kinds(finding->text))
                   : SuiteResult{};
}

/// The case of a file that is a scene.
SuiteResult drawn(const SuiteCase& one, const SuiteRules& rules, const Source& scene) {
    if (!one.golden.empty() && rules.program == nullptr)
        return compared_with(one.golden, one, rules);
    const auto beside = rules_beside(one.path, {});
    MethodOverrides method = beside ? beside->method : MethodOverrides{};
    method.insert(method.end(), rules.method.begin(), rules.method.end());
    const PlannedScene planned = value_or_throw(read_scene(scene, method));
    if (rules.program != nullptr)
        return driven(one, rules, planned, beside ? beside->options : DiffOptions{});
    draw(planned.scene, planned.plan);
    return {};
}

SuiteResult found_in(const SuiteCase& one, const SuiteRules& rules) {
    if (one.is_trace)
        return compared_with(!one.golden.empty()  ? one.golden
                             : !one.scene.empty() ? one.scene
                                                  : one.path,
                             one, rules);
    Source source = value_or_throw(read_named_file(one.path, {}));
    if (is_trace(source)) {
        SuiteCase trace = one;
        trace.is_trace = true;
        return found_in(trace, rules);
    }
    if (is_claims(source))
        return checked(std::move(source));
    if (!is_scene(source))
        return {.outcome = Outcome::left_out};
    return drawn(one, rules, source);
}

} // namespace

bool SuiteCase::has_claims() const {
    return name.ends_with(claims_ending);
}

std::vector<SuiteCase> cases_below(const std::string& folder) {
    const std::vector<std::string> names = files_below(folder, "cases");
    const Neighbors neighbors(folder, names);
    std::vector<SuiteCase> cases;
    for (const std::string& name : names)
        if (auto one = neighbors.case_of(name))
            cases.push_back(*std::move(one));
    if (cases.empty())
        throw problem_of(folder, "expected scenes, traces or claims, found none",
                         "files that end in .json, .jsonl or .claims");
    return cases;
}

SuiteResult result_of(const SuiteCase& one, const SuiteRules& rules) {
    SuiteResult result;
    try {
        result = found_in(one, rules);
    } catch (const Problem& problem) {
        if (problem.cause == Problem::Cause::system)
            throw;
        result = failed(problem);
    } catch (const std::exception& failure) {
        result = failed(printable(failure.what()), "");
    }
    result.name = printable(one.name);
    return result;
}

} // namespace rastertrace
