// SPDX-License-Identifier: MIT
#pragma once

// Which pixels the triangles of a scene cover, and in how many pixels two such results differ.

#include "job_builder.h"

#include <rastertrace/core/draw/plan/plan.h>
#include <rastertrace/core/draw/scene/scene.h>
#include <rastertrace/numerics/report.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rastertrace {

/// Keeps the pixels that are drawn, and counts those that are asked for.
struct PixelSink {
    const Canvas& canvas;
    std::vector<std::size_t>& pixels;
    std::uint64_t tested = 0;

    template <typename Step> void operator()(const Step&) {}
    void operator()(const PixelPlotted<>& step) {
        pixels.push_back(canvas.offset_of(step.pixel()));
    }
    template <typename Scalar> void operator()(const SampleTested<Scalar>& sample) {
        ++tested;
        if (sample.inside)
            pixels.push_back(canvas.offset_of(sample.pixel()));
    }
    template <typename Scalar> void operator()(const ScanlineSpanned<Scalar>& span) {
        const Index last = std::min<Index>(span.to, canvas.right());
        for (Index x = std::max<Index>(span.from, canvas.left()); x <= last; ++x)
            pixels.push_back(canvas.offset_of({static_cast<int>(x), span.y}));
    }

    /// What is worked out only to be told would be counted as work.
    template <typename Step> bool takes() const { return false; }
};

/// How many pixels a fill has asked for. Those that go by rows ask only for the pixels that they draw.
std::uint64_t pixels_tested(const Scene& scene, const PixelSink& sink, std::uint64_t drawn);

/// The pixels of each primitive, in order, each once.
using PixelSets = std::vector<std::vector<std::size_t>>;

void sort_sets(PixelSets& sets);

/// The pixels that the scene's fill covers in the scalar of its plan, and the operations it takes; nothing if that is `adaptive`.
struct CountedPixels {
    PixelSets pixels;
    Work work;
};
CountedPixels counted_pixels(const Scene& scene, const Plan& plan);

/// What exact arithmetic makes of the triangles once their positions have been snapped to the plan's numbers.
PixelSets pixels_when_snapped(const Scene& scene, const Plan& plan);

std::uint64_t size_of(const PixelSets& sets);

/// How many pixels one has and the other has not, primitive by primitive.
std::uint64_t differing(const PixelSets& a, const PixelSets& b);

/// How many pixels of primitives have a neighbor, beside, above or below, that is not theirs.
std::uint64_t perimeter_of(const PixelSets& sets, const Canvas& canvas);

} // namespace rastertrace
