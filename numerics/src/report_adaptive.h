// SPDX-License-Identifier: MIT
#pragma once

// The scalar `adaptive` in the report. It is timed like the other scalars, on triangles that are placed
// already: those in filtered doubles, and the same in rationals for what doubles leave open. Bounds on
// errors, and exact numbers where they are needed, are part of what is timed.
//
//     AdaptiveTriangles triangles(scene, plan);
//     for (const AdaptiveTriangles::Placed& one : triangles.placed)
//         fill(Triangle<Adaptive>{one.filtered->positions}, ...);

#include <rastertrace/core/draw/filtered/exactly.h>
#include <rastertrace/core/draw/list/pieces.h>
#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/numerics/report.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

/// The triangles of a scene on the screen, and the parts that clipping has left of them, ready to be
/// filled, tested and colored again and again.
struct AdaptiveTriangles {
    struct Placed {
        PieceIndex index;
        std::optional<Piece<Adaptive>>
            filtered; ///< none if doubles leave its face or clipping open
        Piece<Rational> exact;
    };

    /// Of a plan that draws with filtered doubles.
    AdaptiveTriangles(const Scene& scene, const Plan& plan);
    AdaptiveTriangles(const AdaptiveTriangles&) = delete;
    AdaptiveTriangles& operator=(const AdaptiveTriangles&) = delete;

    /// Which triangles of the scene they are, in order.
    std::vector<std::size_t> primitives() const;

    /// Before everything is done once more: no piece has been drawn.
    void begin();
    /// What follows is about the next piece.
    void begin(const Placed& piece) { exactness.drawn.push_back(piece.index); }

    const Scene scene;
    const Plan plan;
    Exactness exactness;
    std::vector<Placed> placed;
};

/// The setting `adaptive`, with its work: `note` says what took exact numbers, and how often.
Setting adaptive_setting(std::uint64_t pixels_tested, std::uint64_t exact_fallbacks,
                         std::string note);

} // namespace rastertrace
