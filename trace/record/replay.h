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

#include "trace.h"
#include "traced_steps.h"

#include <rastertrace/core/raster/image.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
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

/// Plays a trace step by step, and remembers what the current step belongs to. Copies share the pictures that they keep.
class Replay {
public:
    static constexpr std::size_t usual_bytes = 64'000'000;

    /// Keyframes take at most so many bytes: one at least is kept, whatever it takes.
    explicit Replay(const Trace& trace, FrameParts parts = {},
                    std::size_t most_bytes = usual_bytes);

    const Trace& trace() const { return trace_; }

    /// Goes to step n, 0 to trace().size().
    void go_to(std::size_t n);

    /// The picture after the current step.
    const Frame& frame() const& { return frame_; }
    Frame frame() && { return std::move(frame_); }

    /// The number of the current step; 0 before the first.
    std::size_t step() const { return place_.step; }

    /// The steps that the current one refers to, by number; 0 if there is none. The primitive it
    /// belongs to, the last scanline, and the one before that of the same primitive.
    std::size_t primitive() const { return place_.primitive; }
    std::size_t scanline() const { return place_.scanline; }
    std::size_t scanline_before() const { return place_.scanline_before; }

    /// The primitives and the `matrix` steps so far, by number.
    std::span<const std::size_t> primitives() const { return so_far(StepKind::primitive); }
    std::span<const std::size_t> matrices() const { return so_far(StepKind::matrix); }

    /// The primitive that any step of the trace belongs to; 0 if there is none.
    std::size_t primitive_of(std::size_t step) const;

    /// The color of the current primitive.
    Color color() const { return place_.color; }

    /// The last place of a vertex before the current step.
    std::size_t vertex_before() const { return place_.vertex_before; }

    /// The step that told how the painter sorts the triangles; 0 if there was none.
    std::size_t order() const { return place_.order; }

    /// The edges of the current primitive that have been set up, by number of their step.
    const std::vector<std::size_t>& edges() const { return place_.edges; }

    /// Where the current line of a `fan` began, by number of its step; 0 if none did.
    std::size_t ray() const { return place_.ray; }

    /// If the current step is a depth test: the one that the buffer had its depth from, if depths are
    /// remembered (FrameParts); 0 for none.
    std::size_t stored_before() const { return place_.stored_before; }

    /// If the current step plotted a pixel that had been drawn already: the step that had.
    std::size_t drew_over() const { return place_.drew_over; }

    /// All steps of the trace that tell where a vertex is on its way to the screen, by number.
    const std::vector<std::size_t>& places_of(const std::string& vertex) const;

    /// What the keyframes take, and how many steps there are from one to the next.
    std::size_t bytes() const { return shared_->bytes; }
    std::size_t interval() const { return shared_->interval; }

private:
    /// The current step and what it refers to: all but the frame.
    struct Place {
        std::size_t step = 0;
        std::size_t primitive = 0;
        std::size_t scanline = 0;
        std::size_t scanline_before = 0;
        std::size_t drew_over = 0;
        std::size_t stored_before = 0;
        std::size_t order = 0;
        std::size_t ray = 0;
        std::size_t vertex = 0;
        std::size_t vertex_before = 0;
        Color color = {}; ///< of the current primitive
        std::vector<std::size_t> edges = {};
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
        Place place;
        std::vector<std::shared_ptr<const Tile>> tiles;

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
        std::map<StepKind, std::vector<std::size_t>>
            steps_of; ///< all of a kind, once someone has asked
        std::optional<std::unordered_map<std::string, std::vector<std::size_t>>>
            places_of; ///< of vertices
    };

    void take_next();
    void take(const PixelStep& step);
    void take(const DepthStep& step);
    const std::vector<std::size_t>& all_of(StepKind kind) const;
    std::span<const std::size_t> so_far(StepKind kind) const;
    static std::shared_ptr<const Tile> blank_tile();
    std::shared_ptr<const Tile> tile(std::size_t index) const;
    void restore(const Keyframe& keyframe);
    void keep();

    const Trace& trace_;
    Frame frame_;
    Place place_;
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
