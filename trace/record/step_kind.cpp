// SPDX-License-Identifier: MIT
#include "step_kind.h"

#include <algorithm>
#include <array>

namespace rastertrace {

namespace {

// clang-format off
const std::array<StepRow, step_kinds> table{{
    {StepKind::triangulate, "a face that is not convex has been cut into triangles",
     "{@face} is not convex; its normal {normal} is largest in {drops}, which is dropped; ears: {@ears}"},

    {StepKind::matrix, "a transform is set up",
     "{#name} matrix{@of_object}{@factors}:{@rows}"},

    {StepKind::vertex, "a vertex enters a space",
     "vertex {name} in {#space} space: {@place}{@snapped}"},

    {StepKind::order, "the painter has sorted the faces",
     "the painter draws, farthest first:{@farthest_first}"},

    {StepKind::primitive, "a primitive begins",
     "{#kind} {name}{@corners}{@radius}{@octant}{@painted}"},

    {StepKind::face, "a face is tested",
     "face {@primitive}: normal {normal} . {@toward} {view} = {dot}{@cosine}: {culled?culled:drawn}"},

    {StepKind::light, "a face is lit",
     "light on {@primitive}: normal {normal} . light {light} = {dot}, intensity {@intensity}, color {color}{@level}"},

    {StepKind::clip, "a primitive meets a plane with a vertex outside it",
     "{name} clipped at the {#plane} plane: {@inside} vertices inside, {out} left"},

    {StepKind::edge, "an edge is set up, or a side is about to be drawn",
     "{@edge}"},

    {StepKind::half, "a half of a `two-halves` fill begins",
     "{#half} half: {@rows_of_half}"},

    {StepKind::ray, "a line of the fan begins",
     "a line begins at ({x}, {y}){@line_to}"},

    {StepKind::crossings, "a row of a polygon meets its edges",
     "row y={y}{@crossings}: inside where the winding number is {@fill_rule}"},

    {StepKind::scanline, "the two ends of a row are known",
     "scanline y={y}{@samples}   {@left_end}   {@right_end}{@depths_of_row}{@empty}"},

    {StepKind::along, "a `naive`, `dda` or `diamond-exit` line is at a step of its major axis",
     "{@along} = {@slope_form}{value}{@rule_of_line} -> {pixel}"},

    {StepKind::decide, "Bresenham chooses",
     "at ({x}, {y}): d = {d} {@sign_of_d} to {move}{@next_d}"},

    {StepKind::sample, "`barycentric` tests a pixel",
     "sample of ({x}, {y}):{@weights}: {inside?none is negative, inside:one is negative, outside}"},

    {StepKind::depth, "a pixel meets the depth buffer",
     "depth at ({x}, {y}): {depth} against {@against}: {pass?passes:fails}{@depth_rule}"},

    {StepKind::pixel, "a pixel is plotted",
     "pixel ({x}, {y}){@color}{@reason}{@drawn_over}"},

    {StepKind::reject, "pixels are dropped",
     "{@dropped}: dropped, {#why}"},

    {StepKind::skip, "a primitive draws nothing",
     "{@kind} {@primitive}: skipped, {#why}"},

    {StepKind::undecided, "with `adaptive`: intervals of doubles leave a decision about the next primitive open",
     "{@what_is_open}; drawn in exact numbers"},
}};
// clang-format on

} // namespace

const StepRow& row_of(StepKind kind) {
    return table[static_cast<std::size_t>(kind)];
}

std::string_view name_of(StepKind kind) {
    return step_names[static_cast<std::size_t>(kind)];
}

std::optional<StepKind> step_kind_named(std::string_view name) {
    const auto* const found = std::find(step_names.begin(), step_names.end(), name);
    return found == step_names.end()
               ? std::nullopt
               : std::optional(static_cast<StepKind>(found - step_names.begin()));
}

std::vector<std::string_view> step_kind_names() {
    return {step_names.begin(), step_names.end()};
}

} // namespace rastertrace
