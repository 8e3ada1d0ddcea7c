// SPDX-License-Identifier: MIT
// `rastertrace stress`: the catalogue of stiff and extreme cases; or, whether a scene is near any cliff.

#include "app/command.h"
#include "app/exit_status.h"
#include "app/json_text.h"
#include "app/load.h"
#include "app/option_values.h"
#include "app/progress.h"
#include "app/shared_options.h"

#include <rastertrace/numerics/cliffs.h>
#include <rastertrace/numerics/stress.h>
#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/problem.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// A case that was run, and what came of it with each scalar and method.
struct RunCase {
    const StressCase* about;
    std::vector<StressRow> rows;

    /// How many rows have this verdict.
    std::size_t count(Verdict verdict) const {
        return static_cast<std::size_t>(
            std::count_if(rows.begin(), rows.end(),
                          [verdict](const StressRow& row) { return verdict_of(row) == verdict; }));
    }
    /// How many rows are not as documented.
    std::size_t failed() const {
        return static_cast<std::size_t>(std::count_if(
            rows.begin(), rows.end(), [](const StressRow& row) { return !is_as_documented(row); }));
    }
};

/// Text over as many lines as it needs. The first begins with `first`, which is padded to `indent`
/// columns; the others are indented by as many.
std::string hanging(std::string_view first, std::size_t indent, std::string_view text) {
    std::string result = padded(first, indent) + joined(wrapped(text, text_width - indent),
                                                        '\n' + std::string(indent, ' '));
    result.resize(result.find_last_not_of(' ') + 1);
    return result + '\n';
}

/// "right 12, wrong 3": the verdicts that there are.
std::string counts_of(const std::array<std::size_t, 4>& counts) {
    std::string text;
    for (const Verdict verdict :
         {Verdict::right, Verdict::within, Verdict::wrong, Verdict::refused})
        if (const std::size_t count = counts[static_cast<std::size_t>(verdict)])
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name_of(verdict), count);
    return text;
}

std::array<std::size_t, 4> counts_of(const RunCase& one) {
    return {one.count(Verdict::right), one.count(Verdict::within), one.count(Verdict::wrong),
            one.count(Verdict::refused)};
}

// The table.

std::string as_table(const std::vector<RunCase>& cases) {
    std::string text = fmt::format("{:<4} {:<40} {:<14} {}\n", "case", "what", "result",
                                   "rows: one scalar and one method each");
    std::array<std::size_t, 4> sum{};
    std::size_t rows = 0;
    std::string failed;
    std::string_view family;
    for (const RunCase& one : cases) {
        if (family_of(*one.about) != family) {
            family = family_of(*one.about);
            text += fmt::format("\n{}\n", family);
        }
        const auto counts = counts_of(one);
        for (std::size_t i = 0; i < counts.size(); ++i)
            sum[i] += counts[i];
        rows += one.rows.size();
        text += fmt::format("{:<4} {:<40} {:<14} {}\n", one.about->id, one.about->title,
                            one.failed() > 0 ? "FAILED" : "as documented", counts_of(counts));
        if (one.failed() > 0)
            failed += fmt::format(" {}", one.about->id);
    }
    text += fmt::format("\n{} cases, {} rows: {}\n", cases.size(), rows, counts_of(sum));
    text += failed.empty()
                ? "Every row is as documented: what must hold holds, and what is documented to be "
                  "wrong is\nwrong by just that much. `--case ID` shows a case in full.\n"
                : fmt::format("Not as documented:{}; `--case ID` shows a case in full.\n", failed);
    return text;
}

// A case in full.

/// Rows that say the same of several scalars, one after the other.
std::string as_text(const std::vector<StressRow>& rows) {
    std::string text;
    constexpr std::size_t scalars_end = 36;
    constexpr std::size_t verdict_end = scalars_end + 10;
    for (std::size_t i = 0; i < rows.size();) {
        const StressRow& row = rows[i];
        if (i == 0 || rows[i - 1].method != row.method)
            text += fmt::format("\n  {}\n", row.method);
        std::string scalars = row.scalar;
        std::size_t next = i + 1;
        for (; next < rows.size() && rows[next].method == row.method &&
               verdict_of(rows[next]) == verdict_of(row) &&
               is_as_documented(rows[next]) == is_as_documented(row) &&
               described(rows[next]) == described(row);
             ++next)
            scalars += ", " + rows[next].scalar;
        // More scalars than the column holds have a line of their own.
        const char mark = is_as_documented(row) ? ' ' : '!';
        if (scalars.size() > scalars_end - 6) {
            text += fmt::format("  {} {}\n", mark, scalars);
            scalars.clear();
        }
        const std::string first =
            fmt::format("  {} {:<{}}{:<{}}", scalars.empty() ? ' ' : mark, scalars, scalars_end - 4,
                        name_of(verdict_of(row)), verdict_end - scalars_end);
        text += hanging(first, verdict_end, described(row));
        if (!is_as_documented(row))
            text +=
                hanging("", verdict_end, "documented: " + described(row.documented, row.measured));
        i = next;
    }
    return text;
}

std::string as_text(const RunCase& one) {
    const StressCase& about = *one.about;
    constexpr std::size_t indent = 10;
    std::string text = fmt::format("{}  {}  ({})\n\n", about.id, about.title, family_of(about));
    text += hanging("  input", indent, about.input);
    text += hanging("  why", indent, about.why);
    text += hanging("  holds", indent, about.holds);
    text += as_text(one.rows);

    text += '\n';
    const auto scenes = about.scenes();
    if (scenes.empty())
        text += hanging("  see", indent,
                        "there is no scene to look at: this is a computation, or is refused");
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        // Of many scenes alike, the first will do.
        if (i == 3 && scenes.size() > 4) {
            text += fmt::format("{:{}}... and {} more\n", "", indent, scenes.size() - i);
            break;
        }
        text += fmt::format("{:<{}}rastertrace stress --case {} --scene{} | rastertrace show -{}\n",
                            i == 0 ? "  see" : "", indent, about.id,
                            scenes.size() > 1 ? fmt::format(" {}", i + 1) : "",
                            scenes[i].name.empty() ? "" : "   # " + scenes[i].name);
    }
    const std::size_t failed = one.failed();
    text += failed == 0 ? "\nas documented\n"
                        : fmt::format("\nFAILED: {} of {} rows not as documented (!)\n", failed,
                                      one.rows.size());
    return text;
}

// JSON.

JsonText json_of(const Documented& documented) {
    JsonText json{{"verdict", name_of(documented.verdict)}};
    if (documented.verdict == Verdict::wrong) {
        json.add("wrong", documented.wrong);
        if (!documented.worst.empty())
            json.add("worst", JsonText::of(std::string(documented.worst)));
    }
    if (documented.verdict == Verdict::within)
        json.add("bound", documented.bound);
    return documented.note.empty() ? json : json.add("note", documented.note);
}

JsonText json_of(const StressRow& row) {
    const Measured& measured = row.measured;
    JsonText json{{"scalar", row.scalar},
                  {"method", row.method},
                  {"verdict", name_of(verdict_of(row))},
                  {"as_documented", is_as_documented(row)},
                  {"wrong", measured.wrong},
                  {"unit", measured.unit}};
    if (!measured.worst_unit.empty())
        json.add("worst", measured.worst).add("worst_unit", measured.worst_unit);
    if (!measured.note.empty())
        json.add(measured.is_refused ? "message" : "note", measured.note);
    return json.add("documented", json_of(row.documented));
}

JsonText json_of(const RunCase& one) {
    const StressCase& about = *one.about;
    return {
        {"id", about.id},
        {"family", family_of(about)},
        {"title", about.title},
        {"input", about.input},
        {"why", about.why},
        {"holds", about.holds},
        {"scenes", JsonText::list(about.scenes(), [](const auto& scene) { return scene.name; })},
        {"as_documented", one.failed() == 0},
        {"rows", JsonText::list(one.rows, [](const auto& row) { return json_of(row); })}};
}

JsonText json_of(const std::vector<RunCase>& cases) {
    std::vector<std::string_view> failed;
    for (const RunCase& one : cases)
        if (one.failed() > 0)
            failed.push_back(one.about->id);
    return {{"cases", JsonText::lines(cases, [](const auto& one) { return json_of(one); })},
            {"failed", failed}};
}

// Which cases.

std::vector<const StressCase*> chosen_cases(const std::vector<std::string>& ids) {
    std::vector<const StressCase*> cases;
    if (ids.empty())
        for (const StressCase& one : stress_cases())
            cases.push_back(&one);
    for (const std::string& id : ids) {
        const StressCase* const one = find_stress_case(id);
        if (one == nullptr) {
            std::vector<std::string_view> known;
            for (const StressCase& each : stress_cases())
                known.push_back(each.id);
            throw problem_of(
                "",
                fmt::format("--case: expected a case of the catalogue, L1 to L13, S1 to "
                            "S14, C1 to C18, Z1 to Z14, P1 to P12 or X1 to X9, found "
                            "\"{}\"",
                            id),
                did_you_mean(id, known));
        }
        if (std::find(cases.begin(), cases.end(), one) == cases.end())
            cases.push_back(one);
    }
    return cases;
}

int print_scene(const StressCase& one, std::size_t number) {
    const auto scenes = one.scenes();
    if (scenes.empty())
        throw problem_of("",
                         fmt::format("--scene: expected a case with a scene, found {}, which is "
                                     "a computation, or is refused",
                                     one.id));
    if (number < 1 || number > scenes.size())
        throw problem_of("", fmt::format("--scene: expected a scene from 1 to {} of {}, found {}",
                                         scenes.size(), one.id, number));
    print(scenes[number - 1].json + "\n");
    return exit_fine;
}

// A user's scene.

std::string as_text(const std::string& title, const std::vector<CliffGroup>& groups,
                    const std::vector<ComparedPicture>& pictures) {
    std::string text = shortened(printable(title), 79) + "\n";
    if (groups.empty())
        text += "\nNear no cliff: no sample within 2^-20 px of an edge, no sliver, nothing steep, "
                "deep, "
                "far out\nor edge-on.\n";
    for (const CliffGroup& group : groups) {
        text += fmt::format("\n{}\n", meaning_of(group.kind));
        for (const Cliff& cliff : group.worst)
            text += hanging(fmt::format("  {} ", shortened(printable(cliff.where), 38)), 42,
                            cliff.how_near);
        if (group.more > 0)
            text += fmt::format("  ... and {} more\n", group.more);
    }

    text += fmt::format("\n{:<10} pixels that differ from `exact`\n", "drawn with");
    for (const ComparedPicture& picture : pictures) {
        std::string found = fmt::format("{} of {}", picture.differing, picture.pixels);
        if (picture.first)
            found += fmt::format(", first ({}, {})", picture.first->x, picture.first->y);
        text += hanging(fmt::format("{:<10} ", picture.scalar), 11,
                        picture.refusal.empty() ? found : "refused: " + printable(picture.refusal));
    }
    return text;
}

JsonText json_of(const std::string& title, const std::vector<CliffGroup>& groups,
                 const std::vector<ComparedPicture>& pictures) {
    const auto cliff_json = [](const Cliff& cliff) {
        return JsonText{{"where", cliff.where}, {"how_near", cliff.how_near}};
    };
    const auto group_json = [&](const CliffGroup& group) {
        return JsonText{{"cliff", name_of(group.kind)},
                        {"meaning", meaning_of(group.kind)},
                        {"worst", JsonText::list(group.worst, cliff_json)},
                        {"more", group.more}};
    };
    const auto picture_json = [](const ComparedPicture& picture) {
        JsonText json{{"scalar", picture.scalar}};
        if (!picture.refusal.empty())
            return json.add("refused", picture.refusal);
        json.add("pixels", picture.pixels).add("differing", picture.differing);
        return picture.first ? json.add("first", *picture.first) : json;
    };
    return {{"title", title},
            {"cliffs", JsonText::list(groups, group_json)},
            {"pictures", JsonText::list(pictures, picture_json)}};
}

class StressCommand final : public Command {
public:
    CommandAbout about() const override {
        return {
            "stress", "Run the stiff and extreme cases, or look for cliffs in a scene",
            "rastertrace stress --case S1\n"
            "         rastertrace stress --case S1 --scene | rastertrace show -\n"
            "         rastertrace stress examples/t0-fill/first-triangle.json\n\n"
            "Each row of a case is one scalar and one method: right; within its stated bound; "
            "wrong\n"
            "by a count; or refused. What is documented to be wrong must be wrong by just that. "
            "Exit\n"
            "status 1: a row is not as documented. How the program bears bad files, full disks "
            "and\n"
            "odd terminals (R1 to R12 of the catalogue) is tested elsewhere: it is no arithmetic."};
    }

    void add_to(OptionList& options) override {
        options.option(
            "scene", scene_file_,
            "A scene; - for standard input. Is it near any cliff, and does a scalar fall?",
            "SCENE");
        options
            .option("--case", ids_,
                    "Only these cases, in full: L1 to L13, S1 to S14, C1 to C18, Z1 to Z14, P1 to "
                    "P12, X1 to X9",
                    "ID,...")
            .separated_by_commas();
        scene_ = options
                     .option("--scene", number_,
                             "Print the scene of the case, or its Nth scene, to draw it", "[N]")
                     .with_optional_value();
        options.flag("--quick", quick_, "Every case, the longest with one scalar only");
        options.flag("--json", json_, "Print JSON");
        drawing_.add_to(options, Holds::no_steps);
    }

    void read() override {
        scenes_ = drawing_.scene_options();
        check_stress();
    }

    int run() override {
        if (!scene_file_.empty())
            return look_at_scene();
        const auto chosen = chosen_cases(ids_);
        if (scene_number_)
            return print_scene(*chosen.front(), *scene_number_);

        std::vector<RunCase> cases;
        {
            std::atomic<std::uint64_t> done = 0;
            Progress progress(
                {.unit = "cases", .total = chosen.size(), .done = [&] { return done.load(); }});
            for (const StressCase* one : chosen) {
                progress.say(fmt::format("{} {}", one->id, one->title));
                cases.push_back({one, rows_of(*one, {.quick = quick_})});
                ++done;
            }
        }
        if (json_) {
            print(json_of(cases).line());
        } else if (ids_.empty()) {
            print(as_table(cases));
        } else {
            std::string_view separator;
            for (const RunCase& one : cases) {
                print(std::string(separator) + as_text(one));
                separator = "\n";
            }
        }
        const bool has_failed = std::any_of(cases.begin(), cases.end(),
                                            [](const RunCase& one) { return one.failed() > 0; });
        return has_failed ? exit_difference : exit_fine;
    }

private:
    /// Looks at the user's own scene.
    int look_at_scene() const {
        const Source source = load_scene_source(scene_file_, scenes_.limits);
        // What a scalar refuses is part of the answer; only what none can draw is a bad scene.
        MethodOverrides exact = scenes_.method;
        exact.emplace_back("scalar", "exact");
        const auto planned = read_scene(source, exact, scenes_.limits, scenes_.frames);
        if (!planned)
            throw planned.problem();
        const Scene& scene = planned.value().scene;
        std::vector<CliffGroup> groups;
        std::vector<ComparedPicture> pictures;
        {
            Progress progress({.doing = "looking for cliffs"});
            groups = cliffs_of(scene);
            progress.say("drawing with every scalar");
            pictures = compared_pictures(source, scenes_.method, scenes_.limits, scenes_.frames);
        }
        const std::string title = shown_title(scene.title, scene_file_);
        print(json_ ? json_of(title, groups, pictures).line() : as_text(title, groups, pictures));
        return exit_fine;
    }

    /// Which options of `stress` go together.
    void check_stress() {
        const bool has_scene = !scene_file_.empty();
        if (has_scene && !ids_.empty())
            refuse_value("--case", "cases, or a scene, not both", scene_file_,
                         find_stress_case(scene_file_) != nullptr
                             ? fmt::format("several cases are one word: --case {},{}",
                                           joined(ids_, ","), scene_file_)
                             : "");
        for (const auto& [key, value] : scenes_.method) {
            if (!has_scene)
                refuse_value(option_named(key), "a scene to draw by another method", "none",
                             "the cases of the catalogue have their own methods");
            if (key == "scalar")
                refuse_value("--scalar", "no scalar: the scene is drawn with each", value);
        }
        if (!has_scene && (!scenes_.frames.vary.empty() || scenes_.frames.frame))
            refuse_value(scenes_.frames.frame ? "--frame" : "--vary", "a scene whose numbers vary",
                         "none");
        if (!scene_->is_given())
            return;
        if (has_scene || ids_.size() != 1)
            refuse_value("--scene", "one case whose scene to print",
                         fmt::format("{}", joined(ids_, ",")), "say --case S1 --scene");
        scene_number_ = 1;
        if (!number_.empty()) {
            scene_number_ = whole_number<std::size_t>(number_);
            if (!scene_number_)
                refuse_value("--scene", "the number of a scene, from 1", number_);
        }
    }

    std::string scene_file_;                  ///< empty: the catalogue
    std::vector<std::string> ids_;            ///< of cases; none: all of them, as a table
    std::optional<std::size_t> scene_number_; ///< print this scene of the only case, from 1
    bool json_ = false;
    bool quick_ = false;
    std::optional<AddedOption> scene_;
    std::string number_;
    DrawingOptions drawing_;
    SceneOptions scenes_;
};

} // namespace

std::unique_ptr<Command> stress_command() {
    return std::make_unique<StressCommand>();
}

} // namespace rastertrace
