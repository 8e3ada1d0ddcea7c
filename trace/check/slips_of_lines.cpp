// SPDX-License-Identifier: MIT
// The mistakes that people make in Bresenham's line.

#include "slip_results.h"

#include <array>
#include <initializer_list>

namespace rastertrace {

namespace {

/// The decisions of a line, whether they or its pixels are asked for; nullptr of anything else.
const BresenhamDecisions* line_in(const Formula& formula) {
    const auto* const pixels = as_form<LinePixels>(formula);
    return pixels != nullptr ? &pixels->decisions : as_form<BresenhamDecisions>(formula);
}

/// The same with other decisions.
Formula with_line(const Formula& formula, const BresenhamDecisions& line) {
    Formula other = formula;
    if (auto* const pixels = std::get_if<LinePixels>(&other.of))
        pixels->decisions = line;
    else
        other.of = line;
    return other;
}

std::vector<SlipResult> tie_the_other_way(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* line = line_in(formula)) {
        BresenhamDecisions other = *line;
        other.steps_at_ties = !other.steps_at_ties;
        results.add_formula(with_line(formula, other));
    }
    return results.take();
}

std::vector<SlipResult> factor_2_dropped(const Formula& formula) {
    SlipResults results(formula);
    const auto* line = line_in(formula);
    if (line == nullptr)
        return {};
    for (const auto& [at_start, in_steps] : {std::pair(1, 2), std::pair(2, 1), std::pair(1, 1)}) {
        BresenhamDecisions other = *line;
        other.factor_at_start = at_start;
        other.factor_in_steps = in_steps;
        results.add_formula(with_line(formula, other));
    }
    return results.take();
}

std::vector<SlipResult> dx_and_dy_exchanged(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* line = line_in(formula)) {
        BresenhamDecisions other = *line;
        std::swap(other.major, other.minor);
        results.add_formula(with_line(formula, other));
    }
    return results.take();
}

/// The decisions with other steps.
std::vector<SlipResult>
decided_otherwise(const Formula& formula,
                  std::initializer_list<std::array<std::optional<Rational>, 3>> others) {
    SlipResults results(formula);
    for (const auto& [start, straight, diagonal] : others) {
        BresenhamDecisions other = *line_in(formula);
        if (start) // of one step, it is the number before it
            other.other_start = start;
        other.other_straight = straight;
        other.other_diagonal = diagonal;
        results.add_formula(with_line(formula, other));
    }
    return results.take();
}

std::vector<SlipResult> steps_exchanged(const Formula& formula) {
    const auto* const line = line_in(formula);
    return line == nullptr
               ? std::vector<SlipResult>{}
               : decided_otherwise(formula, {{std::nullopt, line->diagonal(), line->straight()}});
}

std::vector<SlipResult> diagonal_of_one_axis(const Formula& formula) {
    const auto* const line = line_in(formula);
    return line == nullptr
               ? std::vector<SlipResult>{}
               : decided_otherwise(formula,
                                   {{std::nullopt, std::nullopt, line->straight()},
                                    {std::nullopt, std::nullopt, Rational(-2 * line->major)}});
}

std::vector<SlipResult> start_of_other_axis(const Formula& formula) {
    const auto* const line = line_in(formula);
    return line == nullptr ? std::vector<SlipResult>{}
                           : decided_otherwise(formula, {{Rational(2 * line->major - line->minor),
                                                          std::nullopt, std::nullopt}});
}

/// dx and dy with their signs, in an octant whose lines rise.
std::vector<SlipResult> octant_ignored(const Formula& formula) {
    SlipResults results(formula);
    const auto* const line = line_in(formula);
    if (line == nullptr)
        return {};
    if (const auto* const pixels = as_form<LinePixels>(formula)) {
        LinePixels other = *pixels; // the steps of the first octant
        other.straight = {1, 0};
        other.diagonal = {1, 1};
        results.add_formula({other});
    }
    for (const int sign_of_major : {1, -1})
        for (const int sign_of_minor : {1, -1})
            for (const bool is_exchanged : {false, true}) {
                BresenhamDecisions other = *line;
                other.major = sign_of_major * line->major;
                other.minor = sign_of_minor * line->minor;
                if (is_exchanged)
                    std::swap(other.major, other.minor);
                if (sign_of_major + sign_of_minor < 2) // else the lines rise
                    results.add_formula(with_line(formula, other));
            }
    return results.take();
}

std::vector<SlipResult> shifted_list(const Formula& formula) {
    SlipResults results(formula);
    const Values& right = results.right();
    const auto* const line = as_form<BresenhamDecisions>(formula);
    if (line == nullptr || right.size() < 2 || line->other_start) // one step is no list
        return {};
    results.add(Values(right.begin() + 1, right.end()));
    Values late{right.front()};
    late.insert(late.end(), right.begin(), right.end());
    results.add(std::move(late));
    return results.take();
}

/// A line without its last pixel, or rows without the last.
std::vector<SlipResult> last_pixel_left_out(const Formula& formula) {
    SlipResults results(formula);
    if (as_form<InclusiveCount>(formula))
        results.add(Rational(results.right().front() - 1));
    return results.take();
}

/// The row of the middle corner, which both edges of the shorter side have.
std::vector<SlipResult> middle_row_twice(const Formula& formula) {
    SlipResults results(formula);
    if (const auto* count = as_form<InclusiveCount>(formula); count && count->is_of_rows)
        results.add(Rational(results.right().front() + 1));
    return results.take();
}

constexpr Slip line_slips[] = {
    {"steps-exchanged", as_mistake, as_mistake, as_mistake, 20, steps_exchanged},
    {"diagonal-of-one-axis", as_mistake, as_mistake, as_mistake, 15, diagonal_of_one_axis},
    {"start-of-other-axis", as_mistake, as_mistake, as_mistake, 15, start_of_other_axis},
    {"factor-2-dropped", as_mistake, as_mistake, as_mistake, 20, factor_2_dropped},
    {"dx-and-dy-exchanged", as_mistake, as_mistake, as_mistake, 20, dx_and_dy_exchanged},
    {"octant-ignored", as_mistake, as_mistake, as_mistake, 20, octant_ignored},
    {"shifted-list", "a list that begins one step too early or too late", "d before each step",
     "each number stands beside the wrong step", 20, shifted_list},
    {"tie-the-other-way", "d = 0 decided the other way", "the scene's own rule for d = 0",
     as_mistake, 100, tie_the_other_way},
    {"last-pixel", "the last minus the first", "one more: the first counts, too",
     "a gap at the end of each line", 300, last_pixel_left_out},
    {"middle-row-twice", as_mistake, as_mistake, as_mistake, 100, middle_row_twice},
};

} // namespace

std::span<const Slip> slips_of_lines() {
    return line_slips;
}

} // namespace rastertrace
