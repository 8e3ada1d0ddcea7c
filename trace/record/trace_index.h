// SPDX-License-Identifier: MIT
#pragma once

// The index of a trace: a file beside it that tells where its steps are, what a replay is at from time to time, and
// which pixels its primitives reach. With it a step and a pixel's history are found without reading the rest.
//
//     const auto index = TraceIndex::open(path_of_index("a.jsonl"), source); // throws a Problem: it fits no more
//     const Trace trace = read_trace(source, {.index = index}).value();       // at once
//
// It is never trusted: it fits a trace of the same size, header and end, and each part, of the trace and of itself, is
// held against its checksum when it is first looked at. The numbers in the file have the byte order of the machine; one
// of another order is no index.

#include "frame.h"
#include "step_counts.h"

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/text/mapped_file.h>
#include <rastertrace/trace/text/problem.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// Thrown where a trace, or its index, turns out to be another one than was indexed: read without it.
struct StaleIndex : std::exception {
    const char* what() const noexcept override { return "the index does not fit its trace"; }
};

/// Whole lines of a trace, each with a step as StepWriter writes it.
struct IndexedBlock {
    std::uint64_t offset = 0;   ///< of the first, in the text
    std::uint32_t first = 0;    ///< its step
    std::uint32_t checksum = 0; ///< of the text up to the next block
};

/// What keeps a primitive, or a part of one, from a pixel that none of its steps is about.
enum class UnitRule : std::uint8_t {
    ask,   ///< only its steps tell
    edges, ///< three edge functions: a, b, c of each, with the normal (a, b) of length 1
    rows, ///< least and largest y of its rows, least `from`, largest `to`, least and largest y of its corners
    box,     ///< the box of its corners: least and largest x, least and largest y
    nothing, ///< the same reason for all pixels, without a distance
};

/// Such reasons; WhyNot has their names.
enum class FarReason : std::uint8_t { outside, unpainted, culled, clipped, skipped, unknown };
inline constexpr std::size_t far_reasons = 6;

/// A primitive, or a part of one, as the question about a pixel needs it.
struct PixelUnit {
    std::uint32_t first = 0; ///< its `primitive` step
    UnitRule rule = UnitRule::ask;
    FarReason reason = FarReason::outside;
    bool is_part = false; ///< of the last one that is none
    std::uint8_t unused = 0;

    /// The columns and rows of the canvas that its steps are about: from, to; none if from is larger.
    std::array<std::int16_t, 2> columns{1, 0};
    std::array<std::int16_t, 2> rows{1, 0};
    std::array<float, 9> values{}; ///< of its rule

    friend bool operator==(const PixelUnit&, const PixelUnit&) = default;
};

struct PixelUnits {
    bool are_known = false; ///< false: steps are missing, or come in no usual order
    std::vector<PixelUnit> units{};
    std::array<std::uint64_t, far_reasons>
        others{}; ///< primitives about no pixel: how many of each reason
};

/// True for steps that belong to no primitive: all up to the first, and those about the whole scene. `vertex` steps
/// are found by name.
constexpr bool is_loose(StepKind kind, bool is_behind_primitive) {
    return !is_behind_primitive || kind == StepKind::matrix || kind == StepKind::order;
}

/// How fine an index is. Small ones are for tests.
struct IndexGrain {
    std::size_t block = 1 << 16;    ///< bytes of the trace
    std::size_t keyframe = 1 << 17; ///< steps from one to the next, at least
    std::size_t share_of_frames =
        4; ///< what keyframes may take, in percent of the trace; 0: all are kept
};

class TraceIndex {
public:
    /// Opens the index of a trace that is in a file. Throws a Problem that says why it cannot be used.
    static std::shared_ptr<const TraceIndex> open(const std::string& path, const Source& trace);

    /// Where the lines of steps end in the text of the trace.
    std::size_t end_of_steps() const { return head_.end_of_steps; }
    std::size_t steps() const { return head_.steps; }
    const StepCounts& counts() const { return counts_; }
    std::span<const IndexedBlock> blocks() const { return section<IndexedBlock>(Part::blocks); }

    /// The primitives of the trace, by number of their step.
    std::span<const std::uint32_t> primitives() const {
        return section<std::uint32_t>(Part::primitives);
    }

    /// The primitive that a step belongs to; 0 if there is none.
    std::size_t primitive_of(std::size_t step) const;

    /// The steps that belong to no primitive, without `vertex` steps.
    std::span<const std::uint32_t> loose_steps() const {
        return section<std::uint32_t>(Part::loose);
    }

    /// The `vertex` steps of one name, in order; perhaps with a few of other names.
    std::vector<std::size_t> vertex_steps(std::string_view name) const;

    bool knows_units() const { return head_.knows_units != 0; }
    std::span<const PixelUnit> units() const { return section<PixelUnit>(Part::units); }
    const std::array<std::uint64_t, far_reasons>& other_units() const { return head_.others; }

    /// The last keyframe up to step n, if it lies far behind another step.
    std::optional<ReplayState> keyframe(std::size_t n, std::size_t behind,
                                        const Canvas& canvas) const;

private:
    friend class IndexWriter;

    enum class Part : std::uint8_t { blocks, primitives, loose, vertices, units, keyframes };
    static constexpr std::size_t parts = 6;

    struct Place {
        std::uint64_t offset = 0;
        std::uint64_t size = 0;
        std::uint32_t checksum = 0;
        std::uint32_t unused = 0;
    };
    struct Keyframe {
        Place place;
        std::uint64_t step = 0;
        std::uint64_t size = 0; ///< unpacked
    };
    struct Vertex {
        std::uint32_t name = 0; ///< its checksum
        std::uint32_t step = 0;
    };

    /// The end of the file: what is known last.
    struct Head {
        std::uint64_t magic = 0;
        std::uint64_t trace_size = 0;
        std::uint64_t begin_of_steps = 0;
        std::uint64_t end_of_steps = 0;
        std::uint64_t steps = 0;
        std::uint64_t far =
            0; ///< a keyframe at most so many steps ahead is not unpacked: playing them is quicker
        std::uint32_t header_checksum = 0; ///< of the trace, up to its first step
        std::uint32_t end_checksum = 0;    ///< from its last step on
        std::array<std::uint64_t, step_kinds> counts{};
        std::array<Place, parts> places{};
        std::array<std::uint64_t, far_reasons> others{};
        std::uint32_t knows_units = 0;
        std::uint32_t checksum = 0; ///< of all above
    };

    std::string_view bytes_at(const Place& place) const;
    std::string_view checked(Part part) const;
    template <typename Item> std::span<const Item> section(Part part) const {
        const std::string_view bytes = checked(part);
        return {reinterpret_cast<const Item*>(bytes.data()), bytes.size() / sizeof(Item)};
    }

    std::shared_ptr<const MappedFile> file_;
    Head head_;
    StepCounts counts_;
    mutable std::array<bool, parts> is_checked_{};
};

/// The name of the index of a trace.
inline std::string path_of_index(const std::string& trace) {
    return trace + ".index";
}

/// Writes the index of a trace that has been read whole. Throws a Problem; one is that not each of its lines is written
/// as rastertrace writes it, or that something is wrong with it.
void write_index(const Trace& trace, const PixelUnits& units, const std::string& path,
                 const IndexGrain& grain = {});

} // namespace rastertrace
