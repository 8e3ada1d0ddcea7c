// SPDX-License-Identifier: MIT
#include <rastertrace/figures/plot.h>

#include "label_places.h"
#include "plot_axis.h"

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

// The parts of a plot, in units. Left of the area of marks are the numbers of the y axis.
constexpr double area_left = 58;
constexpr double room_at_right = 14;
constexpr double margin = 14;     ///< between the sheet's edge and what is on it
constexpr double shelf_slot = 13; ///< on the shelf every curve has a column
constexpr double shelf_gap = 14;  ///< between the shelf and the axis
constexpr double mark_radius = 4;
constexpr double ring_radius = 7;
constexpr double title_size = 12;
constexpr double name_size = 11; ///< of axes and curves
constexpr double text_size = 10; ///< of numbers and captions
constexpr double label_size = 9.5;
constexpr double power_size = 8;
constexpr double line_height = 1.3; ///< of text, times its size

/// Marks nearer to one another than this share a label.
constexpr double same_place = 7;

/// Text in lines of at most `width` units.
std::vector<std::string> lines_of(std::string_view text, double size, double width) {
    return wrapped(text, letters_in(width, size));
}

// Marks. Their outlines are filled, not drawn: a curve's dashes would cut them up.

Path scaled(const Path& outline, double factor, Place center) {
    Path path;
    for (const Place& place : outline)
        path.push_back({center.x + factor * place.x, center.y + factor * place.y});
    return path;
}

/// The outlines of marks with corners, 1 unit wide from their centers.
const std::array<Path, 6>& outlines() {
    constexpr double a = 0.28; // half the width of a bar
    static const std::array<Path, 6> all{{
        {{-0.85, -0.85}, {0.85, -0.85}, {0.85, 0.85}, {-0.85, 0.85}},
        {{0, -1.2}, {1.2, 0}, {0, 1.2}, {-1.2, 0}},
        {{0, -1.1}, {1.1, 0.9}, {-1.1, 0.9}},
        {{0, 1.1}, {1.1, -0.9}, {-1.1, -0.9}},
        {{-a, -1},
         {a, -1},
         {a, -a},
         {1, -a},
         {1, a},
         {a, a},
         {a, 1},
         {-a, 1},
         {-a, a},
         {-1, a},
         {-1, -a},
         {-a, -a}},
        {{0, -0.4},
         {0.6, -1},
         {1, -0.6},
         {0.4, 0},
         {1, 0.6},
         {0.6, 1},
         {0, 0.4},
         {-0.6, 1},
         {-1, 0.6},
         {-0.4, 0},
         {-1, -0.6},
         {-0.6, -1}},
    }};
    return all;
}

/// How the marks of a curve look: a circle, or an outline; filled or hollow.
struct MarkStyle {
    std::optional<std::size_t> outline;
    bool is_filled = true;
};
const MarkStyle& mark_style(std::size_t curve) {
    static const std::array<MarkStyle, 12> styles{{{std::nullopt, true},
                                                   {0, true},
                                                   {1, true},
                                                   {2, true},
                                                   {std::nullopt, false},
                                                   {0, false},
                                                   {1, false},
                                                   {2, false},
                                                   {3, true},
                                                   {4, true},
                                                   {5, true},
                                                   {3, false}}};
    return styles[curve % styles.size()];
}

void add_mark(std::size_t curve, Place at, std::vector<Shape>& shapes) {
    constexpr double hollow = 0.6; // of the radius
    const MarkStyle& style = mark_style(curve);
    const auto add = [&](Role role, double radius) {
        if (style.outline)
            shapes.push_back(
                Polygons{.role = role, .paths = {scaled(outlines()[*style.outline], radius, at)}});
        else
            shapes.push_back(Dots{.role = role, .radius = 0.9 * radius, .centers = {at}});
    };
    add(curve_role(curve), mark_radius);
    if (!style.is_filled)
        add(Role::paper, hollow * mark_radius);
}

/// The ring of the Pareto front.
void add_ring(Place at, std::vector<Shape>& shapes) {
    constexpr int corners = 24;
    Path ring;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        ring.push_back(
            {at.x + ring_radius * std::cos(angle), at.y + ring_radius * std::sin(angle)});
    }
    shapes.push_back(Lines{.role = Role::border, .paths = {ring}, .are_closed = true});
}

/// Some marks of a curve that lie on one another, and what is written beside them.
struct MarkGroup {
    std::size_t curve;
    Place at;
    double reach; ///< of the marks, from there
    std::string label;
};

/// A name, once: "8, 12".
void add_name(std::string& label, const std::string& name) {
    if (label.empty())
        label = name;
    else if (label != name && !label.ends_with(", " + name))
        label += ", " + name;
}

class PlotDrawer {
public:
    explicit PlotDrawer(const Plot& plot) : plot_(plot) {}

    Drawing drawn() {
        drawing_ = {.width = plot_.width, .title = plot_.title, .description = plot_.caption};
        double y = add_lines(plot_.title, title_size, 18, true);
        top_ = y - title_size * line_height + 12;
        bottom_ = top_ + plot_.area_height;
        find_axes();
        add_frame();
        for (std::size_t i = 0; i < plot_.curves.size(); ++i)
            add_line(i);
        for (std::size_t i = 0; i < plot_.curves.size(); ++i)
            add_marks(i);
        const std::string left_out = add_labels();
        y = add_lines(plot_.caption, text_size, bottom_ + 52, false);
        if (!left_out.empty())
            y = add_lines("No room for labels of " + left_out + ".", text_size, y, false);
        drawing_.height = std::ceil(y);
        return std::move(drawing_);
    }

private:
    /// Lines of text from the margin on, the first one at this height; returns the height of the next.
    double add_lines(std::string_view text, double size, double y, bool is_bold) {
        for (std::string& line : lines_of(text, size, plot_.width - 2 * margin)) {
            add(Label{.role = is_bold ? Role::strong_text : Role::text,
                      .at = {margin, y},
                      .text = std::move(line),
                      .size = size,
                      .is_bold = is_bold});
            y += size * line_height;
        }
        return y;
    }

    void add(Shape shape) { drawing_.shapes.push_back(std::move(shape)); }

    double area_right() const { return plot_.width - room_at_right; }

    bool has_shelf() const { return plot_.x.scale == PlotScale::logarithmic; }

    void find_axes() {
        std::vector<double> xs;
        std::vector<double> ys;
        for (const PlotCurve& curve : plot_.curves)
            for (const PlotMark& mark : curve.marks) {
                xs.push_back(mark.x);
                ys.push_back(mark.y);
            }
        has_values_ =
            std::any_of(xs.begin(), xs.end(), [this](double x) { return x > 0 || !has_shelf(); });
        const double slots = static_cast<double>(plot_.curves.size()) + 1;
        shelf_right_ = has_shelf() ? area_left + shelf_slot * slots : area_left;
        // There is room for labels right of the last mark.
        x_ = axis_around(xs, {has_shelf() ? shelf_right_ + shelf_gap : area_left, area_right()},
                         plot_.x.scale, {.below = 2, .above = 3});
        y_ = axis_around(ys, {bottom_, top_}, plot_.y.scale, {.below = 1.5, .above = 1.5});
    }

    Place place_of(std::size_t curve, const PlotMark& mark) const {
        const bool is_on_shelf = has_shelf() && mark.x <= 0;
        const double slot = shelf_slot * (static_cast<double>(curve) + 1);
        return {is_on_shelf ? area_left + slot : x_.at(mark.x), y_.at(mark.y)};
    }

    void add_frame() {
        if (has_shelf())
            add(Areas{
                .role = Role::shelf,
                .rectangles = {{{area_left, top_}, shelf_right_ - area_left, plot_.area_height}}});
        add_ticks();
        std::vector<Path> borders;
        if (has_shelf()) {
            add(Label{.role = Role::strong_text,
                      .at = {(area_left + shelf_right_) / 2, bottom_ + 15},
                      .text = "0",
                      .size = title_size,
                      .anchor = Anchor::middle,
                      .is_bold = true});
            add(Lines{.role = Role::border,
                      .paths = {{{shelf_right_, top_}, {shelf_right_, bottom_}}}});
        }
        add(Lines{.role = Role::border,
                  .paths = {{{area_left, top_},
                             {area_right(), top_},
                             {area_right(), bottom_},
                             {area_left, bottom_}}},
                  .are_closed = true});
        const double middle = (top_ + bottom_) / 2;
        add(Label{.at = {(area_left + area_right()) / 2, bottom_ + 33},
                  .text = plot_.x.label,
                  .size = name_size,
                  .anchor = Anchor::middle});
        add(Label{.at = {14, middle},
                  .text = plot_.y.label,
                  .size = name_size,
                  .anchor = Anchor::middle,
                  .is_turned = true});
        if (!has_values_ && !plot_.only_shelf.empty())
            add(Label{.at = {(shelf_right_ + area_right()) / 2, middle},
                      .text = plot_.only_shelf,
                      .size = name_size,
                      .anchor = Anchor::middle});
    }

    /// Lines across the plot, and their numbers as far as they do not collide.
    void add_ticks() {
        Lines lines{.role = Role::grid};
        std::vector<Rectangle> numbers;
        for (const Tick& tick : ticks_of(y_)) {
            const double y = y_.at(tick.value);
            lines.paths.push_back({{area_left, y}, {area_right(), y}});
            add_number(tick, {area_left - 5, y + 3.5}, Anchor::end, numbers);
        }
        if (has_values_)
            for (const Tick& tick : ticks_of(x_)) {
                const double x = x_.at(tick.value);
                lines.paths.push_back({{x, top_}, {x, bottom_}});
                add_number(tick, {x, bottom_ + 15}, Anchor::middle, numbers);
            }
        add(std::move(lines));
    }

    void add_number(const Tick& tick, Place at, Anchor anchor, std::vector<Rectangle>& numbers) {
        const double tick_width = width_of(tick.text, text_size);
        const double width = tick_width + width_of(tick.power, power_size);
        const double left = anchor == Anchor::end ? at.x - width : at.x - width / 2;
        const Rectangle box{{left - 2, at.y - text_size}, width + 4, text_size + 2};
        if (std::any_of(numbers.begin(), numbers.end(),
                        [&box](const Rectangle& other) { return box.meets(other); }))
            return;
        numbers.push_back(box);
        constexpr double raised = 4;
        add(Label{.role = Role::quiet_text,
                  .at = {left + tick_width, at.y},
                  .text = tick.text,
                  .size = text_size,
                  .anchor = Anchor::end});
        if (!tick.power.empty())
            add(Label{.role = Role::quiet_text,
                      .at = {left + tick_width, at.y - raised},
                      .text = tick.power,
                      .size = power_size});
    }

    void add_line(std::size_t index) {
        const PlotCurve& curve = plot_.curves[index];
        if (!curve.has_line || curve.marks.size() < 2)
            return;
        Path path;
        for (const PlotMark& mark : curve.marks)
            path.push_back(place_of(index, mark));
        add(Lines{.role = curve_role(index), .paths = {std::move(path)}});
    }

    void add_marks(std::size_t index) {
        const PlotCurve& curve = plot_.curves[index];
        if (!curve.has_marks)
            return;
        const std::size_t first_group = groups_.size();
        for (const PlotMark& mark : curve.marks) {
            const Place at = place_of(index, mark);
            if (mark.is_on_front)
                add_ring(at, drawing_.shapes);
            add_mark(index, at, drawing_.shapes);
            add_to_groups(first_group, index, at, mark);
        }
    }

    /// The label of a mark, also that of those that lie on it.
    void add_to_groups(std::size_t first, std::size_t curve, Place at, const PlotMark& mark) {
        const double reach = mark.is_on_front ? ring_radius : mark_radius;
        marks_.push_back(box_around(at, reach));
        if (mark.label.empty())
            return;
        for (std::size_t i = first; i < groups_.size(); ++i) {
            MarkGroup& group = groups_[i];
            const double x = at.x - group.at.x;
            const double y = at.y - group.at.y;
            if (x * x + y * y < same_place * same_place) {
                add_name(group.label, mark.label);
                group.reach = std::max(group.reach, reach);
                return;
            }
        }
        groups_.push_back({curve, at, reach, mark.label});
    }

    /// Writes the labels; returns those that have no room.
    std::string add_labels() {
        LabelPlaces places({{area_left, top_}, area_right() - area_left, plot_.area_height},
                           shelf_right_);
        for (const Rectangle& mark : marks_)
            places.take(mark);
        const auto wish_of = [](const MarkGroup& group) {
            return LabelWish{.mark = group.at,
                             .away = group.reach + 1.5,
                             .width = width_of(group.label, label_size) + 1,
                             .height = label_size};
        };
        // Those that have room beside their marks first; the others take what is left.
        std::vector<const MarkGroup*> to_lead;
        for (const MarkGroup& group : groups_) {
            if (const auto place = places.find_beside(wish_of(group)))
                add_label(group, *place);
            else
                to_lead.push_back(&group);
        }
        std::string left_out;
        for (const MarkGroup* group : to_lead) {
            if (const auto place = places.find_anywhere(wish_of(*group)))
                add_label(*group, *place);
            else
                left_out += fmt::format("{}{}: {}", left_out.empty() ? "" : "; ",
                                        plot_.curves[group->curve].name, group->label);
        }
        return left_out;
    }

    void add_label(const MarkGroup& group, const LabelPlace& place) {
        if (place.leader)
            add(Lines{.role = Role::leader, .paths = {*place.leader}});
        const auto [x, anchor] = anchor_beside(group.at, place.box);
        add(Label{.role = curve_role(group.curve),
                  .at = {x, place.box.bottom() - 2},
                  .text = group.label,
                  .size = label_size,
                  .anchor = anchor,
                  .has_rim = true});
    }

    const Plot& plot_;
    Drawing drawing_;
    double top_ = 0;
    double bottom_ = 0;
    double shelf_right_ = 0;
    bool has_values_ = false; ///< off the shelf
    Axis x_;
    Axis y_;
    std::vector<Rectangle> marks_;
    std::vector<MarkGroup> groups_;
};

} // namespace

Drawing plot_drawing(const Plot& plot) {
    return PlotDrawer(plot).drawn();
}

Drawing legend_drawing(const Plot& plot) {
    const std::vector<PlotCurve>& curves = plot.curves;
    constexpr double text_left = 56;
    constexpr double middle = 28;
    constexpr double gap = 6;
    Drawing drawing{.width = legend_width, .title = "What the lines mean"};
    double y = 42;
    const auto add_text = [&](std::string_view text) {
        const auto lines = lines_of(text, name_size, legend_width - text_left - margin);
        for (const std::string& line : lines) {
            drawing.shapes.push_back(
                Label{.at = {text_left, y + 4}, .text = line, .size = name_size});
            y += name_size * line_height;
        }
        y += gap;
    };
    for (std::size_t i = 0; i < curves.size(); ++i) {
        if (curves[i].has_line)
            drawing.shapes.push_back(
                Lines{.role = curve_role(i), .paths = {{{middle - 20, y}, {middle + 20, y}}}});
        if (curves[i].has_marks)
            add_mark(i, {middle, y}, drawing.shapes);
        add_text(curves[i].name);
    }
    const auto has_ring = [](const PlotCurve& curve) {
        return std::any_of(curve.marks.begin(), curve.marks.end(),
                           [](const PlotMark& mark) { return mark.is_on_front; });
    };
    if (std::any_of(curves.begin(), curves.end(), has_ring)) {
        add_ring({middle, y}, drawing.shapes);
        add_text("on the Pareto front");
    }
    if (plot.x.scale == PlotScale::logarithmic) {
        drawing.shapes.push_back(
            Areas{.role = Role::shelf, .rectangles = {{{middle - 8, y - 6}, 16, 12}}});
        add_text("the shelf: exactly 0");
    }
    drawing.height = std::ceil(y);
    return drawing;
}

} // namespace rastertrace
