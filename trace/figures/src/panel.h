// SPDX-License-Identifier: MIT
#pragma once

// The parts of a figure that are drawn on the pixels. Each adds its shapes over those before it; figure.cpp says in
// which order.

#include "grays.h"
#include "lattice.h"

#include <rastertrace/figures/drawing.h>
#include <rastertrace/figures/figure.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/tell/face_groups.h>
#include <rastertrace/trace/tell/shown_steps.h>

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rastertrace {

/// What a part is drawn from.
struct Panel {
    const Replay& replay; ///< at the last step of the frame
    FigureFrame frame;
    Lattice lattice;
    Rectangle sheet = {}; ///< at least as far down as the numbers of columns
    FigureParts parts;
    View view;
    const FaceGroups& groups;
    const Frame* against;       ///< a picture to compare with; nullptr for none
    bool has_all_edges = false; ///< not only those of the current primitive
    bool has_colors = true;     ///< some pixel, or the background, has another color than black
    StepSubject subject = {};   ///< of the first step of the frame

    const Trace& trace() const { return replay.trace(); }

    /// True if the frame is about a step: it is not the whole picture, nor a question.
    bool is_step() const { return frame.steps.first != 0 && !frame.is_question; }

    /// The primitive that the frame is about, by its step; 0: none.
    std::size_t primitive() const { return is_step() ? subject.primitive : replay.primitive(); }

    /// True if a step of the frame has drawn the pixel.
    bool is_current(std::size_t offset) const {
        return is_step() && frame.steps.has(replay.frame().drawn_by[offset]);
    }

    /// All pixels that are shown, top row first.
    template <typename Visit> void for_each_pixel(Visit&& visit) const {
        const Canvas& canvas = lattice.canvas;
        for (int row = 0; row < lattice.rows(); ++row)
            for (int column = 0; column < lattice.columns(); ++column) {
                const Pixel pixel{lattice.region.x0 + column, lattice.top() + row * canvas.down()};
                visit(pixel, canvas.offset_of(pixel));
            }
    }
};

// default_parts.cpp

/// Sets the parts that a figure has, and the side of its pixels.
void set_parts(const FigureOptions& options, Panel& panel);

// pixel_parts.cpp

/// What a pixel is in a comparison of two pictures, with the mark that diff has for it.
struct ComparisonMark {
    Role role;
    std::string_view mark;
};

/// Drawn by both alike, by this trace only, by the other only, by both in different colors.
std::span<const ComparisonMark> comparison_marks();

/// That of a pixel; nullptr if none has drawn it.
const ComparisonMark* comparison_at(const Panel& panel, std::size_t offset);

/// The color of a pixel that has one of its own, whatever the theme; no_color for one that has none.
using PixelColors = std::function<Color(Pixel pixel, std::size_t offset)>;

/// Those of the view; nothing if it paints in the theme's colors.
PixelColors own_colors_of(const Panel& panel);
void add_pixels(const Panel& panel, std::vector<Shape>& shapes);
void add_current(const Panel& panel, std::vector<Shape>& shapes);
void add_rejected(const Panel& panel, std::vector<Shape>& shapes);

// cell_text.cpp
bool has_cell_texts(const FigureParts& parts);
void add_cell_texts(const Panel& panel, std::vector<Shape>& shapes);

/// The side that a pixel needs at least for what is written in it.
double cell_for_texts(const Panel& panel, const FigureParts& parts);

// grid_parts.cpp
void add_grid(const Panel& panel, std::vector<Shape>& shapes);
void add_axes(const Panel& panel, std::vector<Shape>& shapes);
void add_border(const Panel& panel, std::vector<Shape>& shapes);

/// How much room the numbers of rows need at the left, and those of columns below.
double axis_margin(const Lattice& lattice);
inline constexpr double axis_height = 16;

// edge_parts.cpp

/// The corners of a primitive on the sheet; none if its step does not tell them.
Path places_of(const Panel& panel, std::size_t primitive);

/// The primitives whose edges and vertices are shown, by their steps.
std::vector<std::size_t> primitives_with_edges(const Panel& panel);
void add_edges(const Panel& panel, std::vector<Shape>& shapes);
void add_hidden_edges(const Panel& panel, std::vector<Shape>& shapes);
void add_vertices(const Panel& panel, std::vector<Shape>& shapes);
void add_samples(const Panel& panel, std::vector<Shape>& shapes);
void add_half_planes(const Panel& panel, std::vector<Shape>& shapes);

/// True if the frame is about a triangle.
bool has_half_planes(const Panel& panel);

/// Words, each with an arrow to its place.
void add_notes(const std::vector<FigureNote>& notes, const Panel& panel,
               std::vector<Shape>& shapes);

// row_part.cpp
void add_row(const Panel& panel, std::vector<Shape>& shapes);

} // namespace rastertrace
