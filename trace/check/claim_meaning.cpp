// SPDX-License-Identifier: MIT
#include "claim_meaning.h"

#include "claim_comparison.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
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

/// Fails of numbers in a row that can be its ends and its pixels, or the ends of several spans.
[[noreturn]] void refuse_ends_or_pixels(const ClaimedField& numbers, const Claims& claims) {
    const std::vector<std::string> ends(numbers.values.begin(), numbers.values.begin() + 2);
    const std::vector<std::string> rest(numbers.values.begin() + 2, numbers.values.end());
    throw problem_at(
        claims.source, numbers.offset,
        fmt::format("expected two ends, or a pixel's number in each place, found {}, which is {} "
                    "-> {}, or the ends of spans",
                    joined(numbers.values, ", "), joined(ends, ", "), joined(rest, ", ")),
        fmt::format("y=2: {} -> {}", joined(ends, ", "), joined(rest, "..")));
}

bool is_whole(const std::string& value) {
    const auto typed = typed_value(value);
    return value == open_value || (typed && typed->value.get_den() == 1);
}

/// Numbers of a row are the ends of a polygon's spans; where there is none, the pixels, of which none is a fraction.
Claim row_as_meant(Claim claim, const Claims& claims, const StepIndex& told) {
    const ClaimedField* const x = claim.find("x");
    if (x == nullptr || x->values.size() < 3)
        return claim;
    const bool are_whole = std::all_of(x->values.begin(), x->values.end(), is_whole);
    const bool may_be_pixels =
        x->values.size() == 4 && is_whole(x->values[2]) && is_whole(x->values[3]) && !are_whole;
    if (!told.find(StepKind::crossings, {}).empty()) {
        StepIndex::Keys keys;
        for (const ClaimedField& field : claim.fields)
            if (field.name == "y" || field.name == "in")
                keys.emplace_back(field.name, field.values.front());
        const auto& rows = told.find(StepKind::crossings, keys);
        if (may_be_pixels && rows.size() == 1 &&
            told.trace().step(rows.front()).as<CrossingsStep>().x.values().size() == 2)
            refuse_ends_or_pixels(*x, claims);
        return claim;
    }
    if (!are_whole)
        refuse_ends_or_pixels(*x, claims);
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

bool is_right(const StepIndex& told, std::size_t step, const ClaimedField& field) {
    const ToldValues values = told_in(told, step, field);
    return values && compare(field, *values, NumbersHeld::doubles, true).is_right;
}

/// The slope of an edge is dx/dy, and m of y = m x + b if that is what was claimed.
void name_slope(Claim& claim, const StepIndex& told) {
    for (ClaimedField& field : claim.fields) {
        if (field.name != "m")
            continue;
        field.name = "dx_dy";
        ClaimedField as_m{.name = "y_form",
                          .values = {field.values.front(), std::string(open_value)},
                          .is_list = true,
                          .offset = field.offset};
        const auto& edges = told.find(
            StepKind::edge, {{"edge", edge_in(told, claim.find("edge")->values.front())}});
        if (!edges.empty() && is_right(told, edges.front(), as_m))
            field = std::move(as_m);
    }
}

/// A claim about an edge, or about a line of that name.
Claim line_as_meant(Claim claim, const StepIndex& told) {
    name_slope(claim, told);
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

/// Puts the name of the only one in a claim that names none.
void name_only_one(Claim& claim, const TruthIndex& truth) {
    const auto put_only = [&](const StepIndex& index, StepKind kind, std::string_view key) {
        if (claim.step != name_of(kind) || claim.find(key) != nullptr)
            return;
        const auto names = index.values_of(kind == StepKind::face ? kind : StepKind::primitive,
                                           "name"); // a line is an edge, too
        if (names.size() == 1)
            claim.fields.insert(claim.fields.begin(),
                                {.name = std::string(key), .values = {names.front()}});
    };
    put_only(truth.exact(), StepKind::primitive, "name");
    put_only(truth.exact(), StepKind::edge, "edge");
    put_only(truth.faces(), StepKind::face, "name");
}

/// A' is A behind its object space: in a space with so many numbers, of several the last in which that is right.
std::optional<Claim> image_as_meant(const Claim& claim, const std::string& name,
                                    const StepIndex& told) {
    const std::string vertex = name.substr(0, name.size() - 1);
    if (!name.ends_with('\'') || names_vertex(name, told) || !names_vertex(vertex, told))
        return std::nullopt;
    const ClaimedField& claimed = *claim.find("d");
    Claim meant = claim;
    meant.step = name_of(StepKind::vertex);
    ClaimedField at{
        .name = "at", .values = claimed.values, .is_list = true, .offset = claimed.offset};
    std::string space;
    bool is_found = false;
    for (const std::size_t n : told.find(StepKind::vertex, {{"name", vertex}})) {
        const auto step = told.trace().step(n).as<VertexStep>();
        const std::size_t count = step.at.values().size();
        const bool lacks_z = count == 3 && at.values.size() == 2;
        if (step.space == Space::object || (count != at.values.size() && !lacks_z))
            continue;
        const bool is_it = is_right(told, n, at);
        if (is_it || !is_found)
            space = step.space.text();
        is_found = is_found || is_it;
    }
    meant.fields = {{.name = "name", .values = {vertex}, .offset = claim.offset},
                    {.name = "space", .values = {space.empty() ? "screen" : space}},
                    std::move(at)};
    return meant;
}

/// d0 = 2 counts from 0, d1 = 2, d2 = -4 from 1 if these are right so.
void count_from_1(ClaimedField& d, const StepIndex& told) {
    const auto& steps = told.find(StepKind::decide, {});
    if (steps.empty() || !d.goes_on || d.values.size() < 2 || d.values.front() != open_value)
        return;
    ClaimedField moved = d;
    moved.values.erase(moved.values.begin());
    if (!is_right(told, steps.front(), d) && is_right(told, steps.front(), moved))
        d = std::move(moved);
}

/// The pixels beside the steps of a table are those before them, or behind them, as the first of the table says.
Claim step_of_table_as_meant(Claim claim, const Claims& claims, const StepIndex& told) {
    const auto& steps = told.find(StepKind::decide, {});
    const auto is_first = [&](const Claim& one) {
        return one.step == claim.step && one.find("k") != nullptr && one.find("place") != nullptr;
    };
    const auto first = std::find_if(claims.claims.begin(), claims.claims.end(), is_first);
    if (first == claims.claims.end() || steps.empty())
        return claim;
    const auto k = number_in(first->find("k")->values.front());
    const auto decisions = decisions_from(told, steps.front());
    ClaimedField place = *first->find("place");
    place.name = "place_before";
    const bool is_before = k && sgn(*k) >= 0 && *k < static_cast<long>(decisions.size()) &&
                           is_right(told, decisions[k->get_num().get_ui()], place);
    if (!is_before)
        return claim;
    const bool is_only_place =
        std::none_of(claim.fields.begin(), claim.fields.end(), [](const ClaimedField& field) {
            return field.name == "d" && field.values.front() != open_value;
        });
    const Rational step = number_in(claim.find("k")->values.front()).value_or(0);
    const bool is_behind_last = is_only_place && step >= 1; // the pixel behind the step before
    for (ClaimedField& field : claim.fields)
        if (field.name == "k" && is_behind_last)
            field.values.front() = Rational(step - 1).get_str();
        else if (field.name == "place" && !is_behind_last)
            field.name = "place_before";
    return claim;
}

/// A row of a DDA's table says where the line is at a row, or at a column if it is longer in x.
Claim point_of_line_as_meant(Claim claim, const Claims& claims, const StepIndex& told) {
    const ClaimedField* const point = claim.find("xy");
    const auto& steps = told.find(StepKind::along, {});
    if (point == nullptr || steps.empty())
        return claim;
    const bool by_rows = told.trace().step(steps.front()).as<AlongStep>().y.has_value();
    const std::string& key = point->values[by_rows ? 1 : 0];
    if (!is_whole(key) || key == open_value)
        throw problem_at(claims.source, point->offset,
                         fmt::format("expected a whole {}, along which the line goes, found {}",
                                     by_rows ? "y" : "x", key));
    const Rational whole = typed_value(key)->value;
    claim.fields.push_back({.name = by_rows ? "y" : "x", .values = {whole.get_str()}});
    return claim;
}

} // namespace

Claim as_meant(Claim claim, const Claims& claims, const TruthIndex& truth) {
    const StepIndex& told = truth.exact();
    if (!claims.is_table)
        return claim;
    name_only_one(claim, truth);
    if (claim.find("edge") != nullptr)
        return line_as_meant(std::move(claim), told);
    if (claim.step == name_of(StepKind::crossings))
        return row_as_meant(std::move(claim), claims, told);
    if (claim.find("k") != nullptr)
        return step_of_table_as_meant(std::move(claim), claims, told);
    if (claim.step == name_of(StepKind::along))
        return point_of_line_as_meant(std::move(claim), claims, told);
    const ClaimedField* const d = claim.find("d");
    const ClaimedField* name = claim.find("in");
    if (claim.step != name_of(StepKind::decide) || d == nullptr || !d->is_list)
        return claim;
    // d: 2, -4, 6 has no name.
    constexpr auto names_of_d =
        std::to_array<std::string_view>({"d", "dk", "d_k", "p", "pk", "p_k"});
    const bool is_name_of_d =
        name != nullptr &&
        std::find(names_of_d.begin(), names_of_d.end(), name->values.front()) != names_of_d.end() &&
        told.find(StepKind::primitive, {{"name", name->values.front()}}).empty() &&
        !names_vertex(name->values.front(), told);
    if (is_name_of_d) {
        std::erase_if(claim.fields, [](const ClaimedField& field) { return field.name == "in"; });
        name = nullptr;
    }
    if (name == nullptr) {
        for (ClaimedField& field : claim.fields)
            count_from_1(field, told);
        return claim;
    }
    if (auto image = image_as_meant(claim, name->values.front(), told))
        return std::move(*image);
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
