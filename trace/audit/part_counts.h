// SPDX-License-Identifier: MIT
#pragma once

// Counts the steps of a part of a trace, in one of several threads. What depends on the parts in front of it, the picture,
// is left as a list of events, which are taken in order.
//
//     PartCounts part(trace, primitives, drawn);
//     part.take(reader, 1, 100);
//     part.finish(true);
//     part.writes;

#include "drawn_primitive.h"
#include "row_check.h"
#include "stats.h"
#include "stats_needs.h"

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/record/trace.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
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
    void add(const KindCounts& behind);

    const std::vector<std::pair<std::string, std::uint64_t>>& all() const { return count_; }

private:
    /// The place of a kind in `count_`, from 1.
    std::size_t place_of(const std::string& kind_name);

    std::vector<std::pair<std::string, std::uint64_t>> count_;
    std::array<std::size_t, step_kinds> known_{};         ///< places of known kinds; 0: not yet
    std::unordered_map<std::string, std::size_t> places_; ///< of all kinds
};

/// What a step did to a pixel.
struct PixelEvent {
    enum class What : std::uint8_t {
        begin, ///< to none: a primitive begins
        draw,  ///< the pixel is drawn
        pass,  ///< a depth test passes
        tie,   ///< a depth test fails, at the depth that is stored, as both are written
    };
    What what = What::begin;
    Pixel pixel{}; ///< of the canvas; means nothing for `begin`
    Color color{}; ///< that is drawn; of a tie, that of the primitive
};

class PartCounts {
public:
    /// Fills in `primitives`, but for `over` and `coverage`, and `drawn`: those of this part.
    PartCounts(const Trace& trace, std::span<PrimitiveStats> primitives,
               std::span<DrawnPrimitive> drawn);

    /// Takes the steps from `first` to before `end`.
    void take(const StepReader& steps, std::size_t first, std::size_t end);

    /// Behind the last step of the part. The last row of a trace that is cut off is not judged: its pixels may be missing.
    void finish(bool is_whole);

    KindCounts kinds;
    std::uint64_t writes = 0; ///< pixel steps on the canvas
    RowCheck rows;
    StatsNeeds needs;
    std::vector<PixelEvent> events; ///< since they were last cleared

private:
    void count(const PrimitiveStep& begun, std::size_t n);
    void count(const SkipStep& skip);
    void count(const ScanlineStep& row, std::size_t n);
    void count(const PixelStep& step);
    void count(const DepthStep& test);
    void finish_primitive();

    PrimitiveStats& primitive() { return primitives_[begun_ - 1]; }

    const Trace& trace_;
    std::span<PrimitiveStats> primitives_;
    std::span<DrawnPrimitive> drawn_;
    std::size_t begun_ = 0; ///< primitives
    DrawnPixels pixels_;    ///< of the current primitive
    Color color_;           ///< of the current primitive
    bool has_rows_;         ///< rows of the current primitive are judged
};

} // namespace rastertrace
