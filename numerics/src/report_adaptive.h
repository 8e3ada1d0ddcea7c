// SPDX-License-Identifier: MIT
#pragma once

// The scalar `adaptive` in the report. Where its doubles leave something open, only draw() knows how
// to go on with exact numbers, so it is measured as the drawing that it is: of the triangles, on
// pictures of their own.
//
//     const auto drawing = adaptive_drawing(scene);
//     const AdaptiveSteps steps = steps_of(*drawing);
//     builder.add(adaptive_setting(*drawing, steps.pixels_tested()), timed(drawing), units);

#include <rastertrace/core/draw/plan.h>
#include <rastertrace/core/raster/canvas.h>
#include <rastertrace/core/raster/image.h>
#include <rastertrace/core/scene/scene.h>
#include <rastertrace/numerics/report.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace rastertrace {

/// The triangles of a scene, and how they are drawn.
struct AdaptiveDrawing {
    Scene scene;
    Plan plan;
    std::vector<std::size_t> numbers; ///< of its triangles in the scene that they come from
};

/// Plans the drawing of the triangles of a scene in which find_unfit has found nothing, in filtered doubles
/// even where fractions would fit.
std::shared_ptr<AdaptiveDrawing> adaptive_drawing(const Scene& scene);

/// What was told by drawing, in order.
struct AdaptiveSteps {
    struct Plotted {
        std::size_t primitive; ///< its place in the scene that was given
        Pixel pixel;
        Color color;
    };
    struct Tested {
        std::size_t primitive;
        Pixel pixel;
        double depth;
    };
    std::vector<Plotted> plotted;
    std::vector<Tested> tested;          ///< against the depth buffer
    std::uint64_t samples_tested = 0;    ///< by the fill that tests samples
    std::uint64_t pixels_tested() const; ///< by the fill, as the other scalars count them
};
AdaptiveSteps steps_of(const AdaptiveDrawing& drawing);

/// A setting that says that a whole drawing is timed, with the work of it.
Setting adaptive_setting(const AdaptiveDrawing& drawing, std::uint64_t pixels_tested);

/// What is timed: drawing without a sink.
std::function<void()> timed(std::shared_ptr<const AdaptiveDrawing> drawing);

} // namespace rastertrace
