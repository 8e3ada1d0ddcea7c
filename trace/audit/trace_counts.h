// SPDX-License-Identifier: MIT
#pragma once

// Goes through the steps of a trace and counts them.
//
//     TraceCounts counts(trace, stats);
//     for (std::size_t n = 1; n <= trace.size(); ++n)
//         counts.take(n);
//     counts.finish();
//     counts.drawn();

#include "coverage.h"
#include "row_check.h"
#include "stats.h"
#include "stats_needs.h"

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/record/trace.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rastertrace {

/// Counts steps by their kind, in order of appearance. A trace may hold as many kinds as it has steps.
class KindCounts {
public:
    void add(StepKind kind);
    void add(const std::string& kind_name) { ++count_[place_of(kind_name) - 1].second; }

    const std::vector<std::pair<std::string, std::uint64_t>>& all() const { return count_; }

private:
    /// The place of a kind in `count_`, from 1.
    std::size_t place_of(const std::string& kind_name);

    std::vector<std::pair<std::string, std::uint64_t>> count_;
    std::array<std::size_t, step_kinds> known_{};         ///< places of known kinds; 0: not yet
    std::unordered_map<std::string, std::size_t> places_; ///< of all kinds
};

class TraceCounts {
public:
    /// Fills in `stats`, but for what is compared with corners, and what is told of the picture.
    TraceCounts(const Trace& trace, Stats& stats);

    /// Takes step n; they come in order.
    void take(std::size_t n);

    /// Behind the last step. The last row of a trace that is cut off is not judged: its pixels may be missing.
    void finish();

    /// What each primitive has drawn.
    std::vector<DrawnPrimitive>& drawn() { return drawn_; }

    const Image& picture() const { return picture_; }

private:
    void count(const PrimitiveStep& begun, std::size_t n);
    void count(const SkipStep& skip);
    void count(const ScanlineStep& row, std::size_t n);
    void count(const PixelStep& step);
    void count(const DepthStep& test);
    void finish_primitive();

    PrimitiveStats& primitive() { return stats_.primitives.back(); }

    const Trace& trace_;
    Stats& stats_;
    KindCounts kinds_;
    RowCheck rows_;
    StatsNeeds needs_;
    std::vector<DrawnPrimitive> drawn_;
    std::vector<std::uint32_t> pixels_; ///< offsets, of the current primitive
    std::vector<std::uint32_t> hidden_; ///< the same of those that failed the depth test
    Color color_;                       ///< of the current primitive
    bool has_rows_;                     ///< rows of the current primitive are judged
    Image picture_;
    std::vector<bool> is_tied_; ///< pixels where a depth test was a tie that decided what is seen
};

} // namespace rastertrace
