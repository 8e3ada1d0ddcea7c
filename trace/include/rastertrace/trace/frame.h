// SPDX-License-Identifier: MIT
#pragma once

// The picture as it was after any step of a trace.
//
//     Replay replay(trace);
//     replay.go_to(31);
//     replay.frame().image.at({-1, 2});

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/trace.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace rastertrace {

/// A picture, and which step drew each of its pixels.
struct Frame {
    explicit Frame(const Canvas& canvas) : image(canvas), drawn_by(image.colors().size(), 0) {}

    Image image;
    std::vector<std::size_t> drawn_by; ///< the last step that plotted the pixel; 0 for none
};

/// Plays a trace forward step by step and remembers what the current step belongs to.
class Replay {
public:
    explicit Replay(const Trace& trace) : trace_(trace), frame_(trace.canvas) {}

    const Trace& trace() const { return trace_; }

    /// The picture after the current step.
    const Frame& frame() const { return frame_; }

    /// The number of the current step; 0 before the first.
    std::size_t step() const { return step_; }

    /// Goes to step n, 0 to trace().size(). Going back starts over from the first step.
    void go_to(std::size_t n);

    /// The steps that the current one refers to, by number; 0 if there is none. The primitive it
    /// belongs to, the last scanline, and the one before that of the same primitive.
    std::size_t primitive() const { return primitive_; }
    std::size_t scanline() const { return scanline_; }
    std::size_t scanline_before() const { return scanline_before_; }

    /// The color of the current primitive.
    Color color() const { return color_; }

    /// The last place of a vertex before the current step.
    std::size_t vertex_before() const { return vertex_before_; }

    /// The edges of the current primitive that have been set up, by number of their step.
    const std::vector<std::size_t>& edges() const { return edges_; }

    /// If the current step plotted a pixel that had been drawn already: the step that had.
    std::size_t drew_over() const { return drew_over_; }

private:
    void apply_next();

    const Trace& trace_;
    Frame frame_;
    std::size_t step_ = 0;
    std::size_t primitive_ = 0;
    std::size_t scanline_ = 0;
    std::size_t scanline_before_ = 0;
    std::size_t drew_over_ = 0;
    std::size_t vertex_ = 0;
    std::size_t vertex_before_ = 0;
    std::vector<std::size_t> edges_;
    Color color_; ///< of the current primitive
};

/// The picture after step n.
Frame frame_after(const Trace& trace, std::size_t n);

} // namespace rastertrace
