// SPDX-License-Identifier: MIT
// Two triangles and the edge that they share: which of them has each pixel along it, and why.

#include "explain_pixels.h"
#include "explanation.h"

#include "triangle_samples.h"
#include <rastertrace/core/draw/plan/stages.h>
#include <rastertrace/trace/record/told_samples.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

namespace rastertrace {

namespace {

/// The two triangles, and the ends of their edge.
struct Pair {
    std::array<std::string, 2> names;
    std::string edge; ///< as the first of them names its vertices
    Vec2 from;
    Vec2 to;
};

[[noreturn]] void refuse(const std::string& expected, const std::string& found,
                         std::string hint = {}) {
    throw problem_of("", fmt::format("--pair: expected {}, found \"{}\"", expected, found),
                     std::move(hint));
}

/// The triangle of a name, as its `primitive` step says.
PrimitiveText triangle_named(const Trace& trace, const std::string& name) {
    std::vector<std::string> parts;
    for (const std::size_t n : trace.steps_of({StepKind::primitive})) {
        PrimitiveText primitive = primitive_in(trace.step(n));
        if (primitive.name == name && corners_of(primitive))
            return primitive;
        if (is_part_of(trace.step(n).as<PrimitiveStep>(), name))
            parts.push_back(primitive.name);
    }
    if (!parts.empty())
        refuse("the name of a triangle that is drawn", name,
               fmt::format("{} was clipped: ask of its parts, {}", name, joined(parts, ", ")));
    refuse_name(trace, Topic::pair, name);
}

/// The two names that a text joins by a comma. A name may have commas too: the split is where both are known.
std::vector<std::string> names_in(const Trace& trace, const std::string& text) {
    std::set<std::string> known;
    for (const std::size_t n : trace.steps_of({StepKind::primitive}))
        known.insert(name_in(trace.step(n)).text());
    for (std::size_t comma = text.find(','); comma != std::string::npos;
         comma = text.find(',', comma + 1))
        if (known.contains(text.substr(0, comma)) && known.contains(text.substr(comma + 1)))
            return {text.substr(0, comma), text.substr(comma + 1)};
    return split_at(text, ',');
}

Pair pair_named(const Trace& trace, const std::string& text) {
    const auto names = names_in(trace, text);
    if (names.size() != 2 || names[0] == names[1])
        refuse("two triangles, like ABC,ACD", text);
    const PrimitiveText one = triangle_named(trace, names[0]);
    const PrimitiveText other = triangle_named(trace, names[1]);
    const auto corners = *corners_of(one);
    const auto others = *corners_of(other);
    std::vector<std::size_t> shared;
    for (std::size_t i = 0; i < 3; ++i)
        if (std::any_of(others.begin(), others.end(), [&](const Vec2& corner) {
                return corner.x == corners[i].x && corner.y == corners[i].y;
            }))
            shared.push_back(i);
    if (shared.size() != 2)
        refuse("two triangles that share an edge", text,
               fmt::format("they have {} in common", counted(shared.size(), "corner")));
    return {{names[0], names[1]},
            edge_name(one, shared[0], shared[1]),
            corners[shared[0]],
            corners[shared[1]]};
}

/// The steps of the two triangles that decide about pixels near their edge, and where the next primitive begins.
Trace steps_of(const Trace& trace, const Pair& pair, const std::vector<Pixel>& near_edge) {
    const auto is_near = [&](const StepView& step) {
        const auto x = x_in(step);
        const auto y = y_in(step);
        const auto is_before = [&](const Pixel& a, const Pixel& b) {
            return trace.canvas.offset_of(a) < trace.canvas.offset_of(b);
        };
        return x && y && trace.canvas.contains(*x, *y) &&
               std::binary_search(near_edge.begin(), near_edge.end(),
                                  Pixel{static_cast<int>(*x), static_cast<int>(*y)}, is_before);
    };
    Trace excerpt = trace.without_steps();
    excerpt.damage = trace.damage;
    bool is_of_pair = false;
    for (std::size_t n = 1; n <= trace.size(); ++n) {
        const auto kind = trace.kind_of(n);
        const StepView step = trace.step(n);
        const bool ends_pair = is_of_pair && kind == StepKind::primitive;
        if (kind == StepKind::primitive)
            is_of_pair = std::count(pair.names.begin(), pair.names.end(), name_in(step).text()) > 0;
        if (!kind || (!is_of_pair && !ends_pair))
            continue;
        switch (*kind) {
        case StepKind::pixel:
        case StepKind::depth:
        case StepKind::sample:
            if (is_near(step))
                break;
            continue;
        case StepKind::ray:
        case StepKind::along:
        case StepKind::decide:
            continue; // the pixels that they lead to say enough
        default:
            break;
        }
        excerpt.add_to_excerpt(step, kind, trace.number_of(n));
    }
    return excerpt;
}

/// Who has a pixel, and how each of the two came to have it or not.
PixelAlongEdge pixel_of(PixelExplainer& explainer, const Pair& pair, Pixel pixel) {
    const Explanation story = explainer.explain(pixel);
    PixelAlongEdge found{.pixel = pixel};
    for (const std::string& name : pair.names) {
        const auto why_not =
            std::find_if(story.why_not.begin(), story.why_not.end(),
                         [&name](const WhyNot& one) { return one.primitive == name; });
        if (why_not == story.why_not.end()) {
            found.owners.push_back(name);
            found.why.push_back(said({"{} has it", "{} o tem"}, name));
            continue;
        }
        if (why_not->reason == "hidden")
            found.owners.push_back(name);
        if (why_not->reason == "unknown")
            found.is_told = false;
        found.why.push_back(fmt::format("{}: {}", name, why_not->sentence));
    }
    return found;
}

} // namespace

Explanation explain_pair(const Trace& trace, const std::string& names) {
    const Pair pair = pair_named(trace, names);
    const auto place_of = [](const Vec2& at) {
        return ScreenPoint{Coordinate(at.x), Coordinate(at.y)};
    };
    const std::vector<Pixel> near_edge =
        pixels_near(place_of(pair.from), place_of(pair.to),
                    {trace.canvas, told_samples(trace).triangles.x().get_d()});
    const Trace steps = steps_of(trace, pair, near_edge);
    PixelExplainer explainer(steps);
    Explanation explanation;
    std::array<std::size_t, 2> only{};
    std::size_t both = 0, none = 0, untold = 0;
    for (const Pixel& pixel : near_edge) {
        explanation.pixels.push_back(pixel_of(explainer, pair, pixel));
        const auto& owners = explanation.pixels.back().owners;
        if (!explanation.pixels.back().is_told)
            ++untold;
        else if (owners.size() == 2)
            ++both;
        else if (owners.empty())
            ++none;
        else
            ++only[owners.front() == pair.names[0] ? 0 : 1];
    }
    explanation.answer = printable(
        said({"edge {}: {} along it, {} of {}, {} of {}, {} of both, {} of neither",
              "aresta {}: {} ao longo dela, {} de {}, {} de {}, {} de ambos, {} de nenhum"},
             pair.edge, said_count(explanation.pixels.size(), {"pixel", "pixel"}), only[0],
             pair.names[0], only[1], pair.names[1], both, none));
    if (untold > 0)
        explanation.answer += said({", {} not told", ", {} sem resposta"}, untold);
    explanation.lacks = what_lacks(trace, {StepKind::primitive, StepKind::pixel, StepKind::depth});
    return explanation;
}

} // namespace rastertrace
