// SPDX-License-Identifier: MIT
#pragma once

// What the steps of a part of a trace amount to: all that does not depend on the steps in front of it, for one of several
// threads, and what was done to pixels, in turn, for who knows the picture.
//
//     PartCounts part(trace, primitives, drawn);
//     part.take(reader, 1, 100);
//     part.writes;

#include "coverage.h"
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
    void add(const std::string& kind_name, std::uint64_t count);
    void add(const KindCounts& behind);

    const std::vector<std::pair<std::string, std::uint64_t>>& all() const { return count_; }

private:
    std::vector<std::pair<std::string, std::uint64_t>> count_;
    std::array<std::size_t, step_kinds> known_{};         ///< places in `count_`, from 1
    std::unordered_map<std::string, std::size_t> places_; ///< the same of all kinds
};

/// What a step did to a pixel.
struct PixelEvent {
    enum class What : std::uint8_t {
        begin, ///< to none: the next primitive begins
        draw,  ///< it has a color
        pass,  ///< a depth test was passed
        tie,   ///< one was failed, at just the depth that is stored
    };
    What what = What::begin;
    Pixel pixel{}; ///< of the canvas
    Color color{}; ///< of `draw`, and of the primitive that failed
};

class PartCounts {
public:
    /// What is told of its primitives is put there; `over` and `coverage` are not.
    PartCounts(const Trace& trace, std::span<PrimitiveStats> primitives,
               std::span<DrawnPrimitive> drawn);

    /// Takes the steps from `first` to before `end`: whole primitives, or the last ones of the trace.
    void take(const StepReader& steps, std::size_t first, std::size_t end);

    KindCounts kinds;
    std::uint64_t writes = 0; ///< pixel steps on the canvas
    RowCheck rows;
    StatsNeeds needs;
    std::vector<PixelEvent> events; ///< in turn

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
    std::size_t begun_ = 0; ///< so many of them
    DrawnPixels pixels_;    ///< of the current primitive
    Color color_;           ///< of it
    bool has_rows_;         ///< and they are looked at
};

} // namespace rastertrace
