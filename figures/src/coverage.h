// SPDX-License-Identifier: MIT
#pragma once

// How much of each pixel of a bitmap polygons cover, together. All machines find the same: doubles are added,
// multiplied and compared here, nothing else, and coverage is counted in whole numbers.
//
//     PixelCoverage coverage(width, height);
//     coverage.add(places);
//     coverage.for_each_run([&](const CoverageRun& run) { ... });

#include <rastertrace/figures/drawing.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

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
    PixelCoverage(int width, int height) : width_(width), height_(height) {}

    /// A polygon, its places in pixels. Where polygons overlap, what winds around a place counts: two that wind
    /// the same way cover as one.
    void add(std::span<const Place> polygon);

    /// One that winds to the right, however its places are given.
    void add_positive(std::span<const Place> polygon);

    /// A box winds to the right.
    void add(const CoveredBox& box);

    /// Tells what is covered, row by row from the top, and forgets it.
    void for_each_run(const std::function<void(const CoverageRun&)>& tell);

    int width() const { return width_; }
    int height() const { return height_; }

private:
    /// From the top down.
    struct Edge {
        double x; ///< at the top
        double y; ///< of the top
        double slope;
        std::int64_t first; ///< line of samples
        std::int64_t end;   ///< the one behind the last one
        int winding;        ///< 1 for an edge that was given downward, -1 for one upward
    };
    /// Where an edge meets a line of samples, in 256ths of a pixel.
    struct Crossing {
        std::int64_t x;
        int winding;
    };

    void add_edge(Place from, Place to);
    void add_line(std::int64_t line, int weight);
    void tell_row(int y, const std::function<void(const CoverageRun&)>& tell);

    int width_;
    int height_;
    std::vector<Edge> edges_;
    std::vector<Edge> active_;
    std::vector<Crossing> crossings_;
    std::vector<int> steps_; ///< what each pixel of the row covers more than the one before
};

} // namespace rastertrace
