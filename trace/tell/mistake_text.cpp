// SPDX-License-Identifier: MIT
#include "mistake_text.h"

#include "step_text.h"

#include <rastertrace/core/draw/model/mistakes.h>

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

namespace rastertrace {

namespace {

bool is_of_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

void add_ends(Letters& letters, const PrimitiveText& primitive, const std::string& edge) {
    const auto ends = ends_of_edge(primitive, edge);
    if (!ends)
        return;
    const std::vector<std::pair<const char*, std::string>> all{
        {"x1", ends->from[0]}, {"y1", ends->from[1]}, {"x2", ends->to[0]}, {"y2", ends->to[1]}};
    letters.insert(all.begin(), all.end());
}

/// Of Bresenham's line, dx is the longer way.
void add_line(Letters& letters, const Replay& replay, bool is_walked) {
    const auto ends = ends_of_line(replay, primitive_of(replay));
    if (!ends)
        return;
    const Rational dx = ends->to.x - ends->from.x, dy = ends->to.y - ends->from.y;
    const auto& [shorter, longer] = std::minmax({Rational(abs(dx)), Rational(abs(dy))});
    letters.emplace("dx", text(is_walked ? longer : dx));
    letters.emplace("dy", text(is_walked ? shorter : dy));
    letters.emplace("x0", text(ends->from.x));
    letters.emplace("y0", text(ends->from.y));
    if (const bool is_steep = abs(dy) > abs(dx); !is_steep && dx != 0)
        letters.emplace("m", text(Rational(dy / dx)));
}

/// What the letters of a formula stand for in the current step, of whose values `wrong` is the first one that is not what
/// its numbers give.
Letters letters_of(const Replay& replay, std::string_view wrong) {
    const StepView step = replay.trace().step(replay.step());
    const PrimitiveText primitive = primitive_of(replay);
    Letters letters;
    switch (replay.trace().kind_of(replay.step()).value()) {
    case StepKind::edge:
        add_ends(letters, primitive, step.as<EdgeStep>().edge.text());
        break;
    case StepKind::scanline: {
        const auto row = step.as<ScanlineStep>();
        const bool is_right = wrong.starts_with("right");
        add_ends(letters, primitive, (is_right ? row.right_edge : row.left_edge).text());
        letters.emplace("y", std::to_string(row.y));
        letters.emplace("left", row.left.text());
        letters.emplace("right", row.right.text());
        break;
    }
    case StepKind::decide:
        add_line(letters, replay, true);
        break;
    case StepKind::along: {
        const auto along = step.as<AlongStep>();
        add_line(letters, replay, false);
        if (along.x)
            letters.emplace("x", std::to_string(*along.x));
        break;
    }
    case StepKind::face: {
        const auto face = step.as<FaceStep>();
        letters.emplace("normal", point(face.normal.texts()));
        letters.emplace("view", point(face.view.texts()));
        break;
    }
    case StepKind::light: {
        const auto light = step.as<LightStep>();
        letters.emplace("normal", point(light.normal.texts()));
        letters.emplace("light", point(light.light.texts()));
        letters.emplace("N", point(light.normal.texts()));
        letters.emplace("L", point(light.light.texts()));
        break;
    }
    case StepKind::depth: {
        const auto test = step.as<DepthStep>();
        letters.emplace("z", test.depth.text());
        letters.emplace("buffer", test.stored.text());
        break;
    }
    default:
        break;
    }
    return letters;
}

} // namespace

std::string put_in(std::string_view formula, const Letters& letters) {
    const std::size_t equals = formula.find(" = ");
    std::size_t at = equals == std::string_view::npos ? 0 : equals + 3;
    std::string text(formula.substr(0, at));
    while (at < formula.size()) {
        if (!is_of_word(formula[at])) {
            text += formula[at++];
            continue;
        }
        const std::size_t begin = at;
        while (at < formula.size() && is_of_word(formula[at]))
            ++at;
        const std::string_view word = formula.substr(begin, at - begin);
        const auto found = letters.find(word);
        if (found == letters.end()) {
            text += word;
            continue;
        }
        const std::string number = in_sentence(found->second);
        const bool needs_brackets =
            number.front() != '(' &&
            (number.front() == '-' || number.find('/') != std::string::npos);
        text += needs_brackets ? "(" + number + ")" : number;
    }
    return text;
}

std::string formula_of_mistake(const Replay& replay) {
    const Trace& trace = replay.trace();
    if (!trace.numbers_give)
        return {};
    const auto given = trace.numbers_give->find(trace.number_of(replay.step()));
    if (given == trace.numbers_give->end())
        return {};
    std::string text;
    for (const Mistake* const mistake : trace.method.triangles.mistakes)
        text += fmt::format("; {}: {}", mistake->name,
                            put_in(Words(mistake->says).in(language_of_steps()),
                                   letters_of(replay, given->second)));
    return text;
}

} // namespace rastertrace
