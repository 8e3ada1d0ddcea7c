// SPDX-License-Identifier: MIT
#pragma once

// ScreenDrawing in one kind of number: pieces are drawn by what draws a scene (draw_in.h).

#include "draw_in.h"
#include "plan/unfit.h"

#include <rastertrace/core/draw/screen_drawing.h>

namespace rastertrace {

template <typename Scalar> struct ScreenDrawing<Scalar>::State {
    const Scene& scene;
    Plan plan;
    Image image = Image::of_one_row(scene.canvas);
    SceneDrawing<Scalar> drawing{scene, plan, image};
    std::optional<DepthTests<DepthOf<Scalar>>> depth = {};
    std::vector<Piece<Scalar>> pieces = {}; ///< by the owners of depths, if depths are tested
};

template <typename Scalar>
ScreenDrawing<Scalar>::ScreenDrawing(const Scene& scene, std::int64_t denominator,
                                     const DepthRegion& region,
                                     const DepthRule<DepthOf<Scalar>>& rule)
    : state_(new State{.scene = scene, .plan = {.denominator = denominator}}) {
    State& state = *state_;
    if (region.area() == 0)
        return;
    state.drawing.depth = &state.depth.emplace(region, rule, true);
    state.drawing.owners = {
        [&state](std::uint32_t owner) { return state.pieces[owner].primitive; },
        [&state](std::uint32_t owner) { return corners_of(state.pieces[owner]); }};
}

template <typename Scalar> ScreenDrawing<Scalar>::~ScreenDrawing() = default;

template <typename Scalar>
bool ScreenDrawing<Scalar>::draw(const NamedPiece<Scalar>& named, const Listener& listener) {
    State& state = *state_;
    const auto& [piece, name, corners, stages] = named;
    if (is_fraction<Scalar> && !fits_fractions(state.scene, in_doubles(piece), state.plan))
        return false;
    if (unfit_of(in_doubles(piece), state.scene.method, stages.colors != ColorStage::flat,
                 stages.tests_depth))
        return false;
    state.plan.mixes_colors = stages.colors != ColorStage::flat;
    state.plan.stages.pixels.resize(state.scene.primitives.size());
    state.plan.stages.pixels[piece.primitive] = stages;
    if (state.depth) {
        state.depth->begin(static_cast<std::uint32_t>(state.pieces.size()));
        state.pieces.push_back(piece);
    }
    const ListenerSink sink(listener);
    tell_beginning(piece, name, corners, state.drawing, sink);
    draw_piece(piece, state.drawing, sink);
    return true;
}

} // namespace rastertrace
