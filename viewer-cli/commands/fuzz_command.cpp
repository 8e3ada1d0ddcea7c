// SPDX-License-Identifier: MIT
// `rastertrace fuzz`: a rasterizer of somebody else, driven by random scenes until it decides otherwise than we do; the
// scene is then shrunk, and written with a test that fails.

#include "app/command.h"
#include "app/command_words.h"
#include "app/exit_status.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/progress.h"
#include "app/run_program.h"
#include "app/shared_options.h"
#include "commands/driven_program.h"

#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/trace/fuzz/shrink.h>
#include <rastertrace/trace/text/in_threads.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/process_files.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// Which scenes a program is run on.
struct FuzzSeeds {
    std::uint64_t first = 1;
    std::uint64_t count = 1000;
    std::size_t jobs = 1;
    FuzzChoice choice{.has_near_ties = true};
};

/// A scene that the program fails on.
struct FoundScene {
    std::uint64_t seed = 0;
    FuzzScene scene;
    DrivenFinding finding;
};

/// Runs the program on the scenes of all seeds, several at once. What is found does not depend on how many.
class FuzzRuns {
public:
    FuzzRuns(const FuzzSeeds& seeds, const DrivenProgram& program)
        : seeds_(seeds), program_(program), end_(seeds.count) {}

    /// The failing scene of the smallest seed; nothing if there is none. Throws a Problem.
    std::optional<FoundScene> run() {
        // Signals come again while progress is still known: they tell it.
        const Progress progress(
            {.doing = "fuzz", .unit = "scenes", .total = seeds_.count, .done = [this] {
                 return done_.load();
             }});
        const EndingHeldBack ending;
        in_threads(end_, seeds_.jobs, [this](std::size_t number, std::size_t) {
            try {
                try_seed(seeds_.first + number, number);
                ++done_;
            } catch (...) {
                const std::scoped_lock lock(mutex_);
                if (!failure_ || number < failed_) {
                    failed_ = number;
                    failure_ = std::current_exception();
                }
                end_ = 0;
            }
        });
        if (failure_)
            std::rethrow_exception(failure_);
        if (undrawn_ == seeds_.count)
            throw *refusal_;
        return std::move(found_);
    }

    std::uint64_t undrawn() const { return undrawn_; }

private:
    void try_seed(std::uint64_t seed, std::size_t number) {
        FuzzScene scene = random_scene(seed, seeds_.choice);
        const auto reference = program_.reference(scene);
        auto finding = reference ? program_.difference(scene, reference.value()) : std::nullopt;
        const std::scoped_lock lock(mutex_);
        if (!reference) {
            ++undrawn_;
            refusal_ = reference.problem();
        }
        if (!finding || (found_ && found_->seed < seed))
            return;
        found_ = FoundScene{seed, std::move(scene), *std::move(finding)};
        end_ = std::min<std::size_t>(end_, number);
    }

    const FuzzSeeds& seeds_;
    const DrivenProgram& program_;
    std::atomic<std::uint64_t> done_ = 0;
    std::atomic<std::size_t> end_; ///< no run from this one on is begun; changed under the mutex
    std::mutex mutex_;
    std::optional<FoundScene> found_;
    std::exception_ptr failure_; ///< of the first run that threw
    std::size_t failed_ = 0;
    std::optional<Problem> refusal_; ///< of a scene that we do not draw
    std::uint64_t undrawn_ = 0;
};

/// A word for the shell; `$here` in it stands for the folder of the script.
std::string script_word(const std::string& word) {
    return word.starts_with("$here/") ? '"' + word + '"' : shell_word(word);
}

class FuzzCommand final : public Command {
public:
    CommandAbout about() const override {
        return {
            "fuzz", "Drive a rasterizer of your own by random scenes, to the first difference",
            "rastertrace fuzz --runs 1000 --kinds 2d --fill top-left -- ./mine {triangles}\n\n"
            "{scene} stands for a scene file, {triangles} for a text without a parser's need;\n"
            "{out} for the file that the program answers in, if not on standard output: with a\n"
            "trace or a picture. The scene that it fails on is shrunk, and written with a golden\n"
            "and a test."};
    }

    void add_to(OptionList& options) override {
        program_ =
            options
                .option("program", words_, "Behind --: the program, and its arguments", "PROGRAM")
                .required();
        options.option("--runs", runs_, "How many scenes; 1000 if not given", "N");
        options.option("--seed", seed_, "Of the first one; the next has the next; 1 if not given",
                       "N");
        options.option("--kinds", kinds_, "What scenes are about; 2d if not given", "KINDS")
            .values({"2d", "lines", "depth", "clip"});
        options.option("--time", time_, "Seconds that a run may take; 10 if not given", "SECONDS");
        options.option("--jobs", jobs_, "Runs at once; one for each core if not given", "N");
        options.option("--shrink", tries_, "Runs to shrink a scene; 2000 if not given, 0 for none",
                       "N");
        options.option("-o", folder_, "Where to write what is found; fuzz if not given", "FOLDER");
        comparison_.add_to(options);
        method_.add_to(options);
    }

    std::size_t count_plain_words(std::span<const char* const> words) const override {
        const auto begin = std::ranges::find(words, std::string_view("--"));
        return begin == words.end() ? 0 : static_cast<std::size_t>(words.end() - begin) - 1;
    }

    void take_plain_words(std::span<const char* const> words) override {
        words_.assign(words.begin(), words.end());
        program_->required(words.empty());
    }

    void read() override {
        constexpr std::uint64_t most = 1'000'000'000;
        const auto read_number = [](const char* option, const std::string& text, auto& number,
                                    std::uint64_t least, std::uint64_t largest) {
            using Number = std::remove_reference_t<decltype(number)>;
            if (const auto given = number_in_option(option, text, least, largest))
                number = static_cast<Number>(*given);
        };
        seeds_.jobs = usual_jobs();
        read_number("--runs", runs_, seeds_.count, 1, most);
        read_number("--seed", seed_, seeds_.first, 0, most);
        read_number("--time", time_, seconds_, 1, 86'400);
        read_number("--jobs", jobs_, seeds_.jobs, 1, 1024);
        read_number("--shrink", tries_, most_tries_, 0, most);
        auto kinds = values_of("--kinds", "kinds", kinds_,
                               {fuzz_kind_names.begin(), fuzz_kind_names.end()}, fuzz_kind_named);
        if (!kinds.empty())
            seeds_.choice.kinds = std::move(kinds);
        seeds_.choice.method = method_.overrides();
    }

    int run() override {
        const DrivenProgram program(words_, comparison_, std::chrono::seconds(seconds_));
        FuzzRuns runs(seeds_, program);
        auto found = runs.run();
        const std::string seeds =
            fmt::format("seeds {} to {}", seeds_.first, seeds_.first + seeds_.count - 1);
        if (!found) {
            std::string text =
                fmt::format("{}, {}: no difference\n", counted(seeds_.count, "run"), seeds);
            if (runs.undrawn() > 0)
                text += fmt::format("{} of them not compared: we do not draw the scene\n",
                                    runs.undrawn());
            print(text + program.remarks());
            return exit_fine;
        }
        std::size_t tries = 0;
        const FoundScene small = shrunk_finding(program, *std::move(found), tries);
        const bool has_lines = small.scene.kind == FuzzKind::lines;
        const std::size_t vertices = fuzz_vertices(small.scene).size();
        std::string text =
            fmt::format("seed {}: {} {}\n{}\nshrunk by {} to {}, {} {}, {}x{} pixels\n\n{}{}",
                        small.seed, printable(words_.front()), words_of(small.finding.kind),
                        small.finding.first, counted(tries, "run"),
                        counted(small.scene.primitives.size(), has_lines ? "line" : "triangle"),
                        vertices, vertices == 1 ? "vertex" : "vertices", small.scene.width,
                        small.scene.height, triangles_text(small.scene), small.finding.text);
        for (const std::string& file : write_findings(program, small))
            text += fmt::format("written: {}\n", printable(file));
        print(text);
        return exit_difference;
    }

private:
    std::string test_script(const DrivenProgram& program, const FoundScene& found,
                            const std::string& name) const {
        const std::string out = "$here/" + name + ".out";
        std::vector<std::string> words;
        for (const std::string& word :
             program.words_for("$here/" + name + std::string(program.ending()), out))
            words.push_back(script_word(word));
        return fmt::format(
            "#!/bin/sh\n"
            "# Fails until the program draws this scene as its golden says. To be run in the "
            "folder "
            "in\n"
            "# which rastertrace fuzz was run. Seed {}: {}\n"
            "here=$(dirname \"$0\")\n"
            "timeout {} {}{} &&\n"
            "  rastertrace diff --common --any-order {} \"$here/{}.golden.jsonl\" \"{}\"\n",
            found.seed, found.finding.first, seconds_, joined(words, " "),
            program.answers_in_file() ? "" : fmt::format(" > \"{}\"", out),
            comparison_.words(program.ignored()), name, out);
    }

    /// Writes what was found; returns the names of the files.
    std::vector<std::string> write_findings(const DrivenProgram& program,
                                            const FoundScene& found) const {
        make_folder(folder_);
        const std::string name = fmt::format("seed-{}", found.seed);
        std::vector<std::string> written;
        const auto write = [&](const std::string& ending, const std::string& text) {
            written.push_back((std::filesystem::path(folder_) / (name + ending)).string());
            write_file(written.back(), text);
        };
        write(".json", scene_json(found.scene));
        if (program.ending() != ".json")
            write(std::string(program.ending()), program.scene_text(found.scene));
        write(".golden.jsonl", value_or_throw(program.reference(found.scene)));
        write(".sh", test_script(program, found, name));
        std::error_code ignored;
        if (folder_of_outputs().empty())
            std::filesystem::permissions(written.back(), std::filesystem::perms::owner_exec,
                                         std::filesystem::perm_options::add, ignored);
        return written;
    }

    /// The smallest scene that fails as the one found does.
    FoundScene shrunk_finding(const DrivenProgram& program, FoundScene found,
                              std::size_t& tries) const {
        const auto fails = [&](const FuzzScene& scene) {
            const auto reference = program.reference(scene);
            if (!reference)
                return false; // we do not draw it
            auto finding = program.difference(scene, reference.value());
            const bool is_it = finding && finding->kind == found.finding.kind;
            if (is_it)
                found.finding = *std::move(finding);
            return is_it;
        };
        Shrunk small = shrunk(std::move(found.scene), fails, most_tries_);
        found.scene = std::move(small.scene);
        tries = small.tries;
        return found;
    }

    std::vector<std::string> words_; ///< the program and its arguments
    FuzzSeeds seeds_;
    std::size_t most_tries_ = 2000; ///< to shrink what was found
    std::string folder_ = "fuzz";
    ComparisonOptions comparison_;
    std::size_t seconds_ = 10; ///< that a run may take
    std::optional<AddedOption> program_;
    std::string runs_;
    std::string seed_;
    std::string kinds_;
    std::string time_;
    std::string jobs_;
    std::string tries_;
    MethodOptions method_;
};

} // namespace

std::unique_ptr<Command> fuzz_command() {
    return std::make_unique<FuzzCommand>();
}

} // namespace rastertrace
