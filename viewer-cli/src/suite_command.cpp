// SPDX-License-Identifier: MIT
// `rastertrace suite`: all scenes, traces and claims in a folder; and the results of its shards, merged.

#include "command.h"
#include "commands.h"
#include "driven_program.h"
#include "job_runner.h"
#include "load.h"
#include "option_values.h"
#include "run_self.h"
#include "shared_options.h"
#include "suite_cases.h"
#include "suite_journal.h"
#include "suite_results.h"

#include <rastertrace/trace/text/in_threads.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

struct SuiteCommand {
    std::string folder;
    std::vector<std::string> merged;  ///< results of shards, in the place of a folder
    std::vector<std::string> program; ///< and its arguments; none: we draw the scenes
    std::size_t jobs = 1;
    Shard shard;
    std::string journal; ///< "": none is kept
    std::string_view format = suite_formats.front().name;
    ComparisonOptions comparison;
    MethodOverrides method;
    std::size_t seconds = 10; ///< that a run of the program may take
};

/// All that results depend on besides files.
std::string asked_by(const SuiteCommand& command) {
    std::string text = fmt::format("{} {} {}\n", command.comparison.words(""), command.seconds,
                                   static_cast<int>(language_of_steps()));
    for (const auto& [key, value] : command.method)
        text += fmt::format("{}={}\n", key, value);
    for (const std::string& word : command.program)
        text += json_quoted(word);
    return text;
}

/// The cases of the shard. A program that is a file belongs to the files of each.
std::vector<SuiteCase> cases_of(const SuiteCommand& command) {
    std::vector<std::string> program_files;
    for (const std::string& word : command.program)
        if (std::error_code error; std::filesystem::is_regular_file(word, error))
            program_files.push_back(word);
    std::vector<SuiteCase> all = cases_below(command.folder);
    std::vector<SuiteCase> cases;
    for (std::size_t i = command.shard.number - 1; i < all.size(); i += command.shard.count) {
        all[i].files.insert(all[i].files.end(), program_files.begin(), program_files.end());
        cases.push_back(std::move(all[i]));
    }
    return cases;
}

SuiteResults run_cases(const SuiteCommand& command) {
    std::optional<DrivenProgram> program;
    if (!command.program.empty())
        program.emplace("suite", command.program, command.comparison,
                        std::chrono::seconds(command.seconds));
    const SuiteRules rules{.comparison = command.comparison.options(),
                           .method = command.method,
                           .program = program ? &*program : nullptr};
    const std::vector<SuiteCase> cases = cases_of(command);
    std::optional<SuiteJournal> journal;
    if (!command.journal.empty())
        journal.emplace(command.journal, asked_by(command));

    SuiteResults results{.shard = command.shard, .cases = std::vector<SuiteResult>(cases.size())};
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < cases.size(); ++i)
        if (auto known = journal ? journal->find(cases[i]) : std::nullopt)
            results.cases[i] = *std::move(known);
        else
            left.push_back(i);
    JobRunner runner({.doing = "suite",
                      .unit = "cases",
                      .count = left.size(),
                      .at_once = command.jobs,
                      .run_programs = program.has_value()});
    runner.run([&](std::size_t job, std::size_t) {
        const SuiteCase& one = cases[left[job]];
        SuiteResult& result = results.cases[left[job]];
        const OpenedMeanwhile opened;
        result = result_of(one, rules);
        if (journal)
            journal->add(one, opened.paths(), result);
    });
    std::ranges::sort(results.cases, {}, &SuiteResult::name);
    return results;
}

SuiteResults merge_files(const std::vector<std::string>& paths) {
    std::vector<SuiteResults> shards;
    for (const std::string& path : paths)
        shards.push_back(read_suite_results(value_or_throw(read_named_file(path, {}))));
    return merged(std::move(shards));
}

class SuiteCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {"suite", "Test all scenes, traces and claims in a folder",
                "rastertrace suite tests -- ./mine {scene}\n\n"
                "A scene is compared with NAME.golden.jsonl beside it, a trace NAME.jsonl, or "
                "NAME.mine.jsonl,\n"
                "with the golden or the drawing of the scene NAME.json. With a program behind --, "
                "it draws the\n"
                "scenes instead, as for fuzz. Shards are merged from their JSON:\n"
                "  rastertrace suite merge 1.json 2.json --format junit"};
    }

    void add_to(OptionList& options) override {
        options
            .option("folder", words_, "A folder of scenes, traces and claims; or merge FILE...",
                    "FOLDER")
            .required();
        options.option("program", command_.program, "Behind --: a program that draws {scene}",
                       "PROGRAM");
        options.option("--format", format_, "How to print", "NAME")
            .values({"text", "json", "markdown", "junit"});
        options.option("--jobs", jobs_, "Cases at once; one for each core if not given", "N");
        options.option("--shard", shard_, "Only each Nth case, from the Ith on, like 1/4", "I/N");
        options.option("--resume", command_.journal,
                       "Keep a journal there, and run only what it has not, or what has changed",
                       "FILE");
        options.option("--time", time_, "Seconds that a run may take; 10 if not given", "SECONDS");
        command_.comparison.add_to(options);
        method_.add_to(options);
    }

    std::size_t count_plain_words(std::span<const char* const> words) const override {
        const auto begin = std::ranges::find(words, std::string_view("--"));
        return begin == words.end() ? 0 : static_cast<std::size_t>(words.end() - begin) - 1;
    }

    void take_plain_words(std::span<const char* const> words) override {
        command_.program.assign(words.begin(), words.end());
    }

    void read() override {
        std::vector<std::string_view> formats;
        for (const SuiteFormat& format : suite_formats)
            formats.push_back(format.name);
        if (const auto format = value_of<std::size_t>("--format", format_, formats))
            command_.format = formats[*format];
        constexpr std::size_t most_jobs = 1024;
        constexpr std::size_t most_seconds = 86'400;
        command_.jobs =
            number_in_option<std::size_t>("--jobs", jobs_, 1, most_jobs).value_or(usual_jobs());
        command_.seconds = number_in_option<std::size_t>("--time", time_, 1, most_seconds)
                               .value_or(command_.seconds);
        if (!shard_.empty()) {
            const auto shard = shard_named(shard_);
            if (!shard)
                refuse_value("--shard", "I/N with I from 1 to N", shard_);
            command_.shard = *shard;
        }
        command_.method = method_.overrides();
        if (words_.front() == "merge")
            command_.merged.assign(words_.begin() + 1, words_.end());
        else if (words_.size() == 1)
            command_.folder = words_.front();
        if (command_.folder.empty() == command_.merged.empty())
            throw problem_of("", "suite: expected one folder, or merge and results of shards",
                             "a folder of this name is ./merge");
        const auto has_scene = [](const std::string& word) {
            return word.find("{scene}") != std::string::npos;
        };
        if (!command_.program.empty() && std::ranges::none_of(command_.program, has_scene))
            throw problem_of(
                "", "suite: expected a program behind --, with {scene} among its arguments",
                "like: rastertrace suite tests -- ./mine {scene}");
        if (runs_for_page() && !command_.journal.empty())
            throw problem_of("", "suite: a page can keep no journal");
    }

    int run() override {
        const SuiteResults results =
            command_.merged.empty() ? run_cases(command_) : merge_files(command_.merged);
        const auto format = std::ranges::find(suite_formats, command_.format, &SuiteFormat::name);
        print(format->write(results));
        return results.count(SuiteResult::Outcome::failed) > 0 ? exit_difference : exit_fine;
    }

private:
    SuiteCommand command_;
    std::vector<std::string> words_;
    std::string format_;
    std::string jobs_;
    std::string shard_;
    std::string time_;
    MethodOptions method_;
};

} // namespace

std::unique_ptr<Command> suite_command() {
    return std::make_unique<SuiteCommandLine>();
}

} // namespace rastertrace
