// SPDX-License-Identifier: MIT
#pragma once

// How much of each pixel of a bitmap shapes cover, together, by the rasterizer of AGG (Anti-Grain Geometry). It counts
// in 256ths of a pixel, so that all machines find the same.
//
//     PixelCoverage coverage(width, height);
//     coverage.add(places);
//     coverage.for_each_run([&](const CoverageRun& run) { ... });

#include <rastertrace/figures/drawing.h>

#include <agg2/agg_rasterizer_scanline_aa.h>
#include <agg2/agg_scanline_p.h>

#include <functional>
#include <span>

namespace rastertrace {

/// Pixels of a row that are covered alike.
struct CoverageRun {
    int y;
    int begin; ///< the first x
    int end;   ///< the x behind the last one
    int level; ///< how much is covered: 1 to full_coverage
};

/// Coverage is told in eighths: smooth to the eye, and a drawing of few colors stays one that a palette holds.
inline constexpr int full_coverage = 8;

/// A rectangle, in pixels.
struct CoveredBox {
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;
};

class PixelCoverage {
public:
    PixelCoverage(int width, int height);

    /// A polygon, its places in pixels. Where polygons overlap, what winds around a place counts: two that wind
    /// the same way cover as one.
    void add(std::span<const Place> polygon);

    /// A box winds to the right.
    void add(const CoveredBox& box);

    /// What AGG makes of lines and ellipses.
    template <typename Outline> void add_outline(Outline& outline) {
        double x = 0;
        double y = 0;
        outline.rewind(0);
        for (unsigned command = outline.vertex(&x, &y); !agg::is_stop(command);
             command = outline.vertex(&x, &y))
            rasterizer_.add_vertex(x, y, command);
    }

    /// Tells what is covered, row by row from the top, and forgets it.
    void for_each_run(const std::function<void(const CoverageRun&)>& tell);

    int width() const { return width_; }
    int height() const { return height_; }

private:
    int width_;
    int height_;
    agg::rasterizer_scanline_aa<agg::rasterizer_sl_clip_dbl> rasterizer_;
    agg::scanline_p8 line_;
};

} // namespace rastertrace
