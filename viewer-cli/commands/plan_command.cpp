// SPDX-License-Identifier: MIT
// rastertrace plan: which stages a scene needs, and why.

#include "app/command.h"
#include "app/json_text.h"
#include "app/load.h"
#include "app/shared_options.h"

#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/trace/text/conventions.h>
#include <rastertrace/trace/text/method_names.h>
#include <rastertrace/trace/text/pipeline_names.h>
#include <rastertrace/trace/text/stage_name.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <memory>
#include <string>
#include <vector>

namespace rastertrace {

namespace {

/// What leaving a stage out saves: "2097152 bytes, 9 steps, up to 1234 pixels".
std::string as_text(const Savings& saved) {
    std::string text;
    const auto add = [&text](std::uint64_t count, std::string_view before, std::string_view noun) {
        if (count > 0)
            text += fmt::format("{}{}{}", text.empty() ? "" : ", ", before, counted(count, noun));
    };
    add(saved.bytes, "", "byte");
    add(saved.steps, "", "step");
    add(saved.pixels, "up to ", "pixel");
    return text;
}

/// What a scene's convention sets in it, and what is unusual about that.
std::string note_on(const ConventionRow& convention, const Scene& scene) {
    std::string sets;
    for (const auto& [key, value] : convention.method)
        if (find_method_key(key)->get(scene.method) == value)
            sets += fmt::format("{}{} {}", sets.empty() ? "" : ", ", key, value);
    return fmt::format("{}: {}; viewport {}; unusual: {}", convention.what, sets,
                       name_of(scene.viewport), convention.unusual);
}

std::string as_text(const Scene& scene, const Plan& plan) {
    std::string text = shortened(printable(scene.title), 79) + "\n";
    text += fmt::format("{:<12} {:<9} {}\n", "stage", "plan", "why; what it saves");
    for (const StageDecision& decision : plan.stages.decisions) {
        const std::string saved = as_text(decision.saved);
        text += fmt::format("{:<12} {:<9} {}{}\n",
                            fmt::format("{}{}{}", name_of(decision.stage),
                                        decision.plane.empty() ? "" : " ", decision.plane),
                            decision.is_kept ? "kept" : "left out", decision.why,
                            saved.empty() ? "" : "; saves " + saved);
    }
    if (const ConventionRow* const row = row_of(scene.method.convention))
        text += fmt::format("{:<12} {:<9} {}\n", "convention", row->name, note_on(*row, scene));
    return text;
}

JsonText json_of(const StageDecision& decision) {
    JsonText json{{"stage", name_of(decision.stage)}};
    if (!decision.plane.empty())
        json.add("plane", decision.plane);
    const Savings& saved = decision.saved;
    return json.add("kept", decision.is_kept)
        .add("why", decision.why)
        .add("saves", {{"bytes", saved.bytes}, {"steps", saved.steps}, {"pixels", saved.pixels}});
}

JsonText json_of(const Scene& scene, const Plan& plan) {
    std::vector<JsonText> rules;
    if (const ConventionRow* const row = row_of(scene.method.convention))
        rules.push_back(
            JsonText{{"rule", "convention"}, {"value", row->name}, {"note", note_on(*row, scene)}});
    return {{"title", scene.title},
            {"stages", JsonText::list(plan.stages.decisions,
                                      [](const auto& decision) { return json_of(decision); })},
            {"rules", rules}};
}

class PlanCommand final : public Command {
public:
    CommandAbout about() const override {
        return {"plan", "Say which stages of drawing a scene needs, and why",
                "rastertrace plan examples/t4-pipeline/behind-the-eye.json"};
    }

    void add_to(OptionList& options) override {
        options.option("scene", scene_, "A scene; - for standard input", "SCENE").required();
        options.flag("--json", json_, "Print JSON");
        drawing_.add_to(options, Holds::no_steps);
    }

    void read() override { scenes_ = drawing_.scene_options(); }

    int run() override {
        PlannedScene planned = load_scene(scene_, scenes_);
        Scene& scene = planned.scene;
        scene.title = shown_title(scene.title, scene_);
        print(json_ ? json_of(scene, planned.plan).line() : as_text(scene, planned.plan));
        return exit_fine;
    }

private:
    std::string scene_;
    bool json_ = false;
    DrawingOptions drawing_;
    SceneOptions scenes_;
};

} // namespace

std::unique_ptr<Command> plan_command() {
    return std::make_unique<PlanCommand>();
}

} // namespace rastertrace
