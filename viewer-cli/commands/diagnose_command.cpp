// SPDX-License-Identifier: MIT
// rastertrace diagnose: which rule accounts for what a renderer has drawn, and which mistake it makes.

#include "app/command.h"
#include "app/command_words.h"
#include "app/json_text.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/shared_options.h"
#include "commands/explain_text.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/trace/diagnose/diagnosis.h>
#include <rastertrace/trace/diagnose/tell_apart.h>
#include <rastertrace/trace/picture/picture_trace.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/in_threads.h>
#include <rastertrace/trace/text/output.h>
#include <rastertrace/trace/text/text.h>
#include <rastertrace/trace/text/trace_layout.h>

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

struct PairOfFiles {
    std::string scene;
    std::string theirs;
};

/// The scenes of a folder, each with the file of its name and another ending.
std::vector<PairOfFiles> pairs_in(const std::string& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (is_file(entry))
            files.push_back(entry.path());
    std::ranges::sort(files);
    std::vector<PairOfFiles> pairs;
    for (const auto& scene : files)
        for (const auto& theirs : files)
            if (scene.extension() == ".json" && theirs.extension() != ".json" &&
                scene.stem() == theirs.stem())
                pairs.push_back({scene.string(), theirs.string()});
    if (pairs.empty())
        throw problem_of(folder,
                         "expected scenes, and pictures or traces of the same names, found none");
    return pairs;
}

std::vector<PairOfFiles> pairs_of(const std::vector<std::string>& files) {
    std::error_code ignored;
    if (files.size() == 1 && std::filesystem::is_directory(files.front(), ignored))
        return pairs_in(files.front());
    if (files.size() % 2 != 0)
        throw problem_of(
            files.back(),
            fmt::format("expected a scene and what was drawn of it, pair by pair, found {}",
                        files.size() == 1 ? "one file alone"
                                          : fmt::format("{} files", files.size())));
    std::vector<PairOfFiles> pairs;
    for (std::size_t i = 0; i < files.size(); i += 2)
        pairs.push_back({files[i], files[i + 1]});
    return pairs;
}

/// Throws a Problem if somebody claims two things of one number, or something of a name that is not in the scene.
void check_agreement(const Claims& claims, const Source& scene) {
    const Checked checked = check(Truth(scene, {}), claims);
    if (const auto problem = checked.problem())
        throw *problem;
    for (const CheckedClaim& claim : checked.claims)
        for (const std::string& remark : claim.remarks)
            if (remark.starts_with("contradicts"))
                throw problem_at(claims.source, claims.claims[claim.claim].offset,
                                 fmt::format("expected claims that agree with one another, found "
                                             "one that {}",
                                             remark));
}

DrawnPair drawn_pair(const PairOfFiles& files) {
    DrawnPair pair{.scene = load_scene_source(files.scene)};
    const Canvas canvas = value_or_throw(read_scene(pair.scene)).scene.canvas;
    if (const auto picture = picture_in_file(files.theirs, {})) {
        pair.seen = cells_of(*picture, pair.scene);
    } else {
        Source theirs = load_scene_trace_or_claims(files.theirs, {});
        if (is_claims(theirs)) {
            Claims claims = value_or_throw(read_claims(std::move(theirs)));
            if (const auto problem = claims.problem())
                throw *problem;
            pair.claims = comparable(std::move(claims));
            if (pair.claims->claims.empty())
                throw problem_of(files.theirs, "expected claims about what is drawn, found none");
            check_agreement(*pair.claims, pair.scene);
            return pair;
        }
        if (!is_trace(theirs))
            throw problem_of(
                files.theirs,
                fmt::format("expected what was drawn of {}, found another scene", files.scene),
                "theirs is a picture, rows of text, a trace, or claims");
        const Trace trace = load_trace(files.theirs);
        const Canvas& theirs_on = trace.canvas;
        if (theirs_on.left() != canvas.left() || theirs_on.top() != canvas.top())
            throw problem_of(files.theirs,
                             fmt::format("expected a canvas with ({}, {}) at its top left, as that "
                                         "of {} has, found ({}, {})",
                                         canvas.left(), canvas.top(), files.scene, theirs_on.left(),
                                         theirs_on.top()));
        pair.seen = cells_of(trace, pair.scene);
    }
    if (pair.seen.width != canvas.width || pair.seen.height != canvas.height)
        throw problem_of(
            files.theirs,
            fmt::format("expected {} x {} pixels, as the canvas of {} has, found {} x {}",
                        canvas.width, canvas.height, files.scene, pair.seen.width,
                        pair.seen.height));
    return pair;
}

/// What is to be known of the pictures, whatever they come of.
std::string remarks_on(const std::vector<DrawnPair>& pairs, const std::vector<PairOfFiles>& files) {
    std::string text;
    const auto remark = [&text](const std::string& what) {
        text += "  remark      " + what + "\n";
    };
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (pairs[i].claims)
            continue;
        const std::string theirs = printable(files[i].theirs);
        const SeenCells& seen = pairs[i].seen;
        const Image asked = *drawn_by({}, pairs[i].scene);
        std::size_t common = 0, alone = 0, recolored = 0;
        for (std::size_t cell = 0; cell < seen.colors.size(); ++cell) {
            const bool is_seen = seen.colors[cell] != no_color;
            const bool is_asked = asked.colors()[cell] != no_color;
            common += is_seen && is_asked;
            alone += is_seen != is_asked;
            recolored += is_seen && is_asked && differs(seen, cell, asked.colors()[cell]);
        }
        if (common == 0)
            remark(fmt::format("no pixel is drawn in {} and by {} as well: is it a picture of "
                               "this scene?",
                               theirs, printable(files[i].scene)));
        for (const auto& [color, meant] : seen.stand_ins)
            remark(
                fmt::format("{} in {} is the scene's {}", to_text(color), theirs, to_text(meant)));
        if (alone == 0 && recolored > 0)
            remark(fmt::format("{} draws what the scene asks for, {} pixels in another color",
                               theirs, recolored));
        if (seen.between > 0)
            remark(fmt::format("{} pixels of {} have a color between two of the scene's: "
                               "anti-aliasing; each counts as the nearer one",
                               seen.between, theirs));
    }
    return text;
}

/// True if a picture has another color in the place of one that its scene chooses; black is what one has that does not.
bool has_other_colors(const std::vector<DrawnPair>& pairs) {
    return std::ranges::any_of(pairs, [](const DrawnPair& pair) {
        return std::ranges::any_of(pair.seen.stand_ins,
                                   [](const auto& one) { return one.second != Color(); });
    });
}

/// What the differences are counted in.
std::string_view counted_pairs(const std::vector<DrawnPair>& pairs) {
    const auto of_claims = static_cast<std::size_t>(std::ranges::count_if(
        pairs, [](const DrawnPair& pair) { return pair.claims.has_value(); }));
    return of_claims == 0 ? "pixels" : of_claims == pairs.size() ? "claims" : "pixels and claims";
}

/// What a rule is, in a line; settings beside what the scene asks for.
std::string headline(const AnsweredRule& answer, const Scene& asked) {
    const Rule& rule = answer.rule;
    std::vector<std::string> parts;
    std::vector<std::string> instead;
    for (const auto& [name, value] : rule.settings) {
        const MethodKey* const key = find_method_key(name);
        const std::string in_force = key == nullptr ? "" : value_in_force(*key, asked);
        if (in_force == value)
            continue;
        parts.push_back(fmt::format("{} {}", name, value));
        if (!in_force.empty() && name != "convention")
            instead.push_back(fmt::format("{} {}", name, in_force));
    }
    std::string text;
    if (!parts.empty())
        text = fmt::format(
            "draws by {}{}{}", joined(parts, ", "),
            answer.same.empty() ? "" : fmt::format(" ({})", answer.same.front()->says),
            instead.empty() ? "" : fmt::format("; the scene asks for {}", joined(instead, ", ")));
    for (const Mistake* const mistake : rule.mistakes)
        text += fmt::format("{}{} {}: {}{}", text.empty() ? "" : "\n",
                            mistake->is_rule() ? "draws by the rule" : "makes the mistake",
                            mistake->name, mistake->says,
                            mistake->is_rule() ? "" : fmt::format("; right: {}", mistake->should));
    return text;
}

std::string words_for(const Rule& rule) {
    return shell_word(name_of(rule));
}

/// y = 1, 10; after a few: and 5 more rows
std::string rows_in_words(const std::vector<int>& rows) {
    constexpr std::size_t most = 8;
    std::vector<std::string> told;
    for (std::size_t i = 0; i < std::min(rows.size(), most); ++i)
        told.push_back(std::to_string(rows[i]));
    return "y = " + joined(told, ", ") +
           (rows.size() > most ? fmt::format(" and {} more rows", rows.size() - most) : "");
}

std::string details(const Diagnosis& found, const std::vector<DrawnPair>& pairs,
                    const std::vector<PairOfFiles>& files) {
    std::string text;
    const Rule& rule = found.answer.front().rule;
    for (const Mistake* const mistake : rule.mistakes)
        text += fmt::format("  symptom     {} ({})\n", mistake->symptom, mistake->source);
    for (const auto& [name, value] : rule.settings)
        text += fmt::format("  {:<10}  {}\n", name, find_method_key(name)->meaning);
    for (const Mistake* const same : found.answer.front().same)
        text += fmt::format("  known as    {}: {}\n", same->name, same->symptom);
    text +=
        fmt::format("  explains    {} of {} {} that are not as the scene asks: score {:.0f} %\n",
                    found.differing - std::min(found.unexplained, found.differing), found.differing,
                    counted_pairs(pairs), 100 * found.score());
    text += remarks_on(pairs, files);
    for (std::size_t i = 1; i < found.answer.size(); ++i)
        text += fmt::format("  or          {}: it draws the same here; rastertrace diagnose "
                            "--tell-apart {} {} prints a scene that tells them apart\n",
                            name_of(found.answer[i].rule), words_for(rule),
                            words_for(found.answer[i].rule));
    if (found.runner_up)
        text +=
            fmt::format("  next best   {}: it leaves {} of {} unexplained{}\n",
                        name_of(*found.runner_up), found.runner_up_unexplained, found.differing,
                        found.rows.empty() ? "" : "; it differs on " + rows_in_words(found.rows));
    for (const Mistake* const mistake : rule.mistakes)
        if (!mistake->is_rule())
            text += fmt::format("  mend it     where the code has {}, write {}\n", mistake->says,
                                mistake->should);
    if (rule.mistakes.empty())
        text += "  mend it     draw as the scene asks, or say in the scene what is meant\n";
    text += fmt::format("  test        rastertrace {} {} {}\n",
                        pairs[found.pair].claims ? "check" : "diff",
                        shell_word(files[found.pair].scene), shell_word(files[found.pair].theirs));
    return text;
}

/// How the scene's own rules come to a pixel that tells the answer from what was asked.
std::string explained_pixel(const Diagnosis& found, const PairOfFiles& files) {
    const Trace trace = load_trace(files.scene);
    const auto explanation =
        value_or_throw(explain(trace, {.about = Topic::pixel, .pixel = *found.pixel}));
    return fmt::format("\nAs the scene asks, in {}:\n{}", printable(files.scene),
                       explanation_text(explanation));
}

Rule rule_in(const std::string& name) {
    if (name == "asked")
        return {};
    if (auto rule = rule_named(name))
        return *std::move(rule);
    refuse_value("--tell-apart",
                 "a mistake, a convention, settings like rounding=truncate, or `asked`", name);
}

// The known mistakes of rasterizers, as --list prints them.

/// A line for each mistake: its name and its symptom.
std::string mistakes_text() {
    std::string text;
    for (const Mistake& mistake : mistakes())
        text += fmt::format("{:<30} {}\n", mistake.name, mistake.symptom);
    return text;
}

/// All that is known of one.
std::string mistake_text(const Mistake& mistake) {
    std::string text = fmt::format("{}{}\n  it says   {}\n", mistake.name,
                                   mistake.is_rule() ? ", a rule of others" : "", mistake.says);
    if (!mistake.is_rule())
        text += fmt::format("  should    {}\n", mistake.should);
    text += fmt::format("  changes   {}\n  symptom   {}\n  source    {}\n", mistake.step,
                        mistake.symptom, mistake.source);
    if (!mistake.setting.empty())
        text += fmt::format("  the same  {}\n", mistake.setting);
    return text;
}

/// All that is known of each.
JsonText mistakes_json() {
    return {{"mistakes", JsonText::lines(mistakes(), [](const Mistake& mistake) {
                 return JsonText{{"name", mistake.name},       {"says", mistake.says},
                                 {"should", mistake.should},   {"step", mistake.step},
                                 {"symptom", mistake.symptom}, {"source", mistake.source},
                                 {"setting", mistake.setting}};
             })}};
}

class DiagnoseCommand final : public Command {
public:
    CommandAbout about() const override {
        return {
            "diagnose", "Find the rule, or the mistake, that a renderer has drawn by",
            "rastertrace diagnose scene.json theirs.png\n"
            "rastertrace diagnose --list factor-2-dropped\n"
            "rastertrace diagnose --tell-apart tie-refused-by-both asked --fill top-left\n\n"
            "Theirs is a picture, rows of text, a trace, or claims. Several pairs, or a folder of "
            "scenes and pictures of\n"
            "the same names, add up. Exit status: 0 drawn as the scene asks, 1 by another rule, a "
            "mistake, or nothing known.\n\n"
            "A rule that --tell-apart takes is a mistake, a convention, or settings; `asked` is "
            "the method as the options have it."};
    }

    void add_to(OptionList& options) override {
        options.option("files", files_,
                       "A scene and what was drawn of it, pair by pair; or a folder", "FILE");
        options.option("--meant", meant_,
                       "What the scene's method is: scene, as it says, which it is if not given; "
                       "or any: nobody knows",
                       "NAME");
        options.option("--predict", predicted_, "Print what they would draw of this scene",
                       "SCENE");
        OptionList alone = options.one_of("Without what a renderer has drawn", "");
        list_ = alone
                    .option("--list", mistake_,
                            "List the known mistakes of rasterizers, or tell of this one; "
                            "--mistake draws with one",
                            "[NAME]")
                    .with_optional_value()
                    .names_of(NamesOf::mistakes);
        alone
            .option("--tell-apart", rules_apart_,
                    "Print a small scene that two rules draw differently", "RULE RULE")
            .names_of(NamesOf::mistakes);
        alone.flag("--probe", writes_probes_, "Write a few scenes that tell the known rules apart");
        options.flag("--json", json_, "Print the list as JSON");
        options.option("-o", folder_, "Where to write the scenes; probes if not given", "FOLDER");
        options.option("--jobs", jobs_, "Threads; one for each core if not given", "N");
        method_.add_to(options);
    }

    void read() override {
        options_.jobs = usual_jobs();
        if (const auto jobs = number_in_option<std::size_t>("--jobs", jobs_, 1, 1024))
            options_.jobs = *jobs;
        if (!meant_.empty() && meant_ != "scene" && meant_ != "any")
            refuse_value("--meant", "scene or any", meant_);
        options_.any_convention = meant_ == "any";
        if (folder_.empty())
            folder_ = "probes";
        overrides_ = method_.overrides();
        const bool tells_apart = !rules_apart_.empty();
        if (tells_apart && rules_apart_.size() != 2)
            refuse_value("--tell-apart", "two rules", joined(rules_apart_, " "));
        if (!tells_apart && !overrides_.empty())
            throw problem_of("", "expected --tell-apart beside a choice of the method, found none",
                             "a scene says its method itself");
        const bool is_alone = list_->is_given() || tells_apart || writes_probes_;
        if (files_.empty() != is_alone)
            throw problem_of("", is_alone
                                     ? "expected --list, --tell-apart or --probe alone, found "
                                       "files beside it"
                                     : "expected a scene and what was drawn of it, found nothing");
    }

    int run() override {
        if (list_->is_given())
            return list_mistakes();
        if (!rules_apart_.empty())
            return tell_apart();
        return writes_probes_ ? write_probes() : answer();
    }

private:
    ExitStatus answer() const {
        const std::vector<PairOfFiles> files = pairs_of(files_);
        std::vector<DrawnPair> pairs;
        for (const PairOfFiles& pair : files)
            pairs.push_back(drawn_pair(pair));
        const Diagnosis found = diagnose(pairs, options_);
        if (!predicted_.empty() && !found.answer.empty()) {
            const auto drawn = drawn_by(found.answer.front().rule, load_scene_source(predicted_));
            if (!drawn)
                throw problem_of(
                    predicted_,
                    fmt::format("expected a scene that can be drawn by {}, found another",
                                name_of(found.answer.front().rule)));
            Picture picture{drawn->canvas().width, drawn->canvas().height, drawn->colors()};
            std::string text;
            for (const std::string& row : picture_rows(picture))
                text += row + "\n";
            print(text);
            return found.is_as_asked() ? exit_fine : exit_difference;
        }
        if (found.is_as_asked()) {
            const bool is_recolored = has_other_colors(pairs);
            print(fmt::format("drawn as the scene asks{}\n{}",
                              is_recolored ? ", in other colors" : "", remarks_on(pairs, files)));
            return is_recolored ? exit_difference : exit_fine;
        }
        if (found.answer.empty()) {
            print(fmt::format(
                      "nothing that I know: {} {} are not as the scene asks; the closest rule, "
                      "{}, leaves {} wrong\n"
                      "  see         rastertrace {} {} {}\n",
                      found.differing, counted_pairs(pairs), name_of(*found.runner_up),
                      found.unexplained, pairs.front().claims ? "check" : "diff",
                      shell_word(files.front().scene), shell_word(files.front().theirs)) +
                  remarks_on(pairs, files));
            return exit_difference;
        }
        const Scene asked = value_or_throw(read_scene(pairs[found.pair].scene)).scene;
        std::string text =
            headline(found.answer.front(), asked) + "\n" + details(found, pairs, files);
        if (found.pixel)
            text += explained_pixel(found, files[found.pair]);
        print(text);
        return exit_difference;
    }

    ExitStatus write_probes() const {
        make_folder(folder_);
        std::string text;
        std::size_t number = 0;
        for (const Source& scene : probe_scenes(options_.jobs)) {
            const std::string path =
                (std::filesystem::path(folder_) / fmt::format("probe-{:02}.json", ++number))
                    .string();
            write_file(path, scene.text);
            text += fmt::format("written: {}\n", printable(path));
        }
        print(
            text +
            "Draw each with your renderer, as probe-01.png and so on, and diagnose the folder.\n");
        return exit_fine;
    }

    ExitStatus tell_apart() const {
        const std::string& a = rules_apart_[0];
        const std::string& b = rules_apart_[1];
        const auto scene = scene_apart(rule_in(a), rule_in(b), overrides_);
        if (!scene) {
            print_error(fmt::format(
                "rastertrace: no scene found that {} and {} draw differently, in {} random ones\n",
                printable(a), printable(b), most_seeds));
            return exit_difference;
        }
        print(scene->text);
        return exit_fine;
    }

    ExitStatus list_mistakes() const {
        std::vector<std::string_view> names;
        for (const Mistake& mistake : mistakes())
            names.push_back(mistake.name);
        const Mistake* const one = find_mistake(mistake_);
        if (!mistake_.empty() && one == nullptr)
            refuse_value("--list", "a name that `rastertrace diagnose --list` lists", mistake_,
                         did_you_mean(mistake_, names));
        print(one != nullptr ? mistake_text(*one)
              : json_        ? mistakes_json().line()
                             : mistakes_text());
        return exit_fine;
    }

    std::vector<std::string> files_; ///< a scene, what was drawn of it, and so on; or a folder
    DiagnoseOptions options_;
    std::string predicted_; ///< a scene that is to be drawn as theirs would be
    std::string folder_;    ///< for scenes that tell rules apart
    bool writes_probes_ = false;
    std::vector<std::string> rules_apart_; ///< two that a scene is to be found for
    std::string meant_;
    std::string jobs_;
    std::string mistake_;
    bool json_ = false;
    std::optional<AddedOption> list_;
    MethodOptions method_;
    MethodOverrides overrides_; ///< of that scene
};

} // namespace

std::unique_ptr<Command> diagnose_command() {
    return std::make_unique<DiagnoseCommand>();
}

} // namespace rastertrace
