// SPDX-License-Identifier: MIT
#pragma once

// Draws pieces that are on the screen already, one after the other, as draw() does. Whoever knows their corners, like
// the reader of a trace, draws them again so.
//
//     ScreenDrawing<double> drawing(scene, 1, {}, {});
//     scene.primitives.push_back(triangle);
//     drawing.draw({piece, "ABC", {"A", "B", "C"}, {}}, listener);

#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/core/raster/depth_buffer.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

/// A piece with what a list of the scene would say of it.
template <typename Scalar> struct NamedPiece {
    Piece<Scalar> piece;
    std::string_view name;
    std::vector<std::string_view> corners; ///< their names
    PixelStages stages;
};

/// For float, double, Fraction64 and Rational.
template <typename Scalar> class ScreenDrawing {
public:
    /// `scene` says how to draw, and must live as long; its primitives may come later. `denominator` is that of all
    /// coordinates and samples, if they are fractions. Depths are tested within `region`, if it has pixels.
    ScreenDrawing(const Scene& scene, std::int64_t denominator, const DepthRegion& region,
                  const DepthRule<DepthOf<Scalar>>& rule);
    ~ScreenDrawing();

    /// Tells that a piece begins, and draws it. False if drawing it would make an infinity or overflow: then nothing is
    /// told.
    bool draw(const NamedPiece<Scalar>& named, const Listener& listener);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace rastertrace
