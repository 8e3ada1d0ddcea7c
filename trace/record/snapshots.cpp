// SPDX-License-Identifier: MIT
#include "snapshots.h"

#include <algorithm>
#include <utility>

namespace rastertrace {

namespace {

/// The pixels of a tile: from the first to one behind the last.
struct TileRange {
    std::size_t begin;
    std::size_t end;
};

TileRange range_of(std::size_t tile, std::size_t size, std::size_t pixels) {
    return {tile * size, std::min((tile + 1) * size, pixels)};
}

/// Some elements of a vector; none of one that has none.
template <typename To, typename From>
std::vector<To> part_of(const From& values, const TileRange& range) {
    std::vector<To> part;
    if (values.empty())
        return part;
    part.reserve(range.end - range.begin);
    for (std::size_t i = range.begin; i < range.end; ++i)
        part.push_back(static_cast<To>(values[i]));
    return part;
}

/// Puts a part back into `values`; without one, what a blank frame has.
template <typename To, typename From>
void put_back(To* values, const TileRange& range, const std::vector<From>* part, To blank = {}) {
    if (part == nullptr)
        std::fill(values + range.begin, values + range.end, blank);
    else
        std::transform(part->begin(), part->end(), values + range.begin,
                       [](const From& value) { return static_cast<To>(value); });
}

} // namespace

std::size_t Snapshots::Tile::bytes() const {
    return sizeof(Tile) + colors.size() * sizeof(Color) +
           (drawn_by.size() + writes.size() + stored_by.size()) * sizeof(std::uint32_t);
}

std::shared_ptr<const Snapshots::Tile> Snapshots::tile_of(const Frame& frame, std::size_t tile) {
    const TileRange range = range_of(tile, Replay::tile_size, frame.drawn_by.size());
    return std::make_shared<const Tile>(
        Tile{.colors = part_of<Color>(frame.image.colors(), range),
             .drawn_by = part_of<std::uint32_t>(frame.drawn_by, range),
             .writes = part_of<std::uint32_t>(frame.writes, range),
             .stored_by = part_of<std::uint32_t>(frame.stored_by, range)});
}

void Snapshots::restore(Frame& frame, std::size_t tile, const Tile* from) {
    const TileRange range = range_of(tile, Replay::tile_size, frame.drawn_by.size());
    Color* const colors = frame.image.row(frame.image.canvas().top()).colors;
    put_back(colors, range, from ? &from->colors : nullptr, no_color);
    put_back(frame.drawn_by.data(), range, from ? &from->drawn_by : nullptr);
    if (!frame.writes.empty())
        put_back(frame.writes.data(), range, from ? &from->writes : nullptr);
    if (!frame.stored_by.empty())
        put_back(frame.stored_by.data(), range, from ? &from->stored_by : nullptr);
}

bool Snapshots::read_on(std::size_t steps) {
    const std::size_t last = std::min(ahead_.trace().size(), reach() + steps);
    if (last == reach())
        return false;
    while (reach() < last) {
        ahead_.go_to(std::min(last, (reach() / interval_ + 1) * interval_));
        if (reach() % interval_ == 0)
            keep();
    }
    return true;
}

void Snapshots::keep() {
    Snapshot snapshot{ahead_.place_,
                      kept_.empty() ? Tiles(ahead_.has_changed_.size()) : kept_.back().tiles};
    for (std::size_t tile = 0; tile < snapshot.tiles.size(); ++tile)
        if (std::exchange(ahead_.has_changed_[tile], 0) != 0) {
            snapshot.tiles[tile] = tile_of(ahead_.frame(), tile);
            bytes_ += snapshot.tiles[tile]->bytes();
        }
    bytes_ += bytes_beside_tiles(snapshot);
    kept_.push_back(std::move(snapshot));
    while (bytes_ > most_bytes_ && kept_.size() > 1)
        drop_every_second();
}

std::size_t Snapshots::bytes_beside_tiles(const Snapshot& snapshot) {
    return sizeof(Snapshot) + snapshot.tiles.size() * sizeof(Tiles::value_type) +
           snapshot.place.edges.size() * sizeof(std::size_t);
}

void Snapshots::drop_every_second() {
    interval_ *= 2;
    const Tiles newest = kept_.back().tiles;
    std::erase_if(
        kept_, [this](const Snapshot& snapshot) { return snapshot.place.step % interval_ != 0; });
    // What the newest picture had that is not in the last one any more has to be kept next time.
    for (std::size_t tile = 0; tile < newest.size(); ++tile)
        if (newest[tile] != (kept_.empty() ? nullptr : kept_.back().tiles[tile]))
            ahead_.has_changed_[tile] = 1;
    bytes_ = 0;
    for (std::size_t i = 0; i < kept_.size(); ++i) {
        bytes_ += bytes_beside_tiles(kept_[i]);
        for (std::size_t tile = 0; tile < kept_[i].tiles.size(); ++tile)
            if (const auto& own = kept_[i].tiles[tile];
                own && (i == 0 || own != kept_[i - 1].tiles[tile]))
                bytes_ += own->bytes();
    }
}

void Snapshots::go_to(Replay& replay, std::size_t n) const {
    // The last picture up to step n, if it lies nearer than where the replay is.
    const auto behind = std::upper_bound(
        kept_.begin(), kept_.end(), n,
        [](std::size_t step, const Snapshot& snapshot) { return step < snapshot.place.step; });
    const bool is_on_the_way = replay.step() <= n && (behind == kept_.begin() ||
                                                      (behind - 1)->place.step <= replay.step());
    if (!is_on_the_way && behind != kept_.begin())
        restore(replay, *(behind - 1));
    replay.go_to(n);
}

void Snapshots::restore(Replay& replay, const Snapshot& snapshot) const {
    for (std::size_t tile = 0; tile < snapshot.tiles.size(); ++tile) {
        const Tile* const kept = snapshot.tiles[tile].get();
        if (kept != nullptr || replay.has_changed_[tile] != 0)
            restore(replay.frame_, tile, kept);
        replay.has_changed_[tile] = kept != nullptr;
    }
    replay.place_ = snapshot.place;
    const auto know = [](std::vector<std::size_t>& list, const std::vector<std::size_t>& all,
                         std::size_t count) {
        if (list.size() < count)
            list.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    };
    know(replay.primitives_, ahead_.primitives_, snapshot.place.primitives);
    know(replay.matrices_, ahead_.matrices_, snapshot.place.matrices);
}

} // namespace rastertrace
