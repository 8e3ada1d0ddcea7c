// SPDX-License-Identifier: MIT
// The row that a step is about: where the edges meet it, exactly, and how each end becomes a pixel.

#include "panel.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/working.h>

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

/// One end of a row.
struct RowEnd {
    double at;                  ///< x where the edge meets the row
    std::string text;           ///< the same, as the trace has it
    std::optional<Index> pixel; ///< the x of the pixel that it is rounded to, if the step says so
    bool is_left;
};

void add_end(const TracedNumber& end, std::optional<Index> pixel, std::vector<RowEnd>& ends) {
    const auto at = end.nearest_double();
    if (!at)
        return;
    std::string text = as_in_working(end.text());
    constexpr std::size_t most_letters = 8; // a sign, a point and six digits
    if (text.size() > most_letters && text.find('/') == std::string::npos)
        text = fmt::format("{:.6g}", *at);
    ends.push_back({*at, std::move(text), pixel, ends.size() % 2 == 0});
}

/// The two ends of a scanline, or where a row of a polygon meets its edges.
std::vector<RowEnd> ends_of(const Trace& trace, std::size_t row) {
    std::vector<RowEnd> ends;
    if (trace.kind_of(row) == StepKind::scanline) {
        const auto step = trace.step(row).as<ScanlineStep>();
        add_end(step.left, step.from, ends);
        add_end(step.right, step.to, ends);
    } else {
        for (const TracedNumber& x : trace.step(row).as<CrossingsStep>().x.values())
            add_end(x, std::nullopt, ends);
    }
    return ends;
}

} // namespace

void add_row(const Panel& panel, std::vector<Shape>& shapes) {
    const StepSubject& subject = panel.subject;
    if (!subject.pixels || (!subject.is_row && subject.row == 0))
        return;
    const Lattice& lattice = panel.lattice;
    const Rectangle frame = lattice.frame();
    const double right = frame.right();
    const auto y_of = [&lattice](int row) { return lattice.place_of(0, row).y; };
    const auto is_shown = [&lattice](int row) { return lattice.has({lattice.region.x0, row}); };
    const auto& [first, last] = std::pair(subject.pixels->y0, subject.pixels->y1);
    for (const int row : std::set{first, last})
        if (is_shown(row))
            shapes.push_back(Lines{.role = Role::row,
                                   .paths = {{{frame.corner.x, y_of(row)}, {right, y_of(row)}}}});
    if (panel.frame.is_question || subject.row == 0 || !is_shown(first))
        return;
    const double y = y_of(first);

    constexpr double radius = 3;
    constexpr double text_size = 10;
    constexpr double gap = 6;
    constexpr double head = 6;
    for (const RowEnd& end : ends_of(panel.trace(), subject.row)) {
        const bool is_left = end.is_left;
        const double x = lattice.place_of(end.at, 0).x;
        if (!(frame.corner.x <= x && x <= right))
            continue;
        shapes.push_back(Dots{.role = Role::row_end, .radius = radius, .centers = {{x, y}}});

        // The arrow runs a little below the row, from where the edge is to the pixel's own place.
        const bool is_rounded = end.pixel && static_cast<double>(*end.pixel) != end.at;
        if (is_rounded && lattice.canvas.contains(*end.pixel, first)) {
            const double below = y + 0.3 * lattice.cell;
            const double pixel_x = lattice.place_of(static_cast<double>(*end.pixel), 0).x;
            if (frame.corner.x <= pixel_x && pixel_x <= right) {
                shapes.push_back(Lines{.role = Role::row_end, .paths = {{{x, y}, {x, below}}}});
                add_arrow({x, below}, {pixel_x, below}, Role::rounding,
                          std::min(head, 0.4 * lattice.cell), shapes);
            }
        }
        shapes.push_back(Label{.role = Role::row_end,
                               .at = {x + (is_left ? -gap : gap), y - gap},
                               .text = end.text,
                               .size = text_size,
                               .anchor = is_left ? Anchor::end : Anchor::start,
                               .is_bold = true,
                               .has_rim = true});
    }
}

} // namespace rastertrace
