// SPDX-License-Identifier: MIT
#include "step_kind.h"

#include <algorithm>
#include <array>

namespace rastertrace {

namespace {

using enum FieldType;
using enum FieldRole;

// clang-format off
const std::array<StepRow, step_kinds> table{{
    {StepKind::triangulate, "triangulate", "a face that is not convex has been cut into triangles",
     {"{@face} is not convex; its normal {normal} is largest in {drops}, which is dropped; ears: {@ears}",
      "{@face} não é convexa; sua normal {normal} é maior em {drops}, que é descartada; orelhas: {@ears}"},
     {{"name", string, key, true}, {"vertices", list, told}, {"at", list, reason}, {"normal", list, reason},
      {"drops", string, decision}, {"ears", list, decision}}},

    {StepKind::matrix, "matrix", "a transform is set up",
     {"{#name} matrix{@of_object}{@factors}:{@rows}",
      "matriz de {#name}{@of_object}{@factors}:{@rows}"},
     {{"name", string, key, true}, {"object", string, key}, {"rows", list, told}, {"factors", list, told},
      {"factor_rows", list, told}, {"camera", list, told}}},

    {StepKind::vertex, "vertex", "a vertex enters a space",
     {"vertex {name} in {#space} space: {@place}{@snapped}",
      "vértice {name} no espaço {#space}: {@place}{@snapped}"},
     {{"name", string, key, true}, {"space", string, key, true}, {"at", list, reason},
      {"snapped", list, decision}}},

    {StepKind::order, "order", "the painter has sorted the triangles",
     {"the painter draws, farthest first:{@farthest_first}",
      "o pintor desenha, do mais distante ao mais próximo:{@farthest_first}"},
     {{"names", list, decision}, {"distances", list, reason}, {"listed", list, told}}},

    {StepKind::primitive, "primitive", "a primitive begins",
     {"{#kind} {name}{@corners}{@octant}{@painted}",
      "{#kind} {name}{@corners}{@octant}{@painted}"},
     {{"kind", string, told, true}, {"name", string, key, true}, {"vertices", list, told},
      {"at", list, reason}, {"within", quantity, told}, {"depths", list, reason},
      {"color", string, told}, {"colors", list, reason}, {"octant", whole, decision},
      {"part", boolean, told}, {"painted", boolean, told}}},

    {StepKind::face, "face", "a face is tested",
     {"face {@primitive}: normal {normal} . {@toward} {view} = {dot}{@cosine}: {culled?culled:drawn}",
      "face {@primitive}: normal {normal} . {@toward} {view} = {dot}{@cosine}: {culled?eliminada:desenhada}"},
     {{"name", string, key}, {"normal", list, reason}, {"view", list, reason},
      {"dot", quantity, reason, true}, {"cosine", quantity, told, false, true}, {"by", string, key}, {"culled", boolean, decision},
      {"opposite", boolean, told}}},

    {StepKind::light, "light", "a face is lit",
     {"light on {@primitive}: normal {normal} . light {light} = {dot}, intensity {@intensity}, color {color}{@level}",
      "luz em {@primitive}: normal {normal} . luz {light} = {dot}, intensidade {@intensity}, cor {color}{@level}"},
     {{"name", string, key}, {"normal", list, reason}, {"light", list, reason},
      {"dot", quantity, reason}, {"intensity", quantity, told, true}, {"color", string, decision}}},

    {StepKind::clip, "clip", "a primitive meets a plane with a vertex outside it",
     {"{name} clipped at the {#plane} plane: {@inside} vertices inside, {out} left",
      "{name} recortado no plano {#plane}: {@inside} vértices dentro, restam {out}"},
     {{"name", string, key}, {"plane", string, key, true}, {"inside", list, decision},
      {"out", whole, decision}}},

    {StepKind::edge, "edge", "an edge is set up, or a side is about to be drawn",
     {"{@edge}",
      "{@edge}"},
     {{"edge", string, key, true}, {"dx_dy", quantity, reason, false, true}, {"a", quantity, reason},
      {"b", quantity, reason}, {"top_left", boolean, decision}, {"octant", whole, decision}}},

    {StepKind::half, "half", "a half of a `two-halves` fill begins",
     {"{#half} half: {@rows_of_half}",
      "metade {#half}: {@rows_of_half}"},
     {{"half", string, key, true}, {"from_y", whole, decision}, {"to_y", whole, decision}}},

    {StepKind::ray, "ray", "a line of the fan begins",
     {"a line begins at ({x}, {y}){@line_to}",
      "um segmento começa em ({x}, {y}){@line_to}"},
     {{"x", whole, key, true}, {"y", whole, key, true}}},

    {StepKind::scanline, "scanline", "the two ends of a row are known",
     {"scanline y={y}{@samples}   {@left_end}   {@right_end}{@depths_of_row}{@empty}",
      "linha y={y}{@samples}   {@left_end}   {@right_end}{@depths_of_row}{@empty}"},
     {{"y", whole, key, true}, {"left", quantity, reason, true}, {"right", quantity, reason, true},
      {"from", whole, decision, true}, {"to", whole, decision, true}, {"left_edge", string, reason},
      {"right_edge", string, reason}, {"left_depth", quantity, reason},
      {"right_depth", quantity, reason}}},

    {StepKind::along, "along", "a `naive` or `dda` line is at a step of its major axis",
     {"{@along} = {@slope_form}{value}{@rule_of_line} -> {pixel}",
      "{@along} = {@slope_form}{value}{@rule_of_line} -> {pixel}"},
     {{"x", whole, key}, {"y", whole, key}, {"value", quantity, reason, true},
      {"pixel", whole, decision, true}}},

    {StepKind::decide, "decide", "Bresenham chooses",
     {"at ({x}, {y}): d = {d} {@sign_of_d} to {move}{@next_d}",
      "em ({x}, {y}): d = {d} {@sign_of_d} para {move}{@next_d}"},
     {{"x", whole, key, true}, {"y", whole, key, true}, {"d", quantity, reason, true},
      {"move", string, decision, true}}},

    {StepKind::sample, "sample", "`barycentric` tests a pixel",
     {"sample of ({x}, {y}):{@weights}: {inside?none is negative, inside:one is negative, outside}",
      "amostra de ({x}, {y}):{@weights}: {inside?nenhum é negativo, dentro:um é negativo, fora}"},
     {{"x", whole, key, true}, {"y", whole, key, true}, {"weights", list, reason},
      {"inside", boolean, decision}}},

    {StepKind::depth, "depth", "a pixel meets the depth buffer",
     {"depth at ({x}, {y}): {depth} against {@against}: {pass?passes:fails}{@depth_rule}",
      "profundidade em ({x}, {y}): {depth} contra {@against}: {pass?passa:falha}{@depth_rule}"},
     {{"x", whole, key, true}, {"y", whole, key, true}, {"depth", quantity, reason, true},
      {"stored", quantity, reason, false, true}, {"pass", boolean, decision},
      {"side_of", string, reason}, {"beside", string, reason}, {"behind", string, reason}}},

    {StepKind::pixel, "pixel", "a pixel is plotted",
     {"pixel ({x}, {y}){@color}{@reason}{@drawn_over}",
      "pixel ({x}, {y}){@color}{@reason}{@drawn_over}"},
     {{"x", whole, key, true}, {"y", whole, key, true}, {"color", string, decision}}},

    {StepKind::reject, "reject", "pixels are dropped",
     {"{@dropped}: dropped, {#why}",
      "{@dropped}: não se desenha, {#why}"},
     {{"x", whole, key}, {"to_x", whole, key}, {"y", whole, key}, {"to_y", whole, key},
      {"why", string, decision, true}}},

    {StepKind::skip, "skip", "a primitive draws nothing",
     {"{@kind} {@primitive}: skipped, {#why}",
      "{@kind} {@primitive}: omitido, {#why}"},
     {{"name", string, key}, {"why", string, decision, true}}},

    {StepKind::undecided, "undecided", "with `adaptive`: doubles leave a decision about the primitive open",
     {"{@what_is_open}; drawn in exact numbers",
      "{@what_is_open}; desenhado com números exatos"},
     {{"difference", quantity, reason}, {"error", quantity, reason}}},
}};
// clang-format on

} // namespace

FieldType element_type_of(const StepField& list) {
    constexpr std::array<std::string_view, 5> of_names{"vertices", "names", "ears", "factors",
                                                       "colors"};
    if (std::find(of_names.begin(), of_names.end(), list.name) != of_names.end())
        return string;
    return list.name == "inside" ? boolean : quantity;
}

const StepRow& row_of(StepKind kind) {
    return table[static_cast<std::size_t>(kind)];
}

std::string_view name_of(StepKind kind) {
    return row_of(kind).name;
}

std::optional<StepKind> step_kind_named(std::string_view name) {
    for (const StepRow& row : table)
        if (row.name == name)
            return row.kind;
    return std::nullopt;
}

std::vector<std::string_view> step_kind_names() {
    std::vector<std::string_view> names;
    for (const StepRow& row : table)
        names.push_back(row.name);
    return names;
}

} // namespace rastertrace
