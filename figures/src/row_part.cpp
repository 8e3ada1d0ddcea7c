// SPDX-License-Identifier: MIT
// The row that a step is about: where the edges meet it, exactly, and how each end becomes a pixel.

#include "panel.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/working.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace rastertrace {

namespace {

/// One end of a row.
struct RowEnd {
    double at;        ///< x where the edge meets the row
    std::string text; ///< the same, as the trace has it
    Index pixel;      ///< the x of the pixel that it is rounded to
    bool is_left;
};

std::optional<RowEnd> end_of_row(const ScanlineStep& row, bool is_left) {
    const TracedNumber end = is_left ? row.left : row.right;
    const auto at = end.nearest_double();
    if (!at)
        return std::nullopt;
    std::string text = as_in_working(end.text());
    constexpr std::size_t most_letters = 8; // a sign, a point and six digits
    if (text.size() > most_letters && text.find('/') == std::string::npos)
        text = fmt::format("{:.6g}", *at);
    return RowEnd{*at, std::move(text), is_left ? row.from : row.to, is_left};
}

} // namespace

void add_row(const Panel& panel, std::vector<Shape>& shapes) {
    const std::size_t n =
        panel.frame.is_question ? panel.frame.steps.first : panel.replay.scanline();
    // Of a step that has several rows, none is shown.
    if (n == 0 || n > panel.frame.steps.first || panel.trace().kind_of(n) != StepKind::scanline)
        return;
    const auto row = panel.trace().step(n).as<ScanlineStep>();
    const Lattice& lattice = panel.lattice;
    if (!panel.lattice.canvas.contains(lattice.region.x0, row.y) ||
        !lattice.has({lattice.region.x0, static_cast<int>(row.y)}))
        return;
    const double y = lattice.place_of(0, static_cast<double>(row.y)).y;
    const Rectangle frame = lattice.frame();
    const double right = frame.right();
    shapes.push_back(Lines{.role = Role::row, .paths = {{{frame.corner.x, y}, {right, y}}}});
    if (panel.frame.is_question)
        return;

    constexpr double radius = 3;
    constexpr double text_size = 10;
    constexpr double gap = 6;
    constexpr double head = 6;
    for (const bool is_left : {true, false}) {
        const auto end = end_of_row(row, is_left);
        if (!end)
            continue;
        const double x = lattice.place_of(end->at, 0).x;
        if (!(frame.corner.x <= x && x <= right))
            continue;
        shapes.push_back(Dots{.role = Role::row_end, .radius = radius, .centers = {{x, y}}});

        // The arrow runs a little below the row, from where the edge is to the pixel's own place.
        const bool is_rounded = static_cast<double>(end->pixel) != end->at;
        if (is_rounded && lattice.canvas.contains(end->pixel, row.y)) {
            const double below = y + 0.3 * lattice.cell;
            const double pixel_x = lattice.place_of(static_cast<double>(end->pixel), 0).x;
            if (frame.corner.x <= pixel_x && pixel_x <= right) {
                shapes.push_back(Lines{.role = Role::row_end, .paths = {{{x, y}, {x, below}}}});
                add_arrow({x, below}, {pixel_x, below}, Role::rounding,
                          std::min(head, 0.4 * lattice.cell), shapes);
            }
        }
        shapes.push_back(Label{.role = Role::row_end,
                               .at = {x + (is_left ? -gap : gap), y - gap},
                               .text = end->text,
                               .size = text_size,
                               .anchor = is_left ? Anchor::end : Anchor::start,
                               .is_bold = true,
                               .has_rim = true});
    }
}

} // namespace rastertrace
