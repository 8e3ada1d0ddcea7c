// SPDX-License-Identifier: MIT
#include <rastertrace/trace/describe.h>

#include <rastertrace/trace/scene_file.h>
#include <rastertrace/trace/text.h>

#include <fmt/format.h>

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

std::string describe_primitive(const PrimitiveText& primitive) {
    std::string text = fmt::format("{} {}", primitive.kind, primitive.name);
    for (std::size_t i = 0; i < primitive.vertices.size() && i < primitive.positions.size(); ++i)
        text += fmt::format("   {} {}", primitive.vertices[i], point(primitive.positions[i]));
    return text;
}

std::string describe_edge(const Replay& replay, const StepView& step) {
    const std::string name = step.text("edge");
    const std::string slope = step.text("dx_dy");
    std::string text = "edge " + name;
    if (slope == "null")
        return text + ": horizontal, it has no dx/dy";
    if (const auto ends = ends_of_edge(primitive_of(replay), name))
        return text + fmt::format(": dx/dy = ({} {}) / ({} {}) = {}", ends->to[0],
                                  minus(ends->from[0]), ends->to[1], minus(ends->from[1]), slope);
    return text + ": dx/dy = " + slope;
}

/// dx/dy of an edge of the current primitive as it was set up; nothing if it is horizontal.
std::optional<std::string> slope_of(const Replay& replay, const std::string& edge) {
    for (const std::size_t n : replay.edges()) {
        const StepView step = replay.trace().step(n);
        if (step.text("edge") == edge && step.text("dx_dy") != "null")
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
    std::string text = fmt::format("scanline y={}   {}   {}", step.text("y"),
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
    std::string what;
    if (step.field("to_y"))
        what = fmt::format("rows y={} to {}", step.text("y"), step.text("to_y"));
    else if (step.field("to_x"))
        what = fmt::format("pixels ({0}, {2}) to ({1}, {2})", step.text("x"), step.text("to_x"),
                           step.text("y"));
    else
        what = fmt::format("pixel ({}, {})", step.text("x"), step.text("y"));
    return fmt::format("{}: dropped, {}", what, step.text("why"));
}

std::string describe_skip(const Replay& replay, const StepView& step) {
    const PrimitiveText primitive = primitive_of(replay);
    return fmt::format("{} {}: skipped, {}", primitive.kind, primitive.name, step.text("why"));
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
    case StepKind::primitive:
        return describe_primitive(primitive_of(replay));
    case StepKind::edge:
        return describe_edge(replay, step);
    case StepKind::scanline:
        return describe_scanline(replay, step);
    case StepKind::pixel:
        return describe_pixel(replay, step);
    case StepKind::reject:
        return describe_reject(step);
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
