// SPDX-License-Identifier: MIT
#pragma once

// The picture as it was after any step of a trace.
//
//     Replay replay(trace);
//     replay.go_to(31);
//     replay.frame().image.at({-1, 2});
//
// A replay that has gone back keeps pictures from then on, keyframes, so that it goes back as fast as forward. What has
// not changed from one to the next is kept once. When they take too much memory every second one is dropped, and from
// then on they are twice as far apart.

#include "step_context.h"

#include <rastertrace/core/raster/image.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace rastertrace {

/// What a frame remembers of its pixels beside their colors, for who asks.
struct FrameParts {
    bool writes = false;
    bool depths = false;
};

/// A picture, and which step drew each of its pixels. Steps have 32 bits: a trace of more has some 300 GB.
struct Frame {
    explicit Frame(const Canvas& canvas, FrameParts parts = {})
        : image(canvas), drawn_by(image.colors().size()),
          writes(parts.writes ? drawn_by.size() : 0),
          stored_by(parts.depths ? drawn_by.size() : 0) {}

    Image image;
    BlankVector<std::uint32_t> drawn_by; ///< the last step that plotted the pixel; 0 for none
    BlankVector<std::uint32_t> writes;   ///< how often the pixel was plotted
    BlankVector<std::uint32_t>
        stored_by; ///< the depth test that the buffer has its depth from; 0 for none
};

/// Plays a trace step by step: its current step and what that belongs to, and the picture then. Copies share the pictures
/// that they keep.
class Replay : public StepContext {
public:
    static constexpr std::size_t usual_bytes = 64'000'000;

    /// Keyframes take at most so many bytes: one at least is kept, whatever it takes.
    explicit Replay(const Trace& trace, FrameParts parts = {},
                    std::size_t most_bytes = usual_bytes);

    /// Goes to step n, 0 to trace().size().
    void go_to(std::size_t n);

    /// The picture after the current step.
    const Frame& frame() const& { return frame_; }
    Frame frame() && { return std::move(frame_); }

    /// The color of the current primitive.
    Color color() const { return memory_.color; }

    /// If the current step is a depth test: the one that the buffer had its depth from, if depths are
    /// remembered (FrameParts); 0 for none.
    std::size_t stored_before() const { return memory_.stored_before; }

    /// If the current step plotted a pixel that had been drawn already: the step that had.
    std::size_t drew_over() const { return memory_.drew_over; }

    /// What the keyframes take, and how many steps there are from one to the next.
    std::size_t bytes() const { return shared_->bytes; }
    std::size_t interval() const { return shared_->interval; }

private:
    /// What is remembered of the steps so far, but for the frame.
    struct Memory {
        std::size_t drew_over = 0;
        std::size_t stored_before = 0;
        Color color = {}; ///< of the current primitive
    };

    /// So many pixels in a row of the whole canvas, and the step that changed them last. Of one trace, tiles that were
    /// changed by the same step are the same.
    static constexpr std::size_t tile_size = 1024;
    struct Tile {
        std::size_t changed_by;
        std::vector<Color> colors;
        std::array<std::vector<std::uint32_t>, 3> numbers;
    };

    struct Keyframe {
        std::size_t step = 0;
        Memory memory = {};
        std::vector<std::shared_ptr<const Tile>> tiles = {};

        /// What it takes beside the one before.
        std::size_t bytes_beside(const Keyframe& before) const;
    };

    /// What replays of a trace need once.
    struct Shared {
        std::size_t most_bytes = 0;
        std::size_t interval = 4096;
        std::size_t bytes = 0;
        std::vector<Keyframe>
            keyframes; ///< none until a replay goes back; then one every `interval` steps, from 0 on
    };

    void take_next();
    void take(const PixelStep& step);
    void take(const DepthStep& step);
    static std::shared_ptr<const Tile> blank_tile();
    std::shared_ptr<const Tile> tile(std::size_t index) const;
    void restore(const Keyframe& keyframe);
    void keep();

    Frame frame_;
    Memory memory_;
    std::vector<std::size_t> changed_by_; ///< the last step that changed each tile; 0: none
    std::shared_ptr<Shared> shared_;
};

/// A pixel that a step plots.
struct PlottedPixel {
    Pixel pixel;
    Color color;
};

/// What a `pixel` step plots, if it lies on the canvas. Without a color of its own it has that of its primitive.
std::optional<PlottedPixel> plotted_by(const PixelStep& step, const Canvas& canvas,
                                       Color of_primitive);

/// True if the depth of a test is in the buffer from then on: what passes a nearer depth leaves that there.
bool stores_depth(const DepthStep& test);

/// The color of the primitive that a step begins.
Color color_of_primitive(const PrimitiveStep& step);

/// The picture after step n.
Frame frame_after(const Trace& trace, std::size_t n);

} // namespace rastertrace
