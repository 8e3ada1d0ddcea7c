// SPDX-License-Identifier: MIT
#pragma once

// Figures of scenes, and what is read back from their shapes.

#include "traces.h"

#include <rastertrace/figures/figure.h>
#include <rastertrace/trace/tell/selector.h>

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rastertrace {

/// The trace of a scene, with its title, as the program has it.
inline Trace trace_of_scene(const std::string& text) {
    Trace trace = trace_of(scene_in(text));
    trace.title = scene_in(text).title;
    return trace;
}

/// The first step that a selector means.
inline std::size_t step_of(const Trace& trace, const std::string& selector) {
    const auto parsed = parse_selector({"test", selector}, trace);
    return matching_steps(parsed.value(), trace).value().front();
}

inline Drawing figure_of(const Trace& trace, FigureFrame frame, FigureOptions options = {}) {
    return FigureMaker(trace, {frame}, std::move(options)).figure(0);
}

/// The figure of a step with what belongs to it.
inline Drawing figure_at(const Trace& trace, const std::string& selector,
                         FigureOptions options = {}) {
    const std::size_t n = step_of(trace, selector);
    return figure_of(trace, {.steps = {n, end_of(trace, n)}}, std::move(options));
}

inline Drawing whole_figure(const Trace& trace, FigureOptions options = {}) {
    return figure_of(trace, {.steps = {0, trace.size()}}, std::move(options));
}

template <typename Kind> std::vector<Kind> shapes_of(const Drawing& drawing, Role role) {
    std::vector<Kind> found;
    for (const Shape& shape : drawing.shapes)
        if (const auto* const one = std::get_if<Kind>(&shape); one != nullptr && one->role == role)
            found.push_back(*one);
    return found;
}

inline std::vector<std::string> texts_of(const Drawing& drawing, Role role) {
    std::vector<std::string> texts;
    for (const Label& label : shapes_of<Label>(drawing, role))
        texts.push_back(label.text);
    return texts;
}

/// The letters of a label, from the top of an A to the line that they stand on.
inline Rectangle box_of(const Label& label) {
    const double width = width_of(label.text, label.size, label.is_bold);
    const double left = label.at.x - (label.anchor == Anchor::end      ? width
                                      : label.anchor == Anchor::middle ? width / 2
                                                                       : 0);
    return {{left, label.at.y - 0.8 * label.size}, width, 0.8 * label.size};
}

inline std::vector<Rectangle> boxes_of(const Drawing& drawing, Role role) {
    std::vector<Rectangle> boxes;
    for (const Label& label : shapes_of<Label>(drawing, role))
        boxes.push_back(box_of(label));
    return boxes;
}

} // namespace rastertrace
