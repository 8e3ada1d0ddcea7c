// SPDX-License-Identifier: MIT
#pragma once

// The way of a scene's primitives to the screen, by the rules of the model.

#include "tell/listener_sink.h"

#include <rastertrace/core/draw/model/model.h>

#include <functional>
#include <vector>

namespace rastertrace {

/// A primitive on the screen, or a part that clipping has left of one.
struct ModelPiece {
    PrimitiveKind kind;
    std::vector<ModelVertex> corners;
    Color color;
};

/// Hands every piece on, in the order in which they are drawn, when all has been told that leads to it.
void for_each_piece(const ModelRules& rules, const ListenerSink& sink,
                    const std::function<void(const ModelPiece&)>& draw);

} // namespace rastertrace
