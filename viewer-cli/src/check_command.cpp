// SPDX-License-Identifier: MIT
// `rastertrace check`: claims held against a scene or a trace.

#include "check_report.h"
#include "command.h"
#include "commands.h"
#include "load.h"
#include "option_values.h"
#include "shared_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// Checks files of claims, one after the other.
class ClaimsChecker {
public:
    explicit ClaimsChecker(const CheckCommand& command)
        : options_{.method = command.method, .limits = command.input, .frames = command.frames} {}

    /// All claims are about this scene or trace, whatever scene they name.
    void hold_against(Source source) { given_.emplace(truth_in(std::move(source), options_)); }

    /// What the claims were held against is damaged, or sound.
    ExitStatus report() const { return given_ ? report_damage(given_->decided()) : exit_fine; }

    /// Throws a Problem if the file is none of claims, or its scene cannot be drawn.
    CheckedFile check(const std::string& path) {
        return check(load_scene_trace_or_claims(path, options_.limits));
    }
    CheckedFile check(Source source) {
        CheckedFile file{.name = source.name};
        file.claims = value_or_throw(read_claims(std::move(source)));
        if (file.claims.claims.empty())
            throw problem_of(file.name, "expected claims, found none",
                             "rastertrace sheet SCENE writes a sheet to fill in");
        file.checked = rastertrace::check(truth_for(file.claims), file.claims);
        return file;
    }

private:
    const Truth& truth_for(const Claims& claims) {
        if (given_)
            return *given_;
        const std::string path = path_of_scene(claims);
        const auto known = by_path_.find(path);
        if (known != by_path_.end())
            return known->second;
        Source scene = load_scene_of_claims(path, options_.limits);
        return by_path_.emplace(path, truth_in(std::move(scene), options_)).first->second;
    }

    SceneOptions options_;
    std::optional<Truth> given_;
    std::map<std::string, Truth> by_path_; ///< of the scenes that claims have named
};

/// Checks each file of a pile. One that cannot be read is told, and the others go on.
std::vector<CheckedFile> check_pile(ClaimsChecker& checker, std::optional<Source> first,
                                    const std::vector<std::string>& paths) {
    std::vector<CheckedFile> files;
    const auto add = [&files](const std::string& name, auto&& check_file) {
        try {
            files.push_back(check_file());
        } catch (const Problem& problem) {
            if (problem.cause == Problem::Cause::system)
                throw;
            print_error(fmt::format("rastertrace: {}\n", to_text(problem)));
            files.push_back({.name = name, .problem = problem});
        }
    };
    if (first) {
        const std::string name = first->name;
        add(name, [&] { return checker.check(std::move(*first)); });
    }
    for (const std::string& path : paths)
        add(path, [&] { return checker.check(path); });
    return files;
}

std::string report_of(const CheckCommand& command, const std::vector<CheckedFile>& files) {
    switch (command.format) {
    case CheckFormat::json:
        return check_json(files, command.told);
    case CheckFormat::junit:
        return check_junit(files, command.told);
    case CheckFormat::csv:
        return check_csv(files, command.told);
    case CheckFormat::text:
        break;
    }
    return check_text(files, command.told);
}

ExitStatus status_of(const std::vector<CheckedFile>& files) {
    if (std::any_of(files.begin(), files.end(),
                    [](const CheckedFile& file) { return file.problem.has_value(); }))
        return exit_bad_input;
    return std::any_of(
               files.begin(), files.end(),
               [](const CheckedFile& file) { return file.checked.wrong + file.checked.follow > 0; })
               ? exit_difference
               : exit_fine;
}

} // namespace

int run(const CheckCommand& command) {
    Source first = load_scene_trace_or_claims(command.files.front(), command.input);

    // The scene comes first, or the claims say which one it is.
    ClaimsChecker checker(command);
    std::vector<std::string> rest(command.files.begin() + 1, command.files.end());
    const bool is_scene_named = is_claims(first);
    const std::string first_name = first.name;
    std::optional<Source> claims;
    if (is_scene_named)
        claims = std::move(first);
    else
        checker.hold_against(std::move(first)); // or tells why it is no scene, as of broken JSON
    if (!is_scene_named && rest.empty())
        throw problem_of(first_name, "expected claims behind the scene, found none",
                         "rastertrace sheet SCENE writes a sheet to fill in");

    std::vector<CheckedFile> files;
    if (command.files.size() == (is_scene_named ? 1U : 2U))
        files.push_back(claims ? checker.check(std::move(*claims)) : checker.check(rest.front()));
    else
        files = check_pile(checker, std::move(claims), rest);
    print(report_of(command, files));
    const ExitStatus damage = checker.report();
    return damage == exit_fine ? status_of(files) : damage;
}

namespace {

class CheckCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {
            "check", "Say which line of a worked example is wrong, and why",
            "rastertrace check examples/claims/t0-rows.claims\n\n"
            "Claims are lines like these, in a file; docs/check.md has all of them:\n"
            "y=2: -1/4, 25/8 -> -1..3     (3,2): on     A screen: 2, 5     normal ABC: 0, 0, -4\n"
            "Exit status 1: a claim is wrong."};
    }

    void add_to(OptionList& options) override {
        options
            .option("file", command_.files,
                    "A scene or a trace, then files of claims; or only claims that name their "
                    "scenes; - for standard input",
                    "[SCENE] CLAIMS")
            .required();
        options.option("--format", format_, "text, json, junit, or csv: one line for each file",
                       "NAME");
        options.flag("--json", is_json_, "Short for --format json");
        OptionList told = options.one_of("Answers", "How much is given away");
        told.flag("--answers", has_answers_,
                  "The right numbers, their working, likely slips: the default");
        told.option("--hint", hint_,
                    "Where a claim is wrong and by which rule; 2: the formula, too", "1|2");
        told.flag("--no-answers", has_no_answers_,
                  "Only which claims are right and which are wrong");
        options.language();
        drawing_.add_to(options, Holds::steps);
    }

    std::vector<const char*> completed(std::vector<const char*> words) const override {
        for (std::size_t i = 0; i < words.size(); ++i) {
            const std::string_view value = i + 1 < words.size() ? words[i + 1] : "";
            if (words[i] == std::string_view("--hint") && value != "1" && value != "2")
                words.insert(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, "1");
        }
        return words;
    }

    void read() override {
        read_check_format();
        const std::vector<std::string_view> levels{"1", "2"};
        if (has_no_answers_)
            command_.told = CheckTold::verdicts;
        else if (hint_)
            command_.told =
                value_of<int>("--hint", *hint_, levels) == 1 ? CheckTold::formula : CheckTold::rule;
        drawing_.read_into(command_);
    }

    int run() override { return rastertrace::run(command_); }

private:
    void read_check_format() {
        if (is_json_ && !format_.empty())
            refuse_value("--json", "no --format beside it", format_);
        if (is_json_)
            format_ = "json";
        const std::vector<std::string_view> names{"text", "json", "junit", "csv"};
        command_.format =
            value_of<CheckFormat>("--format", format_, names).value_or(CheckFormat::text);
    }

    CheckCommand command_;
    std::string format_;
    bool is_json_ = false;
    bool has_answers_ = false;
    bool has_no_answers_ = false;
    std::optional<std::string> hint_;
    DrawingOptions drawing_;
};

} // namespace

std::unique_ptr<Command> check_command() {
    return std::make_unique<CheckCommandLine>();
}

} // namespace rastertrace
