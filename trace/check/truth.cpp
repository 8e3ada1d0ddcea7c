// SPDX-License-Identifier: MIT
#include "check.h"
#include "claim_subject.h"

#include <rastertrace/core/draw/model/mistakes.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/trace/scene/scene_file.h>

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

namespace {

/// Gives the sines and roots of a scene's matrices many digits; false if it has none.
bool give_many_digits(Scene& scene) {
    bool has_any = false;
    for (SceneObject& object : scene.objects) {
        std::vector<ModelStep> steps = object.model.steps();
        for (ModelStep& step : steps) {
            has_any = has_any || is_rounded(step);
            if (auto* const rotate = std::get_if<Rotate>(&step))
                rotate->digits = RootDigits::many;
        }
        object.model = Model(std::move(steps));
    }
    if (scene.camera) {
        has_any = has_any || is_rounded(*scene.camera);
        scene.camera->digits = RootDigits::many;
    }
    scene.projection.digits = RootDigits::many;
    return has_any || is_rounded(scene.projection);
}

} // namespace

/// A scene, and its traces once someone has asked; or one trace, which is all there is.
struct Truth::State {
    std::optional<Source> scene = {};
    MethodOverrides overrides = {};
    InputLimits limits = {};
    FrameChoice frames = {};
    std::optional<PlannedScene> without_mistake = {};
    std::optional<Trace> decided = {};
    std::optional<Trace> exact = {};
    std::optional<Trace> with_faces = {};
    std::map<const Trace*, std::optional<Trace>> with_many_digits = {};
    std::map<const Mistake*, std::optional<Trace>> with_mistakes = {};
    std::vector<Problem> remarks = {};
    std::optional<TruthIndex> index = {};
    bool names_no_ties = false; ///< of its lines, which have some
    std::vector<std::pair<std::string, Truth>> with_other_ties = {};

    /// The scene with more choices than it has. Every stage runs: it changes no picture, and each vertex is told in every
    /// space. Throws a Problem if it cannot be drawn so.
    PlannedScene planned(const MethodOverrides& more) const {
        MethodOverrides all = every_stage_kept();
        all.insert(all.end(), overrides.begin(), overrides.end());
        all.insert(all.end(), more.begin(), more.end());
        Result<PlannedScene> read = read_scene(*scene, all, limits, frames);
        if (!read)
            throw read.problem();
        return std::move(read.value());
    }

    Trace drawn(const PlannedScene& one) const {
        return drawn_trace(one.scene, one.plan, scene->name, limits.steps);
    }

    /// The same scene in exact numbers; nullptr if it is drawn in them.
    const Trace* drawn_exactly() {
        if (!scene || decided->method.triangles.scalar == ScalarKind::exact)
            return nullptr;
        if (!exact)
            exact = drawn(planned({{"scalar", "exact"}}));
        return &*exact;
    }

    /// The exact trace, or the one with every face tested, with many digits of sines and roots; nullptr if it has none,
    /// or so many steps that no hand works them out, and their fractions take minutes.
    const Trace* drawn_with_many_digits(const Trace& trace) {
        constexpr std::size_t most_steps = 100'000;
        const auto [place, is_new] = with_many_digits.try_emplace(&trace);
        if (is_new && scene && trace.size() <= most_steps) {
            MethodOverrides all{{"scalar", "exact"}};
            if (with_faces && &trace == &*with_faces)
                all.emplace_back("cull", "back");
            PlannedScene one = planned(all);
            if (give_many_digits(one.scene)) {
                one.plan = plan_for(one.scene);
                place->second = drawn(one);
            }
        }
        return place->second ? &*place->second : nullptr;
    }

    /// The scene drawn with a mistake, in exact numbers; nullptr if that changes nothing that it has, or it has more steps
    /// than a hand works out.
    const Trace* drawn_with(const Mistake& mistake) {
        constexpr std::size_t most_steps = 500;
        const auto [place, is_new] = with_mistakes.try_emplace(&mistake);
        if (is_new && scene && decided->size() <= most_steps)
            place->second = drawn_newly_with(mistake);
        return place->second ? &*place->second : nullptr;
    }

    std::optional<Trace> drawn_newly_with(const Mistake& mistake) {
        if (!without_mistake)
            without_mistake = planned({{"scalar", "exact"}});
        if (!mistake.concerns(without_mistake->scene))
            return std::nullopt;
        try {
            if (mistake.put_in == nullptr) {
                MethodOverrides settings = settings_of(mistake);
                settings.emplace_back("scalar", "exact");
                return drawn(planned(settings));
            }
        } catch (const Problem&) {
            return std::nullopt; // what it sets does not go with what else the scene says
        }
        if (!has_model(without_mistake->scene))
            return std::nullopt;
        PlannedScene one = *without_mistake;
        one.scene.method.mistakes = {&mistake};
        return drawn(one);
    }

    /// The same with every face tested; nullptr if there is no scene.
    const Trace* drawn_with_faces() {
        if (!scene)
            return nullptr;
        if (!with_faces)
            with_faces = drawn(planned({{"scalar", "exact"}, {"cull", "back"}}));
        return &*with_faces;
    }
};

Truth::Truth(Trace trace) : state_(std::make_unique<State>()) {
    state_->decided = std::move(trace);
}

Truth::Truth(Source scene, MethodOverrides overrides, InputLimits limits, FrameChoice frames)
    : state_(std::make_unique<State>()) {
    state_->scene = std::move(scene);
    state_->overrides = std::move(overrides);
    state_->limits = limits;
    state_->frames = std::move(frames);
    PlannedScene asked = state_->planned({});
    const Method& method = asked.scene.method;
    state_->names_no_ties = !method.ties && method.snap != Snap::nearest &&
                            traits_of(method.line).rule == LineRule::rounding;
    state_->decided = state_->drawn(asked);
    state_->remarks = std::move(asked.remarks);
}

Truth::Truth(Truth&&) noexcept = default;
Truth::~Truth() = default;

const Trace& Truth::decided() const {
    return *state_->decided;
}

const Trace& Truth::exact() const {
    const Trace* const exact = state_->drawn_exactly();
    return exact == nullptr ? decided() : *exact;
}

const Trace* Truth::with_faces() const {
    return state_->drawn_with_faces();
}

const std::vector<std::pair<std::string, Truth>>& Truth::with_other_ties() const {
    auto& others = state_->with_other_ties;
    if (std::exchange(state_->names_no_ties, false))
        for (const std::string_view ties : {"start", "away", "even", "step"}) {
            MethodOverrides overrides = state_->overrides;
            overrides.emplace_back("ties", ties);
            try {
                others.emplace_back(ties, Truth(*state_->scene, std::move(overrides),
                                                state_->limits, state_->frames));
            } catch (const Problem&) {
                continue; // what else rounds in the scene does not have this one
            }
        }
    return others;
}

const TruthIndex& Truth::index() const {
    if (!state_->index)
        state_->index.emplace(
            decided(), state_->drawn_exactly(),
            [state = state_.get()] { return state->drawn_with_faces(); },
            [state = state_.get()](const Trace& trace) {
                return state->drawn_with_many_digits(trace);
            },
            [state = state_.get()](const Mistake& mistake) { return state->drawn_with(mistake); });
    return *state_->index;
}

const std::vector<Problem>& Truth::remarks() const {
    return state_->remarks;
}

} // namespace rastertrace
