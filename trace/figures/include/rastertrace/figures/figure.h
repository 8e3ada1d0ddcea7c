// SPDX-License-Identifier: MIT
#pragma once

// A figure of a rasterization lesson: the pixels of a frame as large squares, and over them what the algorithm works
// with: true edges, vertices, the row with its exact ends, the arrows of rounding.
//
//     FigureMaker maker(trace, {{n, end_of(trace, n)}}, {});
//     const Drawing figure = maker.figure(0);  // of step n

#include <rastertrace/figures/drawing.h>
#include <rastertrace/figures/space_eye.h>
#include <rastertrace/trace/record/replay.h>
#include <rastertrace/trace/record/trace_options.h>
#include <rastertrace/trace/tell/face_groups.h>
#include <rastertrace/trace/tell/shown_steps.h>
#include <rastertrace/trace/tell/view.h>

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rastertrace {

struct Panel;
struct SpatialScene;

/// What a figure can show beside the pixels. figure_parts() tells of each what it is.
enum class FigurePart : std::uint8_t {
    grid,
    axes,
    edges,
    hidden_edges,
    vertices,
    coordinates,
    samples,
    row,
    pixels,
    current,
    rejected,
    order,
    depths,
    writes,
    weights,
    owners,
    levels,
    half_planes,
    errors,
    space,
    plot,
    title,
    step,
    legend,
    caption,
    working,
};
inline constexpr std::size_t figure_part_count = static_cast<std::size_t>(FigurePart::working) + 1;

/// A set of parts.
class FigureParts {
public:
    bool has(FigurePart part) const { return bits_[static_cast<std::size_t>(part)]; }
    void set(FigurePart part, bool is_in) { bits_[static_cast<std::size_t>(part)] = is_in; }

private:
    std::bitset<figure_part_count> bits_;
};

struct FigurePartRow {
    FigurePart part;
    std::string_view name;
    std::string_view shows;
    std::string_view by_default; ///< when it is there without having been asked for
};

/// The one list of parts.
std::span<const FigurePartRow> figure_parts();
std::optional<FigurePart> figure_part_named(std::string_view name);

/// Words beside the picture, with an arrow to a place in it.
struct FigureNote {
    double x = 0; ///< in the scene's coordinates, on the screen
    double y = 0;
    std::string text;
};

struct FigureOptions {
    std::vector<FigurePart> with = {};    ///< more than would be there
    std::vector<FigurePart> without = {}; ///< less
    std::optional<View> view = {}; ///< what the color of a pixel means; none: the trace's default
    bool is_in_space = false;      ///< the picture in space takes the place of the pixels
    SpaceEye eye = {};             ///< of that, and of the part `space`
    std::optional<Region> region = {}; ///< of the canvas; none: all of it
    std::optional<double> cell = {};   ///< the side of a pixel, in units; none: by the canvas
    /// Of letters. A pixel takes so many fewer units, and is as large as before where it is written.
    double letter_scale = 1;
    std::vector<FigureNote> notes = {};
    std::optional<std::string> title = {};   ///< none: the scene's
    std::optional<std::string> caption = {}; ///< none: what the step says
    const Trace* against = nullptr;          ///< another one, whose final pixels are compared
    std::string against_name = {};
};

/// A frame of a figure.
struct FigureFrame {
    ShownSteps steps = {};
    bool is_question =
        false; ///< the picture before the first step, which is asked for and not told
};

/// Makes the figures of frames of a trace.
class FigureMaker {
public:
    /// The trace must outlive the maker. Throws a Problem if a part was asked for that the scene cannot have.
    FigureMaker(const Trace& trace, std::vector<FigureFrame> frames, FigureOptions options);

    ~FigureMaker();

    std::size_t size() const { return frames_.size(); }

    /// From now on, figures have letters of this size; see FigureOptions.
    void set_letter_scale(double scale) { options_.letter_scale = scale; }

    /// The nth frame, from 0. Fastest in their order. Throws a Problem if a part was asked for that it cannot have.
    Drawing figure(std::size_t n);

private:
    Drawing drawing_in_space(const Panel& panel, std::pair<double, double> size) const;
    Drawing figure_in_space(const Panel& panel, const std::string& caption,
                            const std::vector<std::string>& working) const;

    const Trace& trace_;
    std::vector<FigureFrame> frames_;
    FigureOptions options_;
    View view_;
    bool has_colors_; ///< of the trace's own, see Role::ink
    Replay replay_;
    FaceGroups groups_;
    std::optional<Frame> against_;
    std::unique_ptr<const SpatialScene> space_; ///< nullptr: the scene is typed in pixels
};

} // namespace rastertrace
