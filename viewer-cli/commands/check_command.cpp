// SPDX-License-Identifier: MIT
// `rastertrace check`: claims held against a scene or a trace.

#include "app/command.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/shared_options.h"
#include "commands/check_report.h"
#include "commands/claims_checker.h"

#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

struct CheckCommand {
    std::vector<std::string>
        files; ///< a scene or a trace, then claims; or claims that name their scenes
    bool json = false;
    CheckTold told = CheckTold::answers;
    MethodOverrides method;
    InputLimits input;
    FrameChoice frames;
};

SceneOptions options_of(const CheckCommand& command) {
    return {.method = command.method, .limits = command.input, .frames = command.frames};
}

/// Checks each file of a pile. One that cannot be read is told, and the others go on.
std::vector<CheckedFile> check_pile(const CheckCommand& command, ClaimsChecker& checker,
                                    std::optional<Source> first,
                                    const std::vector<std::string>& paths) {
    std::vector<CheckedFile> files;
    const auto add = [&](const std::string& name, auto&& check_file) {
        try {
            files.push_back(check_file());
            if (!command.json) { // a line needs only what is counted
                files.back().claims = {};
                files.back().checked.claims.clear();
            }
        } catch (const Problem& problem) {
            if (problem.cause == Problem::Cause::system)
                throw;
            print_error(problem);
            files.push_back({.name = name, .problem = problem});
        }
    };
    if (first) {
        const std::string name = first->name;
        add(name, [&] { return checker.check(std::move(*first)); });
    }
    for (const std::string& path : paths)
        add(path, [&] { return checker.check(load_scene_trace_or_claims(path, command.input)); });
    return files;
}

ExitStatus status_of(const std::vector<CheckedFile>& files) {
    std::size_t problems = 0;
    std::size_t wrong = 0;
    for (const CheckedFile& file : files) {
        problems += file.problem ? 1 : 0;
        wrong += file.checked.wrong + file.checked.follow;
    }
    return problems > 0 ? exit_bad_input : wrong > 0 ? exit_difference : exit_fine;
}

/// Checks the claims in `first`, if there are any, and in the files; prints what is found.
ExitStatus tell(const CheckCommand& command, ClaimsChecker& checker, std::optional<Source> first,
                const std::vector<std::string>& paths) {
    std::vector<CheckedFile> files;
    if (paths.size() + (first ? 1U : 0U) == 1)
        files.push_back(checker.check(
            first ? *std::move(first) : load_scene_trace_or_claims(paths.front(), command.input)));
    else
        files = check_pile(command, checker, std::move(first), paths);
    print(command.json ? check_json(files, command.told).line() : check_text(files, command.told));
    const ExitStatus damage = checker.report();
    return damage == exit_fine ? status_of(files) : damage;
}

} // namespace

int run(const CheckCommand& command) {
    ClaimsChecker checker(options_of(command), [](const Problem& remark) { print_error(remark); });
    Source first = load_scene_trace_or_claims(command.files.front(), command.input);

    // The scene comes first, or the claims say which one it is.
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

    return tell(command, checker, std::move(claims), rest);
}

namespace {

class CheckCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {"check", "Say which line of a worked example is wrong, and why",
                "rastertrace check examples/claims/t0-rows.claims\n\n"
                "Claims are lines like these, in a file; check.md of the documentation has all of "
                "them:\n"
                "  y=2: -1/4, 25/8 -> -1..3   (3,2): on\n"
                "  A screen: 2, 5   normal ABC: 0, 0, -4\n"
                "Exit status 1: a claim is wrong."};
    }

    void add_to(OptionList& options) override {
        options
            .option(
                "file", command_.files,
                "A scene or a trace, then files of claims, of which several get a line each; or "
                "only claims that name their scenes; - for standard input",
                "[SCENE] CLAIMS")
            .required();
        options.option("--format", format_, "How to print", "NAME").values({"text", "json"});
        options.flag("--json", command_.json, "Short for --format json");
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
        command_.json = is_json(format_, command_.json);
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
    CheckCommand command_;
    std::string format_;
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
