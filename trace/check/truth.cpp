// SPDX-License-Identifier: MIT
#include "check.h"
#include "claim_subject.h"

#include <rastertrace/trace/scene/scene_file.h>
#include <rastertrace/trace/text/stage_name.h>

#include <optional>
#include <utility>

namespace rastertrace {

/// A scene, and its traces once someone has asked; or one trace, which is all there is.
struct Truth::State {
    std::optional<Source> scene = {};
    MethodOverrides overrides = {};
    InputLimits limits = {};
    FrameChoice frames = {};
    std::optional<Trace> decided = {};
    std::optional<Trace> exact = {};
    std::optional<Trace> with_faces = {};
    std::vector<Problem> remarks = {};
    std::optional<TruthIndex> index = {};

    /// Draws the scene with more choices than it has. Every stage runs: it changes no picture, and each
    /// vertex is told in every space.
    Trace draw(const MethodOverrides& more) {
        MethodOverrides all = overrides;
        for (const std::string_view stage : stage_names())
            all.emplace_back("keep", stage);
        all.insert(all.end(), more.begin(), more.end());
        Result<PlannedScene> read = read_scene(*scene, all, limits, frames);
        if (!read)
            throw read.problem();
        const PlannedScene& planned = read.value();
        remarks = planned.remarks;
        return drawn_trace(planned.scene, planned.plan, scene->name, limits.steps);
    }

    /// The same scene in exact numbers; nullptr if it is drawn in them.
    const Trace* drawn_exactly() {
        if (!scene || decided->method_value("scalar") == "exact")
            return nullptr;
        if (!exact)
            exact = draw({{"scalar", "exact"}});
        return &*exact;
    }

    /// The same with every face tested; nullptr if there is no scene.
    const Trace* drawn_with_faces() {
        if (!scene)
            return nullptr;
        if (!with_faces)
            with_faces = draw({{"scalar", "exact"}, {"cull", "back"}});
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
    state_->decided = state_->draw({});
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

const TruthIndex& Truth::index() const {
    if (!state_->index)
        state_->index.emplace(decided(), state_->drawn_exactly(),
                              [state = state_.get()] { return state->drawn_with_faces(); });
    return *state_->index;
}

const std::vector<Problem>& Truth::remarks() const {
    return state_->remarks;
}

} // namespace rastertrace
