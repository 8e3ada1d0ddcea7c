// SPDX-License-Identifier: MIT
#pragma once

// Certify first, then paint: the rows of a fill in filtered doubles are kept until every decision about
// the triangle has been taken.
//
//     CertainRows rows;
//     if (!left_open_by([&] { fill_top_left(triangle, grid, canvas, rows); }))
//         rows.paint_with(painter, [&](const auto& again) { fill_top_left(triangle, grid, canvas, again); });

#include <rastertrace/core/numbers/adaptive.h>
#include <rastertrace/core/raster/steps.h>

#include <optional>
#include <vector>

namespace rastertrace {

/// Runs what may leave something open; tells what.
template <typename Run> std::optional<Undecided> left_open_by(Run&& run) {
    try {
        run();
        return std::nullopt;
    } catch (const Undecided& undecided) {
        return undecided;
    }
}

/// The rows that a fill yields, kept until all of them are certain. What comes pixel by pixel is too much
/// to keep: its decisions are taken again.
class CertainRows {
public:
    template <typename Step> void operator()(const Step&) {}
    void operator()(const ScanlineSpanned<Adaptive>& span) { spans_.push_back(span); }
    void operator()(const SampleTested<Adaptive>&) { has_pixels_ = true; }
    void operator()(const PixelPlotted&) { has_pixels_ = true; }
    void operator()(const PrimitiveSkipped& step) { skipped_ = step; }

    template <typename Step> bool takes() const { return false; }

    void clear() {
        spans_.clear();
        has_pixels_ = false;
        skipped_.reset();
    }

    /// Why the primitive draws nothing, if it does not.
    const std::optional<PrimitiveSkipped>& skipped() const { return skipped_; }

    /// Hands all of it to a painter; `yield_again(painter)` if not all has been kept.
    template <typename Painter, typename YieldAgain>
    void paint_with(Painter&& painter, YieldAgain&& yield_again) const {
        if (has_pixels_)
            return yield_again(painter);
        for (const auto& span : spans_)
            painter(span);
    }

private:
    std::vector<ScanlineSpanned<Adaptive>> spans_;
    bool has_pixels_ = false;
    std::optional<PrimitiveSkipped> skipped_;
};

} // namespace rastertrace
