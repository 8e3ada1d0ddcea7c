// SPDX-License-Identifier: MIT
#pragma once

// The scalar `adaptive` in the report. It is timed like the other scalars, on triangles that are placed
// already. Each is tried in intervals, then done in doubles; or in rationals, if the intervals leave
// something open. All of that is timed.
//
//     AdaptiveTriangles triangles(scene, plan);
//     for (const AdaptiveTriangles::Placed& one : triangles.placed)
//         if (one.is_decided([&](const Piece<Interval>& piece) { fill(...); }))
//             fill(Triangle<double>{one.doubles.positions}, ...);

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
        std::optional<Piece<Interval>> intervals; ///< none if they leave its face or clipping open
        Piece<double> doubles;                    ///< the middles of these
        Piece<Rational> exact;

        /// True if `try_out(intervals)` decides everything.
        template <typename TryOut> bool is_decided(TryOut&& try_out) const {
            if (!intervals)
                return false;
            try {
                try_out(*intervals);
                return true;
            } catch (const Undecided&) {
                return false;
            }
        }
    };

    /// Of a plan that draws in intervals.
    AdaptiveTriangles(const Scene& scene, const Plan& plan);
    AdaptiveTriangles(const AdaptiveTriangles&) = delete;
    AdaptiveTriangles& operator=(const AdaptiveTriangles&) = delete;

    /// Which triangles of the scene they are, in order.
    std::vector<std::size_t> primitives() const;

    const Scene scene;
    const Plan plan;
    std::vector<Placed> placed;
};

/// The setting `adaptive`, with its work: `note` says what took exact numbers, and how often.
Setting adaptive_setting(std::uint64_t pixels_tested, std::uint64_t exact_fallbacks,
                         std::string note);

} // namespace rastertrace
