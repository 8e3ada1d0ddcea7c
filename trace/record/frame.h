// SPDX-License-Identifier: MIT
#pragma once

// The picture as it was after any step of a trace.
//
//     Replay replay(trace);
//     replay.go_to(31);
//     replay.frame().image.at({-1, 2});
//
// Going back starts over; snapshots.h goes back as fast as forward.

#include "trace.h"
#include "traced_steps.h"

#include <rastertrace/core/raster/image.h>

#include <cstddef>
#include <cstdint>
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

/// A picture, and which step drew each of its pixels.
struct Frame {
    explicit Frame(const Canvas& canvas, FrameParts parts = {})
        : image(canvas), drawn_by(image.colors().size()),
          writes(parts.writes ? drawn_by.size() : 0),
          stored_by(parts.depths ? drawn_by.size() : 0) {}

    /// The memory that it takes.
    std::size_t bytes() const {
        return image.colors().size() * sizeof(Color) + drawn_by.size() * sizeof(std::size_t) +
               writes.size() * sizeof(std::uint32_t) + stored_by.size() * sizeof(std::size_t);
    }

    Image image;
    BlankVector<std::size_t> drawn_by; ///< the last step that plotted the pixel; 0 for none
    BlankVector<std::uint32_t> writes; ///< how often the pixel was plotted
    BlankVector<std::size_t>
        stored_by; ///< the depth test that the buffer has its depth from; 0 for none
};

/// The picture after some steps, and what the last of them refers to.
class ReplayState {
public:
    explicit ReplayState(const Canvas& canvas, FrameParts parts = {})
        : parts_(parts), frame_(canvas, parts),
          has_changed_(frame_.drawn_by.size() / tile_size + 1) {}

    /// Takes the next step.
    void take(const StepView& step);

    /// The same for a step that has been decoded; of other kinds, the kind is enough.
    void take(const PrimitiveStep& step);
    void take(const PixelStep& step);
    void take(const DepthStep& step);
    void take(StepKind kind);

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

    /// All primitives so far, by number of their step.
    std::span<const std::size_t> primitives() const {
        return std::span(primitives_).first(place_.primitives);
    }

    /// The primitive that a step so far belongs to; 0 if there is none.
    std::size_t primitive_of(std::size_t step) const;

    /// The color of the current primitive.
    Color color() const { return place_.color; }

    /// The last place of a vertex before the current step.
    std::size_t vertex_before() const { return place_.vertex_before; }

    /// The `matrix` steps so far, by number.
    std::span<const std::size_t> matrices() const {
        return std::span(matrices_).first(place_.matrices);
    }

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

protected:
    friend class Snapshots;

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
        std::size_t primitives = 0; ///< how many there are so far
        std::size_t matrices = 0;
        Color color = {}; ///< of the current primitive
        std::vector<std::size_t> edges = {};
    };

    /// Starts over from the first step.
    void start_over();

    /// Goes to where another one of the same trace and parts is.
    void go_to_place_of(const ReplayState& other);

    /// Takes over where another one of the same trace is, which remembers all parts.
    void take_over(ReplayState&& other);

    FrameParts parts_;
    Frame frame_;
    Place place_;

    /// Whether pixels of a tile, so many in a row of the whole canvas, are others than in a blank frame, or than
    /// they were when somebody last asked.
    static constexpr std::size_t tile_size = 1024;
    std::vector<std::uint8_t> has_changed_;

    /// Up to the farthest step that this replay has been at.
    std::vector<std::size_t> primitives_;
    std::vector<std::size_t> matrices_;

private:
    void pass();
};

/// Plays a trace forward step by step and remembers what the current step belongs to.
class Replay : public ReplayState {
public:
    explicit Replay(const Trace& trace, FrameParts parts = {})
        : ReplayState(trace.canvas, parts), trace_(trace) {}

    const Trace& trace() const { return trace_; }

    /// Goes to step n, 0 to trace().size(). Going back starts over.
    void go_to(std::size_t n);

    /// Goes to where another replay of the same trace and parts is.
    void go_to_place_of(const Replay& other);

    /// All steps of the trace that tell where a vertex is on its way to the screen, by number.
    const std::vector<std::size_t>& places_of(const std::string& vertex) const;

private:
    const Trace& trace_;

    /// The places of the vertices, by name, of so many steps of the trace, as far as someone has asked. Replays that
    /// have gone to each other's place share it.
    struct VertexPlaces {
        std::unordered_map<std::string, std::vector<std::size_t>> by_name;
        std::size_t steps = 0;
    };
    std::shared_ptr<VertexPlaces> vertex_places_ = std::make_shared<VertexPlaces>();
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
