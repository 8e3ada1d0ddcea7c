// SPDX-License-Identifier: MIT
#include "claim_meaning.h"

#include "claim_comparison.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace rastertrace {

namespace {

/// What a claim about a name is meant to be, other than Bresenham's d.
struct Meant {
    StepKind kind;
    std::string key;
    std::string field;
    std::string space = {};
};

bool names_vertex(const std::string& name, const StepIndex& told) {
    if (!told.find(StepKind::vertex, {{"name", name}}).empty())
        return true;
    const auto& primitives = told.find(StepKind::primitive, {});
    return std::any_of(primitives.begin(), primitives.end(), [&](std::size_t n) {
        const auto names = told.trace().step(n).as<PrimitiveStep>().vertices.texts();
        return std::find(names.begin(), names.end(), name) != names.end();
    });
}

/// A scene without a pipeline tells where a vertex is drawn; of one with several spaces, that with so many numbers.
std::string space_of(const std::string& name, std::size_t count, const Claim& claim,
                     const Claims& claims, const StepIndex& told) {
    std::vector<std::string> spaces;
    for (const std::size_t n : told.find(StepKind::vertex, {{"name", name}})) {
        const auto vertex = told.trace().step(n).as<VertexStep>();
        const std::string space = vertex.space.text();
        if (vertex.at.values().size() == count &&
            std::find(spaces.begin(), spaces.end(), space) == spaces.end())
            spaces.push_back(space);
    }
    if (spaces.size() > 1)
        throw problem_at(claims.source, claim.offset,
                         fmt::format("expected the space that {} is in ({}), found none",
                                     printable(name), joined(spaces, ", ")),
                         fmt::format("{} {}: ...", printable(name), spaces.back()));
    return spaces.empty() ? "screen" : spaces.front();
}

std::optional<Meant> meaning_of_name(const std::string& name, std::size_t count, bool is_open,
                                     const Claim& claim, const Claims& claims,
                                     const TruthIndex& truth) {
    const StepIndex& told = truth.exact();
    if (!told.find(StepKind::decide, {{"in", name}}).empty())
        return std::nullopt;
    if (is_open && names_face(name, truth))
        return Meant{StepKind::face, "name", "culled"};
    if (count == 1 && !told.find(StepKind::edge, {{"edge", edge_in(told, name)}}).empty())
        return Meant{StepKind::edge, "edge", "dx_dy"};
    if (count == 1 || !names_vertex(name, told))
        return std::nullopt;
    return Meant{StepKind::vertex, "name", "at", space_of(name, count, claim, claims, told)};
}

/// Numbers of a row are the ends of a polygon's spans; where there is none, the pixels.
Claim row_as_meant(Claim claim, const StepIndex& told) {
    if (!told.find(StepKind::crossings, {}).empty())
        return claim;
    claim.step = name_of(StepKind::scanline);
    for (ClaimedField& field : claim.fields) {
        if (field.name != "x")
            continue;
        field.name = "pixels";
        if (!are_consecutive(field.values))
            continue;
        ClaimedField last{.name = "to", .values = {field.values.back()}, .offset = field.offset};
        field = {.name = "from", .values = {field.values.front()}, .offset = field.offset};
        claim.fields.push_back(std::move(last));
        break;
    }
    return claim;
}

/// A claim about an edge, or about a line of that name.
Claim line_as_meant(Claim claim, const StepIndex& told) {
    const ClaimedField* const edge = claim.find("edge");
    if (edge == nullptr ||
        !told.find(StepKind::edge, {{"edge", edge_in(told, edge->values.front())}}).empty() ||
        told.find(StepKind::primitive, {{"name", edge->values.front()}}).empty())
        return claim;
    claim.step = name_of(StepKind::primitive);
    for (ClaimedField& field : claim.fields) {
        if (field.name == "edge")
            field.name = "name";
        if (field.name == "dx_dy") { // of a line, the slope is dy/dx
            field.name = "y_form";
            field.is_list = true;
            field.values.emplace_back(open_value);
        }
    }
    return claim;
}

} // namespace

Claim as_meant(Claim claim, const Claims& claims, const TruthIndex& truth) {
    if (claims.is_table && claim.find("edge") != nullptr)
        return line_as_meant(std::move(claim), truth.exact());
    if (claim.step == name_of(StepKind::crossings) && claims.is_table)
        return row_as_meant(std::move(claim), truth.exact());
    const ClaimedField* const d = claim.find("d");
    const ClaimedField* const name = claim.find("in");
    if (claim.step != name_of(StepKind::decide) || d == nullptr || !d->is_list || name == nullptr)
        return claim;
    const bool is_open = d->values == std::vector<std::string>{std::string(open_value)};
    const auto meant =
        meaning_of_name(name->values.front(), d->values.size(), is_open, claim, claims, truth);
    if (!meant)
        return claim;
    claim.step = name_of(meant->kind);
    for (ClaimedField& field : claim.fields) {
        field.name = field.name == "in" ? meant->key : meant->field;
        field.is_list = field.name == "at";
    }
    if (!meant->space.empty())
        claim.fields.push_back({.name = "space", .values = {meant->space}});
    return claim;
}

void name_snapped_place(Claim& claim, const Subject& subject) {
    if (subject.kind != StepKind::vertex || !subject.is_told_in(*subject.exact, subject.step) ||
        claim.find("snapped") != nullptr ||
        !subject.exact->trace().step(subject.step).as<VertexStep>().snapped)
        return;
    const auto is_whole = [](const std::string& value) {
        return value == open_value || value.find_first_not_of("-0123456789") == std::string::npos;
    };
    for (ClaimedField& field : claim.fields)
        if (field.name == "at" && std::all_of(field.values.begin(), field.values.end(), is_whole))
            field.name = "snapped";
}

} // namespace rastertrace
