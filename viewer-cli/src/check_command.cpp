// SPDX-License-Identifier: MIT
// `rastertrace check`: claims held against a scene or a trace.

#include "check_class.h"
#include "check_report.h"
#include "claims_checker.h"
#include "command.h"
#include "commands.h"
#include "exercise_options.h"
#include "figure_file.h"
#include "load.h"
#include "option_values.h"
#include "shared_options.h"

#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

SceneOptions options_of(const CheckCommand& command) {
    return {.method = command.method, .limits = command.input, .frames = command.frames};
}

/// Pictures of a class's slips.
constexpr std::array<Ending<FigureFormat>, 2> chart_endings{
    {{".svg", FigureFormat::svg}, {".png", FigureFormat::png}}};

FigureFormat chart_format(const std::string& path) {
    return format_by_ending<FigureFormat>(path, chart_endings).value_or(FigureFormat::svg);
}

/// Checks each file of a pile. One that cannot be read is told, and the others go on.
std::vector<CheckedFile> check_pile(const CheckCommand& command, ClaimsChecker& checker,
                                    std::optional<Source> first,
                                    const std::vector<std::string>& paths) {
    std::vector<CheckedFile> files;
    const auto add = [&files](const std::string& name, auto&& check_file) {
        try {
            files.push_back(check_file());
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

std::string report_of(const CheckCommand& command, const std::vector<CheckedFile>& files) {
    switch (command.format) {
    case CheckFormat::json:
        return check_json(files, command.told);
    case CheckFormat::junit:
        return check_junit(files, command.told);
    case CheckFormat::csv: {
        std::vector<SheetMark> marks;
        for (const CheckedFile& file : files)
            marks.push_back(mark_of(file));
        return check_csv(marks, command.told);
    }
    case CheckFormat::markdown:
        return check_markdown(files, command.told);
    case CheckFormat::gradescope:
        return check_gradescope(files, command.told, command.visibility);
    case CheckFormat::prairielearn:
        return check_prairielearn(files, command.told);
    case CheckFormat::text:
        break;
    }
    return check_text(files, command.told);
}

/// What another program reads is complete even where a sheet cannot be checked.
bool tells_problems(CheckFormat format) {
    return format != CheckFormat::text && format != CheckFormat::json;
}

ExitStatus status_of(std::size_t problems, std::size_t wrong) {
    return problems > 0 ? exit_bad_input : wrong > 0 ? exit_difference : exit_fine;
}

ExitStatus status_of(const std::vector<CheckedFile>& files) {
    std::size_t problems = 0;
    std::size_t wrong = 0;
    for (const CheckedFile& file : files) {
        problems += file.problem ? 1 : 0;
        wrong += file.checked.wrong + file.checked.follow;
    }
    return status_of(problems, wrong);
}

ExitStatus run_class(const CheckCommand& command) {
    const std::optional<Source> scene =
        command.files.empty()
            ? std::nullopt
            : std::optional(load_scene_trace_or_claims(command.files.front(), command.input));
    std::mutex mutex;
    std::set<std::string> remarks; // each once, however many sheets and threads there are
    const auto remember = [&](const Problem& remark) {
        const std::lock_guard lock(mutex);
        remarks.insert(to_text(remark));
    };
    const ClassMarks marks = mark_class(command.class_folder, [&] {
        ClaimsChecker checker(options_of(command), remember);
        if (scene)
            checker.hold_against(*scene);
        if (command.exercises_like)
            checker.hold_against_exercises_like(*command.exercises_like);
        return checker;
    });
    for (const std::string& remark : remarks)
        print_error(fmt::format("rastertrace: {}\n", remark));
    std::size_t problems = marks.duplicates.size();
    std::size_t wrong = 0;
    for (const SheetMark& sheet : marks.sheets) {
        wrong += sheet.counts.wrong + sheet.counts.follow;
        if (!sheet.problem)
            continue;
        ++problems;
        print_error(*sheet.problem);
    }
    for (const std::string& duplicate : marks.duplicates)
        print_error(fmt::format("rastertrace: {}: {}; each of them is marked\n",
                                printable(command.class_folder), duplicate));
    print(command.format == CheckFormat::csv ? check_csv(marks.sheets, command.told)
                                             : class_text(marks));
    if (!command.chart.empty())
        write_file(command.chart,
                   figure_in(chart_format(command.chart), slip_chart(marks.sheets), {}));
    return status_of(problems, wrong);
}

/// Checks the claims in `first`, if there are any, and in the files; prints what is found.
ExitStatus tell(const CheckCommand& command, ClaimsChecker& checker, std::optional<Source> first,
                const std::vector<std::string>& paths) {
    std::vector<CheckedFile> files;
    if (!tells_problems(command.format) && paths.size() + (first ? 1U : 0U) == 1)
        files.push_back(checker.check(
            first ? *std::move(first) : load_scene_trace_or_claims(paths.front(), command.input)));
    else
        files = check_pile(command, checker, std::move(first), paths);
    print(report_of(command, files));
    const ExitStatus damage = checker.report();
    return damage == exit_fine ? status_of(files) : damage;
}

} // namespace

int run(const CheckCommand& command) {
    if (!command.class_folder.empty())
        return run_class(command);
    ClaimsChecker checker(options_of(command), [](const Problem& remark) { print_error(remark); });
    if (command.exercises_like) {
        checker.hold_against_exercises_like(*command.exercises_like);
        return tell(command, checker, std::nullopt, command.files);
    }
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
        options.option("file", command_.files,
                       "A scene or a trace, then files of claims; or only claims that name their "
                       "scenes; - for standard input",
                       "[SCENE] CLAIMS");
        options.option("--class", command_.class_folder,
                       "The sheets of a class: a file, or a folder with one, for each student",
                       "FOLDER");
        options.option("-o", command_.chart,
                       "With --class: the most likely slips as bars, in an .svg or .png", "FILE");
        exercises_.add_to(options, false);
        options.option("--format", format_, "How to print; csv has one line for each file", "NAME")
            .values({"text", "json", "junit", "markdown", "gradescope", "prairielearn", "csv"});
        options
            .option("--visibility", visibility_, "With --format gradescope; visible if not given",
                    "NAME")
            .values({"visible", "after_due_date", "after_published", "hidden"});
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
        exercises_.read();
        if (exercises_.are_given())
            command_.exercises_like = exercises_.scene();
        if (command_.class_folder.empty())
            read_without_class();
        else
            read_class();
    }

    int run() override { return rastertrace::run(command_); }

private:
    void read_check_format() {
        if (is_json_ && !format_.empty())
            refuse_value("--json", "no --format beside it", format_);
        if (is_json_)
            format_ = "json";
        const std::vector<std::string_view> names{"text",     "json",       "junit",       "csv",
                                                  "markdown", "gradescope", "prairielearn"};
        command_.format =
            value_of<CheckFormat>("--format", format_, names).value_or(CheckFormat::text);
        if (!visibility_.empty() && command_.format != CheckFormat::gradescope)
            refuse_value("--visibility", "--format gradescope beside it", format_);
        const std::vector<std::string_view> visibilities{"visible", "after_due_date",
                                                         "after_published", "hidden"};
        command_.visibility =
            visibilities[value_of<std::size_t>("--visibility", visibility_, visibilities)
                             .value_or(0)];
    }

    void read_without_class() const {
        if (command_.files.empty())
            throw problem_of("", "check: expected a file of claims, or --class FOLDER, found none");
        if (!command_.chart.empty())
            throw problem_of("", "-o: expected --class FOLDER as well, found none");
    }

    void read_class() const {
        if (command_.format != CheckFormat::text && command_.format != CheckFormat::csv)
            refuse_value("--format", "text or csv beside --class", format_);
        if (command_.told != CheckTold::answers)
            throw problem_of("", "--class: expected neither --hint nor --no-answers beside it");
        if (command_.files.size() > (exercises_.are_given() ? 0U : 1U))
            refuse_value("--class", "at most a scene beside it, of no exercises",
                         command_.files.back());
        if (!command_.chart.empty())
            chart_format(command_.chart);
    }

    CheckCommand command_;
    ExerciseOptions exercises_;
    std::string format_;
    std::string visibility_;
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
