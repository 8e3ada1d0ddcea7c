// SPDX-License-Identifier: MIT
#include "claim_fields.h"

#include "claims.h"
#include "claims_keys.h"

#include <rastertrace/core/numbers/number.h>
#include <rastertrace/trace/text/color_text.h>
#include <rastertrace/trace/text/number_fault.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <variant>

namespace rastertrace {

namespace {

/// A field that steps of a kind do not have, but that follows from the trace.
struct DerivedField {
    StepKind kind;
    ClaimField field;
};

using enum FieldType;
constexpr std::array derived_fields{
    DerivedField{StepKind::pixel, {.name = "plotted", .type = boolean}},
    DerivedField{StepKind::pixel, {.name = "inside", .type = boolean}},
    DerivedField{StepKind::pixel, {.name = "z", .type = quantity}},
    DerivedField{StepKind::pixel, {.name = "inverse_z", .type = quantity}},
    DerivedField{StepKind::pixel, {.name = "visible", .type = boolean}},
    DerivedField{StepKind::pixel, {.name = "share", .type = quantity}},
    DerivedField{StepKind::primitive, {.name = "visible", .type = boolean}},
    DerivedField{StepKind::primitive, {.name = "row_count", .type = whole}},
    DerivedField{StepKind::primitive, {.name = "pixel_count", .type = whole}},
    DerivedField{StepKind::primitive, {.name = "pixels", .type = whole, .is_list = true}},
    DerivedField{StepKind::primitive, {.name = "y_form", .type = quantity, .is_list = true}},
    DerivedField{StepKind::primitive, {.name = "x_form", .type = quantity, .is_list = true}},
    DerivedField{StepKind::edge, {.name = "y_form", .type = quantity, .is_list = true}},
    DerivedField{StepKind::edge, {.name = "x_form", .type = quantity, .is_list = true}},
    DerivedField{StepKind::scanline, {.name = "pixel_count", .type = whole}},
    DerivedField{StepKind::scanline, {.name = "pixels", .type = whole, .is_list = true}},
    DerivedField{StepKind::face, {.name = "centroid", .type = quantity, .is_list = true}},
    DerivedField{StepKind::face, {.name = "angle", .type = quantity}},
    DerivedField{StepKind::face, {.name = "plane", .type = quantity, .is_list = true}},
    DerivedField{StepKind::face, {.name = "length", .type = quantity}},
    DerivedField{StepKind::edge, {.name = "m", .type = quantity}},
    DerivedField{StepKind::edge, {.name = "y_min", .type = quantity}},
    DerivedField{StepKind::edge, {.name = "y_max", .type = quantity}},
    DerivedField{StepKind::edge, {.name = "x_start", .type = quantity}},
    DerivedField{StepKind::along, {.name = "xy", .type = quantity, .is_list = true}},
    DerivedField{StepKind::along, {.name = "place", .type = whole, .is_list = true}},
    DerivedField{StepKind::decide, {.name = "d", .type = quantity, .is_list = true}},
    DerivedField{StepKind::decide, {.name = "k", .type = whole, .is_key = true}},
    DerivedField{StepKind::decide, {.name = "place", .type = whole, .is_list = true}},
    DerivedField{StepKind::decide, {.name = "place_before", .type = whole, .is_list = true}},
};

/// What `text`, which is no number, should be: `expected`, or what keeps it from being one.
std::string expected_of_number(std::string_view text, NumberFault fault,
                               std::string_view expected) {
    if (fault != NumberFault::malformed)
        return expected_instead_of(fault);
    if (text.starts_with('+'))
        return "a number without + in front";
    if (text.starts_with('.') || text.starts_with("-."))
        return "a digit before the point, like -0.25";
    return std::string(expected);
}

} // namespace

std::vector<ClaimField> claim_fields_of(StepKind kind) {
    std::vector<ClaimField> fields;
    for (const StepField& field : fields_of(kind))
        fields.push_back({.name = field.name,
                          .type = field.element,
                          .is_list = field.type == list,
                          .is_key = field.role == FieldRole::key});
    for (const DerivedField& derived : derived_fields)
        if (derived.kind == kind)
            fields.push_back(derived.field);
    fields.push_back({.name = "in", .type = string, .is_key = true});
    return fields;
}

std::vector<std::string_view> claim_kinds() {
    std::vector<std::string_view> names;
    for (const std::string_view name : step_kind_names()) {
        const auto fields = claim_fields_of(*step_kind_named(name));
        if (!std::all_of(fields.begin(), fields.end(),
                         [](const ClaimField& field) { return field.is_key; }))
            names.push_back(name);
    }
    return names;
}

std::optional<std::string> expected_instead(const ClaimField& field, std::string_view text) {
    if (text == open_value && !field.is_key)
        return std::nullopt;
    const auto parsed = parse_number(text);
    const Number* const number = std::get_if<Number>(&parsed);
    switch (field.type) {
    case whole:
        if (!number)
            return expected_of_number(text, std::get<NumberFault>(parsed), "a whole number");
        if (number->exact().get_den() != 1)
            return "a whole number";
        break;
    case quantity:
        if (!number)
            return expected_of_number(text, std::get<NumberFault>(parsed),
                                      "a number, like 3.125 or 25/8");
        break;
    case boolean:
        if (text != "true" && text != "false")
            return "true or false";
        break;
    case string:
        if (field.name == "color" && !parse_color(text))
            return "a color, like #ff8000 or red";
        break;
    case list:
        break;
    }
    return std::nullopt;
}

std::optional<std::string> fault_in_last_row(const std::vector<std::string>& rows) {
    const std::string& row = rows.back();
    const std::size_t other = row.find_first_not_of(picture_marks);
    if (other != std::string::npos)
        return fmt::format("expected a row of ., # and ?, found '{}'",
                           row.substr(other, first_code_point(row.substr(other)).length));
    if (row.size() != rows.front().size())
        return fmt::format("expected a row of {} pixels like the first one, found {}",
                           rows.front().size(), row.size());
    return std::nullopt;
}

} // namespace rastertrace
