// SPDX-License-Identifier: MIT
// The pixels of a figure: what their colors mean, which are new, which were tested and not drawn.

#include "panel.h"

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>

namespace rastertrace {

namespace {

/// Collects pixels in rectangles, those beside one another in one.
class RunCollector {
public:
    explicit RunCollector(const Lattice& lattice) : lattice_(lattice) {}

    /// The next pixel of those to be painted, in the order of for_each_pixel.
    void add(Pixel pixel) {
        const Rectangle square = lattice_.square_of(pixel);
        if (last_ && last_->y == pixel.y && last_->x + 1 == pixel.x)
            rectangles_.back().width += square.width;
        else
            rectangles_.push_back(square);
        last_ = pixel;
    }

    std::vector<Rectangle> taken() && { return std::move(rectangles_); }

private:
    const Lattice& lattice_;
    std::vector<Rectangle> rectangles_;
    std::optional<Pixel> last_;
};

/// Pixels of different roles.
class RoleCollector {
public:
    explicit RoleCollector(const Lattice& lattice) : lattice_(lattice) {}
    void add(Role role, Pixel pixel) { runs_.try_emplace(role, lattice_).first->second.add(pixel); }
    void move_to(std::vector<Shape>& shapes) && {
        for (auto& [role, runs] : runs_)
            shapes.push_back(Areas{.role = role, .rectangles = std::move(runs).taken()});
    }

private:
    const Lattice& lattice_;
    std::map<Role, RunCollector> runs_;
};

/// The group of the face that has drawn a pixel.
std::optional<std::size_t> group_at(const Panel& panel, std::size_t offset) {
    const std::size_t step = panel.replay.frame().drawn_by[offset];
    if (step == 0)
        return std::nullopt;
    const auto found = panel.groups.group_of.find(panel.replay.primitive_of(step));
    return found == panel.groups.group_of.end() ? 0 : found->second;
}

void add_plotted(const Panel& panel, std::vector<Shape>& shapes) {
    RoleCollector pixels(panel.lattice);
    const Frame& frame = panel.replay.frame();
    const bool marks_current = panel.parts.has(FigurePart::current);
    // Faces that hide lines, and are not drawn themselves, are blank: the lines are black on them.
    bool hides_lines = false;
    for (std::size_t offset = 0; offset < frame.stored_by.size(); ++offset)
        hides_lines = hides_lines || (frame.stored_by[offset] != 0 && frame.drawn_by[offset] == 0);
    panel.for_each_pixel([&](Pixel pixel, std::size_t offset) {
        if (frame.drawn_by[offset] != 0)
            pixels.add(marks_current && panel.is_current(offset) ? Role::current
                       : hides_lines                             ? Role::ink
                                                                 : Role::plotted,
                       pixel);
    });
    std::move(pixels).move_to(shapes);
}

void add_in_ink(const Panel& panel, std::vector<Shape>& shapes) {
    RoleCollector pixels(panel.lattice);
    panel.for_each_pixel([&](Pixel pixel, std::size_t offset) {
        if (panel.replay.frame().drawn_by[offset] != 0)
            pixels.add(Role::ink, pixel);
    });
    std::move(pixels).move_to(shapes);
}

void add_faces(const Panel& panel, std::vector<Shape>& shapes) {
    RoleCollector pixels(panel.lattice);
    panel.for_each_pixel([&](Pixel pixel, std::size_t offset) {
        if (const auto group = group_at(panel, offset))
            pixels.add(face_role(*group), pixel);
    });
    std::move(pixels).move_to(shapes);
}

PixelColors shades(const Panel& panel) {
    return [&frame = panel.replay.frame(),
            empty = panel.trace().background.value_or(no_color)](Pixel, std::size_t offset) {
        return frame.drawn_by[offset] == 0 ? empty : frame.image.colors()[offset];
    };
}

PixelColors depth_shades(const Panel& panel) {
    const auto cells = std::make_shared<FrameCells>(View::depth, panel.replay, 1);
    return [cells](Pixel pixel, std::size_t) {
        const auto brightness = cells->at(pixel).brightness;
        return brightness ? gray(*brightness) : no_color;
    };
}

/// The more often a pixel was written, the darker.
PixelColors write_shades(const Panel& panel) {
    return [&writes = panel.replay.frame().writes](Pixel, std::size_t offset) {
        return writes[offset] == 0 ? no_color : gray(share_of_writes(writes[offset]));
    };
}

void add_colored(const Panel& panel, const PixelColors& color_of, std::vector<Shape>& shapes) {
    Pixels pixels{.corner = panel.lattice.corner,
                  .side = panel.lattice.cell,
                  .columns = static_cast<std::size_t>(panel.lattice.columns()),
                  .colors = {}};
    pixels.colors.reserve(pixels.columns * static_cast<std::size_t>(panel.lattice.rows()));
    panel.for_each_pixel(
        [&](Pixel pixel, std::size_t offset) { pixels.colors.push_back(color_of(pixel, offset)); });
    shapes.push_back(std::move(pixels));
}

void add_comparison(const Panel& panel, std::vector<Shape>& shapes) {
    RoleCollector pixels(panel.lattice);
    panel.for_each_pixel([&](Pixel pixel, std::size_t offset) {
        if (const ComparisonMark* const mark = comparison_at(panel, offset))
            pixels.add(mark->role, pixel);
    });
    std::move(pixels).move_to(shapes);
}

} // namespace

std::span<const ComparisonMark> comparison_marks() {
    static constexpr std::array<ComparisonMark, 4> marks{
        {{Role::same, ""}, {Role::only_here, "!"}, {Role::only_there, "?"}, {Role::differs, "~"}}};
    return marks;
}

const ComparisonMark* comparison_at(const Panel& panel, std::size_t offset) {
    const Frame& here = panel.replay.frame();
    const Frame& there = *panel.against;
    const bool is_here = here.drawn_by[offset] != 0;
    const bool is_there = there.drawn_by[offset] != 0;
    if (!is_here && !is_there)
        return nullptr;
    const bool is_alike = here.image.colors()[offset] == there.image.colors()[offset];
    return &comparison_marks()[is_here && is_there ? (is_alike ? 0 : 3) : (is_here ? 1 : 2)];
}

PixelColors own_colors_of(const Panel& panel) {
    if (panel.against != nullptr)
        return {};
    switch (panel.view) {
    case View::plotted:
    case View::coverage:
    case View::faces:
        return {};
    case View::shade:
        return panel.has_colors ? shades(panel) : PixelColors();
    case View::depth:
        return depth_shades(panel);
    case View::writes:
        return write_shades(panel);
    }
    return {};
}

void add_pixels(const Panel& panel, std::vector<Shape>& shapes) {
    if (panel.against != nullptr)
        add_comparison(panel, shapes);
    else if (const PixelColors own = own_colors_of(panel))
        add_colored(panel, own, shapes);
    else if (panel.view == View::faces)
        add_faces(panel, shapes);
    else if (panel.view == View::shade)
        add_in_ink(panel, shapes);
    else
        add_plotted(panel, shapes);
}

void add_current(const Panel& panel, std::vector<Shape>& shapes) {
    // In `plotted`, those that it has drawn have a color of their own.
    const bool have_color = panel.view == View::plotted && panel.against == nullptr;
    const StepSubject& subject = panel.subject;
    const bool has_subject = panel.is_step() && subject.pixels && !subject.is_row;
    if (have_color && !has_subject)
        return;
    const auto has_border = [&](Pixel pixel) {
        const bool is_drawn = panel.is_current(panel.lattice.canvas.offset_of(pixel));
        return (is_drawn && !have_color) || (!is_drawn && has_subject && subject.has(pixel));
    };
    Lines border{.role = Role::current_border};
    panel.for_each_pixel([&](Pixel pixel, std::size_t) {
        if (!has_border(pixel))
            return;
        const auto is_current = [&](int dx, int dy) {
            const Pixel other{pixel.x + dx, pixel.y + dy * panel.lattice.canvas.down()};
            return panel.lattice.has(other) && has_border(other);
        };
        const Place at = panel.lattice.corner_of(pixel);
        const double cell = panel.lattice.cell;
        if (!is_current(0, -1))
            border.paths.push_back({at, {at.x + cell, at.y}});
        if (!is_current(0, 1))
            border.paths.push_back({{at.x, at.y + cell}, {at.x + cell, at.y + cell}});
        if (!is_current(-1, 0))
            border.paths.push_back({at, {at.x, at.y + cell}});
        if (!is_current(1, 0))
            border.paths.push_back({{at.x + cell, at.y}, {at.x + cell, at.y + cell}});
    });
    shapes.push_back(std::move(border));
}

void add_rejected(const Panel& panel, std::vector<Shape>& shapes) {
    const std::set<std::size_t> offsets = pixels_not_drawn(panel.trace(), panel.frame.steps);
    Lines crosses{.role = Role::rejected};
    panel.for_each_pixel([&](Pixel pixel, std::size_t offset) {
        if (!offsets.contains(offset))
            return;
        const Place at = panel.lattice.corner_of(pixel);
        const double near = 0.25 * panel.lattice.cell;
        const double far = 0.75 * panel.lattice.cell;
        crosses.paths.push_back({{at.x + near, at.y + near}, {at.x + far, at.y + far}});
        crosses.paths.push_back({{at.x + near, at.y + far}, {at.x + far, at.y + near}});
    });
    if (!crosses.paths.empty())
        shapes.push_back(std::move(crosses));
}

} // namespace rastertrace
