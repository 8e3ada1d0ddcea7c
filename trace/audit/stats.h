// SPDX-License-Identifier: MIT
#pragma once

// What a trace amounts to: how many steps, pixels, and pixels drawn again; and what its triangles
// should have drawn and did not, or did draw and should not have.
//
//     const Stats stats = stats_of(trace);
//     stats.primitives[0].coverage->holes.count;
//
// What a triangle should have drawn is found from the positions in its primitive step alone, by its
// edge functions. A pixel is judged by its sample point: its integer point, or (1/2, 1/2) from
// there when the method says "sample":"center". Numbers of a trace are read as the doubles, or
// floats, which they stand for. Where they leave open on which side of an edge a sample lies, it
// counts as neither inside nor outside.

#include <rastertrace/trace/record/trace.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

/// How many pixels of each finding are kept; the rest are only counted.
inline constexpr std::size_t most_pixels_kept = 1000;

/// Where more triangles than this meet at one edge, only the first of them are compared: there are
/// about half as many pairs as the square of this, and a sound mesh has one.
inline constexpr std::size_t most_compared = 8;

/// Pixels that something was found about.
struct PixelList {
    std::uint64_t count = 0;
    std::vector<Pixel> kept; ///< the first ones, from the top row of the picture, left to right

    /// Counts a pixel, and keeps it if it is among the first.
    void add(Pixel pixel) {
        if (++count <= most_pixels_kept)
            kept.push_back(pixel);
    }
};

/// What a triangle drew against what it covers.
struct Coverage {
    PixelList holes; ///< not drawn, though the sample point lies strictly inside
    PixelList
        outside; ///< drawn, or hidden, though the sample point lies outside the closed triangle
};

/// What one primitive drew.
struct PrimitiveStats {
    std::size_t step = 0; ///< the number of its primitive step
    std::string kind;
    std::string name;
    std::uint64_t writes = 0; ///< pixel steps
    std::uint64_t pixels = 0; ///< different pixels among them
    std::uint64_t over = 0;   ///< writes onto pixels that were drawn already
    std::uint64_t hidden = 0; ///< pixels that failed the depth test and that it has not drawn
    std::string skipped;      ///< why it drew nothing, if it was skipped
    std::optional<Coverage> coverage; ///< of a triangle with area whose positions are known
};

/// Two triangles that have an edge in common: the same two end positions, in either order. If both
/// lie on one side of it, it is a fold, and they cover the same pixels.
struct SharedEdge {
    // Triangles by their places in Stats::primitives.
    std::uint32_t one = 0;                     ///< the one drawn first
    std::uint32_t other = 0;                   ///< and the one drawn later
    std::uint32_t named_by = 0;                ///< the first one that has the edge
    std::array<std::uint8_t, 2> vertices = {}; ///< the ends of the edge in that one, 0 to 2

    PixelList twice = {}; ///< that both have drawn; none at a fold

    /// That neither has drawn, near the edge. The sample point lies strictly inside one of the
    /// triangles, or on the edge but not on its ends, unless it is a fold. Near: at most one pixel
    /// from the edge, up or down where the edge is flatter than 45 degrees (or just that), to the
    /// left or right where it is steeper.
    PixelList never = {};
};

/// A scanline step that the steps behind it do not agree with: the pixels from `from` to `to` should
/// have been plotted, hidden or rejected, each once, and no others.
struct WrongRow {
    std::size_t step = 0;
    std::string primitive;
    Index y = 0;
    Index from = 0;
    Index to = 0;
    std::uint64_t missing = 0; ///< of the pixels from `from` to `to`
    std::uint64_t others = 0;  ///< pixels that are none of these, or come again
};

/// What `stats` can be asked to fail on.
enum class StatsFinding {
    holes,   ///< pixels inside a triangle, or between two, that none has drawn
    twice,   ///< pixels that both triangles at an edge have drawn
    outside, ///< pixels drawn outside of their triangle
    rows,    ///< scanline steps that the steps behind them do not agree with
    redo,    ///< decisions that are not those that their numbers give: see redo.h
};

/// Those that stats_of judges by.
inline constexpr std::array stats_findings{StatsFinding::holes, StatsFinding::twice,
                                           StatsFinding::outside, StatsFinding::rows};

inline constexpr std::array<std::string_view, 5> finding_names{"holes", "twice", "outside", "rows",
                                                               "redo"};
std::string names_of(const std::vector<StatsFinding>& findings); ///< "holes, twice"

/// Findings that a trace cannot be judged by.
struct Unjudged {
    std::vector<StatsFinding> findings;
    std::string lacks; ///< `expected "at", ..., found none`
};

/// Where the sample points are, by the pixels of a trace that does not say so.
struct FoundSample {
    bool is_center = false;    ///< by which all is judged
    bool explains_all = false; ///< it does, and the other one does not; false: neither does
};

struct Stats {
    std::uint64_t steps = 0;
    std::vector<std::pair<std::string, std::uint64_t>> count; ///< by kind, in order of appearance
    std::uint64_t canvas = 0;                                 ///< pixels that the canvas has
    std::uint64_t pixels = 0;                                 ///< different pixels drawn
    std::uint64_t writes = 0;                                 ///< pixel steps on the canvas
    std::vector<PrimitiveStats> primitives;
    std::vector<SharedEdge> edges; ///< every pair of triangles with area at every edge
    std::vector<WrongRow> wrong_rows;
    std::vector<Unjudged> unjudged;

    /// If the trace does not tell it, and not both of them explain all pixels.
    std::optional<FoundSample> sample;

    /// Where a triangle of another color had just the depth of the one that is seen, and came too
    /// late: drawn in another order, the picture would be another one.
    PixelList depth_ties;
    std::string frame;          ///< name of the final picture, see frame_name
    bool frame_differs = false; ///< the end record names another picture
};

/// An edge as the first triangle that has it names its vertices: "AC".
std::string name_of(const SharedEdge& edge, const Stats& stats, const Trace& trace);

/// Counts, and compares what was drawn with what should have been. Nothing is compared in a trace
/// that steps were left out of, nor is the last primitive of a truncated trace: pixels that are
/// missing there were not necessarily missed.
Stats stats_of(const Trace& trace);

} // namespace rastertrace
