// SPDX-License-Identifier: MIT
// What is told of a row, a face, a vertex or an edge: the steps that are about it, in order.

#include "explanation.h"
#include "step_text.h"

#include <rastertrace/core/scene/stages.h>
#include <rastertrace/trace/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string_view>

namespace rastertrace {

namespace {

/// A step of a trace, and the primitive that it belongs to.
struct StepOf {
    std::size_t number;
    StepKind kind;
    StepView step;
    std::string primitive; ///< its name; "" before the first one
};

/// Every step of a kind that we know.
void for_each_step(const Trace& trace, const std::function<void(const StepOf&)>& take) {
    std::string primitive;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (!kind)
            continue;
        const StepView step = trace.step(n);
        if (kind == StepKind::primitive)
            primitive = step.text("name");
        take({n, *kind, step, primitive});
    }
}

std::vector<std::size_t> numbers_of(const Trace& trace,
                                    const std::function<bool(const StepOf&)>& is_meant) {
    std::vector<std::size_t> numbers;
    for_each_step(trace, [&](const StepOf& one) {
        if (is_meant(one))
            numbers.push_back(one.number);
    });
    return numbers;
}

/// A name that nothing has: what there is.
[[noreturn]] void refuse(std::string_view option, std::string_view what, const std::string& name,
                         const std::set<std::string>& known) {
    constexpr std::size_t most_listed = 12;
    std::vector<std::string> listed(known.begin(), known.end());
    const std::string near =
        did_you_mean(name, std::vector<std::string_view>(listed.begin(), listed.end()));
    const bool is_all = listed.size() <= most_listed;
    listed.resize(std::min(listed.size(), most_listed));
    throw problem_of("", fmt::format("{}: expected {}, found \"{}\"", option, what, name),
                     !near.empty()   ? near
                     : known.empty() ? std::string("the trace has none")
                                     : fmt::format("there are {}{}", joined(listed, ", "),
                                                   is_all ? "" : ", ..."));
}

void note_lack(const Trace& trace, StepKind kind, Explanation& explanation) {
    if (trace.lacks(kind))
        explanation.lacks.push_back(
            fmt::format("{} steps were left out of the trace", name_of(kind)));
}

/// What has become of a face: its pixels that were plotted, hidden, and are still seen at the end.
std::string fate_of(const Trace& trace, const std::string& name) {
    Replay replay(trace);
    replay.go_to(trace.size());
    std::size_t plotted = 0, hidden = 0, seen = 0;
    std::string skipped;
    for_each_step(trace, [&](const StepOf& one) {
        if (!is_part_of(one.primitive, name))
            return;
        if (one.kind == StepKind::skip)
            skipped = one.step.text("why");
        if (one.kind == StepKind::depth && one.step.text("pass") == "false")
            ++hidden;
        const auto x = one.step.whole("x");
        const auto y = one.step.whole("y");
        if (one.kind != StepKind::pixel || !x || !y || !trace.canvas.contains(*x, *y))
            return;
        ++plotted;
        const Pixel pixel{static_cast<int>(*x), static_cast<int>(*y)};
        if (replay.frame().drawn_by[trace.canvas.offset_of(pixel)] == one.number)
            ++seen;
    });
    if (!skipped.empty() && plotted == 0)
        return fmt::format("not drawn: {}", printable(skipped));
    return fmt::format("{} plotted, {} hidden by what is nearer, {} seen at the end",
                       counted(plotted, "pixel"), hidden, seen);
}

} // namespace

Explanation explain_scanline(const Trace& trace, int y) {
    Explanation explanation;
    explanation.tries =
        tries_of(trace, numbers_of(trace, [y](const StepOf& one) {
                     return one.kind == StepKind::scanline && one.step.whole("y") == y;
                 }));
    note_lack(trace, StepKind::scanline, explanation);
    const std::string fill = trace.method_value("fill");
    if (!explanation.tries.empty())
        explanation.answer = counted(explanation.tries.size(), "primitive") + " with this row";
    else if (!explanation.lacks.empty())
        explanation.answer = "not told";
    else if (fill == "barycentric" || fill == "fan")
        explanation.answer =
            fmt::format("no primitive has rows: {} goes {}", fill,
                        fill == "fan" ? "line by line" : "through every pixel of a box");
    else
        explanation.answer = "no primitive has this row";
    return explanation;
}

Explanation explain_face(const Trace& trace, const std::string& name) {
    // A face of more than three corners is drawn as the triangles that it was cut into.
    std::set<std::string> known;
    std::vector<std::string> triangles{name};
    for_each_step(trace, [&](const StepOf& one) {
        if (one.kind == StepKind::primitive || one.kind == StepKind::triangulate)
            known.insert(one.step.text("name"));
        if (one.kind == StepKind::triangulate && one.step.text("name") == name)
            triangles = one.step.texts("ears");
    });
    if (!trace.lacks(StepKind::primitive) && !known.contains(name))
        refuse("--face", "the name of a face", name, known);
    const auto is_of_face = [&](const std::string& primitive) {
        return std::any_of(triangles.begin(), triangles.end(), [&](const std::string& triangle) {
            return is_part_of(primitive, triangle);
        });
    };
    Explanation explanation;
    bool has_test = false;
    explanation.tries = tries_of(trace, numbers_of(trace, [&](const StepOf& one) {
                                     switch (one.kind) {
                                     case StepKind::triangulate:
                                         return one.step.text("name") == name;
                                     case StepKind::face:
                                         has_test = has_test || is_of_face(one.primitive);
                                         return is_of_face(one.primitive);
                                     case StepKind::primitive:
                                     case StepKind::light:
                                     case StepKind::clip:
                                     case StepKind::skip:
                                     case StepKind::undecided:
                                         return is_of_face(one.primitive);
                                     default:
                                         return false;
                                     }
                                 }));
    note_lack(trace, StepKind::face, explanation);
    note_lack(trace, StepKind::pixel, explanation);
    if (!has_test && explanation.lacks.empty())
        explanation.lacks.emplace_back("no face is tested: the method does not cull");
    std::vector<std::string> fates;
    for (const std::string& triangle : triangles)
        fates.push_back(triangles.size() == 1
                            ? fate_of(trace, triangle)
                            : fmt::format("{}: {}", printable(triangle), fate_of(trace, triangle)));
    explanation.answer = trace.lacks(StepKind::pixel) ? "not told" : joined(fates, "; ");
    return explanation;
}

Explanation explain_vertex(const Trace& trace, const std::string& name) {
    std::set<std::string> known;
    std::string place;
    Explanation explanation;
    explanation.tries =
        tries_of(trace, numbers_of(trace, [&](const StepOf& one) {
                     if (one.kind == StepKind::vertex)
                         known.insert(one.step.text("name"));
                     return one.kind == StepKind::vertex && one.step.text("name") == name;
                 }));
    const bool has_places = !explanation.tries.empty();
    if (has_places) {
        const StepView last(explanation.tries.back().step);
        place = fmt::format("{} space: {}", last.text("space"), point(last.texts("at")));
    }

    // Where no matrix moves a vertex, the primitives say where it is.
    const auto corners = numbers_of(trace, [&](const StepOf& one) {
        if (one.kind != StepKind::primitive)
            return false;
        const PrimitiveText primitive = primitive_in(one.step);
        bool is_corner = false;
        for (std::size_t i = 0; i < primitive.vertices.size(); ++i) {
            known.insert(primitive.vertices[i]);
            is_corner = is_corner || primitive.vertices[i] == name;
            if (primitive.vertices[i] == name && place.empty() && i < primitive.positions.size())
                place = fmt::format("{}, as it was typed: no matrix moves it",
                                    point(primitive.positions[i]));
        }
        return is_corner;
    });
    if (!known.contains(name))
        refuse("--vertex", "the name of a vertex", name, known);
    if (!has_places)
        explanation.tries = tries_of(trace, corners);
    note_lack(trace, StepKind::vertex, explanation);
    explanation.answer = place.empty() ? "not told" : place;
    return explanation;
}

Explanation explain_edge(const Trace& trace, const std::string& name) {
    // AB is also BA: a trace names an edge from its upper vertex.
    std::set<std::string> known, spellings;
    for_each_step(trace, [&](const StepOf& one) {
        if (one.kind == StepKind::edge)
            known.insert(one.step.text("edge"));
        if (one.kind != StepKind::primitive)
            return;
        const PrimitiveText primitive = primitive_in(one.step);
        for (std::size_t i = 0; i < primitive.vertices.size(); ++i)
            for (std::size_t j = i + 1; j < primitive.vertices.size(); ++j) {
                const std::string edge = edge_name(primitive, i, j);
                const std::string back = edge_name(primitive, j, i);
                known.insert(edge);
                if (edge == name || back == name)
                    spellings.insert({edge, back});
            }
    });
    if (known.contains(name))
        spellings.insert(name);
    if (spellings.empty())
        refuse("--edge", "the name of an edge", name, known);

    // The edge is set up, and rows begin or end at it; or it is a line, with its own steps.
    bool is_in_line = false;
    std::size_t rows = 0;
    Explanation explanation;
    explanation.tries =
        tries_of(trace, numbers_of(trace, [&](const StepOf& one) {
                     switch (one.kind) {
                     case StepKind::primitive:
                         is_in_line = one.step.text("kind") == "line" &&
                                      spellings.contains(edge_name(primitive_in(one.step), 0, 1));
                         return is_in_line;
                     case StepKind::edge: {
                         const bool is_meant = spellings.contains(one.step.text("edge"));
                         is_in_line = is_meant && one.step.field("octant");
                         return is_meant;
                     }
                     case StepKind::scanline: {
                         const bool is_end = spellings.contains(one.step.text("left_edge")) ||
                                             spellings.contains(one.step.text("right_edge"));
                         rows += is_end ? 1 : 0;
                         return is_end;
                     }
                     case StepKind::along:
                     case StepKind::decide:
                         return is_in_line;
                     default:
                         return false;
                     }
                 }));
    note_lack(trace, StepKind::edge, explanation);
    note_lack(trace, StepKind::scanline, explanation);
    if (!explanation.tries.empty() && rows == 0)
        explanation.answer = explanation.tries.front().sentence;
    else
        explanation.answer = rows > 0 ? fmt::format("{} with this end", counted(rows, "row"))
                                      : "no step is about it";
    return explanation;
}

} // namespace rastertrace
