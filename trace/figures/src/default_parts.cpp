// SPDX-License-Identifier: MIT
// Which parts a figure has: those that were asked for, and those that make sense for its frame and its size.

#include "panel.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rastertrace {

namespace {

/// The largest pixels, and how wide and high they may be together, in units.
constexpr double largest_cell = 30;
constexpr double widest_panel = 560;
constexpr double highest_panel = 480;

// Parts that are there by themselves need pixels of at least so many units ...
constexpr double cell_for_grid = 5;
constexpr double cell_for_samples = 14;
constexpr double room_for_vertices = 150; ///< of all pixels together
constexpr double cell_for_digits = 9;
constexpr double cell_for_numbers = 40; ///< numbers of depths may enlarge pixels up to this
// ... and at most so many things.
constexpr std::size_t few_primitives = 6;
constexpr std::size_t few_vertices = 24;

/// What was asked for, of one part.
std::optional<bool> wanted(const FigureOptions& options, FigurePart part) {
    const auto is_in = [part](const std::vector<FigurePart>& list) {
        return std::find(list.begin(), list.end(), part) != list.end();
    };
    return is_in(options.without) ? std::optional(false)
           : is_in(options.with)  ? std::optional(true)
                                  : std::nullopt;
}

double side_by_canvas(const Lattice& lattice) {
    const double side =
        std::min({largest_cell, widest_panel / lattice.columns(), highest_panel / lattice.rows()});
    return std::max(1.0, std::floor(side));
}

} // namespace

void set_parts(const FigureOptions& options, Panel& panel) {
    Lattice& lattice = panel.lattice;
    lattice.cell = options.cell.value_or(side_by_canvas(lattice)) / options.letter_scale;
    const auto set = [&](FigurePart part, bool by_default) {
        panel.parts.set(part, wanted(options, part).value_or(by_default));
    };
    const auto make_room = [&] {
        if (!options.cell)
            lattice.cell = std::max(lattice.cell, std::ceil(cell_for_texts(panel, panel.parts)));
    };

    // What is written in the pixels makes them as large as it needs.
    for (const FigurePart part : {FigurePart::order, FigurePart::depths, FigurePart::weights,
                                  FigurePart::owners, FigurePart::levels})
        set(part, false);
    set(FigurePart::writes, panel.view == View::writes && lattice.cell >= cell_for_digits);
    const auto have_room = [&](FigurePart part) {
        FigureParts numbers;
        numbers.set(part, true);
        const double needed = cell_for_texts(panel, numbers);
        return needed <= (options.cell ? lattice.cell : cell_for_numbers);
    };
    if (panel.view == View::depth && !wanted(options, FigurePart::depths))
        set(FigurePart::depths, have_room(FigurePart::depths));
    make_room();

    // Grays mean nothing without numbers or a legend, half-planes nothing without a legend.
    const bool has_grays = (panel.view == View::depth && !panel.parts.has(FigurePart::depths)) ||
                           (panel.view == View::writes && !panel.parts.has(FigurePart::writes));
    set(FigurePart::half_planes, false);
    set(FigurePart::legend, panel.view == View::faces || panel.against != nullptr || has_grays ||
                                panel.parts.has(FigurePart::half_planes));

    // What the step is about.
    const bool is_step = panel.is_step();
    set(FigurePart::pixels, true);
    set(FigurePart::current, is_step);
    set(FigurePart::rejected, is_step);
    set(FigurePart::row, is_step || panel.frame.is_question);
    set(FigurePart::caption, is_step || options.caption.has_value());
    set(FigurePart::title, true);
    set(FigurePart::step, panel.parts.has(FigurePart::title));
    set(FigurePart::axes, true);

    // What needs room, and what is too much if there is too much of it.
    set(FigurePart::grid, lattice.cell >= cell_for_grid);
    set(FigurePart::samples, tests_samples(panel.trace()) && lattice.cell >= cell_for_samples &&
                                 !has_cell_texts(panel.parts));
    set(FigurePart::hidden_edges, false);
    panel.has_all_edges = !is_step || wanted(options, FigurePart::edges) == true ||
                          panel.parts.has(FigurePart::hidden_edges);
    const std::size_t with_edges = primitives_with_edges(panel).size();
    set(FigurePart::edges, panel.parts.has(FigurePart::hidden_edges) ||
                               (with_edges <= few_primitives && !has_cell_texts(panel.parts)));
    set(FigurePart::vertices, panel.parts.has(FigurePart::edges) &&
                                  3 * with_edges <= few_vertices &&
                                  lattice.cell * lattice.columns() >= room_for_vertices);
    set(FigurePart::coordinates, panel.parts.has(FigurePart::vertices));

    for (const FigurePart part :
         {FigurePart::errors, FigurePart::space, FigurePart::plot, FigurePart::working})
        set(part, false);
}

} // namespace rastertrace
