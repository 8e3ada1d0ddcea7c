// SPDX-License-Identifier: MIT
#pragma once

// The way of a scene's primitives to the screen, by the rules of the model.

#include "tell/listener_sink.h"

#include <rastertrace/core/draw/model/model.h>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace rastertrace {

/// A primitive on the screen, or a part that clipping has left of one.
struct ModelPiece {
    std::size_t primitive; ///< its index in the scene
    PrimitiveKind kind;    ///< a line, if it is a part of an outline
    std::vector<ModelVertex> corners;
    Color color;
    std::size_t side = 0; ///< of an outline that it is a part of
};

/// The pixel of a point, where pixels have their samples at whole numbers.
inline GridPoint pixel_of(const Vec<Rational, 2>& at) {
    return nearest_pixel(at, SampleOffset<Rational>());
}
inline Pixel pixel_at(GridPoint p) {
    return {static_cast<int>(p.x), static_cast<int>(p.y)};
}

/// A vertex with samples at whole numbers.
ModelVertex on_samples(ModelVertex vertex, const Rational& offset);

/// The ends of a line, where samples lie at whole numbers, from that where it begins to be drawn.
std::pair<ModelVertex, ModelVertex> directed(const ModelRules& rules, const ModelVertex& from,
                                             const ModelVertex& to);

/// Hands every piece on, in the order in which they are drawn, when all has been told that leads to it.
void for_each_piece(const ModelRules& rules, const ListenerSink& sink,
                    const std::function<void(const ModelPiece&)>& draw);

} // namespace rastertrace
