// SPDX-License-Identifier: MIT
#pragma once

// Pictures of a trace kept from time to time, so that a replay goes back as fast as forward, in bounded memory.
//
//     Snapshots snapshots(trace, parts);
//     while (snapshots.read_on(100'000)) {}
//     Replay replay(trace, parts);
//     snapshots.go_to(replay, 5'000'000);
//
// What has not changed from one picture to the next is kept once. When the memory is full every second picture is
// dropped, and from then on they are twice as far apart.

#include "frame.h"
#include "trace.h"

#include <rastertrace/core/raster/image.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace rastertrace {

class Snapshots {
public:
    static constexpr std::size_t usual_bytes = 256'000'000;

    /// Pictures of a trace, which may still grow, with these parts, in at most so many bytes: of one picture at least,
    /// whatever it takes.
    Snapshots(const Trace& trace, FrameParts parts, std::size_t most_bytes = usual_bytes)
        : ahead_(trace, parts), most_bytes_(most_bytes) {}

    /// Goes through so many steps more, as far as the trace has them; false if there is none.
    bool read_on(std::size_t steps);

    /// The last step that it went through: up to here a replay comes quickly.
    std::size_t reach() const { return ahead_.step(); }

    /// A replay at that step.
    const Replay& farthest() const { return ahead_; }

    /// Takes a replay of the same trace and parts to step n.
    void go_to(Replay& replay, std::size_t n) const;

    /// What the pictures take, and how many steps there are from one to the next.
    std::size_t bytes() const { return bytes_; }
    std::size_t interval() const { return interval_; }

private:
    /// A part of a frame, with a value for each pixel of it. Steps have 32 bits: a trace of more has some 300 GB.
    struct Tile {
        std::vector<Color> colors;
        std::vector<std::uint32_t> drawn_by;
        std::vector<std::uint32_t> writes;
        std::vector<std::uint32_t> stored_by;

        std::size_t bytes() const;
    };
    using Tiles = std::vector<std::shared_ptr<const Tile>>; ///< nullptr: blank

    struct Snapshot {
        Replay::Place place;
        Tiles tiles;
    };

    static std::shared_ptr<const Tile> tile_of(const Frame& frame, std::size_t tile);
    static std::size_t bytes_beside_tiles(const Snapshot& snapshot);
    static void restore(Frame& frame, std::size_t tile, const Tile* from);
    void restore(Replay& replay, const Snapshot& snapshot) const;
    void keep();
    void drop_every_second();

    Replay ahead_;
    std::vector<Snapshot> kept_; ///< one every `interval_` steps
    std::size_t interval_ = 1 << 12;
    std::size_t bytes_ = 0;
    std::size_t most_bytes_;
};

} // namespace rastertrace
