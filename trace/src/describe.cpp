// SPDX-License-Identifier: MIT
#include <rastertrace/trace/describe.h>

#include <rastertrace/trace/scene_file.h>
#include <rastertrace/trace/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace rastertrace {

namespace {

/// `+ 3` for "3" and `- 3` for "-3": a number as the second term of a sum.
std::string plus(const std::string& number) {
    return number.starts_with('-') ? fmt::format("- {}", number.substr(1))
                                   : fmt::format("+ {}", number);
}

/// `- 3` for "3" and `+ 3` for "-3": a number that is taken away.
std::string minus(const std::string& number) {
    return number.starts_with('-') ? fmt::format("+ {}", number.substr(1))
                                   : fmt::format("- {}", number);
}

/// What the formulas need of the primitive that is being drawn.
struct PrimitiveText {
    std::string kind;
    std::string name;
    std::vector<std::string> vertices;
    std::vector<std::vector<std::string>> positions;
};

PrimitiveText primitive_of(const Replay& replay) {
    if (replay.primitive() == 0)
        return {};
    const StepView step = replay.trace().step(replay.primitive());
    return {step.text("kind"), step.text("name"), step.texts("vertices"), step.text_rows("at")};
}

std::string point(const std::vector<std::string>& coordinates) {
    return fmt::format("({})", fmt::join(coordinates, ", "));
}

/// The ends of an edge, found by its name.
struct EdgeEnds {
    std::vector<std::string> from;
    std::vector<std::string> to;
};

std::optional<EdgeEnds> ends_of_edge(const PrimitiveText& primitive, const std::string& edge) {
    const std::vector<std::string_view> names(primitive.vertices.begin(), primitive.vertices.end());
    const std::string_view separator = name_separator(names);
    for (std::size_t from = 0; from < names.size(); ++from)
        for (std::size_t to = 0; to < names.size(); ++to) {
            const bool have_places =
                from < primitive.positions.size() && to < primitive.positions.size() &&
                primitive.positions[from].size() >= 2 && primitive.positions[to].size() >= 2;
            if (from != to && have_places &&
                edge == fmt::format("{}{}{}", names[from], separator, names[to]))
                return EdgeEnds{primitive.positions[from], primitive.positions[to]};
        }
    return std::nullopt;
}

std::string describe_primitive(const PrimitiveText& primitive, const StepView& step) {
    std::string text = fmt::format("{} {}", primitive.kind, primitive.name);
    const auto colors = step.texts("colors");
    for (std::size_t i = 0; i < primitive.vertices.size() && i < primitive.positions.size(); ++i) {
        text += fmt::format("   {} {}", primitive.vertices[i], point(primitive.positions[i]));
        if (i < colors.size())
            text += fmt::format(" {}", colors[i]);
    }
    if (primitive.positions.empty())
        text += ": not all of it can be seen, it is clipped";
    if (step.field("octant"))
        text += fmt::format("   octant {}", step.text("octant"));
    return text;
}

std::string describe_matrix(const StepView& step) {
    std::string text = step.text("name") + " matrix";
    if (step.field("object"))
        text += " of " + step.text("object");
    text += ":";
    for (const auto& row : step.text_rows("rows"))
        text += fmt::format("  [{}]", fmt::join(row, " "));
    return text;
}

/// The space that a vertex goes on to comes of the one before: by a matrix, or by dividing by w.
std::string describe_vertex(const Replay& replay, const StepView& step) {
    const std::string space = step.text("space");
    const auto at = step.texts("at");
    std::string text =
        fmt::format("vertex {} in {} space: {}", step.text("name"), space, point(at));
    if (const auto before = replay.vertex_before();
        before != 0 && replay.trace().step(before).text("name") == step.text("name")) {
        const auto from = replay.trace().step(before).texts("at");
        if (space == "canonical" && from.size() == 4)
            text = fmt::format("vertex {} in {} space: ({}, {}, {}) / {} = {}", step.text("name"),
                               space, from[0], from[1], from[2], from[3], point(at));
        else if (!replay.trace().step(before).text("space").empty())
            text +=
                fmt::format(", from {} {}", replay.trace().step(before).text("space"), point(from));
    }
    if (step.field("snapped"))
        text += fmt::format(" -> {}", point(step.texts("snapped")));
    return text;
}

std::string describe_clip(const StepView& step) {
    std::string text =
        fmt::format("{} clipped at the {} plane:", step.text("name"), step.text("plane"));
    const auto inside = step.texts("inside");
    const auto count = std::count(inside.begin(), inside.end(), "true");
    text +=
        fmt::format(" {} of {} vertices inside, {} left", count, inside.size(), step.text("out"));
    return text;
}

std::string describe_order(const StepView& step) {
    const auto names = step.texts("names");
    const auto distances = step.texts("distances");
    std::string text = "the painter draws, farthest first:";
    constexpr std::size_t most_named = 8;
    for (std::size_t i = 0; i < names.size() && i < most_named; ++i)
        text += fmt::format("{} {} at {}", i == 0 ? "" : ",", names[i],
                            i < distances.size() ? distances[i] : "?");
    if (names.size() > most_named)
        text += fmt::format(" ... and {} more", names.size() - most_named);
    return text;
}

/// n . v = dot, and what follows from its sign.
std::string describe_face(const PrimitiveText& primitive, const StepView& step) {
    const bool is_by_light = step.text("by") == "light";
    std::string text = fmt::format("face {}: normal {} . {} {} = {}", primitive.name,
                                   point(step.texts("normal")), is_by_light ? "to light" : "to eye",
                                   point(step.texts("view")), step.text("dot"));
    if (step.text("cosine") != "null")
        text += fmt::format(", cosine {}", step.text("cosine"));
    return text + (step.text("culled") == "true" ? ": culled" : ": drawn");
}

std::string describe_light(const PrimitiveText& primitive, const StepView& step) {
    return fmt::format("light on {}: normal {} . light {} = {}, intensity {}, color {}",
                       primitive.name, point(step.texts("normal")), point(step.texts("light")),
                       step.text("dot"), step.text("intensity"), step.text("color"));
}

std::string describe_depth(const StepView& step) {
    const std::string stored = step.text("stored");
    return fmt::format("depth at ({}, {}): {} against {}: {}", step.text("x"), step.text("y"),
                       step.text("depth"), stored == "null" ? "nothing" : stored,
                       step.text("pass") == "true" ? "passes" : "fails");
}

std::string describe_edge_function(const StepView& step, const std::optional<EdgeEnds>& ends) {
    const bool is_top_left = step.text("top_left") == "true";
    return fmt::format("edge {}: E(x, y) = {} (x {}) {} (y {}), {}", step.text("edge"),
                       step.text("a"), ends ? minus(ends->from[0]) : "- x1", plus(step.text("b")),
                       ends ? minus(ends->from[1]) : "- y1",
                       is_top_left ? "top or left: samples where E = 0 belong to the triangle"
                                   : "samples where E = 0 do not belong to the triangle");
}

std::string describe_edge(const Replay& replay, const StepView& step) {
    const std::string name = step.text("edge");
    if (step.field("octant"))
        return fmt::format("side {}: octant {}", name, step.text("octant"));
    const auto ends = ends_of_edge(primitive_of(replay), name);
    if (step.field("a"))
        return describe_edge_function(step, ends);
    const std::string slope = step.text("dx_dy");
    if (slope == "null")
        return fmt::format("edge {}: horizontal, it has no dx/dy", name);
    if (ends)
        return fmt::format("edge {}: dx/dy = ({} {}) / ({} {}) = {}", name, ends->to[0],
                           minus(ends->from[0]), ends->to[1], minus(ends->from[1]), slope);
    return fmt::format("edge {}: dx/dy = {}", name, slope);
}

std::string describe_half(const StepView& step, const Canvas& canvas) {
    const Index from = step.whole("from_y").value_or(0);
    const Index to = step.whole("to_y").value_or(0);
    // A half is filled upward: its rows end where they began, or above.
    if (canvas.row_of(from) < canvas.row_of(to))
        return fmt::format("{} half: no row", step.text("half"));
    return fmt::format("{} half: rows y={} to {}", step.text("half"), from, to);
}

std::string describe_along(const StepView& step) {
    const bool is_x_major = step.field("x").has_value();
    return fmt::format("{} = {}: {} = {} -> {}", is_x_major ? "x" : "y",
                       step.text(is_x_major ? "x" : "y"), is_x_major ? "y" : "x",
                       step.text("value"), step.text("pixel"));
}

std::string describe_decision(const StepView& step) {
    const std::string d = step.text("d");
    const bool goes_straight = d.starts_with('-') || d == "0";
    return fmt::format("at ({}, {}): d = {} {}, {} to {}", step.text("x"), step.text("y"), d,
                       goes_straight ? "<= 0" : "> 0", goes_straight ? "straight on" : "diagonally",
                       step.text("move"));
}

std::string describe_sample(const PrimitiveText& primitive, const StepView& step) {
    std::string text = fmt::format("sample of ({}, {}):", step.text("x"), step.text("y"));
    const auto weights = step.texts("weights");
    for (std::size_t i = 0; i < weights.size(); ++i)
        text += fmt::format(" {} {}", i < primitive.vertices.size() ? primitive.vertices[i] : "?",
                            weights[i]);
    return text + (step.text("inside") == "true" ? ": none is negative, inside"
                                                 : ": one is negative, outside");
}

/// dx/dy of an edge of the current primitive as it was set up; nothing if it is horizontal.
std::optional<std::string> slope_of(const Replay& replay, const std::string& edge) {
    for (const std::size_t n : replay.edges()) {
        const StepView step = replay.trace().step(n);
        if (step.text("edge") == edge && step.field("dx_dy") && step.text("dx_dy") != "null")
            return step.text("dx_dy");
    }
    return std::nullopt;
}

/// One end of a row: `left AB: x = 2 + 3/4 (2 - 5) = -1/4 -> -1`.
std::string describe_end(const Replay& replay, const StepView& step, const std::string& side,
                         const std::string& pixel) {
    const std::string edge = step.text(side + "_edge");
    const std::string x = step.text(side);
    const std::string y = step.text("y");
    std::string text = edge.empty() ? side + ": x = " : fmt::format("{} {}: x = ", side, edge);

    const auto slope = slope_of(replay, edge);
    const auto ends = ends_of_edge(primitive_of(replay), edge);
    const bool adds = replay.trace().method_value("lerp") == "incremental";
    std::string x_before;
    if (adds && replay.scanline_before() != 0) {
        const StepView before = replay.trace().step(replay.scanline_before());
        for (const std::string other_side : {"left", "right"})
            if (before.text(other_side + "_edge") == edge)
                x_before = before.text(other_side);
    }
    if (slope && !x_before.empty())
        text += fmt::format("{} {} = ", x_before,
                            replay.trace().canvas.down() > 0 ? plus(*slope) : minus(*slope));
    else if (slope && ends)
        text +=
            fmt::format("{} {} ({} {}) = ", ends->from[0], plus(*slope), y, minus(ends->from[1]));
    return text + fmt::format("{} -> {}", x, pixel);
}

std::string describe_scanline(const Replay& replay, const StepView& step) {
    const std::string y = step.text("y");
    const bool is_at_center = replay.trace().method_value("sample") == "center";
    std::string text = fmt::format("scanline y={}{}   {}   {}", y,
                                   is_at_center ? fmt::format(", samples at y = {} + 1/2", y) : "",
                                   describe_end(replay, step, "left", step.text("from")),
                                   describe_end(replay, step, "right", step.text("to")));
    if (*step.whole("to") < *step.whole("from"))
        text += "   no pixel between";
    return text;
}

std::string describe_pixel(const Replay& replay, const StepView& step) {
    std::string text = fmt::format("pixel ({}, {})", step.text("x"), step.text("y"));
    if (step.field("color"))
        text += fmt::format(" {}", step.text("color"));
    if (!replay.trace().canvas.contains(*step.whole("x"), *step.whole("y")))
        text += "   not on the canvas, not drawn";
    else if (replay.drew_over() != 0)
        text += fmt::format("   over step {}", replay.drew_over());
    return text;
}

std::string describe_reject(const StepView& step) {
    const std::string x = step.text("x");
    const std::string y = step.text("y");
    const std::string to_x = step.field("to_x") ? step.text("to_x") : x;
    const std::string to_y = step.field("to_y") ? step.text("to_y") : y;
    std::string what;
    if (x.empty())
        what = fmt::format("rows y={} to {}", y, to_y);
    else if (x == to_x && y == to_y)
        what = fmt::format("pixel ({}, {})", x, y);
    else
        what = fmt::format("pixels ({}, {}) to ({}, {})", x, y, to_x, to_y);
    return fmt::format("{}: dropped, {}", what, step.text("why"));
}

std::string describe_skip(const Replay& replay, const StepView& step) {
    const PrimitiveText primitive = primitive_of(replay);
    return fmt::format("{} {}: skipped, {}", primitive.kind, primitive.name, step.text("why"));
}

std::string describe_undecided(const StepView& step) {
    if (step.text("error").empty())
        return "a number has left the doubles; drawn in exact numbers";
    return fmt::format(
        "doubles leave it open: a difference of {}, off by up to {}; drawn in exact numbers",
        step.text("difference"), step.text("error"));
}

std::string unsafe_description(const Replay& replay) {
    if (replay.step() == 0)
        return "nothing drawn yet";
    const StepView step = replay.trace().step(replay.step());
    const auto kind = replay.trace().kind_of(replay.step());
    if (!kind) {
        constexpr std::size_t width = 100;
        return shortened(step.json(), width);
    }
    switch (*kind) {
    case StepKind::matrix:
        return describe_matrix(step);
    case StepKind::vertex:
        return describe_vertex(replay, step);
    case StepKind::clip:
        return describe_clip(step);
    case StepKind::order:
        return describe_order(step);
    case StepKind::face:
        return describe_face(primitive_of(replay), step);
    case StepKind::light:
        return describe_light(primitive_of(replay), step);
    case StepKind::depth:
        return describe_depth(step);
    case StepKind::primitive:
        return describe_primitive(primitive_of(replay), step);
    case StepKind::edge:
        return describe_edge(replay, step);
    case StepKind::half:
        return describe_half(step, replay.trace().canvas);
    case StepKind::ray:
        return fmt::format("a line begins at ({}, {})", step.text("x"), step.text("y"));
    case StepKind::scanline:
        return describe_scanline(replay, step);
    case StepKind::along:
        return describe_along(step);
    case StepKind::decide:
        return describe_decision(step);
    case StepKind::sample:
        return describe_sample(primitive_of(replay), step);
    case StepKind::pixel:
        return describe_pixel(replay, step);
    case StepKind::reject:
        return describe_reject(step);
    case StepKind::undecided:
        return describe_undecided(step);
    case StepKind::skip:
        break;
    }
    return describe_skip(replay, step);
}

} // namespace

std::string describe_step(const Replay& replay) {
    return printable(unsafe_description(replay));
}

} // namespace rastertrace
