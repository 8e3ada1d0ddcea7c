// SPDX-License-Identifier: MIT
// `rastertrace exercise`: scenes like one of a course, with other numbers.

#include "command.h"
#include "exercise_options.h"
#include "figure_file.h"
#include "load.h"
#include "option_values.h"
#include "sheet_page.h"

#include <rastertrace/trace/check/claims_template.h>
#include <rastertrace/trace/exercise/exercise.h>
#include <rastertrace/trace/exercise/exercise_id.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rastertrace {

namespace {

/// Slips that no numbers tell apart: `a = b; c = d`.
std::string slips_in_words(const Exercise& exercise) {
    std::vector<std::string> alike;
    for (const auto& group : exercise.slips)
        if (group.size() > 1)
            alike.push_back(joined({group.begin(), group.end()}, " = "));
    return fmt::format("{} slips give wrong answers of their own{}\n", exercise.slips.size(),
                       alike.empty() ? "" : "; the same with any numbers: " + joined(alike, "; "));
}

class ExerciseCommandLine final : public Command {
public:
    CommandAbout about() const override {
        return {"exercise", "Make an exercise of a scene: as much work, with other numbers",
                "rastertrace exercise --like examples/t0-fill/first-triangle.json --seed anna\n\n"
                "The same seed makes the same exercise everywhere: who marks it needs only the "
                "seed, as in\n"
                "  rastertrace exercise --like scene.json --seed anna |\n"
                "      rastertrace check - sheet.txt"};
    }

    void add_to(OptionList& options) override {
        model_.add_to(options, true);
        options
            .option("--seed", seed_, "A word that stands for it, such as a student's number", "ID")
            .required();
        options.option("--count", count_, "So many, with the seeds ID-1, ID-2, ...", "N");
        options.option("-o", folder_,
                       "Where scene.json, sheet.txt and picture.svg go, of several in a folder for "
                       "each; none: the scene to standard output",
                       "FOLDER");
    }

    void read() override {
        number_ = number_in_option<std::size_t>("--count", count_, 1, 10'000);
        if (number_ && folder_.empty())
            throw problem_of("", "--count: expected -o FOLDER as well, found none");
        if (number_ && seed_.find('/') != std::string::npos)
            refuse_value("--seed", "no / beside --count, which makes folders of it", seed_);
        id_ = value_or_throw(exercise_id(seed_));
        model_.read();
    }

    int run() override {
        ExerciseMaker like(model_.scene());
        if (folder_.empty()) {
            print(like.exercise(id_).scene.text);
            return exit_fine;
        }
        Exercise last;
        std::set<std::string> different;
        for (std::size_t i = 1; i <= number_.value_or(1); ++i) {
            const std::string ending = number_ ? fmt::format("-{}", i) : "";
            last = like.exercise(id_ + ending);
            different.insert(last.scene.text);
            write(last,
                  number_ ? (std::filesystem::path(folder_) / (seed_ + ending)).string() : folder_);
        }
        if (number_)
            print(fmt::format("{} exercises, {} of them different\n", *number_, different.size()));
        print(slips_in_words(last));
        return exit_fine;
    }

private:
    /// Throws a Problem rather than writing over a sheet that has been filled in.
    static void write(const Exercise& exercise, const std::string& folder) {
        const auto path = [&folder](const char* name) {
            return (std::filesystem::path(folder) / name).string();
        };
        InputFrames input(path("scene.json"),
                          {.name = path("scene.json"), .text = exercise.scene.text}, {});
        const Trace trace = input.trace(input.first());
        const std::string sheet = fmt::format("{}{}\n{}", exercise_line(exercise.id),
                                              scene_line("scene.json"), claims_template(trace));
        refuse_filled_sheet(path("sheet.txt"), sheet);
        make_folder(folder);
        write_file(path("scene.json"), exercise.scene.text);
        write_file(path("sheet.txt"), sheet);
        write_file(
            path("picture.svg"),
            figure_in(FigureFormat::svg, sheet_page(trace, &exercise.scene, exercise.id), {}));
        print(fmt::format("written: {}\n", printable(folder)));
    }

    ExerciseOptions model_;
    std::string seed_;
    std::string count_;
    std::string folder_;
    std::string id_;
    std::optional<std::size_t> number_;
};

} // namespace

std::unique_ptr<Command> exercise_command() {
    return std::make_unique<ExerciseCommandLine>();
}

} // namespace rastertrace
