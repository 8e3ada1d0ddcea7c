// SPDX-License-Identifier: MIT
// The true geometry over the pixels: edges, vertices with their coordinates, samples, half-planes.

#include "clip.h"
#include "label_places.h"
#include "panel.h"
#include "visibility.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/corners.h>
#include <rastertrace/trace/tell/formula.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// Where faces were cut into triangles: sides that two triangles of a face have.
class Diagonals {
public:
    Diagonals(const Panel& panel, const std::vector<std::size_t>& primitives) {
        for (const std::size_t primitive : primitives) {
            const auto step = panel.trace().step(primitive).as<PrimitiveStep>();
            const auto names = step.vertices.texts();
            for (std::size_t i = 0; step.face && i < names.size(); ++i)
                ++times_[key(step.face.text(), names[i], names[(i + 1) % names.size()])];
        }
    }
    bool has(const PrimitiveStep& step, const std::string& a, const std::string& b) const {
        const auto found = step.face ? times_.find(key(step.face.text(), a, b)) : times_.end();
        return found != times_.end() && found->second > 1;
    }

private:
    using Key = std::array<std::string, 3>;
    static Key key(const std::string& face, const std::string& a, const std::string& b) {
        return {face, std::min(a, b), std::max(a, b)};
    }
    std::map<Key, int> times_;
};

/// The sides of a primitive, as far as they are inside, without the diagonals of its face.
std::vector<Path> sides_of(const Panel& panel, std::size_t primitive,
                           const Diagonals* diagonals = nullptr) {
    const Path corners = places_of(panel, primitive);
    const auto step = panel.trace().step(primitive).as<PrimitiveStep>();
    const auto names = step.vertices.texts();
    std::vector<Path> sides;
    const std::size_t count = corners.size() == 2 ? 1 : corners.size();
    for (std::size_t i = 0; i < count && corners.size() > 1; ++i)
        if (diagonals != nullptr && names.size() == corners.size() &&
            diagonals->has(step, names[i], names[(i + 1) % names.size()]))
            continue;
        else if (const auto side =
                     clipped(corners[i], corners[(i + 1) % corners.size()], panel.lattice.frame()))
            sides.push_back({side->first, side->second});
    return sides;
}

Place middle_of(const Path& corners) {
    Place sum;
    for (const Place& corner : corners)
        sum = {sum.x + corner.x, sum.y + corner.y};
    const auto count = static_cast<double>(corners.size());
    return {sum.x / count, sum.y / count};
}

/// A vertex, its words, and from where they should keep away.
struct NamedVertex {
    Place at;
    std::string names;
    std::string coordinates;
    Place inside; ///< the middle of its primitive

    std::string text() const { return names + coordinates; }
};

/// Those that are inside, each once.
std::vector<NamedVertex> vertices_of(const Panel& panel) {
    std::vector<NamedVertex> vertices;
    std::set<std::pair<std::string, std::pair<double, double>>> known;
    const Visibility visibility(panel);
    for (const std::size_t primitive : primitives_with_edges(panel)) {
        const auto step = panel.trace().step(primitive).as<PrimitiveStep>();
        const auto names = step.vertices.texts();
        const auto positions = text_rows(step.at);
        const Path corners = places_of(panel, primitive);
        for (std::size_t i = 0; i < std::min(names.size(), corners.size()); ++i) {
            if (!panel.lattice.frame().has(corners[i]) ||
                (!panel.parts.has(FigurePart::hidden_edges) &&
                 !visibility.is_seen(primitive, corners[i])) ||
                !known.insert({names[i], {corners[i].x, corners[i].y}}).second)
                continue;
            // Vertices at one place share their words.
            const auto same =
                std::find_if(vertices.begin(), vertices.end(),
                             [&](const NamedVertex& other) { return other.at == corners[i]; });
            if (same != vertices.end())
                same->names += ", " + names[i];
            else
                vertices.push_back({corners[i], names[i],
                                    panel.parts.has(FigurePart::coordinates)
                                        ? fmt::format("({}, {})", short_number(positions[i][0]),
                                                      short_number(positions[i][1]))
                                        : std::string(),
                                    middle_of(corners)});
        }
    }
    return vertices;
}

/// Of a step that tells the painter's order, the primitives in it, which come after that step; else none.
std::vector<std::size_t> in_painters_order(const Panel& panel) {
    const Trace& trace = panel.trace();
    const std::size_t step = panel.frame.steps.first;
    std::vector<std::size_t> primitives;
    if (!panel.is_step() || trace.kind_of(step) != StepKind::order)
        return primitives;
    std::map<std::string, std::size_t> by_name;
    for (const std::size_t n : trace.steps_of({StepKind::primitive}, step + 1))
        by_name.emplace(trace.step(n).as<PrimitiveStep>().name.text(), n);
    for (const std::string& name : trace.step(step).as<OrderStep>().names.texts())
        if (const auto found = by_name.find(name); found != by_name.end())
            primitives.push_back(found->second);
    return primitives;
}

/// The place of each in the painter's order, in its middle.
void add_painters_order(const Panel& panel, std::vector<Shape>& shapes) {
    std::size_t place = 0;
    for (const std::size_t primitive : in_painters_order(panel))
        if (const Path corners = places_of(panel, primitive); !corners.empty())
            shapes.push_back(Label{.role = Role::normal,
                                   .at = middle_of(corners),
                                   .text = fmt::format("{}.", ++place),
                                   .size = 12,
                                   .anchor = Anchor::middle,
                                   .is_bold = true,
                                   .has_rim = true});
}

/// The parts of all sides that are seen, or those that are not: calls `visit(primitive, part)`.
template <typename Visit>
void for_each_part(const Panel& panel, bool are_seen, const Visit& visit) {
    const Visibility visibility(panel);
    const auto primitives = primitives_with_edges(panel);
    const Diagonals diagonals(panel, primitives);
    for (const std::size_t primitive : primitives)
        for (const Path& side : sides_of(panel, primitive, &diagonals))
            for (Path& part : visibility.parts_of(primitive, side, are_seen))
                visit(primitive, std::move(part));
}

} // namespace

Path places_of(const Panel& panel, std::size_t primitive) {
    Path places;
    for (const Place& corner : corners_of(panel.trace().step(primitive).as<PrimitiveStep>()))
        places.push_back(panel.lattice.place_of(corner.x, corner.y));
    return places;
}

std::vector<std::size_t> primitives_with_edges(const Panel& panel) {
    if (auto sorted = in_painters_order(panel); !sorted.empty())
        return sorted;
    const auto all = panel.replay.primitives();
    const std::size_t current = panel.primitive();
    if (panel.has_all_edges || current == 0)
        return {all.begin(), all.end()};
    return {current};
}

void add_edges(const Panel& panel, std::vector<Shape>& shapes) {
    Lines others{.role = Role::other_edge};
    Lines current{.role = Role::true_edge};
    for_each_part(panel, true, [&](std::size_t primitive, Path&& part) {
        const bool is_current = primitive == panel.primitive() || !panel.is_step();
        (is_current ? current : others).paths.push_back(std::move(part));
    });
    shapes.push_back(std::move(others));
    shapes.push_back(std::move(current));
    if (const auto& edge = panel.subject.edge; edge && panel.is_step()) {
        const Path corners = places_of(panel, panel.primitive());
        const auto side = corners.empty() ? std::nullopt
                                          : clipped(corners[(*edge)[0]], corners[(*edge)[1]],
                                                    panel.lattice.frame());
        if (side)
            shapes.push_back(
                Lines{.role = Role::current_border, .paths = {{side->first, side->second}}});
    }
    add_painters_order(panel, shapes);
}

void add_hidden_edges(const Panel& panel, std::vector<Shape>& shapes) {
    Lines hidden{.role = Role::other_edge};
    for_each_part(panel, false,
                  [&](std::size_t, Path&& part) { hidden.paths.push_back(std::move(part)); });
    shapes.push_back(std::move(hidden));
}

void add_vertices(const Panel& panel, std::vector<Shape>& shapes) {
    constexpr double size = 11;
    constexpr double radius = 2.6;
    Dots dots{.role = Role::vertex, .radius = radius};
    Obstacles obstacles{
        .sheet = panel.sheet, .frame = panel.lattice.frame(), .sides = {}, .words = {}};
    constexpr std::size_t few_primitives = 50; // among more, there is no way around their sides
    const auto primitives = primitives_with_edges(panel);
    for (std::size_t i = 0; primitives.size() <= few_primitives && i < primitives.size(); ++i)
        for (Path& side : sides_of(panel, primitives[i]))
            obstacles.sides.push_back(std::move(side));
    std::vector<Shape> labels;
    for (const NamedVertex& vertex : vertices_of(panel)) {
        dots.centers.push_back(vertex.at);
        // Where there is no room for all of it, the names will do; or the dot alone.
        std::string words = vertex.text();
        auto box = words_beside({vertex.at, vertex.inside, words, size}, obstacles);
        if (!box) {
            words = vertex.names;
            box = words_beside({vertex.at, vertex.inside, words, size}, obstacles);
        }
        if (!box)
            continue;
        obstacles.words.push_back(*box);
        labels.push_back(strong_label_in(*box, {vertex.at, vertex.inside, words, size}));
    }
    shapes.push_back(std::move(dots));
    shapes.insert(shapes.end(), labels.begin(), labels.end());
}

void add_samples(const Panel& panel, std::vector<Shape>& shapes) {
    constexpr double radius = 1.4;
    Dots dots{.role = Role::sample, .radius = radius};
    panel.for_each_pixel(
        [&](Pixel pixel, std::size_t) { dots.centers.push_back(panel.lattice.sample_of(pixel)); });
    shapes.push_back(std::move(dots));
}

bool has_half_planes(const Panel& panel) {
    const std::size_t primitive = panel.primitive();
    return primitive != 0 &&
           corners_of(panel.trace().step(primitive).as<PrimitiveStep>()).size() == 3;
}

void add_half_planes(const Panel& panel, std::vector<Shape>& shapes) {
    if (!has_half_planes(panel))
        return;
    const std::size_t primitive = panel.primitive();
    const Path corners = places_of(panel, primitive);
    const auto names = panel.trace().step(primitive).as<PrimitiveStep>().vertices.texts();
    std::vector<Shape> lines; // and their names: no half-plane covers them
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Place a = corners[i];
        const Place b = corners[(i + 1) % 3];
        const Place c = corners[(i + 2) % 3];
        const auto side_of = [a, b](Place p) { return doubled_area(a, b, p); };
        // The side of the third corner is the inner one.
        const double sign = side_of(c) < 0 ? -1 : 1;
        const Path all = corners_of(panel.lattice.frame());
        shapes.push_back(Polygons{.role = Role::inside, .paths = {clipped(all, [&](Place p) {
                                                            return sign * side_of(p);
                                                        })}});
        shapes.push_back(Polygons{.role = Role::outside, .paths = {clipped(all, [&](Place p) {
                                                             return -sign * side_of(p);
                                                         })}});
        // The whole line, through the panel.
        constexpr double far = 1000;
        const Place beyond{b.x + far * (b.x - a.x), b.y + far * (b.y - a.y)};
        const Place before{a.x - far * (b.x - a.x), a.y - far * (b.y - a.y)};
        if (const auto line = clipped(before, beyond, panel.lattice.frame())) {
            lines.push_back(
                Lines{.role = Role::other_edge, .paths = {{line->first, line->second}}});
            if (names.size() != 3)
                continue;
            // Its name on the inner side, in the middle of what is seen of the line.
            const Place middle{(line->first.x + line->second.x) / 2,
                               (line->first.y + line->second.y) / 2};
            const double length = std::sqrt(std::pow(b.x - a.x, 2) + std::pow(b.y - a.y, 2));
            constexpr double inward = 16;
            if (length > 0)
                lines.push_back(
                    Label{.role = Role::text,
                          .at = {middle.x - sign * (b.y - a.y) / length * inward,
                                 middle.y + sign * (b.x - a.x) / length * inward + 4},
                          .text = fmt::format("{}{} \u2265 0", names[i], names[(i + 1) % 3]),
                          .size = 10,
                          .anchor = Anchor::middle,
                          .has_rim = true});
        }
    }
    shapes.insert(shapes.end(), lines.begin(), lines.end());
}

void add_notes(const std::vector<FigureNote>& notes, const Panel& panel,
               std::vector<Shape>& shapes) {
    constexpr double size = 10;
    constexpr double head = 6;
    Obstacles obstacles{
        .sheet = panel.sheet, .frame = panel.lattice.frame(), .sides = {}, .words = {}};
    for (const Shape& shape : shapes)
        if (const auto* const label = std::get_if<Label>(&shape))
            obstacles.words.push_back(
                {{label->at.x - (label->anchor == Anchor::end      ? 1
                                 : label->anchor == Anchor::middle ? 0.5
                                                                   : 0) *
                                    width_of(label->text, label->size, label->is_bold),
                  label->at.y - label->size},
                 width_of(label->text, label->size, label->is_bold),
                 label->size});
    for (const FigureNote& note : notes) {
        const Place at = panel.lattice.place_of(note.x, note.y);
        const double away = std::max(2 * panel.lattice.cell, 24.0);
        const std::string words = printable(note.text);
        for (const auto& [right, down] : {std::pair(1, -1), {-1, -1}, {1, 1}, {-1, 1}}) {
            const Place beside{at.x + right * away, at.y + down * away};
            const auto box = words_beside({beside, at, words, size}, obstacles);
            if (!box)
                continue;
            obstacles.words.push_back(*box);
            add_arrow({std::clamp(at.x, box->left(), box->right()),
                       down < 0 ? box->bottom() : box->top()},
                      at, Role::rounding, head, shapes);
            Label label = strong_label_in(*box, {beside, at, words, size});
            label.role = Role::rounding;
            label.names_points = false;
            label.has_formulas = true;
            shapes.push_back(std::move(label));
            break;
        }
    }
}

} // namespace rastertrace
