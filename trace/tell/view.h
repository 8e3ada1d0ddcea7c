// SPDX-License-Identifier: MIT
#pragma once

// What a cell of a frame shows of its pixel:
//
//     plotted    # where the pixel is drawn
//     faces      a letter for each face, the same in all frames
//     shade      a ramp from dark to light, or the color itself
//     depth      what the depth buffer holds
//     writes     how often the pixel was written
//     coverage   how far its sample lies inside the triangle, in tenths of a pixel
//
//     const FrameCells cells(View::faces, replay, 1);
//     cells.at({3, 2}).text;  // "a"

#include "face_groups.h"

#include <rastertrace/core/raster/image.h>
#include <rastertrace/trace/record/replay.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {

enum class View : std::uint8_t { plotted, faces, shade, depth, writes, coverage };

/// plotted, faces, ...
std::vector<std::string_view> view_names();
std::string_view name_of(View view);
std::optional<View> view_named(std::string_view name);

/// The view in which the point of a trace can be seen: `shade` if colors are mixed or lit; `faces` if there
/// is more than one triangle, `depth` if there is a buffer and too many of one color for letters; else
/// `plotted`.
View default_view(const Trace& trace);

/// True if pixels pass a test of depths, be it of a kind that we do not know.
bool has_depth_buffer(const Trace& trace);

/// True if a nearer depth is a larger one, as far as the tests of a trace tell.
bool larger_is_nearer(const Trace& trace);

/// What a replay of a trace has to remember for a view, and for what its depth tests say.
FrameParts parts_for(View view, const Trace& trace);

/// A number of a trace as it was written if that is short, at most six characters; else by its first digits.
std::string short_number(const std::string& text);

/// The faces that have letters, in the order of the letters, of the trace whose end a replay has reached. Those that had
/// one before, in another frame of a sequence, keep it.
FaceGroups lettered_faces(const Replay& at_end, const FaceGroups& before = {});

struct Cell {
    std::string text;
    std::optional<Color> color = {};       ///< of the pixel, where the view shows it
    std::optional<double> brightness = {}; ///< of a depth: 0 for the farthest, 1 for the nearest
};

/// The cells of the frame that a replay has reached. The replay must live as long, and stay there.
class FrameCells {
public:
    /// A cell of `depth` is a number if it takes at most `room` columns; else a ramp from far to near. Who shows many
    /// frames in letters finds out once which faces have them, and keeps that for as long.
    FrameCells(View view, const Replay& replay, std::size_t room,
               const FaceGroups* faces = nullptr);
    FrameCells(const FrameCells&) = delete;
    FrameCells& operator=(const FrameCells&) = delete;

    /// The cell of a pixel of the canvas.
    Cell at(Pixel pixel) const;

    /// Columns of the widest cell.
    std::size_t width() const { return width_; }

    /// What the cells mean, beyond `.`: words that may be spread over lines.
    const std::vector<std::string>& legend() const { return legend_; }

private:
    void set_up_faces(const FaceGroups* faces);
    void set_up_shade();
    void set_up_depths(std::size_t room);
    void set_up_coverage();

    const Replay& replay_;
    std::optional<FaceGroups> own_faces_;
    std::function<Cell(std::size_t offset, Pixel pixel)> cell_;
    std::size_t width_ = 1;
    std::vector<std::string> legend_;
};

} // namespace rastertrace
