// SPDX-License-Identifier: MIT
// What is told of a row, a face, a vertex or an edge: the steps that are about it, in order.

#include "explanation.h"

#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/language.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <map>
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
    std::string whole;     ///< the same, or, of a part that clipping has made, what it is a part of
};

/// Every step of a kind that we know.
void for_each_step(const Trace& trace, const std::function<void(const StepOf&)>& take) {
    std::string primitive, whole;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        if (!kind)
            continue;
        const StepView step = trace.step(n);
        if (kind == StepKind::primitive) {
            const auto begun = step.as<PrimitiveStep>();
            primitive = begun.name.text();
            whole = name_of_whole(begun);
        }
        if (kind == StepKind::undecided) { // it stands before its primitive
            const std::string next = step.as<UndecidedStep>().name.text();
            take({n, *kind, step, next, next});
            continue;
        }
        take({n, *kind, step, primitive, whole});
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

/// True of a `primitive` step that can be asked about as a face.
bool is_face(const StepOf& primitive) {
    const auto traits = traits_of(primitive.step.as<PrimitiveStep>().kind);
    return primitive.primitive != primitive.whole || !traits || traits->corners > 2;
}

/// An answer that counts steps: not all of them are there if the trace lacks some.
std::string counted_in(const Explanation& explanation, const std::string& answer) {
    return explanation.lacks.empty() ? answer : said("as far as the trace goes: {}", answer);
}

/// The answer of a trace that does not tell it.
std::string no_answer() {
    return said("not told");
}

/// What has become of a triangle or an outline. Pixels are counted once, however often they were written.
struct Fate {
    bool is_painted = true;
    std::set<std::size_t> plotted; ///< where on the canvas
    std::set<std::size_t> hidden;
    std::set<std::size_t> passed; ///< the depth test
    std::size_t seen = 0;         ///< of the plotted ones, at the end
    std::string skipped;          ///< why it draws nothing
};

void take_step(Fate& fate, const StepOf& one, const Replay& at_end) {
    if (one.kind == StepKind::primitive && one.step.as<PrimitiveStep>().painted.is_false())
        fate.is_painted = false;
    if (one.kind == StepKind::skip)
        fate.skipped = one.step.as<SkipStep>().why.text();
    const Canvas& canvas = at_end.trace().canvas;
    const auto x = x_in(one.step);
    const auto y = y_in(one.step);
    if (!x || !y || !canvas.contains(*x, *y))
        return;
    const auto offset = canvas.offset_of({static_cast<int>(*x), static_cast<int>(*y)});
    if (one.kind == StepKind::depth)
        (one.step.as<DepthStep>().pass.is_false() ? fate.hidden : fate.passed).insert(offset);
    if (one.kind == StepKind::pixel)
        fate.plotted.insert(offset);
    if (one.kind == StepKind::pixel && at_end.frame().drawn_by[offset] == one.number)
        ++fate.seen;
}

/// The fates of primitives, and of the parts that clipping has made of them, by their names.
std::map<std::string, Fate> fates_in(const Trace& trace, const std::vector<std::string>& names) {
    std::map<std::string, Fate> fates;
    for (const std::string& name : names)
        fates[name] = {};
    Replay at_end(trace);
    at_end.go_to(trace.size());
    for_each_step(trace, [&](const StepOf& one) {
        const auto own = fates.find(one.primitive);
        const auto found = own == fates.end() ? fates.find(one.whole) : own;
        if (found != fates.end())
            take_step(found->second, one, at_end);
    });
    return fates;
}

std::string text_of(const Fate& fate, bool lacks_depths) {
    if (!fate.skipped.empty() && fate.plotted.empty() && fate.hidden.empty())
        return said("not drawn: {}##face", printable(in_language_of_steps(fate.skipped)));
    if (!fate.is_painted)
        return said("not painted: it only hides what lies behind it, at {}",
                    said_count(fate.passed.size(), "pixel"));
    const std::string hidden =
        lacks_depths ? "" : said(", {} hidden by what is nearer", fate.hidden.size());
    return said("{} plotted{}, {} seen at the end", said_count(fate.plotted.size(), "pixel"),
                hidden, fate.seen);
}

/// Why no step tests whether a face is turned away.
std::string why_not_tested(const Trace& trace) {
    const std::string cull = trace.method.word_of("cull");
    return cull.empty() || cull == "none" ? said("no face is tested: the method does not cull")
                                          : said("it was skipped before it was tested");
}

/// Who has pixels in a row without being filled row by row: lines, and the sides of outlines.
std::set<std::string> passing_through(const Trace& trace, int y) {
    std::set<std::string> names;
    bool is_line = false;
    for_each_step(trace, [&](const StepOf& one) {
        if (one.kind == StepKind::primitive) {
            const auto traits = traits_of(one.step.as<PrimitiveStep>().kind);
            is_line = traits && traits->thickness == Thickness::line;
        }
        if (is_line && one.kind == StepKind::pixel && y_in(one.step) == y)
            names.insert(one.whole);
    });
    return names;
}

/// Why a trace that lacks no step has none of a row.
std::string why_no_row(const Trace& trace, int y) {
    const Fill fill = trace.method.triangles.fill;
    if (fill == Fill::barycentric || fill == Fill::fan)
        return said("no primitive has rows: {} goes {}", traits_of(fill).name,
                    fill == Fill::fan ? said("line by line")
                                      : said("through every pixel of a box"));
    const auto lines = passing_through(trace, y);
    if (lines.empty())
        return said("no primitive has this row");
    return said("no filled triangle has this row; {} with pixels in it {} no rows",
                said_count(lines.size(), "line"), lines.size() == 1 ? said("has") : said("have"));
}

} // namespace

Explanation explain_scanline(const Trace& trace, int y) {
    Explanation explanation;
    std::vector<std::string> owners;
    explanation.tries = tries_of(trace, numbers_of(trace, [&](const StepOf& one) {
                                     const bool is_row =
                                         one.kind == StepKind::scanline && y_in(one.step) == y;
                                     if (is_row)
                                         owners.push_back(one.primitive);
                                     return is_row;
                                 }));
    for (std::size_t i = 0; i < owners.size(); ++i)
        explanation.tries[i].primitive = owners[i];
    explanation.lacks = what_lacks(trace, {StepKind::scanline});
    if (!owners.empty())
        explanation.answer = counted_in(
            explanation, said("{} with this row", said_count(owners.size(), "primitive")));
    else
        explanation.answer = explanation.lacks.empty() ? why_no_row(trace, y) : no_answer();
    return explanation;
}

std::vector<std::string> names_to_ask(const Trace& trace, Topic topic) {
    std::set<std::string> names;
    for_each_step(trace, [&](const StepOf& one) {
        if (topic == Topic::face && one.kind == StepKind::triangulate)
            names.insert(one.step.as<TriangulateStep>().name.text());
        if (topic == Topic::vertex && one.kind == StepKind::vertex)
            names.insert(name_in(one.step).text());
        if (topic == Topic::edge && one.kind == StepKind::edge)
            names.insert(one.step.as<EdgeStep>().edge.text());
        if (one.kind != StepKind::primitive)
            return;
        const PrimitiveText primitive = primitive_in(one.step);
        if ((topic == Topic::face && is_face(one)) ||
            (topic == Topic::pair && corners_of(primitive)))
            names.insert(one.primitive);
        if (topic == Topic::vertex)
            names.insert(primitive.vertices.begin(), primitive.vertices.end());
        for (std::size_t i = 0; topic == Topic::edge && i < primitive.vertices.size(); ++i)
            for (std::size_t j = i + 1; j < primitive.vertices.size(); ++j)
                names.insert(edge_name(primitive, i, j));
    });
    return {names.begin(), names.end()};
}

void refuse_name(const Trace& trace, Topic topic, const std::string& name) {
    constexpr std::size_t most_listed = 12;
    std::vector<std::string> known = names_to_ask(trace, topic);
    std::string hint =
        did_you_mean(name, std::vector<std::string_view>(known.begin(), known.end()));
    if (hint.empty()) {
        const bool is_all = known.size() <= most_listed;
        known.resize(std::min(known.size(), most_listed));
        hint = known.empty()
                   ? std::string("the trace has none")
                   : fmt::format("there are {}{}", joined(known, ", "), is_all ? "" : ", ...");
    }
    const std::string_view what = topic == Topic::face     ? "a face"
                                  : topic == Topic::vertex ? "a vertex"
                                  : topic == Topic::edge   ? "an edge"
                                                           : "a triangle that is drawn";
    throw problem_of(
        "", fmt::format("--{}: expected the name of {}, found \"{}\"", name_of(topic), what, name),
        std::move(hint));
}

std::vector<std::string> triangles_of_face(const Trace& trace, const std::string& name) {
    bool is_known = trace.lacks(StepKind::primitive);
    std::vector<std::string> triangles{name};
    for_each_step(trace, [&](const StepOf& one) {
        if (one.kind == StepKind::triangulate && name_in(one.step) == name) {
            triangles = one.step.as<TriangulateStep>().ears.texts();
            is_known = true;
        }
        is_known =
            is_known || (one.kind == StepKind::primitive && one.primitive == name && is_face(one));
    });
    if (!is_known)
        refuse_name(trace, Topic::face, name);
    return triangles;
}

namespace {

/// True of the steps that say how a face is turned, lit, clipped.
bool is_about_face(StepKind kind) {
    return kind == StepKind::primitive || kind == StepKind::face || kind == StepKind::light ||
           kind == StepKind::clip || kind == StepKind::skip || kind == StepKind::undecided;
}

} // namespace

Explanation explain_face(const Trace& trace, const std::string& name) {
    const std::vector<std::string> triangles = triangles_of_face(trace, name);
    const auto is_of_face = [&](const StepOf& one) {
        return std::any_of(triangles.begin(), triangles.end(), [&](const std::string& triangle) {
            return one.primitive == triangle || one.whole == triangle;
        });
    };
    bool has_test = false;
    Explanation explanation;
    explanation.tries =
        tries_of(trace, numbers_of(trace, [&](const StepOf& one) {
                     if (one.kind == StepKind::triangulate)
                         return name_in(one.step) == name;
                     has_test = has_test || (one.kind == StepKind::face && is_of_face(one));
                     return is_about_face(one.kind) && is_of_face(one);
                 }));
    explanation.lacks =
        what_lacks(trace, {StepKind::primitive, StepKind::face, StepKind::pixel, StepKind::depth});
    const bool is_told = !trace.lacks(StepKind::primitive) && !trace.lacks(StepKind::pixel);
    std::vector<std::string> texts;
    const auto fates = fates_in(trace, triangles);
    for (const std::string& triangle : triangles)
        texts.push_back((triangles.size() == 1 ? "" : printable(triangle) + ": ") +
                        text_of(fates.at(triangle), trace.lacks(StepKind::depth)));
    explanation.answer = is_told ? counted_in(explanation, joined(texts, "; ")) : no_answer();
    if (!has_test && explanation.lacks.empty())
        explanation.lacks.push_back(why_not_tested(trace));
    return explanation;
}

Explanation explain_vertex(const Trace& trace, const std::string& name) {
    std::string place;
    Explanation explanation;
    const auto placed = numbers_of(trace, [&](const StepOf& one) {
        return one.kind == StepKind::vertex && name_in(one.step) == name;
    });
    explanation.tries = tries_of(trace, placed);
    const bool has_places = !placed.empty();
    if (has_places) {
        const auto last = trace.step(placed.back()).as<VertexStep>();
        place =
            said("{} space: {}", in_language_of_steps(last.space.text()), point(last.at.texts()));
    }

    // Where no matrix moves a vertex, the primitives say where it is.
    const auto corners = numbers_of(trace, [&](const StepOf& one) {
        if (one.kind != StepKind::primitive)
            return false;
        const PrimitiveText primitive = primitive_in(one.step);
        bool is_corner = false;
        for (std::size_t i = 0; i < primitive.vertices.size(); ++i) {
            is_corner = is_corner || primitive.vertices[i] == name;
            if (primitive.vertices[i] == name && place.empty() && i < primitive.positions.size())
                place =
                    said("{}, as it was typed: no matrix moves it", point(primitive.positions[i]));
        }
        return is_corner;
    });
    if (!has_places && corners.empty())
        refuse_name(trace, Topic::vertex, name);
    if (!has_places)
        explanation.tries = tries_of(trace, corners);
    explanation.lacks = what_lacks(trace, {StepKind::vertex});
    explanation.answer = place.empty() ? no_answer() : place;
    return explanation;
}

namespace {

/// Why no step is about an edge that a primitive has.
std::string why_not_set_up(const Trace& trace, const std::set<std::string>& spellings) {
    std::set<std::string> owners;
    std::string why = said("no step is about it");
    for_each_step(trace, [&](const StepOf& one) {
        if (one.kind == StepKind::primitive) {
            const PrimitiveText primitive = primitive_in(one.step);
            for (std::size_t i = 0; i < primitive.vertices.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    if (spellings.contains(edge_name(primitive, i, j)))
                        owners.insert(one.primitive);
        }
        if (one.kind != StepKind::skip)
            return;
        const auto skip = one.step.as<SkipStep>();
        const std::string name = skip.name ? skip.name.text() : one.primitive;
        if (owners.contains(name))
            why = said("no edge is set up: {} is {}{}", printable(name),
                       skip.why == SkipReason::culled ? "" : said("skipped, "),
                       printable(in_language_of_steps(skip.why.text())));
    });
    return why;
}

} // namespace

Explanation explain_edge(const Trace& trace, const std::string& name) {
    // AB is also BA: a trace names an edge from its upper vertex.
    std::set<std::string> spellings;
    for_each_step(trace, [&](const StepOf& one) {
        if (one.kind == StepKind::edge && one.step.as<EdgeStep>().edge == name)
            spellings.insert(name);
        if (one.kind != StepKind::primitive)
            return;
        const PrimitiveText primitive = primitive_in(one.step);
        for (std::size_t i = 0; i < primitive.vertices.size(); ++i)
            for (std::size_t j = i + 1; j < primitive.vertices.size(); ++j) {
                const std::string edge = edge_name(primitive, i, j);
                const std::string back = edge_name(primitive, j, i);
                if (edge == name || back == name)
                    spellings.insert({edge, back});
            }
    });
    if (spellings.empty())
        refuse_name(trace, Topic::edge, name);

    // The edge is set up, and rows begin or end at it; or it is a line, with its own steps.
    bool is_in_line = false;
    std::size_t rows = 0;
    Explanation explanation;
    explanation.tries =
        tries_of(trace, numbers_of(trace, [&](const StepOf& one) {
                     switch (one.kind) {
                     case StepKind::primitive:
                         is_in_line = one.step.as<PrimitiveStep>().kind == PrimitiveKind::line &&
                                      spellings.contains(edge_name(primitive_in(one.step), 0, 1));
                         return is_in_line;
                     case StepKind::edge: {
                         const auto side = one.step.as<EdgeStep>();
                         const bool is_meant = spellings.contains(side.edge.text());
                         is_in_line = is_meant && side.octant;
                         return is_meant;
                     }
                     case StepKind::scanline: {
                         const auto row = one.step.as<ScanlineStep>();
                         const bool is_end = spellings.contains(row.left_edge.text()) ||
                                             spellings.contains(row.right_edge.text());
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
    explanation.lacks = what_lacks(trace, {StepKind::edge, StepKind::scanline});
    if (!explanation.tries.empty() && rows == 0)
        explanation.answer = explanation.tries.front().sentence;
    else
        explanation.answer =
            counted_in(explanation, rows > 0 ? said("{} with this end", said_count(rows, "row"))
                                             : why_not_set_up(trace, spellings));
    return explanation;
}

} // namespace rastertrace
