// SPDX-License-Identifier: MIT
// `rastertrace check`: claims held against a scene or a trace.

#include "app/command.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/shared_options.h"
#include "commands/check_report.h"

#include <rastertrace/trace/check/check.h>
#include <rastertrace/trace/check/claims_template.h>
#include <rastertrace/trace/check/exercise.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// What a claim is about: each field of its step, or the picture.
std::vector<std::pair<std::string, ClaimVerdict>> numbers_of(const Claims& claims,
                                                             const CheckedClaim& claim) {
    if (claims.claims[claim.claim].step == "picture")
        return {{"picture", claim.verdict}};
    std::vector<std::pair<std::string, ClaimVerdict>> numbers;
    for (const CheckedField& field : claim.fields)
        numbers.emplace_back(fmt::format("{} {}", claim.step, field.name), field.verdict);
    return numbers;
}

/// Right, unless something in it is not.
ClaimVerdict worse_of(ClaimVerdict a, ClaimVerdict b) {
    for (const ClaimVerdict worst :
         {ClaimVerdict::wrong, ClaimVerdict::open, ClaimVerdict::follows})
        if (a == worst || b == worst)
            return worst;
    return ClaimVerdict::right;
}

/// Counts the lines of the empty sheet: what a sheet lacks is open; what nobody asked for, or asked for once, does not
/// count.
void count_by_empty_sheet(const Truth& truth, const std::string& sheet, CheckedFile& file) {
    std::map<std::string, ClaimVerdict> said;
    for (const CheckedClaim& claim : file.checked.claims)
        for (const auto& [number, verdict] : numbers_of(file.claims, claim)) {
            ClaimVerdict& known = said.try_emplace(number, verdict).first->second;
            known = worse_of(known, verdict);
        }
    const Claims asked = value_or_throw(read_claims({.name = file.name, .text = sheet}));
    Checked& counts = file.checked;
    counts.right = counts.wrong = counts.follow = counts.open = 0;
    for (const CheckedClaim& claim : rastertrace::check(truth, asked).claims) {
        ClaimVerdict verdict = ClaimVerdict::right;
        for (const auto& [number, open] : numbers_of(asked, claim)) {
            const auto found = said.find(number);
            verdict = worse_of(verdict, found == said.end() ? ClaimVerdict::open : found->second);
        }
        ++(verdict == ClaimVerdict::right     ? counts.right
           : verdict == ClaimVerdict::wrong   ? counts.wrong
           : verdict == ClaimVerdict::follows ? counts.follow
                                              : counts.open);
    }
}

using TellRemark = std::function<void(const Problem&)>;

/// Checks files of claims, one after the other.
///
///     ClaimsChecker checker({}, false, [](const Problem& remark) { print_error(remark); });
///     checker.hold_against(scene);       // or each file names its scene
///     checker.check(sheet).checked.wrong;
class ClaimsChecker {
public:
    /// Remarks on the scenes that it draws go to `tell`.
    ClaimsChecker(SceneOptions options, bool is_strict, TellRemark tell)
        : options_(std::move(options)), is_strict_(is_strict), tell_(std::move(tell)) {}

    /// All claims are about this scene or trace, whatever scene they name; those of a sheet that names its exercise are
    /// about the exercise like this scene. Throws a Problem.
    void hold_against(Source source);

    /// What the claims were held against is damaged, or sound.
    ExitStatus report() const { return given_ ? report_damage(given_->decided()) : exit_fine; }

    /// Throws a Problem if the file is none of claims, or its scene cannot be drawn.
    CheckedFile check(Source source);

private:
    const Truth& truth_for(const CheckedFile& file);
    Truth told_truth(Source source) const;

    SceneOptions options_;
    bool is_strict_; ///< a claim that is not understood is a problem of the file
    TellRemark tell_;
    std::optional<Truth> given_;
    std::optional<Source> given_scene_;
    std::string like_; ///< the scene of `make_exercise_`
    ExerciseMaker make_exercise_;
    std::string last_name_;     ///< of the scene that came last, and the ID of its exercise
    std::string last_sheet_;    ///< of the exercise, empty
    std::optional<Truth> last_; ///< about it
};

void ClaimsChecker::hold_against(Source source) {
    if (!is_trace(source))
        given_scene_ = source;
    given_.emplace(told_truth(std::move(source)));
}

CheckedFile ClaimsChecker::check(Source source) {
    CheckedFile file{.name = source.name};
    if (!given_ || given_scene_)
        file.exercise = value_or_throw(exercise_of_sheet(source));
    file.claims = value_or_throw(read_claims(std::move(source)));
    if (file.claims.claims.empty())
        throw problem_of(file.name, "expected claims, found none",
                         "rastertrace sheet SCENE writes a sheet to fill in");
    const Truth& truth = truth_for(file);
    file.checked = rastertrace::check(truth, file.claims);
    if (const auto problem = file.checked.problem(); problem && is_strict_)
        throw *problem;
    if (!file.exercise.empty())
        count_by_empty_sheet(truth, last_sheet_, file);
    return file;
}

const Truth& ClaimsChecker::truth_for(const CheckedFile& file) {
    if (given_ && file.exercise.empty())
        return *given_;
    const std::string scene = given_ ? given_scene_->name : path_of_scene(file.claims);
    const std::string name = file.exercise + "\n" + scene;
    if (last_ && name == last_name_)
        return *last_;
    last_.reset();
    const auto load = [&] {
        return given_ ? *given_scene_ : load_scene_of_claims(file.claims, options_.limits);
    };
    if (file.exercise.empty()) {
        last_.emplace(told_truth(load()));
    } else {
        if (!make_exercise_ || like_ != scene)
            make_exercise_ = exercises_like(load());
        like_ = scene;
        Source exercise = make_exercise_(file.exercise);
        const auto planned =
            value_or_throw(read_scene(exercise, options_.method, options_.limits, options_.frames));
        last_sheet_ = claims_template(
            drawn_trace(planned.scene, planned.plan, exercise.name, options_.limits.steps));
        last_.emplace(told_truth(std::move(exercise)));
    }
    last_name_ = name;
    return *last_;
}

Truth ClaimsChecker::told_truth(Source source) const {
    Truth truth = truth_in(std::move(source), options_);
    for (const Problem& remark : truth.remarks())
        tell_(remark);
    return truth;
}

// The command.

ExitStatus status_of(const std::vector<CheckedFile>& files) {
    std::size_t problems = 0;
    std::size_t wrong = 0;
    for (const CheckedFile& file : files) {
        problems += file.problem ? 1 : 0;
        wrong += file.checked.has_faults() ? 1 : 0;
    }
    return problems > 0 ? exit_bad_input : wrong > 0 ? exit_difference : exit_fine;
}

class CheckCommand final : public Command {
public:
    CommandAbout about() const override {
        return {"check", "Say which line of a worked example is wrong, and why",
                "rastertrace check examples/claims/t0-rows.claims\n\n"
                "Claims are lines like these, in a file; check.md of the documentation has all of "
                "them:\n"
                "  y=2: -1/4, 25/8 -> -1..3   (3,2): on\n"
                "  A screen: 2, 5   normal ABC: 0, 0, -4\n"
                "Exit status 1: a claim is wrong, or not understood."};
    }

    void add_to(OptionList& options) override {
        options
            .option(
                "file", files_,
                "A scene or a trace, then files of claims, of which several get a line each; or "
                "only claims that name their scenes; - for standard input",
                "[SCENE] CLAIMS")
            .required();
        options.option("--format", format_, "How to print", "NAME").values({"text", "json"});
        options.flag("--json", json_, "Short for --format json");
        OptionList told = options.one_of("Answers", "How much is given away");
        told.flag("--answers", has_answers_,
                  "The right numbers, their working, likely slips: the default");
        told.option("--hint", hint_,
                    "Where a claim is wrong and by which rule; 2: the formula, too", "1|2");
        told.flag("--no-answers", has_no_answers_,
                  "Only which claims are right and which are wrong");
        options.flag("--strict", is_strict_,
                     "A line that is not understood is an error: exit status 2, and no marks");
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
        json_ = is_json(format_, json_);
        const std::vector<std::string_view> levels{"1", "2"};
        if (has_no_answers_)
            told_ = CheckTold::verdicts;
        else if (hint_)
            told_ =
                value_of<int>("--hint", *hint_, levels) == 1 ? CheckTold::formula : CheckTold::rule;
        scenes_ = drawing_.scene_options();
    }

    int run() override {
        ClaimsChecker checker(scenes_, is_strict_,
                              [](const Problem& remark) { print_error(remark); });
        Source first = load_scene_trace_or_claims(files_.front(), scenes_.limits);

        // The scene comes first, or the claims say which one it is.
        const std::vector<std::string> rest(files_.begin() + 1, files_.end());
        const bool is_scene_named = is_claims(first);
        const std::string first_name = first.name;
        std::optional<Source> claims;
        if (is_scene_named)
            claims = std::move(first);
        else
            checker.hold_against(
                std::move(first)); // or tells why it is no scene, as of broken JSON
        if (!is_scene_named && rest.empty())
            throw problem_of(first_name, "expected claims behind the scene, found none",
                             "rastertrace sheet SCENE writes a sheet to fill in");

        std::vector<CheckedFile> files;
        if (rest.size() + (claims ? 1U : 0U) == 1)
            files.push_back(
                checker.check(claims ? *std::move(claims)
                                     : load_scene_trace_or_claims(rest.front(), scenes_.limits)));
        else
            files = check_pile(checker, std::move(claims), rest);
        print(json_ ? check_json(files, told_).line() : check_text(files, told_));
        const ExitStatus damage = checker.report();
        return damage == exit_fine ? status_of(files) : damage;
    }

private:
    /// Checks each file of a pile. One that cannot be read is told, and the others go on.
    std::vector<CheckedFile> check_pile(ClaimsChecker& checker, std::optional<Source> first,
                                        const std::vector<std::string>& paths) const {
        std::vector<CheckedFile> files;
        const auto add = [&](const std::string& name, auto&& check_file) {
            try {
                files.push_back(check_file());
                if (!json_) { // a line needs only what is counted
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
            add(path,
                [&] { return checker.check(load_scene_trace_or_claims(path, scenes_.limits)); });
        return files;
    }

    std::vector<std::string>
        files_; ///< a scene or a trace, then claims; or claims that name their scenes
    std::string format_;
    bool json_ = false;
    bool has_answers_ = false;
    bool is_strict_ = false;
    bool has_no_answers_ = false;
    std::optional<std::string> hint_;
    CheckTold told_ = CheckTold::answers;
    DrawingOptions drawing_;
    SceneOptions scenes_;
};

} // namespace

std::unique_ptr<Command> check_command() {
    return std::make_unique<CheckCommand>();
}

} // namespace rastertrace
