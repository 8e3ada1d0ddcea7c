// SPDX-License-Identifier: MIT
#include "trace_lines.h"

#include "field_type.h"
#include "write_trace.h"

#include <rastertrace/trace/text/json_document.h>
#include <rastertrace/trace/text/json_scanner.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace rastertrace {

std::string disagreement(std::string_view told, std::string_view what, std::string_view found) {
    return fmt::format("expected {} {} as the end record says, found {}", told, what, found);
}

namespace {

std::optional<std::string_view> field_in(std::string_view json, std::string_view name) {
    JsonScanner fields(json);
    while (fields.next_field())
        if (fields.key() == name)
            return fields.value();
    return std::nullopt;
}

/// Throws a Problem if a step lacks a field that it cannot be understood without, or has a wrong one.
void check_fields(StepKind kind, const Source& source, std::size_t begin, std::string_view json) {
    for (const StepField& field : fields_of(kind)) {
        if (!field.is_required())
            continue;
        const auto value = field_in(json, field.name);
        if (!value)
            throw problem_at(source, begin,
                             fmt::format("expected a {} step with the key \"{}\", found none",
                                         name_of(kind), field.name));
        if (!has_type(*value, field.type))
            throw problem_at(source, begin + static_cast<std::size_t>(value->data() - json.data()),
                             fmt::format("expected {}, found {}", expected_for(field.type),
                                         shortened(*value, 40)));
    }
}

/// Throws a Problem if a step has something else where a color belongs.
void check_colors(StepKind kind, const Source& source, std::size_t begin, std::string_view json) {
    for (const StepField& field : fields_of(kind)) {
        const auto value = field.is_color ? field_in(json, field.name) : std::nullopt;
        if (value && !has_type_of(*value, field))
            throw problem_at(
                source, begin + static_cast<std::size_t>(value->data() - json.data()),
                fmt::format("expected {}, found {}", expected_for(field), shortened(*value, 40)),
                "or #rgb, #rrggbbaa, or a name of CSS 2.1");
    }
}

} // namespace

std::optional<StepKind> checked_kind(const Source& source, std::size_t begin, std::size_t size) {
    // Valid JSON, each key once. Where the quick look finds fault, the thorough one says which.
    const std::string_view json = source.view().substr(begin, size);
    constexpr std::size_t most_keys = 16;
    std::array<std::string_view, most_keys> keys;
    std::size_t key_count = 0;
    std::string_view kind_json;
    bool is_plain = true;
    bool has_color = false;
    JsonScanner fields(json);
    while (fields.next_field()) {
        if (fields.key() == "step")
            kind_json = fields.value();
        has_color = has_color || holds_color(fields.key());
        const auto seen = keys.begin() + static_cast<std::ptrdiff_t>(key_count);
        if (key_count == most_keys || std::find(keys.begin(), seen, fields.key()) != seen)
            is_plain = false;
        else
            keys[key_count++] = fields.key();
    }
    if (fields.failed() || fields.needs_full_check() || !is_plain) {
        const auto parsed = parse_json(source, begin, size);
        if (!parsed)
            throw parsed.problem();
        if (const JsonValue step = parsed.value().root(); step.kind != JsonValue::Kind::object)
            throw problem_at(source, begin,
                             fmt::format("expected a step, found {}", described(step)));
    }
    if (!kind_json.starts_with('"'))
        throw problem_at(source, begin,
                         R"(expected a step with the key "step" and its kind, found none)");
    const auto kind = step_kind_named(plain_text(kind_json));
    if (kind)
        check_fields(*kind, source, begin, json);
    if (kind && has_color)
        check_colors(*kind, source, begin, json);
    return kind;
}

void note_not_finite(NotFiniteSteps& noted, const Source& source, std::size_t begin,
                     std::string_view json, StepKind kind) {
    constexpr std::string_view nan = "NaN\"";
    constexpr std::string_view infinity = "inf\"";
    if (json.find(nan) == std::string_view::npos && json.find(infinity) == std::string_view::npos)
        return; // nearly always
    for (const StepField& field : fields_of(kind)) {
        const auto value =
            field.element == FieldType::quantity ? field_in(json, field.name) : std::nullopt;
        const auto found = value ? not_finite_in(*value) : std::nullopt;
        if (!found)
            continue;
        if (noted.count++ == 0)
            noted.first =
                problem_at(source, begin + static_cast<std::size_t>(found->data() - json.data()),
                           fmt::format("remark: expected a finite number for {}, found {}",
                                       field.name, *found));
        return;
    }
}

} // namespace rastertrace
