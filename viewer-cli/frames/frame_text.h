// SPDX-License-Identifier: MIT
#pragma once

// A frame as text: the canvas as a grid of characters, top row first.
//
//     First triangle                                                  step 14 of 62
//     scanline y=2   left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> -1   ...
//
//          -8-7-6-5-4-3-2-1 0 1 2 3 4 5 6 7 8
//       4   . . . . . . . . . # # . . . . . .
//     > 2   . . . . . . . @ @ @ @ @ . . . . .

#include "frames/terminal_text.h"

#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/trace_options.h>
#include <rastertrace/trace/tell/view.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

/// A frame, how it is looked at, and what is said above it.
struct FrameText {
    std::string caption = {};   ///< what the step says, see describe_step
    std::size_t first_step = 0; ///< pixels drawn by the steps from this one (0: none) ...
    std::size_t last_step = 0;  ///< ... to this one, the frame's own, are new, and marked
    View view = View::plotted;
    ColorDepth colors = ColorDepth::none;
    std::optional<Region> region = {};     ///< show this part, whatever the terminal's size
    bool is_overview = false;              ///< show all of the canvas, many pixels to a cell
    std::vector<std::string> working = {}; ///< lines below the caption, see working_of
    bool has_heading = true;               ///< title, caption and working
    std::string below = {}; ///< what will be printed below the frame, for which it leaves room
    std::optional<Pixel> center =
        {}; ///< what a cut canvas is shown around; none: what the step is about
    std::optional<Pixel> cursor = {}; ///< a pixel that is marked
    std::optional<Region> coming =
        {}; ///< pixels of the row that the step has found, which the next ones may draw
    std::size_t scale = 1; ///< lines of a cell; if it is more than one, twice as many columns
    bool has_half_blocks = false; ///< two pixels above each other to a character, in their colors
    const FaceGroups* faces = nullptr; ///< that have letters, see FrameCells
};

/// What of a canvas a frame shows: columns and rows of cells, counted from its left and top. A cell is a block of
/// pixels.
struct FrameWindow {
    int first_column = 0;
    int columns = 0; ///< of cells
    int first_row = 0;
    int rows = 0;
    int block_width = 1;
    int block_height = 1;
};

/// Where in a frame's text its cells stand.
struct FrameGrid {
    FrameWindow window;
    std::size_t first_line = 0; ///< of the text, from 0
    std::size_t first_column = 0;
    std::size_t cell_columns = 1;
    std::size_t cell_lines = 1;

    /// The pixel at a place of the text, from 0: the first of its block.
    std::optional<Pixel> pixel_at(std::size_t line, std::size_t column, const Canvas& canvas) const;
};

struct LaidOutFrame {
    std::string text;
    FrameGrid grid;
};

/// The frame that a replay has reached, with title, caption, coordinates along the borders, and a legend.
///
/// A cell shows what its view says (view.h). New pixels are `@` in `plotted`, and elsewhere `[a b]` where there
/// are gaps, or reversed in colors, as a pixel that the first step is about, or the ends of its edge; `x` is a pixel that
/// one of these steps has tested and not drawn. `>` are the rows that the first of them is about. In `plotted`, a vertex of the current primitive is its letter, small
/// where its pixel is not drawn, and `*` if its name is longer, which the legend tells; elsewhere names stand
/// behind their row, with their x. A vertex that a primitive hides which has no such corner is not shown.
///
/// A canvas too wide for `size` loses the gaps between its columns; one that still does not fit is cut to a
/// window around the pixels that the step is about, and a line says so.
LaidOutFrame laid_out_frame(const Replay& replay, const FrameText& about, TextSize size);

/// The title in so many columns, with the mistake that it is drawn with.
std::string title_of(const Trace& trace, std::size_t columns);

/// Title and caption alone, in lines of so many columns.
std::vector<std::string> frame_heading(const Trace& trace, const FrameText& about,
                                       std::size_t columns);

/// Columns that the grid of a canvas takes with gaps, and its coordinates.
std::size_t grid_columns(const Canvas& canvas, const FrameText& about);

/// Its text.
std::string frame_text(const Replay& replay, const FrameText& about, TextSize size);

/// The pixel of a frame that step n is about: its own, the middle of its row, or the newest one.
std::optional<Pixel> pixel_looked_at(const Replay& replay, std::size_t n);

/// Only the grid, or a part of it, top row first: `.` empty, `#` plotted; or the cells of another view.
std::string bare_frame_text(const Frame& frame);
std::string bare_frame_text(const Replay& replay, View view,
                            const std::optional<Region>& region = {},
                            const FaceGroups* faces = nullptr);

/// What a scene is about, and all of its picture above `about.below`.
std::string summary_text(const Replay& replay, FrameText about, TextSize size);

/// What stands below the last frame: what lies off the canvas, and the stages.
std::string text_below(const Trace& trace);

} // namespace rastertrace
