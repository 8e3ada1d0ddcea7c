// SPDX-License-Identifier: MIT
#include "coverage.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace rastertrace {

namespace {

/// Cells are the pixels that an outline goes through. AGG leaves out what is beyond its limit: so that is far away, at
/// four gigabytes.
constexpr unsigned most_blocks_of_cells = 1U << 16;

/// AGG tells 0 to 255.
int level_of(int cover) {
    constexpr int most = 255;
    return (cover * full_coverage + most / 2) / most;
}

} // namespace

PixelCoverage::PixelCoverage(int width, int height)
    : width_(width), height_(height), rasterizer_(most_blocks_of_cells) {
    rasterizer_.clip_box(0, 0, width, height);
}

void PixelCoverage::add(std::span<const Place> polygon) {
    if (polygon.empty())
        return;
    rasterizer_.move_to_d(polygon[0].x, polygon[0].y);
    for (const Place& place : polygon.subspan(1))
        rasterizer_.line_to_d(place.x, place.y);
    rasterizer_.close_polygon();
}

void PixelCoverage::add(const CoveredBox& box) {
    if (box.left < box.right)
        add(std::array<Place, 4>{{{box.left, box.top},
                                  {box.right, box.top},
                                  {box.right, box.bottom},
                                  {box.left, box.bottom}}});
}

void PixelCoverage::for_each_run(const std::function<void(const CoverageRun&)>& tell) {
    const auto tell_part = [&](int begin, int length, int cover) {
        const CoverageRun run{line_.y(), begin, std::min(begin + length, width_), level_of(cover)};
        if (run.level > 0 && run.begin < run.end)
            tell(run);
    };
    if (rasterizer_.rewind_scanlines()) {
        line_.reset(rasterizer_.min_x(), rasterizer_.max_x());
        while (rasterizer_.sweep_scanline(line_) && line_.y() < height_) {
            auto span = line_.begin();
            for (unsigned i = 0; i < line_.num_spans(); ++i, ++span)
                if (span->len < 0)
                    tell_part(span->x, -span->len, *span->covers);
                else
                    for (int k = 0; k < span->len; ++k)
                        tell_part(span->x + k, 1, span->covers[k]); // NOLINT: an array of C
        }
    }
    rasterizer_.reset();
}

} // namespace rastertrace
