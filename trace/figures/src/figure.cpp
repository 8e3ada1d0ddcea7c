// SPDX-License-Identifier: MIT
#include <rastertrace/figures/figure.h>

#include "depth_plot.h"
#include "error_bars.h"
#include "panel.h"
#include "space_drawing.h"
#include "words.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/corners.h>
#include <rastertrace/trace/tell/describe.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/tell/told_samples.h>
#include <rastertrace/trace/tell/working.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rastertrace {

namespace {

constexpr double margin_of_sheet = 10; // in units

constexpr double smallest_scene = 220; // in units

/// Faces of more groups are put together by mesh or by color, if that makes fewer. After eight, colors come again.
constexpr std::size_t most_groups = 64;

Lattice lattice_of(const Trace& trace, const std::optional<Region>& region) {
    const Canvas& canvas = trace.canvas;
    const Region all{.x0 = canvas.left(),
                     .y0 = std::min(canvas.top(), canvas.bottom()),
                     .x1 = canvas.right(),
                     .y1 = std::max(canvas.top(), canvas.bottom())};
    const auto offset = told_samples(trace).triangles;
    return {.canvas = canvas,
            .region = region.value_or(all),
            .begins_at_integers = pixels_begin_at_integers(trace),
            .sample_x = offset.x().get_d(),
            .sample_y = offset.y().get_d(),
            .cell = 1,
            .corner = {}};
}

bool has_words(const FigureParts& parts) {
    return parts.has(FigurePart::title) || parts.has(FigurePart::caption) ||
           parts.has(FigurePart::working) || parts.has(FigurePart::legend);
}

/// True if there is nothing around the pixels.
bool is_bare(const FigureParts& parts) {
    return !has_words(parts) && !parts.has(FigurePart::axes) && !parts.has(FigurePart::grid) &&
           !parts.has(FigurePart::vertices);
}

bool is_in(const std::vector<FigurePart>& list, FigurePart part) {
    return std::find(list.begin(), list.end(), part) != list.end();
}

/// Why a frame is refused that has nothing of a part which was asked for; nothing if the part may be empty.
std::optional<Problem> problem_of_nothing(FigurePart part) {
    switch (part) {
    case FigurePart::half_planes:
        return problem_of("", "--with half-planes: expected a frame of a triangle, found another",
                          "--step \"primitive ...\", or another step of a triangle");
    case FigurePart::row:
        return problem_of("", "--with row: expected a frame with a scanline, found none",
                          "--step \"scanline ...\", or another step of its row");
    case FigurePart::rejected:
        return problem_of("",
                          "--with rejected: expected a frame with a pixel that was tested and not "
                          "drawn, found none",
                          "--step of a sample or of a depth test that fails; without --step, all "
                          "of them");
    default:
        return std::nullopt;
    }
}

/// What is drawn on the pixels, in this order. Throws a Problem if there is nothing of a part that is `needed`.
void add_raster(const Panel& panel, const std::vector<FigurePart>& needed,
                std::vector<Shape>& shapes) {
    using AddPart = void (*)(const Panel&, std::vector<Shape>&);
    constexpr std::array<std::pair<FigurePart, AddPart>, 11> on_pixels{
        {{FigurePart::pixels, add_pixels},
         {FigurePart::half_planes, add_half_planes},
         {FigurePart::grid, add_grid},
         {FigurePart::axes, add_axes},
         {FigurePart::current, add_current},
         {FigurePart::samples, add_samples},
         {FigurePart::edges, add_edges},
         {FigurePart::hidden_edges, add_hidden_edges},
         {FigurePart::rejected, add_rejected},
         {FigurePart::row, add_row},
         {FigurePart::vertices, add_vertices}}};
    for (const auto& [part, add] : on_pixels) {
        if (!panel.parts.has(part))
            continue;
        const std::size_t before = shapes.size();
        add(panel, shapes);
        if (shapes.size() == before && is_in(needed, part))
            if (auto problem = problem_of_nothing(part))
                throw *std::move(problem);
    }
    add_cell_texts(panel, shapes);
    if (panel.parts.has(FigurePart::grid) || panel.parts.has(FigurePart::axes))
        add_border(panel, shapes);
}

bool has_step(const Trace& trace, StepKind kind) {
    return trace.next_of({kind}, 1, trace.size()) <= trace.size();
}

/// True if something in the trace has another color than black, which is that of a scene without colors.
bool has_colors(const Trace& trace) {
    if (trace.background)
        return true;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (kind == StepKind::primitive &&
            !(color_of_primitive(trace.step(n).as<PrimitiveStep>()) == Color{}))
            return true;
        if (kind == StepKind::pixel && trace.step(n).as<PixelStep>().color)
            return true;
    }
    return false;
}

bool has_triangle(const Trace& trace) {
    for (const std::size_t n : trace.steps_of({StepKind::primitive}))
        if (corners_of(trace.step(n).as<PrimitiveStep>()).size() == 3)
            return true;
    return false;
}

/// Refuses a part that was asked for, and that no frame of the trace can have.
void check_parts(const std::vector<FigurePart>& with, const Trace& trace) {
    struct Needed {
        FigurePart part;
        bool (*is_there)(const Trace& trace);
        std::string_view message;
        std::string_view hint;
    };
    constexpr std::array all{
        Needed{FigurePart::depths, [](const Trace& one) { return has_step(one, StepKind::depth); },
               "--with depths: expected a scene with depth tests, found none",
               "--depth linear-z --keep depth tests what no other triangle can hide, too"},
        Needed{FigurePart::weights,
               [](const Trace& one) { return has_step(one, StepKind::sample); },
               "--with weights: expected a fill that tests samples by weights, found none",
               "--fill barycentric"},
        Needed{FigurePart::half_planes, has_triangle,
               "--with half-planes: expected a scene with triangles on the screen, found none", ""},
        Needed{FigurePart::row, [](const Trace& one) { return has_step(one, StepKind::scanline); },
               "--with row: expected a scene with scanlines, found none",
               "--fill scanline draws triangles row by row"},
        Needed{FigurePart::rejected,
               [](const Trace& one) {
                   return !pixels_not_drawn(one, {0, one.size()}).empty();
               },
               "--with rejected: expected a scene with pixels that are tested and not drawn, "
               "found none",
               "--fill barycentric tests pixels beside a triangle, too"}};
    for (const Needed& needed : all)
        if (is_in(with, needed.part) && !needed.is_there(trace))
            throw problem_of("", std::string(needed.message), std::string(needed.hint));
}

/// Refuses a part that is about pixels.
void check_parts_in_space(const std::vector<FigurePart>& with) {
    constexpr std::array in_space{FigurePart::title, FigurePart::step, FigurePart::caption,
                                  FigurePart::working};
    for (const FigurePart part : with)
        if (std::find(in_space.begin(), in_space.end(), part) == in_space.end())
            throw problem_of("",
                             fmt::format("--with {}: expected title, step, caption or working in "
                                         "the picture in space, found a part of pixels",
                                         figure_parts()[static_cast<std::size_t>(part)].name),
                             "--with space shows that picture beside the pixels");
}

/// What stands beside the pixels, or below.
struct Beside {
    std::optional<Decisions> decisions = {};
    std::optional<Drawing> space = {};
    std::vector<Plot> plots = {};

    bool has_bars_at_right() const { return decisions && decisions->is_steep; }
    bool has_bars_below() const { return decisions && !decisions->is_steep; }

    /// The scene is as high as the pixels, and as wide.
    static double side_of_scene(const Lattice& lattice, double letter_scale) {
        return std::max(lattice.height(), smallest_scene / letter_scale);
    }
    double width_at_right() const {
        return (has_bars_at_right() ? error_bars_size : 0) + (space ? space->width : 0);
    }
    double width_below() const {
        double width = 0;
        for (const Plot& plot : plots)
            width += plot.width;
        return width;
    }
};

/// Why there is no plot.
Problem problem_of_plot(const Trace& trace) {
    const auto depth = trace.method.triangles.depth;
    if ((depth == Depth::linear_z || depth == Depth::inverse_z) && has_step(trace, StepKind::depth))
        return problem_of("",
                          "--with plot: expected a frame with two depths along a row or a side, "
                          "found fewer",
                          "--step \"scanline ...\" of a longer row");
    return problem_of("",
                      "--with plot: expected a triangle with depths of linear-z or inverse-z, "
                      "found none",
                      "--depth linear-z --keep depth tests a triangle that no other one can hide");
}

/// What was asked for, but for the picture in space. Throws a Problem if the only frame has nothing of it; one of many
/// goes without.
Beside beside_of(const Panel& panel, bool is_only) {
    Beside beside;
    if (panel.parts.has(FigurePart::errors)) {
        beside.decisions = decisions_of(panel.replay);
        if (!beside.decisions && is_only)
            throw problem_of("",
                             "--with errors: expected a frame of Bresenham's line, found another",
                             "--step last, or another step of such a line");
    }
    if (panel.parts.has(FigurePart::plot)) {
        beside.plots = depth_plots(panel);
        if (beside.plots.empty() && is_only)
            throw problem_of_plot(panel.trace());
    }
    return beside;
}

/// Draws what stands at the right of the pixels; returns how high it is.
double add_at_right(const Beside& beside, const Lattice& lattice, double left, Drawing& sheet) {
    if (beside.has_bars_at_right()) {
        add_error_bars(*beside.decisions, lattice, left, sheet.shapes);
        left += error_bars_size;
    }
    if (!beside.space)
        return 0;
    Drawing space = *beside.space;
    const double height = space.height;
    place(std::move(space), {left, lattice.corner.y}, sheet);
    return height;
}

/// Draws what stands below; returns how high it is.
double add_below(const Beside& beside, const Lattice& lattice, const Column& column, double y,
                 Drawing& sheet) {
    if (beside.has_bars_below()) {
        add_error_bars(*beside.decisions, lattice, y, sheet.shapes);
        return error_bars_size;
    }
    double left = column.left;
    double height = 0;
    for (const Plot& plot : beside.plots) {
        Drawing drawing = plot_drawing(plot);
        height = std::max(height, drawing.height);
        place(std::move(drawing), {left, y}, sheet);
        left += plot.width;
    }
    if (!beside.plots.empty()) {
        Drawing legend = legend_drawing(beside.plots.front());
        const double legend_height = legend.height;
        place(std::move(legend), {column.left, y + height}, sheet);
        height += legend_height;
    }
    return height;
}

} // namespace

FigureMaker::FigureMaker(const Trace& trace, std::vector<FigureFrame> frames, FigureOptions options)
    : trace_(trace), frames_(std::move(frames)), options_(std::move(options)),
      view_(options_.view.value_or(default_view(trace))), has_colors_(has_colors(trace)),
      replay_(trace, {.writes = view_ == View::writes || is_in(options_.with, FigurePart::writes),
                      .depths = true}) {
    groups_ = painted_face_groups(trace, most_groups);
    if (options_.is_in_space || is_in(options_.with, FigurePart::space)) {
        auto space = space_of(trace);
        if (!space)
            throw problem_of("",
                             fmt::format("{} space: expected vertices in space, found a scene "
                                         "that is typed in pixels, or in clip space",
                                         options_.is_in_space ? "--view" : "--with"),
                             "of a scene whose vertices have z: --keep model tells where they are");
        space_ = std::make_unique<const SpatialScene>(*std::move(space));
    }
    if (options_.is_in_space)
        check_parts_in_space(options_.with);
    check_parts(options_.with, trace);
    if (options_.against != nullptr)
        against_ = frame_after(*options_.against, options_.against->size());
}

FigureMaker::~FigureMaker() = default;

Drawing FigureMaker::drawing_in_space(const Panel& panel, std::pair<double, double> size) const {
    if (!panel.is_step())
        return space_drawing(*space_, trace_, options_.eye, size, nullptr);
    Replay at_step(trace_);
    at_step.go_to(panel.frame.steps.first);
    return space_drawing(*space_, trace_, options_.eye, size, &at_step);
}

Drawing FigureMaker::figure_in_space(const Panel& panel, const std::string& caption,
                                     const std::vector<std::string>& working) const {
    const std::pair size{480.0 / options_.letter_scale, 360.0 / options_.letter_scale};
    const FigureParts& parts = panel.parts;
    Drawing sheet{.width = size.first + 2 * margin_of_sheet,
                  .title = options_.title.value_or(trace_.title)};
    const Column column{margin_of_sheet, sheet.width - margin_of_sheet};
    double y = margin_of_sheet;
    if (parts.has(FigurePart::title))
        y += add_title(sheet.title, panel, column, y, sheet.shapes);
    place(drawing_in_space(panel, size), {margin_of_sheet, y}, sheet);
    y += size.second;
    if (parts.has(FigurePart::caption))
        y += add_caption(caption, !options_.caption, column, y, sheet.shapes);
    if (parts.has(FigurePart::working))
        y += add_working(working, column, y, sheet.shapes);
    sheet.height = std::ceil(y + margin_of_sheet);
    sheet.description = said("The scene in space.") + (caption.empty() ? "" : " " + caption);
    return sheet;
}

Drawing FigureMaker::figure(std::size_t n) {
    Panel panel{.replay = replay_,
                .frame = frames_[n],
                .lattice = lattice_of(trace_, options_.region),
                .parts = {},
                .view = view_,
                .groups = groups_,
                .against = against_ ? &*against_ : nullptr,
                .has_colors = has_colors_};
    const ShownSteps steps = panel.frame.steps;

    // What is said of a step is said at the step; its pixels come after it.
    std::string caption = options_.caption.value_or("");
    std::vector<std::string> working;
    if (panel.is_step()) {
        replay_.go_to(steps.first);
        if (!options_.caption)
            caption = with_six_digits(describe_step(replay_));
        working = working_of(replay_);
    }
    replay_.go_to(panel.frame.is_question ? steps.first - 1 : steps.last);
    panel.subject = subject_of(replay_, steps.first);
    set_parts(options_, panel);

    const FigureParts& parts = panel.parts;
    // One of many frames may have nothing of what was asked for.
    const bool is_only = frames_.size() == 1;
    if (options_.is_in_space)
        return figure_in_space(panel, caption, working);
    Beside beside = beside_of(panel, is_only);
    for (Plot& plot : beside.plots) {
        plot.width /= options_.letter_scale;
        plot.area_height /= options_.letter_scale;
    }
    if (parts.has(FigurePart::space)) {
        const double side = Beside::side_of_scene(panel.lattice, options_.letter_scale);
        beside.space = drawing_in_space(panel, {side, side});
    }

    // The width of the sheet is that of the pixels, of the numbers at their left, and of what is beside them.
    Lattice& lattice = panel.lattice;
    const double margin = is_bare(parts) ? 0 : margin_of_sheet;
    const double numbers = parts.has(FigurePart::axes) ? axis_margin(lattice) : 0;
    lattice.corner.x = std::ceil(margin + numbers);
    Drawing sheet{.title = options_.title.value_or(trace_.title)};
    const double beside_left = lattice.corner.x + lattice.width();
    const double right =
        std::max(beside_left + beside.width_at_right(), margin + beside.width_below());
    sheet.width = std::ceil(std::max(
        right + margin, has_words(parts) ? narrowest_for_words / options_.letter_scale : 0));
    const Column column{margin, sheet.width - margin};

    // From the top to the bottom.
    double y = margin;
    if (parts.has(FigurePart::title))
        y += add_title(sheet.title, panel, column, y, sheet.shapes);
    lattice.corner.y = std::ceil(y);
    const double numbers_below = parts.has(FigurePart::axes) ? axis_height : 0;
    y = lattice.corner.y + lattice.height() + numbers_below;
    panel.sheet = {{}, sheet.width, y + margin};
    add_raster(panel, is_only ? options_.with : std::vector<FigurePart>(), sheet.shapes);
    add_notes(options_.notes, panel, sheet.shapes);
    y = std::max(y, lattice.corner.y + add_at_right(beside, lattice, beside_left, sheet));
    y += add_below(beside, lattice, column, y, sheet);
    if (parts.has(FigurePart::legend))
        y += add_legend(panel, options_.against_name, column, y, sheet.shapes);
    if (parts.has(FigurePart::caption))
        y += add_caption(caption, !options_.caption, column, y, sheet.shapes);
    if (parts.has(FigurePart::working))
        y += add_working(working, column, y, sheet.shapes);
    sheet.height = std::ceil(y + margin);
    sheet.description = said("{} x {} pixels, {} drawn.", lattice.columns(), lattice.rows(),
                             replay_.frame().image.drawn());
    if (!caption.empty())
        sheet.description += " " + caption;
    return sheet;
}

} // namespace rastertrace
