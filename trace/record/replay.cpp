// SPDX-License-Identifier: MIT
#include "replay.h"

#include <algorithm>
#include <utility>

namespace rastertrace {

Replay::Replay(const Trace& trace, FrameParts parts, std::size_t most_bytes)
    : StepContext(trace), frame_(trace.canvas, parts),
      changed_by_(frame_.drawn_by.size() / tile_size + 1), shared_(std::make_shared<Shared>()) {
    shared_->most_bytes = most_bytes;
}

void Replay::go_to(std::size_t n) {
    std::vector<Keyframe>& kept = shared_->keyframes;
    if (n < step() && kept.empty())
        kept.emplace_back().tiles.assign(changed_by_.size(), blank_tile());
    if (!kept.empty()) {
        const Keyframe& nearest = *std::prev(std::upper_bound(
            kept.begin(), kept.end(), n,
            [](std::size_t step, const Keyframe& keyframe) { return step < keyframe.step; }));
        if (n < step() || step() < nearest.step)
            restore(nearest);
    }
    while (step() < n) {
        take_next();
        if (!kept.empty() && step() == kept.back().step + shared_->interval)
            keep();
    }
}

void Replay::take_next() {
    const StepView step = trace().step(++step_);
    memory_.drew_over = memory_.stored_before = 0;
    const auto kind = step.kind();
    if (kind == StepKind::primitive)
        memory_.color = color_of_primitive(step.as<PrimitiveStep>());
    else if (kind == StepKind::pixel)
        take(step.as<PixelStep>());
    else if (kind == StepKind::depth)
        take(step.as<DepthStep>());
}

void Replay::take(const PixelStep& step) {
    const auto plotted = plotted_by(step, trace().canvas, memory_.color);
    if (!plotted)
        return;
    const std::size_t offset = trace().canvas.offset_of(plotted->pixel);
    frame_.image.at(plotted->pixel) = plotted->color;
    memory_.drew_over = std::exchange(frame_.drawn_by[offset], static_cast<std::uint32_t>(step_));
    if (!frame_.writes.empty())
        ++frame_.writes[offset];
    changed_by_[offset / tile_size] = step_;
}

void Replay::take(const DepthStep& step) {
    if (frame_.stored_by.empty() || !trace().canvas.contains(step.x, step.y))
        return;
    const std::size_t offset =
        trace().canvas.offset_of({static_cast<int>(step.x), static_cast<int>(step.y)});
    memory_.stored_before = frame_.stored_by[offset];
    if (!stores_depth(step))
        return;
    frame_.stored_by[offset] = static_cast<std::uint32_t>(step_);
    changed_by_[offset / tile_size] = step_;
}

std::shared_ptr<const Replay::Tile> Replay::blank_tile() {
    const std::vector<std::uint32_t> none(tile_size, 0);
    return std::make_shared<const Tile>(
        Tile{0, std::vector(tile_size, no_color), {none, none, none}});
}

std::shared_ptr<const Replay::Tile> Replay::tile(std::size_t index) const {
    const std::size_t begin = index * tile_size;
    const std::size_t end = std::min(begin + tile_size, frame_.drawn_by.size());
    const auto part_of = [begin, end]<typename Value>(const BlankVector<Value>& values) {
        return values.empty() ? std::vector<Value>()
                              : std::vector(values.data() + begin, values.data() + end);
    };
    return std::make_shared<const Tile>(
        Tile{changed_by_[index],
             part_of(frame_.image.colors()),
             {part_of(frame_.drawn_by), part_of(frame_.writes), part_of(frame_.stored_by)}});
}

void Replay::restore(const Keyframe& keyframe) {
    Color* const colors = frame_.image.row(trace().canvas.top()).colors;
    const std::array lists{&frame_.drawn_by, &frame_.writes, &frame_.stored_by};
    for (std::size_t index = 0; index < changed_by_.size(); ++index) {
        const Tile& tile = *keyframe.tiles[index];
        if (std::exchange(changed_by_[index], tile.changed_by) == tile.changed_by)
            continue;
        const std::size_t begin = index * tile_size;
        const std::size_t size = std::min(tile_size, frame_.drawn_by.size() - begin);
        std::copy_n(tile.colors.data(), size, colors + begin);
        for (std::size_t list = 0; list < lists.size(); ++list)
            if (!lists[list]->empty())
                std::copy_n(tile.numbers[list].data(), size, lists[list]->data() + begin);
    }
    step_ = keyframe.step;
    memory_ = keyframe.memory;
}

std::size_t Replay::Keyframe::bytes_beside(const Keyframe& before) const {
    std::size_t bytes = sizeof(Keyframe) + tiles.size() * sizeof(tiles[0]);
    for (std::size_t index = 0; index < tiles.size(); ++index)
        if (tiles[index] != before.tiles[index]) {
            bytes += sizeof(Tile) + tiles[index]->colors.size() * sizeof(Color);
            for (const auto& list : tiles[index]->numbers)
                bytes += list.size() * sizeof(list[0]);
        }
    return bytes;
}

void Replay::keep() {
    auto& [most_bytes, interval, bytes, kept] = *shared_;
    Keyframe next{step_, memory_, kept.back().tiles};
    for (std::size_t index = 0; index < changed_by_.size(); ++index)
        if (next.tiles[index]->changed_by != changed_by_[index])
            next.tiles[index] = tile(index);
    bytes += next.bytes_beside(kept.back());
    kept.push_back(std::move(next));
    while (bytes > most_bytes && kept.size() > 1) {
        interval *= 2;
        std::erase_if(kept, [interval = interval](const Keyframe& keyframe) {
            return keyframe.step % interval != 0;
        });
        bytes = 0;
        for (std::size_t i = 1; i < kept.size(); ++i)
            bytes += kept[i].bytes_beside(kept[i - 1]);
    }
}

std::optional<PlottedPixel> plotted_by(const PixelStep& pixel, const Canvas& canvas,
                                       Color of_primitive) {
    if (!canvas.contains(pixel.x, pixel.y))
        return std::nullopt;
    return PlottedPixel{{static_cast<int>(pixel.x), static_cast<int>(pixel.y)},
                        pixel.color ? pixel.color.color().value_or(of_primitive) : of_primitive};
}

bool stores_depth(const DepthStep& test) {
    return test.pass.is_true() && !test.side_of && !test.beside;
}

Color color_of_primitive(const PrimitiveStep& step) {
    return step.color.color().value_or(Color{});
}

Frame frame_after(const Trace& trace, std::size_t n) {
    Replay replay(trace);
    replay.go_to(n);
    return std::move(replay).frame();
}

} // namespace rastertrace
