// SPDX-License-Identifier: MIT
#include <rastertrace/figures/figure.h>

#include "clip.h"
#include "panel.h"

#include <rastertrace/trace/describe.h>
#include <rastertrace/trace/text.h>
#include <rastertrace/trace/working.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace rastertrace {

namespace {

constexpr std::array parts{
    FigurePartRow{FigurePart::grid, "grid", "lines between the pixels",
                  "where pixels are large enough"},
    FigurePartRow{FigurePart::axes, "axes",
                  "the numbers of columns and rows, and where x and y are 0", "always"},
    FigurePartRow{FigurePart::edges, "edges", "the true edges of primitives, over the pixels",
                  "of the step's primitive; at the end, of all if they are few"},
    FigurePartRow{FigurePart::vertices, "vertices", "their vertices, with coordinates",
                  "with edges"},
    FigurePartRow{FigurePart::samples, "samples", "the place where each pixel is tested",
                  "for fills that test samples"},
    FigurePartRow{FigurePart::row, "row",
                  "the row of a scanline, its exact ends, and arrows to the pixels that they are "
                  "rounded to",
                  "for a scanline"},
    FigurePartRow{FigurePart::pixels, "pixels", "the pixels drawn so far, colored by --view",
                  "always"},
    FigurePartRow{FigurePart::current, "current", "which of them this step has drawn",
                  "for a step"},
    FigurePartRow{FigurePart::rejected, "rejected",
                  "a cross where the step has tested a pixel and not drawn it", "for a step"},
    FigurePartRow{FigurePart::order, "order", "in each pixel, as the how manieth it was drawn",
                  "never"},
    FigurePartRow{FigurePart::depths, "depths", "in each pixel, what the depth buffer holds",
                  "in the view depth, where the numbers fit"},
    FigurePartRow{FigurePart::writes, "writes", "in each pixel, how often it was written",
                  "in the view writes"},
    FigurePartRow{FigurePart::weights, "weights", "in each pixel that was tested, its weights",
                  "never"},
    FigurePartRow{FigurePart::patterns, "patterns",
                  "a pattern for each face, so that they differ without color",
                  "in the view faces"},
    FigurePartRow{FigurePart::half_planes, "half-planes",
                  "for each edge of a triangle the side where its function is not negative",
                  "never"},
    FigurePartRow{FigurePart::errors, "errors",
                  "below or beside Bresenham's line, d at each of its decisions", "never"},
    FigurePartRow{FigurePart::scene, "scene",
                  "beside the picture, the scene in space: wireframe, eye, view plane, normals",
                  "never"},
    FigurePartRow{FigurePart::plot, "plot",
                  "below, depths along the row: as drawn, and the true curve", "never"},
    FigurePartRow{FigurePart::title, "title", "the title of the scene, and which step it is",
                  "always"},
    FigurePartRow{FigurePart::legend, "legend", "what colors and patterns stand for",
                  "in the view faces, and for --against"},
    FigurePartRow{FigurePart::caption, "caption", "what the step says, or --caption TEXT",
                  "for a step"},
    FigurePartRow{FigurePart::working, "working", "below it, how its numbers come of one another",
                  "never"},
};
static_assert(parts.size() == figure_part_count);

constexpr std::array<std::string_view, 2> palettes{"distinct", "scene"};

// Sizes in units.
constexpr double margin = 10;
constexpr double title_size = 13;
constexpr double title_height = 22;
constexpr double step_size = 9;
constexpr double caption_size = 11;
constexpr double caption_line = 15;
constexpr double working_size = 9.5;
constexpr double working_line = 13;
constexpr double legend_size = 10;
constexpr double legend_line = 16;
constexpr double swatch = 11;
constexpr double narrowest = 300; ///< of a figure with words

/// More groups of faces than can be told apart: eight colors, each with eight patterns.
constexpr std::size_t most_groups = 64;

/// The largest pixels, and how wide and high they may be together.
constexpr double largest_cell = 30;
constexpr double widest_panel = 560;
constexpr double highest_panel = 480;

// What is drawn where nothing was asked for: pixels of at least so many units ...
constexpr double cell_for_grid = 5;
constexpr double cell_for_patterns = 6;
constexpr double cell_for_samples = 9;
constexpr double cell_for_numbers = 40; ///< numbers may enlarge pixels up to this
// ... and at most so many
constexpr std::size_t few_primitives = 6;
constexpr std::size_t few_vertices = 24;
constexpr std::size_t few_legends = 24;

double side_by_canvas(const Lattice& lattice) {
    const double side =
        std::min({largest_cell, widest_panel / lattice.columns(), highest_panel / lattice.rows()});
    return std::max(1.0, std::floor(side));
}

Lattice lattice_of(const Trace& trace, const std::optional<Region>& region) {
    const Canvas& canvas = trace.canvas;
    const Region all{.x0 = canvas.left(),
                     .y0 = std::min(canvas.top(), canvas.bottom()),
                     .x1 = canvas.right(),
                     .y1 = std::max(canvas.top(), canvas.bottom())};
    return {.canvas = canvas,
            .region = region.value_or(all),
            .has_center_samples = trace.samples_at_centers(),
            .cell = 1,
            .corner = {}};
}

bool tests_samples(const Trace& trace) {
    const std::string fill = trace.method_value("fill");
    return fill == "barycentric" || fill == "top-left";
}

/// The words of a title line: which steps are shown.
std::string steps_text(const FigureFrame& frame, const Trace& trace) {
    const auto [first, last] = frame.steps;
    if (frame.is_question)
        return fmt::format("before step {} of {}", trace.number_of(first), trace.size());
    if (first == last || first == 0)
        return fmt::format("step {} of {}", trace.number_of(last), trace.size());
    return fmt::format("steps {} to {} of {}", trace.number_of(first), trace.number_of(last),
                       trace.size());
}

/// A swatch of a legend, and its words.
struct LegendEntry {
    Role role;
    std::optional<std::size_t> pattern;
    std::optional<Color> color;
    std::string text;
};

/// Sets the entries in lines, from a place on; returns how high they are.
double add_legend(const std::vector<LegendEntry>& entries, Place corner, double width,
                  std::vector<Shape>& shapes) {
    double x = corner.x;
    double y = corner.y;
    for (const LegendEntry& entry : entries) {
        constexpr double gap = 5;
        const double needed = swatch + gap + width_of(entry.text, legend_size) + 2 * gap;
        if (x > corner.x && x + needed > corner.x + width) {
            x = corner.x;
            y += legend_line;
        }
        const Rectangle box{{x, y}, swatch, swatch};
        shapes.push_back(Areas{.role = entry.role, .color = entry.color, .rectangles = {box}});
        if (entry.pattern)
            shapes.push_back(
                Lines{.role = Role::pattern, .paths = pattern_strokes(*entry.pattern, box)});
        shapes.push_back(Lines{.role = Role::grid, .paths = {corners_of(box)}, .are_closed = true});
        shapes.push_back(Label{
            .at = {x + swatch + gap, y + 0.85 * swatch}, .text = entry.text, .size = legend_size});
        x += needed;
    }
    return entries.empty() ? 0 : y + legend_line - corner.y;
}

} // namespace

std::span<const FigurePartRow> figure_parts() {
    return parts;
}

std::optional<FigurePart> figure_part_named(std::string_view name) {
    const auto found = std::find_if(parts.begin(), parts.end(),
                                    [name](const FigurePartRow& row) { return row.name == name; });
    return found == parts.end() ? std::nullopt : std::optional(found->part);
}

std::vector<std::string_view> face_palette_names() {
    return {palettes.begin(), palettes.end()};
}

std::optional<FacePalette> face_palette_named(std::string_view name) {
    const auto found = std::find(palettes.begin(), palettes.end(), name);
    if (found == palettes.end())
        return std::nullopt;
    return static_cast<FacePalette>(found - palettes.begin());
}

FigureMaker::FigureMaker(const Trace& trace, std::vector<FigureFrame> frames, FigureOptions options)
    : trace_(trace), frames_(std::move(frames)), options_(std::move(options)),
      view_(options_.view.value_or(default_view(trace))),
      replay_(trace, {.writes = true, .depths = true}) {
    std::vector<std::size_t> painted;
    std::size_t order = 0;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (kind == StepKind::order)
            order = n;
        if (kind == StepKind::primitive && trace.step(n).text("painted") != "false")
            painted.push_back(n);
    }
    groups_ = face_groups(trace, std::move(painted), order, most_groups);
    if (options_.against != nullptr)
        against_ = frame_after(*options_.against, options_.against->size());
}

Drawing FigureMaker::figure(std::size_t n) {
    const FigureFrame& frame = frames_[n];
    const bool is_step = frame.steps.first != 0 && !frame.is_question;

    // What is said of the step is said at the step; its pixels come after it.
    std::string caption = options_.caption.value_or("");
    std::vector<std::string> working;
    if (is_step) {
        replay_.go_to(frame.steps.first);
        if (!options_.caption)
            caption = describe_step(replay_);
        working = working_of(replay_);
    }
    replay_.go_to(frame.is_question ? frame.steps.first - 1 : frame.steps.last);

    Panel panel{.replay = replay_,
                .frame = frame,
                .lattice = lattice_of(trace_, options_.region),
                .parts = {},
                .view = view_,
                .groups = groups_,
                .palette = options_.palette,
                .against = against_ ? &*against_ : nullptr};
    Lattice& lattice = panel.lattice;
    FigureParts& shown = panel.parts;
    lattice.cell = options_.cell.value_or(side_by_canvas(lattice));

    // What is there by itself, and what was asked for.
    const bool is_row = is_step && trace_.kind_of(frame.steps.first) == StepKind::scanline;
    const auto is_wanted = [this](FigurePart part) {
        const auto names = [part](const std::vector<FigurePart>& list) {
            return std::find(list.begin(), list.end(), part) != list.end();
        };
        return names(options_.without) ? std::optional(false)
               : names(options_.with)  ? std::optional(true)
                                       : std::nullopt;
    };
    const auto decide = [&](FigurePart part, bool by_default) {
        shown.set(part, is_wanted(part).value_or(by_default));
    };
    decide(FigurePart::depths, false);
    decide(FigurePart::order, false);
    decide(FigurePart::weights, false);
    decide(FigurePart::writes, false);
    if (!options_.cell) {
        const double needed = cell_for_texts(replay_, shown);
        lattice.cell = std::max(lattice.cell, std::ceil(needed));
    }
    if (view_ == View::depth && !is_wanted(FigurePart::depths)) {
        FigureParts numbers;
        numbers.set(FigurePart::depths, true);
        const double needed = cell_for_texts(replay_, numbers);
        if (needed <= (options_.cell ? lattice.cell : cell_for_numbers)) {
            shown.set(FigurePart::depths, true);
            lattice.cell = std::max(lattice.cell, std::ceil(needed));
        }
    }
    const double cell = lattice.cell;
    decide(FigurePart::writes, view_ == View::writes && cell >= cell_for_samples);
    panel.has_all_edges = !is_step || is_wanted(FigurePart::edges) == true;
    const std::size_t edged = primitives_with_edges(panel).size();
    decide(FigurePart::grid, cell >= cell_for_grid);
    decide(FigurePart::axes, true);
    decide(FigurePart::edges, edged <= few_primitives);
    decide(FigurePart::vertices, shown.has(FigurePart::edges) && 3 * edged <= few_vertices);
    decide(FigurePart::samples,
           tests_samples(trace_) && cell >= cell_for_samples && !shown.has(FigurePart::weights));
    decide(FigurePart::row, is_row || frame.is_question);
    decide(FigurePart::pixels, true);
    decide(FigurePart::current, is_step);
    decide(FigurePart::rejected, is_step);
    decide(FigurePart::patterns,
           view_ == View::faces && cell >= cell_for_patterns && !panel.against);
    decide(FigurePart::half_planes, false);
    decide(FigurePart::errors, false);
    decide(FigurePart::scene, false);
    decide(FigurePart::plot, false);
    decide(FigurePart::title, true);
    decide(FigurePart::legend, view_ == View::faces || panel.against != nullptr);
    decide(FigurePart::caption, is_step || options_.caption.has_value());
    decide(FigurePart::working, false);

    // The sheet, from the top.
    Drawing sheet;
    sheet.title = trace_.title;
    double y = margin + (shown.has(FigurePart::title) ? title_height : 0);
    lattice.corner = {margin + (shown.has(FigurePart::axes) ? axis_margin(lattice) : 0),
                      std::round(y)};
    lattice.corner.x = std::round(lattice.corner.x);
    const double right = lattice.corner.x + lattice.width();
    const bool has_words = shown.has(FigurePart::title) || shown.has(FigurePart::caption) ||
                           shown.has(FigurePart::working);
    sheet.width = std::ceil(std::max(right + margin, has_words ? narrowest : 0));

    std::vector<Shape>& shapes = sheet.shapes;
    if (shown.has(FigurePart::title)) {
        const std::string steps = steps_text(frame, trace_);
        const double room = sheet.width - 2 * margin - width_of(steps, step_size) - margin;
        shapes.push_back(
            Label{.role = Role::strong_text,
                  .at = {margin, margin + title_size - 1},
                  .text = shortened(printable(trace_.title),
                                    static_cast<std::size_t>(room / width_of("x", title_size))),
                  .size = title_size,
                  .is_bold = true});
        shapes.push_back(Label{.role = Role::quiet_text,
                               .at = {sheet.width - margin, margin + title_size - 1},
                               .text = steps,
                               .size = step_size,
                               .anchor = Anchor::end});
    }
    using AddPart = void (*)(const Panel&, std::vector<Shape>&);
    constexpr std::array<std::pair<FigurePart, AddPart>, 11> on_pixels{
        {{FigurePart::pixels, add_pixels},
         {FigurePart::patterns, add_patterns},
         {FigurePart::half_planes, add_half_planes},
         {FigurePart::grid, add_grid},
         {FigurePart::axes, add_axes},
         {FigurePart::current, add_current},
         {FigurePart::samples, add_samples},
         {FigurePart::edges, add_edges},
         {FigurePart::rejected, add_rejected},
         {FigurePart::row, add_row},
         {FigurePart::vertices, add_vertices}}};
    for (const auto& [part, add] : on_pixels)
        if (shown.has(part))
            add(panel, shapes);
    add_cell_texts(panel, shapes);
    if (shown.has(FigurePart::grid) || shown.has(FigurePart::axes))
        add_border(panel, shapes);
    y = lattice.corner.y + lattice.height() + (shown.has(FigurePart::axes) ? axis_height : 0) + 6;

    if (shown.has(FigurePart::legend)) {
        std::vector<LegendEntry> entries;
        if (panel.against) {
            entries = {{Role::plotted, {}, {}, "the same"},
                       {Role::only_here, {}, {}, "only " + printable(trace_.title)},
                       {Role::only_there, {}, {}, "only " + printable(options_.against_name)},
                       {Role::differs, {}, {}, "in another color"}};
        } else if (groups_.names.size() <= few_legends) {
            for (std::size_t i = 0; i < groups_.names.size(); ++i)
                entries.push_back(
                    {face_role(i),
                     shown.has(FigurePart::patterns) ? std::optional(i) : std::nullopt,
                     {},
                     printable(groups_.names[i])});
        }
        y += add_legend(entries, {margin, y}, sheet.width - 2 * margin, shapes);
    }

    const auto add_lines = [&](const std::vector<std::string>& lines, double size, double height,
                               bool is_fixed) {
        for (const std::string& line : lines) {
            shapes.push_back(Label{.at = {margin, y + 0.8 * size},
                                   .text = line,
                                   .size = size,
                                   .is_fixed_width = is_fixed});
            y += height;
        }
    };
    const auto columns = [&sheet](double size) {
        return static_cast<std::size_t>((sheet.width - 2 * margin) / width_of("x", size));
    };
    if (shown.has(FigurePart::caption)) {
        y += 4;
        add_lines(wrapped(printable(caption), columns(caption_size)), caption_size, caption_line,
                  false);
    }
    if (shown.has(FigurePart::working)) {
        y += 4;
        std::vector<std::string> lines;
        for (const std::string& line : working)
            for (std::string& piece : wrapped(line, columns(working_size)))
                lines.push_back(std::move(piece));
        add_lines(lines, working_size, working_line, true);
    }
    sheet.height = std::ceil(y + margin - 4);
    sheet.description = fmt::format("{} x {} pixels, {} drawn. {}", lattice.columns(),
                                    lattice.rows(), replay_.frame().image.drawn(), caption);
    return sheet;
}

} // namespace rastertrace
